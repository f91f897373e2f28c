// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Distribution/Distribution.h"

#include "Private/Control/SizeChecks.h"
#include "Private/Distribution/Layers.h"
#include "Private/Distribution/PointIds.h"
#include "Private/Distribution/Ranks.h"

#include "vtkAlgorithm.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkPointSet.h"

#include <utility>

namespace subdivision
{
namespace
{

std::vector<MeshPart> GetParts(const std::vector<Block>& blocks)
{
  std::vector<MeshPart> parts;
  for (size_t b = 0; b < blocks.size(); ++b)
  {
    MeshPart part;
    part.Mesh = blocks[b].Input;
    part.Block = static_cast<int>(b);
    parts.push_back(std::move(part));
  }
  return parts;
}

/// Runs the filter on the joined parts of a partition, and fills the outputs of its blocks.
bool RunPartition(std::vector<MeshPart> parts, int pointType,
  const DistributionOptions& distribution, const FilterTraits& traits, RunOptions& options,
  const FilterWork& work, std::vector<Block>& blocks)
{
  return DoWork(traits, options,
    [&]
    {
      JoinedMesh joined = Join(parts, pointType);
      AddPointBlocks(parts, joined);
      if (!RestoreStamp(parts, joined))
      {
        options.Warn("Earlier filters made the blocks or partitions of the input, but not all of "
                     "them in one run of one process. This filter takes them as any other mesh: "
                     "results are not those of one filter with all levels. Use one filter with "
                     "more levels, or switch JoinBlocks off, and each block goes on by itself.");
      }
      parts.clear();
      const auto whole = MakeMesh(distribution.IsOfSurfaces);
      if (!work(joined.Mesh, whole))
      {
        return false;
      }
      joined.Mesh = nullptr;
      TakeOutputs(joined, whole, options.OutputPointsPrecision == vtkAlgorithm::DEFAULT_PRECISION,
        distribution.GhostLayers, blocks);
      return true;
    });
}

}

bool RunPartitions(std::vector<std::vector<Block>>& partitions, Exchange& exchange,
  const DistributionOptions& distribution, const FilterTraits& traits, RunOptions& options,
  const FilterWork& work)
{
  std::vector<std::vector<MeshPart>> parts;
  for (const std::vector<Block>& blocks : partitions)
  {
    parts.push_back(GetParts(blocks));
  }
  const std::string tooLarge = CheckMemoryForJoining(parts);
  if (!tooLarge.empty())
  {
    options.Fail(tooLarge);
  }
  if (!exchange.Agree(tooLarge.empty()))
  {
    return false;
  }
  const int pointType = FindPointType(parts, exchange);
  if (exchange.GetNumberOfPartitions() > 1)
  {
    const std::string uneven = CheckLoad(parts, exchange);
    if (!uneven.empty())
    {
      options.Warn(uneven);
    }
    IdentifyPoints(parts, exchange, options.Warn);
    AddLayers(parts, distribution.Layers + distribution.GhostLayers, exchange);
    ShareArrays(parts, exchange);
  }
  else if (!TakeStampedIds(parts[0]))
  {
    IdentifyPoints(parts, exchange, options.Warn);
  }
  bool done = true;
  for (size_t p = 0; p < partitions.size() && done; ++p)
  {
    done = parts[p].empty() ||
      RunPartition(
        std::move(parts[p]), pointType, distribution, traits, options, work, partitions[p]);
  }
  return exchange.Agree(done);
}

void RequestOutput(vtkDataObject* input, bool isOfSurfaces, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkDataObject* output = info->Get(vtkDataObject::DATA_OBJECT());
  vtkSmartPointer<vtkDataObject> wanted;
  if (vtkDataObjectTree::SafeDownCast(input))
  {
    wanted.TakeReference(input->NewInstance());
  }
  else
  {
    wanted = MakeMesh(isOfSurfaces);
  }
  if (!output || output->GetDataObjectType() != wanted->GetDataObjectType())
  {
    info->Set(vtkDataObject::DATA_OBJECT(), wanted);
  }
}

int RunDistributed(vtkAlgorithm* filter, vtkDataObject* input, vtkDataObject* output,
  const DistributionOptions& distribution, const FilterTraits& traits, RunOptions& options,
  const FilterWork& work)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  const int ranks = distribution.Controller ? distribution.Controller->GetNumberOfProcesses() : 1;
  if (!composite && (ranks == 1 || !distribution.JoinBlocks))
  {
    return RunFilter(filter, vtkPointSet::SafeDownCast(input), vtkPointSet::SafeDownCast(output),
      traits, options, work);
  }
  bool failed = false;
  ConnectToFilter(filter, options, failed);
  bool done = true;
  std::vector<Block> blocks;
  if (distribution.JoinBlocks)
  {
    Exchange exchange(distribution.Controller);
    const MemoryShare share(CountRanksOfMachine(exchange));
    RankMessages messages(options);
    blocks = GetBlocks(input, distribution.IsOfSurfaces, options.Warn);
    PrepareBlocks(blocks, composite && distribution.AddBlockIndex, distribution.Prepare);
    std::vector<std::vector<Block>> partitions = { std::move(blocks) };
    done = RunPartitions(partitions, exchange, distribution, traits, options, work);
    blocks = std::move(partitions[0]);
    failed = messages.Tell(exchange);
  }
  else
  {
    blocks = GetBlocks(input, distribution.IsOfSurfaces, options.Warn);
    for (Block& block : blocks)
    {
      block.Output->GetFieldData()->PassData(block.Input->GetFieldData());
      done = done && DoWork(traits, options, [&] { return work(block.Input, block.Output); });
    }
  }
  if (done && !failed)
  {
    SetOutputs(input, blocks, distribution.IsOfSurfaces, output);
  }
  else
  {
    output->Initialize();
  }
  return failed ? 0 : 1;
}

int RunOnBlocks(vtkAlgorithm* filter, vtkDataObject* input, vtkDataObject* output,
  const FilterTraits& traits, RunOptions& options, const FilterWork& work)
{
  auto* from = vtkCompositeDataSet::SafeDownCast(input);
  auto* to = vtkCompositeDataSet::SafeDownCast(output);
  if (!from || !to)
  {
    return RunFilter(filter, vtkPointSet::SafeDownCast(input), vtkPointSet::SafeDownCast(output),
      traits, options, work);
  }
  to->CopyStructure(from);
  int result = 1;
  const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(from->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    vtkDataObject* block = iterator->GetCurrentDataObject();
    const auto made = vtkSmartPointer<vtkDataObject>::Take(block->NewInstance());
    made->GetFieldData()->PassData(block->GetFieldData());
    result &= RunFilter(filter, vtkPointSet::SafeDownCast(block), vtkPointSet::SafeDownCast(made),
      traits, options, work);
    to->SetDataSet(iterator, made);
  }
  return result;
}

}
