// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceSides.h
 * Finds the upper side of a surface: which faces have the opposite orientation to the rest of their
 * part.
 */
#ifndef SubdivisionObjects_SurfaceSides_h
#define SubdivisionObjects_SurfaceSides_h

#include "Core/Operators/FaceSides.h"
#include "Core/Surfaces/Scheme/SurfaceRings.h"

namespace subdivision
{

/// The links between the faces of a mesh, for FaceSides.h: edges of two faces. `isSure(vertex)`: an
/// edge without such an end is no link.
template <typename Id, typename IsSure>
auto LinkFaces(const PolygonMesh<Id>& mesh, const IsSure& isSure)
{
  return [&mesh, isSure](vtkIdType face, const auto& visit)
  {
    const Id first = mesh.GetFirst(static_cast<Id>(face));
    const Id end = first + static_cast<Id>(mesh.GetSize(static_cast<Id>(face)));
    for (Id corner = first; corner < end; ++corner)
    {
      const Id twin = mesh.Twins[corner];
      if (twin >= 0 && (isSure(mesh.Vertices[corner]) || isSure(mesh.Vertices[mesh.Next(corner)])))
      {
        visit(vtkIdType(mesh.GetFace(twin)), mesh.Vertices[twin] == mesh.Vertices[corner]);
      }
    }
  };
}

/**
 * 1 for each face that is oriented against the first face of its part, else 0. A part is connected
 * over edges of two faces; in a part that is not orientable no face counts as turned. The result is
 * empty if no two neighbouring faces are oriented differently.
 */
template <typename Id>
Buffer<unsigned char> FindTurnedFaces(const PolygonMesh<Id>& mesh)
{
  const auto links = LinkFaces(mesh, [](Id) { return true; });
  return HaveContradictions(mesh.NumberOfFaces, links)
    ? FindSides(mesh.NumberOfFaces, links).ListTurned()
    : Buffer<unsigned char>();
}

/// Whether each part has two sides: a Moebius strip has one.
template <typename Id>
bool IsOrientable(const PolygonMesh<Id>& mesh)
{
  const Buffer<unsigned char> turned = FindTurnedFaces(mesh);
  const auto links = LinkFaces(mesh, [](Id) { return true; });
  const auto areTurned = [&](vtkIdType a, vtkIdType b)
  { return !turned.empty() && turned[a] != turned[b]; };
  return !HaveContradictions(mesh.NumberOfFaces,
    [&](vtkIdType face, const auto& visit)
    {
      links(face, [&](vtkIdType other, bool contradicts)
        { visit(other, contradicts != areTurned(face, other)); });
    });
}

/// The face whose orientation the tangents of a vertex have: the face of FindTangentCorner or, on a
/// curve or at a corner, the first face of the sector of that face; -1 if there is none.
template <typename Id>
Id FindFaceOfTangents(const PolygonMesh<Id>& mesh, const SurfaceTags<Id>& tags, Id vertex)
{
  const Id corner = FindTangentCorner(mesh, tags, vertex);
  if (corner < 0)
  {
    return -1;
  }
  const SectorEnds<Id> ends = tags.Vertices[vertex] == VertexTag::Smooth
    ? SectorEnds<Id>()
    : FindSectorEnds(mesh, tags, corner);
  return mesh.GetFace(ends.Size > 0 ? ends.First.Corner : corner);
}

}

#endif
