// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BezierTools.h
 * Small meshes, and what the filters with OutputCells = Bezier make of them.
 */
#ifndef SubdivisionObjects_BezierTools_h
#define SubdivisionObjects_BezierTools_h

#include "MultiDimensionalSubdivisionTools.h"

#include "vtkSurfaceSubdivision.h"

namespace bezier_tools
{

using namespace multi_dimensional_subdivision_tools;
using Filter = vtkMultiDimensionalSubdivision;
using Configure = std::function<void(Filter*)>;

Grid MakeBezier(vtkDataObject* input, int levels, const Configure& configure = nullptr);

Grid MakeBezierSurface(vtkDataObject* input, int scheme, int levels, double tolerance = 1e-4);

/// A point of a cell, as VTK evaluates it, and a value of an array there.
Point EvaluateCell(vtkUnstructuredGrid* grid, vtkIdType c, const Point& at);

/// Places inside and on the faces of a cell of a dimension.
std::vector<Point> MakePlaces(int dimension);

void AddScalar(vtkUnstructuredGrid* grid);

std::vector<Point> Shake(std::vector<Point> points, double size);

/// n by n squares, each as two triangles or as a quad.
Grid MakeSheet(int n, bool triangles, double shake);

/// n^3 cells of six tetrahedra around a diagonal each. The axes have obtuse angles, so that the box
/// spline marks the edges by which the tetrahedra are regular.
Grid MakeLattice(int n);

/// Tetrahedra around an edge with some of their faces and edges, a sheet of triangles on one edge
/// of theirs with lines on it, and a line alone. `areFirst`: faces come before what they bound.
Grid MakeMixed(bool areFirst);

vtkSmartPointer<vtkPolyData> ToSurface(vtkUnstructuredGrid* grid);

/// A closed surface of 8 triangles, all vertices of which are extraordinary.
Grid MakeOctahedron();

/// Two poles with n quads around each: vertices of n and of three quads.
Grid MakeTrapezohedron(int n);

/// The tetrahedra of a mesh, with its points in double precision and no data.
Grid TakeSolids(vtkUnstructuredGrid* mesh);

/// The triangles at the border of tetrahedra, as these turn them outwards.
Grid TakeBoundary(vtkUnstructuredGrid* solid);

}

#endif
