// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bezier/BezierCells.h"

#include "Core/Memory/CellSplits.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Bezier/BezierPatches.h"
#include "Private/Bezier/ValueRanges.h"
#include "Private/Reading/ReadableMesh.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <memory>
#include <sstream>
#include <vector>

namespace subdivision
{
namespace
{

/// Rounds of one mesh, of which each has the cells that the one before did not know to fit.
using Rounds = std::vector<std::unique_ptr<BezierPatches>>;

/// A point of the mesh of a round.
struct RoundPoint
{
  std::size_t Round;
  vtkIdType Id;
};

/// Gathers tuples of all arrays that vtkDataSetAttributes copies, which are not global ids; `get`:
/// the data of the mesh of a round.
template <typename Get>
void GatherData(const Rounds& rounds, const std::vector<RoundPoint>& sources, const Get& get,
  vtkDataSetAttributes* to)
{
  to->CopyAllocate(get(rounds[0]->GetMesh()), static_cast<vtkIdType>(sources.size()));
  for (std::size_t round = 0; round < rounds.size(); ++round)
  {
    vtkNew<vtkIdList> fromIds;
    vtkNew<vtkIdList> toIds;
    for (const std::size_t i : InTurn(sources.size()))
    {
      if (sources[i].Round == round)
      {
        fromIds->InsertNextId(sources[i].Id);
        toIds->InsertNextId(static_cast<vtkIdType>(i));
      }
    }
    to->CopyData(get(rounds[round]->GetMesh()), fromIds, toIds);
  }
}

class BezierWriter
{
public:
  BezierWriter(const Rounds& rounds, const BezierOptions& options)
    : Made(rounds)
    , Options(options)
    , Next(rounds.size(), 0)
    , Before(rounds.size())
    , Components(rounds[0]->GetNumberOfComponents())
  {
    while (this->Next[0] < rounds[0]->Get().size())
    {
      this->Collect(0);
    }
  }
  vtkSmartPointer<vtkUnstructuredGrid> Write()
  {
    this->NumberPoints();
    this->WriteCells();
    this->WriteValues();
    return this->Output;
  }

private:
  /// A patch and its round.
  struct Chosen
  {
    std::size_t Round;
    const Patch* Which;
  };
  const BezierPatches& GetRound(const Chosen& chosen) const { return *this->Made[chosen.Round]; }
  const Root& GetRoot(const Chosen& chosen) const
  {
    return this->GetRound(chosen).GetCells().GetRoot(chosen.Which->Root);
  }
  /// Collects the patches of the next root of a round. A patch that is not known to fit is the next
  /// root of the next round.
  void Collect(std::size_t round)
  {
    const std::vector<Patch>& patches = this->Made[round]->Get();
    std::size_t& next = this->Next[round];
    const vtkIdType root = patches[next].Root;
    for (; next < patches.size() && patches[next].Root == root; ++next)
    {
      if (round + 1 < this->Made.size() && !this->Made[round]->IsKnown(patches[next]))
      {
        this->JoinCorners(round, patches[next]);
        this->Collect(round + 1);
      }
      else
      {
        this->Patches.push_back({ round, &patches[next] });
      }
    }
  }
  /// Notes which points the corners of the next root of the next round are in this one.
  void JoinCorners(std::size_t round, const Patch& patch)
  {
    const SplitRoots& cells = this->Made[round]->GetCells();
    const BezierPatches& after = *this->Made[round + 1];
    const Root& root = cells.GetRoot(patch.Root);
    const Root& child = after.GetCells().GetRoot(after.Get()[this->Next[round + 1]].Root);
    const LatticePart whole = GetWhole(child);
    std::vector<vtkIdType>& before = this->Before[round + 1];
    before.resize(static_cast<std::size_t>(after.GetMesh()->GetNumberOfPoints()), -1);
    for (const FrameNode& corner : GetPatchShape(root).CornerPoints)
    {
      before[after.GetCells().GetPoint(child, whole.At(corner, 2))] =
        cells.GetPoint(root, patch.Part.At(corner, 2));
    }
  }
  RoundPoint FindFirst(RoundPoint point) const
  {
    while (point.Round > 0 && this->Before[point.Round][point.Id] >= 0)
    {
      point.Id = this->Before[point.Round--][point.Id];
    }
    return point;
  }
  /// Corners are one point for all cells that have them. Other control points are one for cells of
  /// the same level, which have the same nodes on an edge or face that they share: all have one
  /// degree.
  void NumberPoints()
  {
    std::vector<std::vector<std::vector<vtkIdType>>> numbers(this->Made.size());
    std::vector<vtkIdType> nodes;
    this->Offsets.push_back(0);
    for (const Chosen& patch : InTurn(this->Patches))
    {
      const Root& root = this->GetRoot(patch);
      const int corners = root.Lattice ? GetPatchShape(root).Corners : VTK_INT_MAX;
      const int level = this->GetRound(patch).GetLevel(*patch.Which);
      this->GetRound(patch).GetNodes(*patch.Which, nodes);
      for (std::size_t k = 0; k < nodes.size(); ++k)
      {
        const bool isCorner = static_cast<int>(k) < corners;
        const RoundPoint node = { patch.Round, nodes[k] };
        const RoundPoint source = isCorner ? this->FindFirst(node) : node;
        const std::size_t table = isCorner ? 0 : 1 + level;
        auto& tables = numbers[source.Round];
        tables.resize(std::max(tables.size(), table + 1));
        if (tables[table].empty())
        {
          tables[table].assign(
            static_cast<std::size_t>(this->Made[source.Round]->GetMesh()->GetNumberOfPoints()), -1);
        }
        vtkIdType& number = tables[table][source.Id];
        if (number < 0)
        {
          number = static_cast<vtkIdType>(this->Sources.size());
          this->Sources.push_back(source);
          this->Owners.push_back(&patch - this->Patches.data());
        }
        this->Ids.push_back(number);
      }
      this->Offsets.push_back(static_cast<vtkIdType>(this->Ids.size()));
    }
  }
  void WriteCells()
  {
    const auto size = static_cast<vtkIdType>(this->Patches.size());
    const auto types = vtkSmartPointer<vtkUnsignedCharArray>::New();
    types->SetNumberOfValues(size);
    vtkNew<vtkIdTypeArray> offsets;
    vtkNew<vtkIdTypeArray> ids;
    offsets->SetNumberOfValues(size + 1);
    ids->SetNumberOfValues(static_cast<vtkIdType>(this->Ids.size()));
    std::copy(this->Offsets.begin(), this->Offsets.end(), offsets->GetPointer(0));
    std::copy(this->Ids.begin(), this->Ids.end(), ids->GetPointer(0));
    std::vector<RoundPoint> sources(this->Patches.size());
    ForEach(size,
      [&](vtkIdType p)
      {
        const Chosen& patch = this->Patches[p];
        const Root& root = this->GetRoot(patch);
        types->SetValue(p,
          static_cast<unsigned char>(root.Lattice
              ? GetPatchShape(root).CellType
              : this->GetRound(patch).GetCells().GetType(root)));
        sources[p] = { patch.Round, root.First }; // a root's cells have its data
      });
    vtkNew<vtkCellArray> cells;
    cells->SetData(offsets, ids);
    if (this->Options.Use32BitIds)
    {
      cells->ConvertTo32BitStorage();
    }
    this->Output->SetCells(types, cells);
    GatherData(
      this->Made, sources, [](vtkPointSet* mesh) { return mesh->GetCellData(); },
      this->Output->GetCellData());
  }
  void WriteValues()
  {
    const auto size = static_cast<vtkIdType>(this->Sources.size());
    GatherData(
      this->Made, this->Sources, [](vtkPointSet* mesh) { return mesh->GetPointData(); },
      this->Output->GetPointData());
    std::vector<double> values(static_cast<std::size_t>(this->Components * size));
    ForEach(size,
      [&](vtkIdType i)
      {
        const RoundPoint& source = this->Sources[i];
        std::copy_n(this->Made[source.Round]->GetValues(source.Id), this->Components,
          values.data() + this->Components * i);
      });
    ForEach(static_cast<vtkIdType>(this->Patches.size()),
      [&](vtkIdType p) { this->FitValues(p, values); });
    int component = 0;
    const std::vector<vtkDataArray*>& arrays = this->Made[0]->GetArrays();
    for (vtkDataArray* array : arrays)
    {
      const int components = array->GetNumberOfComponents();
      const auto fitted = MakeArray(array->GetDataType(), components, size);
      CopyLooks(array, fitted);
      ForEach(size, [&](vtkIdType i)
        { fitted->SetTuple(i, values.data() + this->Components * i + component); });
      component += components;
      if (array == arrays[0])
      {
        vtkNew<vtkPoints> points;
        points->SetData(fitted);
        this->Output->SetPoints(points);
      }
      else
      {
        AddInstead(this->Made[0]->GetMesh()->GetPointData(), fitted, this->Output->GetPointData());
      }
    }
  }

  /// Writes the values of points that no patch before has.
  void FitValues(vtkIdType p, std::vector<double>& values) const
  {
    const Chosen& patch = this->Patches[p];
    const BezierPatches& round = this->GetRound(patch);
    const Root& root = this->GetRoot(patch);
    if (!root.Lattice)
    {
      return;
    }
    const PatchShape& shape = round.GetShape(root);
    std::vector<vtkIdType> nodes;
    round.GetNodes(*patch.Which, nodes);
    for (std::size_t k = shape.Corners; k < nodes.size(); ++k)
    {
      const vtkIdType id = this->Ids[this->Offsets[p] + static_cast<vtkIdType>(k)];
      if (this->Owners[id] != p)
      {
        continue;
      }
      double* to = values.data() + this->Components * id;
      std::fill_n(to, this->Components, 0.);
      for (std::size_t node = 0; node < nodes.size(); ++node)
      {
        const double weight = shape.Weights[k][node];
        if (weight != 0.) // 0 times a value that is not finite is not 0
        {
          const double* from = round.GetValues(nodes[node]);
          for (int c = 0; c < this->Components; ++c)
          {
            to[c] += weight * from[c];
          }
        }
      }
    }
  }

  const Rounds& Made;
  const BezierOptions& Options;
  std::vector<std::size_t> Next; ///< of each round, the patch that is collected next
  /// Of the points of each round which ones they are in the round before; -1: not known.
  std::vector<std::vector<vtkIdType>> Before;
  const int Components;
  std::vector<Chosen> Patches;
  std::vector<vtkIdType> Offsets;  ///< where each patch begins in Ids
  std::vector<vtkIdType> Ids;      ///< of the control points of each patch
  std::vector<RoundPoint> Sources; ///< the point of a mesh that each control point belongs to
  std::vector<vtkIdType> Owners;   ///< the first patch of each control point
  vtkSmartPointer<vtkUnstructuredGrid> Output = vtkSmartPointer<vtkUnstructuredGrid>::New();
};

/// The largest value of all ranks.
int FindLargest(int value, vtkMultiProcessController* controller)
{
  int largest = value;
  if (controller && controller->GetNumberOfProcesses() > 1)
  {
    controller->AllReduce(&value, &largest, 1, vtkCommunicator::MAX_OP);
  }
  return largest;
}

/// Calls ofMesh(mesh) for each mesh.
template <typename OfMesh>
vtkSmartPointer<vtkDataObject> ForMeshes(vtkDataObject* data, const OfMesh& ofMesh)
{
  return ChangeMeshes(data,
    [&](vtkDataObject* object, unsigned int) -> vtkSmartPointer<vtkDataObject>
    {
      const bool isMesh =
        vtkUnstructuredGrid::SafeDownCast(object) || vtkPolyData::SafeDownCast(object);
      return isMesh ? ofMesh(vtkPointSet::SafeDownCast(object))
                    : vtkSmartPointer<vtkDataObject>(object);
    });
}

}

/// The rounds of each mesh, and the ranges that the first one found for all of them.
struct BezierState
{
  std::unique_ptr<ValueRanges> Ranges;
  int Degree = 0;
  std::vector<Rounds> Meshes;
  CellSplits Splits;
  bool AsksForSplits = true; ///< until a run takes no notice of them
  vtkIdType Cells = 0;       ///< how many there are at least
  vtkIdType Unknown = 0;     ///< how many of these the next round looks at
  /// Chooses the patches of an output of the filter.
  void Add(vtkDataObject* data, const BezierOptions& options)
  {
    if (!this->Ranges)
    {
      this->Ranges = std::make_unique<ValueRanges>(data, options.Controller);
    }
    if (this->Splits.Made.empty())
    {
      this->Meshes.clear(); // the whole has all of them
      this->Cells = this->Unknown = 0;
    }
    this->Cells -= this->Unknown;
    std::size_t number = 0;
    ForMeshes(data,
      [&](vtkPointSet* mesh) -> vtkSmartPointer<vtkDataObject>
      {
        this->Meshes.resize(std::max(this->Meshes.size(), number + 1));
        Rounds& rounds = this->Meshes[number];
        if (!mesh->GetPoints()) // also after an error
        {
          rounds.clear();
        }
        else
        {
          rounds.push_back(
            std::make_unique<BezierPatches>(mesh, *this->Ranges, options, this->Splits.Made));
          this->Degree = std::max(this->Degree, rounds.back()->FindDegree());
        }
        ++number;
        return mesh;
      });
    this->Degree = FindLargest(this->Degree, options.Controller);
    for (const Rounds& rounds : this->Meshes)
    {
      if (!rounds.empty())
      {
        rounds.back()->Choose(this->Degree);
        this->Cells += static_cast<vtkIdType>(rounds.back()->Get().size());
      }
    }
  }
  /// Whether another round has to look at some cells. If one mesh is all there is, that needs no
  /// more than these.
  bool GoesOn(vtkDataObject* data, const BezierOptions& options)
  {
    const bool areKnown = std::all_of(this->Meshes.begin(), this->Meshes.end(),
      [](const Rounds& rounds) { return rounds.empty() || rounds.back()->AreKnown(); });
    if (!options.MayGoOn || FindLargest(areKnown ? 0 : 1, options.Controller) == 0)
    {
      return false;
    }
    this->AsksForSplits = this->AsksForSplits && options.IsWhole &&
      vtkPointSet::SafeDownCast(data) && this->Splits.Flags.empty() == this->Splits.Made.empty();
    if (this->AsksForSplits)
    {
      const auto& flags = this->Splits.Flags.emplace_back(this->Meshes[0].back()->FlagUnknown());
      this->Unknown = std::count(flags.begin(), flags.end(), 1);
    }
    else
    {
      this->Splits.Flags.clear();
    }
    this->Splits.Made.clear();
    return true;
  }
  vtkSmartPointer<vtkDataObject> Write(vtkDataObject* data, const BezierOptions& options)
  {
    std::size_t number = 0;
    return ForMeshes(data,
      [&](vtkPointSet* mesh) -> vtkSmartPointer<vtkDataObject>
      {
        Rounds& rounds = this->Meshes[number++];
        const auto grid = rounds.empty() ? vtkSmartPointer<vtkUnstructuredGrid>::New()
                                         : BezierWriter(rounds, options).Write();
        rounds.clear();
        vtkFieldData* fields = mesh->GetFieldData();
        for (int a = 0; a < fields->GetNumberOfArrays(); ++a)
        {
          if (!BelongsToStamp(fields->GetAbstractArray(a)->GetName()))
          {
            grid->GetFieldData()->AddArray(fields->GetAbstractArray(a));
          }
        }
        return grid;
      });
  }
};

BezierRounds::BezierRounds() = default;
BezierRounds::~BezierRounds() = default;

CellSplits* BezierRounds::GetSplits() const
{
  return this->Now->Splits.Flags.empty() ? nullptr : &this->Now->Splits;
}

int BezierRounds::Run(int most, const std::function<int(double, double)>& run)
{
  double begin = 0.;
  int result = 0;
  this->Levels = std::min(1, most);
  this->Now = std::make_unique<BezierState>();
  do
  {
    this->GoesOn = false; // an error ends all
    this->MayGoOn = this->Levels < most;
    const double end = this->MayGoOn ? 0.5 * (begin + 1.) : 1.;
    result = run(begin, end);
    begin = end;
    ++this->Levels;
  } while (this->GoesOn);
  this->Now.reset();
  return result;
}

vtkSmartPointer<vtkDataObject> BezierRounds::Finish(vtkDataObject* made, BezierOptions options)
{
  const CellSplits& splits = this->Now->Splits;
  const int before = splits.Made.empty() ? 0 : static_cast<int>(splits.Flags.size());
  options.Levels = this->Levels - before;
  options.Steps = this->Levels + this->FurtherSteps - before;
  options.MayGoOn = this->MayGoOn;
  this->Now->Add(made, options);
  this->GoesOn = this->Now->GoesOn(made, options);
  const vtkIdType cells = this->Now->Cells;
  if (cells > options.MaximumNumberOfCells)
  {
    std::ostringstream message;
    message << "BezierTolerance = " << options.Tolerance << " would make "
            << (this->GoesOn ? "at least " : "") << cells
            << " Bezier cells, which is above MaximumNumberOfCells = "
            << options.MaximumNumberOfCells
            << ". Use a larger BezierTolerance or fewer levels, or raise MaximumNumberOfCells.";
    options.Fail(message.str());
    this->GoesOn = false;
    this->Now->Meshes = std::vector<Rounds>(this->Now->Meshes.size());
  }
  return this->GoesOn ? vtkSmartPointer<vtkDataObject>(made) : this->Now->Write(made, options);
}

vtkSmartPointer<vtkDataObject> MakeBezierCells(vtkDataObject* data, const BezierOptions& options)
{
  BezierState state;
  state.Add(data, options);
  return state.Write(data, options);
}

}
