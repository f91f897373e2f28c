// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlaceSum.h
 * What the ways to places share: a sum over few vertices around the place, which goes back from
 * level to level; and those to places in solids (SolidPlaces.h): tetrahedra by their corners.
 */
#ifndef SubdivisionObjects_PlaceSum_h
#define SubdivisionObjects_PlaceSum_h

#include "Core/Memory/UnevenRanges.h"
#include "Core/Solids/Limits/BoxSplineLattice.h"
#include "Core/Solids/Limits/SolidPlaces.h"
#include "Core/Solids/Limits/VertexNumbers.h"

#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace subdivision
{

using PartWeights = std::array<double, PlaceParts::Count>;

/// How often a simplex is split around a place that lies in no polynomial. The limit is linear over
/// a part as small as this but for rounding, which does not grow with the splits (PlaceSum).
constexpr int MostSplits = 52;

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

/// A place as weighted sums over vertices of a level, which go back from level to level. The first
/// of `Weights` are those of a value, whose sum is 1; the others are those of derivatives, whose
/// sum is 0.
template <typename Lattice, typename Weights = PartWeights>
class PlaceSum
{
public:
  using LevelRow = typename Lattice::LevelRow;
  using Vertex = typename LevelRow::Vertex;

  /// `lattice` knows the rows and limits of the vertices of all levels (BoxSplineLattice.h,
  /// LocalLattice.h).
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
  /// Goes back to an earlier level. False: a rule is unknown.
  bool StepBack(int levels)
  {
    this->RemoveConstants();
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
      this->RemoveConstants();
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
  void Write(SolidRow<Id>& row) const
  {
    this->ForColumns(
      [&row](Id column, const Weights& weights)
      {
        row.Columns.push_back(column);
        row.Weights.push_back(weights);
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
  /// Derivatives of constants are 0. On level k weights of first derivatives are as large as 2^k,
  /// and so are their errors from rounding. On the way back an error shrinks as a derivative does,
  /// but for a multiple of the value, which no step changes: this is found by the sum, and taken
  /// away, so that derivatives on all levels are as exact as values. It is taken away on each
  /// level: where derivatives shrink faster than 2^-k, near vertices with three or four triangles,
  /// nothing of them would be left beside what earlier levels add up to.
  void RemoveConstants()
  {
    Weights sums{};
    for (const Weights& weights : this->Sum.OfVertices)
    {
      for (std::size_t p = 0; p < sums.size(); ++p)
      {
        sums[p] += weights[p];
      }
    }
    for (Weights& weights : this->Sum.OfVertices)
    {
      const double value = weights[0] / sums[0];
      for (std::size_t p = 1; p < sums.size(); ++p)
      {
        weights[p] -= sums[p] * value;
      }
    }
  }

  Lattice& Vertices;
  VertexSum<Vertex, Weights> Sum;
  VertexSum<Vertex, Weights> Before;
  LevelRow Found;
};

/// Finds tetrahedra by their corners.
template <typename Id>
class TetTable
{
public:
  TetTable(const SimplicialComplex<Id>& complex, const std::vector<LimitPlace<Id>>& places)
  {
    Buffer<unsigned char> isCorner(complex.NumberOfVertices, 0);
    for (const LimitPlace<Id>& place : InTurn(places))
    {
      for (int i = 0; place.Dimension == 3 && i < 4; ++i)
      {
        isCorner[place.Corners[i]] = 1;
      }
    }
    ForEachInTurn(complex.NumberOfTets,
      [&](vtkIdType t)
      {
        std::array<Id, 4> corners;
        std::copy_n(complex.TetVertices.data() + 4 * t, 4, corners.begin());
        if (std::all_of(corners.begin(), corners.end(), [&](Id v) { return isCorner[v] != 0; }))
        {
          std::sort(corners.begin(), corners.end());
          this->Tets.emplace_back(corners, static_cast<Id>(t));
        }
      });
    std::sort(this->Tets.begin(), this->Tets.end());
  }
  /// -1: there is none.
  Id Find(std::array<Id, 4> corners) const
  {
    std::sort(corners.begin(), corners.end());
    const auto found = std::lower_bound(this->Tets.begin(), this->Tets.end(), corners,
      [](const auto& listed, const auto& wanted) { return listed.first < wanted; });
    return found == this->Tets.end() || found->first != corners ? Id(-1) : found->second;
  }

private:
  std::vector<std::pair<std::array<Id, 4>, Id>> Tets; ///< ascending
};

/// act(finder, number of the place) for all places in threads, each of which makes a finder.
template <typename Make, typename Act>
void ForPlacesInThreads(std::size_t places, const Make& make, const Act& act)
{
  vtkSMPThreadLocal<decltype(make())> ofThreads;
  ForUnevenRanges(static_cast<vtkIdType>(places),
    [&](vtkIdType begin, vtkIdType end)
    {
      auto& finder = ofThreads.Local();
      if (!finder)
      {
        finder = make();
      }
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        act(*finder, i);
      }
    });
}

/// Finds the rows of all places in solids: find(finder, place, row).
template <typename Id, typename Make, typename Find>
std::vector<SolidRow<Id>> FindSolidRowsInThreads(
  const std::vector<LimitPlace<Id>>& places, const Make& make, const Find& find)
{
  std::vector<SolidRow<Id>> rows(places.size());
  ForPlacesInThreads(places.size(), make, [&](auto& finder, std::size_t i)
    { places[i].Dimension == 3 ? find(finder, places[i], rows[i]) : void(); });
  return rows;
}

/// Whether rules depend both on sectors and on what is semi-sharp: then rows read more of what is
/// semi-sharp than what lies at their vertex or edge.
template <typename Id>
bool HasSharpSectors(const Strata<Id>& strata, const SemiSharpStages<Id>& creases)
{
  const auto hasSectors = [](const SharpStage<Id>& stage) { return !stage.Strata.Sectors.empty(); };
  const auto isSharp = [](double sharpness) { return sharpness > 0.; };
  const bool isAnySharp =
    std::any_of(creases.Sharpness.begin(), creases.Sharpness.end(), isSharp) ||
    std::any_of(creases.FaceSharpness.begin(), creases.FaceSharpness.end(), isSharp);
  return isAnySharp &&
    (!strata.Sectors.empty() ||
      std::any_of(creases.Stages.begin(), creases.Stages.end(), hasSectors));
}

/// Whether any place is in a solid whose rows a lattice may know.
template <typename Id>
bool HasPlacesOnLattice(const Strata<Id>& strata, const SemiSharpStages<Id>& creases,
  const std::vector<LimitPlace<Id>>& places)
{
  return std::any_of(places.begin(), places.end(),
           [](const LimitPlace<Id>& place) { return place.Dimension == 3; }) &&
    !HasSharpSectors(strata, creases);
}

}

#endif
