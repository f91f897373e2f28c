// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SolidMaps.h
 * Spectra and characteristic maps of volume schemes around a vertex, an edge or a face inside a
 * solid, by steps of the scheme on the tetrahedra there.
 */
#ifndef SubdivisionObjects_SolidMaps_h
#define SubdivisionObjects_SolidMaps_h

#include "Core/Smoothness/StarMap.h"
#include "Core/Solids/Scheme/SolidScheme.h"

#include <array>
#include <vector>

namespace subdivision
{

/**
 * All control tetrahedra at a vertex, an edge or a face that lies inside a solid, or one
 * tetrahedron, in the order of their vertices that the scheme wants. They number the vertices; the
 * first ones, as many as `Corners` says, are the corners of the vertex, edge, face or tetrahedron.
 */
struct SolidStar
{
  int Corners = 1;
  std::vector<std::array<int, 4>> Tets;
};

/// The star of a vertex with other numbers and another order of tetrahedra: stars that differ only
/// in these get the same ones. `marks`: whether the order of the vertices of a tetrahedron matters,
/// which then marks its edges 02 and 13. Stars that do not close around the vertex stay.
SolidStar OrderStar(const SolidStar& star, bool marks);

/**
 * Of an edge the vertex in its middle after one step is examined, of a face one of the three inside
 * it after two, of a tetrahedron the one in its middle. Sets eigenvalues and condition, and, where
 * the condition holds and `samples`, looks at the characteristic map. It takes the eigenvectors of
 * l1, l2, l3 one step further, as coordinates of the vertices up to twice as far as the solids at
 * the vertex go. It is regular if all tetrahedra of that level which do not touch the vertex, but
 * go no farther than three times as far as the ones at the vertex, have the same orientation; a
 * step repeats the space between. It is injective too if the tetrahedra at the vertex go around it
 * once: they, and all their images by further steps, then cover space once.
 * Stars of too many tetrahedra are not examined (LocalMatrix.h): all eigenvalues are 0.
 */
template <typename Scheme>
SmoothnessFacts ExamineSolid(const SolidStar& star, bool samples);

/// The characteristic map itself, after `levels` further steps, 1 or more, as far as it is known.
/// It is empty where l3 = l4, so that it is not unique.
template <typename Scheme>
StarMap MapSolid(const SolidStar& star, int levels);

/// How many tetrahedra such a map may have.
double CountCellsOfMap(const SolidStar& star, int levels);

}

#endif
