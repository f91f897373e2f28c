// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchmarkSurface.cxx
 * Surface subdivision: Loop on the sphere of triangles, Catmull-Clark on a sphere of quads; points
 * and a scalar, first execution.
 */
#include "BenchmarkLimit.h"

#include "vtkSurfaceSubdivision.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <string>

namespace benchmarks
{
namespace
{

struct Scheme
{
  const char* Name;
  const char* Mesh;
  int Kind;
  FlatMesh (*Make)();
};

const Scheme Schemes[] = {
  { "Loop", "sphere", vtkSurfaceSubdivision::LOOP, []() { return MakeSphere(5); } },
  { "Catmull-Clark", "quads", vtkSurfaceSubdivision::CATMULL_CLARK,
    []() { return MakeQuadSphere(58); } },
};
constexpr int Levels = 3;

vtkPolyData* GetInput(const Scheme& scheme)
{
  static vtkSmartPointer<vtkPointSet> inputs[2];
  vtkSmartPointer<vtkPointSet>& input = inputs[&scheme - Schemes];
  if (!input)
  {
    input = ToVtk(scheme.Make());
  }
  return vtkPolyData::SafeDownCast(input);
}

Produced Run(Stopwatch& watch, const Scheme& scheme)
{
  vtkNew<vtkSurfaceSubdivision> filter;
  filter->SetInputData(GetInput(scheme));
  filter->SetScheme(scheme.Kind);
  filter->SetNumberOfLevels(Levels);
  filter->SetCacheOperator(false);
  watch.Time([&]() { filter->Update(); });
  vtkPolyData* output = filter->GetOutput();
  return { static_cast<double>(output->GetNumberOfCells()),
    1024. * static_cast<double>(output->GetActualMemorySize()) };
}

/// Arrays of the sizes of points, scalar, connectivity and offsets.
Produced Limit(Stopwatch& watch, const Scheme& scheme)
{
  vtkNew<vtkSurfaceSubdivision> filter;
  filter->SetInputData(GetInput(scheme));
  filter->SetScheme(scheme.Kind);
  filter->SetNumberOfLevels(Levels);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  OutputSize size;
  size.Cells = static_cast<double>(output->GetNumberOfCells());
  for (vtkDataArray* array : { output->GetPoints()->GetData(), output->GetPointData()->GetScalars(),
         static_cast<vtkDataArray*>(output->GetPolys()->GetConnectivityArray()),
         static_cast<vtkDataArray*>(output->GetPolys()->GetOffsetsArray()) })
  {
    size.Arrays.push_back(
      static_cast<std::size_t>(array->GetNumberOfValues()) * array->GetDataTypeSize());
    size.Bytes += static_cast<double>(size.Arrays.back());
  }
  return RunLimit(watch, size, Pages::Small);
}

void RegisterSurface()
{
  for (const Scheme& scheme : Schemes)
  {
    for (int threads : ThreadCounts)
    {
      const std::string end = std::string("/") + scheme.Mesh + "/levels:" + std::to_string(Levels);
      Register(std::string("surface/") + scheme.Name + end, threads,
        [&scheme](Stopwatch& watch) { return Run(watch, scheme); });
      Register(std::string("surfacelimit/") + scheme.Name + end, threads,
        [&scheme](Stopwatch& watch) { return Limit(watch, scheme); });
    }
  }
}

const Registration Registered(RegisterSurface);

}
}
