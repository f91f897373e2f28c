// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file RefinedCells.h
 * Output: connectivity, offsets and types of a level's cells, in output order.
 */
#ifndef SubdivisionObjects_RefinedCells_h
#define SubdivisionObjects_RefinedCells_h

#include "Core/Solids/BoxSpline/Refinement.h"

#include <vector>

namespace subdivision
{

/// Coordinates as they are stored; without any nothing is known of volumes.
struct StoredPoints
{
  StoredPoints() = default;
  StoredPoints(const float* values)
    : Single(values)
  {
  }
  StoredPoints(const double* values)
    : Double(values)
  {
  }

  const float* Single = nullptr;
  const double* Double = nullptr;
};

/// Where the cells go; CountCells tells the sizes.
template <typename Out>
struct CellStorage
{
  Out* Connectivity;
  Out* Offsets; ///< one more than there are cells
  unsigned char* Types;
  /// One for each cell of the level, or null: set to the sign that the volumes of all cells in a
  /// tetrahedron have, if the writer knows it.
  signed char* Signs = nullptr;
};

struct CellCounts
{
  vtkIdType Cells = 0;
  vtkIdType Entries = 0; ///< of the connectivity
};

/// The runs as they are after `levels` steps: counts and positions.
std::vector<CellRun> RefineRuns(const std::vector<CellRun>& runs, int levels);
CellCounts CountCells(const std::vector<CellRun>& runs);

/// Writes the cells of a level.
template <typename Id, typename Out>
void WriteCells(const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs,
  const CellStorage<Out>& out);

/// Writes the children of a level's cells; `runs` are runs of the level itself. Of cells of a
/// higher dimension than `highest` only types and offsets. `points` of the children are only needed
/// for out.Signs.
template <typename Id, typename Out>
void WriteChildren(const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs,
  const CellStorage<Out>& out, int highest = 3, const StoredPoints& points = {});

/// Writes the children of the children of a level's cells, as WriteChildren does. The level was
/// made with Depth::ForRefinement and has no equal cells. `centres` is the number of its octahedra,
/// whose centres are vertices of the next level.
template <typename Id, typename Out>
void WriteGrandchildren(const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs,
  const CellStorage<Out>& out, int highest = 3, Id centres = 0, const StoredPoints& points = {});

/// Whether `cells` are the cells of a level.
template <typename Id>
bool HasCells(
  const SimplicialComplex<Id>& complex, const std::vector<CellRun>& runs, const SimplexList& cells);

/// Whether some cells equal earlier ones.
template <typename Id>
bool HasEqualCells(const SimplicialComplex<Id>& complex)
{
  return !complex.EqualLines.Twins.empty() || !complex.EqualTriangles.Twins.empty() ||
    !complex.EqualTets.Twins.empty();
}

}

#endif
