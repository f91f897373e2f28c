// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchmarkAdaptive.cxx
 * Local refinement of a surface to a geometric error of 3e-4 of its size: by the sqrt(3) scheme,
 * and red-green on the limit. The surfaces: a sphere of 82,000 triangles with bumps, and, if the
 * folder of further meshes has it, a scanned bunny. The limit: writing the output.
 */
#include "BenchmarkLimit.h"

#include "Private/vtkSubdivisionObjectsCompat.h"

#include "vtkAdaptiveSurfaceSubdivision.h"
#include "vtkRedGreenRefinement.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <map>
#include <string>
#include <vector>

namespace benchmarks
{
namespace
{

constexpr double Tolerance = 3e-4;
constexpr int Levels = 8;

struct Surface
{
  const char* Name;
  vtkSmartPointer<vtkPointSet> (*Make)();

  vtkPointSet* Get() const
  {
    static std::map<std::string, vtkSmartPointer<vtkPointSet>> made;
    vtkSmartPointer<vtkPointSet>& surface = made[this->Name];
    surface = surface ? surface : this->Make();
    return surface;
  }
};

const Surface Surfaces[] = {
  { "bumpy", []() { return ToVtk(MakeBumpySphere(6)); } },
  { "bunny", []() { return ReadFile(GetDataFolder() + "/surf_bunny_full.vtp"); } },
};

template <typename Filter>
void SetUp(Filter* filter, const Surface& surface)
{
  filter->SetInputData(surface.Get());
  filter->SetRefineByGeometricError(true);
  filter->SetGeometricTolerance(Tolerance);
  filter->SetMaximumLevel(Levels);
}

/// The bytes of the output's points, scalar and cells.
OutputSize GetSize(vtkPointSet* output)
{
  OutputSize size;
  std::vector<vtkDataArray*> arrays = { output->GetPoints()->GetData(),
    output->GetPointData()->GetScalars() };
  auto add = [&arrays](vtkCellArray* cells)
  {
    arrays.push_back(cells->GetConnectivityArray());
    arrays.push_back(cells->GetOffsetsArray());
  };
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(output))
  {
    add(grid->GetCells());
    arrays.push_back(subdivision::GetCellTypes(grid));
  }
  else
  {
    add(vtkPolyData::SafeDownCast(output)->GetPolys());
  }
  size.Cells = static_cast<double>(output->GetNumberOfCells());
  for (vtkDataArray* array : arrays)
  {
    size.Arrays.push_back(
      static_cast<std::size_t>(array->GetNumberOfValues()) * array->GetDataTypeSize());
    size.Bytes += static_cast<double>(size.Arrays.back());
  }
  return size;
}

template <typename Filter>
Produced Run(Stopwatch& watch, const Surface& surface, const std::function<void(Filter*)>& set)
{
  vtkNew<Filter> filter;
  SetUp(filter.Get(), surface);
  set(filter);
  watch.Time([&]() { filter->Update(); });
  const OutputSize size = GetSize(filter->GetOutput());
  return { size.Cells, size.Bytes };
}

template <typename Filter>
void RegisterFilter(
  const std::string& what, const Surface& surface, const std::function<void(Filter*)>& set)
{
  const std::string end = "/" + what + "/" + surface.Name + "/levels:" + std::to_string(Levels);
  for (int threads : ThreadCounts)
  {
    Register("adaptive" + end, threads,
      [&surface, set](Stopwatch& watch) { return Run<Filter>(watch, surface, set); });
    Register("adaptivelimit" + end, threads,
      [&surface, set](Stopwatch& watch)
      {
        static std::map<std::string, OutputSize> sizes; // one for each filter
        OutputSize& size = sizes[surface.Name];
        if (size.Arrays.empty())
        {
          vtkNew<Filter> filter;
          SetUp(filter.Get(), surface);
          set(filter);
          filter->Update();
          size = GetSize(filter->GetOutput());
        }
        return RunLimit(watch, size, Pages::Huge);
      });
  }
}

void RegisterAdaptive()
{
  for (const Surface& surface : Surfaces)
  {
    if (surface.Get())
    {
      RegisterFilter<vtkAdaptiveSurfaceSubdivision>(
        "sqrt3", surface, [](vtkAdaptiveSurfaceSubdivision*) {});
      RegisterFilter<vtkRedGreenRefinement>("redgreen", surface,
        [](vtkRedGreenRefinement* filter) { filter->SetPlacement(vtkRedGreenRefinement::LIMIT); });
    }
  }
}

const Registration Registered(RegisterAdaptive);

}
}
