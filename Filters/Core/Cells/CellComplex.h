// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellComplex.h
 * Vertices, edges, faces and solids of one level of a mesh of cells of all types, and how they lie
 * on each other.
 *
 * A face is a cycle of three or four vertices. Quads come before triangles, and edges, quads and
 * triangles ascend by their sorted vertices (Mathematics 15). A solid with all faces of an earlier
 * one, its twin, is no part of the complex; it is split like its twin.
 */
#ifndef SubdivisionObjects_CellComplex_h
#define SubdivisionObjects_CellComplex_h

#include "Core/Cells/CellShapes.h"
#include "Core/Memory/Buffer.h"

#include <vector>

namespace subdivision
{

/// Cells in the order of the output, with a number of points that they may name.
template <typename Id>
struct CellList
{
  vtkIdType NumberOfPoints = 0;
  Buffer<CellShape> Shapes;
  Buffer<Id> Offsets; ///< of the corners of each cell; one more than cells
  Buffer<Id> Corners;

  vtkIdType GetNumberOfCells() const { return this->Shapes.size(); }
  const Id* GetCorners(vtkIdType cell) const { return this->Corners.data() + this->Offsets[cell]; }
  const CellTable& GetTable(vtkIdType cell) const { return GetCellTable(this->Shapes[cell]); }
};

template <typename Id>
struct CellComplex
{
  Id NumberOfVertices = 0;
  Id NumberOfEdges = 0;
  Id NumberOfFaces = 0;
  Id NumberOfQuads = 0;         ///< the first faces
  Id NumberOfTets = 0;          ///< solids, without twins
  Id NumberOfLineCells = 0;     ///< lines among the cells
  Id NumberOfTriangleCells = 0; ///< polygons among the cells
  Id NumberOfCentres = 0;

  CellList<Id> Cells;
  Rows<Id> CellEdges;     ///< of all cells, as in CellTable
  Rows<Id> CellFaces;     ///< of polygons and solids
  Buffer<Id> Centres;     ///< of each cell, or -1
  Buffer<Id> CentreCells; ///< the cell of each centre
  Buffer<Id> Twins;       ///< of each cell, or -1; empty: there are none

  Buffer<Id> EdgeVertices; ///< 2 for each edge, ascending
  Buffer<Id> FaceVertices; ///< in cyclic order, see GetFirst
  Buffer<Id> FaceEdges;    ///< edge i goes from vertex i to the next one
  Buffer<Id> EdgeFirsts;   ///< the first entry of CellEdges that has each edge
  Buffer<Id> FaceFirsts;   ///< the same of CellFaces
  Rows<Id> FaceSolids;     ///< cells
  Rows<Id> EdgeFaces;
  Rows<Id> EdgeSolids;
  Rows<Id> VertexEdges;
  Rows<Id> VertexSolids;

  bool HasEdgesAlone() const { return this->NumberOfFaces == 0; }
  int GetSize(Id face) const { return face < this->NumberOfQuads ? 4 : 3; }
  /// Where vertices and edges of a face begin.
  vtkIdType GetFirst(Id face) const
  {
    return 3 * vtkIdType(face) + std::min(vtkIdType(face), vtkIdType(this->NumberOfQuads));
  }
  Row<Id> GetVertices(Id face) const
  {
    const Id* first = this->FaceVertices.data() + this->GetFirst(face);
    return { first, first + this->GetSize(face) };
  }
  Row<Id> GetEdges(Id face) const
  {
    const Id* first = this->FaceEdges.data() + this->GetFirst(face);
    return { first, first + this->GetSize(face) };
  }
  Id GetOtherEnd(Id edge, Id vertex) const
  {
    const Id* ends = this->EdgeVertices.data() + 2 * vtkIdType(edge);
    return ends[0] == vertex ? ends[1] : ends[0];
  }
  bool IsTwin(vtkIdType cell) const { return !this->Twins.empty() && this->Twins[cell] >= 0; }
  /// Frees all but the cells with their edges, faces and centres, of which children are made.
  void ForgetIncidences();
  /// The edge of two vertices, or -1.
  Id FindEdge(Id a, Id b) const;
  /// Points after a step: vertices, edges, quads, centres.
  vtkIdType GetNumberOfNewPoints() const
  {
    return vtkIdType(this->NumberOfVertices) + this->NumberOfEdges + this->NumberOfQuads +
      this->NumberOfCentres;
  }
};

template <typename Id>
CellComplex<Id> BuildCellComplex(CellList<Id> cells);

/// The same for the children of all cells of a complex, in less time: each edge and face of a child
/// lies in one edge, face or solid of the complex, so that each comes once.
template <typename Id>
CellComplex<Id> RefineCellComplex(const CellComplex<Id>& complex);

/// The children of all cells; the children of one cell follow each other.
template <typename Id>
CellList<Id> SplitCells(const CellComplex<Id>& complex);

/// Writes the point that each local point of a cell is after a step.
template <typename Id>
void FindPointsOfStep(const CellComplex<Id>& complex, vtkIdType cell, Id* points);

/// Where the children of each cell begin; one more than cells.
template <typename Id>
Buffer<Id> FindFirstChildren(const CellList<Id>& cells);

/// Gives values of cells to their parts: the parts of cell c begin at first[c].
template <typename Id, typename Value>
std::vector<Value> GiveTo(const Buffer<Id>& first, const std::vector<Value>& values)
{
  std::vector<Value> given(values.empty() ? 0 : static_cast<std::size_t>(first[first.size() - 1]));
  ForEach(static_cast<vtkIdType>(values.size()),
    [&](vtkIdType c)
    {
      std::fill(given.begin() + first[c], given.begin() + first[c + 1],
        values[static_cast<std::size_t>(c)]);
    });
  return given;
}

// What Links.h asks of a complex.

template <typename Id>
vtkIdType GetLeastCycle(const CellComplex<Id>&)
{
  return 2;
}
template <typename Id>
Row<Id> GetSolidsAt(const CellComplex<Id>& complex, Id face)
{
  return complex.FaceSolids[face];
}
template <typename Id>
Id GetOtherEdge(const CellComplex<Id>& complex, Id face, Id edge, Id vertex, Id)
{
  const Row<Id> edges = complex.GetEdges(face);
  const Row<Id> vertices = complex.GetVertices(face);
  const vtkIdType size = edges.size();
  const vtkIdType i = std::find(vertices.begin(), vertices.end(), vertex) - vertices.begin();
  const Id next = edges.begin()[i];
  return next == edge ? edges.begin()[(i + size - 1) % size] : next;
}
template <typename Id>
Id GetOppositeVertex(const CellComplex<Id>& complex, Id face, Id edge)
{
  const Row<Id> edges = complex.GetEdges(face);
  const vtkIdType i = std::find(edges.begin(), edges.end(), edge) - edges.begin();
  return edges.size() == 3 ? complex.GetVertices(face).begin()[(i + 2) % 3] : Id(-1);
}
template <typename Id>
Id GetOtherFace(const CellComplex<Id>& complex, Id solid, Id face, Id edge)
{
  for (const Id other : complex.CellFaces[solid])
  {
    const Row<Id> edges = complex.GetEdges(other);
    if (other != face && std::find(edges.begin(), edges.end(), edge) != edges.end())
    {
      return other;
    }
  }
  return -1;
}
template <typename Id>
vtkIdType CountSolidsAt(const CellComplex<Id>& complex, Id vertex, vtkIdType, vtkIdType)
{
  return complex.VertexSolids[vertex].size();
}

}

#endif
