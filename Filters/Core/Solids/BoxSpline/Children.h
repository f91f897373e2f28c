// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Children.h
 * One simplex at a time: the ids of its children on the next level, and their corners and edges.
 */
#ifndef SubdivisionObjects_Children_h
#define SubdivisionObjects_Children_h

#include "Core/Solids/Complex/Simplices.h"
#include "Core/Solids/Complex/SimplicialComplex.h"

namespace subdivision
{

/// Ids of the next level, seen from the parent.
template <typename Id>
class ChildIds
{
public:
  explicit ChildIds(const SimplicialComplex<Id>& parent)
    : Parent(parent)
    , InFaceStart(2 * parent.NumberOfEdges)
    , DiagonalStart(2 * parent.NumberOfEdges + 3 * parent.NumberOfFaces)
    , InteriorStart(4 * parent.NumberOfFaces)
  {
  }
  Id Midpoint(Id edge) const { return this->Parent.NumberOfVertices + edge; }
  Id Half(Id edge, Id end) const
  {
    return 2 * edge + (this->Parent.EdgeVertices[2 * edge + vtkIdType(1)] == end ? 1 : 0);
  }
  Id InFace(Id face, int corner) const { return this->InFaceStart + 3 * face + corner; }
  Id Diagonal(Id tet) const { return this->DiagonalStart + tet; }
  Id Face(Id face, int child) const { return 4 * face + child; }
  Id Interior(Id tet, int face) const { return this->InteriorStart + 8 * tet + face; }
  Id Tet(Id tet, int child) const { return 8 * tet + child; }

private:
  const SimplicialComplex<Id>& Parent;
  const Id InFaceStart;
  const Id DiagonalStart;
  const Id InteriorStart;
};

/// The ids of what one step makes on the edges and faces of one tetrahedron. Indices are local
/// numbers in the tetrahedron.
template <typename Id>
struct TetParts
{
  Id Lattice[10];
  Id Halves[6][4];  ///< edge, vertex: the half at the vertex
  Id InFaces[4][4]; ///< face, vertex: the child edge that cuts the vertex off
  Id Corners[4][4]; ///< face, vertex: the child triangle at the vertex
  Id Middles[4];    ///< face: the child triangle in the middle
  Id Tet;

  TetParts(const SimplicialComplex<Id>& complex, const ChildIds<Id>& ids, Id tet)
    : Tet(tet)
  {
    const Id* vertices = complex.TetVertices.data() + 4 * vtkIdType(tet);
    const Id* edges = complex.TetEdges.data() + 6 * vtkIdType(tet);
    const Id* faces = complex.TetFaces.data() + 4 * vtkIdType(tet);
    for (int i = 0; i < 4; ++i)
    {
      this->Lattice[i] = vertices[i];
    }
    for (int e = 0; e < 6; ++e)
    {
      this->Lattice[4 + e] = ids.Midpoint(edges[e]);
      for (int end : tetrahedron::EdgeVertices[e])
      {
        this->Halves[e][end] = ids.Half(edges[e], vertices[end]);
      }
    }
    for (int f = 0; f < 4; ++f)
    {
      this->Middles[f] = ids.Face(faces[f], 3);
      for (int vertex : tetrahedron::FaceVertices[f])
      {
        const int position = complex.VertexInFace(faces[f], vertices[vertex]);
        this->InFaces[f][vertex] = ids.InFace(faces[f], position);
        this->Corners[f][vertex] = ids.Face(faces[f], position);
      }
    }
  }

  Id GetEdge(const tetrahedron::ChildEdge& edge, const ChildIds<Id>& ids) const
  {
    switch (edge.Origin)
    {
      case tetrahedron::EdgeOrigin::HalfEdge:
        return this->Halves[edge.Index][edge.Corner];
      case tetrahedron::EdgeOrigin::InFace:
        return this->InFaces[edge.Index][edge.Corner];
      default:
        return ids.Diagonal(this->Tet);
    }
  }
  Id GetFace(const tetrahedron::ChildFace& face, const ChildIds<Id>& ids) const
  {
    switch (face.Origin)
    {
      case tetrahedron::FaceOrigin::FaceCorner:
        return this->Corners[face.Index][face.Corner];
      case tetrahedron::FaceOrigin::FaceMiddle:
        return this->Middles[face.Index];
      default:
        return ids.Interior(this->Tet, face.Index);
    }
  }
};

/// The four children of a triangle.
template <typename Id>
struct TriangleChildren
{
  Id Vertices[4 * 3];
  Id Edges[4 * 3];

  TriangleChildren(const SimplicialComplex<Id>& complex, const ChildIds<Id>& ids, Id face)
  {
    const Id* vertices = complex.FaceVertices.data() + 3 * vtkIdType(face);
    const Id* edges = complex.FaceEdges.data() + 3 * vtkIdType(face);
    const Id lattice[6] = { vertices[0], vertices[1], vertices[2], ids.Midpoint(edges[0]),
      ids.Midpoint(edges[1]), ids.Midpoint(edges[2]) };
    for (int c = 0; c < 4; ++c)
    {
      for (int k = 0; k < 3; ++k)
      {
        this->Vertices[3 * c + k] = lattice[triangle::Children[c][k]];
        this->Edges[3 * c + k] = c == 3      ? ids.InFace(face, triangle::MiddleEdgeCorner[k])
          : triangle::VertexOpposite[k] == c ? ids.InFace(face, c)
                                             : ids.Half(edges[k], vertices[c]);
      }
    }
  }
};

/// The eight children of a tetrahedron.
template <typename Id>
struct TetChildren
{
  Id Vertices[8 * 4];
  Id Edges[8 * 6];

  TetChildren(const TetParts<Id>& parts, const ChildIds<Id>& ids)
  {
    for (int c = 0; c < 8; ++c)
    {
      for (int k = 0; k < 4; ++k)
      {
        this->Vertices[4 * c + k] = parts.Lattice[tetrahedron::Children[c][k]];
      }
      for (int k = 0; k < 6; ++k)
      {
        this->Edges[6 * c + k] = parts.GetEdge(tetrahedron::ChildEdges[c][k], ids);
      }
    }
  }
};

}

#endif
