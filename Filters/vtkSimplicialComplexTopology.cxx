// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSimplicialComplexTopology.h"

#include "Private/Topology/TopologyProbe.h"

#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkSimplicialComplexTopology);

vtkSimplicialComplexTopology::vtkSimplicialComplexTopology() = default;
vtkSimplicialComplexTopology::~vtkSimplicialComplexTopology() = default;

int vtkSimplicialComplexTopology::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  subdivision::ProbeOptions options;
  options.SpecialOnly = this->SpecialOnly;
  return this->Run(inputVector, outputVector, options,
    "Counts, and results at the borders of partitions, are those of this partition alone.",
    "the simplices of the input. Use a part of the input.",
    [&options](vtkPointSet* input, vtkPointSet* output)
    {
      return subdivision::ProbeTopology(input, options, vtkUnstructuredGrid::SafeDownCast(output));
    });
}

void vtkSimplicialComplexTopology::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SpecialOnly: " << this->SpecialOnly << "\n";
}
