// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SolidTurns.h
 * The direction of a triangle on a solid.
 */
#ifndef SubdivisionObjects_SolidTurns_h
#define SubdivisionObjects_SolidTurns_h

#include "Core/Solids/Complex/SimplicialComplex.h"

namespace subdivision
{

/// Of a permutation: 1 for even, -1 for odd.
template <int Size>
int GetParity(const int (&places)[Size])
{
  int sign = 1;
  for (int i = 0; i < Size; ++i)
  {
    for (int j = i + 1; j < Size; ++j)
    {
      sign = places[i] > places[j] ? -sign : sign;
    }
  }
  return sign;
}

/// The direction of a face of a tetrahedron, seen from outside a positive one: 1 if its vertices in
/// this order run counterclockwise, -1 if clockwise.
template <typename Id>
int GetTurnOnTet(const SimplicialComplex<Id>& complex, Id tet, const Id (&triangle)[3])
{
  int places[4];
  places[3] = 6;
  for (int k = 0; k < 3; ++k)
  {
    places[k] = complex.VertexInTet(tet, triangle[k]);
    places[3] -= places[k];
  }
  return -GetParity(places);
}

}

#endif
