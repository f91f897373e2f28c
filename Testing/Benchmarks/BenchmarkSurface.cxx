// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchmarkSurface.cxx
 * Surface subdivision: schemes for triangles on a sphere of triangles, the others on a sphere of
 * quads, to about 1.3 million faces (sqrt(3): 1.66 million); points and a scalar, first execution.
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
  int Kind;
  bool OfTriangles;
  int Levels;

  const char* GetMesh() const { return this->OfTriangles ? "sphere" : "quads"; }
};

const Scheme Schemes[] = {
  { "Loop", vtkSurfaceSubdivision::LOOP, true, 3 },
  { "Butterfly", vtkSurfaceSubdivision::MODIFIED_BUTTERFLY, true, 3 },
  { "sqrt3", vtkSurfaceSubdivision::SQRT_THREE, true, 4 },
  { "Catmull-Clark", vtkSurfaceSubdivision::CATMULL_CLARK, false, 3 },
  { "Doo-Sabin", vtkSurfaceSubdivision::DOO_SABIN, false, 3 },
  { "Midedge", vtkSurfaceSubdivision::MIDEDGE, false, 6 },
  { "4-8", vtkSurfaceSubdivision::FOUR_EIGHT, false, 6 },
};

vtkPolyData* GetInput(const Scheme& scheme)
{
  static vtkSmartPointer<vtkPointSet> inputs[2];
  vtkSmartPointer<vtkPointSet>& input = inputs[scheme.OfTriangles ? 0 : 1];
  if (!input)
  {
    input = ToVtk(scheme.OfTriangles ? MakeSphere(5) : MakeQuadSphere(58));
  }
  return vtkPolyData::SafeDownCast(input);
}

Produced Run(Stopwatch& watch, const Scheme& scheme)
{
  vtkNew<vtkSurfaceSubdivision> filter;
  filter->SetInputData(GetInput(scheme));
  filter->SetScheme(scheme.Kind);
  filter->SetNumberOfLevels(scheme.Levels);
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
  filter->SetNumberOfLevels(scheme.Levels);
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
      const std::string end =
        std::string("/") + scheme.GetMesh() + "/levels:" + std::to_string(scheme.Levels);
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
