// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestFeaturesSemiSharpFaces.cxx
 * Surfaces inside of solids, and interfaces, that are sharp for some levels (array index 4).
 */
#include "TetOctFilterTools.h"

using namespace tet_oct_filter_tools;

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

void Sharp(Filter* filter)
{
  SetCellArray(filter, 4, "Sharpness");
}

const Configure Schemes[] = { Sharp, TetOct(Sharp) };

/// An octahedron with triangles across its middle, and lines 1-0-2 in them, and their sharpness.
/// The materials above and below differ.
Grid MakeSharpOctahedron(
  const std::vector<double>& triangles, const std::vector<double>& lines = {})
{
  std::vector<Cell> cells{ { VTK_TRIANGLE, { 0, 1, 3 } }, { VTK_TRIANGLE, { 0, 3, 2 } },
    { VTK_TRIANGLE, { 0, 2, 4 } }, { VTK_TRIANGLE, { 0, 4, 1 } } };
  cells.resize(triangles.size());
  if (!lines.empty())
  {
    cells.push_back({ VTK_LINE, { 1, 0 } });
    cells.push_back({ VTK_LINE, { 0, 2 } });
  }
  const Grid grid = MakeOctahedron(cells);
  vtkNew<vtkDoubleArray> sharpness;
  sharpness->SetName("Sharpness");
  sharpness->SetNumberOfValues(8);
  sharpness->Fill(0.);
  for (const auto& values : { triangles, lines })
  {
    for (const double s : values)
    {
      sharpness->InsertNextValue(s);
    }
  }
  grid->GetCellData()->AddArray(sharpness);
  std::vector<int> materials{ 1, 1, 1, 1, 2, 2, 2, 2 };
  materials.resize(static_cast<std::size_t>(grid->GetNumberOfCells()), 0);
  AddCellArray(grid, "Material", materials);
  return grid;
}

const MatrixRow SharpVertex = SurfaceVertex(0, { 1, 2, 3, 4 });

void ExpectSamePoints(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b, double tolerance)
{
  const vtkIdType points = std::min(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  for (vtkIdType p = 0; p < points; ++p)
  {
    for (int k = 0; k < 3; ++k)
    {
      ASSERT_NEAR(GetPoint(a, p)[k], GetPoint(b, p)[k], tolerance) << "point " << p;
    }
  }
}

}

TEST(FeaturesSemiSharpFaces, FullyFractionallyAndNotAtAll)
{
  for (const Configure& scheme : Schemes)
  {
    const Matrix smooth(MakeSharpOctahedron({}), scheme);
    for (const double s : { 0.25, 0.5, 1., 3., Infinity })
    {
      const Matrix solid(MakeSharpOctahedron({ s, s, s, s }), scheme);
      const double weight = std::min(1., s);
      EXPECT_TRUE(Near(solid.Vertex(0), Blend(weight, SharpVertex, smooth.Vertex(0)))) << s;
      EXPECT_TRUE(
        Near(solid.Edge(0, 1), Blend(weight, SurfaceEdge(0, 1, 3, 4), smooth.Edge(0, 1))));
      EXPECT_TRUE(Near(solid.Edge(1, 3), Blend(weight, CurveEdge(1, 3), smooth.Edge(1, 3))));
      EXPECT_TRUE(Near(solid.Edge(0, 5), smooth.Edge(0, 5)));
    }
  }
}

TEST(FeaturesSemiSharpFaces, RowsTakeTheMeanOfTrianglesAndLinesDecide)
{
  const Matrix smooth(MakeSharpOctahedron({}), Sharp);
  const Matrix mean(MakeSharpOctahedron({ 0.25, 0.5, 0.5, 0.75 }), Sharp);
  EXPECT_TRUE(Near(mean.Vertex(0), Blend(0.5, SharpVertex, smooth.Vertex(0))));
  EXPECT_TRUE(Near(mean.Edge(0, 3), Blend(0.375, SurfaceEdge(0, 3, 1, 2), smooth.Edge(0, 3))));
  const Matrix both(MakeSharpOctahedron({ 3., 3., 3., 3. }, { 0.5, 0.25 }), Sharp);
  EXPECT_TRUE(Near(both.Vertex(0), Blend(0.375, CurveVertex(0, 1, 2), smooth.Vertex(0))));
  EXPECT_TRUE(Near(both.Edge(0, 1), Blend(0.5, CurveEdge(0, 1), smooth.Edge(0, 1))));
  EXPECT_TRUE(Near(both.Edge(0, 3), SurfaceEdge(0, 3, 1, 2)));
}

TEST(FeaturesSemiSharpFaces, LargeIsFlaggedForAsManyLevels)
{
  for (const Configure& scheme : Schemes)
  {
    const Grid flagged = Execute(MakeSharpOctahedron({ Infinity, Infinity, Infinity }), 3, scheme);
    ExpectSamePoints(Execute(MakeSharpOctahedron({ 3., 7., 3. }), 3, scheme), flagged, 1e-15);
    const Grid less = Execute(MakeSharpOctahedron({ 2., 2., 2. }), 3, scheme);
    EXPECT_NE(GetPoint(less, 0), GetPoint(flagged, 0));
  }
}

TEST(FeaturesSemiSharpFaces, FiltersInARowAreOneAndChildrenCarryWhatIsLeft)
{
  for (const double a : { 0.5, 1., 1.5, 2.25, 3. })
  {
    const Grid input = MakeSharpOctahedron({ a, 1.25, a }, { 0.75, 2. });
    for (const Configure& scheme : Schemes)
    {
      const Grid direct = Execute(input, 3, scheme);
      const Grid one = Execute(input, 1, scheme);
      EXPECT_EQ(
        one->GetCellData()->GetArray("Sharpness")->GetComponent(64, 0), std::max(a - 1., 0.));
      EXPECT_EQ(Compare(direct, Execute(Execute(one, 1, scheme), 1, scheme)), "") << a;
      const Configure notKept = [&scheme](Filter* filter)
      {
        scheme(filter);
        filter->CacheOperatorOff();
      };
      EXPECT_EQ(Compare(direct, Execute(input, 3, notKept)), "") << a;
    }
  }
}

TEST(FeaturesSemiSharpFaces, InterfacesStayForAsManyLevels)
{
  for (const Configure& scheme : Schemes)
  {
    const Configure interfaces = [&scheme](Filter* filter)
    {
      scheme(filter);
      SetCellArray(filter, 1, "Material");
      filter->PreserveInterfacesOn();
    };
    // Triangles with a sharpness decide; interfaces without one stay for ever.
    const Grid all = MakeSharpOctahedron({ 1.5, 1.5, 0.5, 0.5 });
    ExpectSamePoints(Execute(all, 3, interfaces), Execute(all, 3, scheme), 1e-15);
    const Grid some = MakeSharpOctahedron({ 1.5, 1.5, 0., 0. });
    const Grid flagged = MakeSharpOctahedron({ 1.5, 1.5, Infinity, Infinity });
    ExpectSamePoints(Execute(some, 3, interfaces), Execute(flagged, 3, scheme), 1e-15);
    // So do marks.
    const Grid marks = MakeGrid(
      std::vector<Point>(7), { { VTK_TRIANGLE, { 0, 1, 3 } }, { VTK_TRIANGLE, { 0, 3, 2 } } });
    vtkNew<vtkDoubleArray> sharpness;
    sharpness->SetName("Sharpness");
    sharpness->InsertNextValue(1.5);
    sharpness->InsertNextValue(1.5);
    marks->GetCellData()->AddArray(sharpness);
    const Grid marked = Execute(MakeSharpOctahedron({}), 3,
      [&](Filter* filter)
      {
        interfaces(filter);
        filter->SetInputDataObject(2, marks);
        filter->SetCreasePointsToSameId();
      });
    for (vtkIdType p = 0; p < 7; ++p) // the cells are others, and so are new points
    {
      const Point expected = GetPoint(Execute(some, 3, interfaces), p);
      for (int k = 0; k < 3; ++k)
      {
        EXPECT_NEAR(GetPoint(marked, p)[k], expected[k], 1e-15) << p;
      }
    }
    const Grid one = Execute(some, 1, interfaces);
    EXPECT_EQ(Compare(Execute(some, 3, interfaces), Execute(one, 2, interfaces)), "");
    EXPECT_NE(GetPoint(Execute(some, 3, interfaces), 0), GetPoint(Execute(all, 3, interfaces), 0));
  }
}

TEST(FeaturesSemiSharpFaces, TheLimitDoesNotDependOnTheLevel)
{
  const Grid input = MakeSharpOctahedron({ 2.75, 1.25, 0.5, 1. }, { 0.75, 2. });
  const Grid smooth = MakeSharpOctahedron({});
  for (const Configure& scheme : Schemes)
  {
    const Configure limit = [&scheme](Filter* filter)
    {
      scheme(filter);
      filter->ProjectToLimitOn();
    };
    const Grid first = Execute(input, 0, limit);
    EXPECT_GT(std::abs(GetPoint(first, 0)[2] - GetPoint(Execute(smooth, 0, limit), 0)[2]), 1e-3);
    for (const int levels : { 1, 2, 4 })
    {
      ExpectSamePoints(Execute(input, levels, limit), first, 1e-13);
    }
  }
}

TEST(FeaturesSemiSharpFaces, SolidsHaveNone)
{
  const Grid solids = MakeSharpOctahedron({ 1. });
  solids->GetCellData()->GetArray("Sharpness")->SetComponent(3, 0, 9.);
  vtkNew<Messages> messages;
  Execute(solids, 1, Sharp, messages);
  ASSERT_EQ(messages->Warnings.size(), 1u);
  EXPECT_NE(messages->Warnings[0].find("cell 3"), std::string::npos);
}
