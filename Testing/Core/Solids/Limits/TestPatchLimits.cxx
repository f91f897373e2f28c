// SPDX-License-Identifier: BSD-3-Clause
// Limits over edges and faces of a level by trees of patches, and by values on a lattice, against
// LimitByLevels.
#include "LatticeNames.h"
#include "LimitByLevels.h"
#include "LimitTools.h"

#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Limits/LatticePlaces.h"
#include "Core/Solids/Limits/LatticeValues.h"
#include "Core/Solids/Limits/PatchTree.h"

using namespace coretest;

namespace
{

constexpr int Splits = 5;

/// Vertices of fine levels on some edges and faces of a level.
class PatchCase
{
public:
  PatchCase(const Level<int>& level, int components, unsigned int seed)
    : Control(level)
    , Components(components)
    , Names(level.Complex.NumberOfVertices)
    , Random(seed)
  {
    this->Ask(level.Complex.FaceVertices, 3);
    this->Ask(level.Complex.EdgeVertices, 2);
  }

  void Compare()
  {
    const int size = this->Components;
    const std::vector<double> values = this->MakeControlValues();
    const std::vector<double> expected = this->FindExpected(values);
    const SheetReader<Level<int>> reader(this->Control);
    PatchPolynomials polynomials(this->Control.Strata.Weights);
    PatchTree tree(polynomials, size);
    std::vector<double> found(size);
    for (const Place& place : this->Places)
    {
      found.assign(size, std::nan(""));
      if (tree.Start(reader, place.Simplex, values.data()))
      {
        tree.Find(place.Weights, found.data());
      }
      this->Known += std::isnan(found[0]) ? 0 : 1;
      for (int c = 0; c < size && !std::isnan(found[0]); ++c)
      {
        ASSERT_NEAR(found[c], expected[size * place.Vertex + c], 1e-12);
      }
    }
  }
  /// The same of values on a lattice, which know all rules.
  void CompareOnLattice(std::size_t mostKept)
  {
    const int size = this->Components;
    const std::vector<double> values = this->MakeControlValues();
    const std::vector<double> expected = this->FindExpected(values);
    const SemiSharpStages<int> noCreases;
    const LevelLattices<Level<int>> lattices(this->Control, noCreases);
    LatticeValues<Level<int>> lattice(lattices, size);
    LatticePlaces<int> places(this->Control);
    ASSERT_TRUE(places.Find(this->Names.GetMidpoints()));
    std::vector<double> found(size);
    for (int v = 0; v < places.GetNumberOfVertices(); ++v)
    {
      lattice.GetSize() > mostKept ? lattice.Clear() : void();
      lattice.FindLimit(places.GetVertex(v), places.GetLevel(v), values.data(), found.data());
      for (int c = 0; c < size; ++c)
      {
        ASSERT_NEAR(found[c], expected[size * v + c], 1e-12);
      }
    }
  }
  int GetSize() const { return static_cast<int>(this->Places.size()); }

  int Known = 0;

private:
  std::vector<double> MakeControlValues() const
  {
    return MakeValues(this->Components * this->Control.Complex.NumberOfVertices, 5);
  }
  std::vector<double> FindExpected(const std::vector<double>& values) const
  {
    return ApplyTo(
      BuildRows(LimitByLevels<Level<int>>(this->Control, {}, this->Names.GetMidpoints())), values,
      this->Components);
  }

  struct Place
  {
    PatchSimplex<int> Simplex;
    std::array<double, 3> Weights;
    int Vertex;
  };

  /// Goes from some simplices to smaller and smaller children, whose corners are places.
  void Ask(const Buffer<int>& vertices, int size)
  {
    const auto simplices = static_cast<int>(vertices.size() / size);
    for (int i = 0; i < std::min(8, simplices); ++i)
    {
      PatchSimplex<int> simplex;
      simplex.Number = static_cast<int>(this->Random() % simplices);
      std::copy_n(vertices.data() + size * simplex.Number, size, simplex.Corners.begin());
      std::array<int, 4> corners{ { -1, -1, -1, -1 } };
      std::copy_n(simplex.Corners.begin(), size, corners.begin());
      std::array<std::array<double, 3>, 3> weights{ { { { 1., 0., 0. } }, { { 0., 1., 0. } },
        { { 0., 0., 1. } } } };
      // Half of them always to the same corner.
      const int toCorner = this->Random() % 2 == 0 ? static_cast<int>(this->Random() % size) : -1;
      for (int depth = 0; depth < Splits; ++depth)
      {
        const auto& children = ListChildren(size - 1);
        const int child =
          toCorner >= 0 ? toCorner : static_cast<int>(this->Random() % children.size());
        corners = GetCornersOfChild(corners, size - 1, child, this->Names);
        const auto before = weights;
        for (int k = 0; k < size; ++k)
        {
          const auto [first, second] = children[child].Corners[k];
          for (int c = 0; c < 3; ++c)
          {
            weights[k][c] = 0.5 * (before[first][c] + before[second][c]);
          }
        }
      }
      for (int k = 0; k < size; ++k)
      {
        if (corners[k] >= this->Control.Complex.NumberOfVertices)
        {
          this->Places.push_back({ simplex, weights[k], corners[k] });
        }
      }
    }
  }

  const Level<int>& Control;
  const int Components;
  VertexNames<int> Names;
  std::mt19937 Random;
  std::vector<Place> Places;
};

/// Calls check(case) for each mesh with each of the options.
template <typename Check>
void ForCasesInZoo(const Check& check)
{
  unsigned int seed = 1;
  for (const Mesh& mesh : MakeZooAndRandom())
  {
    for (const char* options : OptionNames)
    {
      SCOPED_TRACE(mesh.Name + " " + options);
      const Level<int> level = std::move(BuildNamed<int>(mesh, options).Level);
      PatchCase which(level, 2 + static_cast<int>(seed % 2), seed);
      ++seed;
      check(which);
      if (testing::Test::HasFatalFailure())
      {
        return;
      }
    }
  }
}

/// The same, where an eighth of all places are to be known.
template <typename Compare>
void ExpectSomeKnownInZoo(const Compare& compare)
{
  int known = 0;
  int all = 0;
  ForCasesInZoo(
    [&](PatchCase& which)
    {
      compare(which);
      known += which.Known;
      all += which.GetSize();
    });
  EXPECT_GT(known, all / 8);
}

}

TEST(PatchLimits, EqualLimitsByLevelsOnTheWholeZoo)
{
  ExpectSomeKnownInZoo([](PatchCase& which) { which.Compare(); });
}

/// Values that are no numbers make no limits elsewhere, and a place that no split reaches has none.
TEST(PatchLimits, HaveNoNumberWhereThereIsNone)
{
  PatchPolynomials polynomials(LoopWeights::Warren);
  PatchTree tree(polynomials, 1);
  SheetKey key;
  key.Places = SheetPlaces::Face;
  key.Fans.fill({ SheetFan::Kind::Closed, 5, 0 });
  std::fill_n(tree.Start(key, 18, { { 0, 1, 2 } }), 18, 2.);
  double limit = 0.;
  tree.Find({ { 0.25, 0.25, 0.5 } }, &limit);
  EXPECT_NEAR(limit, 2., 1e-13);
  tree.Find({ { 1., 0., 0. } }, &limit);
  EXPECT_TRUE(std::isnan(limit));
  tree.Find({ { std::nan(""), 0.5, 0.5 } }, &limit);
  EXPECT_TRUE(std::isnan(limit));
}

TEST(LatticeValues, EqualLimitsByLevelsOnTheWholeZoo)
{
  unsigned int seed = 1;
  ForCasesInZoo([&](PatchCase& which) { which.CompareOnLattice(++seed % 3 == 0 ? 50 : 100000); });
}
