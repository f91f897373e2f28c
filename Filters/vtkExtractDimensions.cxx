// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExtractDimensions.h"

#include "Private/Distribution/Dimensions.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkExtractDimensions);

vtkExtractDimensions::vtkExtractDimensions() = default;
vtkExtractDimensions::~vtkExtractDimensions() = default;

void vtkExtractDimensions::AddOutputDimension(int dimension)
{
  if (dimension >= 0 && dimension <= 3)
  {
    this->SetOutputDimensions(this->OutputDimensions | 1 << dimension);
  }
}

int vtkExtractDimensions::FillInputPortInformation(int, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  for (const char* type : { "vtkUnstructuredGrid", "vtkPolyData", "vtkDataObjectTree" })
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), type);
  }
  return 1;
}

int vtkExtractDimensions::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto part =
    subdivision::TakeDimensions(vtkDataObject::GetData(inputVector[0]), this->OutputDimensions);
  if (part)
  {
    vtkDataObject::GetData(outputVector)->ShallowCopy(part);
  }
  return 1;
}

void vtkExtractDimensions::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OutputDimensions: " << this->OutputDimensions << "\n";
}
