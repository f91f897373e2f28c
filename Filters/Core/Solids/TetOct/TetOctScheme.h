// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TetOctScheme.h
 * The tet/oct scheme as a SolidScheme: its solids are tetrahedra and octahedra, and an octahedron
 * is written as four tetrahedra around its shortest diagonal.
 */
#ifndef SubdivisionObjects_TetOctScheme_h
#define SubdivisionObjects_TetOctScheme_h

#include "Core/Solids/Scheme/ChildRows.h"
#include "Core/Solids/Scheme/SolidScheme.h"
#include "Core/Solids/Scheme/SolidTurns.h"
#include "Core/Solids/TetOct/TetOctCells.h"
#include "Core/Solids/TetOct/TetOctSplit.h"
#include "Core/Solids/TetOct/TetOctStar.h"

#include <array>
#include <memory>
#include <vector>

namespace subdivision
{

template <typename IdType>
struct TetOctScheme
{
  using Id = IdType;
  using Level = TetOctLevel<Id>;
  using ChildRows = subdivision::ChildRows<TetOctSplit<Id>>;
  using Star = TetOctStar<Id>;

  static LevelCounts RefineCounts(const LevelCounts& counts)
  {
    return { counts.Vertices + counts.Edges + counts.Octahedra,
      2 * counts.Edges + 3 * counts.Faces + 12 * counts.Octahedra,
      4 * counts.Faces + 4 * counts.Tets + 24 * counts.Octahedra,
      4 * counts.Tets + 8 * counts.Octahedra, counts.Tets + 6 * counts.Octahedra };
  }
  /// Rings of 8 and of 18 with carriers.
  static double CountMoreIds(const LevelCounts& counts)
  {
    return 26. * counts.Octahedra + 37. * counts.Vertices + 2. * counts.Edges;
  }
  static constexpr SchemeTraits Traits = { 2, false, true, RefineCounts, CountMoreIds,
    ListTetOctVertices, RegularEdgeRing, RegularVertexRing };

  static Level Start(subdivision::Level<Id>&& control)
  {
    return MakeTetOctLevel(std::move(control));
  }
  static void CountSolids(const Level& level, LevelCounts& counts)
  {
    counts.Octahedra = static_cast<double>(level.NumberOfOctahedra);
  }
  static Id CountCentres(const Level& level) { return level.NumberOfOctahedra; }
  static int CountSteps(const Level& level) { return level.Steps; }

  template <typename Out, typename T>
  static void WriteChildren(const Level& level, const std::vector<CellRun>& runs, int steps,
    const T* points, const CellStorage<Out>& out)
  {
    steps == 1 ? WriteTetOctChildren(level, runs, points, out)
               : WriteTetOctGrandchildren(level, runs, points, out);
  }
  static bool HasCells(
    const Level& level, const std::vector<CellRun>& runs, const SimplexList& cells)
  {
    return subdivision::HasCells(level, runs, cells);
  }
  static std::vector<vtkIdType> FindParents(
    const Level& level, const std::vector<CellRun>& runs, const SimplexList& cells)
  {
    return level.Steps > 0 ? subdivision::FindParents(level, runs, cells)
                           : std::vector<vtkIdType>();
  }

  static const std::shared_ptr<const Buffer<Id>>& GetSpokes(const Level& level)
  {
    return level.TetsAtSpokes;
  }
  static int GetTurn(const Level& level, Id cell, const Id (&triangle)[3])
  {
    const Id oct = cell - level.Complex.NumberOfTets;
    if (oct < 0)
    {
      return GetTurnOnTet(level.Complex, cell, triangle);
    }
    // Seen from the centre, the first vertices of the three pairs are positive axes.
    int axes[3];
    int sign = 1;
    for (int k = 0; k < 3; ++k)
    {
      const int place = VertexInOct(level, oct, triangle[k]);
      axes[k] = place / 2;
      sign = place % 2 ? -sign : sign;
    }
    return sign * GetParity(axes);
  }

  class ControlTets
  {
  public:
    ControlTets(const Level& level, int)
      : NumberOfTets(level.Complex.NumberOfTets)
    {
      const vtkIdType all = level.Complex.NumberOfTets + 4 * vtkIdType(level.NumberOfOctahedra);
      this->Counts.push_back({ all >> (3 * level.Steps), 0 });
      for (int step = 0; step < level.Steps; ++step)
      {
        const std::array<vtkIdType, 2> last = this->Counts.back();
        this->Counts.push_back({ 4 * last[0] + 8 * last[1], last[0] + 6 * last[1] });
      }
    }
    vtkIdType Find(Id solid) const
    {
      bool isOct = solid >= this->NumberOfTets;
      vtkIdType cell = isOct ? solid - this->NumberOfTets : solid;
      for (std::size_t step = this->Counts.size() - 1; step-- > 0;)
      {
        const vtkIdType ofTets = isOct ? this->Counts[step][0] : 4 * this->Counts[step][0];
        const bool isOfTet = cell < ofTets;
        cell = isOfTet ? cell / (isOct ? 1 : 4) : (cell - ofTets) / (isOct ? 6 : 8);
        isOct = !isOfTet;
      }
      return cell;
    }

  private:
    Id NumberOfTets;
    /// Numbers of tetrahedra and octahedra on all levels from the control level on.
    std::vector<std::array<vtkIdType, 2>> Counts;
  };
};

template <typename Id>
struct SchemeOfLevel<TetOctLevel<Id>>
{
  using Type = TetOctScheme<Id>;
};

}

#endif
