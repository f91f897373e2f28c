// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/BoxSpline/Stencils.h"

#include "Core/Operators/ForBlocks.h"

namespace subdivision
{

const RingMasks& BoxSplineMasks()
{
  auto vertexMask = [](Rule rule, vtkIdType size)
  { return size == 0 ? Mask{ 1., 0. } : VertexMask(rule, size); };
  static const RingMasks masks{ MaskTables<Mask>{
    MaskTable<Mask>(vertexMask), MaskTable<Mask>(EdgeMask) } };
  return masks;
}

template <typename Id>
void ForStoredRows(const StoredRows<Id>& rows, const typename RingOperator<Id>::RingsUser& use)
{
  ForKinds<2>({ rows.Vertices.size(), rows.Edges.size() },
    [&](std::size_t kind, vtkIdType first, vtkIdType last)
    {
      ForBlocks(first, last, [&](vtkIdType begin, vtkIdType end)
        { use(kind == 0 ? rows.OfVertices(begin, end) : rows.OfEdges(begin, end)); });
    });
}

template <typename Id>
void ExplicitRows<Id>::ForEachBlock(const PointOperator::User& use) const
{
  ForBlocksInThreads(static_cast<vtkIdType>(this->Rows.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      WeightedRows<Id> rows{ 0, end - begin, this->Offsets.data() + begin, this->Columns.data(),
        this->Weights.data(), this->Rows.data() + begin };
      rows.CopiesOnes = false;
      use(rows);
    });
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

template <typename Id>
void Stencils<Id>::ForRows(const typename RingOperator<Id>::RingsUser& use) const
{
  // No smaller blocks: the rows are read from memory in any case, and an array that is summed alone
  // stays in the cache.
  const StoredRows<Id> rows = this->GetStored();
  ForKinds<2>({ rows.Vertices.size(), rows.Edges.size() },
    [&](std::size_t kind, vtkIdType begin, vtkIdType end)
    { use(kind == 0 ? rows.OfVertices(begin, end) : rows.OfEdges(begin, end)); });
}

template <typename Id>
void Stencils<Id>::ForEachBlock(const PointOperator::User& use) const
{
  RingOperator<Id>::ForEachBlock(use);
  this->Explicit.ForEachBlock(use);
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

#define SUBDIVISION_STENCILS(Id)                                                                   \
  template struct ExplicitRows<Id>;                                                                \
  template struct Stencils<Id>;                                                                    \
  template void ForStoredRows(const StoredRows<Id>&, const typename RingOperator<Id>::RingsUser&); \
  template Stencils<Id> TakeStencils(Level<Id>&)
SUBDIVISION_STENCILS(int);
SUBDIVISION_STENCILS(long long);

}
