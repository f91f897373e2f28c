// SPDX-License-Identifier: BSD-3-Clause
#include "Private/Distribution/Distribution.h"

#include "Private/Distribution/BlockCases.h"
#include "Private/Distribution/KeptParts.h"
#include "Private/Distribution/Meeting.h"
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
#include <map>
#include <memory>
#include <mutex>
#include <thread>
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

/// The partitions of this rank and what their work has to do with the others.
class Rounds
{
public:
  Rounds(Exchange& exchange, const std::vector<SentLayers>& sent)
    : With(exchange)
    , Sent(sent)
  {
  }

  void Start(int partition, const JoinedMesh& joined)
  {
    auto partners = this->With.MakePartners(partition, joined, this->Sent[partition].OfFirst);
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->OfMesh[joined.Mesh] = std::move(partners);
  }
  Partners* Find(vtkPointSet* mesh)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    const auto found = this->OfMesh.find(mesh);
    return found == this->OfMesh.end() ? nullptr : found->second.get();
  }
  /// Runs the work on a partition, or answers for it; returns whether all partitions are done.
  bool Run(int partition, bool hasMesh, const std::function<bool()>& work)
  {
    try
    {
      return hasMesh ? this->With.End(partition, work()) : this->With.Answer(partition);
    }
    catch (const PartnersStopped&)
    {
      return false;
    }
  }

private:
  Meeting With;
  const std::vector<SentLayers>& Sent;
  std::mutex Mutex;
  std::map<vtkPointSet*, std::unique_ptr<Partners>> OfMesh;
};

/// What the work on one partition needs.
struct PartitionWork
{
  std::vector<MeshPart> Parts;
  bool IsPartial;  ///< there are other partitions
  bool AreStamped; ///< an earlier filter made them, and this one may go on
  bool HaveOwn;    ///< values of blocks differ, and the work reads OwnBlockName
  std::vector<Block>& Blocks;
  int PointType;
  const DistributionOptions& Distribution;
  const FilterTraits& Traits;
  RunOptions& Options;
  const FilterWork& Work;
};

/// Runs the filter on the joined parts of a partition, and fills the outputs of its blocks;
/// `rounds`: null if the work does not need the others.
bool RunPartition(PartitionWork run, Rounds* rounds, int partition)
{
  return DoWork(run.Traits, run.Options,
    [&]
    {
      const bool keepsOwn = run.Distribution.KeepsOwnValues;
      JoinedMesh joined = Join(run.Parts, run.PointType, keepsOwn || run.HaveOwn);
      AddPointBlocks(run.Parts, joined);
      if (!RestoreStamp(run.Parts, run.AreStamped, run.IsPartial, joined))
      {
        run.Options.Warn(
          "Earlier filters made the blocks or partitions of the input, but not all of "
          "them in one run, or something is missing. This filter takes them as any other mesh: "
          "results are not those of one filter with all levels. Use one filter with "
          "more levels, or switch JoinBlocks off, and each block goes on by itself.");
      }
      if (keepsOwn || run.HaveOwn)
      {
        KeepOwnValues(run.Parts, joined, keepsOwn ? OwnValues::OfAll : OwnValues::OfBlocks);
      }
      if (run.Distribution.Change)
      {
        joined.Mesh = run.Distribution.Change(joined.Mesh);
      }
      run.Parts.clear();
      if (rounds)
      {
        rounds->Start(partition, joined);
      }
      const auto whole = MakeMesh(run.Distribution.IsOfSurfaces);
      if (!run.Work(joined.Mesh, whole))
      {
        return false;
      }
      joined.Mesh = nullptr;
      OutputOptions output;
      output.OwnPrecision = run.Options.OutputPointsPrecision == vtkAlgorithm::DEFAULT_PRECISION;
      output.GhostLayers = run.Distribution.GhostLayers;
      if (run.HaveOwn)
      {
        whole->GetPointData()->RemoveArray(MaterialPointIdsName); // blocks are not torn
      }
      // A filter that cannot number what it makes of a part says why.
      output.GlobalIds = run.Options.GenerateGlobalIds &&
        (!run.IsPartial || whole->GetPointData()->HasArray(PointNumbersName));
      TakeOutputs(joined, whole, output, run.Blocks);
      return true;
    });
}

/// Finds out which points are one, and brings the layers. Returns whether an earlier filter made
/// the parts, so that this one may go on.
bool PrepareParts(std::vector<std::vector<MeshPart>>& parts, Exchange& exchange,
  const DistributionOptions& distribution, KeptParts& kept, RunOptions& options)
{
  const bool isShared = exchange.GetNumberOfPartitions() > 1;
  const int layers = distribution.Layers + distribution.GhostLayers;
  if (isShared)
  {
    const std::string uneven = CheckLoad(parts, exchange);
    if (!uneven.empty())
    {
      options.Warn(uneven);
    }
    if (kept.Restore(parts, layers, distribution.KeepsOwnValues, exchange))
    {
      std::vector<std::string> warnings = kept.GetWarnings();
      Tell(warnings, options);
      return kept.AreStamped();
    }
  }
  std::vector<std::string> warnings;
  const bool areStamped = TakeStampedNumbers(parts, exchange);
  bool haveSeveralPlaces = false;
  if (!areStamped)
  {
    haveSeveralPlaces = IdentifyPoints(
      parts, exchange, [&](const std::string& message) { warnings.push_back(message); },
      distribution.KeepsOwnValues);
  }
  else if (distribution.KeepsOwnValues)
  {
    TakeCopiedPoints(parts);
  }
  if (isShared)
  {
    std::vector<SentLayers> sent = AddLayers(parts, layers, exchange);
    ShareArrays(parts, exchange);
    kept.Keep(parts, std::move(sent), areStamped, haveSeveralPlaces, warnings);
  }
  Tell(warnings, options);
  return areStamped;
}

/// Calls run(0) to run(size - 1) side by side.
void RunTogether(size_t size, const std::function<void(size_t)>& run)
{
  std::vector<std::thread> threads;
  for (size_t i = 1; i < size; ++i)
  {
    threads.emplace_back(run, i);
  }
  run(0);
  for (std::thread& thread : threads)
  {
    thread.join();
  }
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
  KeptParts own;
  KeptParts& kept = distribution.Kept ? *distribution.Kept : own;
  const bool areStamped = PrepareParts(parts, exchange, distribution, kept, options);
  if (distribution.HasCases)
  {
    *distribution.HasCases = std::any_of(
      parts[0].begin(), parts[0].end(), [](const MeshPart& part) { return part.Case != 0; });
  }
  const bool haveOwn = AreSeveralBlocks(parts, exchange) &&
    FindOwnBlocks(
      parts, exchange, distribution.KeepsOwnValues ? RunOptions().Warn : options.Warn) &&
    distribution.ReadsOwnBlocks;
  const auto run = [&](size_t p, Rounds* rounds)
  {
    return parts[p].empty() ||
      RunPartition({ std::move(parts[p]), exchange.GetNumberOfPartitions() > 1, areStamped, haveOwn,
                     partitions[p], pointType, distribution, traits, options, work },
        rounds, static_cast<int>(p));
  };
  const bool inRounds = distribution.WorksInRounds || exchange.GetPartitionsOfRank() == 1;
  if (inRounds && exchange.GetNumberOfPartitions() > 1)
  {
    Rounds rounds(exchange, kept.GetSent());
    options.FindPartners = [&rounds](vtkPointSet* mesh) { return rounds.Find(mesh); };
    options.GhostLayers = distribution.GhostLayers;
    std::vector<char> done(partitions.size(), 0);
    RunTogether(partitions.size(),
      [&](size_t p)
      {
        done[p] =
          rounds.Run(static_cast<int>(p), !partitions[p].empty(), [&] { return run(p, &rounds); });
      });
    options.FindPartners = nullptr;
    return std::find(done.begin(), done.end(), 0) == done.end();
  }
  bool done = true;
  for (size_t p = 0; p < partitions.size() && done; ++p)
  {
    done = run(p, nullptr);
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
    Exchange exchange(distribution.Controller);
    const MemoryShare share(CountRanksOfMachine(exchange));
    RankMessages messages(options);
    tellWarnings();
    std::vector<std::vector<Block>> partitions(1);
    const auto join = [&]
    {
      partitions[0] = GetBlocks(input, distribution.IsOfSurfaces, options.Warn);
      PrepareBlocks(partitions[0], composite && distribution.AddBlockIndex, distribution.Prepare);
      return RunPartitions(partitions, exchange, distribution, traits, options, work);
    };
    done = ranks > 1 ? join() : DoWork(traits, options, join); // other ranks wait for this one
    blocks = std::move(partitions[0]);
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
