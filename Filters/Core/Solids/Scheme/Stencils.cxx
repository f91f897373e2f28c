// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Scheme/Stencils.h"

#include "Core/Memory/Ids.h"
#include "Core/Operators/ForBlocks.h"

#include <algorithm>
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
ExplicitRows<Id> MakeSectorRows(const Strata<Id>& strata, const Buffer<Id>& edgeVertices)
{
  ExplicitRows<Id> rows;
  const auto add = [&rows](Id column, double weight)
  {
    rows.Columns.push_back(column);
    rows.Weights.push_back(weight);
  };
  const auto vertices = static_cast<Id>(strata.Vertices.size());
  const std::vector<SectorEdge<Id>>& sectors = strata.Sectors;
  for (std::size_t i = 0; i < sectors.size();)
  {
    const Id edge = sectors[i].Edge;
    const SectorEdgeRange<Id> ofEdge = FindSectorEdges(sectors, edge);
    i += static_cast<std::size_t>(ofEdge.end() - ofEdge.begin());
    if (!AreComplete(ofEdge))
    {
      continue; // at the border of a part, where no row is read
    }
    const SectorMask mask = GetSectorMask(ofEdge);
    rows.Rows.push_back(vertices + edge);
    add(edgeVertices[2 * vtkIdType(edge)], mask.Ends[0]);
    add(edgeVertices[2 * vtkIdType(edge) + 1], mask.Ends[1]);
    for (Id member : strata.EdgeRings.GetMembers(edge))
    {
      add(member, mask.Ring);
    }
    for (const SectorEdge<Id>& sector : ofEdge)
    {
      for (int k = 0; k < 2 && sector.Flatness > 0.; ++k)
      {
        add(sector.Ends[k], mask.Bounds[sector.End][k]);
      }
    }
    rows.Offsets.push_back(static_cast<Id>(rows.Columns.size()));
  }
  return rows;
}

template <typename Id>
void AppendRow(const StoredRows<Id>& stored, const ExplicitRows<Id>& own, vtkIdType row,
  double factor, ExplicitRows<Id>& rows)
{
  const auto found = std::lower_bound(own.Rows.begin(), own.Rows.end(), static_cast<Id>(row));
  if (found != own.Rows.end() && *found == row)
  {
    const auto place = static_cast<std::size_t>(found - own.Rows.begin());
    for (Id k = own.Offsets[place]; k < own.Offsets[place + 1]; ++k)
    {
      rows.Columns.push_back(own.Columns[static_cast<std::size_t>(k)]);
      rows.Weights.push_back(own.Weights[static_cast<std::size_t>(k)] * factor);
    }
    return;
  }
  const vtkIdType starts[3] = { 0, stored.Vertices.size(),
    stored.Vertices.size() + stored.Edges.size() };
  const std::size_t kind = row < starts[1] ? 0 : row < starts[2] ? 1 : 2;
  const vtkIdType i = row - starts[kind];
  AppendWeighted(stored.Get(kind, i, i + 1), 0, factor, rows);
}

SUBDIVISION_COMPILE_FUNCTION(MakeSectorRows);
SUBDIVISION_COMPILE_FUNCTION(AppendRow);
SUBDIVISION_COMPILE(class LevelRows);
SUBDIVISION_COMPILE(struct Stencils);

}
