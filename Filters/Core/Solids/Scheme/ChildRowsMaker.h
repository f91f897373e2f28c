// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ChildRowsMaker.h
 * Makes the rows of ChildRows: those at vertices, at edges, in faces and in solids of the given
 * level.
 */
#ifndef SubdivisionObjects_ChildRowsMaker_h
#define SubdivisionObjects_ChildRowsMaker_h

#include "Core/Solids/Scheme/ChildRows.h"
#include "Core/Solids/Scheme/RingBlock.h"
#include "Core/Solids/Scheme/Stencils.h"

namespace subdivision
{

template <typename Split>
class ChildRowsMaker
{
public:
  using Id = typename Split::Id;
  using Shapes = typename Split::Shapes;
  using User = typename RingOperator<Id>::RingsUser;

  ChildRowsMaker(const typename Split::Level& level, const ChildIds<Split>& ids, const User& use)
    : Level(level)
    , Complex(level.Complex)
    , Strata(level.Strata)
    , Solids(GetSolidRows(level))
    , Emitter(level)
    , Ids(ids)
    , FirstEdgeRow(ids.GetNumberOfVertices())
    , FirstCentreRow(FirstEdgeRow + ids.GetNumberOfEdges())
    , Use(use)
  {
  }
  void Run() const
  {
    constexpr std::size_t outer = 3;
    std::array<vtkIdType, outer + Shapes::Size> counts{ this->Complex.NumberOfVertices,
      this->Complex.NumberOfEdges, this->Complex.NumberOfFaces };
    ForShapes(Shapes(),
      [&](auto shape)
      {
        constexpr int kind = decltype(shape)::Index;
        counts[outer + kind] = HasRows<decltype(shape)> ? this->Ids.GetNumberOfSolids(kind) : 0;
      });
    ForKinds<outer + Shapes::Size>(counts,
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
          default:
            ForShapes(Shapes(),
              [&](auto shape)
              {
                if (decltype(shape)::Index + outer == kind)
                {
                  this->InSolids(shape, begin, end);
                }
              });
            break;
        }
      });
  }

private:
  void AtVertices(vtkIdType first, vtkIdType last) const
  {
    const Rings<Id>& rings = this->Strata.VertexRings;
    const vtkIdType counted = this->Solids.NumberOfCounted;
    RingBlock<Id> rows(*this->Solids.Masks, false, BlockSize);
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
        // Rings of vertices with counts keep their sizes and come first, so that offsets into the
        // counts are the same on all levels.
        RingRows<Id> block = rows.Get();
        block.NumberOfCounted = counted - begin;
        block.Counts = begin < counted ? this->Solids.Counts + rings.Offsets[begin] : nullptr;
        this->Use(block);
      });
  }

  /// Both halves of each edge, and its midpoint.
  void AtEdges(vtkIdType first, vtkIdType last) const
  {
    RingBlock<Id> edges(*this->Solids.Masks, true, 2 * BlockSize);
    RingBlock<Id> vertices(*this->Solids.Masks, false, BlockSize);
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
    RingBlock<Id> rows(*this->Solids.Masks, true, 3 * BlockSize);
    ForBlocks(first, last,
      [&](vtkIdType begin, vtkIdType end)
      {
        rows.Start(this->FirstEdgeRow + this->Ids.InFace(static_cast<Id>(begin), 0));
        for (vtkIdType i = begin; i < end; ++i)
        {
          const Id f = static_cast<Id>(i);
          rows.Reserve(3 * this->Emitter.CountInFaceAtMost(f));
          InFaceRows<Split> rings(this->Emitter, f, rows);
          this->Emitter.EmitInFace(f, rings);
        }
        this->Use(rows.Get());
      });
  }

  /// Centres of the children of one solid.
  template <typename Shape, typename... Child>
  static constexpr int CountChildCentres(ShapeList<Child...>)
  {
    return (0 + ... + (Child::Centres * ChildrenOf<Shape, Child>));
  }
  template <typename Shape>
  static constexpr int ChildCentresOf = CountChildCentres<Shape>(Shapes());
  template <typename Shape>
  static constexpr bool HasRows = InnerEdgesOf<Shape> + Shape::Centres + ChildCentresOf<Shape> > 0;

  /// The rows of the inner edges and the centre of each solid, and of the centres of its children.
  template <typename Shape>
  void InSolids(Shape shape, vtkIdType first, vtkIdType last) const
  {
    constexpr vtkIdType blockSize = BlockSize / (InnerEdgesOf<Shape> > 1 ? 8 : 1); // many rows each
    RingBlock<Id> edges(*this->Solids.Masks, true, InnerEdgesOf<Shape> * blockSize);
    RingBlock<Id> centres(*this->Solids.Masks, false, Shape::Centres * blockSize);
    Buffer<Id> corners(RingRows<Id>::CentreSize * ChildCentresOf<Shape> * blockSize);
    ForBlocks(
      first, last,
      [&](vtkIdType begin, vtkIdType end)
      {
        this->UseInnerEdges(shape, begin, end, edges);
        this->UseCentres(shape, begin, end, centres);
        ForShapes(Shapes(),
          [&](auto child) { this->UseChildCentres(child, shape, begin, end, corners.data()); });
      },
      blockSize);
  }

  template <typename Shape>
  void UseInnerEdges(Shape, vtkIdType begin, vtkIdType end, RingBlock<Id>& rows) const
  {
    if constexpr (InnerEdgesOf<Shape> > 0)
    {
      rows.Start(
        this->FirstEdgeRow + this->Ids.template InnerEdge<Shape>(static_cast<Id>(begin), 0));
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Id solid = static_cast<Id>(i);
        rows.Reserve(InnerEdgesOf<Shape> * this->Emitter.template CountInner<Shape>());
        for (int e = 0; e < InnerEdgesOf<Shape>; ++e)
        {
          auto ring = rows.Open();
          this->Emitter.template EmitInner<Shape>(solid, e, ring);
          this->Emitter.template GetInnerEnds<Shape>(solid, e, rows.GetEnds());
          rows.Close(ring, Stratum(Rule::RegularEdge));
        }
      }
      this->Use(rows.Get());
    }
  }

  template <typename Shape>
  void UseCentres(Shape, vtkIdType begin, vtkIdType end, RingBlock<Id>& rows) const
  {
    if constexpr (Shape::Centres > 0)
    {
      rows.Start(this->Ids.template Centre<Shape>(static_cast<Id>(begin)));
      for (vtkIdType i = begin; i < end; ++i)
      {
        rows.Reserve(this->Emitter.template CountCentre<Shape>());
        auto ring = rows.Open();
        this->Emitter.template EmitCentre<Shape>(static_cast<Id>(i), ring);
        rows.Close(ring, Stratum(Rule::RegularEdge));
      }
      this->Use(rows.Get());
    }
  }

  /// The rows of the centres of those children that have one.
  template <typename Child, typename Shape>
  void UseChildCentres(Child, Shape, vtkIdType begin, vtkIdType end, Id* corners) const
  {
    if constexpr (Child::Centres > 0)
    {
      const SolidList<Id> list = Split::GetSolids(this->Level, Shape());
      Id* corner = corners;
      for (vtkIdType i = begin; i < end; ++i)
      {
        const SolidLattice<Shape, Id> lattice(list, this->Ids, static_cast<Id>(i));
        for (const auto& points : Children<Shape, Child>.Points)
        {
          for (int point : points)
          {
            *corner++ = lattice.Points[point];
          }
        }
      }
      const vtkIdType first = this->Ids.template ChildOf<Shape, Child>(static_cast<Id>(begin), 0);
      this->Use({ this->Solids.Masks, false, this->FirstCentreRow + first,
        ChildrenOf<Shape, Child> * (end - begin), nullptr, nullptr, nullptr, corners, true });
    }
  }

  const typename Split::Level& Level;
  const SimplicialComplex<Id>& Complex;
  const subdivision::Strata<Id>& Strata;
  const SolidRows<Id> Solids;
  const RingEmitter<Split> Emitter;
  const ChildIds<Split>& Ids;
  const vtkIdType FirstEdgeRow;
  const vtkIdType FirstCentreRow;
  const User& Use;
};

template <typename Split>
void ChildRows<Split>::ForRows(const typename RingOperator<Id>::RingsUser& use) const
{
  ChildRowsMaker<Split>(this->Level, this->Ids, use).Run();
}

}

#endif
