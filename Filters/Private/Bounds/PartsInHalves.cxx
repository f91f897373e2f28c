// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bounds/PartsAsCells.h"

#include "Core/Memory/Sorting.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <utility>

namespace subdivision
{
namespace
{

using Lattice = NestedPieces::Lattice;
using Part = PartsAsCells::Part;
/// Whole numbers for the corners of a cell.
using Weights = std::array<int, Lattice::MostCorners>;
constexpr int Divisions = Lattice::Divisions;

/// Even numbers to take away from some weights, so that half of their sum is left. A place next to
/// a side of the cell stays next to it, and no other place comes next to a side. (In tetrahedra a
/// place may, but there rows are the same.)
Weights FindExcess(Weights weights)
{
  Weights excess{};
  for (int taken = 0; taken < Divisions; taken += 2)
  {
    const auto most = std::max_element(weights.begin(), weights.end()) - weights.begin();
    weights[most] -= 2;
    excess[most] += 2;
  }
  return excess;
}

FrameNode Add(const FrameNode& a, const FrameNode& b, int factor)
{
  return { { a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2] } };
}

FrameNode Halve(const FrameNode& place)
{
  return { { place[0] / 2, place[1] / 2, place[2] / 2 } };
}

class PartsInHalves : public PartsAsCells
{
public:
  PartsInHalves(const SteppedPieces& from, const std::vector<Part>& wanted)
    : PartsAsCells(from)
  {
    this->ListParts(wanted);
    this->NumberOldPoints();
    this->FindPieces();
    this->MakeRows();
    std::vector<vtkIdType> cells(this->Parts.size());
    std::iota(cells.begin(), cells.end(), vtkIdType(0));
    this->Finish(cells, { &this->Step });
  }

private:
  using Mask = NestedPieces::Mask;
  /// How a place is moved to one where its row is known.
  struct Shift
  {
    vtkIdType Cell;
    Mask Face;       ///< all cells that have it are alike there
    Weights Corners; ///< how much of each corner is taken away
  };
  /// Points come in the order of the steps that make them.
  void NumberOldPoints()
  {
    std::vector<std::pair<int, vtkIdType>> points;
    for (const Part& part : InTurn(this->Parts))
    {
      const Lattice& lattice = this->GetLattice(part);
      for (int point = 0; point < lattice.CountPoints(); ++point)
      {
        if (lattice.GetStep(point) < NestedPieces::Steps)
        {
          points.emplace_back(lattice.GetStep(point), this->GetOld(part, point));
        }
      }
    }
    SortDistinct(points);
    for (const auto& [step, old] : InTurn(points))
    {
      this->NumbersOfOld.emplace_back(old, static_cast<vtkIdType>(this->NumbersOfOld.size()));
      for (int later = step; later <= NestedPieces::Steps; ++later)
      {
        ++this->Counts[later];
      }
    }
    SortDistinct(this->NumbersOfOld);
  }
  /// A new point is known by the points in whose middle it is.
  void FindPieces()
  {
    using Parents = std::array<vtkIdType, Lattice::MostCorners>;
    std::vector<int> kinds;
    std::vector<vtkIdType> numbers; // of the points of all parts
    std::vector<std::pair<Parents, vtkIdType>> places;
    for (const Part& part : InTurn(this->Parts))
    {
      const Lattice& lattice = this->GetLattice(part);
      kinds.push_back(lattice.ChildKinds[part.Child]);
      const auto first = static_cast<vtkIdType>(numbers.size());
      for (int point = 0; point < lattice.CountPoints(); ++point)
      {
        numbers.push_back(this->FindNumber(this->GetOld(part, point)));
      }
      for (const Lattice::Middle& middle : lattice.Middles[NestedPieces::Steps])
      {
        Parents parents{ { -1, -1, -1, -1 } };
        std::transform(middle.Parents.begin(), middle.Parents.end(), parents.begin(),
          [&](int parent) { return parent < 0 ? -1 : numbers[first + parent]; });
        std::sort(parents.begin(), parents.end());
        places.emplace_back(parents, first + middle.Point);
      }
    }
    StableSort(places, std::less<>());
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      this->Counts[NestedPieces::Steps] += i == 0 || places[i].first != places[i - 1].first ? 1 : 0;
      numbers[places[i].second] = this->Counts[NestedPieces::Steps] - 1;
    }
    Buffer<vtkIdType> placePoints(static_cast<vtkIdType>(numbers.size()));
    std::copy(numbers.begin(), numbers.end(), placePoints.begin());
    this->Pieces = std::make_unique<NestedPieces>(kinds, std::move(placePoints), this->Counts);
  }
  void MakeRows()
  {
    const vtkIdType rows = this->Counts[NestedPieces::Steps];
    std::vector<std::pair<Part, int>> points(static_cast<std::size_t>(rows)); // of parts
    for (std::size_t p = 0; p < this->Parts.size(); ++p)
    {
      const vtkIdType first = this->Pieces->GetFirstPlace(static_cast<vtkIdType>(p));
      for (int point = 0; point < this->GetLattice(this->Parts[p]).CountPoints(); ++point)
      {
        points[this->Pieces->GetPoint(first + point)] = { this->Parts[p], point };
      }
    }
    std::vector<Sectors::Entries> found(static_cast<std::size_t>(rows));
    ForEach(rows,
      [&](vtkIdType row)
      {
        Shift shift;
        const vtkIdType known = this->FindRow(points[row].first, points[row].second, shift);
        found[row] = GetRow(this->From.Last, known,
          [&](vtkIdType column)
          {
            const vtkIdType old = this->ShiftColumn(shift, column);
            return old < 0 ? -1 : this->FindNumber(old);
          });
      });
    this->Step.NumberOfColumns = this->Counts[NestedPieces::Steps - 1];
    this->Step.Offsets = Buffer<long long>(rows + 1, 0);
    ForEach(rows,
      [&](vtkIdType row) { this->Step.Offsets[row] = static_cast<long long>(found[row].size()); });
    CountsToOffsets(this->Step.Offsets);
    this->Step.Columns = Buffer<long long>(this->Step.Offsets[rows]);
    this->Step.Weights = Buffer<double>(this->Step.Offsets[rows]);
    ForEach(rows,
      [&](vtkIdType row)
      {
        vtkIdType to = this->Step.Offsets[row];
        for (const auto& [column, weight] : found[row])
        {
          this->Step.Columns[to] = std::max<vtkIdType>(column, 0);
          this->Step.Weights[to++] = column < 0 ? std::numeric_limits<double>::quiet_NaN() : weight;
        }
      });
  }

  /// The point before with the row of a point of a part; `shift` tells how this point moves there.
  vtkIdType FindRow(const Part& part, int point, Shift& shift) const
  {
    const Lattice& lattice = this->GetLattice(part);
    constexpr int all = 2 * Divisions;
    FrameNode place = lattice.GetPlaceInChild(part.Child, point);
    shift = { part.Cell, lattice.GetWhole(), {} };
    if (lattice.IsQuad() && place[0] % all != 0 && place[1] % all != 0)
    {
      // Along each axis by itself, as multiples of the second corner and of the last one.
      shift.Corners[1] = FindExcess({ { place[0], all - place[0], 0, 0 } })[0];
      shift.Corners[3] = FindExcess({ { place[1], all - place[1], 0, 0 } })[0];
    }
    else
    {
      Weights weights{};
      shift.Face = 0;
      const Lattice::Weights exact = lattice.WeighCorners(place, all);
      for (int k = 0; k < lattice.Corners; ++k)
      {
        weights[k] = static_cast<int>(all * exact[k]);
        shift.Face |= weights[k] > 0 ? 1U << k : 0U;
      }
      shift.Corners = FindExcess(weights);
    }
    for (int k = 0; k < lattice.Corners; ++k)
    {
      place = Add(place, lattice.CornerPlaces[k], -shift.Corners[k]);
    }
    return this->From.Pieces.GetPoint(
      this->From.Pieces.GetFirstPlace(part.Cell) + lattice.Find(place));
  }
  /// The multiples that a shift takes of the corners of a cell. Returns false if this cell does not
  /// have all corners of the shift, or not as a face. A row inside a quad reads this quad only.
  bool Match(const Shift& shift, vtkIdType cell, Weights& corners) const
  {
    if (cell == shift.Cell)
    {
      corners = shift.Corners;
      return true;
    }
    const NestedPieces& pieces = this->From.Pieces;
    corners = {};
    Mask left = shift.Face;
    Mask found = 0;
    for (int k = 0; k < pieces.GetNumberOfCorners(shift.Cell); ++k)
    {
      for (int i = 0; i < pieces.GetNumberOfCorners(cell) && (left >> k & 1U); ++i)
      {
        if (pieces.GetCorner(cell, i) == pieces.GetCorner(shift.Cell, k))
        {
          left &= ~(1U << k);
          found |= 1U << i;
          corners[i] = shift.Corners[k];
        }
      }
    }
    const Lattice& lattice = pieces.GetLattice(cell);
    return left == 0 && lattice.Close(found) == found &&
      !(lattice.IsQuad() && found == lattice.GetWhole());
  }
  /// The column that is where another one of the row before was; -1 if no cell tells.
  vtkIdType ShiftColumn(const Shift& shift, vtkIdType column) const
  {
    const NestedPieces& pieces = this->From.Pieces;
    const auto places = this->From.AllSectors.GetPlaces(column);
    Weights corners{};
    for (const bool isOwn : { true, false }) // most columns lie in the cell itself
    {
      for (const vtkIdType at : places)
      {
        const vtkIdType cell = this->GetCell(at);
        if ((cell == shift.Cell) == isOwn && this->Match(shift, cell, corners))
        {
          const vtkIdType first = pieces.GetFirstPlace(cell);
          const Lattice& lattice = pieces.GetLattice(cell);
          FrameNode place = lattice.Places[at - first];
          for (int i = 0; i < lattice.Corners; ++i)
          {
            place = Add(place, lattice.CornerPlaces[i], corners[i]);
          }
          return pieces.GetPoint(first + lattice.Find(Halve(place)));
        }
      }
    }
    // A row of a point in an octahedron reads all of it.
    for (const vtkIdType at : places)
    {
      const vtkIdType first = pieces.GetFirstQuarter(this->GetCell(at));
      const bool isQuarter = pieces.GetKind(this->GetCell(at)) >= Lattice::FirstQuarter;
      for (vtkIdType quarter = first; isQuarter && quarter < first + 4; ++quarter)
      {
        if (this->Match(shift, quarter, corners))
        {
          return this->ShiftInOctahedron(at, quarter, corners);
        }
      }
    }
    return -1;
  }
  /// Moves a place of an octahedron by the multiples that a shift takes of a quarter's corners.
  vtkIdType ShiftInOctahedron(vtkIdType place, vtkIdType quarter, const Weights& corners) const
  {
    const NestedPieces& pieces = this->From.Pieces;
    const vtkIdType cell = this->GetCell(place);
    FrameNode at =
      pieces.GetLattice(cell).GetPlaceInSolid(static_cast<int>(place - pieces.GetFirstPlace(cell)));
    const Lattice& lattice = pieces.GetLattice(quarter);
    for (int k = 0; k < lattice.Corners; ++k)
    {
      // A corner is Divisions away from the centre.
      const FrameNode corner = lattice.GetPlaceInSolid(lattice.CornerPoints[k]);
      for (int x = 0; x < 3; ++x)
      {
        at[x] += corners[k] * corner[x] / Divisions;
      }
    }
    const auto found = lattice.PointsOfSolid.find(Halve(at));
    return found == lattice.PointsOfSolid.end()
      ? -1
      : pieces.GetPoint(pieces.GetFirstPlace(quarter) + found->second);
  }

  vtkIdType FindNumber(vtkIdType old) const
  {
    const auto at = std::lower_bound(this->NumbersOfOld.begin(), this->NumbersOfOld.end(),
      std::pair<vtkIdType, vtkIdType>{ old, 0 });
    return at != this->NumbersOfOld.end() && at->first == old ? at->second : -1;
  }

  vtkIdType GetCell(vtkIdType place) const { return this->From.AllSectors.GetCell(place); }

  std::array<vtkIdType, NestedPieces::Steps + 1> Counts{};
  std::vector<std::pair<vtkIdType, vtkIdType>> NumbersOfOld; ///< ascending
  MatrixFactors::Matrix Step;
};

}

std::unique_ptr<PartsAsCells> SplitIntoHalves(
  const SteppedPieces& from, const std::vector<Part>& wanted)
{
  return std::make_unique<PartsInHalves>(from, wanted);
}

}
