// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solids/Limits/SolidPlaces.h"

#include "Core/Solids/Limits/BoxSplinePatch.h"
#include "Core/Solids/Limits/LatticeCorners.h"
#include "Core/Solids/Limits/PlacePolynomial.h"
#include "Core/Solids/Limits/RegularLattice.h"
#include "Core/Solids/Limits/SimplexTable.h"

#include <algorithm>
#include <memory>

namespace subdivision
{
namespace
{

/// Finds the row of one place after the other.
template <typename Id>
class SolidPlaceFinder
{
public:
  SolidPlaceFinder(const Level<Id>& level, const LevelLattices<Level<Id>>& lattices)
    : Complex(level.Complex)
    , Own(lattices.Make())
    , Regular(level, *this->Own)
  {
  }

  void Find(const LimitPlace<Id>& place, Id tet, PlaceRow<Id>& row)
  {
    this->Start(place, tet);
    int level = 0;
    bool isRead = this->ReadPolynomial();
    for (; !isRead && level < MostSplits; ++level)
    {
      this->Split();
      isRead = this->ReadPolynomial();
    }
    if ((isRead || this->ReadCorners()) && this->Sum.StepBack(level))
    {
      this->Sum.Write(row);
    }
  }

private:
  using Lattice = typename LevelLattices<Level<Id>>::Lattice;

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
    GoToChild(3, child, this->Corners);
  }

  /// Whether all is regular that the limit over the part depends on: what its corners lie in, and
  /// what two of these share where a step goes from one end of a marked edge to the other. The
  /// vertex in the middle of that step has a neighbour there, which is as near to it as they are.
  bool IsRegular() const
  {
    constexpr std::array<int, 2> marked{ { 1 | 4, 2 | 8 } }; // corners of tetrahedra
    const auto& carriers = this->Part.Carriers;
    const auto isRegular = [&](int a)
    {
      return this->Parts[a] &&
        std::all_of(carriers.begin(), carriers.end(),
          [&](int b)
          {
            const auto isStep = [&](int edge)
            { return (a & edge) != 0 && (b & edge) != 0 && (a & b & edge) == 0; };
            return (a & b) == 0 || this->Parts[a & b] ||
              !std::any_of(marked.begin(), marked.end(), isStep);
          });
    };
    return std::all_of(carriers.begin(), carriers.end(), isRegular);
  }

  /// Takes the polynomial over the part, if there is one.
  bool ReadPolynomial()
  {
    if (!this->IsRegular())
    {
      return false;
    }
    this->Sum.Clear();
    for (const BoxSplineNode& node : WeightBoxSpline(this->Part.At, this->Part.Directions))
    {
      const auto& steps = node.Steps;
      LatticeVertex<Id> vertex;
      if (!this->Regular.Find(this->Tet,
            CombineCorners(this->Corners,
              { { 1 - steps[0], steps[0] - steps[1], steps[1] - steps[2], steps[2] } }),
            vertex))
      {
        return false;
      }
      this->Sum.Add(vertex, node.Weights);
    }
    return true;
  }

  /// Takes the linear function between the limits of the part's corners.
  bool ReadCorners()
  {
    this->Sum.Clear();
    for (int i = 0; i < 4; ++i)
    {
      PartWeights weights{ { this->Part.At[i] } };
      for (int d = 0; d < 3; ++d)
      {
        weights[PlaceParts::First + d] = this->Part.Directions[d][i];
      }
      if (!this->Sum.AddLimit(this->Own->GetSmooth().Find(3, this->Tet, this->Corners[i]), weights))
      {
        return false;
      }
    }
    return true;
  }

  const SimplicialComplex<Id>& Complex;
  const std::shared_ptr<Lattice> Own;
  const RegularLattice<Id> Regular;
  Id Tet = -1;
  std::array<bool, 16> Parts{}; ///< of the tetrahedron that are regular
  PlaceInPart Part;
  LatticeCorners Corners{}; ///< of the part
  PlaceSum<Lattice> Sum{ *this->Own };
};

}

template <typename Id>
std::vector<PlaceRow<Id>> FindSolidRows(const Level<Id>& level,
  const LevelLattices<Level<Id>>& lattices, const std::vector<LimitPlace<Id>>& places)
{
  using Finder = SolidPlaceFinder<Id>;
  const SimplexTable<Id, 4> tets(level.Complex.NumberOfTets,
    FlagCorners(level.Complex.NumberOfVertices, places, true), level.Complex.TetVertices);
  std::vector<PlaceRow<Id>> rows(places.size());
  ForPlacesInThreads(
    places.size(), [&]() { return std::make_shared<Finder>(level, lattices); },
    [&](Finder& finder, std::size_t i)
    {
      const LimitPlace<Id>& place = places[i];
      const Id tet = place.Dimension == 3 ? tets.Find(place.Corners.data()) : Id(-1);
      tet >= 0 ? finder.Find(place, tet, rows[i]) : void();
    });
  return rows;
}

template std::vector<PlaceRow<int>> FindSolidRows(
  const Level<int>&, const LevelLattices<Level<int>>&, const std::vector<LimitPlace<int>>&);
template std::vector<PlaceRow<long long>> FindSolidRows(const Level<long long>&,
  const LevelLattices<Level<long long>>&, const std::vector<LimitPlace<long long>>&);

}
