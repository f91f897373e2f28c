// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RingFinder.h
 * Regular vertices of a level that is not made, and their rings, from the level before.
 */
#ifndef SubdivisionObjects_RingFinder_h
#define SubdivisionObjects_RingFinder_h

#include "Core/Memory/Loops.h"
#include "Core/Solids/Limits/RegularRings.h"
#include "Core/Solids/Limits/Restriction.h"

#include <algorithm>

namespace subdivision
{

/// Finds rings from the level before, of which all edges and triangles are split.
template <typename Level>
class RingFinder
{
public:
  using Id = typename Level::IdType;

  RingFinder(const Level& level, int steps)
    : Complex(level.Complex)
    , Strata(level.Strata)
    , Shift(2 * steps)
    , AreSmooth(std::all_of(level.Strata.Faces.begin(), level.Strata.Faces.end(),
        [](const Stratum& face) { return face.GetRule() == Rule::Surface; }))
    , IsInSector(level.Strata.Sectors.empty() ? 0 : level.Complex.NumberOfEdges, 0)
  {
    for (const SectorEdge<Id>& sector : level.Strata.Sectors)
    {
      this->IsInSector[sector.Edge] = 1;
    }
  }
  /// Writes the ring of a vertex that the level has, too. Returns its side, or -1.
  Id FindOld(Id vertex, Id* ring) const;
  /// The same for the midpoint of an edge.
  Id FindMidpoint(Id edge, Id* ring) const;

private:
  bool IsSmooth(Id edge) const
  {
    const Row<Id> faces = this->Strata.EdgeRings.GetCarriers(edge);
    return this->Strata.Edges[edge].GetRule() == Rule::Surface && faces.size() == 2 &&
      this->IsSmoothFace(faces.begin()[0]) && this->IsSmoothFace(faces.begin()[1]);
  }
  /// Whether the edges that a step makes inside a face are smooth.
  bool IsSmoothFace(Id face) const
  {
    return face >= 0 && (this->AreSmooth || this->Strata.Faces[face].GetRule() == Rule::Surface);
  }
  /// `face` has the smallest number of all around. Where it is no cell, nobody asks for its side.
  Id GetSide(Id face, bool isAgainst) const
  {
    return face < this->Complex.NumberOfTriangleCells
      ? static_cast<Id>(2 * (face >> this->Shift) + (isAgainst ? 1 : 0))
      : Id(-1);
  }
  Id GetMidpoint(Id edge) const { return this->Complex.NumberOfVertices + edge; }

  const SimplicialComplex<Id>& Complex;
  const subdivision::Strata<Id>& Strata;
  const int Shift;
  const bool AreSmooth;             ///< all faces, so that none is looked up
  Buffer<unsigned char> IsInSector; ///< edges whose rule changes at an end
};

template <typename Level>
typename Level::IdType RingFinder<Level>::FindOld(Id vertex, Id* ring) const
{
  constexpr int size = RegularRings<Id>::Size;
  const Row<Id> edges = this->Strata.VertexRings.GetCarriers(vertex);
  if (this->Strata.Vertices[vertex].GetRule() != Rule::Surface || edges.size() != size)
  {
    return -1;
  }
  const Id first = *edges.begin();
  Id edge = first;
  Id face = -1;
  Id least = -1;
  bool isAgainst = false;
  for (int j = 0; j < size; ++j)
  {
    if (edge < 0 || !this->IsSmooth(edge) || (j > 0 && edge == first))
    {
      return -1;
    }
    const Id* faces = this->Strata.EdgeRings.GetCarriers(edge).begin();
    if (j > 0 && faces[0] != face && faces[1] != face)
    {
      return -1;
    }
    face = faces[j > 0 && faces[0] == face ? 1 : 0];
    ring[j] = this->GetMidpoint(edge);
    // The edges at a corner are that with its number, which leaves it, and the one before.
    const int corner = this->Complex.VertexInFace(face, vertex);
    const Id* around = this->Complex.FaceEdges.data() + 3 * vtkIdType(face);
    const bool leaves = around[corner] == edge;
    if (j == 0 || face < least)
    {
      least = face;
      isAgainst = !leaves;
    }
    edge = around[leaves ? (corner + 2) % 3 : corner];
  }
  return edge == first ? this->GetSide(least, isAgainst) : Id(-1);
}

template <typename Level>
typename Level::IdType RingFinder<Level>::FindMidpoint(Id edge, Id* ring) const
{
  if (!this->IsSmooth(edge) || (!this->IsInSector.empty() && this->IsInSector[edge] != 0))
  {
    return -1;
  }
  const Id* faces = this->Strata.EdgeRings.GetCarriers(edge).begin();
  const Id* ends = this->Complex.EdgeVertices.data() + 2 * vtkIdType(edge);
  bool runsAlong[2];
  for (int side = 0; side < 2; ++side)
  {
    const Id* around = this->Complex.FaceEdges.data() + 3 * vtkIdType(faces[side]);
    const int place = this->Complex.EdgeInFace(faces[side], edge);
    const Id begin = this->Complex.FaceVertices[3 * vtkIdType(faces[side]) + place];
    runsAlong[side] = begin == ends[0];
    const Id atBegin = this->GetMidpoint(around[(place + 2) % 3]);
    const Id atEnd = this->GetMidpoint(around[(place + 1) % 3]);
    Id* half = ring + 3 * side; // from the first end to the second one, and back
    const bool isFromBegin = begin == ends[side];
    half[0] = ends[side];
    half[1] = isFromBegin ? atBegin : atEnd;
    half[2] = isFromBegin ? atEnd : atBegin;
  }
  return faces[0] == faces[1] ? Id(-1)
    : faces[0] < faces[1]     ? this->GetSide(faces[0], runsAlong[0])
                              : this->GetSide(faces[1], !runsAlong[1]);
}

/// The next level around flagged vertices of a level: all that comes from these vertices, and from
/// what lies at them, is whole.
template <typename Level>
class RefinedPart
{
public:
  using Id = typename Level::IdType;

  RefinedPart(const Level& level, const Buffer<unsigned char>& at)
    : Old(level.Complex)
    , Part(level, at)
    , Next(Refine(Part.Restrict(), Depth::ForRefinement))
  {
  }
  const Restriction<Level>& GetPart() const { return this->Part; }
  const Level& GetNext() const { return this->Next; }
  /// The number in the whole next level of a vertex of the part, and the inverse.
  Id GetWhole(vtkIdType vertex) const
  {
    const vtkIdType edge = vertex - this->Part.GetOldVertices().size();
    const vtkIdType centre = edge - this->Part.GetOldEdges().size();
    return edge < 0 ? this->Part.GetOldVertices()[vertex]
      : centre < 0
      ? this->Old.NumberOfVertices + this->Part.GetOldEdges()[edge]
      : this->Old.NumberOfVertices + this->Old.NumberOfEdges + this->Part.GetOldOcts()[centre];
  }
  Id GetOwn(vtkIdType vertex) const
  {
    const vtkIdType edge = vertex - this->Old.NumberOfVertices;
    const vtkIdType centre = edge - this->Old.NumberOfEdges;
    const auto vertices = static_cast<Id>(this->Part.GetOldVertices().size());
    const auto& centres = this->Part.GetOldOcts();
    return edge < 0 ? this->Part.GetNewVertices()[vertex]
      : centre < 0  ? vertices + this->Part.GetNewEdges()[edge]
                    : vertices +
        static_cast<Id>(this->Part.GetOldEdges().size() +
          (std::lower_bound(centres.begin(), centres.end(), static_cast<Id>(centre)) -
            centres.begin()));
  }

private:
  const SimplicialComplex<Id>& Old;
  const Restriction<Level> Part;
  const Level Next;
};

}

#endif
