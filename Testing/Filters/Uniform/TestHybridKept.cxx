// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestHybridKept.cxx
 * VolumeScheme = HYBRID: the operator, what is kept for the next execution, and filters in a row.
 */
#include "HybridFilterTools.h"

#include "vtkDoubleArray.h"
#include "vtkSubdivisionOperator.h"

using namespace hybrid_filter_tools;

TEST(HybridKept, TheOperatorTimesThePointsIsTheOutput)
{
  const Grid input = MakeAllTypes();
  AddSharpness(input, { { 8, 1.5 }, { 9, .5 } });
  for (int levels = 0; levels <= 3; ++levels)
  {
    vtkNew<Filter> filter;
    filter->SetInputData(input);
    filter->SetNumberOfLevels(levels);
    Hybrid(filter);
    ReadSharpness(filter);
    vtkNew<vtkSubdivisionOperator> operation;
    ASSERT_TRUE(filter->ComputeOperator(operation));
    filter->Update();
    vtkUnstructuredGrid* output = filter->GetOutput();
    ASSERT_EQ(operation->GetNumberOfRows(), output->GetNumberOfPoints());
    ASSERT_EQ(operation->GetNumberOfColumns(), input->GetNumberOfPoints());
    vtkNew<vtkIdTypeArray> offsets;
    vtkNew<vtkIdTypeArray> ids;
    vtkNew<vtkDoubleArray> weights;
    operation->GetRows(offsets, ids, weights);
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      Point sum{};
      for (vtkIdType k = offsets->GetValue(i); k < offsets->GetValue(i + 1); ++k)
      {
        for (int c = 0; c < 3; ++c)
        {
          sum[c] += weights->GetValue(k) * GetPoint(input, ids->GetValue(k))[c];
        }
      }
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(sum[c], GetPoint(output, i)[c], 1e-14) << levels << " levels, point " << i;
      }
    }
    EXPECT_EQ(operation->GetNumberOfFactors(), levels + 1);
  }
}

TEST(HybridKept, KeptOperatorsGiveTheSame)
{
  for (const bool hasOctahedra : { true, false })
  {
    SCOPED_TRACE(hasOctahedra);
    const Grid input = hasOctahedra
      ? MakeAllTypes()
      : MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
                   { 1, 1, 1 }, { 0, 1, 1 } },
          { { VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 } }, { VTK_LINE, { 0, 1 } } });
    const vtkIdType line = hasOctahedra ? 8 : 1;
    AddSharpness(input, { { line, 1.5 } });
    const Configure configure = With(
      [](Filter* filter)
      {
        ReadSharpness(filter);
        filter->DetectFeaturesOn();
        filter->SetFeatureAngle(60.);
        filter->SetNumberOfLevels(2);
      });
    Kept filter(configure);
    const Grid first = filter.Update(input);
    EXPECT_EQ(filter.CountBuilds(), 1);
    EXPECT_EQ(Compare(first, Fresh(input, configure)), "");
    const Grid firstCopy = DeepCopy(first);
    const Grid changed = DeepCopy(input);
    for (vtkIdType i = 0; i < changed->GetNumberOfPoints(); ++i)
    {
      const Point p = GetPoint(changed, i);
      MovePoint(changed, i, p[0] + .01 * std::sin(3. * i), p[1] + .01 * std::cos(5. * i), p[2]);
    }
    const Grid second = filter.Update(changed);
    EXPECT_EQ(filter.CountBuilds(), 0);
    EXPECT_EQ(Compare(second, Fresh(changed, configure)), "");
    EXPECT_EQ(SharesCells(first, second), !hasOctahedra);
    EXPECT_EQ(Compare(first, firstCopy), "");
    // Other features, sharpness, or cells are built.
    const Grid bent = DeepCopy(changed);
    MovePoint(bent, 6, 3., 3., 3.);
    EXPECT_EQ(Compare(filter.Update(bent), Fresh(bent, configure)), "");
    const Grid sharper = DeepCopy(changed);
    sharper->GetCellData()->GetArray("Sharpness")->SetComponent(line, 0, 3.);
    filter.CountBuilds();
    EXPECT_EQ(Compare(filter.Update(sharper), Fresh(sharper, configure)), "");
    EXPECT_EQ(filter.CountBuilds(), 1);
    // Somebody wrote into the cells of an output.
    const Grid third = filter.Update(changed);
    third->GetCells()->GetConnectivityArray()->SetComponent(0, 0, 5);
    EXPECT_EQ(Compare(filter.Update(changed), Fresh(changed, configure)), "");
  }
}

TEST(HybridKept, FiltersInARowEqualOne)
{
  const auto features = [](Filter* filter)
  {
    Hybrid(filter);
    ReadSharpness(filter);
    filter->DetectFeaturesOn();
    filter->SetFeatureAngle(50.);
    filter->PreserveInterfacesOn();
    SetCellArray(filter, 1, "Material");
    filter->SetInputArrayToProcess(8, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Marks");
    filter->MarkCreasesOn();
    filter->MarkSurfacesOn();
  };
  for (unsigned int seed = 1; seed <= 12; ++seed)
  {
    SCOPED_TRACE(seed);
    const Grid input = MakeAllTypes(seed);
    AddSharpness(input, { { 8, 1.5 }, { 9, .5 * seed }, { 10, 2.75 } });
    AddCellArray(input, "Material", { 1, 2, 1, 2, 1, 3, 1, 1, 1, 1, 1, 1 });
    vtkNew<vtkDoubleArray> marks;
    marks->SetName("Marks");
    vtkNew<vtkDoubleArray> sharpness;
    sharpness->SetName("PointSharpness");
    for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
    {
      marks->InsertNextValue((i * seed) % 3 == 1 ? 1. : 0.);
      sharpness->InsertNextValue(i == 2 ? 2.5 : 1.25);
    }
    input->GetPointData()->AddArray(marks);
    input->GetPointData()->AddArray(sharpness);
    const Configure configure = [&](Filter* filter)
    {
      features(filter);
      if (seed % 2 == 1)
      {
        filter->SetInputArrayToProcess(
          9, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "PointSharpness");
      }
      if (seed % 3 == 0)
      {
        filter->SetType1RuleToSharp();
        filter->SetType2RuleToSharp();
        filter->SetType3RuleToSharp();
      }
      filter->SetCreaseEnd(static_cast<int>(seed % 2));
    };
    const Grid whole = Execute(input, 3, configure);
    const Grid one = Execute(input, 1, configure);
    const Grid two = Execute(one, 1, configure);
    ExpectSame(Execute(two, 1, configure), whole);
    ExpectSame(Execute(one, 2, configure), whole);
    ExpectSame(two, Execute(input, 2, configure));
    // A point was moved: that is all that changes. Cells are those of another mesh: features anew.
    const Grid moved = DeepCopy(one);
    MovePoint(moved, 0, 0., 0., 0.);
    EXPECT_EQ(Execute(moved, 1, configure)->GetNumberOfCells(), two->GetNumberOfCells());
    const Grid turned = DeepCopy(one);
    turned->GetCells()->GetConnectivityArray()->SetComponent(0, 0, 3);
    vtkNew<Messages> messages;
    Execute(turned, 1, configure, messages);
    EXPECT_TRUE(messages->Errors.empty());
  }
}
