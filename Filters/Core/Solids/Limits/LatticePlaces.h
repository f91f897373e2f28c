// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LatticePlaces.h
 * Where the vertices of a local refinement (LocalLimit.h) lie on a lattice.
 */
#ifndef SubdivisionObjects_LatticePlaces_h
#define SubdivisionObjects_LatticePlaces_h

#include "Core/Operators/VertexRow.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Limits/BoxSplineLattice.h"

#include <array>
#include <vector>

namespace subdivision
{

template <typename Id>
class LatticePlaces
{
public:
  /// `level` is the control level. It must outlive this.
  explicit LatticePlaces(const Level<Id>& level)
    : Complex(level.Complex)
    , First(level.Complex.NumberOfVertices)
  {
  }
  explicit LatticePlaces(const TetOctLevel<Id>& level)
    : Complex(level.Complex)
    , OctVertices(&level.OctVertices)
    , First(level.Complex.NumberOfVertices)
  {
  }

  /// Finds the places of control vertices and of midpoints, which are as in the constructor of
  /// LocalLimit, but that the edges are not looked for. False: one lies in no simplex and no piece
  /// of an octahedron, or first is on a level that is too fine.
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
  /// A vertex on its level.
  LatticeVertex<Id> GetVertex(Id vertex) const
  {
    return vertex < this->First ? LatticeVertex<Id>{ 0, vertex, { { 1, 0, 0, 0 } } }
                                : this->GetMidpoint(vertex);
  }

private:
  static constexpr int MostLevels = 61; // all weights are sums that fit into 64 bits

  /// The corners of a control simplex, ascending; then -1.
  struct Carrier
  {
    std::array<Id, 4> Corners;
    bool operator==(const Carrier& other) const { return this->Corners == other.Corners; }
    std::uint64_t GetHash() const;
    int GetSize() const;
    void Add(Id corner);
  };
  struct Simplex
  {
    Id Number = -1;
    /// Which of the carrier's corners is the first, second, ... one as the complex lists them; of a
    /// piece of an octahedron, which of its vertices each of the carrier's corners is.
    std::array<signed char, 4> Order{};
    bool IsOct = false;
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
  LatticeVertex<Id> GetMidpoint(Id vertex) const;
  bool Unite(const std::array<Id, 2>& ends, Place& place);
  LatticeWeights GetWeights(const Place& place, Id carrier) const;
  void FindSimplices();
  void FindSimplicesAmong(const Buffer<Id>& vertices, int size);
  void FindPieces();

  const SimplicialComplex<Id>& Complex;
  const Buffer<Id>* const OctVertices = nullptr; ///< null: there are no octahedra
  const Id First;                                ///< midpoint
  VertexNumbers<Carrier> Carriers;
  std::vector<Simplex> Simplices; ///< of each carrier
  std::vector<Place> Midpoints;
};

}

#endif
