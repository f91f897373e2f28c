// SPDX-License-Identifier: BSD-3-Clause
#include "GapMeshes.h"

#include "BenchmarkMeshes.h"

#include "vtkSurfaceSubdivision.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace benchmarks
{

int Scaled(int n, double scale, double dimension)
{
  return std::max(1, static_cast<int>(std::lround(n * std::pow(scale, 1. / dimension))));
}

Mesh MakeSolid(int n, double scale)
{
  return ToVtk(MakeCube(Scaled(n, scale)));
}

Mesh MakeLayers(int n, double scale)
{
  const Mesh mesh = MakeSolid(n, scale);
  vtkNew<vtkIntArray> materials;
  materials->SetName("MaterialId");
  materials->SetNumberOfTuples(mesh->GetNumberOfCells());
  const vtkIdType layer = mesh->GetNumberOfCells() / 4 + 1;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    materials->SetValue(i, static_cast<int>(i / layer % 2));
  }
  mesh->GetCellData()->AddArray(materials);
  return mesh;
}

vtkSmartPointer<vtkImageData> MakeImage(int n, double scale)
{
  const int cells = Scaled(n, scale);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(cells + 1, cells + 1, cells + 1);
  image->SetSpacing(1. / cells, 1. / cells, 1. / cells);
  return image;
}

Mesh MakeHexahedra(int n, double scale)
{
  const auto image = MakeImage(n, scale);
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    points->InsertNextPoint(image->GetPoint(i));
  }
  grid->SetPoints(points);
  grid->Allocate(image->GetNumberOfCells());
  vtkNew<vtkIdList> voxel;
  for (vtkIdType i = 0; i < image->GetNumberOfCells(); ++i)
  {
    image->GetCellPoints(i, voxel);
    vtkIdType* const ids = voxel->GetPointer(0);
    std::swap(ids[2], ids[3]);
    std::swap(ids[6], ids[7]);
    grid->InsertNextCell(VTK_HEXAHEDRON, 8, ids);
  }
  return grid;
}

Mesh MakeQuadratic(int n, double scale)
{
  const FlatMesh cube = MakeCube(Scaled(n, scale));
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  grid->Allocate(cube.GetNumberOfCells());
  constexpr int edges[6][2] = { { 0, 1 }, { 1, 2 }, { 0, 2 }, { 0, 3 }, { 1, 3 }, { 2, 3 } };
  for (int c = 0; c < cube.GetNumberOfCells(); ++c)
  {
    std::array<double, 3> corners[4];
    std::array<vtkIdType, 10> ids;
    for (int i = 0; i < 4; ++i)
    {
      std::copy_n(cube.Points.data() + 3 * cube.Cells[4 * c + i], 3, corners[i].data());
      ids[i] = points->InsertNextPoint(corners[i].data());
    }
    for (int e = 0; e < 6; ++e)
    {
      const auto& a = corners[edges[e][0]];
      const auto& b = corners[edges[e][1]];
      ids[4 + e] = points->InsertNextPoint((a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2);
    }
    grid->InsertNextCell(VTK_QUADRATIC_TETRA, 10, ids.data());
  }
  grid->SetPoints(points);
  return grid;
}

Mesh MakeSurface(bool ofTriangles, int levels, double scale)
{
  vtkNew<vtkSurfaceSubdivision> filter;
  filter->SetInputData(ofTriangles ? ToVtk(MakeSphere(5)) : ToVtk(MakeQuadSphere(58)));
  filter->SetScheme(
    ofTriangles ? vtkSurfaceSubdivision::LOOP : vtkSurfaceSubdivision::CATMULL_CLARK);
  filter->SetNumberOfLevels(
    std::max(0, levels + static_cast<int>(std::lround(std::log(scale) / std::log(4.)))));
  filter->Update();
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->ShallowCopy(filter->GetOutput());
  mesh->GetFieldData()->Initialize(); // without the stamp
  return mesh;
}

Mesh MakeMoved(vtkPointSet* mesh, double x)
{
  auto moved = Mesh::Take(mesh->NewInstance());
  moved->DeepCopy(mesh);
  for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
  {
    double at[3];
    moved->GetPoint(i, at);
    moved->GetPoints()->SetPoint(i, at[0] + x, at[1], at[2]);
  }
  return moved;
}

vtkSmartPointer<vtkDataObject> MakeBlocks(vtkPointSet* mesh)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetBlock(0, mesh);
  blocks->SetBlock(1, MakeMoved(mesh, 1.));
  return blocks;
}

Mesh MakeCloud(int n, double scale)
{
  const auto image = MakeImage(n, scale);
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* x = image->GetPoint(i);
    points->InsertNextPoint(0.2 + 0.6 * x[0], 0.2 + 0.6 * x[1], 0.2 + 0.6 * x[2]);
  }
  cloud->SetPoints(points);
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("Vectors");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(points->GetNumberOfPoints());
  vectors->FillValue(1.);
  cloud->GetPointData()->SetVectors(vectors);
  return cloud;
}

vtkSmartPointer<vtkImageData> MakeLabels(int n, double scale)
{
  const auto image = MakeImage(n, scale);
  image->AllocateScalars(VTK_INT, 1);
  auto* labels = vtkIntArray::SafeDownCast(image->GetPointData()->GetScalars());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* x = image->GetPoint(i);
    const double r = std::hypot(x[0] - 0.5, x[1] - 0.5, x[2] - 0.5);
    labels->SetValue(i, r < 0.3 ? 2 : r < 0.48 ? 1 : 0);
  }
  labels->SetName("Label");
  return image;
}

vtkSmartPointer<vtkSphere> MakeBall(double centre, double radius)
{
  auto ball = vtkSmartPointer<vtkSphere>::New();
  ball->SetCenter(centre, centre, centre);
  ball->SetRadius(radius);
  return ball;
}

}
