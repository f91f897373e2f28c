// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestTetOctCache.cxx
 * What is kept with VolumeScheme = TetOct: the output is that of a new filter, diagonals included.
 */
#include "OperatorCacheTools.h"

using namespace operator_cache_tools;

namespace
{

const Configure TetOct = [](Filter* filter) { filter->SetVolumeSchemeToTetOct(); };

Grid Stretch(vtkUnstructuredGrid* grid, double x, double z)
{
  const Grid copy = DeepCopy(grid);
  for (vtkIdType i = 0; i < copy->GetNumberOfPoints(); ++i)
  {
    const Point p = GetPoint(copy, i);
    copy->GetPoints()->SetPoint(i, x * p[0], p[1], z * p[2]);
  }
  return copy;
}

}

TEST(TetOctCache, MovedPointsTurnOctahedra)
{
  Kept kept(TetOct);
  const Grid input = MakeInput();
  const Grid first = kept.Update(input);
  const Grid copy = DeepCopy(first);
  EXPECT_EQ(kept.CountBuilds(), 1);
  EXPECT_EQ(Compare(first, Fresh(input, TetOct)), "");
  const double factors[][2] = { { 4., 1. }, { 1., 3. }, { 0.2, 0.5 }, { 1., 1. } };
  bool turned = false;
  for (const auto& factor : factors)
  {
    const Grid moved = Stretch(input, factor[0], factor[1]);
    const Grid output = kept.Update(moved);
    EXPECT_EQ(Compare(output, Fresh(moved, TetOct)), "");
    turned = turned || GetCells(output) != GetCells(first);
    const Grid shifted = DeepCopy(moved); // too little to turn anything
    const Point p = GetPoint(moved, 0);
    MovePoint(shifted, 0, p[0] + 1e-9, p[1], p[2]);
    const Grid again = kept.Update(shifted);
    EXPECT_EQ(Compare(again, Fresh(shifted, TetOct)), "");
    EXPECT_TRUE(SharesCells(output, again));
    EXPECT_FALSE(SharesPoints(output, again));
  }
  EXPECT_TRUE(turned);
  EXPECT_EQ(kept.CountBuilds(), 0);
  EXPECT_EQ(Compare(first, copy), ""); // earlier outputs stay as they are
}

TEST(TetOctCache, OtherScalarsShareCellsAndPoints)
{
  for (bool narrow : { false, true })
  {
    Kept kept(
      [narrow](Filter* filter)
      {
        filter->SetVolumeSchemeToTetOct();
        filter->SetUse32BitIds(narrow);
      });
    const Grid input = MakeInput();
    const Grid first = kept.Update(input);
    const Grid other = Grid::New();
    other->ShallowCopy(input);
    other->GetPointData()->AddArray(
      MakeArray<vtkDoubleArray>("scalar", 1, input->GetNumberOfPoints(), 0., 1., 9));
    const Grid second = kept.Update(other);
    EXPECT_EQ(kept.CountBuilds(), 1);
    EXPECT_TRUE(SharesCells(first, second));
    EXPECT_TRUE(SharesPoints(first, second));
    EXPECT_EQ(Compare(second, Fresh(other, TetOct)), "");
  }
}

TEST(TetOctCache, SchemesAreKeptApart)
{
  Kept kept(TetOct);
  const Grid input = MakeInput();
  const Grid tetOct = kept.Update(input);
  kept->SetVolumeSchemeToBoxSpline();
  EXPECT_EQ(Compare(kept.Update(input), Fresh(input)), "");
  kept->SetVolumeSchemeToTetOct();
  EXPECT_EQ(Compare(kept.Update(input), tetOct), "");
  EXPECT_EQ(kept.CountBuilds(), 3);
}

TEST(TetOctCache, OtherRulesTurnOctahedraToo)
{
  Kept kept(TetOct);
  const Grid input = MakeInput();
  std::vector<int> materials;
  for (vtkIdType i = 0; i < input->GetNumberOfCells(); ++i)
  {
    materials.push_back(static_cast<int>(i % 2));
  }
  const Grid flagged = With(input, "MaterialId", materials);
  const Grid before = kept.Update(flagged);
  const Grid copy = DeepCopy(before);
  kept->DetectFeaturesOn();
  const Configure detect = [](Filter* filter)
  {
    filter->SetVolumeSchemeToTetOct();
    filter->DetectFeaturesOn();
  };
  EXPECT_EQ(Compare(kept.Update(flagged), Fresh(flagged, detect)), "");
  kept->SetCreaseEndToDart();
  EXPECT_EQ(Compare(kept.Update(flagged),
              Fresh(flagged,
                [&detect](Filter* filter)
                {
                  detect(filter);
                  filter->SetCreaseEndToDart();
                })),
    "");
  EXPECT_EQ(Compare(before, copy), "");
}

TEST(TetOctCache, FiltersInARow)
{
  vtkNew<Filter> first;
  vtkNew<Filter> second;
  first->SetVolumeSchemeToTetOct();
  second->SetVolumeSchemeToTetOct();
  second->SetInputConnection(first->GetOutputPort());
  const Grid input = MakeInput();
  AddCellArray(input, "number", std::vector<int>(input->GetNumberOfCells(), 3));
  for (double x : { 1., 5., 0.3, 1. })
  {
    const Grid moved = Stretch(input, x, 1.);
    first->SetInputDataObject(moved);
    second->Update();
    EXPECT_EQ(Compare(second->GetOutput(), Fresh(moved, TetOct)), "");
  }
}

TEST(TetOctCache, NoStepAtAll)
{
  Kept kept(
    [](Filter* filter)
    {
      filter->SetVolumeSchemeToTetOct();
      filter->SetNumberOfLevels(0);
    });
  const Grid one = Execute(MakeInput(), 1, TetOct);
  for (double x : { 1., 5., 1. })
  {
    const Grid moved = Stretch(one, x, 1.);
    const Grid output = kept.Update(moved);
    EXPECT_EQ(Compare(output, moved), ""); // nothing changes, diagonals neither
  }
  EXPECT_EQ(kept.CountBuilds(), 1);
}
