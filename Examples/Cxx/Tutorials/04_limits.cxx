// SPDX-License-Identifier: BSD-3-Clause
// 4. Limits: points on the smooth object itself, its normals, and exact values at places.
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkMultiDimensionalSubdivision.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <iostream>

int main()
{
  const double corners[6][3] = { { 1 }, { -1 }, { 0, 1 }, { 0, -1 }, { 0, 0, 1 }, { 0, 0, -1 } };
  vtkNew<vtkUnstructuredGrid> control; // an octahedron
  control->SetPoints(vtkNew<vtkPoints>());
  vtkNew<vtkIdTypeArray> cells; // a place is a cell, and two weights
  vtkNew<vtkDoubleArray> weights;
  weights->SetNumberOfComponents(3);
  for (int i = 0; i < 8; ++i)
  {
    control->GetPoints()->InsertPoint(i % 6, corners[i % 6]);
    const vtkIdType triangle[3] = { i & 1, 2 + (i >> 1 & 1), 4 + (i >> 2) };
    cells->InsertNextValue(control->InsertNextCell(VTK_TRIANGLE, 3, triangle));
    weights->InsertNextTuple3(1. / 3., 1. / 3., 0.);
  }
  vtkNew<vtkMultiDimensionalSubdivision> subdivide;
  subdivide->SetInputData(control);
  subdivide->SetNumberOfLevels(3);
  subdivide->ProjectToLimitOn(); // with normals, as nothing is sharp
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputConnection(subdivide->GetOutputPort());
  writer->SetFileName("04_limits.vtu");
  vtkNew<vtkPolyData> centres;
  const bool isDone = writer->Write() && subdivide->EvaluateLimit(cells, weights, centres);
  std::cout << "the middle of a face is at " << centres->GetPoint(0)[0] << " on each axis\n";
  return isDone ? 0 : 1;
}
