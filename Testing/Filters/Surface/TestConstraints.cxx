// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestConstraints.cxx
 * Interpolation of some points and values, and prescribed normals: what is wanted holds, all else
 * stays where smoothing leaves it, or moves little.
 */
#include "SurfaceTools.h"

#include "vtkSubdivisionModelSource.h"
#include "vtkSubdivisionOperator.h"

using namespace surfacetools;
using multi_dimensional_subdivision_tools::LoadModel;
using multi_dimensional_subdivision_tools::Messages;

namespace
{

using Filter = vtkSurfaceSubdivision;

constexpr int Points = vtkDataObject::FIELD_ASSOCIATION_POINTS;

/// A bumpy torus of triangles or quads: 12 times 14 points.
Model MakeTorus(bool triangles)
{
  constexpr int m = 14;
  constexpr int n = 12;
  Model torus;
  for (int i = 0; i < m * n; ++i)
  {
    const double a = 2. * vtkMath::Pi() * (i % m) / m;
    const double b = 2. * vtkMath::Pi() * (i / m) / n;
    const double r = 1. + 0.1 * std::sin(3. * i * i);
    torus.Points.push_back({ (3. + r * std::cos(b)) * std::cos(a),
      (3. + r * std::cos(b)) * std::sin(a), r * std::sin(b) });
  }
  for (int i = 0; i < m * n; ++i)
  {
    const vtkIdType row = i / m * m;
    const vtkIdType above = (row + m) % (m * n);
    const vtkIdType next = (i + 1) % m;
    const vtkIdType quad[4] = { i, row + next, above + next, above + i % m };
    if (triangles)
    {
      torus.Faces.push_back({ quad[0], quad[1], quad[2] });
      torus.Faces.push_back({ quad[0], quad[2], quad[3] });
    }
    else
    {
      torus.Faces.push_back({ quad[0], quad[1], quad[2], quad[3] });
    }
  }
  return torus;
}

/// Adds the weights "Chosen", 0 but where they are given, and the values "spike".
template <typename Mesh>
vtkSmartPointer<Mesh> Choose(Mesh* mesh, const std::map<vtkIdType, double>& chosen)
{
  vtkNew<vtkDoubleArray> weights;
  weights->SetName("Chosen");
  vtkNew<vtkDoubleArray> spike;
  spike->SetName("spike");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const auto found = chosen.find(i);
    weights->InsertNextValue(found == chosen.end() ? 0. : found->second);
    spike->InsertNextValue(i == chosen.begin()->first ? 1. : 0.);
  }
  auto copy = vtkSmartPointer<Mesh>::New();
  copy->ShallowCopy(mesh);
  copy->GetPointData()->AddArray(weights);
  copy->GetPointData()->AddArray(spike);
  return copy;
}

/// Limits of the control points of a mesh.
template <typename FilterClass, typename Mesh>
vtkSmartPointer<Mesh> FindLimits(Mesh* input, const std::function<void(FilterClass*)>& configure)
{
  vtkNew<FilterClass> filter;
  filter->SetNumberOfLevels(0);
  filter->ProjectToLimitOn();
  filter->AddInterpolatedArray("spike");
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  configure(filter);
  return multi_dimensional_subdivision_tools::UpdateWithoutErrors<Mesh>(filter.Get(), input);
}

/// Limits are on their part of the way for chosen points, and the others move less than with all.
template <typename FilterClass, typename Mesh>
void ExpectChosen(Mesh* input, const std::map<vtkIdType, double>& chosen,
  const std::function<void(FilterClass*)>& configure)
{
  const auto given = Choose(input, chosen);
  const auto plain = FindLimits<FilterClass, Mesh>(given, configure);
  const auto run = [&](bool some)
  {
    return FindLimits<FilterClass, Mesh>(given,
      [&](FilterClass* filter)
      {
        configure(filter);
        filter->InterpolatePointsOn();
        filter->InterpolateArraysOn();
        some ? filter->SetInputArrayToProcess(13, 0, 0, Points, "Chosen") : void();
      });
  };
  const auto made = run(true);
  const auto all = run(false);
  double moved = 0.;
  double movedOfAll = 0.;
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    const Point before = multi_dimensional_subdivision_tools::GetPoint(plain, i);
    const Point now = multi_dimensional_subdivision_tools::GetPoint(made, i);
    Point wanted = multi_dimensional_subdivision_tools::GetPoint(input, i);
    const auto found = chosen.find(i);
    if (found == chosen.end())
    {
      moved = std::max(moved, GetDistance(now, before));
      movedOfAll = std::max(
        movedOfAll, GetDistance(multi_dimensional_subdivision_tools::GetPoint(all, i), before));
      continue;
    }
    for (int c = 0; c < 3; ++c)
    {
      wanted[c] = before[c] + found->second * (wanted[c] - before[c]);
    }
    EXPECT_LT(GetDistance(now, wanted), 1e-10 * input->GetLength()) << i;
  }
  EXPECT_GT(moved, 0.);
  EXPECT_LT(moved, movedOfAll);
}

std::function<void(Filter*)> WithScheme(int scheme)
{
  return [scheme](Filter* filter) { filter->SetScheme(scheme); };
}

/// The largest sine of the angle between normals of limits and the wanted ones.
double FindTurn(vtkPolyData* made, const std::map<vtkIdType, Point>& wanted)
{
  double most = 0.;
  for (const auto& [i, normal] : wanted)
  {
    const Point now = multi_dimensional_subdivision_tools::GetTuple(made, "LimitNormals", i);
    Point cross{};
    vtkMath::Cross(now.data(), normal.data(), cross.data());
    most = std::max(most, vtkMath::Norm(cross.data()) / vtkMath::Norm(normal.data()));
  }
  return most;
}

vtkSmartPointer<vtkPolyData> WithNormals(
  vtkPolyData* input, const std::map<vtkIdType, Point>& wanted)
{
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("Wanted");
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    const auto found = wanted.find(i);
    const Point normal = found == wanted.end() ? Point{ 0., 0., 0. } : found->second;
    normals->InsertNextTuple(normal.data());
  }
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(input);
  copy->GetPointData()->AddArray(normals);
  return copy;
}

const auto Prescribed = [](Filter* filter)
{
  filter->GenerateLimitNormalsOn();
  filter->SetInputArrayToProcess(14, 0, 0, Points, "Wanted");
};

}

TEST(Constraints, ChosenPointsOfSurfaces)
{
  for (const int scheme : { Filter::LOOP, Filter::CATMULL_CLARK, Filter::SQRT_THREE })
  {
    SCOPED_TRACE(scheme);
    const auto input = MakeInput(MakeTorus(scheme != Filter::CATMULL_CLARK));
    ExpectChosen<Filter, vtkPolyData>(
      input, { { 5, 1. }, { 6, 1. }, { 40, 0.5 }, { 100, 1. } }, WithScheme(scheme));
  }
}

TEST(Constraints, ChosenPointsOfSolidsAndCurves)
{
  using Solids = vtkMultiDimensionalSubdivision;
  const auto solid = multi_dimensional_subdivision_tools::InDouble(
    LoadModel(vtkSubdivisionModelSource::MATERIAL_BLOCK, vtkAlgorithm::DOUBLE_PRECISION));
  for (const int scheme : { Solids::BOX_SPLINE, Solids::TET_OCT })
  {
    ExpectChosen<Solids, vtkUnstructuredGrid>(solid.Get(), { { 0, 1. }, { 3, 1. }, { 8, 0.25 } },
      [scheme](Solids* filter) { filter->SetVolumeScheme(scheme); });
  }
  std::vector<Point> points;
  std::vector<multi_dimensional_subdivision_tools::Cell> lines;
  for (vtkIdType i = 0; i < 9; ++i)
  {
    const auto x = static_cast<double>(i);
    points.push_back({ x, std::sin(x * x), std::cos(2. * x) });
    i > 0 ? lines.push_back({ VTK_LINE, { i - 1, i } }) : void();
  }
  const auto curve = multi_dimensional_subdivision_tools::MakeGrid(points, lines);
  ExpectChosen<Solids, vtkUnstructuredGrid>(curve.Get(), { { 2, 1. }, { 6, 1. } }, [](Solids*) {});
}

/// One datum moves one control value, and nothing exceeds the range: with all points chosen
/// everything moves.
TEST(Constraints, OneDatumIsLocal)
{
  const auto input = Choose(MakeInput(MakeTorus(true)).Get(), { { 50, 1. } });
  const auto run = [&](bool some)
  {
    return FindLimits<Filter, vtkPolyData>(input,
      [&](Filter* filter)
      {
        filter->SetScheme(Filter::LOOP);
        filter->ProjectToLimitOff();
        filter->InterpolateArraysOn();
        some ? filter->SetInputArrayToProcess(13, 0, 0, Points, "Chosen") : void();
      });
  };
  const auto count = [&](vtkPolyData* made)
  {
    int moved = 0;
    for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
    {
      const double value = made->GetPointData()->GetArray("spike")->GetComponent(i, 0);
      EXPECT_GE(value, made == nullptr ? 0. : -1.);
      moved += value != (i == 50 ? 1. : 0.);
    }
    return moved;
  };
  EXPECT_EQ(count(run(true)), 1);
  EXPECT_GT(count(run(false)), 100);
  for (const bool some : { true, false })
  {
    vtkNew<Filter> filter;
    vtkNew<Messages> heard;
    heard->Watch(filter);
    filter->SetScheme(Filter::LOOP);
    filter->SetNumberOfLevels(3);
    filter->ProjectToLimitOn();
    filter->InterpolateArraysOn();
    filter->AddInterpolatedArray("spike");
    some ? filter->SetInputArrayToProcess(13, 0, 0, Points, "Chosen") : void();
    filter->SetInputData(input);
    filter->Update();
    EXPECT_EQ(heard->CountWarnings("exceed the range"), some ? 0 : 1);
    double range[2];
    filter->GetOutput()->GetPointData()->GetArray("spike")->GetRange(range);
    EXPECT_NEAR(range[1], 1., some ? 1e-10 : 0.2);
    EXPECT_EQ(range[0] >= 0., some);
  }
}

TEST(Constraints, NormalsOfTheLimit)
{
  const std::map<vtkIdType, Point> wanted{ { 5, { 0., 0., 2. } }, { 6, { 1., 2., 3. } },
    { 90, { -1., 0.5, 0.2 } } };
  for (const int scheme :
    { Filter::LOOP, Filter::CATMULL_CLARK, Filter::SQRT_THREE, Filter::MODIFIED_BUTTERFLY })
  {
    SCOPED_TRACE(scheme);
    const bool triangles = scheme != Filter::CATMULL_CLARK;
    const auto input = WithNormals(MakeInput(MakeTorus(triangles)), wanted);
    const auto chosen = Choose(input.Get(), { { 5, 1. }, { 40, 1. } });
    const auto plain = FindLimits<Filter, vtkPolyData>(chosen,
      [scheme](Filter* filter)
      {
        filter->SetScheme(scheme);
        filter->GenerateLimitNormalsOn();
      });
    EXPECT_GT(FindTurn(plain, wanted), 0.1);
    for (const bool interpolates : { false, true })
    {
      for (const int levels : { 0, 2 })
      {
        const auto made = FindLimits<Filter, vtkPolyData>(chosen,
          [&](Filter* filter)
          {
            filter->SetScheme(scheme);
            filter->SetNumberOfLevels(levels);
            filter->SetInterpolatePoints(interpolates);
            filter->SetInputArrayToProcess(13, 0, 0, Points, "Chosen");
            Prescribed(filter);
          });
        EXPECT_LT(FindTurn(made, wanted), 1e-10);
        int moved = 0;
        for (vtkIdType i = 0; i < input->GetNumberOfPoints() && levels == 0; ++i)
        {
          moved += GetDistance(multi_dimensional_subdivision_tools::GetPoint(plain, i),
                     multi_dimensional_subdivision_tools::GetPoint(made, i)) > 0.;
        }
        EXPECT_LT(moved, 110) << "of 168";
        for (const vtkIdType i : { 5, 40 })
        {
          EXPECT_TRUE(!interpolates ||
            GetDistance(multi_dimensional_subdivision_tools::GetPoint(made, i),
              multi_dimensional_subdivision_tools::GetPoint(input, i)) < 1e-9);
        }
      }
    }
  }
}

TEST(Constraints, NormalsHaveNoOperator)
{
  vtkNew<Filter> filter;
  vtkNew<Messages> heard;
  heard->Watch(filter);
  filter->SetScheme(Filter::LOOP);
  Prescribed(filter);
  filter->SetInputData(WithNormals(MakeInput(MakeTorus(true)), { { 7, { 0., 1., 1. } } }));
  vtkNew<vtkSubdivisionOperator> found;
  EXPECT_FALSE(filter->ComputeOperator(found));
  ASSERT_EQ(heard->Errors.size(), 1u);
  EXPECT_NE(heard->Errors[0].find("have no operator"), std::string::npos) << heard->Errors[0];
}

/// Where nothing is free there are no control points; faults of arrays are errors.
TEST(Constraints, FaultsAreTold)
{
  const auto mesh = MakeInput(MakeTorus(true));
  const auto run = [](vtkPolyData* input, bool points, const char* chosen, const char* normals)
  {
    vtkNew<Filter> filter;
    vtkNew<Messages> heard;
    heard->Watch(filter);
    filter->SetScheme(Filter::LOOP);
    filter->SetInterpolatePoints(points);
    chosen ? filter->SetInputArrayToProcess(13, 0, 0, Points, chosen) : void();
    normals ? filter->SetInputArrayToProcess(14, 0, 0, Points, normals) : void();
    filter->SetInputData(input);
    filter->Update();
    return heard->Errors.empty() ? heard->Warnings : heard->Errors;
  };
  const auto expect = [](const std::vector<std::string>& said, const char* part)
  {
    ASSERT_FALSE(said.empty());
    EXPECT_NE(said[0].find(part), std::string::npos) << said[0];
  };
  const auto input = Choose(mesh.Get(), { { 3, 1.5 } });
  expect(run(input, true, "Chosen", nullptr), "1.500000 of point 3");
  expect(run(input, true, "Absent", nullptr), "is not there");
  EXPECT_TRUE(run(input, false, "Chosen", nullptr).empty());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect(run(WithNormals(mesh, { { 7, { 0., nan, 1. } } }), false, nullptr, "Wanted"),
    "not finite at point 7");
  expect(run(input, false, nullptr, "Chosen"), "need three components");
  expect(run(WithNormals(mesh, { { 7, { 0., 1., 1. } } }), true, nullptr, "Wanted"),
    "No control points give the limit these normals");
  Model model = MakeTorus(true);
  model.Points.push_back({ 0., 0., 0. });
  expect(run(WithNormals(MakeInput(model), { { 168, { 0., 1., 1. } } }), false, nullptr, "Wanted"),
    "1 points, the first is point 168, have no tangents");
}
