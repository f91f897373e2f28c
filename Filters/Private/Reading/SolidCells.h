// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SolidCells.h
 * Hexahedra, voxels, wedges and pyramids as tetrahedra that respect the diagonals of their quads.
 */
#ifndef SubdivisionObjects_SolidCells_h
#define SubdivisionObjects_SolidCells_h

#include "Private/Reading/QuadDiagonals.h"

#include "vtkType.h"

namespace subdivision
{

struct FaceTable
{
  int NumberOfPoints;
  int NumberOfFaces;
  int Faces[6][4]; ///< outward; a triangle ends with -1
};

/**
 * The faces of a cell type: TETRA, VOXEL, HEXAHEDRON, WEDGE, PYRAMID; null for others.
 * A wedge is read as VTK documented it up to 9.6, and as mesh files have it: the normal of (0,1,2)
 * points outward. (VTK 9.7 turned the definition round; a result must not depend on the VTK that
 * runs.)
 */
const FaceTable* GetFaceTable(int cellType);

/**
 * Drops repeated neighbours from a closed loop of `size` ids and returns its new size. A loop of
 * two is an edge.
 */
vtkIdType CollapseLoop(vtkIdType* loop, vtkIdType size);

struct SolidSplit
{
  static constexpr int Maximum = 12;
  static constexpr vtkIdType Centre = -1;

  int NumberOfTets = 0;
  vtkIdType Tets[Maximum][4] = {}; ///< `Centre` stands for the new point, always in place 0
  bool HasCentre = false;
  /// The different points of the cell, whose mean is the centre.
  int NumberOfPoints = 0;
  vtkIdType Points[8] = {};
  /// Quads on both diagonals of which the mesh has triangles.
  int NumberOfContested = 0;
  QuadKey Contested[6] = {};
};

/**
 * Splits a cell with a face table. The tets of a cell that is oriented as VTK wants it are
 * positive. Repeated ids are allowed: the pieces that would have no volume are left out.
 *
 * A centre is added only where the diagonals allow nothing else. For a wedge these are the 2 of 8
 * choices in which no point has two diagonals, for a hexahedron 18 of 64 (a test compares with an
 * exhaustive search). With all diagonals through the smallest id there is none.
 */
SolidSplit SplitSolid(int cellType, const vtkIdType* ids, const QuadDiagonals& diagonals);

}

#endif
