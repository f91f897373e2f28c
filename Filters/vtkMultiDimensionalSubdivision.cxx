// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMultiDimensionalSubdivision.h"

#include "Private/Bezier/BezierCells.h"
#include "Private/Distribution/Dimensions.h"
#include "Private/Places/PlaceOutput.h"
#include "Private/Run/FilterRun.h"
#include "Private/Run/KeptEntries.h"
#include "Private/Uniform/UniformBounds.h"
#include "Private/Uniform/UniformSubdivision.h"

#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkMultiDimensionalSubdivision);

vtkMultiDimensionalSubdivision::vtkMultiDimensionalSubdivision()
  : Cache(std::make_unique<subdivision::KeptEntries>())
  , Bezier(std::make_unique<subdivision::BezierRounds>())
{
}

vtkMultiDimensionalSubdivision::~vtkMultiDimensionalSubdivision() = default;

void vtkMultiDimensionalSubdivision::SetCacheOperator(bool cache)
{
  if (this->CacheOperator != cache)
  {
    this->CacheOperator = cache;
    this->Cache->Clear();
    this->Modified();
  }
}

void vtkMultiDimensionalSubdivision::AddOutputDimension(int dimension)
{
  if (dimension >= 0 && dimension <= 3)
  {
    this->SetOutputDimensions(this->OutputDimensions | 1 << dimension);
  }
}

bool vtkMultiDimensionalSubdivision::WritesBezierCells() const
{
  return this->OutputCells == BEZIER_CELLS && this->HasOutput() && !this->Places &&
    !this->KeepCellTypes && this->VolumeScheme != TET_OCT;
}

void vtkMultiDimensionalSubdivision::Inspect(vtkDataObject*, vtkDataObject* readable)
{
  if (this->WritesBezierCells())
  {
    this->Bezier->SetFurtherSteps(
      subdivision::CountFurtherSteps(this->SharesRanks() ? nullptr : readable, false));
  }
}

vtkSmartPointer<vtkDataObject> vtkMultiDimensionalSubdivision::Finish(vtkDataObject* made)
{
  const auto part = subdivision::TakeDimensions(
    made, this->OutputDimensions, [](const std::string&) {}); // all points of the own output exist
  if (!this->WritesBezierCells())
  {
    return part;
  }
  subdivision::BezierOptions options;
  options.Tolerance = this->BezierTolerance;
  options.Use32BitIds = this->Use32BitIds;
  options.Controller = this->SharesRanks() ? this->Controller.Get() : nullptr;
  options.IsWhole = part == made && !options.Controller;
  options.MaximumNumberOfCells = this->MaximumNumberOfCells;
  options.Fail = [this](const std::string& text) { subdivision::Fail(this, text); };
  return this->Bezier->Finish(part, options);
}

bool vtkMultiDimensionalSubdivision::ComputeOperator(vtkSubdivisionOperator* result)
{
  if (this->KeepCellTypes)
  {
    subdivision::Fail(this, "With KeepCellTypes there is no operator to hand out: switch it off.");
    return false;
  }
  return this->FindOperator(result);
}

bool vtkMultiDimensionalSubdivision::EvaluateLimit(
  vtkIdTypeArray* cells, vtkDataArray* parameters, vtkPolyData* result)
{
  const std::string error = subdivision::CheckPlaceArrays(cells, parameters);
  if (!error.empty())
  {
    subdivision::Fail(this, error);
    return false;
  }
  if (this->InterfaceValues == DISCONTINUOUS_VALUES)
  {
    subdivision::Fail(
      this, "Places have no values that jump: switch InterfaceValues to Continuous.");
    return false;
  }
  const subdivision::PlaceRequest request{ cells, parameters, result, nullptr };
  result->Initialize();
  this->Places = &request;
  this->RunAside();
  this->Places = nullptr;
  return result->GetNumberOfPoints() == cells->GetNumberOfTuples();
}

vtkIdType vtkMultiDimensionalSubdivision::GetNumberOfTopologyBuilds() const
{
  return this->Cache->NumberOfBuilds;
}

int vtkMultiDimensionalSubdivision::GetLayersOfCells() const
{
  const bool readsLimit = this->ProjectToLimit || this->GenerateLimitNormals ||
    this->GenerateTangents || this->InterpolatePoints || this->InterpolateArrays;
  const int further = this->GenerateErrorBounds ? 1 : 0; // deviations next to a cell count
  return further + (this->VolumeScheme == TET_OCT && readsLimit ? 3 : 2);
}

int vtkMultiDimensionalSubdivision::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  subdivision::UniformOptions options;
  options.Levels = this->NumberOfLevels;
  options.Scheme = subdivision::GetVolumeScheme(this->VolumeScheme);
  options.KeepCellTypes = this->KeepCellTypes && this->VolumeScheme == LINEAR;
  if (this->KeepCellTypes && !options.KeepCellTypes)
  {
    subdivision::Warn(this, "KeepCellTypes needs VolumeScheme = Linear: it is ignored.");
  }
  if (options.KeepCellTypes &&
    (this->GenerateClassification || this->GenerateLimitNormals || this->GenerateTangents))
  {
    subdivision::Warn(this,
      "With KeepCellTypes there are no rules and normals: GenerateClassification, "
      "GenerateLimitNormals and GenerateTangents are ignored.");
  }
  const bool writesBezierCells = this->WritesBezierCells();
  if (this->OutputCells == BEZIER_CELLS && this->HasOutput() && !this->Places && !writesBezierCells)
  {
    subdivision::Warn(this,
      "Bezier cells need VolumeScheme = BoxSpline or Linear, no KeepCellTypes: they stay linear.");
  }
  if (writesBezierCells && this->GenerateGlobalIds)
  {
    subdivision::Warn(this, "Bezier cells have no global ids: GenerateGlobalIds is ignored.");
  }
  if (writesBezierCells && this->GenerateErrorBounds)
  {
    subdivision::Warn(this, "Bezier cells have no error bounds: GenerateErrorBounds is ignored.");
  }
  options.GenerateClassification = this->GenerateClassification;
  options.ProjectToLimit = this->ProjectToLimit || writesBezierCells;
  options.GenerateLimitNormals = this->GenerateLimitNormals && !options.KeepCellTypes;
  options.GenerateTangents = this->GenerateTangents && !options.KeepCellTypes;
  options.Use32BitIds = this->Use32BitIds;
  options.Cache = this->CacheOperator ? this->Cache.get() : nullptr;
  options.Places = this->Places;
  if (this->Places)
  {
    options.Levels = 0;
    options.ProjectToLimit = true;
    options.GenerateLimitNormals = options.GenerateTangents = false;
    options.GenerateClassification = options.KeepCellTypes = false;
    options.Cache = nullptr;
  }
  const bool addsBounds =
    this->GenerateErrorBounds && this->HasOutput() && !this->Places && !writesBezierCells;
  options.KeepsCopies = addsBounds;
  // A level reads points of cells around each cell only, linear rules those of the cell itself.
  const bool readsLimit = options.ProjectToLimit || this->GenerateLimitNormals ||
    this->GenerateTangents || this->InterpolatePoints || this->InterpolateArrays || addsBounds;
  const bool isLocal = this->VolumeScheme == LINEAR || (this->NumberOfLevels <= 1 && !readsLimit);
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
          auto* grid = vtkUnstructuredGrid::SafeDownCast(output);
          return subdivision::SubdivideUniformly(input, options, grid) &&
            (!addsBounds || subdivision::AddUniformBounds(input, options, grid));
        });
    });
}

void vtkMultiDimensionalSubdivision::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfLevels: " << this->NumberOfLevels << "\n";
  os << indent << "VolumeScheme: " << this->VolumeScheme << "\n";
  os << indent << "KeepCellTypes: " << this->KeepCellTypes << "\n";
  os << indent << "GenerateClassification: " << this->GenerateClassification << "\n";
  os << indent << "ProjectToLimit: " << this->ProjectToLimit << "\n";
  os << indent << "GenerateLimitNormals: " << this->GenerateLimitNormals << "\n";
  os << indent << "GenerateTangents: " << this->GenerateTangents << "\n";
  os << indent << "GenerateErrorBounds: " << this->GenerateErrorBounds << "\n";
  os << indent << "OutputCells: " << this->OutputCells << "\n";
  os << indent << "BezierTolerance: " << this->BezierTolerance << "\n";
  os << indent << "OutputDimensions: " << this->OutputDimensions << "\n";
  os << indent << "Use32BitIds: " << this->Use32BitIds << "\n";
  os << indent << "CacheOperator: " << this->CacheOperator << "\n";
  os << indent << "Operators kept: " << this->Cache->GetNumberOfEntries() << " ("
     << this->Cache->GetMemorySize() << " bytes)\n";
  os << indent << "NumberOfTopologyBuilds: " << this->Cache->NumberOfBuilds << "\n";
}
