// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestStorage.cxx
 * Cells that newer VTK stores by formulas instead of numbers are read like any others.
 */
#include "MultiDimensionalSubdivisionTools.h"

#include "Private/vtkSubdivisionObjectsCompat.h"

#include "vtkRedGreenRefinement.h"

using namespace multi_dimensional_subdivision_tools;

namespace
{

/// Four tetrahedra around an edge; their types as one number, their offsets as a formula where VTK
/// can do so.
Grid MakeTets(bool byFormula)
{
  const double coordinates[6][3] = { { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 0, 1, 0 },
    { -1, 0, 0 }, { 0, -1, 0 } };
  vtkNew<vtkPoints> points;
  for (const auto& x : coordinates)
  {
    points->InsertNextPoint(x);
  }
  vtkNew<vtkCellArray> cells;
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  if (byFormula)
  {
    cells->UseFixedSizeDefaultStorage(4);
  }
#endif
  Grid grid = Grid::New();
  grid->SetPoints(points);
  vtkNew<vtkUnsignedCharArray> types;
  for (vtkIdType i = 0; i < 4; ++i)
  {
    const vtkIdType ids[4] = { 0, 1, 2 + i, 2 + (i + 1) % 4 };
    cells->InsertNextCell(4, ids);
    types->InsertNextValue(VTK_TETRA);
  }
  byFormula ? grid->SetCells(VTK_TETRA, cells) : grid->SetCells(types, cells);
  return grid;
}

}

TEST(Storage, CellsByFormulaAreReadLikeOthers)
{
  for (int levels : { 0, 1, 3 })
  {
    Options options;
    options.Levels = levels;
    const Grid expected = Subdivide(MakeTets(false), options);
    EXPECT_EQ(expected->GetNumberOfCells(), 4 << (3 * levels));
    EXPECT_EQ(Compare(expected, Subdivide(MakeTets(true), options)), "") << levels;
  }
}

TEST(Storage, RedGreenRefinementReadsCellsByFormula)
{
  vtkIdType cells[2];
  for (bool byFormula : { false, true })
  {
    vtkNew<vtkRedGreenRefinement> filter;
    filter->SetInputData(MakeTets(byFormula));
    filter->RefineByAttributeErrorOff();
    filter->RefineByEdgeLengthOn();
    filter->SetMaximumEdgeLength(1.2);
    filter->SetMaximumLevel(2);
    filter->Update();
    cells[byFormula] = filter->GetOutput()->GetNumberOfCells();
  }
  EXPECT_GT(cells[0], 4);
  EXPECT_EQ(cells[0], cells[1]);
}
