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

/// The limit masks of a vertex with four quads all around, by LimitKind: its position and its
/// tangents, which are those of the four corners that a step makes around it. The weights of the
/// vertex, of its neighbours, and of the vertices opposite to it; quad j begins at neighbour j.
inline const std::array<std::array<double, 9>, 3> DooSabinLimitsOfQuads = []()
{
  constexpr double ofCorner[3][4] = { { 0.25, 0.25, 0.25, 0.25 }, { 1., 0., -1., 0. },
    { 0., 1., 0., -1. } };
  std::array<std::array<double, 9>, 3> masks{};
  for (int kind = 0; kind < 3; ++kind)
  {
    for (int j = 0; j < 4; ++j)
    {
      masks[kind][0] += ofCorner[kind][j] * DooSabinQuad[0];
      masks[kind][1 + j] += ofCorner[kind][j] * DooSabinQuad[1];
      masks[kind][1 + (j + 1) % 4] += ofCorner[kind][j] * DooSabinQuad[3];
      masks[kind][5 + j] = ofCorner[kind][j] * DooSabinQuad[2];
    }
  }
  return masks;
}();

}

#endif
