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

/// The schemes with the numbers of vtkSurfaceSubdivision. Stamps in files hold them.
enum class SurfaceSchemeKind
{
  Loop,
  ModifiedButterfly,
  CatmullClark,
  DooSabin,
  Midedge,
  FourEight,
  SqrtThree,
  Linear
};

/// Null for a number that is no scheme. `weights`: of Loop.
template <typename Id>
std::shared_ptr<const SurfaceScheme<Id>> MakeSurfaceScheme(
  SurfaceSchemeKind kind, bool modifiedBoundary, LoopWeights weights = LoopWeights::Warren);

}

#endif
