// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSubdivisionLabelSolid.h"

#include "vtkMultiDimensionalSubdivision.h"

#include "Private/Arrays/Arrays.h"
#include "Private/Labels/LabelSolid.h"
#include "Private/Labels/Materials.h"
#include "Private/Reading/InputArrays.h"
#include "Private/Run/FilterRun.h"
#include "Private/Run/Ports.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <string>

vtkStandardNewMacro(vtkSubdivisionLabelSolid);

namespace
{

/// The filter that makes the solid. Its warnings are not passed on: the faults are measured, and
/// the next round may mend them. Nothing mends those of curved cells, which are made once.
class InnerFilter
{
public:
  explicit InnerFilter(subdivision::LabelSolidOptions& options)
    : Options(options)
  {
    vtkNew<vtkCallbackCommand> listener;
    listener->SetClientData(this);
    listener->SetCallback(Listen);
    for (const unsigned long event :
      { vtkCommand::WarningEvent, vtkCommand::ErrorEvent, vtkCommand::ProgressEvent })
    {
      this->Filter->AddObserver(event, listener);
    }
  }
  vtkMultiDimensionalSubdivision* operator->() { return this->Filter; }
  void SetOutputCells(int cells, int order)
  {
    this->IsLast = true;
    this->Filter->SetOutputCells(cells == vtkSubdivisionLabelSolid::QUADRATIC_CELLS
        ? vtkUniformSubdivisionAlgorithm::QUADRATIC_CELLS
        : vtkUniformSubdivisionAlgorithm::LAGRANGE_CELLS);
    this->Filter->SetCellOrder(order);
  }
  /// Returns null after an error or a stop.
  vtkUnstructuredGrid* Run(vtkUnstructuredGrid* grid, vtkPolyData* creases)
  {
    ++this->Round;
    this->Filter->SetInputData(grid);
    if (creases->GetNumberOfCells() > 0)
    {
      this->Filter->SetInputData(2, creases);
    }
    this->Filter->Update();
    return this->IsStopped ? nullptr : this->Filter->GetOutput();
  }

private:
  static void Listen(vtkObject*, unsigned long event, void* self, void* data)
  {
    auto* inner = static_cast<InnerFilter*>(self);
    if (event == vtkCommand::ErrorEvent)
    {
      inner->IsStopped = true;
      inner->Options.Fail(static_cast<const char*>(data));
    }
    else if (event == vtkCommand::WarningEvent && inner->IsLast)
    {
      const std::string text(static_cast<const char*>(data));
      const auto begin = text.find("): "); // what VTK writes before a message
      inner->Options.Warn(text.substr(begin == std::string::npos ? 0 : begin + 3));
    }
    else if (event == vtkCommand::ProgressEvent)
    {
      // A round begins where the one before ended. The labels were read before the first.
      inner->Done =
        std::max(inner->Done, 1. - (1. - *static_cast<double*>(data) / 2.) / inner->Round);
      // VTK takes back the abort of a filter at its first report: it is told again at the next one.
      if (inner->IsStopped || inner->Options.Progress(inner->Done))
      {
        inner->IsStopped = true;
        inner->Filter->SetAbortExecute(1);
      }
    }
  }

  subdivision::LabelSolidOptions& Options;
  vtkNew<vtkMultiDimensionalSubdivision> Filter;
  int Round = 0;
  double Done = subdivision::LabelsAreRead;
  bool IsStopped = false;
  bool IsLast = false;
};

}

vtkSubdivisionLabelSolid::vtkSubdivisionLabelSolid()
{
  this->SetNumberOfInputPorts(2);
}

vtkSubdivisionLabelSolid::~vtkSubdivisionLabelSolid() = default;

void vtkSubdivisionLabelSolid::SetMaterialsConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

int vtkSubdivisionLabelSolid::FillInputPortInformation(int port, vtkInformation* info)
{
  return port == 0
    ? subdivision::TakeTypes(info, { "vtkImageData", "vtkRectilinearGrid", "vtkStructuredGrid" })
    : subdivision::TakeTypes(info, { "vtkTable" }, true);
}

int vtkSubdivisionLabelSolid::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  // All pieces come to RequestData, which makes the first one.
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

/// Smoothing needs the whole image.
int vtkSubdivisionLabelSolid::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  for (int port = 0; port < 2; ++port)
  {
    if (vtkInformation* const info = inputVector[port]->GetInformationObject(0))
    {
      subdivision::AskForWhole(info);
    }
  }
  return 1;
}

bool vtkSubdivisionLabelSolid::FindLabels(
  vtkDataSet* image, subdivision::LabelSolidOptions& options)
{
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS;
  const std::string name = subdivision::GetInputArrayName(this, LABELS_ARRAY, association);
  vtkDataSetAttributes* points = image->GetPointData();
  vtkDataSetAttributes* cells = image->GetCellData();
  if (name.empty())
  {
    options.OfPoints = points->GetScalars();
    options.Labels = options.OfPoints ? points->GetScalars() : cells->GetScalars();
  }
  else
  {
    options.OfPoints = association == vtkDataObject::FIELD_ASSOCIATION_POINTS ||
      (association != vtkDataObject::FIELD_ASSOCIATION_CELLS && points->HasArray(name.c_str()));
    const subdivision::ArrayRequest request{ LABELS_ARRAY, nullptr, false, options.OfPoints };
    if (!subdivision::FindInputArray(this, options.OfPoints ? points : cells,
          options.OfPoints ? image->GetNumberOfPoints() : image->GetNumberOfCells(), request,
          options.Warn, options.Fail, options.Labels))
    {
      return false;
    }
  }
  const vtkIdType voxels =
    options.OfPoints ? image->GetNumberOfPoints() : image->GetNumberOfCells();
  if (!options.Labels || options.Labels->GetNumberOfComponents() != 1 ||
    options.Labels->GetNumberOfTuples() != voxels)
  {
    options.Fail("The input has no labels: choose a point or cell array with one whole number for "
                 "each voxel (array index 0), or make it the active scalars.");
    return false;
  }
  return true;
}

int vtkSubdivisionLabelSolid::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  if (info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) > 0)
  {
    return 1; // the first piece is the whole solid
  }
  auto* image = vtkDataSet::GetData(inputVector[0]);
  auto* output = vtkUnstructuredGrid::GetData(outputVector);
  subdivision::LabelSolidOptions options;
  bool failed = false;
  subdivision::ConnectToFilter(this, options, failed);
  subdivision::FilterTraits traits;
  traits.Memory = "so many voxels. Make NumberOfControlCells smaller, use fewer levels, or take a "
                  "part of the image.";
  const bool isDone = subdivision::DoWork(traits, options,
    [&]
    {
      return this->FindLabels(image, options) &&
        this->MakeSolid(image, vtkTable::GetData(inputVector[1]), options, output);
    });
  if (!isDone)
  {
    output->Initialize();
  }
  return 1; // 0 would make the pipeline tell a second error
}

bool vtkSubdivisionLabelSolid::MakeSolid(vtkDataSet* image, vtkTable* table,
  subdivision::LabelSolidOptions& options, vtkUnstructuredGrid* output)
{
  const std::string name = subdivision::GetLabelName(options);
  if (table)
  {
    options.Materials = table->GetRowData();
  }
  else if (subdivision::IsMaterialTable(image->GetFieldData(), name))
  {
    options.Materials = image->GetFieldData();
  }
  options.Background = this->BackgroundLabel;
  options.WantedCells = this->NumberOfControlCells;
  options.ByCorners = this->Connectivity == CORNERS;
  options.KeepConnected = this->KeepConnected;
  options.FlatBorder = this->FlatBorder;
  options.SmoothingSteps = this->NumberOfSmoothingSteps;
  options.LargestMove = this->MaximumDisplacement;
  options.Levels = this->NumberOfLevels;
  InnerFilter inner(options);
  inner->SetController(nullptr);
  inner->SetNumberOfLevels(this->NumberOfLevels);
  const bool isHybrid = this->CellType == HEXAHEDRA;
  inner->SetVolumeScheme(isHybrid ? vtkSubdivisionAlgorithm::HYBRID : this->VolumeScheme);
  inner->SetMaximumNumberOfCells(VTK_ID_MAX); // memory is the only limit
  inner->SetProjectToLimit(true);
  inner->SetInterpolatePoints(true);
  inner->SetPreserveInterfaces(true);
  inner->SetCreasePointsToSameId();
  inner->SetGenerateOriginalIds(true);
  inner->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, name.c_str());
  // The limit passes through the points: without a step these are the points of the grid.
  const bool isControl = isHybrid && this->NumberOfLevels == 0;
  options.Hexahedra = isHybrid;
  options.Subdivide = [&inner, isControl](vtkUnstructuredGrid* grid, vtkPolyData* creases)
  { return isControl ? grid : inner.Run(grid, creases); };
  if (this->OutputCells != LINEAR_CELLS)
  {
    options.Curve = [&](vtkUnstructuredGrid* grid, vtkPolyData* creases)
    {
      inner.SetOutputCells(this->OutputCells, this->CellOrder);
      return inner.Run(grid, creases);
    };
  }
  return subdivision::MakeLabelSolid(image, options, output);
}

void vtkSubdivisionLabelSolid::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "BackgroundLabel: " << this->BackgroundLabel << "\n";
  os << indent << "NumberOfControlCells: " << this->NumberOfControlCells << "\n";
  os << indent << "KeepConnected: " << this->KeepConnected << "\n";
  os << indent << "Connectivity: " << this->Connectivity << "\n";
  os << indent << "FlatBorder: " << this->FlatBorder << "\n";
  os << indent << "CellType: " << this->CellType << "\n";
  os << indent << "NumberOfLevels: " << this->NumberOfLevels << "\n";
  os << indent << "VolumeScheme: " << this->VolumeScheme << "\n";
  os << indent << "OutputCells: " << this->OutputCells << "\n";
  os << indent << "CellOrder: " << this->CellOrder << "\n";
  os << indent << "NumberOfSmoothingSteps: " << this->NumberOfSmoothingSteps << "\n";
  os << indent << "MaximumDisplacement: " << this->MaximumDisplacement << "\n";
}
