// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestModifiedBoundary.cxx
 * The survey's rules next to boundaries, creases and corners in the main filter: against
 * vtkSurfaceSubdivision, on solids, in a row, with limits and normals.
 */
#include "BezierTools.h"
#include "ModifiedBoundaryTools.h"
#include "PlaceTools.h"

#include "vtkAdaptiveSurfaceSubdivision.h"
#include "vtkRedGreenRefinement.h"
#include "vtkSimplicialComplexTopology.h"
#include "vtkSubdivisionDeformation.h"
#include "vtkSubdivisionLimitProbe.h"
#include "vtkSubdivisionModelSource.h"
#include "vtkSubdivisionSmoothness.h"
#include "vtkSurfaceSubdivision.h"

using namespace modified_boundary_tools;

TEST(ModifiedBoundary, SurfacesAreThoseOfTheSurfaceFilter)
{
  for (unsigned seed = 0; seed < 40; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto input = MakeCreased(seed, seed % 2);
    for (int levels = 0; levels <= 3; ++levels)
    {
      ExpectSameSurfaces(input, levels, false, false);
      ExpectSameSurfaces(input, levels, true, false);
    }
    // Normals of a crease are those of one side in the surface filter, of both in the other one.
    ExpectSameSurfaces(WithoutCorners(input), 1, true, true);
  }
}

/// Creases that are sharp for whole levels have all rules near them in both filters.
TEST(ModifiedBoundary, SemiSharpCreasesAreThoseOfTheSurfaceFilter)
{
  for (unsigned seed = 0; seed < 40; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto input = MakeSemiSharp(seed);
    for (int levels = 0; levels <= 3; ++levels)
    {
      ExpectSameSurfaces(input, levels, false, false);
      ExpectSameSurfaces(input, levels, true, false);
    }
  }
}

TEST(ModifiedBoundary, IsOnInAllFilters)
{
  const std::vector<vtkSmartPointer<vtkSubdivisionAlgorithm>> filters = {
    vtkSmartPointer<vtkAdaptiveSurfaceSubdivision>::New(), vtkSmartPointer<Filter>::New(),
    vtkSmartPointer<vtkRedGreenRefinement>::New(),
    vtkSmartPointer<vtkSimplicialComplexTopology>::New(),
    vtkSmartPointer<vtkSubdivisionDeformation>::New(),
    vtkSmartPointer<vtkSubdivisionLimitProbe>::New(),
    vtkSmartPointer<vtkSubdivisionSmoothness>::New(), vtkSmartPointer<vtkSurfaceSubdivision>::New()
  };
  for (vtkSubdivisionAlgorithm* filter : filters)
  {
    EXPECT_TRUE(filter->GetModifiedBoundary()) << filter->GetClassName();
    filter->ModifiedBoundaryOff();
    EXPECT_FALSE(filter->GetModifiedBoundary()) << filter->GetClassName();
  }
}

TEST(ModifiedBoundary, ChangesSomethingButLinearLevels)
{
  const auto input = MakeCreased(3, true);
  const Configure plain = [](Filter* filter) { filter->ModifiedBoundaryOff(); };
  EXPECT_NE(Compare(Execute(input, 2), Execute(input, 2, plain)), "");
  const Configure linear = [](Filter* filter)
  {
    filter->SetVolumeSchemeToLinear();
    filter->ProjectToLimitOn();
    filter->GenerateLimitNormalsOn();
    filter->GenerateTangentsOn();
  };
  const Configure both = [=](Filter* filter)
  {
    linear(filter);
    plain(filter);
  };
  EXPECT_EQ(Compare(Execute(input, 2, linear), Execute(input, 2, both)), "");
}

/// A tube of triangles, three at each boundary vertex: both rules are the same, bit for bit.
TEST(ModifiedBoundary, RegularBoundariesKeepTheirBits)
{
  std::vector<Point> points;
  std::vector<Cell> cells;
  constexpr vtkIdType around = 7;
  for (vtkIdType i = 0; i < 4 * around; ++i)
  {
    const double angle = 0.9 * static_cast<double>(i % around);
    points.push_back({ std::cos(angle), std::sin(angle), 0.3 * static_cast<double>(i / around) });
    const vtkIdType right = i - i % around + (i + 1) % around;
    if (i < 3 * around)
    {
      cells.push_back({ VTK_TRIANGLE, { i, right, right + around } });
      cells.push_back({ VTK_TRIANGLE, { i, right + around, i + around } });
    }
  }
  const Grid tube = MakeGrid(points, cells);
  for (const bool limit : { false, true })
  {
    const Grid on = Execute(tube, 2,
      [=](Filter* filter)
      {
        filter->SetInputArrayToProcess(10, 0, 0, 0, "None");
        filter->SetProjectToLimit(limit);
        filter->SmoothShadingOff();
      });
    const Grid off = Execute(tube, 2,
      [=](Filter* filter)
      {
        filter->SetInputArrayToProcess(10, 0, 0, 0, "None");
        filter->ModifiedBoundaryOff();
        filter->SetProjectToLimit(limit);
        filter->SmoothShadingOff();
      });
    EXPECT_EQ(Compare(on, off), "");
  }
}

namespace
{

/// Expects that each point of the surface is one of the solid.
void ExpectPointsOf(vtkUnstructuredGrid* solids, vtkUnstructuredGrid* surface)
{
  std::vector<Point> solid;
  for (vtkIdType i = 0; i < solids->GetNumberOfPoints(); ++i)
  {
    solid.push_back(GetPoint(solids, i));
  }
  std::sort(solid.begin(), solid.end());
  std::set<vtkIdType> used;
  for (const Ids& cell : GetCells(surface))
  {
    used.insert(cell.begin(), cell.end());
  }
  const double off = 1e-13 * surface->GetLength();
  for (const vtkIdType i : used)
  {
    const Point p = GetPoint(surface, i);
    auto at = std::lower_bound(solid.begin(), solid.end(), Point{ p[0] - off, -1e9, -1e9 });
    double least = 1e9;
    for (; at != solid.end() && (*at)[0] <= p[0] + off; ++at)
    {
      least = std::min(least, std::max(std::abs((*at)[1] - p[1]), std::abs((*at)[2] - p[2])));
    }
    ASSERT_LT(least, off) << "point " << i;
  }
}

}

/// The boundary of a solid, with creases and corners on it, is that surface subdivided alone.
TEST(ModifiedBoundary, BoundariesOfSolidsAreSurfaces)
{
  int count = 0;
  for (int model = 0; model < vtkSubdivisionModelSource::NUMBER_OF_MODELS; ++model)
  {
    vtkNew<vtkSubdivisionModelSource> source;
    source->SetModel(model);
    source->Update();
    const Grid solids = bezier_tools::TakeSolids(source->GetOutput());
    if (solids->GetNumberOfCells() == 0)
    {
      continue;
    }
    ++count;
    solids->GetPointData()->AddArray(
      MakeArray<vtkDoubleArray>(AngleName, 1, solids->GetNumberOfPoints(), 0., 360., 5));
    const Grid boundary = bezier_tools::TakeBoundary(solids);
    boundary->GetPointData()->ShallowCopy(solids->GetPointData());
    for (const int scheme : { Filter::BOX_SPLINE, Filter::TET_OCT })
    {
      SCOPED_TRACE(testing::Message() << "model " << model << ", scheme " << scheme);
      const Configure configure = [=](Filter* filter)
      {
        filter->SetVolumeScheme(scheme);
        filter->DetectFeaturesOn();
        filter->ProjectToLimitOn();
      };
      ExpectPointsOf(Execute(solids, 2, configure), Execute(boundary, 2, configure));
    }
  }
  EXPECT_GE(count, 4);
}

TEST(ModifiedBoundary, FiltersInARowAreOne)
{
  const Grid box = MakeBox();
  for (const int scheme : { Filter::BOX_SPLINE, Filter::TET_OCT })
  {
    for (const bool cached : { true, false })
    {
      const Configure configure = [=](Filter* filter)
      {
        UseFeatures(filter);
        filter->SetVolumeScheme(scheme);
        filter->SetCacheOperator(cached);
      };
      const Grid whole = Execute(box, 3, configure);
      Grid step = box;
      for (int level = 0; level < 3; ++level)
      {
        step = Execute(step, 1, configure);
      }
      EXPECT_EQ(Compare(step, whole), "") << "scheme " << scheme << " cached " << cached;
    }
  }
}

TEST(ModifiedBoundary, LimitsDoNotDependOnLevels)
{
  const Grid box = MakeBox();
  for (const int scheme : { Filter::BOX_SPLINE, Filter::TET_OCT })
  {
    const auto limit = [&](int levels)
    {
      return Execute(box, levels,
        [=](Filter* filter)
        {
          UseFeatures(filter);
          filter->SetVolumeScheme(scheme);
          filter->ProjectToLimitOn();
        });
    };
    const Grid early = limit(0);
    for (int levels = 1; levels < 3; ++levels)
    {
      const Grid late = limit(levels);
      for (vtkIdType i = 0; i < box->GetNumberOfPoints(); ++i)
      {
        const Point a = GetPoint(early, i);
        const Point b = GetPoint(late, i);
        ASSERT_LT(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), 1e-12)
          << "point " << i << " after " << levels << " levels, scheme " << scheme;
      }
    }
  }
}

/// The limit at places of triangles is that of the points which levels make there.
TEST(ModifiedBoundary, PlacesAreThoseOfLevels)
{
  for (unsigned seed = 2; seed < 20; seed += 3)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto input = MakeSemiSharp(seed);
    const auto configure = [](Filter* filter)
    {
      SetAngles(filter);
      filter->SetCreaseEndToDart();
      filter->SetInputArrayToProcess(4, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Sharpness");
    };
    const Grid fine = Execute(input, 2,
      [&](Filter* filter)
      {
        configure(filter);
        filter->ProjectToLimitOn();
      });
    vtkNew<vtkIdTypeArray> cells;
    vtkNew<vtkDoubleArray> parameters;
    parameters->SetNumberOfComponents(3);
    Ids expected;
    const vtkIdType first = input->GetNumberOfVerts() + input->GetNumberOfLines();
    const vtkIdType begin = input->GetNumberOfVerts() + 4 * input->GetNumberOfLines();
    for (vtkIdType i = 0; i < input->GetNumberOfPolys(); ++i)
    {
      // Children are consecutive: at the first corner, and in the middle of the middle one.
      const Ids corner = GetCell(fine, begin + 16 * i);
      const Ids middle = GetCell(fine, begin + 16 * i + 15);
      const std::pair<vtkIdType, Point> places[] = { { corner[0], { 0., 0., 0. } },
        { corner[1], { 0.25, 0., 0. } }, { corner[2], { 0., 0.25, 0. } },
        { middle[0], { 0.5, 0.25, 0. } } };
      for (const auto& [point, place] : places)
      {
        cells->InsertNextValue(first + i);
        parameters->InsertNextTuple(place.data());
        expected.push_back(point);
      }
    }
    vtkNew<Filter> filter;
    configure(filter);
    filter->SetInputData(input);
    vtkNew<vtkPolyData> result;
    ASSERT_TRUE(filter->EvaluateLimit(cells, parameters, result));
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
      const Point a = GetPoint(result, static_cast<vtkIdType>(i));
      const Point b = GetPoint(fine, expected[i]);
      ASSERT_LT(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), 1e-12) << "place " << i;
    }
  }
}

/// A place in the middle of a triangle is near the edges that end on a border.
TEST(ModifiedBoundary, PlacesAreThoseOfTheSurfaceFilter)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto input = WithoutCorners(MakeCreased(seed, false));
    std::mt19937 random(seed);
    place_tools::Places places;
    for (vtkIdType i = 0; i < 20 * input->GetNumberOfPolys(); ++i)
    {
      double u = random() / 4294967296.;
      double v = random() / 4294967296.;
      if (u + v > 1.)
      {
        u = 1. - u;
        v = 1. - v;
      }
      places.Add(i / 20, { u, v, 0. });
    }
    vtkNew<Filter> main;
    main->SetInputData(input);
    vtkNew<vtkSurfaceSubdivision> loop;
    loop->SetInputData(input);
    EXPECT_LT(GetDifference(Collect(place_tools::Evaluate(main.Get(), places), places.GetSize()),
                Collect(place_tools::Evaluate(loop.Get(), places), places.GetSize())),
      1e-12);
  }
}

TEST(ModifiedBoundary, ThreadsDoNotMatter)
{
  const Grid box = MakeBox();
  MakeInThreads(
    [&]
    {
      return Execute(box, 3,
        [](Filter* filter)
        {
          UseFeatures(filter);
          filter->ProjectToLimitOn();
          filter->GenerateLimitNormalsOn();
        });
    });
}

TEST(ModifiedBoundary, OnlyAnglesOfCornersChangeTheOperator)
{
  vtkNew<Filter> filter;
  SetAngles(filter.Get());
  const Grid box = MakeBox();
  filter->SetVolumeSchemeToBoxSpline();
  filter->DetectFeaturesOn();
  const Grid first = UpdateWithoutErrors<vtkUnstructuredGrid>(filter.Get(), box);
  EXPECT_EQ(filter->GetNumberOfTopologyBuilds(), 1);
  const Grid other = DeepCopy(box);
  other->GetPointData()->GetArray(AngleName)->Fill(200.);
  const Grid second = UpdateWithoutErrors<vtkUnstructuredGrid>(filter.Get(), other);
  EXPECT_EQ(filter->GetNumberOfTopologyBuilds(), 2);
  EXPECT_NE(GetDifference(Collect(first, 0), Collect(second, 0)), 0.);
  const Grid fresh = Execute(other, 1, [](Filter* f) { f->DetectFeaturesOn(); });
  EXPECT_EQ(Compare(second, fresh), "");
}

/// Without angles, which would show in what is kept.
TEST(ModifiedBoundary, SwitchedFiltersMakeWhatFreshOnesMake)
{
  const auto input = MakeCreased(3, true);
  vtkNew<Filter> filter;
  for (const bool modified : { true, false, true })
  {
    const Configure configure = [=](Filter* f)
    {
      f->SetInputArrayToProcess(10, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "None");
      f->SetModifiedBoundary(modified);
    };
    configure(filter);
    const Grid made = UpdateWithoutErrors<vtkUnstructuredGrid>(filter.Get(), input);
    EXPECT_EQ(Compare(made, Execute(input, 1, configure)), "") << modified;
  }
}

/// No crease is semi-sharp: the last two steps are one where operators are not kept.
TEST(ModifiedBoundary, KeptOperatorsDoNotMatter)
{
  const auto input = MakeCreased(3, true);
  for (const int scheme : { Filter::BOX_SPLINE, Filter::TET_OCT })
  {
    Grid made[2];
    for (const bool cached : { false, true })
    {
      made[cached] = Execute(input, 2,
        [=](Filter* filter)
        {
          filter->SetVolumeScheme(scheme);
          filter->SetCacheOperator(cached);
        });
    }
    EXPECT_EQ(Compare(made[0], made[1]), "") << "scheme " << scheme;
  }
}

TEST(ModifiedBoundary, AnArrayThatIsMissingIsAnError)
{
  vtkNew<Messages> messages;
  vtkNew<Filter> filter;
  messages->Watch(filter);
  filter->SetInputArrayToProcess(10, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Nothing");
  filter->SetInputData(MakeBox());
  filter->Update();
  ASSERT_FALSE(messages->Errors.empty());
  EXPECT_NE(messages->Errors[0].find("Nothing"), std::string::npos);
}
