// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlaceSum.h
 * What the ways to places in solids of all schemes share (SolidPlaces.h): a sum over few vertices
 * around the place, which goes back from level to level, and tetrahedra by their corners.
 */
#ifndef SubdivisionObjects_PlaceSum_h
#define SubdivisionObjects_PlaceSum_h

#include "Core/Memory/UnevenRanges.h"
#include "Core/Solids/Limits/BoxSplineLattice.h"
#include "Core/Solids/Limits/SolidPlaces.h"

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

/// How often a solid is split around a place that lies in no polynomial. The limit is linear over
/// a part as small as this but for rounding, which does not grow with the splits (PlaceSum).
constexpr int MostSplitsOfSolids = 48;

/// A weighted sum over vertices of a level, each of which it has once.
template <typename Id>
class LatticeSum
{
public:
  void Clear()
  {
    this->Vertices.clear();
    this->Weights.clear();
    this->Slots.assign(this->Slots.size(), -1);
  }
  void Add(const LatticeVertex<Id>& vertex, double factor, const PartWeights& weights)
  {
    if (2 * (this->Vertices.size() + 1) > this->Slots.size())
    {
      this->Grow();
    }
    int& slot = this->Locate(vertex);
    if (slot < 0)
    {
      slot = static_cast<int>(this->Vertices.size());
      this->Vertices.push_back(vertex);
      this->Weights.push_back(PartWeights{});
    }
    PartWeights& sum = this->Weights[static_cast<std::size_t>(slot)];
    for (std::size_t p = 0; p < sum.size(); ++p)
    {
      sum[p] += factor * weights[p];
    }
  }

  std::vector<LatticeVertex<Id>> Vertices;
  std::vector<PartWeights> Weights;

private:
  int& Locate(const LatticeVertex<Id>& vertex)
  {
    std::uint64_t hash =
      4 * static_cast<std::uint64_t>(vertex.Simplex) + static_cast<std::uint64_t>(vertex.Dimension);
    for (const long long weight : vertex.Weights)
    {
      hash = (hash ^ static_cast<std::uint64_t>(weight)) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 32;
    }
    for (;; ++hash)
    {
      int& slot = this->Slots[hash & (this->Slots.size() - 1)];
      if (slot < 0 || this->Vertices[static_cast<std::size_t>(slot)] == vertex)
      {
        return slot;
      }
    }
  }
  void Grow()
  {
    this->Slots.assign(2 * this->Slots.size(), -1);
    for (std::size_t i = 0; i < this->Vertices.size(); ++i)
    {
      this->Locate(this->Vertices[i]) = static_cast<int>(i);
    }
  }

  std::vector<int> Slots = std::vector<int>(256, -1); ///< a power of two
};

/// A place as weighted sums over vertices of a level, which go back from level to level.
template <typename Id, typename Lattice>
class PlaceSum
{
public:
  /// `lattice` knows the rows and limits of the vertices of all levels (BoxSplineLattice.h).
  explicit PlaceSum(Lattice& lattice)
    : Vertices(lattice)
  {
  }

  void Clear() { this->Sum.Clear(); }
  void Add(const LatticeVertex<Id>& vertex, const PartWeights& weights)
  {
    this->Sum.Add(vertex, 1., weights);
  }
  /// Adds the limit of a vertex. False: a rule is unknown.
  bool AddLimit(const LatticeVertex<Id>& vertex, const PartWeights& weights)
  {
    if (!this->Vertices.ReadLimit(vertex, this->Row))
    {
      return false;
    }
    this->AddRow(weights, this->Sum);
    return true;
  }
  /// Goes back to an earlier level. False: a rule is unknown.
  bool StepBack(int levels)
  {
    for (; levels > 0; --levels)
    {
      this->Before.Clear();
      for (std::size_t i = 0; i < this->Sum.Vertices.size(); ++i)
      {
        if (!this->Vertices.ReadRow(this->Sum.Vertices[i], this->Row))
        {
          return false;
        }
        this->AddRow(this->Sum.Weights[i], this->Before);
      }
      std::swap(this->Sum, this->Before);
    }
    return true;
  }
  /// Writes the sum over control vertices.
  void Write(SolidRow<Id>& row)
  {
    this->RemoveConstants();
    std::vector<std::size_t> order(this->Sum.Vertices.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b)
      { return this->Sum.Vertices[a].Simplex < this->Sum.Vertices[b].Simplex; });
    for (const std::size_t i : order)
    {
      row.Columns.push_back(this->Sum.Vertices[i].Simplex);
      row.Weights.push_back(this->Sum.Weights[i]);
    }
  }

private:
  void AddRow(const PartWeights& weights, LatticeSum<Id>& sum) const
  {
    for (std::size_t k = 0; k < this->Row.Vertices.size(); ++k)
    {
      sum.Add(this->Row.Vertices[k], this->Row.Weights[k], weights);
    }
  }
  /// Derivatives of constants are 0. On level k weights of first derivatives are as large as 2^k,
  /// and so are their errors from rounding. On the way back an error shrinks as a derivative does,
  /// but for a multiple of the value, which no step changes: this is found by the sum, and taken
  /// away, so that derivatives on all levels are as exact as values.
  void RemoveConstants()
  {
    PartWeights sums{};
    for (const PartWeights& weights : this->Sum.Weights)
    {
      for (std::size_t p = 0; p < sums.size(); ++p)
      {
        sums[p] += weights[p];
      }
    }
    for (PartWeights& weights : this->Sum.Weights)
    {
      const double value = weights[PlaceParts::Value] / sums[PlaceParts::Value];
      for (std::size_t p = PlaceParts::Value + 1; p < sums.size(); ++p)
      {
        weights[p] -= sums[p] * value;
      }
    }
  }

  Lattice& Vertices;
  LatticeSum<Id> Sum;
  LatticeSum<Id> Before;
  LatticeRow<Id> Row;
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

/// Finds the rows of all places in solids in threads, each of which has a finder of its own:
/// find(finder, place, row).
template <typename Finder, typename Id, typename Make, typename Find>
std::vector<SolidRow<Id>> FindSolidRowsInThreads(
  const std::vector<LimitPlace<Id>>& places, const Make& make, const Find& find)
{
  std::vector<SolidRow<Id>> rows(places.size());
  vtkSMPThreadLocal<std::shared_ptr<Finder>> ofThreads;
  ForUnevenRanges(static_cast<vtkIdType>(places.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      std::shared_ptr<Finder>& finder = ofThreads.Local();
      if (!finder)
      {
        finder = make();
      }
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        if (places[i].Dimension == 3)
        {
          find(*finder, places[i], rows[i]);
        }
      }
    });
  return rows;
}

/// Whether any place is in a solid, and no rule depends both on sectors and on what is semi-sharp.
template <typename Id>
bool HasPlacesOnLattice(const Strata<Id>& strata, const SemiSharpStages<Id>& creases,
  const std::vector<LimitPlace<Id>>& places)
{
  const auto hasSectors = [](const SharpStage<Id>& stage) { return !stage.Strata.Sectors.empty(); };
  const auto isSharp = [](double sharpness) { return sharpness > 0.; };
  const bool isAnySharp =
    std::any_of(creases.Sharpness.begin(), creases.Sharpness.end(), isSharp) ||
    std::any_of(creases.FaceSharpness.begin(), creases.FaceSharpness.end(), isSharp);
  return std::any_of(places.begin(), places.end(),
           [](const LimitPlace<Id>& place) { return place.Dimension == 3; }) &&
    (!isAnySharp ||
      (strata.Sectors.empty() &&
        std::none_of(creases.Stages.begin(), creases.Stages.end(), hasSectors)));
}

}

#endif
