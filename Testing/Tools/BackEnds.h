// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BackEnds.h
 * The back ends of vtkSMPTools that tests try. A build of VTK has some of them.
 */
#ifndef BackEnds_h
#define BackEnds_h

#if defined(__SANITIZE_THREAD__)
/// TBB and OpenMP are not built with checks of threads, so that these do not see how their threads
/// wait for each other, and take all that they run for races.
constexpr const char* BackEnds[] = { "Sequential", "STDThread" };
#else
constexpr const char* BackEnds[] = { "Sequential", "STDThread", "TBB", "OpenMP" };
#endif

#endif
