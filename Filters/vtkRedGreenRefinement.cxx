// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRedGreenRefinement.h"

#include "Private/Criteria/RefinementInput.h"
#include "Private/Criteria/RefinementSelection.h"
#include "Private/RedGreen/RedGreenRun.h"

#include "vtkCommand.h"
#include "vtkCompositeDataSet.h"
#include "vtkImplicitFunction.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
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

/// Finds the selected cells of a composite input now, before VTK executes the filter for each
/// block: only here all blocks can be seen.
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

bool vtkRedGreenRefinement::ReadCriteria(vtkPointSet* input, subdivision::RedGreenOptions& run)
{
  const subdivision::RefinementSettings settings = subdivision::GetRefinementSettings(
    this, ATTRIBUTE_ARRAY, this->RefineBySelection || this->RefineByFunction);
  subdivision::RefinementOptions& options = run.Criteria;
  if (!subdivision::ReadRefinementOptions(this, input, settings, run.Warn, run.Fail, options))
  {
    return false;
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
      run.Fail("RefineByFunction needs an ImplicitFunction.");
      return false;
    }
    options.Function = this->ImplicitFunction;
  }
  return true;
}

// ------------------------------------------------------------------------------------------------

int vtkRedGreenRefinement::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  subdivision::RedGreenOptions options;
  options.LimitPlacement = this->Placement == LIMIT;
  return this->Run(inputVector, outputVector, options,
    "Each partition is refined by itself, so that cells may not fit together at its borders.",
    "this refinement. Lower MaximumNumberOfCells or MaximumLevel, raise the tolerances, or use a "
    "part of the input.",
    [&](vtkPointSet* input, vtkUnstructuredGrid* output)
    {
      return this->ReadCriteria(input, options) &&
        subdivision::RefineRedGreen(input, options, output);
    });
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
  os << indent << "RefineByCurvature: " << this->RefineByCurvature << "\n";
  os << indent << "MaximumAngle: " << this->MaximumAngle << "\n";
  os << indent << "RefineByWantedLevel: " << this->RefineByWantedLevel << "\n";
  os << indent << "MaximumLevel: " << this->MaximumLevel << "\n";
  os << indent << "Placement: " << this->Placement << "\n";
}
