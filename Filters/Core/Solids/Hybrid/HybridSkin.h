// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HybridSkin.h
 * Tangents of a level whose solids are not made: the same as Skin.h for cells of all types.
 *
 * The *skin* of a level of solids is its faces with one solid, as a level of polygons. Where no
 * rule there reads the inside of a solid, the skin is refined alone, and its vertices are some
 * vertices of the whole. A level without solids is its own skin.
 */
#ifndef SubdivisionObjects_HybridSkin_h
#define SubdivisionObjects_HybridSkin_h

#include "Core/Solids/Hybrid/HybridLevel.h"
#include "Core/Solids/Limits/Skin.h"

#include <vector>

namespace subdivision
{

/// Whether BuildHybridSkinTangents finds all tangents of the level that is `steps` steps after this
/// one. `wantsCurves`: also those of curves inside solids, which the skin does not have.
template <typename Id>
bool HasClosedSkin(const HybridLevel<Id>& level, int steps, bool wantsCurves);

/// The tangents at vertices of the next level, which is `steps` steps after the control level.
/// `controls`: as in BuildHybridTangents, of the cells of this level.
template <typename Id>
SkinTangents<Id> BuildHybridSkinTangents(
  const HybridLevel<Id>& level, const std::vector<vtkIdType>& controls, int steps);

/// Whether nothing is sharp in a picture of the level that is `steps` steps after a control level,
/// all whose cells are solids, or all surfaces: no joint, crease or corner. The border of a surface
/// is not sharp; a surface that is not orientable is.
template <typename Id>
bool LooksSmooth(const HybridLevel<Id>& control, int steps);

}

#endif
