// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSubdivisionSmoothness.h"

#include "Private/Run/FilterRun.h"
#include "Private/Run/Ports.h"
#include "Private/Smoothness/SmoothnessProbe.h"
#include "Private/Surface/SurfaceInput.h"

#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <string>
#include <vector>

vtkStandardNewMacro(vtkSubdivisionSmoothness);

vtkSubdivisionSmoothness::vtkSubdivisionSmoothness() = default;
vtkSubdivisionSmoothness::~vtkSubdivisionSmoothness() = default;

int vtkSubdivisionSmoothness::RequestDataObject(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  return subdivision::MakeOutput<vtkUnstructuredGrid>(outputVector);
}

int vtkSubdivisionSmoothness::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (vtkCompositeDataSet::SafeDownCast(vtkDataObject::GetData(inputVector[0])) ||
    this->SharesRanks())
  {
    subdivision::Fail(this,
      "The mesh consists of blocks, or is shared by several ranks. Merge it to one data set "
      "first.");
    return 0;
  }
  subdivision::SmoothnessOptions options;
  options.SampleMaps = this->SampleMaps;
  options.FailingOnly = this->FailingOnly;
  options.MapOfCell = this->MapOfCell;
  options.MapLevels = this->MapLevels;
  if (options.MapOfCell >= 0 && !options.FailingOnly)
  {
    options.SampleMaps = false; // the ids of cells do not depend on it
  }
  options.IsTetOct = this->Scheme == TET_OCT;
  const bool isOfSurfaces = this->Scheme >= LOOP;
  options.Scheme =
    static_cast<subdivision::SurfaceSchemeKind>(isOfSurfaces ? this->Scheme - LOOP : 0);
  return this->Run(inputVector, outputVector, options, nullptr,
    "the simplices of the input. Use a part of the input.",
    [&](vtkPointSet* input, vtkPointSet* output)
    {
      auto* made = vtkUnstructuredGrid::SafeDownCast(output);
      if (!isOfSurfaces)
      {
        return subdivision::ProbeSolids(input, options, made);
      }
      vtkSmartPointer<vtkPolyData> surface = vtkPolyData::SafeDownCast(input);
      if (auto* grid = vtkUnstructuredGrid::SafeDownCast(input))
      {
        std::vector<std::string> warnings;
        surface = subdivision::MakeSurface(grid, true, false, warnings);
        subdivision::Tell(warnings, options);
      }
      // Cells have other ids now.
      return this->ReadFeatureOptions(surface, options) &&
        subdivision::ProbeSurfaces(surface, options, made);
    });
}

void vtkSubdivisionSmoothness::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Scheme: " << this->Scheme << "\n";
  os << indent << "SampleMaps: " << this->SampleMaps << "\n";
  os << indent << "FailingOnly: " << this->FailingOnly << "\n";
  os << indent << "MapOfCell: " << this->MapOfCell << "\n";
  os << indent << "MapLevels: " << this->MapLevels << "\n";
}
