// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestHostileInput.cxx
 * Input that is legal but unlikely, or damaged on purpose: nothing crashes, nothing becomes NaN.
 */
#include "FeatureTools.h"

using namespace feature_tools;

namespace
{

/// A wedge whose three quads have been cut in turn by triangles: it needs a centre.
Grid MakeTwistedWedge()
{
  return MakeGrid({ { 0, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 0, 0, 1 }, { 0, 1, 1 }, { 1, 0, 1 } },
    { { VTK_WEDGE, { 0, 1, 2, 3, 4, 5 } }, { VTK_TRIANGLE, { 0, 1, 4 } },
      { VTK_TRIANGLE, { 1, 2, 5 } }, { VTK_TRIANGLE, { 2, 0, 3 } } });
}

bool IsFinite(vtkUnstructuredGrid* grid)
{
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    for (double x : GetPoint(grid, p))
    {
      if (!std::isfinite(x))
      {
        return false;
      }
    }
  }
  return true;
}

}

TEST(HostileInput, GlobalIdsAndACentre)
{
  const Grid wedge = MakeTwistedWedge();
  SetGlobalIds(wedge, { 60, 50, 40, 30, 20, 10 });
  const Grid direct = Execute(wedge, 2);
  EXPECT_TRUE(IsFinite(direct));
  EXPECT_EQ(Compare(direct, Execute(Execute(Execute(wedge, 0), 1), 1)), "");
}

TEST(HostileInput, GlobalIdsThatAreTooFew)
{
  const Grid wedge = MakeTwistedWedge();
  const Grid expected = Execute(wedge, 1);
  SetGlobalIds(wedge, { 3 });
  vtkNew<Messages> messages;
  const Grid result = Execute(wedge, 1, {}, messages);
  ASSERT_EQ(messages->Warnings.size(), 1u);
  EXPECT_NE(messages->Warnings[0].find("global ids"), std::string::npos);
  EXPECT_EQ(GetCells(result), GetCells(expected));
}

TEST(HostileInput, CellsWithoutAnyPoints)
{
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(vtkNew<vtkPoints>());
  const vtkIdType ids[4] = { 0, 1, 2, 3 };
  grid->InsertNextCell(VTK_TETRA, 4, ids);
  vtkNew<Messages> messages;
  const Grid result = Execute(grid.Get(), 1, {}, messages);
  EXPECT_EQ(messages->Warnings.size(), 1u);
  EXPECT_EQ(result->GetNumberOfCells(), 0);
}

TEST(HostileInput, EqualTetsAndEqualGlobalIds)
{
  const Grid tets = MakeGrid({ { 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 } },
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 2, 0, 3, 1 } },
      { VTK_TETRA, { 3, 2, 1, 0 } } });
  SetGlobalIds(tets, { 7, 7, 7, 7 });
  const Grid result = Execute(tets, 3);
  EXPECT_EQ(result->GetNumberOfCells(), 3 * 512);
  EXPECT_EQ(result->GetNumberOfPoints(), 165);
}

TEST(HostileInput, CoordinatesNearTheLargest)
{
  for (double scale : { 1e300, 8e307, 1.7e308 })
  {
    const Grid box =
      MakeGrid({ { -scale, -scale, -scale }, { scale, -scale, -scale }, { scale, scale, -scale },
                 { -scale, scale, -scale }, { -scale, -scale, scale }, { scale, -scale, scale },
                 { scale, scale, scale }, { -scale, scale, scale } },
        { { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } } });
    EXPECT_TRUE(IsFinite(Execute(box, 2))) << scale;
    EXPECT_TRUE(IsFinite(Execute(box, 2,
      [](Filter* filter) { filter->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION); })))
      << scale;
  }
}

TEST(HostileInput, FeaturesAtAnyScaleAndOfFlatTriangles)
{
  const Configure features = [](Filter* filter)
  {
    filter->DetectFeaturesOn();
    filter->GenerateClassificationOn();
  };
  for (double s : { 1e-165, 1e-9, 1., 1e200 })
  {
    for (bool folded : { false, true })
    {
      const Grid sheet =
        MakeGrid({ { 0, 0, 0 }, { s, 0, 0 }, { 0, s, 0 }, { 0, -s, folded ? s : 0. } },
          { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 1, 0, 3 } } });
      const Grid result = Execute(sheet, 0, features);
      const bool found = result->GetFieldData()->HasArray("SubdivisionSingularLines");
      EXPECT_EQ(found, folded) << s;
    }
  }
  const Grid flat = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { .5, 1, 0 }, { .25, 0, 0 } },
    { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 1, 0, 3 } } });
  EXPECT_FALSE(Execute(flat, 0, features)->GetFieldData()->HasArray("SubdivisionSingularLines"));
}

TEST(HostileInput, WithoutAStepTheCacheGivesWhatWentIn)
{
  const Grid fan = MakeFan(5);
  vtkNew<Filter> filter;
  filter->SetNumberOfLevels(0);
  filter->SetInputData(fan);
  filter->Update();
  const Grid copy = DeepCopy(fan);
  fan->GetPoints()->SetPoint(0, 99., 0., 0.);
  filter->SetInputData(copy);
  filter->Update();
  EXPECT_EQ(GetPoint(filter->GetOutput(), 0), GetPoint(copy, 0));
}

TEST(HostileInput, DamagedArraysThatTravelWithAMesh)
{
  const Grid first = Execute(MakeFan(6), 1,
    [](Filter* filter)
    {
      filter->GenerateOriginalIdsOn();
      filter->DetectFeaturesOn();
      filter->SetFeatureAngle(1.);
    });
  const Grid plain = Execute(first, 1);
  // Ids that are too few.
  const Grid shortIds = DeepCopy(first);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("vtkOriginalPointIds");
  ids->InsertNextValue(0);
  shortIds->GetPointData()->AddArray(ids);
  vtkNew<Messages> messages;
  EXPECT_EQ(GetCells(Execute(shortIds, 1, {}, messages)), GetCells(plain));
  EXPECT_EQ(messages->Warnings.size(), 1u);
  // Singular lines that are none of the mesh.
  for (const std::vector<vtkIdType>& forged :
    std::vector<std::vector<vtkIdType>>{ { 3, 3 }, { 1, 4 }, { 0, 4000 }, { -1, 2 } })
  {
    const Grid mesh = DeepCopy(first);
    vtkNew<vtkIdTypeArray> lines;
    lines->SetName("SubdivisionSingularLines");
    lines->SetNumberOfComponents(2);
    lines->InsertNextTypedTuple(forged.data());
    mesh->GetFieldData()->AddArray(lines);
    EXPECT_EQ(Execute(mesh, 1)->GetNumberOfPoints(), plain->GetNumberOfPoints());
  }
  // A stamp of nonsense.
  const Grid mesh = DeepCopy(first);
  vtkDataArray* stamp = mesh->GetFieldData()->GetArray("Subdivision");
  vtkNew<vtkDoubleArray> nonsense;
  nonsense->SetName("Subdivision");
  for (vtkIdType i = 0; i < stamp->GetNumberOfTuples(); ++i)
  {
    nonsense->InsertNextValue(std::numeric_limits<double>::quiet_NaN());
  }
  mesh->GetFieldData()->AddArray(nonsense);
  EXPECT_EQ(Execute(mesh, 1)->GetNumberOfPoints(), plain->GetNumberOfPoints());
}

/// For each spoke the filter looks for vertices that are neighbours of both its ends. It begins at
/// the end with few neighbours: the other one, the hub, has 80000. The test checks the result, not
/// the time.
TEST(HostileInput, AHubOfManyBlendedSpokes)
{
  constexpr int spokes = 20000;
  std::vector<Point> points = { { 0, 0, 0 } };
  std::vector<Cell> cells;
  for (vtkIdType i = 0; i < spokes; ++i)
  {
    const double t = 6.283185307179586 * static_cast<double>(i) / spokes;
    const vtkIdType p = static_cast<vtkIdType>(points.size());
    points.push_back({ std::cos(t), std::sin(t), 0 });
    for (int k = 0; k < 3; ++k)
    {
      points.push_back({ std::cos(t), std::sin(t), 1. + k });
      cells.push_back({ VTK_TRIANGLE, { 0, p, p + 1 + k } });
    }
  }
  const Grid result = Execute(MakeGrid(points, cells), 1);
  EXPECT_EQ(result->GetNumberOfCells(), 4 * 3 * spokes);
  EXPECT_TRUE(IsFinite(result));
}
