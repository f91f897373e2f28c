// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRedGreenRefinement.h"

#include "Private/RedGreen/RedGreenRefinement.h"
#include "Private/Run/FilterRun.h"

#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkRedGreenRefinement);

vtkRedGreenRefinement::vtkRedGreenRefinement() = default;
vtkRedGreenRefinement::~vtkRedGreenRefinement() = default;

int vtkRedGreenRefinement::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  subdivision::RedGreenOptions options;
  options.LimitPlacement = this->Placement == LIMIT;
  options.Scheme = subdivision::GetVolumeScheme(this->VolumeScheme);
  options.GenerateLimitNormals = this->GenerateLimitNormals && options.LimitPlacement;
  if (this->GenerateLimitNormals && !options.LimitPlacement)
  {
    subdivision::Warn(this,
      "GenerateLimitNormals makes no normals with Placement = Linear: set Placement to Limit.");
  }
  return this->RunRounds(inputVector, outputVector, options, options.Criteria,
    [&options](vtkPointSet* input, vtkPointSet* output)
    {
      return subdivision::RefineRedGreen(input, options, vtkUnstructuredGrid::SafeDownCast(output));
    });
}

void vtkRedGreenRefinement::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Placement: " << this->Placement << "\n";
  os << indent << "VolumeScheme: " << this->VolumeScheme << "\n";
  os << indent << "GenerateLimitNormals: " << this->GenerateLimitNormals << "\n";
}
