// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Info.h
 * `--info`: how large an output will be.
 */
#ifndef SubdivisionObjects_Info_h
#define SubdivisionObjects_Info_h

#include "CommandLine.h"
#include "Pipeline.h"

namespace subdivide
{

/// What will come out.
struct Forecast
{
  Size Output;
  double Seconds = 0.;
  bool IsExact = false; ///< it was made, and not foretold from fewer levels
  double Maximum = 0.;  ///< MaximumNumberOfCells, if that would stop the run
};

/**
 * Runs the filters. Where the last one has uniform levels it makes as few of them as tell how cells
 * and points of each dimension grow, at least two unless they are too large or not allowed. Throws
 * Failure.
 */
Forecast Foretell(const Command& command);

/// Prints what would come out: counts, memory and time.
void PrintInfo(const Command& command);

}

#endif
