// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetOctLattice.h
 * The vertices of all levels of a tet/oct refinement and their rows, without making a level: what
 * BoxSplineLattice.h is for the box-spline scheme.
 *
 * All solids of the control level are parts of one regular lattice, each in coordinates of its own:
 * edges are (+-1, +-1, 0) and its permutations, and tetrahedra and octahedra lie between them. So
 * the solids at a vertex follow from its coordinates in the control solids at it, and its row from
 * their shares (TetOctMasks.h). Curves and boundaries have the rules of BoxSplineLattice.
 */
#ifndef SubdivisionObjects_TetOctLattice_h
#define SubdivisionObjects_TetOctLattice_h

#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Limits/BoxSplineLattice.h"

#include <array>
#include <vector>

namespace subdivision
{

/// The tetrahedra and octahedra at each vertex; octahedron o as NumberOfTets + o.
template <typename Id>
Rows<Id> ListSolidsAtVertices(const TetOctLevel<Id>& level);

/// A vertex inside an octahedron has coordinates along its three diagonals, which end at 2^level
/// and its negative, and 2^level as fourth weight; its simplex is NumberOfTets + octahedron.
/// Otherwise it is like BoxSplineLattice.
template <typename Id>
class TetOctLattice
{
public:
  using LevelRow = LatticeRow<Id>;

  /// All must outlive this. `level` and `strata` are as for BoxSplineLattice.
  TetOctLattice(const TetOctLevel<Id>& level, const subdivision::Strata<Id>& strata,
    const Rows<Id>& solidsAtVertices)
    : Here(level)
    , Strata(strata)
    , SolidsAt(solidsAtVertices)
    , Curved(level, strata)
  {
  }

  /// The vertex with some weights of the corners of a tetrahedron, none of which is negative, or
  /// with coordinates in an octahedron.
  LatticeVertex<Id> Find(Id solid, const LatticeWeights& weights) const;
  /// Finds vertices on curves and surfaces.
  const BoxSplineLattice<Id>& GetCurved() const { return this->Curved; }

  bool ReadRow(const LatticeVertex<Id>& vertex, LatticeRow<Id>& row) const;
  bool ReadLimit(const LatticeVertex<Id>& vertex, LatticeRow<Id>& row);
  bool AddStar(const LatticeVertex<Id>& vertex, LatticeStar<Id>& star) const;
  void AddStarInSolid(const LatticeVertex<Id>& vertex, Id solid, LatticeStar<Id>& star) const;

private:
  using Point = std::array<long long, 3>;
  /// A control solid, and how far its corners are away from each other.
  struct Frame
  {
    Id Solid;
    long long Size;
  };
  /// A tetrahedron or octahedron at a vertex, which comes first; then the opposite vertex in an
  /// octahedron; then neighbours, in an octahedron opposite ones side by side.
  struct Cell
  {
    std::array<Point, 6> Vertices;
    int Size;
    bool IsOct() const { return this->Size == 6; }
  };

  Rule GetRule(const LatticeVertex<Id>& vertex) const
  {
    return vertex.Dimension == 3 ? Rule::Solid : this->Curved.GetRule(vertex);
  }
  /// How far the corners of a control solid are away from each other.
  long long GetSize(const LatticeVertex<Id>& vertex) const
  {
    const LatticeWeights& weights = vertex.Weights;
    return vertex.Dimension == 3 && this->IsOct(vertex.Simplex)
      ? weights[3]
      : weights[0] + weights[1] + weights[2] + weights[3];
  }
  /// Vertices have an even sum in tetrahedra, and in octahedra one like the size.
  bool IsVertex(const Frame& frame, const Point& at) const
  {
    return (at[0] + at[1] + at[2] - (this->IsOct(frame.Solid) ? frame.Size : 0)) % 2 == 0;
  }
  bool IsOct(Id solid) const { return solid >= this->Here.Complex.NumberOfTets; }
  const Id* GetCorners(Id solid, int& size) const;
  Point Place(const LatticeVertex<Id>& vertex, Id solid) const;
  LatticeVertex<Id> FindAt(const Frame& frame, const Point& at) const;
  bool IsInside(const Frame& frame, const Point& at) const;
  template <typename Act>
  void ForSolids(const LatticeVertex<Id>& vertex, const Act& act) const;
  template <typename Act>
  void ForCells(const Frame& frame, const Point& at, const Act& act) const;
  int AddVertexShares(const Frame& frame, const Point& at, LatticeRow<Id>& row) const;
  int AddEdgeShares(
    const Frame& frame, const Point& first, const Point& second, LatticeRow<Id>& row) const;
  void AddRegularVertex(const Frame& frame, const Point& at, LatticeRow<Id>& row) const;
  void AddRegularEdge(const Frame& frame, const Point& first, const Point& second, int third,
    LatticeRow<Id>& row) const;
  std::array<Point, 2> FindEnds(const Frame& frame, const Point& at) const;
  int AddShares(const LatticeVertex<Id>& vertex, Id solid, LatticeRow<Id>& row) const;
  bool ReadBlend(const LatticeVertex<Id>& vertex, LatticeRow<Id>& row) const;
  void AddSpokes(const LatticeVertex<Id>& vertex, LatticeRow<Id>& row) const;
  void AddNeighbours(const LatticeVertex<Id>& vertex, Id solid, LatticeRow<Id>& row) const;
  void AddNeighboursOfEdge(const LatticeVertex<Id>& vertex, Id solid, LatticeRow<Id>& row) const;

  const TetOctLevel<Id>& Here;
  const subdivision::Strata<Id>& Strata;
  const Rows<Id>& SolidsAt;
  BoxSplineLattice<Id> Curved; ///< knows vertices of tetrahedra, and what lies not in solids
  LatticeLimits Limits;
};

}

#endif
