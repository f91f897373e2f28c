// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Scheme/SharpPatch.h"

#include "Core/Memory/Ids.h"

#include <utility>

namespace subdivision
{

template <typename Id>
SharpPatch<Id>::SharpPatch(const SurfaceScheme<Id>& scheme, const SurfaceLevel<Id>& whole,
  const SharpCreases<Id>& creases, const std::vector<Id>& vertices)
  : Scheme(scheme)
  , Patch(whole, vertices)
{
  this->Creases.Step = creases.Step;
  for (const SharpEdge<Id>& edge : creases.Edges)
  {
    const Id own = this->FindEdge(edge.Edge);
    if (own >= 0)
    {
      this->Creases.Edges.push_back({ own, edge.Left });
    }
  }
  if (!this->Creases.Edges.empty())
  {
    for (const SharpTags<Id>& stage : creases.Stages)
    {
      this->Creases.Stages.push_back({ stage.Until,
        { this->Patch.CropTags(whole, stage.Tags.Whole),
          this->Patch.CropTags(whole, stage.Tags.All) } });
    }
  }
  this->Scheme.CloseRim(whole, this->Patch);
  this->Scheme.Prepare(this->Patch.Level);
}

template <typename Id>
SurfaceLevel<Id> SharpPatch<Id>::Refine(SharpCreases<Id>& next)
{
  const SurfaceLevel<Id>& level = this->Patch.Level;
  next = SharpCreases<Id>();
  next.Step = this->Creases.Step + 1;
  if (this->Creases.Edges.empty())
  {
    return this->Scheme.Refine(level, Depth::ForRefinement);
  }
  for (const SharpTags<Id>& stage : this->Creases.Stages)
  {
    if (stage.Until > next.Step)
    {
      next.Stages.push_back({ stage.Until,
        { this->Scheme.RefineTags(level, stage.Tags.Whole),
          this->Scheme.RefineTags(level, stage.Tags.All) } });
    }
  }
  for (const SharpEdge<Id>& edge : this->Creases.Edges)
  {
    for (Id half = 2 * edge.Edge;
      half < 2 * edge.Edge + 2 && edge.Left > 1. && !next.Stages.empty(); ++half)
    {
      next.Edges.push_back({ half, edge.Left - 1. });
    }
  }
  this->Rows = std::make_unique<SharpRows<Id>>(
    level, std::move(this->Creases.Stages.front().Tags), this->Creases.Edges);
  return this->Scheme.Refine(level, Depth::ForRefinement);
}

template <typename Id>
void SharpPatch<Id>::AppendRow(vtkIdType row, RowBlock<Id>& rows) const
{
  const SurfaceLevel<Id>& level = this->Patch.Level;
  this->Rows ? this->Rows->Append(this->Scheme, level, row, row + 1, rows)
             : this->Scheme.AppendRows(level, level.Tags, row, row + 1, rows);
}

SUBDIVISION_COMPILE(class SharpPatch);

}
