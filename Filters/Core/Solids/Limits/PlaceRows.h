// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlaceRows.h
 * The rows of places (PlaceLimits.h): sums of rows of nodes, or of the powers of a patch.
 */
#ifndef SubdivisionObjects_PlaceRows_h
#define SubdivisionObjects_PlaceRows_h

#include "Core/Operators/SparseRows.h"
#include "Core/Solids/Limits/PatchPolynomials.h"
#include "Core/Solids/Limits/PlacePolynomial.h"
#include "Core/Solids/Limits/RegularParts.h"

#include <algorithm>
#include <array>
#include <vector>

namespace subdivision
{

/// What the row of a place is made of: nodes with their weights, or a part of a patch.
template <typename Id>
struct PlaceNodes
{
  std::vector<Id> Vertices;
  std::vector<std::array<double, PlaceParts::Count>> Weights;
  int Part = 0; ///< SheetKey::Part; 0: there are nodes
};

/// The rows of a place over the columns that they have.
template <typename LevelType>
class RowsOfPlace
{
public:
  using Id = typename LevelType::IdType;

  RowsOfPlace(const SparseRows<Id>& limits, const RegularReader<LevelType>& reader)
    : Limits(limits)
    , Reader(reader)
    , Polynomials(reader.GetWeights())
  {
  }

  /// Finds the columns, ascending. Consecutive places often have the same, which are read once
  /// then.
  const std::vector<Id>& FindColumns(const LimitPlace<Id>& place, const PlaceNodes<Id>& nodes)
  {
    nodes.Part > 0 ? this->ReadPatch(place, nodes.Part) : this->ReadNodes(nodes.Vertices);
    return this->Columns;
  }
  /// The sums of what FindColumns read last: one weight for each column.
  void Sum(const LimitPlace<Id>& place, const PlaceNodes<Id>& nodes,
    const std::array<double*, PlaceParts::Count>& sums)
  {
    if (nodes.Part == 0)
    {
      for (int part = 0; part < PlaceParts::Count; ++part)
      {
        this->AddUp(
          nodes.Weights.size(), sums[part], [&](std::size_t n) { return nodes.Weights[n][part]; });
      }
      return;
    }
    if (this->Weights.empty())
    {
      this->WeightPatch();
    }
    const PlaceInPart part = GoToPart(place.Dimension, StartPart(place), nodes.Part);
    const auto powers = FindPatchPowers(part.At, part.Directions);
    for (int p = 0; p < PlaceParts::Count; ++p)
    {
      this->AddUp(PatchPowers, sums[p], [&](std::size_t n) { return powers[p][n]; });
    }
  }

private:
  /// Adds rows of the matrix with their weights.
  template <typename GetWeight>
  void AddUp(std::size_t rows, double* sums, const GetWeight& getWeight) const
  {
    const std::size_t columns = this->Columns.size();
    std::fill_n(sums, columns, 0.);
    for (std::size_t n = 0; n < rows; ++n)
    {
      const double weight = getWeight(n);
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
  void ReadPatch(const LimitPlace<Id>& place, int part)
  {
    if (this->Part == part && this->Corners == place.Corners)
    {
      return;
    }
    this->Part = part;
    this->Corners = place.Corners;
    this->Nodes.clear();
    this->Reader.ReadPatch(place, this->Patch);
    this->Patch.Key.Part = static_cast<unsigned char>(part);
    this->Columns = this->Patch.Columns;
    this->SortColumns();
    this->Weights.clear();
  }
  void WeightPatch()
  {
    const std::vector<double>& polynomials = this->Polynomials.Find(this->Patch.Key);
    this->Weights.assign(PatchPowers * this->Columns.size(), 0.);
    for (std::size_t c = 0; c < this->Patch.Columns.size(); ++c)
    {
      const std::size_t to = this->FindPlace(this->Patch.Columns[c]);
      for (std::size_t p = 0; p < PatchPowers; ++p)
      {
        this->Weights[p * this->Columns.size() + to] +=
          polynomials[p * this->Patch.Columns.size() + c];
      }
    }
  }

  const SparseRows<Id>& Limits;
  const RegularReader<LevelType>& Reader;
  PatchPolynomials Polynomials;
  SheetPatch<Id> Patch;
  std::array<Id, 4> Corners{}; ///< whose patch was read last
  int Part = 0;                ///< of that patch; 0: nodes were read last
  std::vector<Id> Nodes;       ///< that were read last, if no patch was
  std::vector<Id> Columns;
  std::vector<double> Weights; ///< of all columns for the first node or power, for the second, ...
};

}

#endif
