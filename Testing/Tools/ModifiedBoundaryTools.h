// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ModifiedBoundaryTools.h
 * Surfaces and solids with borders, creases and corners, and comparisons of the main filter with
 * vtkSurfaceSubdivision on them.
 */
#ifndef SubdivisionObjects_ModifiedBoundaryTools_h
#define SubdivisionObjects_ModifiedBoundaryTools_h

#include "MultiDimensionalSubdivisionTools.h"

namespace modified_boundary_tools
{

using namespace multi_dimensional_subdivision_tools;
using Filter = vtkMultiDimensionalSubdivision;
using Configure = std::function<void(Filter*)>;

constexpr const char* AngleName = "Angle";

void SetAngles(vtkSubdivisionAlgorithm* filter);

Grid Execute(vtkPointSet* input, int levels, const Configure& configure = {});

/// A rough surface with borders, and creases that touch neither a border nor each other, which end
/// in darts; some border vertices are flagged as corners. Each point has an angle.
vtkSmartPointer<vtkPolyData> MakeCreased(unsigned seed, bool hasCreases);

/// The same with creases that are sharp for no, one or two levels, or for ever.
vtkSmartPointer<vtkPolyData> MakeSemiSharp(unsigned seed);

/// Points of the input, then those of all cells, or an array there: filters number new points each
/// in their own way.
std::vector<Point> Collect(vtkPointSet* mesh, vtkIdType points, const char* array = nullptr);

double GetDifference(const std::vector<Point>& a, const std::vector<Point>& b);

/// What both filters make of a surface.
void ExpectSameSurfaces(vtkPolyData* input, int levels, bool limit, bool normals);

vtkSmartPointer<vtkPolyData> WithoutCorners(vtkPolyData* input);

/// A box of hexahedra with shells, lines and a fin, creases that are sharp for some levels, and
/// angles.
Grid MakeBox();

void UseFeatures(Filter* filter);

}

#endif
