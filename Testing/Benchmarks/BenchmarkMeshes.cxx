// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkMeshes.h"

#include "Private/vtkSubdivisionObjectsCompat.h"

#include "vtkMultiDimensionalSubdivision.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <stdexcept>

namespace benchmarks
{
namespace
{

/// Some smooth function of the place.
double ScalarAt(const double* x)
{
  return x[0] + 2. * x[1] * x[1] + std::sin(3. * x[2]);
}

void AddPoint(FlatMesh& mesh, double x, double y, double z)
{
  const double point[3] = { x, y, z };
  mesh.Points.insert(mesh.Points.end(), point, point + 3);
  mesh.Scalar.push_back(ScalarAt(point));
}

/// Leaves one double scalar on the points, and no other array.
void SetScalar(vtkPointSet* mesh)
{
  vtkNew<vtkDoubleArray> scalar;
  scalar->SetName("Scalar");
  scalar->SetNumberOfTuples(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double x[3];
    mesh->GetPoint(i, x);
    scalar->SetValue(i, ScalarAt(x));
  }
  mesh->GetPointData()->Initialize();
  mesh->GetCellData()->Initialize();
  mesh->GetFieldData()->Initialize();
  mesh->GetPointData()->SetScalars(scalar);
}

}

vtkSmartPointer<vtkPoints> MakeCircle(int n)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->InsertNextPoint(0., 0., -1.);
  points->InsertNextPoint(0., 0., 1.);
  for (int i = 0; i < n; ++i)
  {
    const double angle = 2. * 3.141592653589793 * i / n;
    points->InsertNextPoint(std::cos(angle), std::sin(angle), 0.);
  }
  return points;
}

vtkSmartPointer<vtkUnstructuredGrid> MakeStar(int n)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(MakeCircle(n));
  grid->Allocate(n);
  for (int i = 0; i < n; ++i)
  {
    const vtkIdType ids[4] = { 0, 1, 2 + i, 2 + (i + 1) % n };
    grid->InsertNextCell(VTK_TETRA, 4, ids);
  }
  return grid;
}

std::string GetDataFolder()
{
  const char* folder = std::getenv("SUBDIVISIONOBJECTS_SHARED_DATA");
  return folder ? folder : SUBDIVISIONOBJECTS_SHARED_DATA;
}

namespace
{

FlatMesh MakeLattice(int n)
{
  FlatMesh mesh;
  for (int k = 0; k <= n; ++k)
  {
    for (int j = 0; j <= n; ++j)
    {
      for (int i = 0; i <= n; ++i)
      {
        AddPoint(mesh, double(i) / n, double(j) / n, double(k) / n);
      }
    }
  }
  return mesh;
}

}

FlatMesh MakeHexahedra(int n)
{
  FlatMesh mesh = MakeLattice(n);
  mesh.Corners = 8;
  const int row = n + 1;
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        const int a = i + row * (j + row * k);
        for (const int corner : { a, a + row * row })
        {
          mesh.Cells.insert(
            mesh.Cells.end(), { corner, corner + 1, corner + row + 1, corner + row });
        }
      }
    }
  }
  return mesh;
}

FlatMesh MakeCube(int n)
{
  FlatMesh mesh = MakeLattice(n);
  mesh.Corners = 4;
  const int step[3] = { 1, n + 1, (n + 1) * (n + 1) };
  const int orders[6][3] = { { 0, 1, 2 }, { 1, 2, 0 }, { 2, 0, 1 }, { 1, 0, 2 }, { 0, 2, 1 },
    { 2, 1, 0 } };
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        for (int o = 0; o < 6; ++o)
        {
          const int a = i * step[0] + j * step[1] + k * step[2];
          const int b = a + step[orders[o][0]];
          const int c = b + step[orders[o][1]];
          const int d = c + step[orders[o][2]];
          const int even[4] = { a, b, c, d };
          const int odd[4] = { a, c, b, d };
          mesh.Cells.insert(mesh.Cells.end(), o < 3 ? even : odd, (o < 3 ? even : odd) + 4);
        }
      }
    }
  }
  return mesh;
}

FlatMesh MakeSphere(int levels)
{
  FlatMesh mesh;
  mesh.Corners = 3;
  auto add = [&mesh](double x, double y, double z)
  {
    const double length = std::sqrt(x * x + y * y + z * z);
    AddPoint(mesh, x / length, y / length, z / length);
    return mesh.GetNumberOfPoints() - 1;
  };
  const double g = (1. + std::sqrt(5.)) / 2.;
  for (double s : { 1., -1. })
  {
    for (double t : { g, -g })
    {
      add(0., s, t);
      add(s, t, 0.);
      add(t, 0., s);
    }
  }
  const auto near = [&mesh](int a, int b)
  {
    double square = 0.;
    for (int c = 0; c < 3; ++c)
    {
      const double d = mesh.Points[3 * a + c] - mesh.Points[3 * b + c];
      square += d * d;
    }
    return square < 1.2; // edges of an icosahedron in a unit sphere: 1.106
  };
  for (int a = 0; a < 12; ++a)
  {
    for (int b = a + 1; b < 12; ++b)
    {
      for (int c = b + 1; c < 12; ++c)
      {
        if (near(a, b) && near(b, c) && near(a, c))
        {
          const double* p = mesh.Points.data() + 3 * a;
          const double* q = mesh.Points.data() + 3 * b;
          const double* r = mesh.Points.data() + 3 * c;
          const double volume = p[0] * (q[1] * r[2] - q[2] * r[1]) +
            p[1] * (q[2] * r[0] - q[0] * r[2]) + p[2] * (q[0] * r[1] - q[1] * r[0]);
          const int triangle[3] = { a, volume > 0. ? b : c, volume > 0. ? c : b };
          mesh.Cells.insert(mesh.Cells.end(), triangle, triangle + 3);
        }
      }
    }
  }
  for (int level = 0; level < levels; ++level)
  {
    std::map<std::array<int, 2>, int> middles;
    auto middle = [&](int a, int b)
    {
      const std::array<int, 2> edge = { std::min(a, b), std::max(a, b) };
      auto found = middles.find(edge);
      if (found == middles.end())
      {
        const std::vector<double>& x = mesh.Points;
        const int added =
          add(x[3 * a] + x[3 * b], x[3 * a + 1] + x[3 * b + 1], x[3 * a + 2] + x[3 * b + 2]);
        found = middles.emplace(edge, added).first;
      }
      return found->second;
    };
    std::vector<int> cells;
    for (std::size_t t = 0; t < mesh.Cells.size(); t += 3)
    {
      const int* v = mesh.Cells.data() + t;
      const int m[3] = { middle(v[0], v[1]), middle(v[1], v[2]), middle(v[2], v[0]) };
      cells.insert(
        cells.end(), { v[0], m[0], m[2], m[0], v[1], m[1], m[2], m[1], v[2], m[0], m[1], m[2] });
    }
    mesh.Cells = cells;
  }
  return mesh;
}

FlatMesh MakeBumpySphere(int levels)
{
  FlatMesh mesh = MakeSphere(levels);
  for (int i = 0; i < mesh.GetNumberOfPoints(); ++i)
  {
    double* x = mesh.Points.data() + 3 * i;
    const double bumps = 0.1 * std::sin(6. * x[0]) * std::cos(7. * x[1]) +
      0.02 * std::sin(31. * x[1]) * std::sin(29. * x[2]) +
      0.002 * std::sin(97. * x[2]) * std::cos(89. * x[0]);
    std::transform(x, x + 3, x, [bumps](double c) { return (1. + bumps) * c; });
  }
  return mesh;
}

FlatMesh MakeTorus(int n)
{
  FlatMesh mesh;
  mesh.Corners = 3;
  const double step = 2. * 3.14159265358979323846 / n;
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      const double radius = 1. + 0.4 * std::cos(step * j);
      AddPoint(
        mesh, radius * std::cos(step * i), radius * std::sin(step * i), 0.4 * std::sin(step * j));
      const int nextI = (i + 1) % n;
      const int nextJ = (j + 1) % n;
      const int corners[4] = { n * i + j, n * nextI + j, n * nextI + nextJ, n * i + nextJ };
      mesh.Cells.insert(mesh.Cells.end(),
        { corners[0], corners[1], corners[2], corners[0], corners[2], corners[3] });
    }
  }
  return mesh;
}

FlatMesh MakeQuadSphere(int n)
{
  FlatMesh mesh;
  mesh.Corners = 4;
  mesh.HasQuads = true;
  std::map<std::array<int, 3>, int> ids; // by the place on the surface of a cube
  auto find = [&](const std::array<int, 3>& at)
  {
    const auto [found, isNew] = ids.emplace(at, mesh.GetNumberOfPoints());
    if (isNew)
    {
      const double x = 2. * at[0] / n - 1.;
      const double y = 2. * at[1] / n - 1.;
      const double z = 2. * at[2] / n - 1.;
      const double length = std::sqrt(x * x + y * y + z * z);
      AddPoint(mesh, x / length, y / length, z / length);
    }
    return found->second;
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int side : { 0, n })
    {
      for (int i = 0; i < n * n; ++i)
      {
        auto corner = [&](int u, int v)
        {
          std::array<int, 3> at{};
          at[axis] = side;
          at[(axis + 1) % 3] = i % n + u;
          at[(axis + 2) % 3] = i / n + v;
          return find(at);
        };
        const int quad[4] = { corner(0, 0), side ? corner(1, 0) : corner(0, 1), corner(1, 1),
          side ? corner(0, 1) : corner(1, 0) };
        mesh.Cells.insert(mesh.Cells.end(), quad, quad + 4);
      }
    }
  }
  return mesh;
}

vtkSmartPointer<vtkPointSet> ToVtk(const FlatMesh& mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh.GetNumberOfPoints());
  for (int i = 0; i < mesh.GetNumberOfPoints(); ++i)
  {
    points->SetPoint(i, mesh.Points.data() + 3 * i);
  }
  vtkNew<vtkCellArray> cells;
  for (int c = 0; c < mesh.GetNumberOfCells(); ++c)
  {
    vtkIdType ids[8];
    std::copy_n(mesh.Cells.data() + mesh.Corners * c, mesh.Corners, ids);
    cells->InsertNextCell(mesh.Corners, ids);
  }
  vtkSmartPointer<vtkPointSet> result;
  if (mesh.Corners == 3 || mesh.HasQuads)
  {
    vtkNew<vtkPolyData> surface;
    surface->SetPolys(cells);
    result = surface;
  }
  else
  {
    vtkNew<vtkUnstructuredGrid> grid;
    grid->SetCells(mesh.Corners == 8 ? VTK_HEXAHEDRON : VTK_TETRA, cells);
    result = grid;
  }
  result->SetPoints(points);
  SetScalar(result);
  return result;
}

vtkSmartPointer<vtkPointSet> MakePolylines(int polylines, int lines)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (int p = 0; p < polylines; ++p)
  {
    cells->InsertNextCell(lines + 1);
    for (int i = 0; i <= lines; ++i)
    {
      const double t = 0.02 * i;
      const double x[3] = { t, p + std::sin(t), std::cos(t) };
      cells->InsertCellPoint(points->InsertNextPoint(x));
    }
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetLines(cells);
  SetScalar(result);
  return result;
}

vtkSmartPointer<vtkPointSet> ReadFile(const std::string& path)
{
  if (!std::ifstream(path).good())
  {
    return nullptr;
  }
  vtkSmartPointer<vtkPointSet> result;
  auto read = [&](auto* reader)
  {
    reader->SetFileName(path.c_str());
    reader->Update();
    result.TakeReference(reader->GetOutput()->NewInstance());
    result->ShallowCopy(reader->GetOutput());
  };
  if (path.back() == 'p')
  {
    read(vtkNew<vtkXMLPolyDataReader>().Get());
  }
  else
  {
    read(vtkNew<vtkXMLUnstructuredGridReader>().Get());
  }
  SetScalar(result);
  return result;
}

FlatMesh ReadTriangles(const std::string& path)
{
  FlatMesh mesh;
  mesh.Corners = 3;
  const auto surface = ReadFile(path);
  if (!surface)
  {
    return mesh;
  }
  std::vector<int> numbers(static_cast<std::size_t>(surface->GetNumberOfPoints()), -1);
  vtkDataArray* scalar = surface->GetPointData()->GetScalars();
  vtkNew<vtkIdList> corners;
  for (vtkIdType c = 0; c < surface->GetNumberOfCells(); ++c)
  {
    surface->GetCellPoints(c, corners);
    for (vtkIdType i = 0; corners->GetNumberOfIds() == 3 && i < 3; ++i)
    {
      const vtkIdType point = corners->GetId(i);
      if (numbers[point] < 0)
      {
        numbers[point] = mesh.GetNumberOfPoints();
        double x[3];
        surface->GetPoint(point, x);
        mesh.Points.insert(mesh.Points.end(), x, x + 3);
        mesh.Scalar.push_back(scalar->GetComponent(point, 0));
      }
      mesh.Cells.push_back(numbers[point]);
    }
  }
  return mesh;
}

const std::vector<Case>& GetCases()
{
  static const std::vector<Case> cases = []()
  {
    std::vector<Case> made = {
      { "cube", 3, []() { return ToVtk(MakeCube(12)); } },
      { "sphere", 3, []() { return ToVtk(MakeSphere(5)); } },
      { "polylines", 3, []() { return MakePolylines(1000, 1000); } },
      { "hexahedra", 3, []() { return ToVtk(MakeHexahedra(22)); } },
    };
    for (const char* name :
      { "large_porepy_case3_500k.vtu", "tet_geos_synthetic.vtu", "surf_bunny_full.vtp" })
    {
      const std::string path = GetDataFolder() + "/" + name;
      if (std::ifstream(path).good())
      {
        made.push_back({ name, 2, [path]() { return ReadFile(path); } });
      }
    }
    return made;
  }();
  return cases;
}

const Case& GetCase(const char* name)
{
  for (const Case& which : GetCases())
  {
    if (which.Name == name)
    {
      return which;
    }
  }
  throw std::invalid_argument(std::string("no such case: ") + name);
}

vtkPointSet* GetInput(const Case& which)
{
  static std::map<std::string, vtkSmartPointer<vtkPointSet>> inputs;
  vtkSmartPointer<vtkPointSet>& input = inputs[which.Name];
  if (!input)
  {
    input = which.Make();
  }
  return input;
}

OutputSize MeasureOutput(vtkUnstructuredGrid* output)
{
  auto bytes = [](vtkDataArray* array)
  { return static_cast<std::size_t>(array->GetNumberOfValues()) * array->GetDataTypeSize(); };
  OutputSize size;
  size.Cells = static_cast<double>(output->GetNumberOfCells());
  size.Points = static_cast<double>(output->GetNumberOfPoints());
  size.Bytes = 1024. * static_cast<double>(output->GetActualMemorySize());
  size.Arrays = { bytes(output->GetPoints()->GetData()),
    bytes(output->GetPointData()->GetScalars()), bytes(output->GetCells()->GetConnectivityArray()),
    bytes(output->GetCells()->GetOffsetsArray()), bytes(subdivision::GetCellTypes(output)) };
  if (vtkDataArray* pieces = output->GetCellData()->GetArray("OctahedronId"))
  {
    size.Arrays.push_back(bytes(pieces));
  }
  return size;
}

const OutputSize& GetOutputSize(const Case& which, int levels)
{
  static std::map<std::string, OutputSize> sizes;
  OutputSize& size = sizes[which.Name + std::to_string(levels)];
  if (size.Arrays.empty())
  {
    vtkNew<vtkMultiDimensionalSubdivision> filter;
    filter->SetInputData(GetInput(which));
    filter->SetNumberOfLevels(levels);
    filter->SetMaximumNumberOfCells(VTK_ID_MAX);
    filter->SmoothShadingOff();
    filter->Update();
    size = MeasureOutput(filter->GetOutput());
  }
  return size;
}

}
