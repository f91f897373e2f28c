// SPDX-License-Identifier: BSD-3-Clause
#include "GapCases.h"

#include "BenchmarkMeshes.h"
#include "GapMeshes.h"

#include "vtkAdaptiveSurfaceSubdivision.h"
#include "vtkExtractDimensions.h"
#include "vtkMultiDimensionalSubdivision.h"
#include "vtkRedGreenRefinement.h"
#include "vtkSimplicialComplexTopology.h"
#include "vtkSubdivisionCageSource.h"
#include "vtkSubdivisionDeformation.h"
#include "vtkSubdivisionLabelSolid.h"
#include "vtkSubdivisionLimitProbe.h"
#include "vtkSubdivisionModelSource.h"
#include "vtkSubdivisionSmoothness.h"
#include "vtkSurfaceSubdivision.h"
#include "vtkUnstructuredGrid.h"

#include <utility>

namespace benchmarks
{
namespace
{

using Algorithm = vtkSmartPointer<vtkAlgorithm>;
using Main = vtkMultiDimensionalSubdivision;
using Surface = vtkSurfaceSubdivision;
using RedGreen = vtkRedGreenRefinement;
using Adaptive = vtkAdaptiveSurfaceSubdivision;
using Deformation = vtkSubdivisionDeformation;

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
  const MakeInput few = [](double scale) { return MakeSolid(20, scale); };
  add("Bezier cells", few, 0, [](Main* filter) { filter->SetOutputCellsToBezier(); });
  add("error bounds", few, 0, [](Main* filter) { filter->GenerateErrorBoundsOn(); });
  add(
    "error bounds at one edge", [](double scale) { return MakeStar(Scaled(100000, scale, 1.)); }, 0,
    [](Main* filter) { filter->GenerateErrorBoundsOn(); });
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
    if (scheme.Kind == Surface::LOOP || scheme.Kind == Surface::CATMULL_CLARK)
    {
      const MakeInput few = [=](double scale) { return MakeSurface(scheme.OfTriangles, 1, scale); };
      add(", Bezier cells", few, 1, [](Surface* filter) { filter->SetOutputCellsToBezier(); });
      add(", error bounds", few, 0, [](Surface* filter) { filter->GenerateErrorBoundsOn(); });
    }
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
  const auto probe = [&](const std::string& name, const MakeInput& input, int places)
  {
    cases.push_back(MakeCase<vtkSubdivisionLimitProbe>("probe, " + name, input,
      [=](vtkSubdivisionLimitProbe* filter)
      { filter->SetInputDataObject(3, MakeCloud(places, 1.)); }));
  };
  probe("solid", [](double scale) { return MakeSolid(20, scale); }, 9);
  probe("surface", [](double scale) { return MakeSurface(true, 2, scale); }, 30);
  const auto smoothness = [&](const std::string& name, const MakeInput& input, int scheme)
  {
    cases.push_back(MakeCase<vtkSubdivisionSmoothness>("smoothness, " + name, input,
      [=](vtkSubdivisionSmoothness* filter) { filter->SetScheme(scheme); }));
  };
  smoothness(
    "box spline", [](double scale) { return MakeSolid(30, scale); },
    vtkSubdivisionSmoothness::BOX_SPLINE);
  smoothness(
    "tet/oct", [](double scale) { return MakeSolid(20, scale); },
    vtkSubdivisionSmoothness::TET_OCT);
  smoothness(
    "Loop", [](double scale) { return MakeSurface(true, 2, scale); },
    vtkSubdivisionSmoothness::LOOP);
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
