// SPDX-License-Identifier: BSD-3-Clause
#include "ArraysOfAllKinds.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkLookupTable.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkVariant.h"

namespace all_kinds
{
namespace
{

constexpr vtkTypeInt64 Large = (vtkTypeInt64(1) << 53) + 1; ///< the first that no double is

vtkSmartPointer<vtkAbstractArray> MakeOfType(int type, int components, vtkIdType size)
{
  auto array = vtkSmartPointer<vtkAbstractArray>::Take(vtkAbstractArray::CreateArray(type));
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(size);
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    array->SetVariantValue(i,
      type == VTK_STRING ? vtkVariant("text " + std::to_string(i))
                         : vtkVariant(type == VTK_BIT ? int(i % 2) : int(i % 100)));
  }
  return array;
}

template <typename Value>
vtkSmartPointer<vtkDataArray> MakeApart(int components, vtkIdType size, Value first)
{
  auto array = vtkSmartPointer<vtkSOADataArrayTemplate<Value>>::New();
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(size);
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    array->SetValue(i, first + static_cast<Value>(i));
  }
  return array;
}

}

void Decorate(vtkAbstractArray* array, const std::string& name)
{
  array->SetName(name.c_str());
  array->SetComponentName(0, ("first of " + name).c_str());
  array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), ("unit of " + name).c_str());
  if (auto* data = vtkDataArray::SafeDownCast(array))
  {
    vtkNew<vtkLookupTable> colours;
    colours->SetNumberOfTableValues(7);
    data->SetLookupTable(colours);
  }
}

void AddAll(vtkDataSetAttributes* data, vtkIdType size)
{
  for (const int type :
    { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_INT,
      VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG,
      VTK_ID_TYPE, VTK_FLOAT, VTK_DOUBLE, VTK_BIT, VTK_STRING, VTK_VARIANT })
  {
    const auto array = MakeOfType(type, 2, size);
    Decorate(array, "type " + std::to_string(type));
    data->AddArray(array);
  }
  const auto apart = MakeApart<double>(2, size, 0.);
  Decorate(apart, "apart");
  data->AddArray(apart);
  const auto large = MakeApart<vtkTypeInt64>(1, size, Large);
  Decorate(large, "large");
  data->AddArray(large);
  const auto unsignedLarge = MakeOfType(VTK_UNSIGNED_LONG_LONG, 1, size);
  for (vtkIdType i = 0; i < size; ++i)
  {
    unsignedLarge->SetVariantValue(i, static_cast<unsigned long long>(-1 - i));
  }
  Decorate(unsignedLarge, "largest");
  data->AddArray(unsignedLarge);
  const std::pair<int, int> attributes[] = { { vtkDataSetAttributes::SCALARS, 1 },
    { vtkDataSetAttributes::VECTORS, 3 }, { vtkDataSetAttributes::NORMALS, 3 },
    { vtkDataSetAttributes::TCOORDS, 2 }, { vtkDataSetAttributes::TENSORS, 9 },
    { vtkDataSetAttributes::TANGENTS, 3 }, { vtkDataSetAttributes::EDGEFLAG, 1 },
    { vtkDataSetAttributes::GLOBALIDS, 1 }, { vtkDataSetAttributes::PEDIGREEIDS, 1 } };
  for (const auto& [attribute, components] : attributes)
  {
    const bool areIds = attribute == vtkDataSetAttributes::GLOBALIDS ||
      attribute == vtkDataSetAttributes::PEDIGREEIDS;
    const auto array = MakeOfType(areIds ? VTK_ID_TYPE : VTK_DOUBLE, components, size);
    for (vtkIdType i = 0; areIds && i < size; ++i)
    {
      array->SetVariantValue(i, 1000 + i);
    }
    Decorate(array, vtkDataSetAttributes::GetAttributeTypeAsString(attribute));
    data->SetActiveAttribute(data->AddArray(array), attribute);
  }
}

}
