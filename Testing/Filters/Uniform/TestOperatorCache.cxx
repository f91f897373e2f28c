// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestOperatorCache.cxx
 * What a filter keeps between executions is used when it fits, and never changes the output.
 */
#include "OperatorCacheTools.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTrivialProducer.h"

using namespace operator_cache_tools;

// ---------------------------------------------------------------- what may change for free

TEST(OperatorCache, ChangedScalars)
{
  Kept filter;
  const Grid input = MakeInput();
  const Grid first = filter.Update(input);
  EXPECT_EQ(filter.CountBuilds(), 1);
  const Grid changed = DeepCopy(input);
  changed->GetPointData()->GetArray("scalar")->Fill(0.25);
  const Grid second = filter.Update(changed);
  EXPECT_EQ(filter.CountBuilds(), 0);
  EXPECT_TRUE(SharesCells(first, second));
  EXPECT_TRUE(SharesPoints(first, second));
  EXPECT_EQ(Compare(second, Fresh(changed)), "");
  EXPECT_NE(Compare(second, first), "");
}

TEST(OperatorCache, ChangedCoordinates)
{
  Kept filter;
  const Grid input = MakeInput();
  const Grid first = filter.Update(input);
  const Grid firstCopy = DeepCopy(first);
  filter.CountBuilds();
  const Grid changed = DeepCopy(input);
  const Point p = GetPoint(changed, 13);
  MovePoint(changed, 13, p[0] + 1e-7, p[1], p[2]);
  const Grid second = filter.Update(changed);
  EXPECT_EQ(filter.CountBuilds(), 0);
  EXPECT_TRUE(SharesCells(first, second));
  EXPECT_FALSE(SharesPoints(first, second));
  EXPECT_EQ(Compare(second, Fresh(changed)), "");
  EXPECT_EQ(Compare(first, firstCopy), ""); // an output that is in use stays as it was
  const Grid third = filter.Update(changed);
  EXPECT_TRUE(SharesPoints(second, third));
  const Grid fourth = filter.Update(input);
  EXPECT_EQ(Compare(fourth, firstCopy), "");
  EXPECT_EQ(filter.CountBuilds(), 0);
  // The same arrays with other values in them, and nobody was told.
  input->GetPoints()->GetData()->SetComponent(13, 0, p[0] - 1e-7);
  EXPECT_EQ(Compare(filter.Update(input), Fresh(input)), "");
  EXPECT_EQ(filter.CountBuilds(), 0);
}

TEST(OperatorCache, NewAndChangedArrays)
{
  Kept filter;
  const Grid input = MakeInput();
  const Grid first = filter.Update(input);
  filter.CountBuilds();
  AddArrays(input);
  Grid output = filter.Update(input);
  EXPECT_TRUE(SharesCells(first, output) && SharesPoints(first, output));
  EXPECT_EQ(Compare(output, Fresh(input)), "");
  input->GetPointData()->RemoveArray("rgb");
  input->GetCellData()->RemoveArray("float");
  output = filter.Update(input);
  EXPECT_TRUE(SharesCells(first, output) && SharesPoints(first, output));
  EXPECT_EQ(Compare(output, Fresh(input)), "");
  EXPECT_EQ(filter.CountBuilds(), 0);
}

TEST(OperatorCache, WhatDoesNotChangeTheOperator)
{
  Kept filter;
  const Grid input = MakeInput();
  AddArrays(input);
  filter.Update(input);
  filter.CountBuilds();
  const std::vector<Configure> changes = {
    [](Filter* f) { f->GenerateClassificationOn(); },
    [](Filter* f) { f->GenerateOriginalIdsOn(); },
    [](Filter* f) { f->InterpolateIntegersOn(); },
    [](Filter* f) { f->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION); },
    [](Filter* f) { f->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION); },
    [](Filter* f) { f->GenerateClassificationOff(); },
    [](Filter* f) { f->SetFeatureAngle(50.); },
  };
  Configure all;
  for (std::size_t i = 0; i < changes.size(); ++i)
  {
    changes[i](filter.Get());
    all = [all, change = changes[i]](Filter* f)
    {
      if (all)
      {
        all(f);
      }
      change(f);
    };
    EXPECT_EQ(Compare(filter.Update(input), Fresh(input, all)), "") << i;
    EXPECT_EQ(filter.CountBuilds(), 0) << i;
  }
}

TEST(OperatorCache, ZeroLevels)
{
  const Configure zero = [](Filter* f)
  {
    f->SetNumberOfLevels(0);
    f->GenerateClassificationOn();
  };
  Kept filter(zero);
  const Grid input = MakeInput();
  filter.Update(input);
  filter.CountBuilds();
  input->GetPointData()->GetArray("scalar")->Fill(3.);
  EXPECT_EQ(Compare(filter.Update(input), Fresh(input, zero)), "");
  EXPECT_EQ(filter.CountBuilds(), 0);
}

namespace
{

/// A source of time steps: the same cells, other scalars and points.
class Steps : public vtkTrivialProducer
{
public:
  static Steps* New() { VTK_STANDARD_NEW_BODY(Steps); }
  vtkTypeMacro(Steps, vtkTrivialProducer);
  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** in, vtkInformationVector* out) override
  {
    vtkInformation* port = out->GetInformationObject(0);
    if (request->Has(vtkDemandDrivenPipeline::REQUEST_INFORMATION()))
    {
      const double times[3] = { 0., 1., 2. };
      port->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times, 3);
      port->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), times, 2);
    }
    if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()))
    {
      const double time = port->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP());
      auto* output = vtkUnstructuredGrid::SafeDownCast(port->Get(vtkDataObject::DATA_OBJECT()));
      output->ShallowCopy(MakeInput());
      output->GetPointData()->GetArray("scalar")->Fill(time);
      output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
      return 1;
    }
    return this->Superclass::ProcessRequest(request, in, out);
  }
};

}

TEST(OperatorCache, TimeSteps)
{
  vtkNew<Steps> source;
  const Grid holder = Grid::New();
  source->SetOutput(holder);
  Kept filter;
  filter->SetInputConnection(source->GetOutputPort());
  filter->UpdateTimeStep(0.);
  const auto first = Grid::New();
  first->ShallowCopy(filter->GetOutput());
  EXPECT_EQ(filter.CountBuilds(), 1);
  filter->UpdateTimeStep(2.);
  EXPECT_EQ(filter.CountBuilds(), 0);
  EXPECT_TRUE(SharesCells(first, filter->GetOutput()));
  EXPECT_TRUE(SharesPoints(first, filter->GetOutput()));
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("scalar")->GetTuple1(5), 2.);
  EXPECT_EQ(first->GetPointData()->GetArray("scalar")->GetTuple1(5), 0.);
}

TEST(OperatorCache, TimeStepsRepeatNoWarning)
{
  vtkNew<Steps> source;
  const Grid holder = Grid::New();
  source->SetOutput(holder);
  vtkNew<Filter> filter;
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetInterfaceValuesToDiscontinuous(); // but no interface is kept
  vtkNew<Messages> messages;
  messages->Watch(filter);
  const auto warnings = [&messages](auto&& update)
  {
    messages->Warnings.clear();
    update();
    return messages->Warnings.size();
  };
  EXPECT_EQ(1u, warnings([&] { filter->UpdateTimeStep(0.); }));
  EXPECT_EQ(0u, warnings([&] { filter->UpdateTimeStep(2.); }));
  EXPECT_EQ(0u, warnings([&] { filter->UpdateTimeStep(0.); }));
  filter->SetNumberOfLevels(0);
  EXPECT_EQ(1u, warnings([&] { filter->UpdateTimeStep(1.); }));
  source->Modified(); // another mesh, for all that is known
  EXPECT_EQ(1u, warnings([&] { filter->UpdateTimeStep(1.); }));
}

// ---------------------------------------------------------------- what may not

TEST(OperatorCache, ChangedCellsWithTheSamePointers)
{
  Kept filter;
  const Grid input = MakeInput();
  filter.Update(input);
  EXPECT_EQ(filter.CountBuilds(), 1);
  // Two points change places in all cells; the array does not say that it was modified.
  vtkDataArray* ids = input->GetCells()->GetConnectivityArray();
  const vtkMTimeType time = input->GetCells()->GetMTime();
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    const double id = ids->GetTuple1(i);
    ids->SetComponent(i, 0, id == 0. ? 26. : id == 26. ? 0. : id);
  }
  EXPECT_EQ(input->GetCells()->GetMTime(), time);
  EXPECT_EQ(Compare(filter.Update(input), Fresh(input)), "");
  EXPECT_EQ(filter.CountBuilds(), 1);
  // A type alone: the last two points become unused.
  const Grid line = MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, { { VTK_QUAD, { 0, 1, 2, 3 } } });
  filter.Update(line);
  filter.CountBuilds();
  subdivision::GetCellTypes(line)->SetValue(0, VTK_TETRA);
  EXPECT_EQ(Compare(filter.Update(line), Fresh(line)), "");
  EXPECT_EQ(filter.CountBuilds(), 1);
}

TEST(OperatorCache, EqualCellsInOtherArrays)
{
  Kept filter;
  const Grid input = MakeInput();
  const Grid first = filter.Update(input);
  filter.CountBuilds();
  const Grid copy = DeepCopy(input);
  copy->GetCells()->ConvertTo32BitStorage();
  const Grid second = filter.Update(copy);
  EXPECT_TRUE(SharesCells(first, second) && SharesPoints(first, second));
  EXPECT_EQ(filter.CountBuilds(), 0);
}

TEST(OperatorCache, DiagonalThatChanges)
{
  // The octahedron's diagonal of a tetrahedron is the shortest.
  const Grid tet = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0.1, 1.5, 0 }, { 0.5, 0.3, 2.6 } },
    { { VTK_TETRA, { 0, 1, 2, 3 } } });
  Kept filter;
  filter.Update(tet);
  filter.CountBuilds();
  MovePoint(tet, 3, 0.51, 0.3, 2.6);
  EXPECT_EQ(Compare(filter.Update(tet), Fresh(tet)), "");
  EXPECT_EQ(filter.CountBuilds(), 0);
  const Grid before = Fresh(tet);
  MovePoint(tet, 3, 2.5, -1.3, 0.6);
  const Grid after = filter.Update(tet);
  EXPECT_EQ(Compare(after, Fresh(tet)), "");
  EXPECT_NE(GetCells(after), GetCells(before));
  EXPECT_EQ(filter.CountBuilds(), 1);
}

TEST(OperatorCache, FeatureThatChanges)
{
  const Grid hinge = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 0.3, 2, 0 }, { 0.8, -0.5, 0.1 } },
    { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 1, 0, 3 } } });
  const Configure detect = [](Filter* f) { f->DetectFeaturesOn(); };
  Kept filter(detect);
  filter.Update(hinge);
  filter.CountBuilds();
  for (double z : { 0.2, 0.1, 0.25 }) // up to 27 degrees
  {
    MovePoint(hinge, 3, 0.8, -0.5, z);
    EXPECT_EQ(Compare(filter.Update(hinge), Fresh(hinge, detect)), "");
    EXPECT_EQ(filter.CountBuilds(), 0);
  }
  MovePoint(hinge, 3, 0.8, -0.5, 0.5); // 45 degrees
  EXPECT_EQ(Compare(filter.Update(hinge), Fresh(hinge, detect)), "");
  EXPECT_EQ(filter.CountBuilds(), 1);
  filter->SetFeatureAngle(44.);
  filter.Update(hinge);
  EXPECT_EQ(filter.CountBuilds(), 0);
  filter->SetFeatureAngle(46.);
  EXPECT_EQ(Compare(filter.Update(hinge), Fresh(hinge)), ""); // none at all
  EXPECT_EQ(filter.CountBuilds(), 1);
}

TEST(OperatorCache, OptionsThatChangeTheOperator)
{
  const Grid input = MakeOctahedron({ { VTK_LINE, { 0, 5 } }, { VTK_TRIANGLE, { 0, 1, 3 } },
    { VTK_LINE, { 0, 7 } }, { VTK_LINE, { 5, 7 } }, { VTK_LINE, { 3, 7 } } });
  input->GetPoints()->InsertNextPoint(3, 3, 3);
  AddCellArray(input, "MaterialId", { 1, 1, 1, 1, 2, 2, 2, 2, 0, 0, 0, 0, 0 });
  AddCellArray(input, "Part", { 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 3, 3, 1 });
  AddCellArray(input, "Rule", { 2, 2, 2, 2, 0, 0, 0, 0, 0, 0, 1, 1, 1 });
  AddCellArray(input, "flags", { 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0 });
  const std::vector<Configure> changes = {
    [](Filter* f) { f->SetNumberOfLevels(1); },
    [](Filter* f) { f->SetEmbeddedCellsToSingularInside(); },
    [](Filter* f) { f->SetCreaseEndToDart(); },
    [](Filter* f) { f->SetLoopWeightsToLoop(); },
    [](Filter* f) { f->ModifiedBoundaryOff(); },
    [](Filter* f) { f->GenerateTangentsOn(); },
    [](Filter* f) { f->PreserveInterfacesOn(); },
    [](Filter* f) { f->SetType1RuleToFollowDimension1(); },
    [](Filter* f) { f->SetType2RuleToSharp(); },
    [](Filter* f) { f->SetType3RuleToSharp(); },
    [](Filter* f)
    {
      f->SetType2RuleToFollowPart();
      SetCellArray(f, 2, "Part");
    },
    [](Filter* f) { SetCellArray(f, 3, "Rule"); },
    [](Filter* f) { SetCellArray(f, 0, "flags"); },
    [](Filter* f) { f->DetectFeaturesOn(); },
    [](Filter* f) { f->Use32BitIdsOn(); },
  };
  for (std::size_t i = 0; i < changes.size(); ++i)
  {
    Kept filter;
    filter.Update(input);
    filter.CountBuilds();
    changes[i](filter.Get());
    EXPECT_EQ(Compare(filter.Update(input), Fresh(input, changes[i])), "") << i;
    EXPECT_EQ(filter.CountBuilds(), 1) << i;
    filter.Update(input);
    EXPECT_EQ(filter.CountBuilds(), 0) << i;
  }
}

TEST(OperatorCache, WarningsAreRepeated)
{
  const Grid input = MakeFan(6, { { VTK_LINE, { 0, 1 } }, { VTK_LINE, { 1, 0 } } });
  AddCellArray(input, "Singular", { 0, 0, 0, 0, 0, 0, 1, 0 });
  vtkNew<Filter> filter;
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetInputData(input);
  filter->Update();
  EXPECT_EQ(messages->Warnings.size(), 1u);
  filter->Modified();
  filter->Update();
  EXPECT_EQ(messages->Warnings.size(), 2u);
}

// ---------------------------------------------------------------- memory

TEST(OperatorCache, ForgetsWhatIsNotNeeded)
{
  Kept filter;
  EXPECT_TRUE(HoldsNothing(filter.Get()));
  filter.Update(MakeInput());
  EXPECT_TRUE(HoldsOperators(filter.Get(), 1));
  filter.Update(MakeFan(5));
  EXPECT_TRUE(HoldsOperators(filter.Get(), 1));
  filter->CacheOperatorOff();
  EXPECT_TRUE(HoldsNothing(filter.Get()));
  filter.Update(MakeFan(5));
  EXPECT_TRUE(HoldsNothing(filter.Get()));
  filter->CacheOperatorOn();
  filter.Update(MakeFan(5));
  EXPECT_TRUE(HoldsOperators(filter.Get(), 1));
  filter.Update(Grid::New());
  EXPECT_TRUE(HoldsNothing(filter.Get()));
}

TEST(OperatorCache, CountsNothingWhenOff)
{
  Kept filter([](Filter* f) { f->CacheOperatorOff(); });
  const Grid input = MakeInput();
  const Grid first = filter.Update(input);
  const Grid second = filter.Update(input);
  EXPECT_EQ(filter.CountBuilds(), 0);
  EXPECT_FALSE(SharesCells(first, second));
  EXPECT_FALSE(SharesPoints(first, second));
  EXPECT_EQ(Compare(first, second), "");
}

TEST(OperatorCache, Use32BitIds)
{
  const Grid input = MakeMixedBox(2);
  for (int levels : { 0, 1, 2 })
  {
    for (bool cache : { false, true })
    {
      auto run = [&](bool narrow)
      {
        return Execute(input, levels,
          [&](Filter* filter)
          {
            filter->SetCacheOperator(cache);
            filter->SetUse32BitIds(narrow);
          });
      };
      const Grid wide = run(false);
      const Grid narrow = run(true);
      EXPECT_TRUE(wide->GetCells()->IsStorage64Bit());
      EXPECT_FALSE(narrow->GetCells()->IsStorage64Bit());
      EXPECT_EQ(Compare(wide, narrow), "");
      EXPECT_EQ(Compare(Execute(narrow, 1), Execute(wide, 1)), "");
    }
  }
}

TEST(OperatorCache, AChangeOfRulesKeepsTheCells)
{
  const Grid fan = feature_tools::MakeFan(6, { { VTK_LINE, { 0, 1 } }, { VTK_LINE, { 0, 4 } } });
  feature_tools::AddCellArray(fan, "MaterialId", { 1, 1, 1, 2, 2, 2, 0, 0 });
  vtkNew<vtkMultiDimensionalSubdivision> filter;
  filter->SetInputData(fan);
  filter->SetNumberOfLevels(2);
  auto isFresh = [&filter, &fan]
  {
    vtkNew<vtkMultiDimensionalSubdivision> fresh;
    fresh->SetInputData(fan);
    fresh->SetNumberOfLevels(2);
    fresh->CacheOperatorOff();
    fresh->SetEmbeddedCells(filter->GetEmbeddedCells());
    fresh->SetCreaseEnd(filter->GetCreaseEnd());
    fresh->SetPreserveInterfaces(filter->GetPreserveInterfaces());
    fresh->Update();
    return feature_tools::Compare(filter->GetOutput(), fresh->GetOutput()) == "";
  };
  filter->SetEmbeddedCellsToSingular();
  filter->Update();
  const vtkSmartPointer<vtkCellArray> cells = filter->GetOutput()->GetCells();
  filter->SetCreaseEndToDart();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetCells(), cells.Get());
  EXPECT_TRUE(isFresh());
  filter->PreserveInterfacesOn(); // derives other simplices: other ids
  filter->Update();
  EXPECT_NE(filter->GetOutput()->GetCells(), cells.Get());
  EXPECT_TRUE(isFresh());
}
