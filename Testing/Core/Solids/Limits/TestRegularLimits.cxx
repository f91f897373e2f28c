// SPDX-License-Identifier: BSD-3-Clause
// Limit rows of a level that is not made are those of the same level when it is made.
#include "LimitTools.h"

#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Limits/RegularLimits.h"

using namespace coretest;

namespace
{

/// Weights by column.
std::map<int, double> ListWeights(const SparseRows<int>& rows, vtkIdType row)
{
  std::map<int, double> weights;
  for (int i = rows.Offsets[row]; i < rows.Offsets[row + 1]; ++i)
  {
    EXPECT_TRUE(weights.emplace(rows.Columns[i], rows.Weights[i]).second) << "a column twice";
  }
  return weights;
}

/// Compares all rows of the levels after one step, without solids, or after two, up to `levels`.
template <typename Level>
void ExpectRowsOfLevels(Level level, int levels)
{
  LimitKinds<int> kinds;
  for (int step = 1; step <= levels; ++step)
  {
    SCOPED_TRACE("level " + std::to_string(step));
    Level next = Refine(level, Depth::ForRefinement);
    if (step > 1 || !HasSolids(level))
    {
      const SparseRows<int> found = FindNextLimits(level, kinds).Store();
      const SparseRows<int> wanted = BuildLimitRows(next);
      ASSERT_EQ(found.GetNumberOfRows(), wanted.GetNumberOfRows());
      for (vtkIdType v = 0; v < found.GetNumberOfRows(); ++v)
      {
        const std::map<int, double> ofFound = ListWeights(found, v);
        const std::map<int, double> ofWanted = ListWeights(wanted, v);
        ASSERT_EQ(ofFound.size(), ofWanted.size()) << "vertex " << v;
        for (const auto& [column, weight] : ofWanted)
        {
          ASSERT_EQ(ofFound.count(column), 1u) << "vertex " << v << " column " << column;
          ASSERT_NEAR(ofFound.at(column), weight, 1e-14) << "vertex " << v << " column " << column;
        }
      }
    }
    if (HasSolids(level))
    {
      kinds.Refine(level);
      if (step == 1)
      {
        kinds.FindOwn(next);
      }
    }
    level = std::move(next);
  }
}

}

TEST(RegularLimits, AreThoseOfTheLevelItself)
{
  ForEachMeshAndOptions(
    [](const Mesh& mesh, const std::string& options)
    {
      // A third level has midpoints inside faces that lie in solids.
      const int levels = mesh.Points.size() < 24 ? 3 : 2;
      ExpectRowsOfLevels(BuildNamed<int>(mesh, options).Level, levels);
      ExpectRowsOfLevels(MakeTetOctLevel(BuildNamed<int>(mesh, options).Level), levels);
    });
}
