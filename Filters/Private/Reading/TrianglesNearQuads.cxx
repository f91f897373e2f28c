// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Reading/TrianglesNearQuads.h"

#include "Private/Reading/SolidCells.h"

#include "vtkCellType.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace subdivision
{

namespace
{

/// Calls `visit(loop, size)` for every triangle and quad that the cell is or has as a face.
template <typename Visit>
void ForEachFace(int cellType, const CellIds& cell, std::vector<vtkIdType>& scratch, Visit&& visit)
{
  vtkIdType loop[4];
  const auto visitLoop = [&visit](vtkIdType* ids, vtkIdType count)
  {
    const vtkIdType size = CollapseLoop(ids, count);
    if (size == 3 || (size == 4 && !IsFolded(ids)))
    {
      visit(ids, size);
    }
  };
  if (const FaceTable* table = GetFaceTable(cellType))
  {
    for (int face = 0; face < table->NumberOfFaces; ++face)
    {
      const int* local = table->Faces[face];
      const int corners = local[3] < 0 ? 3 : 4;
      for (int i = 0; i < corners; ++i)
      {
        loop[i] = cell.Ids[local[i]];
      }
      visitLoop(loop, corners);
    }
  }
  else if (cellType == VTK_PIXEL || cellType == VTK_QUAD)
  {
    GetQuad(cellType, cell.Ids, loop);
    visitLoop(loop, 4);
  }
  else if (cellType == VTK_TRIANGLE_STRIP)
  {
    for (vtkIdType i = 0; i + 2 < cell.Size; ++i)
    {
      GetStripTriangle(cell.Ids, i, loop);
      visitLoop(loop, 3);
    }
  }
  else if (cellType == VTK_TRIANGLE || cellType == VTK_POLYGON)
  {
    scratch.assign(cell.Ids, cell.Ids + cell.Size);
    visitLoop(scratch.data(), cell.Size);
  }
}

/// Cell types that never have a quad, so that most cells are skipped without a look at their
/// points.
bool NeverHasQuads(int cellType)
{
  return cellType == VTK_TETRA || cellType == VTK_TRIANGLE || cellType == VTK_TRIANGLE_STRIP;
}

/// One byte per point, 1 for the points of quads. They are atomic because several threads may write
/// the same byte; all write 1.
using PointMarks = std::vector<std::atomic<unsigned char>>;

void MarkQuadPoints(const CellReader& cells, const CheckedCells& checked, PointMarks& marks)
{
  ForCellBlocks(cells,
    [&](vtkIdType, vtkIdType begin, vtkIdType end)
    {
      std::vector<vtkIdType> ids;
      std::vector<vtkIdType> scratch;
      for (vtkIdType cellId = begin; cellId < end; ++cellId)
      {
        const int type = cells.GetCellType(cellId);
        if (!TakesPart(checked.States[cellId]) || NeverHasQuads(type))
        {
          continue;
        }
        ForEachFace(type, cells.GetCell(cellId, ids), scratch,
          [&marks](const vtkIdType* loop, vtkIdType size)
          {
            for (vtkIdType i = 0; size == 4 && i < 4; ++i)
            {
              marks[loop[i]].store(1, std::memory_order_relaxed);
            }
          });
      }
    });
}

}

void GetQuad(int cellType, const vtkIdType* ids, vtkIdType* quad)
{
  std::copy(ids, ids + 4, quad);
  if (cellType == VTK_PIXEL)
  {
    std::swap(quad[2], quad[3]);
  }
}

void GetStripTriangle(const vtkIdType* ids, vtkIdType i, vtkIdType* triangle)
{
  std::copy(ids + i, ids + i + 3, triangle);
  if (i & 1)
  {
    std::swap(triangle[0], triangle[1]);
  }
}

bool IsFolded(const vtkIdType* quad)
{
  return quad[0] == quad[2] || quad[1] == quad[3];
}

std::vector<TriangleKey> FindTrianglesNearQuads(
  const CellReader& cells, const CheckedCells& checked, vtkIdType numberOfPoints)
{
  PointMarks marks(static_cast<size_t>(numberOfPoints));
  MarkQuadPoints(cells, checked, marks);
  const auto marked = [&marks](vtkIdType id)
  { return marks[id].load(std::memory_order_relaxed) != 0; };

  std::vector<std::vector<TriangleKey>> found(static_cast<size_t>(cells.GetNumberOfBlocks()));
  ForCellBlocks(cells,
    [&](vtkIdType block, vtkIdType begin, vtkIdType end)
    {
      std::vector<vtkIdType> ids;
      std::vector<vtkIdType> scratch;
      for (vtkIdType cellId = begin; cellId < end; ++cellId)
      {
        if (!TakesPart(checked.States[cellId]))
        {
          continue;
        }
        const CellIds cell = cells.GetCell(cellId, ids);
        if (std::count_if(cell.Ids, cell.Ids + cell.Size, marked) < 3)
        {
          continue;
        }
        ForEachFace(cells.GetCellType(cellId), cell, scratch,
          [&](const vtkIdType* loop, vtkIdType size)
          {
            if (size == 3 && marked(loop[0]) && marked(loop[1]) && marked(loop[2]))
            {
              found[block].push_back(MakeTriangleKey(loop[0], loop[1], loop[2]));
            }
          });
      }
    });
  std::vector<TriangleKey> all;
  for (const auto& some : found)
  {
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

}
