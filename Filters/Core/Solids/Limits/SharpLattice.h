// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SharpLattice.h
 * A lattice (BoxSplineLattice.h, TetOctLattice.h) with what is semi-sharp: on which level a vertex
 * is says which step makes it, and so how much of the sharpness is left (Mathematics 5).
 */
#ifndef SubdivisionObjects_SharpLattice_h
#define SubdivisionObjects_SharpLattice_h

#include "Core/Operators/PlaceSum.h"
#include "Core/Solids/Limits/TetOctLattice.h"
#include "Core/Solids/Scheme/SharpSectors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <memory>
#include <type_traits>
#include <vector>

namespace subdivision
{

/// What is semi-sharp on the control level. Threads share it.
template <typename Id>
class SharpSimplices
{
public:
  /// All must outlive this. `strata`: those of the level of `complex`.
  SharpSimplices(const SimplicialComplex<Id>& complex, const Strata<Id>& strata,
    const SemiSharpStages<Id>& creases);

  const SemiSharpStages<Id>& GetCreases() const { return this->Creases; }
  /// Whether there is anything.
  bool IsEmpty() const { return this->Flags[0].empty(); }
  /// Whether rows of vertices inside a simplex depend on what is semi-sharp, on any level.
  bool Has(int dimension, Id simplex) const
  {
    return dimension < 3 && !this->Flags[dimension].empty() && this->Flags[dimension][simplex] != 0;
  }
  /// What is left after some steps, a mean; 0: nothing.
  double GetSharpness(int dimension, Id simplex, int steps) const
  {
    return dimension >= 2
      ? std::max(0., this->GetOfFace(dimension, simplex) - steps)
      : this->Parts.GetSharpness(dimension * this->NumberOfVertices + simplex, steps);
  }
  double GetMostSharpness(int dimension, Id simplex) const
  {
    return dimension >= 2
      ? this->GetOfFace(dimension, simplex)
      : this->Parts.GetMostSharpness(dimension * this->NumberOfVertices + simplex);
  }

private:
  /// Of a face; 0 in solids.
  double GetOfFace(int dimension, Id simplex) const
  {
    const Buffer<double>& all = this->Creases.FaceSharpness;
    return dimension > 2 || all.empty() ? 0. : std::min<double>(all[simplex], SharpForever);
  }

  const SemiSharpStages<Id>& Creases;
  const vtkIdType NumberOfVertices;
  const SharpParts Parts;
  std::array<Buffer<unsigned char>, 3> Flags; ///< by the dimension; all empty if there is nothing
};

/// Threads have one each.
template <typename Id, typename Lattice>
class SharpLattice
{
public:
  using LevelRow = LatticeRow<Id>;

  /// All must outlive this. `more`: what the lattice takes besides.
  template <typename LevelType, typename... More>
  SharpLattice(const LevelType& level, const SharpSimplices<Id>& sharp, const More&... more)
    : Complex(level.Complex)
    , Smooth(level, level.Strata, more...)
    , Sharp(sharp)
  {
    this->Sectors.push_back(&level.Strata.Sectors);
    for (const SharpStage<Id>& stage : sharp.GetCreases().Stages)
    {
      this->OfStages.emplace_back(level, stage.Strata, more...);
      this->Sectors.push_back(&stage.Strata.Sectors);
    }
  }

  /// Knows where vertices are.
  const Lattice& GetSmooth() const { return this->Smooth; }
  /// Knows where vertices on curves and surfaces are.
  const BoxSplineLattice<Id>& GetCurved() const
  {
    if constexpr (std::is_same<Lattice, BoxSplineLattice<Id>>::value)
    {
      return this->Smooth;
    }
    else
    {
      return this->Smooth.GetCurved();
    }
  }
  bool IsSharp(int dimension, Id simplex) const { return this->Sharp.Has(dimension, simplex); }

  /// The row of a vertex over the level before it. False: a rule is unknown.
  bool ReadRow(const LatticeVertex<Id>& vertex, LatticeRow<Id>& row) const
  {
    return this->Sharp.Has(vertex.Dimension, vertex.Simplex)
      ? this->ReadBlend(vertex, CountLevels(vertex) - 1, row)
      : this->Smooth.ReadRow(vertex, row);
  }
  /// Makes a row over the level before of one over a level. False: a rule is unknown.
  bool StepBack(LatticeRow<Id>& row) const;
  /// The limit of a vertex over its own level (Mathematics 8).
  bool ReadLimit(const LatticeVertex<Id>& vertex, LatticeRow<Id>& row)
  {
    if (this->IsNextOther(vertex))
    {
      return this->ReadLimit(vertex.Double(), row) && this->StepBack(row);
    }
    const double most = this->GetSharpnessLeft(vertex);
    return most > 0. ? this->ReadSharpLimit(vertex, static_cast<int>(std::ceil(most)), row)
                     : this->Smooth.ReadLimit(vertex, row);
  }
  /// The rows of a star (ShadingNormals.h): where `size` of its items, after the vertex itself, lie
  /// in the end, seen from the vertex. It has no item twice, and all that its rows read; on one
  /// control simplex all stars have the same items in the same order. `corners` and `made` as in
  /// FindStarRows. False: a rule is unknown.
  bool ReadStar(const LatticeStar<Id>& star, std::size_t size,
    const std::vector<std::array<int, 2>>& corners, int made, std::vector<LatticeRow<Id>>& rows);

  /// On which level a vertex is.
  static int CountLevels(const LatticeVertex<Id>& vertex)
  {
    const LatticeWeights& weights = vertex.Weights;
    long long size = weights[0] + weights[1] + weights[2] + weights[3];
    int levels = 0;
    for (; size > 1; size /= 2)
    {
      ++levels;
    }
    return levels;
  }
  /// Whether rules around a vertex are others in the next step than in later ones: on the control
  /// level, and on a control edge beside an end at which there are sectors.
  bool IsNextOther(const LatticeVertex<Id>& vertex) const
  {
    const auto hasSectors = [&](const std::vector<SectorEdge<Id>>* sectors)
    { return !FindSectorEdges(*sectors, vertex.Simplex).IsEmpty(); };
    const LatticeWeights& weights = vertex.Weights;
    return (vertex.Dimension == 0 && weights[0] == 1) ||
      (vertex.Dimension == 1 && std::min(weights[0], weights[1]) == 1 &&
        std::any_of(this->Sectors.begin(), this->Sectors.end(), hasSectors));
  }
  /// How much of the sharpness at a vertex is left after the steps that made it.
  double GetSharpnessLeft(const LatticeVertex<Id>& vertex) const
  {
    return this->Sharp.Has(vertex.Dimension, vertex.Simplex)
      ? this->Sharp.GetMostSharpness(vertex.Dimension, vertex.Simplex) - CountLevels(vertex)
      : 0.;
  }

private:
  using Sum = VertexSum<LatticeVertex<Id>, std::array<double, 1>>;

  std::size_t FindStage(int step) const
  {
    const auto& stages = this->Sharp.GetCreases().Stages;
    const auto found = std::find_if(stages.begin(), stages.end(),
      [step](const SharpStage<Id>& stage) { return stage.Until > step; });
    return static_cast<std::size_t>(found - stages.begin()) - (found == stages.end() ? 1 : 0);
  }

  bool ReadSharpLimit(const LatticeVertex<Id>& vertex, int steps, LatticeRow<Id>& row);
  bool GoBack(const LatticeStar<Id>& star, int steps, LatticeRow<Id>& row) const;
  bool ReadBlend(const LatticeVertex<Id>& vertex, int step, LatticeRow<Id>& row) const;
  double GetWeight(const LatticeVertex<Id>& vertex, int step) const;
  static void Write(const Sum& sum, LatticeRow<Id>& row)
  {
    row.Clear();
    for (std::size_t i = 0; i < sum.Vertices.size(); ++i)
    {
      row.Add(sum.Vertices[i], sum.OfVertices[i][0]);
    }
  }
  static void AddTo(Sum& sum, double factor, const LatticeRow<Id>& row)
  {
    for (std::size_t k = 0; k < row.Vertices.size(); ++k)
    {
      sum.Add(row.Vertices[k], row.Weights[k], { { factor } });
    }
  }

  const SimplicialComplex<Id>& Complex;
  Lattice Smooth;
  const SharpSimplices<Id>& Sharp;
  std::deque<Lattice> OfStages;
  LatticeLimits Stars{ 256 };
  std::vector<const std::vector<SectorEdge<Id>>*> Sectors; ///< smooth ones, those of stages
};

/// The lattices of a level, one for each thread. `level` was made with Depth::ForRefinement, or is
/// the control level. Both arguments must outlive this.
template <typename LevelType>
class LevelLattices
{
public:
  using Id = typename LevelType::IdType;
  static constexpr bool IsTetOct = std::is_same<LevelType, TetOctLevel<Id>>::value;
  using Lattice = SharpLattice<Id,
    typename std::conditional<IsTetOct, TetOctLattice<Id>, BoxSplineLattice<Id>>::type>;

  LevelLattices(const LevelType& level, const SemiSharpStages<Id>& creases)
    : Here(level)
    , Sharp(level.Complex, level.Strata, creases)
  {
    if constexpr (IsTetOct)
    {
      this->SolidsAt = ListSolidsAtVertices(level);
    }
  }
  LevelLattices(const LevelLattices&) = delete; // lattices refer to it
  LevelLattices& operator=(const LevelLattices&) = delete;

  const SharpSimplices<Id>& GetSharp() const { return this->Sharp; }
  std::shared_ptr<Lattice> Make() const
  {
    if constexpr (IsTetOct)
    {
      return std::make_shared<Lattice>(this->Here, this->Sharp, this->SolidsAt);
    }
    else
    {
      return std::make_shared<Lattice>(this->Here, this->Sharp);
    }
  }

private:
  const LevelType& Here;
  const SharpSimplices<Id> Sharp;
  Rows<Id> SolidsAt; ///< of the tet/oct scheme
};

}

#endif
