// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Control/PlaceSearch.h"

#include <algorithm>
#include <cmath>

namespace subdivision
{
namespace
{

using Vector = std::array<double, 3>;

constexpr double LeastStep = 1e-12; ///< after which the next one is rounding

double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector Subtract(const Vector& a, const Vector& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2] } };
}

/// Goes back half of a step that made the distance larger.
void GoBack(PlaceSearch& search)
{
  double length = 0.;
  for (std::size_t i = 0; i < search.Place.Weights.size(); ++i)
  {
    double& weight = search.Place.Weights[i];
    length = std::max(length, std::abs(weight - search.Best.Weights[i]));
    weight = 0.5 * (weight + search.Best.Weights[i]);
  }
  if (length < LeastStep)
  {
    search.Place = search.Best;
    search.IsDone = true;
  }
}

/// Solves H s = -m for up to three unknowns, by elimination with pivots. Returns false if H is not
/// positive.
bool Solve(int size, double matrix[3][4])
{
  for (int i = 0; i < size; ++i)
  {
    if (!(matrix[i][i] > 0.))
    {
      return false;
    }
    for (int row = 0; row < size; ++row)
    {
      const double factor = row == i ? 0. : matrix[row][i] / matrix[i][i];
      for (int c = i; c < 4; ++c)
      {
        matrix[row][c] -= factor * matrix[i][c];
      }
    }
  }
  return true;
}

/// Directions in which a place may move.
struct FreeDirections
{
  int Size = 0;
  std::array<Vector, 3> Slopes{};                         ///< how the value changes
  std::array<std::array<double, 2>, 3> FirstParameters{}; ///< and how the first two parameters do

  void Add(const Vector& slope, double u, double v)
  {
    this->Slopes[this->Size] = slope;
    this->FirstParameters[this->Size] = { { u, v } };
    ++this->Size;
  }
  void Remove(int i)
  {
    for (; i + 1 < this->Size; ++i)
    {
      this->Slopes[i] = this->Slopes[i + 1];
      this->FirstParameters[i] = this->FirstParameters[i + 1];
    }
    --this->Size;
  }
};

/// Finds the step of Newton's method or, if the distance bends the wrong way, the one that counts
/// the value as linear. Returns false if there is none.
bool SolveForStep(const FreeDirections& free, const PlaceValue& parts, const Vector& rest,
  bool hasSecond, std::array<double, 3>& step)
{
  double matrix[3][4] = {};
  const auto fill = [&](bool bends)
  {
    for (int i = 0; i < free.Size; ++i)
    {
      for (int k = 0; k < free.Size; ++k)
      {
        const std::array<double, 2>& u = free.FirstParameters[i];
        const std::array<double, 2>& v = free.FirstParameters[k];
        matrix[i][k] = Dot(free.Slopes[i], free.Slopes[k]);
        matrix[i][k] += !bends ? 0.
                               : u[0] * v[0] * Dot(parts[PlaceParts::Second], rest) +
            (u[0] * v[1] + u[1] * v[0]) * Dot(parts[PlaceParts::Mixed], rest) +
            u[1] * v[1] * Dot(parts[PlaceParts::SecondOfSecond], rest);
      }
      matrix[i][3] = -Dot(free.Slopes[i], rest);
    }
  };
  fill(hasSecond);
  bool isSolved = Solve(free.Size, matrix);
  if (!isSolved)
  {
    fill(false);
    isSolved = Solve(free.Size, matrix);
  }
  for (int i = 0; i < free.Size && isSolved; ++i)
  {
    step[i] = matrix[i][3] / matrix[i][i];
  }
  return isSolved;
}

/// The same without directions in which the step would leave the cell at once: isOutside(i, step)
/// tells that of direction i, which remove(i) then takes out of what belongs to the directions.
template <typename IsOutside, typename Remove>
bool FindStep(FreeDirections& free, const PlaceValue& parts, const Vector& rest, bool hasSecond,
  std::array<double, 3>& step, const IsOutside& isOutside, const Remove& remove)
{
  while (SolveForStep(free, parts, rest, hasSecond, step))
  {
    int out = 0;
    while (out < free.Size && !isOutside(out, step[out]))
    {
      ++out;
    }
    if (out == free.Size)
    {
      return true;
    }
    free.Remove(out);
    remove(out);
  }
  return false;
}

/// Makes one step of a search in a simplex, in which weights that would become negative stay 0.
void AdvanceInSimplex(
  PlaceSearch& search, int dimension, const PlaceValue& parts, const Vector& rest)
{
  std::array<double, 4>& weights = search.Place.Weights;
  const auto most = std::max_element(weights.begin(), weights.begin() + dimension + 1);
  const int base = static_cast<int>(most - weights.begin());
  // How the value changes with the weight of a corner, which the base gives away.
  const auto getSlope = [&](int corner)
  {
    const Vector none{};
    return Subtract(corner > 0 ? parts[PlaceParts::First + corner - 1] : none,
      base > 0 ? parts[PlaceParts::First + base - 1] : none);
  };
  FreeDirections free;
  std::array<int, 3> corners{};
  for (int i = 0; i <= dimension; ++i)
  {
    const Vector slope = getSlope(i);
    if (i != base && (weights[i] > 0. || Dot(slope, rest) < 0.))
    {
      corners[free.Size] = i;
      // Of the parameters, those of the corners 1 and 2.
      free.Add(slope, double(i == 1) - double(base == 1), double(i == 2) - double(base == 2));
    }
  }
  std::array<double, 3> ofFree{};
  const auto isOutside = [&](int i, double step) { return weights[corners[i]] == 0. && step < 0.; };
  const auto remove = [&](int i)
  { std::copy(corners.begin() + i + 1, corners.end(), corners.begin() + i); };
  if (!FindStep(free, parts, rest, dimension < 3, ofFree, isOutside, remove))
  {
    search.IsDone = true;
    return;
  }
  std::array<double, 4> step{};
  double length = 0.;
  double part = 1.;
  int stops = -1;
  for (int i = 0; i < free.Size; ++i)
  {
    step[corners[i]] = ofFree[i];
    step[base] -= ofFree[i];
    length = std::max(length, std::abs(ofFree[i]));
  }
  for (int i = 0; i <= dimension; ++i)
  {
    if (weights[i] + part * step[i] < 0.)
    {
      part = weights[i] / -step[i];
      stops = i;
    }
  }
  for (int i = 0; i <= dimension; ++i)
  {
    weights[i] = i == stops ? 0. : std::max(0., weights[i] + part * step[i]);
  }
  search.IsDone = free.Size == 0 || length * part < LeastStep;
}

/// The same in a quad: x and y stay from 0 to 1.
void AdvanceInQuad(PlaceSearch& search, const PlaceValue& parts, const Vector& rest)
{
  std::array<double, 4>& at = search.Place.Weights;
  FreeDirections free;
  std::array<int, 2> axes{};
  for (int i = 0; i < 2; ++i)
  {
    const Vector& slope = parts[PlaceParts::First + i];
    const double change = Dot(slope, rest);
    if ((at[i] > 0. || change < 0.) && (at[i] < 1. || change > 0.))
    {
      axes[free.Size] = i;
      free.Add(slope, i == 0 ? 1. : 0., i == 1 ? 1. : 0.);
    }
  }
  std::array<double, 3> step{};
  const auto isOutside = [&](int i, double by)
  { return (at[axes[i]] == 0. && by < 0.) || (at[axes[i]] == 1. && by > 0.); };
  const auto remove = [&](int i) { axes[0] = axes[i == 0 ? 1 : 0]; };
  if (!FindStep(free, parts, rest, true, step, isOutside, remove))
  {
    search.IsDone = true;
    return;
  }
  double part = 1.;
  double length = 0.;
  int stops = -1;
  const auto getEnd = [&](int i) { return step[i] < 0. ? 0. : 1.; };
  for (int i = 0; i < free.Size; ++i)
  {
    const double left = getEnd(i) - at[axes[i]];
    length = std::max(length, std::abs(step[i]));
    if (part * std::abs(step[i]) > std::abs(left))
    {
      part = left / step[i];
      stops = i;
    }
  }
  for (int i = 0; i < free.Size; ++i)
  {
    double& x = at[axes[i]];
    x = i == stops ? getEnd(i) : std::min(1., std::max(0., x + part * step[i]));
  }
  search.IsDone = free.Size == 0 || length * part < LeastStep;
}

}

void AdvanceSearch(
  const SearchedCells& cells, const PlaceValue& value, const Vector& target, PlaceSearch& search)
{
  const vtkIdType cell = search.Place.Cell;
  const Vector rest = Subtract(value[PlaceParts::Value], target);
  search.Place.Distance = std::sqrt(Dot(rest, rest));
  const double rounding = 1e-12 *
    (search.Place.Distance + std::abs(target[0]) + std::abs(target[1]) + std::abs(target[2]));
  if (search.Place.Distance > search.Best.Distance + rounding)
  {
    GoBack(search);
    return;
  }
  search.Best = search.Place;
  cells.IsQuad(cell) ? AdvanceInQuad(search, value, rest)
                     : AdvanceInSimplex(search, cells.Dimensions[cell], value, rest);
}

}
