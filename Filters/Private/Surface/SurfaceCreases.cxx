// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Surface/SurfaceCreases.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Memory/Vectors.h"
#include "Core/Rules/Pi.h"
#include "Core/Surfaces/Scheme/SurfaceRings.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Control/Stamp.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

namespace subdivision
{
namespace
{

using namespace vectors;

/// A vector in the plane of a face that points from the edge of `corner` into the face: the mean
/// normal of the face times the edge.
template <typename Id>
Vector FindHeight(const PolygonMesh<Id>& mesh, Id corner, const double* points)
{
  auto between = [&](Id from, Id to)
  {
    return Subtract(points + 3 * static_cast<vtkIdType>(mesh.Vertices[to]),
      points + 3 * static_cast<vtkIdType>(mesh.Vertices[from]));
  };
  Vector normal{ 0., 0., 0. };
  const Id after = mesh.Next(corner);
  for (Id c = mesh.Next(after); c != corner; c = mesh.Next(c))
  {
    const Id before = mesh.Previous(c);
    const Vector part = Cross(between(corner, before), between(corner, c));
    for (int i = 0; i < 3; ++i)
    {
      normal[i] += part[i];
    }
  }
  return Cross(normal, between(corner, after));
}

/// The ends of the edges that `isWanted` takes.
template <typename Id, typename IsWanted>
std::vector<vtkIdType> ListEdges(const PolygonMesh<Id>& mesh, const IsWanted& isWanted)
{
  std::vector<vtkIdType> pairs;
  for (const vtkIdType e : InTurn(mesh.GetNumberOfEdges()))
  {
    if (isWanted(e))
    {
      pairs.insert(pairs.end(), { mesh.EdgeVertices[2 * e], mesh.EdgeVertices[2 * e + 1] });
    }
  }
  return pairs;
}

template <typename Id>
std::vector<vtkIdType> FindFeatureEdges(
  const PolygonMesh<Id>& mesh, const Coordinates& points, double angle)
{
  constexpr double degree = Pi / 180.;
  const double least = (angle + 180. * points.Tie) * degree; // more than may be rounding
  Buffer<unsigned char> turns(mesh.GetNumberOfEdges());
  ForEach(turns.size(),
    [&](vtkIdType e)
    {
      turns[e] = 0;
      const Id corner = mesh.EdgeCorners[e];
      if (corner < 0 || mesh.Twins[corner] < 0)
      {
        return;
      }
      const Vector a = FindHeight(mesh, corner, points);
      const Vector b = FindHeight(mesh, mesh.Twins[corner], points);
      const double lengths = std::sqrt(Dot(a, a)) * std::sqrt(Dot(b, b));
      if (lengths > 0. && std::isfinite(lengths))
      {
        const double cosine = std::max(-1., std::min(-Dot(a, b) / lengths, 1.));
        turns[e] = std::acos(cosine) > least;
      }
    });
  return ListEdges(mesh, [&](vtkIdType e) { return turns[e] != 0; });
}

template <typename Id>
std::vector<vtkIdType> FindInterfaceEdges(
  const PolygonMesh<Id>& mesh, const std::vector<vtkIdType>& faceCells, vtkDataArray* materials)
{
  const std::vector<int> numbers = NumberMaterials(materials);
  auto materialOf = [&](Id corner)
  { return numbers[static_cast<std::size_t>(faceCells[mesh.GetFace(corner)])]; };
  return ListEdges(mesh,
    [&](vtkIdType e)
    {
      const Id corner = mesh.EdgeCorners[e];
      const Id twin = corner < 0 ? corner : mesh.Twins[corner];
      return twin >= 0 && materialOf(corner) != materialOf(twin);
    });
}

}

template <typename Id>
std::vector<vtkIdType> FindDerivedEdges(const PolygonMesh<Id>& mesh,
  const std::vector<vtkIdType>& faceCells, const Coordinates& points, const FeatureOptions& options)
{
  std::vector<vtkIdType> pairs;
  if (options.PreserveInterfaces)
  {
    pairs = FindInterfaceEdges(mesh, faceCells, options.Material);
  }
  if (options.DetectFeatures)
  {
    const std::vector<vtkIdType> more = FindFeatureEdges(mesh, points, options.FeatureAngle);
    std::copy(more.begin(), more.end(), std::back_inserter(pairs));
  }
  return pairs;
}

SharpPairs FindMarkedEdges(
  vtkPolyData* input, const MarkOptions& marks, const std::function<void(const std::string&)>& warn)
{
  SharpPairs pairs;
  if (marks.IsEmpty())
  {
    return pairs;
  }
  MarkOptions options = marks;
  options.FacesStay = true; // the sharpness of faces is for solids
  const SharpTuples marked =
    FindMarkedSimplices(input, CellsToSimplices(input, nullptr), options, warn);
  const SimplexTuples& tuples = marked.Tuples;
  pairs.Points = tuples.Tuples[1];
  pairs.Sharpness = marked.Sharpness[1];
  for (const vtkIdType corner : tuples.Tuples[0])
  {
    pairs.Points.insert(pairs.Points.end(), 2, corner);
  }
  // As for flagged faces: an edge of marked faces is sharp unless it has exactly two of them.
  std::map<std::pair<vtkIdType, vtkIdType>, int> counts;
  const std::vector<vtkIdType>& faces = tuples.Tuples[2];
  for (std::size_t i = 0; i < faces.size(); i += 3) // whose points ascend
  {
    ++counts[{ faces[i], faces[i + 1] }];
    ++counts[{ faces[i], faces[i + 2] }];
    ++counts[{ faces[i + 1], faces[i + 2] }];
  }
  for (const auto& count : InTurn(counts))
  {
    if (count.second != 2)
    {
      pairs.Points.insert(pairs.Points.end(), { count.first.first, count.first.second });
    }
  }
  if (!pairs.Sharpness.empty())
  {
    pairs.Sharpness.resize(pairs.Points.size() / 2, std::numeric_limits<double>::infinity());
  }
  return pairs;
}

template <typename Id>
void AddSharpEdges(const PolygonMesh<Id>& mesh, const SharpPairs& pairs, SurfaceCreases& creases)
{
  SurfaceFeatures& features = creases.Features;
  if (!pairs.Points.empty())
  {
    features.SharpEdges.resize(mesh.GetNumberOfEdges(), 0);
  }
  std::vector<Id> edges;
  for (std::size_t i = 0; i + 1 < pairs.Points.size(); i += 2)
  {
    const Id a = static_cast<Id>(pairs.Points[i]);
    const vtkIdType b = pairs.Points[i + 1];
    if (a == b)
    {
      features.Corners.resize(mesh.NumberOfVertices, 0);
      features.Corners[a] = 1;
      continue;
    }
    const bool isFinite = !pairs.Sharpness.empty() && !std::isinf(pairs.Sharpness[i / 2]);
    if (isFinite)
    {
      creases.Sharpness.resize(mesh.GetNumberOfEdges(), 0.);
    }
    CollectEdges(mesh, a, [&](Id e) { return mesh.GetOtherEnd(e, a) == b; }, edges);
    for (Id edge : InTurn(edges))
    {
      if (isFinite)
      {
        creases.Sharpness[edge] = std::max(creases.Sharpness[edge], pairs.Sharpness[i / 2]);
      }
      else
      {
        features.SharpEdges[edge] = 1;
      }
    }
  }
}

template <typename Id>
std::vector<vtkIdType> ListSharpEdges(const PolygonMesh<Id>& mesh, const SurfaceFeatures& features)
{
  std::vector<vtkIdType> pairs = ListEdges(mesh, [&](vtkIdType e)
    { return !features.SharpEdges.empty() && features.SharpEdges[static_cast<std::size_t>(e)]; });
  for (const std::size_t v : InTurn(features.Corners.size()))
  {
    if (features.Corners[v])
    {
      pairs.insert(pairs.end(), 2, static_cast<vtkIdType>(v));
    }
  }
  return pairs;
}

JointRule FindKnownRule(JointRule rule)
{
  return rule == JointRule::Sharp ? rule : JointRule::Blend;
}

template <typename Id>
SurfaceCreases ReadSurfaceCreases(
  const FeatureOptions& options, const SurfaceCells& cells, const SurfaceLevel<Id>& level)
{
  SurfaceCreases creases;
  SurfaceFeatures& features = creases.Features;
  const PolygonMesh<Id>& mesh = level.Mesh;
  features.DartEnds = options.DartEnds;
  features.Type1 = FindKnownRule(options.Type1);
  features.Type2 = FindKnownRule(options.Type2);
  features.Type3 = FindKnownRule(options.Type3);
  if (vtkDataArray* flags = options.Singular)
  {
    features.SharpEdges.assign(mesh.GetNumberOfEdges(), 0);
    features.Corners.assign(mesh.NumberOfVertices, 0);
    auto isFlagged = [flags](vtkIdType cell) { return flags->GetComponent(cell, 0) != 0.; };
    for (const std::size_t i : InTurn(cells.Vertices.size()))
    {
      features.Corners[cells.Vertices[i]] |= isFlagged(cells.VertexCells[i]);
    }
    // An edge of flagged faces is sharp unless it has exactly two of them.
    std::vector<unsigned char> counts(mesh.GetNumberOfEdges(), 0);
    for (const vtkIdType c : InTurn(mesh.GetNumberOfCorners()))
    {
      unsigned char& count = counts[mesh.Edges[c]];
      count = static_cast<unsigned char>(
        std::min(3, count + isFlagged(cells.FaceCells[mesh.GetFace(static_cast<Id>(c))])));
    }
    for (const std::size_t e : InTurn(counts.size()))
    {
      features.SharpEdges[e] = counts[e] == 1 || counts[e] > 2;
    }
    for (const vtkIdType s : InTurn(level.Lines.size()))
    {
      features.SharpEdges[level.Lines[s] / 2] |= isFlagged(cells.SegmentCells[s]);
    }
  }
  if (vtkDataArray* sharpness = options.Sharpness)
  {
    creases.Sharpness.assign(mesh.GetNumberOfEdges(), 0.);
    for (const vtkIdType s : InTurn(level.Lines.size()))
    {
      const double value = sharpness->GetComponent(cells.SegmentCells[s], 0);
      double& edge = creases.Sharpness[level.Lines[s] / 2];
      edge = value > edge ? value : edge;
    }
    for (const std::size_t e : InTurn(creases.Sharpness.size()))
    {
      if (std::isinf(creases.Sharpness[e]))
      {
        features.SharpEdges.resize(creases.Sharpness.size(), 0);
        features.SharpEdges[e] = 1;
        creases.Sharpness[e] = 0.;
      }
    }
  }
  return creases;
}

template <typename Id>
void WriteSharpCorners(const PolygonMesh<Id>& mesh, const SurfaceCreases& creases,
  const double* points, SurfaceStamp& stamp)
{
  stamp.FaceAngles.clear();
  stamp.GivenCorners.clear();
  std::vector<unsigned char> isEnd(static_cast<std::size_t>(mesh.NumberOfVertices), 0);
  for (const std::size_t e : InTurn(creases.Sharpness.size()))
  {
    for (std::size_t i = 2 * e; i < 2 * e + 2 && creases.Sharpness[e] > 0.; ++i)
    {
      isEnd[mesh.EdgeVertices[static_cast<vtkIdType>(i)]] = 1;
    }
  }
  const SurfaceFeatures& features = creases.Features;
  for (const std::size_t v : InTurn(isEnd.size()))
  {
    if (isEnd[v])
    {
      stamp.GivenCorners.insert(stamp.GivenCorners.end(),
        { static_cast<double>(v), features.Angles.empty() ? -1. : features.Angles[v],
          features.Flatness.empty() ? -1. : features.Flatness[v] });
    }
  }
  const vtkIdType corners = stamp.GivenCorners.empty() ? 0 : mesh.GetNumberOfCorners();
  for (const vtkIdType c : InTurn(corners))
  {
    if (isEnd[mesh.Vertices[c]])
    {
      stamp.FaceAngles.insert(stamp.FaceAngles.end(),
        { static_cast<double>(c), MeasureFaceAngle(mesh, static_cast<Id>(c), points) });
    }
  }
}

template <typename Id>
void ReadSharpCorners(
  const SurfaceStamp& stamp, const PolygonMesh<Id>& mesh, SurfaceFeatures& features)
{
  auto set = [](std::vector<double>& values, vtkIdType size, double place, double value)
  {
    const vtkIdType at = ToId(place);
    if (at >= 0 && at < size)
    {
      values.resize(static_cast<std::size_t>(size), -1.);
      values[at] = value;
    }
  };
  for (std::size_t i = 0; i + 2 < stamp.GivenCorners.size(); i += 3)
  {
    const double* given = stamp.GivenCorners.data() + i;
    set(features.Angles, mesh.NumberOfVertices, given[0], given[1]);
    set(features.Flatness, mesh.NumberOfVertices, given[0], given[2]);
  }
  for (std::size_t i = 0; i + 1 < stamp.FaceAngles.size(); i += 2)
  {
    set(
      features.FaceAngles, mesh.GetNumberOfCorners(), stamp.FaceAngles[i], stamp.FaceAngles[i + 1]);
  }
}

void TakeGivenOfPart(const SurfaceStamp& stamp, SurfaceFeatures& features)
{
  const auto take = [&stamp](int component)
  {
    std::vector<double> values;
    for (std::size_t i = 0; i < stamp.ControlPoints.size(); i += ControlPointComponents)
    {
      values.push_back(stamp.ControlPoints[i + component]);
    }
    return values;
  };
  features.Angles = take(4);
  features.Flatness = take(5);
}

std::vector<double> ReadPointValues(vtkDataArray* array, vtkIdType points, double factor)
{
  std::vector<double> values;
  for (vtkIdType i = 0; array && i < points; ++i)
  {
    const double value = array->GetComponent(i, 0);
    values.push_back(value >= 0. ? value * factor : -1.);
  }
  return values;
}

SUBDIVISION_COMPILE_FUNCTION(WriteSharpCorners);
SUBDIVISION_COMPILE_FUNCTION(ReadSharpCorners);
SUBDIVISION_COMPILE_FUNCTION(ReadSurfaceCreases);
SUBDIVISION_COMPILE_FUNCTION(FindDerivedEdges);
SUBDIVISION_COMPILE_FUNCTION(AddSharpEdges);
SUBDIVISION_COMPILE_FUNCTION(ListSharpEdges);

}
