// SPDX-License-Identifier: BSD-3-Clause
#include "CellsToSimplicesTools.h"

using namespace cells_to_simplices_tools;

namespace
{

/// Points (x, y) on a tilted plane, far from the origin, under the given numbering.
Mesh TiltedPolygon(const std::vector<std::array<double, 2>>& outline, const Ids& ids)
{
  Mesh mesh;
  mesh.Points.resize(outline.size());
  for (size_t i = 0; i < outline.size(); ++i)
  {
    const auto& p = outline[i];
    mesh.Points[ids[i]] = { 100 + 0.6 * p[0], 200 + p[1], 0.8 * p[0] };
  }
  mesh.Cells.push_back({ VTK_POLYGON, ids });
  return mesh;
}

double AreaOf(const std::vector<std::array<double, 2>>& outline)
{
  double twice = 0;
  for (size_t i = 0; i < outline.size(); ++i)
  {
    const auto& p = outline[i];
    const auto& q = outline[(i + 1) % outline.size()];
    twice += p[0] * q[1] - p[1] * q[0];
  }
  return twice / 2;
}

/// n - 2 triangles that face the polygon's way and have its area: so none overlaps another.
void ExpectTilesPolygon(const std::vector<std::array<double, 2>>& outline, const Ids& ids)
{
  const Mesh mesh = TiltedPolygon(outline, ids);
  const auto result = Convert(mesh);
  const auto simplices = GetSimplices(result);
  ASSERT_EQ(simplices.size(), outline.size() - 2);
  const Point normal = { -0.8, 0, 0.6 };
  double sum = 0;
  for (const Ids& s : simplices)
  {
    const double area = Dot(TwiceArea(mesh.Points, s), normal) / 2;
    EXPECT_GT(area, 1e-9 * AreaOf(outline));
    sum += area;
  }
  EXPECT_NEAR(sum, AreaOf(outline), 1e-9 * AreaOf(outline));
  EXPECT_TRUE(result.Warnings.empty());
}

}

TEST(CellsToSimplices, ConcavePolygonsAreTiled)
{
  using Outline = std::vector<std::array<double, 2>>;
  const Outline arrow = { { 0, 0 }, { 4, 0 }, { 4, 3 }, { 2, 1 }, { 0, 3 } };
  Outline comb = { { 0, 0 }, { 12, 0 } };
  for (int i = 6; i > 0; --i)
  {
    comb.push_back({ 2.0 * i, 5 });
    comb.push_back({ 2.0 * i - 1, 0.5 });
  }
  Outline spiral;
  for (int i = 0; i <= 60; ++i)
  {
    const double t = 0.2 * i;
    spiral.push_back({ (1 + t) * std::cos(t), (1 + t) * std::sin(t) });
  }
  for (int i = 60; i >= 0; --i)
  {
    const double t = 0.2 * i;
    spiral.push_back({ (0.5 + t) * std::cos(t), (0.5 + t) * std::sin(t) });
  }
  std::mt19937 random(21);
  for (const Outline& outline : { arrow, comb, spiral })
  {
    Ids ids = Range(outline.size());
    for (int i = 0; i < 20; ++i)
    {
      ExpectTilesPolygon(outline, ids);
      std::shuffle(ids.begin(), ids.end(), random);
    }
  }
}

TEST(CellsToSimplices, RandomStarPolygonsAreTiled)
{
  std::mt19937 random(22);
  std::uniform_real_distribution<double> radius(0.1, 2);
  for (int i = 0; i < 300; ++i)
  {
    const int n = 5 + i % 30;
    std::vector<std::array<double, 2>> outline;
    for (int k = 0; k < n; ++k)
    {
      const double r = radius(random);
      const double t = 2 * 3.14159265358979 * k / n;
      outline.push_back({ r * std::cos(t), r * std::sin(t) });
    }
    ExpectTilesPolygon(outline, Range(outline.size()));
  }
}

TEST(CellsToSimplices, PointsInsideStraightEdgesGiveNoFlatPieces)
{
  ExpectTilesPolygon({ { 0, 0 }, { 1, 0 }, { 2, 0 }, { 2, 2 }, { 0, 2 } }, Range(5));
  ExpectTilesPolygon({ { 0, 0 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 0, 3 } }, Range(5));
  ExpectTilesPolygon({ { 0, 0 }, { 0.1, 0 }, { 0.2, 0 }, { 0.3, 0 }, { 0.7, 0 }, { 1, 0 },
                       { 2.0 / 3, 1.0 / 3 }, { 1.0 / 3, 2.0 / 3 }, { 0, 1 }, { 0, 0.3 } },
    Range(10));
}

TEST(CellsToSimplices, EqualEarsAreCutBySmallestId)
{
  std::vector<std::array<double, 2>> hexagon;
  for (int k = 0; k < 6; ++k)
  {
    hexagon.push_back({ std::cos(k * 1.0471975511965976), std::sin(k * 1.0471975511965976) });
  }
  const Mesh mesh = TiltedPolygon(hexagon, { 5, 2, 0, 4, 1, 3 });
  EXPECT_EQ(GetSimplices(Convert(mesh))[0], (Ids{ 2, 0, 4 }));
  const vtkIdType globalIds[6] = { 5, 4, 3, 2, 1, 0 };
  EXPECT_EQ(GetSimplices(CellsToSimplices(MakeGrid(mesh), globalIds))[0], (Ids{ 3, 5, 2 }));
}

TEST(CellsToSimplices, DegeneratePolygonsStillGiveAllPieces)
{
  std::mt19937 random(23);
  const double huge = std::numeric_limits<double>::max();
  const std::vector<std::vector<Point>> outlines = { { { 0, 0, 0 }, { 1, 1, 1 }, { 2, 2, 2 },
                                                       { 3, 3, 3 }, { 1.5, 1.5, 1.5 } },
    { { 7, 7, 7 }, { 7, 7, 7 }, { 7, 7, 7 }, { 7, 7, 7 }, { 7, 7, 7 }, { 7, 7, 7 } },
    { { 0, 0, 0 }, { 2, 2, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { -1, 1, 0 } },
    { { 0, 0, 0 }, { 2, 2, 0 }, { 4, 0, 0 }, { 4, 2, 0 }, { 2, 0, 0 }, { 0, 2, 0 } },
    { { -huge, 0, 0 }, { 0, -huge, 0 }, { huge, 0, 0 }, { 0, huge, 0 }, { -huge, huge, 0 } },
    { { 0, 0, 0 }, { 1e-320, 0, 0 }, { 2e-320, 1e-320, 0 }, { 0, 2e-320, 0 }, { 0, 1e-320, 0 } } };
  for (const auto& outline : outlines)
  {
    const Mesh mesh = Shuffled(VTK_POLYGON, outline, random);
    const auto result = Convert(mesh);
    EXPECT_EQ(result.Simplices.Dimensions.size(), outline.size() - 2);
    ExpectSound(result, 1);
  }
}

TEST(CellsToSimplices, SizeAndPlaceOfAPolygonDoNotMatter)
{
  const std::vector<std::array<double, 2>> outline = { { 0, 0 }, { 5, 0 }, { 4, 3 }, { 2, 1 },
    { 1, 4 } };
  for (int start = 0; start < 5; ++start)
  {
    Mesh mesh = TiltedPolygon(outline, Range(5));
    Ids& loop = mesh.Cells[0].Points;
    std::rotate(loop.begin(), loop.begin() + start, loop.end());
    const auto expected = GetSimplices(Convert(mesh));
    for (const double scale : { 1e-300, 1e-7, 1e150, 1e300 })
    {
      Mesh other = mesh;
      for (size_t i = 0; i < 5; ++i)
      {
        for (int k = 0; k < 3; ++k)
        {
          // The small one stays far away: what counts is its own size.
          const double x = mesh.Points[i][k] - mesh.Points[0][k];
          other.Points[i][k] = scale == 1e-7 ? 200 + x * scale : x * scale;
        }
      }
      EXPECT_EQ(GetSimplices(Convert(other)), expected) << scale;
    }
  }
}

TEST(CellsToSimplices, PolygonWithBridgeToAHole)
{
  // The bridge (0,0)-(1,1) is passed twice, by different points at the same places.
  ExpectTilesPolygon({ { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 }, { 0, 0 }, { 1, 1 }, { 1, 3 },
                       { 3, 3 }, { 3, 1 }, { 1, 1 } },
    Range(10));
}

TEST(CellsToSimplices, RingsAlongBridgesAreCutWithoutAWarning)
{
  // A square with two square holes, and bridges between them.
  Mesh mesh;
  mesh.Points = { { 0, 0, 0 }, { 9, 0, 0 }, { 9, 9, 0 }, { 0, 9, 0 }, { 1, 1, 0 }, { 3, 1, 0 },
    { 3, 3, 0 }, { 1, 3, 0 }, { 5, 5, 0 }, { 7, 5, 0 }, { 7, 7, 0 }, { 5, 7, 0 } };
  mesh.Cells = { { VTK_POLYGON, { 0, 1, 2, 3, 0, 4, 7, 6, 8, 11, 10, 9, 8, 6, 5, 4 } } };
  const auto result = Convert(mesh);
  EXPECT_TRUE(result.Warnings.empty());
  double area = 0.;
  for (const Ids& s : GetSimplices(result))
  {
    const double twice = TwiceArea(mesh.Points, s)[2];
    EXPECT_GT(twice, 0.);
    area += twice / 2.;
  }
  EXPECT_NEAR(area, 81. - 4. - 4., 1e-12);
}
