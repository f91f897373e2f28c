// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bounds/Deviations.h"

#include "Core/Memory/UnevenRanges.h"
#include "Private/Bounds/VectorRanges.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace subdivision
{
namespace
{

/// Values at the points after a step: those before, and means of them.
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

/// For each place of a cell the vectors of the points on which the limit next to it depends: those
/// of the pieces at it that belong to its sector; where the sector has tetrahedra, whose edges have
/// rings beyond these, or if `isWide`, of one layer of pieces more.
VectorRanges Spread(const NestedPieces& pieces, const Sectors& sectors, int components,
  const VectorRanges& ofPoints, bool isWide)
{
  const auto forPlaces = [&pieces](const auto& act) // act(cell, point, place)
  {
    ForUnevenRanges(pieces.GetNumberOfCells(),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType c = begin; c < end; ++c)
        {
          const vtkIdType first = pieces.GetFirstPlace(c);
          for (vtkIdType place = first; place < pieces.GetFirstPlace(c + 1); ++place)
          {
            act(c, static_cast<int>(place - first), place);
          }
        }
      });
  };
  const auto spreadInCells = [&](VectorRanges& to, const auto& getRange)
  {
    forPlaces(
      [&](vtkIdType c, int point, vtkIdType place)
      {
        for (const int neighbour : pieces.GetLattice(c).Neighbours[point])
        {
          to.Extend(place, getRange(pieces.GetFirstPlace(c) + neighbour));
        }
      });
  };
  VectorRanges inCells(pieces.GetNumberOfPlaces(), components);
  spreadInCells(inCells, [&](vtkIdType place) { return ofPoints.Get(pieces.GetPoint(place)); });
  VectorRanges near(pieces.GetNumberOfPlaces(), components);
  // Extends by what the sector at each place has. Places at one point with one sector have the
  // same: where there are many, it is found once.
  const auto spreadInSectors = [&](const auto& whole, const auto& rest)
  {
    constexpr vtkIdType many = 64;
    const auto spreadTo = [&](vtkIdType c, int point, vtkIdType place)
    {
      sectors.ForSector(
        c, point, [&](vtkIdType other) { whole(place, other); },
        [&](vtkIdType other) { rest(place, other); });
    };
    forPlaces(
      [&](vtkIdType c, int point, vtkIdType place)
      {
        if (sectors.GetPlaces(pieces.GetPoint(place)).size() < many)
        {
          spreadTo(c, point, place);
        }
      });
    const auto spreadToAll = [&](vtkIdType place, const std::vector<vtkIdType>& others)
    {
      const vtkIdType c = sectors.GetCell(place);
      spreadTo(c, static_cast<int>(place - pieces.GetFirstPlace(c)), place);
      for (const vtkIdType other : others)
      {
        near.Extend(other, near.Get(place));
      }
    };
    for (const vtkIdType at : InTurn(pieces.GetNumberOfPoints(NestedPieces::Steps)))
    {
      if (sectors.GetPlaces(at).size() >= many)
      {
        BetweenLoops::Act();
        sectors.ForGroups(at, spreadToAll);
      }
    }
  };
  spreadInSectors([&](vtkIdType place, vtkIdType other) { near.Extend(place, inCells.Get(other)); },
    [&](vtkIdType place, vtkIdType other)
    { near.Extend(place, ofPoints.Get(pieces.GetPoint(other))); });
  if (isWide || pieces.HasTets())
  {
    spreadInCells(inCells, [&](vtkIdType place) { return near.Get(place); });
    spreadInSectors(
      [&](vtkIdType place, vtkIdType other)
      {
        if (isWide || pieces.GetDimension(sectors.GetCell(other)) == 3)
        {
          near.Extend(place, inCells.Get(other));
        }
      },
      [](vtkIdType, vtkIdType) {});
  }
  return near;
}

VectorRanges MakeRanges(const NestedPieces& pieces, int components, const Buffer<double>& vectors)
{
  VectorRanges ranges(pieces.GetNumberOfPoints(NestedPieces::Steps), components);
  ForEach(pieces.GetNumberOfPoints(NestedPieces::Steps),
    [&](vtkIdType i) { ranges.Add(i, vectors.data() + components * i); });
  return ranges;
}

/// What all steps after step 3 together add to bilinear pieces: what a row makes of them after m
/// steps is h a + h^2 b with h = 2^-m, where a and b follow from two steps (Mathematics 14).
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
          // The half of an edge. Its rule may be another one than that of the whole edge; then it
          // is that of the edge's middle, at h = 1/2.
          add(i, first.data() + components * parents[1], 1., half);
          add(i, second.data() + components * parents[1], 2., half);
        }
      }
    });
  return tail;
}

/// The bound of a piece: on |x + a + b| where x is the difference at a corner, a is in the range of
/// what steps 2 and 3 add, and b in that of all later steps, or `further` out of it.
double BoundPiece(int components, const double* differences, int corners, const VectorRange& steps,
  const VectorRange& tail, double further)
{
  double byNorms = 0.;
  double byComponents = 0.;
  for (int k = 0; k < corners; ++k)
  {
    const double* x = differences + components * k;
    byNorms = std::max(byNorms, Known(GetNorm(x, components)));
    double squares = 0.;
    for (int c = 0; c < components; ++c)
    {
      const double least = x[c] + steps.GetLeast(c) + tail.GetLeast(c);
      const double largest = x[c] + steps.GetLargest(c) + tail.GetLargest(c);
      const double most = std::max(Known(std::abs(least)), Known(std::abs(largest)));
      squares += most * most;
    }
    byComponents = std::max(byComponents, Known(std::sqrt(squares)));
  }
  byNorms += steps.GetNorm() + tail.GetNorm();
  return std::min(Known(byNorms), Known(byComponents)) + further;
}

/// Finds bounds of cells from what steps and all later steps add.
class CellBounds
{
public:
  CellBounds(const NestedPieces& pieces, const Sectors& sectors, const BoundedValues& values,
    const Buffer<double>& linear, const VectorRanges& steps, const VectorRanges& tail)
    : Pieces(pieces)
    , AllSectors(sectors)
    , Values(values)
    , Linear(linear)
    , Steps(steps)
    , Tail(tail)
    , OfSteps(values.Components)
    , OfTail(values.Components)
    , OfPiece(static_cast<std::size_t>(values.Components) * NestedPieces::MostCorners)
  {
  }

  CellBound Find(vtkIdType cell)
  {
    const NestedPieces::Lattice& lattice = this->Pieces.GetLattice(cell);
    this->Differences.resize(this->Values.Components * lattice.Points.size());
    for (std::size_t i = 0; i < lattice.Points.size(); ++i)
    {
      this->FindDifference(
        cell, static_cast<int>(i), this->Differences.data() + this->Values.Components * i);
    }
    CellBound bound;
    this->OfPieces.clear();
    for (int piece = 0; piece < lattice.GetNumberOfPieces(); ++piece)
    {
      this->OfPieces.push_back(this->FindOfPiece(cell, piece) + this->Values.Rounding);
      bound.Largest = std::max(bound.Largest, this->OfPieces.back());
    }
    for (int point = 0; point < static_cast<int>(lattice.Points.size()); ++point)
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
  double FindOfPiece(vtkIdType cell, int piece)
  {
    const NestedPieces::Lattice& lattice = this->Pieces.GetLattice(cell);
    this->OfSteps.Clear();
    this->OfTail.Clear();
    for (int k = 0; k < lattice.Corners; ++k)
    {
      const int point = lattice.Pieces[lattice.Corners * piece + k];
      const vtkIdType place = this->Pieces.GetFirstPlace(cell) + point;
      this->OfSteps.Add(this->Steps.Get(place));
      this->OfTail.Add(this->Tail.Get(place));
      std::copy_n(this->Differences.data() + this->Values.Components * point,
        this->Values.Components, this->OfPiece.data() + this->Values.Components * k);
    }
    this->OfTail.AddZero();
    double further = 0.;
    for (int k = 0; k < lattice.Corners; ++k)
    {
      const int point = lattice.Pieces[lattice.Corners * piece + k];
      further = std::max(further, this->GetFurther(cell, point));
    }
    return BoundPiece(this->Values.Components, this->OfPiece.data(), lattice.Corners, this->OfSteps,
      this->OfTail, further);
  }

  /// What the limit is away at a point at least: |x + a + b| as in BoundPiece, of this point.
  double FindLeast(vtkIdType cell, int point)
  {
    const int components = this->Values.Components;
    const vtkIdType place = this->Pieces.GetFirstPlace(cell) + point;
    this->OfSteps.Clear();
    this->OfTail.Clear();
    this->OfSteps.Add(this->Steps.Get(place));
    this->OfTail.Add(this->Tail.Get(place));
    this->OfTail.AddZero();
    const double* x = this->Differences.data() + components * point;
    double squares = 0.;
    for (int c = 0; c < components; ++c)
    {
      const double least = x[c] + this->OfSteps.GetLeast(c) + this->OfTail.GetLeast(c);
      const double largest = x[c] + this->OfSteps.GetLargest(c) + this->OfTail.GetLargest(c);
      const double nearest = least > 0. ? least : largest < 0. ? -largest : 0.;
      squares += nearest * nearest;
    }
    const double byNorms =
      GetNorm(x, components) - this->OfSteps.GetNorm() - this->OfTail.GetNorm();
    const double least = std::max(std::sqrt(squares), std::isfinite(byNorms) ? byNorms : 0.);
    return least - this->GetFurther(cell, point);
  }

  /// Rows of vertices in faces between solids, which step 3 does not have, may make a little more
  /// of the kink there than rows of edges.
  double GetFurther(vtkIdType cell, int point) const
  {
    return this->AllSectors.HasTets(cell, point) ? 0.25 * this->OfTail.GetNorm() : 0.;
  }

  /// Of linear values from those of the output.
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
  const VectorRanges& Steps;
  const VectorRanges& Tail;
  VectorRange OfSteps;
  VectorRange OfTail;
  std::vector<double> Differences; ///< at all points of the cell
  std::vector<double> OfPiece;
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
  const Buffer<double> kinks = FindMoves(pieces, 3, components, values.LastStep(middles), linear);
  const VectorRanges steps = Spread(pieces, sectors, components,
    MakeRanges(pieces, components, FindMoves(pieces, 3, components, values.Third, linear)), false);
  const bool hasQuads = pieces.HasQuads(); // then both halves of an edge count
  const VectorRanges tail = Spread(pieces, sectors, components,
    hasQuads ? FindTailOfQuads(pieces, components,
                 FindMoves(pieces, 2, components, values.Second, middles), kinks)
             : MakeRanges(pieces, components, kinks),
    hasQuads);
  std::vector<CellBound> bounds(cells.size());
  ForUnevenRanges(static_cast<vtkIdType>(cells.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      CellBounds find(pieces, sectors, values, linear, steps, tail);
      for (vtkIdType i = begin; i < end; ++i)
      {
        bounds[i] = find.Find(cells[i]);
      }
    });
  return bounds;
}

}
