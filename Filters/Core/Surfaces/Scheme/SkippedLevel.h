// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkippedLevel.h
 * The last step of a surface, from a level that is not made.
 *
 * After a step that halves edges, the neighbours of most vertices and edges follow from the level
 * before this step by arithmetic: a scheme makes their rows so (PrimalRows.h). The others are at
 * curves, corners and joints, and at edges that both faces have in the same direction. The part
 * around these is refined as a level of its own, by the step of all levels, and its rows are taken.
 * So all rows have the same entries in the same order as if the level had been made.
 */
#ifndef SubdivisionObjects_SkippedLevel_h
#define SubdivisionObjects_SkippedLevel_h

#include "Core/Operators/SparseRows.h"
#include "Core/Surfaces/Scheme/SurfacePatch.h"

#include <array>
#include <atomic>
#include <vector>

namespace subdivision
{

/// The part of a level's vertices that may be irregular where the next level is skipped: where more
/// are, it costs less to make the level. Tests change it; negative: no level is skipped.
inline double MostIrregularVertices = 0.05;

/// Whether isTrue(i) for all i of [0, size).
template <typename IsTrue>
bool AreAll(vtkIdType size, const IsTrue& isTrue)
{
  std::atomic<bool> areAll{ true };
  ForRanges(size,
    [&](vtkIdType begin, vtkIdType end)
    {
      while (begin < end && isTrue(begin))
      {
        ++begin;
      }
      if (begin < end)
      {
        areAll = false;
      }
    });
  return areAll;
}

/// The vertices of a level at which rows of the step from the next level may be irregular,
/// ascending: vertices that are not smooth, and the ends of edges that are not, or that both faces
/// have in the same direction.
template <typename Id>
std::vector<Id> FindIrregularVertices(const SurfaceLevel<Id>& level);

/// The rows at these vertices, their edges and their faces.
template <typename Id>
class IrregularRows
{
public:
  /// `vertices`: of FindIrregularVertices. All faces of the level have as many corners.
  IrregularRows(const SurfaceScheme<Id>& scheme, const SurfaceLevel<Id>& level,
    const std::vector<Id>& vertices);

  /// Appends the entries of a row, which is given by its number in the whole step.
  void Append(vtkIdType row, RowBlock<Id>& rows) const;

private:
  void KeepFirstCorners(const PolygonMesh<Id>& whole);

  /// How many vertices, edges and faces there are (SurfaceSegments::Kind).
  using Sizes = std::array<vtkIdType, 3>;
  static Sizes GetSizes(const PolygonMesh<Id>& mesh)
  {
    return { mesh.NumberOfVertices, mesh.GetNumberOfEdges(), mesh.NumberOfFaces };
  }
  /// The number in one level of a thing that comes from a vertex, edge or face; `id` is its number
  /// in another level. `renumber(kind, i)`: the same for the vertex, edge or face.
  template <typename Renumber>
  static vtkIdType Translate(const IdSegments& segments, vtkIdType id, const Sizes& from,
    const Sizes& to, const Renumber& renumber);

  SurfacePatch<Id> Patch;
  SurfaceSegments Children; ///< the order of the rows
  Sizes SizesOfLevel;
  Sizes SizesOfPatch;
  SparseRows<Id> Rows; ///< of the patch, with the columns of the whole step
};

}

#endif
