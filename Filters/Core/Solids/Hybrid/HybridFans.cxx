// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Hybrid/HybridFans.h"

#include "Core/Memory/Ids.h"

#include <algorithm>

namespace subdivision
{
namespace
{

/// The faces of a fan around vertex 0 as cells: the far ends of edges follow it, then the far
/// corners of quads.
CellList<int> MakeFanCells(const Neighbourhood& key)
{
  const bool isClosed = key.back() == 1;
  const int faces = static_cast<int>(key.size()) - 1;
  const int edges = faces + (isClosed ? 0 : 1);
  CellList<int> list;
  list.Shapes = Buffer<CellShape>(faces);
  list.Offsets = Buffer<int>(faces + 1, 0);
  std::vector<int> corners;
  int last = edges;
  for (int f = 0; f < faces; ++f)
  {
    list.Shapes[f] = key[f] == 4 ? CellShape::Quad : CellShape::Triangle;
    corners.insert(corners.end(), { 0, 1 + f });
    if (key[f] == 4)
    {
      corners.push_back(++last);
    }
    corners.push_back(1 + (f + 1) % edges);
    list.Offsets[f + 1] = static_cast<int>(corners.size());
  }
  list.NumberOfPoints = last + 1;
  list.Corners = Buffer<int>(static_cast<vtkIdType>(corners.size()));
  std::copy(corners.begin(), corners.end(), list.Corners.begin());
  return list;
}

}

template <typename Id>
bool FollowFan(const HybridLevel<Id>& level, Id vertex, Id edge, Id face, HybridFan<Id>& fan)
{
  const CellComplex<Id>& complex = level.Complex;
  const auto ruleOf = [&level](Id e) { return level.Strata.Edges[e].Result.GetRule(); };
  fan.Vertex = vertex;
  fan.Edges.assign(1, edge);
  fan.Faces.clear();
  for (;;)
  {
    if (complex.GetSize(face) == 4 && level.Strata.Faces[face].GetRule() != Rule::Surface)
    {
      return false;
    }
    fan.Faces.push_back(face);
    const Id next = GetOtherEdge(complex, face, fan.Edges.back(), vertex, Id(0));
    fan.IsClosed = next == edge;
    if (fan.IsClosed)
    {
      return ruleOf(edge) == Rule::Surface;
    }
    fan.Edges.push_back(next);
    if (ruleOf(next) != Rule::Surface)
    {
      return ruleOf(next) == Rule::Curve && ruleOf(edge) == Rule::Curve;
    }
    Id beyond = -1;
    int size = 0;
    bool isThere = false;
    for (const Id other : complex.EdgeFaces[next])
    {
      if (IsInRing(complex, level.Strata, other, level.Strata.Edges[next]))
      {
        ++size;
        isThere = isThere || other == face;
        beyond = other == face ? beyond : other;
      }
    }
    if (size != 2 || !isThere)
    {
      return false;
    }
    face = beyond;
  }
}

template <typename Id>
bool FindFan(const HybridLevel<Id>& level, Id vertex, HybridFan<Id>& fan)
{
  const CellComplex<Id>& complex = level.Complex;
  const Decision& decision = level.Strata.Vertices[vertex];
  Id first[2] = { -1, -1 };
  std::size_t ends = 0;
  for (const Id edge : complex.VertexEdges[vertex])
  {
    for (const Id face : complex.EdgeFaces[edge])
    {
      if (IsInRing(complex, level.Strata, face, decision))
      {
        ++ends;
        first[0] = first[0] < 0 ? edge : first[0];
        first[1] = first[1] < 0 ? face : first[1];
      }
    }
  }
  return ends > 0 && FollowFan(level, vertex, first[0], first[1], fan) && fan.IsClosed &&
    2 * fan.Faces.size() == ends &&
    std::all_of(fan.Faces.begin(), fan.Faces.end(),
      [&](Id face) { return IsInRing(complex, level.Strata, face, decision); });
}

template <typename Id>
bool IsPlainFan(const HybridLevel<Id>& level, const HybridFan<Id>& fan)
{
  const auto isPlain = [&](const HybridStrata<Id>& strata, bool isSharp)
  {
    return strata.Sectors.empty() ||
      std::all_of(fan.Edges.begin(), fan.Edges.end(),
        [&](Id edge)
        {
          const auto sectors = FindSectorEdges(strata.Sectors, edge);
          return std::all_of(sectors.begin(), sectors.end(),
            [&](const SectorEdge<Id>& sector)
            {
              return !isSharp && !fan.IsClosed && !sector.IsShared &&
                level.Complex.EdgeVertices[2 * vtkIdType(edge) + sector.End] == fan.Vertex;
            });
        });
  };
  const auto& stages = level.Sharpness.Stages;
  return level.Sharpness.GetMost(level.Complex, fan.Vertex) <= 0. && isPlain(level.Strata, false) &&
    std::all_of(
      stages.begin(), stages.end(), [&](const auto& stage) { return isPlain(stage.Strata, true); });
}

LocalRows MakeFanRows(const Neighbourhood& key, LoopWeights weights)
{
  HybridLevel<int> level;
  level.Complex = BuildCellComplex(MakeFanCells(key));
  StrataOptions options;
  options.Weights = weights;
  level.Strata = DecideHybridStrata(level.Complex, SingularSimplices(), options);
  HybridFan<int> fan;
  fan.IsClosed = key.back() == 1;
  const auto size = static_cast<int>(key.size()) - 1;
  for (int f = 0; f < size + (fan.IsClosed ? 0 : 1); ++f)
  {
    fan.Edges.push_back(level.Complex.FindEdge(0, 1 + f));
    f < size ? fan.Faces.push_back(*level.Complex.CellFaces[f].begin()) : void();
  }
  const HybridRows<int> rows(level, HybridRules::Smooth);
  const auto addRow = rows.StartRows();
  RowBlock<int> block;
  LocalRows local;
  fan.ForItems(level.Complex,
    [&](std::size_t, int, vtkIdType row)
    {
      block.Clear();
      addRow(row, block);
      for (std::size_t k = 0; k < block.GetNumberOfEntries(); ++k)
      {
        local.Add(block.GetColumns()[k], block.GetWeights()[k]);
      }
      local.EndRow();
    });
  return local;
}

const std::vector<double>& FanLimits::Find(const Neighbourhood& key)
{
  if (this->Solved.size() > MostSolutions)
  {
    this->Solved.clear();
  }
  std::vector<double>& weights = this->Solved[key];
  if (weights.empty())
  {
    weights = MakeFanRows(key, this->Weights).FindLimit();
  }
  return weights;
}

#define SUBDIVISION_FANS(Id)                                                                       \
  template bool FollowFan(const HybridLevel<Id>&, Id, Id, Id, HybridFan<Id>&);                     \
  template bool FindFan(const HybridLevel<Id>&, Id, HybridFan<Id>&);                               \
  template bool IsPlainFan(const HybridLevel<Id>&, const HybridFan<Id>&)
SUBDIVISION_FANS(int);
SUBDIVISION_FANS(long long);

}
