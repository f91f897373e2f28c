// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bounds/PieceLattice.h"

#include "Private/Bounds/TetOctPieces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace subdivision
{
namespace
{

/// The parts into which some steps cut a cell, in the order of cells, on a lattice of so many
/// divisions. `children`: the parts of one step, on the lattice of `cuts` divisions.
std::vector<LatticePart> ListParts(
  int dimension, int steps, int divisions, const std::vector<LatticePart>& children, int cuts)
{
  std::vector<LatticePart> parts(1);
  for (int axis = 0; axis < dimension; ++axis)
  {
    parts[0].Axes[axis][axis] = divisions;
  }
  for (int step = 0; step < steps; ++step)
  {
    std::vector<LatticePart> next;
    for (const LatticePart& part : parts)
    {
      for (const LatticePart& child : children)
      {
        next.push_back(part.Take(child, cuts));
      }
    }
    parts = std::move(next);
  }
  return parts;
}

/// The three lines, or nine triangles, in which the edges of one are cut into thirds.
std::vector<LatticePart> ListThirds(int dimension)
{
  std::vector<LatticePart> parts;
  const auto add = [&](int x, int y, int size)
  {
    LatticePart part;
    part.Origin = { { x, y, 0 } };
    for (int axis = 0; axis < dimension; ++axis)
    {
      part.Axes[axis][axis] = size;
    }
    parts.push_back(part);
  };
  for (int y = 0; y < (dimension == 2 ? 3 : 1); ++y)
  {
    for (int x = 0; x + y < 3; ++x)
    {
      add(x, y, 1);
      if (dimension == 2 && x + y < 2)
      {
        add(x + 1, y + 1, -1); // turned by half a turn
      }
    }
  }
  return parts;
}

PatchShape::Kind GetShape(int kind)
{
  if (kind < PatchShape::NumberOfKinds)
  {
    return static_cast<PatchShape::Kind>(kind);
  }
  return kind == PieceLattice::CurveInThirds ? PatchShape::Curve
    : kind == PieceLattice::TriangleInThirds ? PatchShape::Triangle
                                             : PatchShape::Tetrahedron;
}

int Number(const FrameNode& place, int side)
{
  return place[0] + side * (place[1] + side * place[2]);
}

}

PieceLattice PieceLattice::Make(int kind)
{
  PieceLattice lattice;
  std::vector<LatticePart> children(1); // a vertex stays
  int steps = Steps;                    // that cut the cell
  if (kind >= 0)
  {
    const PatchShape& shape = PatchShape::Get(GetShape(kind));
    lattice.Dimension = shape.Dimension;
    lattice.Corners = shape.Corners;
    for (int k = 0; k < shape.Corners; ++k)
    {
      std::transform(shape.CornerPoints[k].begin(), shape.CornerPoints[k].end(),
        lattice.CornerPlaces[k].begin(), [](int x) { return x / 2; });
    }
    children = shape.Children;
  }
  if (kind == CurveInThirds || kind == TriangleInThirds)
  {
    lattice.Cuts = 3;
    lattice.Size = DivisionsInThirds;
    children = ListThirds(lattice.Dimension);
    steps = 2;
  }
  const auto listParts = [&](int times, int divisions)
  { return ListParts(lattice.Dimension, times, divisions, children, lattice.Cuts); };
  lattice.AddPoints(listParts(steps, lattice.Size));
  for (int times = 0; times < steps; ++times)
  {
    lattice.AddMiddles(Steps - steps + times + 1, listParts(times, lattice.Size), children);
  }
  lattice.Children = listParts(1, lattice.Cuts * lattice.Size);
  lattice.ChildKinds.assign(lattice.Children.size(), kind);
  lattice.Neighbours.resize(lattice.Places.size());
  if (kind < TetOctTetrahedron)
  {
    lattice.AddNeighbours();
  }
  else
  {
    lattice.Quarter = kind - FirstQuarter;
    lattice.AddNeighboursInSolids();
    lattice.TurnChildren();
  }
  for (std::vector<int>& neighbours : lattice.Neighbours)
  {
    std::sort(neighbours.begin(), neighbours.end());
    neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
  }
  return lattice;
}

int PieceLattice::AddPoint(const FrameNode& place)
{
  int& number = this->Numbers[Number(place, this->Size + 1)];
  if (number < 0)
  {
    number = this->CountPoints();
    this->Places.push_back(place);
    this->Points.push_back(this->WeighCorners(place, this->Size));
    this->Faces.push_back(0);
    for (int k = 0; k < this->Corners; ++k)
    {
      this->Faces.back() |= this->Points.back()[k] > 0. ? 1U << k : 0U;
    }
  }
  return number;
}

/// The points in the order in which pieces have them first.
void PieceLattice::AddPoints(const std::vector<LatticePart>& pieces)
{
  const int side = this->Size + 1;
  this->Numbers.assign(side * side * side, -1);
  for (const LatticePart& piece : pieces)
  {
    for (int k = 0; k < this->Corners; ++k)
    {
      this->Pieces.push_back(this->AddPoint(piece.At(this->CornerPlaces[k], 1)));
    }
  }
  for (int k = 0; k < this->Corners; ++k)
  {
    const FrameNode& unit = this->CornerPlaces[k];
    this->CornerPoints[k] =
      this->Find({ { this->Size * unit[0], this->Size * unit[1], this->Size * unit[2] } });
  }
}

void PieceLattice::AddNeighbours()
{
  for (std::size_t piece = 0; piece < this->Pieces.size(); piece += this->Corners)
  {
    const auto begin = this->Pieces.begin() + static_cast<std::ptrdiff_t>(piece);
    for (int k = 0; k < this->Corners; ++k)
    {
      std::vector<int>& neighbours = this->Neighbours[begin[k]];
      neighbours.insert(neighbours.end(), begin, begin + this->Corners);
    }
  }
}

/// Adds the points that a step makes of parts. A part and its neighbours make the same ones.
void PieceLattice::AddMiddles(
  int step, const std::vector<LatticePart>& parts, const std::vector<LatticePart>& children)
{
  std::map<int, Middle> found;
  for (const LatticePart& part : parts)
  {
    for (const LatticePart& child : children)
    {
      for (int k = 0; k < this->Corners; ++k)
      {
        const FrameNode place = child.At(this->CornerPlaces[k], 1);
        const Weights weights = this->WeighCorners(place, this->Cuts);
        double least = 1.; // of the parents; others have multiples of it
        for (const double weight : weights)
        {
          least = weight > 0. ? std::min(least, weight) : least;
        }
        Middle middle{ this->Find(part.At(place, this->Cuts)), { { -1, -1, -1, -1 } } };
        int parents = 0;
        for (int of = 0; of < this->Corners; ++of)
        {
          for (auto left = std::lround(weights[of] / least); left > 0; --left)
          {
            middle.Parents[parents++] = this->Find(part.At(this->CornerPlaces[of], 1));
          }
        }
        if (parents > 1)
        {
          found.try_emplace(middle.Point, middle);
        }
      }
    }
  }
  for (const auto& entry : found)
  {
    this->Middles[step].push_back(entry.second);
  }
}

/// Where a point is in an octahedron (TetOctPieces) that has this as one of its quarters; where the
/// point is in the cell, where `quarter` is negative.
FrameNode PieceLattice::GetPlaceInQuarter(int quarter, int point) const
{
  if (quarter < 0)
  {
    return this->Places[point];
  }
  FrameNode place{ { 0, 0, 0 } };
  for (int k = 0; k < this->Corners; ++k)
  {
    const auto multiple = static_cast<int>(this->Points[point][k] * Divisions);
    const FrameNode vertex = TetOctPieces::GetVertex(TetOctPieces::GetQuarters()[quarter][k]);
    for (int axis = 0; axis < 3; ++axis)
    {
      place[axis] += multiple * vertex[axis];
    }
  }
  return place;
}

/// The neighbours in a tet/oct solid.
void PieceLattice::AddNeighboursInSolids()
{
  const int size = this->CountPoints();
  const auto add = [&](int of)
  {
    for (int point = 0; point < size; ++point)
    {
      this->PointsOfSolid.try_emplace(
        this->GetPlaceInQuarter(of, point), point + size * (of - this->Quarter));
    }
  };
  add(this->Quarter); // its own points, where it has them
  for (int other = 0; this->Quarter >= 0 && other < 4; ++other)
  {
    add(other);
  }
  const CellShape shape = this->Quarter < 0 ? CellShape::Tet : CellShape::Octahedron;
  for (const LatticeCell& solid : ListLatticeCells(shape, SplitOrder::TetOct, Steps))
  {
    const int corners = GetCellTable(solid.Shape).Corners;
    for (int i = 0; i < corners; ++i)
    {
      const int point = this->PointsOfSolid.at(solid.Corners[i]);
      for (int j = 0; this->Has(point) && j < corners; ++j)
      {
        this->Neighbours[point].push_back(this->PointsOfSolid.at(solid.Corners[j]));
      }
    }
  }
}

/// Finds the kinds of the children of a tet/oct solid, and gives quarters among them the order of
/// corners that quarters have: an end of the diagonal first, and the other one third.
void PieceLattice::TurnChildren()
{
  this->ChildKinds.assign(this->Children.size(), TetOctTetrahedron);
  const auto turn = [this](int child, int kind, const std::array<int, 4>& corners)
  {
    LatticePart& part = this->Children[child];
    const auto getCorner = [this, of = part](int corner)
    { return of.At(this->CornerPlaces[corner], 1); };
    part.Origin = getCorner(corners[0]);
    for (int axis = 0; axis < 3; ++axis)
    {
      const FrameNode end = getCorner(corners[axis + 1]);
      for (int x = 0; x < 3; ++x)
      {
        part.Axes[axis][x] = end[x] - part.Origin[x];
      }
    }
    this->ChildKinds[child] = FirstQuarter + kind;
  };
  if (this->Quarter < 0)
  {
    // The four around the diagonal, one after the other.
    turn(4, 0, { { 1, 2, 3, 0 } });
    turn(6, 1, { { 0, 3, 2, 1 } });
    turn(7, 2, { { 2, 1, 0, 3 } });
    turn(5, 3, { { 1, 2, 3, 0 } });
    return;
  }
  for (int child = 0; child < 4; ++child)
  {
    this->ChildKinds[child] = FirstQuarter + this->Quarter;
  }
  turn(5, (this->Quarter + 3) % 4, { { 2, 3, 0, 1 } });
  turn(6, (this->Quarter + 1) % 4, { { 1, 0, 3, 2 } });
}

std::vector<PieceLattice::QuarterChild> PieceLattice::ListOctahedron(int child) const
{
  std::vector<QuarterChild> found;
  if (this->ChildKinds[child] < FirstQuarter)
  {
    return found;
  }
  if (this->Quarter < 0)
  {
    return { { 0, 4 }, { 0, 6 }, { 0, 7 }, { 0, 5 } };
  }
  const auto add = [&](int quarter, int number)
  { found.push_back({ quarter % 4 - this->Quarter, number }); };
  if (child == 0 || child == 2) // at an end of the diagonal
  {
    for (int quarter = 0; quarter < 4; ++quarter)
    {
      add(quarter, child);
    }
    return found;
  }
  // At the last corner of a quarter, which is the second one of the quarter before.
  const int at = child == 3 || child == 6 ? this->Quarter : (this->Quarter + 1) % 4;
  std::array<std::array<int, 2>, 4> of{};
  of[at] = { { at, 3 } };
  of[(at + 1) % 4] = { { at, 6 } };
  of[(at + 3) % 4] = { { at + 3, 1 } };
  of[(at + 2) % 4] = { { at + 3, 5 } };
  for (const auto& [quarter, number] : of)
  {
    add(quarter, number);
  }
  return found;
}

const PieceLattice& PieceLattice::Get(int kind)
{
  static const std::vector<PieceLattice> all = []
  {
    std::vector<PieceLattice> made;
    for (int k = -1; k < NumberOfKinds; ++k)
    {
      made.push_back(Make(k));
    }
    return made;
  }();
  return all[kind + 1];
}

PieceLattice::Mask PieceLattice::Close(Mask corners) const
{
  // The quad itself has two opposite corners, or three corners. All other sets are faces.
  const bool isFace = (corners & (corners - 1U)) == 0 || corners == 3U || corners == 6U ||
    corners == 12U || corners == 9U;
  return this->IsQuad() && !isFace ? this->GetWhole() : corners;
}

PieceLattice::Weights PieceLattice::WeighCorners(const FrameNode& place, int divisions) const
{
  const auto divide = [divisions](int x) { return static_cast<double>(x) / divisions; };
  const double x = divide(place[0]);
  const double y = divide(place[1]);
  if (this->IsQuad())
  {
    return { { (1. - x) * (1. - y), x * (1. - y), x * y, (1. - x) * y } };
  }
  return { { divide(divisions - place[0] - place[1] - place[2]), x, y, divide(place[2]) } };
}

int PieceLattice::Find(const FrameNode& place) const
{
  const int side = this->Size + 1;
  const bool isInside =
    std::all_of(place.begin(), place.end(), [side](int x) { return x >= 0 && x < side; });
  return isInside ? this->Numbers[Number(place, side)] : -1;
}

int PieceLattice::FindOfChild(int child, int point) const
{
  FrameNode place = this->GetPlaceInChild(child, point);
  for (int& x : place)
  {
    if (x % this->Cuts != 0)
    {
      return -1;
    }
    x /= this->Cuts;
  }
  return this->Find(place);
}

int PieceLattice::GetStep(int point) const
{
  int step = Steps;
  const FrameNode& place = this->Places[point];
  for (int size = this->Cuts; size <= this->Size &&
    std::all_of(place.begin(), place.end(), [size](int x) { return x % size == 0; });
    size *= this->Cuts)
  {
    --step;
  }
  return step;
}

}
