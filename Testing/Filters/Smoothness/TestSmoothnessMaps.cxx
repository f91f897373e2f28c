// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSmoothnessMaps.cxx
 * The characteristic map of a cell of the output of vtkSubdivisionSmoothness: which star it is of,
 * and where there is none. The maps themselves: TestStarMaps.cxx.
 */
#include "FeatureTools.h"

#include "vtkSubdivisionSmoothness.h"

using namespace feature_tools;

namespace
{

using Smoothness = vtkSubdivisionSmoothness;

Grid Examine(vtkDataObject* input, int scheme, vtkIdType cell, int levels = 2, bool failing = false)
{
  vtkNew<Smoothness> filter;
  filter->SetScheme(scheme);
  filter->SetMapOfCell(cell);
  filter->SetMapLevels(levels);
  filter->SetFailingOnly(failing);
  return UpdateWithoutErrors<vtkUnstructuredGrid>(filter.Get(), input);
}

/// The only error, if there is one; the output is then empty.
std::string FindError(vtkDataObject* input, int scheme, vtkIdType cell, vtkIdType most = 1000000)
{
  vtkNew<Smoothness> filter;
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetInputDataObject(input);
  filter->SetScheme(scheme);
  filter->SetMapOfCell(cell);
  filter->SetMaximumNumberOfCells(most);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells() == 0, !messages->Errors.empty());
  return messages->Errors.empty() ? std::string() : messages->Errors[0];
}

double Get(vtkUnstructuredGrid* grid, const char* name, vtkIdType cell, int component = 0)
{
  return grid->GetCellData()->GetArray(name)->GetComponent(cell, component);
}

/// The first cell of a kind whose condition holds.
vtkIdType Find(vtkUnstructuredGrid* all, int dimension, int rule, bool isSector)
{
  for (vtkIdType c = 0; c < all->GetNumberOfCells(); ++c)
  {
    if (Get(all, "SimplexDimension", c) == dimension && Get(all, "RuleDimension", c) == rule &&
      (Get(all, "Sector", c) >= 0.) == isSector && Get(all, "Condition", c) == 1.)
    {
      return c;
    }
  }
  return -1;
}

/// A map of regular cells with the eigenvalues of the cell that it is of.
void ExpectMap(vtkUnstructuredGrid* all, vtkIdType cell, vtkUnstructuredGrid* map, bool isSolid)
{
  ASSERT_GT(map->GetNumberOfCells(), 8);
  EXPECT_EQ(map->GetCellType(0) == VTK_TETRA, isSolid);
  vtkDataArray* jacobians = map->GetCellData()->GetArray("Jacobian");
  ASSERT_TRUE(jacobians);
  EXPECT_EQ(jacobians, map->GetCellData()->GetScalars());
  for (vtkIdType c = 0; c < map->GetNumberOfCells(); ++c)
  {
    EXPECT_GT(jacobians->GetComponent(c, 0), 0.);
  }
  vtkDataArray* rings = map->GetPointData()->GetArray("Ring");
  ASSERT_TRUE(rings);
  EXPECT_EQ(rings->GetNumberOfTuples(), map->GetNumberOfPoints());
  vtkDataArray* eigenvalues = map->GetFieldData()->GetArray("Eigenvalues");
  ASSERT_TRUE(eigenvalues);
  ASSERT_EQ(eigenvalues->GetNumberOfTuples(), 6);
  for (int k = 0; k < 6; ++k)
  {
    EXPECT_NEAR(eigenvalues->GetComponent(k, 0), Get(all, "Eigenvalues", cell, k), 1e-7) << k;
  }
}

}

TEST(SmoothnessMaps, OfVerticesEdgesAndFacesInsideSolids)
{
  const Grid box = MakeKuhnBox(3);
  for (const int scheme : { Smoothness::BOX_SPLINE, Smoothness::TET_OCT })
  {
    const Grid all = Examine(box, scheme, -1);
    for (int dimension = 0; dimension < 3; ++dimension)
    {
      SCOPED_TRACE(testing::Message() << "scheme " << scheme << ", dimension " << dimension);
      const vtkIdType cell = Find(all, dimension, 3, false);
      ASSERT_GE(cell, 0);
      ExpectMap(all, cell, Examine(box, scheme, cell, 1), true);
    }
    for (const bool isSector : { false, true })
    {
      const vtkIdType cell = Find(all, 0, 2, isSector);
      if (cell >= 0)
      {
        ExpectMap(all, cell, Examine(box, scheme, cell), false);
      }
    }
    const vtkIdType edge = Find(all, 1, 2, false);
    ASSERT_GE(edge, 0);
    ExpectMap(all, edge, Examine(box, scheme, edge), false);
  }
}

// A fan of seven triangles has a map of seven parts around its middle, half of one at its border.
TEST(SmoothnessMaps, OfSurfaces)
{
  const Grid fan = MakeFan(7);
  for (const int scheme : { Smoothness::LOOP, Smoothness::MODIFIED_BUTTERFLY,
         Smoothness::CATMULL_CLARK, Smoothness::FOUR_EIGHT, Smoothness::SQRT_THREE })
  {
    SCOPED_TRACE(scheme);
    const Grid all = Examine(fan, scheme, -1);
    const vtkIdType middle = Find(all, 0, 2, false);
    ASSERT_GE(middle, 0);
    const Grid map = Examine(fan, scheme, middle);
    ExpectMap(all, middle, map, false);
    EXPECT_EQ(map->GetNumberOfCells() % 7, 0);
    EXPECT_GT(Examine(fan, scheme, middle, 3)->GetNumberOfCells(), map->GetNumberOfCells());
    for (const int dimension : { 1, 2 })
    {
      const vtkIdType cell = Find(all, dimension, 2, false);
      ASSERT_GE(cell, 0);
      ExpectMap(all, cell, Examine(fan, scheme, cell), false);
    }
    const vtkIdType sector = Find(all, 0, 2, true);
    if (sector >= 0)
    {
      ExpectMap(all, sector, Examine(fan, scheme, sector), false);
    }
  }
}

TEST(SmoothnessMaps, IdsAreThoseOfTheOutput)
{
  const Grid fan = MakeFan(9);
  const Grid failing = Examine(fan, Smoothness::BOX_SPLINE, -1, 2, true);
  const Grid all = Examine(fan, Smoothness::BOX_SPLINE, -1);
  EXPECT_LT(failing->GetNumberOfCells(), all->GetNumberOfCells());
  vtkNew<Smoothness> filter;
  filter->SetMapOfCell(3);
  filter->SetMapLevels(9);
  EXPECT_EQ(filter->GetMapLevels(), 4);
  EXPECT_NE(
    FindError(fan, Smoothness::LOOP, all->GetNumberOfCells() + 9).find("has"), std::string::npos);
}

// A vertex becomes a face of as many corners, which is what repeats.
TEST(SmoothnessMaps, OfDualSchemesAreAroundFaces)
{
  const Grid fan = MakeFan(5);
  for (const int scheme : { int(Smoothness::DOO_SABIN), int(Smoothness::MIDEDGE) })
  {
    const Grid map = Examine(fan, scheme, 0);
    ASSERT_GT(map->GetNumberOfCells(), 50);
    int faces = 0;
    for (vtkIdType c = 0; c < map->GetNumberOfCells(); ++c)
    {
      EXPECT_GT(Get(map, "Jacobian", c), 0.);
      faces += map->GetCellType(c) == VTK_POLYGON ? 1 : 0;
      EXPECT_EQ(GetCell(map, c).size(), map->GetCellType(c) == VTK_POLYGON ? 5U : 4U);
    }
    EXPECT_EQ(faces, 1);
  }
}

TEST(SmoothnessMaps, WhereThereIsNoneIsSaid)
{
  const Grid fan = MakeFan(5);
  const Grid all = Examine(fan, Smoothness::LOOP, -1);
  vtkIdType curve = 0;
  while (Get(all, "RuleDimension", curve) != 1.)
  {
    ++curve;
  }
  for (const auto& [scheme, cell] : { std::make_pair(int(Smoothness::LOOP), curve),
         std::make_pair(int(Smoothness::DOO_SABIN), curve) })
  {
    const std::string error = FindError(fan, scheme, cell);
    EXPECT_NE(
      error.find("no characteristic map at cell " + std::to_string(cell)), std::string::npos)
      << error;
  }
  const std::string many = FindError(fan, Smoothness::LOOP, 1000);
  EXPECT_NE(many.find("MapOfCell is 1000, but the output has " +
              std::to_string(all->GetNumberOfCells()) + " cells"),
    std::string::npos)
    << many;
  const Grid box = MakeKuhnBox(2);
  const vtkIdType edge = Find(Examine(box, Smoothness::BOX_SPLINE, -1), 1, 3, false);
  const std::string large = FindError(box, Smoothness::BOX_SPLINE, edge, 2000);
  EXPECT_NE(large.find("Take fewer MapLevels"), std::string::npos) << large;
}
