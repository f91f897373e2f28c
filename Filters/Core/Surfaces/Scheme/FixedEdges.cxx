// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/Scheme/FixedEdges.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Core/Surfaces/Scheme/SurfaceRings.h"

namespace subdivision
{

template <typename Id>
void FixEdges(SurfaceLevel<Id>& level)
{
  const PolygonMesh<Id>& mesh = level.Mesh;
  SurfaceTags<Id>& tags = level.Tags;
  ForEach(mesh.GetNumberOfEdges(),
    [&](vtkIdType e)
    {
      const Id corner = mesh.EdgeCorners[e];
      if (corner < 0 || mesh.Twins[corner] < 0)
      {
        tags.Edges[e] = EdgeTag::Sharp;
      }
    });
  for (const Id line : InTurn(level.Lines))
  {
    tags.Edges[line / 2] = EdgeTag::Sharp;
  }
  const bool hasSharp = HasSharpEdges(tags);
  ForRanges(mesh.NumberOfVertices,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<Id> edges;
      for (vtkIdType v = begin; v < end; ++v)
      {
        VertexTag& tag = tags.Vertices[v];
        if (tag != VertexTag::Corner)
        {
          if (hasSharp)
          {
            CollectSharpEdges(mesh, tags, static_cast<Id>(v), edges);
          }
          const bool isSmooth = edges.empty() && !mesh.FindJoint(static_cast<Id>(v));
          tag = isSmooth        ? VertexTag::Smooth
            : edges.size() == 2 ? VertexTag::Curve
                                : VertexTag::Corner;
        }
      }
    });
}

SUBDIVISION_COMPILE_FUNCTION(FixEdges);

}
