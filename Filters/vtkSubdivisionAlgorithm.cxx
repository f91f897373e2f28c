// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSubdivisionAlgorithm.h"

#include "Private/ArrayNames.h"
#include "Private/Control/RunOptions.h"
#include "Private/Reading/InputArrays.h"
#include "Private/vtkSubdivisionObjectsCompat.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointSet.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <new>

vtkSubdivisionAlgorithm::vtkSubdivisionAlgorithm() = default;
vtkSubdivisionAlgorithm::~vtkSubdivisionAlgorithm() = default;

int vtkSubdivisionAlgorithm::FillInputPortInformation(int, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkSubdivisionAlgorithm::Run(vtkInformationVector** inputVector,
  vtkInformationVector* outputVector, subdivision::RunOptions& options, const char* ghosts,
  const std::string& memory, const std::function<bool(vtkPointSet*, vtkUnstructuredGrid*)>& run)
{
  vtkPointSet* input = vtkPointSet::GetData(inputVector[0]);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
  if (!input || !output)
  {
    vtkErrorMacro("The input is missing, or is neither a vtkUnstructuredGrid nor a vtkPolyData.");
    return 0;
  }
  if (!input->GetPoints())
  {
    return 1; // without points the output is empty
  }
  vtkUnsignedCharArray* types = input->GetCellGhostArray();
  if (types &&
    std::any_of(types->GetPointer(0), types->GetPointer(0) + types->GetNumberOfTuples(),
      [](unsigned char type) { return type & vtkDataSetAttributes::DUPLICATECELL; }))
  {
    vtkWarningMacro("The input has duplicate (ghost) cells. " << ghosts);
  }
  options.InterpolateIntegers = this->InterpolateIntegers;
  options.GenerateOriginalIds = this->GenerateOriginalIds;
  options.OutputPointsPrecision = this->OutputPointsPrecision;
  options.MaximumNumberOfCells = this->MaximumNumberOfCells;
  if (!this->ReadFeatureOptions(input, options.Features))
  {
    return 0;
  }
  options.Progress = [this](double done)
  {
    this->UpdateProgress(done);
    return subdivision::IsAborted(this);
  };
  options.Warn = [this](const std::string& message) { vtkWarningMacro(<< message); };
  bool failed = false;
  options.Fail = [this, &failed](const std::string& message)
  {
    vtkErrorMacro(<< message);
    failed = true;
  };
  bool done = false;
  try
  {
    done = run(input, output);
  }
  catch (const std::bad_alloc&)
  {
    options.Fail("There is not enough memory for " + memory);
  }
  if (!done)
  {
    output->Initialize();
  }
  return failed ? 0 : 1;
}

/// Finds the cell array at an index; null where it is unset and `fallback` is not there. Returns
/// false, after an error message, if it cannot be used.
bool vtkSubdivisionAlgorithm::FindCellArray(
  vtkPointSet* input, int index, const char* fallback, bool integral, vtkDataArray*& array)
{
  return subdivision::FindInputArray(
    this, input->GetCellData(), input->GetNumberOfCells(), { index, fallback, integral },
    [this](const std::string& message) { vtkWarningMacro(<< message); },
    [this](const std::string& message) { vtkErrorMacro(<< message); }, array);
}

bool vtkSubdivisionAlgorithm::ReadFeatureOptions(
  vtkPointSet* input, subdivision::FeatureOptions& options)
{
  using subdivision::JointRule;
  vtkDataArray* arrays[5];
  if (!this->FindCellArray(
        input, SINGULAR_ARRAY, subdivision::SingularName, true, arrays[SINGULAR_ARRAY]) ||
    !this->FindCellArray(input, MATERIAL_ARRAY, "MaterialId", false, arrays[MATERIAL_ARRAY]) ||
    !this->FindCellArray(input, PART_ARRAY, nullptr, true, arrays[PART_ARRAY]) ||
    !this->FindCellArray(input, RULE_ARRAY, nullptr, true, arrays[RULE_ARRAY]) ||
    !this->FindCellArray(input, SHARPNESS_ARRAY, nullptr, false, arrays[SHARPNESS_ARRAY]))
  {
    return false;
  }
  options.Singular = arrays[SINGULAR_ARRAY];
  options.Material = arrays[MATERIAL_ARRAY];
  options.Part = arrays[PART_ARRAY];
  options.Rules = arrays[RULE_ARRAY];
  options.Sharpness = arrays[SHARPNESS_ARRAY];
  if (this->PreserveInterfaces && !options.Material)
  {
    vtkErrorMacro("PreserveInterfaces needs a cell array of materials: set array index 1, or name "
                  "the array MaterialId.");
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
