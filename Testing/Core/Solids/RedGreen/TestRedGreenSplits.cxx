// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestRedGreenSplits.cxx
 * Mathematics 13 on a few cells, by hand: scopes of cells, and edges that other states have split.
 */
#include "RedGreenFew.h"

#include "Core/Solids/RedGreen/RedGreen.h"

using namespace redgreen_reference;

namespace
{

constexpr auto Ignored = CellScope::Ignored;
constexpr auto Copied = CellScope::Copied;
constexpr auto Own = CellScope::Own;

const int EdgesOfTriangle[3][2] = { { 0, 1 }, { 1, 2 }, { 0, 2 } };

void CheckHalvings(const RedGreen<int>& state, std::size_t most)
{
  std::vector<std::vector<int>> expected(most);
  for (int v = state.GetNumberOfInputVertices(); v < state.GetNumberOfVertices(); ++v)
  {
    expected.at(static_cast<std::size_t>(CountHalvings(state, v) - 1)).push_back(v);
  }
  EXPECT_EQ(ListByHalvings(state), expected);
  EXPECT_TRUE(expected.empty() || !expected.back().empty());
}

/// A triangle whose edges are numbered as the marks are: `first` is number 0.
Few MakeRed(const std::vector<Tuple>& cells, int first, int cell = 0)
{
  Few few(9, cells);
  const int* ends = EdgesOfTriangle[first];
  const Tuple& own = cells[static_cast<std::size_t>(cell)];
  few.State.MarkEdge({ cell, -1 }, static_cast<int>(own[static_cast<std::size_t>(ends[0])]),
    static_cast<int>(own[static_cast<std::size_t>(ends[1])]));
  few.State.MarkCell({ cell, -1 });
  few.State.Close();
  return few;
}

}

TEST(RedGreenSplits, OwnCellsAreCounted)
{
  const std::vector<CellScope> scopes{ Own, Copied, Ignored, Own, Ignored };
  Few few(7, { { 0, 1, 2 }, { 1, 0, 3 }, { 1, 2, 4 }, { 5, 6 }, { 2, 0, 1 } });
  few.State.SetScopes(scopes.data());
  EXPECT_EQ(few.State.GetNumberOfCells(), 2);
  few.State.MarkCell({ 0, -1 });
  EXPECT_TRUE(few.State.Close());
  EXPECT_EQ(few.State.GetNumberOfCells(), 5);
  for (int cell = 0; cell < 5; ++cell)
  {
    EXPECT_EQ(few.State.IsRed(cell), cell == 0);
  }
  // The copied one is green, the ignored ones stay.
  const auto written = Write(few.State, few.Points);
  EXPECT_EQ(written.Kinds, (std::vector<unsigned char>{ 1, 1, 1, 1, 2, 2, 0, 0, 0 }));
}

TEST(RedGreenSplits, EdgesOfTheInput)
{
  const std::vector<Tuple> cells{ { 5, 0, 1 }, { 1, 0, 3 }, { 1, 2, 4, 0 }, { 3, 2 }, { 4 },
    { 5, 3 } };
  const std::vector<CellScope> scopes{ Copied, Own, Ignored, Own, Own, Ignored };
  const std::set<std::pair<int, int>> there{ { 0, 5 }, { 1, 5 }, { 0, 1 }, { 0, 3 }, { 1, 3 },
    { 2, 3 } };
  for (const bool hasScopes : { true, false })
  {
    for (int a = 0; a < 6; ++a)
    {
      for (int b = 0; b < 6; ++b)
      {
        if (a == b)
        {
          continue;
        }
        Few few(6, cells);
        hasScopes ? few.State.SetScopes(scopes.data()) : void();
        const std::pair<int, int> edge = std::minmax(a, b);
        const std::set<std::pair<int, int>> ignored{ { 1, 2 }, { 1, 4 }, { 2, 4 }, { 0, 2 },
          { 0, 4 }, { 3, 5 } };
        const bool isThere = there.count(edge) > 0 || (!hasScopes && ignored.count(edge) > 0);
        EXPECT_EQ(few.State.SplitEdge(a, b), isThere) << a << " " << b;
        EXPECT_EQ(few.FindMiddle(a, b) >= 0, isThere) << a << " " << b;
        EXPECT_EQ(few.State.SplitEdge(b, a), isThere) << "again";
        EXPECT_EQ(few.State.GetNumberOfVertices(), isThere ? 7 : 6);
        EXPECT_EQ(few.State.Close(), isThere);
      }
    }
  }
}

TEST(RedGreenSplits, HalvesOfEdges)
{
  for (int first = 0; first < 3; ++first)
  {
    for (const auto& ends : EdgesOfTriangle)
    {
      for (const int end : { 0, 1 })
      {
        for (const bool turned : { false, true })
        {
          Few few = MakeRed({ { 0, 1, 2 } }, first);
          const int middle = few.FindMiddle(ends[0], ends[1]);
          EXPECT_TRUE(turned ? few.State.SplitEdge(middle, ends[end])
                             : few.State.SplitEdge(ends[end], middle));
          EXPECT_EQ(few.State.GetNumberOfVertices(), 13);
          EXPECT_EQ(few.FindMiddle(middle, ends[end]), 12);
          EXPECT_EQ(few.FindMiddle(middle, ends[1 - end]), -1);
          EXPECT_TRUE(few.State.Close());
          EXPECT_EQ(few.Count(), (Counts{ 0, 3, 2, 0, 0 }));
        }
      }
    }
  }
}

// A vertex opposite to an edge has no edge to its midpoint, whichever edges were looked up.
TEST(RedGreenSplits, NoEdgeFromAMidpoint)
{
  for (int k = 0; k < 3; ++k)
  {
    for (const bool turned : { false, true })
    {
      Few few(9, { { 0, 1, 2 }, { 3, 4, 5 } });
      const int* ends = EdgesOfTriangle[k];
      few.State.MarkEdge({ 0, -1 }, ends[0], ends[1]);
      few.State.Close();
      for (const int other : { 3 - ends[0] - ends[1], 3, 4, 8 })
      {
        EXPECT_FALSE(turned ? few.State.SplitEdge(9, other) : few.State.SplitEdge(other, 9));
      }
      EXPECT_EQ(few.State.GetNumberOfVertices(), 10);
      EXPECT_FALSE(few.State.Close());
      EXPECT_EQ(few.Count(), (Counts{ 1, 0, 2, 0, 0 }));
    }
  }
}

// An edge between two midpoints is one of a red child where one cell has both edges.
TEST(RedGreenSplits, EdgesBetweenMidpoints)
{
  for (int first = 0; first < 3; ++first)
  {
    for (int k = 0; k < 3; ++k)
    {
      for (const int by : { 1, 2 })
      {
        // Other cells at the edges, in front of it or behind it, and lines that are looked up
        // first.
        const std::vector<std::pair<int, std::vector<Tuple>>> meshes{ { 0, { { 0, 1, 2 } } },
          { 0, { { 0, 1, 2 }, { 0, 1, 3 }, { 1, 2, 4 }, { 2, 0, 5 } } },
          { 3, { { 0, 1, 3 }, { 1, 2, 4 }, { 2, 0, 5 }, { 0, 1, 2 } } },
          { 4, { { 0, 1 }, { 7, 8 }, { 1, 2 }, { 0, 2 }, { 0, 1, 2 }, { 0, 1, 2, 6 } } } };
        for (const auto& [cell, cells] : meshes)
        {
          Few few = MakeRed(cells, first, cell);
          const int* one = EdgesOfTriangle[k];
          const int* two = EdgesOfTriangle[(k + by) % 3];
          const int ends[2] = { few.FindMiddle(one[0], one[1]), few.FindMiddle(two[0], two[1]) };
          const int before = few.State.GetNumberOfVertices();
          EXPECT_TRUE(few.State.SplitEdge(ends[0], ends[1])) << first << k << by << cell;
          EXPECT_EQ(few.FindMiddle(ends[0], ends[1]), before);
          EXPECT_TRUE(few.State.Close());
          EXPECT_TRUE(few.State.IsRed(cell));
        }
      }
    }
  }
}

TEST(RedGreenSplits, NoEdgeBetweenMidpointsOfTwoCells)
{
  const std::vector<Tuple> cells{ { 6, 7 }, { 0, 1, 2 }, { 2, 3, 4 }, { 3, 4 }, { 0, 1 } };
  for (int first = 1; first < 3; ++first)
  {
    Few few(9, cells);
    few.State.MarkCell({ first, -1 });
    few.State.MarkCell({ 3 - first, -1 });
    few.State.Close();
    const int before = few.State.GetNumberOfVertices();
    const int edges[6][2] = { { 0, 1 }, { 1, 2 }, { 0, 2 }, { 2, 3 }, { 3, 4 }, { 2, 4 } };
    for (int k = 0; k < 3; ++k)
    {
      for (int l = 3; l < 6; ++l)
      {
        const int one = few.FindMiddle(edges[k][0], edges[k][1]);
        const int two = few.FindMiddle(edges[l][0], edges[l][1]);
        EXPECT_FALSE(few.State.SplitEdge(one, two)) << k << " " << l;
        EXPECT_FALSE(few.State.SplitEdge(two, one)) << k << " " << l;
      }
    }
    EXPECT_EQ(few.State.GetNumberOfVertices(), before);
    EXPECT_FALSE(few.State.Close());
  }
}

// One of the midpoints is a vertex of the input.
TEST(RedGreenSplits, EdgesAtMidpointsOfTheInput)
{
  for (const bool turned : { false, true })
  {
    Few few(9, { { 0, 1, 2 } });
    few.State.AddMidpoint(1, 2, 3);
    few.State.MarkEdge({ 0, -1 }, 0, 1);
    few.State.Close();
    ASSERT_EQ(few.FindMiddle(0, 1), 9);
    EXPECT_TRUE(turned ? few.State.SplitEdge(9, 3) : few.State.SplitEdge(3, 9));
    EXPECT_EQ(few.FindMiddle(9, 3), 11);
    EXPECT_TRUE(few.State.Close());
    EXPECT_EQ(few.Count(), (Counts{ 0, 2, 4, 0, 0 }));
    Few half(9, { { 0, 1, 2 } });
    half.State.AddMidpoint(1, 2, 3);
    half.State.Close();
    EXPECT_TRUE(turned ? half.State.SplitEdge(2, 3) : half.State.SplitEdge(3, 1));
    EXPECT_TRUE(half.State.Close());
    EXPECT_EQ(half.Count(), (Counts{ 0, 3, 2, 0, 0 }));
  }
}

// Which cells of the input have the edge of a new vertex.
TEST(RedGreenSplits, CellsAtANewVertex)
{
  Few few(9, { { 0, 1, 2 }, { 1, 0, 3 }, { 2, 4 }, { 1, 2 }, { 4, 1, 0, 5 } });
  few.State.MarkCell({ 0, -1 });
  few.State.Propagate();
  const auto find = [&](int a, int b)
  {
    std::set<int> cells;
    few.State.ForInputCells(few.FindMiddle(a, b), [&](int cell) { cells.insert(cell); });
    return cells;
  };
  EXPECT_EQ(find(0, 1), (std::set<int>{ 0, 1, 4 }));
  EXPECT_EQ(find(1, 2), (std::set<int>{ 0, 3 }));
  EXPECT_EQ(find(0, 2), (std::set<int>{ 0 }));
}

TEST(RedGreenSplits, VerticesByHalvings)
{
  Few few(9, { { 0, 1, 2 }, { 2, 1, 4 } });
  CheckHalvings(few.State, 0);
  few.State.MarkEdge({ 0, -1 }, 0, 1);
  few.State.Close();
  CheckHalvings(few.State, 1);
  few.State.MarkEdge({ 0, -1 }, 0, few.FindMiddle(0, 1)); // vertex 9, the first one
  few.State.Close();
  CheckHalvings(few.State, 2);
  few.State.MarkCell({ 0, 0 });
  few.State.MarkCell({ 0, 3 });
  few.State.Close();
  CheckHalvings(few.State, 2);
  for (const auto& cell : few.State.GetChangedCells())
  {
    few.State.MarkCell(cell.Leaf);
  }
  few.State.Close();
  CheckHalvings(few.State, 3);
  // The vertex that was halved more often may be either end.
  for (const bool turned : { false, true })
  {
    Few other(9, { { 0, 1, 2 } });
    other.State.AddMidpoint(1, 2, 3);
    other.State.MarkCell({ 0, -1 });
    const int middle = other.FindMiddle(0, 1);
    turned ? other.State.SplitEdge(3, middle) : other.State.SplitEdge(middle, 3);
    other.State.Close();
    CheckHalvings(other.State, 2);
  }
}
