// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Operators/ShadingNormals.h"

#include "Core/Memory/Vectors.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>

namespace subdivision
{
namespace
{

using namespace vectors;

/// A sum shorter than this fraction of its terms has cancelled.
constexpr double Cancelled = 1e-6;

double Length(const double a[3])
{
  return std::hypot(a[0], a[1], a[2]);
}

bool IsLong(const double a[3], double least)
{
  const double length = Length(a);
  return length > least && std::isfinite(length);
}

Vector Scale(const double a[3], double factor)
{
  return { a[0] * factor, a[1] * factor, a[2] * factor };
}

/// Times `length`.
Vector Normalise(const double a[3], double length = 1.)
{
  const double own = Length(a);
  return { length * (a[0] / own), length * (a[1] / own), length * (a[2] / own) };
}

/// The longest vector; of equally long ones, but for rounding, the last in lexicographic order.
const Vector& FindLongest(const std::vector<Vector>& vectors)
{
  constexpr double equal = 1. - 1e-9;
  const Vector* longest = &vectors.front();
  double length = 0.;
  for (const Vector& vector : vectors)
  {
    length = std::max(length, Length(vector.data()));
  }
  for (const Vector& vector : vectors)
  {
    const bool isOther = Length(longest->data()) < equal * length || *longest < vector;
    longest = Length(vector.data()) >= equal * length && isOther ? &vector : longest;
  }
  return *longest;
}

/// Along the lines at a point.
Vector FindTangent(std::vector<Vector>& lines)
{
  std::sort(lines.begin(), lines.end());
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  if (lines.size() == 2)
  {
    const Vector chord = Subtract(lines[1].data(), lines[0].data());
    if (IsLong(chord.data(), Cancelled * (Length(lines[0].data()) + Length(lines[1].data()))))
    {
      return chord;
    }
  }
  return lines.empty() ? Vector{ 0., 0., 0. } : FindLongest(lines);
}

/// Adds vectors up. Returns whether they do not cancel.
bool AddUp(const std::vector<Vector>& parts, Vector& sum)
{
  sum = { 0., 0., 0. };
  double all = 0.;
  for (const Vector& part : parts)
  {
    all += Length(part.data());
    std::transform(part.begin(), part.end(), sum.begin(), sum.begin(), std::plus<>());
  }
  return IsLong(sum.data(), Cancelled * all);
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
  const Vector line = Normalise(vector);
  const auto far = std::min_element(
    line.begin(), line.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  Vector across = Scale(line.data(), -*far);
  across[far - line.begin()] += 1.;
  const Vector unit = Normalise(across.data());
  std::copy(unit.begin(), unit.end(), normal);
}

void ShadingStar::Clear()
{
  this->Corners.clear();
  this->Lines.clear();
}

void ShadingStar::AddCorner(
  const double a[3], const double b[3], const double middle[3], double sign)
{
  this->Corners.push_back(
    { { a[0], a[1], a[2] }, { b[0], b[1], b[2] }, { middle[0], middle[1], middle[2] }, sign });
}

void ShadingStar::AddLine(const double end[3])
{
  if (IsLong(end, 0.))
  {
    this->Lines.push_back({ end[0], end[1], end[2] });
  }
}

void ShadingStar::FindNormal(double normal[3])
{
  constexpr double parallel = 1e-9;
  double largest = 0.;
  for (const Corner& corner : this->Corners)
  {
    largest = std::max({ largest, Length(corner.A.data()), Length(corner.B.data()) });
  }
  // The normal times the angle, and the area; sums do not depend on the order.
  std::vector<std::pair<Vector, Vector>> parts;
  for (const Corner& corner : this->Corners)
  {
    if (!IsLong(corner.A.data(), 0.) || !IsLong(corner.B.data(), 0.))
    {
      continue;
    }
    const Vector a = Normalise(corner.A.data());
    const Vector b = Normalise(corner.B.data());
    const Vector cross = Cross(a, b);
    const double cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    const Vector side = Scale(Subtract(corner.B.data(), corner.A.data()).data(), 1. / largest);
    const Vector middle = Scale(corner.Middle.data(), 1. / largest);
    const Vector area = Cross(middle, side);
    // Sides in one line: the face beside them may have a normal.
    const bool isCorner = IsLong(cross.data(), parallel);
    if (isCorner || IsLong(area.data(), parallel * Length(middle.data()) * Length(side.data())))
    {
      parts.emplace_back(Normalise(isCorner ? cross.data() : area.data(),
                           corner.Sign * std::atan2(Length(cross.data()), cosine)),
        Scale(area.data(), corner.Sign));
    }
  }
  if (parts.empty())
  {
    for (const Corner& corner : this->Corners) // which have no width
    {
      this->AddLine(corner.A.data());
      this->AddLine(corner.B.data());
    }
    return FindPerpendicular(FindTangent(this->Lines).data(), normal);
  }
  std::sort(parts.begin(), parts.end());
  std::vector<Vector> angles;
  std::vector<Vector> areas;
  for (const auto& [ofAngle, area] : parts)
  {
    angles.push_back(ofAngle);
    areas.push_back(area);
  }
  Vector sum;
  if (!AddUp(angles, sum) && !AddUp(areas, sum))
  {
    sum = FindLongest(areas);
    sum = IsLong(sum.data(), 0.) ? sum : FindLongest(angles);
  }
  const Vector unit = Normalise(sum.data());
  std::copy(unit.begin(), unit.end(), normal);
}

namespace
{

/// Whether two rows have, but for their lengths, almost the same weights or the opposite ones, or
/// one of them is much shorter than the other.
bool AreNarrow(const double* a, const double* b, std::size_t size)
{
  constexpr double least = 1e-4;
  const double lengths[2] = { std::sqrt(std::inner_product(a, a + size, a, 0.)),
    std::sqrt(std::inner_product(b, b + size, b, 0.)) };
  if (std::min(lengths[0], lengths[1]) <= least * std::max(lengths[0], lengths[1]))
  {
    return true;
  }
  double squares[2] = { 0., 0. };
  for (std::size_t k = 0; k < size; ++k)
  {
    squares[0] += std::pow(a[k] / lengths[0] - b[k] / lengths[1], 2);
    squares[1] += std::pow(a[k] / lengths[0] + b[k] / lengths[1], 2);
  }
  return std::min(squares[0], squares[1]) < least * least;
}

}

std::vector<double> FindStarRows(const std::vector<double>& step, std::size_t size,
  const std::vector<std::array<int, 2>>& corners, int made)
{
  const std::size_t ends = size - 1;
  // Seen from the point, which moves too.
  std::vector<double> seen(ends * ends);
  std::vector<double> first(ends * size, 0.);
  for (std::size_t i = 0; i < ends; ++i)
  {
    for (std::size_t k = 0; k < ends; ++k)
    {
      seen[i * ends + k] = step[(i + 1) * size + k + 1] - step[k + 1];
    }
    first[i * size] = -1.;
    first[i * size + i + 1] = 1.;
  }
  const auto isNarrow = [&](const std::vector<double>& rows)
  {
    return std::any_of(corners.begin(), corners.end(),
      [&](const std::array<int, 2>& corner)
      {
        return AreNarrow(
          rows.data() + (corner[0] - 1) * size, rows.data() + (corner[1] - 1) * size, size);
      });
  };
  const auto advance = [&](std::vector<double>& rows)
  {
    std::vector<double> next(ends * size, 0.);
    for (std::size_t i = 0; i < ends; ++i)
    {
      for (std::size_t k = 0; k < ends; ++k)
      {
        const double weight = seen[i * ends + k];
        for (std::size_t j = 0; weight != 0. && j < size; ++j)
        {
          next[i * size + j] += weight * rows[k * size + j];
        }
      }
    }
    rows = std::move(next);
  };
  int level = 0;
  for (std::vector<double> rows = first; level < MostStepsOfStars && !isNarrow(rows); ++level)
  {
    advance(rows);
  }
  for (; level > made; --level)
  {
    advance(first);
  }
  return first;
}

}
