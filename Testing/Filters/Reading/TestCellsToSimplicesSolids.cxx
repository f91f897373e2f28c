// SPDX-License-Identifier: BSD-3-Clause
#include "CellsToSimplicesLattice.h"
#include "CellsToSimplicesTools.h"

#include "vtkSOADataArrayTemplate.h"

using namespace cells_to_simplices_tools;

namespace
{

/// As VTK up to 9.6 documents it: the normal of (0,1,2) points outward.
const std::vector<Point> WedgePoints = { { 0, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 0, 0, 1 },
  { 0, 1, 1 }, { 1, 0, 1 } };
const std::vector<Point> PyramidPoints = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 },
  { 0.3, 0.4, 1 } };

/// One triangle that fixes a diagonal: 0 joins the points 0 and 2 of the quad, 1 joins 1 and 3.
Cell Fix(const Ids& quad, int diagonal)
{
  return { VTK_TRIANGLE, { quad[diagonal], quad[1 + diagonal], quad[(2 + diagonal) % 4] } };
}

Ids Pick(const Ids& ids, const int* local)
{
  return { ids[local[0]], ids[local[1]], ids[local[2]], ids[local[3]] };
}

bool IsOnBoundary(const Mesh& mesh, const Face& face, double size)
{
  for (int i = 0; i < 3; ++i)
  {
    for (const double side : { 0.0, size })
    {
      if (mesh.Points[face[0]][i] == side && mesh.Points[face[1]][i] == side &&
        mesh.Points[face[2]][i] == side)
      {
        return true;
      }
    }
  }
  return false;
}

}

TEST(CellsToSimplices, EverySolidIsFilledByPositiveTets)
{
  std::mt19937 random(11);
  const std::vector<Point> voxel = { CubePoints[0], CubePoints[1], CubePoints[3], CubePoints[2],
    CubePoints[4], CubePoints[5], CubePoints[7], CubePoints[6] };
  for (int i = 0; i < 200; ++i)
  {
    const std::vector<std::tuple<int, std::vector<Point>, double, size_t>> solids = {
      { VTK_HEXAHEDRON, CubePoints, 1, 6 }, { VTK_VOXEL, voxel, 1, 6 },
      { VTK_WEDGE, WedgePoints, 0.5, 3 }, { VTK_PYRAMID, PyramidPoints, 1.0 / 3, 2 }
    };
    for (const auto& [type, points, volume, pieces] : solids)
    {
      const Mesh mesh = Shuffled(type, points, random);
      const auto result = Convert(mesh);
      EXPECT_EQ(result.Simplices.Dimensions.size(), pieces);
      EXPECT_EQ(result.GetNumberOfCentres(), 0) << "the smallest id never needs a centre";
      ExpectFills(result, mesh.Points, volume);
    }
  }
}

TEST(CellsToSimplices, AffineSolidsKeepTheirVolume)
{
  std::mt19937 random(12);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int i = 0; i < 50; ++i)
  {
    std::vector<Point> axes(3);
    for (Point& a : axes)
    {
      a = { coordinate(random), coordinate(random), coordinate(random) };
    }
    const double determinant = Dot(Cross(axes[0], axes[1]), axes[2]);
    Mesh mesh = Shuffled(VTK_HEXAHEDRON, CubePoints, random);
    for (Point& p : mesh.Points)
    {
      Point q{};
      for (int k = 0; k < 3; ++k)
      {
        q[k] = 3 + axes[0][k] * p[0] + axes[1][k] * p[1] + axes[2][k] * p[2];
      }
      p = q;
    }
    // An inverted hexahedron stays inverted, piece by piece.
    for (const Ids& s : GetSimplices(Convert(mesh)))
    {
      EXPECT_NEAR(Volume(mesh.Points, s), determinant / 6, 1e-12);
    }
  }
}

TEST(CellsToSimplices, HexahedronCentreOnlyWhereNothingElseIsPossible)
{
  std::set<unsigned> possible;
  for (const CubeSplit& split : GetAllCubeSplits().Splits)
  {
    possible.insert(split.Pattern);
  }
  EXPECT_EQ(GetAllCubeSplits().Splits.size(), 74u);
  EXPECT_EQ(possible.size(), 46u);
  std::mt19937 random(13);
  for (unsigned pattern = 0; pattern < 64; ++pattern)
  {
    for (int i = 0; i < 20; ++i)
    {
      Mesh mesh = Shuffled(VTK_HEXAHEDRON, CubePoints, random);
      const Ids ids = mesh.Cells[0].Points;
      if (i % 2)
      {
        mesh.Cells[0] = { VTK_VOXEL,
          { ids[0], ids[1], ids[3], ids[2], ids[4], ids[5], ids[7], ids[6] } };
      }
      std::set<Face> expected;
      for (int f = 0; f < 6; ++f)
      {
        const Ids q = Pick(ids, CubeFaces[f]);
        const int d = pattern >> f & 1;
        mesh.Cells.push_back(Fix(q, d));
        expected.insert(MakeFace(q[d], q[d + 1], q[(d + 2) % 4]));
        expected.insert(MakeFace(q[d], q[d + 2], q[(d + 3) % 4]));
      }
      const auto result = Convert(mesh);
      EXPECT_EQ(result.GetNumberOfCentres(), possible.count(pattern) ? 0 : 1) << pattern;
      EXPECT_EQ(result.Simplices.Dimensions.size(), (possible.count(pattern) ? 6u : 12u) + 6u);
      ExpectFills(result, mesh.Points, 1);
      EXPECT_EQ(FacesUsed(CountFaces(GetSimplices(result)), 1), expected) << pattern;
      EXPECT_TRUE(result.Warnings.empty());
    }
  }
}

TEST(CellsToSimplices, WedgeCentreOnlyWhereTheDiagonalsTurnRound)
{
  constexpr int faces[3][4] = { { 0, 3, 4, 1 }, { 1, 4, 5, 2 }, { 2, 5, 3, 0 } };
  std::mt19937 random(14);
  for (unsigned pattern = 0; pattern < 8; ++pattern)
  {
    for (int i = 0; i < 20; ++i)
    {
      Mesh mesh = Shuffled(VTK_WEDGE, WedgePoints, random);
      const Ids ids = mesh.Cells[0].Points;
      std::set<Face> expected = { MakeFace(ids[0], ids[1], ids[2]),
        MakeFace(ids[3], ids[4], ids[5]) };
      for (int f = 0; f < 3; ++f)
      {
        const Ids q = Pick(ids, faces[f]);
        const int d = pattern >> f & 1;
        mesh.Cells.push_back(Fix(q, d));
        expected.insert(MakeFace(q[d], q[d + 1], q[(d + 2) % 4]));
        expected.insert(MakeFace(q[d], q[d + 2], q[(d + 3) % 4]));
      }
      const auto result = Convert(mesh);
      const bool cyclic = pattern == 0 || pattern == 7;
      EXPECT_EQ(result.GetNumberOfCentres(), cyclic ? 1 : 0) << pattern;
      EXPECT_EQ(result.Simplices.Dimensions.size(), (cyclic ? 8u : 3u) + 3u);
      ExpectFills(result, mesh.Points, 0.5);
      EXPECT_EQ(FacesUsed(CountFaces(GetSimplices(result)), 1), expected) << pattern;
    }
  }
}

TEST(CellsToSimplices, CentresComeInCellOrder)
{
  Mesh mesh;
  for (int cell = 0; cell < 2; ++cell)
  {
    const vtkIdType o = 6 * cell;
    for (const Point& p : WedgePoints)
    {
      mesh.Points.push_back({ p[0] + 5 * cell, p[1], p[2] });
    }
    mesh.Cells.push_back({ VTK_WEDGE, { o, o + 1, o + 2, o + 3, o + 4, o + 5 } });
    mesh.Cells.push_back({ VTK_TRIANGLE, { o, o + 3, o + 4 } });
    mesh.Cells.push_back({ VTK_TRIANGLE, { o + 1, o + 4, o + 5 } });
    mesh.Cells.push_back({ VTK_TRIANGLE, { o + 2, o + 5, o + 3 } });
  }
  const auto result = Convert(mesh);
  EXPECT_EQ(result.Simplices.NumberOfPoints, 14);
  EXPECT_EQ(result.CentreOffsets, (Ids{ 0, 6, 12 }));
  EXPECT_EQ(result.CentreMembers, (Ids{ 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11 }));
  EXPECT_EQ(GetSimplices(result)[0][0], 12);
  EXPECT_EQ(GetSimplices(result)[11][0], 13);
}

TEST(CellsToSimplices, RandomHybridMeshesConform)
{
  for (unsigned seed = 0; seed < 30; ++seed)
  {
    const int size = 4;
    const RandomLattice lattice(size, seed);
    const auto result = Convert(lattice.Result);
    EXPECT_TRUE(result.Warnings.empty()) << result.Warnings[0];
    ExpectSound(result, static_cast<vtkIdType>(lattice.Result.Cells.size()));
    ExpectFills(result, lattice.Result.Points, std::pow(size, 3));
    const auto simplices = GetSimplices(result);
    const auto count = CountFaces(simplices);
    for (const Face& face : FacesUsed(count, 1))
    {
      EXPECT_TRUE(IsOnBoundary(lattice.Result, face, size));
    }
    for (const Ids& s : simplices)
    {
      if (s.size() == 3)
      {
        EXPECT_TRUE(count.count(MakeFace(s[0], s[1], s[2]))) << "a piece of a shell lies askew";
      }
    }
  }
}

TEST(CellsToSimplices, ThreadsDoNotChangeTheResult)
{
  const RandomLattice lattice(20, 3);
  const auto grid = MakeGrid(lattice.Result);
  ASSERT_GT(grid->GetNumberOfCells(), 3 * 4096);
  const std::string backend = vtkSMPTools::GetBackend();
  vtkSMPTools::SetBackend("Sequential");
  const auto one = CellsToSimplices(grid, nullptr);
  vtkSMPTools::SetBackend("STDThread");
  vtkSMPTools::Initialize(4);
  const auto four = CellsToSimplices(grid, nullptr);
  vtkSMPTools::Initialize(0);
  vtkSMPTools::SetBackend(backend.c_str());
  EXPECT_EQ(one.Simplices.Connectivity, four.Simplices.Connectivity);
  EXPECT_EQ(one.Simplices.Dimensions, four.Simplices.Dimensions);
  EXPECT_EQ(one.ParentCells, four.ParentCells);
  EXPECT_EQ(one.CentreOffsets, four.CentreOffsets);
  EXPECT_EQ(one.CentreMembers, four.CentreMembers);
}

TEST(CellsToSimplices, AnyStorageOfIdsAndPoints)
{
  const RandomLattice lattice(3, 1);
  const auto reference = Convert(lattice.Result);
  auto grid = MakeGrid(lattice.Result);
  grid->GetCells()->ConvertTo32BitStorage();
  vtkNew<vtkSOADataArrayTemplate<float>> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(grid->GetNumberOfPoints());
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    coordinates->SetTuple(i, grid->GetPoint(i));
  }
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  grid->SetPoints(points);
  const auto result = CellsToSimplices(grid, nullptr);
  EXPECT_EQ(result.Simplices.Connectivity, reference.Simplices.Connectivity);
  EXPECT_EQ(result.CentreMembers, reference.CentreMembers);

  coordinates->SetComponent(lattice.Result.Cells[0].Points[1], 2, std::nan(""));
  EXPECT_EQ(CellsToSimplices(grid, nullptr).Warnings.size(), 1u);

  Mesh tets;
  tets.Points.resize(5);
  tets.Cells = { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 4, 1, 2, 3 } } };
  grid = MakeGrid(tets);
  grid->GetCells()->ConvertTo32BitStorage();
  EXPECT_EQ(
    CellsToSimplices(grid, nullptr).Simplices.Connectivity, (Ids{ 0, 1, 2, 3, 4, 1, 2, 3 }));
}

TEST(CellsToSimplices, CollapsedHexahedraKeepTheirVolume)
{
  struct Collapse
  {
    std::array<int, 8> To;
    double Volume;
  };
  // A cube's points moved onto others: to a wedge, a pyramid, a tet, a plate, an edge.
  const std::vector<Collapse> collapses = { { { 0, 1, 2, 3, 4, 5, 6, 7 }, 1 },
    { { 0, 1, 1, 0, 4, 5, 6, 7 }, 0.5 }, { { 0, 1, 2, 3, 4, 4, 4, 4 }, 1.0 / 3 },
    { { 0, 1, 3, 3, 4, 4, 4, 4 }, 1.0 / 6 }, { { 0, 1, 2, 3, 0, 1, 2, 3 }, 0 },
    { { 0, 1, 1, 0, 0, 1, 1, 0 }, 0 }, { { 5, 5, 5, 5, 5, 5, 5, 5 }, 0 } };
  std::mt19937 random(31);
  for (const Collapse& collapse : collapses)
  {
    for (int i = 0; i < 50; ++i)
    {
      Mesh mesh = Shuffled(VTK_HEXAHEDRON, CubePoints, random);
      const Ids ids = mesh.Cells[0].Points;
      for (int k = 0; k < 8; ++k)
      {
        mesh.Cells[0].Points[k] = ids[collapse.To[k]];
      }
      const auto result = Convert(mesh);
      ExpectSound(result, 1);
      ExpectFills(result, mesh.Points, collapse.Volume);
      EXPECT_EQ(result.GetNumberOfCentres(), 0);
      EXPECT_EQ(result.Warnings.size(), collapse.Volume == 1 ? 0u : 1u);
    }
  }
}

TEST(CellsToSimplices, NothingIsBetweenFacesThatCoincide)
{
  // Point 5 lies on point 2: two quads share the triangle (1, 4, 2), facing each other across
  // nothing.
  Mesh mesh;
  mesh.Points.resize(8);
  mesh.Cells = { { VTK_HEXAHEDRON, { 1, 4, 2, 5, 6, 2, 7, 0 } } };
  EXPECT_EQ(GetSimplices(Convert(mesh)), (std::vector<Ids>{ { 0, 1, 2, 6 }, { 0, 1, 5, 2 } }));
}

TEST(CellsToSimplices, CollapsedHexahedraConformWithTheirNeighbours)
{
  // Every edge of the lower of two cubes collapsed in turn: pieces still meet face to face.
  constexpr int edges[12][2] = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 4, 5 }, { 5, 6 },
    { 6, 7 }, { 7, 4 }, { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } };
  std::mt19937 random(32);
  for (const auto& edge : edges)
  {
    for (int i = 0; i < 40; ++i)
    {
      Ids ids = Range(12);
      std::shuffle(ids.begin(), ids.end(), random);
      ids[edge[1]] = ids[edge[0]];
      Mesh mesh;
      mesh.Points.resize(12);
      mesh.Cells = { { VTK_HEXAHEDRON, Ids(ids.begin(), ids.begin() + 8) },
        { VTK_HEXAHEDRON, Ids(ids.begin() + 4, ids.end()) } };
      for (int f = 0; f < 6 && i >= 20; ++f) // half of them with diagonals fixed at random
      {
        const Ids q = Pick(ids, CubeFaces[f]);
        if (std::set<vtkIdType>(q.begin(), q.end()).size() == 4)
        {
          mesh.Cells.push_back(Fix(q, static_cast<int>(random() & 1)));
        }
      }
      const auto result = Convert(mesh);
      ExpectSound(result, static_cast<vtkIdType>(mesh.Cells.size()));
      const auto simplices = GetSimplices(result);
      const auto count = CountFaces(simplices);
      // The closed surface of what was glued: every edge of it lies on exactly two of its
      // triangles.
      std::map<std::pair<vtkIdType, vtkIdType>, int> onSurface;
      const auto surface = FacesUsed(count, 1);
      for (const Face& face : surface)
      {
        ++onSurface[{ face[0], face[1] }];
        ++onSurface[{ face[1], face[2] }];
        ++onSurface[{ face[0], face[2] }];
      }
      for (const auto& [key, n] : onSurface)
      {
        EXPECT_EQ(n, 2);
      }
      EXPECT_EQ(surface.size(), 18u);
      for (const Ids& s : simplices)
      {
        if (s.size() == 3)
        {
          EXPECT_TRUE(count.count(MakeFace(s[0], s[1], s[2])));
        }
      }
    }
  }
}
