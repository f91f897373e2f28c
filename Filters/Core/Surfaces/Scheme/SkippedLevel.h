// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkippedLevel.h
 * The last step of a surface, from a level that is not made.
 *
 * After a step that halves edges, the neighbours of most vertices and edges follow from the level
 * before this step by arithmetic: a scheme makes their rows so (PrimalRows.h). The others are at
 * curves, corners and joints, and at edges that both faces have in the same direction. The part
 * around these is refined as a level of its own, by the step of all levels, and its rows are taken.
 * So all rows have the same entries in the same order as if the level had been made. Limit rows of
 * a last level that is not made come about in the same way.
 */
#ifndef SubdivisionObjects_SkippedLevel_h
#define SubdivisionObjects_SkippedLevel_h

#include "Core/Operators/SparseRows.h"
#include "Core/Surfaces/Scheme/SurfacePatch.h"

#include <algorithm>
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

/// The next level around some vertices of a level: all at their edges and faces.
template <typename Id>
class NextPatch
{
public:
  /// `vertices`: ascending. All faces of the level have as many corners.
  NextPatch(const SurfaceScheme<Id>& scheme, const SurfaceLevel<Id>& level,
    const std::vector<Id>& vertices, Depth depth);

  const SurfaceLevel<Id>& GetNext() const { return this->Next; }
  const SurfaceSegments& GetSegments() const { return this->Segments; }
  /// The vertex of the whole next level that a vertex of the patch is.
  Id GetVertex(vtkIdType vertex) const
  {
    const std::vector<Id>* const numbers[3] = { &this->Patch.Vertices, &this->Patch.Edges,
      &this->Patch.Faces };
    return static_cast<Id>(Translate(this->Segments.Vertices, vertex, this->SizesOfPatch,
      this->SizesOfLevel, [&](int kind, vtkIdType id) { return (*numbers[kind])[id]; }));
  }
  /// The number in the patch of what the whole has, both in the order of `segments`.
  vtkIdType Find(const IdSegments& segments, vtkIdType id) const
  {
    const std::vector<Id>* const numbers[3] = { &this->Patch.Vertices, &this->Patch.Edges,
      &this->Patch.Faces };
    return Translate(segments, id, this->SizesOfLevel, this->SizesOfPatch,
      [&](int kind, vtkIdType of)
      { return SurfacePatch<Id>::Find(*numbers[kind], static_cast<Id>(of)); });
  }

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
    const Sizes& to, const Renumber& renumber)
  {
    vtkIdType first = 0;
    for (const IdSegment& segment : segments)
    {
      const vtkIdType size = segment.OfEach * from[segment.Kind];
      if (id < size)
      {
        return first + segment.OfEach * renumber(segment.Kind, id / segment.OfEach) +
          id % segment.OfEach;
      }
      id -= size;
      first += segment.OfEach * to[segment.Kind];
    }
    return -1;
  }

  SurfacePatch<Id> Patch;
  Sizes SizesOfLevel;
  Sizes SizesOfPatch;
  SurfaceLevel<Id> Next;
  SurfaceSegments Segments; ///< the order of its parts
};

/// The rows at some vertices of a level, their edges and their faces.
template <typename Id>
class IrregularRows
{
public:
  /// `vertices`: of FindIrregularVertices. With `ofStep` the rows are those of the step from the
  /// next level, else its limit rows.
  IrregularRows(const SurfaceScheme<Id>& scheme, const SurfaceLevel<Id>& level,
    const std::vector<Id>& vertices, bool ofStep);

  /// Appends the entries of a row, which is given by its number in the whole step.
  void Append(vtkIdType row, RowBlock<Id>& rows) const;
  void AppendLimit(LimitKind kind, vtkIdType row, RowBlock<Id>& rows) const;
  /// Whether a vertex of the level is one of these.
  bool IsIrregular(Id vertex) const { return !this->IsEmpty() && this->Flags[vertex] != 0; }
  bool IsEmpty() const { return this->Flags.empty(); }

private:
  const SurfaceScheme<Id>& Scheme;
  NextPatch<Id> Patch;
  SurfaceSegments Children; ///< the order of the rows
  SparseRows<Id> Rows;      ///< of the patch, with the columns of the whole step
  Buffer<unsigned char> Flags;
};

}

#endif
