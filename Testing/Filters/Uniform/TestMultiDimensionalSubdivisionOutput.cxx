// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestMultiDimensionalSubdivisionOutput.cxx
 * Which points and cells come out, in which order, and how they are classified.
 */
#include "MultiDimensionalSubdivisionTools.h"

#include "vtkSubdivisionModelSource.h"

using namespace multi_dimensional_subdivision_tools;

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// Mathematics 2: children by pairs of corners; a pair of equal corners is the corner.
using Child = std::vector<std::array<int, 2>>;
const std::vector<Child> ChildTables[4] = { { { { 0, 0 } } },
  { { { 0, 0 }, { 0, 1 } }, { { 0, 1 }, { 1, 1 } } },
  { { { 0, 0 }, { 0, 1 }, { 0, 2 } }, { { 0, 1 }, { 1, 1 }, { 1, 2 } },
    { { 0, 2 }, { 1, 2 }, { 2, 2 } }, { { 0, 1 }, { 1, 2 }, { 0, 2 } } },
  { { { 0, 0 }, { 0, 1 }, { 0, 2 }, { 0, 3 } }, { { 0, 1 }, { 1, 1 }, { 1, 2 }, { 1, 3 } },
    { { 0, 2 }, { 1, 2 }, { 2, 2 }, { 2, 3 } }, { { 0, 3 }, { 1, 3 }, { 2, 3 }, { 3, 3 } },
    { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 3 } }, { { 1, 2 }, { 0, 2 }, { 0, 1 }, { 1, 3 } },
    { { 0, 2 }, { 0, 3 }, { 1, 3 }, { 2, 3 } }, { { 1, 3 }, { 1, 2 }, { 0, 2 }, { 2, 3 } } } };

constexpr int TypeOf[4] = { VTK_VERTEX, VTK_LINE, VTK_TRIANGLE, VTK_TETRA };

/// The cells of `fine` are the children of those of `coarse`, cell by cell, and there is one new
/// point for each edge.
void ExpectChildren(vtkUnstructuredGrid* coarse, vtkUnstructuredGrid* fine)
{
  std::map<std::array<vtkIdType, 2>, vtkIdType> edges;
  vtkIdType at = 0;
  for (vtkIdType i = 0; i < coarse->GetNumberOfCells(); ++i)
  {
    const Ids parent = GetCell(coarse, i);
    const int dimension = static_cast<int>(parent.size()) - 1;
    for (const Child& child : ChildTables[dimension])
    {
      ASSERT_LT(at, fine->GetNumberOfCells());
      ASSERT_EQ(fine->GetCellType(at), TypeOf[dimension]);
      const Ids ids = GetCell(fine, at++);
      ASSERT_EQ(ids.size(), parent.size());
      for (std::size_t k = 0; k < ids.size(); ++k)
      {
        const vtkIdType a = parent[child[k][0]];
        const vtkIdType b = parent[child[k][1]];
        if (a == b)
        {
          ASSERT_EQ(ids[k], a) << "cell " << i;
          continue;
        }
        const std::array<vtkIdType, 2> edge{ std::min(a, b), std::max(a, b) };
        ASSERT_GE(ids[k], coarse->GetNumberOfPoints());
        ASSERT_EQ(edges.emplace(edge, ids[k]).first->second, ids[k]) << "cell " << i;
      }
    }
  }
  EXPECT_EQ(at, fine->GetNumberOfCells());
  std::set<vtkIdType> points;
  for (const auto& edge : edges)
  {
    points.insert(edge.second);
  }
  EXPECT_EQ(points.size(), edges.size());
  EXPECT_EQ(
    coarse->GetNumberOfPoints() + static_cast<vtkIdType>(edges.size()), fine->GetNumberOfPoints());
}

/// Two tets on a face, that face, one tet again in another order, a fin with its edge, a line, two
/// vertices, and an unused NaN point in the middle of the points.
const std::vector<Point> ZooPoints = { { 0, 0, 0 }, { NaN, 0, 0 }, { 1, 0, 0 }, { 0, 1.1, 0 },
  { 0, 0, 1.2 }, { 1.3, 1.2, 1.1 }, { 3, 0, 0 }, { 4, 0, 1 }, { 9, 9, 9 }, { 8, 8, 8 } };
const std::vector<Cell> ZooCells = { { VTK_VERTEX, { 0 } }, { VTK_TRIANGLE, { 4, 2, 3 } },
  { VTK_TETRA, { 0, 2, 3, 4 } }, { VTK_TETRA, { 5, 2, 4, 3 } }, { VTK_TETRA, { 3, 4, 0, 2 } },
  { VTK_CONVEX_POINT_SET, { 0, 2, 3 } }, { VTK_TRIANGLE, { 2, 5, 6 } }, { VTK_LINE, { 6, 5 } },
  { VTK_LINE, { 6, 7 } }, { VTK_TRIANGLE, { 6, 5, 2 } }, { VTK_VERTEX, { 8 } } };

Grid MakeZoo()
{
  const Grid grid = MakeGrid(ZooPoints, ZooCells);
  grid->GetCellData()->AddArray(MakeArray<vtkIntArray>("id", 1, grid->GetNumberOfCells(), 0, 0, 1));
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    grid->GetCellData()->GetArray("id")->SetComponent(i, 0, 100. + i);
  }
  return grid;
}

Grid SubdivideZoo(Options options)
{
  vtkNew<Messages> messages;
  const Grid result = Subdivide(MakeZoo(), options, messages);
  EXPECT_EQ(messages->Warnings.size(), 1u);
  EXPECT_EQ(messages->CountWarnings("not supported"), 1);
  EXPECT_EQ(messages->Errors.size(), 0u);
  return result;
}

bool IsEven(const Ids& from, const Ids& to)
{
  Ids rest = to;
  bool even = true;
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    const auto found = std::find(rest.begin() + i, rest.end(), from[i]);
    EXPECT_TRUE(found != rest.end());
    if (found != rest.begin() + i)
    {
      std::iter_swap(found, rest.begin() + i);
      even = !even;
    }
  }
  return even;
}

}

TEST(MultiDimensionalSubdivisionOutput, LevelZeroHasTheSimplicesInTheirPlaces)
{
  Options options;
  options.Levels = 0;
  const Grid zero = SubdivideZoo(options);
  ASSERT_EQ(zero->GetNumberOfPoints(), static_cast<vtkIdType>(ZooPoints.size()));
  for (vtkIdType i = 0; i < zero->GetNumberOfPoints(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const double x = ZooPoints[i][k];
      EXPECT_TRUE(std::isnan(x) ? std::isnan(GetPoint(zero, i)[k]) : GetPoint(zero, i)[k] == x);
    }
  }
  ASSERT_EQ(zero->GetNumberOfCells(), static_cast<vtkIdType>(ZooCells.size()) - 1);
  vtkIdType at = 0;
  for (std::size_t i = 0; i < ZooCells.size(); ++i)
  {
    if (ZooCells[i].Type == VTK_CONVEX_POINT_SET)
    {
      continue;
    }
    EXPECT_EQ(zero->GetCellType(at), ZooCells[i].Type);
    EXPECT_EQ(zero->GetCellData()->GetArray("id")->GetTuple1(at), 100. + i);
    const Ids ids = GetCell(zero, at++);
    if (ZooCells[i].Type == VTK_TETRA)
    {
      EXPECT_EQ(ids[0], ZooCells[i].Points[0]);
      EXPECT_TRUE(IsEven(ZooCells[i].Points, ids));
    }
    else
    {
      EXPECT_EQ(ids, ZooCells[i].Points);
    }
  }
}

TEST(MultiDimensionalSubdivisionOutput, MarkedPairHasTheShortestDiagonal)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    // Pairs of opposite edges: with a stretched axis, the diagonal across it is the shortest.
    std::vector<Point> points = { { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } };
    const int x = axis;
    const int y = (axis + 1) % 3;
    const int z = (axis + 2) % 3;
    const double size[3] = { 4, 2, 1 };
    // A disphenoid: corners of a box of which every other is taken. Its diagonals are the box's
    // axes.
    for (int i = 0; i < 4; ++i)
    {
      points[i][x] = (i & 1) ? size[0] : 0;
      points[i][y] = (i & 2) ? size[1] : 0;
      points[i][z] = (i == 1 || i == 2) ? size[2] : 0;
    }
    const Grid zero = Subdivide(MakeGrid(points, { { VTK_TETRA, { 0, 1, 2, 3 } } }), 0);
    // The diagonal along z is the shortest: it joins the edges 12 (top) and 03 (bottom).
    const Ids ids = GetCell(zero, 0);
    EXPECT_EQ(ids[0], 0);
    EXPECT_EQ(ids[2], 3);
    EXPECT_TRUE(IsEven({ 0, 1, 2, 3 }, ids));
  }
}

TEST(MultiDimensionalSubdivisionOutput, ChildrenInTheOrderOfTheTable)
{
  Options options;
  std::vector<Grid> levels;
  for (options.Levels = 0; options.Levels <= 3; ++options.Levels)
  {
    levels.push_back(SubdivideZoo(options));
  }
  const Grid box = MakeMixedBox(2);
  for (int i = 0; i < 3; ++i)
  {
    ExpectChildren(levels[i], levels[i + 1]);
    ExpectChildren(Subdivide(box, i), Subdivide(box, i + 1));
  }
}

TEST(MultiDimensionalSubdivisionOutput, CellDataGoToTheChildren)
{
  Options options;
  options.Levels = 2;
  options.OriginalIds = true;
  const Grid two = SubdivideZoo(options);
  vtkDataArray* id = two->GetCellData()->GetArray("id");
  vtkDataArray* original = two->GetCellData()->GetArray("vtkOriginalCellIds");
  ASSERT_TRUE(vtkIdTypeArray::SafeDownCast(original));
  vtkIdType at = 0;
  for (vtkIdType i = 0; i < static_cast<vtkIdType>(ZooCells.size()); ++i)
  {
    const int type = ZooCells[i].Type;
    const int children = type == VTK_TETRA ? 64
      : type == VTK_TRIANGLE               ? 16
      : type == VTK_LINE                   ? 4
      : type == VTK_VERTEX                 ? 1
                                           : 0;
    for (int k = 0; k < children; ++k)
    {
      ASSERT_EQ(two->GetCellType(at), type);
      ASSERT_EQ(id->GetTuple1(at), 100. + i);
      ASSERT_EQ(original->GetTuple1(at++), i);
    }
  }
  EXPECT_EQ(at, two->GetNumberOfCells());
}

TEST(MultiDimensionalSubdivisionOutput, OrientationIsKept)
{
  // All weights are positive, but the sign is promised for midpoints: a lattice keeps its own.
  for (bool turned : { false, true })
  {
    std::vector<Cell> cells;
    const std::vector<Point> corners = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 },
      { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
    cells.push_back(
      { VTK_HEXAHEDRON, turned ? Ids{ 4, 5, 6, 7, 0, 1, 2, 3 } : Ids{ 0, 1, 2, 3, 4, 5, 6, 7 } });
    const Grid hex = MakeGrid(corners, cells);
    Grid current = Subdivide(hex, 0);
    for (int i = 0; i < 3; ++i)
    {
      for (const Ids& tet : GetCells(current))
      {
        ASSERT_EQ(GetSignedVolume(current, tet) < 0, turned);
      }
      current = Subdivide(current, 1);
    }
  }
}

TEST(MultiDimensionalSubdivisionOutput, UnusedPointsStayWhereTheyAre)
{
  Options options;
  options.Levels = 3;
  const Grid three = SubdivideZoo(options);
  EXPECT_TRUE(std::isnan(GetPoint(three, 1)[0]));
  EXPECT_EQ(GetPoint(three, 9), ZooPoints[9]);
  EXPECT_EQ(GetPoint(three, 8), ZooPoints[8]); // and so does an isolated vertex
  for (vtkIdType i = 0; i < three->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(std::isfinite(GetPoint(three, i)[0]), i != 1) << i;
  }
}

TEST(MultiDimensionalSubdivisionOutput, FollowersChangeNothing)
{
  // The zoo without followers and copies has the same points, up to their order.
  std::vector<Cell> cells;
  for (std::size_t i : { 2, 3, 6, 8, 10 })
  {
    cells.push_back(ZooCells[i]);
  }
  const Grid few = Subdivide(MakeGrid(ZooPoints, cells), 2);
  Options options;
  options.Levels = 2;
  const Grid all = SubdivideZoo(options);
  std::set<Point> a;
  std::set<Point> b;
  for (const auto& [grid, set] : { std::make_pair(few, &a), std::make_pair(all, &b) })
  {
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    {
      Point p = GetPoint(grid, i);
      for (double& x : p)
      {
        x = std::isnan(x) ? -99. : std::round(x * 1e10);
      }
      set->insert(p);
    }
  }
  EXPECT_EQ(a, b);
}

// ---------------------------------------------------------------- classification

namespace
{

struct Expected
{
  Ids Points;
  int Rule;
  int Type;
};

/// Pieces side by side, each with the vertices that it is about.
struct Pieces
{
  std::vector<Point> Points;
  std::vector<Cell> Cells;
  std::vector<int> Dimensions;
  std::vector<Expected> Vertices;

  void Add(vtkIdType size, const std::vector<Cell>& cells, const std::vector<int>& dimensions,
    const std::vector<Expected>& vertices)
  {
    const auto first = static_cast<vtkIdType>(this->Points.size());
    std::mt19937 random(static_cast<unsigned>(first));
    auto next = [&random] { return random() / 4294967296.; };
    for (vtkIdType i = 0; i < size; ++i)
    {
      this->Points.push_back({ 3. * first + next(), next(), next() });
    }
    for (Cell cell : cells)
    {
      for (vtkIdType& id : cell.Points)
      {
        id += first;
      }
      this->Cells.push_back(cell);
    }
    this->Dimensions.insert(this->Dimensions.end(), dimensions.begin(), dimensions.end());
    for (Expected expected : vertices)
    {
      for (vtkIdType& id : expected.Points)
      {
        id += first;
      }
      this->Vertices.push_back(expected);
    }
  }
};

Pieces MakePieces()
{
  Pieces p;
  auto triangle = [](vtkIdType a, vtkIdType b, vtkIdType c)
  { return Cell{ VTK_TRIANGLE, { a, b, c } }; };
  auto tet = [](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d)
  { return Cell{ VTK_TETRA, { a, b, c, d } }; };
  auto line = [](vtkIdType a, vtkIdType b) { return Cell{ VTK_LINE, { a, b } }; };
  // A curve, a vertex in it and one of its own, an unused point.
  p.Add(5, { line(0, 1), line(1, 2), { VTK_VERTEX, { 1 } }, { VTK_VERTEX, { 3 } } }, { 1, 1, 1, 0 },
    { { { 0, 2 }, 0, 0 }, { { 1 }, 1, 0 }, { { 3, 4 }, 0, 0 } });
  // Three curves in a vertex.
  p.Add(4, { line(0, 1), line(0, 2), line(0, 3) }, { 1, 1, 1 },
    { { { 0 }, 4, 2 }, { { 1, 2, 3 }, 0, 0 } });
  // A fan of three triangles around a vertex, with an edge of it as a line.
  p.Add(4, { triangle(0, 1, 2), triangle(0, 2, 3), triangle(0, 3, 1), line(0, 1) }, { 2, 2, 2, 2 },
    { { { 0 }, 2, 0 }, { { 1, 2, 3 }, 1, 0 } });
  // Three sheets on an edge.
  p.Add(5, { triangle(0, 1, 2), triangle(0, 1, 3), triangle(1, 0, 4) }, { 2, 2, 2 },
    { { { 0, 1 }, 4, 2 }, { { 2, 3, 4 }, 1, 0 } });
  // A bow-tie.
  p.Add(5, { triangle(0, 1, 2), triangle(0, 3, 4) }, { 2, 2 },
    { { { 0 }, 4, 3 }, { { 1, 2, 3, 4 }, 1, 0 } });
  // A curve at a surface; the vertex lies in both.
  p.Add(4, { triangle(0, 1, 2), line(0, 3), { VTK_VERTEX, { 0 } }, { VTK_VERTEX, { 3 } } },
    { 2, 1, 2, 1 }, { { { 0 }, 4, 1 }, { { 1, 2 }, 1, 0 }, { { 3 }, 0, 0 } });
  // A tet with a face, an edge, a corner and a copy of its own.
  p.Add(4,
    { triangle(2, 1, 0), tet(0, 1, 2, 3), line(3, 1), { VTK_VERTEX, { 2 } }, tet(3, 2, 1, 0) },
    { 3, 3, 3, 3, 3 }, { { { 0, 1, 2, 3 }, 2, 0 } });
  // A fin on a tet.
  p.Add(5, { tet(0, 1, 2, 3), triangle(0, 1, 4) }, { 3, 2 },
    { { { 0, 1 }, 4, 1 }, { { 2, 3 }, 2, 0 }, { { 4 }, 1, 0 } });
  // Four tets around an inner vertex.
  p.Add(5, { tet(4, 1, 2, 3), tet(0, 4, 2, 3), tet(0, 1, 4, 3), tet(0, 1, 2, 4) }, { 3, 3, 3, 3 },
    { { { 4 }, 3, 0 }, { { 0, 1, 2, 3 }, 2, 0 } });
  // Two tets at an edge, and two at a vertex.
  p.Add(6, { tet(0, 1, 2, 3), tet(0, 1, 4, 5) }, { 3, 3 },
    { { { 0, 1 }, 4, 3 }, { { 2, 3, 4, 5 }, 2, 0 } });
  p.Add(7, { tet(0, 1, 2, 3), tet(0, 4, 5, 6) }, { 3, 3 },
    { { { 0 }, 4, 3 }, { { 1, 2, 3, 4, 5, 6 }, 2, 0 } });
  // Three tets on a face.
  p.Add(6, { tet(0, 1, 2, 3), tet(0, 1, 2, 4), tet(0, 1, 2, 5) }, { 3, 3, 3 },
    { { { 0, 1, 2 }, 4, 2 }, { { 3, 4, 5 }, 2, 0 } });
  return p;
}

}

TEST(MultiDimensionalSubdivisionClassification, IsThatOfEveryPiece)
{
  const Pieces pieces = MakePieces();
  const Grid grid = MakeGrid(pieces.Points, pieces.Cells);
  grid->GetPointData()->AddArray(MakeNames("RuleDimension", grid->GetNumberOfPoints()));
  grid->GetPointData()->AddArray(MakeNames("NonManifoldType", grid->GetNumberOfPoints()));
  grid->GetCellData()->AddArray(MakeNames("ManifoldDimension", grid->GetNumberOfCells()));
  for (int levels : { 0, 1, 2 })
  {
    Options options;
    options.Levels = levels;
    options.Classification = true;
    const Grid result = Subdivide(grid, options);
    auto* rules =
      vtkUnsignedCharArray::SafeDownCast(result->GetPointData()->GetAbstractArray("RuleDimension"));
    auto* types = vtkUnsignedCharArray::SafeDownCast(
      result->GetPointData()->GetAbstractArray("NonManifoldType"));
    auto* dimensions = vtkUnsignedCharArray::SafeDownCast(
      result->GetCellData()->GetAbstractArray("ManifoldDimension"));
    ASSERT_TRUE(rules && types && dimensions);
    ASSERT_EQ(rules->GetNumberOfValues(), result->GetNumberOfPoints());
    ASSERT_EQ(types->GetNumberOfValues(), result->GetNumberOfPoints());
    ASSERT_EQ(dimensions->GetNumberOfValues(), result->GetNumberOfCells());
    EXPECT_EQ(result->GetPointData()->GetNumberOfArrays(), 2);
    EXPECT_TRUE(result->GetCellData()->HasArray("Inverted"));
    EXPECT_EQ(result->GetCellData()->GetNumberOfArrays(), 2);
    for (const Expected& expected : pieces.Vertices)
    {
      for (vtkIdType id : expected.Points)
      {
        EXPECT_EQ(rules->GetValue(id), expected.Rule) << "point " << id;
        EXPECT_EQ(types->GetValue(id), expected.Type) << "point " << id;
      }
    }
    vtkIdType at = 0;
    for (std::size_t i = 0; i < pieces.Cells.size(); ++i)
    {
      const int own = static_cast<int>(pieces.Cells[i].Points.size()) - 1;
      for (int child = 0; child < (1 << (own * levels)); ++child)
      {
        ASSERT_EQ(dimensions->GetValue(at++), pieces.Dimensions[i]) << "cell " << i;
      }
    }
    EXPECT_EQ(at, result->GetNumberOfCells());
  }
}

TEST(MultiDimensionalSubdivisionClassification, OfNewPoints)
{
  // A tet with a fin: new points have the class of their edge.
  const std::vector<Point> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 1, -1, 0 } };
  const Grid grid = MakeGrid(points,
    { { VTK_LINE, { 0, 1 } }, { VTK_TRIANGLE, { 0, 1, 4 } }, { VTK_LINE, { 2, 3 } },
      { VTK_LINE, { 1, 4 } }, { VTK_TETRA, { 0, 1, 2, 3 } } });
  Options options;
  options.Classification = true;
  const Grid result = Subdivide(grid, options);
  auto rule = [&](vtkIdType line, const char* name)
  { return result->GetPointData()->GetArray(name)->GetTuple1(GetCell(result, line)[1]); };
  EXPECT_EQ(rule(0, "RuleDimension"), 4); // where the fin meets the tet
  EXPECT_EQ(rule(0, "NonManifoldType"), 1);
  EXPECT_EQ(rule(6, "RuleDimension"), 2); // outside of the tet
  EXPECT_EQ(rule(8, "RuleDimension"), 1); // border of the fin
  EXPECT_EQ(rule(8, "NonManifoldType"), 0);
}

TEST(MultiDimensionalSubdivisionClassification, OffByDefault)
{
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  filter->SetVolumeSchemeToBoxSpline();
  EXPECT_FALSE(filter->GetGenerateClassification());
  EXPECT_FALSE(filter->GetGenerateOriginalIds());
  EXPECT_FALSE(filter->GetInterpolateIntegers());
  EXPECT_EQ(filter->GetNumberOfLevels(), 1);
  EXPECT_EQ(filter->GetMaximumNumberOfCells(), 500000000);
  EXPECT_EQ(filter->GetOutputPointsPrecision(), int(vtkAlgorithm::DEFAULT_PRECISION));
  const Grid result = Subdivide(MakeMixedBox(1), 1);
  EXPECT_EQ(result->GetPointData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(result->GetCellData()->GetNumberOfArrays(), 0);
}
