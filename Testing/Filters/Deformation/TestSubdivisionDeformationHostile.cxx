// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSubdivisionDeformationHostile.cxx
 * Cells that cannot be read, at each of the three inputs: messages name them, and nothing crashes.
 */
#include "SubdivisionDeformationTools.h"

#include "vtkExplicitStructuredGrid.h"

using namespace deformation_tools;

namespace
{

constexpr vtkIdType Huge = std::numeric_limits<vtkIdType>::max();

vtkSmartPointer<vtkIdTypeArray> MakeIds(const Ids& ids)
{
  auto array = vtkSmartPointer<vtkIdTypeArray>::New();
  for (vtkIdType id : ids)
  {
    array->InsertNextValue(id);
  }
  return array;
}

/// Cells as they are written: offsets and ids of any kind.
vtkSmartPointer<vtkCellArray> MakeCells(const Ids& offsets, const Ids& ids)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(MakeIds(offsets), MakeIds(ids));
  return cells;
}

/// Points in the middle of MakeKuhnBox(2), and vectors for `cells` cells.
template <typename Data>
void AddPointsAndVectors(Data* data, vtkIdType cells)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < 8; ++i)
  {
    points->InsertNextPoint(0.7 + 0.3 * (i % 2), 0.8 + 0.2 * (i / 2 % 2), 0.9 + 0.1 * (i / 4));
  }
  data->SetPoints(points);
  data->GetCellData()->SetVectors(
    MakeArray<vtkDoubleArray>("velocity", 3, static_cast<int>(cells), -1, 1, 5));
}

/// Whether the vectors of a cell are those of the input.
bool IsLeft(vtkDataSet* output, vtkDataSet* input, vtkIdType cell)
{
  double before[3];
  double after[3];
  input->GetCellData()->GetVectors()->GetTuple(cell, before);
  output->GetCellData()->GetVectors()->GetTuple(cell, after);
  return std::equal(before, before + 3, after);
}

/// Deforms; cells of `wrong` alone keep their vectors, and the only warning names the first.
void ExpectVectorsAreLeft(vtkPointSet* input, const std::set<vtkIdType>& wrong)
{
  const Grid cage = MakeKuhnBox(2);
  Deformer filter;
  const auto output = filter.Run(input, cage, Moved(cage, Affine));
  ASSERT_TRUE(output);
  EXPECT_TRUE(filter.GetErrors().empty());
  EXPECT_LT(GetLargestError(output, input, Affine), 1e-12);
  const vtkIdType cells = input->GetCellData()->GetVectors()->GetNumberOfTuples();
  for (vtkIdType i = 0; i < cells; ++i)
  {
    EXPECT_EQ(IsLeft(output, input, i), wrong.count(i) > 0) << i;
  }
  ASSERT_EQ(filter.GetWarnings().size(), wrong.empty() ? 0U : 1U);
  if (!wrong.empty())
  {
    const std::string text = std::to_string(wrong.size()) + " cell(s) of the input, the first is " +
      "cell " + std::to_string(*wrong.begin()) + ",";
    EXPECT_NE(filter.GetWarnings()[0].find(text), std::string::npos) << filter.GetWarnings()[0];
  }
}

vtkSmartPointer<vtkPolyData> MakePolyData(vtkPoints* points, vtkCellArray* polys)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  return mesh;
}

/// A square in the plane z = 0 around (0.5, 0.5), of 4 x 4 points.
vtkSmartPointer<vtkPoints> MakeSquare(double shift)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  for (int i = 0; i < 16; ++i)
  {
    points->InsertNextPoint(i % 4 + shift, i / 4, 0.);
  }
  return points;
}

/// Nine quads, and then cells that were made up.
vtkSmartPointer<vtkCellArray> MakeQuadsAnd(const std::vector<Ids>& more)
{
  Ids offsets{ 0 };
  Ids ids;
  for (vtkIdType i = 0; i < 11; ++i)
  {
    if (i % 4 != 3)
    {
      ids.insert(ids.end(), { i, i + 1, i + 5, i + 4 });
      offsets.push_back(static_cast<vtkIdType>(ids.size()));
    }
  }
  for (const Ids& cell : more)
  {
    ids.insert(ids.end(), cell.begin(), cell.end());
    offsets.push_back(static_cast<vtkIdType>(ids.size()));
  }
  return MakeCells(offsets, ids);
}

const std::vector<Ids> WrongPolygons = { {}, { 3 }, { 3, 7 }, { 0, 1, 99 }, { -1, 2, 3 },
  { 0, 1, 5, Huge }, { 0, 1, 5, -Huge } };

}

TEST(SubdivisionDeformationHostile, CellsOfAGridThatNameNoPoints)
{
  vtkNew<vtkUnstructuredGrid> input;
  AddPointsAndVectors(input.Get(), 6);
  vtkNew<vtkUnsignedCharArray> types;
  for (int type :
    { VTK_TETRA, VTK_TETRA, VTK_TRIANGLE, VTK_EMPTY_CELL, VTK_POLY_VERTEX, VTK_TETRA })
  {
    types->InsertNextValue(static_cast<unsigned char>(type));
  }
  input->SetCells(types,
    MakeCells({ 0, 4, 8, 11, 11, 11, 15 }, { 0, 1, 2, 4, 0, 1, 2, 8, 0, -1, 2, 3, 4, 5, Huge }));
  const Grid cage = MakeKuhnBox(2);
  Deformer filter;
  const auto output = filter.Run(input, cage, Moved(cage, Affine));
  ASSERT_EQ(filter.GetWarnings().size(), 1U);
  EXPECT_NE(filter.GetWarnings()[0].find("4 cell(s) of the input, the first is cell 1,"),
    std::string::npos);
  for (vtkIdType i = 0; i < 6; ++i)
  {
    EXPECT_EQ(IsLeft(output, input, i), i > 0) << i; // an empty cell has nothing to turn it
  }
}

TEST(SubdivisionDeformationHostile, OffsetsThatLeadNowhere)
{
  for (const Ids& offsets : std::vector<Ids>{
         { 0, 4, 400, 8 }, { 0, 4, Huge, 8 }, { 0, 4, -5, 8 }, { 0, 4, 2, 8 }, { 0, 4, -Huge, 8 } })
  {
    vtkNew<vtkUnstructuredGrid> input;
    AddPointsAndVectors(input.Get(), 3);
    input->SetCells(VTK_POLYGON, MakeCells(offsets, { 0, 1, 2, 4, 1, 2, 3, 5 }));
    const Grid cage = MakeKuhnBox(2);
    Deformer filter;
    const auto output = filter.Run(input, cage, Moved(cage, Affine));
    EXPECT_LT(GetLargestError(output, input, Affine), 1e-12);
    EXPECT_FALSE(IsLeft(output, input, 0));
    EXPECT_TRUE(IsLeft(output, input, 1));
    ASSERT_EQ(filter.GetWarnings().size(), 1U);
    EXPECT_NE(filter.GetWarnings()[0].find("the first is cell 1,"), std::string::npos);
  }
}

TEST(SubdivisionDeformationHostile, PolygonsOfTheInput)
{
  vtkNew<vtkPolyData> input;
  AddPointsAndVectors(input.Get(), 7);
  input->SetVerts(MakeCells({ 0, 1, 2 }, { 5, 8 }));
  input->SetLines(MakeCells({ 0, 2, 2 }, { 0, 1 }));
  input->SetPolys(MakeCells({ 0, 0, 3, 6 }, { 0, 1, 2, 3, 4, -2 }));
  ExpectVectorsAreLeft(input, { 1, 3, 4, 6 });
}

TEST(SubdivisionDeformationHostile, ExplicitGridsOfTheInput)
{
  vtkNew<vtkExplicitStructuredGrid> input;
  input->SetDimensions(3, 2, 2);
  AddPointsAndVectors(input.Get(), 2);
  input->SetCells(
    MakeCells({ 0, 8, 16 }, { 0, 1, 3, 2, 4, 5, 7, 6, 0, 1, 3, 2, 4, 5, 7, 1000000000000 }));
  ExpectVectorsAreLeft(input, { 1 });
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(8);
  ghosts->FillValue(0);
  ghosts->SetValue(2, vtkDataSetAttributes::HIDDENPOINT);
  input->GetPointData()->AddArray(ghosts);
  ExpectVectorsAreLeft(input, { 1 });
}

TEST(SubdivisionDeformationHostile, PolygonsOfTheMeshes)
{
  const Grid input = MakeCloud(5, { 0.3, 0.3, 0 }, { 2.7, 2.7, 0 }, 1);
  for (int scheme : { vtkSubdivisionDeformation::LOOP, vtkSubdivisionDeformation::CATMULL_CLARK })
  {
    for (const Ids& wrong : WrongPolygons)
    {
      const auto rest = MakePolyData(MakeSquare(0.), MakeQuadsAnd({ wrong }));
      const auto moved = MakePolyData(MakeSquare(5.), MakeQuadsAnd({ wrong }));
      Deformer filter;
      filter->SetSurfaceScheme(scheme);
      const auto output = filter.Run(input, rest, moved);
      EXPECT_TRUE(filter.GetErrors().empty());
      ASSERT_EQ(filter.GetWarnings().size(), 1U);
      EXPECT_NE(filter.GetWarnings()[0].find("(cell 9, "), std::string::npos)
        << filter.GetWarnings()[0];
      EXPECT_LT(GetLargestError(
                  output, input, [](const Point& x) { return Point{ x[0] + 5., x[1], x[2] }; }),
        1e-6);
      // Meshes that differ there are read cell by cell.
      filter.Forget();
      filter.Run(input, rest, MakePolyData(MakeSquare(5.), MakeQuadsAnd({ { 0, 1, 6 } })));
      ASSERT_EQ(filter.GetErrors().size(), 1U);
      EXPECT_NE(filter.GetErrors()[0].find("Cell 9 is the first that differs"), std::string::npos);
      filter.Forget();
      filter.Run(input, MakePolyData(MakeSquare(0.), MakeQuadsAnd({ { 0, 1, 6 } })), moved);
      ASSERT_EQ(filter.GetErrors().size(), 1U);
      EXPECT_NE(filter.GetErrors()[0].find("Cell 9 is the first that differs"), std::string::npos);
    }
  }
}

/// All cells are wrong.
TEST(SubdivisionDeformationHostile, MeshesWithoutACellThatCanBeUsed)
{
  const Grid input = MakeCloud(5, { 0.3, 0.3, 0 }, { 2.7, 2.7, 0 }, 1);
  for (int scheme : { vtkSubdivisionDeformation::LOOP, vtkSubdivisionDeformation::CATMULL_CLARK })
  {
    Ids offsets{ 0 };
    Ids ids;
    for (const Ids& wrong : WrongPolygons)
    {
      ids.insert(ids.end(), wrong.begin(), wrong.end());
      offsets.push_back(static_cast<vtkIdType>(ids.size()));
    }
    const auto mesh = MakePolyData(MakeSquare(0.), MakeCells(offsets, ids));
    Deformer filter;
    filter->SetSurfaceScheme(scheme);
    const auto output = filter.Run(input, mesh, mesh);
    EXPECT_EQ(ComparePoints(output, input), "");
    EXPECT_TRUE(filter.GetErrors().empty());
    EXPECT_FALSE(filter.GetWarnings().empty());
  }
}

TEST(SubdivisionDeformationHostile, CellsWithoutATypeInTheMeshes)
{
  const Grid cage = MakeKuhnBox(2);
  const Grid input = MakeCloud(5, { 0.7, 0.7, 0.7 }, { 1.3, 1.3, 1.3 }, 1);
  const Grid rest = DeepCopy(cage);
  vtkNew<vtkUnsignedCharArray> types;
  types->InsertNextValue(VTK_TETRA);
  rest->SetCells(types, cage->GetCells());
  Deformer filter;
  filter.Run(input, rest, rest);
  EXPECT_TRUE(filter.GetErrors().empty());
  ASSERT_FALSE(filter.GetWarnings().empty());
  EXPECT_NE(
    filter.GetWarnings()[0].find("47 cells (the first is cell 1, type 0"), std::string::npos)
    << filter.GetWarnings()[0];
  filter.Forget();
  filter.Run(input, cage, rest);
  ASSERT_EQ(filter.GetErrors().size(), 1U);
  EXPECT_NE(filter.GetErrors()[0].find("Cell 1 is the first that differs"), std::string::npos);
}

/// As blocks, cells pass through the reader of partitions.
TEST(SubdivisionDeformationHostile, BlocksOfWrongCells)
{
  const Grid input = MakeCloud(5, { 0.3, 0.3, 0 }, { 2.7, 2.7, 0 }, 1);
  for (const Ids& wrong : WrongPolygons)
  {
    vtkSmartPointer<vtkMultiBlockDataSet> meshes[2];
    for (int m = 0; m < 2; ++m)
    {
      meshes[m] = vtkSmartPointer<vtkMultiBlockDataSet>::New();
      meshes[m]->SetBlock(0, MakePolyData(MakeSquare(5. * m), MakeQuadsAnd({})));
      meshes[m]->SetBlock(1, MakePolyData(MakeSquare(5. * m), MakeQuadsAnd({ wrong })));
    }
    Deformer filter;
    filter.Run(input, meshes[0], meshes[1]);
    EXPECT_FALSE(filter.GetWarnings().empty());
    vtkNew<vtkMultiBlockDataSet> inputs;
    vtkNew<vtkPolyData> block;
    AddPointsAndVectors(block.Get(), 10);
    block->SetPolys(MakeQuadsAnd({ wrong }));
    inputs->SetBlock(0, block);
    const Grid cage = MakeKuhnBox(2);
    filter.Run(inputs, cage, Moved(cage, Affine));
    EXPECT_TRUE(filter.GetErrors().empty());
  }
}
