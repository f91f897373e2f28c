// SPDX-License-Identifier: BSD-3-Clause
// Tet/oct operators and cells that are made without being stored: they are those that Refine
// stores.
#include "TetOctTools.h"

#include "Core/Operators/ApplyRows.h"
#include "Core/Solids/Scheme/ChildRows.h"

#include <gtest/gtest.h>

#include <mutex>

using namespace tetoct_tools;

namespace
{

/// Everything that makes a row.
struct RowContent
{
  char Kind = 0; ///< v, e, o; 0: not handed over
  int Rule = -1;
  int Type = -1;
  std::vector<int> Ends;
  std::vector<int> Ring;
  std::vector<int> Tets; ///< at the spokes of a control vertex
  bool operator==(const RowContent& other) const
  {
    return this->Kind == other.Kind && this->Rule == other.Rule && this->Type == other.Type &&
      this->Ends == other.Ends && this->Ring == other.Ring && this->Tets == other.Tets;
  }
};

/// All rows in order; fails when one is not handed over exactly once.
std::vector<RowContent> Collect(const RingOperator<int>& operation)
{
  std::vector<RowContent> all(operation.GetNumberOfRows());
  std::mutex mutex;
  operation.ForRows(
    [&](const RingRows<int>& rows)
    {
      const std::lock_guard<std::mutex> lock(mutex);
      for (vtkIdType i = 0; i < rows.Count; ++i)
      {
        ASSERT_LT(rows.FirstRow + i, static_cast<vtkIdType>(all.size()));
        RowContent& row = all[rows.FirstRow + i];
        ASSERT_EQ(row.Kind, 0) << rows.FirstRow + i;
        row.Kind = rows.OfCentres ? 'o' : rows.OfEdges ? 'e' : 'v';
        const Row<int> ring = rows.GetRing(i);
        row.Ring.assign(ring.begin(), ring.end());
        if (rows.OfCentres)
        {
          continue;
        }
        row.Rule = static_cast<int>(rows.Strata[i].GetRule());
        row.Type = rows.Strata[i].GetType();
        if (rows.OfEdges)
        {
          row.Ends.assign(rows.Ends + 2 * i, rows.Ends + 2 * i + 2);
        }
        else if (rows.HasCounts(i))
        {
          const int* tets = rows.Counts + rows.Offsets[i];
          row.Tets.assign(tets, tets + ring.size());
        }
      }
    });
  return all;
}

/// The same cells, whichever diagonals the points ask for.
void ExpectSameCells(
  const TetOctMesh<int>& level, const TetOctMesh<int>& children, const std::vector<double>& points)
{
  WrittenCells made(CountCells(RefineRuns(level.Runs, 2)));
  WriteTetOctGrandchildren(level.Level, level.Runs, points.data(), made.GetStorage());
  WrittenCells expected(CountCells(RefineRuns(children.Runs, 1)));
  WriteTetOctChildren(children.Level, children.Runs, points.data(), expected.GetStorage());
  ASSERT_EQ(made.Connectivity, expected.Connectivity);
  ASSERT_EQ(made.Offsets, expected.Offsets);
  ASSERT_EQ(made.Types, expected.Types);
}

void ExpectSameOnTheFly(const TetOctMesh<int>& level)
{
  const TetOctMesh<int> children = RefineOnce(level);
  const auto stored = Collect(LevelRows<int>(children.Level));
  const ChildRows<TetOctSplit<int>> rows(level.Level);
  ASSERT_EQ(rows.GetNumberOfVertices(), children.Level.Complex.NumberOfVertices);
  ASSERT_EQ(rows.GetNumberOfEdges(), children.Level.Complex.NumberOfEdges);
  ASSERT_EQ(rows.GetNumberOfRows(),
    rows.GetNumberOfVertices() + rows.GetNumberOfEdges() + children.Level.NumberOfOctahedra);
  const auto made = Collect(rows);
  ASSERT_EQ(made.size(), stored.size());
  for (std::size_t row = 0; row < stored.size(); ++row)
  {
    ASSERT_NE(stored[row].Kind, 0) << row;
    ASSERT_TRUE(made[row] == stored[row]) << row;
  }
  if (HasEqualCells(level.Level.Complex))
  {
    return;
  }
  std::mt19937 random(5);
  std::vector<double> points(3 * stored.size());
  std::generate(points.begin(), points.end(), [&random] { return random() / 4294967296.; });
  ExpectSameCells(level, children, points);
  ExpectSameCells(level, children, std::vector<double>(points.size(), 1.)); // all diagonals tie
}

}

TEST(TetOctChildRows, AreThoseOfTheStoredLevel)
{
  for (JointRule rule : { JointRule::Blend, JointRule::Sharp, JointRule::FollowDimension2 })
  {
    StrataOptions options;
    options.Type1 = options.Type2 = options.Type3 = rule;
    for (const Mesh& mesh : MakeZooAndRandom())
    {
      SCOPED_TRACE(mesh.Name);
      const TetOctMesh<int> level = BuildTetOct<int>(mesh.Cells, mesh.Singular, options);
      ExpectSameOnTheFly(level);
      ExpectSameOnTheFly(RefineOnce(level));
    }
  }
}

TEST(TetOctChildRows, ManyBlocks)
{
  const Mesh mesh = MakeLattice("many", 8, 1., 1).Control;
  const TetOctMesh<int> level = BuildTetOct<int>(mesh.Cells, mesh.Singular);
  ASSERT_GT(level.Level.Complex.NumberOfEdges, 2000);
  ExpectSameOnTheFly(RefineOnce(level));
}

/// What a filter does in its last two steps.
TEST(TetOctChildRows, SumsAreThoseOfTheStoredOperators)
{
  const Mesh mesh = MakeLattice("Lattice", 4, 0.3, 11).Control;
  const TetOctMesh<int> level = BuildTetOctAt<int>(mesh, 1);
  std::mt19937 random(3);
  for (int components : { 1, 2, 3 })
  {
    std::vector<double> values(level.Level.Complex.NumberOfVertices * components);
    std::generate(values.begin(), values.end(), [&random] { return random() / 4294967296.; });
    auto apply = [components](const auto& operation, const std::vector<double>& in)
    {
      std::vector<double> out(operation.GetNumberOfRows() * components);
      operation.ForRows(
        [&](const RingRows<int>& rows) { SumRows(rows, in.data(), out.data(), components); });
      return out;
    };
    const std::vector<double> made =
      apply(ChildRows<TetOctSplit<int>>(level.Level), apply(LevelRows<int>(level.Level), values));
    std::vector<double> expected = values;
    const TetOctMesh<int> children = RefineOnce(level);
    for (const TetOctMesh<int>* step : { &level, &children })
    {
      const Stencils<int> stencils = CopyStencils(step->Level);
      std::vector<double> next(stencils.GetNumberOfRows() * components);
      stencils.Apply(expected.data(), next.data(), components);
      expected = std::move(next);
    }
    ASSERT_EQ(made, expected);
  }
}
