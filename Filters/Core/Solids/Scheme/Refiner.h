// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Refiner.h
 * One uniform step of a scheme that splits its solids by tables (SolidShapes.h). All ids of
 * children follow by arithmetic (SolidParts.h), and children inherit strata. Every iteration writes
 * a range of its own, so the result does not depend on threads.
 *
 * `Split` is a struct with
 *  - Id, Level, and Shapes, the list of the shapes of its solids;
 *  - CountSolids(level): how many solids a level has of each shape;
 *  - GetSolids(level, shape) and GetStorage(level, shape): where they stand (SolidList,
 *    SolidStorage);
 *  - SolidRings (RingEmitter.h);
 *  - Continue(parent, child): copies the rest that a level hands on.
 */
#ifndef SubdivisionObjects_Refiner_h
#define SubdivisionObjects_Refiner_h

#include "Core/Rules/Depth.h"
#include "Core/Solids/Scheme/EqualSimplices.h"
#include "Core/Solids/Scheme/RingEmitter.h"

namespace subdivision
{

template <typename Split>
class Refiner
{
public:
  using Id = typename Split::Id;
  using Level = typename Split::Level;
  using Shapes = typename Split::Shapes;

  Refiner(const Level& parent, Depth depth)
    : Whole(parent)
    , Parent(parent.Complex)
    , Strata(parent.Strata)
    , Ids(parent)
    , Emitter(parent)
    , Full(depth == Depth::ForRefinement)
  {
  }

  Level Run()
  {
    this->Count();
    this->MakeEdges();
    this->MakeFaces();
    this->MakeSolids();
    RefineEqualLinesAndTriangles(this->Parent, this->Next.Complex);
    ForShapes(Shapes(), [this](auto shape) { this->MakeEqualSolids(shape); });
    this->MakeRings();
    Split::Continue(this->Whole, this->Next);
    return std::move(this->Next);
  }

private:
  void Count()
  {
    const auto& parent = this->Parent;
    auto& child = this->Next.Complex;
    child.NumberOfVertices = this->Ids.GetNumberOfVertices();
    child.NumberOfEdges = this->Ids.GetNumberOfEdges();
    child.NumberOfLineCells = 2 * parent.NumberOfLineCells;
    child.NumberOfTriangleCells = 4 * parent.NumberOfTriangleCells;
    child.NumberOfFaces = this->Full ? this->Ids.GetNumberOfFaces() : child.NumberOfTriangleCells;
    child.VertexCells = Buffer<Id>(parent.VertexCells.size());
    std::copy(parent.VertexCells.begin(), parent.VertexCells.end(), child.VertexCells.begin());
  }
  /// Edges, and the strata of edges and vertices.
  void MakeEdges()
  {
    const auto& parent = this->Parent;
    auto& ends = this->Next.Complex.EdgeVertices;
    auto& strata = this->Next.Strata;
    strata.TakeChoices(this->Strata);
    strata.Sectors =
      RefineSectorEdges(this->Strata.Sectors, parent.EdgeVertices, parent.NumberOfVertices);
    ends = Buffer<Id>(2 * vtkIdType(this->Next.Complex.NumberOfEdges));
    strata.Edges = Buffer<Stratum>(this->Next.Complex.NumberOfEdges);
    strata.Vertices = Buffer<Stratum>(this->Next.Complex.NumberOfVertices);
    ForEach(
      parent.NumberOfVertices, [&](vtkIdType v) { strata.Vertices[v] = this->Strata.Vertices[v]; });
    ForEach(parent.NumberOfEdges,
      [&](vtkIdType e)
      {
        strata.Vertices[parent.NumberOfVertices + e] =
          this->Emitter.MidpointStratum(static_cast<Id>(e));
        strata.Edges[2 * e] = strata.Edges[2 * e + 1] = this->Strata.Edges[e];
        for (int half = 0; half < 2; ++half)
        {
          this->Emitter.GetHalfEnds(static_cast<Id>(e), half, ends.data() + 4 * e + 2 * half);
        }
      });
    ForEach(parent.NumberOfFaces,
      [&](vtkIdType f)
      {
        for (int corner = 0; corner < 3; ++corner)
        {
          const vtkIdType edge = this->Ids.InFace(static_cast<Id>(f), corner);
          this->Emitter.GetInFaceEnds(static_cast<Id>(f), corner, ends.data() + 2 * edge);
          strata.Edges[edge] = this->Emitter.InFaceStratum(static_cast<Id>(f), corner);
        }
      });
    ForShapes(Shapes(), [this](auto shape) { this->MakeInnerEdges(shape); });
  }
  template <typename Shape>
  void MakeInnerEdges(Shape)
  {
    if constexpr (InnerEdgesOf<Shape> > 0)
    {
      auto& ends = this->Next.Complex.EdgeVertices;
      auto& strata = this->Next.Strata;
      ForEach(this->Ids.GetNumberOfSolids(Shape::Index),
        [&](vtkIdType i)
        {
          const Id solid = static_cast<Id>(i);
          if constexpr (Shape::Centres > 0)
          {
            strata.Vertices[this->Ids.template Centre<Shape>(solid)] = Stratum(Rule::RegularEdge);
          }
          for (int e = 0; e < InnerEdgesOf<Shape>; ++e)
          {
            const vtkIdType edge = this->Ids.template InnerEdge<Shape>(solid, e);
            this->Emitter.template GetInnerEnds<Shape>(solid, e, ends.data() + 2 * edge);
            strata.Edges[edge] = Stratum(Rule::RegularEdge);
          }
        });
    }
  }
  void MakeFaces()
  {
    const auto& parent = this->Parent;
    auto& child = this->Next.Complex;
    const vtkIdType split = this->Full ? parent.NumberOfFaces : parent.NumberOfTriangleCells;
    child.FaceVertices = Buffer<Id>(3 * vtkIdType(child.NumberOfFaces));
    child.FaceEdges = Buffer<Id>(3 * vtkIdType(child.NumberOfFaces));
    ForEach(split,
      [&](vtkIdType i)
      {
        const TriangleChildren<Id> children(parent, this->Ids, static_cast<Id>(i));
        std::copy_n(children.Vertices, 12, child.FaceVertices.data() + 12 * i);
        std::copy_n(children.Edges, 12, child.FaceEdges.data() + 12 * i);
      });
    if (this->Full)
    {
      this->MakeFaceCells();
    }
  }
  /// Makes the strata of all faces, and finds the cells at faces that lie in faces of the parent.
  /// SplitSolid adds the cells at the others.
  void MakeFaceCells()
  {
    const auto& parent = this->Parent;
    auto& child = this->Next.Complex;
    Buffer<Id>& offsets = child.FaceTets.Offsets;
    this->Next.Strata.Faces = Buffer<Stratum>(child.NumberOfFaces);
    offsets = Buffer<Id>(vtkIdType(child.NumberOfFaces) + 1);
    ForEach(parent.NumberOfFaces,
      [&](vtkIdType f)
      {
        std::fill_n(this->Next.Strata.Faces.data() + 4 * f, 4, this->Strata.Faces[f]);
        std::fill_n(offsets.data() + 4 * f, 4, static_cast<Id>(parent.FaceTets[f].size()));
      });
    const vtkIdType outer = 4 * vtkIdType(parent.NumberOfFaces);
    Fill(this->Next.Strata.Faces.data() + outer, child.NumberOfFaces - outer, Stratum(Rule::Solid));
    Fill(offsets.data() + outer, child.NumberOfFaces - outer, Id(2));
    CountsToOffsets(offsets);
    child.FaceTets.Items = Buffer<Id>(offsets[child.NumberOfFaces]);
    ForEach(parent.NumberOfFaces,
      [&](vtkIdType f)
      {
        Id place = 0;
        for (Id cell : parent.FaceTets[f])
        {
          Id cells[4];
          this->WithSolid(cell, [&](auto shape, Id solid)
            { this->GetCellsAtFace(shape, solid, parent.FaceVertices.data() + 3 * f, cells); });
          for (int c = 0; c < 4; ++c)
          {
            child.FaceTets.Items[offsets[4 * f + c] + place] = cells[c];
          }
          ++place;
        }
      });
  }
  /// act(shape, its number among the solids of this shape) for a solid as FaceTets names it.
  template <typename Act>
  void WithSolid(Id cell, const Act& act) const
  {
    bool found = false;
    ForShapes(Shapes(),
      [&](auto shape)
      {
        constexpr int kind = decltype(shape)::Index;
        const Id solids = this->Ids.GetNumberOfSolids(kind);
        if (!found && (kind + 1 == Shapes::Size || cell < solids))
        {
          found = true;
          act(shape, cell);
        }
        cell -= solids;
      });
  }
  /// The children of a solid at the four parts of one of its faces.
  template <typename Shape>
  void GetCellsAtFace(Shape, Id solid, const Id* face, Id cells[4]) const
  {
    const Id* vertices =
      Split::GetSolids(this->Whole, Shape()).Vertices + Shape::Vertices * vtkIdType(solid);
    int local[3];
    for (int corner = 0; corner < 3; ++corner)
    {
      local[corner] = FindPlace<Shape::Vertices>(vertices, face[corner]);
    }
    const int place = Shape::FaceOf(local[0], local[1], local[2]);
    const auto& table = FacesIn<Shape>;
    for (int corner = 0; corner < 3; ++corner)
    {
      cells[corner] = this->Ids.template Cell<Shape>(solid, table.AtCorners[place][local[corner]]);
    }
    cells[3] = this->Ids.template Cell<Shape>(solid, table.AtMiddles[place]);
  }
  void MakeSolids()
  {
    ForShapes(Shapes(),
      [this](auto shape)
      {
        using Shape = decltype(shape);
        const vtkIdType children = this->Ids.GetNumberOfChildren(Shape::Index);
        const SolidStorage<Id> out = Split::GetStorage(this->Next, shape);
        out.Number = static_cast<Id>(children);
        out.Vertices = Buffer<Id>(Shape::Vertices * children);
        out.Edges = Buffer<Id>(Shape::Edges * children);
        out.Faces = Buffer<Id>(this->Full ? Shape::Faces * children : 0);
      });
    ForShapes(Shapes(),
      [this](auto shape)
      {
        ForEach(this->Ids.GetNumberOfSolids(decltype(shape)::Index),
          [&](vtkIdType i) { this->SplitSolid(shape, static_cast<Id>(i)); });
      });
  }
  /// The children of a solid, and the faces between them.
  template <typename Shape>
  void SplitSolid(Shape, Id solid)
  {
    const SolidParts<Shape, Id> parts(
      this->Parent, Split::GetSolids(this->Whole, Shape()), this->Ids, solid);
    ForShapes(Shapes(), [&](auto child) { this->WriteChildren(child, solid, parts); });
    if (this->Full)
    {
      this->WriteInnerFaces(solid, parts);
    }
  }
  template <typename Child, typename Shape>
  void WriteChildren(Child, Id solid, const SolidParts<Shape, Id>& parts)
  {
    const auto& table = Children<Shape, Child>;
    const SolidStorage<Id> out = Split::GetStorage(this->Next, Child());
    const vtkIdType first = this->Ids.template ChildOf<Shape, Child>(solid, 0);
    Id* vertex = out.Vertices.data() + Child::Vertices * first;
    Id* edge = out.Edges.data() + Child::Edges * first;
    for (std::size_t c = 0; c < table.Size; ++c)
    {
      for (int point : table.Points[c])
      {
        *vertex++ = parts.Lattice.Points[point];
      }
      for (int place : table.Edges[c])
      {
        *edge++ = parts.Edges[place];
      }
    }
    Id* face = out.Faces.data() + Child::Faces * first;
    for (std::size_t c = 0; c < table.Size && this->Full; ++c)
    {
      for (int place : table.Faces[c])
      {
        *face++ = parts.GetFace(place);
      }
    }
  }
  template <typename Shape>
  void WriteInnerFaces(Id solid, const SolidParts<Shape, Id>& parts)
  {
    static constexpr auto inner = Shape::GetInnerFaces();
    const auto& table = FacesIn<Shape>;
    auto& child = this->Next.Complex;
    vtkIdType face = parts.FirstInnerFace;
    for (int f = 0; f < InnerFacesOf<Shape>; ++f, ++face)
    {
      for (int i = 0; i < 3; ++i)
      {
        child.FaceVertices[3 * face + i] = parts.Lattice.Points[inner[f][i]];
        child.FaceEdges[3 * face + i] = parts.Edges[table.InnerEdges[f][i]];
      }
      Id* cells = child.FaceTets.Items.data() + child.FaceTets.Offsets[face];
      cells[0] = this->Ids.template Cell<Shape>(solid, table.AtInner[f][0]);
      cells[1] = this->Ids.template Cell<Shape>(solid, table.AtInner[f][1]);
    }
  }
  /// The followers of one shape on the next level.
  template <typename Child>
  void MakeEqualSolids(Child)
  {
    vtkIdType size = 0;
    ForShapes(Shapes(),
      [&](auto shape)
      {
        size += ChildrenOf<decltype(shape), Child> *
          Split::GetSolids(this->Whole, shape).Equal->Twins.size();
      });
    Split::GetStorage(this->Next, Child()).Equal = { Buffer<Id>(Child::Vertices * size),
      Buffer<Id>(size) };
    vtkIdType first = 0;
    ForShapes(Shapes(),
      [&](auto shape)
      {
        this->MakeEqualChildren(Child(), shape, first);
        first += ChildrenOf<decltype(shape), Child> *
          Split::GetSolids(this->Whole, shape).Equal->Twins.size();
      });
  }
  /// The tables give the vertices of a child of an equal solid; its twin is the child of the
  /// parent's twin that has the same vertices.
  template <typename Child, typename Shape>
  void MakeEqualChildren(Child, Shape, vtkIdType first)
  {
    constexpr int size = Child::Vertices;
    const SolidList<Id> list = Split::GetSolids(this->Whole, Shape());
    const SolidStorage<Id> out = Split::GetStorage(this->Next, Child());
    for (vtkIdType i = 0; i < list.Equal->Twins.size(); ++i)
    {
      const Id twin = list.Equal->Twins[i];
      Id edges[Shape::Edges];
      GetEdgesOfEqual<Shape>(list, i, edges);
      const SolidLattice<Shape, Id> lattice(
        this->Ids, list.Equal->Vertices.data() + Shape::Vertices * i, edges, twin);
      for (const auto& points : Children<Shape, Child>.Points)
      {
        Id* vertices = out.Equal.Vertices.data() + size * first;
        for (int k = 0; k < size; ++k)
        {
          vertices[k] = lattice.Points[points[k]];
        }
        int child = ChildrenOf<Shape, Child> - 1; // equal solids are split alike: one is found
        auto get = [&]() { return this->Ids.template ChildOf<Shape, Child>(twin, child); };
        while (child > 0 &&
          !std::is_permutation(
            vertices, vertices + size, out.Vertices.data() + size * vtkIdType(get())))
        {
          --child;
        }
        out.Equal.Twins[first++] = get();
      }
    }
  }
  void CountRings()
  {
    const auto& parent = this->Parent;
    auto& edges = this->Next.Strata.EdgeRings;
    auto& vertices = this->Next.Strata.VertexRings;
    edges.Offsets = Buffer<Id>(vtkIdType(this->Next.Complex.NumberOfEdges) + 1);
    vertices.Offsets = Buffer<Id>(vtkIdType(this->Next.Complex.NumberOfVertices) + 1);
    ForEach(parent.NumberOfVertices, [&](vtkIdType v)
      { vertices.Offsets[v] = static_cast<Id>(this->Strata.VertexRings.GetSize(v)); });
    ForEach(parent.NumberOfEdges,
      [&](vtkIdType i)
      {
        const Id e = static_cast<Id>(i);
        edges.Offsets[2 * i] = edges.Offsets[2 * i + 1] = this->Emitter.CountHalf(e);
        vertices.Offsets[this->Ids.Midpoint(e)] = this->Emitter.CountMidpoint(e);
      });
    ForEach(parent.NumberOfFaces,
      [&](vtkIdType i)
      {
        const Id f = static_cast<Id>(i);
        this->Emitter.CountInFace(f, edges.Offsets.data() + this->Ids.InFace(f, 0));
      });
    ForShapes(Shapes(),
      [&](auto shape)
      {
        using Shape = decltype(shape);
        const vtkIdType solids = this->Ids.GetNumberOfSolids(Shape::Index);
        const Id inner = this->Emitter.template CountInner<Shape>();
        const Id centre = this->Emitter.template CountCentre<Shape>();
        Fill(edges.Offsets.data() + this->Ids.template InnerEdge<Shape>(0, 0),
          InnerEdgesOf<Shape> * solids, inner);
        Fill(vertices.Offsets.data() + this->Ids.template Centre<Shape>(0), Shape::Centres * solids,
          centre);
      });
    for (Rings<Id>* rings : { &edges, &vertices })
    {
      CountsToOffsets(rings->Offsets);
      const vtkIdType entries = rings->Offsets[rings->Offsets.size() - 1];
      rings->Members = Buffer<Id>(entries);
      rings->Carriers = Buffer<Id>(this->Full ? entries : 0);
    }
  }
  void MakeRings()
  {
    this->CountRings();
    const auto& parent = this->Parent;
    auto& edges = this->Next.Strata.EdgeRings;
    auto& vertices = this->Next.Strata.VertexRings;
    ForEach(parent.NumberOfVertices,
      [&](vtkIdType v)
      {
        auto vertex = this->WriteRing(vertices, v);
        this->Emitter.EmitVertex(static_cast<Id>(v), vertex);
      });
    ForEach(parent.NumberOfEdges,
      [&](vtkIdType i)
      {
        const Id e = static_cast<Id>(i);
        RingWriter<Id> halves[2] = { this->WriteRing(edges, 2 * i),
          this->WriteRing(edges, 2 * i + 1) };
        auto midpoint = this->WriteRing(vertices, this->Ids.Midpoint(e));
        this->Emitter.EmitAtEdge(e, halves, midpoint);
      });
    ForEach(parent.NumberOfFaces,
      [&](vtkIdType i)
      {
        const Id f = static_cast<Id>(i);
        const InFaceRings rings{ this, &edges, this->Ids.InFace(f, 0) };
        this->Emitter.EmitInFace(f, rings);
      });
    ForShapes(Shapes(),
      [&](auto shape)
      {
        using Shape = decltype(shape);
        if constexpr (InnerEdgesOf<Shape> > 0)
        {
          ForEach(this->Ids.GetNumberOfSolids(Shape::Index),
            [&](vtkIdType i)
            {
              const Id solid = static_cast<Id>(i);
              for (int e = 0; e < InnerEdgesOf<Shape>; ++e)
              {
                auto inner = this->WriteRing(edges, this->Ids.template InnerEdge<Shape>(solid, e));
                this->Emitter.template EmitInner<Shape>(solid, e, inner);
              }
              if constexpr (Shape::Centres > 0)
              {
                auto centre = this->WriteRing(vertices, this->Ids.template Centre<Shape>(solid));
                this->Emitter.template EmitCentre<Shape>(solid, centre);
              }
            });
        }
      });
  }

  RingWriter<Id> WriteRing(Rings<Id>& rings, vtkIdType row) const
  {
    const Id first = rings.Offsets[row];
    return { rings.Members.data() + first, this->Full ? rings.Carriers.data() + first : nullptr };
  }
  /// The rings of the edges inside a face, as RingEmitter::EmitInFace takes them.
  struct InFaceRings
  {
    const Refiner* Maker;
    Rings<Id>* Edges;
    vtkIdType First;
    RingWriter<Id> Open(int corner, Id) const
    {
      return this->Maker->WriteRing(*this->Edges, this->First + corner);
    }
    void Close(int, const RingWriter<Id>&) const {}
  };

  const Level& Whole;
  const SimplicialComplex<Id>& Parent;
  const subdivision::Strata<Id>& Strata;
  const ChildIds<Split> Ids;
  const RingEmitter<Split> Emitter;
  const bool Full;
  Level Next;
};

}

#endif
