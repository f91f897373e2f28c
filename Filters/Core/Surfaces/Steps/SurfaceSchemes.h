// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceSchemes.h
 * The schemes by name.
 */
#ifndef SubdivisionObjects_SurfaceSchemes_h
#define SubdivisionObjects_SurfaceSchemes_h

#include "Core/Surfaces/Scheme/SurfaceScheme.h"

namespace subdivision
{

/// As vtkSurfaceSubdivision numbers them.
enum class SurfaceSchemeKind
{
  Loop,
  ModifiedButterfly,
  CatmullClark,
  DooSabin,
  Midedge,
  FourEight,
  SqrtThree
};

/// Null for a number that is no scheme.
template <typename Id>
std::shared_ptr<const SurfaceScheme<Id>> MakeSurfaceScheme(
  SurfaceSchemeKind kind, bool modifiedBoundary);

}

#endif
