// SPDX-License-Identifier: BSD-3-Clause
// How the work of blocks and ranks ended.
#include "FeatureTools.h"
#include "PartitionTools.h"

#include "vtkSurfaceSubdivision.h"

using namespace partition_tools;
using namespace multi_dimensional_subdivision_tools;
using subdivision::DistributionOptions;
using subdivision::RunOptions;

TEST(RunEnds, NoOutputIsEmptyWithoutAnError)
{
  const Mesh mesh = MakeSkin(MakeMeshes()[0]);
  vtkNew<vtkMultiBlockDataSet> input;
  input->SetBlock(0, mesh);
  const auto run = [&](const std::function<bool(RunOptions&, vtkAlgorithm*)>& work)
  {
    vtkNew<vtkSurfaceSubdivision> filter;
    vtkNew<Messages> messages;
    messages->Watch(filter);
    vtkNew<vtkMultiBlockDataSet> output;
    DistributionOptions distribution;
    distribution.IsOfSurfaces = true;
    RunOptions options;
    RunDistributed(filter, input, output, distribution, subdivision::FilterTraits(), options,
      [&](vtkPointSet*, vtkPointSet*) { return work(options, filter); });
    EXPECT_EQ(output->GetNumberOfBlocks(), 0u);
    return messages->Errors;
  };
  const auto silent = run([](RunOptions&, vtkAlgorithm*) { return false; });
  ASSERT_EQ(silent.size(), 1u);
  EXPECT_NE(silent[0].find("without an output"), std::string::npos) << silent[0];
  const auto failed = run(
    [](RunOptions& options, vtkAlgorithm*)
    {
      options.Fail("a reason");
      return false;
    });
  ASSERT_EQ(failed.size(), 1u);
  EXPECT_NE(failed[0].find("a reason"), std::string::npos) << failed[0];
  const auto stopped = run(
    [](RunOptions&, vtkAlgorithm* filter)
    {
      filter->SetAbortExecute(1);
      return false;
    });
  EXPECT_TRUE(stopped.empty());
}
