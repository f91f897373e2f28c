// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HybridFilterTools.h
 * Meshes of cells of all types through vtkMultiDimensionalSubdivision with VolumeScheme = HYBRID.
 */
#ifndef SubdivisionObjects_HybridFilterTools_h
#define SubdivisionObjects_HybridFilterTools_h

#include "OperatorCacheTools.h"

#include "vtkSurfaceSubdivision.h"

namespace hybrid_filter_tools
{

using namespace operator_cache_tools;

inline const Configure Hybrid = [](Filter* filter) { filter->SetVolumeSchemeToHybrid(); };

/// HYBRID, and more.
inline Configure With(const Configure& more)
{
  return [more](Filter* filter)
  {
    Hybrid(filter);
    more(filter);
  };
}

/// A hexahedron with a wedge, a pyramid, a tetrahedron, a quad, triangles and lines on it, some of
/// them sides of solids; point and cell arrays.
Grid MakeAllTypes(unsigned int seed = 1);

/// Adds the cell array "Sharpness": these values by cell, else 0.
void AddSharpness(vtkUnstructuredGrid* grid, const std::map<vtkIdType, double>& values);
inline const Configure ReadSharpness = [](Filter* filter)
{ filter->SetInputArrayToProcess(4, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Sharpness"); };

/// Cells, points and all arrays of the same names, up to rounding.
void ExpectSame(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b, double tolerance = 1e-13);

/// Quads by Catmull-Clark of vtkSurfaceSubdivision.
vtkSmartPointer<vtkPolyData> SubdivideQuads(vtkUnstructuredGrid* quads, int levels,
  const std::function<void(vtkSurfaceSubdivision*)>& configure = nullptr);

}

#endif
