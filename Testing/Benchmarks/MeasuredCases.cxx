// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeasuredCases.cxx
 * Runs one of the main cases by itself, for tools that look at a process.
 *
 *   SubdivisionObjectsCase NAME[-normals|-limits] [SIZE [REPETITIONS [THREADS]]]
 *
 * With normals of the limit, or points on it, behind a case's name. SIZE 1 (default) gives about a
 * hundredth of the cells that benchmarks have, 2 as many as they. Prints the cells of the output,
 * and the milliseconds of all threads together in each repetition. The work is in MeasuredWork, so
 * that `valgrind --tool=callgrind --toggle-collect=MeasuredWork` counts nothing else.
 */
#include "BenchmarkMeshes.h"

#include "vtkDataSet.h"
#include "vtkMultiDimensionalSubdivision.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkSMPTools.h"
#include "vtkSurfaceSubdivision.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif

extern "C" [[gnu::noinline]] void MeasuredWork(vtkAlgorithm* filter)
{
  filter->Update();
}

namespace
{

using benchmarks::ToVtk;

struct Entry
{
  const char* Name;
  vtkSmartPointer<vtkPointSet> (*MakeInput)(bool large);
  int Scheme; ///< of vtkSurfaceSubdivision; -1: the main filter
  int Levels;
};

vtkSmartPointer<vtkPointSet> MakeTets(bool large)
{
  return ToVtk(benchmarks::MakeCube(large ? 12 : 3));
}
vtkSmartPointer<vtkPointSet> MakeHexes(bool large)
{
  return ToVtk(benchmarks::MakeHexahedra(large ? 22 : 5));
}
vtkSmartPointer<vtkPointSet> MakeTriangles(bool large)
{
  return ToVtk(benchmarks::MakeSphere(large ? 5 : 2));
}
vtkSmartPointer<vtkPointSet> MakeQuads(bool large)
{
  return ToVtk(benchmarks::MakeQuadSphere(large ? 58 : 7));
}
vtkSmartPointer<vtkPointSet> MakeLines(bool large)
{
  return benchmarks::MakePolylines(large ? 1000 : 20, 1000);
}

const Entry Entries[] = {
  { "tetrahedra", MakeTets, -1, 3 },
  { "hexahedra", MakeHexes, -1, 3 },
  { "triangles", MakeTriangles, -1, 3 },
  { "polylines", MakeLines, -1, 3 },
  { "Loop", MakeTriangles, vtkSurfaceSubdivision::LOOP, 3 },
  { "Butterfly", MakeTriangles, vtkSurfaceSubdivision::MODIFIED_BUTTERFLY, 3 },
  { "sqrt3", MakeTriangles, vtkSurfaceSubdivision::SQRT_THREE, 4 },
  { "Catmull-Clark", MakeQuads, vtkSurfaceSubdivision::CATMULL_CLARK, 3 },
  { "Doo-Sabin", MakeQuads, vtkSurfaceSubdivision::DOO_SABIN, 3 },
  { "Midedge", MakeQuads, vtkSurfaceSubdivision::MIDEDGE, 6 },
  { "4-8", MakeQuads, vtkSurfaceSubdivision::FOUR_EIGHT, 6 },
};

template <typename Filter>
vtkSmartPointer<Filter> MakeFilter(const Entry& entry, const std::string& addition)
{
  auto filter = vtkSmartPointer<Filter>::New();
  filter->SetNumberOfLevels(entry.Levels);
  filter->SetGenerateLimitNormals(addition == "-normals");
  filter->SetProjectToLimit(addition == "-limits");
  filter->SmoothShadingOff();
  filter->SetCacheOperator(false);
  return filter;
}

vtkSmartPointer<vtkAlgorithm> MakeFilter(
  const Entry& entry, const std::string& addition, vtkPointSet* input)
{
  vtkSmartPointer<vtkAlgorithm> filter;
  if (entry.Scheme < 0)
  {
    filter = MakeFilter<vtkMultiDimensionalSubdivision>(entry, addition);
  }
  else
  {
    const auto made = MakeFilter<vtkSurfaceSubdivision>(entry, addition);
    made->SetScheme(entry.Scheme);
    filter = made;
  }
  filter->SetInputDataObject(0, input);
  return filter;
}

}

int main(int argc, char** argv)
{
#ifdef __GLIBC__
  // As in a process that runs the filter for the first time (BenchmarkMain.cxx).
  mallopt(M_MMAP_MAX, 65536);
  mallopt(M_MMAP_THRESHOLD, 128 * 1024);
  mallopt(M_TRIM_THRESHOLD, 128 * 1024);
#endif
  const std::string name = argc > 1 ? argv[1] : "";
  const auto number = [&](int i) { return argc > i ? std::atoi(argv[i]) : 1; };
  vtkSMPTools::Initialize(number(4));
  for (const Entry& entry : Entries)
  {
    const std::string addition = name.substr(std::min(name.size(), std::strlen(entry.Name)));
    if (name != entry.Name + addition ||
      (!addition.empty() && addition != "-normals" && addition != "-limits"))
    {
      continue;
    }
    const auto input = entry.MakeInput(number(2) > 1);
    for (int i = 0; i < number(3); ++i)
    {
      const auto filter = MakeFilter(entry, addition, input);
      const std::clock_t begin = std::clock();
      MeasuredWork(filter);
      const double taken = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
      auto* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
      if (i == 0)
      {
        std::printf("%lld cells\n", static_cast<long long>(output->GetNumberOfCells()));
      }
      std::printf("%.2f ms\n", taken);
    }
    return EXIT_SUCCESS;
  }
  std::printf("The first argument is the name of a case:");
  for (const Entry& entry : Entries)
  {
    std::printf(" %s", entry.Name);
  }
  std::printf("\n");
  return EXIT_FAILURE;
}
