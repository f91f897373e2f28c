// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SignOfChildren.h
 * The sign of the volumes of the children of tetrahedra, told from their lattice points while these
 * are at hand: reading the cells of an output once more takes longer than writing them. The sign
 * counts where the volume is larger than its possible rounding.
 */
#ifndef SubdivisionObjects_SignOfChildren_h
#define SubdivisionObjects_SignOfChildren_h

#include "Core/Solids/BoxSpline/BoxSplineSplit.h"
#include "Core/Solids/BoxSpline/RefinedCells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace subdivision
{

/// The lattice points of a tetrahedron and of its children; `Parents` of these cells have a
/// lattice: 1, the tetrahedron itself, or 8 after a step. The points are numbered: lattice points
/// of the tetrahedron, then the midpoints of the edges of its children by place (SolidShapes.h).
template <int Parents>
struct TetLattice
{
  static constexpr int Size = Parents == 1 ? 10 : 35;
  std::array<std::array<unsigned char, 10>, Parents> Points{};

  constexpr TetLattice()
  {
    constexpr const auto& children = Children<MarkedTetShape, MarkedTetShape>;
    for (std::size_t p = 0; p < Parents; ++p)
    {
      for (std::size_t k = 0; k < 10; ++k)
      {
        const int point = Parents == 1 ? static_cast<int>(k)
          : k < 4                      ? children.Points[p][k]
                                       : 10 + children.Edges[p][k - 4];
        this->Points[p][k] = static_cast<unsigned char>(point);
      }
    }
  }
};
template <int Parents>
constexpr TetLattice<Parents> TetLatticeOf{};

/// Finds the sign that the volumes of all children of a tetrahedron have (tetrahedron::Children),
/// or of all their children. 0: they differ, or one may be rounding, or products may overflow or
/// vanish.
template <int Parents>
class SignOfChildren
{
public:
  static constexpr int Size = TetLattice<Parents>::Size;

  explicit SignOfChildren(const StoredPoints& points)
    : Points(points)
  {
  }
  /// `lattice`: the points of the tetrahedron.
  template <typename Id>
  signed char Find(const Id (&lattice)[Size]) const
  {
    return this->Points.Single ? FindSign(lattice, this->Points.Single)
                               : FindSign(lattice, this->Points.Double);
  }

private:
  struct Vector
  {
    double X, Y, Z;
  };
  static Vector Minus(const Vector& a, const Vector& b)
  {
    return { a.X - b.X, a.Y - b.Y, a.Z - b.Z };
  }
  static Vector Cross(const Vector& a, const Vector& b)
  {
    return { a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X };
  }
  static double Dot(const Vector& a, const Vector& b) { return a.X * b.X + a.Y * b.Y + a.Z * b.Z; }

  template <typename Id, typename T>
  static signed char FindSign(const Id (&lattice)[Size], const T* values)
  {
    // With e the largest error of rounding and d the size of the box of the points, differences
    // are off by e d, products of two by 3 e d^2, cross products by 8 e d^2, and volumes by less
    // than 48 e d^3. The range of sizes keeps products within the range of numbers.
    constexpr double part = 30 * std::numeric_limits<double>::epsilon(); // e is half of it
    Vector at[Size];
    const double d = Read(lattice, values, at);
    const double bound = part * d * d * d;
    constexpr auto parents = std::make_index_sequence<Parents>();
    const bool mayBeKnown = d > 1e-80 && d < 1e80;
    return !mayBeKnown                    ? 0
      : AreBeyond<1>(at, bound, parents)  ? 1
      : AreBeyond<-1>(at, bound, parents) ? -1
                                          : 0;
  }
  /// Reads the points. Returns the size of their box.
  template <typename Id, typename T>
  static double Read(const Id (&lattice)[Size], const T* values, Vector (&at)[Size])
  {
    constexpr double most = std::numeric_limits<double>::max();
    Vector low{ most, most, most };
    Vector high{ -most, -most, -most };
    const auto read = [](T value, double& x, double& least, double& greatest)
    {
      x = static_cast<double>(value);
      least = least < x ? least : x;
      greatest = greatest > x ? greatest : x;
    };
    for (int k = 0; k < Size; ++k)
    {
      const T* value = values + 3 * static_cast<vtkIdType>(lattice[k]);
      read(value[0], at[k].X, low.X, high.X);
      read(value[1], at[k].Y, low.Y, high.Y);
      read(value[2], at[k].Z, low.Z, high.Z);
    }
    const Vector sizes = Minus(high, low);
    return std::max({ sizes.X, sizes.Y, sizes.Z });
  }
  /// Whether all volumes of this sign are beyond the bound, times 6. Without a loop, so that
  /// numbers of points are constants.
  template <int Sign, std::size_t... Parent>
  static bool AreBeyond(const Vector (&at)[Size], double bound, std::index_sequence<Parent...>)
  {
    return (AreChildrenBeyond<Sign, Parent>(at, bound) && ...);
  }
  /// The same of the eight children of a parent.
  template <int Sign, std::size_t Parent>
  static bool AreChildrenBeyond(const Vector (&at)[Size], double bound)
  {
    constexpr const auto& places = TetLatticeOf<Parents>.Points[Parent];
    const Vector& p0 = at[places[0]];
    const Vector& p1 = at[places[1]];
    const Vector& p2 = at[places[2]];
    const Vector& p3 = at[places[3]];
    const Vector& p4 = at[places[4]];
    const Vector& p5 = at[places[5]];
    const Vector& p6 = at[places[6]];
    const Vector& p7 = at[places[7]];
    const Vector& p8 = at[places[8]];
    const Vector& p9 = at[places[9]];
    // Each child in the middle has the diagonal from 5 to 8 as an edge, and shares the triangle
    // opposite to one of its ends with a child at a corner.
    const Vector diagonal = Minus(p8, p5);
    const auto isPairBeyond = [&diagonal, bound](const Vector& triangle, const Vector& corner)
    {
      const double volumes[2] = { Dot(triangle, diagonal), Dot(triangle, corner) };
      return Sign > 0 ? volumes[0] > bound && volumes[1] > bound
                      : volumes[0] < -bound && volumes[1] < -bound;
    };
    return isPairBeyond(Cross(Minus(p6, p5), Minus(p4, p5)), Minus(p5, p0)) &&
      isPairBeyond(Cross(Minus(p7, p5), Minus(p9, p5)), Minus(p5, p2)) &&
      isPairBeyond(Cross(Minus(p4, p8), Minus(p7, p8)), Minus(p1, p8)) &&
      isPairBeyond(Cross(Minus(p9, p8), Minus(p6, p8)), Minus(p3, p8));
  }

  const StoredPoints Points;
};

}

#endif
