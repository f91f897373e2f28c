// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LatticePlaces.h
 * Where the vertices of a local refinement (LocalLimit.h) lie on a lattice.
 */
#ifndef SubdivisionObjects_LatticePlaces_h
#define SubdivisionObjects_LatticePlaces_h

#include "Core/Operators/VertexRow.h"
#include "Core/Solids/Limits/BoxSplineLattice.h"

#include <array>
#include <vector>

namespace subdivision
{

template <typename Id>
class LatticePlaces
{
public:
  /// `complex` is that of the control level. It must outlive this.
  explicit LatticePlaces(const SimplicialComplex<Id>& complex)
    : Complex(complex)
    , First(complex.NumberOfVertices)
  {
  }

  /// Finds the places of control vertices and of midpoints, which are as in the constructor of
  /// LocalLimit, but that the edges are not looked for. False: one lies in no simplex, or first is
  /// on a level that is too fine.
  bool Find(const std::vector<std::array<Id, 2>>& midpoints);

  /// Control vertices, then midpoints.
  Id GetNumberOfVertices() const { return this->First + static_cast<Id>(this->Midpoints.size()); }
  /// The level on which a vertex first exists.
  int GetLevel(Id vertex) const
  {
    return vertex < this->First ? 0 : this->Midpoints[vertex - this->First].Level;
  }
  /// A number that midpoints in the same control simplex share.
  Id GetCarrier(Id vertex) const { return this->Midpoints[vertex - this->First].Carrier; }
  /// A midpoint on its level.
  LatticeVertex<Id> GetMidpoint(Id vertex) const;

private:
  static constexpr int MostLevels = 50;

  /// The corners of a control simplex, ascending; then -1.
  struct Carrier
  {
    std::array<Id, 4> Corners;
    bool operator==(const Carrier& other) const { return this->Corners == other.Corners; }
    std::uint64_t GetHash() const;
    int GetSize() const;
  };
  struct Simplex
  {
    Id Number = -1;
    /// Which of the carrier's corners is the first, second, ... one as the complex lists them.
    std::array<signed char, 4> Order{};
  };
  struct Place
  {
    Id Carrier;
    int Level;
    LatticeWeights Weights; ///< of the corners of the carrier, multiples of 1/2^Level
  };

  /// Of control vertices those that are asked for get a carrier.
  Place GetPlace(Id vertex)
  {
    return vertex >= this->First
      ? this->Midpoints[vertex - this->First]
      : Place{ static_cast<Id>(this->Carriers.GetNumber({ { { vertex, -1, -1, -1 } } })), 0,
          { { 1, 0, 0, 0 } } };
  }
  bool Unite(const std::array<Id, 2>& ends, Place& place);
  LatticeWeights GetWeights(const Place& place, Id carrier) const;
  void FindSimplices();
  void FindSimplicesAmong(const Buffer<Id>& vertices, int size);

  const SimplicialComplex<Id>& Complex;
  const Id First; ///< midpoint
  VertexNumbers<Carrier> Carriers;
  std::vector<Simplex> Simplices; ///< of each carrier
  std::vector<Place> Midpoints;
};

}

#endif
