// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchmarkFilter.cxx
 * The whole filter: first execution, execution with another scalar, larger and larger levels, and
 * control meshes of 10^3 cells and more.
 */
#include "BenchmarkFilter.h"

#include "BenchmarkMeshes.h"
#include "BenchmarkTools.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <string>

namespace benchmarks
{
namespace
{

/// Nothing, where the filter refused what does not fit into memory.
Produced Tell(vtkUnstructuredGrid* output)
{
  if (output->GetNumberOfCells() == 0)
  {
    return { 0., 0., true };
  }
  const OutputSize size = MeasureOutput(output);
  return { size.Cells, size.Bytes };
}

Produced RunOnce(Stopwatch& watch, const Case& which, int levels, bool cache)
{
  const auto filter = MakeFilter(which, levels, cache);
  watch.Time([&]() { filter->Update(); });
  return Tell(filter->GetOutput());
}

/// Execution with normals of the limit, or with points on the limit, or, with neither, the other
/// scheme for solids alone.
Produced RunWith(
  Stopwatch& watch, const Case& which, int levels, bool tetOct, bool normals, bool limits)
{
  const auto filter = MakeFilter(which, levels, false);
  tetOct ? filter->SetVolumeSchemeToTetOct() : filter->SetVolumeSchemeToBoxSpline();
  filter->SetGenerateLimitNormals(normals);
  filter->SetProjectToLimit(limits);
  watch.Time([&]() { filter->Update(); });
  return Tell(filter->GetOutput());
}

/// Execution without smoothing, of cells that keep their types.
Produced RunLinear(Stopwatch& watch, const Case& which, int levels)
{
  const auto filter = MakeFilter(which, levels, false);
  filter->SetVolumeSchemeToLinear();
  filter->KeepCellTypesOn();
  watch.Time([&]() { filter->Update(); });
  return Tell(filter->GetOutput());
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
  return Tell(filter->GetOutput());
}

/// A control mesh of about ten times as many cells as the one before, and the levels that fit.
struct ControlMesh
{
  const char* Kind;
  const char* Cells;
  FlatMesh (*Make)(int);
  int Size;
  int Levels;
  bool IsQuick;
};

const ControlMesh ControlMeshes[] = {
  { "tetrahedra", "1296", MakeCube, 6, 1, true },
  { "tetrahedra", "10368", MakeCube, 12, 1, true },
  { "tetrahedra", "105456", MakeCube, 26, 1, true },
  { "tetrahedra", "998250", MakeCube, 55, 1, true },
  { "tetrahedra", "10110954", MakeCube, 119, 1, false },
  { "triangles", "1280", MakeSphere, 3, 2, true },
  { "triangles", "20480", MakeSphere, 5, 2, true },
  { "triangles", "81920", MakeSphere, 6, 2, true },
  { "triangles", "1310720", MakeSphere, 8, 2, true },
  { "triangles", "9999392", MakeTorus, 2236, 2, false },
};

Produced RunControl(Stopwatch& watch, const ControlMesh& mesh)
{
  // Made anew: not all of them fit into memory beside the largest output.
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  filter->SetInputData(ToVtk(mesh.Make(mesh.Size)));
  filter->SetNumberOfLevels(mesh.Levels);
  filter->SetMaximumNumberOfCells(VTK_ID_MAX);
  filter->SmoothShadingOff();
  SetCache(filter.Get(), false, 0);
  watch.Time([&]() { filter->Update(); });
  return Tell(filter->GetOutput());
}

/// The largest level whose output, with what the filter takes beside it, fits into 20 GB and into
/// the memory that is free.
int GetLargestLevel(const Case& which, int growth)
{
  const double available = GetAvailableMemory();
  constexpr double peak = 1.2; // beside the output
  double bytes = GetOutputSize(which, which.Levels).Bytes * growth;
  int level = which.Levels;
  while (peak * bytes < std::min(0.95 * available, 2e10))
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
      [&cube](Stopwatch& watch) { return RunWith(watch, cube, 3, true, false, false); });
    Register("filter/linear/hexahedra/levels:3", threads,
      [](Stopwatch& watch) { return RunLinear(watch, GetCase("hexahedra"), 3); });
    for (const bool normals : { false, true })
    {
      const std::string what = normals ? "normals" : "limits";
      for (const Case* which : { &cube, &sphere })
      {
        Register("filter/" + what + "/" + which->Name + "/levels:3", threads,
          [=](Stopwatch& watch) { return RunWith(watch, *which, 3, false, normals, !normals); });
      }
      Register("filter/tetoct-" + what + "/cube/levels:3", threads,
        [&cube, normals](Stopwatch& watch)
        { return RunWith(watch, cube, 3, true, normals, !normals); });
    }
    Register("filter/cached/cube/levels:3", threads,
      [&cube](Stopwatch& watch) { return RunOnce(watch, cube, 3, true); });
  }
  if (IsForPeers())
  {
    return; // finding the largest levels takes memory that is then warm
  }
  const int repetitions = IsQuick() ? 0 : 3;
  for (const ControlMesh& mesh : ControlMeshes)
  {
    for (int threads : ThreadCounts)
    {
      if (mesh.IsQuick || !IsQuick())
      {
        Register(
          std::string("control/") + mesh.Kind + "/" + mesh.Cells +
            "/levels:" + std::to_string(mesh.Levels),
          threads, [&mesh](Stopwatch& watch) { return RunControl(watch, mesh); }, repetitions);
      }
    }
  }
  const struct
  {
    const char* Name;
    int Growth;
  } scaled[] = { { "cube", 8 }, { "sphere", 4 }, { "polylines", 2 } };
  for (const auto& item : scaled)
  {
    const Case& which = GetCase(item.Name);
    const int fitting = GetLargestLevel(which, item.Growth);
    const int largest = IsQuick() ? std::min(fitting, which.Levels + 1) : fitting;
    for (int levels = 2; levels <= largest; ++levels)
    {
      for (int threads : ThreadCounts)
      {
        if (levels != which.Levels)
        {
          Register(
            "filter/first/" + which.Name + "/levels:" + std::to_string(levels), threads,
            [&which, levels](Stopwatch& watch) { return RunOnce(watch, which, levels, false); },
            repetitions);
        }
      }
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
  filter->SmoothShadingOff();
  SetCache(filter.Get(), cache, 0);
  return filter;
}

}
