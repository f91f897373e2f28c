// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 12: the rows of Catmull and Clark's scheme, number by number.
#include "SchemeTools.h"

#include "Core/Rules/Pi.h"
#include "Core/Surfaces/CatmullClark/CatmullClarkScheme.h"

using namespace surfacetools;

namespace
{

class Surface : public SchemeRows
{
public:
  explicit Surface(const Model& model, const SurfaceFeatures& features = SurfaceFeatures())
    : SchemeRows(SurfaceSchemeKind::CatmullClark, model, features)
  {
  }
};

/// Quads around vertex 0, all around it: edges lead to 1 to n, quad j lies between edges j and
/// j + 1, opposite corners are n + 1 to 2n. n quads more behind them, around vertex 2n + 1.
Model MakeTrapezohedron(int n)
{
  Model model;
  model.Points.push_back({ 0., 0., 0. });
  for (const double radius : { 1., 1.5 })
  {
    for (int j = 0; j < n; ++j)
    {
      const double t = 2. * Pi * (radius > 1. ? j + 0.5 : j) / n;
      model.Points.push_back({ radius * std::cos(t), radius * std::sin(t), 0. });
    }
  }
  model.Points.push_back({ 0., 0., -1. });
  for (int j = 0; j < n; ++j)
  {
    model.Faces.push_back({ 0, 1 + j, 1 + n + j, 1 + (j + 1) % n });
  }
  for (int j = 0; j < n; ++j)
  {
    const int next = (j + 1) % n;
    model.Faces.push_back({ 2 * n + 1, 1 + n + next, 1 + next, 1 + n + j });
  }
  return model;
}

/// k quads around vertex 0 on the boundary, which take an angle in the plane: edges lead to 1 to
/// k + 1, opposite corners are k + 2 to 2k + 1. With k - 1 quads more the inner ends lie inside.
Model MakeHalf(int k, double angle, bool closed = true)
{
  Model model;
  model.Points.push_back({ 0., 0., 0. });
  for (int j = 0; j <= k; ++j)
  {
    model.Points.push_back({ std::cos(angle * j / k), std::sin(angle * j / k), 0. });
  }
  for (int j = 0; j < k; ++j)
  {
    const double t = angle * (j + 0.5) / k;
    model.Points.push_back({ 1.5 * std::cos(t), 1.5 * std::sin(t), 0. });
    model.Faces.push_back({ 0, 1 + j, k + 2 + j, 2 + j });
  }
  for (int j = 1; closed && j < k; ++j)
  {
    model.Faces.push_back({ 2 * k + 2, k + 2 + j, 1 + j, k + 1 + j });
  }
  model.Points.push_back({ 0., 0., 1. });
  return model;
}

/// Edge j of a sector of k quads, before the flatness modification: its two quads count too.
Weights EdgeOfSector(int k, int j, double own, double other)
{
  const double side = 1. / 16.;
  return { { 0, own }, { 1 + j, other }, { j, side }, { 2 + j, side }, { k + 1 + j, side },
    { k + 2 + j, side } };
}

Weights FaceOfSector(int k, int j)
{
  return { { 0, 0.25 }, { 1 + j, 0.25 }, { 2 + j, 0.25 }, { k + 2 + j, 0.25 } };
}

/// 3/8 - 1/4 cos t, by hand, where a curve has 1 to 6 quads on one side.
const double GammaOfCurve[7] = { 0., 0.625, 0.375, 0.25, 0.1982233047033631, 0.1727457514062631,
  0.1584936490538903 };

}

// ---------------------------------------------------------------- steps

// 1 - 7/(4k), 3/(2k^2) and 1/(4k^2) for the vertex, each neighbour and each opposite corner.
TEST(SurfaceCatmullClark, VertexInside)
{
  const double cases[][3] = { { 5. / 12., 1. / 6., 1. / 36. }, { 9. / 16., 3. / 32., 1. / 64. },
    { 13. / 20., 3. / 50., 1. / 100. }, { 17. / 24., 1. / 24., 1. / 144. },
    { 3. / 4., 3. / 98., 1. / 196. }, { 25. / 32., 3. / 128., 1. / 256. } };
  for (int k = 3; k <= 8; ++k)
  {
    const double* weights = cases[k - 3];
    Weights expected{ { 0, weights[0] } };
    for (int j = 1; j <= k; ++j)
    {
      expected[j] = weights[1];
      expected[k + j] = weights[2];
    }
    const Surface surface(MakeTrapezohedron(k));
    for (const bool modified : { true, false })
    {
      ExpectRow(surface.GetRow(0, modified), expected, "valence " + std::to_string(k));
    }
  }
}

// A prism: its vertices have one triangle and two quads each.
TEST(SurfaceCatmullClark, PolygonsOfOtherSizes)
{
  Model model;
  model.Points = MakeRandomPoints(6, 1);
  model.Faces = { { 2, 1, 0 }, { 0, 1, 4, 3 }, { 1, 2, 5, 4 }, { 2, 0, 3, 5 }, { 3, 4, 5 } };
  const Surface prism(model);
  ExpectRow(prism.GetRow(0),
    { { 0, 23. / 54. }, { 1, 19. / 108. }, { 2, 19. / 108. }, { 3, 1. / 6. }, { 4, 1. / 36. },
      { 5, 1. / 36. } },
    "vertex");
  ExpectRow(prism.GetEdgeRow(0, 1),
    { { 0, 19. / 48. }, { 1, 19. / 48. }, { 2, 1. / 12. }, { 3, 1. / 16. }, { 4, 1. / 16. } },
    "triangle and quad");
  ExpectRow(prism.GetEdgeRow(0, 3),
    { { 0, 0.375 }, { 3, 0.375 }, { 1, 0.0625 }, { 2, 0.0625 }, { 4, 0.0625 }, { 5, 0.0625 } },
    "two quads");
  ExpectRow(prism.GetFaceRow(3), { { 0, 0.25 }, { 2, 0.25 }, { 3, 0.25 }, { 5, 0.25 } }, "quad");
  ExpectRow(prism.GetFaceRow(4), { { 3, 1. / 3. }, { 4, 1. / 3. }, { 5, 1. / 3. } }, "triangle");
}

TEST(SurfaceCatmullClark, VertexOnABoundaryACreaseOrACorner)
{
  const Weights curve = { { 0, 0.75 }, { 1, 0.125 }, { 5, 0.125 } };
  ExpectRow(Surface(MakeHalf(4, Pi)).GetRow(0), curve, "boundary");
  ExpectRow(Surface(MakeHalf(1, 1.)).GetRow(0), { { 0, 1. } }, "of a single face");
  Model corner = MakeHalf(4, Pi);
  corner.Corners = { 0 };
  ExpectRow(Surface(corner).GetRow(0), { { 0, 1. } }, "flagged");
  Model crease = MakeTrapezohedron(7);
  crease.Lines = { { 0, 1 } };
  ExpectRow(Surface(crease).GetRow(0), { { 0, 1. } }, "end of a crease");
  SurfaceFeatures dart;
  dart.DartEnds = true;
  ExpectRow(Surface(crease, dart).GetRow(0), Surface(MakeTrapezohedron(7)).GetRow(0), "dart");
  crease.Lines.push_back({ 5, 0 });
  ExpectRow(Surface(crease).GetRow(0), curve, "crease");
  crease.Lines.push_back({ 0, 2 });
  ExpectRow(Surface(crease).GetRow(0), { { 0, 1. } }, "three creases");
}

TEST(SurfaceCatmullClark, EdgeInsideAndOnACurve)
{
  const Surface grid(MakeSheet(4, 4, false, { 1., 0., 0. }, { 0., 1., 0. }));
  Model crease = MakeTrapezohedron(6);
  crease.Lines = { { 0, 1 }, { 0, 4 } };
  const Surface creased(crease);
  for (const bool modified : { true, false })
  {
    ExpectRow(grid.GetEdgeRow(12, 13, modified),
      { { 12, 0.375 }, { 13, 0.375 }, { 7, 0.0625 }, { 8, 0.0625 }, { 17, 0.0625 },
        { 18, 0.0625 } },
      "inside");
    ExpectRow(grid.GetEdgeRow(1, 2, modified), { { 1, 0.5 }, { 2, 0.5 } }, "boundary");
    ExpectRow(creased.GetEdgeRow(0, 4, modified), { { 0, 0.5 }, { 4, 0.5 } }, "crease");
    ExpectRow(
      grid.GetFaceRow(5, modified), { { 6, 0.25 }, { 7, 0.25 }, { 12, 0.25 }, { 11, 0.25 } }, "");
  }
}

TEST(SurfaceCatmullClark, EdgeNextToABoundary)
{
  for (int k = 2; k <= 6; ++k)
  {
    const Surface surface(MakeHalf(k, Pi));
    const double g = GammaOfCurve[k];
    for (int j = 1; j < k; ++j)
    {
      const std::string what = std::to_string(k) + " quads, edge " + std::to_string(j);
      ExpectRow(surface.GetEdgeRow(0, 1 + j), EdgeOfSector(k, j, 0.75 - g, g), what);
      ExpectRow(surface.GetEdgeRow(0, 1 + j, false), EdgeOfSector(k, j, 0.375, 0.375), what);
    }
  }
}

// The number of quads of its own side counts, not that of the other. A side of one quad has no
// smooth edge.
TEST(SurfaceCatmullClark, EdgeNextToACrease)
{
  ForEdgesNextToACrease(MakeTrapezohedron,
    [](const Model& model, const SurfaceFeatures& features, int j, int side)
    {
      const Surface surface(model, features);
      const int n = static_cast<int>(model.Points.size()) / 2 - 1;
      const double g = GammaOfCurve[side];
      Weights expected = { { 0, 0.75 - g }, { 1 + j, g }, { j, 0.0625 },
        { 1 + (j + 1) % n, 0.0625 }, { n + j, 0.0625 }, { 1 + n + j, 0.0625 } };
      ExpectRow(surface.GetEdgeRow(0, 1 + j), expected, "modified");
      expected[0] = expected[1 + j] = 0.375;
      ExpectRow(surface.GetEdgeRow(0, 1 + j, false), expected, "plain");
    });
  // The end of a crease is a corner without sectors: the plain rule.
  Model model = MakeTrapezohedron(5);
  model.Lines = { { 0, 1 } };
  ExpectRow(Surface(model).GetEdgeRow(0, 3), EdgeOfSector(4, 2, 0.375, 0.375), "end of a crease");
}

TEST(SurfaceCatmullClark, EdgeWithBothEndsOnCurves)
{
  // 4 quads at one end, 2 at the other.
  const Surface surface(MakeHalf(4, Pi, false));
  const double g = GammaOfCurve[4];
  ExpectRow(surface.GetEdgeRow(0, 3), EdgeOfSector(4, 2, (0.75 - g + 0.375) / 2., (g + 0.375) / 2.),
    "the mean of two masks");
  ExpectRow(surface.GetEdgeRow(0, 3, false), EdgeOfSector(4, 2, 0.375, 0.375), "plain");
  // 3 triangles at one end, 2 at the other: the mean of (3/8, 1/8) and (1/4, 1/4), and 1/6 each by
  // the two triangles.
  const Surface fan(MakeFan(3, true));
  ExpectRow(fan.GetEdgeRow(0, 2),
    { { 0, 23. / 48. }, { 2, 17. / 48. }, { 1, 1. / 12. }, { 3, 1. / 12. } }, "triangles");
}

// ---------------------------------------------------------------- corners

TEST(SurfaceCatmullClark, EdgeAtAConvexCorner)
{
  // 3/8 - 1/4 cos(alpha / k); alpha is kept in [pi/8, 7pi/8].
  const std::tuple<int, double, double> cases[] = { { 2, Pi / 2., 0.1982233047033631 },
    { 3, Pi / 2., 0.1584936490538903 }, { 2, 2. * Pi / 3., 0.25 }, { 2, 0.2, 0.1298036798991924 },
    { 2, 3.1, 0.3262274194959679 }, { 4, Pi, 0.1817473866593158 } };
  for (const auto& [k, angle, g] : cases)
  {
    Model model = MakeHalf(k, angle);
    model.Corners = { 0 };
    const Surface surface(model);
    for (int j = 1; j < k; ++j)
    {
      const std::string what = "angle " + std::to_string(angle) + " edge " + std::to_string(j);
      ExpectRow(surface.GetEdgeRow(0, 1 + j), EdgeOfSector(k, j, 0.75 - g, g), what);
    }
    ExpectRow(surface.GetFaceRow(0), FaceOfSector(k, 0), "a convex corner's face");
  }
}

TEST(SurfaceCatmullClark, ThirdEigenvalueAtCorners)
{
  const auto scheme = MakeCatmullClarkScheme<int>(true);
  EXPECT_NEAR(scheme->GetThirdEigenvalue(3, Pi), 0.5, 1e-15);
  EXPECT_NEAR(scheme->GetThirdEigenvalue(3, 1.5 * Pi), (11. + std::sqrt(57.)) / 32., 1e-15);
  EXPECT_NEAR(scheme->GetThirdEigenvalue(1, 1.5 * Pi), 0.25, 1e-15);
}

// Three quads that take 270 degrees: t = 90 degrees, g = 3/8, l3 = (11 + sqrt(57))/32 and so
// s = (sqrt(57) - 3)/8. With a = (r0 - v)/2 and b = (r3 - v)/2 the plane of the curves has its
// points at v - b for edge 1, v - a for edge 2, and v + a - b, v - a - b, v - a + b for the faces.
TEST(SurfaceCatmullClark, FlatnessAtAConcaveCorner)
{
  Model model = MakeHalf(3, 1.5 * Pi);
  model.Corners = { 0 };
  const Surface surface(model);
  const double s = (std::sqrt(57.) - 3.) / 8.;
  const Weights edges[] = { EdgeOfSector(3, 1, 0.375, 0.375), EdgeOfSector(3, 2, 0.375, 0.375) };
  ExpectRow(surface.GetEdgeRow(0, 2), Flatten(edges[0], 3, s, 0., -0.5), "edge 1");
  ExpectRow(surface.GetEdgeRow(0, 3), Flatten(edges[1], 3, s, -0.5, 0.), "edge 2");
  ExpectRow(surface.GetFaceRow(0), Flatten(FaceOfSector(3, 0), 3, s, 0.5, -0.5), "face 0");
  ExpectRow(surface.GetFaceRow(1), Flatten(FaceOfSector(3, 1), 3, s, -0.5, -0.5), "face 1");
  ExpectRow(surface.GetFaceRow(2), Flatten(FaceOfSector(3, 2), 3, s, -0.5, 0.5), "face 2");
  ExpectRow(surface.GetEdgeRow(0, 2, false), edges[0], "plain edge");
  ExpectRow(surface.GetFaceRow(1, false), FaceOfSector(3, 1), "plain face");
  ExpectRow(surface.GetFaceRow(3), { { 8, 0.25 }, { 6, 0.25 }, { 2, 0.25 }, { 5, 0.25 } },
    "not at the corner");
}

// In the plane of the corner the point of an edge lies at half the angle's unit vector, that of a
// face at the sum of its two edges: weights by the law of sines. Clamped angles are those of both t
// and the plane.
TEST(SurfaceCatmullClark, FlatnessOfConcaveAngles)
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
      const double g = 3. / 8. - std::cos(t) / 4.;
      // The larger root of (a - l)(1/4 - l) = b/4: what a step makes of edges and faces.
      const double a = g + std::cos(Pi / k) / 8.;
      const double b = (1. + std::cos(Pi / k)) / 8.;
      const double third = (a + 0.25) / 2. + std::sqrt((a + 0.25) * (a + 0.25) / 4. - (a - b) / 4.);
      const double s = 1. - 0.25 / third;
      auto first = [&](int j) { return std::sin(angle - j * t) / (2. * std::sin(angle)); };
      auto last = [&](int j) { return std::sin(j * t) / (2. * std::sin(angle)); };
      const std::string what = std::to_string(k) + " faces, angle " + std::to_string(given);
      for (int j = 1; j < k; ++j)
      {
        ExpectRow(surface.GetEdgeRow(0, 1 + j),
          Flatten(EdgeOfSector(k, j, 0.75 - g, g), k, s, first(j), last(j)), what);
      }
      for (int j = 0; j < k; ++j)
      {
        ExpectRow(surface.GetFaceRow(j),
          Flatten(FaceOfSector(k, j), k, s, first(j) + first(j + 1), last(j) + last(j + 1)), what);
      }
    }
  }
}

// 270 degrees in two quads at two corners of one quad, s = 1/2. The point of a corner's only edge
// is at v - (a + b) sqrt(1/2), those of its faces further by a or b, with a and b as above.
TEST(SurfaceCatmullClark, TwoConcaveCornersMeetInTheMean)
{
  const double r = std::sqrt(2.);
  Model model;
  model.Points = MakeRandomPoints(8, 1);
  model.Faces = { { 0, 1, 2, 3 }, { 0, 3, 4, 5 } };
  model.Corners = { 0, 3 };
  const Surface atEdge(model, GiveShape(8, { 0, 3 }, 1.5 * Pi, 0.5));
  const double own = 7. / 16. + r / 8.;
  const double side = 1. / 32. - r / 16.;
  ExpectRow(atEdge.GetEdgeRow(0, 3),
    { { 0, own }, { 3, own }, { 1, side }, { 2, side }, { 4, side }, { 5, side } }, "edge");
  model.Faces = { { 0, 1, 2, 3 }, { 0, 3, 4, 5 }, { 1, 6, 7, 2 } };
  model.Corners = { 0, 2 };
  const Surface atFace(model, GiveShape(8, { 0, 2 }, 1.5 * Pi, 0.5));
  const double corner = 0.25 + r / 8.;
  const double end = 0.25 - r / 16.;
  ExpectRow(atFace.GetFaceRow(0),
    { { 0, corner }, { 2, corner }, { 1, end }, { 3, end }, { 5, -r / 16. }, { 7, -r / 16. } },
    "face");
}

// What the rows are for: linear functions are halved, the third wave is quartered. Over the faces
// its waves are 1/(4 l3 - 1) times the sum of both edges'.
TEST(SurfaceCatmullClark, WavesInASectorOfAConcaveCorner)
{
  for (int k = 2; k <= 6; ++k)
  {
    const double angle = 4.5;
    Model model = MakeHalf(k, angle);
    model.Corners = { 0 };
    const Surface surface(model);
    const double third = surface.Modified->GetThirdEigenvalue(k, angle);
    auto check = [k](const Weights& row, const std::function<double(int)>& wave, double ofFaces,
                   double expected)
    {
      double sum = 0.;
      for (const auto& entry : row)
      {
        const int i = entry.first - 1;
        const int j = entry.first - k - 2;
        sum += entry.second * (i < 0 ? 0. : i <= k ? wave(i) : ofFaces * (wave(j) + wave(j + 1)));
      }
      EXPECT_NEAR(sum, expected, 1e-13) << k;
    };
    const double t = angle / k;
    auto cosine = [t](int i) { return std::cos(i * t); };
    auto sine = [t](int i) { return std::sin(i * t); };
    auto last = [k](int i) { return std::sin(i * Pi / k); };
    const double f = 1. / (4. * third - 1.);
    for (int j = 1; j < k; ++j)
    {
      const Weights row = surface.GetEdgeRow(0, 1 + j);
      check(row, cosine, 1., cosine(j) / 2.);
      check(row, sine, 1., sine(j) / 2.);
      check(row, last, f, last(j) / 4.);
    }
    for (int j = 0; j < k; ++j)
    {
      const Weights row = surface.GetFaceRow(j);
      check(row, cosine, 1., (cosine(j) + cosine(j + 1)) / 2.);
      check(row, sine, 1., (sine(j) + sine(j + 1)) / 2.);
      check(row, last, f, f * (last(j) + last(j + 1)) / 4.);
    }
  }
}
