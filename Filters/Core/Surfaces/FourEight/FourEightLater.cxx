// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Surfaces/FourEight/FourEightLater.h"

#include "Core/Memory/ForNumbered.h"
#include "Core/Memory/Ids.h"
#include "Core/Surfaces/FourEight/FourEightRings.h"
#include "Core/Surfaces/Scheme/RegularGroups.h"
#include "Core/Surfaces/Scheme/SkippedLevel.h"

#include <array>

namespace subdivision
{
namespace
{

/// What belongs to the four corners of a spoke's face, or to its sides from each of them to the
/// next: the vertex in the face, that in the quad across the edge of the corner before the spoke's,
/// the corner's vertex, and that in the quad across the corner's own edge.
template <typename Id>
using OfSpoke = std::array<Id, 4>;

/// The levels two and more steps later, from this one, which has quads only.
template <typename Id>
class LaterLevels
{
public:
  explicit LaterLevels(const SurfaceLevel<Id>& level)
    : Next(level)
    , Mesh(level.Mesh)
    , Corners(static_cast<Id>(level.Mesh.GetNumberOfCorners()))
    , FirstQuad(static_cast<Id>(this->Next.GetNumberOfVertices()))
    , FirstSpoke(this->FirstQuad + static_cast<Id>(this->Next.GetNumberOfFaces()))
    , FirstSide(this->FirstSpoke + this->Corners)
    , Twins(level.Mesh.Twins.data())
    , Faces(level.Later.data())
    , Spokes(this->Faces + this->Corners)
    , OfApices(this->Spokes + this->Corners)
    , OfVertices(this->OfApices + this->Corners)
    , FirstSides(this->OfVertices + this->Corners)
  {
  }

  /// The number of the face of a corner's spoke.
  Id GetFace(Id corner) const { return this->Faces[corner]; }
  /// The corner of the spoke of a face.
  Id GetSpoke(vtkIdType face) const { return this->Spokes[face] >> 1; }
  /// At which of its corners the face begins.
  std::size_t GetFirst(vtkIdType face) const
  {
    return 2 * static_cast<std::size_t>(this->Spokes[face] & 1);
  }

  static Id GetNext(Id corner) { return (corner & ~Id(3)) | ((corner + 1) & 3); }
  static Id GetPrevious(Id corner) { return (corner & ~Id(3)) | ((corner + 3) & 3); }
  /// The spokes whose faces lie across its sides; side i is side 3 - i of such a face.
  OfSpoke<Id> GetAcross(Id corner) const
  {
    const Id before = GetPrevious(corner);
    return { before, this->Twins[before], GetNext(this->Twins[corner]), GetNext(corner) };
  }
  OfSpoke<Id> GetVertices(Id corner, const OfSpoke<Id>& across) const
  {
    return { static_cast<Id>(this->Mesh.NumberOfVertices) + (corner >> 2),
      this->FirstQuad + this->Next.GetQuad(across[0], across[1]), this->Mesh.Vertices[corner],
      this->GetVertexInQuad(corner) };
  }
  /// The faces across its sides, on the level three steps later. Two of them are stored with the
  /// spoke, the other two with those across.
  OfSpoke<Id> GetSides(Id corner, const OfSpoke<Id>& across) const
  {
    return { this->OfApices[corner], this->OfVertices[across[1]], this->OfVertices[corner],
      this->OfApices[across[3]] };
  }
  /// Of the spokes across: the side after the common one, and the side before it.
  OfSpoke<Id> GetSidesAfter(Id corner, const OfSpoke<Id>& across) const
  {
    return { this->OfApices[across[0]], this->OfApices[GetNext(across[1])],
      this->OfVertices[across[2]], this->OfVertices[this->Twins[corner]] };
  }
  OfSpoke<Id> GetSidesBefore(const OfSpoke<Id>& across) const
  {
    return { this->OfVertices[across[0]], this->OfVertices[this->Twins[GetPrevious(across[1])]],
      this->OfApices[across[2]], this->OfApices[GetNext(across[3])] };
  }
  /// Where the number of one of them is stored.
  vtkIdType GetPlace(Id corner, const OfSpoke<Id>& across, std::size_t side) const
  {
    const vtkIdType part = side == 0 || side == 3 ? 2 : 3;
    return part * this->Corners + (side % 2 == 0 ? corner : across[side]);
  }
  /// The number of the first such face that belongs to a spoke's face.
  Id GetFirstSide(vtkIdType face) const { return this->FirstSides[face]; }
  /// The spoke's face to which such a face belongs.
  vtkIdType FindFaceOfSide(vtkIdType number) const
  {
    return std::upper_bound(
             this->FirstSides, this->FirstSides + this->Corners, static_cast<Id>(number)) -
      this->FirstSides - 1;
  }
  /// The vertex in the quad of a corner's edge, on the next level.
  Id GetVertexInQuad(Id corner) const
  {
    return this->FirstQuad + this->Next.GetQuad(corner, this->Twins[corner]);
  }
  /// The vertex in the face of a corner's spoke.
  Id GetVertexInSpoke(Id corner) const { return this->FirstSpoke + this->GetFace(corner); }

  const FourEightNextLevel<Id> Next;
  const PolygonMesh<Id>& Mesh;
  const Id Corners;
  const Id FirstQuad; ///< the first vertex in a quad, a spoke's face, a face across a side
  const Id FirstSpoke;
  const Id FirstSide;

private:
  const Id* const Twins;
  const Id* const Faces;
  const Id* const Spokes;
  const Id* const OfApices;
  const Id* const OfVertices;
  const Id* const FirstSides;
};

/// Calls act(spoke, isAtVertex) for the sides of the quad of an owner whose face, two steps later,
/// belongs to that quad.
template <typename Id, typename Act>
void ForSpokesOfQuad(const FourEightNextLevel<Id>& next, vtkIdType corner, const Act& act)
{
  const Id owner = static_cast<Id>(corner);
  if (!next.IsOwner(owner))
  {
    return;
  }
  const Id twin = next.Mesh.Twins[owner];
  const Id quad = next.GetQuad(owner);
  const std::array<Id, 4> others = next.GetNeighbours(owner);
  const std::array<Id, 4> spokes = { next.Mesh.Next(twin), twin, next.Mesh.Next(owner), owner };
  for (std::size_t side = 0; side < 4; ++side)
  {
    if (quad < others[side])
    {
      act(spokes[side], side % 2 == 0);
    }
  }
}

/// What lies across the sides of a spoke's face, which belong to it or to the face across. Loops
/// over the sides take no branches, which nobody could predict: what belongs to others is written,
/// too, and then overwritten.
template <typename Id>
class SpokeFace
{
public:
  SpokeFace(const LaterLevels<Id>& later, vtkIdType face)
    : Corner(later.GetSpoke(face))
    , Face(static_cast<Id>(face))
    , Across(later.GetAcross(this->Corner))
    , FacesAcross{ later.GetFace(this->Across[0]), later.GetFace(this->Across[1]),
      later.GetFace(this->Across[2]), later.GetFace(this->Across[3]) }
    , First(later.GetFirst(face))
  {
  }

  /// The sides in the order in which the faces across them are numbered, for i of [0, 4).
  std::size_t GetSide(std::size_t i) const { return (this->First + i) % 4; }
  bool IsOwn(std::size_t side) const { return this->Face < this->FacesAcross[side]; }
  Id CountOwn() const
  {
    return static_cast<Id>(this->IsOwn(0)) + static_cast<Id>(this->IsOwn(1)) +
      static_cast<Id>(this->IsOwn(2)) + static_cast<Id>(this->IsOwn(3));
  }

  const Id Corner;
  const Id Face;
  const OfSpoke<Id> Across;
  const OfSpoke<Id> FacesAcross;
  const std::size_t First;
};

template <typename Id>
void Prepare(SurfaceLevel<Id>& level)
{
  if (level.Mesh.Arity != 4)
  {
    return;
  }
  const vtkIdType corners = level.Mesh.GetNumberOfCorners();
  level.Later = Buffer<Id>(5 * corners);
  Id* const faces = level.Later.data();
  const LaterLevels<Id> later(level);
  ForNumbered<Id>(
    corners, [&](vtkIdType c, Id& number)
    { ForSpokesOfQuad(later.Next, c, [&number](Id, bool) { ++number; }); },
    [&](vtkIdType c, Id& number)
    {
      ForSpokesOfQuad(later.Next, c,
        [&](Id spoke, bool isAtVertex)
        {
          faces[spoke] = number;
          faces[corners + number++] = 2 * spoke + (isAtVertex ? 1 : 0);
        });
    });
  ForNumbered<Id>(
    corners, [&](vtkIdType face, Id& number) { number += SpokeFace<Id>(later, face).CountOwn(); },
    [&](vtkIdType face, Id& number)
    {
      faces[4 * corners + face] = number;
      const SpokeFace<Id> spoke(later, face);
      Id others = 0;
      for (std::size_t i = 0; i < 4; ++i)
      {
        const std::size_t side = spoke.GetSide(i);
        const bool isOwn = spoke.IsOwn(side);
        *(isOwn ? faces + later.GetPlace(spoke.Corner, spoke.Across, side) : &others) = number;
        number += isOwn;
      }
    });
}

/// Writes the vertices of a spoke's face, from its first corner on.
template <typename Id>
void CopyVertices(const LaterLevels<Id>& later, vtkIdType face, Id* to)
{
  const Id corner = later.GetSpoke(face);
  const OfSpoke<Id> vertices = later.GetVertices(corner, later.GetAcross(corner));
  const bool isTurned = later.GetFirst(face) > 0;
  to[0] = isTurned ? vertices[2] : vertices[0];
  to[1] = isTurned ? vertices[3] : vertices[1];
  to[2] = isTurned ? vertices[0] : vertices[2];
  to[3] = isTurned ? vertices[1] : vertices[3];
}

/// Appends rows of vertices with four around each: writeRing(i, columns) for i of [begin, end), in
/// order.
template <typename Id, typename WriteRing>
void AppendRings(
  vtkIdType begin, vtkIdType end, Id firstVertex, const WriteRing& writeRing, RowBlock<Id>& rows)
{
  rows.AddRun(FourEightVertex, end - begin,
    [&](vtkIdType i, Id* columns)
    {
      columns[0] = static_cast<Id>(firstVertex + begin + i);
      writeRing(begin + i, columns + 1);
      return true;
    });
}

/// The rows of vertices of this level, and of those in its faces. `ring(corner)`: what lies around
/// a corner's vertex; `inFace(corner)`: around the vertex in its face.
template <typename Id, typename Ring, typename InFace>
void AppendKnownVertices(const SurfaceLevel<Id>& level, const LaterLevels<Id>& later,
  vtkIdType begin, vtkIdType end, const Ring& ring, const InFace& inFace, RowBlock<Id>& rows)
{
  const FourEightMadeVertices<Id> made(level);
  const vtkIdType others = made.GetFirst();
  const auto visitAround = [&inFace](Id first, Id size, const auto& visit)
  { VisitInTurn(first, size, [&](Id corner) { visit(inFace(corner)); }); };
  ForKindsOfRows<3>({ others, level.Mesh.NumberOfVertices - others, level.Mesh.NumberOfFaces },
    begin, end,
    [&](std::size_t kind, vtkIdType first, vtkIdType last)
    {
      kind == 0     ? AppendWalkedVertices(later.Next, first, last, ring, rows)
        : kind == 1 ? made.Append(first, last, ring, rows)
                    : AppendVerticesInFaces(later.Next, first, last, visitAround, rows);
    });
}

/// The rows of those in quads. getRing(owner): what lies around that in the quad of an owner.
template <typename Id, typename GetRing>
void AppendVerticesInQuads(const LaterLevels<Id>& later, vtkIdType begin, vtkIdType end,
  const GetRing& getRing, RowBlock<Id>& rows)
{
  Id corner = later.Next.FindOwner(begin) - 1;
  AppendRings(
    begin, end, later.FirstQuad,
    [&](vtkIdType, Id* columns)
    {
      corner = later.Next.FindNextOwner(corner + 1);
      const std::array<Id, 4> ring = getRing(corner);
      std::copy(ring.begin(), ring.end(), columns);
    },
    rows);
}

/// The step from the level two steps later.
template <typename Id>
void AppendSecond(const SurfaceLevel<Id>& level, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
{
  const LaterLevels<Id> later(level);
  const auto ring = [&later](Id corner) { return later.GetVertexInQuad(corner); };
  ForKindsOfRows<3>({ later.FirstQuad, later.FirstSpoke - later.FirstQuad, later.Corners }, begin,
    end,
    [&](std::size_t kind, vtkIdType first, vtkIdType last)
    {
      switch (kind)
      {
        case 0:
          return AppendKnownVertices(level, later, first, last, ring, ring, rows);
        case 1:
          return AppendVerticesInQuads(
            later, first, last, [&later](Id owner) { return later.Next.GetVertices(owner); }, rows);
        default:
          rows.AddRun(FourEightCentre, last - first,
            [&](vtkIdType i, Id* columns)
            {
              CopyVertices(later, first + i, columns);
              return true;
            });
      }
    });
}

/// Writes the vertices of the faces across the sides that belong to a spoke's face, three steps
/// later. Returns how many faces there are.
template <typename Id>
std::size_t WriteFacesAcross(const LaterLevels<Id>& later, vtkIdType face, Id (&to)[16])
{
  const SpokeFace<Id> spoke(later, face);
  const OfSpoke<Id> vertices = later.GetVertices(spoke.Corner, spoke.Across);
  std::size_t count = 0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    const std::size_t side = spoke.GetSide(i);
    Id* const quad = to + 4 * count;
    quad[0] = vertices[side];
    quad[1] = later.FirstSpoke + spoke.FacesAcross[side];
    quad[2] = vertices[(side + 1) % 4];
    quad[3] = later.FirstSpoke + spoke.Face;
    count += spoke.IsOwn(side);
  }
  return count;
}

/// The rows of vertices in faces across sides, from face to face.
template <typename Id>
void AppendCentres(const LaterLevels<Id>& later, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
{
  vtkIdType face = later.FindFaceOfSide(begin);
  auto used = static_cast<std::size_t>(begin - later.GetFirstSide(face));
  Id quads[16];
  std::size_t found = WriteFacesAcross(later, face, quads);
  rows.AddRun(FourEightCentre, end - begin,
    [&](vtkIdType, Id* columns)
    {
      while (used == found)
      {
        used = 0;
        found = WriteFacesAcross(later, ++face, quads);
      }
      std::copy_n(quads + 4 * used++, 4, columns);
      return true;
    });
}

/// The step from the level three steps later.
template <typename Id>
void AppendThird(const SurfaceLevel<Id>& level, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
{
  const LaterLevels<Id> later(level);
  const PolygonMesh<Id>& mesh = level.Mesh;
  const auto inFace = [&later](Id corner) { return later.GetVertexInSpoke(corner); };
  const auto ring = [&](Id corner) { return inFace(mesh.Next(mesh.Twins[corner])); };
  ForKindsOfRows<4>({ later.FirstQuad, later.FirstSpoke - later.FirstQuad, later.Corners,
                      2 * static_cast<vtkIdType>(later.Corners) },
    begin, end,
    [&](std::size_t kind, vtkIdType first, vtkIdType last)
    {
      switch (kind)
      {
        case 0:
          return AppendKnownVertices(level, later, first, last, ring, inFace, rows);
        case 1:
          return AppendVerticesInQuads(
            later, first, last,
            [&](Id owner)
            {
              const Id twin = mesh.Twins[owner];
              return std::array<Id, 4>{ inFace(owner), inFace(mesh.Next(twin)), inFace(twin),
                inFace(mesh.Next(owner)) };
            },
            rows);
        case 2:
          return AppendRings(
            first, last, later.FirstSpoke,
            [&later](vtkIdType face, Id* columns) { CopyVertices(later, face, columns); }, rows);
        default:
          return AppendCentres(later, first, last, rows);
      }
    });
}

template <typename Id>
void AppendRows(
  const SurfaceLevel<Id>& level, int ahead, vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
{
  ahead == 2 ? AppendSecond(level, begin, end, rows) : AppendThird(level, begin, end, rows);
}

/// Vertices that were there stay, and new ones are the means of faces.
template <typename Id>
void GetParents(
  const SurfaceLevel<Id>& level, int ahead, vtkIdType row, std::vector<vtkIdType>& parents)
{
  const LaterLevels<Id> later(level);
  if (row < (ahead == 2 ? later.FirstSpoke : later.FirstSide))
  {
    parents.assign({ row });
    return;
  }
  ListColumns<Id>(
    [&](RowBlock<Id>& rows) { AppendRows(level, ahead, row, row + 1, rows); }, parents);
}

/// The faces of the level four steps later that come from a spoke's face: each lies across a side
/// of a face three steps later, which belongs to the spoke's face, and belongs to it.
template <typename Id>
class LastFaces
{
public:
  LastFaces(const LaterLevels<Id>& later, vtkIdType face)
    : Later(later)
    , Spoke(later, face)
    , Sides(later.GetSides(this->Spoke.Corner, this->Spoke.Across))
    , After(later.GetSidesAfter(this->Spoke.Corner, this->Spoke.Across))
    , Before(later.GetSidesBefore(this->Spoke.Across))
  {
  }

  Id Count() const
  {
    Id count = 0;
    for (std::size_t side = 0; side < 4; ++side)
    {
      for (const Id other : this->GetNeighbours(side))
      {
        count += this->Spoke.IsOwn(side) & (this->Sides[side] < other);
      }
    }
    return count;
  }

  /// Writes them, one after the other, and returns how many there are.
  template <typename Out>
  Id Write(Out* const first) const
  {
    const OfSpoke<Id> ofSpoke = this->Later.GetVertices(this->Spoke.Corner, this->Spoke.Across);
    Out* to = first;
    Out others[4]; // for faces that belong to others, so that no neighbouring block is touched
    for (std::size_t i = 0; i < 4; ++i)
    {
      const std::size_t side = this->Spoke.GetSide(i);
      const bool isOwnSide = this->Spoke.IsOwn(side);
      const Id quad = this->Sides[side];
      const std::array<Id, 4> neighbours = this->GetNeighbours(side);
      const std::array<Id, 4> vertices = { ofSpoke[side],
        this->Later.FirstSpoke + this->Spoke.FacesAcross[side], ofSpoke[(side + 1) % 4],
        this->Later.FirstSpoke + this->Spoke.Face };
      for (std::size_t k = 0; k < 4; ++k)
      {
        const bool isOwn = isOwnSide & (quad < neighbours[k]);
        WriteFace(isOwn ? to : others, vertices[k], this->Later.FirstSide + neighbours[k],
          vertices[(k + 1) % 4], this->Later.FirstSide + quad);
        to += isOwn ? 4 : 0;
      }
    }
    return static_cast<Id>((to - first) / 4);
  }

private:
  /// The faces three steps later across the sides of that across a side of the spoke's face.
  std::array<Id, 4> GetNeighbours(std::size_t side) const
  {
    return { this->After[side], this->Before[side], this->Sides[(side + 1) % 4],
      this->Sides[(side + 3) % 4] };
  }

  const LaterLevels<Id>& Later;
  const SpokeFace<Id> Spoke;
  const OfSpoke<Id> Sides;
  const OfSpoke<Id> After;
  const OfSpoke<Id> Before;
};

template <typename Id, typename Out>
void WriteFaces(const SurfaceLevel<Id>& level, Out* ids)
{
  const LaterLevels<Id> later(level);
  ForNumbered<Id>(
    later.Corners, [&](vtkIdType face, Id& number)
    { number += LastFaces<Id>(later, face).Count(); }, [&](vtkIdType face, Id& number)
    { number += LastFaces<Id>(later, face).Write(ids + 4 * static_cast<vtkIdType>(number)); });
}

}

template <typename Id>
StepsOfLater<Id> MakeFourEightStepsOfLater()
{
  return { Prepare<Id>, AppendRows<Id>, GetParents<Id>,
    [](const SurfaceLevel<Id>& level, IdsOut ids)
    { std::visit([&level](auto* to) { WriteFaces(level, to); }, ids); } };
}

SUBDIVISION_COMPILE_FUNCTION(MakeFourEightStepsOfLater);

}
