// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSubdivisionMeasures.h"

#include "Private/Measures/Measures.h"
#include "Private/Reading/InputArrays.h"
#include "Private/Run/FilterRun.h"
#include "Private/Run/Ports.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkSubdivisionOperator.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

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
    !this->Levels->HasControl() ? this->Levels->AddControl(finished)
      : this->Gradients         ? this->Levels->FindGradients(finished, *this->Gradients)
                                : this->Levels->AddLevel(finished);
  }
  return finished;
}

bool vtkSubdivisionMeasures::FindArrays(
  vtkUnstructuredGrid* mesh, vtkDataArray*& material, vtkDataArray*& density)
{
  const auto warn = [](const std::string&) {}; // the reader of features has warned
  const auto fail = [this](const std::string& text) { this->FailMeasuring(text); };
  return subdivision::FindInputArray(this, mesh->GetCellData(), mesh->GetNumberOfCells(),
           { MATERIAL_ARRAY, "MaterialId", false }, warn, fail, material) &&
    subdivision::FindInputArray(this, mesh->GetPointData(), mesh->GetNumberOfPoints(),
      { DENSITY_ARRAY, nullptr, false, true, false, "densities" }, warn, fail, density);
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
  vtkTable* const table = vtkTable::GetData(outputVector);
  if (!this->Work([&] { return this->MeasureLevels(inputVector, table); }))
  {
    table->Initialize();
  }
  this->Levels.reset();
  return this->HasFailed ? 0 : 1;
}

bool vtkSubdivisionMeasures::Work(const std::function<bool()>& work)
{
  subdivision::MeasureOptions options;
  options.FindArrays = [this](
                         vtkUnstructuredGrid* mesh, vtkDataArray*& material, vtkDataArray*& density)
  { return this->FindArrays(mesh, material, density); };
  options.Fail = [this](const std::string& text) { this->FailMeasuring(text); };
  options.Tolerance = this->Tolerance;
  options.Controller = this->SharesRanks() ? this->Controller.Get() : nullptr;
  this->HasFailed = false;
  subdivision::FilterTraits traits;
  traits.Memory = "the levels. Make MaximumLevel or MaximumCellsOfLevel smaller.";
  subdivision::RunOptions messages;
  subdivision::ConnectToFilter(this, messages, this->HasFailed);
  const bool isDone = subdivision::DoWork(traits, messages,
    [&]
    {
      this->Levels = std::make_unique<subdivision::MeasuredLevels>(options);
      return work();
    });
  this->SetProgressShiftScale(0., 1.);
  return isDone;
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

bool vtkSubdivisionMeasures::ComputeGradients(vtkIdType row, vtkPointData* gradients)
{
  gradients->Initialize();
  this->Update();
  vtkTable* const table = this->GetOutput();
  if (row < 0 || row >= table->GetNumberOfRows())
  {
    subdivision::Fail(this,
      "There is no row " + std::to_string(row) + ": the table has " +
        std::to_string(table->GetNumberOfRows()) + ".");
    return false;
  }
  const auto read = [table, row](const char* name, double otherwise)
  {
    auto* const column = vtkDataArray::SafeDownCast(table->GetColumnByName(name));
    return column ? column->GetComponent(row, 0) : otherwise;
  };
  subdivision::MeasureGradients found;
  found.Dimension = static_cast<int>(read("Dimension", 0.));
  found.OfAllMaterials = read("AllMaterials", 1.) != 0.;
  found.Material = read("Material", 0.);
  const auto last =
    static_cast<int>(vtkDataArray::SafeDownCast(table->GetFieldData()->GetArray("MeasuredLevels"))
        ->GetComponent(0, 0));
  this->Gradients = &found;
  const int dimensions = std::exchange(this->OutputDimensions, int(ALL_DIMENSIONS));
  const bool isDone = this->Work([&] { return this->AddGradientsOfLevels(last); });
  if (isDone)
  {
    this->Levels->WriteGradients(found, gradients);
  }
  this->OutputDimensions = dimensions;
  this->Gradients = nullptr;
  this->Levels.reset();
  return isDone;
}

/// The limit is a sum of what the last levels have, and so are its derivatives.
bool vtkSubdivisionMeasures::AddGradientsOfLevels(int last)
{
  vtkInformationVector** const inputs = this->GetExecutive()->GetInputInformation();
  subdivision::MeasureGradients& found = *this->Gradients;
  bool isGood = this->MakeLevelAside(-1, true, { 0., 0.1 }, inputs) && this->Levels->HasControl();
  for (int level = std::max(last - 2, 0); isGood && level <= last; ++level)
  {
    std::vector<double> levels(last + 1, 0.);
    levels[level] = 1.;
    const double weight = subdivision::Extrapolate(levels, 0., 0.).Value;
    const double done = 0.1 + 0.3 * (level - last + 2);
    vtkNew<vtkSubdivisionOperator> rows;
    found.OfLevel = nullptr;
    isGood = this->MakeLevelAside(level, false, { done, 0.15 }, inputs, rows) &&
      this->MakeLevelAside(level, false, { done + 0.15, 0.15 }, inputs) && found.OfLevel &&
      rows->MultiplyTransposed(found.OfLevel);
    if (isGood && !found.Sum)
    {
      found.Sum = vtkSmartPointer<vtkDoubleArray>::New();
      found.Sum->SetNumberOfComponents(found.OfLevel->GetNumberOfComponents());
      found.Sum->SetNumberOfTuples(found.OfLevel->GetNumberOfTuples());
      found.Sum->FillValue(0.);
    }
    for (vtkIdType i = 0; isGood && i < found.Sum->GetNumberOfValues(); ++i)
    {
      found.Sum->SetValue(i, found.Sum->GetValue(i) + weight * found.OfLevel->GetValue(i));
    }
  }
  return isGood;
}

void vtkSubdivisionMeasures::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumLevel: " << this->MaximumLevel << "\n";
  os << indent << "MaximumCellsOfLevel: " << this->MaximumCellsOfLevel << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
}
