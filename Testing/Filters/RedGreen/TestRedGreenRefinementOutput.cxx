// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestRedGreenRefinementOutput.cxx
 * vtkRedGreenRefinement: limits of size, bad input, and what becomes of arrays.
 */
#include "RedGreenRefinementTools.h"

#include "vtkPlane.h"
#include "vtkSphere.h"

using namespace red_green_refinement_tools;

namespace
{

// ------------------------------------------------------------------------------------------------
// Limits

TEST(RedGreenLimits, NumberOfCells)
{
  const Grid box = MakeBox(2);
  AddValues(box);
  for (vtkIdType most : { 48, 60, 500, 5000 })
  {
    vtkNew<Messages> messages;
    const Grid output = Refine(
      box,
      [most](Filter* filter)
      {
        filter->RefineByAttributeErrorOn();
        filter->SetAttributeTolerance(0.);
        filter->SetMaximumLevel(60);
        filter->SetMaximumNumberOfCells(most);
      },
      messages);
    EXPECT_EQ(messages->CountWarnings("which is MaximumNumberOfCells"), 1) << most;
    EXPECT_LE(output->GetNumberOfCells(), most);
    EXPECT_GT(2 * output->GetNumberOfCells(), most) << "nearly as many as may be";
  }
}

TEST(RedGreenLimits, TheWorstIsRefined)
{
  const Grid box = MakeBox(3);
  AddValues(box);
  vtkNew<Messages> messages;
  const Grid output = Refine(
    box,
    [](Filter* filter)
    {
      filter->RefineByAttributeErrorOn();
      filter->SetAttributeTolerance(0.001);
      filter->SetMaximumNumberOfCells(250);
    },
    messages);
  EXPECT_EQ(messages->CountWarnings("the worst ones last"), 1);
  // Where x is small the values hardly change, where it is large they do.
  for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
  {
    const Ids ids = GetCell(output, i);
    if (GetKind(output, i) == 1.)
    {
      EXPECT_TRUE(std::all_of(
        ids.begin(), ids.end(), [&](vtkIdType id) { return GetPoint(output, id)[0] >= 1.; }));
    }
  }
  EXPECT_GT(output->GetNumberOfCells(), box->GetNumberOfCells());
}

TEST(RedGreenLimits, AnInputThatIsTooLargeStaysWhatItIs)
{
  const Grid box = MakeBox(2);
  AddValues(box);
  vtkNew<Messages> messages;
  const Grid output = Refine(
    box,
    [](Filter* filter)
    {
      filter->RefineByAttributeErrorOn();
      filter->SetMaximumNumberOfCells(10);
    },
    messages);
  EXPECT_EQ(messages->CountWarnings("nothing is refined"), 1);
  EXPECT_EQ(GetCells(output), GetCells(box));
}

TEST(RedGreenLimits, NumbersEnd)
{
  const Grid line = multi_dimensional_subdivision_tools::MakeGrid(
    { { 1., 0., 0. }, { 2., 0., 0. } }, { { VTK_LINE, { 0, 1 } } });
  vtkNew<vtkSphere> sphere;
  sphere->SetCenter(1., 0., 0.);
  vtkNew<Messages> messages;
  sphere->SetRadius(0.);
  const Grid output = Refine(
    line,
    [&](Filter* filter)
    {
      // The cell at the point 1: its level goes on until there is no number between.
      filter->RefineByArrayRangeOn();
      filter->SetArrayRange(1., 1.);
      filter->SetMaximumLevel(60);
      vtkNew<vtkDoubleArray> x;
      x->SetName("x");
      x->InsertNextValue(1.);
      x->InsertNextValue(2.);
      line->GetPointData()->SetScalars(x);
    },
    messages);
  EXPECT_EQ(messages->CountWarnings("no number lies between"), 1);
  EXPECT_EQ(output->GetNumberOfCells(), 53);
}

// ------------------------------------------------------------------------------------------------
// Bad input

TEST(RedGreenErrors, ArraysThatCannotBeUsed)
{
  const Grid box = MakeBox(1);
  AddValues(box);
  box->GetCellData()->AddArray(MakeArray<vtkDoubleArray>("WantedLevel", 1, 6, 0., 3., 1));
  const std::pair<Configure, const char*> cases[] = {
    { [](Filter* filter)
      {
        filter->RefineByAttributeErrorOn();
        filter->SetInputArrayToProcess(5, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "nothing");
      },
      "Point array \"nothing\" (array index 5) is not there" },
    { [](Filter* filter)
      {
        filter->RefineByArrayRangeOn();
        filter->SetInputArrayToProcess(6, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "nothing");
      },
      "Cell array \"nothing\" (array index 6) is not there" },
    { [](Filter* filter) { filter->RefineByArrayRangeOn(); }, "needs an array" },
    { [](Filter* filter) { filter->RefineByFunctionOn(); }, "needs an ImplicitFunction" },
    { [](Filter* filter)
      {
        filter->RefineByWantedLevelOn();
        filter->SetInputArrayToProcess(
          7, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "WantedLevel");
      },
      "must hold integers" },
  };
  for (const auto& [configure, text] : cases)
  {
    vtkNew<Messages> messages;
    const Grid output = Refine(box, configure, messages);
    ASSERT_FALSE(messages->Errors.empty()) << text;
    EXPECT_NE(messages->Errors[0].find(text), std::string::npos) << messages->Errors[0];
    EXPECT_EQ(output->GetNumberOfCells(), 0);
  }
}

TEST(RedGreenErrors, DefaultRefinesByGeometryWhereThereIsNoArray)
{
  const Grid box = MakeBox(1);
  const Grid output = Refine(box, [](Filter* filter) { filter->RefineByAttributeErrorOn(); });
  const Grid named = Refine(box,
    [](Filter* filter)
    {
      filter->RefineByAttributeErrorOff();
      filter->RefineByGeometricErrorOn();
    });
  EXPECT_GT(output->GetNumberOfCells(), box->GetNumberOfCells());
  EXPECT_EQ(Compare(output, named), "");
}

// ------------------------------------------------------------------------------------------------
// Arrays and cells

TEST(RedGreenArrays, EveryArrayReachesTheOutput)
{
  const Grid box = MakeMixedBox(1);
  AddArrays(box);
  const Grid output = Refine(box,
    [](Filter* filter)
    {
      filter->RefineByEdgeLengthOn();
      filter->SetMaximumEdgeLength(0.8);
      filter->GenerateOriginalIdsOn();
    });
  const Grid uniform = Subdivide(box, 1);
  for (int i = 0; i < uniform->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* wanted = uniform->GetPointData()->GetAbstractArray(i);
    vtkAbstractArray* array = output->GetPointData()->GetAbstractArray(wanted->GetName());
    ASSERT_TRUE(array) << wanted->GetName();
    EXPECT_STREQ(array->GetClassName(), wanted->GetClassName());
    EXPECT_EQ(array->GetNumberOfComponents(), wanted->GetNumberOfComponents());
    EXPECT_EQ(array->GetNumberOfTuples(), output->GetNumberOfPoints());
  }
  for (int i = 0; i < box->GetCellData()->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* in = box->GetCellData()->GetAbstractArray(i);
    if (in == box->GetCellData()->GetGlobalIds() || in == box->GetCellData()->GetPedigreeIds())
    {
      continue;
    }
    vtkAbstractArray* array = output->GetCellData()->GetAbstractArray(in->GetName());
    ASSERT_TRUE(array) << in->GetName();
    for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
    {
      const int components = in->GetNumberOfComponents();
      EXPECT_EQ(array->GetVariantValue(cell * components).ToString(),
        in->GetVariantValue(GetOrigin(output, cell) * components).ToString());
    }
  }
  EXPECT_TRUE(output->GetPointData()->GetArray("vtkOriginalPointIds"));
  for (int i = 0; i < box->GetFieldData()->GetNumberOfArrays(); ++i)
  {
    EXPECT_TRUE(output->GetFieldData()->HasArray(box->GetFieldData()->GetArrayName(i)));
  }
}

TEST(RedGreenArrays, OldPointsKeepTheirValuesAndNewOnesAreBetween)
{
  const Grid box = MakeBox(2);
  AddWeights(box);
  AddValues(box);
  AddWantedLevels(box, 2, 9);
  const Grid output = RefineToWanted(box);
  vtkDataArray* weights = output->GetPointData()->GetArray("Weights");
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double value = 0.;
    double sum = 0.;
    for (int c = 0; c < weights->GetNumberOfComponents(); ++c)
    {
      sum += weights->GetComponent(i, c);
      value += weights->GetComponent(i, c) * box->GetPointData()->GetArray("V")->GetComponent(c, 0);
    }
    EXPECT_EQ(sum, 1.);
    EXPECT_NEAR(output->GetPointData()->GetArray("V")->GetComponent(i, 0), value, 1e-12);
    if (i < box->GetNumberOfPoints())
    {
      EXPECT_EQ(weights->GetComponent(i, static_cast<int>(i)), 1.);
    }
  }
}

TEST(RedGreenArrays, GhostTypesGoToTheChildren)
{
  const Grid box = MakeBox(1);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (int i = 0; i < 6; ++i)
  {
    ghosts->InsertNextValue(i == 2 ? vtkDataSetAttributes::DUPLICATECELL
        : i == 4                   ? vtkDataSetAttributes::HIDDENCELL
                                   : 0);
  }
  box->GetCellData()->AddArray(ghosts);
  vtkNew<Messages> messages;
  const Grid output = Refine(
    box,
    [](Filter* filter)
    {
      filter->RefineByEdgeLengthOn();
      filter->SetMaximumLevel(1);
    },
    messages);
  EXPECT_EQ(messages->CountWarnings("duplicate (ghost) cells"), 1);
  std::set<vtkIdType> seen;
  for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
  {
    seen.insert(GetOrigin(output, i));
    EXPECT_EQ(output->GetCellGhostArray()->GetValue(i) != 0, GetOrigin(output, i) == 2);
  }
  EXPECT_EQ(seen, (std::set<vtkIdType>{ 0, 1, 2, 3, 5 })) << "hidden cells take no part";
}

}
