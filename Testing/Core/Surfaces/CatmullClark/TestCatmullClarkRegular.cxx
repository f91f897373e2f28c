// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 12: the rows of Catmull-Clark where the surface is smooth and consists of quads.
#include "SchemeTools.h"

#include "Core/Surfaces/CatmullClark/CatmullClarkRegular.h"

using namespace surfacetools;

namespace
{

/// Writes the neighbour by whose edge a walk enters a quad, and the vertex opposite.
struct Members
{
  const PolygonMesh<int>& Mesh;
  void operator()(const FanStep<int>& step, int* two) const
  {
    two[0] = GetNeighbour(this->Mesh, step);
    two[1] = this->Mesh.Vertices[this->Mesh.Next(this->Mesh.Next(step.Corner))];
  }
};

/// k quads around vertex 0: neighbours 1, 3, 5, ..., with the vertices opposite between them.
Model MakeStar(int k)
{
  Model model;
  model.Points = MakeRandomPoints(static_cast<std::size_t>(2 * k) + 1, 1);
  for (int j = 0; j < k; ++j)
  {
    model.Faces.push_back({ 0, 1 + 2 * j, 2 + 2 * j, 1 + (2 * j + 2) % (2 * k) });
  }
  return model;
}

/// The weights of a vertex of k faces by definition: (F + 2 M + (k - 3) v) / k, where F is the mean
/// of the face points and M that of the middles of the edges.
Weights GetExpected(int k)
{
  const double n = k;
  Weights row{ { 0, (n - 3.) / n + 1. / n + 1. / (4. * n) } };
  for (int j = 0; j < k; ++j)
  {
    row[1 + 2 * j] = 1. / (n * n) + 2. / (4. * n * n);
    row[2 + 2 * j] = 1. / (4. * n * n);
  }
  return row;
}

std::vector<Weights> ToRows(const RowBlock<int>& rows)
{
  std::vector<Weights> maps(rows.GetNumberOfRows());
  for (std::size_t row = 0; row < maps.size(); ++row)
  {
    for (std::size_t i = rows.GetBegin(row); i < rows.GetEnd(row); ++i)
    {
      maps[row][rows.GetColumns()[i]] += rows.GetWeights()[i];
    }
  }
  return maps;
}

/// Of vertices [begin, end). Those that are not regular get one entry: how many steps their walks
/// have.
std::vector<Weights> GetRows(const SurfaceLevel<int>& level, int begin, int end)
{
  SurfaceTags<int> tags;
  tags.Vertices = Buffer<VertexTag>(level.Mesh.NumberOfVertices, VertexTag::Curve);
  for (int v = 0; v < static_cast<int>(level.Mesh.NumberOfVertices); ++v)
  {
    std::vector<int> edges;
    CollectEdges(
      level.Mesh, v, [&](int e) { return level.Mesh.Twins[level.Mesh.EdgeCorners[e]] < 0; }, edges);
    tags.Vertices[v] = edges.empty() ? VertexTag::Smooth : VertexTag::Curve;
  }
  RowBlock<int> rows;
  AppendPrimalVertices<4>(
    level, tags, QuadsAtVertex, begin, end, Members{ level.Mesh }, [](int, int*) { return false; },
    [&](int vertex, const std::vector<FanStep<int>>& steps)
    { rows.Add(vertex, 100. + static_cast<double>(steps.size())); }, rows);
  return ToRows(rows);
}

}

TEST(CatmullClarkRegular, Masks)
{
  ASSERT_EQ(QuadsAtVertex.size(), 9u);
  ASSERT_EQ(QuadsAtEdge.size(), 6u);
  ASSERT_EQ(QuadOfFace.size(), 4u);
  for (std::size_t i = 0; i < 9; ++i)
  {
    EXPECT_EQ(QuadsAtVertex[i], i == 0 ? 36. / 64. : i % 2 ? 6. / 64. : 1. / 64.) << i;
  }
  for (std::size_t i = 0; i < 6; ++i)
  {
    EXPECT_EQ(QuadsAtEdge[i], i < 2 ? 6. / 16. : 1. / 16.) << i;
  }
  for (const double weight : QuadOfFace)
  {
    EXPECT_EQ(weight, 0.25);
  }
}

TEST(CatmullClarkRegular, VertexOfAnyNumberOfQuads)
{
  for (int k = 3; k <= 8; ++k)
  {
    for (const bool areTurned : { false, true })
    {
      Model model = MakeStar(k);
      for (std::size_t face = 0; face < model.Faces.size() && areTurned; face += 2)
      {
        std::reverse(model.Faces[face].begin(), model.Faces[face].end());
      }
      const SurfaceLevel<int> level = MakeLevel(model.Points.size(), model.Faces, {});
      std::vector<FanStep<int>> steps;
      VisitCycle(level.Mesh, level.Mesh.VertexCorners[0],
        [&](const FanStep<int>& step) { steps.push_back(step); });
      RowBlock<int> rows;
      AppendQuadVertex(0, steps, Members{ level.Mesh }, rows);
      ExpectRow(ToWeights(rows), GetExpected(k), std::to_string(k) + " quads");
      // The same where four are regular, and for others the walk.
      ExpectRow(GetRows(level, 0, 1).at(0), k == 4 ? GetExpected(4) : Weights{ { 0, 100. + k } },
        "with others");
    }
  }
}

TEST(CatmullClarkRegular, VerticesOneAfterTheOther)
{
  Model model = MakeSheet(5, 4, false, { 1., 0., 0. }, { 0., 1., 0. });
  for (const bool areQuads : { true, false })
  {
    if (!areQuads)
    {
      model.Faces[0] = { 0, 1, 7 }; // far away, but then rows of quads are not made together
      model.Faces.push_back({ 0, 7, 6 });
    }
    const SurfaceLevel<int> level = MakeLevel(model.Points.size(), model.Faces, {});
    ASSERT_EQ(level.Mesh.Arity, areQuads ? 4 : 0);
    const std::vector<Weights> rows = GetRows(level, 0, 30);
    ASSERT_EQ(rows.size(), 30u);
    for (int v = 0; v < 30; ++v)
    {
      const int x = v % 6;
      const int y = v / 6;
      const bool isInside = x > 0 && x < 5 && y > 0 && y < 4;
      const int faces = !areQuads && v == 7 ? 5 : 4;
      Weights expected{ { v, isInside ? 100. + faces : 100. } };
      if (isInside && areQuads)
      {
        expected[v] = 9. / 16.;
        for (const int step : { 1, -1, 6, -6 })
        {
          expected[v + step] = 3. / 32.;
        }
        for (const int step : { 7, -7, 5, -5 })
        {
          expected[v + step] = 1. / 64.;
        }
      }
      ExpectRow(rows[static_cast<std::size_t>(v)], expected, "vertex " + std::to_string(v));
    }
  }
}
