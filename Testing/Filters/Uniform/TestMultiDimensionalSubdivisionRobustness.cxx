// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestMultiDimensionalSubdivisionRobustness.cxx
 * Bad cells, ghosts, limits, empty input, progress and abort, and files from elsewhere.
 */
#include "MultiDimensionalSubdivisionTools.h"

#include "vtkCallbackCommand.h"

using namespace multi_dimensional_subdivision_tools;

namespace
{

const std::vector<Point> Corners = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
  { 1, 1, 1 }, { 2, 0, 0 }, { 2, 2, 0 }, { 0, 2, 2 } };

Grid MakeTet()
{
  return MakeGrid(Corners, { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TRIANGLE, { 1, 2, 4 } } });
}

/// Collects what a filter says of its progress.
void Observe(vtkObject*, unsigned long, void* values, void* data)
{
  static_cast<std::vector<double>*>(values)->push_back(*static_cast<double*>(data));
}

/// A good mesh with a bad cell: one warning, and the rest is as if the cell were not there.
void ExpectPassedOver(std::vector<Cell> bad, const std::string& text, bool nanPoint = false)
{
  SCOPED_TRACE(text);
  auto points = Corners;
  if (nanPoint)
  {
    points.push_back({ 0, std::numeric_limits<double>::quiet_NaN(), 0 });
    points.push_back({ std::numeric_limits<double>::infinity(), 0, 0 });
  }
  const std::vector<Cell> good = { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TRIANGLE, { 1, 2, 4 } } };
  std::vector<Cell> mixed = { good[0] };
  mixed.insert(mixed.end(), bad.begin(), bad.end());
  mixed.push_back(good[1]);
  for (int levels : { 0, 1, 2 })
  {
    vtkNew<Messages> messages;
    Options options;
    options.Levels = levels;
    const Grid result = Subdivide(MakeGrid(points, mixed), options, messages);
    EXPECT_EQ(messages->Errors.size(), 0u);
    ASSERT_EQ(messages->Warnings.size(), 1u);
    EXPECT_EQ(messages->CountWarnings(text), 1) << messages->Warnings[0];
    EXPECT_EQ(messages->CountWarnings("cell 1"), 1) << messages->Warnings[0];
    EXPECT_EQ(messages->CountWarnings(std::to_string(bad.size()) + " cell"), 1);
    EXPECT_EQ(Compare(result, Subdivide(MakeGrid(points, good), options)), "");
  }
}

}

TEST(MultiDimensionalSubdivisionBadCells, AreAsIfAbsent)
{
  ExpectPassedOver({ { VTK_CONVEX_POINT_SET, { 0, 1, 2 } } }, "not supported");
  ExpectPassedOver({ { VTK_HIGHER_ORDER_TRIANGLE, { 0, 1, 2, 3, 4, 5 } }, { VTK_EMPTY_CELL, {} } },
    "not supported");
  ExpectPassedOver({ { VTK_TETRA, { 1, 2, 4, 8 } }, { VTK_LINE, { -1, 2 } } }, "point id");
  ExpectPassedOver({ { VTK_QUAD, { 1, 2, 4, 1000000000000 } } }, "point id");
  ExpectPassedOver({ { VTK_TETRA, { 1, 2, 4, 8 } }, { VTK_LINE, { 9, 2 } } }, "not a number", true);
  ExpectPassedOver({ { VTK_TETRA, { 1, 2, 4, 4 } }, { VTK_LINE, { 2, 2 } } }, "repeated");
  ExpectPassedOver({ { VTK_TRIANGLE, { 3, 4, 3 } } }, "repeated");
  ExpectPassedOver({ { VTK_HEXAHEDRON, { 1, 1, 1, 1, 1, 1, 1, 1 } } }, "repeated");
  ExpectPassedOver({ { VTK_TETRA, { 1, 2, 4 } } }, "number of points");
  ExpectPassedOver({ { VTK_POLY_LINE, { 4 } } }, "number of points");
}

TEST(MultiDimensionalSubdivisionBadCells, InvertedAndFlatOnesAreKept)
{
  const Grid grid = MakeGrid(Corners,
    { { VTK_TETRA, { 1, 0, 2, 3 } }, { VTK_TETRA, { 0, 1, 5, 6 } },
      { VTK_TRIANGLE, { 0, 1, 5 } } });
  EXPECT_EQ(Subdivide(grid, 1)->GetNumberOfCells(), 8 + 8 + 4);
}

// ---------------------------------------------------------------- ghosts

namespace
{

vtkSmartPointer<vtkUnsignedCharArray> MakeGhosts(const std::vector<int>& values)
{
  auto ghosts = vtkSmartPointer<vtkUnsignedCharArray>::New();
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (int value : values)
  {
    ghosts->InsertNextValue(static_cast<unsigned char>(value));
  }
  return ghosts;
}

constexpr int Hidden = vtkDataSetAttributes::HIDDENCELL;
constexpr int Duplicate = vtkDataSetAttributes::DUPLICATECELL;

}

TEST(MultiDimensionalSubdivisionGhosts, HiddenCellsHaveNoInfluence)
{
  const std::vector<Cell> cells = { { VTK_TRIANGLE, { 1, 2, 4 } }, { VTK_TETRA, { 0, 1, 2, 3 } },
    { VTK_QUADRATIC_EDGE, { 0, 1, 2 } }, { VTK_LINE, { 4, 7 } } };
  const Grid grid = MakeGrid(Corners, cells);
  grid->GetCellData()->AddArray(MakeGhosts({ 0, Hidden, Hidden | 64, 0 }));
  const Grid few = MakeGrid(Corners, { cells[0], cells[3] });
  few->GetCellData()->AddArray(MakeGhosts({ 0, 0 }));
  for (int levels : { 0, 1, 2 })
  {
    EXPECT_EQ(Compare(Subdivide(grid, levels), Subdivide(few, levels)), "");
  }
}

TEST(MultiDimensionalSubdivisionGhosts, TypesGoToChildrenAndPoints)
{
  // Two triangles on an edge, the second a duplicate; a point of none, hidden before.
  const Grid grid =
    MakeGrid(Corners, { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 2, 1, 4 } } });
  grid->GetCellData()->AddArray(MakeGhosts({ 0, Duplicate | 2 }));
  grid->GetPointData()->AddArray(MakeGhosts({ 1, 1, 1, 0, 0, 2, 0, 0 }));
  for (int levels : { 0, 1, 2 })
  {
    vtkNew<Messages> messages;
    Options options;
    options.Levels = levels;
    options.Integers = true;
    vtkNew<vtkMultiDimensionalSubdivision> filter;
    messages->Watch(filter);
    Set(filter, options);
    filter->ModifiedBoundaryOff();
    filter->SetInputData(grid);
    filter->Update();
    const Grid result = filter->GetOutput();
    EXPECT_EQ(messages->Errors.size(), 0u);
    EXPECT_EQ(messages->Warnings.size(), 0u) << "one layer is enough for curves and surfaces";
    vtkUnsignedCharArray* cells = result->GetCellGhostArray();
    vtkUnsignedCharArray* points = result->GetPointGhostArray();
    ASSERT_TRUE(cells && points);
    ASSERT_EQ(points->GetNumberOfValues(), result->GetNumberOfPoints());
    std::set<vtkIdType> owned;
    std::set<vtkIdType> used;
    for (vtkIdType i = 0; i < result->GetNumberOfCells(); ++i)
    {
      const bool second = i >= result->GetNumberOfCells() / 2;
      EXPECT_EQ(cells->GetValue(i), second ? (Duplicate | 2) : 0);
      for (vtkIdType p : GetCell(result, i))
      {
        used.insert(p);
        if (!second)
        {
          owned.insert(p);
        }
      }
    }
    EXPECT_LT(owned.size(), used.size());
    for (vtkIdType p = 0; p < result->GetNumberOfPoints(); ++p)
    {
      const int expected = owned.count(p) ? 0
        : used.count(p)                   ? int(vtkDataSetAttributes::DUPLICATEPOINT)
        : p == 5                          ? 2
                                          : 0;
      EXPECT_EQ(points->GetValue(p), expected) << p;
    }
  }
}

TEST(MultiDimensionalSubdivisionGhosts, NoneAreMade)
{
  const Grid one = Subdivide(MakeTet(), 1);
  EXPECT_FALSE(one->GetPointGhostArray());
  EXPECT_FALSE(one->GetCellGhostArray());
}

// ---------------------------------------------------------------- limits

namespace
{

/// An error, an empty output, and no work before: each level says how far it is when it begins.
void ExpectRefused(vtkDataObject* input, Options options, const std::vector<std::string>& parts)
{
  vtkNew<Messages> messages;
  std::vector<double> values;
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(Observe);
  command->SetClientData(&values);
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  messages->Watch(filter);
  filter->AddObserver(vtkCommand::ProgressEvent, command);
  filter->SetInputDataObject(input);
  Set(filter, options);
  filter->Update();
  const auto begun = std::count_if(
    values.begin(), values.end(), [](double value) { return value > 0. && value < 1.; });
  EXPECT_EQ(begun, 0) << "levels were made before the refusal";
  const Grid result = filter->GetOutput();
  EXPECT_EQ(result->GetNumberOfCells(), 0);
  EXPECT_EQ(result->GetNumberOfPoints(), 0);
  ASSERT_FALSE(messages->Errors.empty());
  for (const std::string& part : parts)
  {
    EXPECT_NE(messages->Errors[0].find(part), std::string::npos) << messages->Errors[0];
  }
}

}

TEST(MultiDimensionalSubdivisionLimits, MaximumNumberOfCells)
{
  const Grid grid = MakeTet();
  Options options;
  options.Levels = 2;
  options.MaximumNumberOfCells = 64 + 16;
  EXPECT_EQ(Subdivide(grid, options)->GetNumberOfCells(), 80);
  options.MaximumNumberOfCells = 79;
  ExpectRefused(grid, options, { " 80 cells", "79", "3.28 kB" });
  options.Levels = 0;
  options.MaximumNumberOfCells = 1;
  ExpectRefused(grid, options, { " 2 cells" });
}

TEST(MultiDimensionalSubdivisionLimits, AbsurdLevels)
{
  Options options;
  options.Levels = 20;
  ExpectRefused(MakeTet(), options, { "cells", "47.3 EB" });
  options.Levels = 12; // 8^12 tets are some terabytes, whatever the limit says
  options.MaximumNumberOfCells = VTK_ID_MAX;
  ExpectRefused(MakeTet(), options, { "68736253952 cells", "points", "5.69 TB" });
  options.Levels = 20;
  ExpectRefused(MakeTet(), options, { "95.3 EB" });
  ExpectRefused(MakeMixedBox(1), options, { " EB" });
  ExpectRefused(MakeMixedBox(4), options, { " EB" });
}

TEST(MultiDimensionalSubdivisionLimits, ANewUpdateAfterAnErrorWorks)
{
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetInputData(MakeTet());
  filter->SetNumberOfLevels(20);
  filter->Update();
  EXPECT_FALSE(messages->Errors.empty());
  filter->SetNumberOfLevels(1);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 12);
}

TEST(MultiDimensionalSubdivisionLimits, CurvesAndVerticesTakeManyLevels)
{
  const Grid curve = MakeGrid(Corners, { { VTK_LINE, { 0, 1 } }, { VTK_VERTEX, { 3 } } });
  const Grid result = Subdivide(curve, 16);
  EXPECT_EQ(result->GetNumberOfCells(), 65536 + 1);
  EXPECT_EQ(result->GetNumberOfPoints(), 8 + 65535);
  EXPECT_EQ(Subdivide(MakeGrid(Corners, { { VTK_VERTEX, { 3 } } }), 20)->GetNumberOfPoints(), 8);
}

// ---------------------------------------------------------------- nothing to do

TEST(MultiDimensionalSubdivisionEmpty, GivesEmptyOutput)
{
  vtkNew<vtkUnstructuredGrid> nothing;
  vtkNew<vtkPolyData> noPoly;
  const Grid noPoints = MakeGrid({}, {});
  const Grid noCells = MakeGrid(Corners, {});
  AddArrays(noCells);
  const Grid onlyBad = MakeGrid({}, { { VTK_LINE, { 0, 1 } } });
  vtkNew<vtkPolyData> poly;
  poly->SetPoints(noCells->GetPoints());
  for (int levels : { 0, 1, 3 })
  {
    Options options;
    options.Levels = levels;
    options.OriginalIds = options.Classification = true;
    for (vtkDataObject* input : std::initializer_list<vtkDataObject*>{ nothing, noPoly, noPoints })
    {
      const Grid result = Subdivide(input, options);
      EXPECT_EQ(result->GetNumberOfCells(), 0);
      EXPECT_EQ(result->GetNumberOfPoints(), 0);
      EXPECT_EQ(Subdivide(result, options)->GetNumberOfPoints(), 0); // and once more
    }
    for (vtkDataObject* input : std::initializer_list<vtkDataObject*>{ noCells, poly })
    {
      const Grid result = Subdivide(input, options);
      EXPECT_EQ(result->GetNumberOfCells(), 0);
      ASSERT_EQ(result->GetNumberOfPoints(), 8);
      for (vtkIdType i = 0; i < 8; ++i)
      {
        EXPECT_EQ(GetPoint(result, i), Corners[i]);
      }
      EXPECT_EQ(result->GetPointData()->GetNumberOfArrays(), input == poly ? 3 : 8 + 3);
      EXPECT_EQ(Compare(result, Subdivide(result, options), false), "");
    }
    vtkNew<Messages> messages;
    EXPECT_EQ(Subdivide(onlyBad, options, messages)->GetNumberOfCells(), 0);
    EXPECT_EQ(messages->Warnings.size(), 1u);
    EXPECT_EQ(messages->Errors.size(), 0u);
  }
}

TEST(MultiDimensionalSubdivisionEmpty, OnlyVertices)
{
  const Grid grid = MakeGrid(Corners, { { VTK_VERTEX, { 3 } }, { VTK_POLY_VERTEX, { 0, 1, 0 } } });
  AddArrays(grid);
  for (int levels : { 0, 1, 3 })
  {
    const Grid result = Subdivide(grid, levels);
    EXPECT_EQ(GetCells(result), (std::vector<Ids>{ { 3 }, { 0 }, { 1 }, { 0 } }));
    ASSERT_EQ(result->GetNumberOfPoints(), 8);
    for (vtkIdType i = 0; i < 8; ++i)
    {
      EXPECT_EQ(GetPoint(result, i), Corners[i]);
    }
    EXPECT_EQ(Compare(result, Subdivide(grid, 2), false), "");
  }
}

// ---------------------------------------------------------------- progress; TestAborted.cxx has
// stops

TEST(MultiDimensionalSubdivisionProgress, RisesFromZeroToOne)
{
  const Grid grid = MakeMixedBox(2);
  for (int levels : { 0, 1, 2, 4 })
  {
    std::vector<double> values;
    vtkNew<vtkCallbackCommand> command;
    command->SetCallback(Observe);
    command->SetClientData(&values);
    vtkNew<vtkMultiDimensionalSubdivision> filter;
    filter->AddObserver(vtkCommand::ProgressEvent, command);
    filter->SetInputData(grid);
    filter->SetNumberOfLevels(levels);
    filter->Update();
    ASSERT_FALSE(values.empty());
    EXPECT_TRUE(std::is_sorted(values.begin(), values.end()));
    EXPECT_GE(values.front(), 0.);
    EXPECT_EQ(values.back(), 1.);
    const std::set<double> distinct(values.begin(), values.end());
    EXPECT_GE(static_cast<int>(distinct.size()), levels + 1);
  }
}
