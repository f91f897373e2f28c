// SPDX-License-Identifier: BSD-3-Clause
// The steps of a LocalLimit without making a level.
#include "Core/Solids/Limits/LocalLimit.h"

#include "Core/Memory/GrowingBuffer.h"
#include "Core/Memory/Ids.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Limits/LatticePlaces.h"
#include "Core/Solids/Limits/LatticeRings.h"
#include "Core/Solids/Limits/VertexNumbers.h"

#include <algorithm>
#include <utility>

namespace subdivision
{
namespace
{

/// Rows that are made one after the other.
template <typename Id>
class RowList
{
public:
  RowList() { this->Offsets.push_back(0); }
  void Add(std::size_t column, double weight)
  {
    this->Columns.push_back(static_cast<Id>(column));
    this->Weights.push_back(weight);
  }
  void EndRow() { this->Offsets.push_back(static_cast<Id>(this->Columns.size())); }
  SparseRows<Id> Take(std::size_t columns) const
  {
    SparseRows<Id> rows;
    rows.NumberOfColumns = static_cast<vtkIdType>(columns);
    rows.Offsets = this->Offsets.Copy();
    rows.Columns = this->Columns.Copy();
    rows.Weights = this->Weights.Copy();
    return rows;
  }

private:
  GrowingBuffer<Id> Offsets;
  GrowingBuffer<Id> Columns;
  GrowingBuffer<double> Weights;
};

}

/// Goes from the finest level back to the control level, and numbers on each what the rows read.
template <typename Id>
class LocalLimit<Id>::LatticeBuilder
{
public:
  LatticeBuilder(const Level<Id>& control, const LatticePlaces<Id>& places)
    : Control(control)
    , Places(places)
    , Lattice(control)
  {
  }

  /// False: a rule is not known.
  bool Build(const Buffer<unsigned char>& wanted, std::vector<Step>& steps)
  {
    std::vector<std::vector<Id>> onLevel(1);
    for (const Id v : InTurn(this->Places.GetNumberOfVertices()))
    {
      if (wanted.empty() || wanted[v])
      {
        const auto level = static_cast<std::size_t>(this->Places.GetLevel(v));
        onLevel.resize(std::max(onLevel.size(), level + 1));
        onLevel[level].push_back(v);
      }
    }
    steps.resize(onLevel.size());
    bool isKnown = true;
    for (std::size_t level = onLevel.size(); isKnown && level-- > 1;)
    {
      isKnown = this->MakeLimits(onLevel[level], steps[level]) && this->MakeRows(steps[level]);
    }
    if (isKnown)
    {
      this->MakeControlLimits(std::move(onLevel[0]), steps[0]);
    }
    return isKnown;
  }

private:
  /// The limits of the wanted vertices of a level; those in the same control simplex, which have
  /// the same weights, side by side.
  bool MakeLimits(std::vector<Id>& vertices, Step& step)
  {
    const auto getKey = [this](Id v) { return std::make_pair(this->Places.GetCarrier(v), v); };
    std::sort(vertices.begin(), vertices.end(), [&](Id a, Id b) { return getKey(a) < getKey(b); });
    RowList<Id> rows;
    for (const Id v : InTurn(vertices))
    {
      if (!this->Lattice.ReadLimit(this->Places.GetMidpoint(v), this->Row))
      {
        return false;
      }
      this->AddRow(this->Numbers, rows);
    }
    step.Limits = rows.Take(this->Numbers.Vertices.size());
    step.Vertices = std::move(vertices);
    return true;
  }

  /// The rows of all vertices of a level that have a number. Those of the level before it get
  /// theirs.
  bool MakeRows(Step& step)
  {
    VertexNumbers<LatticeVertex<Id>> before;
    RowList<Id> rows;
    for (const LatticeVertex<Id>& vertex : InTurn(this->Numbers.Vertices))
    {
      if (!this->Lattice.ReadRow(vertex, this->Row))
      {
        return false;
      }
      this->AddRow(before, rows);
    }
    step.Rows = rows.Take(before.Vertices.size());
    std::swap(this->Numbers, before);
    return true;
  }

  void AddRow(VertexNumbers<LatticeVertex<Id>>& numbers, RowList<Id>& rows) const
  {
    for (std::size_t k = 0; k < this->Row.Vertices.size(); ++k)
    {
      rows.Add(numbers.GetNumber(this->Row.Vertices[k]), this->Row.Weights[k]);
    }
    rows.EndRow();
  }

  /// The first step differs at joints, so the limits of control vertices are those of the level.
  void MakeControlLimits(std::vector<Id>&& vertices, Step& step)
  {
    Buffer<Id> wanted(static_cast<vtkIdType>(vertices.size()));
    std::copy(vertices.begin(), vertices.end(), wanted.begin());
    step.Limits = BuildLimitRows(this->Control, {}, wanted);
    for (Id& column : InTurn(step.Limits.Columns))
    {
      column = static_cast<Id>(this->Numbers.GetNumber({ 0, column, { { 1, 0, 0, 0 } } }));
    }
    step.Limits.NumberOfColumns = static_cast<vtkIdType>(this->Numbers.Vertices.size());
    step.Vertices = std::move(vertices);
    RowList<Id> copies;
    for (const LatticeVertex<Id>& vertex : InTurn(this->Numbers.Vertices))
    {
      copies.Add(static_cast<std::size_t>(vertex.GetColumn()), 1.);
      copies.EndRow();
    }
    step.Rows = copies.Take(static_cast<std::size_t>(this->Control.Complex.NumberOfVertices));
  }

  const Level<Id>& Control;
  const LatticePlaces<Id>& Places;
  LatticeRings<Id> Lattice;
  VertexNumbers<LatticeVertex<Id>> Numbers; ///< of the current level
  LatticeRow<Id> Row;
};

template <typename Id>
std::optional<LocalLimit<Id>> LocalLimit<Id>::MakeOnLattice(const Level<Id>& control,
  const std::vector<std::array<Id, 2>>& midpoints, const Buffer<unsigned char>& wanted)
{
  if (!control.Strata.Sectors.empty()) // limits beside them are not known
  {
    return std::nullopt;
  }
  LocalLimit limit;
  limit.NumberOfColumns = control.Complex.NumberOfVertices;
  limit.NumberOfRows = limit.NumberOfColumns + static_cast<vtkIdType>(midpoints.size());
  LatticePlaces<Id> places(control.Complex);
  if (!places.Find(midpoints) || !LatticeBuilder(control, places).Build(wanted, limit.Steps))
  {
    return std::nullopt;
  }
  return limit;
}

template <typename Id>
bool LocalLimit<Id>::IsLatticeFaster(
  const SimplicialComplex<Id>& control, const std::vector<std::array<Id, 2>>& midpoints)
{
  std::vector<int> levels;
  levels.reserve(midpoints.size());
  std::size_t onEdges = 0; // of the control mesh, in their middles
  const auto getLevel = [&](Id v)
  { return v < control.NumberOfVertices ? 0 : levels[v - control.NumberOfVertices]; };
  for (const auto& [a, b] : InTurn(midpoints))
  {
    levels.push_back(1 + std::max(getLevel(a), getLevel(b)));
    onEdges += levels.back() == 1 && a != b ? 1 : 0;
  }
  const int deepest = levels.empty() ? 0 : *std::max_element(levels.begin(), levels.end());
  const auto edges = static_cast<std::size_t>(control.NumberOfEdges);
  const bool isSolid = 8 * static_cast<std::size_t>(control.NumberOfTets) > edges;
  // Three whole levels have 1 + 8 + 64 vertices for each control edge.
  const bool isShallow = deepest < 3 || (deepest == 3 && midpoints.size() > 36 * onEdges);
  return isSolid && !(isShallow && 4 * onEdges > edges);
}

#define SUBDIVISION_ON_LATTICE(Id)                                                                 \
  template std::optional<LocalLimit<Id>> LocalLimit<Id>::MakeOnLattice(                            \
    const Level<Id>&, const std::vector<std::array<Id, 2>>&, const Buffer<unsigned char>&);        \
  template bool LocalLimit<Id>::IsLatticeFaster(                                                   \
    const SimplicialComplex<Id>&, const std::vector<std::array<Id, 2>>&)
SUBDIVISION_ON_LATTICE(int);
SUBDIVISION_ON_LATTICE(long long);

}
