// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestBezierTolerance.cxx
 * BezierTolerance is kept: cells that were not split as often as is allowed are nowhere farther
 * from the limit than it says, at the same parameters.
 */
#include "BezierTools.h"
#include "PlaceTools.h"
#include "Turns.h"

#include "Private/Bezier/PatchShape.h"

#include "vtkXMLUnstructuredGridWriter.h"

using namespace bezier_tools;
using place_tools::Evaluate;
using place_tools::Places;
using subdivision::FrameNode;
using subdivision::LatticePart;
using subdivision::PatchShape;

namespace
{

using Evaluator = std::function<vtkSmartPointer<vtkPolyData>(const Places&)>;

const PatchShape& GetShape(int type)
{
  return PatchShape::Get(type == VTK_LINE ? PatchShape::Curve
      : type == VTK_TRIANGLE              ? PatchShape::Triangle
      : type == VTK_QUAD                  ? PatchShape::Quad
                                          : PatchShape::Tetrahedron);
}

/// Where a place of a part is in the whole cell, whose axes have `Divisions` parts.
constexpr int Divisions = 1 << 12;
Point FindPlace(const LatticePart& part, const Point& at)
{
  Point place{};
  for (int x = 0; x < 3; ++x)
  {
    place[x] = part.Origin[x];
    for (int axis = 0; axis < 3; ++axis)
    {
      place[x] += at[axis] * part.Axes[axis][x];
    }
    place[x] /= Divisions;
  }
  return place;
}

/// Which part of a cell of the input each Bezier cell is: the one whose corners have the limits
/// that are its corners.
class PartFinder
{
public:
  struct Part
  {
    vtkIdType Cell;
    int Level;
    LatticePart Of;
  };

  PartFinder(vtkDataSet* input, vtkUnstructuredGrid* bezier, int levels, Evaluator evaluate)
    : Input(input)
    , Bezier(bezier)
    , Levels(levels)
    , Evaluate(std::move(evaluate))
  {
  }
  const std::vector<Part>& Find()
  {
    this->FindCorners();
    for (vtkIdType c = 0; c < this->Input->GetNumberOfCells(); ++c)
    {
      LatticePart whole;
      const int dimension = GetShape(this->Input->GetCellType(c)).Dimension;
      for (int axis = 0; axis < dimension; ++axis)
      {
        whole.Axes[axis][axis] = Divisions;
      }
      this->Take({ c, 0, whole });
    }
    EXPECT_EQ(static_cast<vtkIdType>(this->Parts.size()), this->Bezier->GetNumberOfCells());
    return this->Parts;
  }

private:
  /// The limits of the corners of all cells, at once.
  void FindCorners()
  {
    Places places;
    std::vector<std::pair<vtkIdType, FrameNode>> keys;
    for (vtkIdType c = 0; c < this->Input->GetNumberOfCells(); ++c)
    {
      for (FrameNode at : GetShape(this->Input->GetCellType(c)).CornerPoints)
      {
        places.Add(c, { at[0] / 2., at[1] / 2., at[2] / 2. });
        std::transform(at.begin(), at.end(), at.begin(), [](int x) { return x * Divisions / 2; });
        keys.emplace_back(c, at);
      }
    }
    const auto limits = this->Evaluate(places);
    for (std::size_t i = 0; i < keys.size(); ++i)
    {
      this->Limits[keys[i]] = GetPoint(limits, static_cast<vtkIdType>(i));
    }
  }
  void Take(const Part& part)
  {
    if (this->IsNext(part))
    {
      this->Parts.push_back(part);
      return;
    }
    ASSERT_LT(part.Level, this->Levels) << "no Bezier cell is here in cell " << part.Cell;
    for (const LatticePart& child : GetShape(this->Input->GetCellType(part.Cell)).Children)
    {
      this->Take({ part.Cell, part.Level + 1, part.Of.Take(child) });
    }
  }
  bool IsNext(const Part& part)
  {
    const auto next = static_cast<vtkIdType>(this->Parts.size());
    if (next >= this->Bezier->GetNumberOfCells())
    {
      return false;
    }
    const PatchShape& shape = GetShape(this->Input->GetCellType(part.Cell));
    const Ids ids = GetCell(this->Bezier, next);
    for (int k = 0; k < shape.Corners; ++k)
    {
      const Point limit = this->FindLimit(part.Cell, part.Of.At(shape.CornerPoints[k], 2));
      const Point corner = GetPoint(this->Bezier, ids[k]);
      for (int x = 0; x < 3; ++x)
      {
        if (std::abs(limit[x] - corner[x]) > 1e-10)
        {
          return false;
        }
      }
    }
    return true;
  }
  Point FindLimit(vtkIdType cell, const FrameNode& at)
  {
    const auto made = this->Limits.emplace(std::make_pair(cell, at), Point{});
    if (made.second)
    {
      Places place;
      place.Add(
        cell, { at[0] / double(Divisions), at[1] / double(Divisions), at[2] / double(Divisions) });
      made.first->second = GetPoint(this->Evaluate(place), 0);
    }
    return made.first->second;
  }

  vtkDataSet* Input;
  vtkUnstructuredGrid* Bezier;
  int Levels;
  Evaluator Evaluate;
  std::vector<Part> Parts;
  std::map<std::pair<vtkIdType, FrameNode>, Point> Limits;
};

/// Places everywhere in a cell: not those where the filter looks. `areFew`: for limits that take
/// long.
std::vector<Point> MakePlacesInside(const PatchShape& shape, bool areFew)
{
  std::vector<Point> places;
  const int steps = areFew ? 5 : shape.Dimension == 3 ? 7 : 11;
  for (int k = 0; k <= (shape.Dimension > 2 ? steps : 0); ++k)
  {
    for (int j = 0; j <= (shape.Dimension > 1 ? steps : 0); ++j)
    {
      for (int i = 0; i <= steps; ++i)
      {
        if (shape.CellType == VTK_BEZIER_QUADRILATERAL || i + j + k <= steps)
        {
          places.push_back({ i / double(steps), j / double(steps), k / double(steps) });
        }
      }
    }
  }
  return places;
}

/// Two poles and n points around, in random places, as triangles.
Grid MakeBipyramid(int n)
{
  std::vector<Point> points{ { 0., 0., 1. }, { 0., 0., -1. } };
  std::vector<Cell> cells;
  for (vtkIdType i = 0; i < n; ++i)
  {
    const double angle = 2. * 3.14159265358979 * static_cast<double>(i) / n;
    points.push_back({ std::cos(angle), std::sin(angle), 0. });
    cells.push_back({ VTK_TRIANGLE, { 2 + i, 2 + (i + 1) % n, 0 } });
    cells.push_back({ VTK_TRIANGLE, { 2 + (i + 1) % n, 2 + i, 1 } });
  }
  const Grid grid = MakeGrid(Shake(points, 0.2), cells);
  AddScalar(grid);
  return grid;
}

/// Five tetrahedra around an edge, whose ends and which are extraordinary.
Grid MakeTets()
{
  std::vector<Point> points{ { 0., 0., 1. }, { 0., 0., -1. } };
  std::vector<Cell> cells;
  for (vtkIdType i = 0; i < 5; ++i)
  {
    const double angle = 2. * 3.14159265358979 * static_cast<double>(i) / 5.;
    points.push_back({ std::cos(angle), std::sin(angle), 0. });
    cells.push_back({ VTK_TETRA, { 0, 1, 2 + i, 2 + (i + 1) % 5 } });
  }
  const Grid grid = MakeGrid(Shake(points, 0.1), cells);
  AddScalar(grid);
  return grid;
}

/// The weights of control points at places of Bezier cells, which are those of all cells of a type
/// and degree.
class Weights
{
public:
  const std::vector<double>& Get(vtkUnstructuredGrid* bezier, vtkIdType c, const Point& at)
  {
    const vtkIdType size = bezier->GetCells()->GetCellSize(c);
    std::vector<double>& weights = this->Known[{ { bezier->GetCellType(c), size }, at }];
    if (weights.empty())
    {
      vtkCell* cell = bezier->GetCell(c);
      weights.resize(static_cast<std::size_t>(cell->GetNumberOfPoints()));
      cell->InterpolateFunctions(at.data(), weights.data());
    }
    return weights;
  }

private:
  std::map<std::pair<std::array<vtkIdType, 2>, Point>, std::vector<double>> Known;
};

/// What was compared, and the largest errors as parts of what the tolerance allows.
struct Found
{
  double OfPoints = 0.;
  double OfValues = 0.;
  vtkIdType Places = 0;
  vtkIdType Parts = 0; ///< cells that are a part of a cell of the input

  void Expect(vtkIdType parts) const
  {
    std::cout << this->Places << " places, " << this->Parts << " parts: points " << this->OfPoints
              << ", values " << this->OfValues << " of the tolerance\n";
    EXPECT_LE(this->OfPoints, 1.);
    EXPECT_LE(this->OfValues, 1.);
    EXPECT_GT(std::max(this->OfPoints, this->OfValues), 0.5)
      << "meshes without errors show nothing";
    EXPECT_GE(this->Parts, turns::GetTurn() < 0 ? parts : parts / 6); // some rounds have few
  }
};

/// Compares the Bezier cells that were not split as often as is allowed with the limit. `size`: the
/// limit as a mesh, of which the tolerance is a part.
void Compare(vtkDataSet* input, vtkUnstructuredGrid* bezier, int levels, double tolerance,
  vtkDataSet* size, const Evaluator& evaluate, Found& found, bool areFew = false)
{
  Places places;
  std::vector<std::pair<vtkIdType, Point>> inBezier;
  PartFinder finder(input, bezier, levels, evaluate);
  const auto& parts = finder.Find();
  for (vtkIdType c = 0; c < static_cast<vtkIdType>(parts.size()); ++c)
  {
    if (parts[c].Level == levels)
    {
      continue;
    }
    found.Parts += parts[c].Level > 0 ? 1 : 0;
    for (const Point& at : MakePlacesInside(GetShape(input->GetCellType(parts[c].Cell)), areFew))
    {
      inBezier.emplace_back(c, at);
      places.Add(parts[c].Cell, FindPlace(parts[c].Of, at));
    }
  }
  found.Places += places.GetSize();
  const auto limits = evaluate(places);
  double range[2];
  size->GetPointData()->GetArray("Scalar")->GetRange(range);
  vtkDataArray* wanted = limits->GetPointData()->GetArray("Scalar");
  vtkDataArray* values = bezier->GetPointData()->GetArray("Scalar");
  Weights weights;
  for (std::size_t i = 0; i < inBezier.size(); ++i)
  {
    const auto& [c, at] = inBezier[i];
    const std::vector<double>& shares = weights.Get(bezier, c, at);
    const Ids ids = GetCell(bezier, c);
    Point difference = GetPoint(limits, static_cast<vtkIdType>(i));
    double ofValue = wanted->GetComponent(static_cast<vtkIdType>(i), 0);
    for (std::size_t k = 0; k < ids.size(); ++k)
    {
      const Point control = GetPoint(bezier, ids[k]);
      for (int x = 0; x < 3; ++x)
      {
        difference[x] -= shares[k] * control[x];
      }
      ofValue -= shares[k] * values->GetComponent(ids[k], 0);
    }
    const double distance = std::hypot(difference[0], difference[1], difference[2]);
    found.OfPoints = std::max(found.OfPoints, distance / (tolerance * size->GetLength()));
    found.OfValues =
      std::max(found.OfValues, std::abs(ofValue) / (tolerance * (range[1] - range[0])));
  }
}

/// By the main filter. From level 0 on the order of corners in solids is that of the box spline.
void CheckGrid(
  vtkUnstructuredGrid* mesh, int levels, double tolerance, Found& found, bool areFew = false)
{
  vtkNew<Filter> filter;
  filter->SetNumberOfLevels(0);
  const Grid input = UpdateWithoutErrors<vtkUnstructuredGrid>(filter.Get(), mesh);
  const Grid bezier =
    MakeBezier(input, levels, [=](Filter* made) { made->SetBezierTolerance(tolerance); });
  filter->SetNumberOfLevels(3);
  filter->ProjectToLimitOn();
  const Grid limit = UpdateWithoutErrors<vtkUnstructuredGrid>(filter.Get(), input);
  Compare(
    input, bezier, levels, tolerance, limit,
    [&](const Places& places) { return Evaluate(filter, places); }, found, areFew);
}

void CheckSurface(vtkPolyData* input, int scheme, int levels, double tolerance, Found& found)
{
  const Grid bezier = MakeBezierSurface(input, scheme, levels, tolerance);
  vtkNew<vtkSurfaceSubdivision> filter;
  filter->SetInputData(input);
  filter->SetScheme(scheme);
  filter->SetNumberOfLevels(4);
  filter->ProjectToLimitOn();
  filter->Update();
  vtkNew<vtkPolyData> limit;
  limit->ShallowCopy(filter->GetOutput());
  Compare(
    input, bezier, levels, tolerance, limit,
    [&](const Places& places) { return Evaluate(filter, places); }, found);
}

void CheckSurface(vtkUnstructuredGrid* mesh, int scheme, int levels, double tolerance, Found& found)
{
  CheckSurface(ToSurface(mesh), scheme, levels, tolerance, found);
}

constexpr double Tolerances[3] = { 1e-2, 1e-3, 1e-4 };

}

TEST(BezierTolerance, IsKeptByTrianglesOfBothFilters)
{
  Found found[2];
  for (const double tolerance : Tolerances)
  {
    for (const int n : turns::Some({ 3, 5, 8, 12 }))
    {
      CheckGrid(MakeBipyramid(n), 5, tolerance, found[0]);
      CheckSurface(MakeBipyramid(n), vtkSurfaceSubdivision::LOOP, 5, tolerance, found[1]);
    }
    CheckGrid(MakeSheet(3, true, 0.2), 5, tolerance, found[0]);
    CheckSurface(MakeSheet(3, true, 0.2), vtkSurfaceSubdivision::LOOP, 5, tolerance, found[1]);
  }
  found[0].Expect(1500);
  found[1].Expect(1500);
}

TEST(BezierTolerance, IsKeptByQuads)
{
  Found found;
  for (const double tolerance : Tolerances)
  {
    for (const int n : turns::Some({ 3, 5, 8, 12 }))
    {
      CheckSurface(MakeTrapezohedron(n), vtkSurfaceSubdivision::CATMULL_CLARK, 5, tolerance, found);
    }
    CheckSurface(
      MakeSheet(3, false, 0.2), vtkSurfaceSubdivision::CATMULL_CLARK, 5, tolerance, found);
  }
  found.Expect(1500);
}

TEST(BezierTolerance, IsKeptBySolids)
{
  Found found;
  for (const double tolerance : { 1e-2, 3e-3, 1e-3, 3e-4 })
  {
    CheckGrid(MakeLattice(1), 2, tolerance, found);
    CheckGrid(MakeTets(), 2, tolerance, found);
  }
  found.Expect(20);
}

/// Lines are faces of triangles and tetrahedra, and triangles of tetrahedra, in both orders.
TEST(BezierTolerance, IsKeptByFacesOfOtherCells)
{
  Found found;
  CheckGrid(MakeMixed(false), 1, 2.2e-2, found, true);
  CheckGrid(MakeMixed(true), 1, 2.2e-2, found, true);
  found.Expect(0);
}

TEST(BezierTolerance, IsKeptByLinesOfSurfaces)
{
  for (const int scheme : { vtkSurfaceSubdivision::LOOP, vtkSurfaceSubdivision::CATMULL_CLARK })
  {
    Found found;
    for (const double tolerance : Tolerances)
    {
      for (const int n : turns::Some({ 4, 5, 8 }))
      {
        const bool isLoop = scheme == vtkSurfaceSubdivision::LOOP;
        const auto surface = ToSurface(isLoop ? MakeBipyramid(n) : MakeTrapezohedron(n));
        vtkNew<vtkCellArray> lines;
        for (const vtkIdType first : { 2, 3, 4 })
        {
          lines->InsertNextCell({ first, first + 1 });
        }
        lines->InsertNextCell({ 0, 2 });
        surface->SetLines(lines);
        CheckSurface(surface, scheme, 5, tolerance, found);
      }
    }
    found.Expect(1000);
  }
}

namespace
{

/// The bytes of a .vtu file, as VTK writes it by default, of points and cells.
std::size_t MeasureFile(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkUnstructuredGrid> bare;
  bare->CopyStructure(grid);
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(bare);
  writer->WriteToOutputStringOn();
  writer->Write();
  return writer->GetOutputString().size();
}

}

/// Linear cells on the limit need so many levels that their error bounds are below the tolerance.
TEST(BezierTolerance, FilesAreSmallerThanOfLinearCells)
{
  for (const int n : { 4, 5 })
  {
    const Grid input = MakeBipyramid(n);
    for (const double tolerance : { 1e-2, 1e-3 })
    {
      const Grid bezier =
        MakeBezier(input, 5, [=](Filter* made) { made->SetBezierTolerance(tolerance); });
      vtkNew<Filter> filter;
      filter->ProjectToLimitOn();
      filter->GenerateErrorBoundsOn();
      Grid linear;
      double range[2] = { 0., 1e9 };
      for (int levels = 1; levels < 7 && range[1] > tolerance * bezier->GetLength(); ++levels)
      {
        filter->SetNumberOfLevels(levels);
        linear = UpdateWithoutErrors<vtkUnstructuredGrid>(filter.Get(), input);
        linear->GetCellData()->GetArray("ErrorBound")->GetRange(range);
      }
      ASSERT_LE(range[1], tolerance * bezier->GetLength());
      const std::size_t sizes[2] = { MeasureFile(bezier), MeasureFile(linear) };
      std::cout << bezier->GetNumberOfCells() << " and " << linear->GetNumberOfCells() << " cells, "
                << sizes[0] << " and " << sizes[1] << " bytes\n";
      EXPECT_LT(sizes[0], sizes[1]);
    }
  }
}
