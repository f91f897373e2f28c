// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestRedGreen.cxx
 * Patterns, the closure as a closure, starting again from leaves, threads, files from elsewhere.
 */
#include "CoreZoo.h"
#include "FileTools.h"
#include "RedGreenChecks.h"

#include "Core/Solids/RedGreen/RedGreenTables.h"
#include "Private/Reading/CellsToSimplices.h"

using namespace file_tools;
using namespace redgreen_reference;

namespace
{

/// Leaves of the input, all levels 0, chosen by a seed.
std::vector<vtkIdType> Choose(vtkIdType size, int count, unsigned int seed)
{
  std::mt19937 random(seed);
  std::vector<vtkIdType> chosen;
  for (int i = 0; i < count && size > 0; ++i)
  {
    chosen.push_back(static_cast<vtkIdType>(random()) % size);
  }
  return chosen;
}

/// Marks leaves of all levels: in each round one in so many of the changed cells.
template <typename Id>
void RefineByChance(RedGreen<Id>& state, int rounds, unsigned int seed, unsigned int oneIn = 20)
{
  std::mt19937 random(seed);
  for (vtkIdType cell : Choose(state.GetNumberOfInputCells(), 3, seed))
  {
    state.MarkCell({ static_cast<Id>(cell), -1 });
  }
  state.Close();
  for (int round = 1; round < rounds; ++round)
  {
    for (const auto& cell : state.GetChangedCells())
    {
      if (random() % oneIn == 0)
      {
        state.MarkCell(cell.Leaf);
      }
    }
    state.Close();
  }
}

/// Leaves as sets of points, whatever input cell they come from.
template <typename Id>
std::multiset<std::pair<int, Cell>> GetShapes(const Written<Id>& written)
{
  std::multiset<std::pair<int, Cell>> shapes;
  for (const NaiveLeaf& leaf : written.GetLeaves())
  {
    shapes.insert({ leaf.Level, leaf.Points });
  }
  return shapes;
}

/// The mesh with its green cells replaced by their leaves, as another run takes it.
struct LeafMesh
{
  SimplexList Cells;
  std::vector<unsigned char> Levels;
  std::vector<std::array<vtkIdType, 3>> Midpoints; ///< two ends and the midpoint
  SimplexView GetView() const
  {
    SimplexView view(this->Cells);
    view.Levels = this->Levels.data();
    return view;
  }
};

template <typename Id>
LeafMesh UndoGreen(const Written<Id>& written)
{
  LeafMesh mesh;
  mesh.Cells.NumberOfPoints = static_cast<vtkIdType>(written.Keys.size());
  const auto cells = GetCells(written.Cells);
  vtkIdType last = -1;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    Tuple cell = cells[i];
    const vtkIdType green = written.GreenParents[i];
    if (green >= 0)
    {
      if (green == last)
      {
        continue;
      }
      last = green;
      const auto& leaf = written.GreenLeaves[green];
      cell.assign(leaf.Vertices.begin(), leaf.Vertices.begin() + leaf.Dimension + 1);
      for (int k = 0; k < 6; ++k)
      {
        if (leaf.Midpoints[k] >= 0)
        {
          const auto& ends =
            leaf.Dimension == 3 ? tetrahedron::EdgeVertices[k] : triangle::EdgeVertices[k];
          mesh.Midpoints.push_back(
            { { leaf.Vertices[ends[0]], leaf.Vertices[ends[1]], leaf.Midpoints[k] } });
        }
      }
    }
    mesh.Cells.Dimensions.push_back(static_cast<unsigned char>(cell.size() - 1));
    mesh.Cells.Connectivity.insert(mesh.Cells.Connectivity.end(), cell.begin(), cell.end());
    mesh.Levels.push_back(written.Levels[i]);
  }
  return mesh;
}

/// The same mesh with the numbers of vertices turned round: midpoints come first.
LeafMesh TurnNumbers(LeafMesh mesh)
{
  const vtkIdType last = mesh.Cells.NumberOfPoints - 1;
  for (vtkIdType& vertex : mesh.Cells.Connectivity)
  {
    vertex = last - vertex;
  }
  for (auto& midpoint : mesh.Midpoints)
  {
    for (vtkIdType& vertex : midpoint)
    {
      vertex = last - vertex;
    }
  }
  return mesh;
}

template <typename Id>
void AddMidpoints(RedGreen<Id>& state, const LeafMesh& mesh)
{
  for (const auto& m : mesh.Midpoints)
  {
    state.AddMidpoint(static_cast<Id>(m[0]), static_cast<Id>(m[1]), static_cast<Id>(m[2]));
  }
}

std::vector<std::string> GetNames()
{
  std::vector<std::string> names = { "KuhnLattice", "EverythingAtOnce", "CrowdOfTets",
    "FinInRegularEdge", "RepeatedTets", "FollowerLines", "ThreeSheets" };
  for (unsigned int seed = 1; seed <= 12; ++seed)
  {
    names.push_back("Random" + std::to_string(seed));
  }
  return names;
}

class RedGreenOfMesh : public testing::TestWithParam<std::string>
{
};

}

TEST(RedGreenPatterns, CloseAsCounted)
{
  std::map<int, int> closed; // how many patterns of a tetrahedron end in so many split edges
  std::map<RefinementKind, std::set<int>> parts;
  for (unsigned int pattern = 0; pattern < 64; ++pattern)
  {
    const auto& entry = redgreen::PartsOf[3][pattern];
    ASSERT_EQ(entry.Closed & pattern, pattern);
    ASSERT_EQ(redgreen::PartsOf[3][entry.Closed].Closed, entry.Closed);
    ++closed[redgreen::CountBits(entry.Closed)];
    parts[entry.Kind].insert(entry.Count);
  }
  EXPECT_EQ(closed, (std::map<int, int>{ { 0, 1 }, { 1, 6 }, { 2, 3 }, { 3, 16 }, { 6, 38 } }));
  EXPECT_EQ(parts[RefinementKind::Untouched], std::set<int>{ 1 });
  EXPECT_EQ(parts[RefinementKind::Red], std::set<int>{ 8 });
  EXPECT_EQ(parts[RefinementKind::GreenI], std::set<int>{ 2 });
  EXPECT_EQ(parts[RefinementKind::GreenII], std::set<int>{ 4 });
  EXPECT_EQ(parts[RefinementKind::GreenIII], std::set<int>{ 4 });
}

TEST(RedGreen, WithoutMarksIsTheInput)
{
  for (const Mesh& mesh : MakeZoo())
  {
    RedGreen<int> state{ SimplexView(mesh.Cells) };
    EXPECT_FALSE(state.Close());
    const auto written = Write(state, mesh.Points);
    EXPECT_EQ(written.Cells.Connectivity, mesh.Cells.Connectivity) << mesh.Name;
    EXPECT_EQ(written.Cells.Dimensions, mesh.Cells.Dimensions);
    EXPECT_EQ(written.Points, mesh.Points);
  }
}

/// All cells marked in each round: the uniform refinement.
TEST(RedGreen, EverythingMarkedIsUniform)
{
  for (const char* name : { "KuhnCube", "FlushFin", "EverythingAtOnce", "OctahedronMixedMarks" })
  {
    const Mesh mesh = FindInZoo(name);
    RedGreen<int> state{ SimplexView(mesh.Cells) };
    for (int cell = 0; cell < static_cast<int>(mesh.Cells.GetNumberOfSimplices()); ++cell)
    {
      state.MarkCell({ cell, -1 });
    }
    EXPECT_TRUE(state.Close());
    for (const auto& cell : state.GetChangedCells())
    {
      state.MarkCell(cell.Leaf);
    }
    EXPECT_TRUE(state.Close());
    const auto written = Write(state, mesh.Points);
    EXPECT_TRUE(written.GreenLeaves.empty());
    auto uniform = Build<int>(mesh.Cells);
    uniform = RefineOnce(RefineOnce(uniform));
    EXPECT_EQ(written.Cells.Dimensions, ReadCells(uniform).Dimensions);
    EXPECT_EQ(
      state.GetNumberOfVertices(), uniform.Level.Complex.NumberOfVertices); // no point twice
  }
}

/// The order of marks and their distribution over rounds do not matter.
TEST_P(RedGreenOfMesh, IsAClosure)
{
  const Mesh mesh = FindInZoo(GetParam());
  const auto marks = Choose(mesh.Cells.GetNumberOfSimplices(), 8, 7);
  RedGreen<int> together{ SimplexView(mesh.Cells) };
  RedGreen<int> single{ SimplexView(mesh.Cells) };
  for (vtkIdType cell : marks)
  {
    together.MarkCell({ static_cast<int>(cell), -1 });
  }
  together.Close();
  for (auto cell = marks.rbegin(); cell != marks.rend(); ++cell)
  {
    single.MarkCell({ static_cast<int>(*cell), -1 });
    single.Close(); // more rounds than scans
  }
  EXPECT_FALSE(single.Close());
  EXPECT_EQ(Write(together, mesh.Points).GetLeaves(), Write(single, mesh.Points).GetLeaves());
}

TEST_P(RedGreenOfMesh, StartsAgainFromLeaves)
{
  const Mesh mesh = FindInZoo(GetParam());
  RedGreen<int> first{ SimplexView(mesh.Cells) };
  RefineByChance(first, 3, 11);
  const auto written = Write(first, mesh.Points);
  const LeafMesh leaves = UndoGreen(written);
  {
    RedGreen<int> again(leaves.GetView());
    AddMidpoints(again, leaves);
    again.Close();
    const auto same = Write(again, written.Points, &written.Keys);
    ASSERT_EQ(same.Cells.Connectivity, written.Cells.Connectivity);
    ASSERT_EQ(same.Levels, written.Levels);
    ASSERT_EQ(same.Kinds, written.Kinds);
    ASSERT_EQ(same.GreenParents, written.GreenParents);
    ASSERT_EQ(same.Points, written.Points);
  }
  // Marks, green edges among them, in the run that goes on and in one that starts from the leaves.
  std::map<std::pair<int, Cell>, RedGreenLeaf<int>> handles;
  for (int cell = 0; cell < static_cast<int>(mesh.Cells.GetNumberOfSimplices()); ++cell)
  {
    const NaiveLeaf leaf = ToNaive(first, { cell, -1 }, written.Keys);
    handles[{ leaf.Level, leaf.Points }] = { cell, -1 };
  }
  RedGreen<int> replay{ SimplexView(mesh.Cells) };
  std::mt19937 random(11);
  for (vtkIdType cell : Choose(mesh.Cells.GetNumberOfSimplices(), 3, 11))
  {
    replay.MarkCell({ static_cast<int>(cell), -1 });
  }
  for (int round = 0; round < 3; ++round)
  {
    replay.Close();
    const auto keys = MakeKeys(replay);
    for (const auto& cell : replay.GetChangedCells())
    {
      const NaiveLeaf leaf = ToNaive(replay, cell.Leaf, keys);
      handles[{ leaf.Level, leaf.Points }] = cell.Leaf;
      if (round < 2 && random() % 20 == 0)
      {
        replay.MarkCell(cell.Leaf);
      }
    }
  }
  ASSERT_EQ(GetShapes(Write(replay, mesh.Points)), GetShapes(written));
  RedGreen<int> second(leaves.GetView());
  AddMidpoints(second, leaves);
  const auto own = GetCells(written.Cells);
  std::vector<int> places; // of leaves in the list that the second run has
  for (std::size_t i = 0; i < own.size(); ++i)
  {
    const bool next = i == 0 || written.GreenParents[i] < 0 ||
      written.GreenParents[i] != written.GreenParents[i - 1];
    places.push_back((places.empty() ? -1 : places.back()) + (next ? 1 : 0));
  }
  for (int i = 0; i < 6; ++i)
  {
    const std::size_t chosen = random() % own.size();
    const NaiveLeaf leaf = [&]()
    {
      const auto cell = second.GetCell(RedGreenLeaf<int>{ places[chosen], -1 });
      NaiveLeaf named{ 0, cell.Level, {} };
      for (int v = 0; v <= cell.Dimension; ++v)
      {
        named.Points.push_back(written.Keys[cell.Vertices[v]]);
      }
      return named;
    }();
    const auto handle = handles.at({ leaf.Level, leaf.Points });
    for (std::size_t a = 1; a < own[chosen].size(); ++a)
    {
      // The numbers of vertices are those of `first`, which made them in the same order.
      const int end0 = static_cast<int>(own[chosen][0]);
      const int end1 = static_cast<int>(own[chosen][a]);
      replay.MarkEdge(handle, end0, end1);
      second.MarkEdge({ places[chosen], -1 }, end0, end1);
    }
  }
  replay.Close();
  second.Close();
  const auto expected = Write(replay, mesh.Points);
  const auto result = Write(second, written.Points, &written.Keys);
  EXPECT_EQ(GetShapes(result), GetShapes(expected));
  EXPECT_EQ(result.Keys.size(), expected.Keys.size());
}

/// Midpoints of the input may have any numbers, 0 too.
TEST_P(RedGreenOfMesh, StartsAgainWithMidpointsInFront)
{
  const Mesh mesh = FindInZoo(GetParam());
  RedGreen<int> first{ SimplexView(mesh.Cells) };
  RefineByChance(first, 3, 11);
  const auto written = Write(first, mesh.Points);
  const LeafMesh leaves = UndoGreen(written);
  const LeafMesh turned = TurnNumbers(leaves);
  const std::vector<Key> turnedKeys(written.Keys.rbegin(), written.Keys.rend());
  const std::vector<double> points(3 * turnedKeys.size()); // are not looked at
  RedGreen<int> second(leaves.GetView());
  RedGreen<int> third(turned.GetView());
  AddMidpoints(second, leaves);
  AddMidpoints(third, turned);
  std::mt19937 random(5);
  const int last = static_cast<int>(leaves.Cells.NumberOfPoints) - 1;
  const std::vector<Tuple> cells = GetCells(leaves.Cells);
  for (int round = 0; round < 3 && !cells.empty(); ++round)
  {
    const std::size_t chosen = random() % cells.size();
    const RedGreenLeaf<int> leaf{ static_cast<int>(chosen), -1 };
    if (round == 2)
    {
      second.MarkCell(leaf);
      third.MarkCell(leaf);
    }
    else if (round == 1 && cells[chosen].size() > 1)
    {
      const int a = static_cast<int>(cells[chosen].front());
      const int b = static_cast<int>(cells[chosen].back());
      second.MarkEdge(leaf, a, b);
      third.MarkEdge(leaf, last - a, last - b);
    }
    EXPECT_EQ(third.Close(), second.Close());
    const auto expected = Write(second, points, &written.Keys);
    const auto result = Write(third, points, &turnedKeys);
    ASSERT_EQ(GetShapes(result), GetShapes(expected));
    ASSERT_EQ(result.Keys.size(), expected.Keys.size());
    ASSERT_EQ(third.GetNumberOfCells(), second.GetNumberOfCells());
    for (int cell = 0; cell < static_cast<int>(cells.size()); ++cell)
    {
      ASSERT_EQ(third.IsRed(cell), second.IsRed(cell));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, RedGreenOfMesh, testing::ValuesIn(GetNames()),
  [](const auto& instance) { return instance.param; });

/// Large enough for threads, and for more than one block of the scans.
TEST(RedGreen, SameBitsForAnyNumberOfThreads)
{
  const Mesh mesh = MakeLattice("Lattice", 15, 1., 9).Control;
  std::vector<Written<int>> results;
  for (int threads : { 1, 4 })
  {
    vtkSMPTools::Initialize(threads);
    RedGreen<int> state{ SimplexView(mesh.Cells) };
    RefineByChance(state, 7, 5);
    results.push_back(Write(state, mesh.Points));
    EXPECT_EQ(state.GetNumberOfCells(), results.back().Cells.GetNumberOfSimplices());
  }
  vtkSMPTools::Initialize(0);
  EXPECT_GT(results[0].GreenLeaves.size(), 100u);
  EXPECT_EQ(results[0].Cells.Connectivity, results[1].Cells.Connectivity);
  EXPECT_EQ(results[0].Types, results[1].Types);
  EXPECT_EQ(results[0].Levels, results[1].Levels);
  EXPECT_EQ(results[0].Kinds, results[1].Kinds);
  EXPECT_EQ(results[0].GreenParents, results[1].GreenParents);
  EXPECT_EQ(results[0].InputCells, results[1].InputCells);
  EXPECT_EQ(results[0].Points, results[1].Points);
  CheckArrays(mesh.Cells, results[0]);
  CheckConforming(mesh.Cells, results[0]);
}

/// The diagonal is chosen when it is needed, and nothing else is touched.
TEST(RedGreen, OrdersTetrahedraWhenTheyAreNeeded)
{
  const Mesh mesh = MakeLattice("Lattice", 2, 1., 4).Control;
  int calls = 0;
  RedGreen<int> state(SimplexView(mesh.Cells),
    [&calls](vtkIdType* tet)
    {
      ++calls;
      std::rotate(tet + 1, tet + 2, tet + 4);
    });
  state.MarkCell({ 5, -1 });
  state.Close();
  const Tuple own = GetCells(mesh.Cells)[5];
  const auto cell = state.GetCell(5);
  EXPECT_EQ(cell.Vertices,
    (std::array<int, 4>{ { static_cast<int>(own[0]), static_cast<int>(own[2]),
      static_cast<int>(own[3]), static_cast<int>(own[1]) } }));
  EXPECT_LT(calls, 48);
  CheckConforming(mesh.Cells, Write(state, mesh.Points));
}

/// Round for round the same few cells, however large the mesh is and however many rounds there
/// were.
TEST(RedGreen, WorkIsThatOfTheCellsThatChange)
{
  std::vector<std::size_t> changes;
  for (int n : { 4, 16 })
  {
    const Mesh mesh = MakeLattice("Lattice", n, 1., 3).Control;
    const auto corner =
      std::min_element(mesh.Points.begin(), mesh.Points.end()); // of its x at least
    const auto vertex = static_cast<int>((corner - mesh.Points.begin()) / 3);
    RedGreen<int> state{ SimplexView(mesh.Cells) };
    const std::size_t before = state.GetMemorySize();
    const auto cells = GetCells(mesh.Cells);
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      if (std::count(cells[i].begin(), cells[i].end(), vertex) > 0)
      {
        state.MarkCell({ static_cast<int>(i), -1 });
      }
    }
    state.Close();
    std::size_t most = 0;
    for (int round = 1; round < 30; ++round)
    {
      const auto changed = state.GetChangedCells();
      most = std::max(most, static_cast<std::size_t>(changed.size()));
      for (const auto& cell : changed)
      {
        if (std::count(cell.Vertices.begin(), cell.Vertices.end(), vertex) > 0)
        {
          state.MarkCell(cell.Leaf);
        }
      }
      state.Close();
    }
    EXPECT_LT(most, 1500u);
    EXPECT_LT(state.GetMemorySize() - before, 30u * 1500u * 300u);
    changes.push_back(most);
  }
  EXPECT_LT(changes[1], 3 * changes[0]);
}

class RedGreenOfFile : public testing::TestWithParam<const char*>
{
};

TEST_P(RedGreenOfFile, IsConforming)
{
  const std::string path = GetSharedFile(GetParam());
  if (const std::string reason = WhyNotRead(path); !reason.empty())
  {
    GTEST_SKIP() << reason;
  }
  const auto grid = ReadGrid(path);
  auto simplices = CellsToSimplices(grid, nullptr);
  std::vector<double> points(3 * static_cast<std::size_t>(simplices.Simplices.NumberOfPoints));
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    grid->GetPoint(i, points.data() + 3 * i);
  }
  for (vtkIdType c = 0; c < simplices.GetNumberOfCentres(); ++c)
  {
    const vtkIdType first = simplices.CentreOffsets[c];
    const vtkIdType size = simplices.CentreOffsets[c + 1] - first;
    for (vtkIdType i = 0; i < 3 * size; ++i)
    {
      points[3 * (grid->GetNumberOfPoints() + c) + i % 3] +=
        points[3 * simplices.CentreMembers[first + i / 3] + i % 3] / static_cast<double>(size);
    }
  }
  double extent = 0.; // lengths in units of the mesh, for the tolerances
  for (double x : points)
  {
    extent = std::max(extent, std::abs(x));
  }
  for (double& x : points)
  {
    x /= extent > 0. ? extent : 1.;
  }
  OrderTets(simplices.Simplices, points.data(), nullptr, 0);
  RedGreen<int> state{ SimplexView(simplices.Simplices) };
  RefineByChance(state, 6, 3, 35);
  const auto written = Write(state, points);
  EXPECT_GT(written.Cells.GetNumberOfSimplices(), simplices.Simplices.GetNumberOfSimplices());
  CheckArrays(simplices.Simplices, written);
  CheckConforming(simplices.Simplices, written);
  CheckShape(simplices.Simplices, points, written);
}

INSTANTIATE_TEST_SUITE_P(Shared, RedGreenOfFile,
  testing::Values("hex_geos_box_hybrid.vtu", "hex_gmsh_quadtri_torus_4types.vtu",
    "hex_mfem_tinyzoo.vtu", "line_navis_neuron.vtu", "mix_elmer_shell_on_solid.vtu",
    "mix_elmer_wire_pair.vtu", "mix_geos_cube.vtu", "mix_ogs5_fracture_network.vtu",
    "mix_porepy_case2_4k.vtu", "nm_ogs5_fracture_surfaces.vtu", "tet_geos_synthetic.vtu",
    "tet_gmsh_coil_crack.vtu"),
  [](const testing::TestParamInfo<const char*>& file)
  {
    const std::string name = file.param;
    return name.substr(0, name.find('.'));
  });
