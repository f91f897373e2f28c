// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Uniform/UniformRun.h"

#include "Core/Solids/Complex/TetOrder.h"
#include "Core/Solids/TetOct/TetOctCells.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/Arrays.h"
#include "Private/Arrays/CellArrays.h"
#include "Private/Control/SizeChecks.h"
#include "Private/Reading/SolidOrientation.h"
#include "Private/Uniform/Classification.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

namespace subdivision
{
namespace
{

constexpr const char* DimensionName = "ManifoldDimension";
constexpr const char* InvertedName = "Inverted";

template <typename Id>
LevelCounts CountSimplices(const Level<Id>& level)
{
  return subdivision::CountSimplices(level.Complex);
}

}

bool UniformRun::Run()
{
  if (!this->Plan() || !this->Execute())
  {
    return false;
  }
  this->Write();
  this->Keep();
  return true;
}

// ------------------------------------------------------------------------------------------------
// Planning

/// Reads the input, decides whether its stamp is true, and checks sizes. Tells the warnings of all
/// that. Returns false after an error.
bool UniformRun::Plan()
{
  this->Read(true);
  const std::string tooMany = CheckNumberOfCells(
    this->Mesh.Cells.Simplices, this->Options.Levels, this->Options.MaximumNumberOfCells);
  if (!tooMany.empty())
  {
    Tell(this->Mesh.Warnings, this->Options);
    this->Options.Fail(tooMany);
    return false;
  }
  this->StartPoints();
  if (!this->FindKeptOrBuild()) // the stamp is wrong
  {
    this->Read(false);
    this->StartPoints();
    this->FindKeptOrBuild();
  }
  Tell(this->Mesh.Warnings, this->Options);
  for (const std::string& warning : this->Found ? this->Found->Warnings : this->BuildWarnings)
  {
    this->Options.Warn(warning);
  }
  return this->Found ||
    std::visit([this](const auto& level)
      { return this->HasMemoryFor(CountSimplices(level), sizeof(level.Complex.NumberOfVertices)); },
      this->Current);
}

/// Reads the control mesh.
void UniformRun::Read(bool trustStamp)
{
  this->Mesh =
    ReadControlMesh(this->Input, trustStamp, this->Options.Features, this->Options.Scheme);
  if (this->Mesh.IsOfOtherScheme)
  {
    this->Mesh.Warnings.emplace_back(
      "An earlier filter made the input with another VolumeScheme. This filter takes it as any "
      "other mesh: it looks for features again, and octahedra are four tetrahedra each.");
  }
}

/// Starts points and arrays, and does what needs coordinates of the control mesh.
void UniformRun::StartPoints()
{
  PointArrayOptions arrays;
  arrays.InterpolateIntegers = this->Options.InterpolateIntegers;
  arrays.CarryOriginalIds = this->Mesh.IsStamped &&
    HasIds(this->Input->GetPointData(), OriginalPointIdsName, this->Input->GetNumberOfPoints());
  arrays.OriginalIds = this->Options.GenerateOriginalIds || arrays.CarryOriginalIds;
  arrays.Warn = [this](const std::string& warning) { this->Mesh.Warnings.push_back(warning); };
  arrays.Precision = this->Options.OutputPointsPrecision;
  if (arrays.OriginalIds)
  {
    arrays.Replaced.emplace_back(OriginalPointIdsName);
  }
  if (this->Options.GenerateLimitNormals)
  {
    arrays.Replaced.emplace_back(LimitNormalsName);
  }
  if (this->Options.GenerateClassification)
  {
    arrays.Replaced.insert(arrays.Replaced.end(), { RuleName, TypeName });
  }
  this->Points = std::make_unique<PointArrays>(this->Input, this->Mesh.Cells,
    this->Mesh.GetGlobalIds(), static_cast<vtkIdType>(this->Mesh.GlobalIds.size()), arrays);
  if (this->Mesh.MadeLevels == 0)
  {
    this->Mesh.Inverted =
      FindInvertedTets(this->Mesh.Cells.Simplices, this->Points->GetCoordinates());
  }
  if (!this->Mesh.IsStamped && !this->IsTetOct()) // the tet/oct scheme does not use this order
  {
    OrderTets(this->Mesh.Cells.Simplices, this->Points->GetCoordinates(), this->Mesh.GetGlobalIds(),
      static_cast<vtkIdType>(this->Mesh.GlobalIds.size()));
  }
}

/// Finds what was kept for this mesh, or builds the current level. Returns false if the stamp is
/// wrong.
bool UniformRun::FindKeptOrBuild()
{
  if (this->Options.Cache)
  {
    this->Key = this->MakeKey();
    this->Found = this->FindKept(this->Key);
  }
  return this->Found || this->Build();
}

bool UniformRun::Build()
{
  const int levels = this->Options.Levels + (this->Options.ReadsLimit() ? 1 : 0);
  const bool large =
    NeedsLargeIds(this->Mesh.GetControl(), this->Mesh.MadeLevels + levels, this->IsTetOct());
  if (this->IsTetOct())
  {
    return large ? this->BuildLevel<TetOctLevel, long long>()
                 : this->BuildLevel<TetOctLevel, int>();
  }
  return large ? this->BuildLevel<Level, long long>() : this->BuildLevel<Level, int>();
}

template <template <typename> class AnyLevel, typename Id>
bool UniformRun::BuildLevel()
{
  ControlComplex<Id> control;
  const bool further = this->Options.Levels > 1 || this->Options.ReadsLimit();
  const bool isTrue = BuildControlComplex(
    this->Mesh, this->Options.Features, this->Points->GetCoordinates(),
    [this](const std::string& warning) { this->BuildWarnings.push_back(warning); },
    further ? Depth::ForRefinement : Depth::ForOutput, control,
    this->Current.emplace<AnyLevel<Id>>());
  this->Control = std::move(static_cast<ControlTraits&>(control));
  return isTrue;
}

bool UniformRun::HasMemoryFor(const LevelCounts& counts, double bytesPerId) const
{
  SizeEstimate estimate;
  estimate.Control = counts;
  estimate.Levels = this->Options.Levels;
  estimate.Runs = this->Control.Runs;
  estimate.BytesPerPoint = this->Points->GetBytesPerPoint();
  estimate.BytesPerCell = GetBytesPerTuple(this->Input->GetCellData());
  estimate.BytesPerId = bytesPerId;
  estimate.Projects = this->Options.ReadsLimit();
  const std::string tooLarge = CheckMemory(estimate);
  if (!tooLarge.empty())
  {
    this->Options.Fail(tooLarge);
  }
  return tooLarge.empty();
}

// ------------------------------------------------------------------------------------------------
// Execution

/// Makes points and cells of the output. Returns false if Progress asks to stop.
bool UniformRun::Execute()
{
  if (this->Found)
  {
    this->UseKept(*this->Found);
    return true;
  }
  if (this->Options.Cache)
  {
    this->SameCells = this->Options.Cache->FindCells(this->Key, this->Control.Derived);
    this->ToKeep = std::make_unique<KeptOperator>();
    this->ToKeep->Key = std::move(this->Key);
    this->ToKeep->PointsIn.TakeReference(this->Points->GetPoints()->NewInstance());
    this->ToKeep->PointsIn->DeepCopy(this->Points->GetPoints());
  }
  return std::visit(
    [this](auto& level) { return this->Step(level, this->ToKeep.get()); }, this->Current);
}

/// Makes the steps. At most two levels are in memory at a time, and of the last one only the cells
/// are made, unless limits are needed. Returns false if Progress asks to stop.
template <template <typename> class AnyLevel, typename Id>
bool UniformRun::Step(AnyLevel<Id>& level, KeptOperator* keep)
{
  using Operator = decltype(TakeStencils(level));
  const int steps = this->Options.Levels;
  auto kept = std::make_unique<KeptStepsOf<Operator, Id>>();
  if (steps == 0)
  {
    this->Cells = this->SameCells
      ? this->SameCells->Cells
      : CopyCells(this->Mesh.Cells.Simplices, this->Control.Runs,
          this->IsTetOct() ? this->Mesh.MadeLevels : -1, this->Options.Use32BitIds);
    this->Derived = GatherTuples(level.Complex, this->Control.DerivedRuns, 0);
    this->GoToLimit(level, *kept);
    this->FinishPoints(true);
    this->AddClassification(level.Strata.Vertices, Buffer<Stratum>());
    if (keep)
    {
      keep->ControlStrata = std::move(level.Strata.Vertices);
      if (this->Options.ReadsLimit())
      {
        keep->Steps = std::move(kept);
      }
    }
    return true;
  }
  this->PartOctahedra(level);
  // Whether the last two operators are stored. If not, StepTwice makes the last two steps at once,
  // row by row; it cannot where operators are kept or blended, or the last level is needed.
  const bool stored = keep || this->Options.ReadsLimit() || steps < 2 ||
    HasEqualCells(level.Complex) || IsSharpAfter(this->Control.Sharpness, steps - 2);
  // Whether octahedra are cut around their shortest diagonals when they are written. Kept cells are
  // written before the points are known, and octahedra are turned afterwards in each execution; so
  // are those whose points still move to the limit.
  const bool turned = this->IsTetOct() && !keep && !this->Options.ReadsLimit();
  for (int step = 0; step < steps; ++step)
  {
    if (this->IsStopped((step + 1.) / (steps + 1.)))
    {
      return false;
    }
    if (step + 2 == steps && !stored)
    {
      this->StepTwice(level);
      return true;
    }
    const bool last = step + 1 == steps;
    AnyLevel<Id> next;
    if (last)
    {
      if (!turned)
      {
        this->MakeCells(level, 1);
      }
      this->Derived = GatherTuples(level.Complex, this->Control.DerivedRuns, 1);
    }
    if (this->Options.ReadsLimit())
    {
      next = Refine(level, Depth::ForRefinement);
    }
    else if (!last)
    {
      next = Refine(level, step + 2 == steps ? Depth::ForOutput : Depth::ForRefinement);
    }
    if (!last)
    {
      this->Control.Runs = RefineRuns(this->Control.Runs, 1);
      this->Control.DerivedRuns = RefineRuns(this->Control.DerivedRuns, 1);
    }
    Operator stencils = TakeStencils(level);
    AnyLevel<Id> parent = std::move(level);
    level = std::move(next);
    if (!last || !turned)
    {
      parent = AnyLevel<Id>();
    }
    if (IsSharpAfter(this->Control.Sharpness, step))
    {
      auto sharp =
        BuildSharpLevel<AnyLevel, Id>(this->Mesh, this->Options.Features, this->Control, step);
      BlendSemiSharp(
        this->Control.Sharpness, step, this->Mesh.MadeLevels + step, TakeStencils(sharp), stencils);
    }
    this->Points->Advance(stencils);
    if (last && turned)
    {
      this->MakeTurnedCells(parent, stencils);
    }
    if (last)
    {
      this->GoToLimit(level, *kept);
      this->FinishPoints(!this->SameCells);
      this->AddClassification(stencils.Vertices, stencils.Edges);
    }
    if (keep)
    {
      kept->Add(std::move(stencils));
    }
  }
  if (keep)
  {
    keep->Steps = std::move(kept);
  }
  return true;
}

/// The last two steps without the level between them.
template <typename Id>
void UniformRun::StepTwice(const Level<Id>& level)
{
  this->MakeCells(level, 2);
  this->Derived = GatherTuples(level.Complex, this->Control.DerivedRuns, 2);
  this->Points->Advance(LevelRows<Id>(level));
  const ChildRows<Id> last(level);
  this->Points->Advance(last);
  this->FinishTwoSteps(last);
}
template <typename Id>
void UniformRun::StepTwice(const TetOctLevel<Id>& level)
{
  this->Derived =
    GatherTuples(level.Complex, this->Control.DerivedRuns, 2, level.NumberOfOctahedra);
  this->Points->Advance(TetOctLevelRows<Id>(level));
  const TetOctChildRows<Id> last(level);
  this->Points->Advance(last);
  this->Cells = MakeChildren(
    level, this->Control.Runs, 2, this->Points->GetPoints(), this->Options.Use32BitIds);
  this->HasTurned = true;
  this->FinishTwoSteps(last);
}

template <typename Rows>
void UniformRun::FinishTwoSteps(const Rows& last)
{
  this->FinishPoints(true);
  if (!this->Options.GenerateClassification)
  {
    return;
  }
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

/// Moves the vertices of the last level to their limits, and computes normals.
template <template <typename> class AnyLevel, typename Id, typename Kept>
void UniformRun::GoToLimit(const AnyLevel<Id>& level, Kept& kept)
{
  if (this->Options.ReadsLimit())
  {
    LimitOperators<Id> limit(level,
      BuildSharpStages<AnyLevel, Id>(
        this->Mesh, this->Options.Features, this->Control, this->Options.Levels),
      { this->Control.Solids, this->Mesh.MadeLevels + this->Options.Levels },
      this->Options.ProjectToLimit, this->Options.GenerateLimitNormals);
    limit.Apply(*this->Points, this->Mesh.Inverted);
    kept.SetLimit(std::move(limit));
  }
}

// ------------------------------------------------------------------------------------------------
// Output

/// Makes the cells of the output before the points are known. Octahedra are turned later.
template <typename Id>
void UniformRun::MakeCells(const Level<Id>& level, int steps)
{
  this->Cells = this->SameCells
    ? this->SameCells->Cells
    : MakeChildren(level, this->Control.Runs, steps, this->Options.Use32BitIds);
}
template <typename Id>
void UniformRun::MakeCells(const TetOctLevel<Id>& level, int)
{
  this->Cells = this->SameCells
    ? this->SameCells->Cells
    : MakeChildren(level, this->Control.Runs, 1, nullptr, this->Options.Use32BitIds);
}

/// The same when the points are known, in one pass over the cells instead of two. The operator
/// gives back the arrays that it took from the level.
template <typename Id>
void UniformRun::MakeTurnedCells(TetOctLevel<Id>& level, TetOctStencils<Id>& stencils)
{
  level.OctVertices = std::move(stencils.OctVertices);
  level.Complex.EdgeVertices = std::move(stencils.EdgeVertices);
  this->Cells = MakeChildren(
    level, this->Control.Runs, 1, this->Points->GetPoints(), this->Options.Use32BitIds);
  this->HasTurned = true;
}

template <typename Id>
void UniformRun::PartOctahedra(const TetOctLevel<Id>& level)
{
  if (level.Steps > 0)
  {
    this->Parents = FindParents(level, this->Control.Runs, this->Mesh.Cells.Simplices);
  }
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

/// Writes cell data, ghost types and the stamp.
void UniformRun::Write()
{
  CellArrayOptions cells;
  cells.Levels = this->Options.Levels;
  cells.OriginalIds = this->Options.GenerateOriginalIds;
  cells.CarryOriginalIds = this->Mesh.IsStamped &&
    HasIds(this->Input->GetCellData(), OriginalCellIdsName, this->Input->GetNumberOfCells());
  if (cells.OriginalIds && !cells.CarryOriginalIds)
  {
    cells.Replaced.emplace_back(OriginalCellIdsName);
  }
  if (this->Cells.Octahedra)
  {
    cells.Replaced.emplace_back(this->Cells.Octahedra->GetName());
  }
  cells.Warn = this->Options.Warn;
  if (this->Options.GenerateClassification)
  {
    cells.Replaced.emplace_back(DimensionName);
    cells.Replaced.emplace_back(InvertedName);
  }
  CopyCellArrays(this->Input, this->Mesh.Cells, this->Parents, cells, this->Output);
  if (this->Cells.Octahedra)
  {
    AddInstead(this->Input->GetCellData(), this->Cells.Octahedra, this->Output->GetCellData());
  }
  if (this->Options.GenerateClassification)
  {
    AddValuesOfSimplices(this->Control.ManifoldDimensions.data(), this->Mesh.GetControl(),
      this->Mesh.MadeLevels + this->Options.Levels, DimensionName, this->Input, this->Output);
  }
  this->CheckOrientation();
  if (this->Options.Features.Sharpness)
  {
    ReduceSharpness(
      this->Options.Features.Sharpness->GetName(), this->Options.Levels, this->Output);
  }
  RebuildPointGhosts(this->Input, this->Output);

  Stamp stamp;
  stamp.Scheme = this->Options.Scheme;
  stamp.Levels = this->Mesh.MadeLevels + this->Options.Levels;
  stamp.NumberOfControlPoints = this->Mesh.GetControl().NumberOfPoints;
  stamp.IsProjected = this->Options.ProjectToLimit;
  WriteStamp(stamp, this->Output);
  WriteSingularTuples(stamp.IsProjected ? SimplexTuples() : this->Derived, this->Output);
  const std::vector<vtkIdType> none;
  WriteIds(GlobalIdsName, stamp.IsProjected ? none : this->Mesh.GlobalIds, this->Output);
  WriteIds(InvertedCellsName, stamp.IsProjected ? none : this->Mesh.Inverted, this->Output);
}

/// Warns of solids that smoothing turned inside out, and marks them (Inverted).
void UniformRun::CheckOrientation()
{
  vtkSmartPointer<vtkUnsignedCharArray> marks;
  if (this->Options.GenerateClassification)
  {
    marks = vtkSmartPointer<vtkUnsignedCharArray>::New();
    marks->SetName(InvertedName);
    marks->SetNumberOfTuples(this->Output->GetNumberOfCells());
    marks->FillValue(0);
    AddInstead(this->Input->GetCellData(), marks, this->Output->GetCellData());
  }
  const int levels = this->Mesh.MadeLevels + this->Options.Levels;
  const bool hasMoved = this->Options.Levels > 0 || this->Options.ProjectToLimit;
  if (!hasMoved && (levels == 0 || !marks))
  {
    return;
  }
  const InvertedCells found =
    FindInvertedCells(this->Mesh.GetControl(), levels, this->Mesh.Inverted, this->Points->GetTie(),
      this->Output, marks ? marks->GetPointer(0) : nullptr);
  if (found.Count > 0 && hasMoved)
  {
    this->Options.Warn(std::to_string(found.Count) + " of " +
      std::to_string(this->Output->GetNumberOfCells()) +
      " cells are solids that smoothing turned inside out, the first is cell " +
      std::to_string(found.First) +
      ": the control mesh is too thin there. Make its solids less flat, or take fewer levels; "
      "GenerateClassification marks these cells (Inverted).");
  }
}

void UniformRun::AddClassification(const Buffer<Stratum>& vertices, const Buffer<Stratum>& edges)
{
  if (this->Options.GenerateClassification)
  {
    AddRules(vertices, edges, this->Input, this->Output);
  }
}

bool SubdivideUniformly(
  vtkPointSet* input, const UniformOptions& options, vtkUnstructuredGrid* output)
{
  return UniformRun(input, options, output).Run();
}

bool FindUniformOperators(
  vtkPointSet* input, const UniformOptions& options, UniformOperators& operators)
{
  vtkNew<vtkUnstructuredGrid> scratch;
  return UniformRun(input, options, scratch).FindOperators(operators);
}

}
