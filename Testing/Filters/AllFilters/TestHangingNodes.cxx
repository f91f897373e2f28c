// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestHangingNodes.cxx
 * Points that lie inside edges and faces of other cells are told, and CloseHangingNodes cuts cells
 * so that all fit: no border is left inside, and areas and volumes stay.
 */
#include "FeatureTools.h"
#include "PartitionTools.h"

#include "Private/Reading/HangingNodes.h"
#include "Private/Uniform/UniformSubdivision.h"

#include "vtkAdaptiveSurfaceSubdivision.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"
#include "vtkRedGreenRefinement.h"
#include "vtkSimplicialComplexTopology.h"
#include "vtkSurfaceSubdivision.h"
#include "vtkTetra.h"
#include "vtkTriangle.h"

#include <map>

using namespace feature_tools;

namespace
{

const Configure Close = [](Filter* filter) { filter->CloseHangingNodesOn(); };

/// Collects cells by the places of their corners.
class Builder
{
public:
  vtkIdType Find(const Point& place)
  {
    const auto found = this->Ids.emplace(place, static_cast<vtkIdType>(this->Places.size()));
    if (found.second)
    {
      this->Places.push_back(place);
    }
    return found.first->second;
  }
  void Add(int type, const std::vector<Point>& places)
  {
    Cell cell{ type, {} };
    for (const Point& place : places)
    {
      cell.Points.push_back(this->Find(place));
    }
    this->Cells.push_back(cell);
  }
  /// An axis-parallel square or cube.
  void AddBox(int type, const Point& low, double side)
  {
    static const int corners[8][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 },
      { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
    std::vector<Point> places;
    for (int i = 0; i < (type == VTK_QUAD ? 4 : 8); ++i)
    {
      const int* c = corners[type == VTK_VOXEL && i % 4 > 1 ? i ^ 1 : i];
      places.push_back({ low[0] + side * c[0], low[1] + side * c[1], low[2] + side * c[2] });
    }
    this->Add(type, places);
  }
  Grid Make() const { return MakeGrid(this->Places, this->Cells); }

private:
  std::map<Point, vtkIdType> Ids;
  std::vector<Point> Places;
  std::vector<Cell> Cells;
};

/// Cubes (or squares) of a quadtree or octree that is refined towards the origin, `depth` times; as
/// a whole the cube from 0 to 2.
Grid MakeTree(int type, int depth)
{
  Builder builder;
  const int planes = type == VTK_QUAD ? 1 : 2;
  double side = 1.;
  for (int level = 0; level <= depth; ++level, side /= 2.)
  {
    for (int i = 0; i < 4 * planes; ++i)
    {
      const int at[3] = { i % 2, i / 2 % 2, i / 4 };
      if (i > 0 || level == depth)
      {
        builder.AddBox(type, { side * at[0], side * at[1], side * at[2] }, side);
      }
    }
  }
  return builder.Make();
}

double GetMeasure(vtkUnstructuredGrid* grid)
{
  double sum = 0.;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    const Ids ids = GetCell(grid, c);
    double x[4][3];
    for (std::size_t i = 0; i < ids.size() && i < 4; ++i)
    {
      grid->GetPoint(ids[i], x[i]);
    }
    sum += ids.size() == 4 ? vtkTetra::ComputeVolume(x[0], x[1], x[2], x[3])
      : ids.size() == 3    ? vtkTriangle::TriangleArea(x[0], x[1], x[2])
                           : 0.;
  }
  return sum;
}

/// The total length or area of the parts of the border of triangles or tetrahedra.
double GetBorder(vtkUnstructuredGrid* grid)
{
  std::map<Ids, int> uses;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    Ids ids = GetCell(grid, c);
    std::sort(ids.begin(), ids.end());
    for (std::size_t omitted = 0; omitted < ids.size(); ++omitted)
    {
      Ids part = ids;
      part.erase(part.begin() + static_cast<std::ptrdiff_t>(omitted));
      ++uses[part];
    }
  }
  double sum = 0.;
  for (const auto& [part, count] : uses)
  {
    double x[3][3];
    for (std::size_t i = 0; i < part.size(); ++i)
    {
      grid->GetPoint(part[i], x[i]);
    }
    const double size = part.size() == 3
      ? vtkTriangle::TriangleArea(x[0], x[1], x[2])
      : std::hypot(x[0][0] - x[1][0], x[0][1] - x[1][1], x[0][2] - x[1][2]);
    sum += count == 1 ? size : 0.;
  }
  return sum;
}

/// That the cells fit, have the measure and border that they had, and a value that is linear.
void ExpectClosed(const Grid& grid, double measure, double border)
{
  vtkNew<vtkDoubleArray> values;
  values->SetName("values");
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    const double* x = grid->GetPoint(i);
    values->InsertNextValue(x[0] + 2. * x[1] - x[2]);
  }
  grid->GetPointData()->AddArray(values);
  const Grid closed = Execute(grid, 0, Close);
  EXPECT_NEAR(GetMeasure(closed), measure, 1e-12);
  EXPECT_NEAR(GetBorder(closed), border, 1e-12);
  for (vtkIdType i = 0; i < closed->GetNumberOfPoints(); ++i)
  {
    const double* x = closed->GetPoint(i);
    const double value = closed->GetPointData()->GetArray("values")->GetComponent(i, 0);
    EXPECT_NEAR(value, x[0] + 2. * x[1] - x[2], 1e-12);
  }
  // No crack opens: new points of the border are on that of the level before, or near.
  const Grid fine = Execute(grid, 1, Close);
  EXPECT_LT(GetBorder(fine), border + 1e-12);
}

std::vector<std::string> Tell(vtkDataObject* input, int levels = 1, const Configure& configure = {})
{
  vtkNew<Messages> messages;
  Execute(input, levels, configure, messages);
  return messages->Warnings;
}

bool Has(const std::vector<std::string>& warnings, const std::string& part)
{
  return warnings.size() == 1 && warnings[0].find(part) != std::string::npos;
}

/// Two triangles beside an edge that has `size` points, and cells on the other side of it.
Grid MakeTJunction(int size)
{
  std::vector<Point> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 1, 0 }, { 0.5, -1, 0.2 } };
  std::vector<Cell> cells = { { VTK_TRIANGLE, { 0, 1, 2 } } };
  vtkIdType last = 0;
  for (int i = 1; i <= size; ++i)
  {
    points.push_back({ static_cast<double>(i) / (size + 1), 0, 0 });
    cells.push_back({ VTK_TRIANGLE, { 3 + i, last, 3 } });
    last = 3 + i;
  }
  cells.push_back({ VTK_TRIANGLE, { 1, last, 3 } });
  return MakeGrid(points, cells);
}

}

TEST(HangingNodes, AreCountedAndToldWithTheFirstCell)
{
  const auto warnings = Tell(MakeTree(VTK_QUAD, 1));
  EXPECT_TRUE(Has(warnings,
    "2 points hang: they lie inside an edge or a face of another cell (the "
    "first cell is 0, with point "));
  EXPECT_TRUE(Has(warnings, "Switch CloseHangingNodes on"));
  EXPECT_TRUE(Has(Tell(MakeTJunction(1)), "1 point hangs: it lies"));
  EXPECT_TRUE(Has(Tell(MakeTJunction(5)), "5 points hang"));
  EXPECT_TRUE(Has(Tell(MakeTree(VTK_HEXAHEDRON, 1)), "points hang"));
  EXPECT_TRUE(Tell(MakeTree(VTK_QUAD, 2), 1, Close).empty());
}

TEST(HangingNodes, OfAllFiltersThatSmooth)
{
  const auto tell = [](auto* filter, vtkDataObject* input)
  {
    vtkNew<Messages> messages;
    messages->Watch(filter);
    filter->SetInputDataObject(input);
    filter->Update();
    const bool isTold = Has(messages->Warnings, "2 points hang");
    messages->Warnings.clear();
    filter->CloseHangingNodesOn();
    filter->Update();
    return isTold && messages->Warnings.empty() && messages->Errors.empty();
  };
  const Grid quads = MakeTree(VTK_QUAD, 1);
  for (const int scheme : { vtkSurfaceSubdivision::LOOP, vtkSurfaceSubdivision::CATMULL_CLARK,
         vtkSurfaceSubdivision::DOO_SABIN, vtkSurfaceSubdivision::FOUR_EIGHT,
         vtkSurfaceSubdivision::SQRT_THREE })
  {
    vtkNew<vtkSurfaceSubdivision> filter;
    filter->SetScheme(scheme);
    EXPECT_TRUE(tell(filter.Get(), quads)) << scheme;
  }
  vtkNew<vtkSimplicialComplexTopology> topology;
  EXPECT_TRUE(tell(topology.Get(), quads));
  vtkNew<vtkAdaptiveSurfaceSubdivision> adaptive;
  EXPECT_TRUE(tell(adaptive.Get(), quads));
}

TEST(HangingNodes, NothingIsSaidOfWhatOnlyTouches)
{
  // A tip on an edge, and a tip on a face.
  EXPECT_TRUE(Tell(
    MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0.5, 0, 0 }, { 0, -1, 0 }, { 1, -1, 0 } },
      { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 3, 4, 5 } } }))
      .empty());
  // Flat cells, whose own points lie on their edges.
  EXPECT_TRUE(Tell(MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 0, 0 }, { 0, 0, 1 } },
                     { { VTK_TETRA, { 0, 1, 2, 3 } } }))
      .empty());
  EXPECT_TRUE(
    Tell(MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 0, 0 } }, { { VTK_TRIANGLE, { 0, 1, 2 } } }))
      .empty());
  // A point that is near an edge, not on it.
  EXPECT_TRUE(
    Tell(MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0.5, -0.01, 0 }, { 0, -1, 0 } },
           { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 0, 3, 4 } } }))
      .empty());
}

/// Points inside faces, none of whose edges has a point.
TEST(HangingNodes, InsideFaces)
{
  // A tetrahedron beside three, which share a point inside its face.
  const std::vector<Point> corners = { { 0, 0, 0 }, { 3, 0, 0 }, { 0, 3, 0 }, { 0, 0, 3 },
    { 1, 1, 0 }, { 0, 0, -3 } };
  EXPECT_TRUE(Has(Tell(MakeGrid(corners,
                    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 0, 4, 1, 5 } },
                      { VTK_TETRA, { 1, 4, 2, 5 } }, { VTK_TETRA, { 2, 4, 0, 5 } } })),
    "1 point hangs: it lies inside an edge or a face of another cell (the first cell is 0, with "
    "point 4)"));
  // A small cube on a large one.
  Builder cubes;
  cubes.AddBox(VTK_HEXAHEDRON, { 0, 0, 0 }, 3.);
  cubes.AddBox(VTK_HEXAHEDRON, { 0.6, 1, 3 }, 1.);
  EXPECT_TRUE(Has(Tell(cubes.Make()), "4 points hang"));
}

/// Walls that stand on floors: inside a face, along an edge that two faces share, across many.
TEST(HangingNodes, OfWallsOnFloors)
{
  const auto tell = [](double from, double to, double y, int wallCells)
  {
    Builder builder;
    for (int i = 0; i < 16; ++i)
    {
      builder.AddBox(VTK_QUAD, { double(i % 4), double(i / 4), 0. }, 1.);
    }
    for (int i = 0; i < wallCells; ++i)
    {
      const double a = from + (to - from) * i / wallCells;
      const double b = from + (to - from) * (i + 1) / wallCells;
      builder.Add(VTK_QUAD, { { a, y, 0 }, { b, y, 0 }, { b, y, 1 }, { a, y, 1 } });
    }
    const Grid grid = builder.Make();
    vtkNew<Messages> messages;
    vtkNew<vtkSurfaceSubdivision> surface;
    messages->Watch(surface);
    surface->SetInputDataObject(grid);
    surface->SetScheme(vtkSurfaceSubdivision::CATMULL_CLARK);
    surface->Update();
    std::vector<std::string> warnings = Tell(grid);
    EXPECT_EQ(warnings.size(), messages->Warnings.size());
    return warnings;
  };
  EXPECT_TRUE(Has(tell(1.2, 1.8, 1.3, 1), "2 points hang"));
  EXPECT_TRUE(Has(tell(1., 2., 1., 2), "1 point hangs"));
  EXPECT_TRUE(Has(tell(0.5, 3.5, 2.7, 5), "6 points hang"));
  EXPECT_TRUE(tell(1., 3., 2., 2).empty()); // it shares its points
}

TEST(HangingNodes, EndsOfLinesInsideFaces)
{
  const std::vector<Point> points = { { 0, 0, 0 }, { 3, 0, 0 }, { 0, 3, 0 }, { 0, 0, 3 },
    { 1, 1, 0 }, { 1, 1, -1 } };
  const Cell beam = { VTK_LINE, { 4, 5 } };
  EXPECT_TRUE(
    Has(Tell(MakeGrid(points, { { VTK_TRIANGLE, { 0, 1, 2 } }, beam })), "1 point hangs"));
  EXPECT_TRUE(
    Has(Tell(MakeGrid(points, { { VTK_TETRA, { 0, 1, 2, 3 } }, beam })), "1 point hangs"));
}

/// Red-green refinement tells of points on cells that it splits.
TEST(HangingNodes, OfRedGreenRefinement)
{
  const auto tell = [](const Grid& grid, double least)
  {
    vtkNew<vtkDoubleArray> x;
    x->SetName("x");
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    {
      x->InsertNextValue(grid->GetPoint(i)[0]);
    }
    grid->GetPointData()->AddArray(x);
    vtkNew<Messages> messages;
    vtkNew<vtkRedGreenRefinement> filter;
    messages->Watch(filter);
    filter->SetInputDataObject(grid);
    filter->RefineByAttributeErrorOff();
    filter->RefineByArrayRangeOn();
    filter->SetInputArrayToProcess(6, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "x");
    filter->SetArrayRange(least, 10.);
    filter->SetMaximumLevel(1);
    filter->Update();
    EXPECT_TRUE(messages->Errors.empty());
    return messages->Warnings;
  };
  EXPECT_TRUE(Has(tell(MakeTree(VTK_QUAD, 1), 0.), "2 points hang"));
  EXPECT_TRUE(Has(tell(MakeTree(VTK_HEXAHEDRON, 1), 0.), "12 points hang"));
  EXPECT_TRUE(Has(tell(MakeTJunction(3), 0.), "3 points hang"));
  // Nothing is split beside the points that hang.
  Builder builder;
  builder.AddBox(VTK_HEXAHEDRON, { 0, 0, 0 }, 1.);
  builder.AddBox(VTK_HEXAHEDRON, { 1, 0, 0 }, 0.5);
  for (int i = 3; i < 8; ++i)
  {
    builder.AddBox(VTK_HEXAHEDRON, { 0.5 * i, 0, 0 }, 0.5);
  }
  EXPECT_TRUE(tell(builder.Make(), 3.9).empty());
  EXPECT_TRUE(Has(tell(builder.Make(), 0.9), "3 points hang"));
}

TEST(HangingNodes, EndsOfLinesInsideOthers)
{
  const Grid lines = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 1, 0 }, { 0.5, 0, 0 }, { 0, 1, 0 } },
    { { VTK_POLY_LINE, { 0, 1, 2 } }, { VTK_LINE, { 3, 4 } } });
  EXPECT_TRUE(Has(Tell(lines), "1 point hangs"));
  const Grid closed = Execute(lines, 0, Close);
  EXPECT_EQ(GetEdges(closed),
    (std::set<std::pair<vtkIdType, vtkIdType>>{ { 0, 3 }, { 1, 3 }, { 1, 2 }, { 3, 4 } }));
}

/// A line of many edges that is winding, on one of which a second line ends, if at all, and another
/// one that comes back to itself.
TEST(HangingNodes, EndsOnLongLines)
{
  constexpr vtkIdType edges = 200;
  const auto tell = [](vtkIdType edge, bool comesBack)
  {
    std::vector<Point> points;
    std::vector<Cell> cells = { { VTK_POLY_LINE, {} },
      { VTK_POLY_LINE, { edges + 1, edges + 2 } } };
    for (vtkIdType i = 0; i <= edges; ++i)
    {
      const double t = 0.1 * static_cast<double>(i);
      points.push_back({ t, std::sin(t), std::cos(0.7 * t) });
      cells[0].Points.push_back(i);
    }
    const auto middle = [&points](vtkIdType i)
    {
      return Point{ 0.5 * (points[i][0] + points[i + 1][0]),
        0.5 * (points[i][1] + points[i + 1][1]), 0.5 * (points[i][2] + points[i + 1][2]) };
    };
    points.push_back(edge < 0 ? Point{ 3, 3, 3 } : middle(edge));
    points.push_back({ 5, 5, 5 });
    if (comesBack)
    {
      points.push_back(middle(100));
      cells[0].Points.push_back(edges + 3);
    }
    return Tell(MakeGrid(points, cells));
  };
  EXPECT_TRUE(tell(-1, false).empty());
  for (const vtkIdType edge : { 0, 31, 32, 150, 199 })
  {
    EXPECT_TRUE(Has(tell(edge, false), "1 point hangs")) << edge;
    EXPECT_TRUE(Has(tell(edge, true), "2 points hang")) << edge;
  }
}

TEST(CloseHangingNodes, Quadtrees)
{
  for (int depth = 1; depth < 5; ++depth)
  {
    ExpectClosed(MakeTree(VTK_QUAD, depth), 4., 8.);
  }
}

TEST(CloseHangingNodes, Octrees)
{
  for (int depth = 1; depth < 4; ++depth)
  {
    ExpectClosed(MakeTree(VTK_HEXAHEDRON, depth), 8., 24.);
    ExpectClosed(MakeTree(VTK_VOXEL, depth), 8., 24.);
  }
}

TEST(CloseHangingNodes, SeveralSizesBesideOneCube)
{
  // A cube beside 4 x 4 x 4 ones, of which some are cut once more.
  Builder builder;
  builder.AddBox(VTK_HEXAHEDRON, { 0, 0, 0 }, 1.);
  for (int i = 0; i < 64; ++i)
  {
    const Point low = { 1. + 0.25 * (i % 4), 0.25 * (i / 4 % 4), 0.25 * (i / 16) };
    if (i % 5)
    {
      builder.AddBox(VTK_HEXAHEDRON, low, 0.25);
      continue;
    }
    for (int k = 0; k < 8; ++k)
    {
      builder.AddBox(VTK_HEXAHEDRON,
        { low[0] + 0.125 * (k % 2), low[1] + 0.125 * (k / 2 % 2), low[2] + 0.125 * (k / 4) },
        0.125);
    }
  }
  ExpectClosed(builder.Make(), 2., 10.);
}

TEST(CloseHangingNodes, TrianglesAndPolygons)
{
  for (const int size : { 1, 2, 7 })
  {
    const Grid grid = MakeTJunction(size);
    const Grid closed = Execute(grid, 0, Close);
    EXPECT_EQ(closed->GetNumberOfCells(), 2 * (size + 1));
    EXPECT_NEAR(GetMeasure(closed), 0.5 + 0.5 * std::hypot(1., 0.2), 1e-12) << size;
  }
}

/// Wedges, pyramids and tetrahedra whose faces others cover.
TEST(CloseHangingNodes, OtherSolids)
{
  const Point top = { 0.5, 0.5, 2. };
  Builder builder;
  builder.Add(VTK_PYRAMID, { { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 }, top });
  for (int i = 0; i < 4; ++i)
  {
    builder.AddBox(VTK_HEXAHEDRON, { 0.5 * (i % 2), 0.5 * (i / 2), 0.5 }, 0.5);
  }
  const double side = 4. * 0.5 * std::hypot(1., 0.5);
  ExpectClosed(builder.Make(), 1. / 3. + 0.5, side + 2. + 1.);
  // A wedge below a triangle that is cut in four.
  Builder other;
  const std::vector<Point> at = { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 1, 0, 0 }, { 1, 1, 0 },
    { 0, 1, 0 } };
  const auto down = [](Point p) { return Point{ p[0], p[1], -1. }; };
  other.Add(VTK_WEDGE, { at[0], at[1], at[2], down(at[0]), down(at[1]), down(at[2]) });
  const Point tip = { 0.5, 0.5, 1. };
  for (const auto& t : std::vector<Ids>{ { 0, 3, 5 }, { 3, 1, 4 }, { 5, 4, 2 }, { 3, 4, 5 } })
  {
    other.Add(VTK_TETRA, { at[t[0]], at[t[1]], at[t[2]], tip });
  }
  const Grid grid = other.Make();
  const Grid closed = Execute(grid, 0, Close);
  EXPECT_NEAR(std::abs(GetMeasure(closed)), 2. + 2. / 3., 1e-12);
  EXPECT_TRUE(Tell(grid, 1, Close).empty());
}

TEST(CloseHangingNodes, CellsThatCannotBeCutAreCounted)
{
  // 2 x 2 beside 3 x 3.
  Builder builder;
  for (int i = 0; i < 4; ++i)
  {
    builder.AddBox(VTK_HEXAHEDRON, { -0.5, 0.5 * (i % 2), 0.5 * (i / 2) }, 0.5);
  }
  for (int i = 0; i < 9; ++i)
  {
    builder.AddBox(VTK_HEXAHEDRON, { 0., i % 3 / 3., i / 3 / 3. }, 1. / 3.);
  }
  EXPECT_TRUE(
    Has(Tell(builder.Make(), 1, Close), "cannot be cut so that they do (the first is cell 0)"));
}

/// A smooth surface has no crack where a mesh of quads is finer than that beside it.
TEST(CloseHangingNodes, NoCrackAfterThreeLevels)
{
  const Grid grid = MakeTree(VTK_QUAD, 2);
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    double x[3];
    grid->GetPoint(i, x);
    x[2] = 0.1 * x[0] * (2. - x[1]); // bilinear: points in the middle of an edge stay on it
    grid->GetPoints()->SetPoint(i, x);
  }
  const Grid fine = Execute(grid, 3, Close);
  int ends = 0;
  for (const auto& [a, b] : GetEdges(fine))
  {
    int uses = 0;
    double x[2][3];
    fine->GetPoint(a, x[0]);
    fine->GetPoint(b, x[1]);
    const bool isInside =
      std::all_of(&x[0][0], &x[0][0] + 2, [](double v) { return v > 0.2 && v < 1.8; });
    for (vtkIdType c = 0; isInside && c < fine->GetNumberOfCells(); ++c)
    {
      const Ids ids = GetCell(fine, c);
      uses += std::count(ids.begin(), ids.end(), a) && std::count(ids.begin(), ids.end(), b);
    }
    ends += isInside && uses != 2;
  }
  EXPECT_EQ(ends, 0);
}

TEST(CloseHangingNodes, AcrossBlocks)
{
  const Grid whole = MakeTree(VTK_HEXAHEDRON, 1);
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (const int part : { 0, 1 })
  {
    Builder builder;
    for (vtkIdType c = 0; c < whole->GetNumberOfCells(); ++c)
    {
      std::vector<Point> places;
      for (const vtkIdType id : GetCell(whole, c))
      {
        double x[3];
        whole->GetPoint(id, x);
        places.push_back({ x[0], x[1], x[2] });
      }
      if ((c < 7) == (part == 0))
      {
        builder.Add(VTK_HEXAHEDRON, places);
      }
    }
    blocks->SetBlock(part, builder.Make());
  }
  vtkNew<Filter> filter;
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetInputDataObject(blocks);
  filter->SetNumberOfLevels(1);
  filter->CloseHangingNodesOn();
  filter->Update();
  EXPECT_TRUE(messages->Warnings.empty());
  const Grid expected = Execute(whole, 1, Close);
  auto* made = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_EQ(made->GetNumberOfCells(), expected->GetNumberOfCells());
}

/// On ranks, cells fit to those of others.
TEST(CloseHangingNodes, PartitionsHaveWhatTheWholeHas)
{
  const Grid tree = MakeTree(VTK_HEXAHEDRON, 2);
  partition_tools::NumberCells(tree);
  subdivision::UniformOptions options;
  options.Levels = 2;
  options.Warn = [](const std::string& message) { ADD_FAILURE() << message; };
  options.Fail = options.Warn;
  subdivision::DistributionOptions distribution;
  distribution.Layers = 3;
  distribution.Change = [](vtkPointSet* mesh)
  {
    std::vector<std::string> warnings;
    auto closed = subdivision::CloseHangingNodes(mesh, warnings);
    EXPECT_TRUE(warnings.empty());
    return closed;
  };
  vtkNew<vtkUnstructuredGrid> whole;
  ASSERT_TRUE(subdivision::SubdivideUniformly(distribution.Change(tree), options, whole));
  for (const auto& partition : partition_tools::CommonPartitions)
  {
    std::vector<partition_tools::Mesh> outputs;
    ASSERT_TRUE(partition_tools::RunOnParts(
      partition_tools::Cut(tree, partition), partition, distribution, options,
      [&](vtkPointSet* mesh, vtkPointSet* made)
      {
        return subdivision::SubdivideUniformly(
          mesh, options, vtkUnstructuredGrid::SafeDownCast(made));
      },
      outputs));
    SCOPED_TRACE(partition.Name);
    partition_tools::ExpectWhole(whole, outputs);
  }
}
