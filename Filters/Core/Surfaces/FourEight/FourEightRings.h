// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FourEightRings.h
 * What lies around vertices of later levels of the 4-8 scheme, which are not made, as corners of a
 * level without fixed edges and without irregular vertices.
 */
#ifndef SubdivisionObjects_FourEightRings_h
#define SubdivisionObjects_FourEightRings_h

#include "Core/Surfaces/FourEight/FourEightRegular.h"
#include "Core/Surfaces/FourEight/FourEightTopology.h"
#include "Core/Surfaces/Scheme/CycleRows.h"

#include <algorithm>
#include <array>
#include <vector>

namespace subdivision
{

/// The next level, from this one.
template <typename Id>
class FourEightNextLevel
{
public:
  explicit FourEightNextLevel(const SurfaceLevel<Id>& level)
    : Mesh(level.Mesh)
    , Children(level)
  {
  }

  vtkIdType GetNumberOfVertices() const
  {
    return this->Mesh.NumberOfVertices + this->Mesh.NumberOfFaces;
  }
  vtkIdType GetNumberOfFaces() const { return this->Mesh.GetNumberOfEdges(); }

  /// The vertex in a corner's face.
  Id GetApex(Id corner) const
  {
    return static_cast<Id>(this->Mesh.NumberOfVertices) + this->Mesh.GetFace(corner);
  }
  /// FourEightTopology::GetSpokeOut.
  Id GetSpokeOut(Id corner) const { return this->Children.GetSpokeOut(corner); }
  /// The quad across a corner's edge.
  Id GetQuad(Id corner) const { return this->GetQuad(corner, this->Mesh.Twins[corner]); }
  Id GetQuad(Id corner, Id twin) const { return this->Children.GetChild(std::min(corner, twin)); }
  /// Whether a quad belongs to a corner, as to the first one of its edge.
  bool IsOwner(Id corner) const { return this->Children.HasChild(corner); }
  /// The corner to which a quad belongs.
  Id FindOwner(vtkIdType quad) const { return this->Children.FindCornerOf(static_cast<Id>(quad)); }
  /// The next corner from this one on to which a quad belongs.
  Id FindNextOwner(Id corner) const
  {
    while (!this->Children.HasChild(corner))
    {
      ++corner;
    }
    return corner;
  }

  /// The vertices of the quad of an owner.
  std::array<Id, 4> GetVertices(Id owner) const
  {
    const Id twin = this->Mesh.Twins[owner];
    return { this->Mesh.Vertices[owner], this->GetApex(twin), this->Mesh.Vertices[twin],
      this->GetApex(owner) };
  }
  /// The quads across the four sides of the quad of an owner.
  std::array<Id, 4> GetNeighbours(Id owner) const
  {
    const Id twin = this->Mesh.Twins[owner];
    return { this->GetQuad(this->Mesh.Next(twin)), this->GetQuad(this->Mesh.Previous(twin)),
      this->GetQuad(this->Mesh.Next(owner)), this->GetQuad(this->Mesh.Previous(owner)) };
  }

  const PolygonMesh<Id>& Mesh;

private:
  const FourEightTopology<Id> Children;
};

/// Appends the rows of the vertices in faces [begin, end) of a level, on whichever later one.
/// visitAround(first, size, visit) calls visit(vertex) for the vertices around that in the face
/// with this first corner and this number of corners.
template <typename Id, typename VisitAround>
void AppendVerticesInFaces(const FourEightNextLevel<Id>& next, vtkIdType begin, vtkIdType end,
  const VisitAround& visitAround, RowBlock<Id>& rows)
{
  const PolygonMesh<Id>& mesh = next.Mesh;
  const auto getVertex = [&mesh](vtkIdType face)
  { return static_cast<Id>(mesh.NumberOfVertices + face); };
  for (vtkIdType f = begin; f < end; ++f)
  {
    f += rows.AddRun(FourEightVertex, end - f,
      [&](vtkIdType i, Id* columns)
      {
        const Id face = static_cast<Id>(f + i);
        if (mesh.GetSize(face) != 4)
        {
          return false;
        }
        *columns++ = getVertex(face);
        visitAround(mesh.GetFirst(face), 4, [&columns](Id vertex) { *columns++ = vertex; });
        return true;
      });
    if (f < end)
    {
      const Id face = static_cast<Id>(f);
      const Id size = mesh.GetSize(face);
      rows.Add(getVertex(face), 0.5);
      visitAround(mesh.GetFirst(face), size,
        [&](Id vertex) { rows.Add(vertex, 0.5 / static_cast<double>(size)); });
      rows.EndRow();
    }
  }
}

/// Calls visit(corner) for the corners of a face around the vertex that a step makes in it.
template <typename Id, typename Visit>
void VisitInTurn(Id first, Id size, const Visit& visit)
{
  visit(first + size - 1);
  for (Id corner = first; corner < first + size - 1; ++corner)
  {
    visit(corner);
  }
}

/// Those of this level's vertices that steps made, each in a face of a level before. Half-edges at
/// such a vertex follow from the corners of that face, which takes less time than a walk.
template <typename Id>
class FourEightMadeVertices
{
public:
  explicit FourEightMadeVertices(const SurfaceLevel<Id>& level)
    : Mesh(level.Mesh)
  {
    for (const SurfaceLevel<Id>* before = level.Before; before; before = before->Before)
    {
      this->Levels.emplace_back(*before);
    }
  }

  /// The first of them, after which all were made.
  vtkIdType GetFirst() const
  {
    return this->Levels.empty() ? this->Mesh.NumberOfVertices
                                : this->Levels.back().Mesh.NumberOfVertices;
  }

  /// Appends the rows of vertices [begin, end), which count from the first one, on whichever later
  /// level. `ring(corner)`: a vertex around that of a corner of this level.
  template <typename Ring>
  void Append(vtkIdType begin, vtkIdType end, const Ring& ring, RowBlock<Id>& rows) const
  {
    for (std::size_t i = this->Levels.size(); i-- > 0;)
    {
      const auto visitAround = [&, i](Id first, Id size, const auto& visit)
      { VisitInTurn(first, size, [&](Id corner) { visit(ring(this->FindCornerAt(i, corner))); }); };
      const vtkIdType faces = this->Levels[i].Mesh.NumberOfFaces;
      AppendVerticesInFaces(
        this->Levels[i], std::max<vtkIdType>(begin, 0), std::min(end, faces), visitAround, rows);
      begin -= faces;
      end -= faces;
    }
  }

private:
  /// The corner of this level, at the vertex in a face of Levels[i], in the face that has come to
  /// lie at a corner of that face.
  Id FindCornerAt(std::size_t i, Id corner) const
  {
    corner = this->Levels[i].GetSpokeOut(corner);
    while (i-- > 0)
    {
      corner = this->GetAfter(i).Next(this->Levels[i].GetSpokeOut(corner));
    }
    return corner;
  }
  /// The level after Levels[i].
  const PolygonMesh<Id>& GetAfter(std::size_t i) const
  {
    return i == 0 ? this->Mesh : this->Levels[i - 1].Mesh;
  }

  const PolygonMesh<Id>& Mesh;
  std::vector<FourEightNextLevel<Id>> Levels; ///< the last one first
};

/// Appends the rows of vertices [begin, end) of a level, on whichever later one, by walks. The walk
/// around a vertex there begins beyond the edge of its corner. `ring`: as in FourEightMadeVertices.
template <typename Id, typename Ring>
void AppendWalkedVertices(const FourEightNextLevel<Id>& next, vtkIdType begin, vtkIdType end,
  const Ring& ring, RowBlock<Id>& rows)
{
  using Steps = typename CycleWalks<Id>::Steps;
  AppendCycleRows(
    next.Mesh, FourEightVertex, begin, end, [](Id) { return true; },
    [&](Id vertex, const Steps& steps, Id* columns)
    {
      if (steps.size() != 4)
      {
        return false;
      }
      columns[0] = vertex;
      columns[1] = ring(steps[3].Corner);
      for (int k = 0; k < 3; ++k)
      {
        columns[2 + k] = ring(steps[k].Corner);
      }
      return true;
    },
    [&](Id vertex, const Steps& steps)
    {
      const double weight = 0.5 / static_cast<double>(steps.size());
      rows.Add(vertex, 0.5);
      rows.Add(ring(steps.back().Corner), weight);
      for (std::size_t k = 0; k + 1 < steps.size(); ++k)
      {
        rows.Add(ring(steps[k].Corner), weight);
      }
    },
    rows);
}

}

#endif
