// SPDX-License-Identifier: BSD-3-Clause
// The steps of a LocalLimit without making a level.
#include "Core/Solids/Limits/LocalLimit.h"

#include "Core/Memory/GrowingBuffer.h"
#include "Core/Memory/Ids.h"
#include "Core/Operators/VertexRow.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Limits/LatticePlaces.h"
#include "Core/Solids/Limits/SharpLattice.h"

#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <memory>
#include <stdexcept>
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

/// Goes from the finest level back to the control level, and numbers on each the vertices that the
/// rows read.
template <typename Id>
template <typename LevelType>
class LocalLimit<Id>::LatticeBuilder
{
public:
  LatticeBuilder(
    const LevelType& control, const SemiSharpStages<Id>& creases, const LatticePlaces<Id>& places)
    : Control(control)
    , Creases(creases)
    , Places(places)
    , Makes(control, creases)
  {
  }

  void Build(const Buffer<unsigned char>& wanted, std::vector<Step>& steps)
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
    for (std::size_t level = onLevel.size(); level-- > 1;)
    {
      this->MakeLimits(onLevel[level], steps[level]);
      this->MakeRows(steps[level]);
    }
    this->MakeControlLimits(std::move(onLevel[0]), steps[0]);
    if (this->IsUnknown)
    {
      throw std::logic_error("The rule of a vertex is not known.");
    }
  }

private:
  using Vertex = LatticeVertex<Id>;
  using Numbers = VertexNumbers<Vertex>;
  using Lattice = typename LevelLattices<LevelType>::Lattice;

  /// The limits of the wanted vertices of a level; those in the same control simplex, which have
  /// the same weights, side by side.
  void MakeLimits(std::vector<Id>& vertices, Step& step)
  {
    const auto getKey = [this](Id v) { return std::make_pair(this->Places.GetCarrier(v), v); };
    std::sort(vertices.begin(), vertices.end(), [&](Id a, Id b) { return getKey(a) < getKey(b); });
    step.Limits = this->ReadRows(vertices.size(), this->OfLevel,
      [&](std::size_t i, Lattice& lattice, LatticeRow<Id>& row)
      { return lattice.ReadLimit(this->Places.GetVertex(vertices[i]), row); });
    step.Vertices = std::move(vertices);
  }

  /// The rows of all vertices of a level that have a number. Vertices of the level before it get
  /// theirs.
  void MakeRows(Step& step)
  {
    Numbers before;
    const std::vector<Vertex>& vertices = this->OfLevel.Vertices;
    step.Rows = this->ReadRows(vertices.size(), before,
      [&](std::size_t i, const Lattice& lattice, LatticeRow<Id>& row)
      { return lattice.ReadRow(vertices[i], row); });
    std::swap(this->OfLevel, before);
  }

  /// read(number, lattice, row) in threads. False: a rule is unknown.
  template <typename Read>
  SparseRows<Id> ReadRows(std::size_t size, Numbers& numbers, const Read& read)
  {
    constexpr std::size_t most = 2048; // whose names are in memory
    std::vector<LatticeRow<Id>> found(std::min(size, most));
    RowList<Id> rows;
    for (std::size_t first = 0; first < size; first += most)
    {
      const std::size_t count = std::min(most, size - first);
      ForRanges(static_cast<vtkIdType>(count),
        [&](vtkIdType begin, vtkIdType end)
        {
          std::shared_ptr<Lattice>& lattice = this->OfThreads.Local();
          if (!lattice)
          {
            lattice = this->Makes.Make();
          }
          for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
          {
            read(first + i, *lattice, found[i]) ? void() : found[i].Clear();
          }
        });
      for (std::size_t i = 0; i < count; ++i)
      {
        for (std::size_t k = 0; k < found[i].Vertices.size(); ++k)
        {
          rows.Add(numbers.GetNumber(found[i].Vertices[k]), found[i].Weights[k]);
        }
        rows.EndRow();
        this->IsUnknown = this->IsUnknown || found[i].Vertices.empty();
      }
    }
    return rows.Take(numbers.Vertices.size());
  }

  /// The first step differs at joints, so the limits of control vertices are those of the level.
  void MakeControlLimits(std::vector<Id>&& vertices, Step& step)
  {
    Buffer<Id> wanted(static_cast<vtkIdType>(vertices.size()));
    std::copy(vertices.begin(), vertices.end(), wanted.begin());
    step.Limits = BuildLimitRows(this->Control, this->Creases, wanted);
    for (Id& column : InTurn(step.Limits.Columns))
    {
      column = static_cast<Id>(this->OfLevel.GetNumber({ 0, column, { { 1, 0, 0, 0 } } }));
    }
    step.Limits.NumberOfColumns = static_cast<vtkIdType>(this->OfLevel.Vertices.size());
    step.Vertices = std::move(vertices);
    RowList<Id> copies;
    for (const Vertex& vertex : InTurn(this->OfLevel.Vertices))
    {
      copies.Add(static_cast<std::size_t>(vertex.GetColumn()), 1.);
      copies.EndRow();
    }
    step.Rows = copies.Take(static_cast<std::size_t>(this->Control.Complex.NumberOfVertices));
  }

  const LevelType& Control;
  const SemiSharpStages<Id>& Creases;
  const LatticePlaces<Id>& Places;
  const LevelLattices<LevelType> Makes;
  vtkSMPThreadLocal<std::shared_ptr<Lattice>> OfThreads;
  Numbers OfLevel; ///< of the vertices of the current level
  bool IsUnknown = false;
};

template <typename Id>
template <typename LevelType>
LocalLimit<Id> LocalLimit<Id>::MakeOnLattice(const LevelType& control,
  const SemiSharpStages<Id>& creases, const std::vector<std::array<Id, 2>>& midpoints,
  const Buffer<unsigned char>& wanted)
{
  LocalLimit limit;
  limit.NumberOfColumns = control.Complex.NumberOfVertices;
  limit.NumberOfRows = limit.NumberOfColumns + static_cast<vtkIdType>(midpoints.size());
  LatticePlaces<Id> places(control);
  if (!places.Find(midpoints))
  {
    throw std::invalid_argument("A midpoint has ends that lie in no cell.");
  }
  LatticeBuilder<LevelType>(control, creases, places).Build(wanted, limit.Steps);
  return limit;
}

#define SUBDIVISION_ON_LATTICE(Level)                                                              \
  template LocalLimit<Level::IdType> LocalLimit<Level::IdType>::MakeOnLattice(const Level&,        \
    const SemiSharpStages<Level::IdType>&, const std::vector<std::array<Level::IdType, 2>>&,       \
    const Buffer<unsigned char>&)
SUBDIVISION_ON_LATTICE(Level<int>);
SUBDIVISION_ON_LATTICE(Level<long long>);
SUBDIVISION_ON_LATTICE(TetOctLevel<int>);
SUBDIVISION_ON_LATTICE(TetOctLevel<long long>);

}
