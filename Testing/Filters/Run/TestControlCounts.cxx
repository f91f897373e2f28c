// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestControlCounts.cxx
 * What cells are before the first level, as panels count them.
 */
#include "vtkCellType.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiDimensionalSubdivision.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace
{

using Counts = std::array<double, 9>;

Counts CountOf(vtkDataObject* input, vtkMultiDimensionalSubdivision* filter)
{
  filter->SetInputDataObject(input);
  Counts counts;
  std::copy_n(filter->GetControlCounts(), counts.size(), counts.begin());
  return counts;
}

/// A cell of each of these types and sizes, far from the others.
vtkNew<vtkUnstructuredGrid> MakeGrid(const std::vector<std::pair<int, vtkIdType>>& cells)
{
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  grid->SetPoints(points);
  for (const auto& [type, size] : cells)
  {
    std::vector<vtkIdType> ids;
    for (vtkIdType i = 0; i < size; ++i)
    {
      ids.push_back(
        points->InsertNextPoint(static_cast<double>(points->GetNumberOfPoints()), i % 2, i % 3));
    }
    grid->InsertNextCell(type, size, ids.data());
  }
  return grid;
}

}

TEST(ControlCounts, OfCellsOfAllDimensions)
{
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  EXPECT_EQ(filter->GetControlCounts()[5], 0.);
  const auto grid =
    MakeGrid({ { VTK_VERTEX, 1 }, { VTK_POLY_LINE, 4 }, { VTK_TRIANGLE, 3 }, { VTK_POLYGON, 5 },
      { VTK_TETRA, 4 }, { VTK_WEDGE, 6 }, { VTK_PYRAMID, 5 }, { VTK_HEXAHEDRON, 8 } });
  EXPECT_EQ(CountOf(grid, filter), (Counts{ 1., 3., 4., 12., 8., 8., 4., 1., 3. }));
}

/// They are kept, since a panel asks often, and found anew where the input changes.
TEST(ControlCounts, FollowTheInput)
{
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  const auto grid = MakeGrid({ { VTK_LINE, 2 } });
  EXPECT_EQ(CountOf(grid, filter)[1], 1.);
  const vtkIdType ids[] = { 0, 1 };
  grid->InsertNextCell(VTK_LINE, 2, ids);
  grid->Modified();
  EXPECT_EQ(CountOf(grid, filter)[1], 2.);
  EXPECT_EQ(CountOf(MakeGrid({ { VTK_TETRA, 4 } }), filter),
    (Counts{ 0., 0., 0., 1., 0., 1., 0., 0., 1. }));
}

TEST(ControlCounts, OfImagesAndBlocks)
{
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  vtkNew<vtkImageData> image;
  image->SetDimensions(300, 300, 300);
  constexpr double voxels = 299. * 299. * 299.;
  EXPECT_EQ(
    CountOf(image, filter), (Counts{ 0., 0., 0., 6. * voxels, 0., voxels, 0., 0., voxels }));
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, image);
  blocks->SetBlock(1, MakeGrid({ { VTK_QUAD, 4 } }));
  EXPECT_EQ(
    CountOf(blocks, filter), (Counts{ 0., 0., 2., 6. * voxels, 4., voxels + 1., 1., 0., voxels }));
}
