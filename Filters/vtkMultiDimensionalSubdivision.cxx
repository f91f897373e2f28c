// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMultiDimensionalSubdivision.h"

#include "Private/Arrays/Arrays.h"
#include "Private/Distribution/Dimensions.h"
#include "Private/Reading/CellChecks.h"
#include "Private/Run/FilterRun.h"
#include "Private/Uniform/UniformBounds.h"
#include "Private/Uniform/UniformSubdivision.h"
#include "Private/vtkSubdivisionObjectsCompat.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <tuple>
#include <vector>

namespace
{

/// Members that get back their values at the end of a scope.
template <typename Members>
class Given;
template <typename... Values>
class Given<std::tuple<Values&...>>
{
public:
  explicit Given(const std::tuple<Values&...>& members)
    : Members(members)
    , Before(members)
  {
  }
  ~Given() { this->Members = this->Before; }
  Given(const Given&) = delete;
  Given& operator=(const Given&) = delete;

private:
  std::tuple<Values&...> Members;
  const std::tuple<Values...> Before;
};

}

vtkStandardNewMacro(vtkMultiDimensionalSubdivision);

vtkMultiDimensionalSubdivision::vtkMultiDimensionalSubdivision() = default;
vtkMultiDimensionalSubdivision::~vtkMultiDimensionalSubdivision() = default;

void vtkMultiDimensionalSubdivision::AddOutputDimension(int dimension)
{
  if (dimension >= 0 && dimension <= 3)
  {
    this->SetOutputDimensions(this->OutputDimensions | 1 << dimension);
  }
}

const char* vtkMultiDimensionalSubdivision::DescribeBezierNeeds() const
{
  return this->KeepCellTypes || this->VolumeScheme == TET_OCT || this->VolumeScheme == HYBRID
    ? "Bezier cells need VolumeScheme = BoxSpline or Linear, no KeepCellTypes: they stay linear."
    : nullptr;
}

const char* vtkMultiDimensionalSubdivision::DescribeCurvedNeeds() const
{
  return this->KeepCellTypes && this->VolumeScheme == LINEAR && this->HasNodesBetweenLevels()
    ? "CellOrder 3, 5 and 6 need no KeepCellTypes: the cells stay linear."
    : nullptr;
}

vtkSmartPointer<vtkDataObject> vtkMultiDimensionalSubdivision::Finish(vtkDataObject* made)
{
  const auto part = subdivision::TakeDimensions(made, this->OutputDimensions, !this->SharesRanks(),
    [this](const std::string& text) { subdivision::Warn(this, text); });
  return this->MakeCurvedCells(part, part == made);
}

bool vtkMultiDimensionalSubdivision::EvaluateLimit(
  vtkIdTypeArray* cells, vtkDataArray* parameters, vtkPolyData* result)
{
  return this->FindLimit(cells, parameters, result);
}

bool vtkMultiDimensionalSubdivision::MakeLevelAside(int level, bool isFirst,
  const std::pair<double, double>& part, vtkInformationVector** inputVector,
  vtkSubdivisionOperator* found)
{
  auto options = std::tie(this->NumberOfLevels, this->ProjectToLimit, this->GenerateOriginalIds,
    this->GenerateGlobalIds, this->OutputPointsPrecision, this->CacheOperator,
    this->GenerateLimitNormals, this->SmoothShading, this->GenerateTangents,
    this->GenerateErrorBounds, this->GenerateClassification, this->OutputCells);
  const Given<decltype(options)> given(options); // also where memory ends
  options = std::make_tuple(std::max(level, 0), level >= 0, true, false, int(DOUBLE_PRECISION),
    false, false, false, false, false, false, int(LINEAR_CELLS));
  if (found)
  {
    return this->FindOperator(found);
  }
  vtkNew<vtkInformationVector> made;
  made->SetNumberOfInformationObjects(1);
  this->vtkMultiDimensionalSubdivision::RequestDataObject(nullptr, inputVector, made);
  // Levels are told as time steps: one of another time repeats no warning.
  this->NumberOfRunsAside += isFirst ? 0. : 1.;
  made->GetInformationObject(0)->Set(
    vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP(), this->NumberOfRunsAside);
  this->SetProgressShiftScale(part.first, part.second);
  return this->vtkMultiDimensionalSubdivision::RequestData(nullptr, inputVector, made) != 0;
}

bool vtkMultiDimensionalSubdivision::IsStopped()
{
  const double own = subdivision::IsAborted(this) ? 1. : 0.;
  const auto all = this->SharesRanks() ? subdivision::GatherFromRanks(this->Controller, { own })
                                       : std::vector<double>{ own };
  return std::find(all.begin(), all.end(), 1.) != all.end();
}

int vtkMultiDimensionalSubdivision::GetLayersOfCells() const
{
  const bool readsLimit = this->ProjectToLimit || this->GenerateLimitNormals ||
    this->GenerateTangents || this->InterpolatePoints || this->InterpolateArrays;
  const int further = this->GenerateErrorBounds ? 1 : 0; // deviations next to a cell count
  // The border of the outermost layer has angles that the whole has not: creases that end too
  // early.
  const bool mayKeepTypes = this->VolumeScheme == HYBRID || this->VolumeScheme == AUTOMATIC;
  return further +
    ((this->VolumeScheme != BOX_SPLINE && readsLimit) || (mayKeepTypes && this->DetectFeatures)
        ? 3
        : 2);
}

int vtkMultiDimensionalSubdivision::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  subdivision::UniformOptions options;
  const bool isHybrid = this->VolumeScheme == HYBRID;
  options.Scheme = subdivision::GetVolumeScheme(this->VolumeScheme);
  const bool keepsTypes = this->KeepCellTypes && this->VolumeScheme == LINEAR;
  if (this->KeepCellTypes && !keepsTypes && !isHybrid)
  {
    subdivision::Warn(this, "KeepCellTypes needs VolumeScheme = Linear: it is ignored.");
  }
  if (keepsTypes &&
    (this->GenerateClassification || this->GenerateLimitNormals || this->GenerateTangents))
  {
    subdivision::Warn(this,
      "With KeepCellTypes there are no rules and normals: GenerateClassification, "
      "GenerateLimitNormals and GenerateTangents are ignored.");
  }
  this->ReadLevelOptions(options);
  options.KeepCellTypes = isHybrid || (keepsTypes && !this->Places);
  options.GenerateClassification = this->GenerateClassification && !this->Places;
  if (keepsTypes && !this->Places)
  {
    options.GenerateLimitNormals = options.GenerateTangents = false;
  }
  const bool addsBounds = this->AddsBounds();
  options.KeepsCopies = addsBounds;
  options.KeepsTypesIfPossible = this->VolumeScheme == AUTOMATIC;
  options.NeedsCuts = !options.KeepsTypesIfPossible ? nullptr
    : this->WritesBezierCells()                     ? "OutputCells = Bezier"
    : addsBounds                                    ? "GenerateErrorBounds"
                                                    : nullptr;
  // A level reads points of cells around each cell only, linear rules only points of the cell
  // itself.
  const bool readsLimit = options.ProjectToLimit || options.GenerateLimitNormals ||
    this->GenerateTangents || this->InterpolatePoints || this->InterpolateArrays || addsBounds;
  const bool isLocal = this->VolumeScheme == LINEAR || (this->NumberOfLevels <= 1 && !readsLimit);
  return this->RunLevels(
    inputVector, outputVector, options, isLocal,
    [&](vtkPointSet* input, vtkPointSet* output)
    {
      this->AskForShading(
        options, this->VolumeScheme != LINEAR && !(isLocal && subdivision::HasDuplicates(input)));
      auto* const grid = vtkUnstructuredGrid::SafeDownCast(output);
      return this->Torn ? subdivision::SubdivideWithSeams(input, this->Torn, options, grid)
                        : subdivision::SubdivideUniformly(input, options, grid);
    },
    [&](vtkPointSet* input, vtkPointSet* output)
    {
      return subdivision::AddUniformBounds(
        input, options, vtkUnstructuredGrid::SafeDownCast(output));
    });
}

void vtkMultiDimensionalSubdivision::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "VolumeScheme: " << this->VolumeScheme << "\n";
  os << indent << "KeepCellTypes: " << this->KeepCellTypes << "\n";
  os << indent << "GenerateClassification: " << this->GenerateClassification << "\n";
  os << indent << "OutputDimensions: " << this->OutputDimensions << "\n";
}
