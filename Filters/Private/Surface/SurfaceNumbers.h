// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceNumbers.h
 * Numbers the points and cells of an output that is made of a part of a surface as the output of
 * the whole surface numbers them.
 */
#ifndef SubdivisionObjects_SurfaceNumbers_h
#define SubdivisionObjects_SurfaceNumbers_h

#include "Private/Partitions/SharedNumbers.h"
#include "Private/Surface/SurfaceCells.h"

class vtkPolyData;

namespace subdivision
{

/// The kinds of control parts: SurfaceSegments::Kind, and vertex cells.
constexpr int VertexCellKind = SurfaceSegments::NumberOfKinds;
constexpr int NumberOfControlKinds = VertexCellKind + 1;

/// The control parts of each kind as keys; edges get theirs from their vertices (MakeEdgeKeys).
using ControlKeys = std::array<SharedKeys, NumberOfControlKinds>;

struct SurfaceNumbers : WholeNumbers
{
  vtkIdType NumberOfControlPoints = 0; ///< of the whole
};

/**
 * The output has the vertices, lines and faces of `segments`, which come from the level `control`,
 * whose parts are `keys`. All partitions call this together.
 *
 * It is enough to number the vertices, edges, faces and lines of the control level, and to count
 * the descendants of each where their numbers differ (SurfaceSegments): 10 exchanges, however many
 * steps there are. About 8 bytes are sent for each control part and varied segment.
 */
template <typename Id>
SurfaceNumbers NumberSurface(ControlKeys keys, const SurfaceLevel<Id>& control,
  const SurfaceSegments& segments, OtherPartitions& others);

/// The control parts that are points and cells of `input`, the mesh that `others` know; `cells`
/// are its cells. All partitions call this together.
ControlKeys MakeControlKeys(vtkPolyData* input, const SurfaceCells& cells, OtherPartitions& others);

/// The turned faces (FindTurnedFaces) of a control level, as in the whole surface. All partitions
/// call this together.
template <typename Id>
Buffer<unsigned char> FindTurnedOfPart(
  const PolygonMesh<Id>& mesh, const ControlKeys& keys, OtherPartitions& others);

/// The points of the input as keys, by their ids: sure are points of own cells and of none.
SharedKeys MakeVertexKeys(vtkPolyData* input, const OtherPartitions& others);
/// Edges as keys, by the numbers of their vertices, in whose order they are: sure are edges of own
/// faces and lines.
template <typename Id>
SharedKeys MakeEdgeKeys(const SurfaceLevel<Id>& control, const SharedKeys& faces,
  const SharedKeys& lines, const SharedNumbers& vertices);

}

#endif
