// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bounds/PieceLattice.h"

#include "Private/Bounds/TetOctPieces.h"

#include <algorithm>
#include <iterator>
#include <map>

namespace subdivision
{
namespace
{

/// A place on the lattice of a shape as weights of its corners.
PieceLattice::Weights WeighCorners(const PatchShape& shape, const LatticePoint& point, int all)
{
  const double x = static_cast<double>(point[0]) / all;
  const double y = static_cast<double>(point[1]) / all;
  const double z = static_cast<double>(point[2]) / all;
  if (shape.Corners > shape.Dimension + 1)
  {
    return { { (1. - x) * (1. - y), x * (1. - y), x * y, (1. - x) * y } };
  }
  return { { 1. - x - y - z, x, y, z } };
}

/// The parts that some steps split a shape into, in the order of cells, on a lattice of so many
/// divisions.
std::vector<LatticePart> ListParts(const PatchShape& shape, int steps, int divisions)
{
  LatticePart whole;
  for (int axis = 0; axis < shape.Dimension; ++axis)
  {
    whole.Axes[axis][axis] = divisions;
  }
  std::vector<LatticePart> parts{ whole };
  for (int step = 0; step < steps; ++step)
  {
    std::vector<LatticePart> children;
    for (const LatticePart& part : parts)
    {
      std::transform(shape.Children.begin(), shape.Children.end(), std::back_inserter(children),
        [&part](const LatticePart& child) { return part.Take(child); });
    }
    parts = std::move(children);
  }
  return parts;
}

int Number(const LatticePoint& place, int side)
{
  return place[0] + side * (place[1] + side * place[2]);
}

}

/// The points in the order in which pieces have them first.
void PieceLattice::AddPieces(const PatchShape& shape)
{
  this->Numbers.assign(Side * Side * Side, -1);
  for (const LatticePart& part : ListParts(shape, Steps, Divisions))
  {
    for (const LatticePoint& corner : shape.CornerPoints)
    {
      const LatticePoint place = part.At(corner, 2);
      int& number = this->Numbers[Number(place, Side)];
      if (number < 0)
      {
        number = static_cast<int>(this->Places.size());
        this->Places.push_back(place);
      }
      this->Pieces.push_back(number);
    }
  }
}

void PieceLattice::AddNeighbours()
{
  this->Neighbours.resize(this->Places.size());
  for (std::size_t piece = 0; piece < this->Pieces.size(); piece += this->Corners)
  {
    const auto begin = this->Pieces.begin() + static_cast<std::ptrdiff_t>(piece);
    for (int k = 0; k < this->Corners; ++k)
    {
      std::vector<int>& neighbours = this->Neighbours[begin[k]];
      neighbours.insert(neighbours.end(), begin, begin + this->Corners);
    }
  }
  this->SortNeighbours();
}

void PieceLattice::SortNeighbours()
{
  for (std::vector<int>& neighbours : this->Neighbours)
  {
    std::sort(neighbours.begin(), neighbours.end());
    neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
  }
}

std::vector<PieceLattice::Middle> PieceLattice::ListMiddles(const PatchShape& shape, int step) const
{
  std::map<int, Middle> found;
  for (const LatticePart& part : ListParts(shape, step - 1, Divisions))
  {
    for (const LatticePart& child : shape.Children)
    {
      for (const LatticePoint& corner : shape.CornerPoints)
      {
        const LatticePoint place = child.At(corner, 2);
        const Weights weights = WeighCorners(shape, place, 2);
        Middle middle{ this->Find(part.At(place, 2)), { { -1, -1, -1, -1 } } };
        int parents = 0;
        for (int k = 0; k < shape.Corners; ++k)
        {
          if (weights[k] > 0.)
          {
            middle.Parents[parents++] = this->Find(part.At(shape.CornerPoints[k], 2));
          }
        }
        if (parents > 1)
        {
          found.try_emplace(middle.Point, middle);
        }
      }
    }
  }
  std::vector<Middle> middles;
  std::transform(found.begin(), found.end(), std::back_inserter(middles),
    [](const auto& entry) { return entry.second; });
  return middles;
}

PieceLattice PieceLattice::MakeVertex()
{
  PieceLattice lattice;
  lattice.Numbers.assign(Side * Side * Side, -1);
  lattice.Numbers[0] = 0;
  lattice.Places.push_back({ { 0, 0, 0 } });
  lattice.Points.push_back({ { 1., 0., 0., 0. } });
  lattice.Faces.push_back(1);
  lattice.Neighbours.push_back({ 0 });
  lattice.Pieces.push_back(0);
  lattice.Children.emplace_back();
  lattice.ChildKinds.push_back(-1);
  return lattice;
}

PieceLattice PieceLattice::Make(const PatchShape& shape)
{
  PieceLattice lattice;
  lattice.Dimension = shape.Dimension;
  lattice.Corners = shape.Corners;
  lattice.AddPieces(shape);
  for (const LatticePoint& place : lattice.Places)
  {
    lattice.Points.push_back(WeighCorners(shape, place, Divisions));
    Mask face = 0;
    for (int k = 0; k < shape.Corners; ++k)
    {
      face |= lattice.Points.back()[k] > 0. ? 1U << k : 0U;
    }
    lattice.Faces.push_back(face);
  }
  lattice.AddNeighbours();
  for (int step = 1; step <= Steps; ++step)
  {
    lattice.Middles[step] = lattice.ListMiddles(shape, step);
  }
  for (int k = 0; k < shape.Corners; ++k)
  {
    for (int axis = 0; axis < shape.Dimension; ++axis)
    {
      lattice.CornerPlaces[k][axis] = shape.CornerPoints[k][axis] / 2;
    }
  }
  lattice.Children = ListParts(shape, 1, 2 * Divisions);
  const auto all = PatchShape::NumberOfKinds;
  for (int kind = 0; kind < all && lattice.ChildKinds.empty(); ++kind)
  {
    if (&shape == &PatchShape::Get(static_cast<PatchShape::Kind>(kind)))
    {
      lattice.ChildKinds.assign(lattice.Children.size(), kind);
    }
  }
  return lattice;
}

/// Where a point is in an octahedron (TetOctPieces) that has this as one of its quarters; itself
/// where `quarter` is negative.
LatticePoint PieceLattice::GetPlaceInQuarter(int quarter, int point) const
{
  if (quarter < 0)
  {
    return this->Places[point];
  }
  LatticePoint place{ { 0, 0, 0 } };
  for (int k = 0; k < this->Corners; ++k)
  {
    const auto multiple = static_cast<int>(this->Points[point][k] * Divisions);
    const TetOctPieces::Place vertex =
      TetOctPieces::GetVertex(TetOctPieces::GetQuarters()[quarter][k]);
    for (int axis = 0; axis < 3; ++axis)
    {
      place[axis] += multiple * vertex[axis];
    }
  }
  return place;
}

/// As any tetrahedron, but for neighbours. The order of corners of a quarter is such that its
/// children lie in quarters and tetrahedra of the next levels (Mathematics 14).
PieceLattice PieceLattice::MakeOfTetOct(int kind)
{
  PieceLattice lattice = Make(PatchShape::Get(PatchShape::Tetrahedron));
  const int quarter = kind - FirstQuarter;
  lattice.Quarter = quarter;
  const int size = static_cast<int>(lattice.Places.size());
  std::map<LatticePoint, int>& points = lattice.PointsOfSolid; // its own where it has them
  const auto add = [&](int of)
  {
    for (int point = 0; point < size; ++point)
    {
      points.try_emplace(lattice.GetPlaceInQuarter(of, point), point + size * (of - quarter));
    }
  };
  add(quarter);
  for (int other = 0; quarter >= 0 && other < 4; ++other)
  {
    add(other);
  }
  for (std::vector<int>& neighbours : lattice.Neighbours)
  {
    neighbours.clear();
  }
  for (const TetOctPieces::Solid& solid : TetOctPieces::Get(quarter >= 0).Solids)
  {
    for (int i = 0; i < solid.CountCorners(); ++i)
    {
      const int point = points.at(solid.Corners[i]);
      for (int j = 0; point >= 0 && point < size && j < solid.CountCorners(); ++j)
      {
        lattice.Neighbours[point].push_back(points.at(solid.Corners[j]));
      }
    }
  }
  lattice.SortNeighbours();
  lattice.TurnChildren();
  return lattice;
}

/// Finds the kinds of the children of a tet/oct solid, and gives those that are quarters the order
/// of corners that quarters have: an end of the diagonal first, and the other one third.
void PieceLattice::TurnChildren()
{
  this->ChildKinds.assign(this->Children.size(), TetOctTetrahedron);
  const auto turn = [this](int child, int kind, const std::array<int, 4>& corners)
  {
    LatticePart& part = this->Children[child];
    const auto getCorner = [of = part](int corner)
    {
      LatticePoint place = of.Origin;
      for (int x = 0; corner > 0 && x < 3; ++x)
      {
        place[x] += of.Axes[corner - 1][x];
      }
      return place;
    };
    part.Origin = getCorner(corners[0]);
    for (int axis = 0; axis < 3; ++axis)
    {
      const LatticePoint end = getCorner(corners[axis + 1]);
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
  static const std::array<PieceLattice, NumberOfKinds + 1> all{ MakeVertex(),
    Make(PatchShape::Get(PatchShape::Curve)), Make(PatchShape::Get(PatchShape::Triangle)),
    Make(PatchShape::Get(PatchShape::Quad)), Make(PatchShape::Get(PatchShape::Tetrahedron)),
    MakeOfTetOct(TetOctTetrahedron), MakeOfTetOct(FirstQuarter), MakeOfTetOct(FirstQuarter + 1),
    MakeOfTetOct(FirstQuarter + 2), MakeOfTetOct(FirstQuarter + 3) };
  return all[kind + 1];
}

PieceLattice::Mask PieceLattice::Close(Mask corners) const
{
  // Of two opposite corners of a quad, or three of them, that is the quad. All other sets are
  // faces.
  const bool isFace = (corners & (corners - 1U)) == 0 || corners == 3U || corners == 6U ||
    corners == 12U || corners == 9U;
  return this->Dimension == 2 && this->Corners == 4 && !isFace ? this->GetWhole() : corners;
}

int PieceLattice::Find(const LatticePoint& place) const
{
  const bool isInside =
    std::all_of(place.begin(), place.end(), [](int x) { return x >= 0 && x < Side; });
  return isInside ? this->Numbers[Number(place, Side)] : -1;
}

int PieceLattice::GetStep(int point) const
{
  int step = Steps;
  const LatticePoint& place = this->Places[point];
  for (int size = 2;
    step > 0 && std::all_of(place.begin(), place.end(), [size](int x) { return x % size == 0; });
    size *= 2)
  {
    --step;
  }
  return step;
}

}
