// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MeasureTable.cxx
 * The table of measures, and the arrays of their derivatives.
 */
#include "Private/Measures/Measures.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace subdivision
{

namespace
{

using Columns = std::vector<vtkSmartPointer<vtkDataArray>>; // a table takes whole ones only

template <typename Array>
vtkSmartPointer<Array> AddColumn(const std::string& name, int components, Columns& columns)
{
  const auto column = vtkSmartPointer<Array>::New();
  column->SetName(name.c_str());
  column->SetNumberOfComponents(components);
  columns.push_back(column);
  return column;
}

/// Adds a column of numbers and one of their remainders. `read` gives the estimate of a row and
/// component.
void AddEstimates(const std::string& name, std::vector<std::string> components, std::size_t rows,
  const std::function<const Estimate&(std::size_t, int)>& read, Columns& columns)
{
  const auto size = static_cast<int>(components.size());
  for (const bool ofRemainders : { false, true })
  {
    const auto column =
      AddColumn<vtkDoubleArray>(name + (ofRemainders ? "Remainder" : ""), size, columns);
    column->SetNumberOfTuples(static_cast<vtkIdType>(rows));
    for (int c = 0; c < size; ++c)
    {
      if (size > 1 && !components[c].empty())
      {
        column->SetComponentName(c, components[c].c_str());
      }
      for (std::size_t row = 0; row < rows; ++row)
      {
        const Estimate& estimate = read(row, c);
        column->SetComponent(
          static_cast<vtkIdType>(row), c, ofRemainders ? estimate.Remainder : estimate.Value);
      }
    }
  }
}

}

void MeasuredLevels::Write(vtkTable* table) const
{
  Columns columns;
  const auto dimensions = AddColumn<vtkIntArray>("Dimension", 1, columns);
  vtkSmartPointer<vtkDoubleArray> materials;
  vtkSmartPointer<vtkUnsignedCharArray> wholes;
  if (this->HasMaterial)
  {
    wholes = AddColumn<vtkUnsignedCharArray>("AllMaterials", 1, columns);
    materials = AddColumn<vtkDoubleArray>("Material", 1, columns);
  }
  std::vector<std::vector<Estimate>> rows;
  const auto addRow = [&](const Key& key, bool ofAllMaterials)
  {
    rows.push_back(this->FindLimits(key, ofAllMaterials));
    dimensions->InsertNextValue(key.first);
    if (this->HasMaterial)
    {
      wholes->InsertNextValue(ofAllMaterials ? 1 : 0);
      materials->InsertNextValue(ofAllMaterials ? 0. : key.second);
    }
  };
  int dimension = -1;
  for (const auto& [key, row] : this->Levels.back())
  {
    if (key.first != dimension)
    {
      addRow(key, true);
      dimension = key.first;
    }
    if (this->HasMaterial)
    {
      addRow(key, false);
    }
  }
  const auto add = [&](const std::string& name, std::vector<std::string> components,
                     std::size_t first, int step = 1)
  {
    AddEstimates(
      name, std::move(components), rows.size(),
      [&rows, first, step](std::size_t row, int c) -> const Estimate&
      { return rows[row][first + static_cast<std::size_t>(c) * step]; }, columns);
  };
  add("Measure", { "" }, MeasureMoment);
  if (this->HasDensity)
  {
    add("Mass", { "" }, MassMoment);
  }
  add("Centroid", { "X", "Y", "Z" }, FirstMoments);
  add("Inertia", { "XX", "YY", "ZZ", "XY", "YZ", "XZ" }, SecondMoments);
  const auto components = static_cast<std::size_t>(this->Components);
  std::size_t first = 0;
  for (const Array& array : this->Arrays)
  {
    const std::size_t means = IntegralMoments + components;
    const std::size_t extremes = means + components;
    const std::vector<std::string> names(array.Components);
    add(array.Name + "Integral", names, IntegralMoments + first);
    add(array.Name + "Mean", names, means + first);
    add(array.Name + "Minimum", names, extremes + 2 * first, 2);
    add(array.Name + "Maximum", names, extremes + 2 * first + 1, 2);
    first += array.Components;
  }
  table->Initialize();
  for (const auto& column : columns)
  {
    table->AddColumn(column);
  }
  const auto level = vtkSmartPointer<vtkIntArray>::New();
  level->SetName("MeasuredLevels");
  level->InsertNextValue(this->GetNumberOfLevels() - 1);
  table->GetFieldData()->AddArray(level);
}

void MeasuredLevels::WriteGradients(const MeasureGradients& gradients, vtkPointData* data) const
{
  int first = 0;
  const auto add = [&](const std::string& name, int components)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name.c_str());
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(gradients.Sum->GetNumberOfTuples());
    for (int c = 0; c < components; ++c)
    {
      array->CopyComponent(c, gradients.Sum, first + c);
    }
    data->AddArray(array);
    first += components;
  };
  add("MeasureByPoints", 3);
  if (this->HasDensity)
  {
    add("MassByPoints", 3);
    add("MassByDensity", 1);
  }
  for (const Array& array : this->Arrays)
  {
    add(array.Name + "IntegralByPoints", 3 * array.Components);
    add(array.Name + "IntegralByValues", 1);
    if (this->HasDensity)
    {
      add(array.Name + "IntegralByDensity", array.Components);
    }
  }
}

}
