// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSmoothnessRuns.cxx
 * How vtkSubdivisionSmoothness runs: threads, progress and options.
 */
#include "MultiDimensionalSubdivisionTools.h"

#include "vtkSubdivisionSmoothness.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkSubdivisionModelSource.h"

#include <sstream>

using namespace multi_dimensional_subdivision_tools;

using Filter = vtkSubdivisionSmoothness;

TEST(SubdivisionSmoothness, ThreadsDoNotMatter)
{
  const Grid mesh = LoadModel(vtkSubdivisionModelSource::SPRING_AND_VALVE);
  MakeInThreads(
    [&]
    {
      vtkNew<Filter> filter;
      filter->SampleMapsOn();
      return UpdateWithoutErrors<vtkUnstructuredGrid>(filter.Get(), mesh);
    });
}

/// Progress goes on in small steps, never back, and a user can stop at each.
TEST(SubdivisionSmoothness, ProgressMoves)
{
  const Grid mesh = LoadModel(vtkSubdivisionModelSource::SPRING_AND_VALVE);
  for (const bool samples : { false, true })
  {
    vtkNew<Filter> filter;
    filter->SetSampleMaps(samples);
    filter->SetInputDataObject(mesh);
    std::vector<double> seen;
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(&seen);
    command->SetCallback(
      [](vtkObject* caller, unsigned long, void* list, void*)
      {
        static_cast<std::vector<double>*>(list)->push_back(
          vtkAlgorithm::SafeDownCast(caller)->GetProgress());
      });
    filter->AddObserver(vtkCommand::ProgressEvent, command);
    filter->Update();
    EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
    seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
    EXPECT_GE(seen.size(), 20u);
    double most = 0.;
    for (std::size_t i = 1; i < seen.size(); ++i)
    {
      most = std::max(most, seen[i] - seen[i - 1]);
    }
    EXPECT_LE(most, samples ? 0.6 : 0.7);
  }
}

TEST(SubdivisionSmoothness, OptionsArePrinted)
{
  vtkNew<Filter> filter;
  EXPECT_EQ(filter->GetScheme(), Filter::BOX_SPLINE);
  EXPECT_TRUE(filter->GetModifiedBoundary());
  EXPECT_FALSE(filter->GetSampleMaps());
  EXPECT_FALSE(filter->GetFailingOnly());
  filter->SetScheme(99);
  std::ostringstream out;
  filter->Print(out);
  for (const char* part : { "Scheme: 9", "ModifiedBoundary: 1", "SampleMaps: 0", "FailingOnly: 0" })
  {
    EXPECT_NE(out.str().find(part), std::string::npos) << part;
  }
}
