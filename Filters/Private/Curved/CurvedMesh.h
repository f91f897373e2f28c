// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CurvedMesh.h
 * Curved cells with their nodes, and the proof that they are valid.
 */
#ifndef SubdivisionObjects_CurvedMesh_h
#define SubdivisionObjects_CurvedMesh_h

#include "Private/Curved/CellJacobian.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <functional>
#include <string>
#include <vector>

class vtkDataArray;

namespace subdivision
{

class Exchange;

struct CurvedMesh
{
  std::vector<const CurvedShape*> Shapes; ///< of each cell
  const vtkIdType* Offsets = nullptr;     ///< where its nodes begin, and one more
  const vtkIdType* Nodes = nullptr;

  vtkIdType GetNumberOfCells() const { return static_cast<vtkIdType>(this->Shapes.size()); }
  const vtkIdType* GetNodes(vtkIdType cell) const { return this->Nodes + this->Offsets[cell]; }
};

/// The proofs of each cell; cells that are no solids are valid, with 1.
struct CurvedProof
{
  std::vector<unsigned char> Valid;
  std::vector<double> Scaled; ///< CellJacobian::Bound

  void Set(vtkIdType cell, const CellJacobian::Bound& bound)
  {
    this->Valid[cell] = bound.IsValid ? 1 : 0;
    this->Scaled[cell] = bound.Scaled;
  }
};

/// The curved cells of a block, or of all.
struct CurvedPart
{
  CurvedMesh Mesh;
  vtkSmartPointer<vtkDataArray> Points;
  unsigned int Block = 0; ///< its number, 0 if there are no blocks
  CurvedProof Proof;
};

/**
 * Proves which solids are valid, and repairs the others: their nodes go back towards the places
 * that they have in the straight cell, by the least step, in 1/32 of the way, after which all cells
 * are valid. Nodes inside of the solids of the mesh go first, and nodes on its boundary and on
 * faces, lines and vertices only where that is not enough. A warning counts the cells and tells the
 * largest move; an error names the first cell that is not valid even where it is straight, which
 * stays as it is. Where nodes move, `Points` is replaced by a copy.
 *
 * All ranks call this together. Nodes at one place are one node, which moves in all parts and on
 * all ranks that have it: so results do not depend on how cells are shared out. Rank 0 tells.
 */
void ProveAndRepair(const std::vector<CurvedPart*>& parts, Exchange& ranks,
  const std::function<void(const std::string&)>& warn,
  const std::function<void(const std::string&)>& fail);

}

#endif
