// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Level.h
 * A level of a mesh whose solids are tetrahedra, which every volume scheme starts from, and how
 * many simplices a level has.
 */
#ifndef SubdivisionObjects_Level_h
#define SubdivisionObjects_Level_h

#include "Core/Memory/IdSegments.h"
#include "Core/Rules/Depth.h"
#include "Core/Solids/Strata/Strata.h"

namespace subdivision
{

template <typename Id>
struct Level
{
  using IdType = Id;
  SimplicialComplex<Id> Complex;
  subdivision::Strata<Id> Strata;
};

struct LevelCounts;

/// A volume scheme as code that is compiled once sees it.
struct SchemeTraits
{
  int Number; ///< in stamps, which files hold: it never changes
  /// Whether the result depends on the vertex order of tetrahedra, so that OrderTets chooses it.
  bool OrdersTets;
  /// Whether some solids are written as several tetrahedra, *pieces*, which depend on the points.
  bool HasPieces;
  // To estimate sizes before any memory is taken:
  LevelCounts (*Refine)(const LevelCounts&);
  /// How many ids a level with rings and carriers has besides ids of tetrahedra, faces and edges.
  double (*CountMoreIds)(const LevelCounts&);
  /// The ids of the vertices after some steps, to number vertices of several ranks (IdSegments.h).
  IdSegments (*ListVertices)(int steps);
  /// Sizes of the rings of regular edges and vertices where they are larger than on surfaces,
  /// otherwise 0.
  double EdgeRing = 0;
  double VertexRing = 0;
  /// Whether limits have tangent planes where the rules say so. If not, normals are for shading.
  bool HasTangents = true;
};

/// Numbers of simplices after a number of steps, to estimate sizes before any memory is taken.
struct LevelCounts
{
  double Vertices = 0;
  double Edges = 0;
  double Faces = 0;
  double Tets = 0;
  double Octahedra = 0; ///< solids that are no tetrahedra
  const SchemeTraits* Scheme = nullptr;
  LevelCounts Refine() const
  {
    LevelCounts refined = this->Scheme->Refine(*this);
    refined.Scheme = this->Scheme;
    return refined;
  }
};

/// The scheme is left open.
template <typename Id>
LevelCounts CountSimplices(const SimplicialComplex<Id>& complex)
{
  return { static_cast<double>(complex.NumberOfVertices),
    static_cast<double>(complex.NumberOfEdges), static_cast<double>(complex.NumberOfFaces),
    static_cast<double>(complex.NumberOfTets) };
}

}

#endif
