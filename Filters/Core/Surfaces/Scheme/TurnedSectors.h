// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TurnedSectors.h
 * Sectors in schemes whose steps turn the mesh, sqrt(3) and 4-8: from level to level, and the angle
 * and the flatness for the centres that even steps make beside curves (Mathematics 11, 12).
 *
 * An odd step puts a centre into each of the k faces of a sector and leaves its curves alone, so
 * that it has k + 1 faces. The even step after it makes the points between two of these centres,
 * and shortens the curves.
 */
#ifndef SubdivisionObjects_TurnedSectors_h
#define SubdivisionObjects_TurnedSectors_h

#include "Core/Surfaces/Scheme/SectorRows.h"

namespace subdivision
{

/// The edge at which a sector begins or ends, as a corner of its first or last face.
template <typename Id>
Id FindEndOfSector(const PolygonMesh<Id>& mesh, const SurfaceTags<Id>& tags, Id corner, bool isLast)
{
  const Id before = mesh.Previous(corner);
  const bool isOut = tags.Edges[mesh.Edges[corner]] != EdgeTag::Smooth;
  const bool isIn = tags.Edges[mesh.Edges[before]] != EdgeTag::Smooth;
  return isIn && (isLast || !isOut) ? before : corner;
}

/// Moves the corners of sectors to the next level. move(fixed, vertex) is the corner of a vertex in
/// the child at this end of a fixed edge, which is given as a corner of this level.
template <typename Id, typename Move>
void MoveSectors(const PolygonMesh<Id>& mesh, const SurfaceTags<Id>& tags, const Move& move,
  std::vector<Sector<Id>>& sectors)
{
  for (Sector<Id>& sector : sectors)
  {
    const bool isLone = sector.First == sector.Last;
    sector.First =
      sector.First < 0 ? -1 : move(FindEndOfSector(mesh, tags, sector.First, false), sector.Vertex);
    sector.Last =
      sector.Last < 0 ? -1 : move(FindEndOfSector(mesh, tags, sector.Last, isLone), sector.Vertex);
  }
}

/// Whether the faces of a sector at a corner are so wide that odd steps flatten, too: they are two,
/// at a concave corner.
inline bool IsWide(double angleOfFace)
{
  return angleOfFace > 2. / 3. * Pi * (1. + 1e-9);
}

/// The row of the centre that a step makes in a face of `Size` corners: the mean of the corners or,
/// beside curves, the mean of the masks of its corners there.
template <typename Id, int Size>
class CentreAtCurves
{
public:
  /// `regular`: how many faces there are in a sector on a curve where the plain rule is right.
  /// far(angle) is the weight of each other corner in the mask of a corner, by the angle of one
  /// face of its sector before the odd step. `factor`: of lengths in two steps.
  template <typename Far>
  CentreAtCurves(const SurfaceLevel<Id>& level, const SurfaceTags<Id>& tags, Id face, int regular,
    const Far& far, double factor)
    : Mesh(level.Mesh)
    , Tags(tags)
    , First(level.Mesh.GetFirst(face))
    , IsEven(level.Step % 2 == 1)
    , Factor(factor)
  {
    int corners = 0;
    double sums[Size] = {};
    for (int i = 0; i < Size; ++i)
    {
      if (tags.Vertices[this->Mesh.Vertices[this->First + i]] == VertexTag::Smooth)
      {
        continue;
      }
      const double angle = this->FindAngle(static_cast<Id>(this->First + i), regular);
      const double weight = angle > 0. ? far(angle) : 1. / Size;
      for (int j = 0; j < Size; ++j)
      {
        sums[j] += i == j ? 1. - (Size - 1) * weight : weight;
      }
      ++corners;
      this->Plain = this->Plain && !(angle > 0.);
    }
    for (int j = 0; j < Size; ++j)
    {
      this->Weights[j] = this->Plain ? 1. / Size : sums[j] / corners;
    }
  }

  bool IsPlain() const { return this->Plain && this->Flat.Points.empty(); }
  void Append(RowBlock<Id>& rows) const
  {
    for (int i = 0; i < Size; ++i)
    {
      rows.Add(this->Mesh.Vertices[this->First + i], this->Flat.GetKept() * this->Weights[i]);
    }
    this->Flat.Append(rows);
  }

private:
  /// The angle of one face of the sector of a corner of the face; 0: the plain rule applies. Adds
  /// the point towards which the centre moves.
  double FindAngle(Id corner, int regular)
  {
    const Id vertex = this->Mesh.Vertices[corner];
    const bool isCurve = this->Tags.Vertices[vertex] == VertexTag::Curve;
    if (isCurve && !this->IsEven)
    {
      return 0.;
    }
    const SectorEnds<Id> ends = FindSectorEnds(this->Mesh, this->Tags, corner);
    const int faces = ends.Size - (this->IsEven ? 1 : 0);
    if (faces < 2 || (isCurve && faces == regular))
    {
      return 0.;
    }
    if (isCurve)
    {
      return Pi / faces;
    }
    const Sector<Id>* sector = FindSector(this->Tags, vertex, ends);
    const Id last =
      sector && sector->First == ends.First.Corner ? ends.Last.Corner : ends.First.Corner;
    if (!sector || sector->Last != last)
    {
      return 0.; // a line goes through it
    }
    const double angle = sector->Angle / faces;
    if (sector->Flatness > 0. && (this->IsEven || IsWide(angle)))
    {
      this->AddFlatPoint(corner, *sector, ends, angle);
    }
    return this->IsEven ? angle : 0.;
  }

  void AddFlatPoint(
    Id corner, const Sector<Id>& sector, const SectorEnds<Id>& ends, double angleOfFace)
  {
    double turn = this->IsEven ? 0. : angleOfFace / 2.;
    for (FanStep<Id> step = ends.First; step.Corner != corner; step.Advance(this->Mesh))
    {
      turn += angleOfFace;
    }
    // In both steps the end of the curve is the edge's on this level, times the factor.
    const double size = 2. * (this->IsEven ? this->Factor : std::sqrt(this->Factor));
    const FlatWeights half = GetFlatWeights(sector.Angle, std::cos(turn), std::sin(turn));
    FlatPoint<Id> flat;
    flat.Flatness = sector.Flatness;
    flat.Corner = sector.Vertex;
    flat.Weights[0] = size * half.First;
    flat.Weights[1] = size * half.Last;
    flat.Ends[0] =
      this->Mesh.GetOtherEnd(this->Mesh.Edges[ends.First.GetHalfEdgeIn(this->Mesh)], flat.Corner);
    flat.Ends[1] =
      this->Mesh.GetOtherEnd(this->Mesh.Edges[ends.Last.GetHalfEdgeOut(this->Mesh)], flat.Corner);
    this->Flat.Add(flat);
  }

  const PolygonMesh<Id>& Mesh;
  const SurfaceTags<Id>& Tags;
  const Id First; ///< corner
  const bool IsEven;
  const double Factor;
  double Weights[Size];
  bool Plain = true;
  FlatPoints<Id> Flat;
};

}

#endif
