// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchmarkInterpolation.cxx
 * Control points and a scalar whose limits are the given ones, of 10^5 points: the first execution,
 * one with another scalar, where operators and points are kept, one where points move too, and the
 * first with three materials between which the scalar jumps. Each beside the same execution without
 * interpolation. No level, all on the limit: the solver shows.
 */
#include "BenchmarkFilter.h"
#include "BenchmarkTools.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

namespace benchmarks
{
namespace
{

/// What changes after the first execution; None: it is measured itself.
enum class Change
{
  None,
  Scalar,
  Points
};

vtkPointSet* GetMesh()
{
  static const vtkSmartPointer<vtkPointSet> mesh = ToVtk(MakeCube(46)); // 103,823 points
  return mesh;
}

/// The same in three slabs of different materials.
vtkSmartPointer<vtkPointSet> MakeSlabs()
{
  auto slabs = vtkSmartPointer<vtkPointSet>::Take(GetMesh()->NewInstance());
  slabs->ShallowCopy(GetMesh());
  vtkNew<vtkIntArray> materials;
  materials->SetName("MaterialId");
  for (vtkIdType c = 0; c < slabs->GetNumberOfCells(); ++c)
  {
    materials->InsertNextValue(static_cast<int>(3 * c / slabs->GetNumberOfCells()));
  }
  slabs->GetCellData()->AddArray(materials);
  return slabs;
}

vtkSmartPointer<vtkPointSet> MakeChanged(Change change)
{
  auto changed = vtkSmartPointer<vtkPointSet>::Take(GetMesh()->NewInstance());
  changed->ShallowCopy(GetMesh());
  vtkDataArray* old = GetMesh()->GetPointData()->GetScalars();
  vtkNew<vtkDoubleArray> scalar;
  scalar->SetName(old->GetName());
  for (vtkIdType i = 0; i < old->GetNumberOfTuples(); ++i)
  {
    scalar->InsertNextValue(1. - old->GetComponent(i, 0));
  }
  changed->GetPointData()->SetScalars(scalar);
  if (change == Change::Points)
  {
    vtkNew<vtkPoints> points;
    points->DeepCopy(GetMesh()->GetPoints());
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      const double* x = points->GetPoint(i);
      points->SetPoint(i, x[0], x[1], 1.25 * x[2]);
    }
    changed->SetPoints(points);
  }
  return changed;
}

Produced RunInterpolation(Stopwatch& watch, Change change, bool interpolate)
{
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  filter->SetInputData(GetMesh());
  filter->SetNumberOfLevels(0);
  filter->ProjectToLimitOn();
  filter->SetInterpolatePoints(interpolate);
  filter->SetInterpolateArrays(interpolate);
  if (change != Change::None)
  {
    filter->Update();
    filter->SetInputData(MakeChanged(change));
  }
  watch.Time([&]() { filter->Update(); });
  const OutputSize size = MeasureOutput(filter->GetOutput());
  return { size.Cells, size.Bytes };
}

Produced RunJumps(Stopwatch& watch, bool interpolate)
{
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  filter->SetInputData(MakeSlabs());
  filter->SetNumberOfLevels(0);
  filter->ProjectToLimitOn();
  filter->PreserveInterfacesOn();
  filter->SetInterfaceValuesToDiscontinuous();
  filter->SetInterpolateArrays(interpolate);
  watch.Time([&]() { filter->Update(); });
  const OutputSize size = MeasureOutput(filter->GetOutput());
  return { size.Cells, size.Bytes };
}

void RegisterInterpolation()
{
  const struct
  {
    const char* Name;
    Change Of;
  } runs[] = { { "first", Change::None }, { "new scalar", Change::Scalar },
    { "moved points", Change::Points } };
  for (const auto& run : runs)
  {
    for (const int threads : ThreadCounts)
    {
      for (const bool interpolate : { true, false })
      {
        Register(std::string(interpolate ? "interpolation/" : "projection/") + run.Name +
            "/cube46/levels:0",
          threads, [run, interpolate](Stopwatch& watch)
          { return RunInterpolation(watch, run.Of, interpolate); });
      }
    }
  }
  for (const int threads : ThreadCounts)
  {
    for (const bool interpolate : { true, false })
    {
      Register(std::string(interpolate ? "interpolation/" : "projection/") +
          "jumping values/cube46/levels:0",
        threads, [interpolate](Stopwatch& watch) { return RunJumps(watch, interpolate); });
    }
  }
}

const Registration Registered(RegisterInterpolation);

}
}
