// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellFaces.h
 * The faces of cells of all types.
 */
#ifndef SubdivisionObjects_CellFaces_h
#define SubdivisionObjects_CellFaces_h

#include "Core/Memory/Sorting.h"
#include "Private/Reading/NonLinearCells.h"
#include "Private/Reading/PolyhedronFaces.h"
#include "Private/Reading/SolidCells.h"
#include "Private/Reading/TrianglesNearQuads.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace subdivision
{

/// Calls `visit(loop, size)` for the faces of solids, which look outwards, and for triangles, quads
/// and polygons, also of the pieces of cells. Each task needs an object of its own.
class CellFaces
{
public:
  CellFaces(vtkPointSet* input, const CellReader& cells)
    : Cells(cells)
    , NonLinear(input)
  {
  }

  template <typename Visit>
  void ForEach(vtkIdType cellId, const CellIds& cell, const Visit& visit)
  {
    const int type = this->Cells.GetCellType(cellId);
    const auto visitLoop = [&visit](vtkIdType* ids, vtkIdType count)
    {
      const vtkIdType size = CollapseLoop(ids, count);
      if (size >= 3 && !(size == 4 && IsFolded(ids)))
      {
        visit(ids, size);
      }
    };
    if (IsPolyhedron(type))
    {
      ForEachFaceLoop(type, cell, this->Scratch, visitLoop);
    }
    else if (this->IsLinear(type))
    {
      this->VisitLinear(type, cell, visitLoop);
    }
    else
    {
      this->VisitPieces(*this->NonLinear.Find(type, cellId, cell.Size), cell, visitLoop);
    }
  }

private:
  static bool IsLinear(int type) { return type <= VTK_HEXAGONAL_PRISM; }

  template <typename Visit>
  void VisitLinear(int type, const CellIds& cell, const Visit& visit)
  {
    vtkIdType loop[4];
    if (const SolidFaces* table = GetFaceTable(type))
    {
      for (int face = 0; face < table->NumberOfFaces; ++face)
      {
        const int* local = table->Faces[face];
        const int corners = local[3] < 0 ? 3 : 4;
        for (int i = 0; i < corners; ++i)
        {
          loop[i] = cell.Ids[local[i]];
        }
        visit(loop, corners);
      }
    }
    else if (type == VTK_PIXEL || type == VTK_QUAD)
    {
      GetQuad(type, cell.Ids, loop);
      visit(loop, 4);
    }
    else if (type == VTK_TRIANGLE_STRIP)
    {
      for (vtkIdType i = 0; i + 2 < cell.Size; ++i)
      {
        GetStripTriangle(cell.Ids, i, loop);
        visit(loop, 3);
      }
    }
    else if (type == VTK_TRIANGLE || type == VTK_POLYGON)
    {
      this->Scratch.assign(cell.Ids, cell.Ids + cell.Size);
      visit(this->Scratch.data(), cell.Size);
    }
  }

  template <typename Visit>
  void VisitPieces(const CellPieces& table, const CellIds& cell, const Visit& visit)
  {
    ForEachPiece(table, cell,
      [&](int type, const CellIds& piece)
      {
        if (type != CellPiece::Octahedron)
        {
          this->VisitLinear(type, piece, visit);
          return;
        }
        for (int face = 0; face < 8; ++face)
        {
          vtkIdType loop[3] = { piece.Ids[face & 1], piece.Ids[2 + ((face >> 1) & 1)],
            piece.Ids[4 + (face >> 2)] };
          visit(loop, 3);
        }
      });
  }

  const CellReader& Cells;
  NonLinearCells NonLinear;
  std::vector<vtkIdType> Scratch;
};

/// Equal for the same points in any order.
inline std::uint64_t HashLoop(const vtkIdType* ids, vtkIdType size)
{
  std::uint64_t sum = static_cast<std::uint64_t>(size);
  for (vtkIdType i = 0; i < size; ++i)
  {
    std::uint64_t x = static_cast<std::uint64_t>(ids[i]) + 0x9E3779B97F4A7C15ull;
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ull;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBull;
    sum += x ^ (x >> 31);
  }
  return sum;
}

/// Sorts hashes, and keeps the hashes that are there once.
inline void KeepSingles(std::vector<std::uint64_t>& hashes)
{
  StableSort(hashes, std::less<>());
  std::vector<std::uint64_t> singles;
  for (const std::size_t i : InTurn(hashes.size()))
  {
    if ((i == 0 || hashes[i - 1] != hashes[i]) &&
      (i + 1 == hashes.size() || hashes[i + 1] != hashes[i]))
    {
      singles.push_back(hashes[i]);
    }
  }
  hashes.swap(singles);
}

}

#endif
