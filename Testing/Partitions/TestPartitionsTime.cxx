// SPDX-License-Identifier: BSD-3-Clause
// Partitions whose values change while their cells stay: only values are sent again.
#include "PartitionTools.h"

#include "Private/Distribution/Distribution.h"
#include "Private/Distribution/KeptParts.h"
#include "Private/Uniform/UniformSubdivision.h"

using namespace partition_tools;
using namespace multi_dimensional_subdivision_tools;
using subdivision::Block;

namespace
{

constexpr int Parts = 3;

bool Subdivide(vtkPointSet* input, vtkPointSet* output)
{
  subdivision::UniformOptions options;
  options.Levels = 1;
  options.Warn = [](const std::string&) {};
  options.Fail = [](const std::string& message) { ADD_FAILURE() << message; };
  return SubdivideUniformly(input, options, vtkUnstructuredGrid::SafeDownCast(output));
}

struct Sent
{
  vtkIdType Messages;
  vtkIdType Bytes;
};

/// Moves one slab away from its neighbours, although it shares ids of points with them.
void MoveAway(vtkPointSet* slab)
{
  for (vtkIdType p = 0; p < slab->GetNumberOfPoints(); ++p)
  {
    const Point at = GetPoint(slab, p);
    slab->GetPoints()->SetPoint(p, at[0], at[1], at[2] + 10.);
  }
}

/// The numbers of points of the parts that outputs have, and the warnings.
struct Result
{
  std::vector<vtkIdType> Points;
  int Warnings;

  bool operator==(const Result& other) const
  {
    return this->Points == other.Points && this->Warnings == other.Warnings;
  }
};

Result Distribute(const std::vector<Mesh>& cut, subdivision::KeptParts& kept)
{
  std::vector<std::vector<Block>> blocks(cut.size());
  for (std::size_t i = 0; i < cut.size(); ++i)
  {
    Block block;
    block.Input = cut[i];
    block.Output = subdivision::MakeMesh(false);
    blocks[i].push_back(block);
  }
  subdivision::PartitionsOfRank partitions(nullptr, static_cast<int>(cut.size()));
  subdivision::DistributionOptions distribution;
  distribution.Kept = &kept;
  subdivision::RunOptions options;
  Result result{ {}, 0 };
  options.Warn = [&](const std::string&) { ++result.Warnings; };
  options.Fail = [](const std::string& message) { ADD_FAILURE() << message; };
  EXPECT_TRUE(RunPartitions(
    blocks, partitions, distribution, subdivision::FilterTraits(), options, Subdivide));
  for (const auto& own : blocks)
  {
    double bounds[6];
    own[0].Output->GetBounds(bounds);
    result.Points.push_back(own[0].Output->GetNumberOfPoints());
    result.Points.push_back(static_cast<vtkIdType>(1e6 * bounds[5]));
  }
  return result;
}

/// Subdivides parts of a mesh and compares them with the whole, if that has the same numbers of
/// points. Returns what was sent for that.
Sent Check(
  vtkPointSet* whole, const std::vector<int>& partOf, KnownBy known, subdivision::KeptParts& kept)
{
  std::vector<std::vector<Block>> blocks(Parts);
  const std::vector<Mesh> cut = Cut(whole, partOf, Parts, known);
  for (int i = 0; i < Parts; ++i)
  {
    Block block;
    block.Input = cut[i];
    block.Output = subdivision::MakeMesh(false);
    blocks[i].push_back(block);
  }
  subdivision::PartitionsOfRank partitions(nullptr, Parts);
  subdivision::DistributionOptions distribution;
  distribution.Kept = &kept;
  subdivision::RunOptions options;
  options.Warn = [](const std::string& message) { ADD_FAILURE() << message; };
  options.Fail = options.Warn;
  EXPECT_TRUE(RunPartitions(
    blocks, partitions, distribution, subdivision::FilterTraits(), options, Subdivide));
  std::vector<Mesh> outputs;
  for (const auto& own : blocks)
  {
    outputs.push_back(own[0].Output);
  }
  if (known == KnownBy::GlobalIds)
  {
    const Mesh expected = subdivision::MakeMesh(false);
    EXPECT_TRUE(Subdivide(whole, expected));
    ExpectWhole(expected, outputs);
  }
  return { partitions.GetNumberOfMessages(), partitions.GetNumberOfBytes() };
}

Mesh MakeMesh()
{
  const Mesh mesh = MakeMixedBox(4);
  AddArrays(vtkUnstructuredGrid::SafeDownCast(mesh));
  NumberCells(mesh);
  return mesh;
}

void Move(vtkPointSet* mesh)
{
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    const Point at = GetPoint(mesh, p);
    mesh->GetPoints()->SetPoint(p, at[0] + 0.1 * std::sin(at[1]), at[1], 1.1 * at[2]);
  }
}

void ChangeValues(vtkPointSet* mesh)
{
  vtkDataArray* first = mesh->GetPointData()->GetArray(0);
  for (vtkIdType i = 0; i < first->GetNumberOfTuples(); ++i)
  {
    first->SetComponent(i, 0, first->GetComponent(i, 0) + static_cast<double>(i % 5));
  }
}

}

TEST(PartitionsTime, OnlyValuesAreSentAgain)
{
  const Mesh mesh = MakeMesh();
  const std::vector<int> partOf = CutInSlabs(mesh, Parts);
  subdivision::KeptParts kept;
  const Sent first = Check(mesh, partOf, KnownBy::GlobalIds, kept);
  ChangeValues(mesh);
  Move(mesh);
  const Sent second = Check(mesh, partOf, KnownBy::GlobalIds, kept);
  // Each slab has one or two neighbours, and two layers reach no farther.
  EXPECT_GE(2 * (Parts - 1) + 2, second.Messages);
  EXPECT_GT(10 * first.Bytes, 13 * second.Bytes); // with ten arrays values are most of it
}

TEST(PartitionsTime, PointsOfOneIdThatPartAreApart)
{
  const Mesh mesh = MakeMesh();
  const std::vector<int> partOf = CutInSlabs(mesh, Parts);
  const std::vector<Mesh> together = Cut(mesh, partOf, Parts, KnownBy::GlobalIds);
  std::vector<Mesh> apart = Cut(mesh, partOf, Parts, KnownBy::GlobalIds);
  MoveAway(apart[0]);
  subdivision::KeptParts none;
  const Result expected = Distribute(apart, none);
  subdivision::KeptParts kept;
  const Result first = Distribute(together, kept);
  EXPECT_EQ(first.Warnings, 0);
  EXPECT_GT(expected.Warnings, 0); // of the partitions that look after the ids
  EXPECT_TRUE(Distribute(apart, kept) == expected);
  EXPECT_TRUE(Distribute(together, kept) == first); // and back again
}

TEST(PartitionsTime, PartsMayDisagreeOnTheTypeOfAnArray)
{
  // The array of one part has another type: there and in the others it keeps what it was, and all
  // else is that of the whole.
  const Mesh mesh = MakeMesh();
  const std::vector<Mesh> cut = Cut(mesh, CutInSlabs(mesh, Parts), Parts, KnownBy::GlobalIds);
  constexpr const char* name = "Disagrees";
  for (int i = 0; i < Parts; ++i)
  {
    const auto array = vtkSmartPointer<vtkDataArray>::Take(
      vtkDataArray::CreateDataArray(i == 1 ? VTK_DOUBLE : VTK_INT));
    array->SetName(name);
    array->SetNumberOfTuples(cut[i]->GetNumberOfCells());
    array->Fill(i + 0.5);
    cut[i]->GetCellData()->AddArray(array);
  }
  const Partition partition = { "slabs", Parts, 1, false, KnownBy::GlobalIds, 0 };
  subdivision::RunOptions options;
  options.Warn = [](const std::string& message) { ADD_FAILURE() << message; };
  options.Fail = options.Warn;
  std::vector<Mesh> outputs;
  ASSERT_TRUE(RunOnParts(
    cut, partition, subdivision::DistributionOptions(), options,
    [](vtkPointSet* input, vtkPointSet* output) { return Subdivide(input, output); }, outputs));
  for (int i = 0; i < Parts; ++i)
  {
    vtkDataArray* array = outputs[i]->GetCellData()->GetArray(name);
    ASSERT_TRUE(array);
    EXPECT_EQ(i == 1 ? VTK_DOUBLE : VTK_INT, array->GetDataType());
    for (vtkIdType c = 0; c < array->GetNumberOfTuples(); ++c)
    {
      ASSERT_EQ(i == 1 ? 1.5 : i, array->GetTuple1(c));
    }
    outputs[i]->GetCellData()->RemoveArray(name);
  }
  const Mesh expected = subdivision::MakeMesh(false);
  ASSERT_TRUE(Subdivide(mesh, expected));
  ExpectWhole(expected, outputs);
}

TEST(PartitionsTime, CoordinatesThatAreIdsMakeAllNew)
{
  const Mesh mesh = MakeMesh();
  const std::vector<int> partOf = CutInSlabs(mesh, Parts);
  subdivision::KeptParts kept;
  const Sent first = Check(mesh, partOf, KnownBy::Coordinates, kept);
  ChangeValues(mesh);
  EXPECT_GT(10 * first.Bytes, 13 * Check(mesh, partOf, KnownBy::Coordinates, kept).Bytes);
  Move(mesh); // which part knows about a point follows from its coordinates
  subdivision::KeptParts none;
  const Sent afresh = Check(mesh, partOf, KnownBy::Coordinates, none);
  EXPECT_EQ(afresh.Bytes, Check(mesh, partOf, KnownBy::Coordinates, kept).Bytes);
}

TEST(PartitionsTime, CellsThatChangeOnOneRankMakeAllNew)
{
  const Mesh mesh = MakeMesh();
  const std::vector<int> partOf = CutInSlabs(mesh, Parts);
  subdivision::KeptParts kept;
  Check(mesh, partOf, KnownBy::GlobalIds, kept);
  const Mesh less = subdivision::MakeMesh(false);
  less->DeepCopy(mesh);
  vtkNew<vtkIdList> ids;
  less->GetCellPoints(0, ids);
  std::vector<vtkIdType> turned(ids->begin(), ids->end());
  std::swap(turned[0], turned[1]);
  vtkUnstructuredGrid::SafeDownCast(less)->GetCells()->ReplaceCellAtId(
    0, static_cast<vtkIdType>(turned.size()), turned.data());
  Check(less, partOf, KnownBy::GlobalIds, kept);
  // An array more, too.
  vtkNew<vtkDoubleArray> more;
  more->SetName("More");
  more->SetNumberOfValues(less->GetNumberOfPoints());
  more->FillValue(1.5);
  less->GetPointData()->AddArray(more);
  Check(less, partOf, KnownBy::GlobalIds, kept);
}
