// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SharpPatch.h
 * The part of a level around some vertices, with the creases there that are sharp for some steps
 * more, and the step from it.
 *
 * The given vertices, and the edges and faces at them, have the same rows as in the whole level. If
 * each patch is around vertices whose neighbours have such rows on the level that the patch before
 * made, some vertices can be followed through any number of steps while patches do not grow.
 */
#ifndef SubdivisionObjects_SharpPatch_h
#define SubdivisionObjects_SharpPatch_h

#include "Core/Surfaces/Scheme/SharpRows.h"
#include "Core/Surfaces/Scheme/SurfacePatch.h"

#include <memory>
#include <vector>

namespace subdivision
{

/// Tags of some steps.
template <typename Id>
struct SharpTags
{
  int Until = 0; ///< the tags hold in steps before this one
  SharpTagPair<Id> Tags;
};

/// The creases of a level that are sharp for some steps more.
template <typename Id>
struct SharpCreases
{
  std::vector<SharpEdge<Id>> Edges;  ///< ascending
  std::vector<SharpTags<Id>> Stages; ///< ascending; after the last one no crease counts as sharp
  int Step = 0;                      ///< how many steps have been made
};

template <typename Id>
class SharpPatch
{
public:
  /// `vertices`: ascending. `scheme` has to live as long as the patch.
  SharpPatch(const SurfaceScheme<Id>& scheme, const SurfaceLevel<Id>& whole,
    const SharpCreases<Id>& creases, const std::vector<Id>& vertices);

  const SurfaceLevel<Id>& GetLevel() const { return this->Patch.Level; }
  const std::vector<SharpEdge<Id>>& GetSharpEdges() const { return this->Creases.Edges; }
  /// The vertices of the whole level that are vertices of the patch, ascending.
  const std::vector<Id>& GetVertices() const { return this->Patch.Vertices; }
  const std::vector<Id>& GetFaces() const { return this->Patch.Faces; }
  /// The numbers in the patch of parts of the whole level; -1: the patch does not have the part.
  Id FindVertex(Id vertex) const { return Patch.Find(this->Patch.Vertices, vertex); }
  Id FindEdge(Id edge) const { return Patch.Find(this->Patch.Edges, edge); }
  Id FindFace(Id face) const { return Patch.Find(this->Patch.Faces, face); }

  /// The next level, and the creases that are sharp there. Is called once.
  SurfaceLevel<Id> Refine(SharpCreases<Id>& next);
  /// Appends the row of a vertex of the next level; after Refine.
  void AppendRow(vtkIdType row, RowBlock<Id>& rows) const;
  /// Appends the limit row of a vertex, if no crease is sharp near it any more.
  void AppendLimitRow(Id vertex, LimitKind kind, RowBlock<Id>& rows) const
  {
    const SurfaceLevel<Id>& level = this->GetLevel();
    this->Scheme.AppendLimitRows(level, level.Tags, kind, vertex, vertex + 1, rows);
  }

private:
  const SurfaceScheme<Id>& Scheme;
  SurfacePatch<Id> Patch;
  SharpCreases<Id> Creases;
  std::unique_ptr<SharpRows<Id>> Rows; ///< null: no crease is sharp
};

}

#endif
