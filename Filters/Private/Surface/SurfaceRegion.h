// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceRegion.h
 * How a surface subdivision goes on with a part of a surface of which several partitions have
 * parts, where the scheme does not halve edges, so that the control mesh cannot be read off the
 * cells.
 *
 * The region of a part is all that the work on it made: its own cells, and those of layers around
 * them. A part keeps, in field data, the cells of its region, the numbers of its points and cells
 * in the whole output, and the stamp that the region has as a surface by itself (SurfaceStamp.h).
 * The next filter brings the points and cells that other partitions have (MeshPart::Region) and
 * puts them where they were in the region. Then it goes on with the region as with a whole surface.
 *
 * Field arrays, besides those of the stamp:
 *  - `SubdivisionRegionPoints`, `SubdivisionRegionCells`: numbers in the whole; -1 where a point or
 *    cell is there only because the region ends.
 *  - `SubdivisionRegionVerts`, `...Lines`, `...Polys`, and the same with `Offsets`: the cells.
 *  - `SubdivisionRegionControl`: of each control vertex, face, line and vertex cell its kind, and
 *    twice its number in the whole, plus 1 if it is own.
 */
#ifndef SubdivisionObjects_SurfaceRegion_h
#define SubdivisionObjects_SurfaceRegion_h

#include "Private/Surface/SurfaceNumbers.h"
#include "Private/Surface/SurfaceSubdivision.h"

#include "vtkSmartPointer.h"

namespace subdivision
{

struct SurfaceRegion
{
  vtkSmartPointer<vtkPolyData> Mesh;
  /// Which point and cell of the input each one of the region is; -1: none.
  std::vector<vtkIdType> Points;
  std::vector<vtkIdType> Cells;
};

/// Keeps the cells of an output as a region.
void WriteRegion(const SurfaceNumbers& numbers, vtkPolyData* output);
void RemoveRegion(vtkPolyData* output);

/// Makes the region of the input, if the filter goes on with it. All partitions call this together,
/// and get the same answer.
bool FindRegion(vtkPolyData* input, const SurfaceOptions& options, SurfaceRegion& region);

/// Options of the input as options of its region.
SurfaceOptions TakeToRegion(
  vtkPolyData* input, const SurfaceOptions& options, const SurfaceRegion& region);

/// Makes original ids of an output, which count in the region, those of the input.
void CountInInput(vtkPolyData* input, const SurfaceRegion& region, vtkPolyData* output);

/// The control parts of a region as keys.
ControlKeys ReadControlKeys(vtkPolyData* region);

}

#endif
