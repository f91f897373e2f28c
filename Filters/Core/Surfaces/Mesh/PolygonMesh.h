// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PolygonMesh.h
 * One level of a surface: polygons, their edges, and how to walk around a vertex.
 *
 * A corner is a vertex of one face, and at the same time the half-edge from it to the face's next
 * corner. Corners of a face are consecutive. Two half-edges on the same edge are twins if no other
 * face has the edge. They may run in the same direction, so that the surface need not be
 * orientable. A fan is a set of faces around a vertex that follow one another across twins: a
 * cycle, or a chain between two edges without twins. Edges without faces (free edges, from line
 * cells) are edges too.
 *
 * Incidence is searched once, on the input (BuildPolygonMesh); a step makes the next level by
 * arithmetic.
 */
#ifndef SubdivisionObjects_PolygonMesh_h
#define SubdivisionObjects_PolygonMesh_h

#include "Core/Memory/Buffer.h"

#include <algorithm>
#include <vector>

namespace subdivision
{

template <typename Id>
struct PolygonMesh
{
  vtkIdType NumberOfVertices = 0;
  vtkIdType NumberOfFaces = 0;
  /// The number of corners of each face if all have 3 or all have 4. Otherwise 0; then FaceOffsets
  /// and CornerFaces are used. On a level that has only its counts FaceOffsets may end early, where
  /// quads follow: GetFirstOfCounted.
  int Arity = 0;
  Buffer<Id> FaceOffsets;
  Buffer<Id> CornerFaces;

  Buffer<Id> Vertices;     ///< of each corner
  Buffer<Id> Edges;        ///< of each corner: to the next one's vertex
  Buffer<Id> Twins;        ///< of each corner: the other one on the edge; -1 for none
  Buffer<Id> EdgeVertices; ///< two for each edge
  Buffer<Id> EdgeCorners;  ///< one for each edge: its first corner; -1: it has no face
  /// Of each vertex: a corner of its fan, or -1 if it has neither faces nor edges. A smaller value
  /// means that the vertex is number -2 - value of Joints.
  Buffer<Id> VertexCorners;

  /// A vertex that is not exactly one fan: it has several fans, a free edge, or an edge of three or
  /// more faces. This is wider than a joint of Mathematics 3.
  struct Joint
  {
    Id Vertex;
    std::vector<Id> Fans;      ///< one corner of each
    std::vector<Id> FreeEdges; ///< edges without faces
  };
  std::vector<Joint> Joints;
  /// Edges of three and more faces, with all their corners.
  struct Sheaf
  {
    Id Edge;
    std::vector<Id> Corners;
  };
  std::vector<Sheaf> Sheaves; ///< ascending by edge

  /// The number of edges of a level that does not store them.
  vtkIdType EdgesNotStored = 0;

  vtkIdType GetNumberOfCorners() const
  {
    return this->Vertices.empty() ? this->Arity * this->NumberOfFaces : this->Vertices.size();
  }
  vtkIdType GetNumberOfEdges() const
  {
    return this->EdgeCorners.empty() ? this->EdgesNotStored : this->EdgeCorners.size();
  }

  Id GetFace(Id corner) const
  {
    switch (this->Arity) // divisions by constants take less time
    {
      case 3:
        return corner / 3;
      case 4:
        return corner / 4;
      default:
        return this->CornerFaces[corner];
    }
  }
  Id GetFirst(Id face) const { return this->Arity ? face * this->Arity : this->FaceOffsets[face]; }
  vtkIdType GetFirstOfCounted(vtkIdType face) const
  {
    const vtkIdType stored = this->FaceOffsets.size() - 1;
    return this->Arity ? this->Arity * face
      : face <= stored ? this->FaceOffsets[face]
                       : this->FaceOffsets[stored] + 4 * (face - stored);
  }
  Id GetSize(Id face) const
  {
    return this->Arity ? this->Arity : this->FaceOffsets[face + 1] - this->FaceOffsets[face];
  }
  Id Next(Id corner) const
  {
    switch (this->Arity)
    {
      case 3:
        return corner % 3 == 2 ? corner - 2 : corner + 1;
      case 4:
        return corner % 4 == 3 ? corner - 3 : corner + 1;
      default:
      {
        const Id face = this->CornerFaces[corner];
        return corner + 1 == this->FaceOffsets[face + 1] ? this->FaceOffsets[face] : corner + 1;
      }
    }
  }
  Id Previous(Id corner) const
  {
    switch (this->Arity)
    {
      case 3:
        return corner % 3 == 0 ? corner + 2 : corner - 1;
      case 4:
        return corner % 4 == 0 ? corner + 3 : corner - 1;
      default:
      {
        const Id face = this->CornerFaces[corner];
        return corner == this->FaceOffsets[face] ? this->FaceOffsets[face + 1] - 1 : corner - 1;
      }
    }
  }
  /// The end of an edge that is not `vertex`.
  Id GetOtherEnd(Id edge, Id vertex) const
  {
    const Id first = this->EdgeVertices[2 * edge];
    return first == vertex ? this->EdgeVertices[2 * edge + 1] : first;
  }
  const Joint* FindJoint(Id vertex) const
  {
    const Id corner = this->VertexCorners[vertex];
    return corner < -1 ? &this->Joints[-2 - corner] : nullptr;
  }
  /// The edge of three or more faces; null if this one has fewer.
  const Sheaf* FindSheaf(Id edge) const
  {
    const auto at = std::lower_bound(this->Sheaves.begin(), this->Sheaves.end(), edge,
      [](const Sheaf& sheaf, Id e) { return sheaf.Edge < e; });
    return at != this->Sheaves.end() && at->Edge == edge ? &*at : nullptr;
  }
  std::size_t GetMemorySize() const;
};

/// A face on a walk around a vertex: its corner there, and the direction of the walk, which enters
/// the face by one edge at the vertex and leaves it by the other.
template <typename Id>
struct FanStep
{
  Id Corner;
  bool Forward; ///< enters by the edge to the next corner, leaves by the edge from the previous one

  Id GetHalfEdgeIn(const PolygonMesh<Id>& mesh) const
  {
    return this->Forward ? this->Corner : mesh.Previous(this->Corner);
  }
  Id GetHalfEdgeOut(const PolygonMesh<Id>& mesh) const
  {
    return this->Forward ? mesh.Previous(this->Corner) : this->Corner;
  }
  FanStep Turn() const { return { this->Corner, !this->Forward }; }
  /// The next face around the vertex; false where there is none.
  bool Advance(const PolygonMesh<Id>& mesh)
  {
    const Id out = this->GetHalfEdgeOut(mesh);
    const Id twin = mesh.Twins[out];
    if (twin < 0)
    {
      return false;
    }
    const Id vertex = mesh.Vertices[this->Corner];
    this->Forward = mesh.Vertices[twin] == vertex;
    this->Corner = this->Forward ? twin : mesh.Next(twin);
    return true;
  }
};

/// The first step of a walk through the fan of a corner: in a cycle at the corner itself, in a
/// chain at that end which a walk forward from the corner reaches.
template <typename Id>
FanStep<Id> FindFanStart(const PolygonMesh<Id>& mesh, Id corner)
{
  FanStep<Id> step{ corner, true };
  while (step.Advance(mesh))
  {
    if (step.Corner == corner)
    {
      return { corner, true };
    }
  }
  return step.Turn();
}

/// Calls visit(step) for each face of the fan of a corner, from FindFanStart on. Returns whether
/// the fan is a cycle.
template <typename Id, typename Visit>
bool VisitFan(const PolygonMesh<Id>& mesh, Id corner, const Visit& visit)
{
  FanStep<Id> step = FindFanStart(mesh, corner);
  const Id first = step.Corner;
  do
  {
    visit(step);
    if (!step.Advance(mesh))
    {
      return false;
    }
  } while (step.Corner != first);
  return true;
}

/// visit(step) for each face of a fan that is a cycle, beginning with the corner's.
template <typename Id, typename Visit>
void VisitCycle(const PolygonMesh<Id>& mesh, Id corner, const Visit& visit)
{
  FanStep<Id> step{ corner, true };
  do
  {
    visit(step);
  } while (step.Advance(mesh) && step.Corner != corner);
}

/// The polygons and lines of the input. Each face has at least three different vertices.
template <typename Id>
struct PolygonList
{
  vtkIdType NumberOfVertices = 0;
  Buffer<Id> FaceOffsets;
  Buffer<Id> Vertices;
  /// Segments of line cells, two vertices each.
  Buffer<Id> Segments;
};

/// `segmentEdges`: where each segment lies, 2 edge + (1 if it runs against the edge).
template <typename Id>
PolygonMesh<Id> BuildPolygonMesh(PolygonList<Id>&& list, Buffer<Id>& segmentEdges);

}

#endif
