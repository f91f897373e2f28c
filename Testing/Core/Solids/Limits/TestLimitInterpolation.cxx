// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 8, Interpolation: with the limit rows of all meshes and rules, and of both volume
// schemes, few products are needed.
#include "LimitTools.h"
#include "TetOctTools.h"

#include "Core/Operators/Interpolation.h"

using namespace tetoct_tools;

namespace
{

/// The number of products that random values need; their limits are checked.
template <typename Level>
int CountProducts(const Level& level, const SemiSharpStages<int>& creases)
{
  const auto rows = BuildLimitRows(level, creases);
  const std::vector<double> given = MakeValues(rows.GetNumberOfRows(), 3);
  std::vector<double> control(given.size());
  std::vector<InterpolationGroup> groups{ { 1 } };
  InterpolationLimits limits;
  limits.LeastEigenvalue = GetLeastEigenvalue(level.Strata.Weights);
  FindInterpolation(rows, given.data(), groups, limits, control.data());
  EXPECT_TRUE(groups[0].HasConverged) << groups[0].Error;
  for (std::size_t i = 0; i < given.size(); ++i)
  {
    control[i] += given[i];
  }
  const std::vector<double> limit = ApplyTo(rows, control, 1);
  const auto [low, high] = std::minmax_element(given.begin(), given.end());
  for (std::size_t i = 0; i < given.size(); ++i)
  {
    EXPECT_NEAR(limit[i], given[i], 1.1e-10 * (*high - *low)) << i;
  }
  return groups[0].Products;
}

}

TEST(LimitInterpolation, FewProductsForAllMeshesAndRules)
{
  int most = 0;
  for (const Mesh& mesh : MakeZooAndRandom())
  {
    const auto test = [&](const auto& level, const SemiSharpStages<int>& creases)
    { most = std::max(most, CountProducts(level, creases)); };
    for (const char* options : OptionNames)
    {
      SCOPED_TRACE(mesh.Name + " " + options);
      test(BuildNamed<int>(mesh, options).Level, {});
      test(MakeTetOctLevel(BuildNamed<int>(mesh, options).Level), {});
    }
    SCOPED_TRACE(mesh.Name + " semi-sharp");
    const SemiSharpMesh semi(mesh, "Blend", 5);
    test(semi.MakeSmoothLevel(0), semi.MakeStages(0));
  }
  EXPECT_EQ(most, 40) << "three tetrahedra on one triangle are solved for directly";
}
