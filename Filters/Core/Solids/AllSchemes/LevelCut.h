// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LevelCut.h
 * The part of a level that some control simplices have become, for a last step of these alone.
 *
 * The last step makes seven of eight points. Where a mesh has cells that only tell the rules of
 * others, they are cut off before it. Ids in the part are those that the part of the control mesh
 * would have alone, so that all arithmetic of ids holds in it. But rings keep members beyond the
 * part: these are columns of its operator that come after its vertices.
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

  /// `level` is `steps` steps after the control level.
  LevelCut(const Level& level, const ControlParts& parts, int steps);

  /// The part of a level with the same complex, for one step with Depth::ForOutput. Its rings have
  /// no carriers.
  Level Cut(const Level& level) const;
  /// Of cells in `runs` those that are kept and, if `wanted` has flags, one for each control
  /// simplex in `runs`, that are wanted.
  std::vector<CellRun> Cut(const std::vector<CellRun>& runs, const std::vector<char>& wanted) const;
  /// Of rows of vertices and edges those that are kept.
  std::vector<SharpRow> Cut(const std::vector<SharpRow>& rows) const;
  /// Copies values at the vertices of the level to the columns of the part.
  SparseRows<Id> TakeColumns() { return std::move(this->Columns); }

private:
  Selection<Id> SelectParts(
    const ControlParts& parts, vtkIdType size, std::vector<IdSegment> segments) const;
  Selection<Id> SelectEqual(const EqualCells<Id>& equal, const Selection<Id>& twins) const;
  EqualCells<Id> CutEqual(const EqualCells<Id>& equal, int size, const Selection<Id>& selected,
    const Selection<Id>& twins) const;
  void MakeColumns();
  Rings<Id> CutRings(const Rings<Id>& rings, const Selection<Id>& owners) const;
  void CutSolids(const subdivision::Level<Id>&, subdivision::Level<Id>&) const {}
  void CutSolids(const TetOctLevel<Id>& level, TetOctLevel<Id>& part) const;
  Id GetNewNumber(const CellRun& run, vtkIdType i) const;

  int Steps;
  Selection<Id> Vertices;
  Selection<Id> Edges;
  Selection<Id> Faces; ///< of triangle cells
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
