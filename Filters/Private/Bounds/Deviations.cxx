// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bounds/Deviations.h"

#include "Core/Memory/UnevenRanges.h"
#include "Private/Bounds/VectorRanges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace subdivision
{
namespace
{

/// Values at the points after a step: the values before, and means of them.
Buffer<double> MakeMiddles(
  const NestedPieces& pieces, int step, int components, const Buffer<double>& values)
{
  const vtkIdType before = pieces.GetNumberOfPoints(step - 1);
  Buffer<double> middles(components * pieces.GetNumberOfPoints(step), 0.);
  CopyInThreads(values.data(), components * before, middles.data());
  ForEach(pieces.GetNumberOfPoints(step) - before,
    [&](vtkIdType i)
    {
      const vtkIdType* parents = pieces.GetParents(step, before + i);
      double* to = middles.data() + components * (before + i);
      int count = 0;
      while (count < NestedPieces::MostCorners && parents[count] >= 0)
      {
        for (int c = 0; c < components; ++c)
        {
          to[c] += values[components * parents[count] + c];
        }
        ++count;
      }
      for (int c = 0; c < components && count > 0; ++c)
      {
        to[c] /= count;
      }
    });
  return middles;
}

/// By how much a step moves the points away from linear values; 0 where no cell has a point.
Buffer<double> FindMoves(const NestedPieces& pieces, int step, int components,
  const Buffer<double>& stepped, const Buffer<double>& middles)
{
  const vtkIdType before = pieces.GetNumberOfPoints(step - 1);
  Buffer<double> moves(stepped.size());
  ForEach(pieces.GetNumberOfPoints(step),
    [&](vtkIdType i)
    {
      const bool isUsed = i < before || pieces.GetParents(step, i)[0] >= 0;
      for (vtkIdType k = components * i; k < components * (i + 1); ++k)
      {
        moves[k] = isUsed ? stepped[k] - middles[k] : 0.;
      }
    });
  return moves;
}

/// The points that the bounds of some cells need: of these cells, and of the pieces at them.
class NeededPoints
{
public:
  NeededPoints(
    const NestedPieces& pieces, const Sectors& sectors, const std::vector<vtkIdType>& cells)
  {
    if (static_cast<vtkIdType>(cells.size()) == pieces.GetNumberOfCells())
    {
      return;
    }
    const vtkIdType points = pieces.GetNumberOfPoints(NestedPieces::Steps);
    this->Own = Buffer<char>(points, 0);
    this->All = Buffer<char>(points, 0);
    for (const vtkIdType cell : InTurn(cells))
    {
      for (vtkIdType at = pieces.GetFirstPlace(cell); at < pieces.GetFirstPlace(cell + 1); ++at)
      {
        this->Own[pieces.GetPoint(at)] = 1;
      }
    }
    ForEach(points,
      [&](vtkIdType point)
      {
        for (const vtkIdType place : sectors.GetPlaces(point))
        {
          const vtkIdType first = pieces.GetFirstPlace(sectors.GetCell(place));
          const auto& near = pieces.GetLattice(sectors.GetCell(place)).Neighbours[place - first];
          if (std::any_of(near.begin(), near.end(),
                [&](int neighbour) { return this->Own[pieces.GetPoint(first + neighbour)] != 0; }))
          {
            this->All[point] = 1;
            return;
          }
        }
      });
  }
  bool AreOfCells(vtkIdType point) const { return this->Own.empty() || this->Own[point] != 0; }
  bool Has(vtkIdType point) const { return this->All.empty() || this->All[point] != 0; }

private:
  Buffer<char> Own; ///< empty: all are needed
  Buffer<char> All;
};

/// Ranges of the vectors that steps 2 and 3 add, and that all later steps add.
using StepsAndTail = std::array<VectorRanges, 2>;

/// For each spot at a cell the ranges over the points on which the limit there depends: points of
/// the pieces at the spot that belong to its sector. One more layer of pieces counts in thirds, for
/// the tail if `isWide`, and beside tetrahedra, whose edges have rings beyond these.
StepsAndTail Spread(const NestedPieces& pieces, const Sectors& sectors, const NeededPoints& needed,
  int components, const StepsAndTail& ofPoints, bool isWide)
{
  // act(place) for the place of a cell and its neighbours there.
  const auto forNeighbours = [&](vtkIdType place, const auto& act)
  {
    const vtkIdType cell = sectors.GetCell(place);
    const vtkIdType first = pieces.GetFirstPlace(cell);
    for (const int neighbour : pieces.GetLattice(cell).Neighbours[place - first])
    {
      act(first + neighbour);
    }
  };
  // whole(place) and rest(place) as Sectors::ForSector calls them.
  const auto forSector = [&](vtkIdType place, const auto& whole, const auto& rest)
  {
    const vtkIdType cell = sectors.GetCell(place);
    sectors.ForSector(cell, static_cast<int>(place - pieces.GetFirstPlace(cell)), whole, rest);
  };
  const auto makeRanges = [&]
  {
    return StepsAndTail{ VectorRanges(sectors.GetNumberOfSpots(), components),
      VectorRanges(sectors.GetNumberOfSpots(), components) };
  };
  const bool hasThirds = pieces.HasThirds();
  const bool isTwice = isWide || hasThirds || pieces.HasTets();
  StepsAndTail near = makeRanges();
  sectors.ForSpots([&](vtkIdType point)
    { return isTwice ? needed.Has(point) : needed.AreOfCells(point); },
    [&](vtkIdType spot, vtkIdType place)
    {
      const auto extend = [&](vtkIdType by)
      {
        const vtkIdType point = pieces.GetPoint(by);
        near[0].Extend(spot, ofPoints[0].Get(point));
        near[1].Extend(spot, ofPoints[1].Get(point));
      };
      forSector(place, [&](vtkIdType other) { forNeighbours(other, extend); }, extend);
    });
  if (!isTwice)
  {
    return near;
  }
  StepsAndTail wide = makeRanges();
  sectors.ForSpots([&](vtkIdType point) { return needed.AreOfCells(point); },
    [&](vtkIdType spot, vtkIdType place)
    {
      const auto extendTail = [&](vtkIdType by)
      { wide[1].Extend(spot, near[1].Get(sectors.GetSpot(by))); };
      const auto extend = [&](vtkIdType by)
      {
        wide[0].Extend(spot, near[0].Get(sectors.GetSpot(by)));
        extendTail(by);
      };
      extend(place);
      forSector(
        place,
        [&](vtkIdType other)
        {
          if (hasThirds || pieces.GetDimension(sectors.GetCell(other)) == 3)
          {
            forNeighbours(other, extend);
          }
          else if (isWide)
          {
            forNeighbours(other, extendTail);
          }
        },
        [](vtkIdType) {});
    });
  return wide;
}

VectorRanges MakeRanges(const NestedPieces& pieces, int components, const Buffer<double>& vectors)
{
  VectorRanges ranges(pieces.GetNumberOfPoints(NestedPieces::Steps), components);
  ForEach(pieces.GetNumberOfPoints(NestedPieces::Steps),
    [&](vtkIdType i) { ranges.Add(i, vectors.data() + components * i); });
  return ranges;
}

/// The sum of all steps after step 3: each adds half of the step before, or a third of it.
VectorRanges FindTail(const NestedPieces& pieces, int components, Buffer<double> kinks)
{
  if (pieces.HasThirds())
  {
    ForEach(kinks.size(), [&](vtkIdType i) { kinks[i] *= 0.5; }); // 1/3 + 1/9 + ...
  }
  return MakeRanges(pieces, components, kinks);
}

/// The same for bilinear pieces: a row on them gives h a + h^2 b after m steps, with h = 2^-m,
/// where a and b follow from two steps (Mathematics 14).
VectorRanges FindTailOfQuads(const NestedPieces& pieces, int components,
  const Buffer<double>& first, const Buffer<double>& second)
{
  VectorRanges tail(pieces.GetNumberOfPoints(NestedPieces::Steps), components);
  const vtkIdType old = pieces.GetNumberOfPoints(1);
  const vtkIdType before = pieces.GetNumberOfPoints(2);
  ForRanges(pieces.GetNumberOfPoints(3),
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<double> vector(static_cast<std::size_t>(components));
      // Of a row that makes `one` at h = 1 and `half` at h = 1/2.
      const auto add = [&](vtkIdType point, const double* one, double factor, const double* half)
      {
        for (int c = 0; c < components; ++c)
        {
          vector[c] = 0.5 * factor * one[c];
        }
        tail.Add(point, vector.data());
        for (int c = 0; c < components; ++c)
        {
          vector[c] = 0.5 * (4. * half[c] - factor * one[c]);
        }
        tail.Add(point, vector.data());
      };
      for (vtkIdType i = begin; i < end; ++i)
      {
        std::fill(vector.begin(), vector.end(), 0.);
        tail.Add(i, vector.data());
        const double* half = second.data() + components * i;
        if (i < old)
        {
          add(i, first.data() + components * i, 1., half);
        }
        const vtkIdType* parents = i < before ? nullptr : pieces.GetParents(3, i);
        if (parents && parents[0] >= 0 && parents[0] < old && parents[2] < 0)
        {
          // The half of an edge. Its rule may differ from the rule of the whole edge; then it is
          // the rule of the edge's middle, at h = 1/2.
          add(i, first.data() + components * parents[1], 1., half);
          add(i, second.data() + components * parents[1], 2., half);
        }
      }
    });
  return tail;
}

/// Finds bounds of cells from the ranges of steps 2 and 3, and of all later steps. The limit at a
/// point is x + a + b, where x is the difference of linear values from values of the output, a is
/// in the first range, and b in the second one, or GetFurther out of it.
class CellBounds
{
public:
  CellBounds(const NestedPieces& pieces, const Sectors& sectors, const BoundedValues& values,
    const Buffer<double>& linear, const StepsAndTail& ranges)
    : Pieces(pieces)
    , AllSectors(sectors)
    , Values(values)
    , Linear(linear)
    , Ranges(ranges)
    , Near(2, values.Components)
    , Zero(2 * static_cast<std::size_t>(values.Components) + 1, 0.)
  {
  }

  CellBound Find(vtkIdType cell)
  {
    const NestedPieces::Lattice& lattice = this->Pieces.GetLattice(cell);
    this->Differences.resize(this->Values.Components * lattice.Points.size());
    this->Norms.resize(lattice.Points.size());
    this->HasTets.resize(lattice.Points.size());
    for (std::size_t i = 0; i < lattice.Points.size(); ++i)
    {
      double* difference = this->Differences.data() + this->Values.Components * i;
      this->FindDifference(cell, static_cast<int>(i), difference);
      this->Norms[i] = GetNorm(difference, this->Values.Components);
      this->HasTets[i] = this->AllSectors.HasTets(cell, static_cast<int>(i)) ? 1 : 0;
    }
    CellBound bound;
    this->OfPieces.clear();
    for (int piece = 0; piece < lattice.GetNumberOfPieces(); ++piece)
    {
      const int* points = lattice.Pieces.data() + lattice.Corners * piece;
      this->OfPieces.push_back(
        this->FindLargest(cell, points, lattice.Corners) + this->Values.Rounding);
      bound.Largest = std::max(bound.Largest, this->OfPieces.back());
    }
    for (int point = 0; point < lattice.CountPoints(); ++point)
    {
      bound.Least = std::max(bound.Least, this->FindLeast(cell, point) - this->Values.Rounding);
    }
    if (!IsNear(bound.Largest, bound.Least, this->Values.Rounding))
    {
      bound.OfPieces = this->OfPieces;
    }
    return bound;
  }

private:
  /// Takes the ranges around some points of a cell.
  void LookAround(vtkIdType cell, const int* points, int count)
  {
    this->Near.Clear(0);
    this->Near.Clear(1);
    this->Near.Extend(1, this->Zero.data()); // there may be no later step
    for (int k = 0; k < count; ++k)
    {
      const vtkIdType spot = this->AllSectors.GetSpot(this->Pieces.GetFirstPlace(cell) + points[k]);
      this->Near.Extend(0, this->Ranges[0].Get(spot));
      this->Near.Extend(1, this->Ranges[1].Get(spot));
    }
  }
  /// Sums the squares of get(least, largest) for the components of x + a + b at a point.
  template <typename Get>
  double SumSquares(int point, const Get& get) const
  {
    const int components = this->Values.Components;
    const double* x = this->Differences.data() + components * point;
    const double* steps = this->Near.Get(0);
    const double* tail = this->Near.Get(1);
    double squares = 0.;
    for (int c = 0; c < components; ++c)
    {
      const double distance =
        get(x[c] + steps[c] + tail[c], x[c] + steps[components + c] + tail[components + c]);
      squares += distance * distance;
    }
    return squares;
  }
  double GetNormOf(int range) const { return this->Near.Get(range)[2 * this->Values.Components]; }

  /// The bound of a piece: the largest distance by components or by norms, whichever is less.
  double FindLargest(vtkIdType cell, const int* points, int corners)
  {
    this->LookAround(cell, points, corners);
    double norm = 0.;
    bool hasTets = false;
    double squares = 0.;
    for (int k = 0; k < corners; ++k)
    {
      norm = std::max(norm, Known(this->Norms[points[k]]));
      hasTets = hasTets || this->HasTets[points[k]] != 0;
      squares = std::max(squares,
        this->SumSquares(points[k], [](double least, double largest)
          { return std::max(Known(std::abs(least)), Known(std::abs(largest))); }));
    }
    const double byNorms = norm + (this->GetNormOf(0) + this->GetNormOf(1));
    return std::min(Known(byNorms), Known(std::sqrt(squares))) + this->GetFurther(hasTets);
  }

  /// The least distance of the limit at a point.
  double FindLeast(vtkIdType cell, int point)
  {
    this->LookAround(cell, &point, 1);
    const double squares = this->SumSquares(point, [](double least, double largest)
      { return least > 0. ? least
          : largest < 0.  ? -largest
                          : 0.; });
    const double byNorms = this->Norms[point] - this->GetNormOf(0) - this->GetNormOf(1);
    const double least = std::max(std::sqrt(squares), std::isfinite(byNorms) ? byNorms : 0.);
    return least - this->GetFurther(this->HasTets[point] != 0);
  }

  /// Rows of vertices in faces between solids, which step 3 does not have, may make a little more
  /// of the kink there than rows of edges.
  double GetFurther(bool hasTets) const { return hasTets ? 0.25 * this->GetNormOf(1) : 0.; }

  /// The difference of linear values from values of the output.
  void FindDifference(vtkIdType cell, int point, double* difference) const
  {
    const vtkIdType id = this->Pieces.GetPoint(this->Pieces.GetFirstPlace(cell) + point);
    const int components = this->Values.Components;
    std::copy_n(this->Linear.data() + components * id, components, difference);
    AddShown(this->Pieces, this->Values, cell, point, -1., difference);
  }

  const NestedPieces& Pieces;
  const Sectors& AllSectors;
  const BoundedValues& Values;
  const Buffer<double>& Linear;
  const StepsAndTail& Ranges;
  VectorRanges Near;               ///< around some points: of steps, and of the tail
  const std::vector<double> Zero;  ///< a range
  std::vector<double> Differences; ///< at all points of the cell
  std::vector<double> Norms;       ///< of these
  std::vector<char> HasTets;       ///< whether their sectors have tetrahedra
  std::vector<double> OfPieces;
};

}

void AddShown(const NestedPieces& pieces, const BoundedValues& values, vtkIdType cell, int point,
  double factor, double* value)
{
  const NestedPieces::Weights& weights = pieces.GetLattice(cell).Points[point];
  for (int c = 0; c < values.Components; ++c)
  {
    double shown = 0.;
    for (int corner = 0; corner < pieces.GetNumberOfCorners(cell); ++corner)
    {
      shown +=
        weights[corner] * values.Shown[values.Components * pieces.GetCorner(cell, corner) + c];
    }
    value[c] += factor * shown;
  }
}

std::vector<CellBound> FindBounds(const NestedPieces& pieces, const Sectors& sectors,
  const BoundedValues& values, const std::vector<vtkIdType>& cells)
{
  const int components = values.Components;
  const Buffer<double> middles = MakeMiddles(pieces, 2, components, values.Next);
  const Buffer<double> linear = MakeMiddles(pieces, 3, components, middles);
  Buffer<double> kinks = FindMoves(pieces, 3, components, values.LastStep(middles), linear);
  const NeededPoints needed(pieces, sectors, cells);
  const bool hasQuads = pieces.HasQuads(); // then both halves of an edge count
  const StepsAndTail ranges = Spread(pieces, sectors, needed, components,
    { MakeRanges(pieces, components, FindMoves(pieces, 3, components, values.Third, linear)),
      hasQuads ? FindTailOfQuads(pieces, components,
                   FindMoves(pieces, 2, components, values.Second, middles), kinks)
               : FindTail(pieces, components, std::move(kinks)) },
    hasQuads);
  std::vector<CellBound> bounds(cells.size());
  ForUnevenRanges(static_cast<vtkIdType>(cells.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      CellBounds find(pieces, sectors, values, linear, ranges);
      for (vtkIdType i = begin; i < end; ++i)
      {
        bounds[i] = find.Find(cells[i]);
      }
    });
  return bounds;
}

}
