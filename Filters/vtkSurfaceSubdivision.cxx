// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceSubdivision.h"

#include "Private/Reading/InputArrays.h"
#include "Private/Run/FilterRun.h"
#include "Private/Surface/SurfaceBounds.h"

#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <string>

vtkStandardNewMacro(vtkSurfaceSubdivision);

vtkSurfaceSubdivision::vtkSurfaceSubdivision() = default;
vtkSurfaceSubdivision::~vtkSurfaceSubdivision() = default;

bool vtkSurfaceSubdivision::EvaluateLimit(
  vtkIdTypeArray* cells, vtkDataArray* parameters, vtkPolyData* result)
{
  if (this->Scheme != LOOP && this->Scheme != CATMULL_CLARK)
  {
    result->Initialize();
    subdivision::Fail(this, "Places have limits with Scheme = Loop or CatmullClark only.");
    return false;
  }
  return this->FindLimit(cells, parameters, result);
}

const char* vtkSurfaceSubdivision::DescribeBezierNeeds() const
{
  return this->Scheme == LOOP || this->Scheme == CATMULL_CLARK || this->Scheme == LINEAR
    ? nullptr
    : "Bezier cells need Scheme = Loop, CatmullClark or Linear: the cells stay linear.";
}

int vtkSurfaceSubdivision::GetLayersOfCells() const
{
  return subdivision::CountLayersOfSurface(
    static_cast<subdivision::SurfaceSchemeKind>(this->Scheme));
}

int vtkSurfaceSubdivision::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  subdivision::SurfaceOptions options;
  this->ReadLevelOptions(options);
  options.Scheme = static_cast<subdivision::SurfaceSchemeKind>(this->Scheme);
  if (this->Scheme == LINEAR && this->WritesBezierCells())
  {
    options.ProjectToLimit = this->ProjectToLimit;
  }
  options.JoinSeams = this->JoinSeams;
  options.KeepsMerged = this->MergePoints && this->MergedValues == KEEP_VALUES;
  // Without rules for boundaries that angles decide, a level reads points of cells around only.
  const bool isLocal =
    !this->ModifiedBoundary && (this->Scheme == LOOP || this->Scheme == CATMULL_CLARK);
  return this->RunLevels(
    inputVector, outputVector, options, isLocal,
    [&](vtkPointSet* input, vtkPointSet* output)
    {
      if (this->Places && this->OutputPointsPrecision == DEFAULT_PRECISION)
      {
        options.OutputPointsPrecision = DOUBLE_PRECISION;
      }
      vtkDataArray* flatness = nullptr;
      const bool isRead =
        subdivision::FindInputArray(this, input->GetPointData(), input->GetNumberOfPoints(),
          { FLATNESS_ARRAY, nullptr, false, true }, options.Warn, options.Fail, flatness);
      options.Flatness = flatness;
      return isRead &&
        subdivision::SubdivideSurface(
          vtkPolyData::SafeDownCast(input), options, vtkPolyData::SafeDownCast(output));
    },
    [&](vtkPointSet* input, vtkPointSet* output)
    {
      return subdivision::AddSurfaceBounds(
        vtkPolyData::SafeDownCast(input), options, vtkPolyData::SafeDownCast(output));
    });
}

void vtkSurfaceSubdivision::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Scheme: " << this->Scheme << "\n";
  os << indent << "JoinSeams: " << this->JoinSeams << "\n";
}
