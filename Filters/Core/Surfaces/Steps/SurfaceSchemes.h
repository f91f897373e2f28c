// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceSchemes.h
 * Makes a surface scheme by its number.
 */
#ifndef SubdivisionObjects_SurfaceSchemes_h
#define SubdivisionObjects_SurfaceSchemes_h

#include "Core/Rules/LoopWeights.h"
#include "Core/Surfaces/Scheme/SurfaceScheme.h"

namespace subdivision
{

/// With the numbers of vtkSubdivisionAlgorithm::Schemes, which stamps in files hold.
enum class SurfaceSchemeKind
{
  Linear = 2,
  Loop,
  CatmullClark,
  ModifiedButterfly,
  DooSabin,
  Midedge,
  FourEight,
  SqrtThree
};

/// Null for a number that is no scheme. `weights`: of Loop.
template <typename Id>
std::shared_ptr<const SurfaceScheme<Id>> MakeSurfaceScheme(
  SurfaceSchemeKind kind, bool modifiedBoundary, LoopWeights weights = LoopWeights::Warren);

}

#endif
