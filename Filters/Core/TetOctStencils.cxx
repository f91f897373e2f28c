// SPDX-License-Identifier: BSD-3-Clause
#include "TetOctStencils.h"

#include "Store.h"
#include "TetOctMasks.h"

#include <cmath>
#include <numeric>

namespace subdivision
{
namespace
{

/// A row with all its weights, for where speed does not matter.
template <typename Id>
void AppendWeighted(const TetOctStencils<Id>& stencils, vtkIdType row, ExplicitRows<Id>& rows)
{
  auto append = [&rows](Id column, double weight)
  {
    if (weight != 0.)
    {
      rows.Columns.push_back(column);
      rows.Weights.push_back(weight);
    }
  };
  const vtkIdType vertices = stencils.Vertices.size();
  const vtkIdType edge = row - vertices;
  const vtkIdType oct = edge - stencils.Edges.size();
  if (oct >= 0)
  {
    for (int i = 0; i < 6; ++i)
    {
      append(stencils.OctVertices[6 * oct + i], 1. / 6.);
    }
    return;
  }
  const Row<Id> ring =
    row < vertices ? stencils.VertexRings.GetMembers(row) : stencils.EdgeRings.GetMembers(edge);
  if (row < vertices && stencils.IsControlSolid(row))
  {
    const Id* tets = stencils.TetsAtSpokes->data() + stencils.VertexRings.Offsets[row];
    const double all = std::accumulate(tets, tets + ring.size(), 0.) / 3.;
    append(static_cast<Id>(row), tetoct::TetVertexOwn);
    for (Id member : ring)
    {
      append(member, tetoct::TetVertexOther * static_cast<double>(*tets++) / all);
    }
    return;
  }
  const PartedMask mask = row < vertices
    ? TetOctVertexMask(stencils.Vertices[row].GetRule(), ring.size())
    : TetOctEdgeMask(stencils.Edges[edge].GetRule(), ring.size());
  if (row < vertices)
  {
    append(static_cast<Id>(row), mask.Own);
  }
  else
  {
    append(stencils.EdgeVertices[2 * edge], mask.Own);
    append(stencils.EdgeVertices[2 * edge + 1], mask.Own);
  }
  const Id* member = ring.begin();
  for (int part = 0; part < mask.Parts; ++part)
  {
    for (vtkIdType i = 0; i < mask.Sizes[part]; ++i)
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
  RowSums(const TetOctStencils<Id>& stencils, const T* in, T* out, int components)
    : Stencils(stencils)
    , In(in)
    , Out(out)
    , Components(N == 0 ? components : N)
    , Values(N == 0 ? components : 0)
    , Partial(N == 0 ? components : 0)
  {
  }

  void PutVertex(vtkIdType v)
  {
    const Row<Id> ring = this->Stencils.VertexRings.GetMembers(v);
    const T* own = this->At(v);
    if (this->Stencils.IsControlSolid(v))
    {
      this->PutControlSolid(v, ring);
      return;
    }
    const PartedMask mask = TetOctVertexMask(this->Stencils.Vertices[v].GetRule(), ring.size());
    if (mask.Own == 1.) // also where values that are not finite must not spread
    {
      std::copy(own, own + this->Size(), this->Out + v * this->Size());
      return;
    }
    double* sum = this->Sum();
    for (int c = 0; c < this->Size(); ++c)
    {
      sum[c] = mask.Own * static_cast<double>(own[c]);
    }
    this->AddParts(mask, ring);
    this->Put(v);
  }

  void PutEdge(vtkIdType e)
  {
    const Row<Id> ring = this->Stencils.EdgeRings.GetMembers(e);
    const Rule rule = this->Stencils.Edges[e].GetRule();
    const bool regular = rule == Rule::RegularEdge; // most edges by far
    const PartedMask mask = regular ? RegularEdgeMask : TetOctEdgeMask(rule, ring.size());
    const T* first = this->At(this->Stencils.EdgeVertices[2 * e]);
    const T* second = this->At(this->Stencils.EdgeVertices[2 * e + 1]);
    double* sum = this->Sum();
    for (int c = 0; c < this->Size(); ++c)
    {
      sum[c] = mask.Own * (static_cast<double>(first[c]) + static_cast<double>(second[c]));
    }
    if (regular)
    {
      this->template AddRegularPart<4>(RegularEdgeMask.Weights[0], ring.begin());
      this->template AddRegularPart<4>(RegularEdgeMask.Weights[1], ring.begin() + 4);
    }
    else
    {
      this->AddParts(mask, ring);
    }
    this->Put(this->Stencils.Vertices.size() + e);
  }

  void PutOct(vtkIdType o)
  {
    double* sum = this->Sum();
    std::fill(sum, sum + this->Size(), 0.);
    const Id* vertices = this->Stencils.OctVertices.data() + 6 * o;
    this->AddPart(1. / 6., vertices, vertices + 6);
    this->Put(this->Stencils.Vertices.size() + this->Stencils.Edges.size() + o);
  }

private:
  int Size() const { return N == 0 ? this->Components : N; }
  double* Sum() { return N == 0 ? this->Values.data() : this->FixedValues; }
  const T* At(vtkIdType column) const { return this->In + column * this->Size(); }

  void PutControlSolid(vtkIdType v, Row<Id> ring)
  {
    double* sum = this->Sum();
    const T* own = this->At(v);
    const Id* tets = this->Stencils.TetsAtSpokes->data() + this->Stencils.VertexRings.Offsets[v];
    double all = 0.;
    for (vtkIdType i = 0; i < ring.size(); ++i)
    {
      all += static_cast<double>(tets[i]) / 3.;
    }
    for (int c = 0; c < this->Size(); ++c)
    {
      sum[c] = tetoct::TetVertexOwn * static_cast<double>(own[c]);
    }
    for (vtkIdType i = 0; i < ring.size(); ++i)
    {
      const double weight = tetoct::TetVertexOther * static_cast<double>(tets[i]) / all;
      const T* value = this->At(ring.begin()[i]);
      for (int c = 0; c < this->Size(); ++c)
      {
        sum[c] += weight * static_cast<double>(value[c]);
      }
    }
    this->Put(v);
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
    std::fill(partial, partial + this->Size(), 0.);
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
  void Put(vtkIdType row)
  {
    const double* sum = this->Sum();
    T* result = this->Out + row * this->Size();
    for (int c = 0; c < this->Size(); ++c)
    {
      result[c] = Store<T>(std::isfinite(sum[c]) ? sum[c] : this->SumTermByTerm(row, c));
    }
  }

  double SumTermByTerm(vtkIdType row, int component) const
  {
    ExplicitRows<Id> terms;
    AppendWeighted(this->Stencils, row, terms);
    double sum = 0.;
    for (std::size_t i = 0; i < terms.Columns.size(); ++i)
    {
      sum += terms.Weights[i] * static_cast<double>(this->At(terms.Columns[i])[component]);
    }
    return sum;
  }

  const TetOctStencils<Id>& Stencils;
  const T* In;
  T* Out;
  const int Components;
  double FixedValues[N == 0 ? 1 : N];
  double FixedPartial[N == 0 ? 1 : N];
  std::vector<double> Values;
  std::vector<double> Partial;
};

template <int N, typename Id, typename T>
void ApplyRows(const TetOctStencils<Id>& stencils, const T* in, T* out, int components)
{
  using Sums = RowSums<N, Id, T>;
  auto each = [&](vtkIdType size, void (Sums::*put)(vtkIdType))
  {
    ForRanges(size,
      [&](vtkIdType begin, vtkIdType end)
      {
        Sums sums(stencils, in, out, components);
        for (vtkIdType i = begin; i < end; ++i)
        {
          (sums.*put)(i);
        }
      });
  };
  each(stencils.Vertices.size(), &Sums::PutVertex);
  each(stencils.Edges.size(), &Sums::PutEdge);
  each(stencils.OctVertices.size() / 6, &Sums::PutOct);
}

}

template <typename Id>
void TetOctStencils<Id>::AppendRow(vtkIdType row, double factor, ExplicitRows<Id>& rows) const
{
  const std::size_t before = rows.Weights.size();
  AppendWeighted(*this, row, rows);
  for (std::size_t i = before; i < rows.Weights.size(); ++i)
  {
    rows.Weights[i] *= factor;
  }
}

template <typename Id>
template <typename T>
void TetOctStencils<Id>::Apply(const T* in, T* out, int components) const
{
  switch (components)
  {
    case 1:
      ApplyRows<1>(*this, in, out, components);
      break;
    case 3:
      ApplyRows<3>(*this, in, out, components);
      break;
    default:
      ApplyRows<0>(*this, in, out, components);
      break;
  }
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

#define SUBDIVISION_APPLY(Id, T) template void TetOctStencils<Id>::Apply(const T*, T*, int) const
#define SUBDIVISION_STENCILS(Id)                                                                   \
  template struct TetOctStencils<Id>;                                                              \
  template TetOctStencils<Id> TakeStencils(TetOctLevel<Id>&);                                      \
  SUBDIVISION_APPLY(Id, float);                                                                    \
  SUBDIVISION_APPLY(Id, double);                                                                   \
  SUBDIVISION_APPLY(Id, char);                                                                     \
  SUBDIVISION_APPLY(Id, signed char);                                                              \
  SUBDIVISION_APPLY(Id, unsigned char);                                                            \
  SUBDIVISION_APPLY(Id, short);                                                                    \
  SUBDIVISION_APPLY(Id, unsigned short);                                                           \
  SUBDIVISION_APPLY(Id, int);                                                                      \
  SUBDIVISION_APPLY(Id, unsigned int);                                                             \
  SUBDIVISION_APPLY(Id, long);                                                                     \
  SUBDIVISION_APPLY(Id, unsigned long);                                                            \
  SUBDIVISION_APPLY(Id, long long);                                                                \
  SUBDIVISION_APPLY(Id, unsigned long long)
SUBDIVISION_STENCILS(int);
SUBDIVISION_STENCILS(long long);

}
