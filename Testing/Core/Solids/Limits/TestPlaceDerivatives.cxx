// SPDX-License-Identifier: BSD-3-Clause
// Derivatives at places of curves, triangles and solids, the second ones of curves and triangles
// too, with all rules: near each corner of a cell they are those of the same place in the part that
// a step cuts off there, at any distance.
#include "LimitTools.h"
#include "TetOctTools.h"
#include "Turns.h"

#include "Core/Solids/Limits/PlaceLimits.h"

#include <type_traits>

using namespace tetoct_tools;

namespace
{

/// A level, what is semi-sharp there, and the same after a step.
template <typename LevelType>
struct TwoLevels
{
  LevelType First;
  SemiSharpStages<int> FirstCreases;
  LevelType Second;
  SemiSharpStages<int> SecondCreases;
  Stencils<int> Step;
};

Level<int> Start(Level<int>&& control, const Level<int>&)
{
  return std::move(control);
}
TetOctLevel<int> Start(Level<int>&& control, const TetOctLevel<int>&)
{
  return MakeTetOctLevel(std::move(control));
}

template <typename LevelType>
TwoLevels<LevelType> MakeLevels(const Mesh& mesh, const std::string& options)
{
  TwoLevels<LevelType> levels;
  levels.First = Start(std::move(BuildNamed<int>(mesh, options).Level), LevelType());
  levels.Second = Refine(levels.First, Depth::ForRefinement);
  levels.Step = CopyStencils(levels.First);
  return levels;
}

/// What there is at a place (PlaceParts), and how large its weights are.
struct Found
{
  std::array<double, PlaceParts::Count> Sums{};
  std::array<double, PlaceParts::Count> Sizes{};
};

template <typename LevelType>
std::vector<Found> Evaluate(const LevelType& level, const SemiSharpStages<int>& creases,
  const std::vector<LimitPlace<int>>& places, const std::vector<double>& values)
{
  const PlaceLimits<int> limits(level, creases, places, PlaceDerivatives::Second);
  EXPECT_TRUE(limits.Rows.HasPart(PlaceParts::SecondOfSecond) ||
    std::none_of(
      places.begin(), places.end(), [](const auto& place) { return place.Dimension == 2; }));
  std::vector<Found> all(places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    for (int part = 0; part < PlaceParts::Count; ++part)
    {
      for (int k = limits.Rows.Offsets[i];
        limits.Rows.HasPart(part) && k < limits.Rows.Offsets[i + 1]; ++k)
      {
        const double weight = limits.Rows.Weights[part][k];
        all[i].Sums[part] += weight * values[limits.Rows.Columns[k]];
        all[i].Sizes[part] += std::abs(weight);
      }
    }
  }
  return all;
}

/// Places at powers of 1/2 from a corner of a simplex, and where they are in the part at the
/// corner.
template <typename LevelType>
class NearCorners
{
public:
  explicit NearCorners(TwoLevels<LevelType>&& levels)
    : Levels(std::move(levels))
  {
  }

  /// Adds places near a corner of a simplex with some number.
  void Add(int dimension, int number)
  {
    const SimplicialComplex<int>& complex = this->Levels.First.Complex;
    const int* first = dimension == 1 ? complex.EdgeVertices.data() + 2 * number
      : dimension == 2                ? complex.FaceVertices.data() + 3 * number
                                      : complex.TetVertices.data() + 4 * number;
    LimitPlace<int> place;
    place.Dimension = dimension;
    std::copy_n(first, dimension + 1, place.Corners.begin());
    std::shuffle(place.Order.begin(), place.Order.begin() + dimension + 1, this->Random);
    std::map<int, int> cornersOfPart; // to those of the simplex
    const int corner = place.Corners[place.Order[0]];
    for (int i = 0; i <= dimension; ++i)
    {
      const int other = place.Corners[i];
      cornersOfPart[other == corner ? corner
                                    : complex.NumberOfVertices + FindEdge(complex, corner, other)] =
        other;
    }
    LimitPlace<int> inPart = place;
    int k = 0;
    for (const auto& [vertex, other] : cornersOfPart)
    {
      inPart.Corners[k++] = vertex;
    }
    if (dimension == 3)
    {
      this->OrderTet(inPart.Corners);
    }
    for (int i = 0; i <= dimension; ++i)
    {
      inPart.Order[i] =
        static_cast<int>(std::find_if(inPart.Corners.begin(), inPart.Corners.end(), [&](int vertex)
                           { return cornersOfPart.at(vertex) == place.Corners[place.Order[i]]; }) -
          inPart.Corners.begin());
    }
    for (const int depth : Depths)
    {
      for (int i = 0; i < dimension; ++i)
      {
        const double at = 0.125 + 0.2 * std::generate_canonical<double, 53>(this->Random);
        place.Parameters[i] = std::ldexp(at, -depth);
        inPart.Parameters[i] = std::ldexp(at, 1 - depth);
      }
      this->Places.push_back(place);
      this->InParts.push_back(inPart);
    }
  }

  /// The weights of the largest derivative at a place say how exact all of them are: beside a
  /// crease those across it become smaller than those along it.
  void Compare()
  {
    const std::vector<double> values = MakeValues(this->Levels.First.Complex.NumberOfVertices, 3);
    std::vector<double> next(this->Levels.Second.Complex.NumberOfVertices);
    this->Levels.Step.Apply(values.data(), next.data(), 1);
    const std::vector<Found> expected =
      Evaluate(this->Levels.Second, this->Levels.SecondCreases, this->InParts, next);
    const std::vector<Found> found =
      Evaluate(this->Levels.First, this->Levels.FirstCreases, this->Places, values);
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      const int dimension = this->Places[i].Dimension;
      const int depth = Depths[i % Depths.size()];
      // There the limit is no polynomial: it is taken as linear over parts of 2^-52 of the solid.
      const bool isLinear = dimension == 3 && !std::is_same<LevelType, Level<int>>::value;
      const double bound = 1e-12 + (isLinear ? std::ldexp(1., depth - 50) : 0.);
      EXPECT_NEAR(found[i].Sums[0], expected[i].Sums[0], 1e-13) << i;
      // Steps with semi-sharp rules leave the rounding of what is linear in second derivatives.
      const bool isSharp = !this->Levels.FirstCreases.Stages.empty();
      const double more = isSharp ? std::ldexp(1., depth - 54) : 0.;
      const auto compare = [&](int begin, int end, double factor, double by)
      {
        const auto first = found[i].Sizes.begin();
        // Second derivatives are 0 on straight curves, but for rounding.
        const double most = std::max(
          begin < PlaceParts::Second ? 0. : 1., *std::max_element(first + begin, first + end));
        for (int part = begin; part < end; ++part)
        {
          EXPECT_NEAR(found[i].Sums[part], factor * expected[i].Sums[part], by * most)
            << "part " << part << " 2^-" << depth << " of a simplex of dimension " << dimension
            << " from " << this->Places[i].Corners[this->Places[i].Order[0]];
        }
      };
      compare(PlaceParts::First, PlaceParts::First + dimension, 2., bound);
      if (dimension < 3)
      {
        compare(PlaceParts::Second, dimension == 1 ? PlaceParts::Second + 1 : PlaceParts::Count, 4.,
          bound + more);
      }
    }
  }

  /// Some simplices of each dimension, but those inside of solids: in general the limit there has
  /// no derivatives by the parameters of edges and faces.
  void AddSome(int count)
  {
    const SimplicialComplex<int>& complex = this->Levels.First.Complex;
    const std::array<int, 4> sizes{ { 0, complex.NumberOfEdges, complex.NumberOfFaces,
      complex.NumberOfTets } };
    for (int dimension = 1; dimension < 4; ++dimension)
    {
      const auto size = static_cast<unsigned int>(sizes[dimension]);
      for (int i = 0; size > 0 && i < count; ++i)
      {
        const auto number = static_cast<int>(this->Random() % size);
        const Strata<int>& strata = this->Levels.First.Strata;
        const auto isCurved = [](Rule rule)
        { return rule == Rule::Curve || rule == Rule::Surface || rule == Rule::Blend; };
        if (dimension == 3 ||
          isCurved((dimension == 1 ? strata.Edges : strata.Faces)[number].GetRule()))
        {
          this->Add(dimension, number);
        }
      }
    }
  }

private:
  static constexpr std::array<int, 6> Depths{ { 1, 4, 16, 27, 39, 46 } };

  /// Gives corners of a tetrahedron of the second level the order that they have there.
  void OrderTet(std::array<int, 4>& corners) const
  {
    const SimplicialComplex<int>& complex = this->Levels.Second.Complex;
    for (int tet = 0; tet < complex.NumberOfTets; ++tet)
    {
      const int* own = complex.TetVertices.data() + 4 * tet;
      if (std::is_permutation(corners.begin(), corners.end(), own))
      {
        std::copy_n(own, 4, corners.begin());
      }
    }
  }

  std::mt19937 Random{ 4 };
  TwoLevels<LevelType> Levels;
  std::vector<LimitPlace<int>> Places;
  std::vector<LimitPlace<int>> InParts;
};

template <typename LevelType>
class PlaceDerivativesNearCorners : public testing::Test
{
};
using LevelTypes = testing::Types<Level<int>, TetOctLevel<int>>;
TYPED_TEST_SUITE(PlaceDerivativesNearCorners, LevelTypes, );

}

TYPED_TEST(PlaceDerivativesNearCorners, AreThoseOfTheNextLevel)
{
  for (const std::string& name : GetNamesOfZoo(4))
  {
    for (const char* options : turns::Some({ "Blend", "Regional", "ModifiedBoundary" }))
    {
      SCOPED_TRACE(name + " " + options);
      NearCorners<TypeParam> places(MakeLevels<TypeParam>(FindInZoo(name), options));
      places.AddSome(1);
      places.Compare();
    }
  }
}

TEST(PlaceDerivatives, BesideWhatIsSemiSharp)
{
  for (const char* name : { "KuhnCube", "ThreeSheets", "CreasedSurface", "OpenFan" })
  {
    for (unsigned int seed = 0; seed < 3; ++seed)
    {
      SCOPED_TRACE(testing::Message() << name << " " << seed);
      const SemiSharpMesh mesh(FindInZoo(name), "Blend", seed);
      TwoLevels<Level<int>> levels{ mesh.MakeSmoothLevel(0), mesh.MakeStages(0),
        mesh.MakeSmoothLevel(1), mesh.MakeStages(1), mesh.MakeStencils(0) };
      NearCorners<Level<int>> places(std::move(levels));
      places.AddSome(3);
      places.Compare();
    }
  }
}
