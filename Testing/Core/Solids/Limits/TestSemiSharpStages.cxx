// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSemiSharpStages.cxx
 * Mathematics 5: what is left of sharpness at the rows of a level, number by number.
 */
#include "CoreTools.h"

#include "Core/Solids/Limits/LimitStencils.h"

using namespace coretest;

namespace
{

std::vector<std::pair<vtkIdType, double>> ListRows(const SharpParts& parts)
{
  std::vector<std::pair<vtkIdType, double>> rows;
  for (const SharpRow& row : parts.GetRows())
  {
    rows.emplace_back(row.Row, row.Sharpness);
  }
  return rows;
}

}

TEST(SemiSharpStages, NothingIsNamedBeforeItIsSet)
{
  EXPECT_EQ(SharpForever, 256);
  EXPECT_LT(std::pow(0.75, SharpForever), 1e-31);
  const SharpStage<int> stage;
  EXPECT_EQ(stage.Until, 0);
  EXPECT_EQ(stage.TetsAtSpokes, nullptr);
}

TEST(SemiSharpStages, PartsOfEdgesAndFaces)
{
  SimplexList list;
  list.NumberOfPoints = 4;
  list.Dimensions = { 2, 2 };
  list.Connectivity = { 0, 1, 2, 1, 3, 2 };
  const Subdivided<int> level = Build<int>(list);
  const auto& complex = level.Level.Complex;
  ASSERT_EQ(complex.NumberOfEdges, 5);
  ASSERT_EQ(complex.NumberOfFaces, 2);
  const int sharp = FindEdge(complex, 0, 1);
  const int* corners = complex.FaceVertices.data();
  const int face = std::count(corners, corners + 3, 3) > 0 ? 0 : 1; // that with vertex 3
  SemiSharpStages<int> stages;
  EXPECT_TRUE(ListRows(stages.ListParts(complex)).empty());
  stages.Sharpness = Buffer<double>(5, 0.);
  EXPECT_TRUE(ListRows(stages.ListParts(complex)).empty());

  // A line that is sharp: its row, and those of its ends.
  stages.Sharpness[sharp] = 0.5;
  EXPECT_EQ(ListRows(stages.ListParts(complex)),
    (std::vector<std::pair<vtkIdType, double>>{ { 0, 0.5 }, { 1, 0.5 }, { 4 + sharp, 0.5 } }));
  stages.Sharpness[sharp] = 1e300;
  EXPECT_EQ(ListRows(stages.ListParts(complex)),
    (std::vector<std::pair<vtkIdType, double>>{ { 0, 256. }, { 1, 256. }, { 4 + sharp, 256. } }));
  EXPECT_EQ(ListRows(stages.ListParts(complex, 3.))[0].second, 3.);

  // A triangle that is sharp, too: it counts where no line does.
  stages.FaceSharpness = Buffer<double>(2, 0.);
  EXPECT_EQ(ListRows(stages.ListParts(complex)).size(), 3u);
  stages.FaceSharpness[face] = 0.25;
  std::map<vtkIdType, double> expected{ { 0, 256. }, { 1, 256. }, { 4 + sharp, 256. }, { 2, 0.25 },
    { 3, 0.25 } };
  for (const auto& ends : { std::pair(1, 2), std::pair(2, 3), std::pair(1, 3) })
  {
    expected[4 + FindEdge(complex, ends.first, ends.second)] = 0.25;
  }
  const auto rows = ListRows(stages.ListParts(complex));
  EXPECT_EQ(rows, (std::vector<std::pair<vtkIdType, double>>(expected.begin(), expected.end())));
  const SharpParts parts = stages.ListParts(complex);
  EXPECT_EQ(parts.GetSharpness(1, 255.5), 0.5);
  EXPECT_EQ(parts.GetSharpness(3, 0.125), 0.125);
  EXPECT_EQ(parts.GetMostSharpness(1), 256.);
  stages.FaceSharpness[face] = 1000.;
  EXPECT_EQ(stages.ListParts(complex).GetMostSharpness(3), 256.);
}
