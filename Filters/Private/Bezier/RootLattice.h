// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RootLattice.h
 * The lattice of a cell that was split some times, and which of its cells have its points.
 */
#ifndef SubdivisionObjects_RootLattice_h
#define SubdivisionObjects_RootLattice_h

#include "Core/Memory/Buffer.h"
#include "Private/Bezier/PatchShape.h"

namespace subdivision
{

/// Which corner of which cell of a root each point of its lattice is: 4 * cell + corner.
class RootLattice
{
public:
  RootLattice(const PatchShape& shape, int steps)
    : Shape(shape)
    , Size((1 << steps) + 1)
    , Corners(this->Count(), -1)
  {
    this->Add(this->GetWhole(), steps, 0);
  }
  LatticePart GetWhole() const
  {
    LatticePart whole;
    for (int axis = 0; axis < this->Shape.Dimension; ++axis)
    {
      whole.Axes[axis][axis] = this->Size - 1;
    }
    return whole;
  }
  vtkIdType GetCorner(const LatticePoint& point) const { return this->Corners[this->Index(point)]; }

private:
  vtkIdType Count() const
  {
    vtkIdType count = 1;
    for (int axis = 0; axis < this->Shape.Dimension; ++axis)
    {
      count *= this->Size;
    }
    return count;
  }
  vtkIdType Index(const LatticePoint& point) const
  {
    return point[0] + vtkIdType(this->Size) * (point[1] + vtkIdType(this->Size) * point[2]);
  }
  void Add(const LatticePart& part, int steps, vtkIdType cell)
  {
    if (steps == 0)
    {
      for (int corner = 0; corner < this->Shape.Corners; ++corner)
      {
        const LatticePoint point = part.At(this->Shape.CornerPoints[corner], 2);
        this->Corners[this->Index(point)] = 4 * cell + corner;
      }
      return;
    }
    const auto children = static_cast<vtkIdType>(this->Shape.Children.size());
    for (vtkIdType c = 0; c < children; ++c)
    {
      this->Add(part.Take(this->Shape.Children[c]), steps - 1, children * cell + c);
    }
  }

  const PatchShape& Shape;
  const int Size;
  Buffer<vtkIdType> Corners;
};

}

#endif
