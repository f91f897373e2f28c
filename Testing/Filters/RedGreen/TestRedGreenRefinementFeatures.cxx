// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestRedGreenRefinementFeatures.cxx
 * vtkRedGreenRefinement with Placement LIMIT: all options of the base class, semi-sharp creases
 * among them, mean what they mean in vtkMultiDimensionalSubdivision with ProjectToLimit.
 */
#include "RedGreenRefinementTools.h"

using namespace red_green_refinement_tools;

namespace
{

using Base = vtkSubdivisionAlgorithm;

struct FeatureCase
{
  const char* Name;
  std::function<void(Base*)> Set;
};

void SetCellArray(Base* filter, int index, const char* name)
{
  filter->SetInputArrayToProcess(index, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, name);
}

void SetModifiedBoundary(Base* filter)
{
  auto* uniform = vtkMultiDimensionalSubdivision::SafeDownCast(filter);
  uniform ? uniform->ModifiedBoundaryOn()
          : vtkRedGreenRefinement::SafeDownCast(filter)->ModifiedBoundaryOn();
}

std::vector<FeatureCase> MakeCases()
{
  return {
    { "Nothing", [](Base*) {} },
    { "Singular", [](Base* filter) { SetCellArray(filter, 0, "Flags"); } },
    { "SingularDart",
      [](Base* filter)
      {
        SetCellArray(filter, 0, "Flags");
        filter->SetCreaseEndToDart();
      } },
    { "LoopWeights", [](Base* filter) { filter->SetLoopWeightsToLoop(); } },
    { "ModifiedBoundary",
      [](Base* filter)
      {
        filter->SetInputArrayToProcess(10, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Angles");
        SetModifiedBoundary(filter);
      } },
    { "ModifiedBoundaryAndFlags",
      [](Base* filter)
      {
        SetCellArray(filter, 0, "Flags");
        SetCellArray(filter, 4, "Sharpness");
        filter->SetInputArrayToProcess(10, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Angles");
        SetModifiedBoundary(filter);
      } },
    { "Embedded", [](Base* filter) { filter->SetEmbeddedCellsToSingular(); } },
    { "EmbeddedInside", [](Base* filter) { filter->SetEmbeddedCellsToSingularInside(); } },
    { "Interfaces",
      [](Base* filter)
      {
        filter->PreserveInterfacesOn();
        SetCellArray(filter, 1, "Regions");
      } },
    { "Features",
      [](Base* filter)
      {
        filter->DetectFeaturesOn();
        filter->SetFeatureAngle(40.);
      } },
    { "Sharp",
      [](Base* filter)
      {
        filter->SetType1RuleToSharp();
        filter->SetType2RuleToSharp();
        filter->SetType3RuleToSharp();
      } },
    { "Follow2", [](Base* filter) { filter->SetType1RuleToFollowDimension2(); } },
    { "Follow3", [](Base* filter) { filter->SetType1RuleToFollowDimension3(); } },
    { "FollowPart",
      [](Base* filter)
      {
        filter->SetType2RuleToFollowPart();
        SetCellArray(filter, 2, "Regions");
      } },
    { "Regional", [](Base* filter) { SetCellArray(filter, 3, "Rules"); } },
    { "SemiSharp", [](Base* filter) { SetCellArray(filter, 4, "Sharpness"); } },
    { "SemiSharpAndFeatures",
      [](Base* filter)
      {
        SetCellArray(filter, 4, "Sharpness");
        filter->DetectFeaturesOn();
      } },
  };
}

/// With lines along some of its edges, triangles on some of its faces, and arrays for all options.
Grid MakeFeatured(coretest::Mesh mesh)
{
  std::mt19937 random(11);
  std::set<coretest::Tuple> known;
  const auto cells = coretest::GetCells(mesh.Cells);
  for (const coretest::Tuple& cell : cells)
  {
    known.insert(coretest::Sorted(cell));
  }
  for (const coretest::Tuple& cell : cells)
  {
    for (int pattern = 1; pattern < 1 << cell.size(); ++pattern)
    {
      coretest::Tuple face;
      for (std::size_t i = 0; i < cell.size(); ++i)
      {
        if (pattern >> i & 1)
        {
          face.push_back(cell[i]);
        }
      }
      const unsigned oneIn = face.size() == 2 ? 3 : 7;
      if (random() % oneIn == 0 && face.size() > 1 && known.insert(coretest::Sorted(face)).second)
      {
        mesh.AddCell(face);
      }
    }
  }
  const Grid grid = MakeGrid(mesh);
  vtkNew<vtkIntArray> flags;
  vtkNew<vtkDoubleArray> sharpness;
  flags->SetName("Flags");
  sharpness->SetName("Sharpness");
  const vtkIdType size = grid->GetNumberOfCells();
  for (vtkIdType i = 0; i < size; ++i)
  {
    const int type = grid->GetCellType(i);
    flags->InsertNextValue(
      type != VTK_TETRA && i >= static_cast<vtkIdType>(cells.size()) && random() % 3 == 0);
    const double values[] = { 0., 0.3, 1., 1.75, 2.5, std::numeric_limits<double>::infinity() };
    sharpness->InsertNextValue(type == VTK_LINE ? values[random() % 6] : 0.);
  }
  grid->GetCellData()->AddArray(flags);
  grid->GetCellData()->AddArray(sharpness);
  grid->GetCellData()->AddArray(MakeArray<vtkIntArray>("Regions", 1, size, 0., 2.999, 2));
  grid->GetCellData()->AddArray(MakeArray<vtkIntArray>("Rules", 1, size, 0., 6.999, 3));
  grid->GetPointData()->AddArray(
    MakeArray<vtkDoubleArray>("Angles", 1, grid->GetNumberOfPoints(), -60., 360., 5));
  grid->GetPointData()->AddArray(
    MakeArray<vtkDoubleArray>("V", 1, grid->GetNumberOfPoints(), -1., 1., 4));
  return grid;
}

Grid Project(vtkUnstructuredGrid* input, int levels, const FeatureCase& features,
  Messages* messages, int scheme = vtkMultiDimensionalSubdivision::BOX_SPLINE)
{
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  filter->SetVolumeScheme(scheme);
  messages->Watch(filter);
  filter->SetInputData(input);
  filter->SetNumberOfLevels(levels);
  filter->ProjectToLimitOn();
  features.Set(filter);
  filter->Update();
  return filter->GetOutput();
}

class RedGreenFeatures : public testing::TestWithParam<const char*>
{
};

}

TEST_P(RedGreenFeatures, EverythingMarkedIsTheProjectedUniformMesh)
{
  const Grid input = MakeFeatured(coretest::FindInZoo(GetParam()));
  std::set<std::vector<double>> results;
  for (const FeatureCase& features : MakeCases())
  {
    for (int level = 0; level < 3; ++level)
    {
      vtkNew<Messages> said;
      vtkNew<Messages> expected;
      const Grid output = Refine(
        input,
        [&](Filter* filter)
        {
          filter->RefineByEdgeLengthOn();
          filter->SetMaximumEdgeLength(0.);
          filter->SetMaximumLevel(level);
          filter->SetPlacementToLimit();
          features.Set(filter);
        },
        said);
      const Grid uniform = Project(input, level, features, expected);
      EXPECT_EQ(said->Warnings.size(), expected->Warnings.size()) << features.Name;
      EXPECT_TRUE(said->Errors.empty() && expected->Errors.empty()) << features.Name;
      EXPECT_LE(GetDifference(output, uniform, level == 0), 1e-12)
        << features.Name << " level " << level;
      std::vector<double> points;
      for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
      {
        points.push_back(GetPoint(output, i)[0]);
      }
      if (level == 1)
      {
        results.insert(points);
      }
    }
  }
  EXPECT_GT(results.size(), 4u) << "options change something";
}

TEST_P(RedGreenFeatures, EverythingMarkedHasThePointsOfTheTetOctScheme)
{
  const Grid input = MakeFeatured(coretest::FindInZoo(GetParam()));
  for (const FeatureCase& features : MakeCases())
  {
    SCOPED_TRACE(features.Name);
    vtkNew<Messages> messages;
    const Grid output = Refine(
      input,
      [&](Filter* filter)
      {
        filter->RefineByEdgeLengthOn();
        filter->SetMaximumEdgeLength(0.);
        filter->SetMaximumLevel(2);
        filter->SetPlacementToLimit();
        filter->SetVolumeSchemeToTetOct();
        features.Set(filter);
      },
      messages);
    const Grid uniform =
      Project(input, 2, features, messages, vtkMultiDimensionalSubdivision::TET_OCT);
    EXPECT_TRUE(messages->Errors.empty());
    ASSERT_EQ(output->GetNumberOfPoints(), uniform->GetNumberOfPoints());
    EXPECT_LE(GetFarthest(output, uniform), 1e-12);
    EXPECT_LE(GetFarthest(uniform, output), 1e-12);
  }
}

/// Wherever and however late a point is made, semi-sharp creases have lost as much as they should.
TEST_P(RedGreenFeatures, PointsDoNotDependOnTheirNeighbourhood)
{
  const Grid input = MakeFeatured(coretest::FindInZoo(GetParam()));
  AddWeights(input);
  AddWantedLevels(input, 3, 5, 0.1);
  auto run = [&](const FeatureCase& features, int placement, bool everything)
  {
    vtkNew<Messages> messages;
    return Refine(
      input,
      [&](Filter* filter)
      {
        filter->SetRefineByWantedLevel(!everything);
        filter->SetRefineByEdgeLength(everything);
        filter->SetMaximumEdgeLength(0.);
        filter->SetPlacement(placement);
        features.Set(filter);
      },
      messages);
  };
  const FeatureCase nothing = MakeCases()[0];
  const Grid uniform = run(nothing, Filter::LINEAR, true);
  const Grid adaptive = run(nothing, Filter::LINEAR, false);
  const Ids same = FindSamePoints(adaptive, uniform);
  for (const FeatureCase& features : MakeCases())
  {
    const Grid limit = run(features, Filter::LIMIT, false);
    const Grid projected = run(features, Filter::LIMIT, true);
    ASSERT_EQ(adaptive->GetNumberOfPoints(), limit->GetNumberOfPoints());
    for (vtkIdType i = 0; i < limit->GetNumberOfPoints(); ++i)
    {
      ASSERT_GE(same[i], 0) << i;
      const Point p = GetPoint(limit, i);
      const Point q = GetPoint(projected, same[i]);
      ASSERT_LE(std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]), 1e-12) << features.Name << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Zoo, RedGreenFeatures,
  testing::Values("OctahedronSurface", "OpenFan", "ThreeSheets", "TetsSharingEdge", "KuhnCube",
    "FlushFin", "EverythingAtOnce"),
  [](const auto& instance) { return std::string(instance.param); });

/// Whole numbers of sharpness below the level of a point, and infinite ones, by other means: a
/// curve in a surface is the cubic B-spline of its own points as long as it is sharp.
TEST(RedGreenSemiSharp, ASharpCreaseIsACurveAndASmoothOneIsNot)
{
  const Grid sheet = MakeGrid(coretest::With(
    coretest::FindInZoo("OctahedronSurface"), "", { { 0, 2 }, { 2, 1 }, { 1, 3 }, { 3, 0 } }));
  auto run = [&](double sharpness)
  {
    vtkNew<vtkDoubleArray> values;
    values->SetName("Sharpness");
    for (vtkIdType i = 0; i < sheet->GetNumberOfCells(); ++i)
    {
      values->InsertNextValue(sheet->GetCellType(i) == VTK_LINE ? sharpness : 0.);
    }
    sheet->GetCellData()->AddArray(values);
    return Refine(sheet,
      [](Filter* filter)
      {
        filter->RefineByEdgeLengthOn();
        filter->SetMaximumEdgeLength(1.);
        filter->SetMaximumLevel(1);
        filter->SetPlacementToLimit();
        SetCellArray(filter, 4, "Sharpness");
      });
  };
  // The closed cubic B-spline of (1,0) (0,1) (-1,0) (0,-1) has (2/3,0) on it.
  EXPECT_NEAR(GetPoint(run(std::numeric_limits<double>::infinity()), 0)[0], 2. / 3., 1e-14);
  EXPECT_NEAR(GetPoint(run(40.), 0)[0], 2. / 3., 1e-10);
  // The limit of Loop's scheme at valence 4: 1 - 4 b with b = 8c / (3 + 32c), c = 3/32.
  const double b = 0.75 / (3. + 3.);
  EXPECT_NEAR(GetPoint(run(0.), 0)[0], 1. - 4. * b, 1e-14);
  double before = GetPoint(run(0.), 0)[0];
  for (double sharpness : { 0.5, 1., 1.5, 2., 3. })
  {
    const double x = GetPoint(run(sharpness), 0)[0];
    EXPECT_GT(x, before) << sharpness;
    EXPECT_LT(x, 2. / 3.) << sharpness;
    before = x;
  }
}
