// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSamplerInputs.cxx
 * vtkSubdivisionSampler with parts of images, threads, time steps, blocks, no cells, and stops.
 */
#include "HybridFilterTools.h"
#include "SamplerTools.h"

#include "Core/Memory/Loops.h"

#include "vtkCommand.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTrivialProducer.h"

using namespace sampler_tools;

// ------------------------------------------------------------------------------------------------
// Parts, threads, time, blocks

TEST(SamplerInputs, PartsAreThoseOfTheWholeBitForBit)
{
  const Grid mesh = hybrid_filter_tools::MakeAllTypes();
  vtkNew<Filter> filter;
  filter->SetNumberOfSamples(30);
  filter->GenerateCoverageOn();
  filter->GenerateDistanceOn();
  const Image whole = Sample(filter, mesh);
  ASSERT_GT(CountInside(whole), 0);
  const int* const dimensions = whole->GetDimensions();
  int part[6] = { 3, dimensions[0] - 4, dimensions[1] / 3, dimensions[1] / 2, dimensions[2] / 2,
    dimensions[2] - 1 };
  vtkNew<Filter> other;
  other->SetNumberOfSamples(30);
  other->GenerateCoverageOn();
  other->GenerateDistanceOn();
  other->SetInputDataObject(mesh);
  for (int i = 0; i < 2; ++i)
  {
    other->UpdateExtent(part);
    const Image found = other->GetOutput();
    ASSERT_EQ(found->GetNumberOfPoints(),
      vtkIdType(part[1] - part[0] + 1) * (part[3] - part[2] + 1) * (part[5] - part[4] + 1));
    EXPECT_GT(CountInside(found), 0);
    const auto expected = Image::New();
    expected->DeepCopy(whole);
    expected->Crop(part);
    EXPECT_EQ(CompareImages(expected, found), "");
    --part[0]; // the second part, of the object that was kept
  }
}

TEST(SamplerInputs, ThreadsMakeTheSameBits)
{
  const Grid mesh = hybrid_filter_tools::MakeAllTypes();
  const auto make = [&]
  {
    vtkNew<Filter> filter;
    filter->SetNumberOfSamples(40);
    filter->GenerateCoverageOn();
    filter->GenerateDistanceOn();
    return Sample(filter, mesh);
  };
  const std::string before = vtkSMPTools::GetBackend();
  ASSERT_TRUE(vtkSMPTools::SetBackend("STDThread"));
  vtkSMPTools::Initialize(1);
  const Image one = make();
  for (const int threads : { 2, 3, 8 })
  {
    vtkSMPTools::Initialize(threads);
    EXPECT_EQ(CompareImages(one, make()), "") << threads;
  }
  vtkSMPTools::SetBackend(before.c_str());
  vtkSMPTools::Initialize(0);
  EXPECT_GT(CountInside(one), 0);
}

namespace
{

/// A source of time steps: a solid whose values are the time.
class Steps : public vtkTrivialProducer
{
public:
  static Steps* New() { VTK_STANDARD_NEW_BODY(Steps); }
  vtkTypeMacro(Steps, vtkTrivialProducer);
  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override
  {
    vtkInformation* const port = out->GetInformationObject(0);
    if (request->Has(vtkDemandDrivenPipeline::REQUEST_INFORMATION()))
    {
      const double times[3] = { 0., 1., 2. };
      port->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times, 3);
      port->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), times, 2);
    }
    if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()))
    {
      const double time = port->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP());
      auto* const output = vtkUnstructuredGrid::GetData(out);
      output->ShallowCopy(MakeSolid());
      output->GetPointData()->GetArray("Heat")->Fill(time);
      output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
      return 1;
    }
    return this->Superclass::ProcessRequest(request, in, out);
  }
};

}

TEST(SamplerInputs, EachTimeStepIsSampled)
{
  vtkNew<Steps> source;
  const Grid holder = Grid::New();
  source->SetOutput(holder);
  vtkNew<Filter> filter;
  filter->SetNumberOfSamples(12);
  filter->SetInputConnection(source->GetOutputPort());
  for (const double time : { 2., 1., 2. })
  {
    filter->UpdateTimeStep(time);
    ASSERT_GT(CountInside(filter->GetOutput()), 0);
    vtkDataArray* const heat = filter->GetOutput()->GetPointData()->GetArray("Heat");
    EXPECT_NEAR(heat->GetRange()[1], time, 1e-12);
  }
}

TEST(SamplerInputs, BlocksAreOneMesh)
{
  const Grid whole = MakeMixedBox(2);
  std::vector<Grid> parts;
  for (const bool isFirst : { true, false })
  {
    const Grid cells = Grid::New();
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
    AddPlaces(cells);
    parts.push_back(cells);
  }
  const Grid bare = Grid::New();
  bare->CopyStructure(whole);
  AddPlaces(bare);
  vtkNew<Filter> filter;
  filter->SetNumberOfSamples(20);
  filter->GenerateCoverageOn();
  filter->GenerateDistanceOn();
  const Image one = Sample(filter, bare);
  const Image other = Sample(filter, MakeBlocks(parts));
  ASSERT_EQ(one->GetNumberOfPoints(), other->GetNumberOfPoints());
  ASSERT_GT(CountInside(one), 0);
  EXPECT_EQ(CountInside(one), CountInside(other));
  for (const char* name : { "X", "Coverage", "Distance", "vtkValidPointMask" })
  {
    vtkDataArray* const a = one->GetPointData()->GetArray(name);
    vtkDataArray* const b = other->GetPointData()->GetArray(name);
    ASSERT_TRUE(a && b) << name;
    double most = 0.;
    for (vtkIdType s = 0; s < one->GetNumberOfPoints(); ++s)
    {
      most = std::max(most, std::abs(a->GetComponent(s, 0) - b->GetComponent(s, 0)));
    }
    EXPECT_LT(most, 1e-6) << name;
  }
}

TEST(SamplerInputs, DataSetsOfAllKindsAreMeshes)
{
  const auto sample = [](vtkDataObject* input)
  {
    vtkNew<Filter> filter;
    filter->SetNumberOfSamples(16);
    return Sample(filter, input);
  };
  const Grid sheet = MakeSheet();
  vtkNew<vtkPolyData> polygons;
  polygons->SetPoints(sheet->GetPoints());
  polygons->SetPolys(sheet->GetCells());
  EXPECT_EQ(CompareImages(sample(sheet), sample(polygons)), "");
  vtkNew<vtkImageData> voxels;
  voxels->SetDimensions(3, 3, 2);
  const Grid hexahedra = Grid::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < voxels->GetNumberOfPoints(); ++i)
  {
    points->InsertNextPoint(voxels->GetPoint(i));
  }
  hexahedra->SetPoints(points);
  for (vtkIdType c = 0; c < voxels->GetNumberOfCells(); ++c)
  {
    vtkNew<vtkIdList> ids;
    voxels->GetCellPoints(c, ids);
    hexahedra->InsertNextCell(VTK_VOXEL, ids);
  }
  const Image image = sample(voxels);
  EXPECT_GT(CountInside(image), 50);
  EXPECT_EQ(CompareImages(image, sample(hexahedra)), "");
}

// ------------------------------------------------------------------------------------------------
// Nothing, and what is stopped

TEST(SamplerInputs, NothingIsSampledWithoutCells)
{
  for (const Grid& mesh : { MakeGrid({ { 0, 0, 0 } }, {}), MakeSheet() })
  {
    vtkNew<Filter> filter;
    filter->SetOutputDimensions(1 << 3);
    vtkNew<Messages> messages;
    messages->Watch(filter);
    filter->SetInputDataObject(mesh);
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_TRUE(messages->Errors.empty());
    EXPECT_EQ(messages->CountWarnings("nothing to sample"), 1);
  }
}

/// Such arrays were replaced, and written to after that.
TEST(SamplerInputs, ArraysNamedLikeThoseOfTheOutputAreLeftOut)
{
  const Grid solid = MakeSolid();
  solid->GetCellData()->AddArray(MakeArray<vtkIntArray>("MaterialId", 1, 1, 3., 3., 1));
  for (const char* const name : { "Material", "Coverage", "Distance", "vtkValidPointMask" })
  {
    const Grid mesh = Grid::New();
    mesh->DeepCopy(solid);
    mesh->GetPointData()->AddArray(MakeArray<vtkDoubleArray>(name, 3, 4, 1., 2., 1));
    vtkNew<Filter> filter;
    filter->SetNumberOfSamples(12);
    filter->GenerateCoverageOn();
    filter->GenerateDistanceOn();
    vtkNew<Messages> messages;
    messages->Watch(filter);
    filter->SetInputDataObject(mesh);
    filter->Update();
    EXPECT_EQ(messages->CountWarnings(std::string("\"") + name + "\" is left out"), 1) << name;
    vtkPointData* const data = filter->GetOutput()->GetPointData();
    EXPECT_EQ(data->GetNumberOfArrays(), 5) << name;
    EXPECT_EQ(data->GetArray(name)->GetNumberOfComponents(), 1) << name;
    EXPECT_EQ(data->GetArray("Coverage")->GetRange()[1], 1.) << name;
  }
}

TEST(SamplerInputs, PointsThatAreNotFiniteGiveNoImage)
{
  for (const double bad :
    { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    const Grid mesh = MakeGrid(
      { { 0, 0, 0 }, { bad, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, { { VTK_TETRA, { 0, 1, 2, 3 } } });
    vtkNew<Filter> filter;
    vtkNew<Messages> messages;
    messages->Watch(filter);
    filter->SetInputDataObject(mesh);
    filter->Update();
    EXPECT_EQ(CountInside(filter->GetOutput()), 0);
    EXPECT_GE(messages->CountWarnings("infinite or not a number"), 1);
  }
}

TEST(SamplerInputs, AToleranceThatWasNotReachedIsTold)
{
  vtkNew<Filter> filter;
  filter->SetNumberOfSamples(8);
  filter->SetMaximumLevel(1);
  filter->SetTolerance(0.);
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetInputDataObject(MakeSolid());
  filter->Update();
  EXPECT_TRUE(messages->Errors.empty());
  EXPECT_EQ(messages->CountWarnings("raise MaximumLevel"), 1);
  filter->SetTolerance(0.1);
  filter->SetMaximumLevel(5);
  filter->Update();
  EXPECT_EQ(messages->CountWarnings("raise MaximumLevel"), 1);
}

namespace
{

/// Counts the reports of progress, and stops the filter at one of them. No loop asks after it, as
/// where the next level takes less time than passes between two reports.
class Stopper : public vtkCommand
{
public:
  static Stopper* New() { return new Stopper; }
  vtkTypeMacro(Stopper, vtkCommand);
  void Execute(vtkObject* caller, unsigned long, void*) override
  {
    if (++this->Reports == this->StopAt)
    {
      static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
      subdivision::BetweenLoops::SecondsBetween = 1e9;
    }
  }
  int Reports = 0;
  int StopAt = 0;
};

}

/// Levels make most of the reports; the last ones are of the samples.
TEST(SamplerInputs, AStoppedRunHasNoSamples)
{
  const double before = std::exchange(subdivision::BetweenLoops::SecondsBetween, 0.);
  vtkNew<Filter> filter;
  filter->SetNumberOfSamples(24);
  filter->GenerateCoverageOn();
  filter->SetInputDataObject(hybrid_filter_tools::MakeAllTypes());
  vtkNew<Messages> messages;
  messages->Watch(filter);
  vtkNew<Stopper> stopper;
  filter->AddObserver(vtkCommand::ProgressEvent, stopper);
  filter->Update();
  const auto whole = Image::New();
  whole->DeepCopy(filter->GetOutput());
  const int reports = stopper->Reports;
  int stops = 0;
  for (int stopAt = 1; stopAt <= reports;
    stopAt = std::min(stopAt + 1 + stopAt / 4, std::max(stopAt + 1, reports - 30)))
  {
    subdivision::BetweenLoops::SecondsBetween = 0.;
    stopper->Reports = 0;
    stopper->StopAt = stopAt;
    filter->SetAbortExecute(0); // newer VTK does not take it back itself
    filter->Modified();
    filter->Update();
    const bool hasStopped = filter->GetOutput()->GetPointData()->GetNumberOfArrays() == 0;
    EXPECT_EQ(hasStopped ? "" : CompareImages(whole, filter->GetOutput()), "") << stopAt;
    stops += hasStopped ? 1 : 0;
  }
  EXPECT_GT(stops, 20);
  EXPECT_TRUE(messages->Errors.empty());
  stopper->StopAt = 0;
  filter->SetAbortExecute(0);
  filter->Modified();
  filter->Update();
  EXPECT_EQ(CompareImages(whole, filter->GetOutput()), "");
  subdivision::BetweenLoops::SecondsBetween = before;
}

TEST(SamplerInputs, OptionsOfMeshesStay)
{
  vtkNew<Filter> filter;
  filter->SetNumberOfLevels(3);
  filter->SetNumberOfSamples(8);
  Sample(filter, MakeSolid());
  EXPECT_EQ(filter->GetNumberOfLevels(), 3);
  EXPECT_FALSE(filter->GetProjectToLimit());
  EXPECT_FALSE(filter->GetGenerateOriginalIds());
  EXPECT_TRUE(filter->GetCacheOperator());
}
