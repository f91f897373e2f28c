// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SimplicialComplex.h
 * Vertices, edges, faces and tetrahedra of one level, and how they lie on each other.
 *
 * BuildComplex builds it from the control mesh by sorting; Refine (Refinement.h) then computes all
 * ids of children by arithmetic. The line cells are the first edges and the triangle cells the
 * first faces, in output order and with the vertex order of the cell; so are their children. Cells
 * that equal an earlier cell, their *twin*, are stored apart as *followers*: they change no rule
 * and are split like their twin. Here the word follower means these only (Mathematics 2 has more).
 */
#ifndef SubdivisionObjects_SimplicialComplex_h
#define SubdivisionObjects_SimplicialComplex_h

#include "Core/Memory/Buffer.h"
#include "Core/Memory/SimplexList.h"
#include "Core/Solids/Complex/Simplices.h"

namespace subdivision
{

/// The position of a value that is in the list. There are no branches, because the processor would
/// mispredict them.
template <int Size, typename Id>
int FindPlace(const Id* list, Id wanted)
{
  int place = 0;
  for (int i = 1; i < Size; ++i)
  {
    place += list[i] == wanted ? i : 0;
  }
  return place;
}

/// Cells that equal an earlier cell: their own vertex order, and their twin.
template <typename Id>
struct EqualCells
{
  Buffer<Id> Vertices; ///< dimension + 1 for each
  Buffer<Id> Twins;    ///< edge, face or tetrahedron
};

template <typename Id>
struct SimplicialComplex
{
  Id NumberOfVertices = 0;
  Id NumberOfEdges = 0;
  Id NumberOfFaces = 0;
  Id NumberOfTets = 0;
  Id NumberOfLineCells = 0;     ///< the first edges
  Id NumberOfTriangleCells = 0; ///< the first faces

  Buffer<Id> VertexCells;  ///< the vertex of each vertex cell
  Buffer<Id> EdgeVertices; ///< 2 for each edge
  Buffer<Id> FaceVertices; ///< 3 for each face
  Buffer<Id> FaceEdges;    ///< 3 for each face, as in triangle::EdgeVertices
  Buffer<Id> TetVertices;  ///< 4 for each tetrahedron
  Buffer<Id> TetEdges;     ///< 6 for each tetrahedron, as in tetrahedron::EdgeVertices
  Buffer<Id> TetFaces;     ///< 4 for each tetrahedron, opposite to its vertices
  Rows<Id> FaceTets;       ///< the tetrahedra at each face
  Rows<Id> EdgeFaces;      ///< the faces at each edge, where BuildComplex knew them; may be empty
  EqualCells<Id> EqualLines;
  EqualCells<Id> EqualTriangles;
  EqualCells<Id> EqualTets;

  /// Whether there is nothing but vertices and edges.
  bool HasEdgesAlone() const { return this->NumberOfFaces == 0 && this->NumberOfTets == 0; }
  Id GetOtherEnd(Id edge, Id vertex) const
  {
    const Id* ends = this->EdgeVertices.data() + 2 * edge;
    return ends[0] == vertex ? ends[1] : ends[0];
  }
  /// The local number of a vertex, edge or face in a face or tetrahedron that has it.
  int VertexInFace(Id face, Id vertex) const
  {
    return FindPlace<3>(this->FaceVertices.data() + 3 * face, vertex);
  }
  int EdgeInFace(Id face, Id edge) const
  {
    return FindPlace<3>(this->FaceEdges.data() + 3 * face, edge);
  }
  int FaceInTet(Id tet, Id face) const
  {
    return FindPlace<4>(this->TetFaces.data() + 4 * tet, face);
  }
  int VertexInTet(Id tet, Id vertex) const
  {
    return FindPlace<4>(this->TetVertices.data() + 4 * tet, vertex);
  }
  int EdgeInTet(Id tet, Id edge) const
  {
    return FindPlace<6>(this->TetEdges.data() + 6 * tet, edge);
  }
  /// The vertex of a face that does not lie on one of its edges.
  Id VertexOpposite(Id face, Id edge) const;
  /// The other edge of a face at a vertex.
  Id OtherEdge(Id face, Id edge, Id vertex) const;
};

/// Consecutive output cells of one dimension that are consecutive in the complex too. So runs tell
/// the order of the output without a table.
struct CellRun
{
  int Dimension = 0;
  bool Equal = false; ///< whether they are in EqualCells, where First then counts
  vtkIdType First = 0;
  vtkIdType Count = 0;
  vtkIdType FirstCell = 0;  ///< position of the first among all output cells
  vtkIdType FirstEntry = 0; ///< position of its first vertex in the connectivity
};

/// Builds the complex of the simplices. `runs` receives the order in which the output lists them.
template <typename Id>
SimplicialComplex<Id> BuildComplex(const SimplexList& simplices, std::vector<CellRun>& runs);

/// For each simplex in output order: the dimension of the maximal simplex that it is, or is a face
/// of; the largest if there are several.
template <typename Id>
Buffer<unsigned char> FindManifoldDimensions(
  const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs);

template <typename Id>
Id SimplicialComplex<Id>::OtherEdge(Id face, Id edge, Id vertex) const
{
  const int* edges = triangle::EdgesAt[this->VertexInFace(face, vertex)];
  const Id first = this->FaceEdges[3 * vtkIdType(face) + edges[0]];
  return first == edge ? this->FaceEdges[3 * vtkIdType(face) + edges[1]] : first;
}

template <typename Id>
Id SimplicialComplex<Id>::VertexOpposite(Id face, Id edge) const
{
  const Id* vertices = this->FaceVertices.data() + 3 * vtkIdType(face);
  const Id* edges = this->FaceEdges.data() + 3 * vtkIdType(face);
  return vertices[triangle::VertexOpposite[FindPlace<3>(edges, edge)]];
}

}

#endif
