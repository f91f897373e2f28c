// SPDX-License-Identifier: BSD-3-Clause
// A uniform subdivision of a mesh with copies of cells of other partitions: it leaves them out of
// the last step, and numbers its output as the whole does.
#include "Private/Uniform/UniformRun.h"

#include "Core/Memory/Loops.h"
#include "Private/Partitions/OtherPartitions.h"
#include "Private/Partitions/SharedSides.h"
#include "Private/Reading/UnusedPoints.h"

#include "vtkCellData.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <numeric>

namespace subdivision
{
namespace
{

/// Adds to some simplices all that share a point with them.
void AddLayer(const SimplexList& simplices, std::vector<char>& flags)
{
  std::vector<char> isAt(static_cast<std::size_t>(simplices.NumberOfPoints), 0);
  for (const bool marks : { true, false })
  {
    const vtkIdType* first = simplices.Connectivity.data();
    for (std::size_t s = 0; s < flags.size(); ++s)
    {
      const vtkIdType* last = first + simplices.Dimensions[s] + 1;
      if (marks && flags[s])
      {
        std::for_each(first, last, [&](vtkIdType point) { isAt[point] = 1; });
      }
      else if (!marks && std::any_of(first, last, [&](vtkIdType point) { return isAt[point]; }))
      {
        flags[s] = 1;
      }
      first = last;
    }
  }
}

}

/// Finds the control simplices whose children the output needs. All are made to the end with
/// limits, because a limit depends on a ring of the last level, with fields of materials, because
/// the colours of a point come from all cells at it, and where others read them.
void UniformRun::FindWanted()
{
  this->Wanted = WantedSimplices();
  if (!this->Others || this->Options.Levels == 0 || this->Options.ReadsLimit() ||
    this->Options.KeepsCopies || this->Points->HasWeights())
  {
    return;
  }
  const SimplexList& control = this->Mesh.GetControl();
  const std::vector<vtkIdType>& parents = this->Mesh.Cells.ParentCells;
  const bool arePieces = this->Mesh.MadeLevels == 0 && !parents.empty();
  std::vector<char> flags;
  vtkIdType cell = 0;
  for (const unsigned char dimension : InTurn(control.Dimensions))
  {
    flags.push_back(this->Others->IsOwn(arePieces ? parents[cell] : cell));
    cell += vtkIdType(1) << (dimension * this->Mesh.MadeLevels);
  }
  // A layer of control simplices has all of a layer of fine cells.
  for (int layer = 0; layer < this->Options.GhostLayers; ++layer)
  {
    AddLayer(control, flags);
  }
  if (std::find(flags.begin(), flags.end(), 0) != flags.end())
  {
    this->Wanted = { std::move(flags), FindUnusedPoints(this->Input) };
  }
}

/// How many cells of each dimension the current level has in the output.
std::vector<CellRun> UniformRun::CountWanted() const
{
  if (this->Wanted.IsAll() && !this->IsNarrow)
  {
    return this->Control.Runs;
  }
  std::vector<CellRun> runs(4);
  const std::vector<unsigned char>& dimensions =
    this->IsNarrow ? this->Split.Simplices.Dimensions : this->Mesh.GetControl().Dimensions;
  for (const std::size_t s : InTurn(dimensions.size()))
  {
    runs[dimensions[s]].Count += this->IsNarrow ? 1
      : this->Wanted.Flags[s] ? vtkIdType(1) << (dimensions[s] * this->Mesh.MadeLevels)
                              : 0;
  }
  for (int dimension = 0; dimension < 4; ++dimension)
  {
    runs[dimension].Dimension = dimension;
  }
  return RefineRuns(runs, 0);
}

/// Numbers control simplices by their complex: the one that was built, if it is the current level.
void UniformRun::NumberControl()
{
  if (!this->Others)
  {
    return;
  }
  const auto number = [this](const auto& complex, const std::vector<CellRun>& runs)
  {
    this->Numbers = subdivision::NumberControl(complex, runs, this->Mesh, this->Wanted, this->Input,
      this->Mesh.MadeLevels + this->Options.Levels, *this->Others);
  };
  const SimplexList& control = this->Mesh.GetControl();
  std::vector<CellRun> runs;
  if (this->Found || this->Mesh.MadeLevels > 0)
  {
    const SimplexTuples& derived =
      this->Found ? this->Found->ControlDerived : this->Control.Derived.Tuples;
    const auto complex = BuildComplex<long long>(AddTuples(control, derived), runs);
    number(complex, runs);
    return;
  }
  runs = this->Control.Runs;
  for (CellRun run : this->Control.DerivedRuns)
  {
    run.FirstCell += control.GetNumberOfSimplices();
    runs.push_back(run);
  }
  std::visit([&](const auto& level) { number(level.Complex, runs); }, this->Current);
}

/// The triangles of the current level by their numbers in the whole: the children of each control
/// triangle follow each other.
SharedKeys UniformRun::MakeTriangleKeys(vtkIdType triangles) const
{
  const int shift = 2 * this->Mesh.MadeLevels;
  SharedKeys keys;
  for (vtkIdType t = 0; t < triangles; ++t)
  {
    const vtkIdType control = this->Numbers.Numbers[2][t >> shift];
    const vtkIdType child = t & ((vtkIdType(1) << shift) - 1);
    keys.Keys.push_back(control < 0 ? -1 : (control << shift) + child);
  }
  keys.Own.assign(keys.Keys.size(), 1);
  return keys;
}

/// Finds the control triangles that are turned.
void UniformRun::FindTurned()
{
  if (!this->Options.HasFrames())
  {
    return;
  }
  if (!this->Found && this->Sides.PartOf.empty()) // LooksSmooth may have found them
  {
    this->Sides = std::visit([this](const auto& level)
      { return FindTriangleSides(level, FindSureVertices(this->Mesh.Cells, this->Others)); },
      this->Current);
  }
  const FaceSides& sides = this->Found ? this->Found->Sides : this->Sides;
  const auto triangles = static_cast<vtkIdType>(sides.PartOf.size());
  this->Turned =
    TakeParents(this->Others ? JoinSides(sides, this->MakeTriangleKeys(triangles), *this->Others)
                             : sides.ListTurned(),
      this->Mesh.MadeLevels);
}

/// Finds the part of a level `further` steps before the last that the output needs, and its runs.
template <typename Scheme>
LevelCut<Scheme> UniformRun::MakeCut(const typename Scheme::Level& level, int further)
{
  LevelCut<Scheme> cut(
    level, this->Numbers.Parts, this->Mesh.MadeLevels + this->Options.Levels - further, further);
  this->Control.Runs = cut.Cut(this->Control.Runs, this->Wanted.Flags);
  this->Control.DerivedRuns = cut.Cut(this->Control.DerivedRuns, {});
  return cut;
}

/// Leaves only the part that the output needs for the last step.
template <typename Scheme>
std::unique_ptr<LevelCut<Scheme>> UniformRun::CutOff(
  typename Scheme::Level& level, Kept<Scheme>& kept)
{
  if (this->Wanted.IsAll())
  {
    return nullptr;
  }
  auto cut = std::make_unique<LevelCut<Scheme>>(this->MakeCut<Scheme>(level, 1));
  level = cut->Cut(level);
  kept.SetColumns(cut->TakeColumns(), level.Complex.NumberOfVertices);
  kept.TakeColumns(*this->Points);
  return cut;
}

/// Takes the simplices that are not wanted out of the mesh that was read, when all is made that
/// depends on them. A kept mesh is without them already.
void UniformRun::LeaveWanted()
{
  if (this->Wanted.IsAll())
  {
    return;
  }
  const int made = this->Mesh.MadeLevels;
  const std::vector<unsigned char> dimensions = this->Mesh.GetControl().Dimensions;
  // The values of wanted simplices; each simplex has the values of its children after some levels.
  const auto pick = [&](const auto& values, int levels)
  {
    std::decay_t<decltype(values)> picked;
    auto first = values.begin();
    for (std::size_t s = 0; s < dimensions.size() && first != values.end(); ++s)
    {
      const auto last = first + (std::ptrdiff_t(1) << (dimensions[s] * levels));
      if (this->Wanted.Flags[s])
      {
        picked.insert(picked.end(), first, last);
      }
      first = last;
    }
    return picked;
  };
  std::vector<vtkIdType> simplices(dimensions.size());
  std::iota(simplices.begin(), simplices.end(), vtkIdType(0));
  simplices = pick(simplices, 0);
  SimplicesOfCells& cells = this->Mesh.Cells;
  if (cells.ParentCells.empty())
  {
    cells.ParentCells.resize(cells.Simplices.Dimensions.size());
    std::iota(cells.ParentCells.begin(), cells.ParentCells.end(), vtkIdType(0));
  }
  cells.ParentCells = pick(cells.ParentCells, made);
  cells.Simplices.Dimensions = pick(cells.Simplices.Dimensions, made);
  this->Mesh.Above.Dimensions = pick(this->Mesh.Above.Dimensions, 0);
  if (!this->Found)
  {
    this->Parents = pick(this->Parents, made + 1);
    this->Control.ManifoldDimensions =
      Selection<vtkIdType>(this->Wanted.Flags).Pick(this->Control.ManifoldDimensions);
  }
  std::vector<vtkIdType> inverted;
  for (const vtkIdType tet : InTurn(this->Mesh.Inverted))
  {
    if (this->Wanted.Flags[tet / 2])
    {
      const auto place = std::lower_bound(simplices.begin(), simplices.end(), tet / 2);
      inverted.push_back(2 * (place - simplices.begin()) + tet % 2);
    }
  }
  this->Mesh.Inverted = std::move(inverted);
}

#define SUBDIVISION_CUT_OFF(Scheme)                                                                \
  template std::unique_ptr<LevelCut<Scheme>> UniformRun::CutOff(Scheme::Level&, Kept<Scheme>&);    \
  template LevelCut<Scheme> UniformRun::MakeCut(const Scheme::Level&, int)
SUBDIVISION_FOR_VOLUME_SCHEMES(SUBDIVISION_CUT_OFF);

}
