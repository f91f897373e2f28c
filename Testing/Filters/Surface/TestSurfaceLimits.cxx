// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSurfaceLimits.cxx
 * Limit positions and normals of surfaces do not depend on the level at which they are asked for,
 * nor on the order and the orientation of faces.
 */
#include "PointTools.h"
#include "SurfaceTools.h"

using namespace surfacetools;
using namespace point_tools;

namespace
{

/// A grid of 5 x 5 fields without a quarter of 2 x 2 or more: a concave corner, which is flagged.
Model MakeNotched(bool triangles, int from)
{
  Model grid = MakeSheet(5, 5, triangles, { 1., 0., 0. }, { 0., 1., 0. });
  Polygons faces;
  for (const auto& face : grid.Faces)
  {
    double x = 0.;
    double y = 0.;
    for (const vtkIdType v : face)
    {
      x += grid.Points[v][0] / static_cast<double>(face.size());
      y += grid.Points[v][1] / static_cast<double>(face.size());
    }
    if (x < from || y < from)
    {
      faces.push_back(face);
    }
  }
  grid.Faces = faces;
  grid.Corners = { from * 6 + from };
  const std::vector<Point> noise = MakeRandomPoints(grid.Points.size(), 3);
  for (std::size_t i = 0; i < noise.size(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      grid.Points[i][c] += (c == 2 ? 0.5 : 0.2) * noise[i][c];
    }
  }
  return grid;
}

Point GetNormal(const std::vector<Point>& first, const std::vector<Point>& second, std::size_t i)
{
  const Point& a = first[i];
  const Point& b = second[i];
  Point n = { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  for (double& x : n)
  {
    x = length > 0. ? x / length : 0.;
  }
  return n;
}

vtkSmartPointer<vtkPolyData> RunWithCorners(const Model& model, int scheme, int levels)
{
  const auto input = MakeInput(model);
  vtkNew<vtkCellArray> vertices;
  for (const vtkIdType corner : model.Corners)
  {
    vertices->InsertNextCell(1, &corner);
  }
  input->SetVerts(vertices);
  vtkNew<vtkIntArray> flags;
  flags->SetName("Singular");
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    flags->InsertNextValue(
      cell < static_cast<vtkIdType>(model.Corners.size() + model.Lines.size()));
  }
  input->GetCellData()->AddArray(flags);
  return RunFilter(input, scheme, levels, true);
}

constexpr int SchemesWithLimits[] = { vtkSurfaceSubdivision::LOOP,
  vtkSurfaceSubdivision::CATMULL_CLARK, vtkSurfaceSubdivision::MODIFIED_BUTTERFLY,
  vtkSurfaceSubdivision::FOUR_EIGHT, vtkSurfaceSubdivision::SQRT_THREE };

bool IsOfTriangles(int scheme)
{
  return scheme != vtkSurfaceSubdivision::CATMULL_CLARK &&
    scheme != vtkSurfaceSubdivision::FOUR_EIGHT;
}

}

TEST(SurfaceLimits, NearConcaveCornersTheyAreThoseOfAllLevels)
{
  for (const int scheme : SchemesWithLimits)
  {
    for (const int from : { 2, 3 })
    {
      const Model model = MakeNotched(IsOfTriangles(scheme), from);
      Walk walk(model, static_cast<SurfaceSchemeKind>(scheme));
      const std::vector<Point> limits = walk.GetLimit();
      const std::vector<Point> first = walk.GetLimit(LimitKind::Tangent1);
      const std::vector<Point> second = walk.GetLimit(LimitKind::Tangent2);
      for (int level = 1; level < 5; ++level)
      {
        walk.Step();
        const std::vector<Point> later = walk.GetLimit();
        const std::vector<Point> along = walk.GetLimit(LimitKind::Tangent1);
        const std::vector<Point> across = walk.GetLimit(LimitKind::Tangent2);
        for (std::size_t i = 0; i < limits.size(); ++i)
        {
          EXPECT_LT(GetDistance(later[i], limits[i]), 1e-12) << scheme << " vertex " << i;
          EXPECT_LT(GetDistance(GetNormal(along, across, i), GetNormal(first, second, i)), 1e-9)
            << scheme << " vertex " << i << " level " << level;
        }
      }
    }
  }
}

TEST(SurfaceLimits, NormalsAtCornersDoNotDependOnTheOrderOfFaces)
{
  // Four faces around a corner at the boundary, with two sectors, of 80 and of 240 degrees, in one
  // plane; the same with a gap between the sectors.
  for (const bool gap : { false, true })
  {
    for (const int scheme : SchemesWithLimits)
    {
      const bool triangles = IsOfTriangles(scheme);
      Model model;
      model.Points = { { 0, 0, 0 } };
      for (int i = 0; i < 10; ++i)
      {
        const double turn = (gap && i > 2 ? 10. : 0.) + 40. * (gap && i > 2 ? i - 1 : i);
        const double angle = turn * std::acos(-1.) / 180.;
        model.Points.push_back({ std::cos(angle), std::sin(angle), 0. });
      }
      model.Corners = { 0 };
      if (!gap)
      {
        model.Lines = { { 0, 3 } };
      }
      int order[] = { 0, 1, 2, 3 };
      do
      {
        model.Faces.clear();
        for (const int quarter : order)
        {
          const vtkIdType a = 1 + 2 * quarter + (gap && quarter > 0 ? 1 : 0);
          if (triangles)
          {
            model.Faces.push_back({ 0, a, a + 1 });
            model.Faces.push_back({ 0, a + 1, a + 2 });
          }
          else
          {
            model.Faces.push_back({ 0, a, a + 1, a + 2 });
          }
        }
        for (int levels = 0; levels < 3; ++levels)
        {
          const Point normal = GetNormals(RunWithCorners(model, scheme, levels), 1)[0];
          EXPECT_NEAR(normal[2], 1., 1e-12)
            << scheme << " order " << order[0] << order[1] << order[2] << order[3] << gap;
        }
      } while (std::next_permutation(order, order + 4));
    }
  }
}

TEST(SurfaceLimits, ManyCornersTakeLinearTime)
{
  // Separate triangles, or quads, each vertex of which is a corner: quadratic time would be longer
  // than ctest waits.
  for (const int scheme :
    { vtkSurfaceSubdivision::CATMULL_CLARK, vtkSurfaceSubdivision::SQRT_THREE })
  {
    Model model;
    for (vtkIdType i = 0; i < 300000; ++i)
    {
      const double x = 2. * static_cast<double>(i);
      model.Points.push_back({ x, 0., 0. });
      model.Points.push_back({ x + 1., 0., 0. });
      model.Points.push_back({ x, 1., 0. });
      model.Faces.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
      for (vtkIdType k = 0; k < 3; ++k)
      {
        model.Corners.push_back(3 * i + k);
      }
    }
    const auto output = RunWithCorners(model, scheme, 0);
    for (const Point& normal : GetNormals(output, model.Points.size()))
    {
      ASSERT_NEAR(normal[2], 1., 1e-9);
    }
  }
}

TEST(SurfaceLimits, NormalsOfOneSideWhereFacesAreTurnedOver)
{
  for (const int scheme : SchemesWithLimits)
  {
    const bool triangles = IsOfTriangles(scheme);
    Model model = MakeSheet(5, 5, triangles, { 1., 0., 0. }, { 0., 1., 0. });
    model.Corners.clear();
    for (std::size_t face = 1; face < model.Faces.size(); ++face)
    {
      if (face * 7 % 5 < 2)
      {
        std::reverse(model.Faces[face].begin(), model.Faces[face].end());
      }
    }
    for (int levels = 0; levels < 3; ++levels)
    {
      const auto output = RunFilter(MakeInput(model), scheme, levels, true);
      const std::vector<Point> normals =
        GetNormals(output, static_cast<std::size_t>(output->GetNumberOfPoints()));
      for (std::size_t i = 0; i < normals.size(); ++i)
      {
        EXPECT_NEAR(normals[i][2], 1., 1e-9)
          << "scheme " << scheme << " level " << levels << " point " << i;
      }
    }
  }
}

TEST(SurfaceLimits, ParallelTangentsHaveANormalForShading)
{
  // Two doublets: vertices of two faces inside a surface. Their two tangents are parallel, and the
  // faces say what is up.
  Model model;
  model.Points = { { 0.3, 0.1, 0.7 }, { -1, -1, 0.1 }, { 1, -1, 0.3 }, { 1.1, 1, -0.2 },
    { -1, 1.2, 0.4 }, { 0.1, 0.2, 2.3 } };
  model.Faces = { { 1, 2, 3, 0 }, { 1, 0, 3, 4 }, { 1, 4, 5, 2 }, { 2, 5, 4, 3 } };
  std::vector<std::vector<Point>> found;
  for (int levels = 0; levels < 6; ++levels)
  {
    found.push_back(GetNormals(
      RunFilter(MakeInput(model), vtkSurfaceSubdivision::CATMULL_CLARK, levels, true), 6));
    for (std::size_t i = 0; i < 6; ++i)
    {
      EXPECT_NEAR(Length(found.back()[i]), 1., 1e-12) << levels;
    }
    for (std::size_t i = 1; i < 5; ++i)
    {
      EXPECT_LT(GetDistance(found.back()[i], found[0][i]), 1e-9) << levels;
    }
  }
}
