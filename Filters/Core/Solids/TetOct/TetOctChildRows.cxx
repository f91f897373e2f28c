// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/TetOct/TetOctChildRows.h"

#include "Core/Solids/BoxSpline/RingBlock.h"
#include "Core/Solids/TetOct/TetOctSplit.h"

namespace subdivision
{
namespace
{

/// Makes the rows of TetOctChildRows: those at vertices, at edges, in faces, tetrahedra and
/// octahedra of the given level.
template <typename Id>
class TetOctRowsMaker
{
public:
  TetOctRowsMaker(const TetOctLevel<Id>& level, vtkIdType vertices, vtkIdType edges,
    const typename RingOperator<Id>::RingsUser& use)
    : Level(level)
    , Complex(level.Complex)
    , Strata(level.Strata)
    , Emitter(level)
    , Ids(level)
    , FirstEdgeRow(vertices)
    , FirstCentreRow(vertices + edges)
    , Use(use)
  {
  }
  void Run() const
  {
    ForKinds<5>(
      { this->Complex.NumberOfVertices, this->Complex.NumberOfEdges, this->Complex.NumberOfFaces,
        this->Complex.NumberOfTets, this->Level.NumberOfOctahedra },
      [this](std::size_t kind, vtkIdType begin, vtkIdType end)
      {
        switch (kind)
        {
          case 0:
            this->AtVertices(begin, end);
            break;
          case 1:
            this->AtEdges(begin, end);
            break;
          case 2:
            this->InFaces(begin, end);
            break;
          case 3:
            this->InTets(begin, end);
            break;
          default:
            this->InOctahedra(begin, end);
            break;
        }
      });
  }

private:
  void AtVertices(vtkIdType first, vtkIdType last) const
  {
    const Rings<Id>& rings = this->Strata.VertexRings;
    const vtkIdType control = this->Level.NumberOfControlVertices;
    RingBlock<Id> rows(TetOctMasks(), false, BlockSize);
    ForBlocks(first, last,
      [&](vtkIdType begin, vtkIdType end)
      {
        rows.Start(begin);
        for (vtkIdType v = begin; v < end; ++v)
        {
          rows.Reserve(static_cast<Id>(rings.GetSize(v)));
          auto ring = rows.Open();
          this->Emitter.EmitVertex(static_cast<Id>(v), ring);
          rows.Close(ring, this->Strata.Vertices[v]);
        }
        // Rings of control vertices keep their sizes and come first, so that offsets into
        // TetsAtSpokes are the same on all levels.
        const Id* tets =
          begin < control ? this->Level.TetsAtSpokes->data() + rings.Offsets[begin] : nullptr;
        RingRows<Id> block = rows.Get();
        block.NumberOfCounted = control - begin;
        block.Counts = tets;
        this->Use(block);
      });
  }

  /// Both halves of each edge, and its midpoint.
  void AtEdges(vtkIdType first, vtkIdType last) const
  {
    RingBlock<Id> edges(TetOctMasks(), true, 2 * BlockSize);
    RingBlock<Id> vertices(TetOctMasks(), false, BlockSize);
    ForBlocks(first, last,
      [&](vtkIdType begin, vtkIdType end)
      {
        edges.Start(this->FirstEdgeRow + 2 * begin);
        vertices.Start(this->Ids.Midpoint(static_cast<Id>(begin)));
        for (vtkIdType i = begin; i < end; ++i)
        {
          const Id e = static_cast<Id>(i);
          const Id size = this->Emitter.CountHalf(e);
          edges.Reserve(2 * size);
          vertices.Reserve(this->Emitter.CountMidpointAtMost(e));
          MemberWriter<Id> halves[2] = { edges.Open(), edges.Open(size) };
          auto midpoint = vertices.Open();
          this->Emitter.EmitAtEdge(e, halves, midpoint);
          vertices.Close(midpoint, this->Emitter.MidpointStratum(e));
          for (int half = 0; half < 2; ++half)
          {
            this->Emitter.GetHalfEnds(e, half, edges.GetEnds());
            edges.Close(halves[half], this->Strata.Edges[e]);
          }
        }
        this->Use(edges.Get());
        this->Use(vertices.Get());
      });
  }

  void InFaces(vtkIdType first, vtkIdType last) const
  {
    RingBlock<Id> rows(TetOctMasks(), true, 3 * BlockSize);
    ForBlocks(first, last,
      [&](vtkIdType begin, vtkIdType end)
      {
        rows.Start(this->FirstEdgeRow + this->Ids.InFace(static_cast<Id>(begin), 0));
        for (vtkIdType i = begin; i < end; ++i)
        {
          const Id f = static_cast<Id>(i);
          rows.Reserve(3 * this->Emitter.CountInFaceAtMost(f));
          InFaceRows<TetOctSplit<Id>> rings(this->Emitter, f, rows);
          this->Emitter.EmitInFace(f, rings);
        }
        this->Use(rows.Get());
      });
  }

  /// The rows of the centres of those child octahedra that lie in the middle of tetrahedra.
  void InTets(vtkIdType first, vtkIdType last) const
  {
    Buffer<Id> octs(6 * BlockSize);
    ForBlocks(first, last,
      [&](vtkIdType begin, vtkIdType end)
      {
        Id* vertex = octs.data();
        for (vtkIdType t = begin; t < end; ++t)
        {
          const SolidLattice<TetShape, Id> lattice(
            GetTets(this->Complex), this->Ids, static_cast<Id>(t));
          for (int point : Children<TetShape, OctShape>.Points[0])
          {
            *vertex++ = lattice.Points[point];
          }
        }
        this->UseCentres(this->Ids.template ChildOf<TetShape, OctShape>(static_cast<Id>(begin), 0),
          end - begin, octs.data());
      });
  }

  /// The rows of the spokes and the centre of each octahedron, and of the centres of the child
  /// octahedra at its vertices.
  void InOctahedra(vtkIdType first, vtkIdType last) const
  {
    constexpr vtkIdType blockSize = BlockSize / 8; // each has many rows
    RingBlock<Id> spokes(TetOctMasks(), true, 12 * blockSize);
    RingBlock<Id> vertices(TetOctMasks(), false, blockSize);
    Buffer<Id> octs(36 * blockSize);
    ForBlocks(
      first, last,
      [&](vtkIdType begin, vtkIdType end)
      {
        const Id firstOct = static_cast<Id>(begin);
        spokes.Start(this->FirstEdgeRow + this->Ids.template InnerEdge<OctShape>(firstOct, 0));
        vertices.Start(this->Ids.template Centre<OctShape>(firstOct));
        Id* vertex = octs.data();
        for (vtkIdType i = begin; i < end; ++i)
        {
          const Id o = static_cast<Id>(i);
          spokes.Reserve(12 * RegularEdgeRing);
          for (int e = 0; e < 12; ++e)
          {
            auto spoke = spokes.Open();
            this->Emitter.template EmitInner<OctShape>(o, e, spoke);
            this->Emitter.template GetInnerEnds<OctShape>(o, e, spokes.GetEnds());
            spokes.Close(spoke, Stratum(Rule::RegularEdge));
          }
          vertices.Reserve(RegularVertexRing);
          auto centre = vertices.Open();
          this->Emitter.template EmitCentre<OctShape>(o, centre);
          vertices.Close(centre, Stratum(Rule::RegularEdge));
          const SolidLattice<OctShape, Id> lattice(
            TetOctSplit<Id>::GetSolids(this->Level, OctShape()), this->Ids, o);
          for (const auto& child : Children<OctShape, OctShape>.Points)
          {
            for (int point : child)
            {
              *vertex++ = lattice.Points[point];
            }
          }
        }
        this->Use(spokes.Get());
        this->Use(vertices.Get());
        this->UseCentres(this->Ids.template ChildOf<OctShape, OctShape>(firstOct, 0),
          6 * (end - begin), octs.data());
      },
      blockSize);
  }

  void UseCentres(vtkIdType first, vtkIdType count, const Id* octs) const
  {
    this->Use({ &TetOctMasks(), false, this->FirstCentreRow + first, count, nullptr, nullptr,
      nullptr, octs, true });
  }

  const TetOctLevel<Id>& Level;
  const SimplicialComplex<Id>& Complex;
  const subdivision::Strata<Id>& Strata;
  const RingEmitter<TetOctSplit<Id>> Emitter;
  const ChildIds<TetOctSplit<Id>> Ids;
  const vtkIdType FirstEdgeRow;
  const vtkIdType FirstCentreRow;
  const typename RingOperator<Id>::RingsUser& Use;
};

}

template <typename Id>
TetOctLevelRows<Id>::TetOctLevelRows(const TetOctLevel<Id>& level)
  : Stored{ level.Strata.Vertices, level.Strata.Edges, level.Complex.EdgeVertices,
    level.OctVertices, level.Strata.VertexRings, level.Strata.EdgeRings, *level.TetsAtSpokes,
    level.NumberOfControlVertices }
{
}

template <typename Id>
void TetOctLevelRows<Id>::ForRows(const typename RingOperator<Id>::RingsUser& use) const
{
  this->Stored.ForRows(use);
}

template <typename Id>
vtkIdType TetOctChildRows<Id>::GetNumberOfVertices() const
{
  return TetOctLevelRows<Id>(this->Level).GetNumberOfRows();
}

template <typename Id>
vtkIdType TetOctChildRows<Id>::GetNumberOfEdges() const
{
  const auto& complex = this->Level.Complex;
  return 2 * vtkIdType(complex.NumberOfEdges) + 3 * vtkIdType(complex.NumberOfFaces) +
    12 * vtkIdType(this->Level.NumberOfOctahedra);
}

template <typename Id>
vtkIdType TetOctChildRows<Id>::GetNumberOfRows() const
{
  return this->GetNumberOfVertices() + this->GetNumberOfEdges() + this->Level.Complex.NumberOfTets +
    6 * vtkIdType(this->Level.NumberOfOctahedra);
}

template <typename Id>
void TetOctChildRows<Id>::ForRows(const typename RingOperator<Id>::RingsUser& use) const
{
  TetOctRowsMaker<Id>(this->Level, this->GetNumberOfVertices(), this->GetNumberOfEdges(), use)
    .Run();
}

template class TetOctLevelRows<int>;
template class TetOctLevelRows<long long>;
template class TetOctChildRows<int>;
template class TetOctChildRows<long long>;

}
