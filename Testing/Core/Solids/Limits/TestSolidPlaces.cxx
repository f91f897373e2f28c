// SPDX-License-Identifier: BSD-3-Clause
// Rows of places in solids: against limits of far smaller parts around the place, which
// LimitByLevels finds by refining, and against what polynomials of the lattice must have.
#include "LatticeNames.h"
#include "LimitByLevels.h"
#include "LimitTools.h"
#include "TetOctTools.h"
#include "Turns.h"

#include "Core/Solids/Limits/BoxSplinePatch.h"
#include "Core/Solids/Limits/SolidPlaces.h"

using namespace tetoct_tools;

namespace
{

using PartWeights = std::array<double, PlaceParts::Count>;
using DenseRow = std::map<int, PartWeights>; ///< by column

LimitPlace<int> MakePlace(
  const Level<int>& level, int tet, const std::array<double, 4>& weights, std::mt19937& random)
{
  LimitPlace<int> place;
  place.Dimension = 3;
  std::copy_n(level.Complex.TetVertices.data() + 4 * tet, 4, place.Corners.begin());
  std::shuffle(place.Order.begin(), place.Order.end(), random);
  for (int k = 0; k < 3; ++k)
  {
    place.Parameters[k] = weights[k + 1] / (weights[0] + weights[1] + weights[2] + weights[3]);
  }
  return place;
}
/// A place inside of a tetrahedron; every other one is close to a face.
LimitPlace<int> MakePlaceInside(const Level<int>& level, int tet, int kind, std::mt19937& random)
{
  std::array<double, 4> weights;
  for (double& weight : weights)
  {
    weight = std::generate_canonical<double, 53>(random);
  }
  weights[3] *= kind % 2 == 1 ? 0.01 : 1.;
  return MakePlace(level, tet, weights, random);
}
/// A vertex of level 6 inside a tetrahedron, a face or an edge, or at a vertex.
LimitPlace<int> MakeVertex(const Level<int>& level, int tet, int dimension, std::mt19937& random)
{
  std::array<double, 4> weights{};
  unsigned int left = 64u;
  for (int i = 0; i < dimension; ++i)
  {
    const unsigned int weight = 1 + random() % (left / 2);
    weights[i] = weight;
    left -= weight;
  }
  weights[dimension] = left;
  return MakePlace(level, tet, weights, random);
}

/// The polynomial between limits of vertices around each place, after many splits.
std::vector<DenseRow> FindBySplits(const Level<int>& level,
  const std::vector<LimitPlace<int>>& places, int splits,
  const SemiSharpStages<int>& creases = SemiSharpStages<int>())
{
  VertexNames<int> names(level.Complex.NumberOfVertices);
  std::vector<std::vector<int>> nodes;
  std::vector<std::vector<PartWeights>> weights;
  for (const LimitPlace<int>& place : places)
  {
    PlaceInPart part = StartPart(place);
    std::array<int, 4> corners = place.Corners;
    for (int split = 0; split < splits; ++split)
    {
      const int child = part.FindChild(3);
      part.GoToChild(3, child);
      corners = GetCornersOfChild(corners, 3, child, names);
    }
    weights.push_back(WeightLattice(3, part.At, part.Directions));
    nodes.emplace_back();
    for (const PlaceNode& node : ListLattice(3))
    {
      nodes.back().push_back(FindNode(corners, node, names));
    }
  }
  const SparseRows<int> limits =
    BuildRows(LimitByLevels<Level<int>>(level, creases, names.GetMidpoints()));
  std::vector<DenseRow> rows(places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    for (std::size_t n = 0; n < nodes[i].size(); ++n)
    {
      const int node = nodes[i][n];
      for (int k = limits.Offsets[node]; k < limits.Offsets[node + 1]; ++k)
      {
        PartWeights& sum = rows[i].emplace(limits.Columns[k], PartWeights{}).first->second;
        for (int part = 0; part < PlaceParts::Count; ++part)
        {
          sum[part] += limits.Weights[k] * weights[i][n][part];
        }
      }
    }
  }
  return rows;
}

DenseRow ToDense(const PlaceRow<int>& row)
{
  DenseRow dense;
  for (std::size_t c = 0; c < row.Columns.size(); ++c)
  {
    dense[row.Columns[c]] = row.Weights[c];
  }
  return dense;
}

/// The largest difference of two rows in one of their parts.
double Differ(const DenseRow& a, const DenseRow& b, int part)
{
  double most = 0.;
  for (const DenseRow* row : { &a, &b })
  {
    for (const auto& [column, weights] : *row)
    {
      const auto get = [&, c = column](const DenseRow& of)
      { return of.count(c) > 0 ? of.at(c)[part] : 0.; };
      most = std::max(most, std::abs(get(a) - get(b)));
    }
  }
  return most;
}

std::vector<PlaceRow<int>> FindRows(const Level<int>& level,
  const std::vector<LimitPlace<int>>& places,
  const SemiSharpStages<int>& creases = SemiSharpStages<int>())
{
  const LevelLattices<Level<int>> lattices(level, creases);
  return FindSolidRows(level, lattices, places);
}

std::vector<DenseRow> FindDense(const Level<int>& level, const std::vector<LimitPlace<int>>& places,
  const SemiSharpStages<int>& creases = SemiSharpStages<int>())
{
  std::vector<DenseRow> dense;
  for (const PlaceRow<int>& row : FindRows(level, places, creases))
  {
    dense.push_back(ToDense(row));
    EXPECT_FALSE(row.Columns.empty());
    EXPECT_TRUE(std::is_sorted(row.Columns.begin(), row.Columns.end()));
  }
  return dense;
}

}

TEST(SolidPlaces, RowsAreThoseOfSmallerParts)
{
  std::mt19937 random(3);
  std::size_t places = 0;
  for (const std::string& name : GetNamesOfZoo(8))
  {
    const Mesh mesh = FindInZoo(name);
    for (const char* options :
      turns::Some({ "Blend", "Sharp", "Follow2", "LoopWeights", "ModifiedBoundary" }))
    {
      const Level<int> level = std::move(BuildNamed<int>(mesh, options).Level);
      const auto drawTet = [&]()
      { return static_cast<int>(random() % static_cast<unsigned>(level.Complex.NumberOfTets)); };
      std::vector<LimitPlace<int>> inside;
      std::vector<LimitPlace<int>> vertices;
      for (int kind = 0; kind < 8 && level.Complex.NumberOfTets > 0; ++kind)
      {
        vertices.push_back(MakeVertex(level, drawTet(), kind % 4, random));
        kind < 2 ? inside.push_back(MakePlaceInside(level, drawTet(), kind, random)) : void();
      }
      const std::vector<DenseRow> atVertices = FindDense(level, vertices);
      const std::vector<DenseRow> limits = FindBySplits(level, vertices, 6);
      for (std::size_t i = 0; i < limits.size(); ++i)
      {
        EXPECT_LT(Differ(atVertices[i], limits[i], PlaceParts::Value), 1e-13)
          << name << " " << options << " " << i;
      }
      const std::vector<DenseRow> between = FindDense(level, inside);
      const std::vector<DenseRow> expected = FindBySplits(level, inside, 20);
      for (std::size_t i = 0; i < expected.size(); ++i)
      {
        EXPECT_LT(Differ(between[i], expected[i], PlaceParts::Value), 1e-12)
          << name << " " << options << " " << i;
        for (int k = 0; k < 3; ++k)
        {
          EXPECT_LT(Differ(between[i], expected[i], PlaceParts::First + k), 1e-6)
            << name << " " << options << " " << i;
        }
      }
      places += limits.size() + expected.size();
    }
  }
  EXPECT_GT(places, turns::GetShare(700u));
}

TEST(SolidPlaces, BesideWhatIsSemiSharp)
{
  std::mt19937 random(8);
  const Lattice lattice = MakeLattice("lattice", 3, 0.3, 0);
  for (unsigned int seed = 0; seed < 6; ++seed)
  {
    SemiSharpMesh mesh(lattice.Control, "Blend", seed);
    auto& edges = mesh.Sharpness.Edges;
    auto& faces = mesh.Sharpness.Faces;
    std::fill(edges.begin(), edges.end(), 0.);
    std::fill(faces.begin(), faces.end(), 0.);
    (seed % 2 == 0 ? edges[random() % edges.size()] : faces[random() % faces.size()]) = 1.5;
    const Level<int> level = mesh.MakeSmoothLevel(0);
    const SemiSharpStages<int> creases = mesh.MakeStages(0);
    std::vector<LimitPlace<int>> places;
    for (int tet = static_cast<int>(seed); tet < level.Complex.NumberOfTets; tet += 7)
    {
      places.push_back(MakeVertex(level, tet, 3, random));
    }
    const std::vector<DenseRow> found = FindDense(level, places, creases);
    const std::vector<DenseRow> expected = FindBySplits(level, places, 6, creases);
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
      EXPECT_LT(Differ(found[i], expected[i], PlaceParts::Value), 1e-13) << seed << " " << i;
    }
    EXPECT_GT(places.size(), 10u);
  }
}

/// On the lattice all faces, edges and vertices are regular, so that nothing is split: a place
/// reads the 32 vertices around its tetrahedron, and no others.
TEST(SolidPlaces, LatticesAreNotSplit)
{
  for (const unsigned int seed : { 0u, 5u })
  {
    const Lattice lattice = MakeLattice("lattice", 5, 0.3, seed);
    const Level<int> level = std::move(BuildNamed<int>(lattice.Control, "Blend").Level);
    std::mt19937 random(4);
    std::vector<LimitPlace<int>> places;
    for (int tet = 0; tet < level.Complex.NumberOfTets; ++tet)
    {
      const int* corners = level.Complex.TetVertices.data() + 4 * tet;
      if (std::all_of(corners, corners + 4,
            [&](int corner)
            {
              const auto& at = lattice.Positions[static_cast<std::size_t>(corner)];
              return std::all_of(at.begin(), at.end(), [](int x) { return x > 0 && x < 5; });
            }))
      {
        places.push_back(MakePlaceInside(level, tet, static_cast<int>(places.size()), random));
      }
    }
    ASSERT_EQ(places.size(), 27u * 6u);
    const std::vector<PlaceRow<int>> rows = FindRows(level, places);
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      EXPECT_LE(rows[i].Columns.size(), 32u);
      EXPECT_GE(rows[i].Columns.size(), 15u);
      // Quadratic functions become quadratic functions with the same second derivatives.
      const LimitPlace<int>& place = places[i];
      const auto get = [&](int vertex)
      {
        const auto& at = lattice.Positions[static_cast<std::size_t>(vertex)];
        return std::array<double, 3>{ { 1. * at[0], 1. * at[1], 1. * at[2] } };
      };
      const std::array<double, 3> first = get(place.Corners[place.Order[0]]);
      std::array<std::array<double, 3>, 2> ways{};
      for (int d = 0; d < 2; ++d)
      {
        for (int c = 0; c < 3; ++c)
        {
          ways[d][c] = get(place.Corners[place.Order[d + 1]])[c] - first[c];
        }
      }
      double sums[PlaceParts::Count] = {};
      for (std::size_t k = 0; k < rows[i].Columns.size(); ++k)
      {
        const std::array<double, 3> x = get(rows[i].Columns[k]);
        for (int part = 0; part < PlaceParts::Count; ++part)
        {
          sums[part] += rows[i].Weights[k][part] * (x[0] * x[1] + 2. * x[2] * x[2]);
        }
      }
      const auto bend = [&](int d, int e)
      { return ways[d][0] * ways[e][1] + ways[d][1] * ways[e][0] + 4. * ways[d][2] * ways[e][2]; };
      EXPECT_NEAR(sums[PlaceParts::Second], bend(0, 0), 1e-11);
      EXPECT_NEAR(sums[PlaceParts::Mixed], bend(0, 1), 1e-11);
      EXPECT_NEAR(sums[PlaceParts::SecondOfSecond], bend(1, 1), 1e-11);
    }
  }
}

/// Derivatives of the polynomials are what these differ by.
TEST(SolidPlaces, DerivativesOfBoxSplines)
{
  constexpr double h = 1e-4;
  const CornerWeights at{ { 0.31, 0.17, 0.29, 0.23 } };
  const std::array<CornerWeights, 3> directions{ { { { -1., 1., 0., 0. } }, { { -1., 0., 1., 0. } },
    { { -1., 0., 0., 1. } } } };
  using Nodes = std::map<std::array<int, 3>, PartWeights>;
  const auto weigh = [&](int direction, double by)
  {
    CornerWeights moved = at;
    for (int i = 0; i < 4; ++i)
    {
      moved[i] += by * directions[direction][i];
    }
    Nodes nodes;
    for (const BoxSplineNode& node : WeightBoxSpline(moved, directions))
    {
      nodes[node.Steps] = node.Weights;
    }
    return nodes;
  };
  Nodes nodes = weigh(0, 0.);
  EXPECT_EQ(nodes.size(), 32u);
  double sum = 0.;
  for (const auto& [steps, weights] : nodes)
  {
    EXPECT_GT(weights[PlaceParts::Value], 0.);
    sum += weights[PlaceParts::Value];
  }
  EXPECT_NEAR(sum, 1., 1e-15);
  for (int d = 0; d < 3; ++d)
  {
    Nodes before = weigh(d, -h);
    Nodes after = weigh(d, h);
    for (const auto& [steps, weights] : nodes)
    {
      const auto differ = [&, s = steps](int part)
      { return (after[s][part] - before[s][part]) / (2. * h); };
      EXPECT_NEAR(weights[PlaceParts::First + d], differ(PlaceParts::Value), 1e-7);
      if (d < 2)
      {
        EXPECT_NEAR(weights[d == 0 ? PlaceParts::Second : PlaceParts::Mixed],
          differ(PlaceParts::First), 1e-7);
        EXPECT_NEAR(weights[d == 0 ? PlaceParts::Mixed : PlaceParts::SecondOfSecond],
          differ(PlaceParts::First + 1), 1e-7);
      }
    }
  }
}
