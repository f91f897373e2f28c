// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Distribution/KeptParts.h"

#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Control/GreenLeaves.h"
#include "Private/Distribution/PlacesOfIds.h"
#include "Private/Values/PointCopies.h"
#include "Private/vtkSubdivisionObjectsCompat.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <functional>

namespace subdivision
{
namespace
{

/// Collects the numbers that have to be the same.
class KeyMaker
{
public:
  explicit KeyMaker(std::vector<std::uint64_t>& key)
    : Key(key)
  {
  }
  void Add(std::uint64_t number) { this->Key.push_back(number); }
  void Add(vtkDataArray* values)
  {
    this->Add(static_cast<std::uint64_t>(values ? values->GetNumberOfValues() : -1));
    if (values)
    {
      const auto print = ComputeFingerprint(Contiguous(values));
      this->Key.insert(this->Key.end(), print.begin(), print.end());
    }
  }
  /// Names and types of arrays.
  void AddKinds(vtkDataSetAttributes* data)
  {
    for (int a = 0; a < data->GetNumberOfArrays(); ++a)
    {
      vtkAbstractArray* array = data->GetAbstractArray(a);
      this->Add(std::hash<std::string>()(array->GetName() ? array->GetName() : ""));
      this->Add(static_cast<std::uint64_t>(array->GetDataType()));
      this->Add(static_cast<std::uint64_t>(array->GetNumberOfComponents()));
    }
  }
  void AddCells(vtkPointSet* mesh)
  {
    if (auto* grid = vtkUnstructuredGrid::SafeDownCast(mesh))
    {
      this->Add(GetCellTypes(grid));
    }
    ForEachCellArray(mesh,
      [this](vtkCellArray* cells, vtkIdType)
      {
        this->Add(cells->GetOffsetsArray());
        this->Add(cells->GetConnectivityArray());
      });
    this->Add(mesh->GetCellGhostArray());
  }
  /// The names of points and cells: ids or, if there are none, coordinates, and the stamp of an
  /// earlier filter.
  void AddIds(vtkPointSet* mesh)
  {
    vtkDataArray* ids = mesh->GetPointData()->GetGlobalIds();
    this->Add(ids ? ids : mesh->GetPoints()->GetData());
    this->Add(mesh->GetCellData()->GetGlobalIds());
    vtkFieldData* field = mesh->GetFieldData();
    for (int a = 0; a < field->GetNumberOfArrays(); ++a)
    {
      if (BelongsToStamp(field->GetAbstractArray(a)->GetName()))
      {
        this->Add(field->GetArray(a));
      }
    }
  }

private:
  std::vector<std::uint64_t>& Key;
};

bool HaveLeaves(const std::vector<MeshPart>& parts)
{
  return std::any_of(parts.begin(), parts.end(),
    [](const MeshPart& part) { return !GreenLeaves(part.Mesh).IsEmpty(); });
}

/// The same part without the data that the next execution brings: an own part without its mesh, one
/// that came from others without values. What remains is the part that ShareArrays adds.
MeshPart DropValues(const MeshPart& part, bool hasCome)
{
  MeshPart kept = part;
  if (!hasCome)
  {
    kept.Mesh = part.Block == NoBlock ? part.Mesh : nullptr;
    return kept;
  }
  kept.Mesh = vtkSmartPointer<vtkPointSet>::Take(part.Mesh->NewInstance());
  kept.Mesh->ShallowCopy(part.Mesh);
  kept.Mesh->SetPoints(nullptr);
  kept.Mesh->GetPointData()->Initialize();
  kept.Mesh->GetCellData()->Initialize();
  return kept;
}

/// A kept part that may get values.
MeshPart Copy(const MeshPart& kept)
{
  MeshPart part = kept;
  part.Mesh = vtkSmartPointer<vtkPointSet>::Take(kept.Mesh->NewInstance());
  part.Mesh->ShallowCopy(kept.Mesh);
  return part;
}

}

bool KeptPartition::Restore(
  std::vector<MeshPart>& parts, int layers, bool joinsCopies, Exchange& exchange)
{
  this->Current.clear();
  this->CurrentPlaces.clear();
  KeyMaker key(this->Current);
  KeyMaker places(this->CurrentPlaces);
  key.Add(static_cast<std::uint64_t>(layers));
  key.Add(static_cast<std::uint64_t>(exchange.GetNumberOfPartitions()));
  key.Add(joinsCopies ? 1 : 0);
  key.Add(parts.size());
  for (const MeshPart& part : parts)
  {
    key.AddCells(part.Mesh);
    key.AddIds(part.Mesh);
    if (part.Mesh->GetPointData()->GetGlobalIds() && part.Mesh->GetPoints())
    {
      places.Add(part.Mesh->GetPoints()->GetData());
    }
    if (joinsCopies)
    {
      key.Add(part.Mesh->GetPointData()->GetArray(MaterialPointIdsName));
    }
    key.AddKinds(part.Mesh->GetPointData());
    key.AddKinds(part.Mesh->GetCellData());
  }
  // Points of one id are one where they lie at one place: when they move, that is found out anew
  // where it was not so, and else compared with the new coordinates.
  const bool haveMoved = !exchange.Agree(this->CurrentPlaces == this->KnownPlaces);
  if (!exchange.Agree(this->Current == this->Known) || (haveMoved && this->HasSeveralPlaces))
  {
    this->Forget();
    return false;
  }
  const std::vector<MeshPart> given = parts;
  for (size_t i = 0; i < this->Parts.size(); ++i)
  {
    const MeshPart& kept = this->Parts[i];
    if (i < given.size())
    {
      parts[i].Points = kept.Points;
      parts[i].Cells = kept.Cells;
      parts[i].Levels = kept.Levels;
      parts[i].Case = kept.Case;
    }
    else
    {
      parts.push_back(Copy(kept));
    }
  }
  SendValuesAgain(parts, this->Sent, exchange);
  if (haveMoved && !HavePlacesOfIds(parts, exchange))
  {
    parts = given;
    this->Forget();
    return false;
  }
  this->KnownPlaces = std::move(this->CurrentPlaces);
  return true;
}

void KeptPartition::Keep(const std::vector<MeshPart>& parts, SentLayers sent, bool areStamped,
  bool haveSeveralPlaces, std::vector<std::string> warnings)
{
  // Leaves number their points and cells anew in each part: values alone are not enough.
  this->Known = HaveLeaves(parts) ? Key() : std::move(this->Current);
  this->KnownPlaces = std::move(this->CurrentPlaces);
  this->HasSeveralPlaces = haveSeveralPlaces;
  std::vector<char> hasCome(parts.size(), 0);
  for (const auto& [from, list] : sent.In)
  {
    for (const size_t i : list)
    {
      hasCome[i] = 1;
    }
  }
  this->Parts.clear();
  for (size_t i = 0; i < parts.size(); ++i)
  {
    this->Parts.push_back(DropValues(parts[i], hasCome[i]));
  }
  this->Sent = std::move(sent);
  this->Stamped = areStamped;
  this->Warnings = std::move(warnings);
}

void KeptPartition::Forget()
{
  this->Known.clear();
  this->Parts.clear();
  this->Sent = SentLayers();
  this->Warnings.clear();
}

}
