// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Settings.h
 * From the text of an option to the filter.
 */
#ifndef SubdivisionObjects_Settings_h
#define SubdivisionObjects_Settings_h

#include "Options.h"

#include <string>

namespace subdivide
{

/// Sets an option of any kind but Mesh and Table, whose files are read later. Throws UsageError
/// where the text is none of what the option takes, or the filter does not keep the value.
void ApplySetting(vtkAlgorithm* filter, const Option& option, const std::string& text);

/// Whether a switch of this name is on: "on", "1", "true" or "yes", or their opposites. Throws
/// UsageError.
bool IsOn(const std::string& name, const std::string& text);

/// What the option takes, for the help: "0.5", "Blend|Sharp", "FILE".
std::string DescribeValue(const Option& option);

}

#endif
