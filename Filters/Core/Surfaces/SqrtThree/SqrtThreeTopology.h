// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SqrtThreeTopology.h
 * Where the children of a level are in a step of the sqrt(3) scheme (SqrtThreeScheme.h): everything
 * by arithmetic.
 *
 * The child across edge ab of a face with apex P (its centre, or in even steps the third of its
 * fixed edge that is nearer to ab), Q the apex on the other side, is (a, Q, P). If the other face
 * runs along the edge in the same direction, the first of the two has that child at a, and the
 * second (b, its own apex, the other): there it keeps its own orientation.
 */
#ifndef SubdivisionObjects_SqrtThreeTopology_h
#define SubdivisionObjects_SqrtThreeTopology_h

#include "Core/Surfaces/Scheme/SurfaceScheme.h"

#include <algorithm>

namespace subdivision
{

/// The carrier of the child across an edge, where the faces there lie in one face each: that of its
/// last corner, which is new, first and then that of the corner before, which is new too.
/// `isSecond`: these two are exchanged in the child (see above).
template <typename Id>
Carrier<Id> JoinSqrtThree(const Carrier<Id>& own, const Carrier<Id>& other, bool isSecond)
{
  return isSecond ? Carrier<Id>{ other.First, own.First } : Carrier<Id>{ own.First, other.First };
}
/// A step later, for the edge that begins with a corner, it is the one face of a new corner: of
/// that where the child is, if the edge joins two.
template <typename Id>
Carrier<Id> PartSqrtThree(const Carrier<Id>& own, int corner, bool isSecond)
{
  const bool isOfLast = corner == 2 || (corner == 1 && isSecond);
  const Id face = isOfLast ? own.First : own.Second;
  return { face, face };
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
    , HasFixed(level.HasCurves)
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

  Id GetNumberOfVertices() const
  {
    return static_cast<Id>(this->Mesh.NumberOfVertices) + this->Centres + 2 * this->Thirds;
  }
  Id GetNumberOfEdges() const
  {
    const Id faces = static_cast<Id>(this->Mesh.NumberOfFaces);
    return this->FirstSpoke + 2 * faces + this->Centres;
  }

  bool IsFixed(Id corner) const
  {
    return this->HasFixed && IsSharp(this->Tags.Edges[this->Mesh.Edges[corner]]);
  }
  /// Whether edges are cut into thirds.
  bool HasThirds() const { return this->Thirds > 0; }
  /// The first of the two points that cut a fixed edge.
  Id GetThird(Id edge) const { return this->Places[this->Mesh.NumberOfFaces + edge]; }
  /// That which is nearer to one of its ends.
  Id GetThirdNear(Id edge, Id vertex) const
  {
    return this->GetThird(edge) + (this->Mesh.EdgeVertices[2 * edge] == vertex ? 0 : 1);
  }
  /// The outer third of a fixed edge at one of its ends, as an edge of the next level.
  Id GetOuterEdge(Id edge, Id vertex) const
  {
    return static_cast<Id>(this->Mesh.GetNumberOfEdges()) + this->GetThirdNear(edge, vertex) -
      static_cast<Id>(this->Mesh.NumberOfVertices) - this->Centres;
  }

  /// The vertex at the centre of a face; -1: it has none.
  Id GetCentre(Id face) const
  {
    return !this->Places        ? static_cast<Id>(this->Mesh.NumberOfVertices) + face
      : this->Places[face] >= 0 ? this->Places[face]
                                : -1;
  }
  /// The edge of a face that is cut into thirds, as its corner.
  Id GetCutCorner(Id face) const { return 3 * face + (-1 - this->Places[face]) % 3; }

  /// What stands across an edge of a face that is not fixed.
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

  /// The corner of the next level whose edge joins the apex of a corner's face to the beginning, or
  /// to the end, of the corner's edge, in the child across that edge.
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
  /// In even steps, for a fixed edge: the same for its outer thirds.
  Id GetOuterSideAtBegin(Id cut) const { return this->GetSideAtEnd(this->Mesh.Previous(cut)); }
  Id GetOuterSideAtEnd(Id cut) const { return this->GetSideAtBegin(this->Mesh.Next(cut)); }

  /// The half-edge of the next level between a corner's vertex and the apex, or the third, that
  /// comes after it.
  Id GetSideOfCorner(Id corner) const
  {
    const bool isCut = this->GetCentre(corner / 3) < 0 && this->GetCutCorner(corner / 3) == corner;
    return isCut ? this->GetOuterSideAtBegin(corner) : this->GetSideAtBegin(corner);
  }

  /// The edge of the next level from the apex across a corner's edge to the beginning, or to the
  /// end, of that edge.
  Id GetSpokeAtBegin(Id corner) const { return this->GetSpoke(corner, corner); }
  Id GetSpokeAtEnd(Id corner) const { return this->GetSpoke(corner, this->Mesh.Next(corner)); }
  /// In even steps: from the vertex opposite to a cut edge to the third nearer to its beginning, or
  /// to its end.
  Id GetCutSpoke(Id cut, bool atEnd) const
  {
    return this->GetFirstSpoke(cut / 3) + (atEnd ? 1 : 0);
  }

  const PolygonMesh<Id>& Mesh;
  const SurfaceTags<Id>& Tags;
  const Id* Places;
  const bool IsEven;
  const bool HasFixed; ///< whether any edge is
  Id Centres = 0;      ///< number of faces that get a centre
  Id Thirds = 0;       ///< number of edges that are cut into thirds

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
  /// The edge of a vertex that cuts it into thirds.
  Id FindCutEdge(Id vertex) const
  {
    const Id* first = this->Places + this->Mesh.NumberOfFaces;
    const Id* last = first + this->Mesh.GetNumberOfEdges();
    return static_cast<Id>(std::upper_bound(first, last, vertex) - first - 1);
  }

private:
  Id CountCentresBefore(Id face) const
  {
    return !this->Places        ? face
      : this->Places[face] >= 0 ? this->Places[face] - static_cast<Id>(this->Mesh.NumberOfVertices)
                                : (-1 - this->Places[face]) / 3;
  }
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

  Id FirstSpoke = 0;
};

}

#endif
