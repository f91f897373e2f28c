// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HybridOutput.h
 * Writes the cells of an output whose cells keep their types.
 */
#ifndef SubdivisionObjects_HybridOutput_h
#define SubdivisionObjects_HybridOutput_h

#include "Core/Cells/CellComplex.h"
#include "Core/Memory/Coordinates.h"

#include "vtkCellArray.h"
#include "vtkIdTypeArray.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <functional>
#include <vector>

namespace subdivision
{

template <typename Id>
struct HybridOutput
{
  vtkSmartPointer<vtkCellArray> Cells;
  vtkSmartPointer<vtkUnsignedCharArray> Types;
  vtkSmartPointer<vtkIdTypeArray> Octahedra; ///< OctahedraName
  Buffer<unsigned char> AreInverted;         ///< empty without signs
  Buffer<Id> First; ///< the first output cell of each cell of the level; one more than these
};

/// The children of the cells of a level or, without `splits`, these cells. An octahedron is four
/// tetrahedra around its shortest diagonal: `points()` gives the output's points, and is called if
/// there are octahedra or signs. `small`: with 32-bit ids where they fit. Reads only what
/// CellComplex::ForgetIncidences leaves, and frees that as soon as the corners are written.
///
/// `signs`: of the volume of the control cell in which each cell lies (FindOrientations); empty, or
/// output cells of other signs are inverted.
template <typename Id>
HybridOutput<Id> WriteHybridCells(CellComplex<Id> complex, bool splits, bool small,
  const std::vector<signed char>& signs, const std::function<Coordinates()>& points);

}

#endif
