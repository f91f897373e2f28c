// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GreenLeaves.h
 * The field array from which the cells can be told that red-green refinement split green, and its
 * change where some cells of a mesh, or of several meshes, become another one.
 */
#ifndef SubdivisionObjects_GreenLeaves_h
#define SubdivisionObjects_GreenLeaves_h

#include "vtkType.h"

#include <functional>
#include <utility>
#include <vector>

class vtkDataArray;
class vtkPointSet;

namespace subdivision
{

/// The cell array with the leaf that a green cell is a part of, -1 for others.
constexpr const char* GreenParentName = "GreenParent";
/// The field array with the leaves: four points, and the points on the edges 01, 02, 03, 12, 13,
/// 23; -1 for none.
constexpr const char* LeavesName = "RedGreenLeaves";
constexpr int LeafComponents = 10;

/// The leaves of a mesh. There are none if an array is missing, or has another form.
class GreenLeaves
{
public:
  explicit GreenLeaves(vtkPointSet* mesh);

  bool IsEmpty() const { return !this->Parents; }
  /// The leaf of a cell, -1.
  vtkIdType GetLeaf(vtkIdType cell) const;
  /// A point of a leaf, by the component; -1.
  vtkIdType GetPoint(vtkIdType leaf, int component) const;
  /// How many green cells are parts of a leaf.
  int CountParts(vtkIdType leaf) const;

private:
  vtkDataArray* Parents = nullptr;
  vtkDataArray* Leaves = nullptr;
};

/// A cell of one of several meshes.
using CellOfMesh = std::pair<std::size_t, vtkIdType>;

/**
 * Gives `mesh`, which has the cell arrays of cells of others, the leaves of these. Cell c is
 * `sourceOf(c)`; `placeOf(i, point)`: where a point of mesh i is now, -1 if it is not. The parts of
 * a leaf stand one after another. A leaf without all of its points is left out. Nothing happens if
 * there are no leaves.
 */
void TakeLeaves(const std::vector<vtkPointSet*>& from,
  const std::function<CellOfMesh(vtkIdType)>& sourceOf,
  const std::function<vtkIdType(std::size_t, vtkIdType)>& placeOf, vtkPointSet* mesh);

/// The same for some cells and points of one mesh, ascending.
void TakeLeaves(vtkPointSet* from, const std::vector<vtkIdType>& cells,
  const std::vector<vtkIdType>& points, vtkPointSet* mesh);

}

#endif
