// SPDX-License-Identifier: BSD-3-Clause
// 2. Two materials: the surface between them stays smooth and sharp, and a value jumps there.
#include <vtkMultiDimensionalSubdivision.h>
#include <vtkNew.h>
#include <vtkSubdivisionModelSource.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <iostream>

int main()
{
  vtkNew<vtkSubdivisionModelSource> block; // its cell array MaterialId names the materials
  block->SetModelToMaterialBlock();

  vtkNew<vtkMultiDimensionalSubdivision> subdivide;
  subdivide->SetInputConnection(block->GetOutputPort());
  subdivide->SetNumberOfLevels(3);
  subdivide->Update();
  const vtkIdType blurred = subdivide->GetOutput()->GetNumberOfPoints();

  subdivide->PreserveInterfacesOn();
  subdivide->SetInterfaceValuesToDiscontinuous(); // points of the interface exist twice
  vtkNew<vtkXMLUnstructuredGridWriter> writer;    // in ParaView: Clip, colour by Tension
  writer->SetInputConnection(subdivide->GetOutputPort());
  writer->SetFileName("02_two_materials.vtu");
  writer->Write();

  const vtkIdType more = subdivide->GetOutput()->GetNumberOfPoints() - blurred;
  std::cout << more << " points have a second value\n";
  return more > 0 ? 0 : 1;
}
