// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Reading/TrianglesNearQuads.h"

#include "Private/Reading/CellFaces.h"
#include "Private/Reading/FlatPart.h"

#include "vtkCellType.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace subdivision
{

namespace
{

/// Cell types that never have a quad, so that most cells are skipped without a look at their
/// points.
bool NeverHasQuads(int cellType)
{
  return cellType == VTK_TETRA || cellType == VTK_TRIANGLE || cellType == VTK_TRIANGLE_STRIP ||
    cellType == VTK_QUADRATIC_TETRA || cellType == VTK_QUADRATIC_TRIANGLE;
}

/// One byte per point, 1 for the points of quads. They are atomic because several threads may write
/// the same byte; all write 1.
using PointMarks = std::vector<std::atomic<unsigned char>>;

void MarkQuadPoints(
  vtkPointSet* input, const CellReader& cells, const CheckedCells& checked, PointMarks& marks)
{
  ForCellBlocks(cells,
    [&](vtkIdType, vtkIdType begin, vtkIdType end)
    {
      std::vector<vtkIdType> ids;
      CellFaces faces(input, cells);
      for (vtkIdType cellId = begin; cellId < end; ++cellId)
      {
        const int type = cells.GetCellType(cellId);
        if (!TakesPart(checked.States[cellId]) || NeverHasQuads(type))
        {
          continue;
        }
        faces.ForEach(cellId, cells.GetCell(cellId, ids),
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

/// Cells that may have a point in the middle of an edge, as CloseHangingNodes makes them.
bool IsOfLoops(int cellType)
{
  return cellType == FaceLoops || cellType == VTK_POLYGON;
}

/// The corner of a quad that lies on the line between its neighbours; -1: there is none.
int FindStraightCorner(vtkPoints* points, const vtkIdType* quad)
{
  double x[4][3];
  for (int i = 0; i < 4; ++i)
  {
    points->GetPoint(quad[i], x[i]);
  }
  for (int i = 0; i < 4; ++i)
  {
    const double* ends[2] = { x[(i + 3) % 4], x[(i + 1) % 4] };
    if (FlatPart(ends, 2).Find(x[i]) == FlatPart::Inside)
    {
      return i;
    }
  }
  return -1;
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
  vtkPointSet* input, const CellReader& cells, const CheckedCells& checked)
{
  PointMarks marks(static_cast<size_t>(input->GetNumberOfPoints()));
  MarkQuadPoints(input, cells, checked, marks);
  const auto marked = [&marks](vtkIdType id)
  { return marks[id].load(std::memory_order_relaxed) != 0; };

  std::vector<std::vector<TriangleKey>> found(static_cast<size_t>(cells.GetNumberOfBlocks()));
  ForCellBlocks(cells,
    [&](vtkIdType block, vtkIdType begin, vtkIdType end)
    {
      std::vector<vtkIdType> ids;
      CellFaces faces(input, cells);
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
        faces.ForEach(cellId, cell,
          [&](const vtkIdType* loop, vtkIdType size)
          {
            if (size == 3 && marked(loop[0]) && marked(loop[1]) && marked(loop[2]))
            {
              found[block].push_back(MakeTriangleKey(loop[0], loop[1], loop[2]));
            }
            const int tip = size == 4 && IsOfLoops(cells.GetCellType(cellId))
              ? FindStraightCorner(input->GetPoints(), loop)
              : -1;
            if (tip >= 0) // the other diagonal would make a triangle without a size
            {
              found[block].push_back(
                MakeTriangleKey(loop[tip], loop[(tip + 1) % 4], loop[(tip + 2) % 4]));
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
