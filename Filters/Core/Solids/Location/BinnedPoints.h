// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BinnedPoints.h
 * Points in the bins of a lattice.
 */
#ifndef SubdivisionObjects_BinnedPoints_h
#define SubdivisionObjects_BinnedPoints_h

#include "Core/Solids/Location/Box.h"

#include "vtkType.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace subdivision
{

/// Four linear functions of the place. None of them is below 0 where points are looked for.
struct LinearBounds
{
  double AtLow[4];     ///< at the low corner of the box of all points
  double Slopes[3][4]; ///< along each axis
};

/// The points of a group, sorted by bins: this order gives their numbers here. The points of a row
/// of bins, along x, are consecutive.
class BinnedPoints
{
public:
  void Load(const double* points, const int* ids, int size);
  const Box& GetBox() const { return this->Whole; }

  /// Points of bins that meet the box, and in which all bounds may hold: in each row the points
  /// from `first` to before `second`. The box meets GetBox().
  const std::vector<std::pair<int, int>>& FindRows(const Box& box, const LinearBounds& bounds);

  /// Lists the points in the bins that a box meets, without points that were taken out, if they are
  /// at most `most`. Returns how many there are; -1: more. The box meets GetBox().
  int ListFew(const Box& box, int most, int* list) const;

  int GetId(int i) const { return this->Ids[this->Loaded[i]]; }
  double GetCoordinate(int c, int i) const { return this->Coordinates[c][this->Loaded[i]]; }

  /// Takes a point out of Singles: its coordinate is no number any more.
  void Remove(int i) { this->Singles[0][i] = std::numeric_limits<float>::quiet_NaN(); }
  /// Whether Singles can be told from each other. If not they mean nothing.
  bool HasSingles() const
  {
    return this->HalfWidth == 0. || (this->HalfWidth > 1e-300 && this->HalfWidth < 1e300);
  }

  /// How many points are read at a time from Singles, in which that many more numbers follow.
  static constexpr int AtATime = 4;
  /// Coordinates in single precision, from the middle of the box and divided by half its longest
  /// side: from -1 to 1.
  std::array<std::vector<float>, 3> Singles;
  double Middle[3] = { 0., 0., 0. };
  double HalfWidth = 0.;

private:
  void Gather(const double* points, const int* ids, int size);
  void ChooseBins(int size);
  void FindPlaces(int size);
  void Sort(int size);
  int GetPlace(int c, double x) const
  {
    const double place = (x - this->Whole.Low[c]) * this->Scale[c];
    return place > 0. ? static_cast<int>(std::min(place, this->Bins[c] - 1.)) : 0;
  }

  Box Whole;
  int Bins[3] = { 1, 1, 1 };
  double Scale[3] = { 0., 0., 0. };
  const int* Ids = nullptr;                       ///< as they were given
  std::array<std::vector<double>, 3> Coordinates; ///< in the same order
  std::vector<int> Loaded;                        ///< the number of each point in that order
  std::vector<int> Starts;                        ///< of bins
  std::vector<int> Places;                        ///< while points are sorted
  std::vector<std::pair<int, int>> Rows;
};

}

#endif
