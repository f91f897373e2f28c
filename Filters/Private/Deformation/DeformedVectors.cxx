// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Deformation/DeformedVectors.h"

#include "Core/Memory/Loops.h"
#include "Core/Memory/Store.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Reading/CellReader.h"
#include "Private/Reading/ReadableMesh.h"
#include "Private/Run/RunOptions.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace subdivision
{
namespace
{

constexpr int Attributes[] = { vtkDataSetAttributes::VECTORS, vtkDataSetAttributes::TANGENTS,
  vtkDataSetAttributes::NORMALS };

/// The active array of a kind if it can be transformed, else null.
vtkDataArray* FindActive(vtkDataSetAttributes* data, int attribute, vtkIdType tuples)
{
  vtkDataArray* array = data->GetAttribute(attribute);
  const bool isFloating =
    array && (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE);
  return isFloating && array->GetNumberOfComponents() == 3 && array->GetNumberOfTuples() == tuples
    ? array
    : nullptr;
}

void Multiply(const double* matrix, const double in[3], double out[3])
{
  for (int row = 0; row < 3; ++row)
  {
    out[row] = matrix[3 * row] * in[0] + matrix[3 * row + 1] * in[1] + matrix[3 * row + 2] * in[2];
  }
}

/// Multiplies a normal by the inverse transpose and makes its length 1. The inverse transpose is
/// the matrix of cofactors over the determinant, of which only the sign matters. A normal that
/// becomes 0 stays as it was.
void MultiplyNormal(const double* matrix, const double in[3], double out[3])
{
  double cofactors[9];
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      auto at = [&](int r, int c) { return matrix[3 * ((row + r) % 3) + (column + c) % 3]; };
      cofactors[3 * row + column] = at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1);
    }
  }
  const double determinant =
    matrix[0] * cofactors[0] + matrix[1] * cofactors[1] + matrix[2] * cofactors[2];
  Multiply(cofactors, in, out);
  const double length = std::sqrt(out[0] * out[0] + out[1] * out[1] + out[2] * out[2]);
  const double factor = length > 0. ? (determinant < 0. ? -1. : 1.) / length : 0.;
  for (int c = 0; c < 3; ++c)
  {
    out[c] = factor != 0. && std::isfinite(factor) ? factor * out[c] : in[c];
  }
}

template <typename T>
void TransformValues(const Buffer<double>& jacobians, bool areNormals, const T* from, T* to)
{
  ForEach(jacobians.size() / 9,
    [&](vtkIdType i)
    {
      const double in[3] = { static_cast<double>(from[3 * i]), static_cast<double>(from[3 * i + 1]),
        static_cast<double>(from[3 * i + 2]) };
      double out[3];
      (areNormals ? MultiplyNormal : Multiply)(jacobians.data() + 9 * i, in, out);
      for (int c = 0; c < 3; ++c)
      {
        to[3 * i + c] = Store<T>(out[c]);
      }
    });
}

void TransformAttributes(const Buffer<double>& jacobians, vtkDataSetAttributes* data)
{
  vtkNew<vtkDataSetAttributes> before;
  before->ShallowCopy(data);
  for (int attribute : Attributes)
  {
    vtkDataArray* array = FindActive(before, attribute, jacobians.size() / 9);
    if (!array)
    {
      continue;
    }
    const bool areNormals = attribute == vtkDataSetAttributes::NORMALS;
    const auto from = Contiguous(array);
    const auto to = MakeArray(array->GetDataType(), 3, array->GetNumberOfTuples());
    CopyLooks(array, to);
    if (array->GetDataType() == VTK_FLOAT)
    {
      TransformValues(jacobians, areNormals, static_cast<const float*>(from->GetVoidPointer(0)),
        static_cast<float*>(to->GetVoidPointer(0)));
    }
    else
    {
      TransformValues(jacobians, areNormals, static_cast<const double*>(from->GetVoidPointer(0)),
        static_cast<double*>(to->GetVoidPointer(0)));
    }
    int source = 0;
    while (before->GetAbstractArray(source) != array)
    {
      ++source;
    }
    if (!array->GetName()) // AddLike replaces arrays by name only
    {
      data->SetAttribute(nullptr, attribute);
    }
    AddLike(before, source, to, data);
  }
}

/// The mean over some points; the identity of none.
void Average(const Buffer<double>& jacobians, const CellIds& points, double mean[9])
{
  for (int k = 0; k < 9; ++k)
  {
    double sum = 0.;
    for (vtkIdType i = 0; i < points.Size; ++i)
    {
      sum += jacobians[9 * points.Ids[i] + k];
    }
    mean[k] = points.Size > 0 ? sum / static_cast<double>(points.Size) : k % 4 == 0 ? 1. : 0.;
  }
}

/// The mean over the points of each cell. A cell that cannot be read gets the identity, and goes to
/// `wrong`: nobody has checked the cells of the input before.
Buffer<double> AverageOverCells(
  const Buffer<double>& jacobians, vtkPointSet* data, std::vector<vtkIdType>& wrong)
{
  const vtkIdType points = jacobians.size() / 9;
  vtkSmartPointer<vtkDataObject> readable = data;
  if (!vtkUnstructuredGrid::SafeDownCast(data)) // of which the ids are wanted as they are
  {
    std::vector<std::string> none;
    readable = MakeReadable(data, NonLinearRule::Pieces, none);
  }
  const CellReader cells(vtkPointSet::SafeDownCast(readable));
  Buffer<double> means(9 * data->GetNumberOfCells());
  std::vector<vtkIdType> scratch;
  for (const vtkIdType i : InTurn(data->GetNumberOfCells()))
  {
    CellIds cell = i < cells.GetNumberOfCells() ? cells.GetCell(i, scratch) : CellIds();
    const bool isRight = std::all_of(
      cell.Ids, cell.Ids + cell.Size, [points](vtkIdType id) { return id >= 0 && id < points; });
    const bool isEmpty =
      cell.Size == 0 && (i >= cells.GetNumberOfCells() || cells.GetCellType(i) != VTK_EMPTY_CELL);
    if (!isRight || isEmpty)
    {
      wrong.push_back(i);
      cell = {};
    }
    Average(jacobians, cell, means.data() + 9 * i);
  }
  return means;
}

bool HasActive(vtkDataSetAttributes* data, vtkIdType tuples)
{
  return std::any_of(std::begin(Attributes), std::end(Attributes),
    [&](int attribute) { return FindActive(data, attribute, tuples) != nullptr; });
}

}

bool HasVectors(vtkPointSet* data)
{
  return HasActive(data->GetPointData(), data->GetNumberOfPoints()) ||
    HasActive(data->GetCellData(), data->GetNumberOfCells());
}

void TransformVectors(
  const Buffer<double>& jacobians, const RunOptions& options, vtkPointSet* output)
{
  TransformAttributes(jacobians, output->GetPointData());
  if (!HasActive(output->GetCellData(), output->GetNumberOfCells()))
  {
    return;
  }
  std::vector<vtkIdType> wrong;
  TransformAttributes(AverageOverCells(jacobians, output, wrong), output->GetCellData());
  if (!wrong.empty())
  {
    options.Warn(std::to_string(wrong.size()) + " cell(s) of the input, the first is cell " +
      std::to_string(wrong[0]) +
      ", have no points, or point ids that are negative or not below the number of points: the "
      "filter does not turn the vectors of these cells. Correct the cells in the program that "
      "wrote them.");
  }
}

}
