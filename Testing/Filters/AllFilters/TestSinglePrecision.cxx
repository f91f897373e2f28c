// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSinglePrecision.cxx
 * Points in single precision, VTK's default: what is equal but for rounding is equal (Mathematics
 * 2), so that choices do not depend on the precision, nor on how a lattice is turned.
 */
#include "SubdivisionDeformationTools.h"
#include "SurfaceTools.h"

#include "vtkRedGreenRefinement.h"

using namespace deformation_tools;

namespace
{

/// Turned by angles that no lattice has, and away from the origin.
Point Turn(const Point& x)
{
  const double c = std::cos(0.7);
  const double s = std::sin(0.7);
  const Point y = { c * x[0] - s * x[1], s * x[0] + c * x[1], x[2] };
  return { c * y[0] - s * y[2] + 0.3, y[1] - 0.4, s * y[0] + c * y[2] + 0.1 };
}

/// A grid with its points moved, and stored in single or double precision.
Grid Store(vtkUnstructuredGrid* grid, const Map& map, int type)
{
  std::vector<Point> points;
  std::vector<Cell> cells;
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    points.push_back(map(GetPoint(grid, i)));
  }
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    cells.push_back({ grid->GetCellType(i), GetCell(grid, i) });
  }
  return MakeGrid(points, cells, type);
}

surfacetools::Model MakePrism(int sides)
{
  surfacetools::Model prism;
  for (int i = 0; i < 2 * sides; ++i)
  {
    const double t = 6.283185307179586 * (i % sides) / sides;
    prism.Points.push_back(Turn({ std::cos(t), std::sin(t), 1. * (i / sides) }));
  }
  for (vtkIdType i = 0; i < sides; ++i)
  {
    const vtkIdType j = (i + 1) % sides;
    prism.Faces.push_back({ i, j, j + sides, i + sides });
  }
  return prism;
}

vtkSmartPointer<vtkPolyData> ToSingle(vtkPolyData* surface)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(surface);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    points->InsertNextPoint(surface->GetPoint(i));
  }
  copy->SetPoints(points);
  return copy;
}

double GetLargestDifference(vtkPointSet* a, vtkPointSet* b)
{
  return GetLargestError(a, b, [](const Point& x) { return x; });
}

}

TEST(SinglePrecision, ALatticeKeepsItsMarkedEdges)
{
  const Grid straight = MakeKuhnBox(4);
  const std::vector<Ids> expected = GetCells(Execute(straight, 1));
  for (const double spacing : { 1., 0.1, 100. })
  {
    auto map = [spacing](const Point& x)
    { return Turn({ spacing * x[0], spacing * x[1], spacing * x[2] }); };
    for (const int type : { VTK_DOUBLE, VTK_FLOAT })
    {
      EXPECT_EQ(GetCells(Execute(Store(straight, map, type), 1)), expected) << spacing;
    }
    // Whatever was or will be rounded.
    for (const int type : { VTK_DOUBLE, VTK_FLOAT })
    {
      for (const int precision : { vtkAlgorithm::SINGLE_PRECISION, vtkAlgorithm::DOUBLE_PRECISION })
      {
        const Grid stored = Execute(Store(straight, map, type), 1,
          [precision](Filter* filter) { filter->SetOutputPointsPrecision(precision); });
        EXPECT_EQ(GetCells(stored), expected) << spacing;
      }
    }
  }
}

TEST(SinglePrecision, RedTetrahedraKeepTheirMarkedEdges)
{
  auto refine = [](vtkUnstructuredGrid* grid)
  {
    vtkNew<vtkRedGreenRefinement> filter;
    filter->SetInputData(grid);
    filter->RefineByAttributeErrorOff();
    filter->RefineByEdgeLengthOn();
    filter->SetMaximumEdgeLength(0.9);
    filter->SetMaximumLevel(1);
    filter->Update();
    return GetCells(filter->GetOutput());
  };
  const Grid straight = MakeKuhnBox(3);
  const std::vector<Ids> expected = refine(straight);
  EXPECT_GT(expected.size(), 8u * 27u);
  EXPECT_EQ(refine(Store(straight, Turn, VTK_FLOAT)), expected);
}

TEST(SinglePrecision, PolygonsAreCutAlike)
{
  for (int sides : { 6, 8, 12 })
  {
    std::vector<Point> points;
    Cell polygon{ VTK_POLYGON, {} };
    for (int i = 0; i < sides; ++i)
    {
      const double t = 6.283185307179586 * i / sides;
      points.push_back({ std::cos(t), std::sin(t), 0. });
      polygon.Points.push_back(i);
    }
    // And one with points on its edges.
    for (int i = 0; i < 8; ++i)
    {
      const double side[8][2] = { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 2, 1 }, { 2, 2 }, { 1, 2 },
        { 0, 2 }, { 0, 1 } };
      points.push_back({ 3. + side[i][0], side[i][1], 0. });
    }
    Cell square{ VTK_POLYGON, {} };
    for (int i = 0; i < 8; ++i)
    {
      square.Points.push_back(sides + i);
    }
    const Grid flat = MakeGrid(points, { polygon, square });
    const std::vector<Ids> expected = GetCells(Execute(flat, 0));
    EXPECT_EQ(GetCells(Execute(Store(flat, Turn, VTK_DOUBLE), 0)), expected) << sides;
    EXPECT_EQ(GetCells(Execute(Store(flat, Turn, VTK_FLOAT), 0)), expected) << sides;
  }
}

TEST(SinglePrecision, AnAngleThatIsTheFeatureAngleIsNoFeature)
{
  // 12 sides: each edge turns by just the 30 degrees that are FeatureAngle's default.
  const surfacetools::Model prism = MakePrism(12);
  const auto surface = surfacetools::MakeInput(prism);
  auto subdivide = [](vtkPolyData* input, double angle)
  {
    vtkNew<vtkSurfaceSubdivision> filter;
    filter->SetInputData(input);
    filter->SetSchemeToCatmullClark();
    filter->DetectFeaturesOn();
    filter->SetFeatureAngle(angle);
    filter->Update();
    auto output = vtkSmartPointer<vtkPolyData>::New();
    output->ShallowCopy(filter->GetOutput());
    return output;
  };
  std::vector<Cell> cells;
  for (const auto& face : prism.Faces)
  {
    cells.push_back({ VTK_QUAD, face });
  }
  for (const int type : { VTK_DOUBLE, VTK_FLOAT })
  {
    const auto stored = type == VTK_FLOAT ? ToSingle(surface) : surface;
    EXPECT_LT(GetLargestDifference(subdivide(stored, 30.), subdivide(stored, 31.)), 1e-12) << type;
    EXPECT_GT(GetLargestDifference(subdivide(stored, 29.9), subdivide(stored, 31.)), 1e-3) << type;
    const Grid grid = MakeGrid(prism.Points, cells, type);
    auto execute = [&grid](double angle)
    {
      return Execute(grid, 1,
        [angle](Filter* filter)
        {
          filter->DetectFeaturesOn();
          filter->SetFeatureAngle(angle);
        });
    };
    EXPECT_LT(GetLargestDifference(execute(30.), execute(31.)), 1e-12) << type;
    EXPECT_GT(GetLargestDifference(execute(29.9), execute(31.)), 1e-3) << type;
  }
}

TEST(SinglePrecision, AStraightCornerIsConvex)
{
  for (const bool triangles : { true, false })
  {
    surfacetools::Model grid =
      surfacetools::MakeSheet(6, 4, triangles, { 1., 0., 0. }, { 0., 1., 0. });
    grid.Corners.clear();
    std::vector<vtkIdType> corners;
    for (int i = 1; i < 6; ++i)
    {
      corners.push_back(i); // in the middle of a straight side
    }
    vtkSmartPointer<vtkPolyData> results[3];
    for (int i = 0; i < 3; ++i) // straight, turned, turned in single precision
    {
      surfacetools::Model model = grid;
      for (Point& point : model.Points)
      {
        point = i > 0 ? Turn(point) : point;
      }
      auto input = surfacetools::MakeInput(model);
      vtkNew<vtkCellArray> vertices;
      for (const vtkIdType corner : corners)
      {
        vertices->InsertNextCell(1, &corner);
      }
      input->SetVerts(vertices);
      vtkNew<vtkIntArray> flags;
      flags->SetName("Singular");
      for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
      {
        flags->InsertNextValue(cell < static_cast<vtkIdType>(corners.size()));
      }
      input->GetCellData()->AddArray(flags);
      results[i] = surfacetools::RunFilter(i == 2 ? ToSingle(input) : input,
        triangles ? vtkSurfaceSubdivision::LOOP : vtkSurfaceSubdivision::CATMULL_CLARK, 2);
    }
    EXPECT_LT(GetLargestError(results[1], results[0], Turn), 1e-12) << triangles;
    EXPECT_LT(GetLargestError(results[2], results[0], Turn), 1e-5) << triangles;
  }
}

TEST(SinglePrecision, PointsOnACageInSinglePrecisionAreInside)
{
  auto place = [](const Point& x) { return Point{ x[0] / 3. + 0.7, x[1] / 3., x[2] / 3. }; };
  std::vector<Point> points;
  for (int i = 0; i < 40; ++i)
  {
    points.push_back(place({ 0., 0.04 * i + 0.01, 0.9 }));
    points.push_back(place({ 0.04 * i + 0.1, 2., 0.3 }));
  }
  const Grid cloud = MakeGrid(points, {}, VTK_DOUBLE);
  for (const int type : { VTK_DOUBLE, VTK_FLOAT })
  {
    const Grid cage = Store(MakeKuhnBox(2), place, type);
    Deformer filter;
    filter->DetectFeaturesOn();
    filter.Run(cloud, cage, Moved(cage, Affine));
    EXPECT_EQ(filter->GetNumberOfOutsidePoints(), 0) << type;
  }
}
