// SPDX-License-Identifier: BSD-3-Clause
// Adaptive sqrt(3), Mathematics 11: topology, and the limits of vertices.

#include "AdaptiveSurfaceTools.h"

#include "Private/AdaptiveSurface/AdaptiveSurfaceValues.h"
#include "Private/Reading/CellsToSimplices.h"

using namespace surfacetools;

namespace
{

std::map<std::string, Model> MakeAdaptiveZoo()
{
  std::map<std::string, Model> zoo = MakeZoo(true);
  zoo["fan of 3"] = MakeFan(3, false);
  zoo["fan of 40"] = MakeFan(40, false);
  zoo["half fan of 7"] = MakeFan(7, true);
  return zoo;
}

}

TEST(AdaptiveSqrtThree, SplitEverywhereIsTheUniformMesh)
{
  for (const auto& [name, model] : MakeAdaptiveZoo())
  {
    Walk uniform(model, SurfaceSchemeKind::SqrtThree, false);
    for (int level = 0; level <= 5; ++level)
    {
      SCOPED_TRACE(name + ", level " + std::to_string(level));
      Adaptive adaptive(model);
      adaptive.SplitTo(level);
      const Adaptive::Result result = adaptive.Finish();
      ASSERT_EQ(static_cast<vtkIdType>(result.Triangles.size()), uniform.Level.Mesh.NumberOfFaces);
      ASSERT_EQ(static_cast<vtkIdType>(result.Points.size()), uniform.Level.Mesh.NumberOfVertices);
      const std::vector<Point> limit = uniform.GetLimit();
      for (std::size_t i = 0; i < limit.size(); ++i)
      {
        ASSERT_LT(GetDistance(result.Points[i], limit[i]), 1e-12) << "vertex " << i;
      }
      for (std::size_t f = 0; f < result.Triangles.size(); ++f)
      {
        const int* corners = uniform.Level.Mesh.Vertices.data() + 3 * f;
        ASSERT_TRUE(std::equal(corners, corners + 3, result.Triangles[f].begin()));
        ASSERT_EQ(result.Generations[f], 2 * level);
      }
      uniform.Step();
    }
  }
}

namespace
{

/// Follows the same path in both meshes: every triangle of the first is one of the second, which is
/// the uniform hierarchy, or a third of one; their vertices have the same limits.
void CompareBranch(const Adaptive& adaptive, const Adaptive::Result& result, int face,
  const Adaptive& uniform, const Adaptive::Result& all, int same)
{
  auto compare = [&](int vertex, int other)
  { ASSERT_LT(GetDistance(result.Points[vertex], all.Points[other]), 1e-12); };
  for (int i = 0; i < 3; ++i)
  {
    compare(adaptive.Mesh.GetVertices(face)[i], uniform.Mesh.GetVertices(same)[i]);
  }
  for (int i = 0; i < 3 && adaptive.Mesh.IsSplit(face); ++i)
  {
    ASSERT_TRUE(uniform.Mesh.IsSplit(same));
    compare(adaptive.Mesh.GetApex(3 * face + i), uniform.Mesh.GetApex(3 * same + i));
    const int child = adaptive.Mesh.GetChild(3 * face + i);
    if (adaptive.Mesh.IsThere(child))
    {
      CompareBranch(adaptive, result, child, uniform, all, uniform.Mesh.GetChild(3 * same + i));
    }
  }
}

using Edge = std::pair<int, int>;

std::map<Edge, std::vector<std::size_t>> FindEdges(const Adaptive::Result& result)
{
  std::map<Edge, std::vector<std::size_t>> edges;
  for (std::size_t t = 0; t < result.Triangles.size(); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      const auto ends = std::minmax(result.Triangles[t][i], result.Triangles[t][(i + 1) % 3]);
      edges[{ ends.first, ends.second }].push_back(t);
    }
  }
  return edges;
}

/// Each edge has two triangles, or as many as the fixed edge of the control mesh that it is on;
/// what meets at it is balanced. Around closed fans of two faces there are several edges between
/// the same points.
void CheckConforming(
  const Adaptive& adaptive, const Adaptive::Result& result, bool hasDoubleEdges = false)
{
  std::map<Edge, std::size_t> fixed;
  for (int s = 0; s < adaptive.Mesh.GetNumberOfSegments(); ++s)
  {
    const auto& segment = adaptive.Mesh.GetSegmentAt(s);
    if (segment.Thirds < 0)
    {
      const auto ends = std::minmax(segment.Ends[0], segment.Ends[1]);
      fixed[{ ends.first, ends.second }] = static_cast<std::size_t>(segment.NumberOfSides);
    }
  }
  std::size_t found = 0;
  for (const auto& [edge, triangles] : FindEdges(result))
  {
    const auto at = fixed.find(edge);
    const std::size_t times =
      hasDoubleEdges && triangles.size() % 2 == 0 ? triangles.size() / 2 : 1;
    ASSERT_EQ(triangles.size(), times * (at == fixed.end() ? 2u : at->second))
      << "edge " << edge.first << " " << edge.second;
    found += at == fixed.end() ? 0 : 1;
    for (std::size_t t : triangles)
    {
      const int difference = result.Generations[t] - result.Generations[triangles[0]];
      ASSERT_LE(std::abs(difference), at == fixed.end() && times == 1 ? 1 : 3);
    }
  }
  for (const auto& [edge, sides] : fixed)
  {
    found += sides == 0 ? 1 : 0;
  }
  EXPECT_EQ(found, fixed.size());
}

}

TEST(AdaptiveSqrtThree, RandomSplitsAreAConformingPartOfTheUniformHierarchy)
{
  for (const auto& [name, model] : MakeAdaptiveZoo())
  {
    Adaptive uniform(model);
    uniform.SplitTo(6);
    const Adaptive::Result all = uniform.Finish();
    for (unsigned seed = 0; seed < 12; ++seed)
    {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      Adaptive adaptive(model);
      adaptive.SplitAtRandom(seed, 12, 5);
      const vtkIdType cells = adaptive.Mesh.GetNumberOfCells();
      const Adaptive::Result result = adaptive.Finish();
      ASSERT_GE(cells, static_cast<vtkIdType>(result.Triangles.size()));
      for (int face = 0; face < adaptive.Mesh.GetNumberOfControlFaces(); ++face)
      {
        CompareBranch(adaptive, result, face, uniform, all, face);
      }
      CheckConforming(adaptive, result, name == "pillow");
    }
  }
}

/// Edges of many faces, pinched vertices, equal faces, free lines.
TEST(AdaptiveSqrtThree, RandomFacesAreAPartOfTheUniformHierarchy)
{
  std::mt19937 random(5);
  for (unsigned trial = 0; trial < 25; ++trial)
  {
    SCOPED_TRACE("trial " + std::to_string(trial));
    Model model;
    model.Points = MakeRandomPoints(12, trial);
    model.Lines = { { 0, 1 }, { 3, 9 } };
    for (int i = 0; i < 20; ++i)
    {
      const vtkIdType first = static_cast<vtkIdType>(random() % 12);
      const vtkIdType second = static_cast<vtkIdType>((first + 1 + random() % 11) % 12);
      const vtkIdType third = static_cast<vtkIdType>(random() % 12);
      if (third != first && third != second)
      {
        model.Faces.push_back({ first, second, third });
      }
    }
    Walk uniform(model, SurfaceSchemeKind::SqrtThree, false);
    for (int level = 0; level < 4; ++level)
    {
      uniform.Step();
    }
    Adaptive everywhere(model);
    everywhere.SplitTo(4);
    const Adaptive::Result all = everywhere.Finish();
    const std::vector<Point> limit = uniform.GetLimit();
    ASSERT_EQ(limit.size(), all.Points.size());
    for (std::size_t i = 0; i < limit.size(); ++i)
    {
      ASSERT_LT(GetDistance(all.Points[i], limit[i]), 1e-12) << "vertex " << i;
    }
    Adaptive adaptive(model);
    adaptive.SplitAtRandom(trial, 8, 3);
    const Adaptive::Result result = adaptive.Finish();
    for (int face = 0; face < adaptive.Mesh.GetNumberOfControlFaces(); ++face)
    {
      CompareBranch(adaptive, result, face, everywhere, all, face);
    }
  }
}

namespace
{

/// The limits of an adaptive mesh, as the criteria see them.
class LimitsBetween
{
public:
  LimitsBetween(const Adaptive& adaptive)
    : Mesh(adaptive.Mesh)
    , Rows(Mesh, adaptive.Control.Level, *adaptive.Control.Scheme)
  {
    vtkNew<vtkDoubleArray> points;
    points->SetNumberOfComponents(3);
    for (const Point& point : adaptive.Control.Points)
    {
      points->InsertNextTuple(point.data());
    }
    this->Array.Start(points, SimplicesOfCells(), true);
    this->Values = std::make_unique<AdaptiveSurfaceValues<int>>(Mesh, Rows, Array, true);
    std::vector<int> vertices(static_cast<std::size_t>(Mesh.GetNumberOfVertices()));
    std::iota(vertices.begin(), vertices.end(), 0);
    std::vector<int> faces;
    for (int face = 0; face < Mesh.GetNumberOfFaces(); ++face)
    {
      if (Mesh.IsThere(face))
      {
        faces.push_back(face);
      }
    }
    this->Values->Add(vertices, faces, 0);
  }
  int Find(int corner, std::array<Point, 3>& places)
  {
    return this->Values->FindPlaces(corner, this->Scratch, places[0].data());
  }

private:
  const AdaptiveSqrtThree<int>& Mesh;
  AdaptiveSqrtThreeRows<int> Rows;
  ContinuedArray Array;
  std::unique_ptr<AdaptiveSurfaceValues<int>> Values;
  RowBlock<int> Scratch;
};

/// The centre of the child across an edge that has a certain vertex.
Point GetCentreOfChild(const Adaptive& mesh, const Adaptive::Result& result, int corner, int vertex)
{
  for (const int side : { corner, mesh.Mesh.GetTwin(corner) })
  {
    const int child = mesh.Mesh.GetChild(side);
    const int* corners = mesh.Mesh.GetVertices(child);
    if (std::find(corners, corners + 3, vertex) != corners + 3)
    {
      return result.Points[mesh.Mesh.GetApex(3 * child)];
    }
  }
  ADD_FAILURE() << "no child at corner " << corner;
  return {};
}

/// Follows the same path in both meshes, as CompareBranch, and compares the limits at the thirds of
/// edges. The number of edges where they are known.
int CompareThirds(const Adaptive& adaptive, LimitsBetween& limits, int face,
  const Adaptive& uniform, const Adaptive::Result& all, int same)
{
  int compared = 0;
  for (int i = 0; i < 3; ++i)
  {
    const int corner = 3 * face + i;
    std::array<Point, 3> places;
    if (!adaptive.Mesh.IsFixed(corner) && limits.Find(corner, places) == 3)
    {
      for (int end = 0; end < 2; ++end)
      {
        const int vertex = uniform.Mesh.GetVertices(same)[(i + end) % 3];
        const Point expected = GetCentreOfChild(uniform, all, 3 * same + i, vertex);
        EXPECT_LT(GetDistance(places[static_cast<std::size_t>(1 + end)], expected), 1e-12);
      }
      ++compared;
    }
    const int child = adaptive.Mesh.IsSplit(face) ? adaptive.Mesh.GetChild(corner) : -1;
    if (child >= 0 && adaptive.Mesh.IsThere(child))
    {
      compared +=
        CompareThirds(adaptive, limits, child, uniform, all, uniform.Mesh.GetChild(3 * same + i));
    }
  }
  return compared;
}

}

TEST(AdaptiveSqrtThree, LimitsAtThirdsOfEdgesAreThoseOfTheUniformHierarchy)
{
  int compared = 0;
  for (const auto& [name, model] : MakeAdaptiveZoo())
  {
    if (name == "pillow") // several edges between the same vertices
    {
      continue;
    }
    Adaptive uniform(model);
    uniform.SplitTo(6);
    const Adaptive::Result all = uniform.Finish();
    for (unsigned seed = 0; seed < 6; ++seed)
    {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      Adaptive adaptive(model);
      adaptive.SplitAtRandom(seed, 12, 4);
      adaptive.Finish();
      LimitsBetween limits(adaptive);
      for (int face = 0; face < adaptive.Mesh.GetNumberOfControlFaces(); ++face)
      {
        compared += CompareThirds(adaptive, limits, face, uniform, all, face);
      }
    }
  }
  EXPECT_GT(compared, 1000);
}

TEST(AdaptiveSqrtThree, TheOrderOfSplitsDoesNotMatter)
{
  for (const auto& [name, model] : MakeAdaptiveZoo())
  {
    SCOPED_TRACE(name);
    Adaptive first(model);
    first.SplitAtRandom(3, 12, 5);
    // The same set from its last face to its first one, found by their paths.
    std::vector<std::vector<int>> paths;
    for (int face = 0; face < first.Mesh.GetNumberOfFaces(); ++face)
    {
      if (first.Mesh.IsSplit(face))
      {
        std::vector<int> path;
        int at = face;
        for (; at >= first.Mesh.GetNumberOfControlFaces(); at = first.Mesh.GetParent(at))
        {
          path.push_back((at - static_cast<int>(first.Mesh.GetNumberOfControlFaces())) % 3);
        }
        path.push_back(at);
        paths.push_back(path);
      }
    }
    Adaptive second(model);
    for (auto path = paths.rbegin(); path != paths.rend(); ++path)
    {
      int at = path->back();
      for (std::size_t i = path->size() - 1; i-- > 0;)
      {
        if (!second.Mesh.IsSplit(at))
        {
          second.Mesh.Split(at);
        }
        const int corner = 3 * at + (*path)[i];
        if (!second.Mesh.IsThere(second.Mesh.GetChild(corner)))
        {
          second.Mesh.Split(second.Mesh.GetTwin(corner) / 3);
        }
        at = second.Mesh.GetChild(corner);
      }
      second.Mesh.Split(at);
    }
    const Adaptive::Result a = first.Finish();
    const Adaptive::Result b = second.Finish();
    EXPECT_EQ(a.Triangles, b.Triangles);
    EXPECT_EQ(a.Generations, b.Generations);
    EXPECT_EQ(a.Faces, b.Faces);
    EXPECT_EQ(a.Points, b.Points);
  }
}

TEST(AdaptiveSqrtThree, ASplitStopsAtAnyNumberOfCells)
{
  for (const auto& [name, model] : MakeAdaptiveZoo())
  {
    SCOPED_TRACE(name);
    for (vtkIdType most = 1; most < 120; most += 7)
    {
      Adaptive adaptive(model);
      bool isDone = true;
      for (int round = 0; isDone && round < 400; ++round)
      {
        int face = static_cast<int>(adaptive.Mesh.GetNumberOfFaces()) - 1;
        while (!adaptive.Mesh.IsThere(face) || adaptive.Mesh.IsSplit(face))
        {
          --face;
        }
        isDone = adaptive.Mesh.Split(face, most);
      }
      EXPECT_FALSE(isDone);
      const vtkIdType given =
        adaptive.Control.Level.Mesh.NumberOfFaces + adaptive.Control.Level.Lines.size();
      EXPECT_LE(adaptive.Mesh.GetNumberOfCells(), std::max(most, given));
      CheckConforming(adaptive, adaptive.Finish(), name == "pillow");
    }
  }
}

TEST(AdaptiveSqrtThree, OneDeepSplitCostsInProportionToItsLevel)
{
  // One corner of a large grid, 40 steps deep.
  Adaptive adaptive(MakeSheet(40, 40, true, { 1., 0., 0. }, { 0.5, 0.8, 0. }));
  int face = 100;
  for (int level = 0; level < 40; ++level)
  {
    ASSERT_TRUE(adaptive.Mesh.Split(face));
    int corner = 3 * face;
    if (!adaptive.Mesh.IsThere(adaptive.Mesh.GetChild(corner)))
    {
      ASSERT_TRUE(adaptive.Mesh.Split(adaptive.Mesh.GetTwin(corner) / 3));
    }
    face = adaptive.Mesh.GetChild(corner);
  }
  EXPECT_LT(adaptive.Mesh.GetNumberOfCells() - 3200, 40 * 30);
  const Adaptive::Result result = adaptive.Finish();
  CheckConforming(adaptive, result);
  EXPECT_EQ(*std::max_element(result.Generations.begin(), result.Generations.end()), 80);
  for (const Point& point : result.Points)
  {
    EXPECT_NEAR(point[2], 0., 1e-13);
    EXPECT_TRUE(std::isfinite(point[0]) && std::isfinite(point[1]));
  }
}

TEST(AdaptiveSqrtThree, LinesFollowTheirSegments)
{
  for (const char* name : { "crease", "free line" })
  {
    const Model model = MakeZoo(true)[name];
    Adaptive adaptive(model);
    adaptive.SplitTo(2);
    adaptive.Mesh.Cut(adaptive.Mesh.GetSegmentOfEdge(adaptive.Control.Level.Lines[0] / 2));
    const AdaptiveSqrtThreeOutput<int> output(adaptive.Mesh);
    for (vtkIdType line = 0; line < adaptive.Control.Level.Lines.size(); ++line)
    {
      std::vector<AdaptiveSqrtThreeOutput<int>::Piece> pieces;
      output.AppendPieces(adaptive.Control.Level.Lines[line], pieces);
      ASSERT_EQ(pieces.size(), 3u);
      int at = static_cast<int>(model.Lines[line][0]);
      for (const auto& piece : pieces)
      {
        EXPECT_EQ(piece.Ends[0], at);
        EXPECT_EQ(piece.Generation, 4);
        at = piece.Ends[1];
      }
      EXPECT_EQ(at, model.Lines[line][1]);
    }
  }
}
