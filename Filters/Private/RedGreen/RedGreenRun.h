// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RedGreenRun.h
 * From input to output in rounds of local refinement: what vtkRedGreenRefinement does.
 */
#ifndef SubdivisionObjects_RedGreenRun_h
#define SubdivisionObjects_RedGreenRun_h

#include "Private/Control/RunOptions.h"
#include "Private/Criteria/RefinementCriteria.h"

class vtkPointSet;
class vtkUnstructuredGrid;

namespace subdivision
{

struct RedGreenOptions : RunOptions
{
  RefinementOptions Criteria;
  bool LimitPlacement = false;
};

/// False: stopped by an error (told to Fail) or by Progress. The output is then to be emptied.
bool RefineRedGreen(
  vtkPointSet* input, const RedGreenOptions& options, vtkUnstructuredGrid* output);

}

#endif
