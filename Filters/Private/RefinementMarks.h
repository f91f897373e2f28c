// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RefinementMarks.h
 * What criteria mark among the cells that a red-green state shows them.
 */
#ifndef SubdivisionObjects_RefinementMarks_h
#define SubdivisionObjects_RefinementMarks_h

#include "Core/RedGreen.h"
#include "RedGreenMesh.h"
#include "RefinementCriteria.h"

#include <utility>
#include <vector>

namespace subdivision
{

/// An edge of a leaf, or the whole leaf.
template <typename Id>
struct RefinementMark
{
  double Error = 0.; ///< as a multiple of what is allowed
  RedGreenLeaf<Id> Leaf;
  Id Ends[2] = { -1, -1 }; ///< -1: all edges
};

/// The cells of the input that are not red.
template <typename Id>
class InputCandidates
{
public:
  InputCandidates(const RedGreenMesh& mesh, const RedGreen<Id>& state)
    : Mesh(mesh)
    , State(state)
    , View(mesh.GetView())
    , Places(this->View)
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
  bool IsOver(vtkIdType i) const { return this->State.IsRed(static_cast<Id>(i)); }
  RedGreenLeaf<Id> GetLeaf(vtkIdType i) const { return { static_cast<Id>(i), -1 }; }

private:
  const RedGreenMesh& Mesh;
  const RedGreen<Id>& State;
  const SimplexView View;
  const SimplexPlaces Places;
};

/// The cells that the last round changed, but for those that cannot be refined further.
template <typename Id>
class ChangedCandidates
{
public:
  ChangedCandidates(const RedGreenMesh& mesh, const RedGreen<Id>& state, int maximumLevel)
    : Mesh(mesh)
    , View(mesh.GetView())
    , Cells(state.GetChangedCells())
  {
    const auto isFinal = [&](const RedGreenOutputCell<Id>& cell)
    { return cell.Level - this->View.GetLevel(cell.Input) >= maximumLevel; };
    this->Cells.erase(
      std::remove_if(this->Cells.begin(), this->Cells.end(), isFinal), this->Cells.end());
  }
  bool IsInput() const { return false; }
  vtkIdType GetSize() const { return static_cast<vtkIdType>(this->Cells.size()); }
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
  RedGreenLeaf<Id> GetLeaf(vtkIdType i) const { return this->Cells[i].Leaf; }

private:
  const RedGreenMesh& Mesh;
  const SimplexView View;
  std::vector<RedGreenOutputCell<Id>> Cells;
};

/// What a round found beside marks.
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
std::vector<RefinementMark<Id>> FindMarks(const Cells& cells, const RefinementCriteria& criteria,
  int maximumLevel, const LimitError& limitError, MarkNotes& notes)
{
  enum
  {
    MarksCell = 1,
    MarksEdges = 2,
    HasNoValue = 4
  };
  auto forEdges = [&](vtkIdType i, const auto& act)
  {
    const auto points = cells.GetPoints(i);
    for (auto a = points.begin(); a != points.end(); ++a)
    {
      for (auto b = a + 1; b != points.end(); ++b)
      {
        bool hasNoValue = false;
        double error = criteria.GetEdgeError(*a, *b, hasNoValue);
        const double atLimit = limitError(static_cast<Id>(*a), static_cast<Id>(*b));
        hasNoValue = hasNoValue || atLimit < 0.;
        error = std::max(error, atLimit);
        act(static_cast<Id>(*a), static_cast<Id>(*b), error, hasNoValue);
      }
    }
  };
  std::vector<RefinementMark<Id>> marks;
  auto mark = [&](vtkIdType i, int flags, double cellError)
  {
    bool tooShort = false;
    forEdges(i,
      [&](Id a, Id b, double error, bool hasNoValue)
      {
        const bool isShort = criteria.IsTooShort(a, b);
        tooShort = tooShort || isShort;
        if (hasNoValue && cells.IsInput())
        {
          notes.WithoutValue.emplace_back(std::min(a, b), std::max(a, b));
        }
        if (error > 1. && !(flags & MarksCell))
        {
          notes.TooShort += isShort ? 1 : 0;
          if (!isShort)
          {
            marks.push_back({ error, cells.GetLeaf(i), { a, b } });
          }
        }
      });
    if (flags & MarksCell)
    {
      notes.TooShort += tooShort ? 1 : 0;
      if (!tooShort)
      {
        marks.push_back({ cellError, cells.GetLeaf(i), { -1, -1 } });
      }
    }
  };
  // Stretch by stretch, so that what is known of cells stays in the cache.
  constexpr vtkIdType stretch = 262144;
  const bool readsEdges = criteria.ReadsEdges();
  Buffer<double> errors(std::min(stretch, cells.GetSize()));
  Buffer<unsigned char> found(errors.size());
  for (vtkIdType begin = 0; begin < cells.GetSize(); begin += stretch)
  {
    const vtkIdType size = std::min(stretch, cells.GetSize() - begin);
    criteria.GetCellErrors(cells, begin, size, errors);
    ForEach(size,
      [&](vtkIdType at)
      {
        const vtkIdType i = begin + at;
        int flags = 0;
        if (!cells.IsOver(i) && cells.GetSteps(i) < maximumLevel && cells.GetLevel(i) < LastLevel &&
          cells.GetPoints(i).size() > 1)
        {
          flags = errors[at] > 1. ? MarksCell : 0;
          if (readsEdges)
          {
            forEdges(i,
              [&flags](Id, Id, double error, bool hasNoValue)
              { flags |= (error > 1. ? MarksEdges : 0) | (hasNoValue ? HasNoValue : 0); });
          }
        }
        found[at] = static_cast<unsigned char>(flags);
      });
    for (vtkIdType at = 0; at < size; ++at)
    {
      if (found[at] != 0)
      {
        mark(begin + at, found[at], errors[at]);
      }
    }
  }
  return marks;
}

}

#endif
