// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BezierPatches.h
 * Which parts of cells become Bezier cells: as few as the tolerance allows.
 */
#ifndef SubdivisionObjects_BezierPatches_h
#define SubdivisionObjects_BezierPatches_h

#include "Core/Memory/Buffer.h"
#include "Core/Memory/Loops.h"
#include "Private/Bezier/BezierCells.h"
#include "Private/Bezier/PatchShape.h"
#include "Private/Bezier/ValueRanges.h"
#include "Private/Roots/SplitRoots.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace subdivision
{

/// A part of a root that becomes one cell.
struct Patch
{
  vtkIdType Root;
  int Level;
  LatticePart Part;
};

/// The share of the tolerance for checked points: the largest error lies between them.
constexpr double ShareOfChecks = 2. / 3.;

inline const PatchShape& GetPatchShape(const Root& root)
{
  return PatchShape::Get(PatchShape::FindKind(root.Shape));
}
inline LatticePart GetWhole(const Root& root)
{
  LatticePart whole;
  for (int axis = 0; root.Lattice && axis < GetPatchShape(root).Dimension; ++axis)
  {
    whole.Axes[axis][axis] = 1 << root.Steps;
  }
  return whole;
}

inline vtkSmartPointer<vtkPointSet> CopyMesh(vtkPointSet* mesh)
{
  auto copy = vtkSmartPointer<vtkPointSet>::Take(mesh->NewInstance());
  copy->ShallowCopy(mesh);
  return copy;
}

/// The patches of a mesh on the limit.
class BezierPatches
{
public:
  /// `made`: which roots have patches; empty: all.
  BezierPatches(vtkPointSet* mesh, const ValueRanges& ranges, const BezierOptions& options,
    const std::vector<char>& made)
    : Mesh(CopyMesh(mesh))
    , Options(options)
    , Made(made)
    , Cells(this->Mesh, options.Steps, [this](const Root& root) { return this->IsPatch(root); })
  {
    this->CheckSteps();
    this->ReadValues(ranges);
  }
  /// The largest degree that a root needs.
  int FindDegree() const
  {
    int degree = 0;
    for (const vtkIdType r : InTurn(this->Cells.GetNumberOfRoots()))
    {
      const Root& root = this->Cells.GetRoot(r);
      degree = std::max(degree, root.Lattice ? GetPatchShape(root).Degree : 0);
    }
    return degree;
  }
  /// Chooses the patches, and gives them one degree.
  void Choose(int degree)
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
            this->Split({ r, 0, GetWhole(this->Cells.GetRoot(r)) }, patches[r]);
          }
        }
      });
    for (const auto& ofRoot : InTurn(patches))
    {
      this->Patches.insert(this->Patches.end(), ofRoot.begin(), ofRoot.end());
    }
  }

  const std::vector<Patch>& Get() const { return this->Patches; }
  /// Whether no further step is needed to see that the patch fits.
  bool IsKnown(const Patch& patch) const
  {
    const Root& root = this->Cells.GetRoot(patch.Root);
    return !root.Lattice || patch.Level < this->CountLevels(root);
  }
  bool AreKnown() const
  {
    return std::all_of(this->Patches.begin(), this->Patches.end(),
      [this](const Patch& patch) { return this->IsKnown(patch); });
  }
  /// Flags the cells of the first level that a further step has to look at (CellSplits.h).
  std::vector<char> FlagUnknown() const
  {
    std::vector<char> flags;
    for (const Patch& patch : InTurn(this->Patches))
    {
      const Root& root = this->Cells.GetRoot(patch.Root);
      const bool hasChildren = root.Lattice && this->GetLevel(patch) == 0;
      flags.insert(flags.end(), hasChildren ? GetPatchShape(root).Children.size() : 1,
        this->IsKnown(patch) ? 0 : 1);
    }
    return flags;
  }

  vtkPointSet* GetMesh() const { return this->Mesh; }
  const SplitRoots& GetCells() const { return this->Cells; }
  /// The fitted arrays, points first; and the values of each point, one array after the other.
  const std::vector<vtkDataArray*>& GetArrays() const { return this->Arrays; }
  int GetNumberOfComponents() const { return this->Components; }
  const double* GetValues(vtkIdType point) const
  {
    return this->Values.data() + this->Components * point;
  }
  const PatchShape& GetShape(const Root& root) const
  {
    return PatchShape::Get(PatchShape::FindKind(root.Shape), this->Degree);
  }
  /// The points of the mesh that are the nodes of a patch, or the points of a cell that is written
  /// as it is.
  void GetNodes(const Patch& patch, std::vector<vtkIdType>& nodes) const
  {
    const Root& root = this->Cells.GetRoot(patch.Root);
    nodes.clear();
    if (!root.Lattice)
    {
      const CellIds cell = this->Cells.GetPoints(root);
      nodes.assign(cell.Ids, cell.Ids + cell.Size);
      return;
    }
    const PatchShape& shape = this->GetShape(root);
    for (const FrameNode& node : shape.Nodes)
    {
      nodes.push_back(this->Cells.GetPoint(root, patch.Part.At(node, shape.Divisions)));
    }
  }

  /// The lattices of patches of one number have the same points on edges and faces that they share:
  /// steps that a root lacks count as levels.
  int GetLevel(const Patch& patch) const
  {
    const Root& root = this->Cells.GetRoot(patch.Root);
    return root.Lattice ? patch.Level + this->Options.Steps - root.Steps : 0;
  }

private:
  /// How often a root may be split. The steps beyond these give the points that a patch needs.
  int CountLevels(const Root& root) const
  {
    return std::max(0, this->Options.Levels - (this->Options.Steps - root.Steps));
  }
  /// The cells of a root with too few points stay as they are.
  bool IsPatch(const Root& root)
  {
    const bool isKind = root.Shape >= CellShape::Line && root.Shape <= CellShape::Tet;
    const bool hasPoints =
      isKind && root.Steps - this->CountLevels(root) >= GetPatchShape(root).SampleLevels;
    if (isKind && !hasPoints && this->FirstWithoutPoints < 0)
    {
      this->FirstWithoutPoints = root.First;
    }
    return hasPoints && root.Order == SplitOrder::Simplices;
  }
  /// CountFurtherSteps sees all cells that CellsToSimplices and MakeSurface read, and prevents
  /// this.
  void CheckSteps() const
  {
    const vtkIdType cell = this->FirstWithoutPoints;
    if (cell >= 0)
    {
      this->Options.Fail("Cell " + std::to_string(cell) + " after " +
        std::to_string(this->Options.Steps) + " steps, of type " +
        std::to_string(this->Mesh->GetCellType(cell)) +
        ", was split too seldom for a Bezier cell: it and others of its kind stay linear. This is "
        "a fault of the filter, not of the input: report it, and set OutputCells to Linear.");
    }
  }
  /// Points and arrays of floating point numbers, in double, side by side.
  void ReadValues(const ValueRanges& ranges)
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
  void Split(const Patch& patch, std::vector<Patch>& patches) const
  {
    const Root& root = this->Cells.GetRoot(patch.Root);
    if (!root.Lattice || patch.Level == this->CountLevels(root) || this->Fits(patch))
    {
      patches.push_back(patch);
      return;
    }
    Patch child = patch;
    ++child.Level;
    for (const LatticePart& part : GetPatchShape(root).Children)
    {
      child.Part = patch.Part.Take(part);
      this->Split(child, patches);
    }
  }

  /// Whether the polynomial of a patch is the limit at the points of one further step: the
  /// tolerance of points is a distance, of arrays a difference of each component. Values that are
  /// not finite do not count.
  bool Fits(const Patch& patch) const
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

  const vtkSmartPointer<vtkPointSet> Mesh;
  const BezierOptions Options;
  const std::vector<char> Made;
  vtkIdType FirstWithoutPoints = -1;
  const SplitRoots Cells;
  std::vector<vtkDataArray*> Arrays;
  int Degree = 0;
  int Components = 0;
  Buffer<double> Values;
  std::vector<double> Allowed; ///< the tolerance of each component
  std::vector<Patch> Patches;
};

}

#endif
