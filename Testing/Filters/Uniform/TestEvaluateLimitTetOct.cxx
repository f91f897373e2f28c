// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestEvaluateLimitTetOct.cxx
 * The limit at places of tetrahedra by the tet/oct scheme: against the projected points of levels,
 * by symmetry, and against differences.
 */
#include "MultiDimensionalSubdivisionTools.h"
#include "PlaceTools.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>

using namespace multi_dimensional_subdivision_tools;
using namespace place_tools;

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

vtkSmartPointer<vtkPolyData> EvaluateTetOct(vtkUnstructuredGrid* grid, const Places& places)
{
  vtkNew<Filter> filter;
  filter->SetInputData(grid);
  filter->SetVolumeSchemeToTetOct();
  return Evaluate(filter.Get(), places);
}

Point GetTuple(vtkPolyData* result, const char* name, vtkIdType i)
{
  Point p{};
  result->GetPointData()->GetArray(name)->GetTuple(i, p.data());
  return p;
}

double GetDistance(const Point& a, const Point& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

}

/// All places with parameters that are multiples of 1/4 are vertices of level 2, and the only ones:
/// corners, middles of edges and centres of octahedra. They have the limits of these.
TEST(EvaluateLimitTetOct, LatticesAreVerticesOfALevel)
{
  for (const bool hasCrease : { false, true })
  {
    const Grid grid = MakeTets(hasCrease);
    vtkNew<Filter> filter;
    filter->SetVolumeSchemeToTetOct();
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
          GetDistance(GetPoint(fine, p), x) < GetDistance(GetPoint(fine, nearest), x) ? p : nearest;
      }
      isMet[static_cast<std::size_t>(nearest)] = true;
      ASSERT_LT(GetDistance(GetPoint(fine, nearest), GetPoint(result, i)), 1e-12) << i;
      ASSERT_NEAR(values->GetComponent(i, 0), fineValues->GetComponent(nearest, 0), 1e-12) << i;
    }
    // The octahedra of the last level are written in pieces with their centres, of level 3.
    const auto met = std::count(isMet.begin(), isMet.end(), true);
    EXPECT_GE(met, 75) << hasCrease;
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
  EXPECT_LT(GetDistance(GetPoint(twice, 0), GetPoint(twice, 1)), 1e-13);
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
      EXPECT_NEAR(slopes[k][c], k == c ? slopes[0][0] : slopes[0][1], 1e-6) << k << " " << c;
    }
  }
}

/// In an output of the filter places are in tetrahedra, with the limit of the control mesh; pieces
/// of octahedra are refused.
TEST(EvaluateLimitTetOct, FiltersInARow)
{
  const Grid grid = MakeTets(false);
  vtkNew<Filter> filter;
  filter->SetVolumeSchemeToTetOct();
  filter->SetNumberOfLevels(1);
  const Grid fine = UpdateWithoutErrors<vtkUnstructuredGrid>(filter.Get(), grid);
  vtkDataArray* pieces = fine->GetCellData()->GetArray("OctahedronId");
  ASSERT_NE(pieces, nullptr);
  vtkIdType whole = 0;
  vtkIdType piece = 0;
  while (pieces->GetComponent(whole, 0) >= 0.)
  {
    ++whole;
  }
  while (pieces->GetComponent(piece, 0) < 0.)
  {
    ++piece;
  }
  Places inFine;
  inFine.Add(whole, { 0.2, 0.3, 0.1 });
  const auto found = EvaluateTetOct(fine, inFine);
  double least = VTK_DOUBLE_MAX;
  Places inControl; // of all corners of the parent, in any order
  const double w[4] = { 0.4, 0.2, 0.3, 0.1 };
  std::array<int, 4> order{ { 0, 1, 2, 3 } };
  do
  {
    for (int corner = 0; corner < 4; ++corner)
    {
      Point p{};
      for (int k = 1; k < 4; ++k)
      {
        p[k - 1] = 0.5 * w[order[k]] + (corner == k ? 0.5 : 0.);
      }
      inControl.Add(0, p);
    }
  } while (std::next_permutation(order.begin(), order.end()));
  const auto all = EvaluateTetOct(grid, inControl);
  for (vtkIdType i = 0; i < inControl.GetSize(); ++i)
  {
    least = std::min(least, GetDistance(GetPoint(all, i), GetPoint(found, 0)));
  }
  EXPECT_LT(least, 1e-12);
  filter->SetInputData(fine);
  vtkNew<Messages> messages;
  messages->Watch(filter);
  Places inPiece;
  inPiece.Add(piece, { 0.2, 0.3, 0.1 });
  vtkNew<vtkPolyData> result;
  EXPECT_FALSE(filter->EvaluateLimit(inPiece.Cells, inPiece.Parameters, result));
  ASSERT_FALSE(messages->Errors.empty());
  EXPECT_NE(messages->Errors[0].find("a piece of an octahedron"), std::string::npos)
    << messages->Errors[0];
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
