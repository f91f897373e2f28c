// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HybridZoo.h
 * Meshes of all cell types for the reference of the hybrid scheme: fans and columns around an edge,
 * boxes of mixed types, with surfaces, lines and marks.
 */
#ifndef SubdivisionObjects_HybridZoo_h
#define SubdivisionObjects_HybridZoo_h

#include "HybridReference.h"

namespace hybridtest
{

/// The unit cube: one hexahedron.
Mesh MakeCube();

/// The cube from -1 to 1 as six pyramids around its middle, which is point 8.
Mesh MakeSixPyramids();

/// Hexahedra and wedges in this order around the axis z, in layers; open: the first and the last do
/// not meet. Point i, up to the number of layers, is point i of the axis.
Mesh MakeFan(const std::vector<Type>& sectors, int layers, bool isClosed = true);

/// A mesh by its seed: a box of all types or a fan, some with holes, surfaces, lines, followers,
/// marks and materials; its points are moved by up to 15 per cent of the spacing.
Mesh MakeRandomHybrid(unsigned int seed, bool withOctahedra = true);

}

#endif
