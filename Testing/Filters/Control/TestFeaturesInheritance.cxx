// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestFeaturesInheritance.cxx
 * Classes that children inherit are those found again on the children, flags carried along; and
 * filters in a row are one filter, with every option on.
 */
#include "FeatureTools.h"
#include "FileTools.h"

using namespace feature_tools;
using namespace file_tools;

namespace
{

void Strip(vtkUnstructuredGrid* grid)
{
  for (const char* name :
    { "Subdivision", "SubdivisionGlobalIds", "SubdivisionInvertedCells",
      "SubdivisionSingularVertices", "SubdivisionSingularLines", "SubdivisionSingularTriangles" })
  {
    grid->GetFieldData()->RemoveArray(name);
  }
}

/// Whether three tetrahedra share a face.
bool HasFaceOfThree(vtkUnstructuredGrid* grid)
{
  std::map<Ids, std::set<Ids>> faces;
  for (Ids tet : GetCells(grid))
  {
    std::sort(tet.begin(), tet.end());
    for (std::size_t i = 0; tet.size() == 4 && i < 4; ++i)
    {
      Ids face = tet;
      face.erase(face.begin() + static_cast<std::ptrdiff_t>(i));
      faces[face].insert(tet);
    }
  }
  return std::any_of(
    faces.begin(), faces.end(), [](const auto& face) { return face.second.size() > 2; });
}

/// Rules and types of the points of `levels` levels against those found anew on that mesh.
void ExpectSameClasses(vtkUnstructuredGrid* grid, int levels, const Configure& options)
{
  const Grid inherited = Execute(grid, levels, options);
  ASSERT_GT(inherited->GetNumberOfCells(), 0);
  const Grid stripped = DeepCopy(inherited);
  Strip(stripped);
  ASSERT_EQ(stripped->GetFieldData()->GetNumberOfArrays(), 0);
  const Grid found = Execute(stripped, 0, options);
  for (const char* name : { "RuleDimension", "NonManifoldType" })
  {
    vtkDataArray* a = inherited->GetPointData()->GetArray(name);
    vtkDataArray* b = found->GetPointData()->GetArray(name);
    ASSERT_TRUE(a && b);
    ASSERT_EQ(a->GetNumberOfTuples(), b->GetNumberOfTuples());
    for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i)
    {
      ASSERT_EQ(a->GetTuple1(i), b->GetTuple1(i)) << name << " of point " << i;
    }
  }
}

void ExpectChains(vtkUnstructuredGrid* grid, const Configure& options)
{
  const Grid three = Execute(grid, 3, options);
  ASSERT_GT(three->GetNumberOfCells(), 0);
  const Grid zero = Execute(grid, 0, options);
  const Grid one = Execute(grid, 1, options);
  const Grid two = Execute(one, 1, options);
  EXPECT_EQ(Compare(three, Execute(two, 1, options)), "");
  EXPECT_EQ(Compare(three, Execute(zero, 3, options)), "");
  EXPECT_EQ(Compare(three, Execute(Execute(zero, 1, options), 2, options)), "");
  EXPECT_EQ(Compare(three, Execute(WriteAndRead(two), 1, options)), "");
  EXPECT_EQ(
    Compare(three, Execute(WriteAndRead(Execute(WriteAndRead(one), 1, options)), 1, options)), "");
  EXPECT_EQ(Compare(three, Execute(WriteAndRead(zero), 3, options)), "");
}

}

TEST(FeaturesInheritance, FlaggedCellsOfRandomComplexes)
{
  for (unsigned seed = 0; seed < 300; ++seed)
  {
    SCOPED_TRACE(seed);
    const Grid grid = MakeRandomComplex(seed);
    ExpectSameClasses(grid, 1,
      [seed](Filter* filter)
      {
        filter->SetCreaseEnd(static_cast<int>(seed % 2));
        filter->GenerateClassificationOn();
      });
    if (testing::Test::HasFailure())
    {
      return;
    }
  }
}

TEST(FeaturesInheritance, TwoLevels)
{
  for (unsigned seed = 0; seed < 40; ++seed)
  {
    SCOPED_TRACE(seed);
    ExpectSameClasses(MakeRandomComplex(seed), 2,
      [seed](Filter* filter)
      {
        filter->SetCreaseEnd(static_cast<int>(seed % 2));
        filter->GenerateClassificationOn();
      });
    if (testing::Test::HasFailure())
    {
      return;
    }
  }
}

TEST(FeaturesInheritance, AllOptionsOnRandomSurfaces)
{
  for (unsigned seed = 0; seed < 300; ++seed)
  {
    SCOPED_TRACE(seed);
    const Configure options = RandomOptions(seed);
    ExpectSameClasses(MakeRandomComplex(seed, false), 1 + seed % 2,
      [&](Filter* filter)
      {
        options(filter);
        filter->DetectFeaturesOff(); // angles are those of the input
      });
    if (testing::Test::HasFailure())
    {
      return;
    }
  }
}

TEST(FeaturesInheritance, AllOptionsOnRandomSolids)
{
  for (unsigned seed = 0; seed < 300; ++seed)
  {
    SCOPED_TRACE(seed);
    const Configure options = RandomOptions(seed);
    const Grid grid = MakeRandomComplex(seed);
    const bool special = HasFaceOfThree(grid); // see ThreeSolidsOnATriangle
    ExpectSameClasses(grid, 1 + seed % 2,
      [&](Filter* filter)
      {
        options(filter);
        filter->DetectFeaturesOff();
        if (special)
        {
          filter->SetType2RuleToBlend();
          SetCellArray(filter, 3, "None");
        }
      });
    if (testing::Test::HasFailure())
    {
      return;
    }
  }
}

TEST(FeaturesInheritance, ThreeSolidsOnATriangle)
{
  // All that is inside the triangle is a type 2 joint too. (Not for Sharp: what is inside a curve
  // inherits the curve, while among the sharp edges inside the triangle it would be a corner.)
  const Grid grid =
    MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0, 0, -1 }, { 1, 1, 1 } },
      { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 0, 1, 2, 4 } },
        { VTK_TETRA, { 0, 1, 2, 5 } } });
  AddCellArray(grid, "Rule", { 0, 1, 6 });
  for (int rule : { 0, 2 })
  {
    for (const char* regions : { "None", "Rule" })
    {
      for (int levels : { 1, 2 })
      {
        SCOPED_TRACE(std::to_string(rule) + regions + std::to_string(levels));
        ExpectSameClasses(grid, levels,
          [&](Filter* filter)
          {
            filter->SetType2Rule(rule);
            SetCellArray(filter, 3, regions);
            filter->GenerateClassificationOn();
          });
      }
    }
  }
}

TEST(FeaturesInheritance, FiltersInARowWithEveryOption)
{
  const Grid box = MakeMixedBox(2);
  const auto cells = static_cast<int>(box->GetNumberOfCells());
  std::vector<int> flags;
  std::vector<int> others;
  for (int i = 0; i < cells; ++i)
  {
    const int type = box->GetCellType(i);
    flags.push_back(type != VTK_HEXAHEDRON && type != VTK_WEDGE && i % 5 == 0);
    others.push_back(i % 7);
  }
  AddCellArray(box, "Singular", flags);
  AddCellArray(box, "MaterialId", others);
  AddCellArray(box, "Part", others);
  AddCellArray(box, "Rule", others);
  AddArrays(box);
  for (int embedded = 0; embedded < 3; ++embedded)
  {
    SCOPED_TRACE(embedded);
    ExpectChains(box,
      [embedded](Filter* filter)
      {
        filter->SetGenerateClassification(true);
        filter->SetGenerateOriginalIds(true);
        filter->SetCreaseEndToDart();
        filter->SetEmbeddedCells(embedded);
        filter->PreserveInterfacesOn();
        filter->DetectFeaturesOn();
        filter->SetType1RuleToFollowDimension2();
        filter->SetType2RuleToFollowPart();
        filter->SetType3RuleToSharp();
        SetCellArray(filter, 2, "Part");
        SetCellArray(filter, 3, "Rule");
      });
  }
}

TEST(FeaturesInheritance, FiltersInARowOnRandomComplexes)
{
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    SCOPED_TRACE(seed);
    ExpectChains(MakeRandomComplex(seed), RandomOptions(seed + 1000));
    if (testing::Test::HasFailure())
    {
      return;
    }
  }
}
