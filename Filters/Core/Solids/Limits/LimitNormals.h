// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LimitNormals.h
 * Tangents and normals at the limit, of surfaces and of the boundaries of solids (Mathematics 8).
 *
 * A vertex inside a surface with neighbours p_0, p_1, ... in cyclic order has the tangents sum
 * cos(2 pi j/m) p_j and sum sin(2 pi j/m) p_j; all its triangles count as one *sector*. A vertex on
 * a boundary or crease has one or two sectors, each from one sharp edge to the next. The tangents
 * of a sector of k triangles are p_0 - p_k along the curve, and one across it with the weights
 * sin(pi j/k) of p_1 to p_k-1; the weights of p_0, p_k and the vertex make it a left eigenvector
 * for the eigenvalue 3/8 + 1/4 cos(pi/k). The normal of a vertex is the mean of the normals of its
 * sectors. A sector of 7 or more triangles has no tangent plane: the eigenvalue 3/8 + 1/4 cos(2
 * pi/k) is then larger than 1/2, that of the tangent along the curve. Corners, curves, joints,
 * darts, and vertices of creases that are still sharp have no tangent plane either; they take a
 * normal for shading from their star in the limit (ShadingStars.h). Where the tangents of a sector
 * are parallel but for rounding its normal is perpendicular to the longer one. Inside solids, where
 * no surface and no curve passes, no direction is a normal, and it is zero.
 */
#ifndef SubdivisionObjects_LimitNormals_h
#define SubdivisionObjects_LimitNormals_h

#include "Core/Memory/Coordinates.h"
#include "Core/Operators/FaceSides.h"
#include "Core/Solids/Limits/LimitStencils.h"
#include "Core/Solids/Limits/ShadingStars.h"

#include <array>
#include <cstddef>
#include <vector>

namespace subdivision
{

template <typename Id>
struct LimitTangents
{
  Rows<Id> Sectors; ///< the sectors of each vertex by Offsets; Items is empty, because sectors are
                    ///< numbered vertex by vertex
  /// The two tangents of each sector, one row each. On a surface their cross product has the
  /// direction that fits one of its triangles; on the boundary of a solid that of the walk around
  /// the vertex.
  SparseRows<Id> First;
  SparseRows<Id> Second;
  /// For a sector on the boundary of a solid, one entry for each triangle: twice the number of the
  /// control tetrahedron in which the solid lies, plus 1 if by the order of its vertices this
  /// tetrahedron lies on the side to which the cross product points. The side is decided on the
  /// control mesh, because smoothing may turn solids inside out and must not turn normals.
  Buffer<vtkIdType> SideOffsets;
  Buffer<vtkIdType> Sides;
  /// The control triangle in which that triangle of each sector lies; -1 on a solid.
  Buffer<Id> Triangles;
  /// For each vertex of a curve the neighbour from which the curve comes, and that to which it
  /// goes; -1: the vertex has sectors, or lies on no curve.
  Buffer<Id> AlongCurves;
  /// The source of normals for shading of vertices without sector.
  ShadingStars<Id> Shading;

  /// Flags the vertices without sector.
  Buffer<unsigned char> FindMissing() const
  {
    Buffer<unsigned char> missing(this->Sectors.GetNumberOfRows());
    ForEach(missing.size(),
      [&](vtkIdType v) { missing[v] = this->Sectors.Offsets[v] == this->Sectors.Offsets[v + 1]; });
    return missing;
  }
  vtkIdType GetNumberOfSectors() const { return this->First.GetNumberOfRows(); }
  std::size_t GetMemorySize() const
  {
    return this->Sectors.GetMemorySize() + this->First.GetMemorySize() +
      this->Second.GetMemorySize() + this->SideOffsets.GetMemorySize() +
      this->Sides.GetMemorySize() + this->Triangles.GetMemorySize() +
      this->AlongCurves.GetMemorySize() + this->Shading.GetMemorySize();
  }
};

/// Weights of the two tangents of a sector: of the vertex, and of the far ends of its edges.
struct SectorTangents
{
  std::vector<std::array<double, 2>> Edges;
  std::array<double, 2> Own{ { 0., 0. } };
};
/// Those of a sector of `size` edges where all rules stay the same in further steps. `isModified`:
/// by the modified rules next to boundaries.
SectorTangents FindSectorTangents(std::size_t size, bool isClosed, bool isModified);

/// The sides of the surfaces of a level, triangle by triangle, so that normals have one side on all
/// that is reached over edges of two triangles, smooth ones and creases. They are the same on all
/// levels. `isSure`: a flag for each vertex; an edge without such an end is no link; empty: all are
/// sure.
template <typename Level>
FaceSides FindTriangleSides(const Level& level, const std::vector<char>& isSure = {});

/// The tangents at all vertices of a level that can be refined (Depth::ForRefinement).
template <typename Level>
LimitTangents<typename Level::IdType> BuildLimitTangents(const Level& level,
  const SemiSharpStages<typename Level::IdType>& creases = {}, const ControlSolids& solids = {});

/// The same of a part of a level that is `made` steps after the control level; `cells` tell where
/// the cells of the part lie.
template <typename Level>
LimitTangents<typename Level::IdType> BuildLimitTangents(const Level& level,
  const SemiSharpStages<typename Level::IdType>& creases, const ControlSolids& solids,
  const ShadingCells<typename Level::IdType>& cells, int made);

/// Computes the unit normals of the rows of Sectors, three numbers for each; vertices without
/// sector get zero. The other arguments are as in ComputeLimitNormals.
template <typename Id>
void ComputeSectorNormals(const LimitTangents<Id>& tangents, const Coordinates& points,
  const std::vector<vtkIdType>& inverted, const Buffer<unsigned char>& turned, double* normals);

/// Computes two tangents of each vertex, three numbers each, from the points of the level: the
/// tangents of its first sector, whose cross product has the direction of the normal, or on a curve
/// the first along it, or zeros. The other arguments are as in ComputeLimitNormals.
template <typename Id>
void ComputeLimitTangents(const LimitTangents<Id>& tangents, const Coordinates& points,
  const std::vector<vtkIdType>& inverted, const Buffer<unsigned char>& turned, double* first,
  double* second);

/// Computes unit normals, three numbers for each vertex, from the points of the level. Vertices
/// without sector get a normal for shading (ShadingNormals.h), or zero inside solids. `inverted`
/// has, in ascending order, twice the number of each control tetrahedron with negative volume; odd
/// numbers in it are ignored. `turned` has a flag for each control triangle (FindTriangleSides);
/// empty: none is turned.
template <typename Id>
void ComputeLimitNormals(const LimitTangents<Id>& tangents, const Coordinates& points,
  const std::vector<vtkIdType>& inverted, const Buffer<unsigned char>& turned, double* normals);

}

#endif
