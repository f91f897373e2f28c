// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Reading/CellReader.h"

#include "Private/vtkSubdivisionObjectsCompat.h"

#include "Core/Memory/Buffer.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
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
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(input))
  {
    this->Add(grid->GetCells(), VTK_EMPTY_CELL);
    this->TypesOwner = subdivision::GetCellTypes(grid);
    this->Types = this->NumberOfCells > 0 ? this->TypesOwner->GetPointer(0) : nullptr;
  }
  else if (auto* poly = vtkPolyData::SafeDownCast(input))
  {
    this->Add(poly->GetVerts(), VTK_POLY_VERTEX);
    this->Add(poly->GetLines(), VTK_POLY_LINE);
    this->Add(poly->GetPolys(), VTK_POLYGON);
    this->Add(poly->GetStrips(), VTK_TRIANGLE_STRIP);
  }
}

void CellReader::GetAllIds(std::vector<vtkIdType>& ids) const
{
  ids.clear();
  vtkIdType size = 0;
  for (const Part& part : this->Parts)
  {
    size += part.Offsets[part.End - part.Begin] - part.Offsets[0];
  }
  ids.reserve(static_cast<size_t>(size));
  AdviseHugePages(ids.data(), ids.capacity() * sizeof(vtkIdType));
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

const vtkIdType* CellReader::FindAllIds() const
{
  if (this->Parts.size() != 1)
  {
    return nullptr;
  }
  const Part& part = this->Parts[0];
  if (part.Ids.IsCopy || part.Ids.Owner->GetDataTypeSize() != sizeof(vtkIdType))
  {
    return nullptr;
  }
  return static_cast<const vtkIdType*>(part.Ids.Owner->GetVoidPointer(0)) + part.Offsets[0];
}

void CellReader::Integers::Set(vtkDataArray* array)
{
  this->Owner = array;
  const bool plain = array->HasStandardMemoryLayout() && IsSignedInteger(array);
  if (!plain)
  {
    // Offsets that VTK computes by a formula, or an array of another type or layout. Both are rare,
    // so the values are copied.
    this->IsCopy = true;
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

}
