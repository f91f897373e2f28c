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
  int Model; ///< -1: the name is that of a file
  /// A criterion: a part of the diagonal, or an angle in degrees; 0: not this one.
  double Tolerance;
  double Angle;
  int UniformLevels; ///< that are as exact, or as fine where cells are smallest; 0: not compared
  bool IsQuick;
};

const ShapeCase Cases[] = {
  { "screw", vtkSubdivisionModelSource::SCREW, 0.00057, 0., 4, true },
  { "screw-angle", vtkSubdivisionModelSource::SCREW, 0., 6., 5, true },
  { "plate-angle", vtkSubdivisionModelSource::MECHANICAL_PART, 0., 4., 4, true },
  { "nm_ogs5_fracture_surfaces.vtu", -1, 0., 10., 0, true },
  { "surf_bunny_3k.vtp", -1, 0., 10., 0, true },
  { "tet_gmsh_coil_crack.vtu", -1, 0., 10., 0, true },
  { "mix_elmer_shell_on_solid.vtu", -1, 0., 10., 0, false },
  { "mix_ogs5_fracture_network.vtu", -1, 0., 10., 0, false },
};

vtkSmartPointer<vtkPointSet> MakeInput(const ShapeCase& which)
{
  if (which.Model < 0)
  {
    return ReadFile(GetDataFolder() + "/" + which.Name);
  }
  vtkNew<vtkSubdivisionModelSource> source;
  source->SetModel(which.Model);
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
  filter->SetInputData(MakeInput(which));
  filter->SetNumberOfLevels(which.UniformLevels);
  filter->ProjectToLimitOn();
  filter->SmoothShadingOff();
  return Run(watch, filter.Get());
}

void RegisterShapes()
{
  for (const ShapeCase& which : Cases)
  {
    if ((IsQuick() && !which.IsQuick) || (which.Model < 0 && !MakeInput(which)))
    {
      continue;
    }
    // Refining a file takes seconds.
    const int repetitions = which.Model < 0 ? 1 : 0;
    for (const int threads : ThreadCounts)
    {
      const std::string name = which.Name + "/levels:" + std::to_string(which.UniformLevels);
      Register(
        "shape/adaptive/" + name, threads, [&which](Stopwatch& watch)
        { return Run(watch, MakeShapeFilter(which.Name).Get()); }, repetitions);
      if (which.UniformLevels > 0)
      {
        Register("shape/uniform/" + name, threads,
          [&which](Stopwatch& watch) { return RunUniform(watch, which); });
      }
    }
  }
}

const Registration Registered(RegisterShapes);

}

vtkSmartPointer<vtkRedGreenRefinement> MakeShapeFilter(const std::string& name)
{
  for (const ShapeCase& which : Cases)
  {
    const auto input = which.Name == name ? MakeInput(which) : nullptr;
    if (input)
    {
      auto filter = vtkSmartPointer<vtkRedGreenRefinement>::New();
      filter->SetInputData(input);
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
