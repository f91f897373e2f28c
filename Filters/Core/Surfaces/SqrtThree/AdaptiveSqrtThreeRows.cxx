// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/SqrtThree/AdaptiveSqrtThreeRows.h"

#include "Core/Memory/Ids.h"
#include "Core/Operators/ForBlocks.h"
#include "Core/Rules/Pi.h"
#include "Core/Surfaces/Scheme/SurfaceSides.h"
#include "Core/Surfaces/SqrtThree/SqrtThreeMasks.h"

#include <cmath>
#include <map>

namespace subdivision
{
namespace
{

/// Added vertices have six neighbours. These are the weights of the mean of the neighbours in the
/// limit (eq. 7) and in a step (eq. 2).
constexpr double LimitOfRing = 1. / 2.;
constexpr double StepOfRing = 1. / 3.;

}

template <typename Id>
AdaptiveSqrtThreeRows<Id>::AdaptiveSqrtThreeRows(const AdaptiveSqrtThree<Id>& mesh,
  const SurfaceLevel<Id>& control, const SurfaceScheme<Id>& scheme)
  : Mesh(mesh)
  , Control(control)
  , Scheme(scheme)
  , PowerRows(control.Mesh.NumberOfVertices, -1)
{
  ForEach(control.Mesh.NumberOfVertices,
    [&](vtkIdType v)
    {
      const Id corner = control.Mesh.VertexCorners[v];
      if (control.Tags.Vertices[v] == VertexTag::Smooth && corner >= 0)
      {
        int n = 0;
        VisitCycle(control.Mesh, corner, [&n](const FanStep<Id>&) { ++n; });
        this->PowerRows[v] = n;
      }
    });
  std::map<int, int> rows{ { -1, 0 } }; // by valence
  this->AddPowers(1. / 3.);
  for (int& row : this->PowerRows)
  {
    const auto [found, isNew] = rows.emplace(row, static_cast<int>(this->Powers.size()));
    if (isNew)
    {
      this->AddPowers(std::max(0., 2. / 3. - GetSqrtThreeRingWeight(row)));
    }
    row = found->second;
  }
}

template <typename Id>
void AdaptiveSqrtThreeRows<Id>::AddPowers(double factor)
{
  this->Powers.emplace_back();
  for (int level = 0; level < MostLevels; ++level)
  {
    this->Powers.back()[level] = std::pow(factor, level);
  }
}

template <typename Id>
bool AdaptiveSqrtThreeRows<Id>::HasFixedEdges(Id face) const
{
  const Id corner = 3 * face;
  return this->Mesh.IsFixed(corner) || this->Mesh.IsFixed(corner + 1) ||
    this->Mesh.IsFixed(corner + 2);
}

// ------------------------------------------------------------------------------------------------
// Positions

template <typename Id>
double AdaptiveSqrtThreeRows<Id>::GetPart(Id vertex, int level) const
{
  int row = 0;
  bool isOnCurve = false;
  if (vertex < this->Mesh.GetNumberOfControlVertices())
  {
    row = this->PowerRows[vertex];
    isOnCurve = row == 0;
  }
  else
  {
    const auto& added = this->Mesh.GetAdded(vertex);
    level -= added.Level;
    isOnCurve = added.Source < 0;
  }
  return this->Powers[row][std::min(isOnCurve ? level - level % 2 : level, MostLevels - 1)];
}

/// Where a vertex is on a level.
template <typename Id>
void AdaptiveSqrtThreeRows<Id>::AddPosition(
  Id vertex, int level, double weight, RowBlock<Id>& rows) const
{
  if (vertex >= this->Mesh.GetNumberOfControlVertices())
  {
    const auto& added = this->Mesh.GetAdded(vertex);
    if (level == added.Level && added.Source >= 0 && this->HasFixedEdges(added.Source))
    {
      this->AddCorners(added.Source, weight, rows);
      return;
    }
  }
  const double own = this->GetPart(vertex, level);
  rows.Add(2 * static_cast<vtkIdType>(vertex), weight * own);
  if (own < 1.)
  {
    rows.Add(2 * static_cast<vtkIdType>(vertex) + 1, weight * (1. - own));
  }
}

/// The centre of a face as it comes into being.
template <typename Id>
void AdaptiveSqrtThreeRows<Id>::AddCorners(Id face, double weight, RowBlock<Id>& rows) const
{
  for (int i = 0; i < 3; ++i)
  {
    this->AddPosition(
      this->Mesh.GetVertices(face)[i], this->Mesh.GetLevel(face), weight / 3., rows);
  }
}

/// The point that a face puts across one of its edges, as it comes into being.
template <typename Id>
void AdaptiveSqrtThreeRows<Id>::AddApex(Id corner, double weight, RowBlock<Id>& rows) const
{
  if (this->Mesh.IsCut(corner / 3))
  {
    bool isSecond = false;
    const Id segment = this->Mesh.GetThirdAcross(corner, isSecond);
    this->AddThird(segment, isSecond, weight, rows);
    return;
  }
  this->AddCorners(corner / 3, weight, rows);
}

/// The same for the face on the other side of the edge. If this does not exist yet, it is computed
/// from the face that must be split for it.
template <typename Id>
void AdaptiveSqrtThreeRows<Id>::AddApexAcross(Id corner, double weight, RowBlock<Id>& rows) const
{
  const Id twin = this->Mesh.GetTwin(corner);
  if (twin >= 0)
  {
    this->AddApex(twin, weight, rows);
    return;
  }
  const int level = this->Mesh.GetLevel(corner / 3);
  this->AddPosition(this->Mesh.GetVertex(corner), level, weight / 3., rows);
  this->AddPosition(this->Mesh.GetVertex(this->Mesh.Next(corner)), level, weight / 3., rows);
  this->AddApex(this->Mesh.GetTwin(this->Mesh.FindMissing(corner)), weight / 3., rows);
}

/// A third of a segment ab as it comes into being: (16 a + 10 b + z) / 27, where z, the neighbour
/// of a on the other side, follows from the limit of a, (z + 4 a + b) / 6; at ends and corners as
/// well, where the limit is a.
template <typename Id>
void AdaptiveSqrtThreeRows<Id>::AddThird(
  Id segment, bool isSecond, double weight, RowBlock<Id>& rows) const
{
  const auto& piece = this->Mesh.GetSegmentAt(segment);
  const Id near = piece.Ends[isSecond ? 1 : 0];
  const Id far = piece.Ends[isSecond ? 0 : 1];
  this->AddPosition(near, piece.Level, weight * 4. / 9., rows);
  this->AddPosition(far, piece.Level, weight / 3., rows);
  rows.Add(2 * static_cast<vtkIdType>(near) + 1, weight * 2. / 9.);
}

// ------------------------------------------------------------------------------------------------
// Limits of centres

template <typename Id>
void AdaptiveSqrtThreeRows<Id>::AddCentreLimit(Id face, double weight, RowBlock<Id>& rows) const
{
  if (!this->HasFixedEdges(face))
  {
    this->AddRegularLimit(face, weight, rows);
    return;
  }
  // The ring after the next step: centres, and the thirds of fixed edges.
  const int level = this->Mesh.GetLevel(face) + 1;
  const double ring = weight * LimitOfRing / 6.;
  this->AddNext(face, weight * (1. - LimitOfRing), rows);
  for (Id corner = 3 * face; corner < 3 * face + 3; ++corner)
  {
    if (this->Mesh.IsFixed(corner))
    {
      this->AddThird(this->Mesh.GetSegment(corner), false, ring, rows);
      this->AddThird(this->Mesh.GetSegment(corner), true, ring, rows);
      continue;
    }
    this->AddApexAcross(corner, 2. / 3. * ring, rows);
    this->AddCorners(face, 2. / 3. * ring, rows);
    this->AddPosition(this->Mesh.GetVertex(corner), level, ring / 3., rows);
    this->AddPosition(this->Mesh.GetVertex(this->Mesh.Next(corner)), level, ring / 3., rows);
  }
}

/// Adds (1 - b) p + b mean(ring). The ring of the centre p of a face are the corners of the face
/// and the centres of its neighbours.
template <typename Id>
void AdaptiveSqrtThreeRows<Id>::AddRegularLimit(Id face, double weight, RowBlock<Id>& rows) const
{
  const int level = this->Mesh.GetLevel(face);
  const double ring = weight * LimitOfRing / 6.;
  double corners[3];
  std::fill(corners, corners + 3, weight * (1. - LimitOfRing) / 3.);
  for (int i = 0; i < 3; ++i)
  {
    const Id corner = 3 * face + i;
    const Id twin = this->Mesh.GetTwin(corner);
    if (twin < 0 || this->Mesh.IsCut(twin / 3))
    {
      this->AddApexAcross(corner, ring, rows);
      continue;
    }
    corners[i] += ring / 3.;
    corners[(i + 1) % 3] += ring / 3.;
    this->AddPosition(this->Mesh.GetVertex(this->Mesh.Previous(twin)), level, ring / 3., rows);
  }
  for (int i = 0; i < 3; ++i)
  {
    const Id vertex = this->Mesh.GetVertices(face)[i];
    this->AddPosition(vertex, level, corners[i], rows);
    this->AddPosition(vertex, level + 1, ring, rows);
  }
}

/// Adds the value of the centre p of a face one step after its first level. Each fixed edge ab of
/// the face gives it a ghost neighbour a + b - p (Mathematics 11).
template <typename Id>
void AdaptiveSqrtThreeRows<Id>::AddNext(Id face, double weight, RowBlock<Id>& rows) const
{
  const int level = this->Mesh.GetLevel(face) + 1;
  const double ring = weight * StepOfRing / 6.;
  double own = weight * (1. - StepOfRing);
  for (Id corner = 3 * face; corner < 3 * face + 3; ++corner)
  {
    const Id a = this->Mesh.GetVertex(corner);
    this->AddPosition(a, level, ring, rows);
    if (this->Mesh.IsFixed(corner))
    {
      own -= ring;
      this->AddPosition(a, level, ring, rows);
      this->AddPosition(this->Mesh.GetVertex(this->Mesh.Next(corner)), level, ring, rows);
    }
    else
    {
      this->AddApexAcross(corner, ring, rows);
    }
  }
  this->AddCorners(face, own, rows);
}

/// Adds a neighbour of the centre of the face (P, Q, a) of AppendLimitOnEdge, where `vertex` is a
/// and `corner` the other edge at a of one of the two faces: the centre of the child across that
/// edge or, if it is fixed, the point on it that is nearer to a.
template <typename Id>
void AdaptiveSqrtThreeRows<Id>::AddSideAt(
  Id vertex, Id corner, double weight, RowBlock<Id>& rows) const
{
  const Id face = corner / 3;
  if (this->Mesh.IsFixed(corner))
  {
    const Id segment = this->Mesh.GetSegment(corner);
    this->AddThird(segment, this->Mesh.GetSegmentAt(segment).Ends[0] != vertex, weight, rows);
    return;
  }
  this->AddApexAcross(corner, weight / 3., rows);
  this->AddCorners(face, weight / 3., rows);
  this->AddPosition(vertex, this->Mesh.GetLevel(face) + 1, weight / 3., rows);
}

// ------------------------------------------------------------------------------------------------
// Rows

template <typename Id>
void AdaptiveSqrtThreeRows<Id>::AppendVertex(Id vertex, RowBlock<Id>& rows) const
{
  if (vertex < this->Mesh.GetNumberOfControlVertices())
  {
    rows.Add(vertex, 1.);
    rows.EndRow();
    this->Scheme.AppendLimitRows(
      this->Control, this->Control.Tags, LimitKind::Position, vertex, vertex + 1, rows);
    return;
  }
  const auto& added = this->Mesh.GetAdded(vertex);
  if (added.Source < 0)
  {
    this->AddThird(-1 - added.Source, added.IsSecond, 1., rows);
    rows.EndRow();
    this->AppendThirdLimit(-1 - added.Source, added.IsSecond, rows);
    return;
  }
  if (this->HasFixedEdges(added.Source))
  {
    // One step later its value is a third of this first value and two thirds of the limit.
    this->AddNext(added.Source, 3., rows);
    this->AddCentreLimit(added.Source, -2., rows);
  }
  else
  {
    this->AddCorners(added.Source, 1., rows);
  }
  rows.EndRow();
  this->AppendCentreLimit(added.Source, rows);
}

template <typename Id>
void AdaptiveSqrtThreeRows<Id>::AppendCentre(Id face, RowBlock<Id>& rows) const
{
  this->AddCorners(face, 1., rows);
  rows.EndRow();
}

template <typename Id>
void AdaptiveSqrtThreeRows<Id>::AppendCentreLimit(Id face, RowBlock<Id>& rows) const
{
  this->AddCentreLimit(face, 1., rows);
  rows.EndRow();
}

/// As AddRegularLimit of the face (P, Q, a) between the centres P and Q of the two faces of an edge
/// ab, on the next level.
template <typename Id>
void AdaptiveSqrtThreeRows<Id>::AppendLimitOnEdge(
  Id corner, bool isFromEnd, RowBlock<Id>& rows) const
{
  const Id twin = this->Mesh.GetTwin(corner);
  Id a = this->Mesh.GetVertex(corner);
  Id b = this->Mesh.GetVertex(this->Mesh.Next(corner));
  if (isFromEnd)
  {
    std::swap(a, b);
  }
  const int level = this->Mesh.GetLevel(corner / 3) + 1;
  const double ring = LimitOfRing / 6.;
  const double own = (1. - LimitOfRing + ring) / 3.; // in the face and in the one across PQ
  for (const Id face : { corner / 3, twin / 3 })
  {
    this->AddCorners(face, own, rows);
    this->AddNext(face, ring, rows);
  }
  this->AddPosition(a, level, (1. - LimitOfRing) / 3., rows);
  this->AddPosition(a, level + 1, ring, rows);
  this->AddPosition(b, level, ring / 3., rows);
  for (const Id side : { corner, twin })
  {
    const bool isFirst = this->Mesh.GetVertex(side) == a;
    this->AddSideAt(a, isFirst ? this->Mesh.Previous(side) : this->Mesh.Next(side), ring, rows);
  }
  rows.EndRow();
}

template <typename Id>
void AdaptiveSqrtThreeRows<Id>::AppendThirdLimit(
  Id segment, bool isSecond, RowBlock<Id>& rows) const
{
  const auto& piece = this->Mesh.GetSegmentAt(segment);
  this->AddPosition(piece.Ends[isSecond ? 1 : 0], piece.Level + 2, 1. / 6., rows);
  this->AddThird(segment, isSecond, 2. / 3., rows);
  this->AddThird(segment, !isSecond, 1. / 6., rows);
  rows.EndRow();
}

// ------------------------------------------------------------------------------------------------
// Tangents

template <typename Id>
void AdaptiveSqrtThreeRows<Id>::AppendTangent(Id vertex, LimitKind kind, RowBlock<Id>& rows) const
{
  if (vertex < this->Mesh.GetNumberOfControlVertices())
  {
    this->Scheme.AppendLimitRows(this->Control, this->Control.Tags, kind, vertex, vertex + 1, rows);
    return;
  }
  const auto& added = this->Mesh.GetAdded(vertex);
  if (added.Source < 0)
  {
    this->AddThirdTangent(vertex, kind, rows);
  }
  else
  {
    this->AddCentreTangent(added.Source, kind, rows);
  }
  rows.EndRow();
}

/// Adds the tangent of the centre of a face: the sum over its ring with the weights cos or sin of
/// the angle. The ring is on its first level or, if the face has fixed edges, on the next level.
template <typename Id>
void AdaptiveSqrtThreeRows<Id>::AddCentreTangent(Id face, LimitKind kind, RowBlock<Id>& rows) const
{
  const int level = this->Mesh.GetLevel(face) + 1;
  const bool hasFixed = this->HasFixedEdges(face);
  for (int i = 0; i < 3; ++i)
  {
    const Id corner = 3 * face + i;
    const Id ends[2] = { this->Mesh.GetVertex(corner),
      this->Mesh.GetVertex(this->Mesh.Next(corner)) };
    for (int j = 0; j < 2; ++j)
    {
      const double angle = (2 * i + j) * Pi / 3.;
      const double weight = kind == LimitKind::Tangent1 ? std::cos(angle) : std::sin(angle);
      if (!hasFixed && j == 0)
      {
        this->AddPosition(ends[0], level, weight, rows);
      }
      else if (!hasFixed)
      {
        this->AddApexAcross(corner, weight, rows);
      }
      else if (this->Mesh.IsFixed(corner))
      {
        const Id segment = this->Mesh.GetSegment(corner);
        this->AddThird(segment, this->Mesh.GetSegmentAt(segment).Ends[0] != ends[j], weight, rows);
      }
      else
      {
        this->AddPosition(ends[j], level, weight / 3., rows);
        this->AddApexAcross(corner, weight / 3., rows);
        this->AddCorners(face, weight / 3., rows);
      }
    }
  }
}

template <typename Id>
Id AdaptiveSqrtThreeRows<Id>::FindFaceOfTangents(Id vertex) const
{
  if (vertex < this->Mesh.GetNumberOfControlVertices())
  {
    return subdivision::FindFaceOfTangents(this->Control.Mesh, this->Control.Tags, vertex);
  }
  const auto& added = this->Mesh.GetAdded(vertex);
  const Id face = added.Source >= 0 ? added.Source : this->FindCutFace(added);
  return face < 0 ? face : this->Mesh.GetControlFace(face);
}

/// The first triangle beside a point that cuts a segment; -1: the segment has no faces.
template <typename Id>
Id AdaptiveSqrtThreeRows<Id>::FindCutFace(const typename AdaptiveSqrtThree<Id>::Vertex& added) const
{
  const auto& piece = this->Mesh.GetSegmentAt(-1 - added.Source);
  return piece.NumberOfSides > 0 ? this->Mesh.GetChild(this->Mesh.GetSide(piece, 0)) : -1;
}

/// Adds the tangent of a point that cuts a segment: along the curve, or across it into the first
/// face at the segment, in which three triangles lie at the point.
template <typename Id>
void AdaptiveSqrtThreeRows<Id>::AddThirdTangent(Id vertex, LimitKind kind, RowBlock<Id>& rows) const
{
  const auto& added = this->Mesh.GetAdded(vertex);
  const Id segment = -1 - added.Source;
  const auto& piece = this->Mesh.GetSegmentAt(segment);
  const Id end = piece.Ends[added.IsSecond ? 1 : 0];
  const Id face = this->FindCutFace(added);
  const Id cut = 3 * face; // the first corner
  const bool isAtBegin = face < 0 ? !added.IsSecond : this->Mesh.GetVertex(cut) == end;
  if (kind == LimitKind::Tangent1)
  {
    const double turn = isAtBegin ? 1. : -1.;
    this->AddThird(segment, !added.IsSecond, turn, rows);
    this->AddPosition(end, added.Level, -turn, rows);
    return;
  }
  if (face >= 0)
  {
    const SqrtThreeTransversalMask mask(3);
    this->AddThird(segment, added.IsSecond, mask.Own, rows);
    this->AddThird(segment, !added.IsSecond, mask.End, rows);
    this->AddPosition(end, added.Level, mask.End, rows);
    this->AddPosition(
      this->Mesh.GetVertex(this->Mesh.Previous(cut)), added.Level, mask.Inside[1], rows);
    this->AddApexAcross(
      isAtBegin ? this->Mesh.Previous(cut) : this->Mesh.Next(cut), mask.Inside[2], rows);
  }
}

// ------------------------------------------------------------------------------------------------
// The operator

/// Passes the rows of values between.
template <typename Id>
void AdaptiveSqrtThreeLimit<Id>::ForEachBlockBetween(const User& use) const
{
  for (std::size_t level = 0; level + 1 < this->Levels.size(); ++level)
  {
    const vtkIdType first = this->Levels[level];
    ForRanges(this->Levels[level + 1] - first,
      [&](vtkIdType from, vtkIdType to)
      {
        RowBlock<Id> block;
        ForBlocks(first + from, first + to,
          [&](vtkIdType begin, vtkIdType end)
          {
            block.Clear();
            for (vtkIdType v = begin; v < end; ++v)
            {
              this->Rows.AppendVertex(static_cast<Id>(v), block);
            }
            WeightedRows<Id> rows = block.GetRows(2 * begin);
            rows.FromBetween = level > 0;
            rows.ToBetween = true;
            use(rows);
          });
      });
  }
}

template <typename Id>
void AdaptiveSqrtThreeLimit<Id>::ForEachBlock(const User& use) const
{
  this->ForEachBlockBetween(use);
  ForRanges(this->GetNumberOfRows(),
    [&](vtkIdType from, vtkIdType to)
    {
      RowBlock<Id> block;
      ForBlocks(from, to,
        [&](vtkIdType begin, vtkIdType end)
        {
          block.Clear();
          for (vtkIdType v = begin; v < end; ++v)
          {
            block.Add(2 * v + 1, 1.);
            block.EndRow();
          }
          WeightedRows<Id> rows = block.GetRows(begin);
          rows.FromBetween = true;
          use(rows);
        });
    });
}

template <typename Id>
void AdaptiveSqrtThreeLimit<Id>::FindTangents(
  const Buffer<double>& in, TangentPairs& tangents) const
{
  Buffer<double> values(3 * this->GetNumberBetween());
  this->ForEachBlockBetween(
    [&](const RowsView& view)
    {
      const bool fromBetween = std::get<WeightedRows<Id>>(view).FromBetween;
      SumRows(view, fromBetween ? values.data() : in.data(), values.data(), 3);
    });
  const vtkIdType given = this->GetNumberOfColumns();
  ForRanges(this->GetNumberOfRows(),
    [&](vtkIdType begin, vtkIdType end)
    {
      RowBlock<Id> rows;
      for (vtkIdType v = begin; v < end; ++v)
      {
        const double* points = given > v ? in.data() : values.data();
        for (int t = 0; t < 2; ++t)
        {
          rows.Clear();
          this->Rows.AppendTangent(
            static_cast<Id>(v), t == 0 ? LimitKind::Tangent1 : LimitKind::Tangent2, rows);
          rows.Apply(points, tangents.Values[t].data() + 3 * v, 3);
          tangents.Errors[v] += GetTangentError(rows, 0, points, DoubleUnit);
        }
      }
    });
}

SUBDIVISION_COMPILE(class AdaptiveSqrtThreeRows);
SUBDIVISION_COMPILE(class AdaptiveSqrtThreeLimit);

}
