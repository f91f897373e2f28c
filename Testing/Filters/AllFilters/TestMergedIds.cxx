// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestMergedIds.cxx
 * Ids of points in selections and in crease geometry are those of the input, also of points that
 * MergePoints joins with others.
 */
#include "MultiDimensionalSubdivisionTools.h"
#include "SelectionTools.h"

#include "vtkAdaptiveSurfaceSubdivision.h"
#include "vtkRedGreenRefinement.h"
#include "vtkSurfaceSubdivision.h"

using namespace multi_dimensional_subdivision_tools;

namespace
{

constexpr vtkIdType Width = 6; ///< points of a row

/// Three rows of points, and two rows of quads on them. `isApart`: each row of quads has points of
/// its own, so that 12 to 17 are at the places of 6 to 11.
Grid MakeRows(bool isApart, bool hasIds)
{
  std::vector<Point> points;
  Ids ids;
  const auto add = [&](int row, vtkIdType id)
  {
    for (int i = 0; i < Width; ++i)
    {
      points.push_back(
        { static_cast<double>(i), static_cast<double>(row), 0.3 * ((5 * i + 3 * row) % 4) });
      ids.push_back(id + 100 + i);
    }
  };
  add(0, 0);
  add(1, Width);
  isApart ? add(1, 2 * Width) : void();
  add(2, 3 * Width);
  std::vector<Cell> cells;
  for (const vtkIdType begin : { vtkIdType(0), isApart ? 2 * Width : Width })
  {
    for (vtkIdType i = begin; i + 1 < begin + Width; ++i)
    {
      cells.push_back({ VTK_QUAD, { i, i + 1, i + Width + 1, i + Width } });
    }
  }
  const Grid grid = MakeGrid(points, cells);
  hasIds ? SetGlobalIds(grid, ids) : void();
  return grid;
}

/// Lines between points of the same ids.
vtkSmartPointer<vtkPolyData> MakeCreases(const std::vector<Ids>& lines, bool hasIds)
{
  const auto creases = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  Ids ids;
  for (vtkIdType i = 0; i < 4 * Width; ++i)
  {
    points->InsertNextPoint(0., 0., 0.);
    ids.push_back(100 + i);
  }
  for (const Ids& line : lines)
  {
    cells->InsertNextCell(2, line.data());
  }
  creases->SetPoints(points);
  creases->SetLines(cells);
  hasIds ? SetGlobalIds(creases, ids) : void();
  return creases;
}

/// The points of the first mesh that a filter makes without saying anything.
template <typename Filter, typename Configure>
std::vector<Point> Run(vtkDataObject* input, bool merges, const Configure& configure)
{
  vtkNew<Filter> filter;
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetInputDataObject(input);
  filter->SetMergePoints(merges);
  configure(filter.Get());
  filter->Update();
  EXPECT_TRUE(messages->Errors.empty());
  EXPECT_TRUE(messages->Warnings.empty())
    << (messages->Warnings.empty() ? "" : messages->Warnings[0]);
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  auto* made =
    vtkPointSet::SafeDownCast(blocks ? blocks->GetBlock(0) : filter->GetOutputDataObject(0));
  std::vector<Point> points;
  for (vtkIdType i = 0; i < made->GetNumberOfPoints(); ++i)
  {
    points.emplace_back();
    made->GetPoint(i, points.back().data());
  }
  return points;
}

/// Expects of lines on the rows that are apart what lines on those that are joined do.
template <typename Filter>
void CheckCreases(bool hasIds, bool hasBlocks)
{
  SCOPED_TRACE(testing::Message() << hasIds << hasBlocks);
  const auto run = [&](bool isApart, const std::vector<Ids>& lines)
  {
    const Grid grid = MakeRows(isApart, hasIds);
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(0, grid);
    vtkDataObject* input = grid;
    return Run<Filter>(hasBlocks ? blocks : input, isApart,
      [&](Filter* filter)
      {
        filter->SetInputDataObject(2, MakeCreases(lines, hasIds));
        filter->SetCreasePointsToSameId();
      });
  };
  // Global ids of the last row are the same in both.
  const Ids inner = hasIds ? Ids{ 8, 20 } : Ids{ 8, 14 };
  const Ids beside = { 7, 8 };
  EXPECT_EQ(run(true, { { 14, 20 } }), run(false, { inner }));
  EXPECT_EQ(run(true, { { 13, 14 } }), run(false, { beside }));
  EXPECT_EQ(run(true, { { 7, 14 }, { 8, 20 } }), run(false, { beside, inner }));
  EXPECT_NE(run(false, { beside }), run(false, { inner }));
}

/// The same for a selected point.
template <typename Filter, typename Configure>
void CheckSelection(const Configure& configure)
{
  const auto run = [&](bool isApart, vtkIdType point)
  {
    return Run<Filter>(MakeRows(isApart, false), isApart,
      [&](Filter* filter)
      {
        filter->SetInputDataObject(
          1, selection_tools::MakeSelection(vtkSelectionNode::POINT, { point }));
        configure(filter);
      });
  };
  for (const vtkIdType point : { 8, 12, 14, 17, 20 })
  {
    SCOPED_TRACE(point);
    EXPECT_EQ(run(true, point), run(false, point < 2 * Width ? point : point - Width));
  }
  EXPECT_NE(run(false, 8), run(false, 11));
}

}

TEST(MergedIds, CreasesOfTheSameId)
{
  for (const bool hasIds : { false, true })
  {
    CheckCreases<vtkSurfaceSubdivision>(hasIds, false);
    CheckCreases<vtkMultiDimensionalSubdivision>(hasIds, false);
  }
  CheckCreases<vtkMultiDimensionalSubdivision>(true, true);
}

TEST(MergedIds, SelectedPoints)
{
  CheckSelection<vtkSurfaceSubdivision>([](auto*) {});
  CheckSelection<vtkMultiDimensionalSubdivision>([](auto*) {});
  const auto refine = [](auto* filter)
  {
    filter->RefineByAttributeErrorOff();
    filter->RefineByGeometricErrorOff();
    filter->RefineBySelectionOn();
    filter->SetMaximumLevel(1);
  };
  CheckSelection<vtkRedGreenRefinement>(refine);
  CheckSelection<vtkAdaptiveSurfaceSubdivision>(refine);
}
