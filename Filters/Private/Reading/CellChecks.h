// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellChecks.h
 * Which cells take part, and what the user is told about the others.
 */
#ifndef SubdivisionObjects_CellChecks_h
#define SubdivisionObjects_CellChecks_h

#include "Private/Reading/CellReader.h"

#include <string>
#include <vector>

class vtkPointSet;

namespace subdivision
{

/// In order of precedence: a cell with several faults is reported for the first.
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
  NumberOfStates
};

constexpr bool TakesPart(CellState state)
{
  return state == CellState::Good || state == CellState::PartlyRepeated;
}

struct CheckedCells
{
  std::vector<CellState> States;
  /// Some cell that takes part is, or has for a face, a quad.
  bool HasQuads = false;
};

/// Ghost types of the cells, or null.
const unsigned char* GetGhosts(vtkPointSet* input, vtkIdType numberOfCells);

CheckedCells CheckCells(vtkPointSet* input, const CellReader& cells);

/// One sentence for each kind of cell that was passed over.
std::vector<std::string> DescribePassedOver(const CellReader& cells, const CheckedCells& checked);

}

#endif
