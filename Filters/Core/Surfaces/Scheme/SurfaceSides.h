// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceSides.h
 * Finds the upper side of a surface: which faces have the opposite orientation to the rest of their
 * part.
 */
#ifndef SubdivisionObjects_SurfaceSides_h
#define SubdivisionObjects_SurfaceSides_h

#include "Core/Surfaces/Scheme/SurfaceRings.h"

#include <atomic>

namespace subdivision
{

/**
 * 1 for each face whose orientation is opposite to that of the first face of its part, else 0. A
 * part is all that can be reached over edges of two faces; in a part that is not orientable no face
 * counts as turned. The result is empty if no two neighbouring faces are oriented differently.
 * Children keep the order and the orientation of their parents, so that the sides are the same on
 * all levels.
 */
template <typename Id>
Buffer<unsigned char> FindTurnedFaces(const PolygonMesh<Id>& mesh)
{
  auto contradicts = [&mesh](Id corner)
  {
    const Id twin = mesh.Twins[corner];
    return twin >= 0 && mesh.Vertices[twin] == mesh.Vertices[corner];
  };
  std::atomic<bool> found(false);
  ForEach(mesh.GetNumberOfCorners(),
    [&](vtkIdType c)
    {
      if (contradicts(static_cast<Id>(c)))
      {
        found.store(true, std::memory_order_relaxed);
      }
    });
  if (!found)
  {
    return Buffer<unsigned char>();
  }
  constexpr unsigned char unknown = 2;
  Buffer<unsigned char> turned(mesh.NumberOfFaces, unknown);
  std::vector<Id> part;
  for (vtkIdType start = 0; start < mesh.NumberOfFaces; ++start)
  {
    if (turned[start] != unknown)
    {
      continue;
    }
    turned[start] = 0;
    part.assign(1, static_cast<Id>(start));
    bool isOrientable = true;
    for (std::size_t i = 0; i < part.size(); ++i)
    {
      const Id face = part[i];
      const Id first = mesh.GetFirst(face);
      for (Id corner = first; corner < first + mesh.GetSize(face); ++corner)
      {
        const Id twin = mesh.Twins[corner];
        if (twin < 0)
        {
          continue;
        }
        const Id other = mesh.GetFace(twin);
        const unsigned char side =
          static_cast<unsigned char>(turned[face] ^ (contradicts(corner) ? 1 : 0));
        if (turned[other] == unknown)
        {
          turned[other] = side;
          part.push_back(other);
        }
        isOrientable = isOrientable && turned[other] == side;
      }
    }
    for (const Id face : part)
    {
      turned[face] = isOrientable ? turned[face] : 0;
    }
  }
  return turned;
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
