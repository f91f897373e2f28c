// SPDX-License-Identifier: BSD-3-Clause
#include "SubdivisionDeformationTools.h"

#include "vtkPointSet.h"

namespace deformation_tools
{

Grid MakeCloud(int size, Point low, Point high, unsigned seed, int type)
{
  std::mt19937 random(seed);
  std::vector<Point> points(size);
  std::vector<Cell> cells;
  for (int i = 0; i < size; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      points[i][c] = low[c] + (high[c] - low[c]) * (random() / 4294967296.);
    }
    cells.push_back({ VTK_VERTEX, { i } });
  }
  return MakeGrid(points, cells, type);
}

vtkSmartPointer<vtkPoints> MovePoints(vtkPointSet* mesh, const Map& map)
{
  const auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    points->InsertNextPoint(map(GetPoint(mesh, i)).data());
  }
  return points;
}

Grid Moved(vtkUnstructuredGrid* mesh, const Map& map)
{
  const Grid moved = DeepCopy(mesh);
  moved->SetPoints(MovePoints(mesh, map));
  return moved;
}

vtkSmartPointer<vtkPointSet> Deformer::Run(
  vtkDataObject* input, vtkDataObject* rest, vtkDataObject* deformed)
{
  this->Filter->SetInputData(input);
  this->Filter->SetRestMeshData(rest);
  this->Filter->SetDeformedMeshData(deformed);
  this->Filter->Modified();
  this->Filter->Update();
  vtkPointSet* output = this->Filter->GetOutput();
  if (!output)
  {
    return nullptr;
  }
  auto copy = vtkSmartPointer<vtkPointSet>::Take(output->NewInstance());
  copy->ShallowCopy(output);
  return copy;
}

double GetLargestError(vtkPointSet* result, vtkPointSet* input, const Map& map)
{
  EXPECT_EQ(result->GetNumberOfPoints(), input->GetNumberOfPoints());
  double largest = 0.;
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    const Point found = GetPoint(result, i);
    const Point wanted = map(GetPoint(input, i));
    for (int c = 0; c < 3; ++c)
    {
      const double error = std::abs(found[c] - wanted[c]);
      largest = error <= largest ? largest : error; // NaN counts
    }
  }
  return largest;
}

}
