// SPDX-License-Identifier: BSD-3-Clause
#include "UniformSubdivision.h"

#include "Arrays.h"
#include "CellArrays.h"
#include "Classification.h"
#include "ControlComplex.h"
#include "Core/TetOrder.h"
#include "SizeChecks.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTypeInt32Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <limits>

namespace subdivision
{
namespace
{

constexpr const char* DimensionName = "ManifoldDimension";

class UniformRun
{
public:
  UniformRun(vtkPointSet* input, const UniformOptions& options, vtkUnstructuredGrid* output)
    : Input(input)
    , Options(options)
    , Output(output)
  {
  }
  bool Run();

private:
  enum class Outcome
  {
    Done,
    Stopped,
    NotOurs ///< the stamp fits, the cells do not
  };
  Outcome Execute(bool trustStamp);
  void StartPoints();
  TopologyKey MakeKey() const;
  KeptOperator* FindKept(const TopologyKey& key);
  void UseKept(KeptOperator& kept);

  template <typename Id>
  Outcome BuildAndStep(KeptOperator* keep);
  template <typename Id>
  bool HasMemoryFor(const SimplicialComplex<Id>& complex) const;
  template <typename Id>
  Outcome Step(Level<Id>& level, KeptOperator* keep);
  template <typename Id>
  void StepTwice(const Level<Id>& level);
  template <typename Id>
  void GoToLimit(const Level<Id>& level, KeptStepsOf<Id>& kept);
  template <typename Id>
  void MakeCells(const SimplicialComplex<Id>& complex, int steps);
  template <typename Id>
  void MakeDerived(const SimplicialComplex<Id>& complex, int steps);

  void Finish();
  void AddClassification(const Buffer<Stratum>& vertices, const Buffer<Stratum>& edges);
  bool IsStopped(double done) const
  {
    return this->Options.Progress && this->Options.Progress(done);
  }

  vtkPointSet* Input;
  const UniformOptions& Options;
  vtkUnstructuredGrid* Output;
  ControlMesh Mesh;
  std::unique_ptr<PointArrays> Points;
  ControlTraits Control; ///< its runs are those of the current level
  SimplexTuples Derived; ///< singular simplices as the output names them
  std::vector<std::string> BuildWarnings;
  const KeptOperator* SameCells = nullptr;     ///< has the output's cells, where only rules changed
  vtkSmartPointer<vtkUnsignedCharArray> Types; ///< of the output's cells
};

bool UniformRun::Run()
{
  Outcome outcome = this->Execute(true);
  if (outcome == Outcome::NotOurs)
  {
    outcome = this->Execute(false);
  }
  return outcome == Outcome::Done;
}

UniformRun::Outcome UniformRun::Execute(bool trustStamp)
{
  this->Mesh = ReadControlMesh(this->Input, trustStamp, this->Options.Features, this->Options.Warn);
  const std::string tooMany = CheckNumberOfCells(
    this->Mesh.Cells.Simplices, this->Options.Levels, this->Options.MaximumNumberOfCells);
  if (!tooMany.empty())
  {
    this->Options.Fail(tooMany);
    return Outcome::Stopped;
  }
  this->StartPoints();
  if (!this->Mesh.IsStamped)
  {
    OrderTets(this->Mesh.Cells.Simplices, this->Points->GetCoordinates(), this->Mesh.GetGlobalIds(),
      static_cast<vtkIdType>(this->Mesh.GlobalIds.size()));
  }
  std::unique_ptr<KeptOperator> keep;
  if (this->Options.Cache)
  {
    TopologyKey key = this->MakeKey();
    if (KeptOperator* kept = this->FindKept(key))
    {
      this->UseKept(*kept);
      return Outcome::Done;
    }
    keep = std::make_unique<KeptOperator>();
    keep->Key = std::move(key);
    keep->PointsIn.TakeReference(this->Points->GetPoints()->NewInstance());
    keep->PointsIn->DeepCopy(this->Points->GetPoints());
  }
  const int levels = this->Options.Levels + (this->Options.ReadsLimit() ? 1 : 0);
  const bool large = NeedsLargeIds(this->Mesh.GetControl(), this->Mesh.MadeLevels + levels);
  const Outcome outcome =
    large ? this->BuildAndStep<long long>(keep.get()) : this->BuildAndStep<int>(keep.get());
  if (outcome == Outcome::Done && keep)
  {
    keep->Cells = this->Output->GetCells();
    keep->Types = this->Types;
    keep->PointsOut = this->Output->GetPoints()->GetData();
    keep->Derived = std::move(this->Derived);
    keep->ControlDerived = std::move(this->Control.Derived);
    keep->Candidates = std::move(this->Control.Candidates);
    keep->Features = std::move(this->Control.Features);
    keep->ManifoldDimensions = std::move(this->Control.ManifoldDimensions);
    keep->Warnings = std::move(this->BuildWarnings);
    ++this->Options.Cache->NumberOfBuilds;
    this->Options.Cache->Add(std::move(keep));
  }
  return outcome;
}

void UniformRun::StartPoints()
{
  PointArrayOptions arrays;
  arrays.InterpolateIntegers = this->Options.InterpolateIntegers;
  arrays.CarryOriginalIds = this->Mesh.IsStamped &&
    HasIds(this->Input->GetPointData(), "vtkOriginalPointIds", this->Input->GetNumberOfPoints());
  arrays.OriginalIds = this->Options.GenerateOriginalIds || arrays.CarryOriginalIds;
  arrays.Warn = this->Options.Warn;
  arrays.Precision = this->Options.OutputPointsPrecision;
  if (arrays.OriginalIds)
  {
    arrays.Replaced.emplace_back("vtkOriginalPointIds");
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
}

// ------------------------------------------------------------------------------------------------
// What is kept

TopologyKey UniformRun::MakeKey() const
{
  TopologyKey key;
  key.Simplices = this->Mesh.Cells.Simplices;
  key.MadeLevels = this->Mesh.MadeLevels;
  key.NumberOfControlPoints = this->Mesh.GetControl().NumberOfPoints;
  key.Levels = this->Options.Levels;
  key.Use32BitIds = this->Options.Use32BitIds;
  key.Choices = EncodeChoices(this->Options.Features, this->Mesh.Values);
  key.Choices.push_back(this->Mesh.IsStamped);
  key.Choices.push_back(this->Options.ProjectToLimit);
  key.Choices.push_back(this->Options.GenerateLimitNormals);
  for (const auto& tuples : this->Mesh.Derived.Tuples)
  {
    key.Choices.push_back(static_cast<long long>(tuples.size()));
    key.Choices.insert(key.Choices.end(), tuples.begin(), tuples.end());
  }
  return key;
}

/// The kept operator, if the features are still where they were.
KeptOperator* UniformRun::FindKept(const TopologyKey& key)
{
  return this->Options.Cache->Find(key,
    [this](const KeptOperator& kept)
    {
      const double* points = kept.Candidates.empty() ? nullptr : this->Points->GetCoordinates();
      for (std::size_t i = 0; i < kept.Candidates.size(); ++i)
      {
        if (IsFeature(kept.Candidates[i], points, this->Options.Features.FeatureAngle) !=
          kept.Features[i])
        {
          return false;
        }
      }
      return true;
    });
}

void UniformRun::UseKept(KeptOperator& kept)
{
  for (const std::string& warning : kept.Warnings)
  {
    this->Options.Warn(warning);
  }
  this->Output->SetCells(kept.Types, kept.Cells);
  // Normals need the points before they are projected.
  if (kept.Steps && !this->Options.GenerateLimitNormals &&
    HoldsSameValues(this->Points->GetPoints(), kept.PointsIn))
  {
    this->Points->ReusePoints(kept.PointsOut);
  }
  else
  {
    kept.PointsIn->DeepCopy(this->Points->GetPoints());
  }
  if (kept.Steps)
  {
    kept.Steps->Apply(*this->Points);
  }
  this->Points->Finish(this->Output);
  kept.PointsOut = this->Output->GetPoints()->GetData();
  if (this->Options.Levels > 0)
  {
    this->AddClassification(kept.Steps->GetLastVertices(), kept.Steps->GetLastEdges());
  }
  else
  {
    this->AddClassification(kept.ControlStrata, Buffer<Stratum>());
  }
  this->Derived = kept.Derived;
  this->Control.ManifoldDimensions = Buffer<unsigned char>(kept.ManifoldDimensions.size());
  std::copy(kept.ManifoldDimensions.begin(), kept.ManifoldDimensions.end(),
    this->Control.ManifoldDimensions.begin());
  this->Finish();
}

// ------------------------------------------------------------------------------------------------
// Building

template <typename Id>
UniformRun::Outcome UniformRun::BuildAndStep(KeptOperator* keep)
{
  ControlComplex<Id> control;
  const bool further = this->Options.Levels > 1 || this->Options.ReadsLimit();
  const Depth depth = further ? Depth::ForRefinement : Depth::ForOutput;
  auto warn = [this](const std::string& warning)
  {
    this->BuildWarnings.push_back(warning);
    this->Options.Warn(warning);
  };
  if (!BuildControlComplex(
        this->Mesh, this->Options.Features, this->Points->GetCoordinates(), warn, depth, control))
  {
    return Outcome::NotOurs;
  }
  Level<Id> level = std::move(control.Current);
  this->Control = std::move(static_cast<ControlTraits&>(control));
  this->SameCells =
    keep ? this->Options.Cache->FindCells(keep->Key, this->Control.Derived) : nullptr;
  if (!this->HasMemoryFor(level.Complex))
  {
    return Outcome::Stopped;
  }
  const Outcome outcome = this->Step(level, keep);
  if (outcome == Outcome::Done)
  {
    this->Finish();
  }
  return outcome;
}

template <typename Id>
bool UniformRun::HasMemoryFor(const SimplicialComplex<Id>& complex) const
{
  SizeEstimate estimate;
  estimate.Control = CountSimplices(complex);
  estimate.Levels = this->Options.Levels;
  estimate.Runs = this->Control.Runs;
  estimate.BytesPerPoint = this->Points->GetBytesPerPoint();
  estimate.BytesPerCell = GetBytesPerTuple(this->Input->GetCellData());
  estimate.BytesPerId = sizeof(Id);
  estimate.Projects = this->Options.ReadsLimit();
  const std::string tooLarge = CheckMemory(estimate);
  if (!tooLarge.empty())
  {
    this->Options.Fail(tooLarge);
  }
  return tooLarge.empty();
}

/// The steps themselves. At most two levels are alive at a time, and of the last one only its cells
/// are ever made.
template <typename Id>
UniformRun::Outcome UniformRun::Step(Level<Id>& level, KeptOperator* keep)
{
  const int steps = this->Options.Levels;
  auto kept = std::make_unique<KeptStepsOf<Id>>();
  if (steps == 0)
  {
    this->MakeCells(level.Complex, 0);
    this->MakeDerived(level.Complex, 0);
    this->GoToLimit(level, *kept);
    this->Points->Finish(this->Output);
    this->AddClassification(level.Strata.Vertices, Buffer<Stratum>());
    if (keep)
    {
      keep->ControlStrata = std::move(level.Strata.Vertices);
      if (this->Options.ReadsLimit())
      {
        keep->Steps = std::move(kept);
      }
    }
    return Outcome::Done;
  }
  // Only what is kept, or blended, needs the last two operators as tables.
  const bool stored = keep || this->Options.ReadsLimit() || steps < 2 ||
    HasEqualCells(level.Complex) || IsSharpAfter(this->Control.Sharpness, steps - 2);
  for (int step = 0; step < steps; ++step)
  {
    if (this->IsStopped((step + 1.) / (steps + 1.)))
    {
      return Outcome::Stopped;
    }
    if (step + 2 == steps && !stored)
    {
      this->StepTwice(level);
      return Outcome::Done;
    }
    const bool last = step + 1 == steps;
    Level<Id> next;
    if (last)
    {
      this->MakeCells(level.Complex, 1);
      this->MakeDerived(level.Complex, 1);
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
    Stencils<Id> stencils = TakeStencils(level);
    level = std::move(next);
    if (IsSharpAfter(this->Control.Sharpness, step))
    {
      Level<Id> sharp =
        BuildSharpLevel<Id>(this->Mesh, this->Options.Features, this->Control, step);
      BlendSemiSharp(
        this->Control.Sharpness, step, this->Mesh.MadeLevels + step, TakeStencils(sharp), stencils);
    }
    this->Points->Advance(stencils);
    if (last)
    {
      this->GoToLimit(level, *kept);
      this->Points->Finish(this->Output);
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
  return Outcome::Done;
}

/// The last two steps without the level between them.
template <typename Id>
void UniformRun::StepTwice(const Level<Id>& level)
{
  this->MakeCells(level.Complex, 2);
  this->MakeDerived(level.Complex, 2);
  this->Points->Advance(LevelRows<Id>(level));
  const ChildRows<Id> last(level);
  this->Points->Advance(last);
  this->Points->Finish(this->Output);
  if (!this->Options.GenerateClassification)
  {
    return;
  }
  const LevelRows<Id> before(level);
  Buffer<Stratum> vertices(before.GetNumberOfRows());
  Buffer<Stratum> edges(last.GetNumberOfRows() - vertices.size());
  last.ForRows(
    [&](const StencilRows<Id>& rows)
    {
      std::copy_n(rows.Strata, rows.Count,
        rows.OfEdges ? edges.data() + (rows.FirstRow - vertices.size())
                     : vertices.data() + rows.FirstRow);
    });
  this->AddClassification(vertices, edges);
}

/// From the vertices of the last level to their limits.
template <typename Id>
void UniformRun::GoToLimit(const Level<Id>& level, KeptStepsOf<Id>& kept)
{
  if (this->Options.ReadsLimit())
  {
    LimitOperators<Id> limit(level,
      BuildSharpStages<Id>(this->Mesh, this->Options.Features, this->Control, this->Options.Levels),
      this->Options.ProjectToLimit, this->Options.GenerateLimitNormals);
    limit.Apply(*this->Points);
    kept.SetLimit(std::move(limit));
  }
}

// ------------------------------------------------------------------------------------------------
// Output

/// The cells of a level after 0, 1 or 2 steps, at a place that has room for them.
template <typename Id, typename Out>
void WriteRefined(const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs, int steps,
  const CellStorage<Out>& storage)
{
  switch (steps)
  {
    case 0:
      WriteCells(complex, runs, storage);
      break;
    case 1:
      WriteChildren(complex, runs, storage);
      break;
    default:
      WriteGrandchildren(complex, runs, storage);
      break;
  }
}

/// The cells of a level after some steps, as the output's.
template <typename Id>
void UniformRun::MakeCells(const SimplicialComplex<Id>& complex, int steps)
{
  if (this->SameCells)
  {
    this->Types = this->SameCells->Types;
    this->Output->SetCells(this->Types, this->SameCells->Cells);
    return;
  }
  const CellCounts counts = CountCells(RefineRuns(this->Control.Runs, steps));
  LevelCounts refined = CountSimplices(complex);
  for (int step = 0; step < steps; ++step)
  {
    refined = refined.Refine();
  }
  const bool small = this->Options.Use32BitIds &&
    std::max(static_cast<double>(counts.Entries), refined.Vertices) <
      std::numeric_limits<int>::max();
  const auto types = MakeArray(VTK_UNSIGNED_CHAR, 1, counts.Cells);
  vtkNew<vtkCellArray> cells;
  auto fill = [&](auto* offsets, auto* connectivity)
  {
    Allocate(offsets, 1, counts.Cells + 1);
    Allocate(connectivity, 1, counts.Entries);
    using Out = typename std::remove_pointer<decltype(offsets->GetPointer(0))>::type;
    const CellStorage<Out> storage{ connectivity->GetPointer(0), offsets->GetPointer(0),
      static_cast<unsigned char*>(types->GetVoidPointer(0)) };
    WriteRefined(complex, this->Control.Runs, steps, storage);
    cells->SetData(offsets, connectivity);
  };
  if (small)
  {
    vtkNew<vtkTypeInt32Array> offsets;
    vtkNew<vtkTypeInt32Array> connectivity;
    fill(offsets.Get(), connectivity.Get());
  }
  else
  {
    vtkNew<vtkIdTypeArray> offsets;
    vtkNew<vtkIdTypeArray> connectivity;
    fill(offsets.Get(), connectivity.Get());
  }
  this->Types = vtkUnsignedCharArray::SafeDownCast(types);
  this->Output->SetCells(this->Types, cells);
}

/// The singular simplices that were derived, as the output names them.
template <typename Id>
void UniformRun::MakeDerived(const SimplicialComplex<Id>& complex, int steps)
{
  const CellCounts counts = CountCells(RefineRuns(this->Control.DerivedRuns, steps));
  this->Derived = SimplexTuples();
  if (counts.Cells == 0)
  {
    return;
  }
  Buffer<long long> connectivity(counts.Entries);
  Buffer<long long> offsets(counts.Cells + 1);
  Buffer<unsigned char> types(counts.Cells);
  const CellStorage<long long> storage{ connectivity.data(), offsets.data(), types.data() };
  WriteRefined(complex, this->Control.DerivedRuns, steps, storage);
  for (vtkIdType i = 0; i < counts.Cells; ++i)
  {
    const int dimension = static_cast<int>(offsets[i + 1] - offsets[i]) - 1;
    auto& tuples = this->Derived.Tuples[dimension];
    tuples.insert(
      tuples.end(), connectivity.data() + offsets[i], connectivity.data() + offsets[i + 1]);
  }
}

/// Cell data, ghosts and the stamp.
void UniformRun::Finish()
{
  CellArrayOptions cells;
  cells.Levels = this->Options.Levels;
  cells.OriginalIds = this->Options.GenerateOriginalIds;
  cells.CarryOriginalIds = this->Mesh.IsStamped &&
    HasIds(this->Input->GetCellData(), "vtkOriginalCellIds", this->Input->GetNumberOfCells());
  if (cells.OriginalIds && !cells.CarryOriginalIds)
  {
    cells.Replaced.emplace_back("vtkOriginalCellIds");
  }
  cells.Warn = this->Options.Warn;
  if (this->Options.GenerateClassification)
  {
    cells.Replaced.emplace_back(DimensionName);
  }
  CopyCellArrays(this->Input, this->Mesh.Cells, cells, this->Output);
  if (this->Options.GenerateClassification)
  {
    AddValuesOfSimplices(this->Control.ManifoldDimensions.data(), this->Mesh.GetControl(),
      this->Mesh.MadeLevels + this->Options.Levels, DimensionName, this->Input, this->Output);
  }
  if (this->Options.Features.Sharpness)
  {
    ReduceSharpness(
      this->Options.Features.Sharpness->GetName(), this->Options.Levels, this->Output);
  }
  RebuildPointGhosts(this->Input, this->Output);

  Stamp stamp;
  stamp.Levels = this->Mesh.MadeLevels + this->Options.Levels;
  stamp.NumberOfControlPoints = this->Mesh.GetControl().NumberOfPoints;
  stamp.IsProjected = this->Options.ProjectToLimit;
  WriteStamp(stamp, this->Output);
  WriteSingularTuples(stamp.IsProjected ? SimplexTuples() : this->Derived, this->Output);
  WriteGlobalIds(stamp.IsProjected ? std::vector<vtkIdType>() : this->Mesh.GlobalIds, this->Output);
}

void UniformRun::AddClassification(const Buffer<Stratum>& vertices, const Buffer<Stratum>& edges)
{
  if (this->Options.GenerateClassification)
  {
    AddRules(vertices, edges, this->Input, this->Output);
  }
}

}

bool SubdivideUniformly(
  vtkPointSet* input, const UniformOptions& options, vtkUnstructuredGrid* output)
{
  return UniformRun(input, options, output).Run();
}

}
