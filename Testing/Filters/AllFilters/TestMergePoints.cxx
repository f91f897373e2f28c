// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestMergePoints.cxx
 * MergePoints gives what a mesh gives whose cells share points by hand, bit for bit.
 */
#include "FeatureTools.h"

#include "vtkSurfaceSubdivision.h"

using namespace feature_tools;

namespace
{

const Configure Merge = [](Filter* filter) { filter->MergePointsOn(); };

/// A value that depends on the place alone.
void AddValues(vtkPointSet* grid)
{
  vtkNew<vtkDoubleArray> values;
  values->SetName("values");
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    const double* x = grid->GetPoint(i);
    values->InsertNextValue(x[0] + 2. * x[1] + 4. * x[2]);
  }
  grid->GetPointData()->AddArray(values);
}

/// A tetrahedron, and cells on its faces that have points of their own: 0 = 4, 1 = 5, 2 = 6 = 8.
const std::vector<Point> Touching = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
  { -0., 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, -1 }, { 0, 1, 0 }, { 2, 2, 2 } };

/// With some of the points, to which cells count; without `kept`, with all.
Grid MakeTouching(const std::vector<Cell>& cells, const Ids& kept = {})
{
  std::vector<Point> points;
  for (const vtkIdType point : kept)
  {
    points.push_back(Touching[point]);
  }
  const Grid grid = MakeGrid(kept.empty() ? Touching : points, cells);
  AddValues(grid);
  return grid;
}

/// Two tetrahedra that touch in a face, of which each has values of its own: 1 and 3, or else 1.
Grid MakeTwo(double value, double away = 0.)
{
  const double below = -away;
  const Grid grid = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0, 0, below },
                               { 1, 0, below }, { 0, 1, below }, { 0, 0, -1 } },
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 5, 4, 6, 7 } } });
  vtkNew<vtkDoubleArray> values;
  values->SetName("values");
  for (int i = 0; i < 8; ++i)
  {
    values->InsertNextValue(i < 4 ? 1. : value);
  }
  grid->GetPointData()->AddArray(values);
  return grid;
}

std::vector<double> GetValues(vtkDataSet* mesh, const char* name = "values")
{
  std::vector<double> values;
  vtkDataArray* array = mesh->GetPointData()->GetArray(name);
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetComponent(i, 0));
  }
  return values;
}

Configure MergeWith(int rule)
{
  return [rule](Filter* filter)
  {
    filter->MergePointsOn();
    filter->SetMergedValues(rule);
  };
}

}

TEST(MergePoints, CellsShareTheFirstOfThePointsAtAPlace)
{
  const Grid apart = MakeTouching(
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 5, 4, 6, 7 } }, { VTK_LINE, { 8, 9 } } });
  const Grid joined = MakeTouching(
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 1, 0, 2, 4 } }, { VTK_LINE, { 2, 5 } } },
    { 0, 1, 2, 3, 7, 9 });
  vtkNew<Messages> ofPointsApart;
  EXPECT_NE(Compare(Execute(apart, 2, {}, ofPointsApart), Execute(joined, 2)), "");
  EXPECT_EQ(Compare(Execute(apart, 2, Merge), Execute(joined, 2)), "");
  EXPECT_EQ(Compare(Execute(joined, 2, Merge), Execute(joined, 2)), "");
}

TEST(MergePoints, TheSmallestGlobalIdStands)
{
  const std::vector<vtkIdType> ids = { 9, 1, 7, 3, 4, 5, 6, 2, 0, 8 };
  const Grid apart = MakeTouching(
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 5, 4, 6, 7 } }, { VTK_LINE, { 8, 9 } } });
  const Grid joined = MakeTouching(
    { { VTK_TETRA, { 2, 0, 4, 1 } }, { VTK_TETRA, { 0, 2, 4, 3 } }, { VTK_LINE, { 4, 5 } } },
    { 1, 3, 4, 7, 8, 9 });
  SetGlobalIds(apart, ids);
  SetGlobalIds(joined, { 1, 3, 4, 2, 0, 8 });
  EXPECT_EQ(Compare(Execute(apart, 2, Merge), Execute(joined, 2)), "");
}

TEST(MergePoints, ACellWithTwoPointsAtOnePlaceIsDegenerate)
{
  const Grid grid = MakeTouching({ { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TRIANGLE, { 6, 8, 9 } } });
  vtkNew<Messages> messages;
  const Grid result = Execute(grid, 1, Merge, messages);
  EXPECT_EQ(result->GetNumberOfCells(), 8);
  EXPECT_EQ(messages->CountWarnings("repeated point ids"), 1);
  EXPECT_EQ(messages->CountWarnings("one and the same cell in 1 cell (cell 1)"), 1);
}

TEST(MergePoints, PointsThatAreNotFiniteOrDoNotExistStay)
{
  std::vector<Point> points = Touching;
  points[3][1] = std::numeric_limits<double>::quiet_NaN();
  points[9][1] = std::numeric_limits<double>::quiet_NaN();
  points[7] = { 0, 0, -std::numeric_limits<double>::infinity() };
  const Grid grid = MakeGrid(points,
    { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 1, 8, 3 } }, { VTK_LINE, { 4, 99 } },
      { VTK_LINE, { -1, 4 } }, { VTK_TRIANGLE, { 4, 8, 9 } }, { VTK_LINE, { 6, 4 } } });
  vtkNew<Messages> messages;
  const Grid result = Execute(grid, 0, Merge, messages);
  EXPECT_EQ(GetCells(result), (std::vector<Ids>{ { 0, 1, 2 }, { 2, 0 } }));
  EXPECT_EQ(messages->Warnings.size(), 2u);
}

TEST(MergePoints, PolyhedraShareFacesUnlessTheyHaveTwoPointsAtOnePlace)
{
  for (const bool isDoubled : { false, true })
  {
    vtkNew<vtkUnstructuredGrid> grid;
    vtkNew<vtkPoints> points;
    for (Point p : Touching)
    {
      points->InsertNextPoint(p.data());
    }
    grid->SetPoints(points);
    const vtkIdType top[] = { 3, 0, 2, 1, 3, 0, 1, 3, 3, 1, 2, 3, 3, 2, 0, 3 };
    grid->InsertNextCell(VTK_POLYHEDRON, 4, top);
    // With two points at one place: a pyramid of five points, whose base has an edge without
    // length.
    const vtkIdType lower[] = { 3, 4, 5, 6, 3, 5, 4, 7, 3, 6, 5, 7, 3, 4, 6, 7 };
    const vtkIdType doubled[] = { 4, 4, 5, 6, 8, 3, 5, 4, 7, 3, 6, 5, 7, 3, 8, 6, 7, 3, 4, 8, 7 };
    grid->InsertNextCell(VTK_POLYHEDRON, isDoubled ? 5 : 4, isDoubled ? doubled : lower);
    vtkNew<Messages> messages;
    const Grid result = Execute(grid.Get(), 0, Merge, messages);
    EXPECT_EQ(messages->CountWarnings("one and the same cell"), isDoubled ? 1 : 0);
    std::set<vtkIdType> used;
    for (const Ids& cell : GetCells(result))
    {
      used.insert(cell.begin(), cell.end());
    }
    EXPECT_EQ(used.size(), isDoubled ? 11u : 7u); // with a centre in each
  }
}

TEST(MergePoints, BlocksOfAComposite)
{
  vtkNew<vtkMultiBlockDataSet> blocks[2];
  const std::vector<Cell> line = { { VTK_LINE, { 6, 9 } } }; // beside points without cells
  blocks[0]->SetBlock(
    0, MakeTouching({ { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 5, 4, 6, 7 } } }));
  blocks[1]->SetBlock(0,
    MakeTouching(
      { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 1, 0, 2, 4 } } }, { 0, 1, 2, 3, 7, 8, 9 }));
  blocks[0]->SetBlock(1, MakeTouching(line));
  blocks[1]->SetBlock(1, MakeTouching(line));
  auto run = [](vtkDataObject* input, bool merges)
  {
    vtkNew<Filter> filter;
    filter->SetInputDataObject(input);
    filter->SetMergePoints(merges);
    filter->JoinBlocksOff();
    filter->Update();
    auto* made = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
    return std::vector<Grid>{ vtkUnstructuredGrid::SafeDownCast(made->GetBlock(0)),
      vtkUnstructuredGrid::SafeDownCast(made->GetBlock(1)) };
  };
  const auto results = run(blocks[0], true);
  const auto expected = run(blocks[1], false);
  EXPECT_EQ(Compare(results[0], expected[0]), "");
  EXPECT_EQ(Compare(results[1], expected[1]), "");
}

/// A cube as sources make it, each side with points of its own, becomes one closed surface.
TEST(MergePoints, ACubeOfSixQuads)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polys;
  for (int side = 0; side < 6; ++side)
  {
    vtkIdType ids[4];
    for (int corner = 0; corner < 4; ++corner)
    {
      double x[3];
      const int axis = side / 2;
      x[axis] = side % 2;
      x[(axis + 1) % 3] = corner == 1 || corner == 2;
      x[(axis + 2) % 3] = corner >= 2;
      ids[corner] = points->InsertNextPoint(x);
    }
    polys->InsertNextCell(4, ids);
  }
  vtkNew<vtkPolyData> cube;
  cube->SetPoints(points);
  cube->SetPolys(polys);
  for (const bool merges : { false, true })
  {
    vtkNew<vtkSurfaceSubdivision> filter;
    filter->SetInputData(cube);
    filter->SetSchemeToCatmullClark();
    filter->SetNumberOfLevels(1);
    filter->JoinSidesOff();
    filter->SetMergePoints(merges);
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPolys(), 24);
    // 8 or 24 points of the input, then 6 of faces, and 12 or 24 of edges.
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 6 + (merges ? 8 + 12 : 24 + 24));
  }
}

TEST(MergePoints, OriginalIdsAreThoseOfTheInput)
{
  const Configure configure = [](Filter* filter)
  {
    filter->MergePointsOn();
    filter->GenerateOriginalIdsOn();
  };
  const Grid result = Execute(MakeTwo(1.), 1, configure);
  const std::vector<double> ids = GetValues(result, "vtkOriginalPointIds");
  EXPECT_EQ(result->GetNumberOfPoints(), 14);
  EXPECT_EQ(
    std::vector<double>(ids.begin(), ids.begin() + 6), (std::vector<double>{ 0, 1, 2, 3, 7, -1 }));
  // In blocks too, of which each counts its own.
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakeTwo(1.));
  blocks->SetBlock(1, MakeGrid({ { 5, 5, 5 }, { 6, 6, 6 } }, { { VTK_LINE, { 0, 1 } } }));
  vtkNew<Filter> filter;
  filter->SetInputDataObject(blocks);
  filter->SetNumberOfLevels(0);
  configure(filter);
  filter->Update();
  auto* made = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_EQ(GetValues(vtkDataSet::SafeDownCast(made->GetBlock(0)), "vtkOriginalPointIds"),
    (std::vector<double>{ 0, 1, 2, 3, 7 }));
}

TEST(MergePoints, PointsWithoutCellsStay)
{
  const Grid grid = MakeGrid({ { 0, 0, 0 }, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 0 }, { 0, 1, 0 } },
    { { VTK_LINE, { 1, 2 } }, { VTK_LINE, { 3, 4 } } });
  const Grid result = Execute(grid, 0, Merge);
  EXPECT_EQ(result->GetNumberOfPoints(), 4);
  EXPECT_EQ(GetCells(result), (std::vector<Ids>{ { 1, 2 }, { 1, 3 } }));
}

TEST(MergePoints, ArraysThatDoNotFitAreLeftOut)
{
  const Grid grid = MakeTwo(1.);
  vtkNew<vtkDoubleArray> five; // as many as remain
  five->SetName("five");
  five->SetNumberOfValues(5);
  five->FillValue(0.);
  grid->GetPointData()->AddArray(five);
  vtkNew<Messages> messages;
  const Grid result = Execute(grid, 1, Merge, messages);
  EXPECT_EQ(messages->CountWarnings("\"five\" has 5 tuples for 8 points"), 1);
  EXPECT_FALSE(result->GetPointData()->HasArray("five"));
}

TEST(MergePoints, DifferentValuesAreToldAndTheFirstIsTaken)
{
  vtkNew<Messages> messages;
  const Grid result = Execute(MakeTwo(3.), 0, Merge, messages);
  EXPECT_EQ(GetValues(result), (std::vector<double>{ 1, 1, 1, 1, 3 }));
  ASSERT_EQ(messages->Warnings.size(), 1u);
  EXPECT_EQ(messages->CountWarnings("\"values\" (3 points, by up to 2)"), 1);
  EXPECT_EQ(messages->CountWarnings("Set MergedValues to Average or Keep"), 1);
}

TEST(MergePoints, AveragesOfDifferentValues)
{
  EXPECT_EQ(GetValues(Execute(MakeTwo(3.), 0, MergeWith(Filter::AVERAGE_VALUE))),
    (std::vector<double>{ 2, 2, 2, 1, 3 }));
  const Grid grid = MakeTwo(std::numeric_limits<double>::quiet_NaN());
  const std::vector<double> known = GetValues(Execute(grid, 0, MergeWith(Filter::AVERAGE_VALUE)));
  EXPECT_EQ(std::vector<double>(known.begin(), known.begin() + 4), std::vector<double>(4, 1.));
  // Labels have no mean.
  const Grid labels = MakeTwo(1.);
  vtkNew<vtkIntArray> label;
  label->SetName("label");
  for (int i = 0; i < 8; ++i)
  {
    label->InsertNextValue(i < 4 ? 7 : 9);
  }
  labels->GetPointData()->AddArray(label);
  vtkNew<Messages> messages;
  EXPECT_EQ(GetValues(Execute(labels, 0, MergeWith(Filter::AVERAGE_VALUE), messages), "label"),
    (std::vector<double>{ 7, 7, 7, 7, 9 }));
  EXPECT_EQ(messages->CountWarnings("\"label\" (3 points, by up to 2)"), 1);
  const Configure integers = [](Filter* filter)
  {
    MergeWith(Filter::AVERAGE_VALUE)(filter);
    filter->InterpolateIntegersOn();
  };
  EXPECT_EQ(
    GetValues(Execute(labels, 0, integers), "label"), (std::vector<double>{ 8, 8, 8, 7, 9 }));
}

/// Each tetrahedron has its own value everywhere, and the shape is that of a mesh that is joined.
TEST(MergePoints, KeptValuesJump)
{
  const Grid result = Execute(MakeTwo(3.), 2, MergeWith(Filter::KEEP_VALUES));
  const Grid joined = Execute(MakeTwo(1.), 2, Merge);
  EXPECT_EQ(result->GetNumberOfPoints(), joined->GetNumberOfPoints() + 15);
  for (vtkIdType c = 0; c < result->GetNumberOfCells(); ++c)
  {
    for (const vtkIdType id : GetCell(result, c))
    {
      EXPECT_EQ(GetValues(result)[id], c < 64 ? 1. : 3.);
    }
  }
  for (vtkIdType i = 0; i < joined->GetNumberOfPoints(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(result->GetPoint(i)[k], joined->GetPoint(i)[k]);
    }
  }
  EXPECT_FALSE(result->GetCellData()->HasArray("SubdivisionMergedParts"));
}

TEST(MergePoints, NothingToMergeIsNoError)
{
  for (const int rule : { Filter::FIRST_VALUE, Filter::AVERAGE_VALUE, Filter::KEEP_VALUES })
  {
    const Grid empty = vtkSmartPointer<vtkUnstructuredGrid>::New();
    const Grid result = Execute(empty, 1, MergeWith(rule));
    EXPECT_EQ(result->GetNumberOfPoints(), 0);
    // Without points in common all is as without the option.
    const Grid one = MakeGrid(
      { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, { { VTK_TETRA, { 0, 1, 2, 3 } } });
    AddValues(one);
    EXPECT_EQ(GetValues(Execute(one, 1, MergeWith(rule))), GetValues(Execute(one, 1)));
  }
}

TEST(MergePoints, ValuesOnBothSidesOfASlitCannotJump)
{
  // Four triangles around point 0; the slit between 1 and 5 ends there.
  const Grid grid =
    MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 }, { 0, -1, 0 }, { 1, 0, 0 } },
      { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 0, 2, 3 } }, { VTK_TRIANGLE, { 0, 3, 4 } },
        { VTK_TRIANGLE, { 0, 4, 5 } } });
  vtkNew<vtkDoubleArray> values;
  values->SetName("values");
  for (int i = 0; i < 6; ++i)
  {
    values->InsertNextValue(i);
  }
  grid->GetPointData()->AddArray(values);
  vtkNew<Messages> messages;
  Execute(grid, 1, MergeWith(Filter::KEEP_VALUES), messages);
  EXPECT_EQ(messages->CountWarnings("1 point touches another of the same connected part"), 1);
  // Seams of a surface can.
  vtkNew<vtkSurfaceSubdivision> filter;
  vtkNew<Messages> ofSurface;
  ofSurface->Watch(filter);
  filter->SetInputDataObject(grid);
  filter->SetNumberOfLevels(0);
  filter->MergePointsOn();
  filter->SetMergedValuesToKeep();
  filter->Update();
  EXPECT_TRUE(ofSurface->Warnings.empty());
  EXPECT_EQ(GetValues(filter->GetOutput()), (std::vector<double>{ 0, 1, 2, 3, 4, 5 }));
}

TEST(MergePoints, ToleranceJoinsAlmostEqualPoints)
{
  const auto merge = [](double tolerance)
  {
    return [tolerance](Filter* filter)
    {
      filter->MergePointsOn();
      filter->SetMergeTolerance(tolerance);
    };
  };
  const double diagonal = std::sqrt(6.);
  const Grid apart = MakeTwo(1., 1e-4 * diagonal);
  EXPECT_EQ(Execute(apart, 1, merge(1.001e-4))->GetNumberOfPoints(), 14);
  vtkNew<Messages> messages;
  EXPECT_EQ(Execute(apart, 1, merge(0.999e-4), messages)->GetNumberOfPoints(), 20);
  // Two blocks, whose points become equal.
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(
    0, MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { VTK_TRIANGLE, { 0, 1, 2 } } }));
  blocks->SetBlock(1,
    MakeGrid({ { 0, 0, 1e-7 }, { 1, 1e-7, 0 }, { 0, -1, 0 } }, { { VTK_TRIANGLE, { 1, 0, 2 } } }));
  vtkNew<Filter> filter;
  filter->SetInputDataObject(blocks);
  merge(1e-6)(filter);
  filter->SetNumberOfLevels(2);
  filter->Update();
  auto* made = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  std::set<std::array<double, 3>> places;
  for (const unsigned int block : { 0u, 1u })
  {
    auto* mesh = vtkDataSet::SafeDownCast(made->GetBlock(block));
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      const double* x = mesh->GetPoint(i);
      places.insert({ x[0], x[1], x[2] });
    }
  }
  EXPECT_EQ(places.size(), 25u); // 15 + 15 - 5
}

/// With JoinSeams a texture keeps its seam, with or without MergePoints; elsewhere it is left out.
TEST(MergePoints, TextureCoordinatesAreNeverThoseOfTheFirst)
{
  vtkNew<vtkPolyData> strip;
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> texture;
  texture->SetName("texture");
  texture->SetNumberOfComponents(2);
  vtkNew<vtkCellArray> polys;
  for (int i = 0; i <= 6; ++i)
  {
    const double angle = i % 6 * std::acos(-1.) / 3;
    for (int z = 0; z < 2; ++z)
    {
      points->InsertNextPoint(std::cos(angle), std::sin(angle), z);
      texture->InsertNextTuple2(i / 6., z);
    }
    const vtkIdType ids[4] = { 2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1 };
    i < 6 ? polys->InsertNextCell(4, ids) : vtkIdType(0);
  }
  strip->SetPoints(points);
  strip->SetPolys(polys);
  strip->GetPointData()->SetTCoords(texture);
  vtkSmartPointer<vtkPolyData> outputs[2];
  for (const bool merges : { false, true })
  {
    vtkNew<vtkSurfaceSubdivision> filter;
    vtkNew<Messages> messages;
    messages->Watch(filter);
    filter->SetInputData(strip);
    filter->SetSchemeToCatmullClark();
    filter->SetNumberOfLevels(2);
    filter->SetMergePoints(merges);
    filter->Update();
    EXPECT_TRUE(messages->Warnings.empty());
    outputs[merges] = filter->GetOutput();
  }
  EXPECT_EQ(GetValues(outputs[0], "texture"), GetValues(outputs[1], "texture"));
  EXPECT_FALSE(GetValues(outputs[0], "texture").empty());
  vtkNew<Messages> messages;
  const Grid result = [&]
  {
    vtkNew<Filter> filter;
    messages->Watch(filter);
    filter->SetInputData(strip);
    filter->MergePointsOn();
    filter->Update();
    return Grid(filter->GetOutput());
  }();
  EXPECT_EQ(messages->CountWarnings("texture coordinates \"texture\" (2 points, by up to 1)"), 1);
  EXPECT_EQ(messages->CountWarnings("Use JoinSeams"), 1);
  EXPECT_FALSE(result->GetPointData()->HasArray("texture"));
}
