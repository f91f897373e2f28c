// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AdaptiveSqrtThreeRows.h
 * Limits of the vertices of an adaptive sqrt(3) mesh (Mathematics 11; Kobbelt, section 4).
 *
 * A vertex has two values: the one with which it came into being, and its limit. They give the one
 * that it has on any level: g^m of the first, the rest of the limit, after m steps (eq. 8). So each
 * vertex is a sum of values of vertices of earlier levels, those of the face whose centre it is and
 * of that face's neighbours, and no level of the uniform mesh is ever made. A point on a curve
 * needs only the two ends of the segment that it cuts: what lies beyond is in their limits.
 *
 * The first value of a centre whose face has fixed edges is not the one with which it came into
 * being, for which the formula does not hold, but the one for which it holds from then on.
 */
#ifndef SubdivisionObjects_AdaptiveSqrtThreeRows_h
#define SubdivisionObjects_AdaptiveSqrtThreeRows_h

#include "Core/Operators/TangentErrors.h"
#include "Core/Surfaces/SqrtThree/AdaptiveSqrtThree.h"

namespace subdivision
{

template <typename Id>
class AdaptiveSqrtThreeRows
{
public:
  AdaptiveSqrtThreeRows(const AdaptiveSqrtThree<Id>& mesh, const SurfaceLevel<Id>& control,
    const SurfaceScheme<Id>& scheme);

  /// Both rows of a vertex. Those of control vertices have control vertices as columns; those of
  /// others have 2 v for the first value of vertex v and 2 v + 1 for its limit.
  void AppendVertex(Id vertex, RowBlock<Id>& rows) const;

  /// The rows of the centre that a face has or would have, as it comes into being, and of its
  /// limit; the face must not be cut.
  void AppendCentre(Id face, RowBlock<Id>& rows) const;
  void AppendCentreLimit(Id face, RowBlock<Id>& rows) const;
  /// The same a third along an edge, from the end at `corner` or from the other one: the centre of
  /// a face of the next level, which is there or would be. The twin has to be there, and neither
  /// face may be cut.
  void AppendLimitOnEdge(Id corner, bool isFromEnd, RowBlock<Id>& rows) const;
  /// The same for one of the points that cut a segment.
  void AppendThirdLimit(Id segment, bool isSecond, RowBlock<Id>& rows) const;

  /// The row of a tangent, with the columns of AppendVertex; the first along a curve.
  void AppendTangent(Id vertex, LimitKind kind, RowBlock<Id>& rows) const;
  /// The control face whose orientation the tangents of a vertex have; -1: it has no face.
  Id FindFaceOfTangents(Id vertex) const;

  /// How much of its first value a vertex has on a level; the rest is its limit. Not for a centre
  /// of a face with fixed edges on the level on which it came into being.
  double GetPart(Id vertex, int level) const;

private:
  bool HasFixedEdges(Id face) const;
  void AddPosition(Id vertex, int level, double weight, RowBlock<Id>& rows) const;
  void AddCorners(Id face, double weight, RowBlock<Id>& rows) const;
  void AddApex(Id corner, double weight, RowBlock<Id>& rows) const;
  void AddApexAcross(Id corner, double weight, RowBlock<Id>& rows) const;
  void AddThird(Id segment, bool isSecond, double weight, RowBlock<Id>& rows) const;
  void AddThirdLimit(Id segment, bool isSecond, double weight, RowBlock<Id>& rows) const;
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
  std::vector<double> Factors; ///< g of control vertices; negative: on a curve, or a corner
};

/// Limits of all vertices of a mesh as an operator on arrays of control values. Vertices are
/// numbered level by level: `levels` has the first of each level, and their number at the end.
template <typename Id>
class AdaptiveSqrtThreeLimit
{
public:
  AdaptiveSqrtThreeLimit(const AdaptiveSqrtThreeRows<Id>& rows, std::vector<Id> levels)
    : Rows(rows)
    , Levels(std::move(levels))
  {
  }
  vtkIdType GetNumberOfColumns() const { return this->Levels[1]; }
  vtkIdType GetNumberOfRows() const { return this->Levels.back(); }

  /// What is between is in double.
  template <typename T>
  void Apply(const T* in, T* out, int components) const;
  /// Tangents instead of positions, of three coordinates for each control vertex.
  void FindTangents(const Buffer<double>& in, TangentPairs& tangents) const;

private:
  Buffer<double> GetValues(const Buffer<double>& in, int components) const;

  const AdaptiveSqrtThreeRows<Id>& Rows;
  std::vector<Id> Levels;
};

template <typename Id>
template <typename T>
void AdaptiveSqrtThreeLimit<Id>::Apply(const T* in, T* out, int components) const
{
  Buffer<double> control(this->GetNumberOfColumns() * components);
  ForEach(control.size(), [&](vtkIdType i) { control[i] = static_cast<double>(in[i]); });
  const Buffer<double> values = this->GetValues(control, components);
  ForEach(this->GetNumberOfRows(),
    [&](vtkIdType v)
    {
      for (int c = 0; c < components; ++c)
      {
        out[v * components + c] = Store<T>(values[(2 * v + 1) * components + c]);
      }
    });
}

/// The rows of a block on values, as in RowBlock.
template <typename Id>
void ApplyRows(const RowBlock<Id>& rows, const double* in, double* out, int components)
{
  switch (components)
  {
    case 1:
      rows.template Apply<1>(in, out, 1);
      return;
    case 3:
      rows.template Apply<3>(in, out, 3);
      return;
    default:
      rows.template Apply<0>(in, out, components);
  }
}

}

#endif
