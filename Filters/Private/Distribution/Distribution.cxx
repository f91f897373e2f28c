// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Distribution/Distribution.h"

#include "Private/Distribution/Layers.h"
#include "Private/Distribution/PointIds.h"

#include "vtkAlgorithm.h"
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
  if (exchange.GetNumberOfPartitions() > 1)
  {
    IdentifyPoints(parts, exchange, options.Warn);
    AddLayers(parts, distribution.Layers, exchange);
  }
  else if (!TakeStampedIds(parts[0]))
  {
    IdentifyPoints(parts, exchange, options.Warn);
  }
  bool done = true;
  for (size_t p = 0; p < partitions.size() && done; ++p)
  {
    if (parts[p].empty())
    {
      continue;
    }
    JoinedMesh joined = Join(parts[p]);
    AddPointBlocks(parts[p], joined);
    RestoreStamp(parts[p], joined);
    parts[p].clear();
    const auto whole = MakeMesh(distribution.IsOfSurfaces);
    done = DoWork(joined.Mesh, whole, traits, options, work);
    joined.Mesh = nullptr;
    for (size_t b = 0; b < partitions[p].size() && done; ++b)
    {
      TakeOutput(joined, whole, options.OutputPointsPrecision == vtkAlgorithm::DEFAULT_PRECISION,
        static_cast<int>(b), partitions[p]);
    }
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
  std::vector<Block> blocks = GetBlocks(input, distribution.IsOfSurfaces, options.Warn);
  bool done = true;
  if (distribution.JoinBlocks)
  {
    PrepareBlocks(blocks, composite && distribution.AddBlockIndex, distribution.Prepare);
    Exchange exchange(distribution.Controller);
    std::vector<std::vector<Block>> partitions = { std::move(blocks) };
    done = RunPartitions(partitions, exchange, distribution, traits, options, work);
    blocks = std::move(partitions[0]);
  }
  else
  {
    for (Block& block : blocks)
    {
      block.Output->GetFieldData()->PassData(block.Input->GetFieldData());
      done = done && DoWork(block.Input, block.Output, traits, options, work);
    }
  }
  if (done)
  {
    SetOutputs(input, blocks, distribution.IsOfSurfaces, output);
  }
  else
  {
    output->Initialize();
  }
  return failed ? 0 : 1;
}

}
