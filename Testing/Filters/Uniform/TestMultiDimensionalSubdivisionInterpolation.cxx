// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestMultiDimensionalSubdivisionInterpolation.cxx
 * InterpolatePoints and InterpolateArrays of vtkMultiDimensionalSubdivision.
 */
#include "FileTools.h"
#include "OperatorCacheTools.h"
#include "Turns.h"

#include "vtkSubdivisionModelSource.h"

using namespace operator_cache_tools;

namespace
{

const Configure Interpolating = [](Filter* filter)
{
  filter->InterpolatePointsOn();
  filter->InterpolateArraysOn();
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
};

/// Runs the filter; only warnings of overshoot and of inverted solids are allowed.
Grid Interpolate(vtkDataObject* input, int levels, const Configure& configure = {})
{
  vtkNew<Messages> messages;
  const Grid output =
    Execute(input, levels, configure ? And(Interpolating, configure) : Interpolating, messages);
  EXPECT_TRUE(messages->Errors.empty());
  for (const std::string& warning : messages->Warnings)
  {
    EXPECT_NE(warning.find("exceed the range"), std::string::npos) << warning;
  }
  return output;
}

/// The largest difference at the points of `given`, as a part of the range of its values.
double FindError(vtkDataArray* given, vtkDataArray* now)
{
  double range = 0.;
  double most = 0.;
  for (int c = 0; c < given->GetNumberOfComponents(); ++c)
  {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (vtkIdType i = 0; i < given->GetNumberOfTuples(); ++i)
    {
      const double value = given->GetComponent(i, c);
      low = std::min(low, value);
      high = std::max(high, value);
      most = std::max(most, std::abs(value - now->GetComponent(i, c)));
    }
    range = std::max(range, high - low);
  }
  return range > 0. ? most / range : most;
}

/// Points and arrays in double have the values of the input at its points.
void ExpectInterpolated(vtkPointSet* input, vtkUnstructuredGrid* output)
{
  ASSERT_GE(output->GetNumberOfPoints(), input->GetNumberOfPoints());
  EXPECT_LE(FindError(input->GetPoints()->GetData(), output->GetPoints()->GetData()), 1.001e-10);
  for (int a = 0; a < input->GetPointData()->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = input->GetPointData()->GetArray(a);
    if (array && array->GetDataType() == VTK_DOUBLE)
    {
      SCOPED_TRACE(array->GetName());
      vtkDataArray* now = output->GetPointData()->GetArray(array->GetName());
      EXPECT_LE(FindError(array, now), 1.001e-10);
    }
  }
}

const Configure Projected = [](Filter* filter) { filter->ProjectToLimitOn(); };
const Configure TetOct = [](Filter* filter) { filter->SetVolumeSchemeToTetOct(); };

Grid MakeBoxWithSharpness()
{
  const Grid grid = MakeMixedBox(2);
  AddArrays(grid);
  vtkNew<vtkDoubleArray> sharpness;
  sharpness->SetName("Sharpness");
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    sharpness->InsertNextValue(grid->GetCellType(cell) == VTK_LINE ? 2.75 : 0.);
  }
  grid->GetCellData()->AddArray(sharpness);
  return grid;
}

}

TEST(MultiDimensionalSubdivisionInterpolation, TheLimitPassesThroughTheInput)
{
  const std::vector<Configure> rules = { [](Filter*) {}, TetOct,
    [](Filter* filter)
    {
      filter->SetType1RuleToSharp();
      filter->SetType2RuleToSharp();
      filter->SetCreaseEndToDart();
      filter->DetectFeaturesOn();
    },
    [](Filter* filter)
    {
      filter->SetVolumeSchemeToTetOct();
      filter->SetEmbeddedCellsToSingular();
      filter->SetType1RuleToFollowDimension2();
    } };
  for (int model = 0; model < 8; ++model)
  {
    const Grid input = LoadModel(model);
    for (std::size_t rule = 0; rule < rules.size(); ++rule)
    {
      SCOPED_TRACE(testing::Message() << "model " << model << ", rules " << rule);
      ExpectInterpolated(input, Interpolate(input, 0, And(Projected, rules[rule])));
      ExpectInterpolated(input, Interpolate(input, 1, And(Projected, rules[rule])));
    }
    // Something is solved for: plain limits are elsewhere.
    EXPECT_GT(FindError(input->GetPoints()->GetData(),
                Execute(input, 0, Projected)->GetPoints()->GetData()),
      1e-3);
  }
}

TEST(MultiDimensionalSubdivisionInterpolation, WithSharpnessInterfacesAndValuesOfEachType)
{
  const Grid input = MakeBoxWithSharpness();
  std::vector<int> parts;
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    parts.push_back(static_cast<int>(cell % 3));
  }
  AddCellArray(input, "Part", parts);
  const Configure configure = And(Projected,
    [](Filter* filter)
    {
      SetCellArray(filter, 4, "Sharpness");
      SetCellArray(filter, 1, "Part");
      filter->PreserveInterfacesOn();
    });
  const Grid plain = Execute(input, 1, configure);
  for (const Configure& scheme : { Configure([](Filter*) {}), TetOct })
  {
    const Grid output = Interpolate(input, 1, And(configure, scheme));
    ExpectInterpolated(input, output);
    EXPECT_LT(FindError(input->GetPointData()->GetArray("float"),
                output->GetPointData()->GetArray("float")),
      1e-6);
  }
  const Grid output = Interpolate(input, 1, configure);
  for (const char* name : { "int", "byte", "bit", "string", "rgb", "rgba" })
  {
    EXPECT_EQ(CompareValues(output->GetPointData()->GetAbstractArray(name),
                plain->GetPointData()->GetAbstractArray(name)),
      "")
      << name << " has no control values";
  }
}

TEST(MultiDimensionalSubdivisionInterpolation, OnlyWhatIsChosen)
{
  const Grid input = MakeBoxWithSharpness();
  const auto extra = vtkSmartPointer<vtkDoubleArray>::New();
  extra->DeepCopy(input->GetPointData()->GetArray("double"));
  extra->SetName("other");
  input->GetPointData()->AddArray(extra);
  const Grid plain = Execute(input, 1);
  const Grid points = Execute(input, 1, [](Filter* filter) { filter->InterpolatePointsOn(); });
  EXPECT_EQ(CompareArrays(points->GetPointData(), plain->GetPointData(), "points"), "");
  EXPECT_NE(CompareValues(points->GetPoints()->GetData(), plain->GetPoints()->GetData()), "");
  vtkNew<Messages> messages;
  const Grid chosen = Execute(
    input, 1,
    [](Filter* filter)
    {
      filter->InterpolateArraysOn();
      filter->AddInterpolatedArray("other");
      filter->AddInterpolatedArray("int");
      filter->AddInterpolatedArray("nothing");
    },
    messages);
  EXPECT_EQ(messages->CountWarnings("array \"int\""), 1);
  EXPECT_EQ(messages->CountWarnings("array \"nothing\""), 1);
  EXPECT_EQ(CompareValues(chosen->GetPoints()->GetData(), plain->GetPoints()->GetData()), "");
  EXPECT_EQ(CompareValues(chosen->GetPointData()->GetAbstractArray("double"),
              plain->GetPointData()->GetAbstractArray("double")),
    "");
  EXPECT_NE(CompareValues(chosen->GetPointData()->GetAbstractArray("other"),
              plain->GetPointData()->GetAbstractArray("other")),
    "");
}

TEST(MultiDimensionalSubdivisionInterpolation, WeightBlends)
{
  const Grid input = MakeBoxWithSharpness();
  const auto weighted = [&](double weight)
  {
    return Interpolate(input, 1, [=](Filter* filter) { filter->SetInterpolationWeight(weight); });
  };
  const Grid plain = Execute(input, 1,
    [](Filter* filter) { filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION); });
  EXPECT_EQ(Compare(weighted(0.), plain), "");
  const Grid full = weighted(1.);
  const Grid half = weighted(0.5);
  for (vtkIdType i = 0; i < plain->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      ASSERT_NEAR(GetPoint(half, i)[c], (GetPoint(plain, i)[c] + GetPoint(full, i)[c]) / 2., 1e-14);
    }
    ASSERT_NEAR(half->GetPointData()->GetArray("double")->GetComponent(i, 0),
      (plain->GetPointData()->GetArray("double")->GetComponent(i, 0) +
        full->GetPointData()->GetArray("double")->GetComponent(i, 0)) /
        2.,
      1e-13);
  }
}

TEST(MultiDimensionalSubdivisionInterpolation, ConstantsAndValuesThatAreNotFinite)
{
  const Grid input = MakeBoxWithSharpness();
  input->GetPointData()->GetArray("double")->Fill(0.1);
  vtkDataArray* values = input->GetPointData()->GetArray("float");
  values->SetComponent(0, 0, std::numeric_limits<double>::quiet_NaN());
  const Grid output = Interpolate(input, 0);
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    ASSERT_EQ(output->GetPointData()->GetArray("double")->GetComponent(i, 0), 0.1);
    ASSERT_EQ(std::isnan(output->GetPointData()->GetArray("float")->GetComponent(i, 0)), i == 0);
  }
}

TEST(MultiDimensionalSubdivisionInterpolation, IsKeptWithTheOperator)
{
  for (const auto& run : { std::make_pair(0, false), { 2, false }, { 1, true } })
  {
    SCOPED_TRACE(testing::PrintToString(run));
    const Configure configure = And(Interpolating,
      [run](Filter* filter)
      {
        filter->SetNumberOfLevels(run.first);
        filter->SetVolumeScheme(run.second ? Filter::TET_OCT : Filter::BOX_SPLINE);
        filter->SetInterpolationWeight(0.75);
      });
    vtkNew<Filter> filter;
    configure(filter);
    const auto update = [&](vtkDataObject* input)
    {
      filter->SetInputDataObject(input);
      filter->Update();
      auto copy = Grid::New();
      copy->ShallowCopy(filter->GetOutput());
      return copy;
    };
    const auto fresh = [&](vtkDataObject* input, double weight)
    {
      vtkNew<Messages> messages;
      return Execute(input, run.first,
        And(configure,
          [=](Filter* other)
          {
            other->CacheOperatorOff();
            other->SetInterpolationWeight(weight);
          }),
        messages);
    };
    const Grid input = MakeInput();
    const Grid first = update(input);
    EXPECT_EQ(filter->GetNumberOfTopologyBuilds(), 1);
    EXPECT_EQ(Compare(first, fresh(input, 0.75)), "");
    const Grid changed = DeepCopy(input);
    vtkDataArray* scalar = changed->GetPointData()->GetArray("scalar");
    for (vtkIdType i = 0; i < scalar->GetNumberOfTuples(); ++i)
    {
      scalar->SetComponent(i, 0, std::sin(static_cast<double>(i)));
    }
    const Grid second = update(changed);
    EXPECT_TRUE(SharesCells(first, second) && SharesPoints(first, second));
    EXPECT_EQ(Compare(second, fresh(changed, 0.75)), "");
    filter->SetInterpolationWeight(0.5);
    const Grid third = update(changed);
    EXPECT_FALSE(SharesPoints(second, third)) << "they were moved by another weight";
    EXPECT_EQ(Compare(third, fresh(changed, 0.5)), "");
    const Point p = GetPoint(changed, 13);
    MovePoint(changed, 13, p[0] + 1e-7, p[1], p[2]); // diagonals stay
    EXPECT_EQ(Compare(update(changed), fresh(changed, 0.5)), "");
    EXPECT_EQ(filter->GetNumberOfTopologyBuilds(), 1);
    filter->SetInterpolationWeight(0.);
    EXPECT_EQ(Compare(update(changed), fresh(changed, 0.)), "");
    EXPECT_EQ(filter->GetNumberOfTopologyBuilds(), 2);
  }
}

TEST(MultiDimensionalSubdivisionInterpolation, FiltersInARow)
{
  const Grid input = MakeBoxWithSharpness();
  for (const Configure& scheme : { Configure([](Filter*) {}), TetOct })
  {
    const Grid once = Interpolate(input, 2, scheme);
    const Grid first = Interpolate(input, 1, scheme);
    EXPECT_EQ(Compare(once, Interpolate(first, 1, scheme)), "") << "solved for once";
    EXPECT_EQ(Compare(once, Execute(first, 1, scheme)), "");
    const Grid plain = Execute(input, 1, scheme);
    vtkNew<Messages> messages;
    const Grid late = Execute(plain, 1, And(Interpolating, scheme), messages);
    EXPECT_EQ(messages->CountWarnings("did not interpolate"), 1);
    EXPECT_EQ(Compare(late, Execute(plain, 1, scheme)), "");
  }
}

/// Values that interpolate exceed the range that they are given, and a warning counts them.
TEST(MultiDimensionalSubdivisionInterpolation, OvershootIsCounted)
{
  std::vector<Point> points;
  Ids line;
  vtkNew<vtkDoubleArray> step;
  step->SetName("step");
  for (int i = 0; i < 8; ++i)
  {
    points.push_back({ i * 1., 0., 0. });
    line.push_back(i);
    step->InsertNextValue(i < 4 ? 0. : 1.);
  }
  const Grid input = MakeGrid(points, { { VTK_POLY_LINE, line } });
  input->GetPointData()->AddArray(step);
  vtkNew<Messages> messages;
  const Grid output = Execute(input, 2, Interpolating, messages);
  vtkIdType count = 0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double value = output->GetPointData()->GetArray("step")->GetComponent(i, 0);
    count += value < -1e-9 || value > 1. + 1e-9 ? 1 : 0;
  }
  EXPECT_GT(count, 0);
  EXPECT_EQ(messages->CountWarnings(std::to_string(count) + " of " +
              std::to_string(output->GetNumberOfPoints()) + " values of step"),
    1);
}

TEST(MultiDimensionalSubdivisionInterpolation, SameBitsForAnyNumberOfThreads)
{
  const Grid input = MakeKuhnBox(20, 0.2, 3); // more points than a loop without threads has
  MakeInThreads([&] { return Interpolate(input, 0); });
}

TEST(MultiDimensionalSubdivisionInterpolation, Files)
{
  for (const char* name : { "line_navis_neuron.vtu", "nat_ogs_sphere_zero_volume.vtu",
         "mix_elmer_shell_on_solid.vtu", "nm_triple_vierbein.vtp", "nat_bunny_verts_dup_points.vtp",
         "tet_geos_synthetic.vtu", "large_porepy_case3_500k.vtu" })
  {
    SCOPED_TRACE(name);
    const std::string path = file_tools::GetSharedFile(name);
    if (const std::string reason = file_tools::WhyNotRead(path); !reason.empty())
    {
      GTEST_SKIP() << reason;
    }
    if (!turns::IsNextInTurn())
    {
      continue;
    }
    const auto input = file_tools::ReadFile(path);
    vtkNew<Messages> messages;
    const Grid output = Execute(input, 0, And(Interpolating, Projected), messages);
    EXPECT_EQ(messages->CountWarnings("does not pass"), 0);
    ExpectInterpolated(input, output);
  }
}
