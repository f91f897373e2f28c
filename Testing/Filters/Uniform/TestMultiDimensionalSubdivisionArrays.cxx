// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestMultiDimensionalSubdivisionArrays.cxx
 * Arrays by kind: what is smoothed, rounded, inherited, dropped, made.
 */
#include "MultiDimensionalSubdivisionTools.h"

#include "vtkCharArray.h"
#include "vtkInformation.h"
#include "vtkLongArray.h"
#include "vtkLongLongArray.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkShortArray.h"
#include "vtkSignedCharArray.h"
#include "vtkUnsignedIntArray.h"
#include "vtkUnsignedLongLongArray.h"
#include "vtkUnsignedShortArray.h"
#include "vtkVariantArray.h"

using namespace multi_dimensional_subdivision_tools;

namespace
{

/// A curve through three points: 0, 1, 2; global ids 30, 20, 10 on request.
Grid MakeCurve(bool globalIds = false, int type = VTK_DOUBLE)
{
  const Grid grid = MakeGrid({ { 0, 0, 0 }, { 1, 2, 0 }, { 3, 0, 4 } },
    { { VTK_LINE, { 0, 1 } }, { VTK_LINE, { 1, 2 } } }, type);
  if (globalIds)
  {
    vtkNew<vtkIdTypeArray> ids;
    ids->SetName("ids");
    for (vtkIdType id : { 30, 20, 10 })
    {
      ids->InsertNextValue(id);
    }
    grid->GetPointData()->SetGlobalIds(ids);
  }
  return grid;
}

/// Points of the curve after one level, in their order along it.
std::array<vtkIdType, 5> Along(vtkUnstructuredGrid* one)
{
  return { 0, GetCell(one, 0)[1], 1, GetCell(one, 2)[1], 2 };
}

/// Values at the vertices, and those expected along the curve after one level.
template <typename Array>
void ExpectValues(const std::array<double, 3>& values, const std::array<double, 5>& expected,
  Options options, bool globalIds = false, int components = 1)
{
  const Grid grid = MakeCurve(globalIds);
  vtkNew<Array> array;
  SCOPED_TRACE(array->GetClassName());
  array->SetName("a");
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(3);
  for (int i = 0; i < 3; ++i)
  {
    for (int k = 0; k < components; ++k)
    {
      array->SetComponent(i, k, k + 1 == components ? values[i] : 0.);
    }
  }
  grid->GetPointData()->AddArray(array);
  const Grid one = Subdivide(grid, options);
  vtkDataArray* result = one->GetPointData()->GetArray("a");
  ASSERT_TRUE(result);
  EXPECT_EQ(result->GetDataType(), array->GetDataType());
  ASSERT_EQ(result->GetNumberOfComponents(), components);
  ASSERT_EQ(result->GetNumberOfTuples(), 5);
  for (int i = 0; i < 5; ++i)
  {
    EXPECT_EQ(result->GetComponent(Along(one)[i], components - 1), expected[i]) << i;
    if (components > 1)
    {
      EXPECT_EQ(result->GetComponent(Along(one)[i], 0), 0.);
    }
  }
}

/// The rule for integers: labels, or means that are rounded.
template <typename Array>
void ExpectInteger(double a, double b, double c)
{
  Options options;
  ExpectValues<Array>({ a, b, c }, { a, a, b, b, c }, options);
  ExpectValues<Array>({ a, b, c }, { a, b, b, c, c }, options, true);
  ExpectValues<Array>({ a, b, c }, { a, b, b, c, c }, options, true, 2);
  options.Integers = true;
  auto round = [](double x) { return std::floor(x + 0.5); };
  ExpectValues<Array>({ a, b, c },
    { a, round((a + b) / 2), round(0.75 * b + (a + c) / 8), round((b + c) / 2), c }, options);
}

}

TEST(MultiDimensionalSubdivisionArrays, FloatingArraysAreSmoothed)
{
  for (int components : { 1, 2, 3, 6, 9, 13 })
  {
    const Options options;
    ExpectValues<vtkDoubleArray>(
      { 1, 2, 4.5 }, { 1, 1.5, 1.5 + 5.5 / 8, 3.25, 4.5 }, options, false, components);
    ExpectValues<vtkFloatArray>(
      { 1, 2, 4.5 }, { 1, 1.5, 1.5 + 5.5 / 8, 3.25, 4.5 }, options, true, components);
    ExpectValues<vtkSOADataArrayTemplate<double>>(
      { 1, 2, 4.5 }, { 1, 1.5, 1.5 + 5.5 / 8, 3.25, 4.5 }, options, false, components);
  }
}

TEST(MultiDimensionalSubdivisionArrays, PointsAreSmoothed)
{
  const Grid one = Subdivide(MakeCurve(), 1);
  const auto along = Along(one);
  EXPECT_EQ(GetPoint(one, along[0]), (Point{ 0, 0, 0 }));
  EXPECT_EQ(GetPoint(one, along[1]), (Point{ 0.5, 1, 0 }));
  EXPECT_EQ(GetPoint(one, along[2]), (Point{ 0.75 + 0.375, 1.5, 0.5 }));
  EXPECT_EQ(GetPoint(one, along[3]), (Point{ 2, 1, 2 }));
  EXPECT_EQ(GetPoint(one, along[4]), (Point{ 3, 0, 4 }));
}

TEST(MultiDimensionalSubdivisionArrays, RowsAreSummedInDouble)
{
  // In float, 2^24 and 1 would lose the latter.
  ExpectValues<vtkFloatArray>(
    { 16777216, 2, -16777216 }, { 16777216, 8388609, 1.5, -8388607, -16777216 }, Options());
}

TEST(MultiDimensionalSubdivisionArrays, IntegersAreLabels)
{
  ExpectInteger<vtkIntArray>(-7, 100000, -8);
  ExpectInteger<vtkIntArray>(-1, -2, -2);
  ExpectInteger<vtkCharArray>(7, 100, 3);
  ExpectInteger<vtkSignedCharArray>(-7, 100, -90);
  ExpectInteger<vtkShortArray>(-7, 3, 30000);
  ExpectInteger<vtkUnsignedShortArray>(7, 60000, 3);
  ExpectInteger<vtkUnsignedIntArray>(7, 4000000000., 3);
  ExpectInteger<vtkLongArray>(-7, 5e12, 3);
  ExpectInteger<vtkLongLongArray>(-7, 5e12, 3);
  ExpectInteger<vtkUnsignedLongLongArray>(7, 5e12, 3);
  ExpectInteger<vtkIdTypeArray>(7, -5, 3);
  ExpectInteger<vtkUnsignedCharArray>(7, 250, 4);
  ExpectInteger<vtkSOADataArrayTemplate<int>>(-7, 100000, -8);
}

TEST(MultiDimensionalSubdivisionArrays, ColoursAreSmoothedAndRounded)
{
  for (int components : { 3, 4 })
  {
    // 6.5 is rounded up; 255 stays 255.
    ExpectValues<vtkUnsignedCharArray>(
      { 10, 3, 255 }, { 10, 7, 35, 129, 255 }, Options(), true, components);
    ExpectValues<vtkUnsignedCharArray>(
      { 255, 255, 255 }, { 255, 255, 255, 255, 255 }, Options(), false, components);
  }
  ExpectValues<vtkUnsignedCharArray>({ 10, 3, 255 }, { 10, 10, 3, 3, 255 }, Options(), false, 2);
  ExpectValues<vtkUnsignedCharArray>({ 10, 3, 255 }, { 10, 10, 3, 3, 255 }, Options(), false, 5);
  ExpectValues<vtkSignedCharArray>({ 10, 3, 100 }, { 10, 10, 3, 3, 100 }, Options(), false, 3);
}

TEST(MultiDimensionalSubdivisionArrays, StringsBitsAndVariantsAreInherited)
{
  for (bool globalIds : { false, true })
  {
    for (bool integers : { false, true })
    {
      const Grid grid = MakeCurve(globalIds);
      grid->GetPointData()->AddArray(MakeNames("s", 3));
      vtkNew<vtkBitArray> bits;
      bits->SetName("b");
      bits->SetNumberOfComponents(2);
      vtkNew<vtkVariantArray> variants;
      variants->SetName("v");
      for (int i = 0; i < 3; ++i)
      {
        bits->InsertNextTuple2(i == 1, i == 2);
        variants->InsertNextValue(i == 1 ? vtkVariant("x") : vtkVariant(i + 0.5));
      }
      grid->GetPointData()->AddArray(bits);
      grid->GetPointData()->AddArray(variants);
      Options options;
      options.Integers = integers;
      const Grid one = Subdivide(grid, options);
      vtkPointData* data = one->GetPointData();
      const int from[5] = { 0, globalIds ? 1 : 0, 1, globalIds ? 2 : 1, 2 };
      for (const char* name : { "s", "b", "v" })
      {
        vtkAbstractArray* before = grid->GetPointData()->GetAbstractArray(name);
        vtkAbstractArray* array = data->GetAbstractArray(name);
        ASSERT_TRUE(array) << name;
        EXPECT_STREQ(array->GetClassName(), before->GetClassName());
        const int n = array->GetNumberOfComponents();
        ASSERT_EQ(n, before->GetNumberOfComponents());
        for (int i = 0; i < 5; ++i)
        {
          for (int k = 0; k < n; ++k)
          {
            EXPECT_EQ(array->GetVariantValue(Along(one)[i] * n + k).ToString(),
              before->GetVariantValue(from[i] * n + k).ToString())
              << name << i;
          }
        }
      }
    }
  }
}

TEST(MultiDimensionalSubdivisionArrays, InheritedOverLevelsFromTheSmallestGlobalId)
{
  // By hand: the middle takes the label of the earlier end, every later point that of the older of
  // its two neighbours. With 0 earlier than 1, the points 1/16 ... 10/16 have the label of 0.
  for (bool globalIds : { false, true })
  {
    const Grid grid = MakeCurve(globalIds);
    grid->GetPointData()->AddArray(MakeNames("s", 3));
    const Grid four = Subdivide(grid, 4);
    auto* names = vtkStringArray::SafeDownCast(four->GetPointData()->GetAbstractArray("s"));
    ASSERT_TRUE(names);
    const int last = globalIds ? 5 : 10;
    for (int i = 1; i <= 16; ++i)
    {
      const vtkIdType p = GetCell(four, i - 1)[1];
      EXPECT_EQ(std::string(names->GetValue(p)), i <= last ? "n0" : "n1") << i;
      const vtkIdType q = GetCell(four, 16 + i - 1)[1];
      EXPECT_EQ(std::string(names->GetValue(q)), i <= last ? "n1" : "n2") << i;
    }
  }
}

namespace
{

template <typename Array>
void AddKind(vtkDataSetAttributes* data, const char* name, int components, vtkIdType size)
{
  auto array = MakeArray<Array>(name, components, size, 0, 100, 5);
  for (int k = 0; k < components; ++k)
  {
    array->SetComponentName(k, (std::string(name) + char('a' + k)).c_str());
  }
  array->GetInformation()->Set(vtkAbstractArray::GUI_HIDE(), 1);
  array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), "furlong");
  data->AddArray(array);
}

}

TEST(MultiDimensionalSubdivisionArrays, LooksAreKept)
{
  using Attributes = vtkDataSetAttributes;
  const Grid grid = MakeMixedBox(2);
  for (Attributes* data :
    std::initializer_list<Attributes*>{ grid->GetPointData(), grid->GetCellData() })
  {
    const vtkIdType size =
      data == grid->GetPointData() ? grid->GetNumberOfPoints() : grid->GetNumberOfCells();
    AddKind<vtkIntArray>(data, "before", 1, size);
    AddKind<vtkDoubleArray>(data, "scalars", 2, size);
    AddKind<vtkFloatArray>(data, "vectors", 3, size);
    AddKind<vtkDoubleArray>(data, "coordinates", 2, size);
    AddKind<vtkDoubleArray>(data, "tensors", 9, size);
    AddKind<vtkIntArray>(data, "after", 3, size);
    data->AddArray(MakeArray<vtkBitArray>("bits", 2, size, 0, 1.9, 8));
    data->AddArray(MakeNames("strings", size));
    data->SetActiveAttribute("scalars", Attributes::SCALARS);
    data->SetActiveAttribute("vectors", Attributes::VECTORS);
    data->SetActiveAttribute("coordinates", Attributes::TCOORDS);
    data->SetActiveAttribute("tensors", Attributes::TENSORS);
  }
  for (int levels : { 0, 1, 2 })
  {
    Options options;
    options.Levels = levels;
    options.Classification = options.OriginalIds = true;
    const Grid result = Subdivide(grid, options);
    for (int i = 0; i < 2; ++i)
    {
      Attributes* from =
        i == 0 ? static_cast<Attributes*>(grid->GetPointData()) : grid->GetCellData();
      Attributes* to =
        i == 0 ? static_cast<Attributes*>(result->GetPointData()) : result->GetCellData();
      for (int a = 0; a < from->GetNumberOfArrays(); ++a)
      {
        vtkAbstractArray* before = from->GetAbstractArray(a);
        vtkAbstractArray* after = to->GetAbstractArray(before->GetName());
        ASSERT_TRUE(after) << before->GetName();
        EXPECT_EQ(to->GetAbstractArray(a), after) << "order of arrays";
        EXPECT_EQ(after->GetDataType(), before->GetDataType());
        EXPECT_EQ(after->GetNumberOfTuples(),
          i == 0 ? result->GetNumberOfPoints() : result->GetNumberOfCells());
        EXPECT_EQ(after->HasAComponentName(), before->HasAComponentName());
        for (int k = 0; before->HasAComponentName() && k < before->GetNumberOfComponents(); ++k)
        {
          EXPECT_STREQ(after->GetComponentName(k), before->GetComponentName(k));
        }
        if (before->HasInformation())
        {
          ASSERT_TRUE(after->HasInformation()) << before->GetName();
          EXPECT_STREQ(after->GetInformation()->Get(vtkDataArray::UNITS_LABEL()), "furlong");
          EXPECT_EQ(after->GetInformation()->Get(vtkAbstractArray::GUI_HIDE()), 1);
        }
      }
      for (int type = 0; type < Attributes::NUM_ATTRIBUTES; ++type)
      {
        vtkAbstractArray* a = from->GetAbstractAttribute(type);
        vtkAbstractArray* b = to->GetAbstractAttribute(type);
        EXPECT_STREQ(a ? a->GetName() : "none", b ? b->GetName() : "none");
      }
    }
  }
}

TEST(MultiDimensionalSubdivisionArrays, NoneIsLostAndTheInputIsNotTouched)
{
  const Grid grid = MakeMixedBox(2);
  AddArrays(grid);
  AddGlobalIds(grid, 2);
  grid->GetPointData()->AddArray(
    MakeArray<vtkSOADataArrayTemplate<float>>("soa", 4, grid->GetNumberOfPoints(), 0, 9, 1));
  grid->GetCellData()->AddArray(
    MakeArray<vtkSOADataArrayTemplate<float>>("soa", 4, grid->GetNumberOfCells(), 0, 9, 1));
  const Grid before = DeepCopy(grid);
  for (int levels : { 0, 1, 2 })
  {
    for (bool all : { false, true })
    {
      Options options;
      options.Levels = levels;
      options.Integers = options.OriginalIds = options.Classification = all;
      const Grid result = Subdivide(grid, options);
      vtkFieldData* from[3] = { grid->GetPointData(), grid->GetCellData(), grid->GetFieldData() };
      vtkFieldData* to[3] = { result->GetPointData(), result->GetCellData(),
        result->GetFieldData() };
      for (int i = 0; i < 3; ++i)
      {
        for (int a = 0; a < from[i]->GetNumberOfArrays(); ++a)
        {
          const char* name = from[i]->GetArrayName(a);
          EXPECT_TRUE(to[i]->HasArray(name) || std::string(name) == "GlobalIds") << name;
        }
      }
      EXPECT_EQ(CompareValues(to[2]->GetAbstractArray("names"), MakeNames("", 2)), "");
      EXPECT_EQ(to[2]->GetArray("TimeValue")->GetTuple1(0), 0.25);
      EXPECT_EQ(Compare(grid, before), "");
      vtkDataArray* smooth = result->GetPointData()->GetArray("double");
      for (vtkIdType p = 0; p < result->GetNumberOfPoints(); ++p)
      {
        for (int k = 0; k < 3; ++k)
        {
          ASSERT_TRUE(std::isfinite(GetPoint(result, p)[k]));
          ASSERT_LE(std::abs(smooth->GetComponent(p, k)), 5.); // means of what lies within
        }
      }
    }
  }
}

TEST(MultiDimensionalSubdivisionArrays, CellArraysOfAllKindsGoToTheChildren)
{
  const Grid grid = MakeMixedBox(2);
  AddArrays(grid);
  AddGlobalIds(grid, 2);
  vtkCellData* from = grid->GetCellData();
  from->AddArray(MakeArray<vtkBitArray>("bits", 3, grid->GetNumberOfCells(), 0, 1.9, 4));
  from->AddArray(
    MakeArray<vtkSOADataArrayTemplate<int>>("soa", 2, grid->GetNumberOfCells(), -9, 9, 1));
  for (int levels : { 0, 1, 2 })
  {
    Options options;
    options.Levels = levels;
    options.OriginalIds = true;
    const Grid result = Subdivide(grid, options);
    auto* origins =
      vtkIdTypeArray::SafeDownCast(result->GetCellData()->GetArray("vtkOriginalCellIds"));
    ASSERT_TRUE(origins);
    EXPECT_EQ(origins->GetNumberOfComponents(), 1);
    for (int a = 0; a < from->GetNumberOfArrays(); ++a)
    {
      vtkAbstractArray* before = from->GetAbstractArray(a);
      if (before == from->GetGlobalIds())
      {
        continue;
      }
      vtkAbstractArray* after = result->GetCellData()->GetAbstractArray(before->GetName());
      ASSERT_TRUE(after) << before->GetName();
      const int n = before->GetNumberOfComponents();
      for (vtkIdType i = 0; i < result->GetNumberOfCells(); ++i)
      {
        for (int k = 0; k < n; ++k)
        {
          ASSERT_EQ(after->GetVariantValue(i * n + k).ToString(),
            before->GetVariantValue(origins->GetValue(i) * n + k).ToString())
            << before->GetName();
        }
      }
    }
  }
}

// Pedigree ids of cells also hold for their children; all others only where nothing is new.
TEST(MultiDimensionalSubdivisionArrays, IdsAreKeptWhereTheyHold)
{
  const Grid grid = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 1 } },
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 1, 2, 3, 4 } } });
  AddGlobalIds(grid, 1);
  grid->GetPointData()->SetPedigreeIds(MakeNames("pedigree", grid->GetNumberOfPoints()));
  grid->GetCellData()->SetPedigreeIds(
    MakeArray<vtkIntArray>("pedigree", 1, grid->GetNumberOfCells(), 0, 99, 1));
  for (int levels : { 0, 1 })
  {
    Options options;
    options.Levels = levels;
    options.Integers = true;
    const Grid result = Subdivide(grid, options); // fails if anything is said
    for (const bool ofCells : { false, true })
    {
      const int type = ofCells ? vtkDataObject::CELL : vtkDataObject::POINT;
      vtkDataSetAttributes* data = result->GetAttributes(type);
      EXPECT_EQ(data->GetGlobalIds() != nullptr, levels == 0);
      EXPECT_EQ(data->GetPedigreeIds() != nullptr, levels == 0 || ofCells);
      EXPECT_EQ(data->GetNumberOfArrays(), levels == 0 ? 2 : 1); // points have their normals
      for (vtkIdType i = 0; i < (levels == 0 ? result->GetNumberOfElements(type) : 0); ++i)
      {
        EXPECT_EQ(data->GetGlobalIds()->GetVariantValue(i),
          grid->GetAttributes(type)->GetGlobalIds()->GetVariantValue(i));
      }
    }
  }
}

TEST(MultiDimensionalSubdivisionArrays, Precision)
{
  for (int given : { VTK_FLOAT, VTK_DOUBLE })
  {
    for (int levels : { 0, 1 })
    {
      for (int precision : { vtkAlgorithm::SINGLE_PRECISION, vtkAlgorithm::DOUBLE_PRECISION,
             vtkAlgorithm::DEFAULT_PRECISION })
      {
        Options options;
        options.Levels = levels;
        options.Precision = precision;
        const Grid grid = MakeCurve(false, given);
        grid->GetPointData()->AddArray(MakeArray<vtkFloatArray>("f", 1, 3, 0, 1, 1));
        const Grid result = Subdivide(grid, options);
        EXPECT_EQ(result->GetPoints()->GetDataType(),
          precision == vtkAlgorithm::SINGLE_PRECISION     ? VTK_FLOAT
            : precision == vtkAlgorithm::DOUBLE_PRECISION ? VTK_DOUBLE
                                                          : given);
        EXPECT_EQ(GetPoint(result, 1), levels ? (Point{ 1.125, 1.5, 0.5 }) : (Point{ 1, 2, 0 }));
        EXPECT_EQ(result->GetPointData()->GetArray("f")->GetDataType(), VTK_FLOAT);
        EXPECT_EQ(grid->GetPoints()->GetDataType(), given);
      }
    }
  }
  const Grid integers = MakeCurve(false, VTK_INT);
  EXPECT_EQ(GetPoint(Subdivide(integers, 1), 1), (Point{ 1.125, 1.5, 0.5 }));
}

TEST(MultiDimensionalSubdivisionArrays, OriginalIds)
{
  Options options;
  options.OriginalIds = true;
  options.Levels = 2;
  const Grid grid = MakeMixedBox(2);
  const vtkIdType size = grid->GetNumberOfPoints();
  const Grid two = Subdivide(grid, options);
  options.Levels = 1;
  const Grid chained = Subdivide(Subdivide(grid, options), options);
  for (const Grid& result : { two, chained })
  {
    auto* ids =
      vtkIdTypeArray::SafeDownCast(result->GetPointData()->GetArray("vtkOriginalPointIds"));
    ASSERT_TRUE(ids);
    for (vtkIdType i = 0; i < result->GetNumberOfPoints(); ++i)
    {
      ASSERT_EQ(ids->GetValue(i), i < size ? i : -1);
    }
    EXPECT_LT(result->GetCellData()->GetArray("vtkOriginalCellIds")->GetRange()[1],
      grid->GetNumberOfCells());
  }
  // Without a valid stamp they refer to this filter's input, whatever it brings along.
  const Grid changed = DeepCopy(chained);
  RemoveStamp(changed);
  const Grid anew = Subdivide(changed, options);
  vtkDataArray* points = anew->GetPointData()->GetArray("vtkOriginalPointIds");
  vtkDataArray* cells = anew->GetCellData()->GetArray("vtkOriginalCellIds");
  EXPECT_EQ(points->GetRange()[1], changed->GetNumberOfPoints() - 1);
  EXPECT_EQ(cells->GetRange()[1], changed->GetNumberOfCells() - 1);
  EXPECT_EQ(points->GetTuple1(changed->GetNumberOfPoints() - 1), changed->GetNumberOfPoints() - 1);
  EXPECT_EQ(points->GetTuple1(changed->GetNumberOfPoints()), -1);
  // With a stamp, but made without ids: they refer to this filter's input too.
  const Grid one = Subdivide(grid, 1);
  const Grid later = Subdivide(one, options);
  EXPECT_EQ(later->GetPointData()->GetArray("vtkOriginalPointIds")->GetRange()[1],
    one->GetNumberOfPoints() - 1);
  EXPECT_EQ(later->GetCellData()->GetArray("vtkOriginalCellIds")->GetRange()[1],
    one->GetNumberOfCells() - 1);
}

TEST(MultiDimensionalSubdivisionArrays, OfTheWrongLengthAreLeftOutWithAWarning)
{
  const Grid grid = MakeCurve();
  grid->GetPointData()->AddArray(MakeArray<vtkDoubleArray>("long", 1, 300000, 0, 1, 1));
  grid->GetPointData()->AddArray(MakeArray<vtkIntArray>("short", 1, 2, 0, 1, 1));
  grid->GetCellData()->AddArray(MakeArray<vtkIntArray>("cells", 1, 1, 0, 1, 1));
  vtkNew<Messages> messages;
  const Grid result = Subdivide(grid, Options(), messages);
  EXPECT_EQ(result->GetNumberOfCells(), 4);
  EXPECT_EQ(result->GetPointData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(result->GetCellData()->GetNumberOfArrays(), 0);
  ASSERT_EQ(messages->Warnings.size(), 3u);
  for (const char* name : { "long", "short", "cells" })
  {
    EXPECT_TRUE(std::any_of(messages->Warnings.begin(), messages->Warnings.end(),
      [name](const std::string& text) { return text.find(name) != std::string::npos; }))
      << name;
  }
}

TEST(MultiDimensionalSubdivisionArrays, OriginalIdsAreCarriedOnWhereTheyAreNotAskedForAgain)
{
  Options options;
  options.OriginalIds = true;
  const Grid first = Subdivide(MakeCurve(), options);
  const Grid second = Subdivide(first, 1);
  auto* points =
    vtkDataArray::SafeDownCast(second->GetPointData()->GetAbstractArray("vtkOriginalPointIds"));
  ASSERT_TRUE(points);
  for (vtkIdType p = 0; p < second->GetNumberOfPoints(); ++p)
  {
    EXPECT_EQ(points->GetComponent(p, 0), p < 3 ? p : -1);
  }
  EXPECT_TRUE(second->GetCellData()->HasArray("vtkOriginalCellIds"));
}

TEST(MultiDimensionalSubdivisionArrays, OriginalIdsOfASelectionGoOnInOneFilterAsInTwo)
{
  const Grid grid = MakeCurve();
  vtkNew<vtkIntArray> given;
  given->SetName("vtkOriginalPointIds");
  for (int id : { 7, 5, 9 })
  {
    given->InsertNextValue(id);
  }
  grid->GetPointData()->AddArray(given);
  for (const Grid& output : { Subdivide(grid, 2), Subdivide(Subdivide(grid, 1), 1) })
  {
    vtkDataArray* ids = output->GetPointData()->GetArray("vtkOriginalPointIds");
    ASSERT_TRUE(vtkIdTypeArray::SafeDownCast(ids));
    for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p)
    {
      EXPECT_EQ(ids->GetComponent(p, 0), p < 3 ? given->GetValue(p) : -1);
    }
  }
}

TEST(MultiDimensionalSubdivisionArrays, WhatIsMadeAnewStaysActive)
{
  const Grid grid = MakeCurve();
  grid->GetPointData()->SetScalars(MakeArray<vtkIntArray>("RuleDimension", 1, 3, 0, 1, 1));
  Options options;
  options.Classification = true;
  const Grid result = Subdivide(grid, options);
  ASSERT_TRUE(result->GetPointData()->GetScalars());
  EXPECT_STREQ(result->GetPointData()->GetScalars()->GetName(), "RuleDimension");
  EXPECT_EQ(result->GetPointData()->GetScalars()->GetNumberOfTuples(), 5);
}
