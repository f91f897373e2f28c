// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestHybridReference.cxx
 * The slow reference of the hybrid scheme against figures that were settled before it.
 */
#include "FileTools.h"
#include "HybridZoo.h"

#include "vtkCellType.h"

#include <cmath>
#include <iterator>

using namespace hybridtest;

namespace
{

/// The weights of a row at points, in their order.
std::vector<double> At(const Row& row, const Ids& points)
{
  std::vector<double> weights;
  for (int point : points)
  {
    const auto found = row.find(point);
    weights.push_back(found == row.end() ? 0. : found->second);
  }
  return weights;
}

void ExpectNear(
  const std::vector<double>& got, const std::vector<double>& wanted, double tolerance = 1e-14)
{
  ASSERT_EQ(got.size(), wanted.size());
  for (std::size_t i = 0; i < got.size(); ++i)
  {
    EXPECT_NEAR(got[i], wanted[i], tolerance) << "entry " << i;
  }
}

/// The row of the new point of an edge or quad: the one whose linear place is the mean of these
/// corners.
Row RowOf(const Mesh& mesh, const Ids& side)
{
  const Complex complex(mesh);
  std::size_t point = mesh.Points.size();
  for (int d = 1; d <= 2; ++d)
  {
    for (const auto& [ids, cell] : complex.GetSides(d))
    {
      if (ids == Sorted(side))
      {
        return Refine(mesh).Rows[point];
      }
      point += cell.Shape != Type::Triangle;
    }
  }
  ADD_FAILURE() << "there is no such side";
  return {};
}

Point Minus(const Point& a, const Point& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

double Determinant(const Point& a, const Point& b, const Point& c)
{
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
    a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// Of trilinear hexahedra, by Gauss's rule of two points a direction, which is exact.
double VolumeOfHexes(const Mesh& mesh)
{
  static const int unit[8][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
  double volume = 0.;
  for (const Cell& cell : mesh.Cells)
  {
    for (const auto& place : unit)
    {
      Point derivatives[3] = {};
      for (int i = 0; i < 8; ++i)
      {
        for (int d = 0; d < 3; ++d)
        {
          double factor = unit[i][d] == 1 ? 1. : -1.;
          for (int e = 0; e < 3; ++e)
          {
            const double x = .5 + (place[e] == 1 ? 1. : -1.) / std::sqrt(12.);
            factor *= e == d ? 1. : unit[i][e] == 1 ? x : 1. - x;
          }
          for (int c = 0; c < 3; ++c)
          {
            derivatives[d][c] += factor * mesh.Points[cell.Corners[i]][c];
          }
        }
      }
      volume += Determinant(derivatives[0], derivatives[1], derivatives[2]) / 8.;
    }
  }
  return volume;
}

std::map<Type, int> CountTypes(const Mesh& mesh)
{
  std::map<Type, int> counts;
  for (const Cell& cell : mesh.Cells)
  {
    ++counts[cell.Shape];
  }
  return counts;
}

Mesh One(Type shape, int corners)
{
  Mesh mesh;
  mesh.Cells.push_back({ shape, {} });
  for (int i = 0; i < corners; ++i)
  {
    mesh.Points.push_back({ std::cos(3. * i), std::sin(5. * i), i * .3 });
    mesh.Cells[0].Corners.push_back(i);
  }
  return mesh;
}

/// Four hexahedra around point 0, then the ends of its edges, six quads' and four cells' far
/// corners.
Mesh FourHexes()
{
  const Point ends[4] = { { 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 } };
  Mesh mesh;
  mesh.Points.push_back({});
  mesh.Points.insert(mesh.Points.end(), std::begin(ends), std::end(ends));
  int quad[4][4];
  const auto sum = [](const Point& a, const Point& b)
  { return Point{ a[0] + b[0], a[1] + b[1], a[2] + b[2] }; };
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < i; ++j)
    {
      quad[i][j] = quad[j][i] = static_cast<int>(mesh.Points.size());
      mesh.Points.push_back(sum(ends[i], ends[j]));
    }
  }
  for (int left = 0; left < 4; ++left)
  {
    const int i = (left + 1) % 4;
    const int j = (left + 2) % 4;
    const int k = (left + 3) % 4;
    const int far = static_cast<int>(mesh.Points.size());
    mesh.Points.push_back(sum(sum(ends[i], ends[j]), ends[k]));
    mesh.Cells.push_back(
      { Type::Hex, { 0, i + 1, quad[i][j], j + 1, k + 1, quad[i][k], far, quad[j][k] } });
  }
  return mesh;
}

}

TEST(HybridReference, ACubeShrinksToItsLimit)
{
  Mesh mesh = MakeCube();
  const double volumes[] = { .42708333, .35019180, .33308094, .32892638 };
  for (double volume : volumes)
  {
    const bool isFirst = mesh.Cells.size() == 1;
    mesh = Refine(mesh).Fine;
    EXPECT_NEAR(VolumeOfHexes(mesh), volume, 6e-9);
    if (isFirst)
    {
      ExpectNear({ mesh.Points[0].begin(), mesh.Points[0].end() }, { 2. / 9, 2. / 9, 2. / 9 });
    }
  }
  const Row limit = LimitRow(MakeCube(), 0);
  Point place = {};
  for (const auto& [id, weight] : limit)
  {
    for (int c = 0; c < 3; ++c)
    {
      place[c] += weight * MakeCube().Points[id][c];
    }
  }
  ExpectNear({ place.begin(), place.end() }, { .25, .25, .25 }, 1e-12);
}

TEST(HybridReference, SixPyramidsAroundAPoint)
{
  const Mesh mesh = MakeSixPyramids();
  const Row row = Refine(mesh).Rows[8];
  ExpectNear(At(row, { 8, 0, 6 }), { 13. / 24, 11. / 192, 11. / 192 });
  ExpectNear(At(LimitRow(mesh, 8), { 8, 0, 6 }), { .32559759, .08430030, .08430030 }, 6e-9);
  // An inner edge has three pyramids; each has two neighbours of its end, two of which are shared.
  const Row edge = RowOf(mesh, { 0, 8 });
  ExpectNear(At(edge, { 0, 8, 1, 2, 6 }), { 79. / 256, 5. / 24, 2. * 49 / 768, 77. / 2304, 0. });
}

TEST(HybridReference, QuadsAndEdgesBetweenCells)
{
  Mesh mesh = MakeCube();
  mesh.Points.push_back({ .5, .5, 2. });
  mesh.Cells.push_back({ Type::Pyramid, { 4, 5, 6, 7, 8 } });
  ExpectNear(At(RowOf(mesh, { 4, 5, 6, 7 }), { 4, 0, 8 }), { 81. / 448, 1. / 32, 17. / 112 });

  const Mesh three = MakeFan({ Type::Hex, Type::Hex, Type::Hex }, 1);
  ExpectNear(At(RowOf(three, { 0, 1 }), { 0, 1, 2, 3, 4, 8, 9, 12 }),
    { 5. / 24, 5. / 24, 1. / 12, 1. / 12, 1. / 12, 1. / 72, 1. / 72, 1. / 72 });
}

TEST(HybridReference, FourHexesAroundAPoint)
{
  const Mesh mesh = FourHexes();
  ExpectNear(
    At(Refine(mesh).Rows[0], { 0, 1, 5, 11 }), { 27. / 64, 27. / 256, 3. / 128, 1. / 256 });
  ExpectNear(
    At(LimitRow(mesh, 0), { 0, 1, 5, 11 }), { .25325885, .10998603, .04376164, .01105680 }, 6e-9);
}

TEST(HybridReference, LimitsOfColumns)
{
  // Of the middle of the axis: itself, above, a neighbour, above it, opposite, above it.
  const auto hexes = [](std::size_t n)
  { return LimitRow(MakeFan(std::vector<Type>(n, Type::Hex), 2), 1); };
  ExpectNear(At(hexes(3), { 1, 2, 4, 5, 13, 14 }),
    { 1. / 4, 1. / 16, 1. / 9, 1. / 36, 1. / 36, 1. / 144 }, 1e-12);
  ExpectNear(At(hexes(5), { 1, 2, 4, 5, 19, 20 }),
    { 1. / 3, 1. / 12, 4. / 75, 1. / 75, 1. / 75, 1. / 300 }, 1e-12);
  const auto wedges = [](std::size_t n)
  { return LimitRow(MakeFan(std::vector<Type>(n, Type::Wedge), 2), 1); };
  ExpectNear(At(wedges(3), { 1, 2, 4, 5 }), { 4. / 15, 1. / 15, 2. / 15, 1. / 30 }, 1e-12);
  ExpectNear(At(wedges(4), { 1, 2, 4, 5 }), { 1. / 3, 1. / 12, 1. / 12, 1. / 48 }, 1e-12);
}

/// A surface of quads and triangles times a line: its rows times the cubic B-spline's.
TEST(HybridReference, AColumnIsASurfaceTimesALine)
{
  const Type h = Type::Hex;
  const Type w = Type::Wedge;
  for (const std::vector<Type>& sectors : { std::vector<Type>{ h, h, h }, { w, w, w }, { h, h, w },
         { h, w, w, w, w }, { h, w, h, w, w } })
  {
    const Mesh solid = MakeFan(sectors, 2);
    Mesh surface;
    surface.Points.resize(solid.Points.size() / 3);
    for (const Cell& cell : solid.Cells)
    {
      if (cell.Corners[0] == 0)
      {
        Cell face = { cell.Shape == h ? Type::Quad : Type::Triangle, {} };
        for (std::size_t i = 0; i < cell.Corners.size() / 2; ++i)
        {
          face.Corners.push_back(cell.Corners[i] / 3);
        }
        surface.Cells.push_back(face);
      }
    }
    const Row flat = Refine(surface).Rows[0];
    const Row row = Refine(solid).Rows[1];
    const Row middle = RowOf(solid, { 1, 2 });
    for (const auto& [id, weight] : flat)
    {
      ExpectNear(
        At(row, { 3 * id, 3 * id + 1, 3 * id + 2 }), { weight / 8, weight * 3 / 4, weight / 8 });
      ExpectNear(At(middle, { 3 * id, 3 * id + 1, 3 * id + 2 }), { 0., weight / 2, weight / 2 });
    }
  }
}

TEST(HybridReference, TetrahedraAloneAreTheTetOctScheme)
{
  Mesh mesh = One(Type::Tet, 4);
  const std::size_t points[] = { 10, 35, 165 };
  const int tets[] = { 4, 24, 176 };
  const int octahedra[] = { 1, 10, 84 };
  for (int level = 0; level < 3; ++level)
  {
    const Level next = Refine(mesh);
    EXPECT_EQ(next.Fine.Points.size(), points[level]);
    EXPECT_EQ(CountTypes(next.Fine)[Type::Tet], tets[level]);
    EXPECT_EQ(CountTypes(next.Fine)[Type::Octahedron], octahedra[level]);
    int regular = 0;
    for (std::size_t i = 0; i < mesh.Points.size(); ++i)
    {
      const Row& row = next.Rows[i];
      // The octet lattice: 12 neighbours, and 6 opposite corners of octahedra.
      regular += row.size() == 19 && std::abs(row.at(static_cast<int>(i)) - 25. / 48) < 1e-14;
    }
    EXPECT_EQ(regular, level == 2 ? 1 : 0);
    mesh = next.Fine;
  }
}

TEST(HybridReference, CellsSplitIntoAsManyAsTheirFormulasSay)
{
  Mesh hex = One(Type::Hex, 8);
  Mesh wedge = One(Type::Wedge, 6);
  Mesh pyramid = One(Type::Pyramid, 5);
  Mesh octahedron = One(Type::Octahedron, 6);
  const int joined[3][3] = { { 4, 1, 4 }, { 16, 14, 40 }, { 64, 140, 336 } };
  const int inside[3][2] = { { 6, 8 }, { 44, 80 }, { 344, 672 } };
  for (int k = 1; k <= 3; ++k)
  {
    const int n = 1 << k;
    for (Mesh* mesh : { &hex, &wedge, &pyramid, &octahedron })
    {
      *mesh = Refine(*mesh).Fine;
    }
    EXPECT_EQ(CountTypes(hex), (std::map<Type, int>{ { Type::Hex, n * n * n } }));
    EXPECT_EQ(hex.Points.size(), (n + 1) * (n + 1) * (n + 1));
    EXPECT_EQ(CountTypes(wedge), (std::map<Type, int>{ { Type::Wedge, n * n * n } }));
    EXPECT_EQ(wedge.Points.size(), (n + 1) * (n + 1) * (n + 2) / 2);
    EXPECT_EQ(CountTypes(pyramid),
      (std::map<Type, int>{ { Type::Pyramid, joined[k - 1][0] },
        { Type::Octahedron, joined[k - 1][1] }, { Type::Tet, joined[k - 1][2] } }));
    EXPECT_EQ(pyramid.Points.size(), (n + 1) * (n + 2) * (2 * n + 3) / 6);
    EXPECT_EQ(CountTypes(octahedron),
      (std::map<Type, int>{
        { Type::Octahedron, inside[k - 1][0] }, { Type::Tet, inside[k - 1][1] } }));
    EXPECT_EQ(octahedron.Points.size(), (n + 1) * (2 * n * n + 4 * n + 3) / 3);
  }
}

TEST(HybridReference, CellsKeepTheirOrientation)
{
  Mesh mesh = MakeSixPyramids();
  mesh.Points.insert(mesh.Points.end(),
    { { 3, 0, 0 }, { 4, 0, 0 }, { 3, 1, 0 }, { 3, 0, 1 }, { 4, 0, 1 }, { 3, 1, 1 } });
  mesh.Cells.clear();
  mesh.Cells.push_back({ Type::Wedge, { 9, 10, 11, 12, 13, 14 } });
  mesh.Cells.push_back({ Type::Pyramid, { 0, 1, 2, 3, 8 } });
  for (int i : { 0, 1, 2, 3, 8, 9, 10, 11, 12, 13, 14 })
  {
    mesh.Singular.insert({ i });
  }
  for (int level = 0; level < 2; ++level)
  {
    mesh = Refine(mesh).Fine;
    for (const Cell& cell : mesh.Cells)
    {
      const auto side = [&](int i, int j)
      { return Minus(mesh.Points[cell.Corners[i]], mesh.Points[cell.Corners[j]]); };
      const double volume = cell.Shape == Type::Octahedron
        ? Determinant(side(0, 1), side(2, 3), side(4, 5))
        : cell.Shape == Type::Pyramid ? Determinant(side(1, 0), side(3, 0), side(4, 0))
                                      : Determinant(side(1, 0), side(2, 0), side(3, 0));
      EXPECT_GT(volume, 0.);
    }
  }
}

TEST(HybridReference, QuadOfThreeHexesAndThreeSheets)
{
  Mesh mesh;
  mesh.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  for (int i = 0; i < 3; ++i)
  {
    const int first = static_cast<int>(mesh.Points.size());
    mesh.Cells.push_back({ Type::Hex, { 0, 1, 2, 3, first, first + 1, first + 2, first + 3 } });
    mesh.Points.resize(mesh.Points.size() + 4);
  }
  ExpectNear(
    At(RowOf(mesh, { 0, 1, 2, 3 }), { 0, 3, 4, 15 }), { 3. / 16, 3. / 16, 1. / 48, 1. / 48 });
  mesh.Joint = Joints::Sharp;
  ExpectNear(At(RowOf(mesh, { 0, 1, 2, 3 }), { 0, 4 }), { 1. / 4, 0. });

  // Three sheets at a line of two edges: 9/16 and 7/80 five times; an edge of three quads.
  Mesh sheets;
  sheets.Points.resize(12);
  for (int i = 3; i < 12; i += 3)
  {
    sheets.Cells.push_back({ Type::Quad, { 0, 1, i + 1, i } });
    sheets.Cells.push_back({ Type::Quad, { 1, 2, i + 2, i + 1 } });
  }
  ExpectNear(At(Refine(sheets).Rows[1], { 1, 0, 4, 3 }), { 9. / 16, 7. / 80, 7. / 80, 0. });
  ExpectNear(
    At(RowOf(sheets, { 0, 1 }), { 0, 1, 3, 4, 2 }), { 5. / 16, 5. / 16, 1. / 16, 1. / 16, 0. });
}

/// The zoo of MFEM with its boundary cells: sums over the points of three levels.
TEST(HybridReference, SumsOfAMeshOfAllTypes)
{
  const std::string path = file_tools::GetSharedFile("hex_mfem_tinyzoo.vtu");
  if (!file_tools::WhyNotRead(path).empty())
  {
    GTEST_SKIP() << file_tools::WhyNotRead(path);
  }
  const std::map<int, Type> types = { { VTK_TRIANGLE, Type::Triangle }, { VTK_QUAD, Type::Quad },
    { VTK_TETRA, Type::Tet }, { VTK_PYRAMID, Type::Pyramid }, { VTK_WEDGE, Type::Wedge },
    { VTK_HEXAHEDRON, Type::Hex } };
  const auto grid = file_tools::ReadGrid(path);
  Mesh mesh;
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    mesh.Points.emplace_back();
    grid->GetPoint(i, mesh.Points.back().data());
  }
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    vtkNew<vtkIdList> ids;
    grid->GetCellPoints(i, ids);
    mesh.Cells.push_back({ types.at(grid->GetCellType(i)), Ids(ids->begin(), ids->end()) });
  }
  const std::size_t points[] = { 45, 225, 1377 };
  const double sums[3][4] = { { 45.13565793, 22.55402441, 22.60616352, 94.6526781326 },
    { 225.52539657, 113.08384459, 113.37694696, 446.1233261582 },
    { 1379.75502717, 693.76157490, 695.77188914, 2667.5372881483 } };
  for (int level = 0; level < 3; ++level)
  {
    mesh = Refine(mesh).Fine;
    ASSERT_EQ(mesh.Points.size(), points[level]);
    std::vector<double> sum(4);
    for (const Point& point : mesh.Points)
    {
      for (int c = 0; c < 3; ++c)
      {
        sum[c] += point[c];
        sum[3] += point[c] * point[c];
      }
    }
    ExpectNear(sum, std::vector<double>(std::begin(sums[level]), std::end(sums[level])), 6e-9);
    if (level == 1)
    {
      EXPECT_EQ(CountTypes(mesh),
        (std::map<Type, int>{ { Type::Triangle, 128 }, { Type::Quad, 96 }, { Type::Tet, 64 },
          { Type::Pyramid, 16 }, { Type::Wedge, 64 }, { Type::Hex, 64 },
          { Type::Octahedron, 24 } }));
    }
  }
}

/// Random meshes: rows are convex.
TEST(HybridReference, RowsOfRandomMeshesAreMeans)
{
  std::map<Type, int> counts;
  for (unsigned int seed = 0; seed < 100; ++seed)
  {
    SCOPED_TRACE(seed);
    const Mesh mesh = MakeRandomHybrid(seed);
    for (const auto& [shape, count] : CountTypes(mesh))
    {
      counts[shape] += count;
    }
    const Level level = Refine(mesh);
    ASSERT_EQ(level.Rows.size(), level.Fine.Points.size());
    for (const Row& row : level.Rows)
    {
      double sum = 0.;
      for (const auto& item : row)
      {
        sum += item.second;
        EXPECT_GE(item.second, -1e-15);
      }
      EXPECT_NEAR(sum, 1., 1e-14);
    }
  }
  EXPECT_EQ(counts.size(), 9U);
}
