// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellReader.h
 * The cells of a vtkUnstructuredGrid or vtkPolyData by cell id, for many threads at once. Nothing
 * is built inside the data set, and no id is trusted: a cell may name points that do not exist.
 */
#ifndef SubdivisionObjects_CellReader_h
#define SubdivisionObjects_CellReader_h

#include "vtkSMPTools.h"
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

/// Cells per task. Tasks have fixed bounds, so that what they find does not depend on the threads.
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

  /// A VTK cell type; POLY_VERTEX, POLY_LINE, POLYGON, TRIANGLE_STRIP for the four parts of
  /// vtkPolyData.
  int GetCellType(vtkIdType cellId) const
  {
    return this->Types ? this->Types[cellId] : this->FindPart(cellId).Type;
  }

  /// `scratch` holds the ids where they are stored in another type than vtkIdType; reuse it.
  CellIds GetCell(vtkIdType cellId, std::vector<vtkIdType>& scratch) const;

  /// All ids of all cells, in cell order.
  void GetAllIds(std::vector<vtkIdType>& ids) const;
  /// The same where they are; null if they are not stored one after the other as vtkIdType.
  const vtkIdType* FindAllIds() const;

  /// An integer array of either size behind a plain pointer.
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

  /// A vtkCellArray.
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
      // The same bits under another name (long or long long): readable as such.
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
void ForBlocks(const CellReader& cells, const Work& work)
{
  const auto range = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType block = begin; block < end; ++block)
    {
      work(block, block * CellsPerBlock,
        std::min(cells.GetNumberOfCells(), (block + 1) * CellsPerBlock));
    }
  };
  if (cells.GetNumberOfBlocks() < 3) // not worth starting threads for
  {
    range(0, cells.GetNumberOfBlocks());
    return;
  }
  vtkSMPTools::For(0, cells.GetNumberOfBlocks(), range);
}

}

#endif
