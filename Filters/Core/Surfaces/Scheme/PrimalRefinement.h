// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PrimalRefinement.h
 * The two splits that halve edges (Mathematics 2, 12): a triangle into 4 triangles, a polygon of n
 * corners into n quads. All ids of children are arithmetic.
 *
 * With V vertices, E edges, F faces and C corners on a level, the next one has
 *  - vertices: v stays v; the point of edge e is V + e; that of face f (quads only) V + E + f;
 *  - edges: 2e and 2e + 1 are the halves of e, in its direction; inside, 2E + c for each corner c:
 *    across the triangle near c, or from the point of c's edge to the face point;
 *  - faces: 4f + i at corner i of triangle f, 4f + 3 its middle; or c at corner c.
 */
#ifndef SubdivisionObjects_PrimalRefinement_h
#define SubdivisionObjects_PrimalRefinement_h

#include "Core/Surfaces/Scheme/SurfaceScheme.h"

namespace subdivision
{

template <typename Id>
SurfaceLevel<Id> RefineTriangles(const SurfaceLevel<Id>& level, Depth depth);

template <typename Id>
SurfaceLevel<Id> RefineToQuads(const SurfaceLevel<Id>& level, Depth depth);

/// Finds the six vertices around the point of an edge on a level that RefineTriangles made, in the
/// order of VisitCycle: without a walk, of which each step would wait for the one before. False: it
/// takes a walk, because two triangles have the edge in the same direction, or not two have it.
template <typename Id>
bool FindRingOfEdgePoint(const PolygonMesh<Id>& mesh, Id point, std::vector<Id>& ring);

/// The vertices of the faces of the next level, one face after the other.
template <typename Id, typename Out>
void WriteTriangles(const SurfaceLevel<Id>& level, Out* ids);
template <typename Id, typename Out>
void WriteQuads(const SurfaceLevel<Id>& level, Out* ids);

/// Tags of the next level. Halves of an edge have its tag, its midpoint the vertex tag that
/// corresponds to it, and old vertices keep theirs. All other edges and vertices are smooth.
template <typename Id>
SurfaceTags<Id> RefineTriangleTags(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags);
template <typename Id>
SurfaceTags<Id> RefineToQuadTags(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags);

/// The order of ids after a split.
void ListTriangleChildren(const SurfaceSegments& segments, SurfaceSegments& children);
void ListQuadChildren(const SurfaceSegments& segments, SurfaceSegments& children);

/// Base class of the schemes that split each triangle into four, with one new vertex on each edge.
template <typename Id>
class QuarteringScheme : public SurfaceScheme<Id>
{
public:
  bool NeedsTriangles() const override { return true; }
  vtkIdType GetNumberOfRows(const SurfaceLevel<Id>& level) const override
  {
    return level.Mesh.NumberOfVertices + level.Mesh.GetNumberOfEdges();
  }
  void GetParents(
    const SurfaceLevel<Id>& level, vtkIdType row, std::vector<vtkIdType>& parents) const override
  {
    const vtkIdType edge = row - level.Mesh.NumberOfVertices;
    if (edge < 0)
    {
      parents.assign({ row });
      return;
    }
    parents.assign({ level.Mesh.EdgeVertices[2 * edge], level.Mesh.EdgeVertices[2 * edge + 1] });
  }
  SurfaceLevel<Id> Refine(const SurfaceLevel<Id>& level, Depth depth) const override
  {
    return RefineTriangles(level, depth);
  }
  void ListChildren(const SurfaceLevel<Id>&, const SurfaceSegments& segments,
    SurfaceSegments& children) const override
  {
    ListTriangleChildren(segments, children);
  }
  bool WritesFaces() const override { return true; }
  void WriteFaces(const SurfaceLevel<Id>& level, int* ids) const override
  {
    WriteTriangles(level, ids);
  }
  void WriteFaces(const SurfaceLevel<Id>& level, long long* ids) const override
  {
    WriteTriangles(level, ids);
  }
  SurfaceTags<Id> RefineTags(
    const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags) const override
  {
    return RefineTriangleTags(level, tags);
  }
  void CarryFaces(const SurfaceLevel<Id>& level, const Buffer<Carrier<Id>>& faces, bool,
    Buffer<Carrier<Id>>& children) const override
  {
    children = Buffer<Carrier<Id>>(4 * level.Mesh.NumberOfFaces);
    ForEach(children.size(), [&](vtkIdType i) { children[i] = faces[i / 4]; });
  }
  vtkIdType GetOrientingFace(const SurfaceLevel<Id>&, vtkIdType child) const override
  {
    return child / 4;
  }
};

}

#endif
