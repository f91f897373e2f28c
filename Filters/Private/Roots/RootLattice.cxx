// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Roots/RootLattice.h"

#include "Core/Cells/CellFrames.h"
#include "Core/Solids/Complex/Simplices.h"
#include "Core/Solids/TetOct/TetOctTables.h"

#include <algorithm>

namespace subdivision
{
namespace
{

using Act = std::function<void(const LatticeCell&)>;

struct Child
{
  CellShape Shape;
  std::array<unsigned char, 8> Points; ///< local points (CellShapes.h)
};

/// As cells keep their types, but for the order of some.
std::vector<Child> MakeChildren(CellShape shape, SplitOrder order)
{
  std::vector<Child> children;
  for (const CellChild& child : GetCellTable(shape).Children)
  {
    children.push_back({ child.Shape, child.Points });
  }
  const auto replace = [&](std::size_t first, CellShape of, const auto& lists)
  {
    children.resize(first);
    for (const auto& points : lists)
    {
      children.push_back({ of, {} });
      std::copy(std::begin(points), std::end(points), children.back().Points.begin());
    }
  };
  if (order == SplitOrder::Simplices && shape == CellShape::Tet)
  {
    replace(0, shape, tetrahedron::Children);
  }
  else if (order == SplitOrder::TetOct && shape == CellShape::Octahedron)
  {
    replace(6, CellShape::Tet, OctShape::GetChildren(TetShape()));
  }
  else if (order == SplitOrder::Simplices && shape == CellShape::Quad)
  {
    for (int c = 0; c < 4; ++c) // each child begins with its corner
    {
      auto& points = children[c].Points;
      std::rotate(points.begin(), points.begin() + c, points.begin() + 4);
    }
  }
  return children;
}

const std::vector<Child>& GetChildren(CellShape shape, SplitOrder order)
{
  static const auto all = []
  {
    std::array<std::vector<Child>, NumberOfShapes * NumberOfSplitOrders> made;
    for (int i = 0; i < NumberOfShapes * NumberOfSplitOrders; ++i)
    {
      made[i] = MakeChildren(
        static_cast<CellShape>(i % NumberOfShapes), static_cast<SplitOrder>(i / NumberOfShapes));
    }
    return made;
  }();
  return all[static_cast<int>(shape) + NumberOfShapes * static_cast<int>(order)];
}

/// Returns where the cells that follow begin.
int Split(const LatticeCell& cell, SplitOrder order, int steps, const Act& act)
{
  if (steps == 0)
  {
    act(cell);
    return cell.First + (cell.Shape == CellShape::Octahedron ? 4 : 1);
  }
  std::array<FrameNode, 27> nodes{};
  int size = 0;
  for (const auto& corners : GetCellTable(cell.Shape).PointCorners)
  {
    FrameNode& node = nodes[size++];
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const unsigned char corner : corners)
      {
        node[axis] += cell.Corners[corner][axis];
      }
      node[axis] /= static_cast<int>(corners.size());
    }
  }
  int next = cell.First;
  for (const Child& child : GetChildren(cell.Shape, order))
  {
    LatticeCell made{ child.Shape, next, {} };
    std::transform(child.Points.begin(), child.Points.end(), made.Corners.begin(),
      [&nodes](unsigned char point) { return nodes[point]; });
    next = Split(made, order, steps - 1, act);
  }
  return next;
}

}

std::array<FrameNode, 8> GetCornerNodes(CellShape shape, int divisions)
{
  std::array<FrameNode, 8> nodes{};
  const int size = shape == CellShape::Octahedron ? -divisions : divisions;
  int corner = 0;
  for (const FramePoint& point : GetFrameCorners(shape))
  {
    std::transform(point.begin(), point.end(), nodes[corner++].begin(),
      [size](double x) { return static_cast<int>(x) * size; });
  }
  return nodes;
}

void ForLatticeCells(CellShape shape, SplitOrder order, int steps, const Act& act)
{
  Split({ shape, 0, GetCornerNodes(shape, 1 << steps) }, order, steps, act);
}

std::vector<LatticeCell> ListLatticeCells(CellShape shape, SplitOrder order, int steps)
{
  std::vector<LatticeCell> cells;
  ForLatticeCells(
    shape, order, steps, [&cells](const LatticeCell& cell) { cells.push_back(cell); });
  return cells;
}

RootLattice::RootLattice(CellShape shape, SplitOrder order, int steps)
{
  const int size = 1 << steps;
  const int coarse = std::max(1, size / 4); // enough to tell orders apart
  const int dimension = GetCellTable(shape).Dimension;
  this->Low = shape == CellShape::Octahedron ? -size : 0;
  this->Width = size - this->Low + 1;
  this->Corners = Buffer<int>((dimension > 0 ? this->Width : 1) *
      (dimension > 1 ? this->Width : 1) * vtkIdType(dimension > 2 ? this->Width : 1),
    -1);
  ForLatticeCells(shape, order, steps,
    [&](const LatticeCell& cell)
    {
      const bool isOct = cell.Shape == CellShape::Octahedron;
      this->Types.insert(this->Types.end(), isOct ? 4 : 1,
        isOct ? static_cast<unsigned char>(VTK_TETRA)
              : TypesOfShapes[static_cast<std::size_t>(cell.Shape)]);
      if (isOct)
      {
        this->Octahedra.push_back(cell);
        return;
      }
      for (int k = 0; k < GetCellTable(cell.Shape).Corners; ++k)
      {
        const FrameNode& node = cell.Corners[k];
        int& corner = this->Corners[this->Index(node)];
        if (corner < 0)
        {
          corner = ToCorner(cell.First, k);
        }
        else if (std::all_of(node.begin(), node.end(), [coarse](int x) { return x % coarse == 0; }))
        {
          this->EqualCorners.emplace_back(corner, ToCorner(cell.First, k));
        }
      }
    });
  for (std::size_t oct = 0; oct < this->Octahedra.size(); ++oct)
  {
    for (int k = 0; k < 6; ++k)
    {
      int& corner = this->Corners[this->Index(this->Octahedra[oct].Corners[k])];
      corner = corner == -1 ? -2 - static_cast<int>(oct) : corner;
    }
  }
}

}
