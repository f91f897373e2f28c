// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CatmullClarkScheme.h
 * Catmull and Clark's scheme, piecewise smooth (Mathematics 12).
 */
#ifndef SubdivisionObjects_CatmullClarkScheme_h
#define SubdivisionObjects_CatmullClarkScheme_h

#include "Core/Surfaces/Scheme/SurfaceScheme.h"

namespace subdivision
{

/// `modifiedBoundary` selects the rules of Mathematics 12 for edges and faces near curves;
/// otherwise all smooth edges have the same rule.
template <typename Id>
std::unique_ptr<SurfaceScheme<Id>> MakeCatmullClarkScheme(bool modifiedBoundary);

}

#endif
