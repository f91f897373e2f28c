// SPDX-License-Identifier: BSD-3-Clause
// A uniform subdivision of which only some cells go on: each level keeps them and the cells on
// which they depend.
#include "Private/Uniform/UniformRun.h"

#include "Core/Memory/CellSplits.h"
#include "Core/Memory/Loops.h"
#include "Core/Operators/BlockOperator.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Limits/Restriction.h"

#include <algorithm>
#include <type_traits>

namespace subdivision
{
namespace
{

/// A limit depends on the neighbours of its vertex. Each step back adds neighbours of these, but
/// they lie twice as near.
constexpr int MostDistance = 4;

/// The cells of runs that have a flag.
std::vector<CellRun> TakeFlagged(const std::vector<CellRun>& runs, const std::vector<char>& flags)
{
  std::vector<CellRun> taken;
  auto flag = flags.begin();
  for (const CellRun& run : runs)
  {
    bool isFirst = true;
    for (const vtkIdType i : InTurn(run.Count))
    {
      if (!*flag++)
      {
        isFirst = true;
        continue;
      }
      if (isFirst)
      {
        taken.push_back(run);
        taken.back().First += i;
        taken.back().Count = 0;
      }
      ++taken.back().Count;
      isFirst = false;
    }
  }
  return RefineRuns(taken, 0);
}

/// Flags the vertices of the cells of runs with 1, and vertices within `distance` edges of them
/// with larger numbers.
template <typename Id>
Buffer<unsigned char> FlagVertices(
  const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs, int distance)
{
  Buffer<unsigned char> flags(complex.NumberOfVertices, 0);
  const Buffer<Id>* const corners[4] = { &complex.VertexCells, &complex.EdgeVertices,
    &complex.FaceVertices, &complex.TetVertices };
  for (const CellRun& run : runs)
  {
    const vtkIdType size = run.Dimension + 1;
    const Id* const first = corners[run.Dimension]->data() + size * run.First;
    std::for_each(first, first + size * run.Count, [&](Id vertex) { flags[vertex] = 1; });
  }
  for (int step = 1; step <= distance; ++step)
  {
    ForEachInTurn(complex.NumberOfEdges,
      [&](vtkIdType e)
      {
        const Id* ends = complex.EdgeVertices.data() + 2 * e;
        for (int i = 0; i < 2; ++i)
        {
          if (flags[ends[i]] == step && flags[ends[1 - i]] == 0)
          {
            flags[ends[1 - i]] = static_cast<unsigned char>(step + 1);
          }
        }
      });
  }
  return flags;
}

}

/// Lists the cells that go on, if the run can make them alone: all that it writes depends on these
/// and their neighbours, in the same way on each level.
bool UniformRun::FindSplit()
{
  const UniformOptions& options = this->Options;
  const SimplicesOfCells& all = this->Mesh.Cells;
  if (!options.Splits || options.Scheme != StampScheme::BoxSpline || this->Others ||
    options.Factors || options.HasFrames() || options.GenerateClassification ||
    options.KeepsCopies || this->Points->HasWeights())
  {
    return false;
  }
  this->Split = SimplicesOfCells();
  this->Split.Simplices.Dimensions = all.Simplices.Dimensions;
  for (const vtkIdType s : InTurn(all.Simplices.GetNumberOfSimplices()))
  {
    this->Split.ParentCells.push_back(all.ParentCells.empty() ? s : all.ParentCells[s]);
  }
  for (const std::vector<char>& flags : options.Splits->Flags)
  {
    SimplicesOfCells children;
    auto flag = flags.begin();
    for (const std::size_t s : InTurn(this->Split.ParentCells.size()))
    {
      const unsigned char dimension = this->Split.Simplices.Dimensions[s];
      for (int child = 0; child < 1 << dimension; ++child)
      {
        if (flag == flags.end())
        {
          return false;
        }
        if (*flag++)
        {
          children.Simplices.Dimensions.push_back(dimension);
          children.ParentCells.push_back(this->Split.ParentCells[s]);
        }
      }
    }
    this->Split = std::move(children);
  }
  return true;
}

/// Whether a level that was built has no rules that depend on cells far away.
bool UniformRun::IsLocal() const
{
  return std::visit([](const auto& level) { return !HasEqualCells(level.Complex); }, this->Current);
}

/// Leaves of the level after `step` steps the cells that go on and, where no semi-sharp rule holds
/// any more, their surroundings: their limits depend on no more.
template <typename Scheme>
void UniformRun::Narrow(typename Scheme::Level& level, int step)
{
  using Id = typename Scheme::Id;
  if constexpr (std::is_same<typename Scheme::Level, Level<Id>>::value)
  {
    const std::vector<std::vector<char>>& flags = this->Options.Splits->Flags;
    if (step <= static_cast<int>(flags.size()))
    {
      this->Control.Runs = TakeFlagged(this->Control.Runs, flags[step - 1]);
      this->Control.DerivedRuns.clear();
    }
    if (!IsSharpAfter(this->Control.Sharpness, step))
    {
      const int distance = std::min(this->Options.Levels - step, MostDistance);
      const Buffer<unsigned char> at = FlagVertices(level.Complex, this->Control.Runs, distance);
      const Restriction<Level<Id>> part(level, at);
      const Buffer<Id>& old = part.GetOldVertices();
      this->Points->Take(
        BlockOperator<Id>(level.Complex.NumberOfVertices, old.size(),
          [&old](vtkIdType begin, vtkIdType end, RowBlock<Id>& rows)
          {
            for (; begin < end; ++begin)
            {
              rows.Add(old[begin], 1.);
              rows.EndRow();
            }
          }),
        [&old](vtkIdType row) { return static_cast<vtkIdType>(old[row]); }, old.size());
      for (CellRun& run : this->Control.Runs)
      {
        const auto& of = run.Dimension == 1 ? part.GetNewEdges()
          : run.Dimension == 2              ? part.GetNewFaces()
                                            : part.GetNewTets();
        run.First = of[run.First];
      }
      level = part.Restrict();
    }
  }
}

#define SUBDIVISION_NARROW(Scheme) template void UniformRun::Narrow<Scheme>(Scheme::Level&, int)
SUBDIVISION_FOR_VOLUME_SCHEMES(SUBDIVISION_NARROW);

}
