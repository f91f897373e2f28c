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
  const bool found[2] = { this->CountTriangles(quad, 0) > 0, this->CountTriangles(quad, 1) > 0 };
  choice.Contested = found[0] && found[1];
  choice.Diagonal = found[0] == found[1] ? this->FindSmallest(quad) : found[0] ? 0 : 1;
  return choice;
}

int QuadDiagonals::FindCut(const vtkIdType* quad) const
{
  const bool found[2] = { this->CountTriangles(quad, 0) == 2, this->CountTriangles(quad, 1) == 2 };
  return !found[0] && !found[1] ? -1
    : found[0] == found[1]      ? this->FindSmallest(quad)
    : found[0]                  ? 0
                                : 1;
}

int QuadDiagonals::FindSmallest(const vtkIdType* quad) const
{
  return static_cast<int>(std::min_element(quad, quad + 4, this->Order) - quad) & 1;
}

int QuadDiagonals::CountTriangles(const vtkIdType* quad, int diagonal) const
{
  if (this->Triangles.empty())
  {
    return 0;
  }
  const auto count = [&](int third)
  {
    return this->HasTriangle(MakeTriangleKey(quad[diagonal], quad[diagonal + 2], quad[third])) ? 1
                                                                                               : 0;
  };
  return count(diagonal + 1) + count((diagonal + 3) % 4);
}

bool QuadDiagonals::HasTriangle(const TriangleKey& key) const
{
  const auto begin = this->Triangles.begin() + this->First[key[0]];
  const auto end = this->Triangles.begin() + this->First[key[0] + 1];
  return begin != end && std::binary_search(begin, end, key);
}

}
