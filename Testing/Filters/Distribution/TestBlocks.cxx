// SPDX-License-Identifier: BSD-3-Clause
// Blocks of a composite data set that share points are one mesh.
#include "FeatureTools.h"
#include "PartitionTools.h"
#include "SelectionTools.h"

#include "vtkAdaptiveSurfaceSubdivision.h"
#include "vtkCell.h"
#include "vtkInformation.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkRedGreenRefinement.h"
#include "vtkSimplicialComplexTopology.h"
#include "vtkSubdivisionDeformation.h"
#include "vtkSurfaceSubdivision.h"
#include "vtkTable.h"

using namespace partition_tools;
using namespace multi_dimensional_subdivision_tools;

namespace
{

Grid MakeBox(int n)
{
  const Grid box = MakeMixedBox(n);
  AddArrays(box);
  NumberCells(box);
  return box;
}

template <typename Filter>
vtkSmartPointer<vtkDataObject> RunFilterOn(Filter* filter, vtkDataObject* input)
{
  UpdateInSilence(filter, input, nullptr, { "rest mesh" }); // of the deformed box
  return filter->GetOutputDataObject(0);
}

/// The blocks of a mesh give what the whole gives, by a filter that `make` makes.
template <typename Make>
void ExpectBlocksAreWhole(vtkPointSet* mesh, const Make& make)
{
  const std::vector<Mesh> cut = Cut(mesh, CutByChance(mesh, 4, 5), 4, KnownBy::GlobalIds);
  const auto whole = RunFilterOn(make().Get(), mesh);
  const auto parts = RunFilterOn(make().Get(), MakeBlocks(cut));
  ExpectWhole(vtkPointSet::SafeDownCast(whole), GetMeshes(parts));
}

vtkSmartPointer<vtkMultiDimensionalSubdivision> MakeUniform(int levels)
{
  auto filter = vtkSmartPointer<vtkMultiDimensionalSubdivision>::New();
  filter->SetVolumeSchemeToBoxSpline();
  filter->SetNumberOfLevels(levels);
  return filter;
}

}

TEST(Blocks, AreOneMeshForEveryFilter)
{
  const Grid box = MakeBox(2);
  ExpectBlocksAreWhole(box, [] { return MakeUniform(2); });
  ExpectBlocksAreWhole(box,
    []
    {
      auto filter = MakeUniform(1);
      filter->InterpolatePointsOn();
      return filter;
    });
  for (const bool limit : { false, true })
  {
    ExpectBlocksAreWhole(box,
      [limit]
      {
        auto filter = vtkSmartPointer<vtkRedGreenRefinement>::New();
        filter->RefineByAttributeErrorOff();
        filter->RefineByEdgeLengthOn();
        filter->SetMaximumEdgeLength(0.4);
        filter->SetPlacement(limit);
        return filter;
      });
  }
  const Mesh skin = MakeSkin(box);
  ExpectBlocksAreWhole(skin, [] { return vtkSmartPointer<vtkSurfaceSubdivision>::New(); });
  ExpectBlocksAreWhole(skin,
    []
    {
      auto filter = vtkSmartPointer<vtkAdaptiveSurfaceSubdivision>::New();
      filter->RefineByAttributeErrorOff();
      filter->RefineByGeometricErrorOff();
      filter->RefineByEdgeLengthOn();
      filter->SetMaximumEdgeLength(0.4);
      return filter;
    });
}

TEST(Blocks, HaveTheMarksOfTheWhole)
{
  const Grid box = MakeBox(2);
  vtkNew<vtkIntArray> marks;
  marks->SetName("Marks");
  std::vector<vtkIdType> ids;
  vtkNew<vtkIdTypeArray> numbers; // those of the blocks
  numbers->SetName("Numbers");
  vtkNew<vtkPolyData> lines;
  lines->SetPoints(box->GetPoints());
  vtkNew<vtkCellArray> cells;
  for (vtkIdType p = 0; p < box->GetNumberOfPoints(); ++p)
  {
    marks->InsertNextValue(p % 3 > 0);
    numbers->InsertNextValue(p);
    if (p % 3 > 0)
    {
      ids.push_back(p);
    }
  }
  box->GetPointData()->AddArray(marks);
  box->GetPointData()->SetGlobalIds(numbers);
  for (vtkIdType c = 0; c < box->GetNumberOfCells(); ++c)
  {
    vtkCell* cell = box->GetCell(c);
    if (cell->GetNumberOfEdges() > 0 && c % 2 == 0)
    {
      cells->InsertNextCell(cell->GetEdge(0)->GetPointIds());
    }
  }
  lines->SetLines(cells);
  ASSERT_GT(lines->GetNumberOfCells(), 3);
  const auto selection =
    selection_tools::MakeSelection(vtkSelectionNode::POINT, vtkSelectionNode::GLOBALIDS, ids);
  for (const int kind : { 0, 1, 2 })
  {
    SCOPED_TRACE(kind);
    ExpectBlocksAreWhole(box,
      [&]
      {
        auto filter = MakeUniform(2);
        filter->SetMarkCreases(true);
        filter->SetMarkSurfaces(true);
        if (kind == 0)
        {
          filter->SetInputArrayToProcess(8, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Marks");
        }
        if (kind > 0)
        {
          filter->SetInputDataObject(
            kind, kind == 1 ? static_cast<vtkDataObject*>(selection.Get()) : lines);
        }
        return filter;
      });
  }
}

TEST(Blocks, FiltersInARowAreOne)
{
  const Grid box = MakeBox(2);
  const std::vector<Mesh> cut = Cut(box, CutInSlabs(box, 3), 3, KnownBy::GlobalIds);
  const auto once = RunFilterOn(MakeUniform(3).Get(), box);
  vtkSmartPointer<vtkDataObject> blocks = MakeBlocks(cut);
  for (int i = 0; i < 3; ++i)
  {
    blocks = RunFilterOn(MakeUniform(1).Get(), blocks);
  }
  ExpectWhole(vtkPointSet::SafeDownCast(once), GetMeshes(blocks));
}

TEST(Blocks, OneThatIsTheWholeOutputGoesOn)
{
  const Grid box = MakeBox(2);
  const auto once = RunFilterOn(MakeUniform(2).Get(), box);
  const auto first = RunFilterOn(MakeUniform(1).Get(), box);
  auto filter = MakeUniform(1);
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetInputDataObject(MakeBlocks({ vtkPointSet::SafeDownCast(first) }));
  filter->Update();
  EXPECT_TRUE(messages->Warnings.empty());
  ExpectWhole(vtkPointSet::SafeDownCast(once), GetMeshes(filter->GetOutputDataObject(0)));
}

TEST(Blocks, ThatDoNotGoOnAreSaid)
{
  // One of two blocks of an earlier output, and blocks that were subdivided each by itself.
  const Grid box = MakeBox(2);
  const std::vector<Mesh> cut = Cut(box, CutInSlabs(box, 2), 2, KnownBy::GlobalIds);
  const std::vector<Mesh> together = GetMeshes(RunFilterOn(MakeUniform(1).Get(), MakeBlocks(cut)));
  auto alone = MakeUniform(1);
  alone->JoinBlocksOff();
  const std::vector<Mesh> apart = GetMeshes(RunFilterOn(alone.Get(), MakeBlocks(cut)));
  for (const std::vector<Mesh>& meshes : { std::vector<Mesh>{ together[1] }, apart })
  {
    auto filter = MakeUniform(1);
    vtkNew<Messages> messages;
    messages->Watch(filter);
    filter->SetInputDataObject(MakeBlocks(meshes));
    filter->Update();
    EXPECT_EQ(1, messages->CountWarnings("Earlier filters made the blocks"));
  }
}

TEST(Blocks, StructureNamesAndFieldDataAreKept)
{
  const Grid box = MakeBox(2);
  const std::vector<Mesh> cut = Cut(box, CutInSlabs(box, 3), 3, KnownBy::Coordinates);
  vtkNew<vtkDoubleArray> time;
  time->SetName("Time");
  time->InsertNextValue(3.);
  cut[1]->GetFieldData()->AddArray(time);
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, cut[0]);
  inner->SetBlock(2, cut[1]);
  inner->GetMetaData(2u)->Set(vtkCompositeDataSet::NAME(), "rock");
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(1, inner);
  blocks->SetBlock(2, cut[2]);
  vtkNew<vtkIntArray> run;
  run->SetName("Run");
  run->InsertNextValue(7);
  blocks->GetFieldData()->AddArray(run);

  const auto output = RunFilterOn(MakeUniform(1).Get(), blocks);
  auto* all = vtkMultiBlockDataSet::SafeDownCast(output);
  ASSERT_TRUE(all);
  EXPECT_EQ(3u, all->GetNumberOfBlocks());
  EXPECT_FALSE(all->GetBlock(0));
  EXPECT_TRUE(all->GetFieldData()->HasArray("Run"));
  auto* innerOutput = vtkMultiBlockDataSet::SafeDownCast(all->GetBlock(1));
  ASSERT_TRUE(innerOutput);
  EXPECT_EQ(3u, innerOutput->GetNumberOfBlocks());
  EXPECT_STREQ("rock", innerOutput->GetMetaData(2u)->Get(vtkCompositeDataSet::NAME()));
  EXPECT_TRUE(innerOutput->GetBlock(2)->GetFieldData()->HasArray("Time"));
  EXPECT_FALSE(innerOutput->GetBlock(0)->GetFieldData()->HasArray("Time"));
  EXPECT_EQ(3u, GetMeshes(all).size());
}

TEST(Blocks, OfPartitionedCollections)
{
  const Grid box = MakeBox(2);
  const std::vector<Mesh> cut = Cut(box, CutByChance(box, 3, 1), 3, KnownBy::GlobalIds);
  vtkNew<vtkPartitionedDataSet> first;
  first->SetPartition(0, cut[0]);
  first->SetPartition(1, cut[1]);
  vtkNew<vtkPartitionedDataSet> second;
  second->SetPartition(0, cut[2]);
  vtkNew<vtkPartitionedDataSetCollection> all;
  all->SetPartitionedDataSet(0, first);
  all->SetPartitionedDataSet(1, second);
  const auto whole = RunFilterOn(MakeUniform(1).Get(), box);
  const auto output = RunFilterOn(MakeUniform(1).Get(), all);
  EXPECT_TRUE(vtkPartitionedDataSetCollection::SafeDownCast(output));
  ExpectWhole(vtkPointSet::SafeDownCast(whole), GetMeshes(output));
}

TEST(Blocks, KeepArraysThatOthersDoNotHave)
{
  const Grid box = MakeMixedBox(2);
  const std::vector<Mesh> cut = Cut(box, CutInSlabs(box, 2), 2, KnownBy::GlobalIds);
  auto constant = MakeArray<vtkDoubleArray>("Only", 2, cut[0]->GetNumberOfPoints(), 0., 0., 1);
  constant->Fill(5.);
  cut[0]->GetPointData()->AddArray(constant);
  // The same name, another type.
  cut[0]->GetCellData()->AddArray(
    MakeArray<vtkDoubleArray>("Both", 1, cut[0]->GetNumberOfCells(), 0., 1., 1));
  cut[1]->GetCellData()->AddArray(
    MakeArray<vtkIntArray>("Both", 1, cut[1]->GetNumberOfCells(), 0., 9., 1));
  const std::vector<Mesh> leaves = GetMeshes(RunFilterOn(MakeUniform(2).Get(), MakeBlocks(cut)));
  ASSERT_EQ(2u, leaves.size());
  vtkDataArray* only = leaves[0]->GetPointData()->GetArray("Only");
  ASSERT_TRUE(only);
  EXPECT_FALSE(leaves[1]->GetPointData()->HasArray("Only"));
  for (int c = 0; c < 2; ++c) // up to the border of the block
  {
    EXPECT_NEAR(5., only->GetRange(c)[0], 1e-12);
    EXPECT_NEAR(5., only->GetRange(c)[1], 1e-12);
  }
  EXPECT_EQ(VTK_DOUBLE, leaves[0]->GetCellData()->GetArray("Both")->GetDataType());
  EXPECT_EQ(VTK_INT, leaves[1]->GetCellData()->GetArray("Both")->GetDataType());
}

TEST(Blocks, AreMaterials)
{
  // Two blocks without a material array: PreserveInterfaces keeps the face between them.
  const Grid box = MakeMixedBox(2);
  const std::vector<int> slabs = CutInSlabs(box, 2);
  NumberCells(box);
  const std::vector<Mesh> cut = Cut(box, slabs, 2, KnownBy::GlobalIds);
  auto filter = MakeUniform(2);
  filter->PreserveInterfacesOn();
  const std::vector<Mesh> parts = GetMeshes(RunFilterOn(filter.Get(), MakeBlocks(cut)));
  vtkNew<vtkIntArray> materials;
  materials->SetName("MaterialId");
  for (const int slab : slabs)
  {
    materials->InsertNextValue(slab);
  }
  box->GetCellData()->AddArray(materials);
  auto serial = MakeUniform(2);
  serial->PreserveInterfacesOn();
  const auto whole = RunFilterOn(serial.Get(), box);
  vtkPointSet::SafeDownCast(whole)->GetCellData()->RemoveArray("MaterialId");
  ExpectWhole(vtkPointSet::SafeDownCast(whole), parts);
}

TEST(Blocks, OriginalIdsCountInTheBlock)
{
  const Grid box = MakeMixedBox(2);
  const std::vector<Mesh> cut = Cut(box, CutInSlabs(box, 2), 2, KnownBy::GlobalIds);
  auto filter = MakeUniform(1);
  filter->GenerateOriginalIdsOn();
  const std::vector<Mesh> leaves = GetMeshes(RunFilterOn(filter.Get(), MakeBlocks(cut)));
  for (size_t b = 0; b < 2; ++b)
  {
    vtkDataArray* cells = leaves[b]->GetCellData()->GetArray("vtkOriginalCellIds");
    EXPECT_EQ(0., cells->GetRange()[0]);
    EXPECT_EQ(static_cast<double>(cut[b]->GetNumberOfCells() - 1), cells->GetRange()[1]);
    vtkDataArray* points = leaves[b]->GetPointData()->GetArray("vtkOriginalPointIds");
    std::set<double> found;
    for (vtkIdType i = 0; i < points->GetNumberOfTuples(); ++i)
    {
      found.insert(points->GetTuple1(i));
    }
    found.erase(-1.);
    EXPECT_EQ(static_cast<size_t>(cut[b]->GetNumberOfPoints()), found.size());
  }
}

TEST(Blocks, GhostCellsAreLeftOut)
{
  const Grid box = MakeBox(2);
  const std::vector<int> slabs = CutInSlabs(box, 2);
  // Each block has all cells; those of the other are duplicates.
  std::vector<Mesh> cut;
  for (int b = 0; b < 2; ++b)
  {
    const Grid block = DeepCopy(box);
    AddGlobalIds(block, 3);
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    for (const int slab : slabs)
    {
      ghosts->InsertNextValue(slab == b ? 0 : vtkDataSetAttributes::DUPLICATECELL);
    }
    block->GetCellData()->AddArray(ghosts);
    cut.push_back(block);
  }
  const Grid ids = DeepCopy(box);
  AddGlobalIds(ids, 3);
  const std::vector<Mesh> leaves = GetMeshes(RunFilterOn(MakeUniform(1).Get(), MakeBlocks(cut)));
  vtkIdType cells = 0;
  for (const Mesh& leaf : leaves)
  {
    cells += leaf->GetNumberOfCells();
  }
  EXPECT_EQ(
    vtkPointSet::SafeDownCast(RunFilterOn(MakeUniform(1).Get(), box))->GetNumberOfCells(), cells);
}

TEST(Blocks, DoubledPointsStayApartAndAreSaid)
{
  // A block with two points at a place where another block has one.
  const Grid first = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 2, 0, 0 } },
    { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_LINE, { 3, 4 } } });
  const Grid second =
    MakeGrid({ { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } }, { { VTK_TRIANGLE, { 0, 2, 1 } } });
  vtkNew<Messages> messages;
  auto filter = MakeUniform(1);
  messages->Watch(filter);
  filter->SetInputDataObject(MakeBlocks({ first, second }));
  filter->Update();
  EXPECT_EQ(1, messages->CountWarnings("several points with the same"));
  EXPECT_EQ(2u, GetMeshes(filter->GetOutputDataObject(0)).size());
}

TEST(Blocks, OfOtherTypesAreSaid)
{
  const Grid box = MakeBox(1);
  vtkNew<Messages> messages;
  vtkNew<vtkSurfaceSubdivision> filter;
  messages->Watch(filter);
  const auto blocks = MakeBlocks({ box, MakeSkin(box) });
  blocks->SetBlock(0, vtkNew<vtkTable>());
  filter->SetInputDataObject(blocks);
  filter->Update();
  EXPECT_EQ(1, messages->CountWarnings("is a vtkTable"));
  const std::vector<Mesh> leaves = GetMeshes(filter->GetOutputDataObject(0));
  ASSERT_EQ(2u, leaves.size());
  EXPECT_EQ(0, leaves[0]->GetNumberOfCells());
  EXPECT_LT(0, leaves[1]->GetNumberOfCells());
}

TEST(Blocks, AreOneControlMeshOfADeformation)
{
  const Grid cage = MakeMixedBox(2);
  const Grid moved = DeepCopy(cage);
  for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
  {
    const Point at = GetPoint(moved, i);
    moved->GetPoints()->SetPoint(i, at[0] + 0.1 * at[1] * at[2], at[1], at[2] + 0.1 * at[0]);
  }
  const Grid inner = Grid::New();
  inner->DeepCopy(vtkPointSet::SafeDownCast(RunFilterOn(MakeUniform(1).Get(), cage)));
  NumberCells(inner);
  const std::vector<int> chance = CutByChance(cage, 3, 2);
  auto deform = [&](vtkDataObject* rest, vtkDataObject* deformed, vtkDataObject* points)
  {
    vtkNew<vtkSubdivisionDeformation> filter;
    filter->SetRestMeshData(rest);
    filter->SetDeformedMeshData(deformed);
    filter->SetOutsidePointsToNearest();
    return RunFilterOn(filter.Get(), points);
  };
  const auto whole = deform(cage, moved, inner);
  const std::vector<Mesh> parts = Cut(inner, CutInSlabs(inner, 2), 2, KnownBy::Coordinates);
  const auto blocks = deform(MakeBlocks(Cut(cage, chance, 3, KnownBy::GlobalIds)),
    MakeBlocks(Cut(moved, chance, 3, KnownBy::GlobalIds)), MakeBlocks(parts));
  ExpectWhole(vtkPointSet::SafeDownCast(whole), GetMeshes(blocks));
}

TEST(Blocks, HaveTheSimplicesOfTheirFirstCells)
{
  const std::vector<Point> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } };
  const Grid both =
    MakeGrid(points, { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 1, 3, 2 } } });
  vtkNew<vtkSimplicialComplexTopology> filter;
  const std::vector<Mesh> leaves =
    GetMeshes(RunFilterOn(filter.Get(), MakeBlocks(Cut(both, { 0, 1 }, 2, KnownBy::GlobalIds))));
  ASSERT_EQ(2u, leaves.size());
  EXPECT_EQ(7, leaves[0]->GetNumberOfCells()); // with the edge and vertices between the blocks
  EXPECT_EQ(4, leaves[1]->GetNumberOfCells());
}

TEST(Blocks, AreOneComplex)
{
  const Grid box = MakeMixedBox(2);
  const std::vector<Mesh> cut = Cut(box, CutByChance(box, 3, 2), 3, KnownBy::GlobalIds);
  vtkNew<vtkSimplicialComplexTopology> serial;
  const auto output = RunFilterOn(serial.Get(), box);
  auto* whole = vtkPointSet::SafeDownCast(output);
  vtkNew<vtkSimplicialComplexTopology> filter;
  const std::vector<Mesh> leaves = GetMeshes(RunFilterOn(filter.Get(), MakeBlocks(cut)));
  // Each simplex is there once, with the same facts: told by the sums of their numbers.
  vtkIdType cells = 0;
  for (const char* name : { "Boundary", "NonManifoldType", "Valence", "ManifoldDimensions" })
  {
    double sums[2] = {};
    auto add = [name](vtkPointSet* mesh, double& sum)
    {
      vtkDataArray* values = mesh->GetCellData()->GetArray(name);
      ASSERT_TRUE(values);
      for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
      {
        sum += values->GetTuple1(i);
      }
    };
    add(whole, sums[0]);
    for (const Mesh& leaf : leaves)
    {
      add(leaf, sums[1]);
    }
    EXPECT_EQ(sums[0], sums[1]) << name;
  }
  for (const Mesh& leaf : leaves)
  {
    cells += leaf->GetNumberOfCells();
    EXPECT_EQ(std::string(),
      CompareValues(whole->GetFieldData()->GetAbstractArray("SimplexCounts"),
        leaf->GetFieldData()->GetAbstractArray("SimplexCounts")));
  }
  EXPECT_EQ(whole->GetNumberOfCells(), cells);
}

namespace
{

/// Refines the cells of `input` that are listed, in the block of a composite index (0: no blocks).
vtkSmartPointer<vtkDataObject> RefineSelected(
  vtkDataObject* input, const std::vector<vtkIdType>& cells, int compositeIndex)
{
  const auto selection = selection_tools::MakeSelection(vtkSelectionNode::CELL, cells);
  if (compositeIndex > 0)
  {
    selection->GetNode(0u)->GetProperties()->Set(
      vtkSelectionNode::COMPOSITE_INDEX(), compositeIndex);
  }
  vtkNew<vtkRedGreenRefinement> filter;
  filter->RefineByAttributeErrorOff();
  filter->SetMaximumLevel(2);
  selection_tools::RefineBy(filter, selection);
  return RunFilterOn(filter.Get(), input);
}

}

TEST(Blocks, ASelectionInABlockIsFoundInTheWhole)
{
  const Grid box = MakeBox(3);
  const std::vector<int> slabs = CutInSlabs(box, 2);
  const std::vector<Mesh> cut = Cut(box, slabs, 2, KnownBy::GlobalIds);
  // The first five cells of the second block, and what they are in the whole.
  std::vector<vtkIdType> ofWhole;
  for (size_t c = 0; c < slabs.size() && ofWhole.size() < 5; ++c)
  {
    if (slabs[c] == 1)
    {
      ofWhole.push_back(static_cast<vtkIdType>(c));
    }
  }
  const auto whole = RefineSelected(box, ofWhole, 0);
  const auto parts = RefineSelected(MakeBlocks(cut), { 0, 1, 2, 3, 4 }, 2);
  EXPECT_LT(box->GetNumberOfCells(), vtkPointSet::SafeDownCast(whole)->GetNumberOfCells());
  ExpectWhole(vtkPointSet::SafeDownCast(whole), GetMeshes(parts));
}
