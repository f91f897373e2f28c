// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestRedGreenStored.cxx
 * Mathematics 13: which cells of the input red-green refinement stores, how it finds them, and how
 * much memory it takes for that.
 */
#include "RedGreenFew.h"

#include "Core/Memory/Loops.h"

using namespace redgreen_reference;

namespace
{

/// Bytes of a state, as the documentation of RedGreen says.
constexpr std::size_t SizeOfCell = 84;
constexpr std::size_t SizeOfEdge = 24;
constexpr std::size_t SizeOfPage = 4096 * sizeof(int);

/// A triangle that touches nothing, for Few::CountStored.
Tuple MakeProbe(vtkIdType points)
{
  return { points - 3, points - 2, points - 1 };
}

/// Lines one after the other.
std::vector<Tuple> MakeLines(int size)
{
  std::vector<Tuple> cells;
  for (int i = 0; i < size; ++i)
  {
    cells.push_back({ i, i + 1 });
  }
  return cells;
}

std::vector<int> MakeRange(int size)
{
  std::vector<int> cells(static_cast<std::size_t>(size));
  std::iota(cells.begin(), cells.end(), 0);
  return cells;
}

/// The round in which the incidence from vertices to cells appears, if lines are marked one after
/// the other, each of which touches none of before.
int FindRoundOfIncidence(int size, int first)
{
  Few few(size + 1, MakeLines(size));
  for (int round = 0; round < 20; ++round)
  {
    const std::size_t before = few.State.GetMemorySize();
    few.State.MarkCell({ first + 2 * round, -1 });
    few.State.Close();
    if (few.State.GetMemorySize() >= before + 12u * static_cast<unsigned>(size))
    {
      return round;
    }
  }
  return -1;
}

/// A block of 4096 cells: a triangle that alone has the least and the largest vertex, in front of
/// lines between others. Behind the block are the edges of the triangle, as lines.
std::vector<Tuple> MakeBlock(int turns)
{
  std::vector<Tuple> cells{ { 0, 5000, 300 } };
  std::rotate(cells[0].begin(), cells[0].begin() + turns, cells[0].end());
  for (int i = 1; i < 4096; ++i)
  {
    cells.push_back({ 300 + i % 100, 301 + i % 100 });
  }
  cells.push_back({ 0, 300 });
  cells.push_back({ 5000, 300 });
  return cells;
}

}

TEST(RedGreenStored, CellsAsTheyAreGiven)
{
  const SimplexList list =
    MakeList(9, { { 0, 1, 2, 3 }, { 4, 5, 6, 7 }, { 1, 2, 3 }, { 5, 8 }, { 7 }, { 8, 4, 1, 0 } });
  const std::vector<unsigned char> levels{ 0, 1, 0, 2, 0, 0 };
  SimplexView view(list);
  view.Levels = levels.data();
  const auto order = [](vtkIdType* vertices) { std::swap(vertices[0], vertices[3]); };
  for (const bool ordered : { true, false })
  {
    for (const bool stored : { true, false })
    {
      RedGreen<int> state(view, ordered ? order : std::function<void(vtkIdType*)>());
      if (stored)
      {
        state.Expect(MakeRange(6));
      }
      const std::array<int, 4> turned[2] = { { { 3, 1, 2, 0 } }, { { 0, 4, 1, 8 } } };
      const std::array<int, 4> kept[2] = { { { 0, 1, 2, 3 } }, { { 8, 4, 1, 0 } } };
      const std::array<int, 4> expected[6] = { ordered ? turned[0] : kept[0], { { 4, 5, 6, 7 } },
        { { 1, 2, 3, -1 } }, { { 5, 8, -1, -1 } }, { { 7, -1, -1, -1 } },
        ordered ? turned[1] : kept[1] };
      for (int i = 0; i < 6; ++i)
      {
        const auto cell = state.GetCell(i);
        EXPECT_EQ(cell.Vertices, expected[i]) << i;
        EXPECT_EQ(cell.Level, levels[static_cast<std::size_t>(i)]) << i;
        EXPECT_EQ(cell.Dimension, list.Dimensions[static_cast<std::size_t>(i)]) << i;
        EXPECT_EQ(cell.Input, i);
        EXPECT_EQ(cell.Parent, -1) << i;
        EXPECT_EQ(cell.Child, -1) << i;
      }
    }
  }
}

TEST(RedGreenStored, EachCellOnce)
{
  const std::vector<Tuple> cells{ { 0, 1, 2 }, { 3, 4 }, { 5, 6, 7, 8 }, { 9, 10 }, MakeProbe(14) };
  for (const auto& [expected, stored] : std::vector<std::pair<std::vector<int>, int>>{
         { {}, 0 }, { { 0 }, 1 }, { { 0, 0 }, 1 }, { { 2, 0, 2 }, 2 }, { { 3, 1, 0, 2 }, 4 } })
  {
    for (const bool again : { false, true })
    {
      Few few(14, cells);
      few.State.Expect(expected);
      again ? few.State.Expect(expected) : void();
      for (const int cell : expected)
      {
        few.State.MarkCell({ cell, -1 });
        EXPECT_TRUE(few.State.IsRed(cell));
        EXPECT_EQ(few.State.GetCell(cell).Vertices[1], cells[static_cast<std::size_t>(cell)][1]);
      }
      few.State.Close();
      for (int cell = 0; cell < 4; ++cell)
      {
        EXPECT_EQ(few.State.IsRed(cell), std::count(expected.begin(), expected.end(), cell) > 0);
      }
      EXPECT_EQ(few.CountStored(), stored);
    }
  }
}

TEST(RedGreenStored, ExpectMakesRoom)
{
  constexpr int size = 300;
  Few few(size + 1, MakeLines(size));
  const std::size_t before = few.State.GetMemorySize();
  few.State.Expect(MakeRange(size));
  PairTable<int> table;
  table.Reserve(size * 3 / 2);
  EXPECT_EQ(few.State.GetMemorySize(),
    before + SizeOfPage + 2 * size * SizeOfCell + size * 3 / 2 * SizeOfEdge +
      table.GetMemorySize());
}

// A new vertex of each line, a split edge that was not passed on, and a cell that has changed.
TEST(RedGreenStored, MarksTakeThreeIds)
{
  constexpr int size = 1000;
  Few few(size + 1, MakeLines(size));
  few.State.Expect(MakeRange(size));
  const std::size_t before = few.State.GetMemorySize();
  for (int i = 0; i < size; ++i)
  {
    few.State.MarkCell({ i, -1 });
  }
  const std::size_t marks = 3 * size * sizeof(int);
  EXPECT_GE(few.State.GetMemorySize(), before + marks);
  EXPECT_LT(few.State.GetMemorySize(), before + marks + marks / 8);
}

// So that a filter reports its progress and can be stopped.
TEST(RedGreenStored, ActsBetweenCells)
{
  Few few(101, MakeLines(100));
  const double seconds = std::exchange(BetweenLoops::SecondsBetween, 0.);
  const int turns = std::exchange(BetweenLoops::TurnsBetween, 1);
  int acts = 0;
  {
    const BetweenLoops between([&acts] { ++acts; });
    few.State.Expect(MakeRange(100));
  }
  BetweenLoops::SecondsBetween = seconds;
  BetweenLoops::TurnsBetween = turns;
  EXPECT_GE(acts, 100);
}

// Those with two vertices at split edges. The first scan finds them, or the incidence later.
TEST(RedGreenStored, CellsAtTwoEndsOfSplitEdges)
{
  constexpr int size = 14; // of the points but those of the probe
  for (const bool later : { false, true })
  {
    for (int by = 0; by < size; ++by)
    {
      SCOPED_TRACE(std::to_string(later) + " " + std::to_string(by));
      std::vector<Tuple> cells{ { 0, 1, 2 }, { 0, 1, 3 }, { 0, 4, 5 }, { 1, 4, 6 }, { 4, 5, 6 },
        { 0, 1 }, { 1, 2 }, { 0 }, { 0, 4, 5, 6 }, { 7, 1, 8, 0 }, { 9, 10 }, { 4, 1 } };
      for (Tuple& cell : cells)
      {
        for (vtkIdType& vertex : cell)
        {
          vertex = (vertex + by) % size;
        }
      }
      cells.push_back(MakeProbe(size + 3));
      Few few(size + 3, cells);
      if (later)
      {
        few.State.MarkCell({ 10, -1 });
        few.State.Close();
      }
      few.State.MarkEdge({ 0, -1 }, by % size, (1 + by) % size);
      few.State.Close();
      const int whole = later ? 7 : 8;
      EXPECT_EQ(few.Count(), (Counts{ whole + 1, later ? 4 : 2, 4 + 2, 0, 0 }));
      EXPECT_EQ(few.CountStored(), later ? 5 : 4);
    }
  }
}

// A cell that is stored already has one more vertex at split edges, and another split edge.
TEST(RedGreenStored, ACellIsFoundAgain)
{
  for (const bool hasSpare : { false, true })
  {
    std::vector<Tuple> cells{ { 0, 1, 2 }, { 0, 1, 2, 3 }, { 0, 1 }, { 1, 2 }, { 2, 3 }, { 4, 5 },
      MakeProbe(9) };
    for (int i = 0; i < 5000 && hasSpare; ++i)
    {
      cells.insert(cells.end() - 1, { 4, 5 }); // more scans before there is an incidence
    }
    Few few(9, cells);
    few.State.MarkCell({ 2, -1 });
    few.State.Close();
    const int spare = hasSpare ? 5000 : 0;
    EXPECT_EQ(few.Count(), (Counts{ 4 + spare, 2, 4, 0, 0 }));
    few.State.MarkCell({ 4, -1 });
    few.State.Close();
    EXPECT_EQ(few.Count(), (Counts{ 3 + spare, 4, 2, 4, 0 }));
    few.State.MarkCell({ 3, -1 });
    few.State.Close(); // two faces and more of the tetrahedron
    EXPECT_EQ(few.Count(), (Counts{ 2 + spare, 2 + 2 + 2 + 4 + 8, 0, 0, 0 }));
    EXPECT_EQ(few.CountStored(), 5);
  }
}

// An edge at a midpoint is no edge of a cell of the input, also if one of its ends is a vertex of
// the input: that has not to be at a split edge then.
TEST(RedGreenStored, EdgesAtMidpointsTellNothing)
{
  for (const bool turned : { false, true })
  {
    Few few(17, { { 0, 1, 2 }, { 3, 2 }, { 3, 0 }, MakeProbe(17) });
    few.State.AddMidpoint(1, 2, 3);
    few.State.MarkEdge({ 0, -1 }, 0, 1);
    EXPECT_TRUE(few.State.Close());
    EXPECT_TRUE(few.State.IsRed(0));
    const int middle = few.FindMiddle(0, 1);
    ASSERT_EQ(middle, 17);
    turned ? few.State.MarkEdge({ 0, -1 }, 3, middle) : few.State.MarkEdge({ 0, -1 }, middle, 3);
    EXPECT_TRUE(few.State.Close());
    EXPECT_GE(few.FindMiddle(middle, 3), 18);
    // The triangle, and its children.
    EXPECT_EQ(few.CountStored(), 5);
  }
}

// Of a cell with two vertices at split edges one edge is looked up.
TEST(RedGreenStored, EdgesBetweenTwoEndsOnly)
{
  constexpr int size = 200;
  std::vector<Tuple> cells = MakeLines(size);
  for (int i = 0; i < size; ++i)
  {
    const int tip = size + 1 + 3 * i;
    cells.push_back({ i, tip, i + 1 });
    cells.push_back({ i + 1, i, tip + 1 });
    cells.push_back({ tip + 2, i + 1, i });
  }
  Few few(4 * size + 1, cells);
  for (int i = 0; i < size; ++i)
  {
    few.State.MarkCell({ i, -1 });
  }
  few.State.Close();
  EXPECT_EQ(few.Count(), (Counts{ 0, 2 * size, 6 * size, 0, 0 }));
  // The edges, their table, vertices, the queue, two lists of changed cells, flags.
  const std::size_t rest = 256 * SizeOfEdge + 1024 * 12 + (256 + 256 + 2 * 1024) * 4 + 801;
  EXPECT_LT(few.State.GetMemorySize(), SizeOfPage + 1024 * SizeOfCell + rest + 2000);
}

// Four times as many cells are scanned as there are. A scan passes over blocks of 4096 cells that
// have no vertex near those of the marks.
TEST(RedGreenStored, AnIncidenceAfterSomeScans)
{
  EXPECT_EQ(FindRoundOfIncidence(4096, 10), 4);
  EXPECT_EQ(FindRoundOfIncidence(8192, 10), 7);
  EXPECT_EQ(FindRoundOfIncidence(8192, 4161), 7); // 65 vertices and more behind the first block
  EXPECT_EQ(FindRoundOfIncidence(8192, 4090), 5); // at the border of the two
}

TEST(RedGreenStored, TheLastCellOfABlock)
{
  for (const int size : { 2, 63, 64, 65, 4095, 4096, 4097, 4098, 8192, 8193 })
  {
    std::vector<Tuple> cells = MakeLines(size);
    cells.back() = { 0, 1, size };
    Few few(size + 1, cells);
    few.State.MarkCell({ 0, -1 });
    few.State.Close();
    EXPECT_EQ(few.Count(), (Counts{ size - 2, 2, 2, 0, 0 })) << size;
    few.State.MarkEdge({ size - 1, -1 }, 1, size);
    few.State.Close();
    EXPECT_EQ(few.Count(), (Counts{ size - 2, 2 + 4, 0, 0, 0 })) << size;
  }
}

TEST(RedGreenStored, BlocksOfCellsOfAllDimensions)
{
  // A row of tetrahedra, each with a triangle and a line, and a vertex between.
  std::vector<Tuple> cells;
  for (int i = 0; i < 1200; ++i)
  {
    const int v = 3 * i;
    cells.push_back({ v, v + 1, v + 2, v + 3 });
    cells.push_back({ v, v + 3, v + 1 });
    cells.push_back({ v + 3, v });
    cells.push_back({ v + 1 });
  }
  for (const int chosen : { 0, 500, 1023, 1024, 1025, 1199 })
  {
    Few few(3601, cells);
    few.State.MarkEdge({ 4 * chosen, -1 }, 3 * chosen, 3 * chosen + 3);
    few.State.Close();
    EXPECT_EQ(few.Count(), (Counts{ 4797, 2, 4, 0, 0 })) << chosen;
    EXPECT_EQ(few.State.GetNumberOfVertices(), 3602);
  }
}

TEST(RedGreenStored, TheRangeOfABlock)
{
  for (int turns = 0; turns < 3; ++turns)
  {
    for (const int line : { 4096, 4097 })
    {
      Few few(5001, MakeBlock(turns));
      few.State.MarkCell({ 100, -1 }); // line 300-301
      few.State.Close();
      EXPECT_EQ(few.Count()[2], 0);
      few.State.MarkCell({ line, -1 }); // only this vertex is new
      few.State.Close();
      EXPECT_EQ(few.Count()[2], 2) << turns << " " << line;
    }
  }
}
