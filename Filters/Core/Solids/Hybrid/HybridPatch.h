// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HybridPatch.h
 * Some cells of a level around a vertex or a cell, with all that its rules depend on, as numbers:
 * equal ones have the same rows and limit weights, and make a small level of their own.
 */
#ifndef SubdivisionObjects_HybridPatch_h
#define SubdivisionObjects_HybridPatch_h

#include "Core/Operators/LocalRows.h"
#include "Core/Operators/VertexRow.h"
#include "Core/Solids/Hybrid/HybridLevel.h"

#include <cstddef>
#include <vector>

namespace subdivision
{

/// A solid at a vertex, or a face without solids, or an edge without faces; or one cell of the
/// level. Lists are as in CellTable.
template <typename Id>
struct StarCell
{
  CellShape Shape;
  int Place; ///< of the vertex among its corners
  const Id* Corners;
  const Id* Edges;
  const Id* Faces;
  Id Centre;

  const CellTable& GetTable() const { return GetCellTable(this->Shape); }
  bool IsApex() const { return this->Shape == CellShape::Pyramid && this->Place == 4; }
};

/// The new point in which the child of a cell at its corner i has its corner j.
int GetMiddle(CellShape shape, int i, int j);

/// A cell of a complex at one of its corners.
template <typename Id>
StarCell<Id> GetStarCell(const CellComplex<Id>& complex, vtkIdType cell, Id vertex);

/// The number that a local point of a cell has after a step.
template <typename Id>
vtkIdType GetNewPoint(const CellComplex<Id>& complex, const StarCell<Id>& cell, int point);

template <typename Id>
class HybridPatch
{
public:
  /// The level must live as long.
  explicit HybridPatch(const HybridLevel<Id>& level)
    : Here(level)
  {
  }
  /// The cells at a vertex.
  void ReadStar(Id vertex);
  /// A cell, the cells that touch it, those that touch these, and so on.
  void ReadLayers(const StarCell<Id>& cell, int layers);

  /// Whether nothing that is not in Key changes the rules of the first step.
  bool IsPlain() const { return !this->HasSectors; }
  /// Whether rules at known vertices repeat from the next level on only.
  bool ChangesOnce() const { return this->Changes; }
  /// For how many more steps something is sharp at known vertices.
  double GetSharpSteps() const { return this->SharpSteps; }
  const CellComplex<Id>& GetComplex() const { return this->Here.Complex; }
  /// The cells alone as a level, in their order, whose vertices are Numbers. What has no known
  /// vertex has no rule.
  HybridLevel<Id> MakeLevel() const;

  std::vector<StarCell<Id>> Cells;
  VertexNumbers<Id> Numbers; ///< of the corners
  std::size_t Known = 1;     ///< of how many of these all cells are there: the first ones
  Neighbourhood Key;

private:
  void AddCellsAt(Id vertex);
  void ReadExceptions();
  void WriteKey();
  void WriteRules(const StarCell<Id>& cell, const HybridStrata<Id>& strata);
  void WriteVertices(const HybridStrata<Id>& strata);
  bool IsKnown(const StarCell<Id>& cell, int corner) const
  {
    return static_cast<std::size_t>(this->Numbers.Find(cell.Corners[corner])) < this->Known;
  }
  template <typename ActOnEdge, typename ActOnFace>
  void ForParts(const StarCell<Id>& cell, const ActOnEdge& onEdge, const ActOnFace& onFace) const;
  template <typename Act>
  void ForEdgesAtKnown(const Act& act) const;
  void CopyStrata(
    const HybridStrata<Id>& from, const CellComplex<Id>& complex, HybridStrata<Id>& strata) const;
  void CopySectors(
    const HybridStrata<Id>& from, const CellComplex<Id>& complex, HybridStrata<Id>& strata) const;
  void CopySharpness(HybridLevel<Id>& level) const;

  const HybridLevel<Id>& Here;
  double SharpSteps = 0.;
  bool HasSectors = false;
  bool Changes = false;
  std::vector<int> Codes;
};

}

#endif
