// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchmarkWorst.cxx
 * Meshes in which everything is at one vertex or in one cell, in two sizes: twice the size must
 * take about twice the time.
 */
#include "BenchmarkMeshes.h"
#include "BenchmarkTools.h"

#include "vtkMultiDimensionalSubdivision.h"
#include "vtkSubdivisionSmoothness.h"
#include "vtkSurfaceSubdivision.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace benchmarks
{
namespace
{

using Sizes = std::vector<int>;

const Sizes Usual = { 50000, 100000 };
/// Where k points are computed from k neighbours each, sizes are refused before any work, see
/// Documentation/Guide/Limits.md.
const Sizes Refused = { 100000, 200000 };
/// Much for each cell.
const Sizes Slow = { 5000, 10000 };
/// Of which a step makes 0.45 and 0.9 million.
const Sizes Large = { 112500, 225000 };

using Mesh = vtkSmartPointer<vtkPointSet>;

/// A star with a material of each tetrahedron its own.
Mesh MakeStarOfMaterials(int n)
{
  const auto grid = MakeStar(n);
  vtkNew<vtkIntArray> materials;
  materials->SetName("MaterialId");
  for (int i = 0; i < n; ++i)
  {
    materials->InsertNextValue(i);
  }
  grid->GetCellData()->AddArray(materials);
  return grid;
}

/// n triangles, or quads of two points of the circle each, around a vertex; with a crease at each
/// edge there, which has this sharpness.
Mesh MakeFan(int n, bool ofTriangles, double sharpness = 0.)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(MakeCircle(ofTriangles ? n : 2 * n));
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkDoubleArray> values;
  values->SetName("Sharpness");
  for (vtkIdType i = 0; i < n; ++i)
  {
    const vtkIdType next = (i + 1) % n;
    const vtkIdType triangle[3] = { 1, 2 + i, 2 + next };
    const vtkIdType quad[4] = { 1, 2 + 2 * i, 3 + 2 * i, 2 + 2 * next };
    const vtkIdType line[2] = { 1, ofTriangles ? triangle[1] : quad[1] };
    ofTriangles ? polys->InsertNextCell(3, triangle) : polys->InsertNextCell(4, quad);
    if (sharpness > 0.)
    {
      lines->InsertNextCell(2, line);
      values->InsertNextValue(sharpness);
    }
  }
  values->Resize(values->GetNumberOfTuples() + n);
  for (int i = 0; i < n; ++i)
  {
    values->InsertNextValue(0.);
  }
  mesh->SetPolys(polys);
  if (sharpness > 0.)
  {
    mesh->SetLines(lines);
    mesh->GetCellData()->AddArray(values);
  }
  return mesh;
}

Mesh MakePolygon(int n)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(MakeCircle(n));
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell(n);
  for (vtkIdType i = 0; i < n; ++i)
  {
    polys->InsertCellPoint(2 + i);
  }
  mesh->SetPolys(polys);
  return mesh;
}

/// n triangles of a sheet, about half as many points, each of which is a corner.
Mesh MakeCorners(int n)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> verts;
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkIntArray> flags;
  flags->SetName("Singular");
  constexpr vtkIdType width = 100;
  const vtkIdType height = n / (2 * width);
  for (vtkIdType i = 0; i < (width + 1) * (height + 1); ++i)
  {
    const auto x = static_cast<double>(i % (width + 1));
    const auto y = static_cast<double>(i / (width + 1));
    points->InsertNextPoint(x, y, std::sin(x + y));
    verts->InsertNextCell(1, &i);
    flags->InsertNextValue(1);
  }
  for (vtkIdType i = 0; i < width * height; ++i)
  {
    const vtkIdType a = i / width * (width + 1) + i % width;
    const vtkIdType lower[3] = { a, a + 1, a + width + 1 };
    const vtkIdType upper[3] = { a + 1, a + width + 2, a + width + 1 };
    polys->InsertNextCell(3, lower);
    polys->InsertNextCell(3, upper);
    flags->InsertNextValue(0);
    flags->InsertNextValue(0);
  }
  mesh->SetPoints(points);
  mesh->SetVerts(verts);
  mesh->SetPolys(polys);
  mesh->GetCellData()->AddArray(flags);
  return mesh;
}

/// n quads of a sheet, each second row of which begins with a crease that is sharp for some levels.
Mesh MakeSharpSheet(int n)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> polys;
  constexpr vtkIdType width = 300;
  const vtkIdType height = n / width;
  for (vtkIdType i = 0; i < (width + 1) * (height + 1); ++i)
  {
    const auto x = static_cast<double>(i % (width + 1));
    const auto y = static_cast<double>(i / (width + 1));
    points->InsertNextPoint(x, y, std::sin(x + y));
  }
  for (vtkIdType i = 0; i < width * height; ++i)
  {
    const vtkIdType a = i / width * (width + 1) + i % width;
    const vtkIdType quad[4] = { a, a + 1, a + width + 2, a + width + 1 };
    polys->InsertNextCell(4, quad);
    if (i / width % 2 == 1)
    {
      lines->InsertNextCell(2, quad);
    }
  }
  vtkNew<vtkDoubleArray> values;
  values->SetName("Sharpness");
  values->SetNumberOfTuples(lines->GetNumberOfCells() + polys->GetNumberOfCells());
  values->Fill(0.);
  std::fill_n(values->GetPointer(0), lines->GetNumberOfCells(), 3.5);
  mesh->SetPoints(points);
  mesh->SetLines(lines);
  mesh->SetPolys(polys);
  mesh->GetCellData()->AddArray(values);
  return mesh;
}

template <typename Filter>
Produced Run(Stopwatch& watch, const Mesh& mesh, const std::function<void(Filter*)>& configure)
{
  vtkNew<Filter> filter;
  filter->SetInputDataObject(mesh);
  filter->SetNumberOfLevels(1);
  filter->SetCacheOperator(false);
  configure(filter);
  watch.Time([&]() { filter->Update(); });
  auto* output = vtkPointSet::SafeDownCast(filter->GetOutputDataObject(0));
  return { static_cast<double>(output->GetNumberOfCells()),
    1024. * static_cast<double>(output->GetActualMemorySize()) };
}

template <typename Filter>
void Add(
  const std::string& name, const std::function<Mesh(int)>& make,
  const std::function<void(Filter*)>& configure = [](Filter*) {}, const Sizes& sizes = Usual,
  int repetitions = 0)
{
  for (const int size : sizes)
  {
    Register(
      "worst/" + name + "/" + std::to_string(size) + "/levels:1", 1,
      [=](Stopwatch& watch) { return Run<Filter>(watch, make(size), configure); }, repetitions);
  }
}

/// The limit at n places beside a vertex of eight faces, all in one of these.
template <typename Filter>
void AddPlaces(
  const std::string& name, bool ofTriangles, const std::function<void(Filter*)>& configure)
{
  for (const int size : Usual)
  {
    Register("worst/" + name + ", places in a cell/" + std::to_string(size) + "/levels:0", 1,
      [=](Stopwatch& watch)
      {
        vtkNew<Filter> filter;
        filter->SetInputDataObject(MakeFan(8, ofTriangles));
        configure(filter);
        vtkNew<vtkIdTypeArray> cells;
        vtkNew<vtkDoubleArray> parameters;
        parameters->SetNumberOfComponents(3);
        for (int i = 0; i < size; ++i)
        {
          cells->InsertNextValue(0);
          parameters->InsertNextTuple3((i + 0.5) / size, 0.3 * (1. - (i + 0.5) / size), 0.);
        }
        vtkNew<vtkPolyData> result;
        watch.Time([&]() { filter->EvaluateLimit(cells, parameters, result); });
        return Produced{ static_cast<double>(result->GetNumberOfPoints()),
          1024. * static_cast<double>(result->GetActualMemorySize()) };
      });
  }
}

/// Eigenvalues and maps at a vertex of n faces, which are too many for these, and at all others.
void AddSmoothness(const std::string& name, bool ofTriangles, int kind)
{
  for (const int size : Usual)
  {
    Register("worst/Smoothness, " + name + "/" + std::to_string(size) + "/levels:0", 1,
      [=](Stopwatch& watch)
      {
        vtkNew<vtkSubdivisionSmoothness> filter;
        filter->SetInputDataObject(MakeFan(size, ofTriangles));
        filter->SetScheme(kind);
        watch.Time([&]() { filter->Update(); });
        return Produced{ static_cast<double>(filter->GetOutput()->GetNumberOfCells()),
          1024. * static_cast<double>(filter->GetOutput()->GetActualMemorySize()) };
      });
  }
}

void RegisterWorst()
{
  using Main = vtkMultiDimensionalSubdivision;
  using Surface = vtkSurfaceSubdivision;
  const auto tets = [](int n) { return MakeStar(n); };
  Add<Main>("tetrahedra at an edge", tets);
  Add<Main>("tetrahedra at an edge, tet-oct", tets,
    [](Main* filter) { filter->SetVolumeSchemeToTetOct(); });
  Add<Main>("tetrahedra at an edge, limit normals", tets,
    [](Main* filter)
    {
      filter->ProjectToLimitOn();
      filter->GenerateLimitNormalsOn();
    });
  Add<Main>(
    "materials at an edge", [](int n) { return MakeStarOfMaterials(n); },
    [](Main* filter) { filter->PreserveInterfacesOn(); });
  Add<Main>(
    "creases at a vertex", [](int n) { return MakeFan(n, true, 1e9); },
    [](Main* filter)
    {
      filter->SetInputArrayToProcess(4, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Sharpness");
    });
  Add<Main>("polygon, cut", MakePolygon);
  const struct
  {
    const char* Name;
    int Kind;
    bool OfTriangles;
  } schemes[] = {
    { "Loop", Surface::LOOP, true },
    { "Butterfly", Surface::MODIFIED_BUTTERFLY, true },
    { "sqrt3", Surface::SQRT_THREE, true },
    { "Catmull-Clark", Surface::CATMULL_CLARK, false },
    { "Doo-Sabin", Surface::DOO_SABIN, false },
    { "Midedge", Surface::MIDEDGE, false },
    { "4-8", Surface::FOUR_EIGHT, false },
  };
  for (const auto& scheme : schemes)
  {
    const std::string name = scheme.Name;
    const int kind = scheme.Kind;
    const bool ofTriangles = scheme.OfTriangles;
    const std::function<Mesh(int)> fan = [=](int n) { return MakeFan(n, ofTriangles); };
    const Sizes& ofVertex = kind == Surface::MODIFIED_BUTTERFLY ? Refused : Usual;
    const Sizes& ofPolygon = kind == Surface::DOO_SABIN ? Refused : Usual;
    const bool isLinear = kind != Surface::MODIFIED_BUTTERFLY && kind != Surface::DOO_SABIN &&
      kind != Surface::FOUR_EIGHT;
    const Sizes& ofLimits = isLinear ? Usual : Refused;
    const auto plain = [=](Surface* filter) { filter->SetScheme(kind); };
    const auto limits = [=](Surface* filter)
    {
      filter->SetScheme(kind);
      filter->ProjectToLimitOn();
      filter->GenerateLimitNormalsOn();
      filter->GenerateTangentsOn();
    };
    Add<Surface>(name + ", vertex", fan, plain, ofVertex);
    Add<Surface>(name + ", vertex, limits", fan, limits, ofLimits);
    if (!ofTriangles)
    {
      Add<Surface>(name + ", polygon", MakePolygon, plain, ofPolygon);
      Add<Surface>(name + ", polygon, limits", MakePolygon, limits, ofLimits);
    }
    AddSmoothness(name, ofTriangles, vtkSubdivisionSmoothness::LOOP + kind);
  }
  Add<Surface>(
    "Loop, creases at a vertex", [](int n) { return MakeFan(n, true, 1e9); },
    [](Surface* filter) { filter->GenerateLimitNormalsOn(); });
  Add<Surface>(
    "Loop, sharpness left at the limit", [](int n) { return MakeFan(n, true, 3.5); },
    [](Surface* filter)
    {
      filter->SetInputArrayToProcess(4, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Sharpness");
      filter->ProjectToLimitOn();
    },
    Slow);
  if (!IsQuick()) // some minutes
  {
    Add<Surface>(
      "Catmull-Clark, sharpness left at the limit", MakeSharpSheet,
      [](Surface* filter)
      {
        filter->SetSchemeToCatmullClark();
        filter->SetInputArrayToProcess(
          4, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Sharpness");
        filter->ProjectToLimitOn();
      },
      Large, 1);
  }
  const std::function<Mesh(int)> triangles = [](int n) { return MakeFan(n, true); };
  const std::function<Mesh(int)> quads = [](int n) { return MakeFan(n, false); };
  Add<Main>(
    "Bezier cells", triangles, [](Main* filter) { filter->SetOutputCellsToBezier(); }, Slow);
  Add<Surface>(
    "Bezier cells, Loop", triangles, [](Surface* filter) { filter->SetOutputCellsToBezier(); },
    Slow);
  Add<Surface>(
    "Bezier cells, Catmull-Clark", quads,
    [](Surface* filter)
    {
      filter->SetSchemeToCatmullClark();
      filter->SetOutputCellsToBezier();
    },
    Slow);
  Add<Main>(
    "error bounds, tetrahedra at an edge", tets,
    [](Main* filter) { filter->GenerateErrorBoundsOn(); }, Slow);
  Add<Surface>(
    "error bounds, Loop", triangles, [](Surface* filter) { filter->GenerateErrorBoundsOn(); },
    Slow);
  AddPlaces<Main>("main filter", true, [](Main*) {});
  AddPlaces<Surface>("Loop", true, [](Surface*) {});
  AddPlaces<Surface>(
    "Catmull-Clark", false, [](Surface* filter) { filter->SetSchemeToCatmullClark(); });
  Add<Surface>("Loop, corners everywhere, limits", MakeCorners,
    [](Surface* filter)
    {
      filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Singular");
      filter->ProjectToLimitOn();
      filter->GenerateLimitNormalsOn();
      filter->GenerateTangentsOn();
    });
}

const Registration Registered(RegisterWorst);

}
}
