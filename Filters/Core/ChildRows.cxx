// SPDX-License-Identifier: BSD-3-Clause
#include "ChildRows.h"

#include "RingEmitter.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace subdivision
{
namespace
{

/// Simplices whose rows are made together: their rings fit into a core's own cache.
constexpr vtkIdType BlockSize = 256;

/// block(begin, end) over blocks that cover [begin, end).
template <typename Block>
void ForBlocks(vtkIdType begin, vtkIdType end, const Block& block)
{
  for (; begin < end; begin += BlockSize)
  {
    block(begin, std::min(begin + BlockSize, end));
  }
}

/// body(kind, begin, end) over ranges of some kinds of things, `counts` of each, in one go: threads
/// do not wait for each other between two kinds.
template <std::size_t Kinds, typename Body>
void ForKinds(const std::array<vtkIdType, Kinds>& counts, const Body& body)
{
  ForRanges(std::accumulate(counts.begin(), counts.end(), vtkIdType(0)),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (std::size_t kind = 0; kind < Kinds; ++kind)
      {
        const vtkIdType first = std::max(begin, vtkIdType(0));
        const vtkIdType last = std::min(end, counts[kind]);
        if (first < last)
        {
          body(kind, first, last);
        }
        begin -= counts[kind];
        end -= counts[kind];
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
    RowBlock<Id> rows(false, BlockSize);
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
    RowBlock<Id> edges(true, 2 * BlockSize);
    RowBlock<Id> vertices(false, BlockSize);
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
      });
  }

  void InFaces(vtkIdType first, vtkIdType last) const
  {
    RowBlock<Id> rows(true, 3 * BlockSize);
    ForBlocks(first, last,
      [&](vtkIdType begin, vtkIdType end)
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
      });
  }

  void OfDiagonals(vtkIdType first, vtkIdType last) const
  {
    RowBlock<Id> rows(true, BlockSize);
    ForBlocks(first, last,
      [&](vtkIdType begin, vtkIdType end)
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
  const auto& complex = this->Level.Complex;
  const auto& strata = this->Level.Strata;
  const vtkIdType vertices = complex.NumberOfVertices;
  ForKinds<2>({ vertices, complex.NumberOfEdges },
    [&](std::size_t kind, vtkIdType first, vtkIdType last)
    {
      const Rings<Id>& rings = kind == 0 ? strata.VertexRings : strata.EdgeRings;
      const Stratum* rules = (kind == 0 ? strata.Vertices : strata.Edges).data();
      ForBlocks(first, last,
        [&](vtkIdType begin, vtkIdType end)
        {
          use({ kind == 1, kind == 0 ? begin : vertices + begin, end - begin, rules + begin,
            complex.EdgeVertices.data() + (kind == 0 ? 0 : 2 * begin), rings.Offsets.data() + begin,
            rings.Members.data() });
        });
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
