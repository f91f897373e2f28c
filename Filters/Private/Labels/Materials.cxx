// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Labels/Materials.h"

#include "Private/Arrays/Arrays.h"
#include "Private/Labels/LabelImage.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkSmartPointer.h"

#include <map>
#include <set>
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

namespace
{

/// For each position in `labels`, plus 1, the row of the table; -1: there is none.
std::vector<vtkIdType> FindRows(vtkDataArray* column, vtkIdType size,
  const std::vector<vtkVariant>& labels, const std::function<void(const std::string&)>& warn)
{
  std::map<vtkVariant, vtkIdType> rows;
  std::set<vtkVariant> repeated;
  const auto values = column ? Contiguous(column) : nullptr;
  for (vtkIdType row = 0; row < size; ++row)
  {
    const vtkVariant label =
      values ? FindWholeNumber(values, row) : vtkVariant(static_cast<long long>(row));
    if (label.IsValid() && !rows.emplace(label, row).second)
    {
      repeated.insert(label);
    }
  }
  std::vector<vtkIdType> rowOfIndex(labels.size() + 1, -1);
  std::string without;
  std::string several;
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    const auto found = rows.find(labels[i]);
    if (found != rows.end())
    {
      rowOfIndex[i + 1] = found->second;
    }
    else if (without.empty())
    {
      without = labels[i].ToString();
    }
    if (several.empty() && repeated.count(labels[i]) > 0)
    {
      several = labels[i].ToString();
    }
  }
  if (!without.empty())
  {
    warn("The table of materials has no row for label " + without +
      ": its cells get zeros. Add a row for it.");
  }
  if (!several.empty())
  {
    warn("The table of materials has several rows for label " + several + ": the first counts.");
  }
  return rowOfIndex;
}

}

void AddMaterials(vtkFieldData* table, const std::string& name,
  const std::vector<vtkVariant>& labels, const std::vector<int>& cellLabels,
  vtkDataSetAttributes* cells, vtkFieldData* fields,
  const std::function<void(const std::string&)>& warn)
{
  vtkDataArray* column = FindLabelColumn(table, name);
  for (const std::string& wanted : { name, std::string("Label") })
  {
    if (!column && table->GetAbstractArray(wanted.c_str()))
    {
      warn("The column \"" + wanted +
        "\" of the table of materials has no numbers: the number of a row, from 0, is its label.");
    }
  }
  // The arrays of field data may have different sizes: arrays of another size are no columns.
  const vtkIdType size = column ? column->GetNumberOfTuples() : table->GetNumberOfTuples();
  const std::vector<vtkIdType> rowOfIndex = FindRows(column, size, labels, warn);
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
    const auto plain = Contiguous(vtkDataArray::SafeDownCast(from));
    const auto values = vtkSmartPointer<vtkDataArray>(
      vtkDataArray::SafeDownCast(MakeLike(from, static_cast<vtkIdType>(cellLabels.size()))));
    values->Fill(0.);
    for (std::size_t cell = 0; cell < cellLabels.size(); ++cell)
    {
      const vtkIdType row = rowOfIndex[cellLabels[cell]];
      if (row >= 0)
      {
        values->SetTuple(static_cast<vtkIdType>(cell), row, plain);
      }
    }
    if (cells->HasArray(from->GetName()))
    {
      warn("The column \"" + std::string(from->GetName()) +
        "\" of the table of materials replaces the array of the voxels that has its name.");
    }
    cells->AddArray(values);
  }
}

}
