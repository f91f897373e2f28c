// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 5: the rows of Loop's scheme where the surface is smooth.
#include "SchemeTools.h"

#include "Core/Surfaces/Loop/LoopRegular.h"

using namespace surfacetools;

namespace
{

Weights MakeStar(int center, double own, const std::vector<int>& ring, double weight)
{
  Weights row{ { center, own } };
  for (const int member : ring)
  {
    row[member] = weight;
  }
  return row;
}

std::vector<int> Count(int first, int size)
{
  std::vector<int> ids;
  for (int i = 0; i < size; ++i)
  {
    ids.push_back(first + i);
  }
  return ids;
}

/// Of vertices [begin, end): one entry of 100 where a vertex is not smooth.
std::vector<Weights> GetRows(const SurfaceLevel<int>& level, const SurfaceTags<int>& tags,
  LoopWeights weights, int begin, int end)
{
  RowBlock<int> rows;
  const auto members = [&](const FanStep<int>& step, int* one)
  { *one = GetNeighbour(level.Mesh, step); };
  AppendPrimalVertices<3>(
    level, tags, LoopVertex, begin, end, members, [](int, int*) { return false; },
    [&](int vertex, const std::vector<FanStep<int>>& steps)
    {
      steps.empty() ? rows.Add(vertex, 100.)
                    : AppendLoopVertex(vertex, weights, steps, members, rows);
    },
    rows);
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

/// All vertices are smooth but for those of the boundary.
SurfaceTags<int> MakeTags(const PolygonMesh<int>& mesh)
{
  SurfaceTags<int> tags;
  tags.Vertices = Buffer<VertexTag>(mesh.NumberOfVertices, VertexTag::Smooth);
  for (int e = 0; e < static_cast<int>(mesh.GetNumberOfEdges()); ++e)
  {
    for (int end = 0; end < 2 && mesh.Twins[mesh.EdgeCorners[e]] < 0; ++end)
    {
      tags.Vertices[mesh.EdgeVertices[2 * e + end]] = VertexTag::Curve;
    }
  }
  return tags;
}

}

TEST(LoopRegular, Masks)
{
  ASSERT_EQ(LoopVertex.size(), 7u);
  ASSERT_EQ(LoopEdge.size(), 4u);
  for (std::size_t i = 0; i < 7; ++i)
  {
    EXPECT_EQ(LoopVertex[i], i == 0 ? 0.625 : 0.0625) << i;
  }
  for (std::size_t i = 0; i < 4; ++i)
  {
    EXPECT_EQ(LoopEdge[i], i < 2 ? 0.375 : 0.125) << i;
  }
}

TEST(LoopRegular, RingOfAnySize)
{
  for (const int n : { 3, 4, 5, 6, 9 })
  {
    for (const bool areTurned : { false, true })
    {
      Model model = MakeFan(n, false);
      for (std::size_t face = 0; face < model.Faces.size() && areTurned; face += 2)
      {
        std::reverse(model.Faces[face].begin(), model.Faces[face].end());
      }
      const SurfaceLevel<int> level = MakeLevel(model.Points.size(), model.Faces, {});
      const double wave = 0.375 + 0.25 * std::cos(2. * Pi / n);
      for (const LoopWeights weights : { LoopWeights::Warren, LoopWeights::Loop })
      {
        const double own = n == 3        ? 7. / 16.
          : weights == LoopWeights::Loop ? 1. - (0.625 - wave * wave)
                                         : 0.625;
        const Weights expected = MakeStar(0, own, Count(1, n), (1. - own) / n);
        ExpectRow(
          GetRows(level, MakeTags(level.Mesh), weights, 0, 1).at(0), expected, "some vertices");
      }
    }
  }
}

// Inside a sheet of triangles that lean to the left, rows and others take turns.
TEST(LoopRegular, VerticesOneAfterTheOther)
{
  const Model model = MakeSheet(5, 4, true, { 1., 0., 0. }, { 0., 1., 0. });
  const SurfaceLevel<int> level = MakeLevel(model.Points.size(), model.Faces, {});
  const std::vector<Weights> rows =
    GetRows(level, MakeTags(level.Mesh), LoopWeights::Warren, 2, 30);
  ASSERT_EQ(rows.size(), 28u);
  for (int v = 2; v < 30; ++v)
  {
    const bool isInside = v % 6 > 0 && v % 6 < 5 && v / 6 > 0 && v / 6 < 4;
    const Weights inside = MakeStar(v, 0.625, { v + 1, v - 1, v + 6, v - 6, v + 5, v - 5 }, 0.0625);
    ExpectRow(rows[static_cast<std::size_t>(v) - 2], isInside ? inside : Weights{ { v, 100. } },
      "vertex " + std::to_string(v));
  }
  // Several rings that are not regular follow one another.
  Model solid;
  solid.Points = MakeRandomPoints(6, 1);
  solid.Faces = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 }, { 0, 4, 1 }, { 5, 2, 1 }, { 5, 3, 2 },
    { 5, 4, 3 }, { 5, 1, 4 } };
  const SurfaceLevel<int> octahedron = MakeLevel(6, solid.Faces, {});
  const std::vector<Weights> four =
    GetRows(octahedron, MakeTags(octahedron.Mesh), LoopWeights::Warren, 0, 6);
  ASSERT_EQ(four.size(), 6u);
  const int opposite[6] = { 5, 3, 4, 1, 2, 0 };
  for (int v = 0; v < 6; ++v)
  {
    Weights expected = MakeStar(v, 0.625, Count(0, 6), 3. / 32.);
    expected[v] = 0.625;
    expected.erase(opposite[v]);
    ExpectRow(four[static_cast<std::size_t>(v)], expected, "octahedron");
  }
}
