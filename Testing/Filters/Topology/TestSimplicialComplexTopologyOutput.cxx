// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSimplicialComplexTopologyOutput.cxx
 * Rules compared with those of the subdivision filter; input, output, messages and threads.
 */
#include "SimplicialComplexTopologyTools.h"

#include "vtkSubdivisionModelSource.h"

#include <sstream>

using namespace simplicial_complex_topology_tools;

// ------------------------------------------------------------------------------------------------
// Against the subdivision filter

namespace
{

Grid Classify(vtkDataObject* input, int levels, const Configure& setup)
{
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  filter->SetInputDataObject(input);
  filter->SetNumberOfLevels(levels);
  filter->GenerateClassificationOn();
  filter->SetVolumeSchemeToBoxSpline(); // vtkSimplicialComplexTopology tells of cut cells
  if (setup)
  {
    setup(filter);
  }
  filter->Update();
  return filter->GetOutput();
}

/// Rules and types are those that the filter uses, and the cells are all faces of its simplices.
void ExpectAgreement(vtkDataObject* input, const Configure& setup = nullptr)
{
  const Grid probe = Probe(input, setup);
  const Grid coarse = Classify(input, 0, setup);
  const Grid fine = Classify(input, 1, setup);
  std::map<Ids, vtkIdType> points; // where the filter has the values of vertices and edges
  std::set<Ids> simplices[4];
  vtkIdType child = 0;
  for (vtkIdType i = 0; i < coarse->GetNumberOfCells(); ++i)
  {
    const Ids cell = GetCell(coarse, i);
    const int size = static_cast<int>(cell.size());
    for (int subset = 1; subset < (1 << size); ++subset)
    {
      Ids face;
      for (int k = 0; k < size; ++k)
      {
        if (subset & (1 << k))
        {
          face.push_back(cell[k]);
        }
      }
      std::sort(face.begin(), face.end());
      simplices[face.size() - 1].insert(face);
    }
    for (int k = 0; k < size; ++k)
    {
      points[{ cell[k] }] = cell[k];
      const Ids corner = GetCell(fine, child + k);
      for (int j = 0; j < size && size > 1; ++j)
      {
        if (j != k)
        {
          points[{ std::min(cell[k], cell[j]), std::max(cell[k], cell[j]) }] = corner[j];
        }
      }
    }
    child += vtkIdType(1) << (3 * (size == 4) + 2 * (size == 3) + (size == 2));
  }
  std::vector<Ids> expected;
  for (int dimension = 0; dimension < 3; ++dimension)
  {
    expected.insert(expected.end(), simplices[dimension].begin(), simplices[dimension].end());
  }
  const std::vector<Ids> cells = GetCells(probe);
  ASSERT_EQ(cells, expected);
  Ids counts;
  for (const auto& ofDimension : simplices)
  {
    counts.push_back(static_cast<vtkIdType>(ofDimension.size()));
  }
  EXPECT_EQ(Field(probe, "SimplexCounts"), counts);
  for (const char* name : { "RuleDimension", "NonManifoldType" })
  {
    vtkDataArray* found = probe->GetCellData()->GetArray(name);
    vtkDataArray* used = fine->GetPointData()->GetArray(name);
    for (std::size_t i = 0; i < cells.size() && cells[i].size() < 3; ++i)
    {
      ASSERT_EQ(found->GetTuple1(i), used->GetTuple1(points.at(cells[i])))
        << name << " of cell " << i << ", " << cells[i].size() << " vertices";
    }
  }
}

const Configure Choices[] = { nullptr,
  [](vtkSubdivisionAlgorithm* filter)
  {
    filter->SetEmbeddedCellsToSingular();
    filter->SetCreaseEndToDart();
    filter->SetType1RuleToSharp();
    filter->SetType2RuleToSharp();
    filter->SetType3RuleToSharp();
  },
  [](vtkSubdivisionAlgorithm* filter)
  {
    filter->DetectFeaturesOn();
    filter->SetType1RuleToFollowDimension2();
  } };

}

TEST(SimplicialComplexTopologyRules, ModelsAgreeWithTheFilter)
{
  for (int model = 0; model < vtkSubdivisionModelSource::NUMBER_OF_MODELS; ++model)
  {
    SCOPED_TRACE(vtkSubdivisionModelSource::GetModelName(model));
    const Grid input = LoadModel(model);
    for (const Configure& choice : Choices)
    {
      ExpectAgreement(input, choice);
    }
    ExpectAgreement(input, [](vtkSubdivisionAlgorithm* filter) { filter->PreserveInterfacesOn(); });
    const Ids components = Field(Probe(input), "ManifoldComponents");
    ASSERT_EQ(components.size(), 4u);
    EXPECT_EQ(components[0], 0);
  }
  EXPECT_EQ(
    Field(Probe(LoadModel(vtkSubdivisionModelSource::MATERIAL_BLOCK)), "EulerCharacteristic"),
    Ids{ 1 });
  EXPECT_EQ(SingularCells(Probe(LoadModel(vtkSubdivisionModelSource::SHIP))).size(), 0u);
  EXPECT_GT(SingularCells(Probe(LoadModel(vtkSubdivisionModelSource::MECHANICAL_PART))).size(), 0u);
}

TEST(SimplicialComplexTopologyRules, MixedBoxAgreesWithTheFilter)
{
  for (const Configure& choice : Choices)
  {
    ExpectAgreement(MakeMixedBox(3), choice);
  }
}

TEST(SimplicialComplexTopologyRules, OutputOfTheFilterIsUnderstood)
{
  for (const Configure& choice : Choices)
  {
    for (int levels : { 0, 1, 2 })
    {
      const Grid input = Classify(MakeMixedBox(1), levels, choice);
      ExpectAgreement(input, choice);
      const Grid probe = Probe(input, choice);
      EXPECT_EQ(probe->GetFieldData()->GetArray("Subdivision"), nullptr);
      EXPECT_EQ(probe->GetFieldData()->GetNumberOfArrays(), 3);
      if (!choice)
      {
        const Grid plain = DeepCopy(input);
        RemoveStamp(plain);
        EXPECT_EQ(Compare(probe, Probe(plain)), "");
      }
    }
  }
}

TEST(SimplicialComplexTopologyRules, DerivedSimplicesAreInherited)
{
  const Grid input = MakeBall();
  Flag(input, { 1, 1, 1, 1, 2, 2, 2, 2 }, "MaterialId");
  const Grid once =
    Classify(input, 1, [](vtkSubdivisionAlgorithm* filter) { filter->PreserveInterfacesOn(); });
  const Grid probe = Probe(once);
  const std::vector<Ids> singular = SingularCells(probe);
  EXPECT_EQ(singular.size(), 16u);
  for (const Ids& cell : singular)
  {
    EXPECT_EQ(cell.size(), 3u);
  }
  const Grid flagged = MakeBall({ { VTK_LINE, { 6, 4 } }, { VTK_TRIANGLE, { 6, 0, 2 } } });
  Flag(flagged, { 0, 0, 0, 0, 0, 0, 0, 0, 1, 1 });
  const Grid children = Probe(Classify(flagged, 2, nullptr));
  EXPECT_EQ(SingularCells(children).size(), 4u + 16u);
}

// ------------------------------------------------------------------------------------------------
// Input and output

TEST(SimplicialComplexTopologyOutput, PointsAndArrays)
{
  const Grid input = MakeMixedBox(2, VTK_FLOAT);
  AddArrays(input);
  const Grid probe = Probe(input,
    [](vtkSubdivisionAlgorithm* filter)
    {
      filter->GenerateOriginalIdsOn();
      filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    });
  ASSERT_GE(probe->GetNumberOfPoints(), input->GetNumberOfPoints());
  EXPECT_EQ(probe->GetPoints()->GetDataType(), VTK_DOUBLE);
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(GetPoint(probe, i), GetPoint(input, i));
    EXPECT_EQ(probe->GetPointData()->GetArray("double")->GetComponent(i, 1),
      input->GetPointData()->GetArray("double")->GetComponent(i, 1));
    EXPECT_EQ(probe->GetPointData()->GetArray("vtkOriginalPointIds")->GetTuple1(i), i);
  }
  EXPECT_STREQ(probe->GetPointData()->GetScalars()->GetName(), "float");
  EXPECT_STREQ(probe->GetCellData()->GetScalars()->GetName(), "RuleDimension");
  EXPECT_EQ(probe->GetFieldData()->GetArray("TimeValue")->GetTuple1(0), 0.25);
  EXPECT_EQ(probe->GetCellData()->GetNumberOfArrays(), 8);
  const char* const classes[][2] = { { "SimplexDimension", "vtkUnsignedCharArray" },
    { "ManifoldDimensions", "vtkUnsignedCharArray" }, { "Boundary", "vtkUnsignedCharArray" },
    { "NonManifoldType", "vtkUnsignedCharArray" }, { "Singular", "vtkUnsignedCharArray" },
    { "Valence", "vtkIntArray" }, { "RuleDimension", "vtkSignedCharArray" },
    { "vtkOriginalCellIds", "vtkIdTypeArray" } };
  for (const auto& array : classes)
  {
    ASSERT_NE(probe->GetCellData()->GetArray(array[0]), nullptr) << array[0];
    EXPECT_TRUE(probe->GetCellData()->GetArray(array[0])->IsA(array[1])) << array[0];
    EXPECT_EQ(
      probe->GetCellData()->GetArray(array[0])->GetNumberOfTuples(), probe->GetNumberOfCells());
  }
}

TEST(SimplicialComplexTopologyOutput, OriginalCellIds)
{
  const Grid input = MakeComplex(9,
    { { VTK_VERTEX, { 3 } }, { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_POLY_LINE, { 5, 3, 2 } },
      { VTK_VERTEX, { 3 } }, { VTK_TRIANGLE, { 2, 1, 0 } }, { VTK_TRIANGLE, { 0, 1, 2 } } });
  const Grid probe =
    Probe(input, [](vtkSubdivisionAlgorithm* filter) { filter->GenerateOriginalIdsOn(); });
  const std::map<Ids, vtkIdType> ids = { { { 3 }, 0 }, { { 2, 3 }, 2 }, { { 3, 5 }, 2 },
    { { 0, 1, 2 }, 4 } };
  for (vtkIdType i = 0; i < probe->GetNumberOfCells(); ++i)
  {
    const auto found = ids.find(GetCell(probe, i));
    EXPECT_EQ(probe->GetCellData()->GetArray("vtkOriginalCellIds")->GetTuple1(i),
      found == ids.end() ? -1 : found->second);
  }
}

TEST(SimplicialComplexTopologyOutput, BadCellsArePassedOver)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Grid input = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { nan, 0, 1 } },
    { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 0, 1, 3 } }, { VTK_LINE, { 1, 1 } },
      { VTK_QUADRATIC_EDGE, { 0, 1, 2 } } });
  vtkNew<Messages> messages;
  const Grid probe = Probe(input, nullptr, false, messages);
  EXPECT_EQ(messages->Warnings.size(), 3u);
  EXPECT_TRUE(messages->Errors.empty());
  ExpectNumbers(probe, { 3, 3, 1, 0 }, { 0, 0, 1, 0 });
}

TEST(SimplicialComplexTopologyOutput, Empty)
{
  EXPECT_EQ(Probe(Grid::New())->GetNumberOfCells(), 0);
  ExpectNumbers(Probe(MakeComplex(3, {})), { 0, 0, 0, 0 }, { 0, 0, 0, 0 });
  vtkNew<vtkPolyData> nothing;
  EXPECT_EQ(Probe(nothing)->GetNumberOfPoints(), 0);
}

TEST(SimplicialComplexTopologyOutput, TooManyCells)
{
  const Grid input = MakeBall();
  auto most = [](vtkIdType cells)
  { return [cells](vtkSubdivisionAlgorithm* filter) { filter->SetMaximumNumberOfCells(cells); }; };
  EXPECT_EQ(Probe(input, most(45))->GetNumberOfCells(), 45);
  EXPECT_EQ(Probe(input, most(26), true)->GetNumberOfCells(), 26);
  vtkNew<Messages> messages;
  const Grid failed = Probe(input, most(44), false, messages);
  ASSERT_FALSE(messages->Errors.empty());
  EXPECT_NE(messages->Errors[0].find("MaximumNumberOfCells = 44"), std::string::npos);
  EXPECT_EQ(failed->GetNumberOfPoints(), 0);
}

TEST(SimplicialComplexTopologyOutput, PolyData)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> strips;
  for (int i = 0; i < 4; ++i)
  {
    points->InsertNextPoint(i / 2, i % 2, 0.);
  }
  const vtkIdType strip[4] = { 0, 1, 2, 3 };
  strips->InsertNextCell(4, strip);
  vtkNew<vtkPolyData> input;
  input->SetPoints(points);
  input->SetStrips(strips);
  const Grid probe = Probe(input);
  ExpectNumbers(probe, { 4, 5, 2, 0 }, { 0, 0, 1, 0 });
  EXPECT_EQ(Values(probe, { 1, 2 }), (V{ 2, 0, 0, 0, 2, 2 }));
}

TEST(SimplicialComplexTopologyOutput, Ghosts)
{
  const Grid input = MakeComplex(7,
    { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 1, 2, 3 } }, { VTK_TRIANGLE, { 4, 5, 6 } },
      { VTK_LINE, { 3, 1 } } });
  vtkUnsignedCharArray* ghosts = input->AllocateCellGhostArray();
  ghosts->SetValue(1, vtkDataSetAttributes::DUPLICATECELL);
  ghosts->SetValue(2, vtkDataSetAttributes::HIDDENCELL);
  vtkNew<Messages> messages;
  const Grid probe = Probe(input, nullptr, false, messages);
  EXPECT_EQ(messages->CountWarnings("duplicate"), 1);
  ExpectNumbers(probe, { 4, 5, 2, 0 }, { 0, 0, 1, 0 });
  vtkUnsignedCharArray* found = probe->GetCellGhostArray();
  ASSERT_NE(found, nullptr);
  const std::set<Ids> duplicates = { { 2, 3 }, { 1, 2, 3 } };
  for (vtkIdType i = 0; i < probe->GetNumberOfCells(); ++i)
  {
    EXPECT_EQ(found->GetValue(i) != 0, duplicates.count(GetCell(probe, i)) == 1);
  }
}

TEST(SimplicialComplexTopologyOutput, ThreadsDoNotMatter)
{
  const Grid input = MakeMixedBox(14);
  EXPECT_GT(MakeInThreads([&] { return Probe(input); })->GetNumberOfCells(), 50000);
}

TEST(SimplicialComplexTopologyOutput, Print)
{
  vtkNew<vtkSimplicialComplexTopology> filter;
  EXPECT_FALSE(filter->GetSpecialOnly());
  filter->SpecialOnlyOn();
  std::ostringstream text;
  filter->Print(text);
  EXPECT_NE(text.str().find("SpecialOnly: 1"), std::string::npos);
}
