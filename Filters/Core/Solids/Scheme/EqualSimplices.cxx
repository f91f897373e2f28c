// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Scheme/EqualSimplices.h"

#include "Core/Memory/Ids.h"
#include "Core/Solids/Scheme/SolidParts.h"

namespace subdivision
{

/// The tables give the vertices of a child of an equal cell; its twin is the child of the parent's
/// twin that has the same vertices.
template <typename Id>
void RefineEqualLinesAndTriangles(const SimplicialComplex<Id>& parent, SimplicialComplex<Id>& child)
{
  const SkeletonIds<Id> ids(parent);
  const vtkIdType lines = parent.EqualLines.Twins.size();
  child.EqualLines = { Buffer<Id>(4 * lines), Buffer<Id>(2 * lines) };
  for (vtkIdType i = 0; i < lines; ++i)
  {
    const Id edge = parent.EqualLines.Twins[i];
    const Id* ends = parent.EqualLines.Vertices.data() + 2 * i;
    const Id out[4] = { ends[0], ids.Midpoint(edge), ids.Midpoint(edge), ends[1] };
    std::copy(out, out + 4, child.EqualLines.Vertices.data() + 4 * i);
    child.EqualLines.Twins[2 * i] = ids.Half(edge, ends[0]);
    child.EqualLines.Twins[2 * i + 1] = ids.Half(edge, ends[1]);
  }
  const vtkIdType triangles = parent.EqualTriangles.Twins.size();
  child.EqualTriangles = { Buffer<Id>(12 * triangles), Buffer<Id>(4 * triangles) };
  for (vtkIdType i = 0; i < triangles; ++i)
  {
    const Id face = parent.EqualTriangles.Twins[i];
    Id lattice[6];
    GetEdgesOfEqualTriangle(parent, i, lattice + 3);
    for (int k = 0; k < 3; ++k)
    {
      lattice[k] = parent.EqualTriangles.Vertices[3 * i + k];
      lattice[3 + k] = ids.Midpoint(lattice[3 + k]);
    }
    for (int c = 0; c < 4; ++c)
    {
      child.EqualTriangles.Twins[4 * i + c] =
        ids.Face(face, c == 3 ? 3 : parent.VertexInFace(face, lattice[c]));
      for (int k = 0; k < 3; ++k)
      {
        child.EqualTriangles.Vertices[12 * i + 3 * c + k] = lattice[triangle::Children[c][k]];
      }
    }
  }
}

template <typename Id>
void GetEdgesOfEqualTriangle(const SimplicialComplex<Id>& complex, vtkIdType index, Id edges[3])
{
  const Id twin = complex.EqualTriangles.Twins[index];
  for (int e = 0; e < 3; ++e)
  {
    const Id opposite = complex.EqualTriangles.Vertices[3 * index + triangle::VertexOpposite[e]];
    edges[e] = complex.FaceEdges[3 * vtkIdType(twin) +
      triangle::EdgeOpposite[complex.VertexInFace(twin, opposite)]];
  }
}

SUBDIVISION_COMPILE_FUNCTION(RefineEqualLinesAndTriangles);
SUBDIVISION_COMPILE_FUNCTION(GetEdgesOfEqualTriangle);

}
