// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Places/PlaceSearch.h"

#include "Core/Memory/Vectors.h"

#include <algorithm>
#include <cmath>

namespace subdivision
{
namespace
{

using namespace vectors;

constexpr double LeastStep = 1e-12; ///< after which the next one is rounding

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

/// The weights that a step changes: of the corners of a simplex, or of both ends along each axis of
/// a quad. The sum of a group of them stays 1.
struct GroupedWeights
{
  GroupedWeights(const std::array<double, 4>& place, bool isQuad, int dimension)
    : Size(isQuad ? 2 : dimension + 1)
    , All(isQuad ? 4 : this->Size)
    , Values(place)
  {
    if (isQuad)
    {
      this->Values = { { 1. - place[0], place[0], 1. - place[1], place[1] } };
    }
  }
  std::array<double, 4> GetPlace() const
  {
    const auto& v = this->Values;
    const auto get = [&v](int end) { return v[end - 1] == 0. ? 1. : v[end]; };
    return this->Size < this->All ? std::array<double, 4>{ { get(1), get(3), 0., 0. } } : v;
  }
  /// The parameter that is weight i; -1: the first one of a group is none.
  int GetParameter(int i) const
  {
    return i % this->Size == 0 ? -1 : i / this->Size + i % this->Size - 1;
  }

  const int Size; ///< of a group
  const int All;  ///< the number of weights
  std::array<double, 4> Values;
};

/// Makes one step of a search, in which weights that would become negative stay 0.
void Advance(PlaceSearch& search, bool isQuad, int dimension, const Slope& slope)
{
  GroupedWeights grouped(search.Place.Weights, isQuad, dimension);
  std::array<double, 4>& weights = grouped.Values;
  FreeDirections free;
  std::array<int, 3> own{};   // the weight of each direction,
  std::array<int, 3> bases{}; // and the one of its group that gives it away
  for (int group = 0; group < grouped.All; group += grouped.Size)
  {
    const auto first = weights.begin() + group;
    const auto base =
      static_cast<int>(std::max_element(first, first + grouped.Size) - weights.begin());
    for (int i = group; i < group + grouped.Size; ++i)
    {
      const int gets = grouped.GetParameter(i);
      const int gives = grouped.GetParameter(base);
      const Vector none{};
      const Vector change = Subtract(gets >= 0 ? slope.Parts[PlaceParts::First + gets] : none,
        gives >= 0 ? slope.Parts[PlaceParts::First + gives] : none);
      if (i != base && (weights[i] > 0. || Dot(change, slope.Rest) < 0.))
      {
        own[free.Size] = i;
        bases[free.Size] = base;
        Vector parameters{};
        for (int p = 0; p < 3; ++p)
        {
          parameters[p] = double(gets == p) - double(gives == p);
        }
        free.Add(change, parameters);
      }
    }
  }
  std::array<double, 3> ofFree{};
  const auto isOutside = [&](int i, double step) { return weights[own[i]] == 0. && step < 0.; };
  const auto remove = [&](int i)
  {
    std::copy(own.begin() + i + 1, own.end(), own.begin() + i);
    std::copy(bases.begin() + i + 1, bases.end(), bases.begin() + i);
  };
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
    step[own[i]] = ofFree[i];
    step[bases[i]] -= ofFree[i];
    length = std::max(length, std::abs(ofFree[i]));
  }
  for (int i = 0; i < grouped.All; ++i)
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
  for (int i = 0; i < grouped.All; ++i)
  {
    weights[i] = i == stops ? 0. : std::max(0., weights[i] + part * step[i]);
  }
  search.Place.Weights = grouped.GetPlace();
  search.Promise = GetPromise(free, ofFree, part, slope.Rest);
  search.IsDone = free.Size == 0 || length * part < LeastStep;
}

/// The second derivatives of half the squared distance, minus the derivatives of a linear value.
Matrix ReadBends(const PlaceValue& parts, const Vector& rest)
{
  const double mixed = Dot(parts[PlaceParts::Mixed], rest);
  return { { { { Dot(parts[PlaceParts::Second], rest), mixed, 0. } },
    { { mixed, Dot(parts[PlaceParts::SecondOfSecond], rest), 0. } }, { { 0., 0., 0. } } } };
}

bool HasNoSecond(const PlaceValue& parts)
{
  const auto isZero = [&parts](int part) { return parts[part] == Vector{}; };
  return isZero(PlaceParts::Second) && isZero(PlaceParts::Mixed) &&
    isZero(PlaceParts::SecondOfSecond);
}

/// Learns the same where it is not known from the slopes at the best place and at one beside it.
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
  const auto learnsAt = [&](const PlaceValue& at)
  { return isSolid || (cells.LacksSecond && HasNoSecond(at)); };
  if (!isFirst)
  {
    if (learnsAt(value))
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
  const Slope slope{ parts, rest, learnsAt(parts) ? search.Bends : ReadBends(parts, rest),
    search.Damping };
  Advance(search, cells.IsQuad(cell), cells.Dimensions[cell], slope);
}

}
