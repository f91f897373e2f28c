// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Selection.h
 * Some items of a list, which keep their order and get new numbers.
 */
#ifndef SubdivisionObjects_Selection_h
#define SubdivisionObjects_Selection_h

#include "Core/Memory/Buffer.h"

namespace subdivision
{

template <typename Id>
struct Selection
{
  Buffer<Id> New; ///< of each item of the list, -1 for items that are not selected
  Buffer<Id> Old; ///< of each selected item

  Selection() = default;
  /// `flags`: 0 for items that are not selected.
  template <typename Flags>
  explicit Selection(const Flags& flags)
  {
    const auto size = static_cast<vtkIdType>(flags.size());
    Buffer<Id> offsets(size + 1);
    ForEach(size, [&](vtkIdType i) { offsets[i] = flags[i] ? 1 : 0; });
    CountsToOffsets(offsets);
    this->New = Buffer<Id>(size);
    this->Old = Buffer<Id>(offsets[size]);
    ForEach(size,
      [&](vtkIdType i)
      {
        this->New[i] = flags[i] ? offsets[i] : -1;
        if (flags[i])
        {
          this->Old[offsets[i]] = static_cast<Id>(i);
        }
      });
  }

  /// The values of selected items.
  template <typename T>
  Buffer<T> Pick(const Buffer<T>& values) const
  {
    Buffer<T> picked(this->Old.size());
    ForEach(picked.size(), [&](vtkIdType i) { picked[i] = values[this->Old[i]]; });
    return picked;
  }
  /// The same where an item has `size` ids, which get new numbers too.
  Buffer<Id> Pick(const Buffer<Id>& tuples, int size, const Buffer<Id>& numbers) const
  {
    Buffer<Id> picked(size * this->Old.size());
    ForEach(this->Old.size(),
      [&](vtkIdType i)
      {
        for (int k = 0; k < size; ++k)
        {
          picked[size * i + k] = numbers[tuples[size * vtkIdType(this->Old[i]) + k]];
        }
      });
    return picked;
  }
};

}

#endif
