// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestRedGreenRefinementTolerance.cxx
 * vtkRedGreenRefinement: errors against the limit, measured with a mesh three levels finer, are
 * below the tolerance that was asked for.
 */
#include "FileTools.h"
#include "PointTools.h"
#include "RedGreenRefinementTools.h"

#include "vtkMath.h"

using namespace red_green_refinement_tools;
using namespace point_tools;

namespace
{

double GetDistanceFromPoint(const Point& p, const Point& a)
{
  return std::sqrt(Dot(Subtract(p, a), Subtract(p, a)));
}

Point Combine(const Point& a, double s, const Point& u, double t = 0., const Point& v = {})
{
  return { a[0] + s * u[0] + t * v[0], a[1] + s * u[1] + t * v[1], a[2] + s * u[2] + t * v[2] };
}

/// From a line or triangle.
double GetDistance(const Point& p, const std::vector<Point>& corners)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Point& a = corners[i];
    const Point along = Subtract(corners[(i + 1) % corners.size()], a);
    const double length = Dot(along, along);
    const double t = length > 0. ? Dot(Subtract(p, a), along) / length : 0.;
    nearest =
      std::min(nearest, GetDistanceFromPoint(p, Combine(a, std::max(0., std::min(t, 1.)), along)));
  }
  if (corners.size() == 3)
  {
    const Point u = Subtract(corners[1], corners[0]);
    const Point v = Subtract(corners[2], corners[0]);
    const Point w = Subtract(p, corners[0]);
    const double determinant = Dot(u, u) * Dot(v, v) - Dot(u, v) * Dot(u, v);
    const double s = (Dot(v, v) * Dot(w, u) - Dot(u, v) * Dot(w, v)) / determinant;
    const double t = (Dot(u, u) * Dot(w, v) - Dot(u, v) * Dot(w, u)) / determinant;
    if (determinant > 0. && s >= 0. && t >= 0. && s + t <= 1.)
    {
      nearest = std::min(nearest, GetDistanceFromPoint(p, Combine(corners[0], s, u, t, v)));
    }
  }
  return nearest;
}

/// Lines and triangles by the input cell that they come from; boundaries of solids as cell -1.
std::map<vtkIdType, std::vector<Ids>> GetCurved(vtkUnstructuredGrid* grid)
{
  std::map<vtkIdType, std::vector<Ids>> curved;
  std::map<Ids, int> faces;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    const Ids ids = GetCell(grid, i);
    if (ids.size() == 2 || ids.size() == 3)
    {
      curved[GetOrigin(grid, i)].push_back(ids);
    }
    for (std::size_t k = 0; ids.size() == 4 && k < 4; ++k)
    {
      Ids face = ids;
      face.erase(face.begin() + static_cast<std::ptrdiff_t>(k));
      std::sort(face.begin(), face.end());
      ++faces[face];
    }
  }
  for (const auto& [face, count] : faces)
  {
    if (count == 1)
    {
      curved[-1].push_back(face);
    }
  }
  return curved;
}

/// The largest distance of the points of a fine mesh from a coarse one, of each curve and surface
/// by itself.
double MeasureDistance(vtkUnstructuredGrid* fine, vtkUnstructuredGrid* coarse)
{
  double largest = 0.;
  auto cells = GetCurved(coarse);
  for (const auto& [origin, parts] : GetCurved(fine))
  {
    std::set<vtkIdType> points;
    for (const Ids& part : parts)
    {
      points.insert(part.begin(), part.end());
    }
    std::vector<std::vector<Point>> shapes;
    for (const Ids& cell : cells[origin])
    {
      shapes.emplace_back();
      for (vtkIdType id : cell)
      {
        shapes.back().push_back(GetPoint(coarse, id));
      }
    }
    const std::size_t step = 1 + points.size() * shapes.size() / 100000;
    std::size_t number = 0;
    for (vtkIdType point : points)
    {
      if (number++ % step == 0)
      {
        double nearest = std::numeric_limits<double>::infinity();
        for (const auto& shape : shapes)
        {
          nearest = std::min(nearest, GetDistance(GetPoint(fine, point), shape));
        }
        largest = std::max(largest, nearest);
      }
    }
  }
  return largest;
}

Grid RefineTo(vtkUnstructuredGrid* input, double tolerance, bool isRelative = false)
{
  return Refine(input,
    [=](Filter* filter)
    {
      filter->RefineByGeometricErrorOn();
      filter->SetRelativeTolerance(isRelative);
      filter->SetGeometricTolerance(tolerance);
      filter->SetMaximumLevel(7);
      filter->SetPlacementToLimit();
    });
}

/// Curves whose edges cross the limit in their middle: the distance there is none.
Grid MakeZigzag()
{
  std::vector<Point> points;
  std::vector<Cell> cells;
  for (vtkIdType i = 0; i < 12; ++i)
  {
    points.push_back({ 1. * static_cast<double>(i), i % 2 ? 1. : -1., 0. });
    if (i > 0)
    {
      cells.push_back({ VTK_LINE, { i - 1, i } });
    }
  }
  return multi_dimensional_subdivision_tools::MakeGrid(points, cells);
}

}

TEST(RedGreenTolerance, OfGeometryIsMetOnTheZoo)
{
  std::vector<Grid> inputs = { MakeZigzag() };
  for (const coretest::Mesh& mesh : coretest::MakeZooAndRandom())
  {
    const vtkIdType cells = mesh.Cells.GetNumberOfSimplices();
    if (cells > 0 && cells < 9)
    {
      inputs.push_back(MakeGrid(mesh));
    }
  }
  int refined = 0;
  for (const Grid& input : inputs)
  {
    for (double tolerance : { 0.1, 0.04 })
    {
      const Grid output = RefineTo(input, tolerance);
      const int level = GetFinestLevel(output);
      if (level < 3)
      {
        const Grid fine =
          HalveAll(input, level + 3, [](Filter* one) { one->SetPlacementToLimit(); });
        EXPECT_LE(MeasureDistance(fine, output), tolerance) << GetCells(input).size() << " cells";
        refined += level > 0 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(refined, 30);
}

TEST(RedGreenTolerance, InTheUnitsOfTheMeshOrOfItsSize)
{
  // Scaling changes nothing where the tolerance is relative, and counts where it is not.
  const Grid small = MakeGrid(coretest::FindInZoo("Icosahedron"));
  const Grid large = DeepCopy(small);
  for (vtkIdType i = 0; i < small->GetNumberOfPoints(); ++i)
  {
    const Point p = GetPoint(small, i);
    large->GetPoints()->SetPoint(i, 64. * p[0], 64. * p[1], 64. * p[2]);
  }
  EXPECT_EQ(GetCells(RefineTo(small, 0.004, true)), GetCells(RefineTo(large, 0.004, true)));
  EXPECT_EQ(GetCells(RefineTo(small, 0.01)), GetCells(RefineTo(large, 0.64)));
  EXPECT_GT(RefineTo(large, 0.1)->GetNumberOfCells(), RefineTo(small, 0.1)->GetNumberOfCells());
  // Of the diagonal of the box.
  double bounds[6];
  small->GetBounds(bounds);
  const double diagonal =
    std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
  EXPECT_EQ(
    GetCells(RefineTo(small, 0.004, true)), GetCells(RefineTo(small, 0.004 * diagonal, false)));
}

/// Angles between the normals of triangles that share an edge, in degrees.
double MeasureLargestTurn(vtkUnstructuredGrid* grid)
{
  std::map<Ids, std::vector<Point>> normals;
  for (const Ids& ids : GetCells(grid))
  {
    const Point a = GetPoint(grid, ids[0]);
    const Point u = Subtract(GetPoint(grid, ids[1]), a);
    const Point v = Subtract(GetPoint(grid, ids[2]), a);
    const Point normal = { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
      u[0] * v[1] - u[1] * v[0] };
    for (std::size_t k = 0; k < 3; ++k)
    {
      normals[{ std::min(ids[k], ids[(k + 1) % 3]), std::max(ids[k], ids[(k + 1) % 3]) }].push_back(
        normal);
    }
  }
  double largest = 0.;
  for (const auto& [edge, pair] : normals)
  {
    EXPECT_EQ(pair.size(), 2u);
    const double cosine =
      Dot(pair[0], pair[1]) / std::sqrt(Dot(pair[0], pair[0]) * Dot(pair[1], pair[1]));
    largest = std::max(largest, vtkMath::DegreesFromRadians(std::acos(std::min(1., cosine))));
  }
  return largest;
}

TEST(RedGreenTolerance, CurvatureIsMetWhateverTheSize)
{
  const Grid small = MakeGrid(coretest::FindInZoo("Icosahedron"));
  const Grid large = DeepCopy(small);
  for (vtkIdType i = 0; i < small->GetNumberOfPoints(); ++i)
  {
    const Point p = GetPoint(small, i);
    large->GetPoints()->SetPoint(i, 64. * p[0], 64. * p[1], 64. * p[2]);
  }
  auto refineTo = [](vtkUnstructuredGrid* input, double angle)
  {
    return Refine(input,
      [angle](Filter* filter)
      {
        filter->RefineByCurvatureOn();
        filter->SetMaximumAngle(angle);
        filter->SetMaximumLevel(8);
        filter->SetPlacementToLimit();
      });
  };
  for (double angle : { 30., 9. })
  {
    const Grid output = refineTo(small, angle);
    EXPECT_LE(MeasureLargestTurn(output), angle);
    EXPECT_GT(MeasureLargestTurn(output), 0.2 * angle);
    EXPECT_EQ(GetCells(output), GetCells(refineTo(large, angle)));
  }
}

// Flat cells have edges whose ends are one place: what rounding makes of their limits is no arc.
TEST(RedGreenTolerance, EdgesOfNoLengthHaveNoAngle)
{
  const std::string file = file_tools::GetSharedFile("nat_ogs_sphere_zero_volume.vtu");
  const std::string why = file_tools::WhyNotRead(file);
  if (!why.empty())
  {
    GTEST_SKIP() << why;
  }
  const Grid input = file_tools::ReadGrid(file);
  const Grid other = DeepCopy(input);
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    const Point p = GetPoint(input, i);
    other->GetPoints()->SetPoint(i, 1.1 * p[0], 1.1 * p[1], 1.1 * p[2]); // rounded otherwise
  }
  auto refine = [](vtkUnstructuredGrid* grid)
  {
    return Refine(grid,
      [](Filter* filter)
      {
        filter->RefineByCurvatureOn();
        filter->SetMaximumAngle(15.);
        filter->SetMaximumLevel(1);
      });
  };
  const Grid output = refine(input);
  EXPECT_GT(output->GetNumberOfPoints(), input->GetNumberOfPoints() + 1000);
  EXPECT_EQ(output->GetNumberOfPoints(), refine(other)->GetNumberOfPoints());
}

TEST(RedGreenTolerance, CurvatureOfCurvesIsMetAndStraightOnesStay)
{
  const Grid zigzag = Refine(MakeZigzag(),
    [](Filter* filter)
    {
      filter->RefineByCurvatureOn();
      filter->SetMaximumAngle(6.);
      filter->SetMaximumLevel(9);
      filter->SetPlacementToLimit();
    });
  EXPECT_LT(GetFinestLevel(zigzag), 9);
  std::map<vtkIdType, Ids> neighbours;
  for (const Ids& ids : GetCells(zigzag))
  {
    neighbours[ids[0]].push_back(ids[1]);
    neighbours[ids[1]].push_back(ids[0]);
  }
  double largest = 0.;
  for (const auto& [point, others] : neighbours)
  {
    if (others.size() == 2)
    {
      const Point u = Subtract(GetPoint(zigzag, point), GetPoint(zigzag, others[0]));
      const Point v = Subtract(GetPoint(zigzag, others[1]), GetPoint(zigzag, point));
      const double cosine = Dot(u, v) / std::sqrt(Dot(u, u) * Dot(v, v));
      largest = std::max(largest, vtkMath::DegreesFromRadians(std::acos(std::min(1., cosine))));
    }
  }
  EXPECT_LE(largest, 6.);
  EXPECT_GT(largest, 1.);
  const Grid straight = multi_dimensional_subdivision_tools::MakeGrid(
    { { 0., 0., 0. }, { 1., 0., 0. }, { 3., 0., 0. } },
    { { VTK_LINE, { 0, 1 } }, { VTK_LINE, { 1, 2 } } });
  const Grid same = Refine(straight,
    [](Filter* filter)
    {
      filter->RefineByCurvatureOn();
      filter->SetMaximumAngle(0.001);
    });
  EXPECT_EQ(same->GetNumberOfCells(), 2);
}

/// The differences of values along the edges of a mesh from those of a finer one, at eighths; of
/// both, the same mesh with linear placement says which points are where.
double MeasureDifference(vtkUnstructuredGrid* fine, vtkUnstructuredGrid* fineAtLimit,
  vtkUnstructuredGrid* coarse, vtkUnstructuredGrid* coarseAtLimit)
{
  auto getKey = [](vtkUnstructuredGrid* grid, vtkIdType point)
  {
    vtkDataArray* weights = grid->GetPointData()->GetArray("Weights");
    std::vector<double> key(weights->GetNumberOfComponents());
    weights->GetTuple(point, key.data());
    return key;
  };
  std::map<std::vector<double>, double> values;
  vtkDataArray* exact = fineAtLimit->GetPointData()->GetArray("V");
  for (vtkIdType i = 0; i < fine->GetNumberOfPoints(); ++i)
  {
    values[getKey(fine, i)] = exact->GetComponent(i, 0);
  }
  vtkDataArray* own = coarseAtLimit->GetPointData()->GetArray("V");
  double largest = 0.;
  vtkIdType compared = 0;
  ForEdges(coarse,
    [&](vtkIdType a, vtkIdType b)
    {
      const auto first = getKey(coarse, a);
      const auto second = getKey(coarse, b);
      for (int k = 1; k < 8; ++k)
      {
        auto key = first;
        for (std::size_t c = 0; c < key.size(); ++c)
        {
          key[c] = (8 - k) / 8. * first[c] + k / 8. * second[c];
        }
        const auto found = values.find(key);
        if (found != values.end())
        {
          const double value =
            (8 - k) / 8. * own->GetComponent(a, 0) + k / 8. * own->GetComponent(b, 0);
          largest = std::max(largest, std::abs(value - found->second));
          ++compared;
        }
      }
    });
  EXPECT_GT(compared, coarse->GetNumberOfCells());
  return largest;
}

TEST(RedGreenTolerance, OfAttributesIsMetOnTheZoo)
{
  std::vector<Grid> inputs = { MakeZigzag() };
  for (const char* name : { "OpenPolyline", "CrossingLines", "OctahedronSurface", "ClosedFan",
         "ThreeSheets", "SingleTet", "TwoTets", "PinchedTets", "Octahedron", "EverythingAtOnce" })
  {
    inputs.push_back(MakeGrid(coretest::FindInZoo(name)));
  }
  int refined = 0;
  for (const Grid& input : inputs)
  {
    AddWeights(input);
    auto values = MakeArray<vtkDoubleArray>("V", 1, input->GetNumberOfPoints(), -1., 1., 3);
    if (input == inputs[0])
    {
      for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
      {
        values->SetValue(i, GetPoint(input, i)[1]);
      }
    }
    input->GetPointData()->AddArray(values);
    const double range = values->GetRange(0)[1] - values->GetRange(0)[0];
    constexpr double tolerance = 0.02;
    auto run = [&](int placement)
    {
      return Refine(input,
        [placement](Filter* filter)
        {
          filter->RefineByAttributeErrorOn();
          filter->SetAttributeErrorKindToLimitDifference();
          filter->SetAttributeTolerance(tolerance);
          filter->SetInputArrayToProcess(5, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "V");
          filter->SetPlacement(placement);
          filter->SetMaximumLevel(6);
        });
    };
    const Grid coarse = run(Filter::LINEAR);
    const int level = GetFinestLevel(coarse);
    refined += level > 0 ? 1 : 0;
    const int finest = std::min(level + 3, 5);
    const Grid fine =
      HalveAll(input, finest, [](Filter* filter) { filter->SetPlacementToLimit(); });
    const double measured =
      MeasureDifference(HalveAll(input, finest), fine, coarse, run(Filter::LIMIT));
    EXPECT_LE(measured, tolerance * range) << input->GetNumberOfCells() << " cells";
  }
  EXPECT_GT(refined, 7);
}

/// No error is allowed: the limits of size and level end it, and are told.
TEST(RedGreenTolerance, NoneAtAllIsStoppedByTheLimits)
{
  const Grid input = MakeGrid(coretest::FindInZoo("EverythingAtOnce"));
  AddValues(input);
  for (int kind = 0; kind < 3; ++kind)
  {
    auto configure = [kind](Filter* filter, int level, vtkIdType cells)
    {
      filter->SetRefineByGeometricError(kind == 0);
      filter->SetGeometricTolerance(0.);
      filter->SetRefineByAttributeError(kind > 0);
      filter->SetAttributeErrorKind(kind == 1 ? Filter::JUMP : Filter::LIMIT_DIFFERENCE);
      filter->SetAttributeTolerance(0.);
      filter->SetMaximumLevel(level);
      filter->SetMaximumNumberOfCells(cells);
    };
    vtkNew<Messages> messages;
    const Grid byCells =
      Refine(input, [&](Filter* filter) { configure(filter, 60, 3000); }, messages);
    EXPECT_EQ(messages->Warnings.size(), 1u) << kind;
    EXPECT_EQ(messages->CountWarnings("which is MaximumNumberOfCells"), 1) << kind;
    EXPECT_LE(byCells->GetNumberOfCells(), 3000);
    EXPECT_GT(byCells->GetNumberOfCells(), 500);
    const Grid byLevel = Refine(input, [&](Filter* filter) { configure(filter, 2, 3000); });
    EXPECT_EQ(GetFinestLevel(byLevel), 2);
  }
}
