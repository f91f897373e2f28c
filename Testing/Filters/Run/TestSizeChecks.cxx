// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSizeChecks.cxx
 * What is said of outputs that would be too large.
 */
#include "Private/Run/SizeChecks.h"

#include <gtest/gtest.h>

namespace
{

bool Says(const std::string& message, const std::string& part)
{
  return message.find(part) != std::string::npos;
}

}

TEST(SizeChecks, AdviseWhatCanHelp)
{
  EXPECT_EQ("", subdivision::CheckNumberOfCells(1000., 41000., 2, 1000));
  const std::string few = subdivision::CheckNumberOfCells(1001., 41041., 2, 1000);
  EXPECT_TRUE(Says(few, "would make 1001 cells (up to 41 kB for")) << few;
  EXPECT_TRUE(Says(few, "raise MaximumNumberOfCells")) << few;
  const std::string many = subdivision::CheckNumberOfCells(2e19, 8.2e20, 20, 500000000);
  EXPECT_TRUE(Says(many, "would make 2e+19 cells (up to 820 EB for")) << many;
  EXPECT_TRUE(Says(many, "not enough memory")) << many;
  EXPECT_FALSE(Says(many, "raise")) << many;
}

TEST(SizeChecks, SizesHaveUnits)
{
  EXPECT_EQ("0 bytes", subdivision::Bytes(0.));
  EXPECT_EQ("656 bytes", subdivision::Bytes(656.));
  EXPECT_EQ("999 bytes", subdivision::Bytes(999.));
  EXPECT_EQ("1 kB", subdivision::Bytes(1000.));
  EXPECT_EQ("1 MB", subdivision::Bytes(999600.));
  EXPECT_EQ("12.3 GB", subdivision::Bytes(1.234e10));
  EXPECT_EQ("36.3 PB", subdivision::Bytes(36277708191e6));
}

TEST(SizeChecks, TellWhatWasEstimated)
{
  subdivision::ForgetEstimate();
  EXPECT_FALSE(Says(subdivision::TellEstimate(), "expected")) << subdivision::TellEstimate();
  EXPECT_TRUE(Says(subdivision::TellEstimate(), "B are available.")) << subdivision::TellEstimate();
  EXPECT_EQ("", subdivision::CheckMemory(4000., 1000., 123456., 2));
  const std::string told = subdivision::TellEstimate();
  EXPECT_TRUE(Says(told, "About 123 kB were expected to be enough; ")) << told;
  EXPECT_TRUE(Says(told, " are available.")) << told;
}
