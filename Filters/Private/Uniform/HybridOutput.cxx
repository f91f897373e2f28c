// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Uniform/HybridOutput.h"

#include "Core/Memory/FreedPages.h"
#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Solids/TetOct/TetOctCells.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Uniform/HybridFacts.h"

#include "vtkCellType.h"
#include "vtkNew.h"
#include "vtkTypeInt32Array.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

namespace subdivision
{
namespace
{

constexpr std::array<unsigned char, NumberOfShapes - 1> Types = { VTK_VERTEX, VTK_LINE,
  VTK_TRIANGLE, VTK_QUAD, VTK_TETRA, VTK_PYRAMID, VTK_WEDGE, VTK_HEXAHEDRON };

/// The cells that a cell of a type is in the output.
struct Pieces
{
  std::vector<CellChild> Cells;
  int Count = 0; ///< an octahedron is four
  int Corners = 0;
  int Octahedra = 0;
};

std::array<Pieces, NumberOfShapes> ListPieces(bool splits)
{
  std::array<Pieces, NumberOfShapes> all;
  for (int s = 0; s < NumberOfShapes; ++s)
  {
    const auto shape = static_cast<CellShape>(s);
    CellChild itself{ shape, {}, {}, {} };
    std::iota(itself.Points.begin(), itself.Points.end(), static_cast<unsigned char>(0));
    Pieces& pieces = all.at(s);
    pieces.Cells = splits ? GetCellTable(shape).Children : std::vector<CellChild>{ itself };
    for (const CellChild& cell : pieces.Cells)
    {
      const bool isOctahedron = cell.Shape == CellShape::Octahedron;
      pieces.Count += isOctahedron ? 4 : 1;
      pieces.Corners += isOctahedron ? 16 : GetCellTable(cell.Shape).Corners;
      pieces.Octahedra += isOctahedron ? 1 : 0;
    }
  }
  return all;
}

/// The four tetrahedra around the shortest diagonal.
template <typename Id>
void CutIntoTetrahedra(const Id* corners, const Coordinates& points, vtkIdType* tets)
{
  Id sorted[6];
  std::copy_n(corners, 6, sorted);
  SortOctahedron(sorted);
  CutOctahedron(sorted, FindShortestDiagonal(sorted, points.Values, points.Tie), tets);
}

template <typename Id>
class Writer
{
public:
  Writer(CellComplex<Id> complex, bool splits, const std::vector<signed char>& signs)
    : Complex(std::move(complex))
    , Splits(splits)
    , Signs(signs)
    , OfShapes(ListPieces(splits))
    , First(this->Sum(&Pieces::Count))
    , FirstCorner(this->Sum(&Pieces::Corners))
  {
    const auto& shapes = this->Complex.Cells.Shapes;
    this->HasOctahedra = std::any_of(shapes.begin(), shapes.end(),
      [this](CellShape shape) { return this->Of(shape).Octahedra > 0; });
  }

  HybridOutput<Id> Write(bool small, const std::function<Coordinates()>& points)
  {
    const auto largest = static_cast<double>(std::max({ vtkIdType(*(this->FirstCorner.end() - 1)),
      this->Complex.GetNumberOfNewPoints(), this->Complex.Cells.NumberOfPoints }));
    if (this->HasOctahedra || !this->Signs.empty())
    {
      this->Points = points();
    }
    this->Made.Cells = vtkSmartPointer<vtkCellArray>::New();
    small&& largest < LargestSmallId ? this->WriteAs<vtkTypeInt32Array>()
                                     : this->WriteAs<vtkIdTypeArray>();
    this->WriteTypes();
    this->Made.First = std::move(this->First);
    return std::move(this->Made);
  }

private:
  const Pieces& Of(CellShape shape) const
  {
    return this->OfShapes[static_cast<std::size_t>(shape)];
  }
  const Pieces& Of(vtkIdType cell) const { return this->Of(this->Complex.Cells.Shapes[cell]); }

  /// Where the items of each cell begin, and all end.
  Buffer<Id> Sum(int Pieces::* count) const
  {
    const vtkIdType size = this->Complex.Cells.GetNumberOfCells();
    Buffer<Id> first(size + 1);
    ForEach(size, [&](vtkIdType c) { first[c] = this->Of(c).*count; });
    CountsToOffsets(first);
    return first;
  }

  /// Corners come first: what they are made of is as large as what follows.
  template <typename Array>
  void WriteAs()
  {
    this->Made.AreInverted = Buffer<unsigned char>(
      this->Signs.empty() ? 0 : vtkIdType(*(this->First.end() - 1)), static_cast<unsigned char>(0));
    vtkNew<Array> corners;
    Allocate(corners, 1, *(this->FirstCorner.end() - 1));
    auto* const to = corners->GetPointer(0);
    ForEach(this->First.size() - 1, [&](vtkIdType c) { this->WriteCorners(c, to); });
    this->Points = Coordinates(nullptr);
    CellList<Id>& cells = this->Complex.Cells;
    this->Complex.CellEdges = Rows<Id>();
    this->Complex.CellFaces = Rows<Id>();
    this->Complex.Centres = Buffer<Id>();
    cells.Offsets = Buffer<Id>();
    cells.Corners = Buffer<Id>();
    ReturnFreedPages();
    vtkNew<Array> offsets;
    Allocate(offsets, 1, vtkIdType(*(this->First.end() - 1)) + 1);
    auto* const begins = offsets->GetPointer(0);
    using Out = std::decay_t<decltype(*begins)>;
    begins[*(this->First.end() - 1)] = static_cast<Out>(*(this->FirstCorner.end() - 1));
    ForEach(this->First.size() - 1,
      [&](vtkIdType c)
      {
        Out* begin = begins + this->First[c];
        auto corner = static_cast<Out>(this->FirstCorner[c]);
        this->ForPieces(c,
          [&](CellShape shape, bool)
          {
            *begin++ = corner;
            corner += static_cast<Out>(GetCellTable(shape).Corners);
          });
      });
    this->Made.Cells->SetData(offsets, corners);
  }

  /// act(shape, isPiece) for the output cells of a cell.
  template <typename Act>
  void ForPieces(vtkIdType cell, const Act& act) const
  {
    for (const CellChild& child : this->Of(cell).Cells)
    {
      const bool isPiece = child.Shape == CellShape::Octahedron;
      for (int i = 0; i < (isPiece ? 4 : 1); ++i)
      {
        act(isPiece ? CellShape::Tet : child.Shape, isPiece);
      }
    }
  }

  template <typename Out>
  void WriteCorners(vtkIdType cell, Out* corners)
  {
    Id points[27];
    const CellList<Id>& cells = this->Complex.Cells;
    this->Splits
      ? FindPointsOfStep(this->Complex, cell, points)
      : static_cast<void>(std::copy(cells.GetCorners(cell), cells.GetCorners(cell + 1), points));
    corners += this->FirstCorner[cell];
    vtkIdType made = this->First[cell];
    const int sign = this->Signs.empty() ? 0 : this->Signs[static_cast<std::size_t>(cell)];
    for (const CellChild& child : this->Of(cell).Cells)
    {
      Id ends[8];
      const int size = GetCellTable(child.Shape).Corners;
      const int count = child.Shape == CellShape::Octahedron ? 4 : 1;
      std::transform(
        child.Points.begin(), child.Points.begin() + size, ends, [&](int k) { return points[k]; });
      if (sign != 0)
      {
        const bool isInverted = sign * FindOrientation(child.Shape, ends, this->Points) < 0;
        std::fill_n(this->Made.AreInverted.data() + made, count, isInverted ? 1 : 0);
      }
      made += count;
      if (count > 1)
      {
        vtkIdType tets[16];
        CutIntoTetrahedra(ends, this->Points, tets);
        corners =
          std::transform(tets, tets + 16, corners, [](vtkIdType p) { return static_cast<Out>(p); });
        continue;
      }
      corners = std::transform(
        ends, ends + size, corners, [](Id point) { return static_cast<Out>(point); });
    }
  }

  void WriteTypes()
  {
    const vtkIdType size = *(this->First.end() - 1);
    this->FirstCorner = Buffer<Id>();
    this->Made.Types = vtkSmartPointer<vtkUnsignedCharArray>::New();
    this->Made.Octahedra = vtkSmartPointer<vtkIdTypeArray>::New();
    this->Made.Octahedra->SetName(OctahedraName);
    Allocate(this->Made.Types, 1, size);
    Allocate(this->Made.Octahedra, 1, size);
    const Buffer<Id> first = this->HasOctahedra ? this->Sum(&Pieces::Octahedra) : Buffer<Id>();
    unsigned char* const types = this->Made.Types->GetPointer(0);
    vtkIdType* const octahedra = this->Made.Octahedra->GetPointer(0);
    ForEach(this->First.size() - 1,
      [&](vtkIdType c)
      {
        vtkIdType made = this->First[c];
        vtkIdType pieces = this->HasOctahedra ? 4 * vtkIdType(first[c]) : 0;
        this->ForPieces(c,
          [&](CellShape shape, bool isPiece)
          {
            types[made] = Types[static_cast<std::size_t>(shape)];
            octahedra[made++] = isPiece ? pieces++ / 4 : -1;
          });
      });
  }

  CellComplex<Id> Complex;
  const bool Splits;
  const std::vector<signed char>& Signs;
  const std::array<Pieces, NumberOfShapes> OfShapes;
  Buffer<Id> First;
  Buffer<Id> FirstCorner;
  bool HasOctahedra = false;
  Coordinates Points{ nullptr };
  HybridOutput<Id> Made;
};

}

template <typename Id>
HybridOutput<Id> WriteHybridCells(CellComplex<Id> complex, bool splits, bool small,
  const std::vector<signed char>& signs, const std::function<Coordinates()>& points)
{
  return Writer<Id>(std::move(complex), splits, signs).Write(small, points);
}

SUBDIVISION_COMPILE_FUNCTION(WriteHybridCells);

}
