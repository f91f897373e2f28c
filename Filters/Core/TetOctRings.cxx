// SPDX-License-Identifier: BSD-3-Clause
// Rings of the next level: emit(carrier, member).
#include "TetOctRefiner.h"

namespace subdivision
{
namespace
{

/// Faces at an edge of which two octahedra are known, and neighbours of a vertex with six.
constexpr int RegularFaces = 4;
constexpr int RegularEdgeRing = 8;
constexpr int RegularVertexRing = 18;

/// Position of a vertex in a face of an octahedron.
constexpr int CornerOf(int face, int vertex)
{
  const int* corners = octahedron::FaceVertices[face];
  return corners[0] == vertex ? 0 : corners[1] == vertex ? 1 : 2;
}

/// The first vertex of the pair that an edge of an octahedron does not touch.
constexpr int ThirdPair(int a, int b)
{
  return 2 * (3 - (a >> 1) - (b >> 1));
}

}

/// act(isTet, cell, its local edge) for each solid at an edge of dimension 3 or a blended one.
template <typename Id>
template <typename Act>
void TetOctRefiner<Id>::ForCellsAround(Id edge, const Act& act) const
{
  const auto& parent = this->Parent;
  const Row<Id> carriers = this->Strata.EdgeRings.GetCarriers(edge);
  const bool regular = this->Strata.Edges[edge].GetRule() == Rule::RegularEdge;
  const Id* last = regular ? carriers.begin() + RegularFaces : carriers.end();
  for (const Id* face = carriers.begin(); face != last; ++face)
  {
    if (*face < 0)
    {
      continue;
    }
    for (Id cell : parent.FaceTets[*face])
    {
      // Two faces of the cell lie at the edge; the first of them speaks for it.
      if (cell < parent.NumberOfTets)
      {
        const int local = parent.EdgeInTet(cell, edge);
        const int opposite = tetrahedron::OppositeEdge(local);
        if (parent.TetFaces[4 * vtkIdType(cell) + tetrahedron::EdgeVertices[opposite][0]] == *face)
        {
          act(true, cell, local);
        }
        continue;
      }
      const Id oct = cell - parent.NumberOfTets;
      const int local = Find(this->Level.OctEdges.data() + 12 * vtkIdType(oct), 12, edge);
      const int* ends = octahedron::EdgeVertices[local];
      const int first = octahedron::FaceOf(ends[0], ends[1], ThirdPair(ends[0], ends[1]));
      if (this->Level.OctFaces[8 * vtkIdType(oct) + first] == *face)
      {
        act(false, oct, local);
      }
    }
  }
}

/// Half an edge keeps the parent's ring: the midpoints towards its members; of an octahedron that
/// is half as large the centre is opposite to the end.
template <typename Id>
template <typename Emit>
void TetOctRefiner<Id>::EmitHalfEdgeRing(Id edge, Id end, const Emit& emit) const
{
  const Row<Id> carriers = this->Strata.EdgeRings.GetCarriers(edge);
  const bool regular = this->Strata.Edges[edge].GetRule() == Rule::RegularEdge;
  const Id* last = regular ? carriers.begin() + RegularFaces : carriers.end();
  for (const Id* face = carriers.begin(); face != last; ++face)
  {
    if (*face >= 0)
    {
      const int corner = this->Parent.VertexInFace(*face, end);
      emit(this->Ids.Face(*face, corner), this->OtherMidpoint(*face, edge, corner));
    }
  }
  const Id other = this->Parent.OtherEnd(edge, end);
  for (const Id* oct = last; oct != carriers.end(); oct += 2)
  {
    const int a = this->VertexInOct(*oct, end);
    const int b = this->VertexInOct(*oct, other);
    const Id child = this->Ids.OctOfOct(*oct, a);
    emit(child, this->Ids.Centre(*oct));
    emit(child, this->OctMidpoint(*oct, a, octahedron::Opposite(b)));
  }
}

/// Where a face is in a cell at it.
template <typename Id>
FaceSide<Id> TetOctRefiner<Id>::GetSide(Id face, Id cell) const
{
  const auto& parent = this->Parent;
  const Id* vertices = parent.FaceVertices.data() + 3 * vtkIdType(face);
  FaceSide<Id> side;
  side.IsTet = cell < parent.NumberOfTets;
  side.Cell = side.IsTet ? cell : cell - parent.NumberOfTets;
  for (int i = 0; i < 3; ++i)
  {
    side.Corners[i] = side.IsTet ? parent.VertexInTet(side.Cell, vertices[i])
                                 : this->VertexInOct(side.Cell, vertices[i]);
  }
  side.Face = side.IsTet ? parent.FaceInTet(side.Cell, face)
                         : octahedron::FaceOf(side.Corners[0], side.Corners[1], side.Corners[2]);
  return side;
}

/// The edge that cuts a corner off a face: the corner and the opposite midpoint, one point in each
/// cell beside the face; then the opposites in the octahedra there. `sides`: the two of a face of
/// dimension 3.
template <typename Id>
template <typename Emit>
void TetOctRefiner<Id>::EmitInFaceRing(
  Id face, int corner, const FaceSide<Id> sides[2], const Emit& emit) const
{
  const auto& parent = this->Parent;
  const Rule rule = this->Strata.Faces[face].GetRule();
  if (rule == Rule::Curve)
  {
    return;
  }
  const Id* vertices = parent.FaceVertices.data() + 3 * vtkIdType(face);
  emit(this->Ids.Face(face, corner), vertices[corner]);
  emit(this->Ids.Face(face, 3),
    this->Ids.Midpoint(parent.FaceEdges[3 * vtkIdType(face) + triangle::EdgeOpposite[corner]]));
  if (rule == Rule::Surface)
  {
    return;
  }
  auto emitNear = [&](const FaceSide<Id>& side)
  {
    const int a = side.Corners[corner];
    if (side.IsTet)
    {
      emit(this->Ids.Cut(side.Cell, a),
        this->Ids.Midpoint(
          parent.TetEdges[6 * vtkIdType(side.Cell) + tetrahedron::EdgeOf[a][side.Face]]));
      return;
    }
    emit(this->Ids.Fan(side.Cell, side.Face, CornerOf(side.Face, a)), this->Ids.Centre(side.Cell));
  };
  if (rule == Rule::Blend)
  {
    for (Id cell : parent.FaceTets[face])
    {
      emitNear(this->GetSide(face, cell));
    }
    return;
  }
  emitNear(sides[0]);
  emitNear(sides[1]);
  for (int s = 0; s < 2; ++s)
  {
    const FaceSide<Id>& side = sides[s];
    const int others[2] = { side.Corners[(corner + 1) % 3], side.Corners[(corner + 2) % 3] };
    for (int i = 0; i < 2; ++i)
    {
      if (side.IsTet) // opposite to the midpoint of the corner and others[i]
      {
        emit(this->Ids.OctOfTet(side.Cell),
          this->Ids.Midpoint(parent.TetEdges[6 * vtkIdType(side.Cell) +
            tetrahedron::EdgeOf[others[1 - i]][side.Face]]));
        continue;
      }
      const int a = side.Corners[corner];
      emit(this->Ids.OctOfOct(side.Cell, a),
        this->OctMidpoint(side.Cell, a, octahedron::Opposite(others[i])));
    }
  }
}

/// From the centre of an octahedron to the midpoint of its edge.
template <typename Id>
template <typename Emit>
void TetOctRefiner<Id>::EmitSpokeRing(Id oct, int edge, const Emit& emit) const
{
  const int* ends = octahedron::EdgeVertices[edge];
  const int third = ThirdPair(ends[0], ends[1]);
  for (int r = third; r < third + 2; ++r)
  {
    const int face = octahedron::FaceOf(ends[0], ends[1], r);
    for (int i = 0; i < 2; ++i)
    {
      emit(this->Ids.Fan(oct, face, CornerOf(face, ends[i])), this->OctMidpoint(oct, ends[i], r));
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

/// An old vertex keeps its ring: midpoints towards neighbours, centres towards opposites.
template <typename Id>
template <typename Emit>
void TetOctRefiner<Id>::EmitVertexRing(Id vertex, const Emit& emit) const
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
    emit(this->Ids.OctOfOct(*oct, this->VertexInOct(*oct, vertex)), this->Ids.Centre(*oct));
  }
}

/// The midpoint of an edge: its ends; on each face of the edge's ring two midpoints; the centre of
/// each octahedron; then what is opposite in the octahedra around it.
template <typename Id>
template <typename Emit>
void TetOctRefiner<Id>::EmitMidpointRing(Id edge, const Emit& emit) const
{
  const auto& parent = this->Parent;
  const Rule rule = this->Strata.Edges[edge].GetRule();
  const Id ends[2] = { parent.EdgeVertices[2 * vtkIdType(edge)],
    parent.EdgeVertices[2 * vtkIdType(edge) + 1] };
  emit(2 * edge, ends[0]);
  emit(2 * edge + 1, ends[1]);
  if (rule == Rule::Curve)
  {
    return;
  }
  const Row<Id> carriers = this->Strata.EdgeRings.GetCarriers(edge);
  const Id* last = rule == Rule::RegularEdge ? carriers.begin() + RegularFaces : carriers.end();
  for (const Id* face = carriers.begin(); face != last; ++face)
  {
    if (*face >= 0)
    {
      for (Id end : ends)
      {
        const int corner = parent.VertexInFace(*face, end);
        emit(this->Ids.InFace(*face, corner), this->OtherMidpoint(*face, edge, corner));
      }
    }
  }
  if (rule == Rule::Surface)
  {
    return;
  }
  this->ForCellsAround(edge,
    [&](bool isTet, Id cell, int local)
    {
      if (!isTet)
      {
        emit(this->Ids.Spoke(cell, local), this->Ids.Centre(cell));
      }
    });
  if (rule == Rule::Blend)
  {
    return;
  }
  this->ForCellsAround(edge,
    [&](bool isTet, Id cell, int local)
    {
      if (isTet)
      {
        emit(this->Ids.OctOfTet(cell),
          this->Ids.Midpoint(
            parent.TetEdges[6 * vtkIdType(cell) + tetrahedron::OppositeEdge(local)]));
        return;
      }
      const int* corners = octahedron::EdgeVertices[local];
      for (int i = 0; i < 2; ++i)
      {
        emit(this->Ids.OctOfOct(cell, corners[i]),
          this->OctMidpoint(cell, corners[i], octahedron::Opposite(corners[1 - i])));
      }
    });
}

template <typename Id>
template <typename Emit>
void TetOctRefiner<Id>::EmitCentreRing(Id oct, const Emit& emit) const
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

template <typename Id>
void TetOctRefiner<Id>::MakeRings()
{
  const auto& parent = this->Parent;
  const vtkIdType vertices = parent.NumberOfVertices;
  const vtkIdType edges = parent.NumberOfEdges;
  const vtkIdType octs = this->Level.NumberOfOctahedra;
  // Regular rows have a size that is known; the others are emitted once to be counted.
  auto make = [this](Rings<Id>& rings, vtkIdType size, const auto& each)
  {
    rings.Offsets = Buffer<Id>(size + 1);
    each(
      [&](vtkIdType row, int regularSize, const auto& emitRow)
      {
        Id count = static_cast<Id>(regularSize);
        if (regularSize == 0)
        {
          emitRow([&count](Id, Id) { ++count; });
        }
        rings.Offsets[row] = count;
      });
    CountsToOffsets(rings.Offsets);
    rings.Members = Buffer<Id>(rings.Offsets[size]);
    rings.Carriers = Buffer<Id>(this->Full ? vtkIdType(rings.Offsets[size]) : 0);
    each(
      [&](vtkIdType row, int, const auto& emitRow)
      {
        Id next = rings.Offsets[row];
        emitRow(
          [&](Id carrier, Id member)
          {
            rings.Members[next] = member;
            if (this->Full)
            {
              rings.Carriers[next] = carrier;
            }
            ++next;
          });
      });
  };
  auto isRegular = [](Stratum stratum) { return stratum.GetRule() == Rule::RegularEdge; };
  auto eachEdge = [&](const auto& act)
  {
    ForEach(edges,
      [&](vtkIdType i)
      {
        const Id e = static_cast<Id>(i);
        const int size = isRegular(this->Strata.Edges[i]) ? RegularEdgeRing : 0;
        for (int half = 0; half < 2; ++half)
        {
          act(2 * i + half, size,
            [&](const auto& emit)
            { this->EmitHalfEdgeRing(e, parent.EdgeVertices[2 * i + half], emit); });
        }
      });
    ForEach(parent.NumberOfFaces,
      [&](vtkIdType i)
      {
        const Id f = static_cast<Id>(i);
        const int size = this->Strata.Faces[i].GetRule() == Rule::Solid ? RegularEdgeRing : 0;
        FaceSide<Id> sides[2]; // of a face of dimension 3, looked up once for its three edges
        for (int corner = 0; corner < 3; ++corner)
        {
          act(this->Ids.InFace(f, corner), size,
            [&](const auto& emit)
            {
              if (corner == 0 && size > 0)
              {
                const Row<Id> cells = parent.FaceTets[f];
                sides[0] = this->GetSide(f, cells.begin()[0]);
                sides[1] = this->GetSide(f, cells.begin()[1]);
              }
              this->EmitInFaceRing(f, corner, sides, emit);
            });
        }
      });
    ForEach(octs,
      [&](vtkIdType i)
      {
        const Id o = static_cast<Id>(i);
        for (int e = 0; e < 12; ++e)
        {
          act(this->Ids.Spoke(o, e), RegularEdgeRing,
            [&](const auto& emit) { this->EmitSpokeRing(o, e, emit); });
        }
      });
  };
  auto eachVertex = [&](const auto& act)
  {
    ForEach(vertices,
      [&](vtkIdType v)
      {
        act(v, static_cast<int>(this->Strata.VertexRings.GetSize(v)),
          [&](const auto& emit) { this->EmitVertexRing(static_cast<Id>(v), emit); });
      });
    ForEach(edges,
      [&](vtkIdType e)
      {
        act(vertices + e, isRegular(this->Strata.Edges[e]) ? RegularVertexRing : 0,
          [&](const auto& emit) { this->EmitMidpointRing(static_cast<Id>(e), emit); });
      });
    ForEach(octs,
      [&](vtkIdType o)
      {
        act(vertices + edges + o, RegularVertexRing,
          [&](const auto& emit) { this->EmitCentreRing(static_cast<Id>(o), emit); });
      });
  };
  make(this->Child.Strata.EdgeRings, this->Child.Complex.NumberOfEdges, eachEdge);
  make(this->Child.Strata.VertexRings, this->Child.Complex.NumberOfVertices, eachVertex);
}

template class TetOctRefiner<int>;
template class TetOctRefiner<long long>;

}
