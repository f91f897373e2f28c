// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SparseIds.h
 * An id for each of a few among many things, which lie near each other: an array in pages, of which
 * those without any id take no memory.
 */
#ifndef SubdivisionObjects_SparseIds_h
#define SubdivisionObjects_SparseIds_h

#include "Core/Memory/Buffer.h"

#include <vector>

namespace subdivision
{

/// An id for each of many, -1 for most of them: room is taken page by page, where there are others.
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
