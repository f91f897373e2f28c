// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file LabelTools.h
 * Images of labels, and a vtkSubdivisionLabelSolid that is told of what it says.
 */
#ifndef SubdivisionObjects_LabelTools_h
#define SubdivisionObjects_LabelTools_h

#include "MultiDimensionalSubdivisionTools.h"

#include "vtkImageData.h"
#include "vtkSubdivisionLabelSolid.h"

namespace label_tools
{

using namespace multi_dimensional_subdivision_tools;

using Image = vtkSmartPointer<vtkImageData>;
using Rule = std::function<int(int, int, int)>;

/// An image of n[0] x n[1] x n[2] voxels around its points, or of so many cells.
inline Image MakeImage(const std::array<int, 3>& n, const Rule& rule, bool ofCells = false)
{
  auto image = Image::New();
  const int more = ofCells ? 1 : 0;
  image->SetDimensions(n[0] + more, n[1] + more, n[2] + more);
  vtkNew<vtkUnsignedCharArray> labels;
  labels->SetName("Tissue");
  for (int k = 0; k < n[2]; ++k)
  {
    for (int j = 0; j < n[1]; ++j)
    {
      for (int i = 0; i < n[0]; ++i)
      {
        labels->InsertNextValue(static_cast<unsigned char>(rule(i, j, k)));
      }
    }
  }
  (ofCells ? static_cast<vtkDataSetAttributes*>(image->GetCellData()) : image->GetPointData())
    ->SetScalars(labels);
  return image;
}

/// A filter that is told of what it says.
struct Made
{
  Made() { this->Heard->Watch(this->Filter); }
  vtkSubdivisionLabelSolid* operator->() { return this->Filter; }
  vtkUnstructuredGrid* Run(vtkDataSet* image)
  {
    this->Heard->Warnings.clear();
    this->Heard->Errors.clear();
    this->Filter->SetInputDataObject(0, image);
    this->Filter->Update();
    return this->Filter->GetOutput();
  }
  void ExpectSilence() const
  {
    EXPECT_TRUE(this->Heard->Errors.empty());
    EXPECT_TRUE(this->Heard->Warnings.empty() && this->Heard->Inversions.empty());
  }
  void ExpectError(const std::string& part)
  {
    ASSERT_EQ(this->Heard->Errors.size(), 1u) << part;
    EXPECT_NE(this->Heard->Errors[0].find(part), std::string::npos) << this->Heard->Errors[0];
    EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfCells(), 0);
  }

  vtkNew<vtkSubdivisionLabelSolid> Filter;
  vtkNew<Messages> Heard;
};

}

#endif
