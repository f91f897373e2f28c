// SPDX-License-Identifier: BSD-3-Clause
// Limits from a lattice against those from levels, the reference: the same but for rounding.
#include "LimitTools.h"

#include "Core/Solids/Limits/LocalLimit.h"
#include "Core/Solids/RedGreen/RedGreen.h"

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

vtkIdType CountFlags(const Buffer<unsigned char>& flags)
{
  return std::count(flags.begin(), flags.end(), 1);
}

template <typename Id>
std::map<Id, double> GetEntries(const SparseRows<Id>& rows, vtkIdType row)
{
  std::map<Id, double> entries;
  for (Id k = rows.Offsets[row]; k < rows.Offsets[row + 1]; ++k)
  {
    EXPECT_TRUE(entries.emplace(rows.Columns[k], rows.Weights[k]).second);
  }
  return entries;
}

/// The rows of both, entry by entry in whatever order, and what they make of values.
template <typename Id>
void ExpectNear(const LocalLimit<Id>& onLattice, const LocalLimit<Id>& onLevels)
{
  constexpr double tolerance = 1e-12; // weights of a row are at most 1, and values at most 1
  const SparseRows<Id> rows = BuildRows(onLattice);
  const SparseRows<Id> expected = BuildRows(onLevels);
  ASSERT_EQ(rows.GetNumberOfRows(), expected.GetNumberOfRows());
  for (vtkIdType i = 0; i < rows.GetNumberOfRows(); ++i)
  {
    const std::map<Id, double> row = GetEntries(rows, i);
    const std::map<Id, double> wanted = GetEntries(expected, i);
    ASSERT_EQ(row.size(), wanted.size()) << "row " << i;
    for (auto a = row.begin(), b = wanted.begin(); a != row.end(); ++a, ++b)
    {
      ASSERT_EQ(a->first, b->first) << "row " << i;
      ASSERT_NEAR(a->second, b->second, tolerance) << "row " << i;
    }
  }
  const auto values = MakeValues(3 * static_cast<int>(onLevels.GetNumberOfColumns()), 3);
  std::vector<double> limits(3 * onLevels.GetNumberOfRows(), 1.);
  std::vector<double> wanted = limits;
  onLattice.Apply(values.data(), limits.data(), 3);
  onLevels.Apply(values.data(), wanted.data(), 3);
  for (std::size_t i = 0; i < limits.size(); ++i)
  {
    ASSERT_NEAR(limits[i], wanted[i], tolerance) << "value " << i;
  }
}

/// From a lattice; what it does not know, which `others` receives, from levels.
template <typename Id>
LocalLimit<Id> MakeOnBoth(const Level<Id>& control, const SemiSharpStages<Id>& creases,
  const std::vector<std::array<Id, 2>>& ends, Buffer<unsigned char>& others)
{
  auto limit = LocalLimit<Id>::MakeOnLattice(control, creases, ends, {}, others);
  if (CountFlags(others) > 0)
  {
    limit.Append(LocalLimit<Id>(control, creases, ends, others));
  }
  return limit;
}

/// Vertices once more on later levels, named by equal ends.
template <typename Id>
void ExpectNearOnLaterLevels()
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
    Buffer<unsigned char> others;
    const auto onLattice = LocalLimit<Id>::MakeOnLattice(control.Level, {}, ends, {}, others);
    ASSERT_EQ(CountFlags(others), 0);
    ExpectNear(onLattice, LocalLimit<Id>(control.Level, {}, ends));
  }
}

}

/// On a lattice all is known but what is beside a sharp joint.
TEST(LocalLimitOnLattice, HasTheRowsOfLevels)
{
  static const std::set<std::string> partly = { "Sharp", "Regional" };
  std::mt19937 random(5);
  int known = 0;
  int partlyKnown = 0;
  for (const Mesh& mesh : MakeZooAndRandom())
  {
    for (const std::string options : OptionNames)
    {
      SCOPED_TRACE(mesh.Name + " " + options);
      const auto control = BuildNamed<int>(mesh, options);
      const int whole = mesh.Cells.GetNumberOfSimplices() > 30 ? 1 : 2;
      const Ends ends = RefineByChance(mesh, 5, whole, random);
      Buffer<unsigned char> others;
      const auto limit = MakeOnBoth<int>(control.Level, {}, ends, others);
      const bool knowsAll = CountFlags(others) == 0;
      EXPECT_TRUE(knowsAll || partly.count(options) > 0);
      (knowsAll ? known : partlyKnown) += CountFlags(others) < others.size() ? 1 : 0;
      ExpectNear(limit, LocalLimit<int>(control.Level, {}, ends));
      if (testing::Test::HasFatalFailure())
      {
        return;
      }
    }
  }
  EXPECT_GT(known, 500);
  EXPECT_GT(partlyKnown, 10);
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
  Buffer<unsigned char> others;
  const auto onLattice = LocalLimit<int>::MakeOnLattice(control.Level, {}, ends, wanted, others);
  ASSERT_EQ(CountFlags(others), 0);
  const LocalLimit<int> onLevels(control.Level, {}, ends, wanted);
  ExpectNear(onLattice, onLevels);
  EXPECT_EQ(onLattice.GetNumberOfLevels(), 6);
  EXPECT_EQ(CountSupportValues(onLattice), CountSupportValues(onLevels));
}

/// Limits beside what is semi-sharp come from levels, all others from the lattice.
TEST(LocalLimitOnLattice, SemiSharpCreases)
{
  std::mt19937 random(6);
  int partlyKnown = 0;
  for (const Mesh& mesh : MakeZooAndRandom())
  {
    for (const char* options : { "Blend", "Regional", "ModifiedBoundary" })
    {
      SCOPED_TRACE(mesh.Name + " " + options);
      const SemiSharpMesh sharp(mesh, options, 3);
      const auto level = sharp.MakeSmoothLevel(0);
      const auto creases = sharp.MakeStages(0);
      const Ends ends = RefineByChance(mesh, 3, 1, random);
      Buffer<unsigned char> others;
      const auto limit = MakeOnBoth<int>(level, creases, ends, others);
      partlyKnown += CountFlags(others) > 0 && CountFlags(others) < others.size() ? 1 : 0;
      ExpectNear(limit, LocalLimit<int>(level, creases, ends));
      if (testing::Test::HasFatalFailure())
      {
        return;
      }
    }
  }
  EXPECT_GT(partlyKnown, 10);
}

TEST(LocalLimitOnLattice, VerticesOnLaterLevels)
{
  ExpectNearOnLaterLevels<int>();
  ExpectNearOnLaterLevels<long long>();
}

/// What lies in no simplex is left to levels, which say what is wrong.
TEST(LocalLimitOnLattice, EndsInNoSimplex)
{
  const auto line = Build<int>(FindInZoo("OpenPolyline").Cells);
  const auto isMade = [&line](const Ends& ends)
  {
    Buffer<unsigned char> others;
    LocalLimit<int>::MakeOnLattice(line.Level, {}, ends, {}, others);
    return CountFlags(others) == 0;
  };
  EXPECT_TRUE(isMade({ { 0, 1 }, { 5, 0 }, { 1, 0 } }));
  EXPECT_FALSE(isMade({ { 0, 2 } }));
  EXPECT_FALSE(isMade({ { 0, 5 } }));
  EXPECT_FALSE(isMade({ { -1, 1 } }));
  EXPECT_FALSE(isMade({ { 0, 1 }, { 5, 2 } }));
}
