// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceSubdivision.h"

#include "Private/Bezier/BezierCells.h"
#include "Private/Places/PlaceOutput.h"
#include "Private/Reading/InputArrays.h"
#include "Private/Run/FilterRun.h"
#include "Private/Run/KeptEntries.h"
#include "Private/Surface/SurfaceBounds.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <string>

vtkStandardNewMacro(vtkSurfaceSubdivision);

vtkSurfaceSubdivision::vtkSurfaceSubdivision()
  : Cache(std::make_unique<subdivision::KeptEntries>())
  , Bezier(std::make_unique<subdivision::BezierRounds>())
{
}

vtkSurfaceSubdivision::~vtkSurfaceSubdivision() = default;

void vtkSurfaceSubdivision::SetCacheOperator(bool cache)
{
  if (this->CacheOperator != cache)
  {
    this->CacheOperator = cache;
    this->Cache->Clear();
    this->Modified();
  }
}

vtkIdType vtkSurfaceSubdivision::GetNumberOfTopologyBuilds() const
{
  return this->Cache->NumberOfBuilds;
}

bool vtkSurfaceSubdivision::EvaluateLimit(
  vtkIdTypeArray* cells, vtkDataArray* parameters, vtkPolyData* result)
{
  result->Initialize();
  const std::string error = subdivision::CheckPlaceArrays(cells, parameters);
  if (!error.empty())
  {
    subdivision::Fail(this, error);
    return false;
  }
  if (this->Scheme != LOOP && this->Scheme != CATMULL_CLARK)
  {
    subdivision::Fail(this, "Places have limits with Scheme = Loop or CatmullClark only.");
    return false;
  }
  if (this->InterfaceValues == DISCONTINUOUS_VALUES)
  {
    subdivision::Fail(
      this, "Places have no values that jump: switch InterfaceValues to Continuous.");
    return false;
  }
  const subdivision::PlaceRequest request{ cells, parameters, result, nullptr };
  this->Places = &request;
  this->RunAside();
  this->Places = nullptr;
  return result->GetNumberOfPoints() == cells->GetNumberOfTuples();
}

bool vtkSurfaceSubdivision::WritesBezierCells() const
{
  return this->OutputCells == BEZIER_CELLS && this->HasOutput() && !this->Places &&
    (this->Scheme == LOOP || this->Scheme == CATMULL_CLARK || this->Scheme == LINEAR);
}

void vtkSurfaceSubdivision::Inspect(vtkDataObject*, vtkDataObject* readable)
{
  if (this->WritesBezierCells())
  {
    this->Bezier->SetFurtherSteps(subdivision::CountFurtherSteps(
      this->SharesRanks() ? nullptr : readable, this->Scheme == CATMULL_CLARK));
  }
}

int vtkSurfaceSubdivision::GetLayersOfCells() const
{
  return subdivision::CountLayersOfSurface(
    static_cast<subdivision::SurfaceSchemeKind>(this->Scheme));
}

vtkSmartPointer<vtkDataObject> vtkSurfaceSubdivision::Finish(vtkDataObject* made)
{
  if (!this->WritesBezierCells())
  {
    return made;
  }
  subdivision::BezierOptions options;
  options.Tolerance = this->BezierTolerance;
  options.Use32BitIds = this->Use32BitIds;
  options.Controller = this->SharesRanks() ? this->Controller.Get() : nullptr;
  options.IsWhole = !options.Controller;
  options.MaximumNumberOfCells = this->MaximumNumberOfCells;
  options.Fail = [this](const std::string& text) { subdivision::Fail(this, text); };
  return this->Bezier->Finish(made, options);
}

int vtkSurfaceSubdivision::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  subdivision::SurfaceOptions options;
  options.Scheme = static_cast<subdivision::SurfaceSchemeKind>(this->Scheme);
  options.Levels = this->NumberOfLevels;
  const bool writesBezierCells = this->WritesBezierCells();
  if (this->OutputCells == BEZIER_CELLS && this->HasOutput() && !this->Places && !writesBezierCells)
  {
    subdivision::Warn(
      this, "Bezier cells need Scheme = Loop, CatmullClark or Linear: the cells stay linear.");
  }
  if (writesBezierCells && this->GenerateGlobalIds)
  {
    subdivision::Warn(this, "Bezier cells have no global ids: GenerateGlobalIds is ignored.");
  }
  if (writesBezierCells && this->GenerateErrorBounds)
  {
    subdivision::Warn(this, "Bezier cells have no error bounds: GenerateErrorBounds is ignored.");
  }
  options.ProjectToLimit = this->ProjectToLimit || (writesBezierCells && this->Scheme != LINEAR);
  options.GenerateLimitNormals = this->GenerateLimitNormals;
  options.GenerateTangents = this->GenerateTangents;
  options.Use32BitIds = this->Use32BitIds;
  options.JoinSeams = this->JoinSeams;
  options.KeepsMerged = this->MergePoints && this->MergedValues == KEEP_VALUES;
  options.Cache = this->CacheOperator ? this->Cache.get() : nullptr;
  const bool addsBounds =
    this->GenerateErrorBounds && this->HasOutput() && !this->Places && !writesBezierCells;
  options.Places = this->Places;
  if (this->Places)
  {
    options.ProjectToLimit = true;
    options.GenerateLimitNormals = options.GenerateTangents = false;
    options.Cache = nullptr;
  }
  // Without rules for boundaries that angles decide, a level reads points of cells around only.
  const bool isLocal =
    !this->ModifiedBoundary && (this->Scheme == LOOP || this->Scheme == CATMULL_CLARK);
  return this->Bezier->Run(writesBezierCells ? this->NumberOfLevels : -1, options,
    [&]
    {
      return this->Run(inputVector, outputVector, options, isLocal ? "" : nullptr,
        "NumberOfLevels = " + std::to_string(this->NumberOfLevels) +
          ". Use fewer levels, or a part of the input.",
        [&](vtkPointSet* input, vtkPointSet* output)
        {
          options.Levels = this->Places ? 0 : this->NumberOfLevels;
          if (writesBezierCells)
          {
            this->Bezier->SetLevels(options);
          }
          if (this->Places && this->OutputPointsPrecision == DEFAULT_PRECISION)
          {
            options.OutputPointsPrecision = DOUBLE_PRECISION;
          }
          auto* from = vtkPolyData::SafeDownCast(input);
          auto* to = vtkPolyData::SafeDownCast(output);
          vtkDataArray* flatness = nullptr;
          const bool isRead =
            subdivision::FindInputArray(this, input->GetPointData(), input->GetNumberOfPoints(),
              { FLATNESS_ARRAY, nullptr, false, true }, options.Warn, options.Fail, flatness);
          options.Flatness = flatness;
          return isRead && subdivision::SubdivideSurface(from, options, to) &&
            (!addsBounds || subdivision::AddSurfaceBounds(from, options, to));
        });
    });
}

void vtkSurfaceSubdivision::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Scheme: " << this->Scheme << "\n";
  os << indent << "NumberOfLevels: " << this->NumberOfLevels << "\n";
  os << indent << "ProjectToLimit: " << this->ProjectToLimit << "\n";
  os << indent << "GenerateLimitNormals: " << this->GenerateLimitNormals << "\n";
  os << indent << "GenerateTangents: " << this->GenerateTangents << "\n";
  os << indent << "GenerateErrorBounds: " << this->GenerateErrorBounds << "\n";
  os << indent << "OutputCells: " << this->OutputCells << "\n";
  os << indent << "BezierTolerance: " << this->BezierTolerance << "\n";
  os << indent << "JoinSeams: " << this->JoinSeams << "\n";
  os << indent << "Use32BitIds: " << this->Use32BitIds << "\n";
  os << indent << "CacheOperator: " << this->CacheOperator << "\n";
  os << indent << "Levels kept: " << this->Cache->GetMemorySize() << " bytes\n";
  os << indent << "NumberOfTopologyBuilds: " << this->Cache->NumberOfBuilds << "\n";
}
