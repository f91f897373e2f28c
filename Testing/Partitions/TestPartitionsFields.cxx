// SPDX-License-Identifier: BSD-3-Clause
// Values that jump at interfaces are on partitions, simulated in one process, those of the whole
// mesh.
#include "PartitionTools.h"

#include "Private/Control/MaterialFields.h"
#include "Private/RedGreen/RedGreenRun.h"
#include "Private/Uniform/UniformSubdivision.h"

#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"

using namespace partition_tools;
using namespace multi_dimensional_subdivision_tools;

namespace
{

const Partition Partitions[] = { { "three slabs", 3, 1, false }, { "cell by cell", 3, 1, true },
  { "cell by cell on many", 8, 2, true } };

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

/// Compares parts with the whole. `work` gets the options for a part, with its materials.
template <typename Options, typename Work>
void ExpectWholeOf(const Options& options, const Work& work)
{
  for (const Mesh& mesh : MakeMeshes())
  {
    AddMaterials(mesh);
    Options shared = options;
    auto run = [&](vtkPointSet* input, vtkPointSet* output)
    {
      Options own = shared;
      own.Features.Material = input->GetCellData()->GetArray("MaterialId");
      return RunWithMaterialFields(input, output, own, { true, { CellName }, true },
        [&](vtkPointSet* control, vtkPointSet* made) { return work(control, own, made); });
    };
    const auto whole = Grid::New();
    ASSERT_TRUE(run(mesh, whole));
    EXPECT_TRUE(whole->GetPointData()->HasArray("MaterialPointIds"));
    for (const Partition& partition : Partitions)
    {
      SCOPED_TRACE(std::string(partition.Name) + ", mesh of " +
        std::to_string(mesh->GetNumberOfCells()) + " cells");
      subdivision::DistributionOptions distribution;
      distribution.WorksInRounds = true;
      std::vector<Mesh> outputs;
      EXPECT_TRUE(RunOnParts(Cut(mesh, partition), partition, distribution, shared, run, outputs));
      ExpectWhole(whole, outputs);
      if (testing::Test::HasFailure())
      {
        return;
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
    auto options = MakeOptions<subdivision::UniformOptions>();
    options.Levels = 2;
    options.Scheme = scheme;
    options.ProjectToLimit = scheme == subdivision::StampScheme::BoxSpline;
    ExpectWholeOf(options,
      [](vtkPointSet* input, const subdivision::UniformOptions& own, vtkPointSet* output)
      { return SubdivideUniformly(input, own, vtkUnstructuredGrid::SafeDownCast(output)); });
  }
}

TEST(PartitionsFields, GiveTheWholeOfRedGreen)
{
  auto options = MakeOptions<subdivision::RedGreenOptions>();
  options.Criteria.ByEdgeLength = true;
  options.Criteria.MaximumEdgeLength = 0.4;
  options.Criteria.MaximumLevel = 2;
  ExpectWholeOf(options,
    [](vtkPointSet* input, const subdivision::RedGreenOptions& own, vtkPointSet* output)
    { return RefineRedGreen(input, own, vtkUnstructuredGrid::SafeDownCast(output)); });
}
