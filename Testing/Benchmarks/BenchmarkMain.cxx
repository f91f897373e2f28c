// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchmarkMain.cxx
 * All benchmarks in one program, so that they are repeated in random order in one run.
 *
 *   SubdivisionObjectsBenchmarks [--quick] [--peers] [--warm] [Google Benchmark's own options]
 *   SubdivisionObjectsBenchmarks --peak-memory CASE LEVELS THREADS CACHE(0|1)
 *
 * Of the cases of BenchmarkShape.h and BenchmarkSurface.h the second form ignores LEVELS and CACHE.
 *
 * Either the peers are measured, or all the rest: what peers leave in the heap must not make our
 * memory warm. With --warm it is to be: what repetitions free stays in the process, as where a
 * pipeline runs again and again. The second form executes the filter once in this fresh process and
 * prints how much memory it took.
 */
#include "BenchmarkFilter.h"
#include "BenchmarkShape.h"
#include "BenchmarkSurface.h"
#include "BenchmarkTools.h"

#include "Core/Memory/Buffer.h"

#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include "vtksys/SystemInformation.hxx"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <vector>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace benchmarks
{
namespace
{

std::vector<RegisterFunction>& GetRegistrations()
{
  static std::vector<RegisterFunction> functions;
  return functions;
}

bool Quick = false;
bool Peers = false;
bool Warm = false;

/// Bytes that a line of this process's status tells.
double ReadStatus(const std::string& key)
{
  std::ifstream status("/proc/self/status");
  std::string word;
  double kilobytes = 0.;
  while (status >> word)
  {
    if (word == key + ":")
    {
      status >> kilobytes;
      break;
    }
  }
  return 1024. * kilobytes;
}

template <typename Filter>
int PrintPeakMemoryOf(Filter* filter)
{
  std::ofstream("/proc/self/clear_refs") << "5"; // the peak counts from here
  const double before = ReadStatus("VmRSS");
  filter->Update();
  const double peak = ReadStatus("VmHWM");
  vtkPointSet* output = filter->GetOutput();
  std::printf("{ \"growth\": %.0f, \"output\": %.0f, \"cells\": %lld }\n", peak - before,
    1024. * static_cast<double>(output->GetActualMemorySize()),
    static_cast<long long>(output->GetNumberOfCells()));
  return EXIT_SUCCESS;
}

int PrintPeakMemory(char** arguments)
{
  vtkSMPTools::Initialize(std::atoi(arguments[2]));
  if (const auto shape = MakeShapeFilter(arguments[0]))
  {
    return PrintPeakMemoryOf(shape.Get());
  }
  if (const auto surface = MakeSurfaceFilter(arguments[0]))
  {
    return PrintPeakMemoryOf(surface.Get());
  }
  return PrintPeakMemoryOf(
    MakeFilter(GetCase(arguments[0]), std::atoi(arguments[1]), std::atoi(arguments[3]) != 0).Get());
}

}

void AddRegistration(RegisterFunction function)
{
  GetRegistrations().push_back(function);
}

bool IsQuick()
{
  return Quick;
}

bool IsForPeers()
{
  return Peers;
}

void ReturnFreeMemory()
{
#ifdef __GLIBC__
  // Large blocks are to come from the kernel, as in a process that runs the filter for the first
  // time. The C library changes these values by what earlier repetitions did; MPI sets them too.
  mallopt(M_MMAP_MAX, 65536);
  mallopt(M_MMAP_THRESHOLD, 128 * 1024);
  mallopt(M_TRIM_THRESHOLD, 128 * 1024);
  malloc_trim(0);
#endif
}

void KeepFreeMemory()
{
#ifdef __GLIBC__
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, -1);
#endif
}

double GetAvailableMemory()
{
  vtksys::SystemInformation system;
  return 1024. *
    (static_cast<double>(system.GetHostMemoryAvailable()) -
      static_cast<double>(system.GetHostMemoryUsed()));
}

void TouchFreeMemory(double bytes)
{
  const auto size =
    static_cast<vtkIdType>(std::clamp(bytes, 0., std::max(0., 0.5 * GetAvailableMemory())) / 8.);
  {
    subdivision::Buffer<long long> memory(size, 1);
    benchmark::DoNotOptimize(memory.data());
    benchmark::ClobberMemory();
  }
  // Nothing of it is to be in the caches.
  static subdivision::Buffer<long long> others(16 << 20, 1);
  subdivision::ForEach(others.size(), [&](vtkIdType i) { ++others[i]; });
}

}

int main(int argc, char** argv)
{
  for (bool* option : { &benchmarks::Quick, &benchmarks::Peers, &benchmarks::Warm })
  {
    const char* name = option == &benchmarks::Quick ? "--quick"
      : option == &benchmarks::Peers                ? "--peers"
                                                    : "--warm";
    if (argc > 1 && std::strcmp(argv[1], name) == 0)
    {
      *option = true;
      argv[1] = argv[0];
      ++argv;
      --argc;
    }
  }
  // The C library's values are set before anything is made.
  benchmarks::Warm ? benchmarks::KeepFreeMemory() : benchmarks::ReturnFreeMemory();
  if (argc == 6 && std::strcmp(argv[1], "--peak-memory") == 0)
  {
    return benchmarks::PrintPeakMemory(argv + 2);
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
  {
    return EXIT_FAILURE;
  }
  for (benchmarks::RegisterFunction function : benchmarks::GetRegistrations())
  {
    function();
  }
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return EXIT_SUCCESS;
}
