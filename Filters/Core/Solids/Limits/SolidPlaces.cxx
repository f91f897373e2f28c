// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/SolidPlaces.h"

#include "Core/Memory/Ids.h"
#include "Core/Memory/UnevenRanges.h"
#include "Core/Solids/Limits/BoxSplinePatch.h"
#include "Core/Solids/Limits/PlacePolynomial.h"
#include "Core/Solids/Limits/RegularLattice.h"
#include "Core/Solids/Limits/SolidLattice.h"

#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>

namespace subdivision
{
namespace
{

using PartWeights = std::array<double, PlaceParts::Count>;

/// How often a tetrahedron is split in which nothing becomes regular around the place. Derivatives
/// have a rounding error in proportion to 2^splits, and others in proportion to the size.
constexpr int MostSplits = 24;
/// The same for the value alone. On faces whose two tetrahedra mark different edges it is not even
/// smooth: errors are in proportion to the size.
constexpr int MostSplitsOfValues = 42;

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

/// Finds the row of one place after the other.
template <typename Id>
class SolidPlaceFinder
{
public:
  explicit SolidPlaceFinder(const Level<Id>& level)
    : Complex(level.Complex)
    , Lattice(level)
    , Regular(level, this->Lattice)
  {
  }

  /// Leaves the row empty if a rule near the place is unknown.
  void Find(const LimitPlace<Id>& place, Id tet, SolidRow<Id>& row)
  {
    this->Start(place, tet);
    int level = 0;
    bool isRegular = this->ReadPolynomial();
    for (; !isRegular && level < MostSplits; ++level)
    {
      this->Split();
      isRegular = this->ReadPolynomial();
    }
    if ((isRegular || this->ReadSmallPart(level)) && this->StepBack(level, 0))
    {
      this->Write(row);
    }
  }

private:
  void Start(const LimitPlace<Id>& place, Id tet)
  {
    if (tet != this->Tet)
    {
      this->Tet = tet;
      this->Parts = this->Regular.FindRegularParts(tet);
    }
    LimitPlace<Id> ordered = place;
    for (int i = 0; i < 4; ++i)
    {
      ordered.Corners[i] = this->Complex.TetVertices[4 * vtkIdType(tet) + i];
    }
    for (int& corner : ordered.Order)
    {
      corner = this->Complex.VertexInTet(tet, place.Corners[corner]);
    }
    this->Part = StartPart(ordered);
    for (int i = 0; i < 4; ++i)
    {
      this->Corners[i] = LatticeWeights{};
      this->Corners[i][i] = 1;
    }
  }
  void Split()
  {
    const int child = this->Part.FindChild(3);
    this->Part.GoToChild(3, child);
    const std::array<LatticeWeights, 4> old = this->Corners;
    for (int i = 0; i < 4; ++i)
    {
      const int point = ListChildren(3)[static_cast<std::size_t>(child)].Corners[i];
      const int* ends = point < 4 ? nullptr : GetEdgeEnds(3, point - 4);
      for (int k = 0; k < 4; ++k)
      {
        this->Corners[i][k] = ends ? old[ends[0]][k] + old[ends[1]][k] : 2 * old[point][k];
      }
    }
  }
  LatticeWeights Combine(const std::array<int, 4>& factors) const
  {
    LatticeWeights weights{};
    for (int i = 0; i < 4; ++i)
    {
      for (int k = 0; k < 4; ++k)
      {
        weights[k] += factors[i] * this->Corners[i][k];
      }
    }
    return weights;
  }

  /// Takes the polynomial over the part, if there is one.
  bool ReadPolynomial()
  {
    const auto& carriers = this->Part.Carriers;
    if (!std::all_of(
          carriers.begin(), carriers.end(), [this](int corners) { return this->Parts[corners]; }))
    {
      return false;
    }
    this->Sum.Clear();
    for (const BoxSplineNode& node : WeightBoxSpline(this->Part.At, this->Part.Directions))
    {
      const auto& steps = node.Steps;
      LatticeVertex<Id> vertex;
      if (!this->Regular.Find(this->Tet,
            this->Combine({ { 1 - steps[0], steps[0] - steps[1], steps[1] - steps[2], steps[2] } }),
            vertex))
      {
        return false;
      }
      this->Sum.Add(vertex, 1., node.Weights);
    }
    return true;
  }

  /// Takes derivatives of the polynomial between the limits of vertices of a small part, and the
  /// value of an even smaller one. `level`: of the part; then that of the sum.
  bool ReadSmallPart(int& level)
  {
    const std::vector<PartWeights> weights = WeightLattice(3, this->Part.At, this->Part.Directions);
    const std::vector<PlaceNode>& nodes = ListLattice(3);
    LatticeSum<Id> slopes;
    for (std::size_t n = 0; n < nodes.size(); ++n)
    {
      if (!this->AddLimit(nodes[n], weights[n], slopes))
      {
        return false;
      }
    }
    level += 2; // the nodes divide edges in four
    this->Split();
    this->Split();
    int last = level;
    for (; !this->ReadPolynomial(); ++last)
    {
      if (last == MostSplitsOfValues)
      {
        if (!this->ReadCorners())
        {
          return false;
        }
        break;
      }
      this->Split();
    }
    for (PartWeights& parts : this->Sum.Weights)
    {
      std::fill(parts.begin() + PlaceParts::Value + 1, parts.end(), 0.);
    }
    if (!this->StepBack(last, level))
    {
      return false;
    }
    for (std::size_t i = 0; i < slopes.Vertices.size(); ++i)
    {
      slopes.Weights[i][PlaceParts::Value] = 0.;
      this->Sum.Add(slopes.Vertices[i], 1., slopes.Weights[i]);
    }
    return true;
  }
  /// Takes the linear function between the limits of the part's corners.
  bool ReadCorners()
  {
    this->Sum.Clear();
    for (int i = 0; i < 4; ++i)
    {
      PlaceNode corner{};
      corner[i] = 1;
      if (!this->AddLimit(corner, PartWeights{ { this->Part.At[i] } }, this->Sum))
      {
        return false;
      }
    }
    return true;
  }
  bool AddLimit(const PlaceNode& node, const PartWeights& weights, LatticeSum<Id>& sum)
  {
    if (!this->Lattice.ReadLimit(this->Lattice.Find(3, this->Tet, this->Combine(node)), this->Row))
    {
      return false;
    }
    this->AddRow(weights, sum);
    return true;
  }

  void AddRow(const PartWeights& weights, LatticeSum<Id>& sum) const
  {
    for (std::size_t k = 0; k < this->Row.Vertices.size(); ++k)
    {
      sum.Add(this->Row.Vertices[k], this->Row.Weights[k], weights);
    }
  }
  /// Replaces the sum over vertices of a level by the same over an earlier one.
  bool StepBack(int level, int last)
  {
    for (; level > last; --level)
    {
      this->Before.Clear();
      for (std::size_t i = 0; i < this->Sum.Vertices.size(); ++i)
      {
        if (!this->Lattice.ReadRow(this->Sum.Vertices[i], this->Row))
        {
          return false;
        }
        this->AddRow(this->Sum.Weights[i], this->Before);
      }
      std::swap(this->Sum, this->Before);
    }
    return true;
  }
  void Write(SolidRow<Id>& row) const
  {
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

  const SimplicialComplex<Id>& Complex;
  SolidLattice<Id> Lattice;
  const RegularLattice<Id> Regular;
  Id Tet = -1;
  std::array<bool, 16> Parts{}; ///< of the tetrahedron that are regular
  PlaceInPart Part;
  std::array<LatticeWeights, 4> Corners{}; ///< of the part
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

}

template <typename Id>
std::vector<SolidRow<Id>> FindSolidRows(
  const Level<Id>& level, const std::vector<LimitPlace<Id>>& places)
{
  std::vector<SolidRow<Id>> rows(places.size());
  if (!level.Strata.Sectors.empty() ||
    std::none_of(places.begin(), places.end(),
      [](const LimitPlace<Id>& place) { return place.Dimension == 3; }))
  {
    return rows;
  }
  const TetTable<Id> tets(level.Complex, places);
  vtkSMPThreadLocal<std::shared_ptr<SolidPlaceFinder<Id>>> ofThreads;
  ForUnevenRanges(static_cast<vtkIdType>(places.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      std::shared_ptr<SolidPlaceFinder<Id>>& finder = ofThreads.Local();
      if (!finder)
      {
        finder = std::make_shared<SolidPlaceFinder<Id>>(level);
      }
      for (vtkIdType i = begin; i < end; ++i)
      {
        const auto place = static_cast<std::size_t>(i);
        const Id tet = places[place].Dimension == 3 ? tets.Find(places[place].Corners) : Id(-1);
        if (tet >= 0)
        {
          finder->Find(places[place], tet, rows[place]);
        }
      }
    });
  return rows;
}

SUBDIVISION_COMPILE_FUNCTION(FindSolidRows);

}
