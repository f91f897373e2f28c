// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchmarkSurface.cxx
 * Surface subdivision: schemes for triangles on a sphere of triangles, the others on a sphere of
 * quads, to about 1.3 million faces (sqrt(3): 1.66 million); points and a scalar, first execution.
 * The same with normals of the limit, and with points on the limit.
 */
#include "BenchmarkSurface.h"

#include "BenchmarkLimit.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <map>
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

vtkSmartPointer<vtkSurfaceSubdivision> MakeFilter(const Scheme& scheme)
{
  auto filter = vtkSmartPointer<vtkSurfaceSubdivision>::New();
  filter->SetInputData(GetInput(scheme));
  filter->SetScheme(scheme.Kind);
  filter->SetNumberOfLevels(scheme.Levels);
  filter->SetCacheOperator(false);
  return filter;
}

Produced Run(Stopwatch& watch, const Scheme& scheme, bool normals = false, bool limits = false)
{
  const auto filter = MakeFilter(scheme);
  filter->SetGenerateLimitNormals(normals);
  filter->SetProjectToLimit(limits);
  watch.Time([&]() { filter->Update(); });
  vtkPolyData* output = filter->GetOutput();
  return { static_cast<double>(output->GetNumberOfCells()),
    1024. * static_cast<double>(output->GetActualMemorySize()) };
}

/// Points, scalar, connectivity and offsets of the output, found by running the filter once.
const OutputSize& GetSize(const Scheme& scheme)
{
  static std::map<std::string, OutputSize> sizes;
  OutputSize& size = sizes[scheme.Name];
  if (size.Arrays.empty())
  {
    const auto filter = MakeFilter(scheme);
    filter->Update();
    vtkPolyData* output = filter->GetOutput();
    size.Cells = static_cast<double>(output->GetNumberOfCells());
    for (vtkDataArray* array :
      { output->GetPoints()->GetData(), output->GetPointData()->GetScalars(),
        static_cast<vtkDataArray*>(output->GetPolys()->GetConnectivityArray()),
        static_cast<vtkDataArray*>(output->GetPolys()->GetOffsetsArray()) })
    {
      size.Arrays.push_back(
        static_cast<std::size_t>(array->GetNumberOfValues()) * array->GetDataTypeSize());
      size.Bytes += static_cast<double>(size.Arrays.back());
    }
  }
  return size;
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
      Register(std::string("surfaceframes/") + scheme.Name + "-normals" + end, threads,
        [&scheme](Stopwatch& watch) { return Run(watch, scheme, true, false); });
      Register(std::string("surfaceframes/") + scheme.Name + "-limits" + end, threads,
        [&scheme](Stopwatch& watch) { return Run(watch, scheme, false, true); });
      Register(std::string("surfacelimit/") + scheme.Name + "-small" + end, threads,
        [&scheme](Stopwatch& watch) { return RunLimit(watch, GetSize(scheme), Pages::Small); });
      Register(std::string("surfacelimit/") + scheme.Name + "-huge" + end, threads,
        [&scheme](Stopwatch& watch) { return RunLimit(watch, GetSize(scheme), Pages::Huge); });
    }
  }
}

const Registration Registered(RegisterSurface);

}

vtkSmartPointer<vtkSurfaceSubdivision> MakeSurfaceFilter(const std::string& name)
{
  for (const Scheme& scheme : Schemes)
  {
    if (scheme.Name == name)
    {
      return MakeFilter(scheme);
    }
  }
  return nullptr;
}

}
