// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DualRefiner.h
 * Base class of the refiners of dual schemes: writes faces of the next level and joins their
 * half-edges.
 */
#ifndef SubdivisionObjects_DualRefiner_h
#define SubdivisionObjects_DualRefiner_h

#include "Core/Surfaces/Dual/DualPlaces.h"

#include <algorithm>

namespace subdivision
{

template <typename Id>
class DualRefiner
{
protected:
  DualRefiner(const SurfaceLevel<Id>& level, Depth depth)
    : Level(level)
    , Mesh(level.Mesh)
    , Places(*level.Dual)
    , Whole(!IsLast(depth))
  {
  }
  ~DualRefiner() = default;

  /// Prepares the next level. It has `vertices` vertices besides the lone ones, and `faces` faces
  /// with `corners` corners besides the vertex faces, which come last.
  void Start(vtkIdType vertices, vtkIdType faces, vtkIdType corners)
  {
    this->FirstVertexFace = faces;
    this->FirstVertexCorner = corners;
    this->Next.Step = this->Level.Step + 1;
    RefineLines(this->Level, vertices, this->Next);
    PolygonMesh<Id>& out = this->Next.Mesh;
    out.NumberOfVertices = vertices + this->Places.GetNumberOfLoneRows();
    out.NumberOfFaces = faces + this->Places.GetNumberOfFaces();
    const vtkIdType size = corners + this->Places.GetNumberOfCorners();
    out.Vertices = Buffer<Id>(size);
    out.FaceOffsets = Buffer<Id>(out.NumberOfFaces + 1);
    out.FaceOffsets[out.NumberOfFaces] = static_cast<Id>(size);
    if (this->Whole)
    {
      out.Twins = Buffer<Id>(size);
      out.CornerFaces = Buffer<Id>(size);
      out.VertexCorners = Buffer<Id>(out.NumberOfVertices);
      this->Next.FanSizes = Buffer<signed char>(out.NumberOfVertices, 0);
      std::fill(out.VertexCorners.begin() + vertices, out.VertexCorners.end(), static_cast<Id>(-1));
    }
  }

  void SetFace(vtkIdType face, vtkIdType first, vtkIdType size)
  {
    PolygonMesh<Id>& out = this->Next.Mesh;
    out.FaceOffsets[face] = static_cast<Id>(first);
    if (this->Whole)
    {
      std::fill(out.CornerFaces.begin() + first, out.CornerFaces.begin() + first + size,
        static_cast<Id>(face));
    }
  }
  /// Sets the sizes of the faces inside old faces.
  void SetInnerFaces()
  {
    ForEach(this->Mesh.NumberOfFaces,
      [this](vtkIdType f)
      {
        const Id face = static_cast<Id>(f);
        this->SetFace(face, this->Mesh.GetFirst(face), this->Mesh.GetSize(face));
      });
  }
  struct Fan
  {
    Id Vertex;
    Id Corner;
    const std::vector<FanStep<Id>>& Steps; ///< of FindFanForward
    bool IsCycle;
  };
  /// Makes the vertex faces. setFan(fan, at) writes the face of a fan, from corner `at` of the next
  /// level on, and returns the number of its corners, or 0 if there is
  /// no face.
  template <typename SetFan>
  void SetVertexFaces(const SetFan& setFan)
  {
    const auto set = [&](Id vertex, const auto& visitFans)
    {
      vtkIdType face = this->FirstVertexFace + this->Places.Faces[vertex];
      vtkIdType at = this->FirstVertexCorner + this->Places.Corners[vertex];
      visitFans(
        [&](Id corner, const std::vector<FanStep<Id>>& steps, bool cycle)
        {
          const vtkIdType size = setFan(Fan{ vertex, corner, steps, cycle }, static_cast<Id>(at));
          if (size > 0)
          {
            this->SetFace(face++, at, size);
            at += size;
          }
        });
    };
    ForRanges(this->Mesh.NumberOfVertices,
      [&](vtkIdType begin, vtkIdType end) { ForFansForward(this->Mesh, begin, end, set); });
  }

  void Join(Id a, Id b)
  {
    if (this->Whole)
    {
      this->Next.Mesh.Twins[a] = b;
      this->Next.Mesh.Twins[b] = a;
    }
  }
  void Open(Id corner)
  {
    if (this->Whole)
    {
      this->Next.Mesh.Twins[corner] = -1;
    }
  }
  void SetVertexCorner(Id vertex, Id corner)
  {
    if (this->Whole)
    {
      this->Next.Mesh.VertexCorners[vertex] = corner;
    }
  }

  /// SurfaceLevel::FanSizes of the next level.
  void SetFanSize(Id vertex, int size)
  {
    if (this->Whole)
    {
      this->Next.FanSizes[vertex] = static_cast<signed char>(size);
    }
  }

  const SurfaceLevel<Id>& Level;
  const PolygonMesh<Id>& Mesh;
  const DualPlaces<Id>& Places;
  const bool Whole;
  vtkIdType FirstVertexFace = 0;
  vtkIdType FirstVertexCorner = 0;
  SurfaceLevel<Id> Next;
};

}

#endif
