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

struct SolidFaces
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
const SolidFaces* GetFaceTable(int cellType);

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
  vtkIdType Tets[Maximum][4] = {}; ///< `Centre` stands for the new point, always at position 0
  bool HasCentre = false;
  /// The different points of the cell, whose mean is the centre.
  int NumberOfPoints = 0;
  vtkIdType Points[8] = {};
  /// Quads for which the mesh has triangles on both diagonals.
  int NumberOfContested = 0;
  QuadKey Contested[6] = {};
};

/**
 * Splits a cell with a face table. The tets of a cell that is oriented as VTK wants it are
 * positive. Repeated ids are allowed: the pieces that would have no volume are left out.
 *
 * A centre is added only where the diagonals allow nothing else. This is so for 2 of the 8 choices
 * of diagonals in a wedge (where no point has two diagonals) and for 18 of the 64 in a hexahedron;
 * a test compares with an exhaustive search. If each diagonal goes through the smallest point of
 * its quad, no centre is needed.
 */
SolidSplit SplitSolid(int cellType, const vtkIdType* ids, const QuadDiagonals& diagonals);

}

#endif
