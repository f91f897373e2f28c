// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CurvedTools.h
 * Curved cells of the filters, as VTK's own classes see them.
 */
#ifndef SubdivisionObjects_CurvedTools_h
#define SubdivisionObjects_CurvedTools_h

#include "BezierTools.h"
#include "HybridFilterTools.h"
#include "PlaceTools.h"

#include "vtkCell.h"
#include "vtkGenericCell.h"

namespace curved_tools
{

using namespace hybrid_filter_tools;

/// Tetrahedra with faces, edges and other cells on them, none of which is inside out.
inline Grid MakeUprightMixed()
{
  const Grid mixed = bezier_tools::MakeMixed(false);
  std::vector<Point> points;
  for (vtkIdType i = 0; i < mixed->GetNumberOfPoints(); ++i)
  {
    points.push_back(GetPoint(mixed, i));
  }
  std::vector<Cell> cells;
  for (vtkIdType c = 0; c < mixed->GetNumberOfCells(); ++c)
  {
    cells.push_back({ mixed->GetCellType(c), GetCell(mixed, c) });
    if (mixed->GetCellType(c) == VTK_TETRA && GetSignedVolume(mixed, cells.back().Points) < 0.)
    {
      std::swap(cells.back().Points[0], cells.back().Points[1]);
    }
  }
  const Grid grid = MakeGrid(points, cells);
  bezier_tools::AddScalar(grid);
  return grid;
}

/// QUADRATIC_CELLS for order 0, else LAGRANGE_CELLS.
inline void SetOrder(vtkUniformSubdivisionAlgorithm* filter, int order)
{
  filter->SetOutputCells(order == 0 ? Filter::QUADRATIC_CELLS : Filter::LAGRANGE_CELLS);
  filter->SetCellOrder(order == 0 ? 2 : order);
}

/// The points of a cell, at its parameters of nodes, by VTK.
inline std::vector<Point> EvaluateAtNodes(vtkCell* cell)
{
  std::vector<Point> points;
  std::vector<double> weights(static_cast<std::size_t>(cell->GetNumberOfPoints()));
  for (int i = 0; i < static_cast<int>(weights.size()); ++i)
  {
    Point at;
    std::copy_n(cell->GetParametricCoords() + 3 * i, 3, at.begin());
    int part = 0;
    Point p;
    cell->EvaluateLocation(part, at.data(), p.data(), weights.data());
    points.push_back(p);
  }
  return points;
}

/// The determinant of the Jacobian by differences of VTK's points.
inline double FindDeterminant(vtkCell* cell, const Point& at)
{
  const double h = 1e-5;
  std::vector<double> weights(static_cast<std::size_t>(cell->GetNumberOfPoints()));
  double slopes[3][3];
  for (int k = 0; k < 3; ++k)
  {
    Point ends[2];
    for (int side = 0; side < 2; ++side)
    {
      Point moved = at;
      moved[k] += side == 0 ? -h : h;
      int part = 0;
      cell->EvaluateLocation(part, moved.data(), ends[side].data(), weights.data());
    }
    for (int c = 0; c < 3; ++c)
    {
      slopes[k][c] = (ends[1][c] - ends[0][c]) / (2. * h);
    }
  }
  return vtkMath::Determinant3x3(slopes);
}

/// A place of a solid, by random numbers.
template <typename Random>
Point DrawPlace(vtkCell* cell, Random& random)
{
  std::uniform_real_distribution<double> unit(0.001, 0.999);
  Point at{ unit(random), unit(random), unit(random) };
  const vtkIdType corners = cell->GetNumberOfFaces();
  const int inSimplex = corners == 4 ? 3 : cell->GetNumberOfEdges() == 9 ? 2 : 0;
  const double sum = at[0] + (inSimplex > 1 ? at[1] : 0.) + (inSimplex > 2 ? at[2] : 0.);
  for (int k = 0; k < inSimplex && sum > 1.; ++k)
  {
    at[k] /= sum * 1.001;
  }
  return at;
}

/// The corners of a curved cell: as many as its linear one has.
inline std::size_t CountCorners(vtkCell* cell)
{
  switch (cell->GetCellDimension())
  {
    case 0:
      return 1;
    case 1:
      return 2;
    case 2:
      return static_cast<std::size_t>(cell->GetNumberOfEdges());
    default:
      return cell->GetNumberOfFaces() == 4 ? 4
        : cell->GetNumberOfFaces() == 6    ? 8
        : cell->GetNumberOfEdges() == 9    ? 6
                                           : 5;
  }
}

/// VTK's classes find their nodes where they are.
inline void ExpectVtkOrder(vtkUnstructuredGrid* curved)
{
  std::set<int> seen;
  for (vtkIdType c = 0; c < curved->GetNumberOfCells(); ++c)
  {
    if (!seen.insert(curved->GetCellType(c)).second)
    {
      continue;
    }
    vtkCell* cell = curved->GetCell(c);
    const std::vector<Point> points = EvaluateAtNodes(cell);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const Point node = GetPoint(curved, cell->GetPointId(static_cast<int>(i)));
      for (int k = 0; k < 3; ++k)
      {
        // The apex of VTK's quadratic pyramid has no parameters of its own.
        EXPECT_NEAR(points[i][k], node[k], 1e-9) << curved->GetCellType(c) << " " << i;
      }
    }
  }
}

/// Cells of any dimension that have the corners of a face or edge have its nodes there.
inline void ExpectConforming(vtkUnstructuredGrid* curved)
{
  std::map<Ids, Ids> known;
  const auto compare = [&](vtkCell* part, const std::string& where)
  {
    Ids corners;
    Ids nodes;
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      (static_cast<std::size_t>(i) < CountCorners(part) ? corners : nodes)
        .push_back(part->GetPointId(static_cast<int>(i)));
    }
    std::sort(corners.begin(), corners.end());
    std::sort(nodes.begin(), nodes.end());
    const auto entry = known.emplace(corners, nodes).first;
    EXPECT_EQ(entry->second, nodes) << where;
  };
  for (vtkIdType c = 0; c < curved->GetNumberOfCells(); ++c)
  {
    vtkNew<vtkGenericCell> cell;
    curved->GetCell(c, cell);
    const std::string where = "cell " + std::to_string(c);
    for (int e = 0; cell->GetCellDimension() > 1 && e < cell->GetNumberOfEdges(); ++e)
    {
      compare(cell->GetEdge(e), where);
    }
    for (int f = 0; cell->GetCellDimension() > 2 && f < cell->GetNumberOfFaces(); ++f)
    {
      compare(cell->GetFace(f), where);
    }
    compare(curved->GetCell(c), where);
  }
}

}

#endif
