// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestEvaluateLimitTetOct.cxx
 * The limit at places of tetrahedra by the tet/oct scheme: against the projected points of levels,
 * by symmetry, and against differences.
 */
#include "MultiDimensionalSubdivisionTools.h"
#include "PlaceTools.h"
#include "PointTools.h"

using namespace multi_dimensional_subdivision_tools;
using namespace place_tools;
using namespace point_tools;

namespace
{

using Filter = vtkMultiDimensionalSubdivision;

/// Tetrahedra around an edge, with a value for each point.
Grid MakeTets(bool hasCrease)
{
  std::vector<Point> points = { { 0., 0., -1. }, { 0.1, 0.2, 1.1 } };
  std::vector<Cell> cells;
  for (int i = 0; i < 5; ++i)
  {
    points.push_back({ std::cos(1.2 * i), std::sin(1.3 * i), 0.2 * std::sin(3. * i) });
    cells.push_back({ VTK_TETRA, { 0, 1, 2 + i, 2 + (i + 1) % 5 } });
  }
  const Grid grid = MakeGrid(points, cells);
  if (hasCrease)
  {
    const vtkIdType line[2] = { 0, 2 };
    grid->InsertNextCell(VTK_LINE, 2, line);
    vtkNew<vtkIntArray> flags;
    flags->SetName("Singular");
    for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
    {
      flags->InsertNextValue(cell == 5 ? 1 : 0);
    }
    grid->GetCellData()->AddArray(flags);
  }
  grid->GetPointData()->AddArray(
    MakeArray<vtkDoubleArray>("Random", 1, grid->GetNumberOfPoints(), -1., 1., 7));
  return grid;
}

/// A semi-sharp line on the boundary, at which three of the tetrahedra lie.
void AddSemiSharpLine(vtkUnstructuredGrid* grid)
{
  const vtkIdType line[2] = { 2, 3 };
  grid->InsertNextCell(VTK_LINE, 2, line);
  vtkNew<vtkDoubleArray> sharpness;
  sharpness->SetName("Sharpness");
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    sharpness->InsertNextValue(grid->GetCellType(cell) == VTK_LINE ? 1.5 : 0.);
  }
  grid->GetCellData()->AddArray(sharpness);
}

void PrepareTetOct(Filter* filter, vtkUnstructuredGrid* grid)
{
  filter->SetInputData(grid);
  filter->SetVolumeSchemeToTetOct();
  if (grid->GetCellData()->HasArray("Sharpness"))
  {
    filter->SetInputArrayToProcess(4, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Sharpness");
  }
}

vtkSmartPointer<vtkPolyData> EvaluateTetOct(vtkUnstructuredGrid* grid, const Places& places)
{
  vtkNew<Filter> filter;
  PrepareTetOct(filter.Get(), grid);
  return Evaluate(filter.Get(), places);
}

}

/// All places with parameters that are multiples of 1/4 are vertices of level 2, and the only ones:
/// corners, middles of edges and centres of octahedra. They have the limits of these.
TEST(EvaluateLimitTetOct, LatticesAreVerticesOfALevel)
{
  for (const char* crease : { "none", "singular", "semi-sharp" })
  {
    const Grid grid = MakeTets(crease == std::string("singular"));
    crease == std::string("semi-sharp") ? AddSemiSharpLine(grid) : void();
    vtkNew<Filter> filter;
    PrepareTetOct(filter.Get(), grid);
    filter->SetNumberOfLevels(2);
    filter->ProjectToLimitOn();
    const Grid fine = UpdateWithoutErrors<vtkUnstructuredGrid>(filter.Get(), grid);
    Places places;
    for (vtkIdType cell = 0; cell < 5; ++cell)
    {
      for (int i = 0; i <= 4; ++i)
      {
        for (int j = 0; i + j <= 4; ++j)
        {
          for (int k = 0; i + j + k <= 4; ++k)
          {
            places.Add(cell, { 0.25 * i, 0.25 * j, 0.25 * k });
          }
        }
      }
    }
    const auto result = EvaluateTetOct(grid, places);
    vtkDataArray* values = result->GetPointData()->GetArray("Random");
    vtkDataArray* fineValues = fine->GetPointData()->GetArray("Random");
    std::vector<bool> isMet(static_cast<std::size_t>(fine->GetNumberOfPoints()), false);
    for (vtkIdType i = 0; i < places.GetSize(); ++i)
    {
      vtkIdType nearest = 0;
      for (vtkIdType p = 1; p < fine->GetNumberOfPoints(); ++p)
      {
        const Point x = GetPoint(result, i);
        nearest =
          Distance(GetPoint(fine, p), x) < Distance(GetPoint(fine, nearest), x) ? p : nearest;
      }
      isMet[static_cast<std::size_t>(nearest)] = true;
      ASSERT_LT(Distance(GetPoint(fine, nearest), GetPoint(result, i)), 1e-12) << i;
      ASSERT_NEAR(values->GetComponent(i, 0), fineValues->GetComponent(nearest, 0), 1e-12) << i;
    }
    // The octahedra of the last level are written in pieces with their centres, of level 3.
    const auto met = std::count(isMet.begin(), isMet.end(), true);
    EXPECT_GE(met, 75) << crease;
  }
}

/// Values and derivatives fit together, between vertices, on faces and edges, and across faces.
TEST(EvaluateLimitTetOct, DerivativesAreDifferences)
{
  const Grid grid = MakeTets(false);
  constexpr double h = 1e-3;
  const std::vector<Point> at = { { 0.31, 0.22, 0.17 }, { 0.05, 0.6, 0.1 }, { 0.249, 0.252, 0.246 },
    { 0.11, 0.13, 0.62 }, { 0.4, 0.11, 0.45 } };
  Places places;
  for (const Point& p : at)
  {
    places.Add(2, p);
    for (int k = 0; k < 3; ++k)
    {
      for (const double by : { -h, h })
      {
        Point q = p;
        q[k] += by;
        places.Add(2, q);
      }
    }
  }
  const auto result = EvaluateTetOct(grid, places);
  const char* names[3] = { "DerivativeU", "DerivativeV", "DerivativeW" };
  for (vtkIdType i = 0; i < static_cast<vtkIdType>(at.size()); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Point before = GetPoint(result, 7 * i + 1 + 2 * k);
      const Point after = GetPoint(result, 7 * i + 2 + 2 * k);
      const Point slope = GetTuple(result, names[k], 7 * i);
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(slope[c], (after[c] - before[c]) / (2. * h), 1e-4) << i << " " << names[k];
      }
    }
  }
  // The same place on the common face of two tetrahedra.
  Places common;
  common.Add(2, { 0.3, 0., 0.41 });
  common.Add(3, { 0.3, 0.41, 0. });
  const auto twice = EvaluateTetOct(grid, common);
  EXPECT_LT(Distance(GetPoint(twice, 0), GetPoint(twice, 1)), 1e-13);
}

/// One tetrahedron is symmetric, and so is its limit.
TEST(EvaluateLimitTetOct, SymmetryOfOneTetrahedron)
{
  const Grid tet = MakeGrid({ { 0., 0., 0. }, { 8., 0., 0. }, { 0., 8., 0. }, { 0., 0., 8. } },
    { { VTK_TETRA, { 0, 1, 2, 3 } } });
  Places places;
  places.Add(0, { 0.25, 0.25, 0.25 });
  const auto result = EvaluateTetOct(tet, places);
  // The limit of the centre is the centre; derivatives are the same in all directions.
  const Point centre = GetPoint(result, 0);
  const Point slopes[3] = { GetTuple(result, "DerivativeU", 0), GetTuple(result, "DerivativeV", 0),
    GetTuple(result, "DerivativeW", 0) };
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_NEAR(centre[k], 2., 1e-13);
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(slopes[k][c], k == c ? slopes[0][0] : slopes[0][1], 1e-13) << k << " " << c;
    }
  }
}

/// In an output of the filter places are in tetrahedra, and in pieces of octahedra. Both have the
/// limit of the control mesh: the corners of a cell tell where in a control tetrahedron it lies.
TEST(EvaluateLimitTetOct, FiltersInARow)
{
  const Grid grid = MakeTets(true);
  Places lattice;
  for (vtkIdType cell = 0; cell < 5; ++cell)
  {
    for (int i = 0; i <= 4; ++i)
    {
      for (int j = 0; i + j <= 4; ++j)
      {
        for (int k = 0; i + j + k <= 4; ++k)
        {
          lattice.Add(cell, { 0.25 * i, 0.25 * j, 0.25 * k });
        }
      }
    }
  }
  const auto known = EvaluateTetOct(grid, lattice);
  for (const int levels : { 1, 2 })
  {
    vtkNew<Filter> filter;
    filter->SetVolumeSchemeToTetOct();
    filter->SetNumberOfLevels(levels);
    const Grid fine = UpdateWithoutErrors<vtkUnstructuredGrid>(filter.Get(), grid);
    vtkDataArray* octahedra = fine->GetCellData()->GetArray("OctahedronId");
    ASSERT_NE(octahedra, nullptr);
    // Four corners of each cell, and a place inside; the same in control tetrahedra.
    Places inFine;
    std::vector<vtkIdType> cells;
    for (vtkIdType cell = 0; cell < fine->GetNumberOfCells(); cell += levels == 1 ? 1 : 11)
    {
      if (fine->GetCellType(cell) == VTK_TETRA)
      {
        cells.push_back(cell);
        inFine.Add(cell, { 0., 0., 0. });
        inFine.Add(cell, { 1., 0., 0. });
        inFine.Add(cell, { 0., 1., 0. });
        inFine.Add(cell, { 0., 0., 1. });
        inFine.Add(cell, { 0.23, 0.31, 0.17 });
      }
    }
    const auto found = EvaluateTetOct(fine, inFine);
    Places inControl;
    std::vector<std::array<Point, 3>>
      ways; // of the parameters of each cell in those of its control
    int pieces = 0;
    for (std::size_t n = 0; n < cells.size(); ++n)
    {
      pieces += octahedra->GetComponent(cells[n], 0) >= 0. ? 1 : 0;
      for (vtkIdType control = 0; control < 5 && ways.size() == n; ++control)
      {
        std::vector<Point> corners;
        for (vtkIdType i = 0; i < 4; ++i)
        {
          for (vtkIdType k = 35 * control; k < 35 * (control + 1); ++k)
          {
            if (Distance(GetPoint(known, k), GetPoint(found, 5 * static_cast<vtkIdType>(n) + i)) <
              1e-11)
            {
              Point p{};
              lattice.Parameters->GetTuple(k, p.data());
              corners.push_back(p);
            }
          }
        }
        if (corners.size() == 4)
        {
          std::array<Point, 3> way{};
          Point place = corners[0];
          const double parameters[3] = { 0.23, 0.31, 0.17 };
          for (int d = 0; d < 3; ++d)
          {
            for (int c = 0; c < 3; ++c)
            {
              way[d][c] = corners[d + 1][c] - corners[0][c];
              place[c] += parameters[d] * way[d][c];
            }
          }
          ways.push_back(way);
          inControl.Add(control, place);
        }
      }
      ASSERT_EQ(ways.size(), n + 1) << "cell " << cells[n];
    }
    EXPECT_GE(pieces, 10);
    EXPECT_GE(static_cast<int>(cells.size()), pieces + 8);
    const auto expected = EvaluateTetOct(grid, inControl);
    const char* names[3] = { "DerivativeU", "DerivativeV", "DerivativeW" };
    for (std::size_t n = 0; n < cells.size(); ++n)
    {
      const auto control = static_cast<vtkIdType>(n);
      const vtkIdType place = 5 * control + 4;
      EXPECT_LT(Distance(GetPoint(expected, control), GetPoint(found, place)), 1e-12) << n;
      EXPECT_NEAR(expected->GetPointData()->GetArray("Random")->GetComponent(control, 0),
        found->GetPointData()->GetArray("Random")->GetComponent(place, 0), 1e-12);
      for (int d = 0; d < 3; ++d)
      {
        const Point slope = GetTuple(found, names[d], place);
        for (int c = 0; c < 3; ++c)
        {
          double sum = 0.;
          for (int k = 0; k < 3; ++k)
          {
            sum += ways[n][d][k] * GetTuple(expected, names[k], control)[c];
          }
          EXPECT_NEAR(slope[c], sum, 1e-12) << n << " " << names[d];
        }
      }
    }
  }
}

/// Between vertices of deep levels values are those of a smooth function.
TEST(EvaluateLimitTetOct, ValuesBesideVerticesOfDeepLevels)
{
  const Grid grid = MakeTets(false);
  const Point vertex{ 77. / 256., 50. / 256., 41. / 256. };
  const Point step{ 1e-7, -3e-7, 2e-7 };
  Places places;
  places.Add(1, vertex);
  places.Add(1, { vertex[0] + step[0], vertex[1] + step[1], vertex[2] + step[2] });
  const auto result = EvaluateTetOct(grid, places);
  const char* names[3] = { "DerivativeU", "DerivativeV", "DerivativeW" };
  for (int c = 0; c < 3; ++c)
  {
    double change = 0.;
    for (int k = 0; k < 3; ++k)
    {
      change += step[k] * GetTuple(result, names[k], 1)[c];
    }
    EXPECT_NEAR(GetPoint(result, 1)[c] - GetPoint(result, 0)[c], change, 1e-12) << c;
  }
}
