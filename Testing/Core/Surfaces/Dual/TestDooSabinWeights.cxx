// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 12: the weights of the Doo-Sabin scheme.
#include "Core/Surfaces/Dual/DooSabinWeights.h"

#include <gtest/gtest.h>

using namespace subdivision;

TEST(DooSabinWeights, OfSmallFaces)
{
  const std::vector<double> expected[3] = { { 2. / 3., 1. / 6., 1. / 6. },
    { 9. / 16., 3. / 16., 1. / 16., 3. / 16. },
    { 0.5, 0.1809016994374947, 0.0690983005625053, 0.0690983005625053, 0.1809016994374947 } };
  for (const std::vector<double>& weights : expected)
  {
    std::vector<double> found(7, 9.); // of another face
    FindCornerWeights(static_cast<vtkIdType>(weights.size()), found);
    ASSERT_EQ(found.size(), weights.size());
    for (std::size_t j = 0; j < weights.size(); ++j)
    {
      EXPECT_NEAR(found[j], weights[j], 1e-15) << weights.size() << " " << j;
    }
  }
  ASSERT_EQ(DooSabinQuad.size(), 4u);
  for (std::size_t j = 0; j < 4; ++j)
  {
    EXPECT_NEAR(DooSabinQuad[j], expected[1][j], 1e-15) << j;
  }
}

// Constants stay, linear functions are halved, all other waves are quartered.
TEST(DooSabinWeights, WavesAroundAFace)
{
  for (int k = 3; k <= 20; ++k)
  {
    std::vector<double> weights;
    FindCornerWeights(k, weights);
    for (int m = 0; m <= k / 2; ++m)
    {
      double factor = 0.;
      for (int j = 0; j < k; ++j)
      {
        factor += weights[j] * std::cos(2. * Pi * m * j / k);
      }
      EXPECT_NEAR(factor, m == 0 ? 1. : m == 1 ? 0.5 : 0.25, 1e-14) << k << " " << m;
    }
    for (int j = 1; j < k; ++j)
    {
      EXPECT_EQ(weights[j], weights[k - j]); // to the last bit, whichever way around
    }
  }
}
