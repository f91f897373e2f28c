// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestLimitProbeHybrid.cxx
 * Nearest places in meshes whose cells keep their types: places in solids are found again,
 * and points outside are as far away as another scheme says.
 */
#include "HybridFilterTools.h"
#include "HybridZoo.h"
#include "LimitProbeTools.h"

using namespace limit_probe_tools;

namespace
{

const Hybrid Keeping;

void AddRandom(vtkUnstructuredGrid* grid)
{
  grid->GetPointData()->AddArray(
    MakeArray<vtkDoubleArray>("Random", 1, grid->GetNumberOfPoints(), -1., 1., 7));
}

/// A box of all types or a fan, with surfaces and lines, by its seed.
Grid MakeRandom(unsigned int seed)
{
  constexpr int types[] = { VTK_VERTEX, VTK_LINE, VTK_TRIANGLE, VTK_QUAD, VTK_TETRA, VTK_PYRAMID,
    VTK_WEDGE, VTK_HEXAHEDRON };
  const hybridtest::Mesh drawn = hybridtest::MakeRandomHybrid(seed, false);
  std::vector<Cell> cells;
  for (const hybridtest::Cell& cell : drawn.Cells)
  {
    cells.push_back(
      { types[static_cast<int>(cell.Shape)], { cell.Corners.begin(), cell.Corners.end() } });
  }
  const Grid grid = MakeGrid({ drawn.Points.begin(), drawn.Points.end() }, cells);
  AddRandom(grid);
  return grid;
}

/// Parameters of a place in a cell, no nearer to its sides than `margin`.
Point DrawPlace(std::mt19937& random, int type, double margin)
{
  const auto draw = [&random] { return random() / 4294967296.; };
  Point at{ draw(), draw(), draw() };
  const bool hasTriangle = type == VTK_TRIANGLE || type == VTK_WEDGE;
  const int simplex = type == VTK_TETRA ? 3 : hasTriangle ? 2 : type == VTK_LINE ? 1 : 0;
  std::sort(at.begin(), at.begin() + simplex);
  for (int k = simplex - 1; k > 0; --k)
  {
    at[k] -= at[k - 1];
  }
  const int dimension = type == VTK_VERTEX     ? 0
    : type == VTK_LINE                         ? 1
    : type == VTK_TRIANGLE || type == VTK_QUAD ? 2
                                               : 3;
  for (int k = 0; k < 3; ++k)
  {
    const double sides = k < simplex ? simplex + 1. : 2.;
    at[k] = k < dimension ? margin + (1. - sides * margin) * at[k] : 0.;
  }
  return at;
}

/// Places in each cell, or in each solid.
place_tools::Places DrawPlaces(vtkUnstructuredGrid* mesh, int count, double margin, bool inSolids)
{
  std::mt19937 random(5);
  place_tools::Places places;
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
  {
    for (int i = 0; i < count && (!inSolids || mesh->GetCell(c)->GetCellDimension() == 3); ++i)
    {
      places.Add(c, DrawPlace(random, mesh->GetCellType(c), margin));
    }
  }
  return places;
}

Grid MakeCubeOfQuads(const std::vector<Point>& corners)
{
  return MakeGrid(corners,
    { { VTK_QUAD, { 0, 3, 2, 1 } }, { VTK_QUAD, { 4, 5, 6, 7 } }, { VTK_QUAD, { 0, 1, 5, 4 } },
      { VTK_QUAD, { 1, 2, 6, 5 } }, { VTK_QUAD, { 2, 3, 7, 6 } }, { VTK_QUAD, { 3, 0, 4, 7 } } });
}
const std::vector<Point> Corners{ { 0, 0, 0 }, { 1, 0, .2 }, { 1, 1, 0 }, { 0, 1, .1 }, { 0, 0, 1 },
  { 1, 0, 1.3 }, { 1, 1, 1 }, { -.1, 1, 1 } };

std::vector<Point> DrawTargets(int count, double size)
{
  std::mt19937 random(11);
  const auto draw = [&] { return .5 + size * (random() / 2147483648. - 1.); };
  std::vector<Point> targets;
  for (int i = 0; i < count; ++i)
  {
    targets.push_back({ draw(), draw(), draw() });
  }
  return targets;
}

double GetDistance(vtkPolyData* found, vtkIdType i)
{
  return found->GetPointData()->GetArray("Distance")->GetComponent(i, 0);
}

}

/// Points inside of solids have the cell and the parameters again.
TEST(LimitProbeHybrid, PointsInsideAreTheirOwnPlaces)
{
  for (unsigned int seed = 20; seed < 21; ++seed)
  {
    SCOPED_TRACE(seed);
    const Grid mesh = MakeRandom(seed);
    ExpectOwnPlaces(mesh, DrawPlaces(mesh, 1, .05, true), 1e-9, Keeping);
  }
}

/// Beside corners, edges and sides.
TEST(LimitProbeHybrid, PointsBesideSides)
{
  const Grid mesh = hybrid_filter_tools::MakeAllTypes();
  AddRandom(mesh);
  for (const double near : { 1e-3 })
  {
    SCOPED_TRACE(near);
    place_tools::Places places;
    for (vtkIdType c = 0; c < 4; ++c)
    {
      for (const Point& at : std::vector<Point>{
             { near, near, .3 }, { .4, .3, near }, { near, .3, .3 }, { .5, near, near } })
      {
        places.Add(c, at);
      }
    }
    ExpectOwnPlaces(mesh, places, 1e-7, Keeping);
  }
}

/// Octahedra that a filter wrote as tetrahedra: each of these is a cell.
TEST(LimitProbeHybrid, PointsInPiecesOfOctahedra)
{
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  Keeping(filter.Get());
  filter->SetNumberOfLevels(1);
  const Grid fine =
    UpdateWithoutErrors<vtkUnstructuredGrid>(filter.Get(), hybrid_filter_tools::MakeAllTypes());
  ASSERT_TRUE(fine->GetCellData()->HasArray("OctahedronId"));
  AddRandom(fine);
  ExpectOwnPlaces(fine, DrawPlaces(fine, 1, .1, true), 1e-9, Keeping);
}

/// The boundary of a hexahedron is Catmull-Clark's surface of its sides, which another search
/// finds; so is a surface of quads.
TEST(LimitProbeHybrid, DistancesAreThoseOfCatmullClark)
{
  const Grid quads = MakeCubeOfQuads(Corners);
  const Grid solid = MakeGrid(Corners, { { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } } });
  for (const double size : { .5, 100. })
  {
    SCOPED_TRACE(size);
    std::vector<Point> targets = DrawTargets(8, size);
    if (size < 1.)
    {
      targets[0] = { .5, .45, .55 }; // inside
    }
    vtkNew<vtkSubdivisionLimitProbe> filter;
    filter->SetSchemeToCatmullClark();
    filter->SetInputDataObject(3, place_tools::MakeTargets(targets));
    const auto expected = UpdateWithoutErrors<vtkPolyData>(filter.Get(), quads);
    const auto ofQuads = Probe(quads, targets, Keeping);
    const auto ofSolid = Probe(solid, targets, Keeping);
    int inside = 0;
    for (vtkIdType i = 0; i < 8; ++i)
    {
      const double distance = GetDistance(expected, i);
      EXPECT_NEAR(GetDistance(ofQuads, i), distance, 1e-11 * (1. + size)) << i;
      const bool isInside = GetDistance(ofSolid, i) < 1e-11;
      inside += isInside ? 1 : 0;
      if (!isInside)
      {
        EXPECT_NEAR(GetDistance(ofSolid, i), distance, 1e-9) << i;
      }
    }
    EXPECT_EQ(inside > 0, size < 1.);
  }
}

/// The default keeps the types of hexahedra, and cuts nothing.
TEST(LimitProbeHybrid, AutomaticIsThatOfTheMainFilter)
{
  const std::vector<Point> targets = DrawTargets(6, 1.);
  const Grid solid = MakeGrid(Corners, { { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } } });
  const auto run = [&](int scheme, vtkUnstructuredGrid* mesh)
  {
    vtkNew<vtkSubdivisionLimitProbe> filter;
    filter->SetScheme(scheme);
    filter->SetInputDataObject(3, place_tools::MakeTargets(targets));
    return UpdateWithoutErrors<vtkPolyData>(filter.Get(), mesh);
  };
  using Probe = vtkSubdivisionLimitProbe;
  EXPECT_EQ(Compare(run(Probe::AUTOMATIC, solid), run(Probe::HYBRID, solid)), "");
  const Grid tets =
    MakeGrid(Corners, { { VTK_TETRA, { 0, 1, 2, 4 } }, { VTK_TETRA, { 1, 2, 4, 6 } } });
  EXPECT_EQ(Compare(run(Probe::AUTOMATIC, tets), run(Probe::BOX_SPLINE, tets)), "");
}

TEST(LimitProbeHybrid, TheDefaultTellsOfCellsThatItCuts)
{
  for (const bool isCut : { true, false })
  {
    vtkNew<vtkSubdivisionLimitProbe> filter;
    filter->SetInputData(isCut
        ? MakeGrid(Corners, { { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } } })
        : MakeGrid(Corners, { { VTK_TETRA, { 0, 1, 2, 4 } } }));
    filter->SetInputDataObject(3, place_tools::MakeTargets(DrawTargets(2, 1.)));
    vtkNew<Messages> messages;
    messages->Watch(filter);
    filter->Update();
    EXPECT_EQ(messages->CountWarnings("set Scheme to Automatic"), isCut ? 1 : 0);
  }
}

/// Cells that are cut have places, but no parameters of their own; so have twins.
TEST(LimitProbeHybrid, CellsWithoutParameters)
{
  std::vector<Point> points;
  for (int i = 0; i < 10; ++i)
  {
    const double angle = .4 * 3.141592653589793 * i;
    points.push_back({ std::cos(angle), std::sin(angle), i / 5 * 1. });
  }
  const Grid prism =
    MakeGrid(points, { { VTK_PENTAGONAL_PRISM, { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9 } } });
  vtkNew<vtkSubdivisionLimitProbe> filter;
  filter->SetSchemeToHybrid();
  filter->SetInputDataObject(3, place_tools::MakeTargets({ { .1, .1, .5 }, { 3., 0., .5 } }));
  filter->SetInputData(prism);
  filter->Update();
  vtkPolyData* found = filter->GetOutput();
  ASSERT_EQ(found->GetNumberOfPoints(), 2);
  EXPECT_NEAR(GetDistance(found, 0), 0., 1e-11);
  EXPECT_GT(GetDistance(found, 1), 2.);
  for (vtkIdType i = 0; i < 2; ++i)
  {
    EXPECT_EQ(found->GetPointData()->GetArray("CellId")->GetComponent(i, 0), 0.);
    EXPECT_EQ(found->GetPointData()->GetArray("CellParameters")->GetComponent(i, 0), -1.);
  }
}
