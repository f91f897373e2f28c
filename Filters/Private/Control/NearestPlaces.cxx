// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Control/NearestPlaces.h"

#include "Core/Memory/Buffer.h"
#include "Core/Memory/UnevenRanges.h"
#include "Core/Solids/Limits/PlacePolynomial.h"
#include "Core/Solids/Location/SimplexTree.h"
#include "Core/Surfaces/Places/QuadParts.h"
#include "Private/Control/PlaceOutput.h"
#include "Private/Control/PlaceSearch.h"

#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
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

constexpr int MostSteps = 40;  ///< of Newton's method, and half steps back
constexpr int MostRounds = 30; ///< from cell to cell

/// A place in a part of a simplex as one of the simplex, by the number of the part after some
/// steps.
std::array<double, 4> LeavePartOfSimplex(
  int dimension, int levels, vtkIdType part, std::array<double, 4> weights)
{
  const auto& children = ListChildren(dimension);
  for (int step = 0; dimension > 0 && step < levels; ++step)
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

/// The same in a quad, whose parts have the numbers of its corners.
std::array<double, 4> LeavePartOfQuad(int levels, vtkIdType part, std::array<double, 2> at)
{
  for (int step = 0; step < levels; ++step)
  {
    at = LeaveCornerOfQuad(static_cast<int>(part % 4), at);
    part /= 4;
  }
  return { { at[0], at[1], 0., 0. } };
}

/// A piece of a cell, or half of one that is a quad.
struct Piece
{
  vtkIdType Number;
  int Half; ///< of a quad: with its second corner, or its fourth one
};

/// Sets where a search begins: near the nearest place of a flat piece, but inside of the piece.
/// `part`: the number of the piece in its cell.
void SetStart(const SearchedCells& cells, vtkIdType part, int levels, int half,
  const double ofPiece[4], NearestPlace& start)
{
  constexpr double inside = 0.1;
  const int dimension = cells.Dimensions[start.Cell];
  if (cells.IsQuad(start.Cell))
  {
    const double both = ofPiece[1] + ofPiece[2];
    std::array<double, 2> at{ { half == 0 ? both : ofPiece[1], half == 0 ? ofPiece[2] : both } };
    for (double& x : at)
    {
      x += inside * (0.5 - x);
    }
    start.Weights = LeavePartOfQuad(levels, part, at);
    return;
  }
  std::array<double, 4> weights{};
  for (int i = 0; i < 4; ++i) // corners that are repeated are the last one
  {
    weights[std::min(i, dimension)] += ofPiece[i];
  }
  for (int i = 0; i <= dimension; ++i)
  {
    weights[i] += inside * (1. / (dimension + 1) - weights[i]);
  }
  start.Weights = LeavePartOfSimplex(dimension, levels, part, weights);
}

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

  std::vector<NearestPlace> Find(vtkDataSet* fine, int levels)
  {
    std::vector<NearestPlace> best = this->FindStarts(fine, levels);
    std::vector<PlaceSearch> searches;
    for (std::size_t i = 0; i < best.size(); ++i)
    {
      if (best[i].Cell >= 0)
      {
        searches.push_back({ i, best[i] });
        best[i].Distance = std::numeric_limits<double>::infinity();
      }
    }
    for (int round = 0; round < MostRounds && !searches.empty(); ++round)
    {
      this->Run(searches);
      std::vector<PlaceSearch> next;
      for (const PlaceSearch& search : searches)
      {
        NearestPlace& place = best[search.Point];
        if (search.Place.Distance < place.Distance)
        {
          place = search.Place;
          this->AddBeside(search, next);
        }
      }
      searches = std::move(next);
    }
    return best;
  }

private:
  const vtkIdType* GetCorners(vtkIdType cell) const
  {
    return this->Cells.Connectivity.data() + this->Starts[cell];
  }

  /// The places at which searches begin.
  std::vector<NearestPlace> FindStarts(vtkDataSet* fine, int levels) const
  {
    Buffer<vtkIdType> firsts(this->Cells.GetNumberOfCells() + 1);
    ForEach(this->Cells.GetNumberOfCells(),
      [&](vtkIdType c) { firsts[c] = vtkIdType(1) << (levels * this->Cells.Dimensions[c]); });
    CountsToOffsets(firsts);
    Buffer<double> points(3 * fine->GetNumberOfPoints());
    ForEachInTurn(
      fine->GetNumberOfPoints(), [&](vtkIdType i) { fine->GetPoint(i, points.data() + 3 * i); });
    std::vector<int> corners[2]; // of tetrahedra, and of all others
    std::vector<Piece> numbers[2];
    vtkNew<vtkIdList> ids;
    ForEachInTurn(fine->GetNumberOfCells(),
      [&](vtkIdType c)
      {
        fine->GetCellPoints(c, ids);
        const auto add = [&](int kind, int half, std::initializer_list<vtkIdType> of)
        {
          for (const vtkIdType k : of)
          {
            corners[kind].push_back(
              static_cast<int>(ids->GetId(std::min(k, ids->GetNumberOfIds() - 1))));
          }
          numbers[kind].push_back({ c, half });
        };
        if (fine->GetCellType(c) == VTK_TETRA)
        {
          add(0, 0, { 0, 1, 2, 3 });
          return;
        }
        add(1, 0, { 0, 1, 2 });
        if (ids->GetNumberOfIds() == 4)
        {
          add(1, 1, { 0, 2, 3 });
        }
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
        const Piece& piece = numbers[kind][place.Simplex];
        const vtkIdType cell =
          std::upper_bound(firsts.begin(), firsts.end(), piece.Number) - firsts.begin() - 1;
        starts[i].Cell = cell;
        SetStart(
          this->Cells, piece.Number - firsts[cell], levels, piece.Half, place.Weights, starts[i]);
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
  return Finder(cells, points, evaluate).Find(fine, levels);
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
