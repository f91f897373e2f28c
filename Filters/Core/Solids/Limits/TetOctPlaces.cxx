// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/TetOctPlaces.h"

#include "Core/Solids/Limits/SolidPlaces.h"
#include "Core/Solids/Limits/TetOctLattice.h"

#include <memory>

namespace subdivision
{
namespace
{

/// Vertices as TetOctLattice has them, with the same denominator on all levels.
struct LatticeMidpoints
{
  LatticeWeights GetMidpoint(const LatticeWeights& a, const LatticeWeights& b) const
  {
    LatticeWeights middle{};
    for (std::size_t i = 0; i < middle.size(); ++i)
    {
      middle[i] = (a[i] + b[i]) / 2;
    }
    return middle;
  }
};

/// Finds the row of one place after the other.
template <typename Id>
class TetOctPlaceFinder
{
public:
  TetOctPlaceFinder(
    const TetOctLevel<Id>& level, const Rows<Id>& solidsAtVertices, const SharpSimplices<Id>& sharp)
    : Here(level)
    , Lattice(level, solidsAtVertices, sharp)
  {
  }

  void FindInTet(const LimitPlace<Id>& place, Id tet, PlaceRow<Id>& row)
  {
    std::array<LatticeWeights, 4> corners{};
    for (int i = 0; i < 4; ++i)
    {
      corners[i][this->Here.Complex.VertexInTet(tet, place.Corners[i])] = Size;
    }
    this->Find(TetOctPlace<LatticeWeights>(corners, StartPart(place)), tet, row);
  }
  void FindInOct(const LimitPlace<Id>& place, Id oct, PlaceRow<Id>& row)
  {
    std::array<LatticeWeights, 6> vertices{};
    for (int i = 0; i < 6; ++i)
    {
      vertices[i][i / 2] = i % 2 == 0 ? -Size : Size;
      vertices[i][3] = Size;
    }
    std::array<LatticeWeights, 4> corners{};
    for (int i = 0; i < 4; ++i)
    {
      corners[i] = vertices[VertexInOct(this->Here, oct, place.Corners[i])];
    }
    this->Find(TetOctPlace<LatticeWeights>(vertices.data(), corners, StartPart(place)),
      this->Here.Complex.NumberOfTets + oct, row);
  }

private:
  /// The level of the vertices between which the limit is linear. One of them may be the centre of
  /// an octahedron, which the next step makes.
  static constexpr int Level = MostSplits + 1;
  static constexpr long long Size = 1ll << Level;

  /// Leaves the row empty if a rule near the place is unknown.
  void Find(TetOctPlace<LatticeWeights> inside, Id solid, PlaceRow<Id>& row)
  {
    LatticeMidpoints midpoints;
    for (int splits = 0; splits < MostSplits; ++splits)
    {
      inside.Split(midpoints);
    }
    std::vector<LatticeWeights> vertices;
    std::vector<PartWeights> weights;
    inside.Finish(midpoints, vertices, weights);
    this->Sum.Clear();
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      if (!this->Sum.AddLimit(this->Lattice.Find(solid, vertices[i]), weights[i]))
      {
        return;
      }
    }
    if (this->Sum.StepBack(Level))
    {
      this->Sum.Write(row);
    }
  }

  const TetOctLevel<Id>& Here;
  TetOctLattice<Id> Lattice;
  PlaceSum<TetOctLattice<Id>> Sum{ this->Lattice };
};

}

template <typename Id>
std::vector<PlaceRow<Id>> FindSolidRows(const TetOctLevel<Id>& level,
  const SemiSharpStages<Id>& creases, const std::vector<LimitPlace<Id>>& places)
{
  using Finder = TetOctPlaceFinder<Id>;
  const SimplicialComplex<Id>& complex = level.Complex;
  const Buffer<unsigned char> isCorner = FlagCorners(complex.NumberOfVertices, places, true);
  const SimplexTable<Id, 4> tets(complex.NumberOfTets, isCorner, complex.TetVertices);
  const SimplexTable<Id, 4> pieces = ListOctPieces(level, isCorner);
  const Rows<Id> solidsAtVertices = ListSolidsAtVertices(level);
  return FindSolidRowsInThreads(
    level, creases, places, [&](const SharpSimplices<Id>& sharp)
    { return std::make_shared<Finder>(level, solidsAtVertices, sharp); },
    [&](Finder& finder, const LimitPlace<Id>& place, PlaceRow<Id>& row)
    {
      const Id piece = pieces.Find(place.Corners.data());
      const Id tet = piece >= 0 ? Id(-1) : tets.Find(place.Corners.data());
      piece >= 0   ? finder.FindInOct(place, piece / PiecesOfOct, row)
        : tet >= 0 ? finder.FindInTet(place, tet, row)
                   : void();
    });
}

template std::vector<PlaceRow<int>> FindSolidRows(
  const TetOctLevel<int>&, const SemiSharpStages<int>&, const std::vector<LimitPlace<int>>&);
template std::vector<PlaceRow<long long>> FindSolidRows(const TetOctLevel<long long>&,
  const SemiSharpStages<long long>&, const std::vector<LimitPlace<long long>>&);

}
