// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestAborted.cxx
 * Every filter, stopped by AbortExecute at each report of progress: the output is empty, and the
 * next execution is that of a new filter, with or without what was kept before.
 */
#include "FeatureTools.h"
#include "LabelTools.h"
#include "SubdivisionDeformationTools.h"
#include "SurfaceTools.h"
#include "Turns.h"

#include "Core/Memory/Loops.h"
#include "Private/vtkSubdivisionObjectsCompat.h"

#include "vtkAdaptiveSurfaceSubdivision.h"
#include "vtkExtractDimensions.h"
#include "vtkImageData.h"
#include "vtkRedGreenRefinement.h"
#include "vtkSimplicialComplexTopology.h"
#include "vtkSphere.h"
#include "vtkSubdivisionCageSource.h"
#include "vtkSubdivisionEdit.h"
#include "vtkSubdivisionLimitProbe.h"
#include "vtkSubdivisionSmoothness.h"

using namespace feature_tools;

namespace
{

using Object = vtkSmartPointer<vtkDataObject>;
using Algorithm = vtkSmartPointer<vtkAlgorithm>;

/// Stops a filter at its n-th report of progress. The first one, of nothing done, and the last one,
/// of all, are those of VTK.
class Stopper : public vtkCommand
{
public:
  static Stopper* New() { return new Stopper; }
  vtkTypeMacro(Stopper, vtkCommand);
  void Execute(vtkObject* caller, unsigned long, void* data) override
  {
    const double done = *static_cast<double*>(data);
    if (std::exchange(this->HasBegun, true) && done < 1. && this->Reports++ == this->StopAt)
    {
      static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
      this->HasStopped = true;
    }
  }
  int Reports = 0;
  int StopAt = -1;
  bool HasStopped = false;

private:
  bool HasBegun = false;
};

/// Collects the progress that a filter reports.
class Listener : public vtkCommand
{
public:
  static Listener* New() { return new Listener; }
  vtkTypeMacro(Listener, vtkCommand);
  void Execute(vtkObject*, unsigned long, void* data) override
  {
    this->Reports.push_back(*static_cast<double*>(data));
  }
  std::vector<double> Reports;
};

void ExpectEmpty(vtkDataObject* output, const std::string& what)
{
  for (const auto& mesh : GetMeshes(output))
  {
    EXPECT_EQ(mesh->GetNumberOfPoints(), 0) << what;
    EXPECT_EQ(mesh->GetNumberOfCells(), 0) << what;
    EXPECT_EQ(mesh->GetPointData()->GetNumberOfArrays(), 0) << what;
    EXPECT_EQ(mesh->GetCellData()->GetNumberOfArrays(), 0) << what;
  }
}

void Run(vtkAlgorithm* filter, const std::vector<Object>& inputs)
{
  for (std::size_t port = 0; port < inputs.size(); ++port)
  {
    filter->SetInputDataObject(static_cast<int>(port), inputs[port]);
  }
  filter->SetAbortExecute(0); // newer VTK does not take it back itself
  filter->Modified();
  filter->Update();
}

/// Stops a filter at each `step`-th report, new or with what it kept, and lets it run then.
void CheckStopsInSteps(const std::string& name, const std::vector<Object>& inputs,
  const std::function<Algorithm()>& make, int step)
{
  const Algorithm fresh = make();
  Run(fresh, inputs);
  bool hasStopped = true;
  for (int stopAt = 0; hasStopped; stopAt += step)
  {
    if (stopAt > 0 && !turns::IsInTurn(static_cast<std::size_t>(stopAt / step)))
    {
      continue;
    }
    hasStopped = false;
    for (const bool isWarm : { false, true })
    {
      const std::string what =
        name + ", report " + std::to_string(stopAt) + (isWarm ? ", not the first run" : "");
      const Algorithm filter = make();
      vtkNew<Messages> messages;
      messages->Watch(filter);
      if (isWarm)
      {
        Run(filter, inputs);
      }
      vtkNew<Stopper> stopper;
      filter->AddObserver(vtkCommand::ProgressEvent, stopper);
      stopper->StopAt = stopAt;
      Run(filter, inputs);
      if (stopper->HasStopped)
      {
        hasStopped = true;
        ExpectEmpty(filter->GetOutputDataObject(0), what);
        EXPECT_EQ(stopper->Reports, stopAt + 1) << what << ": it stops at once";
      }
      EXPECT_TRUE(messages->Errors.empty()) << what;
      stopper->StopAt = -1;
      for (int run = 0; run < 2; ++run)
      {
        Run(filter, inputs);
        EXPECT_EQ(Compare(filter->GetOutputDataObject(0), fresh->GetOutputDataObject(0)), "")
          << what;
      }
      if (testing::Test::HasFailure())
      {
        return;
      }
    }
    ASSERT_TRUE(hasStopped || stopAt > 0) << name << " does not report its progress";
  }
}

int CountReports(const std::vector<Object>& inputs, const std::function<Algorithm()>& make)
{
  const Algorithm filter = make();
  vtkNew<Stopper> stopper;
  filter->AddObserver(vtkCommand::ProgressEvent, stopper);
  Run(filter, inputs);
  return stopper->Reports;
}

/// Progress goes from 0 to 1, and never back.
void CheckProgress(const std::string& name, const std::vector<Object>& inputs,
  const std::function<Algorithm()>& make)
{
  const Algorithm filter = make();
  vtkNew<Listener> listener;
  filter->AddObserver(vtkCommand::ProgressEvent, listener);
  for (const bool isWarm : { false, true })
  {
    Run(filter, inputs);
    const std::vector<double>& reports = listener->Reports;
    const std::string what = name + (isWarm ? ", not the first run" : "");
    ASSERT_GT(reports.size(), 2u) << what;
    EXPECT_EQ(reports.front(), 0.) << what;
    EXPECT_EQ(reports.back(), 1.) << what;
    EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end())) << what;
    listener->Reports.clear();
  }
}

/// Stops between stages, and between loops.
void CheckStops(const std::string& name, const std::vector<Object>& inputs,
  const std::function<Algorithm()>& make)
{
  using subdivision::BetweenLoops;
  const double seconds = BetweenLoops::SecondsBetween;
  const int turns = std::exchange(BetweenLoops::TurnsBetween, 64);
  BetweenLoops::SecondsBetween = 1e9;
  CheckStopsInSteps(name, inputs, make, 1);
  const int stages = CountReports(inputs, make);
  BetweenLoops::SecondsBetween = 0.;
  const int reports = CountReports(inputs, make);
  EXPECT_GT(reports, 2 * stages) << name;
  CheckProgress(name, inputs, make);
  CheckStopsInSteps(name + " between loops", inputs, make, std::max(7, reports / 50));
  BetweenLoops::SecondsBetween = seconds;
  BetweenLoops::TurnsBetween = turns;
}

/// The filter with `configure`, on a mesh, on blocks that are joined and on blocks that are not.
template <typename FilterClass>
void CheckAllInputs(
  const std::string& name, vtkPointSet* mesh, vtkPointSet* other,
  const std::function<void(FilterClass*)>& configure = [](FilterClass*) {})
{
  for (const bool joins : { true, false })
  {
    const auto make = [&]
    {
      auto filter = vtkSmartPointer<FilterClass>::New();
      filter->SetJoinBlocks(joins);
      configure(filter);
      return filter;
    };
    CheckStops(name, { mesh }, make);
    CheckStops(
      name + (joins ? ", joined blocks" : ", blocks"), { MakeBlocks({ mesh, other }) }, make);
  }
}

}

TEST(Aborted, FiltersOfSolids)
{
  const Grid box = MakeKuhnBox(1, 0.1);
  const Grid other =
    deformation_tools::Moved(box, [](const Point& x) { return Point{ x[0] + 1., x[1], x[2] }; });
  AddArrays(box);
  AddArrays(other);
  for (const int scheme : { Filter::BOX_SPLINE, Filter::TET_OCT, Filter::LINEAR })
  {
    for (const bool limit : { false, true })
    {
      CheckAllInputs<Filter>("scheme " + std::to_string(scheme), box, other,
        [=](Filter* filter)
        {
          filter->SetVolumeScheme(scheme);
          filter->SetNumberOfLevels(2);
          filter->SetProjectToLimit(limit);
          filter->SetInterpolatePoints(limit);
          filter->SetCacheOperator(!limit);
        });
    }
  }
  CheckAllInputs<Filter>("types", box, other,
    [](Filter* filter)
    {
      filter->SetVolumeSchemeToLinear();
      filter->KeepCellTypesOn();
    });
  for (const int placement : { 0, 1 })
  {
    CheckAllInputs<vtkRedGreenRefinement>("red-green", box, other,
      [placement](vtkRedGreenRefinement* filter)
      {
        filter->RefineByAttributeErrorOff();
        filter->RefineByEdgeLengthOn();
        filter->SetMaximumEdgeLength(0.5);
        filter->SetPlacement(placement);
      });
  }
  CheckAllInputs<vtkSimplicialComplexTopology>("topology", box, other);
  for (int scheme = 0; scheme <= vtkSubdivisionSmoothness::LOOP; ++scheme)
  {
    CheckStops("smoothness " + std::to_string(scheme), { box },
      [scheme]
      {
        auto filter = vtkSmartPointer<vtkSubdivisionSmoothness>::New();
        filter->SetScheme(scheme);
        return filter;
      });
  }
}

TEST(Aborted, OtherWorkOnSolids)
{
  const Grid box = MakeKuhnBox(2, 0.1);
  AddArrays(box);
  vtkNew<vtkIntArray> materials;
  materials->SetName("MaterialId");
  for (vtkIdType c = 0; c < box->GetNumberOfCells(); ++c)
  {
    materials->InsertNextValue(c < box->GetNumberOfCells() / 2 ? 1 : 2);
  }
  box->GetCellData()->AddArray(materials);
  const auto check = [&](const std::string& name, const std::function<void(Filter*)>& configure)
  {
    CheckStops(name, { box },
      [&]
      {
        auto filter = vtkSmartPointer<Filter>::New();
        filter->SetNumberOfLevels(1);
        configure(filter);
        return filter;
      });
  };
  check("values that jump",
    [](Filter* filter)
    {
      filter->PreserveInterfacesOn();
      filter->SetInterfaceValuesToDiscontinuous();
    });
  check("features, all arrays",
    [](Filter* filter)
    {
      filter->DetectFeaturesOn();
      filter->GenerateClassificationOn();
      filter->GenerateOriginalIdsOn();
      filter->GenerateGlobalIdsOn();
      filter->SetOutputDimensions(Filter::TRIANGLES);
    });
  check("marks, normals",
    [](Filter* filter)
    {
      vtkNew<vtkSphere> ball;
      filter->MarkByFunctionOn();
      filter->SetMarkFunction(ball);
      filter->MarkCreasesOn();
      filter->GenerateLimitNormalsOn();
    });
  for (const bool byShape : { false, true })
  {
    CheckStops("red-green, normals", { box },
      [=]
      {
        auto filter = vtkSmartPointer<vtkRedGreenRefinement>::New();
        filter->SetRefineByGeometricError(byShape);
        filter->SetPlacementToLimit();
        filter->GenerateLimitNormalsOn();
        filter->SetMaximumLevel(1);
        return filter;
      });
  }
}

TEST(Aborted, FurtherLevelsOfSolids)
{
  const Grid box = MakeKuhnBox(1, 0.1);
  AddArrays(box);
  for (const bool isBezier : { false, true })
  {
    CheckStops(isBezier ? "Bezier cells" : "error bounds", { box },
      [isBezier]
      {
        auto filter = vtkSmartPointer<Filter>::New();
        filter->SetNumberOfLevels(0);
        filter->SetOutputCells(isBezier);
        filter->SetGenerateErrorBounds(!isBezier);
        return filter;
      });
  }
}

TEST(Aborted, FiltersWithoutSubdivision)
{
  const Grid box = MakeKuhnBox(4, 0.1);
  AddArrays(box);
  const auto dimensions = []
  {
    auto filter = vtkSmartPointer<vtkExtractDimensions>::New();
    filter->SetOutputDimensions(vtkExtractDimensions::SURFACES | vtkExtractDimensions::SOLIDS);
    return filter;
  };
  CheckStops("dimensions", { box }, dimensions);
  CheckStops("dimensions of blocks", { MakeBlocks({ box, box }) }, dimensions);
  for (const bool alongEdges : { false, true })
  {
    const auto edit = [&box, alongEdges]
    {
      auto filter = vtkSmartPointer<vtkSubdivisionEdit>::New();
      filter->SetTranslation(0., 0., 1.);
      filter->SetFrameToLocal();
      filter->SetFalloffRadius(0.2);
      filter->SetFalloffAlong(alongEdges ? 1 : 0);
      filter->AddPaintedArray("Painted");
      filter->SetInputDataObject(2, box);
      return filter;
    };
    CheckStops("edit", { box }, edit);
  }
  CheckStops("cage", { box },
    []
    {
      auto source = vtkSmartPointer<vtkSubdivisionCageSource>::New();
      source->SetNumberOfCells(5, 5, 8);
      return source;
    });
}

TEST(Aborted, FiltersOfSurfaces)
{
  const auto sheet =
    surfacetools::MakeInput(surfacetools::MakeSheet(3, 3, true, { 1., 0., 0. }, { 0., 1., 0.5 }));
  const auto other =
    surfacetools::MakeInput(surfacetools::MakeSheet(3, 3, true, { -1., 0., 0. }, { 0., 1., 0.5 }));
  for (int scheme = vtkSurfaceSubdivision::LOOP; scheme <= vtkSurfaceSubdivision::LINEAR; ++scheme)
  {
    CheckAllInputs<vtkSurfaceSubdivision>("surface " + std::to_string(scheme), sheet, other,
      [scheme](vtkSurfaceSubdivision* filter)
      {
        filter->SetScheme(scheme);
        filter->SetNumberOfLevels(2);
      });
  }
  CheckAllInputs<vtkAdaptiveSurfaceSubdivision>("adaptive", sheet, other);
  for (const bool isBezier : { false, true })
  {
    CheckStops(isBezier ? "Bezier cells" : "error bounds", { sheet },
      [isBezier]
      {
        auto filter = vtkSmartPointer<vtkSurfaceSubdivision>::New();
        filter->SetOutputCells(isBezier);
        filter->SetGenerateErrorBounds(!isBezier);
        return filter;
      });
  }
}

TEST(Aborted, Probe)
{
  const Grid box = MakeKuhnBox(1, 0.1);
  const Grid places = deformation_tools::MakeCloud(5, { 0.2, 0.2, 0.2 }, { 0.8, 0.8, 0.8 }, 1);
  for (const bool ofSurface : { false, true })
  {
    const Object input = ofSurface ? Object(surfacetools::MakeInput(surfacetools::MakeSheet(
                                       3, 3, true, { 1., 0., 0. }, { 0., 1., 0.5 })))
                                   : Object(box);
    CheckStops(ofSurface ? "probe of a surface" : "probe of solids", { input },
      [&places]
      {
        auto filter = vtkSmartPointer<vtkSubdivisionLimitProbe>::New();
        filter->SetInputDataObject(3, places);
        return filter;
      });
  }
}

TEST(Aborted, Deformation)
{
  const Grid cage = MakeKuhnBox(2);
  const Grid moved = deformation_tools::Moved(cage, deformation_tools::Affine);
  const auto make = [] { return vtkSmartPointer<vtkSubdivisionDeformation>::New(); };
  const Grid cloud = deformation_tools::MakeCloud(9, { 0.7, 0.7, 0.7 }, { 1.3, 1.3, 1.3 }, 1);
  AddArrays(cloud);
  CheckStops("deformation", { cloud, cage, moved }, make);
  CheckStops("deformation of blocks", { MakeBlocks({ cloud, cage }), cage, moved }, make);
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 3);
  image->SetSpacing(0.2, 0.2, 0.2);
  image->SetOrigin(0.8, 0.8, 0.8);
  CheckStops("deformation of an image", { image, cage, moved }, make);
}

TEST(Aborted, Labels)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(6, 6, 6);
  image->AllocateScalars(VTK_INT, 1);
  auto* labels = vtkIntArray::SafeDownCast(image->GetPointData()->GetScalars());
  for (vtkIdType i = 0; i < labels->GetNumberOfTuples(); ++i)
  {
    labels->SetValue(i, i % 6 < 3 ? 1 : 2);
  }
  labels->SetName("Label");
  CheckStops("labels", { image },
    []
    {
      auto filter = vtkSmartPointer<vtkSubdivisionLabelSolid>::New();
      filter->SetNumberOfControlCells(300);
      return filter;
    });
}
