// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BoxSplineSplit.h
 * How the box-spline scheme splits solids (Mathematics 2): eight children of each tetrahedron. With
 * the diagonal and eight inner faces in each of T tetrahedra the next level has
 *  - edges: 2E + 3F + t the diagonal of tetrahedron t;
 *  - faces: 4F + 8t + i inside tetrahedron t (tetrahedron::InteriorFaces);
 *  - tetrahedra: 8t + i (tetrahedron::Children).
 */
#ifndef SubdivisionObjects_BoxSplineSplit_h
#define SubdivisionObjects_BoxSplineSplit_h

#include "Core/Solids/Scheme/Level.h"
#include "Core/Solids/Scheme/RingEmitter.h"
#include "Core/Solids/Scheme/Stencils.h"

namespace subdivision
{

/// A tetrahedron with two marked edges, whose midpoints the diagonal joins (SolidShapes.h).
struct MarkedTetShape : TetrahedronShape
{
  using Shapes = ShapeList<MarkedTetShape>;
  static constexpr int Index = 0;

  static constexpr auto GetChildren(MarkedTetShape)
  {
    std::array<std::array<int, 4>, 8> children{};
    for (int c = 0; c < 8; ++c)
    {
      for (int k = 0; k < 4; ++k)
      {
        children[c][k] = tetrahedron::Children[c][k];
      }
    }
    return children;
  }
  static constexpr auto GetInnerEdges()
  {
    std::array<std::array<int, 2>, 1> edges{};
    edges[0][0] = 4 + tetrahedron::MarkedEdges[0];
    edges[0][1] = 4 + tetrahedron::MarkedEdges[1];
    return edges;
  }
  static constexpr auto GetInnerFaces()
  {
    std::array<std::array<int, 3>, 8> faces{};
    for (int f = 0; f < 8; ++f)
    {
      for (int i = 0; i < 3; ++i)
      {
        faces[f][i] = 4 + tetrahedron::InteriorFaces[f].Edges[i];
      }
    }
    return faces;
  }
};

/// The masks of this scheme (Masks.h).
const RingMasks& BoxSplineMasks(LoopWeights weights);

/// As Stencils.h needs them.
template <typename Id>
SolidRows<Id> GetSolidRows(const Level<Id>& level)
{
  return { &BoxSplineMasks(level.Strata.Weights) };
}
template <typename Id>
void TakeSolidRows(Level<Id>& level, Stencils<Id>& stencils)
{
  stencils.Masks = &BoxSplineMasks(level.Strata.Weights);
}

template <typename IdType>
class BoxSplineRings;

/// As Refiner.h needs it.
template <typename IdType>
struct BoxSplineSplit
{
  using Id = IdType;
  using Level = subdivision::Level<Id>;
  using Shapes = MarkedTetShape::Shapes;
  using SolidRings = BoxSplineRings<Id>;

  static std::array<Id, 1> CountSolids(const Level& level)
  {
    return { level.Complex.NumberOfTets };
  }
  static SolidList<Id> GetSolids(const Level& level, MarkedTetShape)
  {
    return GetTets(level.Complex);
  }
  static SolidStorage<Id> GetStorage(Level& level, MarkedTetShape)
  {
    auto& complex = level.Complex;
    return { complex.NumberOfTets, complex.TetVertices, complex.TetEdges, complex.TetFaces,
      complex.EqualTets };
  }
  static void Continue(const Level&, Level&) {}
};

/// The members that rings have inside tetrahedra (RingEmitter.h).
template <typename IdType>
class BoxSplineRings
{
public:
  using Id = IdType;
  static constexpr Id MostPerCell = 1;

  explicit BoxSplineRings(const Level<Id>& parent)
    : Parent(parent.Complex)
    , Strata(parent.Strata)
    , Ids(parent)
  {
  }
  vtkIdType CountFaces(Rule, vtkIdType ringSize) const { return ringSize; }
  vtkIdType CountSolids(Id, Rule, vtkIdType) const { return 0; }

  Stratum GetMidpointStratum(Stratum edge) const
  {
    return edge.GetRule() == Rule::RegularEdge ? Stratum(Rule::Solid, edge.GetType()) : edge;
  }
  Stratum GetInFaceStratum(Id face, int corner) const;

  Id CountMidpoint(Rule) const { return 0; }
  void CountInFace(Id face, Id sizes[3]) const
  {
    Counter rings{ sizes };
    this->EmitInFace(face, this->Strata.Faces[face].GetRule(), rings);
  }
  Id CountInFaceAtMost(Id face) const
  {
    return 2 + 2 * static_cast<Id>(this->Parent.FaceTets[face].size());
  }

  template <typename Emit>
  void EmitOpposite(Id, Id, Emit&) const
  {
  }
  template <typename Emit>
  void EmitHalves(Id, const Id (&)[2], Emit (&)[2]) const
  {
  }
  /// The other end of each diagonal that ends at the midpoint.
  template <typename Emit>
  void EmitBeside(Id edge, Id face, Emit& midpoint) const;
  template <typename Emit>
  void EmitAround(Id, Rule, Row<Id>, Emit&) const
  {
  }
  /// One or two midpoints in each tetrahedron at the face (FaceCutLinks).
  template <typename Rings>
  void EmitInFace(Id face, Rule rule, Rings& rings) const;

  static constexpr Id CountInner(MarkedTetShape) { return 4; }
  static constexpr Id CountCentre(MarkedTetShape) { return 0; }
  /// The diagonal: the equator around it.
  template <typename Emit>
  void EmitInner(MarkedTetShape, Id tet, int, Emit& emit) const
  {
    for (int q = 0; q < 4; ++q)
    {
      emit(this->GetInnerFace(tet, 4 + q),
        this->Ids.Midpoint(
          this->Parent.TetEdges[6 * vtkIdType(tet) + tetrahedron::EquatorEdges[q]]));
    }
  }

private:
  /// Counts the members that EmitInFace emits.
  struct Counter
  {
    Id* Sizes;
    RingCounter<Id> Open(int, Id) const { return {}; }
    void Close(int corner, const RingCounter<Id>& ring) const { this->Sizes[corner] = ring.Size; }
  };
  /// The local number of an edge that a tetrahedron marks; negative: it does not.
  int FindMarked(Id tet, Id edge) const
  {
    const Id* edges = this->Parent.TetEdges.data() + 6 * vtkIdType(tet);
    const auto& marked = tetrahedron::MarkedEdges;
    return edge == edges[marked[0]] ? marked[0] : edge == edges[marked[1]] ? marked[1] : -1;
  }
  Id GetInnerFace(Id tet, int face) const
  {
    return this->Ids.template InnerFace<MarkedTetShape>(tet, face);
  }

  const SimplicialComplex<Id>& Parent;
  const subdivision::Strata<Id>& Strata;
  const ChildIds<BoxSplineSplit<Id>> Ids;
};

template <typename Id>
template <typename Emit>
void BoxSplineRings<Id>::EmitBeside(Id edge, Id face, Emit& midpoint) const
{
  for (Id tet : this->Parent.FaceTets[face])
  {
    const int local = this->FindMarked(tet, edge);
    const int opposite = tetrahedron::OppositeEdge(local);
    // Two faces of the tetrahedron lie at the edge; only the first of them counts it.
    if (local >= 0 &&
      this->Parent.TetFaces[4 * vtkIdType(tet) + tetrahedron::EdgeVertices[opposite][0]] == face)
    {
      midpoint(this->Ids.template InnerEdge<MarkedTetShape>(tet, 0),
        this->Ids.Midpoint(this->Parent.TetEdges[6 * vtkIdType(tet) + opposite]));
    }
  }
}

template <typename Id>
template <typename Rings>
void BoxSplineRings<Id>::EmitInFace(Id face, Rule rule, Rings& rings) const
{
  const auto& parent = this->Parent;
  for (int corner = 0; corner < 3; ++corner)
  {
    auto emit = rings.Open(corner, this->CountInFaceAtMost(face));
    if (rule != Rule::Curve)
    {
      EmitOnFace(parent, this->Ids, face, corner, emit);
    }
    const Id vertex = parent.FaceVertices[3 * vtkIdType(face) + corner];
    for (Id tet : rule == Rule::Surface || rule == Rule::Curve ? Row<Id>() : parent.FaceTets[face])
    {
      const int local = parent.VertexInTet(tet, vertex);
      const Id* edges = parent.TetEdges.data() + 6 * vtkIdType(tet);
      const tetrahedron::FaceCutLink& link =
        tetrahedron::FaceCutLinks[local][parent.FaceInTet(tet, face)];
      emit(this->GetInnerFace(tet, local), this->Ids.Midpoint(edges[link.CutEdge]));
      if (link.HasDiagonal)
      {
        emit(
          this->GetInnerFace(tet, link.DiagonalFace), this->Ids.Midpoint(edges[link.DiagonalEdge]));
      }
    }
    rings.Close(corner, emit);
  }
}

/// Inside a face between two tetrahedra an edge is regular where both mark the edge it is parallel
/// to: then it lies on the equator of both octahedra.
template <typename Id>
Stratum BoxSplineRings<Id>::GetInFaceStratum(Id face, int corner) const
{
  const Stratum stratum = this->Strata.Faces[face];
  if (stratum.GetRule() != Rule::Solid)
  {
    return stratum;
  }
  const Id parallel = this->Parent.FaceEdges[3 * vtkIdType(face) + triangle::EdgeOpposite[corner]];
  for (Id tet : this->Parent.FaceTets[face])
  {
    if (this->FindMarked(tet, parallel) < 0)
    {
      return stratum;
    }
  }
  return Stratum(Rule::RegularEdge);
}

}

#endif
