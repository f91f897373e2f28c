// SPDX-License-Identifier: BSD-3-Clause
//
// The steps: check every cell; find the triangles that decide the diagonals of quads; count the
// pieces that each block of cells will have; let each block write its pieces to the positions that
// follow from the counts. No block reads data of another one.
#include "Private/Reading/CellsToSimplices.h"

#include "Core/Memory/Sorting.h"
#include "Private/Reading/CellChecks.h"
#include "Private/Reading/CellReader.h"
#include "Private/Reading/CellSplitter.h"
#include "Private/Reading/QuadDiagonals.h"
#include "Private/Reading/TrianglesNearQuads.h"

#include "vtkCellType.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace subdivision
{

namespace
{

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
      CellSplitter<Counter> splitter(cells, input, diagonals, counter);
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
      CellSplitter<Writer> splitter(cells, input, diagonals, writer);
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
