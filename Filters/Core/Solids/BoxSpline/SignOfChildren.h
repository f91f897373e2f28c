// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SignOfChildren.h
 * The sign of the volumes of the children of tetrahedra, told from their lattice points while these
 * are at hand: reading the cells of an output once more takes longer than writing them.
 */
#ifndef SubdivisionObjects_SignOfChildren_h
#define SubdivisionObjects_SignOfChildren_h

#include "vtkType.h"

namespace subdivision
{

/// Coordinates as they are stored; without any nothing is known of volumes.
struct StoredPoints
{
  StoredPoints() = default;
  StoredPoints(const float* values)
    : Single(values)
  {
  }
  StoredPoints(const double* values)
    : Double(values)
  {
  }

  const float* Single = nullptr;
  const double* Double = nullptr;
};

namespace children_volumes
{
struct Vector
{
  double X, Y, Z;
};
inline Vector Cross(const Vector& a, const Vector& b)
{
  return { a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X };
}
inline double Dot(const Vector& a, const Vector& b)
{
  return a.X * b.X + a.Y * b.Y + a.Z * b.Z;
}
}

/// The sign that the volumes of all 8 children (tetrahedron::Children) of `Parents` tetrahedra
/// have; 0: several, or that is not known, because products may overflow or vanish. `lattices`: the
/// 10 lattice points of each. A volume that rounds to the wrong sign belongs to a flat child.
template <int Parents, typename Out, typename T>
signed char GetSignOfChildren(const Out* lattices, const T* values)
{
  using namespace children_volumes;
  constexpr double least = 1e-250;
  constexpr double largest = 1e250;
  double at[10][3][Parents];
  for (int p = 0; p < Parents; ++p)
  {
    for (int k = 0; k < 10; ++k)
    {
      const T* value = values + 3 * static_cast<vtkIdType>(lattices[10 * p + k]);
      for (int c = 0; c < 3; ++c)
      {
        at[k][c][p] = static_cast<double>(value[c]);
      }
    }
  }
  // Loops over the parents, so that compilers use vectors.
  double smallest[Parents];
  double greatest[Parents];
  double sums[Parents];
  for (int p = 0; p < Parents; ++p)
  {
    const auto minus = [&at, p](int a, int b)
    {
      return Vector{ at[a][0][p] - at[b][0][p], at[a][1][p] - at[b][1][p],
        at[a][2][p] - at[b][2][p] };
    };
    double small = largest;
    double great = -largest;
    double sum = 0.;
    const auto add = [&small, &great, &sum](double volume)
    {
      small = volume < small ? volume : small;
      great = volume > great ? volume : great;
      sum += volume; // tells of volumes that are no numbers, too
    };
    const auto addTet = [&minus, &add](int a, int b, int c, int d)
    { add(Dot(minus(b, a), Cross(minus(c, a), minus(d, a)))); };
    addTet(0, 4, 5, 6);
    addTet(1, 4, 8, 7);
    addTet(2, 5, 7, 9);
    addTet(3, 6, 9, 8);
    // The four children in the middle have the diagonal from 5 to 8, and in pairs a triangle at it.
    const Vector diagonal = minus(8, 5);
    const Vector sixth = Cross(diagonal, minus(6, 5));
    const Vector seventh = Cross(minus(7, 5), diagonal);
    const Vector fourth = minus(4, 5);
    const Vector ninth = minus(5, 9);
    add(Dot(fourth, sixth));
    add(Dot(fourth, seventh));
    add(Dot(ninth, sixth));
    add(Dot(ninth, seventh));
    smallest[p] = small;
    greatest[p] = great;
    sums[p] = sum;
  }
  int positive = 0;
  int negative = 0;
  for (int p = 0; p < Parents; ++p)
  {
    positive += smallest[p] > least && sums[p] < largest ? 1 : 0;
    negative += greatest[p] < -least && sums[p] > -largest ? 1 : 0;
  }
  return positive == Parents ? 1 : negative == Parents ? -1 : 0;
}

template <int Parents, typename Out>
signed char GetSignOfChildren(const Out* lattices, const StoredPoints& points)
{
  return points.Single ? GetSignOfChildren<Parents>(lattices, points.Single)
    : points.Double    ? GetSignOfChildren<Parents>(lattices, points.Double)
                       : 0;
}

}

#endif
