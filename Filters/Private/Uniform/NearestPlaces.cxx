// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Uniform/NearestPlaces.h"

#include "Core/Memory/Buffer.h"
#include "Core/Memory/UnevenRanges.h"
#include "Core/Solids/Limits/PlacePolynomial.h"
#include "Core/Solids/Location/SimplexTree.h"

#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace subdivision
{
namespace
{

using Vector = std::array<double, 3>;
using Parts = std::array<Vector, PlaceParts::Count>;

constexpr int MostSteps = 20;       ///< of Newton's method
constexpr int MostRounds = 8;       ///< from simplex to simplex
constexpr double LeastStep = 1e-12; ///< after which the next one is rounding

double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector Subtract(const Vector& a, const Vector& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2] } };
}

/// A search in one simplex, for one of the points.
struct Search
{
  std::size_t Point = 0;
  NearestPlace Place;
  bool IsDone = false;
};

/// The place in the middle of a part of a simplex, by the number of the part after two steps.
std::array<double, 4> GetMiddle(int dimension, vtkIdType part)
{
  std::array<double, 4> weights{};
  std::fill_n(weights.begin(), dimension + 1, 1. / (dimension + 1));
  const auto& children = ListChildren(dimension);
  for (int step = 0; dimension > 0 && step < NearestLevels; ++step)
  {
    const auto count = static_cast<vtkIdType>(children.size());
    const std::array<int, 4>& corners = children[static_cast<std::size_t>(part % count)].Corners;
    part /= count;
    std::array<double, 4> of{};
    for (int i = 0; i <= dimension; ++i)
    {
      const int* ends =
        corners[i] > dimension ? GetEdgeEnds(dimension, corners[i] - dimension - 1) : nullptr;
      of[ends ? ends[0] : corners[i]] += 0.5 * weights[i];
      of[ends ? ends[1] : corners[i]] += 0.5 * weights[i];
    }
    weights = of;
  }
  return weights;
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

/// Makes one step of a search.
void Advance(Search& search, int dimension, const Parts& parts, const Vector& target)
{
  std::array<double, 4>& weights = search.Place.Weights;
  const Vector rest = Subtract(parts[PlaceParts::Value], target);
  search.Place.Distance = std::sqrt(Dot(rest, rest));
  const auto most = std::max_element(weights.begin(), weights.begin() + dimension + 1);
  const int base = static_cast<int>(most - weights.begin());
  // How the value changes with the weight of a corner, which the base gives away.
  const auto getSlope = [&](int corner)
  {
    const Vector none{};
    return Subtract(corner > 0 ? parts[PlaceParts::First + corner - 1] : none,
      base > 0 ? parts[PlaceParts::First + base - 1] : none);
  };
  int free[3];
  int size = 0;
  for (int i = 0; i <= dimension; ++i)
  {
    if (i != base && (weights[i] > 0. || Dot(getSlope(i), rest) < 0.))
    {
      free[size++] = i;
    }
  }
  const auto fill = [&](bool bends, double matrix[3][4])
  {
    for (int i = 0; i < size; ++i)
    {
      const Vector slope = getSlope(free[i]);
      for (int k = 0; k < size; ++k)
      {
        matrix[i][k] = Dot(slope, getSlope(free[k]));
        // Of the parameters, those of the corners 1 and 2.
        const double u[2] = { double(free[i] == 1) - double(base == 1),
          double(free[i] == 2) - double(base == 2) };
        const double v[2] = { double(free[k] == 1) - double(base == 1),
          double(free[k] == 2) - double(base == 2) };
        matrix[i][k] += !bends ? 0.
                               : u[0] * v[0] * Dot(parts[PlaceParts::Second], rest) +
            (u[0] * v[1] + u[1] * v[0]) * Dot(parts[PlaceParts::Mixed], rest) +
            u[1] * v[1] * Dot(parts[PlaceParts::SecondOfSecond], rest);
      }
      matrix[i][3] = -Dot(slope, rest);
    }
  };
  double matrix[3][4] = {};
  fill(dimension < 3, matrix);
  if (!Solve(size, matrix))
  {
    fill(false, matrix);
    if (!Solve(size, matrix))
    {
      search.IsDone = true;
      return;
    }
  }
  std::array<double, 4> step{};
  double length = 0.;
  double part = 1.;
  int stops = -1;
  for (int i = 0; i < size; ++i)
  {
    step[free[i]] = matrix[i][3] / matrix[i][i];
    step[base] -= step[free[i]];
    length = std::max(length, std::abs(step[free[i]]));
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
  search.IsDone = size == 0 || length * part < LeastStep;
}

class Finder
{
public:
  Finder(
    const SimplexList& simplices, const std::vector<Vector>& points, const EvaluatePlaces& evaluate)
    : Simplices(simplices)
    , Points(points)
    , Evaluate(evaluate)
    , Starts(simplices.GetNumberOfSimplices() + 1)
  {
    vtkIdType start = 0;
    for (const vtkIdType s : InTurn(simplices.GetNumberOfSimplices()))
    {
      this->Starts[s] = start;
      start += simplices.Dimensions[s] + 1;
    }
    this->Starts[simplices.GetNumberOfSimplices()] = start;
    Buffer<vtkIdType> owners(start);
    ForEach(simplices.GetNumberOfSimplices(), [&](vtkIdType s)
      { std::fill(owners.begin() + this->Starts[s], owners.begin() + this->Starts[s + 1], s); });
    this->AtVertices = ListByRow<vtkIdType>(
      simplices.NumberOfPoints, start, [&](vtkIdType i) { return simplices.Connectivity[i]; },
      [&](vtkIdType i) { return owners[i]; });
  }

  std::vector<NearestPlace> Find(vtkUnstructuredGrid* fine)
  {
    std::vector<NearestPlace> best = this->FindStarts(fine);
    std::vector<std::set<vtkIdType>> seen(best.size());
    std::vector<Search> searches;
    for (std::size_t i = 0; i < best.size(); ++i)
    {
      if (best[i].Simplex >= 0)
      {
        searches.push_back({ i, best[i] });
        seen[i].insert(best[i].Simplex);
        best[i].Distance = std::numeric_limits<double>::infinity();
      }
    }
    for (int round = 0; round < MostRounds && !searches.empty(); ++round)
    {
      this->Run(searches);
      std::vector<Search> next;
      for (const Search& search : searches)
      {
        NearestPlace& place = best[search.Point];
        if (search.Place.Distance < place.Distance)
        {
          place = search.Place;
          this->AddBeside(search, seen[search.Point], next);
        }
      }
      searches = std::move(next);
    }
    return best;
  }

private:
  int GetDimension(vtkIdType simplex) const { return this->Simplices.Dimensions[simplex]; }
  const vtkIdType* GetCorners(vtkIdType simplex) const
  {
    return this->Simplices.Connectivity.data() + this->Starts[simplex];
  }

  /// The places at which searches begin.
  std::vector<NearestPlace> FindStarts(vtkUnstructuredGrid* fine) const
  {
    const vtkIdType cells = fine->GetNumberOfCells();
    Buffer<vtkIdType> firsts(this->Simplices.GetNumberOfSimplices() + 1);
    ForEach(this->Simplices.GetNumberOfSimplices(),
      [&](vtkIdType s) { firsts[s] = vtkIdType(1) << (NearestLevels * this->GetDimension(s)); });
    CountsToOffsets(firsts);
    Buffer<double> points(3 * fine->GetNumberOfPoints());
    ForEachInTurn(
      fine->GetNumberOfPoints(), [&](vtkIdType i) { fine->GetPoint(i, points.data() + 3 * i); });
    std::vector<int> corners[2]; // of tetrahedra, and of all others
    std::vector<vtkIdType> numbers[2];
    vtkNew<vtkIdList> ids;
    ForEachInTurn(cells,
      [&](vtkIdType c)
      {
        fine->GetCellPoints(c, ids);
        const int kind = ids->GetNumberOfIds() == 4 ? 0 : 1;
        for (vtkIdType k = 0; k < (kind == 0 ? 4 : 3); ++k)
        {
          corners[kind].push_back(
            static_cast<int>(ids->GetId(std::min(k, ids->GetNumberOfIds() - 1))));
        }
        numbers[kind].push_back(c);
      });
    Buffer<int> buffers[2];
    SimplexTree trees[2];
    for (int kind = 0; kind < 2; ++kind)
    {
      buffers[kind] = Buffer<int>(static_cast<vtkIdType>(corners[kind].size()));
      std::copy(corners[kind].begin(), corners[kind].end(), buffers[kind].begin());
      if (!corners[kind].empty())
      {
        trees[kind] = SimplexTree(points.data(), kind == 0 ? 4 : 3, buffers[kind]);
      }
    }
    std::vector<NearestPlace> starts(this->Points.size());
    const auto findStart = [&](vtkIdType i)
    {
      const Vector& x = this->Points[i];
      double least = std::numeric_limits<double>::infinity();
      for (int kind = 0; kind < 2; ++kind)
      {
        PlaceInSimplex place;
        double distance2 = 0.;
        if (numbers[kind].empty() || !std::isfinite(x[0] + x[1] + x[2]) ||
          !trees[kind].FindNearest(x.data(), place, distance2) || !(distance2 < least))
        {
          continue;
        }
        least = distance2;
        const vtkIdType cell = numbers[kind][place.Simplex];
        const vtkIdType simplex =
          std::upper_bound(firsts.begin(), firsts.end(), cell) - firsts.begin() - 1;
        starts[i].Simplex = simplex;
        starts[i].Weights = GetMiddle(this->GetDimension(simplex), cell - firsts[simplex]);
      }
    };
    // For a point far away many triangles may be equally near.
    ForUnevenRanges(static_cast<vtkIdType>(starts.size()),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          findStart(i);
        }
      });
    return starts;
  }

  void Run(std::vector<Search>& searches) const
  {
    for (int step = 0; step < MostSteps; ++step)
    {
      std::vector<std::size_t> active;
      std::vector<NearestPlace> places;
      for (std::size_t i = 0; i < searches.size(); ++i)
      {
        if (!searches[i].IsDone)
        {
          active.push_back(i);
          places.push_back(searches[i].Place);
        }
      }
      if (active.empty())
      {
        return;
      }
      const PlaceValues values = this->Evaluate(places);
      ForEach(static_cast<vtkIdType>(active.size()),
        [&](vtkIdType i)
        {
          Search& search = searches[active[i]];
          Advance(search, this->GetDimension(search.Place.Simplex), values[i],
            this->Points[search.Point]);
        });
    }
  }

  /// Adds searches in other simplices that have all corners with a weight.
  void AddBeside(
    const Search& search, std::set<vtkIdType>& seen, std::vector<Search>& searches) const
  {
    const NearestPlace& place = search.Place;
    const vtkIdType* corners = this->GetCorners(place.Simplex);
    const int size = this->GetDimension(place.Simplex) + 1;
    const auto first = std::find_if(
      place.Weights.begin(), place.Weights.begin() + size, [](double w) { return w > 0.; });
    if (std::count(place.Weights.begin(), place.Weights.begin() + size, 0.) == 0)
    {
      return;
    }
    for (const vtkIdType other : this->AtVertices[corners[first - place.Weights.begin()]])
    {
      const vtkIdType* begin = this->GetCorners(other);
      const vtkIdType* end = begin + this->GetDimension(other) + 1;
      Search next{ search.Point, { other, {}, 0. } };
      bool has = true;
      for (int i = 0; i < size && has; ++i)
      {
        const vtkIdType* found = std::find(begin, end, corners[i]);
        has = place.Weights[i] == 0. || found != end;
        if (has && found != end)
        {
          next.Place.Weights[found - begin] = place.Weights[i];
        }
      }
      if (has && seen.insert(other).second)
      {
        searches.push_back(next);
      }
    }
  }

  const SimplexList& Simplices;
  const std::vector<Vector>& Points;
  const EvaluatePlaces& Evaluate;
  Buffer<vtkIdType> Starts; ///< of the corners of each simplex
  Rows<vtkIdType> AtVertices;
};

}

std::vector<NearestPlace> FindNearestPlaces(const SimplexList& simplices, vtkUnstructuredGrid* fine,
  const std::vector<Vector>& points, const EvaluatePlaces& evaluate)
{
  return Finder(simplices, points, evaluate).Find(fine);
}

}
