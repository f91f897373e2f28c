// SPDX-License-Identifier: BSD-3-Clause
#include "Private/RedGreen/RedGreenRun.h"

#include "Core/Solids/Complex/TetOrder.h"
#include "Private/ArrayNames.h"
#include "Private/Arrays/CellArrays.h"
#include "Private/Arrays/PointArrays.h"
#include "Private/Control/FittingMarks.h"
#include "Private/Control/SharedInterpolation.h"
#include "Private/Control/SizeChecks.h"
#include "Private/Control/StampFields.h"
#include "Private/RedGreen/RedGreenLimit.h"
#include "Private/RedGreen/RedGreenMesh.h"
#include "Private/RedGreen/RedGreenNormals.h"
#include "Private/RedGreen/RedGreenNumbers.h"
#include "Private/RedGreen/RedGreenWriter.h"
#include "Private/RedGreen/RefinementMarks.h"
#include "Private/RedGreen/SharedSplits.h"
#include "Private/RedGreen/VertexOrigins.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <stdexcept>

namespace subdivision
{
namespace
{

class RedGreenRun
{
public:
  RedGreenRun(vtkPointSet* input, const RedGreenOptions& options, vtkUnstructuredGrid* output)
    : Input(input)
    , Options(options)
    , Others(FindPartners(options, input))
    , Output(output)
  {
  }
  bool Run();

private:
  template <typename Id>
  using Marks = std::vector<RefinementMark<Id>>;

  void Read(bool trustStamp);
  void StartPoints();
  void FindLimit();
  template <typename Id>
  bool Refine();
  template <typename Id>
  bool Plan(SharedState<Id>& shared, RedGreenLimit<Id>& limit);
  template <typename Id>
  bool BuildLimit(RedGreenLimit<Id>& limit);
  template <typename Id>
  void Interpolate(RedGreenLimit<Id>& limit);
  template <typename Id>
  bool FindCells(SharedState<Id>& shared, RedGreenLimit<Id>& limit);
  template <typename Id>
  SharedState<Id> StartState();
  template <typename Id>
  bool RunRounds(SharedState<Id>& shared, RedGreenLimit<Id>& limit);
  template <typename Id, typename Cells>
  Marks<Id> FindMarksOf(const Cells& cells, const RedGreen<Id>& state, RedGreenLimit<Id>& limit,
    MarkNotes& notes) const;
  template <typename Id>
  void StopAtLimit(std::vector<Marks<Id>>& rounds, SharedState<Id>& shared);
  bool IsTooLarge(vtkIdType ownCells);
  bool AllAgree(bool own) const { return this->Others ? this->Others->Sum(own ? 0 : 1) == 0 : own; }
  void WarnOfNotes(MarkNotes& notes);

  template <typename Id>
  void MakePoints(const RedGreen<Id>& state, const RedGreenLimit<Id>& limit);
  Coordinates GetGivenCoordinates()
  {
    return this->GivenCoordinates.empty()
      ? this->Points->GetCoordinates()
      : Coordinates(this->GivenCoordinates.data(), this->Points->GetTie());
  }
  bool ReadsLimit() const
  {
    return this->Options.LimitPlacement || this->Options.Criteria.ReadsLimit();
  }
  /// Adds a warning. Warnings are told when it is known that the stamp is true.
  void Warn(const std::string& warning) { this->Mesh.Control.Warnings.push_back(warning); }
  bool IsStopped(double done) const
  {
    return this->Options.Progress && this->Options.Progress(done);
  }

  vtkPointSet* Input;
  const RedGreenOptions& Options;
  Partners* Others; ///< null: the input is the whole mesh
  vtkUnstructuredGrid* Output;
  RedGreenMesh Mesh;
  std::unique_ptr<PointArrays> Points;
  std::vector<double> GivenCoordinates; ///< where Points has others, which interpolate them
  std::unique_ptr<RefinementCriteria> Criteria;
  double MostCells = 0.;       ///< that the output may have
  vtkIdType NumberOfCells = 0; ///< of all partitions, when IsTooLarge was called
  bool MemoryIsLimit = false;
};

bool RedGreenRun::Run()
{
  this->Read(true);
  if (this->IsStopped(0.1))
  {
    return false;
  }
  // There are as many simplices as input cells, or more, if the stamp turns out to be wrong.
  const vtkIdType simplices = std::max(
    this->Mesh.Control.Cells.Simplices.GetNumberOfSimplices(), this->Input->GetNumberOfCells());
  const double largest = 12. * (static_cast<double>(simplices) + this->MostCells);
  return largest < static_cast<double>(std::numeric_limits<int>::max()) ? this->Refine<int>()
                                                                        : this->Refine<long long>();
}

// ------------------------------------------------------------------------------------------------
// Planning

/// Reads the mesh, starts its points, and finds how many cells the output may have.
void RedGreenRun::Read(bool trustStamp)
{
  // Leaves in the place of their green parts do not conform, and then there is no limit. Where
  // limits are needed, green cells are not undone.
  const bool undo = !this->ReadsLimit();
  const auto read = [&](bool undoes)
  {
    const StampScheme scheme = undo ? StampScheme::BoxSpline : this->Options.Scheme;
    return ReadRedGreenMesh(this->Input, this->Options.Features, scheme, trustStamp, undoes);
  };
  this->Mesh = read(undo);
  if (undo && !this->AllAgree(this->Mesh.IsContinued) && this->Mesh.IsContinued)
  {
    this->Mesh = read(false);
  }
  if (this->Others)
  {
    this->Mesh.Scopes = FindScopes(this->Mesh, *this->Others);
  }
  this->StartPoints();
  this->FindLimit();
}

void RedGreenRun::StartPoints()
{
  PointArrayOptions arrays;
  arrays.InterpolateIntegers = this->Options.InterpolateIntegers;
  arrays.HasMaterialFields = this->Options.HasMaterialFields;
  arrays.CarryOriginalIds = this->Mesh.CarriesOriginals(
    this->Input->GetPointData(), OriginalPointIdsName, this->Input->GetNumberOfPoints());
  arrays.OriginalIds = this->Options.GenerateOriginalIds || arrays.CarryOriginalIds;
  arrays.Warn = [this](const std::string& warning) { this->Warn(warning); };
  arrays.Precision = this->Options.OutputPointsPrecision;
  if (arrays.OriginalIds)
  {
    arrays.Replaced.emplace_back(OriginalPointIdsName);
  }
  if (this->Options.GenerateLimitNormals)
  {
    arrays.Replaced.emplace_back(LimitNormalsName);
  }
  const ControlMesh& control = this->Mesh.Control;
  this->GivenCoordinates.clear();
  this->Points = std::make_unique<PointArrays>(this->Input, control.Cells, control.GetGlobalIds(),
    static_cast<vtkIdType>(control.GlobalIds.size()), arrays);
}

/// How many cells the output may have, by the option and by the memory that there is.
void RedGreenRun::FindLimit()
{
  // Connectivity, offset, type, our own arrays, what refinement keeps; a point for five cells.
  const double perCell = 41. + 18. + 130. + GetBytesPerTuple(this->Input->GetCellData()) +
    (this->Points->GetBytesPerPoint() + 40.) / 5.;
  const double fitting = GetAvailableMemory() / perCell;
  const auto wanted = static_cast<double>(this->Options.MaximumNumberOfCells);
  this->MemoryIsLimit = fitting < wanted;
  this->MostCells = std::min(fitting, wanted);
}

/// Decides whether the stamp is true, and which cells the output has. Tells the warnings of all
/// that. Returns false after an error or if Progress asks to stop.
template <typename Id>
bool RedGreenRun::Plan(SharedState<Id>& shared, RedGreenLimit<Id>& limit)
{
  bool isTrue = false;
  bool isFound = false;
  try
  {
    isTrue = this->AllAgree(this->BuildLimit(limit));
    if (isTrue)
    {
      this->Interpolate(limit);
      isFound = this->FindCells(shared, limit);
    }
  }
  catch (const std::invalid_argument&) // the midpoints of the stamp do not fit together
  {
    if (this->Others) // which would not begin again
    {
      throw;
    }
    isTrue = false;
  }
  if (!isTrue)
  {
    this->Read(false);
    limit = RedGreenLimit<Id>();
    this->BuildLimit(limit);
    this->Interpolate(limit);
    isFound = this->FindCells(shared, limit);
  }
  this->Criteria.reset();
  Tell(this->Mesh.Control.Warnings, this->Options);
  return isFound;
}

/// Builds what puts vertices on the limit, if that is needed. Returns false if the stamp is wrong.
template <typename Id>
bool RedGreenRun::BuildLimit(RedGreenLimit<Id>& limit)
{
  if (!this->ReadsLimit())
  {
    return true;
  }
  // Tetrahedra are ordered in a copy, so that cells of the output keep the order of their points,
  // and new points have the same ids with either placement.
  ControlMesh ordered = this->Mesh.Control;
  ordered.Cells.TakeIds();
  const Coordinates points = this->Points->GetCoordinates();
  if (!this->Mesh.TetOrderIsFinal)
  {
    OrderTets(ordered.Cells.Simplices, points, ordered.GetGlobalIds(),
      static_cast<vtkIdType>(ordered.GlobalIds.size()));
  }
  return limit.Build(ordered, this->Options.Features, this->Options.Scheme, points,
    [this](const std::string& warning) { this->Warn(warning); });
}

/// Replaces points and arrays by control values whose limits they are, and lets `limit` know.
template <typename Id>
void RedGreenRun::Interpolate(RedGreenLimit<Id>& limit)
{
  const ControlMesh& control = this->Mesh.Control;
  if (control.IsStamped)
  {
    WarnOfLateInterpolation(this->Options.Interpolation,
      ReadFieldIds(InterpolatedName, this->Input->GetFieldData()),
      [this](const std::string& warning) { this->Warn(warning); });
  }
  const bool isOwn = this->Options.Interpolation.IsOn() && !control.IsStamped;
  if (!AgreeWithOthers(isOwn, this->Input, this->Options))
  {
    return;
  }
  const vtkIdType size = control.Cells.Simplices.NumberOfPoints;
  const double* given = this->Points->GetCoordinates();
  this->GivenCoordinates.assign(given, given + 3 * size);
  InterpolationLimits limits;
  limits.LeastEigenvalue = 1. / 6.; // Mathematics 8
  ConnectToOthers(this->Input, control.Cells, this->Options, limits);
  this->Points->Interpolate(limit.GetControlRows(), this->Options.Interpolation, limits,
    [this](const std::string& warning) { this->Warn(warning); });
  const double* points = this->Points->GetCoordinates();
  std::vector<double> attribute;
  if (vtkDataArray* current = this->Points->FindCurrent(this->Options.Criteria.Attribute))
  {
    for (vtkIdType i = 0; i < size; ++i)
    {
      for (int c = 0; c < current->GetNumberOfComponents(); ++c)
      {
        attribute.push_back(current->GetComponent(i, c));
      }
    }
  }
  limit.SetControlValues({ points, points + 3 * size }, std::move(attribute));
}

/// Runs the rounds.
template <typename Id>
bool RedGreenRun::FindCells(SharedState<Id>& shared, RedGreenLimit<Id>& limit)
{
  shared = this->StartState<Id>();
  const bool isTooLarge = this->IsTooLarge(shared.State->GetNumberOfCells());
  if (isTooLarge && this->MemoryIsLimit)
  {
    Tell(this->Mesh.Control.Warnings, this->Options);
    this->Options.Fail("There is not enough memory for the " + std::to_string(this->NumberOfCells) +
      " cells of the input. Use a part of the input.");
    return false;
  }
  if (!isTooLarge)
  {
    return this->RunRounds(shared, limit);
  }
  this->Warn("The input has " + std::to_string(this->NumberOfCells) +
    " cells, which is more than MaximumNumberOfCells: nothing is refined. Raise "
    "MaximumNumberOfCells.");
  return true;
}

/// Whether the output would have too many cells. All partitions get the same answer.
bool RedGreenRun::IsTooLarge(vtkIdType ownCells)
{
  const bool isOwnTooLarge = static_cast<double>(ownCells) > this->MostCells;
  this->NumberOfCells = this->Others ? this->Others->Sum(ownCells) : ownCells;
  if (!this->Others)
  {
    return isOwnTooLarge;
  }
  this->MemoryIsLimit = this->NumberOfCells <= this->Options.MaximumNumberOfCells;
  return this->Others->Sum(isOwnTooLarge ? 1 : 0) > 0 || !this->MemoryIsLimit;
}

/// The state before any mark.
template <typename Id>
SharedState<Id> RedGreenRun::StartState()
{
  std::function<void(vtkIdType*)> order;
  if (!this->Mesh.TetOrderIsFinal)
  {
    const Coordinates points = this->GetGivenCoordinates();
    const ControlMesh& control = this->Mesh.Control;
    order = [points, &control](vtkIdType* tet)
    {
      OrderTet(
        tet, points, control.GetGlobalIds(), static_cast<vtkIdType>(control.GlobalIds.size()));
    };
  }
  auto state = std::make_unique<RedGreen<Id>>(this->Mesh.GetView(), order);
  for (const auto& middle : this->Mesh.Midpoints)
  {
    state->AddMidpoint(
      static_cast<Id>(middle[0]), static_cast<Id>(middle[1]), static_cast<Id>(middle[2]));
  }
  if (!this->Mesh.Midpoints.empty())
  {
    state->Close();
  }
  SharedState<Id> shared;
  if (this->Others)
  {
    state->SetScopes(this->Mesh.Scopes.data());
    shared.Splits = std::make_unique<SharedSplits<Id>>(this->Mesh, *this->Others);
  }
  shared.State = std::move(state);
  return shared;
}

template <typename Id>
void Apply(const std::vector<RefinementMark<Id>>& marks, std::size_t count, SharedState<Id>& shared)
{
  RedGreen<Id>& state = *shared.State;
  std::vector<Id> inputs;
  inputs.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    if (marks[i].Leaf.Cell < state.GetNumberOfInputCells() &&
      (inputs.empty() || inputs.back() != marks[i].Leaf.Cell))
    {
      inputs.push_back(marks[i].Leaf.Cell);
    }
  }
  state.Expect(inputs);
  for (std::size_t i = 0; i < count; ++i)
  {
    if (marks[i].Ends[0] < 0)
    {
      state.MarkCell(marks[i].Leaf);
    }
    else
    {
      state.MarkEdge(marks[i].Leaf, marks[i].Ends[0], marks[i].Ends[1]);
    }
  }
  shared.Close();
}

template <typename Id, typename Cells>
RedGreenRun::Marks<Id> RedGreenRun::FindMarksOf(
  const Cells& cells, const RedGreen<Id>& state, RedGreenLimit<Id>& limit, MarkNotes& notes) const
{
  const RefinementOptions& options = this->Options.Criteria;
  const bool atLimit = options.ReadsLimit();
  if (atLimit)
  {
    limit.FindErrors(state, cells, options.MaximumLevel, options, *this->Criteria);
  }
  return FindMarks<Id>(
    cells, *this->Criteria, options.MaximumLevel,
    [&](Id a, Id b) { return atLimit ? limit.GetError(a, b) : 0.; }, notes);
}

/// Returns false if Progress asks to stop.
template <typename Id>
bool RedGreenRun::RunRounds(SharedState<Id>& shared, RedGreenLimit<Id>& limit)
{
  std::unique_ptr<RedGreen<Id>>& state = shared.State;
  const RefinementOptions& options = this->Options.Criteria;
  this->Criteria =
    std::make_unique<RefinementCriteria>(options, this->Input, this->Mesh.Control.Cells);
  VertexOrigins origins(*this->Points);
  std::vector<Marks<Id>> rounds;
  MarkNotes notes;
  for (int round = 0;; ++round)
  {
    if (this->IsStopped(0.1 + 0.6 * round / (round + 3.)))
    {
      return false;
    }
    Marks<Id> marks;
    if (round == 0)
    {
      marks = this->FindMarksOf(InputCandidates<Id>(this->Mesh, *state), *state, limit, notes);
    }
    if (round > 0 || !this->Mesh.Midpoints.empty())
    {
      const Marks<Id> more = this->FindMarksOf(
        ChangedCandidates<Id>(this->Mesh, *state, options.MaximumLevel), *state, limit, notes);
      marks.insert(marks.end(), more.begin(), more.end());
    }
    if (this->Others ? this->Others->Sum(static_cast<vtkIdType>(marks.size())) == 0 : marks.empty())
    {
      break;
    }
    Apply(marks, marks.size(), shared);
    rounds.push_back(std::move(marks));
    if (this->IsTooLarge(state->GetNumberOfCells()))
    {
      this->StopAtLimit(rounds, shared);
      break;
    }
    origins.Continue(*state);
    this->Criteria->Continue(state->GetNumberOfVertices(),
      [&](vtkIdType vertex)
      {
        auto ends = state->GetEnds(static_cast<Id>(vertex));
        if (!origins.IsFirst(ends[0], ends[1]))
        {
          std::swap(ends[0], ends[1]);
        }
        return ends;
      });
  }
  this->WarnOfNotes(notes);
  return true;
}

/// The last round made too many cells: goes back and applies only as many of its worst marks as
/// fit. It starts from the input and applies all marks again, which gives the same state as before.
template <typename Id>
void RedGreenRun::StopAtLimit(std::vector<Marks<Id>>& rounds, SharedState<Id>& shared)
{
  Marks<Id> last = std::move(rounds.back());
  rounds.pop_back();
  std::stable_sort(last.begin(), last.end(),
    [](const RefinementMark<Id>& a, const RefinementMark<Id>& b) { return a.Error > b.Error; });
  auto replay = [&](std::size_t count)
  {
    shared = this->StartState<Id>();
    for (const Marks<Id>& marks : rounds)
    {
      Apply(marks, marks.size(), shared);
    }
    if (count > 0 || this->Others)
    {
      Apply(last, count, shared);
    }
    return !this->IsTooLarge(shared.State->GetNumberOfCells());
  };
  const bool memoryIsLimit = this->MemoryIsLimit;
  const std::size_t fits = this->Others ? FindFittingError(last, *this->Others, replay)
                                        : FindFittingCount(last.size(), replay);
  replay(fits);
  auto left = static_cast<vtkIdType>(last.size() - fits);
  left = this->Others ? this->Others->Sum(left) : left;
  std::string what = std::to_string(left) +
    " places that the criteria ask for were not refined. The filter leaves out those with the "
    "smallest errors first, the worst ones last: the output would have more than " +
    std::to_string(
      this->Others ? this->Options.MaximumNumberOfCells : static_cast<vtkIdType>(this->MostCells)) +
    " cells, ";
  what += memoryIsLimit ? "for which there is not enough memory. Use weaker criteria, a lower "
                          "MaximumLevel, or a part of the input."
                        : "which is MaximumNumberOfCells. Raise it, or use weaker criteria or a "
                          "lower MaximumLevel.";
  this->Warn(what);
}

void RedGreenRun::WarnOfNotes(MarkNotes& notes)
{
  auto& edges = notes.WithoutValue;
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  if (!edges.empty())
  {
    vtkDataArray* array = this->Options.Criteria.Attribute;
    this->Warn(std::to_string(edges.size()) + " edges have a value of the point array \"" +
      (array->GetName() ? array->GetName() : "") +
      "\" that is not finite at one of their ends, the first joins points " +
      std::to_string(edges[0].first) + " and " + std::to_string(edges[0].second) +
      ": RefineByAttributeError does not refine them.");
  }
  if (notes.TooShort > 0)
  {
    this->Warn(std::to_string(notes.TooShort) +
      " edges or cells that the criteria ask for were not refined: they are so small that no "
      "number "
      "lies between the coordinates of their points.");
  }
}

// ------------------------------------------------------------------------------------------------
// Output

template <typename Id>
bool RedGreenRun::Refine()
{
  RedGreenLimit<Id> limit;
  SharedState<Id> shared;
  if (!this->Plan(shared, limit) || this->IsStopped(0.75))
  {
    return false;
  }
  shared.State->SortVertices();
  const RedGreen<Id>& state = *shared.State;
  const RedGreenOutput<Id> plan(state);
  std::vector<vtkIdType> simplices;
  WriteRedGreenCells(plan, this->Input, this->Mesh, this->Options, this->Options.LimitPlacement,
    this->Others ? &simplices : nullptr, this->Output);
  if (this->IsStopped(0.9))
  {
    return false;
  }
  this->MakePoints(state, limit);
  TellOvershoot(
    *this->Points, this->Options, this->Input, this->Output, this->Options.LimitPlacement);
  RebuildPointGhosts(this->Input, this->Output);
  WholeSize whole;
  if (this->Others)
  {
    whole =
      AddRedGreenNumbers(this->Input, this->Mesh, state, simplices, *this->Others, this->Output);
  }
  WriteRedGreenFields(this->Mesh, plan, this->Options.LimitPlacement, whole, this->Output);
  return true;
}

template <typename Id>
void RedGreenRun::MakePoints(const RedGreen<Id>& state, const RedGreenLimit<Id>& limit)
{
  VertexOrigins origin(*this->Points);
  if (this->Points->GathersSome())
  {
    origin.Continue(state);
  }
  if (this->Options.LimitPlacement)
  {
    const bool hasNormals = this->Options.GenerateLimitNormals;
    const LocalLimit<Id> operation = limit.GetOperator(state, hasNormals);
    Buffer<double> normals;
    if (hasNormals)
    {
      const RedGreenNormals<Id> sides(
        this->Input, this->Mesh.Control, this->GetGivenCoordinates(), limit, this->Others);
      normals = sides.Compute(operation, this->Points->GetCoordinates());
    }
    this->Points->Advance(operation, origin);
    if (hasNormals)
    {
      this->Points->SetLimitNormals(normals);
    }
  }
  else
  {
    const bool adds = state.GetNumberOfVertices() > state.GetNumberOfInputVertices();
    if (adds)
    {
      this->Points->Advance(MakeMidpointRows(state), origin);
    }
    if (!this->AllAgree(!adds))
    {
      this->Points->LeaveOutNormals();
    }
  }
  this->Points->Finish(this->Output);
}

}

bool RefineRedGreen(vtkPointSet* input, const RedGreenOptions& options, vtkUnstructuredGrid* output)
{
  RedGreenOptions own = options;
  if (Partners* others = FindPartners(options, input))
  {
    own.Criteria.FindLargest = [others](std::vector<double>& values)
    { others->FindLargest(values); };
  }
  return RedGreenRun(input, own, output).Run();
}

}
