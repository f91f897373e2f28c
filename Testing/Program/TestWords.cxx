// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestWords.cxx
 * Messages in the words of the interface that runs a filter.
 */
#include "Words.h"

#include <gtest/gtest.h>

using subdivision::Replace;

TEST(ProgramWords, WordsAreReplaced)
{
  const subdivision::Words words{ { "MergePoints", "merge_points" }, { "Map", "wrong" },
    { "MapLevels", "map_levels" }, { "array index 1", "material_array" },
    { "input port 1", "rest_mesh" }, { "RestMesh (input port 1)", "rest_mesh" } };
  EXPECT_EQ("Switch merge_points on.", Replace(words, "Switch MergePoints on."));
  EXPECT_EQ("merge_points", Replace(words, "MergePoints"));
  EXPECT_EQ("set material_array, or", Replace(words, "set array index 1, or"));
  EXPECT_EQ("nothing, of nothing", Replace(words, "nothing, of nothing"));
  EXPECT_EQ("", Replace(words, ""));
}

TEST(ProgramWords, TheLongestWordIsMeant)
{
  const subdivision::Words words{ { "Map", "wrong" }, { "MapLevels", "map_levels" },
    { "input port 1", "rest_mesh" }, { "RestMesh (input port 1)", "rest_mesh" } };
  EXPECT_EQ("fewer map_levels", Replace(words, "fewer MapLevels"));
  EXPECT_EQ("rest_mesh is missing", Replace(words, "RestMesh (input port 1) is missing"));
}

TEST(ProgramWords, PartsOfWordsStay)
{
  const subdivision::Words words{ { "array index 1", "material_array" },
    { "MergePoints", "merge_points" } };
  for (const char* text : { "array index 10", "DoMergePoints", "MergePoints2", "an array inde" })
  {
    EXPECT_EQ(text, Replace(words, text));
  }
}
