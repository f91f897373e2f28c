// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMultiDimensionalSubdivision.h"

#include "Private/UniformSubdivision.h"
#include "Private/vtkSubdivisionObjectsCompat.h"

#include "vtkCellData.h"
#include "vtkCommand.h"
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

vtkMultiDimensionalSubdivision::vtkMultiDimensionalSubdivision()
  : Cache(std::make_unique<subdivision::OperatorCache>())
{
  this->AddObserver(vtkCommand::StartEvent, this, &vtkMultiDimensionalSubdivision::OnStart);
  this->AddObserver(vtkCommand::EndEvent, this, &vtkMultiDimensionalSubdivision::OnEnd);
}

vtkMultiDimensionalSubdivision::~vtkMultiDimensionalSubdivision() = default;

void vtkMultiDimensionalSubdivision::OnEnd()
{
  if (--this->UpdateDepth == 0)
  {
    this->Cache->ForgetUnused();
  }
}

void vtkMultiDimensionalSubdivision::SetCacheOperator(bool cache)
{
  if (this->CacheOperator != cache)
  {
    this->CacheOperator = cache;
    this->Cache->Clear();
    this->Modified();
  }
}

vtkIdType vtkMultiDimensionalSubdivision::GetNumberOfTopologyBuilds() const
{
  return this->Cache->NumberOfBuilds;
}

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
  options.Use32BitIds = this->Use32BitIds;
  options.Cache = this->CacheOperator ? this->Cache.get() : nullptr;
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
  os << indent << "Use32BitIds: " << this->Use32BitIds << "\n";
  os << indent << "CacheOperator: " << this->CacheOperator << "\n";
  os << indent << "Operators kept: " << this->Cache->GetNumberOfOperators() << " ("
     << this->Cache->GetMemorySize() << " bytes)\n";
  os << indent << "NumberOfTopologyBuilds: " << this->Cache->NumberOfBuilds << "\n";
}
