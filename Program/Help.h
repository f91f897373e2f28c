// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Help.h
 * The texts of --help.
 */
#ifndef SubdivisionObjects_Help_h
#define SubdivisionObjects_Help_h

#include "Options.h"

namespace subdivide
{

/// What the program does, and the list of filters.
void PrintHelp();

/// What a filter does, and its options.
void PrintHelp(const Filter& filter);

}

#endif
