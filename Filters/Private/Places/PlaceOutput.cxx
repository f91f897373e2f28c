// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Places/PlaceOutput.h"

#include "Core/Memory/Loops.h"
#include "Core/Memory/Vectors.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Run/RunOptions.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace subdivision
{
namespace
{

using namespace vectors;

double GetCurvatureOfCurve(const Vector& first, const Vector& second)
{
  const double speed = std::sqrt(Dot(first, first));
  const Vector cross = Cross(first, second);
  return speed > 0. ? std::sqrt(Dot(cross, cross)) / (speed * speed * speed) : 0.;
}

/// The unit normal, the mean and the Gaussian curvature; zero where the tangents span no plane.
struct SurfaceShape
{
  Vector Normal{};
  double Mean = 0.;
  double Gaussian = 0.;
};
SurfaceShape FindShape(const PlacePoint& parts)
{
  const Vector& u = parts[PlaceParts::First];
  const Vector& v = parts[PlaceParts::First + 1];
  SurfaceShape shape;
  Vector normal = Cross(u, v);
  const double area = std::sqrt(Dot(normal, normal));
  if (!(area > 0.))
  {
    return shape;
  }
  for (double& x : normal)
  {
    x /= area;
  }
  const double e = Dot(u, u);
  const double f = Dot(u, v);
  const double g = Dot(v, v);
  const double l = Dot(parts[PlaceParts::Second], normal);
  const double m = Dot(parts[PlaceParts::Mixed], normal);
  const double n = Dot(parts[PlaceParts::SecondOfSecond], normal);
  shape.Normal = normal;
  shape.Mean = 0.5 * (e * n - 2. * f * m + g * l) / (area * area);
  shape.Gaussian = (l * n - m * m) / (area * area);
  return shape;
}

}

std::string CheckPlaceArrays(vtkIdTypeArray* cells, vtkDataArray* parameters)
{
  if (cells->GetNumberOfComponents() == 1 && parameters->GetNumberOfComponents() == 3 &&
    cells->GetNumberOfTuples() == parameters->GetNumberOfTuples())
  {
    return std::string();
  }
  return "Each place has one cell and three parameters, and not " +
    std::to_string(cells->GetNumberOfTuples()) + " cells of " +
    std::to_string(cells->GetNumberOfComponents()) + " numbers and " +
    std::to_string(parameters->GetNumberOfTuples()) + " parameters of " +
    std::to_string(parameters->GetNumberOfComponents()) + ".";
}

vtkDoubleArray* AddPlaceArray(const char* name, int components, vtkIdType size, vtkPolyData* output)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(size);
  array->Fill(0.);
  output->GetPointData()->AddArray(array);
  return array;
}

DerivativeArrays::DerivativeArrays(vtkIdType size, vtkPolyData* output)
{
  for (int k = 0; k < 3; ++k)
  {
    this->Tangents[k] = AddPlaceArray(PlaceDerivativeNames[k], 3, size, output)->GetPointer(0);
  }
  this->Normals = AddPlaceArray(LimitNormalsName, 3, size, output)->GetPointer(0);
  this->Mean = AddPlaceArray(MeanCurvatureName, 1, size, output)->GetPointer(0);
  this->Gaussian = AddPlaceArray(GaussianCurvatureName, 1, size, output)->GetPointer(0);
}

void DerivativeArrays::Set(vtkIdType i, int dimension, const PlacePoint& parts)
{
  for (int k = 0; k < 3; ++k)
  {
    std::copy_n(parts[PlaceParts::First + k].data(), 3, this->Tangents[k] + 3 * i);
  }
  if (dimension == 1)
  {
    this->Mean[i] = GetCurvatureOfCurve(parts[PlaceParts::First], parts[PlaceParts::Second]);
  }
  if (dimension == 2)
  {
    const SurfaceShape shape = FindShape(parts);
    std::copy_n(shape.Normal.data(), 3, this->Normals + 3 * i);
    this->Mean[i] = shape.Mean;
    this->Gaussian[i] = shape.Gaussian;
  }
}

SparseRows<vtkIdType> AppendedRows::Finish()
{
  this->Offsets.push_back(this->Columns.size());
  SparseRows<vtkIdType> rows;
  rows.NumberOfColumns = this->NumberOfColumns;
  rows.Offsets = this->Offsets.Copy();
  rows.Columns = this->Columns.Copy();
  rows.Weights = this->Weights.Copy();
  return rows;
}

namespace
{

/// The arrays of places follow the arrays of the mesh. Where both have a name, the array of places
/// ends with OfPlace.
void AddArraysOfPlaces(vtkDataSet* places, vtkPolyData* output)
{
  vtkDataSetAttributes* from = places->GetPointData();
  vtkDataSetAttributes* to = output->GetPointData();
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    vtkSmartPointer<vtkAbstractArray> array = from->GetAbstractArray(i);
    std::string name = array->GetName() ? array->GetName() : "";
    if (array->GetNumberOfTuples() != places->GetNumberOfPoints() ||
      name == vtkDataSetAttributes::GhostArrayName())
    {
      continue;
    }
    if (to->HasArray(name.c_str()))
    {
      while (to->HasArray(name.c_str()) || from->HasArray(name.c_str()))
      {
        name += "OfPlace";
      }
      std::vector<vtkIdType> all(static_cast<std::size_t>(places->GetNumberOfPoints()));
      std::iota(all.begin(), all.end(), vtkIdType(0));
      array = Gather(array, { all.data(), all.data() + all.size() });
      array->SetName(name.c_str());
    }
    const int added = to->AddArray(array);
    for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
    {
      if (from->GetAbstractAttribute(type) == from->GetAbstractArray(i) &&
        !to->GetAbstractAttribute(type))
      {
        to->SetActiveAttribute(added, type);
      }
    }
  }
}

}

void WarnOfMissingPlaces(
  const std::vector<vtkIdType>& missing, const char* what, const RunOptions& options)
{
  if (!missing.empty())
  {
    const bool isOne = missing.size() == 1;
    options.Warn(std::to_string(missing.size()) + (isOne ? " place has " : " places have ") + what +
      " that are not finite; the first is place " + std::to_string(missing[0]) +
      ". All its results are NaN, or 0 where they are integers. Remove it, or mend its " + what +
      ".");
  }
}

void FinishPlaces(const std::vector<vtkIdType>& missing, vtkPolyData* arrays, vtkDataSet* places,
  vtkPolyData* output)
{
  const auto forget = [&](vtkDataArray* array)
  {
    const bool isInteger =
      array && array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE;
    for (const vtkIdType i : InTurn(missing))
    {
      for (int c = 0; array && c < array->GetNumberOfComponents(); ++c)
      {
        array->SetComponent(i, c, isInteger ? 0. : std::numeric_limits<double>::quiet_NaN());
      }
    }
  };
  if (!missing.empty())
  {
    forget(output->GetPoints()->GetData());
    for (int i = 0; i < output->GetPointData()->GetNumberOfArrays(); ++i)
    {
      forget(output->GetPointData()->GetArray(i));
    }
  }
  for (int i = 0; i < arrays->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = arrays->GetPointData()->GetArray(i);
    vtkIdTypeArray::SafeDownCast(array) ? void() : forget(array); // the cell is -1
    output->GetPointData()->AddArray(array);
  }
  if (places && places->GetNumberOfPoints() == output->GetNumberOfPoints()) // there are cells
  {
    AddArraysOfPlaces(places, output);
  }
  vtkNew<vtkCellArray> vertices;
  for (const vtkIdType i : InTurn(output->GetNumberOfPoints()))
  {
    vertices->InsertNextCell(1, &i);
  }
  output->SetVerts(vertices);
}

}
