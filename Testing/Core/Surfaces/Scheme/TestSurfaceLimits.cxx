// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 8 and 12: limit positions and tangents of Loop and of Catmull and Clark, number by
// number, and as left eigenvectors of a step.
#include "SchemeTools.h"

#include "Core/Rules/Pi.h"
#include "Core/Surfaces/CatmullClark/CatmullClarkScheme.h"
#include "Core/Surfaces/Loop/LoopScheme.h"

using namespace surfacetools;

namespace
{

/// Faces around vertex 0, between edges j and j + 1 for j = 0 ... Edges lead to 1, 2, ...; opposite
/// corners of quads follow. As many faces more behind them, so that the ends of edges that are not
/// at a boundary lie inside the surface.
Model MakeFaces(int faces, bool triangles, bool half, double angle)
{
  Model model;
  const int edges = half ? faces + 1 : faces;
  model.Points.push_back({ 0., 0., 0. });
  for (int j = 0; j < edges; ++j)
  {
    const double t = angle * j / faces;
    model.Points.push_back({ std::cos(t), std::sin(t), 0. });
  }
  const int behind = edges + 1 + (triangles ? 0 : faces);
  for (int j = 0; j < faces; ++j)
  {
    const int next = 1 + (j + 1) % edges;
    if (triangles)
    {
      model.Faces.push_back({ 0, 1 + j, next });
      model.Faces.push_back({ behind, next, 1 + j });
      continue;
    }
    const double t = angle * (j + 0.5) / faces;
    model.Points.push_back({ 1.5 * std::cos(t), 1.5 * std::sin(t), 0. });
    model.Faces.push_back({ 0, 1 + j, edges + 1 + j, next });
  }
  for (int j = 0; !triangles && j < (half ? faces - 1 : faces); ++j)
  {
    const int next = (j + 1) % faces;
    model.Faces.push_back({ behind, edges + 1 + next, 1 + next, edges + 1 + j });
  }
  model.Points.push_back({ 0., 0., -1. });
  return model;
}

/// Rows of vertex 0 of a model.
class Limits
{
public:
  Limits(const Model& model, bool triangles, bool modified = true,
    LoopWeights weights = LoopWeights::Warren)
    : Scheme(
        triangles ? MakeLoopScheme<int>(modified, weights) : MakeCatmullClarkScheme<int>(modified))
    , Level(MakeLevel(model.Points.size(), model.Faces, {}))
  {
    ClassifyModel(model, *this->Scheme, SurfaceFeatures(), this->Level);
  }
  Weights GetRow(LimitKind kind) const
  {
    RowBlock<int> rows;
    this->Scheme->AppendLimitRows(this->Level, this->Level.Tags, kind, 0, 1, rows);
    return ToWeights(rows);
  }
  /// A row over what a step makes of vertex 0, its edges and faces, as a row over what was before.
  Weights GoBack(const Weights& row) const
  {
    const PolygonMesh<int>& mesh = this->Level.Mesh;
    Weights before;
    for (const auto& entry : row)
    {
      vtkIdType at = entry.first;
      for (int e = 0; e < mesh.GetNumberOfEdges() && entry.first > 0; ++e)
      {
        const std::set<int> ends{ mesh.EdgeVertices[2 * e], mesh.EdgeVertices[2 * e + 1] };
        at = ends == std::set<int>{ 0, entry.first } ? mesh.NumberOfVertices + e : at;
      }
      for (int f = 0; f < mesh.NumberOfFaces && mesh.Arity == 4; ++f)
      {
        // Of the faces at vertex 0, which is their first corner.
        const int* corners = mesh.Vertices.data() + mesh.GetFirst(f);
        at = corners[0] == 0 && corners[2] == entry.first
          ? mesh.NumberOfVertices + mesh.GetNumberOfEdges() + f
          : at;
      }
      RowBlock<int> rows;
      this->Scheme->AppendRows(this->Level, this->Level.Tags, at, at + 1, rows);
      for (const auto& old : ToWeights(rows))
      {
        before[old.first] += entry.second * old.second;
      }
    }
    return before;
  }

  const std::shared_ptr<const SurfaceScheme<int>> Scheme;
  SurfaceLevel<int> Level;
};

Weights Scale(Weights row, double factor)
{
  for (auto& entry : row)
  {
    entry.second *= factor;
  }
  return row;
}

/// Weights of the vertex, of its edges' ends and of the opposite corners.
Weights Join(double own, const std::vector<double>& edges, const std::vector<double>& faces = {})
{
  Weights weights{ { 0, own } };
  for (const auto* list : { &edges, &faces })
  {
    for (double weight : *list)
    {
      const int column = static_cast<int>(weights.size());
      weights[column] = weight;
    }
  }
  return weights;
}

/// Tangents inside: the first row is `edges` and `faces` from some edge on, both times the cosine
/// or sine of 2 pi / n per edge; a step makes them smaller by the eigenvalue.
void CheckTangentsInside(int n, bool triangles, double ofEdges, double eigenvalue)
{
  const std::string what = "valence " + std::to_string(n);
  const Limits limits(MakeFaces(n, triangles, false, 2. * Pi), triangles);
  Weights first = limits.GetRow(LimitKind::Tangent1);
  int start = 0; // the edge along which the first tangent points
  while (start < n && std::abs(first[1 + start] - ofEdges) > 1e-14)
  {
    ++start;
  }
  ASSERT_LT(start, n) << what;
  for (const LimitKind kind : { LimitKind::Tangent1, LimitKind::Tangent2 })
  {
    auto wave = [&](int j)
    {
      const double t = 2. * Pi * (j - start) / n;
      return kind == LimitKind::Tangent1 ? std::cos(t) : std::sin(t);
    };
    std::vector<double> edges;
    std::vector<double> faces;
    for (int j = 0; j < n; ++j)
    {
      edges.push_back(ofEdges * wave(j));
      faces.push_back(wave(j) + wave(j + 1));
    }
    const Weights row = Join(0., edges, triangles ? std::vector<double>() : faces);
    ExpectRow(limits.GetRow(kind), row, what);
    ExpectRow(limits.GoBack(row), Scale(row, eigenvalue), what + ", after a step");
  }
}

/// Tangents at a boundary: the difference of both ends, and a row.
void CheckTangentsOnBoundary(
  int k, bool triangles, bool modified, const Weights& expected, double factor)
{
  const std::string what = std::to_string(k) + (triangles ? " triangles" : " quads");
  const Limits limits(MakeFaces(k, triangles, true, Pi), triangles, modified);
  Weights along = limits.GetRow(LimitKind::Tangent1);
  // Which end comes first is open; both tangents turn with it, and so the normal does not.
  const double side = along[1];
  EXPECT_EQ(std::abs(side), 1.) << what;
  ExpectRow(along, { { 1, side }, { k + 1, -side } }, what);
  ExpectRow(limits.GetRow(LimitKind::Tangent2), Scale(expected, side * factor), what);
}

const double Root2 = std::sqrt(2.);
const double Root3 = std::sqrt(3.);

}

// ---------------------------------------------------------------- positions

TEST(SurfaceLimitRows, PositionsOfLoop)
{
  const std::map<int, std::pair<double, double>> cases = { { 3, { 2. / 5., 1. / 5. } },
    { 4, { 1. / 2., 1. / 8. } }, { 5, { 1. / 2., 1. / 10. } }, { 6, { 1. / 2., 1. / 12. } },
    { 7, { 1. / 2., 1. / 14. } }, { 8, { 1. / 2., 1. / 16. } } };
  for (const auto& [n, weights] : cases)
  {
    const std::string what = "valence " + std::to_string(n);
    const Limits limits(MakeFaces(n, true, false, 2. * Pi), true);
    const Weights expected =
      Join(weights.first, std::vector<double>(static_cast<std::size_t>(n), weights.second));
    ExpectRow(limits.GetRow(LimitKind::Position), expected, what);
    ExpectRow(limits.GoBack(expected), expected, what + ": a step does not move it");
  }
}

TEST(SurfaceLimitRows, PositionsOfLoopWithHisOwnWeights)
{
  for (int n = 3; n <= 12; ++n)
  {
    const std::string what = "valence " + std::to_string(n);
    const Limits limits(MakeFaces(n, true, false, 2. * Pi), true, true, LoopWeights::Loop);
    const double wave = 3. / 8. + std::cos(2. * Pi / n) / 4.;
    const double weight = (5. / 8. - wave * wave) / n;
    const double own = 3. / (11. - 8. * (1. - n * weight));
    const Weights expected =
      Join(own, std::vector<double>(static_cast<std::size_t>(n), (1. - own) / n));
    ExpectRow(limits.GetRow(LimitKind::Position), expected, what);
    ExpectRow(limits.GoBack(expected), expected, what + ": a step does not move it");
  }
}

// k/(k + 5), 4/(k(k + 5)) and 1/(k(k + 5)).
TEST(SurfaceLimitRows, PositionsOfCatmullClark)
{
  const double cases[][3] = { { 3. / 8., 1. / 6., 1. / 24. }, { 4. / 9., 1. / 9., 1. / 36. },
    { 1. / 2., 2. / 25., 1. / 50. }, { 6. / 11., 2. / 33., 1. / 66. },
    { 7. / 12., 1. / 21., 1. / 84. }, { 8. / 13., 1. / 26., 1. / 104. } };
  for (int n = 3; n <= 8; ++n)
  {
    const std::string what = "valence " + std::to_string(n);
    const double* weights = cases[n - 3];
    const std::size_t size = static_cast<std::size_t>(n);
    const Limits limits(MakeFaces(n, false, false, 2. * Pi), false);
    const Weights expected = Join(
      weights[0], std::vector<double>(size, weights[1]), std::vector<double>(size, weights[2]));
    ExpectRow(limits.GetRow(LimitKind::Position), expected, what);
    ExpectRow(limits.GoBack(expected), expected, what + ": a step does not move it");
  }
  // Triangles become quads in a step: 3/8 (4/9, 5/27 ...) + 1/6 (5/12, 5/12, 1/12, 1/12) + ... +
  // 1/24 (1/3, 1/3, 1/3) + ...
  Model tetrahedron;
  tetrahedron.Points = MakeRandomPoints(4, 1);
  tetrahedron.Faces = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 1, 3, 2 } };
  ExpectRow(Limits(tetrahedron, false).GetRow(LimitKind::Position),
    Join(5. / 12., { 7. / 36., 7. / 36., 7. / 36. }), "tetrahedron");
}

TEST(SurfaceLimitRows, PositionsOnCurvesAndCorners)
{
  for (const bool triangles : { true, false })
  {
    for (const bool modified : { true, false })
    {
      Model model = MakeFaces(4, triangles, true, 4.);
      const Weights curve = Join(2. / 3., { 1. / 6., 0., 0., 0., 1. / 6. });
      const Limits limits(model, triangles, modified);
      ExpectRow(limits.GetRow(LimitKind::Position), curve, "curve");
      ExpectRow(limits.GoBack({ { 0, 2. / 3. }, { 1, 1. / 6. }, { 5, 1. / 6. } }), curve, "step");
      model.Corners = { 0 };
      ExpectRow(
        Limits(model, triangles, modified).GetRow(LimitKind::Position), { { 0, 1. } }, "corner");
    }
  }
}

// Next to a curve whose rule is another one the row is that of the next level times the step.
TEST(SurfaceLimitRows, PositionsNextToACurve)
{
  // Four triangles in a square: the ends of edges on the boundary have two triangles, and so 1/4
  // for themselves and 1/2 for the vertex inside. 1/2 of its row and 1/8 of each edge's:
  Model fan = MakeFan(4, false);
  ExpectRow(Limits(fan, true).GetRow(LimitKind::Position),
    Join(9. / 16., { 7. / 64., 7. / 64., 7. / 64., 7. / 64. }), "modified");
  ExpectRow(Limits(fan, true, false).GetRow(LimitKind::Position),
    Join(1. / 2., { 1. / 8., 1. / 8., 1. / 8., 1. / 8. }), "plain");
}

// ---------------------------------------------------------------- tangents

TEST(SurfaceLimitRows, TangentsInside)
{
  // Loop: 3/8 + 1/4 cos(2 pi / n).
  CheckTangentsInside(3, true, 1., 0.25);
  CheckTangentsInside(4, true, 1., 0.375);
  CheckTangentsInside(5, true, 1., 0.4522542485937369);
  CheckTangentsInside(6, true, 1., 0.5);
  CheckTangentsInside(8, true, 1., 0.5517766952966369);
  // Catmull-Clark: edges have 16 l1 - 4 times what the sum of two has for a face.
  CheckTangentsInside(3, false, (1. + std::sqrt(17.)) / 2., (9. + std::sqrt(17.)) / 32.);
  CheckTangentsInside(4, false, 4., 0.5);
  CheckTangentsInside(5, false, 4.799813672292755, 0.5499883545182972);
}

TEST(SurfaceLimitRows, TangentsOnABoundaryOfLoop)
{
  // The plain rules (Mathematics 8): (v; e; sines; e), e = (sin t - s)/(1 + 2 cos t).
  CheckTangentsOnBoundary(1, true, false, Join(-2., { 1., 1. }), 1.);
  CheckTangentsOnBoundary(2, true, false, Join(-1., { 0., 1., 0. }), 1.);
  const Weights three = Join(-Root3 / 2., { -Root3 / 4., Root3 / 2., Root3 / 2., -Root3 / 4. });
  CheckTangentsOnBoundary(3, true, false, three, 1.);
  const Weights four = Join(-1., { -Root2 / 2., Root2 / 2., 1., Root2 / 2., -Root2 / 2. });
  CheckTangentsOnBoundary(4, true, false, four, 1.);
  // For g = 1/2 - 1/4 cos t the eigenvalue is 1/2: v = -sin t and
  // e = 1/4 sin t - (1/4 + 1/4 cos t) cot(t/2). The row is that of the next level times the step.
  CheckTangentsOnBoundary(2, true, true, Join(-1., { 0., 1., 0. }), 0.5);
  CheckTangentsOnBoundary(3, true, true, three, 0.5);
  const double e = -0.5 - Root2 / 4.;
  CheckTangentsOnBoundary(
    4, true, true, Join(-Root2 / 2., { e, Root2 / 2., 1., Root2 / 2., e }), 0.5);
}

// For g = 3/8 - 1/4 cos t the eigenvalue is 1/2: v = -sin t, faces have 1/4 of the sum of their two
// edges, and e = 1/4 sin t - (1/2 + 1/4 cos t) cot(t/2).
TEST(SurfaceLimitRows, TangentsOnABoundaryOfCatmullClark)
{
  const Weights two = Join(-1., { -0.25, 1., -0.25 }, { 0.25, 0.25 });
  CheckTangentsOnBoundary(2, false, true, two, 0.5);
  CheckTangentsOnBoundary(2, false, false, two, 1.); // g = 3/8 in both
  const double r = Root3 / 2.;
  CheckTangentsOnBoundary(
    3, false, true, Join(-r, { -r, r, r, -r }, { r / 4., r / 2., r / 4. }), 0.5);
  const double h = Root2 / 2.;
  const double f = (1. + h) / 4.;
  CheckTangentsOnBoundary(4, false, true,
    Join(-h, { -0.75 - Root2 / 2., h, 1., h, -0.75 - Root2 / 2. }, { h / 4., f, f, h / 4. }), 0.5);
}

// With the plain rules the second tangent of Catmull-Clark is that of the larger eigenvalue of
// edges and faces: for 3 quads (11 + sqrt(57))/32.
TEST(SurfaceLimitRows, PlainTangentsOnABoundaryAreEigenvectors)
{
  const std::map<int, double> values = { { 2, 0.5 }, { 3, (11. + std::sqrt(57.)) / 32. },
    { 4,
      (0.625 + Root2 / 16. +
        std::sqrt((0.125 + Root2 / 16.) * (0.125 + Root2 / 16.) + (1. + Root2 / 2.) / 8.)) /
        2. } };
  for (const auto& [k, value] : values)
  {
    const Limits limits(MakeFaces(k, false, true, Pi), false, false);
    const Weights row = limits.GetRow(LimitKind::Tangent2);
    ExpectRow(limits.GoBack(row), Scale(row, value), std::to_string(k) + " quads");
    for (int j = 1; j < k; ++j)
    {
      EXPECT_NEAR(std::abs(row.at(1 + j)), std::sin(j * Pi / k), 1e-14);
    }
  }
}

// At a corner they are an orthonormal pair of the plane of its curves, wherever the faces lie.
TEST(SurfaceLimitRows, TangentsAtCorners)
{
  for (const bool triangles : { true, false })
  {
    for (const double angle : { Pi / 2., 2., 4., 1.5 * Pi })
    {
      Model model = MakeFaces(3, triangles, true, angle);
      model.Corners = { 0 };
      const Limits limits(model, triangles);
      double vectors[2][2] = { { 0., 0. }, { 0., 0. } };
      for (const int i : { 0, 1 })
      {
        double sum = 0.;
        for (const auto& entry : limits.GetRow(i ? LimitKind::Tangent2 : LimitKind::Tangent1))
        {
          EXPECT_TRUE(entry.first == 0 || entry.first == 1 || entry.first == 4) << entry.first;
          vectors[i][0] += entry.second * model.Points[entry.first][0];
          vectors[i][1] += entry.second * model.Points[entry.first][1];
          sum += entry.second;
        }
        EXPECT_NEAR(sum, 0., 1e-14) << angle;
        EXPECT_NEAR(std::hypot(vectors[i][0], vectors[i][1]), 1., 1e-14) << angle;
      }
      const double area = vectors[0][0] * vectors[1][1] - vectors[0][1] * vectors[1][0];
      EXPECT_NEAR(area, 1., 1e-14) << angle;
    }
  }
}

// ---------------------------------------------------------------- all rows

TEST(SurfaceLimitRows, RowsSumToOneAndTangentsToZero)
{
  for (int variant = 0; variant < 8; ++variant)
  {
    const bool triangles = variant % 2 == 0;
    for (const auto& [name, model] : MakeZoo(triangles || variant / 4))
    {
      const Limits limits(model, triangles, variant / 2 % 2 == 0);
      const SurfaceLevel<int>& level = limits.Level;
      if (triangles && level.Mesh.Arity != 3)
      {
        continue;
      }
      auto check = [&mesh = name](const RowBlock<int>& rows, double expected)
      {
        for (std::size_t row = 0; row < rows.GetNumberOfRows(); ++row)
        {
          const double sum = std::accumulate(
            rows.GetWeights() + rows.GetBegin(row), rows.GetWeights() + rows.GetEnd(row), 0.);
          EXPECT_NEAR(sum, expected, 1e-13) << mesh << " row " << row;
        }
      };
      RowBlock<int> rows;
      limits.Scheme->AppendRows(level, level.Tags, 0, limits.Scheme->GetNumberOfRows(level), rows);
      check(rows, 1.);
      for (const LimitKind kind : { LimitKind::Position, LimitKind::Tangent1, LimitKind::Tangent2 })
      {
        rows.Clear();
        limits.Scheme->AppendLimitRows(
          level, level.Tags, kind, 0, level.Mesh.NumberOfVertices, rows);
        check(rows, kind == LimitKind::Position ? 1. : 0.);
      }
    }
  }
}
