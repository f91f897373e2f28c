// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestPartitionsBounds.cxx
 * Error bounds of the parts of a mesh are those of the whole.
 */
#include "PartitionTools.h"

#include "Private/Uniform/UniformBounds.h"

using namespace partition_tools;

namespace
{

bool Subdivide(vtkPointSet* input, const subdivision::UniformOptions& options, vtkPointSet* output)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(output);
  return SubdivideUniformly(input, options, grid) && AddUniformBounds(input, options, grid);
}

void CheckParts(vtkPointSet* whole, const std::function<void(subdivision::UniformOptions&)>& set)
{
  subdivision::UniformOptions options;
  options.Warn = [](const std::string&) {};
  options.Fail = [](const std::string& message) { ADD_FAILURE() << message; };
  options.KeepsCopies = true;
  set(options);
  const auto expected = vtkSmartPointer<vtkUnstructuredGrid>::New();
  ASSERT_TRUE(Subdivide(whole, options, expected));
  ASSERT_TRUE(expected->GetCellData()->HasArray("ErrorBound"));
  for (const Partition& partition : CommonPartitions)
  {
    SCOPED_TRACE(partition.Name);
    subdivision::DistributionOptions distribution;
    distribution.Layers = 3;
    subdivision::UniformOptions ofParts = options;
    std::vector<Mesh> outputs;
    EXPECT_TRUE(RunOnParts(
      Cut(whole, partition), partition, distribution, ofParts,
      [&](vtkPointSet* input, vtkPointSet* output) { return Subdivide(input, ofParts, output); },
      outputs));
    ExpectWhole(expected, outputs);
  }
}

}

TEST(PartitionsBounds, AreThoseOfTheWhole)
{
  const std::vector<Mesh> meshes = MakeMeshes();
  const Mesh solid = meshes[1];
  const Mesh skin = MakeSkin(meshes[0]);
  CheckParts(skin, [](subdivision::UniformOptions& o) { o.Levels = 1; });
  CheckParts(skin,
    [](subdivision::UniformOptions& o)
    {
      o.Levels = 0;
      o.ProjectToLimit = true;
    });
  CheckParts(solid, [](subdivision::UniformOptions& o) { o.Levels = 0; });
  CheckParts(solid,
    [](subdivision::UniformOptions& o)
    {
      o.Levels = 0;
      o.Scheme = subdivision::StampScheme::TetOct;
    });
}
