// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Curved/Prolongation.h"

#include "Core/Memory/Loops.h"
#include "Private/Curved/CurvedNodes.h"
#include "Private/Reading/CellReader.h"
#include "Private/Roots/SplitRoots.h"

#include "vtkPointSet.h"
#include "vtkTetra.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace subdivision
{
namespace
{

/// Cells of a level as roots of a finer mesh, and as curved ones.
class Level
{
public:
  Level(vtkPointSet* mesh, int steps, vtkUnstructuredGrid* curved, CurvedKind kind, int order)
    : Roots(mesh, steps, [steps](const Root& root) { return root.Steps == steps; })
    , Curved(curved)
    , Cells(curved)
    , Size(1 << steps)
  {
    for (int s = 0; s < NumberOfShapes; ++s)
    {
      const auto shape = static_cast<CellShape>(s);
      this->Shapes[s] =
        CurvedShape::Get(shape == CellShape::Octahedron ? CellShape::Tet : shape, kind, order);
    }
  }
  /// Finds the corners of cells in the mesh. Those of an octahedron are corners of others, as it
  /// is in the middle of them. Returns false if the cells are no roots.
  bool FindCorners()
  {
    this->Corners.assign(this->Curved->GetNumberOfPoints(), -1);
    bool areRoots = this->Roots.GetNumberOfRoots() == this->Curved->GetNumberOfCells();
    for (const vtkIdType r : InTurn(areRoots ? this->Roots.GetNumberOfRoots() : vtkIdType(0)))
    {
      const Root& root = this->Roots.GetRoot(r);
      areRoots = areRoots && root.Lattice && this->GetShape(r);
      if (areRoots && root.Shape != CellShape::Octahedron)
      {
        const CurvedShape& shape = *this->GetShape(r);
        std::vector<vtkIdType> scratch;
        const CellIds nodes = this->GetNodes(r, scratch);
        for (int k = 0; k < GetCellTable(shape.Shape).Corners; ++k)
        {
          FrameNode at = shape.Nodes[k];
          std::for_each(at.begin(), at.end(), [&](int& x) { x = x / shape.Order * this->Size; });
          this->Corners[nodes.Ids[k]] = this->Roots.GetPoint(root, at);
        }
      }
    }
    return areRoots;
  }
  const CurvedShape* GetShape(vtkIdType r) const
  {
    return this->Shapes[static_cast<int>(this->Roots.GetRoot(r).Shape)];
  }
  CellIds GetNodes(vtkIdType cell, std::vector<vtkIdType>& scratch) const
  {
    return this->Cells.GetCell(cell, scratch);
  }

  const SplitRoots Roots;
  std::vector<vtkIdType> Corners; ///< of each curved point that is a corner, its point of the mesh

private:
  vtkUnstructuredGrid* Curved;
  const CellReader Cells;
  const int Size;
  std::array<const CurvedShape*, NumberOfShapes> Shapes{};
};

/// The weights of the nodes of a cell, without those that are 0.
using Weights = std::vector<std::pair<int, double>>;

/// Weights of shape functions at nodes of children: multiples of 1 / (2 Order) of the cell.
class NodeWeights
{
public:
  const Weights* Find(const CurvedShape& shape, const FrameNode& place)
  {
    const auto entry = this->Known.emplace(std::make_pair(&shape, place), Weights());
    Weights& weights = entry.first->second;
    if (!entry.second)
    {
      return &weights;
    }
    for (int n = 0; n < shape.GetNumberOfNodes(); ++n)
    {
      FrameNode at = shape.Nodes[n];
      std::for_each(at.begin(), at.end(), [](int& x) { x *= 2; });
      if (at == place) // the apex of a pyramid has no parameters of its own
      {
        weights.assign(1, { n, 1. });
        return &weights;
      }
    }
    std::array<double, 3> at{};
    std::transform(place.begin(), place.end(), at.begin(),
      [&](int x) { return static_cast<double>(x) / (2 * shape.Order); });
    if (shape.Shape == CellShape::Pyramid)
    {
      at[0] /= 1. - at[2];
      at[1] /= 1. - at[2];
    }
    std::vector<double> values(shape.GetNumberOfNodes());
    shape.Cell->InterpolateFunctions(at.data(), values.data());
    for (int n = 0; n < shape.GetNumberOfNodes(); ++n)
    {
      constexpr double rounding = 1e-13;
      std::abs(values[n]) > rounding ? weights.push_back({ n, values[n] }) : void();
    }
    return &weights;
  }

private:
  std::map<std::pair<const CurvedShape*, FrameNode>, Weights> Known;
};

/// Finds the rows of the nodes of one cell after another.
class RowFinder
{
public:
  /// The cell of the first level that has a node, and its weights there.
  struct Row
  {
    vtkIdType Cell = -1;
    const Weights* Of = nullptr;
  };

  RowFinder(const Level& coarse, const Level& fine, int steps, vtkIdType points)
    : Coarse(coarse)
    , Fine(fine)
    , Size(1 << steps)
    , Rows(points)
  {
  }
  /// Returns false if a child has a corner that its parent does not have, or has no parent.
  bool Find()
  {
    vtkIdType child = 0;
    for (const vtkIdType parent : InTurn(this->Coarse.Roots.GetNumberOfRoots()))
    {
      const Root& root = this->Coarse.Roots.GetRoot(parent);
      if (root.Quarter > 0)
      {
        continue;
      }
      this->ListPlaces(root);
      const vtkIdType end = root.First + static_cast<vtkIdType>(root.Lattice->GetTypes().size());
      for (;
        child < this->Fine.Roots.GetNumberOfRoots() && this->Fine.Roots.GetRoot(child).First < end;
        ++child)
      {
        if (!this->FindRows(parent, child))
        {
          return false;
        }
      }
    }
    return child == this->Fine.Roots.GetNumberOfRoots();
  }
  const Row& GetRow(vtkIdType node) const { return this->Rows[node]; }

private:
  /// Where the points of a parent and its children are, in halves of its edges.
  void ListPlaces(const Root& root)
  {
    const int dimension = GetCellTable(root.Shape).Dimension;
    const int least = root.Shape == CellShape::Octahedron ? -2 : 0;
    this->Places.clear();
    for (int z = dimension > 2 ? least : 0; z <= (dimension > 2 ? 2 : 0); ++z)
    {
      for (int y = dimension > 1 ? least : 0; y <= (dimension > 1 ? 2 : 0); ++y)
      {
        for (int x = dimension > 0 ? least : 0; x <= (dimension > 0 ? 2 : 0); ++x)
        {
          const vtkIdType point = this->Coarse.Roots.GetPoint(
            root, { { x * this->Size, y * this->Size, z * this->Size } });
          this->Places.emplace(point, FrameNode{ { x, y, z } });
        }
      }
    }
    this->Places.erase(-1);
  }
  /// The corners of a curved cell among these places. Returns false if one is none.
  bool FindCorners(const Level& level, vtkIdType cell, std::array<FrameNode, 8>& places) const
  {
    std::vector<vtkIdType> scratch;
    const CellIds nodes = level.GetNodes(cell, scratch);
    for (int k = 0; k < GetCellTable(level.GetShape(cell)->Shape).Corners; ++k)
    {
      const auto found = this->Places.find(level.Corners[nodes.Ids[k]]);
      if (found == this->Places.end())
      {
        return false;
      }
      places[k] = found->second;
    }
    return true;
  }
  bool FindRows(vtkIdType parent, vtkIdType child)
  {
    std::array<FrameNode, 8> corners{};
    if (!this->FindCorners(this->Fine, child, corners))
    {
      return false;
    }
    const CurvedShape& shape = *this->Fine.GetShape(child);
    std::vector<vtkIdType> scratch;
    const CellIds nodes = this->Fine.GetNodes(child, scratch);
    for (int n = 0; n < shape.GetNumberOfNodes(); ++n)
    {
      Row& row = this->Rows[nodes.Ids[n]];
      if (row.Of)
      {
        continue;
      }
      const auto weights = GetStraightWeights(shape, shape.Nodes[n]);
      std::array<double, 3> at{};
      for (int k = 0; k < GetCellTable(shape.Shape).Corners; ++k)
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          at[axis] += weights[k] * corners[k][axis];
        }
      }
      row = this->FindRow(parent, at);
      if (!row.Of)
      {
        return false;
      }
    }
    return true;
  }
  /// The row of a place in halves of edges.
  Row FindRow(vtkIdType parent, std::array<double, 3> at)
  {
    Row row;
    row.Cell = parent;
    if (this->Coarse.Roots.GetRoot(parent).Shape == CellShape::Octahedron)
    {
      std::array<FrameNode, 8> corners{};
      std::array<double, 3> inside{};
      for (int piece = 0; !row.Of && piece < 4; ++piece)
      {
        row.Cell = parent + piece;
        if (this->FindCorners(this->Coarse, row.Cell, corners) && FindInTet(corners, at, inside))
        {
          row.Of = this->FindWeights(row.Cell, inside);
        }
      }
      return row;
    }
    row.Of = this->FindWeights(parent, at);
    return row;
  }
  const Weights* FindWeights(vtkIdType parent, const std::array<double, 3>& at)
  {
    const CurvedShape& shape = *this->Coarse.GetShape(parent);
    FrameNode place{};
    std::transform(at.begin(), at.end(), place.begin(),
      [&](double x) { return static_cast<int>(std::lround(x * shape.Order)); });
    return this->Known.Find(shape, place);
  }
  /// The same place in halves of the edges of a tetrahedron. Returns whether it is inside.
  static bool FindInTet(const std::array<FrameNode, 8>& corners, std::array<double, 3> at,
    std::array<double, 3>& inside)
  {
    double places[4][3];
    double weights[4];
    for (std::size_t k = 0; k < 4; ++k)
    {
      std::copy(corners[k].begin(), corners[k].end(), places[k]);
    }
    vtkTetra::BarycentricCoords(at.data(), places[0], places[1], places[2], places[3], weights);
    std::transform(weights + 1, weights + 4, inside.begin(), [](double w) { return 2. * w; });
    constexpr double rounding = 1e-9;
    return *std::min_element(weights, weights + 4) > -rounding;
  }

  const Level& Coarse;
  const Level& Fine;
  const int Size;
  std::vector<Row> Rows;
  std::map<vtkIdType, FrameNode> Places;
  NodeWeights Known;
};

}

void Prolongation::Take(vtkPointSet* mesh, int steps, vtkUnstructuredGrid* curved)
{
  if (!this->Coarse)
  {
    this->Coarse = curved;
    return;
  }
  Level coarse(mesh, steps + 1, this->Coarse, this->Kind, this->Order);
  Level fine(mesh, steps, curved, this->Kind, this->Order);
  const vtkIdType size = curved->GetNumberOfPoints();
  RowFinder rows(coarse, fine, steps, size);
  if (!coarse.FindCorners() || !fine.FindCorners() || !rows.Find())
  {
    return;
  }
  this->Matrix.NumberOfColumns = this->Coarse->GetNumberOfPoints();
  this->Matrix.Offsets = Buffer<long long>(size + 1, 0);
  for (const vtkIdType i : InTurn(size))
  {
    this->Matrix.Offsets[i + 1] =
      this->Matrix.Offsets[i] + static_cast<long long>(rows.GetRow(i).Of->size());
  }
  this->Matrix.Columns = Buffer<long long>(this->Matrix.Offsets[size]);
  this->Matrix.Weights = Buffer<double>(this->Matrix.Offsets[size]);
  ForEach(size,
    [&](vtkIdType i)
    {
      const auto& row = rows.GetRow(i);
      std::vector<vtkIdType> scratch;
      const CellIds nodes = coarse.GetNodes(row.Cell, scratch);
      long long at = this->Matrix.Offsets[i];
      for (const auto& [node, weight] : *row.Of)
      {
        this->Matrix.Columns[at] = nodes.Ids[node];
        this->Matrix.Weights[at++] = weight;
      }
    });
}

}
