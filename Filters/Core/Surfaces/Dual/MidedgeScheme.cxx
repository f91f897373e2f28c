// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Dual/MidedgeScheme.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Sorting.h"
#include "Core/Surfaces/Dual/DualLimits.h"
#include "Core/Surfaces/Dual/DualRefiner.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace subdivision
{
namespace
{

/// Whether the vertices of chains are kept in the step from a level, as corners of their faces.
template <typename Id>
bool KeepsChains(const SurfaceLevel<Id>& level)
{
  return level.Step % 2 == 0; // the first step is an odd one
}

template <typename Id>
class MidedgeRefiner;

template <typename Id>
class MidedgeRefiner : public DualRefiner<Id>
{
  using typename DualRefiner<Id>::Fan;

public:
  explicit MidedgeRefiner(const SurfaceLevel<Id>& level)
    : DualRefiner<Id>(level)
    , Sides(level.Dual->GetNumberOfSides())
    , Keeps(KeepsChains(level))
  {
  }

  template <typename Out>
  void WriteFaces(Out* ids)
  {
    ForEach(this->Mesh.GetNumberOfCorners(),
      [&](vtkIdType c)
      {
        const Id corner = static_cast<Id>(c);
        const Id first = GetFirstOfSide(this->Mesh, corner);
        ids[c] = static_cast<Out>(this->Places.Sides[first]);
        if (first == corner)
        {
          this->SetVertexCorner(this->Places.Sides[first], corner);
        }
      });
    this->SetVertexFaces([&](const Fan& fan, Id at) { return this->SetFan(fan, at, ids); });
  }

private:
  Id GetSide(Id corner) const { return this->Places.Sides[GetFirstOfSide(this->Mesh, corner)]; }
  /// The vertex of the next level that is kept for the chain of a corner. Chains of a vertex are
  /// numbered in the order of its fans.
  Id GetChainVertex(Id vertex, Id corner) const
  {
    Id chain = static_cast<Id>(this->Sides) + this->Places.Chains[vertex];
    bool found = false;
    std::vector<FanStep<Id>> steps;
    VisitFans(this->Mesh, vertex,
      [&](Id other)
      {
        found = found || other == corner;
        chain += !found && !FindFanForward(this->Mesh, other, steps);
      });
    return chain;
  }

  /// The half-edge inside a face of a fan, towards the vertex.
  Id GetInside(const FanStep<Id>& step) const { return this->Mesh.Previous(step.Corner); }

  template <typename Out>
  vtkIdType SetFan(const Fan& fan, Id at, Out* ids)
  {
    const vtkIdType size = this->Places.GetFaceSize(fan.Steps.size(), fan.IsCycle);
    const Id last = this->GetInside(fan.Steps.back());
    if (size < 3)
    {
      fan.IsCycle ? this->Join(this->GetInside(fan.Steps.front()), last) : this->Open(last);
      return 0;
    }
    for (const FanStep<Id>& step : fan.Steps)
    {
      ids[at] = static_cast<Out>(this->GetSide(step.GetHalfEdgeIn(this->Mesh)));
      this->Join(at++, this->GetInside(step));
    }
    if (!fan.IsCycle)
    {
      ids[at] = static_cast<Out>(this->GetSide(fan.Steps.back().GetHalfEdgeOut(this->Mesh)));
      this->Open(at++);
    }
    if (!fan.IsCycle && this->Keeps)
    {
      const Id vertex = this->GetChainVertex(fan.Vertex, fan.Corner);
      ids[at] = static_cast<Out>(vertex);
      this->SetVertexCorner(vertex, at);
      this->Open(at);
    }
    return size;
  }

  const vtkIdType Sides;
  const bool Keeps;
};

/// Appends the limit position of a vertex between two faces, around which the next step makes no
/// face. The step after it makes a vertex in the middle of the edge that is there instead.
template <typename Id>
void AppendBetweenTwoFaces(
  const PolygonMesh<Id>& mesh, const DualFan<Id>& fan, Id vertex, RowBlock<Id>& rows)
{
  // The sides behind both ends of the two edges: four, but one where an end has two faces, too.
  std::vector<std::array<Id, 3>> behind; // sides, ends, and the vertices
  for (const FanStep<Id>& step : fan.Steps)
  {
    const Id next = mesh.Next(step.Corner);
    const Id previous = mesh.Previous(step.Corner);
    const Id last = mesh.Previous(previous);
    behind.push_back(
      { GetFirstOfSide(mesh, next), mesh.Vertices[next], mesh.Vertices[mesh.Next(next)] });
    behind.push_back({ GetFirstOfSide(mesh, last), mesh.Vertices[previous], mesh.Vertices[last] });
  }
  SortDistinct(behind);
  if (behind.size() < 3)
  {
    const Id corner = fan.Steps.front().Corner;
    const Id size = mesh.GetSize(mesh.GetFace(corner));
    const Id* vertices = mesh.Vertices.data() + mesh.GetFirst(mesh.GetFace(corner));
    std::for_each(
      vertices, vertices + size, [&](Id v) { rows.Add(v, 1. / static_cast<double>(size)); });
    return;
  }
  // The vertex in the middle, and the mean of its neighbours, each half.
  const auto addMiddle = [&](Id end, double factor)
  {
    rows.Add(vertex, factor / 2.);
    rows.Add(end, factor / 2.);
  };
  const double each = 1. / (2. * static_cast<double>(behind.size()));
  for (const Id end : fan.Ends)
  {
    addMiddle(end, 1. / 4.);
  }
  for (const auto& side : behind)
  {
    addMiddle(side[1], each / 2.);
    rows.Add(side[1], each / 4.);
    rows.Add(side[2], each / 4.);
  }
}

template <typename Id>
class MidedgeScheme : public DualScheme<Id, MidedgeRefiner<Id>>
{
public:
  FaceMemory GetFaceMemory() const override { return { 40., 1., 50., 118., 215., 290. }; }
  double CountFaces(double faces, double corners, int steps) const override
  {
    return steps > 0 ? corners * std::pow(2., steps - 2) : faces;
  }

  /// The face of a chain has all sides of its fan, and the vertex if it is kept.
  void Prepare(SurfaceLevel<Id>& level) const override
  {
    const bool keeps = KeepsChains(level);
    const auto places = CountDualPlaces(level, keeps ? 2 : 1);
    places->FirstLone = places->GetNumberOfSides() + (keeps ? places->GetNumberOfChains() : 0);
    level.Dual = places;
  }
  void AppendRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>&, vtkIdType begin,
    vtkIdType end, RowBlock<Id>& rows) const override
  {
    const PolygonMesh<Id>& mesh = level.Mesh;
    const DualPlaces<Id>& places = *level.Dual;
    const vtkIdType sides = places.GetNumberOfSides();
    const vtkIdType lone = level.Dual->FirstLone;
    Id corner = begin < sides ? FindByCount(places.Sides, begin) : 0;
    for (vtkIdType row = begin; row < end; ++row)
    {
      if (row >= lone)
      {
        AppendLoneRow(level, row - lone, rows);
      }
      else if (row >= sides)
      {
        rows.Add(FindByCount(places.Chains, row - sides), 1.);
      }
      else
      {
        while (places.Sides[corner + 1] <= row)
        {
          ++corner;
        }
        rows.Add(mesh.Vertices[corner], 0.5);
        rows.Add(mesh.Vertices[mesh.Next(corner)], 0.5);
      }
      rows.EndRow();
    }
  }
  void GetParents(
    const SurfaceLevel<Id>& level, vtkIdType row, std::vector<vtkIdType>& parents) const override
  {
    const PolygonMesh<Id>& mesh = level.Mesh;
    const vtkIdType sides = level.Dual->GetNumberOfSides();
    const vtkIdType lone = level.Dual->FirstLone;
    if (row >= lone)
    {
      GetLoneParents(level, row - lone, parents);
    }
    else if (row >= sides)
    {
      parents.assign({ FindByCount(level.Dual->Chains, row - sides) });
    }
    else
    {
      const Id corner = FindByCount(level.Dual->Sides, row);
      parents.assign({ mesh.Vertices[corner], mesh.Vertices[mesh.Next(corner)] });
    }
  }

  void ListChildren(const SurfaceLevel<Id>& level, const SurfaceSegments& segments,
    SurfaceSegments& children) const override
  {
    const DualPlaces<Id>& places = *level.Dual;
    AppendCounted(segments.Corners, segments.Sizes, places.Sides, 1, children.Vertices);
    if (KeepsChains(level))
    {
      AppendCounted(segments.Vertices, segments.Sizes, places.Chains, 1, children.Vertices);
    }
    ListDualChildren(level, segments, children);
  }
  void AppendLimitRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>&, LimitKind kind,
    vtkIdType begin, vtkIdType end, RowBlock<Id>& rows) const override
  {
    DualFan<Id> fan;
    for (vtkIdType v = begin; v < end; ++v)
    {
      const Id vertex = static_cast<Id>(v);
      const bool hasFaces = fan.Find(level.Mesh, vertex);
      const std::size_t k = fan.Steps.size();
      const bool isPosition = kind == LimitKind::Position;
      if (!hasFaces)
      {
        AppendLoneLimit(level, vertex, kind, rows);
      }
      else if (!fan.IsCycle && kind != LimitKind::Tangent2)
      {
        AppendDualBoundary(fan, vertex, kind, KeepsChains(level) ? 3. / 4. : 1. / 2., rows);
      }
      else if (fan.IsCycle && isPosition && k == 2)
      {
        AppendBetweenTwoFaces(level.Mesh, fan, vertex, rows);
      }
      else if (fan.IsCycle && (isPosition ? k > 2 : k > 3))
      {
        if (isPosition)
        {
          rows.Add(vertex, 1. / 2.);
        }
        for (std::size_t j = 0; j < k; ++j)
        {
          rows.Add(fan.Ends[j], (isPosition ? 0.5 : 1.) * GetDualWeight(kind, j, k));
        }
      }
      rows.EndRow();
    }
  }
};

}

template <typename Id>
std::unique_ptr<SurfaceScheme<Id>> MakeMidedgeScheme()
{
  return std::make_unique<MidedgeScheme<Id>>();
}

SUBDIVISION_COMPILE_FUNCTION(MakeMidedgeScheme);

}
