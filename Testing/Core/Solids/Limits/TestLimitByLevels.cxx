// SPDX-License-Identifier: BSD-3-Clause
// LocalLimit against the levels themselves: the same but for rounding.
#include "LimitByLevels.h"
#include "LimitTools.h"
#include "TetOctTools.h"

#include "Core/Solids/Limits/LocalLimit.h"
#include "Core/Solids/RedGreen/RedGreen.h"

using namespace tetoct_tools;

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
template <typename LevelType, typename Id>
void ExpectNear(const LocalLimit<Id>& limit, const LimitByLevels<LevelType>& onLevels)
{
  constexpr double tolerance = 1e-12; // weights of a row are at most 1, and values at most 1
  const SparseRows<Id> rows = BuildRows(limit);
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
  const std::vector<double> limits = ApplyTo(limit, values, 3);
  const std::vector<double> wanted = ApplyTo(expected, values, 3);
  for (std::size_t i = 0; i < limits.size(); ++i)
  {
    ASSERT_NEAR(limits[i], wanted[i], tolerance) << "value " << i;
  }
}

/// The tetrahedra of a level, and its octahedra in four pieces around a diagonal.
Mesh CutToTets(const TetOctLevel<int>& level)
{
  Mesh mesh;
  mesh.Cells.NumberOfPoints = level.Complex.NumberOfVertices;
  auto& corners = mesh.Cells.Connectivity;
  corners.assign(level.Complex.TetVertices.begin(), level.Complex.TetVertices.end());
  for (int oct = 0; oct < level.NumberOfOctahedra; ++oct)
  {
    const int* v = level.OctVertices.data() + 6 * oct;
    const int first = oct % 3;
    const int others[2] = { (first + 1) % 3, (first + 2) % 3 };
    for (int piece = 0; piece < 4; ++piece)
    {
      corners.insert(corners.end(),
        { v[2 * first], v[2 * others[0] + piece % 2], v[2 * first + 1],
          v[2 * others[1] + piece / 2] });
    }
  }
  mesh.Cells.Dimensions.assign(corners.size() / 4, 3);
  return mesh;
}

template <typename LevelType>
void ExpectNear(const LevelType& level, const SemiSharpStages<typename LevelType::IdType>& creases,
  const std::vector<std::array<typename LevelType::IdType, 2>>& ends)
{
  ExpectNear(LocalLimit<typename LevelType::IdType>(level, creases, ends),
    LimitByLevels<LevelType>(level, creases, ends));
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
    ExpectNear<Level<Id>>(control.Level, {}, ends);
  }
}

}

/// By both schemes, with all rules.
TEST(LimitByLevels, HasTheRowsOfLocalLimit)
{
  std::mt19937 random(5);
  for (const Mesh& mesh : MakeZooAndRandom())
  {
    for (const std::string options : OptionNames)
    {
      SCOPED_TRACE(mesh.Name + " " + options);
      const int whole = mesh.Cells.GetNumberOfSimplices() > 30 ? 1 : 2;
      const Ends ends = RefineByChance(mesh, 5, whole, random);
      ExpectNear<Level<int>>(BuildNamed<int>(mesh, options).Level, {}, ends);
      const TetOctLevel<int> tetOct =
        MakeTetOctLevel(std::move(BuildNamed<int>(mesh, options).Level));
      ExpectNear(tetOct, {}, ends);
      if (testing::Test::HasFatalFailure())
      {
        return;
      }
    }
  }
}

/// Pieces of the octahedra of a level that was made as a whole.
TEST(LimitByLevels, HasTheRowsOfOctahedra)
{
  std::mt19937 random(7);
  for (const char* name : { "Tet", "TwoTets", "EverythingAtOnce" })
  {
    for (const char* options : { "Blend", "Sharp", "Follow2" })
    {
      SCOPED_TRACE(std::string(name) + " " + options);
      const TetOctLevel<int> level =
        Refine(MakeTetOctLevel(std::move(BuildNamed<int>(FindInZoo(name), options).Level)),
          Depth::ForRefinement);
      ExpectNear(level, {}, RefineByChance(CutToTets(level), 4, 1, random));
    }
  }
}

TEST(LimitByLevels, ReadsTheSameVertices)
{
  const auto control = BuildNamed<int>(FindInZoo("KuhnLattice"), "Blend");
  std::mt19937 random(8);
  const Ends ends = RefineByChance(FindInZoo("KuhnLattice"), 5, 1, random);
  const LocalLimit<int> limit(control.Level, {}, ends);
  EXPECT_EQ(limit.GetNumberOfLevels(), 6);
  EXPECT_EQ(CountSupportValues(limit),
    CountSupportValues(LimitByLevels<Level<int>>(control.Level, {}, ends)));
}

TEST(LimitByLevels, SemiSharpCreases)
{
  std::mt19937 random(6);
  for (const Mesh& mesh : MakeZooAndRandom())
  {
    for (const char* options : { "Blend", "Regional", "ModifiedBoundary" })
    {
      SCOPED_TRACE(mesh.Name + " " + options);
      const SemiSharpMesh sharp(mesh, options, 3);
      const Ends ends = RefineByChance(mesh, 3, 1, random);
      ExpectNear(sharp.MakeSmoothLevel(0), sharp.MakeStages(0), ends);
      if (testing::Test::HasFatalFailure())
      {
        return;
      }
    }
  }
}

TEST(LimitByLevels, VerticesOnLaterLevels)
{
  ExpectNearOnLaterLevels<int>();
  ExpectNearOnLaterLevels<long long>();
}

TEST(LimitByLevels, EndsInNoCell)
{
  const auto line = Build<int>(FindInZoo("OpenPolyline").Cells);
  const auto make = [&line](const Ends& ends) { LocalLimit<int>(line.Level, {}, ends); };
  EXPECT_NO_THROW(make({ { 0, 1 }, { 5, 0 }, { 1, 0 } }));
  EXPECT_THROW(make({ { 0, 2 } }), std::invalid_argument);
  EXPECT_THROW(make({ { 0, 5 } }), std::invalid_argument);
  EXPECT_THROW(make({ { -1, 1 } }), std::invalid_argument);
  EXPECT_THROW(make({ { 0, 1 }, { 5, 2 } }), std::invalid_argument);
}
