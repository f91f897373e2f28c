// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestTetOctFilter.cxx
 * VolumeScheme = TetOct (Mathematics 10) through the filter: octahedra in the output, arrays,
 * features, threads.
 */
#include "TetOctFilterTools.h"

using namespace tet_oct_filter_tools;

namespace
{

double GetLength(vtkUnstructuredGrid* grid, vtkIdType a, vtkIdType b)
{
  const Point p = GetPoint(grid, a);
  const Point q = GetPoint(grid, b);
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

/// The points of a mesh in an order of their own; no two are within 1e-9.
std::vector<Point> GetPositions(vtkUnstructuredGrid* grid)
{
  std::vector<Point> points;
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    Point p = GetPoint(grid, i);
    for (double& x : p)
    {
      x = std::round(x * 1e9) / 1e9 + 0.;
    }
    points.push_back(p);
  }
  std::sort(points.begin(), points.end());
  return points;
}

/// Whether two such lists are equal up to rounding.
bool AreSamePositions(const std::vector<Point>& a, const std::vector<Point>& b)
{
  auto isNear = [](const Point& p, const Point& q)
  {
    return std::equal(
      p.begin(), p.end(), q.begin(), [](double x, double y) { return std::abs(x - y) < 3e-9; });
  };
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), isNear);
}

}

TEST(TetOctFilter, OctahedraAreFourTetrahedraAroundTheShortestDiagonal)
{
  const Grid input = MakeKuhnBox(2, 0.3);
  for (int run = 0; run < 6; ++run)
  {
    const int levels = 1 + run / 2;
    const Grid output = Execute(
      input, levels, TetOct([run](Filter* filter) { filter->SetProjectToLimit(run % 2 == 1); }));
    const Ids octahedra = GetOctahedra(output);
    const std::vector<Ids> cells = GetCells(output);
    const vtkIdType perTet[4] = { 0, 1, 10, 84 };
    vtkIdType found = 0;
    ASSERT_EQ(output->GetNumberOfCells(), 48 << (3 * levels));
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      ASSERT_GT(GetSignedVolume(output, cells[i]), 0.);
      if (octahedra[i] < 0)
      {
        continue;
      }
      ASSERT_EQ(octahedra[i], found++); // numbered in order
      const Ids first = cells[i];
      const vtkIdType low = first[0];
      const vtkIdType high = first[2];
      Ids equator;
      for (int k = 0; k < 4; ++k) // consecutive, (a', r, a, q)
      {
        ASSERT_EQ(octahedra[i + k], octahedra[i]);
        ASSERT_EQ(cells[i + k][0], low);
        ASSERT_EQ(cells[i + k][2], high);
        ASSERT_EQ(cells[i + k][1], cells[i + (k + 1) % 4][3]);
        equator.push_back(cells[i + k][1]);
      }
      ASSERT_EQ((std::set<vtkIdType>(equator.begin(), equator.end()).size()), 4u);
      const double length = GetLength(output, low, high) * (1. - 1e-9);
      ASSERT_LE(length, GetLength(output, equator[0], equator[2]));
      ASSERT_LE(length, GetLength(output, equator[1], equator[3]));
      i += 3;
    }
    EXPECT_EQ(found, 48 * perTet[levels]);
  }
}

TEST(TetOctFilter, BoundariesAndCreasesAreAsEver)
{
  // A box with its boundary triangles and all edges of these, of which some are creases.
  const Grid box = MakeKuhnBox(2, 0.3);
  std::map<Ids, int> faces;
  std::vector<Cell> cells;
  for (const Ids& tet : GetCells(box))
  {
    cells.push_back({ VTK_TETRA, tet });
    for (int i = 0; i < 4; ++i)
    {
      Ids face = tet;
      face.erase(face.begin() + i);
      std::sort(face.begin(), face.end());
      ++faces[face];
    }
  }
  std::vector<int> flags(cells.size(), 0);
  for (const auto& face : faces)
  {
    const Ids& f = face.first;
    if (face.second == 1)
    {
      cells.push_back({ VTK_TRIANGLE, { f[1], f[0], f[2] } });
      cells.push_back({ VTK_LINE, { f[0], f[1] } });
      flags.insert(flags.end(), { 0, f[0] + f[1] < 9 ? 1 : 0 });
    }
  }
  std::vector<Point> points;
  for (vtkIdType i = 0; i < box->GetNumberOfPoints(); ++i)
  {
    points.push_back(GetPoint(box, i));
  }
  const Grid input = With(MakeGrid(points, cells), "Singular", flags);
  vtkNew<Messages> same; // an edge flagged once and not flagged once more: not the question here
  for (int levels = 1; levels <= 3; ++levels)
  {
    const Grid solids = Execute(input, levels, TetOct(), same);
    const Grid expected = Execute(input, levels, {}, same);
    ASSERT_EQ(solids->GetNumberOfCells(), expected->GetNumberOfCells());
    const Ids octahedra = GetOctahedra(solids);
    for (vtkIdType i = 0; i < solids->GetNumberOfCells(); ++i)
    {
      ASSERT_EQ(solids->GetCellType(i), expected->GetCellType(i));
      if (solids->GetCellType(i) == VTK_TETRA)
      {
        continue;
      }
      ASSERT_EQ(octahedra[i], -1);
      const Ids a = GetCell(solids, i);
      const Ids b = GetCell(expected, i);
      for (std::size_t k = 0; k < a.size(); ++k) // bit for bit
      {
        ASSERT_EQ(GetPoint(solids, a[k]), GetPoint(expected, b[k]));
      }
    }
  }
}

TEST(TetOctFilter, CellDataAreAsEver)
{
  const Grid input = MakeMixedBox(2);
  AddArrays(input);
  const Grid solids = Execute(input, 2, TetOct());
  const Grid expected = Execute(input, 2);
  for (vtkIdType i = 0; i < solids->GetNumberOfCells(); ++i)
  {
    ASSERT_EQ(solids->GetCellType(i), expected->GetCellType(i));
  }
  ASSERT_TRUE(solids->GetCellData()->GetArray("OctahedronId"));
  solids->GetCellData()->RemoveArray("OctahedronId");
  EXPECT_EQ(CompareArrays(solids->GetCellData(), expected->GetCellData(), ""), "");
}

/// Without a cache the last operator is not stored, and cells are written where points are known.
TEST(TetOctFilter, WhatIsNotKeptChangesNothing)
{
  for (unsigned seed = 1; seed <= 40; ++seed)
  {
    SCOPED_TRACE(seed);
    vtkNew<Messages> ignored;
    const Configure options = RandomOptions(seed);
    const Grid grid = MakeRandomComplex(seed);
    for (int levels = 0; levels <= 3; ++levels)
    {
      const auto execute = [&](bool cache)
      {
        return Execute(grid, levels,
          TetOct(
            [&](Filter* filter)
            {
              options(filter);
              filter->SetCacheOperator(cache);
            }),
          ignored);
      };
      EXPECT_EQ(Compare(execute(true), execute(false)), "") << levels;
    }
  }
}

TEST(TetOctFilter, RowsOfAVertexInside)
{
  // Eight tetrahedra, at each edge four: 15/32 and 8 * 3 * 17/96 in six equal parts, over 8.
  const Matrix matrix(MakeOctahedron(), TetOct());
  MatrixRow expected = { { 0, 15. / 32 } };
  for (vtkIdType i = 1; i <= 6; ++i)
  {
    expected[i] = 17. / 192;
  }
  for (const auto& entry : matrix.Vertex(0))
  {
    EXPECT_NEAR(entry.second, expected[entry.first], 1e-15);
  }
  EXPECT_EQ(matrix.Vertex(0).size(), 7u);
}

TEST(TetOctFilter, OrderOfVerticesAndCellsDoesNotMatter)
{
  const Grid grid = MakeKuhnBox(2, 0.3);
  const auto expected = GetPositions(Execute(grid, 2, TetOct()));
  std::mt19937 random(5);
  for (int attempt = 0; attempt < 5; ++attempt)
  {
    std::vector<Ids> tets = GetCells(grid);
    std::shuffle(tets.begin(), tets.end(), random);
    std::vector<Cell> cells;
    for (Ids& tet : tets)
    {
      std::shuffle(tet.begin(), tet.end(), random);
      cells.push_back({ VTK_TETRA, tet });
    }
    std::vector<Point> points;
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    {
      points.push_back(GetPoint(grid, i));
    }
    const auto actual = GetPositions(Execute(MakeGrid(points, cells), 2, TetOct()));
    EXPECT_TRUE(AreSamePositions(actual, expected));
  }
}

TEST(TetOctFilter, ThereIsNoPreferredDirection)
{
  // A regular tetrahedron with other names for its points: a box spline has to choose one of three
  // equal diagonals, by ids, and stretches along it.
  const std::vector<Point> corners = { { 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 } };
  std::vector<vtkIdType> order = { 0, 1, 2, 3 };
  const Grid grid = MakeGrid(corners, { { VTK_TETRA, order } });
  constexpr int levels = 3; // less have but one point inside, in the middle
  const auto tetOct = GetPositions(Execute(grid, levels, TetOct()));
  const auto boxSpline = GetPositions(Execute(grid, levels));
  int others = 0;
  do
  {
    std::vector<Point> points;
    for (vtkIdType i : order)
    {
      points.push_back(corners[i]);
    }
    const Grid renamed = MakeGrid(points, { { VTK_TETRA, { 0, 1, 2, 3 } } });
    EXPECT_TRUE(AreSamePositions(GetPositions(Execute(renamed, levels, TetOct())), tetOct));
    others += AreSamePositions(GetPositions(Execute(renamed, levels)), boxSpline) ? 0 : 1;
  } while (std::next_permutation(order.begin(), order.end()));
  EXPECT_EQ(others, 16); // two of three diagonals, eight orders each
}

TEST(TetOctFilter, LabelsComeFromTheSmallestGlobalId)
{
  const Grid grid = MakeOneTet();
  AddCellArray(grid, "cell", { 7 });
  vtkNew<vtkIntArray> labels;
  labels->SetName("label");
  for (int label : { 10, 11, 12, 13 })
  {
    labels->InsertNextValue(label);
  }
  grid->GetPointData()->AddArray(labels);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("GlobalIds");
  for (vtkIdType id : { 4, 1, 3, 2 })
  {
    ids->InsertNextValue(id);
  }
  grid->GetPointData()->SetGlobalIds(ids);
  const Grid output = Execute(grid, 2, TetOct());
  ASSERT_EQ(output->GetNumberOfPoints(), 35);
  vtkDataArray* out = output->GetPointData()->GetArray("label");
  // The last point is the centre of the only octahedron: of the midpoints 4 to 9 the smallest is 4,
  // between 0 and 1, and has the value of 1, whose global id is the smaller one.
  EXPECT_EQ(out->GetComponent(34, 0), 11);
  EXPECT_EQ(out->GetComponent(4, 0), 11);
  EXPECT_EQ(out->GetComponent(9, 0), 13); // between 2 and 3
}

TEST(TetOctFilter, ChildrenTakeTheValuesOfTheirPiece)
{
  const Grid one = Execute(MakeOneTet(), 1, TetOct());
  AddCellArray(one, "piece", { 0, 1, 2, 3, 4, 5, 6, 7 });
  const Grid two = Execute(one, 1, TetOct());
  ASSERT_EQ(two->GetNumberOfCells(), 64);
  vtkDataArray* pieces = two->GetCellData()->GetArray("piece");
  const Ids octahedra = GetOctahedra(two);
  std::array<int, 8> tets = {};
  std::map<vtkIdType, std::set<int>> ofOctahedron;
  for (vtkIdType i = 0; i < 64; ++i)
  {
    const int piece = static_cast<int>(pieces->GetComponent(i, 0));
    if (i < 32) // a tetrahedron's children follow each other
    {
      EXPECT_EQ(piece, i / 8);
      continue;
    }
    if (octahedra[i] < 0)
    {
      ++tets[piece];
      continue;
    }
    ofOctahedron[octahedra[i]].insert(piece);
    // The old vertex of the octahedron, one of 4 to 9, is one of the piece's, and of none before.
    for (vtkIdType point : GetCell(two, i))
    {
      for (int before = 4; point >= 4 && point < 10 && before <= piece; ++before)
      {
        const Ids cell = GetCell(one, before);
        EXPECT_EQ(std::count(cell.begin(), cell.end(), point), before == piece ? 1 : 0);
      }
    }
  }
  EXPECT_EQ(tets, (std::array<int, 8>{ 0, 0, 0, 0, 2, 2, 2, 2 })); // those beside two faces each
  EXPECT_EQ(ofOctahedron.size(), 6u);
  for (const auto& entry : ofOctahedron)
  {
    EXPECT_EQ(entry.second.size(), 1u);
  }
}

TEST(TetOctFilter, EqualTetrahedraKeepTheirOwnOrientation)
{
  const Grid grid =
    MakeGrid({ { 0, 0, 0 }, { 1, 0.1, 0 }, { 0.2, 1.3, 0 }, { 0.1, 0.2, 1.1 }, { 1, 1.2, 1.3 } },
      { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 2, 1, 0, 3 } }, { VTK_TETRA, { 1, 2, 3, 4 } },
        { VTK_TETRA, { 1, 2, 0, 3 } } });
  const Grid output = Execute(grid, 3, TetOct());
  ASSERT_EQ(output->GetNumberOfCells(), 4 * 512);
  const Ids octahedra = GetOctahedra(output);
  EXPECT_EQ(*std::max_element(octahedra.begin(), octahedra.end()), 4 * 84 - 1);
  const double sign[4] = { 1., -1., 1., 1. };
  std::set<Ids> cells[4];
  for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
  {
    Ids cell = GetCell(output, i);
    EXPECT_GT(sign[i / 512] * GetSignedVolume(output, cell), 0.);
    std::sort(cell.begin(), cell.end());
    cells[i / 512].insert(cell);
  }
  EXPECT_EQ(cells[0].size(), 512u);
  EXPECT_EQ(cells[0], cells[1]);
  EXPECT_EQ(cells[0], cells[3]);
  ExpectChains(grid, {});
}

TEST(TetOctFilter, ThreadsAndNarrowIdsChangeNothing)
{
  const Grid grid = MakeKuhnBox(3, 0.2);
  AddArrays(grid);
  vtkSMPTools::Initialize(1);
  const Grid one = Execute(grid, 3, TetOct());
  for (bool cache : { true, false })
  {
    auto execute = [&](int threads, bool narrow)
    {
      vtkSMPTools::Initialize(threads);
      return Execute(grid, 3,
        TetOct(
          [=](Filter* filter)
          {
            filter->SetCacheOperator(cache);
            filter->SetUse32BitIds(narrow);
          }));
    };
    EXPECT_EQ(Compare(one, execute(1, false)), "");
    EXPECT_EQ(Compare(one, execute(4, false)), "");
    const Grid narrow = execute(4, true);
    EXPECT_FALSE(narrow->GetCells()->IsStorage64Bit());
    EXPECT_EQ(Compare(one, narrow), "");
  }
  vtkSMPTools::Initialize();
}

TEST(TetOctFilter, CellsOfWrongSizesAndFlatOnesDoNotBreakIt)
{
  // Inverted, flat, all in one point, huge.
  for (double scale : { 0., 1e-300, 1e150, 1e300 })
  {
    const Grid grid = MakeGrid(
      { { 0, 0, 0 }, { scale, 0, 0 }, { 0, scale, 0 }, { 0, 0, -scale }, { scale, scale, 0 } },
      { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 0, 1, 2, 4 } } });
    const Grid output = Execute(grid, 2, TetOct());
    ASSERT_EQ(output->GetNumberOfCells(), 128);
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      for (double x : GetPoint(output, i))
      {
        ASSERT_TRUE(std::isfinite(x));
      }
    }
  }
}

TEST(TetOctFilter, ClassificationKnowsCentres)
{
  const Grid output =
    Execute(MakeOneTet(), 2, TetOct([](Filter* filter) { filter->GenerateClassificationOn(); }));
  vtkDataArray* rules = output->GetPointData()->GetArray("RuleDimension");
  ASSERT_EQ(rules->GetNumberOfTuples(), 35);
  EXPECT_EQ(rules->GetComponent(34, 0), 3);
  EXPECT_EQ(rules->GetComponent(0, 0), 2);
  vtkNew<Filter> filter;
  EXPECT_EQ(filter->GetVolumeScheme(), int(Filter::AUTOMATIC));
  filter->SetVolumeScheme(7);
  EXPECT_EQ(filter->GetVolumeScheme(), int(Filter::AUTOMATIC));
}

TEST(TetOctFilter, CurvesAndSurfacesCostNoSolids)
{
  // One tetrahedron would have 8^14 cells: nothing of that size may be asked for.
  const Grid line = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 } }, { { VTK_LINE, { 0, 1 } } });
  const Grid lines = Execute(line, 14, TetOct());
  EXPECT_EQ(lines->GetNumberOfCells(), 1 << 14);
  EXPECT_EQ(GetOctahedra(lines), Ids(1 << 14, -1));
  const Grid triangle =
    MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { VTK_TRIANGLE, { 0, 1, 2 } } });
  EXPECT_EQ(Execute(Execute(triangle, 7, TetOct()), 2, TetOct())->GetNumberOfCells(), 1 << 18);
}
