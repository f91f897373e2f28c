// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSubdivisionModelSource.h"

#include "Private/Control/FilterRun.h"
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
  auto* output = vtkUnstructuredGrid::GetData(outputVector);
  subdivision::FilterTraits traits;
  traits.Memory = "the model.";
  subdivision::RunOptions options;
  bool failed = false;
  subdivision::ConnectToFilter(this, options, failed);
  const auto make = [&]
  {
    subdivision::ModelBuilder builder;
    Entries[this->Model].Build(builder);
    builder.OrientTriangles();
    builder.Write(output, this->OutputPointsPrecision == SINGLE_PRECISION ? VTK_FLOAT : VTK_DOUBLE);
    return true;
  };
  if (!subdivision::DoWork(traits, options, make))
  {
    output->Initialize();
  }
  return failed ? 0 : 1;
}

void vtkSubdivisionModelSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Model: " << this->GetModelAsString() << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}
