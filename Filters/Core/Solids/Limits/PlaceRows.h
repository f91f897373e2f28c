// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlaceRows.h
 * The rows of places (PlaceLimits.h): sums of the powers of a patch, or rows that are ready.
 */
#ifndef SubdivisionObjects_PlaceRows_h
#define SubdivisionObjects_PlaceRows_h

#include "Core/Solids/Limits/PatchPolynomials.h"
#include "Core/Solids/Limits/PlacePolynomial.h"
#include "Core/Solids/Limits/RegularParts.h"
#include "Core/Solids/Limits/SolidPlaces.h"

#include <algorithm>
#include <array>
#include <vector>

namespace subdivision
{

/// What the row of a place is made of: a part of a patch, or nodes with their weights.
template <typename Id>
struct PlaceNodes
{
  std::vector<Id> Vertices;
  std::vector<std::array<double, PlaceParts::Count>> Weights;
  int Part = 0;                                ///< SheetKey::Part; 0: there are nodes
  const RegularSimplex<Id>* Simplex = nullptr; ///< in which the part is
};

/// The rows of a place over the columns that they have.
template <typename Id>
class RowsOfPlace
{
public:
  explicit RowsOfPlace(LoopWeights weights)
    : Polynomials(weights)
  {
  }

  /// Finds the columns, ascending. `ready`: the row of a place that has nodes. Consecutive places
  /// often have the same patch, which is read once then.
  const std::vector<Id>& FindColumns(const PlaceNodes<Id>& nodes, const SolidRow<Id>& ready)
  {
    if (nodes.Part == 0)
    {
      return ready.Columns;
    }
    this->ReadPatch(nodes);
    return this->Columns;
  }
  /// The sums of what FindColumns read last: one weight for each column.
  void Sum(const LimitPlace<Id>& place, const PlaceNodes<Id>& nodes, const SolidRow<Id>& ready,
    const PlaceSums& sums)
  {
    if (nodes.Part == 0)
    {
      for (std::size_t c = 0; c < ready.Columns.size(); ++c)
      {
        for (int part = 0; part < PlaceParts::Count; ++part)
        {
          sums[part] ? void(sums[part][c] = ready.Weights[c][part]) : void();
        }
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

  void ReadPatch(const PlaceNodes<Id>& nodes)
  {
    if (this->Part == nodes.Part && this->Simplex == nodes.Simplex)
    {
      return;
    }
    this->Part = nodes.Part;
    this->Simplex = nodes.Simplex;
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

  PatchPolynomials Polynomials;
  const RegularSimplex<Id>* Simplex = nullptr; ///< whose patch was read last
  int Part = 0;                                ///< of that patch; 0: none was read
  std::vector<Id> Columns;
  std::vector<double> Weights; ///< of all columns for the first power, for the second, ...
};

}

#endif
