// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ButterflyMasks.h
 * The weights of the modified Butterfly scheme (Mathematics 12). k is the number of faces around a
 * vertex or in its sector. Neighbours j of a sector are 0 to k, neighbours 0 and k the other ends
 * of its sharp edges.
 */
#ifndef SubdivisionObjects_ButterflyMasks_h
#define SubdivisionObjects_ButterflyMasks_h

#include "Core/Operators/RowBlock.h"
#include "Core/Rules/Pi.h"
#include "Core/Surfaces/Mesh/PolygonMesh.h"

#include <array>
#include <cmath>
#include <vector>

namespace subdivision
{
namespace butterfly
{

/// The weight of an extraordinary vertex inside the surface, and the weight of its neighbour j,
/// counted from the other end of the edge. Zorin's survey has no weights for k = 2; the weights
/// here are exact for constants and for functions that are linear along the edge.
constexpr double Centre = 3. / 4.;
inline double Ring(int k, int j)
{
  constexpr double two[2] = { 3. / 8., -1. / 8. };
  constexpr double three[3] = { 5. / 12., -1. / 12., -1. / 12. };
  constexpr double four[4] = { 3. / 8., 0., -1. / 8., 0. };
  switch (k)
  {
    case 2:
      return two[j];
    case 3:
      return three[j];
    case 4:
      return four[j];
    default:
      return (1. / 4. + std::cos(2. * Pi * j / k) + std::cos(4. * Pi * j / k) / 2.) / k;
  }
}

/// The weight of the vertex in the row of edge i, 0 < i < k, of a sector on a smooth curve.
inline double CurveCentre(int k, int i)
{
  const double t = Pi / k;
  return 1. - std::sin(t) * std::sin(i * t) / (k * (1. - std::cos(t)));
}

/// The weight of neighbour j in the same row.
inline double CurveRing(int k, int i, int j)
{
  const double t = Pi / k;
  if (j == 0 || j == k)
  {
    const double end = std::cos(i * t) / 4. -
      std::sin(2. * t) * std::sin(2. * i * t) / (4. * k * (std::cos(t) - std::cos(2. * t)));
    return j == 0 ? end : -end;
  }
  return (std::sin(i * t) * std::sin(j * t) + std::sin(2. * i * t) * std::sin(2. * j * t) / 2.) / k;
}

/// The value at neighbour i of a function that is linear in a sector of this angle. It is 1 at the
/// other end of one sharp edge (the last one if `last`), and 0 at the corner and at the other end
/// of the other one.
inline double LinearInSector(int k, double angle, int i, bool last)
{
  return std::sin((last ? i : k - i) * angle / k) / std::sin(angle);
}

/// As CurveRing, for a sector of this angle at a corner; the corner itself has the rest of the
/// weights. Zorin's survey has no such rule. Like the rule for curves it multiplies functions that
/// are linear in the sector by 1/2 and the first wave that is 0 at both sharp edges by 1/4, and
/// removes all else.
inline double CornerRing(int k, double angle, int i, int j)
{
  auto wave = [k](int m) { return std::sin(m * Pi / k); };
  if (j > 0 && j < k)
  {
    return wave(i) * wave(j) / (2. * k);
  }
  double inWave = 0.;
  for (int m = 1; m < k; ++m)
  {
    inWave += wave(m) * LinearInSector(k, angle, m, j == k);
  }
  return LinearInSector(k, angle, i, j == k) / 2. - wave(i) * inWave / (2. * k);
}

}

/// The mask of an edge between two vertices of six faces: its ends, and on each side the vertex
/// opposite and the two beyond.
inline constexpr std::array<double, 8> ButterflyEdge{ 1. / 2., 1. / 2., 1. / 8., -1. / 16.,
  -1. / 16., 1. / 8., -1. / 16., -1. / 16. };

/// The weights of a tangent of a vertex of six faces whose neighbours have six, too: of these, of
/// the vertices across from it, and of the neighbours of its neighbours straight on. As they are a
/// left eigenvector, they are half of those on the next level (ButterflyTangents.h).
inline const std::array<std::array<double, 18>, 2> ButterflyTangentsInside = []()
{
  std::array<std::array<double, 18>, 2> masks;
  for (int kind = 0; kind < 2; ++kind)
  {
    const auto wave = [kind](int j)
    { return kind == 0 ? std::cos(Pi * j / 3.) : std::sin(Pi * j / 3.); };
    for (int j = 0; j < 6; ++j)
    {
      masks[kind][j] = 8. * wave(j);
      masks[kind][6 + j] = -4. / 3. * (wave(j) + wave(j + 1));
      masks[kind][12 + j] = wave(j) / 2.;
    }
  }
  return masks;
}();

/// Appends the entries of an edge from an end with another number of faces all around, of which
/// `corner` is the end's in the first face of the edge.
template <typename Id>
void AppendButterflyRing(
  const PolygonMesh<Id>& mesh, Id edge, Id vertex, Id corner, double factor, RowBlock<Id>& rows)
{
  thread_local std::vector<Id> ring; // it begins with the edge's other end
  ring.clear();
  FanStep<Id> step{ corner, mesh.Edges[corner] == edge };
  do
  {
    ring.push_back(mesh.GetOtherEnd(mesh.Edges[step.GetHalfEdgeIn(mesh)], vertex));
  } while (step.Advance(mesh) && step.Corner != corner);
  const int k = static_cast<int>(ring.size());
  // The weights depend on k only; they are stored for further edges with the same k.
  thread_local std::vector<double> weights;
  if (static_cast<int>(weights.size()) != k)
  {
    weights.resize(k);
    for (int j = 0; j < k; ++j)
    {
      weights[j] = butterfly::Ring(k, j);
    }
  }
  rows.Add(vertex, factor * butterfly::Centre);
  for (int j = 0; j < k; ++j)
  {
    rows.Add(ring[j], factor * weights[j]);
  }
}

}

#endif
