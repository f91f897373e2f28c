// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CurvedPlaces.h
 * The rows of places at vertices, on curves and on triangles, without making a level.
 */
#ifndef SubdivisionObjects_CurvedPlaces_h
#define SubdivisionObjects_CurvedPlaces_h

#include "Core/Operators/PlaceSum.h"
#include "Core/Solids/Limits/LatticeCorners.h"
#include "Core/Solids/Limits/PlacePolynomial.h"
#include "Core/Solids/Limits/RegularParts.h"
#include "Core/Solids/Limits/SolidPlaces.h"

#include <algorithm>
#include <memory>
#include <type_traits>

namespace subdivision
{

/// Whether the limit over a part is one polynomial.
inline bool IsRegular(const PlaceInPart& part, int dimension, const RegularParts& regular)
{
  const auto first = part.Carriers.begin();
  return std::all_of(
    first, first + dimension + 1, [&regular](int carrier) { return regular[carrier]; });
}

/// Decides how often the simplex of a place is split whose limit is no polynomial: what matters is
/// how small the part is beside its distance from where the limit is not smooth, so splits count
/// from the last one on after which the part has its corners between others of the simplex.
class SplitCount
{
public:
  SplitCount(const PlaceInPart& part, int dimension)
    : Dimension(dimension)
    , Carriers(this->FlagCarriers(part))
  {
  }

  void Add(const PlaceInPart& part)
  {
    const unsigned int carriers = this->FlagCarriers(part);
    this->Splits = carriers == this->Carriers ? this->Splits + 1 : 0;
    this->Carriers = carriers;
  }
  bool IsEnough() const { return this->Splits >= MostSplits; }

private:
  unsigned int FlagCarriers(const PlaceInPart& part) const
  {
    unsigned int flags = 0;
    for (int i = 0; i <= this->Dimension; ++i)
    {
      flags |= 1u << static_cast<unsigned int>(part.Carriers[i]);
    }
    return flags;
  }

  const int Dimension;
  unsigned int Carriers; ///< a bit for each set of corners between which the part has some
  int Splits = 0;
};

/// The lattice that finds vertices on curves and surfaces.
template <typename Id>
const BoxSplineLattice<Id>& GetCurved(const BoxSplineLattice<Id>& lattice)
{
  return lattice;
}
template <typename Id>
const BoxSplineLattice<Id>& GetCurved(const TetOctLattice<Id>& lattice)
{
  return lattice.GetCurved();
}

/// A lattice as it is around a corner of a control simplex. There all levels look the same, so that
/// vertices of deep levels have the names of earlier ones, which fit into 64 bits.
template <typename LevelType>
class LatticeAtCorner
{
public:
  using Id = typename LevelType::IdType;
  using LevelRow = LatticeRow<Id>;

  /// Names are of this level, or a later one, where they are not those of the vertices: so near to
  /// the corner are all vertices on which a limit beside it depends.
  static constexpr int FirstAlike = 4;

  LatticeAtCorner(const LevelType& level, const LevelLattices<LevelType>& lattices)
    : Here(level)
    , Own(lattices.Make())
  {
  }

  /// The lattice that finds vertices on curves and surfaces.
  const BoxSplineLattice<Id>& GetCurved() const
  {
    return subdivision::GetCurved(this->Own->GetSmooth());
  }
  bool ReadLimit(const LatticeVertex<Id>& vertex, LevelRow& row)
  {
    return this->Own->ReadLimit(vertex, row);
  }
  bool ReadRow(const LatticeVertex<Id>& vertex, LevelRow& row) const
  {
    return this->Own->ReadRow(this->Shift > 0 ? this->Move(vertex) : vertex, row);
  }
  /// From now on rows belong to vertices with names of FirstAlike, and so many levels later.
  void SetShift(Id corner, int levels)
  {
    this->Corner = corner;
    this->Shift = levels;
  }

private:
  LatticeVertex<Id> Move(LatticeVertex<Id> vertex) const
  {
    const long long size = 1ll << FirstAlike;
    const long long more = (size << this->Shift) - size;
    if constexpr (std::is_same<LevelType, TetOctLevel<Id>>::value)
    {
      const Id oct = vertex.Simplex - this->Here.Complex.NumberOfTets;
      if (vertex.Dimension == 3 && oct >= 0)
      {
        const int number = VertexInOct(this->Here, oct, this->Corner);
        vertex.Weights[number / 2] += number % 2 == 0 ? -more : more;
        vertex.Weights[3] += more;
        return vertex;
      }
    }
    const Id* const corners = vertex.Dimension == 0
      ? &vertex.Simplex
      : this->GetCurved().GetCorners(vertex.Dimension, vertex.Simplex);
    vertex.Weights[std::find(corners, corners + vertex.Dimension, this->Corner) - corners] += more;
    return vertex;
  }

  const LevelType& Here;
  const std::shared_ptr<typename LevelLattices<LevelType>::Lattice> Own;
  Id Corner = -1;
  int Shift = 0;
};

/// Finds the row of one place after the other: of vertices, and on curves and triangles. These are
/// split around the place until the part is regular, or so small that the limit is linear. The row
/// is that of a polynomial then, or of the part's corners.
template <typename LevelType>
class PlaceFinder
{
public:
  using Id = typename LevelType::IdType;

  PlaceFinder(const LevelType& level, const LevelLattices<LevelType>& lattices, bool hasDerivatives)
    : Lattice(level, lattices)
    , HasDerivatives(hasDerivatives)
  {
  }

  /// Before `sharpSteps` splits nothing is regular.
  void Find(const LimitPlace<Id>& place, const RegularSimplex<Id>& simplex, int sharpSteps,
    PlaceRow<Id>& row)
  {
    const int dimension = place.Dimension;
    PlaceInPart part = StartPart(place, simplex);
    LatticeCorners corners{};
    for (int i = 0; i <= dimension; ++i)
    {
      corners[i][i] = 1;
    }
    SplitCount count(part, dimension);
    int level = 0;
    int shift = 0; // how many levels names do not count
    int first = 0; // the corner of the simplex to which the place is next
    bool isAtFirst = true;
    for (; dimension > 0 && level - shift < MostLevels && !this->IsAtCorner(part) &&
      (level < sharpSteps || (!IsRegular(part, dimension, simplex.Parts) && !count.IsEnough()));
      ++level)
    {
      const int child = part.FindChild(dimension);
      first = level == 0 ? child : first;
      isAtFirst = isAtFirst && child == first && child <= dimension;
      part.GoToChild(dimension, child);
      count.Add(part);
      if (isAtFirst && level >= LatticeAtCorner<LevelType>::FirstAlike && sharpSteps == 0)
      {
        ++shift; // the part has the same names
        continue;
      }
      GoToChild(dimension, child, corners);
    }
    this->Sum.Clear();
    const bool hasPolynomial = !this->IsAtCorner(part) && IsRegular(part, dimension, simplex.Parts);
    hasPolynomial ? this->AddNodes(part, dimension, simplex, corners)
                  : this->AddCorners(part, dimension, simplex, corners);
    int left = level - shift + (hasPolynomial ? 2 : 0);
    if (shift > 0)
    {
      this->Sum.StepBack(left - LatticeAtCorner<LevelType>::FirstAlike);
      left = LatticeAtCorner<LevelType>::FirstAlike + shift - 1;
      this->Lattice.SetShift(simplex.Corners[first], shift);
      this->Sum.StepBack(1, true);
      this->Lattice.SetShift(-1, 0);
    }
    this->Sum.StepBack(left, shift > 0);
    this->Sum.Write(row);
  }

private:
  static constexpr int MostLevels = 59; ///< multiples of 1/2^61 fit into 64 bits

  /// At a corner of a part the limit is that of a vertex, but for its derivatives.
  bool IsAtCorner(const PlaceInPart& part) const
  {
    return !this->HasDerivatives && std::find(part.At.begin(), part.At.end(), 1.) != part.At.end();
  }
  /// `weights`: of the simplex's corners in their order there.
  void AddLimit(int dimension, const RegularSimplex<Id>& simplex, const LatticeWeights& weights,
    const PartWeights& factors)
  {
    const BoxSplineLattice<Id>& curved = this->Lattice.GetCurved();
    LatticeWeights listed = weights;
    for (int k = 0; dimension > 0 && k <= dimension; ++k)
    {
      const Id* const corners = curved.GetCorners(dimension, simplex.Number);
      const auto corner = std::find(simplex.Corners.begin(), simplex.Corners.end(), corners[k]);
      listed[k] = weights[corner - simplex.Corners.begin()];
    }
    this->Sum.AddLimit(curved.Find(dimension, simplex.Number, listed), factors);
  }
  void AddNodes(const PlaceInPart& part, int dimension, const RegularSimplex<Id>& simplex,
    const LatticeCorners& corners)
  {
    const auto weights = WeightLattice(dimension, part.At, part.Directions);
    const std::vector<PlaceNode>& nodes = ListLattice(dimension);
    for (std::size_t n = 0; n < nodes.size(); ++n)
    {
      this->AddLimit(dimension, simplex, CombineCorners(corners, nodes[n]), weights[n]);
    }
  }
  void AddCorners(const PlaceInPart& part, int dimension, const RegularSimplex<Id>& simplex,
    const LatticeCorners& corners)
  {
    for (int i = 0; i <= dimension; ++i)
    {
      const auto& directions = part.Directions;
      this->AddLimit(dimension, simplex, corners[i],
        { { part.At[i], directions[0][i], directions[1][i], directions[2][i] } });
    }
  }

  LatticeAtCorner<LevelType> Lattice;
  const bool HasDerivatives;
  PlaceSum<LatticeAtCorner<LevelType>> Sum{ this->Lattice };
};

}

#endif
