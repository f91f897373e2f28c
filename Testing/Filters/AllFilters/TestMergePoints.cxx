// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestMergePoints.cxx
 * MergePoints gives what a mesh gives whose cells share points by hand, bit for bit.
 */
#include "FeatureTools.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"
#include "vtkSurfaceSubdivision.h"

#include <limits>

using namespace feature_tools;

namespace
{

const Configure Merge = [](Filter* filter) { filter->MergePointsOn(); };

void AddValues(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkDoubleArray> values;
  values->SetName("values");
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(static_cast<double>(i * i % 7));
  }
  grid->GetPointData()->AddArray(values);
}

void SetGlobalIds(vtkUnstructuredGrid* grid, const std::vector<vtkIdType>& ids)
{
  vtkNew<vtkIdTypeArray> array;
  array->SetName("ids");
  for (const vtkIdType id : ids)
  {
    array->InsertNextValue(id);
  }
  grid->GetPointData()->SetGlobalIds(array);
}

/// A tetrahedron, and cells on its faces that have points of their own: 0 = 4, 1 = 5, 2 = 6 = 8.
const std::vector<Point> Touching = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
  { -0., 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, -1 }, { 0, 1, 0 }, { 2, 2, 2 } };

Grid MakeTouching(const std::vector<Cell>& cells)
{
  const Grid grid = MakeGrid(Touching, cells);
  AddValues(grid);
  return grid;
}

}

TEST(MergePoints, CellsShareTheFirstOfThePointsAtAPlace)
{
  const Grid apart = MakeTouching(
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 5, 4, 6, 7 } }, { VTK_LINE, { 8, 9 } } });
  const Grid joined = MakeTouching(
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 1, 0, 2, 7 } }, { VTK_LINE, { 2, 9 } } });
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
    { { VTK_TETRA, { 4, 1, 8, 3 } }, { VTK_TETRA, { 1, 4, 8, 7 } }, { VTK_LINE, { 8, 9 } } });
  SetGlobalIds(apart, ids);
  SetGlobalIds(joined, ids);
  EXPECT_EQ(Compare(Execute(apart, 2, Merge), Execute(joined, 2)), "");
}

TEST(MergePoints, ACellWithTwoPointsAtOnePlaceIsDegenerate)
{
  const Grid grid = MakeTouching({ { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TRIANGLE, { 6, 8, 9 } } });
  vtkNew<Messages> messages;
  const Grid result = Execute(grid, 1, Merge, messages);
  EXPECT_EQ(result->GetNumberOfCells(), 8);
  EXPECT_EQ(messages->CountWarnings("repeated point ids"), 1);
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
    const Grid result = Execute(grid.Get(), 0, Merge);
    std::set<vtkIdType> used;
    for (const Ids& cell : GetCells(result))
    {
      used.insert(cell.begin(), cell.end());
    }
    EXPECT_EQ(used.count(4) + used.count(5) + used.count(6), isDoubled ? 3u : 0u);
  }
}

TEST(MergePoints, BlocksOfAComposite)
{
  vtkNew<vtkMultiBlockDataSet> blocks[2];
  for (const int merged : { 0, 1 })
  {
    const vtkIdType shift = merged ? 0 : 4;
    blocks[merged]->SetBlock(0,
      MakeTouching(
        { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 1 + shift, 0 + shift, 2 + shift, 7 } } }));
    blocks[merged]->SetBlock(1, MakeTouching({ { VTK_LINE, { 2 + shift, 9 } } }));
  }
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
    filter->SetMergePoints(merges);
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPolys(), 24);
    // 24 points of the input, then 6 of faces, and 12 or 24 of edges.
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 24 + 6 + (merges ? 12 : 24));
  }
}
