// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Run/StampFields.h"

#include "Core/Memory/Loops.h"
#include "Private/Arrays/Arrays.h"

#include "vtkIdTypeArray.h"
#include "vtkPointSet.h"

namespace subdivision
{
namespace
{

template <typename Value, typename Get>
std::vector<Value> ReadField(vtkDataArray* array, int components, const Get& get)
{
  std::vector<Value> values;
  if (array)
  {
    values.reserve(array->GetNumberOfValues());
    for (const vtkIdType i : InTurn(array->GetNumberOfTuples()))
    {
      for (int c = 0; c < components; ++c)
      {
        values.push_back(get(i, c));
      }
    }
  }
  return values;
}

}

vtkDataArray* FindField(const char* name, vtkFieldData* data, int components)
{
  vtkDataArray* array = data->GetArray(name);
  return array && array->GetNumberOfComponents() == components ? array : nullptr;
}

std::vector<double> ReadFieldValues(const char* name, vtkFieldData* data, int components)
{
  vtkDataArray* array = FindField(name, data, components);
  return ReadField<double>(
    array, components, [array](vtkIdType i, int c) { return array->GetComponent(i, c); });
}

std::vector<vtkIdType> ReadFieldIds(const char* name, vtkFieldData* data, int components)
{
  vtkDataArray* array = FindField(name, data, components);
  return ReadField<vtkIdType>(
    array, components, [array](vtkIdType i, int c) { return ToId(array->GetComponent(i, c)); });
}

std::vector<vtkIdType> ReadStampNumbers(vtkPointSet* mesh, const StampFormat& format)
{
  std::vector<vtkIdType> numbers = ReadFieldIds(format.Name, mesh->GetFieldData());
  const bool fits = static_cast<int>(numbers.size()) == format.NumberOfNumbers &&
    numbers[0] == format.Version && numbers[format.Points] == mesh->GetNumberOfPoints() &&
    numbers[format.Cells] == mesh->GetNumberOfCells() && numbers[format.Levels] >= 0 &&
    numbers[format.Levels] <= MostStampedLevels && numbers[format.ControlPoints] >= 0 &&
    numbers[format.ControlPoints] <= numbers[format.Points];
  return fits ? numbers : std::vector<vtkIdType>();
}

}
