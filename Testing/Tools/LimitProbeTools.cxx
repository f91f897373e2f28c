// SPDX-License-Identifier: BSD-3-Clause
#include "LimitProbeTools.h"

#include "vtkSubdivisionModelSource.h"

#include <algorithm>

namespace limit_probe_tools
{

Grid MakeModel(int model)
{
  vtkNew<vtkSubdivisionModelSource> source;
  source->SetModel(model);
  source->Update();
  const auto grid = DeepCopy(vtkUnstructuredGrid::SafeDownCast(source->GetOutput()));
  grid->GetPointData()->AddArray(
    MakeArray<vtkDoubleArray>("Random", 1, grid->GetNumberOfPoints(), -1., 1., 7));
  return grid;
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
