// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReadableMesh.h
 * The entrance of all filters: makes the vtkUnstructuredGrid or vtkPolyData that CellReader reads
 * out of inputs of other classes and cells of other types. Cells and points keep their ids.
 */
#ifndef SubdivisionObjects_ReadableMesh_h
#define SubdivisionObjects_ReadableMesh_h

#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

class vtkCompositeDataSet;
class vtkDataObject;

class vtkUnstructuredGrid;

namespace subdivision
{

/// How quadratic and other non-linear cells are read.
enum class NonLinearRule
{
  Corners, ///< linear cells at their corners
  Pieces   ///< are left as they are, and CellsToSimplices cuts them
};

/// Gives a composite data set the structure and the field data of another, and of all in it that
/// are no blocks.
void CopyTree(vtkCompositeDataSet* from, vtkCompositeDataSet* to);

/// Makes a vtkMultiBlockDataSet of AMR: a block for each level, named "Level 0" and so on, with the
/// grids of the level in it. Objects of other classes are returned as they are.
vtkSmartPointer<vtkDataObject> MakeTree(vtkDataObject* input);

/// Calls change(mesh) for a mesh, or for all blocks of a composite data set. The result is the
/// input where nothing changes, else a mesh or a composite data set of the same structure. `change`
/// also gets the flat index of the block, 0 for a single mesh.
vtkSmartPointer<vtkDataObject> ChangeMeshes(vtkDataObject* input,
  const std::function<vtkSmartPointer<vtkDataObject>(vtkDataObject*, unsigned int)>& change);

/**
 * Makes a mesh, or the blocks of a composite data set, readable:
 *  - vtkImageData and vtkRectilinearGrid become grids of voxels or pixels, vtkStructuredGrid and
 *    vtkExplicitStructuredGrid of hexahedra or quads; along an axis of one point they are flat.
 *    Where the solids of such a grid are inside out in the mean, because it is left-handed, all
 *    are turned.
 *  - Cells that have a hidden point (vtkGhostType) become hidden cells.
 *  - Polyhedra become the loops of PolyhedronFaces.h. Such a grid is for CellReader only.
 *  - With NonLinearRule::Corners non-linear cells become linear ones. A warning counts them and the
 *    nodes that no cell uses any more.
 * The points and all arrays are shared with the input. Data that need no change, or are of another
 * class, are returned as they are.
 */
vtkSmartPointer<vtkDataObject> MakeReadable(
  vtkDataObject* input, NonLinearRule rule, std::vector<std::string>& warnings);

/// Makes a vtkStructuredGrid, whose points can move, of vtkImageData and vtkRectilinearGrid, also
/// of blocks. Objects of other classes are returned as they are.
vtkSmartPointer<vtkDataObject> MakeMovable(vtkDataObject* input);

/// The unstructured grids of a data object, which is one or has them as blocks.
std::vector<vtkUnstructuredGrid*> ListGrids(vtkDataObject* data);

}

#endif
