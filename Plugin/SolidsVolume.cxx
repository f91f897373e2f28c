// SPDX-License-Identifier: BSD-3-Clause
#include "SolidsVolume.h"

#include "vtkCellType.h"
#include "vtkExtractDimensions.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeRepresentationPreprocessor.h"

vtkStandardNewMacro(SolidsVolume);

namespace
{
bool HasMoreThanTetrahedra(vtkUnstructuredGrid* grid)
{
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    if (grid->GetCellType(cell) != VTK_TETRA)
    {
      return true;
    }
  }
  return false;
}
}

int SolidsVolume::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  // Not Superclass: without a type of its own this class has the one of its superclass.
  const int result = vtkUnstructuredGridVolumeRepresentation::RequestData(request, inputs, outputs);
  auto* grid = vtkUnstructuredGrid::SafeDownCast(this->Preprocessor->GetOutputDataObject(0));
  if (grid && HasMoreThanTetrahedra(grid))
  {
    vtkNew<vtkUnstructuredGrid> all;
    all->ShallowCopy(grid);
    vtkNew<vtkExtractDimensions> solids;
    solids->SetInputData(all);
    solids->Update();
    grid->ShallowCopy(solids->GetOutputDataObject(0));
  }
  return result;
}
