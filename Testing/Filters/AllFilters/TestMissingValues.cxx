// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestMissingValues.cxx
 * A missing value (not a number, infinite, or masked) costs what takes it by the rows of one level
 * after the other, and nothing else, however the filter computes it.
 */
#include "FeatureTools.h"
#include "SurfaceTools.h"

#include "vtkCharArray.h"
#include "vtkSurfaceSubdivision.h"

using namespace surfacetools;
using feature_tools::MakeKuhnBox;
using multi_dimensional_subdivision_tools::Grid;
using multi_dimensional_subdivision_tools::Messages;

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinite = std::numeric_limits<double>::infinity();

using Mesh = vtkSmartPointer<vtkPointSet>;
using Set = std::function<void(vtkSubdivisionAlgorithm*)>;
/// Makes a mesh of another, with so many levels, and whether on the limit.
using Maker = std::function<Mesh(vtkPointSet*, int, bool, const Set&)>;

template <typename Filter>
Maker MakeMaker(const std::function<void(Filter*)>& choose)
{
  return [choose](vtkPointSet* input, int levels, bool limit, const Set& set)
  {
    vtkNew<Filter> filter;
    choose(filter);
    filter->SetNumberOfLevels(levels);
    filter->SetProjectToLimit(limit);
    set(filter);
    filter->SetInputDataObject(input);
    filter->Update();
    auto copy = Mesh::Take(filter->GetOutput()->NewInstance());
    copy->DeepCopy(filter->GetOutput());
    return copy;
  };
}

template <typename Array>
vtkSmartPointer<Array> AddValues(vtkPointSet* mesh, const char* name, int components)
{
  const auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    array->SetValue(
      i, static_cast<typename Array::ValueType>(std::sin(static_cast<double>(i * i))));
  }
  mesh->GetPointData()->AddArray(array);
  return array;
}

/// Which points of the output of one step take missing values, by the numbers that the filter makes
/// of 1 at one point and 0 at others.
std::vector<bool> TakeStep(
  Mesh& mesh, const Maker& make, bool limit, const std::vector<bool>& areMissing)
{
  const vtkIdType size = mesh->GetNumberOfPoints();
  const auto units = AddValues<vtkDoubleArray>(mesh, "units", static_cast<int>(size));
  for (vtkIdType i = 0; i < size * size; ++i)
  {
    units->SetValue(i, i / size == i % size ? 1. : 0.);
  }
  mesh = make(mesh, limit ? 0 : 1, limit, [](vtkSubdivisionAlgorithm*) {});
  auto* rows = vtkDoubleArray::SafeDownCast(mesh->GetPointData()->GetArray("units"));
  std::vector<bool> taken(static_cast<std::size_t>(mesh->GetNumberOfPoints()), false);
  for (vtkIdType i = 0; i < rows->GetNumberOfValues(); ++i)
  {
    taken[i / size] = taken[i / size] || (areMissing[i % size] && rows->GetValue(i) != 0.);
  }
  mesh->GetPointData()->RemoveArray("units");
  return taken;
}

std::vector<bool> FindMissing(vtkDataArray* array)
{
  std::vector<bool> found;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    found.push_back(!std::isfinite(array->GetComponent(i, 0)));
  }
  return found;
}

/// Runs all levels at once, with other arrays beside that are summed together with these.
void ExpectRowsDecide(vtkPointSet* input, const Maker& make, int levels, bool limit)
{
  SCOPED_TRACE(testing::Message() << "levels " << levels << ", limit " << limit);
  auto mesh = Mesh::Take(input->NewInstance());
  mesh->DeepCopy(input);
  const auto values = AddValues<vtkDoubleArray>(mesh, "double", 1);
  const auto floats = AddValues<vtkFloatArray>(mesh, "float", 3);
  AddValues<vtkFloatArray>(mesh, "other", 2);
  for (vtkIdType i = 1; i < mesh->GetNumberOfPoints(); i += 11)
  {
    values->SetValue(i, i % 2 == 0 ? NaN : -Infinite);
    floats->SetComponent(i, 0, i % 2 == 0 ? NaN : Infinite);
  }
  std::vector<bool> expected = FindMissing(values);
  auto step = Mesh::Take(input->NewInstance());
  step->DeepCopy(input);
  for (int level = 0; level < levels + (limit ? 1 : 0); ++level)
  {
    expected = TakeStep(step, make, level == levels, expected);
  }
  const auto output = make(mesh, levels, limit, [](vtkSubdivisionAlgorithm*) {});
  vtkPointData* data = output->GetPointData();
  EXPECT_EQ(FindMissing(data->GetArray("double")), expected);
  EXPECT_EQ(FindMissing(data->GetArray("float")), expected);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    ASSERT_TRUE(std::isfinite(data->GetArray("other")->GetComponent(i, 0)));
    ASSERT_TRUE(std::isfinite(data->GetArray("float")->GetComponent(i, 1)));
  }
}

Maker RunSolids(int scheme, bool cache)
{
  return MakeMaker<vtkMultiDimensionalSubdivision>(
    [=](vtkMultiDimensionalSubdivision* filter)
    {
      filter->SetVolumeScheme(scheme);
      filter->SetCacheOperator(cache);
    });
}

Maker RunSurfaces(int scheme, bool cache)
{
  return MakeMaker<vtkSurfaceSubdivision>(
    [=](vtkSurfaceSubdivision* filter)
    {
      filter->SetScheme(scheme);
      filter->SetCacheOperator(cache);
    });
}

}

TEST(MissingValues, CostWhatTakesThemInSolids)
{
  const Grid box = MakeKuhnBox(2, 0.2, 3);
  for (const int scheme : { 0, 1, 2 })
  {
    for (const bool cache : { false, true })
    {
      SCOPED_TRACE(testing::Message() << "scheme " << scheme << ", cache " << cache);
      for (const int levels : { 0, 1, 2 })
      {
        ExpectRowsDecide(box, RunSolids(scheme, cache), levels, false);
        ExpectRowsDecide(box, RunSolids(scheme, cache), levels, true);
      }
    }
  }
}

TEST(MissingValues, CostWhatTakesThemInSurfaces)
{
  for (int scheme = vtkSurfaceSubdivision::LOOP; scheme <= vtkSurfaceSubdivision::LINEAR; ++scheme)
  {
    const auto input = MakeInput(MakeSheet(4, 3, scheme % 2 == 0, { 1., 0., 0. }, { 0., 1., 0. }));
    for (const bool cache : { false, true })
    {
      SCOPED_TRACE(testing::Message() << "scheme " << scheme << ", cache " << cache);
      for (const int levels : { 0, 1, 3 })
      {
        ExpectRowsDecide(input, RunSurfaces(scheme, cache), levels, false);
        ExpectRowsDecide(input, RunSurfaces(scheme, cache), levels, true);
      }
    }
  }
}

// Where a mask hides values it hides what is made of them, and all other values are as ever.
TEST(MissingValues, AMaskHidesWhatIsMadeOfHiddenValues)
{
  const Grid box = MakeKuhnBox(2, 0.2, 3);
  const auto values = AddValues<vtkDoubleArray>(box, "values", 2);
  const Maker make = RunSolids(0, true);
  const Mesh plain = make(box, 2, false, [](vtkSubdivisionAlgorithm*) {});
  const auto mask = vtkSmartPointer<vtkCharArray>::New();
  mask->SetName("vtkValidPointMask");
  for (vtkIdType i = 0; i < box->GetNumberOfPoints(); ++i)
  {
    mask->InsertNextValue(i == 4 ? 0 : 1);
  }
  box->GetPointData()->AddArray(mask);
  vtkNew<Messages> messages;
  const Mesh masked =
    make(box, 2, false, [&](vtkSubdivisionAlgorithm* filter) { messages->Watch(filter); });
  vtkDataArray* made = masked->GetPointData()->GetArray("vtkValidPointMask");
  ASSERT_EQ(made->GetDataType(), VTK_CHAR);
  int hidden = 0;
  for (vtkIdType i = 0; i < masked->GetNumberOfPoints(); ++i)
  {
    const double value = masked->GetPointData()->GetArray("values")->GetComponent(i, 1);
    ASSERT_EQ(made->GetComponent(i, 0), std::isfinite(value) ? 1. : 0.);
    ASSERT_TRUE(!std::isfinite(value) ||
      value == plain->GetPointData()->GetArray("values")->GetComponent(i, 1));
    hidden += std::isfinite(value) ? 0 : 1;
  }
  EXPECT_GT(hidden, 1);
  EXPECT_LT(hidden, masked->GetNumberOfPoints());
  ASSERT_EQ(messages->Warnings.size(), 1u);
  EXPECT_EQ(
    messages->CountWarnings(
      "\"values\" at 1 of 27 points (the first is point 4), and so at " + std::to_string(hidden)),
    1);
  EXPECT_EQ(values->GetComponent(4, 0), values->GetComponent(4, 0)) << "the input stays";
}

TEST(MissingValues, AreToldOnceAndWhereSomethingIsMadeOfThem)
{
  const Grid box = MakeKuhnBox(2, 0.2, 3);
  AddValues<vtkDoubleArray>(box, "a", 1)->SetValue(3, NaN);
  AddValues<vtkFloatArray>(box, "b", 3)->SetValue(3, std::numeric_limits<float>::infinity());
  AddValues<vtkFloatArray>(box, "c", 1);
  for (const int levels : { 0, 1 })
  {
    vtkNew<Messages> messages;
    RunSolids(0, true)(
      box, levels, false, [&](vtkSubdivisionAlgorithm* filter) { messages->Watch(filter); });
    ASSERT_EQ(messages->Warnings.size(), static_cast<std::size_t>(levels));
    EXPECT_EQ(messages->CountWarnings("\"a\" at 1 of 27 points (the first is point 3)"), levels);
    EXPECT_EQ(messages->CountWarnings("\"b\" at 1 of 27 points (the first is point 1)"), levels);
    EXPECT_EQ(messages->CountWarnings("\"c\""), 0);
  }
}

// Cells are split where the limit is not a polynomial, and not where it is no number.
TEST(MissingValues, DoNotSplitBezierCells)
{
  const Grid box = MakeKuhnBox(2, 0., 3);
  const auto values = AddValues<vtkDoubleArray>(box, "values", 1);
  vtkIdType cells[2];
  for (const double value : { 0.5, NaN })
  {
    values->SetValue(4, value);
    const Mesh output = RunSolids(2, true)(box, 1, false,
      [](vtkSubdivisionAlgorithm* filter)
      {
        auto* own = vtkMultiDimensionalSubdivision::SafeDownCast(filter);
        own->SetOutputCells(vtkMultiDimensionalSubdivision::BEZIER_CELLS);
      });
    cells[std::isnan(value) ? 1 : 0] = output->GetNumberOfCells();
  }
  EXPECT_EQ(cells[1], cells[0]);
}
