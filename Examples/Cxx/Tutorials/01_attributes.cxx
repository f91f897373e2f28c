// SPDX-License-Identifier: BSD-3-Clause
// 1. Attributes: a tension at few points becomes a smooth field in the solid.
#include <vtkMultiDimensionalSubdivision.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSubdivisionModelSource.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <iostream>

int main()
{
  vtkNew<vtkSubdivisionModelSource> block; // its point array Tension changes from point to point
  block->SetModelToMaterialBlock();

  vtkNew<vtkMultiDimensionalSubdivision> subdivide;
  subdivide->SetInputConnection(block->GetOutputPort());
  subdivide->SetNumberOfLevels(3); // arrays of floating point numbers are smoothed as points are

  vtkNew<vtkXMLUnstructuredGridWriter> writer; // in ParaView: colour by Tension, as Volume
  writer->SetInputConnection(subdivide->GetOutputPort());
  writer->SetFileName("01_attributes.vtu");
  writer->Write();

  double before[2];
  double after[2];
  block->GetOutput()->GetPointData()->GetArray("Tension")->GetRange(before);
  subdivide->GetOutput()->GetPointData()->GetArray("Tension")->GetRange(after);
  std::cout << "tension from " << before[0] << " to " << before[1] << " became from " << after[0]
            << " to " << after[1] << "\n";
  return before[0] <= after[0] && after[0] < after[1] && after[1] <= before[1] ? 0 : 1;
}
