// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LatticeCorners.h
 * The corners of a part of a control simplex as vertices of a lattice (BoxSplineLattice.h).
 */
#ifndef SubdivisionObjects_LatticeCorners_h
#define SubdivisionObjects_LatticeCorners_h

#include "Core/Solids/Limits/BoxSplineLattice.h"
#include "Core/Solids/Limits/PlacePolynomial.h"

#include <array>

namespace subdivision
{

/// The weights of each corner of a part; the corners of the simplex itself have a single 1.
using LatticeCorners = std::array<LatticeWeights, 4>;

/// A sum of the corners of a part, each as often as the factors say.
inline LatticeWeights CombineCorners(
  const LatticeCorners& corners, const std::array<int, 4>& factors)
{
  LatticeWeights weights{};
  for (int i = 0; i < 4; ++i)
  {
    for (int k = 0; k < 4; ++k)
    {
      weights[k] += factors[i] * corners[i][k];
    }
  }
  return weights;
}

/// Goes from the corners of a part to the corners of a child, which are on the next level.
inline void GoToChild(int dimension, int child, LatticeCorners& corners)
{
  const LatticeCorners before = corners;
  for (int i = 0; i <= dimension; ++i)
  {
    std::array<int, 4> factors{};
    for (const int corner : ListChildren(dimension)[static_cast<std::size_t>(child)].Corners[i])
    {
      ++factors[corner];
    }
    corners[i] = CombineCorners(before, factors);
  }
}

}

#endif
