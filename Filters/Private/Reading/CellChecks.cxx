// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Reading/CellChecks.h"

#include "Core/Memory/Loops.h"
#include "Private/Reading/NonLinearCells.h"
#include "Private/Reading/PolyhedronFaces.h"
#include "Private/Reading/SolidCells.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSetAttributes.h"
#include "vtkGenericCell.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

namespace subdivision
{

namespace
{

/// The number of points that a cell of this type has. A negative result -n means n or more points,
/// 0 a type that is not supported.
int GetRequiredSize(int cellType)
{
  switch (cellType)
  {
    case VTK_VERTEX:
      return 1;
    case VTK_POLY_VERTEX:
      return -1;
    case VTK_LINE:
      return 2;
    case VTK_POLY_LINE:
      return -2;
    case VTK_TRIANGLE:
      return 3;
    case VTK_TRIANGLE_STRIP:
    case VTK_POLYGON:
      return -3;
    case VTK_PIXEL:
    case VTK_QUAD:
    case VTK_TETRA:
      return 4;
    case VTK_PYRAMID:
      return 5;
    case VTK_WEDGE:
      return 6;
    case VTK_VOXEL:
    case VTK_HEXAHEDRON:
      return 8;
    case VTK_PENTAGONAL_PRISM:
      return 10;
    case VTK_HEXAGONAL_PRISM:
      return 12;
    case FaceLoops:
      return -1; // its loops are checked
    default:
      return IsNonLinear(cellType) ? -1 : 0; // NonLinearCells knows
  }
}

bool HasQuads(int cellType, vtkIdType size)
{
  switch (cellType)
  {
    case VTK_PIXEL:
    case VTK_QUAD:
    case VTK_PYRAMID:
    case VTK_WEDGE:
    case VTK_VOXEL:
    case VTK_HEXAHEDRON:
      return true;
    case VTK_POLYGON:
      return size >= 4; // larger ones may collapse to quads
    default:
      return IsPolyhedron(cellType) || IsNonLinear(cellType);
  }
}

bool HasRepeats(const vtkIdType* ids, vtkIdType size, std::vector<vtkIdType>& scratch)
{
  if (size > 16)
  {
    scratch.assign(ids, ids + size);
    std::sort(scratch.begin(), scratch.end());
    return std::adjacent_find(scratch.begin(), scratch.end()) != scratch.end();
  }
  if (size == 2)
  {
    return ids[0] == ids[1];
  }
  if (size == 4) // most cells of most meshes
  {
    return ids[0] == ids[1] || ids[0] == ids[2] || ids[0] == ids[3] || ids[1] == ids[2] ||
      ids[1] == ids[3] || ids[2] == ids[3];
  }
  for (vtkIdType i = 1; i < size; ++i)
  {
    if (std::find(ids, ids + i, ids[i]) != ids + i)
    {
      return true;
    }
  }
  return false;
}

/// A ring that turns back at a point loses pieces of no size there. One that passes a point again
/// later loses nothing.
CellState FindRepeatsOfRing(const vtkIdType* ids, vtkIdType size, std::vector<vtkIdType>& scratch)
{
  if (size >= 3 && !HasRepeats(ids, size, scratch))
  {
    return CellState::Good;
  }
  bool turnsBack = size < 3;
  for (vtkIdType i = 0; i < size; ++i)
  {
    turnsBack = turnsBack || ids[i] == ids[(i + 1) % size] || ids[i] == ids[(i + 2) % size];
  }
  return turnsBack ? CellState::PartlyRepeated : CellState::TouchesItself;
}

/// The worst of the faces of a polyhedron.
CellState FindRepeatsInFaces(const CellIds& cell, std::vector<vtkIdType>& scratch)
{
  CellState found = CellState::Good;
  std::vector<vtkIdType> loop;
  ForEachFaceLoop(FaceLoops, cell, loop,
    [&](const vtkIdType* ids, vtkIdType size)
    {
      const CellState state = FindRepeatsOfRing(ids, size, scratch);
      found = found == CellState::PartlyRepeated || state == CellState::Good ? found : state;
    });
  return found;
}

CellState FindRepeats(int cellType, const CellIds& cell, std::vector<vtkIdType>& scratch)
{
  const vtkIdType* ids = cell.Ids;
  const vtkIdType window = cellType == VTK_POLY_LINE ? 2 : 3;
  switch (cellType)
  {
    case VTK_VERTEX:
    case VTK_POLY_VERTEX: // its pieces are single points, which cannot be degenerate
      return CellState::Good;
    case VTK_POLY_LINE: // may pass through a point twice; only the points of one piece must differ
    case VTK_TRIANGLE_STRIP:
      for (vtkIdType i = 0; i + window <= cell.Size; ++i)
      {
        if (HasRepeats(ids + i, window, scratch))
        {
          return CellState::PartlyRepeated;
        }
      }
      return CellState::Good;
    case VTK_POLYGON:
      return FindRepeatsOfRing(ids, cell.Size, scratch);
    case VTK_VOXEL:
    case VTK_HEXAHEDRON:
    case VTK_WEDGE:
    case VTK_PYRAMID:
    case VTK_PENTAGONAL_PRISM:
    case VTK_HEXAGONAL_PRISM:
      return HasRepeats(ids, cell.Size, scratch) ? CellState::PartlyRepeated : CellState::Good;
    case FaceLoops:
      return FindRepeatsInFaces(cell, scratch);
    default:
      if (cell.Size > 4 && IsNonLinear(cellType))
      {
        return HasRepeats(ids, cell.Size, scratch) ? CellState::PartlyRepeated : CellState::Good;
      }
      return HasRepeats(ids, cell.Size, scratch) ? CellState::Repeated : CellState::Good;
  }
}

/// One byte per point, 0 where a coordinate is infinite or not a number; empty if there is none
/// with 0.
std::vector<unsigned char> FindFinitePoints(vtkPointSet* input)
{
  std::vector<unsigned char> finite(static_cast<size_t>(input->GetNumberOfPoints()));
  std::atomic<bool> areAll{ true };
  ForEach(input->GetNumberOfPoints(),
    [&](vtkIdType i)
    {
      double x[3];
      input->GetPoints()->GetPoint(i, x);
      const bool isFinite = std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
      finite[i] = isFinite ? 1 : 0;
      if (!isFinite)
      {
        areAll = false;
      }
    });
  if (areAll)
  {
    finite.clear();
  }
  return finite;
}

/// Checks one cell after the other; one object per task.
class Checker
{
public:
  Checker(vtkPointSet* input, const CellReader& cells, const std::vector<unsigned char>& finite,
    const unsigned char* ghosts)
    : Cells(cells)
    , NumberOfPoints(input->GetNumberOfPoints())
    , Finite(finite.empty() ? nullptr : finite.data())
    , Ghosts(ghosts)
    , NonLinear(input)
  {
  }

  CellState Check(vtkIdType cellId)
  {
    if (this->Ghosts && IsHiddenCell(this->Ghosts[cellId]))
    {
      return CellState::Hidden;
    }
    const int type = this->Cells.GetCellType(cellId);
    const int required = GetRequiredSize(type);
    if (required == 0)
    {
      return CellState::UnsupportedType;
    }
    const CellIds cell = this->Cells.GetCell(cellId, this->Ids);
    const CellState state = this->CheckSize(cellId, type, required, cell)
      ? this->CheckIds(type, cell)
      : CellState::WrongSize;
    this->HasQuads = this->HasQuads || (TakesPart(state) && subdivision::HasQuads(type, cell.Size));
    return state;
  }

  bool HasQuads = false;

private:
  bool CheckSize(vtkIdType cellId, int type, int required, const CellIds& cell)
  {
    if (required < 0 ? cell.Size < -required : cell.Size != required)
    {
      return false;
    }
    if (type == FaceLoops)
    {
      return ForEachFaceLoop(type, cell, this->Scratch, [](const vtkIdType*, vtkIdType) {});
    }
    return required != -1 || type == VTK_POLY_VERTEX ||
      this->NonLinear.Find(type, cellId, cell.Size);
  }

  CellState CheckIds(int type, const CellIds& cell)
  {
    bool inRange = true;
    for (vtkIdType i = 0; i < cell.Size; ++i)
    {
      inRange = inRange && cell.Ids[i] >= 0 && cell.Ids[i] < this->NumberOfPoints;
    }
    if (!inRange)
    {
      return CellState::OutOfRange;
    }
    for (vtkIdType i = 0; this->Finite && i < cell.Size; ++i)
    {
      if (!this->Finite[cell.Ids[i]])
      {
        return CellState::NonFinite;
      }
    }
    return FindRepeats(type, cell, this->Scratch);
  }

  const CellReader& Cells;
  const vtkIdType NumberOfPoints;
  const unsigned char* Finite;
  const unsigned char* Ghosts;
  NonLinearCells NonLinear;
  std::vector<vtkIdType> Ids;
  std::vector<vtkIdType> Scratch;
};

std::string DescribeUnsupported(const CellTally& tally, const CellReader& cells)
{
  return "Passed over " + Describe(tally, cells) +
    " of a type that is not supported. Supported are vertices, lines, poly lines, triangles, "
    "strips, pixels, quads, polygons, tetrahedra, voxels, hexahedra, wedges, pyramids, prisms, "
    "polyhedra, and quadratic, cubic, Lagrange and Bezier cells. Apply "
    "vtkDataSetTriangleFilter first to have others split.";
}

const char* Reason(CellState state)
{
  switch (state)
  {
    case CellState::WrongSize:
      return " whose number of points does not fit the cell type. Correct the cells in the program "
             "that wrote them.";
    case CellState::OutOfRange:
      return " with a point id that is negative or not below the number of points. Correct the "
             "cells "
             "in the program that wrote them.";
    case CellState::NonFinite:
      return " with a point whose coordinates are infinite or not a number. Correct the "
             "coordinates, "
             "or remove these cells.";
    default:
      return "";
  }
}

std::string DescribeRepeats(
  const CellTally& whole, const CellTally& partly, const CellReader& cells)
{
  CellTally all;
  all.Count = whole.Count + partly.Count;
  all.First =
    whole.Count && (!partly.Count || whole.First < partly.First) ? whole.First : partly.First;
  std::string text = "Passed over ";
  text += partly.Count == 0 ? ""
    : whole.Count == 0      ? "the degenerate pieces of "
                            : "all or part of ";
  return text + Describe(all, cells) +
    " with repeated point ids. Remove collapsed cells from the mesh if they are not intended.";
}

}

const unsigned char* GetGhosts(vtkPointSet* input, vtkIdType numberOfCells)
{
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
    input->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  return ghosts && ghosts->GetNumberOfValues() >= numberOfCells ? ghosts->GetPointer(0) : nullptr;
}

bool HasDuplicates(vtkPointSet* input)
{
  const vtkIdType size = input->GetNumberOfCells();
  const unsigned char* types = GetGhosts(input, size);
  return types &&
    std::any_of(types, types + size,
      [](unsigned char type) { return type & vtkDataSetAttributes::DUPLICATECELL; });
}

int GetDimensionOfType(int cellType)
{
  const int type = IsNonLinear(cellType) ? GetCornerCell(cellType, VTK_INT_MAX).Type : cellType;
  if (IsPolyhedron(type) || GetFaceTable(type))
  {
    return 3;
  }
  switch (type)
  {
    case VTK_VERTEX:
    case VTK_POLY_VERTEX:
      return 0;
    case VTK_LINE:
    case VTK_POLY_LINE:
      return 1;
    default:
      return GetRequiredSize(type) == 0 ? -1 : 2;
  }
}

CheckedCells CheckCells(vtkPointSet* input, const CellReader& cells)
{
  CheckedCells checked;
  const vtkIdType size = cells.GetNumberOfCells();
  checked.States.resize(static_cast<size_t>(size));
  const std::vector<unsigned char> finite = FindFinitePoints(input);
  const unsigned char* ghosts = GetGhosts(input, size);
  std::vector<unsigned char> haveQuads(static_cast<size_t>(cells.GetNumberOfBlocks()));
  ForCellBlocks(cells,
    [&](vtkIdType block, vtkIdType begin, vtkIdType end)
    {
      Checker checker(input, cells, finite, ghosts);
      for (vtkIdType i = begin; i < end; ++i)
      {
        checked.States[i] = checker.Check(i);
      }
      haveQuads[block] = checker.HasQuads ? 1 : 0;
    });
  checked.HasQuads = std::find(haveQuads.begin(), haveQuads.end(), 1) != haveQuads.end();
  return checked;
}

std::string Describe(const CellTally& tally, const CellReader& cells)
{
  const int stored = cells.GetCellType(tally.First);
  const int type = stored == FaceLoops ? VTK_POLYHEDRON : stored;
  std::string text = tally.Count == 1 ? "1 cell" : std::to_string(tally.Count) + " cells";
  text += tally.Count == 1 ? " (cell " : " (the first is cell ";
  text += std::to_string(tally.First) + ", type " + std::to_string(type);
  const auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
  return text + (cell ? std::string(", ") + cell->GetClassName() : std::string()) + ")";
}

std::vector<std::string> DescribePassedOver(const CellReader& cells, const CheckedCells& checked)
{
  std::vector<std::string> warnings;
  std::array<CellTally, static_cast<size_t>(CellState::NumberOfStates)> tallies;
  for (const vtkIdType i : InTurn(cells.GetNumberOfCells()))
  {
    tallies[static_cast<size_t>(checked.States[i])].Add(i);
  }
  const auto of = [&](CellState state) -> const CellTally&
  { return tallies[static_cast<size_t>(state)]; };
  if (of(CellState::UnsupportedType).Count)
  {
    warnings.push_back(DescribeUnsupported(of(CellState::UnsupportedType), cells));
  }
  for (const CellState state :
    { CellState::WrongSize, CellState::OutOfRange, CellState::NonFinite })
  {
    if (of(state).Count)
    {
      warnings.push_back("Passed over " + Describe(of(state), cells) + Reason(state));
    }
  }
  const CellTally& whole = of(CellState::Repeated);
  const CellTally& partly = of(CellState::PartlyRepeated);
  if (whole.Count || partly.Count)
  {
    warnings.push_back(DescribeRepeats(whole, partly, cells));
  }
  return warnings;
}

}
