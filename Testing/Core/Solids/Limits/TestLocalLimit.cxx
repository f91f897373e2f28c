// SPDX-License-Identifier: BSD-3-Clause
// Limits of some vertices of the uniform refinement against the uniform refinement itself.
#include "LimitByLevels.h"
#include "LimitTools.h"
#include "TetOctTools.h"

#include "Core/Solids/Limits/LocalLimit.h"
#include "Core/Solids/Limits/Restriction.h"
#include "Core/Solids/RedGreen/RedGreenOutput.h"

#include <stdexcept>

using namespace tetoct_tools;

namespace
{

/// Vertices of the uniform refinement that are asked for: all edges of some level, or some of them
/// and so on down, and diagonals of octahedra; each with its number there.
struct Asked
{
  std::vector<std::array<int, 2>> Ends;
  std::vector<int> Uniform; ///< number in the uniform refinement, control vertices included
};

/// The ends of what has a vertex of the next level in its middle; centres by one diagonal.
std::vector<std::array<int, 2>> ListEnds(const Level<int>& level)
{
  std::vector<std::array<int, 2>> ends;
  for (int e = 0; e < level.Complex.NumberOfEdges; ++e)
  {
    ends.push_back({ level.Complex.EdgeVertices[2 * e], level.Complex.EdgeVertices[2 * e + 1] });
  }
  return ends;
}
std::vector<std::array<int, 2>> ListEnds(const TetOctLevel<int>& level)
{
  std::vector<std::array<int, 2>> ends;
  for (int e = 0; e < level.Complex.NumberOfEdges; ++e)
  {
    ends.push_back({ level.Complex.EdgeVertices[2 * e], level.Complex.EdgeVertices[2 * e + 1] });
  }
  for (int oct = 0; oct < level.NumberOfOctahedra; ++oct)
  {
    const int first = 6 * oct + 2 * (oct % 3);
    ends.push_back({ level.OctVertices[first + 1], level.OctVertices[first] });
  }
  return ends;
}

/// `take(level, edge)`: whether the point of an edge whose ends are asked for is asked for too.
template <typename LevelType, typename Take>
Asked Ask(const std::vector<LevelType>& levels, const Take& take)
{
  Asked asked;
  std::map<int, int> numbers; // number of a uniform vertex among those asked for
  for (int v = 0; v < levels[0].Complex.NumberOfVertices; ++v)
  {
    numbers[v] = v;
    asked.Uniform.push_back(v);
  }
  for (std::size_t l = 0; l + 1 < levels.size(); ++l)
  {
    const auto& complex = levels[l].Complex;
    std::map<int, int> next = numbers;
    const auto ends = ListEnds(levels[l]);
    for (int e = 0; e < static_cast<int>(ends.size()); ++e)
    {
      const auto a = numbers.find(ends[e][0]);
      const auto b = numbers.find(ends[e][1]);
      if (a != numbers.end() && b != numbers.end() && take(static_cast<int>(l), e))
      {
        next[complex.NumberOfVertices + e] = static_cast<int>(asked.Uniform.size());
        asked.Uniform.push_back(complex.NumberOfVertices + e);
        asked.Ends.push_back({ a->second, b->second });
      }
    }
    numbers = next;
  }
  return asked;
}

/// Values on all levels.
template <typename LevelType>
std::vector<std::vector<double>> SubdivideValues(
  const std::vector<LevelType>& levels, const std::vector<double>& values)
{
  std::vector<std::vector<double>> all = { values };
  for (std::size_t l = 0; l + 1 < levels.size(); ++l)
  {
    all.push_back(ApplyTo(CopyStencils(levels[l]), all.back(), 2));
  }
  return all;
}

template <typename Limit>
void ExpectUniformLimits(const Asked& asked, const Limit& limit, const std::vector<double>& values,
  const std::vector<double>& uniform)
{
  const SparseRows<int> rows = BuildRows(limit);
  ASSERT_EQ(rows.GetNumberOfRows(), static_cast<vtkIdType>(asked.Uniform.size()));
  ASSERT_EQ(rows.GetNumberOfColumns(), static_cast<vtkIdType>(values.size() / 2));
  const std::vector<double> byRows = ApplyTo(rows, values, 2);
  for (std::size_t i = 0; i < byRows.size(); ++i)
  {
    ASSERT_NEAR(byRows[i], uniform[2 * asked.Uniform[i / 2] + i % 2], 1e-13) << "vertex " << i / 2;
  }
  if constexpr (std::is_same<Limit, LocalLimit<int>>::value)
  {
    const std::vector<double> limits = ApplyTo(limit, values, 2);
    for (std::size_t i = 0; i < limits.size(); ++i)
    {
      ASSERT_NEAR(limits[i], byRows[i], 1e-13) << "vertex " << i / 2;
    }
  }
}

template <typename LevelType>
LevelType MakeLevel(const Mesh& mesh, const std::string& options)
{
  return SchemeOf<LevelType>::Start(std::move(BuildNamed<int>(mesh, options).Level));
}

template <typename LevelType = Level<int>>
std::vector<LevelType> MakeLevels(const Mesh& mesh, const std::string& options, int steps)
{
  std::vector<LevelType> levels;
  levels.push_back(MakeLevel<LevelType>(mesh, options));
  for (int i = 0; i < steps; ++i)
  {
    levels.push_back(Refine(levels.back(), Depth::ForRefinement));
  }
  return levels;
}

template <typename LevelType>
void ExpectUniformLimitsOfTheZoo()
{
  std::mt19937 random(5);
  for (const Mesh& mesh : MakeZooAndRandom())
  {
    for (const char* options : OptionNames)
    {
      SCOPED_TRACE(mesh.Name + " " + options);
      const int steps = mesh.Cells.GetNumberOfSimplices() > 30 ? 2 : 3;
      const auto levels = MakeLevels<LevelType>(mesh, options, steps);
      const std::vector<double> values = MakeValues(2 * levels[0].Complex.NumberOfVertices, 3);
      const auto all = SubdivideValues(levels, values);
      const auto uniform = ApplyTo(BuildLimitRows(levels.back()), all.back(), 2);
      const unsigned int rarely = 1 + random() % 6;
      const Asked asked = Ask(levels, [&](int, int) { return random() % rarely == 0; });
      ExpectUniformLimits(asked, LocalLimit<int>(levels[0], {}, asked.Ends), values, uniform);
      for (int rings = 0; rings < 2; ++rings) // without a ring, solids have to try again
      {
        const LimitByLevels<LevelType> byLevels(levels[0], {}, asked.Ends, rings);
        ExpectUniformLimits(asked, byLevels, values, uniform);
      }
      if (testing::Test::HasFatalFailure())
      {
        return;
      }
    }
  }
}

/// Values on the levels of a mesh, and what is semi-sharp there.
template <typename LevelType>
struct NormalLevels
{
  std::vector<LevelType> Levels;
  std::vector<SemiSharpStages<int>> Creases;
  std::vector<std::vector<double>> Points;
};

/// The normals of all vertices on the level on which they first exist, against those of whole
/// levels. Some solids are inverted, and some triangles turned. How many are not zero.
template <typename LevelType>
int ExpectUniformNormals(const NormalLevels<LevelType>& mesh, unsigned int seed)
{
  constexpr double tolerance = 1e-11; // of unit vectors; some sectors by chance are nearly flat
  std::mt19937 random(seed);
  const auto& control = mesh.Levels[0].Complex;
  Buffer<unsigned char> turned(control.NumberOfTriangleCells);
  std::generate(turned.begin(), turned.end(), [&random]() { return random() % 2; });
  std::vector<vtkIdType> inverted;
  for (vtkIdType tet = 0; tet < control.NumberOfTets; tet += 1 + random() % 4)
  {
    inverted.push_back(2 * tet);
  }
  const Asked asked = Ask(mesh.Levels, [](int, int) { return true; });
  const ControlSolids solids;
  const LocalLimit<int> limit(mesh.Levels[0], mesh.Creases[0], asked.Ends, &solids);
  std::vector<double> normals(3 * asked.Uniform.size(), 7.);
  limit.ComputeNormals(mesh.Points[0].data(), inverted, turned, normals.data());
  int found = 0;
  for (int l = 0, first = 0; l < static_cast<int>(mesh.Levels.size()); ++l)
  {
    const auto tangents = BuildLimitTangents(mesh.Levels[l], mesh.Creases[l], { {}, l });
    std::vector<double> expected(mesh.Points[l].size());
    ComputeLimitNormals(tangents, mesh.Points[l].data(), inverted, turned, expected.data());
    for (const int size = mesh.Levels[l].Complex.NumberOfVertices; first < size; ++first)
    {
      for (int c = 0; c < 3; ++c)
      {
        const double own = normals[3 * first + c];
        found += own != 0. ? 1 : 0;
        EXPECT_EQ(asked.Uniform[first], first);
        EXPECT_NEAR(own, expected[3 * first + c], tolerance) << "level " << l << " " << first;
      }
    }
  }
  return found;
}

template <typename LevelType>
void ExpectUniformNormalsOfTheZoo()
{
  int found = 0;
  std::size_t option = 0;
  for (const Mesh& mesh : MakeZooAndRandom())
  {
    for (int k = 0; k < 4; ++k) // of the options, in turn
    {
      const std::string options = OptionNames[option++ % std::size(OptionNames)];
      SCOPED_TRACE(mesh.Name + " " + options);
      NormalLevels<LevelType> levels;
      const int steps = mesh.Cells.GetNumberOfSimplices() > 30 ? 1 : 2;
      levels.Levels = MakeLevels<LevelType>(mesh, options, steps);
      levels.Creases.resize(levels.Levels.size());
      levels.Points = { MakeValues(3 * levels.Levels[0].Complex.NumberOfVertices, 3) };
      for (int l = 0; l < steps; ++l)
      {
        levels.Points.push_back(ApplyTo(CopyStencils(levels.Levels[l]), levels.Points.back(), 3));
      }
      found += ExpectUniformNormals(levels, 5);
      if (testing::Test::HasFailure())
      {
        return;
      }
    }
  }
  EXPECT_GT(found, 10000);
}

/// Twelve steps of nothing but the cells at a vertex: its value comes to its limit, and what the
/// rows of the last level say of it is what those of the first said. `most`: vertices at the end.
template <typename LevelType>
void ExpectLimitsAfterTwelveSteps(int most, double shrinks)
{
  std::mt19937 random(8);
  for (const Mesh& mesh : MakeZooAndRandom())
  {
    for (const char* options : OptionNames)
    {
      SCOPED_TRACE(mesh.Name + " " + options);
      LevelType level = MakeLevel<LevelType>(mesh, options);
      if (level.Complex.NumberOfVertices == 0)
      {
        continue;
      }
      int vertex = static_cast<int>(random() % level.Complex.NumberOfVertices);
      std::vector<double> values = MakeValues(level.Complex.NumberOfVertices, 3);
      const double limit = ApplyTo(BuildLimitRows(level), values, 1)[vertex];
      for (int step = 0; step < 12; ++step)
      {
        Buffer<unsigned char> at(level.Complex.NumberOfVertices, 0);
        at[vertex] = 1;
        const Restriction<LevelType> restriction(level, at);
        const LevelType part = restriction.Restrict();
        std::vector<double> kept;
        for (int old : restriction.GetOldVertices())
        {
          kept.push_back(values[old]);
        }
        vertex = restriction.GetNewVertices()[vertex];
        values = ApplyTo(CopyStencils(part), kept, 1);
        level = Refine(part, Depth::ForRefinement);
      }
      EXPECT_LT(level.Complex.NumberOfVertices, most);
      EXPECT_NEAR(values[vertex], limit, 2. * std::pow(shrinks, 12));
      EXPECT_NEAR(ApplyTo(BuildLimitRows(level), values, 1)[vertex], limit, 1e-13);
    }
  }
}

}

TEST(LocalLimit, EqualsTheUniformRefinementOnTheWholeZoo)
{
  ExpectUniformLimitsOfTheZoo<Level<int>>();
}

TEST(LocalLimit, EqualsTheUniformRefinementOfTheTetOctScheme)
{
  ExpectUniformLimitsOfTheZoo<TetOctLevel<int>>();
}

TEST(LocalLimit, NormalsEqualThoseOfTheUniformRefinement)
{
  ExpectUniformNormalsOfTheZoo<Level<int>>();
}

TEST(LocalLimit, NormalsEqualThoseOfTheTetOctScheme)
{
  ExpectUniformNormalsOfTheZoo<TetOctLevel<int>>();
}

TEST(LocalLimit, NormalsAtSemiSharpCreases)
{
  unsigned int seed = 0;
  for (const Mesh& mesh : MakeZooAndRandom())
  {
    ++seed;
    const char* options = OptionNames[seed % std::size(OptionNames)];
    SCOPED_TRACE(mesh.Name + " " + options);
    const SemiSharpMesh semi(mesh, options, seed);
    NormalLevels<Level<int>> levels;
    levels.Points = { MakeValues(3 * mesh.Cells.NumberOfPoints, 3) };
    const int steps = mesh.Cells.GetNumberOfSimplices() > 30 ? 1 : 2;
    for (int l = 0; l <= steps; ++l)
    {
      levels.Levels.push_back(semi.MakeSmoothLevel(l));
      levels.Creases.push_back(semi.MakeStages(l));
      levels.Points.push_back(ApplyTo(semi.MakeStencils(l), levels.Points.back(), 3));
    }
    ExpectUniformNormals(levels, seed);
    if (testing::Test::HasFailure())
    {
      return;
    }
  }
}

/// Red-green refinement with every cell marked, level by level, is the uniform refinement.
TEST(LocalLimit, RedGreenRefinementOfEverything)
{
  for (const Mesh& mesh : MakeZooAndRandom())
  {
    SCOPED_TRACE(mesh.Name);
    RedGreen<int> state{ SimplexView(mesh.Cells) };
    for (vtkIdType cell = 0; cell < mesh.Cells.GetNumberOfSimplices(); ++cell)
    {
      state.MarkCell({ static_cast<int>(cell), -1 });
    }
    state.Close();
    for (const auto& cell : state.GetChangedCells())
    {
      state.MarkCell(cell.Leaf);
    }
    state.Close();
    std::vector<std::array<int, 2>> ends;
    for (int v = state.GetNumberOfInputVertices(); v < state.GetNumberOfVertices(); ++v)
    {
      ends.push_back(state.GetEnds(v));
    }
    const RedGreenOutput<int> output(state);
    WrittenCells written(output.GetCounts());
    RedGreenStorage<long long> storage;
    storage.Cells = written.GetStorage();
    output.Write(storage);
    const auto control = Build<int>(mesh.Cells, mesh.Singular);
    const auto once = RefineOnce(control);
    const auto twice = RefineOnce(once);
    const SimplexList cells = ReadCells(twice);
    ASSERT_EQ(written.ToList(0).Dimensions, cells.Dimensions);
    const std::vector<double> values = MakeValues(mesh.Cells.NumberOfPoints, 4);
    const auto uniform = ApplyTo(BuildLimitRows(twice.Level),
      ApplyTo(CopyStencils(once.Level), ApplyTo(CopyStencils(control.Level), values, 1), 1), 1);
    const LocalLimit<int> local(control.Level, {}, ends);
    std::vector<double> limits(local.GetNumberOfRows());
    local.Apply(values.data(), limits.data(), 1);
    for (std::size_t k = 0; k < cells.Connectivity.size(); ++k)
    {
      ASSERT_NEAR(limits[written.Connectivity[k]], uniform[cells.Connectivity[k]], 1e-13);
    }
  }
}

TEST(LocalLimit, SemiSharpCreases)
{
  std::mt19937 random(6);
  unsigned int seed = 0;
  for (const Mesh& mesh : MakeZooAndRandom())
  {
    SCOPED_TRACE(mesh.Name);
    ++seed;
    const SemiSharpMesh semi(mesh, OptionNames[seed % std::size(OptionNames)], seed);
    std::vector<Level<int>> levels;
    const std::vector<double> values = MakeValues(2 * mesh.Cells.NumberOfPoints, 3);
    std::vector<double> uniform = values;
    for (int l = 0; l <= 2; ++l)
    {
      levels.push_back(semi.MakeSmoothLevel(l));
      uniform = l < 2 ? ApplyTo(semi.MakeStencils(l), uniform, 2) : uniform;
    }
    uniform = ApplyTo(BuildLimitRows(levels[2], semi.MakeStages(2)), uniform, 2);
    const Asked asked = Ask(levels, [&](int, int) { return random() % 3 > 0; });
    const SemiSharpStages<int> creases = semi.MakeStages(0);
    ExpectUniformLimits(asked, LocalLimit<int>(levels[0], creases, asked.Ends), values, uniform);
    ExpectUniformLimits(
      asked, LimitByLevels<Level<int>>(levels[0], creases, asked.Ends), values, uniform);
  }
}

/// Creases meet in the middle of a disk, some sharp for one step. The limit at the middle of an
/// edge opposite reads edges that end where they meet, whose rows depend on all of the creases; by
/// levels too small a part must be found out.
TEST(LocalLimit, SectorsAtSemiSharpCreasesBeyondThePart)
{
  struct Case
  {
    std::vector<int> Lasting; ///< far ends of creases
    std::vector<int> All;     ///< with those that are sharp for one step
    double Angle;
  };
  // A concave corner; a curve; a curve that is a corner without an angle for a step.
  const Case cases[] = { { {}, { 1, 2, 3 }, 4. }, { {}, { 1, 2 }, -1. },
    { { 1, 2 }, { 1, 2, 3 }, -1. } };
  constexpr int around = 8;
  Mesh mesh("Disk");
  const int points = 2 * around + 1;
  mesh.Cells.NumberOfPoints = points;
  for (int i = 1; i <= around; ++i)
  {
    const int next = i % around + 1;
    mesh.AddCells({ { 0, i, next }, { i, i + around, next }, { next, i + around, next + around } });
  }
  for (const Case& one : cases)
  {
    SCOPED_TRACE(&one - cases);
    StrataOptions options;
    options.ModifiedBoundary = true;
    options.CornerAngles = Buffer<double>(points, one.Angle);
    const auto build = [&](const std::vector<int>& ends)
    {
      Mesh creased;
      for (const int end : ends)
      {
        creased.Singular.insert({ 0, end });
      }
      return std::move(Build<int>(mesh.Cells, creased.Singular, options).Level);
    };
    Level<int> smooth = build(one.Lasting);
    SemiSharpStages<int> creases;
    creases.Sharpness = Buffer<double>(smooth.Complex.NumberOfEdges, 0.);
    for (const int end : one.All)
    {
      const bool lasts = std::count(one.Lasting.begin(), one.Lasting.end(), end) > 0;
      creases.Sharpness[FindEdge(smooth.Complex, 0, end)] = lasts ? 0. : 1.;
    }
    creases.Stages.push_back({ 1, std::move(build(one.All).Strata) });
    const std::vector<double> values = MakeValues(points, 3);
    const auto limits = ApplyTo(LocalLimit<int>(smooth, creases, { { 5, 6 } }), values, 1);
    const auto byLevels =
      ApplyTo(BuildRows(LimitByLevels<Level<int>>(smooth, creases, { { 5, 6 } }, 0)), values, 1);
    const int middle = points + FindEdge(smooth.Complex, 5, 6);
    const Level<int> next = Refine(smooth, Depth::ForRefinement);
    const auto rows = creases.ListParts(smooth.Complex).GetRows();
    Level<int> sharp = build(one.All);
    Stencils<int> stencils = TakeStencils(smooth);
    BlendSemiSharp(rows, TakeStencils(sharp), stencils);
    const auto uniform = ApplyTo(BuildLimitRows(next), ApplyTo(stencils, values, 1), 1);
    EXPECT_NEAR(limits.back(), uniform[middle], 1e-13);
    EXPECT_NEAR(byLevels.back(), uniform[middle], 1e-13);
  }
}

/// Creases that are sharp for ever are sharp.
TEST(LocalLimit, InfinitelySharpCreases)
{
  const Mesh mesh = FindInZoo("Icosahedron");
  SemiSharpMesh semi(mesh, "Blend", 1);
  const Level<int> smooth = semi.MakeSmoothLevel(0);
  SemiSharpStages<int> creases;
  creases.Sharpness = Buffer<double>(smooth.Complex.NumberOfEdges, 0.);
  std::fill(semi.Sharpness.Edges.begin(), semi.Sharpness.Edges.end(), 0.);
  semi.Sharpness.Faces.clear();
  for (int e = 0; e < smooth.Complex.NumberOfEdges; e += 3)
  {
    creases.Sharpness[e] = semi.Sharpness.Edges[e] = std::numeric_limits<double>::infinity();
  }
  creases.Stages.push_back({ SharpForever, semi.MakeLevel(0, 0.).Strata });
  const Level<int> sharp = semi.MakeLevel(0, 0.);
  std::vector<std::array<int, 2>> ends;
  for (int e = 0; e < smooth.Complex.NumberOfEdges; ++e)
  {
    const int vertex = smooth.Complex.NumberOfVertices + 2 * e;
    ends.push_back({ smooth.Complex.EdgeVertices[2 * e], smooth.Complex.EdgeVertices[2 * e + 1] });
    ends.push_back({ smooth.Complex.EdgeVertices[2 * e], vertex });
  }
  const LocalLimit<int> local(smooth, creases, ends);
  const LocalLimit<int> flagged(sharp, {}, ends);
  const std::vector<double> values = MakeValues(smooth.Complex.NumberOfVertices, 2);
  std::vector<double> a(local.GetNumberOfRows());
  std::vector<double> b(a.size());
  local.Apply(values.data(), a.data(), 1);
  flagged.Apply(values.data(), b.data(), 1);
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    EXPECT_NEAR(a[i], b[i], 1e-13) << i;
  }
}

TEST(LocalLimit, TwelveLevelsAroundAVertex)
{
  ExpectLimitsAfterTwelveSteps<Level<int>>(600, 0.75);
}

TEST(LocalLimit, TwelveTetOctLevelsAroundAVertex)
{
  ExpectLimitsAfterTwelveSteps<TetOctLevel<int>>(1000, 5. / 6.);
}

TEST(LocalLimit, CostsWhatIsAskedFor)
{
  const Lattice lattice = MakeLattice("Lattice", 8, 1., 4);
  const auto control = Build<int>(lattice.Control.Cells);
  const auto& complex = control.Level.Complex;
  // Straight down to one vertex in the middle.
  const auto middle =
    std::find(lattice.Positions.begin(), lattice.Positions.end(), std::array<int, 3>{ 4, 4, 4 });
  const int near = static_cast<int>(middle - lattice.Positions.begin());
  int edge = 0;
  while (complex.EdgeVertices[2 * edge] != near && complex.EdgeVertices[2 * edge + 1] != near)
  {
    ++edge;
  }
  std::vector<std::array<int, 2>> ends;
  int far = complex.GetOtherEnd(edge, near);
  for (int i = 0; i < 10; ++i)
  {
    ends.push_back({ near, far });
    far = complex.NumberOfVertices + i;
  }
  const LocalLimit<int> local(control.Level, {}, ends);
  EXPECT_LT(CountSupportValues(local), complex.NumberOfVertices + 10 * 200);
}

/// A vertex does not move its limit when it is taken on later levels.
TEST(LocalLimit, AVertexOnLaterLevels)
{
  for (const char* name : { "OpenPolyline", "ClosedFan", "Valence4", "EverythingAtOnce" })
  {
    const auto control = Build<int>(FindInZoo(name).Cells);
    const int vertices = control.Level.Complex.NumberOfVertices;
    std::vector<std::array<int, 2>> ends;
    for (int i = 0; i < 3 * vertices;
      ++i) // each vertex on the next level, then on the one after it
    {
      ends.push_back({ i, i });
    }
    const LocalLimit<int> limit(control.Level, {}, ends);
    EXPECT_EQ(limit.GetNumberOfLevels(), 4);
    const std::vector<double> limits =
      ApplyTo(limit, MakeValues(control.Level.Complex.NumberOfVertices, 2), 1);
    for (int i = vertices; i < 4 * vertices; ++i)
    {
      EXPECT_NEAR(limits[i], limits[i % vertices], 1e-14) << name << " " << i;
    }
  }
}
