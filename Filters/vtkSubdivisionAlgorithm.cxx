// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSubdivisionAlgorithm.h"
#include "vtkSubdivisionOperator.h"

#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Arrays/MatrixArrays.h"
#include "Private/Control/CoincidentPoints.h"
#include "Private/Distribution/Distribution.h"
#include "Private/Distribution/KeptParts.h"
#include "Private/Reading/CellChecks.h"
#include "Private/Reading/HangingNodes.h"
#include "Private/Reading/InputArrays.h"
#include "Private/Reading/ReadableMesh.h"
#include "Private/Run/ControlCounts.h"
#include "Private/Run/FilterRun.h"
#include "Private/Run/Ports.h"
#include "Private/Run/ToldWarnings.h"
#include "Private/Surface/FaceCounts.h"
#include "Private/Surface/SurfaceInput.h"
#include "Private/Values/MaterialFields.h"
#include "Private/Values/MissingValues.h"
#include "Private/Values/SharedInterpolation.h"
#include "Private/vtkSubdivisionObjectsCompat.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkDataObjectTree.h"
#include "vtkDataSet.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleKey.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <limits>
#include <vector>

vtkSubdivisionAlgorithm::vtkSubdivisionAlgorithm()
  : Controller(vtkMultiProcessController::GetGlobalController())
  , Kept(std::make_unique<subdivision::KeptParts>())
  , Told(std::make_unique<subdivision::ToldWarnings>())
{
}
vtkSubdivisionAlgorithm::~vtkSubdivisionAlgorithm() = default;

vtkCxxSetSmartPointerMacro(vtkSubdivisionAlgorithm, Controller, vtkMultiProcessController);

vtkMultiProcessController* vtkSubdivisionAlgorithm::GetController() const
{
  return this->Controller;
}

void vtkSubdivisionAlgorithm::AddInterpolatedArray(const char* name)
{
  if (name)
  {
    this->InterpolatedArrays.emplace_back(name);
    this->Modified();
  }
}

void vtkSubdivisionAlgorithm::RemoveAllInterpolatedArrays()
{
  if (!this->InterpolatedArrays.empty())
  {
    this->InterpolatedArrays.clear();
    this->Modified();
  }
}

void vtkSubdivisionAlgorithm::AddFieldOfCells(const char* name)
{
  if (name)
  {
    this->FieldsOfCells.emplace_back(name);
    this->Modified();
  }
}

void vtkSubdivisionAlgorithm::RemoveAllFieldsOfCells()
{
  if (!this->FieldsOfCells.empty())
  {
    this->FieldsOfCells.clear();
    this->Modified();
  }
}

bool vtkSubdivisionAlgorithm::SharesRanks() const
{
  return this->JoinBlocks && this->Controller && this->Controller->GetNumberOfProcesses() > 1;
}

int vtkSubdivisionAlgorithm::FillInputPortInformation(int, vtkInformation* info)
{
  // Without the last two VTK would run the filter once for each block.
  return subdivision::TakeTypes(info,
    { "vtkUnstructuredGrid", "vtkPolyData", "vtkImageData", "vtkRectilinearGrid",
      "vtkStructuredGrid", "vtkExplicitStructuredGrid", "vtkDataObjectTree", "vtkUniformGridAMR" });
}

/// RequestDataObject makes the output, which may be a composite data set.
int vtkSubdivisionAlgorithm::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject");
  return 1;
}

int vtkSubdivisionAlgorithm::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  subdivision::RequestOutput(
    vtkDataObject::GetData(inputVector[0]), this->WritesSurfaces(), outputVector);
  return 1;
}

/// Other ranks are asked for their cells in another way.
int vtkSubdivisionAlgorithm::ComputeInputUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  vtkInformation* info = inputVector[0]->GetInformationObject(0);
  if (info && this->JoinBlocks && this->Controller && this->Controller->GetNumberOfProcesses() > 1)
  {
    info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  }
  return 1;
}

double* vtkSubdivisionAlgorithm::GetControlCounts()
{
  vtkDataObject* const input =
    this->GetNumberOfInputConnections(0) > 0 ? this->GetInputDataObject(0, 0) : nullptr;
  const vtkMTimeType time = input ? input->GetMTime() : 0;
  if (time != this->TimeOfCounts) // a panel asks at each move of a slider
  {
    this->Counts = subdivision::CountControlCells(input);
    this->TimeOfCounts = time;
  }
  return this->Counts.data();
}

vtkSmartPointer<vtkDataObject> vtkSubdivisionAlgorithm::ReadInput(
  vtkDataObject* input, std::vector<std::string>& warnings)
{
  this->Torn = nullptr;
  const auto rule = this->QuadraticCells == PIECES ? subdivision::NonLinearRule::Pieces
                                                   : subdivision::NonLinearRule::Corners;
  const auto readable = subdivision::MakeReadable(input, rule, warnings);
  if (!readable)
  {
    return readable;
  }
  return this->MergePoints ? this->MergeIn(readable, warnings) : this->JoinIn(readable, warnings);
}

bool vtkSubdivisionAlgorithm::KeepsCopies() const
{
  return this->MergePoints && this->MergedValues == KEEP_VALUES && !this->HasSeams() &&
    this->HasInterfaces() && this->InterfaceValues == CONTINUOUS_VALUES && !this->SharesRanks();
}

vtkSmartPointer<vtkDataObject> vtkSubdivisionAlgorithm::MergeIn(
  vtkDataObject* readable, std::vector<std::string>& warnings)
{
  subdivision::MergeOptions options;
  options.Tolerance = this->MergeTolerance;
  options.Values = static_cast<subdivision::MergedValues>(this->MergedValues);
  options.InterpolateIntegers = this->InterpolateIntegers;
  options.JoinsBlocks = this->JoinBlocks;
  options.HasSeams = this->HasSeams();
  options.KeepsTexture = this->HasSeams() && this->JoinsSeams();
  options.HasCopies = this->KeepsCopies();
  if (this->MergedValues == KEEP_VALUES && !options.HasSeams && !options.HasCopies)
  {
    options.Values = subdivision::MergedValues::First;
    warnings.emplace_back("With these options the filter cannot keep all values of points that it "
                          "merges: it takes the first, as MergedValues = First does.");
  }
  if (this->SharesRanks() && options.Tolerance > 0.)
  {
    options.Tolerance = 0.;
    warnings.emplace_back("No rank knows all points that are near each other: the filter ignores "
                          "MergeTolerance, and MergePoints joins equal points. Apply "
                          "vtkStaticCleanUnstructuredGrid (surfaces: vtkCleanPolyData) with a "
                          "tolerance before the mesh is distributed.");
  }
  return subdivision::MergeCoincidentPoints(readable, options, warnings);
}

vtkSmartPointer<vtkDataObject> vtkSubdivisionAlgorithm::JoinIn(
  vtkDataObject* readable, std::vector<std::string>& warnings)
{
  subdivision::MergeOptions options;
  options.InterpolateIntegers = this->InterpolateIntegers;
  options.JoinsBlocks = this->JoinBlocks;
  options.KeepsTexture = this->HasSeams() && this->JoinsSeams();
  options.TearsTexture = this->TearsSeams();
  options.Values = this->MergedValues == AVERAGE_VALUE ? subdivision::MergedValues::Average
                                                       : subdivision::MergedValues::First;
  if (!this->JoinSides || !this->CanJoinSides() ||
    !subdivision::FindSides(readable, this->SharesRanks(), options, warnings))
  {
    return readable;
  }
  this->Torn = options.TearsTexture ? vtkPointSet::SafeDownCast(readable) : nullptr;
  return subdivision::MergeCoincidentPoints(readable, options, warnings);
}

vtkSmartPointer<vtkDataObject> vtkSubdivisionAlgorithm::Mark(
  vtkDataObject*, vtkDataObject* readable)
{
  return readable;
}

vtkSmartPointer<vtkDataObject> vtkSubdivisionAlgorithm::Finish(vtkDataObject* made)
{
  return made;
}

int vtkSubdivisionAlgorithm::Run(vtkInformationVector** inputVector,
  vtkInformationVector* outputVector, subdivision::RunOptions& options, const char* ghosts,
  const std::string& memory, const std::function<bool(vtkPointSet*, vtkPointSet*)>& run)
{
  subdivision::FilterTraits traits;
  traits.WrongInput = "The input is missing, or is of a type that this filter does not read.";
  traits.Ghosts = ghosts;
  traits.Memory = memory;
  subdivision::ReadSharedOptions(this, options);
  subdivision::DistributionOptions distribution;
  distribution.JoinBlocks = this->JoinBlocks;
  distribution.Controller = this->Controller;
  distribution.IsOfSurfaces = this->IsOfSurfaces();
  distribution.Kept = this->Kept.get();
  if (this->SharesRanks() && this->HasGhostLayers())
  {
    distribution.GhostLayers =
      vtkStreamingDemandDrivenPipeline::GetUpdateGhostLevel(outputVector->GetInformationObject(0));
  }
  this->ReadInterpolation(options, distribution.Warnings);
  bool hasFields = this->InterfaceValues == DISCONTINUOUS_VALUES;
  if (hasFields && !(this->HasInterfaces() && this->PreserveInterfaces))
  {
    distribution.Warnings.emplace_back(this->HasInterfaces()
        ? "Values can jump at interfaces that are kept only: InterfaceValues is ignored. Switch "
          "PreserveInterfaces on."
        : "With these options the filter has no values that jump at interfaces: it ignores "
          "InterfaceValues.");
    hasFields = false;
  }
  distribution.AddBlockIndex = this->PreserveInterfaces;
  distribution.Prepare = [this](vtkPointSet* block, vtkPointSet* copy)
  { this->Prepare(block, copy); };
  const vtkSmartPointer<vtkDataObject> given =
    subdivision::MakeTree(vtkDataObject::GetData(inputVector[0]));
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  vtkSmartPointer<vtkDataObject> made = output;
  if (this->IsOfSurfaces() && vtkUnstructuredGrid::SafeDownCast(output))
  {
    made = vtkSmartPointer<vtkPolyData>::New();
  }
  vtkSmartPointer<vtkDataObject> readable;
  subdivision::PointSources sources;
  bool failed = false;
  this->PrepareRun(given);
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkInformationDoubleKey* const step = vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP();
  const subdivision::ProgressPart all = options.Part;
  if (all.Begin > 0.) // what was made before is not enough
  {
    this->Told->GoOn();
    output->Initialize();
  }
  else
  {
    this->Told->Begin(this->GetMTime(),
      info->Has(step) ? info->Get(step) : std::numeric_limits<double>::quiet_NaN());
  }
  options.Told = this->Told.get();
  options.Factors = this->Factors;
  options.Part = all.Take(0., 0.05);
  subdivision::ConnectToFilter(this, options, failed);
  const bool isRead = subdivision::DoWork(traits, options,
    [&]
    {
      readable = this->ReadInput(given, distribution.Warnings);
      this->Inspect(given, readable);
      readable = subdivision::RemoveMergedPoints(
        this->Mark(given, readable), distribution.Prepare, options.Warn, sources);
      subdivision::AppendSources(sources, given, this->Factors);
      if (this->IsOfSurfaces())
      {
        readable = this->MakeSurfaces(readable, distribution.Warnings);
      }
      return true;
    });
  if (!isRead && !this->SharesRanks()) // other ranks wait for this one
  {
    output->Initialize();
    return failed ? 0 : 1;
  }
  this->Agree();
  distribution.Layers = this->GetLayersOfCells();
  options.Part = all.Take(0.05, 0.95);
  subdivision::MaterialFieldOptions fields;
  fields.IsOn = hasFields;
  fields.CellArrays = this->FieldsOfCells;
  if (this->KeepsCopies())
  {
    fields.IsOn = fields.OfMergedParts = hasFields = true;
    fields.CellArrays.clear();
  }
  distribution.KeepsOwnValues = hasFields;
  bool hasCases = false;
  distribution.HasCases = &hasCases;
  distribution.ReadsOwnBlocks = this->HasInterfaces() && !hasFields;
  // Whether cells are faces of others, and so have no values of their own, shows one layer farther.
  distribution.Layers += (hasFields || vtkDataObjectTree::SafeDownCast(readable) ? 1 : 0) +
    (this->CloseHangingNodes ? 1 : 0);
  if (this->CloseHangingNodes)
  {
    distribution.Change = [&options](vtkPointSet* mesh)
    {
      std::vector<std::string> warnings;
      auto closed = subdivision::CloseHangingNodes(mesh, warnings);
      subdivision::Tell(warnings, options);
      return closed;
    };
  }
  const int result =
    subdivision::RunDistributed(this, readable, made, distribution, traits, options,
      [&](vtkPointSet* mesh, vtkPointSet* subdivided)
      {
        if (!this->ReadFeatureOptions(mesh, options))
        {
          return false;
        }
        options.Features.MergesPoints |= hasCases;
        const std::string thin = ghosts
          ? std::string()
          : subdivision::DescribeThinLayers(mesh, this->GetLayersOfCells(),
              !this->IsOfSurfaces() && !options.Features.ModifiedBoundary);
        if (!thin.empty())
        {
          options.Warn(thin);
        }
        const auto runMesh = [&](vtkPointSet* masked, vtkPointSet* to)
        {
          return this->HasInterfaces()
            ? subdivision::RunWithMaterialFields(masked, to, options, fields, run)
            : run(masked, to);
        };
        return subdivision::RunWithMissingValues(mesh, subdivided, options, runMesh);
      });
  this->Torn = nullptr;
  if (this->GenerateOriginalIds)
  {
    subdivision::RestoreOriginalPoints(made, sources);
  }
  subdivision::RestoreSourceCells(this->IsOfSurfaces() ? made.Get() : nullptr);
  options.Part = all.Take(0.95, 1.);
  subdivision::ConnectToFilter(this, options, failed);
  const auto finish = [&]
  {
    const auto finished = this->Finish(made);
    if (finished != output)
    {
      output->ShallowCopy(finished);
    }
    return true;
  };
  if (!subdivision::DoWork(traits, options, finish))
  {
    output->Initialize();
    return failed ? 0 : result;
  }
  return result;
}

bool vtkSubdivisionAlgorithm::RunAside()
{
  int port = 0;
  vtkAlgorithm* source = this->GetInputAlgorithm(0, 0, port);
  if (source)
  {
    source->Update(port);
  }
  auto* input = source ? vtkDataSet::SafeDownCast(source->GetOutputDataObject(port)) : nullptr;
  if (!input || this->SharesRanks())
  {
    subdivision::Fail(this,
      "This is for one mesh in this process: the input is missing, consists of blocks, "
      "or is shared by several ranks.");
    return false;
  }
  subdivision::ForgetStop(this);
  vtkNew<vtkInformationVector> outputs;
  outputs->SetNumberOfInformationObjects(1);
  vtkInformationVector** inputs = this->GetExecutive()->GetInputInformation();
  this->RequestDataObject(nullptr, inputs, outputs);
  return this->RequestData(nullptr, inputs, outputs) != 0;
}

bool vtkSubdivisionAlgorithm::FindOperator(vtkSubdivisionOperator* found)
{
  *found->Factors = subdivision::MatrixFactors();
  found->Modified();
  if (this->InterpolatePoints || this->InterpolateArrays ||
    this->InterfaceValues == DISCONTINUOUS_VALUES || this->KeepsCopies())
  {
    subdivision::Fail(this,
      "InterpolatePoints, InterpolateArrays, InterfaceValues = Discontinuous and MergedValues = "
      "Keep have no operator of few entries: switch them off.");
    return false;
  }
  this->Factors = found->Factors.get();
  this->RunAside();
  this->Factors = nullptr;
  auto* input = vtkDataSet::SafeDownCast(this->GetInputDataObject(0, 0));
  if (input && found->GetNumberOfFactors() > 0 &&
    found->GetNumberOfColumns() != input->GetNumberOfPoints())
  {
    subdivision::Fail(this,
      "Cells of higher order got points that the input does not have: the operator is "
      "not one of its points. Cut the cells by another filter first.");
    *found->Factors = subdivision::MatrixFactors();
  }
  return found->GetNumberOfFactors() > 0;
}

void vtkSubdivisionAlgorithm::ReadInterpolation(
  subdivision::RunOptions& options, std::vector<std::string>& warnings) const
{
  subdivision::InterpolationOptions interpolation;
  interpolation.Points = this->InterpolatePoints;
  interpolation.Arrays = this->InterpolateArrays;
  interpolation.Names = this->InterpolatedArrays;
  interpolation.Weight = this->InterpolationWeight;
  if (interpolation.IsOn() && !this->CanInterpolate())
  {
    warnings.emplace_back("With these options this filter does not interpolate: it ignores "
                          "InterpolatePoints and InterpolateArrays.");
    interpolation = subdivision::InterpolationOptions();
  }
  options.Interpolation = interpolation;
}

bool vtkSubdivisionAlgorithm::ReadChosenPoints(vtkPointSet* input, subdivision::RunOptions& options)
{
  vtkDataArray* chosen = nullptr;
  if (!subdivision::FindInputArray(this, input->GetPointData(), input->GetNumberOfPoints(),
        { INTERPOLATION_ARRAY, nullptr, false, true }, options.Warn, options.Fail, chosen))
  {
    return false;
  }
  options.Interpolation.Chosen = options.Interpolation.IsOn() ? chosen : nullptr;
  return subdivision::HasWeights(options.Interpolation, options.Fail);
}

vtkSmartPointer<vtkDataObject> vtkSubdivisionAlgorithm::MakeSurfaces(
  vtkDataObject* input, std::vector<std::string>& warnings)
{
  // Blocks and ranks may share faces of solids, which are no outside then.
  int blocksOfSolids = 0;
  subdivision::ChangeMeshes(vtkDataObjectTree::SafeDownCast(input),
    [&](vtkDataObject* mesh, unsigned int) -> vtkSmartPointer<vtkDataObject>
    {
      const subdivision::FaceCounts counts = subdivision::CountFaces(mesh);
      blocksOfSolids += counts[2] + counts[3] > 0. ? 1 : 0;
      return mesh;
    });
  const bool takesOutside = !this->SharesRanks() && (!this->JoinBlocks || blocksOfSolids < 2);
  return subdivision::ChangeMeshes(input,
    [&](vtkDataObject* mesh, unsigned int) -> vtkSmartPointer<vtkDataObject>
    {
      auto* grid = vtkUnstructuredGrid::SafeDownCast(mesh);
      if (!grid)
      {
        return mesh;
      }
      const auto copy = vtkSmartPointer<vtkUnstructuredGrid>::New();
      copy->ShallowCopy(grid);
      this->Prepare(grid, copy); // while cells have their ids
      return subdivision::MakeSurface(copy, takesOutside, this->HasOriginalCellIds(), warnings);
    });
}

bool vtkSubdivisionAlgorithm::ReadFeatureOptions(vtkPointSet* input, subdivision::RunOptions& run)
{
  using subdivision::JointRule;
  vtkDataArray* arrays[5];
  auto find = [&](int index, const char* fallback, bool integral)
  {
    return subdivision::FindInputArray(this, input->GetCellData(), input->GetNumberOfCells(),
      { index, fallback, integral }, run.Warn, run.Fail, arrays[index]);
  };
  if (!find(SINGULAR_ARRAY, subdivision::SingularName, true) ||
    !find(MATERIAL_ARRAY, "MaterialId", false) || !find(PART_ARRAY, nullptr, true) ||
    !find(RULE_ARRAY, nullptr, true) || !find(SHARPNESS_ARRAY, nullptr, false))
  {
    return false;
  }
  vtkDataArray* angles = nullptr;
  if (!subdivision::FindInputArray(this, input->GetPointData(), input->GetNumberOfPoints(),
        { ANGLE_ARRAY, nullptr, false, true }, run.Warn, run.Fail, angles) ||
    !this->ReadChosenPoints(input, run))
  {
    return false;
  }
  subdivision::FeatureOptions& options = run.Features;
  options.Singular = arrays[SINGULAR_ARRAY];
  options.Material = arrays[MATERIAL_ARRAY];
  options.Part = arrays[PART_ARRAY];
  options.Rules = arrays[RULE_ARRAY];
  options.Sharpness = arrays[SHARPNESS_ARRAY];
  if (this->PreserveInterfaces && !options.Material) // blocks that are joined
  {
    options.Material = input->GetCellData()->GetArray(subdivision::BlockIndexName);
  }
  if (this->PreserveInterfaces && !options.Material)
  {
    run.Fail("PreserveInterfaces needs a cell array of materials: set array index 1, or name the "
             "array MaterialId.");
    return false;
  }
  options.DartEnds = this->CreaseEnd == DART;
  options.Weights = static_cast<subdivision::LoopWeights>(this->LoopWeights);
  options.ModifiedBoundary = this->ModifiedBoundary;
  options.CornerAngles = angles;
  options.Embedded = static_cast<subdivision::EmbeddedRule>(this->EmbeddedCells);
  options.PreserveInterfaces = this->PreserveInterfaces;
  options.DetectFeatures = this->DetectFeatures;
  options.FeatureAngle = this->FeatureAngle;
  options.MergesPoints = this->MergePoints || subdivision::HasDuplicates(input);
  options.ClosesNodes = this->CloseHangingNodes;
  options.JoiningCure = input->GetPointData()->GetTCoords()
    ? "use vtkSurfaceSubdivision, whose JoinSeams keeps the texture coordinates of both sides. "
      "MergePoints leaves them out."
    : "";
  options.Type1 = static_cast<JointRule>(this->Type1Rule);
  options.Type2 = this->Type2Rule == TYPE2_FOLLOW_PART ? JointRule::FollowPart
                                                       : static_cast<JointRule>(this->Type2Rule);
  options.Type3 = static_cast<JointRule>(this->Type3Rule);
  return true;
}

void vtkSubdivisionAlgorithm::SetMaximumNumberOfCellsAsDouble(double cells)
{
  this->SetMaximumNumberOfCells(subdivision::ToCount(cells));
}

void vtkSubdivisionAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto printNames = [&](const char* title, const std::vector<std::string>& names)
  {
    os << indent << title;
    for (const std::string& name : names)
    {
      os << " " << name;
    }
    os << "\n";
  };
  os << indent << "InterpolateIntegers: " << this->InterpolateIntegers << "\n";
  os << indent << "GenerateOriginalIds: " << this->GenerateOriginalIds << "\n";
  os << indent << "GenerateGlobalIds: " << this->GenerateGlobalIds << "\n";
  os << indent << "InterpolatePoints: " << this->InterpolatePoints << "\n";
  os << indent << "InterpolateArrays: " << this->InterpolateArrays << "\n";
  printNames("Interpolated arrays:", this->InterpolatedArrays);
  os << indent << "InterpolationWeight: " << this->InterpolationWeight << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
  os << indent << "MaximumNumberOfCells: " << this->MaximumNumberOfCells << "\n";
  os << indent << "CreaseEnd: " << this->CreaseEnd << "\n";
  os << indent << "LoopWeights: " << this->LoopWeights << "\n";
  os << indent << "ModifiedBoundary: " << this->ModifiedBoundary << "\n";
  os << indent << "EmbeddedCells: " << this->EmbeddedCells << "\n";
  os << indent << "PreserveInterfaces: " << this->PreserveInterfaces << "\n";
  os << indent << "InterfaceValues: " << this->InterfaceValues << "\n";
  printNames("Fields of cells:", this->FieldsOfCells);
  os << indent << "DetectFeatures: " << this->DetectFeatures << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "Type1Rule: " << this->Type1Rule << "\n";
  os << indent << "Type2Rule: " << this->Type2Rule << "\n";
  os << indent << "Type3Rule: " << this->Type3Rule << "\n";
  os << indent << "QuadraticCells: " << this->QuadraticCells << "\n";
  os << indent << "JoinSides: " << this->JoinSides << "\n";
  os << indent << "MergePoints: " << this->MergePoints << "\n";
  os << indent << "MergeTolerance: " << this->MergeTolerance << "\n";
  os << indent << "MergedValues: " << this->MergedValues << "\n";
  os << indent << "CloseHangingNodes: " << this->CloseHangingNodes << "\n";
  os << indent << "JoinBlocks: " << this->JoinBlocks << "\n";
  os << indent << "Controller: " << this->Controller.Get() << "\n";
}
