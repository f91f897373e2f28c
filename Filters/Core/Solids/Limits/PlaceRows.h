// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlaceRows.h
 * The rows of places (PlaceLimits.h): sums of rows of nodes, or of the powers of a patch, or rows
 * that are ready.
 */
#ifndef SubdivisionObjects_PlaceRows_h
#define SubdivisionObjects_PlaceRows_h

#include "Core/Operators/SparseRows.h"
#include "Core/Solids/Limits/PatchPolynomials.h"
#include "Core/Solids/Limits/PlacePolynomial.h"
#include "Core/Solids/Limits/RegularParts.h"
#include "Core/Solids/Limits/SolidPlaces.h"

#include <algorithm>
#include <array>
#include <vector>

namespace subdivision
{

/// What the row of a place is made of: nodes with their weights, or a part of a patch, or itself.
template <typename Id>
struct PlaceNodes
{
  std::vector<Id> Vertices;
  std::vector<std::array<double, PlaceParts::Count>> Weights;
  int Part = 0;                                ///< SheetKey::Part; 0: there are nodes
  const RegularSimplex<Id>* Simplex = nullptr; ///< in which the part is
  const SolidRow<Id>* Ready = nullptr;         ///< null: the row is not yet made
};

/// The rows of a place over the columns that they have.
template <typename Id>
class RowsOfPlace
{
public:
  RowsOfPlace(const SparseRows<Id>& limits, LoopWeights weights)
    : Limits(limits)
    , Polynomials(weights)
  {
  }

  /// Finds the columns, ascending. Consecutive places often have the same, which are read once
  /// then.
  const std::vector<Id>& FindColumns(const PlaceNodes<Id>& nodes)
  {
    if (nodes.Ready)
    {
      return nodes.Ready->Columns;
    }
    nodes.Part > 0 ? this->ReadPatch(nodes) : this->ReadNodes(nodes.Vertices);
    return this->Columns;
  }
  /// The sums of what FindColumns read last: one weight for each column.
  void Sum(const LimitPlace<Id>& place, const PlaceNodes<Id>& nodes, const PlaceSums& sums)
  {
    if (nodes.Ready)
    {
      for (std::size_t c = 0; c < nodes.Ready->Columns.size(); ++c)
      {
        for (int part = 0; part < PlaceParts::Count; ++part)
        {
          sums[part] ? void(sums[part][c] = nodes.Ready->Weights[c][part]) : void();
        }
      }
      return;
    }
    if (nodes.Part == 0)
    {
      for (int part = 0; part < PlaceParts::Count; ++part)
      {
        sums[part] ? this->AddNodes(nodes.Weights, part, sums[part]) : void();
      }
      return;
    }
    if (IsInner(nodes))
    {
      constexpr PatchDirections along{ { { { 1., 0. } }, { { 0., 1. } } } };
      nodes.Simplex->Inner.Weight(place.Parameters[0], place.Parameters[1], along, sums);
      return;
    }
    if (this->Weights.empty())
    {
      this->WeightPatch();
    }
    const PlaceInPart part =
      GoToPart(place.Dimension, StartPart(place, *nodes.Simplex), nodes.Part);
    const CornerWeights& first = part.Directions[0];
    const CornerWeights& second = part.Directions[1];
    const PatchParts powers = FindPatchPowers(PatchPowers::Quartic, part.At[1], part.At[2],
      { { { { first[1], second[1] } }, { { first[2], second[2] } } } });
    SumPowers(PatchPowers::Quartic, powers, this->Weights.data(), this->Columns.size(), sums);
  }

private:
  /// Whether a place lies in a triangle that needs no polynomial of its own.
  static bool IsInner(const PlaceNodes<Id>& nodes)
  {
    return nodes.Part == 1 && nodes.Simplex->Inner.GetSize() > 0;
  }
  /// Adds the rows of nodes with their weights for one of PlaceParts.
  void AddNodes(
    const std::vector<std::array<double, PlaceParts::Count>>& nodes, int part, double* sums) const
  {
    const std::size_t columns = this->Columns.size();
    std::fill_n(sums, columns, 0.);
    for (std::size_t n = 0; n < nodes.size(); ++n)
    {
      const double weight = nodes[n][part];
      if (weight == 0.)
      {
        continue;
      }
      const double* from = this->Weights.data() + n * columns;
      for (std::size_t c = 0; c < columns; ++c)
      {
        sums[c] += weight * from[c];
      }
    }
  }
  void SortColumns()
  {
    std::sort(this->Columns.begin(), this->Columns.end());
    this->Columns.erase(
      std::unique(this->Columns.begin(), this->Columns.end()), this->Columns.end());
  }
  std::size_t FindPlace(Id column) const
  {
    return static_cast<std::size_t>(
      std::lower_bound(this->Columns.begin(), this->Columns.end(), column) - this->Columns.begin());
  }

  void ReadNodes(const std::vector<Id>& nodes)
  {
    if (this->Nodes == nodes)
    {
      return;
    }
    this->Nodes = nodes;
    this->Part = 0;
    this->Columns.clear();
    const auto forEntries = [&](const auto& use)
    {
      for (std::size_t n = 0; n < nodes.size(); ++n)
      {
        for (vtkIdType k = this->Limits.Offsets[nodes[n]]; k < this->Limits.Offsets[nodes[n] + 1];
          ++k)
        {
          use(n, k);
        }
      }
    };
    forEntries([&](std::size_t, vtkIdType k) { this->Columns.push_back(this->Limits.Columns[k]); });
    this->SortColumns();
    this->Weights.assign(nodes.size() * this->Columns.size(), 0.);
    forEntries(
      [&](std::size_t n, vtkIdType k)
      {
        this->Weights[n * this->Columns.size() + this->FindPlace(this->Limits.Columns[k])] +=
          this->Limits.Weights[k];
      });
  }
  void ReadPatch(const PlaceNodes<Id>& nodes)
  {
    if (this->Part == nodes.Part && this->Simplex == nodes.Simplex)
    {
      return;
    }
    this->Part = nodes.Part;
    this->Simplex = nodes.Simplex;
    this->Nodes.clear();
    this->Weights.clear();
    if (IsInner(nodes))
    {
      this->Columns.assign(this->Simplex->Inner.begin(), this->Simplex->Inner.end());
      return;
    }
    this->Columns = this->Simplex->Patch.Columns;
    this->SortColumns();
  }
  void WeightPatch()
  {
    SheetKey key = this->Simplex->Patch.Key;
    key.Part = static_cast<std::uint16_t>(this->Part);
    const std::vector<double>& polynomials = this->Polynomials.Find(key);
    const std::vector<Id>& columns = this->Simplex->Patch.Columns;
    this->Weights.assign(QuarticPowers * this->Columns.size(), 0.);
    for (std::size_t c = 0; c < columns.size(); ++c)
    {
      const std::size_t to = this->FindPlace(columns[c]);
      for (std::size_t p = 0; p < QuarticPowers; ++p)
      {
        this->Weights[p * this->Columns.size() + to] += polynomials[p * columns.size() + c];
      }
    }
  }

  const SparseRows<Id>& Limits;
  PatchPolynomials Polynomials;
  const RegularSimplex<Id>* Simplex = nullptr; ///< whose patch was read last
  int Part = 0;                                ///< of that patch; 0: nodes were read last
  std::vector<Id> Nodes;                       ///< that were read last, if no patch was
  std::vector<Id> Columns;
  std::vector<double> Weights; ///< of all columns for the first node or power, for the second, ...
};

}

#endif
