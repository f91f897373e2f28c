// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMultiDimensionalSubdivision.h"

#include "Private/UniformSubdivision.h"
#include "Private/vtkSubdivisionObjectsCompat.h"

#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <new>

vtkStandardNewMacro(vtkMultiDimensionalSubdivision);

vtkMultiDimensionalSubdivision::vtkMultiDimensionalSubdivision() = default;
vtkMultiDimensionalSubdivision::~vtkMultiDimensionalSubdivision() = default;

int vtkMultiDimensionalSubdivision::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
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
    return 1; // nothing at all: so is the output
  }
  vtkUnsignedCharArray* ghosts = input->GetCellGhostArray();
  if (ghosts &&
    std::any_of(ghosts->GetPointer(0), ghosts->GetPointer(0) + ghosts->GetNumberOfTuples(),
      [](unsigned char type) { return type & vtkDataSetAttributes::DUPLICATECELL; }))
  {
    vtkWarningMacro("The input has duplicate (ghost) cells. Results at the borders of partitions "
                    "are not yet exactly those of the whole mesh.");
  }
  subdivision::UniformOptions options;
  options.Levels = this->NumberOfLevels;
  options.InterpolateIntegers = this->InterpolateIntegers;
  options.GenerateOriginalIds = this->GenerateOriginalIds;
  options.GenerateClassification = this->GenerateClassification;
  options.OutputPointsPrecision = this->OutputPointsPrecision;
  options.MaximumNumberOfCells = this->MaximumNumberOfCells;
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
    done = subdivision::SubdivideUniformly(input, options, output);
  }
  catch (const std::bad_alloc&)
  {
    options.Fail("There is not enough memory for NumberOfLevels = " +
      std::to_string(this->NumberOfLevels) + ". Use fewer levels, or a part of the input.");
  }
  if (!done)
  {
    output->Initialize();
  }
  return failed ? 0 : 1;
}

void vtkMultiDimensionalSubdivision::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfLevels: " << this->NumberOfLevels << "\n";
  os << indent << "GenerateClassification: " << this->GenerateClassification << "\n";
}
