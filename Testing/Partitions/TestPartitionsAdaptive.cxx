// SPDX-License-Identifier: BSD-3-Clause
// Adaptive refinement of the partitions of a surface, simulated in one process, splits the
// triangles that it splits in the whole surface.
#include "PartitionTools.h"
#include "RandomSurfaces.h"
#include "SurfaceTools.h"
#include "Turns.h"

#include "Private/AdaptiveSurface/AdaptiveSurface.h"

#include "vtkSphere.h"

#include <atomic>
#include <mutex>

using namespace partition_tools;
using subdivision::RefinementOptions;
using subdivision::SurfaceOptions;

namespace
{

const Partition Partitions[] = { { "halves", 2, 1, false },
  { "three slabs", 3, 2, false, KnownBy::GlobalIds, 1 },
  { "slabs by coordinates", 4, 1, false, KnownBy::Coordinates }, { "cell by cell", 3, 1, true },
  { "cell by cell on many", 8, 1, true },
  { "cell by cell, by coordinates", 3, 1, true, KnownBy::Coordinates } };

std::atomic<int> MostExchanges{ 0 }; ///< in a round

constexpr const char* IntegerName = "Integer";

void AddAll(vtkPointSet* mesh)
{
  NumberCells(mesh);
  AddFields(mesh);
  vtkNew<vtkIntArray> integers; // which are gathered, not smoothed
  integers->SetName(IntegerName);
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    integers->InsertNextValue(static_cast<int>(p * 7 % 5));
  }
  mesh->GetPointData()->AddArray(integers);
}

/// A grid of triangles with waves, crossed by creases.
surfacetools::Model MakeWaves(int size)
{
  surfacetools::Model model =
    surfacetools::MakeSheet(size, size, true, { 1., 0., 0. }, { 0., 1., 0. });
  const auto noise = surfacetools::MakeRandomPoints(model.Points.size(), 5);
  for (size_t i = 0; i < noise.size(); ++i)
  {
    auto& x = model.Points[i];
    x = { x[0] + 0.2 * noise[i][0], x[1] + 0.2 * noise[i][1],
      std::sin(0.9 * x[0]) * std::cos(0.7 * x[1]) + 0.1 * noise[i][2] };
  }
  model.Corners.clear();
  const vtkIdType width = size + 1;
  for (vtkIdType i = 0; i + 1 < width; ++i) // along a row, and a short one up a column
  {
    model.Lines.push_back({ 5 * width + i, 5 * width + i + 1 });
  }
  for (vtkIdType i = 1; i < 4; ++i)
  {
    model.Lines.push_back({ i * width + 3, (i + 1) * width + 3 });
  }
  return model;
}

std::vector<Mesh> MakeSurfaces()
{
  std::vector<Mesh> surfaces;
  const std::vector<Mesh> solids = MakeMeshes();
  for (size_t m = 0; m < solids.size(); m += 4)
  {
    surfaces.push_back(MakeSkin(solids[m]));
  }
  surfaces.push_back(MakeSkin(solids.back()));
  for (const auto& [name, model] : surfacetools::MakeZoo(true))
  {
    surfaces.push_back(surfacetools::MakeInput(model));
  }
  for (unsigned seed = 0; seed < 4; ++seed)
  {
    surfaces.push_back(surfacetools::MakeInput(surfacetools::RandomSurface(seed).Get()));
  }
  surfaces.push_back(surfacetools::MakeInput(MakeWaves(12)));
  for (const Mesh& surface : surfaces)
  {
    AddAll(surface);
  }
  return surfaces;
}

struct Request
{
  SurfaceOptions Options;
  RefinementOptions Criteria;
};

struct Choice
{
  const char* Name;
  std::function<void(vtkPointSet*, Request&)> Set; ///< for the mesh, or a part of it
};

void ReadField(vtkPointSet* mesh, const char* name, Request& request)
{
  request.Criteria.Attribute = mesh->GetPointData()->GetArray(name);
}

const Choice Choices[] = { { "edge length",
                             [](vtkPointSet*, Request& request)
                             {
                               request.Criteria.ByEdgeLength = true;
                               request.Criteria.MaximumEdgeLength = 0.4;
                               request.Criteria.MaximumLevel = 3;
                             } },
  { "wanted level, with tangents",
    [](vtkPointSet* mesh, Request& request)
    {
      request.Criteria.WantedLevel = mesh->GetCellData()->GetArray(WantedName);
      request.Options.GenerateTangents = true;
    } },
  { "selection, many levels, with normals",
    [](vtkPointSet* mesh, Request& request)
    {
      vtkDataArray* numbers = mesh->GetCellData()->GetArray(CellName);
      for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
      {
        request.Criteria.Selected.push_back(
          static_cast<long long>(numbers->GetComponent(c, 0)) % 29 == 7 ? 1 : 0);
      }
      request.Criteria.MaximumLevel = 6;
      request.Options.GenerateLimitNormals = true;
    } },
  { "jump",
    [](vtkPointSet* mesh, Request& request)
    {
      ReadField(mesh, FieldName, request);
      request.Criteria.AttributeTolerance = 0.2;
    } },
  { "jump of integers",
    [](vtkPointSet* mesh, Request& request)
    {
      ReadField(mesh, IntegerName, request);
      request.Criteria.AttributeTolerance = 0.5;
      request.Criteria.MaximumLevel = 3;
    } },
  { "difference from the limit",
    [](vtkPointSet* mesh, Request& request)
    {
      ReadField(mesh, FieldName, request);
      request.Criteria.AttributeTolerance = 0.02;
      request.Criteria.AttributeErrorOfLimit = true;
    } },
  { "geometric error, with features",
    [](vtkPointSet*, Request& request)
    {
      request.Criteria.ByGeometricError = true;
      request.Criteria.GeometricTolerance = 0.004;
      request.Options.Features.DetectFeatures = true;
    } },
  { "curvature",
    [](vtkPointSet*, Request& request)
    {
      request.Criteria.ByCurvature = true;
      request.Criteria.MaximumAngle = 25.;
    } },
  { "range of points",
    [](vtkPointSet* mesh, Request& request)
    {
      request.Criteria.Range = mesh->GetPointData()->GetArray(FieldName);
      request.Criteria.Least = -0.5;
      request.Criteria.Most = 0.5;
    } },
  { "range of cells", [](vtkPointSet* mesh, Request& request)
    {
      request.Criteria.Range = mesh->GetCellData()->GetArray(CellName);
      request.Criteria.RangeOfCells = true;
      request.Criteria.Least = 3;
      request.Criteria.Most = 40;
    } } };

Request MakeRequest()
{
  Request request;
  request.Options.Scheme = subdivision::SurfaceSchemeKind::SqrtThree;
  request.Options.Warn = [](const std::string&) {};
  request.Options.Fail = [](const std::string& message) { ADD_FAILURE() << message; };
  request.Options.GenerateGlobalIds = true;
  request.Criteria.MaximumLevel = 4;
  return request;
}

bool Refine(vtkPointSet* input, vtkPointSet* output, const Choice& choice, const Request& request)
{
  Request own = request;
  choice.Set(input, own);
  return RefineSurface(
    vtkPolyData::SafeDownCast(input), own.Options, own.Criteria, vtkPolyData::SafeDownCast(output));
}

/// Refines the parts of a surface.
bool RefineParts(const std::vector<Mesh>& cut, const Partition& partition, const Choice& choice,
  const Request& request, std::vector<Mesh>& outputs, int ghostLayers = 0)
{
  subdivision::DistributionOptions distribution;
  distribution.IsOfSurfaces = true;
  distribution.Layers = subdivision::LayersOfAdaptiveSurface;
  distribution.GhostLayers = ghostLayers;
  Request shared = request;
  return RunOnParts(
    cut, partition, distribution, shared.Options,
    [&](vtkPointSet* input, vtkPointSet* output)
    {
      CountingExchange others(shared.Options.Others, MostExchanges);
      Request own = shared;
      own.Options.Others = &others;
      return Refine(input, output, choice, own);
    },
    outputs);
}

void CheckParts(
  const Mesh& surface, const Partition& partition, const Choice& choice, const Request& request)
{
  const std::vector<Mesh> cut = Cut(surface, partition);
  const auto whole = Mesh::Take(vtkPolyData::New());
  ASSERT_TRUE(Refine(
    partition.Known == KnownBy::Coordinates ? Renumber(cut) : surface, whole, choice, request));
  subdivision::AddGlobalIds(whole);
  SCOPED_TRACE(std::string(partition.Name) + ", " + choice.Name + ", output of " +
    std::to_string(whole->GetNumberOfCells()));
  std::vector<Mesh> outputs;
  EXPECT_TRUE(RefineParts(cut, partition, choice, request, outputs));
  ExpectWhole(whole, outputs);
}

}

TEST(PartitionsAdaptive, GiveTheWhole)
{
  const std::vector<Mesh> surfaces = MakeSurfaces();
  MostExchanges = 0;
  for (size_t s = 0; s < surfaces.size() && !HasFailure(); ++s)
  {
    SCOPED_TRACE("surface " + std::to_string(s));
    for (const Choice& choice : Choices)
    {
      for (const Partition& partition : Partitions)
      {
        turns::IsNextInTurn() ? CheckParts(surfaces[s], partition, choice, MakeRequest()) : void();
      }
    }
  }
  EXPECT_GE(3, MostExchanges);
}

// What has to be split before a small triangle is the larger, the farther away it is.
TEST(PartitionsAdaptive, SplitDeepAtOnePlace)
{
  std::mt19937 chance(1);
  const auto pick = [&chance](unsigned choices) { return chance() % choices; };
  MostExchanges = 0;
  for (int i = 0; i < 100 && !HasFailure(); ++i)
  {
    SCOPED_TRACE("run " + std::to_string(i));
    const Mesh surface =
      surfacetools::MakeInput(i % 3 == 0 ? MakeWaves(6 + static_cast<int>(pick(6)))
                                         : surfacetools::RandomSurface(pick(1000)).Get());
    AddAll(surface);
    // A place in a triangle, on an edge or at a corner.
    double weights[3] = { static_cast<double>(pick(3)), static_cast<double>(pick(3)), 1. };
    const double sum = weights[0] + weights[1] + weights[2];
    vtkNew<vtkIdList> ids;
    surface->GetCellPoints(surface->GetNumberOfCells() - 1 -
        pick(static_cast<unsigned>(surface->GetNumberOfCells()) / 2),
      ids);
    double place[3] = { 0., 0., 0. };
    for (int k = 0; k < 3; ++k)
    {
      const double* x = surface->GetPoint(ids->GetId(k % ids->GetNumberOfIds()));
      for (int c = 0; c < 3; ++c)
      {
        place[c] += weights[k] / sum * x[c];
      }
    }
    const int level = 3 + static_cast<int>(pick(10));
    const double radius = level > 8 ? 0.01 : 0.1;
    const Choice choice{ "sphere", [&](vtkPointSet*, Request& request)
      {
        const auto sphere = vtkSmartPointer<vtkSphere>::New();
        sphere->SetCenter(place);
        sphere->SetRadius(radius);
        request.Criteria.Function = sphere;
        request.Criteria.MaximumLevel = level;
        request.Options.GenerateTangents = true;
      } };
    const Partition partition{ "parts", 2 + static_cast<int>(pick(6)), 1, pick(2) == 0 };
    CheckParts(surface, partition, choice, MakeRequest());
  }
  EXPECT_GE(2, MostExchanges);
}

TEST(PartitionsAdaptive, GiveGhostCells)
{
  const Mesh surface = surfacetools::MakeInput(MakeWaves(8));
  AddAll(surface);
  for (const Partition& partition : Partitions)
  {
    SCOPED_TRACE(partition.Name);
    const std::vector<Mesh> cut = Cut(surface, partition);
    for (const Choice& choice : Choices)
    {
      SCOPED_TRACE(choice.Name);
      const auto whole = Mesh::Take(vtkPolyData::New());
      ASSERT_TRUE(Refine(partition.Known == KnownBy::Coordinates ? Renumber(cut) : surface, whole,
        choice, MakeRequest()));
      std::vector<Mesh> outputs;
      EXPECT_TRUE(RefineParts(cut, partition, choice, MakeRequest(), outputs, 1));
      for (const Mesh& output : outputs)
      {
        ExpectGhosts(whole, output);
      }
    }
  }
}

// At the limit of cells all partitions leave out the same.
TEST(PartitionsAdaptive, StopTogether)
{
  const std::vector<Mesh> surfaces = MakeSurfaces();
  for (const Choice& choice : Choices)
  {
    const Mesh& surface = surfaces.back();
    const auto free = Mesh::Take(vtkPolyData::New());
    ASSERT_TRUE(Refine(surface, free, choice, MakeRequest()));
    Request request = MakeRequest();
    request.Options.MaximumNumberOfCells =
      (surface->GetNumberOfCells() + free->GetNumberOfCells()) / 2;
    std::mutex mutex;
    std::set<std::string> warnings;
    request.Options.Warn = [&](const std::string& message)
    {
      const std::lock_guard<std::mutex> lock(mutex);
      warnings.insert(message);
    };
    std::set<vtkIdType> sizes;
    std::vector<Mesh> outputs;
    for (const Partition& partition : Partitions)
    {
      if (partition.Known == KnownBy::Coordinates)
      {
        continue;
      }
      SCOPED_TRACE(std::string(partition.Name) + ", " + choice.Name);
      EXPECT_TRUE(RefineParts(Cut(surface, partition), partition, choice, request, outputs));
      vtkIdType size = 0;
      for (const Mesh& output : outputs)
      {
        size += output->GetNumberOfCells();
      }
      EXPECT_LE(size, request.Options.MaximumNumberOfCells);
      EXPECT_GE(size, surface->GetNumberOfCells());
      sizes.insert(size);
    }
    EXPECT_EQ(1u, sizes.size()) << choice.Name;
    EXPECT_EQ(1,
      std::count_if(warnings.begin(), warnings.end(), [](const std::string& message)
        { return message.find("not refined") != std::string::npos; }))
      << choice.Name;
    // The input alone is too large.
    request.Options.MaximumNumberOfCells = surface->GetNumberOfCells() - 1;
    EXPECT_TRUE(RefineParts(Cut(surface, Partitions[0]), Partitions[0], choice, request, outputs));
    EXPECT_EQ(
      surface->GetNumberOfCells(), outputs[0]->GetNumberOfCells() + outputs[1]->GetNumberOfCells());
  }
}

// Where one partition fails the others do not wait for it.
TEST(PartitionsAdaptive, FailTogether)
{
  const std::vector<Mesh> surfaces = MakeSurfaces();
  for (const int stopAt : { 0, 1, 3, 5, 12 })
  {
    Request request = MakeRequest();
    std::atomic<int> calls{ 0 };
    request.Options.Progress = [&calls, stopAt](double) { return calls++ == stopAt; };
    std::vector<Mesh> outputs;
    EXPECT_FALSE(RefineParts(
      Cut(surfaces.back(), Partitions[1]), Partitions[1], Choices[0], request, outputs));
  }
}
