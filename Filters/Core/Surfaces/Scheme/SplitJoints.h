// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SplitJoints.h
 * The common part of all steps for edges that they cut into pieces or keep: with joints, sheaves,
 * and lines.
 *
 * `Split` says how: an edge has `GetNumberOfPieces()` pieces, GetPiece(edge, i) from its first end
 * on, and between these the points GetPoint(edge, i). For a corner of a face at the edge,
 * GetOnPiece(corner, i) is the half-edge there of the next level, and GetCornerAt(corner, i) the
 * corner at a point in the same face. GetCornerInFan(corner) is a corner of the next level at the
 * vertex of a corner, in the same fan.
 */
#ifndef SubdivisionObjects_SplitJoints_h
#define SubdivisionObjects_SplitJoints_h

#include "Core/Memory/Loops.h"
#include "Core/Surfaces/Mesh/PolygonMesh.h"

namespace subdivision
{

/// Makes the joints and sheaves of the next level. The children of joints are joints, and pieces of
/// sheaves are sheaves. The points that cut sheaves and free edges become joints.
template <typename Id, typename Split>
void SplitJoints(const PolygonMesh<Id>& mesh, const Split& split, PolygonMesh<Id>& out)
{
  using Joint = typename PolygonMesh<Id>::Joint;
  using Sheaf = typename PolygonMesh<Id>::Sheaf;
  const int pieces = split.GetNumberOfPieces();
  std::vector<Id> freeEdges;
  for (const Joint& joint : InTurn(mesh.Joints))
  {
    Joint child{ joint.Vertex, {}, {} };
    for (const Id corner : joint.Fans)
    {
      child.Fans.push_back(split.GetCornerInFan(corner));
    }
    for (const Id edge : joint.FreeEdges)
    {
      const bool isFirst = mesh.EdgeVertices[2 * edge] == joint.Vertex;
      child.FreeEdges.push_back(split.GetPiece(edge, isFirst ? 0 : pieces - 1));
      if (isFirst)
      {
        freeEdges.push_back(edge);
      }
    }
    out.Joints.push_back(std::move(child));
  }
  const auto addJoint = [&](Id vertex, std::vector<Id> fans, std::vector<Id> edges)
  {
    out.VertexCorners[vertex] = static_cast<Id>(-2 - static_cast<vtkIdType>(out.Joints.size()));
    out.Joints.push_back({ vertex, std::move(fans), std::move(edges) });
  };
  for (const Id edge : InTurn(freeEdges))
  {
    for (int i = 0; i + 1 < pieces; ++i)
    {
      addJoint(
        split.GetPoint(edge, i), {}, { split.GetPiece(edge, i), split.GetPiece(edge, i + 1) });
    }
  }
  for (const Sheaf& sheaf : InTurn(mesh.Sheaves))
  {
    for (int i = 0; i < pieces; ++i)
    {
      Sheaf piece{ split.GetPiece(sheaf.Edge, i), {} };
      std::vector<Id> fans;
      for (const Id corner : sheaf.Corners)
      {
        piece.Corners.push_back(split.GetOnPiece(corner, i));
        if (i + 1 < pieces)
        {
          fans.push_back(split.GetCornerAt(corner, i));
        }
      }
      out.Sheaves.push_back(std::move(piece));
      if (i + 1 < pieces)
      {
        addJoint(split.GetPoint(sheaf.Edge, i), std::move(fans), {});
      }
    }
  }
  std::sort(out.Sheaves.begin(), out.Sheaves.end(),
    [](const Sheaf& a, const Sheaf& b) { return b.Edge > a.Edge; });
}

/// The lines of the next level (SurfaceLevel::Lines).
template <typename Id, typename Split>
Buffer<Id> SplitLines(const Buffer<Id>& lines, const Split& split)
{
  const int pieces = split.GetNumberOfPieces();
  Buffer<Id> children(pieces * lines.size());
  ForEach(children.size(),
    [&](vtkIdType i)
    {
      const Id line = lines[i / pieces];
      const Id against = line % 2;
      const int at = static_cast<int>(i % pieces);
      children[i] = 2 * split.GetPiece(line / 2, against ? pieces - 1 - at : at) + against;
    });
  return children;
}

}

#endif
