// SPDX-License-Identifier: BSD-3-Clause
// Red-green refinement of partitions, simulated in one process, splits the cells that it splits in
// the whole mesh.
#include "PartitionTools.h"

#include "Private/Control/Partners.h"
#include "Private/Distribution/Distribution.h"
#include "Private/RedGreen/RedGreenRun.h"

#include "vtkCellData.h"
#include "vtkPointData.h"

#include <atomic>
#include <cmath>

using namespace partition_tools;
using namespace multi_dimensional_subdivision_tools;
using subdivision::Block;
using subdivision::RedGreenOptions;

namespace
{

struct Partition
{
  const char* Name;
  int Parts;
  int Blocks; ///< of each part
  bool ByChance;
  int Empty; ///< parts without cells, the first ones
};

const Partition Partitions[] = { { "halves", 2, 1, false, 0 }, { "three slabs", 3, 2, false, 1 },
  { "cell by cell", 3, 1, true, 0 }, { "cell by cell on many", 8, 1, true, 0 } };

constexpr const char* WantedName = "Wanted";
constexpr const char* FieldName = "Field";

/// Adds what criteria read: a wanted level that is high in few cells, and a field with a front.
void AddFields(vtkPointSet* mesh)
{
  vtkNew<vtkIntArray> wanted;
  wanted->SetName(WantedName);
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
  {
    wanted->InsertNextValue(c % 23 == 5 ? 3 : (c % 7 == 1 ? 1 : 0));
  }
  mesh->GetCellData()->AddArray(wanted);
  vtkNew<vtkDoubleArray> field;
  field->SetName(FieldName);
  double box[6];
  mesh->GetBounds(box);
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    const double* x = mesh->GetPoint(p);
    const double along = (x[0] - box[0]) / (box[1] - box[0]) + 0.2 * x[1];
    field->InsertNextValue(std::tanh(20. * (along - 0.5)));
  }
  mesh->GetPointData()->AddArray(field);
}

std::vector<Mesh> MakeMeshesWithFields()
{
  const std::vector<Mesh> meshes = MakeMeshes();
  for (const Mesh& mesh : meshes)
  {
    AddFields(mesh);
  }
  return meshes;
}

struct Choice
{
  const char* Name;
  std::function<void(vtkPointSet*, RedGreenOptions&)> Set; ///< for the mesh, or a part of it
};

const Choice Choices[] = { { "edge length",
                             [](vtkPointSet*, RedGreenOptions& o)
                             {
                               o.Criteria.ByEdgeLength = true;
                               o.Criteria.MaximumEdgeLength = 0.35;
                             } },
  { "wanted level", [](vtkPointSet* mesh, RedGreenOptions& o)
    { o.Criteria.WantedLevel = mesh->GetCellData()->GetArray(WantedName); } },
  { "jump",
    [](vtkPointSet* mesh, RedGreenOptions& o)
    {
      o.Criteria.Attribute = mesh->GetPointData()->GetArray(FieldName);
      o.Criteria.AttributeTolerance = 0.2;
    } },
  { "geometric error, at the limit",
    [](vtkPointSet*, RedGreenOptions& o)
    {
      o.Criteria.ByGeometricError = true;
      o.Criteria.GeometricTolerance = 0.004;
      o.Criteria.MaximumLevel = 2;
      o.LimitPlacement = true;
    } },
  { "difference from the limit", [](vtkPointSet* mesh, RedGreenOptions& o)
    {
      o.Criteria.Attribute = mesh->GetPointData()->GetArray(FieldName);
      o.Criteria.AttributeTolerance = 0.03;
      o.Criteria.AttributeErrorOfLimit = true;
      o.Criteria.MaximumLevel = 2;
    } } };

RedGreenOptions MakeOptions()
{
  RedGreenOptions options;
  options.Warn = [](const std::string&) {};
  options.Fail = [](const std::string& message) { ADD_FAILURE() << message; };
  options.Criteria.MaximumLevel = 3;
  return options;
}

bool Refine(
  vtkPointSet* input, vtkPointSet* output, const Choice& choice, const RedGreenOptions& options)
{
  RedGreenOptions own = options;
  choice.Set(input, own);
  return RefineRedGreen(input, own, vtkUnstructuredGrid::SafeDownCast(output));
}

/// Counts the exchanges of a round, which begins with a sum of marks and ends with one of cells.
class CountingPartners : public subdivision::Partners
{
public:
  CountingPartners(Partners* of, std::atomic<int>& most)
    : Of(of)
    , Most(most)
  {
  }
  int GetPartition() const override { return this->Of->GetPartition(); }
  int GetNumberOfPartitions() const override { return this->Of->GetNumberOfPartitions(); }
  const std::vector<vtkIdType>& GetPointIds() const override { return this->Of->GetPointIds(); }
  const std::vector<vtkIdType>& GetCellIds() const override { return this->Of->GetCellIds(); }
  bool IsOwn(vtkIdType cell) const override { return this->Of->IsOwn(cell); }
  const std::vector<int>& GetNeighbours(vtkIdType cell) const override
  {
    return this->Of->GetNeighbours(cell);
  }
  bool Send(Messages& messages) override
  {
    const bool hasSent = this->Of->Send(messages);
    this->Sent += hasSent ? 1 : 0;
    if (this->Sent > this->Most && this->IsInRound)
    {
      this->Most = this->Sent;
    }
    return hasSent;
  }
  std::vector<vtkIdType> Gather(vtkIdType own) override
  {
    this->Sent = 0;
    this->IsInRound = true;
    return this->Of->Gather(own);
  }

private:
  Partners* Of;
  std::atomic<int>& Most;
  int Sent = 0;
  bool IsInRound = false;
};

std::atomic<int> MostExchanges{ 0 }; ///< in a round

/// Refines the parts of a mesh. `options` may be changed for one of the parts.
bool RefineParts(const std::vector<Mesh>& cut, const Partition& partition, const Choice& choice,
  const RedGreenOptions& options, std::vector<Mesh>& outputs)
{
  std::vector<std::vector<Block>> blocks(static_cast<size_t>(partition.Parts + partition.Empty));
  for (size_t i = 0; i < cut.size(); ++i)
  {
    Block block;
    block.Input = cut[i];
    block.Output = subdivision::MakeMesh(false);
    blocks[static_cast<size_t>(partition.Empty) + i / static_cast<size_t>(partition.Blocks)]
      .push_back(block);
  }
  subdivision::Exchange exchange(nullptr, partition.Parts + partition.Empty);
  subdivision::DistributionOptions distribution;
  distribution.WorksInRounds = true;
  RedGreenOptions shared = options;
  const bool done =
    RunPartitions(blocks, exchange, distribution, subdivision::FilterTraits(), shared,
      [&](vtkPointSet* input, vtkPointSet* output)
      {
        CountingPartners partners(shared.FindPartners(input), MostExchanges);
        RedGreenOptions own = shared;
        own.FindPartners = [&partners](vtkPointSet*) { return &partners; };
        return Refine(input, output, choice, own);
      });
  outputs.clear();
  for (const auto& own : blocks)
  {
    for (const Block& block : own)
    {
      outputs.push_back(block.Output);
    }
  }
  return done;
}

std::vector<Mesh> Cut(vtkPointSet* whole, const Partition& partition)
{
  const int count = partition.Parts * partition.Blocks;
  return Cut(whole, partition.ByChance ? CutByChance(whole, count, 17) : CutInSlabs(whole, count),
    count, KnownBy::GlobalIds);
}

}

TEST(PartitionsRedGreen, GiveTheWhole)
{
  for (const Mesh& mesh : MakeMeshesWithFields())
  {
    for (const Choice& choice : Choices)
    {
      const auto whole = Grid::New();
      ASSERT_TRUE(Refine(mesh, whole, choice, MakeOptions()));
      for (const Partition& partition : Partitions)
      {
        SCOPED_TRACE(std::string(partition.Name) + ", " + choice.Name + ", mesh of " +
          std::to_string(mesh->GetNumberOfCells()) + " cells, output of " +
          std::to_string(whole->GetNumberOfCells()));
        std::vector<Mesh> outputs;
        MostExchanges = 0;
        EXPECT_TRUE(RefineParts(Cut(mesh, partition), partition, choice, MakeOptions(), outputs));
        EXPECT_GE(4, MostExchanges);
        ExpectWhole(whole, outputs);
        if (HasFailure())
        {
          return;
        }
      }
    }
  }
}

// At the limit of cells all partitions leave out the same.
TEST(PartitionsRedGreen, StopTogether)
{
  const Mesh mesh = MakeMeshesWithFields().back();
  for (const Choice& choice : Choices)
  {
    const auto free = Grid::New();
    ASSERT_TRUE(Refine(mesh, free, choice, MakeOptions()));
    RedGreenOptions options = MakeOptions();
    options.Criteria.MaximumLevel = 0;
    const auto unrefined = Grid::New();
    ASSERT_TRUE(Refine(mesh, unrefined, { "", [](vtkPointSet*, RedGreenOptions&) {} }, options));
    options = MakeOptions();
    options.MaximumNumberOfCells = (unrefined->GetNumberOfCells() + free->GetNumberOfCells()) / 2;
    std::atomic<int> warnings{ 0 };
    options.Warn = [&](const std::string& message)
    { warnings += message.find("not refined") != std::string::npos ? 1 : 0; };
    vtkIdType sizeOfFirst = 0;
    for (const Partition& partition : Partitions)
    {
      SCOPED_TRACE(std::string(partition.Name) + ", " + choice.Name);
      std::vector<Mesh> outputs;
      warnings = 0;
      EXPECT_TRUE(RefineParts(Cut(mesh, partition), partition, choice, options, outputs));
      vtkIdType size = 0;
      for (const Mesh& output : outputs)
      {
        size += output->GetNumberOfCells();
      }
      EXPECT_LE(size, options.MaximumNumberOfCells);
      EXPECT_GE(size, unrefined->GetNumberOfCells());
      sizeOfFirst = sizeOfFirst == 0 ? size : sizeOfFirst;
      EXPECT_EQ(sizeOfFirst, size);
      EXPECT_GE(1, warnings);
    }
  }
}

// Where one partition fails the others do not wait for it.
TEST(PartitionsRedGreen, FailTogether)
{
  const Mesh mesh = MakeMeshesWithFields().back();
  for (const int stopAt : { 0, 1, 3 })
  {
    RedGreenOptions options = MakeOptions();
    std::atomic<int> calls{ 0 };
    options.Progress = [&calls, stopAt](double) { return calls++ == stopAt; };
    std::vector<Mesh> outputs;
    EXPECT_FALSE(
      RefineParts(Cut(mesh, Partitions[1]), Partitions[1], Choices[0], options, outputs));
  }
}
