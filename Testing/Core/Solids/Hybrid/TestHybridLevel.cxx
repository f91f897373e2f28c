// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 15: levels and rows of meshes of cells of all types.
#include "Precompiled.h"

#include "HybridTools.h"
#include "TetOctTools.h"

using namespace hybrid_tools;

namespace
{

void ExpectRow(const std::vector<double>& row, const std::map<vtkIdType, double>& expected)
{
  for (std::size_t i = 0; i < row.size(); ++i)
  {
    const auto at = expected.find(static_cast<vtkIdType>(i));
    EXPECT_NEAR(row[i], at == expected.end() ? 0. : at->second, 1e-15) << "column " << i;
  }
}

/// The volume of hexahedra, each as six tetrahedra around a diagonal and the quads' bilinear parts.
double MeasureHexes(const HybridLevel<int>& level, const std::vector<double>& p)
{
  double volume = 0.;
  const CellTable& hex = GetCellTable(CellShape::Hex);
  for (vtkIdType c = 0; c < level.Complex.Cells.GetNumberOfCells(); ++c)
  {
    // By the divergence theorem: half of both cuts of each side.
    const int* corners = level.Complex.Cells.GetCorners(c);
    const auto triple = [&](int i, int j, int k)
    {
      const double* x = p.data() + 3 * corners[i];
      const double* y = p.data() + 3 * corners[j];
      const double* z = p.data() + 3 * corners[k];
      return x[0] * (y[1] * z[2] - y[2] * z[1]) + x[1] * (y[2] * z[0] - y[0] * z[2]) +
        x[2] * (y[0] * z[1] - y[1] * z[0]);
    };
    double all = 0.;
    for (std::size_t f = 0; f < hex.Faces.size(); ++f)
    {
      const auto& q = hex.Faces[f];
      const double side = triple(q[0], q[1], q[2]) + triple(q[0], q[2], q[3]) +
        triple(q[0], q[1], q[3]) + triple(q[1], q[2], q[3]);
      all += (f == 0 ? -1. : 1.) * side / 12.; // the bottom is the only side seen from inside
    }
    volume += std::abs(all);
  }
  return volume;
}

}

TEST(HybridLevel, UnitCube)
{
  const HybridMesh cube = MakeBox(1, 0);
  HybridLevel<int> level = MakeLevel<int>(cube);
  std::vector<double> points = cube.Points;
  for (const double expected : { .42708333, .35019180, .33308094, .32892638 })
  {
    points = ApplyStep(level, points);
    level = RefineHybrid(level, HybridRules::Smooth);
    if (expected > .4)
    {
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(points[c], 2. / 9., 1e-15);
      }
    }
    EXPECT_NEAR(MeasureHexes(level, points), expected, 1e-8);
  }
  EXPECT_EQ(level.Complex.Cells.GetNumberOfCells(), 4096);
  EXPECT_EQ(level.Complex.NumberOfVertices, 17 * 17 * 17);
}

TEST(HybridLevel, MiddleOfALatticeIsATricubicSpline)
{
  const HybridMesh box = MakeBox(2, 0);
  const std::vector<double> row = GetRow(box, 13); // the middle of 27 points
  for (int i = 0; i < 27; ++i)
  {
    const double at[3] = { i % 3 == 1 ? 6. : 1., i / 3 % 3 == 1 ? 6. : 1., i / 9 == 1 ? 6. : 1. };
    EXPECT_NEAR(row[i], at[0] * at[1] * at[2] / 512., 1e-15);
  }
}

TEST(HybridLevel, ColumnsAreSurfacesTimesACurve)
{
  for (const CellShape shape : { CellShape::Hex, CellShape::Wedge })
  {
    for (const int n : { 3, 4, 5, 6, 7 })
    {
      const HybridMesh column = MakeColumn(shape, n);
      const double w = shape == CellShape::Hex ? 4. / n : n == 3 ? 1.5 : 1.;
      const double own = 1. - w + w * (shape == CellShape::Hex ? 9. / 16. : 5. / 8.);
      const double near = 3. * w / 8. / n;
      const std::vector<double> row = GetRow(column, 1);
      for (int z = 0; z < 3; ++z)
      {
        const double along = z == 1 ? 3. / 4. : 1. / 8.;
        const int ring = shape == CellShape::Hex ? 2 * n : n;
        EXPECT_NEAR(row[z], own * along, 1e-15);
        for (int i = 0; i < n; ++i)
        {
          EXPECT_NEAR(row[3 + z * ring + i], near * along, 1e-15) << n;
        }
      }
    }
  }
  // The edge of three hexahedra, whose relaxed row is in Mathematics 15.
  const HybridMesh three = MakeColumn(CellShape::Hex, 3);
  const HybridLevel<int> level = MakeLevel<int>(three);
  const vtkIdType edge = level.Complex.NumberOfVertices + level.Complex.FindEdge(0, 1);
  const std::vector<double> row = GetRow(three, edge);
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(row[3 + i], 1. / 12., 1e-15);
    EXPECT_NEAR(row[6 + i], 1. / 72., 1e-15);
  }
  EXPECT_NEAR(row[0], 5. / 24., 1e-15);
}

TEST(HybridLevel, ColumnsStayColumns)
{
  // After a step the vertices of a column of three hexahedra still take w = 4/3.
  const HybridMesh column = MakeColumn(CellShape::Hex, 3);
  const HybridLevel<int> level = RefineHybrid(MakeLevel<int>(column), HybridRules::Smooth);
  const vtkIdType size = level.Complex.NumberOfVertices;
  std::vector<double> impulse(static_cast<std::size_t>(size), 0.);
  impulse[1] = 1.;
  const std::vector<double> next = ApplyStep(level, impulse, 1);
  EXPECT_NEAR(next[1], (1. - 4. / 3. + 4. / 3. * 9. / 16.) * 3. / 4., 1e-15);
  const vtkIdType between = MakeLevel<int>(column).Complex.FindEdge(0, 1) + 21;
  impulse[1] = 0.;
  impulse[static_cast<std::size_t>(between)] = 1.;
  EXPECT_NEAR(ApplyStep(level, impulse, 1)[static_cast<std::size_t>(between)],
    (1. - 4. / 3. + 4. / 3. * 9. / 16.) * 3. / 4., 1e-15);
}

TEST(HybridLevel, QuadBetweenAHexAndAPyramid)
{
  HybridMesh mesh = MakeBox(1, 0);
  mesh.AddPoint(.5, .5, 2.);
  mesh.Cells.push_back({ CellShape::Pyramid, { 4, 5, 7, 6, 8 } });
  const HybridLevel<int> level = MakeLevel<int>(mesh);
  int quads = 0;
  for (int f = 0; f < level.Complex.NumberOfQuads; ++f)
  {
    if (level.Complex.FaceSolids[f].size() == 2)
    {
      ++quads;
      std::map<vtkIdType, double> expected{ { 8, 17. / 112. } };
      for (int i = 0; i < 8; ++i)
      {
        expected[i] = i < 4 ? 1. / 32. : 81. / 448.;
      }
      ExpectRow(
        GetRow(mesh, level.Complex.NumberOfVertices + level.Complex.NumberOfEdges + f), expected);
    }
  }
  EXPECT_EQ(quads, 1);
}

TEST(HybridLevel, CubeOfSixPyramids)
{
  HybridMesh mesh = MakeBox(1, 0);
  mesh.Cells.clear();
  mesh.AddPoint(.5, .5, .5);
  for (const auto& base : { std::vector<vtkIdType>{ 0, 1, 3, 2 }, { 4, 6, 7, 5 }, { 0, 4, 5, 1 },
         { 1, 5, 7, 3 }, { 3, 7, 6, 2 }, { 2, 6, 4, 0 } })
  {
    mesh.Cells.push_back({ CellShape::Pyramid, base });
    mesh.Cells.back().Corners.push_back(8);
  }
  std::map<vtkIdType, double> expected{ { 8, 13. / 24. } };
  for (int i = 0; i < 8; ++i)
  {
    expected[i] = 11. / 192.;
  }
  ExpectRow(GetRow(mesh, 8), expected);
}

TEST(HybridLevel, QuadOfThreeHexes)
{
  HybridMesh mesh;
  const vtkIdType shared[4] = { 0, 1, 2, 3 };
  for (int i = 0; i < 16; ++i)
  {
    mesh.AddPoint(i % 4, i / 4, i % 3);
  }
  for (vtkIdType k = 0; k < 3; ++k)
  {
    mesh.Cells.push_back({ CellShape::Hex,
      { shared[0], shared[1], shared[2], shared[3], 4 + 4 * k, 5 + 4 * k, 6 + 4 * k, 7 + 4 * k } });
  }
  const HybridLevel<int> level = MakeLevel<int>(mesh);
  for (int f = 0; f < level.Complex.NumberOfQuads; ++f)
  {
    if (level.Complex.FaceSolids[f].size() == 3)
    {
      std::map<vtkIdType, double> expected;
      for (int i = 0; i < 16; ++i)
      {
        expected[i] = i < 4 ? 3. / 16. : 1. / 48.;
      }
      const vtkIdType row = level.Complex.NumberOfVertices + level.Complex.NumberOfEdges + f;
      ExpectRow(GetRow(mesh, row), expected);
      mesh.Options.Type2 = JointRule::Sharp;
      ExpectRow(GetRow(mesh, row), { { 0, .25 }, { 1, .25 }, { 2, .25 }, { 3, .25 } });
    }
  }
}

TEST(HybridLevel, SurfaceOfQuadsIsCatmullClark)
{
  // The boundary of a cube, as quads alone and around a hexahedron.
  HybridMesh cube = MakeBox(1, 0);
  HybridMesh shell = cube;
  shell.Cells.clear();
  for (const auto& face : GetCellTable(CellShape::Hex).Faces)
  {
    Cell quad{ CellShape::Quad, {} };
    for (const unsigned char corner : face)
    {
      quad.Corners.push_back(cube.Cells[0].Corners[corner]);
    }
    shell.Cells.push_back(quad);
  }
  // Catmull-Clark at three quads: 5/12 itself, 1/6 neighbours, 1/36 opposite ones.
  ExpectRow(GetRow(shell, 0),
    { { 0, 5. / 12. }, { 1, 1. / 6. }, { 2, 1. / 6. }, { 4, 1. / 6. }, { 3, 1. / 36. },
      { 5, 1. / 36. }, { 6, 1. / 36. } });
  const std::vector<double> ofShell = Subdivide(shell, 3);
  const auto all = SortPoints(Subdivide(cube, 3));
  const auto boundary = SortPoints(ofShell);
  for (const auto& point : boundary)
  {
    EXPECT_TRUE(std::any_of(all.begin(), all.end(),
      [&](const auto& other)
      {
        return std::abs(point[0] - other[0]) + std::abs(point[1] - other[1]) +
          std::abs(point[2] - other[2]) <
          1e-13;
      }));
  }
}

TEST(HybridLevel, LinearKeepsVolumes)
{
  const HybridMesh box = MakeBox(2, 7);
  HybridLevel<int> level = MakeLevel<int>(box);
  std::vector<double> points = box.Points;
  const double volume = MeasureHexes(level, points);
  for (int i = 0; i < 2; ++i)
  {
    points = ApplyStep(level, points, 3, HybridRules::Linear);
    level = RefineHybrid(level, HybridRules::Linear);
    EXPECT_NEAR(MeasureHexes(level, points), volume, 1e-12);
  }
}

TEST(HybridLevel, RepeatedSolidsChangeNothing)
{
  HybridMesh box = MakeBox(2, 3);
  const std::vector<double> once = Subdivide(box, 2);
  box.Cells.push_back(box.Cells[2]);
  std::rotate(box.Cells.back().Corners.begin(), box.Cells.back().Corners.begin() + 4,
    box.Cells.back().Corners.end()); // upside down
  ExpectSamePoints(Subdivide(box, 2), once, 1e-13);
}

TEST(HybridLevel, IdsOfBothTypesGiveTheSame)
{
  const HybridMesh box = MakeBox(2, 5);
  EXPECT_EQ(Subdivide<int>(box, 2), Subdivide<long long>(box, 2));
}

/// Tetrahedra, triangles, lines and vertices with their creases and joints: the tet/oct scheme.
class HybridSimplices : public ::testing::TestWithParam<std::string>
{
};

TEST_P(HybridSimplices, EqualTheTetOctScheme)
{
  const coretest::Mesh zoo = coretest::FindInZoo(GetParam());
  const std::vector<Choices> all = MakeChoices();
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    SCOPED_TRACE(i);
    HybridMesh mesh = Take(zoo);
    mesh.Options = all[i];
    auto level = tetoct_tools::BuildTetOct<int>(zoo.Cells, zoo.Singular, all[i].Make());
    std::vector<double> points = zoo.Points;
    for (int step = 1; step <= 2; ++step)
    {
      const auto stencils = tetoct_tools::CopyStencils(level.Level);
      std::vector<double> next(static_cast<std::size_t>(stencils.GetNumberOfRows() * 3));
      stencils.Apply(points.data(), next.data(), 3);
      points = next;
      level = coretest::RefineOnce(level);
      ExpectSamePoints(Subdivide(mesh, step), points, 1e-13);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Zoo, HybridSimplices, ::testing::ValuesIn(coretest::GetNamesOfZoo(20)));
