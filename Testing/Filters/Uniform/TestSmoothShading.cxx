// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSmoothShading.cxx
 * SmoothShading adds the normals of GenerateLimitNormals where nothing is sharp, and none
 * elsewhere.
 */
#include "FeatureTools.h"

using namespace feature_tools;

namespace
{

void DoNothing(Filter*)
{
}

/// Expects the normals of GenerateLimitNormals, or none, and nothing else that differs from an
/// output without SmoothShading.
void ExpectShading(bool hasNormals, vtkDataObject* input, const std::string& name,
  const Configure& configure = DoNothing, int levels = 2)
{
  const Grid shaded = Execute(input, levels, configure);
  EXPECT_EQ(shaded->GetPointData()->GetNormals() != nullptr, hasNormals) << name;
  const Grid plain = Execute(input, levels,
    And(
      [=](Filter* filter)
      {
        filter->SmoothShadingOff();
        filter->SetGenerateLimitNormals(hasNormals);
      },
      configure));
  EXPECT_EQ(Compare(shaded, plain), "") << name;
}

Grid MakeMoebiusBand()
{
  const int size = 8;
  std::vector<Point> points;
  std::vector<Cell> cells;
  for (int i = 0; i < size; ++i)
  {
    const double turn = 2. * 3.14159265358979 * i / size;
    for (const double side : { -0.4, 0.4 })
    {
      const double radius = 1. + side * std::cos(0.5 * turn);
      points.push_back(
        { radius * std::cos(turn), radius * std::sin(turn), side * std::sin(0.5 * turn) });
    }
    const vtkIdType a = 2 * i;
    const vtkIdType b = 2 * i + 1;
    const bool isLast = i + 1 == size;
    const vtkIdType c = isLast ? 1 : a + 2;
    const vtkIdType d = isLast ? 0 : b + 2;
    cells.push_back({ VTK_TRIANGLE, { a, c, b } });
    cells.push_back({ VTK_TRIANGLE, { b, c, d } });
  }
  return MakeGrid(points, cells);
}

}

TEST(SmoothShading, IsWhereNothingIsSharp)
{
  const Grid solid = MakeKuhnBox(2, 0.1);
  const Grid sheet = MakeFan(6);
  const Grid unused = MakeKuhnBox(1);
  unused->GetPoints()->InsertNextPoint(2., 2., 2.);
  for (const int scheme : { Filter::BOX_SPLINE, Filter::TET_OCT, Filter::AUTOMATIC })
  {
    const Configure choose = [scheme](Filter* filter) { filter->SetVolumeScheme(scheme); };
    ExpectShading(true, solid, "solid", choose);
    ExpectShading(true, sheet, "sheet", choose, 1);
    ExpectShading(true, unused, "with a point that no cell uses", choose);
    ExpectShading(false, solid, "no level", choose, 0);
  }
  ExpectShading(true, solid, "projected", [](Filter* filter) { filter->ProjectToLimitOn(); });
  ExpectShading(false, solid, "linear", [](Filter* filter) { filter->SetVolumeSchemeToLinear(); });
  const Configure keep = [](Filter* filter) { filter->SetVolumeSchemeToHybrid(); };
  ExpectShading(true, solid, "hybrid", keep);
  ExpectShading(true, sheet, "hybrid sheet", keep);
  ExpectShading(false, MakeFan(6, { { VTK_LINE, { 0, 3 } } }), "hybrid, line on it", keep);
  ExpectShading(false, solid, "hybrid, no level", keep, 0);
}

TEST(SmoothShading, IsNotWhereSomethingIsSharp)
{
  const Configure detect = [](Filter* filter)
  {
    filter->DetectFeaturesOn();
    filter->SetFeatureAngle(40.);
  };
  const Grid solid = MakeKuhnBox(2);
  ExpectShading(false, solid, "features", detect);
  ExpectShading(false, MakeFlaggedFan(6, { { VTK_LINE, { 0, 1 } } }), "crease");
  ExpectShading(false, MakeFlaggedFan(6, { { VTK_VERTEX, { 0 } } }), "corner");
  ExpectShading(false, MakeFan(6, { { VTK_LINE, { 0, 3 } } }), "line on it");
  ExpectShading(false, MakeMixedBox(1), "mixed");
  ExpectShading(false, MakeMoebiusBand(), "one side");
  // Two fans that share a point, and three triangles at an edge.
  ExpectShading(false,
    MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 }, { 0, -1, 0.5 } },
      { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 0, 3, 4 } } }),
    "bow tie");
  const Grid book =
    With(MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 } },
           { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 0, 1, 3 } },
             { VTK_TRIANGLE, { 0, 1, 4 } } }),
      "Part", { 1, 1, 2 });
  ExpectShading(false, book, "book");
  ExpectShading(false, book, "book, by part",
    [](Filter* filter)
    {
      SetCellArray(filter, 2, "Part");
      filter->SetType2RuleToFollowPart();
    });
}

/// Marks add no cells: nothing but the rule of an edge or a vertex says that it is sharp.
TEST(SmoothShading, IsNotWhereMarksAreSharp)
{
  for (const int scheme : { Filter::BOX_SPLINE, Filter::TET_OCT, Filter::HYBRID })
  {
    for (const Grid& mesh : { MakeFan(6), MakeKuhnBox(2) })
    {
      for (const std::set<vtkIdType>& marked : { std::set<vtkIdType>(), { 0 }, { 0, 1 } })
      {
        vtkNew<vtkIntArray> marks;
        marks->SetName("Marks");
        for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
        {
          marks->InsertNextValue(marked.count(i) > 0 ? 1 : 0);
        }
        mesh->GetPointData()->AddArray(marks);
        ExpectShading(marked.empty(), mesh,
          "scheme " + std::to_string(scheme) + ", marks " + std::to_string(marked.size()),
          [&](Filter* filter)
          {
            filter->SetVolumeScheme(scheme);
            filter->SetInputArrayToProcess(
              8, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Marks");
            filter->SetMarkCorners(marked.size() == 1);
            filter->SetMarkCreases(marked.size() == 2);
            filter->SetCreaseEnd(Filter::DART); // then the ends of a crease are not sharp
          });
      }
    }
  }
}

/// Each block decides for itself.
TEST(SmoothShading, DoesNotDependOnOtherBlocks)
{
  const Grid smooth = MakeFan(6);
  const Grid sharp = MakeFan(6, { { VTK_LINE, { 0, 3 } } });
  for (const bool isFirst : { false, true })
  {
    vtkNew<Filter> filter;
    filter->SetInputDataObject(MakeBlocks(
      isFirst ? std::vector<Grid>{ smooth, sharp } : std::vector<Grid>{ sharp, smooth }));
    filter->JoinBlocksOff();
    filter->Update();
    const auto meshes = GetMeshes(filter->GetOutputDataObject(0));
    ASSERT_EQ(meshes.size(), 2u);
    EXPECT_EQ(meshes[0]->GetPointData()->GetNormals() != nullptr, isFirst);
    EXPECT_EQ(meshes[1]->GetPointData()->GetNormals() != nullptr, !isFirst);
  }
}

/// A new value at the points leaves points and normals as they are.
TEST(SmoothShading, NormalsAreKept)
{
  const Grid input = MakeKuhnBox(2, 0.1);
  vtkNew<Filter> filter;
  filter->SetInputData(input);
  filter->SetNumberOfLevels(2);
  filter->Update();
  const Grid first = DeepCopy(filter->GetOutput());
  vtkDataArray* const normals = filter->GetOutput()->GetPointData()->GetNormals();
  ASSERT_TRUE(normals);
  input->GetPointData()->AddArray(
    MakeArray<vtkDoubleArray>("Heat", 1, input->GetNumberOfPoints(), 0, 9, 1));
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetNormals(), normals);
  filter->GetOutput()->GetPointData()->RemoveArray("Heat");
  EXPECT_EQ(Compare(filter->GetOutput(), first), "");
  // Somebody wrote into them.
  input->GetPointData()->GetArray("Heat")->SetComponent(0, 0, 4.);
  input->GetPointData()->GetArray("Heat")->Modified();
  input->Modified();
  normals->SetComponent(0, 0, 5.);
  filter->Update();
  filter->GetOutput()->GetPointData()->RemoveArray("Heat");
  EXPECT_EQ(Compare(filter->GetOutput(), first), "");
}

TEST(SmoothShading, IsTheSameWithKeptOperators)
{
  const Grid input = MakeKuhnBox(2, 0.1);
  vtkNew<Filter> filter;
  filter->SetInputData(input);
  filter->SetNumberOfLevels(2);
  filter->SetFeatureAngle(40.);
  for (const bool isSharp : { false, false, true, true, false })
  {
    filter->SetDetectFeatures(isSharp);
    const Point moved = GetPoint(input, 0);
    input->GetPoints()->SetPoint(0, moved[0] - 0.01, moved[1], moved[2]);
    input->GetPoints()->Modified();
    input->Modified();
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetPointData()->GetNormals() == nullptr, isSharp);
    EXPECT_EQ(Compare(filter->GetOutput(),
                Execute(input, 2,
                  [&](Filter* fresh)
                  {
                    fresh->SetFeatureAngle(40.);
                    fresh->SetDetectFeatures(isSharp);
                  })),
      "");
  }
}
