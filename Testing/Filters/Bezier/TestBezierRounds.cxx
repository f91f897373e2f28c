// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestBezierRounds.cxx
 * Levels that only some Bezier cells need: they are made for these alone, and the cells are those
 * that whole levels give.
 */
#include "BezierTools.h"
#include "Turns.h"

#include "vtkSubdivisionCageSource.h"
#include "vtkSubdivisionModelSource.h"

using namespace bezier_tools;

namespace
{

using Surface = vtkSurfaceSubdivision;

template <typename FilterClass>
Grid RunFilter(
  FilterClass* filter, vtkDataObject* input, const std::function<void(FilterClass*)>& set)
{
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetInputDataObject(input);
  filter->SetOutputCellsToBezier();
  set(filter);
  filter->Update();
  EXPECT_TRUE(messages->Errors.empty()) << messages->Errors[0];
  vtkDataObject* output = filter->GetOutputDataObject(0);
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(output);
  const auto copy = Grid::New();
  copy->DeepCopy(blocks ? blocks->GetBlock(0) : output);
  return copy;
}

/// Levels of data sets of blocks are always made as a whole.
template <typename FilterClass>
Grid MakeWhole(vtkDataObject* input, const std::function<void(FilterClass*)>& set)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, input);
  vtkNew<FilterClass> filter;
  return RunFilter<FilterClass>(filter, blocks, set);
}

void ExpectNear(vtkDataArray* a, vtkDataArray* b, double tolerance, const std::string& name)
{
  ASSERT_EQ(a->GetNumberOfValues(), b->GetNumberOfValues());
  double most = 0.;
  for (vtkIdType i = 0; i < a->GetNumberOfValues(); ++i)
  {
    const int components = a->GetNumberOfComponents();
    most = std::max(most,
      std::abs(a->GetComponent(i / components, int(i % components)) -
        b->GetComponent(i / components, int(i % components))));
  }
  EXPECT_LE(most, tolerance) << name;
}

/// Returns how many cells there are.
template <typename FilterClass>
vtkIdType ExpectWhole(
  vtkDataObject* input, const std::string& name, const std::function<void(FilterClass*)>& set)
{
  vtkNew<FilterClass> filter;
  const Grid made = RunFilter<FilterClass>(filter, input, set);
  const Grid whole = MakeWhole<FilterClass>(input, set);
  EXPECT_EQ(GetCells(made), GetCells(whole)) << name;
  for (vtkIdType c = 0; c < made->GetNumberOfCells(); ++c)
  {
    EXPECT_EQ(made->GetCellType(c), whole->GetCellType(c)) << name;
  }
  ExpectNear(
    made->GetPoints()->GetData(), whole->GetPoints()->GetData(), 1e-12 * whole->GetLength(), name);
  for (const bool ofPoints : { true, false })
  {
    vtkFieldData* a = made->GetPointData();
    vtkFieldData* b = whole->GetPointData();
    if (!ofPoints)
    {
      a = made->GetCellData();
      b = whole->GetCellData();
    }
    EXPECT_EQ(a->GetNumberOfArrays(), b->GetNumberOfArrays()) << name;
    for (int i = 0; i < b->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = b->GetArray(i);
      vtkDataArray* own = a->GetArray(array->GetName());
      const bool isReal = array->GetDataType() == VTK_DOUBLE || array->GetDataType() == VTK_FLOAT;
      ExpectNear(own, array, isReal ? 1e-12 * (1. + array->GetMaxNorm()) : 0.,
        name + " " + array->GetName());
    }
  }
  return made->GetNumberOfCells();
}

vtkSmartPointer<vtkUnstructuredGrid> MakeModel(int model)
{
  const Grid mesh = LoadModel(model);
  vtkNew<vtkIntArray> numbers; // no mean can be taken of these
  numbers->SetName("Number");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    numbers->InsertNextValue(static_cast<int>(7 * i % 101));
  }
  mesh->GetPointData()->AddArray(numbers);
  return mesh;
}

}

TEST(BezierRounds, SolidsAreThoseOfWholeLevels)
{
  const std::pair<int, double> cases[] = { { vtkSubdivisionModelSource::SCREW, 5e-3 },
    { vtkSubdivisionModelSource::MIXED_DIMENSIONS, 1e-3 },
    { vtkSubdivisionModelSource::MATERIAL_BLOCK, 1e-3 } };
  for (const auto& [model, tolerance] : turns::Some(cases))
  {
    const bool hasMaterials = model == vtkSubdivisionModelSource::MATERIAL_BLOCK;
    const vtkIdType cells = ExpectWhole<Filter>(MakeModel(model), std::to_string(model),
      [&, part = tolerance](Filter* filter)
      {
        filter->SetNumberOfLevels(2);
        filter->SetBezierTolerance(part);
        filter->GenerateOriginalIdsOn();
        filter->SetPreserveInterfaces(hasMaterials);
      });
    EXPECT_GT(cells, 100);
  }
}

/// Here limits depend on midpoints of edges that are not at the cells that go on.
TEST(BezierRounds, ASharpCornerIsThatOfWholeLevels)
{
  vtkNew<vtkSubdivisionCageSource> source;
  source->Update();
  vtkUnstructuredGrid* input = source->GetOutput();
  const vtkIdType last = input->GetNumberOfPoints() - 1;
  input->GetPoints()->SetPoint(last, 1.3, 1.3, 1.3);
  const vtkIdType cells = ExpectWhole<Filter>(input, "",
    [](Filter* filter)
    {
      filter->SetNumberOfLevels(2);
      filter->SetBezierTolerance(3e-3);
      filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    });
  EXPECT_GT(cells, 48);
  EXPECT_LT(cells, 48 * 8 * 4);
}

TEST(BezierRounds, ThreeLevelsOfSolidsAreThoseOfWholeLevels)
{
  ExpectWhole<Filter>(MakeModel(vtkSubdivisionModelSource::SCREW), "",
    [](Filter* filter)
    {
      filter->SetNumberOfLevels(3);
      filter->SetBezierTolerance(5e-3);
    });
}

TEST(BezierRounds, MixedCellsAreThoseOfWholeLevels)
{
  for (const bool areFirst : { false, true })
  {
    const Grid input = MakeMixed(areFirst);
    AddScalar(input);
    for (const double tolerance : { 1e-2, 2e-3, 1e-4 })
    {
      ExpectWhole<Filter>(input, std::to_string(tolerance),
        [&](Filter* filter)
        {
          filter->SetNumberOfLevels(2);
          filter->SetBezierTolerance(tolerance);
          filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
        });
    }
  }
}

TEST(BezierRounds, SemiSharpCreasesAreThoseOfWholeLevels)
{
  const Grid input = MakeModel(vtkSubdivisionModelSource::MIXED_DIMENSIONS);
  const auto sharpness =
    MakeArray<vtkDoubleArray>("Sharpness", 1, input->GetNumberOfCells(), 0.2, 2.4, 2);
  input->GetCellData()->AddArray(sharpness);
  ExpectWhole<Filter>(input, "solids",
    [](Filter* filter)
    {
      filter->SetNumberOfLevels(2);
      filter->SetBezierTolerance(1e-3);
      filter->SetInputArrayToProcess(4, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Sharpness");
    });
  for (const int scheme : { Surface::LOOP, Surface::CATMULL_CLARK })
  {
    ExpectWhole<Surface>(input, "surfaces",
      [scheme](Surface* filter)
      {
        filter->SetScheme(scheme);
        filter->SetNumberOfLevels(4);
        filter->SetBezierTolerance(1e-4);
        filter->SetInputArrayToProcess(
          4, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Sharpness");
      });
  }
}

TEST(BezierRounds, SurfacesAreThoseOfWholeLevels)
{
  for (const int scheme : { Surface::LOOP, Surface::CATMULL_CLARK })
  {
    for (const int model :
      { vtkSubdivisionModelSource::MIXED_DIMENSIONS, vtkSubdivisionModelSource::SCREW })
    {
      const Grid input = MakeModel(model);
      for (const double tolerance : turns::Some({ 1e-3, 1e-5 }))
      {
        ExpectWhole<Surface>(input, std::to_string(scheme) + " " + std::to_string(model),
          [&](Surface* filter)
          {
            filter->SetScheme(scheme);
            filter->SetNumberOfLevels(4);
            filter->SetBezierTolerance(tolerance);
            filter->GenerateOriginalIdsOn();
          });
      }
    }
    ExpectWhole<Surface>(ToSurface(MakeTrapezohedron(5)), "trapezohedron",
      [&](Surface* filter)
      {
        filter->SetScheme(scheme);
        filter->SetNumberOfLevels(6);
        filter->SetBezierTolerance(1e-5);
      });
  }
}

/// Options for which levels are made as a whole.
TEST(BezierRounds, OptionsThatNeedAllCellsGetThem)
{
  const Grid input = MakeModel(vtkSubdivisionModelSource::SCREW);
  for (const int option : turns::Some({ 0, 1, 2, 3 }))
  {
    ExpectWhole<Filter>(input, std::to_string(option),
      [option](Filter* filter)
      {
        filter->SetNumberOfLevels(2);
        filter->SetBezierTolerance(1e-3);
        filter->SetGenerateLimitNormals(option == 0);
        filter->SetGenerateClassification(option == 1);
        filter->SetInterpolatePoints(option == 2);
        filter->SetOutputDimensions(option == 3 ? 1 << 3 : Filter::ALL_DIMENSIONS);
      });
  }
}

/// As a whole the last levels would have billions of cells.
TEST(BezierRounds, CostWhatIsSplit)
{
  constexpr int levels = 12;
  const Grid input = MakeOctahedron();
  vtkNew<Filter> filter;
  const Grid made = RunFilter<Filter>(filter, input,
    [](Filter* f)
    {
      f->SetNumberOfLevels(levels);
      f->SetBezierTolerance(1e-9);
    });
  EXPECT_GT(made->GetNumberOfCells(), 8 * 4 * 3);
  EXPECT_LT(made->GetNumberOfCells(), 100000);
  for (const int scheme : { Surface::LOOP, Surface::CATMULL_CLARK })
  {
    vtkNew<Surface> surface;
    const Grid faces = RunFilter<Surface>(surface, ToSurface(input),
      [scheme](Surface* f)
      {
        f->SetScheme(scheme);
        f->SetNumberOfLevels(levels);
        f->SetBezierTolerance(1e-9);
      });
    EXPECT_GT(faces->GetNumberOfCells(), 8 * 4 * 3);
    EXPECT_LT(faces->GetNumberOfCells(), 100000);
  }
}

TEST(BezierRounds, MaximumNumberOfCellsCountsBezierCells)
{
  const Grid input = MakeModel(vtkSubdivisionModelSource::SCREW);
  const auto set = [](Filter* filter)
  {
    filter->SetNumberOfLevels(2);
    filter->SetBezierTolerance(1e-3);
  };
  vtkNew<Filter> first;
  const vtkIdType cells = RunFilter<Filter>(first, input, set)->GetNumberOfCells();
  for (const vtkIdType maximum : { cells, cells - 1 })
  {
    vtkNew<Filter> filter;
    vtkNew<Messages> messages;
    messages->Watch(filter);
    filter->SetInputData(input);
    filter->SetOutputCellsToBezier();
    set(filter);
    filter->SetMaximumNumberOfCells(maximum);
    filter->Update();
    const bool isEnough = maximum == cells;
    EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), isEnough ? cells : 0);
    ASSERT_EQ(messages->Errors.empty(), isEnough);
    if (!isEnough)
    {
      EXPECT_NE(messages->Errors[0].find("BezierTolerance = 0.001 would make " +
                  std::to_string(cells) + " Bezier cells, which is above MaximumNumberOfCells = " +
                  std::to_string(maximum) + ". Use a larger BezierTolerance"),
        std::string::npos)
        << messages->Errors[0];
    }
  }
}

TEST(BezierRounds, DoNotDependOnThreads)
{
  const Grid input = MakeModel(vtkSubdivisionModelSource::SCREW);
  MakeInThreads(
    [&] { return MakeBezier(input, 2, [](Filter* filter) { filter->SetBezierTolerance(1e-3); }); });
}
