// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestBezierCells.cxx
 * OutputCells = Bezier: cells that VTK itself evaluates are the limit, exactly where it is a
 * polynomial and within the tolerance elsewhere.
 */
#include "BezierTools.h"

#include "vtkGenericCell.h"
#include "vtkMath.h"
#include "vtkStaticCellLocator.h"
#include "vtkTetra.h"
#include "vtkTriangle.h"

using namespace bezier_tools;

namespace
{

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

/// Places and weights of the rule of Gauss with five points, for an interval from 0 to 1: exact to
/// degree 9, which the determinant of a cell of degree 4 has.
const std::array<std::array<double, 2>, 5> Gauss{ { { { 0.046910077030668, 0.1184634425280945 } },
  { { 0.2307653449471585, 0.2393143352496833 } }, { { 0.5, 64. / 225. } },
  { { 0.7692346550528415, 0.2393143352496833 } }, { { 0.953089922969332, 0.1184634425280945 } } } };

/// The derivatives of cells of one type and degree. What each control point has of them is the same
/// in all cells, and asked once: VTK takes long to interpolate in a Bezier tetrahedron.
class Differentiation
{
public:
  Point Get(vtkCell* cell, const Point& at, int axis)
  {
    const std::vector<double>& weights = this->FindWeights(cell, at, axis);
    Point derivative{};
    for (vtkIdType k = 0; k < cell->GetNumberOfPoints(); ++k)
    {
      double control[3];
      cell->GetPoints()->GetPoint(k, control);
      for (int i = 0; i < 3; ++i)
      {
        derivative[i] += weights[static_cast<std::size_t>(k)] * control[i];
      }
    }
    return derivative;
  }

private:
  const std::vector<double>& FindWeights(vtkCell* cell, const Point& at, int axis)
  {
    constexpr double step = 1e-4;
    std::vector<double>& weights = this->Weights[{ at, axis }];
    if (weights.empty())
    {
      weights.resize(static_cast<std::size_t>(cell->GetNumberOfPoints()), 0.);
      for (const double side : { -step, step })
      {
        Point there = at;
        there[axis] += side;
        std::vector<double> shares(weights.size());
        cell->InterpolateFunctions(there.data(), shares.data());
        std::transform(shares.begin(), shares.end(), weights.begin(), weights.begin(),
          [side](double share, double sum) { return sum + share / (2. * side); });
      }
    }
    return weights;
  }

  std::map<std::pair<Point, int>, std::vector<double>> Weights;
};

/// The area of triangles, by the rule of Gauss where the third corner is a side of a square, or of
/// quads, which are the square.
double IntegrateArea(vtkUnstructuredGrid* grid)
{
  double area = 0.;
  Differentiation differentiate;
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    grid->GetCell(c, cell);
    const bool isQuad = grid->GetCellType(c) == VTK_BEZIER_QUADRILATERAL;
    for (const auto& x : Gauss)
    {
      for (const auto& y : Gauss)
      {
        const double width = isQuad ? 1. : 1. - y[0];
        const Point at{ x[0] * width, y[0], 0. };
        Point normal;
        vtkMath::Cross(differentiate.Get(cell, at, 0).data(), differentiate.Get(cell, at, 1).data(),
          normal.data());
        area += x[1] * y[1] * width * vtkMath::Norm(normal.data());
      }
    }
  }
  return area;
}

/// The same for the volume of tetrahedra.
double IntegrateVolume(vtkUnstructuredGrid* grid)
{
  double volume = 0.;
  Differentiation differentiate;
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    grid->GetCell(c, cell);
    for (const auto& x : Gauss)
    {
      for (const auto& y : Gauss)
      {
        for (const auto& z : Gauss)
        {
          const double rest = 1. - z[0];
          const Point at{ x[0] * (1. - y[0]) * rest, y[0] * rest, z[0] };
          const Point axes[3] = { differentiate.Get(cell, at, 0), differentiate.Get(cell, at, 1),
            differentiate.Get(cell, at, 2) };
          volume += x[1] * y[1] * z[1] * (1. - y[0]) * rest * rest *
            vtkMath::Determinant3x3(axes[0].data(), axes[1].data(), axes[2].data());
        }
      }
    }
  }
  return volume;
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
  const Grid surface = MakeOctahedron();
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
    const Grid once = MakeBezierSurface(surface, vtkSurfaceSubdivision::CATMULL_CLARK, 1, 0.);
    EXPECT_EQ(once->GetNumberOfCells(), 2 * sides + 4 * sides) << "each face is split once";
    const Grid bezier = MakeBezierSurface(surface, vtkSurfaceSubdivision::CATMULL_CLARK, 3, 1e-4);
    EXPECT_GT(bezier->GetNumberOfCells(), 3 * sides);
    vtkNew<vtkSurfaceSubdivision> limit;
    limit->SetInputData(surface);
    limit->SetSchemeToCatmullClark();
    limit->SetNumberOfLevels(6);
    limit->ProjectToLimitOn();
    limit->Update();
    const Grid never = MakeBezierSurface(surface, vtkSurfaceSubdivision::CATMULL_CLARK, 0);
    EXPECT_EQ(never->GetNumberOfCells(), 3 * sides);
    EXPECT_LT(FindDistance(never, limit->GetOutput()), 2e-2);
    EXPECT_LT(FindDistance(bezier, limit->GetOutput()), 2e-3);
    for (vtkIdType c = 0; c < bezier->GetNumberOfCells(); ++c)
    {
      EXPECT_EQ(bezier->GetCellType(c), VTK_BEZIER_QUADRILATERAL);
    }
  }
}

namespace
{

/// The area of the triangles of a mesh, of which quads are two, or the volume that they enclose: by
/// the theorem of Gauss the sum of those of the tetrahedra between them and the origin.
double MeasureMesh(vtkPointSet* mesh, bool ofVolume)
{
  double sum = 0.;
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
  {
    mesh->GetCellPoints(c, ids);
    for (vtkIdType second = 1; second + 1 < ids->GetNumberOfIds(); ++second)
    {
      Point p[3] = { GetPoint(mesh, ids->GetId(0)), GetPoint(mesh, ids->GetId(second)),
        GetPoint(mesh, ids->GetId(second + 1)) };
      Point origin{};
      sum += ofVolume
        ? vtkTetra::ComputeVolume(origin.data(), p[0].data(), p[1].data(), p[2].data())
        : vtkTriangle::TriangleArea(p[0].data(), p[1].data(), p[2].data());
    }
  }
  return sum;
}

/// Compares a size with that of level 8 on the limit. The error of linear cells falls by 4 with
/// each level, so that levels 7 and 8 tell the exact size, and whether this is so.
template <typename FilterClass>
void ExpectSizeOfLevel8(
  FilterClass* filter, vtkDataObject* input, bool ofVolume, double found, double tolerance)
{
  filter->SetInputDataObject(input);
  filter->ProjectToLimitOn();
  double sizes[3];
  for (int k = 0; k < 3; ++k)
  {
    filter->SetNumberOfLevels(6 + k);
    filter->Update();
    sizes[k] = MeasureMesh(filter->GetOutput(), ofVolume);
  }
  EXPECT_NEAR((sizes[1] - sizes[0]) / (sizes[2] - sizes[1]), 4., 0.1);
  const double exact = (4. * sizes[2] - sizes[1]) / 3.;
  std::cout << "by quadrature " << found / exact - 1. << ", level 8 " << sizes[2] / exact - 1.
            << "\n";
  EXPECT_NEAR(found / exact, 1., tolerance);
  EXPECT_NEAR(found / sizes[2], 1., tolerance + std::abs(sizes[2] / exact - 1.));
}

double IntegrateAreaOfSurface(vtkUnstructuredGrid* mesh, int scheme, double tolerance)
{
  return IntegrateArea(MakeBezierSurface(ToSurface(mesh), scheme, 5, tolerance));
}

}

/// The limit of the boundary of a solid is the boundary of its limit.
TEST(BezierCells, QuadratureFindsAreaAndVolume)
{
  const auto exact = [](Filter* made) { made->SetBezierTolerance(1e-6); };
  const Grid surface = MakeOctahedron();
  vtkNew<Filter> filter;
  ExpectSizeOfLevel8(
    filter.Get(), surface, false, IntegrateArea(MakeBezier(surface, 5, exact)), 1e-7);
  const Grid solid = MakeLattice(1);
  const Grid boundary = TakeBoundary(solid);
  ASSERT_EQ(boundary->GetNumberOfCells(), 12);
  ExpectSizeOfLevel8(
    filter.Get(), boundary, true, IntegrateVolume(MakeBezier(solid, 2, exact)), 5e-6);
}

TEST(BezierCells, QuadratureFindsAreasOfSurfaces)
{
  vtkNew<vtkSurfaceSubdivision> filter;
  const Grid triangles = MakeOctahedron();
  ExpectSizeOfLevel8(filter.Get(), ToSurface(triangles).Get(), false,
    IntegrateAreaOfSurface(triangles, vtkSurfaceSubdivision::LOOP, 1e-6), 1e-7);
  filter->SetSchemeToCatmullClark();
  for (const int n : { 3, 5 })
  {
    const Grid quads = MakeTrapezohedron(n);
    ExpectSizeOfLevel8(filter.Get(), ToSurface(quads).Get(), false,
      IntegrateAreaOfSurface(quads, vtkSurfaceSubdivision::CATMULL_CLARK, 1e-6), 1e-7);
  }
}
