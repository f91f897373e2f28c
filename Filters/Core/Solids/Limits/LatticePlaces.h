// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LatticePlaces.h
 * Where the vertices of a local refinement (LocalLimit.h) lie on a lattice.
 */
#ifndef SubdivisionObjects_LatticePlaces_h
#define SubdivisionObjects_LatticePlaces_h

#include "Core/Memory/Ids.h"
#include "Core/Operators/VertexRow.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Limits/BoxSplineLattice.h"

#include <algorithm>
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
  bool Find(const std::vector<std::array<Id, 2>>& midpoints)
  {
    this->Midpoints.reserve(midpoints.size());
    for (const auto& ends : InTurn(midpoints))
    {
      Place place;
      const Id next = this->GetNumberOfVertices();
      if (ends[0] < 0 || ends[1] < 0 || ends[0] >= next || ends[1] >= next ||
        !this->Unite(ends, place))
      {
        return false;
      }
      this->Midpoints.push_back(place);
    }
    this->FindSimplices();
    return std::none_of(this->Midpoints.begin(), this->Midpoints.end(),
      [this](const Place& place) { return this->Simplices[place.Carrier].Number < 0; });
  }

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
    std::uint64_t GetHash() const
    {
      std::uint64_t hash = 0;
      for (const Id corner : this->Corners)
      {
        hash = (hash ^ static_cast<std::uint64_t>(corner)) * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 32;
      }
      return hash;
    }
    int GetSize() const
    {
      const auto isCorner = [](Id corner) { return corner >= 0; };
      return static_cast<int>(std::count_if(this->Corners.begin(), this->Corners.end(), isCorner));
    }
    /// Adds a corner, so that all ascend.
    void Add(Id corner)
    {
      int k = this->GetSize();
      for (; k > 0 && corner < this->Corners[k - 1]; --k)
      {
        this->Corners[k] = this->Corners[k - 1];
      }
      this->Corners[k] = corner;
    }
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
  LatticeVertex<Id> GetMidpoint(Id vertex) const
  {
    const Place& place = this->Midpoints[vertex - this->First];
    const Simplex& simplex = this->Simplices[place.Carrier];
    LatticeVertex<Id> found;
    found.Dimension = this->Carriers.Vertices[place.Carrier].GetSize() - 1;
    found.Simplex = simplex.Number;
    if (simplex.IsOct)
    {
      for (int k = 0; k <= found.Dimension; ++k)
      {
        const int number = simplex.Order[k];
        found.Weights[number / 2] += number % 2 == 0 ? -place.Weights[k] : place.Weights[k];
        found.Weights[3] += place.Weights[k];
      }
      found.Dimension = 3;
      return found;
    }
    for (int k = 0; k <= found.Dimension; ++k)
    {
      found.Weights[k] = place.Weights[simplex.Order[k]];
    }
    return found;
  }

  /// Finds the place between two others. False: they lie in no simplex.
  bool Unite(const std::array<Id, 2>& ends, Place& place)
  {
    const Place a = this->GetPlace(ends[0]);
    const Place b = this->GetPlace(ends[1]);
    place.Level = 1 + std::max(a.Level, b.Level);
    place.Carrier = a.Carrier;
    if (a.Carrier != b.Carrier)
    {
      const auto& first = this->Carriers.Vertices[a.Carrier].Corners;
      const auto& second = this->Carriers.Vertices[b.Carrier].Corners;
      std::array<Id, 8> corners;
      const auto isEnd = [](Id corner) { return corner < 0; };
      const auto last =
        std::set_union(first.begin(), std::find_if(first.begin(), first.end(), isEnd),
          second.begin(), std::find_if(second.begin(), second.end(), isEnd), corners.begin());
      if (last - corners.begin() > 4)
      {
        return false;
      }
      Carrier both{ { { -1, -1, -1, -1 } } };
      std::copy(corners.begin(), last, both.Corners.begin());
      place.Carrier = static_cast<Id>(this->Carriers.GetNumber(both));
    }
    const LatticeWeights ofFirst = this->GetWeights(a, place.Carrier);
    const LatticeWeights ofSecond = this->GetWeights(b, place.Carrier);
    for (int i = 0; i < 4; ++i)
    {
      place.Weights[i] =
        (ofFirst[i] << (place.Level - 1 - a.Level)) + (ofSecond[i] << (place.Level - 1 - b.Level));
    }
    return place.Level <= MostLevels;
  }
  /// The weights of the corners of a larger carrier.
  LatticeWeights GetWeights(const Place& place, Id carrier) const
  {
    if (place.Carrier == carrier)
    {
      return place.Weights;
    }
    LatticeWeights weights{};
    const auto& from = this->Carriers.Vertices[place.Carrier].Corners;
    const auto& to = this->Carriers.Vertices[carrier].Corners;
    for (int i = 0, k = 0; i < 4 && from[i] >= 0; ++i, ++k)
    {
      while (to[k] != from[i])
      {
        ++k;
      }
      weights[k] = place.Weights[i];
    }
    return weights;
  }
  void FindSimplices()
  {
    this->Simplices.resize(this->Carriers.Vertices.size());
    for (std::size_t c = 0; c < this->Simplices.size(); ++c)
    {
      const Carrier& carrier = this->Carriers.Vertices[c];
      if (carrier.GetSize() == 1)
      {
        this->Simplices[c].Number = carrier.Corners[0];
      }
    }
    this->FindSimplicesAmong(this->Complex.EdgeVertices, 2);
    this->FindSimplicesAmong(this->Complex.FaceVertices, 3);
    this->FindSimplicesAmong(this->Complex.TetVertices, 4);
    this->OctVertices ? this->FindPieces() : void();
  }
  void FindSimplicesAmong(const Buffer<Id>& vertices, int size)
  {
    Buffer<unsigned char> isCorner(this->Complex.NumberOfVertices, 0);
    for (const Carrier& carrier : InTurn(this->Carriers.Vertices))
    {
      for (int k = 0; carrier.GetSize() == size && k < size; ++k)
      {
        isCorner[carrier.Corners[k]] = 1;
      }
    }
    ForEachInTurn(vertices.size() / size,
      [&](vtkIdType i)
      {
        const Id* corners = vertices.data() + size * i;
        if (!std::all_of(corners, corners + size, [&](Id v) { return isCorner[v] != 0; }))
        {
          return;
        }
        Carrier carrier{ { { -1, -1, -1, -1 } } };
        std::for_each(corners, corners + size, [&carrier](Id corner) { carrier.Add(corner); });
        const std::ptrdiff_t found = this->Carriers.Find(carrier);
        if (found >= 0)
        {
          Simplex& simplex = this->Simplices[static_cast<std::size_t>(found)];
          simplex.Number = static_cast<Id>(i);
          for (int k = 0; k < size; ++k)
          {
            simplex.Order[k] = static_cast<signed char>(
              std::find(carrier.Corners.begin(), carrier.Corners.end(), corners[k]) -
              carrier.Corners.begin());
          }
        }
      });
  }

  /// Finds the vertices with a diagonal of an octahedron among their corners.
  void FindPieces()
  {
    ForEachInTurn(this->OctVertices->size() / 6,
      [&](vtkIdType oct)
      {
        const Id* vertices = this->OctVertices->data() + 6 * oct;
        for (int piece = 0; piece < 27; ++piece)
        {
          const int diagonal = piece / 9;
          Carrier carrier{ { { -1, -1, -1, -1 } } };
          carrier.Add(vertices[2 * diagonal]);
          carrier.Add(vertices[2 * diagonal + 1]);
          const int others[2] = { piece % 3, piece / 3 % 3 }; // 2: none
          for (int i = 0; i < 2; ++i)
          {
            others[i] < 2 ? carrier.Add(vertices[2 * ((diagonal + i + 1) % 3) + others[i]])
                          : void();
          }
          const std::ptrdiff_t found = this->Carriers.Find(carrier);
          if (found >= 0)
          {
            Simplex& simplex = this->Simplices[static_cast<std::size_t>(found)];
            simplex.Number = static_cast<Id>(this->Complex.NumberOfTets + oct);
            simplex.IsOct = true;
            for (int k = 0; k < carrier.GetSize(); ++k)
            {
              simplex.Order[k] = static_cast<signed char>(
                std::find(vertices, vertices + 6, carrier.Corners[k]) - vertices);
            }
          }
        }
      });
  }

  const SimplicialComplex<Id>& Complex;
  const Buffer<Id>* const OctVertices = nullptr; ///< null: there are no octahedra
  const Id First;                                ///< midpoint
  VertexNumbers<Carrier> Carriers;
  std::vector<Simplex> Simplices; ///< of each carrier
  std::vector<Place> Midpoints;
};

}

#endif
