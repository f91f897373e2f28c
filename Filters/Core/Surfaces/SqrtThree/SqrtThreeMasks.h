// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SqrtThreeMasks.h
 * Weights of the sqrt(3) scheme (Mathematics 11).
 */
#ifndef SubdivisionObjects_SqrtThreeMasks_h
#define SubdivisionObjects_SqrtThreeMasks_h

#include "Core/Surfaces/Scheme/TurnedSectors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace subdivision
{

/// The weight of the mean of the n neighbours of a smooth vertex (Kobbelt, eq. 6).
inline double ComputeSqrtThreeRingWeight(int n)
{
  return (4. - 2. * std::cos(2. * Pi / n)) / 9.;
}

/// The same, without a cosine for usual valences.
inline double GetSqrtThreeRingWeight(int n)
{
  static const std::vector<double> usual = []()
  {
    std::vector<double> weights{ 0. };
    while (weights.size() <= 16)
    {
      weights.push_back(ComputeSqrtThreeRingWeight(static_cast<int>(weights.size())));
    }
    return weights;
  }();
  return n < static_cast<int>(usual.size()) ? usual[n] : ComputeSqrtThreeRingWeight(n);
}

/// The mask of a smooth vertex with six neighbours, and the mask of the centre of a face.
inline const std::array<double, 7> SqrtThreeVertex = []()
{
  std::array<double, 7> weights;
  const double ring = ComputeSqrtThreeRingWeight(6) / 6;
  weights.fill(ring);
  weights[0] = 1. - ring * 6;
  return weights;
}();
/// The limit masks of such a vertex, by LimitKind: its position and its tangents.
inline const std::array<std::array<double, 7>, 3> SqrtThreeLimits = []()
{
  std::array<std::array<double, 7>, 3> masks{};
  const double ring =
    3. * ComputeSqrtThreeRingWeight(6) / (1. + 3. * ComputeSqrtThreeRingWeight(6));
  masks[0][0] = 1. - ring;
  for (int j = 0; j < 6; ++j)
  {
    masks[0][j + 1] = ring / 6;
    masks[1][j + 1] = std::cos(2. * Pi * j / 6);
    masks[2][j + 1] = std::sin(2. * Pi * j / 6);
  }
  return masks;
}();
inline constexpr std::array<double, 3> SqrtThreeCentre{ 1. / 3., 1. / 3., 1. / 3. };

/// The weight g of each of the two other corners in the centre that an even step makes beside a
/// vertex on a curve, which has 1 - 2 g, by the angle of one face of the sector: the functions
/// cos(j angle) and sin(j angle) of its edges j shrink to 1/3 in two steps. Beyond 120 degrees,
/// which only two faces at a concave corner have, the weight stays 1.
inline double GetSqrtThreeFarWeight(double angle)
{
  return angle > 0. ? 1. / std::max(1., 2. + 2. * std::cos(angle)) : 1. / 3.;
}

/// The eigenvalue l3 of two steps at a corner, in a sector of k faces with this angle, times 9/4,
/// because flatness is to bring it to 1/9 where other schemes have 1/4.
inline double GetSqrtThreeThirdEigenvalue(int k, double angle)
{
  return k < 2          ? 0.
    : IsWide(angle / k) ? std::numeric_limits<double>::infinity() // the curves alone give the plane
                        : GetSqrtThreeFarWeight(angle / k) * 1.5 * (1. + std::cos(Pi / k));
}

/// The weights of the tangent across a curve in a sector of k triangles, on a level after an even
/// number of steps: of the vertex, of both end neighbours, and of the inner neighbours, sin(j pi /
/// k). They are a left eigenvector of two steps for the eigenvalue (2 + 2 cos(pi / k)) g / 3, where
/// g, `far`, is the weight of GetSqrtThreeFarWeight: for 1/3 then, and by the plain rule g is 1/3.
struct SqrtThreeTransversalMask
{
  explicit SqrtThreeTransversalMask(int k, double far = 1. / 3.)
    : Far(far)
  {
    double sum = 0.;
    for (int j = 0; j <= k; ++j)
    {
      this->Inside.push_back(j == 0 || j == k ? 0. : std::sin(j * Pi / k));
      sum += this->Inside.back();
    }
    if (k == 1)
    {
      this->Own = -2.;
      this->End = 1.;
      return;
    }
    const double value = (2. + 2. * std::cos(Pi / k)) * far / 3.;
    this->Eigenvalue = value;
    const double determinant = (value - 1.) * (value - 1. / 9.);
    const double end = this->Inside[1] * far / 3.;
    const double own = (1. - 4. / 3. * far) * sum;
    this->End = ((value - 19. / 27.) * end + 4. / 27. * own) / determinant;
    this->Own = ((value - 11. / 27.) * own + 32. / 27. * end) / determinant;
  }
  /// Changes the weights to weights for the level one step later. There the sector has k + 1
  /// triangles, and its inner neighbours are the centres of the k triangles.
  void MakeOdd()
  {
    const double sum = std::accumulate(this->Inside.begin(), this->Inside.end(), 0.);
    const double own = 19. / 27. * this->Own + 32. / 27. * this->End + (1. - 2. * this->Far) * sum;
    this->End = 11. / 27. * this->End + 4. / 27. * this->Own;
    this->Own = own;
    std::vector<double> inside{ 0. };
    for (std::size_t j = 1; j < this->Inside.size(); ++j)
    {
      inside.push_back((this->Inside[j - 1] + this->Inside[j]) * this->Far);
    }
    inside.push_back(0.);
    this->Inside = std::move(inside);
  }

  double Far;
  double Eigenvalue = 0.; ///< of two steps; none with one triangle
  double Own = 0.;
  double End = 0.;
  std::vector<double> Inside; ///< of all neighbours from end to end, 0 for the two ends
};

}

#endif
