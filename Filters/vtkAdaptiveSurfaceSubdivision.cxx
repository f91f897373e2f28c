// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveSurfaceSubdivision.h"

#include "Private/AdaptiveSurface/AdaptiveSurface.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkAdaptiveSurfaceSubdivision);

vtkAdaptiveSurfaceSubdivision::vtkAdaptiveSurfaceSubdivision()
{
  this->SetRefineByAttributeError(false);
  this->SetRefineByGeometricError(true);
}
vtkAdaptiveSurfaceSubdivision::~vtkAdaptiveSurfaceSubdivision() = default;

int vtkAdaptiveSurfaceSubdivision::GetLayersOfCells() const
{
  return subdivision::LayersOfAdaptiveSurface;
}

int vtkAdaptiveSurfaceSubdivision::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  subdivision::SurfaceOptions options;
  options.Scheme = subdivision::SurfaceSchemeKind::SqrtThree;
  options.GenerateLimitNormals = this->GenerateLimitNormals;
  options.GenerateTangents = this->GenerateTangents;
  options.Use32BitIds = this->Use32BitIds;
  subdivision::RefinementOptions criteria;
  return this->RunRounds(inputVector, outputVector, options, criteria,
    [&](vtkPointSet* input, vtkPointSet* output)
    {
      return subdivision::RefineSurface(
        vtkPolyData::SafeDownCast(input), options, criteria, vtkPolyData::SafeDownCast(output));
    });
}

void vtkAdaptiveSurfaceSubdivision::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "GenerateLimitNormals: " << this->GenerateLimitNormals << "\n";
  os << indent << "GenerateTangents: " << this->GenerateTangents << "\n";
  os << indent << "Use32BitIds: " << this->Use32BitIds << "\n";
}
