// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RunOptions.h
 * What every filter tells its work: the options that they share, and whom to tell what happens.
 */
#ifndef SubdivisionObjects_RunOptions_h
#define SubdivisionObjects_RunOptions_h

#include "Private/Control/Features.h"

#include <functional>
#include <memory>
#include <set>
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

/// The same options for one run, which says nothing twice: where a stamp turns out to be wrong, the
/// input is read again.
template <typename Options>
Options WarningOnce(const Options& options)
{
  Options once = options;
  once.Warn = [warn = options.Warn, told = std::make_shared<std::set<std::string>>()](
                const std::string& message)
  {
    if (told->insert(message).second)
    {
      warn(message);
    }
  };
  return once;
}

}

#endif
