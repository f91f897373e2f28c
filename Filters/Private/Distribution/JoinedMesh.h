// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file JoinedMesh.h
 * Makes one mesh of several that share points, and parts it again: the blocks of a composite data
 * set, or the cells of this rank and their neighbours from other ranks.
 */
#ifndef SubdivisionObjects_JoinedMesh_h
#define SubdivisionObjects_JoinedMesh_h

#include "Private/ArrayNames.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkPointSet;

namespace subdivision
{

/// An empty vtkPolyData or vtkUnstructuredGrid.
vtkSmartPointer<vtkPointSet> MakeMesh(bool isPolyData);

/// A mesh that becomes a part of a joined one.
struct MeshPart
{
  vtkSmartPointer<vtkPointSet> Mesh;
  int Block = NoBlock;
  /// The id of each point and each cell: equal ids of points are one point; -1 is left out.
  std::vector<vtkIdType> Points;
  std::vector<vtkIdType> Cells;
  /// If an earlier filter made the mesh, and this one goes on: the steps since the control mesh.
  int Levels = 0;
  /// The number of the block in the composite data set, also where another partition has it; its
  /// case, and whether it keeps its values where others have other ones (BlockCases.h).
  int Index = 0;
  int Case = 0;
  bool KeepsOwn = false;
  bool KeepsOwnFloats = false; ///< some of these are floating point numbers
  /// If not empty: numbers that tell points of the same id apart.
  std::vector<vtkIdType> Variants{};
};

/// An array of a joined mesh.
struct JoinedArray
{
  std::string Name; ///< in the joined mesh; differs where arrays of another type have the same name
  std::string OriginalName;
  std::vector<bool> OfPart; ///< the parts that have it
};

struct JoinedMesh
{
  vtkSmartPointer<vtkPointSet> Mesh;
  std::vector<vtkIdType> PointIds; ///< of its points, ascending
  std::vector<vtkIdType> CellIds;  ///< of its cells; ascending, in poly data within each kind
  std::vector<std::vector<vtkIdType>> PointPlaces; ///< of each part; -1: left out
  std::vector<std::vector<vtkIdType>> CellPlaces;
  std::vector<JoinedArray> PointArrays;
  std::vector<JoinedArray> CellArrays;
};

/**
 * Joins meshes. Points and cells stand in the order of their ids. A point or cell that several
 * parts have takes coordinates and values from the first of them; see MeshPart::KeepsOwn.
 *
 * Arrays of the same name, type and number of components are one. Points of parts that do not have
 * an array take the mean of the points beside them that have it, two cells far, so that values
 * inside the parts do not change beside their border; all others are 0 or empty. The first part
 * that has an active attribute (scalars, normals, ...) decides which array that is. Ghost types
 * keep only that a cell is hidden. Field data are left out.
 *
 * The result is a vtkPolyData if all parts are, else a vtkUnstructuredGrid; its points are of
 * `pointType`. Point ids of a cell that do not exist become -1, for the reader to complain about.
 * Sorts points and cells; takes 24 bytes for each, besides the mesh.
 */
JoinedMesh Join(
  const std::vector<MeshPart>& parts, int pointType = VTK_DOUBLE, bool keepsOwnFloats = false);

/**
 * Writes into `part` some cells of `whole`, ascending, with the points that they use, in the order
 * of `whole`, all arrays but BlockName, and the green leaves of these cells. `whole` is a
 * vtkUnstructuredGrid or vtkPolyData, and `part` of the same class. `kept`: points that `part` gets
 * although no cell uses them, ascending. Returns the points that `part` has.
 */
std::vector<vtkIdType> TakeCells(vtkPointSet* whole, const std::vector<vtkIdType>& cells,
  const std::vector<vtkIdType>& kept, vtkPointSet* part);

/// The same without cells: coordinates and arrays of these points and cells.
void TakeValues(vtkPointSet* whole, const std::vector<vtkIdType>& points,
  const std::vector<vtkIdType>& cells, vtkPointSet* part);

/// The cells of each block from 0 to `count` - 1, by the array BlockName.
std::vector<std::vector<vtkIdType>> FindCellsOfBlocks(vtkPointSet* whole, int count);

}

#endif
