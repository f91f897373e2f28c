// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Smoothness/SmoothnessCells.h"

#include "Core/Memory/Loops.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Run/SizeChecks.h"

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
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
  // A kept cell, and its part of the output.
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
  output->GetCellData()->SetActiveScalars(FailingName); // views show it
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

bool SmoothnessCells::WriteMap(const StarMap& map, vtkUnstructuredGrid* output) const
{
  const auto wanted = static_cast<std::size_t>(this->Options.MapOfCell);
  if (wanted >= this->Cells.size())
  {
    this->Options.Fail("MapOfCell is " + std::to_string(wanted) + ", but the output has " +
      std::to_string(this->Cells.size()) +
      " cells. Take the id of one of them, counted from 0, as it is with MapOfCell = -1.");
    return false;
  }
  if (map.IsEmpty())
  {
    this->Options.Fail("There is no characteristic map at cell " + std::to_string(wanted) +
      ": vertices and edges on curves, corners, joints, boundaries in dual schemes and vertices "
      "with octahedra have none, and where the eigenvalues that lead are not larger than the next "
      "one (Condition "
      "is 0) it is not unique. Choose another cell, or take MapOfCell = -1 to look at all.");
    return false;
  }
  const auto size = static_cast<vtkIdType>(map.Points.size());
  const auto cells = static_cast<vtkIdType>(map.Ends.size());
  vtkNew<vtkPoints> points;
  points->SetDataType(
    this->Options.OutputPointsPrecision == vtkAlgorithm::SINGLE_PRECISION ? VTK_FLOAT : VTK_DOUBLE);
  points->SetNumberOfPoints(size);
  vtkNew<vtkDoubleArray> rings;
  rings->SetName("Ring");
  rings->SetNumberOfTuples(size);
  for (const vtkIdType i : InTurn(size))
  {
    points->SetPoint(i, map.Points[i].data());
    rings->SetValue(i, map.Rings[i]);
  }
  vtkNew<vtkCellArray> made;
  vtkNew<vtkUnsignedCharArray> types;
  vtkNew<vtkDoubleArray> jacobians;
  jacobians->SetName("Jacobian");
  for (vtkIdType i = 0, begin = 0; i < cells; begin = map.Ends[i++])
  {
    const vtkIdType corners = map.Ends[i] - begin;
    made->InsertNextCell(static_cast<int>(corners));
    for (vtkIdType k = begin; k < map.Ends[i]; ++k)
    {
      made->InsertCellPoint(map.Corners[k]);
    }
    types->InsertNextValue(
      map.Dimension == 3 ? static_cast<unsigned char>(VTK_TETRA) : FindType(2, corners));
    jacobians->InsertNextValue(map.Jacobians[i]);
  }
  vtkNew<vtkDoubleArray> eigenvalues;
  eigenvalues->SetName("Eigenvalues");
  for (const double value : map.Facts.Eigenvalues)
  {
    eigenvalues->InsertNextValue(value);
  }
  output->SetPoints(points);
  output->GetPointData()->AddArray(rings);
  output->SetCells(types, made);
  output->GetCellData()->AddArray(jacobians);
  output->GetCellData()->SetActiveScalars("Jacobian"); // what views show
  output->GetFieldData()->AddArray(eigenvalues);
  return true;
}

}
