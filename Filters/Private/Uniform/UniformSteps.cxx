// SPDX-License-Identifier: BSD-3-Clause
// The steps of a uniform subdivision: from the control level, or from kept operators, to the points
// and cells of the output.
#include "Private/Uniform/UniformRun.h"

#include "Core/Memory/Loops.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/CellArrays.h"

#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace subdivision
{
namespace
{

/// The operator of a level that stays whole, and may have sectors.
template <typename Id>
class RowsWithSectors : public LevelRows<Id>
{
public:
  template <typename Level>
  explicit RowsWithSectors(const Level& level)
    : LevelRows<Id>(level)
    , Own(MakeSectorRows(level.Strata, level.Complex.EdgeVertices))
  {
  }
  void ForEachBlock(const PointOperator::User& use) const override
  {
    LevelRows<Id>::ForEachBlock(use);
    if (!this->Own.Rows.empty())
    {
      use(WeightedRows<Id>{ 0, static_cast<vtkIdType>(this->Own.Rows.size()),
        this->Own.Offsets.data(), this->Own.Columns.data(), this->Own.Weights.data(),
        this->Own.Rows.data(), false });
    }
  }

private:
  const ExplicitRows<Id> Own;
};

}

/// Makes points and cells of the output. Returns false if Progress asks to stop.
bool UniformRun::Execute()
{
  this->PlanInterpolation();
  if (this->Found)
  {
    this->UseKept(*this->Found);
    return true;
  }
  if (this->Options.Factors)
  {
    this->ToKeep = std::make_unique<KeptOperator>();
  }
  if (this->Options.Cache)
  {
    // Rules may differ: ids of cells depend only on cells and on derived singular simplices.
    const auto& derived = this->Control.Derived.Tuples.Tuples;
    this->SameCells = this->Options.Cache->Find<KeptOperator>(
      [&](const KeptOperator& kept)
      {
        return kept.Key.HasSameCells(this->Key) &&
          std::equal(derived, derived + 3, kept.ControlDerived.Tuples) && kept.HasCells();
      });
    this->ToKeep = std::make_unique<KeptOperator>();
    this->ToKeep->Key = std::move(this->Key);
    this->ToKeep->PointsIn.TakeReference(this->Points->GetPoints()->NewInstance());
    this->ToKeep->PointsIn->DeepCopy(this->Points->GetPoints());
    this->ToKeep->PointsWeight = this->GetPointsWeight();
  }
  return std::visit(
    [this](auto& level)
    {
      using Scheme = SchemeOf<std::decay_t<decltype(level)>>;
      return this->Step<Scheme>(level, this->ToKeep.get());
    },
    this->Current);
}

/// Makes the steps. At most two levels are in memory at a time, and of the last one only the cells
/// are made, unless limits are needed. Returns false if Progress asks to stop.
template <typename Scheme>
bool UniformRun::Step(typename Scheme::Level& level, KeptOperator* keep)
{
  const int steps = this->Options.Levels;
  auto kept = std::make_unique<Kept<Scheme>>();
  if (this->Interpolates())
  {
    kept->SetControlLimit(BuildLimitRows(
      level, BuildSharpStages<Scheme>(this->Mesh, this->Options.Features, this->Control, 0)));
    this->Interpolate(kept->GetControlLimit());
  }
  this->PlanLimit<Scheme>(level, *kept);
  if (this->MakesLast && this->Options.HasFrames() && !this->IsNarrow)
  {
    const std::string tooLarge =
      this->CheckLevels(CountSimplices<Scheme>(level), sizeof(typename Scheme::Id));
    if (!tooLarge.empty() && !this->Options.NormalsWhereSmooth)
    {
      this->Options.Fail(tooLarge);
      return false;
    }
    if (!tooLarge.empty())
    {
      this->Options.GenerateLimitNormals = false;
      this->PlanLimit<Scheme>(level, *kept);
    }
  }
  if (steps > 0)
  {
    this->Parents = Scheme::FindParents(level, this->Control.Runs, this->Mesh.Cells.Simplices);
  }
  else
  {
    this->StepNever<Scheme>(level, *kept, keep);
  }
  // Whether the last two operators are stored. If not, StepTwice makes the last two steps at once,
  // row by row; it cannot where operators are kept or blended, rows depend on sectors, values are
  // divided by weights, or the last level is needed.
  const bool stored = keep || this->MakesLast || this->HasRings || steps < 2 ||
    this->Points->HasWeights() || HasEqualCells(level.Complex) || !level.Strata.Sectors.empty() ||
    IsSharpAfter(this->Control.Sharpness, steps - 2);
  LimitKinds<typename Scheme::Id> kinds;
  for (int step = 0; step < steps; ++step)
  {
    if (this->IsStopped((step + 1.) / (steps + 1.)))
    {
      return false;
    }
    if (this->IsNarrow && step > 0)
    {
      this->Narrow<Scheme>(level, step);
    }
    if (step + 2 == steps && !stored)
    {
      this->StepTwice<Scheme>(level, *kept);
      return true;
    }
    step + 1 == steps ? this->StepLast<Scheme>(level, kinds, *kept, keep != nullptr)
                      : this->StepOnce<Scheme>(level, kinds, step, keep ? kept.get() : nullptr);
  }
  if (keep && (steps > 0 || this->Options.ReadsLimit() || this->Interpolates()))
  {
    keep->Steps = std::move(kept);
  }
  return true;
}

/// The output of no step.
template <typename Scheme>
void UniformRun::StepNever(typename Scheme::Level& level, Kept<Scheme>& kept, KeptOperator* keep)
{
  this->Cells = this->SameCells
    ? this->SameCells->Cells
    : CopyCells(this->Mesh.Cells.Simplices, this->Control.Runs,
        Scheme::Traits.HasPieces ? this->Mesh.MadeLevels : -1, this->Options.Use32BitIds);
  this->GatherDerived<Scheme>(level, 0);
  this->FindLimit<Scheme>(level, kept);
  this->FinishPoints<Scheme>(kept, true);
  this->AddClassification(level.Strata.Vertices, Buffer<Stratum>());
  if (keep)
  {
    keep->ControlStrata = std::move(level.Strata.Vertices);
  }
}

/// Takes the operator out of a level, and drops the rest of the level.
template <typename Scheme>
Stencils<typename Scheme::Id> UniformRun::TakeOperator(
  typename Scheme::Level& level, int step, const LevelCut<Scheme>* cut) const
{
  Stencils<typename Scheme::Id> stencils = TakeStencils(level);
  level = typename Scheme::Level();
  if (IsSharpAfter(this->Control.Sharpness, step))
  {
    auto sharp = BuildSharpLevel<Scheme>(this->Mesh, this->Options.Features, this->Control, step);
    // Edges beyond the cut count at its vertices.
    std::vector<SharpRow> rows =
      FindSharpRows(this->Control.Sharpness, step, this->Mesh.MadeLevels + step, sharp.Complex);
    if (cut)
    {
      rows = cut->Cut(rows);
      sharp = cut->Cut(sharp);
    }
    BlendSemiSharp(rows, TakeStencils(sharp), stencils);
  }
  return stencils;
}

/// Which colours the cells at each point of the control mesh have (MaterialFields.h).
std::vector<ColourMask> UniformRun::FindControlColours() const
{
  if (!this->Points->HasWeights())
  {
    return {};
  }
  const SimplicesOfCells& cells = this->Mesh.Cells;
  vtkDataArray* colours = this->Input->GetCellData()->GetArray(ColourName);
  std::vector<vtkIdType> offsets{ 0 };
  for (const unsigned char dimension : InTurn(cells.Simplices.Dimensions))
  {
    offsets.push_back(offsets.back() + dimension + 1);
  }
  const SimplexView view = cells.GetView();
  ColourMasks masks(view.NumberOfPoints);
  masks.Add(
    view.NumberOfSimplices, [&](vtkIdType c) { return offsets[static_cast<std::size_t>(c)]; },
    [&](vtkIdType i) { return view.Connectivity[i]; },
    [&](vtkIdType c)
    {
      return static_cast<int>(
        colours->GetComponent(cells.ParentCells.empty() ? c : cells.ParentCells[c], 0));
    });
  return masks.Get();
}

/// The same after the step of a level, the first of which is step 0.
template <typename Scheme>
std::vector<ColourMask> UniformRun::FindColours(const typename Scheme::Level& level, int step) const
{
  if (!this->Points->HasWeights())
  {
    return {};
  }
  const UniformCells children = MakeChildren<Scheme>(level, this->Control.Runs, 1, nullptr, true);
  const vtkSmartPointer<vtkAbstractArray> spread =
    SpreadToChildren(this->Input->GetCellData()->GetArray(ColourName), this->Mesh.Cells, step + 1);
  auto* colours = vtkIntArray::SafeDownCast(spread);
  ColourMasks masks(LevelRows<typename Scheme::Id>(level).GetNumberOfRows());
  masks.Add(children.Cells, [&](vtkIdType c) { return colours->GetValue(c); });
  return masks.Get();
}

/// A step that is not the last one. `kept` is null where operators are not kept.
template <typename Scheme>
void UniformRun::StepOnce(typename Scheme::Level& level, LimitKinds<typename Scheme::Id>& kinds,
  int step, Kept<Scheme>* kept)
{
  const bool further = this->MakesLast || this->HasRings || step + 2 < this->Options.Levels;
  std::vector<ColourMask> colours = this->FindColours<Scheme>(level, step);
  typename Scheme::Level next = Refine(level, further ? Depth::ForRefinement : Depth::ForOutput);
  if (this->HasRings && HasSolids(next))
  {
    kinds.Refine(level);
    if (step == 0)
    {
      kinds.FindOwn(next);
    }
  }
  this->Control.Runs = RefineRuns(this->Control.Runs, 1);
  this->Control.DerivedRuns = RefineRuns(this->Control.DerivedRuns, 1);
  Stencils<typename Scheme::Id> stencils = this->TakeOperator<Scheme>(level, step);
  level = std::move(next);
  this->Points->Advance(stencils);
  this->Points->KeepColours(colours);
  if (kept)
  {
    kept->Add(std::move(stencils), std::move(colours));
  }
}

/// The last step. Cells are made first, and pieces are chosen in a second pass over the cells:
/// cells that are kept must not depend on points, and points may still go to the limit.
template <typename Scheme>
void UniformRun::StepLast(typename Scheme::Level& level,
  const LimitKinds<typename Scheme::Id>& kinds, Kept<Scheme>& kept, bool keeps)
{
  const int step = this->Options.Levels - 1;
  const std::unique_ptr<LevelCut<Scheme>> cut = this->CutOff<Scheme>(level, kept);
  this->GatherDerived<Scheme>(level, 1);
  if (Scheme::Traits.HasPieces && !keeps && !this->MakesLast && !this->HasRings &&
    level.Strata.Sectors.empty() && !IsSharpAfter(this->Control.Sharpness, step))
  {
    this->StepLastInPieces<Scheme>(level, kept);
    return;
  }
  this->MakeCells<Scheme>(level, 1, nullptr);
  if (this->HasRings)
  {
    const BlockOperator<typename Scheme::Id> limits = FindNextLimits(level, kinds);
    if (!keeps && !IsSharpAfter(this->Control.Sharpness, step))
    {
      this->Points->Advance(RowsWithSectors<typename Scheme::Id>(level));
      this->FinishPoints<Scheme>(kept, !this->SameCells, &limits);
      this->AddClassification(level.Strata.Vertices, level.Strata.Edges);
      return;
    }
    kept.GetLimit().Rows = limits.Store();
  }
  typename Scheme::Level next;
  std::vector<ColourMask> colours;
  if (this->MakesLast)
  {
    colours = this->FindColours<Scheme>(level, step);
    next = Refine(level, Depth::ForRefinement);
  }
  Stencils<typename Scheme::Id> stencils = this->TakeOperator<Scheme>(level, step, cut.get());
  level = std::move(next);
  this->Points->Advance(stencils);
  this->Points->KeepColours(colours);
  this->FindLimit<Scheme>(level, kept);
  this->FinishPoints<Scheme>(kept, !this->SameCells);
  this->AddClassification(stencils.Vertices, stencils.Edges);
  if (keeps)
  {
    kept.Add(std::move(stencils), std::move(colours));
  }
}

/// The last step of a scheme with pieces, with cells after points: one pass over the cells. The
/// level stays whole for them.
template <typename Scheme>
void UniformRun::StepLastInPieces(const typename Scheme::Level& level, Kept<Scheme>& kept)
{
  this->Points->Advance(LevelRows<typename Scheme::Id>(level));
  this->MakeCells<Scheme>(level, 1, this->Points->GetPoints());
  this->FinishPoints<Scheme>(kept, true);
  this->AddClassification(level.Strata.Vertices, level.Strata.Edges);
}

/// The last two steps without the level between them. Of the last one only rows that the output
/// needs are made.
template <typename Scheme>
void UniformRun::StepTwice(const typename Scheme::Level& level, Kept<Scheme>& kept)
{
  this->Points->Advance(LevelRows<typename Scheme::Id>(level));
  if (this->Wanted.IsAll())
  {
    this->StepTwice<Scheme>(level, typename Scheme::ChildRows(level), nullptr, kept);
    return;
  }
  const LevelCut<Scheme> cut = this->MakeCut<Scheme>(level, 2);
  const typename Scheme::Level part = cut.Cut(level);
  const auto children = cut.SelectChildren(part);
  this->StepTwice<Scheme>(part, typename Scheme::ChildRows(level, &children), &cut, kept);
}

/// Makes the last step of these rows, and the cells of a level two steps before, which is the part
/// of `cut` unless that is null.
template <typename Scheme>
void UniformRun::StepTwice(const typename Scheme::Level& level,
  const typename Scheme::ChildRows& last, const LevelCut<Scheme>* cut, Kept<Scheme>& kept)
{
  this->GatherDerived<Scheme>(level, 2);
  this->Points->Advance(last);
  if (cut)
  {
    this->Points->Renumber(
      [cut](vtkIdType point) { return cut->GetVertex(point); }, cut->GetNumberOfVertices());
  }
  this->MakeCells<Scheme>(level, 2, this->Points->GetPoints());
  this->FinishPoints<Scheme>(kept, true);
  if (this->Options.GenerateClassification)
  {
    this->AddClassificationOf(last);
  }
}

template <typename Rows>
void UniformRun::AddClassificationOf(const Rows& last)
{
  Buffer<Stratum> vertices(last.GetNumberOfVertices());
  Buffer<Stratum> edges(last.GetNumberOfEdges());
  last.ForRows(
    [&](const auto& rows)
    {
      if (rows.Strata) // rows of centres have none
      {
        std::copy_n(rows.Strata, rows.Count,
          rows.OfEdges ? edges.data() + (rows.FirstRow - vertices.size())
                       : vertices.data() + rows.FirstRow);
      }
    });
  this->AddClassification(vertices, edges);
}

/// Finds how normals, tangents and limits are computed, if the last level is not needed for them.
/// Else that level is made.
template <typename Scheme>
void UniformRun::PlanLimit(const typename Scheme::Level& level, Kept<Scheme>& kept)
{
  LimitOperators<typename Scheme::Id>& limit = kept.GetLimit();
  limit.HasNormals = this->Options.GenerateLimitNormals;
  limit.HasTangents = this->Options.GenerateTangents;
  const int steps = this->Options.Levels;
  const bool needsRows =
    this->Options.ProjectToLimit && this->Options.Scheme != StampScheme::Linear;
  this->HasRings = this->ReadsRings(HasSolids(level));
  this->HasFrames = this->Options.HasFrames() && (this->HasRings || !needsRows) &&
    !IsSharpAfter(this->Control.Sharpness, steps) &&
    limit.FindFrames(level, { this->Control.Solids, this->Mesh.MadeLevels }, steps);
  this->MakesLast =
    (needsRows && !this->HasRings) || (this->Options.HasFrames() && !this->HasFrames);
  this->HasRings = this->HasRings && !this->MakesLast;
}

/// Finds what is missing in the operators that follow the last step, by its level.
template <typename Scheme>
void UniformRun::FindLimit(const typename Scheme::Level& level, Kept<Scheme>& kept) const
{
  if (!this->MakesLast)
  {
    return;
  }
  const auto creases = BuildSharpStages<Scheme>(
    this->Mesh, this->Options.Features, this->Control, this->Options.Levels);
  if (this->Options.ProjectToLimit && this->Options.Scheme != StampScheme::Linear)
  {
    kept.GetLimit().Rows = BuildLimitRows(level, creases);
  }
  if (this->Options.HasFrames() && !this->HasFrames)
  {
    kept.GetLimit().FindFrames(
      level, creases, { this->Control.Solids, this->Mesh.MadeLevels + this->Options.Levels });
  }
}

/// Makes the cells of the output. `points` are points of the output, or null where they are not
/// known yet; then pieces are chosen later.
template <typename Scheme>
void UniformRun::MakeCells(const typename Scheme::Level& level, int steps, vtkDataArray* points)
{
  this->Cells = this->SameCells
    ? this->SameCells->Cells
    : MakeChildren<Scheme>(level, this->Control.Runs, steps, points, this->Options.Use32BitIds);
  this->HasTurned = points != nullptr;
}

template <typename Scheme>
void UniformRun::GatherDerived(const typename Scheme::Level& level, int steps)
{
  this->Derived.Tuples =
    GatherTuples(level.Complex, this->Control.DerivedRuns, steps, Scheme::CountCentres(level));
  this->LowerSharpness();
}

template <typename Scheme>
void UniformRun::FinishPoints(
  Kept<Scheme>& kept, bool ownsCells, const BlockOperator<typename Scheme::Id>* limits)
{
  kept.GetLimit().Apply(*this->Points, this->Mesh.Inverted, this->Turned);
  if (limits)
  {
    this->Points->Project(*limits);
  }
  this->FinishPoints(ownsCells);
}

/// Writes points, point data and cells. `ownsCells`: no other output has these cells.
void UniformRun::FinishPoints(bool ownsCells)
{
  this->Points->Finish(this->Output);
  if (this->Cells.Octahedra && this->Options.Levels > 0 && !this->HasTurned)
  {
    TurnOctahedra(this->Cells, !ownsCells, this->Output->GetPoints()->GetData());
  }
  this->Output->SetCells(this->Cells.Types, this->Cells.Cells);
}

}
