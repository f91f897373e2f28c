// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SparseIds.h
 * An array of ids most of which are -1. It consists of pages, and a page whose ids are all -1 takes
 * no memory.
 */
#ifndef SubdivisionObjects_SparseIds_h
#define SubdivisionObjects_SparseIds_h

#include "Core/Memory/Buffer.h"

#include <vector>

namespace subdivision
{

/// Ids of the indices 0 to size - 1. This saves memory where the indices with an id lie near each
/// other.
template <typename Id>
class SparseIds
{
public:
  static constexpr vtkIdType PageSize = 4096;

  SparseIds() = default;
  explicit SparseIds(vtkIdType size)
    : Pages((size + PageSize - 1) / PageSize)
    , Size(size)
  {
  }
  vtkIdType size() const { return this->Size; }
  Id operator[](vtkIdType i) const
  {
    const Buffer<Id>& page = this->Pages[i / PageSize];
    return page.empty() ? Id(-1) : page[i % PageSize];
  }
  void Set(vtkIdType i, Id id)
  {
    Buffer<Id>& page = this->Pages[i / PageSize];
    if (page.empty())
    {
      page = Buffer<Id>(PageSize, -1);
    }
    page[i % PageSize] = id;
  }

  /// Page p has the ids from p * PageSize on; it is empty where they are all -1.
  vtkIdType GetNumberOfPages() const { return static_cast<vtkIdType>(this->Pages.size()); }
  const Buffer<Id>& GetPage(vtkIdType p) const { return this->Pages[p]; }
  std::size_t GetMemorySize() const
  {
    std::size_t size = this->Pages.capacity() * sizeof(Buffer<Id>);
    for (const Buffer<Id>& page : this->Pages)
    {
      size += page.GetMemorySize();
    }
    return size;
  }

private:
  std::vector<Buffer<Id>> Pages;
  vtkIdType Size = 0;
};

}

#endif
