// SPDX-License-Identifier: BSD-3-Clause
#include "vtkUniformSubdivisionAlgorithm.h"

#include "Private/Bezier/BezierCells.h"
#include "Private/Places/PlaceOutput.h"
#include "Private/Run/FilterRun.h"
#include "Private/Run/KeptEntries.h"

#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiProcessController.h"
#include "vtkPolyData.h"

#include <string>

vtkUniformSubdivisionAlgorithm::vtkUniformSubdivisionAlgorithm()
  : Cache(std::make_unique<subdivision::KeptEntries>())
  , Bezier(std::make_unique<subdivision::BezierRounds>())
{
}

vtkUniformSubdivisionAlgorithm::~vtkUniformSubdivisionAlgorithm() = default;

void vtkUniformSubdivisionAlgorithm::SetCacheOperator(bool cache)
{
  if (this->CacheOperator != cache)
  {
    this->CacheOperator = cache;
    this->Cache->Clear();
    this->Modified();
  }
}

vtkIdType vtkUniformSubdivisionAlgorithm::GetNumberOfTopologyBuilds() const
{
  return this->Cache->NumberOfBuilds;
}

bool vtkUniformSubdivisionAlgorithm::ComputeOperator(vtkSubdivisionOperator* result)
{
  return this->FindOperator(result);
}

bool vtkUniformSubdivisionAlgorithm::WritesBezierCells() const
{
  return this->OutputCells == BEZIER_CELLS && this->HasOutput() && !this->Places &&
    !this->DescribeBezierNeeds();
}

bool vtkUniformSubdivisionAlgorithm::AddsBounds() const
{
  return this->GenerateErrorBounds && this->HasOutput() && !this->Places &&
    !this->WritesBezierCells();
}

void vtkUniformSubdivisionAlgorithm::Inspect(vtkDataObject*, vtkDataObject* readable)
{
  if (this->WritesBezierCells())
  {
    this->Bezier->SetFurtherSteps(
      subdivision::CountFurtherSteps(this->SharesRanks() ? nullptr : readable, this->MakesQuads()));
  }
}

vtkSmartPointer<vtkDataObject> vtkUniformSubdivisionAlgorithm::Finish(vtkDataObject* made)
{
  return this->MakeBezierCells(made, true);
}

vtkSmartPointer<vtkDataObject> vtkUniformSubdivisionAlgorithm::MakeBezierCells(
  vtkDataObject* made, bool isWhole)
{
  if (!this->WritesBezierCells())
  {
    return made;
  }
  subdivision::BezierOptions options;
  options.Tolerance = this->BezierTolerance;
  options.Use32BitIds = this->Use32BitIds;
  options.Controller = this->SharesRanks() ? this->Controller.Get() : nullptr;
  options.IsWhole = isWhole && !options.Controller;
  options.MaximumNumberOfCells = this->MaximumNumberOfCells;
  options.Fail = [this](const std::string& text) { subdivision::Fail(this, text); };
  return this->Bezier->Finish(made, options);
}

bool vtkUniformSubdivisionAlgorithm::FindLimit(
  vtkIdTypeArray* cells, vtkDataArray* parameters, vtkPolyData* result)
{
  result->Initialize();
  std::string error = subdivision::CheckPlaceArrays(cells, parameters);
  if (error.empty() && this->InterfaceValues == DISCONTINUOUS_VALUES)
  {
    error = "Places have no values that jump: switch InterfaceValues to Continuous.";
  }
  if (!error.empty())
  {
    subdivision::Fail(this, error);
    return false;
  }
  const subdivision::PlaceRequest request{ cells, parameters, result, nullptr };
  this->Places = &request;
  this->RunAside();
  this->Places = nullptr;
  return result->GetNumberOfPoints() == cells->GetNumberOfTuples();
}

void vtkUniformSubdivisionAlgorithm::ReadLevelOptions(subdivision::LevelOptions& options)
{
  const char* const needs = this->DescribeBezierNeeds();
  const bool asksForBezier =
    this->OutputCells == BEZIER_CELLS && this->HasOutput() && !this->Places;
  if (asksForBezier && needs)
  {
    subdivision::Warn(this, needs);
  }
  if (asksForBezier && !needs && this->GenerateGlobalIds)
  {
    subdivision::Warn(this, "Bezier cells have no global ids: GenerateGlobalIds is ignored.");
  }
  if (asksForBezier && !needs && this->GenerateErrorBounds)
  {
    subdivision::Warn(this, "Bezier cells have no error bounds: GenerateErrorBounds is ignored.");
  }
  options.Levels = this->Places ? 0 : this->NumberOfLevels;
  options.ProjectToLimit = this->ProjectToLimit || this->WritesBezierCells() || this->Places;
  options.GenerateLimitNormals = this->GenerateLimitNormals && !this->Places;
  options.GenerateTangents = this->GenerateTangents && !this->Places;
  options.Use32BitIds = this->Use32BitIds;
  options.Cache = this->CacheOperator && !this->Places ? this->Cache.get() : nullptr;
  options.Places = this->Places;
}

int vtkUniformSubdivisionAlgorithm::RunLevels(vtkInformationVector** inputVector,
  vtkInformationVector* outputVector, subdivision::LevelOptions& options, bool isLocal,
  const Work& subdivide, const Work& addBounds)
{
  const bool writesBezierCells = this->WritesBezierCells();
  const bool addsBounds = this->AddsBounds();
  return this->Bezier->Run(writesBezierCells ? this->NumberOfLevels : -1, options,
    [&]
    {
      return this->Run(inputVector, outputVector, options, isLocal ? "" : nullptr,
        "NumberOfLevels = " + std::to_string(this->NumberOfLevels) +
          ". Use fewer levels, or a part of the input.",
        [&](vtkPointSet* input, vtkPointSet* output)
        {
          if (writesBezierCells)
          {
            this->Bezier->SetLevels(options);
          }
          return subdivide(input, output) && (!addsBounds || addBounds(input, output));
        });
    });
}

void vtkUniformSubdivisionAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfLevels: " << this->NumberOfLevels << "\n";
  os << indent << "ProjectToLimit: " << this->ProjectToLimit << "\n";
  os << indent << "GenerateLimitNormals: " << this->GenerateLimitNormals << "\n";
  os << indent << "GenerateTangents: " << this->GenerateTangents << "\n";
  os << indent << "GenerateErrorBounds: " << this->GenerateErrorBounds << "\n";
  os << indent << "OutputCells: " << this->OutputCells << "\n";
  os << indent << "BezierTolerance: " << this->BezierTolerance << "\n";
  os << indent << "Use32BitIds: " << this->Use32BitIds << "\n";
  os << indent << "CacheOperator: " << this->CacheOperator << "\n";
  os << indent << "Operators kept: " << this->Cache->GetNumberOfEntries() << " ("
     << this->Cache->GetMemorySize() << " bytes)\n";
  os << indent << "NumberOfTopologyBuilds: " << this->Cache->NumberOfBuilds << "\n";
}
