// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceScheme.h
 * The interface of a surface scheme (Mathematics 11, 12), which makes from a level the rows of the
 * operator and the next level.
 */
#ifndef SubdivisionObjects_SurfaceScheme_h
#define SubdivisionObjects_SurfaceScheme_h

#include "Core/Memory/IdSegments.h"
#include "Core/Operators/RowBlock.h"
#include "Core/Rules/Depth.h"
#include "Core/Rules/Rule.h"
#include "Core/Surfaces/Mesh/Carriers.h"
#include "Core/Surfaces/Mesh/PolygonMesh.h"

#include <cmath>
#include <memory>
#include <variant>
#include <vector>

namespace subdivision
{

/// Adds the entries of a row to the row that is being made, times a factor.
template <typename Id>
void AddTimes(const RowBlock<Id>& row, double factor, RowBlock<Id>& rows)
{
  for (std::size_t k = 0; k < row.GetNumberOfEntries(); ++k)
  {
    rows.Add(row.GetColumns()[k], factor * row.GetWeights()[k]);
  }
}

enum class EdgeTag : unsigned char
{
  Smooth,
  Blend, ///< non-manifold, rule G-2 (Mathematics 6)
  // The tags from here on are sharp. At a vertex creases count before joints, and joints before the
  // rest.
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
  Smooth, ///< one closed fan without sharp edges; or a dart
  Curve,  ///< on a curve along two of its sharp edges
  Corner, ///< does not move
  Blend
};

/// A sector at a vertex with VertexTag::Corner: the faces from one sharp edge to the next. Vertices
/// on curves have no such records, because the angle of their sectors is always pi.
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
class IrregularRows;
template <typename Id>
class SurfacePatch;

template <typename Id>
struct SurfaceLevel
{
  PolygonMesh<Id> Mesh;
  SurfaceTags<Id> Tags;
  /// The segments of line cells: 2 edge + (1 if the segment runs against the edge).
  Buffer<Id> Lines;
  /// The vertices of vertex cells. Empty after a step of a scheme that keeps the ids of vertices.
  Buffer<Id> Points;
  /// Whether there may be sharp edges. Prepare sets it in schemes whose steps make none where there
  /// were none.
  bool HasCurves = true;
  int Step = 0; ///< steps since the control mesh; odd and even steps differ in some schemes
  /// If a step that halves edges made this level (PrimalRefinement.h): how many vertices the level
  /// before had. Then come the edge points. In sqrt(3) how many the level had that was the first to
  /// be refined: all others were made by steps. Otherwise -1.
  vtkIdType VerticesBefore = -1;
  /// Prepare sets them: running counts, from which ids of children follow where arithmetic alone is
  /// not enough; in Butterfly the valences of smooth vertices.
  Buffer<Id> Places;
  std::shared_ptr<const DualPlaces<Id>> Dual; ///< the same for dual schemes
};

/// The order in which a level numbers its parts: from which parts of the control level they come.
/// Two parts of a mesh have the same kinds of segments in the same order, because it depends on
/// options and the number of steps only, whether a segment is varied.
struct SurfaceSegments
{
  enum Kind
  {
    Vertex,
    Edge,
    Face,
    Line,
    NumberOfKinds
  };
  std::vector<vtkIdType> Sizes; ///< how many the control level has of each kind
  IdSegments Vertices;
  IdSegments Edges; ///< in schemes that need them
  IdSegments Faces;
  IdSegments Corners;
  IdSegments Lines;
};

enum class LimitKind
{
  Position,
  Tangent1,
  Tangent2
};

/// Things with as many new vertices around them as neighbours, each computed from all neighbours:
/// so k rows of k values.
enum class DenseRows
{
  None,
  OfVertices, ///< k faces around a vertex
  OfFaces,    ///< k corners of a face; vertices become such faces in dual schemes
  OfLimits    ///< both, in rows of limits alone
};

/// The memory for each face that CountFaces counts, in bytes, at most. Measured: TestEstimates.cxx
/// sees that it is enough.
struct FaceMemory
{
  double Ids;    ///< in the output, of 8 bytes each
  double Points; ///< in the output: how many there are for each face of a closed surface
  // At the peak, beside the output, with ids of 4 bytes:
  double Smooth; ///< of closed surfaces without sharp edges
  double Sharp;
  double Limits; ///< where the points are projected
  double Frames; ///< and with normals and tangents
  // The same where the last level is not made (HasLimitsOfNext); 0: it is made.
  double LimitsOfNext = 0.;
  double FramesOfNext = 0.;
};

/// Where ids are written, of either type.
using IdsOut = std::variant<int*, long long*>;

template <typename Id>
class SurfaceScheme
{
public:
  virtual ~SurfaceScheme() = default;

  /// Triangle schemes split other polygons first.
  virtual bool NeedsTriangles() const = 0;
  /// Whether new vertices stand for corners or edges. Otherwise the vertices of a level are
  /// vertices of the next, with the same ids; only then creases, corners and sharpness mean
  /// anything.
  virtual bool IsDual() const { return false; }
  /// Whether steps change the directions in which neighbours lie of a vertex that they keep.
  virtual bool HasLimitStars() const { return !this->IsDual(); }
  /// Makes a patch of a level one that Prepare and Refine take.
  virtual void CloseRim(const SurfaceLevel<Id>& /*whole*/, SurfacePatch<Id>& /*patch*/) const {}
  /// Whether a smooth boundary vertex with one face is a corner by default.
  virtual bool HasCornersOfOneFace() const { return false; }
  /// Whether it has rules for joints that are blended (Mathematics 6); else they are sharp.
  virtual bool BlendsJoints() const { return false; }
  /// The eigenvalue l3, the next one after the two of the tangent plane, at a corner whose sector
  /// has k faces and an angle (Mathematics 12, Flatness).
  virtual double GetThirdEigenvalue(int /*k*/, double /*angle*/) const { return 0.; }

  /// Replaces tags for which the scheme has no rules. Is called once, for the control level.
  virtual void RestrictTags(SurfaceLevel<Id>& /*level*/) const {}
  /// Makes the counts that rows or the ids of children need. Is called for each level before all
  /// other methods.
  virtual void Prepare(SurfaceLevel<Id>& /*level*/) const {}
  /// Whether the two halves of edge e are edges 2e and 2e + 1, so that they can inherit sharpness.
  virtual bool HalvesEdges() const { return true; }

  /// About how many faces there are after some steps, to estimate sizes.
  virtual double CountFaces(double faces, double /*corners*/, int steps) const
  {
    return faces * std::pow(4., steps);
  }

  virtual DenseRows GetDenseRows() const { return DenseRows::None; }
  virtual FaceMemory GetFaceMemory() const = 0;

  /// Number of vertices of the next level.
  virtual vtkIdType GetNumberOfRows(const SurfaceLevel<Id>& level) const = 0;
  /// Rows [begin, end) of the operator to the next level, in order.
  virtual void AppendRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags,
    vtkIdType begin, vtkIdType end, RowBlock<Id>& rows) const = 0;
  /// The vertices of this level from which vertex `row` of the next takes values that cannot be
  /// averaged: from the one with the smallest global id.
  virtual void GetParents(
    const SurfaceLevel<Id>& level, vtkIdType row, std::vector<vtkIdType>& parents) const = 0;
  /// The next level. With ForCounts it has only counts (NumberOf..., Arity, FaceOffsets) and Lines
  /// with EdgeVertices; with ForLastStep all that a further step with ForCounts and CarryFaces
  /// read; with ForSteps all that further steps read, where smooth edges need not be stored.
  virtual SurfaceLevel<Id> Refine(const SurfaceLevel<Id>& level, Depth depth) const = 0;
  /// Appends the segments of the next level, from the segments of this one. Needs no more of the
  /// level than the counts of Prepare, and the first corner of each face.
  virtual void ListChildren(const SurfaceLevel<Id>& level, const SurfaceSegments& segments,
    SurfaceSegments& children) const = 0;
  /// Writes the vertices of the next level's faces, one face after the other.
  virtual void WriteFaces(const SurfaceLevel<Id>& level, IdsOut ids) const = 0;
  /// Tags of the next level from tags of this one (there may be several sets for one level).
  virtual SurfaceTags<Id> RefineTags(
    const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags) const = 0;
  /// The number of steps after which each face lies in one face of the level that many steps
  /// before; 0: there is none.
  virtual int GetCarrierPeriod() const { return 1; }
  /// Computes the carriers of the next level's faces from the carriers of this level's faces.
  /// `areWhole` tells that the step ends a carrier period, after which each face lies in one face.
  virtual void CarryFaces(const SurfaceLevel<Id>& level, const Buffer<Carrier<Id>>& faces,
    bool areWhole, Buffer<Carrier<Id>>& children) const = 0;

  /// The face whose orientation a face of the next level has.
  virtual vtkIdType GetOrientingFace(const SurfaceLevel<Id>& /*level*/, vtkIdType child) const
  {
    return child;
  }
  /// Appends one row for each vertex from `begin` to `end` - 1: its limit position, or a tangent
  /// there.
  virtual void AppendLimitRows(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags,
    LimitKind kind, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows) const = 0;
  /// Where rows of the first tangent have these weights in common: the weights that rows of the
  /// second one have in the same columns. Null: rows of the second tangent must be asked for.
  virtual const double* GetSecondTangent(const double* /*first*/) const { return nullptr; }

  // The step from the next level where that level is not made (SkippedLevel.h): as the methods with
  // these names, but told from this level.
  virtual bool SkipsNext(const SurfaceLevel<Id>& /*level*/) const { return false; }
  /// `others` appends rows that are not regular.
  virtual void AppendRowsOfNext(const SurfaceLevel<Id>& /*level*/,
    const IrregularRows<Id>& /*others*/, vtkIdType /*begin*/, vtkIdType /*end*/,
    RowBlock<Id>& /*rows*/) const
  {
  }
  virtual void GetParentsOfNext(
    const SurfaceLevel<Id>& /*level*/, vtkIdType /*row*/, std::vector<vtkIdType>& /*parents*/) const
  {
  }
  virtual void WriteFacesOfNext(const SurfaceLevel<Id>& /*level*/, IdsOut /*ids*/) const {}
  /// Whether limit rows of the next level can be told, too, those of tangents where these are
  /// wanted.
  virtual bool HasLimitsOfNext(const SurfaceLevel<Id>& /*level*/, bool /*tangents*/) const
  {
    return false;
  }
  /// Appends them. Where nothing else is said, all points stay.
  virtual void AppendLimitRowsOfNext(const SurfaceLevel<Id>& /*level*/,
    const IrregularRows<Id>& /*others*/, LimitKind /*kind*/, vtkIdType begin, vtkIdType end,
    RowBlock<Id>& rows) const
  {
    rows.AddCopies(begin, end - begin);
  }
};

}

#endif
