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

/// Whether normals of sectors point against the cross products of their tangents.
template <typename Id>
class SectorTurns
{
public:
  SectorTurns(const LimitTangents<Id>& tangents, const std::vector<vtkIdType>& inverted,
    const Buffer<unsigned char>& turned)
    : Tangents(tangents)
    , Inverted(inverted)
    , Turned(turned)
  {
  }
  bool IsTurned(vtkIdType sector) const
  {
    const Id triangle = this->Tangents.Triangles[sector];
    return (triangle >= 0 && !this->Turned.empty() && this->Turned[triangle] != 0) ||
      !this->IsOutwards(sector);
  }

private:
  /// Whether most triangles of a sector have their solid behind them; true without solids.
  bool IsOutwards(vtkIdType sector) const
  {
    vtkIdType outwards = 0;
    for (vtkIdType i = this->Tangents.SideOffsets[sector];
      i < this->Tangents.SideOffsets[sector + 1]; ++i)
    {
      outwards += subdivision::IsOutwards(this->Tangents.Sides[i], this->Inverted) ? 1 : -1;
    }
    return outwards >= 0;
  }

  const LimitTangents<Id>& Tangents;
  const std::vector<vtkIdType>& Inverted;
  const Buffer<unsigned char>& Turned;
};

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
  const double largest = FindLargest(points.Values, 3 * tangents.First.GetNumberOfColumns());
  auto getError = [&](const SparseRows<Id>& rows, vtkIdType sector, bool isBound)
  {
    const vtkIdType begin = rows.Offsets[sector];
    const vtkIdType size = rows.Offsets[sector + 1] - begin;
    const double* weights = rows.Weights.data() + begin;
    return isBound ? GetTangentBound(weights, size, largest, points.GetUnit())
                   : GetTangentError(
                       rows.Columns.data() + begin, weights, size, points.Values, points.GetUnit());
  };
  const SectorTurns<Id> turns(tangents, inverted, turned);
  auto normalOf = [&](vtkIdType sector)
  {
    Vector normal;
    FindSectorNormal(
      first.data() + 3 * sector, second.data() + 3 * sector,
      [&](bool isBound)
      {
        return getError(tangents.First, sector, isBound) +
          getError(tangents.Second, sector, isBound);
      },
      turns.IsTurned(sector), normal.data());
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
      const bool isOne = tangents.Sectors.Offsets[v + 1] - tangents.Sectors.Offsets[v] == 1;
      const Vector mean = isOne ? last : Normalise(sum, 1e-6);
      const Vector& normal = Length(mean) > 0. ? mean : last;
      std::copy(normal.begin(), normal.end(), normals + 3 * v);
    });
}

template <typename Id>
void ComputeLimitTangents(const LimitTangents<Id>& tangents, const Coordinates& points,
  const std::vector<vtkIdType>& inverted, const Buffer<unsigned char>& turned, double* first,
  double* second)
{
  const vtkIdType sectors = tangents.GetNumberOfSectors();
  Buffer<double> ofSectors[2] = { Buffer<double>(3 * sectors), Buffer<double>(3 * sectors) };
  tangents.First.Apply(points.Values, ofSectors[0].data(), 3);
  tangents.Second.Apply(points.Values, ofSectors[1].data(), 3);
  const SectorTurns<Id> turns(tangents, inverted, turned);
  ForEach(tangents.Sectors.GetNumberOfRows(),
    [&](vtkIdType v)
    {
      const vtkIdType sector = tangents.Sectors.Offsets[v];
      const bool hasSector = sector < tangents.Sectors.Offsets[v + 1];
      const vtkIdType from = tangents.AlongCurves[2 * v];
      const vtkIdType to = tangents.AlongCurves[2 * v + 1];
      const double sign = hasSector && turns.IsTurned(sector) ? -1. : 1.;
      for (int c = 0; c < 3; ++c)
      {
        first[3 * v + c] = hasSector ? ofSectors[0][3 * sector + c]
          : from >= 0                ? points.Values[3 * to + c] - points.Values[3 * from + c]
                                     : 0.;
        second[3 * v + c] = hasSector ? sign * ofSectors[1][3 * sector + c] : 0.;
      }
    });
}

template <typename Id>
void ComputeLimitNormals(const LimitTangents<Id>& tangents, const Coordinates& points,
  const std::vector<vtkIdType>& inverted, const Buffer<unsigned char>& turned, double* normals)
{
  ComputeSectorNormals(tangents, points, inverted, turned, normals);
  tangents.Shading.Fill(points.Values, inverted, turned, normals);
}

SUBDIVISION_COMPILE_FUNCTION(ComputeSectorNormals);
SUBDIVISION_COMPILE_FUNCTION(ComputeLimitTangents);
SUBDIVISION_COMPILE_FUNCTION(ComputeLimitNormals);

}
