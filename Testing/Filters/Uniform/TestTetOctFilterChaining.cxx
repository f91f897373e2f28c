// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestTetOctFilterChaining.cxx
 * VolumeScheme = TetOct (Mathematics 10): several filters in a row are one filter of their levels.
 */
#include "TetOctFilterTools.h"

#include "vtkSubdivisionModelSource.h"

using namespace tet_oct_filter_tools;

namespace
{

class TetOctOfModel : public testing::TestWithParam<int>
{
};

}

TEST_P(TetOctOfModel, FiltersInARowGiveTheSame)
{
  for (int precision : { vtkAlgorithm::SINGLE_PRECISION, vtkAlgorithm::DOUBLE_PRECISION })
  {
    const Grid grid = LoadModel(GetParam(), precision);
    AddArrays(grid);
    ExpectChains(grid,
      [](Filter* filter)
      {
        filter->GenerateOriginalIdsOn();
        filter->GenerateClassificationOn();
      });
    AddGlobalIds(grid, 3);
    ExpectChains(grid, [](Filter* filter) { filter->InterpolateIntegersOn(); });
  }
}

INSTANTIATE_TEST_SUITE_P(TetOctFilter, TetOctOfModel,
  testing::Range(0, int(vtkSubdivisionModelSource::NUMBER_OF_MODELS)), [](const auto& param)
  { return std::string(vtkSubdivisionModelSource::GetModelName(param.param)); });

TEST(TetOctFilter, RandomComplexesInARow)
{
  for (unsigned seed = 1; seed <= 60; ++seed)
  {
    SCOPED_TRACE(seed);
    vtkNew<Messages> ignored;
    const Configure options = TetOct(RandomOptions(seed));
    const Grid grid = MakeRandomComplex(seed);
    const Grid three = Execute(grid, 3, options, ignored);
    const Grid one = Execute(grid, 1, options, ignored);
    EXPECT_EQ(Compare(three, Execute(one, 2, options, ignored)), "");
    EXPECT_EQ(Compare(three, Execute(Execute(one, 1, options, ignored), 1, options, ignored)), "");
    EXPECT_TRUE(ignored->Errors.empty());
  }
}

TEST(TetOctFilter, SemiSharpCreasesInARow)
{
  // A line through the inside of a solid and one on its boundary.
  const Grid grid =
    MakeOctahedron({ { VTK_LINE, { 5, 0 } }, { VTK_LINE, { 0, 6 } }, { VTK_LINE, { 1, 3 } } });
  vtkNew<vtkDoubleArray> sharpness;
  sharpness->SetName("Sharpness");
  for (double s : { 0., 0., 0., 0., 0., 0., 0., 0., 1.5, 2., 0.75 })
  {
    sharpness->InsertNextValue(s);
  }
  grid->GetCellData()->AddArray(sharpness);
  const Configure sharp = [](Filter* filter) { SetCellArray(filter, 4, "Sharpness"); };
  ExpectChains(grid, sharp);
  const Configure notKept = [sharp](Filter* filter)
  {
    sharp(filter);
    filter->CacheOperatorOff();
  };
  EXPECT_EQ(Compare(Execute(grid, 3, TetOct(sharp)), Execute(grid, 3, TetOct(notKept))), "");
  // The first step between the sharp and the smooth row of a vertex, an average of 1.5 and 2:
  // sharp.
  const MatrixRow row = Matrix(grid, TetOct(sharp)).Vertex(0);
  EXPECT_TRUE(Near(row, CurveVertex(0, 5, 6)));
  sharpness->SetValue(8, 0.5);
  sharpness->SetValue(9, 0.5);
  const MatrixRow half = Matrix(grid, TetOct(sharp)).Vertex(0);
  const MatrixRow smooth = Matrix(MakeOctahedron(), TetOct()).Vertex(0);
  ASSERT_EQ(half.size(), smooth.size());
  for (const auto& entry : smooth)
  {
    const double crease = entry.first == 0   ? 0.75
      : entry.first == 5 || entry.first == 6 ? 0.125
                                             : 0.;
    EXPECT_NEAR(half.at(entry.first), 0.5 * (crease + entry.second), 1e-15);
  }
}

TEST(TetOctFilter, ANextFilterNeedsNeitherTheArrayNorThePoints)
{
  const Grid one = Execute(MakeKuhnBox(1, 0.3), 1, TetOct());
  const Grid moved = DeepCopy(one);
  moved->GetCellData()->RemoveArray("OctahedronId");
  for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
  {
    const Point p = GetPoint(moved, i);
    moved->GetPoints()->SetPoint(i, 5. * p[0], p[1], 0.2 * p[2]); // other diagonals are shorter now
  }
  const Grid output = Execute(moved, 1, TetOct());
  ASSERT_EQ(output->GetNumberOfCells(), 6 * 64);
  const Ids octahedra = GetOctahedra(output);
  EXPECT_EQ(*std::max_element(octahedra.begin(), octahedra.end()), 59);
  // An affine map may come before or after.
  const Grid after = Execute(one, 1, TetOct());
  ASSERT_EQ(after->GetNumberOfPoints(), output->GetNumberOfPoints());
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const Point p = GetPoint(after, i);
    const Point q = GetPoint(output, i);
    EXPECT_NEAR(q[0], 5. * p[0], 1e-14);
    EXPECT_NEAR(q[2], 0.2 * p[2], 1e-14);
  }
}

TEST(TetOctFilter, TheOtherSchemeTakesPlainTetrahedra)
{
  const Grid grid = MakeKuhnBox(1, 0.3);
  for (bool first : { false, true })
  {
    const Grid one = Execute(grid, 1, first ? TetOct() : Configure());
    const Grid plain = DeepCopy(one);
    RemoveStamp(plain);
    vtkNew<Messages> messages;
    const Configure second = first ? Configure() : TetOct();
    const Grid actual = Execute(one, 1, second, messages);
    EXPECT_EQ(messages->CountWarnings("VolumeScheme"), 1);
    EXPECT_TRUE(messages->Errors.empty());
    EXPECT_EQ(Compare(actual, Execute(plain, 1, second)), "");
  }
}
