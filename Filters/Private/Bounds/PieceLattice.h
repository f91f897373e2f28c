// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PieceLattice.h
 * The points of a cell after three steps, and the pieces that they split it into.
 */
#ifndef SubdivisionObjects_PieceLattice_h
#define SubdivisionObjects_PieceLattice_h

#include "Private/Bezier/PatchShape.h"

#include <array>
#include <vector>

namespace subdivision
{

struct PieceLattice
{
  static constexpr int Steps = 3;
  static constexpr int Divisions = 1 << Steps; ///< of an edge of the cell
  static constexpr int MostCorners = 4;
  using Weights = std::array<double, MostCorners>;
  /// Some corners of a cell, a bit for each. Those of a vertex, an edge, a face or all are a face.
  using Mask = unsigned;

  /// A point that a step makes in the middle of others; -1 behind the last one of these.
  struct Middle
  {
    int Point;
    std::array<int, MostCorners> Parents;
  };

  int Dimension = 0;
  int Corners = 1;
  std::vector<LatticePoint> Places;         ///< where each point is
  std::vector<Weights> Points;              ///< each as weights of the corners of the cell
  std::vector<Mask> Faces;                  ///< which face each point is inside of
  std::vector<std::vector<int>> Neighbours; ///< the points of the pieces at each point, itself too
  std::vector<int> Pieces;                  ///< the points of each piece, one after the other
  std::array<std::vector<Middle>, Steps + 1> Middles; ///< the points that each step makes
  /// Where the corners are, where the cell has one division.
  std::array<LatticePoint, MostCorners> CornerPlaces{};
  /// What the first step makes of the cell, on the lattice of twice as many divisions. The pieces
  /// of a child follow those of the child before.
  std::vector<LatticePart> Children;

  /// The one of a shape; -1: a vertex.
  static const PieceLattice& Get(int kind);

  int GetNumberOfPieces() const { return static_cast<int>(this->Pieces.size()) / this->Corners; }
  Mask GetWhole() const { return (1U << this->Corners) - 1U; }
  /// The smallest face that has some corners.
  Mask Close(Mask corners) const;
  /// The point at a place; -1 if there is none.
  int Find(const LatticePoint& place) const;
  int GetCornerPoint(int corner) const
  {
    const LatticePoint& unit = this->CornerPlaces[corner];
    return this->Find({ { Divisions * unit[0], Divisions * unit[1], Divisions * unit[2] } });
  }
  /// Where a point of a child is, on the lattice of twice as many divisions.
  LatticePoint GetPlaceInChild(int child, int point) const
  {
    return this->Children[child].At(this->Places[point], Divisions);
  }
  /// The step that makes a point; 0: it is a corner.
  int GetStep(int point) const;

private:
  static constexpr int Side = Divisions + 1;
  void AddPieces(const PatchShape& shape);
  void AddNeighbours();
  std::vector<Middle> ListMiddles(const PatchShape& shape, int step) const;
  static PieceLattice MakeVertex();
  static PieceLattice Make(const PatchShape& shape);

  std::vector<int> Numbers; ///< of the points, by their places
};

}

#endif
