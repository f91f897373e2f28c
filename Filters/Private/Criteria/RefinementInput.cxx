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

class Reader
{
public:
  using Tell = std::function<void(const std::string&)>;
  Reader(vtkAlgorithm* filter, vtkPointSet* input, const RefinementSettings& settings,
    const Tell& warn, const Tell& fail)
    : Filter(filter)
    , Input(input)
    , Settings(settings)
    , Warn(warn)
    , Fail(fail)
  {
  }
  bool Run(RefinementOptions& options);

private:
  bool FindArray(int index, bool& ofCells, vtkDataArray*& array);
  bool FindNamed(
    int index, bool ofCells, const char* fallback, bool integral, vtkDataArray*& array);
  std::string Index(int index) const { return "array index " + std::to_string(index); }

  vtkAlgorithm* Filter;
  vtkPointSet* Input;
  const RefinementSettings& Settings;
  const Tell& Warn;
  const Tell& Fail;
};

/// The array that the user chose for an index, else the fallback, else null.
bool Reader::FindNamed(
  int index, bool ofCells, const char* fallback, bool integral, vtkDataArray*& array)
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

/// The array for attribute or range: the one that the user chose, else the active scalars; for the
/// attribute else the first array of floating point numbers.
bool Reader::FindArray(int index, bool& ofCells, vtkDataArray*& array)
{
  const bool isRange = index == this->Settings.RangeIndex;
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  const bool named = !GetInputArrayName(this->Filter, index, association).empty();
  ofCells = named && isRange && association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  if (named)
  {
    return this->FindNamed(index, ofCells, nullptr, false, array);
  }
  auto isUsable = [](vtkDataArray* candidate, vtkIdType tuples)
  {
    return candidate && candidate->GetNumberOfTuples() == tuples &&
      candidate->GetNumberOfComponents() > 0;
  };
  vtkPointData* data = this->Input->GetPointData();
  array = data->GetScalars();
  if (isUsable(array, this->Input->GetNumberOfPoints()))
  {
    return true;
  }
  if (isRange)
  {
    array = this->Input->GetCellData()->GetScalars();
    ofCells = isUsable(array, this->Input->GetNumberOfCells());
    array = ofCells ? array : nullptr;
    return true;
  }
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    array = data->GetArray(i);
    if (isUsable(array, this->Input->GetNumberOfPoints()) &&
      (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE))
    {
      return true;
    }
  }
  array = nullptr;
  return true;
}

bool Reader::Run(RefinementOptions& options)
{
  const RefinementSettings& settings = this->Settings;
  const bool alone = !settings.HasOthers && !settings.RefineByArrayRange &&
    !settings.RefineByEdgeLength && !settings.RefineByGeometricError &&
    !settings.RefineByCurvature && !settings.RefineByWantedLevel;
  options.MaximumLevel = settings.MaximumLevel;
  options.InterpolateIntegers = settings.InterpolateIntegers;
  bool ofCells = false;
  vtkDataArray* array = nullptr;
  if (settings.RefineByAttributeError)
  {
    if (!this->FindArray(settings.AttributeIndex, ofCells, array))
    {
      return false;
    }
    if (!array && alone)
    {
      this->Warn("There is nothing to refine by: the input has neither active point scalars nor a "
                 "floating point array of points. Choose an array (" +
        this->Index(settings.AttributeIndex) + "), or another criterion.");
    }
    options.Attribute = array;
    options.AttributeTolerance = settings.AttributeTolerance;
    options.AttributeOfLimit = settings.AttributeErrorOfLimit;
  }
  if (settings.RefineByArrayRange)
  {
    if (!this->FindArray(settings.RangeIndex, options.RangeOfCells, array))
    {
      return false;
    }
    if (!array)
    {
      this->Fail(
        "RefineByArrayRange needs an array: set " + this->Index(settings.RangeIndex) + ".");
      return false;
    }
    options.Range = array;
    options.Least = settings.ArrayRange[0];
    options.Most = settings.ArrayRange[1];
  }
  options.ByEdgeLength = settings.RefineByEdgeLength;
  options.MaximumEdgeLength = settings.MaximumEdgeLength;
  options.ByGeometricError = settings.RefineByGeometricError;
  options.GeometricTolerance = settings.GeometricTolerance;
  options.RelativeTolerance = settings.RelativeTolerance;
  options.ByCurvature = settings.RefineByCurvature;
  options.MaximumAngle = settings.MaximumAngle;
  if (settings.RefineByWantedLevel)
  {
    if (!this->FindNamed(settings.LevelIndex, true, "WantedLevel", true, array))
    {
      return false;
    }
    if (!array)
    {
      this->Fail("RefineByWantedLevel needs an integer cell array: set " +
        this->Index(settings.LevelIndex) + ", or name the array WantedLevel.");
      return false;
    }
    options.WantedLevel = array;
  }
  return true;
}

}

bool ReadRefinementOptions(vtkAlgorithm* filter, vtkPointSet* input,
  const RefinementSettings& settings, const std::function<void(const std::string&)>& warn,
  const std::function<void(const std::string&)>& fail, RefinementOptions& options)
{
  return Reader(filter, input, settings, warn, fail).Run(options);
}

}
