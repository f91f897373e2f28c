// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bounds/TetOctReader.h"

namespace subdivision
{

/// Cells were written in an order that the octahedron had on its level.
TetOctReader::Solid TetOctReader::GetOct(
  vtkIdType first, const std::array<vtkIdType, 6>& vertices) const
{
  Solid solid{ &this->Octahedron, first, {} };
  const auto units = GetCornerNodes(CellShape::Octahedron, 1);
  const auto corners = GetCornerNodes(CellShape::Octahedron, this->Size);
  for (int v = 0; v < 6; ++v)
  {
    const vtkIdType vertex = this->Reader.GetPoint(this->Octahedron, first, corners[v]);
    for (int axis = 0; axis < 3; ++axis)
    {
      solid.Axes[axis] = vertices[2 * axis] == vertex ? units[v] : solid.Axes[axis];
    }
  }
  return solid;
}

vtkIdType TetOctReader::GetPoint(const Solid& solid, const FrameNode& place) const
{
  FrameNode node = place;
  for (int x = 0; x < 3 && solid.Lattice == &this->Octahedron; ++x)
  {
    node[x] =
      place[0] * solid.Axes[0][x] + place[1] * solid.Axes[1][x] + place[2] * solid.Axes[2][x];
  }
  return this->Reader.GetPoint(*solid.Lattice, solid.First, node);
}

}
