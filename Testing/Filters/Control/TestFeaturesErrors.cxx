// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestFeaturesErrors.cxx
 * Arrays that cannot be used are named; names that are not set mean what the class says.
 */
#include "FeatureTools.h"

using namespace feature_tools;

namespace
{

/// A fan with lines 0 1 and 0 4, not flagged.
Grid MakeLines()
{
  return MakeFan(6, { { VTK_LINE, { 0, 1 } }, { VTK_LINE, { 0, 4 } } });
}

const std::vector<int> LineFlags = { 0, 0, 0, 0, 0, 0, 1, 1 };

/// One error that holds all of `parts`, and no output.
void ExpectError(
  vtkUnstructuredGrid* grid, const Configure& configure, const std::vector<std::string>& parts)
{
  vtkNew<Messages> messages;
  const Grid output = Execute(grid, 1, configure, messages);
  EXPECT_EQ(output->GetNumberOfCells(), 0);
  int found = 0;
  for (const std::string& text : messages->Errors)
  {
    found += std::all_of(parts.begin(), parts.end(),
      [&text](const std::string& part) { return text.find(part) != std::string::npos; });
  }
  EXPECT_EQ(found, 1) << parts[0];
  EXPECT_EQ(messages->Warnings.size(), 0u);
}

Configure Named(int index, const char* name)
{
  return [index, name](Filter* filter) { SetCellArray(filter, index, name); };
}

std::string IndexText(int index)
{
  return "index " + std::to_string(index);
}

template <typename Array>
Grid WithArray(const char* name, int components, vtkIdType tuples)
{
  const Grid grid = MakeLines();
  grid->GetCellData()->AddArray(MakeArray<Array>(name, components, tuples, 0., 2., 3));
  return grid;
}

}

TEST(FeaturesErrors, NamedArrayIsMissing)
{
  for (int index = 0; index < 4; ++index)
  {
    ExpectError(MakeLines(), Named(index, "Veins"), { "\"Veins\"", IndexText(index) });
    // A point array of that name is none.
    const Grid grid = MakeLines();
    grid->GetPointData()->AddArray(MakeArray<vtkIntArray>("Veins", 1, 7, 0., 2., 1));
    ExpectError(grid, Named(index, "Veins"), { "\"Veins\"", IndexText(index) });
  }
}

TEST(FeaturesErrors, NamedArrayOfTheWrongKind)
{
  for (int index = 0; index < 4; ++index)
  {
    ExpectError(
      WithArray<vtkIntArray>("a", 2, 8), Named(index, "a"), { "\"a\"", IndexText(index) });
    ExpectError(WithArray<vtkIntArray>("a", 1, 7), Named(index, "a"),
      { "\"a\"", IndexText(index), "7 values for 8 cells" });
    ExpectError(WithArray<vtkIntArray>("a", 1, 9), Named(index, "a"),
      { "\"a\"", IndexText(index), "9 values for 8 cells" });
    const Grid strings = MakeLines();
    strings->GetCellData()->AddArray(MakeNames("a", 8));
    ExpectError(strings, Named(index, "a"), { "\"a\"", IndexText(index) });
    if (index != 1) // materials may be of any numbers
    {
      for (const Grid& grid :
        { WithArray<vtkFloatArray>("a", 1, 8), WithArray<vtkDoubleArray>("a", 1, 8) })
      {
        ExpectError(grid, Named(index, "a"), { "\"a\"", IndexText(index), "integer" });
      }
    }
  }
}

TEST(FeaturesErrors, MaterialsMayBeFloating)
{
  const Grid grid = MakeFan(6);
  vtkNew<vtkDoubleArray> density;
  density->SetName("density");
  for (double value : { 0.25, 0.25, 0.25, 0.5, 0.5, 0.5 })
  {
    density->InsertNextValue(value);
  }
  grid->GetCellData()->AddArray(density);
  const Matrix matrix(grid,
    [](Filter* filter)
    {
      SetCellArray(filter, 1, "density");
      filter->PreserveInterfacesOn();
    });
  EXPECT_TRUE(Near(matrix.Vertex(0), CurveVertex(0, 1, 4)));
}

TEST(FeaturesErrors, MaterialsOf64Bits)
{
  // Hashes that a double cannot tell apart.
  const Grid grid = MakeFan(6);
  vtkNew<vtkIdTypeArray> hash;
  hash->SetName("hash");
  for (vtkIdType i = 0; i < 6; ++i)
  {
    hash->InsertNextValue((vtkIdType(1) << 60) + (i < 3 ? 0 : 1));
  }
  grid->GetCellData()->AddArray(hash);
  const Matrix matrix(grid,
    [](Filter* filter)
    {
      SetCellArray(filter, 1, "hash");
      filter->PreserveInterfacesOn();
    });
  EXPECT_TRUE(Near(matrix.Vertex(0), CurveVertex(0, 1, 4)));
}

TEST(FeaturesErrors, InterfacesNeedMaterials)
{
  ExpectError(
    MakeLines(), [](Filter* filter) { filter->PreserveInterfacesOn(); }, { "PreserveInterfaces" });
  ExpectError(MakeLines(),
    [](Filter* filter)
    {
      filter->PreserveInterfacesOn();
      SetCellArray(filter, 1, "None");
    },
    { "PreserveInterfaces" });
}

TEST(FeaturesErrors, TheNextExecutionIsFine)
{
  vtkNew<Messages> messages;
  vtkNew<Filter> filter;
  messages->Watch(filter);
  filter->SetInputData(With(MakeLines(), "flags", LineFlags));
  SetCellArray(filter, 0, "Veins");
  filter->Update();
  EXPECT_FALSE(messages->Errors.empty());
  messages->Errors.clear();
  SetCellArray(filter, 0, "flags");
  filter->Update();
  EXPECT_TRUE(messages->Errors.empty());
  const Grid fresh = Execute(With(MakeLines(), "flags", LineFlags), 1, Named(0, "flags"));
  EXPECT_EQ(Compare(filter->GetOutput(), fresh), "");
}

TEST(FeaturesErrors, UnsetNames)
{
  const MatrixRow crease = CurveVertex(0, 1, 4);
  const MatrixRow smooth = SurfaceVertex(0, { 1, 2, 3, 4, 5, 6 });
  const Grid standard = With(MakeLines(), "Singular", LineFlags);
  const Grid other = With(MakeLines(), "flags", LineFlags);
  for (const char* name : { "", "None" })
  {
    EXPECT_TRUE(Near(Matrix(standard, Named(0, name)).Vertex(0), crease)) << name;
    EXPECT_TRUE(Near(Matrix(other, Named(0, name)).Vertex(0), smooth)) << name;
    const Configure asPoints = [name](Filter* filter)
    {
      for (int index = 0; index < 4; ++index)
      {
        filter->SetInputArrayToProcess(
          index, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS, name);
      }
    };
    EXPECT_TRUE(Near(Matrix(standard, asPoints).Vertex(0), crease)) << name;
  }
  EXPECT_TRUE(Near(Matrix(standard).Vertex(0), crease));
  EXPECT_TRUE(Near(Matrix(other).Vertex(0), smooth));
  EXPECT_TRUE(Near(Matrix(other, Named(0, "flags")).Vertex(0), crease));
  // A name wins over the standard one.
  const Grid both = With(standard, "flags", std::vector<int>(8, 0));
  EXPECT_TRUE(Near(Matrix(both, Named(0, "flags")).Vertex(0), smooth));
}

TEST(FeaturesErrors, UnsetMaterialsPartsAndRules)
{
  const Configure interfaces = [](Filter* filter) { filter->PreserveInterfacesOn(); };
  const Grid fan = With(MakeFan(6), "MaterialId", { 1, 1, 1, 2, 2, 2 });
  EXPECT_TRUE(Near(Matrix(fan, interfaces).Vertex(0), CurveVertex(0, 1, 4)));
  EXPECT_TRUE(Near(Matrix(fan).Vertex(0), SurfaceVertex(0, { 1, 2, 3, 4, 5, 6 })));
  // Index 2 and 3 have no standard name.
  const Grid book = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0, -1, -1 } },
    { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 0, 1, 3 } },
      { VTK_TRIANGLE, { 0, 1, 4 } } });
  for (const char* name : { "Part", "PartId", "PartArray", "Parts" })
  {
    AddCellArray(book, name, { 1, 1, 2 });
  }
  for (const char* name : { "Rule", "RuleArray", "Rules" })
  {
    AddCellArray(book, name, { 2, 2, 2 });
  }
  const Matrix matrix(book, [](Filter* filter) { filter->SetType2RuleToFollowPart(); });
  EXPECT_TRUE(Near(matrix.Edge(0, 1), SolidEdge(0, 1, { 2, 3, 4 })));
}

TEST(FeaturesErrors, StandardArrayThatCannotBeUsed)
{
  vtkNew<Messages> messages;
  const Grid grid = WithArray<vtkDoubleArray>("Singular", 1, 8);
  const Matrix matrix(grid, {}, messages);
  EXPECT_EQ(messages->Warnings.size(), 1u);
  EXPECT_EQ(messages->CountWarnings("\"Singular\""), 1);
  EXPECT_TRUE(Near(matrix.Vertex(0), SurfaceVertex(0, { 1, 2, 3, 4, 5, 6 })));
}

TEST(FeaturesErrors, ContradictoryFlagsOfEqualCells)
{
  std::vector<int> flags = { 0, 0, 0, 0, 0, 0, 1, 1, 0 };
  const Grid grid =
    MakeFan(6, { { VTK_LINE, { 0, 1 } }, { VTK_LINE, { 0, 4 } }, { VTK_LINE, { 1, 0 } } });
  AddCellArray(grid, "veins", flags);
  vtkNew<Messages> messages;
  const Matrix matrix(grid, Named(0, "veins"), messages);
  EXPECT_EQ(messages->Warnings.size(), 1u);
  EXPECT_EQ(messages->CountWarnings("\"veins\""), 1);
  ASSERT_FALSE(messages->Warnings.empty());
  const std::string text = messages->Warnings[0];
  EXPECT_NE(text.find('6'), std::string::npos) << text;
  EXPECT_NE(text.find('8'), std::string::npos) << text;
  EXPECT_TRUE(Near(matrix.Edge(0, 1), CurveEdge(0, 1)));
}

TEST(FeaturesErrors, ContradictoryFlagsOfEqualVertices)
{
  const Grid grid = MakeFan(6, { { VTK_VERTEX, { 0 } }, { VTK_VERTEX, { 0 } } });
  AddCellArray(grid, "veins", { 0, 0, 0, 0, 0, 0, 0, 1 });
  vtkNew<Messages> messages;
  const Matrix matrix(grid, Named(0, "veins"), messages);
  EXPECT_EQ(messages->CountWarnings("\"veins\""), 1);
  EXPECT_EQ(messages->CountWarnings("6 and 7"), 1);
  EXPECT_TRUE(Near(matrix.Vertex(0), Corner(0)));
}
