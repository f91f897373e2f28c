// SPDX-License-Identifier: BSD-3-Clause
// The number of steps for which a mesh has semi-sharp creases.
#include "Core/Rules/Sharpness.h"

#include <gtest/gtest.h>

using namespace subdivision;

TEST(EdgeSharpness, AnyEdgeAboveTheStepsIsSharp)
{
  EXPECT_FALSE(IsSharpAfter({}, 0));
  EXPECT_FALSE(IsSharpAfter({ 0., 0. }, 0));
  EXPECT_TRUE(IsSharpAfter({ 0., 0.25, 0. }, 0));
  EXPECT_TRUE(IsSharpAfter({ 2.5, 0. }, 2));
  EXPECT_FALSE(IsSharpAfter({ 2.5, 0. }, 3));
}

TEST(EdgeSharpness, AWholeNumberIsUsedUpAfterSoManySteps)
{
  EXPECT_TRUE(IsSharpAfter({ 2. }, 1));
  EXPECT_FALSE(IsSharpAfter({ 2. }, 2));
}
