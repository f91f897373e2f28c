// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file JoinedArrays.h
 * The point and cell arrays of a joined mesh.
 */
#ifndef SubdivisionObjects_JoinedArrays_h
#define SubdivisionObjects_JoinedArrays_h

#include "Private/Distribution/JoinedMesh.h"

class vtkAbstractArray;
class vtkDataSetAttributes;

namespace subdivision
{

/// Where the points or the cells of each part are in the joined mesh; -1: nowhere.
struct Places
{
  vtkIdType Size = 0;
  std::vector<std::vector<vtkIdType>> OfPart;
};

/// Whether an array has a value for each of `size` points or cells; of ghost types there may be
/// more (GetGhosts).
bool HasValues(vtkAbstractArray* array, vtkIdType size);

bool IsFloating(vtkAbstractArray* array);

/// The array of a part whose values an array of the joined mesh takes; null: none.
vtkAbstractArray* FindArray(
  vtkDataSetAttributes* data, vtkAbstractArray* joined, const JoinedArray& entry);

/// Joins the arrays of points or cells: `association` is vtkDataObject::POINT or CELL, `places` are
/// the places of points or of cells. Values that no part has are 0 or empty. A part that keeps its
/// own values has another array where the first part has other values; with `keepsOwnFloats` not of
/// floating point numbers (OwnValues.h).
std::vector<JoinedArray> JoinArrays(const std::vector<MeshPart>& parts, const Places& places,
  int association, bool keepsOwnFloats, vtkDataSetAttributes* joined);

/// Gives values to points of `mesh` that have none in arrays of floating point numbers, from points
/// beside them: see Join.
void ExtendArrays(vtkPointSet* mesh, const std::vector<JoinedArray>& arrays, const Places& places);

}

#endif
