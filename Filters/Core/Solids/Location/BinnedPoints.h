// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BinnedPoints.h
 * Points in the bins of a lattice.
 */
#ifndef SubdivisionObjects_BinnedPoints_h
#define SubdivisionObjects_BinnedPoints_h

#include "Core/Memory/Buffer.h"
#include "Core/Solids/Location/Box.h"

#include <array>
#include <utility>
#include <vector>

namespace subdivision
{

/// By which tolerance a tetrahedron is known to hold a point.
enum class Hold : unsigned char
{
  None,
  Loose,
  Tight
};

/// The points of a group, sorted by bins. Those of a row of bins, along x, are consecutive.
class BinnedPoints
{
public:
  void Load(const double* points, const int* ids, int size);
  const Box& GetBox() const { return this->Whole; }

  /// Points of bins that meet the box: those from `first` to before `second` of each row. The box
  /// meets GetBox().
  const std::vector<std::pair<int, int>>& FindRows(const Box& box);

  std::array<std::vector<double>, 3> Coordinates;
  std::vector<int> Ids;
  std::vector<Hold> Holds;

private:
  void ChooseBins(int size);
  int GetPlace(int c, double x) const
  {
    const double place = (x - this->Whole.Low[c]) * this->Scale[c];
    return place > 0. ? static_cast<int>(std::min(place, this->Bins[c] - 1.)) : 0;
  }

  Box Whole;
  int Bins[3] = { 1, 1, 1 };
  double Scale[3] = { 0., 0., 0. };
  std::vector<int> Starts; ///< of bins
  std::vector<int> Places; ///< while points are sorted
  std::vector<std::pair<int, int>> Rows;
};

}

#endif
