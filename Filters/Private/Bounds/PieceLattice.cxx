// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bounds/PieceLattice.h"

#include "Private/Bounds/TetOctPieces.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>

namespace subdivision
{
namespace
{

/// A place on the lattice of a shape as weights of its corners.
PieceLattice::Weights WeighCorners(const PatchShape& shape, const LatticePoint& point, int all)
{
  const auto divide = [all](int x) { return static_cast<double>(x) / all; };
  const double x = divide(point[0]);
  const double y = divide(point[1]);
  if (shape.Corners > shape.Dimension + 1)
  {
    return { { (1. - x) * (1. - y), x * (1. - y), x * y, (1. - x) * y } };
  }
  return { { divide(all - point[0] - point[1] - point[2]), x, y, divide(point[2]) } };
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

/// Where a corner of a part is that is no quad.
LatticePoint GetCorner(const LatticePart& part, int corner)
{
  LatticePoint place = part.Origin;
  for (int x = 0; corner > 0 && x < 3; ++x)
  {
    place[x] += part.Axes[corner - 1][x];
  }
  return place;
}

/// The three lines, or nine triangles, in which the edges of one are cut into thirds.
std::vector<LatticePart> ListThirds(int dimension, int divisions)
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
  const int third = divisions / 3;
  for (int y = 0; y < (dimension == 2 ? divisions : 1); y += third)
  {
    for (int x = 0; x + y < divisions; x += third)
    {
      add(x, y, third);
      if (dimension == 2 && x + y + third < divisions)
      {
        add(x + third, y + third, -third); // turned by half a turn
      }
    }
  }
  return parts;
}

int Number(const LatticePoint& place, int side)
{
  return place[0] + side * (place[1] + side * place[2]);
}

}

int PieceLattice::AddPoint(const LatticePoint& place)
{
  int& number = this->Numbers[Number(place, this->GetSide())];
  if (number < 0)
  {
    number = static_cast<int>(this->Places.size());
    this->Places.push_back(place);
  }
  return number;
}

/// The points in the order in which pieces have them first.
void PieceLattice::AddPieces(const PatchShape& shape)
{
  const int side = this->GetSide();
  this->Numbers.assign(side * side * side, -1);
  for (const LatticePart& part : ListParts(shape, Steps, Divisions))
  {
    for (const LatticePoint& corner : shape.CornerPoints)
    {
      this->Pieces.push_back(this->AddPoint(part.At(corner, 2)));
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
  const int side = lattice.GetSide();
  lattice.Numbers.assign(side * side * side, -1);
  lattice.AddPoint({ { 0, 0, 0 } });
  lattice.Points.push_back({ { 1., 0., 0., 0. } });
  lattice.Faces.push_back(1);
  lattice.Neighbours.push_back({ 0 });
  lattice.Pieces.push_back(0);
  lattice.Children.emplace_back();
  lattice.ChildKinds.push_back(-1);
  return lattice;
}

void PieceLattice::WeighPoints(const PatchShape& shape)
{
  for (const LatticePoint& place : this->Places)
  {
    this->Points.push_back(WeighCorners(shape, place, this->Size));
    Mask face = 0;
    for (int k = 0; k < shape.Corners; ++k)
    {
      face |= this->Points.back()[k] > 0. ? 1U << k : 0U;
    }
    this->Faces.push_back(face);
  }
}

void PieceLattice::PlaceCorners(const PatchShape& shape)
{
  for (int k = 0; k < shape.Corners; ++k)
  {
    for (int axis = 0; axis < shape.Dimension; ++axis)
    {
      this->CornerPlaces[k][axis] = shape.CornerPoints[k][axis] / 2;
    }
  }
}

PieceLattice PieceLattice::Make(const PatchShape& shape)
{
  PieceLattice lattice;
  lattice.Dimension = shape.Dimension;
  lattice.Corners = shape.Corners;
  lattice.AddPieces(shape);
  lattice.WeighPoints(shape);
  lattice.AddNeighbours();
  for (int step = 1; step <= Steps; ++step)
  {
    lattice.Middles[step] = lattice.ListMiddles(shape, step);
  }
  lattice.PlaceCorners(shape);
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

/// The points at the thirds of the edges of a line or triangle, and in its middle.
void PieceLattice::AddThirds(int step, const LatticePart& part)
{
  const auto add = [&](const std::array<int, 3>& parents)
  {
    LatticePoint sum{ { 0, 0, 0 } };
    Middle middle{ -1, { { -1, -1, -1, -1 } } };
    for (std::size_t i = 0; i < 3; ++i)
    {
      const LatticePoint corner = GetCorner(part, parents[i]);
      middle.Parents[i] = this->AddPoint(corner);
      std::transform(sum.begin(), sum.end(), corner.begin(), sum.begin(), std::plus<>());
    }
    middle.Point = this->AddPoint({ { sum[0] / 3, sum[1] / 3, sum[2] / 3 } });
    this->Middles[step].push_back(middle);
  };
  for (int near = 0; near < this->Corners; ++near)
  {
    for (int far = 0; far < this->Corners; ++far)
    {
      if (near != far)
      {
        add({ { near, near, far } });
      }
    }
  }
  if (this->Corners == 3)
  {
    add({ { 0, 1, 2 } });
  }
}

/// A line or triangle whose edges two steps cut into thirds, and these again.
PieceLattice PieceLattice::MakeInThirds(int kind)
{
  const PatchShape& shape =
    PatchShape::Get(kind == CurveInThirds ? PatchShape::Curve : PatchShape::Triangle);
  PieceLattice lattice;
  lattice.Dimension = shape.Dimension;
  lattice.Corners = shape.Corners;
  lattice.Size = DivisionsInThirds;
  const int side = lattice.GetSide();
  lattice.Numbers.assign(side * side * side, -1);
  lattice.PlaceCorners(shape);
  lattice.Children = ListThirds(shape.Dimension, lattice.Size);
  lattice.ChildKinds.assign(lattice.Children.size(), kind);
  LatticePart whole;
  for (int axis = 0; axis < shape.Dimension; ++axis)
  {
    whole.Axes[axis][axis] = lattice.Size;
  }
  lattice.AddThirds(2, whole);
  for (const LatticePart& child : lattice.Children)
  {
    lattice.AddThirds(3, child);
    for (const LatticePart& piece : lattice.Children)
    {
      for (int k = 0; k < shape.Corners; ++k)
      {
        lattice.Pieces.push_back(lattice.Find(child.At(GetCorner(piece, k), lattice.Size)));
      }
    }
  }
  lattice.WeighPoints(shape);
  lattice.AddNeighbours();
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

/// As any tetrahedron, but for neighbours. With their order of corners the children of a quarter
/// lie in quarters and tetrahedra of the next levels (Mathematics 14).
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

/// Finds the kinds of the children of a tet/oct solid, and gives quarters among them the order of
/// corners that quarters have: an end of the diagonal first, and the other one third.
void PieceLattice::TurnChildren()
{
  this->ChildKinds.assign(this->Children.size(), TetOctTetrahedron);
  const auto turn = [this](int child, int kind, const std::array<int, 4>& corners)
  {
    LatticePart& part = this->Children[child];
    const auto getCorner = [of = part](int corner) { return GetCorner(of, corner); };
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
    MakeInThirds(CurveInThirds), MakeInThirds(TriangleInThirds), MakeOfTetOct(TetOctTetrahedron),
    MakeOfTetOct(FirstQuarter), MakeOfTetOct(FirstQuarter + 1), MakeOfTetOct(FirstQuarter + 2),
    MakeOfTetOct(FirstQuarter + 3) };
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
  const int side = this->GetSide();
  const bool isInside =
    std::all_of(place.begin(), place.end(), [side](int x) { return x >= 0 && x < side; });
  return isInside ? this->Numbers[Number(place, side)] : -1;
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
