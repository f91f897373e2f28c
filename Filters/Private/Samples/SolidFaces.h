// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SolidFaces.h
 * The triangles of tetrahedra that lie between materials, or on the outside.
 */
#ifndef SubdivisionObjects_SolidFaces_h
#define SubdivisionObjects_SolidFaces_h

#include "Private/Samples/SampledImage.h"

#include <vector>

class vtkMultiProcessController;

namespace subdivision
{

struct SolidFace
{
  std::size_t Mesh;
  QuadraticPiece Triangle;
  vtkIdType Top; ///< the corner of the tetrahedron that is not in the triangle
};

/// The triangles which have nothing behind them in their mesh or, if asked for, another material.
std::vector<SolidFace> ListFaces(const std::vector<SampledMesh>& meshes, bool betweenMaterials);

/// Takes out the triangles that are in the same place, also on other ranks, and of different
/// tetrahedra: between blocks, parts and copies of points, and so inside of the object. All ranks
/// call it.
void DropCommonFaces(const std::vector<SampledMesh>& meshes, vtkMultiProcessController* controller,
  std::vector<SolidFace>& faces);

}

#endif
