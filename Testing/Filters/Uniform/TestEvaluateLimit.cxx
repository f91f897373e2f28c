// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestEvaluateLimit.cxx
 * The limit at places of cells: against the projected points of fine levels, closed formulas, and
 * differences.
 */
#include "LimitProbeTools.h"
#include "PlaceTools.h"

#include "vtkSubdivisionModelSource.h"

using namespace multi_dimensional_subdivision_tools;
using namespace place_tools;

namespace
{

using Filter = vtkMultiDimensionalSubdivision;

Grid MakeModel(int model)
{
  const Grid grid = InDouble(LoadModel(model));
  grid->GetPointData()->AddArray(
    MakeArray<vtkDoubleArray>("Random", 2, grid->GetNumberOfPoints(), -1., 1., 7));
  return grid;
}

/// The parameters of a point of a cell, which are multiples of 1/256.
Point FindParameters(vtkUnstructuredGrid* grid, const Ids& cell, const Point& x)
{
  const auto size = static_cast<int>(cell.size());
  const Point origin = GetPoint(grid, cell[0]);
  // The normal equations, by elimination.
  double m[3][4] = {};
  std::vector<Point> sides;
  for (int k = 1; k < size; ++k)
  {
    const Point p = GetPoint(grid, cell[k]);
    sides.push_back({ p[0] - origin[0], p[1] - origin[1], p[2] - origin[2] });
  }
  for (int i = 0; i < size - 1; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      for (int k = 0; k < size - 1; ++k)
      {
        m[i][k] += sides[i][c] * sides[k][c];
      }
      m[i][3] += sides[i][c] * (x[c] - origin[c]);
    }
  }
  for (int i = 0; i < size - 1; ++i)
  {
    for (int row = 0; row < size - 1; ++row)
    {
      const double factor = row == i ? 0. : m[row][i] / m[i][i];
      for (int c = 0; c < 4 && row != i; ++c)
      {
        m[row][c] -= factor * m[i][c];
      }
    }
  }
  Point parameters{};
  for (int i = 0; i < size - 1; ++i)
  {
    parameters[i] = std::round(256. * m[i][3] / m[i][i]) / 256.;
  }
  return parameters;
}

/// A corner of a cell.
using Corner = std::pair<vtkIdType, std::size_t>;

/// So many random corners of cells of a mesh; -1: each point once.
std::vector<Corner> ChooseCorners(vtkUnstructuredGrid* mesh, vtkIdType count, unsigned seed)
{
  std::vector<Corner> corners;
  std::mt19937 random(seed);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const auto cell =
      static_cast<vtkIdType>(random() % static_cast<unsigned>(mesh->GetNumberOfCells()));
    corners.emplace_back(cell, random() % GetCell(mesh, cell).size());
  }
  std::vector<bool> isMet(static_cast<std::size_t>(mesh->GetNumberOfPoints()), count >= 0);
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells() && count < 0; ++cell)
  {
    const Ids ids = GetCell(mesh, cell);
    for (std::size_t k = 0; k < ids.size(); ++k)
    {
      if (!isMet[ids[k]])
      {
        isMet[ids[k]] = true;
        corners.emplace_back(cell, k);
      }
    }
  }
  return corners;
}

/// Compares values at places with what ProjectToLimit gives there after some levels: at so many
/// random vertices of the last one, or (-1) at all.
void CheckAgainstLevels(
  vtkUnstructuredGrid* input, Filter* filter, int levels, vtkIdType count, unsigned seed)
{
  vtkNew<Filter> linear;
  linear->SetInputData(input);
  linear->SetVolumeSchemeToLinear();
  linear->SetNumberOfLevels(levels);
  linear->GenerateOriginalIdsOn();
  linear->Update();
  filter->SetInputData(input);
  filter->SetNumberOfLevels(levels);
  filter->ProjectToLimitOn();
  filter->Update();
  vtkUnstructuredGrid* fine = filter->GetOutput();
  ASSERT_EQ(fine->GetNumberOfCells(), linear->GetOutput()->GetNumberOfCells());
  vtkDataArray* parents = linear->GetOutput()->GetCellData()->GetArray("vtkOriginalCellIds");
  Places places;
  Ids expected;
  for (const auto& [cell, k] : ChooseCorners(fine, count, seed))
  {
    const Ids corners = GetCell(linear->GetOutput(), cell);
    const auto parent = static_cast<vtkIdType>(parents->GetComponent(cell, 0));
    ASSERT_EQ(corners, GetCell(fine, cell));
    places.Add(parent,
      FindParameters(input, GetCell(input, parent), GetPoint(linear->GetOutput(), corners[k])));
    expected.push_back(corners[k]);
  }
  const auto result = Evaluate(filter, places);
  const double size = input->GetLength();
  for (vtkIdType i = 0; i < places.GetSize(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      ASSERT_NEAR(GetPoint(result, i)[c], GetPoint(fine, expected[i])[c], 1e-12 * size)
        << "place " << i << " in cell " << places.Cells->GetValue(i) << " of type "
        << input->GetCellType(places.Cells->GetValue(i)) << " at "
        << places.Parameters->GetComponent(i, 0) << " " << places.Parameters->GetComponent(i, 1)
        << " " << places.Parameters->GetComponent(i, 2);
    }
    for (int c = 0; c < 2 && input->GetPointData()->HasArray("Random"); ++c)
    {
      ASSERT_NEAR(result->GetPointData()->GetArray("Random")->GetComponent(i, c),
        fine->GetPointData()->GetArray("Random")->GetComponent(expected[i], c), 1e-12);
    }
  }
}

/// n triangles around a vertex, or tetrahedra around an edge, and if wanted a curve from there on.
Grid MakeStar(vtkIdType n, bool isSolid, bool hasCurve = true)
{
  std::vector<Point> points{ { 0.1, 0., 0.4 }, { -0.3, 0.2, 1. }, { 0.1, -0.3, 1.9 },
    { 0., 0.1, -0.8 } };
  std::vector<Cell> cells{ { VTK_LINE, { 0, 1 } }, { VTK_LINE, { 2, 1 } } };
  cells.resize(hasCurve ? 2 : 0);
  const vtkIdType around = std::max<vtkIdType>(n, 3);
  for (vtkIdType i = 0; i < around; ++i)
  {
    const double angle = 6.28318530717959 * static_cast<double>(i) / static_cast<double>(around);
    points.push_back({ std::cos(angle), 1.2 * std::sin(angle), 0.1 * static_cast<double>(i % 3) });
  }
  for (vtkIdType i = 0; i < n; ++i)
  {
    const vtkIdType a = 4 + i;
    const vtkIdType b = 4 + (i + 1) % around;
    cells.push_back(
      isSolid ? Cell{ VTK_TETRA, { 0, 3, a, b } } : Cell{ VTK_TRIANGLE, { 0, a, b } });
  }
  const Grid grid = MakeGrid(points, cells);
  grid->GetPointData()->AddArray(
    MakeArray<vtkDoubleArray>("Random", 2, grid->GetNumberOfPoints(), -1., 1., 7));
  return grid;
}

}

TEST(EvaluateLimit, CurvesAreCubicBSplines)
{
  const std::vector<Point> p = { { 0., 0., 0. }, { 1., 2., 0. }, { 3., 1., 1. }, { 4., -1., 2. } };
  const Grid input =
    MakeGrid(p, { { VTK_LINE, { 0, 1 } }, { VTK_LINE, { 2, 1 } }, { VTK_LINE, { 2, 3 } } });
  vtkNew<Filter> filter;
  filter->SetInputData(input);
  Places places;
  for (const double u : { 0., 0.3, 0.7, 1. })
  {
    places.Add(1, { u, 9., 9. }); // from point 2 to 1: what a line does not have is not read
  }
  const auto result = Evaluate(filter, places);
  for (vtkIdType i = 0; i < 4; ++i)
  {
    const double t = 1. - places.Parameters->GetComponent(i, 0);
    const double weights[4] = { (1. - t) * (1. - t) * (1. - t) / 6.,
      (3. * t * t * t - 6. * t * t + 4.) / 6., (-3. * t * t * t + 3. * t * t + 3. * t + 1.) / 6.,
      t * t * t / 6. };
    const double slopes[4] = { -0.5 * (1. - t) * (1. - t), 1.5 * t * t - 2. * t,
      -1.5 * t * t + t + 0.5, 0.5 * t * t };
    const double bends[4] = { 1. - t, 3. * t - 2., 1. - 3. * t, t };
    Point value{};
    Point first{};
    Point second{};
    for (int k = 0; k < 4; ++k)
    {
      for (int c = 0; c < 3; ++c)
      {
        value[c] += weights[k] * p[k][c];
        first[c] -= slopes[k] * p[k][c];
        second[c] += bends[k] * p[k][c];
      }
    }
    const Point cross = { first[1] * second[2] - first[2] * second[1],
      first[2] * second[0] - first[0] * second[2], first[0] * second[1] - first[1] * second[0] };
    const double curvature = std::hypot(cross[0], cross[1], cross[2]) /
      std::pow(std::hypot(first[0], first[1], first[2]), 3);
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(GetPoint(result, i)[c], value[c], 1e-14);
      EXPECT_NEAR(GetTuple(result, "DerivativeU", i)[c], first[c], 1e-13);
      EXPECT_EQ(GetTuple(result, "DerivativeV", i)[c], 0.);
    }
    EXPECT_NEAR(GetTuple(result, "MeanCurvature", i)[0], curvature, 1e-11);
  }
}

TEST(EvaluateLimit, SurfacesAgainstLevels)
{
  const Grid input = limit_probe_tools::MakeWavySurface(0.2, 1.);
  for (const int levels : { 0, 2, 6 })
  {
    SCOPED_TRACE(levels);
    vtkNew<Filter> filter;
    CheckAgainstLevels(input, filter, levels, 200, 3);
  }
}

TEST(EvaluateLimit, AllModelsAgainstLevels)
{
  for (int model = 0; model < vtkSubdivisionModelSource::NUMBER_OF_MODELS; ++model)
  {
    const Grid input = MakeModel(model);
    for (const int scheme : { Filter::BOX_SPLINE, Filter::LINEAR })
    {
      SCOPED_TRACE(testing::Message() << model << " " << scheme);
      vtkNew<Filter> filter;
      filter->SetVolumeScheme(scheme);
      CheckAgainstLevels(input, filter, 2, 40, 5);
    }
  }
}

/// Around a vertex of five triangles, with a curve that begins there.
TEST(EvaluateLimit, AllVerticesOfLevel8)
{
  const Grid input = MakeStar(5, false);
  vtkNew<Filter> filter;
  CheckAgainstLevels(input, filter, 8, -1, 0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 5 * 65536 + 2 * 256);
}

/// The same with three tetrahedra instead of triangles, and with one, as deep as memory lets tests.
TEST(EvaluateLimit, VerticesOfDeepLevelsOfSolids)
{
  for (const auto& [tets, levels] : { std::make_pair(3, 6), std::make_pair(1, 7) })
  {
    SCOPED_TRACE(levels);
    const Grid input = MakeStar(tets, true);
    vtkNew<Filter> filter;
    CheckAgainstLevels(input, filter, levels, 1500, 21);
    const vtkIdType parts = vtkIdType(1) << levels;
    EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), tets * parts * parts * parts + 2 * parts);
  }
}

/// Beside an edge of three solids the limit is not that of four, though all around a place is.
TEST(EvaluateLimit, VerticesBesideEdgesOfSolids)
{
  vtkNew<Filter> filter;
  CheckAgainstLevels(MakeStar(3, true, false), filter, 5, -1, 0);
}

/// Places that rounding puts beside vertices, edges and faces are as near to these as before. Those
/// beside what is not regular are looked at by many splits, each of which doubles the distance.
TEST(EvaluateLimit, PlacesBesideFacesByRounding)
{
  const Grid input = MakeStar(3, true);
  const vtkIdType face[3] = { 4, 5, 2 };
  input->InsertNextCell(VTK_TRIANGLE, 3, face);
  input->GetPointData()->RemoveArray("Random");
  std::mt19937 random(2);
  for (const double distance : { 1e-16, 1e-14, 1e-12, 1e-10 })
  {
    Places on;
    Places beside;
    for (int i = 0; i < 150; ++i)
    {
      const int dimension = 1 + i % 3;
      Point at{};
      for (int k = 0; k < dimension; ++k) // the first corner has the rest, which may be 0
      {
        at[k] = random() % 3 / (k == 2 ? 5. : 7.);
      }
      if (i % 2 == 0 && dimension == 3)
      {
        at[0] = 1. - at[1] - at[2];
      }
      const vtkIdType cell = dimension == 1 ? 0 : dimension == 2 ? 5 : 2 + i % 3;
      on.Add(cell, at);
      for (int k = 0; k < dimension; ++k)
      {
        at[k] += distance * (random() / 2147483648. - 1.);
      }
      beside.Add(cell, at);
    }
    vtkNew<Filter> filter;
    filter->SetInputData(input);
    const auto expected = Evaluate(filter, on);
    const auto found = Evaluate(filter, beside);
    for (vtkIdType i = 0; i < on.GetSize(); ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        ASSERT_NEAR(GetPoint(found, i)[c], GetPoint(expected, i)[c], 1e-13 + 100. * distance)
          << i << " in cell " << on.Cells->GetValue(i) << ", " << distance;
      }
    }
  }
}

TEST(EvaluateLimit, SemiSharpCreases)
{
  const Grid input = limit_probe_tools::MakeWavySurface(0.2, 1.);
  const vtkIdType crease[3] = { 14, 15, 16 };
  for (int i = 0; i < 2; ++i)
  {
    input->InsertNextCell(VTK_LINE, 2, crease + i);
  }
  vtkNew<vtkDoubleArray> sharpness;
  sharpness->SetName("Sharpness");
  for (vtkIdType i = 0; i < input->GetNumberOfCells(); ++i)
  {
    sharpness->InsertNextValue(input->GetCellType(i) == VTK_LINE ? 2.5 : 0.);
  }
  input->GetCellData()->AddArray(sharpness);
  vtkNew<Filter> filter;
  filter->SetInputArrayToProcess(4, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Sharpness");
  CheckAgainstLevels(input, filter, 4, 300, 9);
}

/// Derivatives are what values differ by, inside cells and near extraordinary vertices.
TEST(EvaluateLimit, DerivativesAreDifferences)
{
  const Grid surface = limit_probe_tools::MakeWavySurface(0.2, 1.);
  const Grid solid = MakeModel(vtkSubdivisionModelSource::MECHANICAL_PART);
  for (const Grid& input : { surface, solid })
  {
    vtkIdType cell = 20;
    while (input->GetCellType(cell) != (input == surface ? VTK_TRIANGLE : VTK_TETRA))
    {
      ++cell;
    }
    const int dimension = input == surface ? 2 : 3;
    vtkNew<Filter> filter;
    filter->SetInputData(input);
    const double h = 1. / 1024.;
    const std::vector<Point> at = { { 0.3, 0.3, 0.2 }, { 0.61, 0.2, 0.1 }, { 0.05, 0.06, 0.07 },
      { 0.263, 0.241, 0.221 } };
    Places places;
    for (const Point& p : at)
    {
      places.Add(cell, p);
      for (int k = 0; k < dimension; ++k)
      {
        for (const double steps : { -2., -1., 1., 2. })
        {
          Point q = p;
          q[k] += steps * h;
          places.Add(cell, q);
        }
      }
    }
    const auto result = Evaluate(filter, places);
    const char* names[3] = { "DerivativeU", "DerivativeV", "DerivativeW" };
    vtkIdType i = 0;
    for (std::size_t n = 0; n < at.size(); ++n)
    {
      const vtkIdType centre = i++;
      for (int k = 0; k < dimension; ++k, i += 4)
      {
        for (int c = 0; c < 3; ++c)
        {
          const auto get = [&](vtkIdType step) { return GetPoint(result, i + step)[c]; };
          const double difference = (get(0) - 8. * get(1) + 8. * get(2) - get(3)) / (12. * h);
          // The formula is exact for a polynomial of degree 4.
          EXPECT_NEAR(GetTuple(result, names[k], centre)[c], difference,
            (dimension == 2 ? 1e-10 : 1e-7) * input->GetLength())
            << n << " " << k;
        }
      }
    }
  }
}

/// The curvatures of a surface, from differences of its derivatives.
TEST(EvaluateLimit, CurvaturesAreThoseOfDifferences)
{
  const Grid input = limit_probe_tools::MakeWavySurface(0.2, 1.);
  vtkNew<Filter> filter;
  filter->SetInputData(input);
  const double h = 1. / 4096.;
  Places places;
  for (const Point& p : { Point{ 0.3, 0.4, 0. }, Point{ 0.3 + h, 0.4, 0. },
         Point{ 0.3, 0.4 + h, 0. }, Point{ 0.3 - h, 0.4, 0. }, Point{ 0.3, 0.4 - h, 0. } })
  {
    places.Add(21, p);
  }
  const auto result = Evaluate(filter, places);
  const auto differ = [&](const char* name, vtkIdType a, vtkIdType b)
  {
    const Point p = GetTuple(result, name, a);
    const Point q = GetTuple(result, name, b);
    return Point{ (p[0] - q[0]) / (2. * h), (p[1] - q[1]) / (2. * h), (p[2] - q[2]) / (2. * h) };
  };
  const auto dot = [](const Point& a, const Point& b)
  { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  const Point u = GetTuple(result, "DerivativeU", 0);
  const Point v = GetTuple(result, "DerivativeV", 0);
  const Point normal = GetTuple(result, "LimitNormals", 0);
  EXPECT_NEAR(dot(normal, u), 0., 1e-12);
  EXPECT_NEAR(dot(normal, v), 0., 1e-12);
  EXPECT_NEAR(dot(normal, normal), 1., 1e-12);
  const double l = dot(differ("DerivativeU", 1, 3), normal);
  const double m = dot(differ("DerivativeU", 2, 4), normal);
  const double n = dot(differ("DerivativeV", 2, 4), normal);
  const double area = dot(u, u) * dot(v, v) - dot(u, v) * dot(u, v);
  EXPECT_NEAR(GetTuple(result, "GaussianCurvature", 0)[0], (l * n - m * m) / area, 1e-6);
  EXPECT_NEAR(GetTuple(result, "MeanCurvature", 0)[0],
    0.5 * (dot(u, u) * n - 2. * dot(u, v) * m + dot(v, v) * l) / area, 1e-6);
}
