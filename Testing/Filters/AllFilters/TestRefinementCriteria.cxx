// SPDX-License-Identifier: BSD-3-Clause
// The criteria of vtkRefinementAlgorithm, in all filters that have them.

#include "AdaptiveFilterTools.h"
#include "SelectionTools.h"

#include "vtkFloatArray.h"
#include "vtkPlaneSource.h"
#include "vtkRedGreenRefinement.h"
#include "vtkSphere.h"
#include "vtkSphereSource.h"
#include "vtkTrivialProducer.h"

using namespace adaptive_filter_tools;

namespace
{

using Configure = std::function<void(vtkRefinementAlgorithm*)>;

void SelectOneCell(vtkRefinementAlgorithm* filter)
{
  selection_tools::RefineBy(filter, selection_tools::MakeSelection(vtkSelectionNode::CELL, { 40 }));
}

void UseSphere(vtkRefinementAlgorithm* filter)
{
  vtkNew<vtkSphere> sphere;
  sphere->SetCenter(6., 3.2, 5.);
  sphere->SetRadius(2.5);
  filter->SetImplicitFunction(sphere);
  filter->RefineByFunctionOn();
}

/// Each criterion so that it asks for the hill and leaves the plain around it alone.
const std::vector<std::pair<std::string, Configure>> Criteria = {
  { "AttributeError",
    [](vtkRefinementAlgorithm* filter)
    {
      filter->RefineByAttributeErrorOn();
      filter->SetAttributeTolerance(0.2);
    } },
  { "AttributeError at the limit",
    [](vtkRefinementAlgorithm* filter)
    {
      filter->RefineByAttributeErrorOn();
      filter->SetAttributeErrorKindToLimitDifference();
      filter->SetAttributeTolerance(0.01);
    } },
  { "ArrayRange",
    [](vtkRefinementAlgorithm* filter)
    {
      filter->RefineByArrayRangeOn();
      filter->SetArrayRange(1., 9.);
    } },
  { "Selection", SelectOneCell },
  { "Function", UseSphere },
  { "EdgeLength",
    [](vtkRefinementAlgorithm* filter)
    {
      filter->RefineByEdgeLengthOn();
      filter->SetMaximumEdgeLength(1.2);
    } },
  { "GeometricError",
    [](vtkRefinementAlgorithm* filter)
    {
      filter->RefineByGeometricErrorOn();
      filter->SetGeometricTolerance(0.003);
    } },
  { "Curvature",
    [](vtkRefinementAlgorithm* filter)
    {
      filter->RefineByCurvatureOn();
      filter->SetMaximumAngle(20.);
    } },
  { "WantedLevel",
    [](vtkRefinementAlgorithm* filter)
    {
      filter->RefineByWantedLevelOn();
      filter->SetInputArrayToProcess(7, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Hill level");
    } },
};

/// A steep hill on a plain, whose cells want a level where it is high.
PolyData MakeInputForAll()
{
  PolyData input = MakeHill(8);
  vtkPoints* points = input->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double x[3];
    points->GetPoint(i, x);
    points->SetPoint(i, x[0], x[1], 3. * x[2]);
  }
  vtkNew<vtkIntArray> levels;
  levels->SetName("Hill level");
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    input->GetCellPoints(cell, ids);
    levels->InsertNextValue(input->GetPoint(ids->GetId(0))[2] > 3. ? 2 : 0);
  }
  input->GetCellData()->AddArray(levels);
  return input;
}

template <typename Class>
vtkSmartPointer<vtkPointSet> RunAt(vtkPolyData* input, const Configure& configure, int level)
{
  vtkNew<Messages> messages;
  vtkNew<Class> filter;
  messages->Watch(filter);
  filter->SetInputData(input);
  filter->RefineByAttributeErrorOff();
  filter->RefineByGeometricErrorOff();
  filter->SetMaximumLevel(level);
  configure(filter);
  filter->Update();
  EXPECT_TRUE(messages->Warnings.empty() && messages->Errors.empty());
  return filter->GetOutput();
}

template <typename Class>
class EveryRefinement : public testing::Test
{
};

using Classes = testing::Types<vtkRedGreenRefinement, vtkAdaptiveSurfaceSubdivision>;
TYPED_TEST_SUITE(EveryRefinement, Classes, );

}

TYPED_TEST(EveryRefinement, CriteriaAskForTheHillAndNotForThePlain)
{
  const PolyData input = MakeInputForAll();
  const vtkIdType given = input->GetNumberOfCells();
  EXPECT_EQ(RunAt<TypeParam>(input, [](vtkRefinementAlgorithm*) {}, 2)->GetNumberOfCells(), given);
  for (const auto& [name, configure] : Criteria)
  {
    SCOPED_TRACE(name);
    const auto coarse = RunAt<TypeParam>(input, configure, 1);
    const auto fine = RunAt<TypeParam>(input, configure, 2);
    EXPECT_EQ(RunAt<TypeParam>(input, configure, 0)->GetNumberOfCells(), given);
    EXPECT_GT(coarse->GetNumberOfCells(), given);
    EXPECT_GT(fine->GetNumberOfCells(), coarse->GetNumberOfCells());
    EXPECT_LT(fine->GetNumberOfCells(), 7 * given);
    // The corner far from the hill is the end of the same cells as before.
    vtkNew<vtkIdList> before;
    vtkNew<vtkIdList> after;
    input->BuildLinks();
    input->GetPointCells(0, before);
    vtkIdType found = 0;
    for (vtkIdType cell = 0; cell < fine->GetNumberOfCells(); ++cell)
    {
      fine->GetCellPoints(cell, after);
      found += after->IsId(0) >= 0 ? 1 : 0;
    }
    EXPECT_EQ(found, before->GetNumberOfIds());
  }
}

/// What one criterion asks for, two of them ask for, too.
TYPED_TEST(EveryRefinement, TwoCriteriaAskForMore)
{
  const PolyData input = MakeInputForAll();
  for (const auto& [name, configure] : Criteria)
  {
    SCOPED_TRACE(name);
    const auto both = RunAt<TypeParam>(
      input,
      [&configure = configure](vtkRefinementAlgorithm* filter)
      {
        configure(filter);
        SelectOneCell(filter);
      },
      2);
    EXPECT_GE(both->GetNumberOfCells(), RunAt<TypeParam>(input, configure, 2)->GetNumberOfCells());
    EXPECT_GE(
      both->GetNumberOfCells(), RunAt<TypeParam>(input, SelectOneCell, 2)->GetNumberOfCells());
  }
}

/// Flat, with an array that says nothing, or without arrays, or a sphere that is fine enough.
TYPED_TEST(EveryRefinement, DefaultsDoSomethingOnEachMesh)
{
  const auto withoutArrays = [](vtkPolyDataAlgorithm* source)
  {
    source->Update();
    PolyData mesh = source->GetOutput();
    mesh->GetPointData()->Initialize();
    return mesh;
  };
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(100);
  sphere->SetPhiResolution(100);
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(60, 60);
  const PolyData constant = MakeHill(8);
  vtkNew<vtkFloatArray> values;
  values->SetName("Constant");
  values->SetNumberOfValues(constant->GetNumberOfPoints());
  values->FillValue(1.F);
  constant->GetPointData()->Initialize();
  constant->GetPointData()->SetScalars(values);
  for (const PolyData& input : { withoutArrays(sphere), withoutArrays(plane), constant })
  {
    vtkNew<TypeParam> filter;
    filter->SetInputData(input);
    filter->Update();
    const vtkIdType cells = filter->GetOutput()->GetNumberOfCells();
    vtkNew<TypeParam> chosen;
    chosen->SetInputData(input);
    chosen->SetAttributeTolerance(0.2);
    chosen->SetGeometricTolerance(0.1);
    chosen->Update();
    EXPECT_GT(cells, chosen->GetOutput()->GetNumberOfCells());
    const bool isAdaptive = std::is_same<TypeParam, vtkAdaptiveSurfaceSubdivision>::value;
    vtkNew<TypeParam> once;
    once->SetInputData(input);
    once->SetMaximumLevel(1);
    once->RefineByAttributeErrorOff();
    once->RefineByGeometricErrorOff();
    once->RefineByEdgeLengthOn();
    once->SetMaximumEdgeLength(0.);
    once->Update();
    EXPECT_TRUE(isAdaptive || cells == once->GetOutput()->GetNumberOfCells());
  }
}
