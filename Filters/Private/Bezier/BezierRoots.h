// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BezierRoots.h
 * The cells of the control mesh, found again in a mesh that was split uniformly.
 */
#ifndef SubdivisionObjects_BezierRoots_h
#define SubdivisionObjects_BezierRoots_h

#include "Private/Bezier/RootLattice.h"
#include "Private/Reading/CellReader.h"

#include <map>
#include <utility>
#include <vector>

namespace subdivision
{

/// A cell of the control mesh, or one that is written as it is.
struct Root
{
  vtkIdType First; ///< of its cells
  int Kind;        ///< a PatchShape::Kind; -1: it is written as it is
  int Steps;       ///< in which it was split
  int Levels;      ///< how often it may be split
};

class BezierRoots
{
public:
  /// Finds the roots only. `steps`: how often the mesh was split.
  BezierRoots(vtkPointSet* mesh, int steps)
    : BezierRoots(mesh, steps, steps, false)
  {
  }
  /// For patches. `levels`: how often a root may be split; the steps beyond them give the points
  /// that a patch needs, and the cells of a root with too few stay as they are.
  BezierRoots(vtkPointSet* mesh, int steps, int levels)
    : BezierRoots(mesh, steps, levels, true)
  {
  }
  /// The first cell of a root that was split too seldom for a patch; -1 if there is none.
  vtkIdType GetFirstWithoutPoints() const { return this->FirstWithoutPoints; }
  vtkIdType GetNumberOfRoots() const { return static_cast<vtkIdType>(this->Roots.size()); }
  const Root& GetRoot(vtkIdType r) const { return this->Roots[r]; }

  static const PatchShape& GetShape(const Root& root)
  {
    return PatchShape::Get(static_cast<PatchShape::Kind>(root.Kind));
  }
  /// How many cells a part of a root has that was split off at a level.
  static vtkIdType CountCells(const Root& root, int level)
  {
    return root.Kind < 0 ? 1 : vtkIdType(1) << (GetShape(root).Dimension * (root.Steps - level));
  }
  LatticePart GetWhole(const Root& root) const
  {
    return root.Kind < 0 ? LatticePart() : this->GetLattice(root).GetWhole();
  }
  /// A point of the mesh, by its place in the lattice of a root.
  vtkIdType GetPoint(const Root& root, const LatticePoint& point) const
  {
    return this->Corners[4 * root.First + this->GetLattice(root).GetCorner(point)];
  }
  /// Of a root that is written as it is.
  unsigned char GetType(const Root& root) const { return this->Types[root.First]; }
  void GetPoints(const Root& root, std::vector<vtkIdType>& points) const
  {
    std::vector<vtkIdType> scratch;
    const CellIds cell = this->Reader.GetCell(root.First, scratch);
    points.assign(cell.Ids, cell.Ids + cell.Size);
  }

private:
  BezierRoots(vtkPointSet* mesh, int steps, int levels, bool arePatches)
    : Steps(steps)
    , Levels(levels)
    , ArePatches(arePatches)
    , Reader(mesh)
  {
    this->ReadCells();
    this->FindRoots();
  }
  void ReadCells();
  void FindRoots();
  vtkIdType FindRoot(vtkIdType first, Root& root);
  vtkIdType CountSides(vtkIdType first, vtkIdType size) const;
  bool IsWhole(const Root& root) const;
  bool HasPatchPoints(const Root& root) const;
  const RootLattice& GetLattice(const Root& root) const
  {
    return this->Lattices.at({ root.Kind, root.Steps });
  }

  const int Steps;
  const int Levels;
  const bool ArePatches;
  const CellReader Reader;
  /// The points of each cell, up to four; larger cells have none here.
  Buffer<vtkIdType> Corners;
  Buffer<unsigned char> Types;
  std::vector<Root> Roots;
  vtkIdType FirstWithoutPoints = -1;
  std::map<std::pair<int, int>, RootLattice> Lattices; ///< by kind and steps
};

}

#endif
