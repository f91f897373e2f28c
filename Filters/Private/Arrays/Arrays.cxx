// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Arrays/Arrays.h"

#include "Core/Memory/Loops.h"

#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkLookupTable.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkVariant.h"

#include <atomic>
#include <cstring>
#include <vector>

namespace subdivision
{

vtkSmartPointer<vtkDataArray> MakeArray(int valueType, int components, vtkIdType tuples)
{
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(valueType));
  Allocate(array, components, tuples);
  return array;
}

void Allocate(vtkDataArray* array, int components, vtkIdType tuples)
{
  array->SetNumberOfComponents(components);
  const vtkIdType values = tuples * components;
  if (values > 0)
  {
    const std::size_t bytes = static_cast<std::size_t>(values) * array->GetDataTypeSize();
    array->SetVoidArray(AllocateBytes(bytes), values, 0, vtkAbstractArray::VTK_DATA_ARRAY_FREE);
  }
}

vtkSmartPointer<vtkAbstractArray> MakeLike(vtkAbstractArray* array, vtkIdType tuples)
{
  const bool isData = vtkDataArray::SafeDownCast(array) != nullptr;
  auto made = vtkSmartPointer<vtkAbstractArray>::Take(
    isData ? vtkDataArray::CreateDataArray(array->GetDataType()) : array->NewInstance());
  made->SetNumberOfComponents(array->GetNumberOfComponents());
  made->SetNumberOfTuples(tuples);
  CopyLooks(array, made);
  return made;
}

void CopyLooks(vtkAbstractArray* from, vtkAbstractArray* to)
{
  if (from == to)
  {
    return;
  }
  to->SetName(from->GetName());
  to->CopyComponentNames(from);
  if (from->HasInformation())
  {
    to->CopyInformation(from->GetInformation(), /*deep=*/1);
  }
  else if (to->HasInformation())
  {
    to->GetInformation()->Clear();
  }
  auto* data = vtkDataArray::SafeDownCast(from);
  if (data && vtkDataArray::SafeDownCast(to))
  {
    vtkDataArray::SafeDownCast(to)->SetLookupTable(data->GetLookupTable());
  }
}

void AddLike(
  vtkDataSetAttributes* from, int source, vtkAbstractArray* array, vtkDataSetAttributes* to)
{
  const int added = to->AddArray(array);
  for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
  {
    if (from->GetAbstractAttribute(type) == from->GetAbstractArray(source))
    {
      to->SetActiveAttribute(added, type);
    }
  }
}

void AddInstead(vtkDataSetAttributes* from, vtkAbstractArray* array, vtkDataSetAttributes* to)
{
  int source = -1;
  if (from->GetAbstractArray(array->GetName(), source))
  {
    AddLike(from, source, array, to);
  }
  else
  {
    to->AddArray(array);
  }
}

bool HasTuples(vtkAbstractArray* array, vtkIdType wanted, const char* kind,
  const std::function<void(const std::string&)>& warn)
{
  if (array->GetNumberOfTuples() == wanted)
  {
    return true;
  }
  if (warn)
  {
    warn(std::string("The ") + kind + " array \"" + (array->GetName() ? array->GetName() : "") +
      "\" has " + std::to_string(array->GetNumberOfTuples()) + " tuples for " +
      std::to_string(wanted) + " " + kind +
      "s, so the filter leaves it out of the output. Give it one tuple for each.");
  }
  return false;
}

bool HasIds(vtkDataSetAttributes* data, const char* name, vtkIdType tuples)
{
  vtkDataArray* array = data->GetArray(name);
  return array && array->GetNumberOfComponents() == 1 && array->GetNumberOfTuples() == tuples &&
    array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE;
}

std::vector<vtkIdType> ReadIdsOf(vtkDataSetAttributes* data, vtkIdType tuples)
{
  vtkDataArray* array = data->GetGlobalIds();
  std::vector<vtkIdType> ids;
  vtkIdTypeArray* exact = vtkIdTypeArray::SafeDownCast(array);
  // A double cannot tell all integers of 64 bits apart.
  const bool isLong = array && array->GetDataTypeSize() == 8 && array->GetDataType() != VTK_DOUBLE;
  const auto read = [&](vtkIdType i)
  {
    return isLong ? static_cast<vtkIdType>(array->GetVariantValue(i).ToLongLong())
                  : ToId(array->GetComponent(i, 0));
  };
  for (const vtkIdType i :
    InTurn(array && array->GetNumberOfTuples() == tuples ? tuples : vtkIdType(0)))
  {
    ids.push_back(exact ? exact->GetValue(i) : read(i));
  }
  return ids;
}

vtkIdType ToId(double value)
{
  constexpr double exact = 9007199254740992.; // 2^53
  return value >= -exact && value <= exact ? static_cast<vtkIdType>(value) : -1;
}

vtkIdType ToCount(double value)
{
  return value >= static_cast<double>(VTK_ID_MAX) ? VTK_ID_MAX
    : value >= 1.                                 ? static_cast<vtkIdType>(value)
                                                  : 1;
}

std::vector<double> GatherFromRanks(
  vtkMultiProcessController* controller, const std::vector<double>& own)
{
  const int ranks = controller->GetNumberOfProcesses();
  const auto size = static_cast<vtkIdType>(own.size());
  std::vector<vtkIdType> sizes(ranks);
  controller->AllGather(&size, sizes.data(), 1);
  std::vector<vtkIdType> offsets(ranks, 0);
  for (int r = 1; r < ranks; ++r)
  {
    offsets[r] = offsets[r - 1] + sizes[r - 1];
  }
  std::vector<double> all(offsets.back() + sizes.back());
  controller->AllGatherV(own.data(), all.data(), size, sizes.data(), offsets.data());
  return all;
}

vtkSmartPointer<vtkDataArray> Contiguous(vtkDataArray* array)
{
  if (array->HasStandardMemoryLayout())
  {
    return array;
  }
  const auto copy =
    MakeArray(array->GetDataType(), array->GetNumberOfComponents(), array->GetNumberOfTuples());
  if (array->GetDataTypeSize() == 8 && array->GetDataType() != VTK_DOUBLE)
  {
    // VTK copies by doubles, which do not have all of these numbers.
    ForEachInTurn(array->GetNumberOfValues(),
      [&](vtkIdType i) { copy->SetVariantValue(i, array->GetVariantValue(i)); });
  }
  else
  {
    copy->DeepCopy(array);
  }
  CopyLooks(array, copy);
  return copy;
}

bool HoldsSameValues(vtkDataArray* a, vtkDataArray* b)
{
  if (a->GetDataType() != b->GetDataType() || a->GetNumberOfValues() != b->GetNumberOfValues())
  {
    return false;
  }
  if (a == b || a->GetNumberOfValues() == 0)
  {
    return true;
  }
  const auto* first = static_cast<const char*>(a->GetVoidPointer(0));
  const auto* second = static_cast<const char*>(b->GetVoidPointer(0));
  const vtkIdType size = a->GetDataTypeSize();
  std::atomic<bool> same{ true };
  ForRanges(a->GetNumberOfValues(),
    [&](vtkIdType begin, vtkIdType end)
    {
      if (same &&
        std::memcmp(first + begin * size, second + begin * size,
          static_cast<std::size_t>((end - begin) * size)) != 0)
      {
        same = false;
      }
    });
  return same;
}

void SharedArrays::Set(const std::vector<vtkDataArray*>& arrays)
{
  this->Clear(); // work that stops here has none
  std::vector<Fingerprint> fingerprints;
  for (vtkDataArray* array : arrays)
  {
    fingerprints.push_back(array ? ComputeFingerprint(Contiguous(array)) : Fingerprint());
  }
  this->Fingerprints = std::move(fingerprints);
  this->Arrays.assign(arrays.begin(), arrays.end());
}

void SharedArrays::Clear()
{
  this->Arrays.clear();
  this->Fingerprints.clear();
}

bool SharedArrays::Hold(const std::vector<vtkDataArray*>& arrays) const
{
  bool same = arrays.size() == this->Arrays.size() &&
    std::equal(arrays.begin(), arrays.end(), this->Arrays.begin());
  for (std::size_t i = 0; same && i < arrays.size(); ++i)
  {
    same = !arrays[i] || ComputeFingerprint(Contiguous(arrays[i])) == this->Fingerprints[i];
  }
  return same;
}

vtkSmartPointer<vtkAbstractArray> Gather(vtkAbstractArray* in, Row<vtkIdType> sources)
{
  vtkDataArray* data = vtkDataArray::SafeDownCast(in);
  if (data && data->GetDataType() != VTK_BIT)
  {
    const auto from = Contiguous(data);
    const int components = from->GetNumberOfComponents();
    const auto out = MakeArray(from->GetDataType(), components, sources.size());
    const std::size_t bytes = static_cast<std::size_t>(from->GetDataTypeSize()) * components;
    if (sources.size() > 0 && bytes > 0)
    {
      const char* input = static_cast<const char*>(from->GetVoidPointer(0));
      char* output = static_cast<char*>(out->GetVoidPointer(0));
      auto copy = [&](auto size)
      {
        ForEach(sources.size(), [=](vtkIdType i)
          { std::memcpy(output + i * size, input + sources.First[i] * size, size); });
      };
      switch (bytes)
      {
        case 1: // a size that the compiler knows is one instruction
          copy(std::integral_constant<std::size_t, 1>());
          break;
        case 4:
          copy(std::integral_constant<std::size_t, 4>());
          break;
        case 8:
          copy(std::integral_constant<std::size_t, 8>());
          break;
        default:
          copy(bytes);
      }
    }
    CopyLooks(in, out);
    return out;
  }
  auto out = MakeLike(in, sources.size());
  for (const vtkIdType i : InTurn(sources.size()))
  {
    out->SetTuple(i, sources.First[i], in);
  }
  return out;
}

}
