// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExtractDimensions.h"

#include "Private/Distribution/Dimensions.h"
#include "Private/Run/FilterRun.h"
#include "Private/Run/Ports.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
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
  return subdivision::TakeTypes(
    info, { "vtkUnstructuredGrid", "vtkPolyData", "vtkDataObjectTree" });
}

int vtkExtractDimensions::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  subdivision::FilterTraits traits;
  traits.Memory = "the cells of these dimensions. Take a part of the input.";
  subdivision::RunOptions options;
  bool failed = false;
  subdivision::ConnectToFilter(this, options, failed);
  const auto take = [&]
  {
    auto* ranks = vtkMultiProcessController::GetGlobalController();
    const bool isWhole = !ranks || ranks->GetNumberOfProcesses() == 1;
    const auto part = subdivision::TakeDimensions(
      vtkDataObject::GetData(inputVector[0]), this->OutputDimensions, isWhole, options.Warn);
    if (options.Progress(0.9))
    {
      return false;
    }
    if (part)
    {
      output->ShallowCopy(part);
    }
    return true;
  };
  if (!subdivision::DoWork(traits, options, take))
  {
    output->Initialize();
  }
  return failed ? 0 : 1;
}

void vtkExtractDimensions::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OutputDimensions: " << this->OutputDimensions << "\n";
}
