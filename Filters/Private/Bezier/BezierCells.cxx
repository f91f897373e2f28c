// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bezier/BezierCells.h"

#include "Core/Memory/Buffer.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Bezier/BezierRoots.h"
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
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace subdivision
{
namespace
{

/// A part of a root that becomes one cell.
struct Patch
{
  vtkIdType Root;
  int Level;
  LatticePart Part;
};

/// What of the tolerance the checked points may use up: the largest error lies between them.
constexpr double ShareOfChecks = 2. / 3.;

class BezierWriter
{
public:
  BezierWriter(vtkPointSet* mesh, const ValueRanges& ranges, const BezierOptions& options)
    : Mesh(mesh)
    , Ranges(ranges)
    , Options(options)
    , Cells(mesh, options.Steps, options.Levels)
  {
    this->CheckSteps();
    this->ReadValues();
  }
  /// The largest degree that a root needs.
  int FindDegree() const
  {
    int degree = 0;
    for (const vtkIdType r : InTurn(this->Cells.GetNumberOfRoots()))
    {
      const Root& root = this->Cells.GetRoot(r);
      degree = std::max(degree, root.Kind < 0 ? 0 : BezierRoots::GetShape(root).Degree);
    }
    return degree;
  }
  /// All patches get one degree.
  void ChoosePatches(int degree);
  /// Whether no cell was split as often as is allowed: then all of them are known to fit.
  bool IsDone() const
  {
    return std::none_of(this->Patches.begin(), this->Patches.end(),
      [this](const Patch& patch)
      {
        const Root& root = this->Cells.GetRoot(patch.Root);
        return root.Kind >= 0 && patch.Level == root.Levels;
      });
  }
  vtkSmartPointer<vtkUnstructuredGrid> Write()
  {
    this->NumberPoints();
    this->WriteCells();
    this->WriteValues();
    return this->Output;
  }

private:
  void CheckSteps() const;
  void ReadValues();
  void Split(const Patch& patch, std::vector<Patch>& patches) const;
  bool Fits(const Patch& patch) const;
  void NumberPoints();
  void WriteCells();
  void WriteValues();
  void FitValues(vtkIdType p, std::vector<double>& values) const;

  const PatchShape& GetShape(const Root& root) const
  {
    return PatchShape::Get(static_cast<PatchShape::Kind>(root.Kind), this->Degree);
  }
  /// The points of the mesh that are the nodes of a patch, or the points of a cell that is written
  /// as it is.
  void GetNodes(const Patch& patch, std::vector<vtkIdType>& nodes) const;

  vtkPointSet* Mesh;
  const ValueRanges& Ranges;
  const BezierOptions& Options;
  const BezierRoots Cells;
  std::vector<vtkDataArray*> Arrays; ///< what is fitted, points first
  int Degree = 0;
  int Components = 0;
  Buffer<double> Values;       ///< of each point, one array after the other
  std::vector<double> Allowed; ///< what each component may leave out
  std::vector<Patch> Patches;
  std::vector<vtkIdType> Offsets; ///< where each patch begins in Ids
  std::vector<vtkIdType> Ids;     ///< of the control points of each patch
  std::vector<vtkIdType> Sources; ///< the point of the mesh that each control point belongs to
  std::vector<vtkIdType> Owners;  ///< the first patch of each control point
  vtkSmartPointer<vtkUnstructuredGrid> Output = vtkSmartPointer<vtkUnstructuredGrid>::New();
};

/// CountFurtherSteps sees what CellsToSimplices and MakeSurface read, so that this does not happen.
void BezierWriter::CheckSteps() const
{
  const vtkIdType cell = this->Cells.GetFirstWithoutPoints();
  if (cell >= 0)
  {
    this->Options.Fail("Cell " + std::to_string(cell) + " after " +
      std::to_string(this->Options.Steps) + " steps, of type " +
      std::to_string(this->Mesh->GetCellType(cell)) +
      ", was split too seldom for a Bezier cell: it and others of its kind stay linear. This is a "
      "fault of the filter, not of the input: report it, and set OutputCells to Linear.");
  }
}

/// Points and arrays of floating point numbers, in double, side by side.
void BezierWriter::ReadValues()
{
  const vtkIdType size = this->Mesh->GetNumberOfPoints();
  this->Arrays.assign({ this->Mesh->GetPoints()->GetData() });
  vtkPointData* data = this->Mesh->GetPointData();
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = data->GetArray(a);
    if (array && array->GetName() &&
      (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE))
    {
      this->Arrays.push_back(array);
    }
  }
  for (vtkDataArray* array : this->Arrays)
  {
    this->Components += array->GetNumberOfComponents();
    this->Allowed.resize(this->Components,
      this->Ranges.GetTolerance(array == this->Arrays[0] ? nullptr : array->GetName(),
        ShareOfChecks * this->Options.Tolerance, array->GetDataType() == VTK_FLOAT));
  }
  this->Values = Buffer<double>(this->Components * size);
  int component = 0;
  for (vtkDataArray* array : this->Arrays)
  {
    const vtkSmartPointer<vtkDataArray> contiguous = Contiguous(array);
    const int components = array->GetNumberOfComponents();
    const auto read = [&](const auto* values)
    {
      ForEach(size,
        [&](vtkIdType i)
        {
          std::copy_n(values + components * i, components,
            this->Values.data() + this->Components * i + component);
        });
    };
    if (array->GetDataType() == VTK_FLOAT)
    {
      read(static_cast<const float*>(contiguous->GetVoidPointer(0)));
    }
    else
    {
      read(static_cast<const double*>(contiguous->GetVoidPointer(0)));
    }
    component += components;
  }
}

/// Whether the polynomial of a patch is the limit at the points of one further step: what the
/// tolerance says of points is a distance, of arrays a difference of each component. What is not
/// finite tells nothing.
bool BezierWriter::Fits(const Patch& patch) const
{
  const Root& root = this->Cells.GetRoot(patch.Root);
  const PatchShape& shape = this->GetShape(root);
  std::vector<vtkIdType> nodes;
  this->GetNodes(patch, nodes);
  std::vector<double> values(this->Components);
  for (std::size_t i = 0; i < shape.Checked.size(); ++i)
  {
    const vtkIdType point =
      this->Cells.GetPoint(root, patch.Part.At(shape.Checked[i], 2 * shape.Divisions));
    std::fill(values.begin(), values.end(), 0.);
    for (std::size_t k = 0; k < nodes.size(); ++k)
    {
      const double weight = shape.CheckWeights[i][k];
      for (int c = 0; c < this->Components; ++c)
      {
        values[c] += weight * this->Values[this->Components * nodes[k] + c];
      }
    }
    for (int c = 0; c < this->Components; ++c)
    {
      values[c] = std::abs(values[c] - this->Values[this->Components * point + c]);
      if (values[c] > this->Allowed[c] && std::isfinite(values[c]))
      {
        return false;
      }
    }
    const double distance = std::hypot(values[0], values[1], values[2]);
    if (distance > this->Allowed[0] && std::isfinite(distance))
    {
      return false;
    }
  }
  return true;
}

void BezierWriter::Split(const Patch& patch, std::vector<Patch>& patches) const
{
  const Root& root = this->Cells.GetRoot(patch.Root);
  if (root.Kind < 0 || patch.Level == root.Levels || this->Fits(patch))
  {
    patches.push_back(patch);
    return;
  }
  Patch child = patch;
  ++child.Level;
  for (const LatticePart& part : BezierRoots::GetShape(root).Children)
  {
    child.Part = patch.Part.Take(part);
    this->Split(child, patches);
  }
}

void BezierWriter::ChoosePatches(int degree)
{
  this->Degree = degree;
  const vtkIdType size = this->Cells.GetNumberOfRoots();
  std::vector<std::vector<Patch>> patches(static_cast<std::size_t>(size));
  ForRangesOfBlocks(size,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType r = begin; r < end; ++r)
      {
        const Root& root = this->Cells.GetRoot(r);
        this->Split({ r, 0, this->Cells.GetWhole(root) }, patches[r]);
      }
    });
  for (const auto& ofRoot : InTurn(patches))
  {
    this->Patches.insert(this->Patches.end(), ofRoot.begin(), ofRoot.end());
  }
}

void BezierWriter::GetNodes(const Patch& patch, std::vector<vtkIdType>& nodes) const
{
  const Root& root = this->Cells.GetRoot(patch.Root);
  nodes.clear();
  if (root.Kind < 0)
  {
    this->Cells.GetPoints(root, nodes);
    return;
  }
  const PatchShape& shape = this->GetShape(root);
  for (const LatticePoint& node : shape.Nodes)
  {
    nodes.push_back(this->Cells.GetPoint(root, patch.Part.At(node, shape.Divisions)));
  }
}

/// Corners are one point for all cells that have them. Other control points are one for cells of
/// the same level, which have the same nodes on an edge or face that they share: all have one
/// degree.
void BezierWriter::NumberPoints()
{
  std::vector<std::vector<vtkIdType>> numbers;
  std::vector<vtkIdType> nodes;
  this->Offsets.push_back(0);
  for (const Patch& patch : InTurn(this->Patches))
  {
    const Root& root = this->Cells.GetRoot(patch.Root);
    const int corners = root.Kind < 0 ? VTK_INT_MAX : BezierRoots::GetShape(root).Corners;
    // Steps that a root lacks count as levels: control points belong to their lattice.
    const int level = root.Kind < 0 ? 0 : patch.Level + this->Options.Steps - root.Steps;
    this->GetNodes(patch, nodes);
    for (std::size_t k = 0; k < nodes.size(); ++k)
    {
      const std::size_t table = static_cast<int>(k) < corners ? 0 : 1 + level;
      if (numbers.size() <= table)
      {
        numbers.resize(table + 1);
      }
      if (numbers[table].empty())
      {
        numbers[table].assign(static_cast<std::size_t>(this->Mesh->GetNumberOfPoints()), -1);
      }
      vtkIdType& number = numbers[table][nodes[k]];
      if (number < 0)
      {
        number = static_cast<vtkIdType>(this->Sources.size());
        this->Sources.push_back(nodes[k]);
        this->Owners.push_back(&patch - this->Patches.data());
      }
      this->Ids.push_back(number);
    }
    this->Offsets.push_back(static_cast<vtkIdType>(this->Ids.size()));
  }
}

/// Gathers tuples of all arrays that vtkDataSetAttributes copies, which are not global ids.
void GatherData(
  vtkDataSetAttributes* from, const std::vector<vtkIdType>& sources, vtkDataSetAttributes* to)
{
  const auto size = static_cast<vtkIdType>(sources.size());
  vtkNew<vtkIdList> fromIds;
  vtkNew<vtkIdList> toIds;
  fromIds->SetNumberOfIds(size);
  toIds->SetNumberOfIds(size);
  ForEach(size,
    [&](vtkIdType i)
    {
      fromIds->SetId(i, sources[i]);
      toIds->SetId(i, i);
    });
  to->CopyAllocate(from, size);
  to->CopyData(from, fromIds, toIds);
}

void BezierWriter::WriteCells()
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
  std::vector<vtkIdType> sources(this->Patches.size());
  ForEach(size,
    [&](vtkIdType p)
    {
      const Patch& patch = this->Patches[p];
      const Root& root = this->Cells.GetRoot(patch.Root);
      types->SetValue(p,
        static_cast<unsigned char>(
          root.Kind < 0 ? this->Cells.GetType(root) : BezierRoots::GetShape(root).CellType));
      sources[p] = root.First; // a root's cells have its data
    });
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, ids);
  if (this->Options.Use32BitIds)
  {
    cells->ConvertTo32BitStorage();
  }
  this->Output->SetCells(types, cells);
  GatherData(this->Mesh->GetCellData(), sources, this->Output->GetCellData());
}

/// Writes what a patch is the first to have.
void BezierWriter::FitValues(vtkIdType p, std::vector<double>& values) const
{
  const Patch& patch = this->Patches[p];
  const Root& root = this->Cells.GetRoot(patch.Root);
  if (root.Kind < 0)
  {
    return;
  }
  const PatchShape& shape = this->GetShape(root);
  std::vector<vtkIdType> nodes;
  this->GetNodes(patch, nodes);
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
        const double* from = this->Values.data() + this->Components * nodes[node];
        for (int c = 0; c < this->Components; ++c)
        {
          to[c] += weight * from[c];
        }
      }
    }
  }
}

void BezierWriter::WriteValues()
{
  const auto size = static_cast<vtkIdType>(this->Sources.size());
  GatherData(this->Mesh->GetPointData(), this->Sources, this->Output->GetPointData());
  std::vector<double> values(static_cast<std::size_t>(this->Components * size));
  ForEach(size,
    [&](vtkIdType i)
    {
      std::copy_n(this->Values.data() + this->Components * this->Sources[i], this->Components,
        values.data() + this->Components * i);
    });
  ForEach(
    static_cast<vtkIdType>(this->Patches.size()), [&](vtkIdType p) { this->FitValues(p, values); });
  int component = 0;
  for (vtkDataArray* array : this->Arrays)
  {
    const int components = array->GetNumberOfComponents();
    const auto fitted = MakeArray(array->GetDataType(), components, size);
    CopyLooks(array, fitted);
    const auto write = [&](auto* to)
    {
      using T = std::remove_pointer_t<decltype(to)>;
      ForEach(size,
        [&](vtkIdType i)
        {
          for (int c = 0; c < components; ++c)
          {
            to[components * i + c] = static_cast<T>(values[this->Components * i + component + c]);
          }
        });
    };
    if (array->GetDataType() == VTK_FLOAT)
    {
      write(static_cast<float*>(fitted->GetVoidPointer(0)));
    }
    else
    {
      write(static_cast<double*>(fitted->GetVoidPointer(0)));
    }
    component += components;
    if (array == this->Arrays[0])
    {
      vtkNew<vtkPoints> points;
      points->SetData(fitted);
      this->Output->SetPoints(points);
    }
    else
    {
      AddInstead(this->Mesh->GetPointData(), fitted, this->Output->GetPointData());
    }
  }
}

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

}

vtkSmartPointer<vtkDataObject> MakeBezierCells(vtkDataObject* data, const BezierOptions& options)
{
  const ValueRanges ranges(data, options.Controller);
  std::vector<std::unique_ptr<BezierWriter>> writers;
  int degree = 0;
  const auto change = [&](const auto& ofMesh)
  {
    return ChangeMeshes(data,
      [&](vtkDataObject* object, unsigned int) -> vtkSmartPointer<vtkDataObject>
      {
        const bool isMesh =
          vtkUnstructuredGrid::SafeDownCast(object) || vtkPolyData::SafeDownCast(object);
        return isMesh ? ofMesh(vtkPointSet::SafeDownCast(object))
                      : vtkSmartPointer<vtkDataObject>(object);
      });
  };
  change(
    [&](vtkPointSet* mesh) -> vtkSmartPointer<vtkDataObject>
    {
      writers.push_back(
        mesh->GetPoints() ? std::make_unique<BezierWriter>(mesh, ranges, options) : nullptr);
      degree = std::max(degree, writers.back() ? writers.back()->FindDegree() : 0);
      return mesh;
    });
  degree = FindLargest(degree, options.Controller);
  bool isDone = true;
  for (const auto& made : writers)
  {
    if (made)
    {
      made->ChoosePatches(degree);
      isDone = isDone && made->IsDone();
    }
  }
  if (options.MayGoOn && FindLargest(isDone ? 0 : 1, options.Controller) > 0)
  {
    return nullptr;
  }
  auto writer = writers.begin();
  return change(
    [&](vtkPointSet* mesh) -> vtkSmartPointer<vtkDataObject>
    {
      const auto grid = *writer ? (*writer)->Write() : vtkSmartPointer<vtkUnstructuredGrid>::New();
      (writer++)->reset();
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

int BezierRounds::Run(int most, const std::function<int(double, double)>& run)
{
  double begin = 0.;
  int result = 0;
  this->Levels = std::min(1, most);
  do
  {
    this->GoesOn = false; // an error ends all
    this->MayGoOn = this->Levels < most;
    const double end = this->MayGoOn ? 0.5 * (begin + 1.) : 1.;
    result = run(begin, end);
    begin = end;
    ++this->Levels;
  } while (this->GoesOn);
  return result;
}

vtkSmartPointer<vtkDataObject> BezierRounds::Finish(vtkDataObject* made, BezierOptions options)
{
  options.Levels = this->Levels;
  options.Steps = this->GetSteps();
  options.MayGoOn = this->MayGoOn;
  const auto cells = MakeBezierCells(made, options);
  this->GoesOn = !cells;
  return cells ? cells : vtkSmartPointer<vtkDataObject>(made);
}

}
