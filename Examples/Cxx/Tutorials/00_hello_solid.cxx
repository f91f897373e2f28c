// SPDX-License-Identifier: BSD-3-Clause
// 0. Hello, solid: five points and two tetrahedra become a smooth solid.
#include <vtkCellType.h>
#include <vtkMultiDimensionalSubdivision.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <iostream>

int main()
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(1, 0, 0);
  points->InsertNextPoint(0.5, 0.9, 0);
  points->InsertNextPoint(0.5, 0.3, 0.8);
  points->InsertNextPoint(0.5, 0.3, -0.8);
  const vtkIdType tetrahedra[2][4] = { { 0, 1, 2, 3 }, { 0, 2, 1, 4 } };
  vtkNew<vtkUnstructuredGrid> control;
  control->SetPoints(points);
  for (const auto& tetrahedron : tetrahedra)
  {
    control->InsertNextCell(VTK_TETRA, 4, tetrahedron);
  }

  vtkNew<vtkMultiDimensionalSubdivision> subdivide;
  subdivide->SetInputData(control);
  subdivide->SetNumberOfLevels(3); // each level splits a tetrahedron into 8, and moves points

  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputConnection(subdivide->GetOutputPort());
  writer->SetFileName("00_hello_solid.vtu");
  writer->Write();
  std::cout << "2 tetrahedra became " << subdivide->GetOutput()->GetNumberOfCells() << "\n";
  return subdivide->GetOutput()->GetNumberOfCells() == 2 * 8 * 8 * 8 ? 0 : 1;
}
