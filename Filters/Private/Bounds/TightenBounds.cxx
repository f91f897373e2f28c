// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Bounds/TightenBounds.h"

#include "Core/Memory/UnevenRanges.h"
#include "Private/Bounds/StepFactors.h"
#include "Private/Bounds/VectorRanges.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace subdivision
{
namespace
{

using Part = PartsAsCells::Part;

int CountFurtherSteps(const NestedPieces& pieces, vtkIdType cell)
{
  const int dimension = pieces.GetDimension(cell);
  return pieces.HasThirds() ? MostFurtherStepsInThirds[dimension] : MostFurtherSteps[dimension];
}

/// Whether further steps may bring a bound near: not where the truth is rounding, or much smaller.
bool CanHelp(const CellBound& bound, const NestedPieces& pieces, vtkIdType cell, double rounding)
{
  const double ofStep = pieces.HasThirds() ? 9. : 4.;
  return bound.Least > 16. * rounding &&
    bound.Largest <= NearBound * bound.Least * std::pow(ofStep, CountFurtherSteps(pieces, cell));
}

class Tightener
{
public:
  Tightener(const SplitCells& split, std::vector<CellBound>& bounds)
    : Split(split)
    , Bounds(bounds)
    , Settled(bounds.size(), 0.)
  {
  }
  bool Run(const SteppedPieces& pieces, const BoundedValues& values)
  {
    Parts parts;
    for (const vtkIdType cell : InTurn(pieces.Pieces.GetNumberOfCells()))
    {
      const CellBound& bound = this->Bounds[cell];
      if (!IsNear(bound.Largest, bound.Least, values.Rounding) &&
        CanHelp(bound, pieces.Pieces, cell, values.Rounding))
      {
        this->AddParts(pieces.Pieces, cell, cell, bound, values.Rounding, parts);
      }
    }
    const std::vector<vtkIdType> roots = parts.Roots;
    if (!this->Look(pieces, values, parts, 1))
    {
      return false;
    }
    for (const vtkIdType root : InTurn(roots))
    {
      this->Bounds[root].Largest = std::min(this->Bounds[root].Largest, this->Settled[root]);
    }
    return true;
  }

private:
  /// Parts of cells at one step, each with the cell of the mesh in which it lies.
  struct Parts
  {
    std::vector<Part> Wanted;
    std::vector<vtkIdType> Roots;
  };
  /// About so many parts are looked at together, so that their memory is small. Where edges are cut
  /// into thirds all triangles at a part are cut out with it, at a vertex of many again each time.
  static constexpr std::size_t Batch = 64;
  static constexpr std::size_t BatchInThirds = 512;
  /// Adds the children of a cell that have pieces whose bounds are not near.
  void AddParts(const NestedPieces& pieces, vtkIdType cell, vtkIdType root, const CellBound& bound,
    double rounding, Parts& parts)
  {
    const auto children = static_cast<int>(pieces.GetLattice(cell).Children.size());
    const auto size = static_cast<std::ptrdiff_t>(bound.OfPieces.size()) / children;
    double& settled = this->Settled[root];
    if (size == 0)
    {
      settled = std::max(settled, bound.Largest);
      return;
    }
    for (int child = 0; child < children; ++child)
    {
      const auto begin = bound.OfPieces.begin() + child * size;
      const double most = *std::max_element(begin, begin + size);
      if (IsNear(most, this->Bounds[root].Least, rounding))
      {
        settled = std::max(settled, most);
        continue;
      }
      parts.Wanted.push_back({ cell, child });
      parts.Roots.push_back(root);
    }
  }
  bool Look(
    const SteppedPieces& pieces, const BoundedValues& values, const Parts& parts, int further)
  {
    const int components = values.Components;
    const std::size_t batch = pieces.Pieces.HasThirds() ? BatchInThirds : Batch;
    std::size_t end = 0;
    for (std::size_t begin = 0; begin < parts.Wanted.size(); begin = end)
    {
      // All parts of a cell together: its bound does not depend on other cells.
      while (end < parts.Wanted.size() &&
        (end < begin + batch || parts.Roots[end] == parts.Roots[end - 1]))
      {
        ++end;
      }
      const std::unique_ptr<PartsAsCells> deeper = this->Split(pieces,
        { parts.Wanted.begin() + static_cast<std::ptrdiff_t>(begin),
          parts.Wanted.begin() + static_cast<std::ptrdiff_t>(end) });
      if (!deeper)
      {
        return false;
      }
      const SteppedPieces made = deeper->Get();
      const Buffer<double> next = deeper->Take(1, values.Second, components);
      const Buffer<double> second = deeper->Take(2, values.Third, components);
      const auto step = [&](const Buffer<double>& before)
      { return ApplyFactors(made.Last, before, components); };
      const Buffer<double> third = step(second);
      std::vector<double> shown(components * deeper->GetCorners().size(), 0.);
      for (std::size_t i = 0; i < deeper->GetCorners().size(); ++i)
      {
        const auto& [cell, point] = deeper->GetCorners()[i];
        AddShown(pieces.Pieces, values, cell, point, 1., shown.data() + components * i);
      }
      const BoundedValues ofParts{ components, shown.data(), next, second, third, step,
        values.Rounding };
      const std::vector<CellBound> found =
        FindBounds(made.Pieces, made.AllSectors, ofParts, deeper->GetWanted());
      for (std::size_t i = 0; i < found.size(); ++i)
      {
        double& least = this->Bounds[parts.Roots[begin + i]].Least;
        least = std::max(least, found[i].Least);
      }
      Parts left;
      for (std::size_t i = 0; i < found.size(); ++i)
      {
        const vtkIdType root = parts.Roots[begin + i];
        const vtkIdType cell = deeper->GetWanted()[i];
        if (further == CountFurtherSteps(made.Pieces, cell))
        {
          this->Settled[root] = std::max(this->Settled[root], found[i].Largest);
          continue;
        }
        this->AddParts(made.Pieces, cell, root, found[i], values.Rounding, left);
      }
      if (!this->Look(made, ofParts, left, further + 1))
      {
        return false;
      }
    }
    return true;
  }

  const SplitCells& Split;
  std::vector<CellBound>& Bounds;
  std::vector<double> Settled; ///< the largest bound of parts that are not looked at any more
};

/// The distances of points that are known to be on the limit.
void AddSamples(const NestedPieces& pieces, const BoundedValues& values,
  const Buffer<double>& limits, std::vector<CellBound>& bounds)
{
  ForUnevenRanges(pieces.GetNumberOfCells(),
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<double> difference(static_cast<std::size_t>(values.Components));
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        CellBound& bound = bounds[cell];
        if (IsNear(bound.Largest, bound.Least, values.Rounding))
        {
          continue;
        }
        double most = 0.;
        const vtkIdType first = pieces.GetFirstPlace(cell);
        for (vtkIdType place = first; place < pieces.GetFirstPlace(cell + 1); ++place)
        {
          const vtkIdType point = pieces.GetPoint(place);
          if (values.Components * point < limits.size())
          {
            std::copy_n(
              limits.data() + values.Components * point, values.Components, difference.data());
            AddShown(pieces, values, cell, static_cast<int>(place - first), -1., difference.data());
            most = std::max(most, GetNorm(difference.data(), values.Components));
          }
        }
        bound.Least = std::max(bound.Least, most - values.Rounding);
        if (pieces.GetDimension(cell) == 0)
        {
          bound.Largest = std::min(bound.Largest, most + values.Rounding);
        }
      }
    });
}

}

bool TightenBounds(const SteppedPieces& pieces, const SplitCells& split,
  const BoundedValues& values, const Buffer<double>& limits, std::vector<CellBound>& bounds)
{
  if (!limits.empty())
  {
    AddSamples(pieces.Pieces, values, limits, bounds);
  }
  return Tightener(split, bounds).Run(pieces, values);
}

}
