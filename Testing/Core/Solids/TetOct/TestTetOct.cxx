// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 10: levels of tetrahedra and octahedra, the rows of the operator, and how smooth they
// are.
#include "TetOctTools.h"

using namespace tetoct_tools;

namespace
{

bool IsSolid(Stratum stratum)
{
  return stratum.GetRule() == Rule::Solid || stratum.GetRule() == Rule::RegularEdge;
}

}

TEST(TetOctCore, OneTetrahedronHasTheCountsOfThePaper)
{
  const int counts[3][3] = { { 4, 1, 10 }, { 24, 10, 35 }, { 176, 84, 165 } };
  for (int steps = 1; steps <= 3; ++steps)
  {
    const TetOctMesh<int> mesh = BuildTetOctAt<int>(MakeTet("Tet"), steps);
    EXPECT_EQ(mesh.Level.Complex.NumberOfTets, counts[steps - 1][0]);
    EXPECT_EQ(mesh.Level.NumberOfOctahedra, counts[steps - 1][1]);
    EXPECT_EQ(mesh.Level.Complex.NumberOfVertices, counts[steps - 1][2]);
  }
}

TEST(TetOctCore, SolidsAreSplitAsInTheBook)
{
  ForEachMesh(
    [](const Mesh& mesh)
    {
      TetOctMesh<int> level = BuildTetOct<int>(mesh.Cells, mesh.Singular);
      for (int step = 0; step < 2; ++step)
      {
        const SlowStep slow(level.Level);
        level = RefineOnce(level);
        std::multiset<std::vector<Tuple>> expected;
        std::multiset<std::vector<Tuple>> actual;
        for (const Solid& solid : slow.Children)
        {
          expected.insert(Normal(solid));
        }
        for (const Solid& solid : GetSolids(level.Level))
        {
          actual.insert(Normal(solid));
        }
        ASSERT_EQ(actual, expected);
      }
    });
}

TEST(TetOctCore, IncidencesAreThoseOfTheVertices)
{
  ForEachMesh(
    [](const Mesh& mesh)
    {
      TetOctMesh<int> level = BuildTetOct<int>(mesh.Cells, mesh.Singular);
      for (int step = 0; step < 2; ++step)
      {
        level = RefineOnce(level);
        const auto& complex = level.Level.Complex;
        auto edge = [&complex](int e)
        { return Sorted({ complex.EdgeVertices[2 * e], complex.EdgeVertices[2 * e + 1] }); };
        auto face = [&complex](int f)
        {
          const int* v = complex.FaceVertices.data() + 3 * f;
          return Sorted({ v[0], v[1], v[2] });
        };
        std::map<Tuple, std::multiset<int>> cellsAt;
        auto check = [&](const int* v, const int* edges, const int* faces, auto shape, int cell)
        {
          using Shape = decltype(shape);
          for (int e = 0; e < Shape::Edges; ++e)
          {
            const int* ends = Shape::EdgeVertices[e];
            ASSERT_EQ(edge(edges[e]), Sorted({ v[ends[0]], v[ends[1]] }));
          }
          for (int f = 0; f < Shape::Faces; ++f)
          {
            const int* c = Shape::FaceVertices[f];
            ASSERT_EQ(face(faces[f]), Sorted({ v[c[0]], v[c[1]], v[c[2]] }));
            cellsAt[face(faces[f])].insert(cell);
          }
        };
        for (int t = 0; t < complex.NumberOfTets; ++t)
        {
          check(complex.TetVertices.data() + 4 * t, complex.TetEdges.data() + 6 * t,
            complex.TetFaces.data() + 4 * t, TetShape(), t);
        }
        for (int o = 0; o < level.Level.NumberOfOctahedra; ++o)
        {
          check(level.Level.OctVertices.data() + 6 * o, level.Level.OctEdges.data() + 12 * o,
            level.Level.OctFaces.data() + 8 * o, OctShape(), complex.NumberOfTets + o);
        }
        for (int f = 0; f < complex.NumberOfFaces; ++f)
        {
          const Row<int> row = complex.FaceTets[f];
          ASSERT_EQ(std::multiset<int>(row.begin(), row.end()), cellsAt[face(f)]);
          for (int i = 0; i < 3; ++i)
          {
            const int* ends = triangle::EdgeVertices[i];
            ASSERT_EQ(edge(complex.FaceEdges[3 * f + i]),
              Sorted(
                { complex.FaceVertices[3 * f + ends[0]], complex.FaceVertices[3 * f + ends[1]] }));
          }
        }
      }
    });
}

TEST(TetOctCore, RowsOfSolidsEqualTheSlowOnes)
{
  ForEachMesh(
    [](const Mesh& mesh)
    {
      TetOctMesh<int> level = BuildTetOct<int>(mesh.Cells, mesh.Singular);
      for (int step = 0; step < 3 && level.Level.Complex.NumberOfVertices < 400; ++step)
      {
        const SlowStep slow(level.Level);
        const Matrix matrix = MakeMatrix(CopyStencils(level.Level));
        const auto& complex = level.Level.Complex;
        ASSERT_EQ(matrix.size(), slow.Linear.size());
        for (std::size_t row = 0; row < matrix.size(); ++row)
        {
          ASSERT_NEAR(std::accumulate(matrix[row].begin(), matrix[row].end(), 0.), 1., 1e-14);
          ASSERT_GE(*std::min_element(matrix[row].begin(), matrix[row].end()), 0.);
          const int edge = static_cast<int>(row) - complex.NumberOfVertices;
          if (edge < 0 ? !IsSolid(level.Level.Strata.Vertices[row])
                       : edge < complex.NumberOfEdges && !IsSolid(level.Level.Strata.Edges[edge]))
          {
            continue;
          }
          auto expected = slow.Smoothed[row];
          for (std::size_t i = 0; i < matrix[row].size(); ++i)
          {
            ASSERT_NEAR(matrix[row][i], expected[static_cast<vtkIdType>(i)], 1e-14)
              << "step " << step << " row " << row << " of " << complex.NumberOfVertices
              << " column " << i;
          }
        }
        level = RefineOnce(level);
      }
    });
}

TEST(TetOctCore, OtherRowsOfTheControlMeshAreThoseOfTheBoxSpline)
{
  ForEachMesh(
    [](const Mesh& mesh)
    {
      const TetOctMesh<int> level = BuildTetOct<int>(mesh.Cells, mesh.Singular);
      const Matrix rows = MakeMatrix(CopyStencils(level.Level));
      const Matrix expected =
        coretest::MakeMatrix(coretest::CopyStencils(Build<int>(mesh.Cells, mesh.Singular).Level));
      ASSERT_EQ(rows.size(), expected.size());
      const int vertices = level.Level.Complex.NumberOfVertices;
      for (int row = 0; row < static_cast<int>(rows.size()); ++row)
      {
        if (!IsSolid(row < vertices ? level.Level.Strata.Vertices[row]
                                    : level.Level.Strata.Edges[row - vertices]))
        {
          ASSERT_EQ(rows[row], expected[row]);
        }
      }
    });
}

TEST(TetOctCore, BlendedVerticesHaveAllNeighboursByEdges)
{
  ForEachMesh(
    [](const Mesh& mesh)
    {
      TetOctMesh<int> level = BuildTetOct<int>(mesh.Cells, mesh.Singular);
      for (int step = 0; step < 2; ++step)
      {
        level = RefineOnce(level);
        const auto& complex = level.Level.Complex;
        std::map<vtkIdType, std::set<vtkIdType>> neighbours;
        std::map<Tuple, std::set<vtkIdType>> apexes;
        for (int e = 0; e < complex.NumberOfEdges; ++e)
        {
          const int* ends = complex.EdgeVertices.data() + 2 * e;
          neighbours[ends[0]].insert(ends[1]);
          neighbours[ends[1]].insert(ends[0]);
        }
        for (int f = 0; f < complex.NumberOfFaces; ++f)
        {
          const int* v = complex.FaceVertices.data() + 3 * f;
          for (int i = 0; i < 3; ++i)
          {
            apexes[Sorted({ v[i], v[(i + 1) % 3] })].insert(v[(i + 2) % 3]);
          }
        }
        for (int v = 0; v < complex.NumberOfVertices; ++v)
        {
          if (level.Level.Strata.Vertices[v].GetRule() == Rule::Blend)
          {
            const Tuple ring = GetRing(level.Level.Strata.VertexRings, v);
            ASSERT_EQ(ring, Tuple(neighbours[v].begin(), neighbours[v].end())) << v;
          }
        }
        for (int e = 0; e < complex.NumberOfEdges; ++e)
        {
          if (level.Level.Strata.Edges[e].GetRule() == Rule::Blend)
          {
            const int* ends = complex.EdgeVertices.data() + 2 * e;
            const auto& expected = apexes[Sorted({ ends[0], ends[1] })];
            ASSERT_EQ(
              GetRing(level.Level.Strata.EdgeRings, e), Tuple(expected.begin(), expected.end()));
          }
        }
      }
    });
}

TEST(TetOctCore, InteriorMaskIsTheSelfConvolutionOfFigure9)
{
  // In four coordinates that sum to zero the neighbours of a lattice point are the permutations of
  // (1,-1,0,0), and what is opposite in an octahedron those of (1,1,-1,-1).
  using Place = std::array<int, 4>;
  std::map<Place, double> linear = { { { 0, 0, 0, 0 }, 1. } };
  Place near = { -1, 0, 0, 1 };
  do
  {
    linear[near] = 1. / 2.;
  } while (std::next_permutation(near.begin(), near.end()));
  Place far = { -1, -1, 1, 1 };
  do
  {
    linear[far] = 1. / 6.;
  } while (std::next_permutation(far.begin(), far.end()));
  ASSERT_EQ(linear.size(), 19u);
  std::map<Place, double> expected;
  for (const auto& a : linear)
  {
    for (const auto& b : linear)
    {
      Place sum;
      std::transform(
        a.first.begin(), a.first.end(), b.first.begin(), sum.begin(), std::plus<int>());
      expected[sum] += a.second * b.second / 8.;
    }
  }
  ASSERT_EQ(expected.size(), 85u);
  // The places of the points of a refined tetrahedron, on the finest lattice: linear subdivision.
  TetOctMesh<int> level = BuildTetOct<int>(MakeTet("Tet").Cells);
  constexpr int steps = 3;
  constexpr double finest = 1 << (steps + 1);
  Matrix places = { { finest, 0, 0, 0 }, { 0, finest, 0, 0 }, { 0, 0, finest, 0 },
    { 0, 0, 0, finest } };
  Matrix fine;
  for (int step = 0; step <= steps; ++step)
  {
    fine.clear();
    for (const auto& row : SlowStep(level.Level).Linear)
    {
      fine.emplace_back(4, 0.);
      for (const auto& term : row)
      {
        for (int c = 0; c < 4; ++c)
        {
          fine.back()[c] += term.second * places[term.first][c];
        }
      }
    }
    if (step < steps)
    {
      level = RefineOnce(level);
      places = fine;
    }
  }
  const std::vector<double> middle(4, finest / 4.);
  const auto at = std::find(places.begin(), places.end(), middle) - places.begin();
  ASSERT_LT(at, static_cast<std::ptrdiff_t>(places.size()));
  const Matrix matrix = MakeMatrix(CopyStencils(level.Level));
  std::map<Place, double> mask;
  for (std::size_t row = 0; row < matrix.size(); ++row)
  {
    if (matrix[row][at] != 0.)
    {
      Place offset;
      for (int c = 0; c < 4; ++c)
      {
        offset[c] = static_cast<int>(std::lround(fine[row][c] - middle[c]));
      }
      mask[offset] = matrix[row][at];
    }
  }
  ASSERT_EQ(mask.size(), expected.size());
  EXPECT_NEAR((mask[{ 0, 0, 0, 0 }]), 25. / 48., 1e-15);
  for (const auto& term : expected)
  {
    EXPECT_NEAR(mask[term.first], term.second, 1e-15);
  }
}

TEST(TetOctCore, SpectrumAtAFace)
{
  // What is two cells away from a point of the face stays so, on a lattice half as large.
  const Mesh mesh = FindInZoo("TwoTets");
  TetOctMesh<int> level = BuildTetOct<int>(mesh.Cells);
  constexpr int steps = 3;
  constexpr int finest = 1 << (steps + 1);
  std::vector<std::vector<int>> places;
  for (int v = 0; v < 5; ++v)
  {
    places.emplace_back(5, 0);
    places.back()[v] = finest;
  }
  std::vector<std::vector<int>> fine;
  for (int step = 0; step <= steps; ++step)
  {
    fine.clear();
    for (const auto& row : SlowStep(level.Level).Linear)
    {
      std::vector<double> sum(5, 0.);
      for (const auto& term : row)
      {
        for (int c = 0; c < 5; ++c)
        {
          sum[c] += term.second * places[term.first][c];
        }
      }
      fine.emplace_back(5);
      std::transform(sum.begin(), sum.end(), fine.back().begin(),
        [](double x) { return static_cast<int>(std::lround(x)); });
    }
    if (step < steps)
    {
      level = RefineOnce(level);
      places = fine;
    }
  }
  const std::vector<int> middle = { 0, 6, 6, 4, 0 };
  std::map<vtkIdType, int> distances;
  const auto at = std::find(places.begin(), places.end(), middle) - places.begin();
  ASSERT_LT(at, static_cast<std::ptrdiff_t>(places.size()));
  distances[at] = 0;
  for (int distance = 1; distance <= 2; ++distance)
  {
    for (const Solid& solid : GetSolids(level.Level))
    {
      const bool touches = std::any_of(solid.begin(), solid.end(),
        [&](vtkIdType v) { return distances.count(v) && distances.at(v) < distance; });
      for (vtkIdType v : solid)
      {
        if (touches)
        {
          distances.emplace(v, distance);
        }
      }
    }
  }
  const std::size_t size = distances.size();
  std::vector<double> impulses(places.size() * size, 0.);
  std::vector<vtkIdType> rows;
  for (const auto& column : distances)
  {
    impulses[column.first * size + rows.size()] = 1.;
    std::vector<int> half(5);
    for (int c = 0; c < 5; ++c)
    {
      half[c] = (middle[c] + places[column.first][c]) / 2;
    }
    rows.push_back(std::find(fine.begin(), fine.end(), half) - fine.begin());
    ASSERT_LT(rows.back(), static_cast<vtkIdType>(fine.size()));
  }
  std::vector<double> result(fine.size() * size);
  CopyStencils(level.Level).Apply(impulses.data(), result.data(), static_cast<int>(size));
  Matrix local;
  for (vtkIdType row : rows)
  {
    local.emplace_back(result.data() + row * size, result.data() + (row + 1) * size);
    ASSERT_NEAR(std::accumulate(local.back().begin(), local.back().end(), 0.), 1., 1e-14);
  }
  const std::vector<double> spectrum = GetSpectrum(local);
  for (int k = 0; k < 13; ++k)
  {
    const double expected = k == 0 ? 1. : k < 4 ? 0.5 : k < 10 ? 0.25 : 0.1367;
    EXPECT_NEAR(spectrum[k], expected, k < 10 ? 1e-9 : 5e-5) << k;
  }
  EXPECT_LT(spectrum[13], 0.1366);
}

TEST(TetOctCore, SpectrumAlongAnEdge)
{
  const double pairs[8] = { .31702, .42812, .49479, .53563, .56194, .57972, .59223, .60135 };
  for (int n = 3; n <= 14; ++n)
  {
    SCOPED_TRACE(n);
    const TetOctMesh<int> level = BuildTetOctAt<int>(MakeTetsAroundEdge(n), 1);
    int v = n + 2; // the midpoint of the only edge inside
    while (level.Level.Strata.Vertices[v].GetRule() != Rule::Solid)
    {
      ++v;
    }
    ASSERT_EQ(level.Level.Strata.VertexRings.GetSize(v), 2 + 3 * n);
    std::vector<double> spectrum = GetSpectrum(GetLocalMatrix(level, v));
    EXPECT_NEAR(spectrum[0], 1., 1e-10);
    const std::vector<double> first(spectrum.begin() + 1, spectrum.begin() + 4);
    auto has = [](const std::vector<double>& list, double value, double tolerance)
    {
      return std::count_if(
        list.begin(), list.end(), [&](double x) { return std::abs(x - value) < tolerance; });
    };
    if (n <= 10)
    {
      EXPECT_EQ(has(spectrum, pairs[n - 3], 6e-6), 2);
      // Condition (24): the three largest after 1 are the edge's own and the pair.
      EXPECT_EQ(has(first, 0.5, 1e-9), 1);
      EXPECT_EQ(has(first, pairs[n - 3], 6e-6), 2);
      EXPECT_LT(spectrum[4], std::min(0.5, pairs[n - 3]) - 1e-4);
    }
    else
    {
      EXPECT_EQ(has(first, 0.5, 1e-9), 0);
      EXPECT_GT(spectrum[3], 0.5);
      if (n == 11)
      {
        EXPECT_NEAR(spectrum[3], 0.5176, 5e-5);
      }
    }
  }
}

TEST(TetOctCore, ValuesThatOverflowInASumStayFinite)
{
  const Mesh mesh = MakeLattice("Lattice", 2, 1., 3).Control;
  std::vector<double> huge(mesh.Points.size(), 1.7e308);
  const auto levels = SubdividePoints<OfTetOct>(mesh, huge, 3, 2);
  for (double value : levels.back())
  {
    ASSERT_NEAR(value / 1.7e308, 1., 1e-12);
  }
}
