// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Reading/SolidCells.h"

#include "vtkCellType.h"

#include <algorithm>
#include <array>

namespace subdivision
{

namespace
{

constexpr SolidFaces Tetra = { 4, 4,
  { { 0, 1, 3, -1 }, { 1, 2, 3, -1 }, { 2, 0, 3, -1 }, { 0, 2, 1, -1 } } };
constexpr SolidFaces Hexahedron = { 8, 6,
  { { 0, 4, 7, 3 }, { 1, 2, 6, 5 }, { 0, 1, 5, 4 }, { 3, 7, 6, 2 }, { 0, 3, 2, 1 },
    { 4, 5, 6, 7 } } };
constexpr SolidFaces Voxel = { 8, 6,
  { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 2, 3, 1 },
    { 4, 5, 7, 6 } } };
constexpr SolidFaces Wedge = { 6, 5,
  { { 0, 1, 2, -1 }, { 3, 5, 4, -1 }, { 0, 3, 4, 1 }, { 1, 4, 5, 2 }, { 2, 5, 3, 0 } } };
constexpr SolidFaces Pyramid = { 5, 5,
  { { 0, 3, 2, 1 }, { 0, 1, 4, -1 }, { 1, 2, 4, -1 }, { 2, 3, 4, -1 }, { 3, 0, 4, -1 } } };

using Triangle = std::array<vtkIdType, 3>;

bool Contains(const Triangle& triangle, vtkIdType point)
{
  return triangle[0] == point || triangle[1] == point || triangle[2] == point;
}

/// The boundary of a cell as outward triangles, with counts of the diagonals at each point.
struct Surface
{
  int Size = 0;
  Triangle Triangles[12];
  /// For each entry of SolidSplit::Points: the number of quads at this point whose diagonal ends at
  /// it, and of quads whose diagonal does not.
  int Diagonals[8] = {};
  int Avoided[8] = {};

  void Add(vtkIdType a, vtkIdType b, vtkIdType c) { this->Triangles[this->Size++] = { a, b, c }; }
};

int IndexOf(const SolidSplit& split, vtkIdType point)
{
  return static_cast<int>(
    std::find(split.Points, split.Points + split.NumberOfPoints, point) - split.Points);
}

void AddQuad(
  const vtkIdType* quad, const QuadDiagonals& diagonals, SolidSplit& split, Surface& surface)
{
  if (quad[0] == quad[2] || quad[1] == quad[3])
  {
    return; // folded along its diagonal: its two halves cancel
  }
  const QuadDiagonals::Choice choice = diagonals.Choose(quad);
  if (choice.Contested)
  {
    split.Contested[split.NumberOfContested++] = MakeQuadKey(quad);
  }
  for (int i = 0; i < 4; ++i)
  {
    const int index = IndexOf(split, quad[i]);
    ++((i & 1) == choice.Diagonal ? surface.Diagonals : surface.Avoided)[index];
  }
  if (choice.Diagonal == 0)
  {
    surface.Add(quad[0], quad[1], quad[2]);
    surface.Add(quad[0], quad[2], quad[3]);
  }
  else
  {
    surface.Add(quad[0], quad[1], quad[3]);
    surface.Add(quad[1], quad[2], quad[3]);
  }
}

void AddFaces(const SolidFaces& table, const vtkIdType* ids, const QuadDiagonals& diagonals,
  SolidSplit& split, Surface& surface)
{
  for (int face = 0; face < table.NumberOfFaces; ++face)
  {
    const int* local = table.Faces[face];
    const int corners = local[3] < 0 ? 3 : 4;
    vtkIdType loop[4] = {};
    for (int i = 0; i < corners; ++i)
    {
      loop[i] = ids[local[i]];
    }
    const vtkIdType size = CollapseLoop(loop, corners);
    if (size == 4)
    {
      AddQuad(loop, diagonals, split, surface);
    }
    else if (size == 3)
    {
      surface.Add(loop[0], loop[1], loop[2]);
    }
  }
}

/// Removes pairs of equal triangles that face opposite ways. A collapsed cell may have them, with
/// no volume in between.
void CancelOppositeTriangles(Surface& surface)
{
  for (int i = 0; i < surface.Size; ++i)
  {
    const Triangle& t = surface.Triangles[i];
    for (int j = i + 1; j < surface.Size; ++j)
    {
      const Triangle& o = surface.Triangles[j];
      if (o == Triangle{ t[0], t[2], t[1] } || o == Triangle{ t[2], t[1], t[0] } ||
        o == Triangle{ t[1], t[0], t[2] })
      {
        std::copy(
          surface.Triangles + j + 1, surface.Triangles + surface.Size, surface.Triangles + j);
        std::copy(
          surface.Triangles + i + 1, surface.Triangles + surface.Size - 1, surface.Triangles + i);
        surface.Size -= 2;
        --i;
        break;
      }
    }
  }
}

/// Makes a tet of the apex and each triangle without it. The tets are positive because the
/// triangles face outward and the apex is inside or on the boundary.
void Cone(vtkIdType apex, const Surface& surface, SolidSplit& split)
{
  for (int i = 0; i < surface.Size; ++i)
  {
    const Triangle& t = surface.Triangles[i];
    if (!Contains(t, apex))
    {
      vtkIdType* tet = split.Tets[split.NumberOfTets++];
      tet[0] = apex;
      std::copy(t.begin(), t.end(), tet + 1);
    }
  }
}

/// The index of the smallest point at which the diagonals of all its quads end; -1 if there is
/// none. Tets from such a point to the triangles without it fill the cell.
int FindApex(const SolidSplit& split, const Surface& surface, const PointOrder& order)
{
  int apex = -1;
  for (int i = 0; i < split.NumberOfPoints; ++i)
  {
    if (surface.Avoided[i] == 0 && (apex < 0 || order(split.Points[i], split.Points[apex])))
    {
      apex = i;
    }
  }
  return apex;
}

/// Cuts off a corner at which none of the diagonals of its three quads ends: one tet, and one
/// triangle in place of the three at the corner.
void CutCorner(vtkIdType corner, Surface& surface, SolidSplit& split)
{
  // In the three triangles (corner, a, b) the edges ab form a closed loop, the `link`.
  Triangle link{};
  Surface rest;
  for (int i = 0; i < surface.Size; ++i)
  {
    const Triangle& t = surface.Triangles[i];
    if (!Contains(t, corner))
    {
      rest.Add(t[0], t[1], t[2]);
      continue;
    }
    const int at = t[0] == corner ? 0 : (t[1] == corner ? 1 : 2);
    const vtkIdType a = t[(at + 1) % 3];
    const vtkIdType b = t[(at + 2) % 3];
    if (link[0] == link[1])
    {
      link = { a, b, b };
    }
    else if (a == link[1])
    {
      link[2] = b;
    }
    else if (b == link[0])
    {
      link[2] = a;
    }
  }
  vtkIdType* tet = split.Tets[split.NumberOfTets++];
  tet[0] = corner;
  tet[1] = link[0];
  tet[2] = link[2];
  tet[3] = link[1];
  rest.Add(link[0], link[1], link[2]);
  surface.Size = rest.Size;
  std::copy(rest.Triangles, rest.Triangles + rest.Size, surface.Triangles);
}

/**
 * A hexahedron without apex can still be split if two opposite corners have no diagonal: they are
 * cut off, which leaves an octahedron, and any of its three diagonals splits it.
 */
bool SplitAsOctahedron(
  const vtkIdType* ids, bool voxel, const PointOrder& order, Surface& surface, SolidSplit& split)
{
  for (int corner = 0; corner < 4; ++corner)
  {
    const int opposite = voxel ? 7 - corner : (corner ^ 6);
    // All eight points differ, so that Points[i] is ids[i].
    if (surface.Diagonals[corner] == 0 && surface.Diagonals[opposite] == 0)
    {
      CutCorner(ids[corner], surface, split);
      CutCorner(ids[opposite], surface, split);
      vtkIdType apex = -1;
      for (int i = 0; i < 8; ++i)
      {
        if (i != corner && i != opposite && (apex < 0 || order(ids[i], apex)))
        {
          apex = ids[i];
        }
      }
      Cone(apex, surface, split);
      return true;
    }
  }
  return false;
}

}

const SolidFaces* GetFaceTable(int cellType)
{
  switch (cellType)
  {
    case VTK_TETRA:
      return &Tetra;
    case VTK_VOXEL:
      return &Voxel;
    case VTK_HEXAHEDRON:
      return &Hexahedron;
    case VTK_WEDGE:
      return &Wedge;
    case VTK_PYRAMID:
      return &Pyramid;
    default:
      return nullptr;
  }
}

vtkIdType CollapseLoop(vtkIdType* loop, vtkIdType size)
{
  vtkIdType kept = 0;
  for (vtkIdType i = 0; i < size; ++i)
  {
    if (kept == 0 || loop[i] != loop[kept - 1])
    {
      loop[kept++] = loop[i];
    }
  }
  while (kept > 1 && loop[kept - 1] == loop[0])
  {
    --kept;
  }
  return kept;
}

SolidSplit SplitSolid(int cellType, const vtkIdType* ids, const QuadDiagonals& diagonals)
{
  const SolidFaces& table = *GetFaceTable(cellType);
  SolidSplit split;
  for (int i = 0; i < table.NumberOfPoints; ++i)
  {
    if (IndexOf(split, ids[i]) == split.NumberOfPoints)
    {
      split.Points[split.NumberOfPoints++] = ids[i];
    }
  }
  Surface surface;
  AddFaces(table, ids, diagonals, split, surface);
  const bool collapsed = split.NumberOfPoints < table.NumberOfPoints;
  if (collapsed)
  {
    CancelOppositeTriangles(surface);
  }
  if (split.NumberOfPoints < 4 || surface.Size == 0)
  {
    return split;
  }
  const int apex = FindApex(split, surface, diagonals.GetOrder());
  if (apex >= 0)
  {
    Cone(split.Points[apex], surface, split);
    return split;
  }
  if (table.NumberOfPoints == 8 && !collapsed &&
    SplitAsOctahedron(ids, cellType == VTK_VOXEL, diagonals.GetOrder(), surface, split))
  {
    return split;
  }
  split.HasCentre = true;
  Cone(SolidSplit::Centre, surface, split);
  return split;
}

}
