// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SizeChecks.h
 * Estimates how large an output will be, before memory is taken for it.
 */
#ifndef SubdivisionObjects_SizeChecks_h
#define SubdivisionObjects_SizeChecks_h

#include "Core/Solids/BoxSpline/RefinedCells.h"

#include <string>
#include <vector>

class vtkDataSetAttributes;

namespace subdivision
{

/// An error message if the children of `simplices` after `levels` steps are more than `maximum`.
std::string CheckNumberOfCells(const SimplexList& simplices, int levels, vtkIdType maximum);

/// The same for cells that are counted already, and the bytes that they take.
std::string CheckNumberOfCells(double cells, double bytes, int levels, vtkIdType maximum);

/// At most so many simplices a level has whose cells these are; `scheme` has to live on.
LevelCounts CountSimplices(const SimplexList& cells, const SchemeTraits& scheme);

/// Whether ids inside the program may need more than 32 bits in so many steps.
bool NeedsLargeIds(const SimplexList& control, int levels, const SchemeTraits& scheme);

/// The bytes that estimates add for lists, which begin and end with pages of 2 MB.
constexpr double BytesOfPages = 16e6;

struct SizeEstimate
{
  LevelCounts Control; ///< simplices of the current level
  int Levels = 0;
  std::vector<CellRun> Runs; ///< cells of the current level
  double BytesPerPoint = 0;
  double BytesPerCell = 0; ///< of cell data
  double BytesPerId = 4;
  bool Projects = false;        ///< with limit rows of the last level
  int Frames = 0;               ///< arrays of normals and tangents, with rows beside the limit rows
  bool ProjectsByRings = false; ///< or with limits that the level before tells
  bool KeepsRows = false;       ///< for the next execution: steps, and rows of limits
};

/// An error message if the peak, the output and the memory of the last step, does not fit.
std::string CheckMemory(const SizeEstimate& estimate);

std::string CheckMemory(double cells, double points, double bytes, int levels);

/// The free memory in bytes, or the share of it that this process may take; infinite where the
/// system does not tell.
double GetAvailableMemory();

/// As long as it lives, `sharers` processes share the free memory in equal parts.
class MemoryShare
{
public:
  explicit MemoryShare(int sharers);
  ~MemoryShare();
  MemoryShare(const MemoryShare&) = delete;
  MemoryShare& operator=(const MemoryShare&) = delete;

private:
  int Before;
};

double GetBytesPerTuple(vtkDataSetAttributes* data);

// The memory that the work of a filter was expected to need, kept for the message that it was not
// enough. The checks above keep their estimates.

/// "12.3 GB": three digits, and the unit that fits.
std::string Bytes(double bytes);

/// Keeps the bytes that the work of this thread needs by an estimate.
void KeepEstimate(double bytes);

/// Before a new piece of work.
void ForgetEstimate();

/// One sentence: the estimate, if there was one, and the bytes that are available.
std::string TellEstimate();

}

#endif
