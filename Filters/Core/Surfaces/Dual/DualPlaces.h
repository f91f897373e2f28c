// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DualPlaces.h
 * The common parts of the dual schemes (Mathematics 12): running counts from which the ids of
 * children follow, and the steps of lines and of vertices without faces.
 *
 * A dual step makes out of each fan a face, its *vertex face*. A *side* is two twins, or a corner
 * without twin (an *open* side); so an edge of three or more faces is several sides, and the
 * surface comes apart there. Vertices without faces, and vertices of line and vertex cells, are
 * *kept*: they have a child of their own beside the surface, and lines become curves by the rule d
 * = 1 of Mathematics 5. Children of kept vertices and midpoints of lines are the *lone* vertices,
 * which no face uses.
 *
 * All numbers follow from the order of corners, vertices and lines, not of edges. So a level is the
 * same whether it was refined or built from its cells. A refined level has no PolygonMesh::Edges,
 * its only edges are lines, and its vertices without faces are no joints.
 */
#ifndef SubdivisionObjects_DualPlaces_h
#define SubdivisionObjects_DualPlaces_h

#include "Core/Surfaces/Mesh/CycleWalks.h"
#include "Core/Surfaces/Scheme/SurfaceRings.h"

#include <algorithm>
#include <vector>

namespace subdivision
{

template <typename Id>
struct DualPlaces
{
  Buffer<Id> Sides; ///< of each corner: how many sides there are whose first corner is before it
  Buffer<Id> OpenSides; ///< the same for corners without twins; empty if all have one
  Buffer<Id> Faces;     ///< of each vertex: the number of vertex faces at vertices before it
  Buffer<Id> Corners;   ///< of each vertex: the number of corners of these faces
  Buffer<Id> Chains;    ///< of each vertex: the number of chains at vertices before it; empty: none
  Buffer<Id> Kept;      ///< of each vertex: the number of kept vertices before it; empty: none
  std::vector<Id> KeptVertices;
  std::vector<Id> Segments;   ///< of each line; lines on one edge are one segment
  std::vector<Id> FirstLines; ///< of each segment
  std::vector<Id> Around;  ///< for each kept vertex its two neighbours on a curve; the first is -1
                           ///< if it is on none
  vtkIdType FirstLone = 0; ///< the number of vertices of the next level besides the lone ones
  bool HasQuads = false;   ///< whether the next level has a face along each side
  int OfChain = 0;         ///< how many corners more than faces of its fan the face of a chain has

  /// The corners of the vertex face of a fan of k faces, a cycle or a chain; less than 3: none.
  vtkIdType GetFaceSize(std::size_t k, bool cycle) const
  {
    return static_cast<vtkIdType>(k) + (cycle ? 0 : this->OfChain);
  }
  vtkIdType GetNumberOfSides() const { return this->Sides[this->Sides.size() - 1]; }
  vtkIdType GetNumberOfOpenSides() const
  {
    return this->OpenSides.empty() ? 0 : this->OpenSides[this->OpenSides.size() - 1];
  }
  vtkIdType GetNumberOfQuads() const { return this->HasQuads ? this->GetNumberOfSides() : 0; }
  vtkIdType GetNumberOfFaces() const { return this->Faces[this->Faces.size() - 1]; }
  vtkIdType GetNumberOfCorners() const { return this->Corners[this->Corners.size() - 1]; }
  vtkIdType GetNumberOfChains() const
  {
    return this->Chains.empty() ? 0 : this->Chains[this->Chains.size() - 1];
  }
  /// The number of lone vertices of the next level.
  vtkIdType GetNumberOfLoneRows() const
  {
    return static_cast<vtkIdType>(this->KeptVertices.size() + this->FirstLines.size());
  }
  std::size_t GetMemorySize() const
  {
    return this->Sides.GetMemorySize() + this->OpenSides.GetMemorySize() +
      this->Faces.GetMemorySize() + this->Corners.GetMemorySize() + this->Chains.GetMemorySize() +
      this->Kept.GetMemorySize() +
      sizeof(Id) *
      (3 * this->KeptVertices.size() + this->Segments.size() + this->FirstLines.size());
  }
};

/// `ofChain`: DualPlaces::OfChain. FirstLone and HasQuads are left to the scheme.
template <typename Id>
std::shared_ptr<DualPlaces<Id>> CountDualPlaces(const SurfaceLevel<Id>& level, int ofChain);

/// Appends the row of lone vertex `row`: first come the children of kept vertices (cubic B-splines
/// on curves), then the midpoints of lines.
template <typename Id>
void AppendLoneRow(const SurfaceLevel<Id>& level, vtkIdType row, RowBlock<Id>& rows);
template <typename Id>
void GetLoneParents(const SurfaceLevel<Id>& level, vtkIdType row, std::vector<vtkIdType>& parents);
/// Makes the lines and vertex cells of the next level.
template <typename Id>
void RefineLines(const SurfaceLevel<Id>& level, SurfaceLevel<Id>& next);

/// Appends the segments that all dual schemes have: of lone vertices, of faces, and of lines. Call
/// it after all other vertices are listed.
template <typename Id>
void ListDualChildren(
  const SurfaceLevel<Id>& level, const SurfaceSegments& segments, SurfaceSegments& children);
/// Appends the children of parents that have running counts: `ofEach` for each that is counted.
/// Without counts there are none.
template <typename Id>
void AppendCounted(const IdSegments& parents, const std::vector<vtkIdType>& sizes,
  const Buffer<Id>& before, vtkIdType ofEach, IdSegments& children)
{
  AppendVariedChildren(
    parents, sizes, [&](vtkIdType i) { return before.empty() ? 0 : ofEach * before[i]; }, children);
}

/// SurfaceScheme::CarryFaces: common carriers of the faces at a side or of a fan.
template <typename Id>
void CarryDualFaces(
  const SurfaceLevel<Id>& level, const Buffer<Carrier<Id>>& faces, Buffer<Carrier<Id>>& children);

/// The face of this level whose orientation vertex face number `vertexFace` has.
template <typename Id>
Id FindOrientingFace(const SurfaceLevel<Id>& level, vtkIdType vertexFace);

/// Appends the entries of the limit row of a vertex without faces: on a curve the entries of the
/// cubic B-spline, otherwise the vertex stays.
template <typename Id>
void AppendLoneLimit(const SurfaceLevel<Id>& level, Id vertex, LimitKind kind, RowBlock<Id>& rows);

/// The position of the counted thing number i in the running counts `before`.
template <typename Id>
Id FindByCount(const Buffer<Id>& before, vtkIdType i)
{
  return static_cast<Id>(
    std::upper_bound(before.begin(), before.end(), static_cast<Id>(i)) - before.begin() - 1);
}

/// The first corner of the side of a corner.
template <typename Id>
Id GetFirstOfSide(const PolygonMesh<Id>& mesh, Id corner)
{
  const Id twin = mesh.Twins[corner];
  return twin >= 0 && twin < corner ? twin : corner;
}

/// Finds the steps through the fan of a corner. A cycle begins with the face of the corner. The
/// walk has the direction in which the corner's face is entered forward, so that a vertex face made
/// in this order has the orientation of that face. Returns whether the fan is a cycle.
template <typename Id>
bool FindFanForward(const PolygonMesh<Id>& mesh, Id corner, std::vector<FanStep<Id>>& steps)
{
  FanStep<Id> step{ corner, true };
  steps.clear();
  do
  {
    steps.push_back(step);
    if (!step.Advance(mesh)) // a chain, of which the walk finds the beginning only now
    {
      step = { corner, false };
      while (step.Advance(mesh))
      {
      }
      step = step.Turn();
      steps.clear();
      do
      {
        steps.push_back(step);
      } while (step.Advance(mesh));
      return false;
    }
  } while (step.Corner != corner);
  return true;
}

/// Calls act(vertex, visitFans) for vertices [begin, end), in which visitFans(visit) calls
/// visit(corner, steps, cycle) for each fan of the vertex, as FindFanForward finds them. Walks
/// around several vertices take turns.
template <typename Id, typename Act>
void ForFansForward(const PolygonMesh<Id>& mesh, vtkIdType begin, vtkIdType end, const Act& act)
{
  CycleWalks<Id> walks;
  std::vector<FanStep<Id>> steps;
  for (vtkIdType first = begin; first < end; first += walks.Most)
  {
    const Id last = static_cast<Id>(std::min<vtkIdType>(end, first + walks.Most));
    walks.Walk(mesh, static_cast<Id>(first), last,
      [&mesh](Id vertex) { return mesh.VertexCorners[vertex] >= 0; });
    for (Id vertex = static_cast<Id>(first); vertex < last; ++vertex)
    {
      const bool isKnown = mesh.VertexCorners[vertex] >= 0 && walks.IsCycle(vertex);
      act(vertex,
        [&](const auto& visit)
        {
          VisitFans(mesh, vertex,
            [&](Id corner)
            {
              const bool cycle = isKnown || FindFanForward(mesh, corner, steps);
              visit(corner, isKnown ? walks.Get(vertex) : steps, cycle);
            });
        });
    }
  }
}

}

#endif
