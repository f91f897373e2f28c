// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestRedGreenRefinementLimit.cxx
 * vtkRedGreenRefinement: points and values on the limit, and criteria that ask for it.
 */
#include "RedGreenRefinementTools.h"

#include "vtkCellLocator.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkGenericCell.h"
#include "vtkSubdivisionModelSource.h"

using namespace red_green_refinement_tools;

namespace
{

Grid Project(vtkDataObject* input, int levels,
  int scheme = vtkMultiDimensionalSubdivision::BOX_SPLINE, bool toLimit = true)
{
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  filter->SetVolumeScheme(scheme);
  filter->SetInputDataObject(input);
  filter->SetNumberOfLevels(levels);
  filter->SetProjectToLimit(toLimit);
  filter->Update();
  return filter->GetOutput();
}

class RedGreenLimitZoo : public testing::TestWithParam<std::string>
{
};

TEST_P(RedGreenLimitZoo, EverythingMarkedIsTheProjectedUniformMesh)
{
  const Grid input = MakeGrid(coretest::FindInZoo(this->GetParam()));
  input->GetPointData()->AddArray(
    MakeArray<vtkDoubleArray>("V", 2, input->GetNumberOfPoints(), -1., 1., 3));
  for (int level = 0; level < 3; ++level)
  {
    const Grid output =
      HalveAll(input, level, [](Filter* filter) { filter->SetPlacementToLimit(); });
    EXPECT_LE(GetDifference(output, Project(input, level), level == 0), 1e-12) << level;
  }
}

/// The same for the tet/oct scheme, whose octahedra are cut around other diagonals; also if an
/// earlier filter of that scheme made the first level.
TEST_P(RedGreenLimitZoo, EverythingMarkedHasThePointsOfTheTetOctScheme)
{
  const Grid input = MakeGrid(coretest::FindInZoo(this->GetParam()));
  input->GetPointData()->AddArray(
    MakeArray<vtkDoubleArray>("V", 2, input->GetNumberOfPoints(), -1., 1., 3));
  const int scheme = vtkMultiDimensionalSubdivision::TET_OCT;
  for (int level = 0; level < 3; ++level)
  {
    const Grid expected = Project(input, level, scheme);
    const Configure onLimit = [](Filter* filter)
    {
      filter->SetPlacementToLimit();
      filter->SetVolumeSchemeToTetOct();
    };
    std::vector<Grid> made = { HalveAll(input, level, onLimit) };
    if (level > 0)
    {
      made.push_back(HalveAll(Project(input, 1, scheme, false), level - 1, onLimit));
    }
    for (const Grid& output : made)
    {
      ASSERT_EQ(output->GetNumberOfPoints(), expected->GetNumberOfPoints());
      EXPECT_EQ(output->GetNumberOfCells(), expected->GetNumberOfCells());
      EXPECT_LE(GetFarthest(output, expected), 1e-12) << "level " << level;
      EXPECT_LE(GetFarthest(expected, output), 1e-12) << "level " << level;
    }
  }
}

/// A point of a mesh that is refined here and there has the same limit as in the uniform mesh.
TEST_P(RedGreenLimitZoo, PointsDoNotDependOnTheirNeighbourhood)
{
  const Grid input = MakeGrid(coretest::FindInZoo(this->GetParam()));
  AddWeights(input); // linear placement tells which points are the same
  AddWantedLevels(input, 3, 5, 0.3);
  int scheme = Filter::BOX_SPLINE;
  auto run = [&](int placement, bool everything)
  {
    return Refine(input,
      [=](Filter* filter)
      {
        filter->SetRefineByWantedLevel(!everything);
        filter->SetRefineByEdgeLength(everything);
        filter->SetMaximumEdgeLength(0.);
        filter->SetPlacement(placement);
        filter->SetVolumeScheme(scheme);
      });
  };
  const Grid uniform = run(Filter::LINEAR, true);
  const Grid adaptive = run(Filter::LINEAR, false);
  const Ids same = FindSamePoints(adaptive, uniform);
  for (const int ofLimit : { Filter::BOX_SPLINE, Filter::TET_OCT })
  {
    scheme = ofLimit;
    const Grid projected = run(Filter::LIMIT, true);
    const Grid limit = run(Filter::LIMIT, false);
    ASSERT_EQ(adaptive->GetNumberOfPoints(), limit->GetNumberOfPoints());
    for (vtkIdType i = 0; i < limit->GetNumberOfPoints(); ++i)
    {
      ASSERT_GE(same[i], 0) << i;
      const Point p = GetPoint(limit, i);
      const Point q = GetPoint(projected, same[i]);
      EXPECT_LE(std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]), 1e-12) << i;
    }
  }
}

TEST_P(RedGreenLimitZoo, InterpolatesTheInput)
{
  const Grid input = MakeGrid(coretest::FindInZoo(this->GetParam()));
  input->GetPointData()->AddArray(
    MakeArray<vtkDoubleArray>("V", 2, input->GetNumberOfPoints(), -1., 1., 3));
  AddWantedLevels(input, 2, 5, 0.3);
  vtkNew<Messages> messages;
  const Grid output = Refine(
    input,
    [](Filter* filter)
    {
      filter->RefineByWantedLevelOn();
      filter->SetPlacementToLimit();
      filter->InterpolatePointsOn();
      filter->InterpolateArraysOn();
    },
    messages);
  EXPECT_TRUE(messages->Errors.empty());
  for (const std::string& warning : messages->Warnings)
  {
    EXPECT_TRUE(warning.find("exceed the range") != std::string::npos ||
      warning.find("does not pass") != std::string::npos)
      << warning;
  }
  const bool isDone = messages->CountWarnings("does not pass") == 0; // Mathematics 8
  const double tolerance = isDone ? 1e-10 : 1e-5;
  vtkDataArray* values = input->GetPointData()->GetArray("V");
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(GetPoint(input, i)[c], GetPoint(output, i)[c], tolerance * input->GetLength());
    }
    EXPECT_NEAR(values->GetComponent(i, 1),
      output->GetPointData()->GetArray("V")->GetComponent(i, 1), 3. * tolerance);
  }
}

INSTANTIATE_TEST_SUITE_P(Zoo, RedGreenLimitZoo, testing::ValuesIn(coretest::GetNamesOfZoo(0)),
  [](const auto& instance) { return instance.param; });

// ------------------------------------------------------------------------------------------------
// Criteria

Grid GetModel(const char* name)
{
  vtkNew<vtkSubdivisionModelSource> source;
  for (int i = 0; i < 7; ++i)
  {
    if (std::string(vtkSubdivisionModelSource::GetModelName(i)) == name)
    {
      source->SetModel(i);
    }
  }
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkPolyData> GetSurface(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(grid);
  surface->Update();
  return surface->GetOutput();
}

/// The largest distance of the points of a fine surface from a coarse one.
double GetDistance(vtkUnstructuredGrid* fine, vtkUnstructuredGrid* coarse)
{
  const auto surface = GetSurface(coarse);
  vtkNew<vtkCellLocator> locator;
  locator->SetDataSet(surface);
  locator->BuildLocator();
  vtkNew<vtkGenericCell> cell;
  const auto points = GetSurface(fine);
  double largest = 0.;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    Point nearest;
    vtkIdType id = 0;
    int part = 0;
    double distance = 0.;
    locator->FindClosestPoint(GetPoint(points, i).data(), nearest.data(), cell, id, part, distance);
    largest = std::max(largest, std::sqrt(distance));
  }
  return largest;
}

Configure ToTolerance(double tolerance, int level)
{
  return [tolerance, level](Filter* filter)
  {
    filter->RefineByGeometricErrorOn();
    filter->RelativeToleranceOff();
    filter->SetGeometricTolerance(tolerance);
    filter->SetMaximumLevel(level);
    filter->SetPlacementToLimit();
  };
}

TEST(RedGreenGeometricError, IsBelowTheTolerance)
{
  for (const char* name : { "Screw", "MechanicalPart" })
  {
    const Grid model = GetModel(name);
    const Grid fine = Project(model, name == std::string("Screw") ? 5 : 4);
    vtkIdType before = model->GetNumberOfCells();
    for (double tolerance : { 0.05, 0.02, 0.01 })
    {
      const Grid output = Refine(model, ToTolerance(tolerance, 6));
      const double error = GetDistance(fine, output);
      EXPECT_LE(error, tolerance) << name;
      EXPECT_GE(output->GetNumberOfCells(), before) << name;
      before = output->GetNumberOfCells();
    }
  }
}

/// The limit is that of the control points that are solved for, for criteria too.
TEST(RedGreenGeometricError, IsThatOfTheInterpolatingLimit)
{
  const Grid model = GetModel("Screw");
  model->GetPointData()->AddArray(
    MakeArray<vtkDoubleArray>("V", 1, model->GetNumberOfPoints(), -1., 1., 3));
  vtkNew<vtkMultiDimensionalSubdivision> solver;
  solver->SetInputData(model);
  solver->SetNumberOfLevels(0);
  solver->InterpolatePointsOn();
  solver->InterpolateArraysOn();
  solver->Update();
  const Grid control = DeepCopy(solver->GetOutput());
  control->GetFieldData()->Initialize(); // another mesh
  const auto run = [&](vtkUnstructuredGrid* input, bool ofArray, bool interpolate)
  {
    vtkNew<Messages> messages;
    return Refine(
      input,
      [&](Filter* filter)
      {
        ToTolerance(0.01, 4)(filter);
        filter->SetInterpolatePoints(interpolate);
        filter->SetInterpolateArrays(interpolate);
        filter->SetRefineByGeometricError(!ofArray);
        filter->SetRefineByAttributeError(ofArray);
        filter->SetAttributeErrorKindToLimitDifference();
        filter->SetInputArrayToProcess(5, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "V");
        double range[2];
        input->GetPointData()->GetArray("V")->GetRange(range);
        filter->SetAttributeTolerance(0.1 / (range[1] - range[0]));
      },
      messages);
  };
  for (const bool ofArray : { false, true })
  {
    const Grid output = run(model, ofArray, true);
    const Grid expected = run(control, ofArray, false);
    ASSERT_EQ(output->GetNumberOfPoints(), expected->GetNumberOfPoints());
    EXPECT_NE(output->GetNumberOfPoints(), run(model, ofArray, false)->GetNumberOfPoints());
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      ASSERT_EQ(GetPoint(output, i), GetPoint(expected, i));
    }
  }
}

TEST(RedGreenLimitPlacement, InterpolatesThereOnly)
{
  const Grid model = GetModel("Screw");
  vtkNew<Messages> messages;
  Refine(model, [](Filter* filter) { filter->InterpolatePointsOn(); }, messages);
  EXPECT_EQ(messages->CountWarnings("does not interpolate"), 1);
}

/// Kobbelt's measure: the error against the number of cells.
TEST(RedGreenGeometricError, TakesAThirdOfTheUniformCells)
{
  const Grid model = GetModel("Screw");
  // Its points are exact; there are enough of them to find the largest distance.
  const Grid fine = Refine(model, ToTolerance(1e-3, 9));
  for (int level : { 3, 4 })
  {
    const Grid uniform = Project(model, level);
    const double error = GetDistance(fine, uniform);
    double ours = 0.;
    Grid output;
    for (double factor : { 1.2, 1.1, 1. }) // what is allowed may be more than what is found
    {
      output = Refine(model, ToTolerance(factor * error, 8));
      ours = GetDistance(fine, output);
      if (ours <= error)
      {
        break;
      }
    }
    EXPECT_LE(ours, error) << "level " << level;
    EXPECT_LE(3 * output->GetNumberOfCells(), uniform->GetNumberOfCells()) << "level " << level;
    const std::string name = "Level" + std::to_string(level);
    this->RecordProperty(name + "UniformCells", std::to_string(uniform->GetNumberOfCells()));
    this->RecordProperty(name + "Cells", std::to_string(output->GetNumberOfCells()));
    this->RecordProperty(name + "Errors", std::to_string(ours) + " " + std::to_string(error));
  }
}

/// Edges that lie inside a solid between points of its surface are measured, too.
TEST(RedGreenLimitDifference, MeasuresEdgesOfAllDimensions)
{
  const Grid model = GetModel("SpringAndValve");
  model->GetPointData()->SetActiveScalars("Tension");
  const Grid output = Refine(model,
    [](Filter* filter)
    {
      filter->RefineByAttributeErrorOn();
      filter->SetAttributeErrorKindToLimitDifference();
      filter->SetAttributeTolerance(0.05);
      filter->SetMaximumLevel(2);
    });
  EXPECT_GT(output->GetNumberOfCells(), model->GetNumberOfCells());
}

TEST(RedGreenLimitDifference, RefinesWhereValuesBend)
{
  // Linear values have no difference from the limit but at the boundary.
  const Grid box = MakeBox(4);
  vtkNew<vtkDoubleArray> values;
  values->SetName("V");
  for (vtkIdType i = 0; i < box->GetNumberOfPoints(); ++i)
  {
    const Point p = GetPoint(box, i);
    values->InsertNextValue(p[0] < 2. ? 0. : (p[0] - 2.) * (p[0] - 2.));
  }
  box->GetPointData()->SetScalars(values);
  auto run = [&](double tolerance)
  {
    return Refine(box,
      [tolerance](Filter* filter)
      {
        filter->RefineByAttributeErrorOn();
        filter->SetAttributeErrorKindToLimitDifference();
        filter->SetAttributeTolerance(tolerance);
        filter->SetMaximumLevel(5);
      });
  };
  const Grid rough = run(0.05);
  const Grid fine = run(0.01);
  EXPECT_GT(rough->GetNumberOfCells(), box->GetNumberOfCells());
  EXPECT_GT(fine->GetNumberOfCells(), rough->GetNumberOfCells());
  for (vtkIdType i = 0; i < rough->GetNumberOfCells(); ++i)
  {
    const Ids ids = GetCell(rough, i);
    const bool isFlat = std::all_of(
      ids.begin(), ids.end(), [&](vtkIdType id) { return GetPoint(rough, id)[0] <= 1.; });
    EXPECT_TRUE(
      !isFlat || rough->GetCellData()->GetArray("RefinementKind")->GetComponent(i, 0) != 1.);
  }
}

}
