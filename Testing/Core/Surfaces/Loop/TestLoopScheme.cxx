// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 5 and 12: the rows of Loop's scheme, number by number.
#include "SchemeTools.h"

#include "Core/Rules/Pi.h"
#include "Core/Surfaces/Loop/LoopScheme.h"

using namespace surfacetools;

namespace
{

class Surface : public SchemeRows
{
public:
  explicit Surface(const Model& model, const SurfaceFeatures& features = SurfaceFeatures())
    : SchemeRows(SurfaceSchemeKind::Loop, model, features)
  {
  }
};

/// A vertex with one weight and a ring with another.
Weights Star(double own, const std::vector<int>& ring, double weight)
{
  Weights weights{ { 0, own } };
  for (int member : ring)
  {
    weights[member] = weight;
  }
  return weights;
}

std::vector<int> Count(int first, int size)
{
  std::vector<int> ids(static_cast<std::size_t>(size));
  std::iota(ids.begin(), ids.end(), first);
  return ids;
}

/// Two poles, 0 and n + 1, and a closed ring of vertices 1 to n, each of which has 4 triangles.
Model MakeBipyramid(int n)
{
  Model model;
  model.Points.push_back({ 0., 0., 0. });
  for (int j = 0; j < n; ++j)
  {
    const double t = 2. * Pi * j / n;
    model.Points.push_back({ std::cos(t), std::sin(t), 0. });
    model.Faces.push_back({ 0, 1 + j, 1 + (j + 1) % n });
    model.Faces.push_back({ n + 1, 1 + (j + 1) % n, 1 + j });
  }
  model.Points.push_back({ 0., 0., -1. });
  return model;
}

/// k triangles around vertex 0 on the boundary, which take an angle in the plane, and k more behind
/// them around vertex k + 2. The inner ones of the ring 1 to k + 1 lie inside the surface.
Model MakeHalf(int k, double angle)
{
  Model model;
  model.Points.push_back({ 0., 0., 0. });
  for (int j = 0; j <= k; ++j)
  {
    model.Points.push_back({ std::cos(angle * j / k), std::sin(angle * j / k), 0. });
  }
  for (int j = 1; j <= k; ++j)
  {
    model.Faces.push_back({ 0, j, j + 1 });
    model.Faces.push_back({ k + 2, j + 1, j });
  }
  model.Points.push_back({ 0., 0., 1. });
  return model;
}

/// Edge j of a sector, next to edges j - 1 and j + 1, before the flatness modification.
Weights EdgeOfSector(int j, double own, double other)
{
  return { { 0, own }, { 1 + j, other }, { j, 0.125 }, { 2 + j, 0.125 } };
}

/// 1/2 - 1/4 cos t, by hand, where a curve has 1 to 6 triangles on one side.
const double GammaOfCurve[7] = { 0., 0.75, 0.5, 0.375, 0.3232233047033631, 0.2977457514062631,
  0.2834936490538903 };

}

// ---------------------------------------------------------------- steps

TEST(SurfaceLoop, VertexInside)
{
  const std::map<int, std::pair<double, double>> expected = { { 3, { 7. / 16., 3. / 16. } },
    { 4, { 5. / 8., 3. / 32. } }, { 5, { 5. / 8., 3. / 40. } }, { 6, { 5. / 8., 1. / 16. } },
    { 7, { 5. / 8., 3. / 56. } }, { 8, { 5. / 8., 3. / 64. } } };
  for (const auto& entry : expected)
  {
    const int n = entry.first;
    const Surface surface(MakeBipyramid(n));
    for (const bool modified : { true, false })
    {
      ExpectRow(surface.GetRow(0, modified),
        Star(entry.second.first, Count(1, n), entry.second.second), "valence " + std::to_string(n));
    }
  }
}

TEST(SurfaceLoop, VertexOnABoundaryACreaseOrACorner)
{
  const Weights curve = { { 0, 0.75 }, { 1, 0.125 }, { 5, 0.125 } };
  ExpectRow(Surface(MakeHalf(4, Pi)).GetRow(0), curve, "boundary");
  Model corner = MakeHalf(4, Pi);
  corner.Corners = { 0 };
  ExpectRow(Surface(corner).GetRow(0), { { 0, 1. } }, "flagged");
  Model crease = MakeBipyramid(7);
  crease.Lines = { { 0, 1 } };
  ExpectRow(Surface(crease).GetRow(0), { { 0, 1. } }, "end of a crease");
  SurfaceFeatures dart;
  dart.DartEnds = true;
  ExpectRow(Surface(crease, dart).GetRow(0), Star(5. / 8., Count(1, 7), 3. / 56.), "dart");
  crease.Lines.push_back({ 5, 0 });
  ExpectRow(Surface(crease).GetRow(0), curve, "crease");
  crease.Lines.push_back({ 0, 2 });
  ExpectRow(Surface(crease).GetRow(0), { { 0, 1. } }, "three creases");
  Model lines = MakeBipyramid(3);
  lines.Points.resize(8);
  lines.Lines = { { 5, 6 }, { 6, 7 } };
  ExpectRow(Surface(lines).GetRow(6), { { 6, 0.75 }, { 5, 0.125 }, { 7, 0.125 } }, "lines");
  ExpectRow(Surface(lines).GetRow(5), { { 5, 1. } }, "end of lines");
  ExpectRow(Surface(lines).GetEdgeRow(5, 6), { { 5, 0.5 }, { 6, 0.5 } }, "line");
}

TEST(SurfaceLoop, EdgeInsideAndOnACurve)
{
  const Surface grid(MakeSheet(4, 4, true, { 1., 0., 0. }, { 0., 1., 0. }));
  const Surface half(MakeHalf(5, Pi));
  Model crease = MakeBipyramid(6);
  crease.Lines = { { 0, 1 }, { 0, 4 } };
  const Surface creased(crease);
  for (const bool modified : { true, false })
  {
    ExpectRow(grid.GetEdgeRow(12, 13, modified),
      { { 12, 0.375 }, { 13, 0.375 }, { 8, 0.125 }, { 17, 0.125 } }, "inside");
    ExpectRow(half.GetEdgeRow(3, 4, modified),
      { { 3, 0.375 }, { 4, 0.375 }, { 0, 0.125 }, { 7, 0.125 } }, "across the boundary's vertex");
    ExpectRow(half.GetEdgeRow(0, 1, modified), { { 0, 0.5 }, { 1, 0.5 } }, "boundary");
    ExpectRow(creased.GetEdgeRow(0, 4, modified), { { 0, 0.5 }, { 4, 0.5 } }, "crease");
  }
}

TEST(SurfaceLoop, EdgeNextToABoundary)
{
  for (int k = 2; k <= 6; ++k)
  {
    const Surface surface(MakeHalf(k, Pi));
    const double g = GammaOfCurve[k];
    for (int j = 1; j < k; ++j)
    {
      const std::string what = std::to_string(k) + " triangles, edge " + std::to_string(j);
      ExpectRow(surface.GetEdgeRow(0, 1 + j), EdgeOfSector(j, 0.75 - g, g), what);
      ExpectRow(surface.GetEdgeRow(0, 1 + j, false), EdgeOfSector(j, 0.375, 0.375), what);
    }
  }
  // A vertex of one triangle has no smooth edge. The edge across from it follows its own ends, each
  // of two triangles: 1/4 and 1/2, and so 3/8 in the mean.
  Model ear = MakeHalf(2, Pi);
  ear.Faces = { { 0, 1, 2 }, { 1, 3, 2 } };
  const Weights across = { { 1, 0.375 }, { 2, 0.375 }, { 0, 0.125 }, { 3, 0.125 } };
  ExpectRow(Surface(ear).GetEdgeRow(1, 2), across, "one triangle");
  ExpectRow(Surface(ear).GetRow(0), { { 0, 0.75 }, { 1, 0.125 }, { 2, 0.125 } }, "the ear");
}

// The number of triangles of its own side counts, not that of the other.
TEST(SurfaceLoop, EdgeNextToACrease)
{
  ForEdgesNextToACrease(MakeBipyramid,
    [](const Model& model, const SurfaceFeatures& features, int j, int side)
    {
      const Surface surface(model, features);
      const int n = static_cast<int>(model.Points.size()) - 2;
      const double g = GammaOfCurve[side];
      const int after = 1 + (j + 1) % n;
      ExpectRow(surface.GetEdgeRow(0, 1 + j),
        { { 0, 0.75 - g }, { 1 + j, g }, { j, 0.125 }, { after, 0.125 } }, "modified");
      ExpectRow(surface.GetEdgeRow(0, 1 + j, false),
        { { 0, 0.375 }, { 1 + j, 0.375 }, { j, 0.125 }, { after, 0.125 } }, "plain");
    });
  // The end of a crease is a corner without sectors: the plain rule.
  Model model = MakeBipyramid(5);
  model.Lines = { { 0, 1 } };
  ExpectRow(Surface(model).GetEdgeRow(0, 3), EdgeOfSector(2, 0.375, 0.375), "end of a crease");
}

TEST(SurfaceLoop, EdgeWithBothEndsOnCurves)
{
  // 4 triangles at one end, 2 at the other.
  const Surface surface(MakeFan(4, true));
  const double g = GammaOfCurve[4];
  const Weights mean = { { 0, (0.75 - g + 0.5) / 2. }, { 2, (g + 0.25) / 2. }, { 1, 0.125 },
    { 3, 0.125 } };
  ExpectRow(surface.GetEdgeRow(0, 2), mean, "the mean of two masks");
  ExpectRow(surface.GetEdgeRow(0, 2, false), EdgeOfSector(1, 0.375, 0.375), "plain");
}

// ---------------------------------------------------------------- corners

TEST(SurfaceLoop, EdgeAtAConvexCorner)
{
  // 1/2 - 1/4 cos(alpha / k); alpha is kept in [pi/8, 7pi/8].
  const std::tuple<int, double, double> cases[] = { { 2, Pi / 2., 0.3232233047033631 },
    { 3, Pi / 2., 0.2834936490538903 }, { 2, 2. * Pi / 3., 0.375 }, { 2, 0.2, 0.2548036798991924 },
    { 2, 3.1, 0.4512274194959679 }, { 4, Pi, 0.3067473866593158 } };
  for (const auto& [k, angle, g] : cases)
  {
    Model model = MakeHalf(k, angle);
    model.Corners = { 0 };
    const Surface surface(model);
    for (int j = 1; j < k; ++j)
    {
      const std::string what = "angle " + std::to_string(angle) + " edge " + std::to_string(j);
      ExpectRow(surface.GetEdgeRow(0, 1 + j), EdgeOfSector(j, 0.75 - g, g), what);
      ExpectRow(surface.GetEdgeRow(0, 1 + j, false), EdgeOfSector(j, 0.375, 0.375), what);
    }
  }
}

// Sectors of 2, 3 and 4 faces of 40 degrees; 160 degrees is more than 7/8 pi.
TEST(SurfaceLoop, EachSectorOfACornerHasItsOwnAngle)
{
  Model model = MakeBipyramid(9);
  model.Lines = { { 0, 1 }, { 0, 3 }, { 0, 6 } };
  SurfaceFeatures features;
  features.DartEnds = true;
  const Surface surface(model, features);
  const double of40 = 0.5 - 0.25 * 0.766044443118978;
  const double of39 = 0.5 - 0.25 * 0.773010453362737; // cos(7pi/32)
  ExpectRow(surface.GetEdgeRow(0, 2), EdgeOfSector(1, 0.75 - of40, of40), "of two");
  ExpectRow(surface.GetEdgeRow(0, 5), EdgeOfSector(4, 0.75 - of40, of40), "of three");
  ExpectRow(surface.GetEdgeRow(0, 8), EdgeOfSector(7, 0.75 - of39, of39), "of four");
}

TEST(SurfaceLoop, ThirdEigenvalueAtCorners)
{
  const auto scheme = MakeLoopScheme<int>(true, LoopWeights::Warren);
  EXPECT_NEAR(scheme->GetThirdEigenvalue(3, 1.5 * Pi), 5. / 8., 1e-15);
  EXPECT_NEAR(scheme->GetThirdEigenvalue(2, 1.5 * Pi), 0.5 + std::sqrt(2.) / 8., 1e-15);
  EXPECT_NEAR(scheme->GetThirdEigenvalue(4, Pi / 2.), 0.4458068121688152, 1e-15);
  EXPECT_NEAR(scheme->GetThirdEigenvalue(3, Pi), 0.5, 1e-15);
}

// Three triangles that take 270 degrees: t = 90 degrees, g = 1/2, l3 = 5/8 and s = 3/5. The plane
// of the curves has its point at v - (r3 - v)/2 for edge 1 and v - (r0 - v)/2 for edge 2.
TEST(SurfaceLoop, FlatnessAtAConcaveCorner)
{
  Model model = MakeHalf(3, 1.5 * Pi);
  model.Corners = { 0 };
  const Surface surface(model);
  ExpectRow(surface.GetEdgeRow(0, 2),
    { { 0, 1. }, { 2, 0.2 }, { 1, 0.05 }, { 3, 0.05 }, { 4, -0.3 } }, "edge 1");
  ExpectRow(surface.GetEdgeRow(0, 3),
    { { 0, 1. }, { 3, 0.2 }, { 4, 0.05 }, { 2, 0.05 }, { 1, -0.3 } }, "edge 2");
  ExpectRow(surface.GetEdgeRow(0, 2, false), EdgeOfSector(1, 0.375, 0.375), "plain");
  ExpectRow(surface.GetEdgeRow(2, 3), { { 2, 0.375 }, { 3, 0.375 }, { 0, 0.125 }, { 5, 0.125 } },
    "not at the corner");
  // The other ends on the boundary ask for a mask too, of two triangles, but for no plane.
  Model fan = model;
  fan.Points.pop_back();
  fan.Faces = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 } };
  ExpectRow(Surface(fan).GetEdgeRow(0, 2),
    { { 0, 1.05 }, { 2, 0.15 }, { 1, 0.05 }, { 3, 0.05 }, { 4, -0.3 } }, "both ends on curves");
}

// In the plane of the corner the point lies at half the angle's unit vector: weights by the law of
// sines. Clamped angles are those of both t and the plane.
TEST(SurfaceLoop, FlatnessOfConcaveAngles)
{
  for (int k = 2; k <= 6; ++k)
  {
    for (const double given : { 3.2, 4., 5., 6.1 })
    {
      Model model = MakeHalf(k, given);
      model.Corners = { 0 };
      const Surface surface(model);
      const double angle = std::max(9. * Pi / 8., std::min(given, 15. * Pi / 8.));
      const double t = angle / k;
      const double g = 0.5 - std::cos(t) / 4.;
      const double s = 1. - 0.25 / (0.5 + (std::cos(Pi / k) - std::cos(t)) / 4.);
      for (int j = 1; j < k; ++j)
      {
        const double first = std::sin(angle - j * t) / (2. * std::sin(angle));
        const double last = std::sin(j * t) / (2. * std::sin(angle));
        ExpectRow(surface.GetEdgeRow(0, 1 + j),
          Flatten(EdgeOfSector(j, 0.75 - g, g), k, s, first, last),
          std::to_string(k) + " faces, angle " + std::to_string(given));
      }
    }
  }
}

TEST(SurfaceLoop, FlatnessThatIsGiven)
{
  // At a convex corner there is none by default. 90 degrees, two faces, s = 1/2.
  Model model = MakeHalf(2, 1.);
  model.Corners = { 0 };
  const Surface convex(model, GiveShape(model.Points.size(), { 0 }, Pi / 2., 0.5));
  const double r = std::sqrt(2.);
  const double g = 0.5 - r / 8.;
  ExpectRow(convex.GetEdgeRow(0, 2),
    { { 0, 0.5 * (0.75 - g) + 0.5 - r / 4. }, { 2, g / 2. }, { 1, 0.0625 + r / 8. },
      { 3, 0.0625 + r / 8. } },
    "convex");
  const Surface none(model, GiveShape(model.Points.size(), { 0 }, 1.5 * Pi, 0.));
  const double wide = 0.5 + r / 8.; // t is 135 degrees
  ExpectRow(none.GetEdgeRow(0, 2), EdgeOfSector(1, 0.75 - wide, wide), "concave");
}

// Corners 0 and 2, each of three triangles and 270 degrees: both have s = 3/5.
TEST(SurfaceLoop, TwoConcaveCornersMeetInTheMean)
{
  Model model;
  model.Points = MakeRandomPoints(6, 1);
  model.Faces = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 }, { 2, 5, 3 } };
  model.Corners = { 0, 2 };
  const Surface surface(model, GiveShape(6, { 0, 2 }, 1.5 * Pi));
  ExpectRow(surface.GetEdgeRow(0, 2),
    { { 0, 0.6 }, { 2, 0.6 }, { 1, 0.05 }, { 3, 0.05 }, { 4, -0.15 }, { 5, -0.15 } }, "mean");
}

// What the rows are for: linear functions are halved, the third wave is quartered.
TEST(SurfaceLoop, WavesInASectorOfAConcaveCorner)
{
  for (int k = 2; k <= 6; ++k)
  {
    const double angle = 4.5;
    Model model = MakeHalf(k, angle);
    model.Corners = { 0 };
    const Surface surface(model);
    for (int j = 1; j < k; ++j)
    {
      double cosine = 0.;
      double sine = 0.;
      double third = 0.;
      for (const auto& entry : surface.GetEdgeRow(0, 1 + j))
      {
        const int i = entry.first - 1;
        cosine += i < 0 ? 0. : entry.second * std::cos(i * angle / k);
        sine += i < 0 ? 0. : entry.second * std::sin(i * angle / k);
        third += i < 0 ? 0. : entry.second * std::sin(i * Pi / k);
      }
      EXPECT_NEAR(cosine, std::cos(j * angle / k) / 2., 1e-14) << k;
      EXPECT_NEAR(sine, std::sin(j * angle / k) / 2., 1e-14) << k;
      EXPECT_NEAR(third, std::sin(j * Pi / k) / 4., 1e-14) << k;
    }
  }
}
