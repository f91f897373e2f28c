// SPDX-License-Identifier: BSD-3-Clause
// What panels foretell of the next Apply, beside what then comes out.
#include "Precompiled.h"

#include "Client/ForecastRules.h"

#include "vtkAdaptiveSurfaceSubdivision.h"
#include "vtkMultiDimensionalSubdivision.h"
#include "vtkRedGreenRefinement.h"
#include "vtkSubdivisionLabelSolid.h"
#include "vtkSubdivisionModelSource.h"
#include "vtkSurfaceSubdivision.h"

#include "vtkDataObjectTypes.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkSphereSource.h"

namespace
{

using Main = vtkMultiDimensionalSubdivision;
using OfSurfaces = vtkSurfaceSubdivision;
using Options = ForecastOptions;

vtkSmartPointer<vtkPolyData> MakeSphere()
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(40);
  source->SetPhiResolution(20);
  source->Update();
  source->GetOutput()->GetPointData()->Initialize();
  return source->GetOutput();
}

vtkSmartPointer<vtkImageData> MakeImage()
{
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(7, 7, 7);
  return image;
}

vtkSmartPointer<vtkDataObject> MakeModel(int model)
{
  vtkNew<vtkSubdivisionModelSource> source;
  source->SetModel(model);
  source->Update();
  auto* const grid = source->GetOutput();
  grid->GetPointData()->Initialize();
  grid->GetCellData()->Initialize();
  return grid;
}

/// What comes out beside what is foretold with such options: cells, bytes, and work.
template <typename Filter, typename Configure>
void Check(vtkDataObject* input, Options options, const Configure& configure, double ofBytes = 0.15)
{
  vtkNew<Filter> filter;
  filter->SetInputDataObject(input);
  configure(filter.Get());
  filter->Update();
  ControlCounts counts;
  std::copy_n(filter->GetControlCounts(), counts.size(), counts.begin());
  auto* const points = vtkPointSet::SafeDownCast(input);
  options.BytesPerPoint = points && points->GetPoints()->GetDataType() == VTK_FLOAT ? 12. : 24.;
  const Forecast forecast = Foretell(counts, options);
  auto* const made = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  const auto cells = static_cast<double>(made->GetNumberOfCells());
  const double bytes = 1024. * static_cast<double>(made->GetActualMemorySize());
  ASSERT_GT(cells, 0.);
  if (forecast.IsAtMost)
  {
    EXPECT_GE(forecast.Cells, cells);
    EXPECT_GE(forecast.Bytes, bytes);
    return;
  }
  EXPECT_NEAR(forecast.Cells, cells, 0.05 * cells);
  EXPECT_NEAR(forecast.Bytes, bytes, ofBytes * bytes);
  EXPECT_GE(forecast.Work, forecast.Cells);
  EXPECT_GT(forecast.Seconds, 0.);
}

Options OfMain(int levels)
{
  Options options;
  options.Levels = levels;
  options.VolumeScheme = Main::AUTOMATIC;
  return options;
}

}

TEST(ProgramForecast, SchemesOfSurfaces)
{
  const auto sphere = MakeSphere();
  for (int scheme = OfSurfaces::LOOP; scheme <= OfSurfaces::AUTOMATIC; ++scheme)
  {
    SCOPED_TRACE(scheme);
    Options options;
    options.Kind = Options::OfSurfaces;
    options.Levels = 3;
    options.Scheme = scheme;
    Check<OfSurfaces>(sphere, options,
      [scheme](OfSurfaces* filter)
      {
        filter->SetScheme(scheme);
        filter->SetNumberOfLevels(3);
        filter->SmoothShadingOff();
      });
  }
}

TEST(ProgramForecast, NormalsTangentsAndBounds)
{
  const auto sphere = MakeSphere();
  Options options;
  options.Kind = Options::OfSurfaces;
  options.Levels = 3;
  const auto loop = [](OfSurfaces* filter)
  {
    filter->SetSchemeToLoop();
    filter->SetNumberOfLevels(3);
  };
  options.AddsNormals = options.ReadsLimit = true;
  Check<OfSurfaces>(sphere, options, loop);
  const double withNormals = Foretell(ControlCounts{ 0., 0., 9., 0., 27., 9., 9. }, options).Bytes;
  options.AddsTangents = true;
  Check<OfSurfaces>(sphere, options,
    [&](OfSurfaces* filter)
    {
      loop(filter);
      filter->GenerateTangentsOn();
    });
  EXPECT_GT(Foretell(ControlCounts{ 0., 0., 9., 0., 27., 9., 9. }, options).Bytes, withNormals);
  options.AddsBounds = true;
  EXPECT_GT(Foretell(ControlCounts{ 0., 0., 9., 0., 27., 9., 9. }, options).Seconds,
    60. * Foretell(ControlCounts{ 0., 0., 9., 0., 27., 9., 9. }, OfMain(3)).Seconds);
}

TEST(ProgramForecast, DimensionsOfTheOutput)
{
  const auto model = MakeModel(vtkSubdivisionModelSource::MIXED_DIMENSIONS);
  for (const int dimension : { 1, 2, 3 })
  {
    SCOPED_TRACE(dimension);
    Options options = OfMain(3);
    options.Dimensions.fill(false);
    options.Dimensions.at(static_cast<std::size_t>(dimension)) = true;
    Check<Main>(
      model, options,
      [dimension](Main* filter)
      {
        filter->SetNumberOfLevels(3);
        filter->ClearOutputDimensions();
        filter->AddOutputDimension(dimension);
      },
      0.4);
  }
}

TEST(ProgramForecast, CellsThatAreKeptOrCut)
{
  const auto image = MakeImage();
  for (const int scheme : { Main::BOX_SPLINE, Main::LINEAR, Main::HYBRID, Main::AUTOMATIC })
  {
    SCOPED_TRACE(scheme);
    Options options = OfMain(2);
    options.VolumeScheme = scheme;
    Check<Main>(image, options,
      [scheme](Main* filter)
      {
        filter->SetNumberOfLevels(2);
        filter->SetVolumeScheme(scheme);
        filter->SmoothShadingOff();
      });
  }
}

TEST(ProgramForecast, CurvedCells)
{
  const auto image = MakeImage();
  const auto sphere = MakeSphere();
  for (const int order : { 1, 2, 3, 4 })
  {
    SCOPED_TRACE(order);
    Options options = OfMain(1);
    options.OutputCells = Main::LAGRANGE_CELLS;
    options.CellOrder = order;
    const auto configure = [order](auto* filter)
    {
      filter->SetOutputCellsToLagrange();
      filter->SetCellOrder(order);
    };
    if (order < 3) // the others take long
    {
      Check<Main>(image, options, configure, 0.25);
    }
    options.Kind = Options::OfSurfaces;
    options.Scheme = OfSurfaces::CATMULL_CLARK;
    Check<OfSurfaces>(sphere, options,
      [&](OfSurfaces* filter)
      {
        configure(filter);
        filter->SetSchemeToCatmullClark();
      });
  }
  Options options = OfMain(1);
  options.OutputCells = Main::QUADRATIC_CELLS;
  Check<Main>(sphere, options, [](Main* filter) { filter->SetOutputCellsToQuadratic(); });
  options.OutputCells = Main::BEZIER_CELLS;
  Check<Main>(sphere, options, [](Main* filter) { filter->SetOutputCellsToBezier(); });
}

TEST(ProgramForecast, LocalRefinementAtMost)
{
  const auto refine = [](auto* filter)
  {
    filter->SetMaximumLevel(3);
    filter->RefineByAttributeErrorOff();
    filter->RefineByEdgeLengthOn();
    filter->SetMaximumEdgeLength(0.05);
  };
  Options options;
  options.Levels = 3;
  options.Kind = Options::RedGreen;
  Check<vtkRedGreenRefinement>(MakeModel(vtkSubdivisionModelSource::SHIP), options, refine);
  options.Kind = Options::Adaptive;
  Check<vtkAdaptiveSurfaceSubdivision>(MakeSphere(), options, refine);
  options.MaximumNumberOfCells = 5.;
  const Forecast few = Foretell(ControlCounts{ 0., 0., 9., 0., 27., 9., 9. }, options);
  EXPECT_EQ(few.Cells, 5.);
  EXPECT_LE(few.Work, 5.);
}

TEST(ProgramForecast, LabelsAtMost)
{
  const auto image = MakeImage();
  vtkNew<vtkIntArray> labels;
  labels->SetName("Label");
  labels->SetNumberOfValues(image->GetNumberOfPoints());
  labels->FillValue(1);
  image->GetPointData()->SetScalars(labels);
  const auto voxels = static_cast<double>(image->GetNumberOfPoints());
  for (const bool areHexahedra : { false, true })
  {
    for (const vtkIdType most : { 0, 60 })
    {
      SCOPED_TRACE(most);
      vtkNew<vtkSubdivisionLabelSolid> filter;
      filter->SetInputData(image);
      filter->SetNumberOfControlCells(most);
      filter->SetCellType(areHexahedra);
      filter->Update();
      Options options;
      options.Kind = Options::OfLabels;
      options.Levels = 1;
      options.VolumeScheme = areHexahedra ? Main::HYBRID : Main::BOX_SPLINE;
      options.BytesPerPoint = 24.;
      options.BytesPerCell = 4.;
      options.MaximumNumberOfVoxels = static_cast<double>(most);
      const Forecast forecast = Foretell(ControlCounts{ 0., 0., 0., 0., 0., voxels }, options);
      const auto cells = static_cast<double>(filter->GetOutput()->GetNumberOfCells());
      const auto bytes = 1024. * static_cast<double>(filter->GetOutput()->GetActualMemorySize());
      EXPECT_TRUE(forecast.IsAtMost);
      EXPECT_GE(forecast.Cells, cells);
      EXPECT_LT(forecast.Cells, 9. * cells); // blocks of 2^3 voxels are far fewer than 60
      EXPECT_GE(forecast.Bytes, bytes);
      EXPECT_LT(forecast.Bytes, 12. * bytes);
      EXPECT_EQ(forecast.Cells, (most > 0 ? 60. : voxels) * (areHexahedra ? 8. : 48.));
    }
  }
}
