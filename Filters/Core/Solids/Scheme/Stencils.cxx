// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Scheme/Stencils.h"

#include "Core/Memory/Ids.h"
#include "Core/Operators/ForBlocks.h"

#include <numeric>

namespace subdivision
{
namespace
{

/// Calls use(kind, begin, end) for ranges of all rows, in several threads.
template <typename Id, typename Use>
void ForRowsOfKinds(const StoredRows<Id>& rows, const Use& use)
{
  ForKinds<3>({ rows.Vertices.size(), rows.Edges.size(), rows.Solids.NumberOfCentres }, use);
}

/// A row with all its weights, for where speed does not matter.
template <typename Id>
void AppendWeighted(const RingRows<Id>& rows, vtkIdType i, double factor, ExplicitRows<Id>& out)
{
  auto append = [&](Id column, double weight)
  {
    if (weight != 0.)
    {
      out.Columns.push_back(column);
      out.Weights.push_back(weight * factor);
    }
  };
  const Row<Id> ring = rows.GetRing(i);
  if (rows.OfCentres)
  {
    for (Id vertex : ring)
    {
      append(vertex, 1. / RingRows<Id>::CentreSize);
    }
    return;
  }
  const Id own = static_cast<Id>(rows.GetColumn(i));
  if (rows.HasCounts(i))
  {
    const Id* counts = rows.Counts + rows.Offsets[i];
    const double all = std::accumulate(counts, counts + ring.size(), 0.) / 3.;
    append(own, rows.Masks->CountedOwn);
    for (Id member : ring)
    {
      append(member, rows.Masks->CountedOther * static_cast<double>(*counts++) / all);
    }
    return;
  }
  const PartedMask mask = GetMask(*rows.Masks, rows.OfEdges, rows.Strata[i].GetRule(), ring.size());
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

template <typename Id>
RingRows<Id> StoredRows<Id>::Get(std::size_t kind, vtkIdType begin, vtkIdType end) const
{
  const SolidRows<Id>& solids = this->Solids;
  const vtkIdType vertices = this->Vertices.size();
  switch (kind)
  {
    case 0:
      return { solids.Masks, false, begin, end - begin, this->Vertices.data() + begin, nullptr,
        this->VertexRings.Offsets.data() + begin, this->VertexRings.Members.data(), false,
        solids.NumberOfCounted - begin, solids.Counts };
    case 1:
      return { solids.Masks, true, vertices + begin, end - begin, this->Edges.data() + begin,
        this->EdgeVertices.data() + 2 * begin, this->EdgeRings.Offsets.data() + begin,
        this->EdgeRings.Members.data() };
    default:
      return { solids.Masks, false, vertices + this->Edges.size() + begin, end - begin, nullptr,
        nullptr, nullptr, solids.CentreVertices + RingRows<Id>::CentreSize * begin, true };
  }
}

template <typename Id>
void LevelRows<Id>::ForRows(const typename RingOperator<Id>::RingsUser& use) const
{
  ForRowsOfKinds(this->Stored,
    [&](std::size_t kind, vtkIdType first, vtkIdType last)
    {
      ForBlocks(first, last,
        [&](vtkIdType begin, vtkIdType end) { use(this->Stored.Get(kind, begin, end)); });
    });
}

template <typename Id>
StoredRows<Id> Stencils<Id>::GetStored() const
{
  return { this->Vertices, this->Edges, this->EdgeVertices, this->VertexRings, this->EdgeRings,
    { this->Masks, this->CentreVertices.size() / RingRows<Id>::CentreSize,
      this->CentreVertices.data(), this->NumberOfCounted,
      this->Counts ? this->Counts->data() : nullptr } };
}

template <typename Id>
void Stencils<Id>::ForRows(const typename RingOperator<Id>::RingsUser& use) const
{
  // No smaller blocks: the rows are read from memory in any case, and an array that is summed alone
  // stays in the cache.
  const StoredRows<Id> rows = this->GetStored();
  ForRowsOfKinds(rows,
    [&](std::size_t kind, vtkIdType begin, vtkIdType end) { use(rows.Get(kind, begin, end)); });
}

template <typename Id>
void Stencils<Id>::ForEachBlock(const PointOperator::User& use) const
{
  RingOperator<Id>::ForEachBlock(use);
  const ExplicitRows<Id>& own = this->Explicit;
  ForBlocksInThreads(static_cast<vtkIdType>(own.Rows.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      WeightedRows<Id> rows{ 0, end - begin, own.Offsets.data() + begin, own.Columns.data(),
        own.Weights.data(), own.Rows.data() + begin };
      rows.CopiesOnes = false;
      use(rows);
    });
}

template <typename Id>
std::size_t Stencils<Id>::GetMemorySize() const
{
  return this->Vertices.GetMemorySize() + this->Edges.GetMemorySize() +
    this->EdgeVertices.GetMemorySize() + this->VertexRings.GetMemorySize() +
    this->EdgeRings.GetMemorySize() + this->CentreVertices.GetMemorySize() +
    (this->Counts ? this->Counts->GetMemorySize() : 0) +
    sizeof(Id) * this->Explicit.Columns.size() + sizeof(double) * this->Explicit.Weights.size();
}

template <typename Id>
void Stencils<Id>::AppendRow(vtkIdType row, double factor, ExplicitRows<Id>& rows) const
{
  const vtkIdType starts[3] = { 0, this->Vertices.size(),
    this->Vertices.size() + this->Edges.size() };
  const std::size_t kind = row < starts[1] ? 0 : row < starts[2] ? 1 : 2;
  const vtkIdType i = row - starts[kind];
  AppendWeighted(this->GetStored().Get(kind, i, i + 1), 0, factor, rows);
}

SUBDIVISION_COMPILE(class LevelRows);
SUBDIVISION_COMPILE(struct Stencils);

}
