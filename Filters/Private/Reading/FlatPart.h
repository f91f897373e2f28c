// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FlatPart.h
 * Which points lie on an edge or on a face.
 */
#ifndef SubdivisionObjects_FlatPart_h
#define SubdivisionObjects_FlatPart_h

#include "Core/Memory/Vectors.h"
#include "Core/Solids/Location/Box.h"

#include <vector>

namespace subdivision
{

/// An edge, or a convex face that may be warped. A point lies on it that is no farther away than
/// `Tolerance` times its longest edge, and from a face than its corners are from their mean plane.
class FlatPart
{
public:
  static constexpr double Tolerance = 1e-5;

  /// Of two corners, or of three and more in order.
  FlatPart(const double* const* corners, int size);

  enum Where
  {
    Off,
    AtCorner,
    Inside ///< on an edge or the face
  };
  Where Find(const double* x) const;
  /// How far away a point may be, but for warps.
  double GetTolerance() const { return Tolerance * this->Length; }
  /// Whether a box may have a point on it.
  bool Meets(const Box& box) const;
  /// Where the nearest place of an edge is, from 0 to 1.
  double GetParameter(const double* x) const;

private:
  std::vector<vectors::Vector> Corners;
  std::vector<vectors::Vector> Outwards; ///< of a face: normals of its edges in its plane
  vectors::Vector Middle{};
  vectors::Vector Direction{}; ///< of an edge, or the normal of a face
  double Length = 0.;          ///< of the longest edge
  double Height = 0.;          ///< of points above the plane
  Box Around;
};

}

#endif
