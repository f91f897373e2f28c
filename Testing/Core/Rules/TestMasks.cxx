// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 5 and 6: the weights, number by number, and eq. 12 on Kuhn lattices.
#include "CoreZoo.h"

#include "Core/Rules/Masks.h"

using namespace coretest;

namespace
{

using Weights = std::map<vtkIdType, double>; ///< those that are not zero

/// One step's rows of a mesh.
class Rows1
{
public:
  explicit Rows1(const Mesh& mesh, const StrataOptions& options = StrataOptions())
    : Level(Build<int>(mesh.Cells, mesh.Singular, options))
    , Dense(MakeMatrix(CopyStencils(this->Level.Level)))
  {
  }
  Weights Vertex(vtkIdType v) const { return this->Get(v); }
  Weights Edge(vtkIdType a, vtkIdType b) const
  {
    const int e = FindEdge(this->Level.Level.Complex, a, b);
    EXPECT_GE(e, 0) << a << " " << b;
    return e < 0 ? Weights() : this->Get(this->Level.Level.Complex.NumberOfVertices + e);
  }

  const Subdivided<int> Level;
  const Matrix Dense;

private:
  Weights Get(vtkIdType row) const
  {
    Weights weights;
    for (std::size_t i = 0; i < this->Dense[row].size(); ++i)
    {
      if (this->Dense[row][i] != 0.)
      {
        weights[static_cast<vtkIdType>(i)] = this->Dense[row][i];
      }
    }
    return weights;
  }
};

/// Own weight, and the same weight for each of a ring.
Weights Star(std::initializer_list<vtkIdType> own, double ownWeight,
  std::initializer_list<vtkIdType> ring, double ringWeight)
{
  Weights weights;
  for (vtkIdType v : own)
  {
    weights[v] = ownWeight;
  }
  for (vtkIdType v : ring)
  {
    weights[v] = ringWeight;
  }
  return weights;
}

void ExpectWeights(const Weights& weights, const Weights& expected)
{
  ASSERT_EQ(weights.size(), expected.size());
  for (const auto& entry : expected)
  {
    ASSERT_EQ(weights.count(entry.first), 1u) << entry.first;
    EXPECT_NEAR(weights.at(entry.first), entry.second, 1e-15) << entry.first;
  }
}

/// The coefficients of (1 + z1)^2 (1 + z2)^2 (1 + z3)^2 (1 + z1 z2 z3)^2 / 32.
std::map<std::array<int, 3>, double> MakeBoxSpline()
{
  std::map<std::array<int, 3>, double> mask = { { { 0, 0, 0 }, 1. / 32. } };
  const std::array<int, 3> directions[4] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 1 } };
  for (const auto& d : directions)
  {
    for (int twice = 0; twice < 2; ++twice)
    {
      std::map<std::array<int, 3>, double> product = mask;
      for (const auto& term : mask)
      {
        product[{ term.first[0] + d[0], term.first[1] + d[1], term.first[2] + d[2] }] +=
          term.second;
      }
      mask = product;
    }
  }
  return mask;
}

class BoxSpline : public testing::TestWithParam<std::tuple<double, unsigned int>>
{
};

}

TEST_P(BoxSpline, KuhnLatticeIsEquation12)
{
  constexpr int n = 4;
  const Lattice lattice = MakeLattice("Kuhn", n, std::get<0>(GetParam()), std::get<1>(GetParam()));
  const auto mask = MakeBoxSpline();
  double total = 0.;
  for (const auto& term : mask)
  {
    total += term.second;
  }
  EXPECT_EQ(total, 8.);
  const Rows1 rows(lattice.Control);
  const auto& complex = rows.Level.Level.Complex;
  const int vertices = complex.NumberOfVertices;
  int tested = 0;
  for (int row = 0; row < vertices + complex.NumberOfEdges; ++row)
  {
    // Where the point is on the fine lattice.
    const int ends[2] = { row < vertices ? row : complex.EdgeVertices[2 * (row - vertices)],
      row < vertices ? row : complex.EdgeVertices[2 * (row - vertices) + 1] };
    std::array<int, 3> fine;
    bool inside = true;
    for (int c = 0; c < 3; ++c)
    {
      fine[c] = lattice.Positions[ends[0]][c] + lattice.Positions[ends[1]][c];
      inside = inside && fine[c] > 0 && fine[c] < 2 * n;
    }
    if (!inside)
    {
      continue;
    }
    ++tested;
    for (int column = 0; column < vertices; ++column)
    {
      std::array<int, 3> exponent;
      for (int c = 0; c < 3; ++c)
      {
        exponent[c] = fine[c] - 2 * lattice.Positions[column][c] + 2;
      }
      const auto term = mask.find(exponent);
      ASSERT_EQ(rows.Dense[row][column], term == mask.end() ? 0. : term->second)
        << "row " << row << " column " << column;
    }
  }
  EXPECT_EQ(tested, 7 * 7 * 7);
}
INSTANTIATE_TEST_SUITE_P(
  Core, BoxSpline, testing::Combine(testing::Values(1., 0.1, 0.3), testing::Values(1u, 2u, 3u)));

TEST(CoreMasks, CubicBSpline)
{
  const Rows1 open(FindInZoo("OpenPolyline"));
  ExpectWeights(open.Vertex(0), { { 0, 1. } });
  ExpectWeights(open.Vertex(4), { { 4, 1. } });
  ExpectWeights(open.Vertex(2), Star({ 2 }, 0.75, { 1, 3 }, 0.125));
  ExpectWeights(open.Edge(0, 1), Star({ 0, 1 }, 0.5, {}, 0));
  ExpectWeights(open.Edge(1, 2), Star({ 1, 2 }, 0.5, {}, 0));
  const Rows1 closed(FindInZoo("ClosedPolyline"));
  ExpectWeights(closed.Vertex(0), Star({ 0 }, 0.75, { 1, 3 }, 0.125));
}

TEST(CoreMasks, LoopByValence)
{
  const Rows1 three(FindInZoo("TetSurface"));
  ExpectWeights(three.Vertex(0), Star({ 0 }, 7. / 16., { 1, 2, 3 }, 3. / 16.));
  ExpectWeights(three.Edge(0, 1), Star({ 0, 1 }, 3. / 8., { 2, 3 }, 1. / 8.));
  const Rows1 four(FindInZoo("OctahedronSurface"));
  ExpectWeights(four.Vertex(4), Star({ 4 }, 5. / 8., { 0, 1, 2, 3 }, 3. / 32.));
  const Rows1 five(FindInZoo("Icosahedron"));
  ExpectWeights(five.Vertex(0), Star({ 0 }, 5. / 8., { 1, 3, 5, 7, 9 }, 3. / 40.));
  const Rows1 six(MakeFan("", 6, true));
  ExpectWeights(six.Vertex(0), Star({ 0 }, 10. / 16., { 1, 2, 3, 4, 5, 6 }, 1. / 16.));
  const Rows1 many(MakeFan("", 80, true)); // more than the tables hold
  const Weights row = many.Vertex(0);
  ASSERT_EQ(row.size(), 81u);
  EXPECT_NEAR(row.at(0), 5. / 8., 1e-15);
  EXPECT_NEAR(row.at(80), 3. / 640., 1e-15);
}

// (5/8 - (3/8 + 1/4 cos(2 pi / m))^2) / m for each of m.
TEST(CoreMasks, LoopsOwnWeights)
{
  StrataOptions options;
  options.Weights = LoopWeights::Loop;
  const Rows1 four(FindInZoo("OctahedronSurface"), options);
  ExpectWeights(four.Vertex(4), Star({ 4 }, 33. / 64., { 0, 1, 2, 3 }, 31. / 256.));
  ExpectWeights(four.Edge(4, 0), Rows1(FindInZoo("OctahedronSurface")).Edge(4, 0));
  const double wave = (5. + std::sqrt(5.)) / 16.; // cos(2 pi / 5) = (sqrt(5) - 1) / 4
  const Rows1 five(FindInZoo("Icosahedron"), options);
  ExpectWeights(five.Vertex(0),
    Star({ 0 }, 3. / 8. + wave * wave, { 1, 3, 5, 7, 9 }, (5. / 8. - wave * wave) / 5.));
  const Rows1 seven(MakeFan("", 7, true), options);
  const double seventh = 3. / 8. + 0.62348980185873353 / 4.; // cos(2 pi / 7)
  ExpectWeights(seven.Vertex(0),
    Star({ 0 }, 3. / 8. + seventh * seventh, { 1, 2, 3, 4, 5, 6, 7 },
      (5. / 8. - seventh * seventh) / 7.));
  const Rows1 eight(MakeFan("", 8, true), options);
  const double eighth = (29. - 6. * std::sqrt(2.)) / 64.; // 5/8 - ((3 + sqrt(2)) / 8)^2
  ExpectWeights(eight.Vertex(0), Star({ 0 }, 1. - eighth, { 1, 2, 3, 4, 5, 6, 7, 8 }, eighth / 8.));
  const Rows1 many(MakeFan("", 80, true), options);        // more than the tables hold
  const double far = 3. / 8. + 0.9969173337331279761 / 4.; // cos(pi / 40)
  const Weights row = many.Vertex(0);
  ASSERT_EQ(row.size(), 81u);
  EXPECT_NEAR(row.at(0), 3. / 8. + far * far, 1e-15);
  EXPECT_NEAR(row.at(80), (5. / 8. - far * far) / 80., 1e-15);
  // On boundaries of solids, next to an inner vertex, which has none of this.
  const Rows1 solid(FindInZoo("TwoTets"), options);
  ExpectWeights(solid.Vertex(1), Star({ 1 }, 33. / 64., { 0, 2, 3, 4 }, 31. / 256.));
  ExpectWeights(solid.Edge(0, 2), Star({ 0, 2 }, 3. / 8., { 1, 3 }, 1. / 8.));
}

// Three and six neighbours have the same bits, and so have all other rules.
TEST(CoreMasks, LoopsOwnWeightsChangeNothingElse)
{
  StrataOptions options;
  options.Weights = LoopWeights::Loop;
  for (const char* name : { "TetSurface", "SingleTet", "OpenFan", "ClosedPolyline" })
  {
    EXPECT_EQ(Rows1(FindInZoo(name), options).Dense, Rows1(FindInZoo(name)).Dense) << name;
  }
  EXPECT_EQ(Rows1(MakeFan("", 6, true), options).Dense, Rows1(MakeFan("", 6, true)).Dense);
  EXPECT_NE(Rows1(MakeFan("", 5, true), options).Dense, Rows1(MakeFan("", 5, true)).Dense);
}

TEST(CoreMasks, BoundaryOfSurface)
{
  const Rows1 fan(FindInZoo("OpenFan")); // centre 0, rim 1 to 6
  ExpectWeights(fan.Vertex(0), Star({ 0 }, 0.75, { 1, 6 }, 0.125));
  ExpectWeights(fan.Vertex(1), Star({ 1 }, 0.75, { 0, 2 }, 0.125));
  ExpectWeights(fan.Vertex(3), Star({ 3 }, 0.75, { 2, 4 }, 0.125));
  ExpectWeights(fan.Edge(0, 1), Star({ 0, 1 }, 0.5, {}, 0));
  ExpectWeights(fan.Edge(0, 2), Star({ 0, 2 }, 3. / 8., { 1, 3 }, 1. / 8.));
}

TEST(CoreMasks, BoundaryOfSolidIsLoop)
{
  const Rows1 two(FindInZoo("TwoTets")); // 0123 and 1243 share 123
  ExpectWeights(two.Vertex(0), Star({ 0 }, 7. / 16., { 1, 2, 3 }, 3. / 16.));
  ExpectWeights(two.Vertex(1), Star({ 1 }, 5. / 8., { 0, 2, 3, 4 }, 3. / 32.));
  ExpectWeights(two.Edge(1, 2), Star({ 1, 2 }, 3. / 8., { 0, 4 }, 1. / 8.));
  ExpectWeights(two.Edge(0, 2), Star({ 0, 2 }, 3. / 8., { 1, 3 }, 1. / 8.));
}

TEST(CoreMasks, InsideOfSolid)
{
  const Rows1 centre(FindInZoo("Valence4"));
  ExpectWeights(centre.Vertex(4), Star({ 4 }, 9. / 16., { 0, 1, 2, 3 }, 7. / 64.));
  ExpectWeights(centre.Edge(4, 0), Star({ 4, 0 }, 5. / 16., { 1, 2, 3 }, 3. / 24.));
  ExpectWeights(centre.Vertex(0), Star({ 0 }, 7. / 16., { 1, 2, 3 }, 3. / 16.));
  // Four tetrahedra around an edge: eq. 15 if all mark it, else eq. 18.
  const Rows1 marked(FindInZoo("Octahedron"));
  ExpectWeights(marked.Edge(0, 1), Star({ 0, 1 }, 1. / 4., { 2, 3, 4, 5 }, 1. / 8.));
  const Rows1 mixed(FindInZoo("OctahedronMixedMarks"));
  ExpectWeights(mixed.Edge(0, 1), Star({ 0, 1 }, 5. / 16., { 2, 3, 4, 5 }, 3. / 32.));
}

TEST(CoreMasks, FinOnTet)
{
  const Rows1 fin(FindInZoo("FinOnEdge")); // tetrahedron 0123, triangle 014
  ExpectWeights(fin.Vertex(0), Star({ 0 }, 9. / 16., { 1, 2, 3, 4 }, 7. / 64.));
  ExpectWeights(fin.Vertex(2), Star({ 2 }, 7. / 16., { 0, 1, 3 }, 3. / 16.));
  ExpectWeights(fin.Vertex(4), Star({ 4 }, 3. / 4., { 0, 1 }, 1. / 8.));
  ExpectWeights(fin.Edge(0, 1), Star({ 0, 1 }, 5. / 16., { 2, 3, 4 }, 3. / 24.));
  ExpectWeights(fin.Edge(0, 4), Star({ 0, 4 }, 1. / 2., {}, 0));
  ExpectWeights(fin.Edge(0, 2), Star({ 0, 2 }, 3. / 8., { 1, 3 }, 1. / 8.));
}

TEST(CoreMasks, ThreeSheets)
{
  const Rows1 sheets(FindInZoo("ThreeSheets")); // 01 with 2, 3, 4
  ExpectWeights(sheets.Vertex(0), Star({ 0 }, 9. / 16., { 1, 2, 3, 4 }, 7. / 64.));
  ExpectWeights(sheets.Edge(0, 1), Star({ 0, 1 }, 5. / 16., { 2, 3, 4 }, 1. / 8.));
  ExpectWeights(sheets.Vertex(2), Star({ 2 }, 3. / 4., { 0, 1 }, 1. / 8.));
  // A common neighbour that spans no triangle belongs to the relief ring.
  const Rows1 relief(FindInZoo("ThreeSheetsRelief"));
  ExpectWeights(relief.Edge(0, 1), Star({ 0, 1 }, 5. / 16., { 2, 3, 4, 5 }, 3. / 32.));
  ExpectWeights(relief.Vertex(0), Star({ 0 }, 9. / 16., { 1, 2, 3, 4, 5 }, 7. / 80.));
  ExpectWeights(relief.Edge(0, 5), Star({ 0, 5 }, 1. / 2., {}, 0));
  // On the next level it is not next to the edge any more: midpoint of 01 is Blend with 2 + 6.
  const Subdivided<int> next = RefineOnce(relief.Level);
  const int middle = 6 + FindEdge(relief.Level.Level.Complex, 0, 1);
  const int half = FindEdge(next.Level.Complex, 0, middle);
  EXPECT_EQ(next.Level.Strata.EdgeRings.GetSize(half), 3);
  EXPECT_EQ(next.Level.Strata.VertexRings.GetSize(middle), 8);
}

TEST(CoreMasks, CrossingLines)
{
  const Rows1 lines(FindInZoo("CrossingLines"));
  ExpectWeights(lines.Vertex(0), Star({ 0 }, 9. / 16., { 1, 2, 3, 4 }, 7. / 64.));
  ExpectWeights(lines.Edge(0, 3), Star({ 0, 3 }, 1. / 2., {}, 0));
  ExpectWeights(lines.Vertex(3), { { 3, 1. } });
}

TEST(CoreMasks, TentOnTet)
{
  // The tetrahedron's boundary edge 01 is no joint: the lines 04 and 41 do not make it one.
  const Rows1 tent(FindInZoo("TentOnTet"));
  ExpectWeights(tent.Edge(0, 1), Star({ 0, 1 }, 3. / 8., { 2, 3 }, 1. / 8.));
  ExpectWeights(tent.Vertex(0), Star({ 0 }, 9. / 16., { 1, 2, 3, 4 }, 7. / 64.));
  ExpectWeights(tent.Vertex(4), Star({ 4 }, 3. / 4., { 0, 1 }, 1. / 8.));
}

TEST(CoreMasks, SingularSimplices)
{
  // Creases 02 and 21 on the surface of an octahedron, a corner at 5.
  const Rows1 crease(FindInZoo("CreasedSurface"));
  ExpectWeights(crease.Vertex(2), Star({ 2 }, 3. / 4., { 0, 1 }, 1. / 8.));
  ExpectWeights(crease.Vertex(0), { { 0, 1. } });
  ExpectWeights(crease.Vertex(5), { { 5, 1. } });
  ExpectWeights(crease.Vertex(3), Star({ 3 }, 5. / 8., { 0, 1, 4, 5 }, 3. / 32.));
  ExpectWeights(crease.Edge(0, 2), Star({ 0, 2 }, 1. / 2., {}, 0));
  ExpectWeights(crease.Edge(0, 4), Star({ 0, 4 }, 3. / 8., { 2, 3 }, 1. / 8.));
  // Two singular triangles inside an octahedron meet in its axis 01.
  const Rows1 sheet(FindInZoo("SingularSheetInside"));
  ExpectWeights(sheet.Edge(0, 1), Star({ 0, 1 }, 3. / 8., { 2, 4 }, 1. / 8.));
  ExpectWeights(sheet.Edge(0, 2), Star({ 0, 2 }, 1. / 2., {}, 0));
  ExpectWeights(sheet.Vertex(0), Star({ 0 }, 3. / 4., { 2, 4 }, 1. / 8.));
  ExpectWeights(sheet.Vertex(3), Star({ 3 }, 5. / 8., { 0, 1, 2, 4 }, 3. / 32.));
  // A crease that ends: a corner, or as if it were not there.
  const Mesh end = FindInZoo("CreaseEnd");
  ExpectWeights(Rows1(end).Vertex(0), { { 0, 1. } });
  StrataOptions darts;
  darts.DartEnds = true;
  const Subdivided<int> dart = Build<int>(end.Cells, end.Singular, darts);
  EXPECT_EQ(dart.Level.Strata.Vertices[0].GetRule(), Rule::Surface);
  EXPECT_EQ(GetRing(dart.Level.Strata.VertexRings, 0), (Tuple{ 2, 3, 4, 5 }));
}

namespace
{

void ExpectMask(const Mask& mask, double own, double ring)
{
  EXPECT_EQ(mask.Own, own);
  EXPECT_EQ(mask.Ring, ring);
}

}

/// What meshes do not reach: masks for rings that a rule never has are finite, too.
TEST(CoreMasks, EachRuleHasAMaskForEachRing)
{
  for (Rule rule :
    { Rule::Corner, Rule::Curve, Rule::Surface, Rule::Solid, Rule::Blend, Rule::RegularEdge })
  {
    ExpectMask(EdgeMask(rule, 0), 1. / 2., 0.);
  }
  ExpectMask(EdgeMask(Rule::Solid, 1), 5. / 16., 3. / 8.);
  ExpectMask(EdgeMask(Rule::Curve, 2), 1. / 2., 0.);
  ExpectMask(EdgeMask(Rule::Corner, 2), 1. / 2., 0.);
  ExpectMask(VertexMask(Rule::Corner, 2, LoopWeights::Warren), 1., 0.);
}
