// SPDX-License-Identifier: BSD-3-Clause
// Rows that share their weights are those of rows added entry by entry, bit for bit.
#include "Precompiled.h"

#include "Core/Operators/BlockOperator.h"

namespace
{

using subdivision::BlockOperator;
using subdivision::RowBlock;

constexpr int Columns = 50;
constexpr vtkIdType Rows = 3000;
constexpr std::array<double, 4> Four{ 3. / 8., 3. / 8., 0.1, 0.7 };
constexpr std::array<double, 9> Nine{ 9. / 16., 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 1. / 64. };
constexpr std::array<double, 5> Five{ 0.1, 0.2, 0.3, 0.4, 0. };

int GetColumn(vtkIdType row, std::size_t entry)
{
  return static_cast<int>((row * 7 + static_cast<vtkIdType>(entry) * 13) % Columns);
}

/// Runs of all lengths, with other rows between.
template <std::size_t N>
vtkIdType AddRun(const std::array<double, N>& weights, vtkIdType row, vtkIdType most, bool inRuns,
  RowBlock<int>& rows)
{
  const vtkIdType wanted = row % 23;
  if (inRuns)
  {
    return rows.AddRun(weights, most,
      [&](vtkIdType i, int* columns)
      {
        for (std::size_t k = 0; k < N; ++k)
        {
          columns[k] = GetColumn(row + i, k);
        }
        return i < wanted;
      });
  }
  vtkIdType count = 0;
  for (; count < std::min(wanted, most); ++count)
  {
    for (std::size_t k = 0; k < N; ++k)
    {
      rows.Add(GetColumn(row + count, k), weights[k]);
    }
    rows.EndRow();
  }
  return count;
}

/// Quads, none to four at a time.
vtkIdType AddQuads(vtkIdType row, vtkIdType most, bool inRuns, RowBlock<int>& rows)
{
  const vtkIdType wanted = row % 5;
  if (inRuns)
  {
    return rows.AddQuads(Four, most / 4,
      [&](vtkIdType i, int* corners)
      {
        for (std::size_t k = 0; k < 4; ++k)
        {
          corners[k] = GetColumn(row + 4 * i, k);
        }
        return i < wanted;
      });
  }
  const vtkIdType count = 4 * std::min(wanted, most / 4);
  for (vtkIdType i = 0; i < count; ++i)
  {
    for (std::size_t k = 0; k < 4; ++k)
    {
      rows.Add(GetColumn(row + i / 4 * 4, (static_cast<std::size_t>(i) + k) % 4), Four[k]);
    }
    rows.EndRow();
  }
  return count;
}

BlockOperator<int> MakeOperator(bool inRuns)
{
  return BlockOperator<int>(Columns, Rows,
    [inRuns](vtkIdType begin, vtkIdType end, RowBlock<int>& rows)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        row += AddRun(Four, row, end - row, inRuns, rows);
        row += AddQuads(row, end - row, inRuns, rows);
        row += AddRun(Nine, row, end - row, inRuns, rows);
        row += AddRun(Five, row, end - row, inRuns, rows);
        if (row < end)
        {
          rows.Add(GetColumn(row, 0), 1.);
          rows.EndRow();
        }
      }
    });
}

template <typename T>
std::vector<T> Apply(bool inRuns, int components)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> value(0., 200.);
  std::vector<T> in(static_cast<std::size_t>(Columns * components));
  for (T& x : in)
  {
    x = static_cast<T>(value(random));
  }
  std::vector<T> out(static_cast<std::size_t>(Rows * components), T(-1));
  MakeOperator(inRuns).Apply(in.data(), out.data(), components);
  return out;
}

}

TEST(RowBlock, RunsAreRowsOfEntries)
{
  for (const int components : { 1, 2, 3, 4, 6 })
  {
    EXPECT_EQ(Apply<double>(true, components), Apply<double>(false, components));
    EXPECT_EQ(Apply<float>(true, components), Apply<float>(false, components));
    EXPECT_EQ(Apply<unsigned char>(true, components), Apply<unsigned char>(false, components));
  }
}

TEST(RowBlock, RunsAreStoredAsRows)
{
  const auto runs = MakeOperator(true).Store();
  const auto rows = MakeOperator(false).Store();
  ASSERT_EQ(runs.Columns.size(), rows.Columns.size());
  EXPECT_TRUE(std::equal(runs.Offsets.begin(), runs.Offsets.end(), rows.Offsets.begin()));
  EXPECT_TRUE(std::equal(runs.Columns.begin(), runs.Columns.end(), rows.Columns.begin()));
  EXPECT_TRUE(std::equal(runs.Weights.begin(), runs.Weights.end(), rows.Weights.begin()));
}

TEST(RowBlock, LongRunsArePassedAsEqualRows)
{
  vtkIdType equal = 0;
  vtkIdType quads = 0;
  vtkIdType all = 0;
  MakeOperator(true).ForEachBlock(
    [&](const subdivision::RowsView& view)
    {
      const auto* found = std::get_if<subdivision::EqualRows<int>>(&view);
      equal += found ? found->Count : 0;
      const auto* ofQuads = std::get_if<subdivision::QuadRows<int>>(&view);
      quads += ofQuads ? ofQuads->Count : 0;
      all += std::visit([](const auto& rows) { return rows.Count; }, view);
    });
  EXPECT_EQ(all, Rows);
  EXPECT_GT(equal, Rows / 4);
  EXPECT_GT(quads, Rows / 10);
  EXPECT_LT(equal + quads, Rows);
}

TEST(RowBlock, QuadsHaveAllColumnsWhereTheyAreAskedFor)
{
  RowBlock<int> rows;
  vtkIdType quads = 0;
  for (const vtkIdType more : { 3, 1, 20 })
  {
    rows.AddQuads(Four, more,
      [quads](vtkIdType i, int* corners)
      {
        std::iota(corners, corners + 4, static_cast<int>(10 * (quads + i)));
        return true;
      });
    quads += more;
    ASSERT_EQ(rows.GetNumberOfRows(), 4u * static_cast<std::size_t>(quads));
    for (vtkIdType row = 0; row < 4 * quads; ++row)
    {
      const int* columns = rows.GetColumns() + rows.GetBegin(static_cast<std::size_t>(row));
      for (vtkIdType k = 0; k < 4; ++k)
      {
        EXPECT_EQ(columns[k], 10 * (row / 4) + (row + k) % 4) << row;
      }
    }
  }
}

TEST(RowBlock, WeightsAreThereWheneverTheyAreAskedFor)
{
  RowBlock<int> rows;
  for (const vtkIdType more : { 20, 3, 30 })
  {
    rows.AddRun(Four, more,
      [](vtkIdType, int* columns)
      {
        std::fill_n(columns, 4, 0);
        return true;
      });
    for (std::size_t row = 0; row < rows.GetNumberOfRows(); ++row)
    {
      EXPECT_TRUE(std::equal(Four.begin(), Four.end(), rows.GetWeights() + rows.GetBegin(row)));
    }
  }
  rows.Clear();
  rows.AddRun(Five, 20, [](vtkIdType, int* columns) { return std::fill_n(columns, 5, 0), true; });
  EXPECT_EQ(rows.GetWeights()[95], Five[0]);
}
