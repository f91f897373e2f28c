// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FourEightStar.h
 * The faces that limits of the 4-8 scheme read: at a vertex, and beyond the sides of these.
 */
#ifndef SubdivisionObjects_FourEightStar_h
#define SubdivisionObjects_FourEightStar_h

#include "Core/Surfaces/Scheme/SurfaceRings.h"

#include <array>
#include <vector>

namespace subdivision
{

/// The star of a vertex is *regular* if steps make the same star again: its faces and the faces
/// beyond are quads, and all other vertices of its faces are smooth and have four faces. The two
/// ends of a sector are on the curve, with two faces in the sector.
template <typename Id>
class FourEightStar
{
public:
  /// One face of the vertex: [0] at the edge by which a walk enters the face, [1] at the next one.
  struct Wedge
  {
    Id Opposite;
    std::array<Id, 2> Ends;    ///< of the edges
    std::array<Id, 2> Ahead;   ///< straight ahead of these
    std::array<Id, 2> Knights; ///< between Ahead and Opposite
  };

  /// The star around a smooth vertex, by a walk that begins at a corner of it. False: not regular.
  /// With `modified`, the step must not make other centres beside curves in the faces beyond.
  bool FindAround(const SurfaceLevel<Id>& level, Id corner, bool modified)
  {
    this->Wedges.clear();
    bool isRegular = true;
    const auto isPlain = [&](const std::array<Id, 2>& vertices)
    { return !MovesCentres(level, vertices[0]) && !MovesCentres(level, vertices[1]); };
    VisitCycle(level.Mesh, corner,
      [&](const FanStep<Id>& step)
      {
        isRegular = isRegular && this->Add(level, step) &&
          IsRegularInside(level, this->Wedges.back().Ends[0]) &&
          (!modified ||
            (isPlain(this->Wedges.back().Ahead) && isPlain(this->Wedges.back().Knights)));
      });
    return isRegular;
  }

  /// The star of a sector at a vertex on a curve. False: not regular, as on all odd levels.
  bool FindBeside(const SurfaceLevel<Id>& level, const SectorEnds<Id>& ends)
  {
    this->Wedges.clear();
    bool isRegular = level.Step % 2 == 0;
    FanStep<Id> step = ends.First;
    for (int j = 0; j < ends.Size && isRegular; ++j)
    {
      isRegular =
        this->Add(level, step) && (j == 0 || IsRegularInside(level, this->Wedges.back().Ends[0]));
      step.Advance(level.Mesh);
    }
    return isRegular && this->EndsOnCurve(level, ends.First, 0) &&
      this->EndsOnCurve(level, ends.Last, 1);
  }

  /// Whether the centres that the next step makes in the faces of a vertex may be no means.
  static bool MovesCentres(const SurfaceLevel<Id>& level, Id vertex)
  {
    const VertexTag tag = level.Tags.Vertices[vertex];
    return tag == VertexTag::Corner || (tag != VertexTag::Smooth && level.Step % 2 == 1);
  }

  std::vector<Wedge> Wedges; ///< in the order of the walk

private:
  /// The side of a face that begins (0) or ends (1) opposite to the vertex, in the order of a walk.
  static Id GetSide(const PolygonMesh<Id>& mesh, const FanStep<Id>& step, int end)
  {
    const Id next = mesh.Next(step.Corner);
    return step.Forward == (end == 0) ? next : mesh.Next(next);
  }
  /// Whether the side beyond which a face lies begins, in that face, at the end of the edge.
  static bool BeginsAtEnd(const PolygonMesh<Id>& mesh, const FanStep<Id>& step, int end)
  {
    const Id side = GetSide(mesh, step, end);
    const bool isSame = mesh.Vertices[mesh.Twins[side]] == mesh.Vertices[side];
    return (side == mesh.Next(step.Corner)) == isSame;
  }

  static bool IsRegularInside(const SurfaceLevel<Id>& level, Id vertex)
  {
    if (level.Tags.Vertices[vertex] != VertexTag::Smooth)
    {
      return false;
    }
    FanStep<Id> step{ level.Mesh.VertexCorners[vertex], true };
    const Id first = step.Corner;
    for (int faces = 1; faces <= 4; ++faces)
    {
      if (!step.Advance(level.Mesh) || (step.Corner == first && faces < 4))
      {
        return false;
      }
    }
    return step.Corner == first;
  }

  bool Add(const SurfaceLevel<Id>& level, const FanStep<Id>& step)
  {
    const PolygonMesh<Id>& mesh = level.Mesh;
    if (mesh.GetSize(mesh.GetFace(step.Corner)) != 4)
    {
      return false;
    }
    Wedge wedge;
    wedge.Opposite = mesh.Vertices[mesh.Next(mesh.Next(step.Corner))];
    if (!IsRegularInside(level, wedge.Opposite))
    {
      return false;
    }
    for (int end = 0; end < 2; ++end)
    {
      const Id twin = mesh.Twins[GetSide(mesh, step, end)];
      if (mesh.GetSize(mesh.GetFace(twin)) != 4)
      {
        return false;
      }
      const Id third = mesh.Vertices[mesh.Next(mesh.Next(twin))];
      const Id last = mesh.Vertices[mesh.Previous(twin)];
      const bool beginsAtEnd = BeginsAtEnd(mesh, step, end);
      wedge.Ends[end] = mesh.Vertices[step.Forward == (end == 0) ? mesh.Next(step.Corner)
                                                                 : mesh.Previous(step.Corner)];
      wedge.Ahead[end] = beginsAtEnd ? last : third;
      wedge.Knights[end] = beginsAtEnd ? third : last;
    }
    this->Wedges.push_back(wedge);
    return true;
  }

  /// Whether the edge of the first or last face is followed on the curve by a side of the face
  /// beyond.
  bool EndsOnCurve(const SurfaceLevel<Id>& level, const FanStep<Id>& step, int end) const
  {
    const PolygonMesh<Id>& mesh = level.Mesh;
    const Wedge& wedge = end == 0 ? this->Wedges.front() : this->Wedges.back();
    const Id twin = mesh.Twins[GetSide(mesh, step, end)];
    const Id along = BeginsAtEnd(mesh, step, end) ? mesh.Previous(twin) : mesh.Next(twin);
    return level.Tags.Vertices[wedge.Ends[end]] == VertexTag::Curve &&
      IsSharp(level.Tags.Edges[mesh.Edges[along]]);
  }
};

}

#endif
