// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LimitProbeTools.h
 * vtkSubdivisionLimitProbe: ways to run it, and what must hold for all that it finds.
 */
#ifndef SubdivisionObjects_LimitProbeTools_h
#define SubdivisionObjects_LimitProbeTools_h

#include "MultiDimensionalSubdivisionTools.h"
#include "PlaceTools.h"

#include "vtkSubdivisionLimitProbe.h"

namespace limit_probe_tools
{

using namespace multi_dimensional_subdivision_tools;

/// One of vtkSubdivisionModelSource, with values `Random`.
Grid MakeModel(int model);

/// Configures nothing.
struct Plain
{
  template <typename Filter>
  void operator()(Filter*) const
  {
  }
};
/// Solids of the tet/oct scheme.
struct TetOct
{
  void operator()(vtkSubdivisionLimitProbe* filter) const { filter->SetSchemeToTetOct(); }
  void operator()(vtkMultiDimensionalSubdivision* filter) const
  {
    filter->SetVolumeSchemeToTetOct();
  }
};

/// Cells keep their types.
struct Hybrid
{
  void operator()(vtkSubdivisionLimitProbe* filter) const { filter->SetSchemeToHybrid(); }
  void operator()(vtkMultiDimensionalSubdivision* filter) const
  {
    filter->SetVolumeSchemeToHybrid();
  }
};

/// Runs the filter and copies its output, which has to fit together. `configure` sets up the filter
/// and the one whose limit it looks for.
template <typename Configure>
vtkSmartPointer<vtkPolyData> Probe(
  vtkUnstructuredGrid* mesh, const std::vector<Point>& targets, const Configure& configure)
{
  vtkNew<vtkSubdivisionLimitProbe> filter;
  filter->SetSchemeToBoxSpline();
  configure(filter.Get());
  filter->SetInputDataObject(3, place_tools::MakeTargets(targets));
  const auto found = UpdateWithoutErrors<vtkPolyData>(filter.Get(), mesh);
  EXPECT_EQ(found->GetNumberOfPoints(), static_cast<vtkIdType>(targets.size()));
  EXPECT_EQ(found->GetNumberOfVerts(), found->GetNumberOfPoints());
  vtkNew<vtkMultiDimensionalSubdivision> evaluator;
  evaluator->SetVolumeSchemeToBoxSpline();
  configure(evaluator.Get());
  evaluator->SetInputData(mesh);
  vtkNew<vtkPolyData> again;
  EXPECT_TRUE(evaluator->EvaluateLimit(
    vtkIdTypeArray::SafeDownCast(found->GetPointData()->GetArray("CellId")),
    found->GetPointData()->GetArray("CellParameters"), again));
  for (vtkIdType i = 0; i < found->GetNumberOfPoints(); ++i)
  {
    const Point p = GetPoint(found, i);
    const Point q = GetPoint(again, i);
    double distance = 0.;
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(p[c], q[c], 1e-12 * mesh->GetLength()) << i;
      distance += (p[c] - targets[i][c]) * (p[c] - targets[i][c]);
    }
    EXPECT_NEAR(found->GetPointData()->GetArray("Distance")->GetComponent(i, 0),
      std::sqrt(distance), 1e-12 * mesh->GetLength() + 1e-15 * std::sqrt(distance));
  }
  return found;
}
inline vtkSmartPointer<vtkPolyData> Probe(
  vtkUnstructuredGrid* mesh, const std::vector<Point>& targets)
{
  return Probe(mesh, targets, Plain());
}

/// 40 triangles of a grid, whose points are shifted in it.
Grid MakeWavySurface(double shift, double height);

/// The distance of each target to the nearest point of a mesh.
std::vector<double> FindDistances(vtkPointSet* mesh, const std::vector<Point>& targets);

/// Expects that no vertex of a fine level is nearer than the probe's places by `tolerance`, and
/// none of these much nearer. Returns how many have a vertex that is nearer.
template <typename Configure = Plain>
int ExpectNoVertexIsNearer(const Grid& mesh, const std::vector<Point>& targets, int levels,
  double spacing, double tolerance = 1e-12, const Configure& configure = {})
{
  int count = 0;
  const auto found = Probe(mesh, targets, configure);
  vtkNew<vtkMultiDimensionalSubdivision> fine;
  fine->SetVolumeSchemeToBoxSpline();
  configure(fine.Get());
  fine->SetNumberOfLevels(levels);
  fine->ProjectToLimitOn();
  fine->SetInputData(mesh);
  fine->Update();
  const std::vector<double> least = FindDistances(fine->GetOutput(), targets);
  for (std::size_t t = 0; t < targets.size(); ++t)
  {
    const double distance =
      found->GetPointData()->GetArray("Distance")->GetComponent(static_cast<vtkIdType>(t), 0);
    EXPECT_LE(distance, least[t] + tolerance) << t;
    EXPECT_GE(distance, least[t] - spacing) << t;
    count += distance > least[t] + 1e-12 * (1. + least[t]) ? 1 : 0;
  }
  return count;
}

/// The limit at places, each of which the probe has to find again where it is, to within
/// `tolerance` in its parameters.
template <typename Configure>
void ExpectOwnPlaces(
  const Grid& mesh, const place_tools::Places& places, double tolerance, const Configure& configure)
{
  vtkNew<vtkMultiDimensionalSubdivision> evaluator;
  evaluator->SetVolumeSchemeToBoxSpline();
  configure(evaluator.Get());
  evaluator->SetInputData(mesh);
  const auto at = place_tools::Evaluate(evaluator, places);
  std::vector<Point> targets;
  for (vtkIdType i = 0; i < at->GetNumberOfPoints(); ++i)
  {
    targets.push_back(GetPoint(at, i));
  }
  const auto found = Probe(mesh, targets, configure);
  const auto get = [](vtkPolyData* from, const char* name, vtkIdType i, int component)
  { return from->GetPointData()->GetArray(name)->GetComponent(i, component); };
  for (vtkIdType i = 0; i < at->GetNumberOfPoints(); ++i)
  {
    EXPECT_NEAR(get(found, "Distance", i, 0), 0., 1e-12 * mesh->GetLength()) << i;
    EXPECT_NEAR(get(found, "Random", i, 0), get(at, "Random", i, 0), tolerance) << i;
    EXPECT_EQ(get(found, "CellId", i, 0), places.Cells->GetValue(i)) << i;
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_NEAR(
        get(found, "CellParameters", i, k), places.Parameters->GetComponent(i, k), tolerance)
        << i;
    }
  }
}

}

#endif
