// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DeeperCells.h
 * Parts of cells as cells of their own, one step (of sqrt(3) two) deeper.
 */
#ifndef SubdivisionObjects_DeeperCells_h
#define SubdivisionObjects_DeeperCells_h

#include "Private/Bounds/NestedPieces.h"
#include "Private/Bounds/Sectors.h"

#include <functional>
#include <memory>
#include <vector>

namespace subdivision
{

/// Cells, their sectors, and the last of their steps.
struct SteppedPieces
{
  const NestedPieces& Pieces;
  const Sectors& AllSectors;
  Sectors::Step Last;
};

class DeeperCells
{
public:
  /// A child of a cell (PieceLattice::Children).
  struct Part
  {
    vtkIdType Cell;
    int Child;
    bool operator<(const Part& other) const
    {
      return this->Cell < other.Cell || (this->Cell == other.Cell && this->Child < other.Child);
    }
    bool operator==(const Part& other) const
    {
      return this->Cell == other.Cell && this->Child == other.Child;
    }
  };
  /// For each point that is a corner of a cell, a place in the cells before.
  struct Corner
  {
    vtkIdType Cell;
    int Point; ///< of its lattice
  };

  DeeperCells() = default;
  DeeperCells(const DeeperCells&) = delete;
  DeeperCells& operator=(const DeeperCells&) = delete;
  virtual ~DeeperCells() = default;

  virtual SteppedPieces Get() const = 0;
  /// The cells that wanted parts are.
  const std::vector<vtkIdType>& GetWanted() const { return this->Wanted; }
  const std::vector<Corner>& GetCorners() const { return this->Corners; }
  /// Values at the points after step 1 or 2, from values at the points before.
  Buffer<double> Take(int step, const Buffer<double>& values, int components) const;

protected:
  std::vector<vtkIdType> Wanted;
  std::vector<Corner> Corners;
  std::vector<vtkIdType> Old; ///< which point before each one is that was there before step 3
};

/// Makes parts of cells deeper. Returns null after an error, or a stop.
using SplitCells = std::function<std::unique_ptr<DeeperCells>(
  const SteppedPieces& from, const std::vector<DeeperCells::Part>& wanted)>;

}

#endif
