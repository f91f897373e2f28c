// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Arrays/CellArrays.h"

#include "Core/Memory/Loops.h"
#include "Core/Memory/SimplexStarts.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cstring>
#include <optional>

namespace subdivision
{
namespace
{

/// Gives each simplex's value of `bytes` bytes to all of its children.
template <typename Value>
void Spread(const SimplexStarts& first, const Value& value, std::size_t bytes, char* out)
{
  ForEach(first.GetNumberOfSimplices(),
    [&](vtkIdType i)
    {
      const char* from = value(i);
      for (vtkIdType child = first[i]; child < first[i + 1]; ++child)
      {
        std::memcpy(out + child * bytes, from, bytes);
      }
    });
}

vtkSmartPointer<vtkAbstractArray> SpreadArray(
  vtkAbstractArray* array, const SimplicesOfCells& cells, const SimplexStarts& first)
{
  auto parent = [&](vtkIdType i) { return cells.ParentCells.empty() ? i : cells.ParentCells[i]; };
  vtkDataArray* data = vtkDataArray::SafeDownCast(array);
  const vtkIdType children = first.GetLength();
  if (!data || data->GetDataType() == VTK_BIT)
  {
    Buffer<vtkIdType> sources(children);
    ForEach(first.GetNumberOfSimplices(), [&](vtkIdType i)
      { std::fill(sources.data() + first[i], sources.data() + first[i + 1], parent(i)); });
    return Gather(array, { sources.begin(), sources.end() });
  }
  const auto from = Contiguous(data);
  const int components = from->GetNumberOfComponents();
  const auto out = MakeArray(from->GetDataType(), components, children);
  const std::size_t bytes = static_cast<std::size_t>(from->GetDataTypeSize()) * components;
  if (children > 0 && bytes > 0)
  {
    const char* values = static_cast<const char*>(from->GetVoidPointer(0));
    Spread(
      first, [&](vtkIdType i) { return values + parent(i) * bytes; }, bytes,
      static_cast<char*>(out->GetVoidPointer(0)));
  }
  CopyLooks(array, out);
  return out;
}

/// The ids of the input's cells.
vtkSmartPointer<vtkDataArray> MakeIds(vtkIdType size)
{
  const auto ids = MakeArray(VTK_ID_TYPE, 1, size);
  auto* values = static_cast<vtkIdType*>(ids->GetVoidPointer(0));
  ForEach(size, [values](vtkIdType i) { values[i] = i; });
  return ids;
}

}

void CopyCellArrays(vtkPointSet* input, const CellArrayOptions& options,
  const std::function<vtkSmartPointer<vtkAbstractArray>(vtkAbstractArray*)>& spread,
  const std::function<vtkSmartPointer<vtkAbstractArray>()>& makeIds,
  const std::function<bool()>& areSame, vtkPointSet* output)
{
  vtkCellData* data = input->GetCellData();
  const bool makesIds = options.OriginalIds && !options.CarryOriginalIds;
  const bool hasGlobalIds = data->GetGlobalIds() && areSame();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    const std::string name = array->GetName() ? array->GetName() : "";
    if ((array == data->GetGlobalIds() && !hasGlobalIds && !options.OriginalIds) ||
      (array == data->GetNormals() && options.PointsMove) ||
      (makesIds && name == OriginalCellIdsName) ||
      std::find(options.Replaced.begin(), options.Replaced.end(), name) != options.Replaced.end())
    {
      continue;
    }
    if (!HasTuples(array, input->GetNumberOfCells(), "cell", options.Warn))
    {
      continue;
    }
    const vtkSmartPointer<vtkAbstractArray> copy = spread(array);
    AddLike(data, i, copy, output->GetCellData());
  }
  if (!hasGlobalIds) // children have the ids of their cell
  {
    output->GetCellData()->SetActiveAttribute(-1, vtkDataSetAttributes::GLOBALIDS);
  }
  if (makesIds)
  {
    const vtkSmartPointer<vtkAbstractArray> ids = makeIds();
    ids->SetName(OriginalCellIdsName);
    AddInstead(data, ids, output->GetCellData());
  }
}

vtkSmartPointer<vtkAbstractArray> SpreadToChildren(
  vtkAbstractArray* array, const SimplicesOfCells& cells, int levels)
{
  return SpreadArray(array, cells, FindChildren(cells.Simplices, levels));
}

void CopyCellArrays(vtkPointSet* input, const SimplicesOfCells& cells,
  const CellArrayOptions& options, vtkUnstructuredGrid* output)
{
  std::optional<SimplexStarts> first; // none until an array needs it
  auto areSame = [&]()
  {
    if (!first)
    {
      first.emplace(FindChildren(cells.Simplices, options.Levels));
    }
    return cells.ParentCells.empty() && first->GetLength() == input->GetNumberOfCells();
  };
  auto spread = [&](vtkAbstractArray* array)
  {
    return areSame() ? vtkSmartPointer<vtkAbstractArray>(array) : SpreadArray(array, cells, *first);
  };
  CopyCellArrays(
    input, options, spread, [&]() { return spread(MakeIds(input->GetNumberOfCells())); }, areSame,
    output);
}

bool AreAllCells(Row<vtkIdType> sources, vtkIdType size)
{
  vtkIdType next = 0;
  return sources.size() == size &&
    std::all_of(sources.begin(), sources.end(), [&](vtkIdType cell) { return cell == next++; });
}

void CopyCellArrays(
  vtkPointSet* input, vtkIdTypeArray* sources, const CellArrayOptions& options, vtkPointSet* output)
{
  const vtkIdType* first = sources->GetPointer(0);
  const Row<vtkIdType> row{ first, first + sources->GetNumberOfTuples() };
  CopyCellArrays(
    input, options, [&](vtkAbstractArray* array) { return Gather(array, row); },
    [&]() { return vtkSmartPointer<vtkAbstractArray>(sources); },
    [&]() { return AreAllCells(row, input->GetNumberOfCells()); }, output);
}

void CopyCellArrays(vtkPointSet* input, const SimplicesOfCells& cells,
  const std::vector<vtkIdType>& parents, const CellArrayOptions& options,
  vtkUnstructuredGrid* output)
{
  if (parents.empty())
  {
    CopyCellArrays(input, cells, options, output);
    return;
  }
  SimplicesOfCells children;
  for (unsigned char dimension : InTurn(cells.Simplices.Dimensions))
  {
    children.Simplices.Dimensions.insert(
      children.Simplices.Dimensions.end(), std::size_t(1) << dimension, dimension);
  }
  children.ParentCells = parents;
  CellArrayOptions further = options;
  --further.Levels;
  CopyCellArrays(input, children, further, output);
}

void AddValuesOfSimplices(const unsigned char* values, const SimplexList& simplices, int levels,
  const char* name, vtkPointSet* input, vtkUnstructuredGrid* output)
{
  const SimplexStarts first = FindChildren(simplices, levels);
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(first.GetLength());
  if (array->GetNumberOfTuples() > 0)
  {
    Spread(
      first, [&](vtkIdType i) { return reinterpret_cast<const char*>(values + i); }, 1,
      reinterpret_cast<char*>(array->GetPointer(0)));
  }
  AddInstead(input->GetCellData(), array, output->GetCellData());
}

void ReduceSharpness(const char* name, int levels, vtkUnstructuredGrid* output)
{
  vtkDataArray* sharpness = output->GetCellData()->GetArray(name);
  if (levels == 0 || !sharpness)
  {
    return; // without a step the array may be the input's own
  }
  for (const vtkIdType cell : InTurn(output->GetNumberOfCells()))
  {
    const int type = output->GetCellType(cell);
    if (type == VTK_LINE || type == VTK_TRIANGLE || type == VTK_QUAD)
    {
      sharpness->SetComponent(cell, 0, std::max(sharpness->GetComponent(cell, 0) - levels, 0.));
    }
  }
}

void RebuildPointGhosts(vtkPointSet* input, vtkPointSet* output)
{
  const char* name = vtkDataSetAttributes::GhostArrayName();
  auto* before = vtkUnsignedCharArray::SafeDownCast(input->GetPointData()->GetAbstractArray(name));
  auto* cells = vtkUnsignedCharArray::SafeDownCast(output->GetCellData()->GetAbstractArray(name));
  if (!before && !cells)
  {
    return;
  }
  constexpr unsigned char unused = 255;
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(name);
  ghosts->SetNumberOfTuples(output->GetNumberOfPoints());
  ghosts->FillValue(unused);
  vtkNew<vtkIdList> ids;
  for (const vtkIdType c : InTurn(output->GetNumberOfCells()))
  {
    const bool duplicate = cells && (cells->GetValue(c) & vtkDataSetAttributes::DUPLICATECELL) != 0;
    output->GetCellPoints(c, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      const vtkIdType point = ids->GetId(i);
      const unsigned char type = duplicate ? vtkDataSetAttributes::DUPLICATEPOINT : 0;
      ghosts->SetValue(point,
        static_cast<unsigned char>(
          ghosts->GetValue(point) == unused ? type : type & ghosts->GetValue(point)));
    }
  }
  for (const vtkIdType p : InTurn(ghosts->GetNumberOfTuples()))
  {
    if (ghosts->GetValue(p) == unused)
    {
      ghosts->SetValue(p, before && p < before->GetNumberOfTuples() ? before->GetValue(p) : 0);
    }
  }
  output->GetPointData()->AddArray(ghosts);
}

}
