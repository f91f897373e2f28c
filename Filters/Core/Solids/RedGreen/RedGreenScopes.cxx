// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RedGreenScopes.cxx
 * States that have a part of a mesh, and splits that come from other states.
 */
#include "Core/Solids/RedGreen/RedGreen.h"

#include "Core/Memory/Ids.h"
#include "Core/Solids/RedGreen/RedGreenTables.h"

namespace subdivision
{

template <typename Id>
void RedGreen<Id>::SetScopes(const CellScope* scopes)
{
  this->Scopes = scopes;
  this->OutputCells = std::count(scopes, scopes + this->Input.NumberOfSimplices, CellScope::Own);
}

/// Whether an input cell that is not ignored has the edge ab.
template <typename Id>
bool RedGreen<Id>::HasInputCell(Id a, Id b)
{
  if (this->Incidence.Offsets.empty())
  {
    this->BuildIncidence();
  }
  const auto cells = this->Incidence[a];
  return std::any_of(cells.begin(), cells.end(),
    [&](Id cell)
    {
      const vtkIdType* vertices = this->Input.Connectivity + this->Places[cell];
      const vtkIdType* end = vertices + this->Input.Dimensions[cell] + 1;
      return this->GetScope(cell) != CellScope::Ignored && std::find(vertices, end, b) != end;
    });
}

template <typename Id>
bool RedGreen<Id>::HasUserOfBoth(Id edge, Id second) const
{
  for (Id use = this->Edges[edge].FirstUse; use >= 0;)
  {
    const Node& node = this->Nodes[use / 6];
    const Id* end = node.Edges + redgreen::NumberOfEdges[node.Dimension];
    if (std::find(node.Edges, end, second) != end)
    {
      return true;
    }
    use = node.NextUse[use % 6];
  }
  return false;
}

template <typename Id>
bool RedGreen<Id>::SplitEdge(Id end0, Id end1)
{
  const Id ends[2] = { end0, end1 };
  const Id parents[2] = { this->FindMidpointEdge(end0), this->FindMidpointEdge(end1) };
  for (int i = 0; i < 2; ++i)
  {
    for (int side = 0; parents[i] >= 0 && side < 2; ++side)
    {
      if (this->Edges[parents[i]].Ends[side] == ends[1 - i])
      {
        this->Split(this->GetHalf(parents[i], side));
        return true;
      }
    }
  }
  const bool isThere = std::max(end0, end1) < this->InputVertices
    ? this->HasInputCell(end0, end1)
    : parents[0] >= 0 && parents[1] >= 0 && this->HasUserOfBoth(parents[0], parents[1]);
  if (isThere)
  {
    this->Split(this->FindOrAddEdge(end0, end1));
  }
  return isThere;
}

SUBDIVISION_COMPILE(class RedGreen);

}
