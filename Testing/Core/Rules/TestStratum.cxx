// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 4 and 6: a byte holds the rule and the non-manifold type, and gives both back.
#include "Core/Rules/Stratum.h"

#include <gtest/gtest.h>

using namespace subdivision;

TEST(StratumByte, GivesRuleAndTypeBack)
{
  for (Rule rule :
    { Rule::Corner, Rule::Curve, Rule::Surface, Rule::Solid, Rule::Blend, Rule::RegularEdge })
  {
    for (int type = 0; type <= 3; ++type)
    {
      const Stratum stratum(rule, type);
      EXPECT_EQ(stratum.GetRule(), rule) << "type " << type;
      EXPECT_EQ(stratum.GetType(), type) << "rule " << static_cast<int>(rule);
    }
    EXPECT_EQ(Stratum(rule).GetRule(), rule);
    EXPECT_EQ(Stratum(rule).GetType(), 0) << "manifold unless said otherwise";
  }
  static_assert(sizeof(Stratum) == 1, "levels hold one for each vertex and edge");
}
