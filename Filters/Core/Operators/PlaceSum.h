// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlaceSum.h
 * The row of a place as a sum over few vertices around it, which goes back from level to level.
 */
#ifndef SubdivisionObjects_PlaceSum_h
#define SubdivisionObjects_PlaceSum_h

#include "Core/Operators/PlaceParts.h"
#include "Core/Operators/VertexRow.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

namespace subdivision
{

using PartWeights = std::array<double, PlaceParts::Count>;

/// The row of a place (PlaceParts), with ascending columns.
template <typename Id>
struct PlaceRow
{
  std::vector<Id> Columns;
  std::vector<PartWeights> Weights; ///< of each column

  void CopyWeights(const PlaceSums& to) const
  {
    for (std::size_t c = 0; c < this->Weights.size(); ++c)
    {
      for (std::size_t p = 0; p < PlaceParts::Count; ++p)
      {
        to[p] ? void(to[p][c] = this->Weights[c][p]) : void();
      }
    }
  }
};

/// Weighted sums over vertices of a level, each of which it has once. `Weights`: an array, one
/// weight for each of the sums.
template <typename Vertex, typename Weights>
class VertexSum : public VertexNumbers<Vertex>
{
public:
  void Clear()
  {
    VertexNumbers<Vertex>::Clear();
    this->OfVertices.clear();
  }
  void Add(const Vertex& vertex, double factor, const Weights& weights)
  {
    const std::size_t number = this->GetNumber(vertex);
    if (number == this->OfVertices.size())
    {
      this->OfVertices.push_back(Weights{});
    }
    Weights& sum = this->OfVertices[number];
    for (std::size_t p = 0; p < sum.size(); ++p)
    {
      sum[p] += factor * weights[p];
    }
  }

  std::vector<Weights> OfVertices;
};

/// Derivatives of constants are 0. On level k weights of first derivatives are as large as 2^k, and
/// so are their errors from rounding. On the way back to earlier levels an error shrinks as a
/// derivative does, but for a multiple of the value, which no step changes: this is found by the
/// sum over all vertices, and taken away, so that derivatives on all levels are as exact as values.
/// It is taken away on each level: where derivatives shrink faster than 2^-k, near vertices with
/// three or four triangles, nothing of them would be left beside the sums of earlier levels.
template <typename Weights>
void RemoveConstants(std::vector<Weights>& all)
{
  Weights sums{};
  for (const Weights& weights : all)
  {
    for (std::size_t p = 0; p < sums.size(); ++p)
    {
      sums[p] += weights[p];
    }
  }
  for (Weights& weights : all)
  {
    const double value = weights[0] / sums[0];
    for (std::size_t p = 1; p < sums.size(); ++p)
    {
      weights[p] -= sums[p] * value;
    }
  }
}

/// A place as weighted sums over vertices of a level, which go back from level to level. The first
/// of `Weights` belong to a value, and their sum is 1; the others belong to derivatives, and their
/// sum is 0.
template <typename Lattice, typename Weights = PartWeights>
class PlaceSum
{
public:
  using LevelRow = typename Lattice::LevelRow;
  using Vertex = typename LevelRow::Vertex;

  /// `lattice` knows the rows and limits of the vertices of all levels (SharpLattice.h,
  /// SurfacePlaces.cxx).
  explicit PlaceSum(Lattice& lattice)
    : Vertices(lattice)
  {
  }

  void Clear() { this->Sum.Clear(); }
  void Add(const Vertex& vertex, const Weights& weights) { this->Sum.Add(vertex, 1., weights); }
  /// Adds the limit of a vertex. False: a rule is unknown.
  template <typename Name>
  bool AddLimit(const Name& vertex, const Weights& weights)
  {
    if (!this->Vertices.ReadLimit(vertex, this->Found))
    {
      return false;
    }
    this->AddRow(weights, this->Sum);
    return true;
  }
  /// Goes back to an earlier level. False: a rule is unknown. `goesOn`: after such steps.
  bool StepBack(int levels, bool goesOn = false)
  {
    goesOn ? void() : RemoveConstants(this->Sum.OfVertices);
    for (; levels > 0; --levels)
    {
      this->Before.Clear();
      for (std::size_t i = 0; i < this->Sum.Vertices.size(); ++i)
      {
        if (!this->Vertices.ReadRow(this->Sum.Vertices[i], this->Found))
        {
          return false;
        }
        this->AddRow(this->Sum.OfVertices[i], this->Before);
      }
      std::swap(this->Sum, this->Before);
      RemoveConstants(this->Sum.OfVertices);
    }
    return true;
  }
  /// use(column, weights) for each control vertex, in ascending order.
  template <typename Use>
  void ForColumns(const Use& use) const
  {
    const auto& vertices = this->Sum.Vertices;
    std::vector<std::size_t> order(vertices.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(), [&vertices](std::size_t a, std::size_t b)
      { return vertices[a].GetColumn() < vertices[b].GetColumn(); });
    for (const std::size_t i : order)
    {
      use(vertices[i].GetColumn(), this->Sum.OfVertices[i]);
    }
  }
  template <typename Id>
  void Write(PlaceRow<Id>& row) const
  {
    this->ForColumns(
      [&row](Id column, const Weights& weights)
      {
        row.Columns.push_back(column);
        std::copy_n(weights.begin(), PlaceParts::Count, row.Weights.emplace_back().begin());
      });
  }

private:
  void AddRow(const Weights& weights, VertexSum<Vertex, Weights>& sum) const
  {
    for (std::size_t k = 0; k < this->Found.Vertices.size(); ++k)
    {
      sum.Add(this->Found.Vertices[k], this->Found.Weights[k], weights);
    }
  }
  Lattice& Vertices;
  VertexSum<Vertex, Weights> Sum;
  VertexSum<Vertex, Weights> Before;
  LevelRow Found;
};

}

#endif
