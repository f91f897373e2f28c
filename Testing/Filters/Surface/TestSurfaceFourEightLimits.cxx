// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 12: limits of 4-8. A step moves no limit and turns no tangent plane; the masks where
// all is regular by their numbers, elsewhere by what many steps lead to.
#include "Core/Surfaces/FourEight/FourEightMasks.h"
#include "Core/Surfaces/Scheme/SurfaceSides.h"

#include "PointTools.h"
#include "SurfaceTools.h"

namespace
{

using namespace surfacetools;
using namespace point_tools;

constexpr SurfaceSchemeKind Kind = SurfaceSchemeKind::FourEight;

Point Normalise(const Point& a)
{
  const double length = Length(a);
  return { a[0] / length, a[1] / length, a[2] / length };
}

/// The zoo, k faces around a vertex inside and on a boundary, and faces with many corners.
std::map<std::string, Model> MakeModels()
{
  std::map<std::string, Model> models = MakeZoo(false);
  for (const auto& [name, model] : MakeZoo(true))
  {
    models["triangles, " + name] = model;
  }
  for (int k = 3; k <= 9; ++k)
  {
    for (const bool open : { false, true })
    {
      Model fan = MakeFan(k, open);
      fan.Points = MakeRandomPoints(fan.Points.size(), 17 + k);
      models["fan of " + std::to_string(k) + (open ? ", open" : "")] = fan;
    }
  }
  Model sheet = MakeSheet(6, 5, false, { 1., 0., 0. }, { 0., 1., 0. });
  sheet.Points = MakeRandomPoints(sheet.Points.size(), 5);
  models["sheet"] = sheet;
  sheet.Lines = { { 9, 16 }, { 16, 23 }, { 23, 24 } };
  models["sheet with a crease"] = sheet;
  for (std::size_t f = 0; f < sheet.Faces.size(); f += 3)
  {
    std::reverse(sheet.Faces[f].begin(), sheet.Faces[f].end());
  }
  models["sheet of turned faces"] = sheet;
  return models;
}

/// Whether two faces of one fan of a vertex are oriented differently.
bool AreTurned(const PolygonMesh<int>& mesh, int vertex, int a, int b)
{
  int forward = 0;
  VisitFans(mesh, vertex,
    [&](int corner)
    {
      VisitFan(mesh, corner,
        [&](const FanStep<int>& step)
        {
          const int face = mesh.GetFace(step.Corner);
          forward += face == a || face == b ? (step.Forward ? 1 : -1) : 0;
        });
    });
  return a != b && forward == 0;
}

/// The weight that each vertex of a level has in the row of one of them.
std::vector<double> GetRow(const Walk& walk, int vertex, LimitKind kind)
{
  RowBlock<int> rows;
  walk.Scheme->AppendLimitRows(walk.Level, walk.Level.Tags, kind, vertex, vertex + 1, rows);
  std::vector<double> row(walk.Points.size(), 0.);
  for (std::size_t i = 0; i < rows.GetNumberOfEntries(); ++i)
  {
    row[rows.GetColumns()[i]] += rows.GetWeights()[i];
  }
  return row;
}

}

TEST(SurfaceFourEightLimits, RowsSumToOneAndTangentsToZero)
{
  for (const auto& [name, model] : MakeModels())
  {
    Walk walk(model, Kind);
    for (int level = 0; level < 3; ++level)
    {
      for (int v = 0; v < walk.Level.Mesh.NumberOfVertices; ++v)
      {
        for (const LimitKind kind :
          { LimitKind::Position, LimitKind::Tangent1, LimitKind::Tangent2 })
        {
          double sum = 0.;
          for (const double weight : GetRow(walk, v, kind))
          {
            sum += weight;
          }
          EXPECT_NEAR(sum, kind == LimitKind::Position ? 1. : 0., 1e-13)
            << name << " level " << level << " vertex " << v << " kind " << int(kind);
        }
      }
      walk.Step();
    }
  }
}

TEST(SurfaceFourEightLimits, StepsMoveNoLimit)
{
  for (const auto& [name, model] : MakeModels())
  {
    Walk walk(model, Kind);
    std::vector<Point> before = walk.GetLimit();
    std::vector<double> distances; // steps lead to the limits
    for (int level = 1; level <= 8; ++level)
    {
      walk.Step();
      const std::vector<Point> limits = walk.GetLimit();
      for (std::size_t v = 0; v < before.size(); ++v)
      {
        EXPECT_LT(GetDistance(limits[v], before[v]), 1e-13)
          << name << " level " << level << " vertex " << v;
      }
      before = limits;
      distances.push_back(0.);
      for (std::size_t v = 0; v < model.Points.size(); ++v)
      {
        distances.back() = std::max(distances.back(), GetDistance(before[v], walk.Points[v]));
      }
    }
    EXPECT_LT(distances[7], 0.4 * distances[3] + 1e-15) << name;
  }
}

TEST(SurfaceFourEightLimits, RegularMask)
{
  const Walk walk(MakeSheet(6, 6, false, { 1., 0., 0. }, { 0., 1., 0. }), Kind);
  const std::vector<double> row = GetRow(walk, 24, LimitKind::Position);
  for (int v = 0; v < 49; ++v)
  {
    const int x = std::abs(v % 7 - 3);
    const int y = std::abs(v / 7 - 3);
    const double expected = x + y == 0 ? 35.
      : x + y == 1                     ? 59. / 4.
      : x == 1 && y == 1               ? 22. / 4.
      : x + y == 2                     ? 3. / 4.
      : x + y == 3 && x * y == 2       ? 1. / 8.
                                       : 0.;
    EXPECT_NEAR(row[v], expected / 120., 1e-16) << v;
  }
}

// Of two steps, as Smoothness finds them by numbers.
TEST(SurfaceFourEightLimits, EigenvaluesOfTangents)
{
  const double expected[] = { 0.4083, 0.5, 0.5513, 0.5819, 0.6013, 0.6142, 0.6233 };
  for (int k = 3; k <= 9; ++k)
  {
    const double value = FourEightWave(2. * Pi / k).Value;
    EXPECT_NEAR(value * value, expected[k - 3], 5e-5) << k;
  }
}

// Where faces are turned over their normals are too, which GetOrientingFace tells the filter.
TEST(SurfaceFourEightLimits, StepsTurnNoTangentPlane)
{
  int tested = 0;
  for (const auto& [name, model] : MakeModels())
  {
    Walk walk(model, Kind);
    for (int level = 0; level <= 5; ++level)
    {
      const std::vector<Point> first = walk.GetLimit(LimitKind::Tangent1);
      const std::vector<Point> second = walk.GetLimit(LimitKind::Tangent2);
      Walk next = Walk(model, Kind);
      for (int step = 0; step <= level; ++step)
      {
        next.Step();
      }
      const std::vector<Point> nextFirst = next.GetLimit(LimitKind::Tangent1);
      const std::vector<Point> nextSecond = next.GetLimit(LimitKind::Tangent2);
      for (std::size_t v = 0; v < first.size(); ++v)
      {
        const std::string what =
          name + " level " + std::to_string(level) + " vertex " + std::to_string(v);
        EXPECT_EQ(Length(second[v]) > 0., Length(nextSecond[v]) > 0.) << what;
        const Point normal = Cross(first[v], second[v]);
        const Point nextNormal = Cross(nextFirst[v], nextSecond[v]);
        if (Length(normal) < 1e-6)
        {
          continue;
        }
        ++tested;
        const int face = FindFaceOfTangents(walk.Level.Mesh, walk.Level.Tags, int(v));
        const int nextFace = FindFaceOfTangents(next.Level.Mesh, next.Level.Tags, int(v));
        const auto parent = walk.Scheme->GetOrientingFace(walk.Level, nextFace);
        const double sign = AreTurned(walk.Level.Mesh, int(v), face, int(parent)) ? -1. : 1.;
        const Point a = Normalise(normal);
        const Point b = Normalise(nextNormal);
        EXPECT_LT(GetDistance(a, { sign * b[0], sign * b[1], sign * b[2] }), 1e-9) << what;
      }
      walk.Step();
    }
  }
  EXPECT_GT(tested, 1000);
}

// The tangents themselves, not their directions alone: a step makes them smaller by one factor.
TEST(SurfaceFourEightLimits, TangentsAcrossCurvesAreEigenvectorsOfTwoSteps)
{
  for (int k = 2; k <= 6; ++k)
  {
    Model fan = MakeFan(k, true);
    fan.Points = MakeRandomPoints(fan.Points.size(), 3);
    Walk walk(fan, Kind);
    std::vector<double> factors;
    Point before = walk.GetLimit(LimitKind::Tangent2)[0];
    for (int step = 0; step < 8; ++step)
    {
      walk.Step();
      const Point now = walk.GetLimit(LimitKind::Tangent2)[0];
      EXPECT_LT(Length(Cross(Normalise(before), Normalise(now))), 1e-11) << k;
      factors.push_back(Length(now) / Length(before));
      before = now;
    }
    for (const double factor : factors)
    {
      EXPECT_NEAR(factor, factors[0], 1e-11) << k;
    }
    EXPECT_GT(factors[0], 0.4) << k;
    EXPECT_LT(factors[0], 1.) << k;
  }
}

TEST(SurfaceFourEightLimits, NormalsAreThoseOfTheFacesNearBy)
{
  for (const char* name : { "sheet", "fan of 3", "fan of 5", "fan of 3, open" })
  {
    const Model model = MakeModels()[name];
    Walk walk(model, Kind);
    const std::vector<Point> first = walk.GetLimit(LimitKind::Tangent1);
    const std::vector<Point> second = walk.GetLimit(LimitKind::Tangent2);
    double errors[2];
    for (int part = 0; part < 2; ++part)
    {
      for (int step = 0; step < (part == 0 ? 8 : 4); ++step)
      {
        walk.Step();
      }
      const PolygonMesh<int>& mesh = walk.Level.Mesh;
      const std::vector<Point> limits = walk.GetLimit();
      errors[part] = 0.;
      for (std::size_t v = 0; v < model.Points.size(); ++v)
      {
        const Point plane = Cross(first[v], second[v]);
        const bool isInside = walk.Level.Tags.Vertices[int(v)] == VertexTag::Smooth;
        if (mesh.VertexCorners[int(v)] < 0 || Length(plane) < 1e-6 || (!isInside && v > 0))
        {
          continue;
        }
        const Point normal = Normalise(plane);
        VisitFan(mesh, mesh.VertexCorners[int(v)],
          [&](const FanStep<int>& step)
          {
            const Point& a = limits[mesh.Vertices[mesh.Next(step.Corner)]];
            const Point& b = limits[mesh.Vertices[mesh.Previous(step.Corner)]];
            const Point& x = limits[v];
            const Point face = Cross(
              { a[0] - x[0], a[1] - x[1], a[2] - x[2] }, { b[0] - x[0], b[1] - x[1], b[2] - x[2] });
            errors[part] = std::max(errors[part], Length(Cross(Normalise(face), normal)));
            EXPECT_GT(Dot(face, normal), 0.) << name << " vertex " << v;
          });
      }
    }
    EXPECT_LT(errors[1], 0.6 * errors[0]) << name;
    EXPECT_LT(errors[1], 0.3) << name;
  }
}

TEST(SurfaceFourEightLimits, RowsAreTheSameBitsOneByOne)
{
  for (const auto& [name, model] : MakeModels())
  {
    Walk walk(model, Kind);
    for (int level = 0; level < 4; ++level)
    {
      for (const LimitKind kind : { LimitKind::Position, LimitKind::Tangent1, LimitKind::Tangent2 })
      {
        RowBlock<int> rows;
        const int size = static_cast<int>(walk.Level.Mesh.NumberOfVertices);
        walk.Scheme->AppendLimitRows(walk.Level, walk.Level.Tags, kind, 0, size, rows);
        for (int v = 0; v < size; ++v)
        {
          RowBlock<int> one;
          walk.Scheme->AppendLimitRows(walk.Level, walk.Level.Tags, kind, v, v + 1, one);
          const std::size_t begin = rows.GetBegin(v);
          ASSERT_EQ(rows.GetEnd(v) - begin, one.GetNumberOfEntries()) << name;
          for (std::size_t i = 0; i < one.GetNumberOfEntries(); ++i)
          {
            ASSERT_EQ(rows.GetColumns()[begin + i], one.GetColumns()[i]) << name;
            ASSERT_EQ(rows.GetWeights()[begin + i], one.GetWeights()[i]) << name << " " << v;
          }
        }
      }
      walk.Step();
    }
  }
}

// Level 8 and all before lie on one surface.
TEST(SurfaceFourEightLimits, ThroughTheFilter)
{
  Model model = MakeSheet(5, 5, false, { 1., 0., 0. }, { 0., 1., 0. });
  const std::vector<Point> noise = MakeRandomPoints(model.Points.size(), 9);
  for (std::size_t i = 0; i < noise.size(); ++i)
  {
    model.Points[i][2] += 0.4 * noise[i][2];
  }
  model.Faces[7].pop_back(); // a triangle, and a hole beside it
  const auto first = RunFilter(MakeInput(model), vtkSurfaceSubdivision::FOUR_EIGHT, 0, true);
  for (const int levels : { 1, 2, 3, 8 })
  {
    const auto output =
      RunFilter(MakeInput(model), vtkSurfaceSubdivision::FOUR_EIGHT, levels, true);
    for (vtkIdType i = 0; i < first->GetNumberOfPoints(); ++i)
    {
      Point a;
      Point b;
      first->GetPoint(i, a.data());
      output->GetPoint(i, b.data());
      EXPECT_LT(GetDistance(a, b), 1e-12) << levels << " point " << i;
      first->GetPointData()->GetArray("LimitNormals")->GetTuple(i, a.data());
      output->GetPointData()->GetArray("LimitNormals")->GetTuple(i, b.data());
      EXPECT_NEAR(Length(a), 1., 1e-12);
      const bool isShading = GetDistance(a, b) > 1e-9; // at corners of no tangent plane
      EXPECT_TRUE(!isShading || Dot(a, b) > 0.) << levels << " point " << i;
    }
  }
}

TEST(SurfaceFourEightLimits, ThreadsDoNotChangeTheResult)
{
  // Triangles: no vertex is regular.
  Model model = MakeSheet(90, 80, true, { 1., 0., 0. }, { 0., 1., 0. });
  model.Points = MakeRandomPoints(model.Points.size(), 4);
  const auto output = multi_dimensional_subdivision_tools::MakeInThreads(
    [&] { return RunFilter(MakeInput(model), vtkSurfaceSubdivision::FOUR_EIGHT, 1, true); });
  EXPECT_GT(output->GetNumberOfPolys(), 20000);
}
