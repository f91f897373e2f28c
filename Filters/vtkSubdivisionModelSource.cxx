// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSubdivisionModelSource.h"

#include "Private/ArrayNames.h"
#include "Private/Models/Models.h"
#include "Private/Run/FilterRun.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace
{

struct Entry
{
  const char* Name;
  const subdivision::Model& Model;
};

constexpr Entry Entries[] = {
  { "MixedDimensions", subdivision::MixedDimensions },
  { "Screw", subdivision::Screw },
  { "SpringAndValve", subdivision::SpringAndValve },
  { "Ship", subdivision::Ship },
  { "MechanicalPart", subdivision::MechanicalPart },
  { "Character", subdivision::Character },
  { "MaterialBlock", subdivision::MaterialBlock },
  { "Cylinder", subdivision::Cylinder },
};

static_assert(sizeof(Entries) / sizeof(Entry) == vtkSubdivisionModelSource::NUMBER_OF_MODELS,
  "one entry per model, in the order of the enumeration");

template <typename ArrayClass, typename Value>
vtkSmartPointer<ArrayClass> MakeArray(const char* name, const Value* values, vtkIdType count)
{
  auto array = vtkSmartPointer<ArrayClass>::New();
  array->SetName(name);
  array->SetNumberOfValues(count);
  std::copy(values, values + count, array->GetPointer(0));
  return array;
}

void MakeGrid(const subdivision::Model& model, int typeOfPoints, vtkUnstructuredGrid* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(typeOfPoints);
  points->SetNumberOfPoints(model.NumberOfPoints);
  for (vtkIdType i = 0; i < model.NumberOfPoints; ++i)
  {
    points->SetPoint(i, model.Points + 3 * i);
  }
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> types;
  vtkIdType begin = 0;
  for (vtkIdType i = 0; i < model.NumberOfCells; begin = model.Offsets[i], ++i)
  {
    cells->InsertNextCell(model.Offsets[i] - begin, model.Connectivity + begin);
    types->InsertNextValue(model.Types[i]);
  }
  output->SetPoints(points);
  output->SetCells(types, cells);
  output->GetPointData()->SetScalars(
    MakeArray<vtkDoubleArray>("Tension", model.Tension, model.NumberOfPoints));
  output->GetCellData()->AddArray(
    MakeArray<vtkIntArray>("MaterialId", model.MaterialId, model.NumberOfCells));
  output->GetCellData()->AddArray(
    MakeArray<vtkIntArray>(subdivision::SingularName, model.Singular, model.NumberOfCells));
}

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
    MakeGrid(Entries[this->Model].Model,
      this->OutputPointsPrecision == SINGLE_PRECISION ? VTK_FLOAT : VTK_DOUBLE, output);
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
