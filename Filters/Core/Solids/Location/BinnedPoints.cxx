// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Location/BinnedPoints.h"

#include "Core/Memory/Ahead.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace subdivision
{

/// Chooses bins that are about cubes, with some 4 points each if these lie evenly. A box that is
/// flatter than a bin has one bin in that direction.
void BinnedPoints::ChooseBins(int size)
{
  constexpr double pointsInBin = 4.;
  constexpr double least = 1e-6; // of the longest side: a thinner side has one bin
  double widths[3];
  double longest = 0.;
  for (int c = 0; c < 3; ++c)
  {
    widths[c] = this->Whole.High[c] - this->Whole.Low[c];
    longest = std::max(longest, widths[c]);
    this->Bins[c] = 1;
    this->Scale[c] = 0.;
  }
  constexpr double smallest = 1e-300; // sides of bins do not round to 0
  bool isThick[3];
  for (int c = 0; c < 3; ++c)
  {
    isThick[c] = widths[c] > least * longest && longest > smallest && std::isfinite(longest);
  }
  for (bool changed = true; changed;)
  {
    changed = false;
    double product = pointsInBin / size;
    int axes = 0;
    for (int c = 0; c < 3; ++c)
    {
      product *= isThick[c] ? widths[c] / longest : 1.;
      axes += isThick[c];
    }
    const double side = axes > 0 ? longest * std::pow(product, 1. / axes) : 0.;
    for (int c = 0; c < 3; ++c)
    {
      if (isThick[c] && !(widths[c] > side))
      {
        isThick[c] = false;
        changed = true;
      }
    }
    for (int c = 0; c < 3 && !changed; ++c)
    {
      if (isThick[c])
      {
        this->Bins[c] = static_cast<int>(std::min(widths[c] / side, 1. * size)) + 1;
        this->Scale[c] = this->Bins[c] / widths[c];
      }
    }
  }
}

void BinnedPoints::Load(const double* points, const int* ids, int size)
{
  this->Gather(points, ids, size);
  this->ChooseBins(size);
  this->FindPlaces(size);
  this->Sort(size);
}

/// Copies the points next to each other, which are read once in memory that may be far away.
void BinnedPoints::Gather(const double* points, const int* ids, int size)
{
  this->Ids = ids;
  for (std::vector<double>& coordinates : this->Coordinates)
  {
    coordinates.resize(size);
  }
  double* const to[3] = { this->Coordinates[0].data(), this->Coordinates[1].data(),
    this->Coordinates[2].data() };
  Box box;
  constexpr int ahead = 32; // points that are on their way meanwhile
  for (int i = 0; i < size; ++i)
  {
    AskFor(points, 3 * static_cast<vtkIdType>(ids[std::min(i + ahead, size - 1)]));
    const double* x = points + 3 * static_cast<vtkIdType>(ids[i]);
    box.Add(x);
    for (int c = 0; c < 3; ++c)
    {
      to[c][i] = x[c];
    }
  }
  this->Whole = box;
  this->HalfWidth = 0.;
  for (int c = 0; c < 3; ++c) // half of each: the largest numbers have no sum
  {
    this->Middle[c] = 0.5 * box.Low[c] + 0.5 * box.High[c];
    this->HalfWidth = std::max(this->HalfWidth, 0.5 * box.High[c] - 0.5 * box.Low[c]);
  }
}

/// Finds the bin of each point, and counts the points of each bin.
void BinnedPoints::FindPlaces(int size)
{
  this->Places.resize(size);
  int* places = this->Places.data();
  std::fill(places, places + size, 0);
  for (int c = 2; c >= 0; --c)
  {
    const double* coordinates = this->Coordinates[c].data();
    const double low = this->Whole.Low[c];
    const double scale = this->Scale[c];
    const double last = this->Bins[c] - 1.;
    const int bins = this->Bins[c];
    if (bins == 1)
    {
      continue;
    }
    for (int i = 0; i < size; ++i) // GetPlace, of points in the box
    {
      const double place = (coordinates[i] - low) * scale;
      places[i] = places[i] * bins + static_cast<int>(place < last ? place : last);
    }
  }
  this->Starts.assign(
    static_cast<std::size_t>(this->Bins[0]) * this->Bins[1] * this->Bins[2] + 1, 0);
  for (int i = 0; i < size; ++i)
  {
    ++this->Starts[places[i]];
  }
  int sum = 0;
  for (int& start : this->Starts)
  {
    sum += std::exchange(start, sum);
  }
}

void BinnedPoints::Sort(int size)
{
  const bool isScaled = this->HasSingles() && this->HalfWidth > 0.;
  const double scale = isScaled ? 1. / this->HalfWidth : 0.;
  this->Loaded.resize(size);
  for (std::vector<float>& singles : this->Singles)
  {
    singles.assign(size + AtATime, 0.F);
  }
  for (int i = 0; i < size; ++i)
  {
    const int to = this->Starts[this->Places[i]]++;
    this->Loaded[to] = i;
    for (int c = 0; c < 3; ++c)
    {
      this->Singles[c][to] =
        isScaled ? static_cast<float>((this->Coordinates[c][i] - this->Middle[c]) * scale) : 0.F;
    }
  }
  // Each start has become the next one.
  std::copy_backward(this->Starts.begin(), this->Starts.end() - 1, this->Starts.end());
  this->Starts[0] = 0;
}

namespace
{

/// Four bounds in bins, along a row: `Most` is the largest value of each in the row with y = 0 and
/// z = 0, at its begin; the position in the row adds to it.
struct BoundsOfRows
{
  /// How far out of its bin a point may be by rounding, in bins, and more.
  static constexpr double Slack = 1e-6;

  double Most[4];
  double Steps[3][4]; ///< from bin to bin
  // The bound holds from a position of the row on, or up to one: Most times factor plus base.
  double LowFactors[4];
  double LowBases[4];
  double HighFactors[4];
  double HighBases[4];

  /// The first and the last position of the row at `y` and `z`, where bounds may hold.
  std::pair<double, double> Find(int y, int z) const
  {
    double lows[4];
    double highs[4];
    for (int f = 0; f < 4; ++f)
    {
      const double most = this->Most[f] + y * this->Steps[1][f] + z * this->Steps[2][f];
      lows[f] = most * this->LowFactors[f] + this->LowBases[f];
      highs[f] = most * this->HighFactors[f] + this->HighBases[f];
    }
    return { std::max(std::max(lows[0], lows[1]), std::max(lows[2], lows[3])) - Slack,
      std::min(std::min(highs[0], highs[1]), std::min(highs[2], highs[3])) + Slack };
  }
};

BoundsOfRows FindBounds(
  const LinearBounds& bounds, const Box& whole, const int bins[3], const double scale[3])
{
  constexpr double parallel = 1e-9; // changes less than this along a row
  BoundsOfRows made;
  for (int f = 0; f < 4; ++f)
  {
    double most = bounds.AtLow[f];
    for (int c = 0; c < 3; ++c)
    {
      const double slope = bounds.Slopes[c][f];
      const bool isOne = !(scale[c] > 0.);
      const double step = isOne ? 0. : slope / scale[c];
      made.Steps[c][f] = step;
      const double width = slope == 0. ? 0. : whole.High[c] - whole.Low[c]; // that may be infinite
      const double inBin = isOne ? slope * width : step;
      most += c == 0 && !isOne ? 0. : std::max(0., inBin) + BoundsOfRows::Slack * std::abs(inBin);
    }
    const double step = made.Steps[0][f];
    const bool isParallel = std::abs(step) * bins[0] < parallel;
    most += isParallel ? std::abs(step) * bins[0] : 0.;
    made.Most[f] = most;
    const double factor = isParallel ? 0. : -1. / step;
    made.LowFactors[f] = step > 0. ? factor : 0.;
    made.LowBases[f] = !isParallel && step > 0. ? 0. : -1.;
    made.HighFactors[f] = isParallel ? 1e300 : step < 0. ? factor : 0.;
    made.HighBases[f] = !isParallel && step < 0. ? 0. : bins[0];
  }
  return made;
}

}

int BinnedPoints::ListFew(const Box& box, int most, int* list) const
{
  int first[3];
  int last[3];
  for (int c = 0; c < 3; ++c)
  {
    first[c] = this->GetPlace(c, box.Low[c]);
    last[c] = this->GetPlace(c, box.High[c]);
  }
  int found = 0;
  for (int z = first[2]; z <= last[2]; ++z)
  {
    for (int y = first[1]; y <= last[1]; ++y)
    {
      const int* starts = this->Starts.data() + (z * this->Bins[1] + y) * this->Bins[0];
      const int end = starts[last[0] + 1];
      if (found + end - starts[first[0]] > most)
      {
        return -1;
      }
      for (int i = starts[first[0]]; i < end; ++i)
      {
        list[found] = i;
        found += std::isnan(this->Singles[0][i]) ? 0 : 1;
      }
    }
  }
  return found;
}

const std::vector<std::pair<int, int>>& BinnedPoints::FindRows(
  const Box& box, const LinearBounds& bounds)
{
  int first[3];
  int last[3];
  for (int c = 0; c < 3; ++c)
  {
    first[c] = this->GetPlace(c, box.Low[c]);
    last[c] = this->GetPlace(c, box.High[c]);
  }
  const BoundsOfRows inRows = FindBounds(bounds, this->Whole, this->Bins, this->Scale);
  this->Rows.clear();
  for (int z = first[2]; z <= last[2]; ++z)
  {
    for (int y = first[1]; y <= last[1]; ++y)
    {
      const int* starts = this->Starts.data() + (z * this->Bins[1] + y) * this->Bins[0];
      auto [low, high] = inRows.Find(y, z);
      low = std::max<double>(low, first[0]);
      high = std::min<double>(high, last[0] + 1);
      if (low <= high)
      {
        const int begin = starts[std::min(static_cast<int>(low), last[0])];
        const int end = starts[std::min(static_cast<int>(high), last[0]) + 1];
        if (begin < end)
        {
          this->Rows.emplace_back(begin, end);
        }
      }
    }
  }
  return this->Rows;
}

}
