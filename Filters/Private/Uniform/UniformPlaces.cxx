// SPDX-License-Identifier: BSD-3-Clause
// The limit at places of cells, with derivatives.
#include "Private/Uniform/UniformRun.h"

#include "Core/Memory/Loops.h"
#include "Core/Operators/ApplyRows.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Limits/PlaceLimits.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace subdivision
{
namespace
{

using Vector = std::array<double, 3>;

double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vector Cross(const Vector& a, const Vector& b)
{
  return { { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] } };
}

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
SurfaceShape FindShape(const std::array<Vector, PlaceParts::Count>& parts)
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

vtkDoubleArray* AddArray(const char* name, int components, vtkIdType size, vtkPolyData* output)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(size);
  array->Fill(0.);
  output->GetPointData()->AddArray(array);
  return array;
}

/// Adds derivatives of the points, normals and curvatures to the output.
template <typename Id>
void AddDerivatives(const PlaceLimits<Id>& limits, const std::vector<LimitPlace<Id>>& places,
  const double* points, vtkPolyData* output)
{
  const auto size = static_cast<vtkIdType>(places.size());
  double* tangents[3];
  for (int k = 0; k < 3; ++k)
  {
    tangents[k] = AddArray(PlaceDerivativeNames[k], 3, size, output)->GetPointer(0);
  }
  double* normals = AddArray(LimitNormalsName, 3, size, output)->GetPointer(0);
  double* mean = AddArray(MeanCurvatureName, 1, size, output)->GetPointer(0);
  double* gaussian = AddArray(GaussianCurvatureName, 1, size, output)->GetPointer(0);
  ForEach(size,
    [&](vtkIdType i)
    {
      std::array<Vector, PlaceParts::Count> parts{};
      for (int p = PlaceParts::First; p < PlaceParts::Count; ++p)
      {
        WeightedRows<Id> row = limits.Rows[p].GetRows(i, i + 1);
        row.FirstRow = 0;
        SumRows(row, points, parts[p].data(), 3);
      }
      for (int k = 0; k < 3; ++k)
      {
        std::copy_n(parts[PlaceParts::First + k].data(), 3, tangents[k] + 3 * i);
      }
      if (places[i].Dimension == 1)
      {
        mean[i] = GetCurvatureOfCurve(parts[PlaceParts::First], parts[PlaceParts::Second]);
      }
      if (places[i].Dimension == 2)
      {
        const SurfaceShape shape = FindShape(parts);
        std::copy_n(shape.Normal.data(), 3, normals + 3 * i);
        mean[i] = shape.Mean;
        gaussian[i] = shape.Gaussian;
      }
    });
}

/// One vertex for each point.
void AddVertices(vtkIdType size, vtkPolyData* output)
{
  vtkNew<vtkCellArray> vertices;
  for (const vtkIdType i : InTurn(size))
  {
    vertices->InsertNextCell(1, &i);
  }
  output->SetVerts(vertices);
}

}

/// Finds the simplex of the cell of each place, and the order of its corners. Returns false, after
/// an error, if a cell has none of its own.
template <typename Id>
bool UniformRun::ReadPlaces(const PlaceRequest& request, std::vector<LimitPlace<Id>>& places) const
{
  const SimplexList& simplices = this->Mesh.Cells.Simplices;
  const auto& parents = this->Mesh.Cells.ParentCells;
  const vtkIdType cells = this->Input->GetNumberOfCells();
  std::vector<vtkIdType> starts(static_cast<std::size_t>(cells), -1); // of the simplices
  std::vector<int> counts(static_cast<std::size_t>(cells), 0);
  std::vector<int> dimensions(static_cast<std::size_t>(cells), 0);
  vtkIdType start = 0;
  for (const vtkIdType s : InTurn(simplices.GetNumberOfSimplices()))
  {
    const auto cell = static_cast<std::size_t>(parents.empty() ? s : parents[s]);
    starts[cell] = start;
    dimensions[cell] = simplices.Dimensions[s];
    ++counts[cell];
    start += simplices.Dimensions[s] + 1;
  }
  vtkNew<vtkIdList> points;
  for (const vtkIdType i : InTurn(request.Cells->GetNumberOfTuples()))
  {
    const vtkIdType cell = request.Cells->GetValue(i);
    if (cell < 0 || cell >= cells || counts[cell] != 1)
    {
      this->Options.Fail("Place " + std::to_string(i) + " is in cell " + std::to_string(cell) +
        (cell < 0 || cell >= cells
            ? ": the input has no such cell."
            : ", which is no vertex, line, triangle or tetrahedron, or was left out."));
      return false;
    }
    LimitPlace<Id> place;
    place.Dimension = dimensions[cell];
    this->Input->GetCellPoints(cell, points);
    const vtkIdType* corners = simplices.Connectivity.data() + starts[cell];
    for (int k = 0; k <= place.Dimension; ++k)
    {
      place.Corners[k] = static_cast<Id>(corners[k]);
      place.Order[k] =
        static_cast<int>(std::find(corners, corners + place.Dimension, points->GetId(k)) - corners);
    }
    for (int k = 0; k < place.Dimension; ++k)
    {
      place.Parameters[k] = request.Parameters->GetComponent(i, k);
      if (!std::isfinite(place.Parameters[k]))
      {
        this->Options.Fail("The parameters of place " + std::to_string(i) + " are not finite.");
        return false;
      }
    }
    places.push_back(place);
  }
  return true;
}

template <typename Scheme>
bool UniformRun::FindPlaces(const PlaceRequest& request, const typename Scheme::Level& level)
{
  using Id = typename Scheme::Id;
  std::vector<LimitPlace<Id>> places;
  if (!this->ReadPlaces(request, places))
  {
    return false;
  }
  const auto isSolid = [](const LimitPlace<Id>& place) { return place.Dimension == 3; };
  if (Scheme::Traits.HasPieces && std::any_of(places.begin(), places.end(), isSolid))
  {
    this->Options.Fail("Places inside solids have limits with VolumeScheme = BoxSpline or Linear "
                       "only.");
    return false;
  }
  const auto creases =
    BuildSharpStages<Scheme>(this->Mesh, this->Options.Features, this->Control, 0);
  if (this->Interpolates())
  {
    const SparseRows<Id> limit = BuildLimitRows(level, creases);
    this->Interpolate(&limit);
  }
  const PlaceLimits<Id> limits(level, creases, places);
  const double* coordinates = this->Points->GetCoordinates();
  vtkPolyData* output = request.Output;
  output->Initialize();
  vtkNew<vtkPolyData> derivatives;
  AddDerivatives(limits, places, coordinates, derivatives);
  this->Points->Advance(limits.Rows[PlaceParts::Value],
    [&](vtkIdType row)
    {
      const LimitPlace<Id>& place = places[row];
      const Vector& p = place.Parameters;
      const double first = 1. - p[0] - p[1] - p[2];
      const auto most = std::max_element(p.begin(), p.end());
      return static_cast<vtkIdType>(
        place.Corners[place.Order[first >= *most ? 0 : 1 + (most - p.begin())]]);
    });
  this->Points->ForgetInputPoints();
  this->Points->Finish(output);
  for (const vtkIdType i : InTurn(vtkIdType(derivatives->GetPointData()->GetNumberOfArrays())))
  {
    output->GetPointData()->AddArray(derivatives->GetPointData()->GetArray(static_cast<int>(i)));
  }
  AddVertices(request.Cells->GetNumberOfTuples(), output);
  return true;
}

bool UniformRun::FindPlaces(const PlaceRequest& request)
{
  if (!this->Plan())
  {
    return false;
  }
  this->PlanInterpolation();
  return std::visit([&](const auto& level)
    { return this->FindPlaces<SchemeOf<std::decay_t<decltype(level)>>>(request, level); },
    this->Current);
}

}
