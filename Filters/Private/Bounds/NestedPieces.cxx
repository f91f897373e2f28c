// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bounds/NestedPieces.h"

#include "Private/Bezier/BezierRoots.h"
#include "Private/Reading/CellReader.h"

#include "vtkCellType.h"

#include <algorithm>
#include <iterator>
#include <map>

namespace subdivision
{
namespace
{

/// A place on the lattice of a shape as weights of its corners.
NestedPieces::Weights WeighCorners(const PatchShape& shape, const LatticePoint& point, int all)
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

/// The parts that some steps split a shape into, in the order of cells, on the lattice of all
/// steps.
std::vector<LatticePart> ListParts(const PatchShape& shape, int steps)
{
  LatticePart whole;
  for (int axis = 0; axis < shape.Dimension; ++axis)
  {
    whole.Axes[axis][axis] = 1 << NestedPieces::Steps;
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

/// The pieces that all steps make, and their points in the order in which pieces have them first;
/// `points` gets these on the shape's lattice.
NestedPieces::Lattice MakeLattice(const PatchShape& shape, std::vector<LatticePoint>& points)
{
  NestedPieces::Lattice lattice;
  lattice.Dimension = shape.Dimension;
  lattice.Corners = shape.Corners;
  std::map<LatticePoint, int> numbers;
  for (const LatticePart& part : ListParts(shape, NestedPieces::Steps))
  {
    for (const LatticePoint& corner : shape.CornerPoints)
    {
      const LatticePoint point = part.At(corner, 2);
      const auto [at, isNew] = numbers.try_emplace(point, static_cast<int>(points.size()));
      if (isNew)
      {
        points.push_back(point);
      }
      lattice.Pieces.push_back(at->second);
    }
  }
  for (const LatticePoint& point : points)
  {
    lattice.Points.push_back(WeighCorners(shape, point, 1 << NestedPieces::Steps));
    NestedPieces::Mask face = 0;
    for (int k = 0; k < shape.Corners; ++k)
    {
      face |= lattice.Points.back()[k] > 0. ? 1U << k : 0U;
    }
    lattice.Faces.push_back(face);
  }
  lattice.Neighbours.resize(points.size());
  for (std::size_t piece = 0; piece < lattice.Pieces.size(); piece += shape.Corners)
  {
    const auto begin = lattice.Pieces.begin() + static_cast<std::ptrdiff_t>(piece);
    for (int k = 0; k < shape.Corners; ++k)
    {
      std::vector<int>& neighbours = lattice.Neighbours[begin[k]];
      neighbours.insert(neighbours.end(), begin, begin + shape.Corners);
    }
  }
  for (std::vector<int>& neighbours : lattice.Neighbours)
  {
    std::sort(neighbours.begin(), neighbours.end());
    neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
  }
  return lattice;
}

/// A point that a step makes in the middle of others.
struct MiddlePoint
{
  LatticePoint Point;
  std::vector<LatticePoint> Parents;
};

/// The points of a shape that a step makes.
std::vector<MiddlePoint> ListMiddlePoints(const PatchShape& shape, int step)
{
  std::map<LatticePoint, std::vector<LatticePoint>> found;
  for (const LatticePart& part : ListParts(shape, step - 1))
  {
    for (const LatticePart& child : shape.Children)
    {
      for (const LatticePoint& corner : shape.CornerPoints)
      {
        const LatticePoint place = child.At(corner, 2);
        const NestedPieces::Weights weights = WeighCorners(shape, place, 2);
        std::vector<LatticePoint> parents;
        for (int k = 0; k < shape.Corners; ++k)
        {
          if (weights[k] > 0.)
          {
            parents.push_back(part.At(shape.CornerPoints[k], 2));
          }
        }
        if (parents.size() > 1)
        {
          found.try_emplace(part.At(place, 2), std::move(parents));
        }
      }
    }
  }
  std::vector<MiddlePoint> points;
  for (const auto& [point, parents] : found)
  {
    points.push_back({ point, parents });
  }
  return points;
}

}

NestedPieces::NestedPieces(vtkPointSet* fine, const std::array<vtkIdType, Steps + 1>& points)
  : Points(points)
{
  const BezierRoots roots(fine, Steps);
  this->ReadCells(roots);
  if (this->IsNested)
  {
    this->ReadPlaces(roots);
    this->FindParents(roots, 2);
    this->FindParents(roots, 3);
  }
}

void NestedPieces::ReadCells(const BezierRoots& roots)
{
  std::vector<vtkIdType> ids;
  for (const vtkIdType r : InTurn(roots.GetNumberOfRoots()))
  {
    const Root& root = roots.GetRoot(r);
    this->IsNested =
      this->IsNested && (root.Kind < 0 ? roots.GetType(root) == VTK_VERTEX : root.Steps == Steps);
    if (!this->IsNested)
    {
      return;
    }
    this->Kinds.push_back(static_cast<signed char>(root.Kind));
    if (root.Kind < 0)
    {
      roots.GetPoints(root, ids);
      this->CellCorners.push_back(ids[0]);
    }
    else
    {
      this->Has[root.Kind] = true;
      const LatticePart whole = roots.GetWhole(root);
      for (const LatticePoint& corner : BezierRoots::GetShape(root).CornerPoints)
      {
        this->CellCorners.push_back(roots.GetPoint(root, whole.At(corner, 2)));
      }
    }
    this->CellCorners.resize(MostCorners * this->Kinds.size(), -1);
  }
}

bool NestedPieces::AreOf(vtkPointSet* mesh) const
{
  const CellReader cells(mesh);
  if (!this->IsNested || cells.GetNumberOfCells() != this->GetNumberOfCells())
  {
    return false;
  }
  std::vector<vtkIdType> scratch;
  for (const vtkIdType c : InTurn(this->GetNumberOfCells()))
  {
    const CellIds cell = cells.GetCell(c, scratch);
    if (cell.Size != this->GetNumberOfCorners(c) ||
      !std::equal(cell.Ids, cell.Ids + cell.Size, this->CellCorners.data() + MostCorners * c))
    {
      return false;
    }
  }
  return true;
}

void NestedPieces::ReadPlaces(const BezierRoots& roots)
{
  std::array<std::vector<LatticePoint>, PatchShape::NumberOfKinds> points;
  this->Lattices[0].Points.push_back({ { 1., 0., 0., 0. } });
  this->Lattices[0].Faces.push_back(1);
  this->Lattices[0].Neighbours.push_back({ 0 });
  this->Lattices[0].Pieces.push_back(0);
  for (int kind = 0; kind < PatchShape::NumberOfKinds; ++kind)
  {
    this->Lattices[kind + 1] =
      MakeLattice(PatchShape::Get(static_cast<PatchShape::Kind>(kind)), points[kind]);
  }
  this->FirstPlaces.push_back(0);
  for (const vtkIdType c : InTurn(this->GetNumberOfCells()))
  {
    this->FirstPlaces.push_back(
      this->FirstPlaces.back() + static_cast<vtkIdType>(this->GetLattice(c).Points.size()));
  }
  this->PlacePoints = Buffer<vtkIdType>(this->FirstPlaces.back());
  ForEach(this->GetNumberOfCells(),
    [&](vtkIdType c)
    {
      vtkIdType* to = this->PlacePoints.data() + this->FirstPlaces[c];
      if (this->Kinds[c] < 0)
      {
        *to = this->GetCorner(c, 0);
        return;
      }
      const Root& root = roots.GetRoot(c);
      for (const LatticePoint& point : points[this->Kinds[c]])
      {
        *to++ = roots.GetPoint(root, point);
      }
    });
}

NestedPieces::Mask NestedPieces::Lattice::Close(Mask corners) const
{
  // Of two opposite corners of a quad, or three of them, that is the quad. All other sets are
  // faces.
  const bool isFace = (corners & (corners - 1U)) == 0 || corners == 3U || corners == 6U ||
    corners == 12U || corners == 9U;
  return this->Dimension == 2 && this->Corners == 4 && !isFace ? this->GetWhole() : corners;
}

/// All cells that have a new point find the same parents.
void NestedPieces::FindParents(const BezierRoots& roots, int step)
{
  const vtkIdType before = this->Points[step - 1];
  this->Parents[step] = Buffer<vtkIdType>(MostCorners * (this->Points[step] - before), -1);
  std::array<std::vector<MiddlePoint>, PatchShape::NumberOfKinds> points;
  for (int kind = 0; kind < PatchShape::NumberOfKinds; ++kind)
  {
    points[kind] = ListMiddlePoints(PatchShape::Get(static_cast<PatchShape::Kind>(kind)), step);
  }
  for (const vtkIdType c : InTurn(this->GetNumberOfCells()))
  {
    if (this->Kinds[c] < 0)
    {
      continue;
    }
    const Root& root = roots.GetRoot(c);
    for (const MiddlePoint& middle : points[this->Kinds[c]])
    {
      vtkIdType* parents =
        this->Parents[step].data() + MostCorners * (roots.GetPoint(root, middle.Point) - before);
      if (parents[0] < 0)
      {
        vtkIdType* end = parents;
        for (const LatticePoint& parent : middle.Parents)
        {
          *end++ = roots.GetPoint(root, parent);
        }
        std::sort(parents, end);
      }
    }
  }
}

}
