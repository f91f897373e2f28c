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

/// The types of the cells. Cells without one become empty cells, which no filter takes.
vtkSmartPointer<vtkUnsignedCharArray> GetTypesOfAll(vtkUnstructuredGrid* grid, vtkIdType cells)
{
  vtkSmartPointer<vtkUnsignedCharArray> types = subdivision::GetCellTypes(grid);
  const vtkIdType known = types ? types->GetNumberOfValues() : 0;
  if (known >= cells)
  {
    return types;
  }
  auto all = vtkSmartPointer<vtkUnsignedCharArray>::New();
  all->SetNumberOfValues(cells);
  all->FillValue(VTK_EMPTY_CELL);
  if (known > 0)
  {
    std::copy_n(types->GetPointer(0), known, all->GetPointer(0));
  }
  return all;
}

}

CellReader::CellReader(vtkPointSet* input)
{
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(input))
  {
    this->Add(grid->GetCells(), VTK_EMPTY_CELL);
    this->TypesOwner = GetTypesOfAll(grid, this->NumberOfCells);
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
  const auto bound = [](const Part& part, vtkIdType i)
  { return std::clamp<vtkIdType>(part.Offsets[i], 0, part.Ids.Size); };
  const auto begin = [&](const Part& part) { return bound(part, 0); };
  const auto end = [&](const Part& part)
  { return std::max(begin(part), bound(part, part.End - part.Begin)); };
  vtkIdType size = 0;
  for (const Part& part : this->Parts)
  {
    size += end(part) - begin(part);
  }
  ids.reserve(static_cast<size_t>(size));
  AdviseHugePages(ids.data(), ids.capacity() * sizeof(vtkIdType));
  for (const Part& part : this->Parts)
  {
    // One pass straight into fresh memory; resizing first would touch all of it twice.
    if (part.Ids.Data64)
    {
      ids.insert(ids.end(), part.Ids.Data64 + begin(part), part.Ids.Data64 + end(part));
    }
    else
    {
      ids.insert(ids.end(), part.Ids.Data32 + begin(part), part.Ids.Data32 + end(part));
    }
  }
}

int CellReader::GetGridType(vtkIdType cellId, vtkIdType size) const
{
  const int type = this->GetCellType(cellId);
  if (this->Types)
  {
    return type;
  }
  switch (type)
  {
    case VTK_POLY_VERTEX:
      return size == 1 ? VTK_VERTEX : VTK_POLY_VERTEX;
    case VTK_POLY_LINE:
      return size == 2 ? VTK_LINE : VTK_POLY_LINE;
    case VTK_POLYGON:
      return size == 3 ? VTK_TRIANGLE : (size == 4 ? VTK_QUAD : VTK_POLYGON);
    default:
      return type;
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
