// SPDX-License-Identifier: BSD-3-Clause
#include "GapCases.h"

#include "BenchmarkMeshes.h"

#include "vtkAdaptiveSurfaceSubdivision.h"
#include "vtkExtractDimensions.h"
#include "vtkMultiDimensionalSubdivision.h"
#include "vtkRedGreenRefinement.h"
#include "vtkSimplicialComplexTopology.h"
#include "vtkSubdivisionCageSource.h"
#include "vtkSubdivisionDeformation.h"
#include "vtkSubdivisionLabelSolid.h"
#include "vtkSubdivisionModelSource.h"
#include "vtkSurfaceSubdivision.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphere.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace benchmarks
{
namespace
{

using Algorithm = vtkSmartPointer<vtkAlgorithm>;
using Mesh = vtkSmartPointer<vtkPointSet>;
using Main = vtkMultiDimensionalSubdivision;
using Surface = vtkSurfaceSubdivision;
using RedGreen = vtkRedGreenRefinement;
using Adaptive = vtkAdaptiveSurfaceSubdivision;
using Deformation = vtkSubdivisionDeformation;

int Scaled(int n, double scale, double dimension = 3.)
{
  return std::max(1, static_cast<int>(std::lround(n * std::pow(scale, 1. / dimension))));
}

Mesh MakeSolid(int n, double scale)
{
  return ToVtk(MakeCube(Scaled(n, scale)));
}

/// Two materials, in layers, and a field that each of them has its own values of.
Mesh MakeLayers(int n, double scale)
{
  const Mesh mesh = MakeSolid(n, scale);
  vtkNew<vtkIntArray> materials;
  materials->SetName("MaterialId");
  materials->SetNumberOfTuples(mesh->GetNumberOfCells());
  const vtkIdType layer = mesh->GetNumberOfCells() / 4 + 1;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    materials->SetValue(i, static_cast<int>(i / layer % 2));
  }
  mesh->GetCellData()->AddArray(materials);
  return mesh;
}

/// Hexahedra of an image, of which grids are made when they are read.
vtkSmartPointer<vtkImageData> MakeImage(int n, double scale)
{
  const int cells = Scaled(n, scale);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(cells + 1, cells + 1, cells + 1);
  image->SetSpacing(1. / cells, 1. / cells, 1. / cells);
  return image;
}

/// An unstructured grid of hexahedra.
Mesh MakeHexahedra(int n, double scale)
{
  const auto image = MakeImage(n, scale);
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    points->InsertNextPoint(image->GetPoint(i));
  }
  grid->SetPoints(points);
  grid->Allocate(image->GetNumberOfCells());
  vtkNew<vtkIdList> voxel;
  for (vtkIdType i = 0; i < image->GetNumberOfCells(); ++i)
  {
    image->GetCellPoints(i, voxel);
    vtkIdType* const ids = voxel->GetPointer(0);
    std::swap(ids[2], ids[3]);
    std::swap(ids[6], ids[7]);
    grid->InsertNextCell(VTK_HEXAHEDRON, 8, ids);
  }
  return grid;
}

/// Quadratic tetrahedra, each with points of its own.
Mesh MakeQuadratic(int n, double scale)
{
  const FlatMesh cube = MakeCube(Scaled(n, scale));
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  grid->Allocate(cube.GetNumberOfCells());
  constexpr int edges[6][2] = { { 0, 1 }, { 1, 2 }, { 0, 2 }, { 0, 3 }, { 1, 3 }, { 2, 3 } };
  for (int c = 0; c < cube.GetNumberOfCells(); ++c)
  {
    std::array<double, 3> corners[4];
    std::array<vtkIdType, 10> ids;
    for (int i = 0; i < 4; ++i)
    {
      std::copy_n(cube.Points.data() + 3 * cube.Cells[4 * c + i], 3, corners[i].data());
      ids[i] = points->InsertNextPoint(corners[i].data());
    }
    for (int e = 0; e < 6; ++e)
    {
      const auto& a = corners[edges[e][0]];
      const auto& b = corners[edges[e][1]];
      ids[4 + e] = points->InsertNextPoint((a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2);
    }
    grid->InsertNextCell(VTK_QUADRATIC_TETRA, 10, ids.data());
  }
  grid->SetPoints(points);
  return grid;
}

/// A sphere of triangles or quads of `levels` steps from the coarse one, as any other mesh.
Mesh MakeSurface(bool ofTriangles, int levels, double scale)
{
  vtkNew<Surface> filter;
  filter->SetInputData(ofTriangles ? ToVtk(MakeSphere(5)) : ToVtk(MakeQuadSphere(58)));
  filter->SetScheme(ofTriangles ? Surface::LOOP : Surface::CATMULL_CLARK);
  filter->SetNumberOfLevels(
    std::max(0, levels + static_cast<int>(std::lround(std::log(scale) / std::log(4.)))));
  filter->Update();
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->ShallowCopy(filter->GetOutput());
  mesh->GetFieldData()->Initialize(); // without the stamp
  return mesh;
}

/// A block beside another one.
Mesh MakeMoved(vtkPointSet* mesh, double x)
{
  auto moved = Mesh::Take(mesh->NewInstance());
  moved->DeepCopy(mesh);
  for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
  {
    double at[3];
    moved->GetPoint(i, at);
    moved->GetPoints()->SetPoint(i, at[0] + x, at[1], at[2]);
  }
  return moved;
}

vtkSmartPointer<vtkDataObject> MakeBlocks(vtkPointSet* mesh)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetBlock(0, mesh);
  blocks->SetBlock(1, MakeMoved(mesh, 1.));
  return blocks;
}

Mesh MakeCloud(int n, double scale)
{
  const auto image = MakeImage(n, scale);
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* x = image->GetPoint(i);
    points->InsertNextPoint(0.2 + 0.6 * x[0], 0.2 + 0.6 * x[1], 0.2 + 0.6 * x[2]);
  }
  cloud->SetPoints(points);
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("Vectors");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(points->GetNumberOfPoints());
  vectors->FillValue(1.);
  cloud->GetPointData()->SetVectors(vectors);
  return cloud;
}

/// A ball of label 2 in a cube of label 1, and some background.
vtkSmartPointer<vtkImageData> MakeLabels(int n, double scale)
{
  const auto image = MakeImage(n, scale);
  image->AllocateScalars(VTK_INT, 1);
  auto* labels = vtkIntArray::SafeDownCast(image->GetPointData()->GetScalars());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* x = image->GetPoint(i);
    const double r = std::hypot(x[0] - 0.5, x[1] - 0.5, x[2] - 0.5);
    labels->SetValue(i, r < 0.3 ? 2 : r < 0.48 ? 1 : 0);
  }
  labels->SetName("Label");
  return image;
}

vtkSmartPointer<vtkSphere> MakeBall(double centre, double radius)
{
  auto ball = vtkSmartPointer<vtkSphere>::New();
  ball->SetCenter(centre, centre, centre);
  ball->SetRadius(radius);
  return ball;
}

template <typename Filter>
using Configure = std::function<void(Filter*)>;
using MakeInput = std::function<vtkSmartPointer<vtkDataObject>(double)>;

template <typename Filter>
GapCase MakeCase(const std::string& name, const MakeInput& makeInput,
  const Configure<Filter>& configure, const std::function<void(vtkAlgorithm*)>& change = nullptr)
{
  return { name,
    [=](double scale) -> Algorithm
    {
      auto filter = vtkSmartPointer<Filter>::New();
      filter->SetInputDataObject(0, makeInput(scale));
      configure(filter);
      return filter;
    },
    change };
}

/// Other coordinates of the same mesh.
void MovePoints(vtkAlgorithm* algorithm)
{
  auto* input = vtkPointSet::SafeDownCast(algorithm->GetInputDataObject(0, 0));
  algorithm->SetInputDataObject(0, MakeMoved(input, 0.5));
}

void AddMain(std::vector<GapCase>& cases)
{
  const MakeInput coarse = [](double scale) { return MakeSolid(12, scale); };
  const MakeInput fine = [](double scale) { return MakeSolid(50, scale); };
  const MakeInput layers = [](double scale) { return MakeLayers(12, scale); };
  const auto add = [&](const std::string& name, const MakeInput& input, int levels,
                     const Configure<Main>& configure,
                     const std::function<void(vtkAlgorithm*)>& change = nullptr)
  {
    cases.push_back(MakeCase<Main>(
      "main, " + name, input,
      [=](Main* filter)
      {
        filter->SetNumberOfLevels(levels);
        configure(filter);
      },
      change));
  };
  const auto plain = [](Main*) {};
  add("large", [](double scale) { return MakeSolid(18, scale); }, 3, plain);
  constexpr const char* schemes[] = { "box spline", "tet/oct", "linear" };
  for (int scheme : { Main::BOX_SPLINE, Main::TET_OCT, Main::LINEAR })
  {
    const std::string name = schemes[scheme];
    add(name, coarse, 3, [=](Main* filter) { filter->SetVolumeScheme(scheme); });
    add(name + ", limits, normals", coarse, 3,
      [=](Main* filter)
      {
        filter->SetVolumeScheme(scheme);
        filter->ProjectToLimitOn();
        filter->GenerateLimitNormalsOn();
      });
    add(name + ", fine input", fine, 1, [=](Main* filter) { filter->SetVolumeScheme(scheme); });
    add(name + ", fine input, limits, normals", fine, 1,
      [=](Main* filter)
      {
        filter->SetVolumeScheme(scheme);
        filter->ProjectToLimitOn();
        filter->GenerateLimitNormalsOn();
      });
  }
  add("no levels", [](double scale) { return MakeSolid(94, scale); }, 0, plain);
  add("no cache", coarse, 3, [](Main* filter) { filter->CacheOperatorOff(); });
  add("interpolation", coarse, 3,
    [](Main* filter)
    {
      filter->InterpolatePointsOn();
      filter->InterpolateArraysOn();
    });
  add("interpolation, fine input", fine, 1,
    [](Main* filter)
    {
      filter->InterpolatePointsOn();
      filter->InterpolateArraysOn();
    });
  add("kept", coarse, 3, plain, MovePoints);
  add("kept, fine input", fine, 1, plain, MovePoints);
  add("kept, limits", coarse, 3, [](Main* filter) { filter->ProjectToLimitOn(); }, MovePoints);
  const Configure<Main> interfaces = [](Main* filter) { filter->PreserveInterfacesOn(); };
  const Configure<Main> jumps = [](Main* filter)
  {
    filter->PreserveInterfacesOn();
    filter->SetInterfaceValuesToDiscontinuous();
  };
  add("interfaces", layers, 3, interfaces);
  add("interfaces, fine input", [](double scale) { return MakeLayers(50, scale); }, 1, interfaces);
  add("values that jump", layers, 3, jumps);
  add("values that jump, fine input", [](double scale) { return MakeLayers(50, scale); }, 1, jumps);
  add("features", fine, 1, [](Main* filter) { filter->DetectFeaturesOn(); });
  add("marks", fine, 1,
    [](Main* filter)
    {
      filter->MarkByFunctionOn();
      filter->SetMarkFunction(MakeBall(0.5, 0.3));
      filter->MarkCornersOn();
      filter->MarkCreasesOn();
      filter->MarkSurfacesOn();
    });
  add("all arrays", coarse, 3,
    [](Main* filter)
    {
      filter->GenerateClassificationOn();
      filter->GenerateOriginalIdsOn();
      filter->GenerateGlobalIdsOn();
      filter->Use32BitIdsOn();
    });
  add("all arrays, fine input", fine, 1,
    [](Main* filter)
    {
      filter->GenerateClassificationOn();
      filter->GenerateOriginalIdsOn();
      filter->GenerateGlobalIdsOn();
    });
  add("triangles", fine, 1, [](Main* filter) { filter->SetOutputDimensions(Main::TRIANGLES); });
  const Configure<Main> types = [](Main* filter) { filter->KeepCellTypesOn(); };
  add("types", [](double scale) { return MakeHexahedra(20, scale); }, 3, types);
  add("types, fine input", [](double scale) { return MakeHexahedra(90, scale); }, 1, types);
  add("hexahedra", [](double scale) { return MakeHexahedra(90, scale); }, 0, plain);
  add("image", [](double scale) { return MakeImage(90, scale); }, 0, plain);
  add(
    "quadratic pieces", [](double scale) { return MakeQuadratic(45, scale); }, 0,
    [](Main* filter) { filter->SetQuadraticCellsToPieces(); });
  add(
    "polylines", [](double scale) { return MakePolylines(Scaled(2000, scale, 1.), 1000); }, 2,
    plain);
  add("surface", [](double scale) { return MakeSurface(true, 3, scale); }, 1, plain);
  for (const bool joins : { true, false })
  {
    const std::string name = joins ? "joined blocks" : "blocks";
    add(
      name, [](double scale) { return MakeBlocks(MakeSolid(10, scale)); }, 3,
      [=](Main* filter) { filter->SetJoinBlocks(joins); });
    add(
      name + ", fine input", [](double scale) { return MakeBlocks(MakeSolid(40, scale)); }, 1,
      [=](Main* filter) { filter->SetJoinBlocks(joins); });
  }
  cases.push_back({ "main, of its own output",
    [=](double scale) -> Algorithm
    {
      auto first = vtkSmartPointer<Main>::New();
      first->SetInputDataObject(0, coarse(scale));
      first->SetNumberOfLevels(2);
      first->Update();
      auto second = vtkSmartPointer<Main>::New();
      second->SetInputDataObject(0, first->GetOutputDataObject(0));
      second->SetNumberOfLevels(1);
      return second;
    },
    nullptr });
}

void AddSurfaces(std::vector<GapCase>& cases)
{
  constexpr struct
  {
    const char* Name;
    int Kind;
    bool OfTriangles;
    int Levels;
    int LevelsOfFine;
  } schemes[] = {
    { "Loop", Surface::LOOP, true, 4, 1 },
    { "butterfly", Surface::MODIFIED_BUTTERFLY, true, 4, 1 },
    { "Catmull-Clark", Surface::CATMULL_CLARK, false, 4, 1 },
    { "Doo-Sabin", Surface::DOO_SABIN, false, 4, 1 },
    { "midedge", Surface::MIDEDGE, false, 8, 2 },
    { "4-8", Surface::FOUR_EIGHT, false, 8, 2 },
    { "sqrt(3)", Surface::SQRT_THREE, true, 5, 1 },
    { "linear", Surface::LINEAR, false, 4, 1 },
  };
  for (const auto& scheme : schemes)
  {
    const MakeInput coarse = [=](double scale)
    { return MakeSurface(scheme.OfTriangles, 0, scale); };
    const MakeInput fine = [=](double scale) { return MakeSurface(scheme.OfTriangles, 3, scale); };
    const auto add = [&](const std::string& name, const MakeInput& input, int levels,
                       const Configure<Surface>& configure,
                       const std::function<void(vtkAlgorithm*)>& change = nullptr)
    {
      cases.push_back(MakeCase<Surface>(
        "surface, " + (scheme.Name + name), input,
        [=](Surface* filter)
        {
          filter->SetScheme(scheme.Kind);
          filter->SetNumberOfLevels(levels);
          configure(filter);
        },
        change));
    };
    const Configure<Surface> plain = [](Surface*) {};
    const bool hasLimits =
      scheme.Kind != Surface::MODIFIED_BUTTERFLY && scheme.Kind != Surface::LINEAR;
    const Configure<Surface> limits = [=](Surface* filter)
    {
      filter->SetProjectToLimit(hasLimits);
      filter->GenerateLimitNormalsOn();
      filter->GenerateTangentsOn();
      filter->SetInterpolatePoints(hasLimits);
      filter->GenerateOriginalIdsOn();
    };
    add("", coarse, scheme.Levels, plain);
    add(", fine input", fine, scheme.LevelsOfFine, plain);
    add(", limits, normals", coarse, scheme.Levels, limits);
    add(", fine input, limits, normals", fine, scheme.LevelsOfFine, limits);
    add(", kept", fine, scheme.LevelsOfFine, limits, MovePoints);
  }
  cases.push_back(MakeCase<Surface>(
    "surface, blocks", [](double scale) { return MakeBlocks(MakeSurface(true, 2, scale)); },
    [](Surface* filter) { filter->SetNumberOfLevels(1); }));
  cases.push_back(MakeCase<Surface>(
    "surface, features, seams", [](double scale) { return MakeSurface(false, 3, scale); },
    [](Surface* filter)
    {
      filter->SetScheme(Surface::CATMULL_CLARK);
      filter->SetNumberOfLevels(1);
      filter->DetectFeaturesOn();
      filter->JoinSeamsOn();
    }));
}

template <typename Filter>
std::vector<std::pair<std::string, Configure<Filter>>> GetCriteria(double length)
{
  const auto only = [](const Configure<Filter>& configure) -> Configure<Filter>
  {
    return [=](Filter* filter)
    {
      filter->RefineByAttributeErrorOff();
      filter->SetMaximumLevel(1);
      configure(filter);
    };
  };
  return { { "jump",
             [](Filter* filter)
             {
               filter->SetAttributeTolerance(0.5 / 94);
               filter->SetMaximumLevel(1);
             } },
    { "limit difference",
      [](Filter* filter)
      {
        filter->SetAttributeErrorKindToLimitDifference();
        filter->SetAttributeTolerance(1e-6);
        filter->SetMaximumLevel(1);
      } },
    { "range",
      only(
        [](Filter* filter)
        {
          filter->RefineByArrayRangeOn();
          filter->SetArrayRange(1., 1.2);
        }) },
    { "function",
      only(
        [](Filter* filter)
        {
          filter->RefineByFunctionOn();
          filter->SetImplicitFunction(MakeBall(0.5, 0.3));
        }) },
    { "edge length",
      only(
        [length](Filter* filter)
        {
          filter->RefineByEdgeLengthOn();
          filter->SetMaximumEdgeLength(length);
        }) },
    { "geometric error",
      only(
        [](Filter* filter)
        {
          filter->RefineByGeometricErrorOn();
          filter->SetGeometricTolerance(1e-6);
        }) },
    { "curvature",
      only(
        [](Filter* filter)
        {
          filter->RefineByCurvatureOn();
          filter->SetMaximumAngle(0.01);
        }) } };
}

void AddLocal(std::vector<GapCase>& cases)
{
  for (const auto& [name, configure] : GetCriteria<RedGreen>(1.6 / 80))
  {
    const auto& criterion = configure;
    cases.push_back(MakeCase<RedGreen>(
      "red-green, " + name, [](double scale) { return MakeSolid(80, scale); }, criterion));
    cases.push_back(MakeCase<RedGreen>(
      "red-green on the limit, " + name, [](double scale) { return MakeSolid(40, scale); },
      [criterion](RedGreen* filter)
      {
        criterion(filter);
        filter->SetPlacementToLimit();
        filter->GenerateLimitNormalsOn();
        filter->SetMaximumEdgeLength(1.6 / 40);
        filter->SetAttributeTolerance(0.5 / 40);
      }));
  }
  cases.push_back(MakeCase<RedGreen>(
    "red-green, rounds", [](double scale) { return MakeSolid(40, scale); },
    [](RedGreen* filter)
    {
      filter->RefineByAttributeErrorOff();
      filter->RefineByFunctionOn();
      filter->SetImplicitFunction(MakeBall(0.5, 0.3));
      filter->SetMaximumLevel(4);
    }));
  cases.push_back(MakeCase<RedGreen>(
    "red-green on the limit, tet/oct", [](double scale) { return MakeSolid(40, scale); },
    [](RedGreen* filter)
    {
      filter->RefineByAttributeErrorOff();
      filter->RefineByEdgeLengthOn();
      filter->SetMaximumEdgeLength(1.6 / 40);
      filter->SetPlacementToLimit();
      filter->SetVolumeSchemeToTetOct();
    }));
  cases.push_back(MakeCase<RedGreen>(
    "red-green, joined blocks", [](double scale) { return MakeBlocks(MakeSolid(50, scale)); },
    [](RedGreen* filter)
    {
      filter->RefineByAttributeErrorOff();
      filter->RefineByFunctionOn();
      filter->SetImplicitFunction(MakeBall(0.5, 0.3));
    }));
  for (const auto& [name, configure] : GetCriteria<Adaptive>(0.002))
  {
    cases.push_back(MakeCase<Adaptive>(
      "adaptive, " + name, [](double scale) { return MakeSurface(true, 3, scale); }, configure));
  }
  cases.push_back(MakeCase<Adaptive>(
    "adaptive, rounds, normals", [](double scale) { return MakeSurface(true, 2, scale); },
    [](Adaptive* filter)
    {
      filter->RefineByAttributeErrorOff();
      filter->RefineByFunctionOn();
      filter->SetImplicitFunction(MakeBall(0.5, 0.6));
      filter->SetMaximumLevel(4);
      filter->GenerateLimitNormalsOn();
      filter->GenerateTangentsOn();
    }));
}

void AddOthers(std::vector<GapCase>& cases)
{
  const auto deform = [&](const std::string& name, int cage, int levels, bool isSurface,
                        const std::function<void(vtkAlgorithm*)>& change)
  {
    cases.push_back(MakeCase<Deformation>(
      "deformation, " + name, [](double scale) { return MakeCloud(150, scale); },
      [=](Deformation* filter)
      {
        const Mesh rest = isSurface ? MakeSurface(true, 0, 1.) : MakeSolid(cage, 1.);
        filter->SetRestMeshData(rest);
        filter->SetDeformedMeshData(MakeMoved(rest, 0.5));
        filter->SetNumberOfLevels(levels);
        filter->TransformVectorsOn();
        filter->SetOutsidePointsToNearest();
      },
      change));
  };
  const auto moveCage = [](vtkAlgorithm* filter)
  {
    filter->SetInputDataObject(
      2, MakeMoved(vtkPointSet::SafeDownCast(filter->GetInputDataObject(2, 0)), 0.5));
  };
  deform("coarse cage", 4, 3, false, nullptr);
  deform("fine cage", 40, 1, false, nullptr);
  deform("surface", 0, 1, true, nullptr);
  deform("again", 4, 3, false, moveCage);
  deform("fine cage, again", 40, 1, false, moveCage);
  cases.push_back(MakeCase<vtkSimplicialComplexTopology>(
    "topology", [](double scale) { return MakeSolid(94, scale); },
    [](vtkSimplicialComplexTopology*) {}));
  cases.push_back(MakeCase<vtkSimplicialComplexTopology>(
    "topology, layers", [](double scale) { return MakeLayers(80, scale); },
    [](vtkSimplicialComplexTopology* filter) { filter->PreserveInterfacesOn(); }));
  cases.push_back(MakeCase<vtkExtractDimensions>(
    "dimensions, solids", [](double scale) { return MakeSolid(94, scale); },
    [](vtkExtractDimensions*) {}));
  cases.push_back(MakeCase<vtkExtractDimensions>(
    "dimensions, blocks", [](double scale) { return MakeBlocks(MakeSolid(70, scale)); },
    [](vtkExtractDimensions* filter) { filter->SetOutputDimensions(7); }));
  cases.push_back(MakeCase<vtkSubdivisionLabelSolid>(
    "labels", [](double scale) { return MakeLabels(200, scale); },
    [](vtkSubdivisionLabelSolid*) {}));
  cases.push_back(MakeCase<vtkSubdivisionLabelSolid>(
    "labels, all voxels", [](double scale) { return MakeLabels(50, scale); },
    [](vtkSubdivisionLabelSolid* filter) { filter->SetNumberOfControlCells(0); }));
  cases.push_back(MakeCase<vtkSubdivisionCageSource>(
    "cage", [](double scale) { return MakeCloud(220, scale); },
    [](vtkSubdivisionCageSource* source) { source->SetNumberOfCells(100, 100, 100); }));
  cases.push_back({ "model", [](double) -> Algorithm
    { return vtkSmartPointer<vtkSubdivisionModelSource>::New(); }, nullptr });
}

}

std::vector<GapCase> GetGapCases()
{
  std::vector<GapCase> cases;
  AddMain(cases);
  AddSurfaces(cases);
  AddLocal(cases);
  AddOthers(cases);
  return cases;
}

}
