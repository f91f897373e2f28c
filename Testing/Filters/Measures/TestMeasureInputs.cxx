// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestMeasureInputs.cxx
 * vtkSubdivisionMeasures with blocks, threads, mixed meshes and bad input.
 */
#include "HybridFilterTools.h"
#include "MeasureTools.h"

#include "Core/Memory/Loops.h"

#include "vtkCallbackCommand.h"
#include "vtkIntArray.h"
#include "vtkStringArray.h"

using namespace measure_tools;

namespace
{

/// The only error of a filter, whose table is empty then.
std::string FindError(vtkSubdivisionMeasures* filter, vtkDataObject* input)
{
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetInputDataObject(input);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfRows(), 0);
  return messages->Errors.empty() ? std::string() : messages->Errors.front();
}

Table MeasureLevels(vtkDataObject* mesh, int level)
{
  vtkNew<vtkSubdivisionMeasures> filter;
  filter->SetMaximumLevel(level);
  return Measure(filter, mesh, { "" });
}

}

TEST(MeasureInputs, ThreadsMakeTheSameBits)
{
  const Grid mesh = hybrid_filter_tools::MakeAllTypes();
  const std::string before = vtkSMPTools::GetBackend();
  ASSERT_TRUE(vtkSMPTools::SetBackend("STDThread"));
  vtkSMPTools::Initialize(1);
  const Table one = MeasureLevels(mesh, 4);
  vtkSMPTools::Initialize(3);
  const Table three = MeasureLevels(mesh, 4);
  vtkSMPTools::SetBackend(before.c_str());
  vtkSMPTools::Initialize(0);
  EXPECT_GT(one->GetNumberOfRows(), 2);
  EXPECT_EQ(CompareTables(one, three), "");
}

TEST(MeasureInputs, MixedMeshesHaveARowForEachDimension)
{
  const Grid mesh = hybrid_filter_tools::MakeAllTypes();
  const Table table = MeasureLevels(mesh, 3);
  ASSERT_GE(table->GetNumberOfRows(), 3);
  for (int dimension = 1; dimension <= 3; ++dimension)
  {
    const vtkIdType row = FindRow(table, dimension);
    ASSERT_GE(row, 0);
    EXPECT_GT(Get(table, "Measure", row), 0.);
    EXPECT_LT(Get(table, "MeasureRemainder", row), 0.1 * Get(table, "Measure", row));
  }
  vtkNew<vtkSubdivisionMeasures> filter;
  filter->SetMaximumLevel(3);
  filter->SetOutputDimensions(1 << 2);
  const Table surfaces = Measure(filter, mesh, { "" });
  ASSERT_EQ(surfaces->GetNumberOfRows(), 1);
  EXPECT_EQ(Get(surfaces, "Measure"), Get(table, "Measure", FindRow(table, 2)));
}

TEST(MeasureInputs, BlocksAreOneMesh)
{
  const Grid whole = MakeMixedBox(2);
  std::vector<Grid> parts;
  for (const bool isFirst : { true, false })
  {
    const Grid part = DeepCopy(whole);
    Grid cells = Grid::New();
    cells->SetPoints(whole->GetPoints());
    cells->Allocate(whole->GetNumberOfCells());
    for (vtkIdType c = 0; c < whole->GetNumberOfCells(); ++c)
    {
      vtkNew<vtkIdList> ids;
      whole->GetCellPoints(c, ids);
      if ((c < whole->GetNumberOfCells() / 2) == isFirst)
      {
        cells->InsertNextCell(whole->GetCellType(c), ids);
      }
    }
    parts.push_back(cells);
  }
  const Grid bare = Grid::New();
  bare->CopyStructure(whole);
  const Table one = MeasureLevels(bare, 2);
  const Table other = MeasureLevels(MakeBlocks(parts), 2);
  ASSERT_EQ(one->GetNumberOfRows(), other->GetNumberOfRows());
  for (vtkIdType row = 0; row < one->GetNumberOfRows(); ++row)
  {
    EXPECT_NEAR(Get(one, "Measure", row), Get(other, "Measure", row), 1e-12);
    EXPECT_NEAR(Get(one, "Inertia", row, 3), Get(other, "Inertia", row, 3), 1e-12);
  }
}

TEST(MeasureInputs, BadDensitiesAreErrors)
{
  const Grid mesh =
    MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { VTK_TRIANGLE, { 0, 1, 2 } } });
  mesh->GetPointData()->AddArray(MakeArray<vtkIntArray>("Whole", 1, 3, 1., 5., 1));
  mesh->GetPointData()->AddArray(MakeArray<vtkDoubleArray>("Vector", 3, 3, 1., 5., 1));
  mesh->GetPointData()->AddArray(MakeNames("Text", 3));
  for (const auto& [name, part] : std::map<std::string, std::string>{
         { "None there", "is not there" }, { "Whole", "must be floating point" },
         { "Vector", "one for each point" }, { "Text", "must hold numbers" } })
  {
    vtkNew<vtkSubdivisionMeasures> filter;
    SetDensity(filter, name.c_str());
    const std::string error = FindError(filter, mesh);
    EXPECT_NE(error.find(part), std::string::npos) << name << ": " << error;
    EXPECT_NE(error.find(name), std::string::npos) << error;
  }
  vtkNew<vtkSubdivisionMeasures> filter;
  const Table table = Measure(filter, mesh, { "" });
  EXPECT_TRUE(table->GetColumnByName("VectorIntegral"));
  EXPECT_FALSE(table->GetColumnByName("WholeIntegral"));
  EXPECT_FALSE(table->GetColumnByName("TextIntegral"));
}

TEST(MeasureInputs, NothingIsMeasuredWithoutCells)
{
  vtkNew<vtkSubdivisionMeasures> filter;
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetInputDataObject(MakeGrid({ { 0, 0, 0 } }, {}));
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfRows(), 0);
  EXPECT_TRUE(messages->Errors.empty());
  EXPECT_EQ(messages->CountWarnings("nothing is measured"), 1);
}

TEST(MeasureInputs, PointsThatAreNotFiniteGiveNoNumbers)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Grid mesh =
    MakeGrid({ { 0, 0, 0 }, { 1, nan, 0 }, { 0, 1, 0 } }, { { VTK_TRIANGLE, { 0, 1, 2 } } });
  vtkNew<vtkSubdivisionMeasures> filter;
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetInputDataObject(mesh);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfRows(), 0);
  EXPECT_EQ(messages->CountWarnings("infinite or not a number"), 1); // not once for each level
  EXPECT_EQ(messages->CountWarnings("nothing is measured"), 1);
  mesh->GetPoints()->Modified();
  filter->Update();
  EXPECT_EQ(messages->CountWarnings("infinite or not a number"), 2); // each update tells it
}

TEST(MeasureInputs, AStoppedRunHasNoRows)
{
  const Grid mesh = MakeMixedBox(2);
  vtkNew<vtkSubdivisionMeasures> filter;
  vtkNew<Messages> messages;
  messages->Watch(filter);
  double last = 0.;
  vtkNew<vtkCallbackCommand> stop;
  stop->SetClientData(&last);
  stop->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      auto* const made = vtkSubdivisionMeasures::SafeDownCast(caller);
      double& before = *static_cast<double*>(data);
      EXPECT_GE(made->GetProgress(), before);
      if (made->GetProgress() < 1.) // newer VTK reports the end of stopped runs, too
      {
        before = made->GetProgress();
        made->SetAbortExecute(before > 0.3);
      }
    });
  filter->AddObserver(vtkCommand::ProgressEvent, stop);
  filter->SetInputDataObject(mesh);
  filter->Update();
  EXPECT_GT(last, 0.3);
  EXPECT_LT(last, 0.6);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfRows(), 0);
  EXPECT_TRUE(messages->Errors.empty());
}

namespace
{

/// Stops the filter at one of its reports; no loop asks after it, as where the next level takes
/// less time than passes between two reports.
struct Stop
{
  int At = 0;
  int Reports = 0;
};

void StopAtReport(vtkObject* caller, unsigned long, void* data, void*)
{
  auto& stop = *static_cast<Stop*>(data);
  if (++stop.Reports == stop.At)
  {
    static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
    subdivision::BetweenLoops::SecondsBetween = 1e9;
  }
}

}

/// Also in the control mesh, whose next level is whole.
TEST(MeasureInputs, AStopAtAnyReportHasNoRows)
{
  const double before = subdivision::BetweenLoops::SecondsBetween;
  Stop stop;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&stop);
  command->SetCallback(StopAtReport);
  const Grid mesh = MakeMixedBox(1);
  int reports = 1;
  for (int stopAt = 0; stopAt < reports; ++stopAt) // at first none
  {
    stop = { stopAt, 0 };
    subdivision::BetweenLoops::SecondsBetween = 0.;
    vtkNew<vtkSubdivisionMeasures> filter;
    filter->SetMaximumLevel(1);
    filter->AddObserver(vtkCommand::ProgressEvent, command);
    filter->SetInputDataObject(mesh);
    filter->Update();
    reports = stopAt == 0 ? stop.Reports - 1 : reports; // VTK makes the last one
    EXPECT_EQ(filter->GetOutput()->GetNumberOfRows() == 0, stopAt > 0) << stopAt;
  }
  EXPECT_GT(reports, 20);
  subdivision::BetweenLoops::SecondsBetween = before;
}

TEST(MeasureInputs, OptionsOfMeshesStay)
{
  vtkNew<vtkSubdivisionMeasures> filter;
  filter->SetNumberOfLevels(3);
  filter->SetMaximumLevel(2);
  const Grid mesh =
    MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { VTK_TRIANGLE, { 0, 1, 2 } } });
  Measure(filter, mesh);
  EXPECT_EQ(filter->GetNumberOfLevels(), 3);
  EXPECT_FALSE(filter->GetProjectToLimit());
  EXPECT_FALSE(filter->GetGenerateOriginalIds());
  EXPECT_TRUE(filter->GetCacheOperator());
}
