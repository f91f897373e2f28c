// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRedGreenRefinement.h"

#include "Private/InputArrays.h"
#include "Private/RedGreenRun.h"
#include "Private/RefinementSelection.h"

#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkCompositeDataSet.h"
#include "vtkImplicitFunction.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkSelection.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

vtkStandardNewMacro(vtkRedGreenRefinement);

vtkRedGreenRefinement::vtkRedGreenRefinement()
{
  this->MaximumNumberOfCells = 50000000;
  this->SetNumberOfInputPorts(2);
  this->AddObserver(vtkCommand::StartEvent, this, &vtkRedGreenRefinement::OnStart);
  this->AddObserver(vtkCommand::EndEvent, this, &vtkRedGreenRefinement::OnEnd);
}

vtkRedGreenRefinement::~vtkRedGreenRefinement() = default;

int vtkRedGreenRefinement::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkSelection");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

void vtkRedGreenRefinement::SetSelectionConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

void vtkRedGreenRefinement::SetImplicitFunction(vtkImplicitFunction* function)
{
  if (this->ImplicitFunction != function)
  {
    this->ImplicitFunction = function;
    this->Modified();
  }
}

vtkImplicitFunction* vtkRedGreenRefinement::GetImplicitFunction() const
{
  return this->ImplicitFunction;
}

vtkMTimeType vtkRedGreenRefinement::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->ImplicitFunction ? std::max(own, this->ImplicitFunction->GetMTime()) : own;
}

/// Looks for what is selected in a composite input, as long as all of it can be seen.
void vtkRedGreenRefinement::OnStart()
{
  if (this->UpdateDepth++ > 0)
  {
    return;
  }
  this->SelectedCells.clear();
  auto* all = vtkCompositeDataSet::SafeDownCast(
    this->GetNumberOfInputConnections(0) > 0 ? this->GetInputDataObject(0, 0) : nullptr);
  this->IsComposite = all != nullptr;
  if (all && this->RefineBySelection)
  {
    this->FindSelected(all);
  }
}

void vtkRedGreenRefinement::OnEnd()
{
  if (--this->UpdateDepth == 0)
  {
    this->SelectedCells.clear();
  }
}

void vtkRedGreenRefinement::FindSelected(vtkDataObject* input)
{
  vtkDataObject* selection =
    this->GetNumberOfInputConnections(1) > 0 ? this->GetInputDataObject(1, 0) : nullptr;
  bool isUsable = true;
  this->SelectedCells = subdivision::FindSelectedCells(input, vtkSelection::SafeDownCast(selection),
    [&](const std::string& message)
    {
      isUsable = false;
      vtkWarningMacro("RefineBySelection: the selection cannot be used. " << message);
    });
  if (this->SelectedCells.empty() && isUsable)
  {
    vtkWarningMacro("RefineBySelection: no cell is selected, so nothing is refined for that. "
                    "Connect a selection (input port 1) of cells or points of the input.");
  }
}

// ------------------------------------------------------------------------------------------------
// Criteria

/// The array named at an index; null where none is.
bool vtkRedGreenRefinement::FindNamed(vtkPointSet* input, int index, bool ofCells,
  const char* fallback, bool integral, vtkDataArray*& array)
{
  vtkDataSetAttributes* data = ofCells ? static_cast<vtkDataSetAttributes*>(input->GetCellData())
                                       : static_cast<vtkDataSetAttributes*>(input->GetPointData());
  return subdivision::FindInputArray(
    this, data, ofCells ? input->GetNumberOfCells() : input->GetNumberOfPoints(),
    { index, fallback, integral, !ofCells, !integral },
    [this](const std::string& message) { vtkWarningMacro(<< message); },
    [this](const std::string& message) { vtkErrorMacro(<< message); }, array);
}

/// The array at index 5 or 6: named, or the active scalars; of index 5, else the first floating
/// one.
bool vtkRedGreenRefinement::FindArray(
  vtkPointSet* input, int index, bool& ofCells, vtkDataArray*& array)
{
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  const bool named = !subdivision::GetInputArrayName(this, index, association).empty();
  ofCells = named && index == RANGE_ARRAY && association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  if (named)
  {
    return this->FindNamed(input, index, ofCells, nullptr, false, array);
  }
  auto isUsable = [](vtkDataArray* candidate, vtkIdType tuples)
  {
    return candidate && candidate->GetNumberOfTuples() == tuples &&
      candidate->GetNumberOfComponents() > 0;
  };
  vtkPointData* data = input->GetPointData();
  array = data->GetScalars();
  if (isUsable(array, input->GetNumberOfPoints()))
  {
    return true;
  }
  if (index == RANGE_ARRAY)
  {
    array = input->GetCellData()->GetScalars();
    ofCells = isUsable(array, input->GetNumberOfCells());
    array = ofCells ? array : nullptr;
    return true;
  }
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    array = data->GetArray(i);
    if (isUsable(array, input->GetNumberOfPoints()) &&
      (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE))
    {
      return true;
    }
  }
  array = nullptr;
  return true;
}

bool vtkRedGreenRefinement::ReadCriteria(
  vtkPointSet* input, subdivision::RefinementOptions& options)
{
  const bool alone = !this->RefineByArrayRange && !this->RefineBySelection &&
    !this->RefineByFunction && !this->RefineByEdgeLength && !this->RefineByGeometricError &&
    !this->RefineByWantedLevel;
  options.MaximumLevel = this->MaximumLevel;
  options.InterpolateIntegers = this->InterpolateIntegers;
  bool ofCells = false;
  vtkDataArray* array = nullptr;
  if (this->RefineByAttributeError)
  {
    if (!this->FindArray(input, ATTRIBUTE_ARRAY, ofCells, array))
    {
      return false;
    }
    if (!array && alone)
    {
      vtkWarningMacro("There is nothing to refine by: the input has neither active point scalars "
                      "nor a floating point array of points. Choose an array (index 5), or another "
                      "criterion.");
    }
    options.Attribute = array;
    options.AttributeTolerance = this->AttributeTolerance;
    options.AttributeOfLimit = this->AttributeErrorKind == LIMIT_DIFFERENCE;
  }
  if (this->RefineByArrayRange)
  {
    if (!this->FindArray(input, RANGE_ARRAY, options.RangeOfCells, array))
    {
      return false;
    }
    if (!array)
    {
      vtkErrorMacro("RefineByArrayRange needs an array: set array index 6.");
      return false;
    }
    options.Range = array;
    options.Least = this->ArrayRange[0];
    options.Most = this->ArrayRange[1];
  }
  if (this->RefineBySelection)
  {
    if (!this->IsComposite)
    {
      this->FindSelected(input);
    }
    const auto selected = this->SelectedCells.find(input);
    if (selected != this->SelectedCells.end())
    {
      options.Selected = selected->second;
    }
  }
  if (this->RefineByFunction)
  {
    if (!this->ImplicitFunction)
    {
      vtkErrorMacro("RefineByFunction needs an ImplicitFunction.");
      return false;
    }
    options.Function = this->ImplicitFunction;
  }
  options.ByEdgeLength = this->RefineByEdgeLength;
  options.MaximumEdgeLength = this->MaximumEdgeLength;
  options.ByGeometricError = this->RefineByGeometricError;
  options.GeometricTolerance = this->GeometricTolerance;
  options.RelativeTolerance = this->RelativeTolerance;
  if (this->RefineByWantedLevel)
  {
    if (!this->FindNamed(input, LEVEL_ARRAY, true, "WantedLevel", true, array))
    {
      return false;
    }
    if (!array)
    {
      vtkErrorMacro("RefineByWantedLevel needs an integer cell array: set array index 7, or name "
                    "the array WantedLevel.");
      return false;
    }
    options.WantedLevel = array;
  }
  return true;
}

// ------------------------------------------------------------------------------------------------

int vtkRedGreenRefinement::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  subdivision::RedGreenOptions options;
  options.LimitPlacement = this->Placement == LIMIT;
  bool isUsable = true;
  const int done = this->Run(inputVector, outputVector, options,
    "Partitions are refined each by itself: at their borders they may not fit.",
    "this refinement. Lower MaximumNumberOfCells or MaximumLevel, raise the tolerances, or use a "
    "part of the input.",
    [&](vtkPointSet* input, vtkUnstructuredGrid* output)
    {
      isUsable = this->ReadCriteria(input, options.Criteria);
      return isUsable && subdivision::RefineRedGreen(input, options, output);
    });
  return isUsable ? done : 0;
}

void vtkRedGreenRefinement::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RefineByAttributeError: " << this->RefineByAttributeError << "\n";
  os << indent << "AttributeTolerance: " << this->AttributeTolerance << "\n";
  os << indent << "AttributeErrorKind: " << this->AttributeErrorKind << "\n";
  os << indent << "RefineByArrayRange: " << this->RefineByArrayRange << "\n";
  os << indent << "ArrayRange: " << this->ArrayRange[0] << " " << this->ArrayRange[1] << "\n";
  os << indent << "RefineBySelection: " << this->RefineBySelection << "\n";
  os << indent << "RefineByFunction: " << this->RefineByFunction << "\n";
  os << indent << "ImplicitFunction: " << this->ImplicitFunction.Get() << "\n";
  os << indent << "RefineByEdgeLength: " << this->RefineByEdgeLength << "\n";
  os << indent << "MaximumEdgeLength: " << this->MaximumEdgeLength << "\n";
  os << indent << "RefineByGeometricError: " << this->RefineByGeometricError << "\n";
  os << indent << "GeometricTolerance: " << this->GeometricTolerance << "\n";
  os << indent << "RelativeTolerance: " << this->RelativeTolerance << "\n";
  os << indent << "RefineByWantedLevel: " << this->RefineByWantedLevel << "\n";
  os << indent << "MaximumLevel: " << this->MaximumLevel << "\n";
  os << indent << "Placement: " << this->Placement << "\n";
}
