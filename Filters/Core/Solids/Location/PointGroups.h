// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PointGroups.h
 * Groups of points that lie close together.
 */
#ifndef SubdivisionObjects_PointGroups_h
#define SubdivisionObjects_PointGroups_h

#include "Core/Memory/Buffer.h"
#include "Core/Solids/Location/Box.h"

#include <vector>

namespace subdivision
{

/// Group g has the points Order[Starts[g] .. Starts[g + 1]). The points after the last group are
/// outside of the box, or not finite.
struct PointGroups
{
  /// Makes groups of at most `most` points; of more where that many are practically equal.
  PointGroups(const double* points, int size, const Box& box, int most);

  int GetNumberOfGroups() const { return static_cast<int>(this->Starts.size()) - 1; }

  Buffer<int> Order;
  std::vector<int> Starts;

private:
  void Split(const double* points, int begin, int end, const Box& box, int most, int depth);
};

}

#endif
