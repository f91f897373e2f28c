// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceCells.h
 * Reads the cells of a vtkPolyData as vertices, segments and polygons, and writes them.
 */
#ifndef SubdivisionObjects_SurfaceCells_h
#define SubdivisionObjects_SurfaceCells_h

#include "Core/Surfaces/Steps/SurfaceSteps.h"

#include <string>
#include <vector>

class vtkCellArray;
class vtkPolyData;

namespace subdivision
{

struct SurfaceCells
{
  vtkIdType NumberOfPoints = 0;
  std::vector<vtkIdType> Vertices;
  std::vector<vtkIdType> Segments; ///< two points each
  std::vector<vtkIdType> FaceOffsets{ 0 };
  std::vector<vtkIdType> Corners;
  /// The input cell of each.
  std::vector<vtkIdType> VertexCells;
  std::vector<vtkIdType> SegmentCells;
  std::vector<vtkIdType> FaceCells;
  /// Warnings for the user, one for each kind of fault.
  std::vector<std::string> Warnings;

  vtkIdType GetNumberOfFaces() const { return static_cast<vtkIdType>(this->FaceCells.size()); }
};

/**
 * Reads the cells of a vtkPolyData. Poly vertices become vertices, poly lines segments, strips
 * triangles; with `triangles` polygons become triangles too (PolygonEars.h, QuadDiagonals.h). Cells
 * that cannot be used are left out with a warning, hidden ones without.
 */
SurfaceCells ReadSurfaceCells(vtkPolyData* input, bool triangles, const vtkIdType* globalIds);

/// The faces and segments as a level: its mesh and lines.
template <typename Id>
SurfaceLevel<Id> MakeControlLevel(const SurfaceCells& cells);

/// Writes the cells of the last level. `vertices` are the points of vertex cells where steps keep
/// ids; else the level has them.
template <typename Id>
void WriteSurfaceCells(const SurfaceSteps<Id>& steps, const std::vector<vtkIdType>& vertices,
  bool use32BitIds, vtkPolyData* output);
/// The same of a level.
template <typename Id>
void WriteSurfaceCells(const SurfaceLevel<Id>& level, const std::vector<vtkIdType>& vertices,
  bool use32BitIds, vtkPolyData* output);

}

#endif
