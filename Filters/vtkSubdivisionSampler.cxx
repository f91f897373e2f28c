// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSubdivisionSampler.h"

#include "Private/Arrays/Arrays.h"
#include "Private/Reading/InputArrays.h"
#include "Private/Run/FilterRun.h"
#include "Private/Run/Ports.h"
#include "Private/Run/SizeChecks.h"
#include "Private/Samples/SampledObject.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <sstream>

using Pipeline = vtkStreamingDemandDrivenPipeline;

namespace
{

std::string ToText(double number)
{
  std::ostringstream stream;
  stream << number;
  return stream.str();
}

/// Of an image without samples.
constexpr subdivision::SampleGrid NoGrid{ { { 0., 0., 0. } }, { { 1., 1., 1. } },
  { { 0, -1, 0, -1, 0, -1 } } };

/// The inputs and times on which levels and pieces depend.
subdivision::SampledObject::Key GetKey(vtkInformationVector** inputVector, vtkMTimeType modified)
{
  subdivision::SampledObject::Key key{ {}, modified, {}, {} };
  for (int port = 0; port < 3; ++port)
  {
    vtkDataObject* const input = vtkDataObject::GetData(inputVector[port]);
    std::get<0>(key).emplace_back(input, input ? input->GetMTime() : 0);
  }
  if (vtkInformation* const image = inputVector[3]->GetInformationObject(0))
  {
    image->Get(vtkDataObject::SPACING(), std::get<2>(key).data());
    image->Get(Pipeline::WHOLE_EXTENT(), std::get<3>(key).data());
  }
  return key;
}

double GetLeastSpacing(const subdivision::SampleGrid& grid)
{
  return *std::min_element(grid.Spacing.begin(), grid.Spacing.end());
}

/// What helps where an image around a box has more than `most` samples. How many it has by its
/// spacing depends on the shape of the box and on the margin, so that spacings are tried.
std::string AdviseSpacing(const vtkBoundingBox& box, double most, double spacing, int margin)
{
  const double longest = box.GetMaxLength();
  const auto isTooLarge = [&]
  {
    const auto grid = subdivision::MakeSampleGrid(box, 2, spacing, margin);
    return subdivision::CountSamples(grid) > most || subdivision::HasMostSteps(grid);
  };
  spacing = std::max(spacing, longest / VTK_INT_MAX);
  while (spacing < longest && isTooLarge())
  {
    spacing *= 1.02;
  }
  // A tenth more, as the box may grow with further levels.
  return isTooLarge() ? "Make Margin smaller."
                      : "A spacing of " + ToText(1.1 * spacing) + " would do.";
}

}

vtkStandardNewMacro(vtkSubdivisionSampler);

vtkSubdivisionSampler::vtkSubdivisionSampler()
{
  this->SetNumberOfInputPorts(4);
}

vtkSubdivisionSampler::~vtkSubdivisionSampler() = default;

vtkImageData* vtkSubdivisionSampler::GetOutput()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(0));
}

int vtkSubdivisionSampler::FillInputPortInformation(int port, vtkInformation* info)
{
  return port < 3 ? this->Superclass::FillInputPortInformation(port, info)
                  : subdivision::TakeTypes(info, { "vtkImageData" }, true);
}

int vtkSubdivisionSampler::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkImageData");
  return 1;
}

int vtkSubdivisionSampler::RequestDataObject(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return request ? subdivision::MakeOutput<vtkImageData>(outputVector)
                 : this->Superclass::RequestDataObject( // for ComputeOperator and EvaluateLimit
                     request, inputVector, outputVector);
}

void vtkSubdivisionSampler::FailSampling(const std::string& text)
{
  subdivision::Fail(this, text);
  this->HasFailed = true;
}

vtkSmartPointer<vtkDataObject> vtkSubdivisionSampler::Finish(vtkDataObject* made)
{
  const auto finished = this->Superclass::Finish(made);
  if (this->Object && this->HasOutput())
  {
    this->Object->Level = finished;
  }
  return finished;
}

bool vtkSubdivisionSampler::FindArrays()
{
  const auto warn = [](const std::string&) {}; // the reader of features has warned
  const auto fail = [this](const std::string& text) { this->FailSampling(text); };
  for (subdivision::SampledMesh& mesh : this->Object->Meshes)
  {
    if (!subdivision::FindInputArray(this, mesh.Mesh->GetCellData(), mesh.Mesh->GetNumberOfCells(),
          { MATERIAL_ARRAY, "MaterialId", false }, warn, fail, mesh.Material) ||
      !subdivision::FindInputArray(this, mesh.Mesh->GetPointData(), mesh.Mesh->GetNumberOfPoints(),
        { THICKNESS_ARRAY, nullptr, false, true, false, "thicknesses" }, warn, fail,
        mesh.Thickness))
    {
      return false;
    }
    if (mesh.Thickness && mesh.Thickness->GetNumberOfTuples() > 0 &&
      mesh.Thickness->GetRange(0)[0] < 0.)
    {
      subdivision::Warn(this,
        std::string("Point array \"") + mesh.Thickness->GetName() +
          "\" (array index 12) has negative thicknesses, down to " +
          ToText(mesh.Thickness->GetRange(0)[0]) +
          ": there nothing is sampled. Make them 0 or more.");
    }
  }
  return true;
}

bool vtkSubdivisionSampler::FindBounds(vtkBoundingBox& box)
{
  const double* b = this->SamplingBounds;
  const bool areGood = !this->UseSamplingBounds ||
    (std::all_of(b, b + 6, [](double x) { return std::isfinite(x); }) && b[0] <= b[1] &&
      b[2] <= b[3] && b[4] <= b[5]);
  if (!areGood)
  {
    this->FailSampling("SamplingBounds are not usable: they must be finite, each lower bound at "
                       "most the upper one.");
  }
  else if (this->UseSamplingBounds)
  {
    box.SetBounds(b);
  }
  const bool isSpaced = this->Spacing >= 0. && std::isfinite(this->Spacing);
  if (!isSpaced)
  {
    this->FailSampling("Spacing is not usable: it must be positive, or 0 for NumberOfSamples.");
  }
  return areGood && isSpaced;
}

bool vtkSubdivisionSampler::FindGrid(
  vtkInformationVector** inputVector, vtkBoundingBox box, subdivision::SampleGrid& grid)
{
  vtkInformation* const given = inputVector[3]->GetInformationObject(0);
  if (given)
  {
    vtkImageData* const image = vtkImageData::GetData(given);
    if (image && !image->GetDirectionMatrix()->IsIdentity())
    {
      this->FailSampling("The image at port 3 is rotated (its direction matrix is not the "
                         "identity): resample it along the axes first.");
      return false;
    }
    given->Get(Pipeline::WHOLE_EXTENT(), grid.Extent.data());
    given->Get(vtkDataObject::ORIGIN(), grid.Origin.data());
    given->Get(vtkDataObject::SPACING(), grid.Spacing.data());
    if (!std::all_of(grid.Spacing.begin(), grid.Spacing.end(), [](double x) { return x > 0.; }))
    {
      this->FailSampling("The image at port 3 has a spacing that is not positive.");
      return false;
    }
  }
  else if (!this->FindBounds(box))
  {
    return false;
  }
  else
  {
    const int margin = this->UseSamplingBounds ? 0 : this->Margin;
    grid = box.IsValid()
      ? subdivision::MakeSampleGrid(box, this->NumberOfSamples, this->Spacing, margin)
      : NoGrid;
  }
  return true;
}

bool vtkSubdivisionSampler::CheckSize(
  vtkInformationVector** inputVector, vtkBoundingBox box, const subdivision::SampleGrid& grid)
{
  const double samples = subdivision::CountSamples(grid);
  const auto most = static_cast<double>(this->MaximumNumberOfSamples);
  const bool isTooLong = subdivision::HasMostSteps(grid);
  if (samples > most || isTooLong)
  {
    this->FailSampling((samples <= most ? "The image would have more than " +
                             std::to_string(subdivision::MostSteps) +
                             " samples along an axis, more than an image may have. "
                                        : "The image would have " + ToText(samples) +
                             " samples, more than MaximumNumberOfSamples, " +
                             std::to_string(this->MaximumNumberOfSamples) + ". ") +
      this->Advise(inputVector, box, most, grid));
  }
  return samples <= most && !isTooLong;
}

std::string vtkSubdivisionSampler::Advise(vtkInformationVector** inputVector, vtkBoundingBox box,
  double most, const subdivision::SampleGrid& grid)
{
  if (inputVector[3]->GetNumberOfInformationObjects() > 0)
  {
    return "Give a coarser image.";
  }
  if (this->UseSamplingBounds)
  {
    box.SetBounds(this->SamplingBounds);
  }
  return AdviseSpacing(box, most, grid.Spacing[0], this->UseSamplingBounds ? 0 : this->Margin);
}

bool vtkSubdivisionSampler::MakeLevels(vtkInformationVector** inputVector)
{
  vtkMultiProcessController* const controller =
    this->SharesRanks() ? this->Controller.Get() : nullptr;
  subdivision::SampledObject& object = *this->Object;
  for (int level = 1;; ++level)
  {
    const double runs = this->MaximumLevel + 1.;
    if (!this->MakeLevelAside(level, level == 1, { (level - 1.) / runs, 1. / runs }, inputVector))
    {
      this->HasFailed = true;
      return false;
    }
    if (this->IsStopped())
    {
      return false;
    }
    object.SetLevel(object.Level, level > 1);
    object.Agree(controller);
    if (!this->FindGrid(inputVector, object.Bounds, object.Grid) ||
      (level > 1 && !this->CheckSize(inputVector, object.Bounds, object.Grid)))
    {
      return false;
    }
    const double tolerance = this->Tolerance * GetLeastSpacing(object.Grid);
    if (level == 1)
    {
      // Straight pieces are as far away as their edges bend, these four times nearer at least.
      object.Deviation = object.Bend / 4.;
    }
    const bool isEnough = object.Deviation <= tolerance;
    if (isEnough || level > this->MaximumLevel || 8. * object.Cells > this->MaximumCellsOfLevel)
    {
      this->WarnOfLevel(isEnough);
      const bool fits = this->CheckSize(inputVector, object.Bounds, object.Grid);
      const bool areFound = this->FindArrays();
      this->WarnOfNames();
      object.FindMaterials(controller);
      if (this->GenerateDistance)
      {
        object.Outside = subdivision::ListFaces(object.Meshes, false);
        subdivision::DropCommonFaces(object.Meshes, controller, object.Outside);
      }
      return fits && areFound;
    }
  }
}

void vtkSubdivisionSampler::WarnOfNames()
{
  for (const subdivision::SampledMesh& mesh : this->Object->Meshes)
  {
    vtkPointData* const data = mesh.Mesh->GetPointData();
    for (int a = 0; a < data->GetNumberOfArrays(); ++a)
    {
      const char* const name = data->GetArrayName(a);
      if (subdivision::IsOwnName(
            this->Object->Meshes, this->GenerateCoverage, this->GenerateDistance, name) &&
        subdivision::IsSampled(data->GetArray(a)))
      {
        subdivision::Warn(this,
          "Point array \"" + std::string(name) +
            "\" is left out: an array that the filter makes has its name. Rename it.");
        return;
      }
    }
  }
}

void vtkSubdivisionSampler::WarnOfLevel(bool isEnough)
{
  const subdivision::SampledObject& object = *this->Object;
  if (!object.Bounds.IsValid())
  {
    subdivision::Warn(this,
      "The input has no cells of these dimensions: there is nothing to sample. See "
      "OutputDimensions.");
  }
  else if (!isEnough)
  {
    subdivision::Warn(this,
      "Pieces are up to about " + ToText(object.Deviation / GetLeastSpacing(object.Grid)) +
        " of the distance of samples away from the limit, more than Tolerance, " +
        ToText(this->Tolerance) + ": raise MaximumLevel or MaximumCellsOfLevel.");
  }
  for (const subdivision::SampledMesh& mesh : object.Meshes)
  {
    if (mesh.Pieces.Strange >= 0)
    {
      subdivision::Warn(this,
        "Cell " + std::to_string(mesh.Pieces.Strange) +
          " of the last level and maybe others are in no piece, and are left out. This is a fault "
          "of the filter, not of the input: report it.");
    }
  }
}

/// Updates all inputs but the image, of which the grid is enough.
void vtkSubdivisionSampler::UpdateInputs()
{
  const bool isShared = this->SharesRanks();
  for (int port = 0; port < 3; ++port)
  {
    for (int c = 0; c < this->GetNumberOfInputConnections(port); ++c)
    {
      int from = 0;
      vtkAlgorithm* const producer = this->GetInputAlgorithm(port, c, from);
      vtkNew<vtkInformationVector> requests;
      requests->SetNumberOfInformationObjects(from + 1);
      vtkInformation* const request = requests->GetInformationObject(from);
      subdivision::AskForWhole(request, isShared ? this->Controller->GetLocalProcessId() : 0,
        isShared ? this->Controller->GetNumberOfProcesses() : 1);
      producer->Update(from, requests);
    }
  }
}

bool vtkSubdivisionSampler::MakeObject(vtkInformationVector** inputVector)
{
  const auto key = GetKey(inputVector, this->GetMTime());
  if (this->Object && this->Object->MadeFor == key)
  {
    return this->Object->IsMade;
  }
  this->HasFailed = false;
  this->Object.reset();
  subdivision::FilterTraits traits;
  traits.Memory = "the levels. Make MaximumLevel or MaximumCellsOfLevel smaller.";
  subdivision::RunOptions messages;
  subdivision::ConnectToFilter(this, messages, this->HasFailed);
  const bool isMade = subdivision::DoWork(traits, messages,
    [&]
    {
      this->Object = std::make_unique<subdivision::SampledObject>();
      this->Object->MadeFor = key;
      this->Object->IsMade = this->MakeLevels(inputVector);
      return this->Object->IsMade;
    });
  this->SetProgressShiftScale(0., 1.);
  return isMade;
}

int vtkSubdivisionSampler::ExecuteInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  subdivision::SampleGrid grid = NoGrid;
  if (inputVector[3]->GetNumberOfInformationObjects() > 0 || this->UseSamplingBounds)
  {
    this->HasFailed = false;
    const bool isGood =
      this->FindGrid(inputVector, {}, grid) && this->CheckSize(inputVector, {}, grid);
    grid = isGood ? grid : NoGrid;
  }
  else
  {
    this->UpdateInputs();
    grid = this->MakeObject(inputVector) ? this->Object->Grid : NoGrid;
  }
  vtkInformation* const info = outputVector->GetInformationObject(0);
  info->Set(Pipeline::WHOLE_EXTENT(), grid.Extent.data(), 6);
  info->Set(vtkDataObject::ORIGIN(), grid.Origin.data(), 3);
  info->Set(vtkDataObject::SPACING(), grid.Spacing.data(), 3);
  info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  return 1;
}

int vtkSubdivisionSampler::ComputeInputUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  const bool isShared = this->SharesRanks();
  for (int port = 0; port < 3; ++port)
  {
    if (vtkInformation* const info = inputVector[port]->GetInformationObject(0))
    {
      subdivision::AskForWhole(info, isShared ? this->Controller->GetLocalProcessId() : 0,
        isShared ? this->Controller->GetNumberOfProcesses() : 1);
    }
  }
  return 1;
}

/// The grid is the one that was announced, also where the object has changed since.
int vtkSubdivisionSampler::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!request)
  {
    return this->Superclass::RequestData(request, inputVector, outputVector);
  }
  vtkImageData* const image = vtkImageData::GetData(outputVector);
  image->Initialize();
  vtkInformation* const info = outputVector->GetInformationObject(0);
  int whole[6];
  info->Get(Pipeline::WHOLE_EXTENT(), whole);
  // Without a grid there was a stop, an error or nothing: the levels are not made again.
  if (whole[1] < whole[0] || !this->MakeObject(inputVector))
  {
    return this->HasFailed ? 0 : 1;
  }
  const subdivision::SampledObject& object = *this->Object;
  subdivision::SampleOptions options;
  int wanted[6];
  info->Get(Pipeline::UPDATE_EXTENT(), wanted);
  info->Get(vtkDataObject::ORIGIN(), options.Grid.Origin.data());
  info->Get(vtkDataObject::SPACING(), options.Grid.Spacing.data());
  info->Get(this->SharesRanks() ? Pipeline::WHOLE_EXTENT() : Pipeline::UPDATE_EXTENT(),
    options.Grid.Extent.data());
  const double spacing = GetLeastSpacing(options.Grid);
  options.HasThickness = true;
  options.Thickness = this->Thickness > 0. ? this->Thickness : 2. * spacing;
  options.Tolerance = std::max(this->Tolerance, 1e-6) * spacing;
  options.HasCoverage = this->GenerateCoverage;
  options.MaterialOutside = object.MaterialOutside;
  options.Band = this->DistanceBand > 0. ? std::min(this->DistanceBand, 1e30) : 3. * spacing;
  options.Outside = this->GenerateDistance ? &object.Outside : nullptr;
  std::vector<double> order;
  std::vector<float> others;
  options.Order = this->SharesRanks() ? &order : nullptr;
  options.Others = this->SharesRanks() && this->GenerateDistance ? &others : nullptr;
  subdivision::FilterTraits traits;
  const auto bytesOfSample = static_cast<double>(
    subdivision::CountBytesOfSample(object.Meshes, object.Materials.size(), options));
  traits.Memory = "the image" +
    std::string(this->GenerateCoverage
        ? ", whose samples each have the coverage of all materials. Switch GenerateCoverage off. "
        : ". ") +
    "Ask for parts of the image. " +
    this->Advise(
      inputVector, object.Bounds, subdivision::GetAvailableMemory() / bytesOfSample, options.Grid);
  subdivision::RunOptions messages;
  subdivision::ConnectToFilter(this, messages, this->HasFailed);
  options.Tell = [&messages](double done) { messages.Progress(done); };
  const bool isDone = subdivision::DoWork(traits, messages,
    [&]
    {
      const double bytes = subdivision::CountSamples(options.Grid) * bytesOfSample;
      subdivision::KeepEstimate(bytes);
      if (bytes > subdivision::GetAvailableMemory()) // systems may promise more than they have
      {
        throw std::bad_alloc();
      }
      subdivision::SamplePieces(object.Meshes, object.Materials, options, image);
      if (this->SharesRanks())
      {
        subdivision::JoinRanks(image, options, this->Controller);
        image->Crop(wanted);
      }
      return true;
    });
  if (!isDone)
  {
    image->Initialize();
  }
  return this->HasFailed ? 0 : 1;
}

void vtkSubdivisionSampler::SetMaximumNumberOfSamplesAsDouble(double samples)
{
  this->SetMaximumNumberOfSamples(subdivision::ToCount(samples));
}

void vtkSubdivisionSampler::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n";
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "UseSamplingBounds: " << this->UseSamplingBounds << "\n";
  os << indent << "SamplingBounds:";
  for (const double bound : this->SamplingBounds)
  {
    os << " " << bound;
  }
  os << "\n";
  os << indent << "Margin: " << this->Margin << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "MaximumLevel: " << this->MaximumLevel << "\n";
  os << indent << "MaximumCellsOfLevel: " << this->MaximumCellsOfLevel << "\n";
  os << indent << "Thickness: " << this->Thickness << "\n";
  os << indent << "GenerateCoverage: " << this->GenerateCoverage << "\n";
  os << indent << "GenerateDistance: " << this->GenerateDistance << "\n";
  os << indent << "DistanceBand: " << this->DistanceBand << "\n";
  os << indent << "MaximumNumberOfSamples: " << this->MaximumNumberOfSamples << "\n";
}
