// SPDX-License-Identifier: BSD-3-Clause
// Partitions, simulated in one process, give the result of the whole mesh.
#include "PartitionTools.h"
#include "Turns.h"

#include "Private/Distribution/Distribution.h"
#include "Private/Distribution/PointIds.h"
#include "Private/Run/SizeChecks.h"
#include "Private/Surface/SurfaceSubdivision.h"
#include "Private/Uniform/UniformSubdivision.h"

#include "vtkPlane.h"
#include "vtkSurfaceSubdivision.h"

using namespace partition_tools;
using namespace multi_dimensional_subdivision_tools;
using subdivision::Block;

namespace
{

const Partition Partitions[] = { { "halves", 2, 1, false, KnownBy::GlobalIds },
  { "three slabs by coordinates", 3, 1, false, KnownBy::Coordinates },
  { "cell by cell", 3, 1, true, KnownBy::GlobalIds },
  { "cell by cell on many", 8, 2, true, KnownBy::GlobalIds },
  { "blocks in one process", 1, 4, false, KnownBy::GlobalIds },
  { "cell by cell in blocks", 1, 5, true, KnownBy::Coordinates } };

/// What a filter makes of the parts of a mesh.
std::vector<Mesh> RunOnParts(const std::vector<Mesh>& cut, const Partition& partition,
  bool isOfSurfaces, const subdivision::FilterWork& work, int layers = 2)
{
  subdivision::DistributionOptions distribution;
  distribution.Layers = layers;
  distribution.IsOfSurfaces = isOfSurfaces;
  subdivision::RunOptions options;
  options.Warn = [](const std::string& message) { ADD_FAILURE() << message; };
  options.Fail = options.Warn;
  std::vector<Mesh> outputs;
  EXPECT_TRUE(RunOnParts(cut, partition, distribution, options, work, outputs));
  return outputs;
}

/// Marks edges and faces on one side of a plane.
void Mark(subdivision::MarkOptions& marks)
{
  const auto plane = vtkSmartPointer<vtkPlane>::New();
  plane->SetOrigin(1., 1., 1.);
  plane->SetNormal(0.9, 0.3, -0.2);
  marks.Function = plane;
  marks.Corners = false;
  marks.Creases = true;
  marks.Surfaces = true;
}

/// Angles of corners, convex and concave ones, that follow from coordinates.
vtkSmartPointer<vtkDataArray> MakeAngles(vtkPointSet* mesh)
{
  const auto angles = vtkSmartPointer<vtkDoubleArray>::New();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const Point p = GetPoint(mesh, i);
    const double number = 1.7 * p[0] + 2.3 * p[1] + 0.9 * p[2];
    angles->InsertNextValue(360. * (number - std::floor(number)) - 30.);
  }
  return angles;
}

bool Subdivide(vtkPointSet* input, const subdivision::UniformOptions& options, vtkPointSet* output)
{
  subdivision::UniformOptions own = options;
  own.Features.CornerAngles = own.Features.ModifiedBoundary ? MakeAngles(input) : nullptr;
  return SubdivideUniformly(input, own, vtkUnstructuredGrid::SafeDownCast(output));
}

/// The same as on ranks, where parts know each other.
std::vector<Mesh> SubdivideParts(const std::vector<Mesh>& cut, const Partition& partition,
  subdivision::UniformOptions& options, int ghostLayers = 0)
{
  subdivision::DistributionOptions distribution;
  distribution.GhostLayers = ghostLayers;
  std::vector<Mesh> outputs;
  EXPECT_TRUE(RunOnParts(
    cut, partition, distribution, options, [&options](vtkPointSet* input, vtkPointSet* output)
    { return Subdivide(input, options, output); }, outputs));
  return outputs;
}

struct Choice
{
  const char* Name;
  std::function<void(subdivision::UniformOptions&)> Set;
};

const Choice Choices[] = { { "defaults", [](subdivision::UniformOptions&) {} },
  { "limits",
    [](subdivision::UniformOptions& o)
    {
      o.ProjectToLimit = true;
      o.GenerateClassification = true;
    } },
  { "normals", [](subdivision::UniformOptions& o) { o.GenerateLimitNormals = true; } },
  { "features",
    [](subdivision::UniformOptions& o)
    {
      o.Features.DetectFeatures = true;
      o.Features.Embedded = subdivision::EmbeddedRule::SingularInside;
    } },
  { "marks",
    [](subdivision::UniformOptions& o)
    {
      Mark(o.Features.Marks);
      o.Features.DetectFeatures = true;
    } },
  { "modified boundary",
    [](subdivision::UniformOptions& o)
    {
      o.Features.ModifiedBoundary = true;
      o.Features.DetectFeatures = true;
    } },
  { "limits of it",
    [](subdivision::UniformOptions& o)
    {
      o.Features.ModifiedBoundary = true;
      o.ProjectToLimit = true;
      o.GenerateLimitNormals = true;
    } },
  { "sharp joints", [](subdivision::UniformOptions& o)
    { o.Features.Type1 = o.Features.Type2 = o.Features.Type3 = subdivision::JointRule::Sharp; } } };

struct SurfaceChoice
{
  const char* Name;
  std::function<void(subdivision::SurfaceOptions&)> Set;
};

const SurfaceChoice SurfaceChoices[] = { { "defaults", [](subdivision::SurfaceOptions&) {} },
  { "limits",
    [](subdivision::SurfaceOptions& o)
    {
      o.ProjectToLimit = true;
      o.GenerateTangents = true;
    } },
  { "marks", [](subdivision::SurfaceOptions& o) { Mark(o.Features.Marks); } },
  { "features", [](subdivision::SurfaceOptions& o)
    {
      o.Features.DetectFeatures = true;
      o.Features.Type1 = o.Features.Type2 = o.Features.Type3 = subdivision::JointRule::Sharp;
    } } };

}

TEST(Partitions, GiveTheWholeOfSurfaces)
{
  const std::vector<Mesh> meshes = MakeMeshes();
  for (size_t m = 0; m < meshes.size(); m += 3)
  {
    const Mesh surface = MakeSkin(meshes[m]);
    for (int scheme = vtkSurfaceSubdivision::LOOP; scheme <= vtkSurfaceSubdivision::SQRT_THREE;
      ++scheme)
    {
      for (const SurfaceChoice& choice : SurfaceChoices)
      {
        subdivision::SurfaceOptions options;
        options.Levels = 3;
        options.Scheme = static_cast<subdivision::SurfaceSchemeKind>(scheme);
        options.Warn = [](const std::string&) {};
        options.Fail = [](const std::string& message) { ADD_FAILURE() << message; };
        choice.Set(options);
        const auto work = [&options](vtkPointSet* input, vtkPointSet* output)
        {
          return SubdivideSurface(
            vtkPolyData::SafeDownCast(input), options, vtkPolyData::SafeDownCast(output));
        };
        for (const Partition& partition : turns::Some(Partitions))
        {
          const std::vector<Mesh> cut = Cut(surface, partition);
          const auto whole = Mesh::Take(vtkPolyData::New());
          ASSERT_TRUE(
            work(partition.Known == KnownBy::Coordinates ? Renumber(cut) : surface, whole));
          SCOPED_TRACE(std::string(partition.Name) + ", " + choice.Name + ", scheme " +
            std::to_string(scheme) + ", mesh of " + std::to_string(surface->GetNumberOfCells()) +
            " cells");
          const int layers = subdivision::CountLayersOfSurface(options.Scheme);
          ExpectWhole(whole, RunOnParts(cut, partition, true, work, layers));
          if (HasFailure())
          {
            return;
          }
        }
      }
    }
  }
}

TEST(Partitions, GiveTheWholeUniformly)
{
  for (const Mesh& mesh : MakeMeshes())
  {
    for (const auto scheme :
      { subdivision::StampScheme::BoxSpline, subdivision::StampScheme::TetOct })
    {
      for (const Choice& choice : Choices)
      {
        subdivision::UniformOptions options;
        options.Levels = 2;
        options.Scheme = scheme;
        options.Warn = [](const std::string&) {};
        options.Fail = [](const std::string& message) { ADD_FAILURE() << message; };
        choice.Set(options);
        for (const Partition& partition : turns::Some(Partitions))
        {
          const std::vector<Mesh> cut = Cut(mesh, partition);
          const auto whole = Grid::New();
          ASSERT_TRUE(Subdivide(
            partition.Known == KnownBy::Coordinates ? Renumber(cut) : mesh, options, whole));
          SCOPED_TRACE(std::string(partition.Name) + ", " + choice.Name + ", mesh of " +
            std::to_string(mesh->GetNumberOfCells()) + " cells");
          ExpectWhole(whole, SubdivideParts(cut, partition, options));
          if (HasFailure())
          {
            return;
          }
        }
      }
    }
  }
}

// A part that was taken out of a huge mesh keeps its ids; memory does not depend on these.
TEST(Partitions, MayHaveIdsThatAreFarApart)
{
  const Mesh mesh = MakeMeshes()[0];
  subdivision::UniformOptions options;
  options.Levels = 1;
  options.Warn = [](const std::string&) {};
  options.Fail = [](const std::string& message) { ADD_FAILURE() << message; };
  const auto whole = Grid::New();
  ASSERT_TRUE(Subdivide(mesh, options, whole));
  for (const Partition& partition : Partitions)
  {
    if (partition.Known == KnownBy::GlobalIds)
    {
      const std::vector<Mesh> cut = Cut(mesh, partition);
      for (const Mesh& part : cut)
      {
        for (vtkDataSetAttributes* data :
          { static_cast<vtkDataSetAttributes*>(part->GetPointData()),
            static_cast<vtkDataSetAttributes*>(part->GetCellData()) })
        {
          auto* ids = vtkIdTypeArray::SafeDownCast(data->GetGlobalIds());
          for (vtkIdType i = 0; i < ids->GetNumberOfValues(); ++i)
          {
            ids->SetValue(i, 1000000000000 * ids->GetValue(i));
          }
        }
      }
      SCOPED_TRACE(partition.Name);
      ExpectWhole(whole, SubdivideParts(cut, partition, options));
    }
  }
}

TEST(Partitions, OfALargeMeshAreNotTheWhole)
{
  // Two layers are a small part here, so that what lies farther away is missed if it counts.
  const Partition halves = Partitions[0];
  const Grid box = MakeMixedBox(9);
  AddArrays(box);
  NumberCells(box);
  for (const auto scheme :
    { subdivision::StampScheme::BoxSpline, subdivision::StampScheme::TetOct })
  {
    subdivision::UniformOptions options;
    options.Levels = 1;
    options.Scheme = scheme;
    options.ProjectToLimit = true;
    options.Warn = [](const std::string&) {};
    const auto whole = Grid::New();
    ASSERT_TRUE(Subdivide(box, options, whole));
    ExpectWhole(whole, SubdivideParts(Cut(box, halves), halves, options));
  }
  const Mesh skin = MakeSkin(MakeMixedBox(16));
  for (int scheme = vtkSurfaceSubdivision::LOOP; scheme <= vtkSurfaceSubdivision::SQRT_THREE;
    ++scheme)
  {
    SCOPED_TRACE(scheme);
    subdivision::SurfaceOptions options;
    options.Levels = 2;
    options.Scheme = static_cast<subdivision::SurfaceSchemeKind>(scheme);
    options.ProjectToLimit = true;
    options.Warn = [](const std::string&) {};
    const auto work = [&options](vtkPointSet* input, vtkPointSet* output)
    {
      return SubdivideSurface(
        vtkPolyData::SafeDownCast(input), options, vtkPolyData::SafeDownCast(output));
    };
    const auto whole = Mesh::Take(vtkPolyData::New());
    ASSERT_TRUE(work(skin, whole));
    ExpectWhole(whole, RunOnParts(Cut(skin, halves), halves, true, work));
  }
}

TEST(Partitions, GiveGhostCells)
{
  // Random places, so that corners tell cells apart.
  const Mesh mesh = Mesh::Take(vtkUnstructuredGrid::New());
  mesh->DeepCopy(MakeMixedBox(3));
  std::mt19937 chance(3);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const Point at = GetPoint(mesh, i);
    mesh->GetPoints()->SetPoint(i, at[0] + chance() * 1e-11, at[1], at[2]);
  }
  NumberCells(mesh);
  for (const Partition& partition : Partitions)
  {
    if (partition.Blocks > 1 || partition.Known == KnownBy::Coordinates)
    {
      continue;
    }
    SCOPED_TRACE(partition.Name);
    subdivision::UniformOptions options;
    options.Warn = [](const std::string&) {};
    const Mesh whole = Mesh::Take(vtkUnstructuredGrid::New());
    ASSERT_TRUE(Subdivide(mesh, options, whole));
    for (const Mesh& part : SubdivideParts(Cut(mesh, partition), partition, options, 1))
    {
      ExpectGhosts(whole, part);
    }
  }
}

namespace
{

/// Runs `work` on partitions and returns what they warned of; whether all went well in `done`.
std::vector<std::string> GetWarnings(const std::vector<std::vector<Mesh>>& partitions,
  const subdivision::FilterWork& work, bool& done, std::vector<Mesh>& outputs)
{
  std::vector<std::vector<Block>> blocks;
  for (const std::vector<Mesh>& meshes : partitions)
  {
    blocks.emplace_back();
    for (const Mesh& mesh : meshes)
    {
      blocks.back().push_back({ mesh, subdivision::MakeMesh(false), 0 });
      outputs.push_back(blocks.back().back().Output);
    }
  }
  std::vector<std::string> warnings;
  subdivision::RunOptions options;
  options.Warn = [&](const std::string& message) { warnings.push_back(message); };
  options.Fail = [](const std::string&) {};
  subdivision::PartitionsOfRank ofRank(nullptr, static_cast<int>(partitions.size()));
  done = RunPartitions(
    blocks, ofRank, subdivision::DistributionOptions(), subdivision::FilterTraits(), options, work);
  return warnings;
}

/// Passes four parts on, each of which has a cell array by then.
std::vector<Mesh> FindInAll(const std::vector<Mesh>& cut, const char* name)
{
  bool done = false;
  std::vector<Mesh> outputs;
  int found = 0;
  GetWarnings(
    { { cut[0] }, { cut[1] }, { cut[2] }, { cut[3] } },
    [&](vtkPointSet* input, vtkPointSet* output)
    {
      found += input->GetCellData()->HasArray(name);
      output->ShallowCopy(input);
      return true;
    },
    done, outputs);
  EXPECT_TRUE(done);
  EXPECT_EQ(4, found);
  return outputs;
}

}

TEST(Partitions, FindArraysThatOnlyOthersHave)
{
  // Four slabs: the last one is too far from the first for a copy of its cells.
  const Grid box = MakeMixedBox(9);
  const std::vector<Mesh> cut = Cut(box, CutInSlabs(box, 4), 4, KnownBy::GlobalIds);
  cut[0]->GetCellData()->AddArray(
    MakeArray<vtkDoubleArray>("Only", 1, cut[0]->GetNumberOfCells(), 1., 2., 1));
  const std::vector<Mesh> outputs = FindInAll(cut, "Only");
  EXPECT_TRUE(outputs[0]->GetCellData()->HasArray("Only"));
  for (int i = 1; i < 4; ++i)
  {
    EXPECT_FALSE(outputs[i]->GetCellData()->HasArray("Only")) << i;
  }
}

TEST(Partitions, ArraysThatAreTooShortAreNone)
{
  // The array of the first of four slabs is too short, that of the last is not: all work with it.
  const Grid box = MakeMixedBox(9);
  const std::vector<Mesh> cut = Cut(box, CutInSlabs(box, 4), 4, KnownBy::GlobalIds);
  cut[0]->GetCellData()->AddArray(MakeArray<vtkDoubleArray>("Some", 1, 1, 1., 2., 1));
  cut[3]->GetCellData()->AddArray(
    MakeArray<vtkDoubleArray>("Some", 1, cut[3]->GetNumberOfCells(), 1., 2., 1));
  const std::vector<Mesh> outputs = FindInAll(cut, "Some");
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_EQ(i == 3, outputs[i]->GetCellData()->HasArray("Some")) << i;
  }
}

TEST(Partitions, SayThatCellsAreSpreadUnevenly)
{
  const Grid box = MakeMixedBox(2);
  const Mesh all = Cut(box, CutInSlabs(box, 1), 1, KnownBy::GlobalIds)[0];
  const auto work = [](vtkPointSet* input, vtkPointSet* output)
  {
    output->ShallowCopy(input);
    return true;
  };
  bool done = false;
  std::vector<Mesh> outputs;
  const auto uneven = GetWarnings({ {}, { all }, {}, {} }, work, done, outputs);
  ASSERT_EQ(1u, uneven.size());
  EXPECT_NE(
    std::string::npos, uneven[0].find("rank 1 has " + std::to_string(all->GetNumberOfCells())));
  EXPECT_TRUE(done);
  EXPECT_TRUE(
    GetWarnings({ { all }, {}, {} }, work, done, outputs).empty()); // three times the mean
}

TEST(Partitions, ShareTheMemoryOfAMachine)
{
  const double all = subdivision::GetAvailableMemory();
  const subdivision::MemoryShare share(4);
  EXPECT_NEAR(0.25, subdivision::GetAvailableMemory() / all, 0.05);
}
