// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeasureTools.h
 * Tables of vtkSubdivisionMeasures, and their numbers.
 */
#ifndef SubdivisionObjects_MeasureTools_h
#define SubdivisionObjects_MeasureTools_h

#include "FeatureTools.h"

#include "vtkSubdivisionMeasures.h"
#include "vtkTable.h"

namespace measure_tools
{

using namespace feature_tools;

using Table = vtkSmartPointer<vtkTable>;

inline Table Measure(
  vtkSubdivisionMeasures* filter, vtkDataObject* input, const std::vector<const char*>& but = {})
{
  UpdateInSilence(filter, input, nullptr, but);
  const auto table = Table::New();
  table->DeepCopy(filter->GetOutput());
  return table;
}

inline double Get(vtkTable* table, const std::string& name, vtkIdType row = 0, int component = 0)
{
  auto* const column = vtkDataArray::SafeDownCast(table->GetColumnByName(name.c_str()));
  EXPECT_TRUE(column) << name;
  return column ? column->GetComponent(row, component) : 0.;
}

/// The row of a dimension and material, or of all materials; -1 if there is none.
inline vtkIdType FindRow(vtkTable* table, int dimension, int material = -1)
{
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    const bool ofAll =
      !table->GetColumnByName("AllMaterials") || Get(table, "AllMaterials", row) == 1.;
    if (Get(table, "Dimension", row) == dimension && ofAll == (material < 0) &&
      (material < 0 || Get(table, "Material", row) == material))
    {
      return row;
    }
  }
  return -1;
}

inline void SetDensity(vtkSubdivisionMeasures* filter, const char* name)
{
  filter->SetInputArrayToProcess(11, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name);
}

/// Adds a point array of a function of the points.
inline void AddField(
  vtkPointSet* mesh, const char* name, const std::function<double(const Point&)>& function)
{
  vtkNew<vtkDoubleArray> values;
  values->SetName(name);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(function(GetPoint(mesh, i)));
  }
  mesh->GetPointData()->AddArray(values);
}

/// The first difference between two tables; empty if there is none, bit for bit.
inline std::string CompareTables(vtkTable* a, vtkTable* b)
{
  return CompareArrays(a->GetRowData(), b->GetRowData(), "rows");
}

}

#endif
