// SPDX-License-Identifier: BSD-3-Clause
// Red-green refinement of partitions, simulated in one process, splits the cells that it splits in
// the whole mesh.
#include "PartitionTools.h"
#include "Turns.h"

#include "Private/Distribution/KeptParts.h"
#include "Private/RedGreen/RedGreenRefinement.h"

#include <mutex>

using namespace partition_tools;
using namespace multi_dimensional_subdivision_tools;
using subdivision::RedGreenOptions;

namespace
{

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
      o.GenerateLimitNormals = true;
    } },
  { "difference from the limit",
    [](vtkPointSet* mesh, RedGreenOptions& o)
    {
      o.Criteria.Attribute = mesh->GetPointData()->GetArray(FieldName);
      o.Criteria.AttributeTolerance = 0.03;
      o.Criteria.AttributeErrorOfLimit = true;
      o.Criteria.MaximumLevel = 2;
    } },
  { "tet/oct limit",
    [](vtkPointSet*, RedGreenOptions& o)
    {
      o.Criteria.ByGeometricError = true;
      o.Criteria.GeometricTolerance = 0.004;
      o.Criteria.MaximumLevel = 2;
      o.LimitPlacement = true;
      o.Scheme = subdivision::StampScheme::TetOct;
    } },
  { "interpolating limit", [](vtkPointSet* mesh, RedGreenOptions& o)
    {
      o.Criteria.ByGeometricError = true;
      o.Criteria.GeometricTolerance = 0.004;
      o.Criteria.Attribute = mesh->GetPointData()->GetArray(FieldName);
      o.Criteria.AttributeTolerance = 0.1;
      o.Criteria.AttributeErrorOfLimit = true;
      o.Criteria.MaximumLevel = 2;
      o.LimitPlacement = true;
      o.Interpolation.Points = true;
      o.Interpolation.Arrays = true;
    } } };

RedGreenOptions MakeOptions()
{
  RedGreenOptions options;
  options.Warn = [](const std::string&) {};
  options.Fail = [](const std::string& message) { ADD_FAILURE() << message; };
  options.GenerateGlobalIds = true;
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

std::atomic<int> MostExchanges{ 0 }; ///< in a round

/// Refines the parts of a mesh. `options` may be changed for one of the parts.
bool RefineParts(const std::vector<Mesh>& cut, const Partition& partition, const Choice& choice,
  const RedGreenOptions& options, std::vector<Mesh>& outputs,
  subdivision::KeptParts* kept = nullptr)
{
  subdivision::DistributionOptions distribution;
  distribution.Kept = kept;
  RedGreenOptions chosen = options;
  choice.Set(cut[0], chosen);
  distribution.Layers = chosen.Scheme == subdivision::StampScheme::TetOct ? 3 : 2;
  RedGreenOptions shared = options;
  return RunOnParts(
    cut, partition, distribution, shared,
    [&](vtkPointSet* input, vtkPointSet* output)
    {
      CountingExchange others(shared.Others, MostExchanges);
      RedGreenOptions own = shared;
      own.Others = &others;
      return Refine(input, output, choice, own);
    },
    outputs);
}

}

TEST(PartitionsRedGreen, GiveTheWhole)
{
  for (const Mesh& mesh : MakeMeshesWithFields())
  {
    for (const Choice& choice : turns::Some(Choices))
    {
      const auto whole = Grid::New();
      ASSERT_TRUE(Refine(mesh, whole, choice, MakeOptions()));
      subdivision::AddGlobalIds(whole);
      for (const Partition& partition : CommonPartitions)
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

namespace
{

/// Refines a mesh and its parts once, then `change`s both, and lets `next` go on.
void ExpectToGoOn(
  vtkPointSet* mesh, const Choice& first, const Choice& second,
  const std::function<void(vtkPointSet*)>& change = [](vtkPointSet*) {})
{
  RedGreenOptions options = MakeOptions();
  options.Criteria.MaximumLevel = 1;
  RedGreenOptions more = MakeOptions();
  more.Criteria.MaximumLevel = 2;
  const auto once = Grid::New();
  const auto twice = Grid::New();
  ASSERT_TRUE(Refine(mesh, once, first, options));
  change(once);
  ASSERT_TRUE(Refine(once, twice, second, more));
  subdivision::AddGlobalIds(twice);
  for (const Partition& partition : { CommonPartitions[1], CommonPartitions[3] })
  {
    SCOPED_TRACE(std::string(partition.Name) + ", " + first.Name + ", then " + second.Name +
      ", mesh of " + std::to_string(mesh->GetNumberOfCells()) + " cells, output of " +
      std::to_string(twice->GetNumberOfCells()));
    std::vector<Mesh> parts;
    ASSERT_TRUE(RefineParts(Cut(mesh, partition), partition, first, options, parts));
    for (const Mesh& part : parts)
    {
      change(part);
    }
    subdivision::KeptParts kept;
    for (int step = 0; step < 2; ++step) // what is kept makes no difference
    {
      std::vector<Mesh> outputs;
      ASSERT_TRUE(RefineParts(parts, partition, second, more, outputs, &kept));
      ExpectWhole(twice, outputs);
    }
  }
}

}

// A second filter finds the leaves of the first one, wherever their parts are, and refines these;
// where the limit counts, it takes green cells as they are.
TEST(PartitionsRedGreen, TheNextFilterGoesOn)
{
  const std::pair<int, int> pairs[] = { { 1, 2 }, { 2, 1 }, { 1, 3 }, { 3, 1 } };
  for (const Mesh& mesh : MakeMeshesWithFields())
  {
    for (const auto& [first, second] : turns::Some(pairs))
    {
      ExpectToGoOn(mesh, Choices[first], Choices[second]);
      if (HasFailure())
      {
        return;
      }
    }
  }
}

// Where parts of a leaf have different values on one rank only, no rank undoes green cells.
TEST(PartitionsRedGreen, AllGoOnOrNone)
{
  const Mesh mesh = MakeMixedBox(8); // so that the last slab does not have the first cells
  NumberCells(mesh);
  AddFields(mesh);
  double chosen = -1.; // a cell with green parts, which are the same in the whole and in a part
  ExpectToGoOn(mesh, Choices[1], Choices[2],
    [&chosen](vtkPointSet* refined)
    {
      vtkDataArray* numbers = refined->GetCellData()->GetArray(CellName);
      vtkDataArray* parents = refined->GetCellData()->GetArray("GreenParent");
      vtkNew<vtkIntArray> different;
      different->SetName("Different");
      bool isFirst = true;
      for (vtkIdType c = 0; c < refined->GetNumberOfCells(); ++c)
      {
        const bool isGreen = parents->GetTuple1(c) >= 0.;
        chosen = isGreen && chosen < 0. ? numbers->GetTuple1(c) : chosen;
        const bool isHere = isFirst && isGreen && numbers->GetTuple1(c) == chosen;
        different->InsertNextValue(isHere ? 1 : 0);
        isFirst = isFirst && !isHere;
      }
      refined->GetCellData()->AddArray(different);
    });
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
    std::mutex mutex;
    std::set<std::string> warnings;
    options.Warn = [&](const std::string& message)
    {
      const std::lock_guard<std::mutex> lock(mutex);
      if (message.find("not refined") != std::string::npos)
      {
        warnings.insert(message);
      }
    };
    vtkIdType sizeOfFirst = 0;
    for (const Partition& partition : CommonPartitions)
    {
      SCOPED_TRACE(std::string(partition.Name) + ", " + choice.Name);
      std::vector<Mesh> outputs;
      warnings.clear();
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
      EXPECT_GE(1u, warnings.size());
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
    EXPECT_FALSE(RefineParts(
      Cut(mesh, CommonPartitions[1]), CommonPartitions[1], Choices[0], options, outputs));
  }
}
