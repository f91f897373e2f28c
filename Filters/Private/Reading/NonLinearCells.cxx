// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Reading/NonLinearCells.h"

#include "Private/Reading/SolidCells.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkHigherOrderHexahedron.h"
#include "vtkHigherOrderQuadrilateral.h"
#include "vtkHigherOrderTetra.h"
#include "vtkHigherOrderTriangle.h"
#include "vtkHigherOrderWedge.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <limits>

namespace subdivision
{
namespace
{

/// A type of cell whose nodes are at fixed places: for each node after the corners the corners
/// whose mean it is.
struct QuadraticCell
{
  int Type;
  int CornerType;
  int Corners;
  std::vector<std::vector<int>> Nodes;
};

const std::vector<QuadraticCell>& GetQuadraticCells()
{
  using Nodes = std::vector<std::vector<int>>;
  const auto join = [](Nodes a, const Nodes& b)
  {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  };
  static const Nodes triangle = { { 0, 1 }, { 1, 2 }, { 2, 0 } };
  static const Nodes quad = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 } };
  static const Nodes tetra = join(triangle, { { 0, 3 }, { 1, 3 }, { 2, 3 } });
  static const Nodes layers = join(triangle, { { 3, 4 }, { 4, 5 }, { 5, 3 } });
  static const Nodes wedge = join(layers, { { 0, 3 }, { 1, 4 }, { 2, 5 } });
  static const Nodes sides = { { 0, 1, 4, 3 }, { 1, 2, 5, 4 }, { 2, 0, 3, 5 } };
  static const Nodes pyramid = join(quad, { { 0, 4 }, { 1, 4 }, { 2, 4 }, { 3, 4 } });
  static const Nodes hexahedron =
    join(quad, { { 4, 5 }, { 5, 6 }, { 6, 7 }, { 7, 4 }, { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } });
  static const std::vector<QuadraticCell> cells = {
    { VTK_QUADRATIC_EDGE, VTK_LINE, 2, { { 0, 1 } } },
    { VTK_QUADRATIC_TRIANGLE, VTK_TRIANGLE, 3, triangle },
    { VTK_BIQUADRATIC_TRIANGLE, VTK_TRIANGLE, 3, join(triangle, { { 0, 1, 2 } }) },
    { VTK_QUADRATIC_QUAD, VTK_QUAD, 4, quad },
    { VTK_BIQUADRATIC_QUAD, VTK_QUAD, 4, join(quad, { { 0, 1, 2, 3 } }) },
    { VTK_QUADRATIC_LINEAR_QUAD, VTK_QUAD, 4, { { 0, 1 }, { 2, 3 } } },
    { VTK_QUADRATIC_TETRA, VTK_TETRA, 4, tetra },
    { VTK_QUADRATIC_HEXAHEDRON, VTK_HEXAHEDRON, 8, hexahedron },
    { VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, VTK_HEXAHEDRON, 8,
      join(hexahedron, { { 0, 4, 7, 3 }, { 1, 2, 6, 5 }, { 0, 1, 5, 4 }, { 3, 7, 6, 2 } }) },
    { VTK_TRIQUADRATIC_HEXAHEDRON, VTK_HEXAHEDRON, 8,
      join(hexahedron,
        { { 0, 4, 7, 3 }, { 1, 2, 6, 5 }, { 0, 1, 5, 4 }, { 3, 7, 6, 2 }, { 0, 1, 2, 3 },
          { 4, 5, 6, 7 }, { 0, 1, 2, 3, 4, 5, 6, 7 } }) },
    { VTK_QUADRATIC_WEDGE, VTK_WEDGE, 6, wedge },
    { VTK_QUADRATIC_LINEAR_WEDGE, VTK_WEDGE, 6, layers },
    { VTK_BIQUADRATIC_QUADRATIC_WEDGE, VTK_WEDGE, 6, join(wedge, sides) },
    { VTK_QUADRATIC_PYRAMID, VTK_PYRAMID, 5, pyramid },
    { VTK_TRIQUADRATIC_PYRAMID, VTK_PYRAMID, 5,
      join(pyramid,
        { { 0, 1, 2, 3 }, { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 }, { 3, 0, 4 },
          { 0, 1, 2, 3, 4 } }) },
    // Lagrange and Bezier cells have full lattices, but for these.
    { VTK_LAGRANGE_TRIANGLE, VTK_TRIANGLE, 3, join(triangle, { { 0, 1, 2 } }) },
    { VTK_LAGRANGE_TETRAHEDRON, VTK_TETRA, 4,
      join(tetra, { { 0, 1, 2 }, { 0, 1, 3 }, { 1, 2, 3 }, { 0, 2, 3 }, { 0, 1, 2, 3 } }) },
    { VTK_LAGRANGE_WEDGE, VTK_WEDGE, 6,
      join(join(wedge, { { 0, 1, 2 }, { 3, 4, 5 } }), join(sides, { { 0, 1, 2, 3, 4, 5 } })) },
  };
  return cells;
}

/// The Lagrange type that has the same nodes as a Bezier type; other types are returned as they
/// are.
int ToLagrange(int cellType)
{
  return cellType >= VTK_BEZIER_CURVE && cellType <= VTK_BEZIER_WEDGE
    ? cellType - VTK_BEZIER_CURVE + VTK_LAGRANGE_CURVE
    : cellType;
}

const QuadraticCell* FindQuadratic(int cellType, vtkIdType size)
{
  for (const QuadraticCell& cell : GetQuadraticCells())
  {
    if (cell.Type == cellType && size == cell.Corners + static_cast<vtkIdType>(cell.Nodes.size()))
    {
      return &cell;
    }
  }
  return nullptr;
}

void Add(CellPieces& table, int type, std::initializer_list<int> nodes)
{
  CellPiece piece;
  piece.Type = type;
  piece.Size = static_cast<int>(nodes.size());
  std::copy(nodes.begin(), nodes.end(), piece.Nodes.begin());
  table.Pieces.push_back(piece);
}

// ------------------------------------------------------------------------------------------------
// Full lattices: node(i, j, k) is the node at a place of the lattice.

/// The corners of a hexahedron; of a quad the first four, of a line the first two.
constexpr int CornersOfBox[8][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 },
  { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };

/// Lines, quads or hexahedra.
template <typename Node>
void CutBox(int type, const std::array<int, 3>& orders, const Node& node, CellPieces& table)
{
  CellPiece piece;
  piece.Type = type;
  piece.Size = 1 << table.Dimension;
  for (int k = 0; k < (table.Dimension > 2 ? orders[2] : 1); ++k)
  {
    for (int j = 0; j < (table.Dimension > 1 ? orders[1] : 1); ++j)
    {
      for (int i = 0; i < orders[0]; ++i)
      {
        std::transform(CornersOfBox, CornersOfBox + piece.Size, piece.Nodes.begin(),
          [&](const int(&at)[3]) { return node(i + at[0], j + at[1], k + at[2]); });
        table.Pieces.push_back(piece);
      }
    }
  }
}

template <typename Node>
void CutTriangle(int order, const Node& node, CellPieces& table)
{
  for (int j = 0; j < order; ++j)
  {
    for (int i = 0; i + j < order; ++i)
    {
      Add(table, VTK_TRIANGLE, { node(i, j, 0), node(i + 1, j, 0), node(i, j + 1, 0) });
      if (i + j + 2 <= order)
      {
        Add(table, VTK_TRIANGLE, { node(i + 1, j, 0), node(i + 1, j + 1, 0), node(i, j + 1, 0) });
      }
    }
  }
}

template <typename Node>
void CutTetra(int order, const Node& node, CellPieces& table)
{
  for (int k = 0; k < order; ++k)
  {
    for (int j = 0; j + k < order; ++j)
    {
      for (int i = 0; i + j + k < order; ++i)
      {
        const int x = node(i + 1, j, k);
        const int y = node(i, j + 1, k);
        const int z = node(i, j, k + 1);
        Add(table, VTK_TETRA, { node(i, j, k), x, y, z });
        if (i + j + k + 2 > order)
        {
          continue;
        }
        const int yz = node(i, j + 1, k + 1);
        const int xz = node(i + 1, j, k + 1);
        const int xy = node(i + 1, j + 1, k);
        Add(table, CellPiece::Octahedron, { x, yz, y, xz, z, xy });
        if (i + j + k + 3 <= order)
        {
          Add(table, VTK_TETRA, { xy, yz, xz, node(i + 1, j + 1, k + 1) });
        }
      }
    }
  }
}

template <typename Node>
void CutWedge(const std::array<int, 3>& orders, const Node& node, CellPieces& table)
{
  for (int k = 0; k < orders[2]; ++k)
  {
    // The triangles of two layers of the lattice stand above each other.
    CellPieces below;
    CellPieces above;
    CutTriangle(orders[0], [&](int i, int j, int) { return node(i, j, k); }, below);
    CutTriangle(orders[0], [&](int i, int j, int) { return node(i, j, k + 1); }, above);
    for (size_t t = 0; t < below.Pieces.size(); ++t)
    {
      const auto& a = below.Pieces[t].Nodes;
      const auto& b = above.Pieces[t].Nodes;
      Add(table, VTK_WEDGE, { a[0], a[1], a[2], b[0], b[1], b[2] });
    }
  }
}

template <typename Node>
CellPieces CutLattice(int cornerType, const std::array<int, 3>& orders, const Node& node)
{
  CellPieces table;
  switch (cornerType)
  {
    case VTK_TRIANGLE:
      table.Dimension = 2;
      CutTriangle(orders[0], node, table);
      break;
    case VTK_TETRA:
      table.Dimension = 3;
      CutTetra(orders[0], node, table);
      break;
    case VTK_WEDGE:
      table.Dimension = 3;
      CutWedge(orders, node, table);
      break;
    default:
      table.Dimension = cornerType == VTK_LINE ? 1 : cornerType == VTK_QUAD ? 2 : 3;
      CutBox(cornerType, orders, node, table);
      break;
  }
  return table;
}

/// The number of nodes of a full lattice.
vtkIdType CountNodes(int cornerType, const std::array<int, 3>& orders)
{
  const vtkIdType a = orders[0] + 1;
  const vtkIdType b = orders[1] + 1;
  const vtkIdType c = orders[2] + 1;
  switch (cornerType)
  {
    case VTK_LINE:
      return a;
    case VTK_TRIANGLE:
      return a * (a + 1) / 2;
    case VTK_QUAD:
      return a * b;
    case VTK_TETRA:
      return a * (a + 1) * (a + 2) / 6;
    case VTK_WEDGE:
      return a * (a + 1) / 2 * c;
    default:
      return a * b * c;
  }
}

CellPieces CutLagrange(int cornerType, const std::array<int, 3>& orders)
{
  // The last entry is the number of points, which VTK reads of wedges.
  const int all[4] = { orders[0], orders[1], orders[2],
    static_cast<int>(CountNodes(cornerType, orders)) };
  return CutLattice(cornerType, orders,
    [&](int i, int j, int k)
    {
      const vtkIdType n = orders[0];
      const vtkIdType triangle[3] = { i, j, n - i - j };
      const vtkIdType tetra[4] = { i, j, k, n - i - j - k };
      switch (cornerType)
      {
        case VTK_LINE:
          return i == 0 ? 0 : (i == n ? 1 : i + 1);
        case VTK_TRIANGLE:
          return static_cast<int>(vtkHigherOrderTriangle::Index(triangle, n));
        case VTK_QUAD:
          return vtkHigherOrderQuadrilateral::PointIndexFromIJK(i, j, all);
        case VTK_TETRA:
          return static_cast<int>(vtkHigherOrderTetra::Index(tetra, n));
        case VTK_WEDGE:
          return vtkHigherOrderWedge::PointIndexFromIJK(i, j, k, all);
        default:
          return vtkHigherOrderHexahedron::PointIndexFromIJK(i, j, k, all);
      }
    });
}

// ------------------------------------------------------------------------------------------------
// Quadratic cells

/// The node that is the mean of some corners, in any order; -1 if there is none.
int FindNode(const QuadraticCell& cell, std::vector<int> corners)
{
  std::sort(corners.begin(), corners.end());
  for (size_t n = 0; n < cell.Nodes.size(); ++n)
  {
    std::vector<int> others = cell.Nodes[n];
    std::sort(others.begin(), others.end());
    if (others == corners)
    {
      return cell.Corners + static_cast<int>(n);
    }
  }
  return -1;
}

/// Cuts a face by the nodes on it. `corners`: three or four.
void CutFace(const QuadraticCell& cell, const std::vector<int>& corners, CellPieces& table)
{
  const int n = static_cast<int>(corners.size());
  const int centre = FindNode(cell, corners);
  std::vector<int> middles;
  for (int i = 0; i < n; ++i)
  {
    middles.push_back(FindNode(cell, { corners[i], corners[(i + 1) % n] }));
  }
  const auto lacking = std::count(middles.begin(), middles.end(), -1);
  const auto addPolygon = [&](const std::vector<int>& p)
  {
    if (n == 3)
    {
      Add(table, VTK_TRIANGLE, { p[0], p[1], p[2] });
    }
    else
    {
      Add(table, VTK_QUAD, { p[0], p[1], p[2], p[3] });
    }
  };
  if (lacking == n)
  {
    addPolygon(corners);
    return;
  }
  if (lacking > 0) // two opposite edges of a quad have nodes
  {
    const int a = middles[0] < 0 ? 1 : 0;
    const int c = (a + 2) % 4;
    Add(table, VTK_QUAD, { corners[a], middles[a], middles[c], corners[(a + 3) % 4] });
    Add(table, VTK_QUAD, { middles[a], corners[a + 1], corners[c], middles[c] });
    return;
  }
  for (int i = 0; i < n; ++i)
  {
    const int before = middles[(i + n - 1) % n];
    if (centre < 0)
    {
      Add(table, VTK_TRIANGLE, { corners[i], middles[i], before });
    }
    else if (n == 3)
    {
      Add(table, VTK_TRIANGLE, { corners[i], middles[i], centre });
      Add(table, VTK_TRIANGLE, { before, corners[i], centre });
    }
    else
    {
      Add(table, VTK_QUAD, { corners[i], middles[i], centre, before });
    }
  }
  if (centre < 0)
  {
    addPolygon(middles);
  }
}

/// The place in the lattice of each node; of no use where a node is in the middle of a triangle.
std::map<std::array<int, 3>, int> FindPlaces(
  const QuadraticCell& cell, const std::array<int, 3>& orders)
{
  static const int cornersOfTriangles[6] = { 0, 1, 3, 4, 5, 7 }; // the half of a hexahedron
  const bool isBox = cell.CornerType == VTK_HEXAHEDRON || cell.CornerType == VTK_QUAD;
  const auto place = [&](int corner)
  { return CornersOfBox[isBox ? corner : cornersOfTriangles[corner]]; };
  std::map<std::array<int, 3>, int> places;
  for (int node = 0; node < cell.Corners + static_cast<int>(cell.Nodes.size()); ++node)
  {
    const std::vector<int> members =
      node < cell.Corners ? std::vector<int>{ node } : cell.Nodes[node - cell.Corners];
    std::array<int, 3> at{};
    for (int axis = 0; axis < 3; ++axis)
    {
      int sum = 0;
      for (const int corner : members)
      {
        sum += place(corner)[axis];
      }
      at[axis] = orders[axis] * sum / static_cast<int>(members.size());
    }
    places[at] = node;
  }
  return places;
}

CellPieces CutQuadratic(const QuadraticCell& cell)
{
  const SolidFaces* solid = GetFaceTable(cell.CornerType);
  const int size = cell.Corners + static_cast<int>(cell.Nodes.size());
  const int up = cell.CornerType == VTK_WEDGE && FindNode(cell, { 0, 3 }) < 0 ? 1 : 2;
  const std::array<int, 3> orders = { 2, 2, up };
  const bool isFull = cell.CornerType != VTK_PYRAMID && size == CountNodes(cell.CornerType, orders);
  std::vector<int> all(static_cast<size_t>(cell.Corners));
  for (int i = 0; i < cell.Corners; ++i)
  {
    all[i] = i;
  }
  CellPieces table;
  if (isFull)
  {
    const auto places = FindPlaces(cell, orders);
    table = CutLattice(
      cell.CornerType, orders, [&](int i, int j, int k) { return places.at({ i, j, k }); });
  }
  else if (!solid)
  {
    table.Dimension = 2;
    CutFace(cell, all, table);
  }
  else
  {
    table.Dimension = 3;
    table.Centre = FindNode(cell, all);
    for (int f = 0; f < solid->NumberOfFaces; ++f)
    {
      const int* face = solid->Faces[f];
      CutFace(cell, std::vector<int>(face, face + (face[3] < 0 ? 3 : 4)), table);
    }
  }
  return table;
}

/// The corners of a quadratic polygon come first, then the nodes of its edges. Its corners are cut
/// off, which leaves a polygon.
CellPieces CutPolygon(int corners)
{
  CellPieces table;
  table.Dimension = 2;
  for (int i = 0; i < corners; ++i)
  {
    Add(table, VTK_TRIANGLE, { i, corners + i, corners + (i + corners - 1) % corners });
  }
  // More points than a piece has room for: the nodes are the last ones of the cell.
  CellPiece rest;
  rest.Type = VTK_POLYGON;
  rest.Size = corners;
  table.Pieces.push_back(rest);
  return table;
}

/// The type at the corners of a type with lattices; 0 if it is of no such type.
int GetLatticeCorners(int cellType)
{
  switch (ToLagrange(cellType))
  {
    case VTK_CUBIC_LINE:
    case VTK_LAGRANGE_CURVE:
      return VTK_LINE;
    case VTK_LAGRANGE_TRIANGLE:
      return VTK_TRIANGLE;
    case VTK_LAGRANGE_QUADRILATERAL:
      return VTK_QUAD;
    case VTK_LAGRANGE_TETRAHEDRON:
      return VTK_TETRA;
    case VTK_LAGRANGE_HEXAHEDRON:
      return VTK_HEXAHEDRON;
    case VTK_LAGRANGE_WEDGE:
      return VTK_WEDGE;
    default:
      return 0;
  }
}

}

bool IsNonLinear(int cellType)
{
  return GetCornerCell(cellType, std::numeric_limits<int>::max()).Size > 0;
}

CornerCell GetCornerCell(int cellType, vtkIdType size)
{
  if (cellType == VTK_QUADRATIC_POLYGON)
  {
    return { VTK_POLYGON, size >= 6 ? size / 2 : 0 };
  }
  CornerCell corners;
  corners.Type = GetLatticeCorners(cellType);
  switch (corners.Type)
  {
    case 0:
      for (const QuadraticCell& cell : GetQuadraticCells())
      {
        if (cell.Type == cellType)
        {
          corners = { cell.CornerType, cell.Corners };
        }
      }
      break;
    case VTK_LINE:
      corners.Size = 2;
      break;
    case VTK_TRIANGLE:
      corners.Size = 3;
      break;
    default:
      corners.Size = corners.Type == VTK_QUAD ? 4 : GetFaceTable(corners.Type)->NumberOfPoints;
      break;
  }
  corners.Size = corners.Size <= size ? corners.Size : 0;
  return corners;
}

NonLinearCells::NonLinearCells(vtkPointSet* input)
  : Degrees(input->GetCellData()->GetHigherOrderDegrees())
{
  if (this->Degrees && this->Degrees->GetNumberOfComponents() != 3)
  {
    this->Degrees = nullptr;
  }
}

/// From the array, or from the number of points if all orders are the same.
NonLinearCells::Orders NonLinearCells::FindOrders(
  int cellType, vtkIdType cellId, vtkIdType size) const
{
  const int corners = GetLatticeCorners(cellType);
  const bool isOfOne = corners == VTK_LINE || corners == VTK_TRIANGLE || corners == VTK_TETRA;
  if (cellType == VTK_CUBIC_LINE)
  {
    return { 3, 3, 3 };
  }
  if (this->Degrees && !isOfOne && cellId < this->Degrees->GetNumberOfTuples())
  {
    Orders orders;
    for (int i = 0; i < 3; ++i)
    {
      const double degree = this->Degrees->GetComponent(cellId, i);
      orders[i] = degree >= 1. && degree < 1000. ? static_cast<int>(degree) : 0;
    }
    orders[2] = corners == VTK_QUAD ? 1 : orders[2];
    orders[1] = corners == VTK_WEDGE ? orders[0] : orders[1];
    return orders;
  }
  Orders orders{ 1, 1, 1 };
  while (CountNodes(corners, orders) < size && orders[0] < 1000)
  {
    orders = { orders[0] + 1, orders[0] + 1, orders[0] + 1 };
  }
  return orders;
}

const CellPieces* NonLinearCells::Find(int cellType, vtkIdType cellId, vtkIdType size)
{
  const int type = ToLagrange(cellType);
  const QuadraticCell* quadratic = FindQuadratic(type, size);
  const int lattice = quadratic ? 0 : GetLatticeCorners(type);
  const bool isPolygon = type == VTK_QUADRATIC_POLYGON && size >= 6 && size % 2 == 0;
  const Orders orders = lattice ? this->FindOrders(type, cellId, size) : Orders{ 0, 0, 0 };
  if ((!quadratic && !lattice && !isPolygon) || size > std::numeric_limits<int>::max() ||
    (lattice &&
      (*std::min_element(orders.begin(), orders.end()) < 1 || CountNodes(lattice, orders) != size)))
  {
    return nullptr;
  }
  const Key key = { type, static_cast<int>(size), orders[0], orders[1], orders[2] };
  const auto found = this->Tables.find(key);
  if (found != this->Tables.end())
  {
    return &found->second;
  }
  CellPieces& table = this->Tables[key];
  table = quadratic ? CutQuadratic(*quadratic)
    : isPolygon     ? CutPolygon(static_cast<int>(size / 2))
                    : CutLagrange(lattice, orders);
  return &table;
}

}
