// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlaceResult.h
 * Writes the limit at places, in place of an output: points, arrays and derivatives.
 */
#ifndef SubdivisionObjects_PlaceResult_h
#define SubdivisionObjects_PlaceResult_h

#include "Core/Memory/Loops.h"
#include "Private/Arrays/PointArrays.h"
#include "Private/Places/PlaceOutput.h"

#include "vtkPolyData.h"

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace subdivision
{

/// forRows(use) calls use(first place, its PlaceRows) for one part of `size` places after the
/// other; getDimension(place) is of its cell, getOrigin(place) the vertex whose values it takes in
/// arrays that are not smoothed. `found` may have arrays of places already.
template <typename ForRows, typename GetDimension, typename GetOrigin>
void WritePlaces(const PlaceRequest& request, vtkIdType size, const std::vector<vtkIdType>& missing,
  const ForRows& forRows, const GetDimension& getDimension, const GetOrigin& getOrigin,
  PointArrays& points, vtkPolyData* found)
{
  const double* coordinates = points.GetCoordinates();
  request.Output->Initialize();
  std::optional<DerivativeArrays> derivatives;
  request.HasDerivatives ? void(derivatives.emplace(size, found)) : void();
  std::array<AppendedRows, 4> rows;
  const int parts = request.Rows && request.HasDerivatives ? 4 : 1;
  forRows(
    [&](vtkIdType begin, const auto& part)
    {
      for (int p = 0; p < parts; ++p)
      {
        rows[p].Append(part, p == 0 ? PlaceParts::Value : PlaceParts::First + p - 1);
      }
      ForEach(derivatives ? part.GetNumberOfPlaces() : 0, [&](vtkIdType i)
        { derivatives->Set(begin + i, getDimension(begin + i), SumParts(part, i, coordinates)); });
    });
  SparseRows<vtkIdType> values = rows[0].Finish();
  points.Advance(values, getOrigin);
  if (request.Rows)
  {
    (*request.Rows)[0] = std::move(values);
    for (int p = 1; p < parts; ++p)
    {
      (*request.Rows)[p] = rows[p].Finish();
    }
  }
  points.ForgetInputPoints();
  points.Finish(request.Output);
  FinishPlaces(missing, found, request.Targets, request.Output);
}

}

#endif
