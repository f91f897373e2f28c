// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 8 and 10: limits where solids are tetrahedra and octahedra. What a limit row says of
// a level's values must be what the rows of the next level say of the next values.
#include "LimitTools.h"
#include "TetOctTools.h"

using namespace tetoct_tools;

namespace
{

TetOctLevel<int> RefineTimes(TetOctLevel<int> level, int steps)
{
  for (int i = 0; i < steps; ++i)
  {
    level = Refine(level, Depth::ForRefinement);
  }
  return level;
}

/// A level as it is where all edges and faces are singular that are sharper than `sharpness`.
TetOctLevel<int> MakeLevel(const SemiSharpMesh& semi, int steps, double sharpness)
{
  return RefineTimes(MakeTetOctLevel(semi.MakeLevel(0, sharpness)), steps);
}

SemiSharpStages<int> MakeStages(const SemiSharpMesh& semi, int steps)
{
  SemiSharpStages<int> stages = semi.GiveSharpness(steps, MakeLevel(semi, steps, 1e9).Complex);
  for (int step = steps; step < semi.GetMostSharpness(); ++step)
  {
    TetOctLevel<int> level = MakeLevel(semi, steps, step);
    stages.Stages.push_back({ step + 1 - steps, std::move(level.Strata), level.TetsAtSpokes });
  }
  return stages;
}

Stencils<int> MakeStencils(const SemiSharpMesh& semi, int steps)
{
  TetOctLevel<int> smooth = MakeLevel(semi, steps, 1e9);
  TetOctLevel<int> sharp = MakeLevel(semi, steps, steps);
  Stencils<int> stencils = TakeStencils(smooth);
  const auto rows = FindSharpRows(semi.Sharpness, steps, steps, sharp.Complex);
  BlendSemiSharp(rows, TakeStencils(sharp), stencils);
  return stencils;
}

}

TEST(TetOctLimits, AStepDoesNotMoveTheLimit)
{
  ForEachMeshAndOptions(
    [](const Mesh& mesh, const std::string& options)
    {
      TetOctLevel<int> level = MakeTetOctLevel(BuildNamed<int>(mesh, options).Level);
      std::vector<double> values = MakeValues(level.Complex.NumberOfVertices, 1);
      std::vector<double> limits = ApplyTo(BuildLimitRows(level), values, 1);
      for (int step = 0; step < 2; ++step)
      {
        values = ApplyTo(CopyStencils(level), values, 1);
        level = Refine(level, Depth::ForRefinement);
        const std::vector<double> next = ApplyTo(BuildLimitRows(level), values, 1);
        ExpectSameStart(limits, next);
        limits = next;
      }
    });
}

TEST(TetOctLimits, StepsWithSemiSharpCreasesDoNotMoveTheLimit)
{
  unsigned int seed = 0;
  ForEachMeshAndOptions(
    [&seed](const Mesh& mesh, const std::string& options)
    {
      const SemiSharpMesh semi(mesh, options, ++seed);
      std::vector<double> values = MakeValues(mesh.Cells.NumberOfPoints, seed);
      std::vector<double> limits =
        ApplyTo(BuildLimitRows(MakeLevel(semi, 0, 1e9), MakeStages(semi, 0)), values, 1);
      const int most = mesh.Cells.NumberOfPoints > 20 ? 1 : 2;
      for (int step = 0; step < most; ++step)
      {
        values = ApplyTo(MakeStencils(semi, step), values, 1);
        const std::vector<double> next = ApplyTo(
          BuildLimitRows(MakeLevel(semi, step + 1, 1e9), MakeStages(semi, step + 1)), values, 1);
        ExpectSameStart(limits, next);
        limits = next;
      }
    });
}

TEST(TetOctLimits, RowsAreConvexAndReadTheCellsAroundTheVertex)
{
  for (const Mesh& mesh : MakeZooAndRandom())
  {
    SCOPED_TRACE(mesh.Name);
    const TetOctMesh<int> level = BuildTetOctAt<int>(mesh, 1);
    const int vertices = level.Level.Complex.NumberOfVertices;
    std::vector<std::set<int>> around(vertices);
    for (const Solid& solid : GetSolids(level.Level))
    {
      for (vtkIdType v : solid)
      {
        around[v].insert(solid.begin(), solid.end());
      }
    }
    for (int e = 0; e < level.Level.Complex.NumberOfEdges; ++e)
    {
      const int* ends = level.Level.Complex.EdgeVertices.data() + 2 * e;
      around[ends[0]].insert(ends[1]);
      around[ends[1]].insert(ends[0]);
    }
    const SparseRows<int> rows = BuildLimitRows(level.Level);
    ASSERT_EQ(rows.GetNumberOfRows(), vertices);
    ASSERT_EQ(rows.GetNumberOfColumns(), vertices);
    for (int v = 0; v < vertices; ++v)
    {
      double sum = 0.;
      std::set<int> columns;
      for (int k = rows.Offsets[v]; k < rows.Offsets[v + 1]; ++k)
      {
        ASSERT_TRUE(columns.insert(rows.Columns[k]).second) << "a column twice";
        ASSERT_TRUE(rows.Columns[k] == v || around[v].count(rows.Columns[k]) > 0);
        ASSERT_GT(rows.Weights[k], 0.);
        sum += rows.Weights[k];
      }
      ASSERT_NEAR(sum, 1., 2e-15);
      if (level.Level.Strata.Vertices[v].GetRule() == Rule::RegularEdge)
      {
        ASSERT_EQ(columns.size(), 19u);
      }
    }
  }
}

/// Where all is regular a limit is a sum of values of one function, the solution of the refinement
/// equation with the mask of figure 9 convolved with itself, at lattice points.
TEST(TetOctLimits, RegularVerticesHaveTheRefinableFunction)
{
  // In four coordinates that sum to zero the neighbours of a lattice point are the permutations of
  // (1,-1,0,0), and what is opposite in an octahedron those of (1,1,-1,-1).
  using Place = std::array<int, 4>;
  std::map<Place, double> linear = { { { 0, 0, 0, 0 }, 1. } };
  const std::pair<Place, double> kinds[] = { { { -1, 0, 0, 1 }, 1. / 2. },
    { { -1, -1, 1, 1 }, 1. / 6. } };
  for (const auto& kind : kinds)
  {
    Place place = kind.first;
    do
    {
      linear[place] = kind.second;
    } while (std::next_permutation(place.begin(), place.end()));
  }
  std::map<Place, double> mask;
  for (const auto& a : linear)
  {
    for (const auto& b : linear)
    {
      Place sum;
      std::transform(
        a.first.begin(), a.first.end(), b.first.begin(), sum.begin(), std::plus<int>());
      mask[sum] += a.second * b.second / 8.;
    }
  }
  // Its values f at the 19 places: f(p) = sum of mask(2 p - q) f(q).
  std::map<Place, double> f = linear;
  for (int iteration = 0; iteration < 200; ++iteration)
  {
    std::map<Place, double> next;
    double sum = 0.;
    for (const auto& p : f)
    {
      for (const auto& q : f)
      {
        Place offset;
        for (int c = 0; c < 4; ++c)
        {
          offset[c] = 2 * p.first[c] - q.first[c];
        }
        const auto weight = mask.find(offset);
        next[p.first] += weight == mask.end() ? 0. : weight->second * q.second;
      }
      sum += next[p.first];
    }
    for (auto& value : next)
    {
      value.second /= sum;
    }
    f = next;
  }
  const TetOctMesh<int> level = BuildTetOctAt<int>(MakeTet("Tet"), 2);
  const SparseRows<int> rows = BuildLimitRows(level.Level);
  int regular = 0;
  for (int v = 0; v < level.Level.Complex.NumberOfVertices; ++v)
  {
    if (level.Level.Strata.Vertices[v].GetRule() == Rule::RegularEdge)
    {
      const Row<int> ring = level.Level.Strata.VertexRings.GetMembers(v);
      EXPECT_NEAR(GetWeight(rows, v, v), (f[{ 0, 0, 0, 0 }]), 1e-14);
      EXPECT_NEAR(GetWeight(rows, v, ring.begin()[0]), (f[{ -1, 0, 0, 1 }]), 1e-14);
      EXPECT_NEAR(GetWeight(rows, v, ring.begin()[17]), (f[{ -1, -1, 1, 1 }]), 1e-14);
      ++regular;
    }
  }
  EXPECT_GT(regular, 0);
}

TEST(TetOctLimits, WideIdsChangeNothing)
{
  const Mesh mesh = MakeLattice("Lattice", 2, 0.3, 11).Control;
  const SparseRows<int> narrow = BuildLimitRows(BuildTetOctAt<int>(mesh, 1).Level);
  const SparseRows<long long> wide = BuildLimitRows(BuildTetOctAt<long long>(mesh, 1).Level);
  ASSERT_EQ(narrow.GetNumberOfRows(), wide.GetNumberOfRows());
  EXPECT_TRUE(std::equal(
    narrow.Columns.begin(), narrow.Columns.end(), wide.Columns.begin(), wide.Columns.end()));
  EXPECT_TRUE(std::equal(
    narrow.Weights.begin(), narrow.Weights.end(), wide.Weights.begin(), wide.Weights.end()));
}
