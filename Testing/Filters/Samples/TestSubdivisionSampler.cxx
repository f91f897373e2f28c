// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSubdivisionSampler.cxx
 * vtkSubdivisionSampler: grids, thickness, and what is not usable.
 */
#include "Private/Run/SizeChecks.h"
#include "SamplerTools.h"

#include "vtkTrivialProducer.h"

using namespace sampler_tools;

// ------------------------------------------------------------------------------------------------
// Grids

TEST(SubdivisionSampler, TheGridFollowsFromTheOptions)
{
  vtkNew<Filter> filter;
  filter->SetNumberOfSamples(20);
  filter->SetMargin(2);
  Image image = Sample(filter, MakeSolid());
  EXPECT_EQ(*std::max_element(image->GetDimensions(), image->GetDimensions() + 3), 20);
  EXPECT_GT(CountInside(image), 100);
  EXPECT_TRUE(image->GetPointData()->GetArray("Heat"));
  EXPECT_FALSE(image->GetPointData()->GetArray("Material"));
  EXPECT_FALSE(image->GetPointData()->GetArray("Coverage"));
  filter->SetSpacing(0.05);
  image = Sample(filter, MakeSolid());
  EXPECT_EQ(image->GetSpacing()[0], 0.05);
  EXPECT_EQ(image->GetSpacing()[2], 0.05);
  filter->UseSamplingBoundsOn();
  filter->SetSamplingBounds(0., 1., -1., 2., 0.2, 0.2);
  filter->GenerateCoverageOn();
  image = Sample(filter, MakeSolid());
  EXPECT_EQ(image->GetDimensions()[0], 21);
  EXPECT_EQ(image->GetDimensions()[1], 61);
  EXPECT_EQ(image->GetDimensions()[2], 1);
  EXPECT_NEAR(image->GetOrigin()[1], -1., 1e-12);
  EXPECT_EQ(image->GetPointData()->GetArray("Coverage")->GetNumberOfComponents(), 1);
}

/// Where there is too little room for both, the margin is smaller.
TEST(SubdivisionSampler, NumbersOfSamplesAreThoseAskedFor)
{
  for (const int samples : { 2, 3, 4, 5, 6, 7, 20 })
  {
    for (const int margin : { 0, 1, 2, 50 })
    {
      vtkNew<Filter> filter;
      filter->SetNumberOfSamples(samples);
      filter->SetMargin(margin);
      const Image image = Sample(filter, MakeSolid());
      const int* const found = image->GetDimensions();
      EXPECT_EQ(*std::max_element(found, found + 3), samples) << margin;
    }
  }
}

TEST(SubdivisionSampler, AnImageGivesItsGrid)
{
  const Grid solid = MakeSolid();
  vtkNew<vtkImageData> like;
  like->SetExtent(-3, 12, 2, 9, 1, 5);
  like->SetOrigin(0.1, 0., 0.);
  like->SetSpacing(0.04, 0.05, 0.1);
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(like);
  vtkNew<Filter> filter;
  filter->SetGridConnection(producer->GetOutputPort());
  filter->SetSpacing(7.); // the image goes before it
  const Image image = Sample(filter, solid);
  EXPECT_EQ(image->GetNumberOfPoints(), like->GetNumberOfPoints());
  for (int k = 0; k < 6; ++k)
  {
    EXPECT_EQ(image->GetExtent()[k], like->GetExtent()[k]) << k;
  }
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_EQ(image->GetOrigin()[k], like->GetOrigin()[k]);
    EXPECT_EQ(image->GetSpacing()[k], like->GetSpacing()[k]);
  }
  EXPECT_GT(CountInside(image), 10);
  // The same places without the image.
  vtkNew<Filter> other;
  other->UseSamplingBoundsOn();
  other->SetSamplingBounds(0.26, 0.26, 0.25, 0.25, 0.2, 0.2);
  other->SetSpacing(0.04);
  const Image one = Sample(other, solid);
  ASSERT_EQ(one->GetNumberOfPoints(), 1);
  const vtkIdType same = image->FindPoint(0.26, 0.25, 0.2);
  EXPECT_EQ(CountInside(one), 1);
  EXPECT_NEAR(one->GetPointData()->GetArray("Heat")->GetComponent(0, 0),
    image->GetPointData()->GetArray("Heat")->GetComponent(same, 0), 1e-3);
}

TEST(SubdivisionSampler, BadGridsAreErrors)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double spacing : { -0.5, nan, infinity })
  {
    vtkNew<Filter> filter;
    filter->SetSpacing(spacing);
    const std::string error = FindError(filter, MakeSolid());
    EXPECT_NE(error.find("Spacing is not usable"), std::string::npos) << spacing << ": " << error;
  }
  for (const double high : { -1., nan, infinity })
  {
    vtkNew<Filter> filter;
    filter->UseSamplingBoundsOn();
    filter->SetSamplingBounds(0., 1., 0., 1., 0., high);
    const std::string error = FindError(filter, MakeSolid());
    EXPECT_NE(error.find("SamplingBounds are not usable"), std::string::npos) << high;
    filter->UseSamplingBoundsOff();
    filter->SetNumberOfSamples(10);
    EXPECT_GT(CountInside(Sample(filter, MakeSolid())), 0);
  }
}

TEST(SubdivisionSampler, ARotatedOrFlatGridIsAnError)
{
  vtkNew<vtkImageData> like;
  like->SetDimensions(5, 5, 5);
  like->SetDirectionMatrix(0., 1., 0., -1., 0., 0., 0., 0., 1.);
  vtkNew<Filter> filter;
  filter->SetInputDataObject(3, like);
  EXPECT_NE(FindError(filter, MakeSolid()).find("port 3 is rotated"), std::string::npos);
  like->SetDirectionMatrix(1., 0., 0., 0., 1., 0., 0., 0., 1.);
  like->SetSpacing(0.1, 0., 0.1);
  EXPECT_NE(FindError(filter, MakeSolid()).find("spacing that is not positive"), std::string::npos);
  like->SetSpacing(0.1, 0.1, 0.1);
  EXPECT_GT(CountInside(Sample(filter, MakeSolid())), 0);
}

TEST(SubdivisionSampler, LevelsFollowAnotherGrid)
{
  const Grid mesh = MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, { { VTK_TETRA, { 0, 1, 2, 3 } } });
  vtkNew<vtkImageData> coarse;
  coarse->SetDimensions(4, 4, 4);
  coarse->SetSpacing(0.3, 0.3, 0.3);
  vtkNew<vtkImageData> fine;
  fine->SetDimensions(50, 50, 50);
  fine->SetSpacing(0.02, 0.02, 0.02);
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(coarse);
  vtkNew<Filter> filter;
  filter->SetGridConnection(producer->GetOutputPort());
  Sample(filter, mesh);
  producer->SetOutput(fine);
  const Image image = Sample(filter, mesh);
  vtkNew<Filter> other;
  other->SetInputDataObject(3, fine);
  EXPECT_EQ(CompareImages(image, Sample(other, mesh)), "");
  // A grid that is not good leaves no failure behind.
  fine->SetSpacing(0.02, 0., 0.02);
  EXPECT_NE(FindError(filter, mesh).find("not positive"), std::string::npos);
  fine->SetSpacing(0.02, 0.02, 0.02);
  EXPECT_EQ(CompareImages(image, Sample(filter, mesh)), "");
}

/// No image has so many samples along an axis: they were cut off.
TEST(SubdivisionSampler, ATooLongImageTellsASpacing)
{
  vtkNew<Filter> filter;
  filter->SetSpacing(1e-8);
  filter->SetMargin(0);
  const std::string error = FindError(filter, MakeCurve());
  EXPECT_NE(error.find("along an axis"), std::string::npos) << error;
  EXPECT_NE(error.find("A spacing of 1."), std::string::npos) << error;
}

TEST(SubdivisionSampler, MemoryThatIsNotThereIsTold)
{
  vtkNew<Filter> filter;
  filter->SetSpacing(1e-5);
  filter->SetMaximumNumberOfSamples(VTK_ID_MAX);
  filter->SetMaximumLevel(1);
  std::string error = FindError(filter, MakeSolid());
  EXPECT_NE(error.find("Ask for parts of the image"), std::string::npos) << error;
  // 1e15 samples of nine bytes, and a spacing by which they are fewer than there are bytes.
  const std::size_t told = error.find(" TB were expected to be enough");
  ASSERT_NE(told, std::string::npos) << error;
  EXPECT_GT(std::stod(error.substr(error.rfind(' ', told - 1))), 0.5) << error;
  const std::string words = "A spacing of ";
  const std::size_t at = error.find(words);
  ASSERT_NE(at, std::string::npos) << error;
  const double spacing = std::stod(error.substr(at + words.size()));
  vtkNew<Filter> small;
  small->SetMargin(0);
  const Image image = Sample(small, MakeSolid());
  double bytes = 9.;
  for (int x = 0; x < 3; ++x)
  {
    bytes *= image->GetSpacing()[x] * image->GetDimensions()[x] / spacing;
  }
  // Other programs may take or free memory meanwhile.
  EXPECT_LE(bytes, 1.5 * subdivision::GetAvailableMemory());
  EXPECT_GE(bytes, 0.1 * subdivision::GetAvailableMemory());
  filter->GenerateCoverageOn();
  error = FindError(filter, MakeSolid());
  EXPECT_NE(error.find("Switch GenerateCoverage off"), std::string::npos) << error;
}

/// Solids, flat and straight objects have other numbers of samples by their spacing.
TEST(SubdivisionSampler, ATooLargeImageTellsASpacingThatWorks)
{
  const Grid needle = MakeGrid(
    { { 0, 0, 0 }, { 100, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, { { VTK_TETRA, { 0, 1, 2, 3 } } });
  for (const Grid& mesh : { MakeSolid(), MakeSheet(), MakeCurve(), needle })
  {
    for (const double spacing : { 1e-3, 1e-12, 1e-300 })
    {
      vtkNew<Filter> filter;
      filter->SetMaximumNumberOfSamples(20000);
      filter->SetTolerance(1.);
      filter->SetMaximumLevel(1);
      filter->SetSpacing(spacing);
      if (mesh->GetCellType(0) == VTK_LINE && spacing == 1e-3)
      {
        filter->SetSpacing(1e-4);
      }
      const std::string error = FindError(filter, mesh);
      EXPECT_NE(error.find("MaximumNumberOfSamples"), std::string::npos) << error;
      const std::string words = "A spacing of ";
      const std::size_t at = error.find(words);
      ASSERT_NE(at, std::string::npos) << error;
      filter->SetSpacing(std::stod(error.substr(at + words.size())));
      const Image image = Sample(filter, mesh);
      EXPECT_LE(image->GetNumberOfPoints(), 20000);
      EXPECT_GT(image->GetNumberOfPoints(), 5000) << filter->GetSpacing();
    }
  }
  vtkNew<Filter> filter;
  filter->SetMargin(100);
  filter->SetMaximumNumberOfSamples(20000);
  EXPECT_NE(FindError(filter, MakeSolid()).find("Make Margin smaller"), std::string::npos);
}

// ------------------------------------------------------------------------------------------------
// Thickness

TEST(SubdivisionSampler, ASurfaceAloneHasAThickness)
{
  const Grid sheet = MakeSheet();
  vtkNew<Filter> filter;
  filter->SetSpacing(0.02);
  filter->SetMargin(6);
  const vtkIdType thin = CountInside(Sample(filter, sheet)); // twice the distance of samples
  EXPECT_GT(thin, 0);
  filter->SetThickness(0.16); // 9 samples across, and 3 without it
  const double ratio = double(CountInside(Sample(filter, sheet))) / double(thin);
  EXPECT_GT(ratio, 2.5);
  EXPECT_LT(ratio, 5.);
  filter->SetThickness(-1.);
  EXPECT_EQ(filter->GetThickness(), 0.);
}

TEST(SubdivisionSampler, ACurveIsAsThickAsItsArraySays)
{
  const Grid curve = MakeCurve();
  vtkNew<vtkDoubleArray> thicknesses;
  thicknesses->SetName("Diameter");
  for (const double value : { 0.1, 0.1, 0.5, 0.5 })
  {
    thicknesses->InsertNextValue(value);
  }
  curve->GetPointData()->AddArray(thicknesses);
  vtkNew<Filter> filter;
  filter->SetSpacing(0.02);
  filter->SetMargin(20);
  filter->SetThickness(1e-9); // the array goes before it
  SetThicknesses(filter, "Diameter");
  const Image image = Sample(filter, curve);
  vtkDataArray* const mask = image->GetPointData()->GetArray("vtkValidPointMask");
  for (const auto& [x, y, isInside] : std::vector<std::tuple<double, double, bool>>{
         { 0.6, 0., true }, { 0.6, 0.2, false }, { 2.5, 0.2, true }, { 2.5, 0.3, false } })
  {
    EXPECT_EQ(mask->GetComponent(image->FindPoint(x, y, 0.), 0) != 0., isInside) << x << " " << y;
  }
}

TEST(SubdivisionSampler, BadThicknessesAreErrors)
{
  const Grid curve = MakeCurve();
  curve->GetPointData()->AddArray(MakeArray<vtkIntArray>("Whole", 1, 4, 1., 5., 1));
  curve->GetPointData()->AddArray(MakeArray<vtkDoubleArray>("Vector", 3, 4, 1., 5., 1));
  curve->GetPointData()->AddArray(MakeNames("Text", 4));
  for (const auto& [name, part] : std::map<std::string, std::string>{
         { "None there", "is not there" }, { "Whole", "must be floating point" },
         { "Vector", "one for each point" }, { "Text", "must hold numbers" } })
  {
    vtkNew<Filter> filter;
    SetThicknesses(filter, name.c_str());
    const std::string error = FindError(filter, curve);
    EXPECT_NE(error.find(part), std::string::npos) << name << ": " << error;
    EXPECT_NE(error.find(name), std::string::npos) << error;
    EXPECT_NE(error.find("array index 12"), std::string::npos) << error;
  }
}

TEST(SubdivisionSampler, NegativeThicknessesAreTold)
{
  const Grid curve = MakeCurve();
  curve->GetPointData()->AddArray(MakeArray<vtkDoubleArray>("Diameter", 1, 4, -2., -1., 1));
  vtkNew<Filter> filter;
  SetThicknesses(filter, "Diameter");
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetInputDataObject(curve);
  filter->Update();
  EXPECT_EQ(CountInside(filter->GetOutput()), 0);
  EXPECT_EQ(messages->CountWarnings("Make them 0 or more"), 1);
}
