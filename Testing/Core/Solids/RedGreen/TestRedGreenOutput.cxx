// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestRedGreenOutput.cxx
 * Mathematics 13: the cells that red-green refinement writes, array by array, and the rows of new
 * vertices, number by number.
 */
#include "RedGreenFew.h"

#include "Core/Solids/RedGreen/RedGreenOutput.h"

#include <ostream>

using namespace redgreen_reference;

namespace
{

/// A cell of the output, as a test expects it.
struct OutputCell
{
  Tuple Vertices;
  int Level;
  int Kind;
  int GreenParent;
  int Input;
  bool operator==(const OutputCell& other) const
  {
    return std::tie(this->Vertices, this->Level, this->Kind, this->GreenParent, this->Input) ==
      std::tie(other.Vertices, other.Level, other.Kind, other.GreenParent, other.Input);
  }
};

std::ostream& operator<<(std::ostream& stream, const OutputCell& cell)
{
  return stream << testing::PrintToString(cell.Vertices) << " level " << cell.Level << " kind "
                << cell.Kind << " leaf " << cell.GreenParent << " of " << cell.Input;
}

/// The arrays of an output, a few items longer than they have to be.
template <typename Out>
struct Arrays
{
  static constexpr std::size_t More = 3;
  CellCounts Counts;
  std::vector<Out> Connectivity;
  std::vector<Out> Offsets;
  std::vector<unsigned char> Types;
  std::vector<unsigned char> Levels;
  std::vector<unsigned char> Kinds;
  std::vector<vtkIdType> GreenParents;
  std::vector<vtkIdType> InputCells;

  explicit Arrays(const CellCounts& counts)
    : Counts(counts)
    , Connectivity(static_cast<std::size_t>(counts.Entries) + More, Out(-9))
    , Offsets(static_cast<std::size_t>(counts.Cells) + 1 + More, Out(-9))
    , Types(static_cast<std::size_t>(counts.Cells) + More, 99)
    , Levels(this->Types)
    , Kinds(this->Types)
    , GreenParents(static_cast<std::size_t>(counts.Cells) + More, -9)
    , InputCells(this->GreenParents)
  {
  }

  /// With the optional arrays of which the bits are set.
  RedGreenStorage<Out> GetStorage(unsigned int which)
  {
    RedGreenStorage<Out> storage;
    storage.Cells = { this->Connectivity.data(), this->Offsets.data(), this->Types.data() };
    storage.Levels = which & 1u ? this->Levels.data() : nullptr;
    storage.Kinds = which & 2u ? this->Kinds.data() : nullptr;
    storage.GreenParents = which & 4u ? this->GreenParents.data() : nullptr;
    storage.InputCells = which & 8u ? this->InputCells.data() : nullptr;
    return storage;
  }

  std::vector<OutputCell> GetCells() const
  {
    const unsigned char types[4] = { 1, 3, 5, 10 }; // of VTK
    std::vector<OutputCell> cells;
    for (std::size_t i = 0; i < static_cast<std::size_t>(this->Counts.Cells); ++i)
    {
      const Tuple vertices(this->Connectivity.begin() + this->Offsets[i],
        this->Connectivity.begin() + this->Offsets[i + 1]);
      EXPECT_EQ(this->Types[i], types[vertices.size() - 1]) << i;
      cells.push_back({ vertices, this->Levels[i], this->Kinds[i],
        static_cast<int>(this->GreenParents[i]), static_cast<int>(this->InputCells[i]) });
    }
    EXPECT_EQ(this->Offsets.front(), 0);
    EXPECT_EQ(this->Offsets[static_cast<std::size_t>(this->Counts.Cells)], this->Counts.Entries);
    return cells;
  }

  /// Whether nothing was written behind the ends.
  void CheckEnds() const
  {
    for (std::size_t i = 1; i <= More; ++i)
    {
      EXPECT_EQ(this->Connectivity.rbegin()[i - 1], -9);
      EXPECT_EQ(this->Offsets.rbegin()[i - 1], -9);
      EXPECT_EQ(this->Types.rbegin()[i - 1], 99);
      EXPECT_EQ(this->Levels.rbegin()[i - 1], 99);
      EXPECT_EQ(this->Kinds.rbegin()[i - 1], 99);
      EXPECT_EQ(this->GreenParents.rbegin()[i - 1], -9);
      EXPECT_EQ(this->InputCells.rbegin()[i - 1], -9);
    }
  }
};

template <typename Out, typename Id>
void CheckCells(const RedGreen<Id>& state, const std::vector<OutputCell>& expected)
{
  const RedGreenOutput<Id> output(state);
  const CellCounts counts = output.GetCounts();
  std::size_t entries = 0;
  for (const OutputCell& cell : expected)
  {
    entries += cell.Vertices.size();
  }
  ASSERT_EQ(counts.Cells, static_cast<vtkIdType>(expected.size()));
  ASSERT_EQ(counts.Entries, static_cast<vtkIdType>(entries));
  Arrays<Out> all(counts);
  output.Write(all.GetStorage(15));
  EXPECT_EQ(all.GetCells(), expected);
  all.CheckEnds();
  for (unsigned int which = 0; which < 15 && expected.size() < 100; ++which)
  {
    Arrays<Out> some(counts);
    output.Write(some.GetStorage(which));
    const Arrays<Out> none(counts);
    EXPECT_EQ(some.Connectivity, all.Connectivity);
    EXPECT_EQ(some.Offsets, all.Offsets);
    EXPECT_EQ(some.Types, all.Types);
    EXPECT_EQ(some.Levels, which & 1u ? all.Levels : none.Levels);
    EXPECT_EQ(some.Kinds, which & 2u ? all.Kinds : none.Kinds);
    EXPECT_EQ(some.GreenParents, which & 4u ? all.GreenParents : none.GreenParents);
    EXPECT_EQ(some.InputCells, which & 8u ? all.InputCells : none.InputCells);
  }
}

/// Vertices, lines and triangles in turn that touch nothing.
SimplexList MakeApart(int size)
{
  std::vector<Tuple> cells;
  for (int i = 0; i < size; ++i)
  {
    const Tuple points{ 3 * i + 2, 3 * i, 3 * i + 1 };
    cells.emplace_back(points.begin(), points.begin() + 1 + i % 3);
  }
  return MakeList(3 * size, cells);
}

/// Of these cells; the same backwards is something else.
int GetLevelOf(int cell)
{
  return cell % 5;
}

/// The output where some of these cells were marked, in their order.
std::vector<OutputCell> MakeApartOutput(int size, const std::set<int>& marked)
{
  std::vector<OutputCell> cells;
  int next = 3 * size;
  for (int i = 0; i < size; ++i)
  {
    const int a = 3 * i + 2;
    const int b = 3 * i;
    const int c = 3 * i + 1;
    const int level = GetLevelOf(i);
    if (!marked.count(i) || i % 3 == 0)
    {
      const Tuple points{ a, b, c };
      cells.push_back(
        { Tuple(points.begin(), points.begin() + 1 + i % 3), level, level > 0 ? 1 : 0, -1, i });
    }
    else if (i % 3 == 1)
    {
      cells.push_back({ { a, next }, level + 1, 1, -1, i });
      cells.push_back({ { next, b }, level + 1, 1, -1, i });
      ++next;
    }
    else
    {
      cells.push_back({ { a, next, next + 2 }, level + 1, 1, -1, i });
      cells.push_back({ { next, b, next + 1 }, level + 1, 1, -1, i });
      cells.push_back({ { next + 2, next + 1, c }, level + 1, 1, -1, i });
      cells.push_back({ { next, next + 1, next + 2 }, level + 1, 1, -1, i });
      next += 3;
    }
  }
  return cells;
}

using Entries = std::vector<std::pair<int, double>>;

std::vector<Entries> GetRows(const SparseRows<int>& rows)
{
  std::vector<Entries> result;
  for (vtkIdType i = 0; i < rows.GetNumberOfRows(); ++i)
  {
    result.emplace_back();
    for (int k = rows.Offsets[i]; k < rows.Offsets[i + 1]; ++k)
    {
      result.back().emplace_back(rows.Columns[k], rows.Weights[k]);
    }
  }
  return result;
}

}

TEST(RedGreenOutput, NothingIsNamedBeforeItIsSet)
{
  const GreenLeaf<int> leaf;
  EXPECT_EQ(leaf.Input, 0);
  EXPECT_EQ(leaf.Dimension, 0);
  EXPECT_EQ(leaf.Level, 0);
  EXPECT_EQ(leaf.FirstCell, 0);
  EXPECT_EQ(leaf.NumberOfCells, 0);
  EXPECT_EQ(leaf.Vertices, (std::array<int, 4>{ -1, -1, -1, -1 }));
  EXPECT_EQ(leaf.Midpoints, (std::array<int, 6>{ -1, -1, -1, -1, -1, -1 }));
}

TEST(RedGreenOutput, CellsOfAllKinds)
{
  const SimplexList list =
    MakeList(10, { { 4 }, { 0, 1, 2 }, { 1, 0, 3 }, { 3, 4 }, { 5, 6, 7, 8 }, { 5, 6 }, { 9, 3 } });
  const std::vector<unsigned char> levels{ 0, 0, 2, 1, 0, 3, 0 };
  SimplexView view(list);
  view.Levels = levels.data();
  RedGreen<int> state(view);
  state.MarkCell({ 1, -1 }); // vertices 10 to 12
  state.MarkEdge({ 4, -1 }, 5, 6);
  state.Close();
  const std::vector<OutputCell> expected{ { { 4 }, 0, 0, -1, 0 }, { { 0, 10, 12 }, 1, 1, -1, 1 },
    { { 10, 1, 11 }, 1, 1, -1, 1 }, { { 12, 11, 2 }, 1, 1, -1, 1 }, { { 10, 11, 12 }, 1, 1, -1, 1 },
    { { 1, 10, 3 }, 2, 2, 0, 2 }, { { 10, 0, 3 }, 2, 2, 0, 2 }, { { 3, 4 }, 1, 1, -1, 3 },
    { { 5, 13, 7, 8 }, 0, 2, 1, 4 }, { { 13, 6, 7, 8 }, 0, 2, 1, 4 }, { { 5, 13 }, 4, 1, -1, 5 },
    { { 13, 6 }, 4, 1, -1, 5 }, { { 9, 3 }, 0, 0, -1, 6 } };
  CheckCells<int>(state, expected);
  CheckCells<long long>(state, expected);
  const RedGreenOutput<int> output(state);
  ASSERT_EQ(output.GetNumberOfGreenLeaves(), 2);
  using Leaf = std::tuple<int, int, int, int, int, std::array<int, 4>, std::array<int, 6>>;
  const auto getLeaf = [&](int i)
  {
    const auto leaf = output.GetGreenLeaf(i);
    return Leaf{ leaf.Input, leaf.Dimension, leaf.Level, leaf.FirstCell, leaf.NumberOfCells,
      leaf.Vertices, leaf.Midpoints };
  };
  EXPECT_EQ(getLeaf(0), Leaf(2, 2, 2, 5, 2, { 1, 0, 3, -1 }, { 10, -1, -1, -1, -1, -1 }));
  EXPECT_EQ(getLeaf(1), Leaf(4, 3, 0, 8, 2, { 5, 6, 7, 8 }, { 13, -1, -1, -1, -1, -1 }));
}

TEST(RedGreenOutput, ChildrenThatAreStored)
{
  Few few(3, { { 0, 1, 2 }, { 0, 2 } });
  few.State.MarkCell({ 0, -1 }); // vertices 3 to 5
  few.State.Close();
  few.State.MarkCell({ 0, 3 }); // the middle one: vertices 6 to 8
  few.State.Close();
  const std::vector<OutputCell> expected{ { { 0, 3, 8 }, 1, 2, 0, 0 }, { { 0, 8, 5 }, 1, 2, 0, 0 },
    { { 3, 1, 6 }, 1, 2, 1, 0 }, { { 6, 1, 4 }, 1, 2, 1, 0 }, { { 5, 7, 2 }, 1, 2, 2, 0 },
    { { 7, 4, 2 }, 1, 2, 2, 0 }, { { 3, 6, 8 }, 2, 1, -1, 0 }, { { 6, 4, 7 }, 2, 1, -1, 0 },
    { { 8, 7, 5 }, 2, 1, -1, 0 }, { { 6, 7, 8 }, 2, 1, -1, 0 }, { { 0, 5 }, 1, 1, -1, 1 },
    { { 5, 2 }, 1, 1, -1, 1 } };
  CheckCells<int>(few.State, expected);
  const RedGreenOutput<int> output(few.State);
  ASSERT_EQ(output.GetNumberOfGreenLeaves(), 3);
  for (int i = 0; i < 3; ++i)
  {
    const auto leaf = output.GetGreenLeaf(i);
    EXPECT_EQ(leaf.FirstCell, 2 * i);
    EXPECT_EQ(leaf.NumberOfCells, 2);
    EXPECT_EQ(leaf.Level, 1);
    EXPECT_EQ(leaf.Dimension, 2);
    EXPECT_EQ(leaf.Input, 0);
  }
  EXPECT_EQ(output.GetGreenLeaf(0).Midpoints, (std::array<int, 6>{ -1, 8, -1, -1, -1, -1 }));
  EXPECT_EQ(output.GetGreenLeaf(1).Midpoints, (std::array<int, 6>{ -1, -1, 6, -1, -1, -1 }));
  EXPECT_EQ(output.GetGreenLeaf(2).Midpoints, (std::array<int, 6>{ 7, -1, -1, -1, -1, -1 }));
}

// Cells that stay are copied in blocks of 4096, between those that are split.
TEST(RedGreenOutput, CellsThatStay)
{
  const std::vector<std::set<int>> marks{ {}, { 1 }, { 0, 2, 4 }, { 4094, 4097 }, { 4096, 4097 },
    { 4093, 4094, 8192, 8195 }, { 1, 5000, 8198, 8200 } };
  for (const int size : { 2, 64, 65, 4095, 4096, 4097, 8201 })
  {
    const SimplexList list = MakeApart(size);
    std::vector<unsigned char> levels;
    for (int i = 0; i < size; ++i)
    {
      levels.push_back(static_cast<unsigned char>(GetLevelOf(i)));
    }
    SimplexView view(list);
    view.Levels = levels.data();
    for (const std::set<int>& several : marks)
    {
      if (!several.empty() && *several.rbegin() >= size)
      {
        continue;
      }
      RedGreen<int> state(view);
      for (const int cell : several)
      {
        state.MarkCell({ cell, -1 });
      }
      state.Close();
      CheckCells<int>(state, MakeApartOutput(size, several));
    }
  }
  CheckCells<int>(RedGreen<int>(SimplexView(SimplexList())), {});
}

TEST(RedGreenOutput, RowsOfMidpoints)
{
  Few few(4, { { 0, 1, 2 } });
  few.State.MarkCell({ 0, -1 }); // vertices 4 to 6
  few.State.Close();
  few.State.MarkCell({ 0, 3 }); // vertices 7 to 9
  few.State.MarkEdge({ 0, 0 }, 0, 4);
  few.State.Close();
  const MidpointRows<int> rows = MakeMidpointRows(few.State);
  EXPECT_EQ(rows.GetNumberOfColumns(), 4);
  ASSERT_EQ(few.FindMiddle(0, 4), 10);
  const int size = few.State.GetNumberOfVertices();
  EXPECT_EQ(rows.GetNumberOfRows(), size);
  const std::vector<Entries> own = GetRows(rows.Added);
  ASSERT_EQ(static_cast<int>(own.size()), size - 4);
  EXPECT_EQ(own[0], (Entries{ { 0, 0.5 }, { 1, 0.5 } }));
  EXPECT_EQ(own[1], (Entries{ { 1, 0.5 }, { 2, 0.5 } }));
  EXPECT_EQ(own[2], (Entries{ { 0, 0.5 }, { 2, 0.5 } }));
  EXPECT_EQ(own[3], (Entries{ { 0, 0.25 }, { 1, 0.5 }, { 2, 0.25 } }));
  EXPECT_EQ(own[4], (Entries{ { 0, 0.25 }, { 1, 0.25 }, { 2, 0.5 } }));
  EXPECT_EQ(own[5], (Entries{ { 0, 0.5 }, { 1, 0.25 }, { 2, 0.25 } }));
  EXPECT_EQ(own[6], (Entries{ { 0, 0.75 }, { 1, 0.25 } }));
  const std::vector<double> given{ 1., 10., 100., 1000. };
  std::vector<double> made(static_cast<std::size_t>(size));
  rows.Apply(given.data(), made.data(), 1);
  made.resize(11);
  EXPECT_EQ(
    made, (std::vector<double>{ 1., 10., 100., 1000., 5.5, 55., 50.5, 30.25, 52.75, 28., 3.25 }));
}

// Whatever the order in which cells name their vertices, columns increase.
TEST(RedGreenOutput, ColumnsIncrease)
{
  Tuple cell{ 0, 1, 2, 3 };
  do
  {
    Few few(4, { cell });
    few.State.MarkCell({ 0, -1 });
    few.State.Close();
    for (int child = 0; child < 8; ++child)
    {
      few.State.MarkCell({ 0, child });
    }
    few.State.Close();
    const std::vector<Key> keys = MakeKeys(few.State);
    const std::vector<Entries> own = GetRows(MakeMidpointRows(few.State).Added);
    ASSERT_EQ(own.size(), 31u); // of 35 points
    for (std::size_t i = 0; i < own.size(); ++i)
    {
      EXPECT_EQ(Key(own[i].begin(), own[i].end()), keys[i + 4]);
    }
  } while (std::next_permutation(cell.begin(), cell.end()));
}

// They are passed on in several blocks.
TEST(RedGreenOutput, RowsOfManyMidpoints)
{
  constexpr int size = 2000;
  std::vector<Tuple> cells;
  for (int i = 0; i < size; ++i)
  {
    cells.push_back({ i, i + 1 });
  }
  Few few(size + 1, cells);
  std::vector<double> given{ 0. };
  for (int i = 0; i < size; ++i)
  {
    few.State.MarkCell({ i, -1 });
    given.push_back(i * i % 1000);
  }
  few.State.Close();
  std::vector<double> made(2 * size + 1, -1.);
  MakeMidpointRows(few.State).Apply(given.data(), made.data(), 1);
  for (int i = 0; i < size; ++i)
  {
    const auto k = static_cast<std::size_t>(i);
    ASSERT_EQ(made[k], given[k]);
    ASSERT_EQ(made[size + 1 + k], (given[k] + given[k + 1]) / 2.);
  }
  EXPECT_EQ(made[size], given[size]);
}
