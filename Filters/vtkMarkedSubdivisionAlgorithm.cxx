// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMarkedSubdivisionAlgorithm.h"

#include "Private/ArrayNames.h"
#include "Private/Control/CoincidentPoints.h"
#include "Private/Distribution/GatheredMesh.h"
#include "Private/Reading/InputArrays.h"
#include "Private/Reading/ReadableMesh.h"
#include "Private/Reading/SelectedParts.h"
#include "Private/Run/FilterRun.h"
#include "Private/Run/Ports.h"
#include "Private/Run/RunOptions.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkImplicitFunction.h"
#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkSelection.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <string>
#include <vector>

namespace
{

/// Adds an array of flags; missing flags are 0.
void AddFlags(const std::vector<unsigned char>& flags, vtkIdType size, vtkDataSetAttributes* data)
{
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName(subdivision::MarkedName);
  array->SetNumberOfValues(size);
  array->FillValue(0);
  std::copy(flags.begin(), flags.end(), array->GetPointer(0));
  data->AddArray(array);
}

/// Takes the flags out again.
vtkSmartPointer<vtkDataArray> TakeFlags(vtkDataSetAttributes* data)
{
  const vtkSmartPointer<vtkDataArray> flags = data->GetArray(subdivision::MarkedName);
  data->RemoveArray(subdivision::MarkedName);
  return flags;
}

}

vtkMarkedSubdivisionAlgorithm::vtkMarkedSubdivisionAlgorithm()
{
  this->SetNumberOfInputPorts(3);
}

vtkMarkedSubdivisionAlgorithm::~vtkMarkedSubdivisionAlgorithm() = default;

int vtkMarkedSubdivisionAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  return port == 0 ? this->Superclass::FillInputPortInformation(port, info)
    : port == 1    ? subdivision::TakeTypes(info, { "vtkSelection" }, true)
                   : subdivision::TakeTypes(
                    info, { "vtkUnstructuredGrid", "vtkPolyData", "vtkDataObjectTree" }, true);
}

void vtkMarkedSubdivisionAlgorithm::SetMarkSelectionConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

void vtkMarkedSubdivisionAlgorithm::SetCreaseConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(2, output);
}

vtkCxxSetSmartPointerMacro(vtkMarkedSubdivisionAlgorithm, MarkFunction, vtkImplicitFunction);

vtkImplicitFunction* vtkMarkedSubdivisionAlgorithm::GetMarkFunction() const
{
  return this->MarkFunction;
}

vtkMTimeType vtkMarkedSubdivisionAlgorithm::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->MarkFunction ? std::max(own, this->MarkFunction->GetMTime()) : own;
}

/// Makes the geometry whole, together with other ranks.
void vtkMarkedSubdivisionAlgorithm::PrepareRun(vtkDataObject* input)
{
  this->HasWholeInput =
    !this->SharesRanks() && (this->JoinBlocks || !vtkCompositeDataSet::SafeDownCast(input));
  this->Geometry = this->GetNumberOfInputConnections(2) > 0
    ? subdivision::GatherMesh(this->GetInputDataObject(2, 0),
        this->SharesRanks() ? this->Controller.Get() : nullptr, [this](const std::string& message)
        { subdivision::Warn(this, "Crease geometry: " + message); })
    : nullptr;
}

/// Writes the selection into the blocks, so that it can be found in the joined mesh, and gives the
/// geometry the ids that points have there.
vtkSmartPointer<vtkDataObject> vtkMarkedSubdivisionAlgorithm::Mark(
  vtkDataObject* input, vtkDataObject* readable)
{
  if (this->Geometry && this->CreasePoints == SAME_ID)
  {
    this->Geometry = subdivision::FollowMergedPoints(this->Geometry, readable);
  }
  if (this->GetNumberOfInputConnections(1) == 0 || !input)
  {
    return readable;
  }
  bool isUsable = true;
  const auto selected = subdivision::FindSelectedParts(input, readable,
    vtkSelection::SafeDownCast(this->GetInputDataObject(1, 0)),
    [&](const std::string& message)
    {
      isUsable = false;
      subdivision::Warn(this, "The selection of marks cannot be used. " + message);
    });
  if (selected.empty() && isUsable && this->HasWholeInput)
  {
    subdivision::Warn(this,
      "The selection (input port 1) has no point or cell of the input, so nothing is "
      "marked by it.");
  }
  return subdivision::ChangeMeshes(readable,
    [&](vtkDataObject* object, unsigned int) -> vtkSmartPointer<vtkDataObject>
    {
      const auto parts = selected.find(object);
      auto* mesh = vtkPointSet::SafeDownCast(object);
      if (!mesh || parts == selected.end())
      {
        return object;
      }
      const auto copy = vtkSmartPointer<vtkPointSet>::Take(mesh->NewInstance());
      copy->ShallowCopy(mesh);
      AddFlags(parts->second.Points, mesh->GetNumberOfPoints(), copy->GetPointData());
      AddFlags(parts->second.Cells, mesh->GetNumberOfCells(), copy->GetCellData());
      return copy;
    });
}

bool vtkMarkedSubdivisionAlgorithm::ReadFeatureOptions(
  vtkPointSet* input, subdivision::RunOptions& options)
{
  subdivision::MarkOptions& marks = options.Features.Marks;
  const auto find = [&](int index, vtkSmartPointer<vtkDataArray>& array)
  {
    vtkDataArray* found = nullptr;
    const bool isUsable =
      subdivision::FindInputArray(this, input->GetPointData(), input->GetNumberOfPoints(),
        { index, nullptr, false, true }, options.Warn, options.Fail, found);
    array = found;
    return isUsable;
  };
  if (!this->Superclass::ReadFeatureOptions(input, options) || !find(MARKS_ARRAY, marks.Array) ||
    !find(LEVELS_ARRAY, marks.Sharpness))
  {
    return false;
  }
  if (this->MarkByFunction && !this->MarkFunction)
  {
    options.Fail("MarkByFunction needs a MarkFunction.");
    return false;
  }
  marks.Corners = this->MarkCorners;
  marks.Creases = this->MarkCreases;
  marks.Surfaces = this->MarkSurfaces;
  marks.SelectedPoints = TakeFlags(input->GetPointData());
  marks.SelectedCells = TakeFlags(input->GetCellData());
  marks.Function = this->MarkByFunction ? this->MarkFunction.Get() : nullptr;
  marks.Geometry = this->Geometry;
  marks.ByIds = this->CreasePoints == SAME_ID;
  marks.TellsLost = this->HasWholeInput;
  return true;
}

void vtkMarkedSubdivisionAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MarkCorners: " << this->MarkCorners << "\n";
  os << indent << "MarkCreases: " << this->MarkCreases << "\n";
  os << indent << "MarkSurfaces: " << this->MarkSurfaces << "\n";
  os << indent << "MarkByFunction: " << this->MarkByFunction << "\n";
  os << indent << "MarkFunction: " << this->MarkFunction.Get() << "\n";
  os << indent << "CreasePoints: " << this->CreasePoints << "\n";
}
