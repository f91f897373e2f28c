// SPDX-License-Identifier: BSD-3-Clause
// Values that jump at interfaces are on partitions, simulated in one process, those of the whole
// mesh.
#include "PartitionTools.h"
#include "Turns.h"

#include "Private/Distribution/KeptParts.h"
#include "Private/RedGreen/RedGreenRefinement.h"
#include "Private/Surface/SurfaceSubdivision.h"
#include "Private/Uniform/UniformSubdivision.h"
#include "Private/Values/MaterialFields.h"

using namespace partition_tools;
using namespace multi_dimensional_subdivision_tools;

namespace
{

const Partition Partitions[] = { { "three slabs", 3, 1, false }, { "cell by cell", 3, 1, true },
  { "cell by cell on many", 8, 2, true },
  { "one rank without cells", 3, 1, true, KnownBy::GlobalIds, 1 } };

/// Gives some cells in a row the same material, so that interfaces lie on and between borders.
void AddMaterials(vtkPointSet* mesh)
{
  vtkNew<vtkIntArray> materials;
  materials->SetName("MaterialId");
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
  {
    materials->InsertNextValue(static_cast<int>(c / 5 % 3));
  }
  mesh->GetCellData()->AddArray(materials);
}

template <typename Options>
Options MakeOptions()
{
  Options options;
  options.Warn = [](const std::string&) {};
  options.Fail = [](const std::string& message) { ADD_FAILURE() << message; };
  options.Features.PreserveInterfaces = true;
  return options;
}

/// The work of a filter with fields, on a mesh or a part of one. `work` gets the options for it,
/// with its materials.
template <typename Options, typename Work>
subdivision::FilterWork WithFields(const Options& shared, const Work& work)
{
  return [&shared, work](vtkPointSet* input, vtkPointSet* output)
  {
    Options own = shared;
    own.Features.Material = input->GetCellData()->GetArray("MaterialId");
    return RunWithMaterialFields(input, output, own, { true, { CellName } },
      [&](vtkPointSet* control, vtkPointSet* made) { return work(control, own, made); });
  };
}

std::vector<Mesh> RunOnParts(const std::vector<Mesh>& cut, const Partition& partition,
  subdivision::RunOptions& options, const subdivision::FilterWork& run, int layers = 2,
  subdivision::KeptParts* kept = nullptr)
{
  subdivision::DistributionOptions distribution;
  distribution.KeepsOwnValues = true;
  distribution.Layers = layers + 1; // as with InterfaceValues
  distribution.IsOfSurfaces = vtkPolyData::SafeDownCast(cut[0]) != nullptr;
  distribution.Kept = kept;
  std::vector<Mesh> outputs;
  EXPECT_TRUE(RunOnParts(cut, partition, distribution, options, run, outputs));
  return outputs;
}

std::string Describe(const Partition& partition, vtkPointSet* mesh)
{
  return std::string(partition.Name) + ", mesh of " + std::to_string(mesh->GetNumberOfCells()) +
    " cells";
}

/// Compares parts with the whole.
template <typename Options, typename Work>
void ExpectWholeOf(
  const std::vector<Mesh>& meshes, const Options& options, const Work& work, int layers = 2)
{
  for (const Mesh& mesh : turns::Some(meshes))
  {
    AddMaterials(mesh);
    Options shared = options;
    const auto run = WithFields(shared, work);
    const Mesh whole = subdivision::MakeMesh(vtkPolyData::SafeDownCast(mesh) != nullptr);
    ASSERT_TRUE(run(mesh, whole));
    EXPECT_TRUE(whole->GetPointData()->HasArray("MaterialPointIds"));
    for (const Partition& partition : Partitions)
    {
      SCOPED_TRACE(Describe(partition, mesh));
      ExpectWhole(whole, RunOnParts(Cut(mesh, partition), partition, shared, run, layers));
      if (testing::Test::HasFailure())
      {
        return;
      }
    }
  }
}

bool Smooth(vtkPointSet* input, const subdivision::UniformOptions& options, vtkPointSet* output)
{
  return SubdivideUniformly(input, options, vtkUnstructuredGrid::SafeDownCast(output));
}

bool Refine(vtkPointSet* input, const subdivision::RedGreenOptions& options, vtkPointSet* output)
{
  return RefineRedGreen(input, options, vtkUnstructuredGrid::SafeDownCast(output));
}

/// Cuts a mesh, and gives each part values that no other one has at the points that they share.
std::vector<Mesh> CutWithOwnValues(vtkPointSet* mesh, const Partition& partition, double step)
{
  std::vector<Mesh> cut = Cut(mesh, partition);
  for (std::size_t part = 0; part < cut.size(); ++part)
  {
    vtkDataArray* values = cut[part]->GetPointData()->GetArray("double");
    for (vtkIdType p = 0; p < values->GetNumberOfTuples(); ++p)
    {
      values->SetComponent(p, 0, values->GetComponent(p, 0) + step * static_cast<double>(part));
    }
  }
  return cut;
}

/// Compares each part with that of the same blocks in one process.
template <typename Options, typename Work>
void ExpectBlocksOf(const Options& options, const Work& work)
{
  for (const Mesh& mesh : MakeMeshes())
  {
    AddMaterials(mesh);
    Options shared = options;
    const auto run = WithFields(shared, work);
    for (const Partition& partition : turns::Some(Partitions))
    {
      SCOPED_TRACE(Describe(partition, mesh));
      const Partition inOne = { "blocks", 1, partition.Parts * partition.Blocks, false };
      subdivision::KeptParts kept;
      for (const double step : { 0., 3., 5. }) // the second time values alone change
      {
        const std::vector<Mesh> cut = CutWithOwnValues(mesh, partition, step);
        const auto expected = RunOnParts(cut, inOne, shared, run);
        const auto found = RunOnParts(cut, partition, shared, run, 2, &kept);
        ASSERT_EQ(expected.size(), found.size());
        for (std::size_t part = 0; part < found.size(); ++part)
        {
          SCOPED_TRACE(std::to_string(part) + ", step " + std::to_string(step));
          ASSERT_EQ(expected[part]->GetNumberOfCells(), found[part]->GetNumberOfCells());
          if (found[part]->GetNumberOfCells() > 0)
          {
            ExpectWhole(expected[part], { found[part] });
          }
          if (testing::Test::HasFailure())
          {
            return;
          }
        }
      }
    }
  }
}

}

TEST(PartitionsFields, GiveTheWholeUniformly)
{
  for (const auto scheme :
    { subdivision::StampScheme::BoxSpline, subdivision::StampScheme::TetOct })
  {
    for (const bool interpolates : { false, true })
    {
      auto options = MakeOptions<subdivision::UniformOptions>();
      options.Levels = 2;
      options.Scheme = scheme;
      options.ProjectToLimit = scheme == subdivision::StampScheme::BoxSpline;
      options.Interpolation.Arrays = interpolates;
      ExpectWholeOf(MakeMeshes(), options, Smooth,
        interpolates && scheme == subdivision::StampScheme::TetOct ? 3 : 2);
    }
  }
}

TEST(PartitionsFields, GiveTheWholeOfRedGreen)
{
  for (const bool interpolates : { false, true })
  {
    auto options = MakeOptions<subdivision::RedGreenOptions>();
    options.Criteria.ByEdgeLength = true;
    options.Criteria.MaximumEdgeLength = 0.4;
    options.Criteria.MaximumLevel = 2;
    options.LimitPlacement = interpolates;
    options.Interpolation.Arrays = interpolates;
    ExpectWholeOf(MakeMeshes(), options, Refine);
  }
}

TEST(PartitionsFields, GiveTheWholeOfSurfaces)
{
  std::vector<Mesh> surfaces;
  for (const Mesh& mesh : MakeMeshes())
  {
    surfaces.push_back(MakeSkin(mesh));
  }
  for (const bool interpolates : { false, true })
  {
    auto options = MakeOptions<subdivision::SurfaceOptions>();
    options.Levels = 2;
    options.ProjectToLimit = true;
    options.Interpolation.Arrays = interpolates;
    ExpectWholeOf(surfaces, options,
      [](vtkPointSet* input, const subdivision::SurfaceOptions& own, vtkPointSet* output)
      {
        return SubdivideSurface(
          vtkPolyData::SafeDownCast(input), own, vtkPolyData::SafeDownCast(output));
      });
  }
}

// Each part may have other values where parts meet, on ranks as in blocks of one process.
TEST(PartitionsFields, KeepOwnValuesUniformly)
{
  auto options = MakeOptions<subdivision::UniformOptions>();
  ExpectBlocksOf(options, Smooth);
  options.ProjectToLimit = true;
  options.Interpolation.Arrays = true;
  ExpectBlocksOf(options, Smooth);
}

TEST(PartitionsFields, KeepOwnValuesOfRedGreen)
{
  auto options = MakeOptions<subdivision::RedGreenOptions>();
  options.Criteria.ByEdgeLength = true;
  options.Criteria.MaximumEdgeLength = 0.4;
  options.Criteria.MaximumLevel = 1;
  ExpectBlocksOf(options, Refine);
}

// The next filter joins the copies that the first one made on all ranks.
TEST(PartitionsFields, GiveTheWholeOfFiltersInARow)
{
  for (const bool interpolates : { false, true })
  {
    auto options = MakeOptions<subdivision::UniformOptions>();
    options.Interpolation.Arrays = interpolates;
    const auto run = WithFields(options, Smooth);
    for (const Mesh& mesh : turns::Some(MakeMeshes()))
    {
      AddMaterials(mesh);
      const auto first = Grid::New();
      const auto whole = Grid::New();
      ASSERT_TRUE(run(mesh, first) && run(first, whole));
      for (const Partition& partition : Partitions)
      {
        SCOPED_TRACE(Describe(partition, mesh));
        const auto once = RunOnParts(Cut(mesh, partition), partition, options, run);
        ExpectWhole(whole, RunOnParts(once, partition, options, run));
        if (testing::Test::HasFailure())
        {
          return;
        }
      }
    }
  }
}
