// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Curved/CurvedShapes.h"

#include "Core/Memory/Loops.h"
#include "Private/Curved/CellJacobian.h"

#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <map>
#include <mutex>
#include <numeric>
#include <tuple>

namespace subdivision
{
namespace
{

constexpr int QuadraticTypes[NumberOfShapes] = { VTK_VERTEX, VTK_QUADRATIC_EDGE,
  VTK_QUADRATIC_TRIANGLE, VTK_QUADRATIC_QUAD, VTK_QUADRATIC_TETRA, VTK_QUADRATIC_PYRAMID,
  VTK_QUADRATIC_WEDGE, VTK_QUADRATIC_HEXAHEDRON, VTK_EMPTY_CELL };
constexpr int LagrangeTypes[NumberOfShapes] = { VTK_VERTEX, VTK_LAGRANGE_CURVE,
  VTK_LAGRANGE_TRIANGLE, VTK_LAGRANGE_QUADRILATERAL, VTK_LAGRANGE_TETRAHEDRON, VTK_EMPTY_CELL,
  VTK_LAGRANGE_WEDGE, VTK_LAGRANGE_HEXAHEDRON, VTK_EMPTY_CELL };

vtkIdType CountNodes(CellShape shape, CurvedKind kind, int order)
{
  const vtkIdType line = order + 1;
  const vtkIdType triangle = line * (order + 2) / 2;
  const vtkIdType ofLagrange[NumberOfShapes] = { 1, line, triangle, line * line,
    triangle * (order + 3) / 3, 0, triangle * line, line * line * line, 0 };
  const CellTable& table = GetCellTable(shape);
  return kind == CurvedKind::Lagrange ? ofLagrange[static_cast<int>(shape)]
                                      : table.Corners + static_cast<vtkIdType>(table.Edges.size());
}

/// A cell of a type with a number of nodes. A grid finds the order of a Lagrange cell.
vtkSmartPointer<vtkCell> MakeCell(int type, vtkIdType nodes)
{
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(nodes);
  std::vector<vtkIdType> ids(nodes);
  std::iota(ids.begin(), ids.end(), vtkIdType(0));
  for (const vtkIdType id : ids)
  {
    points->SetPoint(id, 0., 0., 0.);
  }
  grid->SetPoints(points);
  grid->InsertNextCell(type, nodes, ids.data());
  return grid->GetCell(0);
}

CurvedShape Make(CellShape shape, CurvedKind kind, int order)
{
  CurvedShape made;
  made.Shape = shape;
  made.Order = kind == CurvedKind::Quadratic ? 2 : order;
  made.CellType =
    (kind == CurvedKind::Quadratic ? QuadraticTypes : LagrangeTypes)[static_cast<int>(shape)];
  if (made.CellType == VTK_EMPTY_CELL)
  {
    return made;
  }
  const vtkIdType nodes = CountNodes(shape, kind, order);
  made.Cell = MakeCell(made.CellType, nodes);
  const double* at = made.Cell->GetParametricCoords();
  for (vtkIdType n = 0; n < nodes; ++n, at += 3)
  {
    // VTK's pyramids have the parameters of a cube, of which one side became the apex.
    const double size = shape == CellShape::Pyramid ? 1. - at[2] : 1.;
    FrameNode node{};
    for (int axis = 0; axis < GetCellTable(shape).Dimension; ++axis)
    {
      const double x = at[axis] * (axis < 2 ? size : 1.);
      node[axis] = static_cast<int>(std::lround(x * made.Order));
    }
    made.Nodes.push_back(node);
  }
  if (GetCellTable(shape).Dimension == 3)
  {
    for (const int f : InTurn(made.Cell->GetNumberOfFaces()))
    {
      vtkCell* face = made.Cell->GetFace(f);
      const vtkIdType* ids = face->GetPointIds()->GetPointer(0);
      made.Faces.push_back({ face->GetNumberOfEdges(), { ids, ids + face->GetNumberOfPoints() } });
    }
    made.Jacobian = std::make_shared<CellJacobian>(made);
  }
  return made;
}

}

const CurvedShape* CurvedShape::Get(CellShape shape, CurvedKind kind, int order)
{
  static std::map<std::tuple<CellShape, CurvedKind, int>, CurvedShape> shapes;
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  auto found = shapes.find({ shape, kind, order });
  if (found == shapes.end())
  {
    found = shapes.emplace(std::make_tuple(shape, kind, order), Make(shape, kind, order)).first;
  }
  return found->second.Nodes.empty() ? nullptr : &found->second;
}

}
