// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/LocalLimit.h"

#include "Core/Memory/GrowingBuffer.h"
#include "Core/Memory/Ids.h"
#include "Core/Operators/VertexRow.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Limits/LatticeNormals.h"
#include "Core/Solids/Limits/LatticePlaces.h"
#include "Core/Solids/Limits/SectorParts.h"
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
  void Add(const LatticeRow<Id>& row, VertexNumbers<LatticeVertex<Id>>& numbers)
  {
    for (std::size_t k = 0; k < row.Vertices.size(); ++k)
    {
      this->Add(numbers.GetNumber(row.Vertices[k]), row.Weights[k]);
    }
    this->EndRow();
  }
  vtkIdType GetSize() const { return this->Offsets.size() - 1; }
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
class LocalLimit<Id>::Builder
{
public:
  /// All must outlive this; no `solids`: no normals.
  Builder(const LevelType& control, const SemiSharpStages<Id>& creases,
    const LatticePlaces<Id>& places, const ControlSolids* solids)
    : Control(control)
    , Creases(creases)
    , Places(places)
    , Solids(solids)
    , Makes(control, creases)
  {
    if (solids)
    {
      this->Normals = std::make_unique<LatticeNormals<LevelType>>(control, *solids);
    }
  }

  void Build(std::vector<Step>& steps)
  {
    std::vector<std::vector<Id>> onLevel(1);
    for (const Id v : InTurn(this->Places.GetNumberOfVertices()))
    {
      const auto level = static_cast<std::size_t>(this->Places.GetLevel(v));
      onLevel.resize(std::max(onLevel.size(), level + 1));
      onLevel[level].push_back(v);
    }
    steps.resize(onLevel.size());
    for (std::size_t level = onLevel.size(); level-- > 1;)
    {
      this->MakeLimits(onLevel[level], steps[level]);
      this->Normals ? this->MakeTangents(steps[level]) : void();
      SetColumns(steps[level], this->OfLevel.Vertices.size());
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

  /// How many vertices a level has that something reads.
  static void SetColumns(Step& step, std::size_t size)
  {
    const auto columns = static_cast<vtkIdType>(size);
    step.Limits.NumberOfColumns = step.Tangents.Shading.Rows.NumberOfColumns = columns;
    step.Tangents.First.NumberOfColumns = step.Tangents.Second.NumberOfColumns = columns;
  }

  /// The limits of the vertices of a level; those in the same control simplex, which have
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

  /// read(number, lattice, row) in threads; false: a rule is unknown.
  template <typename Read>
  SparseRows<Id> ReadRows(std::size_t size, Numbers& numbers, const Read& read)
  {
    RowList<Id> rows;
    this->template ForBatches<LatticeRow<Id>>(
      size, read, [&](std::size_t, const LatticeRow<Id>& row) { rows.Add(row, numbers); });
    return rows.Take(numbers.Vertices.size());
  }
  /// read(number, lattice, found) in threads, and then in turn write(number, found).
  template <typename Found, typename Read, typename Write>
  void ForBatches(std::size_t size, const Read& read, const Write& write)
  {
    constexpr std::size_t most = 2048; // whose names are in memory
    std::vector<Found> found(std::min(size, most));
    std::vector<char> isKnown(found.size(), 1);
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
            isKnown[i] = read(first + i, *lattice, found[i]) ? 1 : 0;
          }
        });
      for (std::size_t i = 0; i < count; ++i)
      {
        isKnown[i] ? write(first + i, found[i]) : void();
        this->IsUnknown = this->IsUnknown || !isKnown[i];
      }
    }
  }

  /// The tangents, or stars for shading, of the vertices of a level.
  void MakeTangents(Step& step)
  {
    using Normal = LatticeNormal<Id>;
    LimitTangents<Id>& tangents = step.Tangents;
    ShadingStars<Id>& stars = tangents.Shading;
    std::vector<SectorPart<Id>> parts(1);
    RowList<Id> rows;
    const auto addStar = [&](std::size_t vertex)
    {
      stars.Stars.push_back({ static_cast<Id>(vertex), rows.GetSize(),
        static_cast<vtkIdType>(stars.Corners.size()), static_cast<vtkIdType>(stars.Lines.size()) });
    };
    tangents.Sectors.Offsets = Buffer<Id>(static_cast<vtkIdType>(step.Vertices.size()) + 1);
    this->template ForBatches<Normal>(
      step.Vertices.size(), [&](std::size_t i, Lattice& lattice, Normal& normal)
      { return this->Normals->Read(this->Places.GetVertex(step.Vertices[i]), lattice, normal); },
      [&](std::size_t i, const Normal& normal)
      {
        tangents.Sectors.Offsets[static_cast<vtkIdType>(i)] =
          static_cast<Id>(normal.Sectors.size());
        for (const auto& sector : normal.Sectors)
        {
          this->AddSector(sector, parts[0]);
        }
        normal.Rows.empty() ? void() : addStar(i);
        for (const LatticeRow<Id>& row : normal.Rows)
        {
          rows.Add(row, this->OfLevel);
        }
        stars.Corners.insert(stars.Corners.end(), normal.Corners.begin(), normal.Corners.end());
        stars.Lines.insert(stars.Lines.end(), normal.Lines.begin(), normal.Lines.end());
      });
    addStar(step.Vertices.size());
    JoinSectors(parts, 0, tangents);
    stars.Rows = rows.Take(0);
  }
  void AddSector(const typename LatticeNormal<Id>::Sector& sector, SectorPart<Id>& part)
  {
    for (std::size_t k = 0; k < sector.First.Vertices.size(); ++k)
    {
      part.Columns.push_back(static_cast<Id>(this->OfLevel.GetNumber(sector.First.Vertices[k])));
      part.First.push_back(sector.First.Weights[k]);
      part.Second.push_back(sector.Second[k]);
    }
    part.Sizes.push_back(static_cast<Id>(sector.First.Vertices.size()));
    part.Sides.insert(part.Sides.end(), sector.Sides.begin(), sector.Sides.end());
    part.SideSizes.push_back(static_cast<vtkIdType>(sector.Sides.size()));
    part.Triangles.push_back(sector.Triangle);
  }

  /// The first step differs at joints, so limits of control vertices are taken on the level.
  void MakeControlLimits(std::vector<Id>&& vertices, Step& step)
  {
    step.Limits = BuildLimitRows(this->Control, this->Creases);
    if (this->Solids)
    {
      step.Tangents = BuildLimitTangents(this->Control, this->Creases, *this->Solids);
    }
    for (SparseRows<Id>* rows :
      { &step.Limits, &step.Tangents.First, &step.Tangents.Second, &step.Tangents.Shading.Rows })
    {
      for (Id& column : InTurn(rows->Columns))
      {
        column = static_cast<Id>(this->OfLevel.GetNumber({ 0, column, { { 1, 0, 0, 0 } } }));
      }
    }
    SetColumns(step, this->OfLevel.Vertices.size());
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
  const ControlSolids* const Solids;
  std::unique_ptr<const LatticeNormals<LevelType>> Normals;
  const LevelLattices<LevelType> Makes;
  vtkSMPThreadLocal<std::shared_ptr<Lattice>> OfThreads;
  Numbers OfLevel; ///< of the vertices of the current level
  bool IsUnknown = false;
};

template <typename Id>
template <typename LevelType>
LocalLimit<Id>::LocalLimit(const LevelType& control, const SemiSharpStages<Id>& creases,
  const std::vector<std::array<Id, 2>>& midpoints, const ControlSolids* solids)
  : NumberOfRows(control.Complex.NumberOfVertices + static_cast<vtkIdType>(midpoints.size()))
  , NumberOfColumns(control.Complex.NumberOfVertices)
{
  LatticePlaces<Id> places(control);
  if (!places.Find(midpoints))
  {
    throw std::invalid_argument("A midpoint has ends that lie in no cell.");
  }
  Builder<LevelType>(control, creases, places, solids).Build(this->Steps);
}

#define SUBDIVISION_LOCAL(Level)                                                                   \
  template LocalLimit<Level::IdType>::LocalLimit(const Level&,                                     \
    const SemiSharpStages<Level::IdType>&, const std::vector<std::array<Level::IdType, 2>>&,       \
    const ControlSolids*)
SUBDIVISION_LOCAL(Level<int>);
SUBDIVISION_LOCAL(Level<long long>);
SUBDIVISION_LOCAL(TetOctLevel<int>);
SUBDIVISION_LOCAL(TetOctLevel<long long>);

}
