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

#include <array>
#include <vector>

namespace subdivision
{

/// The vertices and weights that a control point is the sum of.
template <typename Id>
struct ControlPoint
{
  struct Entry
  {
    Id Vertex;
    double Weight;
  };

  static ControlPoint Of(Id vertex) { return ControlPoint().Add(vertex, 1.); }
  ControlPoint& Add(Id vertex, double weight)
  {
    this->Entries[this->Size++] = { vertex, weight };
    return *this;
  }
  ControlPoint& Add(const ControlPoint& point, double factor)
  {
    for (const Entry& entry : point)
    {
      this->Add(entry.Vertex, factor * entry.Weight);
    }
    return *this;
  }
  bool empty() const { return this->Size == 0; }
  const Entry* begin() const { return this->Entries.data(); }
  const Entry* end() const { return this->begin() + this->Size; }

  int Size = 0;

private:
  std::array<Entry, 6> Entries; ///< five in a triangle between two curves, four in a quad
};

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
  /// Takes the columns over a face inside of a regular surface. False: it is none of these.
  bool TakeColumns(SplineColumns<Id>& columns) const;
};

/// Where a place is: on a line x goes from the first vertex of the edge to the second one. In a
/// face the corners are at (0, 0), (1, 0), then (0, 1), or (1, 1) and (0, 1).
using PlaceAt = std::array<double, 2>;

/// Sets the wanted PlaceParts for the control points of a regular patch. There is no derivative by
/// a third parameter.
void WeightControlPoints(PolynomialDomain domain, const PlaceAt& at,
  const PatchDirections& directions, PlaceDerivatives derivatives, PatchParts& parts);

/// Of the corners of a part that counts as flat: linear, or bilinear.
PatchParts WeightCorners(int corners, const PlaceAt& at, const PatchDirections& directions);

}

#endif
