// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSubdivisionCageSource.h"

#include "Core/Memory/Loops.h"
#include "Private/Run/FilterRun.h"
#include "Private/Run/Ports.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkSubdivisionCageSource);

namespace
{

/// The fault of bounds after the margin was added; empty if they have a volume. `largest`: the
/// largest coordinate that the output can hold.
std::string FindFault(const double* bounds, double largest)
{
  std::string fault;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = bounds[2 * axis];
    const double high = bounds[2 * axis + 1];
    if (low >= -largest && high <= largest && low < high)
    {
      continue;
    }
    const bool isFlat = std::isfinite(low) && low == high;
    fault = isFlat ? "The box is flat along " : "Bounds along ";
    fault += "xyz"[axis];
    fault += isFlat
      ? ". Raise Margin, or set Bounds with a volume."
      : " are not finite, too large for OutputPointsPrecision, or the first is "
        "larger than the second. Set them in ascending order, or make Margin smaller.";
    break;
  }
  return fault;
}

vtkSmartPointer<vtkPoints> MakePoints(const int* cells, const double* bounds, int type)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(type);
  subdivision::Turns turns;
  // The last point of an axis is exactly at its end.
  const auto place = [&](int axis, int i)
  {
    const double t = static_cast<double>(i) / cells[axis];
    return (1. - t) * bounds[2 * axis] + t * bounds[2 * axis + 1];
  };
  for (int k = 0; k <= cells[2]; ++k)
  {
    for (int j = 0; j <= cells[1]; ++j)
    {
      for (int i = 0; i <= cells[0]; ++i, turns.Next())
      {
        points->InsertNextPoint(place(0, i), place(1, j), place(2, k));
      }
    }
  }
  return points;
}

/// Six tetrahedra for each box: one for each order in which a path along its edges may go from the
/// first corner to the last. Odd orders are turned to make them positive.
vtkSmartPointer<vtkCellArray> MakeCells(const int* cells)
{
  static const int orders[6][3] = { { 0, 1, 2 }, { 1, 2, 0 }, { 2, 0, 1 }, { 0, 2, 1 }, { 2, 1, 0 },
    { 1, 0, 2 } };
  const vtkIdType steps[3] = { 1, cells[0] + 1,
    static_cast<vtkIdType>(cells[0] + 1) * (cells[1] + 1) };
  auto tets = vtkSmartPointer<vtkCellArray>::New();
  subdivision::Turns turns;
  for (int k = 0; k < cells[2]; ++k)
  {
    for (int j = 0; j < cells[1]; ++j)
    {
      for (int i = 0; i < cells[0]; ++i, turns.Next())
      {
        for (int order = 0; order < 6; ++order)
        {
          vtkIdType tet[4] = { i * steps[0] + j * steps[1] + k * steps[2] };
          for (int corner = 0; corner < 3; ++corner)
          {
            tet[corner + 1] = tet[corner] + steps[orders[order][corner]];
          }
          if (order > 2)
          {
            std::swap(tet[1], tet[2]);
          }
          tets->InsertNextCell(4, tet);
        }
      }
    }
  }
  return tets;
}

}

vtkSubdivisionCageSource::vtkSubdivisionCageSource()
  : Controller(vtkMultiProcessController::GetGlobalController())
{
}

vtkSubdivisionCageSource::~vtkSubdivisionCageSource() = default;

void vtkSubdivisionCageSource::SetNumberOfCells(int x, int y, int z)
{
  const int wanted[3] = { x, y, z };
  for (int axis = 0; axis < 3; ++axis)
  {
    const int clamped = std::clamp(wanted[axis], 1, 100);
    if (this->NumberOfCells[axis] != clamped)
    {
      this->NumberOfCells[axis] = clamped;
      this->Modified();
    }
  }
}

vtkCxxSetSmartPointerMacro(vtkSubdivisionCageSource, Controller, vtkMultiProcessController);

vtkMultiProcessController* vtkSubdivisionCageSource::GetController() const
{
  return this->Controller;
}

int vtkSubdivisionCageSource::FillInputPortInformation(int, vtkInformation* info)
{
  return subdivision::TakeTypes(info, { "vtkDataSet", "vtkCompositeDataSet" }, true);
}

int vtkSubdivisionCageSource::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  // All ranks have to come to RequestData, whatever piece they are asked for.
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

/// Each rank reads its own part of the input, whatever it is asked for.
int vtkSubdivisionCageSource::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* info = inputVector[0]->GetInformationObject(0);
  if (info)
  {
    vtkMultiProcessController* ranks = this->Controller;
    info->Set(Pipeline::UPDATE_PIECE_NUMBER(), ranks ? ranks->GetLocalProcessId() : 0);
    info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), ranks ? ranks->GetNumberOfProcesses() : 1);
    info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  }
  return 1;
}

bool vtkSubdivisionCageSource::FindBounds(vtkDataObject* input, double* bounds) const
{
  vtkBoundingBox box;
  const auto add = [&box](vtkDataObject* object)
  {
    auto* data = vtkDataSet::SafeDownCast(object);
    if (data && data->GetNumberOfPoints() > 0)
    {
      box.AddBounds(data->GetBounds());
    }
  };
  if (auto* all = vtkCompositeDataSet::SafeDownCast(input))
  {
    const auto at = vtkSmartPointer<vtkCompositeDataIterator>::Take(all->NewIterator());
    for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
    {
      add(at->GetCurrentDataObject());
    }
  }
  add(input);
  // Of an empty box the ends are the largest numbers, the wrong way round.
  double low[3];
  double high[3];
  box.GetMinPoint(low[0], low[1], low[2]);
  box.GetMaxPoint(high[0], high[1], high[2]);
  for (int axis = 0; axis < 3; ++axis)
  {
    bounds[2 * axis] = low[axis];
    bounds[2 * axis + 1] = high[axis];
  }
  if (this->Controller && this->Controller->GetNumberOfProcesses() > 1)
  {
    double lowest[3];
    double highest[3];
    this->Controller->AllReduce(low, lowest, 3, vtkCommunicator::MIN_OP);
    this->Controller->AllReduce(high, highest, 3, vtkCommunicator::MAX_OP);
    for (int axis = 0; axis < 3; ++axis)
    {
      bounds[2 * axis] = lowest[axis];
      bounds[2 * axis + 1] = highest[axis];
    }
  }
  return bounds[0] <= bounds[1];
}

int vtkSubdivisionCageSource::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  double bounds[6];
  std::copy(this->Bounds, this->Bounds + 6, bounds);
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  if (input && !this->FindBounds(input, bounds))
  {
    subdivision::Fail(this,
      "The input has no points, so there is nothing to put a cage around. Disconnect it "
      "to have a cage in its Bounds.");
    return 1; // 0 would make the pipeline tell a second error
  }
  double longest = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    longest = std::max(longest, bounds[2 * axis + 1] - bounds[2 * axis]);
  }
  const double margin = this->Margin / 100. * (longest > 0 ? longest : 1.);
  for (int axis = 0; axis < 3; ++axis)
  {
    // The limit of the cage is up to 5/24 of a cell inside of it. With a quarter of a new cell on
    // each side n cells are as long as the box and half a cell.
    const double length = bounds[2 * axis + 1] - bounds[2 * axis] + 2. * margin;
    const double shrinking = input ? length / (4. * this->NumberOfCells[axis] - 2.) : 0.;
    bounds[2 * axis] -= margin + shrinking;
    bounds[2 * axis + 1] += margin + shrinking;
  }
  const int type = this->OutputPointsPrecision == SINGLE_PRECISION ? VTK_FLOAT : VTK_DOUBLE;
  const std::string fault = FindFault(bounds,
    type == VTK_FLOAT ? std::numeric_limits<float>::max() : std::numeric_limits<double>::max());
  if (!fault.empty())
  {
    subdivision::Fail(this, fault);
    return 1;
  }
  vtkInformation* info = outputVector->GetInformationObject(0);
  if (info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) > 0)
  {
    return 1; // the first piece is the whole cage
  }
  auto* output = vtkUnstructuredGrid::GetData(outputVector);
  subdivision::FilterTraits traits;
  traits.Memory = "so many boxes. Make NumberOfCells smaller.";
  subdivision::RunOptions options;
  bool failed = false;
  subdivision::ConnectToFilter(this, options, failed);
  const auto make = [&]
  {
    output->SetPoints(MakePoints(this->NumberOfCells, bounds, type));
    if (options.Progress(0.2))
    {
      return false;
    }
    output->SetCells(VTK_TETRA, MakeCells(this->NumberOfCells));
    return true;
  };
  if (!subdivision::DoWork(traits, options, make))
  {
    output->Initialize();
  }
  return failed ? 0 : 1;
}

void vtkSubdivisionCageSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const int* n = this->NumberOfCells;
  const double* b = this->Bounds;
  os << indent << "NumberOfCells: " << n[0] << " " << n[1] << " " << n[2] << "\n";
  os << indent << "Bounds: " << b[0] << " " << b[1] << " " << b[2] << " " << b[3] << " " << b[4]
     << " " << b[5] << "\n";
  os << indent << "Margin: " << this->Margin << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
  os << indent << "Controller: " << this->Controller.Get() << "\n";
}
