// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SheetKey.h
 * What the limit over a part of a curve, or of a *sheet*, depends on. A sheet is the part of a
 * surface, or of the boundary of a solid, that lies between creases, boundaries and joints. There
 * the limit over a triangle depends on nothing but how many triangles its corners have, so that few
 * different rows serve a whole mesh (PatchPolynomials.h).
 */
#ifndef SubdivisionObjects_SheetKey_h
#define SubdivisionObjects_SheetKey_h

#include "Core/Operators/SparseRows.h"

#include <array>
#include <cstdint>

namespace subdivision
{

enum class SheetPlaces : unsigned char
{
  Vertex,      ///< inside a sheet
  CurveVertex, ///< on a curve
  Curve,       ///< an edge of a curve
  Face         ///< of a sheet
};

/// How the triangles of a sheet lie around a corner of one of them.
struct SheetFan
{
  enum class Kind : unsigned char
  {
    None,         ///< nothing depends on it
    Closed,       ///< all around a vertex inside the sheet
    ClosedCorner, ///< the same, the vertex is a corner
    Open,         ///< between two edges of the curve on which the vertex lies
    OpenCorner    ///< the same at a corner
  };
  static constexpr int Most = 31; ///< that a count may be

  Kind What = Kind::None;
  /// How many vertices follow behind the triangle's second, and (not if it is closed) third one of
  /// the other two corners, in the direction away from the triangle.
  int After = 0;
  int Before = 0;

  bool IsClosed() const { return this->What == Kind::Closed || this->What == Kind::ClosedCorner; }
};

/**
 * A triangle with corners 0, 1, 2 and the fans at them. The columns of its rows are the three
 * corners, then for each corner the vertices After and those Before. Corner i has the edges to
 * corner i + 1 and to corner i + 2; After begins across the latter, Before across the former.
 *
 * Of a curve, Fans have Open where the curve goes on and OpenCorner where it does not.
 * Columns are the vertex or both ends, then what the curve goes on to.
 */
struct SheetKey
{
  SheetPlaces Places = SheetPlaces::Vertex;
  std::array<SheetFan, 3> Fans;
  /// Which part of the edge or face: 1 for the whole, for a child (ListChildren) four times the
  /// number of its parent and its own.
  std::uint16_t Part = 1;

  std::uint64_t Pack() const
  {
    std::uint64_t packed =
      static_cast<std::uint64_t>(this->Part) << 8 | static_cast<std::uint64_t>(this->Places);
    for (const SheetFan& fan : this->Fans)
    {
      packed = packed << 13 | static_cast<std::uint64_t>(fan.What) << 10 |
        static_cast<std::uint64_t>(fan.After) << 5 | static_cast<std::uint64_t>(fan.Before);
    }
    return packed;
  }
};

/// The neighbourhood on which a part of a face depends after a step of subdivision.
struct SheetChild
{
  SheetKey Key;
  SparseRows<int> Rows; ///< of its columns, over those of the parent; none: it is no sheet
};

}

#endif
