// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SheetRows.h
 * Limits at some places of a curve, or of a *sheet*: the part of a surface, or of the boundary of a
 * solid, that lies between creases, boundaries and joints. There the limit over a triangle depends
 * on nothing but how many triangles its corners have, so that few different rows serve a whole
 * mesh. They are found by LocalLimit, on a mesh of these triangles alone, when they are first
 * needed.
 */
#ifndef SubdivisionObjects_SheetRows_h
#define SubdivisionObjects_SheetRows_h

#include "Core/Operators/SparseRows.h"
#include "Core/Rules/LoopWeights.h"

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace subdivision
{

/// What the places belong to. A vertex has one place, itself. An edge abc... has three: between a
/// and the middle, the middle, between the middle and b. A face abc has three: near a, near b and
/// near c, each in the middle of the edge that cuts off a corner of the face in two steps. The
/// limit over a lattice, whose nodes divide the edges in four, is a polynomial (PlacePolynomial.h).
enum class SheetPlaces : unsigned char
{
  Vertex,
  CurveVertex,
  Edge,
  CurveEdge,
  Face,
  CurveLattice,
  FaceLattice,
  EdgeLattice ///< the last three are lattices
};

/// How the triangles of a sheet lie around a corner of one of them.
struct SheetFan
{
  enum class Kind : unsigned char
  {
    None,         ///< the places do not depend on it
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
 * Of the places of curves, Fans have Open where the curve goes on and OpenCorner where it does not.
 * Columns are the vertex or both ends, then what the curve goes on to.
 */
struct SheetKey
{
  SheetPlaces Places = SheetPlaces::Vertex;
  std::array<SheetFan, 3> Fans;
  /// In which part of the simplex a lattice lies: 1 for the whole, for a child (ListChildren) four
  /// times the number of its parent and its own.
  std::uint16_t Part = 1;

  bool HasLattice() const { return this->Places >= SheetPlaces::CurveLattice; }
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

/// What a part of a curve, edge or face depends on after a step of subdivision.
struct SheetChild
{
  SheetKey Key;
  SparseRows<int> Rows; ///< of its columns, over those of the parent; none: it is no sheet
};

class SheetRows
{
public:
  explicit SheetRows(LoopWeights weights)
    : Weights(weights)
  {
  }

  /// The weights of all columns at the first place, then at the second, ...; of a lattice for the
  /// first of PatchPowers::Quartic, then for the second, ... of the weights u and v of the second
  /// and third corner.
  const std::vector<double>& Find(const SheetKey& key)
  {
    std::vector<double>& weights = this->Found[key.Pack()];
    if (weights.empty())
    {
      weights = this->Make(key);
    }
    return weights;
  }

  /// A child (ListChildren) of an edge or a face.
  const SheetChild& FindChild(const SheetKey& key, int child);

private:
  std::vector<double> Make(const SheetKey& key) const;

  LoopWeights Weights;
  std::unordered_map<std::uint64_t, std::vector<double>> Found;
  std::unordered_map<std::uint64_t, SheetChild> Children;
};

}

#endif
