// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestFeaturesSemiSharp.cxx
 * Creases that are sharp for some levels (array index 4).
 */
#include "FeatureTools.h"

using namespace feature_tools;

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();
const Configure Sharp = [](Filter* filter) { SetCellArray(filter, 4, "Sharpness"); };

/// A fan of six triangles with lines 1-0-4 across its middle, of sharpness a and b.
Grid MakeSharpFan(double a, double b)
{
  const Grid fan = MakeFan(6, { { VTK_LINE, { 1, 0 } }, { VTK_LINE, { 0, 4 } } });
  vtkNew<vtkDoubleArray> sharpness;
  sharpness->SetName("Sharpness");
  for (double s : { 0., 0., 0., 0., 0., 0., a, b })
  {
    sharpness->InsertNextValue(s);
  }
  fan->GetCellData()->AddArray(sharpness);
  return fan;
}

const MatrixRow SmoothVertex = SurfaceVertex(0, { 1, 2, 3, 4, 5, 6 });

std::vector<double> GetSharpnessOfLines(vtkUnstructuredGrid* grid)
{
  std::vector<double> values;
  vtkDataArray* array = grid->GetCellData()->GetArray("Sharpness");
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    if (grid->GetCellType(cell) == VTK_LINE)
    {
      values.push_back(array->GetComponent(cell, 0));
    }
  }
  return values;
}

}

TEST(FeaturesSemiSharp, FullyFractionallyAndNotAtAll)
{
  for (double s : { 0., 0.25, 0.5, 1., 3., Infinity })
  {
    const Matrix fan(MakeSharpFan(s, s), Sharp);
    const double weight = std::min(1., s);
    EXPECT_TRUE(Near(fan.Vertex(0), Blend(weight, CurveVertex(0, 1, 4), SmoothVertex))) << s;
    EXPECT_TRUE(Near(fan.Edge(0, 1), Blend(weight, CurveEdge(0, 1), SurfaceEdge(0, 1, 2, 6)))) << s;
    EXPECT_TRUE(Near(fan.Edge(0, 2), SurfaceEdge(0, 2, 1, 3))) << s;
  }
}

TEST(FeaturesSemiSharp, AVertexTakesTheMeanOfItsSharpEdges)
{
  const Matrix fan(MakeSharpFan(0.25, 0.5), Sharp);
  EXPECT_TRUE(Near(fan.Vertex(0), Blend(0.375, CurveVertex(0, 1, 4), SmoothVertex)));
  EXPECT_TRUE(Near(fan.Edge(0, 1), Blend(0.25, CurveEdge(0, 1), SurfaceEdge(0, 1, 2, 6))));
  EXPECT_TRUE(Near(fan.Edge(0, 4), Blend(0.5, CurveEdge(0, 4), SurfaceEdge(0, 4, 3, 5))));
  // One sharp edge alone is a crease that ends here.
  const Matrix end(MakeSharpFan(0.25, 0.), Sharp);
  EXPECT_TRUE(Near(end.Vertex(0), Blend(0.25, Corner(0), SmoothVertex)));
}

TEST(FeaturesSemiSharp, ChildrenCarryWhatIsLeft)
{
  const Grid one = Execute(MakeSharpFan(2.5, Infinity), 1, Sharp);
  EXPECT_EQ(GetSharpnessOfLines(one), (std::vector<double>{ 1.5, 1.5, Infinity, Infinity }));
  const Grid three = Execute(MakeSharpFan(2.5, 0.5), 3, Sharp);
  EXPECT_EQ(GetSharpnessOfLines(three), std::vector<double>(16, 0.));
}

TEST(FeaturesSemiSharp, InfiniteIsSingularAndLargeIsForAsManyLevels)
{
  const Grid flagged = MakeFlaggedFan(6, { { VTK_LINE, { 1, 0 } }, { VTK_LINE, { 0, 4 } } });
  const Grid expected = Execute(flagged, 3);
  for (double s : { 3., 7., Infinity })
  {
    const Grid sharp = Execute(MakeSharpFan(s, s), 3, Sharp);
    for (vtkIdType p = 0; p < expected->GetNumberOfPoints(); ++p)
    {
      for (int k = 0; k < 3; ++k) // the same rows, summed in another order
      {
        EXPECT_NEAR(GetPoint(sharp, p)[k], GetPoint(expected, p)[k], 1e-15) << s;
      }
    }
  }
}

TEST(FeaturesSemiSharp, FiltersInARowAreOne)
{
  for (double a : { 0.5, 1., 1.5, 2.25, 3. })
  {
    const Grid input = MakeSharpFan(a, 1.25);
    const Grid direct = Execute(input, 3, Sharp);
    Grid chained = Execute(input, 0, Sharp);
    for (int i = 0; i < 3; ++i)
    {
      chained = Execute(chained, 1, Sharp);
    }
    EXPECT_EQ(Compare(direct, chained), "") << a;
  }
}

TEST(FeaturesSemiSharp, BadValuesAreSaid)
{
  for (double bad : { -1., std::numeric_limits<double>::quiet_NaN() })
  {
    vtkNew<Messages> messages;
    const Grid result = Execute(MakeSharpFan(bad, 0.), 1, Sharp, messages);
    ASSERT_EQ(messages->Warnings.size(), 1u);
    EXPECT_NE(messages->Warnings[0].find("Sharpness"), std::string::npos);
    EXPECT_NE(messages->Warnings[0].find("cell 6"), std::string::npos);
    EXPECT_EQ(GetPoint(result, 0), GetPoint(Execute(MakeSharpFan(0., 0.), 1, Sharp), 0));
  }
}

TEST(FeaturesSemiSharp, IsKeptWithTheOperator)
{
  const Grid input = MakeSharpFan(1.5, 0.75);
  vtkNew<Filter> filter;
  Sharp(filter);
  filter->SetNumberOfLevels(2);
  filter->SetInputData(input);
  filter->Update();
  input->GetPoints()->SetPoint(0, 0.1, 0.2, 0.7);
  input->GetPoints()->Modified();
  input->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfTopologyBuilds(), 1);
  EXPECT_EQ(Compare(filter->GetOutput(), Execute(input, 2, Sharp)), "");
  input->GetCellData()->GetArray("Sharpness")->SetComponent(6, 0, 1.);
  input->GetCellData()->GetArray("Sharpness")->Modified();
  input->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfTopologyBuilds(), 2);
  EXPECT_EQ(Compare(filter->GetOutput(), Execute(input, 2, Sharp)), "");
}
