// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceStars.h
 * Spectra and characteristic maps of surface schemes, by steps of a scheme on a regular mesh around
 * one vertex.
 */
#ifndef SubdivisionObjects_SurfaceStars_h
#define SubdivisionObjects_SurfaceStars_h

#include "Core/Smoothness/StarMap.h"
#include "Core/Surfaces/Steps/SurfaceSchemes.h"

#include <tuple>

namespace subdivision
{

/// The surface around a vertex, from one curve to the next. The spectrum depends on it alone, once
/// other irregular vertices are farther away than the scheme reads.
struct SurfaceStar
{
  enum class Kind
  {
    Closed, ///< all around a vertex inside
    Curve,  ///< at a boundary, or on one side of a crease
    Corner
  };

  SurfaceSchemeKind Scheme = SurfaceSchemeKind::Loop;
  bool ModifiedBoundary = true;
  LoopWeights Weights = LoopWeights::Warren;
  Kind Where = Kind::Closed;
  bool EndsCrease = false; ///< a dart: whether a crease ends at a vertex that is Closed
  int Faces = 6;
  double Angle = 0.;    ///< of a corner
  double Flatness = 0.; ///< of a corner

  bool IsAround() const { return this->Where == Kind::Closed; }
  bool operator<(const SurfaceStar& other) const { return this->Tie() < other.Tie(); }

private:
  std::tuple<SurfaceSchemeKind, bool, LoopWeights, Kind, bool, int, double, double> Tie() const
  {
    return { this->Scheme, this->ModifiedBoundary, this->Weights, this->Where, this->EndsCrease,
      this->Faces, this->Angle, this->Flatness };
  }
};

/// The number of faces around a vertex that steps make inside of a surface; on a curve half as
/// many.
int GetRegularFaces(SurfaceSchemeKind scheme);
/// Whether vertices become faces with as many corners, and so the faces are examined.
bool IsDual(SurfaceSchemeKind scheme);
/// Whether each face gets a vertex in its middle, with as many faces around it as it has corners.
bool HasCentres(SurfaceSchemeKind scheme);

/**
 * Eigenvalues of one step at the vertex and all vertices up to three edges away; of sqrt(3), 4-8
 * and midedge, whose steps turn the mesh, of two steps. In dual schemes, which have no such vertex,
 * of the corners of one face: there the condition compares with 1/4 too, which second derivatives
 * around the face have.
 * Stars of too many faces (LocalMatrix.h), and closed ones of fewer than three, are not examined:
 * all eigenvalues are 0.
 *
 * Where the condition holds and `samples`, the characteristic map, the eigenvectors of l1 and l2,
 * is taken further until edges have a quarter of the length (a ninth for sqrt(3)). It is regular if
 * all triangles (three corners in a row of each face) that lie between the first ring and its image
 * by a step keep their orientation. It is injective too if the first ring goes around once, or at
 * a curve less than once. FaceStars.h says which faces are looked at in dual schemes.
 */
SmoothnessFacts ExamineSurface(const SurfaceStar& star, bool samples);

/// The characteristic map itself, after `levels` further levels, 1 or more (sqrt(3), 4-8, midedge:
/// of two steps each), as far as it is known. In dual schemes it is the map of a face
/// (FaceStars.h), and empty at boundaries. It is empty where l2 = l3, so that it is not unique.
StarMap MapSurface(const SurfaceStar& star, int levels);

}

#endif
