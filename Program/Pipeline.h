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

/// Cells and points of all blocks.
struct Size
{
  double Cells = 0;
  double Points = 0;
  double Bytes = 0;
  bool HasSolids = false;
};
Size GetSize(vtkDataObject* data);

}

#endif
