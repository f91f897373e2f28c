// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BezierPatches.h
 * Which parts of cells become Bezier cells: as few as the tolerance allows.
 */
#ifndef SubdivisionObjects_BezierPatches_h
#define SubdivisionObjects_BezierPatches_h

#include "Core/Memory/Buffer.h"
#include "Private/Bezier/BezierCells.h"
#include "Private/Bezier/BezierRoots.h"

#include "vtkPointSet.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkDataArray;

namespace subdivision
{

class ValueRanges;

/// A part of a root that becomes one cell.
struct Patch
{
  vtkIdType Root;
  int Level;
  LatticePart Part;
};

/// The patches of a mesh on the limit.
class BezierPatches
{
public:
  /// `made`: which roots have patches; empty: all.
  BezierPatches(vtkPointSet* mesh, const ValueRanges& ranges, const BezierOptions& options,
    const std::vector<char>& made);
  /// The largest degree that a root needs.
  int FindDegree() const;
  /// Chooses the patches, and gives them one degree.
  void Choose(int degree);
  const std::vector<Patch>& Get() const { return this->Patches; }
  /// Whether no further step is needed to see that the patch fits.
  bool IsKnown(const Patch& patch) const
  {
    const Root& root = this->Cells.GetRoot(patch.Root);
    return root.Kind < 0 || patch.Level < root.Levels;
  }
  bool AreKnown() const;
  /// Flags the cells of the first level that a further step has to look at (CellSplits.h).
  std::vector<char> FlagUnknown() const;

  vtkPointSet* GetMesh() const { return this->Mesh; }
  const BezierRoots& GetCells() const { return this->Cells; }
  /// The fitted arrays, points first; and the values of each point, one array after the other.
  const std::vector<vtkDataArray*>& GetArrays() const { return this->Arrays; }
  int GetNumberOfComponents() const { return this->Components; }
  const double* GetValues(vtkIdType point) const
  {
    return this->Values.data() + this->Components * point;
  }
  const PatchShape& GetShape(const Root& root) const
  {
    return PatchShape::Get(static_cast<PatchShape::Kind>(root.Kind), this->Degree);
  }
  /// The points of the mesh that are the nodes of a patch, or the points of a cell that is written
  /// as it is.
  void GetNodes(const Patch& patch, std::vector<vtkIdType>& nodes) const;
  /// The lattices of patches of one number have the same points on edges and faces that they share:
  /// steps that a root lacks count as levels.
  int GetLevel(const Patch& patch) const
  {
    const Root& root = this->Cells.GetRoot(patch.Root);
    return root.Kind < 0 ? 0 : patch.Level + this->Options.Steps - root.Steps;
  }

private:
  void CheckSteps() const;
  void ReadValues(const ValueRanges& ranges);
  void Split(const Patch& patch, std::vector<Patch>& patches) const;
  bool Fits(const Patch& patch) const;

  const vtkSmartPointer<vtkPointSet> Mesh;
  const BezierOptions Options;
  const std::vector<char> Made;
  const BezierRoots Cells;
  std::vector<vtkDataArray*> Arrays;
  int Degree = 0;
  int Components = 0;
  Buffer<double> Values;
  std::vector<double> Allowed; ///< the tolerance of each component
  std::vector<Patch> Patches;
};

}

#endif
