// SPDX-License-Identifier: BSD-3-Clause
// 3. Creases: the upper edges of a cube are sharp for some levels.
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataObject.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkSurfaceSubdivision.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataWriter.h>

int main()
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkUnstructuredGrid> cube;
  cube->SetPoints(points);
  for (int i = 0; i < 8; ++i)
  {
    points->InsertNextPoint(i & 1, i >> 1 & 1, i >> 2);
  }
  const vtkIdType cells[10][4] = { { 4, 5 }, { 5, 7 }, { 7, 6 }, { 6, 4 }, { 0, 2, 3, 1 },
    { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 4, 6, 2 }, { 1, 3, 7, 5 } };
  vtkNew<vtkDoubleArray> sharpness;
  sharpness->SetName("Sharpness");
  for (int i = 0; i < 10; ++i) // four lines, which are creases, and six quads
  {
    cube->InsertNextCell(i < 4 ? VTK_LINE : VTK_QUAD, i < 4 ? 2 : 4, cells[i]);
    sharpness->InsertNextValue(i < 4 ? 1.5 : 0); // for so many levels
  }
  cube->GetCellData()->AddArray(sharpness);
  vtkNew<vtkSurfaceSubdivision> subdivide;
  subdivide->SetInputData(cube);
  subdivide->SetNumberOfLevels(3);
  subdivide->SetInputArrayToProcess(4, 0, 0, vtkDataObject::CELL, "Sharpness");
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(subdivide->GetOutputPort());
  writer->SetFileName("03_creases.vtp");
  return writer->Write() ? 0 : 1;
}
