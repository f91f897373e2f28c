// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestMultiDimensionalSubdivisionChaining.cxx
 * Filters in a row give what one filter gives, bit for bit; what was changed in between is noticed.
 */
#include "FeatureTools.h"
#include "FileTools.h"

#include "vtkSubdivisionModelSource.h"

#include "vtkAppendFilter.h"
#include "vtkClipDataSet.h"
#include "vtkExtractCells.h"
#include "vtkPlane.h"
#include "vtkSphereSource.h"
#include "vtkThreshold.h"

using namespace file_tools;
using namespace multi_dimensional_subdivision_tools;

namespace
{

/// 0 + 3 = 3 = 1 + 1 + 1 = 2 + 1, with files in between too.
void ExpectChains(vtkUnstructuredGrid* input, Options options)
{
  auto run = [&](vtkUnstructuredGrid* grid, int levels)
  {
    options.Levels = levels;
    return Subdivide(grid, options);
  };
  const Grid three = run(input, 3);
  ASSERT_GT(three->GetNumberOfCells(), 0);
  const Grid zero = run(input, 0);
  const Grid one = run(zero, 1);
  EXPECT_EQ(Compare(three, run(zero, 3)), "");
  EXPECT_EQ(Compare(run(input, 1), one), "");
  EXPECT_EQ(Compare(run(input, 2), run(one, 1)), "");
  EXPECT_EQ(Compare(three, run(run(one, 1), 1)), "");
  EXPECT_EQ(Compare(three, run(run(input, 2), 1)), "");
  EXPECT_EQ(Compare(three, run(one, 2)), "");
  EXPECT_EQ(Compare(three, run(run(run(one, 0), 2), 0)), "");
  const Grid read = WriteAndRead(run(input, 1));
  EXPECT_EQ(Compare(three, run(WriteAndRead(run(read, 1)), 1)), "");
  EXPECT_EQ(Compare(three, run(WriteAndRead(zero), 3)), "");
}

class ChainingOfModel : public testing::TestWithParam<std::tuple<int, int>>
{
};

}

TEST_P(ChainingOfModel, GivesTheSame)
{
  const auto [model, precision] = GetParam();
  const Grid grid = LoadModel(model, precision);
  ASSERT_EQ(grid->GetPoints()->GetDataType(),
    precision == vtkAlgorithm::SINGLE_PRECISION ? VTK_FLOAT : VTK_DOUBLE);
  AddArrays(grid);
  Options options;
  options.OriginalIds = options.Classification = true;
  ExpectChains(grid, options);
  AddGlobalIds(grid, 3 + model);
  options.Integers = true;
  options.OriginalIds = false;
  ExpectChains(grid, options);
}

INSTANTIATE_TEST_SUITE_P(MultiDimensionalSubdivision, ChainingOfModel,
  testing::Combine(testing::Range(0, int(vtkSubdivisionModelSource::NUMBER_OF_MODELS)),
    testing::Values(int(vtkAlgorithm::SINGLE_PRECISION), int(vtkAlgorithm::DOUBLE_PRECISION))),
  [](const auto& param)
  {
    return std::string(vtkSubdivisionModelSource::GetModelName(std::get<0>(param.param))) +
      (std::get<1>(param.param) == vtkAlgorithm::SINGLE_PRECISION ? "Float" : "Double");
  });

TEST(MultiDimensionalSubdivisionChaining, MixedCellsWithCentres)
{
  for (int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    for (bool globalIds : { false, true })
    {
      const Grid grid = MakeMixedBox(2, type);
      AddArrays(grid);
      if (globalIds)
      {
        AddGlobalIds(grid, 11);
      }
      const Grid zero = Subdivide(grid, 0);
      for (bool integers : { false, true })
      {
        Options options;
        options.Integers = integers;
        options.OriginalIds = options.Classification = true;
        ExpectChains(grid, options);
      }
      Options options;
      options.OriginalIds = true;
      options.Precision =
        type == VTK_FLOAT ? vtkAlgorithm::DOUBLE_PRECISION : vtkAlgorithm::SINGLE_PRECISION;
      ExpectChains(grid, options);
    }
  }
}

TEST(MultiDimensionalSubdivisionChaining, CentreOfAWedgeThatCannotBeSplit)
{
  // The diagonals through global ids turn around the wedge: only a centre helps. Then it is
  // numbered after the points, and its integer comes from the member with the smallest global id.
  const std::vector<Point> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 1, 0, 1 }, { 0, 1, 1 } };
  // Triangles take the quads' diagonals 0-4, 1-5, 2-3.
  const std::vector<Cell> cells = { { VTK_WEDGE, { 0, 1, 2, 3, 4, 5 } },
    { VTK_TRIANGLE, { 0, 1, 4 } }, { VTK_TRIANGLE, { 0, 4, 3 } }, { VTK_TRIANGLE, { 1, 2, 5 } },
    { VTK_TRIANGLE, { 1, 5, 4 } }, { VTK_TRIANGLE, { 2, 0, 3 } }, { VTK_TRIANGLE, { 2, 3, 5 } } };
  for (bool globalIds : { false, true })
  {
    const Grid grid = MakeGrid(points, cells);
    AddArrays(grid);
    vtkIdType smallest = 0;
    if (globalIds)
    {
      AddGlobalIds(grid, 5);
      vtkDataArray* ids = grid->GetPointData()->GetGlobalIds();
      for (vtkIdType i = 1; i < 6; ++i)
      {
        smallest = ids->GetTuple1(i) < ids->GetTuple1(smallest) ? i : smallest;
      }
      EXPECT_NE(smallest, 0);
    }
    Options options;
    options.OriginalIds = options.Classification = true;
    options.Levels = 0;
    const Grid zero = Subdivide(grid, options);
    ASSERT_EQ(zero->GetNumberOfPoints(), 7);
    EXPECT_EQ(zero->GetNumberOfCells(), 8 + 6);
    vtkPointData* data = zero->GetPointData();
    EXPECT_EQ(vtkStringArray::SafeDownCast(data->GetAbstractArray("string"))->GetValue(6),
      "n" + std::to_string(smallest));
    EXPECT_EQ(data->GetArray("int")->GetComponent(6, 1),
      grid->GetPointData()->GetArray("int")->GetComponent(smallest, 1));
    EXPECT_EQ(data->GetArray("vtkOriginalPointIds")->GetTuple1(6), -1);
    EXPECT_EQ(data->GetArray("vtkOriginalPointIds")->GetTuple1(5), 5);
    for (int k = 0; k < 3; ++k)
    {
      double mean = 0;
      for (const Point& p : points)
      {
        mean += p[k] / 6;
      }
      EXPECT_NEAR(GetPoint(zero, 6)[k], mean, 1e-15);
    }
    ExpectChains(grid, options);
  }
}

TEST(MultiDimensionalSubdivisionChaining, StampIsWrittenOnce)
{
  const Grid one = Subdivide(LoadModel(0, vtkAlgorithm::DOUBLE_PRECISION), 1);
  const Grid two = Subdivide(one, 1);
  for (const Grid& grid : { one, two })
  {
    ASSERT_TRUE(grid->GetFieldData()->GetArray("Subdivision"));
    EXPECT_EQ(grid->GetFieldData()->GetNumberOfArrays(), 1);
  }
}

// ---------------------------------------------------------------- what was changed in between

namespace
{

/// The stamp is there, and changes nothing.
void ExpectNotRecognised(vtkUnstructuredGrid* changed)
{
  ASSERT_TRUE(changed->GetFieldData()->GetArray("Subdivision"));
  const Grid plain = DeepCopy(changed);
  RemoveStamp(plain);
  for (int levels : { 0, 1, 2 })
  {
    Options options;
    options.Levels = levels;
    options.OriginalIds = options.Classification = true;
    EXPECT_EQ(Compare(Subdivide(changed, options), Subdivide(plain, options)), "") << levels;
  }
}

/// An output, large enough that the stamp's hash sees only a part of the cells.
Grid MakeOurs(int levels)
{
  Options options;
  options.Levels = levels;
  options.OriginalIds = true;
  const Grid grid = Subdivide(MakeMixedBox(3), options);
  EXPECT_TRUE(levels < 2 || grid->GetNumberOfCells() > 8192);
  return DeepCopy(grid);
}

Grid WithCells(vtkUnstructuredGrid* grid, const std::vector<vtkIdType>& order,
  vtkIdType edited = -1, const Ids& replacement = {})
{
  vtkNew<vtkUnsignedCharArray> types;
  vtkNew<vtkCellArray> cells;
  for (vtkIdType i : order)
  {
    const Ids ids = i == edited ? replacement : GetCell(grid, i);
    types->InsertNextValue(static_cast<unsigned char>(grid->GetCellType(i)));
    cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
  const Grid copy = DeepCopy(grid);
  copy->SetCells(types, cells);
  return copy;
}

Ids Range(vtkIdType size)
{
  Ids ids(size);
  std::iota(ids.begin(), ids.end(), 0);
  return ids;
}

}

TEST(MultiDimensionalSubdivisionStamp, ChangesWhatTheNextFilterDoes)
{
  // Else the tests below would prove nothing.
  for (int levels : { 1, 2 })
  {
    const Grid ours = MakeOurs(levels);
    const Grid plain = DeepCopy(ours);
    RemoveStamp(plain);
    Options options;
    options.OriginalIds = true;
    EXPECT_NE(Compare(Subdivide(ours, options), Subdivide(plain, options), false), "");
  }
}

TEST(MultiDimensionalSubdivisionStamp, ClippedIsNotOurs)
{
  const Grid ours = MakeOurs(1);
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(1.3, 1.2, 1.1);
  plane->SetNormal(1, 0.3, 0.2);
  vtkNew<vtkClipDataSet> clip;
  clip->SetInputData(ours);
  clip->SetClipFunction(plane);
  clip->Update();
  const Grid clipped = DeepCopy(clip->GetOutput());
  ASSERT_NE(clipped->GetNumberOfCells(), ours->GetNumberOfCells());
  clipped->GetFieldData()->PassData(ours->GetFieldData());
  ExpectNotRecognised(clipped);
}

TEST(MultiDimensionalSubdivisionStamp, ThresholdedIsNotOurs)
{
  const Grid ours = MakeOurs(1);
  ours->GetCellData()->AddArray(
    MakeArray<vtkDoubleArray>("chance", 1, ours->GetNumberOfCells(), 0, 1, 1));
  vtkNew<vtkThreshold> threshold;
  threshold->SetInputData(ours);
  threshold->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "chance");
  threshold->SetUpperThreshold(0.3);
  threshold->SetThresholdFunction(vtkThreshold::THRESHOLD_UPPER);
  threshold->Update();
  ASSERT_LT(threshold->GetOutput()->GetNumberOfCells(), ours->GetNumberOfCells());
  ExpectNotRecognised(threshold->GetOutput());
}

TEST(MultiDimensionalSubdivisionStamp, AppendedIsNotOurs)
{
  const Grid ours = MakeOurs(1);
  vtkNew<vtkAppendFilter> append;
  append->AddInputData(ours);
  append->AddInputData(MakeMixedBox(1));
  append->Update();
  const Grid appended = DeepCopy(append->GetOutput());
  appended->GetFieldData()->PassData(ours->GetFieldData());
  ExpectNotRecognised(appended);
}

TEST(MultiDimensionalSubdivisionStamp, OneCellChangedIsNotOurs)
{
  for (int levels : { 1, 2 })
  {
    const Grid ours = MakeOurs(levels);
    const vtkIdType size = ours->GetNumberOfCells();
    for (vtkIdType cell : { vtkIdType(1), size / 2 + 1, size - 2 })
    {
      SCOPED_TRACE(cell);
      Ids ids = GetCell(ours, cell);
      std::swap(ids[0], ids[1]); // the first lines and tets, the last lines
      ExpectNotRecognised(WithCells(ours, Range(size), cell, ids));
      ids = GetCell(ours, cell);
      ids[0] = ids[0] == 0 || ids[1] == 0 ? 5 : 0;
      ExpectNotRecognised(WithCells(ours, Range(size), cell, ids));
    }
  }
}

TEST(MultiDimensionalSubdivisionStamp, OneCellChangedAtLevelZeroIsNotOurs)
{
  // A mesh small enough that the hash sees every cell.
  const Grid ours = MakeOurs(0);
  const vtkIdType size = ours->GetNumberOfCells();
  ASSERT_LT(size, 4096);
  for (vtkIdType cell : { vtkIdType(0), size / 2, size - 1 })
  {
    Ids ids = GetCell(ours, cell);
    std::swap(ids[0], ids[1]);
    ExpectNotRecognised(WithCells(ours, Range(size), cell, ids));
  }
}

TEST(MultiDimensionalSubdivisionStamp, OtherOrderIsNotOurs)
{
  for (int levels : { 0, 1, 2 })
  {
    const Grid ours = MakeOurs(levels);
    Ids order = Range(ours->GetNumberOfCells());
    std::swap(order[2], order[3]);
    ExpectNotRecognised(WithCells(ours, order));
    std::shuffle(order.begin(), order.end(), std::mt19937(3));
    ExpectNotRecognised(WithCells(ours, order));
  }
}

TEST(MultiDimensionalSubdivisionStamp, MadeUpStampsDoNoHarm)
{
  const Grid ours = MakeOurs(1);
  const int size =
    static_cast<int>(ours->GetFieldData()->GetArray("Subdivision")->GetNumberOfTuples());
  for (int i = 0; i < size; ++i)
  {
    for (double value : { -1., 7., 19., 1e9 })
    {
      const Grid forged = DeepCopy(ours);
      forged->GetFieldData()->GetArray("Subdivision")->SetComponent(i, 0, value);
      Options options;
      options.OriginalIds = true;
      const Grid result = Subdivide(forged, options);
      EXPECT_EQ(result->GetNumberOfCells() > 0, true);
    }
  }
  const Grid wrongSize = DeepCopy(ours);
  wrongSize->GetFieldData()->GetArray("Subdivision")->SetNumberOfTuples(3);
  ExpectNotRecognised(wrongSize);
  const Grid text = DeepCopy(ours);
  text->GetFieldData()->RemoveArray("Subdivision");
  text->GetFieldData()->AddArray(MakeNames("Subdivision", 9));
  Options options;
  const Grid plain = DeepCopy(ours);
  RemoveStamp(plain);
  EXPECT_EQ(Compare(Subdivide(text, options), Subdivide(plain, options)), "");
}

TEST(MultiDimensionalSubdivisionChaining, AStampThatIsFoundOutLaterWarnsOnce)
{
  const Grid refined = feature_tools::MakeSwappedLevel(0);
  vtkNew<Messages> messages;
  Options options;
  options.Levels = 1;
  Subdivide(refined, options, messages);
  EXPECT_EQ(messages->CountWarnings("cannot be singular"), 1);
}
