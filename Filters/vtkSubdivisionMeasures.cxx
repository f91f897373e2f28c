// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSubdivisionMeasures.h"

#include "Private/Measures/Measures.h"
#include "Private/Reading/InputArrays.h"
#include "Private/Run/FilterRun.h"
#include "Private/Run/Ports.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <string>

vtkStandardNewMacro(vtkSubdivisionMeasures);

vtkSubdivisionMeasures::vtkSubdivisionMeasures() = default;
vtkSubdivisionMeasures::~vtkSubdivisionMeasures() = default;

vtkTable* vtkSubdivisionMeasures::GetOutput()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(0));
}

int vtkSubdivisionMeasures::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkTable");
  return 1;
}

int vtkSubdivisionMeasures::RequestDataObject(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return request ? subdivision::MakeOutput<vtkTable>(outputVector)
                 : this->Superclass::RequestDataObject( // for ComputeOperator and EvaluateLimit
                     request, inputVector, outputVector);
}

vtkSmartPointer<vtkDataObject> vtkSubdivisionMeasures::Finish(vtkDataObject* made)
{
  const auto finished = this->Superclass::Finish(made);
  if (this->Levels && this->HasOutput())
  {
    this->Levels->HasControl() ? this->Levels->AddLevel(finished)
                               : this->Levels->AddControl(finished);
  }
  return finished;
}

bool vtkSubdivisionMeasures::FindArrays(
  vtkUnstructuredGrid* mesh, vtkDataArray*& material, vtkDataArray*& density)
{
  const auto warn = [](const std::string&) {}; // the reader of features has warned
  const auto fail = [this](const std::string& text) { this->FailMeasuring(text); };
  const bool areFound =
    subdivision::FindInputArray(this, mesh->GetCellData(), mesh->GetNumberOfCells(),
      { MATERIAL_ARRAY, "MaterialId", false }, warn, fail, material) &&
    subdivision::FindInputArray(this, mesh->GetPointData(), mesh->GetNumberOfPoints(),
      { DENSITY_ARRAY, nullptr, false, true }, warn, fail, density);
  if (areFound && density && density->GetDataType() != VTK_FLOAT &&
    density->GetDataType() != VTK_DOUBLE)
  {
    fail(std::string("Point array \"") + density->GetName() +
      "\" (array index 11) is not usable: densities must be floating point numbers, as others are "
      "not smoothed. Convert it first.");
    return false;
  }
  return areFound;
}

void vtkSubdivisionMeasures::FailMeasuring(const std::string& text)
{
  subdivision::Fail(this, text);
  this->HasFailed = true;
}

bool vtkSubdivisionMeasures::MeasureLevel(int level, vtkInformationVector** inputVector)
{
  // The first is at the last one's time, so that an update tells all.
  const double runs = this->MaximumLevel + 2.;
  this->HasFailed |=
    !this->MakeLevelAside(level, level < 0, { (level + 1.) / runs, 1. / runs }, inputVector);
  return !this->IsStopped() && !this->HasFailed && this->Levels->HasControl() &&
    this->Levels->GetNumberOfLevels() == level + 1;
}

int vtkSubdivisionMeasures::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!request)
  {
    return this->Superclass::RequestData(request, inputVector, outputVector);
  }
  subdivision::MeasureOptions options;
  options.FindArrays = [this](
                         vtkUnstructuredGrid* mesh, vtkDataArray*& material, vtkDataArray*& density)
  { return this->FindArrays(mesh, material, density); };
  options.Fail = [this](const std::string& text) { this->FailMeasuring(text); };
  options.Tolerance = this->Tolerance;
  options.Controller = this->SharesRanks() ? this->Controller.Get() : nullptr;
  this->HasFailed = false;
  vtkTable* const table = vtkTable::GetData(outputVector);
  subdivision::FilterTraits traits;
  traits.Memory = "the levels. Make MaximumLevel or MaximumCellsOfLevel smaller.";
  subdivision::RunOptions messages;
  subdivision::ConnectToFilter(this, messages, this->HasFailed);
  const bool isDone = subdivision::DoWork(traits, messages,
    [&]
    {
      this->Levels = std::make_unique<subdivision::MeasuredLevels>(options);
      return this->MeasureLevels(inputVector, table);
    });
  if (!isDone)
  {
    table->Initialize();
  }
  this->SetProgressShiftScale(0., 1.);
  this->Levels.reset();
  return this->HasFailed ? 0 : 1;
}

bool vtkSubdivisionMeasures::MeasureLevels(vtkInformationVector** inputVector, vtkTable* table)
{
  for (int level = -1; level <= this->MaximumLevel; ++level)
  {
    if (level > 1 &&
      (this->Levels->CountNextCells() > this->MaximumCellsOfLevel || this->Levels->IsEnough()))
    {
      break;
    }
    if (!this->MeasureLevel(level, inputVector))
    {
      return false;
    }
  }
  table->Initialize();
  this->Levels->Write(table);
  if (table->GetNumberOfRows() == 0)
  {
    subdivision::Warn(this, "The input has no cells of these dimensions: nothing is measured.");
  }
  return true;
}

void vtkSubdivisionMeasures::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumLevel: " << this->MaximumLevel << "\n";
  os << indent << "MaximumCellsOfLevel: " << this->MaximumCellsOfLevel << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
}
