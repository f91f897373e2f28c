// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FuzzChecks.h
 * What an output must keep of the input: ids that are points, arrays of the right length, finite
 * numbers, and arrays at all.
 */
#ifndef SubdivisionObjects_FuzzChecks_h
#define SubdivisionObjects_FuzzChecks_h

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"

#include <string>

namespace fuzz
{

/// What a filter must not spoil: where the input has it, the output has it too.
struct Soundness
{
  bool HasValidIds = true;    ///< of cells
  bool HasWholeArrays = true; ///< one value for each point or cell
  bool HasFiniteValues =
    true; ///< of points and floating point arrays; so that sums are finite, too
};

/// Up to `limit` a number is finite.
Soundness Examine(vtkDataObject* data, double limit);

/// What is wrong with an output, as one line; null: nothing.
const char* FindFault(vtkDataObject* input, vtkDataObject* output, vtkAlgorithm* filter = nullptr);

/// Name and class of an array of the input's points, or `ofCells` of its cells, that the output of
/// a filter which carries them has not; empty: none. Not asked for where there is no output, and
/// for blocks, which are joined with the arrays that all of them have. Some need not be there:
/// arrays of a wrong length, of which a warning tells; ids and flags of ghosts, which are not those
/// of other points and cells; normals, which do not hold where points move; and arrays without a
/// name.
std::string FindLostArray(vtkDataObject* input, vtkDataObject* output, bool ofCells);

/// Whether this is one data set with points and point arrays that filters in a row do not round:
/// moderate numbers of double precision, and integers, which keep their values.
bool HasDoublesOnly(vtkDataObject* data);

/// Whether two outputs have the same cells, points and arrays bit for bit.
bool AreEqual(vtkDataObject* a, vtkDataObject* b);

}

#endif
