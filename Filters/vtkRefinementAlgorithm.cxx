// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRefinementAlgorithm.h"

#include "Private/ArrayNames.h"
#include "Private/Criteria/RefinementInput.h"
#include "Private/Reading/InputArrays.h"
#include "Private/Reading/SelectedParts.h"
#include "Private/Run/FilterRun.h"
#include "Private/Run/Ports.h"
#include "Private/Run/RunOptions.h"

#include "vtkCellData.h"
#include "vtkImplicitFunction.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkSelection.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

vtkRefinementAlgorithm::vtkRefinementAlgorithm()
{
  this->SetNumberOfInputPorts(2);
}

vtkRefinementAlgorithm::~vtkRefinementAlgorithm() = default;

int vtkRefinementAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  return port == 0 ? this->Superclass::FillInputPortInformation(port, info)
                   : subdivision::TakeTypes(info, { "vtkSelection" }, true);
}

void vtkRefinementAlgorithm::SetSelectionConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

vtkCxxSetSmartPointerMacro(vtkRefinementAlgorithm, ImplicitFunction, vtkImplicitFunction);

vtkImplicitFunction* vtkRefinementAlgorithm::GetImplicitFunction() const
{
  return this->ImplicitFunction;
}

vtkMTimeType vtkRefinementAlgorithm::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->ImplicitFunction ? std::max(own, this->ImplicitFunction->GetMTime()) : own;
}

// ------------------------------------------------------------------------------------------------
// Selection

void vtkRefinementAlgorithm::Inspect(vtkDataObject* input, vtkDataObject* readable)
{
  if (!this->RefineBySelection || !input)
  {
    return;
  }
  vtkDataObject* selection =
    this->GetNumberOfInputConnections(1) > 0 ? this->GetInputDataObject(1, 0) : nullptr;
  bool isUsable = true;
  this->SelectedCells =
    subdivision::FindSelectedCells(input, readable, vtkSelection::SafeDownCast(selection),
      [&](const std::string& message)
      {
        isUsable = false;
        subdivision::Warn(this, "RefineBySelection: the selection cannot be used. " + message);
      });
  if (this->SelectedCells.empty() && isUsable)
  {
    subdivision::Warn(this,
      "RefineBySelection: no cell is selected, so nothing is refined for that. "
      "Connect a selection (input port 1) of cells or points of the input.");
  }
}

/// Writes the selection into the block, so that it can be found in the joined mesh.
void vtkRefinementAlgorithm::Prepare(vtkPointSet* block, vtkPointSet* copy)
{
  if (!this->RefineBySelection)
  {
    return;
  }
  subdivision::RefinementOptions criteria;
  this->ReadSelection(block, criteria);
  vtkNew<vtkUnsignedCharArray> selected;
  selected->SetName(subdivision::SelectedName);
  selected->SetNumberOfValues(copy->GetNumberOfCells());
  selected->FillValue(0);
  std::copy(criteria.Selected.begin(), criteria.Selected.end(), selected->GetPointer(0));
  copy->GetCellData()->AddArray(selected);
}

void vtkRefinementAlgorithm::ReadSelection(
  vtkPointSet* input, subdivision::RefinementOptions& criteria)
{
  auto* joined =
    vtkUnsignedCharArray::SafeDownCast(input->GetCellData()->GetArray(subdivision::SelectedName));
  if (joined)
  {
    criteria.Selected.assign(
      joined->GetPointer(0), joined->GetPointer(0) + joined->GetNumberOfValues());
    return;
  }
  criteria.Selected.clear(); // of the block before
  const auto selected = this->SelectedCells.find(input);
  if (selected != this->SelectedCells.end())
  {
    criteria.Selected = selected->second;
  }
}

// ------------------------------------------------------------------------------------------------
// Criteria

bool vtkRefinementAlgorithm::ReadArrays(vtkPointSet* input, const subdivision::RunOptions& options,
  subdivision::RefinementOptions& criteria)
{
  const subdivision::RefinementArrays arrays(this, input, options.Warn, options.Fail);
  return (!this->RefineByAttributeError ||
           arrays.FindOfPoints(ATTRIBUTE_ARRAY, criteria.Attribute)) &&
    (!this->RefineByArrayRange ||
      arrays.Find(RANGE_ARRAY, "RefineByArrayRange", criteria.Range, criteria.RangeOfCells)) &&
    (!this->RefineByWantedLevel ||
      arrays.FindOfCells(LEVEL_ARRAY, "RefineByWantedLevel", "WantedLevel", criteria.WantedLevel));
}

bool vtkRefinementAlgorithm::ReadCriteria(vtkPointSet* input,
  const subdivision::RunOptions& options, subdivision::RefinementOptions& criteria)
{
  criteria.AttributeTolerance = this->AttributeTolerance;
  criteria.AttributeErrorOfLimit = this->AttributeErrorKind == LIMIT_DIFFERENCE;
  criteria.Least = this->ArrayRange[0];
  criteria.Most = this->ArrayRange[1];
  criteria.ByEdgeLength = this->RefineByEdgeLength;
  criteria.MaximumEdgeLength = this->MaximumEdgeLength;
  criteria.ByGeometricError = this->RefineByGeometricError;
  criteria.GeometricTolerance = this->GeometricTolerance;
  criteria.RelativeTolerance = this->RelativeTolerance;
  criteria.ByCurvature = this->RefineByCurvature;
  criteria.MaximumAngle = this->MaximumAngle;
  criteria.MaximumLevel = this->MaximumLevel;
  criteria.InterpolateIntegers = this->InterpolateIntegers;
  if (!this->ReadArrays(input, options, criteria))
  {
    return false;
  }
  if (this->RefineBySelection)
  {
    this->ReadSelection(input, criteria);
  }
  if (this->RefineByFunction)
  {
    if (!this->ImplicitFunction)
    {
      options.Fail("RefineByFunction needs an ImplicitFunction.");
      return false;
    }
    criteria.Function = this->ImplicitFunction;
  }
  if (this->RefineByAttributeError && !this->RefineBySelection && criteria.IsEmpty())
  {
    criteria.ByGeometricError = true;
  }
  // The default does something on each mesh: of surfaces it is geometry, else an array that nobody
  // named.
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  const bool isNamed = !subdivision::GetInputArrayName(this, ATTRIBUTE_ARRAY, association).empty();
  criteria.AreDefaults = this->RefineByGeometricError == this->IsOfSurfaces() &&
    this->RefineByAttributeError != this->IsOfSurfaces() && !isNamed && !this->RefineByCurvature &&
    !this->RefineByEdgeLength && !this->RefineBySelection && !criteria.ReadsCells() &&
    !criteria.Function && this->AttributeTolerance == 0.1 && this->AttributeErrorKind == JUMP &&
    this->GeometricTolerance == 0.001 && this->RelativeTolerance;
  return true;
}

int vtkRefinementAlgorithm::RunRounds(vtkInformationVector** inputVector,
  vtkInformationVector* outputVector, subdivision::RunOptions& options,
  subdivision::RefinementOptions& criteria,
  const std::function<bool(vtkPointSet*, vtkPointSet*)>& refine)
{
  const int result = this->Run(inputVector, outputVector, options,
    "They are refined like others; cells may not fit those of other partitions.",
    "this refinement. Lower MaximumNumberOfCells or MaximumLevel, raise the tolerances, or use a "
    "part of the input.",
    [&](vtkPointSet* mesh, vtkPointSet* output)
    {
      const bool done = this->ReadCriteria(mesh, options, criteria) && refine(mesh, output);
      if (!mesh->GetCellData()->HasArray(subdivision::BlockName))
      {
        output->GetCellData()->RemoveArray(subdivision::SelectedName);
      }
      return done;
    });
  this->SelectedCells.clear();
  return result;
}

void vtkRefinementAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
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
}
