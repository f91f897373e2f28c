// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RedGreenRefinement.h
 * Does the work of vtkRedGreenRefinement: refines an input in rounds and writes the output.
 */
#ifndef SubdivisionObjects_RedGreenRefinement_h
#define SubdivisionObjects_RedGreenRefinement_h

#include "Private/Control/Stamp.h"
#include "Private/Criteria/RefinementCriteria.h"
#include "Private/Curved/CurvedShapes.h"
#include "Private/Run/RunOptions.h"

class vtkPointSet;
class vtkUnstructuredGrid;

namespace subdivision
{

struct RedGreenOptions : RunOptions
{
  RefinementOptions Criteria;
  bool LimitPlacement = false;
  StampScheme Scheme = StampScheme::BoxSpline; ///< of the limit
  bool IsCurved = false;                       ///< cells of this kind and order
  CurvedKind Kind = CurvedKind::Quadratic;
  int CellOrder = 2;
  vtkPointSet* Torn = nullptr; ///< the input before seams of its texture were joined, if they were
};

/// Returns false after an error (passed to Fail) or if Progress asks to stop. The caller then
/// empties the output.
bool RefineRedGreen(
  vtkPointSet* input, const RedGreenOptions& options, vtkUnstructuredGrid* output);

}

#endif
