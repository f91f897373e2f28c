// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/BoxSpline/ChildRows.h"

#include "Core/Solids/BoxSpline/BoxSplineSplit.h"
#include "Core/Solids/BoxSpline/RingBlock.h"

namespace subdivision
{
namespace
{

/// Makes the rows of ChildRows: those at vertices, at edges, in faces and in tetrahedra of the
/// given level.
template <typename Id>
class ChildRowsMaker
{
public:
  ChildRowsMaker(const Level<Id>& level, const typename RingOperator<Id>::RingsUser& use)
    : Complex(level.Complex)
    , Strata(level.Strata)
    , Emitter(level)
    , Ids(level)
    , FirstEdgeRow(vtkIdType(level.Complex.NumberOfVertices) + level.Complex.NumberOfEdges)
    , Use(use)
  {
  }
  void Run() const
  {
    ForKinds<4>({ this->Complex.NumberOfVertices, this->Complex.NumberOfEdges,
                  this->Complex.NumberOfFaces, this->Complex.NumberOfTets },
      [this](std::size_t dimension, vtkIdType begin, vtkIdType end)
      {
        switch (dimension)
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
          default:
            this->OfDiagonals(begin, end);
            break;
        }
      });
  }

private:
  void AtVertices(vtkIdType first, vtkIdType last) const
  {
    RingBlock<Id> rows(BoxSplineMasks(), false, BlockSize);
    ForBlocks(first, last,
      [&](vtkIdType begin, vtkIdType end)
      {
        rows.Start(begin);
        for (vtkIdType v = begin; v < end; ++v)
        {
          rows.Reserve(static_cast<Id>(this->Strata.VertexRings.GetSize(v)));
          auto ring = rows.Open();
          this->Emitter.EmitVertex(static_cast<Id>(v), ring);
          rows.Close(ring, this->Strata.Vertices[v]);
        }
        this->Use(rows.Get());
      });
  }

  /// Both halves of each edge, and its midpoint.
  void AtEdges(vtkIdType first, vtkIdType last) const
  {
    RingBlock<Id> edges(BoxSplineMasks(), true, 2 * BlockSize);
    RingBlock<Id> vertices(BoxSplineMasks(), false, BlockSize);
    ForBlocks(first, last,
      [&](vtkIdType begin, vtkIdType end)
      {
        edges.Start(this->FirstEdgeRow + 2 * begin);
        vertices.Start(this->Complex.NumberOfVertices + begin);
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
    RingBlock<Id> rows(BoxSplineMasks(), true, 3 * BlockSize);
    ForBlocks(first, last,
      [&](vtkIdType begin, vtkIdType end)
      {
        rows.Start(this->FirstEdgeRow + this->Ids.InFace(static_cast<Id>(begin), 0));
        for (vtkIdType i = begin; i < end; ++i)
        {
          const Id f = static_cast<Id>(i);
          rows.Reserve(3 * this->Emitter.CountInFaceAtMost(f));
          InFaceRows<BoxSplineSplit<Id>> rings(this->Emitter, f, rows);
          this->Emitter.EmitInFace(f, rings);
        }
        this->Use(rows.Get());
      });
  }

  void OfDiagonals(vtkIdType first, vtkIdType last) const
  {
    RingBlock<Id> rows(BoxSplineMasks(), true, BlockSize);
    ForBlocks(first, last,
      [&](vtkIdType begin, vtkIdType end)
      {
        rows.Start(this->FirstEdgeRow +
          this->Ids.template InnerEdge<MarkedTetShape>(static_cast<Id>(begin), 0));
        for (vtkIdType i = begin; i < end; ++i)
        {
          const Id t = static_cast<Id>(i);
          rows.Reserve(4);
          auto ring = rows.Open();
          this->Emitter.template EmitInner<MarkedTetShape>(t, 0, ring);
          this->Emitter.template GetInnerEnds<MarkedTetShape>(t, 0, rows.GetEnds());
          rows.Close(ring, Stratum(Rule::RegularEdge));
        }
        this->Use(rows.Get());
      });
  }

  const SimplicialComplex<Id>& Complex;
  const subdivision::Strata<Id>& Strata;
  const RingEmitter<BoxSplineSplit<Id>> Emitter;
  const ChildIds<BoxSplineSplit<Id>> Ids;
  const vtkIdType FirstEdgeRow;
  const typename RingOperator<Id>::RingsUser& Use;
};

}

template <typename Id>
vtkIdType LevelRows<Id>::GetNumberOfColumns() const
{
  return this->Level.Complex.NumberOfVertices;
}

template <typename Id>
vtkIdType LevelRows<Id>::GetNumberOfRows() const
{
  return vtkIdType(this->Level.Complex.NumberOfVertices) + this->Level.Complex.NumberOfEdges;
}

template <typename Id>
void LevelRows<Id>::ForRows(const typename RingOperator<Id>::RingsUser& use) const
{
  const auto& strata = this->Level.Strata;
  ForStoredRows<Id>({ strata.Vertices, strata.Edges, this->Level.Complex.EdgeVertices,
                      strata.VertexRings, strata.EdgeRings },
    use);
}

template <typename Id>
vtkIdType ChildRows<Id>::GetNumberOfVertices() const
{
  return LevelRows<Id>(this->Level).GetNumberOfRows();
}

template <typename Id>
vtkIdType ChildRows<Id>::GetNumberOfEdges() const
{
  const auto& complex = this->Level.Complex;
  return 2 * vtkIdType(complex.NumberOfEdges) + 3 * vtkIdType(complex.NumberOfFaces) +
    complex.NumberOfTets;
}

template <typename Id>
void ChildRows<Id>::ForRows(const typename RingOperator<Id>::RingsUser& use) const
{
  ChildRowsMaker<Id>(this->Level, use).Run();
}

template class LevelRows<int>;
template class LevelRows<long long>;
template class ChildRows<int>;
template class ChildRows<long long>;

}
