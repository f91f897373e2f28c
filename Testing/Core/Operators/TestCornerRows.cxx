// SPDX-License-Identifier: BSD-3-Clause
// Rows over the corners of simplices: the same as sparse rows, for any number of threads.
#include "Precompiled.h"

#include "Core/Operators/CornerRows.h"

namespace
{

using subdivision::Buffer;
using subdivision::CornerRow;
using subdivision::CornerRows;
using subdivision::SparseRows;

/// Corners of some simplices.
const Buffer<int>& GetCorners()
{
  static const Buffer<int> corners = []
  {
    Buffer<int> made(4 * 100);
    for (int i = 0; i < 400; ++i)
    {
      made[i] = i * 37 % 499;
    }
    return made;
  }();
  return corners;
}

/// Rows of 4, 3, 1 and no corners in turns, and of places in simplices.
CornerRows MakeRandomRows(int columns, vtkIdType size)
{
  std::mt19937 random(5);
  std::uniform_int_distribution<int> column(0, columns - 1);
  std::uniform_real_distribution<double> weight(0.1, 1.);
  CornerRows rows;
  rows.NumberOfColumns = columns;
  rows.Corners = GetCorners().data();
  rows.Simplices = Buffer<int>(size);
  rows.Weights = Buffer<double>(3 * size);
  rows.Others = Buffer<CornerRow>(size);
  for (vtkIdType i = 0; i < size; ++i)
  {
    const auto kind = static_cast<std::size_t>(i % 5);
    CornerRow& row = rows.Others[i] = CornerRow();
    const int corners = std::vector<int>{ 4, 3, 1, 0, 4 }[kind];
    for (int k = 0; k < 4; ++k)
    {
      row.Columns[k] = k < corners ? column(random) : row.Columns[0];
      row.Weights[k] = k < corners ? weight(random) : 0.;
    }
    rows.Simplices[i] = static_cast<int>(kind == 4 ? i % 100 : -1 - i);
    std::copy_n(row.Weights, 3, rows.Weights.data() + 3 * i);
  }
  return rows;
}

TEST(CoreCornerRows, AreTheSameAsSparseRows)
{
  const CornerRows rows = MakeRandomRows(500, 30000); // enough for threads
  const SparseRows<int> sparse = rows.ToSparseRows();
  ASSERT_EQ(sparse.GetNumberOfRows(), 30000);
  EXPECT_EQ(sparse.GetNumberOfColumns(), 500);
  EXPECT_EQ(sparse.Columns.size(), 30000 / 5 * (4 + 3 + 1 + 4));
  std::vector<double> in(3 * 500);
  for (std::size_t i = 0; i < in.size(); ++i)
  {
    in[i] = static_cast<double>((i * 37) % 501) / 7.;
  }
  std::vector<double> found(3 * 30000, -1.);
  std::vector<double> wanted(3 * 30000, -2.);
  rows.Apply(in.data(), found.data(), 3);
  sparse.Apply(in.data(), wanted.data(), 3);
  EXPECT_EQ(found, wanted);
  found.assign(found.size(), -1.);
  rows.Move(in.data(), found.data());
  EXPECT_EQ(found, wanted);
  std::vector<float> singles(3 * 30000, -1.F);
  rows.Apply(in.data(), singles.data(), 3);
  std::vector<float> moved(3 * 30000, -1.F);
  rows.Move(in.data(), moved.data());
  for (std::size_t i = 0; i < wanted.size(); ++i)
  {
    ASSERT_EQ(singles[i], static_cast<float>(wanted[i])) << i;
    ASSERT_EQ(moved[i], singles[i]) << i;
  }
  for (vtkIdType i = 0; i < 5; ++i)
  {
    EXPECT_EQ(rows.IsEmpty(i), i == 3);
  }
  const CornerRow row = rows.GetRow(4);
  EXPECT_EQ(row.Weights[0], 1. - row.Weights[1] - row.Weights[2] - row.Weights[3]);
  EXPECT_TRUE(std::equal(row.Columns, row.Columns + 4, GetCorners().data() + 4 * 4));
}

TEST(CoreCornerRows, SparseRowsLeaveOutWhatHasNoWeight)
{
  // The corner of weight 0 may be the first.
  CornerRows rows;
  rows.NumberOfColumns = 3;
  rows.Simplices = Buffer<int>(1, -1);
  rows.Others = Buffer<CornerRow>(1, CornerRow{ { 0., .25, 0., .75 }, { 2, 0, 2, 1 } });
  const SparseRows<int> sparse = rows.ToSparseRows();
  ASSERT_EQ(sparse.Columns.size(), 2);
  EXPECT_EQ(sparse.Columns[0], 0);
  EXPECT_EQ(sparse.Columns[1], 1);
  const double in[] = { 4., 8., std::numeric_limits<double>::quiet_NaN() };
  double out = 0.;
  sparse.Apply(in, &out, 1);
  EXPECT_EQ(out, 7.);
}

}
