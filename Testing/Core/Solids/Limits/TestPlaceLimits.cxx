// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestPlaceLimits.cxx
 * Places of triangles beside those that Loop's scheme for polygon meshes finds in another way: by
 * steps of what is around a face, and with other tables.
 */
#include "Core/Solids/Complex/SimplicialComplex.h"
#include "Core/Solids/Limits/PlaceLimits.h"
#include "Core/Solids/Scheme/SemiSharp.h"
#include "Core/Solids/Strata/Strata.h"
#include "Core/Surfaces/Places/SurfacePlaces.h"
#include "SurfacePlaceTools.h"

using namespace surfacetools;

namespace
{

/// A closed surface: at six vertices there are four triangles, at all others six.
Walk MakeOctahedron(int steps)
{
  Model model;
  model.Points = { { 1., 0., 0. }, { -1., 0., 0. }, { 0., 1., 0. }, { 0., -1., 0. }, { 0., 0., 1. },
    { 0., 0., -1. } };
  model.Faces = { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 },
    { 3, 1, 5 }, { 0, 3, 5 } };
  Walk walk(model, SurfaceSchemeKind::Loop);
  for (int i = 0; i < steps; ++i)
  {
    walk.Step();
  }
  return walk;
}

Level<int> MakeComplexLevel(const PolygonMesh<int>& mesh)
{
  SimplexList cells;
  cells.NumberOfPoints = mesh.NumberOfVertices;
  cells.Dimensions.assign(static_cast<std::size_t>(mesh.NumberOfFaces), 2);
  cells.Connectivity.assign(mesh.Vertices.begin(), mesh.Vertices.end());
  std::vector<CellRun> runs;
  Level<int> level;
  level.Complex = BuildComplex<int>(cells, runs);
  level.Strata = BuildStrata(level.Complex, SingularSimplices(), StrataOptions());
  return level;
}

/// The same places of both, at least 1/64 away from corners; corners come in any order.
struct PlacesOfBoth
{
  std::vector<SurfacePlace<int>> OfFaces;
  std::vector<LimitPlace<int>> OfSimplices;

  explicit PlacesOfBoth(const PolygonMesh<int>& mesh)
  {
    std::mt19937 random(6);
    for (int i = 0; i < 12 * mesh.NumberOfFaces; ++i)
    {
      std::array<double, 3> weights{};
      do
      {
        std::generate(weights.begin(), weights.end(),
          [&random] { return std::pow(std::generate_canonical<double, 53>(random), 4.); });
        const double sum = std::accumulate(weights.begin(), weights.end(), 0.);
        std::transform(weights.begin(), weights.end(), weights.begin(),
          [sum](double weight) { return weight / sum; });
      } while (*std::max_element(weights.begin(), weights.end()) > 1. - 1. / 64.);
      SurfacePlace<int> ofFace;
      ofFace.Dimension = 2;
      ofFace.Part = i % static_cast<int>(mesh.NumberOfFaces);
      ofFace.At = { { weights[1], weights[2] } };
      this->OfFaces.push_back(ofFace);
      LimitPlace<int> ofSimplex;
      ofSimplex.Dimension = 2;
      std::array<int, 3> turned{ { 0, 1, 2 } };
      std::shuffle(turned.begin(), turned.end(), random);
      for (int k = 0; k < 3; ++k)
      {
        const int corner = turned[static_cast<std::size_t>(k)];
        ofSimplex.Corners[static_cast<std::size_t>(k)] = mesh.Vertices[3 * ofFace.Part + corner];
        ofSimplex.Order[static_cast<std::size_t>(corner)] = k;
      }
      ofSimplex.Parameters = { { weights[1], weights[2], 0. } };
      this->OfSimplices.push_back(ofSimplex);
    }
  }
};

/// One of PlaceParts over all vertices.
std::vector<double> TakeRow(const PlaceRows<int>& rows, vtkIdType place, int part)
{
  std::vector<double> row(static_cast<std::size_t>(rows.NumberOfColumns), 0.);
  for (int k = rows.Offsets[place]; k < rows.Offsets[place + 1]; ++k)
  {
    row[static_cast<std::size_t>(rows.Columns[k])] += rows.Weights[part][k];
  }
  return row;
}

}

/// With no step all corners of triangles have four triangles, with one step one corner or none,
/// with two there are triangles whose control points are all different.
TEST(PlaceLimits, TrianglesAreThoseOfLoop)
{
  for (const int steps : { 0, 1, 2, 3 })
  {
    const Walk walk = MakeOctahedron(steps);
    const PlacesOfBoth places(walk.Level.Mesh);
    const PlaceRows<int> expected = FindSurfacePlaces(
      *walk.Scheme, walk.Level, SharpCreases<int>(), places.OfFaces, PlaceDerivatives::Second);
    const PlaceRows<int> found = PlaceLimits<int>(MakeComplexLevel(walk.Level.Mesh),
      SemiSharpStages<int>(), places.OfSimplices, PlaceDerivatives::Second)
                                   .Rows;
    EXPECT_FALSE(found.HasPart(PlaceParts::First + 2));
    std::array<double, PlaceParts::Count> worst{};
    for (vtkIdType i = 0; i < expected.GetNumberOfPlaces(); ++i)
    {
      for (int part = 0; part < PlaceParts::Count; ++part)
      {
        if (found.HasPart(part))
        {
          const std::vector<double> a = TakeRow(found, i, part);
          const std::vector<double> b = TakeRow(expected, i, part);
          for (std::size_t c = 0; c < a.size(); ++c)
          {
            auto& most = worst[static_cast<std::size_t>(part)];
            most = std::max(most, std::abs(a[c] - b[c]));
          }
        }
      }
    }
    EXPECT_LT(worst[PlaceParts::Value], 1e-13) << steps;
    EXPECT_LT(std::max(worst[PlaceParts::First], worst[PlaceParts::First + 1]), 1e-11) << steps;
    EXPECT_LT(*std::max_element(worst.begin() + PlaceParts::Second, worst.end()), 1e-8) << steps;
  }
}

TEST(PlaceLimits, AreTheSameWithoutSecondDerivatives)
{
  const Walk walk = MakeOctahedron(2);
  const PlacesOfBoth places(walk.Level.Mesh);
  const Level<int> level = MakeComplexLevel(walk.Level.Mesh);
  const PlaceRows<int> all =
    PlaceLimits<int>(level, SemiSharpStages<int>(), places.OfSimplices, PlaceDerivatives::Second)
      .Rows;
  const PlaceRows<int> some =
    PlaceLimits<int>(level, SemiSharpStages<int>(), places.OfSimplices, PlaceDerivatives::First)
      .Rows;
  for (int part = 0; part < PlaceParts::Count; ++part)
  {
    ASSERT_EQ(some.HasPart(part), part < PlaceParts::First + 2) << part;
    for (vtkIdType i = 0; i < all.GetNumberOfPlaces() && some.HasPart(part); ++i)
    {
      EXPECT_EQ(TakeRow(some, i, part), TakeRow(all, i, part)) << "place " << i;
    }
  }
}

/// At every distance from an extraordinary vertex derivatives have the precision of numbers of
/// their own size, which is that of (2 lambda)^k at 2^-k, of second ones of (4 lambda)^k, with the
/// second eigenvalue lambda.
TEST(PlaceLimits, DerivativesNearExtraordinaryVerticesAreThoseOfLoop)
{
  for (const int n : { 3, 4, 5, 7, 12, 20 })
  {
    const Walk walk(MakeStar(n, true), SurfaceSchemeKind::Loop);
    std::vector<SurfacePlace<int>> ofFaces;
    std::vector<LimitPlace<int>> ofSimplices;
    for (int k = 1; k <= 48; ++k)
    {
      for (const double turn : { 0.25, 0.5, 0.875 })
      {
        SurfacePlace<int> ofFace;
        ofFace.Dimension = 2;
        ofFace.At = { { std::ldexp(1. - turn, -k), std::ldexp(turn, -k) } };
        ofFaces.push_back(ofFace);
        LimitPlace<int> ofSimplex;
        ofSimplex.Dimension = 2;
        std::copy_n(walk.Level.Mesh.Vertices.begin(), 3, ofSimplex.Corners.begin());
        ofSimplex.Parameters = { { ofFace.At[0], ofFace.At[1], 0. } };
        ofSimplices.push_back(ofSimplex);
      }
    }
    const PlaceRows<int> expected = FindSurfacePlaces(
      *walk.Scheme, walk.Level, SharpCreases<int>(), ofFaces, PlaceDerivatives::Second);
    const PlaceRows<int> found = PlaceLimits<int>(MakeComplexLevel(walk.Level.Mesh),
      SemiSharpStages<int>(), ofSimplices, PlaceDerivatives::Second)
                                   .Rows;
    for (vtkIdType i = 0; i < expected.GetNumberOfPlaces(); ++i)
    {
      for (int part = 0; part < PlaceParts::Count; ++part)
      {
        ASSERT_EQ(found.HasPart(part), part != PlaceParts::First + 2);
        if (!found.HasPart(part))
        {
          continue;
        }
        const std::vector<double> a = TakeRow(found, i, part);
        const std::vector<double> b = TakeRow(expected, i, part);
        double size = 0.;
        double error = 0.;
        for (std::size_t c = 0; c < a.size(); ++c)
        {
          size = std::max(size, std::abs(b[c]));
          error = std::max(error, std::abs(a[c] - b[c]));
        }
        EXPECT_LT(error, 1e-12 * size) << n << " triangles, place " << i << ", part " << part;
      }
    }
  }
}
