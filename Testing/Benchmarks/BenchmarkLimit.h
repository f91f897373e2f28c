// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchmarkLimit.h
 * What no program can beat: allocating and writing arrays of the size of an output.
 */
#ifndef SubdivisionObjects_BenchmarkLimit_h
#define SubdivisionObjects_BenchmarkLimit_h

#include "BenchmarkMeshes.h"
#include "BenchmarkTools.h"

namespace benchmarks
{

/// Fresh memory in 4 KiB pages, in huge pages, or memory that was written before.
enum class Pages
{
  Small,
  Huge,
  Warm
};

/// Writes arrays of the sizes of `size.Arrays` once.
Produced RunLimit(Stopwatch& watch, const OutputSize& size, Pages pages);

}

#endif
