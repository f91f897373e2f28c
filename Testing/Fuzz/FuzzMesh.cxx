// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzMesh.h"

#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace fuzz
{
namespace
{

constexpr const char* Names[] = { "None", "Singular", "Sharpness", "Material", "Values", "Level",
  "Part", "Rule", "Angle", "vtkOriginalPointIds", "vtkOriginalCellIds", "GlobalIds",
  "RedGreenLeaves", "Subdivision", "SubdivisionSurface", "OctahedronId", "GreenParent",
  "RefinementLevel", "RefinementKind", "vtkGhostType", "LimitNormals", "RuleDimension" };

constexpr double Odd[] = { std::numeric_limits<double>::quiet_NaN(),
  std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), 1e300, -1e300,
  1e-300, 4.9e-324, 1e18, 2147483648., 4294967296., -1., 0. };

double ChooseNumber(Bytes& bytes)
{
  return bytes.Chance(64) ? bytes.OneOf(Odd) : bytes.Number();
}

vtkSmartPointer<vtkPoints> MakePoints(Bytes& bytes, int size)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  constexpr int types[] = { VTK_DOUBLE, VTK_FLOAT };
  points->SetDataType(bytes.OneOf(types));
  for (int i = 0; i < size; ++i)
  {
    const double x = ChooseNumber(bytes);
    const double y = ChooseNumber(bytes);
    points->InsertNextPoint(x, y, ChooseNumber(bytes));
  }
  return points;
}

/// Mostly an id of a point.
vtkIdType ChooseId(Bytes& bytes, int points)
{
  if (points == 0 || bytes.Chance(128))
  {
    constexpr vtkIdType wrong[] = { -1, 1000000, std::numeric_limits<int>::max(),
      std::numeric_limits<vtkIdType>::max(), std::numeric_limits<vtkIdType>::min() };
    return bytes.Chance(3) ? points : bytes.OneOf(wrong);
  }
  return bytes.Choose(points);
}

void AddCells(Bytes& bytes, vtkUnstructuredGrid* grid)
{
  struct Type
  {
    int Number;
    int Corners; ///< -1: any number
  };
  constexpr Type types[] = { { VTK_TETRA, 4 }, { VTK_TRIANGLE, 3 }, { VTK_LINE, 2 },
    { VTK_VERTEX, 1 }, { VTK_TETRA, 4 }, { VTK_HEXAHEDRON, 8 }, { VTK_WEDGE, 6 },
    { VTK_PYRAMID, 5 }, { VTK_VOXEL, 8 }, { VTK_QUAD, 4 }, { VTK_PIXEL, 4 }, { VTK_POLYGON, -1 },
    { VTK_POLY_LINE, -1 }, { VTK_POLY_VERTEX, -1 }, { VTK_TRIANGLE_STRIP, -1 },
    { VTK_QUADRATIC_EDGE, 3 }, { VTK_QUADRATIC_TRIANGLE, 6 }, { VTK_QUADRATIC_TETRA, 10 },
    { VTK_PENTAGONAL_PRISM, 10 }, { VTK_HEXAGONAL_PRISM, 12 }, { VTK_QUADRATIC_QUAD, 8 },
    { VTK_LAGRANGE_TETRAHEDRON, -1 }, { VTK_EMPTY_CELL, 0 }, { VTK_CONVEX_POINT_SET, -1 },
    { VTK_TETRA, -1 }, { VTK_TRIANGLE, -1 } };
  const int points = static_cast<int>(grid->GetNumberOfPoints());
  const int cells = bytes.Choose(24);
  for (int cell = 0; cell < cells; ++cell)
  {
    const Type& type = bytes.OneOf(types);
    const int corners = type.Corners >= 0 ? type.Corners : bytes.Choose(9);
    vtkIdType ids[16];
    for (int i = 0; i < corners; ++i)
    {
      ids[i] = ChooseId(bytes, points);
    }
    grid->InsertNextCell(type.Number, corners, ids);
  }
}

/// A tetrahedron or a triangle at one more point for each byte: solids that share faces, which
/// random ids do not give.
void AddStrip(Bytes& bytes, vtkUnstructuredGrid* grid)
{
  const int points = static_cast<int>(grid->GetNumberOfPoints());
  const int corners = 1 + bytes.Choose(4);
  constexpr int types[] = { VTK_VERTEX, VTK_LINE, VTK_TRIANGLE, VTK_TETRA };
  for (vtkIdType first = 0; first + corners <= points; ++first)
  {
    vtkIdType ids[4] = { first, first + 1, first + 2, first + 3 };
    std::swap(ids[0], ids[bytes.Choose(corners)]);
    grid->InsertNextCell(types[corners - 1], corners, ids);
  }
}

void AddPolyhedron(Bytes& bytes, vtkUnstructuredGrid* grid)
{
  const int points = static_cast<int>(grid->GetNumberOfPoints());
  if (points < 4)
  {
    return;
  }
  // Faces of an octahedron, or of what the bytes say.
  constexpr vtkIdType octahedron[8][3] = { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 },
    { 2, 0, 5 }, { 1, 2, 5 }, { 3, 1, 5 }, { 0, 3, 5 } };
  const bool isOctahedron = points >= 6 && !bytes.Chance(3);
  const int faces = isOctahedron ? 8 : bytes.Choose(8);
  std::vector<vtkIdType> stream;
  for (int face = 0; face < faces; ++face)
  {
    const int corners = isOctahedron ? 3 : bytes.Choose(6);
    stream.push_back(corners);
    for (int i = 0; i < corners; ++i)
    {
      // VTK itself reads these ids when the cell is added.
      stream.push_back(isOctahedron ? octahedron[face][i] : bytes.Choose(points));
    }
  }
  grid->InsertNextCell(VTK_POLYHEDRON, faces, stream.data());
}

vtkSmartPointer<vtkAbstractArray> MakeArray(Bytes& bytes, vtkIdType wanted)
{
  constexpr int types[] = { VTK_DOUBLE, VTK_INT, VTK_FLOAT, VTK_UNSIGNED_CHAR, VTK_ID_TYPE,
    VTK_CHAR, VTK_UNSIGNED_LONG_LONG, VTK_BIT, VTK_STRING };
  const auto array =
    vtkSmartPointer<vtkAbstractArray>::Take(vtkAbstractArray::CreateArray(bytes.OneOf(types)));
  constexpr int components[] = { 1, 1, 1, 2, 3, 4, 9 };
  array->SetNumberOfComponents(bytes.OneOf(components));
  const vtkIdType size = bytes.Chance(16) ? bytes.Choose(40) : wanted;
  array->SetNumberOfTuples(size);
  if (auto* numbers = vtkDataArray::SafeDownCast(array))
  {
    const int kind = bytes.Choose(3); // small whole numbers, ids, or any
    for (vtkIdType i = 0; i < size; ++i)
    {
      for (int c = 0; c < numbers->GetNumberOfComponents(); ++c)
      {
        const double number = kind == 0 ? bytes.Choose(4)
          : kind == 1                   ? static_cast<double>(i)
                                        : ChooseNumber(bytes);
        const bool isReal =
          numbers->GetDataType() == VTK_DOUBLE || numbers->GetDataType() == VTK_FLOAT;
        const bool fits =
          number >= numbers->GetDataTypeMin() && number <= numbers->GetDataTypeMax();
        numbers->SetComponent(i, c, isReal || fits ? number : 1.); // else a cast has no meaning
      }
    }
  }
  return array;
}

void AddArrays(Bytes& bytes, vtkDataSet* data)
{
  const int arrays = bytes.Choose(6);
  for (int i = 0; i < arrays; ++i)
  {
    const bool atPoints = bytes.Choose(2) == 0;
    const char* name = ChooseArray(bytes);
    const auto array =
      MakeArray(bytes, atPoints ? data->GetNumberOfPoints() : data->GetNumberOfCells());
    array->SetName(name);
    vtkDataSetAttributes* attributes =
      atPoints ? static_cast<vtkDataSetAttributes*>(data->GetPointData()) : data->GetCellData();
    if (bytes.Chance(12))
    {
      data->GetFieldData()->AddArray(array);
      continue;
    }
    const int index = attributes->AddArray(array);
    if (bytes.Chance(4))
    {
      attributes->SetActiveAttribute(index, bytes.Choose(vtkDataSetAttributes::NUM_ATTRIBUTES));
    }
  }
}

vtkSmartPointer<vtkUnstructuredGrid> MakeGrid(Bytes& bytes)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(MakePoints(bytes, bytes.Choose(20)));
  switch (bytes.Choose(4))
  {
    case 0:
      AddStrip(bytes, grid);
      break;
    case 1:
      AddCells(bytes, grid);
      break;
    case 2:
      AddStrip(bytes, grid);
      AddCells(bytes, grid);
      break;
    default:
      AddPolyhedron(bytes, grid);
      AddStrip(bytes, grid);
  }
  return grid;
}

void AddPolygons(Bytes& bytes, int points, int least, vtkCellArray* cells)
{
  const int size = bytes.Choose(16);
  for (int cell = 0; cell < size; ++cell)
  {
    const int corners = bytes.Chance(16) ? bytes.Choose(3) : least + bytes.Choose(4);
    cells->InsertNextCell(corners);
    for (int i = 0; i < corners; ++i)
    {
      cells->InsertCellPoint(ChooseId(bytes, points));
    }
  }
}

vtkSmartPointer<vtkPolyData> MakeSurface(Bytes& bytes)
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  const int points = bytes.Choose(20);
  surface->SetPoints(MakePoints(bytes, points));
  const int kind = bytes.Choose(4);
  vtkNew<vtkCellArray> polygons;
  if (kind == 0) // a fan, closed or open
  {
    const int last = points - 1;
    for (int i = 1; i < last; ++i)
    {
      const vtkIdType ids[3] = { 0, i, i + 1 };
      polygons->InsertNextCell(3, ids);
    }
    if (bytes.Choose(2) == 0 && last > 2)
    {
      const vtkIdType ids[3] = { 0, last, 1 };
      polygons->InsertNextCell(3, ids);
    }
  }
  else
  {
    AddPolygons(bytes, points, 3, polygons);
  }
  surface->SetPolys(polygons);
  if (bytes.Chance(3))
  {
    vtkNew<vtkCellArray> lines;
    AddPolygons(bytes, points, 2, lines);
    surface->SetLines(lines);
  }
  if (bytes.Chance(4))
  {
    vtkNew<vtkCellArray> vertices;
    AddPolygons(bytes, points, 1, vertices);
    surface->SetVerts(vertices);
  }
  if (bytes.Chance(6))
  {
    vtkNew<vtkCellArray> strips;
    AddPolygons(bytes, points, 3, strips);
    surface->SetStrips(strips);
  }
  return surface;
}

vtkSmartPointer<vtkImageData> MakeImage(Bytes& bytes)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  const int x = bytes.Choose(5);
  const int y = bytes.Choose(5);
  image->SetDimensions(x, y, bytes.Choose(5));
  constexpr double spacings[] = { 1., 0.1, 1e-300, 1e300, 0., -1. };
  if (bytes.Chance(4))
  {
    image->SetSpacing(bytes.OneOf(spacings), 1., 1.);
  }
  return image;
}

vtkSmartPointer<vtkDataSet> MakeSet(Bytes& bytes)
{
  vtkSmartPointer<vtkDataSet> data;
  switch (bytes.Choose(5))
  {
    case 0:
    case 1:
      data = MakeGrid(bytes);
      break;
    case 2:
    case 3:
      data = MakeSurface(bytes);
      break;
    default:
      data = MakeImage(bytes);
  }
  AddArrays(bytes, data);
  return data;
}

}

const char* ChooseArray(Bytes& bytes)
{
  return bytes.OneOf(Names);
}

vtkSmartPointer<vtkDataObject> MakeData(Bytes& bytes)
{
  if (!bytes.Chance(8))
  {
    return MakeSet(bytes);
  }
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  const int size = bytes.Choose(4);
  for (int i = 0; i < size; ++i)
  {
    blocks->SetBlock(static_cast<unsigned>(i), bytes.Chance(8) ? nullptr : MakeSet(bytes).Get());
  }
  return blocks;
}

}
