// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Surface/SurfaceCells.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Reading/CellChecks.h"
#include "Private/Reading/CellsToSimplices.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTypeInt32Array.h"

#include <algorithm>
#include <type_traits>

namespace subdivision
{
namespace
{

void AddFace(SurfaceCells& cells, vtkIdType cell, const vtkIdType* ids, vtkIdType size)
{
  cells.Corners.insert(cells.Corners.end(), ids, ids + size);
  cells.FaceOffsets.push_back(static_cast<vtkIdType>(cells.Corners.size()));
  cells.FaceCells.push_back(cell);
}

void AddSegment(SurfaceCells& cells, vtkIdType cell, vtkIdType a, vtkIdType b)
{
  cells.Segments.insert(cells.Segments.end(), { a, b });
  cells.SegmentCells.push_back(cell);
}

void AddVertex(SurfaceCells& cells, vtkIdType cell, vtkIdType point)
{
  cells.Vertices.push_back(point);
  cells.VertexCells.push_back(cell);
}

bool AreTriangles(const SimplexList& simplices)
{
  const std::vector<unsigned char>& dimensions = simplices.Dimensions;
  for (const unsigned char dimension : InTurn(dimensions))
  {
    if (dimension != 2)
    {
      return false;
    }
  }
  return true;
}

/// Takes the triangles of all cells.
void TakeTriangles(SimplexList& triangles, SurfaceCells& cells)
{
  const vtkIdType size = triangles.GetNumberOfSimplices();
  cells.Corners = std::move(triangles.Connectivity);
  cells.FaceOffsets.resize(static_cast<std::size_t>(size) + 1);
  cells.FaceCells.resize(static_cast<std::size_t>(size));
  ForEach(size + 1, [&](vtkIdType i) { cells.FaceOffsets[i] = 3 * i; });
  ForEach(size, [&](vtkIdType i) { cells.FaceCells[i] = i; });
}

SurfaceCells ReadSimplices(vtkPolyData* input, const vtkIdType* globalIds)
{
  SimplicesOfCells simplices = CellsToSimplices(input, globalIds);
  SurfaceCells cells;
  cells.NumberOfPoints = simplices.Simplices.NumberOfPoints;
  cells.Warnings = simplices.Warnings;
  const std::size_t size = simplices.Simplices.Dimensions.size();
  if (simplices.ParentCells.empty() && AreTriangles(simplices.Simplices))
  {
    TakeTriangles(simplices.Simplices, cells);
    return cells;
  }
  cells.Corners.reserve(simplices.Simplices.Connectivity.size());
  cells.FaceOffsets.reserve(size + 1);
  cells.FaceCells.reserve(size);
  const vtkIdType* ids = simplices.Simplices.Connectivity.data();
  for (const vtkIdType i : InTurn(simplices.Simplices.GetNumberOfSimplices()))
  {
    const vtkIdType cell = simplices.ParentCells.empty() ? i : simplices.ParentCells[i];
    const int dimension = simplices.Simplices.Dimensions[i];
    switch (dimension)
    {
      case 0:
        AddVertex(cells, cell, ids[0]);
        break;
      case 1:
        AddSegment(cells, cell, ids[0], ids[1]);
        break;
      default:
        AddFace(cells, cell, ids, 3);
        break;
    }
    ids += dimension + 1;
  }
  return cells;
}

/// Removes points that repeat the one before them in the loop.
void RemoveRepeated(std::vector<vtkIdType>& loop)
{
  loop.erase(std::unique(loop.begin(), loop.end()), loop.end());
  while (loop.size() > 1 && loop.front() == loop.back())
  {
    loop.pop_back();
  }
}

bool HasRepeated(std::vector<vtkIdType> loop)
{
  std::sort(loop.begin(), loop.end());
  return std::adjacent_find(loop.begin(), loop.end()) != loop.end();
}

SurfaceCells ReadPolygons(vtkPolyData* input)
{
  const CellReader reader(input);
  const CheckedCells checked = CheckCells(input, reader);
  SurfaceCells cells;
  cells.NumberOfPoints = input->GetNumberOfPoints();
  cells.Warnings = DescribePassedOver(reader, checked);
  const auto faces = static_cast<std::size_t>(input->GetNumberOfPolys());
  cells.Corners.reserve(static_cast<std::size_t>(input->GetPolys()->GetNumberOfConnectivityIds()));
  cells.FaceOffsets.reserve(faces + 1);
  cells.FaceCells.reserve(faces);
  vtkIdType crossing = 0;
  vtkIdType first = -1;
  std::vector<vtkIdType> scratch;
  std::vector<vtkIdType> loop;
  for (const vtkIdType cell : InTurn(reader.GetNumberOfCells()))
  {
    if (!TakesPart(checked.States[cell]))
    {
      continue;
    }
    const CellIds ids = reader.GetCell(cell, scratch);
    switch (reader.GetCellType(cell))
    {
      case VTK_POLY_VERTEX:
      case VTK_VERTEX:
        std::for_each(
          ids.Ids, ids.Ids + ids.Size, [&](vtkIdType id) { AddVertex(cells, cell, id); });
        break;
      case VTK_POLY_LINE:
      case VTK_LINE:
        for (vtkIdType i = 0; i + 1 < ids.Size; ++i)
        {
          if (ids.Ids[i] != ids.Ids[i + 1])
          {
            AddSegment(cells, cell, ids.Ids[i], ids.Ids[i + 1]);
          }
        }
        break;
      case VTK_TRIANGLE_STRIP:
        for (vtkIdType i = 0; i + 2 < ids.Size; ++i)
        {
          const vtkIdType triangle[3] = { ids.Ids[i + i % 2], ids.Ids[i + 1 - i % 2],
            ids.Ids[i + 2] };
          if (triangle[0] != triangle[1] && triangle[1] != triangle[2] &&
            triangle[2] != triangle[0])
          {
            AddFace(cells, cell, triangle, 3);
          }
        }
        break;
      default:
        if (checked.States[cell] == CellState::Good)
        {
          AddFace(cells, cell, ids.Ids, ids.Size);
          break;
        }
        loop.assign(ids.Ids, ids.Ids + ids.Size);
        RemoveRepeated(loop);
        if (loop.size() < 3 || HasRepeated(loop))
        {
          first = crossing++ == 0 ? cell : first;
          break;
        }
        AddFace(cells, cell, loop.data(), static_cast<vtkIdType>(loop.size()));
        break;
    }
  }
  if (crossing > 0)
  {
    cells.Warnings.push_back(std::to_string(crossing) +
      " polygon(s) pass through a point twice, and the filter leaves them out. The first is cell " +
      std::to_string(first) +
      ". Split them where they touch themselves, or cut them by vtkTriangleFilter first.");
  }
  return cells;
}

/// Makes a vtkCellArray with the offsets getOffset(i); `fill` writes its connectivity.
template <typename Array, typename GetOffset, typename Fill>
vtkSmartPointer<vtkCellArray> MakeCells(
  vtkIdType cells, vtkIdType entries, const GetOffset& getOffset, const Fill& fill)
{
  vtkNew<Array> offsets;
  vtkNew<Array> ids;
  Allocate(offsets, 1, cells + 1);
  Allocate(ids, 1, entries);
  using Value = typename Array::ValueType;
  Value* offset = offsets->GetPointer(0);
  ForEach(cells + 1, [&](vtkIdType i) { offset[i] = static_cast<Value>(getOffset(i)); });
  fill(ids->GetPointer(0));
  auto array = vtkSmartPointer<vtkCellArray>::New();
  array->SetData(offsets, ids);
  return array;
}

/// `writeFaces(ids)`: the vertices of all faces.
template <typename Array, typename Id, typename WriteFaces>
void WriteCells(const SurfaceLevel<Id>& level, vtkIdType corners,
  const std::vector<vtkIdType>& vertices, const WriteFaces& writeFaces, vtkPolyData* output)
{
  using Value = typename Array::ValueType;
  const PolygonMesh<Id>& mesh = level.Mesh;
  const vtkIdType points = static_cast<vtkIdType>(vertices.size());
  output->SetVerts(MakeCells<Array>(
    points, points, [](vtkIdType i) { return i; },
    [&](Value* ids)
    {
      for (vtkIdType i = 0; i < points; ++i)
      {
        ids[i] = static_cast<Value>(level.Points.empty() ? vertices[i] : level.Points[i]);
      }
    }));
  const vtkIdType lines = level.Lines.size();
  output->SetLines(MakeCells<Array>(
    lines, 2 * lines, [](vtkIdType i) { return 2 * i; },
    [&](Value* ids)
    {
      ForEach(2 * lines,
        [&](vtkIdType i)
        {
          const Id line = level.Lines[i / 2];
          ids[i] = static_cast<Value>(mesh.EdgeVertices[2 * (line / 2) + (line % 2 + i % 2) % 2]);
        });
    }));
  output->SetPolys(mesh.Arity
      ? MakeCells<Array>(
          mesh.NumberOfFaces, corners, [&](vtkIdType i) { return mesh.Arity * i; }, writeFaces)
      : MakeCells<Array>(
          mesh.NumberOfFaces, corners, [&](vtkIdType i) { return mesh.GetFirstOfCounted(i); },
          writeFaces));
}

template <typename Id, typename WriteFaces>
void WriteCells(const SurfaceLevel<Id>& level, vtkIdType corners,
  const std::vector<vtkIdType>& vertices, bool use32BitIds, const WriteFaces& writeFaces,
  vtkPolyData* output)
{
  const bool small =
    use32BitIds && std::max<vtkIdType>(corners, level.Mesh.NumberOfVertices) < LargestSmallId;
  if (small)
  {
    WriteCells<vtkTypeInt32Array>(level, corners, vertices, writeFaces, output);
  }
  else
  {
    WriteCells<vtkIdTypeArray>(level, corners, vertices, writeFaces, output);
  }
}

}

SurfaceCells ReadSurfaceCells(vtkPolyData* input, bool triangles, const vtkIdType* globalIds)
{
  return triangles ? ReadSimplices(input, globalIds) : ReadPolygons(input);
}

template <typename Id>
SurfaceLevel<Id> MakeControlLevel(const SurfaceCells& cells)
{
  auto copy = [](const std::vector<vtkIdType>& from)
  {
    Buffer<Id> to(static_cast<vtkIdType>(from.size()));
    ForEach(to.size(), [&](vtkIdType i) { to[i] = static_cast<Id>(from[i]); });
    return to;
  };
  PolygonList<Id> list;
  list.NumberOfVertices = cells.NumberOfPoints;
  list.FaceOffsets = copy(cells.FaceOffsets);
  list.Vertices = copy(cells.Corners);
  list.Segments = copy(cells.Segments);
  SurfaceLevel<Id> level;
  level.Mesh = BuildPolygonMesh(std::move(list), level.Lines);
  level.Points = copy(cells.Vertices);
  return level;
}

template <typename Id>
void WriteSurfaceCells(const SurfaceSteps<Id>& steps, const std::vector<vtkIdType>& vertices,
  bool use32BitIds, vtkPolyData* output)
{
  const int last = steps.GetNumberOfSteps();
  WriteCells(
    steps.GetLevel(last), steps.GetNumberOfCorners(last), vertices, use32BitIds,
    [&](auto* ids) { steps.WriteFaces(last, ids); }, output);
}

template <typename Id>
void WriteSurfaceCells(const SurfaceLevel<Id>& level, const std::vector<vtkIdType>& vertices,
  bool use32BitIds, vtkPolyData* output)
{
  const Buffer<Id>& corners = level.Mesh.Vertices;
  WriteCells(
    level, corners.size(), vertices, use32BitIds,
    [&](auto* ids)
    {
      using Value = std::remove_reference_t<decltype(*ids)>;
      ForEach(corners.size(), [&](vtkIdType c) { ids[c] = static_cast<Value>(corners[c]); });
    },
    output);
}

SUBDIVISION_COMPILE_FUNCTION(MakeControlLevel);
template void WriteSurfaceCells(
  const SurfaceLevel<int>&, const std::vector<vtkIdType>&, bool, vtkPolyData*);
template void WriteSurfaceCells(
  const SurfaceLevel<long long>&, const std::vector<vtkIdType>&, bool, vtkPolyData*);
template void WriteSurfaceCells(
  const SurfaceSteps<int>&, const std::vector<vtkIdType>&, bool, vtkPolyData*);
template void WriteSurfaceCells(
  const SurfaceSteps<long long>&, const std::vector<vtkIdType>&, bool, vtkPolyData*);

}
