// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FailingMemory.h
 * Takes the place of the functions that give memory, and lets one call of the library fail. Calls
 * of VTK and others succeed, and those for less than 256 bytes.
 */
#ifndef SubdivisionObjects_FailingMemory_h
#define SubdivisionObjects_FailingMemory_h

namespace failing_memory
{

/// The call after so many others of the library fails, once.
void FailAfter(long calls);
/// None fails any more. Returns whether one has since FailAfter.
bool Stop();

}

#endif
