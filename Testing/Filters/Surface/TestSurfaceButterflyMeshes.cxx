// SPDX-License-Identifier: BSD-3-Clause
// Mathematics 12: the modified Butterfly scheme on meshes.
#include "Precompiled.h"

#include "vtkSurfaceSubdivision.h"

#include "vtkButterflySubdivisionFilter.h"
#include "vtkPlatonicSolidSource.h"
#include "vtkSphereSource.h"

namespace
{

using Surface = vtkSmartPointer<vtkPolyData>;

Surface Subdivide(vtkPolyData* input, int levels)
{
  vtkNew<vtkSurfaceSubdivision> filter;
  filter->SetInputData(input);
  filter->SetScheme(vtkSurfaceSubdivision::MODIFIED_BUTTERFLY);
  filter->SetNumberOfLevels(levels);
  filter->Update();
  return filter->GetOutput();
}

/// A sheet of n by n squares, each two triangles, at height z(x, y).
Surface MakeSheet(int n, const std::function<double(double, double)>& z)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polys;
  for (int y = 0; y <= n; ++y)
  {
    for (int x = 0; x <= n; ++x)
    {
      points->InsertNextPoint(x, y, z(x, y));
      if (x < n && y < n)
      {
        const vtkIdType a = y * (n + 1) + x;
        const vtkIdType triangles[2][3] = { { a, a + 1, a + n + 1 },
          { a + 1, a + n + 2, a + n + 1 } };
        polys->InsertNextCell(3, triangles[0]);
        polys->InsertNextCell(3, triangles[1]);
      }
    }
  }
  auto sheet = Surface::New();
  sheet->SetPoints(points);
  sheet->SetPolys(polys);
  return sheet;
}

/// The largest distance from a point of `a` to the nearest of `b`.
double FindDistance(vtkPolyData* a, vtkPolyData* b)
{
  double largest = 0.;
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    double p[3];
    a->GetPoint(i, p);
    double nearest = VTK_DOUBLE_MAX;
    for (vtkIdType j = 0; j < b->GetNumberOfPoints(); ++j)
    {
      double q[3];
      b->GetPoint(j, q);
      nearest = std::min(nearest, std::hypot(std::hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]));
    }
    largest = std::max(largest, nearest);
  }
  return largest;
}

}

TEST(SurfaceButterfly, KeepsItsPoints)
{
  const Surface sheet = MakeSheet(5, [](double x, double y) { return std::sin(3 * x + 5 * y); });
  const Surface fine = Subdivide(sheet, 2);
  EXPECT_EQ(fine->GetNumberOfPolys(), 16 * sheet->GetNumberOfPolys());
  for (vtkIdType i = 0; i < sheet->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_EQ(fine->GetPoint(i)[c], sheet->GetPoint(i)[c]);
    }
  }
}

TEST(SurfaceButterfly, CubicsInsideQuadraticsNearCurvesLinearFunctionsAtThem)
{
  constexpr int n = 8;
  auto z = [](int degree)
  {
    return [degree](double x, double y)
    {
      const double t = 0.3 * x - 0.7 * y;
      return degree == 1 ? t : degree == 2 ? t * t + x * y : t * t * t + x * y * y - 2. * x * x;
    };
  };
  for (int degree = 1; degree <= 3; ++degree)
  {
    const Surface fine = Subdivide(MakeSheet(n, z(degree)), 1);
    const double margin = degree - 1.; // distance from the boundary
    int tested = 0;
    for (vtkIdType i = (n + 1) * (n + 1); i < fine->GetNumberOfPoints(); ++i)
    {
      double p[3];
      fine->GetPoint(i, p);
      const bool nearCorner = (p[0] < 1. || p[0] > n - 1.) && (p[1] < 1. || p[1] > n - 1.);
      if (nearCorner || std::min({ p[0], p[1], n - p[0], n - p[1] }) < (degree == 2 ? 0.5 : margin))
      {
        continue;
      }
      // New points halve edges.
      EXPECT_NEAR(2. * p[0], std::round(2. * p[0]), 1e-12);
      EXPECT_NEAR(2. * p[1], std::round(2. * p[1]), 1e-12);
      EXPECT_NEAR(p[2], z(degree)(p[0], p[1]), 1e-11) << p[0] << " " << p[1];
      ++tested;
    }
    EXPECT_GT(tested, 40) << degree;
  }
}

TEST(SurfaceButterfly, FlatStaysFlat)
{
  const Surface fine =
    Subdivide(MakeSheet(3, [](double x, double y) { return 2. + x - 3. * y; }), 3);
  for (vtkIdType i = 0; i < fine->GetNumberOfPoints(); ++i)
  {
    double p[3];
    fine->GetPoint(i, p);
    EXPECT_NEAR(p[2], 2. + p[0] - 3. * p[1], 1e-12);
  }
}

TEST(SurfaceButterfly, AVertexOfOneFaceIsACorner)
{
  const auto triangle = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(0., 0., 0.);
  points->InsertNextPoint(1., 0., 0.);
  points->InsertNextPoint(0., 1., 0.);
  vtkNew<vtkCellArray> polys;
  const vtkIdType ids[3] = { 0, 1, 2 };
  polys->InsertNextCell(3, ids);
  triangle->SetPoints(points);
  triangle->SetPolys(polys);
  const Surface fine = Subdivide(triangle, 2);
  ASSERT_EQ(fine->GetNumberOfPoints(), 15);
  int atSides = 0;
  for (vtkIdType i = 0; i < fine->GetNumberOfPoints(); ++i)
  {
    double p[3];
    fine->GetPoint(i, p);
    const double nearest = std::min({ p[0], p[1], 1. - p[0] - p[1] });
    EXPECT_GT(nearest, -1e-14);
    atSides += nearest < 1e-14;
  }
  EXPECT_EQ(atSides, 12);
}

TEST(SurfaceButterfly, EqualsVtkOnClosedMeshesInSinglePrecision)
{
  for (int solid : { VTK_SOLID_OCTAHEDRON, VTK_SOLID_ICOSAHEDRON })
  {
    vtkNew<vtkPlatonicSolidSource> source;
    source->SetSolidType(solid);
    source->Update();
    Surface input = Surface::New();
    input->DeepCopy(source->GetOutput());
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
    {
      double p[3];
      input->GetPoint(i, p);
      points->InsertNextPoint(p[0], 2. * p[1] + 0.3 * p[0], p[2] + p[0] * p[0]);
    }
    input->SetPoints(points);
    vtkNew<vtkButterflySubdivisionFilter> theirs;
    theirs->SetInputData(input);
    theirs->SetNumberOfSubdivisions(3);
    theirs->Update();
    const Surface ours = Subdivide(input, 3);
    ASSERT_EQ(ours->GetNumberOfPoints(), theirs->GetOutput()->GetNumberOfPoints());
    // VTK makes points in single precision.
    ASSERT_EQ(theirs->GetOutput()->GetPoints()->GetDataType(), VTK_FLOAT);
    EXPECT_LT(FindDistance(ours, theirs->GetOutput()), 5e-7) << solid;
  }
}
