// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceSides.h
 * Which side of a surface is up: faces that are turned over against the rest of their part.
 */
#ifndef SubdivisionObjects_SurfaceSides_h
#define SubdivisionObjects_SurfaceSides_h

#include "Core/Surfaces/Scheme/SurfaceRings.h"

#include <atomic>

namespace subdivision
{

/**
 * 1 for each face that is turned over against the first face of its part, which is all that can be
 * reached over edges of two faces; parts that cannot be oriented stay as they are. Empty where no
 * two faces contradict each other. Children keep the order and the orientation of their parents, so
 * that it is the same on all levels.
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

/// The face whose orientation the tangents of a vertex have: that of its first corner or, on a
/// curve, the first of the sector in which this lies; -1: it has no face.
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
