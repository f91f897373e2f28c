// SPDX-License-Identifier: BSD-3-Clause
// Surface filters in a row on partitions, simulated in one process, with schemes that do not halve
// edges.
#include "PartitionTools.h"

#include "Private/AdaptiveSurface/AdaptiveSurface.h"
#include "Private/Surface/SurfaceSubdivision.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>

using namespace partition_tools;
using namespace multi_dimensional_subdivision_tools;
using subdivision::SurfaceOptions;
using subdivision::SurfaceSchemeKind;

namespace
{

constexpr int FirstScheme = 3; ///< of those that do not halve edges
constexpr int NumberOfSchemes = 7;
constexpr const char* AnglesName = "Angles";

SurfaceOptions MakeOptions(int scheme, int levels)
{
  SurfaceOptions options;
  options.Scheme = static_cast<SurfaceSchemeKind>(scheme);
  options.Levels = levels;
  options.Warn = [](const std::string& message)
  { EXPECT_EQ(std::string::npos, message.find("any other mesh")) << message; };
  options.Fail = [](const std::string& message) { ADD_FAILURE() << message; };
  return options;
}

bool Run(vtkPointSet* input, SurfaceOptions options, vtkPointSet* output)
{
  options.Angles = input->GetPointData()->GetArray(AnglesName);
  return SubdivideSurface(
    vtkPolyData::SafeDownCast(input), options, vtkPolyData::SafeDownCast(output));
}

/// What filters with these options in a row make. `change`: what happens before each of them.
Mesh Subdivide(Mesh mesh, const std::vector<SurfaceOptions>& filters,
  const std::function<void(vtkPointSet*, size_t)>& change = nullptr)
{
  for (size_t f = 0; f < filters.size(); ++f)
  {
    if (change)
    {
      change(mesh, f);
    }
    const Mesh output = subdivision::MakeMesh(true);
    EXPECT_TRUE(Run(mesh, filters[f], output));
    mesh = output;
  }
  return mesh;
}

std::vector<Mesh> SubdivideParts(std::vector<Mesh> parts, const Partition& partition,
  const std::vector<SurfaceOptions>& filters,
  const std::function<void(vtkPointSet*, size_t)>& change = nullptr, int ghostLayers = 0)
{
  for (size_t f = 0; f < filters.size(); ++f)
  {
    for (const Mesh& part : parts)
    {
      if (change)
      {
        change(part, f);
      }
    }
    SurfaceOptions options = filters[f];
    subdivision::DistributionOptions distribution;
    distribution.IsOfSurfaces = true;
    distribution.WorksInRounds = true;
    distribution.GhostLayers = f + 1 == filters.size() ? ghostLayers : 0;
    distribution.Layers = subdivision::CountLayersOfSurface(options.Scheme);
    std::vector<Mesh> outputs;
    EXPECT_TRUE(RunOnParts(
      parts, partition, distribution, options, [&options](vtkPointSet* input, vtkPointSet* output)
      { return Run(input, options, output); }, outputs));
    parts = outputs;
  }
  return parts;
}

/// Angles of corners, at some points.
void AddAngles(vtkPointSet* mesh)
{
  vtkNew<vtkDoubleArray> angles;
  angles->SetName(AnglesName);
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    angles->InsertNextValue(p % 4 == 1 ? 30. + static_cast<double>(p % 7) * 20. : -1.);
  }
  mesh->GetPointData()->AddArray(angles);
}

/// test(surface, scheme, partition) for all meshes and schemes, partitions by turns or all.
template <typename Test>
void ForSurfaces(bool all, const Test& test)
{
  size_t turn = 0;
  size_t meshes = 0;
  for (const Mesh& mesh : MakeMeshes())
  {
    ++meshes; // each scheme has each partition, with other meshes
    const Mesh surface = MakeSkin(mesh);
    AddAngles(surface);
    for (int scheme = FirstScheme; scheme < NumberOfSchemes; ++scheme)
    {
      ++turn;
      for (size_t p = 0; p < std::size(CommonPartitions); ++p)
      {
        if (all || p == (turn + meshes) % std::size(CommonPartitions))
        {
          SCOPED_TRACE(std::string(CommonPartitions[p].Name) + ", scheme " +
            std::to_string(scheme) + ", mesh of " + std::to_string(surface->GetNumberOfCells()) +
            " cells");
          test(surface, scheme, CommonPartitions[p]);
        }
        if (testing::Test::HasFailure())
        {
          return;
        }
      }
    }
  }
}

/// Partitions of one process run in threads, which may warn at once.
std::function<void(const std::string&)> CollectInto(std::vector<std::string>& warnings)
{
  return [&warnings, mutex = std::make_shared<std::mutex>()](const std::string& message)
  {
    const std::lock_guard<std::mutex> lock(*mutex);
    warnings.push_back(message);
  };
}

}

TEST(PartitionsRegions, LetFiltersGoOn)
{
  size_t turn = 0;
  ForSurfaces(true,
    [&turn](const Mesh& mesh, int scheme, const Partition& partition)
    {
      const std::vector<std::vector<int>> splits = { { 1, 1 }, { 1, 2 }, { 2, 1 }, { 1, 1, 1 } };
      // Each scheme has each of them, with other meshes.
      const size_t run = turn++ / std::size(CommonPartitions);
      const std::vector<int>& split =
        splits[(run + run / (NumberOfSchemes - FirstScheme)) % splits.size()];
      std::vector<SurfaceOptions> filters;
      int levels = 0;
      for (const int count : split)
      {
        filters.push_back(MakeOptions(scheme, count));
        levels += count;
      }
      SurfaceOptions once = MakeOptions(scheme, levels);
      once.Features.DetectFeatures = filters[0].Features.DetectFeatures = turn % 3 > 0;
      once.Features.FeatureAngle = filters[0].Features.FeatureAngle = 50.;
      filters.back().GenerateLimitNormals = once.GenerateLimitNormals = turn % 2 > 0;
      filters.back().ProjectToLimit = once.ProjectToLimit = turn % 4 > 1;
      ExpectWhole(
        Subdivide(mesh, { once }), SubdivideParts(Cut(mesh, partition), partition, filters));
    });
}

TEST(PartitionsRegions, GiveWayToOtherSchemes)
{
  ForSurfaces(false,
    [](const Mesh& mesh, int scheme, const Partition& partition)
    {
      const int other = FirstScheme + (scheme + 1 - FirstScheme) % 2 + (scheme < 5 ? 0 : 2);
      const std::vector<SurfaceOptions> filters = { MakeOptions(scheme, 1), MakeOptions(other, 1) };
      ExpectWhole(
        Subdivide(mesh, filters), SubdivideParts(Cut(mesh, partition), partition, filters));
    });
}

// It needs more layers than a filter that goes on.
TEST(PartitionsRegions, GiveWayToAdaptiveRefinement)
{
  ForSurfaces(true,
    [](const Mesh& mesh, int scheme, const Partition& partition)
    {
      if (partition.Blocks == 1)
      {
        return; // slabs have the most layers
      }
      SurfaceOptions first = MakeOptions(scheme, 1);
      SurfaceOptions second = MakeOptions(6, 0);
      second.Warn = [](const std::string&) {};
      subdivision::RefinementOptions criteria;
      criteria.ByCurvature = true;
      criteria.MaximumAngle = 10.;
      criteria.MaximumLevel = 5;
      const auto refine = [&](vtkPointSet* input, vtkPointSet* output)
      {
        return RefineSurface(
          vtkPolyData::SafeDownCast(input), second, criteria, vtkPolyData::SafeDownCast(output));
      };
      const Mesh whole = subdivision::MakeMesh(true);
      EXPECT_TRUE(refine(Subdivide(mesh, { first }), whole));
      subdivision::DistributionOptions distribution;
      distribution.IsOfSurfaces = true;
      distribution.WorksInRounds = true;
      distribution.Layers = subdivision::LayersOfAdaptiveSurface;
      std::vector<Mesh> outputs;
      EXPECT_TRUE(RunOnParts(SubdivideParts(Cut(mesh, partition), partition, { first }), partition,
        distribution, second, refine, outputs));
      ExpectWhole(whole, outputs);
    });
}

TEST(PartitionsRegions, TakeValuesAsTheyAre)
{
  const auto change = [](vtkPointSet* mesh, size_t filter)
  {
    if (filter == 0 || mesh->GetNumberOfPoints() == 0)
    {
      return;
    }
    vtkNew<vtkPoints> points;
    points->SetDataType(VTK_DOUBLE);
    for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
    {
      const Point at = GetPoint(mesh, p);
      points->InsertNextPoint(at[0] + 0.1 * at[1], at[1] * at[2], at[2] - 0.3 * at[0]);
    }
    mesh->SetPoints(points);
    // A cell array that is changed in few cells, which are those of one part.
    vtkNew<vtkIntArray> numbers;
    numbers->DeepCopy(mesh->GetCellData()->GetArray("Changed"));
    for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
    {
      if (mesh->GetCellData()->GetArray(CellName)->GetTuple1(c) == 3.)
      {
        numbers->SetValue(c, numbers->GetValue(c) + 1000);
      }
    }
    mesh->GetCellData()->AddArray(numbers);
  };
  ForSurfaces(false,
    [&change](const Mesh& mesh, int scheme, const Partition& partition)
    {
      vtkNew<vtkIntArray> numbers;
      numbers->DeepCopy(mesh->GetCellData()->GetArray(CellName));
      numbers->SetName("Changed");
      mesh->GetCellData()->AddArray(numbers);
      const std::vector<SurfaceOptions> filters = { MakeOptions(scheme, 1),
        MakeOptions(scheme, 1) };
      ExpectWhole(Subdivide(mesh, filters, change),
        SubdivideParts(Cut(mesh, partition), partition, filters, change));
    });
}

// Of those that are asked for they have one layer, because what is farther away is not right.
TEST(PartitionsRegions, HaveGhostCellsOfOneFilter)
{
  ForSurfaces(false,
    [](const Mesh& mesh, int scheme, const Partition& partition)
    {
      const std::vector<Mesh> parts = Cut(mesh, partition);
      const auto once = SubdivideParts(parts, partition, { MakeOptions(scheme, 2) }, nullptr, 1);
      for (const int wanted : { 1, 3 })
      {
        std::atomic<int> warnings(0);
        SurfaceOptions second = MakeOptions(scheme, 1);
        second.Warn = [&](const std::string& message)
        { warnings += message.find("3 layers of ghost cells") != std::string::npos ? 1 : 0; };
        const auto twice =
          SubdivideParts(parts, partition, { MakeOptions(scheme, 1), second }, nullptr, wanted);
        EXPECT_EQ(warnings > 0, wanted > 1);
        for (size_t i = 0; i < parts.size(); ++i)
        {
          ASSERT_EQ(once[i]->GetNumberOfCells(), twice[i]->GetNumberOfCells());
          ASSERT_EQ(once[i]->GetNumberOfPoints(), twice[i]->GetNumberOfPoints());
          for (vtkIdType p = 0; p < once[i]->GetNumberOfPoints(); ++p)
          {
            ASSERT_EQ(GetPoint(once[i], p), GetPoint(twice[i], p)) << "point " << p;
          }
        }
      }
    });
}

TEST(PartitionsRegions, MayComeToOtherRanks)
{
  ForSurfaces(false,
    [](const Mesh& mesh, int scheme, const Partition& partition)
    {
      if (partition.Blocks > 1)
      {
        return;
      }
      std::vector<Mesh> parts =
        SubdivideParts(Cut(mesh, partition), partition, { MakeOptions(scheme, 1) });
      std::reverse(parts.begin(), parts.end());
      ExpectWhole(Subdivide(mesh, { MakeOptions(scheme, 2) }),
        SubdivideParts(parts, partition, { MakeOptions(scheme, 1) }));
    });
}

TEST(PartitionsRegions, MayBeEmpty)
{
  const Mesh none = subdivision::MakeMesh(true);
  vtkNew<vtkPoints> points;
  none->SetPoints(points);
  ForSurfaces(false,
    [&none](const Mesh& mesh, int scheme, const Partition&)
    {
      const SurfaceOptions once = MakeOptions(scheme, 1);
      ExpectWhole(Subdivide(mesh, { MakeOptions(scheme, 2) }),
        SubdivideParts({ none, mesh }, CommonPartitions[0], { once, once }));
    });
}

TEST(PartitionsRegions, WarnWhereCellsMoved)
{
  const Mesh surface = MakeSkin(MakeMeshes()[0]);
  for (int scheme = FirstScheme; scheme < NumberOfSchemes; ++scheme)
  {
    const SurfaceOptions first = MakeOptions(scheme, 1);
    // All cells on the first rank, whose field data know only half of them.
    const std::vector<Mesh> parts =
      SubdivideParts(Cut(surface, CommonPartitions[0]), CommonPartitions[0], { first });
    const Mesh all = Subdivide(surface, { first });
    all->GetFieldData()->ShallowCopy(parts[0]->GetFieldData());
    const Mesh none = subdivision::MakeMesh(true);
    vtkNew<vtkPoints> points;
    none->SetPoints(points);
    none->GetFieldData()->ShallowCopy(parts[1]->GetFieldData());
    std::vector<std::string> warnings;
    SurfaceOptions second = first;
    second.Warn = CollectInto(warnings);
    const std::vector<Mesh> outputs =
      SubdivideParts({ all, none }, CommonPartitions[0], { second });
    EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const std::string& message)
      { return message.find("any other mesh") != std::string::npos; }));
    EXPECT_GT(outputs[0]->GetNumberOfCells(), 0);
  }
}

TEST(PartitionsRegions, MayBeDamaged)
{
  const Mesh surface = MakeSkin(MakeMeshes()[0]);
  for (int scheme = FirstScheme; scheme < NumberOfSchemes; ++scheme)
  {
    const SurfaceOptions first = MakeOptions(scheme, 1);
    SurfaceOptions second = first;
    std::vector<std::string> warnings;
    second.Warn = CollectInto(warnings);
    const Mesh whole = Subdivide(surface, { first, first });
    const auto damage = [](vtkPointSet* part, size_t)
    { part->GetFieldData()->RemoveArray("SubdivisionRegionControl"); };
    const std::vector<Mesh> parts =
      SubdivideParts(Cut(surface, CommonPartitions[0]), CommonPartitions[0], { first });
    ExpectWhole(whole, SubdivideParts(parts, CommonPartitions[0], { second }, damage));
    EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const std::string& message)
      { return message.find("an earlier filter wrote") != std::string::npos; }));
  }
}
