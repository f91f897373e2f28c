// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlaceLimits.h
 * Limits at any place of curves, triangles and tetrahedra of a level, with derivatives
 * (Mathematics 8).
 *
 * Where all is regular around a simplex of a curve or surface, the limit over it is a polynomial of
 * degree 3 or 4. It is found from the limits of the vertices that divide the edges in four
 * (LocalLimit.h), and so needs no other mechanism for its basis. A simplex that is not regular is
 * split, and the part with the place is looked at, until it is regular or so small that a
 * polynomial is the limit but for rounding. The limits of its vertices are passed back from level
 * to level, so that derivatives are exact however small the part is (PlaceSum.h, SharpLattice.h).
 * Polynomials of large parts of curves and sheets are found once for all simplices with the same
 * neighbourhood (PatchPolynomials.h), and inside of regular sheets they are those of the box spline
 * (SplineColumns.h). In solids each place has a row of its own (SolidPlaces.h).
 */
#ifndef SubdivisionObjects_PlaceLimits_h
#define SubdivisionObjects_PlaceLimits_h

#include "Core/Memory/Loops.h"
#include "Core/Operators/PlaceParts.h"
#include "Core/Solids/Limits/LimitStencils.h"

#include <array>
#include <vector>

namespace subdivision
{

template <typename Id>
struct LimitPlace
{
  int Dimension = 0;                               ///< of the simplex
  std::array<Id, 4> Corners{ { -1, -1, -1, -1 } }; ///< in the order in which it is split
  /// Which of these corners is the first, second, ... one for who asks.
  std::array<int, 4> Order{ { 0, 1, 2, 3 } };
  /// The weights of the second, third and fourth corner in that order; the first has the rest.
  std::array<double, 3> Parameters{ { 0., 0., 0. } };
};

template <typename Id>
struct PlaceLimits
{
  /// `level` was made with Depth::ForRefinement, or is the control level.
  template <typename LevelType>
  PlaceLimits(const LevelType& level, const SemiSharpStages<Id>& creases,
    const std::vector<LimitPlace<Id>>& places, PlaceDerivatives derivatives);

  PlaceRows<Id> Rows;
};

/// use(first, limits) for a part of the places after the other: few, so that their rows take little
/// memory and a user can stop between them. Rows in solids have far more entries.
template <typename Id, typename LevelType, typename Use>
void ForPartsOfPlaces(const LevelType& level, const SemiSharpStages<Id>& creases,
  const std::vector<LimitPlace<Id>>& places, PlaceDerivatives derivatives, const Use& use)
{
  constexpr int most = 8192;
  constexpr int weightOfSolid = 32;
  std::vector<LimitPlace<Id>> part;
  int weight = 0;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    part.push_back(places[i]);
    weight += places[i].Dimension == 3 ? weightOfSolid : 1;
    if (weight >= most || i + 1 == places.size())
    {
      use(static_cast<vtkIdType>(i + 1 - part.size()),
        PlaceLimits<Id>(level, creases, part, derivatives));
      BetweenLoops::Act();
      part.clear();
      weight = 0;
    }
  }
}

}

#endif
