// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSubdivisionDeformationPlanes.cxx
 * Control meshes of polygons in a plane, smoothed by Catmull-Clark.
 */
#include "SubdivisionDeformationTools.h"

#include "vtkSurfaceSubdivision.h"

using namespace deformation_tools;

namespace
{

Point BendInPlane(const Point& x)
{
  return { x[0] + 0.1 * std::sin(x[1]), x[1] + 0.05 * x[0] * x[0], x[2] };
}

/// A square of n x n unit quads in the plane z = 0.5. With `mixed` points inside are moved, a quad
/// is two triangles, and two quads are a hexagon.
Grid MakeCage(int n, bool mixed, const std::vector<Cell>& more = {})
{
  std::mt19937 random(3);
  auto shift = [&] { return mixed ? 0.3 * (random() / 4294967296. - 0.5) : 0.; };
  std::vector<Point> points;
  std::vector<Cell> cells;
  for (vtkIdType j = 0; j <= n; ++j)
  {
    for (vtkIdType i = 0; i <= n; ++i)
    {
      const bool inside = i > 0 && j > 0 && i < n && j < n;
      const double x = inside ? shift() : 0.;
      const double y = inside ? shift() : 0.;
      points.push_back({ i + x, j + y, 0.5 });
      const vtkIdType a = j * (n + 1) + i;
      const vtkIdType b = a + n + 1;
      if (i == n || j == n || (mixed && j == 2 && i == 2))
      {
        continue;
      }
      if (mixed && j == 1 && i == 1)
      {
        cells.push_back({ VTK_TRIANGLE, { a, a + 1, b } });
        cells.push_back({ VTK_TRIANGLE, { b, a + 1, b + 1 } });
      }
      else if (mixed && j == 2 && i == 1)
      {
        cells.push_back({ VTK_POLYGON, { a, a + 1, a + 2, b + 2, b + 1, b } });
      }
      else
      {
        cells.push_back({ VTK_QUAD, { a, a + 1, b + 1, b } });
      }
    }
  }
  cells.insert(cells.end(), more.begin(), more.end());
  return MakeGrid(points, cells);
}

/// The cage as the surface filter subdivides it, with what it makes of the points of `bent` as an
/// array, so that the rules are those of the cage.
vtkSmartPointer<vtkPolyData> Subdivide(
  vtkUnstructuredGrid* cage, vtkUnstructuredGrid* bent, int levels)
{
  const Grid carried = DeepCopy(cage);
  vtkNew<vtkDoubleArray> points;
  points->DeepCopy(bent->GetPoints()->GetData());
  points->SetName("bent");
  carried->GetPointData()->AddArray(points);
  vtkNew<vtkSurfaceSubdivision> filter;
  filter->SetInputData(carried);
  filter->SetSchemeToCatmullClark();
  filter->SetNumberOfLevels(levels);
  if (cage->GetCellData()->HasArray("s"))
  {
    filter->SetInputArrayToProcess(4, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "s");
  }
  filter->Update();
  auto output = vtkSmartPointer<vtkPolyData>::New();
  output->ShallowCopy(filter->GetOutput());
  return output;
}

/// The largest difference to the array "bent" of the input.
double GetErrorOfBent(vtkPointSet* result, vtkPointSet* input)
{
  vtkDataArray* bent = input->GetPointData()->GetArray("bent");
  double largest = 0.;
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      const double error = std::abs(GetPoint(result, i)[c] - bent->GetComponent(i, c));
      largest = error <= largest ? largest : error; // NaN counts
    }
  }
  return largest;
}

/// A filter for surfaces of Catmull-Clark that may leave no point outside.
void Prepare(Deformer& filter, int levels)
{
  filter->SetSurfaceSchemeToCatmullClark();
  filter->SetNumberOfLevels(levels);
  filter->SetOutsidePointsToError();
}

}

TEST(SubdivisionDeformationPlanes, PointsFollowTheSubdividedCage)
{
  const Grid cage = MakeCage(5, true);
  const Grid bent = Moved(cage, BendInPlane);
  for (int levels = 0; levels <= 3; ++levels)
  {
    SCOPED_TRACE(levels);
    const auto object = Subdivide(cage, bent, levels);
    Deformer filter;
    Prepare(filter, levels);
    const auto moved = filter.Run(object, cage, bent);
    EXPECT_TRUE(filter.WasSilent());
    EXPECT_LT(GetErrorOfBent(moved, object), 1e-12);
    // The same cage as polygons of vtkPolyData gives the same bits.
    vtkNew<vtkSurfaceSubdivision> none;
    none->SetSchemeToCatmullClark();
    none->SetNumberOfLevels(0);
    none->SetInputData(cage);
    none->Update();
    vtkNew<vtkPolyData> polygons;
    polygons->DeepCopy(none->GetOutput());
    polygons->GetFieldData()->Initialize();
    vtkNew<vtkPolyData> others;
    others->DeepCopy(polygons);
    others->SetPoints(bent->GetPoints());
    EXPECT_EQ(ComparePoints(filter.Run(object, polygons, others), moved), "");
    EXPECT_TRUE(filter.WasSilent());
  }
}

TEST(SubdivisionDeformationPlanes, AffineMapsAreKept)
{
  const Grid cage = MakeCage(5, true);
  const Grid cloud = MakeCloud(300, { 0., 0., 0.5 }, { 5., 5., 0.5 }, 2);
  for (int levels = 0; levels <= 4; ++levels)
  {
    Deformer filter;
    Prepare(filter, levels);
    EXPECT_LT(GetLargestError(filter.Run(cloud, cage, Moved(cage, Affine)), cloud, Affine), 1e-12);
    EXPECT_TRUE(filter.WasSilent()) << levels;
  }
}

TEST(SubdivisionDeformationPlanes, AMovedVertexMovesPointsByItsSpline)
{
  // The shift of a point of a regular cage is a tensor product of cubic B-splines.
  const Grid cage = MakeCage(8, false);
  const Point by{ 0.2, 0.1, -0.4 };
  const Grid bent = DeepCopy(cage);
  const vtkIdType middle = 4 * 9 + 4;
  bent->GetPoints()->SetPoint(middle, 4. + by[0], 4. + by[1], 0.5 + by[2]);
  auto spline = [](double t)
  {
    t = std::abs(t);
    return t < 1. ? (4. - 6. * t * t + 3. * t * t * t) / 6.
      : t < 2.    ? (2. - t) * (2. - t) * (2. - t) / 6.
                  : 0.;
  };
  auto move = [&](const Point& x)
  {
    const double part = spline(x[0] - 4.) * spline(x[1] - 4.);
    return Point{ x[0] + part * by[0], x[1] + part * by[1], x[2] + part * by[2] };
  };
  const Grid cloud = MakeCloud(500, { 1., 1., 0.5 }, { 7., 7., 0.5 }, 5);
  Deformer filter;
  double errors[5];
  for (int levels : { 2, 3, 4 })
  {
    Prepare(filter, levels);
    errors[levels] = GetLargestError(filter.Run(cloud, cage, bent), cloud, move);
  }
  // Linear on cells of width 2^-levels: a quarter of the error with each level.
  EXPECT_LT(errors[4], 2e-3);
  EXPECT_LT(errors[3], 0.35 * errors[2]);
  EXPECT_LT(errors[4], 0.35 * errors[3]);
  filter->SetSurfaceSchemeToLoop(); // prefers one diagonal
  EXPECT_GT(GetLargestError(filter.Run(cloud, cage, bent), cloud, move), 1e-2);
  // Slopes along a line through the vertex change little from sample to sample.
  Prepare(filter, 4);
  const double step = 1. / 16.;
  std::vector<Point> points;
  std::vector<Cell> cells;
  for (vtkIdType i = 0; i <= 96; ++i)
  {
    points.push_back({ 1. + i * step, 4.1, 0.5 });
    cells.push_back({ VTK_VERTEX, { i } });
  }
  const auto line = filter.Run(MakeGrid(points, cells), cage, bent);
  for (vtkIdType i = 1; i < 96; ++i)
  {
    const double turn =
      GetPoint(line, i + 1)[2] - 2. * GetPoint(line, i)[2] + GetPoint(line, i - 1)[2];
    EXPECT_LT(std::abs(turn) / step, 1.1 * 0.4 * 2. * 2. / 3. * step) << i; // |N''| is at most 2
  }
  EXPECT_TRUE(filter.WasSilent());
}

TEST(SubdivisionDeformationPlanes, CreasesAndSharpnessCount)
{
  // Lines after the quads, which the surface has before them: flags must stay with their cells.
  std::vector<Cell> lines;
  for (vtkIdType j = 0; j < 5; ++j)
  {
    lines.push_back({ VTK_LINE, { 6 * j + 3, 6 * j + 9 } });
  }
  const Grid plain = MakeCage(5, true, lines);
  const Grid bent = Moved(plain, BendInPlane);
  const int quads = static_cast<int>(plain->GetNumberOfCells()) - 5;
  const Grid flagged = With(plain, "Singular", FlagsAfter(quads, 5));
  const Grid sharp = DeepCopy(plain);
  AddCellArray<vtkDoubleArray>(sharp, "s", FlagsAfter(quads, 5));
  const auto object = Subdivide(plain, bent, 2);
  Deformer filter;
  Prepare(filter, 2);
  EXPECT_LT(GetErrorOfBent(filter.Run(object, plain, bent), object), 1e-12);
  for (const Grid& cage : { flagged, sharp })
  {
    const Grid moved = Moved(cage, BendInPlane);
    const auto creased = Subdivide(cage, bent, 2);
    EXPECT_NE(ComparePoints(object, creased), ""); // the rules differ
    if (cage == sharp)
    {
      filter->SetInputArrayToProcess(4, 1, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "s");
    }
    EXPECT_LT(GetErrorOfBent(filter.Run(creased, cage, moved), creased), 1e-12);
  }
  EXPECT_EQ(filter->GetNumberOfTopologyBuilds(), 3);
  EXPECT_TRUE(filter.WasSilent());
}

TEST(SubdivisionDeformationPlanes, OperatorsAreKept)
{
  const Grid cage = MakeCage(5, true);
  // Few points, which have composed rows, and many.
  for (const int size : { 20, 5000 })
  {
    const Grid cloud = MakeCloud(size, { 0., 0., 0.5 }, { 5., 5., 0.5 }, 7);
    Deformer filter;
    Prepare(filter, 3);
    filter.Run(cloud, cage, Moved(cage, Affine));
    const Grid bent = Moved(cage, BendInPlane);
    const auto again = filter.Run(cloud, cage, bent);
    EXPECT_EQ(filter->GetNumberOfTopologyBuilds(), 1);
    EXPECT_EQ(filter->GetNumberOfLocationBuilds(), 1);
    Deformer fresh;
    Prepare(fresh, 3);
    EXPECT_EQ(ComparePoints(again, fresh.Run(cloud, cage, bent)), "");
    EXPECT_GT(GetLargestError(again, cloud, Affine), 1.);
    // The other scheme is another subdivision, and comes back.
    filter->SetSurfaceSchemeToLoop();
    filter->SetOutsidePointsToLeave(); // Loop rounds the corners of the cage off
    const auto loop = filter.Run(cloud, cage, bent);
    EXPECT_EQ(filter->GetNumberOfTopologyBuilds(), 2);
    EXPECT_NE(ComparePoints(again, loop), "");
    Deformer unset;
    unset->SetNumberOfLevels(3);
    EXPECT_EQ(ComparePoints(unset.Run(cloud, cage, bent), loop), "");
    filter->SetSurfaceSchemeToCatmullClark();
    EXPECT_EQ(ComparePoints(filter.Run(cloud, cage, bent), again), "");
  }
}

TEST(SubdivisionDeformationPlanes, RestMeshesMayBeSubdividedAlready)
{
  // One level of a cage of one level is two levels of the cage, with its creases.
  const Grid plain = MakeCage(5, true, { { VTK_LINE, { 14, 20 } }, { VTK_LINE, { 20, 26 } } });
  const int quads = static_cast<int>(plain->GetNumberOfCells()) - 2;
  const Grid cage = With(plain, "Singular", FlagsAfter(quads, 2));
  const Grid bent = Moved(cage, BendInPlane);
  const auto rest = Subdivide(cage, bent, 1);
  const auto object = Subdivide(cage, bent, 2);
  vtkNew<vtkPolyData> deformed;
  deformed->DeepCopy(rest);
  deformed->GetPoints()->SetData(rest->GetPointData()->GetArray("bent"));
  Deformer filter;
  Prepare(filter, 1);
  EXPECT_LT(GetErrorOfBent(filter.Run(object, rest, deformed), object), 1e-12);
  EXPECT_TRUE(filter.WasSilent());
}

TEST(SubdivisionDeformationPlanes, TrianglesOfAQuadLieInsideIt)
{
  // A quad that is not convex: the diagonal from its first point would lie outside.
  const Grid cage = MakeGrid(
    { { 4, 0, 0 }, { 1, 1, 0 }, { 0, 4, 0 }, { 0, 0, 0 } }, { { VTK_QUAD, { 0, 1, 2, 3 } } });
  const Grid cloud = MakeGrid({ { 0.5, 0.5, 0 }, { 2, 0.5, 0 }, { 1.5, 1.5, 0 } },
    { { VTK_VERTEX, { 0 } }, { VTK_VERTEX, { 1 } }, { VTK_VERTEX, { 2 } } });
  Deformer filter;
  Prepare(filter, 0);
  filter->SetOutsidePointsToLeave();
  const auto moved = filter.Run(cloud, cage, Moved(cage, Affine));
  EXPECT_EQ(filter->GetNumberOfOutsidePoints(), 1);
  EXPECT_EQ(GetPoint(moved, 2), GetPoint(cloud, 2));
}

TEST(SubdivisionDeformationPlanes, SolidsAreAnError)
{
  Grid cage = MakeCage(5, false, { { VTK_TETRA, { 0, 1, 6, 35 } } });
  const Grid cloud = MakeCloud(20, { 1., 1., 0.5 }, { 4., 4., 0.5 }, 7);
  Deformer filter;
  Prepare(filter, 1);
  EXPECT_EQ(ComparePoints(filter.Run(cloud, cage, Moved(cage, Affine)), cloud), "");
  ASSERT_EQ(filter.GetErrors().size(), 1U);
  EXPECT_NE(filter.GetErrors()[0].find("Cell 25 of the rest mesh is a solid"), std::string::npos)
    << filter.GetErrors()[0];
  EXPECT_TRUE(filter.GetWarnings().empty());
  filter.Forget();
  // It goes on with the next mesh.
  cage = MakeCage(5, false);
  EXPECT_LT(GetLargestError(filter.Run(cloud, cage, Moved(cage, Affine)), cloud, Affine), 1e-12);
  EXPECT_TRUE(filter.WasSilent());
}
