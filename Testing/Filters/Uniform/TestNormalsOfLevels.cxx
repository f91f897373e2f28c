// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestNormalsOfLevels.cxx
 * Normals where there is no tangent plane are those of the limit: the same on all levels, whether
 * points are projected or not, and after local refinement.
 */
#include "FeatureTools.h"

#include "vtkRedGreenRefinement.h"

using namespace feature_tools;

namespace
{

void ExpectNear(vtkUnstructuredGrid* actual, vtkUnstructuredGrid* expected, vtkIdType points,
  const std::string& name)
{
  vtkDataArray* a = actual->GetPointData()->GetArray("LimitNormals");
  vtkDataArray* b = expected->GetPointData()->GetArray("LimitNormals");
  for (vtkIdType i = 0; i < 3 * points; ++i)
  {
    EXPECT_NEAR(a->GetComponent(i / 3, i % 3), b->GetComponent(i / 3, i % 3), 1e-5)
      << name << " point " << i / 3;
  }
}

/// The same complex without flags, with flags, and with simplices that are sharp for a while.
std::vector<std::pair<std::string, Configure>> ListChoices(unsigned seed)
{
  return { { "plain", [](Filter* filter) { filter->ModifiedBoundaryOff(); } }, { "modified", {} },
    { "sharp joints",
      [](Filter* filter)
      {
        filter->SetType1RuleToSharp();
        filter->SetType2RuleToSharp();
        filter->SetType3RuleToSharp();
      } },
    { "random", RandomOptions(seed) },
    { "darts", [](Filter* filter) { filter->SetCreaseEnd(Filter::DART); } } };
}

}

TEST(NormalsOfLevels, OfRandomComplexes)
{
  for (unsigned seed = 1; seed < 40; ++seed)
  {
    const Grid input = MakeRandomComplex(seed, seed % 2 == 0);
    for (const auto& [name, choice] : ListChoices(seed))
    {
      for (const int scheme : { Filter::BOX_SPLINE, Filter::TET_OCT })
      {
        Grid first;
        for (int levels = 0; levels < 3; ++levels)
        {
          for (const bool projects : { false, true })
          {
            const Grid output = Execute(input, levels,
              [&, &use = choice](Filter* filter)
              {
                use ? use(filter) : void();
                filter->SetVolumeScheme(scheme);
                filter->InterpolatePointsOff();
                filter->SetProjectToLimit(projects);
                filter->GenerateLimitNormalsOn();
              });
            first = first ? first : output;
            ExpectNear(output, first, input->GetNumberOfPoints(),
              name + std::to_string(seed) + " level " + std::to_string(levels));
          }
        }
      }
    }
  }
}

TEST(NormalsOfLevels, OfRedGreenRefinement)
{
  for (unsigned seed = 1; seed < 20; ++seed)
  {
    const Grid input = MakeRandomComplex(seed, seed % 2 == 0);
    const Grid uniform =
      Execute(input, 1, [](Filter* filter) { filter->GenerateLimitNormalsOn(); });
    vtkNew<vtkRedGreenRefinement> filter;
    filter->SetInputDataObject(input);
    filter->SetPlacementToLimit();
    filter->GenerateLimitNormalsOn();
    filter->RefineByEdgeLengthOn();
    filter->SetMaximumEdgeLength(0.5);
    filter->SetMaximumLevel(3);
    filter->Update();
    ExpectNear(filter->GetOutput(), uniform, input->GetNumberOfPoints(), std::to_string(seed));
  }
}

/// Three sheets at a joint that is blended: their normals in the limit are those of fine triangles.
TEST(NormalsOfLevels, OfAJointAreThoseOfItsSheets)
{
  std::vector<Point> points;
  std::vector<Cell> cells;
  for (int j = 0; j < 4; ++j)
  {
    points.push_back({ 0.1 * j * j, 1. * j, 0. });
  }
  for (int sheet = 0; sheet < 3; ++sheet)
  {
    const double angle = 1.9 * sheet;
    for (vtkIdType j = 0; j < 4; ++j)
    {
      points.push_back({ std::cos(angle), 1. * j, std::sin(angle) });
    }
    for (vtkIdType j = 0; j < 3; ++j)
    {
      const vtkIdType far = 4 + 4 * sheet + j;
      cells.push_back({ VTK_TRIANGLE, { j, far, j + 1 } });
      cells.push_back({ VTK_TRIANGLE, { far, far + 1, j + 1 } });
    }
  }
  const Grid input = MakeGrid(points, cells);
  const Grid coarse = Execute(input, 0, [](Filter* filter) { filter->GenerateLimitNormalsOn(); });
  const Grid fine = Execute(input, 7, [](Filter* filter) { filter->ProjectToLimitOn(); });
  for (const vtkIdType point : { 1, 2 })
  {
    // By hand: the mean of the triangles at the point, which are small.
    Point sum = { 0., 0., 0. };
    vtkNew<vtkIdList> around;
    fine->GetPointCells(point, around);
    for (vtkIdType c = 0; c < around->GetNumberOfIds(); ++c)
    {
      vtkNew<vtkIdList> corners;
      fine->GetCellPoints(around->GetId(c), corners);
      vtkIdType k = corners->IsId(point);
      Point a = GetPoint(fine, corners->GetId((k + 1) % 3));
      Point b = GetPoint(fine, corners->GetId((k + 2) % 3));
      const Point p = GetPoint(fine, point);
      for (int i = 0; i < 3; ++i)
      {
        a[i] -= p[i];
        b[i] -= p[i];
      }
      const Point n = { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0] };
      const double size = std::hypot(n[0], n[1], n[2]);
      const double angle = std::atan2(size, a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
      for (int i = 0; i < 3; ++i)
      {
        sum[i] += angle * n[i] / size;
      }
    }
    const double length = std::hypot(sum[0], sum[1], sum[2]);
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_NEAR(coarse->GetPointData()->GetArray("LimitNormals")->GetComponent(point, i),
        sum[i] / length, 0.02);
    }
  }
}
