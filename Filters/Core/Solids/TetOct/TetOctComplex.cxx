// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/TetOct/TetOctComplex.h"

#include "Core/Solids/TetOct/TetOctRefiner.h"

namespace subdivision
{
namespace
{

/// A face inside a split cell: its lattice points and edges, and its two cells, a tetrahedron and
/// an octahedron among the children.
struct InnerFace
{
  int Points[3] = { 0, 0, 0 };
  int Edges[3] = { 0, 0, 0 }; ///< as numbered by PlaceOf
  int Tet = 0;
  int Oct = 0;

  template <typename Shape>
  constexpr void Set(int p, int q, int r)
  {
    this->Points[0] = p;
    this->Points[1] = q;
    this->Points[2] = r;
    for (int i = 0; i < 3; ++i)
    {
      this->Edges[i] = PlaceOf<Shape>(ClassifyChildEdge<Shape>(
        this->Points[triangle::EdgeVertices[i][0]], this->Points[triangle::EdgeVertices[i][1]]));
    }
  }
};

constexpr auto MakeCutFaces()
{
  std::array<InnerFace, 4> table{};
  for (int v = 0; v < 4; ++v)
  {
    const int* others = tetrahedron::FaceVertices[v];
    table[v].Set<TetShape>(LatticePoint<TetShape>(v, others[0]),
      LatticePoint<TetShape>(v, others[1]), LatticePoint<TetShape>(v, others[2]));
    table[v].Tet = v;
  }
  return table;
}

constexpr auto MakeFanFaces()
{
  std::array<InnerFace, 24> table{};
  for (int face = 0; face < 8; ++face)
  {
    const int* corners = octahedron::FaceVertices[face];
    for (int i = 0; i < 3; ++i)
    {
      InnerFace& fan = table[3 * face + i];
      fan.Set<OctShape>(OctShape::Points - 1,
        LatticePoint<OctShape>(corners[i], corners[(i + 1) % 3]),
        LatticePoint<OctShape>(corners[i], corners[(i + 2) % 3]));
      fan.Tet = face;
      fan.Oct = corners[i];
    }
  }
  return table;
}

template <typename Shape>
constexpr auto InnerFaces = MakeCutFaces();
template <>
constexpr auto InnerFaces<OctShape> = MakeFanFaces();

}

template <typename Id>
TetOctLevel<Id> TetOctRefiner<Id>::Run()
{
  this->Count();
  this->MakeEdges();
  this->MakeFaces();
  this->MakeCells();
  this->MakeEqualCells();
  this->MakeRings();
  this->Child.TetsAtSpokes = this->Level.TetsAtSpokes;
  this->Child.NumberOfControlVertices = this->Level.NumberOfControlVertices;
  this->Child.Steps = this->Level.Steps + 1;
  return std::move(this->Child);
}

template <typename Id>
void TetOctRefiner<Id>::Count()
{
  const auto& parent = this->Parent;
  const Id octs = this->Level.NumberOfOctahedra;
  auto& child = this->Child.Complex;
  child.NumberOfVertices = parent.NumberOfVertices + parent.NumberOfEdges + octs;
  child.NumberOfEdges = 2 * parent.NumberOfEdges + 3 * parent.NumberOfFaces + 12 * octs;
  child.NumberOfTets = 4 * parent.NumberOfTets + 8 * octs;
  this->Child.NumberOfOctahedra = parent.NumberOfTets + 6 * octs;
  child.NumberOfLineCells = 2 * parent.NumberOfLineCells;
  child.NumberOfTriangleCells = 4 * parent.NumberOfTriangleCells;
  child.NumberOfFaces = this->Full ? 4 * parent.NumberOfFaces + 4 * parent.NumberOfTets + 24 * octs
                                   : child.NumberOfTriangleCells;
  child.VertexCells = Buffer<Id>(parent.VertexCells.size());
  std::copy(parent.VertexCells.begin(), parent.VertexCells.end(), child.VertexCells.begin());
}

/// Edges, and the strata of edges and vertices.
template <typename Id>
void TetOctRefiner<Id>::MakeEdges()
{
  const auto& parent = this->Parent;
  auto& ends = this->Child.Complex.EdgeVertices;
  auto& strata = this->Child.Strata;
  ends = Buffer<Id>(2 * vtkIdType(this->Child.Complex.NumberOfEdges));
  strata.Edges = Buffer<Stratum>(this->Child.Complex.NumberOfEdges);
  strata.Vertices = Buffer<Stratum>(this->Child.Complex.NumberOfVertices);
  ForEach(
    parent.NumberOfVertices, [&](vtkIdType v) { strata.Vertices[v] = this->Strata.Vertices[v]; });
  ForEach(parent.NumberOfEdges,
    [&](vtkIdType e)
    {
      const Stratum stratum = this->Strata.Edges[e];
      strata.Vertices[parent.NumberOfVertices + e] = stratum;
      strata.Edges[2 * e] = stratum;
      strata.Edges[2 * e + 1] = stratum;
      Id* out = ends.data() + 4 * e;
      out[0] = parent.EdgeVertices[2 * e];
      out[1] = out[2] = this->Ids.Midpoint(static_cast<Id>(e));
      out[3] = parent.EdgeVertices[2 * e + 1];
    });
  ForEach(parent.NumberOfFaces,
    [&](vtkIdType f)
    {
      const Id* edges = parent.FaceEdges.data() + 3 * f;
      const Stratum face = this->Strata.Faces[f];
      for (int corner = 0; corner < 3; ++corner)
      {
        const vtkIdType edge = this->Ids.InFace(static_cast<Id>(f), corner);
        ends[2 * edge] = this->Ids.Midpoint(edges[triangle::EdgesAt[corner][0]]);
        ends[2 * edge + 1] = this->Ids.Midpoint(edges[triangle::EdgesAt[corner][1]]);
        strata.Edges[edge] = face.GetRule() == Rule::Solid ? Stratum(Rule::RegularEdge) : face;
      }
    });
  ForEach(this->Level.NumberOfOctahedra,
    [&](vtkIdType o)
    {
      const Id centre = this->Ids.Centre(static_cast<Id>(o));
      strata.Vertices[centre] = Stratum(Rule::RegularEdge);
      for (int e = 0; e < 12; ++e)
      {
        const vtkIdType edge = this->Ids.Spoke(static_cast<Id>(o), e);
        ends[2 * edge] = centre;
        ends[2 * edge + 1] = this->Ids.Midpoint(this->Level.OctEdges[12 * o + e]);
        strata.Edges[edge] = Stratum(Rule::RegularEdge);
      }
    });
}

template <typename Id>
void TetOctRefiner<Id>::MakeFaces()
{
  const auto& parent = this->Parent;
  auto& child = this->Child.Complex;
  const vtkIdType split = this->Full ? parent.NumberOfFaces : parent.NumberOfTriangleCells;
  child.FaceVertices = Buffer<Id>(3 * vtkIdType(child.NumberOfFaces));
  child.FaceEdges = Buffer<Id>(3 * vtkIdType(child.NumberOfFaces));
  constexpr int middleEdgeCorner[3] = { 1, 2, 0 }; // which each edge of the middle child cuts off
  ForEach(split,
    [&](vtkIdType i)
    {
      const Id f = static_cast<Id>(i);
      const Id* vertices = parent.FaceVertices.data() + 3 * i;
      const Id* edges = parent.FaceEdges.data() + 3 * i;
      const Id lattice[6] = { vertices[0], vertices[1], vertices[2], this->Ids.Midpoint(edges[0]),
        this->Ids.Midpoint(edges[1]), this->Ids.Midpoint(edges[2]) };
      for (int c = 0; c < 4; ++c)
      {
        for (int k = 0; k < 3; ++k)
        {
          child.FaceVertices[12 * i + 3 * c + k] = lattice[triangle::Children[c][k]];
          child.FaceEdges[12 * i + 3 * c + k] = c == 3 ? this->Ids.InFace(f, middleEdgeCorner[k])
            : triangle::VertexOpposite[k] == c         ? this->Ids.InFace(f, c)
                                                       : this->Ids.Half(edges[k], vertices[c]);
        }
      }
    });
  if (this->Full)
  {
    this->MakeFaceCells();
  }
}

/// Makes the strata of all faces, and finds the cells at those that lie in faces of the parent.
/// MakeChildren adds the cells at the others.
template <typename Id>
void TetOctRefiner<Id>::MakeFaceCells()
{
  const auto& parent = this->Parent;
  auto& child = this->Child.Complex;
  Buffer<Id>& offsets = child.FaceTets.Offsets;
  this->Child.Strata.Faces = Buffer<Stratum>(child.NumberOfFaces);
  offsets = Buffer<Id>(vtkIdType(child.NumberOfFaces) + 1);
  ForEach(child.NumberOfFaces,
    [&](vtkIdType f)
    {
      const bool inner = f >= 4 * vtkIdType(parent.NumberOfFaces);
      this->Child.Strata.Faces[f] = inner ? Stratum(Rule::Solid) : this->Strata.Faces[f / 4];
      offsets[f] = inner ? 2 : static_cast<Id>(parent.FaceTets[f / 4].size());
    });
  CountsToOffsets(offsets);
  child.FaceTets.Items = Buffer<Id>(offsets[child.NumberOfFaces]);
  ForEach(parent.NumberOfFaces,
    [&](vtkIdType f)
    {
      const Id* vertices = parent.FaceVertices.data() + 3 * f;
      Id place = 0;
      for (Id cell : parent.FaceTets[f])
      {
        Id cells[4];
        if (cell < parent.NumberOfTets)
        {
          for (int corner = 0; corner < 3; ++corner)
          {
            cells[corner] = this->Ids.TetOfTet(cell, parent.VertexInTet(cell, vertices[corner]));
          }
          cells[3] = this->Ids.OctCell(this->Ids.OctOfTet(cell));
        }
        else
        {
          const Id oct = cell - parent.NumberOfTets;
          int local[3];
          for (int corner = 0; corner < 3; ++corner)
          {
            local[corner] = VertexInOct(this->Level, oct, vertices[corner]);
            cells[corner] = this->Ids.OctCell(this->Ids.OctOfOct(oct, local[corner]));
          }
          cells[3] = this->Ids.TetOfOct(oct, octahedron::FaceOf(local[0], local[1], local[2]));
        }
        for (int c = 0; c < 4; ++c)
        {
          child.FaceTets.Items[offsets[4 * f + c] + place] = cells[c];
        }
        ++place;
      }
    });
}

template <typename Id>
void TetOctRefiner<Id>::MakeCells()
{
  auto& child = this->Child.Complex;
  const vtkIdType tets = child.NumberOfTets;
  const vtkIdType octs = this->Child.NumberOfOctahedra;
  child.TetVertices = Buffer<Id>(4 * tets);
  child.TetEdges = Buffer<Id>(6 * tets);
  child.TetFaces = Buffer<Id>(this->Full ? 4 * tets : 0);
  this->Child.OctVertices = Buffer<Id>(6 * octs);
  this->Child.OctEdges = Buffer<Id>(12 * octs);
  this->Child.OctFaces = Buffer<Id>(this->Full ? 8 * octs : 0);
  ForEach(this->Parent.NumberOfTets,
    [&](vtkIdType i)
    {
      const Id t = static_cast<Id>(i);
      this->template MakeChildren<TetShape>(t, this->Ids.TetOfTet(t, 0), this->Ids.OctOfTet(t));
    });
  ForEach(this->Level.NumberOfOctahedra,
    [&](vtkIdType i)
    {
      const Id o = static_cast<Id>(i);
      this->template MakeChildren<OctShape>(o, this->Ids.TetOfOct(o, 0), this->Ids.OctOfOct(o, 0));
    });
}

/// The children of a cell, and the faces between them.
template <typename Id>
template <typename Shape>
void TetOctRefiner<Id>::MakeChildren(Id cell, Id firstTet, Id firstOct)
{
  const CellParts<Shape, Id> parts(this->Level, this->Ids, cell);
  auto& child = this->Child.Complex;
  auto write = [&](int children, Id first, auto& corners, auto& edges, auto& faces,
                 const auto& cornerTable, const auto& edgeTable, const auto& faceTable)
  {
    auto* corner = corners.data() + first * vtkIdType(cornerTable[0].size());
    auto* edge = edges.data() + first * vtkIdType(edgeTable[0].size());
    for (int c = 0; c < children; ++c)
    {
      for (int point : cornerTable[c])
      {
        *corner++ = parts.Lattice.Points[point];
      }
      for (int place : edgeTable[c])
      {
        *edge++ = parts.Edges[place];
      }
    }
    auto* face = faces.data() + first * vtkIdType(faceTable[0].size());
    for (int c = 0; c < children && this->Full; ++c)
    {
      for (const ChildFacePart& part : faceTable[c])
      {
        *face++ = parts.GetFace(part, this->Ids);
      }
    }
  };
  const auto& table = Children<Shape>;
  write(Shape::ChildTets, firstTet, child.TetVertices, child.TetEdges, child.TetFaces, table.Tets,
    table.TetEdges, table.TetFaces);
  write(Shape::ChildOcts, firstOct, this->Child.OctVertices, this->Child.OctEdges,
    this->Child.OctFaces, table.Octs, table.OctEdges, table.OctFaces);
  if (!this->Full)
  {
    return;
  }
  vtkIdType face = Shape::Vertices == 4 ? this->Ids.Cut(cell, 0) : this->Ids.Fan(cell, 0, 0);
  for (const InnerFace& inner : InnerFaces<Shape>)
  {
    for (int i = 0; i < 3; ++i)
    {
      child.FaceVertices[3 * face + i] = parts.Lattice.Points[inner.Points[i]];
      child.FaceEdges[3 * face + i] = parts.Edges[inner.Edges[i]];
    }
    Id* cells = child.FaceTets.Items.data() + child.FaceTets.Offsets[face];
    cells[0] = firstTet + inner.Tet;
    cells[1] = this->Ids.OctCell(firstOct + inner.Oct);
    ++face;
  }
}

template <typename Id>
void TetOctRefiner<Id>::MakeEqualCells()
{
  RefineEqualLinesAndTriangles(this->Parent, this->Child.Complex);
  this->MakeEqualSolids();
}

/// The tables give the vertices of a child of an equal solid; its twin is the child of the parent's
/// twin at the same vertex or face.
template <typename Id>
void TetOctRefiner<Id>::MakeEqualSolids()
{
  const auto& parent = this->Parent;
  const auto& equalTets = parent.EqualTets;
  const auto& equalOcts = this->Level.EqualOcts;
  const vtkIdType tets = equalTets.Twins.size();
  const vtkIdType octs = equalOcts.Twins.size();
  EqualCells<Id>& childTets = this->Child.Complex.EqualTets;
  EqualCells<Id>& childOcts = this->Child.EqualOcts;
  childTets = { Buffer<Id>(4 * (4 * tets + 8 * octs)), Buffer<Id>(4 * tets + 8 * octs) };
  childOcts = { Buffer<Id>(6 * (tets + 6 * octs)), Buffer<Id>(tets + 6 * octs) };
  auto write = [](EqualCells<Id>& out, vtkIdType at, const auto& points, const Id* lattice, Id twin)
  {
    Id* corner = out.Vertices.data() + at * vtkIdType(points.size());
    for (int point : points)
    {
      *corner++ = lattice[point];
    }
    out.Twins[at] = twin;
  };
  for (vtkIdType i = 0; i < tets; ++i)
  {
    const Id twin = equalTets.Twins[i];
    Id lattice[TetShape::Points];
    std::copy_n(equalTets.Vertices.data() + 4 * i, 4, lattice);
    GetEdgesOfEqualTet(parent, i, lattice + 4);
    std::transform(
      lattice + 4, lattice + 10, lattice + 4, [this](Id edge) { return this->Ids.Midpoint(edge); });
    for (int v = 0; v < 4; ++v)
    {
      write(childTets, 4 * i + v, Children<TetShape>.Tets[v], lattice,
        this->Ids.TetOfTet(twin, parent.VertexInTet(twin, lattice[v])));
    }
    write(childOcts, i, Children<TetShape>.Octs[0], lattice, this->Ids.OctOfTet(twin));
  }
  for (vtkIdType i = 0; i < octs; ++i)
  {
    const Id twin = equalOcts.Twins[i];
    Id lattice[OctShape::Points];
    int local[6];
    std::copy_n(equalOcts.Vertices.data() + 6 * i, 6, lattice);
    GetEdgesOfEqualOct(this->Level, i, lattice + 6);
    std::transform(
      lattice + 6, lattice + 18, lattice + 6, [this](Id edge) { return this->Ids.Midpoint(edge); });
    lattice[18] = this->Ids.Centre(twin);
    for (int v = 0; v < 6; ++v)
    {
      local[v] = VertexInOct(this->Level, twin, lattice[v]);
      write(childOcts, tets + 6 * i + v, Children<OctShape>.Octs[v], lattice,
        this->Ids.OctOfOct(twin, local[v]));
    }
    for (int f = 0; f < 8; ++f)
    {
      const int* face = octahedron::FaceVertices[f];
      write(childTets, 4 * tets + 8 * i + f, Children<OctShape>.Tets[f], lattice,
        this->Ids.TetOfOct(
          twin, octahedron::FaceOf(local[face[0]], local[face[1]], local[face[2]])));
    }
  }
}

template <typename Id>
void GetEdgesOfEqualOct(const TetOctLevel<Id>& level, vtkIdType index, Id edges[12])
{
  const vtkIdType twin = level.EqualOcts.Twins[index];
  const Id* vertices = level.OctVertices.data() + 6 * twin;
  int local[6];
  for (int i = 0; i < 6; ++i)
  {
    local[i] = static_cast<int>(
      std::find(vertices, vertices + 6, level.EqualOcts.Vertices[6 * index + i]) - vertices);
  }
  for (int e = 0; e < 12; ++e)
  {
    const int* ends = octahedron::EdgeVertices[e];
    edges[e] = level.OctEdges[12 * twin + octahedron::EdgeOf[local[ends[0]]][local[ends[1]]]];
  }
}

template <typename Id>
TetOctLevel<Id> MakeTetOctLevel(Level<Id>&& control)
{
  TetOctLevel<Id> level;
  level.Complex = std::move(control.Complex);
  level.Strata = std::move(control.Strata);
  level.NumberOfControlVertices = level.Complex.NumberOfVertices;
  level.EqualOcts = { Buffer<Id>(0), Buffer<Id>(0) };
  auto& edges = level.Strata.Edges;
  ForEach(edges.size(),
    [&](vtkIdType e) // edges that are regular for the box spline are not regular in this scheme
    {
      const bool regular = edges[e].GetRule() == Rule::RegularEdge;
      edges[e] = regular ? Stratum(Rule::Solid, edges[e].GetType()) : edges[e];
    });
  Buffer<Id> tetsAt(level.Complex.NumberOfEdges, Id(0));
  for (Id edge : level.Complex.TetEdges)
  {
    ++tetsAt[edge];
  }
  const Rings<Id>& rings = level.Strata.VertexRings;
  auto counts = std::make_shared<Buffer<Id>>(rings.Carriers.size());
  ForEach(counts->size(), [&](vtkIdType i) { (*counts)[i] = tetsAt[rings.Carriers[i]]; });
  level.TetsAtSpokes = counts;
  return level;
}

template <typename Id>
TetOctLevel<Id> Refine(const TetOctLevel<Id>& parent, Depth depth)
{
  return TetOctRefiner<Id>(parent, depth).Run();
}

SUBDIVISION_TETOCT_TEMPLATES(, int);
SUBDIVISION_TETOCT_TEMPLATES(, long long);

}
