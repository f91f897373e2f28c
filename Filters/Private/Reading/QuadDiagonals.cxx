// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Reading/QuadDiagonals.h"

#include "Core/Memory/Sorting.h"

#include <algorithm>
#include <utility>

namespace subdivision
{

TriangleKey MakeTriangleKey(vtkIdType a, vtkIdType b, vtkIdType c)
{
  if (b < a)
  {
    std::swap(a, b);
  }
  if (c < b)
  {
    std::swap(b, c);
  }
  if (b < a)
  {
    std::swap(a, b);
  }
  return { a, b, c };
}

QuadKey MakeQuadKey(const vtkIdType* quad)
{
  QuadKey key{ quad[0], quad[1], quad[2], quad[3] };
  std::sort(key.begin(), key.end());
  return key;
}

void QuadDiagonals::SetTriangles(std::vector<TriangleKey>&& triangles, vtkIdType numberOfPoints)
{
  this->Triangles = std::move(triangles);
  this->First.clear();
  if (this->Triangles.empty())
  {
    return;
  }
  SortDistinct(this->Triangles);
  this->First.assign(static_cast<size_t>(numberOfPoints) + 1, 0);
  for (const TriangleKey& key : InTurn(this->Triangles))
  {
    ++this->First[key[0] + 1];
  }
  for (const vtkIdType point : InTurn(numberOfPoints))
  {
    this->First[point + 1] += this->First[point];
  }
}

QuadDiagonals::Choice QuadDiagonals::Choose(const vtkIdType* quad) const
{
  Choice choice;
  const unsigned found = this->Triangles.empty() ? 0 : this->FindTriangles(quad);
  if (found == 1 || found == 2)
  {
    choice.Diagonal = found == 1 ? 0 : 1;
    return choice;
  }
  const int smallest = static_cast<int>(std::min_element(quad, quad + 4, this->Order) - quad);
  choice.Diagonal = smallest & 1;
  choice.Contested = found == 3;
  return choice;
}

unsigned QuadDiagonals::FindTriangles(const vtkIdType* quad) const
{
  unsigned found = 0;
  for (int left = 0; left < 4; ++left)
  {
    // The triangle without point `left` is cut off by the diagonal that avoids this point.
    const unsigned bit = left & 1 ? 1 : 2;
    if (!(found & bit) &&
      this->HasTriangle(
        MakeTriangleKey(quad[(left + 1) & 3], quad[(left + 2) & 3], quad[(left + 3) & 3])))
    {
      found |= bit;
    }
  }
  return found;
}

bool QuadDiagonals::HasTriangle(const TriangleKey& key) const
{
  const auto begin = this->Triangles.begin() + this->First[key[0]];
  const auto end = this->Triangles.begin() + this->First[key[0] + 1];
  return begin != end && std::binary_search(begin, end, key);
}

}
