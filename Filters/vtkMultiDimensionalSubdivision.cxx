// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMultiDimensionalSubdivision.h"

#include "Private/Distribution/Dimensions.h"
#include "Private/Run/FilterRun.h"
#include "Private/Uniform/UniformBounds.h"
#include "Private/Uniform/UniformSubdivision.h"

#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkMultiDimensionalSubdivision);

vtkMultiDimensionalSubdivision::vtkMultiDimensionalSubdivision() = default;
vtkMultiDimensionalSubdivision::~vtkMultiDimensionalSubdivision() = default;

void vtkMultiDimensionalSubdivision::AddOutputDimension(int dimension)
{
  if (dimension >= 0 && dimension <= 3)
  {
    this->SetOutputDimensions(this->OutputDimensions | 1 << dimension);
  }
}

const char* vtkMultiDimensionalSubdivision::DescribeBezierNeeds() const
{
  return this->KeepCellTypes || this->VolumeScheme == TET_OCT
    ? "Bezier cells need VolumeScheme = BoxSpline or Linear, no KeepCellTypes: they stay linear."
    : nullptr;
}

vtkSmartPointer<vtkDataObject> vtkMultiDimensionalSubdivision::Finish(vtkDataObject* made)
{
  const auto part = subdivision::TakeDimensions(made, this->OutputDimensions, !this->SharesRanks(),
    [this](const std::string& text) { subdivision::Warn(this, text); });
  return this->MakeBezierCells(part, part == made);
}

bool vtkMultiDimensionalSubdivision::ComputeOperator(vtkSubdivisionOperator* result)
{
  if (this->KeepCellTypes)
  {
    subdivision::Fail(this, "With KeepCellTypes there is no operator to hand out: switch it off.");
    return false;
  }
  return this->Superclass::ComputeOperator(result);
}

bool vtkMultiDimensionalSubdivision::EvaluateLimit(
  vtkIdTypeArray* cells, vtkDataArray* parameters, vtkPolyData* result)
{
  return this->FindLimit(cells, parameters, result);
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
  options.Scheme = subdivision::GetVolumeScheme(this->VolumeScheme);
  const bool keepsTypes = this->KeepCellTypes && this->VolumeScheme == LINEAR;
  if (this->KeepCellTypes && !keepsTypes)
  {
    subdivision::Warn(this, "KeepCellTypes needs VolumeScheme = Linear: it is ignored.");
  }
  if (keepsTypes &&
    (this->GenerateClassification || this->GenerateLimitNormals || this->GenerateTangents))
  {
    subdivision::Warn(this,
      "With KeepCellTypes there are no rules and normals: GenerateClassification, "
      "GenerateLimitNormals and GenerateTangents are ignored.");
  }
  this->ReadLevelOptions(options);
  options.KeepCellTypes = keepsTypes && !this->Places;
  options.GenerateClassification = this->GenerateClassification && !this->Places;
  if (options.KeepCellTypes)
  {
    options.GenerateLimitNormals = options.GenerateTangents = false;
  }
  const bool addsBounds = this->AddsBounds();
  options.KeepsCopies = addsBounds;
  // A level reads points of cells around each cell only, linear rules only points of the cell
  // itself.
  const bool readsLimit = options.ProjectToLimit || this->GenerateLimitNormals ||
    this->GenerateTangents || this->InterpolatePoints || this->InterpolateArrays || addsBounds;
  const bool isLocal = this->VolumeScheme == LINEAR || (this->NumberOfLevels <= 1 && !readsLimit);
  const auto act = [&options](const auto& work)
  {
    return [&options, work](vtkPointSet* input, vtkPointSet* output)
    { return work(input, options, vtkUnstructuredGrid::SafeDownCast(output)); };
  };
  return this->RunLevels(inputVector, outputVector, options, isLocal,
    act(&subdivision::SubdivideUniformly), act(&subdivision::AddUniformBounds));
}

void vtkMultiDimensionalSubdivision::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "VolumeScheme: " << this->VolumeScheme << "\n";
  os << indent << "KeepCellTypes: " << this->KeepCellTypes << "\n";
  os << indent << "GenerateClassification: " << this->GenerateClassification << "\n";
  os << indent << "OutputDimensions: " << this->OutputDimensions << "\n";
}
