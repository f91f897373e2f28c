// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Places/NearestPlaces.h"

#include "Core/Memory/Buffer.h"
#include "Core/Memory/UnevenRanges.h"
#include "Private/Places/LimitPatches.h"
#include "Private/Places/PlaceOutput.h"
#include "Private/Places/PlaceSearch.h"
#include "Private/Places/SolidPieces.h"
#include "Private/Run/RunOptions.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace subdivision
{
namespace
{

using Vector = std::array<double, 3>;

constexpr int MostSteps = 40;                ///< of a search in one cell
constexpr int MostRounds = 30;               ///< from cell to cell
constexpr std::size_t MostSearches = 16384;  ///< in cells for each point, on average
constexpr std::size_t PointsAtATime = 16384; ///< bounds the memory of searches
constexpr double FoundInside = 1e-10;        ///< of the size: a distance that is rounding
constexpr double Beside = 1e-4; ///< of the size: where boundaries do not tell the inside

class Finder
{
public:
  Finder(
    const SearchedCells& cells, const std::vector<Vector>& points, const EvaluatePlaces& evaluate)
    : Cells(cells)
    , Points(points)
    , Evaluate(evaluate)
    , Values(points.size())
    , Starts(cells.GetNumberOfCells() + 1)
  {
    vtkIdType start = 0;
    for (const vtkIdType c : InTurn(cells.GetNumberOfCells()))
    {
      this->Starts[c] = start;
      start += cells.CountCorners(c);
    }
    this->Starts[cells.GetNumberOfCells()] = start;
    Buffer<vtkIdType> owners(start);
    ForEach(cells.GetNumberOfCells(), [&](vtkIdType c)
      { std::fill(owners.begin() + this->Starts[c], owners.begin() + this->Starts[c + 1], c); });
    this->AtVertices = ListByRow<vtkIdType>(
      cells.NumberOfPoints, start, [&](vtkIdType i) { return cells.Connectivity[i]; },
      [&](vtkIdType i) { return owners[i]; });
  }

  std::vector<NearestPlace> Find(const SolidPieces* solids)
  {
    this->Best.resize(this->Points.size());
    LimitPatches patches(this->Cells, this->Evaluate);
    for (std::size_t begin = 0; begin < this->Best.size(); begin += PointsAtATime)
    {
      const std::size_t end = std::min(this->Best.size(), begin + PointsAtATime);
      std::vector<std::size_t> left(end - begin);
      std::iota(left.begin(), left.end(), begin);
      if (solids) // a point inside of a solid is its own place
      {
        this->Improve(this->StartInSolids(*solids, left, patches.GetSize(), false));
        left.erase(std::remove_if(left.begin(), left.end(), [&](std::size_t i)
                     { return this->Best[i].Distance <= FoundInside * patches.GetSize(); }),
          left.end());
      }
      std::vector<Vector> points;
      for (const std::size_t i : left)
      {
        points.push_back(this->Points[i]);
      }
      const std::vector<std::vector<NearestPlace>> found = patches.Find(points);
      std::vector<PlaceSearch> searches;
      for (std::size_t i = 0; i < found.size(); ++i)
      {
        for (const NearestPlace& place : found[i])
        {
          this->Points[left[i]] = patches.Approach(points[i]);
          searches.push_back({ left[i], place });
        }
      }
      this->Improve(std::move(searches));
      if (solids)
      {
        this->ImproveInSolids(this->StartInSolids(*solids, left, patches.GetSize(), true));
      }
      for (std::size_t i = 0; i < found.size(); ++i)
      {
        this->Best[left[i]].Distance = Measure(this->Values[left[i]], points[i]);
      }
    }
    return std::move(this->Best);
  }

private:
  static double Measure(const Vector& a, const Vector& b)
  {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  }

  /// Makes the distances of places smaller, from cell to cell.
  void Improve(std::vector<PlaceSearch>&& searches)
  {
    std::size_t left = MostSearches * searches.size();
    for (int round = 0; round < MostRounds && !searches.empty(); ++round)
    {
      if (searches.size() > left)
      {
        return;
      }
      left -= searches.size();
      this->Run(searches);
      std::vector<PlaceSearch> next;
      for (const PlaceSearch& search : searches)
      {
        NearestPlace& place = this->Best[search.Point];
        const double before = place.Distance;
        if (place.Cell < 0 || search.Place.Distance < before)
        {
          place = search.Place;
          this->Values[search.Point] = search.AtBest[PlaceParts::Value];
          this->AddBeside(search, next);
          if (place.Distance < 0.5 * before)
          {
            this->AddInside(search, next);
          }
        }
      }
      searches = std::move(next);
    }
  }

  /// Searches anew, so that places in solids count which are nearer than places before in the same
  /// search, and takes the nearest of all.
  void ImproveInSolids(std::vector<PlaceSearch>&& searches)
  {
    const std::vector<NearestPlace> best = this->Best;
    const std::vector<Vector> values = this->Values;
    for (const PlaceSearch& search : searches)
    {
      this->Best[search.Point] = { -1, {}, std::numeric_limits<double>::infinity() };
    }
    this->Improve(std::move(searches));
    for (const std::size_t i : InTurn(best.size()))
    {
      if (best[i].Distance < this->Best[i].Distance)
      {
        this->Best[i] = best[i];
        this->Values[i] = values[i];
      }
    }
  }

  /// Starts at points that lie in flat pieces of solids; with `isBeside` at points with a place on
  /// the boundary so near that they may lie inside nevertheless.
  std::vector<PlaceSearch> StartInSolids(const SolidPieces& solids,
    const std::vector<std::size_t>& points, double size, bool isBeside) const
  {
    std::vector<NearestPlace> found(points.size());
    ForUnevenRanges(static_cast<vtkIdType>(points.size()),
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType i = first; i < last; ++i)
        {
          const double distance = this->Best[points[i]].Distance;
          if (!isBeside || (distance > FoundInside * size && distance < Beside * size))
          {
            solids.Find(this->Points[points[i]], isBeside, found[i]);
          }
        }
      });
    std::vector<PlaceSearch> searches;
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      if (found[i].Cell >= 0)
      {
        searches.push_back({ points[i], found[i] });
      }
    }
    return searches;
  }

  const vtkIdType* GetCorners(vtkIdType cell) const
  {
    return this->Cells.Connectivity.data() + this->Starts[cell];
  }

  void Run(std::vector<PlaceSearch>& searches) const
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
      const PlaceValues values = this->Evaluate(places, false);
      ForEach(static_cast<vtkIdType>(active.size()),
        [&](vtkIdType i)
        {
          PlaceSearch& search = searches[active[i]];
          AdvanceSearch(this->Cells, values[i], this->Points[search.Point], search);
        });
    }
    for (PlaceSearch& search : searches)
    {
      search.Place = search.IsDone ? search.Place : search.Best;
    }
  }

  /// The weights of the corners of the cell of a place.
  std::array<double, 4> WeightCorners(const NearestPlace& place) const
  {
    if (!this->Cells.IsQuad(place.Cell))
    {
      return place.Weights;
    }
    const double x = place.Weights[0];
    const double y = place.Weights[1];
    return { { (1. - x) * (1. - y), x * (1. - y), x * y, (1. - x) * y } };
  }
  /// Adds a weight of a corner to a place on the border of its cell.
  void AddCorner(int corner, double weight, NearestPlace& place) const
  {
    if (!this->Cells.IsQuad(place.Cell))
    {
      place.Weights[corner] = weight;
      return;
    }
    place.Weights[0] += corner == 1 || corner == 2 ? weight : 0.;
    place.Weights[1] += corner >= 2 ? weight : 0.;
  }

  /// How large a cell is, as far as slopes at a place tell.
  static double MeasureCell(const PlaceSearch& search)
  {
    double size = 0.;
    for (int k = 0; k < 3; ++k)
    {
      size = std::max(size, Measure(search.AtBest[PlaceParts::First + k], Vector{}));
    }
    return size;
  }

  /// Adds searches in other cells that have all corners with a weight. The nearest place may lie in
  /// a cell that was left before, along the same edge, or in a solid on whose boundary this one is.
  void AddBeside(const PlaceSearch& search, std::vector<PlaceSearch>& searches) const
  {
    const std::array<double, 4> weights = this->WeightCorners(search.Place);
    const vtkIdType* corners = this->GetCorners(search.Place.Cell);
    const int size = this->Cells.CountCorners(search.Place.Cell);
    const auto first =
      std::find_if(weights.begin(), weights.begin() + size, [](double w) { return w > 0.; });
    const bool isSolid = this->Cells.Dimensions[search.Place.Cell] == 3;
    const bool mayBeInside = isSolid || search.Place.Distance < 0.5 * MeasureCell(search);
    if (std::count(weights.begin(), weights.begin() + size, 0.) == 0 && (isSolid || !mayBeInside))
    {
      return;
    }
    for (const vtkIdType other : this->AtVertices[corners[first - weights.begin()]])
    {
      const vtkIdType* begin = this->GetCorners(other);
      const vtkIdType* end = begin + this->Cells.CountCorners(other);
      PlaceSearch next{ search.Point, { other, {}, 0. } };
      bool has = other != search.Place.Cell && (mayBeInside || this->Cells.Dimensions[other] < 3);
      for (int i = 0; i < size && has; ++i)
      {
        const vtkIdType* found = std::find(begin, end, corners[i]);
        has = weights[i] == 0. || found != end;
        if (has && found != end)
        {
          this->AddCorner(static_cast<int>(found - begin), weights[i], next.Place);
        }
      }
      if (has)
      {
        searches.push_back(next);
      }
    }
  }

  /// Adds a search in the same solid, farther from its faces, if a point is so near to the place
  /// that it most likely lies inside. Beside an edge at which the boundary is smooth, or an end of
  /// one, the limit nearly stands still in one direction, and a search may end long before the
  /// point.
  void AddInside(const PlaceSearch& search, std::vector<PlaceSearch>& searches) const
  {
    if (this->Cells.Dimensions[search.Place.Cell] < 3)
    {
      return;
    }
    constexpr double near = 1e-4;
    constexpr double rounding = 1e-13;
    const double size = MeasureCell(search);
    if (search.Place.Distance > near * size || search.Place.Distance <= rounding * size)
    {
      return;
    }
    PlaceSearch next{ search.Point, search.Place };
    std::array<double, 4>& weights = next.Place.Weights;
    const auto most = std::max_element(weights.begin(), weights.end());
    const double kept = *most;
    weights.fill((1. - kept) / 3.);
    *most = kept;
    searches.push_back(next);
  }

  const SearchedCells& Cells;
  std::vector<Vector> Points;
  const EvaluatePlaces& Evaluate;
  std::vector<NearestPlace> Best;
  std::vector<Vector> Values; ///< the limits there
  Buffer<vtkIdType> Starts;   ///< of the corners of each cell
  Rows<vtkIdType> AtVertices;
};

}

std::vector<NearestPlace> FindNearestPlaces(const SearchedCells& cells, const SolidPieces* solids,
  const std::vector<Vector>& points, const EvaluatePlaces& evaluate)
{
  return Finder(cells, points, evaluate).Find(solids);
}

bool CheckNearestPlaces(const std::vector<NearestPlace>& places, bool hasCells,
  const RunOptions& options, std::vector<vtkIdType>& missing)
{
  if (!hasCells && !places.empty())
  {
    options.Fail("Places have no nearest place: the mesh has no cells.");
    return false;
  }
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    places[i].Cell < 0 ? missing.push_back(static_cast<vtkIdType>(i)) : void();
  }
  WarnOfMissingPlaces(missing, "coordinates", options);
  return true;
}

void AddNearestArrays(const std::vector<NearestPlace>& places,
  const std::vector<PlaceInCell>& inCells, vtkPolyData* output)
{
  const auto size = static_cast<vtkIdType>(places.size());
  double* distances = AddPlaceArray("Distance", 1, size, output)->GetPointer(0);
  double* parameters = AddPlaceArray("CellParameters", 3, size, output)->GetPointer(0);
  vtkNew<vtkIdTypeArray> cells;
  cells->SetName("CellId");
  for (const vtkIdType i : InTurn(size))
  {
    cells->InsertNextValue(inCells[i].Cell);
    distances[i] = places[i].Distance;
    std::copy_n(inCells[i].Parameters.begin(), 3, parameters + 3 * i);
  }
  output->GetPointData()->AddArray(cells);
}

}
