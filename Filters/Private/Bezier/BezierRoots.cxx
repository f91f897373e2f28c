// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bezier/BezierRoots.h"

#include "vtkCellType.h"

#include <algorithm>

namespace subdivision
{
namespace
{

int FindKind(int type)
{
  switch (type)
  {
    case VTK_LINE:
      return PatchShape::Curve;
    case VTK_TRIANGLE:
      return PatchShape::Triangle;
    case VTK_QUAD:
      return PatchShape::Quad;
    case VTK_TETRA:
      return PatchShape::Tetrahedron;
    default:
      return -1;
  }
}

}

void BezierRoots::ReadCells()
{
  const vtkIdType cells = this->Reader.GetNumberOfCells();
  this->Corners = Buffer<vtkIdType>(4 * cells);
  this->Types = Buffer<unsigned char>(cells);
  ForRanges(cells,
    [this](vtkIdType begin, vtkIdType end)
    {
      std::vector<vtkIdType> scratch;
      for (vtkIdType c = begin; c < end; ++c)
      {
        const CellIds cell = this->Reader.GetCell(c, scratch);
        this->Types[c] = static_cast<unsigned char>(this->Reader.GetGridType(c, cell.Size));
        std::copy_n(cell.Ids, std::min<vtkIdType>(cell.Size, 4), this->Corners.data() + 4 * c);
      }
    });
}

/// How many groups of `size` quads from `first` on came from one face: as many as it had sides. The
/// quad at each side has the face's point as its third one, the point of the edge behind its corner
/// as its second one, and the point of the edge before as its last one.
vtkIdType BezierRoots::CountSides(vtkIdType first, vtkIdType size) const
{
  // Each step puts a corner of a quad first in the child there: so it is first in the first cell of
  // that quarter.
  const auto get = [&](vtkIdType side, int corner)
  { return this->Corners[4 * (first + size * side + corner * (size / 4))]; };
  const vtkIdType most = (this->Types.size() - first) / size;
  vtkIdType sides = 1;
  while (sides < most && this->Types[first + size * sides] == VTK_QUAD &&
    get(sides, 2) == get(0, 2) && get(sides - 1, 1) == get(sides, 3))
  {
    if (get(sides, 1) == get(0, 3))
    {
      return sides + 1;
    }
    ++sides;
  }
  return 0;
}

/// Whether all cells of a root are there and of one type.
bool BezierRoots::IsWhole(const Root& root) const
{
  const vtkIdType end = root.First + CountCells(root, 0);
  if (end > this->Types.size())
  {
    return false;
  }
  const unsigned char type = this->Types[root.First];
  return std::all_of(this->Types.data() + root.First, this->Types.data() + end,
    [type](unsigned char t) { return t == type; });
}

/// Solids need a step more than others: who split the mesh has to know that there are some.
bool BezierRoots::HasPatchPoints(const Root& root) const
{
  return !this->ArePatches || root.Steps - root.Levels >= GetShape(root).SampleLevels;
}

/// Finds the control cell that the cells from `first` on came from, or one side of a face that has
/// not four. Returns the number of its cells.
vtkIdType BezierRoots::FindRoot(vtkIdType first, Root& root)
{
  root = { first, FindKind(this->Types[first]), this->Steps, this->Levels };
  if (root.Kind == PatchShape::Quad)
  {
    const vtkIdType size = vtkIdType(1) << (2 * (root.Steps - 1));
    if (this->CountSides(first, size) != 4)
    {
      --root.Steps;
      root.Levels = std::max(0, root.Levels - 1);
    }
  }
  if (root.Kind >= 0 && !this->IsWhole(root))
  {
    root.Kind = -1;
  }
  if (root.Kind >= 0 && !this->HasPatchPoints(root))
  {
    root.Kind = -1;
    this->FirstWithoutPoints = this->FirstWithoutPoints < 0 ? first : this->FirstWithoutPoints;
  }
  return CountCells(root, 0);
}

void BezierRoots::FindRoots()
{
  Turns turns;
  vtkIdType sidesLeft = 0; // of a face that has not four
  for (vtkIdType first = 0; first < this->Types.size();)
  {
    turns.Next();
    Root root;
    if (sidesLeft > 0)
    {
      root = this->Roots.back();
      root.First = first;
      first += CountCells(root, 0);
      --sidesLeft;
    }
    else
    {
      first += this->FindRoot(first, root);
      if (root.Kind == PatchShape::Quad && root.Steps < this->Steps)
      {
        sidesLeft = std::max<vtkIdType>(0, this->CountSides(root.First, CountCells(root, 0)) - 1);
      }
    }
    this->Roots.push_back(root);
    if (root.Kind >= 0)
    {
      this->Lattices.try_emplace({ root.Kind, root.Steps }, GetShape(root), root.Steps);
    }
  }
}

}
