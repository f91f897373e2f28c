// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file HybridLocal.h
 * The local matrix at a vertex of a level (HybridLimits.h).
 */
#ifndef SubdivisionObjects_HybridLocal_h
#define SubdivisionObjects_HybridLocal_h

#include "Core/Operators/LocalRows.h"
#include "Core/Solids/Hybrid/HybridPatch.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace subdivision
{

/// The rows of the items at a vertex. These are the corners of the star by number, or those of the
/// star some steps later, in the same order.
struct LocalItems
{
  LocalRows Rows;
  /// Of each item after the first step, the cell of the star and its local point.
  std::vector<std::array<int, 2>> Points;
  std::vector<LocalRows> Steps; ///< the items of each further step by those of the one before

  int CountSteps() const
  {
    return static_cast<int>(this->Steps.size()) + (this->Points.empty() ? 0 : 1);
  }
  /// Weights of the items as weights of those of the first step.
  std::vector<double> StepBack(std::vector<double> weights) const
  {
    for (auto step = this->Steps.rbegin(); step != this->Steps.rend(); ++step)
    {
      weights = step->Sum(weights);
    }
    return weights;
  }
};

/// Reads the rows at a vertex as a local matrix.
template <typename Id>
class LocalReader
{
public:
  explicit LocalReader(typename HybridRows<Id>::AddRow addRow)
    : AddRow(std::move(addRow))
  {
  }

  /// Passes the entries of a row.
  template <typename Act>
  void ForEntries(vtkIdType row, const Act& act)
  {
    this->Block.Clear();
    this->AddRow(row, this->Block);
    const Id* columns = this->Block.GetColumns();
    const double* weights = this->Block.GetWeights();
    for (std::size_t k = 0; k < this->Block.GetNumberOfEntries(); ++k)
    {
      act(columns[k], weights[k]);
    }
  }

  /// The new point that takes the place of each corner of a star. False: two of them would take
  /// that of one, as cells share two corners and no edge between them.
  static bool FindMiddles(const HybridPatch<Id>& star, std::vector<vtkIdType>& middles)
  {
    middles.assign(star.Numbers.Vertices.size(), vtkIdType(-1));
    bool isSure = true;
    for (const StarCell<Id>& cell : star.Cells)
    {
      for (int i = 0; i < cell.GetTable().Corners; ++i)
      {
        const vtkIdType row =
          GetNewPoint(star.GetComplex(), cell, GetMiddle(cell.Shape, cell.Place, i));
        vtkIdType& middle = middles[static_cast<std::size_t>(star.Numbers.Find(cell.Corners[i]))];
        isSure = isSure && (middle < 0 || middle == row);
        middle = row;
      }
    }
    return isSure;
  }

  /// The rows of some new points over the corners of a star.
  LocalRows Read(const HybridPatch<Id>& star, const std::vector<vtkIdType>& middles)
  {
    LocalRows local;
    for (const vtkIdType row : middles)
    {
      this->ForEntries(row,
        [&](Id column, double weight)
        {
          const std::ptrdiff_t number = star.Numbers.Find(column);
          number >= 0 ? local.Add(static_cast<int>(number), weight) : void();
        });
      local.EndRow();
    }
    return local;
  }

  /// The rows of new points over a whole level.
  LocalRows Read(const std::vector<Id>& points)
  {
    LocalRows local;
    for (const Id row : points)
    {
      this->ForEntries(
        row, [&](Id column, double weight) { local.Add(static_cast<int>(column), weight); });
      local.EndRow();
    }
    return local;
  }

  /// Where new points lie in the cells of a star; `own`: the level of the star alone.
  static std::vector<std::array<int, 2>> LocatePoints(
    const HybridPatch<Id>& star, const CellComplex<Id>& own, const VertexNumbers<Id>& points)
  {
    std::vector<std::array<int, 2>> places(points.Vertices.size());
    for (std::size_t c = 0; c < star.Cells.size(); ++c)
    {
      const Id first = own.Cells.GetCorners(static_cast<vtkIdType>(c))[0];
      const StarCell<Id> cell = GetStarCell(own, static_cast<vtkIdType>(c), first);
      for (int p = 0; p < static_cast<int>(cell.GetTable().Points.size()); ++p)
      {
        const std::ptrdiff_t number = points.Find(static_cast<Id>(GetNewPoint(own, cell, p)));
        if (number >= 0)
        {
          places[static_cast<std::size_t>(number)] = { { static_cast<int>(c), p } };
        }
      }
    }
    return places;
  }
  /// The item at the far end of an edge, or in the opposite corner of a quad, of which `middle` is
  /// the new point.
  static int FindItem(const HybridPatch<Id>& star, const std::vector<std::array<int, 2>>& points,
    Id end, vtkIdType middle)
  {
    if (points.empty())
    {
      return static_cast<int>(star.Numbers.Find(end));
    }
    const auto found = std::find_if(points.begin(), points.end(),
      [&](const std::array<int, 2>& point)
      {
        const StarCell<Id>& cell = star.Cells[static_cast<std::size_t>(point[0])];
        return GetNewPoint(star.GetComplex(), cell, point[1]) == middle;
      });
    return static_cast<int>(found - points.begin());
  }

  /// Passes a weighted sum of items of the first step over the level: add(column, weight).
  template <typename Add>
  void AddItems(const HybridPatch<Id>& star, const std::vector<std::array<int, 2>>& points,
    const double* weights, std::size_t size, const Add& add)
  {
    for (std::size_t k = 0; k < size; ++k)
    {
      if (points.empty())
      {
        add(star.Numbers.Vertices[k], weights[k]);
        continue;
      }
      const StarCell<Id>& cell = star.Cells[static_cast<std::size_t>(points[k][0])];
      this->ForEntries(GetNewPoint(star.GetComplex(), cell, points[k][1]),
        [&](Id column, double weight) { add(column, weights[k] * weight); });
    }
  }

private:
  const typename HybridRows<Id>::AddRow AddRow;
  RowBlock<Id> Block;
};

/// The items of a star at the first level where nothing is sharp at the vertex, at the earliest of
/// the next one.
template <typename Id>
LocalItems ReadLaterItems(const HybridPatch<Id>& star)
{
  LocalItems items;
  HybridLevel<Id> here = star.MakeLevel();
  for (bool isFirst = true;; isFirst = false)
  {
    const HybridLevel<Id> next = RefineHybrid(here, HybridRules::Smooth);
    HybridPatch<Id> later(next);
    later.ReadStar(0);
    const std::vector<Id>& points = later.Numbers.Vertices;
    if (isFirst)
    {
      items.Points = LocalReader<Id>::LocatePoints(star, here.Complex, later.Numbers);
    }
    else
    {
      const HybridRows<Id> rows(here, HybridRules::Smooth);
      items.Steps.push_back(LocalReader<Id>(rows.StartRows()).Read(points));
    }
    if (later.GetSharpSteps() <= 0.)
    {
      const HybridRows<Id> rows(next, HybridRules::Smooth);
      std::vector<vtkIdType> middles;
      LocalReader<Id>::FindMiddles(later, middles);
      items.Rows = LocalReader<Id>(rows.StartRows()).Read(later, middles);
      return items;
    }
    here = later.MakeLevel();
  }
}

/// The items of a star; `reader`: of its level.
template <typename Id>
LocalItems ReadLocalItems(const HybridPatch<Id>& star, LocalReader<Id>& reader)
{
  std::vector<vtkIdType> middles;
  const bool hasApex = std::any_of(
    star.Cells.begin(), star.Cells.end(), [](const auto& cell) { return cell.IsApex(); });
  if (hasApex || star.ChangesOnce() || star.GetSharpSteps() > 0. ||
    !LocalReader<Id>::FindMiddles(star, middles))
  {
    return ReadLaterItems(star);
  }
  return { reader.Read(star, middles), {}, {} };
}

}

#endif
