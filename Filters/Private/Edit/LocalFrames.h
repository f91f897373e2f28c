// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LocalFrames.h
 * The axes of the limit at each point of a mesh, and the linear maps from those of one mesh to
 * those of another.
 */
#ifndef SubdivisionObjects_LocalFrames_h
#define SubdivisionObjects_LocalFrames_h

#include "Core/Memory/Buffer.h"
#include "Private/Run/RunOptions.h"

#include "vtkSmartPointer.h"

class vtkDataArray;
class vtkPointSet;

namespace subdivision
{

/// Whether a mesh has the arrays of tangents and normals.
bool HasFrameArrays(vtkPointSet* mesh);

/// The tangents, normals and bends at the points of a mesh.
class FramedMesh
{
public:
  /// Takes the arrays of tangents and normals if `fromArrays`, or makes them as
  /// vtkMultiDimensionalSubdivision does at no level. IsUsable is false after an error.
  FramedMesh(vtkPointSet* mesh, bool fromArrays, const RunOptions& options);

  bool IsUsable() const { return this->Tangents[0] && this->Tangents[1] && this->Normals; }
  vtkIdType GetNumberOfPoints() const { return this->Bends.size() / 3; }
  void GetPoint(vtkIdType point, double* x) const;

  /// Three vectors that turn and stretch with the object, one after the other, and returns 3. On
  /// straight curves 1, the tangent; at joints, corners and inside solids 0.
  int FindVectors(vtkIdType point, double* vectors) const;
  /// Three of length 1, perpendicular to each other; the axes of the world where there are less.
  void FindAxes(vtkIdType point, double* axes) const;
  /// Whether the point is inside a solid.
  bool IsInside(vtkIdType point) const;

private:
  vtkPointSet* Mesh;
  vtkSmartPointer<vtkDataArray> Tangents[2];
  vtkSmartPointer<vtkDataArray> Normals;
  Buffer<double> Bends; ///< the sum of the vectors to the neighbours by lines
};

/// A matrix of 9 numbers, row by row, for each point: the map from the vectors of `rest` to those
/// of `moved`.
Buffer<double> FindLocalMaps(
  vtkPointSet* restMesh, const FramedMesh& rest, const FramedMesh& moved);

}

#endif
