// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkShape.h"

#include "BenchmarkFilter.h"
#include "BenchmarkTools.h"

#include "vtkSubdivisionModelSource.h"

#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <string>

namespace benchmarks
{
namespace
{

struct ShapeCase
{
  std::string Name;
  int Model;
  /// A criterion: a part of the diagonal, or an angle in degrees; 0: not this one.
  double Tolerance;
  double Angle;
  int UniformLevels; ///< that are as exact, or as fine where cells are smallest
};

const ShapeCase Cases[] = {
  { "screw", vtkSubdivisionModelSource::SCREW, 0.00057, 0., 4 },
  { "screw-angle", vtkSubdivisionModelSource::SCREW, 0., 6., 5 },
  { "plate-angle", vtkSubdivisionModelSource::MECHANICAL_PART, 0., 4., 4 },
};

vtkSmartPointer<vtkUnstructuredGrid> MakeModel(int model)
{
  vtkNew<vtkSubdivisionModelSource> source;
  source->SetModel(model);
  source->Update();
  return source->GetOutput();
}

template <typename Filter>
Produced Run(Stopwatch& watch, Filter* filter)
{
  watch.Time([&]() { filter->Update(); });
  const OutputSize size = MeasureOutput(filter->GetOutput());
  return { size.Cells, size.Bytes };
}

Produced RunUniform(Stopwatch& watch, const ShapeCase& which)
{
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  filter->SetInputData(MakeModel(which.Model));
  filter->SetNumberOfLevels(which.UniformLevels);
  filter->ProjectToLimitOn();
  return Run(watch, filter.Get());
}

void RegisterShapes()
{
  for (const ShapeCase& which : Cases)
  {
    for (const int threads : ThreadCounts)
    {
      const std::string name = which.Name + "/levels:" + std::to_string(which.UniformLevels);
      Register("shape/adaptive/" + name, threads,
        [&which](Stopwatch& watch) { return Run(watch, MakeShapeFilter(which.Name).Get()); });
      Register("shape/uniform/" + name, threads,
        [&which](Stopwatch& watch) { return RunUniform(watch, which); });
    }
  }
}

const Registration Registered(RegisterShapes);

}

vtkSmartPointer<vtkRedGreenRefinement> MakeShapeFilter(const std::string& name)
{
  for (const ShapeCase& which : Cases)
  {
    if (which.Name == name)
    {
      auto filter = vtkSmartPointer<vtkRedGreenRefinement>::New();
      filter->SetInputData(MakeModel(which.Model));
      filter->RefineByAttributeErrorOff();
      filter->SetPlacementToLimit();
      filter->SetMaximumLevel(8);
      filter->SetRefineByGeometricError(which.Tolerance > 0.);
      filter->SetGeometricTolerance(which.Tolerance);
      filter->SetRefineByCurvature(which.Angle > 0.);
      filter->SetMaximumAngle(which.Angle);
      return filter;
    }
  }
  return nullptr;
}

}
