// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CommandLine.h
 * What the arguments of the program say.
 */
#ifndef SubdivisionObjects_CommandLine_h
#define SubdivisionObjects_CommandLine_h

#include "Options.h"

#include "vtkAlgorithm.h"
#include "vtkSmartPointer.h"

#include <string>
#include <utility>
#include <vector>

namespace subdivide
{

/// A filter whose options are set, all but what waits for files.
struct Stage
{
  const Filter* What;
  vtkSmartPointer<vtkAlgorithm> Algorithm;
  std::vector<std::pair<const Option*, std::string>> Files;
  std::vector<std::pair<const Option*, std::string>> Arrays; ///< may be elsewhere in the input
};

struct Command
{
  bool Help = false;
  bool Version = false;
  bool Info = false;
  bool Quiet = false;
  std::string Input;  ///< empty for a source
  std::string Output; ///< may be empty with Info or Slices, or where a table is made
  std::string Slices; ///< the folder of pictures; may be empty
  bool Dither = false;
  std::vector<Stage> Stages;
  bool NamesFilter = false; ///< else the filter is that by default
};

/// Whether the last filter makes a table, and no mesh. It is printed where there is no output file.
bool MakesTable(const Command& command);

/// Throws UsageError.
Command ReadCommandLine(const std::vector<std::string>& arguments);

}

#endif
