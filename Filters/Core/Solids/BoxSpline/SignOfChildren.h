// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SignOfChildren.h
 * The sign of the volumes of the children of tetrahedra, told from their lattice points while these
 * are at hand: reading the cells of an output once more takes longer than writing them. Four
 * tetrahedra are looked at side by side, first in single precision, then in double: volumes that
 * are larger than what they may round by have their sign.
 */
#ifndef SubdivisionObjects_SignOfChildren_h
#define SubdivisionObjects_SignOfChildren_h

#include "Core/Solids/BoxSpline/BoxSplineSplit.h"
#include "Core/Solids/BoxSpline/RefinedCells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace subdivision
{

/// The lattice points of a tetrahedron and those of its children, of which there are `Parents` with
/// a lattice: 1, the tetrahedron itself, or 8 after a step. The points are numbered: lattice points
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

namespace children_volumes
{
template <typename Real>
struct Vector
{
  Real X, Y, Z;
};
template <typename Real>
Vector<Real> Cross(const Vector<Real>& a, const Vector<Real>& b)
{
  return { a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X };
}
template <typename Real>
Real Dot(const Vector<Real>& a, const Vector<Real>& b)
{
  return a.X * b.X + a.Y * b.Y + a.Z * b.Z;
}

/// How many tetrahedra are looked at side by side: as many as compilers put into one vector.
constexpr int Lanes = 4;
template <typename Real>
using Coordinate = Real[Lanes];

/// The least and the greatest volume in each of the tetrahedra, times 6, and the sum of all, which
/// tells of volumes that are no numbers, too.
template <typename Real>
struct Volumes
{
  Real Least[Lanes];
  Real Greatest[Lanes];
  Real Sums[Lanes];
};

/// The volumes of the eight children with these lattice points, each of three coordinates.
template <typename Real>
Volumes<Real> FindVolumes(const std::array<const Coordinate<Real>*, 10>& at)
{
  Volumes<Real> volumes;
  for (int lane = 0; lane < Lanes; ++lane)
  {
    const auto minus = [&at, lane](std::size_t a, std::size_t b)
    {
      return Vector<Real>{ at[a][0][lane] - at[b][0][lane], at[a][1][lane] - at[b][1][lane],
        at[a][2][lane] - at[b][2][lane] };
    };
    // Each child in the middle has the diagonal from 5 to 8 as an edge, and shares the triangle
    // opposite to one of its ends with a child at a corner.
    const Vector<Real> diagonal = minus(8, 5);
    Real least = std::numeric_limits<Real>::max();
    Real greatest = -least;
    Real sum = Real(0);
    const auto add = [&least, &greatest, &sum](Real volume)
    {
      least = volume < least ? volume : least;
      greatest = volume > greatest ? volume : greatest;
      sum += volume;
    };
    const auto addPair = [&](const Vector<Real>& triangle, const Vector<Real>& corner)
    {
      add(Dot(triangle, diagonal));
      add(Dot(triangle, corner));
    };
    addPair(Cross(minus(6, 5), minus(4, 5)), minus(5, 0));
    addPair(Cross(minus(7, 5), minus(9, 5)), minus(5, 2));
    addPair(Cross(minus(4, 8), minus(7, 8)), minus(1, 8));
    addPair(Cross(minus(9, 8), minus(6, 8)), minus(3, 8));
    volumes.Least[lane] = least;
    volumes.Greatest[lane] = greatest;
    volumes.Sums[lane] = sum;
  }
  return volumes;
}
}

/// Finds the sign that the volumes of all children of a tetrahedron have (tetrahedron::Children),
/// or of all their children; 0: several, or that is not known, because one may be rounding, or
/// products may overflow or vanish.
template <int Parents>
class SignOfChildren
{
public:
  static constexpr int Size = TetLattice<Parents>::Size;

  /// `signs`: where they go, one for each tetrahedron; null: nothing is done.
  SignOfChildren(const StoredPoints& points, signed char* signs)
    : Points(points)
    , Signs(points.Single || points.Double ? signs : nullptr)
  {
  }
  /// Takes the points of a tetrahedron, whose sign goes to `place`.
  template <typename Id>
  void Add(const Id (&lattice)[Size], vtkIdType place)
  {
    if (!this->Signs)
    {
      return;
    }
    this->Points.Single ? this->Read(lattice, this->Points.Single)
                        : this->Read(lattice, this->Points.Double);
    this->Places[this->Count] = place;
    if (++this->Count == Lanes)
    {
      this->Finish();
    }
  }
  /// Stores the signs of the last ones, which are less than a vector.
  void Finish()
  {
    signed char signs[Lanes];
    // The range of sizes keeps products within the range of numbers.
    if (this->Count > 0 && !this->Find<float>(signs, 1e-10F, 1e10F))
    {
      this->Find<double>(signs, 1e-80, 1e80);
    }
    for (int lane = 0; lane < this->Count; ++lane)
    {
      this->Signs[this->Places[lane]] = signs[lane];
    }
    this->Count = 0;
  }

private:
  static constexpr int Lanes = children_volumes::Lanes;
  template <typename Real>
  using Lattice = children_volumes::Coordinate<Real>[Size][3];

  template <typename Id, typename T>
  void Read(const Id (&lattice)[Size], const T* values)
  {
    for (int k = 0; k < Size; ++k)
    {
      const T* value = values + 3 * static_cast<vtkIdType>(lattice[k]);
      for (int c = 0; c < 3; ++c)
      {
        this->At[k][c][this->Count] = static_cast<double>(value[c]);
      }
    }
  }
  template <typename Real>
  static children_volumes::Volumes<Real> FindVolumes(const Lattice<Real>& at)
  {
    children_volumes::Volumes<Real> all;
    for (int lane = 0; lane < Lanes; ++lane)
    {
      all.Least[lane] = std::numeric_limits<Real>::max();
      all.Greatest[lane] = -all.Least[lane];
      all.Sums[lane] = Real(0);
    }
    for (const auto& places : TetLatticeOf<Parents>.Points)
    {
      std::array<const children_volumes::Coordinate<Real>*, 10> points;
      for (std::size_t k = 0; k < 10; ++k)
      {
        points[k] = at[places[k]];
      }
      const auto volumes = children_volumes::FindVolumes<Real>(points);
      for (int lane = 0; lane < Lanes; ++lane)
      {
        all.Least[lane] = std::min(all.Least[lane], volumes.Least[lane]);
        all.Greatest[lane] = std::max(all.Greatest[lane], volumes.Greatest[lane]);
        all.Sums[lane] += volumes.Sums[lane];
      }
    }
    return all;
  }

  /// Returns whether all signs are known then. Coordinates beside the middle of the diagonal are
  /// between `least` and `most`.
  template <typename Real>
  bool Find(signed char (&signs)[Lanes], Real least, Real most) const
  {
    // With coordinates up to r, which round by e r at most, a volume rounds by less than 530 e r^3:
    // differences by 4, products of two by 48, and sums of three with these by 530.
    constexpr Real part = 300 * std::numeric_limits<Real>::epsilon(); // e is half of it
    Lattice<Real> at;
    Real reach[Lanes];
    this->Move(at, reach);
    const auto volumes = FindVolumes<Real>(at);
    bool areKnown = true;
    for (int lane = 0; lane < this->Count; ++lane)
    {
      const Real r = reach[lane];
      const Real bound = part * r * r * r;
      const bool areNumbers =
        r > least && r < most && volumes.Sums[lane] - volumes.Sums[lane] == Real(0);
      signs[lane] = !areNumbers           ? 0
        : volumes.Least[lane] > bound     ? 1
        : volumes.Greatest[lane] < -bound ? -1
                                          : 0;
      areKnown = areKnown && signs[lane] != 0;
    }
    return areKnown;
  }
  /// The points beside the middle of the diagonal, and the largest of their coordinates.
  template <typename Real>
  void Move(Lattice<Real>& at, Real (&reach)[Lanes]) const
  {
    double middle[3][Lanes];
    for (int c = 0; c < 3; ++c)
    {
      for (int lane = 0; lane < Lanes; ++lane)
      {
        middle[c][lane] = (this->At[5][c][lane] + this->At[8][c][lane]) / 2.;
      }
    }
    for (int k = 0; k < Size; ++k)
    {
      for (int c = 0; c < 3; ++c)
      {
        for (int lane = 0; lane < Lanes; ++lane)
        {
          at[k][c][lane] = static_cast<Real>(this->At[k][c][lane] - middle[c][lane]);
        }
      }
    }
    for (int lane = 0; lane < Lanes; ++lane)
    {
      Real farthest = Real(0);
      for (int k = 0; k < Size; ++k)
      {
        for (int c = 0; c < 3; ++c)
        {
          const Real distance = std::abs(at[k][c][lane]);
          farthest = distance > farthest ? distance : farthest;
        }
      }
      reach[lane] = farthest;
    }
  }
  const StoredPoints Points;
  signed char* const Signs;
  int Count = 0; ///< of tetrahedra whose signs are not stored yet
  vtkIdType Places[Lanes];
  Lattice<double> At = {}; ///< lanes beyond Count have any numbers
};

}

#endif
