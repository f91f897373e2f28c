// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SheetLimits.h
 * Limits of values at vertices of a local refinement and at places of its edges and faces, where
 * these lie on curves or in sheets (SheetRows.h). The levels are made as LocalLimit makes them, but
 * none beyond that on which the vertices exist: rows of equal neighbourhoods lead from there to the
 * places. So it takes a small part of the time and memory of LocalLimit, and rounds differently.
 */
#ifndef SubdivisionObjects_SheetLimits_h
#define SubdivisionObjects_SheetLimits_h

#include "Core/Memory/Buffer.h"
#include "Core/Solids/Limits/LocalVertices.h"
#include "Core/Solids/Limits/PatchPolynomials.h"

#include <array>
#include <vector>

namespace subdivision
{

/// An edge or a face of the uniform refinement. Its places are those of SheetRows.h, in the order
/// of the corners.
template <typename Id>
struct LimitSite
{
  std::array<Id, 3> Corners{ { -1, -1, -1 } }; ///< an edge has two
  bool IsFace() const { return this->Corners[2] >= 0; }
};

template <typename Id>
class SheetLimits
{
public:
  static constexpr int PlacesOfSite = 3;

  /// `midpoints`, `wanted`: as in the constructor of LocalLimit, and corners of sites are numbers
  /// of these vertices, which must exist as corners of the leaves of a red-green refinement.
  /// `values`: at the control vertices, interleaved. `known`: rows to use and to add to, if any.
  template <typename LevelType>
  SheetLimits(const LevelType& control, const std::vector<std::array<Id, 2>>& midpoints,
    const Buffer<unsigned char>& wanted, const std::vector<LimitSite<Id>>& sites,
    const double* values, int components, KnownSheetRows* known = nullptr);

  /// The values at the wanted vertices, and at the three places of each site. They are not a number
  /// where something lies neither on a curve nor in a sheet, or depends on values that are none.
  Buffer<double> OfVertices;
  Buffer<double> OfSites;

private:
  template <typename LevelType>
  class Finder;
};

}

#endif
