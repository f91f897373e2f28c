// SPDX-License-Identifier: BSD-3-Clause
// First derivatives at places in solids, by both schemes: against the same places in cells of the
// next level, and against functions of which the derivatives are known.
#include "LimitTools.h"
#include "TetOctTools.h"

#include "Core/Solids/Limits/PlaceLimits.h"
#include "Core/Solids/Limits/TetOctLattice.h"

using namespace tetoct_tools;

namespace
{

using Weights = std::array<double, 4>;
using Values = std::vector<double>;

double Draw(std::mt19937& random)
{
  return std::generate_canonical<double, 53>(random);
}
Values DrawValues(int size, std::mt19937& random)
{
  Values values(static_cast<std::size_t>(size));
  std::generate(values.begin(), values.end(), [&]() { return Draw(random); });
  return values;
}

/// The value and three derivatives at a place of what has some values at the vertices.
template <typename LevelType>
Weights Evaluate(const LevelType& level, const LimitPlace<int>& place, const Values& values)
{
  const PlaceLimits<int> limits(level, SemiSharpStages<int>(), { place }, PlaceDerivatives::First);
  Weights found{};
  for (int part = 0; part < 4; ++part)
  {
    for (vtkIdType k = 0; k < limits.Rows.Columns.size(); ++k)
    {
      found[part] += limits.Rows.Weights[part][k] * values[limits.Rows.Columns[k]];
    }
  }
  return found;
}

Level<int> Start(Level<int>&& control, const Level<int>&)
{
  return std::move(control);
}
TetOctLevel<int> Start(Level<int>&& control, const TetOctLevel<int>&)
{
  return MakeTetOctLevel(std::move(control));
}

/// The corners of one of the tetrahedra in which a step leaves a tetrahedron, or which its
/// octahedron is written as.
std::array<int, 4> DrawChild(const Level<int>& next, int tet, std::mt19937& random)
{
  std::array<int, 4> corners;
  const int child = 8 * tet + static_cast<int>(random() % 8);
  std::copy_n(next.Complex.TetVertices.data() + 4 * child, 4, corners.begin());
  return corners;
}
std::array<int, 4> DrawChild(const TetOctLevel<int>& next, int tet, std::mt19937& random)
{
  std::array<int, 4> corners;
  if (random() % 2 == 0)
  {
    const int child = 4 * tet + static_cast<int>(random() % 4);
    std::copy_n(next.Complex.TetVertices.data() + 4 * child, 4, corners.begin());
    return corners;
  }
  const int* vertices = next.OctVertices.data() + 6 * tet;
  const unsigned int diagonal = random() % 3;
  return { { vertices[2 * diagonal], vertices[2 * diagonal + 1],
    vertices[2 * ((diagonal + 1) % 3) + random() % 2],
    vertices[2 * ((diagonal + 2) % 3) + random() % 2] } };
}

/// A level, the next one, and values of a function on both.
template <typename LevelType>
class TwoLevels
{
public:
  TwoLevels(const Mesh& mesh, const std::string& options)
    : First(Start(std::move(BuildNamed<int>(mesh, options).Level), LevelType()))
    , Second(Refine(this->First, Depth::ForRefinement))
    , FirstValues(DrawValues(this->First.Complex.NumberOfVertices, this->Random))
    , SecondValues(static_cast<std::size_t>(this->Second.Complex.NumberOfVertices))
  {
    CopyStencils(this->First).Apply(this->FirstValues.data(), this->SecondValues.data(), 1);
  }

  /// Compares derivatives at a place of a child of a tetrahedron with those of the same place in
  /// the tetrahedron. `least`: the smallest weight of a corner of the child, of all four.
  void Check(int tet, double least)
  {
    const SimplicialComplex<int>& complex = this->First.Complex;
    const int* control = complex.TetVertices.data() + 4 * tet;
    LimitPlace<int> inChild;
    inChild.Dimension = 3;
    inChild.Corners = DrawChild(this->Second, tet, this->Random);
    std::shuffle(inChild.Corners.begin(), inChild.Corners.end(), this->Random);
    Weights weights;
    std::generate(weights.begin(), weights.end(), [&]() { return Draw(this->Random); });
    weights[3] = 0.;
    const double sum = (weights[0] + weights[1] + weights[2]) / (1. - least);
    LimitPlace<int> place;
    place.Dimension = 3;
    std::copy_n(control, 4, place.Corners.begin());
    for (int k = 0; k < 3; ++k)
    {
      inChild.Parameters[k] = k < 2 ? weights[k + 1] / sum : least;
    }
    const double first = 1. - inChild.Parameters[0] - inChild.Parameters[1] - inChild.Parameters[2];
    std::array<Weights, 4> corners;
    for (int i = 0; i < 4; ++i)
    {
      corners[i] = this->Locate(inChild.Corners[i], tet);
    }
    for (int c = 0; c < 3; ++c)
    {
      place.Parameters[c] = first * corners[0][c + 1];
      for (int k = 0; k < 3; ++k)
      {
        place.Parameters[c] += inChild.Parameters[k] * corners[k + 1][c + 1];
      }
    }
    const Weights expected = Evaluate(this->First, place, this->FirstValues);
    const Weights found = Evaluate(this->Second, inChild, this->SecondValues);
    EXPECT_NEAR(found[0], expected[0], 1e-13);
    // Where the limit is not smooth, derivatives change with the distance from there: the error of
    // the place itself, from rounding, is a larger part of a smaller distance.
    const double bound = 1e-13 + (least > 0. ? 1e-15 / least : 0.);
    for (int d = 0; d < 3; ++d)
    {
      double change = 0.;
      for (int c = 0; c < 3; ++c)
      {
        change += (corners[d + 1][c + 1] - corners[0][c + 1]) * expected[c + 1];
      }
      EXPECT_NEAR(found[d + 1], change, bound) << "tetrahedron " << tet << " at " << least;
    }
  }

  LevelType First;

private:
  /// A vertex of the second level in a tetrahedron of the first one.
  Weights Locate(int vertex, int tet) const
  {
    const SimplicialComplex<int>& complex = this->First.Complex;
    Weights weights{};
    for (int i = 0; i < 4; ++i)
    {
      weights[i] = vertex == complex.TetVertices[4 * tet + i] ? 1. : 0.;
    }
    for (int e = 0; e < 6; ++e)
    {
      if (vertex == complex.NumberOfVertices + complex.TetEdges[6 * tet + e])
      {
        weights[tetrahedron::EdgeVertices[e][0]] = weights[tetrahedron::EdgeVertices[e][1]] = 0.5;
      }
    }
    return weights;
  }

  std::mt19937 Random{ 11 };
  LevelType Second;
  Values FirstValues;
  Values SecondValues;
};

/// Meshes without joints.
const char* const Names[] = { "SingleTet", "TwoTets", "Valence4", "OctahedronMixedMarks",
  "KuhnCube", "KuhnLattice", "SingularFaceInside", "SingularSheetInside", "SingularLineInside" };

template <typename LevelType>
class SolidDerivatives : public testing::Test
{
};
using LevelTypes = testing::Types<Level<int>, TetOctLevel<int>>;
TYPED_TEST_SUITE(SolidDerivatives, LevelTypes, );

}

TYPED_TEST(SolidDerivatives, AreThoseOfTheNextLevel)
{
  for (const char* name : Names)
  {
    for (const char* options : { "Blend", "LoopWeights", "ModifiedBoundary" })
    {
      SCOPED_TRACE(testing::Message() << name << " " << options);
      TwoLevels<TypeParam> levels(FindInZoo(name), options);
      for (int i = 0; i < 8; ++i)
      {
        levels.Check(i % levels.First.Complex.NumberOfTets, std::ldexp(0.7, -5 * i));
      }
    }
  }
}

/// On the boundary derivatives are those on the inner side.
TYPED_TEST(SolidDerivatives, OnFacesAreThoseOfTheNextLevel)
{
  for (const char* name : { "SingleTet", "KuhnCube", "KuhnLattice" })
  {
    SCOPED_TRACE(name);
    TwoLevels<TypeParam> levels(FindInZoo(name), "Blend");
    for (int i = 0; i < 12; ++i)
    {
      levels.Check(i % levels.First.Complex.NumberOfTets, 0.);
    }
  }
}

TYPED_TEST(SolidDerivatives, OfConstantsAreZero)
{
  std::mt19937 random(5);
  for (const char* name : Names)
  {
    const TypeParam level =
      Start(std::move(BuildNamed<int>(FindInZoo(name), "Blend").Level), TypeParam());
    const Values ones(static_cast<std::size_t>(level.Complex.NumberOfVertices), 1.);
    for (int i = 0; i < 10; ++i)
    {
      LimitPlace<int> place;
      place.Dimension = 3;
      const auto tet =
        static_cast<int>(random() % static_cast<unsigned int>(level.Complex.NumberOfTets));
      std::copy_n(level.Complex.TetVertices.data() + 4 * tet, 4, place.Corners.begin());
      place.Parameters = { { 0.3 * Draw(random), 0.6 * Draw(random), std::ldexp(0.1, -4 * i) } };
      const Weights found = Evaluate(level, place, ones);
      EXPECT_NEAR(found[0], 1., 1e-13) << name;
      for (int d = 1; d < 4; ++d)
      {
        EXPECT_NEAR(found[d], 0., 1e-14) << name << " " << i;
      }
    }
  }
}

/// Inside of a control tetrahedron the scheme turns quadratic functions into quadratic functions
/// with the same derivatives, although its limit is no polynomial.
TEST(TetOctDerivatives, OfQuadraticFunctions)
{
  constexpr int steps = 4;
  std::vector<std::array<double, 3>> at{ { { 0., 0., 0. } }, { { 1., 0.1, 0. } },
    { { 0.2, 1., 0.3 } }, { { 0.1, 0.2, 1. } } };
  std::vector<bool> isInside(4, false);
  TetOctMesh<int> mesh = BuildTetOct<int>(FindInZoo("SingleTet").Cells);
  for (int step = 0; step < steps; ++step)
  {
    const SimplicialComplex<int>& complex = mesh.Level.Complex;
    const auto addMean = [&](const int* vertices, int size)
    {
      std::array<double, 3> mean{};
      for (int i = 0; i < 3 * size; ++i)
      {
        mean[i % 3] += at[static_cast<std::size_t>(vertices[i / 3])][i % 3] / size;
      }
      at.push_back(mean);
    };
    for (int e = 0; e < complex.NumberOfEdges; ++e)
    {
      addMean(complex.EdgeVertices.data() + 2 * e, 2);
      isInside.push_back(mesh.Level.Strata.Edges[e].GetRule() == Rule::RegularEdge);
    }
    for (int o = 0; o < mesh.Level.NumberOfOctahedra; ++o)
    {
      addMean(mesh.Level.OctVertices.data() + 6 * o, 6);
      isInside.push_back(true);
    }
    mesh = RefineOnce(mesh);
  }
  const auto square = [](const std::array<double, 3>& x)
  { return x[0] * x[0] - 2. * x[0] * x[1] + 3. * x[1] * x[2] + 0.5 * x[2] * x[2] + x[1]; };
  Values values;
  std::transform(at.begin(), at.end(), std::back_inserter(values), square);
  std::mt19937 random(3);
  int checked = 0;
  for (int tet = 0; tet < mesh.Level.Complex.NumberOfTets; tet += 7)
  {
    LimitPlace<int> place;
    place.Dimension = 3;
    std::copy_n(mesh.Level.Complex.TetVertices.data() + 4 * tet, 4, place.Corners.begin());
    place.Parameters = { { 0.3 * Draw(random), 0.3 * Draw(random), 0.3 * Draw(random) } };
    const PlaceLimits<int> limits(
      mesh.Level, SemiSharpStages<int>(), { place }, PlaceDerivatives::First);
    if (!std::all_of(limits.Rows.Columns.begin(), limits.Rows.Columns.end(),
          [&](int column) { return isInside[static_cast<std::size_t>(column)]; }))
    {
      continue;
    }
    ++checked;
    const auto corner = [&](int i) { return at[static_cast<std::size_t>(place.Corners[i])]; };
    std::array<double, 3> x = corner(0);
    for (int d = 0; d < 3; ++d)
    {
      for (int c = 0; c < 3; ++c)
      {
        x[c] += place.Parameters[d] * (corner(d + 1)[c] - corner(0)[c]);
      }
    }
    const Weights found = Evaluate(mesh.Level, place, values);
    for (int d = 0; d < 3; ++d)
    {
      // A central difference is the derivative of a quadratic function.
      std::array<double, 3> before = x;
      std::array<double, 3> after = x;
      for (int c = 0; c < 3; ++c)
      {
        before[c] -= 0.5 * (corner(d + 1)[c] - corner(0)[c]);
        after[c] += 0.5 * (corner(d + 1)[c] - corner(0)[c]);
      }
      EXPECT_NEAR(found[d + 1], square(after) - square(before), 1e-14) << tet;
    }
  }
  EXPECT_GE(checked, 10);
}

/// All rows of two steps, with all rules that the lattice knows.
TEST(TetOctLattice, RowsAreThoseOfAStep)
{
  std::mt19937 random(2);
  int rows = 0;
  for (const std::string& name : GetNamesOfZoo(8))
  {
    for (const char* options : { "Blend", "Sharp", "LoopWeights", "ModifiedBoundary" })
    {
      TetOctLevel<int> level =
        MakeTetOctLevel(std::move(BuildNamed<int>(FindInZoo(name), options).Level));
      for (int step = 0; step < 2; ++step)
      {
        const int vertices = level.Complex.NumberOfVertices;
        const int edges = level.Complex.NumberOfEdges;
        const int size = vertices + edges + level.NumberOfOctahedra;
        const Values before = DrawValues(vertices, random);
        Values after(static_cast<std::size_t>(size));
        CopyStencils(level).Apply(before.data(), after.data(), 1);
        const Rows<int> solids = ListSolidsAtVertices(level);
        const TetOctLattice<int> lattice(level, level.Strata, solids);
        LatticeRow<int> row;
        for (int i = 0; i < size; ++i)
        {
          const LatticeVertex<int> vertex = i < vertices
            ? LatticeVertex<int>{ 0, i, { { 2, 0, 0, 0 } } }
            : i < vertices + edges
            ? LatticeVertex<int>{ 1, i - vertices, { { 1, 1, 0, 0 } } }
            : LatticeVertex<int>{ 3, level.Complex.NumberOfTets + i - vertices - edges,
                { { 0, 0, 0, 2 } } };
          ASSERT_TRUE(lattice.ReadRow(vertex, row));
          ++rows;
          double sum = 0.;
          for (std::size_t k = 0; k < row.Vertices.size(); ++k)
          {
            sum += row.Weights[k] * before[row.Vertices[k].Simplex];
          }
          EXPECT_NEAR(sum, after[i], 1e-14) << name << " " << options << " " << step << " " << i;
        }
        level = Refine(level, Depth::ForRefinement);
      }
    }
  }
  EXPECT_GT(rows, 10000);
}
