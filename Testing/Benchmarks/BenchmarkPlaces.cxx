// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BenchmarkPlaces.cxx
 * Limits at places between vertices: to make their rows, with all topology that they need, to apply
 * rows that are ready, and EvaluateLimit of the filters as it is called. The places and what is
 * made there are those of the limit stencils of OpenSubdiv (Peers/PeerOpenSubdiv.cxx): points and
 * two derivatives, in double.
 */
#include "BenchmarkPlaces.h"
#include "BenchmarkMeshes.h"
#include "BenchmarkTools.h"

#include "Core/Operators/ApplyRows.h"
#include "Core/Solids/AllSchemes/VolumeSchemes.h"
#include "Core/Solids/Complex/TetOrder.h"
#include "Core/Solids/Limits/PlaceLimits.h"
#include "Core/Surfaces/Places/SurfacePlaces.h"
#include "Core/Surfaces/Scheme/SurfaceTags.h"
#include "Core/Surfaces/Steps/SurfaceSchemes.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiDimensionalSubdivision.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkSurfaceSubdivision.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace benchmarks
{
namespace
{

using namespace subdivision;

/// A mesh, and places in all of its cells.
struct Control
{
  explicit Control(FlatMesh mesh)
    : Mesh(std::move(mesh))
  {
    const SimplexList cells = this->ListCells();
    for (int cell = 0; cell < this->Mesh.GetNumberOfCells(); ++cell)
    {
      for (int i = 0; i < PlacesOfCell; ++i)
      {
        LimitPlace<int> place;
        place.Dimension = this->Mesh.Corners - 1;
        for (int k = 0; k < this->Mesh.Corners; ++k)
        {
          place.Corners[k] = static_cast<int>(cells.Connectivity[this->Mesh.Corners * cell + k]);
        }
        const std::array<double, 2> at = GetPlace(i);
        place.Parameters = { { at[0], at[1], place.Dimension == 3 ? 0.1 : 0. } };
        this->Places.push_back(place);
      }
    }
  }

  SimplexList ListCells() const
  {
    SimplexList cells;
    cells.NumberOfPoints = this->Mesh.GetNumberOfPoints();
    cells.Dimensions.assign(
      this->Mesh.GetNumberOfCells(), static_cast<unsigned char>(this->Mesh.Corners - 1));
    cells.Connectivity.assign(this->Mesh.Cells.begin(), this->Mesh.Cells.end());
    OrderTets(cells, this->Mesh.Points.data(), nullptr, 0);
    return cells;
  }
  Level<int> MakeLevel() const
  {
    Level<int> level;
    std::vector<CellRun> runs;
    level.Complex = BuildComplex<int>(this->ListCells(), runs);
    level.Strata = BuildStrata(level.Complex, SingularSimplices(), StrataOptions());
    return level;
  }

  FlatMesh Mesh;
  std::vector<LimitPlace<int>> Places;
};

/// Moves points, so that tetrahedra mark other edges, and nothing is regular on most faces.
FlatMesh Bend(FlatMesh mesh)
{
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    mesh.Points[i] += 0.12 * std::sin(7. * static_cast<double>(i));
  }
  return mesh;
}

/// Of the rows of values alone.
std::size_t GetMemorySize(const PlaceRows<int>& rows)
{
  return rows.Offsets.GetMemorySize() + rows.Columns.GetMemorySize() +
    rows.Weights[PlaceParts::Value].GetMemorySize();
}

Produced MakeRows(Stopwatch& watch, const Control& control, PlaceDerivatives derivatives)
{
  Level<int> level;
  std::unique_ptr<PlaceLimits<int>> limits;
  watch.Time(
    [&]()
    {
      level = control.MakeLevel();
      limits = std::make_unique<PlaceLimits<int>>(
        level, SemiSharpStages<int>(), control.Places, derivatives);
    });
  return { static_cast<double>(control.Places.size()),
    static_cast<double>(GetMemorySize(limits->Rows)) };
}

Produced ApplyRows(Stopwatch& watch, const Control& control)
{
  static const Level<int> level = control.MakeLevel();
  static const PlaceLimits<int> limits(
    level, SemiSharpStages<int>(), control.Places, PlaceDerivatives::First);
  const auto places = static_cast<vtkIdType>(control.Places.size());
  const vtkIdType size = 3 * places;
  Buffer<double> results[3];
  watch.Time(
    [&]()
    {
      for (Buffer<double>& result : results)
      {
        result = Buffer<double>(size);
      }
      // In blocks, so that columns are still in the cache for the next part.
      constexpr vtkIdType block = 256;
      ForRanges(places,
        [&](vtkIdType first, vtkIdType last)
        {
          for (vtkIdType begin = first; begin < last; begin += block)
          {
            const vtkIdType end = std::min(begin + block, last);
            for (int part = 0; part < 3; ++part)
            {
              SumRows(limits.Rows.GetRows(part, begin, end), control.Mesh.Points.data(),
                results[part].data(), 3);
            }
          }
        });
    });
  return { static_cast<double>(control.Places.size()), 24. * static_cast<double>(size) };
}

/// A surface, and the same places in all of its faces.
struct SurfaceControl
{
  SurfaceControl(FlatMesh mesh, SurfaceSchemeKind kind)
    : Mesh(std::move(mesh))
    , Scheme(MakeSurfaceScheme<int>(kind, true))
  {
    for (int face = 0; face < this->Mesh.GetNumberOfCells(); ++face)
    {
      for (int i = 0; i < PlacesOfCell; ++i)
      {
        SurfacePlace<int> place;
        place.Dimension = 2;
        place.Part = face;
        place.At = GetPlace(i);
        this->Places.push_back(place);
      }
    }
  }

  SurfaceLevel<int> MakeLevel() const
  {
    const FlatMesh& mesh = this->Mesh;
    SurfaceLevel<int> level;
    const auto ids = static_cast<vtkIdType>(mesh.Cells.size());
    PolygonList<int> list;
    list.NumberOfVertices = mesh.GetNumberOfPoints();
    list.FaceOffsets = Buffer<int>(vtkIdType(mesh.GetNumberOfCells()) + 1);
    list.Vertices = Buffer<int>(ids);
    list.Segments = Buffer<int>(0);
    std::copy(mesh.Cells.begin(), mesh.Cells.end(), list.Vertices.begin());
    for (int face = 0; face <= mesh.GetNumberOfCells(); ++face)
    {
      list.FaceOffsets[face] = mesh.Corners * face;
    }
    level.Mesh = BuildPolygonMesh(std::move(list), level.Lines);
    level.Tags = ClassifySurface(level.Mesh, *this->Scheme, SurfaceFeatures(), mesh.Points.data());
    this->Scheme->Prepare(level);
    return level;
  }

  FlatMesh Mesh;
  std::shared_ptr<const SurfaceScheme<int>> Scheme;
  std::vector<SurfacePlace<int>> Places;
};

Produced MakeSurfaceRows(
  Stopwatch& watch, const SurfaceControl& control, PlaceDerivatives derivatives)
{
  PlaceRows<int> rows;
  watch.Time(
    [&]()
    {
      rows = FindSurfacePlaces(
        *control.Scheme, control.MakeLevel(), SharpCreases<int>(), control.Places, derivatives);
    });
  return { static_cast<double>(control.Places.size()), static_cast<double>(GetMemorySize(rows)) };
}

/// The call of a filter: cells and parameters in, points with derivatives, normals, curvatures and
/// arrays out.
template <typename Filter>
Produced CallEvaluateLimit(Stopwatch& watch, const FlatMesh& mesh, Filter* filter)
{
  vtkNew<vtkIdTypeArray> cells;
  vtkNew<vtkDoubleArray> parameters;
  parameters->SetNumberOfComponents(3);
  for (int cell = 0; cell < mesh.GetNumberOfCells(); ++cell)
  {
    for (int i = 0; i < PlacesOfCell; ++i)
    {
      const std::array<double, 2> at = GetPlace(i);
      cells->InsertNextValue(cell);
      parameters->InsertNextTuple3(at[0], at[1], 0.);
    }
  }
  filter->SetInputDataObject(ToVtk(mesh));
  vtkNew<vtkPolyData> result;
  watch.Time([&]() { filter->EvaluateLimit(cells, parameters, result); });
  return { static_cast<double>(result->GetNumberOfPoints()), 0. };
}

Produced CallOnSurface(Stopwatch& watch, const FlatMesh& mesh, int scheme)
{
  vtkNew<vtkSurfaceSubdivision> filter;
  filter->SetScheme(scheme);
  return CallEvaluateLimit(watch, mesh, filter.Get());
}

void RegisterPlaces()
{
  static const SurfaceControl triangles(MakeSphere(4), SurfaceSchemeKind::Loop);
  static const SurfaceControl quads(MakeQuadSphere(29), SurfaceSchemeKind::CatmullClark);
  static const Control sphere(MakeSphere(4));
  static const Control cube(MakeCube(3));
  static const Control bent(Bend(MakeCube(3)));
  for (const int threads : ThreadCounts)
  {
    for (const PlaceDerivatives most : { PlaceDerivatives::First, PlaceDerivatives::Second })
    {
      const std::string make = most == PlaceDerivatives::First
        ? "places/make rows/"
        : "places/make rows with second derivatives/";
      Register(make + "sphere/levels:0", threads,
        [most](Stopwatch& watch) { return MakeRows(watch, sphere, most); });
      Register(make + "cube of solids/levels:0", threads,
        [most](Stopwatch& watch) { return MakeRows(watch, cube, most); });
      Register(make + "bent cube of solids/levels:0", threads,
        [most](Stopwatch& watch) { return MakeRows(watch, bent, most); });
      Register(make + "sphere by Loop/levels:0", threads,
        [most](Stopwatch& watch) { return MakeSurfaceRows(watch, triangles, most); });
      Register(make + "sphere of quads by CatmullClark/levels:0", threads,
        [most](Stopwatch& watch) { return MakeSurfaceRows(watch, quads, most); });
    }
    const std::string call = "places/EvaluateLimit/";
    Register(call + "sphere/levels:0", threads,
      [](Stopwatch& watch)
      {
        vtkNew<vtkMultiDimensionalSubdivision> filter;
        return CallEvaluateLimit(watch, sphere.Mesh, filter.Get());
      });
    Register(call + "sphere by Loop/levels:0", threads, [](Stopwatch& watch)
      { return CallOnSurface(watch, triangles.Mesh, vtkSurfaceSubdivision::LOOP); });
    Register(call + "sphere of quads by CatmullClark/levels:0", threads, [](Stopwatch& watch)
      { return CallOnSurface(watch, quads.Mesh, vtkSurfaceSubdivision::CATMULL_CLARK); });
    Register("places/apply rows/sphere/levels:0", threads,
      [](Stopwatch& watch) { return ApplyRows(watch, sphere); });
  }
}

const Registration Registered(RegisterPlaces);

}
}
