// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSubdivisionDeformation.h"

#include "vtkSubdivisionCageSource.h"

#include "Private/Deformation/Deformation.h"
#include "Private/Distribution/Distribution.h"
#include "Private/Distribution/GatheredMesh.h"
#include "Private/Reading/ReadableMesh.h"
#include "Private/Run/FilterRun.h"
#include "Private/Run/Ports.h"

#include "vtkCellType.h"
#include "vtkDataObject.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkRectilinearGrid.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkSubdivisionDeformation);

vtkSubdivisionDeformation::vtkSubdivisionDeformation()
  : Work(std::make_unique<subdivision::Deformation>())
{
  this->SetNumberOfInputPorts(3);
}

vtkSubdivisionDeformation::~vtkSubdivisionDeformation() = default;

vtkIdType vtkSubdivisionDeformation::GetNumberOfTopologyBuilds() const
{
  return this->Work->GetNumberOfTopologyBuilds();
}

vtkIdType vtkSubdivisionDeformation::GetNumberOfLocationBuilds() const
{
  return this->Work->GetNumberOfLocationBuilds();
}

vtkIdType vtkSubdivisionDeformation::GetNumberOfOutsidePoints() const
{
  return this->Work->NumberOfOutsidePoints;
}

int vtkSubdivisionDeformation::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    return subdivision::TakeTypes(
      info, { "vtkPointSet", "vtkImageData", "vtkRectilinearGrid", "vtkDataObjectTree" });
  }
  // Not required, so that RequestData can tell all missing inputs in one error.
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return this->Superclass::FillInputPortInformation(port, info);
}

int vtkSubdivisionDeformation::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  if (!input)
  {
    return 0;
  }
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkDataObject* output = info->Get(vtkDataObject::DATA_OBJECT());
  vtkSmartPointer<vtkDataObject> made = vtkSmartPointer<vtkStructuredGrid>::New();
  if (!vtkImageData::SafeDownCast(input) && !vtkRectilinearGrid::SafeDownCast(input))
  {
    made.TakeReference(input->NewInstance());
  }
  if (!output || output->GetDataObjectType() != made->GetDataObjectType())
  {
    info->Set(vtkDataObject::DATA_OBJECT(), made);
  }
  return 1;
}

/// Offers the times of all three inputs. Without this VTK would offer only the times of the first.
int vtkSubdivisionDeformation::ExecuteInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  std::set<double> steps;
  std::vector<double> range;
  for (int port = 0; port < 3; ++port)
  {
    vtkInformation* info = inputVector[port]->GetInformationObject(0);
    if (info && info->Has(Pipeline::TIME_STEPS()))
    {
      const double* given = info->Get(Pipeline::TIME_STEPS());
      steps.insert(given, given + info->Length(Pipeline::TIME_STEPS()));
    }
    if (info && info->Has(Pipeline::TIME_RANGE()))
    {
      const double* given = info->Get(Pipeline::TIME_RANGE());
      range.insert(range.end(), given, given + 2);
    }
  }
  vtkInformation* info = outputVector->GetInformationObject(0);
  if (!steps.empty())
  {
    const std::vector<double> all(steps.begin(), steps.end());
    info->Set(Pipeline::TIME_STEPS(), all.data(), static_cast<int>(all.size()));
  }
  if (!range.empty())
  {
    const auto ends = std::minmax_element(range.begin(), range.end());
    const double both[2] = { *ends.first, *ends.second };
    info->Set(Pipeline::TIME_RANGE(), both, 2);
  }
  return 1;
}

/// Whichever part of the input is asked for, the control meshes are needed whole.
int vtkSubdivisionDeformation::ComputeInputUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  for (int port = 1; port < 3; ++port)
  {
    if (vtkInformation* const info = inputVector[port]->GetInformationObject(0))
    {
      subdivision::AskForWhole(info); // the extent of a structured object is of no use here
    }
  }
  return 1;
}

int vtkSubdivisionDeformation::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  subdivision::DeformationOptions options;
  options.OnLimit = this->Embedding == LIMIT;
  options.Levels = options.OnLimit ? 0 : this->NumberOfLevels;
  options.KeepsCellTypes = this->VolumeScheme == HYBRID;
  options.Scheme =
    subdivision::GetVolumeScheme(options.KeepsCellTypes ? BOX_SPLINE : this->VolumeScheme);
  options.SurfaceScheme = this->SurfaceScheme == CATMULL_CLARK
    ? subdivision::SurfaceSchemeKind::CatmullClark
    : subdivision::SurfaceSchemeKind::Loop;
  options.Outside = static_cast<subdivision::OutsideRule>(this->OutsidePoints);
  options.TransformVectors = this->TransformVectors;
  subdivision::ReadSharedOptions(this, options);
  subdivision::FilterTraits traits;
  traits.WrongInput = "The input is missing, or is no vtkPointSet.";
  traits.Memory = "NumberOfLevels = " + std::to_string(this->NumberOfLevels) +
    " and the points of the input. Use fewer levels, or a part of the input.";
  traits.FallsBackToInput = true;
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  bool failed = false;
  const subdivision::ProgressPart all;
  options.Part = all.Take(0., 0.05);
  subdivision::ConnectToFilter(this, options, failed);
  vtkSmartPointer<vtkDataObject> object;
  const auto makeMovable = [&]
  {
    object = subdivision::MakeMovable(vtkDataObject::GetData(inputVector[0]));
    return true;
  };
  if (!subdivision::DoWork(traits, options, makeMovable))
  {
    output->Initialize();
    return failed ? 0 : 1;
  }
  if (this->GetNumberOfInputConnections(2) == 0)
  {
    subdivision::Fail(this,
      "DeformedMesh (input port 2) is missing; the output is the input. RestMesh is a mesh of "
      "solid cells around the input, such as a cage of vtkSubdivisionCageSource, DeformedMesh the "
      "same with its points moved.");
    output->ShallowCopy(object);
    return 1;
  }
  const bool hasRest = this->GetNumberOfInputConnections(1) > 0;
  auto warn = [this](const std::string& message) { subdivision::Warn(this, message); };
  std::vector<std::string> warnings;
  vtkSmartPointer<vtkPointSet> rest;
  vtkSmartPointer<vtkPointSet> deformed;
  const auto read = [&]
  {
    if (hasRest)
    {
      rest =
        subdivision::GatherMesh(this->ReadInput(vtkDataObject::GetData(inputVector[1]), warnings),
          this->GetController(), warn);
    }
    std::for_each(warnings.begin(), warnings.end(), warn); // those of both meshes are the same
    deformed =
      subdivision::GatherMesh(this->ReadInput(vtkDataObject::GetData(inputVector[2]), warnings),
        this->GetController(), warn);
    if (!hasRest && deformed)
    {
      rest = this->MakeCage(vtkDataObject::GetData(inputVector[0]), deformed);
      if (rest)
      {
        warn("RestMesh is missing: the filter takes the cage that vtkSubdivisionCageSource makes "
             "around the input with its default Margin. Connect RestMesh if DeformedMesh was made "
             "otherwise.");
      }
    }
    return true;
  };
  const bool isAlone = !this->GetController() || this->GetController()->GetNumberOfProcesses() == 1;
  // Where there are others they wait for this rank.
  if (!(isAlone ? subdivision::DoWork(traits, options, read) : read()))
  {
    output->Initialize();
    return failed ? 0 : 1;
  }
  options.Part = all.Take(0.05, 1.);
  this->Work->NumberOfOutsidePoints = 0;
  const int result = subdivision::RunOnBlocks(this, object, output, traits, options,
    [&](vtkPointSet* input, vtkPointSet* made)
    {
      if (!hasRest && deformed && !rest)
      {
        options.Fail("RestMesh (input port 1) is missing, and DeformedMesh is no cage around the "
                     "input, as vtkSubdivisionCageSource makes it: the output is the input. "
                     "Connect the mesh that DeformedMesh was before its points were moved.");
        return false;
      }
      if (!rest || !deformed)
      {
        options.Fail(
          "RestMesh and DeformedMesh must be meshes with cells (vtkUnstructuredGrid, vtkPolyData, "
          "structured data, or blocks of these). The output is the input.");
        return false;
      }
      return this->ReadFeatureOptions(rest, options) &&
        this->Work->Run(input, rest, deformed, options, made);
    });
  this->Work->ForgetUnused();
  return result;
}

/// The first tetrahedron goes along x, y and z: its ids are 0, 1, and the points of a row and of a
/// layer more.
vtkSmartPointer<vtkPointSet> vtkSubdivisionDeformation::MakeCage(
  vtkDataObject* object, vtkPointSet* deformed) const
{
  vtkNew<vtkIdList> ids;
  if (deformed->GetNumberOfCells() > 0 && deformed->GetCellType(0) == VTK_TETRA)
  {
    deformed->GetCellPoints(0, ids);
  }
  const vtkIdType row = ids->GetNumberOfIds() == 4 ? ids->GetId(2) - ids->GetId(1) : 0;
  const vtkIdType layer = ids->GetNumberOfIds() == 4 ? ids->GetId(3) - ids->GetId(2) : 0;
  if (row < 2 || layer < 2 * row)
  {
    return nullptr;
  }
  vtkNew<vtkSubdivisionCageSource> source;
  source->SetController(this->GetController());
  source->SetInputDataObject(0, object);
  source->SetNumberOfCells(static_cast<int>(std::min<vtkIdType>(row - 1, 100)),
    static_cast<int>(std::min<vtkIdType>(layer / row - 1, 100)),
    static_cast<int>(std::min<vtkIdType>(deformed->GetNumberOfPoints() / layer - 1, 100)));
  source->Update();
  vtkUnstructuredGrid* cage = source->GetOutput();
  const bool fits = cage->GetNumberOfPoints() == deformed->GetNumberOfPoints() &&
    cage->GetNumberOfCells() == deformed->GetNumberOfCells();
  return fits ? cage : nullptr;
}

void vtkSubdivisionDeformation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfLevels: " << this->NumberOfLevels << "\n";
  os << indent << "VolumeScheme: " << this->VolumeScheme << "\n";
  os << indent << "SurfaceScheme: " << this->SurfaceScheme << "\n";
  os << indent << "Embedding: " << this->Embedding << "\n";
  os << indent << "OutsidePoints: " << this->OutsidePoints << "\n";
  os << indent << "TransformVectors: " << this->TransformVectors << "\n";
  os << indent << "Bytes kept: " << this->Work->GetMemorySize() << "\n";
  os << indent << "NumberOfTopologyBuilds: " << this->GetNumberOfTopologyBuilds() << "\n";
  os << indent << "NumberOfLocationBuilds: " << this->GetNumberOfLocationBuilds() << "\n";
  os << indent << "NumberOfOutsidePoints: " << this->GetNumberOfOutsidePoints() << "\n";
}
