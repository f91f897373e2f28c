// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/ShadingNormals.h"

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

void ShadingNormals::AddTo(vtkIdType point, const double normal[3])
{
  Star& star = this->Stars[point];
  if (IsLong(normal, 0.))
  {
    star.Facets.push_back({ normal[0], normal[1], normal[2] });
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
    Vector line;
    for (int c = 0; c < 3; ++c)
    {
      line[c] = this->Get(other, c) - this->Get(end, c);
    }
    Star& star = this->Stars[end];
    if (IsLong(line.data(), 0.) && !(this->FirstLines && !star.Lines.empty()))
    {
      star.Lines.push_back(line);
    }
  }
}

void ShadingNormals::Write(Star& star, double normal[3])
{
  constexpr double cancelled = 1e-6;
  if (star.Facets.empty())
  {
    FindPerpendicular(FindTangent(star.Lines).data(), normal);
    return;
  }
  std::sort(star.Facets.begin(), star.Facets.end()); // sums do not depend on the order of facets
  Vector sum = { 0., 0., 0. };
  double area = 0.;
  for (const Vector& facet : star.Facets)
  {
    area += Length(facet.data());
    std::transform(facet.begin(), facet.end(), sum.begin(), sum.begin(), std::plus<>());
  }
  Normalise(
    IsLong(sum.data(), cancelled * area) ? sum.data() : FindLongest(star.Facets).data(), normal);
}

void ShadingNormals::Fill()
{
  for (auto& [point, star] : this->Stars)
  {
    Write(star, this->Normals + 3 * point);
  }
  this->Stars.clear();
}

}
