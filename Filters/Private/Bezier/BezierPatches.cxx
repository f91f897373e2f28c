// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bezier/BezierPatches.h"

#include "Private/Bezier/ValueRanges.h"

#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>

namespace subdivision
{
namespace
{

/// The share of the tolerance for checked points: the largest error lies between them.
constexpr double ShareOfChecks = 2. / 3.;

vtkSmartPointer<vtkPointSet> CopyMesh(vtkPointSet* mesh)
{
  auto copy = vtkSmartPointer<vtkPointSet>::Take(mesh->NewInstance());
  copy->ShallowCopy(mesh);
  return copy;
}

}

BezierPatches::BezierPatches(vtkPointSet* mesh, const ValueRanges& ranges,
  const BezierOptions& options, const std::vector<char>& made)
  : Mesh(CopyMesh(mesh))
  , Options(options)
  , Made(made)
  , Cells(this->Mesh, options.Steps, options.Levels)
{
  this->CheckSteps();
  this->ReadValues(ranges);
}

int BezierPatches::FindDegree() const
{
  int degree = 0;
  for (const vtkIdType r : InTurn(this->Cells.GetNumberOfRoots()))
  {
    const Root& root = this->Cells.GetRoot(r);
    degree = std::max(degree, root.Kind < 0 ? 0 : BezierRoots::GetShape(root).Degree);
  }
  return degree;
}

bool BezierPatches::AreKnown() const
{
  return std::all_of(this->Patches.begin(), this->Patches.end(),
    [this](const Patch& patch) { return this->IsKnown(patch); });
}

std::vector<char> BezierPatches::FlagUnknown() const
{
  std::vector<char> flags;
  for (const Patch& patch : InTurn(this->Patches))
  {
    const Root& root = this->Cells.GetRoot(patch.Root);
    const bool hasChildren = root.Kind >= 0 && this->GetLevel(patch) == 0;
    flags.insert(flags.end(), hasChildren ? BezierRoots::GetShape(root).Children.size() : 1,
      this->IsKnown(patch) ? 0 : 1);
  }
  return flags;
}

/// CountFurtherSteps sees all cells that CellsToSimplices and MakeSurface read, and prevents this.
void BezierPatches::CheckSteps() const
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
void BezierPatches::ReadValues(const ValueRanges& ranges)
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
      ranges.GetTolerance(array == this->Arrays[0] ? nullptr : array->GetName(),
        ShareOfChecks * this->Options.Tolerance, array->GetDataType() == VTK_FLOAT));
  }
  this->Values = Buffer<double>(this->Components * size);
  int component = 0;
  for (vtkDataArray* array : this->Arrays)
  {
    ForEach(size, [&](vtkIdType i)
      { array->GetTuple(i, this->Values.data() + this->Components * i + component); });
    component += array->GetNumberOfComponents();
  }
}

/// Whether the polynomial of a patch is the limit at the points of one further step: the tolerance
/// of points is a distance, of arrays a difference of each component. Values that are not finite do
/// not count.
bool BezierPatches::Fits(const Patch& patch) const
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

void BezierPatches::Split(const Patch& patch, std::vector<Patch>& patches) const
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

void BezierPatches::Choose(int degree)
{
  this->Degree = degree;
  const vtkIdType size = this->Cells.GetNumberOfRoots();
  std::vector<std::vector<Patch>> patches(static_cast<std::size_t>(size));
  ForRangesOfBlocks(size,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType r = begin; r < end; ++r)
      {
        if (this->Made.empty() || this->Made[r])
        {
          this->Split({ r, 0, this->Cells.GetWhole(this->Cells.GetRoot(r)) }, patches[r]);
        }
      }
    });
  for (const auto& ofRoot : InTurn(patches))
  {
    this->Patches.insert(this->Patches.end(), ofRoot.begin(), ofRoot.end());
  }
}

void BezierPatches::GetNodes(const Patch& patch, std::vector<vtkIdType>& nodes) const
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

}
