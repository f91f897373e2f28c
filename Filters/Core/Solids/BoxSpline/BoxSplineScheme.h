// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BoxSplineScheme.h
 * The box-spline scheme as a SolidScheme: eight tetrahedra in each tetrahedron.
 */
#ifndef SubdivisionObjects_BoxSplineScheme_h
#define SubdivisionObjects_BoxSplineScheme_h

#include "Core/Solids/BoxSpline/BoxSplineSplit.h"
#include "Core/Solids/BoxSpline/BoxSplineStar.h"
#include "Core/Solids/BoxSpline/RefinedCells.h"
#include "Core/Solids/BoxSpline/Refinement.h"
#include "Core/Solids/Scheme/ChildRows.h"
#include "Core/Solids/Scheme/SolidScheme.h"
#include "Core/Solids/Scheme/SolidTurns.h"

#include <memory>
#include <vector>

namespace subdivision
{

template <typename IdType>
struct BoxSplineScheme
{
  using Id = IdType;
  using Level = subdivision::Level<Id>;
  using ChildRows = subdivision::ChildRows<BoxSplineSplit<Id>>;
  using Star = BoxSplineStar<Id>;

  static LevelCounts RefineCounts(const LevelCounts& counts)
  {
    return { counts.Vertices + counts.Edges, 2 * counts.Edges + 3 * counts.Faces + counts.Tets,
      4 * counts.Faces + 8 * counts.Tets, 8 * counts.Tets };
  }
  static double CountMoreIds(const LevelCounts&) { return 0.; }
  static constexpr SchemeTraits Traits = { 0, true, false, RefineCounts, CountMoreIds,
    ListBoxSplineVertices };

  static Level Start(Level&& control) { return std::move(control); }
  static void CountSolids(const Level&, LevelCounts&) {}
  static Id CountCentres(const Level&) { return 0; }
  static int CountSteps(const Level&) { return 0; }

  template <typename Out, typename T>
  static void WriteChildren(const Level& level, const std::vector<CellRun>& runs, int steps,
    const T* points, const CellStorage<Out>& out)
  {
    steps == 1 ? subdivision::WriteChildren(level.Complex, runs, out, 3, points)
               : WriteGrandchildren(level.Complex, runs, out, 3, Id(0), points);
  }
  static bool HasCells(
    const Level& level, const std::vector<CellRun>& runs, const SimplexList& cells)
  {
    return subdivision::HasCells(level.Complex, runs, cells);
  }
  static std::vector<vtkIdType> FindParents(
    const Level&, const std::vector<CellRun>&, const SimplexList&)
  {
    return {};
  }

  static const std::shared_ptr<const Buffer<Id>>& GetSpokes(const Level&) { return NoSpokes; }
  static int GetTurn(const Level& level, Id tet, const Id (&triangle)[3])
  {
    return GetTurnOnTet(level.Complex, tet, triangle);
  }
  class ControlTets
  {
  public:
    ControlTets(const Level&, int steps)
      : Shift(3 * steps)
    {
    }
    vtkIdType Find(Id tet) const { return static_cast<vtkIdType>(tet) >> this->Shift; }

  private:
    int Shift;
  };

private:
  static inline const std::shared_ptr<const Buffer<Id>> NoSpokes;
};

template <typename Id>
struct SchemeOfLevel<Level<Id>>
{
  using Type = BoxSplineScheme<Id>;
};

}

#endif
