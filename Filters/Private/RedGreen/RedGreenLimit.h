// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RedGreenLimit.h
 * Red-green refinement and the limit of smooth subdivision: the operator that puts all vertices of
 * a state on it, and the errors of edges that criteria ask for.
 */
#ifndef SubdivisionObjects_RedGreenLimit_h
#define SubdivisionObjects_RedGreenLimit_h

#include "Core/Memory/PairTable.h"
#include "Core/Solids/Limits/LocalLimit.h"
#include "Private/Control/ControlComplex.h"
#include "Private/Criteria/RefinementCriteria.h"
#include "Private/RedGreen/RefinementMarks.h"

#include <array>
#include <vector>

namespace subdivision
{

template <typename Id>
class RedGreenLimit
{
public:
  /// False where a stamp that is trusted leads to other cells than those that were read.
  bool Build(const ControlMesh& mesh, const FeatureOptions& features, const Coordinates& points,
    const WarnFunction& warn);

  /// From values at the control vertices to the limits of all vertices of a state.
  LocalLimit<Id> GetOperator(const RedGreen<Id>& state) const;

  /// Finds the errors of the edges of candidates: the largest distance of the limit from the edge,
  /// looked at in one to three places along it; inside a surface, from its triangles. What lies
  /// inside a triangle counts for its edges, too; inside a green one for the edge that only green
  /// cells have.
  template <typename Cells>
  void FindErrors(const RedGreen<Id>& state, const Cells& cells, int maximumLevel,
    const RefinementOptions& options, const RefinementCriteria& criteria);

  /// What FindErrors found; negative: a value is not finite.
  double GetError(Id a, Id b) const
  {
    const Id edge = this->Edges.Find(a, b);
    return edge < 0 ? 0. : this->Errors[edge];
  }

private:
  using Carrier = std::array<Id, 4>; ///< the vertices of a control simplex, ascending; then -1

  /// A place on the limit, and where the straight edge or triangle has it.
  struct Sample
  {
    Id Place = 0; ///< among the vertices of the state, then the Middles
    std::array<Id, 3> Corners{ { -1, -1, -1 } };
    std::array<double, 3> Weights{ { 0., 0., 0. } };
    std::array<Id, 3> Edges{ { -1, -1, -1 } }; ///< that have the error
  };
  /// Two vertices of a candidate, and what they are to its leaf.
  struct EdgeOfCell
  {
    Id Ends[2];
    /// The leaf's edges whose middles the ends are; twice the end itself for a corner.
    std::array<Id, 2> Of[2];
    /// Whether some cell of the uniform refinement has the edge.
    bool IsUniform;
  };

  /// The triangles of a surface at an edge.
  struct SidesOfEdge
  {
    Id Opposites[2] = { -1, -1 };
    /// On an edge of the control mesh: cells of the input end there, so that what lies beside it is
    /// off both.
    bool IsBorder = false;
  };

  void FindCurved();
  void FindCarriers(const RedGreen<Id>& state);
  bool IsCurved(const Carrier& carrier) const;
  void AddSide(Id edge, Id opposite, bool isOfSolid);
  double GetErrorOfEdge(const Sample& sample, const double* const* corners, const double* place,
    const Buffer<double>& limits, const Buffer<Id>& numbers,
    const RefinementCriteria& criteria) const;
  static Carrier Unite(const Carrier& a, const Carrier& b);
  template <typename Cells>
  void FindSamples(const RedGreen<Id>& state, const Cells& cells, int maximumLevel,
    const RefinementOptions& options);
  Id GetMiddle(Id a, Id b);
  static EdgeOfCell LookAt(const RedGreen<Id>& state, const std::array<Id, 4>& leaf, Id a, Id b);
  void AddEdge(const EdgeOfCell& edge, const std::array<Id, 4>& leaf);
  void AddTriangle(const RedGreen<Id>& state, const std::array<Id, 4>& leaf,
    const std::array<Id, 3>& corners, bool isOfSolid);
  Buffer<Id> NumberPlaces(
    const RedGreen<Id>& state, std::vector<std::array<Id, 2>>& midpoints) const;
  void Measure(const RedGreen<Id>& state, const RefinementOptions& options,
    const RefinementCriteria& criteria);

  Level<Id> Control;
  SemiSharpStages<Id> Creases;
  /// Edges and faces of the control mesh that are not merely the inside of a solid; sorted.
  std::vector<Carrier> Curved;
  std::vector<Carrier> Carriers; ///< of each vertex of the state so far
  PairTable<Id> Edges;
  Buffer<double> Errors;          ///< of edges
  std::vector<SidesOfEdge> Sides; ///< of edges
  Id NumberOfEdges = 0;
  // Samples of one round:
  Id FirstMiddle = 0; ///< the number of vertices of the state
  PairTable<Id> MiddlesByEnds;
  std::vector<std::array<Id, 2>> Middles; ///< places that are no vertices: between which they lie
  std::vector<Sample> Samples;
};

}

#endif
