// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellSplitter.h
 * How each type of cell is split into simplices, whether they are counted or written.
 */
#ifndef SubdivisionObjects_CellSplitter_h
#define SubdivisionObjects_CellSplitter_h

#include "Private/Reading/CellChecks.h"
#include "Private/Reading/CellReader.h"
#include "Private/Reading/NonLinearCells.h"
#include "Private/Reading/PolygonEars.h"
#include "Private/Reading/PolyhedronFaces.h"
#include "Private/Reading/QuadDiagonals.h"
#include "Private/Reading/SolidCells.h"
#include "Private/Reading/TrianglesNearQuads.h"

#include "vtkCellType.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <vector>

namespace subdivision
{

inline bool IsRepeated(const vtkIdType* ids, int size)
{
  for (int i = 1; i < size; ++i)
  {
    if (std::find(ids, ids + i, ids[i]) != ids + i)
    {
      return true;
    }
  }
  return false;
}

/// Splits one cell after the other into a sink, which counts or writes; one object per task.
template <typename Sink>
class CellSplitter
{
public:
  CellSplitter(
    const CellReader& cells, vtkPointSet* input, const QuadDiagonals& diagonals, Sink& sink)
    : Cells(cells)
    , Input(input)
    , Diagonals(diagonals)
    , Ears(input->GetPoints(), diagonals.GetOrder())
    , NonLinear(input)
    , Out(sink)
  {
  }

  void Split(vtkIdType cellId, CellState state)
  {
    if (!TakesPart(state))
    {
      return;
    }
    this->CellId = cellId;
    this->IsGood = state == CellState::Good;
    const int type = this->Cells.GetCellType(cellId);
    const CellIds cell = this->Cells.GetCell(cellId, this->Ids);
    if (IsPolyhedron(type))
    {
      this->SplitPolyhedron(type, cell);
    }
    else if (!this->SplitLinear(type, cell))
    {
      this->SplitNonLinear(type, cell);
    }
  }

private:
  /// Returns false if the cell is not linear.
  bool SplitLinear(int type, const CellIds& cell)
  {
    switch (type)
    {
      case VTK_VERTEX:
      case VTK_POLY_VERTEX:
        this->AddWindows(cell, 1);
        break;
      case VTK_LINE:
      case VTK_POLY_LINE:
        this->AddWindows(cell, 2);
        break;
      case VTK_TRIANGLE:
        this->Add(cell.Ids, 3);
        break;
      case VTK_TRIANGLE_STRIP:
        this->SplitStrip(cell);
        break;
      case VTK_PIXEL:
      case VTK_QUAD:
        vtkIdType quad[4];
        GetQuad(type, cell.Ids, quad);
        this->SplitQuad(quad);
        break;
      case VTK_POLYGON:
        this->SplitPolygon(cell);
        break;
      case VTK_TETRA:
        this->Add(cell.Ids, 4);
        break;
      case VTK_VOXEL:
      case VTK_HEXAHEDRON:
      case VTK_WEDGE:
      case VTK_PYRAMID:
        this->SplitSolidCell(type, cell.Ids);
        break;
      default:
        return false;
    }
    return true;
  }

  void Add(const vtkIdType* ids, int size)
  {
    if (this->IsGood || !IsRepeated(ids, size))
    {
      this->Out.AddSimplex(this->CellId, ids, size);
    }
  }

  void AddWindows(const CellIds& cell, int size)
  {
    for (vtkIdType i = 0; i + size <= cell.Size; ++i)
    {
      this->Add(cell.Ids + i, size);
    }
  }

  void SplitStrip(const CellIds& cell)
  {
    for (vtkIdType i = 0; i + 2 < cell.Size; ++i)
    {
      vtkIdType triangle[3];
      GetStripTriangle(cell.Ids, i, triangle);
      this->Add(triangle, 3);
    }
  }

  void SplitQuad(const vtkIdType* quad)
  {
    if (IsFolded(quad))
    {
      return;
    }
    const int last = this->ChooseDiagonal(quad) == 0 ? 2 : 3;
    const vtkIdType first[3] = { quad[0], quad[1], quad[last] };
    const vtkIdType second[3] = { quad[last - 2], quad[2], quad[3] };
    this->Add(first, 3);
    this->Add(second, 3);
  }

  void SplitPolygon(CellIds cell)
  {
    if (!this->IsGood)
    {
      this->Loop.assign(cell.Ids, cell.Ids + cell.Size);
      cell.Size = CollapseLoop(this->Loop.data(), cell.Size);
      cell.Ids = this->Loop.data();
    }
    if (cell.Size == 3)
    {
      this->Add(cell.Ids, 3);
    }
    else if (cell.Size == 4)
    {
      this->SplitQuad(cell.Ids);
    }
    else if (cell.Size > 4 && Sink::Counts && this->IsGood)
    {
      for (vtkIdType i = 2; i < cell.Size; ++i)
      {
        this->Add(cell.Ids, 3); // only their number matters here
      }
    }
    else if (cell.Size > 4)
    {
      for (const auto& triangle : this->Ears.Cut(cell.Ids, cell.Size))
      {
        this->Add(triangle.data(), 3);
      }
    }
  }

  void SplitSolidCell(int type, const vtkIdType* ids)
  {
    SolidSplit split = SplitSolid(type, ids, this->Diagonals);
    for (int i = 0; i < split.NumberOfContested; ++i)
    {
      this->Out.AddContested(split.Contested[i], this->CellId);
    }
    const vtkIdType centre =
      split.HasCentre ? this->Out.AddCentre(split.Points, split.NumberOfPoints) : 0;
    for (int i = 0; i < split.NumberOfTets; ++i)
    {
      if (split.HasCentre)
      {
        split.Tets[i][0] = centre;
      }
      this->Out.AddSimplex(this->CellId, split.Tets[i], 4); // has no repeated ids
    }
  }

  void SplitNonLinear(int type, const CellIds& cell)
  {
    const CellPieces& table = *this->NonLinear.Find(type, this->CellId, cell.Size);
    vtkIdType centre = table.Centre < 0 ? NoPoint : cell.Ids[table.Centre];
    ForEachPiece(table, cell,
      [&](int pieceType, CellIds piece)
      {
        if (pieceType == CellPiece::Octahedron)
        {
          this->SplitOctahedron(piece.Ids);
        }
        else if (table.Dimension == 3 && (pieceType == VTK_TRIANGLE || pieceType == VTK_QUAD))
        {
          vtkIdType face[4];
          std::copy(piece.Ids, piece.Ids + piece.Size, face);
          this->AddCone(cell, centre, face, piece.Size);
        }
        else
        {
          this->SplitLinear(pieceType, piece);
        }
      });
  }

  /// By its shortest diagonal; among equal ones by the one with the smallest point.
  void SplitOctahedron(const vtkIdType* nodes)
  {
    int best = 0;
    for (int d = 1; d < 3; ++d)
    {
      const double change = this->GetLength2(nodes + 2 * d) / this->GetLength2(nodes + 2 * best);
      const auto smallest = [&](int i)
      { return std::min(nodes[2 * i], nodes[2 * i + 1], this->Diagonals.GetOrder()); };
      constexpr double tie = 1e-5; // for points in single precision too
      if (change < 1. - tie ||
        (change <= 1. + tie && this->Diagonals.GetOrder()(smallest(d), smallest(best))))
      {
        best = d;
      }
    }
    const vtkIdType* axis = nodes + 2 * best;
    const vtkIdType* next = nodes + 2 * ((best + 1) % 3);
    const vtkIdType* last = nodes + 2 * ((best + 2) % 3);
    const vtkIdType ring[5] = { next[0], last[0], next[1], last[1], next[0] };
    for (int i = 0; i < 4; ++i)
    {
      const vtkIdType tet[4] = { axis[0], axis[1], ring[i], ring[i + 1] };
      this->Add(tet, 4);
    }
  }

  double GetLength2(const vtkIdType* ends) const
  {
    double a[3];
    double b[3];
    this->Input->GetPoint(ends[0], a);
    this->Input->GetPoint(ends[1], b);
    return vtkMath::Distance2BetweenPoints(a, b);
  }

  void SplitPolyhedron(int type, const CellIds& cell)
  {
    vtkIdType centre = NoPoint;
    ForEachFaceLoop(type, cell, this->Faces,
      [&](vtkIdType* loop, vtkIdType size) { this->AddCone(cell, centre, loop, size); });
  }

  /// Makes the tets between a face of a cell, which looks outwards, and the centre of the cell. The
  /// centre is made for the first face that needs it.
  void AddCone(const CellIds& cell, vtkIdType& centre, vtkIdType* face, vtkIdType size)
  {
    size = this->IsGood ? size : CollapseLoop(face, size);
    if (size < 3 || (size == 4 && IsFolded(face)))
    {
      return;
    }
    if (centre == NoPoint)
    {
      this->Loop.assign(cell.Ids, cell.Ids + cell.Size);
      std::sort(this->Loop.begin(), this->Loop.end(), this->Diagonals.GetOrder());
      this->Loop.erase(std::unique(this->Loop.begin(), this->Loop.end()), this->Loop.end());
      centre = this->Out.AddCentre(this->Loop.data(), static_cast<int>(this->Loop.size()));
    }
    const auto add = [&](vtkIdType a, vtkIdType b, vtkIdType c)
    {
      const vtkIdType tet[4] = { centre, a, b, c };
      this->Add(tet, 4);
    };
    if (size == 3)
    {
      add(face[0], face[1], face[2]);
    }
    else if (size == 4)
    {
      const int shift = this->ChooseDiagonal(face);
      add(face[shift], face[1 + shift], face[2 + shift]);
      add(face[2 + shift], face[(3 + shift) % 4], face[shift]);
    }
    else
    {
      this->Ears.CutFace(face, size, add);
    }
  }

  /// 0: between the quad's points 0 and 2; 1: between 1 and 3.
  int ChooseDiagonal(const vtkIdType* quad)
  {
    const QuadDiagonals::Choice choice = this->Diagonals.Choose(quad);
    if (choice.Contested)
    {
      this->Out.AddContested(quad, this->CellId);
    }
    return choice.Diagonal;
  }

  static constexpr vtkIdType NoPoint = -1;

  const CellReader& Cells;
  vtkPointSet* Input;
  const QuadDiagonals& Diagonals;
  PolygonEars Ears;
  NonLinearCells NonLinear;
  Sink& Out;
  vtkIdType CellId = 0;
  bool IsGood = true;
  std::vector<vtkIdType> Ids;
  std::vector<vtkIdType> Loop;
  std::vector<vtkIdType> Faces;
};

}

#endif
