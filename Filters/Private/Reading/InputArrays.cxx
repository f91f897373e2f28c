// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Reading/InputArrays.h"

#include "Core/Memory/Loops.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

#include <cmath>
#include <sstream>

namespace subdivision
{
namespace
{

/// The first value that is no whole number; -1 if there is none. Some formats, for instance Exodus,
/// store whole numbers as floating point numbers.
vtkIdType FindBroken(vtkDataArray* numbers)
{
  const bool isFloating =
    numbers->GetDataType() == VTK_FLOAT || numbers->GetDataType() == VTK_DOUBLE;
  for (const vtkIdType i : InTurn(isFloating ? numbers->GetNumberOfTuples() : vtkIdType(0)))
  {
    const double value = numbers->GetComponent(i, 0);
    if (!(std::floor(value) == value && std::isfinite(value)))
    {
      return i;
    }
  }
  return -1;
}

}

std::string GetInputArrayName(vtkAlgorithm* algorithm, int index, int& association)
{
  vtkInformationVector* arrays =
    algorithm->GetInformation()->Get(vtkAlgorithm::INPUT_ARRAYS_TO_PROCESS());
  if (!arrays || index >= arrays->GetNumberOfInformationObjects())
  {
    return std::string();
  }
  vtkInformation* array = arrays->GetInformationObject(index);
  if (array->Has(vtkDataObject::FIELD_ASSOCIATION()))
  {
    association = array->Get(vtkDataObject::FIELD_ASSOCIATION());
  }
  const char* given = array->Get(vtkDataObject::FIELD_NAME());
  const std::string name = given ? given : "";
  return name == "None" ? std::string() : name;
}

bool FindInputArray(vtkAlgorithm* algorithm, vtkDataSetAttributes* data, vtkIdType size,
  const ArrayRequest& request, const std::function<void(const std::string&)>& warn,
  const std::function<void(const std::string&)>& fail, vtkDataArray*& array)
{
  array = nullptr;
  int association = 0;
  std::string name = GetInputArrayName(algorithm, request.Index, association);
  const bool named = !name.empty();
  if (!named)
  {
    if (!request.Fallback || !data->HasArray(request.Fallback))
    {
      return true;
    }
    name = request.Fallback;
  }
  vtkAbstractArray* found = data->GetAbstractArray(name.c_str());
  vtkDataArray* numbers = vtkDataArray::SafeDownCast(found);
  const std::string kind = request.OfPoints ? "point" : "cell";
  const std::string subject = (request.OfPoints ? "Point" : "Cell") + std::string(" array \"") +
    name + "\" (array index " + std::to_string(request.Index) + ")";
  std::string fault;
  if (!found)
  {
    fault = " is not there; choose one of the input's " + kind + " arrays, or None.";
  }
  else if (!numbers || found->GetNumberOfComponents() < 1 ||
    (!request.AnyComponents && found->GetNumberOfComponents() != 1))
  {
    fault = " is not usable: it must hold numbers" +
      (request.AnyComponents ? std::string(".") : ", one for each " + kind + ".");
  }
  else if (found->GetNumberOfTuples() != size)
  {
    fault = " has " + std::to_string(found->GetNumberOfTuples()) + " values for " +
      std::to_string(size) + " " + kind + "s.";
  }
  else if (request.Smoothed && numbers->GetDataType() != VTK_FLOAT &&
    numbers->GetDataType() != VTK_DOUBLE)
  {
    fault = std::string(" is not usable: ") + request.Smoothed +
      " must be floating point numbers, as others are not smoothed. Convert it first.";
  }
  else if (request.Integral)
  {
    const vtkIdType broken = FindBroken(numbers);
    if (broken >= 0)
    {
      std::ostringstream text;
      text << " is not usable: it must hold integers, but " << kind << " " << broken << " has "
           << numbers->GetComponent(broken, 0) << ".";
      fault = text.str();
    }
  }
  if (fault.empty())
  {
    array = numbers;
    return true;
  }
  if (named)
  {
    fail(subject + fault);
    return false;
  }
  warn(subject + fault + " It is ignored.");
  return true;
}

}
