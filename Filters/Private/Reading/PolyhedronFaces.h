// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PolyhedronFaces.h
 * The faces of polyhedra, pentagonal and hexagonal prisms.
 *
 * ReadableMesh.h stores a polyhedron as the loops of its faces, one after the other, each of which
 * ends with its first point again: 0 1 2 0, 0 3 1 0 and so on. So its faces are where the points of
 * other cells are. Its type is FaceLoops, because VTK reads the points of VTK_POLYHEDRON in another
 * way.
 */
#ifndef SubdivisionObjects_PolyhedronFaces_h
#define SubdivisionObjects_PolyhedronFaces_h

#include "Private/Reading/CellReader.h"

#include "vtkCellType.h"

#include <algorithm>
#include <vector>

namespace subdivision
{

/// No type of VTK.
constexpr int FaceLoops = 254;

inline bool IsPolyhedron(int cellType)
{
  return cellType == FaceLoops || cellType == VTK_PENTAGONAL_PRISM ||
    cellType == VTK_HEXAGONAL_PRISM;
}

/// Calls visit(loop, size) for each face, whose points are in outward order; `visit` may change the
/// loop. Returns false where the last loop does not end.
template <typename Visit>
bool ForEachFaceLoop(
  int cellType, const CellIds& cell, std::vector<vtkIdType>& loop, const Visit& visit)
{
  if (cellType == FaceLoops)
  {
    const vtkIdType* end = cell.Ids + cell.Size;
    for (const vtkIdType* first = cell.Ids; first != end;)
    {
      const vtkIdType* last = std::find(first + 1, end, *first);
      if (last == end)
      {
        return false;
      }
      loop.assign(first, last);
      visit(loop.data(), static_cast<vtkIdType>(loop.size()));
      first = last + 1;
    }
    return true;
  }
  const vtkIdType n = cell.Size / 2;
  loop.assign(cell.Ids, cell.Ids + n);
  std::reverse(loop.begin(), loop.end());
  visit(loop.data(), n);
  loop.assign(cell.Ids + n, cell.Ids + 2 * n);
  visit(loop.data(), n);
  for (vtkIdType i = 0; i < n; ++i)
  {
    const vtkIdType next = (i + 1) % n;
    loop = { cell.Ids[i], cell.Ids[next], cell.Ids[next + n], cell.Ids[i + n] };
    visit(loop.data(), 4);
  }
  return true;
}

}

#endif
