// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SimplexStarts.h
 * Where the entries of each simplex of a list begin in another list. Most lists have simplices of
 * one dimension only: then that is a product, and nothing is stored.
 */
#ifndef SubdivisionObjects_SimplexStarts_h
#define SubdivisionObjects_SimplexStarts_h

#include "Core/Memory/Buffer.h"
#include "Core/Memory/SimplexList.h"

#include <algorithm>
#include <array>

namespace subdivision
{

/// How many simplices of a list have each dimension.
inline std::array<vtkIdType, 4> CountDimensions(const SimplexView& simplices)
{
  constexpr vtkIdType block = 240; // counts fit into a byte, so that compilers make many at once
  std::array<vtkIdType, 4> counts = {};
  const vtkIdType size = simplices.NumberOfSimplices;
  ForEachInTurn((size + block - 1) / block,
    [&](vtkIdType i)
    {
      const unsigned char* begin = simplices.Dimensions + block * i;
      const vtkIdType length = std::min(block, size - block * i);
      for (unsigned char dimension = 0; dimension < counts.size(); ++dimension)
      {
        unsigned char count = 0;
        for (vtkIdType k = 0; k < length; ++k)
        {
          count = static_cast<unsigned char>(count + (begin[k] == dimension ? 1 : 0));
        }
        counts[dimension] += count;
      }
    });
  return counts;
}
inline std::array<vtkIdType, 4> CountDimensions(const SimplexList& simplices)
{
  return CountDimensions(SimplexView(simplices));
}

class SimplexStarts
{
public:
  /// each(dimension): how much belongs to a simplex, at least 1.
  template <typename Each>
  SimplexStarts(const SimplexView& simplices, const Each& each)
    : Size(simplices.NumberOfSimplices)
  {
    const std::array<vtkIdType, 4> counts = CountDimensions(simplices);
    const auto most = std::max_element(counts.begin(), counts.end());
    this->OfEach = each(static_cast<int>(most - counts.begin()));
    if (*most < this->Size)
    {
      this->Firsts = Buffer<vtkIdType>(this->Size + 1);
      ForEach(this->Size, [&](vtkIdType i) { this->Firsts[i] = each(simplices.Dimensions[i]); });
      CountsToOffsets(this->Firsts);
    }
  }
  /// Where a simplex begins; for the number after the last one, the length of the list.
  vtkIdType operator[](vtkIdType simplex) const
  {
    return this->Firsts.empty() ? simplex * this->OfEach : this->Firsts[simplex];
  }
  vtkIdType GetNumberOfSimplices() const { return this->Size; }
  vtkIdType GetLength() const { return (*this)[this->Size]; }
  /// The simplex that a position belongs to.
  vtkIdType Find(vtkIdType place) const
  {
    return this->Firsts.empty()
      ? place / this->OfEach
      : std::upper_bound(this->Firsts.begin(), this->Firsts.end(), place) - this->Firsts.begin() -
        1;
  }

private:
  const vtkIdType Size;
  vtkIdType OfEach = 1; ///< if Firsts is empty
  Buffer<vtkIdType> Firsts;
};

/// Where the corners of each simplex start in the connectivity.
inline SimplexStarts FindCorners(const SimplexView& simplices)
{
  return SimplexStarts(simplices, [](int dimension) { return dimension + 1; });
}

/// Where the children of each simplex start after some steps.
inline SimplexStarts FindChildren(const SimplexList& simplices, int steps)
{
  return SimplexStarts(
    SimplexView(simplices), [steps](int dimension) { return vtkIdType(1) << (dimension * steps); });
}

}

#endif
