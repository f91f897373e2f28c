// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestTetOctErrorBounds.cxx
 * GenerateErrorBounds with VolumeScheme = TetOct, whose octahedra are written as four tetrahedra.
 */
#include "TetOctBoundTools.h"

using namespace bound_tools;

namespace
{

/// One tetrahedron, n of them around an edge, or 8 around a vertex.
Grid MakeStar(int n, double noise)
{
  std::mt19937 random(static_cast<unsigned>(n));
  const auto draw = [&] { return noise * (random() / 4294967296. - 0.5); };
  std::vector<Point> points;
  std::vector<Cell> cells;
  if (n == 8)
  {
    points.push_back({ draw(), draw(), draw() });
    for (int i = 0; i < 6; ++i)
    {
      Point p{ draw(), draw(), draw() };
      p[i / 2] += i % 2 ? -1. : 1.;
      points.push_back(p);
    }
    for (int i = 0; i < 8; ++i)
    {
      cells.push_back({ VTK_TETRA, { 0, 1 + i % 2, 3 + i / 2 % 2, 5 + i / 4 } });
    }
  }
  else if (n == 1)
  {
    points = { { draw(), 0., 0. }, { 1., draw(), 0. }, { 0., 1., 0. }, { 0., 0., 1. } };
    cells = { { VTK_TETRA, { 0, 1, 2, 3 } } };
  }
  else
  {
    points = { { draw(), 0., 1. }, { draw(), 0., -1. } };
    for (vtkIdType i = 0; i < n; ++i)
    {
      const double angle = 2. * 3.14159265358979 * static_cast<double>(i) / n;
      points.push_back({ std::cos(angle) + draw(), std::sin(angle) + draw(), draw() });
      cells.push_back({ VTK_TETRA, { 0, 1, 2 + i, 2 + (i + 1) % n } });
    }
  }
  return WithValues(MakeGrid(points, cells));
}

void SetTetOct(Filter* filter)
{
  filter->SetVolumeSchemeToTetOct();
}

}

TEST(TetOctErrorBounds, HoldAtRandomPlaces)
{
  std::mt19937 random(5);
  vtkIdType places = 0;
  const auto check = [&](vtkUnstructuredGrid* mesh, int levels, int count, bool projects)
  {
    const Grid input = WithValues(mesh);
    vtkNew<Filter> filter;
    SetTetOct(filter);
    const Grid output = UpdateWithBounds(filter.Get(), input, levels, projects);
    const std::vector<TetOctSolid> solids = FindTetOctSolids(input, levels);
    PlacesOfParts drawn;
    for (int i = 0; i < count; ++i)
    {
      const TetOctSolid& solid = solids[random() % solids.size()];
      const vtkIdType part =
        solid.Cell + (solid.IsOct() ? static_cast<vtkIdType>(random() % 4) : 0);
      const Ids corners = GetCell(output, part);
      const std::array<double, 4> weights = DrawWeights(random, 4);
      Point place{};
      for (int k = 0; k < 4; ++k)
      {
        const auto at = std::find(solid.Points.begin(), solid.Points.end(), corners[k]);
        for (int x = 0; x < 3; ++x)
        {
          place[x] += weights[k] * solid.Places[at - solid.Points.begin()][x];
        }
      }
      drawn.Add(part, weights, static_cast<vtkIdType>(solid.Of), place);
    }
    ExpectBoundsAtPlaces(filter, output, drawn);
    places += count;
  };
  for (const bool projects : { false, true })
  {
    for (const int n : { 3, 4, 5, 8 })
    {
      check(MakeStar(n, 0.3), n % 2, 4500, projects);
    }
  }
  check(MakeStar(5, 0.3), 2, 4500, false);
  EXPECT_GT(places, 40000);
}

TEST(TetOctErrorBounds, HoldAndAreNearTheTruth)
{
  vtkIdType samples = 0;
  for (const bool projects : { false, true })
  {
    for (const int n : { 1, 3, 4, 7, 8 })
    {
      for (const int levels : { 0, 1, 2 })
      {
        Tightness found;
        ExpectTetOctBounds(MakeStar(n, 0.3), levels, levels == 2 ? 3 : 4, {}, projects, found);
        EXPECT_LT(found.GetMedian(), projects ? 2.5 : 1.3) << n << " " << levels;
        EXPECT_LT(found.GetLargest(), 3.) << n << " " << levels << " " << projects;
        samples += found.Samples;
      }
    }
  }
  EXPECT_GT(samples, 1000000);
}

TEST(TetOctErrorBounds, AreNearTheTruthOnRandomComplexes)
{
  Tightness found;
  std::vector<unsigned> seeds(99);
  std::iota(seeds.begin(), seeds.end(), 1U);
  seeds.push_back(270); // two tetrahedra are equal, with other orders of corners after a level
  for (const unsigned seed : seeds)
  {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    random();
    const Grid input = WithValues(MakeRandomComplex(seed));
    const unsigned bits = random() >> 4;
    const Configure configure = ChooseFeatures(bits);
    ExpectTetOctBounds(input, bits / 120 % 2, 3, configure, bits / 60 % 2 == 0, found);
  }
  ExpectRatios(found, 5000, 2.45);
}

/// A filter that reads octahedra starts with them.
TEST(TetOctErrorBounds, GoOnWithAFilterBefore)
{
  const Grid input = MakeStar(4, 0.3);
  const Configure configure = [](Filter* filter)
  {
    SetTetOct(filter);
    filter->GenerateErrorBoundsOn();
  };
  const Grid both = Execute(input, 2, configure);
  const Grid first = Execute(input, 1, configure);
  const Grid second = Execute(first, 1, configure);
  const Grid none = Execute(first, 0, configure);
  const auto expectSame = [](vtkUnstructuredGrid* one, vtkUnstructuredGrid* other)
  {
    for (const char* name : { "ErrorBound", "OneErrorBound", "TwoErrorBound" })
    {
      vtkDataArray* a = one->GetCellData()->GetArray(name);
      vtkDataArray* b = other->GetCellData()->GetArray(name);
      ASSERT_EQ(a->GetNumberOfTuples(), b->GetNumberOfTuples());
      for (vtkIdType c = 0; c < a->GetNumberOfTuples(); ++c)
      {
        EXPECT_GT(a->GetComponent(c, 0), 0.);
        EXPECT_NEAR(a->GetComponent(c, 0), b->GetComponent(c, 0), 1e-12) << name << " of " << c;
      }
    }
  };
  expectSame(both, second);
  expectSame(first, none);
}

TEST(TetOctErrorBounds, DoNotDependOnThreads)
{
  const Configure configure = [](Filter* filter)
  {
    SetTetOct(filter);
    filter->GenerateErrorBoundsOn();
    filter->ProjectToLimitOn();
  };
  const Grid one = MakeInThreads([&] { return Execute(MakeStar(8, 0.3), 1, configure); });
  ASSERT_NE(one->GetCellData()->GetArray("ErrorBound"), nullptr);
}
