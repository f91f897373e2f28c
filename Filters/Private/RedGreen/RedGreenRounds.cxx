// SPDX-License-Identifier: BSD-3-Clause
// The rounds of a red-green refinement: each marks the cells that the criteria ask for and closes
// the marks, until there are none, or the output is large enough.
#include "Private/RedGreen/RedGreenRun.h"

#include "Core/Memory/Sorting.h"
#include "Core/Solids/Complex/TetOrder.h"
#include "Private/Partitions/FittingMarks.h"
#include "Private/RedGreen/VertexOrigins.h"
#include "Private/Values/MissingValues.h"

#include "vtkDataArray.h"

#include <functional>

namespace subdivision
{
namespace
{

template <typename Id>
void Apply(const std::vector<RefinementMark<Id>>& marks, std::size_t count, SharedState<Id>& shared)
{
  RedGreen<Id>& state = *shared.State;
  std::vector<Id> inputs;
  inputs.reserve(count);
  for (const std::size_t i : InTurn(count))
  {
    if (marks[i].Leaf.Cell < state.GetNumberOfInputCells() &&
      (inputs.empty() || inputs.back() != marks[i].Leaf.Cell))
    {
      inputs.push_back(marks[i].Leaf.Cell);
    }
  }
  state.Expect(inputs);
  ForEachInTurn(static_cast<vtkIdType>(count),
    [&](vtkIdType i)
    {
      if (marks[i].Ends[0] < 0)
      {
        state.MarkCell(marks[i].Leaf);
      }
      else
      {
        state.MarkEdge(marks[i].Leaf, marks[i].Ends[0], marks[i].Ends[1]);
      }
    });
  shared.Close();
}

}

/// Finds which cells the output has. Returns false after an error or if Progress asks to stop.
template <typename Id>
bool RedGreenRun::FindCells(SharedState<Id>& shared, const RedGreenLimit<Id>& limit)
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
  for (const auto& middle : InTurn(this->Mesh.Midpoints))
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

template <typename Id, typename Cells>
RedGreenRun::Marks<Id> RedGreenRun::FindMarksOf(
  const Cells& cells, const RedGreen<Id>& state, RedGreenErrors<Id>* errors, MarkNotes& notes) const
{
  if (errors)
  {
    errors->Find(state, cells);
  }
  return FindMarks<Id>(
    cells, *this->Criteria, this->Options.Criteria.MaximumLevel,
    [errors](Id a, Id b) { return errors ? errors->GetError(a, b) : 0.; }, notes);
}

/// Returns false if Progress asks to stop.
template <typename Id>
bool RedGreenRun::RunRounds(SharedState<Id>& shared, const RedGreenLimit<Id>& limit)
{
  std::unique_ptr<RedGreen<Id>>& state = shared.State;
  const RefinementOptions& options = this->Options.Criteria;
  this->Criteria =
    std::make_unique<RefinementCriteria>(options, this->Input, this->Mesh.Control.Cells);
  const auto errors = options.ReadsLimit()
    ? std::make_unique<RedGreenErrors<Id>>(limit, options, *this->Criteria)
    : nullptr;
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
      marks =
        this->FindMarksOf(InputCandidates<Id>(this->Mesh, *state), *state, errors.get(), notes);
    }
    if (round > 0 || !this->Mesh.Midpoints.empty())
    {
      Marks<Id> more =
        this->FindMarksOf(ChangedCandidates<Id>(this->Mesh, *state, options.MaximumLevel), *state,
          errors.get(), notes);
      marks.empty() ? marks.swap(more) : void(marks.insert(marks.end(), more.begin(), more.end()));
    }
    if (this->Others ? this->Others->Sum(static_cast<vtkIdType>(marks.size())) == 0 : marks.empty())
    {
      if (round == 0 && this->Options.Criteria.SplitAll())
      {
        return this->RunRounds(shared, limit);
      }
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
  StableSort(last,
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
  this->Warn(DescribeLeftOut(left,
    this->Others ? this->Options.MaximumNumberOfCells : static_cast<vtkIdType>(this->MostCells),
    memoryIsLimit));
}

void RedGreenRun::WarnOfNotes(MarkNotes& notes)
{
  NoteEdgesWithoutValue(
    notes.WithoutValue, this->Options.Criteria.Attribute, "at one of their ends", this->Options);
  if (notes.TooShort > 0)
  {
    this->Warn(std::to_string(notes.TooShort) +
      " edges or cells that the criteria ask for were not refined: they are so small that no "
      "number "
      "lies between the coordinates of their points. Use weaker criteria there.");
  }
}

template bool RedGreenRun::FindCells(SharedState<int>&, const RedGreenLimit<int>&);
template bool RedGreenRun::FindCells(SharedState<long long>&, const RedGreenLimit<long long>&);

}
