// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 8: limits. What a limit row says of a level's values must be what the rows of the
// next level say of the next values; with rows that read neighbours only, that makes it the limit.
#include "LimitTools.h"

#include "Core/Rules/Pi.h"
#include "Core/Solids/TetOct/TetOctComplex.h"

using namespace coretest;

namespace
{

/// The limit row of vertex 0 of a mesh.
SparseRows<int> MakeRows(const Mesh& mesh, const std::string& options = "Blend")
{
  return BuildLimitRows(BuildNamed<int>(mesh, options).Level);
}

}

TEST(LimitStencils, AStepDoesNotMoveTheLimit)
{
  ForEachMeshAndOptions(
    [](const Mesh& mesh, const std::string& options)
    {
      Subdivided<int> level = BuildNamed<int>(mesh, options);
      std::vector<double> values = MakeValues(level.Level.Complex.NumberOfVertices, 1);
      std::vector<double> limits = ApplyTo(BuildLimitRows(level.Level), values, 1);
      for (int step = 0; step < 2; ++step)
      {
        values = ApplyTo(CopyStencils(level.Level), values, 1);
        level = RefineOnce(level);
        const std::vector<double> next = ApplyTo(BuildLimitRows(level.Level), values, 1);
        ExpectSameStart(limits, next);
        limits = next;
      }
    });
}

TEST(LimitStencils, RowsAreConvexAndLocal)
{
  ForEachMeshAndOptions(
    [](const Mesh& mesh, const std::string& options)
    {
      const Subdivided<int> level = BuildNamed<int>(mesh, options);
      const auto& complex = level.Level.Complex;
      const SparseRows<int> rows = BuildLimitRows(level.Level);
      ASSERT_EQ(rows.GetNumberOfRows(), complex.NumberOfVertices);
      ASSERT_EQ(rows.GetNumberOfColumns(), complex.NumberOfVertices);
      // The flatness of concave corners near by has negative weights, and reads one edge farther.
      const auto& sectors = level.Level.Strata.Sectors;
      const bool isFlat = std::any_of(sectors.begin(), sectors.end(),
        [](const SectorEdge<int>& sector) { return sector.Flatness > 0.; });
      for (int v = 0; v < complex.NumberOfVertices; ++v)
      {
        double sum = 0.;
        std::set<int> columns;
        for (int k = rows.Offsets[v]; k < rows.Offsets[v + 1]; ++k)
        {
          const int column = rows.Columns[k];
          ASSERT_TRUE(columns.insert(column).second) << "a column twice";
          ASSERT_TRUE(isFlat || rows.Weights[k] > 0.) << rows.Weights[k];
          ASSERT_TRUE(isFlat || column == v || FindEdge(complex, v, column) >= 0);
          sum += rows.Weights[k];
        }
        ASSERT_NEAR(sum, 1., 2e-15);
        if (level.Level.Strata.Vertices[v].GetRule() == Rule::Corner)
        {
          ASSERT_EQ(columns, std::set<int>{ v });
        }
      }
    });
}

TEST(LimitStencils, ClosedForms)
{
  const SparseRows<int> curve = MakeRows(FindInZoo("ClosedPolyline"));
  EXPECT_NEAR(GetWeight(curve, 0, 0), 2. / 3., 1e-15);
  EXPECT_NEAR(GetWeight(curve, 0, 1), 1. / 6., 1e-15);
  for (int m : { 3, 4, 5, 6, 7, 20, 3000 })
  {
    const SparseRows<int> rows = MakeRows(MakeFan("Fan", m, true));
    const double c = m == 3 ? 3. / 16. : 3. / (8. * m);
    const double b = 8. * c / (3. + 8. * m * c);
    EXPECT_NEAR(GetWeight(rows, 0, 0), 1. - m * b, 1e-13) << m;
    EXPECT_NEAR(GetWeight(rows, 0, 1), b, 1e-15) << m;
    EXPECT_NEAR(GetWeight(rows, 0, m), b, 1e-15) << m;
    // On the rim, a boundary curve.
    EXPECT_NEAR(GetWeight(rows, 1, 1), 2. / 3., 1e-15) << m;
    EXPECT_EQ(GetWeight(rows, 1, 0), 0.) << m;
  }
  const SparseRows<int> tet = MakeRows(FindInZoo("SingleTet"));
  EXPECT_NEAR(GetWeight(tet, 0, 0), 2. / 5., 1e-15);
  EXPECT_NEAR(GetWeight(tet, 0, 1), 1. / 5., 1e-15);
}

TEST(LimitStencils, ClosedFormOfLoopsOwnWeights)
{
  StrataOptions options;
  options.Weights = LoopWeights::Loop;
  for (int m : { 3, 4, 5, 6, 7, 20, 300 })
  {
    const Mesh fan = MakeFan("Fan", m, true);
    const double wave = 3. / 8. + std::cos(2. * Pi / m) / 4.;
    const double c = (5. / 8. - wave * wave) / m;
    const double b = 8. * c / (3. + 8. * m * c);
    const auto check = [&](const SparseRows<int>& rows, const char* scheme)
    {
      EXPECT_NEAR(GetWeight(rows, 0, 0), 1. - m * b, 1e-13) << m << scheme;
      EXPECT_NEAR(GetWeight(rows, 0, 1), b, 1e-15) << m << scheme;
      EXPECT_NEAR(GetWeight(rows, 0, m), b, 1e-15) << m << scheme;
      EXPECT_NEAR(GetWeight(rows, 1, 1), 2. / 3., 1e-15) << m << scheme;
    };
    check(BuildLimitRows(Build<int>(fan.Cells, fan.Singular, options).Level), " box spline");
    check(BuildLimitRows(MakeTetOctLevel(Build<int>(fan.Cells, fan.Singular, options).Level)),
      " tet/oct");
  }
}

/// The box spline's values at lattice points: those of its generating function (12), 15 points.
TEST(LimitStencils, KuhnLattice)
{
  const Lattice lattice = MakeLattice("Lattice", 4, 1., 11);
  const SparseRows<int> rows = BuildLimitRows(Build<int>(lattice.Control.Cells).Level);
  for (std::size_t v = 0; v < lattice.Positions.size(); ++v)
  {
    if (lattice.Positions[v] != std::array<int, 3>{ 2, 2, 2 })
    {
      continue;
    }
    const vtkIdType row = static_cast<vtkIdType>(v);
    EXPECT_EQ(rows.Offsets[row + 1] - rows.Offsets[row], 15);
    double opposite[3] = { 0., 0., 0. };
    for (int k = rows.Offsets[row]; k < rows.Offsets[row + 1]; ++k)
    {
      // Symmetric about the vertex; the same in all directions of a kind.
      std::array<int, 3> mirrored = lattice.Positions[rows.Columns[k]];
      for (int c = 0; c < 3; ++c)
      {
        opposite[c] += rows.Weights[k] * mirrored[c];
        mirrored[c] = 4 - mirrored[c];
      }
      const auto twin = std::find(lattice.Positions.begin(), lattice.Positions.end(), mirrored);
      EXPECT_NEAR(GetWeight(rows, row, twin - lattice.Positions.begin()), rows.Weights[k], 1e-15);
    }
    for (double c : opposite)
    {
      EXPECT_NEAR(c, 2., 1e-14); // linear functions are reproduced
    }
  }
}

/// Mathematics 9: a dart of valence 6.
TEST(LimitStencils, Dart)
{
  Mesh fan = MakeFan("Dart", 6, true);
  fan.Singular.insert({ 0, 1 });
  const SparseRows<int> rows = MakeRows(fan, "Dart");
  EXPECT_NEAR(GetWeight(rows, 0, 0), .5164, 5e-5);
  EXPECT_NEAR(GetWeight(rows, 0, 1), .0986, 5e-5);
  EXPECT_EQ(GetWeight(MakeRows(fan), 0, 0), 1.);
}

TEST(LimitStencils, StepsWithSemiSharpSimplicesDoNotMoveTheLimit)
{
  unsigned int seed = 0;
  ForEachMeshAndOptions(
    [&seed](const Mesh& mesh, const std::string& options)
    {
      const SemiSharpMesh semi(mesh, options, ++seed);
      std::vector<double> values = MakeValues(mesh.Cells.NumberOfPoints, seed);
      std::vector<double> limits =
        ApplyTo(BuildLimitRows(semi.MakeSmoothLevel(0), semi.MakeStages(0)), values, 1);
      const int most = mesh.Cells.NumberOfPoints > 20 ? 1 : 2;
      for (int step = 0; step < most; ++step)
      {
        values = ApplyTo(semi.MakeStencils(step), values, 1);
        const std::vector<double> next = ApplyTo(
          BuildLimitRows(semi.MakeSmoothLevel(step + 1), semi.MakeStages(step + 1)), values, 1);
        ExpectSameStart(limits, next);
        limits = next;
      }
    });
}

TEST(LimitStencils, SharpForVeryLongIsSharp)
{
  Mesh fan = MakeFan("Fan", 6, true);
  SemiSharpMesh semi(fan, "Blend", 1);
  const Level<int> smooth = semi.MakeSmoothLevel(0);
  std::fill(semi.Sharpness.Edges.begin(), semi.Sharpness.Edges.end(), 0.);
  semi.Sharpness.Faces.clear();
  const int first = FindEdge(smooth.Complex, 0, 1);
  const int second = FindEdge(smooth.Complex, 0, 4);
  semi.Sharpness.Edges[first] = 1e300;
  semi.Sharpness.Edges[second] = 500.5;
  SemiSharpStages<int> stages;
  stages.Sharpness = Buffer<double>(smooth.Complex.NumberOfEdges, 0.);
  stages.Sharpness[first] = semi.Sharpness.Edges[first];
  stages.Sharpness[second] = semi.Sharpness.Edges[second];
  stages.Stages.push_back({ 501, semi.MakeLevel(0, 500.).Strata });
  stages.Stages.push_back({ 1000000000, semi.MakeLevel(0, 501.).Strata });
  const SparseRows<int> rows = BuildLimitRows(smooth, stages);
  EXPECT_NEAR(GetWeight(rows, 0, 0), 2. / 3., 1e-14);
  EXPECT_NEAR(GetWeight(rows, 0, 1), 1. / 6., 1e-14);
  EXPECT_NEAR(GetWeight(rows, 0, 4), 1. / 6., 1e-14);
  EXPECT_NEAR(GetWeight(rows, 0, 2), 0., 1e-14);
}

TEST(LimitStencils, SomeVerticesAndWideIds)
{
  for (const Mesh& mesh : MakeZooAndRandom())
  {
    SCOPED_TRACE(mesh.Name);
    const auto narrow = Build<int>(mesh.Cells, mesh.Singular);
    const auto wide = Build<long long>(mesh.Cells, mesh.Singular);
    const SparseRows<int> all = BuildLimitRows(narrow.Level);
    const int size = narrow.Level.Complex.NumberOfVertices;
    Buffer<long long> backwards(size);
    for (int i = 0; i < size; ++i)
    {
      backwards[i] = size - 1 - i;
    }
    const SparseRows<long long> some = BuildLimitRows(wide.Level, {}, backwards);
    ASSERT_EQ(some.GetNumberOfRows(), size);
    for (int i = 0; i < size; ++i)
    {
      const int first = all.Offsets[size - 1 - i];
      ASSERT_EQ(some.Offsets[i + 1] - some.Offsets[i], all.Offsets[size - i] - first);
      for (int k = 0; k < all.Offsets[size - i] - first; ++k)
      {
        ASSERT_EQ(some.Columns[some.Offsets[i] + k], all.Columns[first + k]);
        ASSERT_EQ(some.Weights[some.Offsets[i] + k], all.Weights[first + k]);
      }
    }
  }
}
