// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Places/PlaceSearch.h"

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

using Matrix = std::array<std::array<double, 3>, 3>;

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
  std::array<Vector, 3> Slopes{};     ///< how the value changes
  std::array<Vector, 3> Parameters{}; ///< and how the parameters do

  void Add(const Vector& slope, const Vector& parameters)
  {
    this->Slopes[this->Size] = slope;
    this->Parameters[this->Size] = parameters;
    ++this->Size;
  }
  void Remove(int i)
  {
    for (; i + 1 < this->Size; ++i)
    {
      this->Slopes[i] = this->Slopes[i + 1];
      this->Parameters[i] = this->Parameters[i + 1];
    }
    --this->Size;
  }
};

/// The data that decide a step from the best place of a search.
struct Slope
{
  const PlaceValue& Parts;
  Vector Rest;  ///< from the point to the value
  Matrix Bends; ///< as in the search
  double Damping;
};

/// Finds the step of Newton's method or, if the distance bends the wrong way, the one that counts
/// the value as linear. Returns false if there is none.
bool SolveForStep(const FreeDirections& free, const Slope& slope, std::array<double, 3>& step)
{
  double matrix[3][4] = {};
  const auto fill = [&](bool bends)
  {
    for (int i = 0; i < free.Size; ++i)
    {
      for (int k = 0; k < free.Size; ++k)
      {
        matrix[i][k] = Dot(free.Slopes[i], free.Slopes[k]) * (i == k ? 1. + slope.Damping : 1.);
        for (int p = 0; bends && p < 3; ++p)
        {
          matrix[i][k] += free.Parameters[i][p] * Dot(slope.Bends[p], free.Parameters[k]);
        }
      }
      matrix[i][3] = -Dot(free.Slopes[i], slope.Rest);
    }
  };
  fill(true);
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
/// tells this of direction i, which remove(i) then takes out of the data of directions.
template <typename IsOutside, typename Remove>
bool FindStep(FreeDirections& free, const Slope& slope, std::array<double, 3>& step,
  const IsOutside& isOutside, const Remove& remove)
{
  while (SolveForStep(free, slope, step))
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

/// Half the squared distance's change along a fraction of a step, if the value were linear and the
/// step short.
double GetPromise(
  const FreeDirections& free, const std::array<double, 3>& step, double part, const Vector& rest)
{
  double change = 0.;
  for (int i = 0; i < free.Size; ++i)
  {
    change += step[i] * Dot(free.Slopes[i], rest);
  }
  return -part * change;
}

/// Makes one step of a search in a simplex, in which weights that would become negative stay 0.
void AdvanceInSimplex(PlaceSearch& search, int dimension, const Slope& slope)
{
  const PlaceValue& parts = slope.Parts;
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
    const Vector change = getSlope(i);
    if (i != base && (weights[i] > 0. || Dot(change, slope.Rest) < 0.))
    {
      corners[free.Size] = i;
      Vector parameters{}; // the weights of all corners but the first
      for (int p = 0; p < 3; ++p)
      {
        parameters[p] = double(i == p + 1) - double(base == p + 1);
      }
      free.Add(change, parameters);
    }
  }
  std::array<double, 3> ofFree{};
  const auto isOutside = [&](int i, double step) { return weights[corners[i]] == 0. && step < 0.; };
  const auto remove = [&](int i)
  { std::copy(corners.begin() + i + 1, corners.end(), corners.begin() + i); };
  if (!FindStep(free, slope, ofFree, isOutside, remove))
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
  if (dimension == 3 && stops >= 0 && !search.MetFaces[stops])
  {
    // Along a face the nearest place may be one that is not even nearer than all around it inside.
    constexpr double mostOfTheWay = 0.9;
    search.MetFaces[stops] = true;
    part *= mostOfTheWay;
    stops = -1;
  }
  for (int i = 0; i <= dimension; ++i)
  {
    weights[i] = i == stops ? 0. : std::max(0., weights[i] + part * step[i]);
  }
  search.Promise = GetPromise(free, ofFree, part, slope.Rest);
  search.IsDone = free.Size == 0 || length * part < LeastStep;
}

/// The same in a quad: x and y stay from 0 to 1.
void AdvanceInQuad(PlaceSearch& search, const Slope& slope)
{
  std::array<double, 4>& at = search.Place.Weights;
  FreeDirections free;
  std::array<int, 2> axes{};
  for (int i = 0; i < 2; ++i)
  {
    const Vector& along = slope.Parts[PlaceParts::First + i];
    const double change = Dot(along, slope.Rest);
    if ((at[i] > 0. || change < 0.) && (at[i] < 1. || change > 0.))
    {
      axes[free.Size] = i;
      free.Add(along, { { i == 0 ? 1. : 0., i == 1 ? 1. : 0., 0. } });
    }
  }
  std::array<double, 3> step{};
  const auto isOutside = [&](int i, double by)
  { return (at[axes[i]] == 0. && by < 0.) || (at[axes[i]] == 1. && by > 0.); };
  const auto remove = [&](int i) { axes[0] = axes[i == 0 ? 1 : 0]; };
  if (!FindStep(free, slope, step, isOutside, remove))
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
  search.Promise = GetPromise(free, step, part, slope.Rest);
  search.IsDone = free.Size == 0 || length * part < LeastStep;
}

/// The second derivatives of half the squared distance, minus the derivatives of a linear value.
Matrix ReadBends(const PlaceValue& parts, const Vector& rest)
{
  const double mixed = Dot(parts[PlaceParts::Mixed], rest);
  return { { { { Dot(parts[PlaceParts::Second], rest), mixed, 0. } },
    { { mixed, Dot(parts[PlaceParts::SecondOfSecond], rest), 0. } }, { { 0., 0., 0. } } } };
}

/// Learns the same in a solid from the slopes at the best place and at one beside it.
void LearnBends(PlaceSearch& search, const PlaceValue& value, const Vector& rest)
{
  constexpr double least = 1e-8; // the sine of an angle beyond which rounding is divided by little
  Vector step{};
  Vector unknown{}; // how the slope changes otherwise than was known
  for (int p = 0; p < 3; ++p)
  {
    step[p] = search.Place.Weights[p + 1] - search.Best.Weights[p + 1];
    const int part = PlaceParts::First + p;
    unknown[p] = Dot(Subtract(value[part], search.AtBest[part]), rest);
  }
  for (int p = 0; p < 3; ++p)
  {
    unknown[p] -= Dot(search.Bends[p], step);
  }
  const double along = Dot(unknown, step);
  if (std::abs(along) > least * std::sqrt(Dot(unknown, unknown) * Dot(step, step)))
  {
    for (int p = 0; p < 3; ++p)
    {
      for (int q = 0; q < 3; ++q)
      {
        search.Bends[p][q] += unknown[p] * unknown[q] / along;
      }
    }
  }
}

/// Damps further steps, by the fraction of its promise that the last one kept.
void SetDamping(PlaceSearch& search, bool isWorse)
{
  // A step of Newton's method does half where the distance is as its derivatives tell.
  constexpr double little = 0.1;
  constexpr double much = 0.3;
  constexpr double first = 1.;
  if (isWorse)
  {
    if (search.Damping == 0.)
    {
      search.Damping = std::min(first, search.LeastDamping * search.Growth);
      search.LeastDamping *= 0.01;
    }
    else
    {
      search.Damping *= search.Growth;
    }
    search.Growth *= 2.;
    return;
  }
  search.Growth = 2.;
  const double done = 0.5 * (search.Best.Distance - search.Place.Distance) *
    (search.Best.Distance + search.Place.Distance);
  if (done < little * search.Promise)
  {
    search.Damping = std::max(first, 2. * search.Damping);
  }
  else if (done > much * search.Promise)
  {
    search.Damping = search.Damping < search.LeastDamping ? 0. : 0.25 * search.Damping;
  }
}

}

void AdvanceSearch(
  const SearchedCells& cells, const PlaceValue& value, const Vector& target, PlaceSearch& search)
{
  const vtkIdType cell = search.Place.Cell;
  const bool isSolid = cells.Dimensions[cell] == 3;
  Vector rest = Subtract(value[PlaceParts::Value], target);
  search.Place.Distance = std::sqrt(Dot(rest, rest));
  const double rounding = 1e-12 *
    (search.Place.Distance + std::abs(target[0]) + std::abs(target[1]) + std::abs(target[2]));
  const bool isFirst = search.Best.Cell < 0;
  const bool isWorse = search.Place.Distance > search.Best.Distance + rounding;
  if (!isFirst)
  {
    if (isSolid)
    {
      LearnBends(search, value, rest);
    }
    SetDamping(search, isWorse);
  }
  if (isWorse)
  {
    search.Place = search.Best;
    rest = Subtract(search.AtBest[PlaceParts::Value], target);
  }
  else
  {
    search.Best = search.Place;
    search.AtBest = value;
  }
  const PlaceValue& parts = search.AtBest;
  const Slope slope{ parts, rest, isSolid ? search.Bends : ReadBends(parts, rest), search.Damping };
  cells.IsQuad(cell) ? AdvanceInQuad(search, slope)
                     : AdvanceInSimplex(search, cells.Dimensions[cell], slope);
}

}
