// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceSubdivision.h"

#include "Private/Reading/InputArrays.h"
#include "Private/Run/FilterRun.h"
#include "Private/Surface/FaceCounts.h"
#include "Private/Surface/SurfaceBounds.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <string>

vtkStandardNewMacro(vtkSurfaceSubdivision);

vtkSurfaceSubdivision::vtkSurfaceSubdivision() = default;
vtkSurfaceSubdivision::~vtkSurfaceSubdivision() = default;

bool vtkSurfaceSubdivision::EvaluateLimit(
  vtkIdTypeArray* cells, vtkDataArray* parameters, vtkPolyData* result)
{
  if (this->Scheme != LOOP && this->Scheme != CATMULL_CLARK && this->Scheme != AUTOMATIC)
  {
    result->Initialize();
    subdivision::Fail(this, "Places have limits with Scheme = Loop or CatmullClark only.");
    return false;
  }
  return this->FindLimit(cells, parameters, result);
}

const char* vtkSurfaceSubdivision::DescribeBezierNeeds() const
{
  const int scheme = this->GetSchemeInUse();
  return scheme == LOOP || scheme == CATMULL_CLARK || scheme == LINEAR
    ? nullptr
    : "Bezier cells need Scheme = Loop, CatmullClark or Linear: the cells stay linear.";
}

const char* vtkSurfaceSubdivision::DescribeCurvedNeeds() const
{
  return this->DescribeBezierNeeds()
    ? "Curved cells need Scheme = Loop, CatmullClark or Linear: the cells stay linear."
    : this->GetSchemeInUse() == LINEAR && this->HasNodesBetweenLevels()
    ? "CellOrder 3, 5 and 6 need Scheme = Loop or CatmullClark: the cells stay linear."
    : nullptr;
}

int vtkSurfaceSubdivision::GetLayersOfCells() const
{
  return subdivision::CountLayersOfSurface(
    static_cast<subdivision::SurfaceSchemeKind>(this->GetSchemeInUse()));
}

void vtkSurfaceSubdivision::Inspect(vtkDataObject* input, vtkDataObject* readable)
{
  if (this->Scheme == AUTOMATIC)
  {
    this->FacesOfRank = subdivision::CountFaces(readable);
    this->Automatic = subdivision::HasMostlyQuads(this->FacesOfRank) ? CATMULL_CLARK : LOOP;
  }
  this->Superclass::Inspect(input, readable);
}

/// All ranks take the scheme that fits the faces of all.
void vtkSurfaceSubdivision::Agree()
{
  if (this->Scheme == AUTOMATIC && this->SharesRanks())
  {
    subdivision::FaceCounts all;
    this->Controller->AllReduce(
      this->FacesOfRank.data(), all.data(), all.size(), vtkCommunicator::SUM_OP);
    this->Automatic = subdivision::HasMostlyQuads(all) ? CATMULL_CLARK : LOOP;
  }
}

int vtkSurfaceSubdivision::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  subdivision::SurfaceOptions options;
  this->ReadLevelOptions(options);
  this->FacesOfRank = {}; // reading may fail on one rank only
  if (this->Scheme == LINEAR && this->WritesCurvedCells())
  {
    options.ProjectToLimit = this->ProjectToLimit;
  }
  options.JoinSeams = this->JoinSeams;
  options.SplitSharpEdges = this->SplitSharpEdges;
  options.KeepsMerged = this->MergePoints && this->MergedValues == KEEP_VALUES;
  // Without rules for boundaries that angles decide, a level reads points of cells around only.
  const bool isLocal = !this->ModifiedBoundary &&
    (this->Scheme == LOOP || this->Scheme == CATMULL_CLARK || this->Scheme == AUTOMATIC);
  return this->RunLevels(
    inputVector, outputVector, options, isLocal,
    [&](vtkPointSet* input, vtkPointSet* output)
    {
      if (this->Places && this->OutputPointsPrecision == DEFAULT_PRECISION)
      {
        options.OutputPointsPrecision = DOUBLE_PRECISION;
      }
      options.Scheme = static_cast<subdivision::SurfaceSchemeKind>(this->GetSchemeInUse());
      vtkDataArray* flatness = nullptr;
      const bool isRead =
        subdivision::FindInputArray(this, input->GetPointData(), input->GetNumberOfPoints(),
          { FLATNESS_ARRAY, nullptr, false, true }, options.Warn, options.Fail, flatness);
      options.Flatness = flatness;
      vtkDataArray* normals = nullptr;
      const bool areRead = isRead && this->ReadNormals(input, options, normals);
      options.Interpolation.Normals = normals;
      this->AskForShading(options,
        options.Scheme == subdivision::SurfaceSchemeKind::Loop ||
          options.Scheme == subdivision::SurfaceSchemeKind::CatmullClark);
      return areRead &&
        subdivision::SubdivideSurface(
          vtkPolyData::SafeDownCast(input), options, vtkPolyData::SafeDownCast(output));
    },
    [&](vtkPointSet* input, vtkPointSet* output)
    {
      return subdivision::AddSurfaceBounds(
        vtkPolyData::SafeDownCast(input), options, vtkPolyData::SafeDownCast(output));
    });
}

bool vtkSurfaceSubdivision::ReadNormals(
  vtkPointSet* input, const subdivision::RunOptions& options, vtkDataArray*& normals)
{
  if (!subdivision::FindInputArray(this, input->GetPointData(), input->GetNumberOfPoints(),
        { NORMAL_ARRAY, nullptr, false, true, true }, options.Warn, options.Fail, normals))
  {
    return false;
  }
  std::string fault =
    normals && normals->GetNumberOfComponents() != 3 ? "need three components" : "";
  if (normals && !this->HasOutput())
  {
    options.Fail("Normals (array index 14) have no operator of few entries: take no array.");
    return false;
  }
  for (vtkIdType i = 0; normals && fault.empty() && i < 3 * normals->GetNumberOfTuples(); ++i)
  {
    if (!std::isfinite(normals->GetComponent(i / 3, static_cast<int>(i % 3))))
    {
      fault = "are not finite at point " + std::to_string(i / 3);
    }
  }
  if (!fault.empty())
  {
    options.Fail("Normals (array index 14) " + fault + ". Give zero vectors where they are free.");
  }
  return fault.empty();
}

void vtkSurfaceSubdivision::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Scheme: " << this->Scheme << "\n";
  os << indent << "SchemeInUse: " << this->GetSchemeInUse() << "\n";
  os << indent << "JoinSeams: " << this->JoinSeams << "\n";
  os << indent << "SplitSharpEdges: " << this->SplitSharpEdges << "\n";
}
