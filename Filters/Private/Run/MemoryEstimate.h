// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MemoryEstimate.h
 * The memory that the work of a filter was expected to need, kept for the message that it was not
 * enough. The bodies stand in SizeChecks.cxx, whose checks keep their estimates.
 */
#ifndef SubdivisionObjects_MemoryEstimate_h
#define SubdivisionObjects_MemoryEstimate_h

#include <string>

namespace subdivision
{

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
