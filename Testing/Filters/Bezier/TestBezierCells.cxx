// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestBezierCells.cxx
 * OutputCells = Bezier: cells that VTK itself evaluates are the limit, exactly where it is a
 * polynomial and within the tolerance elsewhere.
 */
#include "MultiDimensionalSubdivisionTools.h"

#include "vtkSubdivisionModelSource.h"
#include "vtkSubdivisionOperator.h"
#include "vtkSurfaceSubdivision.h"

#include "vtkGenericCell.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkStaticCellLocator.h"

#include <functional>
#include <map>
#include <set>

using namespace multi_dimensional_subdivision_tools;

namespace
{

using Filter = vtkMultiDimensionalSubdivision;
using Configure = std::function<void(Filter*)>;

Grid MakeBezier(vtkDataObject* input, int levels, const Configure& configure = nullptr)
{
  vtkNew<Filter> filter;
  filter->SetNumberOfLevels(levels);
  filter->SetOutputCellsToBezier();
  if (configure)
  {
    configure(filter);
  }
  return UpdateWithoutErrors<vtkUnstructuredGrid>(filter.Get(), input);
}

Grid MakeBezierSurface(vtkDataObject* input, int scheme, int levels, double tolerance = 1e-4)
{
  vtkNew<vtkSurfaceSubdivision> filter;
  filter->SetInputDataObject(input);
  filter->SetScheme(scheme);
  filter->SetNumberOfLevels(levels);
  filter->SetOutputCellsToBezier();
  filter->SetBezierTolerance(tolerance);
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->Update();
  EXPECT_TRUE(messages->Errors.empty() && messages->Warnings.empty());
  EXPECT_EQ(filter->GetOutput(), nullptr);
  const auto output = Grid::New();
  output->DeepCopy(filter->GetUnstructuredGridOutput());
  return output;
}

/// A point of a cell, as VTK evaluates it, and a value of an array there.
Point EvaluateCell(vtkUnstructuredGrid* grid, vtkIdType c, const Point& at)
{
  vtkNew<vtkGenericCell> cell;
  grid->GetCell(c, cell);
  std::vector<double> weights(static_cast<std::size_t>(cell->GetNumberOfPoints()));
  int part = 0;
  Point p;
  cell->EvaluateLocation(part, at.data(), p.data(), weights.data());
  return p;
}
double InterpolateInCell(
  vtkUnstructuredGrid* grid, vtkDataArray* array, vtkIdType c, const Point& at)
{
  vtkNew<vtkGenericCell> cell;
  grid->GetCell(c, cell);
  std::vector<double> weights(static_cast<std::size_t>(cell->GetNumberOfPoints()));
  cell->InterpolateFunctions(at.data(), weights.data());
  double sum = 0.;
  for (vtkIdType k = 0; k < cell->GetNumberOfPoints(); ++k)
  {
    sum += weights[static_cast<std::size_t>(k)] * array->GetComponent(cell->GetPointId(k), 0);
  }
  return sum;
}

/// Places inside and on the faces of a cell of a dimension.
std::vector<Point> MakePlaces(int dimension)
{
  std::vector<Point> places;
  for (const double u : { 0., 0.17, 0.36, 0.6 })
  {
    for (const double v : { 0., 0.11, 0.33 })
    {
      for (const double w : { 0., 0.05 })
      {
        places.push_back({ u, dimension > 1 ? v : 0., dimension > 2 ? w : 0. });
      }
    }
  }
  return places;
}

/// The parameters in the input's cell, whose corners may be in another order: the box spline orders
/// those of solids.
Point ToInput(vtkUnstructuredGrid* input, vtkUnstructuredGrid* bezier, vtkIdType c, const Point& at)
{
  const Ids corners = GetCell(input, c);
  const Ids ids = GetCell(bezier, c);
  vtkDataArray* originals = bezier->GetPointData()->GetArray("vtkOriginalPointIds");
  Point there{};
  for (std::size_t k = 1; k < corners.size(); ++k)
  {
    double rest = 1.;
    for (std::size_t i = 1; i < corners.size(); ++i)
    {
      rest -= at[i - 1];
    }
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      if (originals->GetComponent(ids[i], 0) == static_cast<double>(corners[k]))
      {
        there[k - 1] = i == 0 ? rest : at[i - 1];
      }
    }
  }
  return there;
}

/// Compares each cell, which is one of the input's, with what EvaluateLimit finds. Returns how many
/// there are.
vtkIdType ExpectLimit(
  vtkUnstructuredGrid* input, const std::set<vtkIdType>& which, double tolerance)
{
  const Grid bezier = MakeBezier(input, 0, [](Filter* filter) { filter->GenerateOriginalIdsOn(); });
  EXPECT_EQ(bezier->GetNumberOfCells(), input->GetNumberOfCells());
  vtkNew<Filter> filter;
  filter->SetInputData(input);
  vtkNew<vtkIdTypeArray> cells;
  vtkNew<vtkDoubleArray> parameters;
  parameters->SetNumberOfComponents(3);
  std::vector<std::pair<vtkIdType, Point>> places;
  for (vtkIdType c = 0; c < bezier->GetNumberOfCells(); ++c)
  {
    if (which.empty() || which.count(c) > 0)
    {
      for (const Point& at : MakePlaces(bezier->GetCell(c)->GetCellDimension()))
      {
        places.emplace_back(c, at);
        cells->InsertNextValue(c);
        parameters->InsertNextTuple(ToInput(input, bezier, c, at).data());
      }
    }
  }
  vtkNew<vtkPolyData> limit;
  EXPECT_TRUE(filter->EvaluateLimit(cells, parameters, limit));
  vtkDataArray* values = bezier->GetPointData()->GetArray("Scalar");
  vtkDataArray* wanted = limit->GetPointData()->GetArray("Scalar");
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const auto& [c, at] = places[i];
    const Point found = EvaluateCell(bezier, c, at);
    const Point expected = GetPoint(limit, static_cast<vtkIdType>(i));
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_NEAR(found[axis], expected[axis], tolerance) << c << " " << at[0] << " " << at[1];
    }
    EXPECT_NEAR(InterpolateInCell(bezier, values, c, at),
      wanted->GetComponent(static_cast<vtkIdType>(i), 0), tolerance);
  }
  return static_cast<vtkIdType>(places.size());
}

void AddScalar(vtkUnstructuredGrid* grid)
{
  grid->GetPointData()->AddArray(
    MakeArray<vtkDoubleArray>("Scalar", 1, grid->GetNumberOfPoints(), -1., 1., 3));
}

std::vector<Point> Shake(std::vector<Point> points, double size)
{
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> random(-size, size);
  for (Point& p : points)
  {
    for (double& x : p)
    {
      x += random(generator);
    }
  }
  return points;
}

/// n by n squares, each as two triangles or as a quad.
Grid MakeSheet(int n, bool triangles, double shake)
{
  std::vector<Point> points;
  std::vector<Cell> cells;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      points.push_back({ double(i), double(j), 0. });
      const vtkIdType first = i + (n + 1) * j;
      if (i == n || j == n)
      {
        continue;
      }
      if (triangles)
      {
        cells.push_back({ VTK_TRIANGLE, { first, first + 1, first + n + 2 } });
        cells.push_back({ VTK_TRIANGLE, { first, first + n + 2, first + n + 1 } });
      }
      else
      {
        cells.push_back({ VTK_QUAD, { first, first + 1, first + n + 2, first + n + 1 } });
      }
    }
  }
  Grid grid = MakeGrid(Shake(points, shake), cells);
  AddScalar(grid);
  return grid;
}

/// n^3 cells of six tetrahedra around a diagonal each. The axes have obtuse angles, so that the box
/// spline marks the edges by which the tetrahedra are regular.
Grid MakeLattice(int n)
{
  std::vector<Point> points;
  std::vector<Cell> cells;
  for (int k = 0; k <= n; ++k)
  {
    for (int j = 0; j <= n; ++j)
    {
      for (int i = 0; i <= n; ++i)
      {
        points.push_back({ double(-i + j + k), double(i - j + k), double(i + j - k) });
        if (i == n || j == n || k == n)
        {
          continue;
        }
        const vtkIdType steps[3] = { 1, n + 1, vtkIdType(n + 1) * (n + 1) };
        std::array<int, 3> order{ { 0, 1, 2 } };
        do
        {
          vtkIdType at = i + (n + 1) * (j + vtkIdType(n + 1) * k);
          Ids ids{ at };
          for (const int axis : order)
          {
            ids.push_back(at += steps[axis]);
          }
          const bool isEven = (order[0] == 0 && order[1] == 1) ||
            (order[0] == 1 && order[1] == 2) || (order[0] == 2 && order[1] == 0);
          if (!isEven)
          {
            std::swap(ids[1], ids[2]);
          }
          cells.push_back({ VTK_TETRA, ids });
        } while (std::next_permutation(order.begin(), order.end()));
      }
    }
  }
  Grid grid = MakeGrid(Shake(points, 0.03), cells);
  AddScalar(grid);
  return grid;
}

vtkSmartPointer<vtkPolyData> ToSurface(vtkUnstructuredGrid* grid)
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(grid->GetPoints());
  surface->SetPolys(grid->GetCells());
  surface->GetPointData()->ShallowCopy(grid->GetPointData());
  return surface;
}

/// The largest distance of places of the cells from the limit, as a mesh of many levels.
double FindDistance(vtkUnstructuredGrid* bezier, vtkDataSet* limit)
{
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(limit);
  locator->BuildLocator();
  double most = 0.;
  for (vtkIdType c = 0; c < bezier->GetNumberOfCells(); ++c)
  {
    for (const Point& at : MakePlaces(bezier->GetCell(c)->GetCellDimension()))
    {
      const Point p = EvaluateCell(bezier, c, at);
      Point closest;
      vtkIdType cell;
      int part;
      double squared;
      locator->FindClosestPoint(p.data(), closest.data(), cell, part, squared);
      most = std::max(most, std::sqrt(squared));
    }
  }
  return most;
}

/// Sharing: cells that have an edge in common have its control points in common. Counts the edges
/// of cells by their control points, without direction.
std::map<Ids, int> CountEdges(vtkUnstructuredGrid* bezier)
{
  std::map<Ids, int> edges;
  for (vtkIdType c = 0; c < bezier->GetNumberOfCells(); ++c)
  {
    vtkCell* cell = bezier->GetCell(c);
    for (int e = 0; e < cell->GetNumberOfEdges(); ++e)
    {
      vtkIdList* ids = cell->GetEdge(e)->GetPointIds();
      Ids edge(ids->begin(), ids->end());
      std::sort(edge.begin(), edge.end());
      ++edges[edge];
    }
  }
  return edges;
}

}

TEST(BezierCells, CurvesAreTheLimit)
{
  std::vector<Cell> lines;
  for (vtkIdType i = 0; i < 7; ++i)
  {
    lines.push_back({ VTK_LINE, { i, i + 1 } });
  }
  const Grid input = MakeGrid(Shake(std::vector<Point>(8), 1.), lines);
  AddScalar(input);
  EXPECT_GT(ExpectLimit(input, {}, 1e-13), 0);
  const Grid bezier = MakeBezier(input, 3);
  ASSERT_EQ(bezier->GetNumberOfCells(), 7) << "a cell was split where the limit is a polynomial";
  EXPECT_EQ(bezier->GetCellType(3), VTK_BEZIER_CURVE);
  EXPECT_EQ(bezier->GetNumberOfPoints(), 8 + 2 * 7);
}

TEST(BezierCells, RegularTrianglesAreTheLimit)
{
  const Grid input = MakeSheet(6, true, 0.2);
  // Around the middle all six neighbours of all vertices of a cell are inside.
  EXPECT_GT(ExpectLimit(input, { 26, 27, 28, 29, 30, 31, 38, 39, 40, 41 }, 1e-12), 0);
  const Grid bezier = MakeBezier(input, 0);
  EXPECT_EQ(bezier->GetCellType(30), VTK_BEZIER_TRIANGLE);
  EXPECT_EQ(bezier->GetNumberOfPoints(), 49 + 3 * 120 + 3 * 72);
  for (const auto& [edge, cells] : CountEdges(bezier))
  {
    EXPECT_EQ(edge.size(), 5u);
    EXPECT_LE(cells, 2);
  }
  EXPECT_EQ(CountEdges(bezier).size(), 120u);
}

TEST(BezierCells, RegularSolidsAreTheLimit)
{
  const Grid input = MakeLattice(3);
  const std::set<vtkIdType> inner{ 6 * 13, 6 * 13 + 4 }; // of the cell in the middle
  EXPECT_GT(ExpectLimit(input, inner, 1e-9), 0);
  const Grid bezier = MakeBezier(input, 0);
  EXPECT_EQ(bezier->GetCellType(6 * 13), VTK_BEZIER_TETRAHEDRON);
  EXPECT_EQ(bezier->GetCell(0)->GetNumberOfPoints(), 56);
}

TEST(BezierCells, RegularQuadsAreUniformBSplines)
{
  const int n = 5;
  const Grid grid = MakeSheet(n, false, 0.2);
  const Grid bezier = MakeBezierSurface(ToSurface(grid), vtkSurfaceSubdivision::CATMULL_CLARK, 0);
  ASSERT_EQ(bezier->GetNumberOfCells(), n * n);
  const vtkIdType middle = 2 + n * 2;
  EXPECT_EQ(bezier->GetCellType(middle), VTK_BEZIER_QUADRILATERAL);
  const auto basis = [](double t)
  {
    const double s = 1. - t;
    return std::array<double, 4>{ { s * s * s / 6., (3. * t * t * t - 6. * t * t + 4.) / 6.,
      (3. * s * s * s - 6. * s * s + 4.) / 6., t * t * t / 6. } };
  };
  for (const Point& at : MakePlaces(2))
  {
    const auto x = basis(at[0]);
    const auto y = basis(at[1]);
    const Point found = EvaluateCell(bezier, middle, at);
    for (int axis = 0; axis < 3; ++axis)
    {
      double sum = 0.;
      for (int j = 0; j < 4; ++j)
      {
        for (int i = 0; i < 4; ++i)
        {
          sum += x[i] * y[j] * GetPoint(grid, 1 + i + (n + 1) * (1 + j))[axis];
        }
      }
      EXPECT_NEAR(found[axis], sum, 1e-12);
    }
  }
}

TEST(BezierCells, AreSplitAroundExtraordinaryVerticesOnly)
{
  const Grid input = MakeSheet(8, true, 0.2);
  const Grid without = MakeBezier(input, 0);
  const Grid bezier = MakeBezier(input, 3,
    [](Filter* filter)
    {
      filter->SetBezierTolerance(0.);
      filter->GenerateOriginalIdsOn();
    });
  // Two corners of the sheet are in one triangle, and two in two; all other vertices are regular.
  std::set<vtkIdType> split;
  std::map<vtkIdType, int> pieces;
  vtkDataArray* cells = bezier->GetCellData()->GetArray("vtkOriginalCellIds");
  for (vtkIdType c = 0; c < bezier->GetNumberOfCells(); ++c)
  {
    if (++pieces[static_cast<vtkIdType>(cells->GetComponent(c, 0))] > 1)
    {
      split.insert(static_cast<vtkIdType>(cells->GetComponent(c, 0)));
    }
  }
  EXPECT_EQ(pieces.size(), 128u);
  EXPECT_FALSE(split.empty());
  EXPECT_LT(split.size(), 20u);
  EXPECT_LT(bezier->GetNumberOfCells(), 128 * 64 / 8);
}

TEST(BezierCells, KeepTheirTolerance)
{
  std::vector<Cell> octahedron;
  for (const vtkIdType top : { 4, 5 })
  {
    for (vtkIdType i = 0; i < 4; ++i)
    {
      octahedron.push_back({ VTK_TRIANGLE, { i, (i + 1) % 4, top } });
    }
  }
  const Grid surface =
    MakeGrid(Shake({ { { 1., 0., 0. } }, { { 0., 1., 0. } }, { { -1., 0., 0. } },
                     { { 0., -1., 0. } }, { { 0., 0., 1. } }, { { 0., 0., -1. } } },
               0.2),
      octahedron);
  for (const Grid& input : { surface, MakeLattice(1) })
  {
    const int levels = input == surface ? 4 : 1;
    const auto make = [&](double tolerance)
    {
      return MakeBezier(
        input, levels, [=](Filter* filter) { filter->SetBezierTolerance(tolerance); });
    };
    vtkNew<Filter> filter;
    filter->SetNumberOfLevels(input == surface ? 7 : 4);
    filter->ProjectToLimitOn();
    const Grid limit = UpdateWithoutErrors<vtkUnstructuredGrid>(filter.Get(), input);
    const Grid coarse = make(3e-3);
    const Grid fine = make(3e-5);
    EXPECT_LT(coarse->GetNumberOfCells(), fine->GetNumberOfCells());
    EXPECT_LT(FindDistance(coarse, limit), 5e-3 * limit->GetLength());
    EXPECT_LT(FindDistance(fine, limit), (input == surface ? 2e-4 : 2e-3) * limit->GetLength());
  }
}

TEST(BezierCells, FacesThatAreNoQuadsAreSplit)
{
  // A prism of 5 sides: two pentagons and five quads; and a polygon of 16 corners.
  for (const int sides : { 3, 5, 16 })
  {
    std::vector<Point> points;
    std::vector<Cell> cells{ { VTK_POLYGON, {} }, { VTK_POLYGON, {} } };
    for (int i = 0; i < sides; ++i)
    {
      const double angle = 2. * i * 3.14159265358979 / sides;
      points.push_back({ std::cos(angle), std::sin(angle), 0. });
      points.push_back({ std::cos(angle), std::sin(angle), 2. });
      cells[0].Points.insert(cells[0].Points.begin(), 2 * i);
      cells[1].Points.push_back(2 * i + 1);
      const vtkIdType next = 2 * ((i + 1) % sides);
      cells.push_back({ VTK_QUAD, { 2 * i, next, next + 1, 2 * i + 1 } });
    }
    const auto surface = ToSurface(MakeGrid(points, cells));
    const Grid whole = MakeBezierSurface(surface, vtkSurfaceSubdivision::CATMULL_CLARK, 1, 1.);
    EXPECT_EQ(whole->GetNumberOfCells(), 3 * sides) << "a cell was split that fits";
    const Grid bezier = MakeBezierSurface(surface, vtkSurfaceSubdivision::CATMULL_CLARK, 3, 1e-4);
    EXPECT_GT(bezier->GetNumberOfCells(), 3 * sides);
    vtkNew<vtkSurfaceSubdivision> limit;
    limit->SetInputData(surface);
    limit->SetSchemeToCatmullClark();
    limit->SetNumberOfLevels(6);
    limit->ProjectToLimitOn();
    limit->Update();
    EXPECT_LT(FindDistance(bezier, limit->GetOutput()), 2e-3);
    for (vtkIdType c = 0; c < bezier->GetNumberOfCells(); ++c)
    {
      EXPECT_EQ(bezier->GetCellType(c), VTK_BEZIER_QUADRILATERAL);
    }
  }
}

TEST(BezierCells, DataOfCellsAndPointsStay)
{
  const Grid input = MakeSheet(4, true, 0.1);
  input->GetCellData()->AddArray(
    MakeArray<vtkIntArray>("Material", 1, input->GetNumberOfCells(), 0., 9., 5));
  const Grid linear = MakeBezier(input, 1,
    [](Filter* filter)
    {
      filter->SetOutputCellsToLinear();
      filter->GenerateOriginalIdsOn();
    });
  const Grid bezier = MakeBezier(input, 1,
    [](Filter* filter)
    {
      filter->GenerateOriginalIdsOn();
      filter->SetBezierTolerance(0.);
    });
  ASSERT_NE(bezier->GetPointData()->GetArray("Scalar"), nullptr);
  vtkDataArray* cells = bezier->GetCellData()->GetArray("vtkOriginalCellIds");
  ASSERT_NE(cells, nullptr);
  EXPECT_NE(bezier->GetCellData()->GetArray("Material"), nullptr);
  EXPECT_NE(linear->GetFieldData()->GetAbstractArray("Subdivision"), nullptr);
  EXPECT_EQ(bezier->GetFieldData()->GetAbstractArray("Subdivision"), nullptr);
  for (vtkIdType c = 1; c < bezier->GetNumberOfCells(); ++c)
  {
    EXPECT_LE(cells->GetComponent(c - 1, 0), cells->GetComponent(c, 0));
  }
}

TEST(BezierCells, OtherCellsStay)
{
  const Grid input = MakeGrid({ { { 0., 0., 0. } }, { { 1., 0., 0. } }, { { 0., 1., 0. } } },
    { { VTK_VERTEX, { 1 } }, { VTK_LINE, { 0, 2 } } });
  const Grid bezier = MakeBezier(input, 2);
  ASSERT_EQ(bezier->GetNumberOfCells(), 2);
  EXPECT_EQ(bezier->GetCellType(0), VTK_VERTEX);
  EXPECT_EQ(bezier->GetCellType(1), VTK_BEZIER_CURVE);
  EXPECT_EQ(MakeBezier(vtkSmartPointer<vtkUnstructuredGrid>::New(), 1)->GetNumberOfCells(), 0);
}

TEST(BezierCells, SomeOptionsLeaveThemLinear)
{
  const Grid input = MakeLattice(1);
  for (const bool keeps : { false, true })
  {
    vtkNew<Filter> filter;
    vtkNew<Messages> messages;
    messages->Watch(filter);
    filter->SetInputData(input);
    filter->SetOutputCellsToBezier();
    keeps ? filter->SetVolumeSchemeToLinear() : filter->SetVolumeSchemeToTetOct();
    filter->SetKeepCellTypes(keeps);
    filter->Update();
    EXPECT_EQ(messages->CountWarnings("Bezier cells need VolumeScheme = BoxSpline or Linear"), 1);
    EXPECT_EQ(filter->GetOutput()->GetCellType(0), VTK_TETRA);
    EXPECT_GT(filter->GetOutput()->GetNumberOfCells(), 0);
  }
  vtkNew<vtkSurfaceSubdivision> surface;
  vtkNew<Messages> messages;
  messages->Watch(surface);
  surface->SetInputData(ToSurface(MakeSheet(2, false, 0.)));
  surface->SetSchemeToDooSabin();
  surface->SetOutputCellsToBezier();
  surface->Update();
  EXPECT_EQ(messages->CountWarnings("Bezier cells need Scheme = Loop"), 1);
  ASSERT_NE(surface->GetOutput(), nullptr);
  EXPECT_GT(surface->GetOutput()->GetNumberOfCells(), 0);
}

TEST(BezierCells, BlocksKeepTheirStructure)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  const Grid left = MakeSheet(3, true, 0.1);
  const Grid right = MakeSheet(3, true, 0.1);
  right->GetPoints()->SetPoint(0, 20., 0., 0.);
  blocks->SetBlock(0, ToSurface(left));
  blocks->SetBlock(2, ToSurface(right));
  vtkNew<vtkSurfaceSubdivision> filter;
  filter->SetInputData(blocks);
  filter->SetOutputCellsToBezier();
  filter->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_NE(output, nullptr);
  EXPECT_EQ(output->GetBlock(1), nullptr);
  for (const unsigned block : { 0u, 2u })
  {
    auto* grid = vtkUnstructuredGrid::SafeDownCast(output->GetBlock(block));
    ASSERT_NE(grid, nullptr);
    EXPECT_EQ(grid->GetCellType(0), VTK_BEZIER_TRIANGLE);
  }
}

TEST(BezierCells, DoNotDependOnThreads)
{
  const Grid input = MakeSheet(60, true, 0.2);
  vtkSMPTools::Initialize(1);
  const Grid one = MakeBezier(input, 1);
  vtkSMPTools::Initialize(4);
  const Grid four = MakeBezier(input, 1);
  vtkSMPTools::Initialize(0);
  EXPECT_GT(one->GetNumberOfCells(), 60 * 60 * 2);
  EXPECT_EQ(Compare(one, four), "");
}

TEST(BezierCells, TheOperatorIsThatOfLinearCells)
{
  const Grid input = MakeSheet(3, true, 0.1);
  vtkNew<Filter> filter;
  filter->SetInputData(input);
  filter->SetOutputCellsToBezier();
  vtkNew<vtkSubdivisionOperator> result;
  ASSERT_TRUE(filter->ComputeOperator(result));
  EXPECT_EQ(result->GetNumberOfRows(), 16 + 33);
}
