// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 15: limits of meshes of cells of all types.
#include "Precompiled.h"

#include "HybridTools.h"
#include "HybridZoo.h"
#include "TetOctTools.h"

#include "Core/Cells/CellSigns.h"
#include "Core/Solids/Hybrid/HybridLimits.h"
#include "Core/Solids/Hybrid/HybridTangents.h"
#include "Core/Solids/Limits/LimitNormals.h"
#include "Core/Solids/Limits/LimitStencils.h"

#include <random>

using namespace hybrid_tools;

namespace
{

template <typename Id>
std::map<int, double> GetLimitRow(const SparseRows<Id>& rows, vtkIdType vertex)
{
  std::map<int, double> row;
  for (Id k = rows.Offsets[vertex]; k < rows.Offsets[vertex + 1]; ++k)
  {
    row[static_cast<int>(rows.Columns[k])] += rows.Weights[k];
  }
  return row;
}

std::map<int, double> GetLimitRow(const HybridMesh& mesh, vtkIdType vertex)
{
  const auto level = MakeLevel<int>(mesh);
  return GetLimitRow(MakeLimitOperator(level).Store(), vertex);
}

void ExpectSameRow(
  const std::map<int, double>& row, const std::map<int, double>& expected, double tolerance = 1e-12)
{
  std::map<int, double> difference = row;
  for (const auto& [column, weight] : expected)
  {
    difference[column] -= weight;
  }
  for (const auto& [column, weight] : difference)
  {
    EXPECT_NEAR(weight, 0., tolerance) << "column " << column;
  }
}

template <typename Id>
std::vector<double> FindNormals(
  const LimitTangents<Id>& tangents, const std::vector<double>& points)
{
  std::vector<double> normals(points.size());
  ComputeLimitNormals(tangents, Coordinates(points.data(), 1e-9), {}, {}, normals.data());
  return normals;
}

/// The rows of stars without their order. Normals themselves may be sums that nearly cancel.
void ExpectSameStars(const ShadingStars<int>& stars, const ShadingStars<int>& expected)
{
  ASSERT_EQ(stars.Stars.size(), expected.Stars.size());
  for (std::size_t i = 0; i + 1 < stars.Stars.size(); ++i)
  {
    const auto& star = stars.Stars[i];
    const auto& other = expected.Stars[i];
    SCOPED_TRACE(star.Row);
    ASSERT_EQ(star.Row, other.Row);
    ASSERT_EQ(stars.Stars[i + 1].FirstRow, expected.Stars[i + 1].FirstRow);
    ASSERT_EQ(stars.Stars[i + 1].FirstCorner, expected.Stars[i + 1].FirstCorner);
    ASSERT_EQ(stars.Stars[i + 1].FirstLine, expected.Stars[i + 1].FirstLine);
    for (vtkIdType r = star.FirstRow; r < stars.Stars[i + 1].FirstRow; ++r)
    {
      double least = 1.;
      for (vtkIdType o = other.FirstRow; o < expected.Stars[i + 1].FirstRow; ++o)
      {
        std::map<int, double> difference = GetLimitRow(stars.Rows, r);
        double size = 0.;
        for (const auto& [column, weight] : GetLimitRow(expected.Rows, o))
        {
          difference[column] -= weight;
          size = std::max(size, std::abs(weight));
        }
        double most = 0.;
        for (const auto& entry : difference)
        {
          most = std::max(most, std::abs(entry.second));
        }
        least = std::min(least, most / size);
      }
      EXPECT_LT(least, 1e-9) << "row " << r;
    }
  }
}

/// The control cells of the cells of a level, when they were given to the children so often.
std::vector<vtkIdType> FindControls(const HybridLevel<int>& control, int steps)
{
  std::vector<vtkIdType> controls(
    static_cast<std::size_t>(control.Complex.Cells.GetNumberOfCells()));
  std::iota(controls.begin(), controls.end(), vtkIdType(0));
  std::vector<CellShape> shapes(
    control.Complex.Cells.Shapes.begin(), control.Complex.Cells.Shapes.end());
  for (int step = 0; step < steps; ++step)
  {
    std::vector<vtkIdType> next;
    std::vector<CellShape> nextShapes;
    for (std::size_t c = 0; c < controls.size(); ++c)
    {
      for (const CellChild& child : GetCellTable(shapes[c]).Children)
      {
        next.push_back(controls[c]);
        nextShapes.push_back(child.Shape);
      }
    }
    controls = next;
    shapes = nextShapes;
  }
  return controls;
}

/// Gives all tetrahedra a positive volume, so that they agree on where the outside is.
void Orient(coretest::Mesh& mesh)
{
  vtkIdType first = 0;
  for (const int dimension : mesh.Cells.Dimensions)
  {
    SolidPlaces x{};
    vtkIdType* corners = mesh.Cells.Connectivity.data() + first;
    for (int i = 0; i <= dimension; ++i)
    {
      std::copy_n(mesh.Points.data() + 3 * corners[i], 3, x[i].begin());
    }
    if (dimension == 3 && FindOrientation(CellShape::Tet, x, 0.) < 0)
    {
      std::swap(corners[2], corners[3]);
    }
    first += dimension + 1;
  }
}

std::vector<double> FindLimits(const HybridLevel<int>& level, const std::vector<double>& points)
{
  std::vector<double> limits(points.size());
  MakeLimitOperator(level).Apply(points.data(), limits.data(), 3);
  return limits;
}

}

TEST(HybridLimits, EqualThePowersOfTheReference)
{
  for (unsigned int seed = 0; seed < 32; ++seed)
  {
    SCOPED_TRACE(seed);
    const hybridtest::Mesh mesh = hybridtest::MakeRandomHybrid(seed);
    if (mesh.Cells.size() > 20)
    {
      continue;
    }
    const auto level = MakeLevel<int>(Take(mesh));
    const SparseRows<int> rows = MakeLimitOperator(level).Store();
    ASSERT_EQ(rows.GetNumberOfRows(), static_cast<vtkIdType>(mesh.Points.size()));
    for (int v = 0; v < static_cast<int>(mesh.Points.size()); ++v)
    {
      SCOPED_TRACE(v);
      ExpectSameRow(GetLimitRow(rows, v), hybridtest::LimitRow(mesh, v));
    }
  }
}

/// The limits of old vertices stay the same from level to level, also on levels whose rules are
/// inherited, and limits are means.
TEST(HybridLimits, AStepDoesNotMoveThem)
{
  for (unsigned int seed = 0; seed < 60; ++seed)
  {
    SCOPED_TRACE(seed);
    const hybridtest::Mesh mesh = hybridtest::MakeRandomHybrid(seed);
    const HybridMesh taken = Take(mesh);
    auto level = MakeLevel<int>(taken);
    std::vector<double> points = taken.Points;
    std::vector<double> limits = FindLimits(level, points);
    const int levels = mesh.Cells.size() < 20 ? 3 : 2;
    for (int i = 1; i <= levels; ++i)
    {
      points = ApplyStep(level, points);
      level = RefineHybrid(level, HybridRules::Smooth);
      const SparseRows<int> rows = MakeLimitOperator(level).Store();
      for (vtkIdType v = 0; v < rows.GetNumberOfRows(); ++v)
      {
        double sum = 0.;
        for (const auto& entry : GetLimitRow(rows, v))
        {
          EXPECT_GE(entry.second, 0.);
          sum += entry.second;
        }
        EXPECT_NEAR(sum, 1., 1e-13);
      }
      const std::vector<double> now = FindLimits(level, points);
      for (std::size_t k = 0; k < limits.size(); ++k)
      {
        EXPECT_NEAR(now[k], limits[k], 1e-12) << "level " << i << ", point " << k / 3;
      }
      limits = now;
    }
  }
}

/// The same where edges and faces stay sharp for some steps: after three of them none is.
TEST(HybridLimits, OfWhatIsStillSharp)
{
  double moved = 0.;
  for (unsigned int seed = 0; seed < 40; ++seed)
  {
    SCOPED_TRACE(seed);
    const hybridtest::Mesh drawn = hybridtest::MakeRandomHybrid(seed);
    if (drawn.Cells.size() > 20)
    {
      continue;
    }
    HybridMesh mesh = Take(drawn);
    mesh.Options.ModifiedBoundary = seed % 2 == 0;
    const std::vector<double> smooth = FindLimits(MakeLevel<int>(mesh), mesh.Points);
    AddSharpness(seed, mesh);
    auto level = MakeLevel<int>(mesh);
    std::vector<double> points = mesh.Points;
    std::vector<double> limits = FindLimits(level, points);
    const std::vector<double> normals =
      FindNormals(BuildHybridTangents(level, FindControls(level, 0), 0), points);
    const auto control = MakeLevel<int>(mesh);
    for (int step = 1; step <= 3; ++step)
    {
      points = ApplyStep(level, points);
      level = RefineHybrid(level, HybridRules::Smooth);
      const std::vector<double> later = FindLimits(level, points);
      const std::vector<double> laterNormals =
        FindNormals(BuildHybridTangents(level, FindControls(control, step), step), points);
      for (std::size_t k = 0; k < limits.size(); ++k)
      {
        ASSERT_NEAR(limits[k], later[k], 1e-12) << "step " << step << ", point " << k / 3;
      }
      for (std::size_t k = 0; k < normals.size(); ++k)
      {
        ASSERT_NEAR(normals[k], laterNormals[k], 1e-6) << "step " << step << ", point " << k / 3;
      }
      limits = later;
    }
    EXPECT_TRUE(level.Sharpness.Stages.empty());
    for (std::size_t k = 0; k < smooth.size(); ++k)
    {
      moved = std::max(moved, std::abs(smooth[k] - limits[k]));
    }
  }
  EXPECT_GT(moved, .01);
}

/// Limit values that occur in columns: those of surfaces times 1/6, 4/6, 1/6.
TEST(HybridLimits, OfColumns)
{
  for (const int n : { 3, 4, 5, 6, 7, 9 })
  {
    for (const CellShape shape : { CellShape::Hex, CellShape::Wedge })
    {
      SCOPED_TRACE(n);
      const HybridMesh column = MakeColumn(shape, n);
      const bool isHex = shape == CellShape::Hex;
      const double own = isHex ? n / (n + 5.) : n == 3 ? 2. / 5. : 1. / 2.;
      const double near = isHex ? 4. / (n * (n + 5.)) : (1. - own) / n;
      const double far = 1. / (n * (n + 5.));
      for (const auto& [vertex, weight] : GetLimitRow(column, 1))
      {
        const double* at = column.Points.data() + 3 * vertex;
        const double along = std::abs(at[2] - column.Points[5]) < .5 ? 4. / 6. : 1. / 6.;
        const double out = std::hypot(at[0] - column.Points[3], at[1] - column.Points[4]);
        bool isNear = false;
        for (const Cell& cell : column.Cells)
        {
          // A neighbour across the axis shares an edge with a vertex of it.
          for (std::size_t e = 0; e < GetCellTable(shape).Edges.size(); ++e)
          {
            const auto& ends = GetCellTable(shape).Edges[e];
            isNear = isNear ||
              (std::max(cell.Corners[ends[0]], cell.Corners[ends[1]]) == vertex &&
                std::min(cell.Corners[ends[0]], cell.Corners[ends[1]]) < 3);
          }
        }
        EXPECT_NEAR(weight, along * (out < 1e-9 ? own : isNear ? near : far), 1e-13) << vertex;
      }
    }
  }
}

TEST(HybridLimits, OfLattices)
{
  const HybridMesh box = MakeBox(2, 0);
  const std::map<int, double> row = GetLimitRow(box, 13);
  EXPECT_EQ(row.size(), 27u);
  for (const auto& [i, weight] : row)
  {
    const double at[3] = { i % 3 == 1 ? 4. : 1., i / 3 % 3 == 1 ? 4. : 1., i / 9 == 1 ? 4. : 1. };
    EXPECT_NEAR(weight, at[0] * at[1] * at[2] / 216., 1e-15);
  }
  ExpectSameRow(GetLimitRow(MakeBox(1, 0), 0),
    { { 0, 3. / 8. }, { 1, 1. / 6. }, { 2, 1. / 6. }, { 4, 1. / 6. }, { 3, 1. / 24. },
      { 5, 1. / 24. }, { 6, 1. / 24. } },
    1e-15);
}

/// A tetrahedron as four hexahedra, and a cube as six pyramids, around a point.
TEST(HybridLimits, AroundPoints)
{
  HybridMesh four;
  std::map<std::set<int>, vtkIdType> numbers; // of the middle of some corners
  for (int bits = 1; bits < 16; ++bits)
  {
    std::set<int> corners;
    double sum[3] = { 0., 0., 0. };
    for (int i = 0; i < 4; ++i)
    {
      if (bits >> i & 1)
      {
        corners.insert(i);
        i > 0 ? sum[i - 1] += 1. : 0.;
      }
    }
    const double size = static_cast<double>(corners.size());
    numbers[corners] = four.GetNumberOfPoints();
    four.AddPoint(sum[0] / size, sum[1] / size, sum[2] / size);
  }
  for (int i = 0; i < 4; ++i)
  {
    const int a = (i + 1) % 4;
    const int b = (i + 2) % 4;
    const int c = (i + 3) % 4;
    four.Cells.push_back({ CellShape::Hex,
      { numbers[{ i }], numbers[{ i, a }], numbers[{ i, a, b }], numbers[{ i, b }],
        numbers[{ i, c }], numbers[{ i, a, c }], numbers[{ 0, 1, 2, 3 }], numbers[{ i, b, c }] } });
  }
  std::map<int, double> expected;
  for (const auto& [corners, number] : numbers)
  {
    expected[static_cast<int>(number)] = corners.size() == 4 ? .25325885
      : corners.size() == 3                                  ? .10998603
      : corners.size() == 2                                  ? .04376164
                                                             : .01105680;
  }
  ExpectSameRow(GetLimitRow(four, numbers[{ 0, 1, 2, 3 }]), expected, 1e-8);
  std::map<int, double> ofPyramids{ { 8, .32559759 } };
  for (int i = 0; i < 8; ++i)
  {
    ofPyramids[i] = .08430030;
  }
  ExpectSameRow(GetLimitRow(Take(hybridtest::MakeSixPyramids()), 8), ofPyramids, 1e-8);
}

/// Two hexahedra share two opposite corners of quads and no edge between: solved a step later.
TEST(HybridLimits, WhereCellsShareCornersWithoutAnEdge)
{
  HybridMesh mesh = MakeBox(1, 0);
  for (int i = 0; i < 6; ++i)
  {
    mesh.AddPoint(2. + i % 2, i / 2, -1.);
  }
  mesh.Cells.push_back({ CellShape::Hex, { 0, 8, 3, 9, 10, 11, 12, 13 } });
  const auto level = MakeLevel<int>(mesh);
  const std::vector<double> limits = FindLimits(level, mesh.Points);
  const std::vector<double> next = ApplyStep(level, mesh.Points);
  const std::vector<double> later = FindLimits(RefineHybrid(level, HybridRules::Smooth), next);
  for (std::size_t k = 0; k < limits.size(); ++k)
  {
    EXPECT_NEAR(limits[k], later[k], 1e-12) << "point " << k / 3;
  }
}

/// Cells of any types between few points: they share corners without edges, quads cross, and many
/// lie at one face. Limits and normals are finite, and a step moves no limit.
TEST(HybridLimits, OfCellsWithoutOrder)
{
  std::mt19937 random(11);
  const auto draw = [&random](int size)
  { return static_cast<int>(random() % static_cast<unsigned int>(size)); };
  for (int round = 0; round < 150; ++round)
  {
    SCOPED_TRACE(round);
    HybridMesh mesh;
    const int size = 9 + draw(8);
    for (int i = 0; i < size; ++i)
    {
      mesh.AddPoint(draw(1000) / 500., draw(1000) / 500., draw(1000) / 500.);
    }
    std::vector<vtkIdType> numbers(static_cast<std::size_t>(size));
    std::iota(numbers.begin(), numbers.end(), vtkIdType(0));
    for (int c = 2 + draw(5); c > 0; --c)
    {
      const auto shape = static_cast<CellShape>(draw(NumberOfShapes));
      std::shuffle(numbers.begin(), numbers.end(), random);
      mesh.Cells.push_back(
        { shape, { numbers.begin(), numbers.begin() + GetCellTable(shape).Corners } });
    }
    for (int s = draw(4); s > 0; --s)
    {
      mesh.Singular.insert(coretest::Sorted(
        coretest::Tuple{ mesh.Cells[0].Corners.front(), mesh.Cells[0].Corners.back() }));
    }
    mesh.Options.ModifiedBoundary = draw(3) == 0;
    mesh.Options.DartEnds = draw(2) == 0;
    mesh.Options.Type1 = static_cast<JointRule>(draw(5));
    mesh.Options.Type2 = draw(2) == 0 ? JointRule::Sharp : JointRule::Blend;
    const auto level = MakeLevel<int>(mesh);
    const std::vector<double> limits = FindLimits(level, mesh.Points);
    const std::vector<double> points = ApplyStep(level, mesh.Points);
    const auto next = RefineHybrid(level, HybridRules::Smooth);
    const std::vector<double> later = FindLimits(next, points);
    for (std::size_t k = 0; k < limits.size(); ++k)
    {
      EXPECT_NEAR(limits[k], later[k], 1e-11) << "point " << k / 3;
    }
    for (const double x :
      FindNormals(BuildHybridTangents(level, FindControls(level, 0), 0), mesh.Points))
    {
      EXPECT_TRUE(std::isfinite(x));
    }
    for (const double x : FindNormals(BuildHybridTangents(next, FindControls(level, 1), 1), points))
    {
      EXPECT_TRUE(std::isfinite(x));
    }
  }
}

TEST(HybridLimits, IdsOfBothTypesGiveTheSame)
{
  const HybridMesh mesh = Take(hybridtest::MakeRandomHybrid(7));
  std::vector<double> limits[2] = { mesh.Points, mesh.Points };
  const auto small = MakeLevel<int>(mesh);
  const auto large = MakeLevel<long long>(mesh);
  MakeLimitOperator(small).Apply(mesh.Points.data(), limits[0].data(), 3);
  MakeLimitOperator(large).Apply(mesh.Points.data(), limits[1].data(), 3);
  EXPECT_EQ(limits[0], limits[1]);
}

/// Normals of meshes of all types, with creases and joints, are the same on all levels.
TEST(HybridLimits, AStepDoesNotTurnNormals)
{
  for (unsigned int seed = 0; seed < 40; ++seed)
  {
    SCOPED_TRACE(seed);
    const HybridMesh mesh = Take(hybridtest::MakeRandomHybrid(seed));
    const auto control = MakeLevel<int>(mesh);
    const std::vector<double> normals =
      FindNormals(BuildHybridTangents(control, FindControls(control, 0), 0), mesh.Points);
    const auto level = RefineHybrid(control, HybridRules::Smooth);
    const std::vector<double> later = FindNormals(
      BuildHybridTangents(level, FindControls(control, 1), 1), ApplyStep(control, mesh.Points));
    for (std::size_t k = 0; k < normals.size(); ++k)
    {
      EXPECT_NEAR(normals[k], later[k], 1e-6) << "point " << k / 3;
    }
  }
}

/// Tangents of fans of one type by powers of their matrix are those of the closed forms.
TEST(HybridLimits, TangentsAreLeftEigenvectors)
{
  for (const Neighbourhood& key :
    std::vector<Neighbourhood>{ { 3, 3, 3, 1 }, { 3, 3, 3, 3, 3, 1 }, { 4, 4, 4, 1 },
      { 4, 4, 4, 4, 4, 4, 4, 1 }, { 3, 4, 3, 4, 4, 1 }, { 3, 3, 4, 1 }, { 3, 3, 3, 3, 0 }, { 3, 0 },
      { 4, 0 }, { 4, 4, 4, 0 }, { 4, 4, 0 }, { 3, 4, 0 }, { 4, 3, 3, 0 }, { 3, 4, 4, 0 } })
  {
    const FanTangents tangents = FindFanTangents(key, LoopWeights::Warren, false);
    const LocalRows rows = MakeFanRows(key, LoopWeights::Warren);
    const std::vector<double> matrix = rows.Fill();
    const std::size_t size = rows.GetNumberOfItems();
    SCOPED_TRACE(::testing::PrintToString(key));
    ASSERT_EQ(tangents.First.size(), size);
    double values[2] = { 0., 0. };
    for (int i = 0; i < 2; ++i)
    {
      const std::vector<double>& w = i == 0 ? tangents.First : tangents.Second;
      std::vector<double> image(size, 0.);
      double most = 0.;
      for (std::size_t k = 0; k < size * size; ++k)
      {
        image[k % size] += w[k / size] * matrix[k];
      }
      const auto largest =
        static_cast<std::size_t>(std::max_element(w.begin(), w.end(),
                                   [](double a, double b) { return std::abs(a) < std::abs(b); }) -
          w.begin());
      values[i] = image[largest] / w[largest];
      for (std::size_t k = 0; k < size; ++k)
      {
        most = std::max(most, std::abs(image[k] - values[i] * w[k]));
      }
      EXPECT_LT(most, 1e-10) << "tangent " << i;
    }
    EXPECT_TRUE(key.back() == 1 || std::abs(values[0] - .5) < 1e-12);
    EXPECT_GT(values[1], .2);
  }
}

/// Tetrahedra, triangles, lines and vertices with their creases and joints: the tet/oct scheme.
class HybridSimplexLimits : public ::testing::TestWithParam<std::string>
{
};

TEST_P(HybridSimplexLimits, EqualTheTetOctScheme)
{
  const coretest::Mesh zoo = coretest::FindInZoo(GetParam());
  const std::vector<Choices> all = MakeChoices();
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    SCOPED_TRACE(i);
    HybridMesh mesh = Take(zoo);
    mesh.Options = all[i];
    const auto built = tetoct_tools::BuildTetOct<int>(zoo.Cells, zoo.Singular, all[i].Make());
    const SparseRows<int> expected = BuildLimitRows(built.Level);
    const auto level = MakeLevel<int>(mesh);
    const SparseRows<int> rows = MakeLimitOperator(level).Store();
    ASSERT_EQ(rows.GetNumberOfRows(), expected.GetNumberOfRows());
    for (vtkIdType v = 0; v < rows.GetNumberOfRows(); ++v)
    {
      SCOPED_TRACE(v);
      ExpectSameRow(GetLimitRow(rows, v), GetLimitRow(expected, v));
    }
  }
}

/// Also where there is no tangent plane.
TEST_P(HybridSimplexLimits, HaveTheNormalsOfTheTetOctScheme)
{
  coretest::Mesh zoo = coretest::FindInZoo(GetParam());
  Orient(zoo);
  std::vector<Choices> all(3);
  all[1].Type1 = all[1].Type2 = all[1].Type3 = JointRule::Sharp;
  all[1].DartEnds = true;
  all[2].ModifiedBoundary = true;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    SCOPED_TRACE(i);
    HybridMesh mesh = Take(zoo);
    mesh.Options = all[i];
    const auto built = tetoct_tools::BuildTetOct<int>(zoo.Cells, zoo.Singular, all[i].Make());
    const auto expected = BuildLimitTangents(built.Level);
    const auto level = MakeLevel<int>(mesh);
    const auto tangents = BuildHybridTangents(level, FindControls(level, 0), 0);
    std::vector<double> normals[2] = { mesh.Points, mesh.Points };
    const Coordinates points(mesh.Points.data(), 1e-9);
    ComputeSectorNormals(
      expected, points, {}, FindTriangleSides(built.Level).ListTurned(), normals[0].data());
    ComputeSectorNormals(
      tangents, points, {}, FindPolygonSides(level).ListTurned(), normals[1].data());
    for (std::size_t v = 0; v < normals[0].size() / 3; ++v)
    {
      // Where solids overlap, as many of them may lie on either side: then the side is any.
      int sides = 0;
      for (int s = tangents.Sectors.Offsets[v]; s < tangents.Sectors.Offsets[v + 1]; ++s)
      {
        for (vtkIdType k = tangents.SideOffsets[s]; k < tangents.SideOffsets[s + 1]; ++k)
        {
          sides += tangents.Sides[k] % 2 == 0 ? 1 : -1;
        }
      }
      const double* a = normals[0].data() + 3 * v;
      const double* b = normals[1].data() + 3 * v;
      const bool isTurned = sides == 0 && a[0] * b[0] + a[1] * b[1] + a[2] * b[2] < 0. &&
        tangents.Sectors.Offsets[v] < tangents.Sectors.Offsets[v + 1] &&
        tangents.Triangles[tangents.Sectors.Offsets[v]] < 0;
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(a[c], isTurned ? -b[c] : b[c], 1e-8) << "point " << v;
      }
    }
    ExpectSameStars(tangents.Shading, expected.Shading);
  }
}

INSTANTIATE_TEST_SUITE_P(
  Zoo, HybridSimplexLimits, ::testing::ValuesIn(coretest::GetNamesOfZoo(20)));
