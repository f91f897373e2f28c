// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfacePlaceTools.h
 * Places in polygons and lines, surfaces to look for limits in, and what the limits are there.
 */
#ifndef SurfacePlaceTools_h
#define SurfacePlaceTools_h

#include "PlaceTools.h"
#include "SurfaceTools.h"

namespace surfacetools
{

using Filter = vtkSurfaceSubdivision;
using Configure = std::function<void(Filter*)>;
/// The schemes that have limits at places.
constexpr int PlaceSchemes[] = { Filter::LOOP, Filter::CATMULL_CLARK };

using place_tools::Evaluate;
using place_tools::Places;

vtkSmartPointer<vtkPolyData> Evaluate(
  vtkPolyData* input, int scheme, const Places& places, const Configure& configure = nullptr);

Point GetPoint(vtkDataSet* mesh, vtkIdType i);
/// A tuple of a point array, which has three components at most.
Point GetTuple(vtkPolyData* result, const char* name, vtkIdType i);

/// Compares all corners of some levels with the limit at their places.
void CheckAgainstLevels(
  vtkPolyData* input, int scheme, int levels, const Configure& configure = nullptr);

/// A bumpy grid, with creases that cross and end.
Model MakeBumpySheet(int size, bool triangles, bool hasCreases);

/// A bumpy sheet of two halves that have the points between them twice, for texture coordinates,
/// and lines beside it.
vtkSmartPointer<vtkPolyData> MakeSeamedSheet(bool triangles);

/// An input with a value for each of its lines, which stand first.
vtkSmartPointer<vtkPolyData> MakeCreasedInput(
  const Model& model, const char* name, const std::function<double(vtkIdType)>& getValue);

/// n faces around point 0, which is inside, with two further rings of faces.
Model MakeStar(int n, bool triangles);

}

#endif
