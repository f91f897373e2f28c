// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestFeaturesDerived.cxx
 * Singular simplices that follow from materials and angles (Mathematics 7), and what they look like
 * after some levels: interfaces, holes, flat faces.
 */
#include "FeatureTools.h"

using namespace feature_tools;

namespace
{

const Configure Preserve = [](Filter* filter) { filter->PreserveInterfacesOn(); };

Configure Angle(double degrees)
{
  return [degrees](Filter* filter)
  {
    filter->DetectFeaturesOn();
    filter->SetFeatureAngle(degrees);
  };
}

/// Two triangles at the edge 0 1 that enclose an angle of 180 - `degrees`.
Grid MakeHinge(double degrees, int order = 0)
{
  const double t = degrees / 57.29577951308232;
  const Ids first[3] = { { 0, 1, 2 }, { 1, 0, 2 }, { 2, 0, 1 } };
  const Ids second[3] = { { 0, 1, 3 }, { 3, 0, 1 }, { 1, 0, 3 } };
  return MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0.3, 2, 0 }, { 0.8, -0.5 * std::cos(t), 0.5 * std::sin(t) } },
    { { VTK_TRIANGLE, first[order / 3] }, { VTK_TRIANGLE, second[order % 3] } });
}

double SignedVolume(const Point& a, const Point& b, const Point& c, const Point& d)
{
  const double u[3] = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
  const double v[3] = { c[0] - a[0], c[1] - a[1], c[2] - a[2] };
  const double w[3] = { d[0] - a[0], d[1] - a[1], d[2] - a[2] };
  return (u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
           u[2] * (v[0] * w[1] - v[1] * w[0])) /
    6.;
}

/// The faces of the tetrahedra of some cells that belong to one of them only, oriented outwards.
std::map<Ids, Ids> FindBoundary(const std::vector<Ids>& tets)
{
  const int faces[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };
  std::map<Ids, Ids> boundary;
  for (const Ids& tet : tets)
  {
    for (const auto& local : faces)
    {
      const Ids face = { tet[local[0]], tet[local[1]], tet[local[2]] };
      Ids key = face;
      std::sort(key.begin(), key.end());
      if (!boundary.erase(key))
      {
        boundary[key] = face;
      }
    }
  }
  return boundary;
}

double VolumeInside(vtkUnstructuredGrid* grid, const std::map<Ids, Ids>& boundary)
{
  double volume = 0.;
  for (const auto& face : boundary)
  {
    volume += SignedVolume({ 0.7, 0.4, 0.3 }, GetPoint(grid, face.second[0]),
      GetPoint(grid, face.second[1]), GetPoint(grid, face.second[2]));
  }
  return volume;
}

}

// ---------------------------------------------------------------- materials

TEST(FeaturesDerived, InterfaceInASolid)
{
  const Grid grid = With(MakeOctahedron(), "MaterialId", { 1, 1, 1, 1, 2, 2, 2, 2 });
  EXPECT_TRUE(Near(Matrix(grid).Vertex(0), SolidVertex(0, { 1, 2, 3, 4, 5, 6 })));
  const Matrix matrix(grid, Preserve);
  EXPECT_TRUE(Near(matrix.Vertex(0), SurfaceVertex(0, { 1, 2, 3, 4 })));
  EXPECT_TRUE(Near(matrix.Edge(0, 1), SurfaceEdge(0, 1, 3, 4)));
  EXPECT_TRUE(Near(matrix.Edge(1, 3), CurveEdge(1, 3)));
  EXPECT_TRUE(Near(matrix.Vertex(1), CurveVertex(1, 3, 4)));
  EXPECT_TRUE(Near(matrix.Vertex(5), SurfaceVertex(5, { 1, 2, 3, 4 })));
  const Grid one = With(MakeOctahedron(), "MaterialId", std::vector<int>(8, 4));
  EXPECT_TRUE(Near(Matrix(one, Preserve).Vertex(0), SolidVertex(0, { 1, 2, 3, 4, 5, 6 })));
}

TEST(FeaturesDerived, ThreeMaterialsAtAnEdgeOfASolid)
{
  const Grid grid = With(MakeOctahedron(), "MaterialId", { 1, 1, 2, 3, 1, 1, 2, 3 });
  const Matrix matrix(grid, Preserve);
  EXPECT_TRUE(Near(matrix.Edge(0, 5), CurveEdge(0, 5)));
  EXPECT_TRUE(Near(matrix.Vertex(0), CurveVertex(0, 5, 6)));
  EXPECT_TRUE(Near(matrix.Edge(0, 2), SurfaceEdge(0, 2, 5, 6)));
  EXPECT_TRUE(Near(matrix.Vertex(5), Corner(5))); // the seam and the three borders
  EXPECT_TRUE(Near(matrix.Vertex(1), CurveVertex(1, 5, 6)));
  EXPECT_TRUE(Near(matrix.Vertex(3), SurfaceVertex(3, { 1, 2, 5, 6 })));
}

TEST(FeaturesDerived, InterfacesOfSurfaces)
{
  const Matrix two(With(MakeFan(6), "MaterialId", { 1, 1, 1, 2, 2, 2 }), Preserve);
  EXPECT_TRUE(Near(two.Edge(0, 1), CurveEdge(0, 1)));
  EXPECT_TRUE(Near(two.Edge(0, 4), CurveEdge(0, 4)));
  EXPECT_TRUE(Near(two.Edge(0, 2), SurfaceEdge(0, 2, 1, 3)));
  EXPECT_TRUE(Near(two.Vertex(0), CurveVertex(0, 1, 4)));
  EXPECT_TRUE(Near(two.Vertex(1), Corner(1)));
  const Matrix three(With(MakeFan(6), "MaterialId", { 1, 1, 2, 2, 3, 3 }), Preserve);
  EXPECT_TRUE(Near(three.Vertex(0), Corner(0)));
  EXPECT_TRUE(Near(three.Edge(0, 3), CurveEdge(0, 3)));
  // Three triangles at an edge are a joint, whatever their materials are.
  const Grid book = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0, -1, -1 } },
    { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 0, 1, 3 } },
      { VTK_TRIANGLE, { 0, 1, 4 } } });
  const Matrix joint(With(book, "MaterialId", { 1, 2, 3 }), Preserve);
  EXPECT_TRUE(Near(joint.Edge(0, 1), SolidEdge(0, 1, { 2, 3, 4 })));
}

TEST(FeaturesDerived, FollowersAreNoMaterial)
{
  // Triangles on the boundary of a solid, and an equal tetrahedron.
  const Grid grid = MakeOctahedron({ { VTK_TRIANGLE, { 1, 3, 5 } }, { VTK_TRIANGLE, { 3, 2, 5 } },
    { VTK_TRIANGLE, { 0, 1, 3 } }, { VTK_TETRA, { 0, 1, 3, 5 } } });
  const Matrix matrix(With(grid, "MaterialId", { 1, 1, 1, 1, 1, 1, 1, 1, 2, 3, 4, 5 }), Preserve);
  EXPECT_TRUE(Near(matrix.Vertex(0), SolidVertex(0, { 1, 2, 3, 4, 5, 6 })));
  EXPECT_TRUE(Near(matrix.Edge(3, 5), SurfaceEdge(3, 5, 1, 2)));
  const Matrix equal(With(MakeFan(6, { { VTK_TRIANGLE, { 0, 2, 1 } }, { VTK_LINE, { 0, 1 } } }),
                       "MaterialId", { 1, 1, 1, 1, 1, 1, 2, 3 }),
    Preserve);
  EXPECT_TRUE(Near(equal.Vertex(0), SurfaceVertex(0, { 1, 2, 3, 4, 5, 6 })));
}

TEST(FeaturesDerived, InterfaceIsTheSurfaceByItself)
{
  // The interface of two materials moves like the surface of its triangles does without solids.
  const Grid box = MakeKuhnBox(3, 0.25);
  std::vector<int> materials;
  for (const Ids& tet : GetCells(box))
  {
    double height = 0.;
    for (vtkIdType v : tet)
    {
      height += static_cast<double>(v / 16);
    }
    materials.push_back(height > 6.);
  }
  const Grid solid = With(box, "MaterialId", materials);
  auto interface = [](vtkUnstructuredGrid* grid)
  {
    std::vector<Ids> sides[2];
    vtkDataArray* values = grid->GetCellData()->GetArray("MaterialId");
    for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
    {
      sides[static_cast<int>(values->GetTuple1(i))].push_back(GetCell(grid, i));
    }
    const auto lower = FindBoundary(sides[0]);
    std::vector<Ids> faces;
    for (const auto& face : FindBoundary(sides[1]))
    {
      if (lower.count(face.first))
      {
        faces.push_back(face.first);
      }
    }
    return faces;
  };
  std::vector<Point> points;
  for (vtkIdType i = 0; i < box->GetNumberOfPoints(); ++i)
  {
    points.push_back(GetPoint(box, i));
  }
  std::vector<Cell> triangles;
  for (const Ids& face : interface(solid))
  {
    triangles.push_back({ VTK_TRIANGLE, face });
  }
  ASSERT_GT(triangles.size(), 17u);
  const Grid alone = Execute(MakeGrid(points, triangles), 3);
  const Grid both = Execute(solid, 3, Preserve);
  auto corners = [](vtkUnstructuredGrid* grid, const std::vector<Ids>& cells)
  {
    std::set<vtkIdType> used;
    for (const Ids& cell : cells)
    {
      used.insert(cell.begin(), cell.end());
    }
    std::vector<Point> list;
    for (vtkIdType i : used)
    {
      list.push_back(GetPoint(grid, i));
    }
    return list;
  };
  const std::vector<Ids> fine = interface(both);
  EXPECT_EQ(fine.size(), 64 * triangles.size());
  const std::vector<Point> a = corners(alone, GetCells(alone));
  const std::vector<Point> b = corners(both, fine);
  ASSERT_EQ(a.size(), b.size());
  for (const Point& p : a)
  {
    double nearest = 1.;
    for (const Point& q : b)
    {
      nearest =
        std::min(nearest, std::abs(p[0] - q[0]) + std::abs(p[1] - q[1]) + std::abs(p[2] - q[2]));
    }
    ASSERT_LE(nearest, 1e-13);
  }
}

TEST(FeaturesDerived, VolumesOnBothSides)
{
  const Grid box = MakeKuhnBox(3, 0.3, 9);
  std::mt19937 random(4);
  std::vector<int> materials;
  for (vtkIdType i = 0; i < box->GetNumberOfCells(); ++i)
  {
    materials.push_back(static_cast<int>(i / 6 % 2 + (random() % 3 == 0)));
  }
  const Grid solid = With(box, "MaterialId", materials);
  const Grid fine = Execute(solid, 3,
    [](Filter* filter)
    {
      filter->PreserveInterfacesOn();
      filter->GenerateOriginalIdsOn();
    });
  ASSERT_EQ(fine->GetNumberOfCells(), 512 * box->GetNumberOfCells());
  vtkDataArray* original = fine->GetCellData()->GetArray("vtkOriginalCellIds");
  vtkDataArray* values = fine->GetCellData()->GetArray("MaterialId");
  std::vector<Ids> ofMaterial[3];
  double volumes[3] = {};
  for (vtkIdType i = 0; i < fine->GetNumberOfCells(); ++i)
  {
    const auto ancestor = static_cast<std::size_t>(original->GetTuple1(i));
    ASSERT_EQ(static_cast<vtkIdType>(ancestor), i / 512);
    ASSERT_EQ(values->GetTuple1(i), materials[ancestor]);
    const Ids tet = GetCell(fine, i);
    ofMaterial[materials[ancestor]].push_back(tet);
    volumes[materials[ancestor]] += SignedVolume(GetPoint(fine, tet[0]), GetPoint(fine, tet[1]),
      GetPoint(fine, tet[2]), GetPoint(fine, tet[3]));
  }
  double total = 0.;
  std::size_t faces = 0;
  for (int m = 0; m < 3; ++m)
  {
    const auto boundary = FindBoundary(ofMaterial[m]);
    faces += boundary.size();
    EXPECT_NEAR(VolumeInside(fine, boundary) / volumes[m], 1., 1e-12);
    total += volumes[m];
  }
  const auto outside = FindBoundary(GetCells(fine));
  EXPECT_NEAR(VolumeInside(fine, outside) / total, 1., 1e-12);
  EXPECT_EQ(outside.size(), 64u * 6 * 2 * 9);
  // Each child of an interface triangle is on the boundary of exactly two materials.
  std::map<Ids, int> sides;
  std::size_t coarse = 0;
  std::vector<Ids> input[3];
  for (vtkIdType i = 0; i < box->GetNumberOfCells(); ++i)
  {
    input[materials[i]].push_back(GetCell(box, i));
  }
  for (const auto& cells : input)
  {
    coarse += FindBoundary(cells).size();
  }
  EXPECT_EQ(faces, 64 * coarse);
}

// ---------------------------------------------------------------- angles

TEST(FeaturesDerived, AngleBetweenTriangles)
{
  for (double degrees : { 10., 30., 90., 150. })
  {
    for (int order = 0; order < 9; ++order)
    {
      const Grid hinge = MakeHinge(degrees, order);
      EXPECT_TRUE(Near(Matrix(hinge).Edge(0, 1), SurfaceEdge(0, 1, 2, 3)));
      const Matrix above(hinge, Angle(degrees - 1e-6));
      EXPECT_TRUE(Near(above.Edge(0, 1), CurveEdge(0, 1))) << degrees << " " << order;
      EXPECT_TRUE(Near(above.Vertex(0), Corner(0)));
      const Matrix below(hinge, Angle(degrees + 1e-6));
      EXPECT_TRUE(Near(below.Edge(0, 1), SurfaceEdge(0, 1, 2, 3))) << degrees << " " << order;
      EXPECT_TRUE(Near(below.Vertex(0), CurveVertex(0, 2, 3))); // the border is no feature
    }
  }
  EXPECT_TRUE(Near(Matrix(MakeHinge(30.01), [](Filter* f) { f->DetectFeaturesOn(); }).Edge(0, 1),
    CurveEdge(0, 1)));
  EXPECT_TRUE(Near(Matrix(MakeHinge(29.99), [](Filter* f) { f->DetectFeaturesOn(); }).Edge(0, 1),
    SurfaceEdge(0, 1, 2, 3)));
}

TEST(FeaturesDerived, AngleOnTheBoundaryOfASolid)
{
  const Grid tet = MakeGrid({ { 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 } },
    { { VTK_TETRA, { 0, 1, 2, 3 } } });
  const double regular = 180. - 70.528779365509308;
  const Matrix above(tet, Angle(regular - 1e-6));
  const Matrix below(tet, Angle(regular + 1e-6));
  for (vtkIdType v = 0; v < 4; ++v)
  {
    EXPECT_TRUE(Near(above.Vertex(v), Corner(v)));
    Ids ring = { 0, 1, 2, 3 };
    ring.erase(ring.begin() + v);
    EXPECT_TRUE(Near(below.Vertex(v), SurfaceVertex(v, ring)));
  }
  EXPECT_TRUE(Near(above.Edge(1, 3), CurveEdge(1, 3)));
  EXPECT_TRUE(Near(below.Edge(1, 3), SurfaceEdge(1, 3, 0, 2)));
  // A cube: twelve edges, eight corners; diagonals and what is inside are smooth.
  const Grid box = MakeKuhnBox(2);
  const Matrix cube(box, Angle(30.));
  EXPECT_TRUE(Near(cube.Vertex(0), Corner(0)));
  EXPECT_TRUE(Near(cube.Vertex(1), CurveVertex(1, 0, 2)));
  EXPECT_TRUE(Near(cube.Edge(0, 1), CurveEdge(0, 1)));
  EXPECT_TRUE(Near(cube.Edge(0, 4), SurfaceEdge(0, 4, 1, 3)));
  EXPECT_TRUE(Near(cube.Vertex(4), SurfaceVertex(4, { 0, 1, 3, 5, 7, 8 })));
  EXPECT_EQ(cube.Vertex(13).size(), 15u);
}

TEST(FeaturesDerived, TrianglesWithoutSizeHaveNoAngle)
{
  const Grid grid = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 1, 0 }, { 0.25, 0, 0 } },
    { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 1, 0, 3 } } });
  EXPECT_TRUE(Near(Matrix(grid, Angle(30.)).Edge(0, 1), SurfaceEdge(0, 1, 2, 3)));
}

TEST(FeaturesDerived, AnglesAreThoseOfTheInput)
{
  // The second filter finds nothing by itself, and forgets nothing.
  const Grid hinge = MakeHinge(60.);
  const Grid two = Execute(hinge, 2, Angle(30.));
  EXPECT_EQ(Compare(two, Execute(Execute(hinge, 1, Angle(30.)), 1, Angle(30.))), "");
  EXPECT_EQ(Compare(two, Execute(Execute(hinge, 1, Angle(30.)), 1)), "");
  EXPECT_NE(Compare(two, Execute(Execute(hinge, 1), 1, Angle(30.)), false), "");
}

// ---------------------------------------------------------------- shapes

TEST(FeaturesDerived, HoleOfEightCreaseEdges)
{
  // A plate around a tube: the rim of eight edges is a crease.
  const int n = 8;
  std::vector<Point> points;
  std::vector<Cell> cells;
  for (int ring = 0; ring < 3; ++ring) // outer border, rim, lower end of the tube
  {
    for (int i = 0; i < n; ++i)
    {
      const double t = 6.283185307179586 * i / n;
      const double r = ring == 0 ? 3. : 1.;
      points.push_back({ r * std::cos(t), r * std::sin(t), ring == 2 ? -1. : 0. });
    }
  }
  for (vtkIdType ring = 0; ring < 2; ++ring)
  {
    for (vtkIdType i = 0; i < n; ++i)
    {
      const vtkIdType a = ring * n + i;
      const vtkIdType b = ring * n + (i + 1) % n;
      cells.push_back({ VTK_TRIANGLE, { a, b, a + n } });
      cells.push_back({ VTK_TRIANGLE, { b, b + n, a + n } });
    }
  }
  std::vector<int> flags(cells.size(), 0);
  for (vtkIdType i = 0; i < n; ++i)
  {
    cells.push_back({ VTK_LINE, { n + i, n + (i + 1) % n } });
    flags.push_back(1);
  }
  const Grid grid = With(MakeGrid(points, cells), "Singular", flags);
  const double limitRadius = 4. / 6 + 2. / 6 * std::cos(6.283185307179586 / n);
  for (int level = 1; level <= 5; ++level)
  {
    const Grid fine = Execute(grid, level);
    std::vector<vtkIdType> rim; // in order along the curve
    const int pieces = n << level;
    for (vtkIdType i = fine->GetNumberOfCells() - pieces; i < fine->GetNumberOfCells(); ++i)
    {
      ASSERT_EQ(fine->GetCellType(i), VTK_LINE);
      rim.push_back(GetCell(fine, i)[0]);
      EXPECT_EQ(GetPoint(fine, rim.back())[2], 0.);
    }
    for (int i = 0; i < pieces; ++i)
    {
      const Point p = GetPoint(fine, rim[i]);
      const Point before = GetPoint(fine, rim[(i + pieces - 1) % pieces]);
      const Point after = GetPoint(fine, rim[(i + 1) % pieces]);
      // The uniform cubic B-spline of the eight control points, at i / 2^level.
      const int first = i >> level;
      const double s = (i - (first << level)) / double(1 << level);
      const double basis[4] = { (1 - s) * (1 - s) * (1 - s) / 6,
        (3 * s * s * s - 6 * s * s + 4) / 6, (-3 * s * s * s + 3 * s * s + 3 * s + 1) / 6,
        s * s * s / 6 };
      for (int k = 0; k < 2; ++k)
      {
        double spline = 0.;
        for (int j = 0; j < 4; ++j)
        {
          spline += basis[j] * points[n + (first + j + n - 1) % n][k];
        }
        EXPECT_NEAR((before[k] + 4 * p[k] + after[k]) / 6, spline, 1e-14);
        EXPECT_NEAR(p[k], spline, 0.25 * std::pow(0.25, level));
      }
      if (s == 0.)
      {
        EXPECT_NEAR(
          std::hypot((before[0] + 4 * p[0] + after[0]) / 6, (before[1] + 4 * p[1] + after[1]) / 6),
          limitRadius, 1e-14);
      }
    }
  }
}

TEST(FeaturesDerived, FlaggedFlatFaceStaysFlat)
{
  const int n = 3;
  const Grid box = MakeKuhnBox(n, 0.2, 6);
  std::vector<Point> points;
  std::vector<Cell> cells;
  for (vtkIdType i = 0; i < box->GetNumberOfPoints(); ++i)
  {
    points.push_back(GetPoint(box, i));
    if (i >= n * 16)
    {
      points.back()[2] = 0.1 * points.back()[0] + 0.3 * points.back()[1] + n;
    }
  }
  std::vector<int> flags;
  for (const Ids& tet : GetCells(box))
  {
    cells.push_back({ VTK_TETRA, tet });
    flags.push_back(0);
  }
  for (const auto& face : FindBoundary(GetCells(box)))
  {
    if (face.first[0] >= n * 16)
    {
      cells.push_back({ VTK_TRIANGLE, face.second });
      flags.push_back(1);
    }
  }
  auto deviation = [](vtkUnstructuredGrid* grid)
  {
    double largest = 0.;
    for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
    {
      for (vtkIdType v : GetCell(grid, i))
      {
        const Point p = GetPoint(grid, v);
        largest = grid->GetCellType(i) == VTK_TRIANGLE
          ? std::max(largest, std::abs(p[2] - 0.1 * p[0] - 0.3 * p[1] - 3.))
          : largest;
      }
    }
    return largest;
  };
  const Grid grid = MakeGrid(points, cells);
  EXPECT_GT(deviation(Execute(grid, 2)), 0.01);
  EXPECT_LE(deviation(Execute(With(grid, "Singular", flags), 2)), 1e-14);
  EXPECT_LE(deviation(Execute(With(grid, "Singular", flags), 3)), 1e-14);
}
