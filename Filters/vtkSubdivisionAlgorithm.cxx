// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSubdivisionAlgorithm.h"

#include "Private/ArrayNames.h"
#include "Private/Control/FilterRun.h"
#include "Private/Reading/InputArrays.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkPointSet.h"

vtkSubdivisionAlgorithm::vtkSubdivisionAlgorithm() = default;
vtkSubdivisionAlgorithm::~vtkSubdivisionAlgorithm() = default;

int vtkSubdivisionAlgorithm::FillInputPortInformation(int, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkSubdivisionAlgorithm::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkUnstructuredGrid");
  return 1;
}

int vtkSubdivisionAlgorithm::RequestDataObject(
  vtkInformation*, vtkInformationVector**, vtkInformationVector*)
{
  return 1;
}

int vtkSubdivisionAlgorithm::Run(vtkInformationVector** inputVector,
  vtkInformationVector* outputVector, subdivision::RunOptions& options, const char* ghosts,
  const std::string& memory, const std::function<bool(vtkPointSet*, vtkPointSet*)>& run)
{
  subdivision::FilterTraits traits;
  traits.WrongInput = "The input is missing, or is of a type that this filter does not read.";
  traits.Ghosts = ghosts;
  traits.Memory = memory;
  subdivision::ReadSharedOptions(this, options);
  return subdivision::RunFilter<vtkPointSet, vtkPointSet>(this, inputVector, outputVector, traits,
    options, [&](vtkPointSet* input, vtkPointSet* output)
    { return this->ReadFeatureOptions(input, options) && run(input, output); });
}

bool vtkSubdivisionAlgorithm::ReadFeatureOptions(vtkPointSet* input, subdivision::RunOptions& run)
{
  using subdivision::JointRule;
  vtkDataArray* arrays[5];
  auto find = [&](int index, const char* fallback, bool integral)
  {
    return subdivision::FindInputArray(this, input->GetCellData(), input->GetNumberOfCells(),
      { index, fallback, integral }, run.Warn, run.Fail, arrays[index]);
  };
  if (!find(SINGULAR_ARRAY, subdivision::SingularName, true) ||
    !find(MATERIAL_ARRAY, "MaterialId", false) || !find(PART_ARRAY, nullptr, true) ||
    !find(RULE_ARRAY, nullptr, true) || !find(SHARPNESS_ARRAY, nullptr, false))
  {
    return false;
  }
  subdivision::FeatureOptions& options = run.Features;
  options.Singular = arrays[SINGULAR_ARRAY];
  options.Material = arrays[MATERIAL_ARRAY];
  options.Part = arrays[PART_ARRAY];
  options.Rules = arrays[RULE_ARRAY];
  options.Sharpness = arrays[SHARPNESS_ARRAY];
  if (this->PreserveInterfaces && !options.Material)
  {
    run.Fail("PreserveInterfaces needs a cell array of materials: set array index 1, or name the "
             "array MaterialId.");
    return false;
  }
  options.DartEnds = this->CreaseEnd == DART;
  options.Embedded = static_cast<subdivision::EmbeddedRule>(this->EmbeddedCells);
  options.PreserveInterfaces = this->PreserveInterfaces;
  options.DetectFeatures = this->DetectFeatures;
  options.FeatureAngle = this->FeatureAngle;
  options.Type1 = static_cast<JointRule>(this->Type1Rule);
  options.Type2 = this->Type2Rule == TYPE2_FOLLOW_PART ? JointRule::FollowPart
                                                       : static_cast<JointRule>(this->Type2Rule);
  options.Type3 = static_cast<JointRule>(this->Type3Rule);
  return true;
}

void vtkSubdivisionAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "InterpolateIntegers: " << this->InterpolateIntegers << "\n";
  os << indent << "GenerateOriginalIds: " << this->GenerateOriginalIds << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
  os << indent << "MaximumNumberOfCells: " << this->MaximumNumberOfCells << "\n";
  os << indent << "CreaseEnd: " << this->CreaseEnd << "\n";
  os << indent << "EmbeddedCells: " << this->EmbeddedCells << "\n";
  os << indent << "PreserveInterfaces: " << this->PreserveInterfaces << "\n";
  os << indent << "DetectFeatures: " << this->DetectFeatures << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "Type1Rule: " << this->Type1Rule << "\n";
  os << indent << "Type2Rule: " << this->Type2Rule << "\n";
  os << indent << "Type3Rule: " << this->Type3Rule << "\n";
}
