// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DualPlaces.h
 * What the dual schemes share (Mathematics 12): where the children of a step begin, and what
 * becomes of lines and of vertices without faces.
 *
 * A dual step makes a vertex face of each fan, and no vertex keeps its place. A side is an edge
 * as faces see it: two twins, or a corner without twin, so that sheets come apart at edges of three
 * and more faces. Vertices without faces, and those of line and vertex cells, are kept beside the
 * surface: lines become curves of their own, by the d = 1 rule of Mathematics 5.
 *
 * Everything is numbered in the order of corners, vertices and lines, never of edges: a level is
 * the same whether it was refined or built anew from its cells. Refined levels know edges of lines
 * only: they have no Edges, and vertices without faces are no joints.
 */
#ifndef SubdivisionObjects_DualPlaces_h
#define SubdivisionObjects_DualPlaces_h

#include "Core/Surfaces/Scheme/SurfaceScheme.h"

#include <algorithm>
#include <functional>

namespace subdivision
{

template <typename Id>
struct DualPlaces
{
  Buffer<Id> Sides; ///< of each corner: how many sides there are whose first corner is before it
  Buffer<Id> OpenSides; ///< the same for corners without twins
  Buffer<Id> Faces;     ///< of each vertex: the vertex faces before its own
  Buffer<Id> Corners;   ///< and their corners
  Buffer<Id> Chains;    ///< and how many fans before its own are chains
  Buffer<Id> Kept;      ///< and how many vertices are kept before it
  std::vector<Id> KeptVertices;
  std::vector<Id> Segments;   ///< of each line; lines on one edge are one segment
  std::vector<Id> FirstLines; ///< of each segment
  std::vector<Id> Around;     ///< two for each kept vertex: its neighbours on a curve, or -1

  vtkIdType GetNumberOfSides() const { return this->Sides[this->Sides.size() - 1]; }
  vtkIdType GetNumberOfOpenSides() const { return this->OpenSides[this->OpenSides.size() - 1]; }
  vtkIdType GetNumberOfFaces() const { return this->Faces[this->Faces.size() - 1]; }
  vtkIdType GetNumberOfCorners() const { return this->Corners[this->Corners.size() - 1]; }
  vtkIdType GetNumberOfChains() const { return this->Chains[this->Chains.size() - 1]; }
  /// Vertices of the next level that no face uses.
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

/// The corners of the vertex face of a fan of k faces, a cycle or a chain; less than 3: none.
using VertexFaceSize = std::function<vtkIdType(vtkIdType k, bool cycle)>;

template <typename Id>
std::shared_ptr<const DualPlaces<Id>> CountDualPlaces(
  const SurfaceLevel<Id>& level, const VertexFaceSize& size);

/// The rows of vertices that are kept (cubic B-splines along curves), then of midpoints of lines.
template <typename Id>
void AppendLoneRow(const SurfaceLevel<Id>& level, vtkIdType row, RowBlock<Id>& rows);
template <typename Id>
void GetLoneParents(const SurfaceLevel<Id>& level, vtkIdType row, std::vector<vtkIdType>& parents);
/// Lines and vertex cells of the next level, whose lone vertices begin with `first`.
template <typename Id>
void RefineLines(const SurfaceLevel<Id>& level, vtkIdType first, SurfaceLevel<Id>& next);

/// Writes the carriers of vertex faces: what the faces of their fans share.
template <typename Id>
void CarryFans(const SurfaceLevel<Id>& level, const Buffer<Carrier<Id>>& faces,
  const VertexFaceSize& size, Carrier<Id>* fans);

/// Which one is the i-th that was counted.
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

/// visit(corner) for the first corner of each fan of a vertex.
template <typename Id, typename Visit>
void VisitFansOf(const PolygonMesh<Id>& mesh, Id vertex, const Visit& visit)
{
  if (mesh.VertexCorners[vertex] >= 0)
  {
    visit(mesh.VertexCorners[vertex]);
  }
  else if (const auto* joint = mesh.FindJoint(vertex))
  {
    for (Id corner : joint->Fans)
    {
      visit(corner);
    }
  }
}

/// visit(step) for each face of the fan of a corner, in the direction in which the corner's face
/// goes forward: the vertices of a vertex face in this order are oriented as that face is. True: a
/// cycle.
template <typename Id, typename Visit>
bool VisitFanForward(const PolygonMesh<Id>& mesh, Id corner, const Visit& visit)
{
  FanStep<Id> step{ corner, false };
  bool cycle = false;
  while (!cycle && step.Advance(mesh))
  {
    cycle = step.Corner == corner;
  }
  step = cycle ? FanStep<Id>{ corner, true } : step.Turn();
  const Id first = step.Corner;
  do
  {
    visit(step);
  } while (step.Advance(mesh) && step.Corner != first);
  return cycle;
}

}

#endif
