// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceSubdivision.h"

#include "Private/AdaptiveSurface/AdaptiveSurface.h"
#include "Private/ArrayNames.h"
#include "Private/Control/FilterRun.h"
#include "Private/Criteria/RefinementInput.h"
#include "Private/Reading/InputArrays.h"
#include "Private/Surface/SurfaceSubdivision.h"

#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <string>

vtkStandardNewMacro(vtkSurfaceSubdivision);

vtkSurfaceSubdivision::vtkSurfaceSubdivision()
  : Cache(std::make_unique<subdivision::SurfaceCache>())
{
  this->AddObserver(vtkCommand::StartEvent, this, &vtkSurfaceSubdivision::OnStart);
  this->AddObserver(vtkCommand::EndEvent, this, &vtkSurfaceSubdivision::OnEnd);
}

vtkSurfaceSubdivision::~vtkSurfaceSubdivision() = default;

void vtkSurfaceSubdivision::OnEnd()
{
  if (--this->UpdateDepth == 0)
  {
    this->Cache->ForgetUnused();
  }
}

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

bool vtkSurfaceSubdivision::ReadArrays(vtkPolyData* input, subdivision::SurfaceOptions& options)
{
  auto find = [&](const subdivision::ArrayRequest& request, auto& result)
  {
    vtkDataArray* array = nullptr;
    vtkDataSetAttributes* data = input->GetCellData();
    vtkIdType size = input->GetNumberOfCells();
    if (request.OfPoints)
    {
      data = input->GetPointData();
      size = input->GetNumberOfPoints();
    }
    const bool usable =
      subdivision::FindInputArray(this, data, size, request, options.Warn, options.Fail, array);
    result = array;
    return usable;
  };
  return find({ 0, subdivision::SingularName, true }, options.Features.Singular) &&
    find({ 4, nullptr, false }, options.Features.Sharpness) &&
    find({ 5, nullptr, false, true }, options.Angles) &&
    find({ 6, nullptr, false, true }, options.Flatness);
}

void vtkSurfaceSubdivision::ReadOptions(subdivision::SurfaceOptions& options)
{
  using subdivision::JointRule;
  auto rule = [](int value) { return value == SHARP ? JointRule::Sharp : JointRule::Blend; };
  options.Scheme = static_cast<subdivision::SurfaceSchemeKind>(this->Scheme);
  options.Levels = this->NumberOfLevels;
  options.ModifiedBoundary = this->ModifiedBoundary;
  options.ProjectToLimit = this->ProjectToLimit;
  options.GenerateLimitNormals = this->GenerateLimitNormals;
  options.GenerateTangents = this->GenerateTangents;
  options.Use32BitIds = this->Use32BitIds;
  options.JoinSeams = this->JoinSeams;
  subdivision::ReadSharedOptions(this, options);
  options.Features.DartEnds = this->CreaseEnd == DART;
  options.Features.DetectFeatures = this->DetectFeatures;
  options.Features.FeatureAngle = this->FeatureAngle;
  options.Features.Type1 = rule(this->Type1Rule);
  options.Features.Type2 = rule(this->Type2Rule);
  options.Features.Type3 = rule(this->Type3Rule);
  options.Cache = this->CacheOperator ? this->Cache.get() : nullptr;
}

bool vtkSurfaceSubdivision::Execute(
  vtkPolyData* input, const subdivision::SurfaceOptions& options, vtkPolyData* output)
{
  if (!this->Adaptive || this->Scheme != SQRT_THREE)
  {
    if (this->Adaptive)
    {
      options.Warn("Adaptive is for the scheme SqrtThree only: the filter applies this scheme "
                   "everywhere, NumberOfLevels times. For adaptive Loop subdivision use "
                   "vtkRedGreenRefinement with its Placement Limit.");
    }
    return subdivision::SubdivideSurface(input, options, output);
  }
  const subdivision::RefinementSettings settings =
    subdivision::GetRefinementSettings(this, ATTRIBUTE_ARRAY, false);
  subdivision::RefinementOptions criteria;
  return subdivision::ReadRefinementOptions(
           this, input, settings, options.Warn, options.Fail, criteria) &&
    subdivision::RefineSurface(input, options, criteria, output);
}

int vtkSurfaceSubdivision::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  subdivision::SurfaceOptions options;
  this->ReadOptions(options);
  subdivision::FilterTraits traits;
  traits.WrongInput = "The input is missing, or is no vtkPolyData.";
  traits.Memory = this->Adaptive && this->Scheme == SQRT_THREE
    ? "this refinement. Lower MaximumNumberOfCells or MaximumLevel, raise the tolerances, or use a "
      "part of the input."
    : "NumberOfLevels = " + std::to_string(this->NumberOfLevels) +
      ". Use fewer levels, or a part of the input.";
  return subdivision::RunFilter<vtkPolyData, vtkPolyData>(this, inputVector, outputVector, traits,
    options, [&](vtkPolyData* input, vtkPolyData* output)
    { return this->ReadArrays(input, options) && this->Execute(input, options, output); });
}

void vtkSurfaceSubdivision::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Scheme: " << this->Scheme << "\n";
  os << indent << "NumberOfLevels: " << this->NumberOfLevels << "\n";
  os << indent << "Adaptive: " << this->Adaptive << "\n";
  os << indent << "MaximumLevel: " << this->MaximumLevel << "\n";
  os << indent << "RefineByAttributeError: " << this->RefineByAttributeError << "\n";
  os << indent << "AttributeTolerance: " << this->AttributeTolerance << "\n";
  os << indent << "AttributeErrorKind: " << this->AttributeErrorKind << "\n";
  os << indent << "RefineByArrayRange: " << this->RefineByArrayRange << "\n";
  os << indent << "ArrayRange: " << this->ArrayRange[0] << " " << this->ArrayRange[1] << "\n";
  os << indent << "RefineByEdgeLength: " << this->RefineByEdgeLength << "\n";
  os << indent << "MaximumEdgeLength: " << this->MaximumEdgeLength << "\n";
  os << indent << "RefineByGeometricError: " << this->RefineByGeometricError << "\n";
  os << indent << "GeometricTolerance: " << this->GeometricTolerance << "\n";
  os << indent << "RelativeTolerance: " << this->RelativeTolerance << "\n";
  os << indent << "RefineByCurvature: " << this->RefineByCurvature << "\n";
  os << indent << "MaximumAngle: " << this->MaximumAngle << "\n";
  os << indent << "RefineByWantedLevel: " << this->RefineByWantedLevel << "\n";
  os << indent << "ModifiedBoundary: " << this->ModifiedBoundary << "\n";
  os << indent << "ProjectToLimit: " << this->ProjectToLimit << "\n";
  os << indent << "GenerateLimitNormals: " << this->GenerateLimitNormals << "\n";
  os << indent << "GenerateTangents: " << this->GenerateTangents << "\n";
  os << indent << "JoinSeams: " << this->JoinSeams << "\n";
  os << indent << "CreaseEnd: " << this->CreaseEnd << "\n";
  os << indent << "DetectFeatures: " << this->DetectFeatures << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "Type1Rule: " << this->Type1Rule << "\n";
  os << indent << "Type2Rule: " << this->Type2Rule << "\n";
  os << indent << "Type3Rule: " << this->Type3Rule << "\n";
  os << indent << "InterpolateIntegers: " << this->InterpolateIntegers << "\n";
  os << indent << "GenerateOriginalIds: " << this->GenerateOriginalIds << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
  os << indent << "MaximumNumberOfCells: " << this->MaximumNumberOfCells << "\n";
  os << indent << "Use32BitIds: " << this->Use32BitIds << "\n";
  os << indent << "CacheOperator: " << this->CacheOperator << "\n";
  os << indent << "Levels kept: " << this->Cache->GetMemorySize() << " bytes\n";
  os << indent << "NumberOfTopologyBuilds: " << this->Cache->NumberOfBuilds << "\n";
}
