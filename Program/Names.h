// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Names.h
 * Names of filters, options and entries as people type them.
 */
#ifndef SubdivisionObjects_Names_h
#define SubdivisionObjects_Names_h

#include "Options.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace subdivide
{

/// What was typed makes no sense. The program ends with code 2.
struct UsageError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// Small letters and digits alone: "Catmull-Clark" and "catmullclark" are the same.
std::string Plain(const std::string& name);

/// "; did you mean X?", with the name that is the most alike; empty if none is.
std::string DidYouMean(const std::string& name, const std::vector<std::string>& names);

/// The filter of this name or label, which may be shortened to a beginning that only one has.
const Filter& FindFilter(const std::string& name);

/// The option with this name, short name, name of the property, or a label that no other
/// has; null if there is none.
const Option* FindOption(const Filter& filter, const std::string& name);

/// All names of options of a filter.
std::vector<std::string> GetOptionNames(const Filter& filter);

/// The parts between commas.
std::vector<std::string> SplitList(const std::string& text);

}

#endif
