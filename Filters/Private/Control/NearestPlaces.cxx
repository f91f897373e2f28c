// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Control/NearestPlaces.h"

#include "Core/Memory/Buffer.h"
#include "Core/Memory/UnevenRanges.h"
#include "Private/Control/NearestStarts.h"
#include "Private/Control/PlaceOutput.h"
#include "Private/Control/PlaceSearch.h"

#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace subdivision
{
namespace
{

using Vector = std::array<double, 3>;

constexpr int MostSteps = 40;                ///< of a search in one cell
constexpr int MostRounds = 30;               ///< from cell to cell
constexpr std::size_t PointsAtATime = 16384; ///< bounds the memory of searches

class Finder
{
public:
  Finder(
    const SearchedCells& cells, const std::vector<Vector>& points, const EvaluatePlaces& evaluate)
    : Cells(cells)
    , Points(points)
    , Evaluate(evaluate)
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

  std::vector<NearestPlace> Find(const NearestStarts& starts)
  {
    std::vector<NearestPlace> best(this->Points.size());
    for (std::size_t begin = 0; begin < best.size(); begin += PointsAtATime)
    {
      std::vector<PlaceSearch> searches =
        this->Start(starts, begin, std::min(best.size(), begin + PointsAtATime));
      for (const PlaceSearch& search : searches)
      {
        NearestPlace& place = best[search.Point];
        place.Cell = place.Cell < 0 ? search.Place.Cell : place.Cell;
        place.Distance = std::numeric_limits<double>::infinity();
      }
      for (int round = 0; round < MostRounds && !searches.empty(); ++round)
      {
        this->Run(searches);
        std::vector<PlaceSearch> next;
        for (const PlaceSearch& search : searches)
        {
          NearestPlace& place = best[search.Point];
          const double before = place.Distance;
          if (search.Place.Distance < before)
          {
            place = search.Place;
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
    return best;
  }

private:
  /// The searches for some of the points.
  std::vector<PlaceSearch> Start(
    const NearestStarts& starts, std::size_t begin, std::size_t end) const
  {
    std::vector<std::vector<NearestPlace>> found(end - begin);
    // For a point far away many triangles may be equally near.
    ForUnevenRanges(static_cast<vtkIdType>(found.size()),
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType i = first; i < last; ++i)
        {
          starts.Find(
            this->Points[begin + static_cast<std::size_t>(i)], found[static_cast<std::size_t>(i)]);
        }
      });
    std::vector<PlaceSearch> searches;
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      for (const NearestPlace& place : found[i])
      {
        searches.push_back({ begin + i, place });
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
      const PlaceValues values = this->Evaluate(places);
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

  /// Adds searches in other cells that have all corners with a weight. The nearest place may lie in
  /// a cell that was left before, along the same edge.
  void AddBeside(const PlaceSearch& search, std::vector<PlaceSearch>& searches) const
  {
    const std::array<double, 4> weights = this->WeightCorners(search.Place);
    const vtkIdType* corners = this->GetCorners(search.Place.Cell);
    const int size = this->Cells.CountCorners(search.Place.Cell);
    const auto first =
      std::find_if(weights.begin(), weights.begin() + size, [](double w) { return w > 0.; });
    if (std::count(weights.begin(), weights.begin() + size, 0.) == 0)
    {
      return;
    }
    for (const vtkIdType other : this->AtVertices[corners[first - weights.begin()]])
    {
      const vtkIdType* begin = this->GetCorners(other);
      const vtkIdType* end = begin + this->Cells.CountCorners(other);
      PlaceSearch next{ search.Point, { other, {}, 0. } };
      bool has = other != search.Place.Cell;
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
    double size = 0.; // of the cell
    for (int k = 0; k < 3; ++k)
    {
      const Vector& slope = search.AtBest[PlaceParts::First + k];
      size = std::max(size, std::hypot(slope[0], slope[1], slope[2]));
    }
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
  const std::vector<Vector>& Points;
  const EvaluatePlaces& Evaluate;
  Buffer<vtkIdType> Starts; ///< of the corners of each cell
  Rows<vtkIdType> AtVertices;
};

}

std::vector<NearestPlace> FindNearestPlaces(const SearchedCells& cells, vtkDataSet* fine,
  int levels, const std::vector<Vector>& points, const EvaluatePlaces& evaluate)
{
  return Finder(cells, points, evaluate).Find(NearestStarts(cells, fine, levels));
}

std::string CheckNearestPlaces(const std::vector<NearestPlace>& places, bool hasCells)
{
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (places[i].Cell < 0)
    {
      return "Point " + std::to_string(i) +
        " has no nearest place: " + (hasCells ? "it is not finite." : "the mesh has no cells.");
    }
  }
  return std::string();
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
