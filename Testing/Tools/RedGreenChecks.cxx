// SPDX-License-Identifier: BSD-3-Clause
#include "RedGreenChecks.h"

namespace redgreen_reference
{

void AddFaces(PartsOfCell& parts, const Tuple& cell, const Cell& points)
{
  for (int pattern = 1; pattern < 1 << cell.size(); ++pattern)
  {
    Tuple face;
    Cell corners;
    for (std::size_t i = 0; i < cell.size(); ++i)
    {
      if (pattern >> i & 1)
      {
        face.push_back(cell[i]);
        corners.push_back(points[i]);
      }
    }
    const Tuple support = Support(corners);
    if (support.size() == face.size())
    {
      parts.Inside[support].insert(Sorted(face));
    }
    if (face.size() + 1 == cell.size())
    {
      ++parts.Facets[Sorted(face)];
    }
  }
}

Corners GetCorners(const Tuple& cell, const std::vector<double>& points)
{
  Corners corners;
  for (vtkIdType v : cell)
  {
    corners.push_back({ { points[3 * v], points[3 * v + 1], points[3 * v + 2] } });
  }
  return corners;
}

double Measure(const Corners& c)
{
  Matrix4 gram{};
  for (std::size_t i = 1; i < c.size(); ++i)
  {
    for (std::size_t j = 1; j < c.size(); ++j)
    {
      for (int x = 0; x < 3; ++x)
      {
        gram[i - 1][j - 1] += (c[i][x] - c[0][x]) * (c[j][x] - c[0][x]);
      }
    }
  }
  return std::sqrt(std::max(0., Determinant(gram, static_cast<int>(c.size()) - 1)));
}

double Quality(const Corners& c)
{
  double longest = 0.;
  for (const auto& a : c)
  {
    for (const auto& b : c)
    {
      longest = std::max(longest, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
    }
  }
  return longest > 0. ? Measure(c) / std::pow(longest, static_cast<double>(c.size() - 1)) : 0.;
}

double WorstGreen(const Corners& cell)
{
  double worst = Quality(cell);
  const int size = static_cast<int>(cell.size());
  for (int i = 0; i < size && size > 2; ++i)
  {
    for (int j = 0; j < i; ++j)
    {
      for (const Corners& half : Bisect(cell, i, j))
      {
        worst = std::min(worst, Quality(half));
        if (size == 4)
        {
          int rest[2];
          int* next = rest;
          for (int k = 0; k < 4; ++k)
          {
            if (k != i && k != j)
            {
              *next++ = k;
            }
          }
          for (const Corners& quarter : Bisect(half, rest[0], rest[1]))
          {
            worst = std::min(worst, Quality(quarter));
          }
        }
      }
    }
  }
  for (int apex = 0; apex < 4 && size == 4; ++apex)
  {
    Corners face = cell;
    face.erase(face.begin() + apex);
    const auto a = MiddleOf(face[0], face[1]);
    const auto b = MiddleOf(face[1], face[2]);
    const auto c = MiddleOf(face[0], face[2]);
    for (const Corners& part :
      { Corners{ face[0], a, c, cell[apex] }, Corners{ face[1], a, b, cell[apex] },
        Corners{ face[2], b, c, cell[apex] }, Corners{ a, b, c, cell[apex] } })
    {
      worst = std::min(worst, Quality(part));
    }
  }
  return worst;
}

double WorstGreenOfDescendants(const Corners& cell, int levels)
{
  double worst = WorstGreen(cell);
  if (levels == 0 || cell.size() < 2)
  {
    return worst;
  }
  Cell symbols;
  for (std::size_t i = 0; i < cell.size(); ++i)
  {
    symbols.push_back({ { static_cast<vtkIdType>(i), 1. } });
  }
  for (const Cell& child : RedChildren(symbols))
  {
    Corners corners;
    for (const Key& point : child)
    {
      std::array<double, 3> p{ { 0., 0., 0. } };
      for (const auto& entry : point)
      {
        for (int x = 0; x < 3; ++x)
        {
          p[x] += entry.second * cell[entry.first][x];
        }
      }
      corners.push_back(p);
    }
    worst = std::min(worst, WorstGreenOfDescendants(corners, levels - 1));
  }
  return worst;
}

}
