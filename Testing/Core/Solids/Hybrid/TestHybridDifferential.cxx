// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestHybridDifferential.cxx
 * Levels of random meshes of all cell types, as the product and the slow reference make them.
 */
#include "Precompiled.h"

#include "HybridTools.h"
#include "HybridZoo.h"

#include <random>

namespace
{

void ExpectSameCells(const subdivision::CellList<int>& cells, const hybridtest::Mesh& expected)
{
  ASSERT_EQ(cells.GetNumberOfCells(), static_cast<vtkIdType>(expected.Cells.size()));
  for (vtkIdType c = 0; c < cells.GetNumberOfCells(); ++c)
  {
    const hybridtest::Cell& cell = expected.Cells[c];
    EXPECT_EQ(static_cast<int>(cells.Shapes[c]), static_cast<int>(cell.Shape)) << "cell " << c;
    const int* first = cells.GetCorners(c);
    EXPECT_EQ(hybridtest::Ids(first, cells.GetCorners(c + 1)), cell.Corners) << "cell " << c;
  }
}

template <typename List>
void ExpectSameList(const List& a, const List& b)
{
  ASSERT_EQ(a.size(), b.size());
  EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin()));
}
void ExpectSameRows(const subdivision::Rows<int>& a, const subdivision::Rows<int>& b)
{
  ExpectSameList(a.Offsets, b.Offsets);
  ExpectSameList(a.Items, b.Items);
}

void ExpectSameComplex(
  const subdivision::CellComplex<int>& a, const subdivision::CellComplex<int>& b)
{
  EXPECT_EQ(a.NumberOfQuads, b.NumberOfQuads);
  EXPECT_EQ(a.NumberOfCentres, b.NumberOfCentres);
  ExpectSameRows(a.CellEdges, b.CellEdges);
  ExpectSameRows(a.CellFaces, b.CellFaces);
  ExpectSameRows(a.FaceSolids, b.FaceSolids);
  ExpectSameRows(a.EdgeFaces, b.EdgeFaces);
  ExpectSameRows(a.EdgeSolids, b.EdgeSolids);
  ExpectSameRows(a.VertexEdges, b.VertexEdges);
  ExpectSameRows(a.VertexSolids, b.VertexSolids);
  ExpectSameList(a.EdgeVertices, b.EdgeVertices);
  ExpectSameList(a.FaceVertices, b.FaceVertices);
  ExpectSameList(a.FaceEdges, b.FaceEdges);
  ExpectSameList(a.EdgeFirsts, b.EdgeFirsts);
  ExpectSameList(a.FaceFirsts, b.FaceFirsts);
  ExpectSameList(a.Centres, b.Centres);
  ExpectSameList(a.Twins, b.Twins);
}

/// Whether cells and their twins have the edges of all their faces.
bool HaveEdgesOfTheirFaces(const subdivision::CellComplex<int>& complex)
{
  for (vtkIdType c = 0; c < complex.Cells.GetNumberOfCells(); ++c)
  {
    const subdivision::Row<int> own = complex.CellEdges[c];
    for (const int face : complex.CellFaces[c])
    {
      for (const int edge : complex.GetEdges(face))
      {
        if (std::find(own.begin(), own.end(), edge) == own.end())
        {
          return false;
        }
      }
    }
    const subdivision::Row<int> faces = complex.CellFaces[c];
    if (complex.IsTwin(c) &&
      !std::is_permutation(faces.begin(), faces.end(), complex.CellFaces[complex.Twins[c]].begin()))
    {
      return false;
    }
  }
  return true;
}

/// Makes levels of a mesh both ways.
void ExpectSameLevels(hybridtest::Mesh mesh, int levels)
{
  const hybrid_tools::HybridMesh taken = hybrid_tools::Take(mesh);
  auto level = hybrid_tools::MakeLevel<int>(taken);
  std::vector<double> points = taken.Points;
  for (int i = 1; i <= levels; ++i)
  {
    const hybridtest::Level expected = hybridtest::Refine(mesh);
    points = hybrid_tools::ApplyStep(level, points);
    level = subdivision::RefineHybrid(level, subdivision::HybridRules::Smooth);
    mesh = expected.Fine;
    ASSERT_EQ(points.size(), 3 * mesh.Points.size());
    ExpectSameCells(level.Complex.Cells, mesh);
    for (std::size_t p = 0; p < mesh.Points.size(); ++p)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(points[3 * p + c], mesh.Points[p][c], 1e-13)
          << "level " << i << ", point " << p << ", component " << c;
      }
    }
  }
}

/// Gives one of `most` edges and faces of a mesh a sharpness, by a seed.
void Sharpen(hybridtest::Mesh& mesh, unsigned int seed, unsigned int most)
{
  const hybridtest::Complex complex(mesh);
  constexpr double values[] = { .3, .5, 1., 1.25, 2., 2.7, 1e300 };
  for (int d = 1; d <= 2; ++d)
  {
    for (const auto& side : complex.GetSides(d))
    {
      seed = seed * 1664525u + 1013904223u;
      if ((seed >> 16) % most == 0)
      {
        mesh.Sharpness[side.first] = values[(seed >> 24) % 7];
      }
    }
  }
}

}

/// Children of all types: found one by one in their parents, and looked for among all.
TEST(HybridDifferential, ComplexesOfChildren)
{
  for (unsigned int seed = 0; seed < 40; ++seed)
  {
    SCOPED_TRACE(seed);
    hybrid_tools::HybridMesh mesh = hybrid_tools::Take(hybridtest::MakeRandomHybrid(seed));
    if (seed % 4 == 0)
    {
      mesh.Cells.push_back(mesh.Cells[mesh.Cells.size() / 2]); // maybe a twin
    }
    auto complex = std::move(hybrid_tools::MakeLevel<int>(mesh).Complex);
    for (int i = 0; i < (mesh.Cells.size() < 20 ? 2 : 1); ++i)
    {
      auto children = subdivision::RefineCellComplex(complex);
      ExpectSameComplex(children, subdivision::BuildCellComplex(subdivision::SplitCells(complex)));
      complex = std::move(children);
    }
  }
}

/// Cells that have corners in common, in any order: quads with other edges, and solids that are no
/// twins, though they have the corners of an earlier one.
TEST(HybridDifferential, CellsOnTheSameCorners)
{
  using Cells = std::vector<hybrid_tools::Cell>;
  using Shape = subdivision::CellShape;
  std::vector<Cells> all = {
    { { Shape::Hex, { 0, 1, 2, 3, 4, 5, 6, 7 } }, { Shape::Quad, { 0, 2, 1, 3 } } },
    { { Shape::Pyramid, { 0, 1, 2, 3, 4 } }, { Shape::Pyramid, { 0, 2, 1, 3, 4 } } },
    { { Shape::Wedge, { 0, 1, 2, 3, 4, 5 } }, { Shape::Wedge, { 0, 1, 2, 4, 5, 3 } } },
    { { Shape::Hex, { 0, 1, 2, 3, 4, 5, 6, 7 } }, { Shape::Hex, { 0, 1, 2, 3, 5, 6, 7, 4 } } },
    { { Shape::Octahedron, { 0, 1, 2, 3, 4, 5 } }, { Shape::Octahedron, { 0, 2, 1, 3, 4, 5 } } },
    { { Shape::Hex, { 0, 1, 2, 3, 4, 5, 6, 7 } }, { Shape::Hex, { 7, 6, 5, 4, 3, 2, 1, 0 } } },
  };
  std::mt19937 random(5);
  for (int round = 0; round < 200; ++round)
  {
    all.emplace_back();
    for (int c = 0; c < 2 + round % 4; ++c)
    {
      const auto shape = static_cast<Shape>(random() % subdivision::NumberOfShapes);
      std::vector<vtkIdType> corners = { 0, 1, 2, 3, 4, 5, 6, 7 };
      std::shuffle(corners.begin(), corners.end(), random);
      corners.resize(static_cast<std::size_t>(subdivision::GetCellTable(shape).Corners));
      all.back().push_back({ shape, corners });
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    SCOPED_TRACE(i);
    hybrid_tools::HybridMesh mesh;
    mesh.Cells = all[i];
    for (int p = 0; p < 8; ++p)
    {
      mesh.AddPoint(p % 2, p / 2 % 2, p / 4);
    }
    auto complex = std::move(hybrid_tools::MakeLevel<int>(mesh).Complex);
    EXPECT_TRUE(i > 4 || complex.Twins.empty());
    EXPECT_TRUE(i != 5 || (complex.IsTwin(1) && complex.NumberOfCentres == 1));
    for (int step = 0; step < 2; ++step)
    {
      ASSERT_TRUE(HaveEdgesOfTheirFaces(complex));
      auto children = subdivision::RefineCellComplex(complex);
      ExpectSameComplex(children, subdivision::BuildCellComplex(subdivision::SplitCells(complex)));
      complex = std::move(children);
    }
  }
}

/// Two levels each, the second of which follows rules that children inherit in the product and that
/// the reference finds anew. Mesh 111 has a dart at a column.
TEST(HybridDifferential, RandomMeshesEqualTheReference)
{
  for (unsigned int seed = 0; seed < 120; ++seed)
  {
    SCOPED_TRACE(seed);
    const hybridtest::Mesh mesh = hybridtest::MakeRandomHybrid(seed);
    ExpectSameLevels(mesh, mesh.Cells.size() < 20 ? 2 : 1);
  }
}

/// Joints are smooth: the reference keeps no curves of sharp ones for the stages of sharpness.
TEST(HybridDifferential, SemiSharpPartsEqualTheReference)
{
  for (unsigned int seed = 0; seed < 48; ++seed)
  {
    SCOPED_TRACE(seed);
    hybridtest::Mesh mesh = hybridtest::MakeRandomHybrid(seed);
    mesh.Joint = hybridtest::Joints::Blend;
    Sharpen(mesh, seed, seed % 3 == 0 ? 4 : 15);
    const std::size_t size = mesh.Cells.size();
    ExpectSameLevels(std::move(mesh), size < 5 ? 3 : size < 12 ? 2 : 1);
  }
}
