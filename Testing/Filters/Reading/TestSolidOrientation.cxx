// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSolidOrientation.cxx
 * Solids that smoothing turns inside out, and normals of the limit, which do not follow them.
 */
#include "FeatureTools.h"
#include "PointTools.h"

using namespace feature_tools;
using namespace point_tools;

namespace
{

/// Positive solids, some of them very thin: those of a box of cubes the points of which were moved.
Grid MakeThinSolids(unsigned seed)
{
  const Grid box = MakeKuhnBox(2, 1.6, seed);
  std::vector<Point> points;
  std::vector<Cell> cells;
  for (vtkIdType i = 0; i < box->GetNumberOfPoints(); ++i)
  {
    points.push_back(GetPoint(box, i));
  }
  for (const Ids& cell : GetCells(box))
  {
    if (GetSignedVolume(box, cell) > 0.)
    {
      cells.push_back({ VTK_TETRA, cell });
    }
  }
  return MakeGrid(points, cells);
}

Ids FindNegative(vtkUnstructuredGrid* grid)
{
  Ids found;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    if (grid->GetCellType(i) == VTK_TETRA && GetSignedVolume(grid, GetCell(grid, i)) < 0.)
    {
      found.push_back(i);
    }
  }
  return found;
}

Point GetNormal(vtkUnstructuredGrid* grid, vtkIdType i)
{
  Point normal;
  grid->GetPointData()->GetArray("LimitNormals")->GetTuple(i, normal.data());
  return normal;
}

Grid RunWithNormals(vtkUnstructuredGrid* grid, int levels, int scheme)
{
  vtkNew<Messages> messages; // of what is turned inside out
  return Execute(
    grid, levels,
    [scheme](Filter* filter)
    {
      filter->SetVolumeScheme(scheme);
      filter->GenerateLimitNormalsOn();
      filter->GenerateClassificationOn();
    },
    messages);
}

}

namespace
{

/// Points on the boundary of a solid that follow the rule for surfaces.
bool HasTangentPlane(vtkUnstructuredGrid* grid, vtkIdType i)
{
  return grid->GetPointData()->GetArray("RuleDimension")->GetComponent(i, 0) == 2.;
}

}

TEST(SolidOrientation, NormalsAreThoseOfAllLevels)
{
  vtkIdType some = 0;
  for (unsigned seed = 1; seed <= 12; ++seed)
  {
    for (const int scheme : { Filter::BOX_SPLINE, Filter::TET_OCT })
    {
      const Grid solids = MakeThinSolids(seed);
      // Control cells may be inverted too: these as well as all others, or alone.
      const Grid mixed = DeepCopy(solids);
      vtkNew<vtkCellArray> turned;
      for (vtkIdType i = 0; i < solids->GetNumberOfCells(); ++i)
      {
        Ids ids = GetCell(solids, i);
        if (i % 3 == 0)
        {
          std::swap(ids[0], ids[1]);
        }
        turned->InsertNextCell(4, ids.data());
      }
      mixed->SetCells(VTK_TETRA, turned);
      const Grid first = RunWithNormals(solids, 0, scheme);
      const Grid second = RunWithNormals(mixed, 0, scheme);
      for (int levels = 1; levels < 4; ++levels)
      {
        const Grid later = RunWithNormals(solids, levels, scheme);
        const Grid other = RunWithNormals(mixed, levels, scheme);
        const Grid chained = RunWithNormals(RunWithNormals(mixed, levels - 1, scheme), 1, scheme);
        for (vtkIdType i = 0; i < solids->GetNumberOfPoints(); ++i)
        {
          EXPECT_EQ(GetNormal(chained, i), GetNormal(other, i)) << i;
          if (!HasTangentPlane(first, i))
          {
            continue; // its normal is that of the triangles of a level
          }
          const Point normal = GetNormal(first, i);
          some += Dot(normal, normal) > 0.5;
          EXPECT_NEAR(Dot(normal, GetNormal(later, i)), Dot(normal, normal), 1e-7) << i;
          EXPECT_NEAR(Dot(normal, GetNormal(second, i)), Dot(normal, normal), 1e-7) << i;
          EXPECT_NEAR(Dot(normal, GetNormal(other, i)), Dot(normal, normal), 1e-7) << i;
        }
      }
    }
  }
  EXPECT_GT(some, 1000);
}

/// Flagged corners have no tangent plane: for shading they look away from the solid, whichever way
/// round its cells are.
TEST(SolidOrientation, NormalsOfCornersPointOutOfTheSolid)
{
  const std::vector<Point> points = { { 0., 0., 0. }, { 1., 0., 0. }, { 0., 1., 0. },
    { 0., 0., 1. } };
  for (const Ids& tet : { Ids{ 0, 1, 2, 3 }, Ids{ 1, 0, 2, 3 } })
  {
    std::vector<Cell> cells = { { VTK_TETRA, tet } };
    for (vtkIdType i = 0; i < 4; ++i)
    {
      cells.push_back({ VTK_VERTEX, { i } });
    }
    const Grid solid = With(MakeGrid(points, cells), "Singular", FlagsAfter(1, 4));
    for (const int scheme : { Filter::BOX_SPLINE, Filter::TET_OCT })
    {
      for (int levels = 0; levels < 3; ++levels)
      {
        const Grid result = RunWithNormals(solid, levels, scheme);
        for (vtkIdType i = 0; i < 4; ++i)
        {
          Point away = points[i];
          for (double& value : away)
          {
            value -= 0.25;
          }
          EXPECT_GT(Dot(GetNormal(result, i), away), 0.5 * std::sqrt(Dot(away, away))) << i;
        }
      }
    }
  }
}

TEST(SolidOrientation, NormalsOfSurfacesThatAreTurnedOverInPart)
{
  std::vector<Point> points;
  std::vector<Cell> cells;
  for (int i = 0; i < 36; ++i)
  {
    points.push_back({ 1. * (i % 6), 1. * (i / 6), 0. });
  }
  for (vtkIdType i = 0; i < 25; ++i)
  {
    const vtkIdType p = i % 5 + 6 * (i / 5);
    cells.push_back({ VTK_TRIANGLE, { p, p + 1, p + 6 } });
    cells.push_back({ VTK_TRIANGLE, { p + 1, p + 7, p + 6 } });
  }
  for (std::size_t i = 1; i < cells.size(); ++i)
  {
    if (i * 7 % 5 < 2)
    {
      std::swap(cells[i].Points[0], cells[i].Points[1]);
    }
  }
  const Grid grid = MakeGrid(points, cells);
  for (int levels = 0; levels < 3; ++levels)
  {
    const Grid result = RunWithNormals(grid, levels, Filter::BOX_SPLINE);
    for (vtkIdType i = 0; i < result->GetNumberOfPoints(); ++i)
    {
      EXPECT_NEAR(GetNormal(result, i)[2], 1., 1e-9) << "level " << levels << " point " << i;
    }
  }
}

TEST(SolidOrientation, InvertedCellsAreCountedAndMarked)
{
  vtkIdType all = 0;
  for (unsigned seed = 1; seed <= 12; ++seed)
  {
    const Grid solids = MakeThinSolids(seed);
    for (int levels = 0; levels < 4; ++levels)
    {
      vtkNew<Messages> messages;
      // Where nothing is kept the volumes are told while cells are written.
      const Grid result = Execute(
        solids, levels,
        [seed](Filter* filter)
        {
          filter->GenerateClassificationOn();
          filter->SetCacheOperator(seed % 2 == 0);
        },
        messages);
      const Ids expected = FindNegative(result);
      all += static_cast<vtkIdType>(expected.size());
      EXPECT_TRUE(messages->Warnings.empty());
      ASSERT_EQ(messages->Inversions.size(), expected.empty() ? 0u : 1u);
      if (!expected.empty())
      {
        EXPECT_EQ(messages->Inversions[0]
                    .substr(messages->Inversions[0].find("): ") + 3)
                    .find(std::to_string(expected.size()) + " of " +
                      std::to_string(result->GetNumberOfCells()) + " cells"),
          0u);
      }
      vtkDataArray* marks = result->GetCellData()->GetArray("Inverted");
      ASSERT_TRUE(marks);
      ASSERT_EQ(marks->GetNumberOfTuples(), result->GetNumberOfCells());
      for (vtkIdType i = 0; i < result->GetNumberOfCells(); ++i)
      {
        EXPECT_EQ(
          marks->GetComponent(i, 0) == 1., std::binary_search(expected.begin(), expected.end(), i));
      }
      // One level after the other finds the same.
      if (levels > 0)
      {
        vtkNew<Messages> others;
        const Grid before = Execute(solids, levels - 1, {}, others);
        others->Inversions.clear();
        const Grid chained =
          Execute(before, 1, [](Filter* filter) { filter->GenerateClassificationOn(); }, others);
        EXPECT_EQ(others->Inversions.size(), messages->Inversions.size());
        EXPECT_EQ(Compare(chained, result), "");
      }
    }
  }
  EXPECT_GT(all, 10);
  // Cells that were inverted before are not smoothing's doing.
  const Grid box = MakeKuhnBox(2);
  for (vtkIdType i = 0; i < box->GetNumberOfPoints(); ++i)
  {
    const Point p = GetPoint(box, i);
    box->GetPoints()->SetPoint(i, -p[0], p[1], p[2]);
  }
  EXPECT_FALSE(FindNegative(Execute(box, 2)).empty());
}

/// Volumes whose numbers are beyond the range of a double, or nearly so.
TEST(SolidOrientation, SmallAndLargeSolidsAreMarkedAlike)
{
  const auto mark = [](Filter* filter) { filter->GenerateClassificationOn(); };
  for (unsigned seed = 1; seed <= 3; ++seed)
  {
    const Grid solids = MakeThinSolids(seed);
    vtkNew<Messages> messages;
    const Grid expected = Execute(solids, 2, mark, messages);
    for (const int exponent : { -300, -275, 275, 300 }) // of 2: 300 is 1e90
    {
      const Grid scaled = DeepCopy(solids);
      for (vtkIdType i = 0; i < scaled->GetNumberOfPoints(); ++i)
      {
        const Point p = GetPoint(scaled, i);
        scaled->GetPoints()->SetPoint(
          i, std::ldexp(p[0], exponent), std::ldexp(p[1], exponent), std::ldexp(p[2], exponent));
      }
      const Grid result = Execute(scaled, 2, mark, messages);
      for (vtkIdType i = 0; i < result->GetNumberOfCells(); ++i)
      {
        ASSERT_EQ(result->GetCellData()->GetArray("Inverted")->GetComponent(i, 0),
          expected->GetCellData()->GetArray("Inverted")->GetComponent(i, 0))
          << exponent << ", cell " << i;
      }
    }
  }
}

/// Solids turn over, stay so while arrays change, and turn back.
TEST(SolidOrientation, KeptOperatorsKnowWhatIsUpright)
{
  const auto mark = [](Filter* filter)
  {
    filter->GenerateClassificationOn();
    filter->SetVolumeSchemeToTetOct(); // whose operators do not depend on coordinates
  };
  const Grid thin = MakeThinSolids(2);
  const Grid upright = DeepCopy(thin);
  for (vtkIdType i = 0; i < upright->GetNumberOfPoints(); ++i) // flat, so that nothing turns over
  {
    upright->GetPoints()->SetPoint(i, 0., 0., 0.);
  }
  vtkNew<Filter> filter;
  vtkNew<Messages> messages;
  filter->AddObserver(vtkCommand::WarningEvent, messages);
  filter->SetNumberOfLevels(2);
  mark(filter);
  vtkIdType marked = 0;
  for (const Grid& input : { upright, thin, thin, upright, upright, thin })
  {
    const Grid changed = DeepCopy(input);
    vtkNew<vtkDoubleArray> values;
    values->SetName("value");
    values->SetNumberOfTuples(changed->GetNumberOfPoints());
    values->Fill(static_cast<double>(marked));
    changed->GetPointData()->AddArray(values);
    filter->SetInputData(changed);
    filter->Update();
    vtkNew<Messages> others;
    const Grid expected = Execute(changed, 2, mark, others);
    EXPECT_EQ(Compare(filter->GetOutput(), expected), "");
    marked += static_cast<vtkIdType>(FindNegative(filter->GetOutput()).size());
  }
  EXPECT_GT(marked, 0);
  EXPECT_EQ(filter->GetNumberOfTopologyBuilds(), 1);
}

/// So their normal is the mean of those of the triangles.
TEST(SolidOrientation, BordersOfManyTrianglesHaveNoTangentPlane)
{
  for (int k = 2; k < 12; ++k)
  {
    std::vector<Point> points = { { 0., 0., 0. } };
    std::vector<Cell> cells;
    std::mt19937 random(static_cast<unsigned>(k));
    for (int i = 0; i <= k; ++i)
    {
      const double t = 3.141592653589793 * i / k;
      points.push_back({ std::cos(t), std::sin(t), random() / 4294967296. });
    }
    for (vtkIdType i = 1; i <= k; ++i)
    {
      cells.push_back({ VTK_TRIANGLE, { 0, i, i + 1 } });
    }
    const Grid fan = MakeGrid(points, cells);
    const Point normal = GetNormal(RunWithNormals(fan, 1, Filter::BOX_SPLINE), 0);
    EXPECT_NEAR(Dot(normal, normal), 1., 1e-12) << k;
    EXPECT_GT(normal[2], 0.) << k;
    // The curve is perpendicular to that of the limit, to which stars of many triangles tend
    // slowly.
    const Point along = { points[1][0] - points[k + 1][0], points[1][1] - points[k + 1][1],
      points[1][2] - points[k + 1][2] };
    EXPECT_NEAR(Dot(normal, along), 0., k < 7 ? 1e-5 : 0.1) << k;
    for (const int levels : { 0, 2, 3 })
    {
      const Point other = GetNormal(RunWithNormals(fan, levels, Filter::BOX_SPLINE), 0);
      EXPECT_NEAR(Dot(normal, other), 1., 1e-12) << k << " on level " << levels;
    }
  }
}

TEST(SolidOrientation, FewOfVeryManyAreNoWarning)
{
  for (const vtkIdType lines : { 10, 500000 })
  {
    // A tetrahedron around a point near one of its faces, and lines elsewhere.
    std::vector<Point> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
      { .3, .3, .3 } };
    std::vector<Cell> cells;
    for (const Ids& ids :
      std::vector<Ids>{ { 0, 1, 2, 4 }, { 0, 1, 4, 3 }, { 0, 4, 2, 3 }, { 4, 1, 2, 3 } })
    {
      cells.push_back({ VTK_TETRA, ids });
    }
    for (vtkIdType i = 0; i <= lines; ++i)
    {
      points.push_back({ 2. + static_cast<double>(i), 0., 0. });
      if (i > 0)
      {
        cells.push_back({ VTK_LINE, { 4 + i, 5 + i } });
      }
    }
    vtkNew<Messages> messages;
    const Grid made = Execute(
      MakeGrid(points, cells), 3, [](Filter* filter) { filter->GenerateClassificationOn(); },
      messages);
    auto* marks = made->GetCellData()->GetArray("Inverted");
    double count = 0.;
    for (vtkIdType i = 0; i < made->GetNumberOfCells(); ++i)
    {
      count += marks->GetComponent(i, 0);
    }
    EXPECT_GT(count, 0.);
    EXPECT_EQ(messages->Inversions.size(), lines < 1000 ? 1u : 0u) << lines << ": " << count;
  }
}
