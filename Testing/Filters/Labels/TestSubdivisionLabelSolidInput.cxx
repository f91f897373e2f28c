// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSubdivisionLabelSolidInput.cxx
 * What vtkSubdivisionLabelSolid makes of arrays that do not fit.
 */
#include "LabelTools.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTrivialProducer.h"

#include <cmath>

using namespace label_tools;

// Arrays that cannot be true, labels that doubles cannot tell apart, voxels without a volume.
TEST(SubdivisionLabelSolid, ForgedInput)
{
  for (const vtkIdType size : { 0, 3, 26, 28, 1000 })
  {
    const Image image = MakeImage({ 3, 3, 3 }, [](int, int, int) { return 1; });
    image->GetPointData()->GetScalars()->SetNumberOfTuples(size);
    Made made;
    made.Run(image);
    made.ExpectError("The input has no labels");
  }
  {
    Image image = MakeImage({ 3, 3, 3 }, [](int, int, int) { return 1; });
    image->GetPointData()->AddArray(MakeArray<vtkDoubleArray>("short", 1, 3, 0., 1., 1));
    Made made;
    EXPECT_FALSE(made.Run(image)->GetCellData()->HasArray("short"));
    EXPECT_EQ(made.Heard->CountWarnings("\"short\""), 1);
  }
  {
    const Image image = MakeImage({ 3, 3, 3 }, [](int, int, int) { return 1; });
    vtkNew<vtkIdTypeArray> labels;
    labels->SetNumberOfValues(27);
    labels->FillValue((vtkIdType(1) << 53) + 1);
    image->GetPointData()->SetScalars(labels);
    Made made;
    made.Run(image);
    made.ExpectError("below 2^53");
  }
  {
    const Image image = MakeImage({ 3, 3, 3 }, [](int, int, int) { return 1; });
    image->SetSpacing(0., 1., 1.);
    Made made;
    made.Run(image);
    made.ExpectError("spacing is 0.0");
  }
}

// The arrays of field data have different sizes: those of the labels' size are the columns.
TEST(SubdivisionLabelSolid, FieldDataWithOtherArrays)
{
  const Image image = MakeImage({ 3, 3, 3 }, [](int i, int, int) { return i < 2 ? 1 : 2; });
  vtkFieldData* fields = image->GetFieldData();
  fields->AddArray(MakeArray<vtkDoubleArray>("TimeValue", 1, 1, 3., 3., 1));
  const auto labels = MakeArray<vtkDoubleArray>("Label", 1, 4, 0., 0., 1);
  const auto values = MakeArray<vtkDoubleArray>("K", 1, 4, 0., 0., 1);
  labels->SetValue(0, std::nan(""));
  for (int i = 1; i < 4; ++i)
  {
    labels->SetValue(i, i);
    values->SetValue(i, 10. * i);
  }
  fields->AddArray(labels);
  fields->AddArray(values);
  Made made;
  vtkUnstructuredGrid* solid = made.Run(image);
  made.ExpectSilence();
  vtkDataArray* found = solid->GetCellData()->GetArray("K");
  vtkDataArray* tissues = solid->GetCellData()->GetArray("Tissue");
  ASSERT_TRUE(found && tissues);
  for (vtkIdType c = 0; c < solid->GetNumberOfCells(); ++c)
  {
    ASSERT_EQ(10. * tissues->GetComponent(c, 0), found->GetComponent(c, 0));
  }
  EXPECT_FALSE(solid->GetCellData()->HasArray("TimeValue"));
  EXPECT_TRUE(solid->GetFieldData()->HasArray("TimeValue"));
}

TEST(SubdivisionLabelSolid, TablesThatAreNotClearAreTold)
{
  const Image image = MakeImage({ 3, 3, 3 }, [](int i, int, int) { return i < 2 ? 1 : 2; });
  image->GetPointData()->AddArray(MakeArray<vtkDoubleArray>("K", 1, 27, 0., 1., 1));
  vtkNew<vtkTable> table;
  const auto labels = MakeArray<vtkDoubleArray>("Label", 1, 4, 0., 0., 1);
  const auto values = MakeArray<vtkDoubleArray>("K", 1, 4, 0., 0., 1);
  const int given[] = { 2, 1, 2, 7 };
  for (int i = 0; i < 4; ++i)
  {
    labels->SetValue(i, given[i]);
    values->SetValue(i, 10. + i);
  }
  table->AddColumn(labels);
  table->AddColumn(values);
  vtkNew<vtkTrivialProducer> source;
  source->SetOutput(table);
  {
    Made made;
    made->SetMaterialsConnection(source->GetOutputPort());
    vtkUnstructuredGrid* solid = made.Run(image);
    EXPECT_EQ(made.Heard->CountWarnings("several rows for label 2: the first counts"), 1);
    EXPECT_EQ(made.Heard->CountWarnings("\"K\" of the table of materials replaces the array"), 1);
    vtkDataArray* tissues = solid->GetCellData()->GetArray("Tissue");
    for (vtkIdType c = 0; c < solid->GetNumberOfCells(); ++c)
    {
      ASSERT_EQ(solid->GetCellData()->GetArray("K")->GetComponent(c, 0),
        tissues->GetComponent(c, 0) == 2. ? 10. : 11.);
    }
  }
  table->RemoveColumnByName("Label");
  vtkNew<vtkStringArray> names;
  names->SetName("Label");
  names->SetNumberOfValues(4);
  table->AddColumn(names);
  Made made;
  made->SetMaterialsConnection(source->GetOutputPort());
  made.Run(image);
  EXPECT_EQ(made.Heard->CountWarnings("\"Label\" of the table of materials has no numbers"), 1);
}

TEST(SubdivisionLabelSolid, ProgressGoesOn)
{
  Made made;
  double last = 0.;
  vtkNew<vtkCallbackCommand> listener;
  listener->SetClientData(&last);
  listener->SetCallback(
    [](vtkObject*, unsigned long, void* at, void* data)
    {
      auto* before = static_cast<double*>(at);
      EXPECT_GE(*static_cast<double*>(data), *before);
      *before = *static_cast<double*>(data);
    });
  made.Filter->AddObserver(vtkCommand::ProgressEvent, listener);
  made.Run(MakeImage({ 6, 6, 6 }, [](int i, int j, int) { return i < 3 ? 1 : j < 2 ? 0 : 2; }));
  EXPECT_EQ(last, 1.);
}

TEST(SubdivisionLabelSolid, MeansOfLargeValuesAreFinite)
{
  const Image image = MakeImage({ 2, 2, 2 }, [](int, int, int) { return 1; });
  image->GetPointData()->AddArray(MakeArray<vtkDoubleArray>("Large", 1, 8, 1e308, 1e308, 1));
  Made made;
  made->SetNumberOfControlCells(1);
  vtkUnstructuredGrid* solid = made.Run(image);
  ASSERT_GT(solid->GetNumberOfCells(), 0);
  EXPECT_NEAR(solid->GetCellData()->GetArray("Large")->GetComponent(0, 0) / 1e308, 1., 1e-12);
}

TEST(SubdivisionLabelSolid, HiddenPointsHideTheirCells)
{
  const Image image = MakeImage({ 3, 3, 3 }, [](int, int, int) { return 1; }, true);
  vtkNew<vtkUnsignedCharArray> hidden;
  hidden->SetName(vtkDataSetAttributes::GhostArrayName());
  hidden->SetNumberOfValues(64);
  hidden->FillValue(0);
  hidden->SetValue(0, vtkDataSetAttributes::HIDDENPOINT);
  image->GetPointData()->AddArray(hidden);
  Made made;
  EXPECT_EQ(made.Run(image)->GetNumberOfCells(), 26 * 48);
  hidden->SetValue(1, vtkDataSetAttributes::HIDDENPOINT); // two cells, one of them hidden before
  image->Modified();
  EXPECT_EQ(made.Run(image)->GetNumberOfCells(), 25 * 48);
}
