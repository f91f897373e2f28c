// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchmarkFilter.cxx
 * The whole filter: first execution, execution with another scalar, larger and larger levels.
 */
#include "BenchmarkFilter.h"

#include "BenchmarkMeshes.h"
#include "BenchmarkTools.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkUnstructuredGrid.h"

#include "vtksys/SystemInformation.hxx"

namespace benchmarks
{
namespace
{

Produced Tell(const OutputSize& size)
{
  return { size.Cells, size.Bytes };
}

Produced RunOnce(Stopwatch& watch, const Case& which, int levels, bool cache)
{
  const auto filter = MakeFilter(which, levels, cache);
  watch.Time([&]() { filter->Update(); });
  return Tell(MeasureOutput(filter->GetOutput()));
}

/// The other scheme for solids, on the same mesh.
Produced RunTetOct(Stopwatch& watch, const Case& which, int levels)
{
  const auto filter = MakeFilter(which, levels, false);
  filter->SetVolumeSchemeToTetOct();
  watch.Time([&]() { filter->Update(); });
  return Tell(MeasureOutput(filter->GetOutput()));
}

/// Execution with the same cells, points and options, and another scalar.
Produced RunAgain(Stopwatch& watch, const Case& which, int levels)
{
  const auto filter = MakeFilter(which, levels, true);
  vtkSmartPointer<vtkPointSet> input;
  input.TakeReference(GetInput(which)->NewInstance());
  input->ShallowCopy(GetInput(which));
  filter->SetInputData(input);
  filter->Update();
  vtkDataArray* old = GetInput(which)->GetPointData()->GetScalars();
  vtkNew<vtkDoubleArray> scalar;
  scalar->SetName(old->GetName());
  scalar->SetNumberOfTuples(old->GetNumberOfTuples());
  for (vtkIdType i = 0; i < old->GetNumberOfTuples(); ++i)
  {
    scalar->SetValue(i, 1. - old->GetComponent(i, 0));
  }
  input->GetPointData()->SetScalars(scalar);
  watch.Time([&]() { filter->Update(); });
  return Tell(MeasureOutput(filter->GetOutput()));
}

/// Levels above the standard ones whose output, three times, fits into half of the free memory.
int GetLargestLevel(const Case& which, int growth)
{
  vtksys::SystemInformation system;
  const double available = 1024. *
    (static_cast<double>(system.GetHostMemoryAvailable()) -
      static_cast<double>(system.GetHostMemoryUsed()));
  double bytes = GetOutputSize(which, which.Levels).Bytes * growth;
  int level = which.Levels;
  while (3. * bytes < available / 2.)
  {
    ++level;
    bytes *= growth;
  }
  return level;
}

void RegisterFilter()
{
  for (const Case& which : GetCases())
  {
    for (int threads : ThreadCounts)
    {
      Register("filter/first/" + which.Name + "/levels:" + std::to_string(which.Levels), threads,
        [&which](Stopwatch& watch) { return RunOnce(watch, which, which.Levels, false); });
    }
  }
  const Case& cube = GetCase("cube");
  const Case& sphere = GetCase("sphere");
  for (int threads : ThreadCounts)
  {
    for (const Case* which : { &cube, &sphere })
    {
      Register("filter/again/" + which->Name + "/levels:3", threads,
        [which](Stopwatch& watch) { return RunAgain(watch, *which, 3); });
    }
    Register("filter/tetoct/cube/levels:3", threads,
      [&cube](Stopwatch& watch) { return RunTetOct(watch, cube, 3); });
    Register("filter/cached/cube/levels:3", threads,
      [&cube](Stopwatch& watch) { return RunOnce(watch, cube, 3, true); });
  }
  if (IsQuick())
  {
    return;
  }
  const struct
  {
    const char* Name;
    int Growth;
  } scaled[] = { { "cube", 8 }, { "sphere", 4 }, { "polylines", 2 } };
  for (const auto& item : scaled)
  {
    const Case& which = GetCase(item.Name);
    const int largest = GetLargestLevel(which, item.Growth);
    for (int levels = which.Levels + 1; levels <= largest; ++levels)
    {
      Register(
        "filter/first/" + which.Name + "/levels:" + std::to_string(levels), 4,
        [&which, levels](Stopwatch& watch) { return RunOnce(watch, which, levels, false); }, 3);
    }
  }
}

const Registration Registered(RegisterFilter);

}

vtkSmartPointer<vtkMultiDimensionalSubdivision> MakeFilter(
  const Case& which, int levels, bool cache)
{
  auto filter = vtkSmartPointer<vtkMultiDimensionalSubdivision>::New();
  filter->SetInputData(GetInput(which));
  filter->SetNumberOfLevels(levels);
  filter->SetMaximumNumberOfCells(VTK_ID_MAX);
  SetCache(filter.Get(), cache, 0);
  return filter;
}

}
