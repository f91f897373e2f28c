// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TopologyProbe.h
 * The simplices of a mesh as cells, and what they are: what vtkSimplicialComplexTopology does.
 */
#ifndef SubdivisionObjects_TopologyProbe_h
#define SubdivisionObjects_TopologyProbe_h

#include "Private/Control/RunOptions.h"

class vtkPointSet;
class vtkUnstructuredGrid;

namespace subdivision
{

struct ProbeOptions : RunOptions
{
  bool SpecialOnly = false;
};

/// False: stopped by an error (told to Fail) or by Progress. The output is then to be emptied.
bool ProbeTopology(vtkPointSet* input, const ProbeOptions& options, vtkUnstructuredGrid* output);

}

#endif
