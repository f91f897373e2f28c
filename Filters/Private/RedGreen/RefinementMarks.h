// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RefinementMarks.h
 * Finds the edges and cells that the criteria mark in one round of red-green refinement.
 */
#ifndef SubdivisionObjects_RefinementMarks_h
#define SubdivisionObjects_RefinementMarks_h

#include "Core/Solids/RedGreen/RedGreen.h"
#include "Private/Criteria/RefinementCriteria.h"
#include "Private/RedGreen/RedGreenMesh.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace subdivision
{

/// An edge of a leaf, or the whole leaf.
template <typename Id>
struct RefinementMark
{
  double Error = 0.; ///< as a multiple of the allowed error
  RedGreenLeaf<Id> Leaf;
  Id Ends[2] = { -1, -1 }; ///< -1: all edges
};

/// The cells of the input, which are the candidates for marks in the first round. IsOver says which
/// of them are red already, IsOwn which belong to no other partition.
template <typename Id>
class InputCandidates
{
public:
  InputCandidates(const RedGreenMesh& mesh, const RedGreen<Id>& state)
    : Mesh(mesh)
    , State(state)
    , View(mesh.GetView())
    , Places(FindCorners(this->View))
  {
  }
  bool IsInput() const { return true; }
  vtkIdType GetSize() const { return this->View.NumberOfSimplices; }
  Row<vtkIdType> GetPoints(vtkIdType i) const
  {
    const vtkIdType* first = this->View.Connectivity + this->Places[i];
    return { first, first + this->View.Dimensions[i] + 1 };
  }
  vtkIdType GetInputCell(vtkIdType i) const { return this->Mesh.GetInputCell(i); }
  int GetLevel(vtkIdType i) const { return this->View.GetLevel(i); }
  int GetSteps(vtkIdType) const { return 0; }
  bool IsOver(vtkIdType i) const
  {
    return this->State.IsRed(static_cast<Id>(i)) || this->Mesh.GetScope(i) == CellScope::Ignored;
  }
  bool IsOwn(vtkIdType i) const { return this->Mesh.GetScope(i) == CellScope::Own; }
  RedGreenLeaf<Id> GetLeaf(vtkIdType i) const { return { static_cast<Id>(i), -1 }; }

private:
  const RedGreenMesh& Mesh;
  const RedGreen<Id>& State;
  const SimplexView View;
  const SimplexStarts Places;
};

/// The cells that the last round changed, but for cells that cannot be refined further.
template <typename Id>
class ChangedCandidates
{
public:
  ChangedCandidates(const RedGreenMesh& mesh, const RedGreen<Id>& state, int maximumLevel)
    : Mesh(mesh)
    , View(mesh.GetView())
    , Cells(state.GetChangedCells(maximumLevel))
  {
  }
  bool IsInput() const { return false; }
  vtkIdType GetSize() const { return this->Cells.size(); }
  Row<Id> GetPoints(vtkIdType i) const
  {
    const auto& cell = this->Cells[i];
    return { cell.Vertices.data(), cell.Vertices.data() + cell.Dimension + 1 };
  }
  vtkIdType GetInputCell(vtkIdType i) const
  {
    return this->Mesh.GetInputCell(this->Cells[i].Input);
  }
  int GetLevel(vtkIdType i) const { return this->Cells[i].Level; }
  /// Red steps since the input.
  int GetSteps(vtkIdType i) const
  {
    return this->Cells[i].Level - this->View.GetLevel(this->Cells[i].Input);
  }
  bool IsOver(vtkIdType) const { return false; }
  bool IsOwn(vtkIdType i) const
  {
    return this->Mesh.GetScope(this->Cells[i].Input) == CellScope::Own;
  }
  RedGreenLeaf<Id> GetLeaf(vtkIdType i) const { return this->Cells[i].Leaf; }

private:
  const RedGreenMesh& Mesh;
  const SimplexView View;
  const Buffer<RedGreenOutputCell<Id>> Cells;
};

/// The findings of a round that the user is told.
struct MarkNotes
{
  /// Edges of the input with a value that is not finite.
  std::vector<std::pair<vtkIdType, vtkIdType>> WithoutValue;
  /// Marks that were dropped, because no number lies between the ends of an edge.
  vtkIdType TooShort = 0;
};

/// `limitError(a, b)`: the error of an edge for criteria that ask for the limit, negative where a
/// value is not finite.
template <typename Id, typename Cells, typename LimitError>
class MarkFinder
{
public:
  using Mark = RefinementMark<Id>;

  MarkFinder(const Cells& cells, const RefinementCriteria& criteria, int maximumLevel,
    const LimitError& limitError)
    : Candidates(cells)
    , Criteria(criteria)
    , MaximumLevel(maximumLevel)
    , ErrorAtLimit(limitError)
  {
  }

  /// The marks, in the order of the cells.
  std::vector<Mark> Run(MarkNotes& notes) const
  {
    // A function that threads may not evaluate is evaluated before them, for a stretch of cells at
    // a time.
    const bool isSerial = this->Criteria.ReadsFunction() && !this->Criteria.IsFunctionForThreads();
    const vtkIdType size = this->Candidates.GetSize();
    const vtkIdType stretch = std::min(size, isSerial ? vtkIdType(65536) : size);
    Buffer<double> centroids(isSerial ? 3 * stretch : 0);
    Buffer<double> values(isSerial ? stretch : 0);
    std::vector<Mark> marks;
    for (vtkIdType begin = 0; begin < size; begin += stretch)
    {
      const vtkIdType end = std::min(size, begin + stretch);
      if (isSerial)
      {
        this->Criteria.EvaluateFunction(this->Candidates, begin, end, centroids, values);
      }
      this->Look(begin, end, values, marks, notes);
    }
    return marks;
  }

private:
  static constexpr vtkIdType CandidatesPerBlock = 1024;

  struct Found
  {
    std::vector<Mark> Marks;
    MarkNotes Notes;

    void Clear()
    {
      this->Marks.clear();
      this->Notes = MarkNotes();
    }
  };

  /// Looks at cells in threads; `values`: the function's, if threads may not evaluate it.
  void Look(vtkIdType begin, vtkIdType end, const Buffer<double>& values, std::vector<Mark>& marks,
    MarkNotes& notes) const
  {
    std::vector<Found> found((end - begin + CandidatesPerBlock - 1) / CandidatesPerBlock);
    const auto blocks = [&](vtkIdType firstBlock, vtkIdType lastBlock)
    {
      const bool reads = this->Criteria.ReadsFunction() && values.empty();
      Buffer<double> centroids(reads ? 3 * CandidatesPerBlock : 0);
      Buffer<double> own(reads ? CandidatesPerBlock : 0);
      Found here; // keeps its memory from block to block: lists that grow take longer than looking
      for (vtkIdType block = firstBlock; block < lastBlock; ++block)
      {
        const vtkIdType first = begin + block * CandidatesPerBlock;
        const vtkIdType last = std::min(end, first + CandidatesPerBlock);
        const double* value = values.empty() ? nullptr : values.data() + block * CandidatesPerBlock;
        if (reads)
        {
          this->Criteria.EvaluateFunction(this->Candidates, first, last, centroids, own);
          value = own.data();
        }
        here.Clear();
        this->LookAtBlock(first, last, value, here);
        found[block] = here;
      }
    };
    ForRangesOfBlocks(static_cast<vtkIdType>(found.size()), blocks);
    std::size_t size = marks.size();
    for (const Found& part : found)
    {
      size += part.Marks.size();
    }
    if (size > marks.capacity()) // at once: to grow a long list copies it without a stop
    {
      marks.reserve(std::max(size, 2 * marks.capacity()));
    }
    for (Found& part : found)
    {
      marks.insert(marks.end(), part.Marks.begin(), part.Marks.end());
      notes.WithoutValue.insert(
        notes.WithoutValue.end(), part.Notes.WithoutValue.begin(), part.Notes.WithoutValue.end());
      notes.TooShort += part.Notes.TooShort;
      part = Found();
      BetweenLoops::Act();
    }
  }

  /// `value`: the function's at these cells, or null.
  void LookAtBlock(vtkIdType first, vtkIdType last, const double* value, Found& found) const
  {
    const bool isFunctionAll = this->Criteria.ReadsFunctionOnly();
    for (vtkIdType i = first; i < last; ++i)
    {
      const double* own = value ? value + (i - first) : nullptr;
      if (!isFunctionAll || *own <= 0.)
      {
        this->LookAt(i, this->Candidates.GetPoints(i), own, found);
      }
    }
  }

  template <typename Points>
  void LookAt(vtkIdType i, const Points& points, const double* value, Found& found) const
  {
    if (points.size() < 2 || !this->Candidates.IsOwn(i))
    {
      return;
    }
    const double cellError = this->Criteria.GetCellError(this->Candidates, i, points, value);
    if (!(cellError > 1.) && !this->Criteria.ReadsEdges())
    {
      return;
    }
    if (this->Candidates.GetSteps(i) >= this->MaximumLevel ||
      this->Candidates.GetLevel(i) >= LastLevel || this->Candidates.IsOver(i))
    {
      return;
    }
    if (cellError > 1.)
    {
      this->MarkCell(i, points, cellError, found);
    }
    if (this->Criteria.ReadsEdges())
    {
      this->LookAtEdges(i, points, cellError > 1., found);
    }
  }

  template <typename Points>
  void MarkCell(vtkIdType i, const Points& points, double error, Found& found) const
  {
    bool tooShort = false;
    for (auto a = points.begin(); a != points.end(); ++a)
    {
      for (auto b = a + 1; b != points.end(); ++b)
      {
        tooShort = tooShort || this->Criteria.IsTooShort(*a, *b);
      }
    }
    found.Notes.TooShort += tooShort ? 1 : 0;
    if (!tooShort)
    {
      found.Marks.push_back({ error, this->Candidates.GetLeaf(i), { -1, -1 } });
    }
  }

  template <typename Points>
  void LookAtEdges(vtkIdType i, const Points& points, bool isMarked, Found& found) const
  {
    for (auto a = points.begin(); a != points.end(); ++a)
    {
      for (auto b = a + 1; b != points.end(); ++b)
      {
        const auto first = static_cast<Id>(*a);
        const auto second = static_cast<Id>(*b);
        bool hasNoValue = false;
        double error = this->Criteria.GetEdgeError(first, second, hasNoValue);
        const double atLimit = this->ErrorAtLimit(first, second);
        hasNoValue = hasNoValue || atLimit < 0.;
        error = std::max(error, atLimit);
        if (hasNoValue && this->Candidates.IsInput())
        {
          found.Notes.WithoutValue.emplace_back(std::min(first, second), std::max(first, second));
        }
        if (error > 1. && !isMarked)
        {
          const bool isShort = this->Criteria.IsTooShort(first, second);
          found.Notes.TooShort += isShort ? 1 : 0;
          if (!isShort)
          {
            found.Marks.push_back({ error, this->Candidates.GetLeaf(i), { first, second } });
          }
        }
      }
    }
  }

  const Cells& Candidates;
  const RefinementCriteria& Criteria;
  const int MaximumLevel;
  const LimitError& ErrorAtLimit;
};

template <typename Id, typename Cells, typename LimitError>
std::vector<RefinementMark<Id>> FindMarks(const Cells& cells, const RefinementCriteria& criteria,
  int maximumLevel, const LimitError& limitError, MarkNotes& notes)
{
  return MarkFinder<Id, Cells, LimitError>(cells, criteria, maximumLevel, limitError).Run(notes);
}

}

#endif
