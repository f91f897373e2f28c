// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetOctSplit.h
 * How the tet/oct scheme splits solids (TetOctComplex.h), and the members of rings inside them.
 */
#ifndef SubdivisionObjects_TetOctSplit_h
#define SubdivisionObjects_TetOctSplit_h

#include "Core/Solids/Scheme/RingEmitter.h"
#include "Core/Solids/Scheme/Stencils.h"
#include "Core/Solids/TetOct/TetOctComplex.h"
#include "Core/Solids/TetOct/TetOctTables.h"

namespace subdivision
{

/// The number of faces at a regular edge, and the sizes of the rings of a regular edge and vertex.
/// The first carriers of a regular edge's ring are its faces, the others its two octahedra.
constexpr int RegularFaces = 4;
constexpr int RegularEdgeRing = 8;
constexpr int RegularVertexRing = 18;

/// How many members of the ring of a vertex are opposite to it in octahedra: the last ones.
constexpr vtkIdType CountOpposites(Rule rule, vtkIdType ringSize, bool isControl)
{
  return rule == Rule::RegularEdge ? 6 : rule == Rule::Solid && !isControl ? (ringSize - 2) / 3 : 0;
}

template <typename Id>
int VertexInOct(const TetOctLevel<Id>& level, Id oct, Id vertex)
{
  return FindPlace<6>(level.OctVertices.data() + 6 * vtkIdType(oct), vertex);
}

/// The masks of this scheme (TetOctMasks.h).
const RingMasks& TetOctMasks(LoopWeights weights);

/// As Stencils.h needs them. By symmetry smoothing does not move the centre of an octahedron.
template <typename Id>
SolidRows<Id> GetSolidRows(const TetOctLevel<Id>& level)
{
  return { &TetOctMasks(level.Strata.Weights), level.OctVertices.size() / 6,
    level.OctVertices.data(), level.NumberOfControlVertices, level.TetsAtSpokes->data() };
}
template <typename Id>
void TakeSolidRows(TetOctLevel<Id>& level, Stencils<Id>& stencils)
{
  stencils.Masks = &TetOctMasks(level.Strata.Weights);
  stencils.CentreVertices = std::move(level.OctVertices);
  stencils.NumberOfCounted = level.NumberOfControlVertices;
  stencils.Counts = level.TetsAtSpokes;
}

template <typename IdType>
class TetOctRings;

/// As Refiner.h needs it.
template <typename IdType>
struct TetOctSplit
{
  using Id = IdType;
  using Level = TetOctLevel<Id>;
  using Shapes = TetShape::Shapes;
  using SolidRings = TetOctRings<Id>;

  static std::array<Id, 2> CountSolids(const Level& level)
  {
    return { level.Complex.NumberOfTets, level.NumberOfOctahedra };
  }
  static SolidList<Id> GetSolids(const Level& level, TetShape) { return GetTets(level.Complex); }
  static SolidList<Id> GetSolids(const Level& level, OctShape)
  {
    return { level.OctVertices.data(), level.OctEdges.data(), level.OctFaces.data(),
      &level.EqualOcts };
  }
  static SolidStorage<Id> GetStorage(Level& level, TetShape)
  {
    auto& complex = level.Complex;
    return { complex.NumberOfTets, complex.TetVertices, complex.TetEdges, complex.TetFaces,
      complex.EqualTets };
  }
  static SolidStorage<Id> GetStorage(Level& level, OctShape)
  {
    return { level.NumberOfOctahedra, level.OctVertices, level.OctEdges, level.OctFaces,
      level.EqualOcts };
  }
  static void Continue(const Level& parent, Level& child)
  {
    child.TetsAtSpokes = parent.TetsAtSpokes;
    child.NumberOfControlVertices = parent.NumberOfControlVertices;
    child.Steps = parent.Steps + 1;
  }
};

/// The members that rings have inside tetrahedra and octahedra (RingEmitter.h).
template <typename IdType>
class TetOctRings
{
public:
  using Id = IdType;
  static constexpr Id MostPerCell = 3;

  explicit TetOctRings(const TetOctLevel<Id>& parent)
    : Level(parent)
    , Parent(parent.Complex)
    , Strata(parent.Strata)
    , Ids(parent)
  {
  }
  vtkIdType CountFaces(Rule rule, vtkIdType ringSize) const
  {
    return rule == Rule::RegularEdge ? RegularFaces : ringSize;
  }
  vtkIdType CountSolids(Id vertex, Rule rule, vtkIdType ringSize) const
  {
    return CountOpposites(rule, ringSize, vertex < this->Level.NumberOfControlVertices);
  }

  Stratum GetMidpointStratum(Stratum edge) const { return edge; }
  Stratum GetInFaceStratum(Id face, int) const
  {
    const Stratum stratum = this->Strata.Faces[face];
    return stratum.GetRule() == Rule::Solid ? Stratum(Rule::RegularEdge) : stratum;
  }

  Id CountMidpoint(Rule rule) const { return rule == Rule::RegularEdge ? RegularVertexRing : 0; }
  void CountInFace(Id face, Id sizes[3]) const
  {
    std::fill_n(sizes, 3, this->CountInFaceAtMost(face));
  }
  /// The exact size.
  Id CountInFaceAtMost(Id face) const
  {
    const Rule rule = this->Strata.Faces[face].GetRule();
    return rule == Rule::Solid ? RegularEdgeRing
      : rule == Rule::Surface  ? 2
      : rule == Rule::Curve    ? 0
                               : 2 + static_cast<Id>(this->Parent.FaceTets[face].size());
  }

  /// The centre of an octahedron stands for the vertex opposite in it.
  template <typename Emit>
  void EmitOpposite(Id oct, Id vertex, Emit& emit) const
  {
    emit(this->OctOfOct(oct, VertexInOct(this->Level, oct, vertex)), this->Centre(oct));
  }
  /// The two opposites of a half's ends in the child octahedron there, the first of which is the
  /// centre.
  template <typename Emit>
  void EmitHalves(Id oct, const Id (&ends)[2], Emit (&halves)[2]) const
  {
    const int corners[2] = { VertexInOct(this->Level, oct, ends[0]),
      VertexInOct(this->Level, oct, ends[1]) };
    for (int half = 0; half < 2; ++half)
    {
      const Id child = this->OctOfOct(oct, corners[half]);
      halves[half](child, this->Centre(oct));
      halves[half](
        child, this->OctMidpoint(oct, corners[half], octahedron::Opposite(corners[1 - half])));
    }
  }
  template <typename Emit>
  void EmitBeside(Id, Id, Emit&) const
  {
  }
  /// The centre of each octahedron, then the opposites of the midpoint in the child octahedra
  /// around it.
  template <typename Emit>
  void EmitAround(Id edge, Rule rule, Row<Id> faces, Emit& midpoint) const;
  /// One point in each cell at the face, then the opposites in the child octahedra there.
  template <typename Rings>
  void EmitInFace(Id face, Rule rule, Rings& rings) const;

  static constexpr Id CountInner(TetShape) { return 0; }
  static constexpr Id CountInner(OctShape) { return RegularEdgeRing; }
  static constexpr Id CountCentre(TetShape) { return 0; }
  static constexpr Id CountCentre(OctShape) { return RegularVertexRing; }
  /// A spoke.
  template <typename Emit>
  void EmitInner(OctShape, Id oct, int edge, Emit& emit) const;
  template <typename Emit>
  void EmitCentre(OctShape, Id oct, Emit& emit) const;

private:
  template <typename Rings>
  using MakeEmit = decltype(std::declval<Rings&>().Open(0, Id(0)));

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

  template <typename Act>
  void ForCellsAround(Id edge, Row<Id> faces, const Act& act) const;
  FaceSide GetSide(Id face, Id cell) const;
  template <typename Emit>
  void EmitNear(const FaceSide& side, Emit (&corners)[3]) const;
  template <typename Emit>
  void EmitFar(const FaceSide& side, Emit (&corners)[3]) const;

  // Ids of the simplices that a step makes.
  Id Centre(Id oct) const { return this->Ids.template Centre<OctShape>(oct); }
  Id Spoke(Id oct, int edge) const { return this->Ids.template InnerEdge<OctShape>(oct, edge); }
  Id Cut(Id tet, int vertex) const { return this->Ids.template InnerFace<TetShape>(tet, vertex); }
  Id Fan(Id oct, int face, int corner) const
  {
    return this->Ids.template InnerFace<OctShape>(oct, 3 * face + corner);
  }
  Id OctOfTet(Id tet) const { return this->Ids.template ChildOf<TetShape, OctShape>(tet, 0); }
  Id OctOfOct(Id oct, int vertex) const
  {
    return this->Ids.template ChildOf<OctShape, OctShape>(oct, vertex);
  }
  Id OctMidpoint(Id oct, int a, int b) const
  {
    return this->Ids.Midpoint(this->Level.OctEdges[12 * vtkIdType(oct) + octahedron::EdgeOf[a][b]]);
  }

  const TetOctLevel<Id>& Level;
  const SimplicialComplex<Id>& Parent;
  const subdivision::Strata<Id>& Strata;
  const ChildIds<TetOctSplit<Id>> Ids;
};

/// act(cell) for each solid at an edge of dimension 3 or a blended one.
template <typename Id>
template <typename Act>
void TetOctRings<Id>::ForCellsAround(Id edge, Row<Id> faces, const Act& act) const
{
  const auto& parent = this->Parent;
  for (Id face : faces)
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

/// Emits the members of the ring of an edge's midpoint that lie inside the solids at the edge.
template <typename Id>
template <typename Emit>
void TetOctRings<Id>::EmitAround(Id edge, Rule rule, Row<Id> faces, Emit& midpoint) const
{
  auto emitCentre = [&](const CellAtEdge& at)
  {
    if (!at.IsTet)
    {
      midpoint(this->Spoke(at.Cell, at.Local), this->Centre(at.Cell));
    }
  };
  auto emitOpposites = [&](const CellAtEdge& at)
  {
    if (at.IsTet)
    {
      midpoint(this->OctOfTet(at.Cell),
        this->Ids.Midpoint(
          this->Parent.TetEdges[6 * vtkIdType(at.Cell) + tetrahedron::OppositeEdge(at.Local)]));
      return;
    }
    const int* corners = octahedron::EdgeVertices[at.Local];
    for (int i = 0; i < 2; ++i)
    {
      midpoint(this->OctOfOct(at.Cell, corners[i]),
        this->OctMidpoint(at.Cell, corners[i], octahedron::Opposite(corners[1 - i])));
    }
  };
  if (rule == Rule::RegularEdge) // most edges by far: two cells of each kind, looked up once
  {
    CellAtEdge cells[RegularFaces];
    int size = 0;
    this->ForCellsAround(edge, faces, [&](const CellAtEdge& at) { cells[size++] = at; });
    std::for_each(cells, cells + size, emitCentre);
    std::for_each(cells, cells + size, emitOpposites);
    return;
  }
  this->ForCellsAround(edge, faces, emitCentre);
  if (rule != Rule::Blend)
  {
    this->ForCellsAround(edge, faces, emitOpposites);
  }
}

/// Where a face is in a cell at it.
template <typename Id>
typename TetOctRings<Id>::FaceSide TetOctRings<Id>::GetSide(Id face, Id cell) const
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
void TetOctRings<Id>::EmitNear(const FaceSide& side, Emit (&corners)[3]) const
{
  const Id* edges = this->Parent.TetEdges.data() + 6 * vtkIdType(side.Cell);
  for (int corner = 0; corner < 3; ++corner)
  {
    const int a = side.Corners[corner];
    if (side.IsTet)
    {
      corners[corner](
        this->Cut(side.Cell, a), this->Ids.Midpoint(edges[tetrahedron::EdgeOf[a][side.Face]]));
    }
    else
    {
      corners[corner](this->Fan(side.Cell, side.Face, octahedron::CornerOf(side.Face, a)),
        this->Centre(side.Cell));
    }
  }
}

/// Emits, for each of the three edges inside a face, the opposites of its ends in the child
/// octahedron of a cell.
template <typename Id>
template <typename Emit>
void TetOctRings<Id>::EmitFar(const FaceSide& side, Emit (&corners)[3]) const
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
        corners[corner](this->OctOfTet(side.Cell),
          this->Ids.Midpoint(edges[tetrahedron::EdgeOf[others[1 - i]][side.Face]]));
      }
      else
      {
        corners[corner](this->OctOfOct(side.Cell, a),
          this->OctMidpoint(side.Cell, a, octahedron::Opposite(others[i])));
      }
    }
  }
}

template <typename Id>
template <typename Rings>
void TetOctRings<Id>::EmitInFace(Id face, Rule rule, Rings& rings) const
{
  const Id size = this->CountInFaceAtMost(face);
  MakeEmit<Rings> corners[3] = { rings.Open(0, size), rings.Open(1, size), rings.Open(2, size) };
  for (int corner = 0; corner < 3 && rule != Rule::Curve; ++corner)
  {
    EmitOnFace(this->Parent, this->Ids, face, corner, corners[corner]);
  }
  const Row<Id> cells = this->Parent.FaceTets[face];
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
  for (int corner = 0; corner < 3; ++corner)
  {
    rings.Close(corner, corners[corner]);
  }
}

template <typename Id>
template <typename Emit>
void TetOctRings<Id>::EmitInner(OctShape, Id oct, int edge, Emit& emit) const
{
  const int* ends = octahedron::EdgeVertices[edge];
  const int third = octahedron::ThirdPair(ends[0], ends[1]);
  for (int r = third; r < third + 2; ++r)
  {
    const int face = octahedron::FaceOf(ends[0], ends[1], r);
    for (int i = 0; i < 2; ++i)
    {
      emit(this->Fan(oct, face, octahedron::CornerOf(face, ends[i])),
        this->OctMidpoint(oct, ends[i], r));
    }
  }
  for (int i = 0; i < 2; ++i)
  {
    const int a = ends[i];
    const Id child = this->OctOfOct(oct, a);
    emit(child, this->Level.OctVertices[6 * vtkIdType(oct) + a]);
    emit(child, this->OctMidpoint(oct, a, octahedron::Opposite(ends[1 - i])));
  }
}

template <typename Id>
template <typename Emit>
void TetOctRings<Id>::EmitCentre(OctShape, Id oct, Emit& emit) const
{
  for (int e = 0; e < 12; ++e)
  {
    emit(this->Spoke(oct, e), this->Ids.Midpoint(this->Level.OctEdges[12 * vtkIdType(oct) + e]));
  }
  for (int v = 0; v < 6; ++v)
  {
    emit(this->OctOfOct(oct, v), this->Level.OctVertices[6 * vtkIdType(oct) + v]);
  }
}

}

#endif
