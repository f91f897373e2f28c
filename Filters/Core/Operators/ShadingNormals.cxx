// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/ShadingNormals.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace subdivision
{
namespace
{

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
  Sum& sum = this->Sums[point];
  if (!IsLong(normal, 0.))
  {
    return;
  }
  if (sum.Area == 0.)
  {
    std::copy_n(normal, 3, sum.First);
  }
  sum.Area += Length(normal);
  std::transform(normal, normal + 3, sum.Facets, sum.Facets, std::plus<>());
}

void ShadingNormals::AddLine(vtkIdType a, vtkIdType b)
{
  for (const vtkIdType end : { a, b })
  {
    if (!this->IsMissing(end))
    {
      continue;
    }
    double* line = this->Sums[end].Line;
    if (!IsLong(line, 0.))
    {
      for (int c = 0; c < 3; ++c)
      {
        line[c] = this->Get(b, c) - this->Get(a, c);
      }
    }
  }
}

void ShadingNormals::Write(const Sum& sum, double normal[3]) const
{
  constexpr double cancelled = 1e-6;
  if (IsLong(sum.Facets, cancelled * sum.Area))
  {
    Normalise(sum.Facets, normal);
  }
  else if (sum.Area > 0. && IsLong(sum.First, 0.))
  {
    Normalise(sum.First, normal);
  }
  else if (IsLong(sum.Line, 0.))
  {
    // Perpendicular to the line, in the plane of the line and that axis to which it is least
    // parallel.
    double line[3];
    Normalise(sum.Line, line);
    const auto far = std::min_element(
      line, line + 3, [](double a, double b) { return std::abs(a) < std::abs(b); });
    double across[3] = { -*far * line[0], -*far * line[1], -*far * line[2] };
    across[far - line] += 1.;
    Normalise(across, normal);
  }
  else
  {
    normal[0] = normal[1] = 0.;
    normal[2] = 1.;
  }
}

void ShadingNormals::Fill()
{
  for (const auto& entry : this->Sums)
  {
    this->Write(entry.second, this->Normals + 3 * entry.first);
  }
  this->Sums.clear();
}

}
