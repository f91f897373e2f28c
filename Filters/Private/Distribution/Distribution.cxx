// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Distribution/Distribution.h"

#include "Private/Distribution/BlockCases.h"
#include "Private/Distribution/KeptParts.h"
#include "Private/Distribution/OwnValues.h"
#include "Private/Distribution/PointIds.h"
#include "Private/Distribution/Ranks.h"
#include "Private/Distribution/StampedParts.h"
#include "Private/Reading/ReadableMesh.h"
#include "Private/Run/SizeChecks.h"
#include "Private/vtkSubdivisionObjectsCompat.h"

#include "vtkAlgorithm.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkUniformGridAMR.h"

#include <algorithm>
#include <deque>
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
    part.Index = static_cast<int>(blocks[b].CompositeIndex);
    parts.push_back(std::move(part));
  }
  return parts;
}

/// One of the partitions of this rank.
class PartitionRun
{
public:
  PartitionRun(PartitionsOfRank& partitions, int i, std::vector<Block>& blocks, KeptPartition& kept,
    const DistributionOptions& distribution, RunOptions& options)
    : Blocks(blocks)
    , Kept(kept)
    , Distribution(distribution)
    , Options(options)
    , All(partitions, i)
    , Others(partitions, i)
    , IsPartial(partitions.GetNumberOfPartitions() > 1)
  {
  }

  /// The data for the work in this turn of the partition.
  void BeginTurn() { this->Options.Others = this->Others.HasStarted() ? &this->Others : nullptr; }

  /// Finds out which points are one, brings the layers, and does the work. Returns whether all is
  /// done, in all partitions.
  bool Run(const FilterTraits& traits, const FilterWork& work)
  {
    this->Parts = GetParts(this->Blocks);
    const std::string tooLarge = CheckMemoryForJoining(this->Parts);
    if (!tooLarge.empty())
    {
      this->Options.Fail(tooLarge);
    }
    if (!this->All.Agree(tooLarge.empty()))
    {
      return false;
    }
    this->PointType = FindPointType(this->Parts, this->All);
    this->AreStamped = this->PrepareParts();
    if (this->Distribution.HasCases)
    {
      *this->Distribution.HasCases = std::any_of(this->Parts.begin(), this->Parts.end(),
        [](const MeshPart& part) { return part.Case != 0; });
    }
    this->HaveOwn = AreSeveralBlocks(this->Parts, this->All) &&
      FindOwnBlocks(this->Parts, this->All,
        this->Distribution.KeepsOwnValues ? RunOptions().Warn : this->Options.Warn) &&
      this->Distribution.ReadsOwnBlocks;
    const auto workOnParts = [&]
    {
      return this->Parts.empty() ||
        DoWork(traits, this->Options, [&] { return this->WorkOnParts(work); });
    };
    try
    {
      return !this->IsPartial  ? workOnParts()
        : this->Blocks.empty() ? this->Others.Answer()
                               : this->Others.End(workOnParts());
    }
    catch (const PartitionStopped&)
    {
      return false;
    }
  }

private:
  /// Returns whether an earlier filter made the parts, so that this one may go on.
  bool PrepareParts()
  {
    const bool keepsOwn = this->Distribution.KeepsOwnValues;
    const int layers = this->Distribution.Layers + this->Distribution.GhostLayers;
    if (this->IsPartial)
    {
      const std::string uneven = CheckLoad(this->Parts, this->All);
      if (!uneven.empty() && this->All.GetPartition() == 0)
      {
        this->Options.Warn(uneven);
      }
      if (this->Kept.Restore(this->Parts, layers, keepsOwn, this->All))
      {
        std::vector<std::string> warnings = this->Kept.GetWarnings();
        Tell(warnings, this->Options);
        return this->Kept.AreStamped();
      }
    }
    std::vector<std::string> warnings;
    const bool areStamped = TakeStampedNumbers(this->Parts, this->All);
    bool haveSeveralPlaces = false;
    if (!areStamped)
    {
      haveSeveralPlaces = IdentifyPoints(
        this->Parts, this->All, [&](const std::string& message) { warnings.push_back(message); },
        keepsOwn);
    }
    else if (keepsOwn)
    {
      TakeCopiedPoints(this->Parts);
    }
    if (this->IsPartial)
    {
      SentLayers sent = AddLayers(this->Parts, layers, this->All);
      ShareArrays(this->Parts, this->All);
      this->Kept.Keep(this->Parts, std::move(sent), areStamped, haveSeveralPlaces, warnings);
    }
    Tell(warnings, this->Options);
    return areStamped;
  }
  /// Runs the filter on the joined parts, and fills the outputs of the blocks.
  bool WorkOnParts(const FilterWork& work)
  {
    const bool keepsOwn = this->Distribution.KeepsOwnValues;
    JoinedMesh joined = Join(this->Parts, this->PointType, keepsOwn || this->HaveOwn);
    AddPointBlocks(this->Parts, joined);
    if (!RestoreStamp(this->Parts, this->AreStamped, this->IsPartial, joined))
    {
      this->Options.Warn(
        "Earlier filters made the blocks or partitions of the input, but not all of them in one "
        "run, or cells keep their types on several ranks, or something is missing. This filter "
        "takes them as any other mesh: results are not those of one filter with all levels. Use "
        "one filter with more levels, or switch JoinBlocks off, and each block goes on by itself.");
    }
    if (keepsOwn || this->HaveOwn)
    {
      KeepOwnValues(this->Parts, joined, keepsOwn ? OwnValues::OfAll : OwnValues::OfBlocks);
    }
    if (this->Distribution.Change)
    {
      joined.Mesh = this->Distribution.Change(joined.Mesh);
    }
    this->Parts.clear();
    if (this->IsPartial)
    {
      this->Others.Start(joined, this->Kept.GetSent().OfFirst);
      this->BeginTurn();
    }
    const auto whole = MakeMesh(this->Distribution.IsOfSurfaces);
    if (!work(joined.Mesh, whole))
    {
      return false;
    }
    joined.Mesh = nullptr;
    OutputOptions output;
    output.OwnPrecision = this->Options.OutputPointsPrecision == vtkAlgorithm::DEFAULT_PRECISION;
    output.GhostLayers = this->Distribution.GhostLayers;
    if (this->HaveOwn)
    {
      whole->GetPointData()->RemoveArray(MaterialPointIdsName); // blocks are not torn
    }
    // A filter that cannot number its output of a part says why.
    output.GlobalIds = this->Options.GenerateGlobalIds &&
      (!this->IsPartial || whole->GetPointData()->HasArray(PointNumbersName));
    TakeOutputs(joined, whole, output, this->Blocks);
    return true;
  }

  std::vector<Block>& Blocks;
  KeptPartition& Kept;
  const DistributionOptions& Distribution;
  RunOptions& Options;
  ExchangeOfAll All;
  ExchangeOfWork Others;
  std::vector<MeshPart> Parts;
  int PointType = 0;
  bool IsPartial;          ///< there are other partitions
  bool AreStamped = false; ///< an earlier filter made the parts, and this one may go on
  bool HaveOwn = false;    ///< values of blocks differ, and the work reads OwnBlockName
};

}

bool RunPartitions(std::vector<std::vector<Block>>& blocks, PartitionsOfRank& partitions,
  const DistributionOptions& distribution, const FilterTraits& traits, RunOptions& options,
  const FilterWork& work)
{
  KeptParts own;
  std::vector<KeptPartition>& kept = (distribution.Kept ? *distribution.Kept : own).OfPartitions;
  kept.resize(blocks.size());
  std::deque<PartitionRun> runs;
  for (size_t i = 0; i < blocks.size(); ++i)
  {
    runs.emplace_back(partitions, static_cast<int>(i), blocks[i], kept[i], distribution, options);
  }
  options.GhostLayers = distribution.GhostLayers;
  bool done = true;
  partitions.Run(
    [&](int i) { done = runs[i].Run(traits, work) && done; }, [&](int i) { runs[i].BeginTurn(); });
  options.Others = nullptr;
  return done;
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
  else if (vtkUniformGridAMR::SafeDownCast(input)) // MakeTree
  {
    wanted = vtkSmartPointer<vtkMultiBlockDataSet>::New();
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
  const FilterWork workOnAll = [&](vtkPointSet* mesh, vtkPointSet* made)
  {
    const bool done =
      distribution.Change ? work(distribution.Change(mesh), made) : work(mesh, made);
    if (done && options.GenerateGlobalIds)
    {
      AddGlobalIds(made);
    }
    return done;
  };
  const int ranks = distribution.Controller ? distribution.Controller->GetNumberOfProcesses() : 1;
  const auto tellWarnings = [&]
  {
    std::vector<std::string> warnings = distribution.Warnings;
    Tell(warnings, options);
  };
  if (!composite && (ranks == 1 || !distribution.JoinBlocks))
  {
    return RunFilter(filter, vtkPointSet::SafeDownCast(input), vtkPointSet::SafeDownCast(output),
      traits, options,
      [&](vtkPointSet* from, vtkPointSet* to)
      {
        tellWarnings();
        return workOnAll(from, to);
      });
  }
  bool failed = false;
  ConnectToFilter(filter, options, failed);
  bool done = true;
  std::vector<Block> blocks;
  if (distribution.JoinBlocks)
  {
    PartitionsOfRank ofRank(distribution.Controller);
    ExchangeOfAll exchange(ofRank);
    const MemoryShare share(CountRanksOfMachine(exchange));
    RankMessages messages(options);
    tellWarnings();
    std::vector<std::vector<Block>> ofPartitions(1);
    const auto join = [&]
    {
      ofPartitions[0] = GetBlocks(input, distribution.IsOfSurfaces, options.Warn);
      PrepareBlocks(ofPartitions[0], composite && distribution.AddBlockIndex, distribution.Prepare);
      return RunPartitions(ofPartitions, ofRank, distribution, traits, options, work);
    };
    done = ranks > 1 ? join() : DoWork(traits, options, join); // other ranks wait for this one
    blocks = std::move(ofPartitions[0]);
    failed = messages.Tell(exchange,
      done                  ? RunEnd::Done
        : IsAborted(filter) ? RunEnd::Stopped
                            : RunEnd::NotDone);
  }
  else
  {
    tellWarnings();
    blocks = GetBlocks(input, distribution.IsOfSurfaces, options.Warn);
    const ProgressPart part = options.Part;
    const auto count = static_cast<double>(blocks.size());
    for (size_t b = 0; b < blocks.size() && done; ++b)
    {
      const Block& block = blocks[b];
      const auto before = static_cast<double>(b);
      options.Part = part.Take(before / count, (before + 1.) / count);
      ConnectToFilter(filter, options, failed);
      block.Output->GetFieldData()->PassData(block.Input->GetFieldData());
      done = DoWork(traits, options, [&] { return workOnAll(block.Input, block.Output); });
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
  CopyTree(from, to);
  int result = 1;
  const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(from->NewIterator());
  double count = 0.;
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    count += 1.;
  }
  const ProgressPart part = options.Part;
  double before = 0.;
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    options.Part = part.Take(before / count, (before + 1.) / count);
    before += 1.;
    vtkDataObject* block = iterator->GetCurrentDataObject();
    const auto made = vtkSmartPointer<vtkDataObject>::Take(block->NewInstance());
    made->GetFieldData()->PassData(block->GetFieldData());
    result &= RunFilter(filter, vtkPointSet::SafeDownCast(block), vtkPointSet::SafeDownCast(made),
      traits, options, work);
    if (IsAborted(filter))
    {
      to->Initialize();
      return result;
    }
    to->SetDataSet(iterator, made);
  }
  return result;
}

}
