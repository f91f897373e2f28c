// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LocalLattice.h
 * The vertices of all levels of a LocalLimit and their rows, as PlaceSum goes through them.
 */
#ifndef SubdivisionObjects_LocalLattice_h
#define SubdivisionObjects_LocalLattice_h

#include "Core/Operators/VertexRow.h"
#include "Core/Solids/Limits/LocalLimit.h"

#include <vector>

namespace subdivision
{

/// Vertices have their numbers among the values of their level; on level -1 they are control
/// vertices.
template <typename Id>
class LocalLattice
{
public:
  using LevelRow = VertexRow<LevelVertex<Id>>;

  /// `limit` must outlive this.
  explicit LocalLattice(const LocalLimit<Id>& limit)
    : Limit(limit)
    , Levels(static_cast<std::size_t>(limit.GetNumberOfRows()), -1)
    , Rows(this->Levels.size(), -1)
  {
    for (int level = 0; level < limit.GetNumberOfLevels(); ++level)
    {
      Id row = 0;
      for (const Id vertex : limit.GetVertices(level))
      {
        this->Levels[vertex] = level;
        this->Rows[vertex] = row++;
      }
    }
  }

  /// The level of a wanted vertex of the LocalLimit: the first one that has it.
  int GetLevel(Id vertex) const { return this->Levels[vertex]; }

  // These return true: all rules are known.

  /// The row of a vertex over the level before it.
  bool ReadRow(const LevelVertex<Id>& vertex, LevelRow& row) const
  {
    Read(this->Limit.GetRowsOfLevel(vertex.Level), vertex.Number, vertex.Level - 1, row);
    return true;
  }
  /// The limit of a wanted vertex of the LocalLimit over its own level.
  bool ReadLimit(Id vertex, LevelRow& row) const
  {
    const int level = this->Levels[vertex];
    Read(this->Limit.GetLimitsOnLevel(level), this->Rows[vertex], level, row);
    return true;
  }

private:
  static void Read(const SparseRows<Id>& rows, Id number, int level, LevelRow& row)
  {
    row.Clear();
    for (Id k = rows.Offsets[number]; k < rows.Offsets[number + 1]; ++k)
    {
      row.Add({ level, rows.Columns[k] }, rows.Weights[k]);
    }
  }

  const LocalLimit<Id>& Limit;
  std::vector<int> Levels;
  std::vector<Id> Rows; ///< the number of the limit on its level
};

}

#endif
