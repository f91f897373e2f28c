// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 3 and 4: types and rules on complexes whose answers are known by hand.
#include "Core/Solids/Strata/StrataBuilder.h"
#include "CoreZoo.h"

using namespace coretest;

namespace
{

/// A simplex, its rule, its type and the size of its ring.
struct Known
{
  Tuple Simplex;
  Rule FollowedRule;
  int Type;
  vtkIdType RingSize;
};

void ExpectKnown(const std::string& name, std::initializer_list<Known> known)
{
  SCOPED_TRACE(name);
  const Mesh mesh = FindInZoo(name);
  ASSERT_EQ(mesh.Name, name);
  const Subdivided<int> built = Build<int>(mesh.Cells, mesh.Singular);
  const auto& strata = built.Level.Strata;
  for (const Known& k : known)
  {
    const bool isVertex = k.Simplex.size() == 1;
    const vtkIdType i =
      isVertex ? k.Simplex[0] : FindEdge(built.Level.Complex, k.Simplex[0], k.Simplex[1]);
    const std::string label =
      std::to_string(k.Simplex[0]) + (isVertex ? "" : " " + std::to_string(k.Simplex[1]));
    ASSERT_GE(i, 0) << label;
    const Stratum stratum = isVertex ? strata.Vertices[i] : strata.Edges[i];
    EXPECT_EQ(static_cast<int>(stratum.GetRule()), static_cast<int>(k.FollowedRule)) << label;
    EXPECT_EQ(stratum.GetType(), k.Type) << label;
    EXPECT_EQ((isVertex ? strata.VertexRings : strata.EdgeRings).GetSize(i), k.RingSize) << label;
  }
}

template <typename T>
bool AreEqual(const Buffer<T>& a, const Buffer<T>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end());
}
bool AreEqual(const Buffer<Stratum>& a, const Buffer<Stratum>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
    [](Stratum x, Stratum y) { return x.GetRule() == y.GetRule() && x.GetType() == y.GetType(); });
}
bool AreEqual(const Rings<int>& a, const Rings<int>& b)
{
  return AreEqual(a.Offsets, b.Offsets) && AreEqual(a.Members, b.Members) &&
    AreEqual(a.Carriers, b.Carriers);
}

/// Lines between points by chance: ends, curves, branches, repeated lines, and points without any.
SimplexList MakeNetwork(unsigned int seed)
{
  std::mt19937 random(seed);
  Mesh mesh("network");
  mesh.Cells.NumberOfPoints = 2 + random() % 40;
  const auto points = static_cast<unsigned int>(mesh.Cells.NumberOfPoints);
  const unsigned int reach = seed % 2 == 0 ? 1 : points - 1;
  for (unsigned int lines = random() % (2 * points); lines > 0; --lines)
  {
    const unsigned int a = random() % points;
    const unsigned int b = (a + 1 + random() % reach) % points;
    mesh.AddCell({ a, b });
  }
  return mesh.Cells;
}

std::vector<unsigned char> FindDimensions(const std::string& name)
{
  const Mesh mesh = FindInZoo(name);
  const Subdivided<int> built = Build<int>(mesh.Cells);
  const auto found = FindManifoldDimensions(built.Level.Complex, built.Runs);
  return std::vector<unsigned char>(found.begin(), found.end());
}

}

TEST(CoreStrata, Curves)
{
  ExpectKnown("IsolatedVertex",
    { { { 0 }, Rule::Corner, 0, 0 }, { { 1 }, Rule::Corner, 0, 0 }, { { 3 }, Rule::Corner, 0, 0 },
      { { 1, 2 }, Rule::Curve, 0, 0 } });
  ExpectKnown("OpenPolyline",
    { { { 0 }, Rule::Corner, 0, 0 }, { { 1 }, Rule::Curve, 0, 2 },
      { { 2, 3 }, Rule::Curve, 0, 0 } });
  ExpectKnown("CrossingLines",
    { { { 0 }, Rule::Blend, 2, 4 }, { { 1 }, Rule::Corner, 0, 0 },
      { { 0, 1 }, Rule::Curve, 0, 0 } });
  ExpectKnown("RepeatedLines", { { { 1 }, Rule::Curve, 0, 2 }, { { 0 }, Rule::Corner, 0, 0 } });
}

TEST(CoreStrata, Surfaces)
{
  ExpectKnown("Icosahedron", { { { 0 }, Rule::Surface, 0, 5 }, { { 0, 1 }, Rule::Surface, 0, 2 } });
  ExpectKnown("OpenFan",
    { { { 0 }, Rule::Curve, 0, 2 }, { { 2 }, Rule::Curve, 0, 2 }, { { 0, 2 }, Rule::Surface, 0, 2 },
      { { 1, 2 }, Rule::Curve, 0, 0 } });
  ExpectKnown("BowTie",
    { { { 0 }, Rule::Blend, 3, 6 }, { { 2 }, Rule::Curve, 0, 2 }, { { 0, 2 }, Rule::Surface, 0, 2 },
      { { 0, 1 }, Rule::Curve, 0, 0 } });
  ExpectKnown("TwoTouchingTriangles", { { { 2 }, Rule::Blend, 3, 4 } });
  ExpectKnown("ThreeSheets",
    { { { 0, 1 }, Rule::Blend, 2, 3 }, { { 0 }, Rule::Blend, 2, 4 }, { { 4 }, Rule::Curve, 0, 2 },
      { { 0, 4 }, Rule::Curve, 0, 0 } });
  ExpectKnown(
    "RepeatedTriangles", { { { 1, 2 }, Rule::Surface, 0, 2 }, { { 0, 1 }, Rule::Curve, 0, 0 } });
  ExpectKnown(
    "FollowerLines", { { { 0, 2 }, Rule::Surface, 0, 2 }, { { 0 }, Rule::Surface, 0, 4 } });
  ExpectKnown("LineThroughSurface",
    { { { 0 }, Rule::Blend, 1, 6 }, { { 1 }, Rule::Blend, 1, 5 }, { { 0, 2 }, Rule::Surface, 0, 2 },
      { { 0, 1 }, Rule::Curve, 0, 0 }, { { 6 }, Rule::Corner, 0, 0 } });
}

TEST(CoreStrata, Solids)
{
  ExpectKnown("SingleTet", { { { 0 }, Rule::Surface, 0, 3 }, { { 1, 2 }, Rule::Surface, 0, 2 } });
  ExpectKnown("TetsSharingVertex",
    { { { 0 }, Rule::Blend, 3, 6 }, { { 4 }, Rule::Surface, 0, 3 },
      { { 0, 4 }, Rule::Surface, 0, 2 } });
  ExpectKnown("TetsSharingEdge",
    { { { 0, 1 }, Rule::Blend, 3, 4 }, { { 0 }, Rule::Blend, 3, 5 }, { { 2 }, Rule::Surface, 0, 3 },
      { { 0, 2 }, Rule::Surface, 0, 2 } });
  ExpectKnown("PinchedTets",
    { { { 4, 5 }, Rule::Blend, 3, 4 }, { { 2, 3 }, Rule::Blend, 3, 4 },
      { { 0 }, Rule::Blend, 3, 8 }, { { 2 }, Rule::Blend, 3, 5 } });
  // Three tetrahedra on the triangle 012: its edges and vertices are type 2.
  ExpectKnown("CrowdOfTets",
    { { { 0, 1 }, Rule::Blend, 2, 4 }, { { 0 }, Rule::Blend, 2, 5 }, { { 3 }, Rule::Surface, 0, 3 },
      { { 0, 3 }, Rule::Surface, 0, 2 } });
  ExpectKnown("Valence4",
    { { { 4 }, Rule::Solid, 0, 4 }, { { 4, 0 }, Rule::Solid, 0, 3 },
      { { 0 }, Rule::Surface, 0, 3 } });
  ExpectKnown(
    "Octahedron", { { { 0, 1 }, Rule::RegularEdge, 0, 4 }, { { 0 }, Rule::Surface, 0, 4 } });
  ExpectKnown("OctahedronMixedMarks", { { { 0, 1 }, Rule::Solid, 0, 4 } });
  ExpectKnown("FollowerTriangles",
    { { { 0, 1 }, Rule::Surface, 0, 2 }, { { 0, 3 }, Rule::Surface, 0, 2 },
      { { 0 }, Rule::Surface, 0, 3 } });
  ExpectKnown(
    "RepeatedTets", { { { 1, 2 }, Rule::Surface, 0, 2 }, { { 1 }, Rule::Surface, 0, 4 } });
}

TEST(CoreStrata, Joints)
{
  ExpectKnown("FinOnEdge",
    { { { 0, 1 }, Rule::Blend, 1, 3 }, { { 0 }, Rule::Blend, 1, 4 }, { { 4 }, Rule::Curve, 0, 2 },
      { { 0, 4 }, Rule::Curve, 0, 0 }, { { 2 }, Rule::Surface, 0, 3 } });
  ExpectKnown("FinAtVertex",
    { { { 0 }, Rule::Blend, 1, 5 }, { { 0, 4 }, Rule::Curve, 0, 0 },
      { { 0, 1 }, Rule::Surface, 0, 2 } });
  ExpectKnown("LineOnTet",
    { { { 3 }, Rule::Blend, 1, 4 }, { { 4 }, Rule::Curve, 0, 2 }, { { 5 }, Rule::Corner, 0, 0 },
      { { 3, 0 }, Rule::Surface, 0, 2 }, { { 3, 4 }, Rule::Curve, 0, 0 } });
  ExpectKnown("FinInside",
    { { { 4, 0 }, Rule::Blend, 1, 4 }, { { 4 }, Rule::Blend, 1, 5 },
      { { 4, 1 }, Rule::Solid, 0, 3 } });
  // A regular edge with fins is a joint: eq. 15 does not apply.
  ExpectKnown(
    "FinInRegularEdge", { { { 0, 1 }, Rule::Blend, 1, 6 }, { { 0 }, Rule::Blend, 1, 7 } });
  ExpectKnown("EverythingAtOnce",
    { { { 0 }, Rule::Blend, 1, 7 }, { { 0, 3 }, Rule::Surface, 0, 2 },
      { { 0, 2 }, Rule::Curve, 0, 0 }, { { 1 }, Rule::Corner, 0, 0 } });
}

/// Faces of C_3 alone are counted at a regular edge that follows C_3.
TEST(CoreStrata, AFollowedSolidHasRegularEdges)
{
  const Mesh mesh = FindInZoo("FinInRegularEdge");
  StrataOptions options;
  options.Type1 = JointRule::FollowDimension3;
  const Subdivided<int> built = Build<int>(mesh.Cells, mesh.Singular, options);
  const int edge = FindEdge(built.Level.Complex, 0, 1);
  EXPECT_EQ(built.Level.Strata.Edges[edge].GetRule(), Rule::RegularEdge);
  EXPECT_EQ(built.Level.Strata.EdgeRings.GetSize(edge), 4);
}

TEST(CoreStrata, Singularities)
{
  ExpectKnown("CreasedSurface",
    { { { 2 }, Rule::Curve, 0, 2 }, { { 0 }, Rule::Corner, 0, 0 }, { { 5 }, Rule::Corner, 0, 0 },
      { { 0, 2 }, Rule::Curve, 0, 0 } });
  ExpectKnown("SingularSheetInside",
    { { { 0, 1 }, Rule::Surface, 0, 2 }, { { 0, 2 }, Rule::Curve, 0, 0 },
      { { 0 }, Rule::Curve, 0, 2 }, { { 2 }, Rule::Curve, 0, 2 }, { { 3 }, Rule::Surface, 0, 4 } });
  ExpectKnown("SingularLineInside",
    { { { 0, 1 }, Rule::Curve, 0, 0 }, { { 0 }, Rule::Corner, 0, 0 }, { { 2 }, Rule::Curve, 0, 2 },
      { { 3 }, Rule::Corner, 0, 0 } });
  // The closed surface of a tetrahedron among others.
  const Mesh mesh = FindInZoo("SingularFaceInside");
  const Subdivided<int> built = Build<int>(mesh.Cells, mesh.Singular);
  const Tuple first = GetCells(mesh.Cells)[0];
  for (vtkIdType v : first)
  {
    EXPECT_EQ(built.Level.Strata.Vertices[v].GetRule(), Rule::Surface);
    EXPECT_EQ(built.Level.Strata.VertexRings.GetSize(v), 3);
  }
}

TEST(CoreStrata, AnnulusAndSuspendedTorusAreType3)
{
  // Vertex links that are connected 2-manifolds, but neither sphere nor disk.
  Mesh annulus = MakeSpread("Annulus", 7);
  Mesh torus = MakeSpread("Torus", 8);
  for (int i = 0; i < 3; ++i) // a prism ring without top and bottom, coned to 0
  {
    const int a = 1 + i;
    const int b = 1 + (i + 1) % 3;
    annulus.AddCells({ { 0, a, b, a + 3 }, { 0, b, b + 3, a + 3 } });
  }
  for (int i = 0; i < 7; ++i) // the torus with seven vertices, coned to 7
  {
    torus.AddCells({ { 7, i, (i + 1) % 7, (i + 3) % 7 }, { 7, i, (i + 2) % 7, (i + 3) % 7 } });
  }
  const Subdivided<int> ring = Build<int>(annulus.Cells);
  EXPECT_EQ(ring.Level.Strata.Vertices[0].GetType(), 3);
  EXPECT_EQ(ring.Level.Strata.Vertices[0].GetRule(), Rule::Blend);
  EXPECT_EQ(ring.Level.Strata.Vertices[1].GetType(), 0);
  const Subdivided<int> cone = Build<int>(torus.Cells);
  EXPECT_EQ(cone.Level.Strata.Vertices[7].GetType(), 3);
  EXPECT_EQ(cone.Level.Strata.Vertices[7].GetRule(), Rule::Blend);
  EXPECT_EQ(cone.Level.Strata.Vertices[0].GetType(), 0);
  EXPECT_EQ(cone.Level.Strata.Vertices[0].GetRule(), Rule::Surface);
}

TEST(CoreStrata, TwoSurfacesWithTheEulerCharacteristicOfOneAreType3)
{
  // The link of vertex 0 is the torus with seven vertices and a sphere, or a ring and a disk, in
  // both orders.
  for (const bool isClosed : { true, false })
  {
    for (const bool isLast : { true, false })
    {
      SCOPED_TRACE(std::to_string(isClosed) + std::to_string(isLast));
      Mesh mesh = MakeSpread("TwoSurfaces", 12);
      const int first = isLast ? 1 : 5; // of the torus or ring
      const int other = isLast ? 8 : 1;
      for (int i = 0; i < 7 && isClosed; ++i)
      {
        const auto at = [=](int k) { return vtkIdType(first + (i + k) % 7); };
        mesh.AddCells({ { 0, at(0), at(1), at(3) }, { 0, at(0), at(2), at(3) } });
      }
      for (int i = 0; i < 3 && !isClosed; ++i)
      {
        const int a = first + i;
        const int b = first + (i + 1) % 3;
        mesh.AddCells({ { 0, a, b, a + 3 }, { 0, b, b + 3, a + 3 } });
      }
      for (int i = 0; i < (isClosed ? 4 : 1); ++i)
      {
        const auto at = [=](int k) { return vtkIdType(other + (i + k) % 4); };
        mesh.AddCells({ { 0, at(0), at(1), at(2) } });
      }
      const Subdivided<int> built = Build<int>(mesh.Cells);
      EXPECT_EQ(built.Level.Strata.Vertices[0].GetType(), 3);
      EXPECT_EQ(built.Level.Strata.Vertices[first].GetType(), 0);
    }
  }
}

TEST(CoreStrata, SeveralSmallestFansAreType3)
{
  // Fans at vertex 0 and at edge 01: closed ones are of three, the fewest there may be, beside a
  // closed or an open one.
  const auto add = [](Mesh& mesh, int first, int size, bool isClosed, bool ofTets)
  {
    for (int i = 0; i + (isClosed ? 0 : 1) < size; ++i)
    {
      const int a = first + i;
      const int b = first + (i + 1) % size;
      mesh.AddCells({ ofTets ? Tuple{ 0, 1, a, b } : Tuple{ 0, a, b } });
    }
  };
  for (const bool ofTets : { false, true })
  {
    for (const int size : { 2, 3, 4 })
    {
      for (const bool isClosed : { false, true })
      {
        if (size == 2 && isClosed)
        {
          continue;
        }
        for (const bool isLast : { false, true })
        {
          Mesh mesh = MakeSpread("Fans", 12);
          add(mesh, isLast ? 5 : 2, 3, true, ofTets);
          add(mesh, isLast ? 2 : 5, isLast ? std::min(size, 3) : size, isClosed, ofTets);
          const Subdivided<int> built = Build<int>(mesh.Cells);
          const auto& strata = built.Level.Strata;
          const Stratum stratum =
            ofTets ? strata.Edges[FindEdge(built.Level.Complex, 0, 1)] : strata.Vertices[0];
          EXPECT_EQ(stratum.GetType(), 3) << ofTets << size << isClosed << isLast;
        }
      }
    }
  }
}

// Where there are curves alone, counting edges tells what links do.
TEST(CoreStrata, CurvesAreAsByLinks)
{
  int joints = 0;
  for (unsigned int seed = 0; seed < 300; ++seed)
  {
    SCOPED_TRACE(seed);
    StrataOptions options;
    options.Type2 = seed % 5 == 0 ? JointRule::Sharp : JointRule::Blend;
    options.ModifiedBoundary = seed % 3 == 0;
    options.Weights = seed % 7 == 0 ? LoopWeights::Loop : LoopWeights::Warren;
    const Subdivided<int> built = Build<int>(MakeNetwork(seed), {}, options);
    const SimplicialComplex<int>& complex = built.Level.Complex;
    if (seed % 11 == 0)
    {
      options.VertexChoices = Buffer<unsigned char>(
        complex.NumberOfVertices, 1 + static_cast<unsigned char>(JointRule::Sharp));
    }
    const SingularSimplices none;
    const Strata<int> found = BuildStrata(complex, none, options);
    const Strata<int> expected = StrataBuilder<int>(complex, none, options).Build();
    ASSERT_TRUE(AreEqual(found.Vertices, expected.Vertices));
    ASSERT_TRUE(AreEqual(found.Edges, expected.Edges));
    ASSERT_TRUE(AreEqual(found.Faces, expected.Faces));
    ASSERT_TRUE(AreEqual(found.VertexRings, expected.VertexRings));
    ASSERT_TRUE(AreEqual(found.EdgeRings, expected.EdgeRings));
    ASSERT_EQ(found.Weights, expected.Weights);
    ASSERT_EQ(found.ModifiedBoundary, expected.ModifiedBoundary);
    joints += static_cast<int>(std::count_if(found.Vertices.begin(), found.Vertices.end(),
      [](Stratum stratum) { return stratum.GetType() == 2; }));
  }
  EXPECT_GT(joints, 100);
}

TEST(CoreStrata, ManifoldDimensions)
{
  using Dimensions = std::vector<unsigned char>;
  EXPECT_EQ(FindDimensions("IsolatedVertex"), (Dimensions{ 0, 1, 1, 1 }));
  EXPECT_EQ(FindDimensions("FollowerTriangles"), (Dimensions{ 3, 3, 3, 3, 3 }));
  EXPECT_EQ(FindDimensions("FollowerLines"), (Dimensions{ 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2 }));
  EXPECT_EQ(FindDimensions("EverythingAtOnce"), (Dimensions{ 3, 1, 2, 2, 2, 3, 3 }));
  EXPECT_EQ(FindDimensions("RepeatedTets"), (Dimensions{ 3, 3, 3, 3, 3 }));
  EXPECT_EQ(FindDimensions("TentOnTet"), (Dimensions{ 3, 1, 1 }));
}
