// SPDX-License-Identifier: BSD-3-Clause
#include "BezierTools.h"

#include "vtkGenericCell.h"

namespace bezier_tools
{

Grid MakeBezier(vtkDataObject* input, int levels, const Configure& configure)
{
  vtkNew<Filter> filter;
  filter->SetVolumeSchemeToBoxSpline();
  filter->SetNumberOfLevels(levels);
  filter->SetOutputCellsToBezier();
  if (configure)
  {
    configure(filter);
  }
  return UpdateWithoutErrors<vtkUnstructuredGrid>(filter.Get(), input);
}

Grid MakeBezierSurface(vtkDataObject* input, int scheme, int levels, double tolerance)
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

Grid MakeMixed(bool areFirst)
{
  std::vector<Point> points{ { 0., 0., 1. }, { 0., 0., -1. } };
  std::vector<Cell> cells;
  for (vtkIdType i = 0; i < 5; ++i)
  {
    const double angle = 2. * 3.14159265358979 * static_cast<double>(i) / 5.;
    points.push_back({ std::cos(angle), std::sin(angle), 0. });
    cells.push_back({ VTK_TETRA, { 0, 1, 2 + i, 2 + (i + 1) % 5 } });
  }
  points.insert(points.end(), { { 2., 0.3, 0.5 }, { 2., -0.3, -0.5 }, { 3., 0., 0.2 } });
  const std::vector<Cell> faces{ { VTK_TRIANGLE, { 0, 2, 3 } }, { VTK_TRIANGLE, { 0, 1, 4 } },
    { VTK_LINE, { 0, 2 } }, { VTK_LINE, { 0, 1 } }, { VTK_LINE, { 5, 6 } },
    { VTK_TRIANGLE, { 0, 2, 7 } }, { VTK_TRIANGLE, { 2, 8, 7 } }, { VTK_TRIANGLE, { 7, 8, 9 } },
    { VTK_LINE, { 7, 8 } }, { VTK_LINE, { 8, 9 } }, { VTK_LINE, { 9, 3 } } };
  cells.insert(areFirst ? cells.begin() : cells.end(), faces.begin(), faces.end());
  if (areFirst)
  {
    std::reverse(cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(faces.size()));
  }
  Grid grid = MakeGrid(Shake(points, 0.1), cells);
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

Grid MakeOctahedron()
{
  std::vector<Cell> octahedron;
  for (const vtkIdType top : { 4, 5 })
  {
    for (vtkIdType i = 0; i < 4; ++i)
    {
      octahedron.push_back({ VTK_TRIANGLE, { i, (i + 1) % 4, top } });
    }
  }
  return MakeGrid(Shake({ { { 1., 0., 0. } }, { { 0., 1., 0. } }, { { -1., 0., 0. } },
                          { { 0., -1., 0. } }, { { 0., 0., 1. } }, { { 0., 0., -1. } } },
                    0.2),
    octahedron);
}

Grid MakeTrapezohedron(int n)
{
  std::vector<Point> points{ { 0., 0., 1. }, { 0., 0., -1. } };
  std::vector<Cell> cells;
  for (vtkIdType i = 0; i < n; ++i)
  {
    for (const double side : { 0., 1. })
    {
      const double angle = 3.14159265358979 * (2. * static_cast<double>(i) + side) / n;
      points.push_back({ std::cos(angle), std::sin(angle), 0.5 - side });
    }
    const vtkIdType here = 2 + 2 * i;
    const vtkIdType next = 2 + 2 * ((i + 1) % n);
    cells.push_back({ VTK_QUAD, { 0, here, here + 1, next } });
    cells.push_back({ VTK_QUAD, { 1, next + 1, next, here + 1 } });
  }
  const Grid grid = MakeGrid(Shake(points, 0.1), cells);
  AddScalar(grid);
  return grid;
}

Grid TakeSolids(vtkUnstructuredGrid* mesh)
{
  std::vector<Point> points;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    points.push_back(GetPoint(mesh, i));
  }
  std::vector<Cell> cells;
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
  {
    if (mesh->GetCellType(c) == VTK_TETRA)
    {
      cells.push_back({ VTK_TETRA, GetCell(mesh, c) });
    }
  }
  return MakeGrid(points, cells);
}

Grid TakeBoundary(vtkUnstructuredGrid* solid)
{
  std::map<Ids, Ids> once;
  for (vtkIdType c = 0; c < solid->GetNumberOfCells(); ++c)
  {
    const Ids ids = GetCell(solid, c);
    for (const Ids& face : { Ids{ ids[1], ids[2], ids[3] }, Ids{ ids[0], ids[3], ids[2] },
           Ids{ ids[0], ids[1], ids[3] }, Ids{ ids[0], ids[2], ids[1] } })
    {
      Ids sorted = face;
      std::sort(sorted.begin(), sorted.end());
      if (!once.emplace(sorted, face).second)
      {
        once.erase(sorted);
      }
    }
  }
  const auto boundary = Grid::New();
  boundary->SetPoints(solid->GetPoints());
  for (const auto& [sorted, face] : once)
  {
    boundary->InsertNextCell(VTK_TRIANGLE, 3, face.data());
  }
  return boundary;
}

}
