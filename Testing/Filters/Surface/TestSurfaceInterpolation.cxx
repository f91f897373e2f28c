// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSurfaceInterpolation.cxx
 * InterpolatePoints and InterpolateArrays of vtkSurfaceSubdivision.
 */
#include "MultiDimensionalSubdivisionTools.h"
#include "SurfaceTools.h"

using namespace surfacetools;
using multi_dimensional_subdivision_tools::CompareValues;
using multi_dimensional_subdivision_tools::Messages;

namespace
{

using Filter = vtkSurfaceSubdivision;

constexpr int SchemesWithLimits[] = { Filter::LOOP, Filter::CATMULL_CLARK,
  Filter::MODIFIED_BUTTERFLY, Filter::SQRT_THREE };

vtkSmartPointer<vtkPolyData> MakeWithValues(const Model& model)
{
  const auto input = MakeInput(model);
  vtkNew<vtkDoubleArray> values;
  values->SetName("values");
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(std::sin(2. * static_cast<double>(i * i)));
  }
  input->GetPointData()->AddArray(values);
  vtkNew<vtkIntArray> flags;
  flags->SetName("Singular");
  vtkNew<vtkDoubleArray> sharpness;
  sharpness->SetName("Sharpness");
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    const bool isLine = cell < static_cast<vtkIdType>(model.Lines.size());
    flags->InsertNextValue(isLine && cell % 2 == 0);
    sharpness->InsertNextValue(isLine ? 1.5 : 0.);
  }
  input->GetCellData()->AddArray(flags);
  input->GetCellData()->AddArray(sharpness);
  return input;
}

void Configure(Filter* filter, int scheme, int levels, bool limit)
{
  filter->SetScheme(scheme);
  filter->SetNumberOfLevels(levels);
  filter->SetProjectToLimit(limit);
  filter->SetInputArrayToProcess(4, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Sharpness");
  filter->InterpolatePointsOn();
  filter->InterpolateArraysOn();
}

vtkSmartPointer<vtkPolyData> Update(Filter* filter, vtkPolyData* input)
{
  filter->SetInputDataObject(input);
  filter->Update();
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(filter->GetOutput());
  return copy;
}

/// The largest difference at the points of the input.
double FindError(vtkPolyData* input, vtkPolyData* output)
{
  double most = 0.;
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      most = std::max(
        most, std::abs(input->GetPoint(i)[c] - output->GetPoints()->GetData()->GetComponent(i, c)));
    }
    most = std::max(most,
      std::abs(input->GetPointData()->GetArray("values")->GetComponent(i, 0) -
        output->GetPointData()->GetArray("values")->GetComponent(i, 0)));
  }
  return most;
}

}

TEST(SurfaceInterpolation, TheLimitPassesThroughTheInput)
{
  for (const int scheme : SchemesWithLimits)
  {
    for (const auto& [name, model] : MakeZoo(scheme != Filter::CATMULL_CLARK))
    {
      const auto input = MakeWithValues(model);
      for (const int levels : { 0, 1, 2 })
      {
        SCOPED_TRACE(testing::Message() << name << ", scheme " << scheme << ", levels " << levels);
        vtkNew<Filter> filter;
        vtkNew<Messages> messages;
        messages->Watch(filter);
        Configure(filter, scheme, levels, true);
        const auto output = Update(filter, input);
        // Points of three quads each, and two triangles back to back: there is no solution.
        const bool isSingular = (name == "cube" && scheme == Filter::CATMULL_CLARK) ||
          (name == "pillow" && scheme == Filter::SQRT_THREE);
        EXPECT_EQ(messages->CountWarnings("does not pass") > 0, isSingular);
        EXPECT_TRUE(isSingular || FindError(input, output) < 2e-10) << "of ranges up to 2";
      }
    }
  }
}

/// Eight points of three quads each: control values whose limits alternate do not exist.
TEST(SurfaceInterpolation, WhatHasNoSolutionIsSaid)
{
  Model cube;
  for (int i = 0; i < 8; ++i)
  {
    cube.Points.push_back({ i & 1 ? 1. : 0., i & 2 ? 1. : 0., i & 4 ? 1. : 0. });
  }
  cube.Faces = { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 4, 6, 2 },
    { 1, 3, 7, 5 } };
  const auto input = MakeWithValues(cube);
  vtkDataArray* values = input->GetPointData()->GetArray("values");
  for (int i = 0; i < 8; ++i)
  {
    values->SetComponent(i, 0, (i ^ (i >> 1) ^ (i >> 2)) & 1 ? 1. : -1.);
  }
  vtkNew<Filter> filter;
  vtkNew<Messages> messages;
  messages->Watch(filter);
  Configure(filter, Filter::CATMULL_CLARK, 1, true);
  const auto output = Update(filter, input);
  EXPECT_EQ(messages->CountWarnings("values of the array values"), 1);
  EXPECT_EQ(messages->CountWarnings("through the points"), 0);
  for (int i = 0; i < 8; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(output->GetPoint(i)[c], cube.Points[i][c], 1e-9);
    }
  }
}

namespace
{

/// A sheet of quads and triangles with random points and heights, or the skin of a cube.
Model MakeRandomModel(std::mt19937& random)
{
  const auto draw = [&](int least, int most)
  { return least + static_cast<int>(random() % static_cast<unsigned>(most - least + 1)); };
  const int width = draw(1, 6);
  Model model = MakeSheet(width, draw(1, 6), false, { 1., 0., 0. }, { 0., 1., 0. });
  const std::vector<Point> noise =
    MakeRandomPoints(model.Points.size(), static_cast<int>(random()));
  for (std::size_t i = 0; i < noise.size(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      model.Points[i][c] += 0.2 * noise[i][c];
    }
  }
  std::vector<std::vector<vtkIdType>> faces;
  const int share = draw(0, 2); // of quads that become triangles
  for (const auto& face : model.Faces)
  {
    if (draw(1, 2) > share)
    {
      faces.push_back(face);
    }
    else
    {
      faces.push_back({ face[0], face[1], face[2] });
      faces.push_back({ face[0], face[2], face[3] });
    }
  }
  model.Faces = faces;
  return model;
}

/// The limits that a filter makes of values 1 at one point and 0 at others.
std::vector<std::vector<double>> FindLimitMatrix(vtkPolyData* input, int scheme)
{
  const vtkIdType size = input->GetNumberOfPoints();
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(input);
  vtkNew<vtkDoubleArray> units;
  units->SetName("units");
  units->SetNumberOfComponents(static_cast<int>(size));
  units->SetNumberOfTuples(size);
  for (vtkIdType i = 0; i < size * size; ++i)
  {
    units->SetValue(i, i / size == i % size ? 1. : 0.);
  }
  copy->GetPointData()->AddArray(units);
  vtkNew<Filter> filter;
  Configure(filter, scheme, 0, true);
  filter->InterpolatePointsOff();
  filter->InterpolateArraysOff();
  const auto output = Update(filter, copy);
  std::vector<std::vector<double>> matrix(static_cast<std::size_t>(size));
  for (vtkIdType i = 0; i < size * size; ++i)
  {
    matrix[i / size].push_back(output->GetPointData()->GetArray("units")->GetComponent(
      i / size, static_cast<int>(i % size)));
  }
  return matrix;
}

/// Elimination with pivots; empty if a pivot is only rounding.
std::vector<double> SolveDensely(std::vector<std::vector<double>> matrix, std::vector<double> right)
{
  const std::size_t size = right.size();
  for (std::size_t i = 0; i < size; ++i)
  {
    std::size_t pivot = i;
    for (std::size_t r = i; r < size; ++r)
    {
      pivot = std::abs(matrix[r][i]) > std::abs(matrix[pivot][i]) ? r : pivot;
    }
    std::swap(matrix[i], matrix[pivot]);
    std::swap(right[i], right[pivot]);
    if (std::abs(matrix[i][i]) < 1e-9)
    {
      return {};
    }
    for (std::size_t r = i + 1; r < size; ++r)
    {
      const double part = matrix[r][i] / matrix[i][i];
      for (std::size_t c = i; c < size; ++c)
      {
        matrix[r][c] -= part * matrix[i][c];
      }
      right[r] -= part * right[i];
    }
  }
  for (std::size_t i = size; i-- > 0;)
  {
    for (std::size_t c = i + 1; c < size; ++c)
    {
      right[i] -= matrix[i][c] * right[c];
    }
    right[i] /= matrix[i][i];
  }
  return right;
}

}

// Wherever a dense matrix has a solution the filter finds it, also where its iteration is too slow.
TEST(SurfaceInterpolation, HasTheSolutionsOfDenseMatrices)
{
  std::mt19937 random(11);
  for (const int scheme :
    { Filter::CATMULL_CLARK, Filter::FOUR_EIGHT, Filter::DOO_SABIN, Filter::MIDEDGE, Filter::LOOP })
  {
    int solved = 0;
    for (int trial = 0; trial < 30; ++trial)
    {
      SCOPED_TRACE(testing::Message() << "scheme " << scheme << ", trial " << trial);
      const auto input = MakeWithValues(MakeRandomModel(random));
      std::vector<double> given;
      for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
      {
        given.push_back(input->GetPointData()->GetArray("values")->GetComponent(i, 0));
      }
      const std::vector<double> expected = SolveDensely(FindLimitMatrix(input, scheme), given);
      vtkNew<Filter> filter;
      vtkNew<Messages> messages;
      messages->Watch(filter);
      Configure(filter, scheme, 0, false);
      const auto output = Update(filter, input);
      EXPECT_EQ(messages->CountWarnings("does not pass") > 0, expected.empty());
      vtkDataArray* control = output->GetPointData()->GetArray("values");
      for (std::size_t i = 0; i < expected.size(); ++i)
      {
        EXPECT_NEAR(control->GetComponent(static_cast<vtkIdType>(i), 0), expected[i], 1e-7);
      }
      solved += expected.empty() ? 0 : 1;
    }
    EXPECT_GE(solved, 25) << scheme;
  }
}

TEST(SurfaceInterpolation, IsKeptAndWeighted)
{
  for (const int scheme : SchemesWithLimits)
  {
    SCOPED_TRACE(scheme);
    const auto input = MakeWithValues(MakeZoo(scheme != Filter::CATMULL_CLARK).begin()->second);
    vtkNew<Filter> filter;
    Configure(filter, scheme, 1, false);
    const auto fresh = [&](vtkPolyData* from)
    {
      vtkNew<Filter> other;
      Configure(other, scheme, 1, false);
      other->SetInterpolationWeight(filter->GetInterpolationWeight());
      other->CacheOperatorOff();
      return Update(other, from);
    };
    const auto full = Update(filter, input);
    ExpectSameBits(full, fresh(input));
    EXPECT_EQ(filter->GetNumberOfTopologyBuilds(), 1);
    filter->SetInterpolationWeight(0.5);
    const auto half = Update(filter, input);
    ExpectSameBits(half, fresh(input));
    filter->SetInterpolationWeight(0.);
    const auto plain = Update(filter, input);
    for (vtkIdType i = 0; i < half->GetNumberOfPoints(); ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        ASSERT_NEAR(half->GetPoints()->GetData()->GetComponent(i, c),
          (full->GetPoints()->GetData()->GetComponent(i, c) +
            plain->GetPoints()->GetData()->GetComponent(i, c)) /
            2.,
          1e-13);
      }
    }
    filter->SetInterpolationWeight(1.);
    const auto changed = vtkSmartPointer<vtkPolyData>::New();
    changed->DeepCopy(input);
    vtkDataArray* values = changed->GetPointData()->GetArray("values");
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    {
      values->SetComponent(i, 0, std::cos(static_cast<double>(i)));
      changed->GetPoints()->SetPoint(
        i, 2. * input->GetPoint(i)[0], 0.5 * input->GetPoint(i)[1], input->GetPoint(i)[2]);
    }
    ExpectSameBits(Update(filter, changed), fresh(changed));
    EXPECT_EQ(filter->GetNumberOfTopologyBuilds(), 1);
  }
}

TEST(SurfaceInterpolation, FiltersInARow)
{
  for (const int scheme : SchemesWithLimits)
  {
    SCOPED_TRACE(scheme);
    const auto input = MakeWithValues(MakeZoo(scheme != Filter::CATMULL_CLARK).begin()->second);
    const auto run = [&](vtkPolyData* from, int levels, bool interpolate, Messages* messages)
    {
      vtkNew<Filter> filter;
      messages->Watch(filter);
      Configure(filter, scheme, levels, false);
      filter->SetInterpolatePoints(interpolate);
      filter->SetInterpolateArrays(interpolate);
      return Update(filter, from);
    };
    vtkNew<Messages> messages;
    const auto once = run(input, 2, true, messages);
    const auto first = run(input, 1, true, messages);
    ExpectSameBits(once, run(first, 1, true, messages));
    ExpectSameBits(once, run(first, 1, false, messages));
    EXPECT_EQ(messages->CountWarnings("did not interpolate"), 0);
    const auto plain = run(input, 1, false, messages);
    ExpectSameBits(run(plain, 1, true, messages), run(input, 2, false, messages));
    EXPECT_EQ(messages->CountWarnings("did not interpolate"), 1);
  }
}

/// Points on the two sides of a seam interpolate as one, and each value by itself.
TEST(SurfaceInterpolation, SeamsStayClosed)
{
  Model sheet = MakeSheet(4, 4, true, { 1., 0., 0. }, { 0., 1., 0. });
  const std::vector<Point> noise = MakeRandomPoints(sheet.Points.size(), 3);
  for (std::size_t i = 0; i < noise.size(); ++i)
  {
    sheet.Points[i][2] += noise[i][2];
  }
  // The points in the middle column exist twice.
  std::map<vtkIdType, vtkIdType> twins;
  for (vtkIdType row = 0; row < 5; ++row)
  {
    twins[5 * row + 2] = static_cast<vtkIdType>(sheet.Points.size());
    sheet.Points.push_back(sheet.Points[5 * row + 2]);
  }
  for (auto& face : sheet.Faces)
  {
    const bool isRight = std::any_of(
      face.begin(), face.end(), [&](vtkIdType v) { return v < 25 && sheet.Points[v][0] > 2.5; });
    for (vtkIdType& v : face)
    {
      v = isRight && twins.count(v) ? twins[v] : v;
    }
  }
  const auto input = MakeWithValues(sheet);
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  coordinates->SetNumberOfTuples(input->GetNumberOfPoints());
  coordinates->Fill(0.);
  coordinates->SetName("texture");
  input->GetPointData()->SetTCoords(coordinates);
  vtkNew<Filter> filter;
  Configure(filter, Filter::LOOP, 1, true);
  const auto output = Update(filter, input);
  EXPECT_LT(FindError(input, output), 1e-9);
  for (const auto& [a, b] : twins)
  {
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_EQ(output->GetPoints()->GetData()->GetComponent(a, c),
        output->GetPoints()->GetData()->GetComponent(b, c));
    }
  }
}
