// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Pipeline.h
 * Reads, filters and writes what a command line asks for.
 */
#ifndef SubdivisionObjects_Pipeline_h
#define SubdivisionObjects_Pipeline_h

#include "CommandLine.h"

namespace subdivide
{

/// Reads the files and connects the filters. Throws Failure.
void Connect(Command& command);

/// Updates all filters and returns the output of the last. Throws Failure.
vtkDataObject* Update(const Command& command);

/// Prints what would come out: counts, memory and time.
void PrintInfo(const Command& command);

/// Cells and points of all blocks.
struct Size
{
  double Cells = 0;
  double Points = 0;
  double Bytes = 0;
  bool HasSolids = false;
};
Size GetSize(vtkDataObject* data);

/**
 * The number that follows from those for 0, 1, ... levels, by the growth of uniform subdivision:
 * a sum of powers of `rates`, of which the first as many as there are numbers are taken.
 */
double Extrapolate(const std::vector<double>& numbers, std::vector<double> rates, int levels);

}

#endif
