// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSampledDistances.cxx
 * Distances of vtkSubdivisionSampler: against closed forms, and against triangles of a fine level.
 */
#include "SamplerTools.h"

#include "vtkCellLocator.h"
#include "vtkGeometryFilter.h"
#include "vtkSubdivisionModelSource.h"

using namespace sampler_tools;

namespace
{

constexpr double Sizes[3] = { 3., 2., 2. };

/// Voxels of two materials.
vtkSmartPointer<vtkImageData> MakeBox()
{
  const auto box = vtkSmartPointer<vtkImageData>::New();
  box->SetDimensions(4, 3, 3);
  vtkNew<vtkIntArray> materials;
  materials->SetName("MaterialId");
  for (vtkIdType c = 0; c < box->GetNumberOfCells(); ++c)
  {
    materials->InsertNextValue(c < 5 ? 3 : 7);
  }
  box->GetCellData()->AddArray(materials);
  return box;
}

/// Negative inside.
double FindDistanceOfBox(const double* place)
{
  double outside = 0.;
  double inside = -10.;
  for (int x = 0; x < 3; ++x)
  {
    const double beyond = std::max(-place[x], place[x] - Sizes[x]);
    outside += beyond > 0. ? beyond * beyond : 0.;
    inside = std::max(inside, beyond);
  }
  return outside > 0. ? std::sqrt(outside) : inside;
}

double Clamp(double distance, double band)
{
  return std::max(-band, std::min(band, distance));
}

/// Compares all distances with `expected(place)`; returns how many are nearer than the band.
template <typename Expected>
vtkIdType Compare(vtkImageData* image, double band, double mistake, const Expected& expected)
{
  vtkDataArray* const found = image->GetPointData()->GetArray("Distance");
  EXPECT_TRUE(found && found->GetDataType() == VTK_FLOAT);
  vtkIdType near = 0;
  for (vtkIdType s = 0; found && s < image->GetNumberOfPoints(); ++s)
  {
    const double wanted = Clamp(expected(image->GetPoint(s)), band);
    near += std::abs(wanted) < band ? 1 : 0;
    const double* const p = image->GetPoint(s);
    EXPECT_NEAR(found->GetComponent(s, 0), wanted, mistake) << p[0] << " " << p[1] << " " << p[2];
  }
  return near;
}

}

TEST(SampledDistances, OfABoxAreThoseOfItsOutside)
{
  for (const double band : { 0., 0.7, 50. })
  {
    vtkNew<Filter> filter;
    filter->SetVolumeSchemeToLinear();
    filter->SetSpacing(0.13);
    filter->SetMargin(6);
    filter->GenerateDistanceOn();
    filter->SetDistanceBand(band);
    const double used = band > 0. ? band : 3. * 0.13;
    const Image image = Sample(filter, MakeBox());
    EXPECT_EQ(image->GetPointData()->GetScalars()->GetName(), std::string("Material"));
    EXPECT_GT(Compare(image, used, 1e-6, FindDistanceOfBox), 1000) << band;
  }
}

/// Copies of points, where values jump, are no outside.
TEST(SampledDistances, InterfacesAreNoOutside)
{
  vtkNew<Filter> filter;
  filter->SetVolumeSchemeToLinear();
  filter->SetSpacing(0.2);
  filter->GenerateDistanceOn();
  filter->PreserveInterfacesOn();
  filter->SetInterfaceValues(vtkSubdivisionAlgorithm::DISCONTINUOUS_VALUES);
  Compare(Sample(filter, MakeBox()), 0.6, 1e-6, FindDistanceOfBox);
}

/// The same tetrahedra in two blocks, or twice in one mesh: nothing is behind their faces.
TEST(SampledDistances, CopiesOfSolidsAreNoNeighbours)
{
  const std::vector<Point> points{ { 0, 0, 0 }, { 3, 0, 0 }, { 0, 3, 0 }, { 0, 0, 3 },
    { 3, 3, 3 } };
  const Grid once =
    MakeGrid(points, { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 1, 2, 3, 4 } } });
  const Grid twice = MakeGrid(points,
    { { VTK_TETRA, { 0, 1, 2, 3 } }, { VTK_TETRA, { 1, 2, 3, 4 } },
      { VTK_TETRA, { 3, 1, 0, 2 } } });
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, once);
  blocks->SetBlock(1, once);
  const auto sample = [](vtkDataObject* mesh, bool joins)
  {
    vtkNew<Filter> filter;
    filter->SetVolumeSchemeToLinear();
    filter->SetSpacing(0.2);
    filter->GenerateDistanceOn();
    filter->SetDistanceBand(1.);
    filter->SetJoinBlocks(joins);
    filter->UseSamplingBoundsOn();
    filter->SetSamplingBounds(-0.5, 3.5, -0.5, 3.5, -0.5, 3.5);
    UpdateInSilence(filter, mesh, nullptr, { "Blocks have cells in common", "of the distance" });
    const auto image = Image::New();
    image->DeepCopy(filter->GetOutput());
    return image;
  };
  const Image expected = sample(once, true);
  vtkDataArray* const distances = expected->GetPointData()->GetArray("Distance");
  for (const Image& image : { sample(twice, true), sample(blocks, true), sample(blocks, false) })
  {
    EXPECT_GT(Compare(image, 1., 1e-6,
                [&](const double* p)
                {
                  double place[3] = { p[0], p[1], p[2] };
                  return distances->GetComponent(expected->FindPoint(place), 0);
                }),
      1000);
  }
}

TEST(SampledDistances, OfSurfacesCurvesAndPointsHaveNoSign)
{
  const Grid mesh = MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 3, 0, 0 } },
    { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 0, 2, 3 } }, { VTK_LINE, { 4, 5 } },
      { VTK_VERTEX, { 6 } } });
  vtkNew<Filter> filter;
  filter->SetVolumeSchemeToLinear();
  filter->SetSpacing(0.1);
  filter->SetMargin(5);
  filter->GenerateDistanceOn();
  filter->SetDistanceBand(0.45);
  const auto expected = [](const double* p)
  {
    const auto beyond = [](double x, double high) { return std::max({ 0., -x, x - high }); };
    return std::min({ std::hypot(beyond(p[0], 1.), beyond(p[1], 1.), p[2]),
      std::hypot(p[0] - 2., beyond(p[1], 1.), p[2]), std::hypot(p[0] - 3., p[1], p[2]) });
  };
  EXPECT_GT(Compare(Sample(filter, mesh), 0.45, 1e-6, expected), 1000);
}

/// Inside of the solid its outside counts alone, outside what is nearer.
TEST(SampledDistances, OfMixedObjectsAreThoseOfAllTogether)
{
  const Grid solid = MakeGrid(
    { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 0, 0, 4 }, { 0.5, 0.5, 0.5 }, { -2, -2, 0.5 } },
    { { VTK_TETRA, { 0, 1, 2, 3 } } });
  const Grid mixed = Grid::New();
  mixed->DeepCopy(solid);
  vtkNew<vtkIdList> ends;
  ends->InsertNextId(4); // in the solid
  ends->InsertNextId(5);
  mixed->InsertNextCell(VTK_LINE, ends);
  vtkNew<Filter> filter;
  filter->SetVolumeSchemeToLinear();
  filter->GenerateDistanceOn();
  filter->SetDistanceBand(3.);
  filter->UseSamplingBoundsOn();
  filter->SetSamplingBounds(-2.5, 4.2, -2.5, 4.2, -0.5, 4.2);
  filter->SetSpacing(0.2);
  const Image alone = Sample(filter, solid);
  const Image image = Sample(filter, mixed);
  vtkDataArray* const ofSolid = alone->GetPointData()->GetArray("Distance");
  vtkDataArray* const ofBoth = image->GetPointData()->GetArray("Distance");
  vtkIdType nearer = 0;
  for (vtkIdType s = 0; s < image->GetNumberOfPoints(); ++s)
  {
    const double* const p = image->GetPoint(s);
    // The line is where x = y, from 0.5 to -2, at z = 0.5.
    const double along = std::max(-2., std::min(0.5, (p[0] + p[1]) / 2.));
    const double ofLine = std::hypot(p[0] - along, p[1] - along, p[2] - 0.5);
    const double d = ofSolid->GetComponent(s, 0);
    const double wanted = d < 0. ? d : std::min(d, ofLine);
    nearer += wanted < d ? 1 : 0;
    ASSERT_NEAR(ofBoth->GetComponent(s, 0), wanted, 1e-6) << p[0] << " " << p[1] << " " << p[2];
  }
  EXPECT_GT(nearer, 1000);
}

/// Within the tolerance of the limit: of the outside of a fine level, and of where samples are.
TEST(SampledDistances, OfSmoothSolidsAreThoseOfAFineLevel)
{
  vtkNew<vtkSubdivisionModelSource> source;
  source->SetModelToMechanicalPart();
  source->Update();
  for (const double tolerance : { 0.1, 0.02 })
  {
    vtkNew<Filter> filter;
    filter->SetVolumeSchemeToBoxSpline();
    filter->SetOutputDimensions(vtkMultiDimensionalSubdivision::TETRAHEDRA);
    filter->SetNumberOfSamples(28);
    filter->SetMargin(4);
    filter->SetTolerance(tolerance);
    filter->GenerateDistanceOn();
    const Image image = Sample(filter, source->GetOutput());
    vtkNew<vtkMultiDimensionalSubdivision> level;
    level->SetVolumeSchemeToBoxSpline();
    level->SetOutputDimensions(vtkMultiDimensionalSubdivision::TETRAHEDRA);
    level->SetNumberOfLevels(3);
    level->ProjectToLimitOn();
    level->SetInputConnection(source->GetOutputPort());
    vtkNew<vtkGeometryFilter> outside;
    outside->SetInputConnection(level->GetOutputPort());
    outside->Update();
    vtkNew<vtkCellLocator> locator;
    locator->SetDataSet(outside->GetOutput());
    locator->BuildLocator();
    const double spacing = image->GetSpacing()[0];
    vtkDataArray* const mask = image->GetPointData()->GetArray("vtkValidPointMask");
    const auto expected = [&](const double* p)
    {
      double place[3] = { p[0], p[1], p[2] };
      double nearest[3];
      double square = 0.;
      vtkIdType cell = 0;
      int part = 0;
      const bool isNear = locator->FindClosestPointWithinRadius(
                            place, 3. * spacing, nearest, cell, part, square) != 0;
      const vtkIdType sample = image->FindPoint(place);
      return (isNear ? std::sqrt(square) : 3. * spacing) *
        (mask->GetComponent(sample, 0) != 0. ? -1. : 1.);
    };
    EXPECT_GT(Compare(image, 3. * spacing, 2. * tolerance * spacing, expected), 2000);
  }
}
