// SPDX-License-Identifier: BSD-3-Clause
// Eigenvalues and eigenvectors of small matrices whose answers are known.
#include "Precompiled.h"

#include "Core/Smoothness/LocalMatrix.h"

using namespace subdivision;

namespace
{

LocalMatrix Make(int size, const std::vector<double>& values)
{
  LocalMatrix matrix(size);
  for (int i = 0; i < size * size; ++i)
  {
    matrix.At(i / size, i % size) = values[i];
  }
  return matrix;
}

/// Whether A X is in the space of X: the largest part of A X that is not.
double MeasureResidual(const LocalMatrix& matrix, const std::vector<double>& x, double value)
{
  double most = 0.;
  for (int i = 0; i < matrix.GetSize(); ++i)
  {
    double sum = -value * x[i];
    for (int j = 0; j < matrix.GetSize(); ++j)
    {
      sum += matrix.At(i, j) * x[j];
    }
    most = std::max(most, std::abs(sum));
  }
  return most;
}

}

TEST(LocalMatrix, ModuliComeInDescendingOrder)
{
  // Blocks: 1/4; a turn by a right angle times 1/2, whose eigenvalues are i/2 and -i/2; 1.
  const LocalMatrix matrix = Make(4, { .25, 0, 0, 0, 0, 0, -.5, 0, 0, .5, 0, 0, 7., 0, 0, 1. });
  const std::vector<double> moduli = matrix.FindModuli();
  ASSERT_EQ(moduli.size(), 4u);
  EXPECT_NEAR(moduli[0], 1., 1e-12);
  EXPECT_NEAR(moduli[1], .5, 1e-12);
  EXPECT_NEAR(moduli[2], .5, 1e-12);
  EXPECT_NEAR(moduli[3], .25, 1e-12);
  EXPECT_TRUE(LocalMatrix().FindModuli().empty());
}

TEST(LocalMatrix, LeadingVectorsComeWithTheirPartner)
{
  const LocalMatrix matrix = Make(4, { .25, 0, 0, 0, 0, 0, -.5, 0, 0, .5, 0, 0, 7., 0, 0, 1. });
  EXPECT_TRUE(matrix.FindLeading(1).empty()); // half of a complex pair
  const std::vector<double> pair = matrix.FindLeading(2);
  ASSERT_EQ(pair.size(), 8u);
  for (int column = 0; column < 2; ++column)
  {
    EXPECT_NEAR(pair[column], 0., 1e-12);
    EXPECT_NEAR(pair[6 + column], 0., 1e-12);
  }
  EXPECT_NEAR(std::abs(pair[2] * pair[5] - pair[3] * pair[4]), 1., 1e-12);
  EXPECT_TRUE(matrix.FindLeading(4).empty()); // there are no more than four
}

TEST(LocalMatrix, VectorsContinueOutwards)
{
  // Known: the first two items. The third and fourth read them and each other.
  const LocalMatrix matrix = Make(4, { 1., 0, 0, 0, .5, .5, 0, 0, .2, .3, .4, .1, .1, .6, .2, .1 });
  LocalMatrix near(2);
  for (int i = 0; i < 4; ++i)
  {
    near.At(i / 2, i % 2) = matrix.At(i / 2, i % 2);
  }
  const std::vector<double> basis = near.FindLeading(1);
  ASSERT_EQ(basis.size(), 2u);
  const std::vector<double> all = matrix.Continue(2, basis, 1);
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(all[0], basis[0]);
  EXPECT_EQ(all[1], basis[1]);
  EXPECT_LT(MeasureResidual(matrix, all, .5), 1e-12);
}

TEST(LocalMatrix, VectorsDoNotContinueWhereTheOthersHaveTheSameEigenvalue)
{
  const LocalMatrix matrix = Make(3, { 1., 0, 0, .5, .5, 0, .2, .3, .5 });
  EXPECT_TRUE(matrix.Continue(2, { 0., 1. }, 1).empty());
}
