// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSimplicialComplexTopology.cxx
 * Small complexes whose every value is known by hand.
 */
#include "SimplicialComplexTopologyTools.h"

using namespace simplicial_complex_topology_tools;

// ------------------------------------------------------------------------------------------------
// Values known by hand: C_k, boundary, type, singular, valence, rule

TEST(SimplicialComplexTopology, Tetrahedron)
{
  const Grid probe = Probe(MakeComplex(4, { { VTK_TETRA, { 2, 0, 3, 1 } } }));
  ExpectNumbers(probe, { 4, 6, 4, 1 }, { 0, 0, 0, 1 });
  const std::vector<Ids> cells = { { 0 }, { 1 }, { 2 }, { 3 }, { 0, 1 }, { 0, 2 }, { 0, 3 },
    { 1, 2 }, { 1, 3 }, { 2, 3 }, { 0, 1, 2 }, { 0, 1, 3 }, { 0, 2, 3 }, { 1, 2, 3 } };
  EXPECT_EQ(GetCells(probe), cells);
  const V expected[4] = { {}, { 4, 1, 0, 0, 3, 2 }, { 4, 1, 0, 0, 2, 2 }, { 4, 1, 0, 0, 1, -1 } };
  const int types[4] = { 0, VTK_VERTEX, VTK_LINE, VTK_TRIANGLE };
  for (vtkIdType i = 0; i < probe->GetNumberOfCells(); ++i)
  {
    EXPECT_EQ(Values(probe, cells[i]), expected[cells[i].size()]);
    EXPECT_EQ(probe->GetCellType(i), types[cells[i].size()]);
    EXPECT_EQ(
      probe->GetCellData()->GetArray("SimplexDimension")->GetTuple1(i), cells[i].size() - 1.);
  }
}

TEST(SimplicialComplexTopology, FinOnTetrahedron)
{
  const Grid probe =
    Probe(MakeComplex(5, { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TRIANGLE, { 1, 2, 4 } } }));
  ExpectNumbers(probe, { 5, 8, 5, 1 }, { 0, 0, 1, 1 });
  EXPECT_EQ(Values(probe, { 0 }), (V{ 4, 1, 0, 0, 3, 2 }));
  EXPECT_EQ(Values(probe, { 1 }), (V{ 6, 1, 1, 0, 4, 4 }));
  EXPECT_EQ(Values(probe, { 4 }), (V{ 2, 1, 0, 0, 2, 1 }));
  EXPECT_EQ(Values(probe, { 1, 2 }), (V{ 6, 1, 1, 0, 3, 4 }));
  EXPECT_EQ(Values(probe, { 1, 4 }), (V{ 2, 1, 0, 0, 1, 1 }));
  EXPECT_EQ(Values(probe, { 1, 2, 3 }), (V{ 4, 1, 0, 0, 1, -1 }));
  EXPECT_EQ(Values(probe, { 1, 2, 4 }), (V{ 2, 0, 0, 0, 0, -1 }));
}

TEST(SimplicialComplexTopology, BowTie)
{
  const Grid probe =
    Probe(MakeComplex(5, { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 0, 3, 4 } } }));
  ExpectNumbers(probe, { 5, 6, 2, 0 }, { 0, 0, 1, 0 });
  EXPECT_EQ(Values(probe, { 0 }), (V{ 2, 0, 3, 0, 4, 4 }));
  EXPECT_EQ(Values(probe, { 1 }), (V{ 2, 1, 0, 0, 2, 1 }));
  EXPECT_EQ(Values(probe, { 0, 1 }), (V{ 2, 1, 0, 0, 1, 1 }));
}

TEST(SimplicialComplexTopology, ThreeSheets)
{
  const Grid probe = Probe(MakeComplex(5,
    { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 0, 1, 3 } },
      { VTK_TRIANGLE, { 0, 1, 4 } } }));
  ExpectNumbers(probe, { 5, 7, 3, 0 }, { 0, 0, 1, 0 });
  EXPECT_EQ(Values(probe, { 0, 1 }), (V{ 2, 0, 2, 0, 3, 4 }));
  EXPECT_EQ(Values(probe, { 0 }), (V{ 2, 0, 2, 0, 4, 4 }));
  EXPECT_EQ(Values(probe, { 3 }), (V{ 2, 1, 0, 0, 2, 1 }));
  EXPECT_EQ(Values(probe, { 0, 2 }), (V{ 2, 1, 0, 0, 1, 1 }));
}

TEST(SimplicialComplexTopology, PinchedTetrahedra)
{
  Grid probe =
    Probe(MakeComplex(7, { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 0, 4, 5, 6 } } }));
  ExpectNumbers(probe, { 7, 12, 8, 2 }, { 0, 0, 0, 1 });
  EXPECT_EQ(Values(probe, { 0 }), (V{ 4, 0, 3, 0, 6, 4 }));
  EXPECT_EQ(Values(probe, { 0, 1 }), (V{ 4, 1, 0, 0, 2, 2 }));

  probe = Probe(MakeComplex(6, { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 0, 1, 4, 5 } } }));
  ExpectNumbers(probe, { 6, 11, 8, 2 }, { 0, 0, 0, 1 });
  EXPECT_EQ(Values(probe, { 0, 1 }), (V{ 4, 0, 3, 0, 4, 4 }));
  EXPECT_EQ(Values(probe, { 0 }), (V{ 4, 0, 3, 0, 5, 4 }));

  probe = Probe(MakeComplex(6,
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 0, 1, 2, 4 } },
      { VTK_TETRA, { 0, 1, 2, 5 } } }));
  ExpectNumbers(probe, { 6, 12, 10, 3 }, { 0, 0, 0, 1 });
  EXPECT_EQ(Values(probe, { 0, 1, 2 }), (V{ 4, 0, 2, 0, 3, -1 }));
  EXPECT_EQ(Values(probe, { 0, 1 }), (V{ 4, 0, 2, 0, 4, 4 }));
  EXPECT_EQ(Values(probe, { 0 }), (V{ 4, 0, 2, 0, 5, 4 }));
  EXPECT_EQ(Values(probe, { 3 }), (V{ 4, 1, 0, 0, 3, 2 }));
}

TEST(SimplicialComplexTopology, IsolatedVerticesAndLines)
{
  const std::vector<Cell> cells = { { VTK_VERTEX, { 5 } }, { VTK_LINE, { 7, 2 } },
    { VTK_VERTEX, { 5 } }, { VTK_VERTEX, { 2 } }, { VTK_LINE, { 2, 7 } }, { VTK_VERTEX, { 4 } } };
  const Grid input = MakeComplex(9, cells);
  const Grid probe = Probe(input);
  ExpectNumbers(probe, { 4, 1, 0, 0 }, { 2, 1, 0, 0 });
  EXPECT_EQ(GetCells(probe), (std::vector<Ids>{ { 2 }, { 4 }, { 5 }, { 7 }, { 2, 7 } }));
  EXPECT_EQ(probe->GetNumberOfPoints(), 9);
  EXPECT_EQ(Values(probe, { 5 }), (V{ 0, 0, 0, 0, 0, 0 }));
  EXPECT_EQ(Values(probe, { 2 }), (V{ 1, 1, 0, 0, 1, 0 }));
  EXPECT_EQ(Values(probe, { 2, 7 }), (V{ 1, 0, 0, 0, 0, 1 }));
  EXPECT_EQ(GetCells(Probe(input, nullptr, true)), (std::vector<Ids>{ { 2 }, { 7 } }));
}

TEST(SimplicialComplexTopology, CrossingLines)
{
  const Grid probe =
    Probe(MakeComplex(6, { { VTK_POLY_LINE, { 1, 0, 2, 5 } }, { VTK_POLY_LINE, { 3, 0, 4 } } }));
  ExpectNumbers(probe, { 6, 5, 0, 0 }, { 0, 1, 0, 0 });
  EXPECT_EQ(Values(probe, { 0 }), (V{ 1, 0, 2, 0, 4, 4 }));
  EXPECT_EQ(Values(probe, { 1 }), (V{ 1, 1, 0, 0, 1, 0 }));
  EXPECT_EQ(Values(probe, { 2 }), (V{ 1, 0, 0, 0, 2, 1 }));
  EXPECT_EQ(Values(probe, { 0, 1 }), (V{ 1, 0, 0, 0, 0, 1 }));
}

TEST(SimplicialComplexTopology, MoebiusStrip)
{
  std::vector<Cell> cells;
  for (vtkIdType i = 0; i < 5; ++i)
  {
    cells.push_back({ VTK_TRIANGLE, { i, (i + 1) % 5, (i + 2) % 5 } });
  }
  const Grid probe = Probe(MakeComplex(5, cells));
  ExpectNumbers(probe, { 5, 10, 5, 0 }, { 0, 0, 1, 0 });
  EXPECT_EQ(Values(probe, { 3 }), (V{ 2, 1, 0, 0, 4, 1 }));
  EXPECT_EQ(Values(probe, { 0, 1 }), (V{ 2, 0, 0, 0, 2, 2 }));
  EXPECT_EQ(Values(probe, { 0, 2 }), (V{ 2, 1, 0, 0, 1, 1 }));
}

TEST(SimplicialComplexTopology, Torus)
{
  std::vector<Cell> cells;
  auto at = [](int i, int j) { return vtkIdType(i % 3 + 3 * (j % 3)); };
  for (int j = 0; j < 3; ++j)
  {
    for (int i = 0; i < 3; ++i)
    {
      cells.push_back({ VTK_TRIANGLE, { at(i, j), at(i + 1, j), at(i + 1, j + 1) } });
      cells.push_back({ VTK_TRIANGLE, { at(i, j), at(i + 1, j + 1), at(i, j + 1) } });
    }
  }
  const Grid input = MakeComplex(9, cells);
  const Grid probe = Probe(input);
  ExpectNumbers(probe, { 9, 27, 18, 0 }, { 0, 0, 1, 0 });
  EXPECT_EQ(Values(probe, { 4 }), (V{ 2, 0, 0, 0, 6, 2 }));
  EXPECT_EQ(Values(probe, { 0, 1 }), (V{ 2, 0, 0, 0, 2, 2 }));
  const Grid special = Probe(input, nullptr, true);
  ExpectNumbers(special, { 9, 27, 18, 0 }, { 0, 0, 1, 0 });
  EXPECT_EQ(special->GetNumberOfCells(), 0);
  EXPECT_EQ(special->GetNumberOfPoints(), 9);
  EXPECT_NE(special->GetCellData()->GetArray("Valence"), nullptr);
}

TEST(SimplicialComplexTopology, SphereAndBall)
{
  const Grid sphere = Probe(MakeGrid(BallPoints, BallCells(false)));
  ExpectNumbers(sphere, { 6, 12, 8, 0 }, { 0, 0, 1, 0 });
  const Grid ball = Probe(MakeBall());
  ExpectNumbers(ball, { 7, 18, 20, 8 }, { 0, 0, 0, 1 });
  EXPECT_EQ(Values(ball, { 6 }), (V{ 4, 0, 0, 0, 6, 3 }));
  EXPECT_EQ(Values(ball, { 0 }), (V{ 4, 1, 0, 0, 5, 2 }));
  EXPECT_EQ(Values(ball, { 0, 6 }), (V{ 4, 0, 0, 0, 4, 3 }));
  EXPECT_EQ(Values(ball, { 0, 2 }), (V{ 4, 1, 0, 0, 3, 2 }));
  EXPECT_EQ(Values(ball, { 0, 2, 6 }), (V{ 4, 0, 0, 0, 2, -1 }));
  const Grid special = Probe(MakeBall(), nullptr, true);
  EXPECT_EQ(special->GetNumberOfCells(), 6 + 12 + 8);
  EXPECT_EQ(Values(special, { 0, 2 }), (V{ 4, 1, 0, 0, 3, 2 }));
  EXPECT_EQ(Values(special, { 0, 6 }), V());
}

TEST(SimplicialComplexTopology, ComponentsOfEachDimension)
{
  const Grid probe = Probe(MakeComplex(20,
    { { VTK_VERTEX, { 0 } }, { VTK_LINE, { 1, 2 } }, { VTK_LINE, { 3, 4 } }, { VTK_LINE, { 4, 5 } },
      { VTK_TRIANGLE, { 5, 6, 7 } }, { VTK_TRIANGLE, { 8, 9, 10 } }, { VTK_TRIANGLE, { 1, 2, 11 } },
      { VTK_TETRA, { 8, 12, 13, 14 } }, { VTK_TETRA, { 15, 16, 17, 18 } },
      { VTK_TETRA, { 15, 17, 16, 18 } }, { VTK_TRIANGLE, { 15, 16, 17 } } }));
  // The line 1 2 is a face of a triangle, the last triangle one of a tetrahedron.
  ExpectNumbers(probe, { 19, 23, 11, 2 }, { 1, 1, 3, 2 });
}

// ------------------------------------------------------------------------------------------------
// Singular simplices and options

TEST(SimplicialComplexTopology, FlaggedSimplices)
{
  const Grid input = MakeBall({ { VTK_LINE, { 6, 4 } }, { VTK_LINE, { 6, 5 } },
    { VTK_TRIANGLE, { 2, 0, 6 } }, { VTK_VERTEX, { 3 } }, { VTK_LINE, { 0, 3 } } });
  Grid probe = Probe(input);
  EXPECT_TRUE(SingularCells(probe).empty());
  Flag(input, { 0, 0, 0, 0, 0, 0, 0, 0, 1, 5, 0, -1, 0 });
  probe = Probe(input);
  EXPECT_EQ(SingularCells(probe), (std::vector<Ids>{ { 3 }, { 4, 6 }, { 5, 6 } }));
  EXPECT_EQ(RuleOf(probe, { 6 }), 1);
  EXPECT_EQ(RuleOf(probe, { 4, 6 }), 1);
  EXPECT_EQ(RuleOf(probe, { 4 }), 0);
  EXPECT_EQ(RuleOf(probe, { 3 }), 0);
  EXPECT_EQ(RuleOf(probe, { 0, 6 }), 3);
  const Configure dart = [](vtkSubdivisionAlgorithm* filter) { filter->SetCreaseEndToDart(); };
  EXPECT_EQ(RuleOf(Probe(input, dart), { 4 }), 2);
  // Outside the sphere's own simplices, only the two lines are special; the vertex is by its rule.
  const Grid special = Probe(input, nullptr, true);
  EXPECT_EQ(special->GetNumberOfCells(), 26 + 3);
  EXPECT_EQ(RuleOf(special, { 6 }), 1);

  Flag(input, { 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0 });
  probe = Probe(input);
  EXPECT_EQ(SingularCells(probe), (std::vector<Ids>{ { 0, 2, 6 } }));
  EXPECT_EQ(RuleOf(probe, { 0, 6 }), 1);
  EXPECT_EQ(SingularOf(probe, { 0, 6 }), 0);
  EXPECT_EQ(Probe(input, nullptr, true)->GetNumberOfCells(), 26 + 1 + 2 + 1);
}

TEST(SimplicialComplexTopology, ArraysAreNamedByIndex)
{
  const Grid input = MakeBall({ { VTK_LINE, { 6, 4 } } });
  Flag(input, { 0, 0, 0, 0, 0, 0, 0, 0, 1 }, "wells");
  auto name = [](const char* array)
  {
    return [array](vtkSubdivisionAlgorithm* filter)
    { filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, array); };
  };
  EXPECT_EQ(SingularOf(Probe(input), { 4, 6 }), 0);
  EXPECT_EQ(SingularOf(Probe(input, name("None")), { 4, 6 }), 0);
  EXPECT_EQ(SingularOf(Probe(input, name("wells")), { 4, 6 }), 1);
  vtkNew<Messages> messages;
  const Grid failed = Probe(input, name("faults"), false, messages);
  ASSERT_FALSE(messages->Errors.empty());
  EXPECT_NE(messages->Errors[0].find("faults"), std::string::npos);
  EXPECT_EQ(failed->GetNumberOfCells(), 0);
}

TEST(SimplicialComplexTopology, EmbeddedCells)
{
  const Grid input = MakeBall({ { VTK_LINE, { 6, 4 } }, { VTK_TRIANGLE, { 2, 0, 6 } },
    { VTK_TRIANGLE, { 0, 2, 4 } }, { VTK_VERTEX, { 3 } }, { VTK_VERTEX, { 6 } } });
  auto embedded = [&input](int rule)
  {
    return SingularCells(
      Probe(input, [rule](vtkSubdivisionAlgorithm* filter) { filter->SetEmbeddedCells(rule); }));
  };
  EXPECT_EQ(embedded(0), std::vector<Ids>());
  EXPECT_EQ(embedded(1), (std::vector<Ids>{ { 6 }, { 4, 6 }, { 0, 2, 6 } }));
  EXPECT_EQ(embedded(2), (std::vector<Ids>{ { 3 }, { 6 }, { 4, 6 }, { 0, 2, 4 }, { 0, 2, 6 } }));
}

TEST(SimplicialComplexTopology, Interfaces)
{
  const Grid input = MakeBall();
  Flag(input, { 1, 1, 1, 1, 2, 2, 2, 2 }, "MaterialId"); // either side of x = 0
  const Configure preserve = [](vtkSubdivisionAlgorithm* filter)
  { filter->PreserveInterfacesOn(); };
  const Grid probe = Probe(input, preserve);
  EXPECT_EQ(
    SingularCells(probe), (std::vector<Ids>{ { 2, 4, 6 }, { 2, 5, 6 }, { 3, 4, 6 }, { 3, 5, 6 } }));
  EXPECT_EQ(RuleOf(probe, { 6 }), 2);
  EXPECT_EQ(RuleOf(probe, { 2, 6 }), 2);
  EXPECT_EQ(RuleOf(probe, { 2, 4 }), 1);
  EXPECT_EQ(RuleOf(probe, { 2 }), 1);
  EXPECT_EQ(RuleOf(probe, { 0 }), 2);
  input->GetCellData()->RemoveArray("MaterialId");
  vtkNew<Messages> messages;
  Probe(input, preserve, false, messages);
  EXPECT_FALSE(messages->Errors.empty());
}

TEST(SimplicialComplexTopology, Features)
{
  const Grid input = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 0, 1, 3 } } }); // at right angles
  auto features = [&input](double angle)
  {
    return SingularCells(Probe(input,
      [angle](vtkSubdivisionAlgorithm* filter)
      {
        filter->DetectFeaturesOn();
        filter->SetFeatureAngle(angle);
      }));
  };
  EXPECT_EQ(features(89.), (std::vector<Ids>{ { 0, 1 } }));
  EXPECT_EQ(features(91.), std::vector<Ids>());
}

TEST(SimplicialComplexTopology, JointRules)
{
  const Grid fin = MakeComplex(5, { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TRIANGLE, { 1, 2, 4 } } });
  const int rules[5] = { 4, 1, 4, 1, 2 };
  for (int rule = 0; rule < 5; ++rule)
  {
    const Grid probe =
      Probe(fin, [rule](vtkSubdivisionAlgorithm* filter) { filter->SetType1Rule(rule); });
    EXPECT_EQ(RuleOf(probe, { 1, 2 }), rules[rule]) << rule;
    EXPECT_EQ(Values(probe, { 1, 2 })[2], 1);
  }
  const Grid sheets = MakeComplex(5,
    { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 0, 1, 3 } },
      { VTK_TRIANGLE, { 0, 1, 4 } } });
  Flag(sheets, { 3, 3, 7 }, "parts");
  const Grid part = Probe(sheets,
    [](vtkSubdivisionAlgorithm* filter)
    {
      filter->SetType2RuleToFollowPart();
      filter->SetInputArrayToProcess(2, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "parts");
    });
  EXPECT_EQ(RuleOf(part, { 0, 1 }), 2);
  Flag(sheets, { 0, 2, 0 }, "rules");
  const Grid regional = Probe(sheets, [](vtkSubdivisionAlgorithm* filter)
    { filter->SetInputArrayToProcess(3, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "rules"); });
  EXPECT_EQ(RuleOf(regional, { 0, 1 }), 1);
  const Grid bow = MakeComplex(5, { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 0, 3, 4 } } });
  const Configure sharp = [](vtkSubdivisionAlgorithm* filter) { filter->SetType3RuleToSharp(); };
  EXPECT_EQ(RuleOf(Probe(bow, sharp), { 0 }), 0);
}

TEST(SimplicialComplexTopology, SemiSharpEdgesShowTheSmoothRule)
{
  const Grid input = MakeBall({ { VTK_LINE, { 6, 4 } }, { VTK_LINE, { 6, 5 } } });
  vtkNew<vtkDoubleArray> sharpness;
  sharpness->SetName("sharpness");
  sharpness->SetNumberOfTuples(10);
  sharpness->Fill(0.);
  sharpness->SetValue(8, 1.5);
  sharpness->SetValue(9, std::numeric_limits<double>::infinity());
  input->GetCellData()->AddArray(sharpness);
  const Grid probe = Probe(input,
    [](vtkSubdivisionAlgorithm* filter)
    {
      filter->SetInputArrayToProcess(4, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "sharpness");
    });
  EXPECT_EQ(SingularCells(probe), (std::vector<Ids>{ { 5, 6 } }));
  EXPECT_EQ(RuleOf(probe, { 4, 6 }), 3);
  EXPECT_EQ(RuleOf(probe, { 5, 6 }), 1);
}
