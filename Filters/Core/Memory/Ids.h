// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Ids.h
 * Compiles templates for both types of ids: int, and long long for meshes that are too large for
 * it. A source file ends with these explicit instantiations.
 */
#ifndef SubdivisionObjects_Ids_h
#define SubdivisionObjects_Ids_h

#include "vtkType.h"

#include <limits>

namespace subdivision
{

/// The largest number, of a vertex or of an entry of a table, for which ids of type int are taken.
/// A test build has a small one, so that small meshes are too large for it: ./dev test --narrow.
#ifdef SUBDIVISIONOBJECTS_LARGEST_SMALL_ID
constexpr vtkIdType LargestSmallId = SUBDIVISIONOBJECTS_LARGEST_SMALL_ID;
#else
constexpr vtkIdType LargestSmallId = std::numeric_limits<int>::max();
#endif

}

/// A class template whose only parameter is the type of ids: SUBDIVISION_COMPILE(class Links).
#define SUBDIVISION_COMPILE(Class)                                                                 \
  template Class<int>;                                                                             \
  template Class<long long>

/// The same for a function template that has no overloads: SUBDIVISION_COMPILE_FUNCTION(FixEdges).
#define SUBDIVISION_COMPILE_FUNCTION(Function)                                                     \
  template decltype(Function<int>) Function<int>;                                                  \
  template decltype(Function<long long>) Function<long long>

#endif
