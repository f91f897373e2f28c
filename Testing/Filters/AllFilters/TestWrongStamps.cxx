// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TestWrongStamps.cxx
 * Cells that were changed behind a stamp: filters tell what they tell of a mesh without a stamp,
 * and each warning once.
 */
#include "FeatureTools.h"

#include "vtkRedGreenRefinement.h"
#include "vtkSimplicialComplexTopology.h"
#include "vtkSubdivisionSmoothness.h"
#include "vtkSurfaceSubdivision.h"

using namespace multi_dimensional_subdivision_tools;

namespace
{

/// The warnings of a filter, without its address.
std::vector<std::string> Warn(vtkAlgorithm* filter, vtkDataObject* input)
{
  vtkNew<Messages> messages;
  messages->Watch(filter);
  filter->SetInputDataObject(input);
  filter->Update();
  EXPECT_TRUE(messages->Errors.empty());
  std::vector<std::string> texts = messages->Warnings;
  texts.insert(texts.end(), messages->Inversions.begin(), messages->Inversions.end());
  for (std::string& text : texts)
  {
    text.erase(0, text.find("): "));
  }
  return texts;
}

template <typename DataSet>
vtkSmartPointer<DataSet> WithoutStamp(DataSet* stamped)
{
  auto plain = vtkSmartPointer<DataSet>::New();
  plain->ShallowCopy(stamped);
  vtkNew<vtkFieldData> none;
  plain->SetFieldData(none);
  return plain;
}

template <typename Filter, typename Configure>
void ExpectWarningsOfPlainMesh(
  vtkPointSet* stamped, vtkPointSet* plain, int warnings, const Configure& configure)
{
  vtkNew<Filter> fresh;
  vtkNew<Filter> filter;
  configure(fresh.Get());
  configure(filter.Get());
  const auto expected = Warn(fresh, plain);
  const auto told = Warn(filter, stamped);
  EXPECT_EQ(told, expected) << filter->GetClassName();
  EXPECT_EQ(std::set<std::string>(told.begin(), told.end()).size(), told.size());
  EXPECT_EQ(static_cast<int>(told.size()), warnings) << filter->GetClassName();
  filter->Modified(); // and when something is kept
  EXPECT_EQ(Warn(filter, stamped), expected) << filter->GetClassName();
}

void AddArrayOfWrongSize(vtkPointSet* mesh)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("Short");
  array->SetNumberOfTuples(3);
  array->FillValue(0.);
  mesh->GetPointData()->AddArray(array);
}

/// MakeSwappedLevel with further causes for warnings: an array of wrong size, and global ids of a
/// wrong form in the stamp.
Grid MakeSwapped(int scheme)
{
  const Grid refined = feature_tools::MakeSwappedLevel(scheme);
  AddArrayOfWrongSize(refined);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("SubdivisionGlobalIds");
  ids->SetNumberOfComponents(2);
  ids->SetNumberOfTuples(4);
  ids->FillValue(0);
  refined->GetFieldData()->AddArray(ids);
  return refined;
}

}

TEST(WrongStamp, SwappedTetsWarnOnce)
{
  for (int scheme :
    { vtkMultiDimensionalSubdivision::BOX_SPLINE, vtkMultiDimensionalSubdivision::TET_OCT })
  {
    const Grid swapped = MakeSwapped(scheme);
    const auto plain = WithoutStamp<vtkUnstructuredGrid>(swapped);
    ExpectWarningsOfPlainMesh<vtkMultiDimensionalSubdivision>(swapped, plain, 2,
      [scheme](vtkMultiDimensionalSubdivision* filter)
      {
        filter->SetVolumeScheme(scheme);
        filter->SetNumberOfLevels(1);
      });
  }
  const Grid swapped = MakeSwapped(vtkMultiDimensionalSubdivision::BOX_SPLINE);
  const auto plain = WithoutStamp<vtkUnstructuredGrid>(swapped);
  ExpectWarningsOfPlainMesh<vtkSimplicialComplexTopology>(swapped, plain, 1, [](auto*) {});
  ExpectWarningsOfPlainMesh<vtkSubdivisionSmoothness>(swapped, plain, 1, [](auto*) {});
  ExpectWarningsOfPlainMesh<vtkRedGreenRefinement>(swapped, plain, 2,
    [](vtkRedGreenRefinement* filter)
    {
      filter->SetPlacementToLimit();
      filter->RefineByAttributeErrorOff();
      filter->RefineByEdgeLengthOn();
      filter->SetMaximumLevel(1);
    });
}

TEST(WrongStamp, SwappedTrianglesWarnOnce)
{
  vtkNew<vtkSurfaceSubdivision> first;
  vtkNew<vtkPolyData> tetrahedron;
  vtkNew<vtkPoints> points;
  for (const auto& x : { std::array<double, 3>{ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } })
  {
    points->InsertNextPoint(x.data());
  }
  tetrahedron->SetPoints(points);
  tetrahedron->Allocate(4);
  for (const auto& face : { Ids{ 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } })
  {
    tetrahedron->InsertNextCell(VTK_TRIANGLE, 3, face.data());
  }
  first->SetInputData(tetrahedron);
  first->SetNumberOfLevels(2);
  first->Update();
  vtkNew<vtkPolyData> swapped;
  swapped->DeepCopy(first->GetOutput());
  vtkNew<vtkCellArray> faces;
  for (vtkIdType i = 0; i < swapped->GetNumberOfCells(); ++i)
  {
    const vtkIdType from = i == 1 ? 2 : i == 2 ? 1 : i;
    faces->InsertNextCell(first->GetOutput()->GetCell(from));
  }
  swapped->SetPolys(faces);
  AddArrayOfWrongSize(swapped);
  ExpectWarningsOfPlainMesh<vtkSurfaceSubdivision>(
    swapped, WithoutStamp<vtkPolyData>(swapped), 1, [](auto*) {});
}
