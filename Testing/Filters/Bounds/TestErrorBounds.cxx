// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestErrorBounds.cxx
 * GenerateErrorBounds of vtkMultiDimensionalSubdivision: bounds hold at a million places, and are
 * near the truth.
 */
#include "BoundTools.h"
#include "Turns.h"

#include "Private/Bezier/PatchShape.h"

#include "vtkSubdivisionModelSource.h"

using namespace bound_tools;

namespace
{

Grid MakeModel(int model)
{
  return WithValues(LoadModel(model));
}

/// A closed surface of `n` times two triangles, with vertices of valence 4 and n.
Grid MakeBipyramid(int n, double noise)
{
  std::vector<Point> points{ { 0., 0., 1. }, { 0.1, 0., -1.2 } };
  std::vector<Cell> cells;
  std::mt19937 random(static_cast<unsigned>(n));
  for (int i = 0; i < n; ++i)
  {
    const double angle = 2. * 3.14159265358979 * i / n;
    const auto draw = [&] { return noise * (random() / 4294967296. - 0.5); };
    points.push_back({ std::cos(angle) + draw(), std::sin(angle) + draw(), draw() });
    const vtkIdType a = 2 + i;
    const vtkIdType b = 2 + (i + 1) % n;
    cells.push_back({ VTK_TRIANGLE, { 0, a, b } });
    cells.push_back({ VTK_TRIANGLE, { 1, b, a } });
  }
  return WithValues(MakeGrid(points, cells));
}

/// A closed and an open curve.
Grid MakeCurves()
{
  std::vector<Point> points;
  std::vector<Cell> cells;
  std::mt19937 random(3);
  for (vtkIdType i = 0; i < 12; ++i)
  {
    points.push_back({ std::cos(0.7 * i), std::sin(0.7 * i), random() / 4294967296. });
    if (i != 5)
    {
      cells.push_back({ VTK_LINE, { i, i == 11 ? 6 : i + 1 } });
    }
  }
  return WithValues(MakeGrid(points, cells));
}

Tightness Check(
  vtkUnstructuredGrid* input, int levels, int steps, bool projects, const Configure& configure = {})
{
  Tightness tightness;
  ExpectBounds(MakeBounded<Filter>(input, levels, steps, configure, projects), tightness);
  return tightness;
}

}

TEST(ErrorBounds, HoldAtRandomPlaces)
{
  using subdivision::LatticePart;
  using subdivision::PatchShape;
  std::mt19937 random(12 + turns::GetTurn());
  vtkIdType places = 0;
  vtkIdType inSolids = 0;
  const auto check = [&](vtkUnstructuredGrid* mesh, int levels, int count, bool projects)
  {
    const Grid input = WithValues(mesh);
    vtkNew<Filter> filter;
    filter->SetNumberOfLevels(0);
    const Grid simplices = UpdateWithoutErrors<vtkUnstructuredGrid>(filter.Get(), input);
    const Grid output = UpdateWithBounds(filter.Get(), input, levels, projects);
    ASSERT_EQ(simplices->GetNumberOfCells(), input->GetNumberOfCells());
    Ids firsts{ 0 };
    const auto getDimension = [&](vtkIdType c)
    { return static_cast<int>(GetCell(input, c).size()) - 1; };
    for (vtkIdType c = 0; c < input->GetNumberOfCells(); ++c)
    {
      firsts.push_back(firsts.back() + (vtkIdType(1) << (getDimension(c) * levels)));
    }
    PlacesOfParts drawn;
    for (int i = 0; i < turns::GetShare(count); ++i)
    {
      const auto c =
        static_cast<vtkIdType>(random() % static_cast<unsigned>(input->GetNumberOfCells()));
      const int dimension = getDimension(c);
      inSolids += dimension == 3 ? 1 : 0;
      std::array<Point, 4> corners{};
      for (int k = 1; k <= dimension; ++k)
      {
        corners[k][k - 1] = 1.;
      }
      vtkIdType part = 0;
      for (int level = 0; level < levels && dimension > 0; ++level)
      {
        const PatchShape& shape = PatchShape::Get(dimension == 1 ? PatchShape::Curve
            : dimension == 2                                     ? PatchShape::Triangle
                                                                 : PatchShape::Tetrahedron);
        const std::size_t child = random() % shape.Children.size();
        part = part * static_cast<vtkIdType>(shape.Children.size()) + static_cast<vtkIdType>(child);
        std::array<Point, 4> of{};
        for (int k = 0; k <= dimension; ++k)
        {
          const auto at = shape.Children[child].At(shape.CornerPoints[k], 2);
          for (int x = 0; x < 3; ++x)
          {
            of[k][x] = corners[0][x];
            for (int axis = 0; axis < dimension; ++axis)
            {
              of[k][x] += 0.5 * at[axis] * (corners[axis + 1][x] - corners[0][x]);
            }
          }
        }
        corners = of;
      }
      const std::array<double, 4> weights = DrawWeights(random, dimension + 1);
      Point place{};
      for (int k = 0; k <= dimension; ++k)
      {
        for (int x = 0; x < 3; ++x)
        {
          place[x] += weights[k] * corners[k][x];
        }
      }
      // Tetrahedra have another order inside.
      const Ids inside = GetCell(simplices, c);
      const Ids outside = GetCell(input, c);
      Point given{};
      for (int k = 0; k < dimension; ++k)
      {
        const auto at = std::find(inside.begin(), inside.end(), outside[k + 1]) - inside.begin();
        given[k] = at == 0 ? 1. - place[0] - place[1] - place[2] : place[at - 1];
        given[k] = std::max(0., given[k]);
      }
      drawn.Add(firsts[c] + part, weights, c, given);
    }
    ExpectBoundsAtPlaces(filter, output, drawn);
    places += turns::GetShare(count);
  };
  for (const bool projects : { false, true })
  {
    for (const int n : { 3, 4, 5, 7, 12 })
    {
      check(MakeBipyramid(n, 0.5), n % 3, 31000, projects);
    }
    check(MakeCurves(), 1, 31000, projects);
    for (unsigned seed = 1; seed < 12; ++seed)
    {
      // Where many joints meet in solids a place takes a hundred times as long as elsewhere.
      const bool withSolids = seed % 4 == 0;
      check(MakeRandomComplex(seed, withSolids), seed % 2, withSolids ? 500 : 31000, projects);
    }
    for (const int n : { 1, 2, 3 })
    {
      check(MakeKuhnBox(n, 0.2), n == 3 ? 0 : 1, 20000, projects);
    }
    check(MakeModel(vtkSubdivisionModelSource::MATERIAL_BLOCK), 0, 10000, projects);
  }
  std::cout << places << " places, " << inSolids << " of them in solids\n";
  EXPECT_GE(places, turns::GetShare(1000000));
  EXPECT_GE(inSolids, turns::GetShare(100000));
}

TEST(ErrorBounds, AreNearTheTruthOnCurvesAndSurfaces)
{
  for (const bool projects : { false, true })
  {
    for (const int n : { 3, 4, 5, 6, 8, 16 })
    {
      for (const int levels : { 0, 1, 2 })
      {
        Tightness found = Check(MakeBipyramid(n, 0.4), levels, 4, projects);
        EXPECT_LT(found.GetMedian(), projects ? 2. : 1.3) << n << " " << levels;
        EXPECT_LT(found.GetLargest(), 3.) << n << " " << levels << " " << projects;
      }
    }
    Tightness found = Check(MakeCurves(), 1, 5, projects);
    EXPECT_LT(found.GetLargest(), 2.5) << projects;
  }
}

TEST(ErrorBounds, HoldOnModelsAndAreNearTheTruth)
{
  for (const int model : { 1, 6 })
  {
    for (const bool projects : { false, true })
    {
      Tightness found = Check(MakeModel(model), 0, 4, projects);
      std::cout << "model " << model << (projects ? " on the limit" : "") << ": median "
                << found.GetMedian() << ", most " << found.GetLargest() << "\n";
      EXPECT_LT(found.GetMedian(), 2.) << model;
      EXPECT_LT(found.GetLargest(), 3.) << model;
    }
  }
}

TEST(ErrorBounds, HoldWithFeaturesOfAllKinds)
{
  Tightness found;
  for (unsigned seed = 20; seed < 60; ++seed)
  {
    const Grid input = WithValues(MakeRandomComplex(seed, seed % 3 == 0));
    const Configure configure = [&](Filter* filter)
    {
      filter->SetDetectFeatures(seed % 2 == 0);
      filter->SetCreaseEnd(static_cast<int>(seed / 2 % 2));
      filter->SetLoopWeights(static_cast<int>(seed / 3 % 2));
      filter->SetModifiedBoundary(seed % 3 == 1);
      filter->SetEmbeddedCells(static_cast<int>(seed % 3));
      filter->SetType1Rule(static_cast<int>(seed % 4));
      filter->SetType2Rule(static_cast<int>(seed % 2));
      filter->SetInterpolatePoints(seed % 4 == 1);
    };
    ExpectBounds(
      MakeBounded<Filter>(input, seed % 2, seed % 3 == 0 ? 4 : 5, configure, seed % 2 == 0), found);
  }
  EXPECT_GT(found.Samples, 100000);
  EXPECT_LE(found.GetLargest(), 3.);
}

TEST(ErrorBounds, AreNearTheTruthOnRandomComplexes)
{
  // Most of them have joints and creases everywhere: what lies beyond them does not count. Where
  // this is not enough, or what the limit of an array does far from a cell is much larger than what
  // it does there, further steps of the cell are looked at.
  Tightness found;
  for (unsigned seed = 1; seed < 400; ++seed)
  {
    if (!turns::IsInTurn(seed))
    {
      continue;
    }
    std::mt19937 random(seed);
    const bool withSolids = random() % 2 == 0;
    const Grid input = WithValues(MakeRandomComplex(seed, withSolids));
    const unsigned bits = random() >> 4;
    const Configure configure = ChooseFeatures(bits);
    ExpectBounds(
      MakeBounded<Filter>(input, withSolids ? 0 : 1, 3, configure, bits / 60 % 2 == 0), found);
  }
  ExpectRatios(found, turns::GetShare(20000), 2.2);
}

/// Where many cells have a point, what the limit depends on there is found for all of them at once.
TEST(ErrorBounds, OfAWheelAreTheSameAllAround)
{
  const Configure bounds = [](Filter* filter)
  {
    filter->GenerateErrorBoundsOn();
    filter->ModifiedBoundaryOff();
  };
  for (const int n : { 20, 200 })
  {
    const Grid wheel = Execute(MakeFan(n), 0, bounds);
    vtkDataArray* of = wheel->GetCellData()->GetArray("ErrorBound");
    ASSERT_NE(of, nullptr);
    const double first = of->GetComponent(0, 0);
    EXPECT_GT(first, 0.01);
    for (vtkIdType c = 0; c < n; ++c)
    {
      EXPECT_NEAR(of->GetComponent(c, 0), first, 1e-9) << "triangle " << c << " of " << n;
    }
  }
}

TEST(ErrorBounds, OfTheLinearSchemeAreRounding)
{
  Tightness found;
  const Configure linear = [](Filter* filter) { filter->SetVolumeSchemeToLinear(); };
  const auto bounded = MakeBounded<Filter>(WithValues(MakeRandomComplex(3)), 1, 1, linear, false);
  ExpectBounds(bounded, found);
  double range[2];
  bounded.Coarse->GetCellData()->GetArray("ErrorBound")->GetRange(range);
  EXPECT_GT(range[0], 0.);
  EXPECT_LT(range[1], 1e-12);
}

TEST(ErrorBounds, OfACopyOfThePointsAreThoseOfThePoints)
{
  const auto bounded = MakeBounded<Filter>(MakeBipyramid(5, 0.3), 1, 1, {}, false);
  EXPECT_EQ(CompareValues(bounded.Coarse->GetCellData()->GetArray("ErrorBound"),
              bounded.Coarse->GetCellData()->GetArray("CopyErrorBound")),
    "");
  EXPECT_EQ(CompareValues(bounded.Coarse->GetPointData()->GetArray("SmoothingDistance"),
              bounded.Coarse->GetPointData()->GetArray("CopySmoothingDistance")),
    "");
}

TEST(ErrorBounds, DistancesOfControlPointsAreThoseOfTheirLimits)
{
  const Grid input = MakeBipyramid(7, 0.3);
  const Configure project = [](Filter* filter) { filter->ProjectToLimitOn(); };
  const Grid limit = Execute(input, 0, project);
  const Grid output = Execute(input, 1, [](Filter* filter) { filter->GenerateErrorBoundsOn(); });
  vtkDataArray* distances = output->GetPointData()->GetArray("SmoothingDistance");
  vtkDataArray* ofTwo = output->GetPointData()->GetArray("TwoSmoothingDistance");
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    if (i >= input->GetNumberOfPoints())
    {
      EXPECT_EQ(distances->GetComponent(i, 0), -1.);
      EXPECT_EQ(ofTwo->GetComponent(i, 0), -1.);
      continue;
    }
    const Point p = GetPoint(input, i);
    const Point q = GetPoint(limit, i);
    const double distance = std::hypot(p[0] - q[0], std::hypot(p[1] - q[1], p[2] - q[2]));
    EXPECT_GT(distance, 0.01);
    EXPECT_NEAR(distances->GetComponent(i, 0), distance, 1e-14);
    vtkDataArray* from = input->GetPointData()->GetArray("Two");
    vtkDataArray* to = limit->GetPointData()->GetArray("Two");
    EXPECT_NEAR(ofTwo->GetComponent(i, 0),
      std::hypot(from->GetComponent(i, 0) - to->GetComponent(i, 0),
        from->GetComponent(i, 1) - to->GetComponent(i, 1)),
      1e-12);
  }
  const Grid interpolated = Execute(input, 1,
    [](Filter* filter)
    {
      filter->GenerateErrorBoundsOn();
      filter->InterpolatePointsOn();
    });
  distances = interpolated->GetPointData()->GetArray("SmoothingDistance");
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    EXPECT_LT(distances->GetComponent(i, 0), 1e-9);
  }
}

TEST(ErrorBounds, OfSinglePrecisionHoldForRoundedPoints)
{
  const Grid input = MakeBipyramid(5, 0.3);
  const Grid output = Execute(input, 1,
    [](Filter* filter)
    {
      filter->GenerateErrorBoundsOn();
      filter->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
    });
  const Grid fine = Execute(input, 5, [](Filter* filter) { filter->ProjectToLimitOn(); });
  Tightness found;
  ExpectBounds(output, fine, 4, found);
  EXPECT_LT(found.GetLargest(), 3.);
}

TEST(ErrorBounds, DoNotDependOnThreadsAndOnWhatWasKept)
{
  const Grid input = WithValues(MakeKuhnBox(3, 0.1));
  const Configure configure = [](Filter* filter) { filter->GenerateErrorBoundsOn(); };
  vtkSMPTools::Initialize(1);
  const Grid one = Execute(input, 0, configure);
  vtkSMPTools::Initialize(4);
  vtkNew<Filter> filter;
  filter->SetNumberOfLevels(0);
  UpdateWithoutErrors<vtkUnstructuredGrid>(filter.Get(), input);
  const vtkIdType builds = filter->GetNumberOfTopologyBuilds();
  configure(filter);
  const Grid four = UpdateWithoutErrors<vtkUnstructuredGrid>(filter.Get(), input);
  EXPECT_EQ(filter->GetNumberOfTopologyBuilds(), builds);
  filter->Modified();
  const Grid again = UpdateWithoutErrors<vtkUnstructuredGrid>(filter.Get(), input);
  vtkSMPTools::Initialize(0);
  ASSERT_NE(one->GetCellData()->GetArray("ErrorBound"), nullptr);
  EXPECT_EQ(Compare(one, four), "");
  EXPECT_EQ(Compare(one, again), "");
}

TEST(ErrorBounds, OfBlocksAreThoseOfTheWhole)
{
  const Grid whole = MakeBipyramid(6, 0.4);
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned b = 0; b < 2; ++b)
  {
    const auto block = Grid::New();
    block->SetPoints(whole->GetPoints());
    vtkNew<vtkIdList> ids;
    for (vtkIdType c = 6 * b; c < 6 * (b + 1); ++c)
    {
      whole->GetCellPoints(c, ids);
      block->InsertNextCell(VTK_TRIANGLE, ids);
    }
    blocks->SetBlock(b, block);
  }
  vtkNew<Filter> filter;
  filter->GenerateErrorBoundsOn();
  filter->SetInputDataObject(blocks);
  filter->Update();
  auto* made = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  const Grid expected = Execute(whole, 1, [](Filter* f) { f->GenerateErrorBoundsOn(); });
  vtkDataArray* bounds = expected->GetCellData()->GetArray("ErrorBound");
  for (unsigned b = 0; b < 2; ++b)
  {
    auto* block = vtkUnstructuredGrid::SafeDownCast(made->GetBlock(b));
    vtkDataArray* ofBlock = block->GetCellData()->GetArray("ErrorBound");
    ASSERT_NE(ofBlock, nullptr);
    ASSERT_EQ(ofBlock->GetNumberOfTuples(), 24);
    for (vtkIdType c = 0; c < 24; ++c)
    {
      EXPECT_NEAR(ofBlock->GetComponent(c, 0), bounds->GetComponent(24 * b + c, 0), 1e-12);
    }
  }
}

TEST(ErrorBounds, GoOnWithAFilterBefore)
{
  const Grid input = MakeBipyramid(5, 0.4);
  const Configure configure = [](Filter* filter) { filter->GenerateErrorBoundsOn(); };
  const Grid both = Execute(input, 2, configure);
  const Grid second = Execute(Execute(input, 1, configure), 1, configure);
  vtkDataArray* a = both->GetCellData()->GetArray("ErrorBound");
  vtkDataArray* b = second->GetCellData()->GetArray("ErrorBound");
  ASSERT_EQ(a->GetNumberOfTuples(), b->GetNumberOfTuples());
  for (vtkIdType c = 0; c < a->GetNumberOfTuples(); ++c)
  {
    EXPECT_NEAR(a->GetComponent(c, 0), b->GetComponent(c, 0), 1e-12);
  }
  EXPECT_EQ(second->GetPointData()->GetArray("SmoothingDistanceSmoothingDistance"), nullptr);
}

TEST(ErrorBounds, SayWhereThereAreNone)
{
  const auto expectWarning =
    [](vtkUnstructuredGrid* input, const Configure& configure, const std::string& part)
  {
    vtkNew<Messages> messages;
    const Grid output = Execute(
      input, 1,
      [&](Filter* filter)
      {
        filter->GenerateErrorBoundsOn();
        configure(filter);
      },
      messages);
    EXPECT_TRUE(messages->Errors.empty());
    EXPECT_EQ(messages->CountWarnings(part), 1) << part;
    EXPECT_EQ(messages->CountWarnings("GenerateErrorBounds is ignored"), 1) << part;
    EXPECT_GT(output->GetNumberOfCells(), 0);
    EXPECT_EQ(output->GetCellData()->GetArray("ErrorBound"), nullptr);
  };
  const Grid solid = MakeKuhnBox(1);
  expectWarning(
    solid,
    [](Filter* f)
    {
      f->SetVolumeSchemeToLinear();
      f->KeepCellTypesOn();
    },
    "KeepCellTypes");
  expectWarning(solid, [](Filter* f) { f->SetOutputCellsToBezier(); }, "Bezier cells");
  const Grid creased = MakeFan(6, { { VTK_LINE, { 0, 1 } }, { VTK_LINE, { 0, 4 } } });
  vtkNew<vtkDoubleArray> sharpness;
  sharpness->SetName("Sharpness");
  sharpness->SetNumberOfTuples(creased->GetNumberOfCells());
  sharpness->Fill(0.);
  sharpness->SetComponent(creased->GetNumberOfCells() - 1, 0, 2.5);
  creased->GetCellData()->AddArray(sharpness);
  const Configure sharp = [](Filter* filter)
  {
    filter->GenerateErrorBoundsOn();
    SetCellArray(filter, 4, "Sharpness");
  };
  expectWarning(creased, sharp, "still sharp");
  EXPECT_NE(Execute(creased, 2, sharp)->GetCellData()->GetArray("ErrorBound"), nullptr);
}

TEST(ErrorBounds, NeedMemoryForThreeMoreLevels)
{
  vtkNew<Messages> messages;
  const Grid output = Execute(
    MakeKuhnBox(2), 1,
    [](Filter* filter)
    {
      filter->GenerateErrorBoundsOn();
      filter->SetMaximumNumberOfCells(1000);
    },
    messages);
  ASSERT_FALSE(messages->Errors.empty());
  EXPECT_NE(messages->Errors[0].find("GenerateErrorBounds"), std::string::npos);
  EXPECT_EQ(output->GetNumberOfCells(), 0);
}
