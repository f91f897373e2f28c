// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file UniformSubdivision.h
 * From input to output in uniform steps: what vtkMultiDimensionalSubdivision does.
 */
#ifndef SubdivisionObjects_UniformSubdivision_h
#define SubdivisionObjects_UniformSubdivision_h

#include "Features.h"
#include "OperatorCache.h"

#include <functional>
#include <string>

class vtkPointSet;
class vtkUnstructuredGrid;

namespace subdivision
{

struct UniformOptions
{
  int Levels = 1;
  bool InterpolateIntegers = false;
  bool GenerateOriginalIds = false;
  bool GenerateClassification = false;
  int OutputPointsPrecision = 2;
  vtkIdType MaximumNumberOfCells = 500000000;
  bool Use32BitIds = false;
  FeatureOptions Features;
  /// Where operators are kept; null: nowhere.
  OperatorCache* Cache = nullptr;
  /// Called with the part of the work that is done; true: stop.
  std::function<bool(double)> Progress;
  std::function<void(const std::string&)> Warn;
  std::function<void(const std::string&)> Fail;
};

/// False: stopped by an error (told to Fail) or by Progress. The output is then to be emptied.
bool SubdivideUniformly(
  vtkPointSet* input, const UniformOptions& options, vtkUnstructuredGrid* output);

}

#endif
