// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SqrtThreeTopology.h
 * Computes the ids of children in a step of the sqrt(3) scheme (SqrtThreeScheme.h).
 *
 * The *apex* P of a face across its edge ab is its centre; in even steps, in a face with a fixed
 * edge, that one of the two points on the fixed edge which is nearer to ab. With Q the apex of the
 * other face across ab, the child of the face across ab is (a, Q, P). If both faces run along ab in
 * the same direction, the face with the smaller number has this child, and the other one the child
 * (b, P, Q), where P is its own apex. So each child has the orientation of its own face.
 */
#ifndef SubdivisionObjects_SqrtThreeTopology_h
#define SubdivisionObjects_SqrtThreeTopology_h

#include "Core/Surfaces/Scheme/SurfaceScheme.h"

#include <algorithm>

namespace subdivision
{

/// The carrier of the child across an edge if both faces at the edge lie in one control face each:
/// First is the control face of its last corner, Second the control face of the corner before,
/// which are both new. `isSecond`: the child is the child of the second face, (b, P, Q), in which P
/// and Q are exchanged.
template <typename Id>
Carrier<Id> JoinSqrtThree(const Carrier<Id>& own, const Carrier<Id>& other, bool isSecond)
{
  return isSecond ? Carrier<Id>{ other.First, own.First } : Carrier<Id>{ own.First, other.First };
}
/// The carrier of a child one step later, across the edge that begins with corner 0 to 2 of a face
/// with the carrier `own`: the control face of the one new corner of the face at the edge. If the
/// edge joins both new corners, the child lies at one of them, which counts.
template <typename Id>
Carrier<Id> PartSqrtThree(const Carrier<Id>& own, int corner, bool isSecond)
{
  const bool isOfLast = corner == 2 || (corner == 1 && isSecond);
  const Id face = isOfLast ? own.First : own.Second;
  return { face, face };
}

/// A step makes three faces around a vertex. Returns by how many corners each follows the one
/// before, from the one with the vertex's corner on; 0: no step made the vertex. At the centre of
/// face f the step makes the children 3 f + i. In each of these the half-edge from the centre
/// begins child 9 f + 3 i + 2 of the next step, whose first half-edge begins child 3 (9 f + 3 i +
/// 2) of the step after it, and so on.
template <typename Id>
Id GetStrideOfMade(Id corner)
{
  Id stride = 3;
  while (corner > 0 && corner % 3 == 0)
  {
    corner /= 3;
    stride *= 3;
  }
  return corner % 9 == 2 ? stride : 0;
}

template <typename Id>
class SqrtThreeTopology
{
public:
  explicit SqrtThreeTopology(const SurfaceLevel<Id>& level)
    : Mesh(level.Mesh)
    , Tags(level.Tags)
    , Places(level.Places.empty() ? nullptr : level.Places.data())
    , IsEven(level.Step % 2 == 1)
    , AnyFixed(level.HasCurves)
  {
    const vtkIdType edges = this->Mesh.GetNumberOfEdges();
    if (this->Places)
    {
      this->Centres = this->Places[this->Mesh.NumberOfFaces + edges];
      this->Thirds = this->Places[this->Mesh.NumberOfFaces + edges + 1];
    }
    else
    {
      this->Centres = static_cast<Id>(this->Mesh.NumberOfFaces);
    }
    this->FirstSpoke = static_cast<Id>(edges) + 2 * this->Thirds;
  }

  Id GetEndOfCentres() const
  {
    return static_cast<Id>(this->Mesh.NumberOfVertices) + this->Centres;
  }
  Id GetNumberOfVertices() const { return this->GetEndOfCentres() + 2 * this->Thirds; }
  vtkIdType GetNumberOfFaces() const { return 3 * this->Mesh.NumberOfFaces; }
  vtkIdType GetNumberOfCorners() const { return 9 * this->Mesh.NumberOfFaces; }
  Id GetNumberOfEdges() const
  {
    const Id faces = static_cast<Id>(this->Mesh.NumberOfFaces);
    return this->FirstSpoke + 2 * faces + this->Centres;
  }

  bool IsFixed(Id corner) const
  {
    return this->AnyFixed && IsSharp(this->Tags.Edges[this->Mesh.Edges[corner]]);
  }
  bool HasFixed() const { return this->AnyFixed; }
  /// Whether edges are cut into thirds.
  bool HasThirds() const { return this->Thirds > 0; }
  int GetPiecesOfFixed() const { return this->HasThirds() ? 3 : 1; }
  /// The first of the two points that cut a fixed edge.
  Id GetFirstPoint(Id edge) const { return this->Places[this->Mesh.NumberOfFaces + edge]; }
  /// The one of these two that is nearer to an end of the edge.
  Id GetThirdNear(Id edge, Id vertex) const
  {
    return this->GetFirstPoint(edge) + (this->Mesh.EdgeVertices[2 * edge] == vertex ? 0 : 1);
  }
  /// The outer third of a fixed edge at one of its ends, as an edge of the next level.
  Id GetOuterEdge(Id edge, Id vertex) const
  {
    return static_cast<Id>(this->Mesh.GetNumberOfEdges()) + this->GetThirdNear(edge, vertex) -
      this->GetEndOfCentres();
  }

  /// A fixed edge, or one of its thirds: the middle third keeps its number.
  Id GetPiece(Id edge, int i) const
  {
    const bool isWhole = !this->HasThirds() || i == 1;
    return isWhole ? edge : this->GetOuterEdge(edge, this->Mesh.EdgeVertices[2 * edge + i / 2]);
  }
  EdgeTag GetEdgeTag(vtkIdType edge, const SurfaceTags<Id>& tags) const
  {
    return edge < this->Mesh.GetNumberOfEdges() ? tags.Edges[edge]
      : edge < this->FirstSpoke                 ? EdgeTag::Sharp
                                                : EdgeTag::Smooth;
  }

  /// The vertex at the centre of a face; -1: it has none.
  Id GetCentre(Id face) const
  {
    return !this->Places        ? static_cast<Id>(this->Mesh.NumberOfVertices) + face
      : this->Places[face] >= 0 ? this->Places[face]
                                : -1;
  }
  /// The fixed edge of a face that gets no centre, as its corner.
  Id GetCutCorner(Id face) const { return 3 * face + (-1 - this->Places[face]) % 3; }

  /// The apex of a corner's face across the corner's edge, which is not fixed.
  Id GetApex(Id corner) const
  {
    const Id face = corner / 3;
    const Id centre = this->GetCentre(face);
    if (centre >= 0)
    {
      return centre;
    }
    const Id cut = this->GetCutCorner(face);
    const Id near = this->Mesh.Next(cut) == corner ? corner : cut;
    return this->GetThirdNear(this->Mesh.Edges[cut], this->Mesh.Vertices[near]);
  }

  /// Whether the two faces at an edge run along it in the same direction.
  bool RunsWith(Id corner, Id twin) const
  {
    return this->Mesh.Vertices[corner] == this->Mesh.Vertices[twin];
  }

  /// The half-edge of the next level between the apex of a corner's face and the beginning, or the
  /// end, of the corner's edge, in the child across that edge.
  Id GetSideAtBegin(Id corner) const
  {
    if (this->IsFixed(corner))
    {
      return 3 * corner + 2;
    }
    const Id twin = this->Mesh.Twins[corner];
    return this->RunsWith(corner, twin) && twin < corner ? 3 * twin : 3 * corner + 2;
  }
  Id GetSideAtEnd(Id corner) const
  {
    if (this->IsFixed(corner))
    {
      return 3 * corner + 1;
    }
    const Id twin = this->Mesh.Twins[corner];
    return !this->RunsWith(corner, twin) ? 3 * twin : corner < twin ? 3 * twin + 2 : 3 * corner;
  }
  /// In even steps, the half-edge on the outer third of a fixed edge at its beginning, or at its
  /// end.
  Id GetOuterSideAtBegin(Id cut) const { return this->GetSideAtEnd(this->Mesh.Previous(cut)); }
  Id GetOuterSideAtEnd(Id cut) const { return this->GetSideAtBegin(this->Mesh.Next(cut)); }

  /// The corner of one end of a fixed edge in the child at this end, beside the edge. A child at
  /// the outer third of a cut edge begins with that vertex.
  Id GetCornerAtEnd(Id fixed, Id vertex) const
  {
    const bool isBegin = this->Mesh.Vertices[fixed] == vertex;
    if (!this->IsEven)
    {
      return 3 * fixed + (isBegin ? 0 : 1);
    }
    const Id side = isBegin ? this->GetOuterSideAtBegin(fixed) : this->GetOuterSideAtEnd(fixed);
    return side - side % 3;
  }

  /// A half-edge of the next level at the vertex of a corner, in the same fan: to the apex across
  /// the corner's edge or, if this edge is cut, to the point on it.
  Id GetHalfEdgeAt(Id corner) const
  {
    const bool isCut = this->GetCentre(corner / 3) < 0 && this->GetCutCorner(corner / 3) == corner;
    return isCut ? this->GetOuterSideAtBegin(corner) : this->GetSideAtBegin(corner);
  }

  /// The edge of the next level between the apex of a corner's face across the corner's edge and
  /// the beginning of that edge.
  Id GetSpokeAtBegin(Id corner) const { return this->GetSpoke(corner, corner); }
  /// In even steps the edge between the point on a cut edge that is nearer to its beginning, or to
  /// its end, and the vertex opposite to the cut edge.
  Id GetCutSpoke(Id cut, bool atEnd) const
  {
    return this->GetFirstSpoke(cut / 3) + (atEnd ? 1 : 0);
  }

  const PolygonMesh<Id>& Mesh;
  const SurfaceTags<Id>& Tags;
  const Id* Places;
  const bool IsEven;
  Id Centres = 0; ///< number of faces that get a centre
  Id Thirds = 0;  ///< number of edges that are cut into thirds

  /// The face of a centre, by its number.
  Id FindFace(Id centre) const
  {
    Id first = 0;
    Id last = static_cast<Id>(this->Mesh.NumberOfFaces);
    while (this->Places && last - first > 1)
    {
      const Id middle = first + (last - first) / 2;
      (this->CountCentresBefore(middle) <= centre ? first : last) = middle;
    }
    return this->Places ? first : centre;
  }
  /// The edge that a vertex cuts into thirds.
  Id FindCutEdge(Id vertex) const
  {
    const Id* first = this->Places + this->Mesh.NumberOfFaces;
    const Id* last = first + this->Mesh.GetNumberOfEdges();
    return static_cast<Id>(std::upper_bound(first, last, vertex) - first - 1);
  }

  /// How many faces before this one get a centre; `face` may be the number of all faces.
  Id CountCentresBefore(Id face) const
  {
    if (!this->Places)
    {
      return face;
    }
    if (face == this->Mesh.NumberOfFaces)
    {
      return this->Centres;
    }
    return this->Places[face] >= 0
      ? this->Places[face] - static_cast<Id>(this->Mesh.NumberOfVertices)
      : (-1 - this->Places[face]) / 3;
  }
  /// The same for edges that are cut into thirds.
  Id CountThirdsBefore(Id edge) const
  {
    if (!this->Places || edge == this->Mesh.GetNumberOfEdges())
    {
      return this->Thirds;
    }
    return (this->GetFirstPoint(edge) - this->GetEndOfCentres()) / 2;
  }

private:
  Id GetFirstSpoke(Id face) const
  {
    return this->FirstSpoke + 2 * face + this->CountCentresBefore(face);
  }
  /// `end`: the corner at that end of the edge.
  Id GetSpoke(Id corner, Id end) const
  {
    const Id face = corner / 3;
    if (this->GetCentre(face) >= 0)
    {
      return this->GetFirstSpoke(face) + end % 3;
    }
    const Id cut = this->GetCutCorner(face);
    const bool atEnd = this->Mesh.Next(cut) == corner; // the apex is the third near the end
    const Id opposite = this->Mesh.Previous(cut);
    return end == opposite ? this->GetCutSpoke(cut, atEnd)
                           : this->GetOuterEdge(this->Mesh.Edges[cut], this->Mesh.Vertices[end]);
  }

  const bool AnyFixed;
  Id FirstSpoke = 0;
};

}

#endif
