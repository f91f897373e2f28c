// SPDX-License-Identifier: BSD-3-Clause
//
// The steps: check every cell; find the triangles that decide the diagonals of quads; count the
// pieces that each block of cells will have; let each block write its pieces to the positions that
// follow from the counts. No block reads data of another one.
#include "Private/Reading/CellsToSimplices.h"

#include "Core/Memory/Sorting.h"
#include "Private/Reading/CellChecks.h"
#include "Private/Reading/CellReader.h"
#include "Private/Reading/NonLinearCells.h"
#include "Private/Reading/PolygonEars.h"
#include "Private/Reading/PolyhedronFaces.h"
#include "Private/Reading/QuadDiagonals.h"
#include "Private/Reading/SolidCells.h"
#include "Private/Reading/TrianglesNearQuads.h"

#include "vtkCellType.h"
#include "vtkMath.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace subdivision
{

namespace
{

bool IsRepeated(const vtkIdType* ids, int size)
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

/// How much a block of cells gives, or all blocks before it: simplices, their point ids, centres,
/// and the points whose means the centres are.
struct Amounts
{
  vtkIdType Simplices = 0;
  vtkIdType Ids = 0;
  vtkIdType Centres = 0;
  vtkIdType Members = 0;

  void operator+=(const Amounts& other)
  {
    this->Simplices += other.Simplices;
    this->Ids += other.Ids;
    this->Centres += other.Centres;
    this->Members += other.Members;
  }
};

struct ContestedQuad
{
  QuadKey Key;
  vtkIdType CellId;
  bool operator<(const ContestedQuad& other) const
  {
    return this->Key != other.Key ? this->Key < other.Key : this->CellId < other.CellId;
  }
};

/// First run: how much there will be.
class Counter
{
public:
  static constexpr bool Counts = true;

  void AddSimplex(vtkIdType, const vtkIdType*, int size)
  {
    ++this->Total.Simplices;
    this->Total.Ids += size;
  }
  vtkIdType AddCentre(const vtkIdType*, int size)
  {
    ++this->Total.Centres;
    this->Total.Members += size;
    return VTK_ID_MAX; // no point of the input
  }
  void AddContested(const vtkIdType* quad, vtkIdType cellId)
  {
    this->AddContested(MakeQuadKey(quad), cellId);
  }
  void AddContested(const QuadKey& key, vtkIdType cellId)
  {
    this->Contested.push_back({ key, cellId });
  }

  Amounts Total;
  std::vector<ContestedQuad> Contested;
};

/// Second run: writes to where the counts say.
class Writer
{
public:
  static constexpr bool Counts = false;

  Writer(SimplicesOfCells& output, const Amounts& start, vtkIdType firstCentre)
    : Output(output)
    , At(start)
    , FirstCentre(firstCentre)
  {
  }

  void AddSimplex(vtkIdType cellId, const vtkIdType* ids, int size)
  {
    this->Output.Simplices.Dimensions[this->At.Simplices] = static_cast<unsigned char>(size - 1);
    std::copy(ids, ids + size, this->Output.Simplices.Connectivity.begin() + this->At.Ids);
    if (!this->Output.ParentCells.empty())
    {
      this->Output.ParentCells[this->At.Simplices] = cellId;
    }
    ++this->At.Simplices;
    this->At.Ids += size;
  }
  vtkIdType AddCentre(const vtkIdType* ids, int size)
  {
    std::copy(ids, ids + size, this->Output.CentreMembers.begin() + this->At.Members);
    this->At.Members += size;
    this->Output.CentreOffsets[this->At.Centres + 1] = this->At.Members;
    return this->FirstCentre + this->At.Centres++;
  }
  template <typename Quad>
  void AddContested(const Quad&, vtkIdType)
  {
  }

private:
  SimplicesOfCells& Output;
  Amounts At;
  const vtkIdType FirstCentre;
};

/// Splits one cell after the other into a Counter or a Writer; one object per task.
template <typename Sink>
class Splitter
{
public:
  Splitter(const CellReader& cells, vtkPointSet* input, const QuadDiagonals& diagonals, Sink& sink)
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
      // Both cells at a face have to cut it alike: from its smallest point on, to the smaller side.
      std::rotate(
        face, std::min_element(face, face + size, this->Diagonals.GetOrder()), face + size);
      const bool turns = this->Diagonals.GetOrder()(face[size - 1], face[1]);
      if (turns)
      {
        std::reverse(face + 1, face + size);
      }
      for (const auto& t : this->Ears.Cut(face, size))
      {
        add(t[0], t[turns ? 2 : 1], t[turns ? 1 : 2]);
      }
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

struct Counts
{
  std::vector<Amounts> Starts; ///< of each block
  Amounts Total;
  bool OnePerCell = true; ///< every cell gives exactly one simplex
  std::vector<ContestedQuad> Contested;
};

Counts CountPieces(const CellReader& cells, vtkPointSet* input, const CheckedCells& checked,
  const QuadDiagonals& diagonals)
{
  const size_t blocks = static_cast<size_t>(cells.GetNumberOfBlocks());
  std::vector<Counter> counters(blocks);
  std::vector<unsigned char> onePerCell(blocks, 1);
  ForCellBlocks(cells,
    [&](vtkIdType block, vtkIdType begin, vtkIdType end)
    {
      Counter counter; // a local one: neighbours in the vector would share cache lines
      Splitter<Counter> splitter(cells, input, diagonals, counter);
      for (vtkIdType cellId = begin; cellId < end; ++cellId)
      {
        splitter.Split(cellId, checked.States[cellId]);
        if (counter.Total.Simplices != cellId - begin + 1)
        {
          onePerCell[block] = 0;
        }
      }
      counters[block] = std::move(counter);
    });
  Counts counts;
  for (size_t block = 0; block < blocks; ++block)
  {
    const Counter& counter = counters[block];
    counts.Starts.push_back(counts.Total);
    counts.Total += counter.Total;
    counts.OnePerCell = counts.OnePerCell && onePerCell[block];
    counts.Contested.insert(
      counts.Contested.end(), counter.Contested.begin(), counter.Contested.end());
  }
  return counts;
}

void DescribeContested(std::vector<ContestedQuad>&& quads, std::vector<std::string>& warnings)
{
  if (quads.empty())
  {
    return;
  }
  StableSort(quads, std::less<>());
  quads.erase(std::unique(quads.begin(), quads.end(),
                [](const ContestedQuad& a, const ContestedQuad& b) { return a.Key == b.Key; }),
    quads.end());
  const auto first = std::min_element(quads.begin(), quads.end(),
    [](const ContestedQuad& a, const ContestedQuad& b) { return a.CellId < b.CellId; });
  const bool one = quads.size() == 1;
  warnings.push_back((one ? "1 quad touches" : std::to_string(quads.size()) + " quads touch") +
    " triangles on both diagonals (" + (one ? "" : "the first ") + "in cell " +
    std::to_string(first->CellId) +
    "): the filter takes the diagonal through the smallest point id, and cells do not fit together "
    "there. Look for overlapping cells.");
}

/// Finds the dimensions of the cells if these are simplices all, without a fault. Returns false,
/// and no dimensions, if one is not.
bool ReadPlainSimplices(
  const CellReader& cells, const CheckedCells& checked, std::vector<unsigned char>& dimensions)
{
  // Of a simplex, by the numbers of VTK's types; 0: it never is one.
  constexpr int sizes[VTK_TETRA + 1] = { 0, 1, 1, 2, 2, 3, 3, 3, 0, 0, 4 };
  const auto getSize = [&](vtkIdType cell, std::vector<vtkIdType>& scratch)
  {
    const int type = cells.GetCellType(cell);
    const int size = checked.States[cell] == CellState::Good && type <= VTK_TETRA ? sizes[type] : 0;
    return size > 0 && cells.GetCell(cell, scratch).Size == size ? size : 0;
  };
  ResizeInHugePages(dimensions, cells.GetNumberOfCells());
  std::atomic<bool> plain{ true };
  ForCellBlocks(cells,
    [&](vtkIdType, vtkIdType begin, vtkIdType end)
    {
      std::vector<vtkIdType> scratch;
      for (vtkIdType i = begin; plain && i < end; ++i)
      {
        const int size = getSize(i, scratch);
        dimensions[i] = static_cast<unsigned char>(size - 1);
        if (size == 0)
        {
          plain = false;
        }
      }
    });
  if (!plain)
  {
    dimensions.clear();
  }
  return plain;
}

void SplitCells(const CellReader& cells, vtkPointSet* input, const CheckedCells& checked,
  const QuadDiagonals& diagonals, SimplicesOfCells& output)
{
  Counts counts = CountPieces(cells, input, checked, diagonals);
  DescribeContested(std::move(counts.Contested), output.Warnings);
  const auto size = [](vtkIdType amount) { return static_cast<size_t>(amount); };
  ResizeInHugePages(output.Simplices.Dimensions, counts.Total.Simplices);
  ResizeInHugePages(output.Simplices.Connectivity, counts.Total.Ids);
  ResizeInHugePages(output.ParentCells, counts.OnePerCell ? 0 : counts.Total.Simplices);
  output.CentreOffsets.resize(size(counts.Total.Centres) + 1);
  output.CentreMembers.resize(size(counts.Total.Members));
  const vtkIdType firstCentre = output.Simplices.NumberOfPoints;
  ForCellBlocks(cells,
    [&](vtkIdType block, vtkIdType begin, vtkIdType end)
    {
      Writer writer(output, counts.Starts[block], firstCentre);
      Splitter<Writer> splitter(cells, input, diagonals, writer);
      for (vtkIdType cellId = begin; cellId < end; ++cellId)
      {
        splitter.Split(cellId, checked.States[cellId]);
      }
    });
  output.Simplices.NumberOfPoints += counts.Total.Centres;
}

}

void SimplicesOfCells::TakeIds()
{
  if (this->InPlace)
  {
    vtkIdType size = 0;
    for (unsigned char dimension : InTurn(this->Simplices.Dimensions))
    {
      size += dimension + 1;
    }
    this->Simplices.Connectivity.assign(this->InPlace, this->InPlace + size);
    this->InPlace = nullptr;
  }
}

SimplicesOfCells CellsToSimplices(vtkPointSet* input, const vtkIdType* globalIds, PlainIds ids)
{
  SimplicesOfCells output;
  output.Simplices.NumberOfPoints = input->GetNumberOfPoints();
  const CellReader cells(input);
  const CheckedCells checked = CheckCells(input, cells);
  if (ReadPlainSimplices(cells, checked, output.Simplices.Dimensions))
  {
    // Each cell is one simplex, so that its ids are used as they are.
    output.InPlace = ids == PlainIds::InPlace ? cells.FindAllIds() : nullptr;
    if (!output.InPlace)
    {
      cells.GetAllIds(output.Simplices.Connectivity);
    }
    return output;
  }
  output.Warnings = DescribePassedOver(cells, checked);
  QuadDiagonals diagonals(PointOrder{ globalIds });
  if (checked.HasQuads)
  {
    diagonals.SetTriangles(
      FindTrianglesNearQuads(input, cells, checked), input->GetNumberOfPoints());
  }
  SplitCells(cells, input, checked, diagonals, output);
  return output;
}

}
