// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestMessageWords.cxx
 * Messages in the words of the interface that runs a filter.
 */
#include "Private/Control/MessageWords.h"

#include <gtest/gtest.h>

using subdivision::Replace;

TEST(MessageWords, WordsAreReplaced)
{
  const subdivision::MessageWords words{ { "MergePoints", "merge_points" }, { "Map", "wrong" },
    { "MapLevels", "map_levels" }, { "array index 1", "material_array" },
    { "input port 1", "rest_mesh" }, { "RestMesh (input port 1)", "rest_mesh" } };
  EXPECT_EQ("Switch merge_points on.", Replace(words, "Switch MergePoints on."));
  EXPECT_EQ("merge_points", Replace(words, "MergePoints"));
  EXPECT_EQ("set material_array, or", Replace(words, "set array index 1, or"));
  EXPECT_EQ("nothing, of nothing", Replace(words, "nothing, of nothing"));
  EXPECT_EQ("", Replace(words, ""));
}

TEST(MessageWords, TheLongestWordIsMeant)
{
  const subdivision::MessageWords words{ { "Map", "wrong" }, { "MapLevels", "map_levels" },
    { "input port 1", "rest_mesh" }, { "RestMesh (input port 1)", "rest_mesh" } };
  EXPECT_EQ("fewer map_levels", Replace(words, "fewer MapLevels"));
  EXPECT_EQ("rest_mesh is missing", Replace(words, "RestMesh (input port 1) is missing"));
}

TEST(MessageWords, PartsOfWordsStay)
{
  const subdivision::MessageWords words{ { "array index 1", "material_array" },
    { "MergePoints", "merge_points" } };
  for (const char* text : { "array index 10", "DoMergePoints", "MergePoints2", "an array inde" })
  {
    EXPECT_EQ(text, Replace(words, text));
  }
}
