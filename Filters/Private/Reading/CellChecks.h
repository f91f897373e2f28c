// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellChecks.h
 * Finds out which cells of the input a filter uses, and words the warnings about the others.
 */
#ifndef SubdivisionObjects_CellChecks_h
#define SubdivisionObjects_CellChecks_h

#include "Private/Reading/CellReader.h"

#include "vtkDataSetAttributes.h"

#include <string>
#include <vector>

class vtkPointSet;

namespace subdivision
{

/// The result of CheckCells. The faults are in order of precedence: a cell with several faults has
/// the state of the first one.
enum class CellState : unsigned char
{
  Good,
  Hidden,
  UnsupportedType,
  WrongSize,
  OutOfRange,
  NonFinite,
  Repeated,       ///< passed over
  PartlyRepeated, ///< takes part, without its degenerate pieces
  TouchesItself,  ///< a ring passes a point again, as along the bridge to a hole; nothing is lost
  NumberOfStates
};

constexpr bool TakesPart(CellState state)
{
  return state == CellState::Good || state == CellState::PartlyRepeated ||
    state == CellState::TouchesItself;
}

struct CheckedCells
{
  std::vector<CellState> States;
  /// Whether a cell that takes part is a quad, has a quad as a face, or is a polygon of four or
  /// more points, which may be a quad after repeated points are dropped.
  bool HasQuads = false;
};

/// Whether VTK takes a cell of this ghost type for one that is not there: it is blanked, or finer
/// levels of AMR have its place.
constexpr bool IsHiddenCell(unsigned char type)
{
  return (type & (vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::REFINEDCELL)) != 0;
}

/// Ghost types of the cells, or null.
const unsigned char* GetGhosts(vtkPointSet* input, vtkIdType numberOfCells);

/// Whether there are duplicate cells: the parts of a mesh, which touch, have them around them.
bool HasDuplicates(vtkPointSet* input);

/// The dimension of the simplices that cells of a type become, also of FaceLoops
/// (PolyhedronFaces.h), which VTK does not know; -1 for a type that is not supported.
int GetDimensionOfType(int cellType);

CheckedCells CheckCells(vtkPointSet* input, const CellReader& cells);

/// How many cells have something in common, and the first of them.
struct CellTally
{
  vtkIdType Count = 0;
  vtkIdType First = -1;

  void Add(vtkIdType cell) { this->First = this->Count++ ? this->First : cell; }
  void Add(const CellTally& later)
  {
    this->First = this->Count ? this->First : later.First;
    this->Count += later.Count;
  }
};

/// "3 cells (the first is cell 12, type 24, vtkQuadraticTetra)"
std::string Describe(const CellTally& tally, const CellReader& cells);

/// The warnings, one for each kind of fault.
std::vector<std::string> DescribePassedOver(const CellReader& cells, const CheckedCells& checked);

}

#endif
