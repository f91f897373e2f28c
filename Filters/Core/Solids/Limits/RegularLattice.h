// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RegularLattice.h
 * Where the tetrahedra of a control level lie as in the regular lattice, of which the limit of the
 * box-spline scheme is a polynomial over each tetrahedron (BoxSplinePatch.h).
 */
#ifndef SubdivisionObjects_RegularLattice_h
#define SubdivisionObjects_RegularLattice_h

#include "Core/Solids/Limits/SharpLattice.h"

#include <array>

namespace subdivision
{

template <typename Id>
class RegularLattice
{
public:
  /// Both must outlive this; the lattice is of the level.
  RegularLattice(const Level<Id>& level, const SharpLattice<Id, BoxSplineLattice<Id>>& lattice)
    : Complex(level.Complex)
    , Strata(level.Strata)
    , Lattice(lattice)
  {
  }

  /// Inside which parts of a tetrahedron all is like in the regular lattice, by the corners of the
  /// part, one bit for each.
  std::array<bool, 16> FindRegularParts(Id tet) const;
  /// The vertex with some weights of the corners of a tetrahedron. Where some are negative it lies
  /// in other tetrahedra of the lattice. False if the way to it leads through a face that is not
  /// regular.
  bool Find(Id tet, LatticeWeights weights, LatticeVertex<Id>& vertex) const;

private:
  bool IsRegularFace(Id face) const;
  bool IsRegularEdge(Id edge) const;
  bool IsRegularVertex(Id vertex) const;
  Id GetMarkedEdge(Id tet, int face) const;

  const SimplicialComplex<Id>& Complex;
  const subdivision::Strata<Id>& Strata;
  const SharpLattice<Id, BoxSplineLattice<Id>>& Lattice;
};

}

#endif
