// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Prolongation.h
 * The matrix from the nodes of curved cells of one level to the nodes of the next.
 */
#ifndef SubdivisionObjects_Prolongation_h
#define SubdivisionObjects_Prolongation_h

#include "Core/Operators/MatrixFactors.h"
#include "Private/Curved/CurvedShapes.h"

#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

class vtkPointSet;

namespace subdivision
{

/**
 * Takes the curved cells of one level, and then those of the next with the mesh of linear cells
 * whose `steps` levels earlier ones they are. A node of these lies at a place of a cell of the
 * first: its row is the shape functions of that cell there.
 */
class Prolongation
{
public:
  Prolongation(CurvedKind kind, int order)
    : Kind(kind)
    , Order(order)
  {
  }
  void Take(vtkPointSet* mesh, int steps, vtkUnstructuredGrid* curved);
  /// Whether both levels were taken, and the cells of the second are parts of those of the first.
  bool IsFound() const { return this->Matrix.GetNumberOfRows() > 0; }

  MatrixFactors::Matrix Matrix;

private:
  const CurvedKind Kind;
  const int Order;
  vtkSmartPointer<vtkUnstructuredGrid> Coarse;
};

}

#endif
