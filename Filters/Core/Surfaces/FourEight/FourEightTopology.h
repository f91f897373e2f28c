// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FourEightTopology.h
 * Computes the ids of children in a step of the 4-8 scheme (FourEightScheme.h) from the running
 * counts in SurfaceLevel::Places.
 */
#ifndef SubdivisionObjects_FourEightTopology_h
#define SubdivisionObjects_FourEightTopology_h

#include "Core/Surfaces/Scheme/SurfaceScheme.h"

#include <algorithm>

namespace subdivision
{

template <typename Id>
class FourEightTopology
{
public:
  explicit FourEightTopology(const SurfaceLevel<Id>& level)
    : Mesh(level.Mesh)
    , Tags(level.Tags)
    , IsEven(level.Step % 2 == 1)
    , ChildrenBefore(level.Places.data())
    , CentresBefore(level.Places.size() > CountChildren(this->Mesh)
          ? this->ChildrenBefore + CountChildren(this->Mesh)
          : nullptr)
    , FixedBefore(
        this->CentresBefore ? this->CentresBefore + this->Mesh.NumberOfFaces + 1 : nullptr)
    , StartsBefore(level.Places.size() > CountCommon(this->Mesh)
          ? this->FixedBefore + this->Mesh.GetNumberOfEdges() + 1
          : nullptr)
  {
  }
  /// The number of entries that Places always has: the number of child faces before each corner,
  /// and the total.
  static vtkIdType CountChildren(const PolygonMesh<Id>& mesh)
  {
    return mesh.GetNumberOfCorners() + 1;
  }
  /// The same if some edges are fixed: also the number of centres before each face, and of fixed
  /// edges before each edge, with the totals. If some children are triangles Places has besides the
  /// number of corners of child faces before each corner.
  static vtkIdType CountCommon(const PolygonMesh<Id>& mesh)
  {
    return CountChildren(mesh) + mesh.NumberOfFaces + mesh.GetNumberOfEdges() + 2;
  }

  bool HasFixed() const { return this->FixedBefore != nullptr; }
  Id GetNumberOfCentres() const
  {
    return this->CountCentresBefore(static_cast<Id>(this->Mesh.NumberOfFaces));
  }
  Id GetNumberOfFixed() const
  {
    return this->CountFixedBefore(static_cast<Id>(this->Mesh.GetNumberOfEdges()));
  }
  Id GetNumberOfVertices() const
  {
    return this->GetEndOfCentres() + (this->IsEven ? this->GetNumberOfFixed() : 0);
  }
  Id GetNumberOfFaces() const { return this->ChildrenBefore[this->Mesh.GetNumberOfCorners()]; }
  Id GetNumberOfCorners() const
  {
    return this->GetStart(static_cast<Id>(this->Mesh.GetNumberOfCorners()));
  }
  int GetPiecesOfFixed() const { return this->IsEven && this->HasFixed() ? 2 : 1; }
  Id GetNumberOfPieces() const { return this->GetPiecesOfFixed() * this->GetNumberOfFixed(); }
  Id GetNumberOfEdges() const
  {
    return this->GetNumberOfPieces() +
      this->CountSpokesBefore(static_cast<Id>(this->Mesh.NumberOfFaces),
        static_cast<Id>(this->Mesh.GetNumberOfCorners()));
  }
  bool HasTriangles() const { return this->StartsBefore != nullptr; }

  bool IsFixed(Id corner) const
  {
    return this->HasFixed() && IsSharp(this->Tags.Edges[this->Mesh.Edges[corner]]);
  }
  /// Whether the child face across a corner's edge belongs to this corner, and not to its twin.
  bool HasChild(Id corner) const
  {
    return this->IsFixed(corner) ? !this->IsEven : corner < this->Mesh.Twins[corner];
  }
  Id GetChild(Id corner) const { return this->ChildrenBefore[corner]; }
  /// The corner that a child face belongs to.
  Id FindCornerOf(Id child) const
  {
    return Find(this->ChildrenBefore, this->Mesh.GetNumberOfCorners(), child);
  }
  /// The first corner of that child.
  Id GetStart(Id corner) const
  {
    return this->StartsBefore ? this->StartsBefore[corner] : 4 * this->ChildrenBefore[corner];
  }

  Id GetFirstCentre() const { return static_cast<Id>(this->Mesh.NumberOfVertices); }
  Id GetEndOfCentres() const { return this->GetFirstCentre() + this->GetNumberOfCentres(); }
  /// The vertex at the centre of a face; -1: the face is cut.
  Id GetCentre(Id face) const { return this->IsCut(face) ? Id(-1) : this->GetApex(face); }
  bool IsCut(Id face) const
  {
    return this->HasFixed() && this->CentresBefore[face] == this->CentresBefore[face + 1];
  }
  /// In even steps: the fixed edge of a face, as its corner.
  Id GetCutCorner(Id face) const
  {
    Id corner = this->Mesh.GetFirst(face);
    while (!this->IsFixed(corner))
    {
      ++corner;
    }
    return corner;
  }
  Id GetFirstPoint(Id edge) const { return this->GetEndOfCentres() + this->FixedBefore[edge]; }
  /// The *apex* of a face: its centre or, in a cut face, the middle of its fixed edge.
  Id GetApex(Id face) const
  {
    return !this->HasFixed() ? this->GetFirstCentre() + face
      : this->IsCut(face)    ? this->GetFirstPoint(this->Mesh.Edges[this->GetCutCorner(face)])
                             : this->GetFirstCentre() + this->CentresBefore[face];
  }

  /// A fixed edge, or its half at one end, on the next level.
  Id GetPiece(Id edge, int end) const
  {
    return this->IsEven ? 2 * this->FixedBefore[edge] + end : this->FixedBefore[edge];
  }
  EdgeTag GetEdgeTag(vtkIdType edge, const SurfaceTags<Id>&) const
  {
    return edge < this->GetNumberOfPieces() ? EdgeTag::Sharp : EdgeTag::Smooth;
  }
  /// The *spoke*, an edge of the next level, from the apex of a face to the vertex of a corner. A
  /// cut face has one spoke only, to the vertex opposite to its fixed edge.
  Id GetSpoke(Id face, Id corner) const
  {
    const Id first = this->Mesh.GetFirst(face);
    return this->GetNumberOfPieces() + this->CountSpokesBefore(face, first) +
      (this->IsCut(face) ? 0 : corner - first);
  }

  /// The half-edges of the next level between the apex of a corner's face and both ends of the
  /// corner's edge, in the child across that edge. Not for fixed edges in even steps.
  struct Sides
  {
    Id AtBegin;
    Id AtEnd;
  };
  Sides GetSides(Id corner) const
  {
    const Id twin = this->Mesh.Twins[corner];
    const bool isFixed = this->IsFixed(corner);
    if (isFixed || corner < twin)
    {
      const Id last = this->GetStart(corner) + (isFixed ? 2 : 3);
      return { last, last - 1 };
    }
    const Id start = this->GetStart(twin);
    const bool isFirst = this->Mesh.Vertices[twin] == this->Mesh.Vertices[corner];
    return { isFirst ? start : start + 1, isFirst ? start + 1 : start };
  }
  Id GetSideAtBegin(Id corner) const { return this->GetSides(corner).AtBegin; }
  Id GetSide(Id corner, Id vertex) const
  {
    const Sides sides = this->GetSides(corner);
    return this->Mesh.Vertices[corner] == vertex ? sides.AtBegin : sides.AtEnd;
  }
  /// In even steps: half of a fixed edge, in the face of one of its corners.
  Id GetHalf(Id cut, Id vertex) const
  {
    return this->GetSide(
      this->Mesh.Vertices[cut] == vertex ? this->Mesh.Previous(cut) : this->Mesh.Next(cut), vertex);
  }
  /// A half-edge of the next level at the vertex of a corner, in the same fan.
  Id GetHalfEdgeAt(Id corner) const
  {
    return this->IsEven && this->IsFixed(corner)
      ? this->GetHalf(corner, this->Mesh.Vertices[corner])
      : this->GetSides(corner).AtBegin;
  }

  /// The corner of one end of a fixed edge in the child at this end, beside the edge. In even steps
  /// corners 0 and 2 of a child are old vertices.
  Id GetCornerAtEnd(Id fixed, Id vertex) const
  {
    if (!this->IsEven)
    {
      return this->GetStart(fixed) + (this->Mesh.Vertices[fixed] == vertex ? 0 : 1);
    }
    const Id half = this->GetHalf(fixed, vertex);
    const Id place = half % 4;
    return half - place + (place == 1 || place == 2 ? 2 : 0);
  }

  /// The face of a centre, by its running number, and the fixed edge that a vertex cuts.
  Id FindFace(Id centre) const
  {
    return this->HasFixed() ? Find(this->CentresBefore, this->Mesh.NumberOfFaces, centre) : centre;
  }
  Id FindCutEdge(Id vertex) const
  {
    return Find(this->FixedBefore, this->Mesh.GetNumberOfEdges(), vertex - this->GetEndOfCentres());
  }

  Id CountCentresBefore(Id face) const
  {
    return this->HasFixed() ? this->CentresBefore[face] : face;
  }
  Id CountFixedBefore(Id edge) const { return this->HasFixed() ? this->FixedBefore[edge] : 0; }
  /// A face has one spoke for each corner, a cut triangle only one.
  Id CountSpokesBefore(Id face, Id firstCorner) const
  {
    return firstCorner - 2 * (face - this->CountCentresBefore(face));
  }

  const PolygonMesh<Id>& Mesh;
  const SurfaceTags<Id>& Tags;
  const bool IsEven;

private:
  static Id Find(const Id* before, vtkIdType size, Id number)
  {
    return static_cast<Id>(std::upper_bound(before, before + size, number) - before - 1);
  }
  const Id* ChildrenBefore;
  const Id* CentresBefore;
  const Id* FixedBefore;
  const Id* StartsBefore;
};

}

#endif
