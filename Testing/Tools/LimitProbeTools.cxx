// SPDX-License-Identifier: BSD-3-Clause
#include "LimitProbeTools.h"

#include "vtkSubdivisionModelSource.h"

namespace limit_probe_tools
{

Grid MakeModel(int model)
{
  const Grid grid = LoadModel(model);
  grid->GetPointData()->AddArray(
    MakeArray<vtkDoubleArray>("Random", 1, grid->GetNumberOfPoints(), -1., 1., 7));
  return grid;
}

Grid MakeWavySurface(double shift, double height)
{
  std::vector<Point> points;
  std::vector<Cell> cells;
  for (int i = 0; i < 36; ++i)
  {
    points.push_back({ i % 6 + shift * std::sin(3. * i), i / 6 + shift * std::sin(5. * i + 1.),
      height * std::sin(0.7 * i) });
  }
  for (vtkIdType i = 0; i < 29; ++i)
  {
    if (i % 6 < 5)
    {
      const bool turned = i % 4 == 1;
      cells.push_back({ VTK_TRIANGLE, { i, i + 1, turned ? i + 6 : i + 7 } });
      cells.push_back({ VTK_TRIANGLE, { turned ? i + 1 : i, i + 7, i + 6 } });
    }
  }
  return MakeGrid(points, cells);
}

std::vector<double> FindDistances(vtkPointSet* mesh, const std::vector<Point>& targets)
{
  std::vector<double> distances;
  for (const Point& target : targets)
  {
    double least = VTK_DOUBLE_MAX;
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      const Point p = GetPoint(mesh, i);
      least = std::min(least, std::hypot(p[0] - target[0], p[1] - target[1], p[2] - target[2]));
    }
    distances.push_back(least);
  }
  return distances;
}

}
