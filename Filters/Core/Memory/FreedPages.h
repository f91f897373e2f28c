// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FreedPages.h
 * Memory that was freed, but that the C library keeps.
 */
#ifndef SubdivisionObjects_FreedPages_h
#define SubdivisionObjects_FreedPages_h

#include <cstdlib> // for __GLIBC__

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace subdivision
{

/// Gives the system pages back of which nothing is in use any more: after large lists were freed,
/// and before the output takes as much. Does nothing where the C library has no such call.
inline void ReturnFreedPages()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}

#endif
