// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ControlComplex.h
 * Builds the complex of the level that was read, with its singular simplices and the rules that its
 * vertices and edges follow. It refines the complex of the control mesh.
 */
#ifndef SubdivisionObjects_ControlComplex_h
#define SubdivisionObjects_ControlComplex_h

#include "Core/Solids/Limits/LimitStencils.h"
#include "Private/Control/ControlMesh.h"

#include <functional>
#include <string>
#include <vector>

namespace subdivision
{

/// The part of ControlComplex that does not depend on the type of ids.
struct ControlTraits
{
  std::vector<CellRun> Runs;        ///< the simplices that were read
  std::vector<CellRun> DerivedRuns; ///< singular simplices that follow from the mesh
  SharpTuples Derived;              ///< the same as tuples of control points
  /// The edges that were tested for the feature angle, and which of them exceed it.
  std::vector<FeatureCandidate> Candidates;
  std::vector<bool> Features;
  SolidSharpness Sharpness;                 ///< of control edges and faces
  std::vector<vtkIdType> Solids;            ///< the simplex of each control tetrahedron
  Buffer<unsigned char> ManifoldDimensions; ///< of control simplices
};

template <typename Id>
struct ControlComplex : ControlTraits
{
  Level<Id> Current; ///< the level that was read: MadeLevels steps after the control level
};

using WarnFunction = std::function<void(const std::string&)>;

/// `points` are coordinates of the control points, read for features and for points at one place;
/// `warn` gets messages on these and on flags that contradict each other; `depth` is for the
/// current level. Returns false if the stamp is wrong: its levels do not lead from the control mesh
/// to the simplices that were read, or the mesh does not have its singular simplices.
///
/// The level, of any volume scheme (SolidScheme.h), goes to `current`. That may be control.Current,
/// which else is left empty.
template <typename Scheme>
bool BuildControlComplex(const ControlMesh& mesh, const FeatureOptions& features,
  const Coordinates& points, const WarnFunction& warn, Depth depth,
  ControlComplex<typename Scheme::Id>& control, typename Scheme::Level& current);

/// Warns where cells of a mesh without a stamp come apart (OpenPoints.h). BuildControlComplex does,
/// too; this is for runs that need no complex.
template <typename Id>
void WarnOfOpenPoints(const ControlMesh& mesh, const FeatureOptions& features,
  const Coordinates& points, const WarnFunction& warn);

/// Builds the level `steps` steps after the current one, for output. Edges and faces that are
/// still sharp on it are singular.
template <typename Scheme>
typename Scheme::Level BuildSharpLevel(
  const ControlMesh& mesh, const FeatureOptions& features, const ControlTraits& traits, int steps);

/// The stages of semi-sharp edges and faces from the level `steps` steps after the current one on.
template <typename Scheme>
SemiSharpStages<typename Scheme::Id> BuildSharpStages(
  const ControlMesh& mesh, const FeatureOptions& features, const ControlTraits& traits, int steps);

/// Gives the flags of control simplices to their children after `levels` steps.
std::vector<unsigned char> RefineFlags(
  const SimplexList& simplices, int levels, const std::vector<unsigned char>& flags);

/// Collects the singular simplices: the derived ones, and the flagged ones; `flags` has one for
/// each simplex that was read.
template <typename Id>
SingularSimplices CollectSingular(const SimplicialComplex<Id>& complex, const ControlTraits& traits,
  const std::vector<unsigned char>& flags);

}

#endif
