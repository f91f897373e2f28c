// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchmarkMeshes.h
 * What is measured: the standard cases, as VTK meshes and as flat arrays.
 */
#ifndef SubdivisionObjects_BenchmarkMeshes_h
#define SubdivisionObjects_BenchmarkMeshes_h

#include "vtkSmartPointer.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

class vtkPoints;
class vtkPointSet;
class vtkUnstructuredGrid;

namespace benchmarks
{

/// Triangles, quads, tetrahedra or hexahedra as other libraries want them.
struct FlatMesh
{
  int Corners = 0; ///< per cell
  bool HasQuads = false;
  std::vector<double> Points;
  std::vector<double> Scalar;
  std::vector<int> Cells;

  int GetNumberOfPoints() const { return static_cast<int>(this->Scalar.size()); }
  int GetNumberOfCells() const { return static_cast<int>(this->Cells.size()) / this->Corners; }
};

/// A unit cube of n^3 x 6 tetrahedra (Kuhn).
FlatMesh MakeCube(int n);
/// The same cube of n^3 hexahedra.
FlatMesh MakeHexahedra(int n);
/// A closed surface of 20 x 4^levels triangles.
FlatMesh MakeSphere(int levels);
/// A closed surface of 2 x n^2 triangles.
FlatMesh MakeTorus(int n);
/// A sphere with bumps of several sizes, as scanned objects have.
FlatMesh MakeBumpySphere(int levels);
/// A closed surface of 6 x n^2 quads.
FlatMesh MakeQuadSphere(int n);

/// A mesh with one double scalar on its points, and no other array.
vtkSmartPointer<vtkPointSet> ToVtk(const FlatMesh& mesh);
vtkSmartPointer<vtkPointSet> MakePolylines(int polylines, int lines);
/// A point below, a point above, and n points of a circle.
vtkSmartPointer<vtkPoints> MakeCircle(int n);
/// n tetrahedra around an edge, whose ends have all of them.
vtkSmartPointer<vtkUnstructuredGrid> MakeStar(int n);
/// The folder of further meshes: the variable SUBDIVISIONOBJECTS_SHARED_DATA of the environment.
std::string GetDataFolder();
/// Null when the file does not exist.
vtkSmartPointer<vtkPointSet> ReadFile(const std::string& path);
/// The triangles of a file, without points that none of them uses; no cells if it does not exist.
FlatMesh ReadTriangles(const std::string& path);

/// One of the standard cases.
struct Case
{
  std::string Name;
  int Levels;
  std::function<vtkSmartPointer<vtkPointSet>()> Make;
};

/// Cases that can be made here; those of files that are missing are left out.
const std::vector<Case>& GetCases();
/// Throws if there is none. No string as argument: GCC would take the result for a reference to it.
const Case& GetCase(const char* name);

/// The input of a case, made at most once.
vtkPointSet* GetInput(const Case& which);

/// Sizes of the output of a case, found by running the filter at most once for each.
struct OutputSize
{
  double Cells = 0.;
  double Points = 0.;
  double Bytes = 0.; ///< GetActualMemorySize
  std::vector<std::size_t>
    Arrays; ///< bytes of points, scalar, connectivity, offsets, types, pieces
};
OutputSize MeasureOutput(vtkUnstructuredGrid* output);
const OutputSize& GetOutputSize(const Case& which, int levels);

}

#endif
