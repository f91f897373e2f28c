// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Distribution/JoinedArrays.h"

#include "Core/Memory/Loops.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Reading/CellChecks.h"
#include "Private/Reading/CellReader.h"

#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariant.h"

#include <algorithm>
#include <functional>

namespace subdivision
{
namespace
{

/// How many cells far ExtendArrays goes: as far as rows of the schemes reach.
constexpr int Extent = 2;

/// An array as a part has it.
bool IsSame(vtkAbstractArray* array, vtkAbstractArray* joined, const JoinedArray& entry)
{
  return entry.OriginalName == array->GetName() && array->GetDataType() == joined->GetDataType() &&
    array->GetNumberOfComponents() == joined->GetNumberOfComponents();
}

/// Arrays without a name or with a wrong size are left out, and the ghost types of points, which
/// another partition set.
bool IsCarried(vtkAbstractArray* array, vtkIdType size, int association)
{
  return array->GetName() && HasValues(array, size) &&
    (association != vtkDataObject::POINT ||
      std::string(array->GetName()) != vtkDataSetAttributes::GhostArrayName());
}

/// Whether the joined array so far has all values of `array`.
bool Fits(vtkAbstractArray* array, const std::vector<vtkIdType>& places,
  const std::vector<char>& has, vtkAbstractArray* joined)
{
  const int size = array->GetNumberOfComponents();
  bool fits = true;
  for (size_t i = 0; i < places.size() && fits; ++i)
  {
    for (int c = 0; places[i] >= 0 && has[places[i]] && c < size; ++c)
    {
      fits = fits &&
        array->GetVariantValue(static_cast<vtkIdType>(i) * size + c) ==
          joined->GetVariantValue(places[i] * size + c);
    }
  }
  return fits;
}

/// The array of the joined mesh that takes the values of `array`; makes one if there is none.
/// `fits(e)`: whether array e may take them.
template <typename FitsInto>
size_t FindEntry(vtkAbstractArray* array, vtkIdType size, std::vector<JoinedArray>& entries,
  std::vector<vtkSmartPointer<vtkAbstractArray>>& arrays, size_t numberOfParts,
  const FitsInto& fits)
{
  std::string name = array->GetName();
  for (size_t e = 0; e < entries.size(); ++e)
  {
    if (IsSame(array, arrays[e], entries[e]) && fits(e))
    {
      return e;
    }
    if (entries[e].OriginalName == array->GetName())
    {
      name += "'"; // another type, or other values: no reader asks for it by this name
    }
  }
  entries.push_back({ name, array->GetName(), std::vector<bool>(numberOfParts, false) });
  auto joined = MakeLike(array, size);
  joined->SetName(name.c_str());
  if (auto* numbers = vtkDataArray::SafeDownCast(joined))
  {
    numbers->Fill(0.);
  }
  arrays.push_back(joined);
  return entries.size() - 1;
}

void CopyValues(vtkAbstractArray* from, const std::vector<vtkIdType>& places,
  std::vector<char>& has, vtkAbstractArray* to)
{
  vtkNew<vtkIdList> sources;
  vtkNew<vtkIdList> targets;
  for (const size_t i : InTurn(places.size()))
  {
    if (places[i] >= 0 && !has[places[i]])
    {
      has[places[i]] = 1;
      sources->InsertNextId(static_cast<vtkIdType>(i));
      targets->InsertNextId(places[i]);
    }
  }
  if (targets->GetNumberOfIds() > 0)
  {
    auto* data = vtkDataArray::SafeDownCast(from);
    to->InsertTuples(targets, sources, data ? Contiguous(data).Get() : from);
  }
}

/// Of ghost types only that a cell is hidden has a meaning in the joined mesh.
void KeepHidden(vtkDataSetAttributes* joined)
{
  vtkAbstractArray* array = joined->GetAbstractArray(vtkDataSetAttributes::GhostArrayName());
  if (auto* types = vtkUnsignedCharArray::SafeDownCast(array))
  {
    for (const vtkIdType i : InTurn(types->GetNumberOfValues()))
    {
      types->SetValue(i, IsHiddenCell(types->GetValue(i)) ? vtkDataSetAttributes::HIDDENCELL : 0);
    }
  }
}

void AddActiveAttributes(vtkDataSetAttributes* from, vtkDataSetAttributes* joined,
  const std::vector<JoinedArray>& entries,
  const std::vector<vtkSmartPointer<vtkAbstractArray>>& arrays)
{
  for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
  {
    vtkAbstractArray* active = from->GetAbstractAttribute(type);
    for (size_t e = 0; active && active->GetName() && e < entries.size(); ++e)
    {
      if (!joined->GetAbstractAttribute(type) && IsSame(active, arrays[e], entries[e]))
      {
        joined->SetActiveAttribute(entries[e].Name.c_str(), type);
      }
    }
  }
}

/// Takes values from neighbours once: points of cells that have no value from points that have one.
void ExtendOnce(const CellReader& cells, vtkDataArray* array, std::vector<char>& has)
{
  const int components = array->GetNumberOfComponents();
  std::vector<vtkIdType> counts(has.size(), 0);
  std::vector<vtkIdType> scratch;
  std::vector<double> value(components);
  std::vector<double> sum(components);
  for (const vtkIdType c : InTurn(cells.GetNumberOfCells()))
  {
    const CellIds cell = cells.GetCell(c, scratch);
    for (vtkIdType i = 0; i < cell.Size; ++i)
    {
      if (cell.Ids[i] < 0 || has[cell.Ids[i]])
      {
        continue;
      }
      array->GetTuple(cell.Ids[i], sum.data());
      for (vtkIdType k = 0; k < cell.Size; ++k)
      {
        if (cell.Ids[k] >= 0 && has[cell.Ids[k]])
        {
          array->GetTuple(cell.Ids[k], value.data());
          std::transform(sum.begin(), sum.end(), value.begin(), sum.begin(), std::plus<double>());
          ++counts[cell.Ids[i]];
        }
      }
      array->SetTuple(cell.Ids[i], sum.data());
    }
  }
  for (const size_t i : InTurn(has.size()))
  {
    if (counts[i] > 0)
    {
      array->GetTuple(static_cast<vtkIdType>(i), value.data());
      for (double& v : value)
      {
        v /= static_cast<double>(counts[i]);
      }
      array->SetTuple(static_cast<vtkIdType>(i), value.data());
      has[i] = 1;
    }
  }
}

}

bool HasValues(vtkAbstractArray* array, vtkIdType size)
{
  const vtkIdType given = array->GetNumberOfTuples();
  const bool mayBeMore =
    array->GetName() && std::string(array->GetName()) == vtkDataSetAttributes::GhostArrayName();
  return given == size || (mayBeMore && given > size);
}

bool IsFloating(vtkAbstractArray* array)
{
  return array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
}

vtkAbstractArray* FindArray(
  vtkDataSetAttributes* data, vtkAbstractArray* joined, const JoinedArray& entry)
{
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = data->GetAbstractArray(a);
    if (array->GetName() && IsSame(array, joined, entry))
    {
      return array;
    }
  }
  return nullptr;
}

std::vector<JoinedArray> JoinArrays(const std::vector<MeshPart>& parts, const Places& places,
  int association, bool keepsOwnFloats, vtkDataSetAttributes* joined)
{
  std::vector<JoinedArray> entries;
  std::vector<vtkSmartPointer<vtkAbstractArray>> arrays;
  std::vector<std::vector<char>> has; // which values are there: the first part stays
  for (size_t p = 0; p < parts.size(); ++p)
  {
    vtkDataSetAttributes* data = parts[p].Mesh->GetAttributes(association);
    for (int a = 0; a < data->GetNumberOfArrays(); ++a)
    {
      vtkAbstractArray* array = data->GetAbstractArray(a);
      if (!IsCarried(array, parts[p].Mesh->GetNumberOfElements(association), association))
      {
        continue;
      }
      const bool isFree = !parts[p].KeepsOwn || parts[p].Block == NoBlock ||
        association != vtkDataObject::POINT || (keepsOwnFloats && IsFloating(array));
      const size_t e = FindEntry(array, places.Size, entries, arrays, parts.size(),
        [&](size_t at) { return isFree || Fits(array, places.OfPart[p], has[at], arrays[at]); });
      has.resize(entries.size(), std::vector<char>(static_cast<size_t>(places.Size), 0));
      entries[e].OfPart[p] = true;
      CopyValues(array, places.OfPart[p], has[e], arrays[e]);
    }
  }
  for (const auto& array : arrays)
  {
    joined->AddArray(array);
  }
  for (const MeshPart& part : parts)
  {
    AddActiveAttributes(part.Mesh->GetAttributes(association), joined, entries, arrays);
  }
  KeepHidden(joined);
  return entries;
}

void ExtendArrays(vtkPointSet* mesh, const std::vector<JoinedArray>& arrays, const Places& places)
{
  const CellReader cells(mesh);
  for (const JoinedArray& entry : arrays)
  {
    vtkDataArray* array = mesh->GetPointData()->GetArray(entry.Name.c_str());
    const bool isPartial =
      std::find(entry.OfPart.begin(), entry.OfPart.end(), false) != entry.OfPart.end();
    if (!array || !isPartial || !IsFloating(array))
    {
      continue;
    }
    std::vector<char> has(static_cast<size_t>(places.Size), 0);
    for (size_t p = 0; p < places.OfPart.size(); ++p)
    {
      for (size_t i = 0; entry.OfPart[p] && i < places.OfPart[p].size(); ++i)
      {
        if (places.OfPart[p][i] >= 0)
        {
          has[places.OfPart[p][i]] = 1;
        }
      }
    }
    for (int i = 0; i < Extent; ++i)
    {
      ExtendOnce(cells, array, has);
    }
  }
}

}
