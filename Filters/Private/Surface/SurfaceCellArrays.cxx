// SPDX-License-Identifier: BSD-3-Clause
// The cell data of a subdivision of a surface, from cells to their children.
#include "Private/Surface/SurfaceRun.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/Loops.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Arrays/CellArrays.h"

#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace subdivision
{
namespace
{

/// Whether two arrays of one type and shape have the same values.
bool HoldSame(vtkAbstractArray* a, vtkAbstractArray* b)
{
  vtkDataArray* first = vtkDataArray::SafeDownCast(a);
  vtkDataArray* second = vtkDataArray::SafeDownCast(b);
  if (first && second && first->GetDataType() != VTK_BIT)
  {
    return HoldsSameValues(first, second);
  }
  bool same = a->GetNumberOfValues() == b->GetNumberOfValues();
  for (vtkIdType i = 0; same && i < a->GetNumberOfValues(); ++i)
  {
    same = a->GetVariantValue(i) == b->GetVariantValue(i);
  }
  return same;
}

/// For each face of level `last` the face of level `first` whose cell data it shows. Of the two
/// faces of an edge it is the one that lies in the control face with the smaller id.
template <typename Id>
Buffer<vtkIdType> FindFaceSources(const SurfaceSteps<Id>& steps, int first, int last)
{
  const Buffer<Carrier<Id>> carriers = steps.FindCarriers(first, last);
  const auto controls = first > 0 ? steps.FindCarriers(0, first) : Buffer<Carrier<Id>>();
  auto isBefore = [&controls](Id a, Id b)
  {
    const Id control[2] = { controls.empty() ? 0 : controls[a].First,
      controls.empty() ? 0 : controls[b].First };
    return control[0] != control[1] ? control[0] < control[1] : a < b;
  };
  Buffer<vtkIdType> sources(carriers.size());
  ForEach(sources.size(),
    [&](vtkIdType i)
    {
      const Carrier<Id>& carrier = carriers[i];
      const bool isSecond = carrier.Second >= 0 && isBefore(carrier.Second, carrier.First);
      sources[i] = isSecond ? carrier.Second : carrier.First;
    });
  return sources;
}

/// Finds the tuples from which the cells of an output take their data: vertices and lines from
/// vertices and lines of the input; faces from faces of the input or, where these do not show the
/// data of all earlier faces, of an earlier level.
template <typename Id>
class SurfaceSources
{
public:
  SurfaceSources(const SurfaceCells& cells, const SurfaceSteps<Id>& steps, int firstStep,
    const CarriedCells& carried)
    : Cells(cells)
    , Steps(steps)
    , FirstStep(firstStep)
    , Carried(carried)
  {
  }

  /// Finds carried arrays that were changed since they were shown.
  void FindChanged(vtkPolyData* input)
  {
    for (int a = 0; a < input->GetCellData()->GetNumberOfArrays(); ++a)
    {
      vtkAbstractArray* array = input->GetCellData()->GetAbstractArray(a);
      const CarriedCells::Entry* base = this->FindBase(array);
      if (base && array->GetNumberOfTuples() == input->GetNumberOfCells() &&
        !this->IsShown(*base, array))
      {
        this->Changed.insert(base->Name);
      }
    }
  }
  /// Makes an array of the output from one of the input, and adds to `next` its data for the next
  /// filter.
  vtkSmartPointer<vtkAbstractArray> Copy(vtkAbstractArray* array, CarriedCells& next)
  {
    const CarriedCells::Entry* base = this->FindBase(array);
    const int level = base ? base->Level : this->FirstStep;
    if (array->GetName() && !this->IsWholeAfter(level))
    {
      next.Entries.push_back(
        { array->GetName(), level, base ? base->Array : this->GatherFaces(array) });
    }
    if (!base)
    {
      return Gather(array, Whole(this->GetSources()));
    }
    const vtkIdType tuples = array->GetNumberOfTuples();
    std::vector<vtkIdType> all(tuples);
    std::iota(all.begin(), all.end(), 0);
    const auto both = Gather(array, { all.data(), all.data() + tuples });
    both->InsertTuples(tuples, base->Array->GetNumberOfTuples(), 0, base->Array);
    const Buffer<vtkIdType>& faces = this->FindSources(level, this->Steps.GetNumberOfSteps());
    return Gather(both, Whole(this->Join([&](vtkIdType f) { return tuples + faces[f]; })));
  }
  /// The input cell of each output cell.
  const Buffer<vtkIdType>& GetSources()
  {
    if (this->Sources.empty())
    {
      const Buffer<vtkIdType>& faces =
        this->FindSources(this->FirstStep, this->Steps.GetNumberOfSteps());
      this->Sources = this->Join([&](vtkIdType f) { return this->Cells.FaceCells[faces[f]]; });
    }
    return this->Sources;
  }
  /// Makes the array of the input cell that each output cell comes from.
  vtkSmartPointer<vtkIdTypeArray> CopyIds(const char* name, CarriedCells& next)
  {
    const auto ids = MakeIds(name, this->GetSources());
    if (!this->IsWholeAfter(this->FirstStep))
    {
      next.Entries.push_back({ name, this->FirstStep, MakeIds(name, this->Cells.FaceCells) });
    }
    return ids;
  }

private:
  static Row<vtkIdType> Whole(const Buffer<vtkIdType>& sources)
  {
    return { sources.begin(), sources.end() };
  }
  template <typename List>
  static vtkSmartPointer<vtkIdTypeArray> MakeIds(const char* name, const List& values)
  {
    auto ids = vtkSmartPointer<vtkIdTypeArray>::New();
    ids->SetName(name);
    ids->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
    std::copy(values.begin(), values.end(), ids->GetPointer(0));
    return ids;
  }
  /// Whether each face of the last level lies in a single face of `level`.
  bool IsWholeAfter(int level) const
  {
    const int period = this->Steps.GetScheme().GetCarrierPeriod();
    const int steps = this->Steps.GetNumberOfSteps() - level;
    return steps == 0 || (period > 0 && steps % period == 0);
  }
  vtkSmartPointer<vtkAbstractArray> GatherFaces(vtkAbstractArray* array) const
  {
    const std::vector<vtkIdType>& faces = this->Cells.FaceCells;
    return Gather(array, { faces.data(), faces.data() + faces.size() });
  }
  /// The sources of vertices and lines, then `ofFace(f)` for each face f of the last level.
  template <typename OfFace>
  Buffer<vtkIdType> Join(const OfFace& ofFace) const
  {
    const SurfaceCells& cells = this->Cells;
    const SurfaceLevel<Id>& last = this->Steps.GetLevel(this->Steps.GetNumberOfSteps());
    const vtkIdType vertices = static_cast<vtkIdType>(cells.VertexCells.size());
    const vtkIdType segments = static_cast<vtkIdType>(cells.SegmentCells.size());
    const vtkIdType lines = last.Lines.size();
    Buffer<vtkIdType> sources(vertices + lines + last.Mesh.NumberOfFaces);
    std::copy(cells.VertexCells.begin(), cells.VertexCells.end(), sources.begin());
    ForEach(lines,
      [&](vtkIdType i) { sources[vertices + i] = cells.SegmentCells[i / (lines / segments)]; });
    ForEach(
      last.Mesh.NumberOfFaces, [&](vtkIdType f) { sources[vertices + lines + f] = ofFace(f); });
    return sources;
  }
  /// FindFaceSources, stored for the next array.
  const Buffer<vtkIdType>& FindSources(int first, int last)
  {
    Buffer<vtkIdType>& sources = this->Known[{ first, last }];
    if (sources.empty())
    {
      sources = FindFaceSources(this->Steps, first, last);
    }
    return sources;
  }

  /// The carried data of earlier faces for an array, if the input still shows them. Null if there
  /// are none or the array was changed since: then the values of the input are used.
  const CarriedCells::Entry* FindBase(vtkAbstractArray* array) const
  {
    const CarriedCells::Entry* base = this->Carried.Find(array->GetName());
    if (!base || base->Level >= this->FirstStep || this->Changed.count(base->Name) > 0 ||
      base->Array->GetDataType() != array->GetDataType() ||
      base->Array->GetNumberOfComponents() != array->GetNumberOfComponents() ||
      base->Array->GetNumberOfTuples() != this->Steps.GetLevel(base->Level).Mesh.NumberOfFaces)
    {
      return nullptr;
    }
    return base;
  }
  /// Whether the cells show them.
  bool IsShown(const CarriedCells::Entry& base, vtkAbstractArray* array)
  {
    const Buffer<vtkIdType>& faces = this->FindSources(base.Level, this->FirstStep);
    return HoldSame(Gather(base.Array, Whole(faces)), this->GatherFaces(array));
  }

  const SurfaceCells& Cells;
  const SurfaceSteps<Id>& Steps;
  const int FirstStep;
  const CarriedCells& Carried;
  Buffer<vtkIdType> Sources;
  std::set<std::string> Changed; ///< carried arrays that do not count
  std::map<std::pair<int, int>, Buffer<vtkIdType>> Known;
};

}

/// Copies every cell array of the input to the cells of the last level. The sharpness of lines is
/// reduced.
template <typename Id>
void SurfaceRun<Id>::CopyCellData()
{
  CellArrayOptions arrays;
  arrays.PointsMove = true;
  arrays.OriginalIds = this->Options.GenerateOriginalIds;
  arrays.CarryOriginalIds = this->Stamp.Levels > 0 &&
    HasIds(this->Input->GetCellData(), OriginalCellIdsName, this->Input->GetNumberOfCells());
  arrays.Warn = this->Options.Warn;
  SurfaceSources<Id> sources(this->Cells, *this->Steps, this->MadeLevels, this->Stamp.Carried);
  CarriedCells next;
  sources.FindChanged(this->Input);
  CopyCellArrays(
    this->Input, arrays, [&](vtkAbstractArray* array) { return sources.Copy(array, next); },
    [&] { return sources.CopyIds(OriginalCellIdsName, next); },
    [&]
    {
      const Buffer<vtkIdType>& cells = sources.GetSources();
      return AreAllCells({ cells.begin(), cells.end() }, this->Input->GetNumberOfCells());
    },
    this->Output);
  this->Stamp.Carried = std::move(next);
  if (vtkDataArray* given = this->Options.Features.Sharpness)
  {
    vtkDataArray* sharpness = this->Output->GetCellData()->GetArray(given->GetName());
    const vtkIdType first = static_cast<vtkIdType>(this->Cells.VertexCells.size());
    const vtkIdType lines = GetLast(*this->Steps).Lines.size();
    const int steps = this->Steps->GetNumberOfSteps() - this->MadeLevels;
    for (vtkIdType i = first; sharpness && i < first + lines; ++i)
    {
      sharpness->SetComponent(i, 0, std::max(sharpness->GetComponent(i, 0) - steps, 0.));
    }
  }
}

SUBDIVISION_COMPILE(class SurfaceRun);

}
