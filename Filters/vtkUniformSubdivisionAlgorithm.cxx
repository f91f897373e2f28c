// SPDX-License-Identifier: BSD-3-Clause
#include "vtkUniformSubdivisionAlgorithm.h"

#include "Private/Bezier/BezierCells.h"
#include "Private/Curved/CurvedCells.h"
#include "Private/Curved/Prolongation.h"
#include "Private/Distribution/PartitionsOfRank.h"
#include "Private/Places/PlaceOutput.h"
#include "Private/Run/FilterRun.h"
#include "Private/Run/KeptEntries.h"

#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSubdivisionOperator.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

vtkUniformSubdivisionAlgorithm::vtkUniformSubdivisionAlgorithm()
  : Cache(std::make_unique<subdivision::KeptEntries>())
  , Bezier(std::make_unique<subdivision::BezierRounds>())
  , Nodes(std::make_unique<std::vector<subdivision::CurvedNodes>>())
{
}

vtkUniformSubdivisionAlgorithm::~vtkUniformSubdivisionAlgorithm() = default;

void vtkUniformSubdivisionAlgorithm::SetCacheOperator(bool cache)
{
  if (this->CacheOperator != cache)
  {
    this->CacheOperator = cache;
    this->Cache->Clear();
    this->Modified();
  }
}

vtkIdType vtkUniformSubdivisionAlgorithm::GetNumberOfTopologyBuilds() const
{
  return this->Cache->NumberOfBuilds;
}

bool vtkUniformSubdivisionAlgorithm::ComputeOperator(vtkSubdivisionOperator* result)
{
  return this->FindOperator(result);
}

bool vtkUniformSubdivisionAlgorithm::ComputeProlongation(vtkSubdivisionOperator* result)
{
  *result->Factors = subdivision::MatrixFactors();
  result->Modified();
  const int levels = this->NumberOfLevels;
  if (!this->WritesNodes() || levels == 0)
  {
    subdivision::Fail(this,
      "A prolongation goes from the nodes of curved cells to those of the next level: set "
      "OutputCells to Quadratic or Lagrange, with options that allow it, and NumberOfLevels to 1 "
      "or more.");
    return false;
  }
  subdivision::Prolongation found(this->GetKindOfNodes(), this->GetOrderOfNodes());
  this->Prolongs = &found;
  this->NumberOfLevels = levels - 1;
  const bool isCoarse = this->RunAside();
  this->NumberOfLevels = levels;
  const bool isFine = isCoarse && this->RunAside();
  this->Prolongs = nullptr;
  if (isFine && !found.IsFound())
  {
    subdivision::Fail(this,
      "The cells of level " + std::to_string(levels) + " are no parts of cells of level " +
        std::to_string(levels - 1) +
        ": faces that are no quads become curved cells after a level. Take one level more.");
  }
  if (!found.IsFound())
  {
    return false;
  }
  result->Factors->Append(std::move(found.Matrix));
  return true;
}

bool vtkUniformSubdivisionAlgorithm::WritesBezierCells() const
{
  return this->OutputCells == BEZIER_CELLS && this->HasOutput() && !this->Places &&
    !this->DescribeBezierNeeds();
}

bool vtkUniformSubdivisionAlgorithm::WritesNodes() const
{
  return this->OutputCells > BEZIER_CELLS && this->HasOutput() && !this->Places &&
    !this->DescribeCurvedNeeds();
}

bool vtkUniformSubdivisionAlgorithm::HasNodesBetweenLevels() const
{
  return this->OutputCells == LAGRANGE_CELLS && !subdivision::AreNodesOnLevels(this->CellOrder);
}

bool vtkUniformSubdivisionAlgorithm::AddsBounds() const
{
  return this->GenerateErrorBounds && this->HasOutput() && !this->Places &&
    !this->WritesCurvedCells();
}

void vtkUniformSubdivisionAlgorithm::Inspect(vtkDataObject*, vtkDataObject* readable)
{
  if (this->WritesBezierCells())
  {
    this->Bezier->SetFurtherSteps(
      subdivision::CountFurtherSteps(this->SharesRanks() ? nullptr : readable, this->MakesQuads()));
  }
  // The first level makes quads of other faces.
  this->LeastLevels = this->WritesNodes() && this->MakesQuads() &&
      subdivision::HasOtherCells(this->SharesRanks() ? nullptr : readable, true)
    ? 1
    : 0;
}

vtkSmartPointer<vtkDataObject> vtkUniformSubdivisionAlgorithm::Finish(vtkDataObject* made)
{
  return this->MakeCurvedCells(made, true);
}

subdivision::CurvedKind vtkUniformSubdivisionAlgorithm::GetKindOfNodes() const
{
  return this->OutputCells == QUADRATIC_CELLS ? subdivision::CurvedKind::Quadratic
                                              : subdivision::CurvedKind::Lagrange;
}

int vtkUniformSubdivisionAlgorithm::GetOrderOfNodes() const
{
  return this->OutputCells == QUADRATIC_CELLS ? 2 : this->CellOrder;
}

vtkSmartPointer<vtkDataObject> vtkUniformSubdivisionAlgorithm::MakeCurvedCells(
  vtkDataObject* made, bool isWhole)
{
  if (this->WritesNodes())
  {
    subdivision::CurvedOptions options;
    options.Kind = this->GetKindOfNodes();
    options.Order = this->GetOrderOfNodes();
    options.Use32BitIds = this->Use32BitIds;
    options.Warn = [this](const std::string& text) { subdivision::Warn(this, text); };
    options.Fail = [this](const std::string& text) { subdivision::Fail(this, text); };
    subdivision::PartitionsOfRank ofRank(this->SharesRanks() ? this->Controller.Get() : nullptr);
    subdivision::ExchangeOfAll ranks(ofRank);
    options.Ranks = this->Prolongs ? nullptr : &ranks;
    options.Kept = this->EvaluatesNodes() ? this->Nodes.get() : nullptr;
    auto curved = subdivision::MakeCurvedCells(made, options);
    if (this->Prolongs)
    {
      this->Prolongs->Take(vtkPointSet::SafeDownCast(made),
        subdivision::CountStepsOfNodes(options.Order), vtkUnstructuredGrid::SafeDownCast(curved));
    }
    return curved;
  }
  if (!this->WritesBezierCells())
  {
    return made;
  }
  subdivision::BezierOptions options;
  options.Tolerance = this->BezierTolerance;
  options.Use32BitIds = this->Use32BitIds;
  options.Controller = this->SharesRanks() ? this->Controller.Get() : nullptr;
  options.IsWhole = isWhole && !options.Controller;
  options.MaximumNumberOfCells = this->MaximumNumberOfCells;
  options.Fail = [this](const std::string& text) { subdivision::Fail(this, text); };
  return this->Bezier->Finish(made, options);
}

bool vtkUniformSubdivisionAlgorithm::FindLimit(
  vtkIdTypeArray* cells, vtkDataArray* parameters, vtkPolyData* result)
{
  result->Initialize();
  std::string error = subdivision::CheckPlaceArrays(cells, parameters);
  if (error.empty() && this->InterfaceValues == DISCONTINUOUS_VALUES)
  {
    error = "Places have no values that jump: switch InterfaceValues to Continuous.";
  }
  if (!error.empty())
  {
    subdivision::Fail(this, error);
    return false;
  }
  const subdivision::PlaceRequest request{ cells, parameters, result, nullptr };
  this->Places = &request;
  this->RunAside();
  this->Places = nullptr;
  return result->GetNumberOfPoints() == cells->GetNumberOfTuples();
}

void vtkUniformSubdivisionAlgorithm::ReadLevelOptions(subdivision::LevelOptions& options)
{
  const bool isBezier = this->OutputCells == BEZIER_CELLS;
  const char* const needs = isBezier ? this->DescribeBezierNeeds() : this->DescribeCurvedNeeds();
  const bool asks = this->OutputCells != LINEAR_CELLS && this->HasOutput() && !this->Places;
  if (asks && needs)
  {
    subdivision::Warn(this, needs);
  }
  if (asks && !needs && isBezier && this->GenerateGlobalIds)
  {
    subdivision::Warn(this, "Bezier cells have no global ids: GenerateGlobalIds is ignored.");
  }
  if (asks && !needs && this->GenerateErrorBounds)
  {
    subdivision::Warn(this,
      isBezier ? "Bezier cells have no error bounds: GenerateErrorBounds is ignored."
               : "Curved cells have no error bounds: GenerateErrorBounds is ignored.");
  }
  options.Levels = this->Places ? 0 : this->NumberOfLevels;
  // Nodes between the points of levels are evaluated on cells that are not projected.
  const bool evaluates = this->EvaluatesNodes();
  if (evaluates && (this->GenerateLimitNormals || this->GenerateTangents))
  {
    subdivision::Warn(this,
      "Nodes of CellOrder 3, 5 and 6 have no normals and tangents: GenerateLimitNormals and "
      "GenerateTangents are ignored. Set CellOrder to 1, 2 or 4.");
  }
  options.ProjectToLimit =
    (this->ProjectToLimit || this->WritesCurvedCells() || this->Places) && !evaluates;
  options.GenerateLimitNormals = this->GenerateLimitNormals && !this->Places && !evaluates;
  options.GenerateTangents = this->GenerateTangents && !this->Places && !evaluates;
  options.Use32BitIds = this->Use32BitIds;
  options.Cache = this->CacheOperator && !this->Places ? this->Cache.get() : nullptr;
  options.Places = this->Places;
}

void vtkUniformSubdivisionAlgorithm::AskForShading(
  subdivision::LevelOptions& options, bool areCheap) const
{
  if (!this->GenerateLimitNormals)
  {
    options.NormalsWhereSmooth = this->SmoothShading && areCheap && options.Levels > 0 &&
      !this->WritesCurvedCells() && !options.Others;
    options.GenerateLimitNormals = options.NormalsWhereSmooth;
  }
}

/// Nodes are points of further levels.
void vtkUniformSubdivisionAlgorithm::SetLevelsOfNodes(subdivision::LevelOptions& options) const
{
  const int steps = subdivision::CountStepsOfNodes(this->GetOrderOfNodes());
  options.Levels = std::max(this->NumberOfLevels, this->LeastLevels) + steps;
  options.MaximumNumberOfCells = this->MaximumNumberOfCells > VTK_ID_MAX >> (3 * steps)
    ? VTK_ID_MAX
    : this->MaximumNumberOfCells << (3 * steps);
}

/// Evaluates the nodes of cells that were made, and keeps them until Finish.
bool vtkUniformSubdivisionAlgorithm::EvaluateNodes(
  vtkPointSet* made, subdivision::LevelOptions& options, const Work& subdivide)
{
  const std::string order = "CellOrder " + std::to_string(this->CellOrder);
  if (this->SharesRanks() || this->InterfaceValues == DISCONTINUOUS_VALUES ||
    (this->MergePoints && this->MergedValues == KEEP_VALUES))
  {
    options.Fail(order +
      " is for one process and for values that do not jump, as its nodes are no points of levels: "
      "set CellOrder to 1, 2 or 4.");
    return false;
  }
  subdivision::CurvedNodes nodes;
  subdivision::NodePlaces places;
  if (!subdivision::ListNodes(
        made, subdivision::CurvedKind::Lagrange, this->CellOrder, options.Fail, nodes, places))
  {
    return false;
  }
  vtkNew<vtkPolyData> points;
  nodes.Points = points;
  if (this->Prolongs) // which asks for numbers only
  {
    vtkNew<vtkPoints> none;
    none->SetNumberOfPoints(places.Cells->GetNumberOfTuples());
    points->SetPoints(none);
    subdivision::KeepNodes(std::move(nodes), made, *this->Nodes);
    return true;
  }
  // The same filter goes on with its own output: the stamp has features and control values.
  subdivision::LevelOptions before = options;
  subdivision::PlaceRequest request{ places.Cells, places.Parameters, points };
  request.HasDerivatives = false;
  options.Places = &request;
  options.Levels = 0;
  options.ProjectToLimit = true;
  options.Cache = nullptr;
  options.GenerateOriginalIds = options.GenerateGlobalIds = false;
  options.Interpolation = subdivision::InterpolationOptions();
  const auto scratch = vtkSmartPointer<vtkPointSet>::Take(made->NewInstance());
  bool isDone = this->ReadFeatureOptions(made, options);
  options.Features.Marks = subdivision::MarkOptions();
  isDone = isDone && subdivide(made, scratch);
  options = std::move(before);
  subdivision::KeepNodes(std::move(nodes), made, *this->Nodes);
  return isDone;
}

int vtkUniformSubdivisionAlgorithm::RunLevels(vtkInformationVector** inputVector,
  vtkInformationVector* outputVector, subdivision::LevelOptions& options, bool isLocal,
  const Work& subdivide, const Work& addBounds)
{
  const bool writesBezierCells = this->WritesBezierCells();
  const bool addsBounds = this->AddsBounds();
  const bool evaluates = this->EvaluatesNodes();
  this->Nodes->clear();
  const int result = this->Bezier->Run(writesBezierCells ? this->NumberOfLevels : -1, options,
    [&]
    {
      return this->Run(inputVector, outputVector, options, isLocal ? "" : nullptr,
        "NumberOfLevels = " + std::to_string(this->NumberOfLevels) +
          ". Use fewer levels, or a part of the input.",
        [&](vtkPointSet* input, vtkPointSet* output)
        {
          if (writesBezierCells)
          {
            this->Bezier->SetLevels(options);
          }
          else if (this->WritesNodes())
          {
            this->SetLevelsOfNodes(options);
          }
          return subdivide(input, output) && (!addsBounds || addBounds(input, output)) &&
            (!evaluates || this->EvaluateNodes(output, options, subdivide));
        });
    });
  this->Nodes->clear();
  return result;
}

void vtkUniformSubdivisionAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfLevels: " << this->NumberOfLevels << "\n";
  os << indent << "ProjectToLimit: " << this->ProjectToLimit << "\n";
  os << indent << "GenerateLimitNormals: " << this->GenerateLimitNormals << "\n";
  os << indent << "SmoothShading: " << this->SmoothShading << "\n";
  os << indent << "GenerateTangents: " << this->GenerateTangents << "\n";
  os << indent << "GenerateErrorBounds: " << this->GenerateErrorBounds << "\n";
  os << indent << "OutputCells: " << this->OutputCells << "\n";
  os << indent << "CellOrder: " << this->CellOrder << "\n";
  os << indent << "BezierTolerance: " << this->BezierTolerance << "\n";
  os << indent << "Use32BitIds: " << this->Use32BitIds << "\n";
  os << indent << "CacheOperator: " << this->CacheOperator << "\n";
  os << indent << "Operators kept: " << this->Cache->GetNumberOfEntries() << " ("
     << this->Cache->GetMemorySize() << " bytes)\n";
  os << indent << "NumberOfTopologyBuilds: " << this->Cache->NumberOfBuilds << "\n";
}
