// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file UnevenRanges.h
 * A parallel loop over elements some of which take far longer than others (Loops.cxx).
 */
#ifndef SubdivisionObjects_UnevenRanges_h
#define SubdivisionObjects_UnevenRanges_h

#include "Core/Memory/Loops.h"

namespace subdivision
{

/// Calls body(begin, end) for disjoint ranges that cover [0, size), in several threads. Each thread
/// takes a few elements at a time, and all stop after a while, so that this one can act.
void ForUnevenRanges(vtkIdType size, RangeBody body);

/// That while, after which a part of any loop ends. Tests change it.
inline double SecondsOfUnevenRanges = 0.05;

}

#endif
