// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RunOptions.h
 * What every filter tells its work: the options that they share, and whom to tell what happens.
 */
#ifndef SubdivisionObjects_RunOptions_h
#define SubdivisionObjects_RunOptions_h

#include "Features.h"

#include <functional>
#include <string>

namespace subdivision
{

struct RunOptions
{
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

}

#endif
