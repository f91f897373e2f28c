// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestHandedness.cxx
 * Images and structured grids that are left-handed give solids that are not inside out.
 */
#include "MultiDimensionalSubdivisionTools.h"

#include "vtkExplicitStructuredGrid.h"
#include "vtkImageData.h"
#include "vtkRectilinearGrid.h"
#include "vtkRedGreenRefinement.h"
#include "vtkStructuredGrid.h"

using namespace multi_dimensional_subdivision_tools;

namespace
{

using DataSet = vtkSmartPointer<vtkDataSet>;

/// The points of a box, along x from the first to the last or, mirrored, the other way.
vtkSmartPointer<vtkPoints> MakePoints(bool isMirrored)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  for (int i = 0; i < 36; ++i)
  {
    const double x = i % 4;
    points->InsertNextPoint((isMirrored ? -1.2 : 1.2) * x, i / 4 % 3 + 0.1 * x, i / 12);
  }
  return points;
}

std::vector<DataSet> MakeGrids(bool isMirrored)
{
  vtkNew<vtkImageData> turned;
  turned->SetDimensions(4, 3, 3);
  turned->SetDirectionMatrix(0, 1, 0, isMirrored ? 1 : -1, 0, 0, 0, 0, 1);
  vtkNew<vtkImageData> spaced;
  spaced->SetDimensions(4, 3, 3);
  spaced->SetSpacing(1., isMirrored ? -.5 : .5, 2.);
  vtkNew<vtkRectilinearGrid> rectilinear;
  rectilinear->SetDimensions(4, 3, 3);
  for (int axis = 0; axis < 3; ++axis)
  {
    vtkNew<vtkDoubleArray> along;
    for (int i = 0; i < (axis == 0 ? 4 : 3); ++i)
    {
      along->InsertNextValue((isMirrored && axis == 2 ? -1. : 1.) * (i + .1 * i * i));
    }
    (axis == 0      ? rectilinear->SetXCoordinates(along)
        : axis == 1 ? rectilinear->SetYCoordinates(along)
                    : rectilinear->SetZCoordinates(along));
  }
  vtkNew<vtkStructuredGrid> structured;
  structured->SetDimensions(4, 3, 3);
  structured->SetPoints(MakePoints(isMirrored));
  vtkNew<vtkExplicitStructuredGrid> byCells;
  byCells->SetDimensions(4, 3, 3);
  byCells->SetPoints(MakePoints(isMirrored));
  vtkNew<vtkCellArray> cells;
  for (vtkIdType c = 0; c < structured->GetNumberOfCells(); ++c)
  {
    vtkNew<vtkIdList> ids;
    structured->GetCellPoints(c, ids);
    cells->InsertNextCell(ids);
  }
  byCells->SetCells(cells);
  return { turned.Get(), spaced.Get(), rectilinear.Get(), structured.Get(), byCells.Get() };
}

int CountInverted(vtkUnstructuredGrid* grid)
{
  int count = 0;
  for (const Ids& cell : GetCells(grid))
  {
    count += cell.size() == 4 && GetSignedVolume(grid, cell) <= 0. ? 1 : 0;
  }
  return count;
}

}

TEST(Handedness, SolidsOfGridsArePositive)
{
  for (const bool isMirrored : { false, true })
  {
    for (const DataSet& data : MakeGrids(isMirrored))
    {
      SCOPED_TRACE(std::string(data->GetClassName()) + (isMirrored ? ", mirrored" : ""));
      const Grid smooth = Subdivide(data, 1);
      EXPECT_GT(smooth->GetNumberOfCells(), 100);
      EXPECT_EQ(CountInverted(smooth), 0);
      vtkNew<vtkRedGreenRefinement> refine;
      refine->RefineByAttributeErrorOff();
      const Grid refined = UpdateWithoutErrors<vtkUnstructuredGrid>(refine.Get(), data);
      EXPECT_GT(refined->GetNumberOfCells(), 10);
      EXPECT_EQ(CountInverted(refined), 0);
    }
  }
}

TEST(Handedness, FewInvertedCellsOfAGridStay)
{
  vtkNew<vtkStructuredGrid> grid;
  grid->SetDimensions(4, 3, 3);
  grid->SetPoints(MakePoints(false));
  grid->GetPoints()->SetPoint(0, 9., 0.1, -0.01); // the first cell is turned over
  EXPECT_GT(CountInverted(Subdivide(grid, 0)), 0);
  vtkNew<vtkStructuredGrid> plain;
  plain->SetDimensions(4, 3, 3);
  plain->SetPoints(MakePoints(false));
  EXPECT_EQ(CountInverted(Subdivide(plain, 0)), 0);
}

TEST(Handedness, UnstructuredCellsStayAsTheyAre)
{
  const Grid tet = MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, -1 } }, { { VTK_TETRA, { 0, 1, 2, 3 } } });
  EXPECT_EQ(CountInverted(Subdivide(tet, 0)), 1);
}
