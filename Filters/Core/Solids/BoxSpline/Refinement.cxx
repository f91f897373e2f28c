// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/BoxSpline/Refinement.h"

#include "Core/Solids/BoxSpline/Refiner.h"

namespace subdivision
{
namespace
{

constexpr auto MakeInteriorFaceEdges()
{
  std::array<std::array<tetrahedron::ChildEdge, 3>, 8> table{};
  for (int face = 0; face < 8; ++face)
  {
    const int* edges = tetrahedron::InteriorFaces[face].Edges;
    for (int i = 0; i < 3; ++i)
    {
      table[face][i] = tetrahedron::ClassifyEdge(
        4 + edges[triangle::EdgeVertices[i][0]], 4 + edges[triangle::EdgeVertices[i][1]]);
    }
  }
  return table;
}
constexpr auto InteriorFaceEdges = MakeInteriorFaceEdges();

}

template <typename Id>
Level<Id> Refiner<Id>::Run()
{
  this->Count();
  this->MakeEdges();
  this->MakeFaces();
  this->MakeTets();
  this->MakeEqualCells();
  this->MakeRings();
  return std::move(this->Child);
}

template <typename Id>
void Refiner<Id>::Count()
{
  const auto& parent = this->Parent;
  auto& child = this->Child.Complex;
  child.NumberOfVertices = parent.NumberOfVertices + parent.NumberOfEdges;
  child.NumberOfEdges = 2 * parent.NumberOfEdges + 3 * parent.NumberOfFaces + parent.NumberOfTets;
  child.NumberOfTets = 8 * parent.NumberOfTets;
  child.NumberOfLineCells = 2 * parent.NumberOfLineCells;
  child.NumberOfTriangleCells = 4 * parent.NumberOfTriangleCells;
  child.NumberOfFaces =
    this->Full ? 4 * parent.NumberOfFaces + 8 * parent.NumberOfTets : child.NumberOfTriangleCells;
  child.VertexCells = Buffer<Id>(parent.VertexCells.size());
  std::copy(parent.VertexCells.begin(), parent.VertexCells.end(), child.VertexCells.begin());
}

/// Edges, and the strata of edges and vertices.
template <typename Id>
void Refiner<Id>::MakeEdges()
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
  ForEach(parent.NumberOfTets,
    [&](vtkIdType t)
    {
      const vtkIdType edge = this->Ids.Diagonal(static_cast<Id>(t));
      this->Emitter.GetDiagonalEnds(static_cast<Id>(t), ends.data() + 2 * edge);
      strata.Edges[edge] = Stratum(Rule::RegularEdge);
    });
}

template <typename Id>
void Refiner<Id>::MakeFaces()
{
  const auto& parent = this->Parent;
  auto& child = this->Child.Complex;
  const vtkIdType split = this->Full ? parent.NumberOfFaces : parent.NumberOfTriangleCells;
  child.FaceVertices = Buffer<Id>(3 * vtkIdType(child.NumberOfFaces));
  child.FaceEdges = Buffer<Id>(3 * vtkIdType(child.NumberOfFaces));
  if (this->Full)
  {
    this->Child.Strata.Faces = Buffer<Stratum>(child.NumberOfFaces);
    child.FaceTets.Offsets = Buffer<Id>(vtkIdType(child.NumberOfFaces) + 1);
  }
  ForEach(split,
    [&](vtkIdType i)
    {
      const Id f = static_cast<Id>(i);
      const TriangleChildren<Id> children(parent, this->Ids, f);
      std::copy_n(children.Vertices, 12, child.FaceVertices.data() + 12 * i);
      std::copy_n(children.Edges, 12, child.FaceEdges.data() + 12 * i);
      for (int c = 0; c < 4 && this->Full; ++c)
      {
        this->Child.Strata.Faces[4 * i + c] = this->Strata.Faces[i];
        child.FaceTets.Offsets[4 * i + c] = static_cast<Id>(parent.FaceTets[f].size());
      }
    });
  if (this->Full)
  {
    this->MakeInteriorFaces();
  }
}

/// The faces inside tetrahedra; then which tetrahedra lie at each face.
template <typename Id>
void Refiner<Id>::MakeInteriorFaces()
{
  const auto& parent = this->Parent;
  auto& child = this->Child.Complex;
  ForEach(parent.NumberOfTets,
    [&](vtkIdType i)
    {
      const Id t = static_cast<Id>(i);
      const TetParts<Id> parts(parent, this->Ids, t);
      for (int k = 0; k < 8; ++k)
      {
        const vtkIdType face = this->Ids.Interior(t, k);
        for (int j = 0; j < 3; ++j)
        {
          child.FaceVertices[3 * face + j] =
            parts.Lattice[4 + tetrahedron::InteriorFaces[k].Edges[j]];
          child.FaceEdges[3 * face + j] = parts.GetEdge(InteriorFaceEdges[k][j], this->Ids);
        }
        this->Child.Strata.Faces[face] = Stratum(Rule::Solid);
        child.FaceTets.Offsets[face] = 2;
      }
    });
  CountsToOffsets(child.FaceTets.Offsets);
  child.FaceTets.Items = Buffer<Id>(child.FaceTets.Offsets[child.NumberOfFaces]);
  ForEach(parent.NumberOfFaces,
    [&](vtkIdType i)
    {
      const Id f = static_cast<Id>(i);
      vtkIdType place = 0;
      for (Id tet : parent.FaceTets[f])
      {
        for (int corner = 0; corner < 3; ++corner)
        {
          const int local = parent.VertexInTet(tet, parent.FaceVertices[3 * i + corner]);
          child.FaceTets.Items[child.FaceTets.Offsets[4 * i + corner] + place] =
            this->Ids.Tet(tet, local);
        }
        child.FaceTets.Items[child.FaceTets.Offsets[4 * i + 3] + place] =
          this->Ids.Tet(tet, tetrahedron::MiddleChildren[parent.FaceInTet(tet, f)]);
        ++place;
      }
    });
  ForEach(parent.NumberOfTets,
    [&](vtkIdType i)
    {
      const Id t = static_cast<Id>(i);
      for (int k = 0; k < 8; ++k)
      {
        Id* tets = child.FaceTets.Items.data() + child.FaceTets.Offsets[this->Ids.Interior(t, k)];
        tets[0] = this->Ids.Tet(t, tetrahedron::InteriorFaces[k].Tets[0]);
        tets[1] = this->Ids.Tet(t, tetrahedron::InteriorFaces[k].Tets[1]);
      }
    });
}

template <typename Id>
void Refiner<Id>::MakeTets()
{
  const auto& parent = this->Parent;
  auto& child = this->Child.Complex;
  child.TetVertices = Buffer<Id>(4 * vtkIdType(child.NumberOfTets));
  child.TetEdges = Buffer<Id>(6 * vtkIdType(child.NumberOfTets));
  child.TetFaces = Buffer<Id>(this->Full ? 4 * vtkIdType(child.NumberOfTets) : 0);
  ForEach(parent.NumberOfTets,
    [&](vtkIdType i)
    {
      const TetParts<Id> parts(parent, this->Ids, static_cast<Id>(i));
      const TetChildren<Id> children(parts, this->Ids);
      std::copy_n(children.Vertices, 32, child.TetVertices.data() + 32 * i);
      std::copy_n(children.Edges, 48, child.TetEdges.data() + 48 * i);
      if (this->Full)
      {
        Id* faces = child.TetFaces.data() + 32 * i;
        for (int c = 0; c < 8; ++c)
        {
          for (int k = 0; k < 4; ++k)
          {
            *faces++ = parts.GetFace(tetrahedron::ChildFaces[c][k], this->Ids);
          }
        }
      }
    });
}

template <typename Id>
void Refiner<Id>::MakeEqualCells()
{
  RefineEqualLinesAndTriangles(this->Parent, this->Child.Complex);
  this->MakeEqualTets();
}

template <typename Id>
void Refiner<Id>::MakeEqualTets()
{
  const auto& parent = this->Parent;
  auto& child = this->Child.Complex;
  const vtkIdType tets = parent.EqualTets.Twins.size();
  child.EqualTets = { Buffer<Id>(32 * tets), Buffer<Id>(8 * tets) };
  for (vtkIdType i = 0; i < tets; ++i)
  {
    const Id tet = parent.EqualTets.Twins[i];
    Id lattice[10];
    GetEdgesOfEqualTet(parent, i, lattice + 4);
    std::copy_n(parent.EqualTets.Vertices.data() + 4 * i, 4, lattice);
    for (int k = 0; k < 6; ++k)
    {
      lattice[4 + k] = this->Ids.Midpoint(lattice[4 + k]);
    }
    for (int c = 0; c < 8; ++c)
    {
      Id* out = child.EqualTets.Vertices.data() + 32 * i + 4 * c;
      for (int k = 0; k < 4; ++k)
      {
        out[k] = lattice[tetrahedron::Children[c][k]];
      }
      int twin = 7; // equal tetrahedra mark the same edges, so one of the eight is found
      while (twin > 0 &&
        !std::is_permutation(
          out, out + 4, child.TetVertices.data() + 4 * vtkIdType(this->Ids.Tet(tet, twin))))
      {
        --twin;
      }
      child.EqualTets.Twins[8 * i + c] = this->Ids.Tet(tet, twin);
    }
  }
}

template class Refiner<int>;
template class Refiner<long long>;

template <typename Id>
Level<Id> Refine(const Level<Id>& parent, Depth depth)
{
  return Refiner<Id>(parent, depth).Run();
}

/// The tables give the vertices of a child of an equal cell; its twin is the child of the parent's
/// twin that has the same vertices.
template <typename Id>
void RefineEqualLinesAndTriangles(const SimplicialComplex<Id>& parent, SimplicialComplex<Id>& child)
{
  const ChildIds<Id> ids(parent);
  const vtkIdType lines = parent.EqualLines.Twins.size();
  child.EqualLines = { Buffer<Id>(4 * lines), Buffer<Id>(2 * lines) };
  for (vtkIdType i = 0; i < lines; ++i)
  {
    const Id edge = parent.EqualLines.Twins[i];
    const Id* ends = parent.EqualLines.Vertices.data() + 2 * i;
    const Id out[4] = { ends[0], ids.Midpoint(edge), ids.Midpoint(edge), ends[1] };
    std::copy(out, out + 4, child.EqualLines.Vertices.data() + 4 * i);
    child.EqualLines.Twins[2 * i] = ids.Half(edge, ends[0]);
    child.EqualLines.Twins[2 * i + 1] = ids.Half(edge, ends[1]);
  }
  const vtkIdType triangles = parent.EqualTriangles.Twins.size();
  child.EqualTriangles = { Buffer<Id>(12 * triangles), Buffer<Id>(4 * triangles) };
  for (vtkIdType i = 0; i < triangles; ++i)
  {
    const Id face = parent.EqualTriangles.Twins[i];
    Id lattice[6];
    GetEdgesOfEqualTriangle(parent, i, lattice + 3);
    for (int k = 0; k < 3; ++k)
    {
      lattice[k] = parent.EqualTriangles.Vertices[3 * i + k];
      lattice[3 + k] = ids.Midpoint(lattice[3 + k]);
    }
    for (int c = 0; c < 4; ++c)
    {
      child.EqualTriangles.Twins[4 * i + c] =
        ids.Face(face, c == 3 ? 3 : parent.VertexInFace(face, lattice[c]));
      for (int k = 0; k < 3; ++k)
      {
        child.EqualTriangles.Vertices[12 * i + 3 * c + k] = lattice[triangle::Children[c][k]];
      }
    }
  }
}

template <typename Id>
void GetEdgesOfEqualTet(const SimplicialComplex<Id>& complex, vtkIdType index, Id edges[6])
{
  const Id twin = complex.EqualTets.Twins[index];
  int local[4];
  for (int i = 0; i < 4; ++i)
  {
    local[i] = complex.VertexInTet(twin, complex.EqualTets.Vertices[4 * index + i]);
  }
  for (int e = 0; e < 6; ++e)
  {
    const int* ends = tetrahedron::EdgeVertices[e];
    edges[e] =
      complex.TetEdges[6 * vtkIdType(twin) + tetrahedron::EdgeOf[local[ends[0]]][local[ends[1]]]];
  }
}

template <typename Id>
void GetEdgesOfEqualTriangle(const SimplicialComplex<Id>& complex, vtkIdType index, Id edges[3])
{
  const Id twin = complex.EqualTriangles.Twins[index];
  for (int e = 0; e < 3; ++e)
  {
    const Id opposite = complex.EqualTriangles.Vertices[3 * index + triangle::VertexOpposite[e]];
    edges[e] = complex.FaceEdges[3 * vtkIdType(twin) +
      triangle::EdgeOpposite[complex.VertexInFace(twin, opposite)]];
  }
}

SUBDIVISION_REFINEMENT_TEMPLATES(, int);
SUBDIVISION_REFINEMENT_TEMPLATES(, long long);

}
