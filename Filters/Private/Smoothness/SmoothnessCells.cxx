// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Smoothness/SmoothnessCells.h"

#include "Core/Memory/Loops.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Control/SizeChecks.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSignedCharArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <type_traits>

namespace subdivision
{
namespace
{

unsigned char FindType(int dimension, vtkIdType size)
{
  constexpr unsigned char types[2] = { VTK_VERTEX, VTK_LINE };
  constexpr unsigned char polygons[3] = { VTK_TRIANGLE, VTK_QUAD, VTK_POLYGON };
  return dimension < 2 ? types[dimension] : polygons[std::min<vtkIdType>(size - 3, 2)];
}

}

std::string SmoothnessCells::CheckSize(
  double cells, double points, const SmoothnessOptions& options)
{
  if (cells > static_cast<double>(options.MaximumNumberOfCells))
  {
    return "The mesh has " + std::to_string(static_cast<long long>(cells)) +
      " vertices, edges and faces to examine, which is above MaximumNumberOfCells = " +
      std::to_string(options.MaximumNumberOfCells) +
      ". Take a part of the input, or raise MaximumNumberOfCells.";
  }
  // What is kept of a cell, and its part of the output.
  return CheckMemory(cells, points, cells * (sizeof(Cell) + 110.), 0);
}

void SmoothnessCells::Write(vtkUnstructuredGrid* output) const
{
  this->WriteCells(output);
  this->WriteArrays(output);
  this->MarkPoints(output);
  // The stamp of an earlier filter belongs to other cells.
  vtkFieldData* fields = output->GetFieldData();
  for (int i = fields->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    if (BelongsToStamp(fields->GetArrayName(i)))
    {
      fields->RemoveArray(i);
    }
  }
}

void SmoothnessCells::WriteCells(vtkUnstructuredGrid* output) const
{
  const auto size = static_cast<vtkIdType>(this->Cells.size());
  vtkNew<vtkIdTypeArray> connectivity;
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkUnsignedCharArray> types;
  connectivity->SetNumberOfValues(static_cast<vtkIdType>(this->Connectivity.size()));
  std::copy(this->Connectivity.begin(), this->Connectivity.end(), connectivity->GetPointer(0));
  offsets->SetNumberOfValues(size + 1);
  offsets->SetValue(0, 0);
  types->SetNumberOfValues(size);
  ForEach(size,
    [&](vtkIdType i)
    {
      offsets->GetPointer(0)[i + 1] = this->Cells[i].End;
      types->GetPointer(0)[i] = FindType(this->Cells[i].Dimension, this->GetSize(i));
    });
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  output->SetCells(types, cells);
}

void SmoothnessCells::WriteArrays(vtkUnstructuredGrid* output) const
{
  const auto size = static_cast<vtkIdType>(this->Cells.size());
  const auto add = [&](auto* array, const char* name, const auto& get)
  {
    array->SetName(name);
    array->SetNumberOfTuples(size);
    auto* values = array->GetPointer(0);
    using Value = std::remove_reference_t<decltype(*values)>;
    ForEach(size, [&](vtkIdType i) { values[i] = static_cast<Value>(get(this->Cells[i])); });
    output->GetCellData()->AddArray(array);
  };
  add(vtkNew<vtkUnsignedCharArray>().Get(), "SimplexDimension",
    [](const Cell& cell) { return cell.Dimension; });
  add(vtkNew<vtkSignedCharArray>().Get(), "RuleDimension",
    [](const Cell& cell) { return cell.Rule; });
  add(vtkNew<vtkIntArray>().Get(), "Sector", [](const Cell& cell) { return cell.Sector; });
  add(vtkNew<vtkIntArray>().Get(), "Valence", [](const Cell& cell) { return cell.Facts.Valence; });
  vtkNew<vtkDoubleArray> eigenvalues;
  constexpr int values = SmoothnessFacts::NumberOfValues;
  eigenvalues->SetName("Eigenvalues");
  eigenvalues->SetNumberOfComponents(values);
  eigenvalues->SetNumberOfTuples(size);
  for (int k = 0; k < values; ++k)
  {
    eigenvalues->SetComponentName(k, ("L" + std::to_string(k)).c_str());
  }
  double* to = eigenvalues->GetPointer(0);
  ForEach(size,
    [&](vtkIdType i)
    {
      const auto& found = this->Cells[i].Facts.Eigenvalues;
      std::copy(found.begin(), found.end(), to + values * i);
    });
  output->GetCellData()->AddArray(eigenvalues);
  add(vtkNew<vtkSignedCharArray>().Get(), "Condition",
    [](const Cell& cell) { return cell.Facts.Condition; });
  add(vtkNew<vtkSignedCharArray>().Get(), "Regular",
    [](const Cell& cell) { return cell.Facts.Regular; });
  add(vtkNew<vtkSignedCharArray>().Get(), "Injective",
    [](const Cell& cell) { return cell.Facts.Injective; });
  add(vtkNew<vtkIntArray>().Get(), "Samples", [](const Cell& cell) { return cell.Facts.Samples; });
  add(vtkNew<vtkUnsignedCharArray>().Get(), FailingName,
    [](const Cell& cell) { return cell.Facts.Fails() ? 1 : 0; });
  output->GetCellData()->SetActiveScalars(FailingName); // what views show
}

/// A point is marked where a cell fails, so that other filters find the place in their mesh.
void SmoothnessCells::MarkPoints(vtkUnstructuredGrid* output) const
{
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName(FailingName);
  marks->SetNumberOfTuples(output->GetNumberOfPoints());
  marks->FillValue(0);
  ForEachInTurn(static_cast<vtkIdType>(this->Cells.size()),
    [&](vtkIdType i)
    {
      for (vtkIdType k = this->GetBegin(i); this->Cells[i].Facts.Fails() && k < this->Cells[i].End;
        ++k)
      {
        marks->SetValue(this->Connectivity[k], 1);
      }
    });
  output->GetPointData()->AddArray(marks);
}

PointArrayOptions GetPointOptions(
  vtkPointSet* input, const SmoothnessOptions& options, bool carriesIds)
{
  PointArrayOptions arrays;
  arrays.InterpolateIntegers = options.InterpolateIntegers;
  arrays.OriginalIds = options.GenerateOriginalIds;
  arrays.CarryOriginalIds =
    carriesIds && HasIds(input->GetPointData(), OriginalPointIdsName, input->GetNumberOfPoints());
  arrays.Precision = options.OutputPointsPrecision;
  arrays.Replaced.emplace_back(FailingName);
  if (arrays.OriginalIds)
  {
    arrays.Replaced.emplace_back(OriginalPointIdsName);
  }
  return arrays;
}

}
