// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestLinearScheme.cxx
 * VolumeScheme = LINEAR, and the scheme LINEAR of vtkSurfaceSubdivision: they split, and smooth
 * nothing.
 */
#include "OperatorCacheTools.h"

#include "vtkSubdivisionModelSource.h"
#include "vtkSurfaceSubdivision.h"

using namespace operator_cache_tools;

namespace
{

const Configure Linear = [](Filter* filter) { filter->SetVolumeSchemeToLinear(); };

/// The volume, area and length of all cells.
std::array<double, 3> Measure(vtkUnstructuredGrid* grid)
{
  std::array<double, 3> sizes{};
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    const Ids ids = GetCell(grid, c);
    if (ids.size() == 4)
    {
      sizes[0] += GetSignedVolume(grid, ids);
    }
    else if (ids.size() > 1)
    {
      const Point a = GetPoint(grid, ids[0]);
      Point sides[2];
      for (std::size_t k = 1; k < ids.size(); ++k)
      {
        for (int i = 0; i < 3; ++i)
        {
          sides[k - 1][i] = GetPoint(grid, ids[k])[i] - a[i];
        }
      }
      const auto& [u, v] = sides;
      sizes[ids.size() - 1 == 2 ? 1 : 2] += ids.size() == 2
        ? std::hypot(u[0], u[1], u[2])
        : std::hypot(
            u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) /
          2.;
    }
  }
  return sizes;
}

}

TEST(LinearScheme, CellsAreThoseOfTheBoxSplineAndPointsStay)
{
  for (int model = 0; model < 8; ++model)
  {
    SCOPED_TRACE(model);
    const Grid input = LoadModel(model);
    vtkNew<Messages> messages;
    const Grid smooth = Execute(input, 2, {}, messages);
    const Grid output = Execute(input, 2, Linear);
    EXPECT_EQ(GetCells(output), GetCells(smooth));
    const auto before = Measure(Execute(input, 0));
    const auto after = Measure(output);
    for (int d = 0; d < 3; ++d)
    {
      EXPECT_NEAR(after[d], before[d], 1e-6 * std::abs(before[d])) << d; // points are floats
    }
    for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
    {
      ASSERT_EQ(GetPoint(output, i), GetPoint(input, i));
    }
  }
}

/// Values that are linear in the coordinates stay so, and new values are exact means.
TEST(LinearScheme, NewValuesAreMeansOfTheirEdge)
{
  const Grid input = MakeMixedBox(2);
  AddArrays(input);
  vtkDataArray* values = input->GetPointData()->GetArray("double");
  values->SetComponent(0, 0, std::numeric_limits<double>::infinity());
  const Grid start = Execute(input, 0);
  vtkNew<Messages> messages;
  const Grid output = Execute(input, 1, Linear, messages);
  EXPECT_EQ(messages->CountWarnings("the point array \"double\" at 1 of"), 1);
  std::map<Point, std::vector<double>> places;
  for (vtkIdType i = start->GetNumberOfPoints(); i < output->GetNumberOfPoints(); ++i)
  {
    places[GetPoint(output, i)].push_back(
      output->GetPointData()->GetArray("double")->GetComponent(i, 0));
  }
  values = start->GetPointData()->GetArray("double");
  vtkIdType finite = 0;
  for (const auto& [a, b] : GetEdges(start))
  {
    const Point p = GetPoint(start, a);
    const Point q = GetPoint(start, b);
    const auto found =
      places.find({ 0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.5 * (p[2] + q[2]) });
    ASSERT_NE(found, places.end()) << a << " " << b;
    const double mean = 0.5 * (values->GetComponent(a, 0) + values->GetComponent(b, 0));
    const auto& there = found->second;
    EXPECT_NE(std::find(there.begin(), there.end(), mean), there.end()) << "no neighbour matters";
    finite += std::isfinite(mean) ? 1 : 0;
  }
  EXPECT_GT(finite, 50);
}

TEST(LinearScheme, IsItsOwnLimitAndInterpolates)
{
  const Grid input = MakeMixedBox(2);
  AddArrays(input);
  for (int levels : { 0, 1, 2 })
  {
    const Grid plain = Execute(input, levels, Linear);
    EXPECT_EQ(Compare(Execute(input, levels,
                        And(Linear, [](Filter* filter) { filter->ProjectToLimitOn(); })),
                plain, false),
      "");
    const Grid interpolated = Execute(input, levels,
      And(Linear,
        [](Filter* filter)
        {
          filter->InterpolatePointsOn();
          filter->InterpolateArraysOn();
        }));
    EXPECT_EQ(
      CompareValues(interpolated->GetPoints()->GetData(), plain->GetPoints()->GetData()), "");
    EXPECT_EQ(CompareArrays(interpolated->GetPointData(), plain->GetPointData(), "points"), "");
  }
}

/// There are no tangent planes, and so normals are means of those of triangles.
TEST(LinearScheme, NormalsAreForShading)
{
  const Grid input = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 0 } },
    { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 1, 4, 2 } },
      { VTK_TRIANGLE, { 0, 3, 1 } } });
  const Grid output =
    Execute(input, 1, And(Linear, [](Filter* filter) { filter->GenerateLimitNormalsOn(); }));
  vtkDataArray* normals = output->GetPointData()->GetArray("LimitNormals");
  const double part = std::sqrt(0.5);
  const double expected[5][3] = { { 0, part, part }, { 0, std::sqrt(0.2), std::sqrt(0.8) },
    { 0, 0, 1 }, { 0, 1, 0 }, { 0, 0, 1 } };
  for (int i = 0; i < 5; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(normals->GetComponent(i, c), expected[i][c], 1e-12) << i << " " << c;
    }
  }
}

TEST(LinearScheme, KeptOperatorsStorageAndFiltersInARow)
{
  const Grid input = MakeInput();
  const Configure two = And(Linear, [](Filter* filter) { filter->SetNumberOfLevels(2); });
  Kept filter(two);
  const Grid kept = filter.Update(input);
  EXPECT_EQ(Compare(kept, Fresh(input, two)), "") << "without the cache two steps are one";
  EXPECT_EQ(Compare(kept, Execute(Execute(input, 1, Linear), 1, Linear)), "");
  EXPECT_EQ(Compare(filter.Update(input), kept), "");
  EXPECT_EQ(filter.CountBuilds(), 1);
  vtkNew<Messages> messages;
  Execute(Execute(input, 1, Linear), 1, {}, messages);
  EXPECT_EQ(messages->CountWarnings("another VolumeScheme"), 1);
}

TEST(LinearScheme, SurfacesToo)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Point& p : { Point{ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0.5 }, { 1, 1, 0 } })
  {
    points->InsertNextPoint(p.data());
  }
  vtkNew<vtkCellArray> faces;
  faces->InsertNextCell({ 0, 1, 2 });
  faces->InsertNextCell({ 1, 3, 2 });
  vtkNew<vtkPolyData> input;
  input->SetPoints(points);
  input->SetPolys(faces);
  for (const bool limit : { false, true })
  {
    vtkNew<vtkSurfaceSubdivision> filter;
    filter->SetInputData(input);
    filter->SetSchemeToLinear();
    filter->SetProjectToLimit(limit);
    filter->GenerateLimitNormalsOn();
    filter->Update();
    vtkPolyData* output = filter->GetOutput();
    EXPECT_EQ(output->GetNumberOfPolys(), 8);
    ASSERT_EQ(output->GetNumberOfPoints(), 9);
    for (vtkIdType i = 0; i < 4; ++i)
    {
      EXPECT_EQ(GetPoint(output, i), GetPoint(input, i));
    }
    vtkNew<vtkIdList> cell;
    output->GetCellPoints(3, cell); // the middle of the first triangle
    const Point expected[] = { { 0.5, 0, 0 }, { 0.5, 0.5, 0.25 }, { 0, 0.5, 0.25 } };
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_EQ(GetPoint(output, cell->GetId(i)), expected[i]);
    }
    vtkDataArray* normals = output->GetPointData()->GetArray("LimitNormals");
    for (vtkIdType i = 0; i < 9; ++i)
    {
      const double* n = normals->GetTuple(i);
      EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), 1., 1e-12) << i;
    }
  }
}
