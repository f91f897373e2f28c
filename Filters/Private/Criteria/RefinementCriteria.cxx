// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Criteria/RefinementCriteria.h"

#include "Core/Memory/Loops.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Reading/CellsToSimplices.h"

#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <limits>

namespace subdivision
{

// ------------------------------------------------------------------------------------------------
// Values at points

void ContinuedArray::Start(vtkDataArray* array, const SimplicesOfCells& cells, bool smooth)
{
  this->Components = array->GetNumberOfComponents();
  this->Smooth = smooth;
  const vtkIdType given = array->GetNumberOfTuples();
  this->Given = given + cells.GetNumberOfCentres();
  const auto plain = array->GetDataType() == VTK_BIT ? nullptr : Contiguous(array);
  if (plain && plain->GetDataType() == VTK_DOUBLE && given > 0 && this->Given == given)
  {
    this->Array = plain;
    this->Values = static_cast<const double*>(plain->GetVoidPointer(0));
    return;
  }
  this->Converted = Buffer<double>(this->Given * this->Components);
  double* values = this->Converted.data();
  this->Values = values;
  if (given > 0 && plain)
  {
    auto convert = [&](const auto* from)
    {
      ForEach(given * this->Components,
        [values, from](vtkIdType i) { values[i] = static_cast<double>(from[i]); });
    };
    switch (plain->GetDataType())
    {
      vtkTemplateMacro(convert(static_cast<const VTK_TT*>(plain->GetVoidPointer(0))));
    }
  }
  for (int c = 0; !plain && c < this->Components; ++c)
  {
    ForEach(
      given, [&](vtkIdType i) { values[i * this->Components + c] = array->GetComponent(i, c); });
  }
  this->FillCentres(cells, given);
}

void ContinuedArray::FillCentres(const SimplicesOfCells& cells, vtkIdType given)
{
  for (const vtkIdType i : InTurn(cells.GetNumberOfCentres()))
  {
    const vtkIdType begin = cells.CentreOffsets[i];
    const vtkIdType end = cells.CentreOffsets[i + 1];
    const vtkIdType* members = cells.CentreMembers.data();
    for (int c = 0; c < this->Components; ++c)
    {
      double& value = this->Converted[(given + i) * this->Components + c];
      if (!this->Smooth)
      {
        value = *(this->Get(*std::min_element(members + begin, members + end)) + c);
        continue;
      }
      value = 0.;
      for (vtkIdType m = begin; m < end; ++m)
      {
        value += *(this->Get(members[m]) + c) / static_cast<double>(end - begin);
      }
    }
  }
}

double* ContinuedArray::Grow(vtkIdType size)
{
  if (this->Given > 0)
  {
    const vtkIdType known = this->GetSize();
    GrowingBuffer<double> own;
    own.Reserve(std::max(known, size) * this->Components);
    for (vtkIdType point = 0; point < known; ++point)
    {
      std::copy_n(this->Get(point), this->Components, own.Extend(this->Components));
    }
    this->Added = std::move(own);
    this->Given = 0;
    this->Array = nullptr;
    this->Converted = {};
    this->Values = nullptr;
  }
  const vtkIdType missing = size * this->Components - this->Added.size();
  if (missing > 0)
  {
    std::fill_n(this->Added.Extend(missing), missing, 0.);
  }
  return this->Added.data();
}

double ContinuedArray::GetNorm(vtkIdType point) const
{
  const double* value = this->Get(point);
  if (this->Components == 1)
  {
    return *value; // with its sign
  }
  double sum = 0.;
  for (int c = 0; c < this->Components; ++c)
  {
    sum += value[c] * value[c];
  }
  return std::sqrt(sum);
}

double ContinuedArray::GetDistance(vtkIdType a, vtkIdType b, double allowed) const
{
  const double* first = this->Get(a);
  const double* second = this->Get(b);
  if (this->Components == 1)
  {
    return std::abs(second[0] - first[0]);
  }
  double square = 0.;
  for (int c = 0; c < this->Components; ++c)
  {
    square += (second[c] - first[c]) * (second[c] - first[c]);
  }
  if (square < 0.999 * allowed * allowed) // for most edges; std::hypot is slower, never overflows
  {
    return std::sqrt(square);
  }
  double distance = 0.;
  for (int c = 0; c < this->Components; ++c)
  {
    distance = std::hypot(distance, second[c] - first[c]);
  }
  return distance;
}

double ContinuedArray::GetRange(const std::function<void(std::vector<double>&)>& findLargest) const
{
  std::vector<double> box; // of each component the negative of the least value, and the most
  for (int c = 0; c < this->Components; ++c)
  {
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (vtkIdType i = 0; i < this->GetSize(); ++i)
    {
      const double value = this->Get(i)[c];
      if (std::isfinite(value))
      {
        least = std::min(least, value);
        most = std::max(most, value);
      }
    }
    box.push_back(-least);
    box.push_back(most);
  }
  if (findLargest && !box.empty())
  {
    findLargest(box);
  }
  double diagonal = 0.;
  for (size_t c = 0; c < box.size(); c += 2)
  {
    diagonal = box[c + 1] > -box[c] ? std::hypot(diagonal, box[c + 1] + box[c]) : diagonal;
  }
  return diagonal;
}

// ------------------------------------------------------------------------------------------------
// Criteria

namespace
{

double GetDistanceFromEdge(const double* p, const double* a, const double* b)
{
  double along = 0.;
  double length = 0.;
  for (int c = 0; c < 3; ++c)
  {
    along += (b[c] - a[c]) * (p[c] - a[c]);
    length += (b[c] - a[c]) * (b[c] - a[c]);
  }
  const double t = length > 0. ? std::max(0., std::min(along / length, 1.)) : 0.;
  double distance = 0.;
  for (int c = 0; c < 3; ++c)
  {
    distance = std::hypot(distance, a[c] + t * (b[c] - a[c]) - p[c]);
  }
  return distance;
}

/// Whether the foot of the perpendicular from `p` lies in the triangle; `height` is the signed
/// distance from its plane.
bool FindHeight(const double* p, const double* const* corners, double& height)
{
  double normal[3];
  double square = 0.;
  height = 0.;
  for (int c = 0; c < 3; ++c)
  {
    const int d = (c + 1) % 3;
    const int e = (c + 2) % 3;
    normal[c] = (corners[1][d] - corners[0][d]) * (corners[2][e] - corners[0][e]) -
      (corners[1][e] - corners[0][e]) * (corners[2][d] - corners[0][d]);
    square += normal[c] * normal[c];
    height += normal[c] * (p[c] - corners[0][c]);
  }
  height = square > 0. ? height / std::sqrt(square) : 0.;
  bool isOver = square > 0. && std::isfinite(square);
  for (int i = 0; isOver && i < 3; ++i)
  {
    const double* a = corners[i];
    const double* b = corners[(i + 1) % 3];
    double side = 0.; // positive if the foot is on the inner side of the edge ab
    for (int c = 0; c < 3; ++c)
    {
      const int d = (c + 1) % 3;
      const int e = (c + 2) % 3;
      side += normal[c] * ((b[d] - a[d]) * (p[e] - a[e]) - (b[e] - a[e]) * (p[d] - a[d]));
    }
    isOver = side >= 0.;
  }
  return isOver;
}

double GetDistanceFromTriangle(const double* p, const double* const* corners)
{
  double height = 0.;
  if (FindHeight(p, corners, height))
  {
    return std::abs(height);
  }
  double distance = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i)
  {
    distance = std::min(distance, GetDistanceFromEdge(p, corners[i], corners[(i + 1) % 3]));
  }
  return distance;
}

/// Whether the surface turns by more than a right angle at the common edge of two triangles.
bool IsFold(const double* const ends[2], const double* const opposites[2])
{
  double along[3];
  double sides[2][3];
  vtkMath::Subtract(ends[1], ends[0], along);
  for (int i = 0; i < 2; ++i)
  {
    vtkMath::Subtract(opposites[i], ends[0], sides[i]);
  }
  return vtkMath::Dot(sides[0], sides[1]) * vtkMath::Dot(along, along) >
    vtkMath::Dot(sides[0], along) * vtkMath::Dot(sides[1], along);
}

}

RefinementCriteria::RefinementCriteria(
  const RefinementOptions& options, vtkPointSet* input, const SimplicesOfCells& cells)
  : Options(options)
{
  auto isSmooth = [&options](vtkDataArray* array)
  {
    const int type = array->GetDataType();
    const bool isColour = type == VTK_UNSIGNED_CHAR &&
      (array->GetNumberOfComponents() == 3 || array->GetNumberOfComponents() == 4);
    return type == VTK_FLOAT || type == VTK_DOUBLE || isColour || options.InterpolateIntegers;
  };
  this->Coordinates.Start(input->GetPoints()->GetData(), cells, true);
  if (options.Attribute)
  {
    this->Attribute.Start(options.Attribute, cells, isSmooth(options.Attribute));
    this->AllowedJump = options.AttributeTolerance * this->Attribute.GetRange(options.FindLargest);
  }
  if (options.Range && options.RangeOfCells)
  {
    this->Range.Start(options.Range, SimplicesOfCells(), true);
  }
  else if (options.Range)
  {
    this->Range.Start(options.Range, cells, isSmooth(options.Range));
  }
  if (options.ReadsShape())
  {
    const double size = this->Coordinates.GetRange(options.FindLargest);
    this->AllowedDistance = options.GeometricTolerance * (options.RelativeTolerance ? size : 1.);
    this->Rounding = 1e-14 * size;
  }
}

bool RefinementCriteria::IsTooShort(vtkIdType a, vtkIdType b) const
{
  const double* x = this->Coordinates.Get(a);
  const double* y = this->Coordinates.Get(b);
  bool same[3] = { true, true, true };
  for (int c = 0; c < 3; ++c)
  {
    const double middle = 0.5 * x[c] + 0.5 * y[c];
    same[0] = same[0] && middle == x[c];
    same[1] = same[1] && middle == y[c];
    same[2] = same[2] && x[c] == y[c];
  }
  return (same[0] || same[1]) && !same[2];
}

double RefinementCriteria::GetAttributeErrorAtLimit(
  const double* const* corners, const double* weights, const double* value) const
{
  double error = 0.;
  for (int c = 0; c < this->Attribute.GetComponents(); ++c)
  {
    error = std::hypot(error, weights[0] * corners[0][c] + weights[1] * corners[1][c] - value[c]);
  }
  return std::isfinite(error) ? this->Allow(BetweenPlaces * error, this->AllowedJump) : -1.;
}

double RefinementCriteria::GetGeometricError(
  const double* const* corners, int size, const double* place) const
{
  const double distance = size == 2 ? GetDistanceFromEdge(place, corners[0], corners[1])
                                    : GetDistanceFromTriangle(place, corners);
  double length = 0.;
  for (int i = 0; this->Options.ByCurvature && i < size; ++i)
  {
    const double* a = corners[i];
    const double* b = corners[(i + 1) % size];
    length = std::max(length, std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]));
  }
  return this->GetGeometricError(distance, length);
}

double RefinementCriteria::GetHeight(const double* const* corners, const double* place)
{
  double height = 0.;
  FindHeight(place, corners, height);
  return height;
}

double RefinementCriteria::GetErrorOverEdge(const double* const ends[2],
  const double* const opposites[2], int triangles, const double* place) const
{
  double distance = 0.;
  bool isOver = false;
  for (int i = 0; i < triangles; ++i)
  {
    const double* const corners[3] = { ends[0], ends[1], opposites[i] };
    double height = 0.;
    isOver = FindHeight(place, corners, height) || isOver;
    distance = std::max(distance, std::abs(height));
  }
  if (triangles == 2 && IsFold(ends, opposites))
  {
    distance = GetDistanceFromEdge(place, ends[0], ends[1]);
  }
  else if (triangles == 2 && !isOver)
  {
    double nearest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 2; ++i)
    {
      const double* const corners[3] = { ends[0], ends[1], opposites[i] };
      nearest = std::min(nearest, GetDistanceFromTriangle(place, corners));
    }
    distance = std::max(distance, nearest);
  }
  return this->GetGeometricError(
    distance, std::sqrt(vtkMath::Distance2BetweenPoints(ends[0], ends[1])));
}

std::vector<ContinuedArray*> RefinementCriteria::GetPointArrays()
{
  std::vector<ContinuedArray*> arrays{ &this->Coordinates };
  if (this->Attribute.IsSet())
  {
    arrays.push_back(&this->Attribute);
  }
  if (this->Range.IsSet() && !this->Options.RangeOfCells)
  {
    arrays.push_back(&this->Range);
  }
  return arrays;
}

/// Whether several threads may evaluate the function. These classes keep no state from point to
/// point; others, such as vtkImplicitDataSet, may.
bool RefinementCriteria::IsFunctionForThreads() const
{
  const char* const names[] = { "vtkBox", "vtkCone", "vtkCylinder", "vtkPlane", "vtkQuadric",
    "vtkSphere" };
  return std::any_of(std::begin(names), std::end(names), [this](const char* name)
    { return std::strcmp(name, this->Options.Function->GetClassName()) == 0; });
}

void RefinementCriteria::EvaluateFunction(double* centroids, vtkIdType size, double* values) const
{
  vtkNew<vtkDoubleArray> in;
  vtkNew<vtkDoubleArray> out;
  in->SetNumberOfComponents(3);
  in->SetArray(centroids, 3 * size, 1);
  out->SetArray(values, size, 1);
  this->Options.Function->FunctionValue(in, out);
  if (out->GetNumberOfTuples() == size && out->GetPointer(0) != values)
  {
    std::copy(out->GetPointer(0), out->GetPointer(0) + size, values);
  }
}

}
