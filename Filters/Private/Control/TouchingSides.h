// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TouchingSides.h
 * Points by which sides of one surface touch, without sharing them.
 */
#ifndef SubdivisionObjects_TouchingSides_h
#define SubdivisionObjects_TouchingSides_h

#include "vtkType.h"

#include <utility>
#include <vector>

class vtkPointSet;

namespace subdivision
{

/**
 * Pairs of points with equal coordinates that become one where sides of a surface are joined: the
 * ends of two edges, each of one face, which no other face has. No pair has a point of a solid, or
 * two points of one face. Where no two points have equal coordinates this takes one look at each
 * point; else n log n steps.
 */
std::vector<std::pair<vtkIdType, vtkIdType>> FindTouchingSides(vtkPointSet* readable);

}

#endif
