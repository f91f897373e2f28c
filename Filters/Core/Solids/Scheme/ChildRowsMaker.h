// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ChildRowsMaker.h
 * Makes the rows of ChildRows: at vertices, at edges, in faces and in solids of the given level, or
 * of its selected parts.
 */
#ifndef SubdivisionObjects_ChildRowsMaker_h
#define SubdivisionObjects_ChildRowsMaker_h

#include "Core/Solids/Scheme/ChildRows.h"
#include "Core/Solids/Scheme/RingBlock.h"
#include "Core/Solids/Scheme/Stencils.h"

#include <vector>

namespace subdivision
{

template <typename Split>
class ChildRowsMaker
{
public:
  using Id = typename Split::Id;
  using Shapes = typename Split::Shapes;
  using User = typename RingOperator<Id>::RingsUser;

  ChildRowsMaker(const typename Split::Level& level, const ChildIds<Split>& ids,
    const ChildSelection<Split>* selection, const User& use)
    : Level(level)
    , Complex(level.Complex)
    , Strata(level.Strata)
    , Solids(GetSolidRows(level))
    , Emitter(level)
    , Ids(ids)
    , Selection(selection)
    , RowIds(selection ? selection->Ids : ids)
    , FirstEdgeRow(RowIds.GetNumberOfVertices())
    , FirstCentreRow(FirstEdgeRow + RowIds.GetNumberOfEdges())
    , Use(use)
  {
  }
  void Run() const
  {
    constexpr std::size_t outer = 3;
    std::array<vtkIdType, outer + Shapes::Size> counts{ this->Complex.NumberOfVertices,
      this->Complex.NumberOfEdges, this->Complex.NumberOfFaces };
    if (this->Selection)
    {
      counts = { this->Selection->Vertices.size(), this->Selection->Edges.size(),
        this->Selection->Faces.size() };
    }
    ForShapes(Shapes(),
      [&](auto shape)
      {
        constexpr int kind = decltype(shape)::Index;
        counts[outer + kind] = HasRows<decltype(shape)> ? this->RowIds.GetNumberOfSolids(kind) : 0;
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
  /// The numbers in the level of the parts that get rows.
  Id GetVertex(vtkIdType i) const { return this->Selection ? this->Selection->Vertices[i] : Id(i); }
  Id GetEdge(vtkIdType i) const { return this->Selection ? this->Selection->Edges[i] : Id(i); }
  Id GetFace(vtkIdType i) const { return this->Selection ? this->Selection->Faces[i] : Id(i); }
  template <typename Shape>
  Id GetSolid(Shape, vtkIdType i) const
  {
    return this->Selection ? (*this->Selection->Solids[Shape::Index])[i] : Id(i);
  }

  void AtVertices(vtkIdType first, vtkIdType last) const
  {
    const Rings<Id>& rings = this->Strata.VertexRings;
    RingBlock<Id> rows(*this->Solids.Masks, false, BlockSize, this->Selection != nullptr);
    std::vector<Id> counts;
    ForBlocks(first, last,
      [&](vtkIdType begin, vtkIdType end)
      {
        rows.Start(begin);
        counts.clear();
        vtkIdType counted = 0;
        for (vtkIdType i = begin; i < end; ++i)
        {
          const Id v = this->GetVertex(i);
          const auto size = static_cast<Id>(rings.GetSize(v));
          rows.Reserve(size);
          auto ring = rows.Open();
          this->Emitter.EmitVertex(v, ring);
          rows.SetColumn(v);
          rows.Close(ring, this->Strata.Vertices[v]);
          // Vertices with counts come first, and their rings have the same sizes on all levels.
          if (v < this->Solids.NumberOfCounted)
          {
            ++counted;
            const Id* ofRing = this->Solids.Counts + rings.Offsets[v];
            counts.insert(counts.end(), ofRing, ofRing + size);
          }
        }
        RingRows<Id> block = rows.Get();
        block.NumberOfCounted = counted;
        block.Counts = counts.data();
        this->Use(block);
      });
  }

  /// Both halves of each edge, and its midpoint.
  void AtEdges(vtkIdType first, vtkIdType last) const
  {
    RingBlock<Id> edges(*this->Solids.Masks, true, 2 * BlockSize);
    RingBlock<Id> vertices(*this->Solids.Masks, false, BlockSize, this->Selection != nullptr);
    ForBlocks(first, last,
      [&](vtkIdType begin, vtkIdType end)
      {
        edges.Start(this->FirstEdgeRow + 2 * begin);
        vertices.Start(this->RowIds.Midpoint(static_cast<Id>(begin)));
        for (vtkIdType i = begin; i < end; ++i)
        {
          const Id e = this->GetEdge(i);
          const Id size = this->Emitter.CountHalf(e);
          edges.Reserve(2 * size);
          vertices.Reserve(this->Emitter.CountMidpointAtMost(e));
          MemberWriter<Id> halves[2] = { edges.Open(), edges.Open(size) };
          auto midpoint = vertices.Open();
          this->Emitter.EmitAtEdge(e, halves, midpoint);
          vertices.SetColumn(this->Ids.Midpoint(e));
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
        rows.Start(this->FirstEdgeRow + this->RowIds.InFace(static_cast<Id>(begin), 0));
        for (vtkIdType i = begin; i < end; ++i)
        {
          const Id f = this->GetFace(i);
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
    RingBlock<Id> centres(
      *this->Solids.Masks, false, Shape::Centres * blockSize, this->Selection != nullptr);
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
  void UseInnerEdges(Shape shape, vtkIdType begin, vtkIdType end, RingBlock<Id>& rows) const
  {
    if constexpr (InnerEdgesOf<Shape> > 0)
    {
      rows.Start(
        this->FirstEdgeRow + this->RowIds.template InnerEdge<Shape>(static_cast<Id>(begin), 0));
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Id solid = this->GetSolid(shape, i);
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
  void UseCentres(Shape shape, vtkIdType begin, vtkIdType end, RingBlock<Id>& rows) const
  {
    if constexpr (Shape::Centres > 0)
    {
      rows.Start(this->RowIds.template Centre<Shape>(static_cast<Id>(begin)));
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Id solid = this->GetSolid(shape, i);
        rows.Reserve(this->Emitter.template CountCentre<Shape>());
        auto ring = rows.Open();
        this->Emitter.template EmitCentre<Shape>(solid, ring);
        rows.SetColumn(this->Ids.template Centre<Shape>(solid));
        rows.Close(ring, Stratum(Rule::RegularEdge));
      }
      this->Use(rows.Get());
    }
  }

  /// The rows of the centres of children that have one.
  template <typename Child, typename Shape>
  void UseChildCentres(Child, Shape shape, vtkIdType begin, vtkIdType end, Id* corners) const
  {
    if constexpr (Child::Centres > 0)
    {
      const SolidList<Id> list = Split::GetSolids(this->Level, Shape());
      Id* corner = corners;
      for (vtkIdType i = begin; i < end; ++i)
      {
        const SolidLattice<Shape, Id> lattice(list, this->Ids, this->GetSolid(shape, i));
        for (const auto& points : Children<Shape, Child>.Points)
        {
          for (int point : points)
          {
            *corner++ = lattice.Points[point];
          }
        }
      }
      const vtkIdType first =
        this->RowIds.template ChildOf<Shape, Child>(static_cast<Id>(begin), 0);
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
  const ChildSelection<Split>* const Selection;
  const ChildIds<Split>& RowIds; ///< of the parts that get rows
  const vtkIdType FirstEdgeRow;
  const vtkIdType FirstCentreRow;
  const User& Use;
};

template <typename Split>
void ChildRows<Split>::ForRows(const typename RingOperator<Id>::RingsUser& use) const
{
  ChildRowsMaker<Split>(this->Level, this->LevelIds, this->Selection, use).Run();
}

}

#endif
