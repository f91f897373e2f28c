// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestMechanicalPart.cxx
 * What the mechanical part of vtkSubdivisionModelSource promises beyond all models: its rims and
 * its singular cells.
 */
#include "Precompiled.h"

#include "vtkSubdivisionModelSource.h"

#include "vtkCellType.h"
#include "vtkDataArray.h"

namespace
{

using Simplex = std::vector<vtkIdType>; // sorted

vtkSmartPointer<vtkUnstructuredGrid> MakePart()
{
  vtkNew<vtkSubdivisionModelSource> source;
  source->SetModelToMechanicalPart();
  source->Update();
  return source->GetOutput();
}

}

TEST(MechanicalPart, RimsAreClosedLoopsOfEightFlaggedLines)
{
  const vtkSmartPointer<vtkUnstructuredGrid> grid = MakePart();
  vtkDataArray* singular = grid->GetCellData()->GetArray("Singular");
  std::map<double, std::map<vtkIdType, int>> linesAtHeight; // of points around the hole's axis
  std::map<double, int> loops;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    if (grid->GetCellType(i) != VTK_LINE || singular->GetTuple1(i) == 0.0)
    {
      continue;
    }
    vtkNew<vtkIdList> ids;
    grid->GetCellPoints(i, ids);
    double a[3], b[3];
    grid->GetPoint(ids->GetId(0), a);
    grid->GetPoint(ids->GetId(1), b);
    if (std::hypot(a[0], a[1]) < 1.0 && std::hypot(b[0], b[1]) < 1.0)
    {
      EXPECT_EQ(a[2], b[2]);
      ++loops[a[2]];
      ++linesAtHeight[a[2]][ids->GetId(0)];
      ++linesAtHeight[a[2]][ids->GetId(1)];
      EXPECT_NEAR(std::hypot(a[0], a[1]), 0.9, 1e-3);
    }
  }
  ASSERT_EQ(loops.size(), 2u);
  for (const auto& loop : loops)
  {
    EXPECT_EQ(loop.second, 8);
    EXPECT_EQ(linesAtHeight[loop.first].size(), 8u);
    for (const auto& point : linesAtHeight[loop.first])
    {
      EXPECT_EQ(point.second, 2);
    }
  }
}

TEST(MechanicalPart, SingularCellsAreFacesOfTheSolidAndFlat)
{
  const vtkSmartPointer<vtkUnstructuredGrid> grid = MakePart();
  std::set<Simplex> faces;
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    grid->GetCellPoints(c, ids);
    const Simplex cell(ids->begin(), ids->end());
    for (int mask = 1; cell.size() == 4 && mask < 15; ++mask)
    {
      Simplex face;
      for (int i = 0; i < 4; ++i)
      {
        if ((mask >> i) & 1)
        {
          face.push_back(cell[i]);
        }
      }
      std::sort(face.begin(), face.end());
      faces.insert(face);
    }
  }
  vtkDataArray* singular = grid->GetCellData()->GetArray("Singular");
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    if (singular->GetTuple1(i) != 0.0)
    {
      grid->GetCellPoints(i, ids);
      Simplex cell(ids->begin(), ids->end());
      std::sort(cell.begin(), cell.end());
      EXPECT_EQ(faces.count(cell), 1u);
      std::set<double> x, z;
      for (vtkIdType id : cell)
      {
        x.insert(grid->GetPoint(id)[0]);
        z.insert(grid->GetPoint(id)[2]);
      }
      EXPECT_TRUE(x.size() == 1 || z.size() == 1); // the end, or the bottom or the top
    }
  }
}
