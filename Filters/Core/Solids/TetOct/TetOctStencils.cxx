// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/TetOct/TetOctStencils.h"

#include "Core/Operators/ForBlocks.h"
#include "Core/Solids/TetOct/TetOctMasks.h"

#include <numeric>

namespace subdivision
{
namespace
{

/// A row with all its weights, for where speed does not matter.
template <typename Id>
void AppendWeighted(const RingRows<Id>& rows, vtkIdType i, ExplicitRows<Id>& out)
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
  if (rows.HasCounts(i))
  {
    const Id* tets = rows.Counts + rows.Offsets[i];
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

}

const RingMasks& TetOctMasks()
{
  auto vertexMask = [](Rule rule, vtkIdType size)
  {
    // The least ring of an inner vertex with d = 3 has 5 members.
    return rule == Rule::Solid && size < 5 ? MakeParted({ 1., 0. }, size)
                                           : TetOctVertexMask(rule, size);
  };
  static const RingMasks masks{ MaskTables<PartedMask>{ MaskTable<PartedMask>(vertexMask),
                                  MaskTable<PartedMask>(TetOctEdgeMask) },
    tetoct::TetVertexOwn, tetoct::TetVertexOther };
  return masks;
}

template <typename Id>
void StoredTetOctRows<Id>::ForRows(const typename RingOperator<Id>::RingsUser& use) const
{
  ForKinds<3>({ this->Vertices.size(), this->Edges.size(), this->GetNumberOfCentres() },
    [&](std::size_t kind, vtkIdType first, vtkIdType last)
    {
      ForBlocks(first, last,
        [&](vtkIdType begin, vtkIdType end)
        {
          use(kind == 0   ? this->OfVertices(begin, end)
              : kind == 1 ? this->OfEdges(begin, end)
                          : this->OfCentres(begin, end));
        });
    });
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
void TetOctStencils<Id>::ForRows(const typename RingOperator<Id>::RingsUser& use) const
{
  const StoredTetOctRows<Id> rows = this->GetRows();
  ForKinds<3>({ rows.Vertices.size(), rows.Edges.size(), rows.GetNumberOfCentres() },
    [&](std::size_t kind, vtkIdType begin, vtkIdType end)
    {
      use(kind == 0   ? rows.OfVertices(begin, end)
          : kind == 1 ? rows.OfEdges(begin, end)
                      : rows.OfCentres(begin, end));
    });
}

template <typename Id>
void TetOctStencils<Id>::ForEachBlock(const PointOperator::User& use) const
{
  RingOperator<Id>::ForEachBlock(use);
  this->Explicit.ForEachBlock(use);
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

template struct StoredTetOctRows<int>;
template struct StoredTetOctRows<long long>;
template struct TetOctStencils<int>;
template struct TetOctStencils<long long>;
template TetOctStencils<int> TakeStencils(TetOctLevel<int>&);
template TetOctStencils<long long> TakeStencils(TetOctLevel<long long>&);

}
