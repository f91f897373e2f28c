// SPDX-License-Identifier: BSD-3-Clause
// Limits from a lattice against those from levels: the same bits.
#include "LimitTools.h"

#include "Core/Solids/Limits/LocalLimit.h"
#include "Core/Solids/RedGreen/RedGreen.h"

#include <gtest/gtest.h>

#include <cstring>
#include <optional>
#include <random>
#include <set>

using namespace coretest;

namespace
{

using Ends = std::vector<std::array<int, 2>>;

/// The midpoints of a red-green refinement with `levels` levels: all cells are marked `whole`
/// times, and then four of the finest.
Ends RefineByChance(const Mesh& mesh, int levels, int whole, std::mt19937& random)
{
  RedGreen<int> state{ SimplexView(mesh.Cells) };
  std::vector<RedGreenLeaf<int>> finest;
  for (vtkIdType cell = 0; cell < mesh.Cells.GetNumberOfSimplices(); ++cell)
  {
    finest.push_back({ static_cast<int>(cell), -1 });
  }
  for (int level = 0; level < levels; ++level)
  {
    for (std::size_t i = 0; i < finest.size() && (level < whole || i < 4); ++i)
    {
      state.MarkCell(finest[level < whole ? i : random() % finest.size()]);
    }
    state.Close();
    finest.clear();
    for (const auto& cell : state.GetChangedCells())
    {
      cell.Level == level + 1 ? finest.push_back(cell.Leaf) : void();
    }
  }
  Ends ends;
  for (int v = state.GetNumberOfInputVertices(); v < state.GetNumberOfVertices(); ++v)
  {
    ends.push_back(state.GetEnds(v));
  }
  return ends;
}

bool HaveEqualBits(const double* a, const double* b, std::size_t size)
{
  return std::memcmp(a, b, sizeof(double) * size) == 0;
}

/// The rows of both, entry by entry, and what they make of values.
template <typename Id>
void ExpectEqualBits(const LocalLimit<Id>& onLattice, const LocalLimit<Id>& onLevels)
{
  const SparseRows<Id> rows = onLattice.BuildRows();
  const SparseRows<Id> expected = onLevels.BuildRows();
  ASSERT_EQ(rows.Offsets.size(), expected.Offsets.size());
  ASSERT_EQ(onLattice.GetNumberOfLevels(), onLevels.GetNumberOfLevels());
  for (vtkIdType i = 0; i < rows.GetNumberOfRows(); ++i)
  {
    const Id begin = rows.Offsets[i];
    const Id size = rows.Offsets[i + 1] - begin;
    ASSERT_EQ(begin, expected.Offsets[i]) << "row " << i;
    ASSERT_EQ(size, expected.Offsets[i + 1] - begin) << "row " << i;
    ASSERT_TRUE(std::equal(rows.Columns.data() + begin, rows.Columns.data() + begin + size,
      expected.Columns.data() + begin))
      << "row " << i;
    ASSERT_TRUE(HaveEqualBits(
      rows.Weights.data() + begin, expected.Weights.data() + begin, static_cast<std::size_t>(size)))
      << "row " << i;
  }
  const auto values = MakeValues(3 * static_cast<int>(onLevels.GetNumberOfColumns()), 3);
  std::vector<double> limits(3 * onLevels.GetNumberOfRows(), 1.);
  std::vector<double> wanted = limits;
  onLattice.Apply(values.data(), limits.data(), 3);
  onLevels.Apply(values.data(), wanted.data(), 3);
  ASSERT_TRUE(HaveEqualBits(limits.data(), wanted.data(), limits.size()));
}

/// Vertices once more on later levels, named by equal ends.
template <typename Id>
void ExpectEqualBitsOnLaterLevels()
{
  for (const char* name : { "KuhnLattice", "OpenPolyline", "EverythingAtOnce" })
  {
    SCOPED_TRACE(name);
    const auto control = BuildNamed<Id>(FindInZoo(name), "Blend");
    const SimplicialComplex<Id>& complex = control.Level.Complex;
    std::vector<std::array<Id, 2>> ends;
    for (Id e = 0; e < complex.NumberOfEdges; ++e)
    {
      ends.push_back({ complex.EdgeVertices[2 * e], complex.EdgeVertices[2 * e + 1] });
    }
    for (Id i = 0; i < 2 * (complex.NumberOfVertices + complex.NumberOfEdges); ++i)
    {
      ends.push_back({ i, i });
    }
    const auto onLattice = LocalLimit<Id>::MakeOnLattice(control.Level, ends, {});
    ASSERT_TRUE(onLattice);
    ExpectEqualBits(*onLattice, LocalLimit<Id>(control.Level, {}, ends));
  }
}

}

/// On a lattice all is known but what is beside a sharp joint, or a sector with rules of its own.
TEST(LocalLimitOnLattice, HasTheRowsOfLevels)
{
  static const std::set<std::string> partly = { "Sharp", "Regional", "ModifiedBoundary",
    "ModifiedDart" };
  std::mt19937 random(5);
  int known = 0;
  for (const Mesh& mesh : MakeZooAndRandom())
  {
    for (const std::string options : OptionNames)
    {
      SCOPED_TRACE(mesh.Name + " " + options);
      const auto control = BuildNamed<int>(mesh, options);
      const int whole = mesh.Cells.GetNumberOfSimplices() > 30 ? 1 : 2;
      const Ends ends = RefineByChance(mesh, 5, whole, random);
      const auto onLattice = LocalLimit<int>::MakeOnLattice(control.Level, ends, {});
      EXPECT_TRUE(onLattice || partly.count(options) > 0);
      if (onLattice)
      {
        ++known;
        ExpectEqualBits(*onLattice, LocalLimit<int>(control.Level, {}, ends));
      }
      if (testing::Test::HasFatalFailure())
      {
        return;
      }
    }
  }
  EXPECT_GT(known, 500);
}

/// The same vertices of a solid on five levels, some of them wanted.
TEST(LocalLimitOnLattice, OnlyWhatIsWanted)
{
  const Mesh mesh = FindInZoo("KuhnLattice");
  const auto control = BuildNamed<int>(mesh, "Blend");
  std::mt19937 random(8);
  const Ends ends = RefineByChance(mesh, 5, 1, random);
  Buffer<unsigned char> wanted(
    control.Level.Complex.NumberOfVertices + static_cast<vtkIdType>(ends.size()), 0);
  for (vtkIdType i = 0; i < wanted.size(); i += 7)
  {
    wanted[i] = 1;
  }
  const auto onLattice = LocalLimit<int>::MakeOnLattice(control.Level, ends, wanted);
  ASSERT_TRUE(onLattice);
  const LocalLimit<int> onLevels(control.Level, {}, ends, wanted);
  ExpectEqualBits(*onLattice, onLevels);
  EXPECT_EQ(onLattice->GetNumberOfLevels(), 6);
  EXPECT_EQ(onLattice->GetNumberOfSupportValues(), onLevels.GetNumberOfSupportValues());
}

TEST(LocalLimitOnLattice, VerticesOnLaterLevels)
{
  ExpectEqualBitsOnLaterLevels<int>();
  ExpectEqualBitsOnLaterLevels<long long>();
}

/// What lies in no simplex is left to LocalLimit, which says what is wrong.
TEST(LocalLimitOnLattice, EndsInNoSimplex)
{
  const auto line = Build<int>(FindInZoo("OpenPolyline").Cells);
  const auto isMade = [&line](const Ends& ends)
  { return LocalLimit<int>::MakeOnLattice(line.Level, ends, {}).has_value(); };
  EXPECT_TRUE(isMade({ { 0, 1 }, { 5, 0 }, { 1, 0 } }));
  EXPECT_FALSE(isMade({ { 0, 2 } }));
  EXPECT_FALSE(isMade({ { 0, 5 } }));
  EXPECT_FALSE(isMade({ { -1, 1 } }));
  EXPECT_FALSE(isMade({ { 0, 1 }, { 5, 2 } }));
}

/// Solids that are split as a whole have rings at each control edge and face, and few vertices at
/// each of them unless levels are many.
TEST(LocalLimitOnLattice, IsFasterOnManyLevels)
{
  std::mt19937 random(7);
  const auto isFaster = [&random](const char* name, int levels, int whole)
  {
    const Mesh& mesh = FindInZoo(name);
    const Ends ends = RefineByChance(mesh, levels, whole, random);
    return LocalLimit<int>::IsLatticeFaster(Build<int>(mesh.Cells).Level.Complex, ends);
  };
  for (int levels = 1; levels <= 3; ++levels)
  {
    EXPECT_FALSE(isFaster("KuhnLattice", levels, levels)) << levels;
  }
  EXPECT_TRUE(isFaster("KuhnLattice", 4, 4));
  EXPECT_TRUE(isFaster("KuhnLattice", 3, 1)); // three levels, but not whole ones
  EXPECT_FALSE(isFaster("OpenPolyline", 6, 1));
  // A small part of a mesh.
  const Mesh lattice = FindInZoo("KuhnLattice");
  const auto control = Build<int>(lattice.Cells);
  EXPECT_TRUE(LocalLimit<int>::IsLatticeFaster(control.Level.Complex,
    { { control.Level.Complex.EdgeVertices[0], control.Level.Complex.EdgeVertices[1] } }));
}
