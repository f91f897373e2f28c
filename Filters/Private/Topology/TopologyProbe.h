// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TopologyProbe.h
 * Does the work of vtkSimplicialComplexTopology: writes the simplices of a mesh as cells, and facts
 * about them as arrays.
 */
#ifndef SubdivisionObjects_TopologyProbe_h
#define SubdivisionObjects_TopologyProbe_h

#include "Private/Run/RunOptions.h"

class vtkPointSet;
class vtkUnstructuredGrid;

namespace subdivision
{

struct ProbeOptions : RunOptions
{
  bool SpecialOnly = false;
};

/// Returns false after an error (passed to Fail) or if Progress asks to stop. The caller then
/// empties the output.
bool ProbeTopology(vtkPointSet* input, const ProbeOptions& options, vtkUnstructuredGrid* output);

}

#endif
