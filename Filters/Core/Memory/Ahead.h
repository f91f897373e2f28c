// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Ahead.h
 * Asking for memory before it is read.
 */
#ifndef SubdivisionObjects_Ahead_h
#define SubdivisionObjects_Ahead_h

#include "vtkType.h"

#include <cstdint>

namespace subdivision
{

/// Tells the processor that list[i] is read soon, which may be after the end of the list. Long
/// lists wait at the begin of each page of 4 KiB otherwise. Does nothing where compilers know no
/// way.
template <typename T>
void AskFor([[maybe_unused]] const T* list, [[maybe_unused]] vtkIdType i)
{
#ifdef __GNUC__
  const auto place = reinterpret_cast<std::uintptr_t>(list) +
    static_cast<std::uintptr_t>(i) * sizeof(T); // a pointer may not leave its list
  __builtin_prefetch(reinterpret_cast<const void*>(place));
#endif
}

}

#endif
