// SPDX-License-Identifier: BSD-3-Clause
// Eigenvalues and characteristic maps of volume schemes: against Mathematics 9 and 10, and against
// each other where two ways lead to the same matrix.
#include "Precompiled.h"

#include "Core/Smoothness/SolidMaps.h"
#include "Core/Smoothness/SolidSpectra.h"

#include "Core/Solids/AllSchemes/VolumeSchemes.h"

using namespace subdivision;

namespace
{

using Box = BoxSplineScheme<int>;
using Oct = TetOctScheme<int>;

void ExpectValues(const SmoothnessFacts& facts, const std::vector<double>& values, double off)
{
  EXPECT_NEAR(facts.Eigenvalues[0], 1., 1e-10);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    EXPECT_NEAR(facts.Eigenvalues[i + 1], values[i], off) << "l" << i + 1;
  }
}

void ExpectSmooth(const SmoothnessFacts& facts)
{
  EXPECT_EQ(facts.Condition, Answer::Yes);
  EXPECT_EQ(facts.Regular, Answer::Yes);
  EXPECT_EQ(facts.Injective, Answer::Yes);
  EXPECT_GT(facts.Samples, 100);
}

/// n tetrahedra around an edge that all of them mark.
SolidStar MakeEdge(int n)
{
  SolidStar star;
  star.Corners = 2;
  for (int i = 0; i < n; ++i)
  {
    star.Tets.push_back({ { 0, 2 + i, 1, 2 + (i + 1) % n } });
  }
  return star;
}

/// The vertex with a triangulation of the sphere around it. Each tetrahedron marks the edge from
/// the vertex to the first corner of its triangle, unless the apex comes first: then that between
/// the first and the third.
SolidStar MakeVertex(const std::vector<std::array<int, 3>>& triangles)
{
  SolidStar star;
  for (const auto& [a, b, c] : triangles)
  {
    star.Tets.push_back({ { 0, b, a, c } });
  }
  return star;
}

/// Axes 1 and 2, 3 and 4, 5 and 6.
SolidStar MakeOctahedron(const std::array<int, 4>& order)
{
  SolidStar star;
  for (const int x : { 1, 2 })
  {
    for (const int y : { 3, 4 })
    {
      for (const int z : { 5, 6 })
      {
        const int corners[4] = { 0, x, y, z };
        star.Tets.push_back(
          { { corners[order[0]], corners[order[1]], corners[order[2]], corners[order[3]] } });
      }
    }
  }
  return star;
}

const std::vector<std::array<int, 3>> Tetrahedron = { { { 1, 2, 3 } }, { { 1, 2, 4 } },
  { { 1, 3, 4 } }, { { 2, 3, 4 } } };
const std::vector<std::array<int, 3>> DoublePyramid = { { { 1, 3, 4 } }, { { 1, 4, 5 } },
  { { 1, 5, 3 } }, { { 2, 3, 4 } }, { { 2, 4, 5 } }, { { 2, 5, 3 } } };

template <typename Scheme>
SmoothnessFacts FindSpectrum(const SolidStar& star)
{
  SimplexList list;
  for (const auto& tet : star.Tets)
  {
    list.Dimensions.push_back(3);
    list.Connectivity.insert(list.Connectivity.end(), tet.begin(), tet.end());
  }
  list.NumberOfPoints = 1 + *std::max_element(list.Connectivity.begin(), list.Connectivity.end());
  std::vector<CellRun> runs;
  Level<int> control;
  control.Complex = BuildComplex<int>(list, runs);
  control.Strata = BuildStrata(control.Complex, SingularSimplices(), StrataOptions());
  const typename Scheme::Level level = Scheme::Start(std::move(control));
  SmoothnessFacts facts;
  FindSpectra(level, 1, [](vtkIdType) { return vtkIdType(0); }, &facts);
  return facts;
}

}

TEST(SmoothnessOfSolids, TheLattice)
{
  const SolidStar star{ 4, { { { 0, 1, 2, 3 } } } };
  const std::vector<double> expected = { .5, .5, .5, .25, .25 };
  for (const SmoothnessFacts& facts :
    { ExamineSolid<Box>(star, true), ExamineSolid<Oct>(star, true) })
  {
    ExpectValues(facts, expected, 1e-6);
    ExpectSmooth(facts);
  }
}

TEST(SmoothnessOfSolids, EdgesThatAllTetrahedraMark)
{
  for (int n = 3; n <= 11; ++n)
  {
    SCOPED_TRACE(n);
    const SmoothnessFacts facts = ExamineSolid<Box>(MakeEdge(n), true);
    EXPECT_EQ(facts.Condition, n <= 7 ? Answer::Yes : Answer::No);
    if (n <= 7)
    {
      ExpectSmooth(facts);
    }
    else
    {
      EXPECT_EQ(facts.Regular, Answer::None);
    }
  }
  ExpectValues(ExamineSolid<Box>(MakeEdge(3), false), { .5, .4101, .4101, .3075 }, 5e-5);
  ExpectValues(ExamineSolid<Box>(MakeEdge(8), false), { .6111, .6111, .5, .5 }, 5e-5);
}

TEST(SmoothnessOfSolids, EdgesOfTheTetOctScheme)
{
  const double pairs[] = { .31702, .42812, .49479, .53563, .56194, .57972, .59223, .60135 };
  for (int n = 3; n <= 11; ++n)
  {
    SCOPED_TRACE(n);
    const SmoothnessFacts facts = ExamineSolid<Oct>(MakeEdge(n), true);
    EXPECT_EQ(facts.Condition, n <= 10 ? Answer::Yes : Answer::No);
    if (n <= 10)
    {
      ExpectSmooth(facts);
      EXPECT_NEAR(facts.Eigenvalues[n < 6 ? 2 : 1], pairs[n - 3], 5e-6);
      EXPECT_NEAR(facts.Eigenvalues[n < 6 ? 1 : 3], .5, 1e-8); // along the edge
    }
  }
}

TEST(SmoothnessOfSolids, Faces)
{
  const SolidStar same{ 3, { { { 0, 3, 1, 2 } }, { { 0, 4, 1, 2 } } } };
  const SolidStar other{ 3, { { { 0, 3, 1, 2 } }, { { 0, 4, 2, 1 } } } };
  const SmoothnessFacts smooth = ExamineSolid<Box>(same, true);
  ExpectValues(smooth, { .5, .5, .5, .25, .25 }, 1e-6);
  ExpectSmooth(smooth);
  const SmoothnessFacts rough = ExamineSolid<Box>(other, true);
  ExpectValues(rough, { .5121, .5, .5, .2737, .2678 }, 5e-5);
  ExpectSmooth(rough);
  for (const SolidStar& star : { same, other })
  {
    const SmoothnessFacts facts = ExamineSolid<Oct>(star, true);
    ExpectValues(facts, { .5, .5, .5, .25, .25 }, 1e-6);
    ExpectSmooth(facts);
  }
}

/// Of the box spline (24) fails for valence 4 and 5, of the tet/oct scheme it holds.
TEST(SmoothnessOfSolids, SmallValences)
{
  const SmoothnessFacts four = ExamineSolid<Box>(MakeVertex(Tetrahedron), true);
  ExpectValues(four, { .25, .1875, .1875, .1875 }, 1e-6);
  EXPECT_EQ(four.Condition, Answer::No);
  EXPECT_EQ(four.Regular, Answer::None);
  EXPECT_EQ(ExamineSolid<Box>(MakeVertex(DoublePyramid), true).Condition, Answer::No);
  const SmoothnessFacts other = ExamineSolid<Oct>(MakeVertex(Tetrahedron), true);
  ExpectValues(other, { .1759, .1759, .1759, .1632 }, 5e-5);
  ExpectSmooth(other);
  ExpectSmooth(ExamineSolid<Oct>(MakeVertex(DoublePyramid), true));
}

/// In the middle of a double pyramid the tet/oct scheme fails (24) from 8 sides on.
TEST(SmoothnessOfSolids, DoublePyramidsOfTheTetOctScheme)
{
  for (int n = 3; n <= 12; ++n)
  {
    SCOPED_TRACE(n);
    std::vector<std::array<int, 3>> triangles;
    for (int i = 0; i < n; ++i)
    {
      triangles.push_back({ { 1, 3 + i, 3 + (i + 1) % n } });
      triangles.push_back({ { 2, 3 + i, 3 + (i + 1) % n } });
    }
    const SmoothnessFacts facts = ExamineSolid<Oct>(MakeVertex(triangles), true);
    EXPECT_EQ(facts.Condition, n < 8 ? Answer::Yes : Answer::No);
    if (n == 8)
    {
      ExpectValues(facts, { .44305, .44305, .3056, .3056, .3056 }, 5e-5);
    }
  }
}

/// A vertex of valence 6 whose spokes y are marked in all four tetrahedra: (24) holds, but the
/// third eigenvector is even in all directions, and so maps opposite sides onto each other.
TEST(SmoothnessOfSolids, TheConditionAloneIsNotEnough)
{
  const SmoothnessFacts facts = ExamineSolid<Box>(MakeOctahedron({ { 0, 1, 2, 3 } }), true);
  EXPECT_EQ(facts.Condition, Answer::Yes);
  EXPECT_EQ(facts.Regular, Answer::No);
  EXPECT_EQ(facts.Injective, Answer::No);
  EXPECT_TRUE(facts.Fails());
  ExpectSmooth(ExamineSolid<Oct>(MakeOctahedron({ { 0, 1, 2, 3 } }), true));
}

TEST(SmoothnessOfSolids, BothWaysGiveTheSameEigenvalues)
{
  const SolidStar stars[] = { MakeVertex(Tetrahedron), MakeVertex(DoublePyramid),
    MakeOctahedron({ { 0, 1, 2, 3 } }), MakeOctahedron({ { 1, 0, 2, 3 } }) };
  for (const SolidStar& star : stars)
  {
    const auto compare = [](const SmoothnessFacts& one, const SmoothnessFacts& other)
    {
      EXPECT_EQ(one.Condition, other.Condition);
      EXPECT_EQ(one.Valence, other.Valence);
      ExpectValues(one, { other.Eigenvalues.begin() + 1, other.Eigenvalues.end() }, 1e-8);
    };
    compare(ExamineSolid<Box>(star, false), FindSpectrum<Box>(star));
    compare(ExamineSolid<Oct>(star, false), FindSpectrum<Oct>(star));
  }
}

TEST(SmoothnessOfSolids, TooMuchIsNotExamined)
{
  EXPECT_EQ(ExamineSolid<Oct>(MakeEdge(101), true).Eigenvalues[0], 0.);
  EXPECT_NEAR(ExamineSolid<Oct>(MakeEdge(60), false).Eigenvalues[0], 1., 1e-9);
  EXPECT_EQ(ExamineSheet({ 0, 599, false }).Eigenvalues[0], 0.);
  std::vector<std::array<int, 3>> many; // a double pyramid
  for (int i = 0; i < 700; ++i)
  {
    for (const int apex : { 1, 2 })
    {
      many.push_back({ { apex, 3 + i, 3 + (i + 1) % 700 } });
    }
  }
  const SmoothnessFacts facts = FindSpectrum<Box>(MakeVertex(many));
  EXPECT_EQ(facts.Eigenvalues[0], 0.);
  EXPECT_EQ(facts.Condition, Answer::None);
  EXPECT_EQ(facts.Valence, 702);
}

TEST(SmoothnessOfSolids, SheetsAtCurvesAndCorners)
{
  for (int k = 1; k <= 10; ++k)
  {
    SCOPED_TRACE(k);
    const SmoothnessFacts curve = ExamineSheet({ 0, k, false });
    EXPECT_EQ(curve.Condition, k <= 5 ? Answer::Yes : Answer::No);
    EXPECT_EQ(ExamineSheet({ 0, k, true }).Condition, k <= 2 ? Answer::Yes : Answer::No);
    if (k > 3)
    {
      EXPECT_NEAR(curve.Eigenvalues[1], 3. / 8. + std::cos(3.14159265358979 / k) / 4., 1e-10);
    }
  }
}
