// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Location/BinnedPoints.h"

#include <cmath>
#include <utility>

namespace subdivision
{

/// Chooses bins that are about cubes, with some 4 points each if these lie evenly. A box that is
/// flatter than a bin has one bin in that direction.
void BinnedPoints::ChooseBins(int size)
{
  constexpr double pointsInBin = 4.;
  constexpr double least = 1e-6; // of the longest side: what is thinner has one bin
  double widths[3];
  double longest = 0.;
  for (int c = 0; c < 3; ++c)
  {
    widths[c] = this->Whole.High[c] - this->Whole.Low[c];
    longest = std::max(longest, widths[c]);
    this->Bins[c] = 1;
    this->Scale[c] = 0.;
  }
  bool isThick[3];
  for (int c = 0; c < 3; ++c)
  {
    isThick[c] = widths[c] > least * longest && std::isfinite(longest);
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
  auto get = [&](int i) { return points + 3 * static_cast<vtkIdType>(ids[i]); };
  this->Whole = Box();
  for (int i = 0; i < size; ++i)
  {
    this->Whole.Add(get(i));
  }
  this->ChooseBins(size);
  const int bins = this->Bins[0] * this->Bins[1] * this->Bins[2];
  this->Starts.assign(bins + 1, 0);
  this->Places.resize(size);
  for (int i = 0; i < size; ++i)
  {
    const double* x = get(i);
    int place = 0;
    for (int c = 2; c >= 0; --c)
    {
      place = place * this->Bins[c] + this->GetPlace(c, x[c]);
    }
    this->Places[i] = place;
    ++this->Starts[place];
  }
  int sum = 0;
  for (int& start : this->Starts)
  {
    sum += std::exchange(start, sum);
  }
  this->Ids.resize(size);
  this->Holds.assign(size, Hold::None);
  for (std::vector<double>& coordinates : this->Coordinates)
  {
    coordinates.resize(size);
  }
  for (int i = 0; i < size; ++i)
  {
    const int to = this->Starts[this->Places[i]]++;
    this->Ids[to] = ids[i];
    for (int c = 0; c < 3; ++c)
    {
      this->Coordinates[c][to] = get(i)[c];
    }
  }
  // Each start has become the next one.
  for (int bin = bins; bin > 0; --bin)
  {
    this->Starts[bin] = this->Starts[bin - 1];
  }
  this->Starts[0] = 0;
}

const std::vector<std::pair<int, int>>& BinnedPoints::FindRows(const Box& box)
{
  int first[3];
  int last[3];
  for (int c = 0; c < 3; ++c)
  {
    first[c] = this->GetPlace(c, box.Low[c]);
    last[c] = this->GetPlace(c, box.High[c]);
  }
  this->Rows.clear();
  for (int z = first[2]; z <= last[2]; ++z)
  {
    for (int y = first[1]; y <= last[1]; ++y)
    {
      const int* starts = this->Starts.data() + (z * this->Bins[1] + y) * this->Bins[0];
      if (starts[first[0]] < starts[last[0] + 1])
      {
        this->Rows.emplace_back(starts[first[0]], starts[last[0] + 1]);
      }
    }
  }
  return this->Rows;
}

}
