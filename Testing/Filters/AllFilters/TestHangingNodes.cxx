// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestHangingNodes.cxx
 * Points that lie inside edges and faces of other cells are told. TestCloseHangingNodes.cxx has the
 * option that mends them.
 */
#include "HangingTools.h"

#include "vtkAdaptiveSurfaceSubdivision.h"
#include "vtkRedGreenRefinement.h"
#include "vtkSimplicialComplexTopology.h"
#include "vtkSurfaceSubdivision.h"

using namespace hanging_tools;

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
