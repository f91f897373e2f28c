// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DualRefiner.h
 * Base classes of the dual schemes and of their refiners, which write faces of the next level and
 * join their half-edges.
 */
#ifndef SubdivisionObjects_DualRefiner_h
#define SubdivisionObjects_DualRefiner_h

#include "Core/Surfaces/Dual/DualPlaces.h"
#include "Core/Surfaces/Scheme/SkippedLevel.h"

#include <algorithm>

namespace subdivision
{

template <typename Id>
class DualRefiner
{
public:
  explicit DualRefiner(const SurfaceLevel<Id>& level)
    : Level(level)
    , Mesh(level.Mesh)
    , Places(*level.Dual)
    , FirstVertexFace(level.Mesh.NumberOfFaces + level.Dual->GetNumberOfQuads())
    , FirstVertexCorner(level.Mesh.GetNumberOfCorners() + 4 * level.Dual->GetNumberOfQuads())
  {
  }

  /// Makes the next level. writeFaces(ids) writes the vertices of its faces and joins their
  /// half-edges.
  template <typename WriteFaces>
  SurfaceLevel<Id> MakeNext(Depth depth, const WriteFaces& writeFaces)
  {
    this->Whole = depth != Depth::ForCounts;
    this->Next.Step = this->Level.Step + 1;
    RefineLines(this->Level, this->Next);
    PolygonMesh<Id>& out = this->Next.Mesh;
    out.NumberOfVertices = this->Places.FirstLone + this->Places.GetNumberOfLoneRows();
    out.NumberOfFaces = this->FirstVertexFace + this->Places.GetNumberOfFaces();
    const vtkIdType size = this->FirstVertexCorner + this->Places.GetNumberOfCorners();
    // Quads at the end of a level that has its counts only have no offsets.
    const bool areQuads = !this->Whole && this->AreVertexFacesQuads();
    const vtkIdType faces = areQuads ? this->Mesh.NumberOfFaces : out.NumberOfFaces;
    out.FaceOffsets = Buffer<Id>(faces + 1);
    out.FaceOffsets[faces] = static_cast<Id>(areQuads ? this->Mesh.GetNumberOfCorners() : size);
    areQuads ? this->SetOffsetsInside() : this->SetOffsets();
    if (this->Whole)
    {
      out.Twins = Buffer<Id>(size);
      out.CornerFaces = Buffer<Id>(size);
      ForEach(out.NumberOfFaces,
        [&out](vtkIdType f)
        {
          std::fill(out.CornerFaces.begin() + out.FaceOffsets[f],
            out.CornerFaces.begin() + out.FaceOffsets[f + 1], static_cast<Id>(f));
        });
      out.VertexCorners = Buffer<Id>(out.NumberOfVertices);
      std::fill(out.VertexCorners.begin() + this->Places.FirstLone, out.VertexCorners.end(),
        static_cast<Id>(-1));
      out.Vertices = Buffer<Id>(size);
      writeFaces(out.Vertices.data());
    }
    return std::move(this->Next);
  }

protected:
  struct Fan
  {
    Id Vertex;
    Id Corner;
    const std::vector<FanStep<Id>>& Steps; ///< of FindFanForward
    bool IsCycle;
  };
  /// Makes the vertex faces. setFan(fan, at) writes the face of a fan, from corner `at` of the next
  /// level on, and returns the number of its corners, or 0 if there is no face.
  template <typename SetFan>
  void SetVertexFaces(const SetFan& setFan)
  {
    const auto set = [&](Id vertex, const auto& visitFans)
    {
      vtkIdType at = this->FirstVertexCorner + this->Places.Corners[vertex];
      visitFans([&](Id corner, const std::vector<FanStep<Id>>& steps, bool cycle)
        { at += setFan(Fan{ vertex, corner, steps, cycle }, static_cast<Id>(at)); });
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

  const SurfaceLevel<Id>& Level;
  const PolygonMesh<Id>& Mesh;
  const DualPlaces<Id>& Places;
  const vtkIdType FirstVertexFace;
  const vtkIdType FirstVertexCorner;

private:
  /// Whether there is one vertex face at each vertex, and all have four corners.
  bool AreVertexFacesQuads() const
  {
    return AreAll(this->Mesh.NumberOfVertices + 1, [this](vtkIdType v)
      { return this->Places.Faces[v] == v && this->Places.Corners[v] == 4 * v; });
  }

  /// Faces inside old faces are as large as these.
  void SetOffsetsInside()
  {
    Id* const offsets = this->Next.Mesh.FaceOffsets.data();
    ForEach(this->Mesh.NumberOfFaces,
      [&](vtkIdType f) { offsets[f] = this->Mesh.GetFirst(static_cast<Id>(f)); });
  }
  /// A walk is needed only at several vertex faces.
  void SetOffsets()
  {
    this->SetOffsetsInside();
    Id* const offsets = this->Next.Mesh.FaceOffsets.data();
    const vtkIdType faces = this->Mesh.NumberOfFaces;
    const vtkIdType corners = this->Mesh.GetNumberOfCorners();
    ForEach(this->FirstVertexFace - faces,
      [&](vtkIdType i) { offsets[faces + i] = static_cast<Id>(corners + 4 * i); });
    ForEach(this->Mesh.NumberOfVertices,
      [&](vtkIdType v)
      {
        Id* to = offsets + this->FirstVertexFace + this->Places.Faces[v];
        const Id count = this->Places.Faces[v + 1] - this->Places.Faces[v];
        Id at = static_cast<Id>(this->FirstVertexCorner) + this->Places.Corners[v];
        if (count == 1)
        {
          *to = at;
        }
        if (count < 2)
        {
          return;
        }
        std::vector<FanStep<Id>> steps;
        VisitFans(this->Mesh, static_cast<Id>(v),
          [&](Id corner)
          {
            const bool cycle = FindFanForward(this->Mesh, corner, steps);
            const vtkIdType size = this->Places.GetFaceSize(steps.size(), cycle);
            if (size >= 3)
            {
              *to++ = at;
              at += static_cast<Id>(size);
            }
          });
      });
  }

  bool Whole = false;
  SurfaceLevel<Id> Next;
};

/// `Refiner`: derived from DualRefiner, with WriteFaces(ids).
template <typename Id, typename Refiner>
class DualScheme : public SurfaceScheme<Id>
{
public:
  bool NeedsTriangles() const override { return false; }
  bool IsDual() const override { return true; }
  bool HalvesEdges() const override { return false; }
  vtkIdType GetNumberOfRows(const SurfaceLevel<Id>& level) const override
  {
    return level.Dual->FirstLone + level.Dual->GetNumberOfLoneRows();
  }
  SurfaceLevel<Id> Refine(const SurfaceLevel<Id>& level, Depth depth) const override
  {
    Refiner refiner(level);
    return refiner.MakeNext(depth, [&refiner](Id* ids) { refiner.WriteFaces(ids); });
  }
  void WriteFaces(const SurfaceLevel<Id>& level, IdsOut ids) const override
  {
    std::visit([&level](auto* to) { Refiner(level).WriteFaces(to); }, ids);
  }
  SurfaceTags<Id> RefineTags(const SurfaceLevel<Id>&, const SurfaceTags<Id>&) const override
  {
    return {};
  }
  vtkIdType GetOrientingFace(const SurfaceLevel<Id>& level, vtkIdType child) const override
  {
    const DualPlaces<Id>& places = *level.Dual;
    const vtkIdType side = child - level.Mesh.NumberOfFaces;
    return side < 0 ? child
      : side < places.GetNumberOfQuads()
      ? level.Mesh.GetFace(FindByCount(places.Sides, side))
      : FindOrientingFace(level, side - places.GetNumberOfQuads());
  }
  int GetCarrierPeriod() const override { return 0; }
  void CarryFaces(const SurfaceLevel<Id>& level, const Buffer<Carrier<Id>>& faces, bool,
    Buffer<Carrier<Id>>& children) const override
  {
    CarryDualFaces(level, faces, children);
  }
};

}

#endif
