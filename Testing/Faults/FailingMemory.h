// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FailingMemory.h
 * Takes the place of the functions that give memory, and lets one call of the library fail. Calls
 * of VTK and others succeed, and those for less than 256 bytes. Counts what is not given back, and
 * keeps the peak.
 */
#ifndef SubdivisionObjects_FailingMemory_h
#define SubdivisionObjects_FailingMemory_h

namespace failing_memory
{

/// The call after so many others of the library fails, once.
void FailAfter(long calls);
/// None fails any more. Returns whether one has since FailAfter.
bool Stop();
/// The calls of the library between FailAfter and Stop, if none has failed.
long GetNumberOfCalls();

/// The pieces of memory that all code of the process has and has not given back, plus a constant; 0
/// where that is not counted: under sanitizers, which see themselves what is lost.
long CountPieces();

/// From here on the peak of the bytes that all code of the process has is kept.
void StartPeak();
/// How many bytes the peak is above what was there at StartPeak; 0 where pieces are not counted.
long GetPeak();

}

#endif
