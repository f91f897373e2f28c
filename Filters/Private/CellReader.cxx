// SPDX-License-Identifier: BSD-3-Clause
#include "CellReader.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnstructuredGrid.h"

namespace subdivision
{

namespace
{

bool IsSignedInteger(const vtkDataArray* array)
{
  const int type = array->GetDataType();
  return type == VTK_INT || type == VTK_LONG || type == VTK_LONG_LONG || type == VTK_ID_TYPE;
}

}

CellReader::CellReader(vtkPointSet* input)
{
  this->Grid = vtkUnstructuredGrid::SafeDownCast(input);
  if (this->Grid)
  {
    this->Add(this->Grid->GetCells(), VTK_EMPTY_CELL);
  }
  else if (auto* poly = vtkPolyData::SafeDownCast(input))
  {
    this->Add(poly->GetVerts(), VTK_POLY_VERTEX);
    this->Add(poly->GetLines(), VTK_POLY_LINE);
    this->Add(poly->GetPolys(), VTK_POLYGON);
    this->Add(poly->GetStrips(), VTK_TRIANGLE_STRIP);
  }
}

int CellReader::GetCellType(vtkIdType cellId) const
{
  return this->Grid ? this->Grid->GetCellType(cellId) : this->FindPart(cellId).Type;
}

CellIds CellReader::GetCell(vtkIdType cellId, std::vector<vtkIdType>& scratch) const
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

void CellReader::GetAllIds(std::vector<vtkIdType>& ids) const
{
  ids.clear();
  for (const Part& part : this->Parts)
  {
    // One pass straight into fresh memory; resizing first would touch all of it twice.
    const vtkIdType begin = part.Offsets[0];
    const vtkIdType end = part.Offsets[part.End - part.Begin];
    if (part.Ids.Data64)
    {
      ids.insert(ids.end(), part.Ids.Data64 + begin, part.Ids.Data64 + end);
    }
    else
    {
      ids.insert(ids.end(), part.Ids.Data32 + begin, part.Ids.Data32 + end);
    }
  }
}

void CellReader::Integers::Set(vtkDataArray* array)
{
  this->Owner = array;
  const bool plain = array->HasStandardMemoryLayout() && IsSignedInteger(array);
  if (!plain)
  {
    // Offsets that follow a formula, or arrays in parts: rare enough to be written out once.
    this->Owner = vtkSmartPointer<vtkTypeInt64Array>::New();
    this->Owner->DeepCopy(array);
  }
  this->Size = this->Owner->GetNumberOfValues();
  const void* data = this->Owner->GetVoidPointer(0);
  if (this->Owner->GetDataTypeSize() == sizeof(vtkTypeInt64))
  {
    this->Data64 = static_cast<const vtkTypeInt64*>(data);
  }
  else
  {
    this->Data32 = static_cast<const vtkTypeInt32*>(data);
  }
}

void CellReader::Add(vtkCellArray* cells, int type)
{
  if (!cells || cells->GetNumberOfCells() == 0)
  {
    return;
  }
  this->Parts.emplace_back();
  Part& part = this->Parts.back();
  part.Begin = this->NumberOfCells;
  this->NumberOfCells += cells->GetNumberOfCells();
  part.End = this->NumberOfCells;
  part.Type = type;
  part.Offsets.Set(cells->GetOffsetsArray());
  part.Ids.Set(cells->GetConnectivityArray());
}

const CellReader::Part& CellReader::FindPart(vtkIdType cellId) const
{
  size_t i = 0;
  while (cellId >= this->Parts[i].End)
  {
    ++i;
  }
  return this->Parts[i];
}

}
