// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RedGreenLimit.h
 * Red-green refinement and the limit of smooth subdivision: the operator that puts all vertices of
 * a state on it, and the errors of edges that criteria ask for.
 */
#ifndef SubdivisionObjects_RedGreenLimit_h
#define SubdivisionObjects_RedGreenLimit_h

#include "ControlComplex.h"
#include "Core/LocalLimit.h"
#include "Core/PairTable.h"
#include "RefinementCriteria.h"
#include "RefinementMarks.h"

#include <array>
#include <vector>

namespace subdivision
{

template <typename Id>
class RedGreenLimit
{
public:
  /// False where a stamp that is trusted leads to other cells than those that were read.
  bool Build(const ControlMesh& mesh, const FeatureOptions& features, const double* points,
    const WarnFunction& warn);

  /// From values at the control vertices to the limits of all vertices of a state.
  LocalLimit<Id> GetOperator(const RedGreen<Id>& state) const;

  /// Finds the errors of the edges of candidates; those of green cells that no cell of the uniform
  /// refinement has are left out, their leaf's own edges tell enough.
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

  void FindCurved();
  void FindCarriers(const RedGreen<Id>& state);
  bool IsCurved(Id a, Id b) const;
  static Carrier Unite(const Carrier& a, const Carrier& b);
  template <typename Cells>
  void FindEdges(const RedGreen<Id>& state, const Cells& cells, int maximumLevel);

  Level<Id> Control;
  SemiSharpStages<Id> Creases;
  /// Edges and faces of the control mesh that are not merely the inside of a solid; sorted.
  std::vector<Carrier> Curved;
  std::vector<Carrier> Carriers; ///< of each vertex of the state so far
  PairTable<Id> Edges;
  std::vector<std::array<Id, 2>> Ends; ///< of the edges
  Buffer<double> Errors;
};

}

#endif
