// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TopologyProbe.h
 * The simplices of a mesh as cells, and what they are: what vtkSimplicialComplexTopology does.
 */
#ifndef SubdivisionObjects_TopologyProbe_h
#define SubdivisionObjects_TopologyProbe_h

#include "Features.h"

#include <functional>
#include <string>

class vtkPointSet;
class vtkUnstructuredGrid;

namespace subdivision
{

struct ProbeOptions
{
  bool SpecialOnly = false;
  bool InterpolateIntegers = false;
  bool GenerateOriginalIds = false;
  int OutputPointsPrecision = 2;
  vtkIdType MaximumNumberOfCells = 500000000;
  FeatureOptions Features;
  /// Called with the part of the work that is done; true: stop.
  std::function<bool(double)> Progress;
  std::function<void(const std::string&)> Warn;
  std::function<void(const std::string&)> Fail;
};

/// False: stopped by an error (told to Fail) or by Progress. The output is then to be emptied.
bool ProbeTopology(vtkPointSet* input, const ProbeOptions& options, vtkUnstructuredGrid* output);

}

#endif
