// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Dual/DualPlaces.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"

namespace subdivision
{
namespace
{

template <typename Id>
Id GetLineEnd(const SurfaceLevel<Id>& level, Id line, int end)
{
  const Id value = level.Lines[line];
  return level.Mesh.EdgeVertices[2 * (value / 2) + (value % 2 + end) % 2];
}

template <typename Id>
void CountSides(const PolygonMesh<Id>& mesh, DualPlaces<Id>& places)
{
  const vtkIdType corners = mesh.GetNumberOfCorners();
  places.Sides = Buffer<Id>(corners + 1);
  ForEach(corners,
    [&](vtkIdType c)
    {
      const Id corner = static_cast<Id>(c);
      places.Sides[c] = GetFirstOfSide(mesh, corner) == corner;
    });
  CountsToOffsets(places.Sides);
  if (2 * places.GetNumberOfSides() > corners)
  {
    places.OpenSides = Buffer<Id>(corners + 1);
    ForEach(corners, [&](vtkIdType c) { places.OpenSides[c] = mesh.Twins[c] < 0; });
    CountsToOffsets(places.OpenSides);
  }
}

template <typename Id>
void CountFans(const SurfaceLevel<Id>& level, DualPlaces<Id>& places)
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  const vtkIdType vertices = mesh.NumberOfVertices;
  for (Buffer<Id>* counts : { &places.Faces, &places.Corners, &places.Chains, &places.Kept })
  {
    *counts = Buffer<Id>(vertices + 1);
  }
  const auto count = [&](Id vertex, const auto& visitFans)
  {
    Id faces = 0;
    Id corners = 0;
    Id chains = 0;
    Id fans = 0;
    visitFans(
      [&](Id, const std::vector<FanStep<Id>>& steps, bool cycle)
      {
        const vtkIdType face = places.GetFaceSize(steps.size(), cycle);
        faces += face >= 3;
        corners += face >= 3 ? static_cast<Id>(face) : 0;
        chains += !cycle;
        ++fans;
      });
    places.Faces[vertex] = faces;
    places.Corners[vertex] = corners;
    places.Chains[vertex] = chains;
    places.Kept[vertex] = fans == 0;
  };
  ForRanges(
    vertices, [&](vtkIdType begin, vtkIdType end) { ForFansForward(mesh, begin, end, count); });
  CountsToOffsets(places.Faces);
  CountsToOffsets(places.Corners);
  CountsToOffsets(places.Chains);
}

template <typename Id>
void CountLines(const SurfaceLevel<Id>& level, DualPlaces<Id>& places)
{
  const Id lines = static_cast<Id>(level.Lines.size());
  for (Id point : InTurn(level.Points))
  {
    places.Kept[point] = 1;
  }
  for (Id line = 0; line < lines; ++line)
  {
    places.Kept[GetLineEnd(level, line, 0)] = 1;
    places.Kept[GetLineEnd(level, line, 1)] = 1;
  }
  CountsToOffsets(places.Kept);
  const vtkIdType vertices = level.Mesh.NumberOfVertices;
  places.KeptVertices.resize(places.Kept[vertices]);
  ForEach(vertices,
    [&places](vtkIdType v)
    {
      if (places.Kept[v] < places.Kept[v + 1])
      {
        places.KeptVertices[places.Kept[v]] = static_cast<Id>(v);
      }
    });
  std::vector<Id> segments(lines > 0 ? level.Mesh.GetNumberOfEdges() : 0, -1);
  for (Id line = 0; line < lines; ++line)
  {
    Id& segment = segments[level.Lines[line] / 2];
    if (segment < 0)
    {
      segment = static_cast<Id>(places.FirstLines.size());
      places.FirstLines.push_back(line);
    }
    places.Segments.push_back(segment);
  }
  places.Around.assign(2 * places.KeptVertices.size(), -1);
  std::vector<Id> degrees(places.KeptVertices.size(), 0);
  for (Id line : InTurn(places.FirstLines))
  {
    for (int end = 0; end < 2; ++end)
    {
      const Id kept = places.Kept[GetLineEnd(level, line, end)];
      if (degrees[kept] < 2)
      {
        places.Around[2 * kept + degrees[kept]] = GetLineEnd(level, line, 1 - end);
      }
      ++degrees[kept];
    }
  }
  for (std::size_t k = 0; k < degrees.size(); ++k)
  {
    if (degrees[k] != 2)
    {
      places.Around[2 * k] = -1; // an end of a curve, or a point where curves meet, stays
    }
  }
}

}

template <typename Id>
std::shared_ptr<DualPlaces<Id>> CountDualPlaces(const SurfaceLevel<Id>& level, int ofChain)
{
  auto places = std::make_shared<DualPlaces<Id>>();
  places->OfChain = ofChain;
  CountSides(level.Mesh, *places);
  CountFans(level, *places);
  CountLines(level, *places);
  for (Buffer<Id>* counts : { &places->Chains, &places->Kept })
  {
    if ((*counts)[level.Mesh.NumberOfVertices] == 0)
    {
      *counts = {};
    }
  }
  return places;
}

template <typename Id>
void AppendLoneRow(const SurfaceLevel<Id>& level, vtkIdType row, RowBlock<Id>& rows)
{
  const DualPlaces<Id>& places = *level.Dual;
  const vtkIdType kept = static_cast<vtkIdType>(places.KeptVertices.size());
  if (row >= kept)
  {
    const Id line = places.FirstLines[row - kept];
    rows.Add(GetLineEnd(level, line, 0), 0.5);
    rows.Add(GetLineEnd(level, line, 1), 0.5);
    return;
  }
  if (places.Around[2 * row] < 0)
  {
    rows.Add(places.KeptVertices[row], 1.);
    return;
  }
  rows.Add(places.KeptVertices[row], 0.75);
  rows.Add(places.Around[2 * row], 0.125);
  rows.Add(places.Around[2 * row + 1], 0.125);
}

template <typename Id>
void AppendLoneLimit(const SurfaceLevel<Id>& level, Id vertex, LimitKind kind, RowBlock<Id>& rows)
{
  const DualPlaces<Id>& places = *level.Dual;
  const Id kept = places.Kept[vertex];
  const Id* around = places.Around.data() + 2 * kept;
  const bool isOnCurve = kept < places.Kept[vertex + 1] && around[0] >= 0;
  if (kind == LimitKind::Position)
  {
    rows.Add(vertex, isOnCurve ? 2. / 3. : 1.);
  }
  for (int end = 0; end < 2 && isOnCurve && kind != LimitKind::Tangent2; ++end)
  {
    rows.Add(around[end], kind == LimitKind::Position ? 1. / 6. : end == 0 ? 1. : -1.);
  }
}

template <typename Id>
Id FindOrientingFace(const SurfaceLevel<Id>& level, vtkIdType vertexFace)
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  const Id vertex = FindByCount(level.Dual->Faces, vertexFace);
  vtkIdType left = vertexFace - level.Dual->Faces[vertex];
  Id face = -1;
  std::vector<FanStep<Id>> steps;
  VisitFans(mesh, vertex,
    [&](Id corner)
    {
      const bool cycle = FindFanForward(mesh, corner, steps);
      if (level.Dual->GetFaceSize(steps.size(), cycle) >= 3 && left-- == 0)
      {
        face = mesh.GetFace(corner);
      }
    });
  return face;
}

template <typename Id>
void GetLoneParents(const SurfaceLevel<Id>& level, vtkIdType row, std::vector<vtkIdType>& parents)
{
  const DualPlaces<Id>& places = *level.Dual;
  const vtkIdType kept = static_cast<vtkIdType>(places.KeptVertices.size());
  if (row < kept)
  {
    parents.assign({ places.KeptVertices[row] });
    return;
  }
  const Id line = places.FirstLines[row - kept];
  parents.assign({ GetLineEnd(level, line, 0), GetLineEnd(level, line, 1) });
}

template <typename Id>
void RefineLines(const SurfaceLevel<Id>& level, SurfaceLevel<Id>& next)
{
  const DualPlaces<Id>& places = *level.Dual;
  const vtkIdType first = places.FirstLone;
  next.Points = Buffer<Id>(level.Points.size());
  ForEach(level.Points.size(),
    [&](vtkIdType i) { next.Points[i] = static_cast<Id>(first + places.Kept[level.Points[i]]); });
  const vtkIdType segments = static_cast<vtkIdType>(places.FirstLines.size());
  const vtkIdType middles = first + static_cast<vtkIdType>(places.KeptVertices.size());
  next.Mesh.EdgeVertices = Buffer<Id>(4 * segments);
  next.Mesh.EdgeCorners = Buffer<Id>(2 * segments, static_cast<Id>(-1));
  ForEach(segments,
    [&](vtkIdType s)
    {
      const Id line = places.FirstLines[s];
      Id* ids = next.Mesh.EdgeVertices.data() + 4 * s;
      ids[0] = static_cast<Id>(first + places.Kept[GetLineEnd(level, line, 0)]);
      ids[1] = ids[2] = static_cast<Id>(middles + s);
      ids[3] = static_cast<Id>(first + places.Kept[GetLineEnd(level, line, 1)]);
    });
  next.Lines = Buffer<Id>(2 * level.Lines.size());
  ForEach(level.Lines.size(),
    [&](vtkIdType i)
    {
      const Id line = static_cast<Id>(i);
      const Id segment = places.Segments[i];
      const Id against =
        GetLineEnd(level, line, 0) != GetLineEnd(level, places.FirstLines[segment], 0);
      next.Lines[2 * i] = 2 * (2 * segment + against) + against;
      next.Lines[2 * i + 1] = 2 * (2 * segment + 1 - against) + against;
    });
}

template <typename Id>
void CarryDualFaces(
  const SurfaceLevel<Id>& level, const Buffer<Carrier<Id>>& faces, Buffer<Carrier<Id>>& children)
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  const DualPlaces<Id>& places = *level.Dual;
  children =
    Buffer<Carrier<Id>>(faces.size() + places.GetNumberOfQuads() + places.GetNumberOfFaces());
  std::copy(faces.begin(), faces.end(), children.begin());
  Carrier<Id>* const ofSides = children.data() + faces.size();
  Carrier<Id>* const fans = ofSides + places.GetNumberOfQuads();
  ForEach(places.HasQuads ? mesh.GetNumberOfCorners() : 0,
    [&](vtkIdType c)
    {
      const Id corner = static_cast<Id>(c);
      if (GetFirstOfSide(mesh, corner) == corner)
      {
        CommonCarrier<Id> common;
        common.Add(faces[mesh.GetFace(corner)]);
        if (mesh.Twins[c] >= 0)
        {
          common.Add(faces[mesh.GetFace(mesh.Twins[c])]);
        }
        ofSides[places.Sides[c]] = common.Get();
      }
    });
  const auto carry = [&](Id vertex, const auto& visitFans)
  {
    Carrier<Id>* fan = fans + places.Faces[vertex];
    visitFans(
      [&](Id, const std::vector<FanStep<Id>>& steps, bool cycle)
      {
        if (places.GetFaceSize(steps.size(), cycle) < 3)
        {
          return;
        }
        CommonCarrier<Id> common;
        for (const FanStep<Id>& step : steps)
        {
          common.Add(faces[mesh.GetFace(step.Corner)]);
        }
        *fan++ = common.Get();
      });
  };
  ForRanges(mesh.NumberOfVertices,
    [&](vtkIdType begin, vtkIdType end) { ForFansForward(mesh, begin, end, carry); });
}

template <typename Id>
void ListDualChildren(
  const SurfaceLevel<Id>& level, const SurfaceSegments& segments, SurfaceSegments& children)
{
  const DualPlaces<Id>& places = *level.Dual;
  const std::vector<Id>& first = places.FirstLines;
  AppendCounted(segments.Vertices, segments.Sizes, places.Kept, 1, children.Vertices);
  AppendVariedChildren(
    segments.Lines, segments.Sizes, [&first](vtkIdType line)
    { return std::lower_bound(first.begin(), first.end(), line) - first.begin(); },
    children.Vertices);
  AppendChildren(segments.Faces, 1, children.Faces);
  AppendChildren(segments.Corners, 1, children.Corners);
  if (places.HasQuads)
  {
    AppendCounted(segments.Corners, segments.Sizes, places.Sides, 1, children.Faces);
    AppendCounted(segments.Corners, segments.Sizes, places.Sides, 4, children.Corners);
  }
  AppendCounted(segments.Vertices, segments.Sizes, places.Faces, 1, children.Faces);
  AppendCounted(segments.Vertices, segments.Sizes, places.Corners, 1, children.Corners);
  AppendChildren(segments.Lines, 2, children.Lines);
}

SUBDIVISION_COMPILE_FUNCTION(CountDualPlaces);
SUBDIVISION_COMPILE_FUNCTION(ListDualChildren);
SUBDIVISION_COMPILE_FUNCTION(AppendLoneRow);
SUBDIVISION_COMPILE_FUNCTION(AppendLoneLimit);
SUBDIVISION_COMPILE_FUNCTION(FindOrientingFace);
SUBDIVISION_COMPILE_FUNCTION(GetLoneParents);
SUBDIVISION_COMPILE_FUNCTION(RefineLines);
SUBDIVISION_COMPILE_FUNCTION(CarryDualFaces);

}
