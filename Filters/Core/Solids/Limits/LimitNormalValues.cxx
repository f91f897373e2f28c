// SPDX-License-Identifier: BSD-3-Clause
// Normals from the tangents of LimitNormals.h.
#include "Core/Operators/TangentErrors.h"

#include "Core/Memory/Ids.h"
#include "Core/Solids/Limits/LimitNormals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace subdivision
{
namespace
{

using Vector = std::array<double, 3>;

inline double Length(const Vector& a)
{
  return std::hypot(a[0], a[1], a[2]);
}

/// Of unit length; zero if it is shorter than `least`, or not finite.
inline Vector Normalise(const Vector& a, double least)
{
  const double length = Length(a);
  return length > least && std::isfinite(length)
    ? Vector{ a[0] / length, a[1] / length, a[2] / length }
    : Vector{ 0., 0., 0. };
}

}

template <typename Id>
void ComputeSectorNormals(const LimitTangents<Id>& tangents, const Coordinates& points,
  const std::vector<vtkIdType>& inverted, const Buffer<unsigned char>& turned, double* normals)
{
  const vtkIdType sectors = tangents.GetNumberOfSectors();
  Buffer<double> first(3 * sectors);
  Buffer<double> second(3 * sectors);
  tangents.First.Apply(points.Values, first.data(), 3);
  tangents.Second.Apply(points.Values, second.data(), 3);
  auto getError = [&points](const SparseRows<Id>& rows, vtkIdType sector)
  {
    const vtkIdType begin = rows.Offsets[sector];
    return GetTangentError(rows.Columns.data() + begin, rows.Weights.data() + begin,
      rows.Offsets[sector + 1] - begin, points.Values, points.GetUnit());
  };
  auto isTurned = [&](vtkIdType sector)
  {
    const Id triangle = tangents.Triangles[sector];
    return triangle >= 0 && !turned.empty() && turned[triangle] != 0;
  };
  // Whether most triangles of a sector have their solid behind them; true without solids.
  auto isOutwards = [&](vtkIdType sector)
  {
    vtkIdType outwards = 0;
    for (vtkIdType i = tangents.SideOffsets[sector]; i < tangents.SideOffsets[sector + 1]; ++i)
    {
      const vtkIdType side = tangents.Sides[i];
      const bool isInverted = std::binary_search(inverted.begin(), inverted.end(), side - side % 2);
      outwards += (side % 2 == 1) == isInverted ? 1 : -1;
    }
    return outwards >= 0;
  };
  auto normalOf = [&](vtkIdType sector)
  {
    Vector normal;
    FindNormal(first.data() + 3 * sector, second.data() + 3 * sector,
      getError(tangents.First, sector) + getError(tangents.Second, sector), normal.data());
    if (Length(normal) == 0.)
    {
      const double* a = first.data() + 3 * sector;
      const double* b = second.data() + 3 * sector;
      FindPerpendicular(
        std::hypot(a[0], a[1], a[2]) < std::hypot(b[0], b[1], b[2]) ? b : a, normal.data());
    }
    if (isTurned(sector) || !isOutwards(sector))
    {
      normal = { -normal[0], -normal[1], -normal[2] };
    }
    return normal;
  };
  ForEach(tangents.Sectors.GetNumberOfRows(),
    [&](vtkIdType v)
    {
      Vector sum = { 0., 0., 0. };
      Vector last = { 0., 0., 0. }; // in lexicographic order, whatever the order of sectors
      for (vtkIdType s = tangents.Sectors.Offsets[v]; s < tangents.Sectors.Offsets[v + 1]; ++s)
      {
        const Vector normal = normalOf(s);
        std::transform(normal.begin(), normal.end(), sum.begin(), sum.begin(), std::plus<>());
        last = s == tangents.Sectors.Offsets[v] ? normal : std::max(last, normal);
      }
      const Vector mean = Normalise(sum, 1e-6);
      const Vector& normal = Length(mean) > 0. ? mean : last;
      std::copy(normal.begin(), normal.end(), normals + 3 * v);
    });
}

template <typename Id>
void ComputeLimitNormals(const LimitTangents<Id>& tangents, const Coordinates& points,
  const std::vector<vtkIdType>& inverted, const Buffer<unsigned char>& turned, double* normals)
{
  ComputeSectorNormals(tangents, points, inverted, turned, normals);
  const Buffer<unsigned char> missing = tangents.FindMissing();
  ShadingNormals shading(points.Values, missing, normals);
  tangents.Shading.Fill(shading, turned);
}

SUBDIVISION_COMPILE_FUNCTION(ComputeSectorNormals);
SUBDIVISION_COMPILE_FUNCTION(ComputeLimitNormals);

}
