// SPDX-License-Identifier: BSD-3-Clause
// What holds for 4-8 and sqrt(3) alike, which replace edges: incidences against a search, flat
// grids, creases, and the filter around them.
#include "SurfaceTools.h"

namespace
{

using namespace surfacetools;

class SurfaceReplacedEdges : public testing::TestWithParam<SurfaceSchemeKind>
{
protected:
  const SurfaceSchemeKind Kind = GetParam();
  const bool OfTriangles = Kind == SurfaceSchemeKind::SqrtThree;
  const int Scheme = static_cast<int>(Kind);
  /// Of line; of quads also some of triangles.
  std::map<std::string, Model> Zoo = MakeZoo(OfTriangles);

  void SetUp() override
  {
    const std::map<std::string, Model> triangles = MakeZoo(true);
    for (const char* name : { "triangle", "moebius", "flipped fan", "touching tetrahedra" })
    {
      this->Zoo[std::string("triangles: ") + name] = triangles.at(name);
    }
  }
};

}

TEST_P(SurfaceReplacedEdges, StepsAreWhatASearchFinds)
{
  for (const auto& entry : Zoo)
  {
    SCOPED_TRACE(entry.first);
    Walk walk(entry.second, Kind);
    for (int step = 0; step < (OfTriangles ? 4 : 5); ++step)
    {
      const vtkIdType before = walk.Level.Mesh.NumberOfFaces;
      const vtkIdType euler = GetEuler(walk.Level.Mesh);
      CheckRows(walk);
      const SurfaceLevel<int> output = walk.Scheme->Refine(walk.Level, Depth::ForCounts);
      std::vector<int> faces(
        static_cast<std::size_t>(output.Mesh.GetFirstOfCounted(output.Mesh.NumberOfFaces)));
      walk.Scheme->WriteFaces(walk.Level, faces.data());
      walk.Step();
      EXPECT_EQ(GetEuler(walk.Level.Mesh), euler);
      EXPECT_TRUE(!OfTriangles || walk.Level.Mesh.NumberOfFaces == 3 * before);
      if (entry.first != "pillow") // its flipped edges have the same ends: a search merges them
      {
        CheckIncidences(walk.Level);
      }
      const SurfaceLevel<int>& whole = walk.Level;
      EXPECT_EQ(faces, std::vector<int>(whole.Mesh.Vertices.begin(), whole.Mesh.Vertices.end()));
      ASSERT_EQ(output.Lines.size(), whole.Lines.size());
      EXPECT_TRUE(std::equal(output.Lines.begin(), output.Lines.end(), whole.Lines.begin()));
    }
  }
}

// After four steps the pieces of each line follow one another from its beginning to its end.
TEST_P(SurfaceReplacedEdges, LinesStayConnected)
{
  const vtkIdType pieces = OfTriangles ? 9 : 4;
  for (const char* name : { "crease", "free line" })
  {
    const Model& model = Zoo[name];
    Walk walk(model, Kind);
    for (int step = 0; step < 4; ++step)
    {
      walk.Step();
    }
    const vtkIdType lines = static_cast<vtkIdType>(model.Lines.size());
    ASSERT_EQ(walk.Level.Lines.size(), pieces * lines);
    for (vtkIdType line = 0; line < lines; ++line)
    {
      vtkIdType at = model.Lines[line][0];
      for (vtkIdType i = 0; i < pieces; ++i)
      {
        const int piece = walk.Level.Lines[pieces * line + i];
        const int* ends = walk.Level.Mesh.EdgeVertices.data() + 2 * (piece / 2);
        EXPECT_EQ(ends[piece % 2], at);
        at = ends[1 - piece % 2];
      }
      EXPECT_EQ(at, model.Lines[line][1]);
    }
  }
}

TEST_P(SurfaceReplacedEdges, FlatGridsStayExact)
{
  for (const Point& side : { Point{ 0.5, 0.8, 0.25 }, Point{ 0.25, 0.8, 0.5 } })
  {
    // The rules for corners of two triangles are exact for triangles alike.
    Walk walk(MakeSheet(4, 3, OfTriangles, { 1., 0., 0. }, side), Kind, false);
    for (int step = 0; step < 6; ++step)
    {
      const std::vector<Point> before = walk.Points;
      const std::vector<Point> limit = walk.GetLimit();
      walk.Step();
      for (std::size_t v = 0; v < before.size(); ++v)
      {
        EXPECT_LT(GetDistance(walk.Points[v], before[v]), 1e-14) << step << " " << v;
        EXPECT_LT(GetDistance(limit[v], before[v]), 1e-14) << step << " " << v;
      }
    }
  }
}

TEST_P(SurfaceReplacedEdges, CreasesAreBoundariesOnBothSides)
{
  Model both = MakeSheet(3, 2, OfTriangles, { 1., 0., 0. }, { 0., 1., 0. });
  both.Points = MakeRandomPoints(both.Points.size(), 9);
  both.Lines = { { 4, 5 }, { 5, 6 }, { 6, 7 } };
  Model half = both;
  half.Lines.clear();
  half.Faces.resize(OfTriangles ? 6 : 3);
  half.Corners.insert(half.Corners.end(), { 4, 7 });
  Walk whole(both, Kind);
  Walk part(half, Kind);
  for (int step = 0; step < 6; ++step)
  {
    const std::vector<Point> limits = whole.GetLimit();
    const std::vector<Point> partLimits = part.GetLimit();
    for (int c = 0; c < part.Level.Mesh.GetNumberOfCorners(); ++c)
    {
      // The faces of the half are the first ones of the whole.
      const int v = part.Level.Mesh.Vertices[c];
      const int w = whole.Level.Mesh.Vertices[c];
      EXPECT_LT(GetDistance(part.Points[v], whole.Points[w]), 1e-14);
      EXPECT_LT(GetDistance(partLimits[v], limits[w]), 1e-14);
    }
    whole.Step();
    part.Step();
  }
}

// Random faces on few points: edges of many faces, pinched vertices, equal faces, free lines.
TEST_P(SurfaceReplacedEdges, AnythingIsSubdivided)
{
  std::mt19937 random(11);
  std::uniform_int_distribution<vtkIdType> point(0, 11);
  for (unsigned trial = 0; trial < 30; ++trial)
  {
    Model model;
    model.Points = MakeRandomPoints(12, trial);
    model.Lines = { { 0, 1 }, { 3, 9 } };
    for (int i = 0; i < 20; ++i)
    {
      std::vector<vtkIdType> ids(OfTriangles ? 3 : 3 + i % 3);
      std::generate(ids.begin(), ids.end(), [&] { return point(random); });
      if (std::set<vtkIdType>(ids.begin(), ids.end()).size() == ids.size())
      {
        model.Faces.push_back(ids);
      }
    }
    Walk walk(model, Kind);
    const vtkIdType euler = GetEuler(walk.Level.Mesh);
    for (int step = 0; step < 4; ++step)
    {
      CheckRows(walk);
      walk.Step();
      const PolygonMesh<int>& mesh = walk.Level.Mesh;
      EXPECT_EQ(GetEuler(mesh), euler);
      for (int c = 0; c < mesh.GetNumberOfCorners(); ++c)
      {
        const int twin = mesh.Twins[c];
        ASSERT_TRUE(twin < 0 || (mesh.Twins[twin] == c && mesh.Edges[twin] == mesh.Edges[c]));
      }
      for (const Point& p : walk.Points)
      {
        EXPECT_LT(std::max({ std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) }), 3.); // flatness
      }
    }
    const auto output = RunFilter(MakeInput(model), Scheme, 2);
    EXPECT_GT(output->GetNumberOfPolys(), static_cast<vtkIdType>(2 * model.Faces.size()));
  }
}

// One level after the other gives what several at once give, wherever the cut is.
TEST_P(SurfaceReplacedEdges, FiltersInARowAreOneFilter)
{
  for (const auto& entry : Zoo)
  {
    SCOPED_TRACE(entry.first);
    const auto input = MakeInput(entry.second);
    const auto all = RunFilter(input, Scheme, 4);
    auto single = RunFilter(input, Scheme, 1);
    ExpectSameBits(RunFilter(single, Scheme, 3), all);
    for (int i = 1; i < 4; ++i)
    {
      single = RunFilter(single, Scheme, 1);
    }
    ExpectSameBits(single, all);
  }
}

// The same with flags on vertices, lines and faces, and with edges that are sharp by their angle.
TEST_P(SurfaceReplacedEdges, FiltersInARowKeepFlags)
{
  Model grid = MakeSheet(6, 5, OfTriangles, { 1., 0., 0. }, { 0., 1., 0. });
  const std::vector<Point> noise = MakeRandomPoints(grid.Points.size(), 8);
  for (std::size_t i = 0; i < noise.size(); ++i)
  {
    grid.Points[i][2] = noise[i][2];
  }
  grid.Lines = { { 8, 9 }, { 9, 10 } };
  const auto input = MakeInput(grid);
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 24 });
  vertices->InsertNextCell({ 25 });
  input->SetVerts(vertices);
  vtkNew<vtkIntArray> flags;
  flags->SetName("Singular");
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    flags->InsertNextValue(cell == 1 || cell == 2 || cell == 12 || cell == 13 || cell == 20);
  }
  input->GetCellData()->AddArray(flags);
  auto run = [this](vtkPolyData* from, int levels)
  {
    return RunFilter(from, Scheme, levels, false,
      [](vtkSurfaceSubdivision* filter)
      {
        filter->SetDetectFeatures(true);
        filter->SetFeatureAngle(60.);
      });
  };
  const auto all = run(input, 3);
  ExpectSameBits(run(run(run(input, 1), 1), 1), all);
  input->GetCellData()->Initialize();
  const auto without = run(input, 3);
  EXPECT_NE(without->GetNumberOfPoints(), 0);
  bool isSame = true;
  for (vtkIdType i = 0; i < std::min(without->GetNumberOfPoints(), all->GetNumberOfPoints()); ++i)
  {
    isSame = isSame &&
      without->GetPoints()->GetData()->GetComponent(i, 2) ==
        all->GetPoints()->GetData()->GetComponent(i, 2);
  }
  EXPECT_FALSE(isSame);
}

INSTANTIATE_TEST_SUITE_P(Schemes, SurfaceReplacedEdges,
  testing::Values(SurfaceSchemeKind::FourEight, SurfaceSchemeKind::SqrtThree),
  [](const auto& scheme)
  { return scheme.param == SurfaceSchemeKind::SqrtThree ? "SqrtThree" : "FourEight"; });
