// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestHybridLimitsOfFilter.cxx
 * VolumeScheme = HYBRID: limits, classification and interpolation (Mathematics 15).
 */
#include "HybridFilterTools.h"

#include "vtkIntArray.h"

#include <random>

using namespace hybrid_filter_tools;

namespace
{

const Configure Smooth = [](Filter*) {};
const Configure Project = [](Filter* filter) { filter->ProjectToLimitOn(); };

/// A box of cubes, one of which is moved, with a wedge, a pyramid and shells at it.
Grid MakeMixed()
{
  std::vector<Point> points;
  for (int i = 0; i < 27; ++i)
  {
    points.push_back({ i % 3 + .1 * (i % 2), i / 3 % 3 - .1 * (i % 4), i / 9 + .05 * (i % 5) });
  }
  std::vector<multi_dimensional_subdivision_tools::Cell> cells;
  for (const vtkIdType i : { 0, 1, 3, 4, 9, 10, 12, 13 })
  {
    cells.push_back({ VTK_HEXAHEDRON, { i, i + 1, i + 4, i + 3, i + 9, i + 10, i + 13, i + 12 } });
  }
  points.push_back({ 3., .5, 0. });  // 27
  points.push_back({ 3., .5, 1. });  // 28
  points.push_back({ 1., 1., 3.3 }); // 29
  points.push_back({ -1., 0., 0. }); // 30
  points.push_back({ -1., 1., 0. }); // 31
  points.push_back({ -2., .5, .5 }); // 32
  cells.push_back({ VTK_WEDGE, { 2, 27, 5, 11, 28, 14 } });
  cells.push_back({ VTK_PYRAMID, { 18, 19, 22, 21, 29 } });
  cells.push_back({ VTK_QUAD, { 0, 3, 31, 30 } });
  cells.push_back({ VTK_TRIANGLE, { 30, 31, 32 } });
  cells.push_back({ VTK_LINE, { 32, 29 } });
  return MakeGrid(points, cells);
}

double FindDistance(const Grid& a, const Grid& b, vtkIdType points)
{
  double most = 0.;
  for (vtkIdType i = 0; i < points; ++i)
  {
    const Point p = GetPoint(a, i);
    const Point q = GetPoint(b, i);
    most = std::max({ most, std::abs(p[0] - q[0]), std::abs(p[1] - q[1]), std::abs(p[2] - q[2]) });
  }
  return most;
}

}

TEST(HybridLimitsOfFilter, AreTheSameOnAllLevels)
{
  const Grid input = MakeMixed();
  Grid before = Execute(input, 0, With(Project));
  EXPECT_EQ(before->GetNumberOfPoints(), input->GetNumberOfPoints());
  EXPECT_GT(FindDistance(before, input, input->GetNumberOfPoints()), .01);
  for (int levels = 1; levels <= 3; ++levels)
  {
    const Grid output = Execute(input, levels, With(Project));
    EXPECT_EQ(output->GetNumberOfCells(), Execute(input, levels, With(Smooth))->GetNumberOfCells());
    EXPECT_LT(FindDistance(output, before, before->GetNumberOfPoints()), 1e-13) << levels;
    before = output;
  }
  // What is far from the limit comes near to it.
  EXPECT_LT(
    FindDistance(before, Execute(input, 3, With(Smooth)), before->GetNumberOfPoints()), .02);
}

TEST(HybridLimitsOfFilter, OfACube)
{
  const Grid cube = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
                               { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } },
    { { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } } });
  for (const int levels : { 0, 2 })
  {
    for (const double x : GetPoint(Execute(cube, levels, With(Project)), 0))
    {
      EXPECT_NEAR(x, .25, 1e-15);
    }
  }
}

TEST(HybridLimitsOfFilter, OfTetrahedraAndShellsAreThoseOfTetOct)
{
  const Grid input =
    MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 1.2 }, { 2, 0, 1 } },
      { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 1, 2, 3, 4 } }, { VTK_TRIANGLE, { 1, 4, 5 } },
        { VTK_LINE, { 5, 3 } } });
  for (const int levels : { 0, 1, 2 })
  {
    const Grid output = Execute(input, levels, With(Project));
    const Grid expected = Execute(input, levels,
      [](Filter* filter)
      {
        filter->SetVolumeSchemeToTetOct();
        filter->ProjectToLimitOn();
      });
    ASSERT_EQ(output->GetNumberOfPoints(), expected->GetNumberOfPoints());
    EXPECT_LT(FindDistance(output, expected, input->GetNumberOfPoints()), 1e-12);
  }
}

TEST(HybridLimitsOfFilter, OfQuadsAreCatmullClark)
{
  // A closed cube of quads, and one more beside it that shares an edge: joints stay apart.
  const Grid quads = MakeGrid({ { 0, 0, 0 }, { 1, 0, .2 }, { 1, 1, 0 }, { 0, 1, .1 }, { 0, 0, 1 },
                                { 1, 0, 1.3 }, { 1, 1, 1 }, { -.1, 1, 1 } },
    { { VTK_QUAD, { 0, 3, 2, 1 } }, { VTK_QUAD, { 4, 5, 6, 7 } }, { VTK_QUAD, { 0, 1, 5, 4 } },
      { VTK_QUAD, { 1, 2, 6, 5 } }, { VTK_QUAD, { 2, 3, 7, 6 } }, { VTK_QUAD, { 3, 0, 4, 7 } } });
  const auto expected =
    SubdivideQuads(quads, 2, [](vtkSurfaceSubdivision* filter) { filter->ProjectToLimitOn(); });
  const Grid output = Execute(quads, 2, With(Project));
  ASSERT_EQ(output->GetNumberOfPoints(), expected->GetNumberOfPoints());
  for (vtkIdType i = 0; i < 8; ++i)
  {
    const double* p = expected->GetPoint(i);
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(GetPoint(output, i)[c], p[c], 1e-13);
    }
  }
}

TEST(HybridLimitsOfFilter, InterpolatedPointsAreLimits)
{
  const Grid input = MakeMixed();
  AddArrays(input);
  vtkNew<Messages> messages;
  const Grid output = Execute(input, 1,
    With(
      [](Filter* filter)
      {
        filter->ProjectToLimitOn();
        filter->InterpolatePointsOn();
        filter->InterpolateArraysOn();
      }),
    messages);
  EXPECT_TRUE(messages->Errors.empty());
  EXPECT_LT(FindDistance(output, input, input->GetNumberOfPoints()), 1e-9);
  EXPECT_GT(FindDistance(Execute(input, 1, With(Project)), input, 27), .01);
  vtkDataArray* given = input->GetPointData()->GetArray("double");
  vtkDataArray* made = output->GetPointData()->GetArray("double");
  ASSERT_NE(given, nullptr);
  ASSERT_NE(made, nullptr);
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    EXPECT_NEAR(made->GetComponent(i, 0), given->GetComponent(i, 0),
      1e-9 * (1. + std::abs(given->GetComponent(i, 0))));
  }
}

TEST(HybridLimitsOfFilter, Classification)
{
  const Grid input = MakeMixed();
  const auto classify = With([](Filter* filter) { filter->GenerateClassificationOn(); });
  for (const int levels : { 0, 1, 2 })
  {
    const Grid output = Execute(input, levels, classify);
    vtkDataArray* rules = output->GetPointData()->GetArray("RuleDimension");
    vtkDataArray* types = output->GetPointData()->GetArray("NonManifoldType");
    vtkDataArray* dimensions = output->GetCellData()->GetArray("ManifoldDimension");
    vtkDataArray* inverted = output->GetCellData()->GetArray("Inverted");
    ASSERT_TRUE(rules && types && dimensions && inverted);
    EXPECT_EQ(rules->GetComponent(13, 0), 3.) << "inside";
    EXPECT_EQ(rules->GetComponent(1, 0), 2.) << "on the border of hexahedra";
    EXPECT_EQ(rules->GetComponent(0, 0), 4.) << "a joint";
    EXPECT_EQ(types->GetComponent(0, 0), 1.);
    EXPECT_EQ(types->GetComponent(13, 0), 0.);
    EXPECT_EQ(rules->GetNumberOfTuples(), output->GetNumberOfPoints());
    for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
    {
      const int dimension = output->GetCell(c)->GetCellDimension();
      EXPECT_EQ(dimensions->GetComponent(c, 0), dimension);
      EXPECT_EQ(inverted->GetComponent(c, 0), 0.) << "cell " << c;
    }
  }
}

/// Six times the volume of a hexahedron: each side counts as both of its cuts do together.
double Measure(const Grid& grid, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  grid->GetCellPoints(cell, ids);
  constexpr int faces[6][4] = { { 3, 2, 1, 0 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 }, { 1, 2, 6, 5 },
    { 2, 3, 7, 6 }, { 3, 0, 4, 7 } };
  double volume = 0.;
  for (const auto& face : faces)
  {
    for (int k = 0; k < 4; ++k)
    {
      const Point a = GetPoint(grid, ids->GetId(face[k]));
      const Point b = GetPoint(grid, ids->GetId(face[(k + 1) % 4]));
      const Point c = GetPoint(grid, ids->GetId(face[(k + 2) % 4]));
      volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                  a[2] * (b[0] * c[1] - b[1] * c[0])) /
        2.;
    }
  }
  return volume;
}

TEST(HybridLimitsOfFilter, SolidsThatAreInsideOut)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> shift(-1.5, 1.5);
  int marked = 0;
  for (int round = 0; round < 10; ++round)
  {
    const Grid input = MakeMixed();
    for (vtkIdType i = 0; i < 27; ++i)
    {
      const Point p = GetPoint(input, i);
      input->GetPoints()->SetPoint(
        i, p[0] + shift(random), p[1] + shift(random), p[2] + shift(random));
    }
    std::vector<double> signs; // of the hexahedra of the input
    for (vtkIdType c = 0; c < 8; ++c)
    {
      signs.push_back(Measure(input, c) < 0. ? -1. : 1.);
    }
    vtkNew<Messages> messages;
    const Grid output =
      Execute(input, 1, With([](Filter* filter) { filter->GenerateClassificationOn(); }), messages);
    vtkDataArray* inverted = output->GetCellData()->GetArray("Inverted");
    ASSERT_NE(inverted, nullptr);
    int all = 0;
    for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
    {
      all += inverted->GetComponent(c, 0) > 0. ? 1 : 0;
      if (c < 64)
      {
        const bool isInverted = Measure(output, c) * signs[c / 8] < 0.;
        EXPECT_EQ(inverted->GetComponent(c, 0), isInverted ? 1. : 0.) << c;
        marked += isInverted ? 1 : 0;
      }
    }
    ASSERT_EQ(messages->Inversions.size(), all > 0 ? 1u : 0u);
    EXPECT_TRUE(all == 0 ||
      messages->Inversions[0].find(": " + std::to_string(all) + " of ") != std::string::npos)
      << messages->Inversions[0];
  }
  EXPECT_GT(marked, 0);
}

namespace
{

const Configure Frames = [](Filter* filter)
{
  filter->GenerateLimitNormalsOn();
  filter->GenerateTangentsOn();
};

Point GetVector(const Grid& grid, const char* name, vtkIdType point)
{
  Point vector{ { 0., 0., 0. } };
  vtkDataArray* array = grid->GetPointData()->GetArray(name);
  EXPECT_NE(array, nullptr) << name;
  if (array)
  {
    array->GetTuple(point, vector.data());
  }
  return vector;
}

void ExpectSameVectors(
  const Grid& a, const Grid& b, const char* name, vtkIdType points, double tolerance)
{
  for (vtkIdType i = 0; i < points; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(GetVector(a, name, i)[c], GetVector(b, name, i)[c], tolerance)
        << name << " of point " << i;
    }
  }
}

}

/// Triangles, tetrahedra and lines: the normals and tangents of the tet/oct scheme, also where
/// there is no tangent plane.
TEST(HybridLimitsOfFilter, NormalsOfSimplicesAreThoseOfTetOct)
{
  const Grid input = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 1.2 },
                                { 2, 0, 1 }, { 3, 0, 1.5 }, { 3, 1, 1 }, { 2, 2, 0 } },
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 1, 2, 3, 4 } }, { VTK_TRIANGLE, { 4, 7, 8 } },
      { VTK_TRIANGLE, { 5, 6, 7 } }, { VTK_TRIANGLE, { 5, 7, 4 } }, { VTK_LINE, { 6, 8 } } });
  for (const int levels : { 0, 1, 2 })
  {
    const Grid output = Execute(input, levels, With(Frames));
    const Grid expected = Execute(input, levels,
      [](Filter* filter)
      {
        filter->SetVolumeSchemeToTetOct();
        Frames(filter);
      });
    ASSERT_EQ(output->GetNumberOfPoints(), expected->GetNumberOfPoints());
    ExpectSameVectors(output, expected, "LimitNormals", input->GetNumberOfPoints(), 1e-9);
  }
}

/// Quads alone: Catmull-Clark's normals, of a closed surface and up to its border.
TEST(HybridLimitsOfFilter, NormalsOfQuadsAreThoseOfCatmullClark)
{
  std::vector<Point> points;
  std::vector<multi_dimensional_subdivision_tools::Cell> cells;
  for (int i = 0; i < 25; ++i)
  {
    points.push_back({ i % 5 * 1., i / 5 * 1., std::sin(i * 1.3) });
  }
  for (const vtkIdType i : { 0, 1, 2, 3, 5, 6, 8, 10, 11, 12, 13, 15, 16, 17, 18 })
  {
    cells.push_back({ VTK_QUAD, { i, i + 1, i + 6, i + 5 } });
  }
  const Grid quads = MakeGrid(points, cells);
  const auto surface = SubdivideQuads(
    quads, 1, [](vtkSurfaceSubdivision* filter) { filter->GenerateLimitNormalsOn(); });
  const Grid output = Execute(quads, 1, With(Frames));
  vtkDataArray* expected = surface->GetPointData()->GetArray("LimitNormals");
  ASSERT_NE(expected, nullptr);
  for (vtkIdType i = 0; i < 25; ++i)
  {
    if (i == 0 || i == 4 || i == 20 || i == 24)
    {
      continue; // corners of one quad, which are sharp there
    }
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(GetVector(output, "LimitNormals", i)[c], expected->GetComponent(i, c), 1e-9)
        << "point " << i;
    }
  }
}

/// Normals are the same on all levels, of unit length where anything is to be seen, look out of
/// solids, and are those to which the normals of finer and finer faces tend.
TEST(HybridLimitsOfFilter, NormalsOfMixedMeshes)
{
  const Grid input = MakeMixed();
  const vtkIdType size = input->GetNumberOfPoints();
  Grid before = Execute(input, 0, With(Frames));
  for (int levels = 1; levels <= 3; ++levels)
  {
    const Grid output = Execute(input, levels, With(Frames));
    ExpectSameVectors(output, before, "LimitNormals", before->GetNumberOfPoints(), 1e-7);
    before = output;
  }
  for (vtkIdType i = 0; i < size; ++i)
  {
    const Point n = GetVector(before, "LimitNormals", i);
    EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), i == 13 ? 0. : 1., 1e-12) << i;
  }
  for (const vtkIdType i : { 1, 4, 7, 10, 12, 14, 16 }) // around the middle, point 13
  {
    const Point n = GetVector(before, "LimitNormals", i);
    const Point p = GetPoint(before, i);
    const Point q = GetPoint(before, 13);
    EXPECT_GT(n[0] * (p[0] - q[0]) + n[1] * (p[1] - q[1]) + n[2] * (p[2] - q[2]), 0.) << i;
  }
}

/// Vertices with triangles and quads around them: the normal is that of the limit of fine levels,
/// and perpendicular to both tangents.
TEST(HybridLimitsOfFilter, TangentsWhereTrianglesMeetQuads)
{
  // Sectors around point 0: quads and triangles in all orders of a few, closed or not.
  for (const std::string types :
    { "43434", "44333", "4433", "434", "334", "33344434", "443o", "343o", "34o", "3443o" })
  {
    SCOPED_TRACE(types);
    const bool isClosed = types.back() != 'o';
    const int faces = static_cast<int>(types.size()) - (isClosed ? 0 : 1);
    const int edges = faces + (isClosed ? 0 : 1);
    const double angle = (isClosed ? 2. : 1.) * 3.14159265358979 / faces;
    std::vector<Point> points{ { 0., 0., .3 } };
    for (int e = 0; e < edges; ++e)
    {
      points.push_back({ std::cos(angle * e), std::sin(angle * e), .2 * std::sin(3. * e) });
    }
    std::vector<multi_dimensional_subdivision_tools::Cell> cells;
    for (int f = 0; f < faces; ++f)
    {
      const vtkIdType next = 1 + (f + 1) % edges;
      if (types[f] == '3')
      {
        cells.push_back({ VTK_TRIANGLE, { 0, 1 + f, next } });
        continue;
      }
      cells.push_back({ VTK_QUAD, { 0, 1 + f, static_cast<vtkIdType>(points.size()), next } });
      points.push_back(
        { 1.5 * std::cos(angle * (f + .5)), 1.5 * std::sin(angle * (f + .5)), .1 * f });
    }
    const Grid input = MakeGrid(points, cells);
    const Grid output = Execute(input, 0, With(Frames));
    const Point n = GetVector(output, "LimitNormals", 0);
    for (const char* name : { "LimitTangent1", "LimitTangent2" })
    {
      const Point t = GetVector(output, name, 0);
      EXPECT_GT(std::hypot(t[0], t[1], t[2]), 1e-3);
      EXPECT_NEAR(n[0] * t[0] + n[1] * t[1] + n[2] * t[2], 0., 1e-12);
    }
    // The mean of the normals at the vertex of a fine level, which is nearly flat there.
    const Grid fine = Execute(input, 6, With(Project));
    Point sum{ { 0., 0., 0. } };
    for (vtkIdType c = 0; c < fine->GetNumberOfCells(); ++c)
    {
      vtkNew<vtkIdList> ids;
      fine->GetCellPoints(c, ids);
      const vtkIdType at = ids->IsId(0);
      if (at >= 0)
      {
        const vtkIdType count = ids->GetNumberOfIds();
        const Point o = GetPoint(fine, 0);
        Point a = GetPoint(fine, ids->GetId((at + 1) % count));
        Point b = GetPoint(fine, ids->GetId((at + count - 1) % count));
        for (int k = 0; k < 3; ++k)
        {
          a[k] -= o[k];
          b[k] -= o[k];
        }
        for (int k = 0; k < 3; ++k)
        {
          sum[k] += a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
        }
      }
    }
    const double length = std::hypot(sum[0], sum[1], sum[2]);
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_NEAR(n[k], sum[k] / length, .03) << k;
    }
  }
}
