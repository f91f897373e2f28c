// SPDX-License-Identifier: BSD-3-Clause
// Limits over edges and faces of a level by trees of patches, against LocalLimit.
#include "LimitTools.h"

#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Limits/LatticeNames.h"
#include "Core/Solids/Limits/LocalLimit.h"
#include "Core/Solids/Limits/PatchLimits.h"

#include <gtest/gtest.h>

#include <cmath>

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
    const std::vector<double> values = MakeValues(size * this->Control.Complex.NumberOfVertices, 5);
    const std::vector<double> expected =
      ApplyTo(LocalLimit<int>(this->Control, {}, this->Names.GetMidpoints()), values, size);
    const PatchLimits<Level<int>> limits(this->Control, values.data(), size);
    PatchPolynomials polynomials(this->Control.Strata.Weights);
    PatchTree tree(polynomials, size);
    std::vector<double> found(size);
    for (const Place& place : this->Places)
    {
      found.assign(size, std::nan(""));
      if (limits.Start(place.Simplex, tree))
      {
        tree.Find(place.Weights, found.data());
      }
      this->Known += std::isnan(found[0]) ? 0 : 1;
      for (int c = 0; c < size && !std::isnan(found[0]); ++c)
      {
        ASSERT_NEAR(found[c], expected[size * place.Vertex + c], 1e-12);
      }
    }
    for (int v = 0; v < this->Control.Complex.NumberOfVertices; ++v)
    {
      const bool isFound = limits.FindAtVertex(v, polynomials.GetRows(), found.data());
      for (int c = 0; c < size && isFound; ++c)
      {
        ASSERT_NEAR(found[c], expected[size * v + c], 1e-12);
      }
    }
  }
  int GetSize() const { return static_cast<int>(this->Places.size()); }

  int Known = 0;

private:
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
          const int point = children[child].Corners[k];
          const int* ends = point < size ? nullptr : GetEdgeEnds(size - 1, point - size);
          for (int c = 0; c < 3; ++c)
          {
            weights[k][c] =
              ends ? 0.5 * (before[ends[0]][c] + before[ends[1]][c]) : before[point][c];
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

}

TEST(PatchLimits, EqualLocalLimitsOnTheWholeZoo)
{
  int known = 0;
  int all = 0;
  unsigned int seed = 1;
  for (const Mesh& mesh : MakeZooAndRandom())
  {
    for (const char* options : OptionNames)
    {
      SCOPED_TRACE(mesh.Name + " " + options);
      const Level<int> level = std::move(BuildNamed<int>(mesh, options).Level);
      PatchCase which(level, 2 + static_cast<int>(seed % 2), seed);
      ++seed;
      which.Compare();
      if (testing::Test::HasFatalFailure())
      {
        return;
      }
      known += which.Known;
      all += which.GetSize();
    }
  }
  EXPECT_GT(known, all / 8);
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
