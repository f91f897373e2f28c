// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ControlComplex.h
 * From a control mesh to the complex of the level that was read, with its singular simplices and
 * the rules that its vertices and edges follow.
 */
#ifndef SubdivisionObjects_ControlComplex_h
#define SubdivisionObjects_ControlComplex_h

#include "Core/Solids/Limits/LimitStencils.h"
#include "Core/Solids/TetOct/TetOctComplex.h"
#include "Private/Control/ControlMesh.h"

#include <functional>
#include <string>
#include <vector>

namespace subdivision
{

/// What is known of a control mesh whatever its ids are.
struct ControlTraits
{
  std::vector<CellRun> Runs;        ///< the simplices that were read
  std::vector<CellRun> DerivedRuns; ///< singular simplices that follow from the mesh
  SimplexTuples Derived;            ///< the same, as the control mesh names them
  /// Where features were looked for, and which of them are.
  std::vector<FeatureCandidate> Candidates;
  std::vector<bool> Features;
  EdgeSharpness Sharpness;                  ///< of control edges
  std::vector<vtkIdType> Solids;            ///< the simplex of each control tetrahedron
  Buffer<unsigned char> ManifoldDimensions; ///< of control simplices
};

template <typename Id>
struct ControlComplex : ControlTraits
{
  Level<Id> Current; ///< the control level, or the steps that were made below it
};

using WarnFunction = std::function<void(const std::string&)>;

/// `points` are coordinates at the control points, read for features only; `warn` is told of flags
/// that contradict each other; `depth` is that of the current level. False where the mesh has made
/// levels and these do not lead to the simplices that were read.
template <typename Id>
bool BuildControlComplex(const ControlMesh& mesh, const FeatureOptions& features,
  const Coordinates& points, const WarnFunction& warn, Depth depth, ControlComplex<Id>& control);

/// The same for either kind of solids; control.Current is left empty.
template <template <typename> class AnyLevel, typename Id>
bool BuildControlComplex(const ControlMesh& mesh, const FeatureOptions& features,
  const Coordinates& points, const WarnFunction& warn, Depth depth, ControlComplex<Id>& control,
  AnyLevel<Id>& current);

/// The level `steps` below the current one, for output, as it is where all edges are singular that
/// are then still sharp.
template <template <typename> class AnyLevel, typename Id>
AnyLevel<Id> BuildSharpLevel(
  const ControlMesh& mesh, const FeatureOptions& features, const ControlTraits& traits, int steps);

/// What semi-sharp creases do from the level `steps` below the current one on.
template <template <typename> class AnyLevel, typename Id>
SemiSharpStages<Id> BuildSharpStages(
  const ControlMesh& mesh, const FeatureOptions& features, const ControlTraits& traits, int steps);

/// Flags of control simplices, given to their children.
std::vector<unsigned char> RefineFlags(
  const SimplexList& simplices, int levels, const std::vector<unsigned char>& flags);

/// Flagged simplices, `flags` one for each that was read, and derived ones.
template <typename Id>
SingularSimplices CollectSingular(const SimplicialComplex<Id>& complex, const ControlTraits& traits,
  const std::vector<unsigned char>& flags);

}

#endif
