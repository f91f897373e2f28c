// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSubdivisionModelSource.h"

#include "Private/Models/Models.h"

#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

namespace
{

struct Entry
{
  const char* Name;
  void (*Build)(subdivision::ModelBuilder&);
};

constexpr Entry Entries[] = {
  { "MixedDimensions", subdivision::BuildMixedDimensions },
  { "Screw", subdivision::BuildScrew },
  { "SpringAndValve", subdivision::BuildSpringAndValve },
  { "Ship", subdivision::BuildShip },
  { "MechanicalPart", subdivision::BuildMechanicalPart },
  { "Character", subdivision::BuildCharacter },
  { "MaterialBlock", subdivision::BuildMaterialBlock },
  { "Cylinder", subdivision::BuildCylinder },
};

static_assert(sizeof(Entries) / sizeof(Entry) == vtkSubdivisionModelSource::NUMBER_OF_MODELS,
  "one entry per model, in the order of the enumeration");

}

vtkStandardNewMacro(vtkSubdivisionModelSource);

vtkSubdivisionModelSource::vtkSubdivisionModelSource()
{
  this->SetNumberOfInputPorts(0);
}

const char* vtkSubdivisionModelSource::GetModelName(int model)
{
  return model >= 0 && model < NUMBER_OF_MODELS ? Entries[model].Name : nullptr;
}

int vtkSubdivisionModelSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  subdivision::ModelBuilder builder;
  Entries[this->Model].Build(builder);
  builder.OrientTriangles();
  builder.Write(vtkUnstructuredGrid::GetData(outputVector),
    this->OutputPointsPrecision == SINGLE_PRECISION ? VTK_FLOAT : VTK_DOUBLE);
  return 1;
}

void vtkSubdivisionModelSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Model: " << this->GetModelAsString() << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}
