// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/SheetLimits.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/PairTable.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Limits/Restriction.h"
#include "Core/Solids/Limits/SheetReader.h"

#include <algorithm>
#include <limits>

namespace subdivision
{

/// Goes through the levels with the values at the vertices of their parts.
template <typename Id>
template <typename LevelType>
class SheetLimits<Id>::Finder
{
public:
  Finder(SheetLimits& limits, LocalVertices<Id>& vertices, const std::vector<LimitSite<Id>>& sites,
    int components, KnownSheetRows& known)
    : Limits(limits)
    , Vertices(vertices)
    , Sites(sites)
    , Components(components)
    , Known(known)
    , OnLevel(vertices.GetNumberOfLevels())
  {
    ForEachInTurn(static_cast<vtkIdType>(sites.size()),
      [&](vtkIdType i)
      {
        int level = 0;
        for (const Id corner : sites[i].Corners)
        {
          level = corner < 0 ? level : std::max(level, vertices.GetLevel(corner));
        }
        this->OnLevel[level].push_back(static_cast<Id>(i));
      });
  }

  void Run(const LevelType& control, const double* values);

private:
  /// What a thread keeps from one place to the next.
  struct Memory
  {
    SheetRows& Rows;
    SheetPatch<Id> Patch;
  };
  bool IsBefore(Id a, Id b) const
  {
    return AreValuesBefore(this->Values.data(), this->Components, a, b);
  }

  void GoOn(LevelType& part, const Restriction<LevelType>& restriction);
  void FindVertices(const LevelType& level, std::size_t number);
  void FindSites(const LevelType& level, std::size_t number);
  bool ReadSite(const SheetReader<LevelType>& reader, const PairTable<Id>& edges,
    const std::array<Id, 3>& corners, SheetPatch<Id>& patch) const;
  PairTable<Id> FindEdges(const LevelType& level, const std::vector<Id>& sites) const;
  void AddSums(const SheetPatch<Id>& patch, const double* weights, double* sums) const;
  template <typename Act>
  void WithMemories(vtkIdType size, const Act& act);

  SheetLimits& Limits;
  LocalVertices<Id>& Vertices;
  const std::vector<LimitSite<Id>>& Sites;
  const int Components;
  KnownSheetRows& Known;
  LoopWeights Weights = LoopWeights::Warren; ///< of the levels
  std::vector<std::vector<Id>> OnLevel;      ///< sites
  Buffer<double> Values;                     ///< at the vertices of the current part
  Buffer<unsigned char> Whole;               ///< vertices at which nothing is missing; empty: all
};

template <typename Id>
template <typename LevelType>
void SheetLimits<Id>::Finder<LevelType>::Run(const LevelType& control, const double* values)
{
  this->Values = Buffer<double>(vtkIdType(control.Complex.NumberOfVertices) * this->Components);
  std::copy_n(values, this->Values.size(), this->Values.begin());
  this->Weights = control.Strata.Weights;
  this->Vertices.StartOnControl();
  const LevelType* level = &control;
  LevelType current;
  for (std::size_t l = 0;; ++l)
  {
    this->FindVertices(*level, l);
    this->FindSites(*level, l);
    if (l + 1 == this->Vertices.GetNumberOfLevels())
    {
      return;
    }
    const CurvedParts<LevelType> curved(*level);
    // The last step needs no more than rows of edges at the ends of those that are halved.
    const bool isLast = l + 2 == this->Vertices.GetNumberOfLevels();
    const Buffer<unsigned char> support =
      this->Vertices.FlagSupport(*level, curved, l, isLast ? 0 : 1);
    const Restriction<LevelType> restriction(*level, support, curved);
    LevelType part = restriction.Restrict();
    this->Vertices.FollowToPart(part, restriction.GetNewVertices(), l);
    current = LevelType(); // nothing reads it any more
    current = Refine(part, Depth::ForRefinement);
    this->GoOn(part, restriction);
    level = &current;
  }
}

/// Makes the values of the level to which a part was refined. Those that lack something are not
/// numbers, and so are all that depend on them.
template <typename Id>
template <typename LevelType>
void SheetLimits<Id>::Finder<LevelType>::GoOn(
  LevelType& part, const Restriction<LevelType>& restriction)
{
  const Buffer<Id>& old = restriction.GetOldVertices();
  const vtkIdType size = this->Components;
  Buffer<double> before(size * old.size());
  ForEach(old.size(), [&](vtkIdType v)
    { std::copy_n(this->Values.data() + size * old[v], size, before.data() + size * v); });
  this->Whole = restriction.FlagWhole(part, this->Whole);
  const vtkIdType all = this->Whole.size();
  this->Values = Buffer<double>(size * all);
  TakeStencils(part).Apply(before.data(), this->Values.data(), this->Components);
  ForEach(all,
    [&](vtkIdType v)
    {
      if (!this->Whole[v])
      {
        std::fill_n(this->Values.data() + size * v, size, std::numeric_limits<double>::quiet_NaN());
      }
    });
}

/// act(i, memory of the thread) for each i.
template <typename Id>
template <typename LevelType>
template <typename Act>
void SheetLimits<Id>::Finder<LevelType>::WithMemories(vtkIdType size, const Act& act)
{
  ForRanges(size,
    [&](vtkIdType begin, vtkIdType end)
    {
      Memory memory{ this->Known.OfThread(this->Weights).GetRows(), {} };
      for (vtkIdType i = begin; i < end; ++i)
      {
        act(i, memory);
      }
    });
}

template <typename Id>
template <typename LevelType>
void SheetLimits<Id>::Finder<LevelType>::AddSums(
  const SheetPatch<Id>& patch, const double* weights, double* sums) const
{
  std::fill_n(sums, this->Components, 0.);
  for (const Id column : patch.Columns)
  {
    const double weight = *weights++;
    const double* value = this->Values.data() + vtkIdType(this->Components) * column;
    for (int c = 0; weight != 0. && c < this->Components; ++c)
    {
      sums[c] += weight * value[c];
    }
  }
}

template <typename Id>
template <typename LevelType>
void SheetLimits<Id>::Finder<LevelType>::FindVertices(const LevelType& level, std::size_t number)
{
  const SheetReader<LevelType> reader(level, this->Whole);
  const std::vector<Id>& wanted = this->Vertices.GetWanted(number);
  this->WithMemories(static_cast<vtkIdType>(wanted.size()),
    [&](vtkIdType i, Memory& memory)
    {
      if (reader.ReadVertex(this->Vertices.GetPlace(wanted[i]), memory.Patch))
      {
        this->AddSums(memory.Patch, memory.Rows.Find(memory.Patch.Key).data(),
          this->Limits.OfVertices.data() + vtkIdType(this->Components) * wanted[i]);
      }
    });
}

/// The edges between corners of sites.
template <typename Id>
template <typename LevelType>
PairTable<Id> SheetLimits<Id>::Finder<LevelType>::FindEdges(
  const LevelType& level, const std::vector<Id>& sites) const
{
  const SimplicialComplex<Id>& complex = level.Complex;
  Buffer<unsigned char> isCorner(complex.NumberOfVertices, 0);
  for (const Id site : sites)
  {
    for (const Id corner : this->Sites[site].Corners)
    {
      corner < 0 ? void() : void(isCorner[this->Vertices.GetPlace(corner)] = 1);
    }
  }
  PairTable<Id> edges;
  ForEachInTurn(complex.NumberOfEdges,
    [&](vtkIdType e)
    {
      const Id* ends = complex.EdgeVertices.data() + 2 * e;
      if (isCorner[ends[0]] && isCorner[ends[1]])
      {
        edges.FindOrAdd(ends[0], ends[1], static_cast<Id>(e));
      }
    });
  return edges;
}

/// Reads the patch of an edge (two corners) or face (three).
template <typename Id>
template <typename LevelType>
bool SheetLimits<Id>::Finder<LevelType>::ReadSite(const SheetReader<LevelType>& reader,
  const PairTable<Id>& edges, const std::array<Id, 3>& corners, SheetPatch<Id>& patch) const
{
  if (corners[2] < 0)
  {
    const Id edge = edges.Find(corners[0], corners[1]);
    const auto isBefore = [this](Id a, Id b) { return this->IsBefore(a, b); };
    return edge >= 0 && reader.ReadEdge(edge, corners[0], corners[1], isBefore, patch);
  }
  Id face = -1;
  for (int k = 0; face < 0 && k < 3; ++k)
  {
    const Id edge = edges.Find(corners[k], corners[(k + 1) % 3]);
    face = edge < 0 ? Id(-1) : reader.FindFace(edge, corners);
  }
  return face >= 0 && reader.ReadFace(face, corners, patch);
}

template <typename Id>
template <typename LevelType>
void SheetLimits<Id>::Finder<LevelType>::FindSites(const LevelType& level, std::size_t number)
{
  const std::vector<Id>& sites = this->OnLevel[number];
  if (sites.empty())
  {
    return;
  }
  const SheetReader<LevelType> reader(level, this->Whole);
  const PairTable<Id> edges = this->FindEdges(level, sites);
  this->WithMemories(static_cast<vtkIdType>(sites.size()),
    [&](vtkIdType i, Memory& memory)
    {
      const LimitSite<Id>& site = this->Sites[sites[i]];
      const int size = site.IsFace() ? 3 : 2;
      const std::array<int, 3> order = SortCorners(size,
        [&](int a, int b)
        {
          return this->IsBefore(
            this->Vertices.GetPlace(site.Corners[a]), this->Vertices.GetPlace(site.Corners[b]));
        });
      std::array<Id, 3> corners{ { -1, -1, -1 } };
      for (int k = 0; k < size; ++k)
      {
        corners[k] = this->Vertices.GetPlace(site.Corners[order[k]]);
      }
      if (!this->ReadSite(reader, edges, corners, memory.Patch))
      {
        return;
      }
      const double* weights = memory.Rows.Find(memory.Patch.Key).data();
      double* values =
        this->Limits.OfSites.data() + vtkIdType(PlacesOfSite) * this->Components * sites[i];
      for (int k = 0; k < PlacesOfSite; ++k)
      {
        const int place = site.IsFace() ? order[k] : order[0] == 0 ? k : 2 - k;
        this->AddSums(memory.Patch, weights, values + place * this->Components);
        weights += memory.Patch.Columns.size();
      }
    });
}

template <typename Id>
template <typename LevelType>
SheetLimits<Id>::SheetLimits(const LevelType& control,
  const std::vector<std::array<Id, 2>>& midpoints, const Buffer<unsigned char>& wanted,
  const std::vector<LimitSite<Id>>& sites, const double* values, int components,
  KnownSheetRows* known)
  : OfVertices(
      components * (control.Complex.NumberOfVertices + static_cast<vtkIdType>(midpoints.size())),
      std::numeric_limits<double>::quiet_NaN())
  , OfSites(PlacesOfSite * components * static_cast<vtkIdType>(sites.size()),
      std::numeric_limits<double>::quiet_NaN())
{
  LocalVertices<Id> vertices(control.Complex.NumberOfVertices, midpoints, wanted);
  KnownSheetRows own;
  Finder<LevelType>(*this, vertices, sites, components, known ? *known : own).Run(control, values);
}

SUBDIVISION_COMPILE(class SheetLimits);
#define SUBDIVISION_SHEETS(Level)                                                                  \
  template SheetLimits<Level::IdType>::SheetLimits(const Level&,                                   \
    const std::vector<std::array<Level::IdType, 2>>&, const Buffer<unsigned char>&,                \
    const std::vector<LimitSite<Level::IdType>>&, const double*, int, KnownSheetRows*)
SUBDIVISION_SHEETS(Level<int>);
SUBDIVISION_SHEETS(Level<long long>);
SUBDIVISION_SHEETS(TetOctLevel<int>);
SUBDIVISION_SHEETS(TetOctLevel<long long>);

}
