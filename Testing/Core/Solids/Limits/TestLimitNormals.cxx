// SPDX-License-Identifier: BSD-3-Clause
// Normals of limit surfaces: against the faces of a much finer level, and where there are none.
#include "LimitTools.h"
#include "PointTools.h"

#include "Core/Solids/Limits/Skin.h"

using namespace coretest;
using namespace point_tools;

namespace
{

using Vector = std::array<double, 3>;

Vector At(const std::vector<double>& points, vtkIdType i)
{
  return { points[3 * i], points[3 * i + 1], points[3 * i + 2] };
}

std::vector<double> MakeNormals(const Level<int>& level, const std::vector<double>& points,
  int steps = 0, const std::vector<vtkIdType>& inverted = {},
  const SemiSharpStages<int>& creases = {})
{
  std::vector<double> normals(points.size(), 7.);
  const Buffer<unsigned char> turned = TakeParents(FindTriangleSides(level).ListTurned(), steps);
  ComputeLimitNormals(BuildLimitTangents(level, creases, { {}, steps }), points.data(), inverted,
    turned, normals.data());
  return normals;
}

/// Both tangents of each vertex.
std::pair<std::vector<double>, std::vector<double>> MakeTangents(
  const Level<int>& level, const std::vector<double>& points)
{
  std::pair<std::vector<double>, std::vector<double>> tangents;
  tangents.first.assign(points.size(), 7.);
  tangents.second.assign(points.size(), 7.);
  ComputeLimitTangents(BuildLimitTangents(level), points.data(), {},
    FindTriangleSides(level).ListTurned(), tangents.first.data(), tangents.second.data());
  return tangents;
}

/// Twice the number of each tetrahedron of negative volume.
std::vector<vtkIdType> FindInverted(const Level<int>& level, const std::vector<double>& points)
{
  std::vector<vtkIdType> inverted;
  for (vtkIdType tet = 0; tet < level.Complex.NumberOfTets; ++tet)
  {
    Vector corners[4];
    for (int k = 0; k < 4; ++k)
    {
      corners[k] = At(points, level.Complex.TetVertices[4 * tet + k]);
    }
    Vector s[3];
    for (int k = 0; k < 3; ++k)
    {
      for (int c = 0; c < 3; ++c)
      {
        s[k][c] = corners[k + 1][c] - corners[0][c];
      }
    }
    const double volume = s[0][0] * (s[1][1] * s[2][2] - s[1][2] * s[2][1]) -
      s[0][1] * (s[1][0] * s[2][2] - s[1][2] * s[2][0]) +
      s[0][2] * (s[1][0] * s[2][1] - s[1][1] * s[2][0]);
    if (volume < 0.)
    {
      inverted.push_back(2 * tet);
    }
  }
  return inverted;
}

}

/// The tangents at a vertex are left eigenvectors: a step scales them, so the normal stays.
TEST(LimitNormals, AStepDoesNotTurnThem)
{
  int some = 0;
  for (const Mesh& mesh : MakeZooAndRandom())
  {
    for (const char* options : OptionNames)
    {
      SCOPED_TRACE(mesh.Name + " " + options);
      Subdivided<int> level = BuildNamed<int>(mesh, options);
      std::vector<double> points = MakeValues(3 * level.Level.Complex.NumberOfVertices, 5);
      const std::vector<double> before = MakeNormals(level.Level, points);
      const LimitTangents<int> tangents = BuildLimitTangents(level.Level);
      points = ApplyTo(CopyStencils(level.Level), points, 3);
      const std::vector<double> after = MakeNormals(RefineOnce(level).Level, points);
      const auto& strata = level.Level.Strata;
      for (int v = 0; v < level.Level.Complex.NumberOfVertices; ++v)
      {
        const Vector a = At(before, v);
        const Vector b = At(after, v);
        const double length = Length(a);
        ASSERT_TRUE(length == 0. || std::abs(length - 1.) < 1e-14);
        if (tangents.Sectors.Offsets[v] == tangents.Sectors.Offsets[v + 1])
        {
          continue; // no tangents: it is for shading
        }
        ASSERT_EQ(length == 0., Length(b) == 0.) << v;
        ASSERT_NEAR(Dot(a, b), length, 1e-9) << v;
        const Rule rule = strata.Vertices[v].GetRule();
        ASSERT_TRUE(length == 0. || rule == Rule::Surface || rule == Rule::Curve);
        some += length > 0. ? 1 : 0;
      }
    }
  }
  EXPECT_GT(some, 1000);
}

/// The same where the other ends of edges lie on creases that are still sharp: these have sectors.
TEST(LimitNormals, AStepNextToSemiSharpCreasesDoesNotTurnThem)
{
  int some = 0;
  unsigned int seed = 0;
  for (const Mesh& mesh : MakeZooAndRandom())
  {
    for (const char* options : { "Blend", "ModifiedBoundary", "ModifiedDart" })
    {
      SCOPED_TRACE(mesh.Name + " " + options);
      SemiSharpMesh semi(mesh, options, ++seed);
      std::fill(semi.Sharpness.Faces.begin(), semi.Sharpness.Faces.end(), 0.);
      for (std::size_t edge = 0; edge < semi.Sharpness.Edges.size(); ++edge)
      {
        semi.Sharpness.Edges[edge] *= edge % 4 == 0 ? 1. : 0.;
      }
      const Level<int> level = semi.MakeSmoothLevel(0);
      const Level<int> next = semi.MakeSmoothLevel(1);
      const std::vector<double> points = MakeValues(3 * level.Complex.NumberOfVertices, 5);
      const std::vector<double> later = ApplyTo(semi.MakeStencils(0), points, 3);
      const std::vector<double> before = MakeNormals(level, points, 0, {}, semi.MakeStages(0));
      const std::vector<double> after = MakeNormals(next, later, 0, {}, semi.MakeStages(1));
      const LimitTangents<int> tangents = BuildLimitTangents(level, semi.MakeStages(0));
      for (int v = 0; v < level.Complex.NumberOfVertices; ++v)
      {
        if (tangents.Sectors.Offsets[v] < tangents.Sectors.Offsets[v + 1])
        {
          ASSERT_NEAR(Dot(At(before, v), At(after, v)), Length(At(before, v)), 1e-9) << v;
          ++some;
        }
      }
    }
  }
  EXPECT_GT(some, 200);
}

/// Tangents of a sector span the plane of its normal; those of curves become half in a step.
TEST(LimitNormals, AreThoseOfTheTangents)
{
  int ofSectors = 0;
  int ofCurves = 0;
  for (const Mesh& mesh : MakeZooAndRandom())
  {
    for (const char* options : { "Blend", "Sharp", "Follow1" })
    {
      SCOPED_TRACE(mesh.Name + " " + options);
      Subdivided<int> level = BuildNamed<int>(mesh, options);
      const std::vector<double> points = MakeValues(3 * level.Level.Complex.NumberOfVertices, 5);
      const std::vector<double> normals = MakeNormals(level.Level, points);
      const LimitTangents<int> tangents = BuildLimitTangents(level.Level);
      const auto [first, second] = MakeTangents(level.Level, points);
      const std::vector<double> later = ApplyTo(CopyStencils(level.Level), points, 3);
      const auto next = MakeTangents(RefineOnce(level).Level, later);
      for (int v = 0; v < level.Level.Complex.NumberOfVertices; ++v)
      {
        const Vector a = At(first, v);
        const Vector b = At(second, v);
        const int sectors = tangents.Sectors.Offsets[v + 1] - tangents.Sectors.Offsets[v];
        const Vector cross = { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
          a[0] * b[1] - a[1] * b[0] };
        if (sectors == 1 && Length(cross) > 1e-6)
        {
          ++ofSectors;
          EXPECT_NEAR(Dot(cross, At(normals, v)), Length(cross), 1e-9 * Length(cross)) << v;
        }
        if (sectors > 0)
        {
          continue;
        }
        EXPECT_EQ(Length(b), 0.) << v;
        const auto& ring = level.Level.Strata.VertexRings;
        const bool isOnCurve =
          level.Level.Strata.Vertices[v].GetRule() == Rule::Curve && ring.GetSize(v) == 2;
        EXPECT_EQ(Length(a) > 0., isOnCurve) << v;
        ofCurves += isOnCurve;
        const Vector half = At(next.first, v);
        for (int c = 0; c < 3; ++c)
        {
          EXPECT_NEAR(half[c], a[c] / 2., 1e-14) << v;
        }
      }
    }
  }
  EXPECT_GT(ofSectors, 500);
  EXPECT_GT(ofCurves, 50);
}

/// The same bits from a skin that is refined alone, and zero at all other vertices.
TEST(LimitNormals, OfSkinsAreThoseOfTheWhole)
{
  int closed = 0;
  int left = 0;
  for (const Mesh& mesh : MakeZooAndRandom())
  {
    for (const char* options : OptionNames)
    {
      SCOPED_TRACE(mesh.Name + " " + options);
      Subdivided<int> level = BuildNamed<int>(mesh, options);
      const std::vector<double> control = MakeValues(3 * level.Level.Complex.NumberOfVertices, 5);
      const std::vector<vtkIdType> inverted = FindInverted(level.Level, control);
      const Buffer<unsigned char> turned = FindTriangleSides(level.Level).ListTurned();
      SkinTangents<int> tangents;
      const bool isClosed = BuildSkinTangents(level.Level, {}, 2, tangents);
      EXPECT_TRUE(isClosed || level.Level.Complex.NumberOfTets > 0);
      if (!isClosed)
      {
        continue;
      }
      ++closed;
      level = RefineOnce(RefineOnce(level));
      const vtkIdType size = level.Level.Complex.NumberOfVertices;
      const std::vector<double> points = MakeValues(3 * size, 6);
      std::vector<double> whole(points.size());
      ComputeLimitNormals(BuildLimitTangents(level.Level, {}, { {}, 2 }), points.data(), inverted,
        turned, whole.data());
      const Buffer<double> normals = tangents.ComputeNormals(points.data(), size, inverted, turned);
      for (std::size_t i = 0; i < whole.size(); ++i)
      {
        ASSERT_EQ(normals[i], whole[i]) << i;
      }
      left += tangents.Vertices.size() < size;
    }
  }
  EXPECT_GT(closed, 100);
  EXPECT_GT(left, 20);
}

TEST(LimitNormals, TangentsRunAlongTheLines)
{
  for (const bool turned : { false, true })
  {
    Mesh mesh;
    mesh.Cells.NumberOfPoints = 4;
    for (int i = 0; i < 3; ++i)
    {
      mesh.Cells.Dimensions.push_back(1);
      mesh.Cells.Connectivity.push_back(turned ? i + 1 : i);
      mesh.Cells.Connectivity.push_back(turned ? i : i + 1);
    }
    const std::vector<double> points = { 0, 0, 0, 1, 2, 0, 3, 1, 0, 4, 4, 4 };
    const auto first = MakeTangents(Build<int>(mesh.Cells).Level, points).first;
    const double sign = turned ? -1. : 1.;
    EXPECT_EQ(At(first, 0), (Vector{ 0., 0., 0. }));
    EXPECT_EQ(At(first, 1), (Vector{ 3. * sign, 1. * sign, 0. * sign }));
    EXPECT_EQ(At(first, 2), (Vector{ 3. * sign, 2. * sign, 4. * sign }));
    EXPECT_EQ(At(first, 3), (Vector{ 0., 0., 0. }));
  }
}

TEST(LimitNormals, OfSolidsPointOutwards)
{
  const Lattice lattice = MakeLattice("Cube", 2, 1., 3);
  for (double mirror : { 1., -1. }) // inverted cells too
  {
    Level<int> level = std::move(Build<int>(lattice.Control.Cells).Level);
    std::vector<double> points = lattice.Control.Points;
    for (std::size_t i = 0; i < points.size(); i += 3)
    {
      points[i] = mirror * (points[i] - 1.);
      points[i + 1] -= 1.;
      points[i + 2] -= 1.;
    }
    const std::vector<vtkIdType> inverted = FindInverted(level, points);
    for (int step = 0; step < 2; ++step)
    {
      const std::vector<double> normals = MakeNormals(level, points, step, inverted);
      for (int v = 0; v < level.Complex.NumberOfVertices; ++v)
      {
        const bool isBoundary = level.Strata.Vertices[v].GetRule() == Rule::Surface;
        const Vector normal = At(normals, v);
        ASSERT_EQ(Length(normal) > 0., isBoundary);
        ASSERT_TRUE(!isBoundary || Dot(normal, At(points, v)) > 0.3);
      }
      points = ApplyTo(CopyStencils(level), points, 3);
      level = Refine(level, Depth::ForRefinement);
    }
  }
}

TEST(LimitNormals, OfSurfacesFollowTheTriangles)
{
  for (int flip = 0; flip < 2; ++flip)
  {
    Mesh fan("Fan");
    fan.AddPoint(0., 0., 0.);
    for (int i = 0; i < 6; ++i)
    {
      fan.AddPoint(std::cos(i * 1.0471975511965976), std::sin(i * 1.0471975511965976), 0.);
    }
    for (int i = 0; i < 6; ++i)
    {
      const vtkIdType a = 1 + i;
      const vtkIdType b = 1 + (i + 1) % 6;
      fan.AddCell(flip ? Tuple{ 0, b, a } : Tuple{ 0, a, b });
    }
    const Level<int> level = std::move(Build<int>(fan.Cells).Level);
    const std::vector<double> normals = MakeNormals(level, fan.Points);
    for (int v = 0; v < 7; ++v) // inside, and on the boundary with two triangles
    {
      EXPECT_NEAR(normals[3 * v + 2], flip ? -1. : 1., 1e-14) << v;
    }
  }
}

/// One triangle at a boundary vertex, three and four, and both sides of a crease.
TEST(LimitNormals, SectorsOfABentSurface)
{
  Mesh bent = MakeFan("Bent", 6, true);
  bent.Singular = { { 0, 1 }, { 0, 4 } };
  const Level<int> level = std::move(Build<int>(bent.Cells, bent.Singular).Level);
  // A roof: the crease is its ridge, so the mean of both normals points up.
  std::vector<double> points = { 0, 0, 1 };
  for (int i = 0; i < 6; ++i)
  {
    const double y = std::sin(i * 1.0471975511965976);
    points.insert(points.end(), { std::cos(i * 1.0471975511965976), y, 1. - std::abs(y) });
  }
  const std::vector<double> normals = MakeNormals(level, points);
  EXPECT_NEAR(normals[0], 0., 1e-14);
  EXPECT_NEAR(normals[1], 0., 1e-14);
  EXPECT_NEAR(normals[2], 1., 1e-14);
  // The end of the crease on the boundary is a corner: the mean of both triangles there.
  EXPECT_NEAR(normals[3 * 1 + 1], 0., 1e-14);
  EXPECT_NEAR(Length(At(normals, 1)), 1., 1e-14);
  EXPECT_NEAR(normals[3 * 2 + 2], std::sqrt(.5), 1e-14);
  EXPECT_NEAR(normals[3 * 2 + 1], std::sqrt(.5), 1e-14);
}
