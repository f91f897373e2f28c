// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 1: the operator on the whole zoo. Rows sum to 1, no weight is negative, affine maps
// commute; neither threads nor the width of ids nor the number of components changes a bit.
#include "BackEnds.h"
#include "CoreReference.h"
#include "TetOctTools.h"

#include <cstring>

using namespace tetoct_tools;

namespace
{

template <typename T>
bool SameBits(const std::vector<T>& a, const std::vector<T>& b)
{
  return a.size() == b.size() &&
    (a.empty() || std::memcmp(a.data(), b.data(), sizeof(T) * a.size()) == 0);
}

template <typename Scheme>
class CoreOperatorOf : public testing::Test
{
};
using Schemes = testing::Types<OfBoxSpline, OfTetOct>;
TYPED_TEST_SUITE(CoreOperatorOf, Schemes);

}

TEST(CoreOperator, RowsAreConvex)
{
  ForEachMesh(
    [](const Mesh& mesh)
    {
      Subdivided<int> level = Build<int>(mesh.Cells, mesh.Singular);
      for (int step = 0; step <= 2; ++step)
      {
        if (level.Level.Complex.NumberOfVertices > 600)
        {
          break; // the matrix is dense
        }
        const Matrix matrix = MakeMatrix(CopyStencils(level.Level));
        ASSERT_EQ(static_cast<int>(matrix.size()),
          level.Level.Complex.NumberOfVertices + level.Level.Complex.NumberOfEdges);
        for (const auto& row : matrix)
        {
          ASSERT_NEAR(std::accumulate(row.begin(), row.end(), 0.), 1., 1e-14);
          ASSERT_TRUE(std::all_of(row.begin(), row.end(), [](double w) { return w >= 0.; }));
        }
        level = RefineOnce(level);
      }
    });
}

TEST(CoreOperator, RowsEqualReference)
{
  ForEachMesh(
    [](const Mesh& mesh)
    {
      const Subdivided<int> level = Build<int>(mesh.Cells, mesh.Singular);
      const Reference reference(mesh.Cells, mesh.Singular);
      const Matrix matrix = MakeMatrix(CopyStencils(level.Level));
      const int vertices = level.Level.Complex.NumberOfVertices;
      auto expectRow = [&](const std::vector<double>& row, const std::vector<double>& expected)
      {
        ASSERT_EQ(row.size(), expected.size());
        for (std::size_t i = 0; i < row.size(); ++i)
        {
          ASSERT_NEAR(row[i], expected[i], 1e-15);
        }
      };
      for (int v = 0; v < vertices; ++v)
      {
        expectRow(matrix[v], reference.MakeRow({ v }, reference.Vertices[v]));
      }
      for (int e = 0; e < level.Level.Complex.NumberOfEdges; ++e)
      {
        const int* ends = level.Level.Complex.EdgeVertices.data() + 2 * e;
        const Tuple edge = Sorted({ ends[0], ends[1] });
        expectRow(matrix[vertices + e], reference.MakeRow(edge, reference.Edges.at(edge)));
      }
    });
}

TYPED_TEST(CoreOperatorOf, AffineMapsCommute)
{
  ForEachMesh(
    [](const Mesh& mesh)
    {
      auto map = [](const std::vector<double>& points)
      {
        const double a[3][4] = { { 2, -1, 0.5, 10 }, { 0.3, 1.5, -2, -7 }, { -1, 0.25, 3, 0.125 } };
        std::vector<double> mapped(points.size());
        for (std::size_t i = 0; i < points.size(); i += 3)
        {
          for (int c = 0; c < 3; ++c)
          {
            mapped[i + c] =
              a[c][0] * points[i] + a[c][1] * points[i + 1] + a[c][2] * points[i + 2] + a[c][3];
          }
        }
        return mapped;
      };
      const auto plain = SubdividePoints<TypeParam>(mesh, mesh.Points, 3, 3);
      const auto mapped = SubdividePoints<TypeParam>(mesh, map(mesh.Points), 3, 3);
      for (int step = 0; step <= 3; ++step)
      {
        const std::vector<double> expected = map(plain[step]);
        for (std::size_t i = 0; i < expected.size(); ++i)
        {
          ASSERT_NEAR(mapped[step][i], expected[i], 1e-12) << step;
        }
      }
    });
}

TYPED_TEST(CoreOperatorOf, WidthOfIdsDoesNotMatter)
{
  ForEachMesh(
    [](const Mesh& mesh)
    {
      const auto narrow = SubdividePoints<TypeParam>(mesh, mesh.Points, 3, 3);
      const auto wide = SubdividePoints<TypeParam, long long>(mesh, mesh.Points, 3, 3);
      EXPECT_TRUE(SameBits(narrow.back(), wide.back()));
    });
}

TEST(CoreOperator, WidthOfIdsDoesNotMatter)
{
  ForEachMesh(
    [](const Mesh& mesh)
    {
      Subdivided<int> a = Build<int>(mesh.Cells, mesh.Singular);
      Subdivided<long long> b = Build<long long>(mesh.Cells, mesh.Singular);
      for (int step = 0; step < 2; ++step)
      {
        EXPECT_EQ(ReadCells(a).Connectivity, ReadCells(b).Connectivity);
        EXPECT_EQ(ReadChildren(a).Connectivity, ReadChildren(b).Connectivity);
        for (int e = 0; e < a.Level.Complex.NumberOfEdges; ++e)
        {
          ASSERT_EQ(a.Level.Strata.Edges[e].GetRule(), b.Level.Strata.Edges[e].GetRule());
          ASSERT_EQ(a.Level.Strata.Edges[e].GetType(), b.Level.Strata.Edges[e].GetType());
          ASSERT_EQ(
            GetRing(a.Level.Strata.EdgeRings, e), GetRing(b.Level.Strata.EdgeRings, vtkIdType(e)));
        }
        a = RefineOnce(a);
        b = RefineOnce(b);
      }
    });
}

TYPED_TEST(CoreOperatorOf, ComponentsAreIndependent)
{
  ForEachMesh(
    [](const Mesh& mesh)
    {
      const auto together = SubdividePoints<TypeParam>(mesh, mesh.Points, 3, 2).back();
      std::vector<double> pairs;
      for (std::size_t i = 0; i < mesh.Points.size(); i += 3)
      {
        pairs.insert(pairs.end(), { mesh.Points[i + 1], mesh.Points[i] });
      }
      const auto two = SubdividePoints<TypeParam>(mesh, pairs, 2, 2).back();
      for (int c = 0; c < 3; ++c)
      {
        std::vector<double> own;
        for (std::size_t i = c; i < mesh.Points.size(); i += 3)
        {
          own.push_back(mesh.Points[i]);
        }
        const auto alone = SubdividePoints<TypeParam>(mesh, own, 1, 2).back();
        for (std::size_t i = 0; i < alone.size(); ++i)
        {
          ASSERT_EQ(alone[i], together[3 * i + c]);
          if (c < 2)
          {
            ASSERT_EQ(alone[i], two[2 * i + 1 - c]);
          }
        }
      }
    });
}

TYPED_TEST(CoreOperatorOf, SameBitsInAllBackEndsAndThreads)
{
  const Mesh mesh = MakeLattice("Large", 12, 0.1, 17).Control;
  const std::string before = vtkSMPTools::GetBackend();
  std::vector<double> first;
  SimplexList firstCells;
  int ran = 0;
  for (const char* name : BackEnds)
  {
    if (!vtkSMPTools::SetBackend(name))
    {
      continue;
    }
    for (int threads = 1; threads <= 4; ++threads)
    {
      SCOPED_TRACE(std::string(name) + " " + std::to_string(threads));
      vtkSMPTools::Initialize(threads);
      const auto points = SubdividePoints<TypeParam>(mesh, mesh.Points, 3, 2).back();
      SimplexList cells;
      if constexpr (std::is_same_v<TypeParam, OfBoxSpline>)
      {
        cells = ReadChildren(RefineOnce(Build<int>(mesh.Cells)));
      }
      if (ran++ == 0)
      {
        first = points;
        firstCells = cells;
      }
      EXPECT_TRUE(SameBits(points, first));
      EXPECT_EQ(cells.Connectivity, firstCells.Connectivity);
    }
  }
  EXPECT_GE(ran, 8) << "Sequential and STDThread are always there";
  vtkSMPTools::SetBackend(before.c_str());
  vtkSMPTools::Initialize(0);
}

TEST(CoreOperator, ValuesAreStoredInTheTypeOfTheArray)
{
  Mesh line("Line");
  for (int i = 0; i < 3; ++i)
  {
    line.AddPoint(i, 0, 0);
  }
  line.AddCells({ { 0, 1 }, { 1, 2 } });
  // float: each level is rounded, sums are not.
  const auto floats =
    SubdividePoints<OfBoxSpline>(line, std::vector<float>{ 0.1f, 0.7f, 0.4f }, 1, 1);
  EXPECT_EQ(
    floats[1][1], static_cast<float>(0.75 * double(0.7f) + 0.125 * (double(0.1f) + double(0.4f))));
  EXPECT_EQ(floats[1][3], static_cast<float>(0.5 * (double(0.1f) + double(0.7f))));
  // Integers are rounded to the nearest and stay in range.
  const auto bytes =
    SubdividePoints<OfBoxSpline>(line, std::vector<unsigned char>{ 255, 255, 254 }, 1, 2);
  EXPECT_EQ(bytes[1], (std::vector<unsigned char>{ 255, 255, 254, 255, 255 }));
  const auto signedOnes = SubdividePoints<OfBoxSpline>(line, std::vector<int>{ -3, 0, 5 }, 1, 1);
  EXPECT_EQ(signedOnes[1], (std::vector<int>{ -3, 0, 5, -1, 3 }));
}

TEST(CoreOperator, ValuesThatAreNotFiniteStayWhereNobodyReadsThem)
{
  Mesh mesh("Line");
  for (int i = 0; i < 4; ++i)
  {
    mesh.AddPoint(i, 0, 0);
  }
  mesh.AddCells({ { 0, 1 }, { 1, 2 } });
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto all = SubdividePoints<OfBoxSpline>(mesh, std::vector<double>{ 0., 1., 2., nan }, 1, 2);
  for (std::size_t i = 0; i < all.back().size(); ++i)
  {
    EXPECT_EQ(std::isnan(all.back()[i]), i == 3) << i;
  }
}
