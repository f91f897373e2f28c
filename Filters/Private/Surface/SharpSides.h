// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SharpSides.h
 * Doubles points of the output where a surface is sharp, so that each side has its own normal.
 *
 * A side is a sector: the faces at a vertex from one edge that is not smooth to the next. Such
 * points are for a picture: cells on both sides of a crease share them no more.
 */
#ifndef SubdivisionObjects_SharpSides_h
#define SubdivisionObjects_SharpSides_h

#include "Core/Surfaces/Scheme/SurfaceLimits.h"

class vtkDataArray;
class vtkPolyData;

namespace subdivision
{

struct SharpSides
{
  Buffer<vtkIdType> OfCorners; ///< the side of each corner of a face; -1: its vertex has no other
  std::vector<double> Normals; ///< three numbers for each side
};

/// The sides of a last level. `points`: its vertices before they go to the limit. `finder` knows
/// the tangents of sides in the limit; null: normals are the mean of those of faces, weighted by
/// angle.
template <typename Id>
SharpSides FindSharpSides(const SurfaceLevel<Id>& level, LimitFinder<Id>* finder,
  const Buffer<unsigned char>& turned, vtkDataArray* points);

/// Gives the output, whose polygons are the faces, a point for each side.
template <typename Id>
void SplitSides(const SharpSides& sides, const PolygonMesh<Id>& mesh, vtkPolyData* output);

}

#endif
