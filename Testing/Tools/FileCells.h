// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FileCells.h
 * The cells of a mesh, and what their types alone tell of them.
 */
#ifndef SubdivisionObjects_FileCells_h
#define SubdivisionObjects_FileCells_h

#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointSet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace file_tools
{

/// What is known of a cell by its type alone: its dimension, and of how many simplices it can
/// consist (with or without centres that it needs to fit its neighbours).
struct Shape
{
  int Dimension;
  vtkIdType Least;
  vtkIdType Most;
};

inline Shape GetShape(int type, vtkIdType points)
{
  switch (type)
  {
    case VTK_VERTEX:
      return { 0, 1, 1 };
    case VTK_LINE:
      return { 1, 1, 1 };
    case VTK_TRIANGLE:
    case VTK_QUAD:
    case VTK_POLYGON:
      return { 2, points - 2, points - 2 };
    case VTK_TETRA:
    case VTK_QUADRATIC_TETRA:
      return { 3, 1, 1 };
    case VTK_PYRAMID:
      return { 3, 2, 6 };
    case VTK_WEDGE:
      return { 3, 3, 8 };
    case VTK_VOXEL:
    case VTK_HEXAHEDRON:
      return { 3, 5, 12 };
    case VTK_PENTAGONAL_PRISM:
    case VTK_HEXAGONAL_PRISM:
      return { 3, 3 * (points / 2 - 2), 2 * (points / 2 - 2) + points };
    case VTK_POLYHEDRON:
      return { 3, 1, 100 };
    default:
      ADD_FAILURE() << "cell of type " << type;
      return { 3, 1, 1 };
  }
}

/// The cells of a file.
struct FileCells
{
  explicit FileCells(vtkPointSet* mesh)
  {
    vtkNew<vtkIdList> ids;
    for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
    {
      mesh->GetCellPoints(c, ids);
      this->Types.push_back(mesh->GetCellType(c));
      this->Sizes.push_back(ids->GetNumberOfIds());
      this->Shapes.push_back(GetShape(this->Types.back(), this->Sizes.back()));
    }
  }
  vtkIdType Count(int dimension) const
  {
    return std::count_if(this->Shapes.begin(), this->Shapes.end(),
      [&](const Shape& shape) { return shape.Dimension == dimension; });
  }

  std::vector<int> Types;
  std::vector<vtkIdType> Sizes;
  std::vector<Shape> Shapes;
};

}

#endif
