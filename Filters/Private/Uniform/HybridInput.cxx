// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Uniform/HybridInput.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Memory/Sorting.h"
#include "Core/Solids/TetOct/TetOctCells.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Reading/CellChecks.h"
#include "Private/Reading/CellReader.h"
#include "Private/Reading/CellSplitter.h"
#include "Private/Reading/CollapsedCells.h"
#include "Private/Reading/NonLinearCells.h"
#include "Private/Reading/PolygonEars.h"
#include "Private/Reading/PolyhedronFaces.h"
#include "Private/Reading/SolidCells.h"
#include "Private/Reading/TrianglesNearQuads.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace subdivision
{
namespace
{

/// Reads the cells of a block one after the other.
class HybridReader
{
public:
  HybridReader(vtkPointSet* input, const CellReader& reader, const PointOrder& order,
    CheckedCells& checked, HybridCells& result)
    : Reader(reader)
    , NonLinear(input)
    , Ears(input->GetPoints(), order)
    , Checked(checked)
    , Result(result)
  {
  }

  void Read(vtkIdType cell)
  {
    CellState& state = this->Checked.States[static_cast<std::size_t>(cell)];
    const int type = this->Reader.GetCellType(cell);
    const bool isQuad = type == VTK_QUAD || type == VTK_PIXEL;
    if (!TakesPart(state) && !(isQuad && state == CellState::Repeated))
    {
      return;
    }
    this->Cell = cell;
    this->IsGood = state == CellState::Good;
    this->LosesPieces = false;
    const std::size_t before = this->Result.Shapes.size();
    const CellIds ids = this->Reader.GetCell(cell, this->Ids);
    if (IsPolyhedron(type))
    {
      this->AddStar(type, ids);
    }
    else if (IsNonLinear(type))
    {
      this->AddPieces(type, ids);
    }
    else
    {
      this->AddLinear(type, ids.Ids, ids.Size);
    }
    if (!this->IsGood)
    {
      const bool isLost = this->Result.Shapes.size() == before;
      state = isLost        ? CellState::Repeated
        : this->LosesPieces ? CellState::PartlyRepeated
                            : CellState::Good;
    }
  }

  CellTally WithoutChildren; ///< that are cut

private:
  void AddLinear(int type, const vtkIdType* p, vtkIdType size)
  {
    switch (type)
    {
      case VTK_VERTEX:
      case VTK_POLY_VERTEX:
        this->AddWindows(CellShape::Vertex, p, size);
        break;
      case VTK_LINE:
      case VTK_POLY_LINE:
        this->AddWindows(CellShape::Line, p, size);
        break;
      case VTK_TRIANGLE:
        this->Add(CellShape::Triangle, p);
        break;
      case VTK_TRIANGLE_STRIP:
        for (vtkIdType i = 0; i + 2 < size; ++i)
        {
          vtkIdType triangle[3];
          GetStripTriangle(p, i, triangle);
          this->Add(CellShape::Triangle, triangle);
        }
        break;
      case VTK_PIXEL:
      case VTK_QUAD:
        vtkIdType quad[4];
        GetQuad(type, p, quad);
        this->AddPolygon(quad, 4);
        break;
      case VTK_POLYGON:
        this->AddPolygon(p, size);
        break;
      case VTK_TETRA:
        this->Add(CellShape::Tet, p);
        break;
      default:
        this->AddSolid(type, p, static_cast<int>(size));
        break;
    }
  }

  /// Adds a cell whose points differ.
  void Add(CellShape shape, const vtkIdType* corners)
  {
    if (this->IsGood || !IsRepeated(corners, GetCellTable(shape).Corners))
    {
      this->Result.Add(this->Cell, shape, corners);
    }
    else
    {
      this->LosesPieces = true;
    }
  }

  void AddWindows(CellShape shape, const vtkIdType* p, vtkIdType size)
  {
    for (vtkIdType i = 0; i + GetCellTable(shape).Corners <= size; ++i)
    {
      this->Add(shape, p + i);
    }
  }

  void AddPolygon(const vtkIdType* p, vtkIdType size)
  {
    this->Loop.assign(p, p + size);
    size = this->IsGood ? size : CollapseLoop(this->Loop.data(), size);
    if (size == 3)
    {
      this->Add(CellShape::Triangle, this->Loop.data());
    }
    else if (size == 4)
    {
      this->Add(CellShape::Quad, this->Loop.data());
    }
    else if (size > 4)
    {
      for (const auto& triangle : this->Ears.Cut(this->Loop.data(), size))
      {
        this->Add(CellShape::Triangle, triangle.data());
      }
    }
  }

  void AddSolid(int type, const vtkIdType* p, int size)
  {
    if (!this->IsGood && IsRepeated(p, size))
    {
      const CollapsedCell left = CollapseSolid(type, p);
      if (left.Type == FaceLoops)
      {
        this->AddStar(
          left.Type, { left.Points.data(), static_cast<vtkIdType>(left.Points.size()) });
      }
      else if (left.Type != VTK_EMPTY_CELL)
      {
        this->AddWhole(left.Type, left.Points.data());
      }
      this->LosesPieces = this->LosesPieces || left.Type == VTK_EMPTY_CELL;
    }
    else
    {
      this->AddWhole(type, p);
    }
  }
  void AddWhole(int type, const vtkIdType* p)
  {
    if (type == VTK_VOXEL)
    {
      const vtkIdType hex[8] = { p[0], p[1], p[3], p[2], p[4], p[5], p[7], p[6] };
      this->Result.Add(this->Cell, CellShape::Hex, hex);
      return;
    }
    this->Result.Add(this->Cell,
      type == VTK_HEXAHEDRON  ? CellShape::Hex
        : type == VTK_WEDGE   ? CellShape::Wedge
        : type == VTK_PYRAMID ? CellShape::Pyramid
                              : CellShape::Tet,
      p);
  }

  void AddStar(int type, const CellIds& cell)
  {
    this->TellOfCut();
    vtkIdType centre = NoPoint;
    ForEachFaceLoop(type, cell, this->Faces,
      [&](vtkIdType* loop, vtkIdType size) { this->AddCone(cell, centre, loop, size); });
  }
  /// Makes the cells between a face, which looks outwards, and the centre of the cell. The centre
  /// is made for the first face that needs it.
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
      SortDistinct(this->Loop);
      centre = this->Result.AddCentre(
        this->Cell, this->Loop.data(), static_cast<vtkIdType>(this->Loop.size()));
    }
    const auto add = [&](vtkIdType a, vtkIdType b, vtkIdType c)
    {
      const vtkIdType triangle[3] = { a, b, c };
      if (this->IsGood || !IsRepeated(triangle, 3))
      {
        this->Result.AddCone(this->Cell, centre, triangle, 3);
      }
    };
    if (size > 4)
    {
      this->Ears.CutFace(face, size, add);
    }
    else
    {
      this->Result.AddCone(this->Cell, centre, face, size);
    }
  }

  void AddPieces(int type, const CellIds& cell)
  {
    const CellPieces& table = *this->NonLinear.Find(type, this->Cell, cell.Size);
    vtkIdType centre = table.Centre < 0 ? NoPoint : cell.Ids[table.Centre];
    ForEachPiece(table, cell,
      [&](int pieceType, const CellIds& piece)
      {
        if (pieceType == CellPiece::Octahedron)
        {
          const vtkIdType* p = piece.Ids;
          const vtkIdType octahedron[6] = { p[1], p[0], p[2], p[3], p[4], p[5] };
          this->Add(CellShape::Octahedron, octahedron);
        }
        else if (table.Dimension == 3 && (pieceType == VTK_TRIANGLE || pieceType == VTK_QUAD))
        {
          vtkIdType face[4];
          std::copy(piece.Ids, piece.Ids + piece.Size, face);
          this->AddCone(cell, centre, face, piece.Size);
        }
        else
        {
          this->AddLinear(pieceType, piece.Ids, piece.Size);
        }
      });
  }

  void TellOfCut()
  {
    if (this->WithoutChildren.Count == 0 || this->LastCut != this->Cell)
    {
      this->WithoutChildren.Add(this->Cell);
    }
    this->LastCut = this->Cell;
  }

  static constexpr vtkIdType NoPoint = -1;

  const CellReader& Reader;
  NonLinearCells NonLinear;
  PolygonEars Ears;
  CheckedCells& Checked;
  HybridCells& Result;
  vtkIdType Cell = 0;
  vtkIdType LastCut = -1;
  bool IsGood = true;
  bool LosesPieces = false;
  std::vector<vtkIdType> Ids;
  std::vector<vtkIdType> Loop;
  std::vector<vtkIdType> Faces;
};

/// Four tetrahedra with one OctahedronId become the octahedron that they were cut from.
void JoinPieces(vtkDataArray* numbers, HybridCells& cells)
{
  HybridCells joined;
  joined.NumberOfPoints = cells.NumberOfPoints;
  joined.Centres = std::move(cells.Centres);
  joined.CentreSources = std::move(cells.CentreSources);
  joined.Warnings = std::move(cells.Warnings);
  int pieces = 0;
  double last = -1.;
  const vtkIdType* corners = cells.Corners.data();
  for (const std::size_t c : InTurn(cells.Shapes.size()))
  {
    const CellShape shape = cells.Shapes[c];
    joined.Add(cells.Sources[c], shape, corners);
    corners += GetCellTable(shape).Corners;
    const double number =
      shape == CellShape::Tet ? numbers->GetComponent(cells.Sources[c], 0) : -1.;
    pieces = number >= 0. && number == last ? pieces + 1 : 1;
    last = number;
    if (number < 0. || pieces < 4)
    {
      continue;
    }
    const vtkIdType* tets = joined.Corners.data() + joined.Corners.size() - 16;
    vtkIdType octahedron[6];
    vtkIdType again[16];
    JoinOctahedron(tets, octahedron);
    CutOctahedron(octahedron, 0, again);
    if (std::equal(again, again + 16, tets))
    {
      joined.Shapes.resize(joined.Shapes.size() - 4);
      joined.Sources.resize(joined.Sources.size() - 4);
      joined.Corners.resize(joined.Corners.size() - 16);
      joined.Add(cells.Sources[c - 3], CellShape::Octahedron, octahedron);
    }
    pieces = 0;
  }
  cells = std::move(joined);
}

void TellOfCuts(const CellTally& cut, const CellReader& reader, std::vector<std::string>& warnings)
{
  if (cut.Count > 0)
  {
    warnings.push_back(Describe(cut, reader) + (cut.Count == 1 ? " has" : " have") +
      " no children of the same type: the filter cuts solids into tetrahedra and pyramids "
      "around a point in their middle.");
  }
}

}

bool HasUncutCells(vtkPointSet* input)
{
  const CellReader reader(input);
  const unsigned char* ghosts = GetGhosts(input, reader.GetNumberOfCells());
  std::vector<vtkIdType> scratch;
  const auto isUncut = [&](vtkIdType cell)
  {
    switch (reader.GetCellType(cell))
    {
      case VTK_HEXAHEDRON:
      case VTK_VOXEL:
      case VTK_WEDGE:
      case VTK_PYRAMID:
      case VTK_QUAD:
      case VTK_PIXEL:
        return true;
      case VTK_POLYGON:
        return reader.GetCell(cell, scratch).Size == 4;
      default:
        return false;
    }
  };
  for (const vtkIdType cell : InTurn(reader.GetNumberOfCells()))
  {
    if (!(ghosts && IsHiddenCell(ghosts[cell])) && isUncut(cell))
    {
      return true;
    }
  }
  return false;
}

HybridCells ReadHybridCells(vtkPointSet* input, const vtkIdType* globalIds)
{
  const CellReader reader(input);
  const PointOrder order{ globalIds };
  CheckedCells checked = CheckCells(input, reader);
  HybridCells cells;
  cells.NumberOfPoints = input->GetNumberOfPoints();
  std::vector<HybridCells> blocks(static_cast<std::size_t>(reader.GetNumberOfBlocks()), cells);
  std::vector<CellTally> cuts(blocks.size());
  ForCellBlocks(reader,
    [&](vtkIdType block, vtkIdType begin, vtkIdType end)
    {
      HybridReader read(input, reader, order, checked, blocks[static_cast<std::size_t>(block)]);
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        read.Read(cell);
      }
      cuts[static_cast<std::size_t>(block)] = read.WithoutChildren;
    });
  CellTally cut;
  for (const std::size_t block : InTurn(blocks.size()))
  {
    cells.Append(blocks[block]);
    blocks[block] = HybridCells();
    cut.Add(cuts[block]);
  }
  cells.Warnings = DescribePassedOver(reader, checked);
  TellOfCuts(cut, reader, cells.Warnings);
  if (vtkDataArray* octahedra = input->GetCellData()->GetArray(OctahedraName))
  {
    JoinPieces(octahedra, cells);
  }
  GiveWayToTriangles(cells, order);
  return cells;
}

template <typename Id>
CellList<Id> ListCells(const HybridCells& cells)
{
  const auto size = static_cast<vtkIdType>(cells.Shapes.size());
  CellList<Id> list;
  list.NumberOfPoints = cells.NumberOfPoints;
  list.Shapes = Buffer<CellShape>(size);
  CopyInThreads(cells.Shapes.data(), size, list.Shapes.data());
  list.Offsets = Buffer<Id>(size + 1);
  ForEach(size, [&](vtkIdType c) { list.Offsets[c] = static_cast<Id>(list.GetTable(c).Corners); });
  CountsToOffsets(list.Offsets);
  list.Corners = Buffer<Id>(static_cast<vtkIdType>(cells.Corners.size()));
  CopyInThreads(cells.Corners.data(), list.Corners.size(), list.Corners.data());
  return list;
}

SUBDIVISION_COMPILE_FUNCTION(ListCells);

}
