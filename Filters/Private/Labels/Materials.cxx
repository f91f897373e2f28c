// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Labels/Materials.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkSmartPointer.h"

#include <cmath>
#include <map>
#include <string>

namespace subdivision
{
namespace
{

vtkDataArray* FindLabelColumn(vtkFieldData* table, const std::string& name)
{
  vtkDataArray* column = table->GetArray(name.c_str());
  return column ? column : table->GetArray("Label");
}

}

bool IsMaterialTable(vtkFieldData* table, const std::string& name)
{
  return FindLabelColumn(table, name) != nullptr;
}

std::string AddMaterials(vtkFieldData* table, const std::string& name,
  const std::vector<double>& labels, const std::vector<int>& cellLabels,
  vtkDataSetAttributes* cells, vtkFieldData* fields)
{
  vtkDataArray* column = FindLabelColumn(table, name);
  std::map<double, vtkIdType> rows;
  // The arrays of field data may have different sizes: those of another are no columns.
  const vtkIdType size = column ? column->GetNumberOfTuples() : table->GetNumberOfTuples();
  for (vtkIdType row = 0; row < size; ++row)
  {
    const double label = column ? column->GetComponent(row, 0) : static_cast<double>(row);
    if (!std::isnan(label))
    {
      rows.emplace(label, row);
    }
  }
  std::vector<vtkIdType> rowOfIndex(labels.size() + 1, -1);
  std::string without;
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    const auto found = rows.find(labels[i]);
    if (found != rows.end())
    {
      rowOfIndex[i + 1] = found->second;
    }
    else if (without.empty())
    {
      without = "The table of materials has no row for label " +
        std::to_string(static_cast<long long>(labels[i])) + ": its cells get zeros.";
    }
  }
  for (int i = 0; i < table->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* from = table->GetAbstractArray(i);
    fields->AddArray(from);
    if (from == column || !from->GetName() || !vtkDataArray::SafeDownCast(from) ||
      from->GetNumberOfTuples() != size ||
      from->GetName() == std::string(vtkDataSetAttributes::GhostArrayName()))
    {
      continue;
    }
    const auto values =
      vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::SafeDownCast(from->NewInstance()));
    values->SetName(from->GetName());
    values->SetNumberOfComponents(from->GetNumberOfComponents());
    values->SetNumberOfTuples(static_cast<vtkIdType>(cellLabels.size()));
    values->Fill(0.);
    for (std::size_t cell = 0; cell < cellLabels.size(); ++cell)
    {
      const vtkIdType row = rowOfIndex[cellLabels[cell]];
      if (row >= 0 && row < from->GetNumberOfTuples())
      {
        values->SetTuple(static_cast<vtkIdType>(cell), row, from);
      }
    }
    cells->AddArray(values);
  }
  return without;
}

}
