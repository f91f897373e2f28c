// SPDX-License-Identifier: BSD-3-Clause
#include "SamplerTools.h"

namespace sampler_tools
{

Grid MakeSolid()
{
  const Grid solid = MakeGrid(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, { { VTK_TETRA, { 0, 1, 2, 3 } } });
  solid->GetPointData()->AddArray(MakeArray<vtkDoubleArray>("Heat", 1, 4, 1., 2., 1));
  return solid;
}

Grid MakeSheet()
{
  return MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } },
    { { VTK_TRIANGLE, { 0, 1, 2 } }, { VTK_TRIANGLE, { 0, 2, 3 } } });
}

Grid MakeCurve()
{
  return MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 } },
    { { VTK_LINE, { 0, 1 } }, { VTK_LINE, { 1, 2 } }, { VTK_LINE, { 2, 3 } } });
}

void AddPlaces(vtkPointSet* mesh)
{
  vtkNew<vtkDoubleArray> places;
  places->SetName("X");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    places->InsertNextValue(mesh->GetPoint(i)[0]);
  }
  mesh->GetPointData()->AddArray(places);
}

Image Sample(Filter* filter, vtkDataObject* input)
{
  UpdateInSilence(filter, input, nullptr, { "of the distance of samples away", "give way" });
  const auto image = Image::New();
  image->DeepCopy(filter->GetOutput());
  return image;
}

std::string FindError(Filter* filter, vtkDataObject* input)
{
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetInputDataObject(input);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetNumberOfArrays(), 0);
  return messages->Errors.empty() ? std::string() : messages->Errors.front();
}

vtkIdType CountInside(vtkImageData* image)
{
  vtkDataArray* const mask = image->GetPointData()->GetArray("vtkValidPointMask");
  vtkIdType count = 0;
  for (vtkIdType s = 0; mask && s < image->GetNumberOfPoints(); ++s)
  {
    count += mask->GetComponent(s, 0) != 0. ? 1 : 0;
  }
  return count;
}

std::string CompareImages(vtkImageData* a, vtkImageData* b)
{
  for (int k = 0; k < 3; ++k)
  {
    if (a->GetDimensions()[k] != b->GetDimensions()[k] || a->GetOrigin()[k] != b->GetOrigin()[k] ||
      a->GetSpacing()[k] != b->GetSpacing()[k])
    {
      return "the grids differ along axis " + std::to_string(k);
    }
  }
  return CompareArrays(a->GetPointData(), b->GetPointData(), "samples");
}

void SetThicknesses(Filter* filter, const char* name)
{
  filter->SetInputArrayToProcess(12, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name);
}

}
