// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestRedGreenQueries.cxx
 * Mathematics 13 on a few cells, by hand: what a state of red-green refinement tells of its cells
 * and vertices, which cells have changed, and the order of new vertices.
 */
#include "RedGreenFew.h"

#include <ostream>

using namespace redgreen_reference;

namespace
{

using Corners = std::array<int, 4>;

struct ChangedCell
{
  int Cell;
  int Child;
  int Level;
  RefinementKind Kind;
  Corners Vertices;
  bool operator<(const ChangedCell& other) const
  {
    return std::tie(this->Cell, this->Child, this->Vertices) <
      std::tie(other.Cell, other.Child, other.Vertices);
  }
  bool operator==(const ChangedCell& other) const
  {
    return std::tie(this->Cell, this->Child, this->Level, this->Kind, this->Vertices) ==
      std::tie(other.Cell, other.Child, other.Level, other.Kind, other.Vertices);
  }
};

std::ostream& operator<<(std::ostream& stream, const ChangedCell& cell)
{
  return stream << cell.Cell << " child " << cell.Child << " level " << cell.Level << " kind "
                << static_cast<int>(cell.Kind) << " " << testing::PrintToString(cell.Vertices);
}

/// A line, a triangle of level 2, a tetrahedron and a vertex, which touch nothing.
struct Apart
{
  Apart()
    : List(MakeList(10, { { 3, 4 }, { 0, 1, 2 }, { 5, 6, 7, 8 }, { 9 } }))
    , State(MakeView())
  {
  }
  /// Changed cells, all of which are of the triangle.
  std::vector<ChangedCell> GetChanged(int steps) const
  {
    std::vector<ChangedCell> cells;
    for (const auto& cell : this->State.GetChangedCells(steps))
    {
      EXPECT_EQ(cell.Input, 1);
      EXPECT_EQ(cell.Dimension, 2);
      cells.push_back({ cell.Leaf.Cell, cell.Leaf.Child, cell.Level, cell.Kind, cell.Vertices });
    }
    std::sort(cells.begin(), cells.end());
    return cells;
  }
  void CheckCell(
    const RedGreenCell<int>& cell, int parent, int child, int level, const Corners& vertices) const
  {
    EXPECT_EQ(cell.Input, 1);
    EXPECT_EQ(cell.Dimension, 2);
    EXPECT_EQ(cell.Parent, parent);
    EXPECT_EQ(cell.Child, child);
    EXPECT_EQ(cell.Level, level);
    EXPECT_EQ(cell.Vertices, vertices);
  }

  SimplexList List;
  std::vector<unsigned char> Levels{ 0, 2, 0, 0 };
  RedGreen<int> State;

private:
  SimplexView MakeView() const
  {
    SimplexView view(this->List);
    view.Levels = this->Levels.data();
    return view;
  }
};

/// Children of the triangle, and of its middle child, after marks of both.
const Corners ChildrenOfTriangle[4] = { { 0, 10, 12, -1 }, { 10, 1, 11, -1 }, { 12, 11, 2, -1 },
  { 10, 11, 12, -1 } };
const Corners ChildrenOfMiddle[4] = { { 10, 13, 15, -1 }, { 13, 11, 14, -1 }, { 15, 14, 12, -1 },
  { 13, 14, 15, -1 } };

/// A fan of six triangles with lines at its rim and a tetrahedron on one of them.
std::vector<Tuple> MakeFan()
{
  std::vector<Tuple> cells;
  for (int i = 0; i < 6; ++i)
  {
    cells.push_back({ 1 + i, 0, 1 + (i + 1) % 6 });
    cells.push_back({ 1 + (i + 1) % 6, 1 + i });
  }
  cells.push_back({ 7, 2, 0, 1 });
  return cells;
}

/// What has to stay when vertices get other numbers: the cells of the output as points, in order.
std::vector<Cell> GetOutput(const RedGreen<int>& state)
{
  return Write(state, std::vector<double>(30)).GetPointsOfCells();
}

void CheckOrigins(const RedGreen<int>& state)
{
  const int edges[4][6][2] = { {}, { { 0, 1 } }, { { 0, 1 }, { 1, 2 }, { 0, 2 } },
    { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } } };
  for (int v = state.GetNumberOfInputVertices(); v < state.GetNumberOfVertices(); ++v)
  {
    const auto origin = state.GetOrigin(v);
    const auto cell = state.GetCell(origin.Cell);
    ASSERT_GE(origin.Edge, 0);
    ASSERT_LT(origin.Edge, cell.Dimension * (cell.Dimension + 1) / 2);
    const int* local = edges[cell.Dimension][origin.Edge];
    const auto ends = state.GetEnds(v);
    EXPECT_EQ(std::minmax({ ends[0], ends[1] }),
      std::minmax({ cell.Vertices[static_cast<std::size_t>(local[0])],
        cell.Vertices[static_cast<std::size_t>(local[1])] }))
      << v;
  }
}

}

TEST(RedGreenQueries, CellsOfTheForest)
{
  Apart apart;
  RedGreen<int>& state = apart.State;
  state.MarkCell({ 1, -1 });
  state.Close();
  for (int child = 0; child < 4; ++child)
  {
    apart.CheckCell(state.GetCell({ 1, child }), 1, child, 3, ChildrenOfTriangle[child]);
  }
  state.MarkCell({ 1, 3 }); // children get the ids 5 to 8, as the triangle is stored as 4
  state.Close();
  state.MarkCell({ 8, 1 }); // those of the middle one 9 to 12
  state.Close();
  apart.CheckCell(state.GetCell(1), -1, -1, 2, { 0, 1, 2, -1 });
  for (int child = 0; child < 4; ++child)
  {
    apart.CheckCell(state.GetCell(5 + child), 1, child, 3, ChildrenOfTriangle[child]);
    apart.CheckCell(state.GetCell({ 5 + child, -1 }), 1, child, 3, ChildrenOfTriangle[child]);
    apart.CheckCell(state.GetCell({ 1, child }), 1, child, 3, ChildrenOfTriangle[child]);
    apart.CheckCell(state.GetCell({ 8, child }), 8, child, 4, ChildrenOfMiddle[child]);
    apart.CheckCell(state.GetCell(9 + child), 8, child, 4, ChildrenOfMiddle[child]);
  }
  EXPECT_EQ(state.GetOrigin(10).Cell, 1);
  EXPECT_EQ(state.GetOrigin(10).Edge, 0);
  EXPECT_EQ(state.GetOrigin(11).Cell, 1);
  EXPECT_EQ(state.GetOrigin(11).Edge, 1);
  EXPECT_EQ(state.GetOrigin(12).Cell, 1);
  EXPECT_EQ(state.GetOrigin(12).Edge, 2);
  CheckOrigins(state);
  // Nothing of the others is stored.
  EXPECT_EQ(state.GetCell(0).Vertices, (Corners{ 3, 4, -1, -1 }));
  EXPECT_EQ(state.GetCell(2).Vertices, (Corners{ 5, 6, 7, 8 }));
  EXPECT_EQ(state.GetCell(3).Vertices, (Corners{ 9, -1, -1, -1 }));
  for (const int cell : { 0, 2, 3 })
  {
    EXPECT_EQ(state.GetCell(cell).Input, cell);
    EXPECT_EQ(state.GetCell(cell).Level, 0);
    EXPECT_EQ(state.GetCell(cell).Parent, -1);
    EXPECT_EQ(state.GetCell(cell).Child, -1);
  }
}

TEST(RedGreenQueries, ChangedCellsOfEachRound)
{
  Apart apart;
  RedGreen<int>& state = apart.State;
  EXPECT_TRUE(apart.GetChanged(9).empty());
  state.MarkCell({ 1, -1 });
  state.Close();
  const auto red = RefinementKind::Red;
  const auto green = RefinementKind::GreenI;
  const std::vector<ChangedCell> first{ { 1, 0, 3, red, ChildrenOfTriangle[0] },
    { 1, 1, 3, red, ChildrenOfTriangle[1] }, { 1, 2, 3, red, ChildrenOfTriangle[2] },
    { 1, 3, 3, red, ChildrenOfTriangle[3] } };
  EXPECT_EQ(apart.GetChanged(9), first);
  EXPECT_EQ(apart.GetChanged(2), first);
  EXPECT_TRUE(apart.GetChanged(1).empty());
  state.MarkCell({ 1, 3 });
  state.Close();
  std::vector<ChangedCell> second{ { 5, -1, 3, green, { 0, 10, 15, -1 } },
    { 5, -1, 3, green, { 0, 15, 12, -1 } }, { 6, -1, 3, green, { 10, 1, 13, -1 } },
    { 6, -1, 3, green, { 13, 1, 11, -1 } }, { 7, -1, 3, green, { 12, 14, 2, -1 } },
    { 7, -1, 3, green, { 14, 11, 2, -1 } } };
  EXPECT_EQ(apart.GetChanged(2), second);
  EXPECT_TRUE(apart.GetChanged(1).empty());
  for (int child = 0; child < 4; ++child)
  {
    second.push_back({ 8, child, 4, red, ChildrenOfMiddle[child] });
  }
  EXPECT_EQ(apart.GetChanged(3), second);
  state.Close();
  EXPECT_TRUE(apart.GetChanged(9).empty());
}

// Of a red cell those children that have changed themselves are left out.
TEST(RedGreenQueries, ChangedCellsOfOneRound)
{
  const auto red = RefinementKind::Red;
  const auto green = RefinementKind::GreenI;
  Apart half;
  half.State.MarkCell({ 1, -1 });
  half.State.MarkEdge({ 1, 0 }, 0, 10);
  half.State.Close();
  EXPECT_EQ(half.GetChanged(9),
    (std::vector<ChangedCell>{ { 1, 1, 3, red, ChildrenOfTriangle[1] },
      { 1, 2, 3, red, ChildrenOfTriangle[2] }, { 1, 3, 3, red, ChildrenOfTriangle[3] },
      { 5, -1, 3, green, { 0, 13, 12, -1 } }, { 5, -1, 3, green, { 13, 10, 12, -1 } } }));
  Apart all; // nothing of the triangle itself is left
  all.State.MarkCell({ 1, -1 });
  all.State.MarkCell({ 1, 3 });
  all.State.Close();
  EXPECT_EQ(all.GetChanged(2).size(), 6u);
  EXPECT_EQ(all.GetChanged(9).size(), 10u);
}

TEST(RedGreenQueries, OrderOfVertices)
{
  const std::vector<Tuple> cells = MakeFan();
  std::vector<std::vector<Key>> orders;
  for (const bool isTurned : { false, true })
  {
    Few few(10, cells);
    for (int i = 0; i < static_cast<int>(cells.size()); ++i)
    {
      few.State.MarkCell({ isTurned ? static_cast<int>(cells.size()) - 1 - i : i, -1 });
    }
    few.State.Close();
    for (const int i : { 0, 4, 8, 12 })
    {
      const int cell = isTurned ? 12 - i : i;
      few.State.MarkCell({ cell, 3 });
      const auto child = few.State.GetCell({ cell, 0 });
      few.State.MarkEdge({ cell, 0 }, child.Vertices[0], child.Vertices[1]);
    }
    few.State.Close();
    const int size = few.State.GetNumberOfVertices();
    const std::vector<Cell> before = GetOutput(few.State);
    few.State.SortVertices();
    EXPECT_EQ(few.State.GetNumberOfVertices(), size);
    EXPECT_EQ(GetOutput(few.State), before);
    CheckOrigins(few.State);
    std::vector<std::array<int, 3>> order; // halvings, smaller end, larger end
    for (int v = 10; v < size; ++v)
    {
      const auto ends = few.State.GetEnds(v);
      EXPECT_LT(std::max(ends[0], ends[1]), v);
      order.push_back(
        { CountHalvings(few.State, v), std::min(ends[0], ends[1]), std::max(ends[0], ends[1]) });
    }
    EXPECT_TRUE(std::is_sorted(order.begin(), order.end()));
    EXPECT_EQ(order.back()[0], 2);
    orders.push_back(MakeKeys(few.State));
  }
  EXPECT_EQ(orders[0], orders[1]);
}

// Bytes that a state takes beyond that of a test in TestRedGreenStored: points, and midpoints that
// the input has.
TEST(RedGreenQueries, MemoryOfPointsAndMidpoints)
{
  const Few few(9, { { 0, 1, 2 } });
  const Few more(1009, { { 0, 1, 2 } });
  EXPECT_EQ(more.State.GetMemorySize(), few.State.GetMemorySize() + 1000);
  Few one(9, { { 0, 1, 2 }, { 3, 4, 5 } });
  one.State.AddMidpoint(0, 1, 6);
  Few two(9, { { 0, 1, 2 }, { 3, 4, 5 } });
  two.State.AddMidpoint(0, 1, 6);
  two.State.AddMidpoint(3, 4, 7);
  EXPECT_EQ(two.State.GetMemorySize(), one.State.GetMemorySize() + 4 * sizeof(int));
}

/// What Close() has changed and what changes since then are two lists, which change places.
TEST(RedGreenQueries, MemoryOfChangesIsThatOfBothLists)
{
  Few few(4, { { 0, 1, 2, 3 } });
  few.State.MarkCell({ 0, -1 });
  few.State.Close();
  const std::size_t memory = few.State.GetMemorySize();
  few.State.Close();
  EXPECT_EQ(few.State.GetMemorySize(), memory);
}

/// A tetrahedron at a face whose inner edges exist, as the other side goes on, with middles that
/// are ends of split edges in two triangles. No edge inside the face is split, so it stays green.
TEST(RedGreenQueries, AnInnerEdgeThatExistsNeedNotBeSplit)
{
  Few few(7, { { 0, 1, 2, 3 }, { 0, 1, 4 }, { 1, 2, 5 }, { 0, 1, 2, 6 } });
  for (int cell = 0; cell < 3; ++cell)
  {
    few.State.MarkCell({ cell, -1 });
    few.State.MarkCell({ cell, 3 });
  }
  few.State.Close();
  EXPECT_EQ(few.Count(), Counts({ 0, 20, 16, 0, 8 }));
}
