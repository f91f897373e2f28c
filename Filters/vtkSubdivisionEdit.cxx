// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSubdivisionEdit.h"

#include "Private/Distribution/Distribution.h"
#include "Private/Edit/EditMesh.h"
#include "Private/Reading/ReadableMesh.h"
#include "Private/Run/FilterRun.h"
#include "Private/Run/Ports.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkSelection.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkSubdivisionEdit);

namespace
{

/// A mesh, or the blocks of a composite data set in their order.
std::vector<vtkDataObject*> ListMeshes(vtkDataObject* object)
{
  auto* all = vtkCompositeDataSet::SafeDownCast(object);
  if (!all)
  {
    return { object };
  }
  std::vector<vtkDataObject*> meshes;
  auto at = vtkSmartPointer<vtkCompositeDataIterator>::Take(all->NewIterator());
  for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
  {
    meshes.push_back(at->GetCurrentDataObject());
  }
  return meshes;
}

/// The inputs of an edit, mesh by mesh.
struct EditInputs
{
  vtkSmartPointer<vtkDataObject> Readable;
  vtkSmartPointer<vtkDataObject> Rest; ///< null: there is none
  bool HasSelection = false;
  std::map<vtkDataObject*, subdivision::SelectedParts> Selected; ///< of the mesh at rest, if any
  std::map<vtkDataObject*, subdivision::EditedMesh> Meshes;      ///< by those of the input
  const subdivision::SelectedParts Nothing;

  /// Returns false if the mesh at rest has other blocks.
  bool Connect(vtkDataObject* input)
  {
    const auto given = ListMeshes(input);
    const auto readable = ListMeshes(this->Readable);
    const auto rest = this->Rest ? ListMeshes(this->Rest) : readable;
    if (rest.size() != given.size())
    {
      return false;
    }
    for (std::size_t i = 0; i < given.size(); ++i)
    {
      subdivision::EditedMesh& mesh = this->Meshes[given[i]];
      mesh.Readable = vtkPointSet::SafeDownCast(readable[i]);
      mesh.Rest = this->Rest ? vtkPointSet::SafeDownCast(rest[i]) : nullptr;
      if (this->Rest && !mesh.Rest)
      {
        return false;
      }
      const auto found = this->Selected.find(rest[i]);
      const bool isThere = found != this->Selected.end();
      mesh.Selected = !this->HasSelection ? nullptr : isThere ? &found->second : &this->Nothing;
    }
    return true;
  }
};

}

vtkSubdivisionEdit::vtkSubdivisionEdit()
{
  this->SetNumberOfInputPorts(3);
}

vtkSubdivisionEdit::~vtkSubdivisionEdit() = default;

void vtkSubdivisionEdit::AddPaintedArray(const char* name)
{
  if (name && *name)
  {
    this->PaintedArrays.emplace_back(name);
    this->Modified();
  }
}

void vtkSubdivisionEdit::RemoveAllPaintedArrays()
{
  if (!this->PaintedArrays.empty())
  {
    this->PaintedArrays.clear();
    this->Modified();
  }
}

int vtkSubdivisionEdit::FillInputPortInformation(int port, vtkInformation* info)
{
  return port == 1 ? subdivision::TakeTypes(info, { "vtkSelection" }, true)
                   : subdivision::TakeTypes(info, { "vtkPointSet", "vtkDataObjectTree" }, port > 0);
}

int vtkSubdivisionEdit::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  subdivision::EditOptions options;
  std::copy_n(this->Translation, 3, options.Translation);
  std::copy_n(this->Rotation, 3, options.Rotation);
  std::copy_n(this->Scale, 3, options.Scale);
  std::copy_n(this->Centre, 3, options.Centre);
  options.IsLocal = this->Frame == LOCAL;
  options.FalloffRadius = this->FalloffRadius;
  options.Shape = static_cast<subdivision::FalloffShapeKind>(this->FalloffShape);
  options.AlongEdges = this->FalloffAlong == EDGES;
  options.PaintedArrays = this->PaintedArrays;
  options.PaintedValue = this->PaintedValue;
  options.PaintsCells = this->Painted == PAINT_CELLS;
  options.AddsIds = this->AddedArrays == ADD_IDS;
  subdivision::FilterTraits traits;
  traits.WrongInput = "The input is missing, or is no vtkPointSet.";
  traits.Memory = "the points and cells of the input. Use a part of the input.";
  traits.FallsBackToInput = true;
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  vtkDataObject* rest = options.IsLocal ? vtkDataObject::GetData(inputVector[2]) : nullptr;
  EditInputs inputs;
  bool isUsable = true;
  bool failed = false;
  const subdivision::ProgressPart all;
  options.Part = all.Take(0., 0.1);
  subdivision::ConnectToFilter(this, options, failed);
  const auto read = [&]
  {
    std::vector<std::string> warnings; // of cells, which the filters that subdivide tell
    const auto rule = subdivision::NonLinearRule::Pieces;
    inputs.Readable = subdivision::MakeReadable(input, rule, warnings);
    inputs.Rest = rest ? subdivision::MakeReadable(rest, rule, warnings) : nullptr;
    inputs.HasSelection = this->GetNumberOfInputConnections(1) > 0;
    if (inputs.HasSelection)
    {
      inputs.Selected =
        subdivision::FindSelectedParts(rest ? rest : input, rest ? inputs.Rest : inputs.Readable,
          vtkSelection::SafeDownCast(vtkDataObject::GetData(inputVector[1])),
          [&](const std::string& message)
          {
            isUsable = false;
            options.Fail("The selection cannot be used: the output is the input. " + message);
          });
    }
    if (isUsable && !inputs.Connect(input))
    {
      isUsable = false;
      options.Fail("The mesh at rest has other blocks than the input: the output is the input. "
                   "Connect what the input was before its control mesh was moved.");
    }
    return true;
  };
  if (!subdivision::DoWork(traits, options, read))
  {
    output->Initialize();
    return failed ? 0 : 1;
  }
  if (!isUsable)
  {
    output->ShallowCopy(input);
    return 1;
  }
  if (inputs.HasSelection && inputs.Selected.empty())
  {
    options.Warn("The selection (input port 1) has no point or cell of the input, so nothing is "
                 "edited. Select some, or disconnect it to edit all.");
  }
  options.Part = all.Take(0.1, 1.);
  return subdivision::RunOnBlocks(this, input, output, traits, options,
    [&](vtkPointSet* mesh, vtkPointSet* made)
    { return subdivision::EditMesh(mesh, inputs.Meshes[mesh], options, made); });
}

void vtkSubdivisionEdit::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, const double* values)
  { os << indent << name << ": " << values[0] << " " << values[1] << " " << values[2] << "\n"; };
  print("Translation", this->Translation);
  print("Rotation", this->Rotation);
  print("Scale", this->Scale);
  print("Centre", this->Centre);
  os << indent << "Frame: " << this->Frame << "\n";
  os << indent << "FalloffRadius: " << this->FalloffRadius << "\n";
  os << indent << "FalloffShape: " << this->FalloffShape << "\n";
  os << indent << "FalloffAlong: " << this->FalloffAlong << "\n";
  os << indent << "Painted arrays:";
  for (const std::string& name : this->PaintedArrays)
  {
    os << " " << name;
  }
  os << "\n";
  os << indent << "PaintedValue: " << this->PaintedValue << "\n";
  os << indent << "Painted: " << this->Painted << "\n";
  os << indent << "AddedArrays: " << this->AddedArrays << "\n";
}
