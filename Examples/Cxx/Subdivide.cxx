// Subdivides a built-in control mesh twice and says how it grew.
#include <vtkDataObject.h>
#include <vtkMultiDimensionalSubdivision.h>
#include <vtkNew.h>
#include <vtkSubdivisionModelSource.h>
#include <vtkUnstructuredGrid.h>

#include <iostream>

int main()
{
  vtkNew<vtkSubdivisionModelSource> model;
  vtkNew<vtkMultiDimensionalSubdivision> subdivision;
  subdivision->SetInputConnection(model->GetOutputPort());
  subdivision->SetNumberOfLevels(2);
  subdivision->Update();

  auto* control = vtkUnstructuredGrid::SafeDownCast(model->GetOutputDataObject(0));
  auto* smooth = vtkUnstructuredGrid::SafeDownCast(subdivision->GetOutputDataObject(0));
  if (!control || !smooth)
  {
    return 1;
  }
  std::cout << control->GetNumberOfCells() << " cells became " << smooth->GetNumberOfCells()
            << "\n";
  return smooth->GetNumberOfCells() > control->GetNumberOfCells() ? 0 : 1;
}
