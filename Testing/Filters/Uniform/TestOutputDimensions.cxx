// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestOutputDimensions.cxx
 * Cells of some dimensions: the option of the filter, and the filter vtkExtractDimensions.
 */
#include "MultiDimensionalSubdivisionTools.h"

#include "vtkExtractDimensions.h"

using namespace multi_dimensional_subdivision_tools;

namespace
{

Grid MakeInput()
{
  const Grid box = MakeMixedBox(2);
  AddArrays(box);
  return box;
}

Grid SubdivideTo(vtkDataObject* input, int dimensions, int levels = 1, bool cache = true)
{
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  filter->SetVolumeSchemeToBoxSpline();
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetInputDataObject(input);
  filter->SetNumberOfLevels(levels);
  filter->SetOutputDimensions(dimensions);
  filter->SetCacheOperator(cache);
  filter->Update();
  EXPECT_TRUE(messages->Errors.empty());
  return filter->GetOutput();
}

int GetDimension(int type)
{
  static const std::map<int, int> dimensions = { { VTK_VERTEX, 0 }, { VTK_LINE, 1 },
    { VTK_TRIANGLE, 2 }, { VTK_TETRA, 3 } };
  return dimensions.at(type);
}

/// `part` has the cells of `whole` that have one of the dimensions, with all values.
void ExpectPart(vtkUnstructuredGrid* whole, vtkUnstructuredGrid* part, int dimensions)
{
  std::vector<vtkIdType> cells;
  std::vector<vtkIdType> points;
  for (vtkIdType c = 0; c < whole->GetNumberOfCells(); ++c)
  {
    if (dimensions >> GetDimension(whole->GetCellType(c)) & 1)
    {
      cells.push_back(c);
      const Ids ids = GetCell(whole, c);
      points.insert(points.end(), ids.begin(), ids.end());
    }
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  ASSERT_EQ(part->GetNumberOfCells(), static_cast<vtkIdType>(cells.size()));
  ASSERT_EQ(part->GetNumberOfPoints(), static_cast<vtkIdType>(points.size()));
  for (vtkIdType c = 0; c < part->GetNumberOfCells(); ++c)
  {
    ASSERT_EQ(part->GetCellType(c), whole->GetCellType(cells[c]));
    Ids ids = GetCell(part, c);
    std::transform(ids.begin(), ids.end(), ids.begin(), [&](vtkIdType id) { return points[id]; });
    ASSERT_EQ(ids, GetCell(whole, cells[c]));
  }
  for (vtkIdType p = 0; p < part->GetNumberOfPoints(); ++p)
  {
    ASSERT_EQ(GetPoint(part, p), GetPoint(whole, points[p]));
  }
  const auto expectValues =
    [](vtkDataSetAttributes* from, const std::vector<vtkIdType>& ids, vtkDataSetAttributes* to)
  {
    ASSERT_EQ(to->GetNumberOfArrays(), from->GetNumberOfArrays());
    for (int a = 0; a < from->GetNumberOfArrays(); ++a)
    {
      vtkAbstractArray* values = from->GetAbstractArray(a);
      vtkAbstractArray* taken = to->GetAbstractArray(values->GetName());
      ASSERT_TRUE(taken) << values->GetName();
      ASSERT_EQ(taken->GetDataType(), values->GetDataType());
      const int components = values->GetNumberOfComponents();
      for (std::size_t i = 0; i < ids.size() * components; ++i)
      {
        ASSERT_EQ(taken->GetVariantValue(i).ToString(),
          values->GetVariantValue(ids[i / components] * components + i % components).ToString());
      }
    }
  };
  expectValues(whole->GetPointData(), points, part->GetPointData());
  expectValues(whole->GetCellData(), cells, part->GetCellData());
}

}

TEST(OutputDimensions, AreAnyOfZeroToThree)
{
  const Grid input = MakeInput();
  const Grid whole = SubdivideTo(input, 15);
  EXPECT_TRUE(whole->GetFieldData()->HasArray("Subdivision"));
  for (int dimensions = 0; dimensions < 15; ++dimensions)
  {
    SCOPED_TRACE(dimensions);
    const Grid part = SubdivideTo(input, dimensions);
    ExpectPart(whole, part, dimensions);
    EXPECT_FALSE(part->GetFieldData()->HasArray("Subdivision"));
    EXPECT_EQ(part->GetPointData()->GetScalars() != nullptr,
      whole->GetPointData()->GetScalars() != nullptr);
  }
}

TEST(OutputDimensions, NothingToExtractIsTold)
{
  const std::string said =
    "No cell has one of the dimensions that OutputDimensions asks for, so the "
    "output is empty. There are lines, surfaces: choose from these.";
  const Grid shell = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    { { VTK_QUAD, { 0, 1, 2, 3 } }, { VTK_LINE, { 0, 3 } } });
  for (const bool inside : { false, true })
  {
    vtkNew<vtkExtractDimensions> extract;
    vtkNew<vtkMultiDimensionalSubdivision> filter;
    filter->SetVolumeSchemeToBoxSpline();
    filter->SetOutputDimensions(8);
    vtkNew<Messages> messages;
    UpdateInSilence(inside ? static_cast<vtkAlgorithm*>(filter) : extract, shell, messages);
    EXPECT_EQ(messages->CountWarnings(said), 1);
    EXPECT_EQ(messages->Warnings.size(), 1u);
  }
  vtkNew<vtkExtractDimensions> lines;
  lines->SetOutputDimensions(vtkExtractDimensions::LINES);
  UpdateInSilence(lines, shell);
  vtkNew<vtkExtractDimensions> empty;
  UpdateInSilence(empty, Grid::New()); // nothing could be chosen
}

TEST(OutputDimensions, AreNamedByNumbersToo)
{
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  filter->SetVolumeSchemeToBoxSpline();
  vtkNew<vtkExtractDimensions> extract;
  filter->ClearOutputDimensions();
  extract->ClearOutputDimensions();
  for (const int dimension : { 1, 3, -1, 4, 31 })
  {
    filter->AddOutputDimension(dimension);
    extract->AddOutputDimension(dimension);
  }
  EXPECT_EQ(filter->GetOutputDimensions(), 10);
  EXPECT_EQ(extract->GetOutputDimensions(), 10);
}

TEST(OutputDimensions, ShareTheKeptOperator)
{
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  filter->SetVolumeSchemeToBoxSpline();
  filter->SetInputDataObject(MakeInput());
  filter->SetNumberOfLevels(2);
  filter->Update();
  const Grid whole = DeepCopy(filter->GetOutput());
  for (const int dimensions : { 8, 15, 4, 7, 15 })
  {
    filter->SetOutputDimensions(dimensions);
    filter->Update();
    if (dimensions == 15)
    {
      EXPECT_EQ(Compare(whole, filter->GetOutput()), "");
    }
    else
    {
      ExpectPart(whole, filter->GetOutput(), dimensions);
    }
  }
  EXPECT_EQ(filter->GetNumberOfTopologyBuilds(), 1);
}

TEST(OutputDimensions, AreANewControlMeshForTheNextFilter)
{
  const Grid part = SubdivideTo(MakeInput(), 8);
  const Grid plain = DeepCopy(part);
  plain->GetFieldData()->Initialize();
  EXPECT_EQ(Compare(SubdivideTo(part, 15), SubdivideTo(plain, 15), false), "");
}

TEST(OutputDimensions, KeepTheStructureOfBlocks)
{
  const Grid input = MakeInput();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, input);
  blocks->SetBlock(2, input);
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  filter->SetVolumeSchemeToBoxSpline();
  filter->SetInputDataObject(blocks);
  filter->SetJoinBlocks(false);
  vtkNew<vtkExtractDimensions> extract;
  extract->SetInputConnection(filter->GetOutputPort());
  extract->Update();
  auto* whole = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  auto* parts = vtkMultiBlockDataSet::SafeDownCast(extract->GetOutputDataObject(0));
  ASSERT_EQ(parts->GetNumberOfBlocks(), 3u);
  EXPECT_FALSE(parts->GetBlock(1));
  ExpectPart(vtkUnstructuredGrid::SafeDownCast(whole->GetBlock(2)),
    vtkUnstructuredGrid::SafeDownCast(parts->GetBlock(2)), 8);
  const Grid before = vtkUnstructuredGrid::SafeDownCast(parts->GetBlock(0));
  filter->SetOutputDimensions(8);
  extract->SetOutputDimensions(15);
  extract->Update();
  parts = vtkMultiBlockDataSet::SafeDownCast(extract->GetOutputDataObject(0));
  EXPECT_EQ(Compare(before, vtkUnstructuredGrid::SafeDownCast(parts->GetBlock(0))), "");
}

TEST(ExtractDimensions, TakesCellsOfAnyTypeWithTheirFaces)
{
  auto grid =
    MakeGrid({ { 9, 9, 9 }, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 2, 0, 0 } },
      { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_QUADRATIC_EDGE, { 0, 5, 1 } } });
  vtkNew<vtkIdList> faces;
  for (const vtkIdType id : { 4, 3, 1, 2, 3, 3, 1, 4, 2, 3, 2, 4, 3, 3, 3, 4, 1 })
  {
    faces->InsertNextId(id);
  }
  grid->InsertNextCell(VTK_POLYHEDRON, faces);
  const vtkIdType tet[4] = { 1, 2, 3, 4 };
  grid->InsertNextCell(VTK_TETRA, 4, tet);
  vtkNew<vtkExtractDimensions> extract;
  extract->SetInputDataObject(grid);
  extract->Update();
  auto* solids = vtkUnstructuredGrid::SafeDownCast(extract->GetOutputDataObject(0));
  ASSERT_EQ(solids->GetNumberOfCells(), 2);
  EXPECT_EQ(solids->GetNumberOfPoints(), 4);
  EXPECT_EQ(solids->GetCellType(0), VTK_POLYHEDRON);
  EXPECT_EQ(GetCell(solids, 1), (Ids{ 0, 1, 2, 3 }));
  vtkNew<vtkIdList> stream;
  solids->GetFaceStream(0, stream);
  EXPECT_EQ(Ids(stream->begin(), stream->end()),
    (Ids{ 4, 3, 0, 1, 2, 3, 0, 3, 1, 3, 1, 3, 2, 3, 2, 3, 0 }));
  extract->ClearOutputDimensions();
  extract->AddOutputDimension(1);
  extract->Update();
  auto* lines = vtkUnstructuredGrid::SafeDownCast(extract->GetOutputDataObject(0));
  ASSERT_EQ(lines->GetNumberOfCells(), 1);
  EXPECT_EQ(GetCell(lines, 0), (Ids{ 0, 2, 1 }));
}

TEST(ExtractDimensions, ReadsPolyData)
{
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 5; ++i)
  {
    points->InsertNextPoint(i, i * i, 0.);
  }
  data->SetPoints(points);
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> polygons;
  const vtkIdType line[3] = { 0, 1, 4 };
  lines->InsertNextCell(3, line);
  const vtkIdType triangle[3] = { 3, 1, 2 };
  polygons->InsertNextCell(3, triangle);
  data->SetLines(lines);
  data->SetPolys(polygons);
  data->GetCellData()->AddArray(MakeArray<vtkDoubleArray>("values", 1, 2, 0., 1., 5));
  vtkNew<vtkExtractDimensions> extract;
  extract->SetInputDataObject(data);
  extract->SetOutputDimensions(vtkExtractDimensions::SURFACES);
  extract->Update();
  auto* part = vtkPolyData::SafeDownCast(extract->GetOutputDataObject(0));
  ASSERT_TRUE(part);
  ASSERT_EQ(part->GetNumberOfCells(), 1);
  EXPECT_EQ(part->GetNumberOfPoints(), 3);
  EXPECT_EQ(part->GetNumberOfPolys(), 1);
  EXPECT_EQ(part->GetCellData()->GetArray(0)->GetComponent(0, 0),
    data->GetCellData()->GetArray(0)->GetComponent(1, 0));
}

TEST(OutputDimensions, CellsWithPointsThatDoNotExistAreTold)
{
  const Grid grid = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 0, 1, 2, 99 } }, { VTK_LINE, { -1, 0 } } });
  vtkNew<vtkExtractDimensions> filter;
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetInputData(grid);
  filter->SetOutputDimensions(8);
  filter->Update();
  EXPECT_EQ(
    messages->CountWarnings("1 cell(s) have points that do not exist, the first is cell 1"), 1);
  auto* output = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_EQ(output->GetNumberOfCells(), 1);
  EXPECT_EQ(GetCell(output, 0), (Ids{ 0, 1, 2, 3 }));
}
