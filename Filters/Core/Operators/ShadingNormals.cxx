// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/ShadingNormals.h"

#include "Core/Memory/Loops.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace subdivision
{
namespace
{

using Vector = std::array<double, 3>;

double Length(const double a[3])
{
  return std::hypot(a[0], a[1], a[2]);
}

bool IsLong(const double a[3], double least)
{
  const double length = Length(a);
  return length > least && std::isfinite(length);
}

void Normalise(const double a[3], double out[3])
{
  const double length = Length(a);
  std::transform(a, a + 3, out, [length](double value) { return value / length; });
}

/// The longest vector; of equally long ones the last in lexicographic order.
const Vector& FindLongest(const std::vector<Vector>& sorted)
{
  return *std::max_element(sorted.begin(), sorted.end(), [](const Vector& a, const Vector& b)
    { return std::make_pair(Length(a.data()), a) < std::make_pair(Length(b.data()), b); });
}

/// Along the lines at a point.
Vector FindTangent(std::vector<Vector>& lines)
{
  constexpr double turnsBack = 1e-6;
  std::sort(lines.begin(), lines.end());
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  if (lines.size() == 2)
  {
    const Vector& a = lines[0];
    const Vector& b = lines[1];
    const Vector chord = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
    if (IsLong(chord.data(), turnsBack * (Length(a.data()) + Length(b.data()))))
    {
      return chord;
    }
  }
  return lines.empty() ? Vector{ 0., 0., 0. } : FindLongest(lines);
}

}

void FindPerpendicular(const double vector[3], double normal[3])
{
  if (!IsLong(vector, 0.))
  {
    normal[0] = normal[1] = 0.;
    normal[2] = 1.;
    return;
  }
  double line[3];
  Normalise(vector, line);
  const auto far =
    std::min_element(line, line + 3, [](double a, double b) { return std::abs(a) < std::abs(b); });
  double across[3] = { -*far * line[0], -*far * line[1], -*far * line[2] };
  across[far - line] += 1.;
  Normalise(across, normal);
}

void ShadingNormals::AddTriangle(
  vtkIdType a, vtkIdType b, vtkIdType c, double sign, double normal[3]) const
{
  double u[3];
  double v[3];
  for (int i = 0; i < 3; ++i)
  {
    u[i] = this->Get(b, i) - this->Get(a, i);
    v[i] = this->Get(c, i) - this->Get(a, i);
  }
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    normal[i] += sign * (u[j] * v[k] - u[k] * v[j]);
  }
}

/// Adds the normal of a facet, unless it has no direction.
bool ShadingNormals::AddNormal(const double normal[3])
{
  const bool isFacet = IsLong(normal, 0.);
  if (isFacet)
  {
    this->FacetNormals.push_back({ normal[0], normal[1], normal[2] });
  }
  return isFacet;
}

/// Says that a point lies at the last facet, or at one without a normal.
void ShadingNormals::AddToFacet(vtkIdType point, bool isFacet)
{
  this->Found[point] |= IsThere;
  if (isFacet)
  {
    this->Facets.push_back({ point, static_cast<vtkIdType>(this->FacetNormals.size()) - 1 });
  }
}

void ShadingNormals::AddLine(vtkIdType a, vtkIdType b)
{
  for (const auto& [end, other] : { std::make_pair(a, b), std::make_pair(b, a) })
  {
    if (!this->IsMissing(end))
    {
      continue;
    }
    this->Found[end] |= IsThere;
    Vector line;
    for (int c = 0; c < 3; ++c)
    {
      line[c] = this->Get(other, c) - this->Get(end, c);
    }
    if (IsLong(line.data(), 0.) && !(this->FirstLines && (this->Found[end] & HasLine) != 0))
    {
      this->Found[end] |= HasLine;
      this->Lines.push_back({ end, line });
    }
  }
}

namespace
{

/// The numbers of parts, point by point.
template <typename Part>
Rows<vtkIdType> SortByPoint(const std::vector<Part>& parts, vtkIdType points)
{
  return ListByRow<vtkIdType>(
    points, static_cast<vtkIdType>(parts.size()), [&](vtkIdType i) { return parts[i].Point; },
    [](vtkIdType i) { return i; });
}

/// From the normals of the facets at a point, which are sorted: sums do not depend on their order.
void FindMean(std::vector<Vector>& facets, double normal[3])
{
  constexpr double cancelled = 1e-6;
  std::sort(facets.begin(), facets.end());
  Vector sum = { 0., 0., 0. };
  double area = 0.;
  for (const Vector& facet : facets)
  {
    area += Length(facet.data());
    std::transform(facet.begin(), facet.end(), sum.begin(), sum.begin(), std::plus<>());
  }
  Normalise(IsLong(sum.data(), cancelled * area) ? sum.data() : FindLongest(facets).data(), normal);
}

}

void ShadingNormals::Fill()
{
  const vtkIdType size = this->Found.size();
  const Rows<vtkIdType> facets = SortByPoint(this->Facets, size);
  const Rows<vtkIdType> lines = SortByPoint(this->Lines, size);
  ForRanges(size,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<Vector> star;
      for (vtkIdType point = begin; point < end; ++point)
      {
        if (this->Found[point] == 0)
        {
          continue;
        }
        star.clear();
        const bool hasFacets = facets[point].size() > 0;
        for (const vtkIdType i : hasFacets ? facets[point] : lines[point])
        {
          star.push_back(
            hasFacets ? this->FacetNormals[this->Facets[i].What] : this->Lines[i].What);
        }
        double* normal = this->Normals + 3 * point;
        hasFacets ? FindMean(star, normal) : FindPerpendicular(FindTangent(star).data(), normal);
      }
    });
  this->FacetNormals.clear();
  this->Facets.clear();
  this->Lines.clear();
  ForEach(size, [&](vtkIdType point) { this->Found[point] = 0; });
}

}
