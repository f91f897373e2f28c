// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestLimitProjection.cxx
 * ProjectToLimit of vtkMultiDimensionalSubdivision.
 */
#include "OperatorCacheTools.h"

#include "vtkMath.h"

using namespace operator_cache_tools;

namespace
{

const Configure Projected = [](Filter* filter) { filter->ProjectToLimitOn(); };
const Configure TetOct = [](Filter* filter) { filter->SetVolumeSchemeToTetOct(); };

/// Values that both have, at the points of the first.
void ExpectSameAtPoints(vtkUnstructuredGrid* few, vtkUnstructuredGrid* many, double tolerance)
{
  auto compare = [&](vtkDataArray* a, vtkDataArray* b)
  {
    ASSERT_NE(b, nullptr);
    for (vtkIdType i = 0; i < few->GetNumberOfPoints(); ++i)
    {
      for (int c = 0; c < a->GetNumberOfComponents(); ++c)
      {
        ASSERT_NEAR(a->GetComponent(i, c), b->GetComponent(i, c), tolerance) << i << " " << c;
      }
    }
  };
  ASSERT_LE(few->GetNumberOfPoints(), many->GetNumberOfPoints());
  compare(few->GetPoints()->GetData(), many->GetPoints()->GetData());
  for (int i = 0; i < few->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = few->GetPointData()->GetArray(i);
    if (array && array->GetDataType() == VTK_DOUBLE)
    {
      compare(array, many->GetPointData()->GetArray(array->GetName()));
    }
  }
}

/// A mixed box with values, sharp lines of all kinds, and parts.
Grid MakeBoxWithFeatures()
{
  const Grid grid = MakeMixedBox(2);
  AddArrays(grid);
  std::vector<int> parts;
  vtkNew<vtkDoubleArray> sharpness;
  sharpness->SetName("Sharpness");
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    parts.push_back(static_cast<int>(cell % 3));
    sharpness->InsertNextValue(grid->GetCellType(cell) == VTK_LINE ? 2.75 : 0.);
  }
  AddCellArray(grid, "Part", parts);
  grid->GetCellData()->AddArray(sharpness);
  return grid;
}

}

TEST(LimitProjection, DoesNotDependOnTheLevel)
{
  const Grid input = MakeBoxWithFeatures();
  const std::vector<std::pair<const char*, Configure>> rules = {
    { "Blend", [](Filter*) {} },
    { "Sharp",
      [](Filter* filter)
      {
        filter->SetType1Rule(Filter::TYPE1_SHARP);
        filter->SetType2Rule(Filter::TYPE2_SHARP);
      } },
    { "Features",
      [](Filter* filter)
      {
        filter->DetectFeaturesOn();
        filter->SetFeatureAngle(60.);
        filter->SetCreaseEnd(Filter::DART);
      } },
    { "LoopWeights", [](Filter* filter) { filter->SetLoopWeightsToLoop(); } },
    { "SemiSharp", [](Filter* filter) { SetCellArray(filter, 4, "Sharpness"); } },
    { "TetOct", TetOct },
    { "TetOctSharp",
      [](Filter* filter)
      {
        filter->SetVolumeSchemeToTetOct();
        filter->SetLoopWeightsToLoop();
        filter->SetType1Rule(Filter::TYPE1_SHARP);
        SetCellArray(filter, 4, "Sharpness");
      } },
    { "Interfaces",
      [](Filter* filter)
      {
        SetCellArray(filter, 1, "Part");
        filter->PreserveInterfacesOn();
      } },
  };
  for (const auto& rule : rules)
  {
    SCOPED_TRACE(rule.first);
    const Configure project = And(Projected, rule.second);
    Grid before = Execute(input, 0, project);
    for (int levels = 1; levels <= 3; ++levels)
    {
      SCOPED_TRACE(levels);
      const Grid now = Execute(input, levels, project);
      ExpectSameAtPoints(before, now, 1e-12);
      before = now;
    }
  }
}

TEST(LimitProjection, LevelsComeCloserAndCloser)
{
  const Grid input = MakeMixedBox(1);
  for (const Configure& scheme : { Configure([](Filter*) {}), TetOct })
  {
    const Grid limit = Execute(input, 0, And(Projected, scheme));
    double before = 0.;
    for (int levels = 0; levels <= 4; ++levels)
    {
      const Grid output = Execute(input, levels, scheme);
      double most = 0.;
      for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
      {
        const Point a = GetPoint(limit, i);
        const Point b = GetPoint(output, i);
        most = std::max(most, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
      }
      EXPECT_GT(most, 0.);
      EXPECT_TRUE(levels == 0 || most < 0.6 * before) << levels;
      before = most;
    }
  }
}

TEST(LimitProjection, OnlyPointsAndSmoothedArraysChange)
{
  const Grid input = MakeBoxWithFeatures();
  for (int levels : { 0, 1, 2 })
  {
    SCOPED_TRACE(levels);
    const Grid plain = Execute(input, levels);
    const Grid projected = Execute(input, levels, Projected);
    EXPECT_EQ(GetCells(projected), GetCells(plain));
    EXPECT_EQ(CompareArrays(projected->GetCellData(), plain->GetCellData(), "cells"), "");
    EXPECT_NE(CompareValues(projected->GetPoints()->GetData(), plain->GetPoints()->GetData()), "");
    for (const char* name : { "int", "byte", "bit", "string" })
    {
      EXPECT_EQ(CompareValues(projected->GetPointData()->GetAbstractArray(name),
                  plain->GetPointData()->GetAbstractArray(name)),
        "");
    }
    for (const char* name : { "float", "double", "rgb", "rgba" })
    {
      EXPECT_NE(CompareValues(projected->GetPointData()->GetAbstractArray(name),
                  plain->GetPointData()->GetAbstractArray(name)),
        "");
    }
    EXPECT_STREQ(projected->GetPointData()->GetScalars()->GetName(), "float");
  }
}

TEST(LimitProjection, ACircleOfSplines)
{
  // Control points on a circle of radius 1: the limit of a vertex is 2/3 and two times 1/6.
  std::vector<Point> points;
  Ids line;
  for (int i = 0; i < 8; ++i)
  {
    points.push_back({ std::cos(i * vtkMath::Pi() / 4.), std::sin(i * vtkMath::Pi() / 4.), 0. });
    line.push_back(i);
  }
  line.push_back(0);
  const Grid output = Execute(MakeGrid(points, { { VTK_POLY_LINE, line } }), 1, Projected);
  for (vtkIdType i = 0; i < 8; ++i)
  {
    const Point p = GetPoint(output, i);
    EXPECT_NEAR(std::hypot(p[0], p[1]), 2. / 3. + std::cos(vtkMath::Pi() / 4.) / 3., 1e-15);
    // Parameter 1/2 of a cubic B-spline: 1/48, 23/48, 23/48, 1/48.
    const Point q = GetPoint(output, 8 + i);
    EXPECT_NEAR(std::hypot(q[0], q[1]),
      (46. * std::cos(vtkMath::Pi() / 8.) + 2. * std::cos(3. * vtkMath::Pi() / 8.)) / 48., 1e-15);
  }
}

TEST(LimitProjection, IsKeptWithTheOperator)
{
  for (const auto& run : { std::make_pair(0, false), { 2, false }, { 0, true }, { 2, true } })
  {
    SCOPED_TRACE(testing::PrintToString(run));
    const Configure configure = And(Projected,
      [run](Filter* filter)
      {
        filter->SetNumberOfLevels(run.first);
        filter->SetVolumeScheme(run.second ? Filter::TET_OCT : Filter::BOX_SPLINE);
        filter->GenerateClassificationOn();
      });
    Kept filter(configure);
    const Grid input = MakeInput();
    const Grid first = filter.Update(input);
    EXPECT_EQ(filter.CountBuilds(), 1);
    EXPECT_EQ(Compare(first, Fresh(input, configure)), "");
    const Grid changed = DeepCopy(input);
    changed->GetPointData()->GetArray("scalar")->Fill(0.25);
    const Grid second = filter.Update(changed);
    EXPECT_TRUE(SharesCells(first, second) && SharesPoints(first, second));
    EXPECT_EQ(Compare(second, Fresh(changed, configure)), "");
    const Point p = GetPoint(changed, 13);
    MovePoint(changed, 13, p[0] + 1e-7, p[1], p[2]); // diagonals stay
    EXPECT_EQ(Compare(filter.Update(changed), Fresh(changed, configure)), "");
    EXPECT_EQ(filter.CountBuilds(), 0);
    filter->ProjectToLimitOff();
    const Grid plain = filter.Update(changed);
    EXPECT_EQ(filter.CountBuilds(), 1);
    EXPECT_TRUE(run.second || SharesCells(second, plain)) << "only rules changed";
    EXPECT_FALSE(SharesPoints(second, plain));
  }
}

TEST(LimitProjection, ANextFilterTakesTheOutputForAMeshLikeAnyOther)
{
  const Grid input = MakeMixedBox(1);
  AddGlobalIds(input, 3);
  for (int scheme : { Filter::BOX_SPLINE, Filter::TET_OCT })
  {
    const Configure features = [scheme](Filter* filter)
    {
      filter->SetVolumeScheme(scheme);
      filter->DetectFeaturesOn();
    };
    const Grid projected = Execute(input, 1, And(Projected, features));
    const Grid plain = DeepCopy(projected);
    RemoveStamp(plain);
    EXPECT_TRUE(projected->GetFieldData()->HasArray("Subdivision"));
    EXPECT_FALSE(projected->GetFieldData()->HasArray("SubdivisionSingularLines"));
    EXPECT_EQ(Compare(Execute(projected, 1, features), Execute(plain, 1, features)), "");
    // The last of several filters may project.
    const Grid once = Execute(input, 2, And(Projected, features));
    const Grid twice = Execute(Execute(input, 1, features), 1, And(Projected, features));
    EXPECT_EQ(Compare(once, twice), "");
  }
}

TEST(LimitProjection, SameBitsForAnyNumberOfThreads)
{
  const Grid input = MakeKuhnBox(6, 0.2, 3);
  for (const Configure& configure : { Projected, And(Projected, TetOct) })
  {
    MakeInThreads([&] { return Execute(input, 1, configure); });
  }
}

TEST(LimitProjection, NormalsOfASphere)
{
  // The octahedron: its symmetry makes the normal of a vertex its axis.
  std::vector<Point> points = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 },
    { 0, 0, -1 } };
  std::vector<Cell> cells;
  for (int i = 0; i < 8; ++i)
  {
    const vtkIdType x = i & 1;
    const vtkIdType y = 2 + ((i >> 1) & 1);
    const vtkIdType z = 4 + ((i >> 2) & 1);
    const bool odd = ((i ^ (i >> 1) ^ (i >> 2)) & 1) != 0;
    cells.push_back({ VTK_TRIANGLE, odd ? Ids{ y, x, z } : Ids{ x, y, z } });
  }
  for (int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    const Grid input = MakeGrid(points, cells, type);
    for (int levels : { 0, 1, 3 })
    {
      SCOPED_TRACE(levels);
      const Configure normals = [](Filter* filter) { filter->GenerateLimitNormalsOn(); };
      const Grid plain = Execute(input, levels, normals);
      const Grid projected = Execute(input, levels, And(Projected, normals));
      vtkDataArray* array = projected->GetPointData()->GetArray("LimitNormals");
      ASSERT_NE(array, nullptr);
      EXPECT_EQ(array->GetDataType(), type);
      EXPECT_EQ(CompareValues(array, plain->GetPointData()->GetArray("LimitNormals")), "");
      for (vtkIdType i = 0; i < projected->GetNumberOfPoints(); ++i)
      {
        const Point p = GetPoint(projected, i);
        const double length = std::hypot(p[0], p[1], p[2]);
        double dot = 0.;
        for (int c = 0; c < 3; ++c)
        {
          dot += array->GetComponent(i, c) * p[c] / length;
          if (i < 6)
          {
            EXPECT_NEAR(array->GetComponent(i, c), points[i][c], 1e-6);
          }
        }
        EXPECT_GT(dot, 0.9);
      }
      EXPECT_FALSE(Execute(input, levels, [](Filter* filter) { filter->SmoothShadingOff(); })
          ->GetPointData()
          ->HasArray("LimitNormals"));
    }
  }
}

/// Boundaries of solids are the same surfaces with either scheme, and so are their normals.
TEST(LimitProjection, BoundariesAreThoseOfTheOtherScheme)
{
  const Grid input = MakeKuhnBox(3, 0.2, 5);
  const Configure normals = And(Projected,
    [](Filter* filter)
    {
      filter->GenerateLimitNormalsOn();
      filter->GenerateClassificationOn();
    });
  for (int levels = 0; levels <= 3; ++levels)
  {
    SCOPED_TRACE(levels);
    const Grid box = Execute(input, levels, normals);
    const Grid tetOct = Execute(input, levels, And(normals, TetOct));
    std::map<std::array<long, 3>, vtkIdType> places; // on a grid: rounding differs
    auto placeOf = [](const Point& p)
    {
      return std::array<long, 3>{ std::lround(1e9 * p[0] + 0.3), std::lround(1e9 * p[1] + 0.3),
        std::lround(1e9 * p[2] + 0.3) };
    };
    auto isSurface = [](vtkUnstructuredGrid* grid, vtkIdType i)
    { return grid->GetPointData()->GetArray("RuleDimension")->GetComponent(i, 0) == 2.; };
    for (vtkIdType i = 0; i < box->GetNumberOfPoints(); ++i)
    {
      if (isSurface(box, i))
      {
        places[placeOf(GetPoint(box, i))] = i;
      }
    }
    std::size_t found = 0;
    for (vtkIdType i = 0; i < tetOct->GetNumberOfPoints(); ++i)
    {
      double length = 0.;
      const auto twin =
        isSurface(tetOct, i) ? places.find(placeOf(GetPoint(tetOct, i))) : places.end();
      for (int c = 0; c < 3; ++c)
      {
        const double normal = tetOct->GetPointData()->GetArray("LimitNormals")->GetComponent(i, c);
        length += normal * normal;
        if (twin != places.end())
        {
          ASSERT_NEAR(normal,
            box->GetPointData()->GetArray("LimitNormals")->GetComponent(twin->second, c), 1e-9);
        }
      }
      ASSERT_NEAR(length, isSurface(tetOct, i) ? 1. : 0., 1e-12) << i;
      found += twin != places.end() ? 1 : 0;
    }
    EXPECT_EQ(found, places.size());
  }
}

TEST(LimitProjection, NormalsAreMadeAgainWithThePoints)
{
  const Configure configure = And(Projected,
    [](Filter* filter)
    {
      filter->GenerateLimitNormalsOn();
      filter->GenerateTangentsOn();
    });
  Kept filter(configure);
  const Grid input = MakeInput();
  EXPECT_EQ(Compare(filter.Update(input), Fresh(input, configure)), "");
  EXPECT_EQ(Compare(filter.Update(input), Fresh(input, configure)), "");
  const Grid changed = DeepCopy(input);
  for (vtkIdType i = 0; i < changed->GetNumberOfPoints(); ++i)
  {
    const Point p = GetPoint(changed, i);
    MovePoint(changed, i, -p[0], p[1], p[2]); // inside out
  }
  const Grid mirrored = filter.Update(changed);
  EXPECT_EQ(Compare(mirrored, Fresh(changed, configure)), "");
  EXPECT_EQ(filter.CountBuilds(), 1);
  // An earlier filter's normals and tangents are replaced.
  const Configure normals = [](Filter* f)
  {
    f->GenerateLimitNormalsOn();
    f->GenerateTangentsOn();
  };
  const Grid twice = Execute(Execute(input, 1, normals), 1, normals);
  EXPECT_EQ(Compare(twice, Execute(input, 2, normals)), "");
}

/// The tangents of a surface are perpendicular to its normals, on curves along them, and in solids
/// zero; all where the points were before they were projected.
TEST(LimitProjection, Tangents)
{
  const Grid input = MakeBoxWithFeatures();
  const Configure frames = [](Filter* filter)
  {
    filter->GenerateLimitNormalsOn();
    filter->GenerateTangentsOn();
    filter->GenerateClassificationOn();
    filter->DetectFeaturesOn();
    filter->SetFeatureAngle(60.);
  };
  for (const int levels : { 0, 2 })
  {
    const Grid plain = Execute(input, levels, frames);
    const Grid projected = Execute(input, levels, And(Projected, frames));
    int counts[4] = { 0, 0, 0, 0 }; // of the rules
    for (const char* name : { "LimitTangent1", "LimitTangent2" })
    {
      vtkDataArray* array = projected->GetPointData()->GetArray(name);
      ASSERT_NE(array, nullptr);
      EXPECT_EQ(array->GetDataType(), input->GetPoints()->GetDataType());
      EXPECT_EQ(CompareValues(array, plain->GetPointData()->GetArray(name)), "");
      EXPECT_FALSE(Execute(input, levels)->GetPointData()->HasArray(name));
      for (vtkIdType i = 0; i < projected->GetNumberOfPoints(); ++i)
      {
        Point tangent;
        Point normal;
        array->GetTuple(i, tangent.data());
        projected->GetPointData()->GetArray("LimitNormals")->GetTuple(i, normal.data());
        const auto rule = static_cast<int>(
          projected->GetPointData()->GetArray("RuleDimension")->GetComponent(i, 0));
        const double length = std::hypot(tangent[0], tangent[1], tangent[2]);
        if (rule == 3)
        {
          EXPECT_EQ(length, 0.) << i;
        }
        if (rule == 2 && length > 0.)
        {
          EXPECT_NEAR(
            tangent[0] * normal[0] + tangent[1] * normal[1] + tangent[2] * normal[2], 0., 1e-12)
            << i;
        }
        counts[rule % 4] += length > 0.;
      }
    }
    EXPECT_GT(counts[1], 0);
    EXPECT_GT(counts[2], 0);
  }
}
