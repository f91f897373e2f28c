// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LatticeNames.h
 * The vertices that divide the edges of a simplex in four, as LocalLimit is asked for them.
 */
#ifndef SubdivisionObjects_LatticeNames_h
#define SubdivisionObjects_LatticeNames_h

#include "Core/Memory/PairTable.h"
#include "Core/Solids/Limits/PlacePolynomial.h"

#include <array>
#include <vector>

namespace subdivision
{

/// The numbers of vertices as LocalLimit has them.
template <typename Id>
class VertexNames
{
public:
  explicit VertexNames(Id vertices)
    : First(vertices)
  {
  }
  /// Of equal ends: the vertex itself on the next level.
  Id GetMidpoint(Id a, Id b)
  {
    const Id next = this->First + static_cast<Id>(this->Midpoints.size());
    const Id found = this->Numbers.FindOrAdd(a, b, next);
    if (found == next)
    {
      this->Midpoints.push_back({ { a, b } });
    }
    return found;
  }
  const std::vector<std::array<Id, 2>>& GetMidpoints() const { return this->Midpoints; }

private:
  const Id First;
  PairTable<Id> Numbers;
  std::vector<std::array<Id, 2>> Midpoints;
};

/// The corners of a child (ListChildren), all of the next level.
template <typename Id>
std::array<Id, 4> GetCornersOfChild(
  const std::array<Id, 4>& corners, int dimension, int child, VertexNames<Id>& names)
{
  std::array<Id, 4> ofChild = corners;
  for (int i = 0; i <= dimension; ++i)
  {
    const auto [first, second] = ListChildren(dimension)[child].Corners[i];
    ofChild[i] = names.GetMidpoint(corners[first], corners[second]);
  }
  return ofChild;
}

/// The vertex at a node of the polynomial over a simplex: all belong to the level after the next.
template <typename Id>
Id FindNode(const std::array<Id, 4>& corners, const PlaceNode& node, VertexNames<Id>& names)
{
  const auto findEven = [&](const PlaceNode& point)
  {
    int ends[2] = { -1, -1 };
    for (int i = 0; i < 4; ++i)
    {
      if (point[i] > 0)
      {
        ends[ends[0] < 0 ? 0 : 1] = i;
      }
    }
    return names.GetMidpoint(corners[ends[0]], corners[ends[1] < 0 ? ends[0] : ends[1]]);
  };
  std::array<int, 4> odd{};
  int odds = 0;
  for (int i = 0; i < 4; ++i)
  {
    if (node[i] % 2 != 0)
    {
      odd[odds++] = i;
    }
  }
  if (odds == 0)
  {
    const Id even = findEven(node);
    return names.GetMidpoint(even, even);
  }
  PlaceNode a = node;
  PlaceNode b = node;
  if (odds == 4) // in the middle of the diagonal between the edges 02 and 13
  {
    a = { { 2, 0, 2, 0 } };
    b = { { 0, 2, 0, 2 } };
  }
  else
  {
    ++a[odd[0]];
    --a[odd[1]];
    --b[odd[0]];
    ++b[odd[1]];
  }
  const Id first = findEven(a);
  const Id second = findEven(b);
  return names.GetMidpoint(first, second);
}

}

#endif
