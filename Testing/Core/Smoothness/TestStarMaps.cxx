// SPDX-License-Identifier: BSD-3-Clause
// Characteristic maps as meshes: regular ones are lattices, a step repeats them with the
// eigenvalues, symmetric stars have symmetric ones, and where they fold a Jacobian is negative.
#include "Precompiled.h"

#include "Core/Rules/Pi.h"
#include "Core/Smoothness/SolidMaps.h"
#include "Core/Smoothness/SurfaceStars.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"

using namespace subdivision;

namespace
{

using Box = BoxSplineScheme<int>;
using Oct = TetOctScheme<int>;
using Scheme = SurfaceSchemeKind;
using Point = StarMap::Point;

StarMap Map(Scheme scheme, int faces, int levels = 2,
  SurfaceStar::Kind kind = SurfaceStar::Kind::Closed, bool modified = true)
{
  SurfaceStar star;
  star.Scheme = scheme;
  star.Faces = faces;
  star.Where = kind;
  star.ModifiedBoundary = modified;
  return MapSurface(star, levels);
}

bool HasPoint(const StarMap& map, const Point& wanted)
{
  return std::any_of(map.Points.begin(), map.Points.end(),
    [&](const Point& point)
    {
      return std::abs(point[0] - wanted[0]) < 1e-7 && std::abs(point[1] - wanted[1]) < 1e-7 &&
        std::abs(point[2] - wanted[2]) < 1e-7;
    });
}

double FindLeast(const StarMap& map)
{
  return *std::min_element(map.Jacobians.begin(), map.Jacobians.end());
}
double FindMost(const StarMap& map)
{
  return *std::max_element(map.Jacobians.begin(), map.Jacobians.end());
}

/// The coordinate, on its axis, of the point on the positive axis at this ring; 0: there is none.
double FindOnAxis(const StarMap& map, int axis, double ring)
{
  for (std::size_t i = 0; i < map.Points.size(); ++i)
  {
    Point rest = map.Points[i];
    rest[axis] = 0.;
    if (std::abs(map.Rings[i] - ring) < 1e-9 && std::hypot(rest[0], rest[1], rest[2]) < 1e-9 &&
      map.Points[i][axis] > 0.)
    {
      return map.Points[i][axis];
    }
  }
  return 0.;
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

/// Eight tetrahedra around a vertex, with axes 1 and 2, 3 and 4, 5 and 6; those that are called y
/// are marked in all of them.
SolidStar MakeOctahedron()
{
  SolidStar star;
  for (const int x : { 1, 2 })
  {
    for (const int y : { 3, 4 })
    {
      for (const int z : { 5, 6 })
      {
        star.Tets.push_back({ { 0, x, y, z } });
      }
    }
  }
  return star;
}

}

TEST(StarMaps, RegularOnesAreLattices)
{
  const std::pair<Scheme, int> regular[] = { { Scheme::Loop, 6 }, { Scheme::ModifiedButterfly, 6 },
    { Scheme::CatmullClark, 4 }, { Scheme::FourEight, 4 }, { Scheme::SqrtThree, 6 } };
  for (const auto& [scheme, faces] : regular)
  {
    SCOPED_TRACE(static_cast<int>(scheme));
    const StarMap map = Map(scheme, faces);
    ASSERT_FALSE(map.IsEmpty());
    EXPECT_EQ(map.Dimension, 2);
    EXPECT_GT(map.Ends.size(), 50u);
    EXPECT_EQ(map.Ends.size(), map.Jacobians.size());
    EXPECT_EQ(map.Points.size(), map.Rings.size());
    EXPECT_NEAR(FindLeast(map), 1., 1e-7);
    EXPECT_NEAR(FindMost(map), 1., 1e-7);
    const double ring = scheme == Scheme::SqrtThree ? 1. / 3. : 1. / 2.;
    EXPECT_NEAR(FindOnAxis(map, 0, ring), ring, 1e-7);
  }
  const SolidStar inside{ 4, { { { 0, 1, 2, 3 } } } };
  for (const StarMap& map : { MapSolid<Box>(inside, 1), MapSolid<Oct>(inside, 1) })
  {
    ASSERT_FALSE(map.IsEmpty());
    EXPECT_EQ(map.Dimension, 3);
    EXPECT_GT(map.Ends.size(), 50u);
    EXPECT_GT(FindLeast(map), 0.);
    EXPECT_LT(FindMost(map), FindLeast(map) * (1. + 1e-6));
  }
}

// Kobbelt's figure 17 shows those of sqrt(3) for valences 3 to 9; here with all other schemes.
TEST(StarMaps, SurfacesOfAllValencesAreRegularAndSymmetric)
{
  for (const Scheme scheme : { Scheme::SqrtThree, Scheme::Loop, Scheme::CatmullClark,
         Scheme::ModifiedButterfly, Scheme::FourEight })
  {
    for (int k = 3; k <= 9; ++k)
    {
      SCOPED_TRACE(testing::Message() << "scheme " << static_cast<int>(scheme) << ", k " << k);
      const StarMap map = Map(scheme, k, scheme == Scheme::SqrtThree ? 1 : 2);
      ASSERT_FALSE(map.IsEmpty());
      EXPECT_GT(FindLeast(map), 0.);
      const double turn = 2. * Pi / k;
      for (const Point& point : map.Points)
      {
        EXPECT_TRUE(HasPoint(map,
          { { std::cos(turn) * point[0] - std::sin(turn) * point[1],
            std::sin(turn) * point[0] + std::cos(turn) * point[1], 0. } }));
        EXPECT_TRUE(HasPoint(map, { { point[0], -point[1], 0. } }));
      }
    }
  }
}

// A level more contains all points again, all smaller by one factor.
TEST(StarMaps, AStepRepeatsThem)
{
  for (const Scheme scheme :
    { Scheme::SqrtThree, Scheme::Loop, Scheme::CatmullClark, Scheme::FourEight })
  {
    for (const int k : { 3, 5, 8 })
    {
      SCOPED_TRACE(testing::Message() << "scheme " << static_cast<int>(scheme) << ", k " << k);
      const StarMap coarse = Map(scheme, k, 1);
      const StarMap fine = Map(scheme, k, 2);
      const double ring = scheme == Scheme::SqrtThree ? 1. / 3. : 1. / 2.;
      const double factor = FindOnAxis(fine, 0, ring * ring) / FindOnAxis(coarse, 0, ring);
      ASSERT_GT(factor, 0.1);
      ASSERT_LT(factor, 1.);
      for (const Point& point : coarse.Points)
      {
        EXPECT_TRUE(HasPoint(fine, { { factor * point[0], factor * point[1], 0. } }));
      }
    }
  }
}

// Beside curves a sector of k triangles fills half a plane.
TEST(StarMaps, SectorsFillHalfAPlane)
{
  for (int k = 2; k <= 9; ++k)
  {
    SCOPED_TRACE(k);
    const StarMap map = Map(Scheme::Loop, k, 2, SurfaceStar::Kind::Curve);
    ASSERT_FALSE(map.IsEmpty());
    EXPECT_GT(FindLeast(map), 0.);
    for (const Point& point : map.Points)
    {
      EXPECT_GT(point[1], -1e-9);
    }
  }
}

// Of all linear images the one is taken whose points are spread alike in all directions.
TEST(StarMaps, HaveEqualMoments)
{
  for (const StarMap& map : { Map(Scheme::Loop, 4, 2, SurfaceStar::Kind::Curve),
         Map(Scheme::CatmullClark, 5), MapSolid<Oct>(MakeEdge(3), 2) })
  {
    ASSERT_FALSE(map.IsEmpty());
    double moments[3][3] = {};
    for (const int corner : map.Corners)
    {
      for (int i = 0; i < map.Dimension; ++i)
      {
        for (int j = 0; j < map.Dimension; ++j)
        {
          moments[i][j] += map.Points[corner][i] * map.Points[corner][j];
        }
      }
    }
    for (int i = 0; i < map.Dimension; ++i)
    {
      for (int j = 0; j < map.Dimension; ++j)
      {
        EXPECT_NEAR(moments[i][j], i == j ? moments[0][0] : 0., 1e-9 * moments[0][0]);
      }
    }
  }
}

// Schaefer's figures 11 and 12: around a vertex, and along edges of n tetrahedra.
TEST(StarMaps, TetOct)
{
  const StarMap vertex = MapSolid<Oct>(MakeOctahedron(), 2);
  ASSERT_FALSE(vertex.IsEmpty());
  EXPECT_GT(FindLeast(vertex), 0.);
  for (int n = 3; n <= 10; ++n)
  {
    SCOPED_TRACE(n);
    const StarMap map = MapSolid<Oct>(MakeEdge(n), 2);
    ASSERT_FALSE(map.IsEmpty());
    EXPECT_GT(FindLeast(map), 0.);
    // Along the edge and across it maps shrink in different ways.
    const StarMap coarse = MapSolid<Oct>(MakeEdge(n), 1);
    const double along = FindOnAxis(map, 0, 1. / 4.) / FindOnAxis(coarse, 0, 1. / 2.);
    const double across = FindOnAxis(map, 1, 1. / 4.) / FindOnAxis(coarse, 1, 1. / 2.);
    EXPECT_GT(std::min(along, across), 0.1);
    EXPECT_LT(std::max(along, across), 1.);
    for (const Point& point : coarse.Points)
    {
      ASSERT_TRUE(HasPoint(map, { { along * point[0], across * point[1], across * point[2] } }));
    }
  }
  EXPECT_TRUE(MapSolid<Oct>(MakeEdge(11), 2).IsEmpty()); // l3 = l4
}

// The condition holds there, but the third eigenvector is even in all directions.
TEST(StarMaps, AJacobianIsNegativeWhereAMapFolds)
{
  const StarMap folded = MapSolid<Box>(MakeOctahedron(), 2);
  ASSERT_FALSE(folded.IsEmpty());
  EXPECT_LT(FindLeast(folded), -1e-3 * FindMost(folded));
  const StarMap other = MapSolid<Oct>(MakeOctahedron(), 2);
  ASSERT_FALSE(other.IsEmpty());
  EXPECT_GT(FindLeast(other), 0.);
}

// Faces are what repeats in dual schemes.
TEST(StarMaps, OfFacesInDualSchemes)
{
  for (const Scheme scheme : { Scheme::DooSabin, Scheme::Midedge })
  {
    for (int n = scheme == Scheme::Midedge ? 4 : 3; n <= 10; ++n)
    {
      SCOPED_TRACE(n);
      const StarMap map = Map(scheme, n);
      ASSERT_FALSE(map.IsEmpty());
      EXPECT_GT(FindLeast(map), 0.);
      EXPECT_EQ(std::count_if(map.Points.begin(), map.Points.end(),
                  [&](const Point& p)
                  {
                    const double angle = Pi / n;
                    return std::abs(std::hypot(p[0], p[1]) - 0.125 / std::cos(angle)) < 1e-9;
                  }),
        n); // the face in the middle is regular
      if (n == 4)
      {
        EXPECT_NEAR(FindLeast(map), 1., 1e-9);
        EXPECT_NEAR(FindMost(map), 1., 1e-9);
      }
      // A further level has the same points nearer to the middle, where rings are half as long.
      const StarMap finer = Map(scheme, n, 3);
      for (const Point& point : map.Points)
      {
        ASSERT_TRUE(HasPoint(finer, { { point[0] / 2., point[1] / 2., 0. } }));
      }
    }
  }
}

TEST(StarMaps, AreEmptyWhereThereIsNone)
{
  EXPECT_TRUE(Map(Scheme::DooSabin, 4, 2, SurfaceStar::Kind::Curve).IsEmpty());
  EXPECT_TRUE(Map(Scheme::Midedge, 3).IsEmpty()); // l3 = 1/4, too
  EXPECT_TRUE(Map(Scheme::Loop, 2).IsEmpty());
  EXPECT_TRUE(Map(Scheme::Loop, 1000).IsEmpty());
  EXPECT_TRUE(MapSolid<Box>(MakeEdge(8), 2).IsEmpty());
  EXPECT_TRUE(MapSolid<Box>(MakeEdge(101), 1).IsEmpty());
}
