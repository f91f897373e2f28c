// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSampledValues.cxx
 * The samples of vtkSubdivisionSampler lie where the object is, and have its values: against closed
 * forms, against the places that vtkSubdivisionLimitProbe finds, and against
 * vtkSubdivisionMeasures.
 */
#include "HybridFilterTools.h"
#include "MeasureTools.h"

#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkSubdivisionLimitProbe.h"
#include "vtkSubdivisionModelSource.h"
#include "vtkSubdivisionSampler.h"
#include "vtkTetra.h"

#include <numeric>
#include <random>

using namespace hybrid_filter_tools;

namespace
{

using Image = vtkSmartPointer<vtkImageData>;
using Sampler = vtkSubdivisionSampler;

Grid MakeModel(int model)
{
  vtkNew<vtkSubdivisionModelSource> source;
  source->SetModel(model);
  source->Update();
  const auto copy = Grid::New();
  copy->DeepCopy(source->GetOutput());
  return copy;
}

/// Adds a point array of the coordinates, in double precision.
void AddPlaces(vtkUnstructuredGrid* mesh)
{
  vtkNew<vtkDoubleArray> places;
  places->SetName("Place");
  places->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    places->InsertNextTuple(mesh->GetPoint(i));
  }
  mesh->GetPointData()->AddArray(places);
}

Image Sample(Sampler* sampler, vtkDataObject* input)
{
  return UpdateWithoutErrors<vtkImageData>(sampler, input);
}

vtkDataArray* GetArray(vtkImageData* image, const char* name)
{
  vtkDataArray* const array = image->GetPointData()->GetArray(name);
  EXPECT_NE(array, nullptr) << name;
  return array;
}

bool IsInside(vtkImageData* image, vtkIdType sample)
{
  return image->GetPointData()->GetArray("vtkValidPointMask")->GetComponent(sample, 0) != 0.;
}

/// The largest distance between a sample in the object and its value of "Place".
double FindLargestError(vtkImageData* image, vtkIdType& inside)
{
  vtkDataArray* const places = GetArray(image, "Place");
  double largest = 0.;
  inside = 0;
  for (vtkIdType s = 0; s < image->GetNumberOfPoints(); ++s)
  {
    for (int x = 0; x < 3 && IsInside(image, s); ++x)
    {
      inside += x == 0 ? 1 : 0;
      largest = std::max(largest, std::abs(places->GetComponent(s, x) - image->GetPoint(s)[x]));
    }
  }
  return largest;
}

double SumCoverage(vtkImageData* image)
{
  vtkDataArray* const coverage = GetArray(image, "Coverage");
  double sum = 0.;
  for (vtkIdType s = 0; s < image->GetNumberOfPoints(); ++s)
  {
    for (int c = 0; c < coverage->GetNumberOfComponents(); ++c)
    {
      sum += coverage->GetComponent(s, c);
    }
  }
  const double* spacing = image->GetSpacing();
  return sum * spacing[0] * spacing[1] * spacing[2];
}

/// Whether a point is in one of the tetrahedra of a mesh, which has no other cells. VTK's own
/// search takes points that are outside by a thousandth of a cell.
bool IsInTetrahedra(vtkUnstructuredGrid* mesh, const double* point)
{
  bool isIn = false;
  double place[3] = { point[0], point[1], point[2] };
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells() && !isIn; ++c)
  {
    double corners[4][3];
    for (int k = 0; k < 4; ++k)
    {
      mesh->GetPoint(mesh->GetCell(c)->GetPointId(k), corners[k]);
    }
    double weights[4];
    isIn =
      vtkTetra::BarycentricCoords(place, corners[0], corners[1], corners[2], corners[3], weights) &&
      *std::min_element(weights, weights + 4) >= -1e-9;
  }
  return isIn;
}

/// A box of n^3 hexahedra with two materials, one above the other.
Grid MakeBlock(int n)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(n + 1, n + 1, n + 1);
  vtkNew<vtkIntArray> materials;
  materials->SetName("MaterialId");
  for (vtkIdType c = 0; c < image->GetNumberOfCells(); ++c)
  {
    materials->InsertNextValue(c < image->GetNumberOfCells() / 2 ? 3 : 7);
  }
  image->GetCellData()->AddArray(materials);
  vtkNew<vtkMultiDimensionalSubdivision> reader; // makes cells of voxels
  reader->SetNumberOfLevels(0);
  reader->SetVolumeSchemeToHybrid();
  reader->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  return UpdateWithoutErrors<vtkUnstructuredGrid>(reader.Get(), image);
}

}

// ------------------------------------------------------------------------------------------------
// Closed forms

TEST(SampledValues, ABoxIsFilledWithoutGaps)
{
  const Grid block = MakeBlock(4);
  AddPlaces(block);
  for (const int scheme :
    { vtkMultiDimensionalSubdivision::LINEAR, vtkMultiDimensionalSubdivision::HYBRID })
  {
    vtkNew<Sampler> sampler;
    sampler->SetVolumeScheme(scheme);
    sampler->SetSpacing(0.13);
    sampler->SetMargin(3);
    sampler->PreserveInterfacesOn();
    const Image image = Sample(sampler, block);
    vtkIdType inside = 0;
    EXPECT_LE(FindLargestError(image, inside), 1e-9);
    if (scheme == vtkMultiDimensionalSubdivision::HYBRID)
    {
      EXPECT_GT(inside, 10000);
      continue;
    }
    for (vtkIdType s = 0; s < image->GetNumberOfPoints(); ++s)
    {
      const double* p = image->GetPoint(s);
      const bool isInside = std::all_of(p, p + 3, [](double x) { return x >= 0. && x <= 4.; });
      ASSERT_EQ(IsInside(image, s), isInside) << p[0] << " " << p[1] << " " << p[2];
      ASSERT_EQ(GetArray(image, "Material")->GetComponent(s, 0),
        !isInside     ? 0.
          : p[2] < 2. ? 3.
                      : 7.);
    }
  }
}

TEST(SampledValues, SolidsFarFromTheOriginAreFilledAsThoseThere)
{
  const auto count = [](double far)
  {
    const Grid block = MakeBlock(4);
    for (vtkIdType p = 0; p < block->GetNumberOfPoints(); ++p)
    {
      double at[3];
      block->GetPoint(p, at);
      block->GetPoints()->SetPoint(p, at[0] + far, at[1] + far, at[2] + far);
    }
    vtkNew<Sampler> sampler;
    sampler->SetVolumeSchemeToHybrid();
    sampler->SetSpacing(0.13);
    const Image image = Sample(sampler, block);
    vtkIdType inside = 0;
    for (vtkIdType s = 0; s < image->GetNumberOfPoints(); ++s)
    {
      inside += IsInside(image, s) ? 1 : 0;
    }
    return inside;
  };
  const vtkIdType near = count(0.);
  EXPECT_GT(near, 10000);
  EXPECT_NEAR(double(count(1e9)), double(near), 20.);
}

TEST(SampledValues, CellsOfAllTypesAreFilledWithoutGaps)
{
  const Grid mesh = MakeAllTypes();
  vtkNew<Sampler> sampler;
  sampler->SetVolumeSchemeToLinear();
  sampler->SetOutputDimensions(vtkMultiDimensionalSubdivision::TETRAHEDRA);
  sampler->SetNumberOfSamples(40);
  const Image image = Sample(sampler, mesh);
  vtkNew<vtkMultiDimensionalSubdivision> level;
  level->SetVolumeSchemeToLinear();
  level->SetOutputDimensions(vtkMultiDimensionalSubdivision::TETRAHEDRA);
  const Grid cells = UpdateWithoutErrors<vtkUnstructuredGrid>(level.Get(), mesh);
  vtkIdType inside = 0;
  vtkIdType wrong = 0;
  for (vtkIdType s = 0; s < image->GetNumberOfPoints(); ++s)
  {
    const bool isInside = IsInTetrahedra(cells, image->GetPoint(s));
    inside += isInside ? 1 : 0;
    wrong += isInside != IsInside(image, s) ? 1 : 0;
  }
  EXPECT_GT(inside, 1000);
  EXPECT_EQ(wrong, 0);
}

/// So that the first picture of volume rendering has all materials.
TEST(SampledValues, OutsideIsNoMaterial)
{
  const auto sample = [](vtkDataArray* materials)
  {
    const Grid block = MakeBlock(2);
    materials->SetName("MaterialId");
    materials->SetNumberOfTuples(8);
    for (vtkIdType c = 0; c < 8; ++c)
    {
      materials->SetComponent(c, 0, c < 4 ? 0. : 5.);
    }
    block->GetCellData()->AddArray(materials);
    vtkNew<Sampler> sampler;
    sampler->SetVolumeSchemeToLinear();
    sampler->SetNumberOfSamples(9);
    const Image image = Sample(sampler, block);
    EXPECT_EQ(image->GetPointData()->GetScalars(), GetArray(image, "Material"));
    return GetArray(image, "Material")->GetComponent(0, 0); // a corner of the margin
  };
  EXPECT_EQ(sample(vtkNew<vtkIntArray>()), -1.);
  EXPECT_EQ(sample(vtkNew<vtkUnsignedCharArray>()), 6.);
}

// ------------------------------------------------------------------------------------------------
// The limit

/// Coordinates are values like others, so that the value of a sample is its place, whatever the
/// scheme.
TEST(SampledValues, CoordinatesAreThePlaces)
{
  for (int model = 0; model < vtkSubdivisionModelSource::NUMBER_OF_MODELS; ++model)
  {
    const Grid mesh = MakeModel(model);
    AddPlaces(mesh);
    for (const int scheme : { 0, 1, 3 })
    {
      SCOPED_TRACE(testing::Message() << model << " scheme " << scheme);
      vtkNew<Sampler> sampler;
      sampler->SetVolumeScheme(scheme);
      sampler->SetNumberOfSamples(40);
      sampler->SetMaximumLevel(2);
      sampler->SetOutputDimensions(vtkMultiDimensionalSubdivision::TETRAHEDRA);
      const Image image = Sample(sampler, mesh);
      vtkIdType inside = 0;
      if (image->GetNumberOfPoints() > 0)
      {
        EXPECT_LE(FindLargestError(image, inside), 1e-9 * image->GetLength());
        EXPECT_GT(inside, 0);
      }
    }
  }
}

/// The probe searches the limit itself, by other means. A smaller tolerance makes values more
/// exact.
class SampledLimit : public testing::TestWithParam<std::pair<double, double>>
{
};

TEST_P(SampledLimit, IsThatOfTheProbe)
{
  const auto [tolerance, mistake] = GetParam();
  const Grid mesh = MakeModel(vtkSubdivisionModelSource::MECHANICAL_PART);
  vtkNew<Sampler> sampler;
  sampler->SetVolumeSchemeToBoxSpline();
  sampler->SetOutputDimensions(vtkMultiDimensionalSubdivision::TETRAHEDRA);
  sampler->SetNumberOfSamples(48);
  sampler->SetTolerance(tolerance);
  const Image image = Sample(sampler, mesh);
  std::vector<vtkIdType> samples(image->GetNumberOfPoints());
  std::iota(samples.begin(), samples.end(), 0);
  std::shuffle(samples.begin(), samples.end(), std::mt19937(7));
  samples.resize(2000);
  vtkNew<vtkPolyData> places;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const vtkIdType s : samples)
  {
    points->InsertNextPoint(image->GetPoint(s));
  }
  places->SetPoints(points);
  vtkNew<vtkSubdivisionLimitProbe> probe;
  probe->SetInputDataObject(3, places);
  const auto found = UpdateWithoutErrors<vtkPolyData>(probe.Get(), mesh);
  vtkDataArray* const distances = found->GetPointData()->GetArray("Distance");
  vtkDataArray* const wanted = found->GetPointData()->GetArray("Tension");
  vtkDataArray* const values = GetArray(image, "Tension");
  const double range = wanted->GetRange()[1] - wanted->GetRange()[0];
  vtkIdType inside = 0;
  vtkIdType missed = 0;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const auto p = static_cast<vtkIdType>(i);
    const double distance = distances->GetComponent(p, 0) / image->GetSpacing()[0];
    const bool isOfObject = IsInside(image, samples[i]);
    missed += !isOfObject && distance == 0. ? 1 : 0;
    if (isOfObject)
    {
      EXPECT_LE(distance, tolerance);
      ++inside;
      EXPECT_NEAR(values->GetComponent(samples[i], 0), wanted->GetComponent(p, 0), mistake * range);
    }
  }
  EXPECT_GT(inside, 400);
  EXPECT_LE(missed, 2); // within the tolerance of the boundary
}

INSTANTIATE_TEST_SUITE_P(Tolerances, SampledLimit,
  testing::Values(std::make_pair(0.05, 3e-3), std::make_pair(0.01, 5e-4)));

// ------------------------------------------------------------------------------------------------
// Coverage

TEST(Coverage, SumsToTheVolume)
{
  for (const int model :
    { vtkSubdivisionModelSource::MECHANICAL_PART, vtkSubdivisionModelSource::MATERIAL_BLOCK })
  {
    for (const int scheme : { 0, 1, 2 })
    {
      SCOPED_TRACE(testing::Message() << model << " scheme " << scheme);
      const Grid mesh = MakeModel(model);
      vtkNew<Sampler> sampler;
      sampler->SetVolumeScheme(scheme);
      sampler->SetNumberOfSamples(64);
      sampler->GenerateCoverageOn();
      sampler->SetTolerance(0.02);
      const double sum = SumCoverage(Sample(sampler, mesh));
      vtkNew<vtkSubdivisionMeasures> measures;
      measures->SetVolumeScheme(scheme);
      measures->SetMaximumLevel(4);
      measures->SetOutputDimensions(vtkMultiDimensionalSubdivision::TETRAHEDRA);
      const auto table = UpdateWithoutErrors<vtkTable>(measures.Get(), mesh);
      const double volume = measure_tools::Get(table, "Measure");
      EXPECT_NEAR(sum, volume, 3e-4 * volume);
    }
  }
}

/// Inside of a voxel materials together are all of it, and no sample has another material than the
/// largest part, but at interfaces.
TEST(Coverage, MaterialsShareVoxels)
{
  const Grid block = MakeBlock(4);
  vtkNew<Sampler> sampler;
  sampler->SetVolumeSchemeToLinear();
  sampler->SetSpacing(0.3); // the interface, at 2, passes through voxels
  sampler->GenerateCoverageOn();
  const Image image = Sample(sampler, block);
  vtkDataArray* const coverage = GetArray(image, "Coverage");
  ASSERT_EQ(coverage->GetNumberOfComponents(), 2);
  EXPECT_STREQ(coverage->GetComponentName(0), "3");
  EXPECT_STREQ(coverage->GetComponentName(1), "7");
  const auto cover = [](double low, double high, double place)
  { return std::max(0., std::min(high, place + 0.15) - std::max(low, place - 0.15)) / 0.3; };
  double least = 1.;
  for (vtkIdType s = 0; s < image->GetNumberOfPoints(); ++s)
  {
    const double* p = image->GetPoint(s);
    const double plane = cover(0., 4., p[0]) * cover(0., 4., p[1]);
    const double lower = plane * cover(0., 2., p[2]);
    const double upper = plane * cover(2., 4., p[2]);
    EXPECT_NEAR(coverage->GetComponent(s, 0), lower, 0.1);
    EXPECT_NEAR(coverage->GetComponent(s, 1), upper, 0.1);
    const double sum = coverage->GetComponent(s, 0) + coverage->GetComponent(s, 1);
    least = plane * cover(0., 4., p[2]) > 0.999999 ? std::min(least, sum) : least;
    EXPECT_LE(sum, 1.);
  }
  EXPECT_EQ(least, 1.);
  EXPECT_NEAR(SumCoverage(image), 64., 64. * 1e-3);
}

TEST(Coverage, MaterialsThatAreNotNumbersAreOne)
{
  const Grid block = MakeBlock(2);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  vtkNew<vtkDoubleArray> materials;
  materials->SetName("MaterialId");
  for (vtkIdType c = 0; c < block->GetNumberOfCells(); ++c)
  {
    materials->InsertNextValue(c % 4 == 0 ? nan : c % 4 == 1 ? 12345678. : 12345679.);
  }
  block->GetCellData()->AddArray(materials);
  vtkNew<Sampler> sampler;
  sampler->SetVolumeSchemeToLinear();
  sampler->SetNumberOfSamples(12);
  sampler->GenerateCoverageOn();
  const Image image = Sample(sampler, block);
  vtkDataArray* const coverage = GetArray(image, "Coverage");
  ASSERT_EQ(coverage->GetNumberOfComponents(), 3);
  EXPECT_STREQ(coverage->GetComponentName(0), "12345678"); // not rounded to that of the next
  EXPECT_STREQ(coverage->GetComponentName(1), "12345679");
  for (vtkIdType s = 0; s < image->GetNumberOfPoints(); ++s)
  {
    const double material = GetArray(image, "Material")->GetComponent(s, 0);
    const int own = std::isnan(material) ? 2 : material == 12345679. ? 1 : 0;
    EXPECT_TRUE(material == 0. || coverage->GetComponent(s, own) > 0.) << s;
  }
}

TEST(Coverage, SurfacesHaveNone)
{
  vtkNew<Sampler> sampler;
  sampler->SetNumberOfSamples(24);
  sampler->GenerateCoverageOn();
  const Image image = Sample(sampler,
    MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 } }, { { VTK_TRIANGLE, { 0, 1, 2 } } }));
  EXPECT_EQ(SumCoverage(image), 0.);
}
