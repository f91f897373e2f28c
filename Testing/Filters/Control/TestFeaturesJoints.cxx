// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestFeaturesJoints.cxx
 * Rules of non-manifold vertices and edges (Mathematics 6), on the smallest complexes that have
 * them.
 */
#include "FeatureTools.h"

using namespace feature_tools;

namespace
{

const std::vector<Point> Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
  { 0, -1, -1 }, { -1, 0, 0.5 }, { -1, -1, 0.2 }, { -0.5, 0.5, -0.6 } };

std::vector<Point> First(int n)
{
  return std::vector<Point>(Points.begin(), Points.begin() + n);
}

/// A triangle with a line at vertex 0.
Grid MakeFlag()
{
  return MakeGrid(First(4), { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_LINE, { 0, 3 } } });
}

/// A tetrahedron with a triangle at its edge 0 1.
Grid MakeFin()
{
  return MakeGrid(First(5), { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TRIANGLE, { 0, 1, 4 } } });
}

/// Three triangles at the edge 0 1.
Grid MakeBook(const std::vector<Cell>& before = {}, const std::vector<Cell>& after = {})
{
  std::vector<Cell> cells = before;
  for (vtkIdType i = 2; i < 5; ++i)
  {
    cells.push_back({ VTK_TRIANGLE, { 0, 1, i } });
  }
  cells.insert(cells.end(), after.begin(), after.end());
  return MakeGrid(First(6), cells);
}

/// Lines from vertex 0 to 1 to n.
Grid MakeStar(int n)
{
  std::vector<Cell> cells;
  for (vtkIdType i = 1; i <= n; ++i)
  {
    cells.push_back({ VTK_LINE, { 0, i } });
  }
  return MakeGrid(First(n + 1), cells);
}

/// Points 0 and 1 are the ends of an edge, and others are joined to both: 7 and 8 to one end by a
/// line, to the other by a cell of `type`; 9 to both by such cells. None spans a triangle with
/// both.
void AddNeighbours(int type, std::vector<Cell>& cells)
{
  vtkIdType next = 10;
  auto join = [&](vtkIdType a, vtkIdType b)
  {
    std::vector<vtkIdType> points{ a, b };
    for (; points.size() < (type == VTK_TETRA ? 4u : 3u); ++next)
    {
      points.push_back(next);
    }
    cells.push_back({ type, points });
  };
  cells.push_back({ VTK_LINE, { 0, 7 } });
  join(1, 7);
  cells.push_back({ VTK_LINE, { 1, 8 } });
  join(0, 8);
  join(0, 9);
  join(1, 9);
}

Grid MakeEdgeWithNeighbours(int type, std::vector<Cell> cells)
{
  AddNeighbours(type, cells);
  std::vector<Point> points;
  for (int i = 0; i < 18; ++i)
  {
    points.push_back({ std::cos(2. * i), std::sin(2. * i), 0.1 * i * i });
  }
  return MakeGrid(points, cells);
}

Configure Type1(int rule)
{
  return [rule](Filter* filter) { filter->SetType1Rule(rule); };
}
Configure Type2(int rule)
{
  return [rule](Filter* filter) { filter->SetType2Rule(rule); };
}
Configure Type3(int rule)
{
  return [rule](Filter* filter) { filter->SetType3Rule(rule); };
}
const Configure FollowPart = [](Filter* filter)
{
  filter->SetType2RuleToFollowPart();
  SetCellArray(filter, 2, "Part");
};
/// All joints blend or not by default, and regions have their rules.
Configure Regions(bool sharp)
{
  return [sharp](Filter* filter)
  {
    filter->SetType1Rule(sharp);
    filter->SetType2Rule(sharp);
    filter->SetType3Rule(sharp);
    SetCellArray(filter, 2, "Part");
    SetCellArray(filter, 3, "Rule");
  };
}

}

// ---------------------------------------------------------------- type 1

/// An edge of a solid and of three triangles, which are no faces of it: those who follow the
/// triangles blend with these alone.
TEST(FeaturesJoints, AnInnerJointIsCutToItsDimension)
{
  const Grid mesh = MakeGrid({ { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0.1, 0.2 }, { 0.9, -0.3, 0.8 },
                               { -1, 0.2, 0.3 }, { -0.8, 1, 0.6 }, { -0.7, -1, 0.4 } },
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TRIANGLE, { 0, 1, 4 } }, { VTK_TRIANGLE, { 0, 1, 5 } },
      { VTK_TRIANGLE, { 0, 1, 6 } } });
  EXPECT_TRUE(Near(Matrix(mesh).Edge(0, 1), SolidEdge(0, 1, { 2, 3, 4, 5, 6 })));
  EXPECT_TRUE(Near(
    Matrix(mesh, Type1(Filter::TYPE1_FOLLOW_DIMENSION2)).Edge(0, 1), SolidEdge(0, 1, { 4, 5, 6 })));
  EXPECT_TRUE(
    Near(Matrix(mesh, Type1(Filter::TYPE1_FOLLOW_DIMENSION3)).Edge(0, 1), SurfaceEdge(0, 1, 2, 3)));
}

/// The relief ring of an inner joint has neighbours by edges of the followed dimension only, at
/// both ends: one such edge and a line do not join a point to the edge.
TEST(FeaturesJoints, TheReliefOfAnInnerJointIsCutAtBothEnds)
{
  const std::vector<Cell> book = { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TRIANGLE, { 0, 1, 4 } },
    { VTK_TRIANGLE, { 0, 1, 5 } }, { VTK_TRIANGLE, { 0, 1, 6 } } };
  const std::vector<Cell> pieces = { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 0, 1, 4, 5 } },
    { VTK_TRIANGLE, { 0, 1, 6 } } };
  const MatrixRow all = SolidEdge(0, 1, { 2, 3, 4, 5, 6, 7, 8, 9 });
  // Type 2 among the triangles.
  const Grid triangles = MakeEdgeWithNeighbours(VTK_TRIANGLE, book);
  EXPECT_TRUE(Near(Matrix(triangles).Edge(0, 1), all));
  EXPECT_TRUE(Near(Matrix(triangles, Type1(Filter::TYPE1_FOLLOW_DIMENSION2)).Edge(0, 1),
    SolidEdge(0, 1, { 4, 5, 6, 9 })));
  // Type 3 among the tetrahedra.
  const Grid tets = MakeEdgeWithNeighbours(VTK_TETRA, pieces);
  EXPECT_TRUE(Near(Matrix(tets).Edge(0, 1), all));
  EXPECT_TRUE(Near(Matrix(tets, Type1(Filter::TYPE1_FOLLOW_DIMENSION3)).Edge(0, 1),
    SolidEdge(0, 1, { 2, 3, 4, 5, 9 })));
  const auto sharp = [](Filter* filter)
  {
    filter->SetType1RuleToFollowDimension3();
    filter->SetType3RuleToSharp();
  };
  EXPECT_TRUE(Near(Matrix(tets, sharp).Edge(0, 1), CurveEdge(0, 1)));
}

/// The same for vertices: two sheets, and two solids, that meet in a vertex of a line.
TEST(FeaturesJoints, TheRingOfAnInnerJointVertexIsCutToItsDimension)
{
  const Grid sheets = MakeGrid(First(6),
    { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 0, 3, 4 } }, { VTK_LINE, { 0, 5 } } });
  EXPECT_TRUE(Near(Matrix(sheets).Vertex(0), SolidVertex(0, { 1, 2, 3, 4, 5 })));
  EXPECT_TRUE(Near(Matrix(sheets, Type1(Filter::TYPE1_FOLLOW_DIMENSION2)).Vertex(0),
    SolidVertex(0, { 1, 2, 3, 4 })));
  const Grid solids = MakeGrid(First(8),
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 0, 4, 5, 6 } }, { VTK_LINE, { 0, 7 } } });
  EXPECT_TRUE(Near(Matrix(solids).Vertex(0), SolidVertex(0, { 1, 2, 3, 4, 5, 6, 7 })));
  EXPECT_TRUE(Near(Matrix(solids, Type1(Filter::TYPE1_FOLLOW_DIMENSION3)).Vertex(0),
    SolidVertex(0, { 1, 2, 3, 4, 5, 6 })));
}

TEST(FeaturesJoints, Type1Vertex)
{
  const Grid flag = MakeFlag();
  const MatrixRow blend = SolidVertex(0, { 1, 2, 3 });
  EXPECT_TRUE(Near(Matrix(flag).Vertex(0), blend));
  EXPECT_TRUE(Near(Matrix(flag, Type1(Filter::TYPE1_SHARP)).Vertex(0), Corner(0)));
  EXPECT_TRUE(Near(Matrix(flag, Type1(Filter::TYPE1_FOLLOW_DIMENSION1)).Vertex(0), Corner(0)));
  EXPECT_TRUE(
    Near(Matrix(flag, Type1(Filter::TYPE1_FOLLOW_DIMENSION2)).Vertex(0), CurveVertex(0, 1, 2)));
  EXPECT_TRUE(Near(Matrix(flag, Type1(Filter::TYPE1_FOLLOW_DIMENSION3)).Vertex(0), blend));
  // Inside a curve and a surface.
  const Grid mast = MakeFan(4, { { VTK_LINE, { 0, 5 } }, { VTK_LINE, { 0, 6 } } });
  mast->GetPoints()->InsertNextPoint(0, 0, 2);
  mast->GetPoints()->InsertNextPoint(0, 0, -2);
  EXPECT_TRUE(Near(Matrix(mast).Vertex(0), SolidVertex(0, { 1, 2, 3, 4, 5, 6 })));
  EXPECT_TRUE(
    Near(Matrix(mast, Type1(Filter::TYPE1_FOLLOW_DIMENSION1)).Vertex(0), CurveVertex(0, 5, 6)));
  EXPECT_TRUE(Near(Matrix(mast, Type1(Filter::TYPE1_FOLLOW_DIMENSION2)).Vertex(0),
    SurfaceVertex(0, { 1, 2, 3, 4 })));
}

TEST(FeaturesJoints, Type1Edge)
{
  const Grid fin = MakeFin();
  const Matrix blend(fin);
  EXPECT_TRUE(Near(blend.Edge(0, 1), SolidEdge(0, 1, { 2, 3, 4 })));
  EXPECT_TRUE(Near(blend.Vertex(0), SolidVertex(0, { 1, 2, 3, 4 })));
  const Matrix sharp(fin, Type1(Filter::TYPE1_SHARP));
  EXPECT_TRUE(Near(sharp.Edge(0, 1), CurveEdge(0, 1)));
  EXPECT_TRUE(Near(sharp.Vertex(0), Corner(0)));
  EXPECT_TRUE(Near(sharp.Edge(0, 2), SurfaceEdge(0, 2, 1, 3)));
  const Matrix first(fin, Type1(Filter::TYPE1_FOLLOW_DIMENSION1)); // not there: Blend
  EXPECT_TRUE(Near(first.Edge(0, 1), SolidEdge(0, 1, { 2, 3, 4 })));
  EXPECT_TRUE(Near(first.Vertex(1), SolidVertex(1, { 0, 2, 3, 4 })));
  const Matrix second(fin, Type1(Filter::TYPE1_FOLLOW_DIMENSION2));
  EXPECT_TRUE(Near(second.Edge(0, 1), CurveEdge(0, 1)));
  EXPECT_TRUE(Near(second.Vertex(0), CurveVertex(0, 1, 4)));
  const Matrix third(fin, Type1(Filter::TYPE1_FOLLOW_DIMENSION3));
  EXPECT_TRUE(Near(third.Edge(0, 1), SurfaceEdge(0, 1, 2, 3)));
  EXPECT_TRUE(Near(third.Vertex(0), SurfaceVertex(0, { 1, 2, 3 })));
}

TEST(FeaturesJoints, TwoSharpEdgesAreACurve)
{
  const Grid grid = MakeGrid(First(5),
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TRIANGLE, { 0, 1, 4 } },
      { VTK_TRIANGLE, { 1, 2, 4 } } });
  const Matrix matrix(grid, Type1(Filter::TYPE1_SHARP));
  EXPECT_TRUE(Near(matrix.Vertex(1), CurveVertex(1, 0, 2)));
  EXPECT_TRUE(Near(matrix.Vertex(0), Corner(0)));
  EXPECT_TRUE(Near(matrix.Edge(1, 4), SurfaceEdge(1, 4, 0, 2))); // no joint
}

TEST(FeaturesJoints, FollowedDimensionHasJointsOfItsOwn)
{
  const Grid grid = MakeBook({}, { { VTK_LINE, { 0, 5 } } });
  auto rule = [](int type2)
  {
    return [type2](Filter* filter)
    {
      filter->SetType1RuleToFollowDimension2();
      filter->SetType2Rule(type2);
    };
  };
  // Blend in C_2: the line is ignored.
  const Matrix blend(grid, rule(Filter::TYPE2_BLEND));
  EXPECT_TRUE(Near(blend.Vertex(0), SolidVertex(0, { 1, 2, 3, 4 })));
  EXPECT_TRUE(Near(Matrix(grid).Vertex(0), SolidVertex(0, { 1, 2, 3, 4, 5 })));
  const Matrix sharp(grid, rule(Filter::TYPE2_SHARP));
  EXPECT_TRUE(Near(sharp.Vertex(0), Corner(0)));
  EXPECT_TRUE(Near(sharp.Edge(0, 1), CurveEdge(0, 1)));
  // A fan with a fin and a mast.
  const Grid mast = MakeFan(4, { { VTK_TRIANGLE, { 0, 1, 5 } }, { VTK_LINE, { 0, 6 } } });
  mast->GetPoints()->InsertNextPoint(0, 0, 2);
  mast->GetPoints()->InsertNextPoint(0, 0, -2);
  AddCellArray(mast, "Part", { 3, 3, 3, 3, 2, 0 });
  const Matrix part(mast,
    [](Filter* filter)
    {
      filter->SetType1RuleToFollowDimension2();
      FollowPart(filter);
    });
  EXPECT_TRUE(Near(part.Vertex(0), SurfaceVertex(0, { 1, 2, 3, 4 })));
}

// ---------------------------------------------------------------- type 2

TEST(FeaturesJoints, Type2BlendAndSharp)
{
  const Matrix blend(MakeBook());
  EXPECT_TRUE(Near(blend.Edge(0, 1), SolidEdge(0, 1, { 2, 3, 4 })));
  EXPECT_TRUE(Near(blend.Vertex(0), SolidVertex(0, { 1, 2, 3, 4 })));
  EXPECT_TRUE(Near(blend.Vertex(2), CurveVertex(2, 0, 1)));
  const Matrix sharp(MakeBook(), Type2(Filter::TYPE2_SHARP));
  EXPECT_TRUE(Near(sharp.Edge(0, 1), CurveEdge(0, 1)));
  EXPECT_TRUE(Near(sharp.Vertex(0), Corner(0)));
  EXPECT_TRUE(Near(Matrix(MakeStar(3), Type2(Filter::TYPE2_SHARP)).Vertex(0), Corner(0)));
  // The joints of other types do not care.
  EXPECT_TRUE(
    Near(Matrix(MakeFlag(), Type2(Filter::TYPE2_SHARP)).Vertex(0), SolidVertex(0, { 1, 2, 3 })));
  // Two books in a row: the spine goes on.
  const Grid spine =
    MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0, -1, -1 } },
      { { VTK_TRIANGLE, { 0, 1, 3 } }, { VTK_TRIANGLE, { 0, 1, 4 } }, { VTK_TRIANGLE, { 0, 1, 5 } },
        { VTK_TRIANGLE, { 1, 2, 3 } }, { VTK_TRIANGLE, { 1, 2, 4 } },
        { VTK_TRIANGLE, { 1, 2, 5 } } });
  EXPECT_TRUE(Near(Matrix(spine, Type2(Filter::TYPE2_SHARP)).Vertex(1), CurveVertex(1, 0, 2)));
}

TEST(FeaturesJoints, Type2FollowPartOfLines)
{
  auto at = [](int lines, const std::vector<int>& parts)
  { return Matrix(With(MakeStar(lines), "Part", parts), FollowPart).Vertex(0); };
  EXPECT_TRUE(Near(at(4, { 1, 0, 1, 0 }), CurveVertex(0, 2, 4)));
  EXPECT_TRUE(Near(at(5, { 0, 1, 0, 1, 0 }), CurveVertex(0, 2, 4))); // 0 has three
  EXPECT_TRUE(Near(at(4, { -1, 9, -1, 9 }), CurveVertex(0, 2, 4)));  // negative: no part
  EXPECT_TRUE(Near(at(3, { -1, -5, 2 }), SolidVertex(0, { 1, 2, 3 })));
  EXPECT_TRUE(Near(at(3, { 0, 1, 2 }), SolidVertex(0, { 1, 2, 3 })));
  // Without an array of parts.
  EXPECT_TRUE(Near(
    Matrix(MakeStar(3), Type2(Filter::TYPE2_FOLLOW_PART)).Vertex(0), SolidVertex(0, { 1, 2, 3 })));
}

TEST(FeaturesJoints, Type2FollowPartOfTriangles)
{
  const Matrix book(With(MakeBook(), "Part", { 1, 0, 0 }), FollowPart);
  EXPECT_TRUE(Near(book.Edge(0, 1), SurfaceEdge(0, 1, 3, 4)));
  EXPECT_TRUE(Near(book.Vertex(0), SolidVertex(0, { 1, 2, 3, 4 }))); // closes to no cycle
  const Matrix one(With(MakeBook(), "Part", { 0, 0, 0 }), FollowPart);
  EXPECT_TRUE(Near(one.Edge(0, 1), SolidEdge(0, 1, { 2, 3, 4 })));
  const Grid fin = MakeFan(4, { { VTK_TRIANGLE, { 0, 1, 5 } } });
  fin->GetPoints()->InsertNextPoint(0, 0, 2);
  const Matrix fan(With(fin, "Part", { 5, 5, 5, 5, 1 }), FollowPart);
  EXPECT_TRUE(Near(fan.Edge(0, 1), SurfaceEdge(0, 1, 2, 4)));
  EXPECT_TRUE(Near(fan.Vertex(0), SurfaceVertex(0, { 1, 2, 3, 4 })));
  EXPECT_TRUE(Near(fan.Edge(0, 5), CurveEdge(0, 5))); // its boundary, as ever
  // Four triangles, two parts: the smaller id.
  const Grid four = MakeBook({}, { { VTK_TRIANGLE, { 0, 1, 5 } } });
  EXPECT_TRUE(Near(
    Matrix(With(four, "Part", { 8, 3, 3, 8 }), FollowPart).Edge(0, 1), SurfaceEdge(0, 1, 3, 4)));
}

// ---------------------------------------------------------------- type 3

TEST(FeaturesJoints, Type3)
{
  const Grid bowtie =
    MakeGrid(First(5), { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 0, 3, 4 } } });
  EXPECT_TRUE(Near(Matrix(bowtie).Vertex(0), SolidVertex(0, { 1, 2, 3, 4 })));
  EXPECT_TRUE(Near(Matrix(bowtie, Type3(Filter::TYPE3_SHARP)).Vertex(0), Corner(0)));
  EXPECT_TRUE(
    Near(Matrix(bowtie, Type2(Filter::TYPE2_SHARP)).Vertex(0), SolidVertex(0, { 1, 2, 3, 4 })));
  const Grid tets =
    MakeGrid(First(6), { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 0, 1, 4, 5 } } });
  EXPECT_TRUE(Near(Matrix(tets).Edge(0, 1), SolidEdge(0, 1, { 2, 3, 4, 5 })));
  EXPECT_TRUE(Near(Matrix(tets).Vertex(0), SolidVertex(0, { 1, 2, 3, 4, 5 })));
  EXPECT_TRUE(Near(Matrix(tets, Type3(Filter::TYPE3_SHARP)).Edge(0, 1), CurveEdge(0, 1)));
  EXPECT_TRUE(Near(Matrix(tets, Type3(Filter::TYPE3_SHARP)).Vertex(0), Corner(0)));
}

// ---------------------------------------------------------------- regions

TEST(FeaturesJoints, RegionsChoose)
{
  const MatrixRow blend = SolidEdge(0, 1, { 2, 3, 4 });
  auto edge = [](const std::vector<int>& rules, bool sharp)
  {
    const Grid grid = With(MakeBook(), "Part", { 7, 7, 8 });
    AddCellArray(grid, "Rule", rules);
    return Matrix(grid, Regions(sharp)).Edge(0, 1);
  };
  EXPECT_TRUE(Near(edge({ 0, 0, 0 }, false), blend));
  EXPECT_TRUE(Near(edge({ 0, 0, 0 }, true), CurveEdge(0, 1)));
  EXPECT_TRUE(Near(edge({ 1, 0, 0 }, true), blend));
  EXPECT_TRUE(Near(edge({ 0, 0, 2 }, false), CurveEdge(0, 1)));
  EXPECT_TRUE(Near(edge({ 0, 2, 1 }, false), CurveEdge(0, 1))); // the smallest id
  EXPECT_TRUE(Near(edge({ 0, 1, 2 }, true), blend));
  EXPECT_TRUE(Near(edge({ 0, 6, 0 }, true), SurfaceEdge(0, 1, 2, 3)));
  for (int type1Only : { 3, 4, 5 })
  {
    EXPECT_TRUE(Near(edge({ type1Only, 2, 2 }, true), blend)) << type1Only;
  }
}

/// What a step makes inside a triangle of three tetrahedra follows its region too.
TEST(FeaturesJoints, RegionsChooseInsideTriangles)
{
  const Grid mesh = MakeGrid(First(6),
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 0, 1, 2, 4 } },
      { VTK_TETRA, { 0, 1, 2, 5 } } });
  for (const bool sharp : { false, true })
  {
    const Grid regions = With(With(mesh, "Part", { 0, 0, 0 }), "Rule", { sharp ? 2 : 1, 0, 0 });
    const Grid byRegion = Execute(regions, 2, Regions(!sharp));
    const Grid byOption = Execute(mesh, 2, Type2(sharp));
    for (vtkIdType i = 0; i < byOption->GetNumberOfPoints(); ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_EQ(byRegion->GetPoint(i)[c], byOption->GetPoint(i)[c]) << sharp << ", point " << i;
      }
    }
  }
}

TEST(FeaturesJoints, RegionsChooseForType1)
{
  auto vertex = [](int onTriangle, int onLine, bool sharp, bool lineFirst)
  {
    const Cell triangle = { VTK_TRIANGLE, { 0, 1, 2 } };
    const Cell line = { VTK_LINE, { 0, 3 } };
    const Grid grid =
      lineFirst ? MakeGrid(First(4), { line, triangle }) : MakeGrid(First(4), { triangle, line });
    AddCellArray(grid, "Part", { 0, 0 });
    AddCellArray(grid, "Rule",
      lineFirst ? std::vector<int>{ onLine, onTriangle } : std::vector<int>{ onTriangle, onLine });
    return Matrix(grid, Regions(sharp)).Vertex(0);
  };
  const MatrixRow blend = SolidVertex(0, { 1, 2, 3 });
  for (bool lineFirst : { false, true })
  {
    for (bool sharp : { false, true })
    {
      EXPECT_TRUE(Near(vertex(0, 0, sharp, lineFirst), sharp ? Corner(0) : blend));
      EXPECT_TRUE(Near(vertex(0, 4, sharp, lineFirst), CurveVertex(0, 1, 2)));
      EXPECT_TRUE(Near(vertex(3, 0, sharp, lineFirst), Corner(0)));
      EXPECT_TRUE(Near(vertex(1, 0, sharp, lineFirst), blend));
      EXPECT_TRUE(Near(vertex(2, 0, sharp, lineFirst), Corner(0)));
      EXPECT_TRUE(Near(vertex(0, 5, sharp, lineFirst), blend)); // not in C_3
      EXPECT_TRUE(Near(vertex(6, 0, sharp, lineFirst), blend)); // not for type 1
    }
    EXPECT_TRUE(Near(vertex(4, 2, false, lineFirst), lineFirst ? Corner(0) : CurveVertex(0, 1, 2)));
  }
}

/// A region's choice FollowDimension2 is none of type 2: the joint inside C_2 blends, whatever
/// Type2Rule is. Where the choice is that of Type1Rule, Type2Rule decides inside C_2.
TEST(FeaturesJoints, AnInnerJointThatItsRegionChoseBlends)
{
  const Grid mesh = MakeGrid(First(7),
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TRIANGLE, { 0, 1, 4 } }, { VTK_TRIANGLE, { 0, 1, 5 } },
      { VTK_TRIANGLE, { 0, 1, 6 } } });
  AddCellArray(mesh, "Part", { 0, 0, 0, 0 });
  const Matrix byRegion(With(mesh, "Rule", { 4, 0, 0, 0 }), Regions(true));
  EXPECT_TRUE(Near(byRegion.Edge(0, 1), SolidEdge(0, 1, { 4, 5, 6 })));
  EXPECT_TRUE(Near(byRegion.Vertex(0), SolidVertex(0, { 1, 4, 5, 6 })));
  const Matrix byOption(mesh,
    [](Filter* filter)
    {
      filter->SetType1RuleToFollowDimension2();
      filter->SetType2RuleToSharp();
    });
  EXPECT_TRUE(Near(byOption.Edge(0, 1), CurveEdge(0, 1)));
  EXPECT_TRUE(Near(byOption.Vertex(0), Corner(0)));
}

TEST(FeaturesJoints, RegionsChooseForType3)
{
  const Grid bowtie =
    MakeGrid(First(5), { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 0, 3, 4 } } });
  AddCellArray(bowtie, "Part", { 0, 0 });
  const MatrixRow blend = SolidVertex(0, { 1, 2, 3, 4 });
  EXPECT_TRUE(Near(Matrix(With(bowtie, "Rule", { 0, 2 }), Regions(false)).Vertex(0), Corner(0)));
  for (int rule : { 1, 3, 4, 5, 6 })
  {
    EXPECT_TRUE(Near(Matrix(With(bowtie, "Rule", { 0, rule }), Regions(true)).Vertex(0), blend));
  }
}

TEST(FeaturesJoints, FollowersDoNotChoose)
{
  const Cell follower = { VTK_LINE, { 0, 1 } };
  const Cell equal = { VTK_TRIANGLE, { 1, 0, 4 } };
  const Grid first = With(MakeBook({ follower }, { equal }), "Part", { 0, 0, 0, 1, 1 });
  const MatrixRow blend = SolidEdge(0, 1, { 2, 3, 4 });
  EXPECT_TRUE(
    Near(Matrix(With(first, "Rule", { 2, 0, 0, 0, 2 }), Regions(false)).Edge(0, 1), blend));
  EXPECT_TRUE(
    Near(Matrix(With(first, "Rule", { 2, 0, 1, 0, 2 }), Regions(true)).Edge(0, 1), blend));
}

TEST(FeaturesJoints, ValuesThatAreNoRulesAreNamed)
{
  const Grid grid = With(MakeBook(), "Part", { 0, 0, 0 });
  AddCellArray(grid, "Rule", { 0, 7, -1 });
  vtkNew<Messages> messages;
  const Matrix matrix(grid, Regions(true), messages);
  EXPECT_EQ(messages->Warnings.size(), 1u);
  EXPECT_EQ(messages->CountWarnings("\"Rule\""), 1);
  EXPECT_EQ(messages->CountWarnings("cell 1"), 1);
  EXPECT_TRUE(Near(matrix.Edge(0, 1), CurveEdge(0, 1)));
}

TEST(FeaturesJoints, ARuleChangesOnlyItsJoints)
{
  // Rows of manifold simplices are the same whatever the rules are.
  const Grid grid = MakeRandomComplex(5);
  grid->GetCellData()->RemoveArray("Singular");
  const Configure classify = [](Filter* filter) { filter->SetGenerateClassification(true); };
  const Matrix plain(grid, classify);
  vtkDataArray* types = plain.GetOutput()->GetPointData()->GetArray("NonManifoldType");
  vtkDataArray* rows = plain.GetOutput()->GetPointData()->GetArray("impulses");
  int manifold = 0;
  int joints[4] = {};
  for (int rule = 0; rule < 9; ++rule)
  {
    const Matrix other(grid,
      [rule](Filter* filter)
      {
        filter->SetType1Rule(rule < 5 ? rule : 0);
        filter->SetType2Rule(rule == 5 ? 1 : rule == 6 ? 2 : 0);
        filter->SetType3Rule(rule == 7 ? 1 : 0);
        SetCellArray(filter, 2, "Part");
      });
    vtkDataArray* others = other.GetOutput()->GetPointData()->GetArray("impulses");
    const int type = rule < 5 ? 1 : rule < 7 ? 2 : rule == 7 ? 3 : 0;
    for (vtkIdType i = 0; i < rows->GetNumberOfTuples(); ++i)
    {
      bool same = true;
      for (int k = 0; k < rows->GetNumberOfComponents(); ++k)
      {
        same = same && rows->GetComponent(i, k) == others->GetComponent(i, k);
      }
      const int own = static_cast<int>(types->GetTuple1(i));
      manifold += own == 0;
      joints[own] += !same;
      // A type 1 joint that follows a dimension may meet joints of type 2 and 3 there.
      EXPECT_TRUE(same || own == type) << i << " " << own << " rule " << rule;
    }
  }
  EXPECT_GT(manifold, 0);
  EXPECT_GT(joints[1], 0);
}
