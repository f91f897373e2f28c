// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LevelCut.h
 * The part of a level that some control simplices have become, for last steps of these alone.
 *
 * The last step makes seven of eight points. Where a mesh has cells that only tell the rules of
 * others, they are cut off before it. The part of the control mesh alone would have the same ids,
 * so that all arithmetic of ids holds in the part.
 *
 * Before one step, rings are cut too, but keep members beyond the part: these are columns of its
 * operator that come after its vertices. Before two steps at once, the operator of the last one is
 * made from the whole level, for the children of the part alone (ChildRows.h).
 */
#ifndef SubdivisionObjects_LevelCut_h
#define SubdivisionObjects_LevelCut_h

#include "Core/Memory/Selection.h"
#include "Core/Operators/SparseRows.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Scheme/SemiSharp.h"

#include <array>
#include <utility>
#include <vector>

namespace subdivision
{

/// Flags of the vertices, edges, faces and tetrahedra of a control mesh that are kept, with all
/// their faces.
struct ControlParts
{
  std::array<std::vector<char>, 4> Kept;
};

template <typename Scheme>
class LevelCut
{
public:
  using Id = typename Scheme::Id;
  using Level = typename Scheme::Level;

  using ChildRows = typename Scheme::ChildRows;

  /// `level` is `steps` steps after the control level, and `further` before the last.
  LevelCut(const Level& level, const ControlParts& parts, int steps, int further);

  /// The part of a level with the same complex. Before one step it is for Depth::ForOutput, and its
  /// rings have no carriers; before two it has no rings.
  Level Cut(const Level& level) const;
  /// The simplices that ChildRows makes rows of, before two steps; `part`: of Cut.
  typename ChildRows::Selected SelectChildren(const Level& part) const;
  /// The number in the level of a vertex of the part, and how many there are.
  vtkIdType GetVertex(vtkIdType vertex) const { return this->Vertices.Old[vertex]; }
  vtkIdType GetNumberOfVertices() const { return this->Vertices.Old.size(); }
  /// The cells in `runs` that are kept and, if `wanted` has flags, one for each control simplex in
  /// `runs`, that are wanted.
  std::vector<CellRun> Cut(const std::vector<CellRun>& runs, const std::vector<char>& wanted) const;
  /// The kept ones among rows of vertices and edges.
  std::vector<SharpRow> Cut(const std::vector<SharpRow>& rows) const;
  /// Copies values at the vertices of the level to the columns of the part.
  SparseRows<Id> TakeColumns() { return std::move(this->Columns); }

private:
  Selection<Id> SelectParts(
    const ControlParts& parts, vtkIdType size, std::vector<IdSegment> segments) const;
  Selection<Id> SelectEqual(const EqualCells<Id>& equal, const Selection<Id>& twins) const;
  EqualCells<Id> CutEqual(const EqualCells<Id>& equal, int size, const Selection<Id>& selected,
    const Selection<Id>& twins) const;
  void SelectFaces(const Level& level, const ControlParts& parts);
  void MakeColumns();
  Rings<Id> CutRings(const Rings<Id>& rings, const Selection<Id>& owners) const;
  void CutSolids(const subdivision::Level<Id>&, subdivision::Level<Id>&) const {}
  void CutSolids(const TetOctLevel<Id>& level, TetOctLevel<Id>& part) const;
  void CutRings(const Level& level, Level& part) const;
  void CutCounts(const subdivision::Level<Id>&, subdivision::Level<Id>&) const {}
  void CutCounts(const TetOctLevel<Id>& level, TetOctLevel<Id>& part) const;
  Id GetNewNumber(const CellRun& run, vtkIdType i) const;

  int Steps;
  int Further;
  Selection<Id> Vertices;
  Selection<Id> Edges;
  Selection<Id> Faces; ///< before one step: of triangle cells
  Selection<Id> Tets;
  Selection<Id> Octs;
  Selection<Id> VertexCells;
  Selection<Id> EqualLines;
  Selection<Id> EqualTriangles;
  Selection<Id> EqualTets;
  Buffer<Id> ColumnOf; ///< of each vertex of the level
  SparseRows<Id> Columns;
};

}

#endif
