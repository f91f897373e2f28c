// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetOctReader.h
 * Reads the points of tetrahedra and octahedra of a tet/oct mesh after a few further steps.
 */
#ifndef SubdivisionObjects_TetOctReader_h
#define SubdivisionObjects_TetOctReader_h

#include "Private/Bounds/TetOctPieces.h"
#include "Private/Reading/CellReader.h"

#include <array>
#include <map>
#include <vector>

class vtkPointSet;

namespace subdivision
{

class TetOctReader
{
public:
  using Place = TetOctPieces::Place;

  /// `fine`: the mesh after so many steps, TetOctPieces::Steps at most.
  explicit TetOctReader(vtkPointSet* fine, int steps = TetOctPieces::Steps)
    : Cells(fine)
    , Steps(steps)
  {
  }
  /// `first`: the first of the cells that the solid was split into.
  void ReadTet(vtkIdType first);
  /// `vertices`: in the order of TetOctPieces::Join.
  void ReadOct(vtkIdType first, const std::array<vtkIdType, 6>& vertices);
  /// A point of the solid that was read last.
  vtkIdType Get(const Place& place) const { return this->Points.at(place); }

private:
  using Axes = std::array<Place, 3>; ///< where the axes of TetOctPieces lead
  static Place Move(const Place& place, const Axes& axes);
  Axes FindAxes(vtkIdType first, const std::array<vtkIdType, 6>& vertices);
  void Read(vtkIdType first, bool isOct, const Axes& axes);

  const CellReader Cells;
  const int Steps;
  std::vector<vtkIdType> Scratch;
  std::map<Place, vtkIdType> Points;
};

}

#endif
