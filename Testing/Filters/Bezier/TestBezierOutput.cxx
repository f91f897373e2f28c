// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestBezierOutput.cxx
 * OutputCells = Bezier: what the output has besides the shape of its cells, and where cells stay
 * linear.
 */
#include "BezierTools.h"

#include "Private/Bezier/BezierCells.h"

#include "vtkSubdivisionOperator.h"

#include "vtkGenericCell.h"

using namespace bezier_tools;

namespace
{

/// One cell that fills its place in parameters, as the class of VTK for its type has it.
Grid MakeCellOfType(int type)
{
  const auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
  const double* at = cell->GetParametricCoords();
  std::vector<Point> points;
  Cell ids{ type, {} };
  for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
  {
    points.push_back({ at[3 * i], at[3 * i + 1], at[3 * i + 2] });
    ids.Points.push_back(i);
  }
  return MakeGrid(points, { ids });
}

/// A tetrahedron as VTK stores polyhedra.
Grid MakePolyhedron()
{
  const Grid grid = MakeGrid(
    { { { 0., 0., 0. } }, { { 1., 0., 0. } }, { { 0., 1., 0. } }, { { 0., 0., 1. } } }, {});
  grid->Allocate(1);
  const vtkIdType faces[] = { 3, 0, 2, 1, 3, 0, 1, 3, 3, 1, 2, 3, 3, 2, 0, 3 };
  grid->InsertNextCell(VTK_POLYHEDRON, 4, faces);
  return grid;
}

std::set<int> GetTypes(vtkUnstructuredGrid* grid)
{
  std::set<int> types;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    types.insert(grid->GetCellType(c));
  }
  return types;
}

}

TEST(BezierOutput, DataOfCellsAndPointsStay)
{
  const Grid input = MakeSheet(4, true, 0.1);
  input->GetCellData()->AddArray(
    MakeArray<vtkIntArray>("Material", 1, input->GetNumberOfCells(), 0., 9., 5));
  const Grid linear = MakeBezier(input, 1,
    [](Filter* filter)
    {
      filter->SetOutputCellsToLinear();
      filter->GenerateOriginalIdsOn();
    });
  const Grid bezier = MakeBezier(input, 1,
    [](Filter* filter)
    {
      filter->GenerateOriginalIdsOn();
      filter->SetBezierTolerance(0.);
    });
  ASSERT_NE(bezier->GetPointData()->GetArray("Scalar"), nullptr);
  vtkDataArray* cells = bezier->GetCellData()->GetArray("vtkOriginalCellIds");
  ASSERT_NE(cells, nullptr);
  EXPECT_NE(bezier->GetCellData()->GetArray("Material"), nullptr);
  EXPECT_NE(linear->GetFieldData()->GetAbstractArray("Subdivision"), nullptr);
  EXPECT_EQ(bezier->GetFieldData()->GetAbstractArray("Subdivision"), nullptr);
  for (vtkIdType c = 1; c < bezier->GetNumberOfCells(); ++c)
  {
    EXPECT_LE(cells->GetComponent(c - 1, 0), cells->GetComponent(c, 0));
  }
}

TEST(BezierOutput, OtherCellsStay)
{
  const Grid input = MakeGrid({ { { 0., 0., 0. } }, { { 1., 0., 0. } }, { { 0., 1., 0. } } },
    { { VTK_VERTEX, { 1 } }, { VTK_LINE, { 0, 2 } } });
  const Grid bezier = MakeBezier(input, 2);
  ASSERT_EQ(bezier->GetNumberOfCells(), 2);
  EXPECT_EQ(bezier->GetCellType(0), VTK_VERTEX);
  EXPECT_EQ(bezier->GetCellType(1), VTK_BEZIER_CURVE);
  EXPECT_EQ(MakeBezier(vtkSmartPointer<vtkUnstructuredGrid>::New(), 1)->GetNumberOfCells(), 0);
}

TEST(BezierOutput, SolidsOfAllTypesBecomeBezierTetrahedra)
{
  const std::set<int> tetrahedra{ VTK_BEZIER_TETRAHEDRON };
  for (const int type : { VTK_TETRA, VTK_VOXEL, VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID,
         VTK_PENTAGONAL_PRISM, VTK_HEXAGONAL_PRISM, VTK_QUADRATIC_TETRA, VTK_QUADRATIC_HEXAHEDRON,
         VTK_TRIQUADRATIC_HEXAHEDRON, VTK_QUADRATIC_WEDGE, VTK_QUADRATIC_PYRAMID, VTK_POLYHEDRON })
  {
    const Grid input = type == VTK_POLYHEDRON ? MakePolyhedron() : MakeCellOfType(type);
    const auto cut = [](Filter* filter) { filter->SetQuadraticCellsToPieces(); };
    for (const int levels : { 0, 1 })
    {
      EXPECT_EQ(GetTypes(MakeBezier(input, levels, cut)), tetrahedra) << type << " " << levels;
    }
  }
}

TEST(BezierOutput, FacesOfAllTypesBecomeBezierCells)
{
  for (const int type : { VTK_TRIANGLE, VTK_QUAD, VTK_PIXEL, VTK_POLYGON, VTK_TRIANGLE_STRIP,
         VTK_QUADRATIC_TRIANGLE, VTK_QUADRATIC_QUAD, VTK_BIQUADRATIC_QUAD })
  {
    const std::vector<Point> square{ { { 0., 0., 0. } }, { { 1., 0., 0. } }, { { 0., 1., 0. } },
      { { 1., 1., 0. } } };
    const bool isSquare = type == VTK_POLYGON || type == VTK_TRIANGLE_STRIP;
    const Grid input = isSquare
      ? MakeGrid(square, { { type, type == VTK_POLYGON ? Ids{ 0, 1, 3, 2 } : Ids{ 0, 1, 2, 3 } } })
      : MakeCellOfType(type);
    for (const int levels : { 0, 1 })
    {
      for (const auto& [scheme, wanted] :
        { std::make_pair(vtkSurfaceSubdivision::LOOP, VTK_BEZIER_TRIANGLE),
          std::make_pair(vtkSurfaceSubdivision::LINEAR, VTK_BEZIER_TRIANGLE),
          std::make_pair(vtkSurfaceSubdivision::CATMULL_CLARK, VTK_BEZIER_QUADRILATERAL) })
      {
        vtkNew<vtkSurfaceSubdivision> filter;
        filter->SetInputDataObject(input);
        filter->SetScheme(scheme);
        filter->SetNumberOfLevels(levels);
        filter->SetQuadraticCellsToPieces();
        filter->SetOutputCellsToBezier();
        filter->Update();
        EXPECT_EQ(GetTypes(filter->GetUnstructuredGridOutput()), std::set<int>{ wanted })
          << type << " " << scheme << " " << levels;
      }
      EXPECT_EQ(GetTypes(MakeBezier(
                  input, levels, [](Filter* filter) { filter->SetQuadraticCellsToPieces(); })),
        std::set<int>{ VTK_BEZIER_TRIANGLE })
        << type << " " << levels;
    }
  }
}

TEST(BezierOutput, QuadsWithTwoEqualPointsAreTriangles)
{
  const Grid input =
    MakeGrid({ { { 0., 0., 0. } }, { { 1., 0., 0. } }, { { 0., 1., 0. } }, { { 1., 1., 0. } } },
      { { VTK_POLYGON, { 0, 1, 3, 2 } }, { VTK_POLYGON, { 0, 1, 1, 2 } } });
  vtkNew<vtkSurfaceSubdivision> filter;
  filter->SetInputDataObject(ToSurface(input));
  filter->SetSchemeToCatmullClark();
  filter->SetNumberOfLevels(0);
  filter->SetOutputCellsToBezier();
  filter->Update();
  vtkUnstructuredGrid* bezier = filter->GetUnstructuredGridOutput();
  EXPECT_EQ(bezier->GetNumberOfCells(), 1 + 3);
  EXPECT_EQ(GetTypes(bezier), std::set<int>{ VTK_BEZIER_QUADRILATERAL });
}

TEST(BezierOutput, SolidsWithoutTheirThirdStepAreTold)
{
  vtkNew<Filter> filter;
  filter->SetInputDataObject(MakeLattice(1));
  filter->SetNumberOfLevels(2);
  filter->ProjectToLimitOn();
  filter->Update();
  std::vector<std::string> errors;
  subdivision::BezierOptions options;
  options.Steps = 2;
  options.Fail = [&](const std::string& text) { errors.push_back(text); };
  const auto made = subdivision::MakeBezierCells(filter->GetOutput(), options);
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_NE(errors[0].find("Cell 0 after 2 steps, of type 10"), std::string::npos) << errors[0];
  auto* grid = vtkUnstructuredGrid::SafeDownCast(made);
  ASSERT_NE(grid, nullptr);
  EXPECT_EQ(GetTypes(grid), std::set<int>{ VTK_TETRA });
}

TEST(BezierOutput, SomeOptionsLeaveThemLinear)
{
  const Grid input = MakeLattice(1);
  for (const bool keeps : { false, true })
  {
    vtkNew<Filter> filter;
    vtkNew<Messages> messages;
    messages->Watch(filter);
    filter->SetInputData(input);
    filter->SetOutputCellsToBezier();
    keeps ? filter->SetVolumeSchemeToLinear() : filter->SetVolumeSchemeToTetOct();
    filter->SetKeepCellTypes(keeps);
    filter->Update();
    EXPECT_EQ(messages->CountWarnings("Bezier cells need VolumeScheme = BoxSpline or Linear"), 1);
    EXPECT_EQ(filter->GetOutput()->GetCellType(0), VTK_TETRA);
    EXPECT_GT(filter->GetOutput()->GetNumberOfCells(), 0);
  }
  vtkNew<vtkSurfaceSubdivision> surface;
  vtkNew<Messages> messages;
  messages->Watch(surface);
  surface->SetInputData(ToSurface(MakeSheet(2, false, 0.)));
  surface->SetSchemeToDooSabin();
  surface->SetOutputCellsToBezier();
  surface->Update();
  EXPECT_EQ(messages->CountWarnings("Bezier cells need Scheme = Loop"), 1);
  ASSERT_NE(surface->GetOutput(), nullptr);
  EXPECT_GT(surface->GetOutput()->GetNumberOfCells(), 0);
}

TEST(BezierOutput, BlocksKeepTheirStructure)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  const Grid left = MakeSheet(3, true, 0.1);
  const Grid right = MakeSheet(3, true, 0.1);
  right->GetPoints()->SetPoint(0, 20., 0., 0.);
  blocks->SetBlock(0, ToSurface(left));
  blocks->SetBlock(2, ToSurface(right));
  vtkNew<vtkSurfaceSubdivision> filter;
  filter->SetInputData(blocks);
  filter->SetOutputCellsToBezier();
  filter->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_NE(output, nullptr);
  EXPECT_EQ(output->GetBlock(1), nullptr);
  for (const unsigned block : { 0u, 2u })
  {
    auto* grid = vtkUnstructuredGrid::SafeDownCast(output->GetBlock(block));
    ASSERT_NE(grid, nullptr);
    EXPECT_EQ(grid->GetCellType(0), VTK_BEZIER_TRIANGLE);
  }
}

TEST(BezierOutput, DoNotDependOnThreads)
{
  const Grid input = MakeSheet(60, true, 0.2);
  const Grid output = MakeInThreads([&] { return MakeBezier(input, 1); });
  EXPECT_GT(output->GetNumberOfCells(), 60 * 60 * 2);
}

TEST(BezierOutput, TheOperatorIsThatOfLinearCells)
{
  const Grid input = MakeSheet(3, true, 0.1);
  vtkNew<Filter> filter;
  filter->SetInputData(input);
  filter->SetOutputCellsToBezier();
  vtkNew<vtkSubdivisionOperator> result;
  ASSERT_TRUE(filter->ComputeOperator(result));
  EXPECT_EQ(result->GetNumberOfRows(), 16 + 33);
}

TEST(BezierOutput, ArraysKeepTheToleranceToo)
{
  // All points at one place: only values differ from a polynomial.
  const Grid input = MakeOctahedron();
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    input->GetPoints()->SetPoint(i, 1., 2., 3.);
  }
  EXPECT_EQ(MakeBezier(input, 2)->GetNumberOfCells(), 8);
  AddScalar(input);
  const Grid coarse = MakeBezier(input, 2, [](Filter* filter) { filter->SetBezierTolerance(0.5); });
  EXPECT_EQ(coarse->GetNumberOfCells(), 8);
  EXPECT_GT(MakeBezier(input, 2)->GetNumberOfCells(), 8);
}

TEST(BezierOutput, EqualValuesSplitNothing)
{
  const Grid input = MakeSheet(6, true, 0.2);
  const vtkIdType cells = MakeBezier(input, 2)->GetNumberOfCells();
  for (const double value : { 0., 1. / 3., 1e9 / 7. })
  {
    vtkNew<vtkDoubleArray> equal;
    equal->SetName("Equal");
    equal->SetNumberOfTuples(input->GetNumberOfPoints());
    equal->Fill(value);
    input->GetPointData()->AddArray(equal);
    EXPECT_EQ(MakeBezier(input, 2)->GetNumberOfCells(), cells) << value;
  }
}

TEST(BezierOutput, IdsOf32BitsAndSinglePrecision)
{
  const Grid input = MakeSheet(3, true, 0.1);
  const Grid wide = MakeBezier(input, 1);
  const Grid narrow = MakeBezier(input, 1,
    [](Filter* filter)
    {
      filter->Use32BitIdsOn();
      filter->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
    });
  EXPECT_TRUE(wide->GetCells()->IsStorage64Bit());
  EXPECT_FALSE(narrow->GetCells()->IsStorage64Bit());
  EXPECT_EQ(narrow->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(GetCells(wide), GetCells(narrow));
  for (vtkIdType i = 0; i < wide->GetNumberOfPoints(); ++i)
  {
    EXPECT_NEAR(GetPoint(wide, i)[0], GetPoint(narrow, i)[0], 1e-5);
  }
}

/// Control points belong to a degree, and all cells of a mesh have the same one.
TEST(BezierOutput, FacesHaveTheControlPointsOfWhatTheyBound)
{
  for (const bool areFirst : { false, true })
  {
    const Grid bezier =
      MakeBezier(MakeMixed(areFirst), 1, [](Filter* filter) { filter->SetBezierTolerance(1.); });
    std::map<int, std::set<vtkIdType>> sizes;
    std::vector<std::set<vtkIdType>> cells;
    for (vtkIdType c = 0; c < bezier->GetNumberOfCells(); ++c)
    {
      const Ids ids = GetCell(bezier, c);
      cells.emplace_back(ids.begin(), ids.end());
      sizes[bezier->GetCellType(c)].insert(bezier->GetCells()->GetCellSize(c));
    }
    ASSERT_EQ(bezier->GetNumberOfCells(), 16);
    EXPECT_EQ(sizes[VTK_BEZIER_CURVE], std::set<vtkIdType>{ 6 });
    EXPECT_EQ(sizes[VTK_BEZIER_TRIANGLE], std::set<vtkIdType>{ 21 });
    EXPECT_EQ(sizes[VTK_BEZIER_TETRAHEDRON], std::set<vtkIdType>{ 56 });
    for (vtkIdType a = 0; a < bezier->GetNumberOfCells(); ++a)
    {
      for (vtkIdType b = 0; b < bezier->GetNumberOfCells(); ++b)
      {
        std::vector<vtkIdType> common;
        std::set_intersection(cells[a].begin(), cells[a].end(), cells[b].begin(), cells[b].end(),
          std::back_inserter(common));
        const std::size_t size = common.size(); // a corner, an edge, a face, or all
        EXPECT_TRUE(size < 2 || size == 6 || size == 21 || size == cells[a].size())
          << a << " " << b << " " << size;
      }
    }
  }
  const auto surface = ToSurface(MakeSheet(3, true, 0.2));
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 5, 6 });
  surface->SetLines(lines);
  const Grid bezier = MakeBezierSurface(surface, vtkSurfaceSubdivision::LOOP, 0);
  EXPECT_EQ(bezier->GetCellType(0), VTK_BEZIER_CURVE);
  EXPECT_EQ(bezier->GetCells()->GetCellSize(0), 5);
}

TEST(BezierOutput, LevelsThatSplitNothingCostNothing)
{
  for (const bool areSolids : { false, true })
  {
    const Grid input = areSolids ? MakeLattice(1) : MakeSheet(4, true, 0.1);
    const auto make = [&](int levels)
    {
      return MakeBezier(input, levels,
        [&](Filter* filter)
        {
          filter->SetBezierTolerance(0.1);
          filter->SetMaximumNumberOfCells(input->GetNumberOfCells() << (areSolids ? 12 : 6));
        });
    };
    const Grid one = make(1);
    EXPECT_EQ(one->GetNumberOfCells(), input->GetNumberOfCells());
    EXPECT_EQ(Compare(one, make(12)), "");
  }
}

TEST(BezierOutput, WarningsOfAllRoundsAreToldOnce)
{
  const Grid input = MakeGrid(Shake(std::vector<Point>(6), 1.),
    { { VTK_CONVEX_POINT_SET, { 0, 1, 2, 3, 4 } }, { VTK_TRIANGLE, { 0, 1, 2 } },
      { VTK_TRIANGLE, { 0, 2, 3 } }, { VTK_TRIANGLE, { 0, 3, 4 } }, { VTK_TRIANGLE, { 0, 4, 5 } },
      { VTK_TRIANGLE, { 0, 5, 1 } } });
  vtkNew<Filter> filter;
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetInputDataObject(input);
  filter->SetNumberOfLevels(4);
  filter->SetBezierTolerance(0.);
  filter->SetOutputCellsToBezier();
  filter->Update();
  EXPECT_GT(filter->GetOutput()->GetNumberOfCells(), 5 * 16);
  EXPECT_EQ(messages->Warnings.size(), 1u);
  EXPECT_EQ(messages->CountWarnings("Passed over 1 cell"), 1);
}

TEST(BezierOutput, ValuesThatAreNotFiniteSplitNothing)
{
  const Grid input = MakeSheet(6, true, 0.2);
  const Grid without = MakeBezier(input, 3);
  for (const double value : { std::nan(""), HUGE_VAL })
  {
    const auto missing = MakeArray<vtkDoubleArray>("Missing", 1, 49, 1., 1., 1);
    missing->SetValue(24, value);
    input->GetPointData()->AddArray(missing);
    EXPECT_EQ(GetCells(MakeBezier(input, 3)), GetCells(without)) << value;
  }
}
