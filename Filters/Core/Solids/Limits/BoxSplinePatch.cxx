// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/BoxSplinePatch.h"

#include <algorithm>
#include <cmath>

namespace subdivision
{
namespace
{

/// Of the three directions of the lattice; the fourth has 0.
std::array<double, 4> GetCoordinates(const CornerWeights& weights)
{
  return { { weights[1] + weights[2] + weights[3], weights[2] + weights[3], weights[3], 0. } };
}

/// Sums of all nodes with steps of -1 to 2.
class NodeSums
{
public:
  std::array<double, PlaceParts::Count>& At(const int (&steps)[3])
  {
    return this
      ->Sums[static_cast<std::size_t>(16 * (steps[0] + 1) + 4 * (steps[1] + 1) + steps[2] + 1)];
  }
  std::vector<BoxSplineNode> List() const
  {
    std::vector<BoxSplineNode> nodes;
    for (int i = 0; i < 64; ++i)
    {
      const auto& sums = this->Sums[static_cast<std::size_t>(i)];
      if (std::any_of(sums.begin(), sums.end(), [](double sum) { return sum != 0.; }))
      {
        nodes.push_back({ { { i / 16 - 1, i / 4 % 4 - 1, i % 4 - 1 } }, sums });
      }
    }
    return nodes;
  }

private:
  std::array<std::array<double, PlaceParts::Count>, 64> Sums{};
};

/// The values of two hat functions that are not 0 at each of four numbers, and their slopes.
struct Hats
{
  double Values[4][2];
  static constexpr double Slopes[2] = { -1., 1. };

  /// The product for a choice of one function at each number, some of which are replaced by their
  /// slopes.
  double Multiply(const int (&choice)[4], int a = -1, int b = -1) const
  {
    double product = 1.;
    for (int i = 0; i < 4; ++i)
    {
      product *= i == a || i == b ? Slopes[choice[i]] : this->Values[i][choice[i]];
    }
    return product;
  }
};

}

std::vector<BoxSplineNode> WeightBoxSpline(
  const CornerWeights& at, const std::array<CornerWeights, 3>& directions)
{
  const std::array<double, 4> x = GetCoordinates(at);
  std::array<std::array<double, 4>, 3> slopes;
  std::transform(directions.begin(), directions.end(), slopes.begin(), GetCoordinates);
  // The integral does not change if all four numbers do, so that the sum of all derivatives is 0.
  // This leaves second derivatives by two different numbers.
  const auto mix = [&](int d, int e, int i, int k)
  { return -(slopes[d][i] - slopes[d][k]) * (slopes[e][i] - slopes[e][k]); };
  NodeSums sums;
  for (int interval = 0; interval < 4; ++interval)
  {
    const double begin = interval == 0 ? 0. : 1. - x[interval - 1];
    const double end = 1. - x[interval];
    for (int point = -1; point <= 1; ++point)
    {
      const double s = 0.5 * (begin + end) + 0.5 * (end - begin) * std::sqrt(0.6) * point;
      const double weight = (end - begin) * (point == 0 ? 8. : 5.) / 18.;
      Hats hats;
      for (int i = 0; i < 4; ++i)
      {
        hats.Values[i][1] = x[i] + s - (i < interval ? 1. : 0.);
        hats.Values[i][0] = 1. - hats.Values[i][1];
      }
      for (int number = 0; number < 16; ++number)
      {
        const int choice[4] = { number & 1, number >> 1 & 1, number >> 2 & 1, number >> 3 };
        int steps[3];
        for (int i = 0; i < 3; ++i)
        {
          steps[i] = choice[i] + (i < interval ? 1 : 0) - choice[3];
        }
        auto& parts = sums.At(steps);
        parts[PlaceParts::Value] += weight * hats.Multiply(choice);
        for (int i = 0; i < 4; ++i)
        {
          const double slope = weight * hats.Multiply(choice, i);
          for (int d = 0; d < 3; ++d)
          {
            parts[PlaceParts::First + d] += slopes[d][i] * slope;
          }
          for (int k = 0; k < i; ++k)
          {
            const double mixed = weight * hats.Multiply(choice, i, k);
            parts[PlaceParts::Second] += mix(0, 0, i, k) * mixed;
            parts[PlaceParts::Mixed] += mix(0, 1, i, k) * mixed;
            parts[PlaceParts::SecondOfSecond] += mix(1, 1, i, k) * mixed;
          }
        }
      }
    }
  }
  return sums.List();
}

}
