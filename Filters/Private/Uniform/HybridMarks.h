// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HybridMarks.h
 * Marked vertices, edges and faces of a mesh of cells that are not cut.
 */
#ifndef SubdivisionObjects_HybridMarks_h
#define SubdivisionObjects_HybridMarks_h

#include "Core/Cells/CellComplex.h"
#include "Private/Run/Marks.h"

#include <functional>
#include <string>

class vtkPointSet;

namespace subdivision
{

/// mark(dimension, item, sharpness) is called for each vertex, edge and face that points or a
/// geometry mark; selected cells are not read. Infinite: it stays sharp.
template <typename Id>
void ForHybridMarks(const CellComplex<Id>& complex, vtkPointSet* input, MarkOptions options,
  const std::function<void(const std::string&)>& warn,
  const std::function<void(int, Id, double)>& mark);

}

#endif
