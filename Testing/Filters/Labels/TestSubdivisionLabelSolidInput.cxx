// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestSubdivisionLabelSolidInput.cxx
 * What vtkSubdivisionLabelSolid makes of arrays that do not fit.
 */
#include "LabelTools.h"

#include "vtkDoubleArray.h"

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
    EXPECT_FALSE(
      made.Heard->Warnings.empty() && made.Heard->Inversions.empty() && made.Heard->Errors.empty());
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
