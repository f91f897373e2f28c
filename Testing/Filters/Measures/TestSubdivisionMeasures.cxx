// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSubdivisionMeasures.cxx
 * vtkSubdivisionMeasures does what its documentation says.
 */
#include "MeasureTools.h"
#include "RandomTools.h"

#include "vtkStringArray.h"

using namespace measure_tools;

namespace
{

/// n^3 unit cubes, with the array Value = x + 2 y - z, and a density 1 + x / 10; the cubes that
/// rules of the boundary do not reach have material 1.
Grid MakeLattice(int n, int margin)
{
  std::vector<Point> points;
  std::vector<Cell> cells;
  const vtkIdType row = n + 1;
  for (vtkIdType i = 0; i < row * row * row; ++i)
  {
    points.push_back({ double(i % row), double(i / row % row), double(i / row / row) });
  }
  std::vector<int> materials;
  for (int z = 0; z < n; ++z)
  {
    for (int y = 0; y < n; ++y)
    {
      for (int x = 0; x < n; ++x)
      {
        const vtkIdType a = x + row * (y + row * z);
        const vtkIdType up = a + row * row;
        cells.push_back({ VTK_HEXAHEDRON,
          { a, a + 1, a + row + 1, a + row, up, up + 1, up + row + 1, up + row } });
        const auto isInside = [&](int i) { return i >= margin && i < n - margin; };
        materials.push_back(isInside(x) && isInside(y) && isInside(z) ? 1 : 0);
      }
    }
  }
  const Grid grid = MakeGrid(points, cells);
  AddCellArray(grid, "MaterialId", materials);
  AddField(grid, "Value", [](const Point& p) { return p[0] + 2. * p[1] - p[2]; });
  AddField(grid, "Density", [](const Point& p) { return 1. + p[0] / 10.; });
  return grid;
}

/// Moves points by a matrix whose determinant is 3.
Point Shear(const Point& p)
{
  return { 2. * p[0] + p[1] + 5., 1.5 * p[1] - p[2], p[2] };
}

Grid MakeTet(bool isInverted = false)
{
  const Grid tet = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    { { VTK_TETRA, isInverted ? Ids{ 1, 0, 2, 3 } : Ids{ 0, 1, 2, 3 } } });
  AddField(tet, "Density", [](const Point& p) { return 1. + p[0]; });
  return tet;
}

}

TEST(SubdivisionMeasures, ATetrahedronThatIsNotSmoothed)
{
  vtkNew<vtkSubdivisionMeasures> filter;
  filter->SetVolumeSchemeToLinear();
  const Table table = Measure(filter, MakeTet());
  ASSERT_EQ(table->GetNumberOfRows(), 1);
  EXPECT_EQ(Get(table, "Dimension"), 3.);
  EXPECT_NEAR(Get(table, "Measure"), 1. / 6., 1e-15);
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_NEAR(Get(table, "Centroid", 0, k), 0.25, 1e-15);
    EXPECT_NEAR(Get(table, "Inertia", 0, k), 1. / 80., 1e-15);      // 2 (1/60 - 1/96)
    EXPECT_NEAR(Get(table, "Inertia", 0, 3 + k), 1. / 480., 1e-15); // -(1/120 - 1/96)
  }
  EXPECT_NEAR(Get(table, "DensityIntegral"), 5. / 24., 1e-15);
  EXPECT_NEAR(Get(table, "DensityMean"), 1.25, 1e-14);
  EXPECT_EQ(Get(table, "DensityMinimum"), 1.);
  EXPECT_EQ(Get(table, "DensityMaximum"), 2.);
  EXPECT_LT(Get(table, "DensityMaximumRemainder"), 1e-13);
  EXPECT_LT(Get(table, "MeasureRemainder"), 1e-13);
  EXPECT_EQ(table->GetColumnByName("Mass"), nullptr);
  EXPECT_EQ(table->GetColumnByName("Material"), nullptr);
  auto* levels = vtkDataArray::SafeDownCast(table->GetFieldData()->GetArray("MeasuredLevels"));
  ASSERT_TRUE(levels);
  EXPECT_EQ(levels->GetComponent(0, 0), 1.);
}

TEST(SubdivisionMeasures, DensityWeighsAllButTheMeasure)
{
  vtkNew<vtkSubdivisionMeasures> filter;
  filter->SetVolumeSchemeToLinear();
  SetDensity(filter, "Density");
  const Table table = Measure(filter, MakeTet());
  EXPECT_NEAR(Get(table, "Measure"), 1. / 6., 1e-15);
  EXPECT_NEAR(Get(table, "Mass"), 5. / 24., 1e-15);
  // 1/24 + 1/60, and 1/24 + 1/120, by the mass
  EXPECT_NEAR(Get(table, "Centroid", 0, 0), 7. / 120. * 24. / 5., 1e-14);
  EXPECT_NEAR(Get(table, "Centroid", 0, 1), 6. / 120. * 24. / 5., 1e-14);
  // 1/6 + 2/24 + 1/60
  EXPECT_NEAR(Get(table, "DensityIntegral"), 16. / 60., 1e-15);
  EXPECT_NEAR(Get(table, "DensityMean"), 16. / 60. * 24. / 5., 1e-14);
}

TEST(SubdivisionMeasures, InvertedSolidsCountAsOthers)
{
  vtkNew<vtkSubdivisionMeasures> filter;
  const Table one = Measure(filter, MakeTet());
  const Table other = Measure(filter, MakeTet(true));
  EXPECT_GT(Get(one, "Measure"), 0.);
  EXPECT_NEAR(Get(one, "Measure"), Get(other, "Measure"), 1e-15);
  EXPECT_NEAR(Get(one, "DensityIntegral"), Get(other, "DensityIntegral"), 1e-15);
}

TEST(SubdivisionMeasures, AffineImagesOfLatticesAreExact)
{
  const Grid lattice = MakeLattice(5, 2);
  for (vtkIdType i = 0; i < lattice->GetNumberOfPoints(); ++i)
  {
    lattice->GetPoints()->SetPoint(i, Shear(GetPoint(lattice, i)).data());
  }
  for (const int scheme :
    { vtkMultiDimensionalSubdivision::HYBRID, vtkMultiDimensionalSubdivision::LINEAR })
  {
    vtkNew<vtkSubdivisionMeasures> filter;
    filter->SetVolumeScheme(scheme);
    filter->SetMaximumLevel(3);
    SetDensity(filter, "Density");
    const Table table = Measure(filter, lattice);
    const vtkIdType row = FindRow(table, 3, 1);
    ASSERT_GE(row, 0);
    const Point middle = Shear({ 2.5, 2.5, 2.5 });
    EXPECT_NEAR(Get(table, "Measure", row), 3., 1e-12);
    EXPECT_NEAR(Get(table, "Mass", row), 3. * 1.25, 1e-12);
    EXPECT_NEAR(Get(table, "Centroid", row, 2), middle[2], 1e-12);
    EXPECT_NEAR(Get(table, "Centroid", row, 0), middle[0] + 2. / 12. * 0.1 / 1.25, 1e-12);
    EXPECT_NEAR(Get(table, "ValueIntegral", row), 3. * (1.25 * 5. + 0.1 / 12.), 1e-11);
    EXPECT_NEAR(Get(table, "ValueMinimum", row), 2. + 4. - 3., 1e-12);
    EXPECT_NEAR(Get(table, "ValueMaximum", row), 3. + 6. - 2., 1e-12);
    EXPECT_LT(Get(table, "MeasureRemainder", row), 1e-11);
  }
}

TEST(SubdivisionMeasures, MaterialsSumToTheWhole)
{
  const Grid lattice = MakeLattice(3, 1);
  for (const bool keepsInterfaces : { false, true })
  {
    vtkNew<vtkSubdivisionMeasures> filter;
    filter->SetMaximumLevel(3);
    filter->SetPreserveInterfaces(keepsInterfaces);
    SetDensity(filter, "Density");
    const Table table = Measure(filter, lattice);
    ASSERT_EQ(table->GetNumberOfRows(), 3);
    const vtkIdType whole = FindRow(table, 3);
    for (const char* name : { "Measure", "Mass", "ValueIntegral", "DensityIntegral" })
    {
      const double sum =
        Get(table, name, FindRow(table, 3, 0)) + Get(table, name, FindRow(table, 3, 1));
      EXPECT_NEAR(Get(table, name, whole), sum, 1e-13 * std::abs(sum)) << name;
    }
  }
}

/// A closed cubic B-spline, by Gauss points of its pieces.
TEST(SubdivisionMeasures, ACurveHasTheLengthOfItsSpline)
{
  const std::vector<Point> points{ { 0, 0, 0 }, { 2, 0, 0 }, { 3, 2, 1 }, { 0, 3, 0 },
    { -1, 1, 2 } };
  std::vector<Cell> cells;
  for (vtkIdType i = 0; i < 5; ++i)
  {
    cells.push_back({ VTK_LINE, { i, (i + 1) % 5 } });
  }
  double length = 0.;
  constexpr int parts = 2000;
  for (int piece = 0; piece < 5; ++piece)
  {
    for (int part = 0; part < parts; ++part)
    {
      for (const double gauss : { 0.5 - std::sqrt(1. / 12.), 0.5 + std::sqrt(1. / 12.) })
      {
        const double t = (part + gauss) / parts;
        const double slopes[4] = { -(1. - t) * (1. - t) / 2., (3. * t * t - 4. * t) / 2.,
          (-3. * t * t + 2. * t + 1.) / 2., t * t / 2. };
        Point d{};
        for (int i = 0; i < 4; ++i)
        {
          for (int k = 0; k < 3; ++k)
          {
            d[k] += slopes[i] * points[(piece + i) % 5][k];
          }
        }
        length += std::hypot(d[0], d[1], d[2]) / 2. / parts;
      }
    }
  }
  vtkNew<vtkSubdivisionMeasures> filter;
  filter->SetMaximumLevel(10);
  const Table table = Measure(filter, MakeGrid(points, cells));
  EXPECT_EQ(Get(table, "Dimension"), 1.);
  EXPECT_NEAR(Get(table, "Measure"), length, 1e-9 * length);
  EXPECT_LE(std::abs(Get(table, "Measure") - length), Get(table, "MeasureRemainder") + 1e-12);
}
