// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestBlockCases.cxx
 * Blocks that are not parts of one object: cases of one mesh, objects with ids of their own, and
 * neighbours whose values differ.
 */
#include "MultiDimensionalSubdivisionTools.h"

#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkRedGreenRefinement.h"
#include "vtkStringArray.h"
#include "vtkSurfaceSubdivision.h"
#include "vtkTypeInt32Array.h"
#include "vtkUnsignedLongLongArray.h"

using namespace multi_dimensional_subdivision_tools;
using Filter = vtkMultiDimensionalSubdivision;

namespace
{

/// Tetrahedra around the edge from point 0 to 1, of which each has two of the others; `first` is
/// the first of these, and `count` how many there are.
Grid MakeFan(int first, int count, double value)
{
  std::vector<Point> points = { { 0, 0, 0 }, { 0, 0, 1 } };
  std::vector<Cell> cells;
  for (int i = 0; i <= count; ++i)
  {
    const double angle = 0.5 * (first + i);
    points.push_back({ std::cos(angle), std::sin(angle), 0.1 * (first + i) });
    if (i > 0)
    {
      cells.push_back({ VTK_TETRA, { 0, i + 1, i + 2, 1 } });
    }
  }
  const Grid grid = MakeGrid(points, cells);
  vtkNew<vtkDoubleArray> values;
  values->SetName("T");
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    values->InsertNextValue(value);
  }
  grid->GetPointData()->SetScalars(values);
  return grid;
}

using Blocks = vtkSmartPointer<vtkMultiBlockDataSet>;

template <typename FilterClass>
std::vector<Grid> RunOn(FilterClass* filter, vtkDataObject* input, Messages* messages)
{
  messages->Watch(filter);
  filter->SetInputDataObject(input);
  filter->Update();
  EXPECT_TRUE(messages->Errors.empty());
  std::vector<Grid> outputs;
  for (const auto& leaf : GetMeshes(filter->GetOutputDataObject(0)))
  {
    const auto copy = Grid::New();
    copy->DeepCopy(leaf);
    outputs.push_back(copy);
  }
  return outputs;
}

std::vector<Grid> RunOn(vtkDataObject* input, int levels, Messages* messages)
{
  vtkNew<Filter> filter;
  filter->SetNumberOfLevels(levels);
  return RunOn(filter.Get(), input, messages);
}

void ExpectConstant(vtkPointSet* grid, const char* name, double value)
{
  vtkDataArray* array = grid->GetPointData()->GetArray(name);
  ASSERT_TRUE(array);
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    ASSERT_NEAR(array->GetComponent(p, 0), value, 1e-12 * std::abs(value)) << "point " << p;
  }
}

/// A block is as if it were the only one.
void ExpectAlone(const Grid& output, const Grid& input, int levels)
{
  const Grid alone = Subdivide(input, levels);
  ASSERT_EQ(output->GetNumberOfPoints(), alone->GetNumberOfPoints());
  ASSERT_EQ(GetCells(output), GetCells(alone));
  for (vtkIdType p = 0; p < alone->GetNumberOfPoints(); ++p)
  {
    for (int c = 0; c < 3; ++c)
    {
      ASSERT_NEAR(GetPoint(output, p)[c], GetPoint(alone, p)[c], 1e-12);
    }
  }
}

template <typename Ids>
void SetIds(vtkPointSet* grid, typename Ids::ValueType first)
{
  vtkNew<Ids> ids;
  ids->SetName("GlobalNodeId");
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    ids->InsertNextValue(first + static_cast<typename Ids::ValueType>(p));
  }
  grid->GetPointData()->SetGlobalIds(ids);
}

void Move(vtkPointSet* grid, double x)
{
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    const Point at = GetPoint(grid, p);
    grid->GetPoints()->SetPoint(p, at[0] + x, at[1], at[2]);
  }
}

}

TEST(BlockCases, CasesOfOneMeshHaveTheirOwnValues)
{
  for (const int levels : { 0, 1, 2 })
  {
    const std::vector<Grid> cases = { MakeFan(0, 3, 300.), MakeFan(0, 3, 450.),
      MakeFan(0, 3, 600.) };
    vtkNew<Messages> messages;
    const auto outputs = RunOn(MakeBlocks(cases), levels, messages);
    ASSERT_EQ(outputs.size(), 3u);
    for (int i = 0; i < 3; ++i)
    {
      ExpectAlone(outputs[i], cases[i], levels);
      ExpectConstant(outputs[i], "T", 300. + 150. * i);
    }
    EXPECT_EQ(messages->CountWarnings("cells in common"), 1);
    EXPECT_EQ(messages->Warnings.size(), 1u);
    EXPECT_EQ(messages->CountWarnings("by up to 300 in the point array \"T\" (blocks 1 and 3)"), 1);
  }
}

TEST(BlockCases, CasesWithOtherCellsToo)
{
  const std::vector<Grid> cases = { MakeFan(0, 3, 1.), MakeFan(2, 4, 2.), MakeFan(1, 1, 3.) };
  vtkNew<Messages> messages;
  const auto outputs = RunOn(MakeBlocks(cases), 2, messages);
  ASSERT_EQ(outputs.size(), 3u);
  for (int i = 0; i < 3; ++i)
  {
    ExpectAlone(outputs[i], cases[i], 2);
    ExpectConstant(outputs[i], "T", 1. + i);
  }
}

TEST(BlockCases, PartsOfACaseStayTogether)
{
  // Two cases of two parts each.
  vtkNew<Messages> messages;
  const auto outputs = RunOn(
    MakeBlocks({ MakeFan(0, 2, 1.), MakeFan(2, 2, 1.), MakeFan(0, 2, 5.), MakeFan(2, 2, 5.) }), 1,
    messages);
  vtkNew<Messages> quiet;
  const auto whole = RunOn(MakeBlocks({ MakeFan(0, 2, 1.), MakeFan(2, 2, 1.) }), 1, quiet);
  EXPECT_TRUE(quiet->Warnings.empty());
  ASSERT_EQ(outputs.size(), 4u);
  for (int i = 0; i < 4; ++i)
  {
    ASSERT_EQ(outputs[i]->GetNumberOfPoints(), whole[i % 2]->GetNumberOfPoints());
    for (vtkIdType p = 0; p < outputs[i]->GetNumberOfPoints(); ++p)
    {
      EXPECT_EQ(GetPoint(outputs[i], p), GetPoint(whole[i % 2], p));
    }
    ExpectConstant(outputs[i], "T", i < 2 ? 1. : 5.);
  }
}

TEST(BlockCases, CollectionsAndRefinement)
{
  vtkNew<vtkPartitionedDataSetCollection> collection;
  for (const double value : { 300., 450. })
  {
    vtkNew<vtkPartitionedDataSet> set;
    set->SetPartition(0, MakeFan(0, 2, value));
    collection->SetPartitionedDataSet(collection->GetNumberOfPartitionedDataSets(), set);
  }
  vtkNew<vtkRedGreenRefinement> filter;
  filter->RefineByAttributeErrorOff();
  filter->RefineByEdgeLengthOn();
  filter->SetMaximumEdgeLength(0.6);
  vtkNew<Messages> messages;
  const auto outputs = RunOn(filter.Get(), collection, messages);
  ASSERT_EQ(outputs.size(), 2u);
  EXPECT_GT(outputs[0]->GetNumberOfCells(), 10);
  EXPECT_EQ(GetCells(outputs[0]), GetCells(outputs[1]));
  ExpectConstant(outputs[0], "T", 300.);
  ExpectConstant(outputs[1], "T", 450.);
}

TEST(BlockCases, SetsOfFacesRemainPartsOfTheSolid)
{
  const Grid solid = MakeFan(0, 2, 1.);
  const auto makeFaces = [&](const std::vector<Cell>& cells)
  {
    const Grid faces = MakeGrid(
      { GetPoint(solid, 0), GetPoint(solid, 1), GetPoint(solid, 2), GetPoint(solid, 4) }, cells);
    return faces;
  };
  const Cell first = { VTK_TRIANGLE, { 0, 1, 2 } };
  const Cell last = { VTK_TRIANGLE, { 0, 1, 3 } };
  vtkNew<Messages> messages;
  const auto outputs =
    RunOn(MakeBlocks({ solid, makeFaces({ first, last }), makeFaces({ first }) }), 1, messages);
  EXPECT_TRUE(messages->Warnings.empty());
  ASSERT_EQ(outputs.size(), 3u);
  EXPECT_EQ(GetPoint(outputs[1], 0), GetPoint(outputs[0], 0));
  EXPECT_EQ(GetPoint(outputs[2], 0), GetPoint(outputs[0], 0));
}

TEST(BlockCases, NeighboursKeepDifferentValues)
{
  for (const int levels : { 0, 1, 3 })
  {
    const std::vector<Grid> inputs = { MakeFan(0, 1, 300.), MakeFan(1, 1, 450.),
      MakeFan(2, 1, 600.) };
    const char* texts[] = { "a", "b", "c" };
    for (int i = 0; i < 3; ++i)
    {
      vtkNew<vtkIntArray> numbers;
      numbers->SetName("Part");
      vtkNew<vtkStringArray> names;
      names->SetName("Name");
      for (vtkIdType p = 0; p < inputs[i]->GetNumberOfPoints(); ++p)
      {
        numbers->InsertNextValue(10 + i);
        names->InsertNextValue(texts[i]);
      }
      inputs[i]->GetPointData()->AddArray(numbers);
      inputs[i]->GetPointData()->AddArray(names);
    }
    vtkNew<Messages> messages;
    const auto outputs = RunOn(MakeBlocks(inputs), levels, messages);
    EXPECT_EQ(messages->CountWarnings("Blocks have different values at"), 1);
    const Grid whole = Subdivide(MakeFan(0, 3, 1.), levels);
    vtkIdType cells = 0;
    ASSERT_EQ(outputs.size(), 3u);
    for (int i = 0; i < 3; ++i)
    {
      ExpectConstant(outputs[i], "T", 300. + 150. * i);
      ExpectConstant(outputs[i], "Part", 10. + i);
      auto* names =
        vtkStringArray::SafeDownCast(outputs[i]->GetPointData()->GetAbstractArray("Name"));
      ASSERT_TRUE(names);
      for (vtkIdType p = 0; p < names->GetNumberOfValues(); ++p)
      {
        EXPECT_EQ(names->GetValue(p), texts[i]);
      }
      EXPECT_EQ(
        outputs[i]->GetPointData()->GetScalars(), outputs[i]->GetPointData()->GetArray("T"));
      EXPECT_FALSE(outputs[i]->GetPointData()->HasArray("MaterialPointIds"));
      EXPECT_FALSE(outputs[i]->GetCellData()->HasArray("SubdivisionOwnBlock"));
      cells += outputs[i]->GetNumberOfCells();
      for (vtkIdType p = 0; p < outputs[i]->GetNumberOfPoints(); ++p) // the shape is one
      {
        const vtkIdType found = whole->FindPoint(GetPoint(outputs[i], p).data());
        ASSERT_GE(found, 0);
        for (int c = 0; c < 3; ++c)
        {
          EXPECT_NEAR(GetPoint(whole, found)[c], GetPoint(outputs[i], p)[c], 1e-12);
        }
      }
    }
    EXPECT_EQ(cells, whole->GetNumberOfCells());
  }
}

TEST(BlockCases, NeighboursKeepDifferentTexts)
{
  const std::vector<Grid> inputs = { MakeFan(0, 1, 300.), MakeFan(1, 1, 300.) };
  for (int i = 0; i < 2; ++i)
  {
    vtkNew<vtkStringArray> names;
    names->SetName("Name");
    for (vtkIdType p = 0; p < inputs[i]->GetNumberOfPoints(); ++p)
    {
      names->InsertNextValue(i == 0 ? "a" : "b");
    }
    inputs[i]->GetPointData()->AddArray(names);
  }
  vtkNew<Messages> messages;
  const auto outputs = RunOn(MakeBlocks(inputs), 1, messages);
  EXPECT_EQ(messages->CountWarnings("they differ in the point array \"Name\" (blocks"), 1);
  for (int i = 0; i < 2; ++i)
  {
    auto* names =
      vtkStringArray::SafeDownCast(outputs[i]->GetPointData()->GetAbstractArray("Name"));
    ASSERT_TRUE(names);
    for (vtkIdType p = 0; p < names->GetNumberOfValues(); ++p)
    {
      EXPECT_EQ(names->GetValue(p), i == 0 ? "a" : "b");
    }
  }
}

TEST(BlockCases, RoundingIsNoDifference)
{
  const Grid a = MakeFan(0, 1, 0.1 + 0.2);
  const Grid b = MakeFan(1, 1, 0.3);
  for (const Grid& grid : { a, b })
  {
    vtkNew<vtkFloatArray> missing;
    missing->SetName("Missing");
    for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
    {
      missing->InsertNextValue(NAN);
    }
    grid->GetPointData()->AddArray(missing);
  }
  vtkNew<Messages> messages;
  const auto outputs = RunOn(MakeBlocks({ a, b }), 0, messages);
  EXPECT_TRUE(messages->Warnings.empty());
  EXPECT_EQ(outputs[1]->GetPointData()->GetArray("T")->GetComponent(0, 0), 0.1 + 0.2);
}

TEST(BlockCases, PointsOfOneIdAtTwoPlacesAreTwo)
{
  const std::vector<Grid> grids = { MakeFan(0, 2, 1.), MakeFan(0, 2, 1.), MakeFan(0, 2, 1.) };
  for (int i = 0; i < 3; ++i)
  {
    Move(grids[i], 100. * i);
  }
  const auto expectAlone = [&]
  {
    vtkNew<Messages> messages;
    const auto outputs = RunOn(MakeBlocks(grids), 1, messages);
    ASSERT_EQ(outputs.size(), 3u);
    for (int i = 0; i < 3; ++i)
    {
      ExpectAlone(outputs[i], grids[i], 1);
    }
    EXPECT_EQ(messages->CountWarnings("have the same global id"), 1);
  };
  for (const Grid& grid : grids)
  {
    SetIds<vtkTypeInt32Array>(grid, 0);
  }
  expectAlone();
  for (const Grid& grid : grids)
  {
    SetIds<vtkUnsignedCharArray>(grid, 3);
  }
  expectAlone();
  for (const Grid& grid : grids)
  {
    SetIds<vtkUnsignedLongLongArray>(grid, (1ull << 62) + 1);
  }
  expectAlone();
}

TEST(BlockCases, LargeIdsOfNeighbours)
{
  // Of 2^53 and more, which a double cannot tell apart.
  const long long first = (1ll << 60) + 1;
  const Grid a = MakeFan(0, 1, 1.);
  const Grid b = MakeFan(1, 1, 1.);
  const auto setIds = [&](vtkPointSet* grid, const std::vector<int>& numbers)
  {
    vtkNew<vtkUnsignedLongLongArray> ids;
    ids->SetName("Ids");
    for (const int number : numbers)
    {
      ids->InsertNextValue(static_cast<unsigned long long>(first + number));
    }
    grid->GetPointData()->SetGlobalIds(ids);
  };
  setIds(a, { 0, 1, 2, 3 });
  setIds(b, { 0, 1, 3, 4 });
  const double shift = 1e-9; // ids join what places do not
  b->GetPoints()->SetPoint(2, GetPoint(b, 2)[0] + shift, GetPoint(b, 2)[1], GetPoint(b, 2)[2]);
  vtkNew<Messages> messages;
  const auto outputs = RunOn(MakeBlocks({ a, b }), 1, messages);
  EXPECT_TRUE(messages->Warnings.empty());
  const Grid whole = Subdivide(MakeFan(0, 2, 1.), 1);
  EXPECT_NEAR(GetPoint(outputs[0], 0)[0], GetPoint(whole, 0)[0], 1e-12);
  EXPECT_NEAR(GetPoint(outputs[1], 0)[0], GetPoint(whole, 0)[0], 1e-12);
}

TEST(BlockCases, BlocksOfPointsOnlyKeepThem)
{
  std::vector<Grid> grids;
  for (const double value : { 1., 2. })
  {
    grids.push_back(MakeFan(0, 2, value));
    grids.back()->SetCells(VTK_TETRA, vtkNew<vtkCellArray>());
  }
  vtkNew<Messages> messages;
  const auto outputs = RunOn(MakeBlocks(grids), 1, messages);
  ASSERT_EQ(outputs.size(), 2u);
  for (int i = 0; i < 2; ++i)
  {
    EXPECT_EQ(outputs[i]->GetNumberOfPoints(), grids[i]->GetNumberOfPoints());
    ExpectConstant(outputs[i], "T", 1. + i);
  }
}
