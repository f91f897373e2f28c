// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceScheme.h
 * What a subdivision scheme for surfaces is (Mathematics 11, 12): from a level to the rows of the
 * operator and to the next level.
 */
#ifndef SubdivisionObjects_SurfaceScheme_h
#define SubdivisionObjects_SurfaceScheme_h

#include "Core/Operators/RowBlock.h"
#include "Core/Rules/Depth.h"
#include "Core/Rules/Rule.h"
#include "Core/Surfaces/Mesh/Carriers.h"
#include "Core/Surfaces/Mesh/PolygonMesh.h"

#include <cmath>
#include <memory>
#include <vector>

namespace subdivision
{

enum class EdgeTag : unsigned char
{
  Smooth,
  Blend, ///< non-manifold, rule G-2 (Mathematics 6)
  // Parts of curves. Where they meet, creases count before joints, and these before the rest.
  Sharp, ///< boundary, free line
  Joint, ///< non-manifold, rule G-1
  Crease ///< flagged, whatever else it is
};

constexpr bool IsSharp(EdgeTag tag)
{
  return tag >= EdgeTag::Sharp;
}

enum class VertexTag : unsigned char
{
  Smooth, ///< one closed fan; also the end of a crease that fades out
  Curve,  ///< two of its sharp edges, along which the curve rule works
  Corner, ///< does not move
  Blend
};

/// The faces between two sharp edges at a corner. There are none on curves: those that a step makes
/// are all alike.
template <typename Id>
struct Sector
{
  Id Vertex;
  Id First;        ///< the corner, at the vertex, of the first face
  Id Last;         ///< and of the last face
  int Size;        ///< number of faces k
  double Angle;    ///< alpha, clamped (Mathematics 12)
  double Flatness; ///< s, 0 for none
};

template <typename Id>
struct SurfaceTags
{
  Buffer<EdgeTag> Edges;
  Buffer<VertexTag> Vertices;
  std::vector<Sector<Id>> Sectors; ///< ascending by vertex
};

template <typename Id>
struct DualPlaces;

template <typename Id>
struct SurfaceLevel
{
  PolygonMesh<Id> Mesh;
  SurfaceTags<Id> Tags;
  /// Line cells: 2 edge + (1 if it runs against the edge).
  Buffer<Id> Lines;
  /// Vertex cells: their vertices. Empty after steps of schemes that keep the ids of vertices.
  Buffer<Id> Points;
  /// Whether edges may be sharp, in schemes in which no step makes the first: what Prepare found.
  bool HasCurves = true;
  int Step = 0; ///< since the control mesh: odd or even steps differ in some schemes
  /// Where children begin, as far as arithmetic alone does not tell: what Prepare counted.
  Buffer<Id> Places;
  std::shared_ptr<const DualPlaces<Id>> Dual; ///< the same for dual schemes
};

/// Whether no further step follows.
inline bool IsLast(Depth depth)
{
  return depth == Depth::ForOutput || depth == Depth::ForCounts;
}

enum class LimitKind
{
  Position,
  Tangent1,
  Tangent2
};

template <typename Id>
class SurfaceScheme
{
public:
  virtual ~SurfaceScheme() = default;

  /// Triangle schemes split other polygons first.
  virtual bool NeedsTriangles() const = 0;
  /// Whether creases, corners and sharpness mean anything (dual schemes: no).
  virtual bool UsesTags() const { return true; }
  /// Whether the vertices of a level are vertices of the next, with the same ids (dual schemes:
  /// no).
  virtual bool KeepsVertices() const { return true; }
  /// Whether a smooth boundary vertex with one face is a corner by default.
  virtual bool HasCornersOfOneFace() const { return false; }
  /// Whether it has rules for joints that are blended (Mathematics 6); else they are sharp.
  virtual bool BlendsJoints() const { return false; }
  /// The largest eigenvalue beside those of the tangent plane, at a corner of k faces and an angle.
  virtual double GetThirdEigenvalue(int /*k*/, double /*angle*/) const { return 0.; }

  /// Called once, for the control level: makes tags as strict as the scheme takes them.
  virtual void RestrictTags(SurfaceLevel<Id>& /*level*/) const {}
  /// Called for each level before anything else is asked of it: counts what its children need.
  virtual void Prepare(SurfaceLevel<Id>& /*level*/) const {}
  /// Whether the two halves of edge e are edges 2e and 2e + 1: sharpness can then be given to them.
  virtual bool HalvesEdges() const { return true; }

  /// About how many faces there are after some steps, to estimate sizes.
  virtual double CountFaces(double faces, double /*corners*/, int steps) const
  {
    return faces * std::pow(4., steps);
  }

  /// Number of vertices of the next level.
  virtual vtkIdType GetNumberOfRows(const SurfaceLevel<Id>& level) const = 0;
  /// Rows [begin, end) of the operator to the next level, in order.
  virtual void AppendRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags,
    vtkIdType begin, vtkIdType end, RowBlock<Id>& rows) const = 0;
  /// The vertices of this level from which vertex `row` of the next takes values that cannot be
  /// averaged: from the one with the smallest global id.
  virtual void GetParents(
    const SurfaceLevel<Id>& level, vtkIdType row, std::vector<vtkIdType>& parents) const = 0;
  /// The next level; ForOutput: only faces (NumberOf..., Arity, FaceOffsets, Vertices) and Lines
  /// with EdgeVertices; ForLastStep: all that a step needs which is ForOutput, and CarryFaces.
  virtual SurfaceLevel<Id> Refine(const SurfaceLevel<Id>& level, Depth depth) const = 0;
  /// Whether it has ForCounts, which is ForOutput without Vertices, and WriteFaces for these: the
  /// vertices of the next level's faces, one face after the other.
  virtual bool WritesFaces() const { return false; }
  virtual void WriteFaces(const SurfaceLevel<Id>& /*level*/, int* /*ids*/) const {}
  virtual void WriteFaces(const SurfaceLevel<Id>& /*level*/, long long* /*ids*/) const {}
  /// Tags of the next level from those of this one (there may be several sets for one level).
  virtual SurfaceTags<Id> RefineTags(
    const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags) const = 0;
  /// After how many steps each face lies in exactly one face of before; 0: never.
  virtual int GetCarrierPeriod() const { return 1; }
  /// Where the faces of the next level lie, from where those of this level do. `areWhole`: a number
  /// of steps is over after which each lies in one face.
  virtual void CarryFaces(const SurfaceLevel<Id>& level, const Buffer<Carrier<Id>>& faces,
    bool areWhole, Buffer<Carrier<Id>>& children) const = 0;

  /// One row for each vertex of the level: its limit position, or a tangent there.
  virtual bool HasLimit() const { return false; }
  virtual void AppendLimitRows(const SurfaceLevel<Id>& /*level*/, const SurfaceTags<Id>& /*tags*/,
    LimitKind /*kind*/, vtkIdType /*begin*/, vtkIdType /*end*/, RowBlock<Id>& /*rows*/) const
  {
  }
};

}

#endif
