// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestHybridInput.cxx
 * How VolumeScheme = HYBRID and KeepCellTypes read cells that have no children of their type, have
 * repeated points, or do not fit their neighbours.
 */
#include "FeatureTools.h"
#include "TypedCellTools.h"

#include "vtkCellTypeSource.h"

#include <random>

using namespace feature_tools;
using namespace typed_cell_tools;

namespace
{

const Configure Linear = [](Filter* filter)
{
  filter->SetVolumeSchemeToLinear();
  filter->KeepCellTypesOn();
};
const Configure Hybrid = [](Filter* filter) { filter->SetVolumeSchemeToHybrid(); };

using Types = std::map<int, int>;

/// The corners of a cube in the order of VTK_HEXAHEDRON, moved a little.
std::vector<Point> MakeCorners()
{
  std::vector<Point> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      points[i][c] += .05 * std::sin(3. * static_cast<double>(i) + c);
    }
  }
  return points;
}

std::vector<Ids> GetSides(const Ids& hexahedron)
{
  std::vector<Ids> sides;
  for (const auto& face : { Ids{ 0, 4, 7, 3 }, { 1, 2, 6, 5 }, { 0, 1, 5, 4 }, { 3, 7, 6, 2 },
         { 0, 3, 2, 1 }, { 4, 5, 6, 7 } })
  {
    sides.emplace_back();
    for (const vtkIdType corner : face)
    {
      sides.back().push_back(hexahedron[corner]);
    }
  }
  return sides;
}

/// Of a hexahedron as it is, with repeated points.
double MeasureHexahedron(vtkPointSet* grid, const Ids& hexahedron)
{
  double flux = 0.;
  for (const Ids& side : GetSides(hexahedron))
  {
    flux += GetFlux(grid, side);
  }
  return flux / 6.;
}

/// Whether a quad lies against two triangles of the same cell, which close it.
bool HasFlap(const Ids& hexahedron)
{
  std::set<std::set<vtkIdType>> triangles;
  for (const Ids& side : GetSides(hexahedron))
  {
    triangles.insert({ side.begin(), side.end() }); // quads, too, which equal none below
  }
  bool hasFlap = false;
  for (const Ids& q : GetSides(hexahedron))
  {
    const bool isQuad = std::set<vtkIdType>(q.begin(), q.end()).size() == 4;
    for (int d = 0; d < 2 && isQuad; ++d)
    {
      hasFlap = hasFlap ||
        (triangles.count({ q[d], q[d + 1], q[d + 2] }) &&
          triangles.count({ q[d + 2], q[(d + 3) % 4], q[d] }));
    }
  }
  return hasFlap;
}

}

TEST(HybridInput, CollapsedSolidsAreTheCellsThatTheyAre)
{
  const std::vector<std::pair<Cell, Types>> cases = {
    { { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 4, 4, 4 } }, { { VTK_PYRAMID, 1 } } },
    { { VTK_HEXAHEDRON, { 0, 1, 2, 2, 4, 5, 6, 6 } }, { { VTK_WEDGE, 1 } } },
    { { VTK_HEXAHEDRON, { 0, 0, 2, 3, 4, 4, 6, 7 } }, { { VTK_WEDGE, 1 } } },
    { { VTK_HEXAHEDRON, { 0, 1, 1, 0, 4, 5, 6, 7 } }, { { VTK_WEDGE, 1 } } },
    { { VTK_HEXAHEDRON, { 0, 1, 2, 2, 4, 4, 4, 4 } }, { { VTK_TETRA, 1 } } },
    { { VTK_VOXEL, { 0, 1, 3, 2, 4, 4, 4, 4 } }, { { VTK_PYRAMID, 1 } } },
    { { VTK_WEDGE, { 0, 2, 1, 0, 6, 5 } }, { { VTK_PYRAMID, 1 } } },
    { { VTK_WEDGE, { 0, 2, 1, 4, 4, 4 } }, { { VTK_TETRA, 1 } } },
    { { VTK_PYRAMID, { 0, 1, 2, 2, 4 } }, { { VTK_TETRA, 1 } } },
    { { VTK_QUAD, { 0, 1, 2, 2 } }, { { VTK_TRIANGLE, 1 } } },
    { { VTK_PIXEL, { 0, 1, 3, 3 } }, { { VTK_TRIANGLE, 1 } } },
    { { VTK_POLYGON, { 0, 1, 1, 2, 3 } }, { { VTK_QUAD, 1 } } },
  };
  for (const auto& [cell, expected] : cases)
  {
    for (const Configure& configure : { Linear, Hybrid })
    {
      const Grid output = Execute(MakeGrid(MakeCorners(), { cell }), 0, configure);
      EXPECT_EQ(CountTypes(output), expected)
        << cell.Type << " " << testing::PrintToString(cell.Points);
      EXPECT_TRUE(cell.Type == VTK_QUAD || cell.Type == VTK_PIXEL || cell.Type == VTK_POLYGON ||
        MeasureSolids(output) > .1);
    }
  }
  // A hexahedron with one collapsed edge is a polyhedron of two triangles and four quads.
  vtkNew<Messages> messages;
  const Grid cut =
    Execute(MakeGrid(MakeCorners(), { { VTK_HEXAHEDRON, { 0, 1, 2, 2, 4, 5, 6, 7 } } }), 0, Hybrid,
      messages);
  EXPECT_EQ(CountTypes(cut), (Types{ { VTK_TETRA, 2 }, { VTK_PYRAMID, 4 } }));
  EXPECT_EQ(messages->CountWarnings("1 cell (cell 0, type 12, vtkHexahedron) has no children"), 1);
  EXPECT_EQ(messages->Warnings.size(), 1u);
  // Nothing is left of these.
  vtkNew<Messages> lost;
  EXPECT_EQ(Execute(MakeGrid(MakeCorners(),
                      { { VTK_HEXAHEDRON, { 0, 1, 2, 3, 0, 1, 2, 3 } },
                        { VTK_TETRA, { 0, 1, 2, 2 } }, { VTK_QUAD, { 0, 1, 0, 1 } } }),
              1, Hybrid, lost)
              ->GetNumberOfCells(),
    0);
  EXPECT_EQ(lost->CountWarnings("Passed over 3 cells (the first is cell 0"), 1);
}

/// Hexahedra with any edges collapsed keep their volume, and are closed.
TEST(HybridInput, RandomCollapsedHexahedra)
{
  const int edges[12][2] = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 4, 5 }, { 5, 6 }, { 6, 7 },
    { 7, 4 }, { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } };
  std::mt19937 random(7);
  Types all;
  for (int round = 0; round < 300; ++round)
  {
    Ids p = { 0, 1, 2, 3, 4, 5, 6, 7 };
    for (int count = 1 + static_cast<int>(random() % 4); count > 0; --count)
    {
      const int* edge = edges[random() % 12];
      const vtkIdType from = p[edge[0]];
      const vtkIdType to = p[edge[1]];
      std::replace(p.begin(), p.end(), from, to);
    }
    const Grid input = MakeGrid(MakeCorners(), { { VTK_HEXAHEDRON, p } });
    const double volume = MeasureHexahedron(input, p);
    vtkNew<Messages> messages;
    const Grid output = Execute(input, round % 2, Linear, messages);
    EXPECT_TRUE(HasFlap(p) || std::abs(MeasureSolids(output) - volume) < 1e-14)
      << testing::PrintToString(p);
    EXPECT_TRUE(output->GetNumberOfCells() > 0 || !messages->Warnings.empty());
    ExpectFitting(output);
    for (const auto& type : CountTypes(output))
    {
      all[type.first] += type.second;
    }
  }
  EXPECT_EQ(all.size(), 3u) << "tetrahedra, pyramids, wedges";
}

TEST(HybridInput, PolyhedraPrismsAndPolygonsAreCut)
{
  for (const int type : { VTK_PENTAGONAL_PRISM, VTK_HEXAGONAL_PRISM })
  {
    vtkNew<vtkCellTypeSource> source;
    source->SetCellType(type);
    source->SetBlocksDimensions(2, 2, 2);
    source->Update();
    const Grid before = Execute(source->GetOutput(), 0, Linear, vtkNew<Messages>());
    vtkNew<Messages> messages;
    const Grid output = Execute(source->GetOutput(), 1, Linear, messages);
    EXPECT_EQ(
      messages->CountWarnings("8 cells (the first is cell 0, type " + std::to_string(type)), 1);
    const int corners = type == VTK_PENTAGONAL_PRISM ? 5 : 6;
    EXPECT_EQ(CountTypes(before),
      (Types{ { VTK_PYRAMID, 8 * corners }, { VTK_TETRA, 8 * 2 * (corners - 2) } }));
    EXPECT_NEAR(MeasureSolids(output), MeasureSolids(before), 1e-13);
    ExpectFitting(output);
  }
  const Grid polygons =
    MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 1, 0 }, { 1, 2, 0 }, { 0, 1, 0 }, { 2, 0, 0 } },
      { { VTK_POLYGON, { 0, 1, 2, 3, 4 } }, { VTK_TRIANGLE, { 1, 5, 2 } },
        { VTK_TRIANGLE_STRIP, { 0, 1, 4, 3 } } });
  vtkNew<Messages> messages;
  EXPECT_EQ(CountTypes(Execute(polygons, 1, Hybrid, messages)),
    (Types{ { VTK_TRIANGLE, 4 * (3 + 1 + 2) } }));
  EXPECT_TRUE(messages->Warnings.empty()) << messages->Warnings[0]; // as in other schemes
}

/// A centre is the mean of the corners, for points and arrays, and has the number that it has in
/// the whole mesh.
TEST(HybridInput, CentresAreMeans)
{
  vtkNew<vtkCellTypeSource> source;
  source->SetCellType(VTK_HEXAGONAL_PRISM);
  source->SetBlocksDimensions(1, 1, 1);
  source->Update();
  const Grid input = DeepCopy(vtkUnstructuredGrid::SafeDownCast(source->GetOutput()));
  vtkNew<vtkDoubleArray> values;
  values->SetName("x");
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(GetPoint(input, i)[0]);
  }
  input->GetPointData()->AddArray(values);
  const Grid output = Execute(input, 0, Linear, vtkNew<Messages>());
  ASSERT_EQ(output->GetNumberOfPoints(), input->GetNumberOfPoints() + 1);
  const Point centre = GetPoint(output, input->GetNumberOfPoints());
  Point mean{};
  const Ids ids = GetCell(input, 0);
  for (const vtkIdType id : ids)
  {
    for (int c = 0; c < 3; ++c)
    {
      mean[c] += GetPoint(input, id)[c] / static_cast<double>(ids.size());
    }
  }
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_NEAR(centre[c], mean[c], 1e-15);
  }
  EXPECT_NEAR(output->GetPointData()->GetArray("x")->GetComponent(input->GetNumberOfPoints(), 0),
    mean[0], 1e-15);
}

namespace
{

/// A cube, a pyramid on its left side, and a wedge behind, with their other quads free.
std::vector<Point> MakePlaces()
{
  return { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
    { 1, 1, 1 }, { 0, 1, 1 }, { 2, .5, .5 }, { .5, .5, 2 } };
}

}

/// Two tetrahedra, or two triangles, on a quad by either diagonal.
TEST(HybridInput, QuadsGiveWayToTriangles)
{
  const Ids quad = { 1, 2, 6, 5 }; // a side of the cube
  for (const int d : { 0, 1 })
  {
    const Ids first = { quad[d], quad[d + 1], quad[d + 2] };
    const Ids second = { quad[d + 2], quad[(d + 3) % 4], quad[d] };
    const Cell tets[2] = { { VTK_TETRA, { first[0], first[1], first[2], 8 } },
      { VTK_TETRA, { second[0], second[1], second[2], 8 } } };
    const Cell hex = { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } };
    const Cell pyramid = { VTK_PYRAMID, { 1, 5, 6, 2, 0 } };
    const Cell wedge = { VTK_WEDGE, { 2, 1, 9, 6, 5, 4 } };
    for (const Cell& cell : { hex, pyramid, wedge })
    {
      vtkNew<Messages> messages;
      const Grid start =
        Execute(MakeGrid(MakePlaces(), { tets[0], cell, tets[1] }), 0, Linear, messages);
      const Types expected = cell.Type == VTK_HEXAHEDRON
        ? Types{ { VTK_TETRA, 4 }, { VTK_PYRAMID, 5 } }
        : cell.Type == VTK_PYRAMID ? Types{ { VTK_TETRA, 4 } }
                                   : Types{ { VTK_TETRA, 2 + 2 + 2 }, { VTK_PYRAMID, 2 } };
      EXPECT_EQ(CountTypes(start), expected) << cell.Type;
      EXPECT_EQ(messages->CountWarnings("1 quad(s) lie against two triangles"), 1);
      EXPECT_EQ(messages->CountWarnings("The first is cell 1."), 1);
      const double volume = MeasureSolids(Execute(MakeGrid(MakePlaces(), { cell }), 0, Linear)) +
        MeasureSolids(MakeGrid(MakePlaces(), { tets[0], tets[1] }));
      EXPECT_NEAR(MeasureSolids(start), volume, 1e-14);
      for (const Configure& configure : { Linear, Hybrid })
      {
        const Grid output = Execute(
          MakeGrid(MakePlaces(), { tets[0], cell, tets[1] }), 1, configure, vtkNew<Messages>());
        ExpectFitting(output);
      }
    }
    // Triangles of a surface, too; and a quad of a surface on tetrahedra.
    vtkNew<Messages> messages;
    const Cell triangles[2] = { { VTK_TRIANGLE, first }, { VTK_TRIANGLE, second } };
    EXPECT_EQ(CountTypes(Execute(
                MakeGrid(MakePlaces(), { hex, triangles[0], triangles[1] }), 0, Hybrid, messages)),
      (Types{ { VTK_TETRA, 2 }, { VTK_PYRAMID, 5 }, { VTK_TRIANGLE, 2 } }));
    EXPECT_EQ(CountTypes(Execute(MakeGrid(MakePlaces(), { tets[0], tets[1], { VTK_QUAD, quad } }),
                0, Hybrid, messages)),
      (Types{ { VTK_TETRA, 2 }, { VTK_TRIANGLE, 2 } }));
    // One triangle is not enough, and two that are not halves of one quad neither.
    EXPECT_EQ(CountTypes(Execute(MakeGrid(MakePlaces(), { hex, tets[0] }), 0, Hybrid)),
      (Types{ { VTK_TETRA, 1 }, { VTK_HEXAHEDRON, 1 } }));
  }
}

/// Cells whose quads have the corners of other quads in another order, and wedges on the same
/// corners, are uncut and as each is alone.
TEST(HybridInput, CellsOnTheSameCornersKeepTheirTypes)
{
  const Cell hex = { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } };
  const Cell crossed = { VTK_QUAD, { 0, 2, 1, 3 } };
  const Grid quads = MakeGrid(MakeCorners(), { hex, crossed });
  EXPECT_EQ(Execute(quads, 1, Linear)->GetNumberOfPoints(), 8 + (12 + 2) + (6 + 1) + 1);
  const Cell wedge = { VTK_WEDGE, { 0, 2, 1, 4, 6, 5 } };
  const Cell turned = { VTK_WEDGE, { 0, 2, 1, 6, 5, 4 } };
  const Grid wedges = MakeGrid(MakeCorners(), { wedge, turned });
  EXPECT_EQ(Execute(wedges, 1, Linear)->GetNumberOfPoints(), 8 + (9 + 3) + (3 + 3));
  const Cell pyramid = { VTK_PYRAMID, { 0, 1, 2, 3, 4 } };
  const Cell folded = { VTK_PYRAMID, { 0, 2, 1, 3, 4 } };
  const Grid onQuads = MakeGrid(MakeCorners(), { pyramid, folded });
  EXPECT_EQ(Execute(onQuads, 1, Linear)->GetNumberOfPoints(), 8 + (8 + 2) + 2);
  const std::pair<Grid, std::pair<Cell, Cell>> cases[] = { { quads, { hex, crossed } },
    { wedges, { wedge, turned } }, { onQuads, { pyramid, folded } } };
  for (const auto& [input, cells] : cases)
  {
    vtkNew<Messages> messages;
    const Grid output = Execute(input, 3, Linear, messages);
    EXPECT_TRUE(messages->Warnings.empty());
    double volume = 0.;
    Types types;
    for (const Cell& cell : { cells.first, cells.second })
    {
      const Grid alone = Execute(MakeGrid(MakeCorners(), { cell }), 3, Linear);
      volume += MeasureSolids(alone);
      for (const auto& [type, count] : CountTypes(alone))
      {
        types[type] += count;
      }
    }
    EXPECT_NEAR(MeasureSolids(output), volume, 1e-13);
    EXPECT_EQ(CountTypes(output), types);
    EXPECT_EQ(CountTypes(Execute(input, 3, Hybrid, vtkNew<Messages>())), types);
  }
}

/// Centres have the order of their cells, also where some were there before others gave way.
TEST(HybridInput, CentresOfAllKinds)
{
  std::vector<Point> points = MakePlaces();
  const vtkIdType n = static_cast<vtkIdType>(points.size());
  for (int i = 0; i < 10; ++i)
  {
    points.push_back({ 5. + std::cos(i * 1.2566), std::sin(i * 1.2566), i / 5 * 1. });
  }
  const auto prism = [n](vtkIdType shift)
  {
    Cell cell = { VTK_PENTAGONAL_PRISM, {} };
    for (vtkIdType i = 0; i < 10; ++i)
    {
      cell.Points.push_back(n + i + shift);
    }
    return cell;
  };
  for (int i = 0; i < 10; ++i)
  {
    points.push_back({ 9. + std::cos(i * 1.2566), std::sin(i * 1.2566), i / 5 * 1. });
  }
  const Grid output =
    Execute(MakeGrid(points,
              { prism(0), { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } }, prism(10),
                { VTK_TETRA, { 1, 2, 6, 8 } }, { VTK_TETRA, { 6, 5, 1, 8 } } }),
      0, Linear, vtkNew<Messages>());
  ASSERT_EQ(output->GetNumberOfPoints(), static_cast<vtkIdType>(points.size()) + 3);
  const double xs[3] = { 5., .5, 9. };
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_NEAR(GetPoint(output, static_cast<vtkIdType>(points.size()) + c)[0], xs[c], 1e-3);
  }
}

/// Limits pass through the points of the input also where cells have centres.
TEST(HybridInput, CentresAreInterpolatedBetweenPoints)
{
  const Grid input = MakeGrid(MakeCorners(), { { VTK_HEXAHEDRON, { 0, 1, 2, 2, 4, 5, 6, 7 } } });
  vtkNew<Messages> messages;
  const Grid output = Execute(
    input, 1,
    [](Filter* filter)
    {
      filter->SetVolumeSchemeToHybrid();
      filter->ProjectToLimitOn();
      filter->InterpolatePointsOn();
    },
    messages);
  EXPECT_TRUE(messages->Errors.empty());
  for (const vtkIdType i : { 0, 1, 2, 4, 5, 6, 7 })
  {
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(GetPoint(output, i)[c], GetPoint(input, i)[c], 1e-9) << i;
    }
  }
  EXPECT_EQ(GetPoint(output, 3), GetPoint(input, 3)) << "no cell has it";
}
