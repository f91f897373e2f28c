// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestRedGreenMarks.cxx
 * Mathematics 13 on a few cells, by hand: what each mark does, and what it brings about.
 */
#include "CoreZoo.h"
#include "RedGreenChecks.h"
#include "RedGreenFew.h"

#include "Core/Memory/Loops.h"

#include <stdexcept>

using namespace redgreen_reference;

namespace
{

/// Marks a cell, and an edge of one of its children between the midpoints of two of its edges,
/// before anybody has looked at another cell of the same vertices.
void CheckCutChild(const Tuple& first, const Tuple& second, const int (&edges)[2][2])
{
  Few few(4, { first, second });
  few.State.MarkEdge({ 0, -1 }, edges[0][0], edges[0][1]); // is edge 0
  few.State.MarkCell({ 0, -1 });
  const int ends[2] = { few.FindMiddle(edges[0][0], edges[0][1]),
    few.FindMiddle(edges[1][0], edges[1][1]) };
  bool isThere = false;
  for (int child = 0; child < (first.size() == 3 ? 4 : 8) && !isThere; ++child)
  {
    const auto cell = few.State.GetCell(RedGreenLeaf<int>{ 0, child });
    const auto has = [&](int v)
    { return std::count(cell.Vertices.begin(), cell.Vertices.end(), v) > 0; };
    isThere = has(ends[0]) && has(ends[1]);
    if (isThere)
    {
      few.State.MarkEdge({ 0, child }, ends[1], ends[0]);
    }
  }
  few.State.Close();
  ASSERT_TRUE(few.State.IsRed(0));
  ASSERT_TRUE(few.State.IsRed(1));
  ASSERT_EQ(few.FindMiddle(ends[0], ends[1]) >= 0, isThere);
  // No cell has an edge that is split.
  std::set<std::pair<int, int>> split;
  for (int v = few.State.GetNumberOfInputVertices(); v < few.State.GetNumberOfVertices(); ++v)
  {
    const auto both = few.State.GetEnds(v);
    split.insert(std::minmax({ both[0], both[1] }));
  }
  for (const Tuple& cell : GetCells(Write(few.State, few.Points).Cells))
  {
    for (const vtkIdType a : cell)
    {
      for (const vtkIdType b : cell)
      {
        ASSERT_EQ(split.count({ static_cast<int>(a), static_cast<int>(b) }), 0u);
      }
    }
  }
}

/// The second cell in all orders of its vertices, and all pairs of edges of the first one.
void CheckCutChildren(const Tuple& first, Tuple second)
{
  do
  {
    const int edges[6][2] = { { 0, 1 }, { 0, 2 }, { 1, 2 }, { 0, 3 }, { 1, 3 }, { 2, 3 } };
    for (int k = 0; k < (first.size() == 3 ? 3 : 6); ++k)
    {
      for (int l = 0; l < (first.size() == 3 ? 3 : 6); ++l)
      {
        if (k == l)
        {
          continue;
        }
        SCOPED_TRACE("edges " + std::to_string(k) + " " + std::to_string(l));
        ASSERT_NO_FATAL_FAILURE(CheckCutChild(
          first, second, { { edges[k][0], edges[k][1] }, { edges[l][0], edges[l][1] } }));
      }
    }
  } while (std::next_permutation(second.begin(), second.end()));
}

}

TEST(RedGreenMarks, ACellBecomesRed)
{
  const std::vector<std::pair<Tuple, int>> cells{ { { 0, 1 }, 2 }, { { 0, 1, 2 }, 4 },
    { { 0, 1, 2, 3 }, 8 } };
  for (const auto& [cell, children] : cells)
  {
    Few few(4, { cell });
    EXPECT_FALSE(few.State.IsRed(0));
    few.State.MarkCell({ 0, -1 });
    EXPECT_TRUE(few.State.IsRed(0));
    EXPECT_TRUE(few.State.Close());
    EXPECT_FALSE(few.State.Close());
    EXPECT_EQ(few.Count(), (Counts{ 0, children, 0, 0, 0 }));
    few.State.MarkCell({ 0, -1 }); // it is red already
    EXPECT_FALSE(few.State.Close());
    EXPECT_EQ(few.Count(), (Counts{ 0, children, 0, 0, 0 }));
  }
}

TEST(RedGreenMarks, AVertexCellStays)
{
  Few few(3, { { 0 }, { 1 } });
  few.State.MarkCell({ 1, -1 });
  EXPECT_FALSE(few.State.Close());
  EXPECT_FALSE(few.State.IsRed(1));
  few.State.MarkEdge({ 0, -1 }, 0, 1); // which it has not
  EXPECT_FALSE(few.State.Close());
  EXPECT_EQ(few.Count(), (Counts{ 2, 0, 0, 0, 0 }));
}

TEST(RedGreenMarks, NeighboursBecomeGreen)
{
  // One tetrahedron is red. Others share a face, an edge, a vertex with it, and a triangle and two
  // lines lie on it.
  Few few(9,
    { { 0, 1, 2, 3 }, { 4, 3, 1, 2 }, { 5, 1, 0, 6 }, { 0, 5, 6, 7 }, { 1, 0, 8 }, { 3, 2 },
      { 2, 4 } });
  few.State.MarkCell({ 0, -1 });
  EXPECT_TRUE(few.State.Close());
  // Red: 8 and 2 of the line. Green-I: 2 of a tetrahedron and of the triangle.
  EXPECT_EQ(few.Count(), (Counts{ 2, 10, 4, 0, 4 }));
  for (int cell = 0; cell < 7; ++cell)
  {
    EXPECT_EQ(few.State.IsRed(cell), cell == 0 || cell == 5) << cell;
  }
  EXPECT_EQ(few.State.GetNumberOfVertices(), 15);
}

TEST(RedGreenMarks, AnEdgeByEitherOrderOfItsEnds)
{
  const int edges[6][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } };
  for (int k = 0; k < 6; ++k)
  {
    for (const int first : { 0, 1 })
    {
      Few few(4, { { 0, 1, 2, 3 } });
      few.State.MarkEdge({ 0, -1 }, edges[k][first], edges[k][1 - first]);
      EXPECT_TRUE(few.State.Close());
      EXPECT_EQ(few.Count(), (Counts{ 0, 0, 2, 0, 0 }));
      EXPECT_EQ(few.State.GetOrigin(4).Edge, k);
      EXPECT_FALSE(few.State.IsRed(0));
      few.State.MarkEdge({ 0, -1 }, edges[5 - k][first], edges[5 - k][1 - first]);
      EXPECT_TRUE(few.State.Close());
      EXPECT_EQ(few.Count(), (Counts{ 0, 0, 0, 4, 0 })) << "opposite";
    }
  }
  // Two edges of a face split the third one.
  Few few(4, { { 0, 1, 2, 3 } });
  few.State.MarkEdge({ 0, -1 }, 0, 1);
  few.State.MarkEdge({ 0, -1 }, 2, 1);
  EXPECT_TRUE(few.State.Close());
  EXPECT_EQ(few.Count(), (Counts{ 0, 0, 0, 0, 4 }));
  EXPECT_GE(few.FindMiddle(0, 2), 0);
  few.State.MarkEdge({ 0, -1 }, 0, 3); // a face more, and all is red
  EXPECT_TRUE(few.State.Close());
  EXPECT_EQ(few.Count(), (Counts{ 0, 8, 0, 0, 0 }));
}

// Edges that only green cells have: the leaf becomes red.
TEST(RedGreenMarks, AnEdgeOfGreenCells)
{
  // A half of a split edge is an edge of a red child, which is split too.
  for (const int end : { 0, 1 })
  {
    Few few(3, { { 0, 1, 2 } });
    few.State.MarkEdge({ 0, -1 }, 0, 1);
    few.State.Close();
    const int middle = few.FindMiddle(0, 1);
    end == 0 ? few.State.MarkEdge({ 0, -1 }, 0, middle) : few.State.MarkEdge({ 0, -1 }, middle, 1);
    EXPECT_TRUE(few.State.Close());
    EXPECT_EQ(few.Count(), (Counts{ 0, 3, 2, 0, 0 }));
    EXPECT_GE(few.FindMiddle(end, middle), 0);
    EXPECT_EQ(few.FindMiddle(1 - end, middle), -1);
  }
  // The edge to the opposite vertex vanishes.
  Few few(3, { { 0, 1, 2 } });
  few.State.MarkEdge({ 0, -1 }, 0, 1);
  few.State.Close();
  few.State.MarkEdge({ 0, -1 }, 2, few.FindMiddle(0, 1));
  EXPECT_TRUE(few.State.Close());
  EXPECT_EQ(few.Count(), (Counts{ 0, 4, 0, 0, 0 }));
}

// The edge between the midpoints of two edges: in a face it is one of a red child.
TEST(RedGreenMarks, AnEdgeBetweenMidpointsOfAFace)
{
  const int edges[3][2] = { { 0, 1 }, { 1, 2 }, { 0, 2 } };
  for (int k = 0; k < 3; ++k)
  {
    for (int l = 0; l < 3; ++l)
    {
      if (k == l)
      {
        continue;
      }
      Few few(4, { { 0, 1, 2, 3 } });
      few.State.MarkEdge({ 0, -1 }, 0, 1);
      few.State.MarkEdge({ 0, -1 }, 1, 2);
      few.State.Close();
      ASSERT_EQ(few.Count(), (Counts{ 0, 0, 0, 0, 4 }));
      const int ends[2] = { few.FindMiddle(edges[k][0], edges[k][1]),
        few.FindMiddle(edges[l][0], edges[l][1]) };
      few.State.MarkEdge({ 0, -1 }, ends[0], ends[1]);
      EXPECT_TRUE(few.State.Close());
      EXPECT_GE(few.FindMiddle(ends[0], ends[1]), 0);
      // At the edge are the child at the corner and, of the four inside, one or two.
      const Counts counts = few.Count();
      EXPECT_EQ(counts[0] + counts[3] + counts[4], 0);
      EXPECT_EQ(counts[2], 2 * (8 - counts[1]));
    }
  }
}

// Between midpoints of opposite edges it vanishes, unless it is the diagonal (Mathematics 2).
TEST(RedGreenMarks, AnEdgeBetweenMidpointsOfOppositeEdges)
{
  const int edges[6][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } };
  for (int k = 0; k < 6; ++k)
  {
    SCOPED_TRACE(k);
    Few few(4, { { 0, 1, 2, 3 } });
    NaiveRedGreen naive(few.List);
    const NaiveLeaf leaf = *naive.Leaves.begin();
    for (const int edge : { k, 5 - k })
    {
      few.State.MarkEdge({ 0, -1 }, edges[edge][0], edges[edge][1]);
      naive.MarkEdge(leaf, MakePair(leaf.Points[edges[edge][0]], leaf.Points[edges[edge][1]]));
    }
    few.State.Close();
    naive.Close();
    ASSERT_EQ(few.Count(), (Counts{ 0, 0, 0, 4, 0 }));
    const int ends[2] = { few.FindMiddle(edges[k][0], edges[k][1]),
      few.FindMiddle(edges[5 - k][0], edges[5 - k][1]) };
    const auto keys = MakeKeys(few.State);
    few.State.MarkEdge({ 0, -1 }, ends[0], ends[1]);
    naive.MarkEdge(leaf, MakePair(keys[ends[0]], keys[ends[1]]));
    EXPECT_TRUE(few.State.Close());
    naive.Close();
    const bool isDiagonal = k == 1 || k == 4;
    EXPECT_EQ(few.FindMiddle(ends[0], ends[1]) >= 0, isDiagonal);
    EXPECT_EQ(naive.Splits.count(MakePair(keys[ends[0]], keys[ends[1]])) > 0, isDiagonal);
    EXPECT_EQ(few.Count(), (isDiagonal ? Counts{ 0, 4, 8, 0, 0 } : Counts{ 0, 8, 0, 0, 0 }));
    EXPECT_EQ(Write(few.State, few.Points).GetLeaves(), naive.Leaves);
  }
}

// Midpoints that the input has: the first two cells are a leaf and what an earlier run made of it.
TEST(RedGreenMarks, AMidpointOfTheInput)
{
  for (const bool turned : { false, true })
  {
    Few few(5, { { 0, 1, 2 }, { 4, 1 } });
    turned ? few.State.AddMidpoint(1, 0, 3) : few.State.AddMidpoint(0, 1, 3);
    few.State.AddMidpoint(0, 1, 3); // as another cell of the edge tells
    EXPECT_TRUE(few.State.Close());
    EXPECT_FALSE(few.State.Close());
    EXPECT_EQ(few.Count(), (Counts{ 1, 0, 2, 0, 0 }));
    EXPECT_EQ(few.State.GetNumberOfVertices(), 5); // none is new
    few.State.MarkEdge({ 0, -1 }, 3, 1);
    EXPECT_TRUE(few.State.Close());
    EXPECT_TRUE(few.State.IsRed(0));
    EXPECT_GE(few.FindMiddle(1, 3), 5);
    EXPECT_EQ(few.FindMiddle(0, 3), -1);
    EXPECT_EQ(few.Count(), (Counts{ 1, 3, 2, 0, 0 }));
    EXPECT_EQ(few.State.GetNumberOfVertices(), 8); // two of the triangle, and that one
  }
}

// A half of an edge is an edge of another cell: what splits it there, makes all cells red that have
// the whole edge.
TEST(RedGreenMarks, AHalfThatTheInputHas)
{
  for (const int end : { 0, 1 })
  {
    Few few(6, { { 0, 1, 2 }, { end, 3, 4 }, { 0, 1 } });
    few.State.AddMidpoint(0, 1, 3);
    few.State.MarkEdge({ 1, -1 }, 3, end);
    EXPECT_TRUE(few.State.Close());
    EXPECT_TRUE(few.State.IsRed(0));
    EXPECT_FALSE(few.State.IsRed(1));
    const int middle = few.FindMiddle(end, 3);
    EXPECT_GE(middle, 6);
    // Four children of which one is cut, two of the other triangle, three pieces of the line.
    EXPECT_EQ(few.Count(), (Counts{ 0, 3 + 3, 2 + 2, 0, 0 }));
    EXPECT_EQ(few.State.GetNumberOfVertices(), 9);
  }
}

// An edge at a midpoint of another edge that is no half of it: that edge is none of its cells'.
TEST(RedGreenMarks, AnEdgeAtAMidpoint)
{
  for (const Tuple& other : { Tuple{ 0, 3, 4 }, Tuple{ 0, 4, 3 }, Tuple{ 3, 4 }, Tuple{ 4, 3 } })
  {
    Few few(5, { { 0, 1, 2 }, other });
    few.State.AddMidpoint(0, 1, 3);
    few.State.Close(); // which looks at both cells
    few.State.MarkEdge({ 1, -1 }, 4, 3);
    EXPECT_TRUE(few.State.Close());
    EXPECT_FALSE(few.State.IsRed(0));
    EXPECT_EQ(few.State.GetNumberOfVertices(), 6);
  }
}

// An edge between two midpoints makes red what has both of their edges, whichever numbers they
// have.
TEST(RedGreenMarks, ACellWithOneOfTwoEdges)
{
  const int edges[3][2] = { { 0, 1 }, { 1, 2 }, { 0, 2 } };
  for (int first = 0; first < 3; ++first)
  {
    for (int k = 0; k < 3; ++k)
    {
      Few few(6, { { 0, 1, 2 }, { 0, 1, 3 }, { 1, 2, 4 }, { 5, 0, 2 } });
      few.State.MarkEdge({ 0, -1 }, edges[first][0], edges[first][1]); // is edge 0
      few.State.MarkCell({ 0, -1 });
      few.State.Close();
      const int l = (k + 1) % 3;
      few.State.MarkEdge({ 0, 3 }, few.FindMiddle(edges[k][0], edges[k][1]),
        few.FindMiddle(edges[l][0], edges[l][1]));
      EXPECT_TRUE(few.State.Close());
      for (int cell = 1; cell < 4; ++cell)
      {
        EXPECT_FALSE(few.State.IsRed(cell)) << first << " " << k << " " << cell;
      }
      EXPECT_EQ(few.Count(), (Counts{ 0, 2, 4 + 6, 0, 0 }));
    }
  }
}

// Midpoints of midpoints, with any numbers, 0 too.
TEST(RedGreenMarks, MidpointsOfMidpoints)
{
  int tried = 0;
  for (int by = 0; by < 6; ++by)
  {
    SCOPED_TRACE(by);
    const auto at = [&](int vertex) { return (vertex + by) % 6; };
    const Tuple cell{ at(0), at(1), at(2) };
    // 3 halves 0-1: green.
    Few green(6, { cell });
    green.State.AddMidpoint(at(0), at(1), at(3));
    EXPECT_TRUE(green.State.Close());
    EXPECT_EQ(green.Count(), (Counts{ 0, 0, 2, 0, 0 }));
    EXPECT_FALSE(green.State.IsRed(0));
    EXPECT_EQ(green.State.GetNumberOfVertices(), 6);
    // 4 halves 0-3: the triangle must be red, and a child of it green.
    for (const int end : { 0, 1, 0, 1 })
    {
      Few half(6, { cell });
      const bool isFirst = tried++ % 4 < 2; // in either order
      isFirst ? half.State.AddMidpoint(at(end), at(3), at(4)) : void();
      half.State.AddMidpoint(at(0), at(1), at(3));
      isFirst ? void() : half.State.AddMidpoint(at(end), at(3), at(4));
      EXPECT_TRUE(half.State.Close());
      EXPECT_EQ(half.Count(), (Counts{ 0, 3, 2, 0, 0 }));
      EXPECT_EQ(half.State.GetNumberOfVertices(), 8);
      // A mark of the other half splits that, and nothing else.
      half.State.MarkEdge({ 0, -1 }, at(3), at(1 - end));
      EXPECT_TRUE(half.State.Close());
      EXPECT_EQ(half.Count(), (Counts{ 0, 2, 4, 0, 0 }));
    }
    // 4 halves 1-2, and 5 the edge between 3 and 4.
    for (const bool isLast : { true, false })
    {
      Few inside(6, { cell });
      isLast ? void() : inside.State.AddMidpoint(at(3), at(4), at(5));
      inside.State.AddMidpoint(at(0), at(1), at(3));
      inside.State.AddMidpoint(at(1), at(2), at(4));
      isLast ? inside.State.AddMidpoint(at(3), at(4), at(5)) : void();
      EXPECT_TRUE(inside.State.Close());
      EXPECT_EQ(inside.Count(), (Counts{ 0, 2, 4, 0, 0 }));
      EXPECT_EQ(inside.State.GetNumberOfVertices(), 7);
    }
  }
}

// Levels are stored in one byte. Midpoints that do not fit together would split without end.
TEST(RedGreenMarks, LevelsEnd)
{
  for (const int level : { 254, 255 })
  {
    const SimplexList list = MakeList(4, { { 0, 1, 3 }, { 0, 1, 2 } });
    const std::vector<unsigned char> levels{ 0, static_cast<unsigned char>(level) };
    SimplexView view(list);
    view.Levels = levels.data();
    RedGreen<int> state(view);
    state.MarkCell({ 1, -1 }); // the children are made later
    if (level == 254)
    {
      state.MarkCell({ 1, 0 });
      EXPECT_TRUE(state.Close());
      EXPECT_TRUE(state.IsRed(1));
      continue;
    }
    try
    {
      state.MarkCell({ 1, 0 });
      ADD_FAILURE() << "does not end";
    }
    catch (const std::invalid_argument& error)
    {
      EXPECT_EQ(std::string(error.what()),
        "The cells below cell 1 do not end: midpoints that were given do not fit together.");
    }
  }
}

// Leaves by their number: an input cell, a stored red child, a child that is not stored.
TEST(RedGreenMarks, ChildrenOfARedCell)
{
  Few few(3, { { 0, 1, 2 } });
  few.State.MarkCell({ 0, -1 });
  few.State.MarkCell({ 0, 3 }); // before anybody has closed
  EXPECT_TRUE(few.State.Close());
  EXPECT_EQ(few.Count(), (Counts{ 0, 4, 6, 0, 0 }));
  few.State.MarkCell({ 5, 1 });
  EXPECT_TRUE(few.State.Close());
  EXPECT_TRUE(few.State.IsRed(5));
  // Children are stored together: 2 to 5 are those of the triangle, 6 to 9 those of its last child.
  for (int cell = 2; cell < 10; ++cell)
  {
    EXPECT_EQ(few.State.GetCell(cell).Parent, cell < 6 ? 0 : 5) << cell;
    EXPECT_EQ(few.State.GetCell(cell).Child, (cell - 2) % 4) << cell;
    EXPECT_EQ(few.State.GetCell(cell).Level, cell < 6 ? 1 : 2) << cell;
  }
  // Its neighbour inside is cut, and the two outside at whose edges it has halves are red.
  EXPECT_EQ(few.Count(), (Counts{ 0, 4 + 2 + 2 * 3, 2 + 2 * 2 + 2, 0, 0 }));
}

// Cells that touch nothing that is split are not stored, whatever the order of marks is.
TEST(RedGreenMarks, SplitsSpreadAlongAStrip)
{
  // A strip of triangles: 0 1 2, 1 3 2, 2 3 4, 3 5 4, ...
  std::vector<Tuple> cells;
  for (int i = 0; i < 10; ++i)
  {
    cells.push_back(i % 2 ? Tuple{ i, i + 2, i + 1 } : Tuple{ i, i + 1, i + 2 });
  }
  Few few(12, cells);
  few.State.MarkCell({ 4, -1 });
  few.State.Close();
  EXPECT_EQ(few.Count(), (Counts{ 7, 4, 4, 0, 0 }));
  few.State.MarkEdge({ 3, -1 }, 3, 4); // green: it has another edge now, and is red
  few.State.Close();
  EXPECT_EQ(few.Count(), (Counts{ 6, 8, 4, 0, 0 }));
  EXPECT_TRUE(few.State.IsRed(3));
  // An edge of a child inside makes red what has the whole edge.
  few.State.MarkEdge({ 5, -1 }, 5, few.FindMiddle(5, 6));
  EXPECT_TRUE(few.State.Close());
  EXPECT_TRUE(few.State.IsRed(5));
  EXPECT_GE(few.FindMiddle(5, few.FindMiddle(5, 6)), 0);
}

// An edge that was looked up before it is split, in the cell that was stored first.
TEST(RedGreenMarks, ASplitReachesTheFirstCell)
{
  Few few(5, { { 0, 1, 2 }, { 0, 3 }, { 1, 4 }, { 0, 1 } });
  few.State.Expect({ 0 });
  few.State.MarkCell({ 1, -1 });
  few.State.MarkCell({ 2, -1 });
  few.State.Close();
  EXPECT_EQ(few.Count(), (Counts{ 2, 4, 0, 0, 0 }));
  few.State.MarkCell({ 3, -1 });
  few.State.Close();
  EXPECT_EQ(few.Count(), (Counts{ 0, 6, 2, 0, 0 }));
}

// What the output tells of a green leaf, for the next filter: of edges that are not split, -1.
TEST(RedGreenMarks, MidpointsOfGreenLeaves)
{
  // All vertices of the triangle are ends of split edges, but only one of its edges is split.
  Few few(4, { { 0, 1, 2 }, { 0, 3 } });
  few.State.MarkEdge({ 0, -1 }, 1, 2);
  few.State.MarkCell({ 1, -1 });
  few.State.Close();
  const auto written = Write(few.State, few.Points);
  ASSERT_EQ(written.GreenLeaves.size(), 1u);
  EXPECT_EQ(written.GreenLeaves[0].Midpoints,
    (std::array<int, 6>{ -1, few.FindMiddle(1, 2), -1, -1, -1, -1 }));
}

// The other cell is red at once, with children that are cut.
TEST(RedGreenMarks, TwoEqualTrianglesWithACutChild)
{
  CheckCutChildren({ 0, 1, 2 }, { 0, 1, 2 });
}

TEST(RedGreenMarks, ATetrahedronOnATriangleWithACutChild)
{
  CheckCutChildren({ 0, 1, 2 }, { 0, 1, 2, 3 });
}

TEST(RedGreenMarks, ATriangleOnATetrahedronWithACutChild)
{
  CheckCutChildren({ 0, 1, 2, 3 }, { 0, 1, 2 });
}

TEST(RedGreenMarks, TwoEqualTetrahedraWithACutChild)
{
  CheckCutChildren({ 0, 1, 2, 3 }, { 0, 1, 2, 3 });
}

TEST(RedGreenMarks, ChangedCellsAreNamedOnce)
{
  Few few(4, { { 0, 1, 2, 3 } });
  few.State.MarkEdge({ 0, -1 }, 0, 1);
  few.State.MarkEdge({ 0, -1 }, 2, 3);
  few.State.Close();
  EXPECT_EQ(few.State.GetChangedCells().size(), 4);
  few.State.MarkEdge({ 0, -1 }, 0, 2);
  few.State.Close();
  EXPECT_EQ(few.State.GetChangedCells().size(), 8);
  few.State.Close();
  EXPECT_EQ(few.State.GetChangedCells().size(), 0);
}

// So that a filter reports its progress and can be stopped while splits spread.
TEST(RedGreenMarks, ActsBetweenEdges)
{
  Few few(4, { { 0, 1, 2, 3 } });
  few.State.MarkCell({ 0, -1 });
  few.State.Close();
  const int before = few.State.GetNumberOfVertices();
  for (int child = 0; child < 8; ++child)
  {
    few.State.MarkCell(
      { 0, child }); // no vertex of the input is an end of their edges but old ones
  }
  const double seconds = std::exchange(BetweenLoops::SecondsBetween, 0.);
  const int turns = std::exchange(BetweenLoops::TurnsBetween, 1);
  int acts = 0;
  {
    const BetweenLoops between([&acts] { ++acts; });
    few.State.Propagate();
  }
  BetweenLoops::SecondsBetween = seconds;
  BetweenLoops::TurnsBetween = turns;
  EXPECT_GE(acts, few.State.GetNumberOfVertices() - before);
  EXPECT_EQ(few.State.GetNumberOfVertices(), 35);
}
