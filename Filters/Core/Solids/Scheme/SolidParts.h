// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SolidParts.h
 * The ids of the next level, seen from the parent, and one simplex or solid at a time: the ids of
 * its descendants. With V vertices, E edges and F faces on a level, the next one has
 *  - vertices: v stays v; the point of edge e is V + e; then the centres of solids;
 *  - edges: 2e, 2e + 1 the halves of e; 2E + 3f + i inside face f near its vertex i; then the inner
 *    edges of solids;
 *  - faces: 4f + i near vertex i of f, 4f + 3 its middle; then the inner faces of solids.
 *  Simplices inside solids come shape by shape, and for each shape solid by solid; so do solids of
 *  each shape. BoxSpline and TetOct list them.
 */
#ifndef SubdivisionObjects_SolidParts_h
#define SubdivisionObjects_SolidParts_h

#include "Core/Solids/Complex/SimplicialComplex.h"
#include "Core/Solids/Scheme/SolidShapes.h"

#include <algorithm>
#include <array>

namespace subdivision
{

/// The solids of one shape on a level.
template <typename Id>
struct SolidList
{
  const Id* Vertices;
  const Id* Edges;
  const Id* Faces;
  const EqualCells<Id>* Equal;
};

/// The tetrahedra of a complex.
template <typename Id>
SolidList<Id> GetTets(const SimplicialComplex<Id>& complex)
{
  return { complex.TetVertices.data(), complex.TetEdges.data(), complex.TetFaces.data(),
    &complex.EqualTets };
}

/// The same on a level that is being made.
template <typename Id>
struct SolidStorage
{
  Id& Number;
  Buffer<Id>& Vertices;
  Buffer<Id>& Edges;
  Buffer<Id>& Faces;
  EqualCells<Id>& Equal;
};

/// Ids of the children of vertices, edges and faces, in any scheme.
template <typename Id>
class SkeletonIds
{
public:
  explicit SkeletonIds(const SimplicialComplex<Id>& parent)
    : Parent(parent)
    , InFaceStart(2 * parent.NumberOfEdges)
  {
  }
  Id Midpoint(Id edge) const { return this->Parent.NumberOfVertices + edge; }
  Id Half(Id edge, Id end) const
  {
    return 2 * edge + (this->Parent.EdgeVertices[2 * edge + vtkIdType(1)] == end ? 1 : 0);
  }
  Id InFace(Id face, int corner) const { return this->InFaceStart + 3 * face + corner; }
  Id Face(Id face, int child) const { return 4 * face + child; }

protected:
  const SimplicialComplex<Id>& Parent;

private:
  const Id InFaceStart;
};

/// The same with simplices inside solids. `Split` says how a scheme splits solids (SolidScheme.h).
template <typename Split>
class ChildIds : public SkeletonIds<typename Split::Id>
{
public:
  using Id = typename Split::Id;
  using Shapes = typename Split::Shapes;
  using Numbers = std::array<Id, Shapes::Size>;

  /// `solids`: how many there are of each shape.
  ChildIds(const SimplicialComplex<Id>& parent, const Numbers& solids)
    : SkeletonIds<Id>(parent)
    , Solids(solids)
    , Vertices(parent.NumberOfVertices + parent.NumberOfEdges)
    , Edges(2 * parent.NumberOfEdges + 3 * parent.NumberOfFaces)
    , Faces(4 * parent.NumberOfFaces)
  {
    ForShapes(Shapes(), [this](auto shape) { this->AddShape(shape); });
    for (int kind = 1; kind < Shapes::Size; ++kind)
    {
      this->CellStart[kind] = this->CellStart[kind - 1] + this->Children[kind - 1];
    }
  }
  explicit ChildIds(const typename Split::Level& parent)
    : ChildIds(parent.Complex, Split::CountSolids(parent))
  {
  }

  template <typename Shape>
  Id Centre(Id solid) const
  {
    return this->CentreStart[Shape::Index] + solid;
  }
  template <typename Shape>
  Id InnerEdge(Id solid, int edge) const
  {
    return this->EdgeStart[Shape::Index] + InnerEdgesOf<Shape> * solid + edge;
  }
  template <typename Shape>
  Id InnerFace(Id solid, int face) const
  {
    return this->FaceStart[Shape::Index] + InnerFacesOf<Shape> * solid + face;
  }
  /// The children of shape Child of a solid.
  template <typename Shape, typename Child>
  Id ChildOf(Id solid, int child) const
  {
    return this->ChildStart[Shape::Index][Child::Index] + ChildrenOf<Shape, Child> * solid + child;
  }
  /// The number by which FaceTets of the next level names a child.
  template <typename Shape>
  Id Cell(Id solid, ChildSolid child) const
  {
    return this->CellStart[child.Shape] + this->ChildStart[Shape::Index][child.Shape] +
      NumbersOfChildren<Shape>[child.Shape] * solid + child.Child;
  }

  Id GetNumberOfSolids(int shape) const { return this->Solids[shape]; }
  /// Numbers of the next level.
  Id GetNumberOfVertices() const { return this->Vertices; }
  Id GetNumberOfEdges() const { return this->Edges; }
  Id GetNumberOfFaces() const { return this->Faces; }
  Id GetNumberOfChildren(int shape) const { return this->Children[shape]; }

private:
  template <typename Shape>
  void AddShape(Shape)
  {
    const Id solids = this->Solids[Shape::Index];
    this->CentreStart[Shape::Index] = this->Vertices;
    this->EdgeStart[Shape::Index] = this->Edges;
    this->FaceStart[Shape::Index] = this->Faces;
    this->Vertices += Shape::Centres * solids;
    this->Edges += InnerEdgesOf<Shape> * solids;
    this->Faces += InnerFacesOf<Shape> * solids;
    for (int child = 0; child < Shapes::Size; ++child)
    {
      this->ChildStart[Shape::Index][child] = this->Children[child];
      this->Children[child] += NumbersOfChildren<Shape>[child] * solids;
    }
  }
  Numbers Solids;
  Id Vertices;
  Id Edges;
  Id Faces;
  Numbers CentreStart{};
  Numbers EdgeStart{};
  Numbers FaceStart{};
  std::array<Numbers, Shapes::Size> ChildStart{};
  Numbers Children{};
  Numbers CellStart{};
};

/// The four children of a triangle.
template <typename Id>
struct TriangleChildren
{
  Id Vertices[4 * 3];
  Id Edges[4 * 3];

  TriangleChildren(const SimplicialComplex<Id>& complex, const SkeletonIds<Id>& ids, Id face)
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

/// The lattice points of a solid.
template <typename Shape, typename Id>
struct SolidLattice
{
  Id Points[PointsOf<Shape>];

  template <typename Ids>
  SolidLattice(const Ids& ids, const Id* vertices, const Id* edges, Id solid)
  {
    std::copy(vertices, vertices + Shape::Vertices, this->Points);
    std::transform(edges, edges + Shape::Edges, this->Points + Shape::Vertices,
      [&ids](Id edge) { return ids.Midpoint(edge); });
    if constexpr (Shape::Centres > 0)
    {
      this->Points[PointsOf<Shape> - 1] = ids.template Centre<Shape>(solid);
    }
  }
  template <typename Ids>
  SolidLattice(const SolidList<Id>& list, const Ids& ids, Id solid)
    : SolidLattice(ids, list.Vertices + Shape::Vertices * vtkIdType(solid),
        list.Edges + Shape::Edges * vtkIdType(solid), solid)
  {
  }
};

/// The ids of all parts that one step makes of one solid, by place.
template <typename Shape, typename Id>
struct SolidParts
{
  SolidLattice<Shape, Id> Lattice;
  Id Edges[2 * Shape::Edges + 3 * Shape::Faces + InnerEdgesOf<Shape>];
  Id Faces[4 * Shape::Faces]; ///< without inner ones
  Id FirstInnerFace;

  template <typename Ids>
  SolidParts(
    const SimplicialComplex<Id>& complex, const SolidList<Id>& list, const Ids& ids, Id solid)
    : Lattice(list, ids, solid)
    , FirstInnerFace(ids.template InnerFace<Shape>(solid, 0))
  {
    const Id* vertices = this->Lattice.Points;
    const Id* edges = list.Edges + Shape::Edges * vtkIdType(solid);
    const Id* faces = list.Faces + Shape::Faces * vtkIdType(solid);
    for (int e = 0; e < Shape::Edges; ++e)
    {
      const Id half = ids.Half(edges[e], vertices[Shape::EdgeVertices[e][1]]);
      this->Edges[2 * e + 1] = half;
      this->Edges[2 * e] = half ^ 1;
    }
    Id* inFaces = this->Edges + 2 * Shape::Edges;
    for (int e = 0; e < InnerEdgesOf<Shape>; ++e)
    {
      inFaces[3 * Shape::Faces + e] = ids.template InnerEdge<Shape>(solid, e);
    }
    for (int f = 0; f < Shape::Faces; ++f)
    {
      this->Faces[4 * f + 3] = ids.Face(faces[f], 3);
      for (int corner = 0; corner < 3; ++corner)
      {
        const int position =
          complex.VertexInFace(faces[f], vertices[Shape::FaceVertices[f][corner]]);
        *inFaces++ = ids.InFace(faces[f], position);
        this->Faces[4 * f + corner] = ids.Face(faces[f], position);
      }
    }
  }

  Id GetFace(int place) const
  {
    return place < 4 * Shape::Faces ? this->Faces[place]
                                    : this->FirstInnerFace + (place - 4 * Shape::Faces);
  }
};

/// The edges of a solid of EqualCells in its own vertex order, taken from its twin.
template <typename Shape, typename Id>
void GetEdgesOfEqual(const SolidList<Id>& list, vtkIdType index, Id* edges)
{
  const vtkIdType twin = list.Equal->Twins[index];
  int local[Shape::Vertices];
  for (int i = 0; i < Shape::Vertices; ++i)
  {
    local[i] = FindPlace<Shape::Vertices>(
      list.Vertices + Shape::Vertices * twin, list.Equal->Vertices[Shape::Vertices * index + i]);
  }
  for (int e = 0; e < Shape::Edges; ++e)
  {
    const int* ends = Shape::EdgeVertices[e];
    edges[e] = list.Edges[Shape::Edges * twin + Shape::EdgeOf[local[ends[0]]][local[ends[1]]]];
  }
}

}

#endif
