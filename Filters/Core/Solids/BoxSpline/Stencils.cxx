// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/BoxSpline/Stencils.h"

#include "Core/Memory/ScalarTypes.h"
#include "Core/Memory/Store.h"
#include "Core/Rules/Masks.h"

#include <cmath>
#include <limits>
#include <vector>

namespace subdivision
{
namespace
{

/// The masks by rule and ring size, so that rows divide nothing.
class MaskTable
{
public:
  MaskTable(Mask (*mask)(Rule, vtkIdType))
    : Compute(mask)
  {
    for (int rule = 0; rule < 6; ++rule)
    {
      for (int size = 0; size < Sizes; ++size)
      {
        this->Masks[rule][size] =
          size == 0 && mask == VertexMask ? Mask{ 1., 0. } : mask(static_cast<Rule>(rule), size);
      }
    }
  }
  Mask Get(Stratum stratum, vtkIdType ringSize) const
  {
    return ringSize < Sizes ? this->Masks[static_cast<int>(stratum.GetRule())][ringSize]
                            : this->Compute(stratum.GetRule(), ringSize);
  }

private:
  static constexpr int Sizes = 64;
  Mask (*Compute)(Rule, vtkIdType);
  Mask Masks[6][Sizes];
};

/// Sums over N components; N = 0 when their number is known at run time only.
template <int N>
class Sum
{
public:
  explicit Sum(int) {}
  double& operator[](int c) { return this->Values[c]; }
  int GetSize() const { return N; }

private:
  double Values[N];
};
template <>
class Sum<0>
{
public:
  explicit Sum(int components)
    : Values(components)
  {
  }
  double& operator[](int c) { return this->Values[c]; }
  int GetSize() const { return static_cast<int>(this->Values.size()); }

private:
  std::vector<double> Values;
};

template <int N, typename Id, typename T>
void SumRing(Row<Id> ring, const T* in, Sum<N>& sum)
{
  const int size = sum.GetSize();
  for (int c = 0; c < size; ++c)
  {
    sum[c] = 0.;
  }
  for (Id member : ring)
  {
    const T* value = in + static_cast<vtkIdType>(member) * size;
    for (int c = 0; c < size; ++c)
    {
      sum[c] += static_cast<double>(value[c]);
    }
  }
}

/// A row whose plain sum overflows: each term is weighted first, so that finite values give a
/// finite mean.
template <typename Id, typename T>
T SumTermByTerm(
  const Mask& mask, const T* first, const T* second, Row<Id> ring, const T* in, int stride)
{
  double sum = mask.Own * static_cast<double>(*first);
  sum += second ? mask.Own * static_cast<double>(*second) : 0.;
  for (Id member : ring)
  {
    sum += mask.Ring * static_cast<double>(in[static_cast<vtkIdType>(member) * stride]);
  }
  return Store<T>(sum);
}

template <int N, typename Id, typename T>
void SumVertexRows(const StencilRows<Id>& rows, const T* in, T* out, int components)
{
  static const MaskTable masks(VertexMask);
  Sum<N> sum(components);
  const int size = sum.GetSize();
  for (vtkIdType i = 0; i < rows.Count; ++i)
  {
    const Row<Id> ring = rows.GetRing(i);
    const Mask mask = masks.Get(rows.Strata[i], ring.size());
    const T* own = in + (rows.FirstRow + i) * size;
    T* result = out + (rows.FirstRow + i) * size;
    if (mask.Ring == 0.) // do not read the ring: 0 times a value that is not finite is not 0
    {
      std::copy(own, own + size, result);
      continue;
    }
    SumRing(ring, in, sum);
    for (int c = 0; c < size; ++c)
    {
      const double value = mask.Own * static_cast<double>(own[c]) + mask.Ring * sum[c];
      result[c] = std::isfinite(value)
        ? Store<T>(value)
        : SumTermByTerm(mask, own + c, static_cast<const T*>(nullptr), ring, in + c, size);
    }
  }
}

template <int N, typename Id, typename T>
void SumEdgeRows(const StencilRows<Id>& rows, const T* in, T* out, int components)
{
  static const MaskTable masks(EdgeMask);
  Sum<N> sum(components);
  const int size = sum.GetSize();
  for (vtkIdType i = 0; i < rows.Count; ++i)
  {
    const Row<Id> ring = rows.GetRing(i);
    const Mask mask = masks.Get(rows.Strata[i], ring.size());
    const T* first = in + static_cast<vtkIdType>(rows.Ends[2 * i]) * size;
    const T* second = in + static_cast<vtkIdType>(rows.Ends[2 * i + 1]) * size;
    T* result = out + (rows.FirstRow + i) * size;
    SumRing(ring, in, sum);
    for (int c = 0; c < size; ++c)
    {
      const double ends = static_cast<double>(first[c]) + static_cast<double>(second[c]);
      const double value = mask.Own * ends + mask.Ring * sum[c];
      result[c] = std::isfinite(value)
        ? Store<T>(value)
        : SumTermByTerm(mask, first + c, second + c, ring, in + c, size);
    }
  }
}

template <int N, typename Id, typename T>
void SumRowsOf(const StencilRows<Id>& rows, const T* in, T* out, int components)
{
  rows.OfEdges ? SumEdgeRows<N>(rows, in, out, components)
               : SumVertexRows<N>(rows, in, out, components);
}

}

template <typename Id>
void Stencils<Id>::AppendRow(vtkIdType row, double factor, ExplicitRows<Id>& rows) const
{
  auto append = [&](Id column, double weight)
  {
    rows.Columns.push_back(column);
    rows.Weights.push_back(weight * factor);
  };
  const bool isVertex = row < this->Vertices.size();
  const vtkIdType edge = row - this->Vertices.size();
  const Row<Id> ring =
    isVertex ? this->VertexRings.GetMembers(row) : this->EdgeRings.GetMembers(edge);
  const Mask mask = isVertex ? VertexMask(this->Vertices[row].GetRule(), ring.size())
                             : EdgeMask(this->Edges[edge].GetRule(), ring.size());
  if (isVertex)
  {
    append(static_cast<Id>(row), mask.Own);
  }
  else
  {
    append(this->EdgeVertices[2 * edge], mask.Own);
    append(this->EdgeVertices[2 * edge + 1], mask.Own);
  }
  for (Id member : mask.Ring == 0. ? Row<Id>() : ring)
  {
    append(member, mask.Ring);
  }
}

template <typename Id, typename T>
void SumRows(const StencilRows<Id>& rows, const T* in, T* out, int components)
{
  ForComponents<T>(
    components, [&](auto size) { SumRowsOf<decltype(size)::value>(rows, in, out, components); });
}

template <typename Id>
template <typename T>
void Stencils<Id>::Apply(const T* in, T* out, int components) const
{
  const vtkIdType vertices = this->Vertices.size();
  ForRanges(vertices,
    [&](vtkIdType begin, vtkIdType end)
    {
      SumRows(StencilRows<Id>{ false, begin, end - begin, this->Vertices.data() + begin, nullptr,
                this->VertexRings.Offsets.data() + begin, this->VertexRings.Members.data() },
        in, out, components);
    });
  ForRanges(this->Edges.size(),
    [&](vtkIdType begin, vtkIdType end)
    {
      SumRows(StencilRows<Id>{ true, vertices + begin, end - begin, this->Edges.data() + begin,
                this->EdgeVertices.data() + 2 * begin, this->EdgeRings.Offsets.data() + begin,
                this->EdgeRings.Members.data() },
        in, out, components);
    });
  this->Explicit.Apply(in, out, components);
}

template <typename Id>
std::size_t Stencils<Id>::GetMemorySize() const
{
  return this->Vertices.GetMemorySize() + this->Edges.GetMemorySize() +
    this->EdgeVertices.GetMemorySize() + this->VertexRings.GetMemorySize() +
    this->EdgeRings.GetMemorySize() + sizeof(Id) * this->Explicit.Columns.size() +
    sizeof(double) * this->Explicit.Weights.size();
}

template <typename Id>
Stencils<Id> TakeStencils(Level<Id>& level)
{
  Stencils<Id> stencils;
  stencils.Vertices = std::move(level.Strata.Vertices);
  stencils.Edges = std::move(level.Strata.Edges);
  stencils.EdgeVertices = std::move(level.Complex.EdgeVertices);
  stencils.VertexRings = std::move(level.Strata.VertexRings);
  stencils.VertexRings.Carriers = Buffer<Id>();
  stencils.EdgeRings = std::move(level.Strata.EdgeRings);
  stencils.EdgeRings.Carriers = Buffer<Id>();
  return stencils;
}

#define SUBDIVISION_APPLY(Id, T)                                                                   \
  template void Stencils<Id>::Apply(const T*, T*, int) const;                                      \
  template void SumRows(const StencilRows<Id>&, const T*, T*, int)
#define SUBDIVISION_STENCILS(Id)                                                                   \
  template struct Stencils<Id>;                                                                    \
  template Stencils<Id> TakeStencils(Level<Id>&);                                                  \
  SUBDIVISION_FOR_SCALARS(SUBDIVISION_APPLY, Id)
SUBDIVISION_STENCILS(int);
SUBDIVISION_STENCILS(long long);

}
