// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 12: the rows of the modified Butterfly scheme between vertices inside the surface.
#include "SchemeTools.h"

#include "Core/Surfaces/Butterfly/ButterflyMasks.h"

using namespace surfacetools;

namespace
{

/// The entries from vertex 0 of a fan, for its edge to vertex 1 + j, from a corner in one of the
/// two faces of that edge.
Weights GetRing(const PolygonMesh<int>& mesh, int edge, int corner, double factor)
{
  RowBlock<int> rows;
  AppendButterflyRing(mesh, edge, 0, corner, factor, rows);
  return ToWeights(rows);
}

}

TEST(ButterflyRegular, EdgeOfTwoRegularVertices)
{
  const double expected[8] = { 0.5, 0.5, 0.125, -0.0625, -0.0625, 0.125, -0.0625, -0.0625 };
  ASSERT_EQ(ButterflyEdge.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i)
  {
    EXPECT_EQ(ButterflyEdge[i], expected[i]) << i;
  }
}

// The edge's other end has s_0, the j-th neighbour from there s_j. Weights are the same both ways
// around.
TEST(ButterflyRegular, EdgeOfAnotherVertex)
{
  for (const int k : { 5, 3, 7, 7, 4, 8, 5 }) // weights of before are not those of now
  {
    for (const bool areTurned : { false, true })
    {
      Model model = MakeFan(k, false);
      for (std::size_t face = 0; face < model.Faces.size() && areTurned; face += 2)
      {
        std::reverse(model.Faces[face].begin(), model.Faces[face].end());
      }
      const PolygonMesh<int> mesh = MakeLevel(model.Points.size(), model.Faces, {}).Mesh;
      int found = 0;
      for (int corner = 0; corner < mesh.GetNumberOfCorners(); ++corner)
      {
        for (const int edge : { mesh.Edges[corner], mesh.Edges[mesh.Previous(corner)] })
        {
          if (mesh.Vertices[corner] != 0)
          {
            continue;
          }
          ++found;
          const int end = mesh.GetOtherEnd(edge, 0);
          Weights expected{ { 0, 0.4 * 0.75 } };
          for (int j = 0; j < k; ++j)
          {
            const double t = 2. * Pi * j / k;
            const double s = k == 3 ? (j == 0 ? 5. / 12. : -1. / 12.)
              : k == 4              ? (j == 0      ? 3. / 8.
                                          : j == 2 ? -1. / 8.
                                                   : 0.)
                                    : (0.25 + std::cos(t) + 0.5 * std::cos(2. * t)) / k;
            expected[1 + (end - 1 + j) % k] = 0.4 * s;
          }
          ExpectRow(GetRing(mesh, edge, corner, 0.4), expected, "ring of " + std::to_string(k));
        }
      }
      EXPECT_EQ(found, 2 * k);
    }
  }
}
