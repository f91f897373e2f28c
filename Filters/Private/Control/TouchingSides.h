// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TouchingSides.h
 * Points by which sides of one surface touch, without sharing them.
 */
#ifndef SubdivisionObjects_TouchingSides_h
#define SubdivisionObjects_TouchingSides_h

#include "Core/Memory/Buffer.h"

#include "vtkType.h"

#include <utility>
#include <vector>

class vtkPointSet;

namespace subdivision
{

using PointPairs = std::vector<std::pair<vtkIdType, vtkIdType>>;

/**
 * Pairs of points of equal coordinates that become one, so that the sides of an object share them.
 * Sides are the pieces of a mesh whose faces share points. An object is a set of sides that meet
 * along edges; it is joined as a whole, or not at all: where it is closed then, or each side is one
 * face, and each edge has exactly two sides. So it stays apart where a side meets itself, as in a
 * crack (but not across a seam, where texture coordinates differ); where three sides have an edge;
 * where two lie on each other (1 degree between faces); and where a face has two points at one
 * place. None in a mesh with solids.
 *
 * Values at points do not matter, so that time steps of one mesh are joined alike. Takes one look
 * at each point, and n log n steps for n edges of pieces that touch others. `isOpen`, if not null,
 * gets whether an object is joined that is not closed; with `closedOnly` none is, and it gets
 * whether there is one.
 */
PointPairs FindTouchingSides(
  vtkPointSet* readable, bool* isOpen = nullptr, bool closedOnly = false);

/// Of a mesh whose points are `places` of a joined one: whether each is where seams between its
/// sides end, or meet others or a border, or where a side has one face. Elsewhere a seam goes on.
Buffer<unsigned char> FindSeamCorners(vtkPointSet* sides, Buffer<vtkIdType> places);

}

#endif
