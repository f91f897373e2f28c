// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CellsToSimplices.h
 * Reads the cells of a vtkUnstructuredGrid or vtkPolyData as ordered simplices: lists of points
 * whose order counts.
 */
#ifndef SubdivisionObjects_CellsToSimplices_h
#define SubdivisionObjects_CellsToSimplices_h

#include "Core/Memory/SimplexList.h"

#include <string>
#include <vector>

class vtkPointSet;

namespace subdivision
{

struct SimplicesOfCells
{
  /// The simplices, in input cell order; NumberOfPoints counts the added centres too.
  SimplexList Simplices;
  /// The point ids of the simplices inside the input, if they were not copied;
  /// Simplices.Connectivity is empty then.
  const vtkIdType* InPlace = nullptr;
  /// The input cell each simplex is a piece of. Empty: simplex i is cell i.
  std::vector<vtkIdType> ParentCells;
  /// CSR: centre c (point id = number of input points + c) is the mean of the input points
  /// CentreMembers[CentreOffsets[c] .. CentreOffsets[c + 1]).
  std::vector<vtkIdType> CentreOffsets{ 0 };
  std::vector<vtkIdType> CentreMembers;
  /// Warnings for the user: one for each kind of fault of cells, one for quads with triangles on
  /// both diagonals.
  std::vector<std::string> Warnings;

  vtkIdType GetNumberOfCentres() const
  {
    return static_cast<vtkIdType>(this->CentreOffsets.size()) - 1;
  }
  SimplexView GetView() const
  {
    SimplexView view(this->Simplices);
    view.Connectivity = this->InPlace ? this->InPlace : view.Connectivity;
    return view;
  }
  /// Copies ids that are in place.
  void TakeIds();
};

/// Whether ids are copied from an input whose cells are simplices all.
enum class PlainIds
{
  Copied,
  InPlace ///< if the input stores them as vtkIdType: it must outlive the result
};

/**
 * Splits every cell of `input` (vtkUnstructuredGrid or vtkPolyData) into simplices that fit
 * together across cells. `globalIds` orders the points (null: the index does). The pieces of a cell
 * are consecutive and have its orientation; a cell that is a simplex keeps the order of its points.
 * All cells at a quad split it by the same diagonal: the one on which a triangle of the mesh lies,
 * else the one through the smallest point of the quad. See SolidCells.h for the inside of solids,
 * PolygonEars.h for polygons of five and more points. Cells that cannot be used are left out with a
 * warning, hidden ones (vtkGhostType) without. Neither have any influence on the other cells.
 */
SimplicesOfCells CellsToSimplices(
  vtkPointSet* input, const vtkIdType* globalIds, PlainIds ids = PlainIds::Copied);

}

#endif
