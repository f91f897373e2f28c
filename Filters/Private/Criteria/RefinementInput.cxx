// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Criteria/RefinementInput.h"

#include "Private/Reading/InputArrays.h"

#include "vtkCellData.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

namespace subdivision
{
namespace
{

bool IsUsable(vtkDataArray* array, vtkIdType tuples)
{
  return array && array->GetNumberOfTuples() == tuples && array->GetNumberOfComponents() > 0;
}

}

/// The array that the user chose for an index, else the fallback, else null.
bool RefinementArrays::FindNamed(
  int index, bool ofCells, const char* fallback, bool integral, vtkDataArray*& array) const
{
  vtkDataSetAttributes* data = this->Input->GetPointData();
  vtkIdType size = this->Input->GetNumberOfPoints();
  if (ofCells)
  {
    data = this->Input->GetCellData();
    size = this->Input->GetNumberOfCells();
  }
  return FindInputArray(this->Filter, data, size,
    { index, fallback, integral, !ofCells, !integral }, this->Warn, this->Fail, array);
}

bool RefinementArrays::FindOfPoints(int index, Array& found) const
{
  vtkDataArray* array = nullptr;
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  if (!GetInputArrayName(this->Filter, index, association).empty())
  {
    const bool isThere = this->FindNamed(index, false, nullptr, false, array);
    found = array;
    return isThere;
  }
  vtkPointData* data = this->Input->GetPointData();
  const vtkIdType points = this->Input->GetNumberOfPoints();
  found = IsUsable(data->GetScalars(), points) ? data->GetScalars() : nullptr;
  for (int i = 0; !found && i < data->GetNumberOfArrays(); ++i)
  {
    array = data->GetArray(i);
    if (IsUsable(array, points) &&
      (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE))
    {
      found = array;
    }
  }
  return true;
}

bool RefinementArrays::Find(int index, const char* criterion, Array& found, bool& ofCells) const
{
  vtkDataArray* array = nullptr;
  vtkDataArray* const ofPoints = this->Input->GetPointData()->GetScalars();
  vtkDataArray* const scalarsOfCells = this->Input->GetCellData()->GetScalars();
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  ofCells = false;
  if (!GetInputArrayName(this->Filter, index, association).empty())
  {
    ofCells = association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
    if (!this->FindNamed(index, ofCells, nullptr, false, array))
    {
      return false;
    }
  }
  else if (IsUsable(ofPoints, this->Input->GetNumberOfPoints()))
  {
    array = ofPoints;
  }
  else if (IsUsable(scalarsOfCells, this->Input->GetNumberOfCells()))
  {
    array = scalarsOfCells;
    ofCells = true;
  }
  if (!array)
  {
    this->Fail(
      std::string(criterion) + " needs an array: set array index " + std::to_string(index) + ".");
  }
  double range[2] = { 0., 0. };
  if (array && array->GetNumberOfTuples() > 0)
  {
    array->GetFiniteRange(range, -1);
  }
  if (range[0] > range[1])
  {
    this->Warn(std::string(criterion) + " refines nothing: the array \"" +
      std::string(array->GetName() ? array->GetName() : "") +
      "\" has no value that is a finite number.");
  }
  found = array;
  return array != nullptr;
}

bool RefinementArrays::FindOfCells(
  int index, const char* criterion, const char* fallback, Array& found) const
{
  vtkDataArray* array = nullptr;
  if (!this->FindNamed(index, true, fallback, true, array))
  {
    return false;
  }
  if (!array)
  {
    this->Fail(std::string(criterion) + " needs an integer cell array: set array index " +
      std::to_string(index) + ", or name the array " + fallback + ".");
  }
  found = array;
  return array != nullptr;
}

}
