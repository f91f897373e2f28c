// SPDX-License-Identifier: BSD-3-Clause
#include "CellsToSimplicesTools.h"

#include "vtkDataSetAttributes.h"

using namespace cells_to_simplices_tools;

TEST(CellsToSimplices, SimplicesKeepTheirOrderAndNeedNoParents)
{
  Mesh mesh;
  mesh.Points.resize(6);
  mesh.Cells = { { VTK_TETRA, { 3, 2, 5, 0 } }, { VTK_VERTEX, { 4 } }, { VTK_LINE, { 2, 1 } },
    { VTK_TRIANGLE, { 5, 0, 1 } }, { VTK_TETRA, { 0, 1, 2, 3 } } };
  const auto result = Convert(mesh);
  const std::vector<Ids> expected = { { 3, 2, 5, 0 }, { 4 }, { 2, 1 }, { 5, 0, 1 },
    { 0, 1, 2, 3 } };
  EXPECT_EQ(GetSimplices(result), expected);
  EXPECT_TRUE(result.ParentCells.empty());
  EXPECT_TRUE(result.Warnings.empty());
  EXPECT_EQ(result.Simplices.NumberOfPoints, 6);
  EXPECT_EQ(result.GetNumberOfCentres(), 0);
}

TEST(CellsToSimplices, LowDimensionalCellsInPieces)
{
  Mesh mesh;
  mesh.Points.resize(9);
  mesh.Cells = { { VTK_POLY_VERTEX, { 4, 2, 4 } }, { VTK_POLY_LINE, { 0, 1, 2, 0 } },
    { VTK_TRIANGLE_STRIP, { 3, 4, 5, 6, 7 } }, { VTK_POLYGON, { 8, 1, 2 } } };
  const auto result = Convert(mesh);
  const std::vector<Ids> expected = { { 4 }, { 2 }, { 4 }, { 0, 1 }, { 1, 2 }, { 2, 0 },
    { 3, 4, 5 }, { 5, 4, 6 }, { 5, 6, 7 }, { 8, 1, 2 } };
  EXPECT_EQ(GetSimplices(result), expected);
  EXPECT_EQ(result.ParentCells, (Ids{ 0, 0, 0, 1, 1, 1, 2, 2, 2, 3 }));
  EXPECT_TRUE(result.Warnings.empty()) << result.Warnings[0];
}

TEST(CellsToSimplices, ParentsAreListedOnlyWhereTheyAreNeeded)
{
  Mesh mesh;
  mesh.Points.resize(4);
  mesh.Cells = { { VTK_POLY_LINE, { 0, 1, 1 } }, { VTK_POLYGON, { 0, 1, 2, 2 } } };
  EXPECT_TRUE(Convert(mesh).ParentCells.empty()) << "simplex i is a piece of cell i";
  mesh.Cells = { { VTK_LINE, { 0, 0 } }, { VTK_POLY_LINE, { 0, 1, 2 } } };
  EXPECT_EQ(Convert(mesh).ParentCells, (Ids{ 1, 1 }))
    << "as many simplices as cells, yet not these";
}

TEST(CellsToSimplices, QuadsTakeTheDiagonalThroughTheSmallestId)
{
  Mesh mesh;
  mesh.Points.resize(8);
  mesh.Cells = { { VTK_QUAD, { 3, 1, 2, 4 } }, { VTK_PIXEL, { 0, 5, 6, 7 } },
    { VTK_POLYGON, { 5, 6, 7, 4 } } };
  const std::vector<Ids> expected = { { 3, 1, 4 }, { 1, 2, 4 }, { 0, 5, 7 }, { 0, 7, 6 },
    { 5, 6, 4 }, { 6, 7, 4 } };
  const auto result = Convert(mesh);
  EXPECT_EQ(GetSimplices(result), expected);

  const vtkIdType globalIds[8] = { 7, 6, 5, 4, 3, 2, 1, 0 };
  const std::vector<Ids> turned = { { 3, 1, 4 }, { 1, 2, 4 }, { 0, 5, 7 }, { 0, 7, 6 }, { 5, 6, 7 },
    { 5, 7, 4 } };
  EXPECT_EQ(GetSimplices(CellsToSimplices(MakeGrid(mesh), globalIds)), turned);
}

TEST(CellsToSimplices, TrianglesFixTheDiagonal)
{
  Mesh mesh;
  mesh.Points.resize(10);
  const Cell quad = { VTK_QUAD, { 0, 1, 2, 3 } };
  const std::vector<Ids> other = { { 0, 1, 3 }, { 1, 2, 3 } };
  const std::vector<Cell> neighbours = { { VTK_TRIANGLE, { 3, 1, 0 } },
    { VTK_TRIANGLE_STRIP, { 9, 8, 1, 3, 2 } }, { VTK_TETRA, { 9, 3, 1, 0 } },
    { VTK_PYRAMID, { 1, 8, 7, 2, 3 } }, { VTK_WEDGE, { 5, 6, 7, 0, 1, 3 } },
    { VTK_HEXAHEDRON, { 1, 1, 3, 2, 5, 6, 7, 8 } }, { VTK_POLYGON, { 3, 3, 1, 0 } } };
  for (const Cell& neighbour : neighbours)
  {
    mesh.Cells = { quad, neighbour };
    const auto all = GetSimplices(Convert(mesh));
    ASSERT_GE(all.size(), 3u);
    EXPECT_EQ(std::vector<Ids>(all.begin(), all.begin() + 2), other) << neighbour.Type;
  }
  // A triangle with two points of the quad says nothing, nor does one of a cell that is passed
  // over.
  const std::vector<Cell> strangers = { { VTK_TRIANGLE, { 3, 1, 9 } },
    { VTK_TETRA, { 3, 1, 0, 10 } }, { VTK_TETRA, { 3, 1, 0, 0 } }, { VTK_TRIANGLE_STRIP, { 1, 2 } },
    { VTK_QUADRATIC_EDGE, { 0, 1, 3 } } };
  for (const Cell& stranger : strangers)
  {
    mesh.Cells = { quad, stranger };
    EXPECT_EQ(GetSimplices(Convert(mesh))[0], (Ids{ 0, 1, 2 })) << stranger.Type;
  }
}

TEST(CellsToSimplices, BothDiagonalsTakenGivesOneWarning)
{
  Mesh mesh;
  mesh.Points.resize(12);
  mesh.Cells = { { VTK_LINE, { 0, 1 } }, { VTK_QUAD, { 3, 2, 1, 0 } },
    { VTK_POLYGON, { 0, 1, 2, 3 } }, { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 1, 2, 3 } } };
  const std::vector<Ids> simplices = { { 0, 1 }, { 3, 2, 0 }, { 2, 1, 0 }, { 0, 1, 2 }, { 0, 2, 3 },
    { 0, 1, 2 }, { 1, 2, 3 } };
  auto expected = simplices;
  expected[1] = { 3, 2, 0 };
  expected[2] = { 2, 1, 0 };
  const auto result = Convert(mesh);
  ASSERT_EQ(result.Warnings.size(), 1u);
  EXPECT_TRUE(Has(result.Warnings[0], "1 quad ")) << result.Warnings[0];
  EXPECT_TRUE(Has(result.Warnings[0], "cell 1")) << result.Warnings[0];
  for (const Ids& s : GetSimplices(result))
  {
    if (s.size() == 3 && s != (Ids{ 1, 2, 3 }))
    {
      EXPECT_NE(std::find(s.begin(), s.end(), 0), s.end());
    }
  }
  // The quads of a solid count as well, and each quad once.
  mesh.Cells = { { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } },
    { VTK_HEXAHEDRON, { 4, 5, 6, 7, 8, 9, 10, 11 } }, { VTK_TRIANGLE, { 4, 5, 6 } },
    { VTK_TRIANGLE, { 4, 5, 7 } }, { VTK_TRIANGLE, { 8, 9, 10 } }, { VTK_TRIANGLE, { 8, 9, 11 } } };
  const auto solids = Convert(mesh);
  ASSERT_EQ(solids.Warnings.size(), 1u);
  EXPECT_TRUE(Has(solids.Warnings[0], "2 quads ")) << solids.Warnings[0];
  EXPECT_TRUE(Has(solids.Warnings[0], "cell 0")) << solids.Warnings[0];
}

TEST(CellsToSimplices, PolyDataInCellIdOrder)
{
  vtkNew<vtkPolyData> poly;
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 8; ++i)
  {
    points->InsertNextPoint(std::cos(i), std::sin(i), 0);
  }
  poly->SetPoints(points);
  const auto make = [](const std::vector<Ids>& list)
  {
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    for (const Ids& ids : list)
    {
      cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    }
    return cells;
  };
  poly->SetStrips(make({ { 0, 1, 2, 3 } }));
  poly->SetPolys(make({ { 1, 2, 3 }, { 4, 5, 6, 7 } }));
  poly->SetLines(make({ { 6, 7 }, { 5, 4, 3 } }));
  poly->SetVerts(make({ { 7 }, { 6, 5 } }));
  const std::vector<Ids> expected = { { 7 }, { 6 }, { 5 }, { 6, 7 }, { 5, 4 }, { 4, 3 },
    { 1, 2, 3 }, { 4, 5, 6 }, { 4, 6, 7 }, { 0, 1, 2 }, { 2, 1, 3 } };
  const auto result = CellsToSimplices(poly, nullptr);
  EXPECT_EQ(GetSimplices(result), expected);
  EXPECT_EQ(result.ParentCells, (Ids{ 0, 1, 1, 2, 3, 3, 4, 5, 5, 6, 6 }));

  vtkNew<vtkPolyData> plain;
  plain->SetPoints(points);
  plain->SetPolys(make({ { 1, 2, 3 }, { 4, 6, 7 } }));
  plain->SetVerts(make({ { 7 } }));
  const auto copied = CellsToSimplices(plain, nullptr);
  EXPECT_EQ(GetSimplices(copied), (std::vector<Ids>{ { 7 }, { 1, 2, 3 }, { 4, 6, 7 } }));
  EXPECT_TRUE(copied.ParentCells.empty());
}

TEST(CellsToSimplices, UnsupportedTypesAreNamed)
{
  Mesh mesh;
  mesh.Points.resize(12);
  mesh.Cells = { { VTK_LINE, { 0, 1 } }, { VTK_CONVEX_POINT_SET, Range(10) },
    { VTK_LAGRANGE_PYRAMID, Range(5) }, { VTK_TETRA, { 3, 2, 1, 0 } } };
  ExpectOneWarning(mesh,
    { "2 cells", "cell 1", "vtkConvexPointSet", "41", "vtkDataSetTriangleFilter", "Bezier" },
    { { 0, 1 }, { 3, 2, 1, 0 } });
  mesh.Cells = { { VTK_LINE, { 0, 1 } }, { 250, { 1 } } };
  ExpectOneWarning(mesh, { "1 cell", "cell 1", "250" }, { { 0, 1 } });
  mesh.Cells = { { VTK_LINE, { 0, 1 } }, { VTK_EMPTY_CELL, {} } };
  ExpectOneWarning(mesh, { "1 cell", "vtkEmptyCell" }, { { 0, 1 } });
}

TEST(CellsToSimplices, IdsOutOfRange)
{
  Mesh mesh;
  mesh.Points.resize(4);
  const vtkIdType far = std::numeric_limits<vtkIdType>::max();
  mesh.Cells = { { VTK_LINE, { 0, 4 } }, { VTK_TRIANGLE, { 0, 1, 2 } },
    { VTK_TETRA, { -1, 0, 1, 2 } }, { VTK_POLYGON, { 0, 1, 2, 3, far } },
    { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, -far } } };
  ExpectOneWarning(
    mesh, { "4 cells", "cell 0", "negative or not below the number of points" }, { { 0, 1, 2 } });
}

TEST(CellsToSimplices, PointsThatAreNotFinite)
{
  Mesh mesh;
  mesh.Points.resize(7);
  mesh.Points[2][1] = std::nan("");
  mesh.Points[5][2] = -std::numeric_limits<double>::infinity();
  mesh.Cells = { { VTK_LINE, { 0, 1 } }, { VTK_TRIANGLE, { 0, 1, 2 } },
    { VTK_QUAD, { 0, 1, 3, 5 } }, { VTK_POLY_VERTEX, { 0, 2 } } };
  ExpectOneWarning(mesh, { "3 cells", "cell 1", "infinite or not a number" }, { { 0, 1 } });
  mesh.Cells = { { VTK_TRIANGLE, { 6, 1, 0 } } };
  EXPECT_TRUE(Convert(mesh).Warnings.empty()) << "unused points may be anything";
}

TEST(CellsToSimplices, WrongNumberOfPoints)
{
  Mesh mesh;
  mesh.Points.resize(9);
  mesh.Cells = { { VTK_TETRA, { 0, 1, 2 } }, { VTK_HEXAHEDRON, Range(9) }, { VTK_VERTEX, { 0, 1 } },
    { VTK_POLY_LINE, { 3 } }, { VTK_POLYGON, { 3, 4 } }, { VTK_POLY_VERTEX, {} },
    { VTK_LINE, { 7, 8 } } };
  ExpectOneWarning(mesh, { "6 cells", "cell 0", "number of points does not fit" }, { { 7, 8 } });
}

TEST(CellsToSimplices, RepeatedIds)
{
  Mesh mesh;
  mesh.Points.resize(9);
  mesh.Cells = { { VTK_VERTEX, { 0 } }, { VTK_LINE, { 3, 3 } }, { VTK_TRIANGLE, { 1, 2, 1 } },
    { VTK_TETRA, { 0, 1, 2, 0 } }, { VTK_QUAD, { 0, 1, 2, 2 } }, { VTK_PIXEL, { 0, 1, 0, 2 } } };
  ExpectOneWarning(mesh, { "5 cells", "cell 1", "repeated point ids", "Passed over 5" }, { { 0 } });
  mesh.Cells = { { VTK_POLY_LINE, { 0, 1, 1, 2 } }, { VTK_TRIANGLE_STRIP, { 0, 1, 1, 2, 3 } },
    { VTK_POLYGON, { 4, 5, 5, 6 } }, { VTK_POLYGON, { 7, 8, 8, 7 } },
    { VTK_POLYGON, { 0, 1, 0, 2 } } };
  ExpectOneWarning(mesh, { "5 cells", "cell 0", "degenerate pieces" },
    { { 0, 1 }, { 1, 2 }, { 1, 2, 3 }, { 4, 5, 6 } });
  mesh.Cells.insert(mesh.Cells.begin(), { VTK_LINE, { 0, 0 } });
  ExpectOneWarning(
    mesh, { "6 cells", "cell 0", "all or part" }, { { 0, 1 }, { 1, 2 }, { 1, 2, 3 }, { 4, 5, 6 } });
}

TEST(CellsToSimplices, HiddenCellsTakeNoPart)
{
  Mesh mesh;
  mesh.Points.resize(6);
  mesh.Cells = { { VTK_QUAD, { 0, 1, 2, 3 } }, { VTK_TRIANGLE, { 1, 2, 3 } },
    { VTK_QUADRATIC_EDGE, { 0, 1, 2 } }, { VTK_LINE, { 4, 4 } }, { VTK_LINE, { 4, 5 } } };
  const auto grid = MakeGrid(mesh);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  const unsigned char hidden = vtkDataSetAttributes::HIDDENCELL;
  const unsigned char duplicate = vtkDataSetAttributes::DUPLICATECELL;
  for (const unsigned char ghost : { 0, +hidden, hidden | duplicate, +hidden, +duplicate })
  {
    ghosts->InsertNextValue(ghost);
  }
  grid->GetCellData()->AddArray(ghosts);
  const auto result = CellsToSimplices(grid, nullptr);
  EXPECT_EQ(GetSimplices(result), (std::vector<Ids>{ { 0, 1, 2 }, { 0, 2, 3 }, { 4, 5 } }));
  EXPECT_EQ(result.ParentCells, (Ids{ 0, 0, 4 }));
  EXPECT_TRUE(result.Warnings.empty());
}

TEST(CellsToSimplices, EmptyInput)
{
  vtkNew<vtkUnstructuredGrid> grid;
  EXPECT_EQ(CellsToSimplices(grid, nullptr).Simplices.GetNumberOfSimplices(), 0);
  vtkNew<vtkPolyData> poly;
  EXPECT_EQ(CellsToSimplices(poly, nullptr).Simplices.GetNumberOfSimplices(), 0);
  Mesh mesh;
  mesh.Cells = { { VTK_TETRA, { 0, 1, 2, 3 } } };
  ExpectOneWarning(mesh, { "1 cell" }, {});
  auto noPoints = MakeGrid(mesh);
  noPoints->SetPoints(nullptr);
  EXPECT_EQ(CellsToSimplices(noPoints, nullptr).Warnings.size(), 1u);
}

TEST(CellsToSimplices, NonsenseDoesNoHarm)
{
  std::mt19937 random(41);
  const auto pick = [&random](int from, int to)
  { return std::uniform_int_distribution<int>(from, to)(random); };
  for (int run = 0; run < 300; ++run)
  {
    const int n = pick(1, 12);
    Mesh mesh;
    for (int i = 0; i < n; ++i)
    {
      mesh.Points.push_back({ pick(0, 3) / 1.0, pick(0, 3) / 1.0, pick(0, 3) / 1.0 });
    }
    if (run % 3 == 0)
    {
      mesh.Points[0][1] = std::nan("");
    }
    for (int i = 0; i < 60; ++i)
    {
      constexpr int sizes[15] = { 0, 1, 3, 2, 4, 3, 6, 5, 4, 4, 4, 8, 8, 6, 5 };
      const int type = pick(0, 9) ? pick(0, 14) : pick(0, 255);
      const int size = type < 15 && pick(0, 9) ? sizes[type] : pick(0, 20);
      Ids ids;
      for (int k = 0; k < size; ++k)
      {
        ids.push_back(pick(0, 30) ? pick(0, n - 1) : pick(-2, n + 1));
      }
      mesh.Cells.push_back({ type, ids });
    }
    ExpectSound(Convert(mesh), 60);
  }
}
