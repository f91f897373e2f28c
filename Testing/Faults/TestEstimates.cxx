// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestEstimates.cxx
 * What filters estimate before they take memory is enough, so that none is stopped by the system,
 * and not far more than they take, so that none is refused without need.
 */
#include "FailingMemory.h"
#include "FeatureTools.h"
#include "Private/Run/SizeChecks.h"
#include "Turns.h"

#include "vtkCallbackCommand.h"
#include "vtkImageData.h"
#include "vtkPlaneSource.h"
#include "vtkSphereSource.h"
#include "vtkSubdivisionModelSource.h"
#include "vtkSubdivisionSampler.h"
#include "vtkSurfaceSubdivision.h"

#include <sstream>

using namespace feature_tools;
using namespace multi_dimensional_subdivision_tools;

namespace
{

/// Letters: P projects, N normals, T tangents, S sharp edges, A ten arrays, C keeps operators.
bool Has(const std::string& options, char option)
{
  return options.find(option) != std::string::npos;
}

template <typename Filter>
void Set(Filter* filter, const std::string& options)
{
  filter->SetProjectToLimit(Has(options, 'P'));
  filter->SetGenerateLimitNormals(Has(options, 'N'));
  filter->SetGenerateTangents(Has(options, 'T'));
  filter->SetDetectFeatures(Has(options, 'S'));
  filter->SetFeatureAngle(1.);
  filter->SetCacheOperator(Has(options, 'C'));
}

/// Keeps the bytes of "About 12.3 MB", which are forgotten at the end of the work.
void KeepEstimate(vtkObject*, unsigned long, void* kept, void*)
{
  const std::string told = subdivision::TellEstimate();
  const std::string before = "About ";
  const std::size_t at = told.find(before);
  if (at != std::string::npos)
  {
    std::istringstream text(told.substr(at + before.size()));
    std::string unit;
    double bytes = 0.;
    text >> bytes >> unit;
    const std::string units[] = { "bytes", "kB", "MB", "GB" };
    const auto found = std::find(std::begin(units), std::end(units), unit);
    *static_cast<double*>(kept) = bytes * std::pow(1000., found - std::begin(units));
  }
}

/// A closed surface of triangles, or an open one of quads.
vtkSmartPointer<vtkPolyData> MakeSurface(bool isClosed, const std::string& options)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(16);
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(20, 20);
  vtkPolyDataAlgorithm* source = isClosed ? static_cast<vtkPolyDataAlgorithm*>(sphere) : plane;
  source->Update();
  const auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(source->GetOutput()->GetPoints());
  surface->SetPolys(source->GetOutput()->GetPolys());
  for (int i = 0; i < (Has(options, 'A') ? 10 : 1); ++i)
  {
    vtkNew<vtkDoubleArray> values;
    values->SetName(("Values " + std::to_string(i)).c_str());
    values->SetNumberOfTuples(surface->GetNumberOfPoints());
    values->Fill(1.);
    surface->GetPointData()->AddArray(values);
  }
  return surface;
}

/// The estimate is at least the peak and, besides what lists lose at their ends, at most 1.8 times
/// as much.
template <typename Filter>
void ExpectEstimate(Filter* filter, const std::string& name)
{
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 1, "Sequential", false },
    [&]
    {
      double estimate = 0.;
      vtkNew<vtkCallbackCommand> keep;
      keep->SetCallback(KeepEstimate);
      keep->SetClientData(&estimate);
      filter->AddObserver(vtkCommand::ProgressEvent, keep);
      failing_memory::StartPeak();
      filter->Update();
      const auto peak = static_cast<double>(failing_memory::GetPeak());
      ASSERT_GT(filter->GetOutput()->GetNumberOfCells(), 50000) << name;
      if (peak > 0.)
      {
        std::cout << name << ": " << 1e-6 * peak << " MB, " << estimate / peak << " estimated\n";
        EXPECT_GE(estimate, peak) << name;
        EXPECT_LE(estimate - subdivision::BytesOfPages, 1.8 * peak) << name;
      }
    });
}

struct Scheme
{
  int Number;
  int Levels;
};

/// One case for each scheme: together they take long.
class Estimates : public testing::TestWithParam<Scheme>
{
};

void ExpectEstimateOfSurface(const Scheme& scheme, bool isClosed, const std::string& options)
{
  vtkNew<vtkSurfaceSubdivision> filter;
  filter->SetInputData(MakeSurface(isClosed, options));
  filter->SetScheme(scheme.Number);
  filter->SetNumberOfLevels(scheme.Levels);
  Set(filter.Get(), options);
  ExpectEstimate(filter.Get(), options + (isClosed ? ", closed" : ", open"));
}

TEST_P(Estimates, Surfaces)
{
  for (const std::string options : { "", "C", "S", "A", "N", "PC", "PN", "PNTA" })
  {
    for (const bool isClosed : { true, false })
    {
      ExpectEstimateOfSurface(GetParam(), isClosed, options);
    }
  }
  // All edges are sharp, so that the last level is made for limits.
  ExpectEstimateOfSurface(GetParam(), true, "PS");
}

const Scheme Schemes[] = { { vtkSurfaceSubdivision::LOOP, 5 },
  { vtkSurfaceSubdivision::MODIFIED_BUTTERFLY, 5 }, { vtkSurfaceSubdivision::CATMULL_CLARK, 5 },
  { vtkSurfaceSubdivision::DOO_SABIN, 5 }, { vtkSurfaceSubdivision::MIDEDGE, 10 },
  { vtkSurfaceSubdivision::FOUR_EIGHT, 9 }, { vtkSurfaceSubdivision::FOUR_EIGHT, 10 },
  { vtkSurfaceSubdivision::SQRT_THREE, 6 }, { vtkSurfaceSubdivision::LINEAR, 5 } };

std::string NameOf(const testing::TestParamInfo<Scheme>& given)
{
  return "Scheme" + std::to_string(given.param.Number) + "Levels" +
    std::to_string(given.param.Levels);
}

INSTANTIATE_TEST_SUITE_P(Schemes, Estimates, testing::ValuesIn(Schemes), NameOf);

}

TEST(EstimatesOfSolids, MixedDimensions)
{
  for (const bool isSolid : { true, false })
  {
    for (const int volumeScheme :
      { vtkMultiDimensionalSubdivision::BOX_SPLINE, vtkMultiDimensionalSubdivision::TET_OCT })
    {
      for (const std::string options : turns::Some({ "", "C", "P", "PC", "N", "PNT" }))
      {
        vtkNew<vtkMultiDimensionalSubdivision> filter;
        filter->SetInputDataObject(
          isSolid ? static_cast<vtkDataObject*>(MakeKuhnBox(7)) : MakeSurface(true, options).Get());
        filter->SetVolumeScheme(volumeScheme);
        filter->SetNumberOfLevels(isSolid ? 3 : 5);
        Set(filter.Get(), options);
        ExpectEstimate(filter.Get(),
          std::string(isSolid ? "solid " : "surface ") + std::to_string(volumeScheme) + " " +
            options);
      }
    }
  }
}

TEST(EstimatesOfSolids, CellsThatKeepTheirTypes)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(13, 13, 13);
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(20, 20);
  plane->Update();
  for (const std::string options : { "linear", "", "C", "N", "NTC", "surface N" })
  {
    const bool isLinear = options == "linear";
    const bool isSurface = Has(options, 's');
    vtkNew<vtkMultiDimensionalSubdivision> filter;
    filter->SetInputDataObject(
      isSurface ? static_cast<vtkDataObject*>(plane->GetOutput()) : image.Get());
    isLinear ? filter->SetVolumeSchemeToLinear() : filter->SetVolumeSchemeToHybrid();
    filter->SetKeepCellTypes(isLinear);
    Set(filter.Get(), options);
    filter->SetNumberOfLevels(isSurface ? 5 : 3);
    ExpectEstimate(filter.Get(), "types stay: " + options);
  }
}

/// Of an image with two arrays of numbers in double, materials and distances: what a larger one
/// takes more, so that the levels do not count.
TEST(Estimates, SamplesTakeThirtyBytes)
{
  vtkNew<vtkSubdivisionModelSource> source;
  source->SetModelToMechanicalPart();
  source->Update();
  vtkNew<vtkUnstructuredGrid> mesh;
  mesh->DeepCopy(source->GetOutput());
  mesh->GetPointData()->Initialize();
  for (const char* const name : { "A", "B" })
  {
    vtkNew<vtkDoubleArray> values;
    values->SetName(name);
    values->SetNumberOfTuples(mesh->GetNumberOfPoints());
    values->Fill(1.);
    mesh->GetPointData()->AddArray(values);
  }
  double bytes[2];
  double samples[2];
  for (const int i : { 0, 1 })
  {
    vtkNew<vtkSubdivisionSampler> filter;
    filter->SetInputData(mesh);
    filter->SetMaximumLevel(1);
    filter->SetTolerance(1.);
    filter->SetNumberOfSamples(i == 0 ? 60 : 240);
    failing_memory::StartPeak();
    filter->Update();
    bytes[i] = static_cast<double>(failing_memory::GetPeak());
    samples[i] = static_cast<double>(filter->GetOutput()->GetNumberOfPoints());
    EXPECT_EQ(filter->GetOutput()->GetPointData()->GetNumberOfArrays(), 4);
  }
  if (bytes[1] > 0.) // counted
  {
    const double ofSample = (bytes[1] - bytes[0]) / (samples[1] - samples[0]);
    EXPECT_LE(ofSample, 30.);
    EXPECT_GE(ofSample, 21.); // 2 * 8, 4 and 1
  }
}
