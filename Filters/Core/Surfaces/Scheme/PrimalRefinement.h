// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PrimalRefinement.h
 * The two splits that halve edges (Mathematics 2, 12): a triangle into 4 triangles, a polygon of n
 * corners into n quads. All ids of children are arithmetic.
 *
 * With V vertices, E edges, F faces and C corners on a level, the next one has
 *  - vertices: v stays v; the point of edge e is V + e, of face f (quads only) V + E + f;
 *  - edges: 2e and 2e + 1 are the halves of e, in its direction; inside, 2E + c for each corner c:
 *    across the triangle near c, or from the point of c's edge to the face point;
 *  - faces: 4f + i at corner i of triangle f, 4f + 3 its middle; or c at corner c.
 */
#ifndef SubdivisionObjects_PrimalRefinement_h
#define SubdivisionObjects_PrimalRefinement_h

#include "Core/Surfaces/Scheme/SurfaceScheme.h"

namespace subdivision
{

/// The two triangles at whose edge a new point lies, on the level that a step of triangles made.
template <typename Id>
struct TrianglesOfEdgePoint
{
  Id Children[2]; ///< the first corner of their children
  Id Edges[2];    ///< which of its edges it is, for each triangle

  /// False: two triangles have the edge in the same direction, or not two have it.
  bool Find(const PolygonMesh<Id>& mesh, Id point)
  {
    const Id corner = mesh.VertexCorners[point];
    if (corner < 0)
    {
      return false;
    }
    // The half of the half-edge that ends at x1 of its triangle, and so is in the child at x1, and
    // the half of its twin.
    const Id twin = mesh.Twins[corner];
    if (twin < 0 || twin % 12 % 4 != 0)
    {
      return false; // a boundary, or the other triangle has the edge in the same direction
    }
    this->Children[0] = corner / 12 * 12;
    this->Children[1] = twin / 12 * 12;
    this->Edges[0] = corner % 12 == 3 ? 0 : corner % 12 == 7 ? 1 : 2;
    this->Edges[1] = twin % 12 / 4;
    return true;
  }
};

/// Finds the six vertices around the point of an edge on a level that a step of triangles made, or
/// the edges to them, in the order of VisitCycle: without a walk, of which each step would wait for
/// the one before. False: it takes a walk.
template <bool OfEdges = false, typename Id>
bool FindRingOfEdgePoint(const PolygonMesh<Id>& mesh, Id point, Id ring[6])
{
  constexpr Id seconds[3] = { 3, 7, 2 }; // the second halves of a triangle's edges
  TrianglesOfEdgePoint<Id> triangles;
  if (!triangles.Find(mesh, point))
  {
    return false;
  }
  for (int side = 0; side < 2; ++side)
  {
    const Id* children = (OfEdges ? mesh.Edges : mesh.Vertices).data() + triangles.Children[side];
    const Id edge = triangles.Edges[side];
    const Id next = (edge + 1) % 3;
    // Child i has old vertex i as its corner i, and the middle child has the edge points.
    ring[3 * side] = children[OfEdges ? seconds[edge] : 4 * next];
    ring[3 * side + 1] = children[9 + (OfEdges ? edge : next)];
    ring[3 * side + 2] = children[9 + (edge + 2) % 3];
  }
  return true;
}

/// Finds the four quads around the point of an edge or a face on a level that a step to quads made,
/// in the order of VisitCycle: the first corner of each. `own`: the corner of the point in the
/// first and third of them, and in the others. False: it takes a walk, because it is on the
/// boundary, two faces have the edge in the same direction, or the face had not four corners.
template <typename Id>
bool FindQuadsOfNewPoint(const PolygonMesh<Id>& mesh, Id point, Id quads[4], Id own[2])
{
  const Id corner = mesh.VertexCorners[point];
  if (corner < 0)
  {
    return false;
  }
  const Id first = corner / 4 * 4;
  if (corner % 4 == 2) // of a face: the children follow one another
  {
    if (first + 16 > mesh.Twins.size() || mesh.Twins[first + 13] != corner)
    {
      return false;
    }
    for (Id k = 0; k < 4; ++k)
    {
      quads[k] = first + 4 * k;
    }
    own[0] = own[1] = 2;
    return true;
  }
  // The two children at the edge on this side of it, then the two on the other side.
  const Id second = mesh.Twins[first + 2] - 1;
  const Id third = mesh.Twins[second];
  if (corner % 4 != 3 || third < 0 || third % 4 != 3)
  {
    return false;
  }
  quads[0] = first;
  quads[1] = second;
  quads[2] = third - 3;
  quads[3] = mesh.Twins[third - 1] - 1;
  own[0] = 3;
  own[1] = 1;
  return true;
}

/// Finds the neighbours of the point of an edge or a face, and the vertices opposite in the quads
/// between them. False: it takes a walk.
template <typename Id>
bool FindRingOfNewPoint(const PolygonMesh<Id>& mesh, Id point, Id ring[8])
{
  Id quads[4];
  Id own[2];
  if (!FindQuadsOfNewPoint(mesh, point, quads, own))
  {
    return false;
  }
  for (int k = 0; k < 4; ++k)
  {
    const Id* quad = mesh.Vertices.data() + quads[k];
    ring[2 * k] = quad[(own[k % 2] + 1) % 4];
    ring[2 * k + 1] = quad[(own[k % 2] + 2) % 4];
  }
  return true;
}

/// Base class of the schemes that halve edges: with Arity 3 each triangle becomes four, with Arity
/// 4 each polygon becomes quads.
template <typename Id, int Arity>
class PrimalScheme : public SurfaceScheme<Id>
{
public:
  bool NeedsTriangles() const override { return Arity == 3; }
  vtkIdType GetNumberOfRows(const SurfaceLevel<Id>& level) const override
  {
    return level.Mesh.NumberOfVertices + level.Mesh.GetNumberOfEdges() +
      (Arity == 4 ? level.Mesh.NumberOfFaces : 0);
  }
  void GetParents(
    const SurfaceLevel<Id>& level, vtkIdType row, std::vector<vtkIdType>& parents) const override;
  void GetParentsOfNext(
    const SurfaceLevel<Id>& level, vtkIdType row, std::vector<vtkIdType>& parents) const override;
  SurfaceLevel<Id> Refine(const SurfaceLevel<Id>& level, Depth depth) const override;
  void ListChildren(const SurfaceLevel<Id>& level, const SurfaceSegments& segments,
    SurfaceSegments& children) const override;
  void WriteFaces(const SurfaceLevel<Id>& level, IdsOut ids) const override;
  void WriteFacesOfNext(const SurfaceLevel<Id>& level, IdsOut ids) const override;
  /// Halves of an edge have its tag, its midpoint the vertex tag that corresponds to it, and old
  /// vertices keep theirs. All other edges and vertices are smooth.
  SurfaceTags<Id> RefineTags(
    const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags) const override;
  void CarryFaces(const SurfaceLevel<Id>& level, const Buffer<Carrier<Id>>& faces, bool,
    Buffer<Carrier<Id>>& children) const override;
  vtkIdType GetOrientingFace(const SurfaceLevel<Id>& level, vtkIdType child) const override
  {
    return Arity == 3 ? child / 4 : vtkIdType(level.Mesh.GetFace(static_cast<Id>(child)));
  }
};

}

#endif
