// SPDX-License-Identifier: BSD-3-Clause
// Rows over the corners of simplices: the same as sparse rows, for any number of threads.
#include "Core/Operators/CornerRows.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <vector>

namespace
{

using subdivision::Buffer;
using subdivision::CornerRow;
using subdivision::CornerRows;
using subdivision::SparseRows;

/// Rows of 4, 3, 1 and no corners in turns.
CornerRows MakeRandomRows(int columns, vtkIdType size)
{
  std::mt19937 random(5);
  std::uniform_int_distribution<int> column(0, columns - 1);
  std::uniform_real_distribution<double> weight(0.1, 1.);
  CornerRows rows;
  rows.NumberOfColumns = columns;
  rows.Rows = Buffer<CornerRow>(size);
  for (vtkIdType i = 0; i < size; ++i)
  {
    CornerRow row;
    const int corners = std::vector<int>{ 4, 3, 1, 0 }[i % 4];
    for (int k = 0; k < 4; ++k)
    {
      row.Columns[k] = k < corners ? column(random) : row.Columns[0];
      row.Weights[k] = k < corners ? weight(random) : 0.;
    }
    rows.Rows[i] = row;
  }
  return rows;
}

TEST(CoreCornerRows, AreTheSameAsSparseRows)
{
  const CornerRows rows = MakeRandomRows(500, 30000); // enough for threads
  const SparseRows<int> sparse = rows.ToSparseRows();
  ASSERT_EQ(sparse.GetNumberOfRows(), 30000);
  EXPECT_EQ(sparse.GetNumberOfColumns(), 500);
  EXPECT_EQ(sparse.Columns.size(), 30000 / 4 * (4 + 3 + 1));
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
  std::vector<float> singles(3 * 30000, -1.F);
  rows.Apply(in.data(), singles.data(), 3);
  for (std::size_t i = 0; i < wanted.size(); ++i)
  {
    ASSERT_EQ(singles[i], static_cast<float>(wanted[i])) << i;
  }
  for (vtkIdType i = 0; i < 4; ++i)
  {
    EXPECT_EQ(rows.Rows[i].IsEmpty(), i == 3);
  }
}

TEST(CoreCornerRows, SparseRowsLeaveOutWhatHasNoWeight)
{
  // The corner of weight 0 may be the first.
  CornerRows rows;
  rows.NumberOfColumns = 3;
  rows.Rows = Buffer<CornerRow>(1);
  rows.Rows[0] = CornerRow{ { 0., .25, 0., .75 }, { 2, 0, 2, 1 } };
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
