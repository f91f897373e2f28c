// SPDX-License-Identifier: BSD-3-Clause
// A place in a solid of the tet/oct scheme, by steps to ever smaller tetrahedra and octahedra
// around it.
#include "Core/Solids/Limits/SolidPlaces.h"

#include "Core/Solids/Limits/PlacePolynomial.h"
#include "Core/Solids/Limits/SimplexTable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <vector>

namespace subdivision
{
namespace
{

/**
 * Where a place is in the tetrahedron or octahedron to which the steps have come, and how that
 * changes with the parameters: first the place, then its three derivatives. In a tetrahedron these
 * are weights of its corners. An octahedron has three diagonals from a vertex at -1 to one at 1,
 * and a place has coordinates along these, whose absolute values sum to 1 at most. Vertices
 * are as TetOctLattice has them, with the same denominator on all levels.
 */
class TetOctPlace
{
public:
  using Vertex = LatticeWeights;

  TetOctPlace(const std::array<Vertex, 4>& corners, const PlaceInPart& place)
    : Tet(corners)
    , At{ { place.At, place.Directions[0], place.Directions[1], place.Directions[2] } }
  {
  }

  /// The place lies in a piece of an octahedron, which has four of its six `vertices`.
  TetOctPlace(
    const Vertex* vertices, const std::array<Vertex, 4>& corners, const PlaceInPart& place)
    : TetOctPlace(corners, place)
  {
    this->IsOct = true;
    for (CornerWeights& at : this->At)
    {
      const CornerWeights weights = at;
      at = CornerWeights{};
      for (int i = 0; i < 4; ++i)
      {
        const auto number =
          static_cast<int>(std::find(vertices, vertices + 6, corners[i]) - vertices);
        at[number / 2] += number % 2 == 0 ? -weights[i] : weights[i];
      }
    }
    for (int k = 0; k < 3; ++k)
    {
      this->Oct[k] = { { vertices[2 * k], vertices[2 * k + 1] } };
    }
  }

  /// Goes on to the part of a step with the place.
  void Split() { this->IsOct ? this->SplitOct() : this->SplitTet(); }
  /// Adds four vertices of one level around the place, and the weight of each in the value and the
  /// three first derivatives of the function that is linear between them. Second derivatives are 0.
  void Finish(
    std::vector<Vertex>& vertices, std::vector<std::array<double, PlaceParts::Count>>& weights)
  {
    if (this->IsOct)
    {
      this->GoToFace();
    }
    for (int i = 0; i < 4; ++i)
    {
      vertices.push_back(this->Tet[i]);
      weights.push_back({ { this->At[0][i], this->At[1][i], this->At[2][i], this->At[3][i] } });
    }
  }

private:
  static Vertex GetMidpoint(const Vertex& a, const Vertex& b)
  {
    Vertex middle{};
    for (std::size_t i = 0; i < middle.size(); ++i)
    {
      middle[i] = (a[i] + b[i]) / 2;
    }
    return middle;
  }
  void SplitTet()
  {
    for (int corner = 0; corner < 4; ++corner)
    {
      if (this->At[0][corner] >= 0.5)
      {
        for (int i = 0; i < 4; ++i)
        {
          if (i != corner)
          {
            this->Tet[i] = GetMidpoint(this->Tet[corner], this->Tet[i]);
          }
        }
        this->Double();
        // Not what is left of the corner's own weight: each split would double its error.
        CornerWeights& at = this->At[0];
        at[corner] = 0.;
        at[corner] = 1. - std::accumulate(at.begin(), at.end(), 0.);
        return;
      }
    }
    // The diagonals join the middle of an edge without corner 0 and the middle of the opposite one.
    const std::array<Vertex, 4> tet = this->Tet;
    for (int k = 0; k < 3; ++k)
    {
      const int others[2] = { 1 + (k + 1) % 3, 1 + (k + 2) % 3 };
      this->Oct[k] = { { GetMidpoint(tet[others[0]], tet[others[1]]),
        GetMidpoint(tet[0], tet[k + 1]) } };
    }
    for (CornerWeights& at : this->At)
    {
      const CornerWeights w = at;
      at = { { w[0] + w[1] - w[2] - w[3], w[0] + w[2] - w[1] - w[3], w[0] + w[3] - w[1] - w[2],
        0. } };
    }
    this->IsOct = true;
  }

  void SplitOct()
  {
    const Vertex centre = GetMidpoint(this->Oct[0][0], this->Oct[0][1]);
    const CornerWeights at = this->At[0];
    for (int k = 0; k < 3; ++k)
    {
      const int others[2] = { (k + 1) % 3, (k + 2) % 3 };
      if (std::abs(at[k]) < std::abs(at[others[0]]) + std::abs(at[others[1]]))
      {
        continue;
      }
      const int end = at[k] < 0. ? 0 : 1;
      const Vertex corner = this->Oct[k][end];
      for (const int other : others)
      {
        for (Vertex& vertex : this->Oct[other])
        {
          vertex = GetMidpoint(corner, vertex);
        }
      }
      this->Oct[k][1 - end] = centre;
      this->Double();
      this->At[0][k] += end == 0 ? 1. : -1.;
      return;
    }
    // The tetrahedron of the centre and the middles of the edges of a face; corner k + 1 is
    // opposite to the face's vertex k.
    std::array<Vertex, 3> face = this->FindFace();
    const std::array<double, 3> signs = this->FindSigns();
    this->Tet[0] = centre;
    for (int k = 0; k < 3; ++k)
    {
      this->Tet[k + 1] = GetMidpoint(face[(k + 1) % 3], face[(k + 2) % 3]);
    }
    for (std::size_t p = 0; p < this->At.size(); ++p)
    {
      const CornerWeights q = this->At[p];
      const double x = signs[0] * q[0];
      const double y = signs[1] * q[1];
      const double z = signs[2] * q[2];
      this->At[p] = { { (p == 0 ? 1. : 0.) - (x + y + z), y + z - x, x + z - y, x + y - z } };
    }
    this->IsOct = false;
  }

  /// The tetrahedron of the centre and a face, which is no part of a step.
  void GoToFace()
  {
    const std::array<Vertex, 3> face = this->FindFace();
    const std::array<double, 3> signs = this->FindSigns();
    this->Tet[0] = GetMidpoint(this->Oct[0][0], this->Oct[0][1]);
    for (int k = 0; k < 3; ++k)
    {
      this->Tet[k + 1] = face[k];
    }
    for (std::size_t p = 0; p < this->At.size(); ++p)
    {
      CornerWeights weights{ { p == 0 ? 1. : 0., 0., 0., 0. } };
      for (int k = 0; k < 3; ++k)
      {
        weights[k + 1] = signs[k] * this->At[p][k];
        weights[0] -= weights[k + 1];
      }
      this->At[p] = weights;
    }
    this->IsOct = false;
  }

  std::array<Vertex, 3> FindFace() const
  {
    std::array<Vertex, 3> face{};
    for (int k = 0; k < 3; ++k)
    {
      face[k] = this->Oct[k][this->At[0][k] < 0. ? 0 : 1];
    }
    return face;
  }
  std::array<double, 3> FindSigns() const
  {
    std::array<double, 3> signs{};
    for (int k = 0; k < 3; ++k)
    {
      signs[k] = this->At[0][k] < 0. ? -1. : 1.;
    }
    return signs;
  }
  void Double()
  {
    for (CornerWeights& at : this->At)
    {
      for (double& x : at)
      {
        x *= 2.;
      }
    }
  }

  bool IsOct = false;
  std::array<Vertex, 4> Tet;
  std::array<std::array<Vertex, 2>, 3> Oct{}; ///< the ends of each diagonal, first that at -1
  std::array<CornerWeights, 4> At;
};

/// Outputs have an octahedron in pieces with both ends of a diagonal, and one end of each other
/// one.
constexpr int PiecesOfOct = 12;

/// The pieces of one octahedron after the other, with flags at all corners.
template <typename Id>
SimplexTable<Id, 4> ListOctPieces(
  const TetOctLevel<Id>& level, const Buffer<unsigned char>& isCorner)
{
  return SimplexTable<Id, 4>(PiecesOfOct * vtkIdType(level.NumberOfOctahedra), isCorner,
    [&](vtkIdType i)
    {
      const auto piece = static_cast<int>(i % PiecesOfOct);
      const Id* vertices = level.OctVertices.data() + 6 * (i / PiecesOfOct);
      const int diagonal = piece / 4;
      const int others[2] = { (diagonal + 1) % 3, (diagonal + 2) % 3 };
      return std::array<Id, 4>{ { vertices[2 * diagonal], vertices[2 * diagonal + 1],
        vertices[2 * others[0] + piece % 2], vertices[2 * others[1] + piece / 2 % 2] } };
    });
}

/// Finds the row of one place after the other.
template <typename Id>
class TetOctPlaceFinder
{
public:
  TetOctPlaceFinder(const TetOctLevel<Id>& level, const LevelLattices<TetOctLevel<Id>>& lattices)
    : Here(level)
    , Own(lattices.Make())
  {
  }

  void FindInTet(const LimitPlace<Id>& place, Id tet, PlaceRow<Id>& row)
  {
    std::array<LatticeWeights, 4> corners{};
    for (int i = 0; i < 4; ++i)
    {
      corners[i][this->Here.Complex.VertexInTet(tet, place.Corners[i])] = Size;
    }
    this->Find(TetOctPlace(corners, StartPart(place)), tet, row);
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
    this->Find(TetOctPlace(vertices.data(), corners, StartPart(place)),
      this->Here.Complex.NumberOfTets + oct, row);
  }

private:
  using Lattice = typename LevelLattices<TetOctLevel<Id>>::Lattice;

  /// The level of the vertices between which the limit is linear. One of them may be the centre of
  /// an octahedron, which the next step makes.
  static constexpr int Level = MostSplits + 1;
  static constexpr long long Size = 1ll << Level;

  void Find(TetOctPlace inside, Id solid, PlaceRow<Id>& row)
  {
    for (int splits = 0; splits < MostSplits; ++splits)
    {
      inside.Split();
    }
    std::vector<LatticeWeights> vertices;
    std::vector<PartWeights> weights;
    inside.Finish(vertices, weights);
    this->Sum.Clear();
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      if (!this->Sum.AddLimit(this->Own->GetSmooth().Find(solid, vertices[i]), weights[i]))
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
  const std::shared_ptr<Lattice> Own;
  PlaceSum<Lattice> Sum{ *this->Own };
};

}

template <typename Id>
std::vector<PlaceRow<Id>> FindSolidRows(const TetOctLevel<Id>& level,
  const LevelLattices<TetOctLevel<Id>>& lattices, const std::vector<LimitPlace<Id>>& places)
{
  using Finder = TetOctPlaceFinder<Id>;
  const SimplicialComplex<Id>& complex = level.Complex;
  const Buffer<unsigned char> isCorner = FlagCorners(complex.NumberOfVertices, places, true);
  const SimplexTable<Id, 4> tets(complex.NumberOfTets, isCorner, complex.TetVertices);
  const SimplexTable<Id, 4> pieces = ListOctPieces(level, isCorner);
  std::vector<PlaceRow<Id>> rows(places.size());
  ForPlacesInThreads(
    places.size(), [&]() { return std::make_shared<Finder>(level, lattices); },
    [&](Finder& finder, std::size_t i)
    {
      const LimitPlace<Id>& place = places[i];
      const bool isSolid = place.Dimension == 3;
      const Id piece = isSolid ? pieces.Find(place.Corners.data()) : Id(-1);
      const Id tet = isSolid && piece < 0 ? tets.Find(place.Corners.data()) : Id(-1);
      piece >= 0   ? finder.FindInOct(place, piece / PiecesOfOct, rows[i])
        : tet >= 0 ? finder.FindInTet(place, tet, rows[i])
                   : void();
    });
  return rows;
}

template std::vector<PlaceRow<int>> FindSolidRows(const TetOctLevel<int>&,
  const LevelLattices<TetOctLevel<int>>&, const std::vector<LimitPlace<int>>&);
template std::vector<PlaceRow<long long>> FindSolidRows(const TetOctLevel<long long>&,
  const LevelLattices<TetOctLevel<long long>>&, const std::vector<LimitPlace<long long>>&);

}
