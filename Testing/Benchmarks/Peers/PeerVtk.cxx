// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PeerVtk.cxx
 * VTK's own: Loop and butterfly subdivision (they carry the scalar) and vtkSubdivideTetra, which
 * makes 12 tetrahedra of each, does not share points and carries the scalar.
 */
#include "BenchmarkMeshes.h"
#include "BenchmarkTools.h"

#include "vtkButterflySubdivisionFilter.h"
#include "vtkLoopSubdivisionFilter.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSubdivideTetra.h"
#include "vtkUnstructuredGrid.h"

namespace benchmarks
{
namespace
{

template <typename Filter>
Produced SubdivideSurface(Stopwatch& watch, int levels)
{
  vtkNew<Filter> filter;
  filter->SetInputData(GetInput(GetCase("sphere")));
  filter->SetNumberOfSubdivisions(levels);
  watch.Time([&]() { filter->Update(); });
  vtkPolyData* output = filter->GetOutput();
  return { static_cast<double>(output->GetNumberOfCells()),
    1024. * static_cast<double>(output->GetActualMemorySize()) };
}

Produced SubdivideTetra(Stopwatch& watch, int levels)
{
  vtkSmartPointer<vtkUnstructuredGrid> mesh =
    vtkUnstructuredGrid::SafeDownCast(GetInput(GetCase("cube")));
  for (int level = 0; level < levels; ++level)
  {
    vtkNew<vtkSubdivideTetra> filter;
    filter->SetInputData(mesh);
    watch.Time([&]() { filter->Update(); });
    mesh = filter->GetOutput();
  }
  return { static_cast<double>(mesh->GetNumberOfCells()),
    1024. * static_cast<double>(mesh->GetActualMemorySize()) };
}

void RegisterVtk()
{
  const int levels = 3;
  const std::string end = "/levels:" + std::to_string(levels);
  Register(
    "peer/VTK Loop/sphere" + end, 1,
    [=](Stopwatch& watch) { return SubdivideSurface<vtkLoopSubdivisionFilter>(watch, levels); }, 3);
  Register(
    "peer/VTK Butterfly/sphere" + end, 1, [=](Stopwatch& watch)
    { return SubdivideSurface<vtkButterflySubdivisionFilter>(watch, levels); }, 3);
  Register(
    "peer/vtkSubdivideTetra/cube" + end, 1,
    [=](Stopwatch& watch) { return SubdivideTetra(watch, levels); }, 3);
}

const Registration Registered(RegisterVtk);

}
}
