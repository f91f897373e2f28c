// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetOctReader.h
 * Reads the points of tetrahedra and octahedra of a tet/oct mesh after a few further steps.
 */
#ifndef SubdivisionObjects_TetOctReader_h
#define SubdivisionObjects_TetOctReader_h

#include "Private/Bounds/PieceLattice.h"
#include "Private/Roots/SplitRoots.h"

#include <array>

namespace subdivision
{

class TetOctReader
{
public:
  /// `fine`: the mesh after so many steps.
  explicit TetOctReader(vtkPointSet* fine, int steps = PieceLattice::Steps)
    : Reader(fine)
    , Size(1 << steps)
    , Tet(CellShape::Tet, SplitOrder::TetOct, steps)
    , Octahedron(CellShape::Octahedron, SplitOrder::TetOct, steps)
  {
  }
  struct Solid
  {
    const RootLattice* Lattice;
    vtkIdType First;               ///< of the cells that the solid was split into
    std::array<FrameNode, 3> Axes; ///< where the axes lead that the octahedron had on its level
  };
  Solid GetTet(vtkIdType first) const { return { &this->Tet, first, {} }; }
  /// `vertices`: in the order of TetOctPieces::Join.
  Solid GetOct(vtkIdType first, const std::array<vtkIdType, 6>& vertices) const;
  vtkIdType GetPoint(const Solid& solid, const FrameNode& place) const;

private:
  const LatticeReader Reader;
  const int Size;
  const RootLattice Tet;
  const RootLattice Octahedron;
};

}

#endif
