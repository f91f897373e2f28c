// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSubdivisionAlgorithm.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"

vtkSubdivisionAlgorithm::vtkSubdivisionAlgorithm() = default;
vtkSubdivisionAlgorithm::~vtkSubdivisionAlgorithm() = default;

int vtkSubdivisionAlgorithm::FillInputPortInformation(int, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

void vtkSubdivisionAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "InterpolateIntegers: " << this->InterpolateIntegers << "\n";
  os << indent << "GenerateOriginalIds: " << this->GenerateOriginalIds << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
  os << indent << "MaximumNumberOfCells: " << this->MaximumNumberOfCells << "\n";
}
