// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bounds/DeeperPieces.h"

#include "Core/Memory/Sorting.h"

#include <algorithm>
#include <limits>

namespace subdivision
{
namespace
{

using Lattice = NestedPieces::Lattice;
using Weights = DeeperPieces::Weights;
constexpr int Divisions = Lattice::Divisions;

/// A place on the lattice of twice as many divisions as weights of the corners, which add up to
/// these divisions. Of a quad, a place on its border.
Weights WeighCorners(const Lattice& lattice, const LatticePoint& place)
{
  constexpr int all = 2 * Divisions;
  const auto [x, y, z] = place;
  if (lattice.Corners > lattice.Dimension + 1)
  {
    return { { (all - x) * (all - y) / all, x * (all - y) / all, x * y / all,
      (all - x) * y / all } };
  }
  return { { all - x - y - z, x, y, z } };
}

/// Even numbers which leave half of the sum of some weights. A place near a side stays as near, and
/// other places come not next to one; in tetrahedra they may, where rows are the same.
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

LatticePoint Add(const LatticePoint& a, const LatticePoint& b, int factor)
{
  return { { a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2] } };
}

LatticePoint Halve(const LatticePoint& place)
{
  return { { place[0] / 2, place[1] / 2, place[2] / 2 } };
}

}

DeeperPieces::DeeperPieces(const SteppedPieces& from, const std::vector<Part>& wanted)
  : From(from)
{
  this->ListParts(wanted);
  this->NumberOldPoints();
  this->NumberNewPoints();
  this->FindPieces();
  this->MakeRows();
  this->AllSectors = std::make_unique<Sectors>(*this->Pieces, Sectors::Step{ &this->Last });
}

/// The wanted parts, and all that have a corner with one of them in common.
void DeeperPieces::ListParts(const std::vector<Part>& wanted)
{
  const NestedPieces& pieces = this->From.Pieces;
  std::vector<vtkIdType> corners;
  const auto getCorner = [&](const Part& part, int corner)
  { return this->GetOld(part, this->GetLattice(part).GetCornerPoint(corner)); };
  for (const Part& part : InTurn(wanted))
  {
    for (int k = 0; k < this->GetLattice(part).Corners; ++k)
    {
      corners.push_back(getCorner(part, k));
    }
  }
  SortDistinct(corners);
  std::vector<Part> others;
  for (const vtkIdType corner : InTurn(corners))
  {
    for (const vtkIdType place : this->From.AllSectors.GetPlaces(corner))
    {
      Part part{ this->From.AllSectors.GetCell(place), 0 };
      const Lattice& lattice = this->GetLattice(part);
      for (; part.Child < static_cast<int>(lattice.Children.size()); ++part.Child)
      {
        for (int k = 0; k < lattice.Corners; ++k)
        {
          if (getCorner(part, k) == corner)
          {
            others.push_back(part);
          }
        }
      }
    }
  }
  SortDistinct(others);
  std::map<Part, vtkIdType> numbers;
  this->AddParts(wanted, numbers);
  for (const Part& part : InTurn(wanted))
  {
    this->Wanted.push_back(numbers.at(part));
  }
  this->AddParts(others, numbers);
  this->FirstPlaces.push_back(0);
  for (const Part& part : InTurn(this->Parts))
  {
    this->FirstPlaces.push_back(this->FirstPlaces.back() +
      static_cast<vtkIdType>(pieces.GetLattice(part.Cell).Places.size()));
  }
  this->PlacePoints = Buffer<vtkIdType>(this->FirstPlaces.back());
}

/// Adds parts that are not there yet. Quarters of an octahedron follow each other.
void DeeperPieces::AddParts(const std::vector<Part>& parts, std::map<Part, vtkIdType>& numbers)
{
  const auto add = [&](const Part& part)
  {
    if (numbers.try_emplace(part, static_cast<vtkIdType>(this->Parts.size())).second)
    {
      this->Parts.push_back(part);
    }
  };
  for (const Part& part : InTurn(parts))
  {
    const auto quarters = this->GetLattice(part).ListOctahedron(part.Child);
    for (const Lattice::QuarterChild& quarter : quarters)
    {
      add({ part.Cell + quarter.Quarter, quarter.Child });
    }
    if (quarters.empty())
    {
      add(part);
    }
  }
}

vtkIdType DeeperPieces::GetOld(const Part& part, int point) const
{
  const Lattice& lattice = this->GetLattice(part);
  return this->From.Pieces.GetPoint(this->From.Pieces.GetFirstPlace(part.Cell) +
    lattice.Find(Halve(lattice.GetPlaceInChild(part.Child, point))));
}

/// Points come in the order of the steps that make them.
void DeeperPieces::NumberOldPoints()
{
  std::vector<std::pair<int, vtkIdType>> points;
  for (const Part& part : InTurn(this->Parts))
  {
    const Lattice& lattice = this->GetLattice(part);
    for (int point = 0; point < static_cast<int>(lattice.Places.size()); ++point)
    {
      const int step = lattice.GetStep(point);
      if (step < NestedPieces::Steps)
      {
        points.emplace_back(step, this->GetOld(part, point));
      }
    }
  }
  SortDistinct(points);
  for (const auto& [step, old] : InTurn(points))
  {
    this->NumbersOfOld.emplace_back(old, static_cast<vtkIdType>(this->Old.size()));
    this->Old.push_back(old);
    for (int later = step; later <= NestedPieces::Steps; ++later)
    {
      ++this->Counts[later];
    }
  }
  SortDistinct(this->NumbersOfOld);
}

vtkIdType DeeperPieces::FindNumber(vtkIdType old) const
{
  const auto at = std::lower_bound(this->NumbersOfOld.begin(), this->NumbersOfOld.end(),
    std::pair<vtkIdType, vtkIdType>{ old, 0 });
  return at != this->NumbersOfOld.end() && at->first == old ? at->second : -1;
}

/// A new point is known by the points in whose middle it is.
void DeeperPieces::NumberNewPoints()
{
  using Parents = std::array<vtkIdType, Lattice::MostCorners>;
  std::vector<std::pair<Parents, vtkIdType>> places;
  this->Corners.resize(static_cast<std::size_t>(this->Counts[0]), { -1, -1 });
  for (std::size_t p = 0; p < this->Parts.size(); ++p)
  {
    const Part& part = this->Parts[p];
    const Lattice& lattice = this->GetLattice(part);
    vtkIdType* numbers = this->PlacePoints.data() + this->FirstPlaces[p];
    for (int point = 0; point < static_cast<int>(lattice.Places.size()); ++point)
    {
      const int step = lattice.GetStep(point);
      numbers[point] =
        step < NestedPieces::Steps ? this->FindNumber(this->GetOld(part, point)) : -1;
      if (step == 0)
      {
        this->Corners[numbers[point]] = { part.Cell,
          lattice.Find(Halve(lattice.GetPlaceInChild(part.Child, point))) };
      }
    }
    for (const Lattice::Middle& middle : lattice.Middles[NestedPieces::Steps])
    {
      Parents parents{ { -1, -1, -1, -1 } };
      std::transform(middle.Parents.begin(), middle.Parents.end(), parents.begin(),
        [numbers](int parent) { return parent < 0 ? -1 : numbers[parent]; });
      std::sort(parents.begin(), parents.end());
      places.emplace_back(parents, this->FirstPlaces[p] + middle.Point);
    }
  }
  StableSort(places, std::less<>());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    this->Counts[NestedPieces::Steps] += i == 0 || places[i].first != places[i - 1].first ? 1 : 0;
    this->PlacePoints[places[i].second] = this->Counts[NestedPieces::Steps] - 1;
  }
}

void DeeperPieces::FindPieces()
{
  std::vector<signed char> kinds;
  for (const Part& part : InTurn(this->Parts))
  {
    kinds.push_back(static_cast<signed char>(this->GetLattice(part).ChildKinds[part.Child]));
  }
  this->Pieces =
    std::make_unique<NestedPieces>(std::move(kinds), std::move(this->PlacePoints), this->Counts);
}

/// The point before with the row of a point of a part; `shift` tells how this point moves there.
vtkIdType DeeperPieces::FindRow(const Part& part, int point, Shift& shift) const
{
  const Lattice& lattice = this->GetLattice(part);
  LatticePoint place = lattice.GetPlaceInChild(part.Child, point);
  const bool isInQuad = lattice.Corners > lattice.Dimension + 1 &&
    std::all_of(place.begin(), place.begin() + lattice.Dimension,
      [](int x) { return x % (2 * Divisions) != 0; });
  shift = { part.Cell, lattice.GetWhole(), {}, {} };
  if (isInQuad)
  {
    for (int axis = 0; axis < 2; ++axis)
    {
      shift.Inside[axis] = FindExcess({ { place[axis], 2 * Divisions - place[axis], 0, 0 } })[0];
    }
    place = Add(place, shift.Inside, -1);
  }
  else
  {
    const Weights weights = WeighCorners(lattice, place);
    shift.Corners = FindExcess(weights);
    shift.Face = 0;
    for (int k = 0; k < lattice.Corners; ++k)
    {
      shift.Face |= weights[k] > 0 ? 1U << k : 0U;
      place = Add(place, lattice.CornerPlaces[k], -shift.Corners[k]);
    }
  }
  return this->From.Pieces.GetPoint(
    this->From.Pieces.GetFirstPlace(part.Cell) + lattice.Find(place));
}

/// The multiples that a shift takes of the corners of another cell. Returns false if this cell does
/// not have all corners of the shift, or not as a face.
bool DeeperPieces::Match(const Shift& shift, vtkIdType cell, Weights& corners) const
{
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
  const bool isInQuad = shift.Inside != LatticePoint{};
  return left == 0 && !isInQuad && pieces.GetLattice(cell).Close(found) == found;
}

/// The column that is where another one of the row before was; -1 if no cell tells.
vtkIdType DeeperPieces::ShiftColumn(const Shift& shift, vtkIdType column) const
{
  const NestedPieces& pieces = this->From.Pieces;
  const auto move = [&](vtkIdType at, const Weights& corners)
  {
    const vtkIdType cell = this->From.AllSectors.GetCell(at);
    const vtkIdType first = pieces.GetFirstPlace(cell);
    const Lattice& lattice = pieces.GetLattice(cell);
    LatticePoint place = Add(lattice.Places[at - first], shift.Inside, 1);
    for (int i = 0; i < lattice.Corners; ++i)
    {
      place = Add(place, lattice.CornerPlaces[i], corners[i]);
    }
    return pieces.GetPoint(first + lattice.Find(Halve(place)));
  };
  // Most columns lie in the cell itself.
  const auto places = this->From.AllSectors.GetPlaces(column);
  for (const vtkIdType at : places)
  {
    if (this->From.AllSectors.GetCell(at) == shift.Cell)
    {
      return move(at, shift.Corners);
    }
  }
  Weights corners;
  for (const vtkIdType at : places)
  {
    if (this->Match(shift, this->From.AllSectors.GetCell(at), corners))
    {
      return move(at, corners);
    }
  }
  // A row of a point in an octahedron reads all of it.
  for (const vtkIdType at : places)
  {
    const vtkIdType cell = this->From.AllSectors.GetCell(at);
    const vtkIdType first = pieces.GetFirstQuarter(cell);
    const bool isQuarter = pieces.GetKind(cell) >= Lattice::FirstQuarter;
    for (vtkIdType quarter = first; isQuarter && quarter < first + 4; ++quarter)
    {
      if (quarter == shift.Cell || this->Match(shift, quarter, corners))
      {
        return this->ShiftInOctahedron(
          at, quarter, quarter == shift.Cell ? shift.Corners : corners);
      }
    }
  }
  return -1;
}

/// Moves a place of an octahedron by the multiples that a shift takes of a quarter's corners.
vtkIdType DeeperPieces::ShiftInOctahedron(
  vtkIdType place, vtkIdType quarter, const Weights& corners) const
{
  const NestedPieces& pieces = this->From.Pieces;
  const vtkIdType cell = this->From.AllSectors.GetCell(place);
  LatticePoint at =
    pieces.GetLattice(cell).GetPlaceInSolid(static_cast<int>(place - pieces.GetFirstPlace(cell)));
  const Lattice& lattice = pieces.GetLattice(quarter);
  for (int k = 0; k < lattice.Corners; ++k)
  {
    // A corner is Divisions away from the centre.
    const LatticePoint corner = lattice.GetPlaceInSolid(lattice.GetCornerPoint(k));
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

void DeeperPieces::MakeRows()
{
  const vtkIdType rows = this->Counts[NestedPieces::Steps];
  std::vector<std::pair<int, int>> places(static_cast<std::size_t>(rows), { -1, -1 });
  for (int p = 0; p < static_cast<int>(this->Parts.size()); ++p)
  {
    for (vtkIdType place = this->FirstPlaces[p]; place < this->FirstPlaces[p + 1]; ++place)
    {
      places[this->Pieces->GetPoint(place)] = { p, static_cast<int>(place - this->FirstPlaces[p]) };
    }
  }
  std::vector<std::vector<std::pair<vtkIdType, double>>> found(static_cast<std::size_t>(rows));
  ForEach(rows,
    [&](vtkIdType row)
    {
      Shift shift;
      const vtkIdType known =
        this->FindRow(this->Parts[places[row].first], places[row].second, shift);
      thread_local std::vector<std::pair<vtkIdType, double>> entries;
      entries.clear();
      ForColumns(this->From.Last, this->From.Last.size(), known, 1.,
        [&](vtkIdType column, double weight)
        {
          const vtkIdType old = this->ShiftColumn(shift, column);
          const vtkIdType number = old < 0 ? -1 : this->FindNumber(old);
          const auto at = std::find_if(entries.begin(), entries.end(),
            [number](const auto& entry) { return entry.first == number; });
          if (at == entries.end())
          {
            entries.emplace_back(number, weight);
            return;
          }
          at->second += weight;
        });
      found[row] = entries;
    });
  this->Last.NumberOfColumns = this->Counts[NestedPieces::Steps - 1];
  this->Last.Offsets = Buffer<long long>(rows + 1, 0);
  for (const vtkIdType row : InTurn(rows))
  {
    this->Last.Offsets[row + 1] =
      this->Last.Offsets[row] + static_cast<long long>(found[row].size());
  }
  this->Last.Columns = Buffer<long long>(this->Last.Offsets[rows]);
  this->Last.Weights = Buffer<double>(this->Last.Offsets[rows]);
  ForEach(rows,
    [&](vtkIdType row)
    {
      vtkIdType to = this->Last.Offsets[row];
      for (const auto& [column, weight] : found[row])
      {
        this->Last.Columns[to] = std::max<vtkIdType>(column, 0);
        this->Last.Weights[to++] = column < 0 ? std::numeric_limits<double>::quiet_NaN() : weight;
      }
    });
}

}
