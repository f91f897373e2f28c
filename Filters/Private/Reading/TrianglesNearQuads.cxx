// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Reading/TrianglesNearQuads.h"

#include "Private/Reading/NonLinearCells.h"
#include "Private/Reading/PolyhedronFaces.h"
#include "Private/Reading/SolidCells.h"

#include "vtkCellType.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace subdivision
{

namespace
{

/// Calls `visit(loop, size)` for the triangles and quads of cells and of the pieces of cells. Each
/// task needs an object of its own.
class Faces
{
public:
  Faces(vtkPointSet* input, const CellReader& cells)
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
      if (size == 3 || (size == 4 && !IsFolded(ids)))
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
    if (const FaceTable* table = GetFaceTable(type))
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
      Faces faces(input, cells);
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
      Faces faces(input, cells);
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
