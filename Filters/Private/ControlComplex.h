// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ControlComplex.h
 * From a control mesh to the complex of the level that was read, with its singular simplices and
 * the rules that its vertices and edges follow.
 */
#ifndef SubdivisionObjects_ControlComplex_h
#define SubdivisionObjects_ControlComplex_h

#include "ControlMesh.h"
#include "Core/Refinement.h"

#include <functional>
#include <string>
#include <vector>

namespace subdivision
{

template <typename Id>
struct ControlComplex
{
  Level<Id> Current;                ///< the control level, or the steps that were made below it
  std::vector<CellRun> Runs;        ///< the simplices that were read
  std::vector<CellRun> DerivedRuns; ///< singular simplices that follow from the mesh
  SingularSimplices Singular;       ///< flagged or derived, of the current level
  /// Where features were looked for, and which of them are.
  std::vector<FeatureCandidate> Candidates;
  std::vector<bool> Features;
};

using WarnFunction = std::function<void(const std::string&)>;

/// `points` are coordinates at the control points, read for features only; `warn` hears of flags
/// that contradict each other. False where the mesh has made levels and these do not lead to the
/// simplices that were read.
template <typename Id>
bool BuildControlComplex(const ControlMesh& mesh, const FeatureOptions& features,
  const double* points, const WarnFunction& warn, ControlComplex<Id>& control);

extern template bool BuildControlComplex(const ControlMesh&, const FeatureOptions&, const double*,
  const WarnFunction&, ControlComplex<int>&);
extern template bool BuildControlComplex(const ControlMesh&, const FeatureOptions&, const double*,
  const WarnFunction&, ControlComplex<long long>&);

}

#endif
