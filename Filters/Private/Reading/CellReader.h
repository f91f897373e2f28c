// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellReader.h
 * Reads the cells of a vtkUnstructuredGrid or vtkPolyData by cell id, in several threads at once.
 * It builds nothing inside the data set, which threads share. It does not check point ids: a cell
 * may name points that do not exist.
 */
#ifndef SubdivisionObjects_CellReader_h
#define SubdivisionObjects_CellReader_h

#include "Core/Memory/Buffer.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <vector>

class vtkCellArray;
class vtkDataArray;
class vtkPointSet;

namespace subdivision
{

/// The point ids of one cell, as stored.
struct CellIds
{
  const vtkIdType* Ids = nullptr;
  vtkIdType Size = 0;
};

/// Sets the size of a list that is empty. It gets huge pages before anything is written there.
template <typename T>
void ResizeInHugePages(std::vector<T>& list, vtkIdType size)
{
  list.reserve(static_cast<std::size_t>(size));
  AdviseHugePages(list.data(), sizeof(T) * list.capacity());
  list.resize(static_cast<std::size_t>(size));
}

/// The number of cells in a block, which one task reads. The bounds of blocks are fixed, so that
/// results do not depend on the number of threads.
constexpr vtkIdType CellsPerBlock = 4096;

class CellReader
{
public:
  explicit CellReader(vtkPointSet* input);

  vtkIdType GetNumberOfCells() const { return this->NumberOfCells; }
  vtkIdType GetNumberOfBlocks() const
  {
    return (this->NumberOfCells + CellsPerBlock - 1) / CellsPerBlock;
  }

  /// The VTK cell type. In a vtkPolyData it is POLY_VERTEX, POLY_LINE, POLYGON or TRIANGLE_STRIP,
  /// by the vtkCellArray that has the cell.
  int GetCellType(vtkIdType cellId) const
  {
    return this->Types ? this->Types[cellId] : this->FindPart(cellId).Type;
  }

  /// The VTK cell type that the cell has in a vtkUnstructuredGrid, by its size: a vtkPolyData calls
  /// triangles polygons, too.
  int GetGridType(vtkIdType cellId, vtkIdType size) const;

  /// The result points into the input or, where ids are stored in another type than vtkIdType, into
  /// `scratch`, which callers reuse. It is empty where the offsets of the cell are not valid.
  CellIds GetCell(vtkIdType cellId, std::vector<vtkIdType>& scratch) const;

  /// All ids of all cells, in cell order. Offsets that are not valid are cut to the existing ids.
  void GetAllIds(std::vector<vtkIdType>& ids) const;
  /// The same without a copy, as a pointer into the input; null if the input does not have them in
  /// one array of vtkIdType.
  const vtkIdType* FindAllIds() const;

  /// An array of integers of 32 or 64 bits, read through a plain pointer.
  struct Integers
  {
    void Set(vtkDataArray* array);
    template <typename Work>
    auto Visit(const Work& work) const
    {
      return this->Data64 ? work(this->Data64) : work(this->Data32);
    }
    vtkIdType operator[](vtkIdType i) const
    {
      return this->Data64 ? static_cast<vtkIdType>(this->Data64[i])
                          : static_cast<vtkIdType>(this->Data32[i]);
    }

    const vtkTypeInt64* Data64 = nullptr;
    const vtkTypeInt32* Data32 = nullptr;
    vtkIdType Size = 0;
    bool IsCopy = false; ///< the array could not be read as it is
    vtkSmartPointer<vtkDataArray> Owner;
  };

  /// The cells of one vtkCellArray: an unstructured grid has one part, a vtkPolyData up to four.
  struct Part
  {
    vtkIdType End = 0; ///< one past its last cell
    vtkIdType Begin = 0;
    int Type = 0; ///< of vtkPolyData's cells
    Integers Offsets;
    Integers Ids;
  };
  const Part& FindPart(vtkIdType cellId) const;
  /// Of each cell; null for vtkPolyData.
  const unsigned char* GetTypes() const { return this->Types; }

private:
  void Add(vtkCellArray* cells, int type);

  const unsigned char* Types = nullptr;
  vtkSmartPointer<vtkUnsignedCharArray> TypesOwner;
  std::vector<Part> Parts;
  vtkIdType NumberOfCells = 0;
};

inline const CellReader::Part& CellReader::FindPart(vtkIdType cellId) const
{
  size_t i = 0;
  while (cellId >= this->Parts[i].End)
  {
    ++i;
  }
  return this->Parts[i];
}

inline CellIds CellReader::GetCell(vtkIdType cellId, std::vector<vtkIdType>& scratch) const
{
  const Part& part = this->FindPart(cellId);
  const vtkIdType begin = part.Offsets[cellId - part.Begin];
  const vtkIdType end = part.Offsets[cellId - part.Begin + 1];
  if (begin < 0 || end <= begin || end > part.Ids.Size)
  {
    return {};
  }
  CellIds cell;
  cell.Size = end - begin;
  if constexpr (sizeof(vtkIdType) == sizeof(vtkTypeInt64))
  {
    if (part.Ids.Data64)
    {
      // vtkTypeInt64 and vtkIdType may be `long` and `long long`, two types with the same bits.
      cell.Ids = reinterpret_cast<const vtkIdType*>(part.Ids.Data64) + begin;
      return cell;
    }
  }
  scratch.resize(static_cast<size_t>(cell.Size));
  for (vtkIdType i = 0; i < cell.Size; ++i)
  {
    scratch[i] = part.Ids[begin + i];
  }
  cell.Ids = scratch.data();
  return cell;
}

/// Calls `work(block, first cell, one past the last cell)` for all blocks.
template <typename Work>
void ForCellBlocks(const CellReader& cells, const Work& work)
{
  const auto range = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType block = begin; block < end; ++block)
    {
      work(block, block * CellsPerBlock,
        std::min(cells.GetNumberOfCells(), (block + 1) * CellsPerBlock));
    }
  };
  ForRangesOfBlocks(cells.GetNumberOfBlocks(), range, 3);
}

}

#endif
