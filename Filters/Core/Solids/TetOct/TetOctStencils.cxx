// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/TetOct/TetOctStencils.h"

#include "Core/Memory/ScalarTypes.h"
#include "Core/Memory/Store.h"
#include "Core/Solids/TetOct/TetOctMasks.h"

#include <cmath>
#include <numeric>

namespace subdivision
{
namespace
{

/// A row with all its weights, for where speed does not matter.
template <typename Id>
void AppendWeighted(const TetOctRows<Id>& rows, vtkIdType i, ExplicitRows<Id>& out)
{
  auto append = [&out](Id column, double weight)
  {
    if (weight != 0.)
    {
      out.Columns.push_back(column);
      out.Weights.push_back(weight);
    }
  };
  const Row<Id> ring = rows.GetRing(i);
  if (rows.OfCentres)
  {
    for (Id vertex : ring)
    {
      append(vertex, 1. / 6.);
    }
    return;
  }
  const Id own = static_cast<Id>(rows.FirstRow + i);
  if (rows.IsControlSolid(i))
  {
    const Id* tets = rows.TetsAtSpokes + rows.Offsets[i];
    const double all = std::accumulate(tets, tets + ring.size(), 0.) / 3.;
    append(own, tetoct::TetVertexOwn);
    for (Id member : ring)
    {
      append(member, tetoct::TetVertexOther * static_cast<double>(*tets++) / all);
    }
    return;
  }
  const Rule rule = rows.Strata[i].GetRule();
  const PartedMask mask =
    rows.OfEdges ? TetOctEdgeMask(rule, ring.size()) : TetOctVertexMask(rule, ring.size());
  append(rows.OfEdges ? rows.Ends[2 * i] : own, mask.Own);
  if (rows.OfEdges)
  {
    append(rows.Ends[2 * i + 1], mask.Own);
  }
  const Id* member = ring.begin();
  for (int part = 0; part < mask.Parts; ++part)
  {
    for (vtkIdType k = 0; k < mask.Sizes[part]; ++k)
    {
      append(*member++, mask.Weights[part]);
    }
  }
}

/// Rows for N components; N = 0 when their number is known at run time only.
template <int N, typename Id, typename T>
class RowSums
{
public:
  RowSums(const TetOctRows<Id>& rows, const T* in, T* out, int components)
    : Rows(rows)
    , In(in)
    , Out(out + rows.FirstRow * (N == 0 ? components : N))
    , Components(N == 0 ? components : N)
    , Values(N == 0 ? components : 0)
    , Partial(N == 0 ? components : 0)
  {
  }

  void PutVertex(vtkIdType i)
  {
    const Row<Id> ring = this->Rows.GetRing(i);
    const T* own = this->At(this->Rows.FirstRow + i);
    if (this->Rows.IsControlSolid(i))
    {
      this->PutControlSolid(i, own, ring);
      return;
    }
    const Rule rule = this->Rows.Strata[i].GetRule();
    double* sum = this->Sum();
    if (rule == Rule::RegularEdge) // most vertices by far
    {
      for (int c = 0; c < this->Size(); ++c)
      {
        sum[c] = RegularVertexMask.Own * static_cast<double>(own[c]);
      }
      this->template AddRegularPart<12>(RegularVertexMask.Weights[0], ring.begin());
      this->template AddRegularPart<6>(RegularVertexMask.Weights[1], ring.begin() + 12);
      this->Put(i);
      return;
    }
    const PartedMask mask = TetOctVertexMask(rule, ring.size());
    if (mask.Own == 1.) // do not read the ring: 0 times a value that is not finite is not 0
    {
      std::copy(own, own + this->Size(), this->Out + i * this->Size());
      return;
    }
    for (int c = 0; c < this->Size(); ++c)
    {
      sum[c] = mask.Own * static_cast<double>(own[c]);
    }
    this->AddParts(mask, ring);
    this->Put(i);
  }

  void PutEdge(vtkIdType i)
  {
    const Row<Id> ring = this->Rows.GetRing(i);
    const Rule rule = this->Rows.Strata[i].GetRule();
    if (rule == Rule::RegularEdge) // most edges by far
    {
      this->AddEnds(i, RegularEdgeMask.Own);
      this->template AddRegularPart<4>(RegularEdgeMask.Weights[0], ring.begin());
      this->template AddRegularPart<4>(RegularEdgeMask.Weights[1], ring.begin() + 4);
    }
    else
    {
      const PartedMask mask = TetOctEdgeMask(rule, ring.size());
      this->AddEnds(i, mask.Own);
      this->AddParts(mask, ring);
    }
    this->Put(i);
  }

  void PutCentre(vtkIdType i)
  {
    double* sum = this->Sum();
    std::fill_n(sum, this->Size(), 0.);
    this->template AddRegularPart<6>(1. / 6., this->Rows.Members + 6 * i);
    this->Put(i);
  }

private:
  int Size() const { return N == 0 ? this->Components : N; }
  double* Sum() { return N == 0 ? this->Values.data() : this->FixedValues; }
  const T* At(vtkIdType column) const { return this->In + column * this->Size(); }

  void PutControlSolid(vtkIdType i, const T* own, Row<Id> ring)
  {
    double* sum = this->Sum();
    const Id* tets = this->Rows.TetsAtSpokes + this->Rows.Offsets[i];
    double all = 0.;
    for (vtkIdType k = 0; k < ring.size(); ++k)
    {
      all += static_cast<double>(tets[k]) / 3.;
    }
    for (int c = 0; c < this->Size(); ++c)
    {
      sum[c] = tetoct::TetVertexOwn * static_cast<double>(own[c]);
    }
    for (vtkIdType k = 0; k < ring.size(); ++k)
    {
      const double weight = tetoct::TetVertexOther * static_cast<double>(tets[k]) / all;
      const T* value = this->At(ring.begin()[k]);
      for (int c = 0; c < this->Size(); ++c)
      {
        sum[c] += weight * static_cast<double>(value[c]);
      }
    }
    this->Put(i);
  }

  /// Starts the sum of an edge's row.
  void AddEnds(vtkIdType i, double weight)
  {
    const T* first = this->At(this->Rows.Ends[2 * i]);
    const T* second = this->At(this->Rows.Ends[2 * i + 1]);
    double* sum = this->Sum();
    for (int c = 0; c < this->Size(); ++c)
    {
      sum[c] = weight * (static_cast<double>(first[c]) + static_cast<double>(second[c]));
    }
  }

  /// As AddPart, of a size that the compiler knows.
  template <int Count>
  void AddRegularPart(double weight, const Id* members)
  {
    double* sum = this->Sum();
    for (int c = 0; c < this->Size(); ++c)
    {
      double partial = 0.;
      for (int i = 0; i < Count; ++i)
      {
        partial += static_cast<double>(this->At(members[i])[c]);
      }
      sum[c] += weight * partial;
    }
  }

  void AddParts(const PartedMask& mask, Row<Id> ring)
  {
    const Id* first = ring.begin();
    for (int part = 0; part < mask.Parts; ++part)
    {
      const Id* last = first + mask.Sizes[part];
      if (mask.Weights[part] != 0.)
      {
        this->AddPart(mask.Weights[part], first, last);
      }
      first = last;
    }
  }

  void AddPart(double weight, const Id* first, const Id* last)
  {
    double* sum = this->Sum();
    double* partial = N == 0 ? this->Partial.data() : this->FixedPartial;
    std::fill_n(partial, this->Size(), 0.);
    for (const Id* member = first; member != last; ++member)
    {
      const T* value = this->At(*member);
      for (int c = 0; c < this->Size(); ++c)
      {
        partial[c] += static_cast<double>(value[c]);
      }
    }
    for (int c = 0; c < this->Size(); ++c)
    {
      sum[c] += weight * partial[c];
    }
  }

  /// A row whose plain sum overflows is weighted term by term, so that finite values give a finite
  /// mean.
  void Put(vtkIdType i)
  {
    const double* sum = this->Sum();
    T* result = this->Out + i * this->Size();
    for (int c = 0; c < this->Size(); ++c)
    {
      result[c] = Store<T>(std::isfinite(sum[c]) ? sum[c] : this->SumTermByTerm(i, c));
    }
  }

  double SumTermByTerm(vtkIdType i, int component) const
  {
    ExplicitRows<Id> terms;
    AppendWeighted(this->Rows, i, terms);
    double sum = 0.;
    for (std::size_t k = 0; k < terms.Columns.size(); ++k)
    {
      sum += terms.Weights[k] * static_cast<double>(this->At(terms.Columns[k])[component]);
    }
    return sum;
  }

  const TetOctRows<Id>& Rows;
  const T* In;
  T* Out;
  const int Components;
  double FixedValues[N == 0 ? 1 : N];
  double FixedPartial[N == 0 ? 1 : N];
  std::vector<double> Values;
  std::vector<double> Partial;
};

template <int N, typename Id, typename T>
void SumRowsOf(const TetOctRows<Id>& rows, const T* in, T* out, int components)
{
  RowSums<N, Id, T> sums(rows, in, out, components);
  if (rows.OfCentres)
  {
    for (vtkIdType i = 0; i < rows.Count; ++i)
    {
      sums.PutCentre(i);
    }
  }
  else if (rows.OfEdges)
  {
    for (vtkIdType i = 0; i < rows.Count; ++i)
    {
      sums.PutEdge(i);
    }
  }
  else
  {
    for (vtkIdType i = 0; i < rows.Count; ++i)
    {
      sums.PutVertex(i);
    }
  }
}

}

template <typename Id, typename T>
void SumRows(const TetOctRows<Id>& rows, const T* in, T* out, int components)
{
  ForComponents<T>(
    components, [&](auto size) { SumRowsOf<decltype(size)::value>(rows, in, out, components); });
}

template <typename Id>
void TetOctStencils<Id>::AppendRow(vtkIdType row, double factor, ExplicitRows<Id>& out) const
{
  const std::size_t before = out.Weights.size();
  const StoredTetOctRows<Id> rows = this->GetRows();
  const vtkIdType edge = row - this->Vertices.size();
  const vtkIdType centre = edge - this->Edges.size();
  AppendWeighted(edge < 0 ? rows.OfVertices(row, row + 1)
      : centre < 0        ? rows.OfEdges(edge, edge + 1)
                          : rows.OfCentres(centre, centre + 1),
    0, out);
  for (std::size_t i = before; i < out.Weights.size(); ++i)
  {
    out.Weights[i] *= factor;
  }
}

template <typename Id>
template <typename T>
void TetOctStencils<Id>::Apply(const T* in, T* out, int components) const
{
  const StoredTetOctRows<Id> rows = this->GetRows();
  ForRanges(this->Vertices.size(), [&](vtkIdType begin, vtkIdType end)
    { SumRows(rows.OfVertices(begin, end), in, out, components); });
  ForRanges(this->Edges.size(), [&](vtkIdType begin, vtkIdType end)
    { SumRows(rows.OfEdges(begin, end), in, out, components); });
  ForRanges(rows.GetNumberOfCentres(), [&](vtkIdType begin, vtkIdType end)
    { SumRows(rows.OfCentres(begin, end), in, out, components); });
  this->Explicit.Apply(in, out, components);
}

template <typename Id>
std::size_t TetOctStencils<Id>::GetMemorySize() const
{
  return this->Vertices.GetMemorySize() + this->Edges.GetMemorySize() +
    this->EdgeVertices.GetMemorySize() + this->OctVertices.GetMemorySize() +
    this->VertexRings.GetMemorySize() + this->EdgeRings.GetMemorySize() +
    this->TetsAtSpokes->GetMemorySize() + sizeof(Id) * this->Explicit.Columns.size() +
    sizeof(double) * this->Explicit.Weights.size();
}

template <typename Id>
TetOctStencils<Id> TakeStencils(TetOctLevel<Id>& level)
{
  TetOctStencils<Id> stencils;
  stencils.Vertices = std::move(level.Strata.Vertices);
  stencils.Edges = std::move(level.Strata.Edges);
  stencils.EdgeVertices = std::move(level.Complex.EdgeVertices);
  stencils.OctVertices = std::move(level.OctVertices);
  stencils.VertexRings = std::move(level.Strata.VertexRings);
  stencils.VertexRings.Carriers = Buffer<Id>();
  stencils.EdgeRings = std::move(level.Strata.EdgeRings);
  stencils.EdgeRings.Carriers = Buffer<Id>();
  stencils.TetsAtSpokes = level.TetsAtSpokes;
  stencils.NumberOfControlVertices = level.NumberOfControlVertices;
  return stencils;
}

#define SUBDIVISION_APPLY(Id, T)                                                                   \
  template void TetOctStencils<Id>::Apply(const T*, T*, int) const;                                \
  template void SumRows(const TetOctRows<Id>&, const T*, T*, int)
#define SUBDIVISION_STENCILS(Id)                                                                   \
  template struct TetOctStencils<Id>;                                                              \
  template TetOctStencils<Id> TakeStencils(TetOctLevel<Id>&);                                      \
  SUBDIVISION_FOR_SCALARS(SUBDIVISION_APPLY, Id)
SUBDIVISION_STENCILS(int);
SUBDIVISION_STENCILS(long long);

}
