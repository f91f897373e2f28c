// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSurfacePlaces.cxx
 * The limit at places of polygons and lines: against the projected points of finer levels, the main
 * filter, and what goes wrong.
 */
#include "MultiDimensionalSubdivisionTools.h"
#include "SurfacePlaceTools.h"
#include "Turns.h"

#include "vtkMultiDimensionalSubdivision.h"

using namespace surfacetools;

TEST(SurfacePlaces, ZooAgainstLevels)
{
  for (const int scheme : PlaceSchemes)
  {
    for (const auto& [name, model] : MakeZoo(scheme == Filter::LOOP))
    {
      for (const bool modified : { true, false })
      {
        for (const int levels : { 1, 3 })
        {
          SCOPED_TRACE(testing::Message() << scheme << " " << name << " " << modified);
          CheckAgainstLevels(MakeInput(model), scheme, levels,
            [&](Filter* filter) { filter->SetModifiedBoundary(modified); });
        }
      }
    }
  }
}

/// All corners of all cells of level 8, around a vertex of three faces, and with creases.
TEST(SurfacePlaces, SmallMeshesAgainstLevel8)
{
  for (const int scheme : PlaceSchemes)
  {
    std::map<std::string, Model> zoo = MakeZoo(scheme == Filter::LOOP);
    for (const char* name :
      turns::Some({ scheme == Filter::LOOP ? "tetrahedron" : "cube", "free line" }))
    {
      SCOPED_TRACE(testing::Message() << scheme << " " << name);
      ASSERT_EQ(zoo.count(name), 1u);
      CheckAgainstLevels(MakeInput(zoo[name]), scheme, 8, {});
    }
  }
}

TEST(SurfacePlaces, CreasesAndWeightsAgainstLevels)
{
  for (const int scheme : PlaceSchemes)
  {
    const Model model = MakeBumpySheet(5, scheme == Filter::LOOP, true);
    for (const int weights : { 0, 1 })
    {
      for (const bool modified : { true, false })
      {
        SCOPED_TRACE(testing::Message() << scheme << " " << weights << " " << modified);
        CheckAgainstLevels(MakeCreasedInput(model, "Singular", [](vtkIdType) { return 1.; }),
          scheme, 3,
          [&](Filter* filter)
          {
            filter->SetLoopWeights(weights);
            filter->SetModifiedBoundary(modified);
          });
      }
    }
  }
}

/// Concave corners are flattened: near them rules are no others' in any step.
TEST(SurfacePlaces, ConcaveCornersAgainstLevels)
{
  for (const int scheme : PlaceSchemes)
  {
    Model model = MakeBumpySheet(4, scheme == Filter::LOOP, false);
    const std::size_t first = scheme == Filter::LOOP ? 8 : 4;
    model.Faces.erase(model.Faces.begin(), model.Faces.begin() + first / 2);
    const auto input = MakeInput(model);
    vtkNew<vtkDoubleArray> flatness;
    flatness->SetName("Flatness");
    for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
    {
      flatness->InsertNextValue(i % 3 == 0 ? 0.4 : -1.);
    }
    input->GetPointData()->AddArray(flatness);
    vtkNew<vtkCellArray> corners;
    vtkNew<vtkIntArray> flags;
    flags->SetName("Singular");
    for (const vtkIdType corner : { 7, 12, 15 })
    {
      corners->InsertNextCell(1, &corner);
      flags->InsertNextValue(1);
    }
    input->SetVerts(corners);
    for (std::size_t i = 0; i < model.Faces.size(); ++i)
    {
      flags->InsertNextValue(0);
    }
    input->GetCellData()->AddArray(flags);
    for (const int levels : { 1, 3 })
    {
      SCOPED_TRACE(testing::Message() << scheme << " " << levels);
      CheckAgainstLevels(input, scheme, levels,
        [](Filter* filter)
        {
          filter->SetInputArrayToProcess(
            6, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Flatness");
        });
    }
  }
}

TEST(SurfacePlaces, SemiSharpCreasesAgainstLevels)
{
  for (const int scheme : PlaceSchemes)
  {
    const Model model = MakeBumpySheet(5, scheme == Filter::LOOP, true);
    for (const double sharpness : { 0.4, 1., 2.7, 20. })
    {
      const auto input = MakeCreasedInput(model, "Sharpness",
        [&](vtkIdType cell) { return cell == 1 ? 0.5 * sharpness : sharpness; });
      for (const int levels : { 1, 3 })
      {
        SCOPED_TRACE(testing::Message() << scheme << " " << sharpness << " " << levels);
        CheckAgainstLevels(input, scheme, levels,
          [](Filter* filter)
          {
            filter->SetInputArrayToProcess(
              4, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Sharpness");
          });
      }
    }
  }
}

/// By Loop's scheme with plain rules both filters have the same limits, also at other places than
/// those of levels, and the same derivatives.
TEST(SurfacePlaces, LoopIsThatOfTheMainFilter)
{
  Model model = MakeBumpySheet(6, true, true);
  model.Faces.erase(model.Faces.begin() + 30, model.Faces.begin() + 33);
  const auto input = MakeCreasedInput(model, "Singular", [](vtkIdType) { return 1.; });
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(input->GetPoints());
  grid->Allocate();
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    input->GetCellPoints(cell, points);
    grid->InsertNextCell(input->GetCellType(cell), points);
  }
  grid->GetCellData()->ShallowCopy(input->GetCellData());
  Places places;
  std::mt19937 random(11);
  const auto draw = [&random] { return random() / 4294967296.; };
  for (int i = 0; i < 600; ++i)
  {
    const auto cell =
      static_cast<vtkIdType>(random() % static_cast<unsigned>(input->GetNumberOfCells()));
    double u = draw();
    double v = draw();
    if (u + v > 1.)
    {
      u = 1. - u;
      v = 1. - v;
    }
    places.Add(cell, { u, v, 0. });
  }
  vtkNew<vtkMultiDimensionalSubdivision> other;
  other->SetInputData(grid);
  other->ModifiedBoundaryOff(); // corners have no angles there
  const auto expected = Evaluate(other.Get(), places);
  const auto result =
    Evaluate(input, Filter::LOOP, places, [](Filter* filter) { filter->ModifiedBoundaryOff(); });
  for (vtkIdType i = 0; i < places.GetSize(); ++i)
  {
    SCOPED_TRACE(testing::Message() << i << " in cell " << places.Cells->GetValue(i));
    ASSERT_LT(GetDistance(GetPoint(result, i), GetPoint(expected, i)), 1e-12);
    for (const char* name : { "DerivativeU", "DerivativeV", "DerivativeW", "LimitNormals" })
    {
      ASSERT_LT(GetDistance(GetTuple(result, name, i), GetTuple(expected, name, i)), 1e-8) << name;
    }
    for (const char* name : { "MeanCurvature", "GaussianCurvature" })
    {
      const double given = GetTuple(expected, name, i)[0];
      ASSERT_NEAR(GetTuple(result, name, i)[0], given, 1e-4 * (1. + std::abs(given))) << name;
    }
  }
}

/// Lines that lie on edges follow these, and others are cubic B-splines, with the same derivative
/// at both sides of a point between two lines.
TEST(SurfacePlaces, Lines)
{
  for (const int scheme : PlaceSchemes)
  {
    Model model = MakeBumpySheet(4, scheme == Filter::LOOP, true);
    const auto size = static_cast<vtkIdType>(model.Points.size());
    for (const Point& p : MakeRandomPoints(4, 9))
    {
      model.Points.push_back(p);
    }
    const std::vector<Point>& x = model.Points;
    const vtkIdType lines = static_cast<vtkIdType>(model.Lines.size());
    model.Lines.insert(
      model.Lines.end(), { { size, size + 1 }, { size + 2, size + 1 }, { size + 2, size + 3 } });
    const auto input = MakeCreasedInput(model, "Singular", [](vtkIdType) { return 1.; });
    Places places;
    for (vtkIdType line = 0; line < lines; ++line)
    {
      for (const double u : { 0.31 - 1e-3, 0.31 + 1e-3, 0.31 })
      {
        places.Add(line, { u, 7., 7. });
      }
    }
    places.Add(lines + 1, { 0.25, 0., 0. }); // from the third point to the second
    places.Add(lines + 1, { 1., 0., 0. });
    places.Add(lines, { 1., 0., 0. });
    const auto result = Evaluate(input, scheme, places);
    for (vtkIdType line = 0; line < lines; ++line)
    {
      const Point a = GetPoint(result, 3 * line);
      const Point b = GetPoint(result, 3 * line + 1);
      const Point slope = GetTuple(result, "DerivativeU", 3 * line + 2);
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(slope[c], (b[c] - a[c]) / 2e-3, 1e-5) << scheme << " line " << line;
      }
    }
    const double t = 0.75;
    const double weights[4] = { (1. - t) * (1. - t) * (1. - t) / 6.,
      (3. * t * t * t - 6. * t * t + 4.) / 6., (-3. * t * t * t + 3. * t * t + 3. * t + 1.) / 6.,
      t * t * t / 6. };
    Point expected{};
    for (int k = 0; k < 4; ++k)
    {
      for (int c = 0; c < 3; ++c)
      {
        expected[c] += weights[k] * x[static_cast<std::size_t>(size + k)][c];
      }
    }
    const vtkIdType last = places.GetSize() - 1;
    EXPECT_LT(GetDistance(GetPoint(result, last - 2), expected), 1e-14);
    EXPECT_LT(GetDistance(GetPoint(result, last - 1), GetPoint(result, last)), 1e-14);
    const Point before = GetTuple(result, "DerivativeU", last - 1);
    const Point after = GetTuple(result, "DerivativeU", last);
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(before[c], -after[c], 1e-13);
    }
    EXPECT_GT(GetTuple(result, "MeanCurvature", last)[0], 0.);
    EXPECT_EQ(GetTuple(result, "DerivativeV", last), (Point{ 0., 0., 0. }));
  }
}

TEST(SurfacePlaces, ThreadsAndOtherPlacesDoNotMatter)
{
  for (const int scheme : PlaceSchemes)
  {
    const auto input = MakeInput(MakeBumpySheet(20, scheme == Filter::LOOP, false));
    Places places;
    for (vtkIdType i = 0; i < 2000; ++i)
    {
      places.Add(i * 7 % input->GetNumberOfCells(), { 1. / (3. + i % 5), 1. / (2. + i % 7), 0. });
    }
    const auto many = Evaluate(input, scheme, places);
    vtkSMPTools::Initialize(1);
    const auto one = Evaluate(input, scheme, places);
    vtkSMPTools::Initialize(0);
    for (vtkIdType i = 0; i < places.GetSize(); ++i)
    {
      ASSERT_EQ(GetPoint(many, i), GetPoint(one, i));
      ASSERT_EQ(GetTuple(many, "DerivativeU", i), GetTuple(one, "DerivativeU", i));
      ASSERT_EQ(GetTuple(many, "MeanCurvature", i)[0], GetTuple(one, "MeanCurvature", i)[0]);
    }
    Places last;
    Point at;
    places.Parameters->GetTuple(places.GetSize() - 1, at.data());
    last.Add(places.Cells->GetValue(places.GetSize() - 1), at);
    EXPECT_EQ(GetPoint(Evaluate(input, scheme, last), 0), GetPoint(many, places.GetSize() - 1));
  }
}

/// The rules are those of the filter: control values are solved for, a stamp is read, and points
/// follow the mesh in which seams are joined.
TEST(SurfacePlaces, InterpolationFiltersInARowAndSeams)
{
  for (const int scheme : PlaceSchemes)
  {
    const auto input = MakeInput(MakeStar(5, scheme == Filter::LOOP));
    Places corners;
    for (vtkIdType i = 0; i < input->GetNumberOfCells(); ++i)
    {
      corners.Add(i, { 0., 0., 0. });
    }
    const auto given =
      Evaluate(input, scheme, corners, [](Filter* filter) { filter->InterpolatePointsOn(); });
    const auto fine = RunFilter(input, scheme, 2);
    const auto limit = RunFilter(fine, scheme, 0, true);
    const auto next = Evaluate(fine, scheme, corners);
    vtkNew<vtkIdList> points;
    for (vtkIdType i = 0; i < corners.GetSize(); ++i)
    {
      input->GetCellPoints(i, points);
      EXPECT_LT(GetDistance(GetPoint(given, i), GetPoint(input, points->GetId(0))), 1e-9);
      fine->GetCellPoints(i, points);
      EXPECT_LT(GetDistance(GetPoint(next, i), GetPoint(limit, points->GetId(0))), 1e-13);
    }
    CheckAgainstLevels(MakeSeamedSheet(scheme == Filter::LOOP), scheme, 2);
  }
}

TEST(SurfacePlaces, ArraysThatAreNotSmoothed)
{
  const auto input = MakeInput(MakeZoo(false)["quad"]);
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Numbers");
  for (int i = 0; i < 5; ++i)
  {
    numbers->InsertNextValue(10 + i);
  }
  input->GetPointData()->AddArray(numbers);
  Places places;
  const std::vector<Point> at = { { 0.1, 0.2, 0. }, { 0.9, 0.3, 0. }, { 0.7, 0.8, 0. },
    { 0.2, 0.6, 0. } };
  for (const Point& p : at)
  {
    places.Add(0, p);
  }
  const auto result = Evaluate(input, Filter::CATMULL_CLARK, places);
  vtkDataArray* found = result->GetPointData()->GetArray("Numbers");
  ASSERT_NE(found, nullptr);
  for (vtkIdType i = 0; i < 4; ++i)
  {
    EXPECT_EQ(found->GetComponent(i, 0), 10. + static_cast<double>(i));
  }
}

/// Cells of a grid keep their ids, also where lines come after polygons, and solids have no places.
TEST(SurfacePlaces, CellsOfGrids)
{
  const auto input = MakeInput(MakeZoo(false)["cube"]);
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> all;
  all->SetDataTypeToDouble();
  all->DeepCopy(input->GetPoints());
  const vtkIdType first = all->GetNumberOfPoints();
  const vtkIdType solid[4] = { first, first + 1, first + 2, first + 3 };
  for (const Point& p :
    std::initializer_list<Point>{ { 9, 0, 0 }, { 10, 0, 0 }, { 9, 1, 0 }, { 9, 0, 1 } })
  {
    all->InsertNextPoint(p.data());
  }
  grid->SetPoints(all);
  grid->Allocate();
  grid->InsertNextCell(VTK_TETRA, 4, solid);
  vtkNew<vtkIdList> points;
  Places places;
  Places expected;
  for (vtkIdType face = 0; face < 6; ++face)
  {
    input->GetCellPoints(face, points);
    grid->InsertNextCell(VTK_QUAD, points);
    places.Add(1 + face, { 0.3, 0.1, 0. });
    expected.Add(face, { 0.3, 0.1, 0. });
  }
  const vtkIdType edge[2] = { 0, 1 };
  grid->InsertNextCell(VTK_LINE, 2, edge);
  places.Add(7, { 1., 0., 0. });
  expected.Add(0, { 1., 0., 0. });
  vtkNew<Filter> filter;
  filter->SetInputData(grid);
  filter->SetSchemeToCatmullClark();
  const auto found = Evaluate(filter.Get(), places);
  const auto wanted = Evaluate(input, Filter::CATMULL_CLARK, expected);
  for (vtkIdType i = 0; i < places.GetSize(); ++i)
  {
    EXPECT_LT(GetDistance(GetPoint(found, i), GetPoint(wanted, i)), 1e-14) << i;
  }
  vtkNew<multi_dimensional_subdivision_tools::Messages> messages;
  messages->Watch(filter);
  Places inside;
  inside.Add(0, { 0.1, 0.1, 0.1 });
  vtkNew<vtkPolyData> result;
  EXPECT_FALSE(filter->EvaluateLimit(inside.Cells, inside.Parameters, result));
  ASSERT_FALSE(messages->Errors.empty());
  EXPECT_NE(messages->Errors[0].find("cell 0, which was cut"), std::string::npos);
}

TEST(SurfacePlaces, Errors)
{
  Model model = MakeZoo(false)["pentagon and triangle"];
  model.Lines = { { 0, 1 } };
  const auto input = MakeInput(model);
  vtkNew<Filter> filter;
  filter->SetInputData(input);
  filter->SetSchemeToCatmullClark();
  vtkNew<multi_dimensional_subdivision_tools::Messages> messages;
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
  fails(-1, { 0.2, 0.2, 0. }, "cell -1: the input has no such cell");
  fails(3, { 0.2, 0.2, 0. }, "cell 3: the input has no such cell");
  fails(1, { 0.2, 1.1, 0. }, "cell 1: it is outside");
  fails(0, { -0.1, 0., 0. }, "cell 0: it is outside");
  fails(1, { 0.2, 0.2, 5. }, "cell 1, a polygon that is no quad");
  fails(2, { 0.2, 0.2, 0.5 }, "cell 2, a polygon that is no quad");
  {
    Places missing;
    missing.Add(1, { 0.2, std::nan(""), 0. });
    missing.Add(1, { 0.2, 0.3, 1. });
    const auto found = Evaluate(filter.Get(), missing);
    EXPECT_TRUE(std::isnan(found->GetPoint(0)[0]));
    EXPECT_TRUE(std::isfinite(found->GetPoint(1)[0]));
    EXPECT_EQ(
      messages->CountWarnings("1 place has parameters that are not finite; the first is place 0"),
      1);
  }
  filter->SetSchemeToLoop();
  fails(1, { 0.2, 0.2, 0. }, "cell 1, which was cut");
  fails(2, { 0.6, 0.6, 0. }, "cell 2: it is outside");
  for (const int scheme : { Filter::MODIFIED_BUTTERFLY, Filter::DOO_SABIN, Filter::LINEAR })
  {
    filter->SetScheme(scheme);
    fails(2, { 0.2, 0.2, 0. }, "Loop or CatmullClark");
  }
  filter->SetSchemeToLoop();
  filter->SetInterfaceValuesToDiscontinuous();
  fails(2, { 0.2, 0.2, 0. }, "InterfaceValues");
  filter->SetInterfaceValuesToContinuous();
  Places places;
  places.Add(2, { 0.25, 0.25, 0.25 });
  Evaluate(filter.Get(), places);
  places.Cells->InsertNextValue(2);
  vtkNew<vtkPolyData> result;
  EXPECT_FALSE(filter->EvaluateLimit(places.Cells, places.Parameters, result));
}
