// SPDX-License-Identifier: BSD-3-Clause
#include "Arrays.h"

#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkNew.h"

#include <cstring>

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

void CopyLooks(vtkAbstractArray* from, vtkAbstractArray* to)
{
  to->SetName(from->GetName());
  to->CopyComponentNames(from);
  if (from->HasInformation())
  {
    to->CopyInformation(from->GetInformation(), /*deep=*/1);
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
      "s: it is not in the output. Give it one tuple for each.");
  }
  return false;
}

bool HasIds(vtkDataSetAttributes* data, const char* name, vtkIdType tuples)
{
  vtkDataArray* array = data->GetArray(name);
  return array && array->GetNumberOfComponents() == 1 && array->GetNumberOfTuples() == tuples &&
    array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE;
}

vtkIdType ToId(double value)
{
  constexpr double exact = 9007199254740992.; // 2^53
  return value >= -exact && value <= exact ? static_cast<vtkIdType>(value) : -1;
}

vtkSmartPointer<vtkDataArray> Contiguous(vtkDataArray* array)
{
  if (array->HasStandardMemoryLayout())
  {
    return array;
  }
  auto copy =
    vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(array->GetDataType()));
  copy->DeepCopy(array);
  CopyLooks(array, copy);
  return copy;
}

vtkSmartPointer<vtkAbstractArray> Gather(vtkAbstractArray* in, const Buffer<vtkIdType>& sources)
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
      ForEach(sources.size(),
        [&](vtkIdType i) { std::memcpy(output + i * bytes, input + sources[i] * bytes, bytes); });
    }
    CopyLooks(in, out);
    return out;
  }
  auto out = vtkSmartPointer<vtkAbstractArray>::Take(in->NewInstance());
  out->SetNumberOfComponents(in->GetNumberOfComponents());
  out->SetNumberOfTuples(sources.size());
  for (vtkIdType i = 0; i < sources.size(); ++i)
  {
    out->SetTuple(i, sources[i], in);
  }
  CopyLooks(in, out);
  return out;
}

}
