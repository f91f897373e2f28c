// SPDX-License-Identifier: BSD-3-Clause
#include "ChildRows.h"

#include "RingEmitter.h"

#include <algorithm>

namespace subdivision
{
namespace
{

/// Simplices whose rows are made together: their rings fit into a core's own cache.
constexpr vtkIdType BlockSize = 256;

/// Calls makeBlock() for each thread's range, and what it gives with blocks that cover [0, size).
template <typename MakeBlock>
void ForBlocks(vtkIdType size, const MakeBlock& makeBlock)
{
  ForRanges(size,
    [&](vtkIdType begin, vtkIdType end)
    {
      auto block = makeBlock();
      for (; begin < end; begin += BlockSize)
      {
        block(begin, std::min(begin + BlockSize, end));
      }
    });
}

/// Rows in the making, at most `capacity` at a time.
template <typename Id>
class RowBlock
{
public:
  RowBlock(bool ofEdges, vtkIdType capacity)
    : OfEdges(ofEdges)
    , Strata(capacity)
    , Ends(ofEdges ? 2 * capacity : 0)
    , Offsets(capacity + 1, Id(0))
  {
  }
  void Start(vtkIdType firstRow)
  {
    this->FirstRow = firstRow;
    this->Count = 0;
  }
  /// Makes sure that so many members have room in all rings that are still open.
  void Reserve(Id members)
  {
    const vtkIdType wanted = vtkIdType(this->Offsets[this->Count]) + members;
    if (this->Members.size() < wanted)
    {
      Buffer<Id> larger(2 * wanted);
      std::copy_n(this->Members.begin(), this->Offsets[this->Count], larger.begin());
      this->Members = std::move(larger);
    }
  }
  /// Where the next ring goes that follows on `before` members of open ones.
  MemberWriter<Id> Open(Id before = 0)
  {
    return { this->Members.data() + this->Offsets[this->Count] + before };
  }
  void Close(const MemberWriter<Id>& ring, Stratum stratum)
  {
    this->Strata[this->Count++] = stratum;
    this->Offsets[this->Count] = static_cast<Id>(ring.Members - this->Members.data());
  }
  /// The ends of the edge whose row is closed next.
  Id* GetEnds() { return this->Ends.data() + 2 * this->Count; }

  StencilRows<Id> Get() const
  {
    return { this->OfEdges, this->FirstRow, this->Count, this->Strata.data(), this->Ends.data(),
      this->Offsets.data(), this->Members.data() };
  }

private:
  const bool OfEdges;
  vtkIdType FirstRow = 0;
  vtkIdType Count = 0;
  Buffer<Stratum> Strata;
  Buffer<Id> Ends;
  Buffer<Id> Offsets;
  Buffer<Id> Members;
};

/// The rows of a level's children, one kind after another.
template <typename Id>
class ChildRowsMaker
{
public:
  ChildRowsMaker(const Level<Id>& level, const RowsUser<Id>& use)
    : Complex(level.Complex)
    , Strata(level.Strata)
    , Emitter(level)
    , Ids(level.Complex)
    , FirstEdgeRow(vtkIdType(level.Complex.NumberOfVertices) + level.Complex.NumberOfEdges)
    , Use(use)
  {
  }
  void Run() const
  {
    this->AtVertices();
    this->AtEdges();
    this->InFaces();
    this->OfDiagonals();
  }

private:
  void AtVertices() const
  {
    ForBlocks(this->Complex.NumberOfVertices,
      [&]()
      {
        return [this, rows = RowBlock<Id>(false, BlockSize)](vtkIdType begin, vtkIdType end) mutable
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
        };
      });
  }

  /// Both halves of each edge, and its midpoint.
  void AtEdges() const
  {
    ForBlocks(this->Complex.NumberOfEdges,
      [&]()
      {
        return [this, edges = RowBlock<Id>(true, 2 * BlockSize),
                 vertices = RowBlock<Id>(false, BlockSize)](vtkIdType begin, vtkIdType end) mutable
        {
          edges.Start(this->FirstEdgeRow + 2 * begin);
          vertices.Start(this->Complex.NumberOfVertices + begin);
          for (vtkIdType i = begin; i < end; ++i)
          {
            const Id e = static_cast<Id>(i);
            const Id size = this->Emitter.CountHalf(e);
            edges.Reserve(2 * size);
            vertices.Reserve(this->Emitter.CountAtMost(e));
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
        };
      });
  }

  void InFaces() const
  {
    ForBlocks(this->Complex.NumberOfFaces,
      [&]()
      {
        return
          [this, rows = RowBlock<Id>(true, 3 * BlockSize)](vtkIdType begin, vtkIdType end) mutable
        {
          rows.Start(this->FirstEdgeRow + this->Ids.InFace(static_cast<Id>(begin), 0));
          for (vtkIdType i = begin; i < end; ++i)
          {
            const Id f = static_cast<Id>(i);
            for (int corner = 0; corner < 3; ++corner)
            {
              rows.Reserve(2 + 2 * static_cast<Id>(this->Complex.FaceTets[f].size()));
              auto ring = rows.Open();
              this->Emitter.EmitInFace(f, corner, ring);
              this->Emitter.GetInFaceEnds(f, corner, rows.GetEnds());
              rows.Close(ring, this->Emitter.InFaceStratum(f, corner));
            }
          }
          this->Use(rows.Get());
        };
      });
  }

  void OfDiagonals() const
  {
    ForBlocks(this->Complex.NumberOfTets,
      [&]()
      {
        return [this, rows = RowBlock<Id>(true, BlockSize)](vtkIdType begin, vtkIdType end) mutable
        {
          rows.Start(this->FirstEdgeRow + this->Ids.Diagonal(static_cast<Id>(begin)));
          for (vtkIdType i = begin; i < end; ++i)
          {
            const Id t = static_cast<Id>(i);
            rows.Reserve(4);
            auto ring = rows.Open();
            this->Emitter.EmitDiagonal(t, ring);
            this->Emitter.GetDiagonalEnds(t, rows.GetEnds());
            rows.Close(ring, Stratum(Rule::RegularEdge));
          }
          this->Use(rows.Get());
        };
      });
  }

  const SimplicialComplex<Id>& Complex;
  const subdivision::Strata<Id>& Strata;
  const RingEmitter<Id> Emitter;
  const ChildIds<Id> Ids;
  const vtkIdType FirstEdgeRow;
  const RowsUser<Id>& Use;
};

}

template <typename Id>
vtkIdType LevelRows<Id>::GetNumberOfRows() const
{
  return vtkIdType(this->Level.Complex.NumberOfVertices) + this->Level.Complex.NumberOfEdges;
}

template <typename Id>
void LevelRows<Id>::ForRows(const RowsUser<Id>& use) const
{
  const auto& strata = this->Level.Strata;
  const vtkIdType vertices = this->Level.Complex.NumberOfVertices;
  auto forBlocks = [&](vtkIdType size, const auto& rows)
  {
    ForBlocks(size,
      [&]() { return [&](vtkIdType begin, vtkIdType end) { use(rows(begin, end - begin)); }; });
  };
  forBlocks(vertices,
    [&](vtkIdType first, vtkIdType count)
    {
      return StencilRows<Id>{ false, first, count, strata.Vertices.data() + first, nullptr,
        strata.VertexRings.Offsets.data() + first, strata.VertexRings.Members.data() };
    });
  forBlocks(this->Level.Complex.NumberOfEdges,
    [&](vtkIdType first, vtkIdType count)
    {
      return StencilRows<Id>{ true, vertices + first, count, strata.Edges.data() + first,
        this->Level.Complex.EdgeVertices.data() + 2 * first,
        strata.EdgeRings.Offsets.data() + first, strata.EdgeRings.Members.data() };
    });
}

template <typename Id>
vtkIdType ChildRows<Id>::GetNumberOfRows() const
{
  const auto& complex = this->Level.Complex;
  return vtkIdType(complex.NumberOfVertices) + 3 * vtkIdType(complex.NumberOfEdges) +
    3 * vtkIdType(complex.NumberOfFaces) + complex.NumberOfTets;
}

template <typename Id>
void ChildRows<Id>::ForRows(const RowsUser<Id>& use) const
{
  ChildRowsMaker<Id>(this->Level, use).Run();
}

template class LevelRows<int>;
template class LevelRows<long long>;
template class ChildRows<int>;
template class ChildRows<long long>;

}
