// SPDX-License-Identifier: BSD-3-Clause
// Surface filters in a row on partitions, simulated in one process, with schemes that do not halve
// edges: each takes the cells as any other mesh, as in one process where the stamp is taken away.
#include "PartitionTools.h"
#include "Turns.h"

#include "Private/AdaptiveSurface/AdaptiveSurface.h"
#include "Private/Surface/SurfaceSubdivision.h"

#include "vtkSurfaceSubdivision.h"

#include <mutex>

using namespace partition_tools;
using namespace multi_dimensional_subdivision_tools;
using subdivision::SurfaceOptions;
using subdivision::SurfaceSchemeKind;

namespace
{

/// Of those that do not halve edges.
constexpr int FirstScheme = vtkSurfaceSubdivision::DOO_SABIN;
constexpr int NumberOfSchemes = 4;
constexpr const char* AnglesName = "Angles";
constexpr const char* Names[] = { "DooSabin", "Midedge", "FourEight", "SqrtThree" };

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
  options.Features.CornerAngles = input->GetPointData()->GetArray(AnglesName);
  return SubdivideSurface(
    vtkPolyData::SafeDownCast(input), options, vtkPolyData::SafeDownCast(output));
}

void RemoveStamp(vtkPointSet* mesh)
{
  vtkFieldData* data = mesh->GetFieldData();
  for (int a = data->GetNumberOfArrays() - 1; a >= 0; --a)
  {
    if (std::string(data->GetArrayName(a)).rfind("Subdivision", 0) == 0)
    {
      data->RemoveArray(a);
    }
  }
}

/// What filters with these options in a row make, none of which knows of the one before. `change`:
/// what happens before each of them.
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
    RemoveStamp(output);
    mesh = output;
  }
  return mesh;
}

std::vector<Mesh> SubdivideParts(std::vector<Mesh> parts, const Partition& partition,
  const std::vector<SurfaceOptions>& filters,
  const std::function<void(vtkPointSet*, size_t)>& change = nullptr)
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
    for (int scheme = FirstScheme; scheme < FirstScheme + NumberOfSchemes; ++scheme)
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

/// The same on parts; each filter but the first says that it starts afresh, and why.
void ExpectAfresh(const std::vector<Mesh>& parts, const Partition& partition,
  std::vector<SurfaceOptions> filters, const Mesh& whole,
  const std::function<void(vtkPointSet*, size_t)>& change = nullptr)
{
  std::vector<std::string> warnings;
  for (size_t f = 1; f < filters.size(); ++f)
  {
    filters[f].Warn = CollectInto(warnings);
  }
  ExpectWhole(whole, SubdivideParts(parts, partition, filters, change));
  const std::string name = Names[static_cast<int>(filters[0].Scheme) - FirstScheme];
  const auto count =
    std::count_if(warnings.begin(), warnings.end(), [&name](const std::string& message)
      { return message.find("on several ranks by " + name + ",") != std::string::npos; });
  // Each part that has a mesh says so; the filter tells it once.
  EXPECT_EQ(count, static_cast<long>((filters.size() - 1) * parts.size() / partition.Blocks));
}

}

TEST(PartitionsAfresh, FiltersStartAndSayIt)
{
  size_t turn = 0;
  ForSurfaces(true,
    [&turn](const Mesh& mesh, int scheme, const Partition& partition)
    {
      const std::vector<std::vector<int>> splits = { { 1, 1 }, { 1, 2 }, { 2, 1 }, { 1, 1, 1 } };
      // Each scheme has each of them, with other meshes.
      const size_t run = turn++ / std::size(CommonPartitions);
      if (!turns::IsInTurn(run))
      {
        return;
      }
      const std::vector<int>& split = splits[(run + run / NumberOfSchemes) % splits.size()];
      std::vector<SurfaceOptions> filters;
      for (const int count : split)
      {
        filters.push_back(MakeOptions(scheme, count));
        filters.back().Features.DetectFeatures = turn % 3 > 0;
        filters.back().Features.FeatureAngle = 50.;
      }
      filters.back().GenerateLimitNormals = turn % 2 > 0;
      filters.back().ProjectToLimit = turn % 4 > 1;
      ExpectAfresh(Cut(mesh, partition), partition, filters, Subdivide(mesh, filters));
    });
}

TEST(PartitionsAfresh, GiveWayToOtherSchemes)
{
  ForSurfaces(false,
    [](const Mesh& mesh, int scheme, const Partition& partition)
    {
      const int other = FirstScheme + (scheme + 1 - FirstScheme) % 2 +
        (scheme < vtkSurfaceSubdivision::FOUR_EIGHT ? 0 : 2);
      const std::vector<SurfaceOptions> filters = { MakeOptions(scheme, 1), MakeOptions(other, 1) };
      ExpectWhole(
        Subdivide(mesh, filters), SubdivideParts(Cut(mesh, partition), partition, filters));
    });
}

// It needs more layers than a filter that goes on.
TEST(PartitionsAfresh, GiveWayToAdaptiveRefinement)
{
  ForSurfaces(true,
    [](const Mesh& mesh, int scheme, const Partition& partition)
    {
      if (partition.Blocks == 1 || !turns::IsNextInTurn())
      {
        return; // slabs have the most layers
      }
      SurfaceOptions first = MakeOptions(scheme, 1);
      SurfaceOptions second = MakeOptions(vtkSurfaceSubdivision::SQRT_THREE, 0);
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
      distribution.Layers = subdivision::LayersOfAdaptiveSurface;
      std::vector<Mesh> outputs;
      EXPECT_TRUE(RunOnParts(SubdivideParts(Cut(mesh, partition), partition, { first }), partition,
        distribution, second, refine, outputs));
      ExpectWhole(whole, outputs);
    });
}

TEST(PartitionsAfresh, TakeValuesAsTheyAre)
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
      ExpectAfresh(
        Cut(mesh, partition), partition, filters, Subdivide(mesh, filters, change), change);
    });
}

TEST(PartitionsAfresh, MayComeToOtherRanks)
{
  ForSurfaces(false,
    [](const Mesh& mesh, int scheme, const Partition& partition)
    {
      if (partition.Blocks > 1)
      {
        return;
      }
      const SurfaceOptions once = MakeOptions(scheme, 1);
      SurfaceOptions again = once;
      std::vector<std::string> warnings;
      again.Warn = CollectInto(warnings);
      std::vector<Mesh> parts = SubdivideParts(Cut(mesh, partition), partition, { once });
      std::reverse(parts.begin(), parts.end());
      ExpectWhole(Subdivide(mesh, { once, once }), SubdivideParts(parts, partition, { again }));
      EXPECT_FALSE(warnings.empty());
    });
}

TEST(PartitionsAfresh, MayBeEmpty)
{
  const Mesh none = subdivision::MakeMesh(true);
  vtkNew<vtkPoints> points;
  none->SetPoints(points);
  ForSurfaces(false,
    [&none](const Mesh& mesh, int scheme, const Partition&)
    {
      vtkNew<vtkIntArray> ids; // an empty part keeps them: all of its cells are there
      ids->DeepCopy(mesh->GetCellData()->GetArray(CellName));
      ids->SetName("Ids");
      mesh->GetCellData()->SetGlobalIds(ids);
      const std::vector<SurfaceOptions> filters(2, MakeOptions(scheme, 1));
      ExpectAfresh({ none, mesh }, CommonPartitions[0], filters, Subdivide(mesh, filters));
    });
}

TEST(PartitionsAfresh, WarnWhereCellsMoved)
{
  const Mesh surface = MakeSkin(MakeMeshes()[0]);
  for (int scheme = FirstScheme; scheme < FirstScheme + NumberOfSchemes; ++scheme)
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
