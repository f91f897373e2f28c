// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RunOptions.h
 * The options that all filters share, and the functions through which their work reports progress,
 * warnings and errors.
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
  /// Called with the fraction of the work that is done. Returns true if the work must stop.
  std::function<bool(double)> Progress;
  std::function<void(const std::string&)> Warn;
  std::function<void(const std::string&)> Fail;
};

/// The same options for one execution, in which Warn drops a message that it has given before. A
/// run reads the input twice if the stamp turns out to be wrong.
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
