// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Surface/SurfaceNumbers.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Surfaces/Scheme/SurfaceSides.h"
#include "Private/Partitions/OtherPartitions.h"
#include "Private/Partitions/SharedSides.h"
#include "Private/Reading/UnusedPoints.h"

#include "vtkPolyData.h"

#include <algorithm>

namespace subdivision
{
using Kinds = SurfaceSegments;

SharedKeys MakeVertexKeys(vtkPolyData* input, const OtherPartitions& others)
{
  SharedKeys vertices;
  vertices.Keys = others.GetPointIds();
  vertices.Own = FindOwnPoints(input, {}, others);
  for (const vtkIdType unused : FindUnusedPoints(input))
  {
    vertices.Own[unused] = 1;
  }
  return vertices;
}

template <typename Id>
SharedKeys MakeEdgeKeys(const SurfaceLevel<Id>& control, const SharedKeys& faces,
  const SharedKeys& lines, const SharedNumbers& vertices)
{
  const PolygonMesh<Id>& mesh = control.Mesh;
  const size_t kinds = vertices.Totals.size();
  SharedKeys edges;
  edges.Width = 2;
  edges.Own.assign(static_cast<size_t>(mesh.GetNumberOfEdges()), 0);
  for (const vtkIdType c : InTurn(mesh.GetNumberOfCorners()))
  {
    edges.Own[mesh.Edges[c]] |= faces.Own[mesh.GetFace(static_cast<Id>(c))];
  }
  for (const vtkIdType line : InTurn(control.Lines.size()))
  {
    edges.Own[control.Lines[line] / 2] |= lines.Own[line];
  }
  for (const vtkIdType e : InTurn(mesh.GetNumberOfEdges()))
  {
    const vtkIdType ends[2] = { vertices.First[kinds * mesh.EdgeVertices[2 * e]],
      vertices.First[kinds * mesh.EdgeVertices[2 * e + 1]] };
    const auto [least, most] = std::minmax(ends[0], ends[1]);
    edges.Own[e] = edges.Own[e] && least >= 0;
    edges.Keys.push_back(std::max<vtkIdType>(least, 0));
    edges.Keys.push_back(std::max<vtkIdType>(most, 0));
  }
  return edges;
}

ControlKeys MakeControlKeys(vtkPolyData* input, const SurfaceCells& cells, OtherPartitions& others)
{
  const std::vector<vtkIdType> places = PlaceCells(input, others);
  ControlKeys keys;
  keys[Kinds::Vertex] = MakeVertexKeys(input, others);
  keys[Kinds::Vertex].Keys.resize(static_cast<size_t>(cells.NumberOfPoints));
  keys[Kinds::Vertex].Own.resize(keys[Kinds::Vertex].Keys.size());
  keys[Kinds::Face] = MakeKeysOfPieces(cells.FaceCells, places, others);
  keys[Kinds::Line] = MakeKeysOfPieces(cells.SegmentCells, places, others);
  keys[VertexCellKind] = MakeKeysOfPieces(cells.VertexCells, places, others);
  return keys;
}

template <typename Id>
Buffer<unsigned char> FindTurnedOfPart(
  const PolygonMesh<Id>& mesh, const ControlKeys& keys, OtherPartitions& others)
{
  const SharedKeys& vertices = keys[Kinds::Vertex]; // all faces at own ones are known
  const auto links = LinkFaces(
    mesh, [&vertices](Id vertex) { return vertices.Own[static_cast<size_t>(vertex)] != 0; });
  return JoinSides(FindSides(mesh.NumberOfFaces, links), keys[Kinds::Face], others);
}

template <typename Id>
SurfaceNumbers NumberSurface(ControlKeys keys, const SurfaceLevel<Id>& control,
  const SurfaceSegments& segments, OtherPartitions& others)
{
  IdSegments ofCells{ { VertexCellKind, 1, {} } };
  ofCells.insert(ofCells.end(), segments.Lines.begin(), segments.Lines.end());
  ofCells.insert(ofCells.end(), segments.Faces.begin(), segments.Faces.end());
  const std::vector<const IdSegments*> lists{ &segments.Vertices, &ofCells };
  std::vector<SharedNumbers> things(NumberOfControlKinds);
  SurfaceNumbers numbers;
  for (int kind = 0; kind < NumberOfControlKinds; ++kind)
  {
    if (kind == Kinds::Edge)
    {
      keys[kind] =
        MakeEdgeKeys(control, keys[Kinds::Face], keys[Kinds::Line], things[Kinds::Vertex]);
    }
    things[kind] = NumberTogether(keys[kind], kind, lists, others);
  }
  std::vector<WholeIds> found = FindWholeIds(lists, things);
  numbers.Points = std::move(found[0]);
  numbers.Cells = std::move(found[1]);
  numbers.NumberOfControlPoints = things[Kinds::Vertex].Totals[0];
  return numbers;
}

SUBDIVISION_COMPILE_FUNCTION(MakeEdgeKeys);
SUBDIVISION_COMPILE_FUNCTION(FindTurnedOfPart);
template SurfaceNumbers NumberSurface(
  ControlKeys, const SurfaceLevel<int>&, const SurfaceSegments&, OtherPartitions&);
template SurfaceNumbers NumberSurface(
  ControlKeys, const SurfaceLevel<long long>&, const SurfaceSegments&, OtherPartitions&);

}
