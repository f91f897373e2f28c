// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetOctRingEmitter.h
 * Computes the rings of the next level (TetOctComplex.h) from a tet/oct level and passes them on
 * member by member. Refine stores them (TetOctRings.cxx); TetOctChildRows sums with them at once.
 */
#ifndef SubdivisionObjects_TetOctRingEmitter_h
#define SubdivisionObjects_TetOctRingEmitter_h

#include "Core/Solids/BoxSpline/RingEmitter.h"
#include "Core/Solids/TetOct/TetOctComplex.h"
#include "Core/Solids/TetOct/TetOctMasks.h"
#include "Core/Solids/TetOct/TetOctTables.h"

namespace subdivision
{

/// The number of faces at a regular edge, and the sizes of the rings of a regular edge and vertex.
/// The first carriers of a regular edge's ring are its faces, the others its two octahedra.
constexpr int RegularFaces = 4;
constexpr int RegularEdgeRing = 8;
constexpr int RegularVertexRing = 18;

/// The position of a value that is in the list. There are no branches, because the processor would
/// mispredict them.
template <int Size, typename Id>
int FindPlace(const Id* list, Id wanted)
{
  int place = 0;
  for (int i = 1; i < Size; ++i)
  {
    place += list[i] == wanted ? i : 0;
  }
  return place;
}
template <typename Id>
int VertexInOct(const TetOctLevel<Id>& level, Id oct, Id vertex)
{
  return FindPlace<6>(level.OctVertices.data() + 6 * vtkIdType(oct), vertex);
}

template <typename Id>
class TetOctRingEmitter
{
public:
  explicit TetOctRingEmitter(const TetOctLevel<Id>& parent)
    : Level(parent)
    , Parent(parent.Complex)
    , Strata(parent.Strata)
    , Ids(parent)
  {
  }

  /// The size of the ring of half an edge.
  Id CountHalf(Id edge) const
  {
    Id size = this->IsRegular(edge) ? RegularEdgeRing - RegularFaces : 0;
    for (Id face : this->GetFaces(edge))
    {
      size += face >= 0 ? 1 : 0;
    }
    return size;
  }
  /// The size of the ring of an edge's midpoint.
  Id CountMidpoint(Id edge) const
  {
    const Rule rule = this->Strata.Edges[edge].GetRule();
    if (rule == Rule::RegularEdge || rule == Rule::Surface)
    {
      return rule == Rule::Surface ? 2 + 2 * this->CountHalf(edge) : RegularVertexRing;
    }
    RingCounter<Id> midpoint;
    RingCounter<Id> halves[2];
    this->EmitAtEdge(edge, halves, midpoint);
    return midpoint.Size;
  }
  /// The size of the ring of each of the three edges inside a face.
  Id CountInFace(Id face) const
  {
    const Rule rule = this->Strata.Faces[face].GetRule();
    return rule == Rule::Solid ? RegularEdgeRing
      : rule == Rule::Surface  ? 2
      : rule == Rule::Curve    ? 0
                               : 2 + static_cast<Id>(this->Parent.FaceTets[face].size());
  }

  /// Emits the ring of an old vertex: the midpoints of the edges to its neighbours, and the centres
  /// of the octahedra with its opposites.
  template <typename Emit>
  void EmitVertex(Id vertex, Emit& emit) const;

  /// Emits the rings of the two halves and of the midpoint of an edge. For each face that carries a
  /// member of the edge's ring, the ring of a half has the midpoint of the other edge of the face
  /// at this half's end; for each octahedron of a regular edge it has the two opposites of the
  /// half's ends in the child octahedron there, the first of which is the centre. The ring of the
  /// midpoint has the two ends; for each such face the midpoints of both other edges; the centre of
  /// each octahedron; then the opposites of the midpoint in the child octahedra around it.
  template <typename Emit>
  void EmitAtEdge(Id edge, Emit (&emitHalves)[2], Emit& emitMidpoint) const;

  /// Emits the rings of the three edges that cut the corners off a face: the corner, the midpoint
  /// opposite to it, one point in each cell at the face; then the opposites in the child octahedra
  /// there.
  template <typename Emit>
  void EmitInFace(Id face, Emit (&emitCorners)[3]) const;

  /// Emits the ring of a spoke, the edge from the centre of an octahedron to the midpoint of its
  /// edge.
  template <typename Emit>
  void EmitSpoke(Id oct, int edge, Emit& emit) const;

  template <typename Emit>
  void EmitCentre(Id oct, Emit& emit) const;

  Stratum InFaceStratum(Id face) const
  {
    const Stratum stratum = this->Strata.Faces[face];
    return stratum.GetRule() == Rule::Solid ? Stratum(Rule::RegularEdge) : stratum;
  }

  /// The ends of half an edge, of the edge that cuts a corner off a face, and of a spoke.
  void GetHalfEnds(Id edge, int half, Id ends[2]) const
  {
    ends[half] = this->Parent.EdgeVertices[2 * vtkIdType(edge) + half];
    ends[1 - half] = this->Ids.Midpoint(edge);
  }
  void GetInFaceEnds(Id face, int corner, Id ends[2]) const
  {
    const Id* edges = this->Parent.FaceEdges.data() + 3 * vtkIdType(face);
    ends[0] = this->Ids.Midpoint(edges[triangle::EdgesAt[corner][0]]);
    ends[1] = this->Ids.Midpoint(edges[triangle::EdgesAt[corner][1]]);
  }
  void GetSpokeEnds(Id oct, int edge, Id ends[2]) const
  {
    ends[0] = this->Ids.Centre(oct);
    ends[1] = this->Ids.Midpoint(this->Level.OctEdges[12 * vtkIdType(oct) + edge]);
  }

private:
  /// A solid at an edge, and which of its own edges that is.
  struct CellAtEdge
  {
    bool IsTet;
    Id Cell;
    int Local;
  };
  /// A solid at a face; `Face` and `Corners` are the local numbers in it of the face and of the
  /// face's vertices.
  struct FaceSide
  {
    Id Cell; ///< a tetrahedron or an octahedron
    bool IsTet;
    int Face;
    int Corners[3];
  };

  bool IsRegular(Id edge) const { return this->Strata.Edges[edge].GetRule() == Rule::RegularEdge; }
  /// The faces among the carriers of an edge's ring; negative: none.
  Row<Id> GetFaces(Id edge) const
  {
    const Row<Id> carriers = this->Strata.EdgeRings.GetCarriers(edge);
    return { carriers.begin(),
      this->IsRegular(edge) ? carriers.begin() + RegularFaces : carriers.end() };
  }
  template <typename Act>
  void ForCellsAround(Id edge, const Act& act) const;
  template <typename Emit>
  void EmitAround(Id edge, Rule rule, Emit& midpoint) const;
  FaceSide GetSide(Id face, Id cell) const;
  template <typename Emit>
  void EmitNear(const FaceSide& side, Emit (&corners)[3]) const;
  template <typename Emit>
  void EmitFar(const FaceSide& side, Emit (&corners)[3]) const;

  Id OctMidpoint(Id oct, int a, int b) const
  {
    return this->Ids.Midpoint(this->Level.OctEdges[12 * vtkIdType(oct) + octahedron::EdgeOf[a][b]]);
  }

  const TetOctLevel<Id>& Level;
  const SimplicialComplex<Id>& Parent;
  const subdivision::Strata<Id>& Strata;
  const TetOctIds<Id> Ids;
};

template <typename Id>
template <typename Emit>
void TetOctRingEmitter<Id>::EmitVertex(Id vertex, Emit& emit) const
{
  const Row<Id> carriers = this->Strata.VertexRings.GetCarriers(vertex);
  const vtkIdType opposites = CountOpposites(this->Strata.Vertices[vertex].GetRule(),
    carriers.size(), vertex < this->Level.NumberOfControlVertices);
  const Id* firstOct = carriers.end() - opposites;
  for (const Id* edge = carriers.begin(); edge != firstOct; ++edge)
  {
    emit(this->Ids.Half(*edge, vertex), this->Ids.Midpoint(*edge));
  }
  for (const Id* oct = firstOct; oct != carriers.end(); ++oct)
  {
    emit(this->Ids.OctOfOct(*oct, VertexInOct(this->Level, *oct, vertex)), this->Ids.Centre(*oct));
  }
}

/// act(cell) for each solid at an edge of dimension 3 or a blended one.
template <typename Id>
template <typename Act>
void TetOctRingEmitter<Id>::ForCellsAround(Id edge, const Act& act) const
{
  const auto& parent = this->Parent;
  for (Id face : this->GetFaces(edge))
  {
    if (face < 0)
    {
      continue;
    }
    for (Id cell : parent.FaceTets[face])
    {
      // Two faces of the cell lie at the edge; only the first of them counts it.
      if (cell < parent.NumberOfTets)
      {
        const int local = parent.EdgeInTet(cell, edge);
        const int opposite = tetrahedron::OppositeEdge(local);
        if (parent.TetFaces[4 * vtkIdType(cell) + tetrahedron::EdgeVertices[opposite][0]] == face)
        {
          act(CellAtEdge{ true, cell, local });
        }
        continue;
      }
      const Id oct = cell - parent.NumberOfTets;
      const int local = FindPlace<12>(this->Level.OctEdges.data() + 12 * vtkIdType(oct), edge);
      if (this->Level.OctFaces[8 * vtkIdType(oct) + octahedron::FirstFaceAt(local)] == face)
      {
        act(CellAtEdge{ false, oct, local });
      }
    }
  }
}

template <typename Id>
template <typename Emit>
void TetOctRingEmitter<Id>::EmitAtEdge(Id edge, Emit (&emitHalves)[2], Emit& emitMidpoint) const
{
  // Copies, which stay in registers.
  Emit halves[2] = { emitHalves[0], emitHalves[1] };
  Emit midpoint = emitMidpoint;
  const auto& parent = this->Parent;
  const Rule rule = this->Strata.Edges[edge].GetRule();
  const Id ends[2] = { parent.EdgeVertices[2 * vtkIdType(edge)],
    parent.EdgeVertices[2 * vtkIdType(edge) + 1] };
  midpoint(2 * edge, ends[0]);
  midpoint(2 * edge + 1, ends[1]);
  const Row<Id> faces = this->GetFaces(edge);
  for (Id face : faces)
  {
    if (face < 0)
    {
      continue;
    }
    const Id* edges = parent.FaceEdges.data() + 3 * vtkIdType(face);
    const int place = parent.EdgeInFace(face, edge);
    const int first = triangle::EdgeVertices[place][0];
    // Whether the face has the edge the other way round.
    const int turned = parent.FaceVertices[3 * vtkIdType(face) + first] == ends[0] ? 0 : 1;
    for (int half = 0; half < 2; ++half)
    {
      const int end = half ^ turned;
      const int corner = triangle::EdgeVertices[place][end];
      const Id member = this->Ids.Midpoint(edges[triangle::EdgeBeside[place][end]]);
      halves[half](this->Ids.Face(face, corner), member);
      if (rule != Rule::Curve)
      {
        midpoint(this->Ids.InFace(face, corner), member);
      }
    }
  }
  const Row<Id> carriers = this->Strata.EdgeRings.GetCarriers(edge);
  for (const Id* oct = faces.end(); oct != carriers.end(); oct += 2)
  {
    const int corners[2] = { VertexInOct(this->Level, *oct, ends[0]),
      VertexInOct(this->Level, *oct, ends[1]) };
    for (int half = 0; half < 2; ++half)
    {
      const Id child = this->Ids.OctOfOct(*oct, corners[half]);
      halves[half](child, this->Ids.Centre(*oct));
      halves[half](
        child, this->OctMidpoint(*oct, corners[half], octahedron::Opposite(corners[1 - half])));
    }
  }
  if (rule != Rule::Curve && rule != Rule::Surface)
  {
    this->EmitAround(edge, rule, midpoint);
  }
  emitHalves[0] = halves[0];
  emitHalves[1] = halves[1];
  emitMidpoint = midpoint;
}

/// Emits those members of the ring of an edge's midpoint that lie inside the solids at the edge.
template <typename Id>
template <typename Emit>
void TetOctRingEmitter<Id>::EmitAround(Id edge, Rule rule, Emit& midpoint) const
{
  auto emitCentre = [&](const CellAtEdge& at)
  {
    if (!at.IsTet)
    {
      midpoint(this->Ids.Spoke(at.Cell, at.Local), this->Ids.Centre(at.Cell));
    }
  };
  auto emitOpposites = [&](const CellAtEdge& at)
  {
    if (at.IsTet)
    {
      midpoint(this->Ids.OctOfTet(at.Cell),
        this->Ids.Midpoint(
          this->Parent.TetEdges[6 * vtkIdType(at.Cell) + tetrahedron::OppositeEdge(at.Local)]));
      return;
    }
    const int* corners = octahedron::EdgeVertices[at.Local];
    for (int i = 0; i < 2; ++i)
    {
      midpoint(this->Ids.OctOfOct(at.Cell, corners[i]),
        this->OctMidpoint(at.Cell, corners[i], octahedron::Opposite(corners[1 - i])));
    }
  };
  if (rule == Rule::RegularEdge) // most edges by far: two cells of each kind, looked up once
  {
    CellAtEdge cells[RegularFaces];
    int size = 0;
    this->ForCellsAround(edge, [&](const CellAtEdge& at) { cells[size++] = at; });
    std::for_each(cells, cells + size, emitCentre);
    std::for_each(cells, cells + size, emitOpposites);
    return;
  }
  this->ForCellsAround(edge, emitCentre);
  if (rule != Rule::Blend)
  {
    this->ForCellsAround(edge, emitOpposites);
  }
}

/// Where a face is in a cell at it.
template <typename Id>
typename TetOctRingEmitter<Id>::FaceSide TetOctRingEmitter<Id>::GetSide(Id face, Id cell) const
{
  const auto& parent = this->Parent;
  const Id* vertices = parent.FaceVertices.data() + 3 * vtkIdType(face);
  FaceSide side;
  side.IsTet = cell < parent.NumberOfTets;
  if (side.IsTet)
  {
    side.Cell = cell;
    for (int i = 0; i < 3; ++i)
    {
      side.Corners[i] = parent.VertexInTet(cell, vertices[i]);
    }
    side.Face = parent.FaceInTet(cell, face);
    return side;
  }
  side.Cell = cell - parent.NumberOfTets;
  for (int i = 0; i < 3; ++i)
  {
    side.Corners[i] = VertexInOct(this->Level, side.Cell, vertices[i]);
  }
  side.Face = octahedron::FaceOf(side.Corners[0], side.Corners[1], side.Corners[2]);
  return side;
}

/// Emits, for each of the three edges inside a face, the one point that its ring has inside a cell.
template <typename Id>
template <typename Emit>
void TetOctRingEmitter<Id>::EmitNear(const FaceSide& side, Emit (&corners)[3]) const
{
  const Id* edges = this->Parent.TetEdges.data() + 6 * vtkIdType(side.Cell);
  for (int corner = 0; corner < 3; ++corner)
  {
    const int a = side.Corners[corner];
    if (side.IsTet)
    {
      corners[corner](
        this->Ids.Cut(side.Cell, a), this->Ids.Midpoint(edges[tetrahedron::EdgeOf[a][side.Face]]));
    }
    else
    {
      corners[corner](this->Ids.Fan(side.Cell, side.Face, octahedron::CornerOf(side.Face, a)),
        this->Ids.Centre(side.Cell));
    }
  }
}

/// Emits, for each of the three edges inside a face, the opposites of its ends in the child
/// octahedron of a cell.
template <typename Id>
template <typename Emit>
void TetOctRingEmitter<Id>::EmitFar(const FaceSide& side, Emit (&corners)[3]) const
{
  const Id* edges = this->Parent.TetEdges.data() + 6 * vtkIdType(side.Cell);
  for (int corner = 0; corner < 3; ++corner)
  {
    const int a = side.Corners[corner];
    const int others[2] = { side.Corners[(corner + 1) % 3], side.Corners[(corner + 2) % 3] };
    for (int i = 0; i < 2; ++i)
    {
      if (side.IsTet) // opposite to the midpoint of the corner and others[i]
      {
        corners[corner](this->Ids.OctOfTet(side.Cell),
          this->Ids.Midpoint(edges[tetrahedron::EdgeOf[others[1 - i]][side.Face]]));
      }
      else
      {
        corners[corner](this->Ids.OctOfOct(side.Cell, a),
          this->OctMidpoint(side.Cell, a, octahedron::Opposite(others[i])));
      }
    }
  }
}

template <typename Id>
template <typename Emit>
void TetOctRingEmitter<Id>::EmitInFace(Id face, Emit (&emitCorners)[3]) const
{
  const auto& parent = this->Parent;
  const Rule rule = this->Strata.Faces[face].GetRule();
  if (rule == Rule::Curve)
  {
    return;
  }
  Emit corners[3] = { emitCorners[0], emitCorners[1], emitCorners[2] };
  const Id* vertices = parent.FaceVertices.data() + 3 * vtkIdType(face);
  const Id* edges = parent.FaceEdges.data() + 3 * vtkIdType(face);
  for (int corner = 0; corner < 3; ++corner)
  {
    corners[corner](this->Ids.Face(face, corner), vertices[corner]);
    corners[corner](
      this->Ids.Face(face, 3), this->Ids.Midpoint(edges[triangle::EdgeOpposite[corner]]));
  }
  const Row<Id> cells = parent.FaceTets[face];
  if (rule == Rule::Blend)
  {
    for (Id cell : cells)
    {
      this->EmitNear(this->GetSide(face, cell), corners);
    }
  }
  else if (rule == Rule::Solid) // between two cells
  {
    const FaceSide sides[2] = { this->GetSide(face, cells.begin()[0]),
      this->GetSide(face, cells.begin()[1]) };
    this->EmitNear(sides[0], corners);
    this->EmitNear(sides[1], corners);
    this->EmitFar(sides[0], corners);
    this->EmitFar(sides[1], corners);
  }
  std::copy(corners, corners + 3, emitCorners);
}

template <typename Id>
template <typename Emit>
void TetOctRingEmitter<Id>::EmitSpoke(Id oct, int edge, Emit& emit) const
{
  const int* ends = octahedron::EdgeVertices[edge];
  const int third = octahedron::ThirdPair(ends[0], ends[1]);
  for (int r = third; r < third + 2; ++r)
  {
    const int face = octahedron::FaceOf(ends[0], ends[1], r);
    for (int i = 0; i < 2; ++i)
    {
      emit(this->Ids.Fan(oct, face, octahedron::CornerOf(face, ends[i])),
        this->OctMidpoint(oct, ends[i], r));
    }
  }
  for (int i = 0; i < 2; ++i)
  {
    const int a = ends[i];
    const Id child = this->Ids.OctOfOct(oct, a);
    emit(child, this->Level.OctVertices[6 * vtkIdType(oct) + a]);
    emit(child, this->OctMidpoint(oct, a, octahedron::Opposite(ends[1 - i])));
  }
}

template <typename Id>
template <typename Emit>
void TetOctRingEmitter<Id>::EmitCentre(Id oct, Emit& emit) const
{
  for (int e = 0; e < 12; ++e)
  {
    emit(
      this->Ids.Spoke(oct, e), this->Ids.Midpoint(this->Level.OctEdges[12 * vtkIdType(oct) + e]));
  }
  for (int v = 0; v < 6; ++v)
  {
    emit(this->Ids.OctOfOct(oct, v), this->Level.OctVertices[6 * vtkIdType(oct) + v]);
  }
}

}

#endif
