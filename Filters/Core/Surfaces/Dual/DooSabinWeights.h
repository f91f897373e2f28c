// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DooSabinWeights.h
 * Weights of the Doo-Sabin scheme (Mathematics 12).
 */
#ifndef SubdivisionObjects_DooSabinWeights_h
#define SubdivisionObjects_DooSabinWeights_h

#include "Core/Rules/Pi.h"

#include "vtkType.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace subdivision
{

/// The weights of a face's corners, counted from the one where the new vertex is.
inline void FindCornerWeights(vtkIdType k, std::vector<double>& weights)
{
  weights.resize(k);
  const double size = static_cast<double>(k);
  weights[0] = 1. / 4. + 5. / (4. * size);
  for (vtkIdType j = 1; j < k; ++j)
  {
    const double angle = 2. * Pi * static_cast<double>(std::min(j, k - j)) / size;
    weights[j] = (3. + 2. * std::cos(angle)) / (4. * size);
  }
}

/// The same for a quad.
inline const std::array<double, 4> DooSabinQuad = []()
{
  std::vector<double> weights;
  FindCornerWeights(4, weights);
  return std::array<double, 4>{ weights[0], weights[1], weights[2], weights[3] };
}();

}

#endif
