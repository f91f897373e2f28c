// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestProbeEnds.cxx
 * vtkSubdivisionLimitProbe ends where bounds never get smaller than rounding, and where all places
 * are equally near.
 */
#include "LimitProbeTools.h"

using namespace limit_probe_tools;

namespace
{

struct Case
{
  int Type;
  int Scheme;
};
const std::vector<Case> Cases = { { VTK_LINE, vtkSubdivisionLimitProbe::BOX_SPLINE },
  { VTK_TRIANGLE, vtkSubdivisionLimitProbe::BOX_SPLINE },
  { VTK_QUAD, vtkSubdivisionLimitProbe::BOX_SPLINE },
  { VTK_TETRA, vtkSubdivisionLimitProbe::BOX_SPLINE },
  { VTK_LINE, vtkSubdivisionLimitProbe::CATMULL_CLARK },
  { VTK_TRIANGLE, vtkSubdivisionLimitProbe::LOOP },
  { VTK_QUAD, vtkSubdivisionLimitProbe::CATMULL_CLARK } };

/// The distances of places from the limit of cells of one type on four points or more.
std::vector<double> FindDistances(
  const Case& of, const std::vector<Point>& points, const std::vector<Point>& places)
{
  std::vector<Cell> cells;
  for (std::size_t i = 0; of.Type == VTK_LINE && i < points.size(); ++i)
  {
    const auto first = static_cast<vtkIdType>(i);
    cells.push_back({ VTK_LINE, { first, (first + 1) % static_cast<vtkIdType>(points.size()) } });
  }
  if (of.Type == VTK_TRIANGLE)
  {
    cells = { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 0, 2, 3 } } };
  }
  else if (of.Type != VTK_LINE)
  {
    cells = { { of.Type, { 0, 1, 2, 3 } } };
  }
  vtkNew<vtkSubdivisionLimitProbe> filter;
  filter->SetScheme(of.Scheme);
  filter->SetInputDataObject(3, place_tools::MakeTargets(places));
  const auto found = UpdateWithoutErrors<vtkPolyData>(filter.Get(), MakeGrid(points, cells));
  std::vector<double> distances;
  for (vtkIdType i = 0; i < found->GetNumberOfPoints(); ++i)
  {
    distances.push_back(found->GetPointData()->GetArray("Distance")->GetComponent(i, 0));
  }
  return distances;
}

}

TEST(ProbeEnds, PointsAtOnePlace)
{
  const Point at{ 2., 1., 0. };
  for (const Case& of : Cases)
  {
    SCOPED_TRACE(testing::Message() << of.Type << " " << of.Scheme);
    const auto found =
      FindDistances(of, { at, at, at, at }, { { 0.5, 0.6, 0.7 }, { 10., 10., 10. }, at });
    EXPECT_NEAR(found[0], std::hypot(1.5, 0.4, 0.7), 1e-14);
    EXPECT_NEAR(found[1], std::hypot(8., 9., 10.), 1e-14);
    EXPECT_NEAR(found[2], 0., 1e-15);
  }
}

/// The same as at the origin, as far as limits are known there.
TEST(ProbeEnds, FarFromTheOrigin)
{
  const std::vector<Point> points = { { 0., 0., 0. }, { 1., 0., 0. }, { 1., 1., 0.25 },
    { 0., 1., 1. } };
  const std::vector<Point> places = { { 0.5, 0.625, 0.75 }, { 2., 1., 0. }, { 0.5, 0.5, 0.375 } };
  for (const Case& of : Cases)
  {
    const auto expected = FindDistances(of, points, places);
    for (const double offset : { 1048576. * 1024., 1048576. * 131072. })
    {
      SCOPED_TRACE(testing::Message() << of.Type << " " << of.Scheme << " " << offset);
      auto moved = points;
      auto movedPlaces = places;
      for (auto* some : { &moved, &movedPlaces })
      {
        for (Point& p : *some)
        {
          for (double& x : p)
          {
            x += offset;
          }
        }
      }
      const auto found = FindDistances(of, moved, movedPlaces);
      for (std::size_t i = 0; i < places.size(); ++i)
      {
        EXPECT_NEAR(found[i], expected[i], 1e-15 * offset) << i;
      }
    }
  }
}

/// Each of very many cells may have the place that is nearest to the centre.
TEST(ProbeEnds, CentreOfACircle)
{
  constexpr int size = 40000;
  std::vector<Point> points;
  for (int i = 0; i < size; ++i)
  {
    const double angle = 2. * std::acos(-1.) * i / size;
    points.push_back({ std::cos(angle), std::sin(angle), 0. });
  }
  EXPECT_NEAR(FindDistances(Cases[0], points, { { 0., 0., 0. } })[0], 1., 1e-7);
}
