// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HybridCells.h
 * The cells of an input that are refined as cells of their own types, and the points that they
 * need in the middle of others.
 */
#ifndef SubdivisionObjects_HybridCells_h
#define SubdivisionObjects_HybridCells_h

#include "Core/Cells/CellShapes.h"
#include "Private/Reading/CellsToSimplices.h"
#include "Private/Reading/PointOrder.h"

#include <string>
#include <vector>

namespace subdivision
{

struct HybridCells
{
  vtkIdType NumberOfPoints = 0; ///< of the input, then centres
  std::vector<CellShape> Shapes;
  std::vector<vtkIdType> Corners;
  std::vector<vtkIdType> Sources; ///< the cell of the input of each cell
  SimplicesOfCells Centres;       ///< only these, in the order of cells; no simplices
  std::vector<vtkIdType> CentreSources;
  std::vector<std::string> Warnings;

  vtkIdType GetNumberOfInputPoints() const
  {
    return this->NumberOfPoints - this->Centres.GetNumberOfCentres();
  }
  void Add(vtkIdType source, CellShape shape, const vtkIdType* corners);
  /// Returns the id of the mean of these points.
  vtkIdType AddCentre(vtkIdType source, const vtkIdType* members, vtkIdType size);
  /// Adds the tetrahedron or pyramid between the centre of a solid and a face of three or four
  /// points, which looks outwards.
  void AddCone(vtkIdType source, vtkIdType centre, const vtkIdType* face, vtkIdType size);
  /// Appends other cells of the same input.
  void Append(const HybridCells& more);
};

/**
 * Cells with a quad against two triangles give way, so that all fit together: a quad becomes these
 * triangles, a pyramid on the quad two tetrahedra, a hexahedron or wedge a star around its centre
 * with two tetrahedra on the quad. No other cell changes. A warning counts them. `order` decides
 * where triangles lie on both diagonals.
 */
void GiveWayToTriangles(HybridCells& cells, const PointOrder& order);

}

#endif
