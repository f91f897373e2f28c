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
    this->ReadPieces(roots);
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

void NestedPieces::ReadPieces(const BezierRoots& roots)
{
  std::array<std::vector<LatticePart>, PatchShape::NumberOfKinds> parts;
  this->Places[0].assign(MostCorners, Weights{ { 1., 0., 0., 0. } });
  for (int kind = 0; kind < PatchShape::NumberOfKinds; ++kind)
  {
    const PatchShape& shape = PatchShape::Get(static_cast<PatchShape::Kind>(kind));
    parts[kind] = ListParts(shape, Steps);
    for (const LatticePart& part : parts[kind])
    {
      for (int k = 0; k < MostCorners; ++k)
      {
        const LatticePoint corner = shape.CornerPoints[std::min(k, shape.Corners - 1)];
        this->Places[kind + 1].push_back(WeighCorners(shape, part.At(corner, 2), 1 << Steps));
      }
    }
  }
  this->Firsts.push_back(0);
  for (const signed char kind : InTurn(this->Kinds))
  {
    this->Firsts.push_back(
      this->Firsts.back() + (kind < 0 ? 1 : static_cast<vtkIdType>(parts[kind].size())));
  }
  this->Corners = Buffer<vtkIdType>(MostCorners * this->Firsts.back(), -1);
  ForEach(this->GetNumberOfCells(),
    [&](vtkIdType c)
    {
      vtkIdType* to = this->Corners.data() + MostCorners * this->Firsts[c];
      if (this->Kinds[c] < 0)
      {
        *to = this->GetCorner(c, 0);
        return;
      }
      const Root& root = roots.GetRoot(c);
      const PatchShape& shape = BezierRoots::GetShape(root);
      for (const LatticePart& part : parts[this->Kinds[c]])
      {
        for (int k = 0; k < shape.Corners; ++k)
        {
          to[k] = roots.GetPoint(root, part.At(shape.CornerPoints[k], 2));
        }
        to += MostCorners;
      }
    });
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
