// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LatticeRing.h
 * The order in which levels of the box-spline scheme list the rings of a vertex and of the edge in
 * whose middle it first is, as steps on a lattice (BoxSplineLattice.h).
 *
 * The ring of a vertex follows from that of its edge, and the ring of the edge from where edges of
 * its line first are: on the control mesh, in a face, or along the diagonal of a tetrahedron.
 * Halves of edges, and what lies at them, repeat it (RingEmitter.h, BoxSplineSplit.h). So the order
 * is found by going down, by the tables of the split, to the face or the tetrahedron that the line
 * cuts.
 */
#ifndef SubdivisionObjects_LatticeRing_h
#define SubdivisionObjects_LatticeRing_h

#include "Core/Solids/Limits/BoxSplineLattice.h"
#include "Core/Solids/Limits/LimitRowMaker.h"

#include <array>
#include <vector>

namespace subdivision
{

/// A difference of weights of corners, and corners of a triangle or tetrahedron by their
/// differences from some point.
using LatticeStep = std::array<signed char, 4>;
using LatticeCorners = std::array<LatticeStep, 4>;
constexpr LatticeCorners LatticeUnits = { { { { 1, 0, 0, 0 } }, { { 0, 1, 0, 0 } },
  { { 0, 0, 1, 0 } }, { { 0, 0, 0, 1 } } } };

/// Around vertices, in steps of the level on which they first are.
struct LatticeRing
{
  /// A simplex that has the one inside of which the vertex lies, and which of its corners those
  /// are.
  struct Chart
  {
    int Dimension;
    vtkIdType Simplex;
    std::array<int, 4> Places;
  };
  struct Step
  {
    int Chart; ///< -1: the simplex inside of which the vertex lies
    LatticeStep Change;
  };

  bool IsRegular = false; ///< whether an edge inside solids follows Rule::RegularEdge
  std::vector<Chart> Charts;
  std::vector<Step> Vertex;  ///< to the ring of the vertex; the first two to the ends of its edge
  std::vector<Step> Edge;    ///< to the ring of the edge
  std::vector<double> Limit; ///< weights, once they are known

  // They add in the order of RingEmitter::EmitAtEdge.

  void AddEnds(const LatticeStep& first, const LatticeStep& second);
  /// A face at the edge, by the two ends and its third vertex.
  void AddFace(
    int chart, const LatticeStep& first, const LatticeStep& second, const LatticeStep& third);
  /// Behind it the diagonal that ends on the edge in a tetrahedron at the face, if there is one and
  /// it was not added behind another face; by local numbers of the same vertices.
  void AddDiagonal(int chart, const LatticeCorners& tet, int first, int second, int third);
};

/// The face that the line of an edge cuts, with the tetrahedra at it, or the tetrahedron whose
/// diagonal it is along.
class LatticeCut
{
public:
  using Weights = std::array<long long, 4>;

  /// Starts from a face of the control mesh, and goes down to what is cut by the edge whose middle
  /// has the weights `at`. Each of `charts` has a tetrahedron at the face.
  void FindInFace(const Weights& at, const std::vector<LatticeRing::Chart>& charts);
  /// The same from a tetrahedron.
  void FindInTet(Weights at);

  /// Numbers that tell rings apart which start from the same simplex.
  void AppendKey(Neighbourhood& key) const;
  /// What is around the edge. The charts are there.
  void AddTo(LatticeRing& ring) const;

private:
  struct Side
  {
    int Chart;
    LatticeCorners Corners;
    std::array<int, 3> Places; ///< which of them are those of the face
  };

  void StartOnInnerFace(int face, const std::array<long long, 10>& points);
  void GoDown();

  int Corner; ///< of the face, which the line cuts off; negative: it is along a diagonal
  Weights At;
  LatticeCorners Corners; ///< of the face or tetrahedron
  std::vector<Side> Sides;
};

}

#endif
