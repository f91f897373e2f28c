// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestFeaturesSingular.cxx
 * Flagged and embedded simplices (Mathematics 4, 7), each line on the smallest complex that needs
 * it.
 */
#include "FeatureTools.h"

using namespace feature_tools;

namespace
{

const Configure Dart = [](Filter* filter) { filter->SetCreaseEndToDart(); };
const Configure Inside = [](Filter* filter) { filter->SetEmbeddedCellsToSingularInside(); };
const Configure All = [](Filter* filter) { filter->SetEmbeddedCellsToSingular(); };

/// The interior faces of the octahedron in the plane z = 0.
const std::vector<Cell> Plane = { { VTK_TRIANGLE, { 0, 1, 3 } }, { VTK_TRIANGLE, { 0, 3, 2 } },
  { VTK_TRIANGLE, { 0, 2, 4 } }, { VTK_TRIANGLE, { 4, 1, 0 } } };

std::vector<Cell> PlaneAnd(const std::vector<Cell>& more)
{
  std::vector<Cell> cells = Plane;
  cells.insert(cells.end(), more.begin(), more.end());
  return cells;
}

}

// ---------------------------------------------------------------- vertices and lines

TEST(FeaturesSingular, FlaggedVertexStays)
{
  const Matrix fan(MakeFlaggedFan(6, { { VTK_VERTEX, { 0 } }, { VTK_VERTEX, { 2 } } }));
  EXPECT_TRUE(Near(fan.Vertex(0), Corner(0)));
  EXPECT_TRUE(Near(fan.Vertex(2), Corner(2)));
  EXPECT_TRUE(Near(fan.Vertex(3), CurveVertex(3, 2, 4)));
  EXPECT_TRUE(Near(fan.Edge(0, 1), SurfaceEdge(0, 1, 2, 6)));
  const Matrix solid(MakeFlaggedOctahedron({ { VTK_POLY_VERTEX, { 0, 5 } } }));
  EXPECT_TRUE(Near(solid.Vertex(0), Corner(0)));
  EXPECT_TRUE(Near(solid.Vertex(5), Corner(5)));
  EXPECT_TRUE(Near(solid.Vertex(6), SurfaceVertex(6, { 1, 2, 3, 4 })));
}

TEST(FeaturesSingular, FlagsOfZeroChangeNothing)
{
  const std::vector<Cell> more = { { VTK_VERTEX, { 0 } }, { VTK_LINE, { 0, 1 } } };
  const Matrix fan(With(MakeFan(6, more), "Singular", std::vector<int>(8, 0)));
  EXPECT_TRUE(Near(fan.Vertex(0), SurfaceVertex(0, { 1, 2, 3, 4, 5, 6 })));
  EXPECT_TRUE(Near(fan.Edge(0, 1), SurfaceEdge(0, 1, 2, 6)));
}

TEST(FeaturesSingular, FlagsMayBeWholeFloatingPointNumbers)
{
  const Grid grid = MakeFlaggedFan(6, { { VTK_LINE, { 0, 1 } }, { VTK_LINE, { 4, 0 } } });
  vtkDataArray* given = grid->GetCellData()->GetArray("Singular");
  vtkNew<vtkDoubleArray> flags;
  flags->DeepCopy(given);
  flags->SetName("Singular");
  grid->GetCellData()->AddArray(flags);
  const Matrix fan(grid);
  EXPECT_TRUE(Near(fan.Vertex(0), CurveVertex(0, 1, 4)));
}

TEST(FeaturesSingular, TwoLinesAreACrease)
{
  const Matrix fan(MakeFlaggedFan(6, { { VTK_LINE, { 0, 1 } }, { VTK_LINE, { 4, 0 } } }));
  EXPECT_TRUE(Near(fan.Vertex(0), CurveVertex(0, 1, 4)));
  EXPECT_TRUE(Near(fan.Edge(0, 1), CurveEdge(0, 1)));
  EXPECT_TRUE(Near(fan.Edge(0, 4), CurveEdge(0, 4)));
  EXPECT_TRUE(Near(fan.Edge(0, 2), SurfaceEdge(0, 2, 1, 3)));
  EXPECT_TRUE(Near(fan.Vertex(1), Corner(1))); // ends on the boundary
  EXPECT_TRUE(Near(fan.Vertex(2), CurveVertex(2, 1, 3)));
  const Matrix solid(MakeFlaggedOctahedron({ { VTK_LINE, { 0, 1 } }, { VTK_LINE, { 5, 0 } } }));
  EXPECT_TRUE(Near(solid.Vertex(0), CurveVertex(0, 1, 5)));
  EXPECT_TRUE(Near(solid.Edge(0, 5), CurveEdge(0, 5)));
}

TEST(FeaturesSingular, ThreeLinesAreACorner)
{
  const Matrix fan(
    MakeFlaggedFan(6, { { VTK_LINE, { 0, 1 } }, { VTK_LINE, { 4, 0 } }, { VTK_LINE, { 0, 5 } } }));
  EXPECT_TRUE(Near(fan.Vertex(0), Corner(0)));
  EXPECT_TRUE(Near(fan.Edge(0, 5), CurveEdge(0, 5)));
  EXPECT_TRUE(Near(fan.Edge(0, 6), SurfaceEdge(0, 6, 1, 5)));
}

TEST(FeaturesSingular, CreaseAlongABoundaryIsTheBoundary)
{
  const Grid flagged = MakeFlaggedFan(6, { { VTK_LINE, { 1, 2 } }, { VTK_LINE, { 2, 3 } } });
  const Matrix fan(flagged);
  EXPECT_TRUE(Near(fan.Vertex(2), CurveVertex(2, 1, 3)));
  EXPECT_TRUE(Near(fan.Vertex(1), Corner(1)));
  // Exactly one crease, on a boundary curve: a corner for darts too.
  EXPECT_TRUE(Near(Matrix(flagged, Dart).Vertex(1), Corner(1)));
}

TEST(FeaturesSingular, WireWithoutOtherCells)
{
  const std::vector<Point> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  const std::vector<Cell> cells = { { VTK_LINE, { 0, 1 } }, { VTK_LINE, { 0, 2 } },
    { VTK_LINE, { 0, 3 } } };
  const Grid star = MakeGrid(points, cells);
  EXPECT_TRUE(Near(Matrix(star).Vertex(0), SolidVertex(0, { 1, 2, 3 }))); // Blend
  EXPECT_TRUE(Near(Matrix(With(star, "Singular", { 1, 1, 1 })).Vertex(0), Corner(0)));
  // Two of three: line 2 of Mathematics 4 comes before the joint.
  EXPECT_TRUE(Near(Matrix(With(star, "Singular", { 1, 0, 1 })).Vertex(0), CurveVertex(0, 1, 3)));
  EXPECT_TRUE(Near(Matrix(With(star, "Singular", { 0, 1, 0 })).Vertex(0), Corner(0)));
  EXPECT_TRUE(
    Near(Matrix(With(star, "Singular", { 0, 1, 0 }), Dart).Vertex(0), SolidVertex(0, { 1, 2, 3 })));
  // A flagged vertex, and a flagged maximal triangle by itself.
  const Grid triangle = MakeGrid(points, { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_VERTEX, { 3 } } });
  const Matrix single(With(triangle, "Singular", { 1, 1 }));
  EXPECT_TRUE(Near(single.Vertex(0), CurveVertex(0, 1, 2)));
  EXPECT_TRUE(Near(single.Edge(0, 1), CurveEdge(0, 1)));
  EXPECT_TRUE(Near(single.Vertex(3), Corner(3)));
}

// ---------------------------------------------------------------- crease ends

TEST(FeaturesSingular, EndOfACreaseInASurface)
{
  const Grid flagged = MakeFlaggedFan(6, { { VTK_LINE, { 0, 1 } } });
  EXPECT_TRUE(Near(Matrix(flagged).Vertex(0), Corner(0)));
  const Matrix dart(flagged, Dart);
  EXPECT_TRUE(Near(dart.Vertex(0), SurfaceVertex(0, { 1, 2, 3, 4, 5, 6 })));
  EXPECT_TRUE(Near(dart.Edge(0, 1), CurveEdge(0, 1)));
  EXPECT_TRUE(Near(dart.Vertex(1), Corner(1))); // on a boundary curve
}

TEST(FeaturesSingular, EndOfACreaseInASolid)
{
  const Grid flagged = MakeFlaggedOctahedron({ { VTK_LINE, { 0, 5 } } });
  EXPECT_TRUE(Near(Matrix(flagged).Vertex(0), Corner(0)));
  EXPECT_TRUE(Near(Matrix(flagged).Vertex(5), Corner(5)));
  const Matrix dart(flagged, Dart);
  EXPECT_TRUE(Near(dart.Vertex(0), SolidVertex(0, { 1, 2, 3, 4, 5, 6 })));
  EXPECT_TRUE(Near(dart.Vertex(5), SurfaceVertex(5, { 1, 2, 3, 4 }))); // a surface, no curve
  EXPECT_TRUE(Near(dart.Edge(0, 5), CurveEdge(0, 5)));
}

TEST(FeaturesSingular, EndOfACreaseInASingularSurface)
{
  const Grid flagged = MakeFlaggedOctahedron(PlaneAnd({ { VTK_LINE, { 0, 1 } } }));
  EXPECT_TRUE(Near(Matrix(flagged).Vertex(0), Corner(0)));
  const Matrix dart(flagged, Dart);
  EXPECT_TRUE(Near(dart.Vertex(0), SurfaceVertex(0, { 1, 2, 3, 4 })));
  EXPECT_TRUE(Near(dart.Edge(0, 1), CurveEdge(0, 1)));
  EXPECT_TRUE(Near(dart.Vertex(1), Corner(1))); // three creases
}

// ---------------------------------------------------------------- triangles

TEST(FeaturesSingular, ClosedFanOfTriangles)
{
  const Matrix matrix(MakeFlaggedOctahedron(Plane));
  EXPECT_TRUE(Near(matrix.Vertex(0), SurfaceVertex(0, { 1, 2, 3, 4 })));
  EXPECT_TRUE(Near(matrix.Edge(0, 1), SurfaceEdge(0, 1, 3, 4)));
  EXPECT_TRUE(Near(matrix.Edge(0, 3), SurfaceEdge(0, 3, 1, 2)));
  // Its border: one singular triangle at each edge.
  EXPECT_TRUE(Near(matrix.Edge(1, 3), CurveEdge(1, 3)));
  EXPECT_TRUE(Near(matrix.Vertex(1), CurveVertex(1, 3, 4)));
  // What is not on it.
  EXPECT_TRUE(Near(matrix.Vertex(5), SurfaceVertex(5, { 1, 2, 3, 4 })));
  EXPECT_TRUE(Near(matrix.Edge(1, 5), SurfaceEdge(1, 5, 3, 4)));
}

TEST(FeaturesSingular, ClosedFanOfThreeTriangles)
{
  const Matrix matrix(MakeFlaggedOctahedron({ { VTK_TRIANGLE, { 0, 1, 3 } },
    { VTK_TRIANGLE, { 0, 3, 5 } }, { VTK_TRIANGLE, { 0, 5, 1 } } }));
  EXPECT_TRUE(Near(matrix.Vertex(0), SurfaceVertex(0, { 1, 3, 5 })));
  EXPECT_TRUE(Near(matrix.Edge(0, 5), SurfaceEdge(0, 5, 1, 3)));
}

TEST(FeaturesSingular, TwoFansThatTouchAreACorner)
{
  const Matrix matrix(MakeFlaggedOctahedron({ { VTK_TRIANGLE, { 0, 1, 3 } },
    { VTK_TRIANGLE, { 0, 3, 5 } }, { VTK_TRIANGLE, { 0, 5, 1 } }, { VTK_TRIANGLE, { 0, 2, 4 } },
    { VTK_TRIANGLE, { 0, 4, 6 } }, { VTK_TRIANGLE, { 0, 6, 2 } } }));
  EXPECT_TRUE(Near(matrix.Vertex(0), Corner(0)));
  EXPECT_TRUE(Near(matrix.Edge(0, 1), SurfaceEdge(0, 1, 3, 5)));
  EXPECT_TRUE(Near(matrix.Edge(0, 6), SurfaceEdge(0, 6, 2, 4)));
}

TEST(FeaturesSingular, OneTriangleAtAnEdgeIsACrease)
{
  const Matrix matrix(MakeFlaggedOctahedron({ Plane[0], Plane[1], Plane[2] }));
  EXPECT_TRUE(Near(matrix.Edge(0, 1), CurveEdge(0, 1)));
  EXPECT_TRUE(Near(matrix.Edge(0, 4), CurveEdge(0, 4)));
  EXPECT_TRUE(Near(matrix.Edge(0, 2), SurfaceEdge(0, 2, 3, 4)));
  EXPECT_TRUE(Near(matrix.Vertex(0), CurveVertex(0, 1, 4)));
  EXPECT_TRUE(Near(matrix.Vertex(1), CurveVertex(1, 0, 3)));
}

TEST(FeaturesSingular, ThreeTrianglesAtAnEdgeAreACrease)
{
  const Matrix matrix(MakeFlaggedOctahedron(
    PlaneAnd({ { VTK_TRIANGLE, { 0, 1, 5 } }, { VTK_TRIANGLE, { 0, 5, 2 } } })));
  EXPECT_TRUE(Near(matrix.Edge(0, 1), CurveEdge(0, 1)));
  EXPECT_TRUE(Near(matrix.Edge(0, 2), CurveEdge(0, 2)));
  EXPECT_TRUE(Near(matrix.Edge(0, 5), SurfaceEdge(0, 5, 1, 2)));
  EXPECT_TRUE(Near(matrix.Edge(0, 3), SurfaceEdge(0, 3, 1, 2)));
  EXPECT_TRUE(Near(matrix.Vertex(0), CurveVertex(0, 1, 2)));
  EXPECT_TRUE(Near(matrix.Vertex(1), Corner(1)));            // 3, 4, 5 and 0
  EXPECT_TRUE(Near(matrix.Vertex(5), CurveVertex(5, 1, 2))); // 5-1 and 5-2
}

TEST(FeaturesSingular, ASingularLineOnASingularSurface)
{
  const Matrix matrix(
    MakeFlaggedOctahedron(PlaneAnd({ { VTK_LINE, { 0, 1 } }, { VTK_LINE, { 0, 2 } } })));
  EXPECT_TRUE(Near(matrix.Edge(0, 1), CurveEdge(0, 1)));
  EXPECT_TRUE(Near(matrix.Vertex(0), CurveVertex(0, 1, 2)));
}

// ---------------------------------------------------------------- flags of other cells

TEST(FeaturesSingular, PiecesOfOtherCellsAreFlagged)
{
  const Matrix line(MakeFlaggedFan(6, { { VTK_POLY_LINE, { 1, 0, 4 } } }));
  EXPECT_TRUE(Near(line.Vertex(0), CurveVertex(0, 1, 4)));
  const Matrix strip(MakeFlaggedOctahedron({ { VTK_TRIANGLE_STRIP, { 1, 0, 3, 2 } } }));
  EXPECT_TRUE(Near(strip.Edge(0, 3), SurfaceEdge(0, 3, 1, 2)));
  EXPECT_TRUE(Near(strip.Edge(0, 1), CurveEdge(0, 1)));
  EXPECT_TRUE(Near(strip.Edge(0, 2), CurveEdge(0, 2)));
  // The quad between two hexahedra.
  std::vector<Point> points;
  for (int i = 0; i < 12; ++i)
  {
    points.push_back({ double(i % 2), double(i / 2 % 2), double(i / 4) });
  }
  std::vector<Cell> cells = { { VTK_HEXAHEDRON, { 0, 1, 3, 2, 4, 5, 7, 6 } },
    { VTK_HEXAHEDRON, { 4, 5, 7, 6, 8, 9, 11, 10 } }, { VTK_QUAD, { 4, 5, 7, 6 } } };
  for (int type : { VTK_QUAD, VTK_PIXEL, VTK_POLYGON })
  {
    cells[2] = { type, type == VTK_PIXEL ? Ids{ 4, 5, 6, 7 } : Ids{ 4, 5, 7, 6 } };
    const Matrix quad(With(MakeGrid(points, cells), "Singular", { 0, 0, 1 }));
    EXPECT_TRUE(Near(quad.Vertex(4), CurveVertex(4, 5, 6))) << type;
    EXPECT_TRUE(Near(quad.Edge(4, 5), CurveEdge(4, 5))) << type;
    EXPECT_TRUE(Near(quad.Edge(4, 7), SurfaceEdge(4, 7, 5, 6))) << type;
  }
}

TEST(FeaturesSingular, FlagsOf3DCellsAreIgnoredWithOneWarning)
{
  std::vector<int> flags = { 0, 0, 1, 1, 0, 1, 0, 0, 1 };
  const Grid grid = MakeOctahedron({ { VTK_LINE, { 0, 5 } } });
  AddCellArray(grid, "Cracks", flags);
  vtkNew<Messages> messages;
  const Matrix matrix(grid, [](Filter* filter) { SetCellArray(filter, 0, "Cracks"); }, messages);
  ASSERT_EQ(messages->Warnings.size(), 1u);
  EXPECT_EQ(messages->Errors.size(), 0u);
  EXPECT_EQ(messages->CountWarnings("\"Cracks\""), 1);
  EXPECT_EQ(messages->CountWarnings("3 in all"), 1);
  EXPECT_EQ(messages->CountWarnings("cell 2"), 1);
  EXPECT_TRUE(Near(matrix.Edge(0, 5), CurveEdge(0, 5)));
  EXPECT_TRUE(Near(matrix.Edge(1, 5), SurfaceEdge(1, 5, 3, 4)));
  EXPECT_TRUE(Near(matrix.Vertex(6), SurfaceVertex(6, { 1, 2, 3, 4 })));
}

TEST(FeaturesSingular, AnyIntegerThatIsNotZero)
{
  const Grid grid = MakeFan(6, { { VTK_LINE, { 0, 1 } }, { VTK_LINE, { 0, 4 } } });
  AddCellArray<vtkUnsignedCharArray>(grid, "a", { 0, 0, 0, 0, 0, 0, 200, 1 });
  AddCellArray<vtkIdTypeArray>(grid, "b", { 0, 0, 0, 0, 0, 0, -7, 1 << 30 });
  AddCellArray<vtkBitArray>(grid, "c", { 0, 0, 0, 0, 0, 0, 1, 1 });
  for (const char* name : { "a", "b", "c" })
  {
    const Matrix matrix(grid, [name](Filter* filter) { SetCellArray(filter, 0, name); });
    EXPECT_TRUE(Near(matrix.Vertex(0), CurveVertex(0, 1, 4))) << name;
  }
}

// ---------------------------------------------------------------- embedded cells

TEST(FeaturesSingular, EmbeddedTriangles)
{
  const Grid plane = MakeOctahedron(Plane);
  EXPECT_TRUE(Near(Matrix(plane).Vertex(1), SurfaceVertex(1, { 3, 4, 5, 6 })));
  for (const Configure& rule : { Inside, All })
  {
    const Matrix matrix(plane, rule);
    EXPECT_TRUE(Near(matrix.Vertex(0), SurfaceVertex(0, { 1, 2, 3, 4 })));
    EXPECT_TRUE(Near(matrix.Vertex(1), CurveVertex(1, 3, 4)));
    EXPECT_TRUE(Near(matrix.Edge(0, 1), SurfaceEdge(0, 1, 3, 4)));
  }
  const Grid boundary = MakeOctahedron({ { VTK_TRIANGLE, { 1, 3, 5 } } });
  for (const Configure& rule : { Configure(), Inside })
  {
    const Matrix matrix(boundary, rule);
    EXPECT_TRUE(Near(matrix.Vertex(1), SurfaceVertex(1, { 3, 4, 5, 6 })));
    EXPECT_TRUE(Near(matrix.Edge(1, 3), SurfaceEdge(1, 3, 5, 6)));
  }
  const Matrix all(boundary, All);
  EXPECT_TRUE(Near(all.Vertex(1), CurveVertex(1, 3, 5)));
  EXPECT_TRUE(Near(all.Edge(1, 3), CurveEdge(1, 3)));
}

TEST(FeaturesSingular, EmbeddedLines)
{
  const Grid inSolid = MakeOctahedron({ { VTK_LINE, { 0, 5 } }, { VTK_LINE, { 6, 0 } } });
  EXPECT_TRUE(Near(Matrix(inSolid).Vertex(0), SolidVertex(0, { 1, 2, 3, 4, 5, 6 })));
  for (const Configure& rule : { Inside, All })
  {
    EXPECT_TRUE(Near(Matrix(inSolid, rule).Vertex(0), CurveVertex(0, 5, 6)));
    EXPECT_TRUE(Near(Matrix(inSolid, rule).Edge(0, 5), CurveEdge(0, 5)));
  }
  const Grid onSolid = MakeOctahedron({ { VTK_LINE, { 1, 5 } } });
  EXPECT_TRUE(Near(Matrix(onSolid, Inside).Edge(1, 5), SurfaceEdge(1, 5, 3, 4)));
  EXPECT_TRUE(Near(Matrix(onSolid, All).Edge(1, 5), CurveEdge(1, 5)));
  EXPECT_TRUE(Near(Matrix(onSolid, All).Vertex(1), Corner(1)));
  const Grid onSurface = MakeFan(6, { { VTK_LINE, { 0, 1 } }, { VTK_LINE, { 3, 4 } } });
  EXPECT_TRUE(Near(Matrix(onSurface).Edge(0, 1), SurfaceEdge(0, 1, 2, 6)));
  EXPECT_TRUE(Near(Matrix(onSurface, Inside).Edge(0, 1), CurveEdge(0, 1)));
  EXPECT_TRUE(Near(Matrix(onSurface, Inside).Vertex(3), CurveVertex(3, 2, 4)));
  EXPECT_TRUE(Near(Matrix(onSurface, All).Vertex(3), Corner(3)));
}

TEST(FeaturesSingular, EmbeddedVertices)
{
  const Grid inSolid = MakeOctahedron({ { VTK_VERTEX, { 0 } }, { VTK_VERTEX, { 5 } } });
  EXPECT_TRUE(Near(Matrix(inSolid).Vertex(0), SolidVertex(0, { 1, 2, 3, 4, 5, 6 })));
  EXPECT_TRUE(Near(Matrix(inSolid, Inside).Vertex(0), Corner(0)));
  EXPECT_TRUE(Near(Matrix(inSolid, Inside).Vertex(5), SurfaceVertex(5, { 1, 2, 3, 4 })));
  EXPECT_TRUE(Near(Matrix(inSolid, All).Vertex(5), Corner(5)));
  const Grid onSurface = MakeFan(5, { { VTK_VERTEX, { 0 } }, { VTK_VERTEX, { 1 } } });
  EXPECT_TRUE(Near(Matrix(onSurface, Inside).Vertex(0), Corner(0)));
  EXPECT_TRUE(Near(Matrix(onSurface, Inside).Vertex(1), CurveVertex(1, 2, 5)));
  EXPECT_TRUE(Near(Matrix(onSurface, All).Vertex(1), Corner(1)));
  const Grid onCurve = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 1, 0 } },
    { { VTK_VERTEX, { 1 } }, { VTK_LINE, { 0, 1 } }, { VTK_LINE, { 1, 2 } } });
  EXPECT_TRUE(Near(Matrix(onCurve).Vertex(1), CurveVertex(1, 0, 2)));
  EXPECT_TRUE(Near(Matrix(onCurve, Inside).Vertex(1), Corner(1)));
}

TEST(FeaturesSingular, EmbeddedCellsOnAJointFollow)
{
  // Three triangles at the edge 0 1, a line and a vertex on it.
  const std::vector<Point> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 0, -1, -1 }, { -1, 0, 0 } };
  const Grid book = MakeGrid(points,
    { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 0, 1, 3 } }, { VTK_TRIANGLE, { 0, 1, 4 } },
      { VTK_LINE, { 0, 1 } }, { VTK_VERTEX, { 1 } } });
  EXPECT_TRUE(Near(Matrix(book, Inside).Edge(0, 1), SolidEdge(0, 1, { 2, 3, 4 })));
  EXPECT_TRUE(Near(Matrix(book, Inside).Vertex(1), SolidVertex(1, { 0, 2, 3, 4 })));
  EXPECT_TRUE(Near(Matrix(book, All).Edge(0, 1), CurveEdge(0, 1)));
  EXPECT_TRUE(Near(Matrix(book, All).Vertex(1), Corner(1)));
  // Objects of different dimension: a closed fan with a line at its centre.
  const Grid mast = MakeFan(4, { { VTK_LINE, { 0, 5 } }, { VTK_VERTEX, { 0 } } });
  mast->GetPoints()->InsertNextPoint(0, 0, 2);
  EXPECT_TRUE(Near(Matrix(mast, Inside).Vertex(0), SolidVertex(0, { 1, 2, 3, 4, 5 })));
  EXPECT_TRUE(Near(Matrix(mast, Inside).Edge(0, 5), CurveEdge(0, 5))); // maximal: not embedded
  EXPECT_TRUE(Near(Matrix(mast, All).Vertex(0), Corner(0)));
  const Matrix alone(MakeGrid(points, { { VTK_LINE, { 0, 1 } }, { VTK_LINE, { 1, 2 } } }), All);
  EXPECT_TRUE(Near(alone.Vertex(1), CurveVertex(1, 0, 2)));
}
