// SPDX-License-Identifier: BSD-3-Clause
#include "HybridFilterTools.h"

#include "vtkDoubleArray.h"

#include <random>

namespace hybrid_filter_tools
{

Grid MakeAllTypes(unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> move(-.1, .1);
  std::vector<Point> points{ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 }, { 2, 0, 0 }, { 2, 0, 1 }, { .5, .5, 2 }, { -1, 0, 0 },
    { -1, 1, 0 }, { -2, 0, 0 } };
  for (Point& point : points)
  {
    for (double& x : point)
    {
      x += move(random);
    }
  }
  const Grid grid = MakeGrid(points,
    { { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } }, { VTK_WEDGE, { 1, 2, 8, 5, 6, 9 } },
      { VTK_PYRAMID, { 4, 5, 6, 7, 10 } }, { VTK_TETRA, { 5, 9, 6, 10 } },
      { VTK_QUAD, { 0, 3, 12, 11 } }, { VTK_TRIANGLE, { 11, 12, 13 } }, { VTK_LINE, { 13, 10 } },
      { VTK_VERTEX, { 13 } }, { VTK_LINE, { 0, 1 } }, { VTK_QUAD, { 1, 2, 6, 5 } },
      { VTK_TRIANGLE, { 5, 6, 10 } }, { VTK_LINE, { 6, 7 } } });
  AddArrays(grid);
  return grid;
}

void AddSharpness(vtkUnstructuredGrid* grid, const std::map<vtkIdType, double>& values)
{
  vtkNew<vtkDoubleArray> sharpness;
  sharpness->SetName("Sharpness");
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    const auto found = values.find(c);
    sharpness->InsertNextValue(found == values.end() ? 0. : found->second);
  }
  grid->GetCellData()->AddArray(sharpness);
}

void ExpectSame(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b, double tolerance)
{
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  ASSERT_EQ(a->GetNumberOfCells(), b->GetNumberOfCells());
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      ASSERT_NEAR(GetPoint(a, i)[c], GetPoint(b, i)[c], tolerance) << "point " << i;
    }
  }
  for (vtkIdType i = 0; i < a->GetNumberOfCells(); ++i)
  {
    ASSERT_EQ(a->GetCellType(i), b->GetCellType(i)) << "cell " << i;
    for (vtkIdType k = 0; k < a->GetCell(i)->GetNumberOfPoints(); ++k)
    {
      ASSERT_EQ(a->GetCell(i)->GetPointId(k), b->GetCell(i)->GetPointId(k)) << "cell " << i;
    }
  }
  for (const int type : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    vtkDataSetAttributes* data = a->GetAttributes(type);
    ASSERT_EQ(data->GetNumberOfArrays(), b->GetAttributes(type)->GetNumberOfArrays());
    for (int k = 0; k < data->GetNumberOfArrays(); ++k)
    {
      vtkDataArray* own = data->GetArray(k);
      vtkDataArray* other = own ? b->GetAttributes(type)->GetArray(own->GetName()) : nullptr;
      for (vtkIdType i = 0; own && i < own->GetNumberOfTuples(); ++i)
      {
        ASSERT_NE(other, nullptr) << own->GetName();
        for (int c = 0; c < own->GetNumberOfComponents(); ++c)
        {
          ASSERT_NEAR(own->GetComponent(i, c), other->GetComponent(i, c), 1e-12)
            << own->GetName() << " " << i;
        }
      }
    }
  }
}

vtkSmartPointer<vtkPolyData> SubdivideQuads(vtkUnstructuredGrid* quads, int levels,
  const std::function<void(vtkSurfaceSubdivision*)>& configure)
{
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(quads->GetPoints());
  surface->SetPolys(quads->GetCells());
  vtkNew<vtkSurfaceSubdivision> subdivide;
  subdivide->SetInputData(surface);
  subdivide->SetSchemeToCatmullClark();
  subdivide->SetNumberOfLevels(levels);
  configure ? configure(subdivide) : void();
  subdivide->Update();
  return subdivide->GetOutput();
}

}
