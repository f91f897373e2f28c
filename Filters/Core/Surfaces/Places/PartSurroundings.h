// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PartSurroundings.h
 * The vertices around a part of a face on some level, as sums of vertices of the first level.
 */
#ifndef SubdivisionObjects_PartSurroundings_h
#define SubdivisionObjects_PartSurroundings_h

#include "Core/Operators/RowBlock.h"
#include "Core/Surfaces/Scheme/SharpPatch.h"

#include <cstddef>
#include <vector>

namespace subdivision
{

/// The surroundings of a part, with rows over the vertices around the part with which it began.
/// They are stored as differences from the row of one corner. Differences become smaller with the
/// part, so that derivatives have the precision of numbers of this size.
template <typename Id>
class PartSurroundings
{
public:
  using Matrix = std::vector<double>; ///< of all columns for the first vertex, the second, ...

  PartSurroundings(const SurfaceScheme<Id>& scheme, const SurfaceLevel<Id>& level,
    const SharpCreases<Id>& creases, const std::vector<Id>& vertices)
    : Patch(scheme, level, creases, vertices)
    , Columns(this->Patch.GetVertices())
    , Size(this->Columns.size())
    , Shared(this->Size, 0.)
    , Rows(this->Size * this->Size, 0.)
  {
    for (std::size_t i = 0; i < this->Size; ++i)
    {
      this->Rows[i * this->Size + i] = 1.;
    }
  }
  /// The surroundings of some vertices of the level that a step from others makes.
  PartSurroundings(const SurfaceScheme<Id>& scheme, const PartSurroundings& before,
    const SurfaceLevel<Id>& level, const SharpCreases<Id>& creases, const std::vector<Id>& vertices)
    : Patch(scheme, level, creases, vertices)
    , Columns(before.Columns)
    , Size(before.Size)
    , Shared(before.Shared)
    , Rows(this->Patch.GetVertices().size() * this->Size, 0.)
  {
    RowBlock<Id> row;
    double* sum = this->Rows.data();
    for (const Id vertex : this->Patch.GetVertices())
    {
      before.AddVertexOfNext(vertex, 1., row, sum);
      sum += this->Size;
    }
    const auto corner = static_cast<std::size_t>(this->Patch.FindVertex(vertices.front()));
    const auto first = this->Rows.begin() + static_cast<std::ptrdiff_t>(corner * this->Size);
    const Matrix more(first, first + static_cast<std::ptrdiff_t>(this->Size));
    for (std::size_t c = 0; c < this->Size; ++c)
    {
      this->Shared[c] += more[c];
    }
    for (std::size_t i = 0; i < this->Rows.size(); ++i)
    {
      this->Rows[i] -= more[i % this->Size];
    }
  }

  /// Adds a row over the vertices of the patch as a row over the columns, without Shared.
  void AddRow(const RowBlock<Id>& row, double factor, double* sum) const
  {
    const double* weights = row.GetWeights();
    for (std::size_t k = 0; k < row.GetNumberOfEntries(); ++k)
    {
      this->AddVertex(row.GetColumns()[k], factor * weights[k], sum);
    }
  }
  /// The same for a vertex of the next level. `row` is overwritten.
  void AddVertexOfNext(Id vertex, double factor, RowBlock<Id>& row, double* sum) const
  {
    row.Clear();
    this->Patch.AppendRow(vertex, row);
    this->AddRow(row, factor, sum);
  }
  void AddVertex(Id vertex, double factor, double* sum) const
  {
    const double* row = this->Rows.data() + static_cast<std::size_t>(vertex) * this->Size;
    for (std::size_t c = 0; c < this->Size; ++c)
    {
      sum[c] += factor * row[c];
    }
  }

  SharpPatch<Id> Patch;
  const std::vector<Id> Columns;
  const std::size_t Size; ///< of columns
  Matrix Shared;          ///< a part of each row with the sum 1

private:
  Matrix Rows; ///< of the vertices of the patch
};

}

#endif
