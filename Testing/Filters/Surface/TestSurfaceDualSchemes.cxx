// SPDX-License-Identifier: BSD-3-Clause
// What holds for both dual schemes: rows, incidences, boundaries, and the filter around them.
#include "DualSchemeTools.h"

using namespace dualtools;

namespace
{

class SurfaceDualSchemes : public testing::TestWithParam<subdivision::SurfaceSchemeKind>
{
protected:
  const subdivision::SurfaceSchemeKind Kind = GetParam();
  const bool IsDooSabin = Kind == subdivision::SurfaceSchemeKind::DooSabin;
  const int Scheme = static_cast<int>(Kind);
};

Faces GetFaces(const Mesh& mesh)
{
  Faces faces;
  for (int f = 0; f < mesh.NumberOfFaces; ++f)
  {
    const int* first = mesh.Vertices.data() + mesh.GetFirst(f);
    faces.emplace_back(first, first + mesh.GetSize(f));
  }
  return faces;
}

/// A level is what its cells say, every edge has one or two faces, every face its own corners.
void ExpectConforming(const Level& level)
{
  const Mesh& mesh = level.Mesh;
  const Faces faces = GetFaces(mesh);
  for (const auto& face : faces)
  {
    EXPECT_GE(face.size(), 3u);
    EXPECT_EQ(std::set<vtkIdType>(face.begin(), face.end()).size(), face.size());
  }
  const Level built = MakeLevel(static_cast<std::size_t>(mesh.NumberOfVertices), faces);
  EXPECT_TRUE(built.Mesh.Sheaves.empty());
  EXPECT_TRUE(built.Mesh.Joints.empty());
  ASSERT_EQ(built.Mesh.Twins.size(), mesh.Twins.size());
  EXPECT_TRUE(std::equal(mesh.Twins.begin(), mesh.Twins.end(), built.Mesh.Twins.begin()));
  ASSERT_EQ(built.Mesh.VertexCorners.size(), mesh.VertexCorners.size());
  EXPECT_TRUE(std::equal(
    mesh.VertexCorners.begin(), mesh.VertexCorners.end(), built.Mesh.VertexCorners.begin()));
  for (int c = 0; c < mesh.Vertices.size(); ++c)
  {
    EXPECT_EQ(mesh.GetFace(c), built.Mesh.GetFace(c));
  }
}

/// V - E + F without vertices that have no faces.
int GetEuler(const Level& level)
{
  const Mesh& mesh = level.Mesh;
  std::set<int> used(mesh.Vertices.begin(), mesh.Vertices.end());
  int sides = 0;
  for (int c = 0; c < mesh.Twins.size(); ++c)
  {
    sides += mesh.Twins[c] < c;
  }
  return static_cast<int>(used.size()) - sides + static_cast<int>(mesh.NumberOfFaces);
}

/// Twins run in opposite directions wherever the faces are oriented alike.
void ExpectOriented(const Level& level)
{
  const Mesh& mesh = level.Mesh;
  for (int c = 0; c < mesh.Twins.size(); ++c)
  {
    if (mesh.Twins[c] >= 0)
    {
      EXPECT_EQ(mesh.Vertices[mesh.Twins[c]], mesh.Vertices[mesh.Next(c)]);
    }
  }
}

/// Boundary points of a level, with those of a neighbour each: the boundary as segments.
using Segment = std::array<Point, 2>;

std::vector<Segment> GetBoundary(const Level& level, const Points& points)
{
  std::vector<Segment> segments;
  for (int c = 0; c < level.Mesh.Twins.size(); ++c)
  {
    if (level.Mesh.Twins[c] < 0)
    {
      segments.push_back(
        { points[level.Mesh.Vertices[c]], points[level.Mesh.Vertices[level.Mesh.Next(c)]] });
    }
  }
  return segments;
}

/// `fine` is Chaikin's boundary of `coarse`, whose half-edges follow one another.
void ExpectChaikin(const std::vector<Segment>& coarse, const std::vector<Segment>& fine)
{
  ASSERT_EQ(fine.size(), 2 * coarse.size());
  auto blend = [](const Segment& s, double t)
  {
    Point p{};
    for (int c = 0; c < 3; ++c)
    {
      p[c] = (1. - t) * s[0][c] + t * s[1][c];
    }
    return p;
  };
  auto has = [&](const Point& a, const Point& b)
  {
    return std::any_of(fine.begin(), fine.end(), [&](const Segment& s)
      { return (IsNear(s[0], a) && IsNear(s[1], b)) || (IsNear(s[0], b) && IsNear(s[1], a)); });
  };
  for (const Segment& s : coarse)
  {
    EXPECT_TRUE(has(blend(s, 0.25), blend(s, 0.75)));
    for (const Segment& next : coarse)
    {
      if (IsNear(s[1], next[0]))
      {
        EXPECT_TRUE(has(blend(s, 0.75), blend(next, 0.25)));
      }
    }
  }
}

/// Rows sum to one, have no negative entries, and no column twice.
void ExpectAverages(const subdivision::SparseRows<int>& rows)
{
  for (vtkIdType r = 0; r < rows.GetNumberOfRows(); ++r)
  {
    double sum = 0.;
    std::set<int> columns;
    for (int k = rows.Offsets[r]; k < rows.Offsets[r + 1]; ++k)
    {
      EXPECT_GE(rows.Weights[k], 0.);
      EXPECT_TRUE(columns.insert(rows.Columns[k]).second);
      sum += rows.Weights[k];
    }
    EXPECT_NEAR(sum, 1., 1e-14);
  }
}

}

TEST_P(SurfaceDualSchemes, EveryMesh)
{
  const int levels = IsDooSabin ? 3 : 5;
  for (const Shape& shape : MakeShapes())
  {
    SCOPED_TRACE(shape.Name);
    const Steps steps(MakeLevel(shape.NumberOfVertices, shape.Polygons), Kind, levels);
    Points points = MakeRandomPoints(shape.NumberOfVertices, 3);
    for (int step = 0; step < levels; ++step)
    {
      SCOPED_TRACE(step);
      const Level& next = steps[step + 1];
      ExpectAverages(steps.GetRows(step));
      ExpectConforming(next);
      EXPECT_EQ(GetEuler(next), shape.Euler);
      if (shape.Orientation)
      {
        ExpectOriented(next);
      }
      const Points moved = steps.Apply(step, points);
      // The first faces are the old ones, and keep their centres: these are limit positions.
      for (int f = 0; f < steps[step].Mesh.NumberOfFaces; ++f)
      {
        EXPECT_EQ(next.Mesh.GetSize(f), steps[step].Mesh.GetSize(f));
        EXPECT_TRUE(IsNear(GetCentre(steps[step].Mesh, f, points), GetCentre(next.Mesh, f, moved)));
      }
      const auto carriers = steps.GetCarriers(step);
      ASSERT_EQ(static_cast<vtkIdType>(carriers.size()), next.Mesh.NumberOfFaces);
      const int faces = static_cast<int>(steps[step].Mesh.NumberOfFaces);
      for (const auto& carrier : carriers)
      {
        EXPECT_TRUE(carrier.First >= 0 && carrier.First < faces);
        EXPECT_TRUE(carrier.Second >= -1 && carrier.Second < faces);
      }
      points = moved;
    }
  }
}

// One step of Doo-Sabin, and two of midedge, make the boundary the quadratic spline.
TEST_P(SurfaceDualSchemes, BoundaryIsTheQuadraticSpline)
{
  const int stepsOfOne = IsDooSabin ? 1 : 2;
  for (const Shape& shape : MakeShapes())
  {
    if (!shape.Orientation || shape.Name == "three sheets" || shape.Name == "pinched")
    {
      continue; // half-edges of the boundary do not follow one another
    }
    SCOPED_TRACE(shape.Name);
    const Steps steps(MakeLevel(shape.NumberOfVertices, shape.Polygons), Kind, 2 * stepsOfOne);
    Points points = MakeRandomPoints(shape.NumberOfVertices, 3);
    for (int first : { 0, stepsOfOne })
    {
      Points next = points;
      for (int step = first; step < first + stepsOfOne; ++step)
      {
        next = steps.Apply(step, next);
      }
      ExpectChaikin(
        GetBoundary(steps[first], points), GetBoundary(steps[first + stepsOfOne], next));
      points = next;
    }
  }
}

// Inside a plane grid the points of the second step are odd multiples of 1 / scale, each once.
TEST_P(SurfaceDualSchemes, RegularGridStaysRegular)
{
  const double scale = IsDooSabin ? 8. : 4.;
  const Steps steps(MakeLevel(30, MakeQuads(5, 4)), Kind, 2);
  Points points;
  for (int i = 0; i < 30; ++i)
  {
    points.push_back({ i % 6 * 1., i / 6 * 1., i % 6 * 2. - i / 6 });
  }
  points = steps.Apply(1, steps.Apply(0, points));
  std::set<std::pair<double, double>> seen;
  for (const auto& p : points)
  {
    EXPECT_NEAR(p[2], 2. * p[0] - p[1], 1e-14);
    if (p[0] > 1. && p[0] < 4. && p[1] > 1. && p[1] < 3.)
    {
      EXPECT_EQ(std::fmod(scale * p[0], 2.), 1.);
      EXPECT_EQ(std::fmod(scale * p[1], 2.), 1.);
      EXPECT_TRUE(seen.emplace(p[0], p[1]).second);
    }
  }
  EXPECT_EQ(seen.size(), IsDooSabin ? 12u * 8u : 6u * 4u);
}

TEST_P(SurfaceDualSchemes, SheetsComeApartAtEdgesOfThreeFaces)
{
  const Steps steps(MakeLevel(5, { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } }), Kind, 1);
  EXPECT_EQ(steps[1].Mesh.NumberOfFaces, 3 * (IsDooSabin ? 7 : 4));
  EXPECT_EQ(steps[1].Mesh.NumberOfVertices, 3 * (IsDooSabin ? 9 : 6));
}

TEST_P(SurfaceDualSchemes, Valence2000)
{
  const int levels = IsDooSabin ? 2 : 4;
  for (const bool open : { false, true })
  {
    const Steps steps(MakeLevel(2002, surfacetools::MakeFan(2000, open).Faces), Kind, levels);
    ExpectAverages(steps.GetRows(levels - 1));
    ExpectConforming(steps[levels]);
    EXPECT_EQ(GetEuler(steps[levels]), 1);
  }
}

// Filters of one level are one filter of several, bit for bit: on all shapes, with a curve on
// edges of the surface, a free one, two lines on one edge, vertices with and without faces.
TEST_P(SurfaceDualSchemes, FiltersInARow)
{
  for (const Shape& shape : MakeShapes())
  {
    SCOPED_TRACE(shape.Name);
    const int n = shape.NumberOfVertices;
    const auto& face = shape.Polygons[0];
    const Data input = MakeData(MakeRandomPoints(n + 6, 3), shape.Polygons,
      { { face[1], face[0], face[2] }, { n, n + 2, n + 1 }, { n + 1, n + 2 }, { n + 2, n + 3 },
        { n + 5, n } },
      { face[1], n + 4 });
    std::vector<vtkIdType> labels;
    for (int i = 0; i < n + 6; ++i)
    {
      labels.push_back((7 * i) % 5);
    }
    AddIds(input->GetPointData(), "labels", labels, false);
    std::vector<vtkIdType> cells;
    for (int i = 0; i < input->GetNumberOfCells(); ++i)
    {
      cells.push_back(i);
    }
    AddIds(input->GetCellData(), "cells", cells, false);
    Data step = input;
    for (int levels = 1; levels <= 4; ++levels)
    {
      SCOPED_TRACE(levels);
      step = RunFilter(step, Scheme, 1);
      ExpectSameBits(step, RunFilter(input, Scheme, levels));
    }
  }
}

TEST_P(SurfaceDualSchemes, LinesAndVertices)
{
  // A free curve of three points, a line along an edge of the triangle, three vertex cells.
  const Points points = MakeRandomPoints(8, 3);
  const Data input = MakeData(points, { { 0, 1, 2 } }, { { 3, 4, 5 }, { 1, 0 } }, { 2, 6, 4 });
  const Data out = RunFilter(input, Scheme, 1);
  ASSERT_EQ(out->GetNumberOfVerts(), 3);
  ASSERT_EQ(out->GetNumberOfLines(), 6);
  auto expect = [&](vtkIdType id, const std::vector<std::pair<int, double>>& row)
  {
    double x[3];
    out->GetPoint(id, x);
    Point sum{};
    for (const auto& entry : row)
    {
      for (int c = 0; c < 3; ++c)
      {
        sum[c] += entry.second * points[entry.first][c];
      }
    }
    EXPECT_TRUE(IsNear({ x[0], x[1], x[2] }, sum));
  };
  auto getId = [&](vtkIdType cell, vtkIdType i)
  {
    vtkNew<vtkIdList> ids;
    out->GetCellPoints(cell, ids);
    return ids->GetId(i);
  };
  expect(getId(0, 0), { { 2, 1. } });
  expect(getId(1, 0), { { 6, 1. } });
  expect(getId(2, 0), { { 3, 0.125 }, { 4, 0.75 }, { 5, 0.125 } });
  expect(getId(3, 0), { { 3, 1. } });
  expect(getId(3, 1), { { 3, 0.5 }, { 4, 0.5 } });
  EXPECT_EQ(getId(4, 1), getId(2, 0));
  EXPECT_EQ(getId(4, 1), getId(5, 0));
  expect(getId(6, 1), { { 5, 1. } });
  expect(getId(7, 0), { { 1, 1. } });
  expect(getId(8, 1), { { 0, 1. } });
  // The point that no cell uses is there too.
  bool found = false;
  for (vtkIdType i = 0; i < out->GetNumberOfPoints(); ++i)
  {
    double x[3];
    out->GetPoint(i, x);
    found = found || IsNear({ x[0], x[1], x[2] }, points[7]);
  }
  EXPECT_TRUE(found);
}

// Creases and limits mean nothing here, and the filter says so.
TEST_P(SurfaceDualSchemes, WhatIsIgnoredIsSaid)
{
  const Data input = MakeData(MakeRandomPoints(4, 3), { { 0, 1, 2 }, { 2, 1, 3 } }, { { 1, 2 } });
  const Data plain = RunFilter(input, Scheme, 1);
  vtkNew<multi_dimensional_subdivision_tools::Messages> heard;
  vtkNew<vtkSurfaceSubdivision> filter;
  heard->Watch(filter);
  filter->SetInputData(input);
  filter->SetScheme(Scheme);
  filter->Update();
  EXPECT_TRUE(heard->Warnings.empty());
  filter->SetDetectFeatures(true);
  filter->SetFeatureAngle(0.);
  filter->Update();
  ASSERT_EQ(heard->Warnings.size(), 1u);
  EXPECT_NE(heard->Warnings[0].find("creases"), std::string::npos);
  ExpectSameBits(plain, filter->GetOutput());
}

INSTANTIATE_TEST_SUITE_P(Schemes, SurfaceDualSchemes,
  testing::Values(
    subdivision::SurfaceSchemeKind::DooSabin, subdivision::SurfaceSchemeKind::Midedge),
  [](const auto& scheme)
  { return scheme.param == subdivision::SurfaceSchemeKind::DooSabin ? "DooSabin" : "Midedge"; });
