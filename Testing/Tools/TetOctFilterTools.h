// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetOctFilterTools.h
 * VolumeScheme = TetOct through the filter: what its tests share.
 */
#ifndef SubdivisionObjects_TetOctFilterTools_h
#define SubdivisionObjects_TetOctFilterTools_h

#include "FeatureTools.h"

namespace tet_oct_filter_tools
{

using namespace feature_tools;

Configure TetOct(const Configure& more = {});

Ids GetOctahedra(vtkUnstructuredGrid* grid);

inline Grid MakeOneTet()
{
  return MakeGrid({ { 0, 0, 0 }, { 1, 0.1, 0 }, { 0.2, 1.3, 0 }, { 0.1, 0.2, 1.1 } },
    { { VTK_TETRA, { 0, 1, 2, 3 } } });
}

/// 0 + 3 = 3 = 1 + 1 + 1 = 2 + 1.
void ExpectChains(vtkUnstructuredGrid* input, const Configure& configure);

}

#endif
