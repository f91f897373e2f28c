// SPDX-License-Identifier: BSD-3-Clause
// The simplices of partitions, simulated in one process, are those of the whole mesh, each once,
// and so are their numbers.
#include "PartitionTools.h"

#include "Private/Topology/TopologyProbe.h"

using namespace partition_tools;
using namespace multi_dimensional_subdivision_tools;

namespace
{

const Partition Partitions[] = { { "halves", 2, 1, false },
  { "three slabs", 3, 2, false, KnownBy::GlobalIds, 1 }, { "cell by cell", 3, 1, true },
  { "cell by cell on many", 8, 1, true }, { "one has all", 1, 1, false, KnownBy::GlobalIds, 2 } };

/// The simplices, by the places of their points, and how often each is there.
void AddSimplices(vtkPointSet* mesh, std::map<std::vector<Point>, int>& simplices)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
  {
    mesh->GetCellPoints(c, ids);
    std::vector<Point> corners;
    for (const vtkIdType id : *ids)
    {
      corners.push_back(GetPoint(mesh, id));
    }
    ++simplices[corners];
  }
}

void CheckPartitions(const Mesh& mesh, bool specialOnly = false)
{
  subdivision::ProbeOptions options;
  options.Warn = [](const std::string&) {};
  options.Fail = [](const std::string& message) { ADD_FAILURE() << message; };
  options.GenerateGlobalIds = true;
  options.SpecialOnly = specialOnly;
  const auto whole = Grid::New();
  ASSERT_TRUE(ProbeTopology(mesh, options, whole));
  std::map<std::vector<Point>, int> simplices;
  AddSimplices(whole, simplices);
  for (const Partition& partition : Partitions)
  {
    SCOPED_TRACE(partition.Name);
    subdivision::DistributionOptions distribution;
    subdivision::ProbeOptions own = options;
    std::vector<Mesh> outputs;
    EXPECT_TRUE(RunOnParts(
      Cut(mesh, partition), partition, distribution, own,
      [&own](vtkPointSet* input, vtkPointSet* output)
      { return ProbeTopology(input, own, vtkUnstructuredGrid::SafeDownCast(output)); }, outputs));
    std::map<std::vector<Point>, int> found;
    for (const Mesh& output : outputs)
    {
      AddSimplices(output, found);
      for (const char* name : { "SimplexCounts", "EulerCharacteristic", "ManifoldComponents" })
      {
        EXPECT_EQ(std::string(),
          CompareValues(whole->GetFieldData()->GetAbstractArray(name),
            output->GetFieldData()->GetAbstractArray(name)))
          << name;
      }
    }
    EXPECT_TRUE(simplices == found);
    ExpectIndices(whole, outputs);
  }
}

}

TEST(PartitionsTopology, HaveTheNumbersOfTheWhole)
{
  for (const Mesh& mesh : MakeMeshes())
  {
    SCOPED_TRACE("mesh of " + std::to_string(mesh->GetNumberOfCells()) + " cells");
    CheckPartitions(mesh);
    CheckPartitions(mesh, true);
  }
}

// Components that reach through many partitions, and some that meet in a vertex only.
TEST(PartitionsTopology, CountComponents)
{
  std::mt19937 chance(4);
  for (int run = 0; run < 20; ++run)
  {
    std::vector<Point> points;
    std::vector<Cell> cells;
    for (int i = 0; i < 60; ++i)
    {
      points.push_back({ i % 10 + chance() * 1e-11, i / 10 + chance() * 1e-11, chance() * 1e-9 });
    }
    for (int i = 0; i < 40; ++i)
    {
      const int types[] = { VTK_VERTEX, VTK_LINE, VTK_TRIANGLE, VTK_TETRA };
      const unsigned type = chance() % 4;
      const unsigned first = chance() % 57;
      Cell cell{ types[type], {} };
      for (unsigned k = 0; k <= type; ++k)
      {
        cell.Points.push_back(first + k);
      }
      cells.push_back(cell);
    }
    const Mesh mesh = MakeGrid(points, cells);
    NumberCells(mesh);
    SCOPED_TRACE("run " + std::to_string(run));
    CheckPartitions(mesh);
  }
}
