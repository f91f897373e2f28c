// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSimplicialComplexTopology.h"

#include "Private/TopologyProbe.h"
#include "Private/vtkSubdivisionObjectsCompat.h"

#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <new>

vtkStandardNewMacro(vtkSimplicialComplexTopology);

vtkSimplicialComplexTopology::vtkSimplicialComplexTopology() = default;
vtkSimplicialComplexTopology::~vtkSimplicialComplexTopology() = default;

int vtkSimplicialComplexTopology::RequestData(
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
    vtkWarningMacro("The input has duplicate (ghost) cells. Counts, and results at the borders of "
                    "partitions, are those of this partition alone.");
  }
  subdivision::ProbeOptions options;
  options.SpecialOnly = this->SpecialOnly;
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
    done = subdivision::ProbeTopology(input, options, output);
  }
  catch (const std::bad_alloc&)
  {
    options.Fail("There is not enough memory for the simplices of " +
      std::to_string(input->GetNumberOfCells()) + " cells. Use a part of the input.");
  }
  if (!done)
  {
    output->Initialize();
  }
  return failed ? 0 : 1;
}

void vtkSimplicialComplexTopology::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SpecialOnly: " << this->SpecialOnly << "\n";
}
