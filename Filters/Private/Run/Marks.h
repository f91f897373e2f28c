// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Marks.h
 * Singular simplices that the user marks otherwise than by flags of cells: by points, by a
 * selection, by a function, or by geometry that lies on the mesh.
 */
#ifndef SubdivisionObjects_Marks_h
#define SubdivisionObjects_Marks_h

#include "Core/Solids/Strata/Singularities.h"
#include "Private/Reading/CellsToSimplices.h"

#include "vtkDataArray.h"
#include "vtkImplicitFunction.h"
#include "vtkPointSet.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace subdivision
{

struct MarkOptions
{
  // The simplices that marked points make singular.
  bool Corners = true;   ///< themselves
  bool Creases = false;  ///< edges between two of them
  bool Surfaces = false; ///< faces that have no other points
  // Who marks; null: nobody.
  vtkSmartPointer<vtkDataArray> Array;           ///< of points: not 0
  vtkSmartPointer<vtkDataArray> SelectedPoints;  ///< not 0
  vtkSmartPointer<vtkDataArray> SelectedCells;   ///< not 0; no solids
  vtkSmartPointer<vtkDataArray> Sharpness;       ///< of points; null: all stay for ever
  vtkSmartPointer<vtkImplicitFunction> Function; ///< of points: not positive
  vtkSmartPointer<vtkPointSet> Geometry;         ///< vertices, lines and polygons
  bool ByIds = false; ///< points of the geometry and the mesh match by global id, or index

  bool FacesStay = false; ///< for ever, whatever their sharpness is
  bool TellsLost = true;  ///< of cells of the geometry that do not lie on the mesh

  bool IsEmpty() const
  {
    return !this->Array && !this->SelectedPoints && !this->SelectedCells && !this->Function &&
      !this->Geometry;
  }
};

/// Singular simplices, and for how many levels each line and triangle is one.
struct SharpTuples
{
  SimplexTuples Tuples;
  /// Of each line and each triangle, by its dimension; empty: all are infinite.
  std::vector<double> Sharpness[3];

  double GetSharpness(int dimension, std::size_t simplex) const
  {
    return this->Sharpness[dimension].empty() ? std::numeric_limits<double>::infinity()
                                              : this->Sharpness[dimension][simplex];
  }
  /// Empties lists of sharpness without a finite one.
  void Simplify();
};

/**
 * The singular simplices that marks make of a mesh, each once, sorted by their points. `cells` are
 * the cells of `input`. Edges and faces of the input's cells count: cuts through cells do not, but
 * for cells that are cut along their nodes. `warn` gets messages on marks without effect.
 */
SharpTuples FindMarkedSimplices(vtkPointSet* input, const SimplicesOfCells& cells,
  const MarkOptions& options, const std::function<void(const std::string&)>& warn);

/// The points of a vertex, edge or triangle, ascending, with -1 in front of them.
using SimplexKey = std::array<vtkIdType, 3>;
inline SimplexKey MakeKey(const vtkIdType* ids, int size)
{
  SimplexKey key = { -1, -1, -1 };
  std::copy(ids, ids + size, key.end() - size);
  std::sort(key.begin(), key.end());
  return key;
}

/// Adds the tuples that `tuples` does not have, in whatever order their points are.
void AddMissing(const SharpTuples& more, SharpTuples& tuples);

/// Sets an array of marks in the output to 0: the stamp has the marks, and the next filter must not
/// read them again.
void ClearMarks(const MarkOptions& options, vtkPointSet* output);

}

#endif
