// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GapMeshes.h
 * The meshes of GapCases, of any size.
 */
#ifndef SubdivisionObjects_GapMeshes_h
#define SubdivisionObjects_GapMeshes_h

#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkPointSet.h"
#include "vtkSmartPointer.h"
#include "vtkSphere.h"

namespace benchmarks
{

using Mesh = vtkSmartPointer<vtkPointSet>;

/// A length that makes things of that dimension `scale` times as large.
int Scaled(int n, double scale, double dimension = 3.);
Mesh MakeSolid(int n, double scale);
/// Two materials, in layers.
Mesh MakeLayers(int n, double scale);
vtkSmartPointer<vtkImageData> MakeImage(int n, double scale);
/// An unstructured grid of hexahedra.
Mesh MakeHexahedra(int n, double scale);
/// Quadratic tetrahedra, each with points of its own.
Mesh MakeQuadratic(int n, double scale);
/// A sphere of triangles or quads of `levels` steps from the coarse one, as any other mesh.
Mesh MakeSurface(bool ofTriangles, int levels, double scale);
/// The same beside it.
Mesh MakeMoved(vtkPointSet* mesh, double x);
/// A mesh, and the same beside it.
vtkSmartPointer<vtkDataObject> MakeBlocks(vtkPointSet* mesh);
/// Points in the middle of the unit cube, with vectors.
Mesh MakeCloud(int n, double scale);
/// A ball of label 2 in a ball of label 1, and some background.
vtkSmartPointer<vtkImageData> MakeLabels(int n, double scale);
vtkSmartPointer<vtkSphere> MakeBall(double centre, double radius);

}

#endif
