// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PieceLattice.h
 * The points of a cell after three steps, and the pieces that they split it into. For sqrt(3) a
 * step stands for two of the scheme, which cut edges into thirds; the first one does nothing.
 */
#ifndef SubdivisionObjects_PieceLattice_h
#define SubdivisionObjects_PieceLattice_h

#include "Private/Bezier/PatchShape.h"

#include <array>
#include <map>
#include <vector>

namespace subdivision
{

struct PieceLattice
{
  static constexpr int Steps = 3;
  static constexpr int Divisions = 1 << Steps; ///< of an edge of a cell that is halved
  static constexpr int DivisionsInThirds = 9;
  static constexpr int MostCorners = 4;
  using Weights = std::array<double, MostCorners>;
  /// Some corners of a cell, a bit for each. A vertex, an edge, a face and the cell are faces.
  using Mask = unsigned;

  /// A point that a step makes in the middle of others, one of which may be there twice; -1 behind
  /// the last one of these.
  struct Middle
  {
    int Point;
    std::array<int, MostCorners> Parents;
  };

  int Dimension = 0;
  int Corners = 1;
  int Cuts = 2;                  ///< the parts into which a step cuts an edge
  int Size = Divisions;          ///< the divisions of an edge of this cell
  std::vector<FrameNode> Places; ///< where each point is
  std::vector<Weights> Points;   ///< each as weights of the corners of the cell
  std::vector<Mask> Faces;       ///< which face each point is inside of
  /// Of each point: itself, and the points that have a piece (in a tet/oct solid, one of its
  /// solids) in common with it. They may lie in other quarters: point p of the quarter that is k
  /// further on has the number p + k times the number of points of a quarter.
  std::vector<std::vector<int>> Neighbours;
  std::vector<int> Pieces; ///< the points of each piece, one after the other
  std::array<std::vector<Middle>, Steps + 1> Middles; ///< the points that each step makes
  /// Where the corners are, where the cell has one division.
  std::array<FrameNode, MostCorners> CornerPlaces{};
  std::array<int, MostCorners> CornerPoints{};
  /// The parts into which the first step that cuts the cell cuts it, on a lattice with `Cuts` times
  /// as many divisions. Pieces come child by child.
  std::vector<LatticePart> Children;
  std::vector<int> ChildKinds;
  /// Of a tet/oct solid: its points, and the points of all quarters of its octahedron, by their
  /// places in it (TetOctPieces), numbered as in Neighbours.
  std::map<FrameNode, int> PointsOfSolid;

  /// A child of a quarter: how many quarters further on it is, and its number there.
  struct QuarterChild
  {
    int Quarter;
    int Child;
  };
  /// The four children that one octahedron of the next level is written as, in the order of kinds;
  /// empty if a child is a tetrahedron.
  std::vector<QuarterChild> ListOctahedron(int child) const;

  /// A kind is a PatchShape::Kind, -1 for a vertex, or one of these: with edges cut into thirds, or
  /// of the tet/oct scheme, a tetrahedron, or a quarter of an octahedron, whose four kinds follow
  /// each other.
  enum OtherKind : int
  {
    CurveInThirds = PatchShape::NumberOfKinds,
    TriangleInThirds,
    TetOctTetrahedron,
    FirstQuarter,
    NumberOfKinds = FirstQuarter + 4
  };
  static const PieceLattice& Get(int kind);

  /// Whether a neighbour is one of its own points.
  bool Has(int neighbour) const { return neighbour >= 0 && neighbour < this->CountPoints(); }
  int CountPoints() const { return static_cast<int>(this->Places.size()); }
  int GetNumberOfPieces() const { return static_cast<int>(this->Pieces.size()) / this->Corners; }
  Mask GetWhole() const { return (1U << this->Corners) - 1U; }
  bool IsQuad() const { return this->Corners > this->Dimension + 1; }
  /// The smallest face that has some corners.
  Mask Close(Mask corners) const;
  /// A place on a lattice of so many divisions as weights of the corners.
  Weights WeighCorners(const FrameNode& place, int divisions) const;
  /// The point at a place; -1 if there is none.
  int Find(const FrameNode& place) const;
  /// Where a point of a child is, on the lattice of the children.
  FrameNode GetPlaceInChild(int child, int point) const
  {
    return this->Children[child].At(this->Places[point], this->Size);
  }
  /// The point of the cell that a point of a child is; -1 if the cell does not have it yet.
  int FindOfChild(int child, int point) const;
  /// Where a point is in a solid of the tet/oct scheme (TetOctPieces).
  FrameNode GetPlaceInSolid(int point) const
  {
    return this->GetPlaceInQuarter(this->Quarter, point);
  }
  /// The step that makes a point. Corners are there before the first step that cuts the cell.
  int GetStep(int point) const;

private:
  int AddPoint(const FrameNode& place);
  void AddPoints(const std::vector<LatticePart>& pieces);
  void AddNeighbours();
  void AddNeighboursInSolids();
  void AddMiddles(
    int step, const std::vector<LatticePart>& parts, const std::vector<LatticePart>& children);
  static PieceLattice Make(int kind);
  void TurnChildren();
  FrameNode GetPlaceInQuarter(int quarter, int point) const;

  int Quarter = -1;         ///< of an octahedron; -1: it is none
  std::vector<int> Numbers; ///< of the points, by their places
};

}

#endif
