// SPDX-License-Identifier: BSD-3-Clause
// Rows with weights of their own: what applying and multiplying them gives, against dense algebra.
#include "Precompiled.h"

#include "Core/Operators/SparseRows.h"

namespace
{

using subdivision::Buffer;
using subdivision::SparseRows;

struct Entry
{
  int Column;
  double Weight;
};

SparseRows<int> MakeRows(int columns, const std::vector<std::vector<Entry>>& entries)
{
  SparseRows<int> rows;
  rows.NumberOfColumns = columns;
  rows.Offsets = Buffer<int>(static_cast<vtkIdType>(entries.size()) + 1);
  rows.Offsets[0] = 0;
  int size = 0;
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    size += static_cast<int>(entries[i].size());
    rows.Offsets[static_cast<vtkIdType>(i) + 1] = size;
  }
  rows.Columns = Buffer<int>(size);
  rows.Weights = Buffer<double>(size);
  vtkIdType next = 0;
  for (const auto& row : entries)
  {
    for (const Entry& entry : row)
    {
      rows.Columns[next] = entry.Column;
      rows.Weights[next++] = entry.Weight;
    }
  }
  return rows;
}

SparseRows<int> MakeRandomRows(int columns, int rows, int perRow, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> column(0, columns - 1);
  std::uniform_real_distribution<double> weight(-1., 1.);
  std::vector<std::vector<Entry>> entries(rows);
  for (auto& row : entries)
  {
    for (int k = 0; k < perRow; ++k)
    {
      row.push_back({ column(random), weight(random) });
    }
  }
  return MakeRows(columns, entries);
}

TEST(CoreSparseRows, ApplySumsEachComponent)
{
  const auto rows = MakeRows(3, { { { 2, 1. } }, { { 0, .25 }, { 1, .75 } }, {} });
  const double in[] = { 4., 40., 8., 80., 1., 10. };
  double out[6];
  rows.Apply(in, out, 2);
  EXPECT_EQ(std::vector<double>(out, out + 6), (std::vector<double>{ 1., 10., 7., 70., 0., 0. }));
}

TEST(CoreSparseRows, IntegersAreRounded)
{
  const auto rows = MakeRows(2, { { { 0, .5 }, { 1, .5 } } });
  const int in[] = { 1, 4 };
  int out = 0;
  rows.Apply(in, &out, 1);
  EXPECT_EQ(out, 3);
}

TEST(CoreSparseRows, WeightsOfZeroSpreadNothing)
{
  const auto rows = MakeRows(2, { { { 0, 1. }, { 1, 0. } } });
  const double in[] = { 5., std::numeric_limits<double>::quiet_NaN() };
  double out = 0.;
  rows.Apply(in, &out, 1);
  EXPECT_EQ(out, 5.);
}

TEST(CoreSparseRows, AProductIsOneAfterTheOther)
{
  const auto inner = MakeRandomRows(50, 30000, 5, 1);
  const auto outer = MakeRandomRows(30000, 20000, 6, 2);
  const auto product = Multiply(outer, inner);
  ASSERT_EQ(product.GetNumberOfRows(), 20000);
  ASSERT_EQ(product.GetNumberOfColumns(), 50);
  std::vector<double> in(50);
  for (std::size_t i = 0; i < in.size(); ++i)
  {
    in[i] = static_cast<double>((i * 37) % 50);
  }
  std::vector<double> middle(30000);
  std::vector<double> expected(20000);
  std::vector<double> found(20000);
  inner.Apply(in.data(), middle.data(), 1);
  outer.Apply(middle.data(), expected.data(), 1);
  product.Apply(in.data(), found.data(), 1);
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    ASSERT_NEAR(found[i], expected[i], 1e-11) << "row " << i;
  }
}

}
