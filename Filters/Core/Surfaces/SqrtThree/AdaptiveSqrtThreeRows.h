// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AdaptiveSqrtThreeRows.h
 * Limits of the vertices of an adaptive sqrt(3) mesh (Mathematics 11; Kobbelt, section 4).
 *
 * Two values are stored for each vertex: its first value, which it has on the level where it first
 * exists, and its limit. They give its value m steps later: g^m of the first value, and the rest of
 * the limit (eq. 8). So both values of a vertex are weighted sums of values of vertices of earlier
 * levels: of the face whose centre the vertex is, and of the neighbours of this face. No level of
 * the uniform mesh is made. A point on a curve needs only the two ends of the segment that it cuts,
 * because their limits contain the points beyond.
 *
 * For the centre of a face with fixed edges the formula does not hold on its first level. The first
 * value that is stored for it is the one with which the formula holds on all later levels.
 */
#ifndef SubdivisionObjects_AdaptiveSqrtThreeRows_h
#define SubdivisionObjects_AdaptiveSqrtThreeRows_h

#include "Core/Operators/TangentErrors.h"
#include "Core/Surfaces/SqrtThree/AdaptiveSqrtThree.h"

#include <array>

namespace subdivision
{

template <typename Id>
class AdaptiveSqrtThreeRows
{
public:
  AdaptiveSqrtThreeRows(const AdaptiveSqrtThree<Id>& mesh, const SurfaceLevel<Id>& control,
    const SurfaceScheme<Id>& scheme);

  /// Appends both rows of a vertex, of the first value and of the limit. For control vertices the
  /// columns are control vertices; for others column 2 v is the first value of vertex v, and 2 v +
  /// 1 its limit.
  void AppendVertex(Id vertex, RowBlock<Id>& rows) const;

  /// AppendCentre appends the row of the centre that a face has, or would have if it were split, on
  /// its first level; AppendCentreLimit the row of its limit. The face must not be one that cuts
  /// its edge.
  void AppendCentre(Id face, RowBlock<Id>& rows) const;
  void AppendCentreLimit(Id face, RowBlock<Id>& rows) const;
  /// Appends the row of a limit at one third of an edge, from its beginning or, if `isFromEnd`,
  /// from its end: the limit of the centre of a face of the next level, whether this exists or not.
  /// The twin must exist, and neither face may be one that cuts its edge.
  void AppendLimitOnEdge(Id corner, bool isFromEnd, RowBlock<Id>& rows) const;
  /// Appends the row of the limit of one of the points that cut a segment, whether they exist or
  /// not.
  void AppendThirdLimit(Id segment, bool isSecond, RowBlock<Id>& rows) const;

  /// Appends the row of a tangent, with the columns of AppendVertex. On a curve the first tangent
  /// is along the curve.
  void AppendTangent(Id vertex, LimitKind kind, RowBlock<Id>& rows) const;
  /// The control face whose orientation the tangents of a vertex have; -1: it has no face.
  Id FindFaceOfTangents(Id vertex) const;

  /// The weight of the first value in the value of a vertex on a level; the limit has the rest. Not
  /// for the centre of a face with fixed edges on its first level.
  double GetPart(Id vertex, int level) const;

private:
  static constexpr int MostLevels = 64;

  void AddPowers(double factor);
  bool HasFixedEdges(Id face) const;
  void AddPosition(Id vertex, int level, double weight, RowBlock<Id>& rows) const;
  void AddCorners(Id face, double weight, RowBlock<Id>& rows) const;
  void AddApex(Id corner, double weight, RowBlock<Id>& rows) const;
  void AddApexAcross(Id corner, double weight, RowBlock<Id>& rows) const;
  void AddThird(Id segment, bool isSecond, double weight, RowBlock<Id>& rows) const;
  void AddCentreLimit(Id face, double weight, RowBlock<Id>& rows) const;
  void AddRegularLimit(Id face, double weight, RowBlock<Id>& rows) const;
  void AddCentreTangent(Id face, LimitKind kind, RowBlock<Id>& rows) const;
  void AddThirdTangent(Id vertex, LimitKind kind, RowBlock<Id>& rows) const;
  Id FindCutFace(const typename AdaptiveSqrtThree<Id>::Vertex& added) const;
  void AddNext(Id face, double weight, RowBlock<Id>& rows) const;
  void AddSideAt(Id vertex, Id corner, double weight, RowBlock<Id>& rows) const;

  const AdaptiveSqrtThree<Id>& Mesh;
  const SurfaceLevel<Id>& Control;
  const SurfaceScheme<Id>& Scheme;
  /// Which row of Powers has the powers of g for each control vertex. The first one, of g = 1/3, is
  /// of added vertices, and of curves and corners: there two steps together have g^2 = 1/9.
  std::vector<int> PowerRows;
  /// g^level for each level and each g that there is: so many powers are needed that computing them
  /// would take a fifth of the time.
  std::vector<std::array<double, MostLevels>> Powers;
};

/// The limits of all vertices of a mesh as an operator on arrays of control values. Vertices must
/// be numbered level by level (AdaptiveSqrtThreeOutput); `levels` has the first one of each level,
/// and their number at the end.
template <typename Id>
class AdaptiveSqrtThreeLimit : public PointOperator
{
public:
  AdaptiveSqrtThreeLimit(const AdaptiveSqrtThreeRows<Id>& rows, std::vector<Id> levels)
    : Rows(rows)
    , Levels(std::move(levels))
  {
  }
  vtkIdType GetNumberOfColumns() const override { return this->Levels[1]; }
  vtkIdType GetNumberOfRows() const override { return this->Levels.back(); }
  /// Both values of each vertex.
  vtkIdType GetNumberBetween() const override { return 2 * this->GetNumberOfRows(); }
  void ForEachBlock(const User& use) const override;

  /// Tangents instead of positions, of three coordinates for each control vertex.
  void FindTangents(const Buffer<double>& in, TangentPairs& tangents) const;

private:
  void ForEachBlockBetween(const User& use) const;

  const AdaptiveSqrtThreeRows<Id>& Rows;
  std::vector<Id> Levels;
};

}

#endif
