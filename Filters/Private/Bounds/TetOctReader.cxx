// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bounds/TetOctReader.h"

#include <algorithm>

namespace subdivision
{
namespace
{

constexpr TetOctPieces::Place Units[3] = { { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } };

TetOctPieces::Place GetScaledVertex(int vertex)
{
  TetOctPieces::Place place = TetOctPieces::GetVertex(vertex);
  for (int& x : place)
  {
    x *= TetOctPieces::Divisions;
  }
  return place;
}

}

TetOctReader::Place TetOctReader::Move(const Place& place, const Axes& axes)
{
  Place moved{};
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int x = 0; x < 3; ++x)
    {
      moved[x] += place[axis] * axes[axis][x];
    }
  }
  return moved;
}

void TetOctReader::ReadTet(vtkIdType first)
{
  this->Read(first, false, { { Units[0], Units[1], Units[2] } });
}

void TetOctReader::ReadOct(vtkIdType first, const std::array<vtkIdType, 6>& vertices)
{
  this->Read(first, true, this->FindAxes(first, vertices));
  // Only octahedra are at its vertices.
  for (int v = 0; v < 6; ++v)
  {
    this->Points[GetScaledVertex(v)] = vertices[v];
  }
}

/// Cells were written in an order that the octahedron had on its level. Of the solids at its
/// vertices each has one of `vertices`, and so tells which one it is.
TetOctReader::Axes TetOctReader::FindAxes(vtkIdType first, const std::array<vtkIdType, 6>& vertices)
{
  Axes axes{};
  for (const TetOctPieces::Solid& solid : TetOctPieces::Get(true, this->Steps).Solids)
  {
    for (int axis = 0; axis < 3 && solid.IsOct; ++axis)
    {
      const int own = 2 * axis;
      if (solid.Corners[own] != GetScaledVertex(own))
      {
        continue;
      }
      for (vtkIdType c = first + solid.FirstCell; c < first + solid.FirstCell + 4; ++c)
      {
        const CellIds cell = this->Cells.GetCell(c, this->Scratch);
        for (int v = 0; v < 6; ++v)
        {
          if (std::find(cell.Ids, cell.Ids + cell.Size, vertices[v]) != cell.Ids + cell.Size)
          {
            axes[axis] = TetOctPieces::GetVertex(v);
          }
        }
      }
    }
  }
  return axes;
}

void TetOctReader::Read(vtkIdType first, bool isOct, const Axes& axes)
{
  this->Points.clear();
  for (const TetOctPieces::Solid& solid : TetOctPieces::Get(isOct, this->Steps).Solids)
  {
    if (!solid.IsOct)
    {
      const CellIds cell = this->Cells.GetCell(first + solid.FirstCell, this->Scratch);
      for (int k = 0; k < 4; ++k)
      {
        this->Points[Move(solid.Corners[k], axes)] = cell.Ids[k];
      }
    }
  }
}

}
