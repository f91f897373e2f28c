// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bounds/TetOctPieces.h"

#include "Core/Solids/TetOct/TetOctCells.h"

namespace subdivision
{
namespace
{

TetOctPieces::QuarterTable MakeQuarters()
{
  const int vertices[6] = { 0, 1, 2, 3, 4, 5 };
  int tets[16];
  CutOctahedron(vertices, 0, tets);
  TetOctPieces::QuarterTable quarters{};
  for (int i = 0; i < 16; ++i)
  {
    quarters[i / 4][i % 4] = tets[i];
  }
  return quarters;
}

}

const TetOctPieces::QuarterTable& TetOctPieces::GetQuarters()
{
  static const QuarterTable quarters = MakeQuarters();
  return quarters;
}

FrameNode TetOctPieces::GetVertex(int vertex)
{
  return GetCornerNodes(CellShape::Octahedron, 1)[static_cast<std::size_t>(vertex)];
}

std::array<vtkIdType, 6> TetOctPieces::Join(const vtkIdType* quarters)
{
  std::array<vtkIdType, 6> vertices{};
  JoinOctahedron(quarters, vertices.data());
  return vertices;
}

}
