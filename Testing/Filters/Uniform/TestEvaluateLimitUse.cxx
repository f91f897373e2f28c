// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestEvaluateLimitUse.cxx
 * EvaluateLimit in use: threads, other places, filters in a row, and errors.
 */
#include "LimitProbeTools.h"

#include "vtkSubdivisionModelSource.h"

using namespace limit_probe_tools;
using namespace place_tools;
using Filter = vtkMultiDimensionalSubdivision;

TEST(EvaluateLimit, ThreadsAndOtherPlacesDoNotMatter)
{
  const Grid input = MakeModel(vtkSubdivisionModelSource::SPRING_AND_VALVE);
  vtkNew<Filter> filter;
  filter->SetInputData(input);
  Places places;
  for (vtkIdType i = 0; i < input->GetNumberOfCells(); i += 7)
  {
    places.Add(i, { 0.2, 0.3, 0.1 });
  }
  const auto many = Evaluate(filter, places);
  vtkSMPTools::Initialize(1);
  const auto one = Evaluate(filter, places);
  vtkSMPTools::Initialize(0);
  Places last;
  last.Add(places.Cells->GetValue(places.GetSize() - 1), { 0.2, 0.3, 0.1 });
  const auto alone = Evaluate(filter, last);
  for (vtkIdType i = 0; i < places.GetSize(); ++i)
  {
    EXPECT_EQ(GetPoint(many, i), GetPoint(one, i));
  }
  const Point p = GetPoint(alone, 0);
  const Point q = GetPoint(many, places.GetSize() - 1);
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_NEAR(p[c], q[c], 1e-13 * input->GetLength());
  }
}

/// The rules are those of the filter: control values are solved for, and a stamp is read.
TEST(EvaluateLimit, InterpolationAndFiltersInARow)
{
  const Grid input = MakeModel(vtkSubdivisionModelSource::CYLINDER);
  vtkNew<Filter> first;
  first->SetInputData(input);
  first->InterpolatePointsOn();
  Places corners;
  for (vtkIdType i = 0; i < input->GetNumberOfCells(); i += 5)
  {
    corners.Add(i, { 0., 0., 0. });
  }
  const auto given = Evaluate(first, corners);
  for (vtkIdType i = 0; i < corners.GetSize(); ++i)
  {
    const Point x = GetPoint(input, GetCell(input, corners.Cells->GetValue(i))[0]);
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(GetPoint(given, i)[c], x[c], 1e-9 * input->GetLength());
    }
  }
  first->Update();
  vtkNew<Filter> second;
  second->SetInputData(first->GetOutput());
  second->SetNumberOfLevels(0);
  second->ProjectToLimitOn();
  second->Update();
  const auto result = Evaluate(second, corners);
  for (vtkIdType i = 0; i < corners.GetSize(); ++i)
  {
    const Ids cell = GetCell(first->GetOutput(), corners.Cells->GetValue(i));
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(GetPoint(result, i)[c], GetPoint(second->GetOutput(), cell[0])[c],
        1e-12 * input->GetLength());
    }
  }
}

TEST(EvaluateLimit, Errors)
{
  const Grid input = MakeMixedBox(2);
  vtkNew<Filter> filter;
  filter->SetInputData(input);
  filter->SetVolumeSchemeToBoxSpline();
  vtkNew<Messages> messages;
  messages->Watch(filter);
  const auto fails = [&](vtkIdType cell, const Point& p, const char* part)
  {
    messages->Errors.clear();
    Places places;
    places.Add(cell, p);
    vtkNew<vtkPolyData> result;
    EXPECT_FALSE(filter->EvaluateLimit(places.Cells, places.Parameters, result)) << part;
    ASSERT_FALSE(messages->Errors.empty()) << part;
    EXPECT_NE(messages->Errors[0].find(part), std::string::npos) << messages->Errors[0];
  };
  fails(-1, { 0.2, 0.2, 0.2 }, "no such cell");
  fails(input->GetNumberOfCells(), { 0.2, 0.2, 0.2 }, "no such cell");
  vtkIdType hexahedron = 0;
  while (input->GetCellType(hexahedron) != VTK_HEXAHEDRON)
  {
    ++hexahedron;
  }
  fails(hexahedron, { 0.2, 0.2, 0.2 }, "no vertex, line, triangle or tetrahedron");
  fails(hexahedron, { 0.2, 0.2, 0.2 }, "Use the Subdivision Limit Probe");
  const Grid quad =
    MakeGrid({ { 0., 0., 0. }, { 1., 0., 0. }, { 1., 1., 0. }, { 0., 1., 0. }, { 2., 0., 0. } },
      { { VTK_TRIANGLE, { 1, 4, 2 } }, { VTK_QUAD, { 0, 1, 2, 3 } } });
  filter->SetInputData(quad);
  fails(1, { 0.2, 0.2, 0. }, "EvaluateLimit of vtkSurfaceSubdivision with Scheme = CatmullClark");
  const Grid tet = MakeGrid({ { 0., 0., 0. }, { 1., 0., 0. }, { 0., 1., 0. }, { 0., 0., 1. } },
    { { VTK_TETRA, { 0, 1, 2, 3 } } });
  filter->SetInputData(tet);
  {
    Places missing;
    missing.Add(0, { std::nan(""), 0., 0. });
    missing.Add(0, { 0.2, 0.2, 0.2 });
    const auto found = Evaluate(filter, missing);
    EXPECT_TRUE(std::isnan(found->GetPoint(0)[0]));
    EXPECT_TRUE(std::isfinite(found->GetPoint(1)[0]));
    EXPECT_EQ(
      messages->CountWarnings("1 place has parameters that are not finite; the first is place 0"),
      1);
  }
  fails(0, { 0.6, 0.6, 0. }, "outside of cell 0");
  fails(0, { -0.1, 0.2, 0. }, "outside of cell 0");
  filter->SetInterfaceValuesToDiscontinuous();
  fails(0, { 0.2, 0.2, 0.2 }, "InterfaceValues");
  filter->SetInterfaceValuesToContinuous();
  Places places;
  places.Add(0, { 0.25, 0.25, 0.25 });
  Evaluate(filter, places);
  places.Cells->InsertNextValue(0);
  vtkNew<vtkPolyData> result;
  EXPECT_FALSE(filter->EvaluateLimit(places.Cells, places.Parameters, result));
}
