// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RegularPatch.h
 * The polynomial that is the limit over a regular face or line (Mathematics 8, 12).
 *
 * Over a quad of Catmull-Clark's scheme it is bicubic, over a triangle of Loop's scheme quartic, on
 * a line cubic. It has 16, 12 or 4 control points: the vertices of the face and around it. Beyond a
 * curve these are mirrored, so that the uniform spline follows the rules of the curve.
 */
#ifndef SubdivisionObjects_RegularPatch_h
#define SubdivisionObjects_RegularPatch_h

#include "Core/Operators/SplineColumns.h"
#include "Core/Surfaces/Scheme/SurfaceScheme.h"

#include <utility>
#include <vector>

namespace subdivision
{

/// The vertices and weights that a control point is the sum of.
template <typename Id>
using ControlPoint = std::vector<std::pair<Id, double>>;

enum class PolynomialDomain
{
  Line,
  Triangle,
  Quad
};

template <typename Id>
struct RegularPatch
{
  PolynomialDomain Domain = PolynomialDomain::Line;
  std::vector<ControlPoint<Id>> Points;

  /// Finds the control points over a face or a line. False: it is not regular, or rules near it are
  /// not. All faces must have the number of corners of the scheme.
  bool FindFace(const SurfaceLevel<Id>& level, Id face);
  bool FindLine(const SurfaceLevel<Id>& level, Id edge);
};

/// Finds the columns of a face inside of a regular surface. False: it is none of these.
template <typename Id>
bool FindSplineColumns(const SurfaceLevel<Id>& level, Id face, SplineColumns<Id>& columns);

/// The vertices of a level that the control points are sums of.
template <typename Id>
struct PatchColumns
{
  struct Entry
  {
    int Point;
    int Column;
    double Weight;
  };

  PatchColumns() = default;
  explicit PatchColumns(const RegularPatch<Id>& patch);

  PolynomialDomain Domain = PolynomialDomain::Line;
  std::vector<Id> Vertices; ///< ascending
  std::vector<Entry> Entries;
};

}

#endif
