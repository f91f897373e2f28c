// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSurfacePlaceDerivatives.cxx
 * The limit at places of polygons: closed formulas, derivatives, and what is near extraordinary
 * vertices.
 */
#include "SurfacePlaceTools.h"

#include "vtkMultiDimensionalSubdivision.h"

using namespace surfacetools;

namespace
{

/// The cells around point 0, and those around these, three rings in all, with the same first face.
vtkSmartPointer<vtkPolyData> CropAroundFirst(vtkPolyData* mesh)
{
  std::set<vtkIdType> inside{ 0 };
  std::vector<bool> taken(static_cast<std::size_t>(mesh->GetNumberOfCells()), false);
  vtkNew<vtkIdList> points;
  for (int ring = 0; ring < 3; ++ring)
  {
    std::set<vtkIdType> more = inside;
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      mesh->GetCellPoints(cell, points);
      if (std::any_of(
            points->begin(), points->end(), [&inside](vtkIdType p) { return inside.count(p) > 0; }))
      {
        taken[static_cast<std::size_t>(cell)] = true;
        more.insert(points->begin(), points->end());
      }
    }
    inside = more;
  }
  Model cropped;
  std::map<vtkIdType, vtkIdType> numbers;
  for (const vtkIdType point : inside) // 0 stays the first
  {
    const auto number = static_cast<vtkIdType>(numbers.size());
    numbers[point] = number;
    cropped.Points.push_back(GetPoint(mesh, point));
  }
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    if (taken[static_cast<std::size_t>(cell)])
    {
      mesh->GetCellPoints(cell, points);
      std::vector<vtkIdType> face;
      for (const vtkIdType point : *points)
      {
        face.push_back(numbers[point]);
      }
      cropped.Faces.push_back(face);
    }
  }
  return MakeInput(cropped);
}

}

/// On a regular grid the limit is the uniform bicubic B-spline.
TEST(SurfacePlaceDerivatives, RegularQuadsAreBSplines)
{
  const Model model = MakeBumpySheet(5, false, false);
  const auto input = MakeInput(model);
  const auto point = [&](int x, int y)
  { return model.Points[static_cast<std::size_t>(6 * y + x)]; };
  vtkNew<vtkIdList> first;
  const vtkIdType cell = 12; // in the middle
  input->GetCellPoints(cell, first);
  const int x0 = static_cast<int>(first->GetId(0) % 6);
  const int y0 = static_cast<int>(first->GetId(0) / 6);
  ASSERT_EQ(first->GetId(1), first->GetId(0) + 1);
  ASSERT_EQ(first->GetId(3), first->GetId(0) + 6);
  Places places;
  for (const double u : { 0., 0.3, 0.5, 1. })
  {
    for (const double v : { 0., 0.6, 1. })
    {
      places.Add(cell, { u, v, 17. }); // quads have no third parameter
    }
  }
  const auto result = Evaluate(input, Filter::CATMULL_CLARK, places);
  // The spline by its pieces: degree 3, by the recursion of Cox and de Boor.
  const std::function<double(int, double)> spline = [&spline](int degree, double t) -> double
  {
    if (degree == 0)
    {
      return t >= 0. && t < 1. ? 1. : 0.;
    }
    return (t * spline(degree - 1, t) + (degree + 1. - t) * spline(degree - 1, t - 1.)) / degree;
  };
  const auto weigh = [&spline](double t, int i, int derivative)
  {
    const double at = t + 3. - i; // of control point i - 1
    return derivative == 0 ? spline(3, at) : spline(2, at) - spline(2, at - 1.);
  };
  for (vtkIdType i = 0; i < places.GetSize(); ++i)
  {
    for (int derivative = 0; derivative < 3; ++derivative)
    {
      Point expected{};
      for (int a = 0; a < 4; ++a)
      {
        for (int b = 0; b < 4; ++b)
        {
          const double weight = weigh(places.Parameters->GetComponent(i, 0), a, derivative == 1) *
            weigh(places.Parameters->GetComponent(i, 1), b, derivative == 2);
          for (int c = 0; c < 3; ++c)
          {
            expected[c] += weight * point(x0 - 1 + a, y0 - 1 + b)[c];
          }
        }
      }
      const Point found = derivative == 0
        ? GetPoint(result, i)
        : GetTuple(result, derivative == 1 ? "DerivativeU" : "DerivativeV", i);
      EXPECT_LT(GetDistance(found, expected), 1e-13) << i << " " << derivative;
    }
  }
}

/// At places 2^-k from an extraordinary vertex the limit is that of a vertex after k + 1 steps of
/// the filter, made of the surroundings alone.
TEST(SurfacePlaceDerivatives, NearExtraordinaryVerticesAgainstDeepLevels)
{
  for (const int scheme : PlaceSchemes)
  {
    const bool triangles = scheme == Filter::LOOP;
    for (const int n : { 3, 5, 6, 12 })
    {
      const auto input = MakeInput(MakeStar(n, triangles));
      auto mesh = input;
      Places places;
      std::vector<Point> expected;
      double at = 1.;
      for (int k = 0; k < 20; ++k)
      {
        const auto limit = RunFilter(CropAroundFirst(mesh), scheme, 1, true);
        // The second corner of the first child is on the first edge; the third one of a quad is
        // inside, and the second one of the middle triangle between the far corners.
        vtkNew<vtkIdList> points;
        at /= 2.;
        limit->GetCellPoints(0, points);
        places.Add(0, { at, 0., 0. });
        expected.push_back(GetPoint(limit, points->GetId(1)));
        limit->GetCellPoints(triangles ? 3 : 0, points);
        places.Add(0, { at, at, 0. });
        expected.push_back(GetPoint(limit, points->GetId(triangles ? 1 : 2)));
        const auto next = RunFilter(CropAroundFirst(mesh), scheme, 1);
        mesh = vtkSmartPointer<vtkPolyData>::New(); // without the stamp
        mesh->SetPoints(next->GetPoints());
        mesh->SetPolys(next->GetPolys());
      }
      const auto result = Evaluate(input, scheme, places);
      for (vtkIdType i = 0; i < places.GetSize(); ++i)
      {
        EXPECT_LT(GetDistance(GetPoint(result, i), expected[static_cast<std::size_t>(i)]), 1e-12)
          << scheme << " valence " << n << " place " << i;
      }
    }
  }
}

/// Derivatives are what values differ by, at places near extraordinary vertices, too.
TEST(SurfacePlaceDerivatives, DerivativesAreDifferences)
{
  for (const int scheme : PlaceSchemes)
  {
    for (const int n : { 3, 5, 6, 12 })
    {
      const auto input = MakeInput(MakeStar(n, scheme == Filter::LOOP));
      Places places;
      std::vector<double> steps;
      for (const double scale : { 1., 1. / 16., 1. / 1024. })
      {
        for (const Point& p : { Point{ 0.4, 0.35, 0. }, Point{ 0.55, 0.2, 0. } })
        {
          const double h = scale / 4096.;
          const Point at = { scale * p[0], scale * p[1], 0. };
          places.Add(0, at);
          steps.push_back(h);
          for (int k = 0; k < 2; ++k)
          {
            for (const double step : { -2., -1., 1., 2. })
            {
              Point q = at;
              q[k] += step * h;
              places.Add(0, q);
            }
          }
        }
      }
      const auto result = Evaluate(input, scheme, places);
      for (std::size_t i = 0; i < steps.size(); ++i)
      {
        const vtkIdType centre = 9 * static_cast<vtkIdType>(i);
        for (int k = 0; k < 2; ++k)
        {
          const char* names[2] = { "DerivativeU", "DerivativeV" };
          const Point derivative = GetTuple(result, names[k], centre);
          for (int c = 0; c < 3; ++c)
          {
            const auto get = [&](vtkIdType step)
            { return GetPoint(result, centre + 1 + 4 * k + step)[c]; };
            // The formula is exact for a polynomial of degree 4.
            const double difference =
              (get(0) - 8. * get(1) + 8. * get(2) - get(3)) / (12. * steps[i]);
            EXPECT_NEAR(derivative[c], difference, 1e-14 / steps[i])
              << scheme << " valence " << n << " place " << i << " by " << k;
          }
        }
        const Point normal = GetTuple(result, "LimitNormals", centre);
        const Point u = GetTuple(result, "DerivativeU", centre);
        EXPECT_NEAR(normal[0] * u[0] + normal[1] * u[1] + normal[2] * u[2], 0., 1e-12);
      }
    }
  }
}

/// At an extraordinary vertex the normal is the one that the filter has there, and near it almost
/// so: the more faces, the more slowly normals come near it.
TEST(SurfacePlaceDerivatives, NormalsAtExtraordinaryVertices)
{
  for (const int scheme : PlaceSchemes)
  {
    for (const int n : { 3, 5, 6, 12 })
    {
      const auto input = MakeInput(MakeStar(n, scheme == Filter::LOOP));
      Places places;
      places.Add(0, { 0., 0., 0. });
      places.Add(0, { std::ldexp(1., -40), std::ldexp(1., -41), 0. });
      const auto result = Evaluate(input, scheme, places);
      const auto limit = RunFilter(input, scheme, 0, true);
      for (const vtkIdType i : { 0, 1 })
      {
        EXPECT_LT(
          GetDistance(GetTuple(result, "LimitNormals", i), GetTuple(limit, "LimitNormals", 0)),
          i == 0 || n < 6 ? 1e-8 : 1e-2)
          << scheme << " valence " << n << " place " << i;
      }
      EXPECT_LT(GetDistance(GetPoint(result, 0), GetPoint(limit, 0)), 1e-14);
    }
  }
}

/// Beside an extraordinary vertex, 2^-k of a face away, the main filter has the derivatives of this
/// one, which tend to 0 or to infinity. At the vertex it comes near the tangent plane only.
TEST(SurfacePlaceDerivatives, MainFilterNearExtraordinaryVertices)
{
  const std::map<int, double> errorsOfNormals = { { 3, 1e-13 }, { 4, 1e-9 }, { 5, 1e-12 },
    { 7, 1e-11 }, { 12, 1e-4 } };
  for (const auto& [n, errorOfNormal] : errorsOfNormals)
  {
    const auto input = MakeInput(MakeStar(n, true));
    Places places;
    places.Add(0, { 0., 0., 0. });
    for (int k = 1; k <= 48; ++k)
    {
      places.Add(0, { std::ldexp(1., -k), std::ldexp(1., -k - 1), 0. });
    }
    const auto expected = Evaluate(input, Filter::LOOP, places);
    vtkNew<vtkMultiDimensionalSubdivision> filter;
    filter->SetInputData(input);
    const auto result = Evaluate(filter.Get(), places);
    const Point none = { 0., 0., 0. };
    for (vtkIdType k = 0; k < places.GetSize(); ++k)
    {
      SCOPED_TRACE(testing::Message() << "valence " << n << ", place " << k);
      EXPECT_LT(GetDistance(GetPoint(result, k), GetPoint(expected, k)), 1e-14);
      const double size = std::max(GetDistance(GetTuple(expected, "DerivativeU", k), none),
        GetDistance(GetTuple(expected, "DerivativeV", k), none));
      for (const char* name : { "DerivativeU", "DerivativeV" })
      {
        if (k > 0)
        {
          EXPECT_LT(
            GetDistance(GetTuple(result, name, k), GetTuple(expected, name, k)), 1e-12 * size)
            << name;
        }
      }
    }
    EXPECT_LT(
      GetDistance(GetTuple(result, "LimitNormals", 0), GetTuple(expected, "LimitNormals", 0)),
      errorOfNormal)
      << n;
  }
}
